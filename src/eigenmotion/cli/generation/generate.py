"""`eigenmotion generate`."""

import logging
from pathlib import Path
from typing import Any

import click

from eigenmotion.building.request import Request
from eigenmotion.building.source_check import differences_by_bytes, differences_by_hash, unified_diff
from eigenmotion.codegen.render.emit import Sources
from eigenmotion.files import write
from eigenmotion.progress import clock

from ..options import Shape, distinct, models, output, shaping

_log = logging.getLogger("eigenmotion")


@click.command("generate")
@models
@output
@shaping
@click.option("--check", is_flag=True, help="Write nothing; exit code 1 if a file is out of date.")
@click.option("--strict", is_flag=True, help="With --check: derive again and compare bytes.")
@click.option("--diff", is_flag=True, help="Write nothing; show what would change.")
def command(models: tuple[Path, ...], output: Path, check: bool, strict: bool, diff: bool, **shape: Any) -> int:
    """Write the C, header and Cython sources of each MODEL, a Python file that defines `model`.

    --check compares the hashes in the headers of the files, so it quickly finds an edited model or an edited file.
    --strict derives again and compares bytes, so it also finds a changed generator. --diff adds a unified diff; without
    --check its exit code is 0.
    """
    requests = distinct([Shape(**shape).request(model) for model in models])
    with clock():
        return _done(requests, output, check=check, strict=strict, diff=diff)


def _done(requests: list[Request], output: Path, *, check: bool, strict: bool, diff: bool) -> int:
    if not (check or strict or diff):
        for request in requests:
            _write(_derived(request), output)
        return 0
    differs = [_check(request, output, strict or not check, diff) for request in requests]
    return int(any(differs) and (check or strict))


def _write(sources: Sources, folder: Path) -> None:
    for file in sources.files:
        new = write(folder / file.name, file.text.encode())
        click.echo(f"{'wrote' if new else 'same '} {folder / file.name}")


def _check(request: Request, folder: Path, derive: bool, diff: bool) -> bool:
    """Report the differences of one model's files; return whether there are any."""
    sources = _derived(request) if derive else None
    differences = differences_by_bytes(sources, folder) if sources else differences_by_hash(request, folder)
    for difference in differences:
        click.echo(f"{difference.file}: {difference.reason}", err=True)
    if diff and differences:
        click.echo(unified_diff(sources or _derived(request), folder), nl=False)
    return bool(differences)


def _derived(request: Request) -> Sources:
    _log.info("deriving %s", request.model.name)
    return request.sources()
