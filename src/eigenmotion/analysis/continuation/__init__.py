"""Branches of equilibria and cycles along a parameter."""
