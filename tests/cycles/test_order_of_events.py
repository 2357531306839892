"""Branches of cycles past changes of the order of events: closed forms of bouncing balls and impact oscillators."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Event, Friction, Model

from ..support.generation import system_for
from .test_follow import kinds

x, y, z = dynamicsymbols("x y z")
a, b, c, d, e, k, w, mu, F = symbols("a b c d e k w mu F")
G, W, T = 9.81, 30.0, 2 * np.pi / 30.0


def phase(stroke: float, again: float) -> float:
    """The angle of the table at which a ball hits it once a period."""
    return float(np.arccos((1 - again) * G * T / (2 * (1 + again) * stroke * W)))


def start_of(stroke: float, again: float, t: float) -> tuple[float, float]:
    """Height and speed at a time, in closed form: it flies from z = a sin(phase) with g T / 2."""
    hit = phase(stroke, again) / W
    since = (t - hit) % T
    return stroke * np.sin(W * hit) + G * T / 2 * since - G * since**2 / 2, G * T / 2 - G * since


def two_balls(damping: float, inertia: float) -> em.System:
    """Two balls on tables of strokes a, b, with a damper or an inertia between them."""
    gaps = z - a * sin(w * em.t), y - b * sin(w * em.t)
    return system_for(
        Model(name="two_balls", coordinates=[z, y],
              kinetic_energy=(z.diff() ** 2 + y.diff() ** 2) / 2 + k * z.diff() * y.diff(),
              potential_energy=G * (1 + k) * (z + y), forces=[d * (y.diff() - z.diff()), d * (z.diff() - y.diff())],
              parameters={a: 0.012, b: 0.014, w: W, e: 0.8, d: damping, k: inertia},
              events={"left": Event(gaps[0], direction=-1, impact=(gaps[0], e)),
                      "right": Event(gaps[1], direction=-1, impact=(gaps[1], e))}),
        "lagrange")  # fmt: skip


def both(damping: float = 0.0, inertia: float = 0.0) -> em.Cycle:
    t = phase(0.012, 0.8) / W + T / 2
    (z0, z1), (y0, y1) = start_of(0.012, 0.8, t), start_of(0.014, 0.8, t)
    found = em.find_cycle(two_balls(damping, inertia), x0={"z": z0, "y": y0}, v0={"z": z1, "y": y1}, period=T, t=t)
    assert found.success
    assert found.events == ("left", "right")
    return found


def test_two_hits_at_once_that_do_not_disturb_each_other():
    """At equal strokes both balls hit at once; the branch goes on with the closed form on both sides."""
    start = both()
    branch = em.follow(start, "a", to=0.016)
    assert branch.success
    assert [one.kind for one in branch.special] == ["corner"]
    assert branch.special[0].events == ("left", "right")
    assert branch.special[0].parameter == pytest.approx(0.014, abs=1e-10)
    heights = [start_of(stroke, 0.8, start.t)[0] for stroke in branch.parameter]
    assert branch.x0["z"] == pytest.approx(heights, abs=1e-9)


def after_a_period(start: np.ndarray, t: float, stroke: float, damping: float) -> np.ndarray:
    """The state (z, y, z', y') of two balls with a damper a period later: by SciPy, hit by hit."""

    def rates(_: float, s: np.ndarray) -> list[float]:
        return [s[2], s[3], -G + damping * (s[3] - s[2]), -G + damping * (s[2] - s[3])]

    state, now, strokes = start, t, (stroke, 0.014)
    while now < t + T:
        hits = [lambda at, s, j=j: s[j] - strokes[j] * np.sin(W * at) for j in range(2)]
        for one in hits:
            one.terminal, one.direction = True, -1
        run = solve_ivp(rates, (now, t + T), state, method="DOP853", rtol=1e-12, atol=1e-14, events=hits)
        state, now = run.y[:, -1].copy(), run.t[-1]
        for j in range(2):
            if len(run.t_events[j]):
                speed = strokes[j] * W * np.cos(W * now)
                state[2 + j] = speed - 0.8 * (state[2 + j] - speed)
    return state


def test_two_hits_at_once_with_a_damper():
    """By symmetry they are at once at equal strokes; beyond, derivatives are others, and motions still close."""
    start = both(damping=0.5)
    branch = em.follow(start, "a", to=0.016)
    assert branch.success
    [corner] = [one for one in branch.special if one.kind == "corner"]
    assert corner.parameter == pytest.approx(0.014, abs=1e-10)
    for row in (0, corner.row - 1, corner.row + 1, corner.row + 3, len(branch.parameter) - 1):
        state = np.array([branch.x0["z"][row], branch.x0["y"][row], branch.v0["z"][row], branch.v0["y"][row]])
        end = after_a_period(state, start.t, branch.parameter[row], 0.5)
        assert end == pytest.approx(state, abs=1e-9)
    last = {"x0": {name: one[-1] for name, one in branch.x0.items()},
            "v0": {name: one[-1] for name, one in branch.v0.items()}}  # fmt: skip
    end = em.find_cycle(start.system, **last, period=T, t=start.t, parameters={"a": 0.016, "d": 0.5})
    assert end.events == ("right", "left")
    figure = branch.plot()
    assert "corner" in [one.get_text() for one in figure.axes[0].get_legend().get_texts()]


def test_two_hits_at_once_that_disturb_each_other():
    """With an inertia k between them a hit of one ball changes the other's speed, too.

    Each impulse gives its ball D = g T / (1 - k), and takes k D from the other. The left ball, which hits first, leaves
    with g T / 2 + k D where hits are at once, the right one with g T / 2. A table's rate is this less e D / (1 + e).
    """
    branch = em.follow(both(inertia=0.02), "a", to=0.022)
    gain = G * T / 0.98
    lost = G * T / 2 - 0.8 * gain / 1.8
    wanted = 0.014 * (lost + 0.02 * gain) / lost
    assert not branch.success
    assert branch.special[-1].kind == "corner"
    assert branch.special[-1].parameter == pytest.approx(wanted, abs=1e-10)
    assert branch.parameter[-1] == pytest.approx(wanted, abs=1e-8)
    assert f"events 'left' and 'right' happen at once at {wanted:.6g}" in branch.message
    assert "which is first makes a difference" in branch.message


def test_a_hit_moves_onto_the_section():
    """From left hit to left hit: the right one comes nearer to the end of the period, and is at it at equal strokes."""
    smooth = both()
    hit = next(t for t in smooth.solution.t_events[0])
    row = np.flatnonzero(smooth.solution.t == hit)[-1]
    rows = smooth.solution.x[:, row], smooth.solution.v[:, row]
    x0, v0 = ({"z": one[0], "y": one[1]} for one in rows)
    start = em.find_cycle(smooth.system, x0=x0, v0=v0, t=hit, period=T, section="left")
    assert start.success
    assert start.t == pytest.approx(hit, abs=1e-9)
    branch = em.follow(start, "a", to=0.016)
    assert not branch.success
    assert branch.special[-1].parameter == pytest.approx(0.014, abs=1e-10)
    assert branch.special[-1].events == ("right", "left")
    assert "event 'right' moves onto the section, event 'left', at 0.014" in branch.message
    assert "with another section" in branch.message


def stopped(acts: bool) -> em.System:
    """A driven oscillator beside a stop at x = 1, or a counter there that does not act."""
    what = {"impact": (1 - x, e)} if acts else {}
    return system_for(
        Model(name="stopped" if acts else "counted", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
              potential_energy=x**2 / 2, forces=[F * cos(w * em.t) - c * x.diff()],
              parameters={c: 0.3, w: 1.4, F: 0.5, e: 0.7}, events={"stop": Event(1 - x, direction=-1, **what)}),
        "lagrange")  # fmt: skip


TOUCHES = np.hypot(1 - 1.4**2, 0.3 * 1.4)
"""The force with the amplitude 1."""


def test_a_stop_is_touched():
    """From both sides the branch ends at the force whose amplitude reaches the stop."""
    free = em.find_cycle(stopped(True), period="2*pi/w", t=0.3)
    branch = em.follow(free, "F", to=1.5)
    assert not branch.success
    assert [one.kind for one in branch.special] == ["grazing"]
    assert branch.special[0].events == ("stop",)
    assert branch.special[0].parameter == pytest.approx(TOUCHES, abs=1e-8)
    assert "grazing: event 'stop'" in branch.message
    assert str(branch.special[0]) == "grazing of stop at 1.04785495"
    hits = em.find_cycle(stopped(True), period="2*pi/w", t=0.3, parameters={"F": 1.2})
    assert hits.events == ("stop",)
    other = em.follow(hits, "F", to=0.2, back=3.0)
    assert [one.kind for one in other.special] == ["fold", "grazing"]
    assert other.special[1].parameter == pytest.approx(TOUCHES, abs=1e-8)
    with pytest.raises(em.ModelError, match="at a grazing, no branch leaves"):
        em.follow(branch.special[0], to=1.5)


def test_an_event_that_does_not_act_is_no_obstacle():
    branch = em.follow(em.find_cycle(stopped(False), period="2*pi/w", t=0.3), "F", to=1.5)
    assert branch.success
    assert branch.special == ()
    assert branch.highest["x"][-1] == pytest.approx(1.5 / TOUCHES, rel=1e-3)


def test_a_contact_that_holds_is_touched():
    """Beyond, the motion is far away: it leaves the stop each time with the same state."""
    model = Model(name="held_at_a_stop", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                  forces=[F * cos(w * em.t) - c * x.diff()], parameters={c: 0.3, w: 1.4, F: 0.5},
                  contacts={"stop": Contact(1 - x)})  # fmt: skip
    branch = em.follow(em.find_cycle(system_for(model, "lagrange"), period="2*pi/w", t=0.3), "F", to=1.5)
    assert [one.kind for one in branch.special] == ["grazing"]
    assert branch.special[0].parameter == pytest.approx(TOUCHES, abs=1e-8)
    assert "grazing: event 'stop' begins to happen" in branch.message


def first_stop(w: float) -> float:
    """Den Hartog's problem with damping 0.05, in closed form: the friction mu at which a stop becomes a rest.

    From rest at x = X until rest at -X half a period later, it slides back; at the first, the force is just mu.
    """

    def equations(unknowns: np.ndarray) -> list[float]:
        X, angle, mu = unknowns
        force = 1 / (1 - w**2 + 0.05j * w) * np.exp(1j * angle)
        rate = -0.025 + 1j * np.sqrt(1 - 0.025**2)
        A = X - mu - force.real  # x = mu + Re((A + i B) exp(rate t) + force exp(i w t))
        B = -((1j * w * force).real + A * rate.real) / rate.imag
        decays = (A - 1j * B) * np.exp(rate * np.pi / w)
        return [mu + decays.real - force.real + X, (rate * decays).real + w * force.imag, np.cos(angle) - X + mu]

    found, _, ok, words = fsolve(equations, [1.4, 0.0, 0.3], xtol=1e-13, full_output=True)
    assert ok == 1, words
    return float(found[2])


def rubbed(start: np.ndarray, t: float, limit: float) -> np.ndarray:
    """The state (x, x') a period of the forcing cos(0.6 t) later: by SciPy, slide by slide and rest by rest."""
    end, state = t + 2 * np.pi / 0.6, start
    while t < end:
        side = np.sign(state[1]) or np.sign(np.cos(0.6 * t) - state[0])

        def stops(_: float, s: np.ndarray) -> float:
            return s[1]

        stops.terminal, stops.direction = True, -side
        run = solve_ivp(lambda u, s, side=side: [s[1], np.cos(0.6 * u) - 0.05 * s[1] - s[0] - limit * side], (t, end),
                        state, method="DOP853", rtol=1e-12, atol=1e-13, events=stops)  # fmt: skip
        t, state = run.t[-1], run.y[:, -1]
        if t < end:
            state = np.array([state[0], 0.0])
            times = np.linspace(t, end, 2001)
            pulls = np.abs(np.cos(0.6 * times) - state[0]) > limit
            if not pulls[0]:
                k = int(pulls.argmax()) if pulls.any() else len(times) - 1
                pull = lambda u, at=state[0]: abs(np.cos(0.6 * u) - at) - limit  # noqa: E731
                t = brentq(pull, times[k - 1], times[k], xtol=1e-15) + 1e-14 if pulls.any() else end
    return state


def rubbing(limit: float, t: float) -> em.Cycle:
    model = Model(name="rubbed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                  forces=[cos(w * em.t) - 0.05 * x.diff()], contacts={"rub": Friction(x.diff(), limit=mu)},
                  parameters={w: 0.6, mu: 0.3})  # fmt: skip
    found = em.find_cycle(system_for(model, "lagrange"), x0={"x": 0.0}, v0={"x": -0.5}, period="2*pi/w", t=t,
                          parameters={"mu": limit})  # fmt: skip
    assert found.success
    return found


@pytest.mark.parametrize(("first", "last"), [(0.3, 0.56), (0.56, 0.3)])
def test_a_friction_begins_and_ceases_to_stick(first, last):
    """The branch goes on past the value at which a stop becomes a rest."""
    start = rubbing(first, 3.0)
    assert len(start.events) == (2 if first < last else 4)
    branch = em.follow(start, "mu", to=last)
    assert branch.success
    assert [str(one) for one in branch.special] == ["corner of rub at 0.498613631"]
    assert branch.special[0].parameter == pytest.approx(first_stop(0.6), abs=1e-8)
    for row in (0, branch.special[0].row + 1, -1):
        state = np.array([branch.x0["x"][row], branch.v0["x"][row]])
        assert rubbed(state, 3.0, branch.parameter[row]) == pytest.approx(state, abs=1e-8)


def test_a_rest_or_a_stop_moves_onto_the_start():
    """A start in a rest has one multiplier less, of 0, which is no bifurcation; a stop at the start ends the branch."""
    ends = []
    for t in (4.5, 2.0):
        into_a_rest = em.follow(rubbing(0.3, t), "mu", to=0.95)
        assert into_a_rest.success
        assert np.isnan(into_a_rest.values[-1]).sum() == 1
        assert kinds(into_a_rest) == ["corner"]
        ends.append(into_a_rest.x0["x"][-1])
    assert ends[0] == pytest.approx(ends[1], rel=1e-9)  # both start in the same rest
    branch = em.follow(rubbing(0.3, 0.5), "mu", to=0.95)
    assert not branch.success
    assert "event 'rub' moves onto the start of the period" in branch.message
    assert "call find_cycle at another t" in branch.message
