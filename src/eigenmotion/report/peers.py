"""Peers: solvers of other packages on the same model (SciPy; heyoka.py and CasADi if they are installed)."""

import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from ..arguments.named_values import Vector
from ..codegen.model.symbolic.lagrange import Lagrange
from ..reference.lagrange_equations import double, explicit
from .solvers import MOST_STEPS, Attempt, Solver, Track, track_of

PEERS = "SciPy, heyoka.py, CasADi/CVODES"
"""All of them, in the order in which they are measured."""
DECADES = tuple(float(10.0**-k) for k in range(3, 13))
_SCIPY = ("DOP853", "LSODA", "Radau")
_TAYLOR_TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14)  # each needs a compilation of a second or two
_FUNCTIONS = (
    *("sin", "cos", "tan", "asin", "acos", "atan", "atan2"),
    *("sinh", "cosh", "tanh", "sqrt", "exp", "log"),
)
_LARGEST = 8  # the most coordinates for peers that compile written-out accelerations
LONGEST = 5.0  # [s] after which a run of SciPy is stopped
_CVODES: dict[str, dict[str, Any]] = {
    "Adams": {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"},
    "BDF": {},
}


@dataclass(frozen=True, slots=True)
class Start:
    """The start y = (x, v, z) at t = 0 with n coordinates, and the end time."""

    y: Vector
    n: int
    t_end: float


@dataclass(frozen=True, slots=True)
class Peers:
    """The solvers of peers that can be measured; for the others (name, reason)."""

    solvers: tuple[Solver, ...]
    absent: tuple[tuple[str, str], ...]


def peers(equations: Lagrange, start: Start) -> Peers:
    """Return the solvers of all peers."""
    solvers: list[Solver] = _scipy(equations, start)
    absent: list[tuple[str, str]] = []
    for module, name, make in (("heyoka", "heyoka.py", _heyoka), ("casadi", "CasADi/CVODES", _casadi)):
        reason = _obstacle(module, len(equations.x))
        try:
            solvers += [] if reason else make(equations, start)
        except Exception as error:  # whatever a peer raises for this model is a result
            reason = f"{type(error).__name__}: {error}".splitlines()[0]
        if reason:
            absent.append((name, reason))
    return Peers(tuple(solvers), tuple(absent))


def _obstacle(module: str, n: int) -> str:
    if find_spec(module) is None:
        return f"not installed (pip install {module})"
    return f"left out above {_LARGEST} coordinates: the written-out accelerations grow as n^3" if n > _LARGEST else ""


def _scipy(equations: Lagrange, start: Start) -> list[Solver]:
    rhs = double(equations)

    def attempt(method: str, tolerance: float) -> Attempt:
        def run(t_eval: Vector | None = None) -> Any:
            f = _limited(rhs, LONGEST)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # LSODA repeats its message there
                return solve_ivp(f, (0.0, start.t_end), start.y, method, t_eval, rtol=tolerance, atol=tolerance)

        return Attempt(run, lambda times, done: _scipy_track(run(times), done, start.n))

    def solver(method: str) -> Solver:
        return Solver("SciPy", "classical", method, DECADES, lambda tolerance: attempt(method, tolerance))

    return [solver(method) for method in _SCIPY]


def _limited(rhs: Callable[[float, Vector], Vector], longest: float) -> Callable[[float, Vector], Vector]:
    """Return the right-hand side with a time limit, since SciPy's solvers have none."""
    deadline = time.perf_counter() + longest

    def limited(t: float, y: Vector) -> Vector:
        if time.perf_counter() > deadline:
            raise TimeoutError(f"stopped after {longest:g} s")
        return rhs(t, y)

    return limited


def _scipy_track(at_rows: Any, at_steps: Any, n: int) -> Track:
    message = "" if at_rows.success else str(at_rows.message)
    return track_of(at_rows.y.T, n, nfev=at_steps.nfev, nsteps=len(at_steps.t) - 1, message=message)


def _heyoka(equations: Lagrange, start: Start) -> list[Solver]:
    """Return Taylor's method of heyoka.py, on accelerations written out by elimination."""
    import heyoka  # noqa: PLC0415, an optional package

    y = [heyoka.expression(f"y{k}") for k in range(len(start.y))]
    rates = explicit(equations, functions_of(heyoka), y, heyoka.time)
    # heyoka's equations are expressions, never bare numbers
    system = list(zip(y, [e + heyoka.expression(0.0) for e in rates], strict=True))

    def attempt(tolerance: float) -> Attempt:
        integrator = heyoka.taylor_adaptive(system, state=start.y.copy(), tol=tolerance)

        def restart() -> None:
            integrator.time = 0.0
            integrator.state[:] = start.y

        def run() -> Any:
            restart()
            return integrator.propagate_until(start.t_end, max_steps=MOST_STEPS)

        def track(times: Vector, done: Any) -> Track:
            restart()
            outcome, *_, rows = integrator.propagate_grid(times, max_steps=MOST_STEPS)
            finished = outcome == heyoka.taylor_outcome.time_limit
            return track_of(rows, start.n, nfev=None, nsteps=done[3], message="" if finished else str(outcome))

        return Attempt(run, track)

    return [Solver("heyoka.py", "written out", "Taylor", _TAYLOR_TOLERANCES, attempt)]


def _casadi(equations: Lagrange, start: Start) -> list[Solver]:
    """Return CVODES of SUNDIALS, on written-out accelerations with CasADi's exact Jacobian."""
    import casadi  # noqa: PLC0415, an optional package

    y, t = casadi.SX.sym("y", len(start.y)), casadi.SX.sym("t")
    rates = explicit(equations, functions_of(casadi), [y[k] for k in range(len(start.y))], t)
    problem = {"x": y, "t": t, "ode": casadi.vertcat(*rates)}

    def attempt(method: str, tolerance: float) -> Attempt:
        options: dict[str, Any] = {"abstol": tolerance, "reltol": tolerance, **_CVODES[method]}
        options |= {"max_num_steps": MOST_STEPS, "disable_internal_warnings": True}
        to_end = casadi.integrator("to_end", "cvodes", problem, 0.0, [start.t_end], options)

        def track(times: Vector, _: Any) -> Track:
            stats = to_end.stats()
            rows = casadi.integrator("rows", "cvodes", problem, 0.0, times.tolist(), options)(x0=start.y)["xf"]
            return track_of(np.array(rows).T, start.n, nfev=stats["nfevals"], nsteps=stats["nsteps"])

        return Attempt(lambda: _in_brief(to_end, start.y), track)

    def solver(method: str) -> Solver:
        return Solver("CVODES", "written out", method, DECADES, lambda tolerance: attempt(method, tolerance))

    return [solver(method) for method in _CVODES]


def _in_brief(integrator: Callable[..., Any], y: Vector) -> Any:
    """Integrate; shorten CasADi's error message to its last part."""
    try:
        return integrator(x0=y)
    except RuntimeError as error:
        raise RuntimeError(str(error).splitlines()[-1].rpartition(": ")[2]) from error


def functions_of(module: Any) -> dict[str, Callable[..., Any]]:
    """Return SymPy's function names -> functions of an algebra module, as far as it has them."""
    return {name: getattr(module, name) for name in _FUNCTIONS if hasattr(module, name)}
