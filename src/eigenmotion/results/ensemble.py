"""Result of an ensemble: arrays over runs, coordinates and time, and each run as a Solution."""

from collections.abc import Iterator
from functools import cached_property, partial
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arguments.named_values import Vector
from ..arguments.states import names_of_states
from ..arguments.tasks import EnsembleTask, Members
from ..codegen.model.normalise import ModelError
from ..presentation.notebook import table
from ..presentation.units import time_unit, unit_of, unit_of_marked
from ..runtime import COUNTS, StopReason, explain, modes_of, record, stiffness
from ..runtime.ensemble import energies, reactions, velocities
from .batch_arrays import REASONS, BatchArrays, empty_fields
from .columns import columns
from .multiplier_uniqueness import shared
from .sensitivity import Sensitivity, parts_of
from .solution import Solution
from .trajectory import Trajectory

_ENDS_WELL = sum(reason.success for reason in REASONS)


class Ensemble:
    """K runs of one system, run first and time last; n coordinates, m constraint rows, nt rows of time.

    t : (nt,); without t_eval, the end of the span
    x, v : (K, n, nt); y (K, n_state, nt), published meaning
    multipliers : (K, m, nt); energy, jacobi_integral : (K, nt); outputs, states : name -> (K, nt)
    t_end : (K,) the time that each run reached: a terminal event or a failure ends a run early, and later rows are NaN.
        Without t_eval, the row of a run that a terminal event ended is the state at the event
    success : (K,); stop : (K,) of StopReason; failed : indices of runs that failed; message(k) : how run k ended
    nfev, nsteps : (K,); method : the name of the method that ran
    swept : name -> (K,) values of the arguments that differ between runs
    sensitivity : name -> (dx, dv), each (K, n, nt), and dz (K, p, nt), for each name in `sensitivities`

    ensemble[k] is run k as a Solution, without dense output.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> runs = em.simulate_ensemble(em.build(model), (0.0, 1.0), parameters={"l": [0.5, 1.0, 2.0]})
    >>> runs
    <Ensemble of pendulum: 3 runs, 0 failed>
    >>> runs.x.shape, runs.swept["l"], len(runs[1].t)
    ((3, 1, 1), array([0.5, 1. , 2. ]), 1)
    """

    def __init__(self, common: EnsembleTask, members: Members, results: BatchArrays) -> None:
        self._common, self._members, self._results = common, members, results
        self._model = common.model

    def __len__(self) -> int:
        return self._members.count

    def __iter__(self) -> Iterator[Solution]:
        return (self[k] for k in range(len(self)))

    def __repr__(self) -> str:
        return f"<Ensemble of {self._model.name}: {self.summary}>"

    def _repr_html_(self) -> str:
        swept = [f"{name}: {values.min():.6g} ... {values.max():.6g}" for name, values in self.swept.items()]
        rows = {"runs": self.summary, "method": self.method, "swept": swept or "nothing", "rows": str(len(self.t))}
        return table(self._model.name, rows)

    @property
    def summary(self) -> str:
        """The number of runs, and the stop reasons of those that failed, as text."""
        failures = [reason for reason in REASONS if not reason.success]
        counts = {reason: int((self._results.status == REASONS.index(reason)).sum()) for reason in failures}
        listed = ", ".join(f"{count} {reason}" for reason, count in counts.items() if count)
        return f"{len(self)} runs, {len(self.failed)} failed{f' ({listed})' if listed else ''}"

    # --- how they ended ---

    @property
    def t(self) -> Vector:
        """(nt,)."""
        return self._common.t_eval

    @property
    def t_end(self) -> Vector:
        """(K,)."""
        return self._results.t_end

    @property
    def success(self) -> NDArray[np.bool_]:
        """(K,)."""
        return self._results.status < _ENDS_WELL

    @property
    def failed(self) -> NDArray[np.intp]:
        """Indices of runs that failed."""
        return np.flatnonzero(~self.success)

    @cached_property
    def stop(self) -> NDArray[Any]:
        """(K,) of StopReason."""
        return np.asarray(np.array(REASONS, dtype=object)[self._results.status])

    def message(self, k: int) -> str:
        """Return a message about how and where run k ended, and what to do."""
        results, k = self._results, self._number(k)
        if k in results.messages:
            return results.messages[k]
        stop, model = REASONS[results.status[k]], self._model
        words = explain(
            stop,
            model.coordinates,
            int(results.first[k]),
            int(results.second[k]),
            float(results.size[k]),
            model.events,
            model.row_names,
            tuple(model.tables),
        )
        stiff = stiffness(int(self._count("n_stiff")[k]), int(self.nsteps[k]), self._common.iterates)
        return f"{words if stop is StopReason.FINISHED else f'At t = {results.t_end[k]:.9g}: {words}'}{stiff}"

    @property
    def nfev(self) -> NDArray[np.int_]:
        """(K,): evaluations of the right-hand side."""
        return self._count("nfev")

    @property
    def nsteps(self) -> NDArray[np.int_]:
        """(K,): accepted steps."""
        return self._count("nsteps")

    def _count(self, name: str) -> NDArray[np.int_]:
        return self._results.counts[:, COUNTS.index(name)]

    @property
    def method(self) -> str:
        """The name of the method that ran."""
        return self._common.name

    # --- their rows ---

    @property
    def swept(self) -> dict[str, Vector]:
        """Name -> (K,)."""
        return self._members.swept

    @property
    def y(self) -> Vector:
        """(K, n_state, nt)."""
        return np.moveaxis(self._results.y, 1, 2)

    @property
    def x(self) -> Vector:
        """(K, n, nt)."""
        return self.y[:, : self._n]

    @cached_property
    def v(self) -> Vector:
        """(K, n, nt)."""
        return np.moveaxis(self._v, 1, 2)[:, : self._n]

    @property
    def _n(self) -> int:
        """The number of coordinates; in compiled arrays, states follow them (`arguments.states`)."""
        return self._model.n_coordinates

    @property
    def states(self) -> dict[str, Vector]:
        """Name -> (K, nt): first-order states."""
        return {name: self._v[:, :, self._n + k] for k, name in enumerate(names_of_states(self._model))}

    @property
    def energy(self) -> Vector:
        """(K, nt): T + V."""
        return np.asarray(self._energies.sum(axis=2))

    @property
    def jacobi_integral(self) -> Vector:
        """(K, nt): T2 - T0 + V."""
        return np.asarray(self._energies @ (1.0, 0.0, -1.0, 1.0))

    @property
    def multipliers(self) -> Vector:
        """(K, m, nt)."""
        return np.moveaxis(self._reactions[1], 1, 2)

    @property
    def outputs(self) -> dict[str, Vector]:
        """Name -> (K, nt)."""
        return {name: self._reactions[2][:, :, k] for k, name in enumerate(self._model.outputs)}

    @property
    def sensitivity(self) -> dict[str, Sensitivity]:
        """Name -> dx, dv (K, n, nt); NaN at rows that a run did not reach, and for runs without sensitivities."""
        S = np.moveaxis(self._results.S, (2, 1, 0), (0, 1, 2))  # (2 n, nt, K, columns)
        dx, dv, dz = (np.moveaxis(part, 2, 0) for part in parts_of(self._model, S))
        return {
            name: Sensitivity.of(dx[..., k], dv[..., k], dz[..., k], None)
            for k, name in enumerate(self._differentiated)
        }

    @property
    def _differentiated(self) -> tuple[str, ...]:
        return self._common.differentiated.names if self._common.differentiated else ()

    @property
    def _times(self) -> Vector:
        """(K or 1, nt): times of the rows."""
        return self._results.t_end[:, None] if self._common.end_only else self._common.t_eval[None]

    @cached_property
    def _v(self) -> Vector:
        return velocities(self._model, self._times, self._results.y, self._members.parameters)

    @cached_property
    def _energies(self) -> Vector:
        return energies(self._model, self._times, self._results.y, self._v, self._members.parameters)

    @cached_property
    def _reactions(self) -> tuple[Vector, ...]:
        rows = self._times, self._results.y, self._v, self._inputs
        if self._model.switches:
            return self._results.by_mode(partial(reactions, self._model), rows, self._members, self._common.least_norm)
        return reactions(self._model, *rows, self._members.parameters, self._common.least_norm)

    @property
    def _inputs(self) -> Vector:
        """(K, nt, n_inputs)."""
        count, rows = self._results.y.shape[:2]
        at = np.empty((count, rows, self._model.n_inputs))
        for k in range(count if self._model.n_inputs else 0):
            at[k] = self._results.inputs_of(k, self._members).at(self._times[k if self._common.end_only else 0])
        return at

    # --- one of them ---

    def _number(self, k: int) -> int:
        """Return k as an index from 0; -1 is the last run."""
        if not isinstance(k, (int, np.integer)):
            raise ModelError(f"run {k!r} of an ensemble: runs are numbered, from 0 to {len(self) - 1}")
        if not -len(self) <= k < len(self):
            raise IndexError(f"run {k} of an ensemble of {len(self)}: runs are numbered from 0 to {len(self) - 1}")
        return int(k) % len(self)

    def __getitem__(self, k: int) -> Solution:
        """Return run k.

        Raises
        ------
        IndexError
            There is no such run.
        """
        k = self._number(k)
        results, members, common = self._results, self._members, self._common
        there = ~np.isnan(results.y[k]).any(axis=1)
        t = self._times[k if common.end_only else 0][there]
        rows, stop = np.ascontiguousarray(results.y[k][there]), REASONS[results.status[k]]
        t_events, y_events = self._events(k)
        segments = results.segments.get(k, ())
        ended = stop, self.message(k), common.name, tuple(results.counts[k].tolist())
        fields = record(t, rows.T, t_events, y_events, *ended, modes=modes_of(self._model, segments))
        if common.differentiated is not None:
            fields["sensitivity"] = self._sensitivity(k, there)
        if stop is StopReason.START_REFUSED:
            return Solution(None, fields | empty_fields(self._model))
        prepared = self._model.prepare(members.row("parameters", k))
        task = common.task(prepared, results.inputs_of(k, members), members.row("x", k))
        fields |= shared(task, fields["message"])
        return Solution(Trajectory(task, t, rows, segments), fields)

    def _sensitivity(self, k: int, there: NDArray[np.bool_]) -> dict[str, Sensitivity]:
        S, pieces = self._results.S[k][there].T, self._event_pieces(k)
        shifts = [self._results.dt_events[piece].T for piece in pieces]
        return {
            name: Sensitivity.of(*parts_of(self._model, S[i]), [shift[i] for shift in shifts] if pieces else None)
            for i, name in enumerate(self._differentiated)
        }

    def _events(self, k: int) -> tuple[list[Vector], list[Vector]] | tuple[None, None]:
        """Return t (e,) and y (e, n_state) of each event of run k."""
        results = self._results
        if self._model.n_events == 0:
            return None, None
        pieces = self._event_pieces(k)
        return [results.event_times[piece] for piece in pieces], [results.events[piece] for piece in pieces]

    def _event_pieces(self, k: int) -> list[slice]:
        """Return the rows of each event of run k in the table of all events."""
        ends, counts = self._event_ends[k].tolist(), self._results.event_counts[k].tolist()
        return [slice(end - count, end) for end, count in zip(ends, counts, strict=True)]

    @cached_property
    def _event_ends(self) -> NDArray[Any]:
        """(K, n_events): the end of the rows of each run and event in the table of all events."""
        counts = self._results.event_counts
        return np.cumsum(counts.ravel()).reshape(counts.shape)

    # --- for other tools ---

    def to_xarray(self) -> Any:
        """Return an `xarray.Dataset` with dimensions run, coordinate, time; swept arguments are coordinates of run.

        Where the model has units, variables have the attribute `units`, and `unit` and `rate_unit` are coordinates
        along `coordinate`, since x and v mix them.

        Raises
        ------
        ModelError
            xarray is not installed.
        """
        if find_spec("xarray") is None:
            raise ModelError("to_xarray needs xarray: pip install 'eigenmotion[xarray]'")
        import xarray  # noqa: PLC0415, an optional package

        return xarray.Dataset(
            *_dataset(self), attrs={"model": self._model.name, "formulation": self._model.formulation}
        )


def _dataset(runs: Ensemble) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the data variables and coordinates for xarray, each as (dimensions, values, attributes)."""
    along = ("run", "coordinate", "time")
    data: dict[str, Any] = {
        "x": (along, runs.x), "v": (along, runs.v), "energy": (("run", "time"), runs.energy, _unit(runs, "energy")),
        "t_end": ("run", runs.t_end), "success": ("run", runs.success), "nfev": ("run", runs.nfev),
        "stop": ("run", np.array([str(reason) for reason in runs.stop], dtype=np.str_)),
    }  # fmt: skip
    model = runs._model
    if model.m:
        data["multipliers"] = (("run", "row", "time"), runs.multipliers)
    names = model.coordinates[: runs._n]
    places: dict[str, Any] = {
        "time": ("time", runs.t, {"units": time_unit(model.units)} if model.units else {}),
        "coordinate": np.array(names),
        "run": np.arange(len(runs)),
    }
    if model.units:
        places |= {
            word: ("coordinate", np.array([unit_of(model.units, name, order) for name in names]))
            for order, word in enumerate(("unit", "rate_unit"))
        }
    named = runs.outputs | runs.states
    users = [*(("output", name) for name in runs.outputs), *(("state", name) for name in runs.states),
             *(("swept", name) for name in runs.swept)]  # fmt: skip
    labels = iter(columns({*data, *places, "row"}, users))
    data |= {
        label: (("run", "time"), values, _unit(runs, name))
        for (name, values), label in zip(named.items(), labels, strict=False)
    }
    places |= {
        label: ("run", values, _unit(runs, name))
        for (name, values), label in zip(runs.swept.items(), labels, strict=True)
    }
    return data, places


def _unit(runs: Ensemble, name: str) -> dict[str, str]:
    """Return the attributes of a variable: its unit, if the model has one."""
    unit = unit_of_marked(runs._model.units, name)
    return {"units": unit} if unit else {}
