"""Names that the user's symbols must not take in C: words of the languages, and whatever the templates use."""

from __future__ import annotations

import keyword
import re
from functools import cache
from importlib.resources import files

C_WORDS = frozenset(
    "auto break case char const continue default do double else enum extern float for goto if inline int long "
    "register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while "
    "asm typeof main errno NULL EOF INFINITY NAN I complex imaginary bool true false linux unix i386 "
    "sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp log pow sqrt fabs fmin fmax erf floor "
    "ceil fabs isnan isfinite memcpy memset malloc free y0 y1 yn j0 j1 jn gamma".split()
)
TEMPORARIES = re.compile(r"[cz]_\d+|(?i:em)_.*|model_.*|EIGENMOTION_H")
MACROS = re.compile(r"(DBL|FLT|LDBL|DECIMAL|FP|MATH|HUGE|EXIT|RAND|MB|M)_\w+|math_errhandling")
"""Of the C library: replaced wherever they stand, also where a variable has the name."""
INNER = frozenset("i j k L r sum row column product stretch turn".split())
"""What templates declare in inner scopes only: a user's symbol of that name is not needed there."""
COMMENT = re.compile(r"/\*.*?\*/|\{#.*?#\}", re.DOTALL)
NUMBERED = re.compile(r"(\w+)\{\{ \w+\.number \}\}(\w*)")
MEMBER = re.compile(r"(\.|->)\w+")
HOLE = re.compile(r"\{\{.*?\}\}|\{%.*?%\}", re.DOTALL)


@cache
def _of_templates() -> tuple[frozenset[str], re.Pattern[str]]:
    """Return the identifiers in the templates, and a pattern of those that carry the number of a block."""
    texts = [path.read_text(encoding="utf-8") for path in files("eigenmotion.templates").iterdir()
             if path.name.endswith(".c.jinja")]  # fmt: skip
    bare = [COMMENT.sub(" ", text) for text in texts]
    numbered = {match.groups() for text in bare for match in NUMBERED.finditer(text)}
    plain = (MEMBER.sub(" ", HOLE.sub(" ", NUMBERED.sub(" ", text))) for text in bare)
    words = {word for text in plain for word in re.findall(r"[A-Za-z_]\w*", text)}
    patterns = sorted(rf"{re.escape(before)}\d+{re.escape(after)}" for before, after in numbered)
    return frozenset(words - INNER), re.compile("|".join(patterns))


def is_reserved(identifier: str) -> bool:
    """Whether generated code uses an identifier for something of its own."""
    words, numbered = _of_templates()
    return (
        identifier in C_WORDS
        or identifier in words
        or keyword.iskeyword(identifier)
        or TEMPORARIES.fullmatch(identifier) is not None
        or MACROS.fullmatch(identifier) is not None
        or numbered.fullmatch(identifier) is not None
    )
