"""Results of a run: the solution, and quantities that follow from its rows."""
