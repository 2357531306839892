"""From bodies, joints and loads of `sympy.physics.mechanics` to a model: what users need not write down."""

from .from_mechanics import from_mechanics as from_mechanics
