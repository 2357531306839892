"""The drawing of a robot: solids of its file, and a skeleton."""
