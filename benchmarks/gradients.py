"""Benchmark of gradients: time of `em.vjp` and a pullback over that of a plain run, beside forward sensitivities.

A hanging chain of ten links, with springs and dampers at its joints, swings against a wall, where impacts and a contact
that holds change its mode; 50 quantities. Times are medians over rounds in which all runs alternate. Then a run of
100,000 steps within 32 MB: how much more memory the process takes than before the gradient.

With --jax: the time of `em.to_jax`, compiled. 1,000 motions by `jax.vmap` over `simulate_ensemble`, and a gradient over
`em.vjp` with its pullback.

python benchmarks/gradients.py [--jax]
"""

from __future__ import annotations

import resource
import sys
import time
from functools import partial

import numpy as np
from common.timing import interleaved
from eigenmotion.models.bouncing_ball import model as bouncing_ball
from eigenmotion.models.double_pendulum import model as double_pendulum
from eigenmotion.models.driven_pendulum import model as driven_pendulum
from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

COUNT, SPAN, ROUNDS = 10, (0.0, 3.0), 15
TIMES = np.linspace(*SPAN, 31)


def hanging_chain() -> em.Model:
    """Return the chain; springs and dampers are between neighbouring links, and the tip meets a wall."""
    theta = dynamicsymbols(f"theta1:{COUNT + 1}")
    m, l, k, d = (symbols(f"{letter}1:{COUNT + 1}", positive=True) for letter in "mlkd")
    g, e, wall = symbols("g e wall", positive=True)
    x = [sum(l[i] * sin(theta[i]) for i in range(j + 1)) for j in range(COUNT)]
    y = [-sum(l[i] * cos(theta[i]) for i in range(j + 1)) for j in range(COUNT)]
    bends = [theta[0], *(theta[i] - theta[i - 1] for i in range(1, COUNT))]
    dissipation = sum(d[i] * bend.diff(em.t) ** 2 / 2 for i, bend in enumerate(bends))
    values = {m: 1.0, l: 0.3, k: 5.0, d: 0.05}
    return em.Model(
        name="chain_at_a_wall", coordinates=theta,
        kinetic_energy=sum(m[i] * (x[i].diff(em.t) ** 2 + y[i].diff(em.t) ** 2) / 2 for i in range(COUNT)),
        potential_energy=sum(m[i] * g * y[i] + k[i] * bends[i] ** 2 / 2 for i in range(COUNT)),
        forces=[-dissipation.diff(one.diff(em.t)) for one in theta],
        contacts={"wall": em.Contact(x[-1] + wall, restitution=e, rest=Rational(1, 20))},
        parameters={one: value for row, value in values.items() for one in row} | {g: 9.81, e: 0.3, wall: 0.2},
        initial=dict.fromkeys(theta, 0.3),
    )  # fmt: skip


def fifty(system: em.System) -> list[str]:
    """Return parameters and the start, without those of the contact's modes, on which no motion depends."""
    given = [name for name in system.parameters if not name.startswith("wall_")]
    return [*given, *system.coordinates, *(f"{name}'" for name in system.coordinates)][:50]


def gradient(system: em.System, by: list[str], method: str, weight: np.ndarray) -> dict[str, float]:
    _, pullback = em.vjp(system, SPAN, by=by, t_eval=TIMES, rtol=1e-9, method=method)
    return pullback(dx=weight)


def compare(method: str) -> None:
    system = em.build(hanging_chain())
    by, options = fifty(system), {"t_eval": TIMES, "rtol": 1e-9, "method": method}
    weight = np.random.default_rng(0).standard_normal((COUNT, len(TIMES)))
    forward = partial(system.simulate, SPAN, sensitivities=by, **options)
    calls = {
        "plain": partial(system.simulate, SPAN, **options), "adjoint": partial(gradient, system, by, method, weight),
        "forward": forward,
    }  # fmt: skip
    middle = {name: np.median(seconds) for name, seconds in interleaved(calls, ROUNDS, time.thread_time).items()}
    run, found = forward(), gradient(system, by, method, weight)
    terms = {name: weight * run.sensitivity[name].dx for name in by}
    size = {name: np.abs(one).sum() for name, one in terms.items()}
    off = max(abs(found[name] - one.sum()) / size[name] for name, one in terms.items())
    print(
        f"{method:<8}{len(by)} quantities, {len(run.t_events[0])} events, {len(run.modes)} modes; over a plain run of "
        f"{1e3 * middle['plain']:.1f} ms: adjoint {middle['adjoint'] / middle['plain']:.2f}, "
        f"forward {middle['forward'] / middle['plain']:.1f}; apart by {off:.0e}"
    )


def peak() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3


def long_run() -> None:
    system, before = em.build(driven_pendulum), peak()
    options = {"t_eval": [1000.0], "rtol": 1e-9, "max_step": 0.01}
    plain = min(interleaved({"plain": partial(system.simulate, (0, 1000), **options)}, 3, time.thread_time)["plain"])
    start = time.thread_time()
    solution, pullback = em.vjp(system, (0, 1000), by=["l", "a", "x"], memory=32, **options)
    pullback(dx=np.ones((system.n, 1)))
    print(
        f"{solution.nsteps} steps with memory=32: {(time.thread_time() - start) / plain:.1f} plain runs, "
        f"{peak() - before:.0f} MB more than before"
    )


def by_jax(model: em.Model, by: list[str], span: tuple[float, float], count: int = 1000) -> None:
    import jax  # noqa: PLC0415, an optional package
    import jax.numpy as jnp  # noqa: PLC0415

    jax.config.update("jax_enable_x64", True)
    system, options = em.build(model), {"t_eval": np.linspace(*span, 11)[1:], "rtol": 1e-9}
    times, rtol = options.values()
    motion = em.to_jax(system, span, times, by=by, of="x", rtol=rtol)
    heights = np.linspace(0.5, 1.0, count)
    one, values = dict.fromkeys(by, jnp.array(0.7)), dict.fromkeys(by, jnp.array(heights))
    together = jax.jit(jax.vmap(lambda given: motion(given)["x"]))
    sum_of = jax.jit(jax.grad(lambda given: motion(given)["x"].sum()))

    def pulled() -> dict[str, float]:
        solution, pullback = em.vjp(system, span, by=by, x0=dict.fromkeys(by, 0.7), **options)
        return pullback(dx=np.ones_like(solution.x))

    calls = {
        "ensemble": lambda: em.simulate_ensemble(system, span, x0=dict.fromkeys(by, heights), **options).x,
        "vmap": lambda: jax.block_until_ready(together(values)),
        "vjp": pulled, "grad": lambda: jax.block_until_ready(sum_of(one)),
    }  # fmt: skip
    assert np.array_equal(calls["ensemble"](), calls["vmap"]())
    assert np.allclose([float(found) for found in calls["grad"]().values()], list(calls["vjp"]().values()), rtol=1e-8)
    middle = {name: np.median(seconds) for name, seconds in interleaved(calls, ROUNDS).items()}
    print(
        f"{system.name}: {count} motions by vmap {middle['vmap'] / middle['ensemble']:.2f} of simulate_ensemble "
        f"({1e3 * middle['ensemble']:.0f} ms); a gradient {middle['grad'] / middle['vjp']:.2f} of em.vjp "
        f"({1e3 * middle['vjp']:.1f} ms)"
    )


if __name__ == "__main__":
    if "--jax" in sys.argv:
        by_jax(double_pendulum, list(em.build(double_pendulum).coordinates), (0.0, 10.0))
        by_jax(bouncing_ball, ["z"], (0.0, 1.5))
        sys.exit()
    for one in ("dop853", "ra15"):
        compare(one)
    long_run()
