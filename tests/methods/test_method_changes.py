"""method="auto" during a run: it changes where stiffness begins or ends, and nothing else changes.

The motions are known: x'' = -sin t - D(t) (x' - cos t) has the solution sin t for every damping D. Beside it, y swings
as cos 3 t, and a ball bounces without loss between parabolas.
"""

import pickle
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from sympy import Heaviside, Rational, cos, sin, sqrt, symbols, tanh
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Event, Model, t

from ..support.generation import system_for, system_of

END, SWITCH = 40.0, 20.0
ROWS = np.linspace(0.0, END, 321)
HEIGHT, GRAVITY = 2.0, 9.81
EXPLICIT = ("dop853", "ra15")
BEGINS, ENDS, NEVER = 1.0, -1.0, 0.0


@cache
def system(bounces: bool = False) -> em.System:
    return system_for(model(bounces), formulation="lagrange")


def model(bounces: bool = False, name: str = "prescribed_damping") -> Model:
    x, y, z = dynamicsymbols("x y z")
    d, sign, T, w = symbols("d sign T w", real=True)
    D = d * (1 + sign * tanh((t - T) / w)) / 2
    more = {"contacts": {"floor": Contact(z, restitution=1.0)}} if bounces else {}
    return Model(
        name=name, coordinates=[x, y, z],
        kinetic_energy=(x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=Rational(9, 2) * y**2 + (Rational(981, 100) * z if bounces else 0),
        forces={x: -sin(t) - D * (x.diff() - cos(t))}, events={"half": Event(x - Rational(1, 2))},
        parameters={d: 1e4, sign: 1.0, T: SWITCH, w: 0.1}, initial={y: 1.0, x.diff(): 1.0, z: HEIGHT}, **more,
    )  # fmt: skip


def run(sign, method="auto", rtol=1e-8, bounces=False, **more):
    given = {"sign": sign} if sign != NEVER else {"sign": 1.0, "d": 1.0}
    return system(bounces).simulate((0.0, END), method=method, rtol=rtol, atol=rtol, parameters=given, **more)


def half_times():
    """Return the times at which sin t is a half."""
    k = np.arange(7)
    times = np.concatenate([np.pi / 6 + 2 * np.pi * k, 5 * np.pi / 6 + 2 * np.pi * k])
    return np.sort(times[times < END])


@pytest.mark.parametrize("rtol", [1e-6, 1e-9])
def test_changes_where_stiffness_begins(rtol):
    sol = run(BEGINS, rtol=rtol, t_eval=ROWS)
    assert sol.success
    assert sol.methods[0][1] in EXPLICIT
    assert [name for _, name in sol.methods[1:]] == ["radau9"]
    assert SWITCH - 1.0 < sol.methods[1][0] < SWITCH + 1.0
    assert sol.method == "radau9"
    assert "changed to radau9 at t = " in sol.message
    assert "scene is stiff" not in sol.message
    np.testing.assert_allclose(sol.x[0], np.sin(ROWS), atol=100 * rtol)
    np.testing.assert_allclose(sol.x[1], np.cos(3 * ROWS), atol=300 * rtol)


@pytest.mark.parametrize("rtol", [1e-6, 1e-9])
def test_changes_back_where_it_ends(rtol):
    sol = run(ENDS, rtol=rtol, t_eval=ROWS)
    assert sol.success
    assert [name == "radau9" for _, name in sol.methods[:3]] == [False, True, False]
    assert sol.methods[1][0] < 0.1
    assert sol.method in EXPLICIT
    assert SWITCH - 1.0 < sol.methods[-1][0] < SWITCH + 10.0
    np.testing.assert_allclose(sol.x[0], np.sin(ROWS), atol=100 * rtol)
    np.testing.assert_allclose(sol.x[1], np.cos(3 * ROWS), atol=300 * rtol)


@pytest.mark.parametrize("sign", [BEGINS, ENDS])
def test_costs_less_than_either_method(sign):
    own = run(sign)
    explicit = run(sign, method="dop853")
    assert own.nfev < 0.1 * explicit.nfev
    assert own.nsteps < 0.1 * explicit.nsteps


@pytest.mark.parametrize("sign", [BEGINS, ENDS])
@pytest.mark.parametrize("bounces", [False, True])
def test_events_at_both_sides_of_the_change(sign, bounces):
    sol = run(sign, bounces=bounces)
    assert sol.success
    assert len(sol.methods) > 1
    np.testing.assert_allclose(sol.t_events[0], half_times(), atol=1e-6)
    if bounces:
        fall = np.sqrt(2 * HEIGHT / GRAVITY)
        impacts = fall * (1 + 2 * np.arange(len(sol.t_events[1])))
        np.testing.assert_allclose(sol.t_events[1], impacts, atol=1e-6)
        assert impacts[-1] + 2 * fall > END


@pytest.mark.parametrize("sign", [BEGINS, ENDS])
def test_dense_output_across_the_change(sign):
    sol = run(sign, dense_output=True)
    rows = sol.sol(ROWS)
    np.testing.assert_allclose(rows[0], np.sin(ROWS), atol=1e-6)
    np.testing.assert_allclose(rows[1], np.cos(3 * ROWS), atol=3e-6)
    changed = sol.methods[-1][0]
    np.testing.assert_allclose(sol.sol(changed), sol.sol(np.nextafter(changed, 0.0)), atol=1e-9)
    assert changed in sol.t
    assert np.all(np.diff(sol.t) > 0.0)


@pytest.mark.parametrize("sign", [BEGINS, ENDS])
def test_is_the_motion_of_either_method(sign):
    own = run(sign, t_eval=ROWS)
    for method in ("radau9", "dop853"):
        np.testing.assert_allclose(own.x, run(sign, method=method, t_eval=ROWS).x, atol=3e-6)


@pytest.mark.parametrize("sign", [BEGINS, ENDS])
def test_is_the_same_every_time(sign):
    first, second = run(sign), run(sign)
    assert first.methods == second.methods
    assert np.array_equal(first.t, second.t)
    assert np.array_equal(first.y, second.y)


def test_a_terminal_event_after_the_change_ends_the_run_and_steps_are_bounded():
    short = run(BEGINS, max_steps=100)
    assert short.stop == em.StopReason.TOO_MANY_STEPS
    assert short.nsteps == 100
    whole = run(BEGINS)
    least = run(BEGINS, max_steps=whole.nsteps - 1)
    assert least.stop == em.StopReason.TOO_MANY_STEPS
    assert least.nsteps == whole.nsteps - 1
    assert len(least.methods) > 1


@pytest.mark.parametrize("sign", [BEGINS, ENDS])
def test_sensitivities_go_through_the_change(sign):
    sol = run(sign, sensitivities=["y", "x'"], t_eval=ROWS)
    assert len(sol.methods) > 1
    np.testing.assert_allclose(sol.sensitivity["y"].dx[1], np.cos(3 * ROWS), atol=1e-6)
    np.testing.assert_allclose(sol.sensitivity["y"].dx[0], 0.0, atol=1e-9)
    plain = run(sign, method="radau9", sensitivities=["x'"], t_eval=ROWS)
    np.testing.assert_allclose(sol.sensitivity["x'"].dx[0], plain.sensitivity["x'"].dx[0], atol=1e-5)


def test_gradients_are_by_the_method_of_the_longest_span():
    given = {"parameters": {"sign": BEGINS, "T": 10.0}, "t_eval": ROWS, "rtol": 1e-7, "by": ["x'", "y"]}
    gradients = {}
    for method in ("auto", "radau9"):
        solution, pullback = em.vjp(system(), (0.0, END), method=method, **given)
        assert solution.method == "radau9"
        gradients[method] = pullback(dx=np.ones_like(solution.x))
    assert gradients["auto"] == gradients["radau9"]


def test_error_estimates_bound_the_error():
    sol = run(BEGINS, estimate_error=True, rtol=1e-6, t_eval=ROWS)
    assert len(sol.methods) > 1
    error = abs(sol.x[0] - np.sin(ROWS)).max()
    assert error <= 3 * sol.error_estimate.x_largest[0] + 1e-9


def test_what_is_named_never_changes():
    for method in (*EXPLICIT, "radau9"):
        sol = run(ENDS if method == "radau9" else BEGINS, method=method, rtol=1e-5)
        assert sol.methods == ()
        assert sol.method == method


def test_never_changes_without_stiffness():
    assert run(NEVER).methods == ()
    for name in ("pendulum", "dual_link", "four_bar", "rolling_disk", "elastic_pendulum"):
        sol = system_of(name).simulate((0.0, 30.0), method="auto", rtol=1e-7)
        assert sol.methods == (), name


def test_changes_in_runs_with_controllers():
    x, u = dynamicsymbols("x u")
    d = symbols("d", real=True)
    damped = system_for(Model(
        name="damped_by_wire", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
        forces={x: -d * (1 + u) * (x.diff() - cos(t)) - sin(t) + x}, inputs={u: 0.0},
        parameters={d: 1e4}, initial={x.diff(): 1.0},
    ), formulation="lagrange")  # fmt: skip
    asked = em.Sampled(lambda time, x, v: 0.5, 2.0)
    sol = damped.simulate((0.0, 20.0), inputs={"u": asked}, method="auto", t_eval=np.linspace(0.0, 20.0, 41))
    assert [name for _, name in sol.methods[1:]] == ["radau9"]
    np.testing.assert_allclose(sol.x[0], np.sin(sol.t), atol=1e-4)
    for one, other in pairwise(sol.methods):
        assert one[0] < other[0]


def test_a_copy_of_a_run_that_changed_has_its_states_within_steps():
    built = em.build(model(), formulation="lagrange")
    sol = built.simulate((0.0, END), method="auto", dense_output=True)
    assert len(sol.methods) > 1
    copy = pickle.loads(pickle.dumps(sol))
    assert np.array_equal(copy.sol(ROWS), sol.sol(ROWS))
    assert copy.methods == sol.methods


def unloadable(error):
    """Return a model without derivatives, which cannot be compiled because of an error."""
    built = em.build(model(name="without_derivatives"), formulation="lagrange")

    def load(_):
        raise error

    built.compiled.load_part = load
    return built


def test_keeps_its_method_where_derivatives_cannot_be_compiled():
    sol = unloadable(em.BuildError("no room\nfor it")).simulate(
        (0.0, SWITCH + 1.0), method="auto", rtol=1e-8, atol=1e-8, t_eval=[0.0, SWITCH, SWITCH + 1.0]
    )
    assert sol.success
    assert sol.methods == ()
    assert sol.method in EXPLICIT
    assert f"method='auto' kept {sol.method}" in sol.message
    assert sol.message.endswith("no room")
    np.testing.assert_allclose(sol.x[0], np.sin(sol.t), atol=1e-6)


def test_wrong_derivatives_are_an_error():
    with pytest.raises(em.ProofError, match="they differ"):
        unloadable(em.ProofError("they differ")).simulate((0.0, END), method="auto", rtol=1e-8)


def test_ctrl_c_while_derivatives_are_compiled_ends_the_run_with_its_motion():
    sol = unloadable(KeyboardInterrupt()).simulate((0.0, END), method="auto", rtol=1e-8)
    assert sol.stop == em.StopReason.INTERRUPTED
    assert SWITCH - 1.0 < sol.t[-1] < SWITCH + 1.0
    np.testing.assert_allclose(sol.x[0], np.sin(sol.t), atol=1e-6)


@pytest.mark.parametrize("rtol", [1e-7, 1e-13])
@pytest.mark.parametrize("end", [1.0, 1e2, 1e3, 1e4])
def test_compiles_no_derivatives_without_stiffness(end, rtol):
    swings = dynamicsymbols("swings")
    built = em.build(Model(
        name="swings_long", coordinates=[swings], kinetic_energy=swings.diff() ** 2 / 2,
        potential_energy=-Rational(981, 100) * cos(swings), initial={swings: 1.0},
    ))  # fmt: skip
    asked = []
    built.compiled.load_part = asked.append
    sol = built.simulate((0.0, end), method="auto", rtol=rtol, t_eval=[0.0, end])
    assert sol.success
    assert asked == []


def test_leaves_the_implicit_method_where_it_makes_no_step():
    """Derivatives of the drag are not finite at rest, where z stays; the drag itself is 0 there."""
    x, z, d = *dynamicsymbols("x z"), symbols("d", positive=True)
    resting = em.build(Model(
        name="drag_at_rest", coordinates=[x, z], kinetic_energy=(x.diff() ** 2 + z.diff() ** 2) / 2, potential_energy=0,
        forces={x: -sin(t) - d * (x.diff() - cos(t)), z: -z.diff() * sqrt(z.diff() ** 2 + z**2)},
        parameters={d: 2e3}, initial={x.diff(): 1.0},
    ), formulation="lagrange")  # fmt: skip
    sol = resting.simulate((0.0, 2.0), method="auto", rtol=1e-6, dense_output=True)
    assert sol.success, sol.message
    assert [name == "radau9" for _, name in sol.methods] == [False, True, False]
    assert sol.methods[1][0] == sol.methods[2][0]
    np.testing.assert_allclose(sol.x[0], np.sin(sol.t), atol=1e-6)
    assert not sol.x[1].any()
    assert not resting.simulate((0.0, 2.0), method="radau9", rtol=1e-6).success


@cache
def held() -> em.System:
    wire, u = dynamicsymbols("wire u")
    return system_for(Model(
        name="held_damping", coordinates=[wire], kinetic_energy=wire.diff() ** 2 / 2, potential_energy=0,
        forces={wire: -sin(t) - u * (wire.diff() - cos(t))}, inputs={u: 0.0}, initial={wire.diff(): 1.0},
    ), formulation="lagrange")  # fmt: skip


def test_changes_back_where_each_step_ends_at_a_sample():
    times = np.arange(0.0, END, 0.25)
    damped = em.Signal(times, np.where(times < 5.0, 1e5, 0.0), kind="hold")
    sol = held().simulate((0.0, END), inputs={"u": damped}, method="auto", rtol=1e-8)
    assert [name for _, name in sol.methods] == ["dop853", "radau9", "dop853"]
    assert 5.0 < sol.methods[2][0] < 15.0
    np.testing.assert_allclose(sol.x[0], np.sin(sol.t), atol=1e-6)


@pytest.mark.parametrize("rtol", [1e-8, 1e-11, 1e-12, 1e-13])
def test_never_ends_with_tiny_steps_where_stiffness_returns(rtol):
    """At a tolerance near rounding, the rounding of stiff forces limits the steps of dop853 before stability does."""
    times = np.arange(0.0, END, 0.25)
    damped = em.Signal(times, np.where(times // 5 % 2 == 0, 1e5, 0.0), kind="hold")
    sol, implicit = (
        held().simulate((0.0, END), inputs={"u": damped}, method=method, rtol=rtol, atol=0.01 * rtol)
        for method in ("auto", "radau9")
    )
    assert sol.success
    assert sol.nfev < 4 * implicit.nfev


def test_a_change_of_the_method_at_a_time_event_has_crossed_it():
    """The step before ends there: a later change of an input crossed it once more, where the row is another."""
    x, y, push = dynamicsymbols("x y push")
    a = symbols("a", real=True)
    model = Model(name="changed", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                  potential_energy=2.5e5 * x**2, holonomic_constraints=[y - sin(2 * t)], inputs={push: 0.0},
                  forces={x: push - 3e4 * x.diff() + Heaviside(t - a)}, parameters={a: 10.0},
                  initial={x: 0.01, y.diff(): 2.0})  # fmt: skip
    system = system_for(model, "lagrange")

    def run(at: float) -> em.Solution:
        given = em.Sampled(lambda t, x, v: t, 0.02)
        return system.simulate((0.0, 0.1), method="auto", inputs={"push": given}, parameters={"a": at})

    at = run(10.0).methods[1][0]
    found = run(at)
    assert found.methods[1][0] == at
    assert found.success
    assert found.x[1] == pytest.approx(np.sin(2 * found.t), abs=1e-9)
