"""Robots from files: URDF and MJCF as trees of bodies, joints and constraints."""
