"""Equilibria, and assembly of closed loops from rough guesses."""
