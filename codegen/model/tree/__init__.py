"""Trees of bodies as a user states them: joints, masses, and functions of places and velocities for expressions."""
