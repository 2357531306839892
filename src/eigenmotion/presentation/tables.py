"""Tables on a page, and the same numbers as CSV and JSON."""

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
    """Texts, row by row."""

    head: Row
    rows: tuple[Row, ...]


def as_csv(head: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """Write a line a row; numbers in full precision."""
    text = io.StringIO(newline="")
    table = csv.writer(text, lineterminator="\n")
    table.writerow(head)
    table.writerows(rows)
    return text.getvalue()


def as_json(record: dict[str, Any]) -> str:
    """Write a record; numbers that are not there, or not finite, are null."""
    return json.dumps(_finite(record), indent=1, allow_nan=False) + "\n"


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
