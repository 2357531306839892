"""What a run found: the solution, what follows from its rows, and how it is shown and kept."""
