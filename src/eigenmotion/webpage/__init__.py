"""Interactive pages of models."""
