"""Findings of a report that nobody measured: curves by formulas, for tests of what is chosen, drawn and printed."""

from types import SimpleNamespace

import numpy as np

from eigenmotion.reference.motion import Reference
from eigenmotion.report import Findings, Measurement, ReportOptions
from eigenmotion.report.recommend import curves, recommend

OURS = [("eigenmotion", f, m) for f in ("eigenfactor", "cholesky", "lagrange", "inverse")
        for m in ("rk34", "dopri5", "dop853", "ra15")]  # fmt: skip
IMPLICIT = [("eigenmotion", "lagrange", "radau5"), ("eigenmotion", "lagrange", "radau9")]
PEERS = [("SciPy", "lambdified", "DOP853"), ("SciPy", "lambdified", "LSODA"), ("SciPy", "lambdified", "Radau"),
         ("heyoka.py", "written out", "Taylor"), ("CVODES", "written out", "Adams"),
         ("CVODES", "written out", "BDF")]  # fmt: skip
ALL = (*OURS, *IMPLICIT, *PEERS)


def measurement(solver: tuple[str, str, str], tolerance: float, error: float, seconds: float) -> Measurement:
    family, formulation, method = solver
    label = f"{formulation if family == 'eigenmotion' else family} {method}"
    steps = max(1, round(1e6 * seconds))
    return Measurement(family, formulation, method, label, tolerance, error / 2, error, error, error, seconds,
                       0.9 * seconds, 1.2 * seconds, 9, 10 * steps, steps, steps // 9)  # fmt: skip


def findings(seed: int = 0, name: str = "made_up", solvers=ALL, spread: float = 5.0, units=(), error=1e-8) -> Findings:
    """Return random curves that take from 10 us to some 10^spread times as long."""
    random = np.random.default_rng(seed)
    made = []
    for solver in solvers:
        cost, growth, worst = 10 ** random.uniform(-5, spread - 6), random.uniform(0.05, 0.3), random.uniform(-3, 1)
        for k in range(3, 13):
            size = max(10.0 ** (worst - k), 10 ** random.uniform(-15, -14))
            made.append(measurement(solver, 10.0**-k, size, cost * 10 ** (growth * k) * random.uniform(0.9, 1.1)))
    lines = curves(made)
    model = SimpleNamespace(name=name, units=units)
    system = SimpleNamespace(
        n=2, m=0, h=0, coordinates=("theta", "r"), states=(), formulation="lagrange", n_state=4, left_out=()
    )
    built = SimpleNamespace(formulation="lagrange", system=system, generation=1.0, compilation=1.0, refused="")
    subject = SimpleNamespace(model=model, derivation=0.1, built=(built,), systems=(system,))
    known = Reference(np.zeros(2), np.zeros((2, 2)), np.zeros((2, 2)), np.full(2, 1e-16), "Made up.")
    ask = ReportOptions(error=error, settings={"parameters": {"k": 2.0}, "v0": {"theta": 1.0}})
    return Findings(subject, ask, np.zeros(4), known, tuple(made), (), (), lines, recommend(lines, error))
