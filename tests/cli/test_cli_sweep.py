"""`eigenmotion sweep`: what is swept and drawn, what is stored, and that a sweep that was killed ends the same."""

import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion.batch.sweep import unfinished_store as kept_parts
from eigenmotion.batch.sweep.design import Design, Distribution
from eigenmotion.cli import main
from eigenmotion.progress import duration, words

SWEEP = ["sweep", "scene.py", "--formulation", "lagrange", "--t-end", "1", "--chunk", "7"]
GRID = ["--sweep", "g=1,9.81,20", "--sweep", "angle'=0:2:4", "--sample", "angle=normal(0.5,0.1)", "-n", "3"]


def test_members_are_the_grid_with_every_sample():
    design = Design({"a": [1.0, 2.0], "b": [3.0, 4.0, 5.0]}, {"c": Distribution("uniform", -1.0, 1.0)}, 2, 5)
    found = design.values(0, design.count)
    assert found["a"].tolist() == [1.0] * 6 + [2.0] * 6
    assert found["b"].tolist() == [3.0, 3.0, 4.0, 4.0, 5.0, 5.0] * 2
    assert found["c"].tolist() == found["c"][:2].tolist() * 6


@pytest.mark.parametrize("kind", ["normal", "uniform", "loguniform", "sobol"])
def test_what_is_drawn_follows_from_the_number_of_the_member(kind):
    design = Design({}, {"a": Distribution(kind, 1.0, 2.0), "b": Distribution("sobol", 0.0, 1.0)}, 10_000, 3)
    whole = design.values(0, 10_000)
    pieces = [design.values(start, stop)["a"] for start, stop in [(0, 3000), (3000, 9000), (9000, 10_000)]]
    assert np.array_equal(np.concatenate(pieces), whole["a"])
    expected = {"normal": 1.0, "uniform": 1.5, "sobol": 1.5, "loguniform": 1 / np.log(2)}[kind]
    spread = {"normal": 2.0, "uniform": 12**-0.5, "sobol": 12**-0.5, "loguniform": 0.2871}[kind]
    assert whole["a"].mean() == pytest.approx(expected, abs=4 * spread / 100)
    assert whole["a"].std() == pytest.approx(spread, rel=0.03)
    alone = Design({}, {"a": Distribution(kind, 1.0, 2.0)}, 10_000, 3).values(0, 10_000)["a"]
    assert kind == "sobol" or np.array_equal(alone, whole["a"])
    assert not np.array_equal(Design({}, design.samples, 10_000, 4).values(0, 10_000)["a"], whole["a"])


def files(store: Path) -> dict[str, bytes]:
    """Everything a store is, byte by byte."""
    if store.is_file():
        return {store.name: store.read_bytes()}
    return {str(path.relative_to(store)): path.read_bytes() for path in sorted(store.rglob("*")) if path.is_file()}


def killed_after(parts: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let sweeps die when they have kept so many parts."""
    keep, kept = kept_parts.Parts.write_part, []

    def dying(self, number, arrays):
        if len(kept) == parts:
            raise SystemExit(9)
        kept.append(number)
        keep(self, number, arrays)

    monkeypatch.setattr(kept_parts.Parts, "write_part", dying)


def test_a_sweep_stores_what_simulate_finds(scene, capsys):
    assert main([*SWEEP, *GRID, "--rows", "3", "--set", "m=2", "-o", "runs.npz"]) == 0
    out = capsys.readouterr().out
    assert "36 runs in" in out
    assert "0 failed" in out
    system = em.build(scene, formulation="lagrange")
    with np.load("runs.npz") as found:
        assert found["x"].shape == (36, 1, 3)
        assert found["time"].tolist() == [0.0, 0.5, 1.0]
        for k in (0, 17, 35):
            start = {"x0": {"angle": found["swept_angle"][k]}, "v0": {"angle": found["swept_angle'"][k]}}
            given = {"g": found["swept_g"][k], "m": 2.0}
            alone = system.simulate((0.0, 1.0), **start, parameters=given, t_eval=[0.0, 0.5, 1.0])
            assert np.allclose(found["x"][k], alone.x, rtol=0, atol=1e-12)
            assert np.allclose(found["energy"][k], alone.energy, rtol=1e-12)


@pytest.mark.parametrize(
    "ending", ["csv", "nc", *(pytest.param(one, marks=pytest.mark.nightly) for one in ("npz", "zarr"))]
)
def test_a_sweep_that_was_killed_ends_with_the_same_bytes(scene, capsys, monkeypatch, ending):
    if ending in ("nc", "zarr"):
        pytest.importorskip("xarray")
    if ending == "zarr":
        pytest.importorskip("zarr")
    assert main([*SWEEP, *GRID, "-o", f"whole.{ending}"]) == 0
    with monkeypatch.context() as patch:
        killed_after(2, patch)
        with pytest.raises(SystemExit):
            main([*SWEEP, *GRID, "-o", f"runs.{ending}"])
    assert not Path(f"runs.{ending}").exists()
    assert main([*SWEEP, *GRID, "-o", f"runs.{ending}"]) == 2
    assert "--resume goes on" in capsys.readouterr().err
    assert main([*SWEEP, *GRID, "--seed", "1", "-o", f"runs.{ending}", "--resume"]) == 2
    assert "another sweep" in capsys.readouterr().err
    assert main([*SWEEP, *GRID, "-o", f"runs.{ending}", "--resume", "--workers", "2"]) == 0
    assert list(files(Path(f"runs.{ending}")).values()) == list(files(Path(f"whole.{ending}")).values())
    capsys.readouterr()
    assert main([*SWEEP, *GRID, "-o", f"runs.{ending}", "--resume"]) == 0
    assert "is complete" in capsys.readouterr().out
    assert not list(Path().glob(".runs.*"))


@pytest.mark.parametrize(("given", "words"), [("m=nan", "'m'"), ("theta=1", "theta")])
def test_a_sweep_that_is_refused_leaves_nothing_behind(scene, capsys, given, words):
    assert main([*SWEEP, *GRID, "--set", given, "-o", "runs.csv"]) == 2
    assert words in capsys.readouterr().err
    assert not list(Path().glob(".runs.*"))


def test_failures_are_summed_up(scene, capsys):
    assert main([*SWEEP, "--sweep", "m=1,-1,2,-2,-3,-4", "-o", "runs.csv"]) == 0
    out = capsys.readouterr().out
    assert "6 runs in" in out
    assert "4 failed" in out
    assert "4 start refused  (run 1, 3, 4, ...)" in out
    lines = Path("runs.csv").read_text().splitlines()
    assert lines[0] == "run,m,t,angle,angle',energy,t_end,stop"
    assert lines[2] == "1,-1.0,1.0,nan,nan,nan,0.0,start refused"


@pytest.mark.parametrize("sweep", [["--sweep", "g=1,2", "--sweep", "m=1,2"], ["--sweep", "g=1,2", "--rows", "5"],
                                   ["--sample", "g=uniform(1,2)", "-n", "3"]])  # fmt: skip
def test_a_sweep_is_drawn(scene, sweep):
    pytest.importorskip("matplotlib")
    assert main([*SWEEP, *sweep, "-o", "runs.csv", "--plot", "spread.png"]) == 0
    assert Path("spread.png").stat().st_size > 5000


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "nothing is swept"),
        (["--sweep", "h=1,2"], "--sweep, --sample h: not known to swing1"),
        (["--sweep", "g=1:2"], "expected A:B:K"),
        (["--sweep", "g=1:2:0"], "there must be values"),
        (["--sweep", "g=nan"], "finite"),
        (["--sample", "g=normal(1,2)"], "give both"),
        (["--sweep", "g=1", "-n", "3"], "give both"),
        (["--sample", "g=cauchy(1,2)", "-n", "3"], "unknown distribution 'cauchy'"),
        (["--sample", "g=normal(1,-2)", "-n", "3"], "deviation"),
        (["--sample", "g=normal(1)", "-n", "3"], "expected one of"),
        (["--sample", "g=uniform(1,2)", "-n", "3", "--sweep", "g=1"], "swept and sampled"),
        (["--sweep", "g=1", "-o", "runs.doc"], "known endings"),
        (["--sweep", "g=1", "-o", "nowhere/runs.csv"], "no folder nowhere"),
        (["--sweep", "g=1", "--workers", "2", "--scheduler", "tcp://x"], "give one of them"),
    ],
)
def test_mistakes_are_told_before_anything_runs(scene, capsys, arguments, words):
    assert main([*SWEEP, "-o", "runs.csv", *arguments]) == 2
    assert words in capsys.readouterr().err
    assert not Path("runs.csv").exists()


def test_progress_says_the_time_left():
    assert words(0.6, "6 of 10 runs", 6.0) == "60 %, 6 of 10 runs, 4.0 s left"
    assert [words(done, "runs", 6.0) for done in (0.0, 1.0)] == ["0 %, runs", "100 %, runs"]
    assert [duration(seconds) for seconds in (2.34, 42, 125, 7325)] == ["2.3 s", "42 s", "2 min 5 s", "2 h 2 min"]


@pytest.mark.nightly
def test_a_sweep_killed_twenty_times_ends_with_the_same_bytes(scene):
    long = [*SWEEP, "--sweep", "g=1:20:4000", "--t-end", "100", "--rtol", "1e-9", "--chunk", "50", "--workers", "1"]
    assert main([*long, "-o", "whole.csv"]) == 0
    dice, kills = random.Random(4), 0
    while kills < 20:
        run = subprocess.Popen([sys.executable, "-m", "eigenmotion", *long, "-o", "runs.csv", "--resume"])
        time.sleep(1.0 + 0.5 * dice.random())
        kills += run.poll() is None
        run.kill()
        run.wait()
        if Path("runs.csv").exists():
            assert files(Path("runs.csv"))["runs.csv"] == files(Path("whole.csv"))["whole.csv"]
            Path("runs.csv").unlink()
    assert main([*long, "-o", "runs.csv", "--resume"]) == 0
    assert files(Path("runs.csv"))["runs.csv"] == files(Path("whole.csv"))["whole.csv"]


@pytest.mark.nightly
@pytest.mark.filterwarnings("ignore")
def test_a_cluster_stores_the_same_bytes(scene, tmp_path):
    distributed = pytest.importorskip("distributed")
    assert main([*SWEEP, *GRID, "-o", "whole.csv"]) == 0
    with distributed.LocalCluster(2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        assert main([*SWEEP, *GRID, "-o", "runs.csv", "--scheduler", cluster.scheduler_address]) == 0
    assert Path("runs.csv").read_bytes() == Path("whole.csv").read_bytes()


def test_ctrl_c_keeps_what_is_done(scene):
    long = [*SWEEP, "--sweep", "g=1:20:4000", "--t-end", "1e5", "-o", "runs.csv"]
    command = [sys.executable, "-m", "eigenmotion", *long]
    run = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    parts = Path(".runs.csv.parts")
    while not parts.is_dir() or len(list(parts.iterdir())) < 2:
        assert run.poll() is None
        time.sleep(0.05)
    os.kill(run.pid, signal.SIGINT)
    _, said = run.communicate(timeout=60)
    assert run.returncode == 130
    assert "--resume goes on" in said
    assert json.loads((parts / "sweep.json").read_text())["grid"]["g"][0] == 1.0


CLASH = """\
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model
x, p, q = dynamicsymbols("x"), Symbol("x'"), Symbol("p'")
model = Model(name="clash", coordinates=[x], kinetic_energy=p * x.diff() ** 2 / 2, potential_energy=q * x,
              parameters={p: 1.0, q: 1.0})
"""


def test_a_name_of_two_things_is_refused_and_one_with_a_mark_is_taken(scene, capsys):
    scene.write_text(CLASH)
    assert main(["run", "scene.py", "--formulation", "lagrange", "--set", "x'=1"]) == 2
    assert "--set x': of clash two things have that name" in capsys.readouterr().err
    assert main([*SWEEP, "--sweep", "p'=1,2", "-o", "runs.npz"]) == 0
    with np.load("runs.npz") as found:
        assert found["swept_p'"].tolist() == [1.0, 2.0]
        assert np.allclose(found["x"][:, 0, 0], [-0.5, -1.0])
