"""Stores of sweeps: whenever a sweep is killed, nothing of it is in another, and it ends with the same bytes."""

import random
import time
import zipfile
from collections.abc import Callable
from itertools import cycle
from pathlib import Path

import numpy as np
import pytest

from eigenmotion.batch.sweep.unfinished_store import Parts
from eigenmotion.cli import main
from eigenmotion.results.columns import columns, moving

from .killed_commands import changes, killed_after, killed_at

SWEEP = ["sweep", "scene.py", "--formulation", "lagrange", "--t-end", "1", "--chunk", "4", "--workers", "1"]
ONE = [*SWEEP, "--sweep", "g=1:9:10"]
OTHER = [*SWEEP, "--sweep", "g=2:8:10"]
ENDINGS = ("npz", "csv", "nc", "zarr")


def needs(ending: str) -> None:
    for package in {"nc": ["xarray"], "zarr": ["xarray", "zarr"]}.get(ending, []):
        pytest.importorskip(package)


def content(store: Path) -> dict[str, bytes]:
    """Everything a store is, byte by byte."""
    if store.is_file():
        return {"": store.read_bytes()}
    return {str(path.relative_to(store)): path.read_bytes() for path in sorted(store.rglob("*")) if path.is_file()}


def begun_in(store: Path) -> bool:
    return Path(f".{store.name}.parts", "sweep.json").exists()


class Trial:
    """A sweep that is killed, what follows, and what there must be then."""

    def __init__(self, ending: str) -> None:
        self.store = Path(f"runs.{ending}")
        self.whole = {}
        for name, sweep in (("one", ONE), ("other", OTHER)):
            assert main([*sweep, "-o", f"{name}.{ending}"]) == 0
            self.whole[name] = content(Path(f"{name}.{ending}"))
        assert self.whole["one"] != self.whole["other"]

    def ends(self, sweep: list[str], name: str) -> None:
        assert main([*sweep, "-o", str(self.store), "--resume"]) == 0
        self.is_all(name)

    def is_all(self, name: str) -> None:
        """Have the one sweep's bytes at its place, and nothing else left; make room for the next trial."""
        assert content(self.store) == self.whole[name]
        assert not list(Path().glob(".runs.*"))

    def follow(self, by_another: bool) -> str:
        """Go on with the sweep that was killed, or have another one begin, which is refused or has it all."""
        if not by_another:
            if self.store.exists() and content(self.store) == self.whole["other"] and not begun_in(self.store):
                assert main([*ONE, "-o", str(self.store), "--resume"]) == 2
                self.is_all("other")
                return "kept"
            self.ends(ONE, "one")
            return "resumed"
        code = main([*OTHER, "-o", str(self.store)])
        if code == 0:
            self.is_all("other")
            return "replaced"
        assert code == 2
        assert main([*OTHER, "-o", str(self.store), "--resume"]) == 2
        self.ends(ONE, "one")
        return "refused"


def test_a_sweep_killed_at_a_change_of_a_file_ends_with_the_same_bytes(scene):
    """At every eighth, and all of those with which it ends."""
    at_changes("csv", lambda change, count: change % 8 == 0 or change > count - 6)


@pytest.mark.nightly
@pytest.mark.parametrize("ending", ENDINGS)
def test_a_sweep_killed_at_changes_of_files_ends_with_the_same_bytes(scene, ending):
    at_changes(ending, seldom_in_the_middle)


def seldom_in_the_middle(change: int, count: int) -> bool:
    """Whether to kill a sweep at this change. In the middle, Zarr writes one chunk after another in the same way."""
    return change < 60 or change % 5 == 0 or change > count - 40


def at_changes(ending: str, chosen: Callable[[int, int], bool]) -> None:
    needs(ending)
    trial = Trial(ending)
    count = changes([*ONE, "-o", str(trial.store)])
    trial.is_all("one")
    assert count > 15
    found = []
    changed = [change for change in range(count) if chosen(change, count)]
    for change, by_another in zip(changed, cycle([True, True, False]), strict=False):
        if change % 4 < 2:  # into a place where nothing was, and where the other's store was
            for path in [trial.store, *trial.store.rglob("*")][::-1]:
                path.rmdir() if path.is_dir() else path.unlink(missing_ok=True)
        else:
            assert main([*OTHER, "-o", str(trial.store)]) == 0
        killed_at(change, [*ONE, "-o", str(trial.store)])
        found.append(trial.follow(by_another))
    assert {"resumed", "replaced", "refused"} == set(found) - {"kept"}


def test_a_few_sweeps_killed_at_random_end_with_the_same_bytes(scene):
    at_random("npz", 4)


@pytest.mark.nightly
@pytest.mark.parametrize("ending", ENDINGS)
def test_two_hundred_sweeps_killed_at_random_end_with_the_same_bytes(scene, ending):
    at_random(ending, 50)


def at_random(ending: str, kills: int) -> None:
    """Kill sweeps, half of them in the last tenth of their time; another sweep follows upon every second."""
    needs(ending)
    trial, dice = Trial(ending), random.Random(len(ending))
    start = time.perf_counter()
    changes([*ONE, "-o", str(trial.store)])
    lasts = time.perf_counter() - start
    for number in range(kills):
        part = dice.random() if number % 2 else 1 - 0.1 * dice.random()
        killed_after(lasts * part, [*ONE, "-o", str(trial.store)])
        trial.follow(by_another=number % 4 < 2)


def begun() -> Path:
    """Leave a sweep after two of its parts; returns the folder."""
    keep = Parts.write_part

    def dying(self, number, arrays):
        keep(self, number, arrays)
        if number == 1:
            raise SystemExit(9)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Parts, "write_part", dying)
        with pytest.raises(SystemExit):
            main([*ONE, "-o", "runs.npz"])
    return Path(".runs.npz.parts")


@pytest.mark.parametrize("harm", ["truncated", "empty", "another's", "another number's", "without a name", "a bit"])
def test_a_part_that_is_damaged_is_made_anew(scene, capsys, harm):
    assert main([*ONE, "-o", "one.npz"]) == 0
    part = begun() / "000000.npz"
    whole = part.read_bytes()
    if harm in ("truncated", "empty"):
        part.write_bytes(whole[: len(whole) // 2 if harm == "truncated" else 0])
    elif harm == "a bit":
        with zipfile.ZipFile(part) as file:
            place = whole.index(np.load(part)["x"].tobytes())
            assert file.namelist()
        part.write_bytes(whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :])
    elif harm == "another number's":
        part.write_bytes((part.parent / "000001.npz").read_bytes())
    else:
        with np.load(part) as found:
            arrays = dict(found)
        arrays.pop("of") if harm == "without a name" else arrays.update(of=np.array("part 0 of 00"))
        np.savez(part, **arrays)
    assert main([*ONE, "-o", "runs.npz", "--resume"]) == 0
    assert "1 parts are damaged" in capsys.readouterr().err
    assert content(Path("runs.npz")) == content(Path("one.npz"))


def test_parts_without_an_order_are_nobodys(scene):
    """As an interrupted removal left them: another sweep took them for its own, and said so with exit code 0."""
    assert main([*OTHER, "-o", "other.npz"]) == 0
    (begun() / "sweep.json").unlink()
    assert main([*OTHER, "-o", "runs.npz", "--resume"]) == 0
    assert content(Path("runs.npz")) == content(Path("other.npz"))


def test_one_process_writes_at_a_time(scene, capsys, monkeypatch):
    """A second --resume is refused by name while the first is at work, and the first ends as if it were alone."""
    assert main([*ONE, "-o", "one.csv"]) == 0
    keep, codes = Parts.write_part, []

    def kept(self, number, arrays):
        keep(self, number, arrays)
        if not codes:
            codes.append(None)
            codes[0] = main([*ONE, "-o", "runs.csv", "--resume"])

    monkeypatch.setattr(Parts, "write_part", kept)
    assert main([*ONE, "-o", "runs.csv", "--resume"]) == 0
    assert codes == [2]
    assert "another sweep writes into it now" in capsys.readouterr().err
    assert content(Path("runs.csv")) == content(Path("one.csv"))


def test_a_store_that_is_damaged_is_not_complete(scene, capsys):
    assert main([*ONE, "-o", "runs.npz"]) == 0
    whole = content(Path("runs.npz"))
    Path("runs.npz").write_bytes(whole[""][:500])
    capsys.readouterr()
    assert main([*ONE, "-o", "runs.npz", "--resume"]) == 2
    assert "runs.npz is no store of a sweep, or damaged. It was left as it is" in capsys.readouterr().err
    assert content(Path("runs.npz")) == {"": whole[""][:500]}
    assert main([*ONE, "-o", "runs.npz"]) == 0
    assert content(Path("runs.npz")) == whole


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_store_of_another_sweep_is_not_resumed(scene, capsys, ending):
    """It was replaced, and its results were lost; exit code 0."""
    needs(ending)
    store = f"runs.{ending}"
    assert main([*OTHER, "-o", store]) == 0
    whole = content(Path(store))
    capsys.readouterr()
    assert main([*ONE, "-o", store, "--resume"]) == 2
    said = capsys.readouterr().err
    assert "name another file with -o" in said
    assert ending == "csv" or "--sweep g is [2.0" in said
    assert content(Path(store)) == whole
    assert not list(Path().glob(".runs.*"))
    assert main([*OTHER, "-o", store, "--resume"]) == 0
    assert "is complete" in capsys.readouterr().out
    assert main([*ONE, "-o", store]) == 0
    assert ending == "csv" or "This sweep replaces it when it ends" in capsys.readouterr().err
    assert content(Path(store)) != whole


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_file_that_is_no_store_is_not_replaced_by_resume(scene, capsys, ending):
    needs(ending)
    store = Path(f"runs.{ending}")
    if ending == "npz":
        np.savez(store, mine=np.arange(3))
    else:
        store.write_text("mine\n")
    mine = store.read_bytes()
    assert main([*ONE, "-o", str(store), "--resume"]) == 2
    assert "It was left as it is" in capsys.readouterr().err
    assert store.read_bytes() == mine


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (["--t-end", "2"], "--t-end is 1.0 there, and 2.0 here"),
        (["--rtol", "1e-7"], "--rtol is 1e-06 there, and 1e-07 here"),
        (["--set", "m=2"], "--set is not given there, and ['m=2'] here"),
        (["--formulation", "eigenfactor"], "the model is 'swing1, lagrange' there, and 'swing1, eigenfactor' here"),
        (["--sweep", "m=1,2"], "--sweep m is not given there, and [1.0, 2.0] here"),
    ],
)
def test_the_refusal_says_what_differs(scene, capsys, change, words):
    """Of stores and of sweeps that were not finished."""
    assert main([*ONE, "-o", "runs.npz"]) == 0
    assert main([*ONE, *change, "-o", "runs.npz", "--resume"]) == 2
    assert f"another sweep: {words}. " in capsys.readouterr().err
    Path("runs.npz").unlink()
    begun()
    assert main([*ONE, *change, "-o", "runs.npz", "--resume"]) == 2
    assert f"another sweep: {words}. " in capsys.readouterr().err


def test_a_model_that_was_edited_is_another_sweep(scene, capsys):
    assert main([*ONE, "-o", "runs.npz"]) == 0
    text = Path("scene.py").read_text()
    Path("scene.py").write_text(text.replace("m: 1.0", "m: 1.5"))
    assert Path("scene.py").read_text() != text
    assert main([*ONE, "-o", "runs.npz", "--resume"]) == 2
    assert "another sweep: the model, its default values or how it is compiled differ. " in capsys.readouterr().err


def test_an_order_that_cannot_be_read_is_refused(scene, capsys):
    (begun() / "sweep.json").write_bytes(b"\xff{")
    assert main([*ONE, "-o", "runs.npz", "--resume"]) == 2
    assert "its description cannot be read. Resume that one" in capsys.readouterr().err


NAMES = """\
from sympy import Function, Symbol
from eigenmotion import Model, t
z, energy = Function("z")(t), Function("energy")(t)
a, b, run, theta = Symbol("a b"), Symbol("a_b"), Symbol("run"), Symbol({theta!r})
model = Model(name="columns", coordinates=[z, energy], kinetic_energy=z.diff()**2/2 + energy.diff()**2/2,
              potential_energy=(a + 2 * b + 4 * run + 8 * theta) * z**2,
              parameters={{a: 1.0, b: 2.0, run: 3.0, theta: 4.0}},
              outputs={{"run": 2 * z, "t_end": 3 * z, "swept_run": 4 * z}}, initial={{z: 1.0}})
"""
EVERY = [*SWEEP[:1], "columns.py", *SWEEP[2:], "--sweep", "a b=1,2", "--sweep", "a_b=3,4", "--sweep", "run=5,6",
         "--sweep", "z=1,2"]  # fmt: skip


@pytest.mark.parametrize("ending", ENDINGS)
def test_names_that_would_become_one_are_kept_apart(scene, ending):
    needs(ending)
    Path("columns.py").write_text(NAMES.format(theta="q"))
    assert main([*EVERY, "-o", f"runs.{ending}"]) == 0
    found = columns_of(Path(f"runs.{ending}"))
    swept = [found["swept_a b" if ending == "npz" else "a b"], found["swept_a_b" if ending == "npz" else "a_b"],
             found["swept_swept_run" if ending in ("nc", "zarr", "csv") else "swept_run"],
             found["swept_z" if ending in ("npz", "csv") else "z"]]  # fmt: skip
    assert len({tuple(row) for row in np.array(swept).T.tolist()}) == 16
    outputs = [
        np.ravel(found[name])
        for name in ("output_run", "output_t_end", "output_swept_run" if ending == "npz" else "swept_run")
    ]
    assert np.allclose(outputs[1], 1.5 * outputs[0])
    assert np.allclose(outputs[2], 2 * outputs[0])


def columns_of(store: Path) -> dict[str, np.ndarray]:
    if store.suffix == ".npz":
        with np.load(store) as found:
            return dict(found)
    if store.suffix == ".csv":
        head, *rows = (line.split(",") for line in store.read_text().splitlines())
        assert len(set(head)) == len(head)
        return {name: np.array([float(row[k]) for row in rows]) for k, name in enumerate(head) if name != "stop"}
    xarray = pytest.importorskip("xarray")
    how = {"engine": "scipy"} if store.suffix == ".nc" else {"engine": "zarr", "consolidated": False}
    with xarray.open_dataset(store, **how) as found:
        return {str(name): found[name].values for name in found.variables}


@pytest.mark.parametrize(("ending", "name"), [("nc", "\u03b8"), ("zarr", "a/b"), ("zarr", "..")])
def test_a_name_that_a_store_cannot_hold_is_refused_before_the_runs(scene, capsys, ending, name):
    needs(ending)
    Path("columns.py").write_text(NAMES.format(theta=name))
    swept = [*SWEEP[:1], "columns.py", *SWEEP[2:], "--sweep", f"{name}=1,2"]
    assert main([*swept, "-o", f"runs.{ending}"]) == 2
    assert f"hold no column of the name {name!r}" in capsys.readouterr().err
    assert main([*swept, "-o", "runs.csv"]) == 0


UNITS = """\
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model, t
x, z = dynamicsymbols("x z")
m, k = Symbol("m"), Symbol("k")
model = Model(name="stamp", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, potential_energy=k * x**2 / 2,
    parameters={m: 0.002, k: 8.0}, initial={x: 5.0}, outputs={"force": -k * x, "late": t}, states={z: -z},
    units={x: "mm", m: "t", "force": "N", "late": "seconds", "energy": "mJ", z: "V"})
"""


@pytest.mark.parametrize("ending", ENDINGS)
def test_units_are_in_stores(scene, capsys, ending):
    """Times that are called seconds remain numbers where xarray opens them."""
    needs(ending)
    Path("stamp.py").write_text(UNITS)
    command = ["sweep", "stamp.py", "--t-end", "0.1", "--sweep", "m=0.002,0.004", "--sweep", "x'=0,1", "--rows", "2"]
    assert main([*command, "-o", f"runs.{ending}"]) == 0
    if ending == "csv":
        head = Path("runs.csv").read_text().partition("\n")[0]
        assert head == ("run,m [t],swept_x' [mm/s],t [s],x [mm],x' [mm/s],energy [mJ],z [V],force [N],late [seconds],"
                        "t_end [s],stop")  # fmt: skip
    elif ending != "npz":
        xarray = pytest.importorskip("xarray")
        how = {"consolidated": False} if ending == "zarr" else {}
        with xarray.open_dataset(f"runs.{ending}", **how) as found:
            units = {str(name): found[name].attrs.get("units") for name in found.variables}
            assert {name: unit for name, unit in units.items() if unit} == {
                "m": "t", "x'": "mm/s", "time": "s", "energy": "mJ", "force": "N", "z": "V", "t_end": "s"}  # fmt: skip
            assert (found.unit.item(), found.rate_unit.item()) == ("mm", "mm/s")
            assert found.late.dtype == np.float64
            assert found.late.attrs == {"unit": "seconds"}
    Path("stamp.py").write_text(UNITS.replace('"mm"', '"m"'))
    capsys.readouterr()
    assert main([*command, "-o", f"runs.{ending}", "--resume"]) == 2
    assert ending == "csv" or "another sweep: the unit of x is 'mm' there, and 'm' here. " in capsys.readouterr().err


def test_columns_are_all_different():
    users = [("swept", "a"), ("output", "a"), ("swept", "run"), ("output", "swept_run"), ("swept", "swept_swept_run")]
    found = columns({"run", "t"}, users)
    assert found == ["swept_a", "output_a", "swept_swept_swept_run", "swept_run", "swept_swept_run"]
    assert moving({"t", "energy"}, ["x", "energy", "x'"]) == [
        "x", "coordinate_energy", "coordinate_x'", "rate_x'", "energy'", "x''",
    ]  # fmt: skip


HUGE = 10**12
MANY = ["--sweep", "g=1:2:9000", "--sample", "m=uniform(1,2)", "-n", "90000"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--sweep", "g=1,2", "--sweep", " g=3,4"], "--sweep g is given twice"),
        (["--sample", "g=normal(1,2)", "--sample", "g=normal(3,4)", "-n", "3"], "--sample g is given twice"),
        (["--sweep", "g=1,2", "--set", "g=3"], "g is set and swept"),
        (["--sweep", f"g=1:2:{HUGE}"], "at most 1e+09 in one sweep"),
        (["--sweep", "g=1:2:999999999"], "999999999 values take"),
        (["--sweep", "g=1:2:100000", "--sweep", "m=1:2:100000"], "at most 1e+09 in one sweep"),
        (["--sweep", "g=1,2", "--rows", str(HUGE)], "--chunk: 2 runs of"),
        ([*MANY, "--chunk", str(HUGE)], "--chunk: 810000000 runs"),
        (MANY, "-o runs.npz: .npz files are put together"),
    ],
)  # fmt: skip
def test_what_is_asked_twice_or_goes_beyond_memory_is_told_before_anything_runs(
    scene, capsys, monkeypatch, arguments, words
):
    monkeypatch.setattr("eigenmotion.batch.memory.available", lambda: 10**10)
    assert (
        main([*SWEEP[:6], *(["--chunk", "4"] if "--chunk" not in arguments else []), *arguments, "-o", "runs.npz"]) == 2
    )
    assert words in capsys.readouterr().err
    assert not list(Path().glob(".runs.*"))
