"""From a start to a motion: steps, what watches them, and how a run ends."""
