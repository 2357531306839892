"""Kane's generalised speeds u, and their relation to the rates of coordinates by the kinematic equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy
from sympy.physics.mechanics import System, dynamicsymbols

from ..model import ModelError, t
from ..model.normalise import name_of


@dataclass(frozen=True, slots=True)
class Speeds:
    """Coordinates q (n), and speeds u = P(q, t) qdot + p(q, t).

    in_rates : u -> P qdot + p; empty if the speeds are the rates themselves
    in_speeds : qdot -> expression in u, the inverse
    linear : whether p is zero and every u is a symbol, so that the speeds are quasi-velocities (3)
    """

    coordinates: tuple[sympy.Expr, ...]
    in_rates: Mapping[sympy.Expr, sympy.Expr]
    in_speeds: Mapping[sympy.Expr, sympy.Expr]
    linear: bool

    @property
    def rates(self) -> tuple[sympy.Expr, ...]:
        """(n) the rates qdot."""
        return tuple(q.diff(t) for q in self.coordinates)

    @property
    def velocities(self) -> tuple[sympy.Expr, ...]:
        """(n) the velocities in which energies and loads are written: the speeds if `linear`, else the rates."""
        return tuple(self.in_rates) if self.linear else self.rates

    @property
    def written(self) -> Mapping[sympy.Expr, sympy.Expr]:
        """The replacements that express everything in `velocities`."""
        return self.in_speeds if self.linear else self.in_rates

    @property
    def P(self) -> sympy.ImmutableDenseMatrix:
        """(n, n) derivatives of `velocities` with respect to the rates."""
        if not self.linear:
            return sympy.ImmutableDenseMatrix.eye(len(self.coordinates))
        return sympy.ImmutableDenseMatrix([[row.diff(rate) for rate in self.rates] for row in self.in_rates.values()])


def speeds_of(system: System) -> Speeds:
    """Solve the kinematic equations of a system; a speed that does not occur in them becomes the rate of a coordinate.

    Raises
    ------
    ModelError
        They are not linear, too few or too many; names the speeds and coordinates.
    """
    named = [u for u in system.u if not isinstance(u, sympy.Derivative)]
    kinematic = [u for u in named if system.kdes.has(u)]
    fresh = {u: dynamicsymbols(f"{name_of(u)}_integral") for u in named if u not in kinematic}
    solved = [q for q in system.q if q.diff(t) not in system.u]
    if named or system.kdes:  # otherwise all speeds are rates
        _check_count(kinematic, solved, list(system.kdes))
    in_rates, in_speeds = _solved(kinematic, [q.diff(t) for q in solved], system.kdes)
    in_rates |= {u: q.diff(t) for u, q in fresh.items()}
    in_speeds |= {q.diff(t): u for u, q in fresh.items()}
    coordinates = (*system.q, *fresh.values())
    homogeneous = not any(row.xreplace({q.diff(t): sympy.S.Zero for q in coordinates}) for row in in_rates.values())
    ordered = {u: in_rates[u] for u in named}
    return Speeds(coordinates, ordered, in_speeds, homogeneous and len(ordered) == len(coordinates))


def _check_count(speeds: list[sympy.Expr], coordinates: list[sympy.Expr], equations: list[sympy.Expr]) -> None:
    if not len(speeds) == len(coordinates) == len(equations):
        raise ModelError(
            f"{len(equations)} kinematic equations for the {len(coordinates)} coordinates "
            f"{', '.join(map(name_of, coordinates))} and the {len(speeds)} speeds {', '.join(map(name_of, speeds))}. "
            "Give one equation for each coordinate, such as q.diff() - u, by add_kdes or kinematic_equations."
        )


def _solved(
    speeds: list[sympy.Expr], rates: list[sympy.Expr], equations: sympy.MatrixBase
) -> tuple[dict[sympy.Expr, sympy.Expr], dict[sympy.Expr, sympy.Expr]]:
    """Solve U u + K qdot + k = 0 for u and for qdot."""
    if not equations:
        return {}, {}
    equations = sympy.Matrix(equations)
    U, K = equations.jacobian(speeds), equations.jacobian(rates)
    for row, equation in enumerate(equations):
        if sympy.Matrix([*U.row(row), *K.row(row)]).has(*speeds, *rates):
            raise ModelError(f"The kinematic equation {equation} is not linear in the speeds and rates.")
    k = equations.xreplace(dict.fromkeys([*speeds, *rates], sympy.S.Zero))
    try:
        u, qdot = (_solve(A, -(B * sympy.Matrix(x) + k)) for A, B, x in ((U, K, rates), (K, U, speeds)))
    except ValueError as error:
        names = ", ".join(map(name_of, [*speeds, *rates]))
        raise ModelError(f"The kinematic equations cannot be solved for {names}: {error}.") from error
    return dict(zip(speeds, u, strict=True)), dict(zip(rates, qdot, strict=True))


def _solve(A: sympy.MatrixBase, b: sympy.MatrixBase) -> sympy.MatrixBase:
    return A.LUsolve(b).applyfunc(sympy.trigsimp)
