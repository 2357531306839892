"""Linearised equations of motion, and their modes."""
