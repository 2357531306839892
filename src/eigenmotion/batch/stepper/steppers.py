"""Batch of steppers: K mechanisms of one model, advanced by one call."""

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arguments.named_values import Vector
from ...arguments.states import names_of_states, split_states
from ...arguments.tasks import EnsembleTask
from ...codegen.model.normalise import ModelError, number
from ...runtime import EvaluationError, ManySteps, StopReason
from ...simulation.initial_state.consistency import start_state
from .step_arguments import check_way, chosen_by, columns, numbers, rows

_LEAST = 64  # fewest members for which a thread pays
_LEAST_IN_LANES = 1024  # the same in lanes, which are faster


@dataclass(frozen=True, slots=True, eq=False)
class Starts:
    """Starts of K members: t (K,), x, v (K, n), parameters (K, n_parameters), inputs (K, n_inputs)."""

    t: Vector
    x: Vector
    v: Vector
    parameters: Vector
    inputs: Vector


class Steppers(ManySteps):
    """A batch of K steppers of one model: `System.steppers` opens it.

    `advance(t, inputs=None)` takes every member to t, a number or (K,) numbers [s]; `inputs` (K, n_inputs), or numbers
    and (K,) arrays by name, apply from then on. A member that fails or meets a terminal event has `ended`: it keeps its
    last state until `reset` starts it again, and does not affect the others. `save()` returns the complete state of the
    batch as bytes; `restore(saved)` restores it bit for bit. `advance` allocates no memory.

    The motion of a member does not depend on K, on its index or on the number of threads, bit for bit. It is bit for
    bit that of a single `Stepper`, except in `lanes`, where it agrees to rounding.

    Attributes
    ----------
    t, x, v, u : (K,) [s], (K, n), (K, n), (K, n_inputs)
        The present state and inputs. These are views, which the next `advance` changes: copy what you want to keep.
    ended : (K,)
        Whether a member has ended and waits for a reset.
    y : (K, n_state)
        The states, published meaning.
    energy, jacobi_integral, acceleration, multipliers : (K,) [J], (K,) [J], (K, n), (K, m)
    outputs, events : dict name -> (K,)
        The outputs of the model; the time of the last zero crossing of each event in the last advance, NaN without one.
    stop : list of K StopReason
        Why each ended; `FINISHED` if it has not.
    failed : indices
        The members that ended for another reason than a terminal event; `message(k)` says what to do.
    nfev, nsteps : (K,)
        Right-hand sides and accepted steps since the start of each member.
    starts : Starts
        t (K,), x, v, parameters and inputs (K, ...) of the members when the batch was opened.
    lanes : int
        The number of members that one core advances together; 1: no lanes (see `System.steppers`).

    Examples
    --------
    >>> import numpy as np
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> envs = em.build(model).steppers(3, x0={"theta": [0.5, 1.0, 1.5]}, rtol=1e-9)
    >>> envs.advance(0.5)
    >>> envs.x[:, 0].round(4)
    array([0.0147, 0.1043, 0.3494])
    >>> envs.reset([False, True, False], x0={"theta": 0.1})
    >>> envs.t, envs.x[:, 0].round(4)
    (array([0.5, 0. , 0.5]), array([0.0147, 0.1   , 0.3494]))
    >>> envs.advance(envs.t + 0.1)
    """

    def __init__(self, _task: EnsembleTask, count: int, _workers: int, starts: Starts) -> None:
        """Open the batch with all members at their start."""
        self.starts, self._busy = starts, False
        self._begin(np.arange(count), starts)

    def __len__(self) -> int:
        return self.count

    def __repr__(self) -> str:
        ended = int(np.count_nonzero(self.ended))
        return f"<{self.count} Steppers of {self.model.name}{f', {ended} ended' if ended else ''}>"

    # --- advancing ---

    def advance(self, t: float | ArrayLike, inputs: Mapping[Any, ArrayLike] | ArrayLike | None = None) -> None:
        """Advance all members to exactly t, a number or (K,) numbers [s], forwards or back; inputs apply from now on.

        Raises
        ------
        ModelError
            t or an input is not finite or has the wrong shape, or a name is unknown. No member has moved then.
        """
        self._claim()
        try:
            if not (isinstance(t, float) and self.set_goal(t)):
                self.goals[...] = numbers(t, self.count, "t")
            if inputs is not None and not (self._simple(inputs) and self.set_inputs(cast("Vector", inputs))):
                self.set_inputs(columns(inputs, self.model.inputs, self.u))
            check_way(self.model, self.goals, self.t, self.ended)
            self._go()
        finally:
            self._busy = False
        self.raise_pending()

    def _simple(self, inputs: Any) -> bool:
        """Return whether the arguments are arrays that C can use without conversion."""
        return isinstance(inputs, np.ndarray) and inputs.dtype == np.float64 and inputs.shape == self.u.shape

    def _claim(self) -> None:
        if self._busy:
            raise RuntimeError("these steppers are being advanced, by another thread or a signal handler")
        self._busy = True

    def _go(self) -> None:
        """Advance ranges of members: the first in this thread, which handles signals, the others in other threads."""
        parts = self._parts
        if len(parts) == 1:
            self.go(0, self.count, 0)
            return
        others = [self._threads.submit(self.go, *part, k) for k, part in enumerate(parts[1:], 1)]
        try:
            self.go(*parts[0], 0)
        finally:
            wait(others)

    @cached_property
    def _parts(self) -> list[tuple[int, int]]:
        """Return the range of members of each thread; a lane group is not divided."""
        least = _LEAST_IN_LANES if self.lanes > 1 else _LEAST
        count = max(1, min(self.workers, self.count // least))
        ends = [8 * round(self.count * k / count / 8) for k in range(count)] + [self.count]
        return list(pairwise(ends))

    @cached_property
    def _threads(self) -> ThreadPoolExecutor:
        return ThreadPoolExecutor(len(self._parts) - 1, "steppers")

    # --- resetting ---

    def reset(
        self,
        mask: ArrayLike | None = None,
        *,
        t: float | None = None,
        x0: Mapping[Any, ArrayLike] | ArrayLike | None = None,
        v0: Mapping[Any, ArrayLike] | ArrayLike | None = None,
        parameters: Mapping[Any, ArrayLike] | ArrayLike | None = None,
        inputs: Mapping[Any, ArrayLike] | ArrayLike | None = None,
    ) -> None:
        """Restart members; arguments that are not given have the values of each member when the batch was opened.

        Parameters
        ----------
        mask
            (K,) booleans, or indices of members; None: all.
        t
            [s] the time of the restart.
        x0, v0, parameters, inputs
            By name, numbers or (K,) arrays; or arrays (n,) or (K, n). Rows of members that continue are ignored.

        Raises
        ------
        ModelError
            An inconsistent start; the error names the member, and no member was reset.
        """
        self._claim()
        try:
            chosen, starts = chosen_by(mask, self.count), self.starts
            times = starts.t if t is None else np.full(self.count, number(t, "t"))
            names = self.model.parameters
            p = rows(parameters, names, starts.parameters, chosen, "parameter")
            x, v = self._start(x0, v0, starts, chosen)
            u = starts.inputs if inputs is None else columns(inputs, self.model.inputs, starts.inputs)
            self._begin(chosen, Starts(times, x, v, p, u))
        finally:
            self._busy = False

    def _start(self, x0: Any, v0: Any, starts: Starts, chosen: NDArray[np.intp]) -> tuple[Vector, Vector]:
        """Return x, v of compiled functions: the arguments, over the starts of the batch."""
        c = self.model
        n, (x0, z) = c.n_coordinates, split_states(c, x0)
        x = rows(x0, c.coordinates[:n], starts.x[:, :n], chosen, "coordinate of x0")
        v = rows(v0, c.coordinates[:n], starts.v[:, :n], chosen, "coordinate of v0")
        if not c.n_states:
            return x, v
        z = rows(z, names_of_states(c), starts.v[:, n:], chosen, "state of x0")
        return np.hstack([x, starts.x[:, n:]]), np.hstack([v, z])

    def _begin(self, chosen: NDArray[np.intp], starts: Starts) -> None:
        """Restart all these members; if one cannot start, restart none and raise."""
        to_check = self.stage(chosen, starts.t, starts.x, starts.v, starts.parameters)
        for k in chosen.tolist() if self.model.extrapolates else to_check.tolist():
            try:
                prepared = self.model.prepare(starts.parameters[k].copy())
                start = starts.x[k].copy(), starts.v[k].copy()
                y = start_state(self.model, prepared, float(starts.t[k]), *start, self.task.rtol, self.task.atol)
            except (ModelError, EvaluationError) as error:
                raise ModelError(f"member {k} of {self.count}: {error}") from error
            self.set_start(k, y)
        self.begin(chosen, starts.t, starts.inputs)

    # --- saving ---

    def save(self) -> bytes:
        """Return the complete state of all members as bytes: `restore` restores every number bit for bit."""
        saved: bytes = self.saved()
        return saved

    def restore(self, saved: bytes) -> None:
        """Restore the state that `save` returned, of these steppers or of others of the same model, options and K.

        Raises
        ------
        ValueError
            `saved` is of another model, of other options or of another K.
        """
        self._claim()
        try:
            if not (isinstance(saved, bytes) and self.restore_saved(saved)):
                raise ValueError(f"{self.model.name}: what is to be restored was saved by steppers of another model, "
                                 "method, number, or other tolerances, or compiled for another processor")  # fmt: skip
        finally:
            self._busy = False

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.task, self.count, self.workers, self.starts, self.save())

    # --- present state ---

    @property
    def lanes(self) -> int:
        """The number of members that one core advances together; 1: no lanes."""
        return self.width

    @property
    def y(self) -> Vector:
        """(K, n_state) the states, published meaning."""
        return self.published()

    @property
    def energy(self) -> Vector:
        """(K,) T + V [J]."""
        total: Vector = self.energies().sum(axis=1)
        return total

    @property
    def jacobi_integral(self) -> Vector:
        """(K,) T2 - T0 + V [J]."""
        T2, _, T0, V = self.energies().T
        difference: Vector = T2 - T0 + V
        return difference

    @property
    def acceleration(self) -> Vector:
        """(K, n) d2x/dt2 with the current inputs."""
        return self.reactions()[0][:, : self.model.n_coordinates]

    @property
    def states(self) -> dict[str, Vector]:
        """Name of each first-order state -> (K,)."""
        return dict(zip(names_of_states(self.model), self.whole_v.T[self.model.n_coordinates :], strict=True))

    @property
    def multipliers(self) -> Vector:
        """(K, m) multipliers lambda; the constraint force is -A^T lambda (7)."""
        return self.reactions()[1]

    @property
    def outputs(self) -> dict[str, Vector]:
        """Name of each output -> (K,)."""
        return dict(zip(self.model.outputs, self.observed().T, strict=True))

    @property
    def events(self) -> dict[str, Vector]:
        """Name of each event -> (K,) time of its last zero crossing in the last advance [s]; NaN without one."""
        return dict(zip(self.model.events, self.crossings().T, strict=True)) if self.model.events else {}

    @property
    def stop(self) -> list[StopReason]:
        """Why each member ended; FINISHED if it has not."""
        reasons = [self.reason(k) if ended else None for k, ended in enumerate(self.ended.tolist())]
        return [StopReason.FINISHED if reason is None else reason[0] for reason in reasons]

    @property
    def failed(self) -> NDArray[np.intp]:
        """Indices of the members that ended for another reason than a terminal event."""
        return np.array([k for k in np.flatnonzero(self.ended).tolist() if not self.stop_of(k).success], dtype=np.intp)

    def stop_of(self, k: int) -> StopReason:
        """Return why member k ended; FINISHED if it has not."""
        reason = self.reason(k)
        return StopReason.FINISHED if reason is None else reason[0]

    def message(self, k: int) -> str:
        """Return a message: how member k ended, and what to do about it; "" if it has not ended."""
        reason = self.reason(k)
        return "" if reason is None else f"{self.model.name}: member {k} at t = {self.t[k]:.9g}: {reason[1]}"


def _restored(task: EnsembleTask, count: int, workers: int, starts: Starts, saved: bytes) -> Steppers:
    batch = Steppers(task, count, workers, starts)
    batch.restore(saved)
    return batch
