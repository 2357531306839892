"""The `Program` record that templates print, and its construction from a scene."""
