"""Runs the equations through SymJIT, which compiles without a compiler; SciPy integrates."""

from collections.abc import Iterator
from time import perf_counter

import numpy as np
import sympy as sp
from explicit import explicit
from four_bar import SPAN, Trial, start
from scipy.integrate import solve_ivp
from symjit import compile_func

TOLERANCE = 1e-9


def trials() -> Iterator[Trial]:
    """Compile the accelerations by SymJIT, without a compiler; integrate by SciPy's DOP853."""
    y = list(sp.symbols("y0:6"))
    words = explicit(y)
    before = perf_counter()
    function = compile_func(y, words)
    made = perf_counter() - before
    before = perf_counter()
    end = solve_ivp(
        lambda _, now: np.concatenate([now[3:], np.ravel(function(*now))]),
        (0.0, SPAN), np.concatenate(start()), method="DOP853", rtol=TOLERANCE, atol=TOLERANCE,
    ).y[:, -1]  # fmt: skip
    yield Trial(f"DOP853 of SciPy, {TOLERANCE:g}, compiled in {made:.2g} s", end[:3], end[3:], perf_counter() - before)
