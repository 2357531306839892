"""Arithmetic of the proof: hyper-dual numbers with bounds of their rounding errors."""
