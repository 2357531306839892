"""C identifiers for the user's names: of their own in the scope of a kernel, and no word of C."""

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
"""Words of C, macros of its library, the functions of it that kernels call, and what they compute with (em_real.h)."""
MACROS = re.compile(r"(DBL|FLT|LDBL|DECIMAL|FP|MATH|HUGE|EXIT|RAND|MB|M)_\w+|math_errhandling|__.*|(?i:em)_.*")
"""Of the C library, our headers and compilers: replaced wherever they stand, also where a variable has the name."""


def c_identifier(name: str) -> str:
    """Return a name as C takes it: what is no identifier, or means something in any scope, gets underscores."""
    identifier = re.sub(r"\W", "_", name, flags=re.ASCII)
    if not identifier or identifier[0].isdigit():
        identifier = f"_{identifier}"
    return identifier + "_" if identifier in WORDS or MACROS.fullmatch(identifier) else identifier


def c_identifiers(names: Iterable[str], taken: Collection[str] = ()) -> dict[str, str]:
    """Return name -> identifier, all of them different, and none of those taken."""
    identifiers: dict[str, str] = {}
    for name in names:
        identifiers[name] = free(c_identifier(name), {*taken, *identifiers.values()})
    return identifiers


def free(identifier: str, taken: Collection[str]) -> str:
    """Return an identifier that is not taken yet: this one, or this one with underscores."""
    while identifier in taken:
        identifier += "_"
    return identifier
