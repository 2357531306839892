"""Batches of steppers of one system."""
