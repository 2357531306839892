"""Example mechanisms, one in each file: a `Model` with a drawing, units, and the oracle of its tests."""
