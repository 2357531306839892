"""Picture of a run: the columns it shows, and their axes."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..arguments.named_values import Vector, unknown
from ..codegen.model.normalise import ModelError
from ..presentation.figures import plain_text
from ..presentation.units import on_axis, time_unit
from .columns import names_of_rows
from .motion_table import table, units_of_columns
from .pictures.labelled_lines import label
from .pictures.motion_over_time import Panel, motion_over_time
from .pictures.moving_shapes import Drawing
from .trajectory import Trajectory

_MOST_PANELS = 6


def run_picture(
    rows: Trajectory,
    names: Sequence[str],
    places: Sequence[Vector] | None,
    drawing: Drawing | None,
    over: str | None = None,
) -> Any:
    """Return the figure of some columns of the table of a motion; () for coordinates, states and outputs.

    Parameters
    ----------
    places
        For each event, where it happened on the horizontal axis; None for a model without events.
    over
        The column on the horizontal axis; None for the time.

    Raises
    ------
    ModelError
        An unknown name, or matplotlib is not installed.
    """
    model, columns = rows.model, table(rows)
    if missing := set(names) - set(columns) | set(names) & {"t"}:
        raise ModelError(f"{model.name}: {unknown('column', missing, [name for name in columns if name != 't'])}")
    units = units_of_columns(rows)
    panels = _Panels({name: values for name, values in columns.items() if name != over}, units)
    rates = list(columns)[rows.n + 1 : 2 * rows.n + 1]  # over its only coordinate, a model may have nothing else
    chosen = panels.chosen(names) if names else panels.standard(rows) or panels.chosen(rates)
    happened = places if places is not None else [np.empty(0)] * len(model.events)
    along = on_axis("time $t$", plain_text(time_unit(model.units))), rows.t
    if over is not None:
        along = on_axis(label(over), plain_text(units.get(over, ""))), columns[over]
    return motion_over_time(
        model.name.replace("_", " "), along, chosen, dict(zip(model.events, happened, strict=True)), drawing
    )


class _Panels:
    """Columns of a motion on axes: quantities of different units are on different ones."""

    def __init__(self, columns: dict[str, Vector], units: dict[str, str]) -> None:
        self.columns, self.units = columns, units

    def standard(self, rows: Trajectory) -> list[Panel]:
        """Return coordinates and states, outputs, and named multipliers.

        Outputs without a unit, if they are few, and multipliers of each name are on their own axes.
        """
        model, shown = rows.model, list(self.columns)
        first = len(shown) - model.n_states
        states, outputs = shown[first:], shown[first - len(model.outputs) : first]
        coordinates = [name for name in (*table(rows),)[1 : rows.n + 1] if name in shown]
        motion = self.grouped(dict.fromkeys(coordinates, "coordinates") | dict.fromkeys(states, "states"))
        alone = [name for name in outputs if name not in self.units]
        measured = self.grouped({name: "outputs" for name in outputs if name in self.units})
        others = self.chosen(alone) if len(alone) < _MOST_PANELS else self.grouped(dict.fromkeys(alone, "outputs"))
        return [*motion, *measured, *others, *self._multipliers(rows)]

    def _multipliers(self, rows: Trajectory) -> list[Panel]:
        """Return the multipliers of rows with names: the rows of each name on axes of their own, if names are few.

        Contacts and frictions name theirs.
        """
        named = {name: rows.multipliers[:, k] for k, name in names_of_rows(rows.model).items()}
        groups: dict[str, dict[str, Vector]] = {}
        for name, values in named.items():
            groups.setdefault(name.partition("[")[0], {})[name] = values
        if len(groups) >= _MOST_PANELS:
            return [("multipliers", named)] if named else []
        return [
            (f"multiplier{'s' if len(lines) > 1 else ''} of {plain_text(name)}", lines)
            for name, lines in groups.items()
        ]

    def chosen(self, names: Sequence[str]) -> list[Panel]:
        """Return a panel for each column."""
        return [self._panel(label(name), [name]) for name in names]

    def grouped(self, kinds: Mapping[str, str]) -> list[Panel]:
        """Return a panel for the columns of each unit, named by their kinds, or by the only column."""
        units = dict.fromkeys(self.units.get(name, "") for name in kinds)
        groups = [(unit, [name for name in kinds if self.units.get(name, "") == unit]) for unit in units]
        words = [" and ".join(dict.fromkeys(kinds[name] for name in group)) for _, group in groups]
        return [
            self._panel(label(group[0]) if len(group) == 1 and unit else kind, group)
            for kind, (unit, group) in zip(words, groups, strict=True)
        ]

    def _panel(self, text: str, names: Sequence[str]) -> Panel:
        unit = plain_text(self.units.get(names[0], ""))
        return on_axis(text, unit), {name: self.columns[name] for name in names}
