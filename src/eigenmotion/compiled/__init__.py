"""The functions of one compiled model, in Python's terms."""
