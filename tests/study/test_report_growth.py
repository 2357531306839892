"""benchmarks/growth.py, behind the section "Growth with the number of coordinates" of docs/report.md."""

import re
import shutil
import subprocess
import sys
from math import comb
from pathlib import Path

import pytest
from eigenmotion.codegen.choices import FORMULATIONS, Choices
from eigenmotion.codegen.compiler import explain

import eigenmotion as em
from eigenmotion.building.operation_count import operations_in

pytestmark = pytest.mark.nightly

ROOT = Path(__file__).parents[2]
BY_HAND = """
#include "eigenmotion.h"
#include <math.h>
enum { N_STATE = 6 };
static const double none[1] = {0.0};
static int prepare(const double *parameters, double *c, em_fault *fault) { c[0] = 2.0*3.0; return 0; }
static int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    for (int i = 0; i < N_STATE; ++i) y[i] = sqrt(1.0 + i);
    return 0;
}
static int model_rhs(int mode, double t, const double *y, const double *c, const double *u, const double *memory,
                     int flags, double *restrict dy, em_fault *fault)
{
    for (int i = 0; i < N_STATE; ++i) {
        dy[i] = sqrt(y[i]);
        for (int j = 0; j < i; ++j) dy[i] += y[i]*dy[j];
    }
    if (dy[0] > 0.0) dy[0] = -dy[0]/c[0];
    return 0;
}
const em_model by_hand_model = {
    .n_state = N_STATE, .n_prepared = 1, .parameter_defaults = none, .input_defaults = none, .initial_x = none,
    .initial_v = none, .prepare = prepare, .state = state,
};
"""


@pytest.fixture(scope="module")
def printed() -> str:
    command = [sys.executable, "benchmarks/growth.py", "chain", "--most", "3"]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout


def column(printed: str, n: int, title: str) -> list[str]:
    """Return the cells of the formulations."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in printed.splitlines() if line[:1] == "|"]
    (found,) = [row for row in rows if row[0] == str(n)]
    return found[rows[0].index(title)].split(" / ")


def test_every_formulation_gets_to_the_error(printed):
    for n in (2, 3):
        assert column(printed, n, "states") == [str(2 * n + n * (n + 1)), *[str(2 * n)] * 3]
        for title in ("ns", "right-hand sides to 1e-06", "ms to 1e-06", "s to build"):
            assert all(float(cell) > 0 for cell in column(printed, n, title)), title


needs_a_counter = pytest.mark.skipif(shutil.which("clang++") is None, reason="operations are counted by clang++")


@needs_a_counter
def test_operations_are_counted_as_they_are_executed(tmp_path):
    """Of code by hand: loops count as often as they run; what comes before a right-hand side, or compares, does not."""
    (tmp_path / "by_hand.c").write_text(BY_HAND)
    products_and_sums, roots, division = 2 * 6 * 5 // 2, 6, 1
    assert operations_in("by_hand", tmp_path) == products_and_sums + roots + division


@needs_a_counter
@pytest.mark.parametrize("n", [2, 3])
def test_operations_are_those_of_the_equations(printed, n):
    """Of lagrange, by hand: the terms of the model, M = L D L^T, and L^-T D^-1 L^-1 f."""
    text = explain(em.load_model(ROOT / "models" / "chain.py", n=n), Choices("lagrange"))
    (line,) = re.findall(r"^  lagrange: (.*)$", text, re.M)
    terms = sum(map(int, re.findall(r"\d+", line)))
    products = 2 * (comb(n, 2) + comb(n, 3))  # each with its subtraction, of the pivots and of the entries below
    pivots = n + n + n + comb(n, 2)  # the least allowed, 1 / D, times 1 or NaN, L
    solves = 2 * 2 * comb(n, 2) + n
    assert column(printed, n, "operations")[2] == str(terms + products + pivots + solves)


def test_it_says_who_is_quickest(printed):
    for name in FORMULATIONS:
        assert re.search(rf"^- `{name}`: .*quickest", printed, re.M)
    quickest = re.findall(r": quickest at n = ([\d, ]+)", printed)
    assert sorted(int(n) for text in quickest for n in text.split(",") if n.strip()) == [2, 3]
