"""Values of the user's expressions: hyper-dual numbers with bounds of their rounding."""
