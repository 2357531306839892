"""Drawings of a model along a run: shapes, and pictures of them."""
