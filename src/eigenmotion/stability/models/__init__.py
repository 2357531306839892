"""Small mechanisms made to be driven to their limits."""
