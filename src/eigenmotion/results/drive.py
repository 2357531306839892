"""Result of `drive`: a prescribed motion, and the forces that it takes."""

import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import Any

import numpy as np

from ..arguments.named_values import Vector, unknown
from ..arguments.states import names_of_states
from ..codegen.model.normalise import ModelError
from ..presentation.figures import plain_text
from ..presentation.tables import as_csv
from ..presentation.units import force_unit, on_axis, power_unit, time_unit, unit_of, with_unit
from ..runtime import CompiledModel, Prepared
from .between_rows import between
from .columns import columns, moving, reactions
from .motion_table import save, text_or_file
from .pictures.animation import FRAMES_A_SECOND, animation, frame_times
from .pictures.driven_motion import Lines, driven_motion
from .pictures.labelled_lines import label
from .pictures.moving_shapes import Drawing, require_drawing


@dataclass(frozen=True, eq=False, repr=False)
class Drive:
    """A prescribed motion at k times, and the forces of the actuators. Time is the last axis.

    Attributes
    ----------
    t : (k,)
    x, v, a : (n, k), of all coordinates
    states : name -> (k,)
    actuators : names of coordinates and inputs, in the order of `forces`
    forces : (count, k), of coordinates [J / u_i]; of inputs their values
    power : (count, k), that each actuator gives to the mechanism [W]
    multipliers : (m, k); the constraints push with -A^T lambda (7)
    outputs : name -> (k,), of the driven motion
    u : (n_inputs, k), with the actuators' values in it

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> turn = em.drive(em.build(model), [0.0, 0.5, 1.0], {"theta": em.t**2})
    >>> turn
    <Drive of pendulum: t = 0 ... 1 in 3 rows; largest forces theta 10.25>
    >>> turn.power.round(3)
    array([[ 0.   ,  4.427, 20.51 ]])
    """

    model: CompiledModel
    prepared: Prepared
    t: Vector
    actuators: tuple[str, ...]
    rows: tuple[Vector, Vector, Vector, Vector]
    forces: Vector
    multipliers: Vector
    power: Vector
    outputs: dict[str, Vector]

    def __repr__(self) -> str:
        peaks = ", ".join(
            f"{name} {np.abs(row).max():.4g}" for name, row in zip(self.actuators, self.forces, strict=True)
        )
        span = f"t = {self.t[0]:g} ... {self.t[-1]:g} in {len(self.t)} rows"
        return f"<Drive of {self.model.name}: {span}; largest forces {peaks}>"

    def _coordinates(self, rows: Vector) -> Vector:
        return rows.T[: self.model.n_coordinates]

    @property
    def x(self) -> Vector:
        """(n, k)."""
        return self._coordinates(self.rows[0])

    @property
    def v(self) -> Vector:
        """(n, k)."""
        return self._coordinates(self.rows[1])

    @property
    def a(self) -> Vector:
        """(n, k)."""
        return self._coordinates(self.rows[2])

    @property
    def u(self) -> Vector:
        """(n_inputs, k)."""
        return self.rows[3].T

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return self.model.coordinates[: self.model.n_coordinates]

    @property
    def states(self) -> dict[str, Vector]:
        """Name -> (k,)."""
        return dict(zip(names_of_states(self.model), self.rows[1].T[self.model.n_coordinates :], strict=True))

    @cached_property
    def drawing(self) -> Drawing | None:
        """The drawing of the mechanism at every time; None if the model has no drawing."""
        return self._drawn(self.t, *self.rows[:2]) if self.model.shapes else None

    def drawn(self, t: Vector) -> Drawing:
        """Return the drawing at t (k,), interpolated between the rows.

        Raises
        ------
        ModelError
            The model has no drawing.
        """
        require_drawing(self.drawing, self.model.name)
        return self._drawn(t, *(between(self.t, *self.rows[:2], t) if len(self.t) > 1 else self.rows[:2]))

    def _drawn(self, t: Vector, x: Vector, v: Vector) -> Drawing:
        numbers = self.model.drawn_rows(t, x, v, self.prepared)
        return Drawing(self.model.name, t, self.model.dimension, self.model.shapes, numbers, self.model.units)

    def animate(self, *, speed: float = 1.0, fps: float = FRAMES_A_SECOND) -> Any:
        """Return the motion as a matplotlib animation, as `Solution.animate` does; needs the extra `plot`."""
        return animation(self.drawn(frame_times(self.t[0], self.t[-1], speed, fps)), fps)

    def plot(self, *names: str) -> Any:
        """Return a figure of the motion, forces and powers over time, and of forces over speeds; needs `plot`.

        Parameters
        ----------
        names
            Columns of the table in place of the motion, forces and powers, each on its own axes: reactions and other
            outputs, for example.

        Raises
        ------
        ModelError
            An unknown name, or matplotlib is not installed.
        """
        units = self.model.units
        speeds = {
            name: (self.v[self.coordinates.index(name)], row, unit_of(units, name, 1), self.units[f"force_{name}"])
            for name, row in zip(self.actuators, self.forces, strict=True)
            if name in self.coordinates
        }
        along = on_axis("time $t$", plain_text(time_unit(units))), self.t
        lines = self._chosen(names) if names else self._standard()
        return driven_motion(self.model.name, along, lines, speeds, self.drawing)

    def _standard(self) -> list[Lines]:
        """Return coordinates, forces and powers, those of each unit on their own axes."""
        rows = ("coordinates", self.coordinates, self.x, ""), ("forces", self.actuators, self.forces, "force_")
        lines = list[Lines]()
        for kind, names, values, prefix in (*rows, ("power", self.actuators, self.power, "power_")):
            words = [self.units[prefix + name] for name in names]
            for unit in dict.fromkeys(words):
                of = [k for k, word in enumerate(words) if word == unit]
                lines.append((on_axis(kind, plain_text(unit)), [names[k] for k in of], values[of]))
        return lines

    def _chosen(self, names: Sequence[str]) -> list[Lines]:
        known, rows = self.table()
        if missing := set(names) - set(known[1:]):
            raise ModelError(f"{self.model.name}: {unknown('column', missing, known[1:])}")
        places = [known.index(name) for name in names]
        words = [on_axis(label(name), plain_text(self.units.get(name, ""))) for name in names]
        return [(word, [name], rows[:, [k]].T) for word, name, k in zip(words, names, places, strict=True)]

    @property
    def units(self) -> dict[str, str]:
        """Column of the table -> unit, "" where there is none; multipliers have no unit."""
        of, coordinates = self.model.units, self.coordinates
        words = {"t": time_unit(of)}
        words |= {f"{name}{orders * chr(39)}": unit_of(of, name, orders) for name in coordinates for orders in range(3)}
        words |= {f"force_{name}": force_unit(of, name) if name in coordinates else unit_of(of, name)
                  for name in self.actuators}  # fmt: skip
        words |= {f"power_{name}": power_unit(of) for name in self.actuators}
        return words | {name: unit_of(of, name) for name in (*self.outputs, *self.states, *self.model.inputs)}

    def table(self) -> tuple[list[str], Vector]:
        """Return names of columns and numbers (k, columns): t; coordinates; rates, marked '; accelerations, marked ''.

        Behind these are forces, powers, multipliers, outputs, states and inputs.
        """
        ours = ["t", *reactions(self.model)]
        motion = moving(ours, self.coordinates)
        marked = [*motion, *(f"{name}''" for name in self.coordinates)]
        others = {
            "force": dict(zip(self.actuators, self.forces, strict=True)),
            "power": dict(zip(self.actuators, self.power, strict=True)),
            "output": self.outputs,
            "state": self.states,
            "input": {n: row for n, row in zip(self.model.inputs, self.u, strict=True) if n not in self.actuators},
        }
        users = [(kind, f"{kind}_{n}" if kind in ("force", "power") else n) for kind, of in others.items() for n in of]
        named = columns({*ours, *marked}, users)
        rows = [
            self.t,
            *self.x,
            *self.v,
            *self.a,
            *self.multipliers,
            *(row for of in others.values() for row in of.values()),
        ]
        return ["t", *marked, *ours[1:], *named], np.array(rows).T

    def to_csv(self, path: str | PathLike[str] | None = None) -> str | None:
        """Write `table` to a file, in full precision; return its text if there is no path.

        Where the model has units, they are behind the names of the columns, as in theta [rad].

        Raises
        ------
        ModelError
            The file cannot be written.
        """
        (names, rows), units = self.table(), self.units
        head = [with_unit(name, units.get(name, "")) for name in names]
        return text_or_file(as_csv(head, rows.tolist()), path)

    def save(self, path: str | PathLike[str]) -> None:
        """Write a table to PATH.csv, or arrays to PATH.npz.

        Raises
        ------
        ModelError
            Another ending, or the file cannot be written.
        """
        save(self, path, SAVERS)


def _csv(motion: Drive) -> bytes:
    return str(motion.to_csv()).encode()


def _npz(motion: Drive) -> bytes:
    buffer = io.BytesIO()
    arrays = {name: getattr(motion, name) for name in ("t", "x", "v", "a", "u", "forces", "power", "multipliers")}
    arrays |= {f"output_{name}": values for name, values in motion.outputs.items()}
    arrays |= {f"state_{name}": values for name, values in motion.states.items()}
    np.savez_compressed(
        buffer, coordinates=np.array(motion.coordinates), actuators=np.array(motion.actuators), **arrays
    )
    return buffer.getvalue()


SAVERS: dict[str, Callable[[Drive], bytes]] = {".npz": _npz, ".csv": _csv}
