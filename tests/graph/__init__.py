"""Expressions as a graph: canonical forms, identities, derivatives, schedules."""
