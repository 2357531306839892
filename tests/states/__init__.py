"""First-order states."""
