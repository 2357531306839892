"""Expressions with every subexpression once: what is made of them, what vanishes, what is computed once."""
