"""Environments of Gymnasium over batches of steppers."""
