"""Mechanisms written by hand in C, compiled with `em_stepper.h` and run through ctypes."""

import ctypes as ct
import functools
import itertools
import math
import os
import shlex
import shutil
import subprocess
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline, PPoly
from scipy.special import ellipj, ellipk

from eigenmotion.arguments.methods import METHODS as TABLE
from eigenmotion.building.toolchain import FLAGS

from .mechanism_in_c import RUNGE_KUTTA as RUNGE_KUTTA
from .mechanism_in_c import Mechanism as Mechanism
from .structures import INCLUDE as INCLUDE
from .structures import NUMBERS, POLL
from .structures import Rows as Rows
from .structures import Run as Run
from .structures import Signal as Signal
from .structures import Tableau as Tableau

Array = NDArray[np.float64]
Build = Callable[[Mechanism], "Compiled"]

STRICT = "-std=c11 -Wall -Wextra -Wpedantic -Werror".split()
FAST = f"-march=native -ffp-contract=fast -fno-math-errno -fno-trapping-math {os.environ.get(FLAGS, '-O1')}".split()
COMPILER = shlex.split(os.environ.get("CC", "cc"))

METHODS = tuple(TABLE)
EXPLICIT = tuple(name for name, method in TABLE.items() if not method.implicit)
FINISHED, TERMINAL_EVENT, INTERRUPTED = NUMBERS["EM_FINISHED"], NUMBERS["EM_TERMINAL_EVENT"], NUMBERS["EM_INTERRUPTED"]
STEP_SIZE_UNDERFLOW, TOO_MANY_STEPS = NUMBERS["EM_STEP_SIZE_UNDERFLOW"], NUMBERS["EM_TOO_MANY_STEPS"]
NON_FINITE_STATE, SINGULAR_MASS_MATRIX = NUMBERS["EM_NON_FINITE_STATE"], NUMBERS["EM_SINGULAR_MASS_MATRIX"]
POSITION_NOT_REACHED, OUT_OF_MEMORY = NUMBERS["EM_POSITION_NOT_REACHED"], NUMBERS["EM_OUT_OF_MEMORY"]
CONSTANT, HOLD, LINEAR, CUBIC = (NUMBERS[f"EM_{name}"] for name in ("CONSTANT", "HOLD", "LINEAR", "CUBIC"))


@dataclass(frozen=True, slots=True)
class Compiled:
    mechanism: Mechanism
    library: Any

    @property
    def n_state(self) -> int:
        return 2 * self.mechanism.n + self.mechanism.n_c + self.mechanism.n_s


@dataclass(slots=True)
class Result:
    """A finished run. t (nt,), y (n_state, nt); `kept` holds what the C side points to."""

    run: Run
    compiled: Compiled
    kept: tuple[object, ...]
    t: Array = field(init=False)
    y: Array = field(init=False)

    def __post_init__(self) -> None:
        self.t, self.y = self.table(self.run.rows)

    def __del__(self) -> None:
        self.compiled.library.release(ct.byref(self.run))
        self.compiled.library.release(ct.byref(self.run))  # twice is harmless

    @property
    def status(self) -> int:
        return int(self.run.fault.status)

    def table(self, rows: Rows) -> tuple[Array, Array]:
        n_state = self.compiled.n_state
        if rows.count == 0:
            return np.empty(0), np.empty((n_state, 0))
        t = np.ctypeslib.as_array(rows.t, (rows.count,)).copy()
        return t, np.ctypeslib.as_array(rows.y, (rows.count, n_state)).T.copy()

    def event_times(self, i: int) -> Array:
        return self.table(self.run.events[i])[0]

    def steps(self) -> Iterator[tuple[int, float, float]]:
        for i in range(self.run.n_dense):
            yield i, self.run.dense_steps[i].t, self.run.dense_steps[i].h

    def at(self, step: int, t: float) -> Array:
        y = np.empty(self.compiled.n_state)
        assert self.compiled.library.interpolate(ct.byref(self.run), step, t, y.ctypes.data_as(ct.c_void_p)) == 0
        return y


def compiler_command(source: Path, target: Path, *flags: str) -> list[str]:
    return [*COMPILER, *STRICT, *flags, f"-I{INCLUDE}", str(source), "-o", str(target), "-lm"]


def builder(folder: Path) -> Build:
    """A function that compiles mechanisms, each once, into a folder."""
    if shutil.which(COMPILER[0]) is None:
        pytest.skip(f"no C compiler {COMPILER[0]!r}")
    serial = itertools.count()

    @functools.cache
    def compiled(mechanism: Mechanism) -> Compiled:
        stem = f"mechanism{next(serial)}"
        source, target = folder / f"{stem}.c", folder / f"{stem}.so"
        source.write_text(mechanism.text())
        done = subprocess.run(
            compiler_command(source, target, *FAST, "-shared", "-fPIC"), capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        library = ct.CDLL(str(target))
        library.interpolate.argtypes = (ct.c_void_p, ct.c_size_t, ct.c_double, ct.c_void_p)
        library.tableau.restype = ct.POINTER(Tableau)
        return Compiled(mechanism, library)

    return compiled


def numbers(values: ArrayLike, dtype: type = np.float64) -> Any:
    return np.ascontiguousarray(values, dtype=dtype)


def signal(kind: int, times: ArrayLike, values: ArrayLike) -> tuple[Signal, object]:
    t, u = numbers(times), numbers(values)
    return Signal(kind, t.size, t.ctypes.data, u.ctypes.data), (t, u)


def simulate(
    compiled: Compiled,
    y0: ArrayLike,
    t_span: tuple[float, float],
    method: str = "dop853",
    *,
    rtol: float = 1e-9,
    atol: ArrayLike = 1e-9,
    t_eval: ArrayLike | None = None,
    inputs: Sequence[tuple[Signal, object]] = (),
    direction: Sequence[int] = (),
    terminal: Sequence[int] = (),
    poll: Callable[[], int] | None = None,
    **options: float,
) -> Result:
    n, n_events = compiled.mechanism.n, compiled.mechanism.n_events
    start, tolerance = numbers(y0), numbers(np.broadcast_to(numbers(atol), n))
    signals = (Signal * max(1, len(inputs)))(*(one for one, _ in inputs))
    directions, terminals = numbers(direction or [0] * n_events, np.intc), numbers(terminal or [0] * n_events, np.intc)
    callback = POLL(lambda _: poll()) if poll else POLL()
    run = Run(t_start=t_span[0], t_end=t_span[1], method=TABLE[method].number, rtol=rtol, max_step=math.inf)
    run.max_steps, run.stabilise = 1_000_000, 1
    run.y_start, run.atol = start.ctypes.data, tolerance.ctypes.data
    run.inputs = ct.addressof(signals)
    run.event_direction, run.event_terminal = directions.ctypes.data, terminals.ctypes.data
    run.poll = callback
    times = None if t_eval is None else numbers(t_eval)
    if times is not None:
        run.t_eval, run.n_t_eval = times.ctypes.data, times.size
    for name, value in options.items():
        setattr(run, name, value)
    status = compiled.library.simulate(ct.byref(run))
    kept = (start, tolerance, signals, inputs, directions, terminals, callback, times)
    result = Result(run, compiled, kept)
    assert status == result.status
    return result


PENDULUM = Mechanism(rhs="dy[0] = y[1]; dy[1] = -sin(y[0]);")
FREE_FALL = Mechanism(rhs="dy[0] = y[1]; dy[1] = -1.0;")
DRIVEN = Mechanism(rhs="dy[0] = y[1]; dy[1] = u[0];", n_inputs=1)


def pendulum_angle(t: ArrayLike, amplitude: float) -> Array:
    """x(t) of x'' = -sin x from rest at the amplitude: sin(x / 2) = k cd(t, k), k = sin(amplitude / 2)."""
    k = math.sin(amplitude / 2)
    sn, _, _, _ = ellipj(np.asarray(t) + ellipk(k**2), k**2)
    angle: Array = 2 * np.arcsin(k * sn)
    return angle


CIRCLE = Mechanism(
    n=2,
    rhs="for (int k = 0; k < 2; ++k) dy[k] = y[2 + k], dy[2 + k] = -y[k];",
    settle="""
    if (!(flags & EM_STABILISE)) return 0;
    const double r = hypot(y[0], y[1]);
    y[0] /= r, y[1] /= r;
    const double radial = y[0] * y[2] + y[1] * y[3];
    y[2] -= radial * y[0], y[3] -= radial * y[1];
    return 1;""",
    settles=1,
)

TWO_MODES = Mechanism(
    rhs="dy[0] = y[1] / (mode ? 2.0 : 1.0); dy[1] = -sin(y[0]) * (mode ? 2.0 : 1.0);",
    settle="""
    if (flags & EM_KEEP_MODE) return 0;
    const int wanted = y[0] < 0.0;
    if (wanted == *mode) return 0;
    y[1] *= wanted ? 2.0 : 0.5;
    *mode = wanted; /* which says that y changed, too */
    return 0;""",
    settles=1,
    events="g[0] = v[0];",
    n_events=1,
)


def extended(inner: PPoly, span: tuple[float, float]) -> PPoly:
    """The end values held outside the samples."""
    before, after = float(inner(inner.x[0])), float(inner(inner.x[-1]))
    degree = inner.c.shape[0] - 1
    ends = np.zeros((degree + 1, 2))
    ends[-1] = before, after
    c = np.concatenate([ends[:, :1], inner.c, ends[:, 1:]], axis=1)
    return PPoly(c, np.concatenate([[min(span) - 1], inner.x, [max(span) + 1]]))


SAMPLES = np.array([0.3, 0.7, 0.8, 1.9, 2.4])
VALUES = np.array([1.0, -2.0, 0.5, 3.0, -1.0])


def sampled(kind: int, span: tuple[float, float]) -> tuple[tuple[Signal, object], PPoly]:
    if kind == HOLD:
        inner = PPoly(np.vstack([VALUES[:-1]]), SAMPLES)
        exact = extended(inner, span)
        exact.c[-1, -1] = VALUES[-1]
        return signal(HOLD, SAMPLES, VALUES), exact
    if kind == LINEAR:
        inner = PPoly(np.vstack([np.diff(VALUES) / np.diff(SAMPLES), VALUES[:-1]]), SAMPLES)
        return signal(LINEAR, SAMPLES, VALUES), extended(inner, span)
    spline = CubicSpline(SAMPLES, VALUES)
    return signal(CUBIC, SAMPLES, spline.c.T), extended(PPoly(spline.c, spline.x), span)
