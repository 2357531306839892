"""Stepper: a motion that the caller advances to chosen times, `System.stepper`."""

from collections.abc import Mapping
from typing import Any, Never

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import options
from ..arguments.methods import FIXED, STEPPED, method_of
from ..arguments.named_values import Vector, unknown
from ..arguments.options import STABILISATIONS, OptionError, choice
from ..arguments.tasks import Task
from ..codegen.model.normalise import ModelError, number, real
from ..compiled.compiled_system import CompiledSystem
from ..runtime import Steps
from .initial_state.consistency import start_state
from .initial_state.restart import restart_state

METHOD_NUMBERS = {name: method.number for name, method in STEPPED.items()}
_OPTIONS = ("t", "x0", "v0", "parameters", "inputs", "start", "rtol", "atol", "method", "step", "max_step", "max_steps",
            "stabilisation", "dependent_constraints")  # fmt: skip


class Stepper(Steps):
    """A stepper: the state of a mechanism, which the caller advances to chosen times. `System.stepper` opens it.

    `advance(t, inputs=None)` integrates to exactly t, forwards or backwards, and continues with the step size and
    history of the steps before. `inputs` are numbers by name (or an array of all in order) and apply from then on. On
    failure it raises an EvaluationError whose `stop` is a StopReason, and keeps the last state reached, from which it
    can be advanced again, for example with other inputs. `save()` returns the complete state as bytes;
    `restore(saved)` restores it bit for bit. `advance` allocates no memory. Terminal events do not end an advance:
    `events` has the zero crossings of the last one.

    Steppers share no data; each may be used by one thread at a time. Pickling stores the arguments of its opening and
    the bytes of `save`.

    Attributes
    ----------
    t, x, v, y : float [s], (n,), (n,), (n_state,)
        The current state; y has the published meaning, so that runs can start from it
        (`simulate(..., start=(s.t, s.y))`).
    u : (n_inputs,)
        The current inputs; NaN for a signal.
    events : dict name -> (k,) [s]
        The times at which each event crossed zero in the last advance.
    nfev, nsteps, nrejected : int
        Right-hand sides, accepted and rejected steps so far.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> stepper = em.build(model).stepper(x0={"theta": 1.0}, rtol=1e-9)
    >>> stepper.advance(0.5)
    >>> saved = stepper.save()
    >>> stepper.advance(1.0)
    >>> stepper.x.round(6)
    array([-0.980067])
    >>> stepper.restore(saved)
    >>> stepper.t
    0.5
    """

    @property
    def energy(self) -> float:
        """T + V [J]."""
        T2, T1, T0, V = self._energies()
        return T2 + T1 + T0 + V

    @property
    def jacobi_integral(self) -> float:
        """T2 - T0 + V [J]."""
        T2, _, T0, V = self._energies()
        return T2 - T0 + V

    def _energies(self) -> list[float]:
        x, v = self.motion
        result = self.model.energy_rows(np.array([self.t]), x[None], v[None], self.prepared)
        numbers: list[float] = result[0].tolist()
        return numbers

    @property
    def acceleration(self) -> Vector:
        """(n,) d2x/dt2 with the current inputs."""
        return self._motion()[0][: self.model.n_coordinates]

    @property
    def multipliers(self) -> Vector:
        """(m,) multipliers lambda; the constraint force is -A^T lambda (7)."""
        return self._motion()[1]

    def _motion(self) -> tuple[Vector, Vector]:
        task = self.task
        result: tuple[Vector, Vector] = self.model.acceleration(
            self.t, *self.motion, self.prepared, self._inputs(), task.least_norm
        )
        return result

    @property
    def not_unique(self) -> tuple[int, ...]:
        """The constraint rows whose multipliers are not unique in this state (those of least norm are returned)."""
        result: tuple[int, ...] = self.model.redundant(self.t, self.motion[0], self.prepared)[1]
        return result

    @property
    def outputs(self) -> dict[str, float]:
        """Name of each output -> its value."""
        task, u, (x, v) = self.task, self._inputs(), self.motion
        rows = self.model.output_rows(np.array([self.t]), x[None], v[None], u[None], self.prepared, task.least_norm)
        return dict(zip(self.model.outputs, rows[0].tolist(), strict=True))

    def _inputs(self) -> Vector:
        current, signals = self.u, self.task.inputs.at(self.t)
        return np.where(np.isnan(current), signals, current)

    def __repr__(self) -> str:
        return f"<Stepper of {self.model.name} at t = {self.t:.9g}>"


def stepper(
    system: CompiledSystem,
    *positional: Never,
    t: float | None = None,
    x0: Mapping[Any, float] | ArrayLike | None = None,
    v0: Mapping[Any, float] | ArrayLike | None = None,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | None = None,
    start: Any = None,
    rtol: float = 1e-6,
    atol: float | Mapping[Any, float] | ArrayLike = 1e-9,
    method: str = "dop853",
    step: float | None = None,
    max_step: float = np.inf,
    max_steps: int = 1_000_000,
    stabilisation: str = "project",
    dependent_constraints: str = "auto",
    **misspelt: Any,
) -> Stepper:
    """Open a stepper of this mechanism at time t, which `advance` integrates further.

    Parameters
    ----------
    t, x0, v0, parameters
        The start, as in `simulate`; t is 0 by default.
    inputs
        As in `simulate`; inputs that are numbers can be changed at every `advance`.
    start
        In place of t, x0 and v0: a Solution, or a pair (t, y), to continue from.
    method
        A method of `simulate`, or one of fixed step: "rk4" (order 4; 4 right-hand sides per step), "midpoint" (order 2;
        2). These do the same work in every step, without an error estimate.
    step
        [s] for a method of fixed step: an advance has equal steps no longer than this.
    rtol, atol, max_step, stabilisation, dependent_constraints
        As in `simulate`; max_steps is for one advance.

    Raises
    ------
    ModelError
        An unknown name or option, a value out of range, or an inconsistent start.
    """
    if positional:
        raise OptionError("stepper: everything is given by keyword, as t=0.0, x0={...}")
    if misspelt:
        raise OptionError(f"stepper: {unknown('option', misspelt, _OPTIONS)}")
    named = method_named(method)
    first = fixed_step(named, step)
    relative, absolute = options.tolerances(system.compiled, rtol, atol)
    _, longest, most = options.step_limits(None, max_step, max_steps, np.inf)
    prepared, inputs = system.prepare_both(parameters, inputs)
    begin, y = _start(system, prepared, t, x0, v0, start, relative, absolute)
    task = Task(
        system.compiled, prepared, system.bind(inputs), begin, np.inf, y, relative, absolute, None, False, first,
        longest, most, choice(stabilisation, STABILISATIONS, "stabilisation"),
        options.least_norm_of(dependent_constraints),
    )  # fmt: skip
    if task.inputs.sampled:
        raise ModelError(f"{system.name}: a stepper takes no Sampled input: call the controller between two advances")
    return Stepper(task, METHOD_NUMBERS[named])


def method_named(argument: str) -> str:
    """Return a method of steppers by its name, in upper or lower case.

    Raises
    ------
    ModelError
        The name is unknown, or "auto", which examines a whole run.
    """
    if isinstance(argument, str) and argument.lower() == "auto":
        raise ModelError(
            "method 'auto' chooses for a whole run, and a stepper is asked for its end at each step: give it 'dop853' "
            "or 'ra15', or 'radau9' where the motion is stiff (System.simulate with method='auto' says which)"
        )
    name: str = method_of(argument, {name: name for name in STEPPED})
    return name


def fixed_step(method: str, step: float | None) -> float:
    """Return the step [s] of a method of fixed step; 0 for other methods."""
    if method not in FIXED:
        if step is not None:
            raise ModelError(f"step is for methods of fixed step ({', '.join(FIXED)}); {method} chooses its own")
        return 0.0
    if step is None:
        raise ModelError(f"method {method!r} needs step=..., the length of its steps in seconds")
    length = real(step, "step")
    if not 0 < length < np.inf:
        raise ModelError(f"step is {length}, but must be above 0 and finite")
    return length


def _start(
    system: CompiledSystem, prepared: Any, t: Any, x0: Any, v0: Any, start: Any, rtol: float, atol: Vector
) -> tuple[float, Vector]:
    """Return the time and the state (n_state,) to start from."""
    if start is not None:
        if not (t is None and x0 is None and v0 is None):
            raise ModelError("stepper: start= says all of t, x0 and v0; give either it or them")
        return restart_state(system.compiled, prepared, start, rtol, atol)
    begin = 0.0 if t is None else number(t, "t")
    x, v = system.begin(x0, v0, begin, prepared)
    return begin, start_state(system.compiled, prepared, begin, x, v, rtol, atol)
