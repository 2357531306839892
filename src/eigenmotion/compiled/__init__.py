"""Python interface of one compiled model: its functions at one state."""
