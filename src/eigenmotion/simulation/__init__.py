"""Simulation of a motion from its start."""
