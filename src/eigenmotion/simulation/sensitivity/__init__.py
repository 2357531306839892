"""Sensitivities of a run to parameters, inputs and initial values."""
