"""From a model file to a compiled module that is proved to be the model, and kept."""
