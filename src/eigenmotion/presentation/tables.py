"""Tables for pages, and CSV and JSON."""

import csv
import io
import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

Row = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """A table of texts."""

    head: Row
    rows: tuple[Row, ...]


def as_csv(head: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """Return CSV with one line for each row; numbers have full precision."""
    text = io.StringIO(newline="")
    table = csv.writer(text, lineterminator="\n")
    table.writerow(head)
    table.writerows(rows)
    return text.getvalue()


def as_json(record: dict[str, Any]) -> str:
    """Return a record as JSON; missing numbers, infinity and NaN are null."""
    return json.dumps(_finite(record), indent=1, allow_nan=False) + "\n"


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
