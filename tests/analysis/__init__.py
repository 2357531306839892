"""Linear models, equilibria, closed loops."""
