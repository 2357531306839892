"""Cases: a mechanism, a parameter that drives it to its limits, what should come of it."""
