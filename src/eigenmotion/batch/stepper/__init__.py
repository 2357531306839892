"""Many steppers of one system as one."""
