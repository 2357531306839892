"""Comparison of runs with other runs of this tool, for models without an independent reference."""
