"""Runs the linkage in Newton with its solver Kamino: bodies in space, four revolute joints, on the processor."""

from collections.abc import Iterator
from math import cos, sin
from time import perf_counter

import newton
import numpy as np
import warp as wp
from four_bar import RATE, A, B, C, D, G, Trial, reference, start

STEP, SPAN = 1e-3, 0.1


def trials() -> Iterator[Trial]:
    """Step the linkage; it lies in the plane of x and z, and turns about -y. Numbers are in single precision.

    Ten seconds take too long on a processor, for which it is not made: a part of one is run.
    """
    wp.config.quiet = True
    wp.set_device("cpu")
    model = _linkage()
    solver = newton.solvers.SolverKamino(model=model, config=_settings(model))
    before, after, control = model.state(), model.state(), model.control()
    _launch(before)
    q, turned = start()[0], np.zeros(3)
    solver.step(before, after, control, None, STEP)
    _launch(before)
    begun = perf_counter()
    for _ in range(round(SPAN / STEP)):
        solver.step(before, after, control, None, STEP)
        before, after = after, before
        now = _directions(before)
        turned += (now - (q + turned) + np.pi) % (2 * np.pi) - np.pi
    seconds = perf_counter() - begun
    trial = Trial(f"Kamino, {STEP:g} s, for {SPAN:g} s only", q + turned, -before.body_qd.numpy()[:, 4], seconds)
    print(f"  {trial.line(reference(SPAN))}")
    yield from ()


def _linkage() -> newton.Model:
    builder = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=(0.0, 0.0, -G))
    newton.solvers.SolverKamino.register_custom_attributes(builder)
    builder.begin_world()
    bars = []
    for length, angle, foot in _bars():
        at = np.array([foot[0], 0.0, foot[1]]) + length / 2 * np.array([cos(angle), 0.0, sin(angle)])
        turned = wp.quat_from_axis_angle(wp.vec3(0.0, -1.0, 0.0), float(angle))
        inertia = wp.mat33(np.diag([1e-4, length**3 / 12, length**3 / 12]).astype(np.float32))
        bars.append(builder.add_link(xform=wp.transform(wp.vec3(*map(float, at)), turned), mass=length, inertia=inertia,
                                     lock_inertia=True))  # fmt: skip
    ends = ((-1, 0.0, bars[0], -A / 2), (bars[0], A / 2, bars[1], -B / 2), (-1, D, bars[2], -C / 2),
            (bars[1], B / 2, bars[2], C / 2))  # fmt: skip
    joints = [
        builder.add_joint_revolute(parent, child, parent_xform=_at(one), child_xform=_at(two), axis=(0.0, -1.0, 0.0))
        for parent, one, child, two in ends
    ]
    builder.add_articulation(joints[:3])
    builder.end_world()
    return builder.finalize(skip_validation_joints=True)


def _settings(model: newton.Model) -> object:
    settings = newton.solvers.SolverKamino.Config.from_model(model)
    settings.padmm.primal_tolerance = settings.padmm.dual_tolerance = settings.padmm.compl_tolerance = (
        1e-4  # as its example of a four-bar
    )
    settings.padmm.max_iterations = 200
    return settings


def _bars() -> Iterator[tuple[float, float, tuple[float, float]]]:
    """Give length, direction and foot of each bar."""
    q, _ = start()
    yield from zip((A, B, C), q, ((0.0, 0.0), (A * cos(q[0]), A * sin(q[0])), (D, 0.0)), strict=True)


def _at(x: float) -> object:
    return wp.transform(wp.vec3(x, 0.0, 0.0), wp.quat_identity())


def _launch(state: newton.State) -> None:
    """Give the bodies their velocities (of mass centres) and rates."""
    (q1, q2, q3), v = start()
    feet = ((0.0, 0.0), (-A * sin(q1) * RATE, A * cos(q1) * RATE), (0.0, 0.0))
    rates = np.zeros((3, 6), dtype=np.float32)
    for k, (length, angle, rate) in enumerate(zip((A, B, C), (q1, q2, q3), v, strict=True)):
        rates[k, 0] = feet[k][0] - length / 2 * sin(angle) * rate
        rates[k, 2] = feet[k][1] + length / 2 * cos(angle) * rate
        rates[k, 4] = -rate
    state.body_qd.assign(rates)


def _directions(state: newton.State) -> np.ndarray:
    """Return the directions of the bars (3,) from their quaternions."""
    _, y, _, w = state.body_q.numpy()[:, 3:].T
    return -2 * np.arctan2(y, w)
