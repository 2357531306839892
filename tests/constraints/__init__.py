"""Constraint rows: consistent states, dependent rows, coordinates without mass."""
