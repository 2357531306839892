"""Inverse dynamics and what follows from it."""
