"""Printing of straight-line functions (kernels) as C text."""
