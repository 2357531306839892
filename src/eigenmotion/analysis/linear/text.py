"""A linearised mechanism in words and in a picture."""

from collections.abc import Iterator, Sequence
from typing import Any

from ...arguments.named_values import Vector
from ...presentation.figures import BLUE, blank, uncluttered
from .linearization import Linearization, written


def description(found: Linearization) -> str:
    """Return the state, and each mode on a line: eigenvalue [1/s], frequency [Hz], damping ratio, what it does."""
    names, n = found.model.coordinates, len(found.x)
    state = [*state_rows(names[:n], found.x, found.v, found.acceleration),
             *(f"{name} = {z + 0.0:.6g}" for name, z in zip(names[n:], found.z.tolist(), strict=True))]  # fmt: skip
    held = [f"mode: {', '.join(f'{name} = {value:g}' for name, value in found.mode.items())}"] if found.mode else []
    return "\n".join([f"{found.model.name}: {len(found.A)} states, {found.message}", *held, "", *state, "",
                      *_modes(found), "", _verdict(found)])  # fmt: skip


def state_rows(coordinates: Sequence[str], x: Vector, v: Vector, a: Vector) -> Iterator[str]:
    """Return a state and its accelerations, a coordinate on a line."""
    width = max(10, *map(len, coordinates))
    yield f"{'':{width}} {'position':>14} {'velocity':>14} {'acceleration':>14}"
    rows = zip(coordinates, (x + 0.0).tolist(), (v + 0.0).tolist(), (a + 0.0).tolist(), strict=True)
    yield from (f"{name:{width}} {x:14.6g} {v:14.6g} {a:14.6g}" for name, x, v, a in rows)


def _modes(found: Linearization) -> Iterator[str]:
    yield f"{'eigenvalue [1/s]':24} {'[Hz]':>10} {'damping':>10}  mode"
    for mode in found.modes():
        numbers = f"{mode.frequency:10.4g} {'' if mode.neutral else f'{mode.damping + 0.0:.4g}':>10}"
        yield f"{written(mode.eigenvalue):24} {numbers}  {mode.words}"


def _verdict(found: Linearization) -> str:
    if not len(found.A):
        return "held: nothing can move"
    growing = [mode for mode in found.modes() if mode.grows]
    held = "at this instant " if not found.steady else ""
    if growing:
        return f"{held}unstable: {len(growing)} of {len(found.modes())} modes grow"
    decays = all(mode.decays for mode in found.modes())
    return f"{held}{'stable: every mode decays' if decays else 'no mode grows'}"


def plane(found: Linearization) -> Any:
    """Return a matplotlib figure of the eigenvalues in their plane."""
    figure = blank(6.0, 4.5)
    axes = figure.add_subplot()
    values = found.eigenvalues()
    axes.axvline(0.0, color="0.6", linewidth=0.8)
    axes.plot(values.real, values.imag, "x", color=BLUE, markersize=8, markeredgewidth=2)
    axes.set(xlabel="growth [1/s]", ylabel="frequency [rad/s]", title=f"Eigenvalues of {found.model.name}")
    uncluttered(axes)
    return figure
