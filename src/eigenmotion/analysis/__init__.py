"""Linearisation, equilibria and assembly of mechanisms."""
