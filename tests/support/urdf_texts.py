"""Texts of small URDF files for tests."""

from __future__ import annotations


def link(name, mass=None, center=(0, 0, 0), rpy=(0, 0, 0), inertia=(0, 0, 0, 0, 0, 0)):
    """A link; inertia is xx, xy, xz, yy, yz, zz about the mass centre. Without a mass it has no inertial."""
    if mass is None:
        return f'<link name="{name}"/>'
    entries = " ".join(f'{key}="{value}"' for key, value in zip(
        ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), inertia, strict=True))  # fmt: skip
    origin = f'<origin xyz="{_text(center)}" rpy="{_text(rpy)}"/>'
    return f'<link name="{name}"><inertial>{origin}<mass value="{mass}"/><inertia {entries}/></inertial></link>'


def joint(name, kind, parent, child, xyz=(0, 0, 0), rpy=(0, 0, 0), axis=None, more=""):
    """A joint; without an axis the file has none."""
    direction = "" if axis is None else f'<axis xyz="{_text(axis)}"/>'
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{_text(xyz)}" rpy="{_text(rpy)}"/>{direction}{more}</joint>')  # fmt: skip


def robot(*elements, name="robot"):
    """The text of a file."""
    return f'<?xml version="1.0"?>\n<robot name="{name}">\n' + "\n".join(elements) + "\n</robot>\n"


def _text(numbers):
    return " ".join(map(repr, map(float, numbers)))
