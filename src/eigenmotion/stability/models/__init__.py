"""Small mechanisms with parameters that drive them to their limits."""
