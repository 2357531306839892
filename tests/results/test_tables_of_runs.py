"""Runs as tables: their columns, at any time, and in the formats of other tools."""

import csv
import io
import pickle

import numpy as np
import pytest
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.results.between_rows import passages

from ..support.generation import system_for, system_of

q, z, u = dynamicsymbols("q z u")
TOLERANCES = {"rtol": 1e-10, "atol": 1e-10}
TIMES = np.linspace(0.0, 3.0, 7)


@pytest.fixture(scope="module")
def run():
    """q = cos(t), z = exp(-t)."""
    model = em.Model(
        name="swing", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=q**2 / 2,
        outputs={"square": q**2, "energy": 3 * q, "pull": q.diff().diff()}, states={z: -z}, initial={q: 1, z: 1},
    )  # fmt: skip
    return system_for(model).simulate((0, 3), dense_output=True, **TOLERANCES)


@pytest.fixture(scope="module")
def bounce():
    """A ball that is dropped from 1 and stays on the floor, at gravity 2: it lands at t = 1."""
    model = em.Model(
        name="drop", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=2 * q, initial={q: 1},
        contacts={"floor": em.Contact(q)}, outputs={"force": -em.multiplier("floor")},
    )  # fmt: skip
    return system_for(model).simulate((0, 2), dense_output=True, **TOLERANCES)


def test_columns_have_names_and_those_that_are_taken_their_kind(run):
    columns = run.table()
    assert list(columns) == ["t", "q", "q'", "energy", "square", "output_energy", "pull", "z"]
    np.testing.assert_array_equal(columns["q"], run.x[0])
    np.testing.assert_array_equal(columns["output_energy"], run.outputs["energy"])


def test_a_motion_is_known_at_any_time(run):
    columns = run.at(TIMES).table()
    exact = {
        "t": TIMES, "q": np.cos(TIMES), "q'": -np.sin(TIMES), "energy": np.full(7, 0.5), "square": np.cos(TIMES) ** 2,
        "output_energy": 3 * np.cos(TIMES), "pull": -np.cos(TIMES), "z": np.exp(-TIMES),
    }  # fmt: skip
    for name, values in exact.items():
        np.testing.assert_allclose(columns[name], values, atol=1e-8, err_msg=name)
    assert run.at(1.5).x.shape == (1, 1)
    assert run.at(TIMES).at([0.5]).t == [0.5]
    assert run.at(TIMES).error_estimate is None


@pytest.mark.parametrize(
    ("t", "words"),
    [([0.0, 4.0], "outside the interval"), ([2.0, 1.0], "not in the order of the run"), ([[0.0]], "shape")],
)
def test_times_that_a_motion_does_not_have_are_refused(run, t, words):
    with pytest.raises(em.ModelError, match=words):
        run.at(t)


def test_backwards_the_order_is_that_of_the_run(run):
    back = run.trajectory.model
    assert back.name == "swing"
    found = em.simulate(system_for(_spring()), (0, -3), dense_output=True, **TOLERANCES).at(-TIMES)
    np.testing.assert_allclose(found.x[0], np.cos(TIMES), atol=1e-8)


def _spring():
    return em.Model(
        name="spring", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=q**2 / 2, initial={q: 1}
    )


def test_without_dense_output_a_run_has_its_rows_alone():
    with pytest.raises(em.ModelError, match="dense_output=True"):
        system_for(_spring()).simulate((0, 1)).at([0.5])


def test_each_time_has_the_forces_of_its_mode(bounce):
    times = np.array([0.0, 0.5, 0.99, 1.01, 1.5, 2.0])
    np.testing.assert_allclose(bounce.at(times).outputs["force"], [0, 0, 0, 2, 2, 2], atol=1e-12)
    np.testing.assert_allclose(bounce.at(times[4:]).outputs["force"], [2, 2], atol=1e-12)
    np.testing.assert_allclose(bounce.at(times[:2]).outputs["force"], [0, 0], atol=1e-12)
    np.testing.assert_allclose(bounce.at(times).x[0, :3], 1 - times[:3] ** 2, atol=1e-9)


def test_csv_is_read_back_exactly(run, tmp_path):
    assert run.to_csv(tmp_path / "run.csv") is None
    text = (tmp_path / "run.csv").read_text()
    assert text == run.to_csv()
    head, *rows = csv.reader(io.StringIO(text))
    assert head == list(run.table())
    np.testing.assert_array_equal(np.array(rows, dtype=float).T, [*run.table().values()])
    with pytest.raises(em.ModelError, match="cannot be written"):
        run.to_csv(tmp_path)


def test_a_run_is_saved_by_the_ending_of_the_file(run, tmp_path):
    run.save(tmp_path / "run.csv")
    assert (tmp_path / "run.csv").read_text() == run.to_csv()
    run.save(str(tmp_path / "run.npz"))
    with np.load(tmp_path / "run.npz") as arrays:
        for name in ("t", "y", "x", "v", "multipliers", "energy", "factor_residual"):
            np.testing.assert_array_equal(arrays[name], run[name])
    with pytest.raises(em.ModelError, match=r"known endings are \.npz, \.csv"):
        run.save(tmp_path / "run.txt")
    (tmp_path / "file").touch()
    with pytest.raises(em.ModelError, match="cannot be written"):
        run.save(tmp_path / "file" / "run.npz")


def test_pandas_has_columns_over_time(run):
    pandas = pytest.importorskip("pandas")
    frame = run.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert frame.index.name == "t"
    assert list(frame) == list(run.table())[1:]
    np.testing.assert_array_equal(frame["q"].to_numpy(), run.x[0])
    assert frame.attrs == {"model": "swing", "stop": "finished"}


def test_xarray_has_variables_over_time(run):
    pytest.importorskip("xarray")
    data = run.to_xarray()
    assert list(data) == list(run.table())[1:]
    assert data.sizes == {"t": len(run.t)}
    assert float(data["q"].interp(t=1.0)) == pytest.approx(np.cos(1.0), abs=0.05)
    assert data.attrs == {"model": "swing", "stop": "finished"}


def test_a_copy_from_another_process_says_that_it_has_no_names(run):
    copied = pickle.loads(pickle.dumps(run))
    for call in (copied.table, copied.to_csv, copied.to_pandas, copied.plot, lambda: copied.at([0.0])):
        with pytest.raises(em.ModelError, match="no model"):
            call()


def test_a_motion_is_known_where_a_coordinate_passes_values(run):
    """q = cos(t) falls from 1 to cos(3)."""
    places = np.array([1.0, 0.5, 0.0, -0.5])
    found = run.over("q", places)
    np.testing.assert_allclose(found.t, np.arccos(places), atol=1e-8)
    np.testing.assert_allclose(found.x[0], places, atol=1e-12)
    np.testing.assert_allclose(found.outputs["pull"], -places, atol=1e-8)
    back = system_for(_spring()).simulate((0, -3), dense_output=True, **TOLERANCES).over("q", [0.5])
    np.testing.assert_allclose(back.t, -np.arccos(0.5), atol=1e-8)


def test_multipliers_have_the_names_of_their_rows():
    """A puck on a floor, between two rails, that rubs in two directions."""
    x, y, z = dynamicsymbols("x y z")
    model = em.Model(
        name="named_rows", coordinates=[x, y, z], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=9.81 * z, holonomic_constraints={"rail": [y, 2 * y]}, initial={x.diff(): 1.0},
        contacts={"floor": em.Contact(z), "rub": em.Friction((x.diff(), y.diff()), limit=2.0)},
    )  # fmt: skip
    system = system_for(model, "lagrange")
    run = system.simulate((0, 0.1))
    names = ["lambda_rail[0]", "lambda_rail[1]", "lambda_floor", "lambda_rub[0]", "lambda_rub[1]"]
    assert [name for name in run.table() if name.startswith("lambda")] == names
    np.testing.assert_allclose(run.table()["lambda_floor"], -9.81)
    np.testing.assert_array_equal([run.table()[name] for name in names], run.multipliers)
    unnamed = system_of("four_bar", "lagrange").simulate((0, 0.1)).table()
    assert [name for name in unnamed if name.startswith("lambda")] == ["lambda0", "lambda1"]


def test_the_ends_of_a_motion_are_reached_to_rounding():
    """Rows are on the constraints to rounding, and the motion between them beside these: of a crank driven from 0."""
    ends, at = np.linspace(0.0, 3.0, 4), lambda t: 2 * t + 1e-32
    places = np.array([-1e-32, 3.0, 6.0 * (1 + 1e-15)])
    np.testing.assert_allclose(passages("q", at, ends, places), [0.0, 1.5, 3.0], atol=1e-14)
    with pytest.raises(em.ModelError, match="q does not reach -1e-12"):
        passages("q", at, ends, np.array([-1e-12]))


def test_values_that_are_not_passed_once_are_refused(run):
    with pytest.raises(em.ModelError, match=r"q does not reach -0\.995: it goes from 1 to -0\.989"):
        run.over("q", [-0.995])
    with pytest.raises(em.ModelError, match="unknown coordinate 'z'"):
        run.over("z", [0.5])
    there_and_back = system_for(_spring()).simulate((0, 6), dense_output=True, **TOLERANCES)
    with pytest.raises(em.ModelError, match=r"q turns back at t = 3\.\d+, and passes some values twice"):
        there_and_back.over("q", [0.5])
    with pytest.raises(em.ModelError, match="dense_output=True"):
        system_for(_spring()).simulate((0, 1)).over("q", [0.9])
