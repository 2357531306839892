"""Derivation of the terms of the equations of motion from a model."""
