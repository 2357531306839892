"""Output of solutions: plots, files and text."""
