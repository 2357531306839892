"""Runs the equations in CasADi: IDAS, with accelerations and multipliers as algebraic variables."""

from collections.abc import Iterator
from time import perf_counter

import casadi as ca
import numpy as np
from four_bar import SPAN, Trial, start, system

TOLERANCE = 1e-9


def trials() -> Iterator[Trial]:
    """Solve the constraint as an index-1 DAE by IDAS, multipliers and accelerations as algebraic variables."""
    y, z = ca.SX.sym("y", 6), ca.SX.sym("z", 5)
    matrix, right = system([y[k] for k in range(3)], [y[k] for k in range(3, 6)], ca)
    rows = [sum(matrix[i][j] * z[j] for j in range(5)) - right[i] for i in range(5)]
    problem = {"x": y, "z": z, "ode": ca.vertcat(y[3:], z[:3]), "alg": ca.vertcat(*rows)}
    run = ca.integrator(
        "run", "idas", problem, 0.0, SPAN, {"reltol": TOLERANCE, "abstol": TOLERANCE, "max_num_steps": 10**6}
    )
    before = perf_counter()
    end = np.array(run(x0=np.concatenate(start()))["xf"]).ravel()
    yield Trial(f"IDAS on index 1, {TOLERANCE:g}", end[:3], end[3:], perf_counter() - before)
