"""Integrators, and the stepping loop in C by itself."""
