"""Statements of users: models, their symbols, files, drawings, and systems of sympy.physics.mechanics."""
