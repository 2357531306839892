"""From a start to a motion."""
