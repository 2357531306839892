"""Snippets of the documentation, and public names."""
