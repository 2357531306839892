"""Benchmark of stiff scenes: time to a given error of the compiled stiff methods and of CasADi's CVODES.

The time is that of whole calls. The error is the largest of x at 201 rows, relative to 1 + |x|, compared with
collocation in extended precision on independently derived equations (report/measure.py). CVODES runs in C with CasADi's
exact Jacobian, and only returns the end state. Then the number of steps with 1,000 samples of a torque, interpolated
linearly, over that with the spline through them; and the time of "auto" over that of dop853 on a scene that is not
stiff.
"""

from __future__ import annotations

from functools import partial
from time import thread_time

import numpy as np
from common.timing import interleaved
from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Signal, build
from eigenmotion.reference.lagrange_equations import classical
from eigenmotion.reference.motion import reference
from eigenmotion.report.measure import Budget, Judge, measure
from eigenmotion.report.peers import Start, peers
from eigenmotion.report.recommend import curves
from eigenmotion.report.solvers import IMPLICIT, Problem, Solver, implicit_solvers
from eigenmotion.stability.models.smooth import elastic_link

TARGETS = (1e-4, 1e-6, 1e-8, 1e-10)


def governor() -> Model:
    """Return a flyball governor: two balls on arms; a link of stiffness k and damping d holds the sleeve.

    The engine's torque decreases as the sleeve rises.
    """
    phi, theta, z = dynamicsymbols("phi theta z")
    m, M, J, g, l, k, d, c, tau, kappa = symbols("m M J g l k d c tau kappa", positive=True)
    stretch = z - 2 * l * cos(theta)
    rate = z.diff() + 2 * l * sin(theta) * theta.diff()
    balls = m * l**2 * (theta.diff() ** 2 + sin(theta) ** 2 * phi.diff() ** 2)
    return Model(
        name="governor", coordinates=[phi, theta, z],
        kinetic_energy=balls + Rational(1, 2) * (J * phi.diff() ** 2 + M * z.diff() ** 2),
        potential_energy=-2 * m * g * l * cos(theta) - M * g * z + Rational(1, 2) * k * stretch**2,
        forces={phi: tau - c * phi.diff() - kappa * (2 * l - z), theta: -2 * d * l * sin(theta) * rate, z: -d * rate},
        parameters={m: 1.0, M: 2.0, J: 0.1, g: 9.81, l: 0.3, k: 1e7, d: 1e4, c: 0.2, tau: 4.0, kappa: 15.0},
        initial={theta: 0.6, z: 0.6 * cos(0.6), phi.diff(): 8.0},
    )  # fmt: skip


def relaxation() -> Model:
    """Return van der Pol's oscillator, a mass on a spring with a damping that changes its sign, mu = 1000."""
    x = dynamicsymbols("x")
    mu = symbols("mu", positive=True)
    return Model(
        name="relaxation", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
        forces={x: mu * (1 - x**2) * x.diff()}, parameters={mu: 1000.0}, initial={x: 2.0},
    )  # fmt: skip


def driven() -> Model:
    """Return a pendulum on a stiff, damped spring, driven by a torque."""
    theta, r, u = dynamicsymbols("theta r u")
    m, k, d, g, L = symbols("m k d g L", positive=True)
    return Model(
        name="driven_link", coordinates=[theta, r],
        kinetic_energy=Rational(1, 2) * m * (r.diff() ** 2 + r**2 * theta.diff() ** 2),
        potential_energy=Rational(1, 2) * k * (r - L) ** 2 - m * g * r * cos(theta),
        forces={r: -d * r.diff(), theta: u}, inputs={u: 0.0},
        parameters={m: 1.0, k: 1e10, d: 1e6, g: 9.81, L: 1.0}, initial={theta: 1.0, r: 1.0},
    )  # fmt: skip


SCENES = (
    ("link, k = 1e10, d = 1e6", elastic_link, {"parameters": {"k": 1e10, "d": 1e6}, "x0": {"q": 0.01}}, 1.0),
    ("flyball governor", governor, {}, 4.0),
    ("van der Pol, mu = 1000", relaxation, {}, 2000.0),
)


def solvers_of(model: Model, problem: Problem, values: dict[str, float]) -> tuple[list[Solver], Judge]:
    """Return our stiff methods and CVODES, and the judge of their errors."""
    system = build(model, formulation="lagrange")
    equations, probe = classical(model).with_values(values), problem.simulate(system, "radau9", 1e-9)
    rows = np.concatenate([probe.x, probe.v]).T
    known = reference(equations, rows[0], problem.t_end, along=(probe.t, rows))
    others = peers(equations, Start(rows[0], system.n, problem.t_end)).solvers
    theirs = [solver for solver in others if "CVODES" in solver.label]
    return [*implicit_solvers([system], problem), *theirs], Judge(known, system, values)


def print_times() -> None:
    """Print the time of each solver to each error, and its ratio to that of CVODES BDF."""
    print(f"{'time to an error of':<44}" + "".join(f"{target:>12.0e}" for target in TARGETS))
    for title, model, options, t_end in SCENES:
        solvers, judge = solvers_of(model(), Problem(t_end, options), options.get("parameters", {}))
        by_label = {c.label: c for c in curves(measure(solvers, judge, Budget(), lambda *_: None))}
        base = next((curve for label, curve in by_label.items() if label.endswith("BDF")), None)
        for label, curve in by_label.items():
            seconds = [(curve.seconds_at(target), base and base.seconds_at(target)) for target in TARGETS]
            cells = [f"{1e3 * s:.3g} ms" if s else "-" for s, _ in seconds]
            ratios = [f"{s / b:.2g}" if s and b else "-" for s, b in seconds]
            print(f"{title:<26}{label:<18}" + "".join(f"{cell:>12}" for cell in cells))
            print(f"{'':<26}{'over CVODES BDF':<18}" + "".join(f"{ratio:>12}" for ratio in ratios), flush=True)


def print_inputs() -> None:
    """Print the number of steps with a sampled torque over that with the spline through its samples."""
    system, times = build(driven(), formulation="lagrange"), np.linspace(0.0, 10.0, 1000)
    torque = 3 * np.sin(2 * times) + np.cos(5 * times)
    print("\nsteps across 1,000 linear samples over those of the spline through them")
    for method in IMPLICIT:
        for rtol in (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8):
            steps = {kind: system.simulate((0.0, 10.0), method=method, rtol=rtol, atol=rtol,
                                           inputs={"u": Signal(times, torque, kind)}).nsteps
                     for kind in ("linear", "cubic")}  # fmt: skip
            print(f"{method:<10}{rtol:<10.0e}{steps['linear']:>6} / {steps['cubic']:<6}"
                  f"{steps['linear'] / steps['cubic']:>8.2f}")  # fmt: skip


def print_choice() -> None:
    """Print the cost of the stiffness test for a run that is not stiff."""
    system = build(relaxation(), formulation="lagrange")
    options = {"parameters": {"mu": 0.1}, "rtol": 1e-4}
    calls = {method: partial(system.simulate, (0.0, 5.0), method=method, **options) for method in ("auto", "dop853")}
    seconds = interleaved(calls, 400, thread_time)
    print(f"\n'auto' over dop853, a call of {1e6 * np.median(seconds['dop853']):.0f} us: "
          f"{np.median(seconds['auto']) / np.median(seconds['dop853']):.2f}")  # fmt: skip


if __name__ == "__main__":
    print_times()
    print_inputs()
    print_choice()
