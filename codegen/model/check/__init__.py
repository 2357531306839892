"""Checks of a model that need no derivation."""
