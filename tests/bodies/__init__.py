"""Trees of bodies: recursions, functions of places and velocities, models with trees."""
