"""Solutions as plots, files and text."""
