"""The same mechanism seen from another frame: other origins, units, signs, clocks and orders of its coordinates.

With unit u_k and origin o_k of each coordinate, unit s and origin t_0 of the time, unit e of the energy and r of each
constraint row, all of them parameters, so that one compiled model serves every frame:

    x_k = u_k x'_k + o_k,    t = s t' + t_0,    xdot_k = u_k x'dot_k / s
    T' = T / e,  V' = V / e,  Q'_k = u_k Q_k / e,  phi' = phi / r,  A' xdot' + b' = (A xdot + b) / r,
    lambda' = lambda r / e
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy
from numpy.typing import ArrayLike

import eigenmotion as em
from eigenmotion import Event, Model, System, multiplier, t


def _named(kind: str, count: int) -> list[sympy.Symbol]:
    return list(sympy.symbols(f"{kind}_:{count}", real=True))


_TIME, _CLOCK, _ENERGY = sympy.symbols("unit_of_time clock unit_of_energy", real=True)


def framed(model: Model) -> Model:
    """The model in x', with the frame as parameters; those at their defaults leave it as it is."""
    units, origins, rows = _named("unit", model.n), _named("origin", model.n), _named("row", model.m)
    to_frame = _Replacement(model, units, origins, rows)
    holonomic = [phi / r for phi, r in zip(to_frame.all(model.holonomic_constraints), rows[: model.h], strict=True)]
    nonholonomic = [
        row / r for row, r in zip(to_frame.all(model.nonholonomic_constraints), rows[model.h :], strict=True)
    ]
    defaults = dict.fromkeys([*units, *rows, _TIME, _ENERGY], 1.0) | dict.fromkeys([*origins, _CLOCK], 0.0)
    return replace(
        model,
        name=f"{model.name}_framed",
        kinetic_energy=to_frame(model.kinetic_energy) / _ENERGY,
        potential_energy=to_frame(model.potential_energy) / _ENERGY,
        forces=[u * Q / _ENERGY for u, Q in zip(units, to_frame.all(model.forces), strict=True)],
        holonomic_constraints=holonomic,
        nonholonomic_constraints=nonholonomic,
        quasi_velocities=[(y, to_frame(P_xdot)) for y, P_xdot in model.quasi_velocities],
        parameters=[*model.parameters, *defaults.items()],
        outputs=[(name, to_frame(output)) for name, output in model.outputs],
        events=[
            (name, Event(to_frame(event.expression), event.direction, event.terminal)) for name, event in model.events
        ],
    )


def reordered(model: Model) -> Model:
    """The model with its coordinates, and all that follows their order, the other way round."""
    turned = ("coordinates", "forces", "holonomic_constraints", "nonholonomic_constraints", "quasi_velocities",
              "parameters", "scales")  # fmt: skip
    given = {name: getattr(model, name)[::-1] for name in turned}
    return replace(model, name=f"{model.name}_reordered", outputs=[], **given)


def seen_from(model: Model, frame: Frame) -> Model:
    """The model `framed`, with a frame for its defaults: as it is written down there."""
    x, v = frame.start(np.array(model.initial_x), np.array(model.initial_v))
    there, given = framed(model), frame.parameters(model.n, model.m)
    return replace(
        there,
        parameters={symbol: given.get(symbol.name, value) for symbol, value in there.parameters},
        initial=dict(zip([*model.coordinates, *(x.diff(t) for x in model.coordinates)], [*x, *v], strict=True)),
    )


class _Replacement:
    """Writes an expression in x, xdot, xddot, lambda and t in those of the frame."""

    def __init__(self, model: Model, units: list[sympy.Symbol], origins: list[sympy.Symbol], rows: list[sympy.Symbol]):
        kept = [*(u for u, _ in model.inputs), *(y for y, _ in model.quasi_velocities)]
        self._aside: dict[sympy.Expr, sympy.Expr] = {symbol: sympy.Dummy() for symbol in kept}
        back = {dummy: symbol for symbol, dummy in self._aside.items()}
        for x, u, o in zip(model.coordinates, units, origins, strict=True):
            for order, at in enumerate((x, x.diff(t), x.diff(t, 2))):
                self._aside[at] = dummy = sympy.Dummy()
                back[dummy] = u * at / _TIME**order + (o if order == 0 else 0)
        for k, r in enumerate(rows):
            self._aside[multiplier(k)] = dummy = sympy.Dummy()
            back[dummy] = multiplier(k) * _ENERGY / r
        self._back = back | {t: _TIME * t + _CLOCK}

    def __call__(self, expression: sympy.Expr) -> sympy.Expr:
        return expression.xreplace(self._aside).xreplace(self._back)

    def all(self, expressions: Iterable[sympy.Expr]) -> list[sympy.Expr]:
        return list(map(self, expressions))


@dataclass(frozen=True, slots=True)
class Frame:
    """One frame for n coordinates and m rows; numbers stand for all coordinates or rows alike."""

    units: ArrayLike = 1.0
    origins: ArrayLike = 0.0
    rows: ArrayLike = 1.0
    energy: float = 1.0
    time: float = 1.0
    clock: float = 0.0

    def parameters(self, n: int, m: int) -> dict[str, float]:
        """What the parameters of a `framed` model are in the frame."""
        named = {"unit": (self.units, n), "origin": (self.origins, n), "row": (self.rows, m)}
        each = {f"{kind}_{k}": float(value) for kind, (values, count) in named.items()
                for k, value in enumerate(np.resize(values, count))}  # fmt: skip
        return each | {"unit_of_time": self.time, "clock": self.clock, "unit_of_energy": self.energy}

    def start(self, x: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """x', v' of a state in the model's own frame."""
        units = np.resize(self.units, len(x))
        return (x - np.resize(self.origins, len(x))) / units, v * self.time / units

    def run(
        self, system: System, span: float, rtol: float, atol: float, initial: Sequence[np.ndarray] = (), **options: Any
    ) -> Run:
        """Run a `framed` model from its start, with the tolerance atol on its coordinates in their own units.

        initial : x, v in the model's own frame, where they are not those that the system has as its own
        """
        units, origins = np.resize(self.units, system.n), np.resize(self.origins, system.n)
        x0, v0 = self.start(*(initial or system.initial))
        start, end = ((at - self.clock) / self.time for at in (0.0, span))
        solution = system.simulate(
            (start, end), x0=x0, v0=v0, parameters=self.parameters(system.n, system.m), rtol=rtol,
            atol=dict(zip(system.coordinates, (atol / np.abs(units)).tolist(), strict=True)),
            **options,
        )  # fmt: skip
        x, v = units * solution.x[:, -1] + origins, units * solution.v[:, -1] / self.time
        return Run(solution, x, v)


@dataclass(frozen=True, slots=True)
class Run:
    """A run, and x, v (n,) at its end in the model's own frame."""

    solution: em.Solution
    x: np.ndarray
    v: np.ndarray
