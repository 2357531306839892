"""Calculus and algebra of expressions on the graph: derivatives, values, bounds of rounding, identities."""
