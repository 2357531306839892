"""The ABI of `eigenmotion.h`, and every other place that states it: declarations for Cython, tests, methods."""

import ctypes as ct
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from eigenmotion.arguments.methods import METHODS, STEPPED
from eigenmotion.runtime import StopReason
from eigenmotion.runtime.status.stop_reasons import Detail
from eigenmotion.simulation.initial_state import consistency

from ..support.stepping import COMPILER, INCLUDE
from ..support.structures import KINDS, NUMBERS, enumerators

RUNTIME = INCLUDE.parent
HEADERS = (
    "stddef.h",
    "eigenmotion.h",
    "loop/em_start_check.h",
    "kinematics/em_forward_kinematics.h",
    "batch/em_lane_scheduler.h",
    "tableaux/em_butcher.h",
)


def refused(folder: Path, *lines: str) -> str:
    """What the compiler says against some lines after the headers; "" where nothing."""
    source = folder / "claims.c"
    source.write_text("\n".join([*(f"#include <{name}>" for name in HEADERS), *lines, ""]), encoding="utf-8")
    command = [*COMPILER, "-std=gnu11", "-fsyntax-only", f"-I{INCLUDE}", str(source)]
    return subprocess.run(command, capture_output=True, text=True, check=False).stderr


def statements() -> Iterator[tuple[int, str]]:
    """(indentation, text) of every declaration of the files of declarations, on one line each."""
    held = ""
    for name in ("abi.pxd", "start.pxd", "kinematics.pxd", "ensemble.pxd"):
        for line in (RUNTIME / name).read_text(encoding="utf-8").splitlines():
            held = f"{held} {line.strip()}" if held else line.rstrip()
            if held.count("(") == held.count(")"):
                yield len(held) - len(held.lstrip()), held.strip().replace(" noexcept nogil", "")
                held = ""


def claims() -> Iterator[str]:
    """All that they say, as C that does not compile where it is not so."""
    of, kind = "", ""
    for depth, text in statements():
        if found := re.fullmatch(r"ctypedef (struct|enum) (\w+):", text):
            kind, of = found.groups()
        elif depth == 8 and text == "pass":
            yield f"static const {of} is_{of} = 0;"
        elif depth == 8 and kind == "enum":
            yield f"static const {of} is_{text} = {text};"
        elif depth == 8:
            field = re.findall(r"\(\*(\w+)\)|(\w+)$", text)[0]
            name = "".join(field)
            alone = f"struct said_{of}_{name} {{ {text}; }};"
            types = (f"__typeof__((({one} *)0)->{name})" for one in (of, f"struct said_{of}_{name}"))
            yield f'{alone} _Static_assert(__builtin_types_compatible_p({", ".join(types)}), "{of}.{name}");'
        elif depth == 4:
            yield f"{text};" if "(" in text else f"enum {{ is_{text.split()[-1]} = {text.split()[-1]} }};"


def test_cython_sees_the_structures_that_c_has(tmp_path):
    said = list(claims())
    assert sum("_Static_assert" in line for line in said) > 100
    assert sum("em_start(" in line for line in said) == 1
    assert not refused(tmp_path, *said)


@pytest.mark.parametrize(
    ("right", "wrong"), [("long max_steps", "int max_steps"), ("const double *y_start", "double *y_start")]
)
def test_another_type_is_noticed(tmp_path, right, wrong):
    said = [line.replace(right, wrong) for line in claims()]
    assert right.split()[-1].strip("*") in refused(tmp_path, *said)


def test_tests_see_the_structures_that_c_has(tmp_path):
    said = []
    for name, made in KINDS.items():
        if issubclass(made, ct.Structure):
            said.append(f'_Static_assert(sizeof({name}) == {ct.sizeof(made)}, "{name}");')
            said += [
                f'_Static_assert(offsetof({name}, {field}) == {getattr(made, field).offset}, "{name}.{field}");'
                for field, _ in made._fields_
            ]
    said += [f'_Static_assert({name} == {number}, "{name}");' for name, number in NUMBERS.items()]
    assert len(said) > 80
    assert not refused(tmp_path, *said)


def test_compiled_methods_have_the_numbers_of_the_abi():
    found = {f"EM_{name.upper()}": method.number for name, method in STEPPED.items()}
    assert found == enumerators("em_method")


def test_reasons_stand_in_the_order_of_the_abi():
    assert [f"EM_{reason.name}" for reason in StopReason] == list(enumerators("em_status"))


def test_details_of_reasons_are_those_of_the_abi():
    assert {f"EM_{detail.name}": detail for detail in Detail} == enumerators("em_detail")


@pytest.mark.parametrize("method", METHODS)
def test_every_method_has_a_case_of_its_own(method):
    """A number without one would run nothing."""
    assert f"case EM_{method.upper()}:" in (INCLUDE / "methods/em_methods.h").read_text(encoding="utf-8")


def test_refusals_of_starts_are_those_of_c():
    text = (
        (INCLUDE / "loop/em_start_check.h")
        .read_text(encoding="utf-8")
        .partition("EM_MAY_START = 0,")[2]
        .partition("}")[0]
    )
    assert re.findall(r"EM_(\w+)", text) == [refusal.name for refusal in consistency._Refusal]


SAID_TWICE = {
    "dynamics/em_close_eigenvalues.h EM_EPSILON": consistency._CLOSE,
}


@pytest.mark.parametrize("name", SAID_TWICE)
def test_starts_are_judged_as_compiled_runs_are(name):
    header, constant = name.split()
    text = (INCLUDE / header).read_text(encoding="utf-8")
    found = re.search(rf"(?:#define {constant} |\b{constant} = )([-+.\de]+)", text)
    assert found is not None
    assert float(found[1]) == SAID_TWICE[name]
