"""Monitors of a run: singularities, drift, and how it ends where it fails."""
