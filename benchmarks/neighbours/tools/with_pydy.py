"""Gives Lagrange's method with its constraint to PyDy's System, which says what it takes."""

from collections.abc import Iterator

import sympy as sp
from four_bar import A, B, C, D, Trial
from pydy.system import System
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols


def trials() -> Iterator[Trial]:
    """Give Lagrange's method with its constraint to PyDy's System, which says what it takes."""
    q = dynamicsymbols("q1:4")
    both = A * B**2 / 2
    inertia = (A**3 / 3 + B * A**2, B**3 / 3, C**3 / 3)
    kinetic = sum(one * x.diff() ** 2 for one, x in zip(inertia, q, strict=True)) / 2
    kinetic += both * sp.cos(q[0] - q[1]) * q[0].diff() * q[1].diff()
    loop = [
        A * sp.cos(q[0]) + B * sp.cos(q[1]) - C * sp.cos(q[2]) - D,
        A * sp.sin(q[0]) + B * sp.sin(q[1]) - C * sp.sin(q[2]),
    ]
    method = LagrangesMethod(kinetic, q, hol_coneqs=loop)
    method.form_lagranges_equations()
    try:
        System(method)
    except (TypeError, ValueError, AttributeError, NotImplementedError) as error:
        print(f"  System(LagrangesMethod): {type(error).__name__}: {str(error).splitlines()[0][:90]}")
    yield from ()
