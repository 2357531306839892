"""Cycles: periodic motions."""
