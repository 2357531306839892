"""Evaluation: the runs of all cases, and their outcomes."""
