"""Motions as functions of JAX: against differences, closed forms, ensembles and runs in one piece."""

from typing import Any

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, ModelError, System
from eigenmotion.analysis.gradients import motion_map

from ..support.generation import system_for, system_of

jax = pytest.importorskip("jax")
jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp  # noqa: E402
from jax.test_util import check_grads  # noqa: E402

TIGHT = {"rtol": 1e-11, "atol": 1e-13}
EVERY = ("x", "v", "states", "outputs")
z = dynamicsymbols("z")
g, e, m = symbols("g e m", positive=True)
push = dynamicsymbols("push")
BALL = {"z": 1.0, "z'": 0.3, "e": 0.8, "g": 9.81, "push": 1.0}


def ball(**more: Any) -> System:
    """A ball that a force holds back; it bounces."""
    events = {"floor": Event(z, direction=-1, impact=(z, e))}
    return system_for(
        Model(name="pushed_ball", coordinates=[z], kinetic_energy=m * z.diff() ** 2 / 2, potential_energy=m * g * z,
              forces={z: push}, inputs={push: 0.0}, parameters={m: 2.0, g: 9.81, e: 0.9}, initial={z: 1.0},
              outputs={"pull": push * z.diff() - m * g}, **{"events": events} | more),
        "lagrange")  # fmt: skip


def fall(times: Any = (0.4, 0.7, 1.0), **options: Any) -> Any:
    return em.to_jax(ball(), (0.0, 1.0), times, by=list(BALL), **TIGHT | options)


def largest(tree: Any) -> float:
    return max(float(jnp.abs(leaf).max()) for leaf in jax.tree.leaves(tree))


def apart(found: Any, right: Any) -> float:
    """Return the largest difference of two trees, relative to the largest number of each leaf."""
    pairs = zip(jax.tree.leaves(found), jax.tree.leaves(right), strict=True)
    return max(largest(one - other) / max(largest(other), 1e-30) for one, other in pairs)


def many(values: dict[str, float], count: int) -> dict[str, Any]:
    return {name: value * (1.0 + 0.02 * jnp.arange(count)) for name, value in values.items()}


MOTIONS = {
    "bouncing_ball": {"x'": 0.5, "z": 1.0, "e": 0.8, "g": 9.81},
    "block_on_incline": {"s'": 3.0, "mu": 0.6, "alpha": 0.4},
    "four_bar": {"g": 9.81},
    "servo_pendulums": {"q1": 0.15, "q2'": 0.1, "i": 0.5, "target": 0.05, "K": 0.1},
}


@pytest.mark.parametrize("name", MOTIONS)
def test_derivatives_against_differences(name: str):
    """Forwards and backwards, of all parts of motions with impacts, friction, a loop, states, inputs and outputs."""
    values = MOTIONS[name]
    f = em.to_jax(system_of(name, "lagrange"), (0.0, 0.6), [0.2, 0.6], by=list(values), of=EVERY, **TIGHT)
    check_grads(jax.jit(f), (values,), order=1, modes=("fwd", "rev"), eps=1e-6, atol=1e-6, rtol=1e-6)
    assert apart(jax.jit(jax.jacrev(f))(values), jax.jit(jax.jacfwd(f))(values)) < 1e-8


def test_closed_form_after_a_bounce():
    """z(t) = e s (t - t_1) - g (t - t_1)^2 / 2 after t_1 = sqrt(2 h / g), with s = g t_1."""
    values = {"z": 1.0, "g": 9.81, "e": 0.9}
    f = em.to_jax(ball(), (0.0, 0.7), [0.7], by=list(values), of="x", **TIGHT)

    def right(at: dict[str, Any]) -> Any:
        first = jnp.sqrt(2 * at["z"] / at["g"])
        return at["e"] * at["g"] * first * (0.7 - first) - at["g"] * (0.7 - first) ** 2 / 2

    assert apart(f(values)["x"][0, 0], right(values)) < 1e-9
    for transform in (jax.grad, jax.jacfwd):
        assert apart(transform(lambda at: f(at)["x"][0, 0])(values), transform(right)(values)) < 1e-9


def test_rows_are_those_of_a_run():
    values = {"q1": 0.2, "i": 0.4, "target": 0.05, "K": 0.11}
    system, times = system_of("servo_pendulums", "lagrange"), [0.1, 0.5]
    f = em.to_jax(system, (0.0, 0.5), times, by=list(values), of=EVERY, x0={"q2": 0.0}, v0=[0.0, 0.1, 0.0])
    run = em.simulate(
        system, (0.0, 0.5), t_eval=times, x0={"q1": 0.2, "q2": 0.0, "i": 0.4}, v0=[0.0, 0.1, 0.0],
        inputs={"target": 0.05}, parameters={"K": 0.11},
    )  # fmt: skip
    for found in (f(values), jax.jit(f)(values)):
        assert set(found) == set(EVERY)
        for part in ("x", "v"):
            np.testing.assert_array_equal(found[part], getattr(run, part))
        for part in ("states", "outputs"):
            assert set(found[part]) == set(getattr(run, part))
            for name, rows in found[part].items():
                np.testing.assert_array_equal(rows, getattr(run, part)[name])


def test_vmap_is_one_ensemble(monkeypatch):
    """Bit for bit; nested, of shared values, and compiled, too."""
    calls, given = [], many(BALL, 6)
    whole = motion_map.simulate_ensemble
    monkeypatch.setattr(motion_map, "simulate_ensemble", lambda *a, **k: calls.append(k) or whole(*a, **k))
    monkeypatch.setattr(motion_map, "simulate", None)  # no single run
    f, x0 = fall(), {"z": np.array(given["z"])}
    runs = em.simulate_ensemble(
        ball(), (0.0, 1.0), t_eval=[0.4, 0.7, 1.0], x0=x0, v0={"z": np.array(given["z'"])},
        parameters={"e": np.array(given["e"]), "g": np.array(given["g"])}, inputs={"push": np.array(given["push"])},
        **TIGHT,
    )  # fmt: skip
    nested = jax.tree.map(lambda row: row.reshape(2, 3), given)
    for function, values in ((jax.vmap(f), given), (jax.jit(jax.vmap(f)), given), (jax.vmap(jax.vmap(f)), nested)):
        found = function(values)
        np.testing.assert_array_equal(found["x"].reshape(6, 1, 3), runs.x)
        np.testing.assert_array_equal(found["outputs"]["pull"].reshape(6, 3), runs.outputs["pull"])
    shared = jax.vmap(lambda height: f(BALL | {"z": height}))(jnp.array([0.9, 1.0, 1.1]))
    assert shared["x"].shape == (3, 1, 3)
    assert len(calls) == 4


def test_derivatives_of_many_motions():
    """Each as alone: gradients, and derivatives along a shared direction, which is transposed back to it."""
    f, given = fall(of=EVERY), many(BALL, 3)

    def size(values: dict[str, Any]) -> Any:
        found = f(values)
        return (found["x"] * found["v"]).sum() + found["outputs"]["pull"].sum()

    each = [jax.tree.map(lambda row, k=k: row[k], given) for k in range(3)]
    right = jax.tree.map(lambda *rows: jnp.stack(rows), *map(jax.jit(jax.grad(size)), each))
    for derivative in (
        jax.vmap(jax.grad(size)),
        jax.jit(jax.vmap(jax.grad(size))),
        jax.jit(jax.grad(lambda values: jax.vmap(size)(values).sum())),
        jax.jit(jax.vmap(jax.jacfwd(size))),
    ):
        assert apart(derivative(given), right) < 1e-8

    def moved(direction: dict[str, Any]) -> Any:
        return jax.vmap(lambda values: jax.jvp(size, (values,), (direction,))[1])(given).sum()

    back = jax.jit(jax.grad(moved))(BALL)
    assert apart(back, jax.tree.map(lambda rows: rows.sum(), right)) < 1e-8


def test_a_chain_of_pieces_is_the_whole_run():
    """Pieces of 0.25 s, each from the end of the last, with a force of its own: the input of a controller."""
    system = ball()
    piece = em.to_jax(system, (0.0, 0.25), [0.25], by=["z", "z'", "push", "e"], of=("x", "v"), **TIGHT)
    whole = em.to_jax(system, (0.0, 1.0), [1.0], by=["z", "z'", "push", "e"], of=("x", "v"), **TIGHT)

    def pieces(values: dict[str, Any]) -> dict[str, Any]:
        def step(now: tuple[Any, Any], force: Any) -> tuple[tuple[Any, Any], None]:
            end = piece({"z": now[0], "z'": now[1], "push": force, "e": values["e"]})
            return (end["x"][0, 0], end["v"][0, 0]), None

        (x, v), _ = jax.lax.scan(step, (values["z"], values["z'"]), values["push"] * jnp.ones(4))
        return {"x": x, "v": v}

    at = {"z": jnp.array(1.0), "z'": jnp.array(0.3), "push": jnp.array(1.0), "e": jnp.array(0.8)}
    assert apart(pieces(at), whole(at)) < 1e-8
    assert apart(jax.jit(jax.jacrev(pieces))(at), jax.jacfwd(whole)(at)) < 1e-7


WRONG = {
    "unknown": (BALL | {"q": 1.0}, "unknown name 'q'"), "missing": ({"z": 1.0}, "no value for"),
    "no mapping": ([1.0], "takes a mapping"), "float32": (BALL | {"z": np.float32(1.0)}, "'z' is float32"),
    "an array": (BALL | {"z": jnp.ones(2)}, r"'z' is float64\[2\]"),
    "not finite": (BALL | {"g": np.nan}, "not a finite"),
}  # fmt: skip


@pytest.mark.parametrize("which", WRONG)
def test_mistakes_of_values(which: str):
    with pytest.raises(ModelError, match=WRONG[which][1]):
        fall()(WRONG[which][0])


@pytest.mark.parametrize(("wrong", "words"), [
    ({"by": ["h"]}, "unknown name in by"), ({"by": []}, "by is empty"),
    ({"of": ("y",)}, "unknown part in of"),
    ({"of": ()}, "unknown part in of"), ({"of": "states"}, "has no states"), ({"dense_output": True}, "unknown option"),
    ({"t_eval": None}, "give the times"), ({"t_eval": [2.0]}, "t_eval"), ({"system": "ball"}, "system"),
])  # fmt: skip
def test_mistakes_of_arguments(wrong: dict[str, Any], words: str):
    given = {"system": ball(), "t_span": (0.0, 1.0), "t_eval": [1.0], "by": ["z"]} | wrong
    with pytest.raises(ModelError, match=words):
        em.to_jax(given.pop("system"), given.pop("t_span"), given.pop("t_eval"), **given)


def test_failures_are_named():
    """Of a run, of one of many, of an event that ends a run early; also in compiled functions."""
    f, low = fall(max_steps=3), jnp.array([1.0, 2.0, -1e-3])
    with pytest.raises(ModelError, match=r"pushed_ball: .*max_steps"):
        f(BALL)
    with pytest.raises(ModelError, match=r"pushed_ball: .*max_steps"):
        jax.grad(lambda at: f(at)["x"].sum())(BALL)
    with pytest.raises((ValueError, jax.errors.JaxRuntimeError), match=r"pushed_ball: .*max_steps"):
        jax.block_until_ready(jax.jit(f)(BALL))
    with pytest.raises(ModelError, match=r"pushed_ball: motion 2 \(of 0 to 2\): .*g"):
        jax.vmap(lambda gravity: fall()(BALL | {"g": gravity}))(low)
    ended = ball(events={"floor": Event(z, direction=-1, terminal=True)})
    for function in (jax.jit, jax.jacfwd, jax.jacrev, lambda one: one):
        short = function(em.to_jax(ended, (0.0, 1.0), [0.1, 1.0], by=["z"]))
        with pytest.raises(
            (ValueError, jax.errors.JaxRuntimeError), match=r"ended before its last row, at t = 1. .*terminal event"
        ):
            jax.block_until_ready(short({"z": 1.0}))
    with pytest.raises(ModelError, match="ended before its last row"):
        jax.vmap(em.to_jax(ended, (0.0, 1.0), [1.0], by=["z"]))({"z": jnp.array([0.9, 1.0])})


def test_second_derivatives_are_refused():
    with pytest.raises(ModelError, match="first derivatives only"):
        jax.hessian(lambda values: fall()(values)["x"].sum())(BALL)


def test_float32_is_refused():
    """JAX computes in float32 unless told otherwise."""
    with jax.enable_x64(False), pytest.raises(ModelError, match="jax_enable_x64"):
        fall()
    f = fall()
    with jax.enable_x64(False), pytest.raises(ModelError, match="jax_enable_x64"):
        f(BALL)
