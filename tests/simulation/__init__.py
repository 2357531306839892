"""One run: options, inputs, controllers, and calls to a compiled system."""
