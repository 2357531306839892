"""The matrix of stiff and extreme cases: no cell is wrong, and planted faults are."""

import json
import pickle
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.render.emit import SourceFile, Sources
from eigenmotion.models import chain as chain_model

from eigenmotion import Model, build
from eigenmotion.building.build import all_of
from eigenmotion.building.request import request
from eigenmotion.building.shared_library import load
from eigenmotion.building.toolchain import toolchain
from eigenmotion.reference.collocation import Collocation
from eigenmotion.reference.extended_precision import EPSILON
from eigenmotion.reference.integration import NotReachedError, integrate_graded
from eigenmotion.stability import CASES, Matrix, Outcome, Variant, described, examine, survey, write_matrix
from eigenmotion.stability.cases.case import EXPLICIT
from eigenmotion.stability.cases.variants import EXTRAPOLATE, PLAIN, UNSTABILISED
from eigenmotion.stability.evaluation import matrix
from eigenmotion.stability.evaluation.expected_rows import expected_of
from eigenmotion.stability.evaluation.outcome import classify
from eigenmotion.stability.expectation.closed_forms import chain
from eigenmotion.stability.expectation.truth import FINE, lagrange
from eigenmotion.stability.models.smooth import elastic_link
from eigenmotion.system.system import System

EIGENFACTOR = Variant("eigenfactor")


HARD = [name for name, case in CASES.items() if case.reduced]
BY_DAY = {"damped_spring": PLAIN[::2], "gap": (*PLAIN[:2], EXTRAPOLATE, UNSTABILISED)}


@pytest.fixture(scope="module", params=["day", pytest.param("night", marks=pytest.mark.nightly)])
def reduced(request: pytest.FixtureRequest) -> Matrix:
    """A few points of the cases that were found hardest; what users compile with is in `test_default_flags`."""
    return by_day() if request.param == "day" else surveyed(HARD, workers=2)


def by_day() -> Matrix:
    """The last points of two cases, in turn and by a pool, here of a thread; what takes too many steps takes few.

    By few formulations and options: all of them by night, and in processes, which take seconds to start.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("eigenmotion.stability.evaluation.matrix.Pool", lambda _: ThreadPoolExecutor(1))
        for name, variants in BY_DAY.items():
            case = CASES[name]
            fewer = replace(case, reduced=case.reduced[-1:], max_steps=case.max_steps // 100, variants=variants)
            patch.setitem(CASES, name, fewer)
        first, second = (surveyed([name], workers) for workers, name in enumerate(BY_DAY, start=1))
    return replace(first, points=first.points + second.points)


def surveyed(names: list[str], workers: int) -> Matrix:
    return survey(names, workers, progress=lambda done, what: None, reduced=True)


def test_no_cell_is_wrong(reduced: Matrix):
    wrong = [described(cell) for cell in reduced.cells if cell.outcome is Outcome.WRONG]
    assert not wrong
    assert reduced.count(Outcome.RIGHT) > 0.6 * len(reduced.cells)


def test_processes_can_hand_over_what_is_asked_and_found(reduced: Matrix):
    asked = pickle.dumps((matrix._build, matrix._examine, "gap", 0.0, EXTRAPOLATE))
    assert pickle.loads(asked)[:2] == (matrix._build, matrix._examine)
    assert [cell.outcome for cell in pickle.loads(pickle.dumps(reduced)).cells] == [c.outcome for c in reduced.cells]


def test_what_is_refused_has_a_named_reason_and_words(reduced: Matrix):
    refused = [cell for cell in reduced.cells if cell.outcome is Outcome.REFUSED]
    assert refused
    assert all(cell.reason and len(cell.message) > 40 for cell in refused)


def test_references_are_better_than_what_is_judged_by_them(reduced: Matrix):
    """Where there is no motion (Painleve's rod), there is none, and all runs are refused."""
    for point in reduced.points:
        if point.how.startswith("none:"):
            assert all(cell.outcome is Outcome.REFUSED for cell in point.cells), point.point
            continue
        bounds = [cell.bound for cell in point.cells if cell.bound]
        assert point.reference_error < 0.1 * min(bounds, default=1.0), point.point


def test_heavily_damped_link_takes_a_stiff_method_few_steps(reduced: Matrix):
    """k = 1e10 N/m, d = 1e6 N s/m."""
    stiff = [c for c in reduced.cells if c.case == "damped_spring" and c.point == "1e10" and c.method not in EXPLICIT]
    assert any(c.error is not None and c.error < 1e-6 and c.nsteps is not None and c.nsteps < 2000 for c in stiff)
    explicit = [c for c in reduced.cells if c.case == "damped_spring" and c.point == "1e10" and c.method in EXPLICIT]
    assert {c.reason for c in explicit} <= {"", "too many steps"}


def test_page_pictures_and_numbers(reduced: Matrix, tmp_path):
    page, *others = write_matrix(reduced, tmp_path)
    html = page.read_text(encoding="utf-8")
    assert "<svg" in html
    assert not any(f'{attribute}="http' in html for attribute in ("src", "href"))
    assert {"stability.json", "stability.png", "stability_gap.svg"} <= {path.name for path in others}
    numbers = json.loads((tmp_path / "stability.json").read_text(encoding="utf-8"))
    assert sum(numbers["outcomes"].values()) == len(reduced.cells)
    assert all(rule in html.replace("&#39;", "'") for rule in numbers["rules"].values())


def test_missing_omega_term_is_found():
    """etadot without - S^-1 Omega S eta (41)."""
    sources = request(elastic_link()).sources()
    term = "em_turning_push(N1, C1, T1, s1, r1, Omega1, "
    without = "static const real still[N1*N1];\n    em_turning_push(N1, C1, T1, s1, r1, still, "
    assert sum(file.text.count(term) for file in sources.files) == 1
    files = tuple(SourceFile(file.name, file.text.replace(term, without)) for file in sources.files)
    assert_found(load(all_of(Sources(sources.name, files), toolchain())))


def test_sign_of_t1_is_found():
    """L = T2 - T1 + T0 - V: the Coriolis force turned round, as with the sign printed in (27)."""
    right = elastic_link()
    T = right.kinetic_energy
    backwards = T.xreplace({rate: -rate for rate in right.rates})
    fields = ("name", "coordinates", "potential_energy", "parameters", "initial", "forces")
    given = {field: getattr(right, field) for field in fields}
    given |= {"parameters": dict(right.parameters), "initial": dict(right.initial)}
    assert sympy.expand(T - backwards) != 0
    assert_found(build(Model(kinetic_energy=sympy.expand(backwards), **given)))


def assert_found(faulty: System) -> None:
    case = replace(CASES["lengths"], variants=(EIGENFACTOR,), tolerances=EXPLICIT)
    outcomes = {cell.method: cell.outcome for cell in examine(case, 1.0, {EIGENFACTOR: faulty}).cells}
    assert outcomes.pop("ra15") in (Outcome.WRONG, Outcome.REFUSED)  # its iteration may notice that something is amiss
    assert outcomes == dict.fromkeys([method for method in EXPLICIT if method != "ra15"], Outcome.WRONG)


def test_rules():
    assert classify(1e-6, 1e-6, 0.0) is Outcome.RIGHT
    assert classify(9e-5, 1e-6, 0.0) is Outcome.DEGRADED
    assert classify(1e-3, 1e-6, 1.0) is Outcome.WRONG
    assert classify(1e-3, 1e-6, 1e-5, periods=1e3) is Outcome.DEGRADED
    assert classify(float("nan"), 1e-6, 1.0, periods=1e3) is Outcome.WRONG


def test_collocation_follows_a_stiff_decay():
    """y' = -1e6 (y - cos t) - sin t from y = 2: cos t + exp(-1e6 t)."""
    times = np.array([0.0, 1e-6, 1e-3, 1.0])
    rows = integrate_graded(Collocation(5), lambda t, y: -1e6 * (y - np.cos(t)) - np.sin(t), np.array([2.0]), times, 16)
    exact = np.cos(times) + np.exp(-1e6 * times)
    assert np.abs(rows[:, 0] - exact).max() < 1e-11


def test_steps_on_a_mesh_do_not_go_on_without_a_solution():
    """y' = y^2 from y = 1 ends at t = 1."""
    with np.errstate(all="ignore"), pytest.raises(NotReachedError, match=r"stopped at t = 0\.9"):
        integrate_graded(Collocation(5), lambda t, y: y**2, np.array([1.0]), np.array([0.0, 2.0]), 8)


def test_chain_by_hand_is_the_chain_of_the_model():
    parameters = {"m_1": 2.0, "m_2": 0.5, "m_3": 1.5, "l_1": 0.7, "l_2": 1.2, "l_3": 0.4}
    masses, lengths = np.array([2.0, 0.5, 1.5]), np.array([0.7, 1.2, 0.4])
    y = np.array([0.3, -1.1, 2.0, 0.5, 1.0, -2.0], dtype=np.longdouble)
    ours, theirs = chain(masses, lengths, 9.81)(0.0, y), lagrange(chain_model.model(3), parameters)(0.0, y)
    assert np.abs(ours - theirs).max() < 1e4 * EPSILON


@pytest.mark.parametrize(("name", "value"), [("polar", 1e-3), ("gimbal", 1e-2), ("long_free", 1e2)])
def test_closed_forms_obey_the_classical_equations(name, value):
    """A short way from the start, against integration in extended precision."""
    case = CASES[name]
    point = case.trial(value)
    n, start = len(point.x0), np.concatenate([point.x0, point.v0])
    times = np.linspace(0.0, 0.4, 5)
    rows = point.truth.rows(start, times, FINE)
    difference = rows - integrate_graded(
        Collocation(5), lagrange(case.model(value), point.parameters), start, times, 16
    ).astype(np.float64)
    whole_turns = np.concatenate([2 * np.pi * np.round(difference[:, :n] / (2 * np.pi)), 0 * difference[:, n:]], axis=1)
    assert np.abs(difference - whole_turns).max() < 1e-11


def test_kappa_is_the_growth_of_an_unstable_equilibrium():
    """Two links upright: kappa grows like exp(w t), w^2 = (2 + sqrt 2) g / l the faster."""
    point = CASES["starts"].trial(3.0)
    fastest = np.exp(np.sqrt((2 + np.sqrt(2)) * 9.81) * 2.0)
    kappa = expected_of(point, None).kappa
    assert 0.05 * fastest < kappa < 20 * fastest
