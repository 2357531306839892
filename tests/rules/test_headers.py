"""Headers that one finds by name: short ones have a reason, and the name of a function belongs to one of them."""

import re
from collections import defaultdict
from pathlib import Path

INCLUDE = Path(__file__).parents[2] / "src" / "eigenmotion" / "runtime" / "include"
HEADERS = sorted(INCLUDE.rglob("*.h"))
SHORT = 40

REASONS = {
    "em_assumptions.h": "units of FMI use it without the rest of a run",
    "em_dense_output.h": "a reader looks for dense output by its name",
    "em_generic_functions.h": "dual numbers and lanes share it",
    "em_jacobi_rotations.h": "eigenfactors of one run and of lanes share it",
    "em_lane_singularity.h": "the monitor beside its scalar twin",
    "em_rate_jacobian.h": "the main program of a unit that is compiled on demand",
    "em_reaction_rates.h": "only models with such states include it",
    "em_required_forces.h": "only models without a recursion include it",
    "em_singularity_limits.h": "the monitors of one run and of lanes share it",
    "em_start_tolerance.h": "four rooms measure starts by it",
    "em_table_ranges.h": "units of FMI use it without the rest of a run",
    "em_undefined.h": "starts and failures share it",
}
"""Why a header of fewer than SHORT lines is a file of its own."""

FOR_LANES = {"em_refresh", "em_sin", "em_cos"}
"""Functions that exist for one run and for lanes, under one name because templates call either."""

FUNCTION = re.compile(r"^(?!return\b|else\b)[\w ]+[ *](em_\w+)\((?:[^;{}()]|\([^()]*\))*\)\s*\{", re.MULTILINE)


def test_a_short_header_has_its_reason():
    short = {header.name for header in HEADERS if len(header.read_text(encoding="utf-8").splitlines()) < SHORT}
    assert short == set(REASONS)


def homes(headers: list[Path]) -> dict[str, set[str]]:
    """Name of each function -> the headers that define it."""
    found = defaultdict(set)
    for header in headers:
        for name in FUNCTION.findall(header.read_text(encoding="utf-8")):
            found[name].add(header.name)
    return found


def test_a_function_has_one_home():
    found = homes(HEADERS)
    assert len(found) > 1000
    assert {name: headers for name, headers in found.items() if len(headers) > 1}.keys() == FOR_LANES


def test_a_function_with_two_homes_is_found(tmp_path):
    for name in "ab":
        (tmp_path / f"{name}.h").write_text("static int em_same(int n, int (*f)(int)) {\n    return f(n);\n}\n")
    assert homes(sorted(tmp_path.glob("*.h"))) == {"em_same": {"a.h", "b.h"}}


MACRO = re.compile(r"^#define (EM_\w+)", re.MULTILINE)
ENUMERATION = re.compile(r"enum(?: \w+)? \{(.*?)\}", re.DOTALL)
CHOSEN = {"EM_OF_REAL"}
"""What means one thing on lanes and another on dual numbers, which are never compiled together."""


def constants(header: Path) -> set[str]:
    """Macros and enumerators of a header, but what keeps it from being included twice."""
    text = re.sub(r"/\*.*?\*/", "", header.read_text(encoding="utf-8"), flags=re.DOTALL)
    entries = ",".join(ENUMERATION.findall(text)).split(",")
    named = {*MACRO.findall(text), *(entry.partition("=")[0].strip() for entry in entries)}
    return {name for name in named if name.startswith("EM_") and not name.endswith("_H")}


def test_a_constant_has_one_home():
    """All headers share one namespace: a macro of the same name is another number for those that come after."""
    found = defaultdict(set)
    for header in HEADERS:
        for name in constants(header):
            found[name].add(header.name)
    assert len(found) > 400
    assert {name: headers for name, headers in found.items() if len(headers) > 1}.keys() == CHOSEN


def test_constants_are_found(tmp_path):
    header = tmp_path / "em_one.h"
    header.write_text("#define EM_ONE_H\n#define EM_A 1.0\nenum { EM_B = EM_A, /* EM_C, */ EM_D };\n")
    assert constants(header) == {"EM_A", "EM_B", "EM_D"}
