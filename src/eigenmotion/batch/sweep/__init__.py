"""Sweeps: the values of their members, and their files."""
