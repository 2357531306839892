"""Values of `eigenmotion sweep`: NAME=A:B:K, NAME=V,V,..., NAME=KIND(A,B)."""

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
"""Most runs of one sweep."""
_STOP = 200  # [byte] memory for the end of a run: its stop reason and counts
_POINT = 100  # [byte] memory for a value of a list, and for its text in the description of the sweep


def design_of(model: Model, sweeps: tuple[str, ...], samples: tuple[str, ...], n: int | None, seed: int) -> Design:
    """Return the design from --sweep, --sample, -n and --seed.

    Raises
    ------
    UsageError
        Names that the model does not have, invalid values, or too many runs.
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
    """Return the values of A:B:K or V,V,...."""
    option = f"--sweep {name}={text}"
    pieces = text.split(":")
    try:
        if len(pieces) == 1:
            parsed = [float(value) for value in text.split(",")]
        else:
            low, high, number = pieces
            _check_count(option, count := int(number))
            parsed = np.linspace(float(low), float(high), count).tolist()
    except ValueError as error:
        raise click.UsageError(f"{option}: expected A:B:K, K values from A to B, or a list V,V,...") from error
    if not parsed or not np.isfinite(parsed).all():
        raise click.UsageError(f"{option}: there must be values, and finite ones")
    return parsed


def _check_count(option: str, count: int) -> None:
    if count > MOST:
        raise click.UsageError(f"{option}: {count:.3g} values: at most {MOST:.0e} in one sweep")
    if short := shortage(_POINT * count):
        raise click.UsageError(f"{option}: {count} values {short}")


def _distribution(name: str, text: str) -> Distribution:
    """Return the distribution of KIND(A,B)."""
    option = f"--sample {name}={text}"
    parsed = re.fullmatch(r"\s*(\w+)\s*\(([^,]+),([^,]+)\)\s*", text)
    try:
        if parsed is None:
            raise ValueError
        numbers = float(parsed[2]), float(parsed[3])
        if not np.isfinite(numbers).all():
            raise ValueError
        return Distribution(parsed[1].lower(), *numbers)
    except ModelError as error:
        raise click.UsageError(f"{option}: {error}") from error
    except ValueError as error:
        raise click.UsageError(f"{option}: expected one of {', '.join(KINDS.values())}") from error


def check_set(settings: tuple[str, ...], swept: Collection[str]) -> None:
    """Check that no name is both set and swept.

    Raises
    ------
    UsageError
        A name is both; the message contains it.
    """
    if twice := sorted(assignments(settings, "--set").keys() & set(swept)):
        raise click.UsageError(f"{twice[0]} is set and swept: give one of the two")


def check_memory(model: Model, design: Design, store: Path, rows: int, at_once: int) -> None:
    """Check before the runs that there is enough memory for the runs of a part, and for the store.

    Raises
    ------
    UsageError
        There is not enough memory; says for what, and what to do.
    """
    per_row = 2 * model.n + model.m + 1 + len(model.outputs) + len(model.states)
    each = 8 * (rows * per_row + len(design.grid) + len(design.samples)) + _STOP
    of_part = min(at_once, design.count) * (each + 16 * rows * model.n)  # states, and the arrays that are stored
    if short := shortage(of_part):
        words = f"{min(at_once, design.count)} runs of {rows} rows"
        raise click.UsageError(f"--chunk: {words} {short}. Give a smaller --chunk, or fewer --rows")
    of_store = 2 * design.count * each  # the parts, and the joined arrays
    if store.suffix in JOINED and (short := shortage(of_store)):
        words = f"{store.suffix} files are put together in memory, where {design.count} runs of {rows} rows"
        raise click.UsageError(f"-o {store}: {words} {short}. Store .zarr or .csv, or give fewer --rows")
