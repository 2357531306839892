"""Benchmark of ensembles: dual_link over 10 s with varied K1, compared with heyoka.py's batches; loops of `simulate`.

Also the gain by threads and processes. Ratios are medians over rounds in which the compared calls alternate. Errors are
medians over members of the largest error of x at the end, compared with runs at 1e-13.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from importlib.util import find_spec
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from common.timing import interleaved, ratio
from common.timing import spread as spread_of

from eigenmotion import System, build, load_model, simulate_ensemble
from eigenmotion.reference.lagrange_equations import classical, explicit
from eigenmotion.report.peers import functions_of

MODELS = Path(__file__).parents[1] / "models"
FORMULATIONS = ("lagrange", "inverse", "cholesky", "eigenfactor")
TARGET, TOLERANCES = 5e-10, 10.0 ** -np.arange(8.5, 12.1, 0.125)
SPAN, ROUNDS = (0.0, 10.0), 5
COUNTS = (1, 8, 100, 10_000)
SLOW = tuple(f"{formulation} ra15" for formulation in FORMULATIONS)  # left out where there are many runs
MANY = 300_000  # runs: enough for an executor's chunks (eight on two cores) to take a second each
SCENES = {"four_bar": {}, "chaplygin_sleigh": {}, "spatial_arm": {"n": 6}, "chain": {"n": 8}}

LOOPS = ("four_bar", "slider_crank", "bricard", "jansen")


def spread(count: int) -> np.ndarray:
    """Return K1 of `count` members."""
    return np.linspace(0.5, 2.0, count)


def ensemble(system: System, count: int, tolerance: float, **options: object) -> np.ndarray:
    """Return x (count, n) at the end."""
    options = {"rtol": tolerance, "atol": tolerance, "workers": 1, **options}
    return simulate_ensemble(system, SPAN, parameters={"K1": spread(count)}, **options).x[:, :, 0]


def tolerance_for(run: Callable[[float], np.ndarray], exact: np.ndarray) -> tuple[float, float]:
    """Return the loosest tolerance that reaches the target error, and the error there."""
    for tolerance in TOLERANCES:
        error = float(np.median(np.abs(run(tolerance) - exact).max(axis=1)))
        if error <= TARGET:
            return float(tolerance), error
    return float(tolerance), error


def batches() -> Callable[[int, float, int], Callable[[], np.ndarray]] | None:
    """Return (count, tolerance, batch) -> function that makes these runs with heyoka.py, by a compiled integrator."""
    if find_spec("heyoka") is None:
        return None
    import heyoka  # noqa: PLC0415, an optional package

    model = load_model(MODELS / "dual_link.py")
    equations = classical(model)
    constants = tuple((key, heyoka.par[0] if str(key) == "K1" else value) for key, value in equations.constants)
    n = len(equations.x)
    y = [heyoka.expression(f"y{k}") for k in range(2 * n)]
    rates = explicit(replace(equations, constants=constants), functions_of(heyoka), y, heyoka.time)
    system = list(zip(y, [e + heyoka.expression(0.0) for e in rates], strict=True))
    start = build(model).initial

    def runner(count: int, tolerance: float, batch: int) -> Callable[[], np.ndarray]:
        state = np.repeat(np.concatenate(start)[:, None], batch, axis=1)
        integrator = heyoka.taylor_adaptive_batch(system, state=state.copy(), tol=tolerance, pars=np.ones((1, batch)))
        values = np.resize(spread(count), -(-count // batch) * batch).reshape(-1, batch)

        def run() -> np.ndarray:
            ends = []
            for row in values:
                integrator.set_time(0.0)
                integrator.state[:] = state
                integrator.pars[0] = row
                integrator.propagate_until(SPAN[1])
                ends.append(integrator.state[:n].T.copy())
            return np.concatenate(ends)[:count]

        return run

    return runner


def beside_batches() -> None:
    systems = {formulation: build(MODELS / "dual_link.py", formulation=formulation) for formulation in FORMULATIONS}
    exact = ensemble(systems["lagrange"], 40, 1e-13, method="dop853")
    calls: dict[str, Callable[[int], object]] = {}
    for formulation, system in systems.items():
        for method in ("dop853", "ra15"):
            tolerance, error = tolerance_for(partial(ensemble, system, 40, method=method), exact)
            name = f"{formulation} {method}"
            calls[name] = partial(lambda s, t, m, count: ensemble(s, count, t, method=m), system, tolerance, method)
            print(f"{name:<24} tolerance {tolerance:.1e}, median error {error:.1e}")
    make, widths = batches(), (4, 8)
    for batch in widths if make else ():
        tolerance, error = tolerance_for(lambda t, b=batch: make(40, t, b)(), exact)
        runs = {count: make(count, tolerance, batch) for count in COUNTS}
        calls[f"heyoka.py, {batch} a batch"] = lambda count, runs=runs: runs[count]()
        print(f"heyoka.py, {batch} a batch    tolerance {tolerance:.1e}, median error {error:.1e}")
    for count in COUNTS:
        rounds = ROUNDS if count > 1000 else 5 * ROUNDS
        chosen = {name: call for name, call in calls.items() if count <= 1000 or name not in SLOW}
        seconds = interleaved({name: partial(call, count) for name, call in chosen.items()}, rounds)
        best = min(
            (name for name in seconds if name.startswith("heyoka")), key=lambda k: np.median(seconds[k]), default=None
        )
        print(f"\n{count} runs: microseconds a run on one core{', and over heyoka.py' if best else ''}")
        for name, took in seconds.items():
            beside = f"   {ratio(took, seconds[best])}" if best else ""
            print(f"  {name:<24}{1e6 * np.median(took) / count:10.1f}{beside}")


def half(system: System) -> None:
    ensemble(system, 2000, 1e-10)


def threads() -> None:
    """Print the gain by two threads over one, for two amounts of work, and by two processes.

    The processes share nothing, so that their gain shows what the machine can give.
    """
    system = build(MODELS / "dual_link.py", formulation="lagrange")
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        calls = {f"{runs} by {workers}": partial(ensemble, system, runs, 1e-10, workers=workers)
                 for runs in (4000, 40_000) for workers in (1, 2)}  # fmt: skip
        calls["processes"] = lambda: list(pool.map(half, [system] * 2))
        calls["processes"]()  # warm-up: the processes import and load the library
        seconds = interleaved(calls, ROUNDS)
    for runs in (4000, 40_000):
        gained = ratio(seconds[f"{runs} by 1"], seconds[f"{runs} by 2"])
        print(f"\n{runs} runs: two threads {gained} times as fast as one", end="")
    print(f"\n4000 runs: two processes {ratio(seconds['4000 by 1'], seconds['processes'])} times as fast as one thread")


class Watched(Executor):
    """A wrapper of an executor that records the seconds that each chunk takes in its worker."""

    def __init__(self, pool: Executor) -> None:
        self.pool, self.seconds = pool, list[float]()

    def submit(self, function: Callable[..., object], /, *arguments: object) -> Future:  # type: ignore[override]
        future = self.pool.submit(function, *arguments)
        future.add_done_callback(lambda done: self.seconds.append(done.result()[1]))
        return future


def processes() -> None:
    """Print the gain by an executor of two running processes over one thread, with chunks of a second."""
    system = build(MODELS / "dual_link.py", formulation="lagrange")
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        watched = Watched(pool)
        ensemble(system, 1000, 1e-10, workers=None, executor=pool)  # warm-up: the processes load the library
        calls = {
            "thread": partial(ensemble, system, MANY, 1e-10),
            "executor": partial(ensemble, system, MANY, 1e-10, workers=None, executor=watched),
        }
        seconds = interleaved(calls, ROUNDS)
    chunks = np.array(watched.seconds)
    chunks = chunks[chunks > 0.1 * np.median(chunks)]  # without the pilot runs, which are short
    times = ratio(seconds["thread"], seconds["executor"])
    print(f"\n{MANY} runs: an executor of two processes {times} times as fast as one thread, ", end="")
    print(f"in chunks of {spread_of(chunks, 1.0, 2)} s", flush=True)


def beside_a_loop(count: int = 64) -> None:
    print(f"\n{count} runs of 1 s at 1e-9: time of the ensemble over a loop of `simulate`, one core")
    for name, arguments in SCENES.items():
        for formulation in FORMULATIONS if arguments.get("n", 0) <= 6 else ("lagrange", "eigenfactor"):
            system = build(MODELS / f"{name}.py", formulation=formulation, **arguments)
            first = next(iter(system.parameters))
            values = system.parameters[first] * np.linspace(0.95, 1.05, count) if name != "four_bar" else np.ones(count)
            options = {"rtol": 1e-9, "atol": 1e-9}
            key = first if name != "four_bar" else "density"
            calls = {
                "ensemble": partial(
                    simulate_ensemble, system, (0.0, 1.0), parameters={key: values}, workers=1, **options
                ),
                "loop": lambda s=system, k=key, v=values, g=options: [
                    s.simulate((0.0, 1.0), parameters={k: p}, **g) for p in v
                ],
            }
            seconds = interleaved(calls, ROUNDS)
            print(f"  {name:<20}{formulation:<14}{ratio(seconds['ensemble'], seconds['loop'])}", flush=True)


def beside_nodes(count: int = 24) -> None:
    """Print the measurements on which method="auto" relies if each step is projected onto the position constraints."""
    tolerances = 10.0 ** -np.arange(6, 12)
    print(
        f"\n{count} runs of 1 s, lanes of dop853 over ra15, one core, at {' '.join(f'{one:.0e}' for one in tolerances)}"
    )
    for name in LOOPS:
        system = build(MODELS / f"{name}.py", formulation="lagrange")
        key, value = next(iter(system.parameters.items()))
        ratios = []
        for tolerance in tolerances:
            options = {"parameters": {key: np.full(count, value)}, "rtol": tolerance, "atol": tolerance, "workers": 1}
            calls = {m: partial(simulate_ensemble, system, (0.0, 1.0), method=m, **options) for m in ("dop853", "ra15")}
            seconds = interleaved(calls, 3 * ROUNDS, time.thread_time)
            ratios.append(f"{np.median(seconds['dop853'] / seconds['ra15']):.2f}")
        print(f"  {name:<20}{'   '.join(ratios)}", flush=True)


def main() -> None:
    beside_batches()
    threads()
    processes()
    beside_a_loop()
    beside_nodes()


if __name__ == "__main__":
    main()
