"""From a model to the terms of its equations, and what the compiled equations give."""
