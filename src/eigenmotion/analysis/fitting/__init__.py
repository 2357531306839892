"""Fitting: parameters and initial values of a model from measured motions."""
