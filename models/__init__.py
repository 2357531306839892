"""Mechanisms, one a file: `Model`s with a drawing, units and the oracle that checks them."""
