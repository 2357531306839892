"""Errors, tolerances and thresholds: whatever the frame, the units and the formulation."""
