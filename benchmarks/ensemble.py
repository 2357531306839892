"""Many runs: dual_link over 10 s, K1 varied, beside heyoka.py's batches; threads; processes; and a loop of `simulate`.

Ratios are medians over rounds in which whatever is compared runs in turns. Errors are medians over members of the
largest error of x at the end, against runs at 1e-13.
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
MANY = 300_000  # runs: so many that an executor's chunks, eight on two cores, are of a second each
SCENES = {"four_bar": {}, "chaplygin_sleigh": {}, "spatial_arm": {"n": 6}, "chain": {"n": 8}}

LOOPS = ("four_bar", "slider_crank", "bricard", "jansen")


def spread(count: int) -> np.ndarray:
    """K1 of so many members."""
    return np.linspace(0.5, 2.0, count)


def ensemble(system: System, count: int, tolerance: float, **options: object) -> np.ndarray:
    """x (count, n) at the end."""
    given = {"rtol": tolerance, "atol": tolerance, "workers": 1, **options}
    return simulate_ensemble(system, SPAN, parameters={"K1": spread(count)}, **given).x[:, :, 0]


def tolerance_for(run: Callable[[float], np.ndarray], exact: np.ndarray) -> tuple[float, float]:
    """The loosest tolerance that reaches the target, and the error there."""
    for tolerance in TOLERANCES:
        error = float(np.median(np.abs(run(tolerance) - exact).max(axis=1)))
        if error <= TARGET:
            return float(tolerance), error
    return float(tolerance), error


def batches() -> Callable[[int, float, int], Callable[[], np.ndarray]] | None:
    """heyoka.py's: (count, tolerance, batch) -> what runs them; integrators are compiled before."""
    if find_spec("heyoka") is None:
        return None
    import heyoka  # noqa: PLC0415, an optional package

    model = load_model(MODELS / "dual_link.py")
    equations = classical(model)
    constants = tuple((key, heyoka.par[0] if str(key) == "K1" else value) for key, value in equations.constants)
    n = len(equations.x)
    x, v = ([heyoka.expression(f"{letter}{k}") for k in range(n)] for letter in "xv")
    a = explicit(replace(equations, constants=constants), functions_of(heyoka), x, v, heyoka.time)
    system = list(zip([*x, *v], [e + heyoka.expression(0.0) for e in (*v, *a)], strict=True))
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
    """Two threads over one, on short work and on ten times that; and two processes, which share nothing: what those
    gain is what the machine has to give."""
    system = build(MODELS / "dual_link.py", formulation="lagrange")
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        calls = {f"{runs} by {workers}": partial(ensemble, system, runs, 1e-10, workers=workers)
                 for runs in (4000, 40_000) for workers in (1, 2)}  # fmt: skip
        calls["processes"] = lambda: list(pool.map(half, [system] * 2))
        calls["processes"]()  # they load what they need
        seconds = interleaved(calls, ROUNDS)
    for runs in (4000, 40_000):
        gained = ratio(seconds[f"{runs} by 1"], seconds[f"{runs} by 2"])
        print(f"\n{runs} runs: two threads {gained} times as fast as one", end="")
    print(f"\n4000 runs: two processes {ratio(seconds['4000 by 1'], seconds['processes'])} times as fast as one thread")


class Watched(Executor):
    """Another executor, and the seconds that each chunk took in its worker."""

    def __init__(self, pool: Executor) -> None:
        self.pool, self.seconds = pool, list[float]()

    def submit(self, function: Callable[..., object], /, *given: object) -> Future:  # type: ignore[override]
        future = self.pool.submit(function, *given)
        future.add_done_callback(lambda done: self.seconds.append(done.result()[1]))
        return future


def processes() -> None:
    """An executor of two processes that have begun, on chunks of a second as design.md has them, over one thread."""
    system = build(MODELS / "dual_link.py", formulation="lagrange")
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        watched = Watched(pool)
        ensemble(system, 1000, 1e-10, workers=None, executor=pool)  # they load what they need
        calls = {
            "thread": partial(ensemble, system, MANY, 1e-10),
            "executor": partial(ensemble, system, MANY, 1e-10, workers=None, executor=watched),
        }
        seconds = interleaved(calls, ROUNDS)
    chunks = np.array(watched.seconds)
    chunks = chunks[chunks > 0.1 * np.median(chunks)]  # without pilots
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
            given = {"rtol": 1e-9, "atol": 1e-9}
            key = first if name != "four_bar" else "density"
            calls = {
                "ensemble": partial(
                    simulate_ensemble, system, (0.0, 1.0), parameters={key: values}, workers=1, **given
                ),
                "loop": lambda s=system, k=key, v=values, g=given: [
                    s.simulate((0.0, 1.0), parameters={k: p}, **g) for p in v
                ],
            }
            seconds = interleaved(calls, ROUNDS)
            print(f"  {name:<20}{formulation:<14}{ratio(seconds['ensemble'], seconds['loop'])}", flush=True)


def beside_nodes(count: int = 24) -> None:
    """What method="auto" goes by where steps are put on positions one by one."""
    tolerances = 10.0 ** -np.arange(6, 12)
    print(
        f"\n{count} runs of 1 s, lanes of dop853 over ra15, one core, at {' '.join(f'{one:.0e}' for one in tolerances)}"
    )
    for name in LOOPS:
        system = build(MODELS / f"{name}.py", formulation="lagrange")
        key, value = next(iter(system.parameters.items()))
        found = []
        for tolerance in tolerances:
            given = {"parameters": {key: np.full(count, value)}, "rtol": tolerance, "atol": tolerance, "workers": 1}
            calls = {m: partial(simulate_ensemble, system, (0.0, 1.0), method=m, **given) for m in ("dop853", "ra15")}
            seconds = interleaved(calls, 3 * ROUNDS, time.thread_time)
            found.append(f"{np.median(seconds['dop853'] / seconds['ra15']):.2f}")
        print(f"  {name:<20}{'   '.join(found)}", flush=True)


def main() -> None:
    beside_batches()
    threads()
    processes()
    beside_a_loop()
    beside_nodes()


if __name__ == "__main__":
    main()
