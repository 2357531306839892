"""Sensitivities of a run with respect to parameters, inputs and initial values."""
