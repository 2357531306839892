"""Checks of a model before its equations are derived."""
