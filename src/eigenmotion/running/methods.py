"""The methods there are: the one table that all others are made from.

What compiled ones do stands in em_methods.h, under the same names and numbers.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from types import MappingProxyType


@dataclass(frozen=True, slots=True)
class Method:
    """A way to integrate: compiled, or in Python.

    name : as users write it, in upper or lower case
    order : the power of the step size that the error of a run falls with; None where it varies from step to step
    implicit : solves equations in every step, with the Jacobian of the motion (x, v): for stiff scenes
    number : of a compiled one, em_method of em_run.h; else None
    solver : of the others, "module:class" of what makes the steps, as `scipy.integrate.OdeSolver` does
    needs : the package without which there is none, "" where it comes with ours
    extra : what installs that: pip install 'eigenmotion[extra]'
    begins : of those whose steps are made in Python, the method of the first ones of a leg after events that act, or ""
    iterates : of a compiled one, whether its rates are found by iteration, which ends at the tolerances and no sooner
    """

    name: str
    order: int | None
    implicit: bool = False
    number: int | None = None
    solver: str = ""
    needs: str = ""
    extra: str = ""
    begins: str = ""
    iterates: bool = False

    @property
    def is_compiled(self) -> bool:
        """Whether all of a run is compiled code."""
        return self.number is not None

    @property
    def is_installed(self) -> bool:
        """Whether what it needs is there."""
        return not self.needs or find_spec(self.needs) is not None


def _table(*methods: Method) -> Mapping[str, Method]:
    return MappingProxyType({method.name: method for method in methods})


METHODS = _table(
    Method("rk34", order=4, number=0),
    Method("dopri5", order=5, number=1),
    Method("dop853", order=8, number=2),
    Method("ra15", order=15, number=3, iterates=True),
    Method("radau5", order=5, implicit=True, number=6),
    Method("radau9", order=9, implicit=True, number=7),
    Method("Radau", order=5, implicit=True, solver="scipy.integrate:Radau", begins="Radau"),
    Method("BDF", order=None, implicit=True, solver="scipy.integrate:BDF", begins="Radau"),
    Method("LSODA", order=None, implicit=True, solver="scipy.integrate:LSODA", begins="Radau"),
    Method("CVODE", order=None, implicit=True, solver="eigenmotion.running.sundials:Cvode",
           needs="sksundae", extra="stiff", begins="Radau"),
)  # fmt: skip
AT_ONCE = ("dop853", "ra15")
"""Those that every compiled model has at once, for a run may take them by itself; others are compiled as asked for."""
AUTO = "auto"
"""The name by which users leave the choice to choosing.py."""
COMPILED = _table(*(method for method in METHODS.values() if method.is_compiled))
FIXED = _table(Method("rk4", order=4, number=4), Method("midpoint", order=2, number=5))
"""Of steppers alone: their steps are as long as told, all alike, and nothing says how large their error is."""
STEPPED = _table(*COMPILED.values(), *FIXED.values())
"""All that steppers have."""
IMPLICIT = _table(*(method for method in METHODS.values() if method.implicit))


def checker_of(method: Method) -> Method:
    """Return the method that checks runs of another: of its kind the one of the highest order.

    None that iterates: near rounding its errors are larger than its order says.
    """
    direct = (m for m in METHODS.values() if m.implicit == method.implicit and not m.iterates)
    return max(direct, key=lambda m: m.order or 0)
