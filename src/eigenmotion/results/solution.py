"""Result of a run: the fields of SciPy's solutions, and those of the mechanism, which are computed on first access."""

import sys
from collections.abc import Callable, ItemsView, Iterator, KeysView, ValuesView
from functools import cache
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.named_values import Vector, unknown, vector
from ..arguments.tasks import Task
from ..codegen.model.normalise import ModelError
from ..presentation.figures import has_matplotlib, require_matplotlib
from ..presentation.notebook import image, table
from ..presentation.tables import as_csv
from ..presentation.units import time_unit, with_unit
from ..runtime import CompiledModel, StopReason
from . import motion_table
from .between_rows import between, passages
from .pictures.animation import FRAMES_A_SECOND, animation, frame_times, still
from .pictures.moving_shapes import Drawing, require_drawing
from .run_picture import run_picture
from .trajectory import Segment, Trajectory

__all__ = ["DenseOutput", "Solution", "StopReason"]

_DERIVED: dict[str, Callable[[Trajectory], Any]] = {
    "x": lambda rows: rows.x.T[: rows.n],
    "v": lambda rows: rows.v.T[: rows.n],
    "eta": lambda rows: rows.eta.T[: rows.n],
    "C": lambda rows: np.moveaxis(rows.factors[0], 0, -1)[: rows.n, : rows.n],
    "s": lambda rows: rows.factors[1].T[: rows.n],
    "multipliers": lambda rows: rows.multipliers.T,
    "energy": lambda rows: rows.energies.sum(axis=1),
    "jacobi_integral": lambda rows: rows.energies @ (1.0, 0.0, -1.0, 1.0),
    "constraint_residual": lambda rows: rows.constraint_residual.T,
    "position_residual": lambda rows: rows.position_residual.T,
    "factor_residual": lambda rows: rows.factor_residual,
    "outputs": lambda rows: rows.outputs,
    "states": lambda rows: rows.states,
    "quasi_velocities": lambda rows: rows.quasi_velocities,
    "drawing": lambda rows: rows.drawing,
}

_DEFAULTS: dict[str, Any] = {
    "sol": None, "t_events": None, "y_events": None, "y_after_events": None, "modes": (), "methods": (),
    "error_estimate": None, "error_cost": None, "not_unique": (), "njev": 0, "nlu": 0, "n_bounded": 0, "n_stiff": 0,
}  # fmt: skip
"""Values of fields that a run does not set. Most runs set none, and a dict of half the size takes half the time."""

_OF_ROWS = ("sensitivity", "error_estimate", "error_cost")
"""Fields that belong to the rows of the run."""
_SMOOTH, _DRAWN = 2000, 600
"""Number of points of a line, and of rows of a drawing, in a picture."""


class DenseOutput:
    """y(t) between the accepted steps of a run, each value projected like an accepted step.

    Parameters
    ----------
    rows_at
        Function that returns y (k, n_state) at times (k,) within the run.

    Attributes
    ----------
    t_min, t_max
        The interval of the run.
    ts
        (k + 1,) the ends of the steps.
    """

    def __init__(self, ts: Vector, rows_at: Callable[[Vector], Vector]) -> None:
        self.ts, self._rows_at = ts, rows_at
        self.t_min, self.t_max = float(min(ts[0], ts[-1])), float(max(ts[0], ts[-1]))

    def __call__(self, t: ArrayLike) -> Vector:
        """Return y (n_state,) at a number t, (n_state, k) at t (k,).

        Raises
        ------
        ModelError
            A t outside [t_min, t_max].
        """
        times = vector(t, "t")
        if times.ndim > 1:
            raise ModelError(f"t has shape {times.shape}, but must be a number or one-dimensional")
        if times.size and not (self.t_min <= times.min() and times.max() <= self.t_max):
            raise ModelError(f"t is outside the interval of the run, [{self.t_min:.9g}, {self.t_max:.9g}]")
        rows = self.rows(np.atleast_1d(times))
        return rows.T if times.ndim else rows[0]

    def rows(self, t: Vector) -> Vector:
        """Return y (k, n_state) at times (k,) within the run, without a check."""
        return self._rows_at(t)


class Solution(dict[str, Any]):
    """A motion; fields by attribute or by item. k rows (time is the last axis); n coordinates; m constraint rows.

    t : (k,)
    y : (n_state, k), published meaning; a run can restart from any column
    sol : y(t) as a function, with dense_output
    t_events, y_events : for each event (e,) and (e, n_state); None if the model has no events
    y_after_events : as y_events, but after the event action, for events that act
    modes : for a model with contacts, the start time and parameter name -> value of each mode of the run; else ()
    nfev, njev, nlu : evaluations of the right-hand side and its Jacobian, factorisations (of implicit methods)
    nsteps, nrejected : accepted and rejected steps
    n_bounded : accepted steps that did not run the published equations
    n_stiff : approximate number of steps that stability limited, not their error; if most, `message` says so
    not_unique : the constraint rows whose multipliers are not unique (those of least norm are returned)
    error_estimate, error_cost : an ErrorEstimate and an ErrorCost with estimate_error, else None
    sensitivity : name -> dx, dv (n, k) and dt_events, for each name in `sensitivities`
    method : the name of the method that ran, or the last of them
    methods : of method="auto" that has changed its method, (start time, name) of each; else ()
    stop, status, success, message : a StopReason; -1 failed, 0 finished, 1 terminal event; how it ended, what to do

    Computed on first access, and included in `in` and `keys()`:

    x, v, eta : (n, k); eta as in y, or S C v if y does not have it
    C : (n, n, k), s : (n, k): as in y, or eigenfactors of M(x), continuous in sign and order
    multipliers : (m, k); the constraints push with -A^T lambda (7)
    energy, jacobi_integral : (k,), T + V and T2 - T0 + V
    constraint_residual : (m, k), A v + b
    position_residual : (h, k), phi of the h holonomic rows
    factor_residual : (k,), max|M - C^T S^2 C| / max|M|, with M the factored matrix (docs/theory.md)
    outputs, states, quasi_velocities : name -> (k,)
    drawing : a Drawing with numbers (k, ...); None if the model has no drawing

    Rows without a value (singular M, dependent constraint rows) are NaN.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> sol = em.build(model).simulate((0.0, 10.0), rtol=1e-9, dense_output=True)
    >>> sol.success, str(sol.stop), float(sol.t[-1])
    (True, 'finished', 10.0)
    >>> bool(abs(sol.energy - sol.energy[0]).max() < 1e-6)
    True
    >>> sol.sol([1.0, 2.0]).shape
    (2, 2)
    """

    __slots__ = ("__weakref__", "_source")
    __setattr__ = dict.__setitem__
    __delattr__ = dict.__delitem__
    _source: Trajectory | tuple[Task, tuple[Segment, ...]] | None

    def __init__(self, rows: Trajectory | tuple[Task, tuple[Segment, ...]] | None, fields: dict[str, Any]) -> None:
        """`rows` may be the task and segments of the run: the Trajectory is then made when a field needs it."""
        dict.update(self, fields)
        _keep(self, rows)

    @property  # type: ignore[misc]
    def __class__(self) -> Any:
        """Also an OptimizeResult of SciPy, if that is imported already (the import takes longer than most runs)."""
        of_scipy = getattr(sys.modules.get("scipy.optimize"), "OptimizeResult", None)
        return _one_of(type(self), of_scipy) if isinstance(of_scipy, type) else type(self)

    @property
    def _rows(self) -> Trajectory | None:
        source = self._source
        if isinstance(source, tuple):
            task, segments = source
            source = Trajectory(task, self["t"], self["y"].T, segments)
            _keep(self, source)
        return source

    @property
    def trajectory(self) -> Trajectory | None:
        """The rows of compiled functions, with inputs and accelerations; None in a copy from another process."""
        return self._rows

    @property
    def motion(self) -> tuple[Vector, Vector]:
        """x, v of compiled functions, (n + p, k) each: the last p of v are the states, of x their integrals."""
        rows = self._rows
        if rows is not None:
            return rows.x.T, rows.v.T
        states = list(self["states"].values())  # in a copy from another process; the integrals are not needed
        return np.vstack([self.x, *(0.0 * z for z in states)]), np.vstack([self.v, *states])

    @property
    def model(self) -> CompiledModel | None:
        """The compiled model; None in a copy from another process."""
        return None if self._rows is None else self._rows.model

    def __missing__(self, name: str) -> Any:
        if name in _DEFAULTS:
            return _DEFAULTS[name]
        if self._rows is None or name not in _DERIVED:
            raise KeyError(self._hint(name))
        self[name] = value = _DERIVED[name](self._rows)
        return value

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(*error.args) from error

    def _hint(self, name: str) -> str:
        """Return a hint for a name that is not a field but a coordinate or an output."""
        if self._rows is None:
            return name
        model = self._rows.model
        if name in model.coordinates:
            k = model.coordinates.index(name)
            return f"{name!r} is a coordinate: its values are x[{k}], its rates v[{k}]"
        return f"{name!r} is an output: outputs[{name!r}]" if name in model.outputs else name

    def __contains__(self, name: object) -> bool:
        return super().__contains__(name) or name in _DEFAULTS or (self._rows is not None and name in _DERIVED)

    def __iter__(self) -> Iterator[str]:
        names = list(super().__iter__())
        yield from names
        yield from (name for name in (*_DEFAULTS, *(_DERIVED if self._rows is not None else ())) if name not in names)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def keys(self) -> KeysView[str]:  # type: ignore[override]
        """Names of all fields, derived ones included."""
        return KeysView(self)

    def values(self) -> ValuesView[Any]:  # type: ignore[override]
        """All fields, which are computed if necessary."""
        return ValuesView(self)

    def items(self) -> ItemsView[str, Any]:  # type: ignore[override]
        """Names and fields, which are computed if necessary."""
        return ItemsView(self)

    def get(self, name: str, default: Any = None) -> Any:
        """Return a field, or the default if there is no field of that name."""
        try:
            return self[name]
        except KeyError:
            return default

    def drawn(self, t: Vector) -> Drawing:
        """Return the drawing of the mechanism at t (k,), from `sol`, or else interpolated between the rows.

        Raises
        ------
        ModelError
            The model has no drawing, or this is a copy from another process, which has only its rows.
        """
        rows = self._rows
        if rows is None:
            raise ModelError(
                "a copy of a Solution from another process has the drawing of its own rows only: `drawing`"
            )
        require_drawing(self["drawing"], rows.model.name)
        if self["sol"] is None:
            return require_drawing(rows.drawn(t, *between(rows.t, rows.x, rows.v, t)), rows.model.name)
        y = np.ascontiguousarray(self["sol"](t).T)
        x, v = np.ascontiguousarray(y[:, : rows.model.n]), rows.model.velocity_rows(t, y, rows.task.prepared)
        return require_drawing(rows.drawn(t, x, v), rows.model.name)

    def at(self, t: ArrayLike) -> "Solution":
        """Return the motion at other times t (k,), with all that is computed from its rows; needs dense_output.

        The times are in the order of the run. Sensitivities and error estimates are of the run's own rows: the result
        has none.

        Raises
        ------
        ModelError
            The run has no dense output, or a time is outside it or out of order.

        Examples
        --------
        >>> import eigenmotion as em
        >>> from eigenmotion.models.pendulum import model
        >>> sol = em.build(model).simulate((0.0, 10.0), dense_output=True)
        >>> sol.at([0.0, 5.0, 10.0]).energy.shape
        (3,)
        """
        rows, times = self._named_rows("at"), vector(t, "t")
        if self["sol"] is None:
            raise ModelError("at: the run has no function of time; simulate(..., dense_output=True) keeps one")
        y = self["sol"](np.atleast_1d(times) if times.ndim < 2 else times)
        fields = {name: value for name, value in dict.items(self) if name not in (*_DERIVED, *_OF_ROWS)}
        found = rows.at(np.atleast_1d(times), np.ascontiguousarray(y.T))
        return Solution(found, fields | {"t": found.t, "y": y})

    def over(self, name: str, values: ArrayLike) -> "Solution":
        """Return the motion where a coordinate passes values (k,), in their order in the run, as `at` does for times.

        Raises
        ------
        ModelError
            There is no such coordinate, it turns back during the run, or does not reach a value; or as `at`.

        Examples
        --------
        A pendulum that turns over, at quarters of its first turn:

        >>> import numpy as np
        >>> import eigenmotion as em
        >>> from eigenmotion.models.pendulum import model
        >>> sol = em.build(model).simulate((0.0, 2.0), x0={"theta": 0.0}, v0={"theta": 8.0}, dense_output=True)
        >>> turn = sol.over("theta", np.linspace(0.0, 2 * np.pi, 5))
        >>> (turn.x[0] / np.pi).round(9)
        array([0. , 0.5, 1. , 1.5, 2. ])
        """
        k, sol = self._coordinate(name), self["sol"]
        if sol is None:
            raise ModelError("over: the run has no function of time; simulate(..., dense_output=True) keeps one")
        wanted = np.atleast_1d(vector(values, "values"))
        return self.at(passages(name, lambda t: sol.rows(t)[:, k], np.asarray(sol.ts), wanted))

    def _coordinate(self, name: str) -> int:
        rows = self._named_rows("over")
        known = rows.model.coordinates[: rows.n]
        if name not in known:
            raise ModelError(f"{rows.model.name}: {unknown('coordinate', [name], known)}")
        return known.index(name)

    def table(self) -> dict[str, Vector]:
        """Return column -> (k,): t, coordinates, rates (marked '), multipliers, energy, outputs, states.

        A column has the name of its quantity. Multipliers are lambda_NAME of rows with names, and else lambda0,
        lambda1, ... If a name is taken, its kind is put before it, as in output_energy.

        Raises
        ------
        ModelError
            This is a copy from another process, which has no names.
        """
        return motion_table.table(self._named_rows("table"))

    def to_csv(self, path: str | PathLike[str] | None = None) -> str | None:
        """Write `table` to a file, in full precision; return its text if there is no path.

        Where the model has units, they are behind the names of the columns, as in theta [rad].

        Raises
        ------
        ModelError
            As `table`; or the file cannot be written.
        """
        columns, units = self.table(), motion_table.units_of_columns(self._named_rows("to_csv"))
        head = [with_unit(name, units.get(name, "")) for name in columns]
        return motion_table.text_or_file(as_csv(head, np.vstack([*columns.values()]).T.tolist()), path)

    def save(self, path: str | PathLike[str]) -> None:
        """Write all arrays to PATH.npz, or `table` to PATH.csv.

        Raises
        ------
        ModelError
            As `table`; another ending; or the file cannot be written.
        """
        motion_table.save(self, path, motion_table.SAVERS)

    def to_pandas(self) -> Any:
        """Return `table` as a `pandas.DataFrame` over t; `attrs` has the model's name and units.

        Raises
        ------
        ModelError
            As `table`; or pandas is not installed.
        """
        return motion_table.data_frame(self.table(), self._attributes)

    def to_xarray(self) -> Any:
        """Return `table` as an `xarray.Dataset` with the dimension t; variables have `units`, if the model has.

        Raises
        ------
        ModelError
            As `table`; or xarray is not installed (the extra `xarray`).
        """
        return motion_table.data_set(self.table(), self._attributes)

    @property
    def _attributes(self) -> dict[str, Any]:
        rows = self._named_rows("attrs")
        units = motion_table.units_of_columns(rows)
        return {"model": rows.model.name, "stop": str(self["stop"])} | ({"units": units} if units else {})

    def _named_rows(self, call: str) -> Trajectory:
        if self._rows is None:
            raise ModelError(
                f"{call}: this Solution has numbers, but no model: it is a copy from another process, or the start of "
                "its run was refused. Call it where the run was made"
            )
        return self._rows

    def plot(self, *names: str, over: str | None = None) -> Any:
        """Return a figure of columns of `table`, with the events and the mechanism; needs the extra `plot`.

        Lines are smooth with dense_output, else they join the rows.

        Parameters
        ----------
        names
            Columns, each on its own axes. Without names: coordinates and states, and the outputs.
        over
            The coordinate on the horizontal axis; None for the time.

        Raises
        ------
        ModelError
            An unknown name, no rows, matplotlib is not installed; or as `table`.

        Examples
        --------
        >>> import eigenmotion as em
        >>> from eigenmotion.models.pendulum import model
        >>> sol = em.build(model).simulate((0.0, 10.0), dense_output=True)
        >>> sol.plot("theta", "theta'", "energy").savefig("pendulum.png")
        """
        require_matplotlib()
        rows = self._named_rows("plot")
        if not len(self["t"]):
            raise ModelError("the run has no rows, so there is nothing to plot")
        first, last = float(rows.t[0]), float(rows.t[-1])
        smooth = rows if self["sol"] is None else self.at(np.linspace(first, last, _SMOOTH))._named_rows("plot")
        drawn = self.drawn(np.linspace(first, last, _DRAWN)) if self["drawing"] is not None else None
        if over is None:
            return run_picture(smooth, names, self["t_events"], drawn)
        k = self._coordinate(over)
        places = None if self["y_events"] is None else [y[:, k] for y in self["y_events"]]
        return run_picture(smooth, names, places, drawn, over)

    def animate(self, *, speed: float = 1.0, fps: float = FRAMES_A_SECOND) -> Any:
        """Return the run as a matplotlib animation; needs the extra `plot`.

        Parameters
        ----------
        speed
            Seconds of motion per second.
        fps
            Frames per second.

        Raises
        ------
        ModelError
            The model has no drawing, there are no rows, or matplotlib is not installed.
        """
        if not len(self["t"]):
            raise ModelError("the run has no rows, so there is nothing to animate")
        return animation(self.drawn(frame_times(self["t"][0], self["t"][-1], speed, fps)), fps)

    @property
    def cost(self) -> str:
        """Counts of steps and right-hand sides, as text."""
        return f"{self['nsteps']} steps, {self['nrejected']} rejected, {self['nfev']} right-hand sides"

    def __dir__(self) -> list[str]:
        return sorted({*object.__dir__(self), *self})

    def __repr__(self) -> str:
        t = self["t"]
        span = f"t = {t[0]:g} ... {t[-1]:g}" if len(t) else "no rows"
        model = f" of {self._rows.model.name}" if self._rows is not None else ""
        return f"<Solution{model}: {self['stop']}, {span} in {len(t)} rows, {self.cost}>\n{self['message']}"

    __str__ = __repr__

    def _repr_html_(self) -> str:
        t = self["t"]
        rows = {"ended": f"{self['stop']}: {self['message']}", "rows": str(len(t)), "cost": self.cost}
        if len(t):
            rows |= {"time": f"{t[0]:g} ... {t[-1]:g} {time_unit(model.units) if (model := self.model) else ''}"}
        drawing = self["drawing"] if self._rows is not None else None
        picture = image(still(drawing), "the mechanism at the end") if drawing and has_matplotlib() else ""
        return table(self._rows.model.name if self._rows is not None else "Solution", rows) + picture

    def __reduce__(self) -> tuple[Callable[[dict[str, Any]], "Solution"], tuple[dict[str, Any]]]:
        """Pickle all fields; `sol` only if another process can make the model, which it needs."""
        fields = dict(self.items())
        if self._rows is not None and self._rows.model.recipe is None:
            fields["sol"] = None
        return _restored, (fields,)


@cache
def _one_of(ours: type, of_scipy: type) -> type:
    return type(ours.__name__, (ours, of_scipy), {"__doc__": ours.__doc__, "__module__": ours.__module__})


_keep = Solution.__dict__["_source"].__set__  # the only attribute of a Solution that is not a field


def _restored(fields: dict[str, Any]) -> Solution:
    return Solution(None, fields)
