"""Trees of bodies: joints, kinematics and the recursions of their dynamics, as nodes of an expression graph."""
