"""What users state: models, their symbols, files, drawings, and what is read off sympy.physics.mechanics."""
