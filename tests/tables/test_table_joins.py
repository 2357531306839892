"""Joins of pieces: how many steps and rejections they cost, and that motions across them are exact."""

from functools import cache

import numpy as np
import pytest
import scipy.interpolate as si
import sympy
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for

x, y, path = dynamicsymbols("x y path")
METHODS = ("dop853", "ra15", "radau9")
KNOTS = np.linspace(-10.0, 10.0, 41)
VALUES = np.sin(3 * KNOTS)
LINES = si.make_interp_spline(KNOTS, VALUES, k=1)
LEVELS = si.PPoly(VALUES[None, :-1], KNOTS)
"""A force that bends at each knot, and one that jumps there."""


def oscillator(force, name: str = "oscillator") -> em.System:
    return system_for(em.Model(name=name, coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2,
                               forces={x: force}, initial={x: 1.5}), "lagrange")  # fmt: skip


@cache
def tabled(where: str) -> em.System:
    """A force by a table of the place, or of the time less 10."""
    return oscillator(em.Table(LINES, name="push")({"place": x, "time": em.t - 10}[where]))


# --- smooth joins ---------------------------------------------------------------------------------------------------

FUNCTIONS = {
    "wave": (sympy.sin, np.sin),
    "bell": (lambda z: sympy.exp(-(z**2)), lambda z: np.exp(-(z**2))),
}


@pytest.mark.parametrize("where", ["place", "time"])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_thousand_cubic_pieces_reject_no_more_steps_than_the_function_they_sample(where, name):
    """Of cubics down to a tolerance of their own error, 2e-8 of the bell; of degree 5 it is below all of these."""
    z = {"place": x, "time": em.t - 10}[where]
    function, sampled = FUNCTIONS[name]
    smooth = oscillator(function(z))
    points = np.linspace(-10.0, 10.0, 1001)
    cubic = si.CubicSpline(points, sampled(points))
    quintic = si.make_interp_spline(points, sampled(points), k=5)
    for method in METHODS:
        for rtol, curves in ((1e-6, (cubic, quintic)), (1e-9, (quintic,)), (1e-12, (quintic,))):
            given = {"method": method, "rtol": rtol, "atol": rtol}
            right = smooth.simulate((0, 20), **given)
            for curve in curves:
                found = tabled(where).simulate((0, 20), parameters={"push": curve}, **given)
                assert found.nrejected <= right.nrejected, (method, rtol)
                assert found.nsteps <= right.nsteps + 2, (method, rtol)
                assert found.x[0, -1] == pytest.approx(right.x[0, -1], abs=4 * rtol)


# --- rough joins in time --------------------------------------------------------------------------------------------


def free(table: em.Table) -> em.System:
    """A mass that a table of the time pushes: its place is the second integral of the table."""
    return system_for(em.Model(name="free", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                               forces={x: table(em.t)}), "lagrange")  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("origin", [0.0, 1e6])
def test_jumps_at_known_times_reject_no_step(method, origin):
    """Each side is seen from that side alone: no error is made of the jump."""
    levels = si.PPoly(LEVELS.c, KNOTS + origin)
    place = levels.antiderivative(2)
    found = free(em.Table(levels, name="push")).simulate(
        (origin - 10, origin + 10), method=method, rtol=1e-9, atol=1e-9
    )
    assert found.success
    assert found.nrejected == 0
    assert found.nsteps <= 3 * 40
    np.testing.assert_allclose(found.x[0], place(found.t), rtol=0, atol=1e-9 + 1e-14 * origin)
    assert all(np.abs(found.t - knot).min() <= 2e-16 * origin + 1e-15 for knot in levels.x)
    back = free(em.Table(levels, name="push")).simulate(
        (origin + 10, origin - 10), method=method, rtol=1e-9, x0=found.x[:, -1], v0=found.v[:, -1]
    )
    assert back.nrejected == 0
    np.testing.assert_allclose(back.x[0, -1], 0.0, rtol=0, atol=1e-7 + 1e-12 * origin)


@pytest.mark.parametrize("method", METHODS)
def test_jumps_of_a_table_of_a_line_in_time(method):
    """Of 3 t - 2, and where the table repeats."""
    levels = si.PPoly(LEVELS.c[:, 20:28], KNOTS[20:29])  # from 0 to 4
    for outside, end in (("refuse", 2.0), ("periodic", 9.0)):
        table = em.Table(levels, outside=outside, name="push")
        system = system_for(em.Model(name="faster", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                                     forces={x: table(3 * em.t - 2)}), "lagrange")  # fmt: skip
        found = system.simulate((2 / 3, end), method=method, rtol=1e-10, atol=1e-12)
        times = 2 / 3 + np.arange(int((3 * end - 2) / 0.5) + 1) / 6
        force = si.PPoly(
            levels(3 * (times[:-1] + 0.01) - 2 - 4 * np.floor((3 * times[:-1] - 2 + 0.01) / 4))[None], times
        )
        assert found.success
        assert found.nrejected == 0
        right = force.antiderivative(2)
        np.testing.assert_allclose(found.x[0, -1], right(end), rtol=0, atol=1e-10)


@pytest.mark.parametrize("origin", [0.0, 1e3, 1e6])
def test_a_path_whose_acceleration_jumps_rejects_few_steps(origin):
    """Pchip's curve: 20 pieces once took 900 steps, and as many attempts besides."""
    model = em.Model(name="driven", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, inputs={path: 0.0},
                     holonomic_constraints={"drive": x - path}, outputs={"force": -em.multiplier("drive")})  # fmt: skip
    system = system_for(model, "lagrange")
    knots = np.linspace(0.0, 10.0, 21)
    curve = si.PchipInterpolator(knots + origin, np.sin(knots) + 0.1 * np.sin(3 * knots))
    start = {"x0": [float(curve(origin))], "v0": [float(curve(origin, 1))]}
    for method in METHODS:
        found = system.simulate((origin, origin + 10), inputs={"path": curve}, rtol=1e-9, method=method, **start)
        assert found.success
        assert found.nsteps <= 100
        assert found.nrejected <= 8
        np.testing.assert_allclose(found.x[0], curve(found.t), rtol=0, atol=1e-14 + 1e-15 * origin)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("origin", [1e8, 1e9])
def test_a_path_is_followed_however_late_it_is(origin, method):
    """Times are coarser than the tolerances there; the run once ended at a knot, with words of dependent rows."""
    model = em.Model(
        name="driven_crank", coordinates=[x, y], inputs={path: 0.0}, holonomic_constraints={"drive": x - path},
        kinetic_energy=(2 * x.diff() ** 2 + y.diff() ** 2 + y**2 * x.diff() ** 2) / 2,
        potential_energy=9.81 * y * sympy.sin(x) + 200 * (y - 0.5) ** 2 / 2, initial={y: 0.5},
    )  # fmt: skip
    system = system_for(model, "lagrange")
    knots = np.linspace(0.0, 10.0, 21)
    curve = si.PchipInterpolator(knots + origin, np.sin(knots))
    start = {"x0": [float(curve(origin)), 0.5], "v0": [float(curve(origin, 1)), 0.0]}
    found = system.simulate((origin, origin + 4), inputs={"path": curve}, rtol=1e-8, method=method, **start)
    assert found.success
    np.testing.assert_allclose(found.x[0], curve(found.t), rtol=0, atol=1e-15 * origin)
    early = si.PchipInterpolator(knots, np.sin(knots))
    right = system.simulate((0, 4), inputs={"path": early}, rtol=1e-11, method=method, **start)
    np.testing.assert_allclose(found.x[1, -1], right.x[1, -1], rtol=0, atol=1e-15 * origin + 1e-6)


# --- rough joins in coordinates -------------------------------------------------------------------------------------

MOST = {"dop853": 3.0, "ra15": 10.0, "radau9": 4.0}
"""Rejections for each join that is passed."""


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("curve", [LINES, LEVELS], ids=["bends", "jumps"])
def test_joins_in_coordinates_are_found_in_few_attempts(method, curve):
    """The energy with the force's integral is conserved across them."""
    work = si.PPoly.from_spline(LINES).antiderivative() if curve is LINES else LEVELS.antiderivative()
    for rtol in (1e-6, 1e-9):
        found = tabled("place").simulate((0, 20), x0=[1.45], parameters={"push": curve}, method=method, rtol=rtol,
                                         atol=rtol, max_steps=5000)  # fmt: skip
        assert found.success
        passed = np.abs(np.diff(np.searchsorted(KNOTS, found.x[0]))).sum()
        assert passed > 40
        assert found.nrejected <= MOST[method] * passed
        energy = found.v[0] ** 2 / 2 + found.x[0] ** 2 - work(found.x[0])
        np.testing.assert_allclose(energy, energy[0], rtol=0, atol=300 * rtol)


@pytest.mark.parametrize("method", METHODS)
def test_a_motion_that_turns_at_a_join_goes_on(method):
    """The force is odd: from rest at the join at 1.5 the motion turns at that at -1.5, and comes back, and so on."""
    for rtol in (1e-6, 1e-9, 1e-12):
        found = tabled("place").simulate((0, 20), x0=[1.5], method=method, rtol=rtol, atol=rtol, max_steps=3000)
        assert found.success
        work = si.PPoly.from_spline(LINES).antiderivative()
        energy = found.v[0] ** 2 / 2 + found.x[0] ** 2 - work(found.x[0])
        np.testing.assert_allclose(energy, energy[0], rtol=0, atol=300 * rtol + 1e-11)
