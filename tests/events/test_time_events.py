"""Time events: what changes at times that follow from parameters alone is neither stepped over nor smeared."""

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from sympy import Abs, Heaviside, Max, Mod, Piecewise, Symbol, sign, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Event, Model, ModelError, StopReason, simulate_ensemble, t
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_for

X, Y = dynamicsymbols("x y")
F, START, LAST, K, DUTY = symbols("F t0 d k duty")
PULSE = (t >= START) & (t < START + LAST)


def driven(name: str, force: object, parameters: dict[Symbol, float] | None = None, **given: object) -> Model:
    """A mass of 1 kg on a line."""
    fields = {"coordinates": [X], "kinetic_energy": X.diff() ** 2 / 2, "forces": {X: force}, **given}
    return Model(name=name, parameters=parameters or {}, **fields)


PULSED = driven("pulsed", Piecewise((F, PULSE), (0, True)), {F: 1000.0, START: 3.3, LAST: 1e-3})
SWINGING = driven("swinging", Piecewise((F, PULSE), (0, True)), {F: 1000.0, START: 3.3, LAST: 1e-3},
                  potential_energy=X**2 / 2)  # fmt: skip


@pytest.fixture(scope="module")
def pulsed() -> em.System:
    return system_for(PULSED, "lagrange")


@pytest.fixture(scope="module")
def swinging() -> em.System:
    return system_for(SWINGING, "lagrange")


def after_pulse(start: float, last: float, end: float) -> tuple[float, float]:
    """Where a mass is that was pushed by F = 1000 N for so long, and how fast."""
    return 1000 * last * (end - start - last / 2), 1000 * last


@pytest.mark.parametrize("method", sorted(METHODS))
@pytest.mark.parametrize("last", [1e-3, 1e-6])
def test_no_pulse_is_stepped_over(pulsed, method, last):
    """At rest before it, by every method, at times that nothing else knows of."""
    for start in np.random.default_rng(7).uniform(0.1, 9.9, 2):
        run = pulsed.simulate((0.0, 10.0), method=method, parameters={"t0": start, "d": last})
        x, v = after_pulse(start, (start + last) - start, 10.0)
        assert run.success
        assert run.v[0, -1] == pytest.approx(v, rel=2e-6)
        assert run.x[0, -1] == pytest.approx(x, rel=2e-6)


def test_each_side_of_a_jump_is_seen_from_there_alone(pulsed):
    """Steps end at the jumps to the last digit, and none after the first is rejected."""
    run = pulsed.simulate((0.0, 10.0), parameters={"t0": 0.1, "d": 0.2}, method="dop853")
    assert {0.1, 0.1 + 0.2} <= set(run.t.tolist())
    assert run.nrejected == 0
    assert np.allclose(run.x[0, -1], after_pulse(0.1, 0.2, 10.0)[0], rtol=1e-13)


def test_backwards_and_from_a_break_to_a_break(pulsed):
    there = pulsed.simulate((0.0, 10.0))
    back = pulsed.simulate((10.0, 0.0), x0=there.x[:, -1], v0=there.v[:, -1])
    assert np.allclose([back.x[0, -1], back.v[0, -1]], 0.0, atol=1e-12)
    within = pulsed.simulate((3.3, 3.3 + 1e-3))
    assert within.v[0, -1] == pytest.approx(1.0, rel=1e-12)
    assert pulsed.simulate((3.3, 1.0)).v[0, -1] == 0.0
    assert pulsed.simulate((3.3 + 1e-3, 9.0)).v[0, -1] == 0.0


LAWS = {  # what pushes a mass of 1 kg, and where it is after 3 s
    "ramp": (Max(0, t - 1) + Piecewise((9, sin(t) > 1), (0, True)), 4 / 3),  # at asin(1), whose slope is infinite
    "window": (Piecewise((1e6, Abs(t - 2) < 1e-6), (0, True)), 2.0),
    "square": (sign(sin(2 * np.pi * t)), 0.75),
    "periodic": (Piecewise((1, Mod(t, 0.1) < 0.03), (0, True)), 1.3815),
    "factors": (Piecewise((1, (t - 1) * (t - 2) < 0), (0, True)), 1.5),
    "quadratic": (Piecewise((1, t**2 - 3 * t + 2 < 0), (0, True)), 1.5),
    "twice": (Piecewise((1, t < 0.1 + 0.2), (0, True)) + Piecewise((1, t < 0.3), (0, True)), 1.71),
    "nested": (Max(0, Piecewise((Heaviside(t - 1), t < 2), (-1, True))), 1.5),
}


def test_forms_of_conditions_are_solved():
    masses = dynamicsymbols(" ".join(LAWS))
    model = Model(name="laws", coordinates=masses, kinetic_energy=sum(x.diff() ** 2 for x in masses) / 2,
                  forces=dict(zip(masses, (force for force, _ in LAWS.values()), strict=True)))  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 3.0))
    for name, x in zip(LAWS, run.x[:, -1], strict=True):
        assert x == pytest.approx(LAWS[name][1], rel=1e-9), name


def test_factors_of_the_time_may_have_either_sign_or_vanish():
    system = system_for(driven("factor", Piecewise((1, K * t < 1), (0, True)), {K: 1.0}), "lagrange")
    for k, x in {1.0: 1.5, 0.0: 2.0, -1.0: 2.0, 1e300: 0.0}.items():
        assert system.simulate((0.0, 2.0), parameters={"k": k}).x[0, -1] == pytest.approx(x, abs=1e-12)


@pytest.mark.parametrize(("bend", "slope"), [(1.0, 0.0), (0.0, 1.0), (1e-20, 1.0), (-1e-14, 1.0), (0.0, 0.0)])
def test_a_quadratic_may_be_all_but_straight(bend, slope):
    """Its time was a difference of equal numbers: what ended at 1 s never held."""
    model = driven("straight", Piecewise((1, K * t**2 + DUTY * t < 1), (-1, True)), {K: 1.0, DUTY: 0.0})
    run = system_for(model).simulate((0.0, 2.0), parameters={"k": bend, "duty": slope}, sensitivities=["duty"])
    assert np.allclose(run.x[0, -1], 1.0 if slope or bend else 2.0, rtol=0, atol=1e-12)
    if slope:
        assert run.sensitivity["duty"].dv[0, -1] == pytest.approx(-2.0, rel=1e-9)


def test_times_that_meet_or_pass_each_other(pulsed):
    for last in (0.0, -1.0):
        assert pulsed.simulate((0.0, 10.0), parameters={"d": last}).v[0, -1] == 0.0


def test_a_force_may_end_with_its_run():
    """What has no value behind a break is not asked there by who does not go on."""
    system = system_for(driven("ends", Piecewise((1, t <= 1))), "lagrange")
    assert system.simulate((0.0, 1.0)).x[0, -1] == pytest.approx(0.5)
    beyond = system.simulate((0.0, 2.0))
    assert (beyond.stop, beyond.t[-1]) == (StopReason.NON_FINITE_STATE, 1.0)


def test_members_are_the_same_in_any_company(swinging):
    """Those with a pulse in their span go number by number, the others in lanes."""
    starts = np.random.default_rng(3).uniform(-5.0, 15.0, 37)
    runs = simulate_ensemble(swinging, (0.0, 10.0), parameters={"t0": starts}, rtol=1e-9, atol=1e-12)
    other = simulate_ensemble(swinging, (0.0, 10.0), parameters={"t0": starts[::-1]}, rtol=1e-9, atol=1e-12)
    assert np.array_equal(runs.y, other.y[::-1])
    expected = np.where((starts > 0) & (starts < 9.999), 1000 * (np.cos(9.999 - starts) - np.cos(10 - starts)), 0.0)
    assert np.allclose(runs.x[:, 0, -1], expected, rtol=0, atol=1e-8)


@pytest.mark.parametrize("method", ["rk4", "midpoint", "dop853"])
def test_steppers_stop_there_too(pulsed, method):
    options = {"method": method} | ({"step": 0.5} if method != "dop853" else {})
    one = pulsed.stepper(**options)
    for end in (1.0, 3.3, 7.0, 10.0):
        one.advance(end)
    assert one.v[0] == pytest.approx(1.0, rel=1e-9)
    one.advance(1.0)
    assert one.v[0] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("name", ["t0", "d", "F"])
def test_times_that_depend_on_parameters_have_derivatives(swinging, name):
    """By a closed form: x = F (cos(T - t0 - d) - cos(T - t0))."""
    run = swinging.simulate((0.0, 10.0), sensitivities=[name], rtol=1e-10, atol=1e-13)
    early, late = 10.0 - 3.3, 10.0 - 3.3 - 1e-3
    by_start = 1000 * (np.sin(late) - np.sin(early))
    expected = {"t0": by_start, "d": 1000 * np.sin(late), "F": np.cos(late) - np.cos(early)}
    assert run.sensitivity[name].dx[0, -1] == pytest.approx(expected[name], rel=1e-6)


def test_derivatives_end_by_name_where_times_part(pulsed):
    with pytest.raises(ModelError, match=r"times change apart"):
        pulsed.simulate((0.0, 10.0), parameters={"d": 0.0}, sensitivities=["d"])
    with pytest.raises(ModelError, match=r"times change apart"):
        pulsed.simulate((3.3, 10.0), sensitivities=["t0"])


RAISED = {"name": "raised", "coordinates": [X, Y], "kinetic_energy": X.diff() ** 2 / 2 + Y.diff() ** 2}


@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
@pytest.mark.parametrize("method", ["dop853", "radau9"])
@pytest.mark.parametrize("stabilisation", ["project", "none"])
def test_a_prescribed_motion_may_set_in_at_once(formulation, method, stabilisation):
    """The impulse along the constraint is shared by the masses 1 and 2 that it joins."""
    system = system_for(Model(**RAISED, holonomic_constraints=[X + Y - Max(0, t - 1)]), formulation)
    run = system.simulate((0.0, 2.0), method=method, stabilisation=stabilisation)
    assert np.allclose(run.v[:, -1], [2 / 3, 1 / 3], rtol=0, atol=1e-9)


MOMENTA = {
    "mass": ((1 + Heaviside(t - 1)) * X.diff() ** 2 / 2, "momentum of 'x'"),
    "frame": ((X.diff() + Heaviside(t - 1)) ** 2 / 2, "momentum of 'x'"),
}


@pytest.mark.parametrize("name", MOMENTA)
def test_momenta_that_jump_are_refused_by_name(name):
    kinetic_energy, words = MOMENTA[name]
    model = driven(f"momentum_{name}", 0, kinetic_energy=kinetic_energy, initial={X.diff(): 1.0})
    run = system_for(model).simulate((0.0, 2.0))
    assert (run.stop, run.t[-1]) == (StopReason.MODEL_JUMPS, 1.0)
    assert words in run.message


def test_those_that_bend_are_not():
    model = driven("growing", 0, kinetic_energy=(1 + Max(0, t - 1)) * X.diff() ** 2 / 2, initial={X.diff(): 1.0})
    run = system_for(model).simulate((0.0, 2.0), rtol=1e-9)
    assert run.x[0, -1] == pytest.approx(1 + np.log(2), rel=1e-8)


def test_positions_and_contacts_that_jump_are_refused_by_name():
    torn = system_for(Model(**RAISED, holonomic_constraints=[X + Y - Heaviside(t - 1)])).simulate((0.0, 2.0))
    assert (torn.stop, torn.t[-1]) == (StopReason.MODEL_JUMPS, 1.0)
    assert "Holonomic constraint row 0" in torn.message
    floor = Contact(X - Max(0, t - 1) ** 2 + Max(0, t - 1.5), restitution=0, rest=1e-3)
    kicked = system_for(driven("kicked", -10, contacts={"floor": floor})).simulate((0.0, 2.0))
    assert (kicked.stop, kicked.t[-1]) == (StopReason.MODEL_JUMPS, 1.5)
    assert "contact that holds" in kicked.message


@pytest.mark.parametrize("method", ["dop853", "radau9"])
def test_an_event_that_jumps_happens(method):
    model = driven("noticed", 0, events={"on": Event(Piecewise((-1, t < 1), (1, True)))}, initial={X.diff(): 1.0})
    for span in ((0.0, 2.0), (2.0, 0.0)):
        (times,) = system_for(model).simulate(span, method=method).t_events
        assert times == pytest.approx([1.0], abs=1e-12)


# --- events exactly at breaks: F = 2 until c, then -1; x = t^2 until then --------------------------------------------

C, D = symbols("c d")
TURNED = Piecewise((2, t < C), (-1, True))


def turned(name: str, **events: object) -> em.System:
    return system_for(driven(name, TURNED, {C: 1.0, D: 1.0}, events=events), "lagrange")


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_an_event_at_a_break_at_which_the_run_ends_happens(method):
    """Steps up to a break ask a little before it, where the clock is not yet zero."""
    system = turned("arriving", clock=t - C, later=t - 3, to=Event(Piecewise((-1, t < C), (1, True))),
                    beyond=Event(Piecewise((-1, t <= C), (1, True))), last=Event(t - D, terminal=True))  # fmt: skip
    ends = {(0.0, 1.0): "clock to last", (2.0, 1.0): "clock beyond last", (0.0, 0.5): "", (1.0, 0.5): ""}
    for span, fired in ends.items():
        run = system.simulate(span, x0=[1.0], v0=[0.0], method=method)
        times = dict(zip(system.events, map(list, run.t_events), strict=True))
        assert times == {name: [1.0] if name in fired.split() else [] for name in system.events}
        assert (run.stop is StopReason.TERMINAL_EVENT) == ("last" in fired)


KICK = {X.diff(): -X.diff()}
AT_BREAKS = {  # events, and dx, dv at t = 2 by c and by d; None: the derivatives from both sides differ
    "passive": ({"place": X - D**2}, (3, 3), (0, 0)),
    "clocks": ({"one": t - D, "other": t - C}, (3, 3), (0, 0)),
    "kicked": ({"kick": Event(t - C, reset=KICK)}, (3, -1), (0, 0)),
    "apart": ({"kick": Event(t - D, reset=KICK)}, None, None),
    "crowded": ({"place": X - D**2, "clock": t - D}, None, None),
}


@pytest.mark.parametrize("name", AT_BREAKS)
def test_derivatives_through_events_at_breaks_are_right_or_refused(name):
    """Which were 0 past passive events, and wrong past those that act."""
    events, *expected = AT_BREAKS[name]
    system = turned(name, **events)
    for parameter, right in zip("cd", expected, strict=True):
        if right is None:
            with pytest.raises(ModelError, match=r"times change apart"):
                system.simulate((0.0, 2.0), sensitivities=[parameter])
            continue
        found = system.simulate((0.0, 2.0), sensitivities=[parameter], rtol=1e-10, atol=1e-12).sensitivity[parameter]
        assert np.allclose([found.dx[0, -1], found.dv[0, -1]], right, rtol=0, atol=1e-9)


def test_a_force_that_jumps_where_several_events_happen_jumps_once():
    """x after d under 1 before it and 2 behind: with k events at d directions jumped k times."""
    events = {"one": X - D, "two": D**2 - X * D, "three": 3 * (X - D)}
    model = driven("thrice", 1 + Heaviside(X - D), {D: 1.0}, events=events, initial={X.diff(): 1.0})
    system = system_for(model, "lagrange")
    found = system.simulate((0.0, 2.0), sensitivities=["d"], rtol=1e-10, atol=1e-12).sensitivity["d"]
    speed = np.sqrt(3.0)  # at d; the time there changes by 1 / speed, and a by 1 from then on
    left = 2.0 - (speed - 1.0)
    assert np.allclose([found.dx[0, -1], found.dv[0, -1]], [-left / speed, -1 / speed], rtol=0, atol=1e-6)


@pytest.mark.parametrize("method", ["dop853", "radau9"])
def test_times_that_come_back_faster_than_rounding_tells_are_refused(method):
    """A square wave of 1 s, eight roundings of the time at 1e15 s: it was a constant."""
    square = driven("square", Piecewise((1, Mod(t, D) < D / 2), (-1, True)), {D: 1.0})
    system = system_for(square, "lagrange")
    far = system.simulate((1e9, 1e9 + 2.25), method=method)
    assert far.x[0, -1] == pytest.approx(17 / 32, abs=1e-6)
    for start, period in ((1e15, 1.0), (0.0, 1e-300), (1.0, 1e-17)):
        run = system.simulate((start, start + 2.25), parameters={"d": period}, method=method)
        assert (run.stop, run.t[-1]) == (StopReason.STEP_SIZE_UNDERFLOW, start)
    runs = simulate_ensemble(system, (1.0, 3.25), parameters={"d": [1.0, 1e-17]})
    assert runs.success.tolist() == [True, False]


def test_what_is_not_solved_is_said():
    words = compiler.explain(driven("unsolved", Piecewise((1, t**3 + t < DUTY), (0, True)), {DUTY: 1.0}))
    assert "that steps may pass over" in words
    assert "t**3 + t" in words
    assert "Time events" not in words


def test_what_is_solved_is_said_and_others_pay_nothing():
    assert "t0 + d" in compiler.explain(PULSED) or "d + t0" in compiler.explain(PULSED)
    plain = compiler.generate(driven("plain", sin(t))).files
    assert not any("time_event" in part.text.lower() for part in plain)


def test_the_refusal_names_the_event_and_the_remedy():
    """An impact at the time at which a force is switched on."""
    hit = Event(X, direction=-1, impact=(X, 0.5))
    force = Piecewise((0, t < START), (1, True))
    model = driven("meeting", force, {START: 1.0}, potential_energy=2 * X, initial={X: 1.0}, events={"hit": hit})
    system = system_for(model, "lagrange")
    words = r"changes at once with 'hit'.* about t = 0\.99.*start where one of them is clearly first, or vary only"
    with pytest.raises(ModelError, match=words):
        system.simulate((0.0, 2.0), sensitivities=["t0"])
    with pytest.raises(ModelError, match=words):
        em.vjp(system, (0.0, 2.0), by=["t0"])
