"""Steps by nodes, "ra15": coefficients, order, and what a polynomial does not see of itself: kinks, jumps, peaks."""

import math
import re
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest

from eigenmotion.simulation.method_selection import automatic

from ..support.mechanism_in_c import Mechanism
from ..support.stepping import FINISHED, INCLUDE, PENDULUM, Build, builder, pendulum_angle, signal, simulate
from ..support.structures import NUMBERS

CONSTANT = NUMBERS["EM_CONSTANT"]
KINDS = pytest.mark.parametrize("second_order", [0, 1])


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return builder(tmp_path_factory.mktemp("nodes"))


# --- coefficients -----------------------------------------------------------------------------------------------------


def stated(name):
    text = (INCLUDE / "tableaux/em_radau_nodes.h").read_text()
    body = re.findall(rf"{name}\[.*?= {{(.*?)}};", text, re.DOTALL)[0]
    numbers = np.array([float(word) for word in re.findall(r"[-\d.e]+", body)])
    return numbers if len(numbers) == 8 else numbers.reshape(8, 8)


def lagrange_polynomials(nodes):
    """Coefficients (8, 8), highest power first, of the polynomials that are 1 at one node and 0 at the others."""
    found = []
    for j, node in enumerate(nodes):
        others = [other for k, other in enumerate(nodes) if k != j]
        polynomial = [mpmath.mpf(1)]
        for other in others:
            shifted = [*polynomial, 0]
            for k, coefficient in enumerate(polynomial):
                shifted[k + 1] -= other * coefficient
            polynomial = shifted
        scale = mpmath.fprod(node - other for other in others)
        found.append([coefficient / scale for coefficient in polynomial])
    return found


def integral(polynomial):
    return [c / (len(polynomial) - k) for k, c in enumerate(polynomial)] + [0]


def part_of(polynomial, l):
    """Its coefficient on Legendre's P_l, shifted to [0, 1]."""
    product = mpmath.quad(lambda x: mpmath.polyval(polynomial, x) * mpmath.legendre(l, 2 * x - 1), [0, 1])
    return (2 * l + 1) * product


def test_coefficients_are_those_of_left_radau():
    with mpmath.workdps(50):
        guesses = stated("em_node_place")
        defining = lambda x: mpmath.legendre(7, 2 * x - 1) + mpmath.legendre(8, 2 * x - 1)  # noqa: E731
        nodes = [mpmath.mpf(0), *(mpmath.findroot(defining, guess) for guess in guesses[1:])]
        polynomials = lagrange_polynomials(nodes)
        once = [integral(p) for p in polynomials]
        twice = [integral(p) for p in once]
        legendre = [[part_of(p, l) for l in range(8)] for p in polynomials]
        expected = {
            "em_node_place": nodes,
            "em_end_weight": [mpmath.polyval(p, 1) for p in once],
            "em_integral": [[mpmath.polyval(p, x) for x in nodes] for p in once],
            "em_integral_twice": [[mpmath.polyval(p, x) for x in nodes] for p in twice],
            "em_series_of": legendre,
        }
    for name, numbers in expected.items():
        np.testing.assert_allclose(stated(name), np.array(numbers, dtype=float), rtol=1e-14, atol=1e-17)


# --- order ------------------------------------------------------------------------------------------------------------


@KINDS
def test_order_seen_on_a_smooth_problem(build: Build, second_order: int) -> None:
    """The error over many tolerances at the ends of steps falls with their number: in (x, v) as that of the polynomial;
    in a state of first order as that of the iteration, which gains a power each time, and not two."""
    compiled = build(Mechanism(rhs=PENDULUM.rhs, second_order=second_order))
    steps, errors = [], []
    for rtol in 10.0 ** -np.arange(3, 13):
        runs = [(angle, simulate(compiled, [angle, 0.0], (0.0, 200.0), "ra15", rtol=rtol, atol=rtol))
                for angle in (1.6, 1.8, 2.0, 2.2, 2.4)]  # fmt: skip
        assert all(run.status == FINISHED for _, run in runs)
        steps.append(np.mean([np.log(run.run.n_steps) for _, run in runs]))
        off = [np.abs(run.y[0] - pendulum_angle(run.t, angle)).max() for angle, run in runs]
        errors.append(np.mean(np.log(off)))  # of one run they may be a hundred times as much by chance, in step with it
    order = -np.polyfit(steps, errors, 1)[0]
    assert (12.5 if second_order else 10.5) < order < 19.0


@KINDS
def test_rates_within_steps(build: Build, second_order: int) -> None:
    """Ends of steps are of order 15, the polynomial between of order 10: what is asked within shortens them."""
    compiled = build(Mechanism(rhs=PENDULUM.rhs, second_order=second_order))
    times = np.linspace(0.0, 20.0, 1001)
    for rtol in 10.0 ** -np.arange(5, 13):
        options = {"rtol": rtol, "atol": rtol}
        rows = simulate(compiled, [2.0, 0.0], (0.0, 20.0), "ra15", t_eval=times, **options)
        kept = simulate(compiled, [2.0, 0.0], (0.0, 20.0), "ra15", dense=1, **options)
        middles = [(step, t + part * h) for step, t, h in kept.steps() for part in (0.2, 0.45, 0.7, 0.95)]
        within = np.array([kept.at(step, t)[1] for step, t in middles])
        for t, v in ((times, rows.y[1]), (np.array([t for _, t in middles]), within)):
            assert np.abs(v**2 - 2.0 * (np.cos(pendulum_angle(t, 2.0)) - np.cos(2.0))).max() < 10.0 * rtol


@KINDS
def test_events_within_steps(build: Build, second_order: int) -> None:
    """A pendulum turns at each half of its period: times as right as the ends of steps."""
    compiled = build(Mechanism(rhs=PENDULUM.rhs, second_order=second_order, n_events=1, events="g[0] = v[0];"))
    half = 2.0 * float(mpmath.ellipk(math.sin(1.0) ** 2))
    for rtol in 10.0 ** -np.arange(5, 13):
        run = simulate(compiled, [2.0, 0.0], (0.0, 20.0), "ra15", rtol=rtol, atol=rtol)
        np.testing.assert_allclose(run.event_times(0), half * np.arange(1, 5), rtol=0, atol=10.0 * rtol)


# --- what a polynomial does not see -----------------------------------------------------------------------------------

KINK = "dy[0] = y[1]; dy[1] = t > u[0] ? t - u[0] : 0.0;"
JUMP = "dy[0] = y[1]; dy[1] = t > u[0] ? 1.0 : 0.0;"
KNOCK = "dy[0] = y[1]; dy[1] = t > u[0] && t < u[0] + 0.3 ? 1.0 : 0.0;"
PEAK = "dy[0] = y[1]; dy[1] = 1e-3 / ((t - u[0]) * (t - u[0]) + 1e-6) - y[0];"


@KINDS
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize(
    ("rhs", "end"),
    [
        (KINK, lambda s: (s**3 / 6, s**2 / 2)),
        (JUMP, lambda s: (s**2 / 2, s)),
        (KNOCK, lambda s: (0.3 * (s - 0.15), 0.3)),
    ],
    ids=["kink", "jump", "knock"],
)
def test_kinks_and_jumps_anywhere_in_a_step(build: Build, second_order: int, rtol: float, rhs: str, end) -> None:
    """A force that sets in at u: found at whatever place within a step it lies, also behind the last node."""
    compiled, worst = build(Mechanism(rhs=rhs, n_inputs=1, second_order=second_order)), 0.0
    for start in np.linspace(1.0, 3.0, 67):
        given = [signal(CONSTANT, [0.0], [start])]
        run = simulate(compiled, [1.0, 0.0], (0.0, 10.0), "ra15", rtol=rtol, atol=rtol, inputs=given, max_step=1.0)
        assert run.status == FINISHED
        x, v = end(10.0 - start)
        worst = max(worst, abs(run.y[0, -1] - 1.0 - x) / (1.0 + x), abs(run.y[1, -1] - v) / (1.0 + v))
    assert worst < 8 * rtol


def peak_response(t: float, centre: float) -> tuple[float, float]:
    """x, v at t of x'' = -x + peak, from rest: Duhamel's integral."""
    force = lambda z: 1e-3 / ((z - centre) ** 2 + 1e-6)  # noqa: E731
    places = [0, centre - 0.1, centre - 0.01, centre, centre + 0.01, centre + 0.1, t]
    return tuple(float(mpmath.quad(lambda z, f=f: f(t - z) * force(z), places)) for f in (mpmath.sin, mpmath.cos))


@KINDS
@pytest.mark.parametrize("rtol", [1e-4, 1e-7, 1e-10])
def test_a_peak_as_narrow_as_a_thousandth_of_a_step(build: Build, second_order: int, rtol: float) -> None:
    compiled = build(Mechanism(rhs=PEAK, n_inputs=1, second_order=second_order))
    for centre in (1.234, 2.5):
        given = [signal(CONSTANT, [0.0], [centre])]
        run = simulate(compiled, [0.0, 0.0], (0.0, 5.0), "ra15", rtol=rtol, atol=rtol, inputs=given)
        assert run.status == FINISHED
        assert np.abs(run.y[:, -1] - peak_response(5.0, centre)).max() < 100 * rtol


@pytest.mark.parametrize("rtol", [1e-3, 1e-9])
@pytest.mark.parametrize("method", ["dopri5", "dop853", "ra15"])
def test_a_stiff_damper_ends_right_and_is_noticed(build: Build, method: str, rtol: float) -> None:
    """Its rate lets no iteration converge, and no explicit method be stable, but in short steps."""
    damper = build(Mechanism(rhs="dy[0] = y[1]; dy[1] = -1e5 * (y[1] - cos(t));"))
    run = simulate(damper, [0.0, 1.0], (0.0, 0.2), method, rtol=rtol, atol=rtol)
    assert run.status == FINISHED
    assert run.y[0, -1] == pytest.approx(math.sin(0.2), abs=10 * rtol + 2e-6)
    assert run.run.n_stiff > 0.8 * run.run.n_steps
    pendulum = build(PENDULUM)
    smooth = simulate(pendulum, [2.0, 0.0], (0.0, 100.0), method, rtol=rtol, atol=rtol)
    assert smooth.run.n_stiff == 0


@KINDS
def test_backwards_is_forwards(build: Build, second_order: int) -> None:
    compiled = build(Mechanism(rhs=PENDULUM.rhs, second_order=second_order))
    there = simulate(compiled, [2.0, 0.3], (0.0, 7.0), "ra15", rtol=1e-11, atol=1e-11)
    back = simulate(compiled, there.y[:2, -1], (7.0, 0.0), "ra15", rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(back.y[:, -1], [2.0, 0.3], atol=1e-9)
    assert math.isclose(back.t[-1], 0.0)


@pytest.mark.parametrize(
    ("n", "formulation", "lanes", "least"),
    [
        (3, "eigenfactor", 1, 0.0),
        (3, "eigenfactor", 4, 1e-6),
        (16, "lagrange", 4, 1e-5),
        (16, "eigenfactor", 4, 1e-11),
        (5, "eigenfactor", 8, 1e-6),
        (8, "eigenfactor", 8, 1e-7),
        (10, "eigenfactor", 8, 1e-8),
        (16, "eigenfactor", 8, 1e-10),
    ],
)
def test_auto_takes_nodes_from_the_tolerance_on_at_which_they_pay(n, formulation, lanes, least):
    n_state = 2 * n + (n**2 + n if formulation == "eigenfactor" else 0)
    model = SimpleNamespace(n=n, n_state=n_state, formulation=formulation, lanes=lanes)
    for tolerance in (1e-2, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12):
        assert automatic(model, tolerance, False).name == ("ra15" if tolerance <= least else "dop853")
