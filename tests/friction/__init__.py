"""Coulomb friction: sticking, sliding, cones, bearings, and in proportion to multipliers."""
