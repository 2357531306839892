"""Many steppers as one: against single ones, and against formulas of the same methods in NumPy."""

import ctypes
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import eigenmotion as em

from .environments import ANGLES, FIXED, KINDS, TORQUES, K, driven, in_lanes, kinds, one_by_one, opened, told


def test_what_goes_in_lanes():
    lanes = in_lanes().compiled.lanes
    assert opened("lanes").lanes == (lanes if lanes > 1 else 1)
    assert opened("fixed").lanes == opened("dop853").lanes == 1
    assert in_lanes().steppers(K).lanes == 1  # of steps that are chosen


def test_a_state_with_eta_does_not_go_in_lanes_after_an_ensemble():
    """An ensemble loads lanes, whose state has no velocities here."""
    system = em.build(driven(), formulation="cholesky")
    start = {"x0": {"theta": ANGLES}, "parameters": {"l": 2.0}}
    em.simulate_ensemble(system, (0, 0.1), **start)
    envs = system.steppers(K, **start, **FIXED)
    envs.advance(0.35)
    single = system.stepper(x0={"theta": ANGLES[3]}, parameters={"l": 2.0}, **FIXED)
    single.advance(0.35)
    assert np.array_equal(envs.v[3], single.v)


@kinds
def test_each_is_what_a_single_one_is(kind):
    envs = opened(kind)
    rows = told(envs)
    system, options = KINDS[kind]
    for k in range(0, K, 5):
        single = system().stepper(x0={"theta": ANGLES[k]}, **options)
        for i in range(5):
            single.advance(single.t + 0.07, {"u": TORQUES[k] * (i + 1)})
        apart = np.abs(np.hstack([single.x, single.v, single.t]) - rows[k]).max()
        assert apart == 0.0 or (kind == "lanes" and apart < 1e-13)
        assert single.nsteps == envs.nsteps[k]
        assert envs.energy[k] == pytest.approx(single.energy, rel=1e-12)
        assert envs.acceleration[k] == pytest.approx(single.acceleration, rel=1e-12)
        assert {name: row[k] for name, row in envs.outputs.items()} == pytest.approx(single.outputs, rel=1e-12)


@pytest.mark.parametrize("kind", ["lanes", "fixed"])
def test_classical_steps_are_those_of_numpy(kind):
    """Runge and Kutta's, written out for all at once, each with its own length, torque and way to go."""
    length, ways = np.linspace(0.5, 2.0, K), np.linspace(0.02, 0.4, K)
    envs = opened(kind, parameters={"l": length})
    envs.advance(ways, TORQUES)
    y = np.array([ANGLES, np.zeros(K)])

    def rate(y):
        return np.array([y[1], (TORQUES - 9.81 * length * np.sin(y[0])) / length**2])

    steps = np.ceil(ways / 0.01 - 1e-6)
    for k in range(int(steps.max())):
        h = np.where(k < steps, ways / steps, 0.0)
        k1 = rate(y)
        k2 = rate(y + h / 2 * k1)
        k3 = rate(y + h / 2 * k2)
        y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(y + h * k3))
    assert np.abs(envs.x[:, 0] - y[0]).max() < 1e-13
    assert np.abs(envs.v[:, 0] - y[1]).max() < 1e-13
    assert np.array_equal(envs.nsteps, steps)
    assert np.array_equal(envs.t, ways)


@kinds
def test_bits_depend_on_the_member_alone(kind):
    """Not on how many there are, their order, what became of the others, or threads."""
    rows, order = told(opened(kind)), np.random.default_rng(3).permutation(K)
    assert np.array_equal(told(opened(kind, x0={"theta": ANGLES[order]}), TORQUES[order]), rows[order])
    for k in (0, 11):
        assert np.array_equal(told(opened(kind, 1, x0={"theta": ANGLES[k]}), TORQUES[k : k + 1]), rows[k : k + 1])
    envs = opened(kind, 2500, x0={"theta": np.resize(ANGLES, 2500)}, workers=3)
    assert len(envs._parts) == (2 if envs.lanes > 1 else 3)
    assert np.array_equal(told(envs, np.resize(TORQUES, 2500)), np.resize(rows, (2500, 3)))


@kinds
def test_a_reset_touches_none_but_those_it_is_for(kind):
    envs = opened(kind)
    told(envs)
    mask = np.arange(K) % 3 == 1
    before = envs.x.copy(), envs.v.copy(), envs.u.copy()
    envs.reset(
        mask, t=2.0, x0={"theta": 0.1 * ANGLES}, v0=np.full((K, 1), 0.2), parameters={"l": 1.5}, inputs={"u": 1.0}
    )
    assert all(
        np.array_equal(now[~mask], was[~mask]) for now, was in zip((envs.x, envs.v, envs.u), before, strict=True)
    )
    assert np.array_equal(envs.x[mask, 0], 0.1 * ANGLES[mask])
    assert (envs.v[mask], envs.u[mask], envs.t[mask]) == (pytest.approx(0.2), pytest.approx(1.0), pytest.approx(2.0))
    envs.advance(envs.t + 0.3)
    system, options = KINDS[kind]
    k = 7
    single = system().stepper(
        t=2.0, x0=[0.1 * ANGLES[k]], v0=[0.2], parameters={"l": 1.5}, inputs={"u": 1.0}, **options
    )
    single.advance(2.3)
    assert envs.x[k] == pytest.approx(single.x, abs=1e-13 if kind == "lanes" else 0.0)
    envs.reset()
    assert np.array_equal(told(envs), told(opened(kind)))


@kinds
def test_all_is_saved_and_restored_to_the_last_bit(kind):
    envs = opened(kind, parameters={"l": np.linspace(1, 2, K)})
    told(envs)
    envs.reset(np.arange(5), parameters={"l": 3.0})
    saved = envs.save()
    rows = told(envs)
    for other in (envs, opened(kind), *([pickle.loads(pickle.dumps(envs))] if kind == "lanes" else [])):
        other.restore(saved)
        assert np.array_equal(told(other), rows)
        assert other.save() == envs.save()
    for bad in (saved[:-1], b"", opened(kind, 3, x0=None).save()):
        with pytest.raises(ValueError, match="saved by steppers of another model"):
            envs.restore(bad)


def test_what_they_show_is_theirs_and_follows_them():
    envs = opened("lanes")
    x, v, t = envs.x, envs.v, envs.t
    told(envs)
    assert x is envs.x
    assert v is envs.v
    assert t is envs.t
    assert t == pytest.approx(0.35)
    for shown in (x, v, t, envs.u, envs.ended):
        with pytest.raises(ValueError, match="read-only"):
            shown[0] = 1


def test_a_lane_that_knows_no_sine_is_asked_by_numbers():
    """Angles beyond 1e6 are for C's library."""
    envs = opened("lanes", x0={"theta": np.where(np.arange(K) == 4, 2e6, ANGLES)})
    rows = told(envs)
    single = one_by_one().stepper(x0={"theta": 2e6}, **FIXED)
    for i in range(5):
        single.advance(single.t + 0.07, {"u": TORQUES[4] * (i + 1)})
    assert np.array_equal(np.hstack([single.x, single.v]), rows[4, :2])
    assert np.array_equal(np.delete(rows, 4, 0), np.delete(told(opened("lanes")), 4, 0))


@kinds
def test_no_memory_is_taken_on_the_way(kind):
    """What C has taken, by its own count, is the same after as before; resets that start elsewhere included.

    Other threads of the process may take some in one of the rounds, not in most.
    """
    try:
        mallinfo = ctypes.CDLL(None).mallinfo2
    except AttributeError:
        pytest.skip("counts what glibc has handed out")
    mallinfo.restype = type(
        "Mallinfo", (ctypes.Structure,), {"_fields_": [(f"f{k}", ctypes.c_size_t) for k in range(10)]}
    )
    envs = opened(kind, workers=1)
    told(envs)
    members, starts = np.arange(K), (envs.t.copy(), 0.5 * envs.x, envs.v.copy(), np.tile([1.0, 9.81], (K, 1)))
    envs.goals[...] = 0.8
    taken = []
    for _ in range(8):
        envs.go(0, K, 0)
        envs.stage(members, *starts)
        envs.begin(members, starts[0], TORQUES[:, None])
        envs.go(0, K, 0)
        found = mallinfo()
        taken.append(found.f7)  # uordblks
    assert np.median(np.diff(taken[1:])) == 0


def test_a_signal_ends_an_advance_and_the_next_goes_on():
    envs = opened("fixed", method="rk4", step=1e-6, max_steps=1_000_000_000)
    timer = threading.Timer(0.2, signal.raise_signal, (signal.SIGINT,))
    timer.start()
    begin = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        envs.advance(1000.0)
    assert time.perf_counter() - begin < 5.0
    assert not envs.ended.any()
    envs.advance(envs.t)
    timer.join()
