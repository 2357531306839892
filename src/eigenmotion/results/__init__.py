"""What a run found: the solution, and what follows from its rows."""
