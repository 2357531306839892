"""Batch runs: ensembles, sweeps and batches of steppers of one system."""
