"""Identification: which parameters the forces along a motion tell, and their values from measured forces."""
