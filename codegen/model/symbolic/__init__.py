"""Symbolic equations of motion of a model, for display; generated code does not use them."""
