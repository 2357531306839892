"""`Tree`: bodies joined to each other, whose energies and places are functions for a `Model`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from ..normalise import ModelError, expression, nearest, sequence_of, shown, t
from .body import FREEDOMS, ROTATED, Link, coordinates_of
from .forward_kinematics import Arithmetic, ForwardKinematics
from .functions import call
from .quantity import Quantity

_COMPOSED = {"cylindrical": ("prismatic", "revolute"), "planar": ("prismatic", "prismatic", "revolute")}
"""Joints made of several: along and about the axis; in the plane across it, and about it"""
JOINTS = (*FREEDOMS, *_COMPOSED)
_COUNTS = FREEDOMS | {name: len(parts) for name, parts in _COMPOSED.items()}
_UNIT = (1, 0, 0, 0, 1, 0, 0, 0, 1)
_SKEW = 1e-6
"""A matrix that differs from a rotation by less is taken for the nearest one."""


class Body:
    """A body of a tree, and the functions of its place and motion that expressions of a model may contain.

    Vectors are in the axes of the ground. Points are in the body's frame [m], which is that of its joint, moved by the
    joint.

    Attributes
    ----------
    name
    coordinates : those on which its joint depends, functions of time
    """

    def __init__(self, link: Link, coordinates: tuple[sympy.Expr, ...]) -> None:
        self.link, self.name, self.coordinates = link, link.name, coordinates
        self._chain = tuple(reversed([*link.ancestors]))

    def __repr__(self) -> str:
        return f"<Body {self.name!r}: {self.link.joint}>"

    def position(self, point: Sequence[Any] = (0, 0, 0)) -> sympy.ImmutableDenseMatrix:
        """Return the place (3, 1) of a point of the body [m]."""
        return self._column("position", point)

    def velocity(self, point: Sequence[Any] = (0, 0, 0)) -> sympy.ImmutableDenseMatrix:
        """Return the velocity (3, 1) of a point of the body [m / s]."""
        return self._column("velocity", point)

    @property
    def angular_velocity(self) -> sympy.ImmutableDenseMatrix:
        """(3, 1) [rad / s]"""
        return self._column("angular_velocity", ())

    @property
    def rotation(self) -> sympy.ImmutableDenseMatrix:
        """R (3, 3): its columns are the body's axes."""
        entries = [_call(Quantity("rotation", self._chain, (), (i, j))) for i in range(3) for j in range(3)]
        return sympy.ImmutableDenseMatrix(3, 3, entries)

    @property
    def quaternion(self) -> sympy.ImmutableDenseMatrix:
        """(4, 1) w, x, y, z of the rotation from the joint's frame, of a spherical or free joint.

        The sign changes where the parameters become their shadow set; both signs are the same rotation.
        """
        if self.link.joint not in ROTATED:
            raise ModelError(
                f"body {self.name!r}: its joint is {self.link.joint}. Spherical and free joints have a quaternion; "
                "`rotation` is for all."
            )
        s = self.coordinates[-3:]
        square = sympy.Add(*(one**2 for one in s))
        return sympy.ImmutableDenseMatrix([1 - square, *(2 * one for one in s)]) / (1 + square)

    def _column(self, kind: str, point: Sequence[Any]) -> sympy.ImmutableDenseMatrix:
        vector = _expressions(point, f"{kind} of {self.name}", 3) if kind in ("position", "velocity") else ()
        return sympy.ImmutableDenseMatrix([_call(Quantity(kind, self._chain, vector, (k,))) for k in range(3)])


class Tree:
    """Bodies joined to the ground and to each other, without loops; a loop is closed by constraints of the model.

    Parameters
    ----------
    gravity
        (3,) acceleration of gravity in the axes of the ground [m / s^2]; numbers, or expressions in parameters.

    Examples
    --------
    A double pendulum of rods, with a spring between the tip and the ground:

    >>> import eigenmotion as em
    >>> from sympy import symbols
    >>> m, l, k = symbols("m l k", positive=True)
    >>> tree = em.Tree()
    >>> rod = {"mass": m, "center": (0, 0, -l / 2), "inertia": (m * l**2 / 12, m * l**2 / 12, 0), "axis": "y"}
    >>> upper = tree.body("upper", joint="revolute", **rod)
    >>> lower = tree.body("lower", upper, joint="revolute", at=(0, 0, -l), **rod)
    >>> tip = lower.position((0, 0, -l))
    >>> model = em.Model(
    ...     name="rods",
    ...     coordinates=tree.coordinates,
    ...     kinetic_energy=tree.kinetic_energy,
    ...     potential_energy=tree.potential_energy + k * tip[0] ** 2 / 2,
    ...     parameters={m: 1.0, l: 0.5, k: 20.0},
    ...     outputs={"height": tip[2]},
    ... )
    >>> em.simulate(em.build(model), (0, 1)).success
    True
    """

    def __init__(self, gravity: Sequence[Any] = (0, 0, -9.81)) -> None:
        self.gravity = _expressions(gravity, "gravity", 3)
        self.bodies: dict[str, Body] = {}
        self._links: list[Link] = []

    def body(
        self,
        name: str,
        parent: Body | str | None = None,
        *,
        joint: str,
        axis: str | Sequence[Any] = "z",
        at: Sequence[Any] = (0, 0, 0),
        rotation: Any = None,
        mass: Any = 0,
        center: Sequence[Any] = (0, 0, 0),
        inertia: Any = 0,
        moment: Sequence[Any] | None = None,
        coordinates: Sequence[sympy.Expr] | None = None,
    ) -> Body:
        """Add a body and return it.

        Lengths, masses and inertias are numbers, or expressions in parameters of the model.

        Parameters
        ----------
        parent
            The body that carries it, or its name; None for the ground.
        joint
            "revolute", "prismatic", "cylindrical" (along and about the axis), "planar" (along x and y of the joint's
            frame, and about z), "spherical" (modified Rodrigues parameters), "free" (the place in the parent's frame,
            then these) or "fixed". Beyond half a turn a run replaces the parameters by their shadow set.
        axis
            (3,) of a revolute, prismatic or cylindrical joint, in the joint's frame: "x", "y", "z", or numbers.
        at, rotation
            Where the joint's frame is on the parent: its place (3,) [m], and a matrix (3, 3) whose columns are its
            axes; None for those of the parent.
        mass, center, inertia
            Mass [kg], mass centre in the body's frame [m], and inertia about the mass centre in the body's axes
            [kg m^2]: a matrix (3, 3), or (xx, yy, zz), or (xx, xy, xz, yy, yz, zz).
        moment
            First moments (3,), mass times center [kg m], in place of `center`; the inertia is then about the origin of
            the body's frame. Equations are linear in these ten numbers, so that forces identify them.
        coordinates
            Functions of time; None makes them from the name, "upper" or "upper_1", "upper_2", ... A joint that moves
            along or about an axis may be driven by another: k q + b, with the coordinate q of that joint, and numbers
            or parameters k and b.

        Raises
        ------
        ModelError
            A name is taken, a joint unknown, an axis zero, or numbers are missing; says which.
        """
        what = f"body {shown(name)}"
        self._check(name, joint, what)
        place = (_expressions(at, f"{what}: at", 3), _rotation(rotation, what))
        own = (expression(mass, f"{what}: mass"), _expressions(center, f"{what}: center", 3), _inertia(inertia, what),
               _moment(moment, center, what))  # fmt: skip
        given = self._made(name, _COUNTS[joint], what) if coordinates is None else coordinates
        q = _driven(given, joint, what)
        if joint in ROTATED and {one for one, _, _ in q} & set(self.coordinates):
            raise ModelError(f"{what}: another body has its coordinates. A {joint} joint is not driven by another one.")
        before = self._parent(parent, what)
        links = _chain(name, before, joint, q, place, _axis(axis, what), own)
        self._links += links
        body = self.bodies[name] = Body(links[-1], tuple(one for one, _, _ in q))
        return body

    @property
    def coordinates(self) -> tuple[sympy.Expr, ...]:
        """Coordinates of all joints, each once, in the order of the bodies."""
        return coordinates_of(self._links)

    @property
    def kinetic_energy(self) -> sympy.Expr:
        """Kinetic energy of all bodies [J]."""
        return _call(Quantity("kinetic_energy", tuple(self._links)))

    @property
    def potential_energy(self) -> sympy.Expr:
        """Potential energy of gravity [J]."""
        return _call(Quantity("potential_energy", tuple(self._links), self.gravity))

    def units(self, length: str = "") -> dict[sympy.Expr, str]:
        """Return the units of coordinates, for a Model: "rad" of revolute joints, and a word for lengths of others.

        Modified Rodrigues parameters, of spherical and free joints, have none.

        Examples
        --------
        >>> import eigenmotion as em
        >>> tree = em.Tree()
        >>> slide = tree.body("slide", joint="prismatic", axis="x", mass=1)
        >>> arm = tree.body("arm", slide, joint="revolute", axis="y", mass=1, center=(0, 0, -300))
        >>> tree.units("mm")
        {slide(t): 'mm', arm(t): 'rad'}
        """
        words: dict[sympy.Expr, str] = {}
        for link in self._links:
            places = link.coordinates[:3] if link.joint in ("prismatic", "free") else ()
            for q in link.coordinates:
                words.setdefault(q, "rad" if link.joint == "revolute" else length if q in places else "")
        return {q: unit for q, unit in words.items() if unit}

    def _check(self, name: Any, joint: Any, what: str) -> None:
        if not isinstance(name, str) or not name:
            raise ModelError(f"{what}: its name is a text.")
        if name in self.bodies:
            raise ModelError(f"{what}: the tree has a body of this name. Choose another.")
        if joint not in _COUNTS:
            raise ModelError(f"{what}: joint is {shown(joint)}. Give one of {', '.join(JOINTS)}.")

    def _made(self, name: str, count: int, what: str) -> tuple[sympy.Expr, ...]:
        """Return coordinates that are named after a body."""
        names = [name] if count == 1 else [f"{name}_{k + 1}" for k in range(count)]
        q = tuple(dynamicsymbols(one) for one in names)
        if taken := set(q) & set(self.coordinates):
            raise ModelError(
                f"{what}: another body has the coordinate {taken.pop()}. Rename it, or give `coordinates`."
            )
        return q

    def _parent(self, parent: Any, what: str) -> Link | None:
        if parent is None:
            return None
        if isinstance(parent, Body) and parent.link in self._links:
            return parent.link
        if parent not in self.bodies:
            hint = nearest(parent, self.bodies) if isinstance(parent, str) else ""
            raise ModelError(f"{what}: its parent {shown(parent)} is no body of this tree. Add it before.{hint}")
        return self.bodies[parent].link


Driven = tuple[sympy.Expr, sympy.Expr, sympy.Expr]
"""A coordinate q, and k and b: the joint is at k q + b."""


def _chain(
    name: str, parent: Link | None, joint: str, q: Sequence[Driven], place: tuple[Any, Any], axis: Any, own: Any
) -> list[Link]:
    """Return the body, after massless ones where the joint is made of several."""
    none = (sympy.S.Zero,) * 3
    massless = (sympy.S.Zero, none, (sympy.S.Zero,) * 6, none)
    if joint not in _COMPOSED:
        driven = q[0][1:] if FREEDOMS[joint] == 1 else ()
        return [Link(name, parent, joint, tuple(one for one, _, _ in q), place[0], place[1], axis, *own, *driven)]
    axes = [axis, axis] if joint == "cylindrical" else [_axis(letter, name) for letter in "xyz"]
    links: list[Link] = []
    for number, (kind, (one, ratio, offset), along) in enumerate(zip(_COMPOSED[joint], q, axes, strict=True)):
        last = number == len(q) - 1
        mass, center, inertia, moment = own if last else massless
        links.append(
            Link(name if last else f"{name} {number + 1}", links[-1] if links else parent, kind, (one,),
                 none if links else place[0], tuple(map(sympy.Integer, _UNIT)) if links else place[1], along,
                 mass, center, inertia, moment, ratio, offset, is_part=not last)
        )  # fmt: skip
    return links


def _call(quantity: Quantity) -> sympy.Expr:
    """Return a quantity as a function of its variables; a quantity of fixed bodies without parameters as a number."""
    if quantity.variables:
        return call(quantity)
    numbers = Arithmetic(lambda number: number, lambda number: number, sympy.sin, sympy.cos, lambda number: 1 / number)
    value = ForwardKinematics(numbers, {}).quantity(quantity)
    return sympy.S.Zero if value is None else _exact(value)


def _expressions(given: Any, what: str, count: int) -> tuple[sympy.Expr, ...]:
    entries = sequence_of(given, what)
    if len(entries) != count:
        raise ModelError(f"{what} has {len(entries)} entries. Give {count}.")
    return tuple(_exact(expression(entry, f"{what}[{k}]")) for k, entry in enumerate(entries))


def _exact(value: sympy.Expr) -> sympy.Expr:
    """Return whole floating-point numbers as integers, so that what is zero is seen to be."""
    return sympy.Integer(int(value)) if value.is_Float and float(value).is_integer() else value


def _rotation(given: Any, what: str) -> tuple[sympy.Expr, ...]:
    if given is None:
        return tuple(map(sympy.Integer, _UNIT))
    R = _matrix(given, f"{what}: rotation")
    if R.free_symbols:
        return tuple(map(_exact, R.flat()))
    error = float(max(map(abs, (R.T * R - sympy.eye(3)).evalf())))
    if error > _SKEW or float(R.det()) < 0:
        raise ModelError(
            f"{what}: rotation is no rotation: R^T R differs from 1 by {error:.1e}, and its determinant is "
            f"{float(R.det()):.3f}. Give the axes as columns, of length 1, right-handed."
        )
    for _ in range(2 if error > 1e-15 else 0):  # Newton's iteration for the nearest rotation: R (3 - R^T R) / 2
        R = R.evalf(30)
        R = R * (3 * sympy.eye(3) - R.T * R) / 2
    return tuple(_exact(sympy.Float(entry.evalf(30), 15)) for entry in R.flat())


def _matrix(given: Any, what: str) -> sympy.Matrix:
    try:
        R = sympy.Matrix(given)
    except Exception as error:  # SymPy raises its own errors, and those of what it is given
        raise ModelError(f"{what} is {shown(given)}, not a matrix (3, 3).") from error
    if R.shape != (3, 3):
        raise ModelError(f"{what} has the shape {R.shape}. Give (3, 3).")
    return R.applyfunc(lambda entry: expression(entry, what))


def _moment(given: Any, center: Sequence[Any], what: str) -> tuple[sympy.Expr, ...]:
    if given is None:
        return (sympy.S.Zero,) * 3
    if any(one != 0 for one in sequence_of(center, f"{what}: center")):
        raise ModelError(f"{what}: it has a center and a moment. Give one: the moment is the mass times the center.")
    return _expressions(given, f"{what}: moment", 3)


def _inertia(given: Any, what: str) -> tuple[sympy.Expr, ...]:
    name = f"{what}: inertia"
    if isinstance(given, (int, float, sympy.Expr)) and given == 0:
        return (sympy.S.Zero,) * 6
    shape = getattr(given, "shape", None)
    if shape == (3, 3) or (shape is None and any(isinstance(row, (list, tuple)) for row in sequence_of(given, name))):
        J = _matrix(given, name)
        if any(_differ(J[i, j], J[j, i]) for i, j in ((0, 1), (0, 2), (1, 2))):
            raise ModelError(f"{name} is not symmetric.")
        return tuple(_exact(J[i, j]) for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)))
    entries = sequence_of(given, name)
    if len(entries) == 3:
        xx, yy, zz = entries
        entries = (xx, 0, 0, yy, 0, zz)
    return _expressions(entries, name, 6)


def _differ(first: sympy.Expr, second: sympy.Expr) -> bool:
    """Whether two expressions differ, by more than rounding if they are numbers."""
    if first.free_symbols | second.free_symbols:
        return bool(sympy.simplify(first - second) != 0)
    return abs(float(first) - float(second)) > 1e-12 * max(abs(float(first)), abs(float(second)))


def _axis(given: Any, what: str) -> tuple[sympy.Expr, ...]:
    """Return a direction of length 1."""
    if isinstance(given, str) and given in ("x", "y", "z"):
        return tuple(sympy.Integer(given == letter) for letter in "xyz")
    if isinstance(given, str):
        raise ModelError(f"{what}: axis is {shown(given)}. Give x, y, z or three numbers.")
    entries = _expressions(given, f"{what}: axis", 3)
    if any(entry.free_symbols for entry in entries):
        raise ModelError(f"{what}: its axis contains parameters. Give numbers, and turn it by `rotation`.")
    numbers = [float(entry) for entry in entries]
    length = math.hypot(*numbers)
    if not length:
        raise ModelError(f"{what}: its axis is zero. Give a direction.")
    return tuple(_exact(sympy.Float(number / length)) for number in numbers)


def _driven(given: Any, joint: str, what: str) -> list[Driven]:
    """Return each coordinate with its ratio and offset."""
    entries = sequence_of(given, f"{what}: coordinates")
    read = [_linear(expression(one, f"{what}: coordinates"), what) for one in entries]
    if len(read) != _COUNTS[joint]:
        raise ModelError(
            f"{what}: coordinates is {shown(given)}. Give {_COUNTS[joint]} functions of time: dynamicsymbols."
        )
    if joint in ("spherical", "free") and any(one[1:] != (1, 0) for one in read):
        raise ModelError(f"{what}: coordinates is {shown(given)}. A {joint} joint is not driven by another one.")
    return read


def _linear(given: sympy.Expr, what: str) -> Driven:
    """Return q, k, b of k q + b."""
    functions = [one for one in given.atoms(AppliedUndef) if one.args == (t,)]
    if len(functions) == 1 and not given.has(sympy.Derivative):
        (q,) = functions
        k = sympy.diff(given, q)
        b = sympy.expand(given - k * q)
        if k != 0 and not (k.has(t) or b.has(t)):
            return q, _exact(k), _exact(b)
    raise ModelError(
        f"{what}: coordinates has {shown(given)}. Give a function of time, as dynamicsymbols makes, or k q + b with "
        "one such function q and numbers or parameters k and b."
    )
