"""Derivatives of a run by what it is given."""
