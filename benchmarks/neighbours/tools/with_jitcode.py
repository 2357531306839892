"""Runs the equations in JiTCODE: accelerations by SymPy, compiled, by its dop853."""

from collections.abc import Iterator
from time import perf_counter

import numpy as np
import symengine
import sympy as sp
from explicit import explicit
from four_bar import SPAN, Trial, start
from jitcode import jitcode, y

TOLERANCE = 1e-9


def trials() -> Iterator[Trial]:
    """Solve for the accelerations by SymPy, compile them, and integrate by its dop853."""
    names = sp.symbols("y0:6")
    words = [symengine.sympify(one).subs({name: y(k) for k, name in enumerate(names)}) for one in explicit(list(names))]
    before = perf_counter()
    ode = jitcode([*(y(k) for k in range(3, 6)), *words], verbose=False)
    ode.generate_f_C(simplify=False)  # which it does by default, and takes minutes for these
    ode.set_integrator("dop853", rtol=TOLERANCE, atol=TOLERANCE)
    ode.set_initial_value(np.concatenate(start()), 0.0)
    made = perf_counter() - before
    before = perf_counter()
    end = np.array(ode.integrate(SPAN))
    yield Trial(f"dop853, {TOLERANCE:g}, compiled in {made:.1f} s", end[:3], end[3:], perf_counter() - before)
