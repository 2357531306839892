"""The values that `eigenmotion sweep` is given, in words: NAME=A:B:K, NAME=V,V,..., NAME=KIND(A,B)."""

import re
from collections.abc import Collection
from pathlib import Path

import click
import numpy as np

from eigenmotion.batch.memory import shortage
from eigenmotion.batch.sweep.design import KINDS, Design, Distribution
from eigenmotion.batch.sweep.stores import JOINED
from eigenmotion.codegen.model import Model, ModelError

from .options import assignments, distinct_assignments, values

MOST = 10**9
"""Runs of one sweep."""
_STOP = 200  # [byte] how a run ended
_POINT = 100  # [byte] a value of a list takes, and where it is said what the sweep is


def design_of(model: Model, sweeps: tuple[str, ...], samples: tuple[str, ...], n: int | None, seed: int) -> Design:
    """Return what --sweep, --sample, -n and --seed say.

    Raises
    ------
    UsageError
        Names the model does not have, values that are none, or more runs than a sweep holds.
    """
    if not sweeps and not samples:
        raise click.UsageError("nothing is swept: give --sweep or --sample")
    if bool(samples) != (n is not None):
        raise click.UsageError("-n says how many samples --sample draws: give both")
    grid = {name: _values(name, text) for name, text in distinct_assignments(sweeps, "--sweep").items()}
    drawn = {name: _distribution(name, text) for name, text in distinct_assignments(samples, "--sample").items()}
    if twice := sorted(grid.keys() & drawn.keys()):
        raise click.UsageError(f"{twice[0]} is swept and sampled: give one of the two")
    try:
        values(model, tuple(f"{name}=0" for name in (*grid, *drawn)))
    except click.UsageError as error:
        raise click.UsageError(error.message.replace("--set", "--sweep, --sample")) from error
    design = Design(grid, drawn, n or 1, seed)
    if design.count > MOST:
        raise click.UsageError(f"{design.count:.3g} runs: at most {MOST:.0e} in one sweep")
    return design


def _values(name: str, text: str) -> list[float]:
    """A:B:K or V,V,... -> values."""
    option = f"--sweep {name}={text}"
    pieces = text.split(":")
    try:
        if len(pieces) == 1:
            found = [float(value) for value in text.split(",")]
        else:
            low, high, number = pieces
            _check_count(option, count := int(number))
            found = np.linspace(float(low), float(high), count).tolist()
    except ValueError as error:
        raise click.UsageError(f"{option}: expected A:B:K, K values from A to B, or a list V,V,...") from error
    if not found or not np.isfinite(found).all():
        raise click.UsageError(f"{option}: there must be values, and finite ones")
    return found


def _check_count(option: str, count: int) -> None:
    if count > MOST:
        raise click.UsageError(f"{option}: {count:.3g} values: at most {MOST:.0e} in one sweep")
    if short := shortage(_POINT * count):
        raise click.UsageError(f"{option}: {count} values {short}")


def _distribution(name: str, text: str) -> Distribution:
    """KIND(A,B) -> what is drawn from."""
    option = f"--sample {name}={text}"
    found = re.fullmatch(r"\s*(\w+)\s*\(([^,]+),([^,]+)\)\s*", text)
    try:
        if found is None:
            raise ValueError
        numbers = float(found[2]), float(found[3])
        if not np.isfinite(numbers).all():
            raise ValueError
        return Distribution(found[1].lower(), *numbers)
    except ModelError as error:
        raise click.UsageError(f"{option}: {error}") from error
    except ValueError as error:
        raise click.UsageError(f"{option}: expected one of {', '.join(KINDS.values())}") from error


def check_set(settings: tuple[str, ...], swept: Collection[str]) -> None:
    """Refuse names that are set and swept.

    Raises
    ------
    UsageError
        There is one; names it.
    """
    if twice := sorted(assignments(settings, "--set").keys() & set(swept)):
        raise click.UsageError(f"{twice[0]} is set and swept: give one of the two")


def check_memory(model: Model, design: Design, store: Path, rows: int, at_once: int) -> None:
    """Find out before the runs whether there is memory for those that are kept together, and for the store.

    Raises
    ------
    UsageError
        There is not; says for what, and what to do.
    """
    per_row = 2 * model.n + model.m + 1 + len(model.outputs) + len(model.states)
    each = 8 * (rows * per_row + len(design.grid) + len(design.samples)) + _STOP
    of_part = min(at_once, design.count) * (each + 16 * rows * model.n)  # of states beside what is kept of them
    if short := shortage(of_part):
        words = f"{min(at_once, design.count)} runs of {rows} rows"
        raise click.UsageError(f"--chunk: {words} {short}. Give a smaller --chunk, or fewer --rows")
    of_store = 2 * design.count * each  # parts, and these joined
    if store.suffix in JOINED and (short := shortage(of_store)):
        words = f"{store.suffix} files are put together in memory, where {design.count} runs of {rows} rows"
        raise click.UsageError(f"-o {store}: {words} {short}. Store .zarr or .csv, or give fewer --rows")
