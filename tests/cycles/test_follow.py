"""Branches of equilibria and cycles against closed forms and published bifurcations."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from sympy import cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, ModelError, System

from ..support.generation import system_for, system_of
from .test_find_cycle import duffing, van_der_pol, walker

x, y = dynamicsymbols("x y")
a, b, c, d, k, P, W = symbols("a b c d k P W")


def kinds(branch: em.Branch) -> list[str]:
    return [one.kind for one in branch.special]


def test_a_bead_on_a_hoop():
    """Pitchfork at Omega^2 = g / R; the other branch is cos(theta) = g / (R Omega^2)."""
    system = system_of("rotating_hoop", "lagrange")
    critical = np.sqrt(9.81 / 0.5)
    low = em.follow(em.find_equilibrium(system, [0.0], parameters={"Omega": 3}), "Omega", to=6)
    assert low.success
    assert kinds(low) == ["branch point"]
    assert low.special[0].parameter == pytest.approx(critical, rel=1e-9)
    up = em.find_equilibrium(system, [1.0], parameters={"Omega": 6})
    bent = em.follow(up, "Omega", to=4.5)
    assert np.cos(bent.x0["theta"]) == pytest.approx(9.81 / (0.5 * bent.parameter**2), rel=1e-10)


def test_a_snap_through_truss():
    """Von Mises' truss, force against height: F = 2 k h (L / sqrt(h^2 + a^2) - 1), folds at its extrema."""
    F = symbols("F")
    length = (x**2 + 1) ** 0.5
    truss = Model(name="truss", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                  potential_energy=k * (length - 1.2) ** 2, forces=[-F - d * x.diff()],
                  parameters={k: 1.0, d: 0.3, F: 0.0})  # fmt: skip
    system = system_for(truss, "lagrange")
    start = em.find_equilibrium(system, {"x": np.sqrt(1.2**2 - 1)})
    branch = em.follow(start, "F", to=0.2)
    height = np.sqrt(1.2 ** (2 / 3) - 1)
    force = 2 * height * (1.2 / np.sqrt(height**2 + 1) - 1)
    assert kinds(branch) == ["fold", "fold"]
    assert [one.parameter for one in branch.special] == pytest.approx([force, -force], rel=1e-9)
    assert [one.x0["x"] for one in branch.special] == pytest.approx([height, -height], rel=1e-6)
    assert branch.stable[0] is True
    assert branch.stable[branch.special[0].row + 1] is False
    assert branch.stable[-1] is True


@cache
def ziegler() -> System:
    """Two links with springs and dampers at both joints, masses 2 m and m at joints and tip; P follows the tip."""
    x1, x2 = dynamicsymbols("x1 x2")
    r1 = (sin(x1), cos(x1))
    r2 = (r1[0] + sin(x2), r1[1] + cos(x2))
    v1, v2 = ([one.diff(em.t) for one in r] for r in (r1, r2))
    kinetic = (2 * (v1[0] ** 2 + v1[1] ** 2) + v2[0] ** 2 + v2[1] ** 2) / 2
    push = (-P * sin(x2), -P * cos(x2))
    forces = [sum(p * r.diff(q) for p, r in zip(push, r2, strict=True)) for q in (x1, x2)]
    forces[0] -= d * x1.diff() + c * (x1.diff() - x2.diff())
    forces[1] -= c * (x2.diff() - x1.diff())
    return system_for(
        Model(name="ziegler", coordinates=[x1, x2], kinetic_energy=kinetic,
              potential_energy=x1**2 / 2 + (x1 - x2) ** 2 / 2, forces=forces, parameters={P: 0.0, d: 0.1, c: 0.1}),
        "lagrange")  # fmt: skip


def flutter_load(d: float, c: float) -> float:
    """Routh and Hurwitz: of M s^2 + C s + K(P), (a3 a2 - a4 a1) a1 = a3^2 a0 of the characteristic polynomial."""

    def hurwitz(load: float) -> float:
        M, C, K = (
            np.array([[3, 1], [1, 1]]),
            np.array([[d + c, -c], [-c, c]]),
            np.array([[2 - load, load - 1], [-1, 1]]),
        )
        entry = [[[M[i, j], C[i, j], K[i, j]] for j in range(2)] for i in range(2)]
        a4, a3, a2, a1, a0 = np.polysub(np.polymul(entry[0][0], entry[1][1]), np.polymul(entry[0][1], entry[1][0]))
        return float((a3 * a2 - a4 * a1) * a1 - a3**2 * a0)

    return float(brentq(hurwitz, 0.5, 2.5, xtol=1e-14))


@pytest.mark.parametrize(("d", "c"), [(0.1, 0.1), (0.01, 0.01), (0.3, 0.1)])
def test_zieglers_column_flutters(d, c):
    """Follower load of Ziegler (1952): with damping d, c of 1 : 1 the limit of small damping is 41/28 k / l."""
    start = em.find_equilibrium(ziegler(), [0.0, 0.0], parameters={"d": d, "c": c})
    branch = em.follow(start, "P", to=3.0)
    assert kinds(branch)[0] == "Hopf"
    assert branch.special[0].parameter == pytest.approx(flutter_load(d, c), rel=1e-9)
    if d == c:
        assert branch.special[0].parameter == pytest.approx(41 / 28 + d * d / 2, rel=1e-9)


def test_zieglers_column_without_damping():
    """Frequencies meet at P = 7/2 - sqrt(2): det(K - s M) = 2 s^2 - (7 - 2 P) s + 1 has a double root."""
    start = em.find_equilibrium(ziegler(), [0.0, 0.0], parameters={"d": 0.0, "c": 0.0})
    branch = em.follow(start, "P", to=2.5)
    assert kinds(branch) == ["flutter"]
    assert branch.special[0].parameter == pytest.approx(3.5 - np.sqrt(2), rel=1e-9)
    assert branch.stable[0] is None
    assert branch.stable[-1] is False


def test_a_rotor_with_internal_damping_whirls():
    """Jeffcott's rotor in fixed axes: stable up to W = sqrt(k / m) (1 + external / internal)."""
    outer, inner = symbols("outer inner")
    rotor = Model(name="rotor", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                  potential_energy=k * (x**2 + y**2) / 2,
                  forces=[-(outer + inner) * x.diff() - inner * W * y, -(outer + inner) * y.diff() + inner * W * x],
                  parameters={k: 4.0, outer: 0.3, inner: 0.2, W: 1.0})  # fmt: skip
    start = em.find_equilibrium(system_for(rotor, "lagrange"), [0.0, 0.0])
    branch = em.follow(start, "W", to=8.0)
    assert kinds(branch) == ["Hopf"]
    assert branch.special[0].parameter == pytest.approx(2.0 * (1 + 0.3 / 0.2), rel=1e-10)
    assert sorted(branch.special[0].values.imag)[-1] == pytest.approx(2.0, rel=1e-8)


def fold_of_harmonics(w: float, first: tuple[float, float], harmonics: int = 15) -> float:
    """The frequency w of a fold of x'' + 0.2 x' + x + x^3 = 0.3 cos(w t), by Newton's method for Fourier sums.

    Unknowns are cosines and sines of odd harmonics, the null vector of their equations, and w.
    """
    phase = 2 * np.pi * np.arange(8 * harmonics) / (8 * harmonics)
    odd = np.arange(1, 2 * harmonics, 2)
    waves, k = np.vstack([np.cos(np.outer(odd, phase)), np.sin(np.outer(odd, phase))]), 2 * harmonics
    turn = np.kron([[0, 1], [-1, 0]], np.diag(odd))  # of d/dphase
    u, onto = np.zeros(k), waves / (4 * harmonics)
    u[0], u[harmonics] = first

    def linear(w: float) -> np.ndarray:
        return w**2 * turn @ turn + 0.2 * w * turn + np.eye(k)

    J = linear(w) + 3 * onto * (u @ waves) ** 2 @ waves.T
    null = np.linalg.svd(J)[2][-1]
    norm = null.copy()
    for _ in range(30):
        here, by_w = u @ waves, 2 * w * turn @ turn + 0.2 * turn
        J = linear(w) + 3 * onto * here**2 @ waves.T
        F = linear(w) @ u + onto @ here**3 - 0.3 * np.eye(k)[0]
        bend = 6 * onto * (here * (null @ waves)) @ waves.T
        whole = np.block([[J, np.zeros((k, k)), (by_w @ u)[:, None]], [bend, J, (by_w @ null)[:, None]],
                          [np.zeros((1, k)), norm[None], np.zeros((1, 1))]])  # fmt: skip
        step = np.linalg.solve(whole, np.concatenate([F, J @ null, [norm @ null - 1]]))
        u, null, w = u - step[:k], null - step[k : 2 * k], w - step[-1]
    assert np.abs(step).max() < 1e-12
    return float(w)


def test_folds_of_a_resonance():
    """Forced Duffing: folds in frequency as harmonic balance finds them; the product of multipliers all along."""
    start = em.find_cycle(duffing(), x0={"x": 0.3}, period="2*pi/w", parameters={"w": 0.8})
    branch = em.follow(start, "w", to=2.5)
    assert branch.success
    assert kinds(branch) == ["fold", "fold"]
    assert np.prod(branch.values, axis=1) == pytest.approx(np.exp(-0.2 * branch.period), rel=1e-9)
    for fold in branch.special:
        cycle = em.find_cycle(duffing(), x0=fold.x0, v0=fold.v0, period=fold.period, parameters={"w": fold.parameter})
        assert cycle.multipliers[0] == pytest.approx(1.0, abs=1e-4)
        first = fold.x0["x"], fold.v0["x"] / fold.parameter
        assert fold.parameter == pytest.approx(fold_of_harmonics(fold.parameter + 1e-3, first), rel=1e-9)


def test_van_der_pol_along_mu():
    branch = em.follow(em.find_cycle(van_der_pol(), x0={"x": 2.0}, v0={"x": 0.0}), "mu", to=2.0)
    assert branch.success
    run = solve_ivp(lambda _, s: [s[1], 2 * (1 - s[0] ** 2) * s[1] - s[0]], (0, 60), [2.0, 0.0], method="DOP853",
                    rtol=1e-13, atol=1e-13, events=lambda _, s: s[1])  # fmt: skip
    period = run.t_events[0][-1] - run.t_events[0][-3]
    assert branch.period[-1] == pytest.approx(period, rel=1e-9)
    assert branch.highest["x"][-1] == pytest.approx(np.abs(run.y_events[0][-1][0]), rel=1e-4)


def steps(start: np.ndarray, gamma: float, count: int) -> np.ndarray:
    """Garcia's walker right after a strike, (theta, theta'), some steps later: by SciPy, with equations of its own."""

    def rates(_: float, s: np.ndarray) -> list[float]:
        swing = np.sin(s[0] - gamma) + s[2] ** 2 * np.sin(s[1]) - np.cos(s[0] - gamma) * np.sin(s[1])
        return [s[2], s[3], np.sin(s[0] - gamma), swing]

    def strike(t: float, s: np.ndarray) -> float:
        return s[1] - 2 * s[0] if t > 0.05 else 1.0

    strike.terminal, strike.direction = True, 1
    theta, rate = start
    for _ in range(count):
        begin = [theta, 2 * theta, rate, (1 - np.cos(2 * theta)) * rate]
        run = solve_ivp(rates, (0, 10), begin, method="DOP853", rtol=1e-12, atol=1e-13, events=strike)
        before = run.y_events[0][-1]
        theta, rate = -before[0], np.cos(2 * before[0]) * before[2]
    return np.array([theta, rate])


def test_the_simplest_walker_doubles_its_period():
    """Gaits of 1, 2 and 4 steps, each until the next has twice as many: another program's map closes, with -1.

    Published: one step is stable up to 0.015 (Garcia et al. 1998); chaos begins at 0.01839 (Kurz and Stergiou,
    J. NeuroEngineering Rehabil. 4:30, 2007).
    """
    branch, count = em.follow(walker(0.2, -0.2), "gamma", to=0.0185), 1
    for slope in (0.015088438, 0.017669375, 0.018160120):
        assert branch.success
        assert kinds(branch) == ["doubling"]
        at, gamma = branch.special[0], branch.special[0].parameter
        assert gamma == pytest.approx(slope, abs=1e-9)
        start = np.array([at.x0["theta"], at.v0["theta"]])
        assert steps(start, gamma, count) == pytest.approx(start, abs=1e-9)
        sides = [[steps(start + side * h, gamma, count) for side in (1, -1, 2, -2)] for h in 1e-5 * np.eye(2)]
        map_of = np.array([(8 * (a - b) - (c - d)) / 12e-5 for a, b, c, d in sides]).T
        assert min(np.linalg.eigvals(map_of).real) == pytest.approx(-1.0, abs=2e-5)
        branch, count = em.follow(at, to=0.0185), 2 * count


def test_the_other_branch_of_a_hoop():
    rests = em.find_equilibrium(system_of("rotating_hoop", "lagrange"), [0.0], parameters={"Omega": 3})
    low = em.follow(rests, "Omega", to=6)
    bent = em.follow(low.special[0], to=6)
    assert bent.success
    assert np.cos(bent.x0["theta"]) == pytest.approx(9.81 / (0.5 * bent.parameter**2), rel=1e-10)
    assert np.abs(bent.x0["theta"][-1]) > 0.9
    with pytest.raises(ModelError, match="along Omega"):
        em.follow(low.special[0], "g", to=6)


def test_cycles_begin_at_a_hopf_bifurcation():
    """x'' - (a - x^2) x' + x = 0 is van der Pol's oscillator in units of sqrt(a); it begins as 2 sqrt(a) cos t."""
    model = Model(name="begins", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                  forces=[(a - x**2) * x.diff()], parameters={a: -0.5})  # fmt: skip
    rest = em.follow(em.find_equilibrium(system_for(model, "lagrange"), [0.0]), "a", to=1.0)
    assert kinds(rest) == ["Hopf"]
    assert rest.special[0].parameter == pytest.approx(0.0, abs=1e-9)
    cycles = em.follow(rest.special[0], to=1.0)
    assert cycles.success
    assert all(cycles.stable)
    assert cycles.period[-1] == pytest.approx(6.663286859323130, rel=1e-9)
    assert cycles.highest["x"][:5] == pytest.approx(2 * np.sqrt(cycles.parameter[:5]), rel=1e-3)
    legend = rest.plot(cycles).axes[0].get_legend().get_texts()
    assert [one.get_text() for one in legend] == ["stable", "unstable", "Hopf"]


def test_zieglers_column_flutters_with_an_amplitude():
    """Cycles begin with the frequency of the Hopf bifurcation, by Hurwitz omega^2 = a1 / a3 = 4/9, and are stable."""
    start = em.find_equilibrium(ziegler(), [0.0, 0.0], parameters={"d": 0.3, "c": 0.1})
    rest = em.follow(start, "P", to=2.5)
    cycles = em.follow(rest.special[0], to=2.5)
    assert cycles.success
    assert all(cycles.stable)
    assert cycles.period[0] == pytest.approx(3 * np.pi, rel=1e-4)
    assert (np.diff(cycles.highest["x2"]) > 0.0).all()


def test_a_length_in_a_constraint():
    """A slider crank along the length of its rod: with a constraint, and with the slider as a function of the angle."""
    q, tau, rod = dynamicsymbols("q"), symbols("tau"), symbols("rod")
    slide = cos(q) + sqrt(rod**2 - sin(q) ** 2)
    given = {"forces": [tau - c * q.diff()], "parameters": {tau: 3.0, c: 0.5, rod: 3.0}}
    reduced = Model(name="crank", coordinates=[q], kinetic_energy=q.diff() ** 2 + 2 * slide.diff(em.t) ** 2, **given)
    closed = Model(name="slider", coordinates=[q, x], kinetic_energy=q.diff() ** 2 + 2 * x.diff() ** 2,
                   holonomic_constraints=[(x - cos(q)) ** 2 + sin(q) ** 2 - rod**2], initial={x: 4.0},
                   **given | {"forces": [tau - c * q.diff(), 0]})  # fmt: skip
    turn = {"symmetry": {"q": "q + 2*pi"}, "section": "q"}
    right = em.follow(
        em.find_cycle(system_for(reduced, "lagrange"), x0={"q": 0.0}, v0={"q": 5.0}, **turn), "rod", to=2.0
    )
    start = em.find_cycle(system_for(closed, "lagrange"), x0={"q": 0.0, "x": 4.0}, v0={"q": 5.0}, **turn)
    found = em.follow(start, "rod", to=2.0)
    assert found.success
    assert found.x0["x"] == pytest.approx(1 + found.parameter, rel=1e-10)
    assert found.period[-1] == pytest.approx(right.period[-1], rel=1e-9)
    assert found.values[-1] == pytest.approx(right.values[-1], rel=1e-7)


def test_a_branch_ends_where_cycles_vanish():
    """x'' - (a - u - x^2) x' + x = 0 along the input u, from a = 1 to its Hopf bifurcation at u = 1."""
    u = dynamicsymbols("u")
    model = Model(name="ends", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                  forces=[(a - u - x**2) * x.diff()], parameters={a: 1.0}, inputs={u: 0.0})  # fmt: skip
    start = em.find_cycle(system_for(model, "lagrange"), x0={"x": 2.0}, v0={"x": 0.0})
    branch = em.follow(start, "u", to=1.5)
    assert not branch.success
    assert "equilibrium" in branch.message
    assert branch.parameter[-1] == pytest.approx(1.0, abs=1e-5)


def test_a_second_frequency_appears():
    """Beside van der Pol's cycle an oscillator whose damping d changes its sign: multipliers exp((-d/2 + i w) T)."""
    model = Model(name="beside", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                  potential_energy=(x**2 + 3 * y**2) / 2, forces=[(1 - x**2) * x.diff(), -d * y.diff() - y * x**2 / 9],
                  parameters={d: 0.6})  # fmt: skip
    start = em.find_cycle(system_for(model, "lagrange"), x0={"x": 2.0, "y": 0.0}, v0={"x": 0.0, "y": 0.0})
    branch = em.follow(start, "d", to=-0.3)
    assert kinds(branch) == ["torus"]
    assert branch.special[0].parameter == pytest.approx(0.0, abs=1e-9)


def test_a_family_is_followed_by_what_is_free():
    """Swings of a pendulum of one amplitude along its length: T^2 is proportional to it."""
    system = system_of("pendulum", "lagrange")
    swing = em.find_cycle(system, x0={"theta": 1.0}, free=["period"])
    branch = em.follow(swing, "l", to=2.0)
    assert branch.success
    assert branch.x0["theta"] == pytest.approx(1.0, abs=1e-12)
    assert branch.period**2 == pytest.approx(swing.period**2 * branch.parameter, rel=1e-9)
    with pytest.raises(ModelError, match="one of a family"):
        em.follow(em.find_cycle(system, x0={"theta": 1.0}), "l", to=2.0)


def test_a_number_is_no_period_of_a_forcing_that_changes():
    """With a period that stays, motions close once along w, but the forcing is another one a period later."""
    start = em.find_cycle(duffing(), x0={"x": 0.3}, period=2 * np.pi / 1.2)
    with pytest.raises(ModelError, match=r"at w = .*the forcing does not repeat.*period='2\*pi/w'"):
        em.follow(start, "w", to=1.3)
    assert em.follow(start, "A", to=0.32).success


def test_a_forcing_that_is_absent_at_the_start():
    model = Model(name="driven", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                  forces=[(1 - x**2) * x.diff() + a * cos(3 * em.t)], parameters={a: 0.0})  # fmt: skip
    start = em.find_cycle(system_for(model, "lagrange"), x0={"x": 2.0}, v0={"x": 0.0})
    with pytest.raises(ModelError, match=r"the forcing does not repeat.*Begin where the forcing acts"):
        em.follow(start, "a", to=0.5)


@pytest.mark.parametrize("shift", [0.0, 1.0])
def test_an_impact_moves_onto_the_start(shift):
    """A ball bounces once a period on a table a sin(2 pi t + shift): the fold, at a = u / (2 pi), is a hit at phase 0.

    u is the speed of the table at the hit, g (1 - e) / (2 (1 + e)).
    """
    e, g, top = 0.5, 9.81, 9.81 / 2
    table = a * sin(2 * np.pi * em.t + shift)
    model = Model(name="on_table", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=g * x,
                  parameters={a: 0.3}, events={"hit": em.Event(x - table, direction=-1, impact=(x - table, e))},
                  initial={x: 0.2, x.diff(): 2.0})  # fmt: skip
    u = top * (1 - e) / (1 + e)
    phase = np.arccos(u / (0.3 * 2 * np.pi))
    left = 1 - ((phase - shift) / (2 * np.pi)) % 1
    start = em.find_cycle(system_for(model, "lagrange"), x0={"x": 0.3 * np.sin(phase) + top * left - g / 2 * left**2},
                          v0={"x": top - g * left}, period=1.0)  # fmt: skip
    assert start.success
    branch = em.follow(start, "a", to=0.2)
    if shift:
        assert kinds(branch)[0] == "fold"
        assert branch.special[0].parameter == pytest.approx(u / (2 * np.pi), rel=1e-8)
    else:
        assert not branch.success
        assert "event 'hit' moves onto the start of the period" in branch.message
        assert "find_cycle at another t" in branch.message


def test_wrong_arguments():
    start = em.find_equilibrium(ziegler(), [0.0, 0.0])
    with pytest.raises(ModelError, match="unknown name to follow"):
        em.follow(start, "Q", to=1.0)
    with pytest.raises(ModelError, match="Give another value"):
        em.follow(start, "P", to=0.0)
    with pytest.raises(ModelError, match="`back` on the other side"):
        em.follow(start, "P", to=1.0, back=0.5)
    with pytest.raises(ModelError, match="leave it out of free"):
        em.follow(start, "P", to=1.0, free=["x1", "P"])
    with pytest.raises(ModelError, match="Give a result of"):
        em.follow({"x1": 0.0}, "P", to=1.0)
