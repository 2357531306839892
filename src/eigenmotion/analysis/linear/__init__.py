"""Linearised equations of motion and natural modes."""
