"""Results of runs: the solution, and quantities computed from its rows."""
