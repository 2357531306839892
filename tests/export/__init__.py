"""Functional Mock-up Units and pages."""
