"""Commands that simulate or analyse a model."""
