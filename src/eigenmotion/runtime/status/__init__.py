"""How calls and runs end, in words."""
