"""Words of a URDF file: elements, attributes and numbers, checked before yourdfpy reads them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from xml.etree import ElementTree as Xml

from ..codegen.model.normalise import ModelError, nearest

_SHAPES = ("box", "cylinder", "sphere", "mesh", "capsule")
_ELEMENTS: Mapping[str, tuple[str, ...]] = {
    "robot": ("link", "joint", "material", "transmission", "gazebo"),
    "link": ("inertial", "visual", "collision"),
    "joint": ("parent", "child", "origin", "axis", "limit", "mimic", "dynamics", "safety_controller", "calibration"),
    "inertial": ("origin", "mass", "inertia"), "visual": ("origin", "geometry", "material"),
    "collision": ("origin", "geometry"), "geometry": _SHAPES,
}  # fmt: skip
_NEEDED: Mapping[str, tuple[str, ...]] = {
    "robot": ("name",), "link": ("name",), "joint": ("name", "type"), "parent": ("link",), "child": ("link",),
    "axis": ("xyz",), "mimic": ("joint",), "inertia": ("ixx", "iyy", "izz"), "box": ("size",), "sphere": ("radius",),
    "cylinder": ("radius", "length"), "mesh": ("filename",), "capsule": ("radius", "length"),
}  # fmt: skip
_OTHERS: Mapping[str, tuple[str, ...]] = {
    "origin": ("xyz", "rpy"), "mass": ("value",), "inertia": ("ixy", "ixz", "iyz"), "mesh": ("scale",),
    "limit": ("lower", "upper", "effort", "velocity"), "dynamics": ("damping", "friction"),
    "mimic": ("multiplier", "offset"),
}  # fmt: skip
_VECTORS = ("xyz", "rpy", "size")
_SCALARS = ("value", "ixx", "iyy", "izz", "ixy", "ixz", "iyz", "lower", "upper", "effort", "velocity", "damping",
            "friction", "multiplier", "offset", "radius", "length")  # fmt: skip
_INSIDE: Mapping[str, tuple[str, ...]] = {
    "joint": ("parent", "child"), "visual": ("geometry",), "collision": ("geometry",),
}  # fmt: skip
_COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
_CLOSE = 0.75  # similarity of a misspelt element; names of extensions, as <loop_joint>, are less similar


def check_words(file: Path) -> None:
    """Check the elements of a URDF file, as far as they are read.

    Raises
    ------
    ModelError
        The file is no URDF, a word is missing or misspelt, or a number is none; names the element, and its link or
        joint.
    """
    content = file.read_bytes()
    if b"<xacro:" in _COMMENT.sub(b"", content):
        raise ModelError(f"{file}: it has elements of xacro. Expand them first: xacro {file.name} > robot.urdf")
    root = _parsed(file, content)
    if root.tag != "robot":
        hint = " Read it by load_mjcf." if root.tag == "mujoco" else ""
        raise ModelError(f"{file}: it begins with <{root.tag}>, and URDF with <robot name=...>.{hint}")
    _check(root, f"{file}: <robot>")
    if root.find("link") is None:
        raise ModelError(f"{file}: <robot> has no <link>.")
    for kind in ("link", "joint"):
        for k, owner in enumerate(root.iterfind(kind)):
            name = owner.get("name")
            _check_owner(owner, f"{file}: {kind} {name!r}" if name else f"{file}: <{kind}> number {k + 1}")


def _parsed(file: Path, content: bytes) -> Xml.Element:
    if not content.strip():
        raise ModelError(f"{file}: the file is empty.")
    try:
        return Xml.fromstring(content)
    except Xml.ParseError as error:
        try:
            content.decode()
        except UnicodeDecodeError:
            return _not_utf8(file, content, error)
        raise ModelError(f"{file}: it is no XML: {error}") from error


def _not_utf8(file: Path, content: bytes, error: Xml.ParseError) -> Xml.Element:
    """Return the root of a file with characters of another encoding, as comments may have."""
    try:
        return Xml.fromstring(content.decode("latin-1"))
    except Xml.ParseError:
        raise ModelError(f"{file}: it is no XML, or not in UTF-8: {error}. Save it as UTF-8") from error


def _check_owner(owner: Xml.Element, where: str) -> None:
    """Check a link or joint with all that is in it."""
    for element, inside in _known(owner):
        _check(element, where if element is owner else f"{where}: {inside}")
    if owner.tag == "joint":
        limit = owner.find("limit")
        if limit is not None and float(limit.get("lower", "-inf")) > float(limit.get("upper", "inf")):
            raise ModelError(f"{where}: <limit>: lower {limit.get('lower')} is above upper {limit.get('upper')}.")


def _known(element: Xml.Element, path: str = "") -> Iterator[tuple[Xml.Element, str]]:
    """Give an element and those in it that are read, each with its path: "<inertial><mass>"."""
    yield element, path
    for child in element:
        if child.tag in _ELEMENTS.get(element.tag, ()) and child.tag != "material":
            yield from _known(child, f"{path}<{child.tag}>")


def _check(element: Xml.Element, where: str) -> None:
    needed, others = _NEEDED.get(element.tag, ()), _OTHERS.get(element.tag, ())
    _check_inside(element, where)
    for name in needed:
        if name not in element.attrib:
            unknown = [one for one in element.attrib if one not in (*needed, *others)]
            misspelt = next((one for one in unknown if nearest(one, [name])), None)
            hint = f" Is its {misspelt!r} misspelt?" if misspelt else f' Give it {name}="...".'
            raise ModelError(f"{where} has no attribute {name!r}.{hint}")
    absent = [one for one in others if one not in element.attrib]  # beside what is there, another is an extension
    for name in element.attrib:
        if name not in (*needed, *others) and (hint := nearest(name, absent)):
            raise ModelError(f"{where} has an attribute {name!r}, which URDF does not know.{hint}")
    for name, text in element.attrib.items():
        if name in (*needed, *others) and name in (*_VECTORS, *_SCALARS):
            _check_numbers(f"{where}: {name}={text!r}", text, 3 if name in _VECTORS else 1, element.tag == "limit")


def _check_inside(element: Xml.Element, where: str) -> None:
    """Check which elements are in an element."""
    known, inside = _ELEMENTS.get(element.tag, ()), [str(child.tag) for child in element]
    for tag in inside:
        if tag not in known and (close := get_close_matches(tag, known, 1, _CLOSE)):
            raise ModelError(f"{where} has an element <{tag}>, which URDF does not know. Did you mean <{close[0]}>?")
    for tag in _INSIDE.get(element.tag, ()):
        if tag not in inside:
            raise ModelError(f"{where} has no <{tag}>. Give it one.")
    if element.tag == "geometry" and not set(inside) & set(_SHAPES):
        raise ModelError(f"{where} has no shape. Give it one of {', '.join(f'<{shape}>' for shape in _SHAPES)}.")


def _check_numbers(where: str, text: str, count: int, may_be_infinite: bool) -> None:
    try:
        numbers = [float(word) for word in text.split()]
    except ValueError:
        raise ModelError(f"{where}: {_numbers(count)} expected.") from None
    if len(numbers) != count:
        raise ModelError(f"{where}: {_numbers(count)} expected, not {len(numbers)}.")
    if any(math.isnan(number) or (math.isinf(number) and not may_be_infinite) for number in numbers):
        raise ModelError(f"{where} is not finite.")


def _numbers(count: int) -> str:
    return "a number is" if count == 1 else f"{count} numbers are"
