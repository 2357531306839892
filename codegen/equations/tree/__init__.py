"""Equations of models with trees of bodies."""
