"""Limits of a user's model: cases that are generated from it, within a time budget."""
