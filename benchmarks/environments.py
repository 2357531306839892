"""Comparison of environments of Gymnasium with batches of MuJoCo: the same mechanisms, methods, steps, and one thread.

python benchmarks/environments.py [--rounds 15]

The mechanisms are carts with one and with four poles, from one MJCF file each, which both read. A step of an
environment is 20 ms: two steps of 10 ms of RK4, with an action for each environment; it returns observations, rewards,
and which episodes are over. `em.gym_env` is compared with `mujoco.batch.Batch`, and with `mujoco.rollout` from a state
to the next, with what makes an environment of them in NumPy. First the motions are compared after a second. The time is
processor time of all threads; rounds alternate, and each begins with a reset, whose time does not count. Ratios above
1: `em.gym_env` steps more environments a second. Euler's method is MuJoCo's cheapest, and of first order: that ratio is
not of equal methods.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import mujoco
import numpy as np
from common.timing import ratio, spread
from mujoco import rollout
from mujoco.batch import Batch

import eigenmotion as em

POLES, COUNTS, MOST, STEP, SUBSTEPS, SECONDS = (1, 4), (256, 4096), 10.0, 0.01, 2, 1.0
LINK = (
    '<body pos="0 0 {at}"><joint name="q{k}" axis="0 1 0"/>'
    '<inertial pos="0 0 0.25" mass="0.1" diaginertia="0.002 0.002 0.001"/>{rest}</body>'
)


def links(k: int, count: int) -> str:
    return "" if k > count else LINK.format(at=0.5 * (k > 1), k=k, rest=links(k + 1, count))


def mjcf(poles: int) -> str:
    """Return a cart with poles on it, upright, which a force pushes."""
    return f"""<mujoco model="cart_with_{poles}"><option timestep="{STEP}" integrator="RK4" gravity="0 0 -9.81">
    <flag contact="disable"/></option><worldbody><body name="cart"><joint name="x" type="slide" axis="1 0 0"/>
    <inertial pos="0 0 0" mass="1" diaginertia="0.1 0.1 0.1"/>{links(1, poles)}</body></worldbody>
    <actuator><motor name="push" joint="x"/></actuator></mujoco>"""


def reward(seen: np.ndarray, actions: np.ndarray) -> np.ndarray:
    return np.cos(seen[:, 1]) - 0.01 * actions[:, 0] ** 2


def over(seen: np.ndarray) -> np.ndarray:
    return np.abs(seen[:, 0]) > 1e6  # never, so that all have the same work


class Ours:
    """Environments of `em.gym_env`."""

    def __init__(self, system: em.System, count: int) -> None:
        self.envs = em.gym_env(
            system, count, actions={"tau_x": (-MOST, MOST)}, period=STEP * SUBSTEPS, reward=reward, terminated=over,
            max_steps=10**9, method="rk4", step=STEP, workers=1,
        )  # fmt: skip
        self.begin()

    def begin(self) -> None:
        self.envs.reset(seed=0)

    def step(self, actions: np.ndarray) -> np.ndarray:
        seen, _, _, _, info = self.envs.step(actions)
        if info:
            raise RuntimeError(str(info))
        return seen


class InBatch:
    """Environments of MuJoCo's Batch, whose state is theirs."""

    def __init__(self, model: mujoco.MjModel, count: int) -> None:
        self.batch = Batch(model, nsim=count, nthread=1)
        self.x, self.v, self.u = (self.batch.bind(name) for name in ("qpos", "qvel", "ctrl"))
        self.steps = np.zeros(count, dtype=np.int64)

    def begin(self) -> None:
        self.batch.reset(stage=mujoco.mjtStage.mjSTAGE_NONE.value)

    def step(self, actions: np.ndarray) -> np.ndarray:
        self.u[:] = actions
        self.batch.step(nstep=SUBSTEPS)
        self.steps += 1
        seen = np.hstack([self.x, self.v])
        _ = reward(seen, actions), over(seen), self.steps >= 10**9
        return seen


class RolledOut:
    """Environments of MuJoCo's rollout, from the last state to the next."""

    def __init__(self, model: mujoco.MjModel, count: int) -> None:
        self.model, self.data, self.n = model, [mujoco.MjData(model)], model.nq
        size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        self.state = np.zeros((count, size))
        self.path, self.steps = np.zeros((count, SUBSTEPS, size)), np.zeros(count, dtype=np.int64)

    def begin(self) -> None:
        self.state[:] = 0.0

    def step(self, actions: np.ndarray) -> np.ndarray:
        controls = np.repeat(actions[:, None], SUBSTEPS, axis=1)
        rollout.rollout(self.model, self.data, self.state, controls, state=self.path)
        self.state = self.path[:, -1].copy()
        self.steps += 1
        seen = self.state[:, 1 : 1 + 2 * self.n].copy()
        _ = reward(seen, actions), over(seen), self.steps >= 10**9
        return seen


def agree(kinds: dict[str, Ours | InBatch | RolledOut], count: int) -> str:
    """Return how far the motions are apart after a second of small random pushes."""
    random = np.random.default_rng(0)
    for _ in range(round(SECONDS / (STEP * SUBSTEPS))):
        actions = random.uniform(-1.0, 1.0, (count, 1))
        seen = {name: one.step(actions) for name, one in kinds.items()}
    ours = seen.pop("em.gym_env")
    return ", ".join(f"{name} {np.abs(other - ours).max() / np.abs(ours).max():.0e}" for name, other in seen.items())


def stepping(one: Ours | InBatch | RolledOut, actions: np.ndarray) -> float:
    """Return the seconds of steps from a reset."""
    one.begin()
    begin = time.process_time()
    for action in actions:
        one.step(action)
    return time.process_time() - begin


def show(poles: int, count: int, rounds: int, folder: Path) -> None:
    path = folder / f"cart_with_{poles}.xml"
    path.write_text(mjcf(poles))
    system = em.build(em.load_mjcf(path), formulation="lagrange")
    model, euler = (mujoco.MjModel.from_xml_path(str(path)) for _ in range(2))
    ours = Ours(system, count)
    kinds = {"em.gym_env": ours, "Batch": InBatch(model, count), "rollout": RolledOut(model, count)}
    lanes = ours.envs.steppers.lanes
    print(
        f"{poles} poles, {count} environments, {lanes} lanes; apart after {SECONDS} s, relative: {agree(kinds, count)}"
    )
    euler.opt.integrator = mujoco.mjtIntegrator.mjINT_EULER
    kinds["Batch, Euler"] = InBatch(euler, count)
    times = max(16, 8192 // count)
    actions = np.random.default_rng(1).uniform(-1.0, 1.0, (times, count, 1))
    found = [{name: stepping(one, actions) for name, one in kinds.items()} for _ in range(1 + rounds)][1:]
    seconds = {name: np.array([one[name] for one in found]) for name in kinds}
    for name, taken in seconds.items():
        ahead = ratio(taken, seconds["em.gym_env"])
        print(f"  {name:14} {spread(taken / (times * count), 1e-6):28} us an environment's step, ratio {ahead}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=15)
    rounds = parser.parse_args().rounds
    with tempfile.TemporaryDirectory() as folder:
        for poles in POLES:
            for count in COUNTS:
                show(poles, count, rounds, Path(folder))


if __name__ == "__main__":
    main()
