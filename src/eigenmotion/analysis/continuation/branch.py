"""Branch: equilibria or cycles along a parameter, with the bifurcations on it."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from ...presentation.notebook import table
from ...presentation.units import on_axis, time_unit, unit_of
from .curve import Place
from .cycle_curve import CycleCurve
from .equilibrium_curve import EquilibriumCurve
from .picture import Line, drawn


class Origin(NamedTuple):
    """The branch of a point: its system, curve, parameter, and the point."""

    system: CompiledSystem
    curve: CycleCurve | EquilibriumCurve
    name: str
    place: Place


@dataclass(frozen=True)
class SpecialPoint:
    """A bifurcation on a branch.

    Attributes
    ----------
    kind : "fold": the branch turns back; "branch point": branches cross; "Hopf": an equilibrium begins to oscillate, or
        to stop; "doubling": a cycle of twice the period branches off; "torus": a second frequency appears; "flutter":
        two frequencies of an undamped equilibrium meet; "corner": two events in a period happen at once, and their
        order changes, or a friction begins or ceases to stick; "grazing": an event begins or ceases to happen, such as
        a contact that is only touched; "mode change": a contact of an equilibrium opens or closes, or a friction begins
        or ceases to slide
    parameter : its value, to about 1e-8 of the interval that was followed
    row : the index in the arrays of the branch
    x0, v0 : name -> value, the start for `simulate` or `find_cycle`; period : [s] of a cycle, 0 of an equilibrium
    values : (k,) complex multipliers of a cycle, eigenvalues of an equilibrium; at a corner those before it
    events : the names of those that meet at a corner, or of the one that grazes, or of the contact or friction
    origin : the branch's equations there, for `follow`

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/rotating_hoop.py")
    >>> branch = em.follow(em.find_equilibrium(system, [0], parameters={"Omega": 3}), "Omega", to=5)
    >>> branch.special[0].kind, round(branch.special[0].parameter, 9)
    ('branch point', 4.429446918)
    """

    kind: str
    parameter: float
    row: int
    x0: dict[str, float]
    v0: dict[str, float]
    period: float
    values: NDArray[np.complex128]
    origin: Origin = field(repr=False, compare=False)
    events: tuple[str, ...] = ()

    def __str__(self) -> str:
        names = f" of {' and '.join(self.events)}" if self.events else ""
        return f"{self.kind}{names} at {self.parameter:.9g}"


@dataclass(frozen=True)
class Branch:
    """Equilibria or cycles along a parameter, in order, with the bifurcations among them.

    Attributes
    ----------
    name : of the parameter; of_cycles : whether these are cycles
    success, message : whether the branch reaches its goal, or why it ends before
    parameter : (rows,) values
    x0, v0 : name -> (rows,) coordinates and states, and rates: the starts, for `simulate`
    period : (rows,) [s], 0 of equilibria
    values : (rows, k) complex multipliers of cycles, eigenvalues [1 / s] of equilibria
    stable : (rows,) True, False, or None if it is undecided
    highest, lowest : name -> (rows,) largest and least value of each coordinate and state along the motion
    special : the bifurcations, in order; each is a row, too
    free : name -> (rows,) values of the parameters and inputs that are free in the cycles, and of "t"

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/rotating_hoop.py")
    >>> branch = em.follow(em.find_equilibrium(system, [0], parameters={"Omega": 3}), "Omega", to=5)
    >>> print(branch)
    rotating_hoop: equilibria along Omega from 3 to 5: branch point at 4.42944692
    """

    system: CompiledSystem
    name: str
    of_cycles: bool
    success: bool
    message: str
    parameter: Vector
    x0: dict[str, Vector]
    v0: dict[str, Vector]
    period: Vector
    values: NDArray[np.complex128]
    stable: tuple[bool | None, ...]
    highest: dict[str, Vector]
    lowest: dict[str, Vector]
    special: tuple[SpecialPoint, ...]
    free: dict[str, Vector] = field(default_factory=dict)

    def plot(self, *others: "Branch", of: str | None = None) -> Any:
        """Return a picture of the branch, and of others in the same axes: what is stable solid, else dashed.

        Parameters
        ----------
        others
            Branches along the same parameter, such as the cycles that begin where an equilibrium ends to be stable.
        of
            A coordinate or a state, whose largest and least values along the motion are drawn, or "period". None: the
            coordinate that changes most.

        Returns
        -------
        matplotlib.figure.Figure

        Raises
        ------
        ModelError
            An unknown name, another parameter, or matplotlib is missing.

        Examples
        --------
        >>> import eigenmotion as em
        >>> system = em.build("models/rotating_hoop.py")
        >>> branch = em.follow(em.find_equilibrium(system, [0], parameters={"Omega": 3}), "Omega", to=5)
        >>> branch.plot(of="theta").axes[0].get_xlabel()
        'Omega'
        """
        if other := [one.name for one in others if one.name != self.name]:
            raise ModelError(f"{self.system.name}: branches along {self.name} and {other[0]} are not drawn together")
        named = of if of is not None else self._widest()
        if named != "period" and named not in self.highest:
            known = ", ".join([*self.highest, "period"])
            raise ModelError(f"{self.system.name}: no {named!r} to draw; known are {known}")
        lines = [line for one in (self, *others) for line in one._lines(named)]
        units = self.system.units
        label = on_axis("period", time_unit(units)) if named == "period" else on_axis(named, unit_of(units, named))
        if named != "period" and any(one.of_cycles for one in (self, *others)):
            label = f"largest and least {label}"
        return drawn(self.system.name, on_axis(self.name, unit_of(units, self.name)), label, lines)

    def _widest(self) -> str:
        spans = {name: float(np.ptp([*self.highest[name], *self.lowest[name]])) for name in self.highest}
        return max(spans, key=lambda name: spans[name])

    def _lines(self, of: str) -> list[Line]:
        marks = [(one.row, one.kind) for one in self.special]
        if of == "period":
            return [Line(self.parameter, self.period, self.stable, marks)]
        if not self.of_cycles:
            return [Line(self.parameter, self.highest[of], self.stable, marks)]
        return [Line(self.parameter, one[of], self.stable, marks) for one in (self.highest, self.lowest)]

    def __str__(self) -> str:
        what = "cycles" if self.of_cycles else "equilibria"
        ends = f"from {self.parameter[0]:.6g} to {self.parameter[-1]:.6g}"
        found = ", ".join(map(str, self.special)) or "no bifurcations"
        failure = "" if self.success else f"; {self.message}"
        return f"{self.system.name}: {what} along {self.name} {ends}: {found}{failure}"

    def __repr__(self) -> str:
        return f"<Branch {self}>"

    def _repr_html_(self) -> str:
        rows = {"found": self.message, "bifurcations": [str(one) for one in self.special] or "none"}
        return table(f"{self.system.name}: {'cycles' if self.of_cycles else 'equilibria'} along {self.name}", rows)
