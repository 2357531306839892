"""Motions as functions of JAX and PyTorch."""
