"""Starts of runs at values of the unknowns, and their derivatives: constraints move what is not kept."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arguments.differentiation import rates_of
from ...arguments.named_values import Vector, by_spelling, is_named, rate_name, vector
from ...codegen.model.normalise import ModelError
from ...compiled.projection import closure
from ...runtime import CompiledModel, Prepared
from ...runtime.variations import constraint_partials
from ..equilibrium.assemble import assemble
from ..state.operating_point import OperatingPoint
from ..state.tangent_space import null_space
from .unknowns import Given, Unknowns

_PREFERRED = 30.0
"""Factor of the columns of values that users do not give, so that these follow from the others where they can."""
_STEPS = 30
"""Largest number of Newton's steps onto the constraints."""
_CLOSED = 1e4
"""Largest residual phi, in roundings of its terms."""


@dataclass(frozen=True)
class Start:
    """The start of a run.

    directions : for each unknown, the names of `sensitivities` that it moves, with factors
    """

    x0: Any
    v0: Any
    directions: tuple[Mapping[str, float], ...]


@dataclass(frozen=True)
class FreeStart:
    """Starts without constraints: initial values do not depend on each other. held : no names"""

    given: Given
    unknowns: Unknowns
    held: tuple[str, ...] = ()

    def at(self, values: Mapping[str, float], _: Prepared) -> Start:
        """Return the start at values of the unknowns."""
        c, given = self.given.system.compiled, self.given
        x0 = _named(given.x0, c.coordinates, "x0") | {name: values[name] for name in self.unknowns.positions}
        rates = {name.removesuffix("'"): values[name] for name in self.unknowns.rates}
        v0 = _named(given.v0, c.coordinates, "v0") | rates
        moved = tuple({name: 1.0} for name in self.unknowns.names)
        return Start(x0, None if given.v0 is None and not rates else v0, moved)


def _named(argument: Any, names: tuple[str, ...], what: str) -> dict[str, Any]:
    """Return a start as a mapping of names."""
    if argument is None:
        return {}
    if is_named(argument):
        return by_spelling(argument, what, rate_name)
    return dict(zip(names, vector(argument, what), strict=False))


@dataclass
class ConstrainedStart:
    """Starts on constraints.

    Unknown initial values are kept, then those that x0 and v0 name, then others; the rest follows from the constraints.

    dependent : (positions, rates) numbers of those that follow
    held : names of values that are neither given nor unknown, and which stay as they are at the first start while
        others follow
    """

    unknowns: Unknowns
    model: CompiledModel
    t: float
    x: Vector
    v: Vector
    dependent: tuple[list[int], list[int]]
    held: tuple[str, ...]

    def at(self, values: Mapping[str, float], prepared: Prepared) -> Start:
        """Return the start at values of the unknowns.

        Raises
        ------
        ModelError
            The constraints cannot be closed there.
        """
        c, n = self.model, self.model.n_coordinates
        positions = dict(zip(c.coordinates[:n], range(n), strict=True))
        x, v = self.x.copy(), self.v.copy()
        for name in self.unknowns.positions:
            if name in positions:
                x[positions[name]] = values[name]
            else:
                v[c.coordinates.index(name)] = values[name]
        for name in self.unknowns.rates:
            v[positions[name.removesuffix("'")]] = values[name]
        self.x, self.v = x, v = self._moving(prepared, self._closed(prepared, x), v)
        whole = {"x0": np.concatenate([x[:n], v[n:]]), "v0": v[:n]}
        return Start(**whole, directions=self._directions(prepared, x, v))

    def _closed(self, prepared: Prepared, x: Vector) -> Vector:
        """Return x with phi = 0, by Newton's method in the dependent coordinates."""
        c, dependent = self.model, self.dependent[0]
        with np.errstate(all="ignore"):
            for _ in range(_STEPS if dependent else 0):
                step = self._solved(prepared, x, c.pfaffian(self.t, x, prepared)[0][: c.h], dependent,
                                    -c.position(self.t, x, prepared)[0])  # fmt: skip
                x = x.copy()
                x[dependent] += step
                if not np.abs(step).max() > 1e-15 * np.abs(x).max():
                    break
            phi, rounding = closure(c, prepared, self.t, x)
        if not (np.abs(phi) <= _CLOSED * rounding).all():
            names = ", ".join(c.coordinates[k] for k in range(c.n_coordinates) if k not in dependent) or "nothing"
            raise ModelError(f"{c.name}: the constraints cannot be closed at the start with {names} kept")
        return x

    def _moving(self, prepared: Prepared, x: Vector, v: Vector) -> tuple[Vector, Vector]:
        """Return x, and v with A v + b = 0."""
        A, b = self.model.pfaffian(self.t, x, prepared)
        v, dependent = v.copy(), self.dependent[1]
        v[dependent] = 0.0
        v[dependent] = self._solved(prepared, x, A, dependent, -(A @ v + b))
        return x, v

    def _solved(self, prepared: Prepared, x: Vector, A: Vector, dependent: list[int], right: Vector) -> Vector:
        """Return the dependent numbers, (d,) or (d, k), with which A times them is `right`."""
        unit = _units(self.model, prepared, self.t, x)[dependent]
        part = A[:, dependent] * unit
        length = np.linalg.norm(part, axis=1)
        length = np.where(length > 0.0, length, 1.0)
        if not np.isfinite(part).all():
            raise ModelError(f"{self.model.name}: the constraints are not finite at the start")
        solution = np.linalg.lstsq(part / length[:, None], (right.T / length).T, rcond=1e-12)[0]
        return np.asarray((solution.T * unit).T)

    def _directions(self, prepared: Prepared, x: Vector, v: Vector) -> tuple[dict[str, float], ...]:
        """Return the derivatives of the start along the constraints."""
        c, names = self.model, self.unknowns.names
        n, h = c.n, c.h
        D, columns = constraint_partials(c, self.t, x, v, prepared), argument_columns(c, names)
        S, given = np.zeros((2 * n, len(names))), np.zeros((len(D), len(names)))
        for j, (name, column) in enumerate(zip(names, columns, strict=True)):
            if column >= 0:
                given[:, j] = D[:, column]
            else:
                S[_row(c, name), j] = 1.0
        S[self.dependent[0]] = self._solved(prepared, x, D[:h, :n], self.dependent[0], -(D[:h, :n] @ S[:n] + given[:h]))
        rest = D[h:, : 2 * n] @ S + given[h:]
        S[[n + k for k in self.dependent[1]]] = self._solved(prepared, x, D[h:, n : 2 * n], self.dependent[1], -rest)
        own = (*c.coordinates[: c.n_coordinates], *[""] * c.n_states, *rates_of(c.coordinates[: c.n_coordinates]),
               *c.coordinates[c.n_coordinates :])  # fmt: skip
        moved = [{own[row]: float(S[row, j]) for row in np.flatnonzero(S[:, j])} for j in range(len(names))]
        return tuple(
            one | ({name: 1.0} if column >= 0 else {}) for one, name, column in zip(moved, names, columns, strict=True)
        )


def argument_columns(c: CompiledModel, names: tuple[str, ...]) -> list[int]:
    """Return the argument of compiled functions that each name is, or -1 for initial values."""
    others = {name: 2 * c.n + k for k, name in enumerate((*c.inputs, *c.parameters))}
    return [-1 if name in c.coordinates else others.get(name, -1) for name in names]


def _row(c: CompiledModel, name: str) -> int:
    """Return the row of an initial value among x, v of compiled functions."""
    if name in c.coordinates:
        k = c.coordinates.index(name)
        return k if k < c.n_coordinates else c.n + k
    return c.n + c.coordinates.index(name.removesuffix("'"))


def _units(c: CompiledModel, prepared: Prepared, t: float, x: Vector) -> Vector:
    """Return (n,) changes of coordinates that can be compared."""
    return 1.0 / OperatingPoint(c, prepared, t, x, np.zeros(c.n), c.input_defaults).inertia


def start_of(given: Given, unknowns: Unknowns, prepared: Prepared) -> FreeStart | ConstrainedStart:
    """Return the starts of runs; with constraints, assembled at the guesses.

    Raises
    ------
    ModelError
        The start cannot be assembled, initial values that are kept depend on each other, or v0 has quasi-velocities.
    """
    c = given.system.compiled
    given.system.begin(given.x0, given.v0, given.t, prepared)  # refuses wrong names and shapes
    if not c.m:
        return FreeStart(given, unknowns)
    _refuse_quasi(given, unknowns)
    return _Assembly(given, unknowns, prepared).made()


def _refuse_quasi(given: Given, unknowns: Unknowns) -> None:
    c = given.system.compiled
    quasi = set(c.quasi_velocities)
    named = set(_named(given.v0, (), "v0")) | set(unknowns.rates) if is_named(given.v0) else set(unknowns.rates)
    if quasi & named or (given.v0 is None and c.initial_y is not None):
        raise ModelError(
            f"{c.name}: a fit on constraints starts from rates, not from quasi-velocities. Give v0 in rates."
        )


class _Assembly:
    """The first start on constraints, and the choice of what follows from them."""

    def __init__(self, given: Given, unknowns: Unknowns, prepared: Prepared) -> None:
        self.given, self.unknowns, self.prepared = given, unknowns, prepared
        self.c = c = given.system.compiled
        own = c.coordinates[: c.n_coordinates]
        guesses = dict(zip(unknowns.names, unknowns.guesses, strict=True))
        self.x0 = _named(given.x0, c.coordinates, "x0") | {name: guesses[name] for name in unknowns.positions}
        self.v0 = _named(given.v0, own, "v0") | {name.removesuffix("'"): guesses[name] for name in unknowns.rates}
        self.strict = (
            [own.index(name) for name in unknowns.positions if name in own],
            [own.index(name.removesuffix("'")) for name in unknowns.rates] + list(range(len(own), c.n)),
        )
        self.named = (
            [own.index(name) for name in (self.x0 if is_named(given.x0) else ()) if name in own],
            [own.index(name) for name in (self.v0 if is_named(given.v0) else ()) if name in own],
        )

    def made(self) -> ConstrainedStart:
        given, c = self.given, self.c
        x, v = given.system.begin(self.x0, self.v0, given.t, self.prepared)
        dependent = self._dependent(x)
        positions = [c.coordinates[k] for k in {*self.strict[0], *self.named[0]} - set(dependent[0])]
        rates = {c.coordinates[k]: v[k] for k in {*self.strict[1], *self.named[1]} - set(dependent[1])
                 if k < c.n_coordinates}  # fmt: skip
        found = assemble(given.system, self.x0, rates, t=given.t, parameters=self.prepared, keep=positions)
        n = c.n_coordinates
        x, v = np.concatenate([found.x, x[n:]]), np.concatenate([found.v, v[n:]])
        dependent = self._dependent(x)
        start = ConstrainedStart(self.unknowns, c, given.t, x, v, dependent, ())
        guesses = dict(zip(self.unknowns.names, self.unknowns.guesses, strict=True))
        moved = {name for one in start.at(guesses, self.prepared).directions for name in one}
        self._check_named(moved, dependent)
        start.held = self._held(moved, dependent)
        return start

    def _dependent(self, x: Vector) -> tuple[list[int], list[int]]:
        """Return the numbers of positions and of rates that follow from the others."""
        c = self.c
        A = c.pfaffian(self.given.t, x, self.prepared)[0]
        return self._following(x, A[: c.h], 0), self._following(x, A, 1)

    def _following(self, x: Vector, A: Vector, which: int) -> list[int]:
        c, strict, named = self.c, self.strict[which], self.named[which]
        unit = _units(c, self.prepared, self.given.t, x)
        unit[[k for k in range(c.n) if k not in strict]] *= _PREFERRED
        unit[[k for k in range(c.n) if k not in strict and k not in named]] *= _PREFERRED
        free = null_space(A, unit)[0]
        following = [k for k in range(c.n) if k not in free]
        if wrong := set(strict) & set(following):
            names = ", ".join(repr(c.coordinates[k] + "'" * which) for k in strict if k < c.n_coordinates)
            raise ModelError(
                f"{c.name}: initial values {names} are unknown, but the constraints do not let them vary apart: they "
                f"determine {', '.join(repr(c.coordinates[k] + chr(39) * which) for k in sorted(wrong))}. Name fewer."
            )
        return following

    def _held(self, moved: set[str], dependent: tuple[list[int], list[int]]) -> tuple[str, ...]:
        """Return values whose keeping matters, because others follow from the unknowns and from them."""
        c = self.c
        return tuple(
            c.coordinates[k] + "'" * which
            for which in (0, 1)
            if any(c.coordinates[k] + "'" * which in moved for k in dependent[which])
            for k in range(c.n_coordinates)
            if k not in (*dependent[which], *self.strict[which], *self.named[which])
        )

    def _check_named(self, moved: set[str], dependent: tuple[list[int], list[int]]) -> None:
        """Raise ModelError if a value that users give follows from the unknowns."""
        c = self.c
        for which, what in ((0, "x0"), (1, "v0")):
            for k in set(self.named[which]) & set(dependent[which]):
                name = c.coordinates[k] + "'" * which
                if name in moved:
                    raise ModelError(
                        f"{c.name}: {what} gives {c.coordinates[k]!r}, but with the constraints it follows from the "
                        f"unknowns and the other given values. Leave it out of {what}."
                    )
