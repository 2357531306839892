"""Units of models: words that reach what is shown, and no equation."""

import dataclasses
import pickle
from xml.etree import ElementTree
from zipfile import ZipFile

import numpy as np
import pytest
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.building.request import request
from eigenmotion.results.output.summary import summary
from eigenmotion.webpage.page import Run, about

from ..support.generation import system_for

q, x, u, z = dynamicsymbols("q x u z")
k = Symbol("k", positive=True)
WORDS = {q: "rad", "x": "mm", u: "N", k: "N/mm", "z": "°C", "reach": "mm", "length": "mm", "energy": "mJ"}


def model(**changes):
    return em.Model(
        **{
            "name": "measured",
            "coordinates": [q, x],
            "kinetic_energy": (q.diff() ** 2 + x.diff() ** 2) / 2,
            "potential_energy": (q**2 + k * x**2) / 2,
            "forces": {x: u},
            "parameters": {k: 1.0},
            "inputs": {u: 0.0},
            "states": {z: -z},
            "outputs": {"reach": 2 * x, "number": q * x},
            "initial": {q: 1.0, x: 1.0, z: 1.0},
            "drawing": [em.draw.Line((0, 0), (x, 1))],
            "units": WORDS,
        }
        | changes
    )


@pytest.fixture(scope="module")
def run():
    return system_for(model()).simulate((0, 1), dense_output=True)


@pytest.mark.parametrize(
    ("units", "words"),
    [
        ({"p": "mm"}, "no coordinate, state, parameter, input or output"),
        ({"reahc": "mm"}, "Did you mean 'reach'"),
        ({q.diff(): "rad/s"}, "Units of rates follow"),
        ({q: "rad", "q": "deg"}, "two entries for 'q'"),
        ({q: 1.0}, "must be a word"),
        ({q: " "}, "must be a word"),
        ("rad", "a mapping or a sequence of pairs"),
    ],
)
def test_mistakes_are_named(units, words):
    with pytest.raises(em.ModelError, match=words):
        model(units=units)


def test_they_change_no_equation():
    plain = model(units={})
    assert model().canonical() == plain.canonical()
    assert request(model()).sources_hash == request(plain).sources_hash
    assert dataclasses.replace(model(), name="copied").units == model().units


def test_two_words_for_one_model_are_two_systems():
    """Both have one library in the cache."""
    first, second = em.build(model()), em.build(model(units={q: "deg"}))
    assert first.units["q"] == "rad"
    assert second.units == {"q": "deg"}
    assert em.build(model(units={})).units == {}
    assert pickle.loads(pickle.dumps(second)).units == second.units


def test_rates_follow_from_coordinates(run):
    units = {"t": "s", "q": "rad", "x": "mm", "q'": "rad/s", "x'": "mm/s", "energy": "mJ", "reach": "mm", "z": "°C"}
    head = run.to_csv().splitlines()[0].split(",")
    assert head == [f"{name} [{units[name]}]" if name in units else name for name in run.table()]
    assert "number" in head
    slow = system_for(model(units={q: "deg", "time": "min"})).simulate((0, 1))
    assert "q' [deg/min]" in slow.to_csv()


def test_tables_of_other_tools_have_them_beside_names(run):
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    assert run.to_pandas().attrs["units"]["x'"] == "mm/s"
    data = run.to_xarray()
    assert data["x'"].attrs == {"units": "mm/s"}
    assert data["t"].attrs == {"units": "s"}
    assert data["number"].attrs == {}


def test_ensembles_of_other_tools_have_them():
    pytest.importorskip("xarray")
    swept = {"x0": {"x": [0.1, 0.2]}, "v0": {"q": [0.0, 1.0]}, "t_eval": [0.0, 0.5]}
    data = em.simulate_ensemble(system_for(model()), (0, 1), **swept).to_xarray()
    assert list(data["unit"].values) == ["rad", "mm"]
    assert list(data["rate_unit"].values) == ["rad/s", "mm/s"]
    words = {"energy": "mJ", "reach": "mm", "z": "°C", "time": "s", "x": None}
    assert {name: data[name].attrs.get("units") for name in words} == words
    assert sorted(one.attrs["units"] for one in data.coords.values() if one.dims == ("run",) and one.attrs) == [
        "mm",
        "rad/s",
    ]
    plain = em.simulate_ensemble(system_for(model(units={})), (0, 1), **swept).to_xarray()
    assert not any(one.attrs for one in plain.variables.values())
    assert "unit" not in plain.coords


def test_pictures_have_axes_for_each_unit(run):
    pytest.importorskip("matplotlib")
    *axes, sketch = run.plot().axes
    assert [one.get_ylabel() for one in axes] == ["$q$ [rad]", "$x$ [mm]", "$z$ [°C]", "reach [mm]", "number"]
    assert axes[-1].get_xlabel() == "time $t$ [s]"
    assert (sketch.get_xlabel(), sketch.get_title()) == ("$x$ [mm]", "$t$ = 1 s")
    assert run.plot("x'").axes[0].get_ylabel() == "$\\dot{x}$ [mm/s]"
    *axes, sketch = system_for(model(units={})).simulate((0, 1)).plot().axes
    assert "[" not in "".join(one.get_ylabel() + one.get_xlabel() for one in (*axes, sketch))
    assert sketch.get_title() == "$t$ = 1"


def test_the_summary_names_them(run):
    system = system_for(model())
    rows = summary(system, run, 0.0).splitlines()[-3:]
    assert [row.split()[1] for row in rows] == ["[rad]", "[mm]", "[°C]"]


def test_explanations_list_them():
    assert "\nUnits\n  rad: q\n  mm: x, reach, length\n" in request(model()).explanation()
    assert "Units" not in request(model(units={})).explanation()


def test_pages_have_them_behind_sliders():
    told = about(model(), Run(), True)
    assert [(one["unit"], one["rateUnit"]) for one in told["coordinates"]] == [
        ("rad", "rad/s"),
        ("mm", "mm/s"),
        ("°C", "°C"),
    ]
    assert told["parameters"][0]["unit"] == "N/mm"
    assert told["inputs"][0]["unit"] == "N"
    assert (told["time"], told["energy"], told["measured"]) == ("s", "mJ", True)
    bare = about(model(units={}), Run(), True)
    assert (bare["time"], bare["energy"], bare["measured"]) == ("", "", False)


def test_units_of_a_tree_are_those_of_its_joints():
    tree = em.Tree()
    slide = tree.body("slide", joint="cylindrical", axis="x", mass=1)
    tree.body("arm", slide, joint="revolute", axis="y", mass=1, center=(0, 0, -300))
    tree.body("stone", joint="free", mass=1, inertia=(1, 1, 1))
    found = {str(q.func): unit for q, unit in tree.units("mm").items()}
    assert found == {"slide_1": "mm", "slide_2": "rad", "arm": "rad", "stone_1": "mm", "stone_2": "mm", "stone_3": "mm"}
    assert {str(q.func) for q in tree.units()} == {"slide_2", "arm"}


@pytest.mark.usefixtures("hurried")
def test_units_for_other_tools_have_them(tmp_path):
    """A word that FMI cannot know is a unit of that name; what is given for the export is preferred."""
    em.export_fmu(model(), tmp_path / "unit.fmu", units={"reach": "cm"})
    with ZipFile(tmp_path / "unit.fmu") as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    units = {one.get("name"): one.find("BaseUnit") for one in root.iter("Unit")}
    assert units["mm"].attrib == {"m": "1", "factor": "0.001"}
    assert units["°C"] is None
    assert "cm" in units
    found = {one.get("name"): one.find("Real").get("unit") for one in root.iter("ScalarVariable")}
    assert [found[name] for name in ("q", "der(q)", "x", "der(x)", "k", "u", "z", "reach", "number")] == [
        "rad", "rad/s", "mm", "mm/s", "N/mm", "N", "°C", "cm", None,
    ]  # fmt: skip
    em.export_fmu(model(units=WORDS | {"time": "ms"}), tmp_path / "slow.fmu")
    with ZipFile(tmp_path / "slow.fmu") as archive:
        assert b"<Unit " not in archive.read("modelDescription.xml")


def test_a_saved_motion_is_a_path(tmp_path, monkeypatch, capsys):
    """Its columns have units behind their names."""
    from eigenmotion.cli import main  # noqa: PLC0415

    monkeypatch.chdir(tmp_path)
    (tmp_path / "swing.py").write_text(
        "from sympy.physics.mechanics import dynamicsymbols\n"
        "from eigenmotion import Model\n"
        'q = dynamicsymbols("q")\n'
        'model = Model(name="swing", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=q**2 / 2,\n'
        '              initial={q: 1}, units={q: "rad"})\n'
    )
    assert main(["run", "swing.py", "--t-end", "2", "--rtol", "1e-9", "--save", "a.csv", "--rows", "41"]) == 0
    assert (tmp_path / "a.csv").read_text().startswith("t [s],q [rad],q' [rad/s],energy\n")
    assert main(["drive", "swing.py", "--path", "q=a.csv", "--rows", "5", "-o", "b.csv"]) == 0
    capsys.readouterr()
    head, *rows = (tmp_path / "b.csv").read_text().splitlines()
    assert head == "t [s],q [rad],q' [rad/s],q'' [rad/s^2],force_q,power_q"
    table = np.array([row.split(",") for row in rows], dtype=float)
    np.testing.assert_allclose(table[1:-1, 4], 0.0, atol=1e-3)  # a free motion needs no force
