"""From a model to the terms of its equations of motion."""
