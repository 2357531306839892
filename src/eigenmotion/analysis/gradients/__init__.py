"""Gradients of functions of a motion: by the adjoint, and as functions of JAX and PyTorch."""
