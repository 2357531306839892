"""A mechanism at one state: derivatives, active contacts, and the tangent space of the constraints."""
