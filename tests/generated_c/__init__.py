"""The text of generated C: bytes, names, warnings, flags, the ABI; and programs around it."""
