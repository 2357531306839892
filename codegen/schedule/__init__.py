"""Scheduling: turns expressions of the graph into an ordered list of operations."""
