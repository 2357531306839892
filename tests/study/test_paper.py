"""The paper's experiment: histories against formulas written out here, statements against planted numbers."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from eigenmotion.paper import Verdict, findings, write_figures
from eigenmotion.paper.experiment import MEAN_STEP, Experiment, History, Runs, experiment

L1, L2, L3, K1, K2, K3 = 0.5, 1 / np.sqrt(2), 0.5, 1.0, 1.0, 0.5


@pytest.fixture(scope="module")
def made() -> Experiment:
    return experiment()


@pytest.fixture(scope="module")
def history(made: Experiment) -> History:
    return made.eigenfactor.published


def mass_matrix(theta: np.ndarray) -> np.ndarray:
    """(60) with unit masses."""
    reach, turn = L1 + theta[2], theta[0] - theta[1]
    M = np.diag([2 * reach**2, L2**2, 2.0, L3**2])
    M[0, 1] = M[1, 0] = reach * L2 * np.cos(turn)
    M[1, 2] = M[2, 1] = L2 * np.sin(turn)
    return M


def hand(theta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(56), (57)"""
    reach = L1 + theta[2]
    return reach * np.cos(theta[0]) + L2 * np.cos(theta[1]), reach * np.sin(theta[0]) + L2 * np.sin(theta[1])


def energy(theta: np.ndarray, rates: np.ndarray) -> float:
    """(58) and T = 1/2 xdot^T M xdot"""
    x, y = hand(theta)
    V = K1 * theta[2] ** 2 + K2 * (x**2 + (4 - y) ** 2) + K3 * (theta[3] - theta[0] - np.pi / 2) ** 2
    return float(0.5 * V + 0.5 * rates @ mass_matrix(theta) @ rates)


def axes_of(theta: np.ndarray, like: np.ndarray) -> np.ndarray:
    """Rows: eigenvectors of (60), the largest eigenvalue first, signs as in `like`."""
    C = np.linalg.eigh(mass_matrix(theta))[1].T[::-1]
    return C * np.sign(np.sum(C * like, axis=1))[:, None]


def test_runs_have_the_mean_step_and_nothing_projected(made):
    for runs in (made.eigenfactor, made.inverse):
        assert runs.published.mean_step == pytest.approx(MEAN_STEP, rel=0.005)
        assert runs.projected.mean_step == pytest.approx(MEAN_STEP, rel=0.005)
        assert np.ptp(np.diff(runs.fixed.t)[:-1]) < 1e-12
        assert np.abs(runs.published.solution.constraint_residual).max() > 1e-10
    assert made.eigenfactor.published.solution.n_bounded == 0


def test_eigenvalues_are_those_of_the_mass_matrix(history):
    expected = np.array([np.linalg.eigvalsh(mass_matrix(x))[::-1] for x in history.x.T]).T
    np.testing.assert_allclose(history.eigenvalues, expected, atol=1e-5)


def test_Omega_turns_the_eigenvectors(history):
    h = 1e-5
    for k in range(5, len(history.t), 40):
        x, v = history.x[:, k], history.solution.v[:, k]
        C = axes_of(x, history.solution.C[[2, 1, 3, 0], :, k])
        rate = (axes_of(x + h * v, C) - axes_of(x - h * v, C)) / (2 * h)
        np.testing.assert_allclose(history.Omega[:, :, k], -rate @ C.T, atol=2e-5)


def test_violation_and_energy_error_are_those_of_the_formulas(history):
    y = hand(history.x)[1]
    np.testing.assert_allclose(history.violation, np.abs(y - y[0]), atol=1e-15)
    P = np.array([energy(x, v) for x, v in zip(history.x.T, history.solution.v.T, strict=True)])
    error = np.abs(P - P[0])
    expected = np.sum(np.diff(history.t) * (error[1:] + error[:-1])) / 2
    assert history.energy_error[-1] == pytest.approx(expected, rel=1e-3)
    assert history.energy_error[0] == 0.0


def test_what_the_runs_confirm(made):
    said = {finding.statement: finding for finding in findings(made)}
    gap = dict(next(finding for text, finding in said.items() if "0.03" in text).numbers)
    assert gap["gap"] == pytest.approx(0.0305, abs=1e-4)
    block = dict(next(finding for text, finding in said.items() if "become close" in text).numbers)
    assert list(block.values()) == pytest.approx([0.137, 0.251, 0.111], abs=1e-3)
    assert [float(at.removeprefix("at_")) for at in block] == pytest.approx([2.0, 4.25, 6.5], abs=0.06)
    active = dict(next(finding for text, finding in said.items() if "active" in text).numbers)
    assert active == pytest.approx({"first": 2.02, "turns": 4.26, "last": 6.50}, abs=0.1)
    verdicts = [finding.verdict for finding in findings(made)]
    assert verdicts == [Verdict.CONFIRMED] * 7 + [Verdict.NOT_CONFIRMED, Verdict.CONFIRMED]


def test_statements_are_judged_by_the_numbers(made):
    """Exchange the two formulations: the violation is lower then, and nothing is left of the accuracy's loss."""
    brute = replace(made.eigenfactor, published=made.inverse.published)
    exchanged = findings(Experiment(replace(made.eigenfactor, published=brute.published), made.eigenfactor))
    assert exchanged[7].verdict is Verdict.CONFIRMED
    assert exchanged[8].verdict is Verdict.NOT_CONFIRMED


def test_a_crossing_would_be_found(made, history):
    class Crossing(History):
        @property
        def eigenvalues(self) -> np.ndarray:
            crossed = super().eigenvalues.copy()
            crossed[[1, 3], 100:] = crossed[[3, 1], 100:]
            return crossed

    planted = Crossing(history.system, history.solution, history.rtol)
    runs = Runs(planted, made.eigenfactor.fixed, made.eigenfactor.projected)
    assert findings(Experiment(runs, made.inverse))[2].verdict is Verdict.NOT_CONFIRMED


def test_pictures_are_written(tmp_path):
    pytest.importorskip("matplotlib")
    figures = write_figures(tmp_path / "figures")
    assert [path.name for path in figures.paths] == [f"figure_{number}.png" for number in range(2, 9)]
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in figures.paths)
    assert "Figure 7" in str(figures)


def test_some_pictures_only(tmp_path):
    pytest.importorskip("matplotlib")
    assert [path.name for path in write_figures(tmp_path, {3}).paths] == ["figure_3.png"]
    assert [path.name for path in Path(tmp_path).iterdir()] == ["figure_3.png"]
