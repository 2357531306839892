"""Import of mechanisms from `sympy.physics.mechanics`: turns bodies, joints and loads into a model."""

from .from_mechanics import from_mechanics as from_mechanics
