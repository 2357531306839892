"""Picture of a run: the columns it shows, and their axes."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..arguments.named_values import Vector, unknown
from ..arguments.states import names_of_states
from ..codegen.model.normalise import ModelError
from .motion_table import table
from .pictures.labelled_lines import label
from .pictures.motion_over_time import Panel, motion_over_time
from .pictures.moving_shapes import Drawing
from .trajectory import Trajectory

_MOST_PANELS = 6


def run_picture(rows: Trajectory, names: Sequence[str], times: Sequence[Vector] | None, drawing: Drawing | None) -> Any:
    """Return the figure of some columns of the table of a motion; () for coordinates, states and outputs.

    Raises
    ------
    ModelError
        An unknown name, or matplotlib is not installed.
    """
    model, columns = rows.model, table(rows)
    if missing := set(names) - set(columns) | set(names) & {"t"}:
        raise ModelError(f"{model.name}: {unknown('column', missing, [name for name in columns if name != 't'])}")
    panels = _chosen(columns, names) if names else _standard(rows, columns)
    happened = times if times is not None else [np.empty(0)] * len(model.events)
    return motion_over_time(
        model.name.replace("_", " "), rows.t, panels, dict(zip(model.events, happened, strict=True)), drawing
    )


def _standard(rows: Trajectory, columns: dict[str, Vector]) -> list[Panel]:
    """Return coordinates and states on one axis, and each output on its own, if these are few."""
    model, n = rows.model, rows.n
    shown = list(columns)
    states = shown[len(shown) - len(names_of_states(model)) :] if model.n_states else []
    outputs = shown[len(shown) - len(states) - len(model.outputs) : len(shown) - len(states)]
    motion = [*shown[1 : n + 1], *states]
    panels = [("coordinates and states" if states else "coordinates", {name: columns[name] for name in motion})]
    if len(outputs) < _MOST_PANELS:
        return panels + _chosen(columns, outputs)
    return [*panels, ("outputs", {name: columns[name] for name in outputs})]


def _chosen(columns: dict[str, Vector], names: Sequence[str]) -> list[Panel]:
    return [(label(name), {name: columns[name]}) for name in names]
