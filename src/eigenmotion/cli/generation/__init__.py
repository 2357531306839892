"""Commands that make files of a model."""
