"""The structures of `em_run.h` and `em_butcher.h` for ctypes, read off the headers."""

import ctypes as ct
import re
from pathlib import Path
from typing import Any

INCLUDE = Path(__file__).parents[2] / "src" / "eigenmotion" / "runtime" / "include"
READ = ("em_run.h", "tableaux/em_butcher.h")
TEXT = re.sub(r"/\*.*?\*/", "", "".join((INCLUDE / name).read_text() for name in READ), flags=re.DOTALL)
POLL = ct.CFUNCTYPE(ct.c_int, ct.c_void_p)


def enumerators(kind: str = r"\w*") -> dict[str, int]:
    """Name -> number, of every `enum {...}`, or of those of a kind."""
    found: dict[str, int] = {}
    for body in re.findall(rf"\benum\s*{kind}\s*\{{(.*?)\}}", TEXT, re.DOTALL):
        number = -1
        for entry in filter(None, map(str.strip, body.split(","))):
            name, _, value = (part.strip() for part in entry.partition("="))
            found[name] = number = int(value) if value else number + 1
    return found


NUMBERS = enumerators()
KINDS: dict[str, Any] = {"double": ct.c_double, "int": ct.c_int, "long": ct.c_long, "size_t": ct.c_size_t}


def declared(statement: str) -> list[tuple[str, Any]]:
    """Names and types of one declaration. Addresses, but those of what a run allocates, are numbers."""
    if "(" in statement:
        return [(re.findall(r"\(\*(\w+)\)", statement)[0], POLL)]
    words, *more = (part.strip() for part in statement.split(","))
    kind, first = re.fullmatch(r"(.*?)\s*(\**\w+(?:\[\w+\])*)", words).groups()  # type: ignore[union-attr]
    fields = []
    for stars, name, sizes in re.findall(r"(\**)(\w+)((?:\[\w+\])*)", " ".join([first, *more])):
        made = KINDS.get(kind) if not kind.startswith(("const", "struct")) else None
        if stars:
            made = ct.POINTER(made) if made else ct.c_void_p
        for size in reversed(re.findall(r"\w+", sizes)):
            made = made * (int(size) if size.isdigit() else NUMBERS[size])
        fields.append((name, made))
    return fields


def structure(name: str) -> Any:
    body = re.findall(rf"struct {name} \{{(.*?)\}} {name};", TEXT, re.DOTALL)[0]
    said = filter(None, (" ".join(statement.split()) for statement in body.split(";")))
    return type(name, (ct.Structure,), {"_fields_": [field for statement in said for field in declared(statement)]})


KINDS |= dict.fromkeys(re.findall(r"typedef enum (\w+)", TEXT), ct.c_int)
for known in ("em_fault", "em_signal", "em_rows", "em_dense_step", "em_run", "em_tableau"):
    KINDS[known] = structure(known)

Signal, Rows, Run, Tableau = (KINDS[name] for name in ("em_signal", "em_rows", "em_run", "em_tableau"))
