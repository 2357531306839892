"""Straight-line functions as C text."""
