"""Tables in expressions: their values and derivatives in C, and motions under them, against SciPy's."""

import pickle
from concurrent.futures import ProcessPoolExecutor
from itertools import pairwise
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
import scipy.integrate
import scipy.interpolate as si
import sympy
from sympy import Rational, cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, ModelError, StopReason, Table

THETA, R = dynamicsymbols("theta r")
M, L, G = symbols("m l g", positive=True)
RNG = np.random.default_rng(3)
ANGLES = np.sort(np.concatenate([[-4.0, 4.0], RNG.uniform(-4.0, 4.0, 15)]))
TORQUES = np.sin(2.0 * ANGLES) + 0.3 * ANGLES
SPLINE = si.CubicSpline(ANGLES, TORQUES)
GRID = np.linspace(-2.0, 2.0, 9), np.linspace(-1.0, 3.0, 7)
HEIGHTS = np.sin(GRID[0])[:, None] * np.cos(GRID[1]) + 0.2 * GRID[0][:, None]


def pendulum(table: Table, name: str, **more: object) -> Model:
    given = {"forces": {THETA: table(THETA)}, "outputs": {"torque": table(THETA)}} | more
    return Model(
        name=name, coordinates=[THETA], kinetic_energy=M * (L * THETA.diff()) ** 2 / 2,
        potential_energy=-M * G * L * cos(THETA), parameters={M: 1.0, L: 1.0, G: 9.81}, initial={THETA: 1.0}, **given,
    )  # fmt: skip


def swing(torque, span: tuple[float, float] = (0.0, 5.0), theta: float = 1.0) -> np.ndarray:
    """theta and its rate at the end, by SciPy."""

    def rates(t: float, z: np.ndarray) -> list[float]:
        return [z[1], float(torque(z[0])) - 9.81 * np.sin(z[0])]

    return scipy.integrate.solve_ivp(rates, span, [theta, 0.0], method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]


@pytest.fixture(scope="module")
def loaded() -> em.System:
    return em.build(pendulum(Table(SPLINE, name="load"), "loaded_pendulum"))


# --- values ---------------------------------------------------------------------------------------------------------

CURVES = {
    "cubic": SPLINE, "pchip": si.PchipInterpolator(ANGLES, TORQUES), "akima": si.Akima1DInterpolator(ANGLES, TORQUES),
    "quintic": si.make_interp_spline(ANGLES, TORQUES, k=5), "polynomials": si.PPoly(SPLINE.c, SPLINE.x),
    "of_a_fit": si.PPoly.from_spline(si.splrep(ANGLES, TORQUES, s=0.5)),  # its outer pieces have the length zero
}  # fmt: skip


def observed(system: em.System, points: np.ndarray) -> dict[str, np.ndarray]:
    """Outputs at rows of coordinates."""
    n = len(points)
    rows = system.compiled.output_rows(
        np.zeros(n), points, np.zeros_like(points), np.zeros((n, 0)), system.prepare(), False
    )
    return dict(zip(system.outputs, rows.T, strict=True))


def test_values_and_derivatives_of_one_argument_are_those_of_scipy() -> None:
    x = THETA
    outputs = {f"{name}{d}": Table(curve, name=name)(x).diff(x, d) for name, curve in CURVES.items() for d in range(3)}
    system = em.build(pendulum(Table(SPLINE, name="cubic"), "curves", outputs=outputs))
    points = np.concatenate([RNG.uniform(-4.0, 4.0, 60), ANGLES[1:-1]])
    found = observed(system, points[:, None])
    for name, curve in CURVES.items():
        size = np.abs(curve(points)).max()
        for d in range(3):
            stated = curve(points, d)
            terms = max(np.abs(stated).max(), size / np.diff(ANGLES).min() ** d)
            assert np.abs(found[f"{name}{d}"] - stated).max() <= 1e-14 * terms * 4


def test_values_and_derivatives_of_two_arguments_are_those_of_scipy() -> None:
    spline = si.RectBivariateSpline(*GRID, HEIGHTS)
    chart = Table(spline, outside="extend", name="chart")
    outputs = {f"d{i}{j}": sympy.diff(chart(THETA, R), (THETA, i), (R, j)) for i in range(3) for j in range(3 - i)}
    linear = Table((*GRID, HEIGHTS), outside="extend", name="linear")
    system = em.build(Model(
        name="charted", coordinates=[THETA, R], kinetic_energy=THETA.diff() ** 2 + R.diff() ** 2,
        potential_energy=chart(THETA, R), outputs=outputs | {"linear": linear(THETA, R)}, initial={THETA: 0.1, R: 0.2},
    ))  # fmt: skip
    points = np.column_stack([RNG.uniform(-2.0, 2.0, 40), RNG.uniform(-1.0, 3.0, 40)])
    found = observed(system, points)
    for name in outputs:
        stated = spline.ev(*points.T, dx=int(name[1]), dy=int(name[2]))
        assert np.abs(found[name] - stated).max() <= 2e-13 * max(1.0, np.abs(stated).max())
    grid = si.RegularGridInterpolator(GRID, HEIGHTS)
    assert found["linear"] == pytest.approx(grid(points), abs=1e-15)
    x, v = np.array([0.3, 0.4]), np.zeros(2)
    assert system.acceleration(x, v)[0] == pytest.approx(
        [-spline.ev(*x, dx=1) / 2, -spline.ev(*x, dy=1) / 2], rel=1e-13
    )


def test_sympy_differentiates_evaluates_and_prints_tables() -> None:
    load = Table(SPLINE, name="load")
    call = load(THETA)
    assert [str(call), str(call.diff(THETA))] == ["load(theta(t))", "load'(theta(t))"]
    assert float(load(sympy.Float(0.3))) == pytest.approx(float(SPLINE(0.3)), rel=1e-14)
    assert call == Table(SPLINE, name="load")(THETA)
    assert call != Table(TORQUES_PLUS, name="load")(THETA)
    assert pickle.loads(pickle.dumps(call)) == call
    x = sympy.Symbol("x")
    assert sympy.lambdify(x, load(x) ** 2)(0.3) == pytest.approx(float(SPLINE(0.3)) ** 2, rel=1e-14)
    equations = pendulum(load, "shown").equations()
    assert "load(theta(t))" in str(equations.bias)
    made: dict[str, object] = {}
    exec(pendulum(load, "shown", forces={THETA: call.diff(THETA)}).equations().source(), made)
    assert made["bias"].has(sympy.Subs)


TORQUES_PLUS = si.CubicSpline(ANGLES, TORQUES + 1.0)


# --- motions --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau5"])
def test_a_run_is_that_of_scipy_with_the_same_spline(loaded: em.System, method: str) -> None:
    run = loaded.simulate((0.0, 5.0), method=method, rtol=1e-10, atol=1e-11)
    assert run.success
    assert [run.x[0, -1], run.v[0, -1]] == pytest.approx(swing(SPLINE), abs=3e-7)
    assert run.outputs["torque"] == pytest.approx(SPLINE(run.x[0]), abs=1e-13)


def test_other_numbers_are_given_without_compiling(loaded: em.System) -> None:
    others = (TORQUES_PLUS, Table(si.PchipInterpolator(ANGLES, -TORQUES)), (ANGLES, 0.5 * TORQUES))
    curves = (TORQUES_PLUS, si.PchipInterpolator(ANGLES, -TORQUES), lambda x: np.interp(x, ANGLES, 0.5 * TORQUES))
    for other, curve in zip(others, curves, strict=True):
        run = loaded.simulate((0.0, 5.0), parameters={"load": other}, rtol=1e-9, atol=1e-10)
        assert [run.x[0, -1], run.v[0, -1]] == pytest.approx(swing(curve), abs=1e-5)
        assert run.outputs["torque"] == pytest.approx(curve(run.x[0]), abs=1e-13)
    prepared = loaded.prepare({"load": TORQUES_PLUS})
    for one in (prepared, pickle.loads(pickle.dumps(prepared))):
        found = one.model.acceleration(0.0, [0.3], [0.0], one, [], 0)[0]
        assert found == pytest.approx([TORQUES_PLUS(0.3) - 9.81 * np.sin(0.3)], rel=1e-14)
    assert loaded.parameters["load"] == 0.0
    assert loaded.prepare(dict(loaded.parameters)).parameters[-1] == 0.0


def test_slopes_are_exact(loaded: em.System) -> None:
    A = loaded.linearize({"theta": 0.37}).A
    assert A[1, 0] == pytest.approx(SPLINE(0.37, 1) - 9.81 * np.cos(0.37), rel=1e-13)
    J = em.build(loaded_model(), formulation="lagrange").jacobian(0.0, np.array([0.37, 0.2]))
    assert J[1, 0] == pytest.approx(A[1, 0], rel=1e-13)
    run = loaded.simulate((0.0, 1.0), sensitivities=["theta", "g"], rtol=1e-9, atol=1e-10)
    near = [swing(SPLINE, (0.0, 1.0), 1.0 + h)[0] for h in (-1e-4, 1e-4)]
    assert run.sensitivity["theta"].dx[0, -1] == pytest.approx((near[1] - near[0]) / 2e-4, rel=1e-6)


def loaded_model() -> Model:
    return pendulum(Table(SPLINE, name="load"), "loaded_pendulum")


def test_members_of_an_ensemble_have_tables_of_their_own(loaded: em.System) -> None:
    scaled = [si.CubicSpline(ANGLES, k * TORQUES) for k in np.linspace(0.5, 1.5, 9)]
    runs = em.simulate_ensemble(loaded, (0.0, 5.0), parameters={"load": scaled}, rtol=1e-9, atol=1e-10)
    assert runs.success.all()
    for k, curve in enumerate(scaled):
        assert [runs.x[k, 0, -1], runs.v[k, 0, -1]] == pytest.approx(swing(curve), abs=1e-6)


def test_steps_end_at_joins_that_are_rough() -> None:
    """In the time and in coordinates: a table of lines is as accurate as one that is smooth."""
    times, pushes = np.linspace(0.0, 5.0, 41), RNG.normal(size=41)
    push, load = Table((times, pushes), name="push"), Table((ANGLES, TORQUES), name="load")
    system = em.build(pendulum(load, "kinked", forces={THETA: load(THETA) + push(em.t)}))
    run = system.simulate((0.0, 5.0), rtol=1e-9, atol=1e-10)
    z = np.array([1.0, 0.0])
    for start, end in pairwise(times):
        z = scipy.integrate.solve_ivp(
            lambda t, z: [z[1], np.interp(t, times, pushes) + np.interp(z[0], ANGLES, TORQUES) - 9.81 * np.sin(z[0])],
            (start, end), z, method="DOP853", rtol=1e-11, atol=1e-12, max_step=2e-3).y[:, -1]  # fmt: skip
    assert [run.x[0, -1], run.v[0, -1]] == pytest.approx(z, abs=1e-6)
    assert all(np.abs(run.t - at).min() < 1e-12 for at in times)


def test_slopes_that_jump_at_joins_do_not_disturb_sensitivities(loaded: em.System) -> None:
    """Lines join with a jump of the slope; a jump of the force itself has no derivative, and is refused."""
    lines = (ANGLES, TORQUES)

    def end(g: float) -> float:
        return loaded.simulate((0.0, 2.0), parameters={"load": lines, "g": g}, rtol=1e-12, atol=1e-13).x[0, -1]

    run = loaded.simulate((0.0, 2.0), parameters={"load": lines}, sensitivities=["g"], rtol=1e-9, atol=1e-10)
    assert run.sensitivity["g"].dx[0, -1] == pytest.approx((end(9.81 + 1e-5) - end(9.81 - 1e-5)) / 2e-5, abs=1e-7)
    jumps = si.PPoly(np.array([[0.0, 0.5]]), [-4.0, 0.2, 4.0])
    with pytest.raises(ModelError, match="a force jumps"):
        loaded.simulate((0.0, 2.0), parameters={"load": jumps}, sensitivities=["g"])


# --- beyond the range -----------------------------------------------------------------------------------------------


def test_a_run_that_leaves_a_table_ends_there_and_names_it(loaded: em.System) -> None:
    for method in ("dop853", "ra15", "radau5"):
        run = loaded.simulate((0.0, 5.0), v0=[12.0], method=method)
        assert run.stop is StopReason.OUTSIDE_TABLE
        assert "table 'load' at 4" in run.message
        assert run.x[0, -1] == pytest.approx(4.0, abs=1e-12)
    assert loaded.simulate((0.0, 1.0), x0=[4.5]).stop is StopReason.OUTSIDE_TABLE
    with pytest.raises(em.EvaluationError, match=r"table 'load' at 4\.5"):
        loaded.acceleration([4.5], [0.0])
    runs = em.simulate_ensemble(loaded, (0.0, 5.0), v0={"theta": [0.0, 12.0]})
    assert runs.success.tolist() == [True, False]
    assert "table 'load'" in runs.message(1)


@pytest.mark.parametrize("outside", ["hold", "extend", "periodic"])
def test_beyond_the_range_is_what_was_chosen(outside: str, loaded: em.System) -> None:
    points = np.array([-9.3, -4.0, 4.0, 5.5, 17.0])
    stated = {
        "hold": SPLINE(np.clip(points, -4.0, 4.0)), "extend": SPLINE(points),
        "periodic": SPLINE(points - np.floor((points + 4.0) / 8.0) * 8.0),
    }[outside]  # fmt: skip
    table = Table(SPLINE, outside=outside)
    for point, value in zip(points, stated, strict=True):
        if outside != "periodic" or abs(point) != 4.0:  # where it begins again either end will do
            found = loaded.acceleration([point], [0.0], parameters={"load": table})[0][0] + 9.81 * np.sin(point)
            assert found == pytest.approx(value, rel=1e-12, abs=1e-12)
    run = loaded.simulate((0.0, 2.0), v0=[12.0], parameters={"load": table})
    assert run.success
    assert run.x[0].max() > 4.0


# --- what is refused ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("given", "words"), [
    (([0.0, 2.0, 1.0], [0.0, 1.0, 2.0]), "sort the points"),
    (([0.0, 1.0], [0.0, np.nan]), "finite"),
    (([0.0, 1.0], [0.0, 1.0, 2.0]), "shape"),
    (([0.0], [0.0]), "at least two"),
    (([0.0, 1.0], [0.0, 1.0], [[0.0, 1.0]]), "shape"),
    (si.BPoly([[0.0], [1.0]], [0.0, 1.0]), "Bernstein"),
    (si.CubicSpline([0.0, 1.0], [[0.0, 1.0], [2.0, 3.0]]), "several values"),
    ("load.csv", "CubicSpline"),
])  # fmt: skip
def test_a_table_that_cannot_be_says_why(given: object, words: str) -> None:
    with pytest.raises(ModelError, match=words):
        Table(given, name="load")


def test_models_refuse_what_tables_cannot_be() -> None:
    load = Table(SPLINE, name="load")
    with pytest.raises(ModelError, match="one argument"):
        load(THETA, THETA)
    with pytest.raises(ModelError, match="outside"):
        Table(SPLINE, outside="wrap")
    with pytest.raises(ModelError, match="both named 'l'"):
        pendulum(Table(SPLINE, name="l"), "clash")
    with pytest.raises(ModelError, match="two tables"):
        pendulum(load, "twice", outputs={"other": Table(TORQUES_PLUS, name="load")(THETA)})


def test_runs_refuse_what_is_no_such_table(loaded: em.System) -> None:
    for given, words in (
        (3.0, "is a table"),
        (si.RectBivariateSpline(*GRID, HEIGHTS), "argument"),
        (([0.0, 0.0], [1.0, 1.0]), "increase"),
    ):
        with pytest.raises((ModelError, em.EvaluationError), match=words):
            loaded.simulate((0.0, 1.0), parameters={"load": given})
    with pytest.raises(ModelError, match="'load', which is a table"):
        loaded.simulate((0.0, 1.0), sensitivities=["load"])
    with pytest.raises(ModelError, match="'load', which is a table"):
        em.find_equilibrium(loaded, free=["load"])


def test_tables_travel_to_other_processes(loaded: em.System) -> None:
    """An address says nothing elsewhere: arrays travel, and get an address there."""
    scaled = [(ANGLES, k * TORQUES) for k in (0.5, 1.0)]
    members = {"parameters": {"load": scaled}, "rtol": 1e-8}
    here = em.simulate_ensemble(loaded, (0.0, 1.0), **members)
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        there = em.simulate_ensemble(loaded, (0.0, 1.0), executor=executor, **members)
    assert (here.x == there.x).all()
    many = loaded.steppers(**members)
    many.advance(1.0)
    assert many.x[:, 0] == pytest.approx(here.x[:, 0, -1], abs=1e-12)


# --- ways in --------------------------------------------------------------------------------------------------------


def test_a_model_file_reads_its_table_by_one_line_of_numpy(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "load.csv", np.column_stack([ANGLES, TORQUES]), delimiter=",")
    (tmp_path / "csv_load.py").write_text(
        "from pathlib import Path\n"
        "import numpy as np\n"
        "from sympy.physics.mechanics import dynamicsymbols\n"
        "from eigenmotion import Model, Table\n"
        "theta = dynamicsymbols('theta')\n"
        "angles, torques = np.loadtxt(Path(__file__).with_name('load.csv'), delimiter=',', unpack=True)\n"
        "load = Table((angles, torques), name='load')\n"
        "model = Model(name='csv_load', coordinates=[theta], kinetic_energy=theta.diff() ** 2 / 2,\n"
        "              forces={theta: load(theta)})\n"
    )
    system = em.build(tmp_path / "csv_load.py")
    assert system.acceleration([0.4], [0.0])[0] == pytest.approx([np.interp(0.4, ANGLES, TORQUES)], rel=1e-13)


def test_a_table_may_stand_in_every_term() -> None:
    """In masses, potentials and constraints: the proof of the build compares all of it with SciPy's pieces."""
    bump = Table(si.CubicSpline([-3.0, -1.0, 0.0, 1.0, 3.0], [2.0, 1.3, 1.0, 1.2, 2.5]), outside="extend", name="bump")
    system = em.build(Model(
        name="everywhere", coordinates=[THETA, R], kinetic_energy=Rational(1, 2) * bump(THETA) * (THETA.diff() ** 2
        + R.diff() ** 2), potential_energy=bump(R), holonomic_constraints=[R - bump(THETA) + 1],
        initial={THETA: 0.5, R: float(bump.pieces.value((0,), (0.5,))) - 1.0},
    ))  # fmt: skip
    run = system.simulate((0.0, 3.0), rtol=1e-9, atol=1e-10)
    assert run.success
    assert np.ptp(run.energy) < 1e-7


def test_joins_are_passed_however_late_it_is() -> None:
    """Late times are farther apart than the interval behind a join; the energy is that of the lines' integral."""
    points, values = np.array([-1.0, -0.5, 0.0, 0.3, 1.0]), np.array([0.0, 1.0, -1.0, 2.0, 0.0])
    load = Table((points, values), outside="periodic", name="load")
    work = si.make_interp_spline(points, values, k=1).antiderivative()

    def energy(x: np.ndarray, v: np.ndarray) -> np.ndarray:
        turns, place = np.divmod(x + 1.0, 2.0)
        return v**2 / 2 - turns * work(1.0) - work(place - 1.0)

    system = em.build(Model(name="passing", coordinates=[R], kinetic_energy=R.diff() ** 2 / 2, forces={R: load(R)}))
    for start in (0.0, 1e2, 1e4):
        for speed in np.linspace(2.0, 5.0, 7):
            run = system.simulate((start, start + 20), v0={"r": speed}, rtol=1e-9, atol=1e-9)
            assert run.success, run.message
            assert energy(run.x[0], run.v[0]) == pytest.approx(energy(run.x[0, 0], run.v[0, 0]), abs=1e-7)
