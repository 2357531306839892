"""Building: from a model file to a compiled, verified and cached library."""
