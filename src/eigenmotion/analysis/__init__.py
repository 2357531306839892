"""Small deviations from a motion, and states in which mechanisms stay."""
