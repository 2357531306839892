"""Calculus of expressions on the graph: derivatives, evaluation, rounding error bounds, identity tests."""
