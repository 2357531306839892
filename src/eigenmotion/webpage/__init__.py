"""A model as a page on which it moves."""
