"""Integration methods: the table from which all others are derived.

All methods are compiled. em_methods.h implements them under the same names and numbers.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from ..codegen.model.normalise import ModelError
from .options import choice


@dataclass(frozen=True, slots=True)
class Method:
    """An integration method.

    name : as users write it, in upper or lower case
    order : p: the error of a run is proportional to h^p for steps h
    number : em_method of em_run.h
    implicit : solves equations in every step, with the Jacobian of the motion (x, v): for stiff scenes
    iterates : solves its stages by iteration, which converges only to the tolerances
    dense_calls : whether dense output may take right-hand sides that the step itself does not
    """

    name: str
    order: int
    number: int
    implicit: bool = False
    iterates: bool = False
    dense_calls: bool = False


def _table(*methods: Method) -> Mapping[str, Method]:
    return MappingProxyType({method.name: method for method in methods})


METHODS = _table(
    Method("rk34", order=4, number=0, dense_calls=True),
    Method("dopri5", order=5, number=1),
    Method("dop853", order=8, number=2, dense_calls=True),
    Method("ra15", order=15, number=3, iterates=True),
    Method("radau5", order=5, number=6, implicit=True),
    Method("radau9", order=9, number=7, implicit=True),
)
AUTO = "auto"
"""The name with which users leave the choice to method_selection.py."""
FIXED = _table(Method("rk4", order=4, number=4), Method("midpoint", order=2, number=5))
"""Methods of fixed step, only for steppers: the caller chooses the step, and there is no error estimate."""
STEPPED = _table(*METHODS.values(), *FIXED.values())
"""All methods of steppers."""
IMPLICIT = _table(*(method for method in METHODS.values() if method.implicit))
_FOREIGN_SOLVERS = MappingProxyType({
    **{name: ("SciPy's", "radau9", f"{name!r}, jac=system.jacobian") for name in ("Radau", "BDF", "LSODA")},
    **dict.fromkeys(("CVODE", "CVODES"), ("SUNDIALS'", "radau9", "'BDF', jac=system.jacobian")),
    "RK45": ("SciPy's", "dopri5", "'RK45'"),
    "RK23": ("SciPy's", "rk34", "'RK23'"),
})  # fmt: skip
"""Solvers of other packages: the package, the compiled method that replaces each, and the call of the solver."""


def method_of(argument: object, known: Mapping[str, Any]) -> Any:
    """Return the method of a name, in upper or lower case.

    Raises
    ------
    ModelError
        The name is unknown: lists the known ones; for solvers of SciPy and SUNDIALS, names the compiled method.
    """
    solvers = [name for name in _FOREIGN_SOLVERS if isinstance(argument, str) and name.lower() == argument.lower()]
    if not solvers:
        return choice(argument, known, "method")
    whose, instead, called = _FOREIGN_SOLVERS[solvers[0]]
    raise ModelError(
        f"method {argument!r} is {whose}: the compiled one in its place is {instead!r}. Solvers of SciPy and SUNDIALS "
        "are served by System.rhs and System.jacobian, as in "
        f"scipy.integrate.solve_ivp(system.rhs, t_span, system.state(), method={called})"
    )


def checker_of(method: Method) -> Method:
    """Return the method of a second run for the error estimate: the one of highest order of the same kind.

    Methods that iterate are excluded: close to rounding their errors exceed those of their order.
    """
    direct = (m for m in METHODS.values() if m.implicit == method.implicit and not m.iterates)
    return max(direct, key=lambda m: m.order)
