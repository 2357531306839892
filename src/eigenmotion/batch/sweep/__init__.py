"""Sweeps: the values of the members, and the files of results."""
