"""Initial states of runs: consistent ones, and restarts."""
