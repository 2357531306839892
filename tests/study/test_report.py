"""`eigenmotion report`: what it measures of the paper's mechanism, what it writes and advises; and its command."""

import csv
import io
import json
import re
from contextlib import redirect_stdout
from dataclasses import replace
from types import SimpleNamespace
from xml.etree import ElementTree

import mpmath
import numpy as np
import pytest
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.codegen.model import ModelError
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.cli import main
from eigenmotion.cli.simulation import report as cli
from eigenmotion.report import Budget, Findings, Measurement, ReportOptions, examine
from eigenmotion.report.output import recommendation
from eigenmotion.report.recommend import recommend
from eigenmotion.report.solvers import IMPLICIT, METHODS

from ..oracles.published import DUAL_LINK_X
from ..support.generation import model_of, system_of
from ..support.models_table import MODELS
from .measuring import undisturbed

EXACT = np.array(DUAL_LINK_X, dtype=np.longdouble).astype(float)
TOLERANCES = tuple(10.0**-k for k in range(4, 13))
PENDULUM = str(MODELS / "pendulum.py")


@pytest.fixture(scope="module")
def progress() -> list[tuple[float, str]]:
    return []


@pytest.fixture(scope="module")
def found(progress) -> Findings:
    """A reduced matrix on the paper's mechanism, over its 10 s; nothing is skipped on a slow machine."""
    with undisturbed() as patch:  # times are compared with SciPy's only
        patch.setattr("eigenmotion.report.peers.DECADES", (1e-6, 1e-8, 1e-10))
        patch.setattr("eigenmotion.report.peers._TAYLOR_TOLERANCES", (1e-8,))
        patch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", tuple(10.0**-k for k in range(4, 9)))
        for name in ("SLOW", "_TURN"):  # every run is timed as slow ones are: three times
            patch.setattr(f"eigenmotion.report.measure.{name}", 0.0)
        ask = ReportOptions(error=1e-8, t_end=10.0, tolerances=TOLERANCES, budget=Budget(np.inf, rounds=3))
        return examine(model_of("dual_link"), ask, lambda done, what: progress.append((done, what)))


def test_the_reference_is_the_certified_motion(found):
    np.testing.assert_allclose(found.reference.x[-1], EXACT, rtol=0, atol=1e-15)
    assert found.reference.errors.max() < 1e-14


def test_peers_that_are_installed_find_the_motion(found):
    by_family = {m.family: m for m in found.measurements if m.tolerance == 1e-8}
    assert {"SciPy", "eigenmotion"} <= by_family.keys()
    for measurement in by_family.values():
        assert measurement.message == ""
        assert measurement.error_max < 1e-4


def assert_sound(m: Measurement) -> None:
    assert m.message == ""
    assert 0 < m.error_end <= m.error_max
    assert m.seconds_low <= m.seconds <= m.seconds_high
    assert m.repeats >= 3
    assert m.nfev > m.nsteps > 0
    assert m.constraint_violation < 1e-14
    assert m.energy_integral < 1e3 * m.error_max


def test_every_formulation_method_and_tolerance_is_there(found):
    ours = [m for m in found.measurements if m.family == "eigenmotion" and m.method in METHODS]
    assert {(m.formulation, m.method) for m in ours} == {(f, m) for f in FORMULATIONS for m in METHODS}
    assert {m.tolerance for m in ours} == set(TOLERANCES)
    for m in ours:
        assert_sound(m)
        assert m.position_violation is None
        assert (m.factor_residual is None) == (m.formulation != "eigenfactor")


def test_every_implicit_method_is_there_once(found):
    ours = [m for m in found.measurements if m.family == "eigenmotion" and m.method in IMPLICIT]
    assert {m.formulation for m in ours} == {"lagrange"}
    assert {m.method for m in ours} == set(IMPLICIT)
    for m in ours:
        assert_sound(m)


@pytest.mark.parametrize(
    ("formulation", "method", "rtol"), [("eigenfactor", "dop853", 1e-7), ("lagrange", "radau5", 1e-6)]
)
def test_the_error_at_the_end_is_that_of_a_run(found, formulation, method, rtol):
    (m,) = [m for m in found.measurements if m.label == f"{formulation} {method}" and m.tolerance == rtol]
    run = system_of("dual_link", formulation).simulate((0, 10), rtol=rtol, atol=rtol, method=method)
    assert m.error_end == pytest.approx(np.max(np.abs(run.x[:, -1] - EXACT) / (1 + np.abs(EXACT))), rel=1e-3)
    if method == "dop853":
        assert (m.nfev, m.nsteps) == (run.nfev, run.nsteps)


SCATTER = {"ra15": (5.0, 5.0)}
"""Of a fitted order, below and above. Nine decades of tolerance are some 15 to 60 steps by nodes, and from one to the
next the slope is anything between 4 and 34, since the error at so few steps is a matter of where they end;
`test_gauss_radau` sees the order at steps of one size."""


def test_curves_slope_as_the_orders_say(found):
    ours = [c for c in found.curves if c.family == "eigenmotion"]
    (radau,) = [c for c in ours if c.method == "radau5"]
    assert 4 < radau.order(found.floor) < 6
    orders = {c.label: c.order(found.floor) for c in ours if not c.is_implicit}
    assert len(orders) == len(FORMULATIONS) * len(METHODS)
    for label, order in orders.items():
        method = label.split()[1]
        below, above = SCATTER.get(method, (0.5, 1.5))
        assert METHODS[method] - below < order < METHODS[method] + above, label


def test_progress_runs_from_start_to_end(found, progress):
    done = [fraction for fraction, _ in progress]
    assert done == sorted(done)
    assert 0 <= done[0] < 0.1
    assert 0.8 < done[-1] <= 1


def test_the_recommendation_is_the_soonest_of_all(found):
    chosen = found.recommendation.chosen
    assert chosen.error_max <= 1e-8
    able = [p for c in found.curves if c.family == "eigenmotion" for p in c.reaching(1e-8)]
    assert chosen in able
    assert chosen.seconds == min(p.seconds for p in able)


def test_times_that_spread_are_said_to(found):
    def said(high: float) -> bool:
        chosen = replace(found.recommendation.chosen, seconds_low=1.0, seconds=1.1, seconds_high=high)
        words = recommendation(replace(found, recommendation=replace(found.recommendation, chosen=chosen)))
        return any("Measure again on a quiet one" in sentence for sentence in words)

    assert said(1.5)
    assert not said(1.2)


@pytest.fixture(scope="module")
def called(found, tmp_path_factory) -> SimpleNamespace:
    """What the command asked for, said and wrote, given what was found."""
    pytest.importorskip("matplotlib")
    asked, said, folder = [], io.StringIO(), tmp_path_factory.mktemp("report") / "out"
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(said):
        patch.setattr(cli, "examine", lambda model, ask, progress: asked.append((model.name, ask)) or found)
        model = str(MODELS / "dual_link.py")
        assert main(["report", model, "-o", str(folder), "--error", "1e-6", "--t-end", "3"]) == 0
    return SimpleNamespace(asked=asked, said=said.getvalue(), folder=folder)


@pytest.fixture(scope="module")
def folder(called):
    return called.folder


def test_the_files(folder):
    names = {path.name for path in folder.iterdir()}
    pictures = {f"dual_link_{kind}.{ending}" for kind in ("time", "order") for ending in ("png", "svg")}
    assert names == {"report.html", "report.json", "report.csv", *pictures}
    for name in pictures:
        content = (folder / name).read_bytes()
        assert content.startswith(b"\x89PNG" if name.endswith("png") else b"<svg")
        if name.endswith("svg"):
            ElementTree.fromstring(content.decode())


def test_the_numbers_as_json(folder, found):
    text = (folder / "report.json").read_text()
    (model,) = json.loads(text, parse_constant=pytest.fail)["models"]
    assert model["name"] == "dual_link"
    assert model["reference"]["x_end"] == pytest.approx(EXACT, abs=1e-15)
    assert {built["formulation"] for built in model["formulations"]} == set(FORMULATIONS)
    assert all(built["compilation_seconds"] > 0 and built["left_out"] for built in model["formulations"])
    assert len(model["measurements"]) == len(found.measurements)
    needed = {"error_end", "error_max", "seconds", "seconds_low", "seconds_high", "nfev", "nsteps",
              "constraint_violation", "energy_integral", "factor_residual", "ns_per_rhs"}  # fmt: skip
    assert all(needed <= measurement.keys() for measurement in model["measurements"])
    assert model["recommendation"]["chosen"]["error_max"] <= 1e-8
    ratios = {c["label"]: c["seconds_to_reach"] for c in model["curves"]}
    assert ratios["SciPy DOP853"]["1e-06"] > 10 * ratios["eigenfactor dop853"]["1e-06"]


def test_the_numbers_as_csv(folder, found):
    rows = list(csv.DictReader(io.StringIO((folder / "report.csv").read_text())))
    assert len(rows) == len(found.measurements)
    for row, m in zip(rows, found.measurements, strict=True):
        assert (row["model"], row["label"]) == ("dual_link", m.label)
        assert float(row["error_max"]) == m.error_max
        assert float(row["seconds"]) == m.seconds


def test_the_page_needs_nothing_else(folder):
    page = (folder / "report.html").read_text()
    assert page.count("<svg") == 2 * 4  # charts, each wide and narrow, with few and with all curves
    addresses = re.findall(r'(?:src|href)\s*=\s*"([^"]*)"', page)
    assert all(address.startswith("#") for address in addresses)
    assert "@import" not in page
    assert "url(http" not in page
    assert "do not couple" in page  # what was left out
    assert "None" not in page
    assert "measured once, with lagrange" in page
    assert "the model's own" in page.replace("&#39;", "'")
    assert "nan" not in re.sub(r"<svg.*?</svg>", "", page, flags=re.DOTALL).lower().split()
    for sentence in recommendation_words(page):
        assert sentence


def recommendation_words(page: str) -> list[str]:
    advice = re.search(r'<div class="advice">(.*?)</div>', page, flags=re.DOTALL)
    assert advice
    return re.findall(r"<p>(.*?)</p>", advice[1])


def test_nothing_tells_whose_machine_it_was(folder):
    home = str(MODELS.parent)
    for path in folder.iterdir():
        assert home.encode() not in path.read_bytes()


def test_the_advice_in_words(found):
    words = " ".join(recommendation(found))
    chosen = found.recommendation.chosen
    assert f"formulation {chosen.formulation}, method {chosen.method}, rtol = atol = {chosen.tolerance:.1e}" in words
    assert "SciPy DOP853" in words
    assert "Caution" not in words
    vague = replace(found, reference=replace(found.reference, errors=found.reference.errors + 1e-7))
    assert "Caution" in " ".join(recommendation(vague))
    hopeless = replace(found, recommendation=recommend(found.curves, 1e-30))
    assert "No run reaches" in " ".join(recommendation(hopeless))


def test_the_command_writes_and_advises(called, found):
    assert called.asked == [("dual_link", ReportOptions(error=1e-6, t_end=3.0))]
    chosen = recommendation(found)
    first, *rest = called.said.splitlines()
    assert first == f"dual_link: {chosen[0]}"
    assert len(first) < 120
    assert [line.strip() for line in rest[:-1]] == list(chosen[1:])
    assert (called.folder / "report.html").is_file()


def test_the_advice_on_several_models_is_printed_first(found, monkeypatch, capsys, tmp_path):
    drawn = []
    monkeypatch.setattr(
        cli, "examine", lambda model, ask, progress: replace(found, subject=SimpleNamespace(model=model))
    )
    monkeypatch.setattr(
        cli, "write_report", lambda reports, folder, everything: drawn.append(everything) or (folder / "report.html",)
    )
    models = [PENDULUM, str(MODELS / "double_pendulum.py")]
    assert main(["report", *models, "--all", "-o", str(tmp_path)]) == 0
    first, second, third, *_ = capsys.readouterr().out.splitlines()
    advice = recommendation(found)[0]
    assert [first, second, third] == [f"pendulum: {advice}", f"double_pendulum: {advice}", "pendulum:"]
    assert drawn == [True]


def test_the_command_sets_arguments_of_models(found, monkeypatch, tmp_path, capsys):
    names = []
    monkeypatch.setattr(cli, "examine", lambda model, ask, progress: names.append(model.name) or found)
    monkeypatch.setattr(cli, "write_report", lambda reports, folder, everything: (folder / "report.html",))
    assert main(["report", str(MODELS / "chain.py"), "-D", "n=2", "-o", str(tmp_path)]) == 0
    assert names == [em.load_model(MODELS / "chain.py", n=2).name]


def test_the_command_sets_parameters_and_starts(found, monkeypatch, tmp_path):
    asked = []
    monkeypatch.setattr(cli, "examine", lambda model, ask, progress: asked.append(ask.settings) or found)
    monkeypatch.setattr(cli, "write_report", lambda reports, folder, everything: (folder / "report.html",))
    monkeypatch.setattr(cli, "recommendation", lambda found: ("",))
    settings = ["--set", "k=2e3", "--set", "theta=0.25", "--set", "theta'=1", "--set", "r'=-1"]
    assert main(["report", str(MODELS / "elastic_pendulum.py"), *settings, "-o", str(tmp_path)]) == 0
    assert asked == [{"parameters": {"k": 2e3}, "x0": {"theta": 0.25}, "v0": {"theta": 1.0, "r": -1.0}}]


def test_settings_reach_every_run_and_the_reference(monkeypatch):
    """A pendulum of another length let go elsewhere: every measurement agrees with its closed form."""
    monkeypatch.setattr("eigenmotion.report.formulations.FORMULATIONS", ("eigenfactor",))
    monkeypatch.setattr("eigenmotion.report.peers.DECADES", (1e-8,))
    monkeypatch.setattr("eigenmotion.report.peers._TAYLOR_TOLERANCES", (1e-8,))
    monkeypatch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", (1e-8,))
    settings = {"parameters": {"l": 0.4}, "x0": {"theta": 1.0}}
    ask = ReportOptions(t_end=2.0, tolerances=(1e-8,), settings=settings, budget=Budget(rounds=1))
    made = examine(model_of("pendulum"), ask, lambda done, what: None)
    k, w = mpmath.sin(mpmath.mpf(0.5)), mpmath.sqrt(mpmath.mpf(9.81) / mpmath.mpf(0.4))
    exact = float(2 * mpmath.asin(k * mpmath.ellipfun("cd", 2 * w, k=k)))
    assert made.reference.x[-1, 0] == pytest.approx(exact, abs=1e-14)
    assert made.start.tolist() == [1.0, 0.0]
    assert all(m.message == "" and m.error_max < 1e-4 and m.energy_integral < 1e-4 for m in made.measurements)


@pytest.mark.parametrize("arguments", [
    [], ["nowhere.py"], ["--paper", "--set", "l=1"], [PENDULUM, "--error", "0"], [PENDULUM, "--t-end", "-1"],
    [PENDULUM, "--set", "gee=1"], [PENDULUM, "--set", "l=long"],
])  # fmt: skip
def test_mistakes_in_the_call(arguments, capsys):
    assert main(["report", *arguments]) == 2
    assert capsys.readouterr().err


def test_a_run_that_cannot_get_to_the_end_is_a_mistake(monkeypatch):
    monkeypatch.setattr("eigenmotion.report.formulations.FORMULATIONS", ("lagrange",))
    theta = dynamicsymbols("theta")
    falling = em.Model(name="falling", coordinates=[theta], kinetic_energy=theta.diff() ** 2 / 2,
                       potential_energy=-1 / theta, initial={theta: 1})  # fmt: skip
    with pytest.raises(ModelError, match="--t-end"):
        examine(
            falling,
            ReportOptions(t_end=10.0, tolerances=(1e-6,), budget=Budget(np.inf, rounds=3)),
            lambda done, what: None,
        )
