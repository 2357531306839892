"""Derivatives of whole motions."""
