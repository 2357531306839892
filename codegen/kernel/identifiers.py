"""C identifiers for the user's names: unique in the scope of a kernel, and not reserved."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable

WORDS = frozenset(
    "auto break case char const continue default do double else enum extern float for goto if inline int long "
    "register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while "
    "asm typeof main errno NULL EOF INFINITY NAN I complex imaginary bool true false linux unix i386 EIGENMOTION_H "
    "sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp log pow sqrt fabs erf floor ceil "
    "isnan isfinite memset real".split()
)
"""Reserved names: keywords of C, macros of its library, and functions that kernels call (em_real.h)."""
MACROS = re.compile(r"(DBL|FLT|LDBL|DECIMAL|FP|MATH|HUGE|EXIT|RAND|MB|M)_\w+|math_errhandling|__.*|(?i:em)_.*")
"""Macros of the C library, our headers and compilers, which would replace a variable of the same name."""


def c_identifier(name: str) -> str:
    """Return a valid C identifier for a name: invalid characters become underscores, reserved names get one more."""
    identifier = re.sub(r"\W", "_", name, flags=re.ASCII)
    if not identifier or identifier[0].isdigit():
        identifier = f"_{identifier}"
    return identifier + "_" if identifier in WORDS or MACROS.fullmatch(identifier) else identifier


def c_identifiers(names: Iterable[str], taken: Collection[str] = ()) -> dict[str, str]:
    """Return name -> identifier; identifiers are unique and differ from those in `taken`."""
    identifiers: dict[str, str] = {}
    for name in names:
        identifiers[name] = free(c_identifier(name), {*taken, *identifiers.values()})
    return identifiers


def free(identifier: str, taken: Collection[str]) -> str:
    """Return this identifier, with underscores appended until it is not in `taken`."""
    while identifier in taken:
        identifier += "_"
    return identifier
