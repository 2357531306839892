"""Description of a linearised mechanism: text and a plot of eigenvalues."""

from collections.abc import Iterator, Sequence
from typing import Any

from ...arguments.named_values import Vector
from ...presentation.figures import BLUE, blank, uncluttered
from .linearization import Linearization, eigenvalue_text


def description(linear: Linearization) -> str:
    """Return the state, and one line for each mode: eigenvalue [1/s], frequency [Hz], damping ratio, description."""
    names, n = linear.model.coordinates, len(linear.x)
    state = [*state_rows(names[:n], linear.x, linear.v, linear.acceleration),
             *(f"{name} = {z + 0.0:.6g}" for name, z in zip(names[n:], linear.z.tolist(), strict=True))]  # fmt: skip
    mode = [f"mode: {', '.join(f'{name} = {value:g}' for name, value in linear.mode.items())}"] if linear.mode else []
    return "\n".join([f"{linear.model.name}: {len(linear.A)} states, {linear.message}", *mode, "", *state, "",
                      *_modes(linear), "", _verdict(linear)])  # fmt: skip


def state_rows(coordinates: Sequence[str], x: Vector, v: Vector, a: Vector) -> Iterator[str]:
    """Yield lines with a state and its accelerations, one for each coordinate."""
    width = max(10, *map(len, coordinates))
    yield f"{'':{width}} {'position':>14} {'velocity':>14} {'acceleration':>14}"
    rows = zip(coordinates, (x + 0.0).tolist(), (v + 0.0).tolist(), (a + 0.0).tolist(), strict=True)
    yield from (f"{name:{width}} {x:14.6g} {v:14.6g} {a:14.6g}" for name, x, v, a in rows)


def _modes(linear: Linearization) -> Iterator[str]:
    yield f"{'eigenvalue [1/s]':24} {'[Hz]':>10} {'damping':>10}  mode"
    for mode in linear.modes():
        numbers = f"{mode.frequency:10.4g} {'' if mode.neutral else f'{mode.damping + 0.0:.4g}':>10}"
        yield f"{eigenvalue_text(mode.eigenvalue):24} {numbers}  {mode.words}"


def _verdict(linear: Linearization) -> str:
    if not len(linear.A):
        return "held: nothing can move"
    growing = [mode for mode in linear.modes() if mode.grows]
    mode = "at this instant " if not linear.steady else ""
    if growing:
        return f"{mode}unstable: {len(growing)} of {len(linear.modes())} modes grow"
    decays = all(mode.decays for mode in linear.modes())
    return f"{mode}{'stable: every mode decays' if decays else 'no mode grows'}"


def plane(linear: Linearization) -> Any:
    """Return a matplotlib figure of the eigenvalues in the complex plane."""
    figure = blank(6.0, 4.5)
    axes = figure.add_subplot()
    values = linear.eigenvalues()
    axes.axvline(0.0, color="0.6", linewidth=0.8)
    axes.plot(values.real, values.imag, "x", color=BLUE, markersize=8, markeredgewidth=2)
    axes.set(xlabel="growth [1/s]", ylabel="frequency [rad/s]", title=f"Eigenvalues of {linear.model.name}")
    uncluttered(axes)
    return figure
