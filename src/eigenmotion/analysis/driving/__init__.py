"""Driving: prescribed motions of whole mechanisms, and the forces that they take."""
