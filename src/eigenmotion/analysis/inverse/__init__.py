"""Inverse dynamics: the forces that a motion takes, and what they say about the parameters."""
