"""From a model file to a compiled library that is verified, and kept."""
