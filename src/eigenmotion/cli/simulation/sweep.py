"""`eigenmotion sweep`."""

import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from eigenmotion.arguments.methods import AUTO, METHODS
from eigenmotion.arguments.named_values import Vector, spelled
from eigenmotion.batch.simulate_ensemble import chosen_method, simulate_ensemble
from eigenmotion.batch.sweep.design import KINDS, Design
from eigenmotion.batch.sweep.order import order_of
from eigenmotion.batch.sweep.stores import STORES, arrays_of, check_names, finish, is_done, require, store_difference
from eigenmotion.batch.sweep.unfinished_store import Parts
from eigenmotion.building.build import system_of
from eigenmotion.codegen.model import Model, ModelError
from eigenmotion.presentation.figures import FORMATS, require_matplotlib
from eigenmotion.presentation.figures import save as save_figure
from eigenmotion.progress import clock, counted, duration
from eigenmotion.results.columns import reactions
from eigenmotion.results.ensemble import Ensemble
from eigenmotion.results.output import ensemble_plot
from eigenmotion.runtime import EvaluationError
from eigenmotion.system.system import System

from ..options import Finite, Shape, check_targets, ending, model, setting, shaping, values
from ..sweep_values import MOST, check_memory, check_set, design_of

_SHOWN = 3  # number of failed runs that are listed for each reason
_AT_ONCE = 64  # number of parts that are sent to a cluster together


@click.command("sweep")
@model
@ending(Finite())
@click.option("--sweep", "sweeps", multiple=True, metavar="NAME=A:B:K|V,V,...",
              help="K values from A to B, or a list of values; several --sweep make a grid.")  # fmt: skip
@click.option("--sample", "samples", multiple=True, metavar="NAME=KIND(A,B)",
              help=f"Values drawn at random: {', '.join(KINDS.values())}.")  # fmt: skip
@click.option("-n", "n", type=click.IntRange(1, MOST), metavar="N", help="Number of samples at each point of the grid.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, metavar="N", help="Seed of the samples.")
@setting
@click.option("--rows", type=click.IntRange(1), default=1, show_default=True, metavar="K",
              help="Rows of each run, evenly spaced in time; 1: its end only.")  # fmt: skip
@click.option("--rtol", type=Finite(), default=1e-6, show_default=True, metavar="R", help="Relative tolerance.")
@click.option("--atol", type=Finite(), default=1e-9, show_default=True, metavar="A", help="Absolute tolerance.")
@click.option("--method", default="dop853", show_default=True, metavar="NAME", help=f"{', '.join(METHODS)}, or {AUTO}.")
@click.option("-o", "--output", "store", type=click.Path(path_type=Path), required=True, metavar="FILE",
              help=f"The store to write: {', '.join(f'FILE{ending}' for ending in STORES)}.")  # fmt: skip
@click.option("--workers", type=click.IntRange(1), metavar="N", help="Number of threads. Default: the number of cores.")
@click.option("--scheduler", metavar="ADDRESS", help="Run on the workers of this Dask cluster; needs dask.distributed.")
@click.option(
    "--resume",
    is_flag=True,
    help="Continue a sweep that was interrupted; the result is the same. Refused for another sweep's store.",
)
@click.option("--chunk", type=click.IntRange(1), default=1000, show_default=True, metavar="K",
              help="Runs that are saved together; an interrupted sweep loses unsaved ones.")  # fmt: skip
@click.option("--plot", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
              help="Draw the spread over time, or end values over swept ones, to FILE.png, .svg or .pdf.")  # fmt: skip
@shaping
def command(
    model: Path,
    t_end: float,
    sweeps: tuple[str, ...],
    samples: tuple[str, ...],
    n: int | None,
    seed: int,
    settings: tuple[str, ...],
    rows: int,
    rtol: float,
    atol: float,
    method: str,
    store: Path,
    workers: int | None,
    scheduler: str | None,
    resume: bool,
    chunk: int,
    plot: Path | None,
    **shape: Any,
) -> int:
    """Simulate MODEL for many values of parameters, inputs and initial values, and store every run.

    NAME is as for --set. Runs that fail are stored with their reason, and listed at the end.
    """
    _check_targets(store, plot, workers, scheduler)
    request = Shape(**shape).request(model)
    design = design_of(request.model, sweeps, samples, n, seed)
    swept = (*design.grid, *design.samples)
    check_set(settings, swept)
    check_memory(request.model, design, store, rows, chunk * (_AT_ONCE if scheduler else 1))
    states = [spelled(z) for z, _ in request.model.states]
    check_names(store, swept, [*(name for name, _ in request.model.outputs), *states])
    times = np.linspace(0.0, t_end, rows) if rows > 1 else np.array([t_end])
    with clock():
        system = system_of(request)
    named = chosen_method(system, method, rtol).name  # "auto" depends on the machine; a resumed sweep keeps the choice
    arguments = {"rtol": rtol, "atol": atol, "method": named, "t_eval": times if rows > 1 else None}
    order = order_of(
        system.compiled, design, arguments, sources=request.input_hash, set=sorted(settings), t_end=t_end, rows=rows,
        chunk=chunk,
    )  # fmt: skip
    names = system.coordinates, reactions(system.compiled)
    parts = Parts(store, order, -(-design.count // chunk), times, *names, system.units)
    work = _Sweep(system, request.model, design, parts, chunk, t_end, values(request.model, settings), arguments)
    with parts.locked():
        if resume and is_done(parts, lambda: work.computed(workers)):
            parts.clear()
            click.echo(f"{store} is complete")
            return 0
        parts.begin(resume=resume)
        if store.exists() and store.suffix != ".csv" and (difference := store_difference(parts)):
            click.echo(f"{store} {difference}. This sweep replaces it when it ends", err=True)
        return _done(work, workers, scheduler, plot)


def _done(work: "_Sweep", workers: int | None, scheduler: str | None, plot: Path | None) -> int:
    start = time.perf_counter()
    with _executor(scheduler) as executor:
        try:
            whole = work.run(workers, executor)
        except KeyboardInterrupt:
            whole = False
        except (ModelError, EvaluationError):
            work.parts.clear_if_empty()
            raise
    if not whole:
        click.echo(f"interrupted; --resume goes on where {work.parts.store} was left", err=True)
        return 130
    click.echo(_summary(work.parts, work.design.count, time.perf_counter() - start, work.words))
    if plot:
        click.echo(f"drawn to {save_figure(_picture(work.system, work.design, work.parts), plot)}")
    finish(work.parts)
    click.echo(f"stored in {work.parts.store}")
    return 0


@dataclass(frozen=True)
class _Sweep:
    """Execution of a sweep, part by part."""

    system: System
    model: Model
    design: Design
    parts: Parts
    chunk: int
    t_end: float
    settings: dict[str, dict[str, float]]
    options: dict[str, Any]
    words: dict[str, str] = field(default_factory=dict)
    """Reason of a failure -> the message of a run with that reason, of the parts that this process made."""

    def run(self, workers: int | None, executor: Any) -> bool:
        """Run the missing parts; return whether all parts exist (not after Ctrl-C)."""
        missing = [number for number in range(self.parts.count) if not self.parts.has(number)]
        if damaged := [number for number in missing if self.parts.is_damaged(number)]:
            click.echo(f"{len(damaged)} parts are damaged, or of another sweep: their runs are made anew", err=True)
        together = _AT_ONCE if executor else 1
        total = self.design.count
        with counted(total, total - sum(map(self._size, missing))) as count:
            for first in range(0, len(missing), together):
                some = missing[first : first + together]
                if not self._do(some, workers, executor):
                    return False
                count(sum(map(self._size, some)))
        return True

    def computed(self, workers: int | None) -> Iterator[dict[str, NDArray[Any]]]:
        """Yield the arrays of each part, which are not stored.

        Raises
        ------
        KeyboardInterrupt
            Ctrl-C.
        """
        with counted(self.design.count) as count:
            for number in range(self.parts.count):
                runs, swept = self._runs([number], workers, None)
                if "interrupted" in runs.stop:
                    raise KeyboardInterrupt
                count(self._size(number))
                yield arrays_of(runs, swept)

    def _span(self, number: int) -> tuple[int, int]:
        return number * self.chunk, min((number + 1) * self.chunk, self.design.count)

    def _size(self, number: int) -> int:
        start, stop = self._span(number)
        return stop - start

    def _do(self, numbers: list[int], workers: int | None, executor: Any) -> bool:
        """Run parts and store them, unless they were interrupted; return whether they were stored."""
        runs, swept = self._runs(numbers, workers, executor)
        if "interrupted" in runs.stop:
            return False
        for k in np.flatnonzero(~runs.success).tolist():
            self.words.setdefault(str(runs.stop[k]), runs.message(k))
        arrays, start = arrays_of(runs, swept), 0
        for number in numbers:
            stop = start + self._size(number)
            self.parts.write_part(number, {name: array[start:stop] for name, array in arrays.items()})
            start = stop
        return True

    def _runs(self, numbers: list[int], workers: int | None, executor: Any) -> tuple[Ensemble, dict[str, Vector]]:
        """Return the runs of parts, and name -> swept values."""
        each = [self.design.values(*self._span(number)) for number in numbers]
        swept = {name: np.concatenate([one[name] for one in each]) for name in each[0]}
        options = self.options | self._given(swept) | {"workers": workers, "executor": executor}
        return simulate_ensemble(self.system, (0.0, self.t_end), **options), swept

    def _given(self, swept: dict[str, Any]) -> dict[str, Any]:
        """Return the arguments of `simulate_ensemble` from --set and from swept values."""
        kinds = values(self.model, tuple(f"{name}=0" for name in swept))
        arguments = {kind: dict(numbers) for kind, numbers in self.settings.items()}
        for kind, names in kinds.items():
            for name in names:
                rate = f"{name}'"
                column = swept[rate] if kind == "v0" and rate in swept else swept[name]
                arguments.setdefault(kind, {})[name] = column
        return arguments


def _check_targets(store: Path, plot: Path | None, workers: int | None, scheduler: str | None) -> None:
    """Check the targets and options before the runs."""
    if plot:
        require_matplotlib()
    check_targets(("-o", store, STORES), ("--plot", plot, FORMATS))
    if workers and scheduler:
        raise click.UsageError("--workers are threads here, --scheduler has workers of its own: give one of them")
    require(store)


@contextmanager
def _executor(scheduler: str | None) -> Iterator[Any]:
    """Yield the executor of a Dask cluster, or None for threads of this process."""
    if scheduler is None:
        yield None
        return
    try:
        from distributed import Client  # noqa: PLC0415, an optional package
    except ImportError as error:
        raise ModelError("--scheduler needs dask.distributed: pip install 'eigenmotion[cluster]'") from error
    try:
        client: Any = Client(scheduler, timeout=10)  # type: ignore[no-untyped-call]
    except (OSError, ValueError) as error:
        raise click.UsageError(f"--scheduler {scheduler}: no cluster answers there ({error})") from error
    with client:
        yield client.get_executor(retries=3)


def _summary(parts: Parts, count: int, seconds: float, words: dict[str, str]) -> str:
    """Return a text with the number of runs, the time, and the failures with their reasons, each with one message."""
    stops, first, where = Counter[str](), 0, dict[str, list[int]]()
    for arrays in parts.arrays():
        stops.update(arrays["stop"].tolist())
        for k in np.flatnonzero(~arrays["success"]).tolist():
            named = where.setdefault(str(arrays["stop"][k]), [])
            if len(named) < _SHOWN:
                named.append(first + k)
        first += len(arrays["t_end"])
    failed = sum(number for stop, number in stops.items() if stop in where)
    lines = [f"{count} runs in {duration(seconds)}, {failed} failed"]
    for stop, number in stops.most_common():
        runs = (
            f"  (run {', '.join(map(str, where[stop]))}{', ...' if number > _SHOWN else ''})" if stop in where else ""
        )
        lines.append(f"  {number:>9} {stop}{runs}")
        if stop in where and stop in words:
            lines.append(f"            {words[stop]}")
    return "\n".join(lines)


def _picture(system: System, design: Design, parts: Parts) -> Any:
    x = np.concatenate([arrays["x"] for arrays in parts.arrays()])
    kinds = [
        f"{', '.join(names)} {how}" for names, how in ((design.grid, "swept"), (design.samples, "sampled")) if names
    ]
    title = f"{system.name.replace('_', ' ')}, {design.count} runs: {'; '.join(kinds)}"
    if len(parts.time) > 1:
        return ensemble_plot.over_time(title, system.coordinates, parts.time, x, system.units)
    if len(design.grid) == 2 and not design.samples:
        return ensemble_plot.over_grid(title, system.coordinates, design.grid, x[:, :, 0], system.units)
    every = design.values(0, design.count)
    return ensemble_plot.ends(title, system.coordinates, every, x[:, :, 0], system.units, design.samples)
