"""Tasks: all input of one run; and of an ensemble, as options that its members share and columns of what differs."""

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..runtime import CompiledModel, Prepared
from .differentiation import Differentiated
from .named_values import Vector
from .sampled import Controlled
from .signals import Inputs, Signal

Column = float | Signal | Controlled | Vector | list[Any]
TO_DERIVE = 2
"""Value of Task.dense: keep the dense output for sensitivities, which need no steps shortened for its accuracy."""


class Task(NamedTuple):
    """One run.

    y : (n_state,), published meaning, at t_start
    atol : (n,), of x_k [u_k] and of its velocity [u_k / s]
    t_eval : (k,) in the direction of time, or None: a row for every accepted step
    dense : 1 to keep the dense output for states between rows; TO_DERIVE to keep it for sensitivities
    first_step : [s]; 0: estimated
    stabilise : whether accepted states are projected onto the constraints and eigenfactors are restored
    least_norm : the treatment of dependent constraint rows, a value of DEPENDENT
    """

    model: CompiledModel
    prepared: Prepared
    inputs: Inputs
    t_start: float
    t_end: float
    y: Vector
    rtol: float
    atol: Vector
    t_eval: Vector | None
    dense: int
    first_step: float
    max_step: float
    max_steps: int
    stabilise: bool
    least_norm: int


@dataclass(frozen=True, slots=True, eq=False)
class EnsembleTask:
    """The part of a task that all members of an ensemble share. Fields as of `Task`, and:

    t_eval : (nt,) times of the rows
    method : em_method of em_run.h; None if the method is not compiled
    iterates : whether the method solves its steps by iteration
    end_only : whether each run keeps only its last row
    differentiated : the variables of differentiation, or None
    """

    model: CompiledModel
    method: int | None
    name: str
    iterates: bool
    t_start: float
    t_end: float
    rtol: float
    atol: Vector
    t_eval: Vector
    end_only: bool
    first_step: float
    max_step: float
    max_steps: int
    stabilise: bool
    least_norm: int
    differentiated: Differentiated | None = None

    def task(self, prepared: Any, inputs: Inputs, y: Vector) -> Task:
        """Return the task of one member."""
        t_eval = None if self.end_only else self.t_eval
        return Task(
            self.model, prepared, inputs, self.t_start, self.t_end, y, self.rtol, self.atol, t_eval, False,
            self.first_step, self.max_step, self.max_steps, self.stabilise, self.least_norm,
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Members:
    """K members. All members share an array with one row, and an input that is one number or Signal.

    parameters (K or 1, n_parameters), x, v (K or 1, n)
    signals : for each input a number or a Signal for all, (K,) numbers, or a list of K numbers, Signals and controllers
    refused : (K,) whether a member cannot start for a reason found before its run
    swept : name -> (K,) values of each argument that differs between members
    first : the number of member 0 in the ensemble, if these members are a chunk of it
    """

    count: int
    parameters: Vector
    x: Vector
    v: Vector
    signals: tuple[Column, ...]
    refused: NDArray[np.bool_]
    reasons: dict[int, str]
    swept: dict[str, Vector]
    first: int = 0

    def part(self, start: int, stop: int) -> "Members":
        """Return members start ... stop - 1."""

        def rows(table: Any) -> Any:
            return table[start:stop] if isinstance(table, list) or len(table) > 1 else table

        signals = tuple(rows(one) if isinstance(one, list | np.ndarray) else one for one in self.signals)
        reasons = {k - start: words for k, words in self.reasons.items() if start <= k < stop}
        return replace(
            self, count=stop - start, parameters=rows(self.parameters), x=rows(self.x), v=rows(self.v),
            signals=signals, refused=self.refused[start:stop], reasons=reasons, swept={}, first=self.first + start,
        )  # fmt: skip

    @property
    def controllers(self) -> list[Controlled]:
        """All controllers, each once."""
        lists = [one for one in self.signals if isinstance(one, list)]
        return list(dict.fromkeys(one for each in lists for one in each if isinstance(one, Controlled)))

    @property
    def inputs(self) -> tuple[Any, ...]:
        """Each input for compiled runs: an `em_signal`, an array of numbers, or a list of `em_signal`."""
        return tuple(
            one if isinstance(one, np.ndarray)
            else [Inputs((each,)).compiled[0] for each in one] if isinstance(one, list)
            else Inputs((one,)).compiled[0]
            for one in self.signals
        )  # fmt: skip

    def inputs_of(self, k: int) -> Inputs:
        """Return the inputs of one member."""
        chosen = (one[k] if isinstance(one, list | np.ndarray) else one for one in self.signals)
        return Inputs(tuple(one if isinstance(one, Signal | Controlled) else float(one) for one in chosen))

    def row(self, name: str, k: int) -> Vector:
        """Return the parameters, x or v of one member."""
        table: Vector = getattr(self, name)
        return np.asarray(table[k if len(table) > 1 else 0])
