"""Commands that write files from a model."""
