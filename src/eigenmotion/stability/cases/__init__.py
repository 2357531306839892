"""Cases: a mechanism, a parameter that drives it to its limits, and the expected motion."""
