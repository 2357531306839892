"""Motions that are prescribed, and the forces that they take."""
