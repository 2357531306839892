"""Runs the linkage in Pinocchio: two ways to accelerations through the loop; the integrator is ours, RK4."""

from collections.abc import Callable, Iterator
from time import perf_counter

import numpy as np
import pinocchio as pin
from four_bar import SPAN, A, B, C, D, G, Trial, start

STEP = 1e-3


def trials() -> Iterator[Trial]:
    """Integrate with the accelerations of constraintDynamics and of lcaba; nothing holds the loop but these."""
    (q1, q2, q3), v = start()
    angles, rates = np.array([q1, q2 - q1, q3]), np.array([v[0], v[1] - v[0], v[2]])
    for name in ("constraintDynamics", "lcaba"):
        accelerate = _accelerations(name)
        before = perf_counter()
        q, w = _rk4(accelerate, angles, rates)
        seconds = perf_counter() - before
        yield Trial(f"{name}, RK4 in Python, {STEP:g} s", _absolute(q), _absolute(w), seconds)


def _accelerations(name: str) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    model = _linkage()
    loop = pin.RigidConstraintModel(pin.ContactType.CONTACT_3D, model, 2, _at(B), 3, _at(C), pin.LOCAL)
    models = pin.StdVec_RigidConstraintModel()
    models.append(loop)
    datas = pin.StdVec_RigidConstraintData()
    datas.append(loop.createData())
    data = model.createData()
    settings = pin.ProximalSettings(1e-13, 1e-6, 100)
    if name == "lcaba":
        pin.computeJointMinimalOrdering(model, data, models)
    else:
        pin.initConstraintDynamics(model, data, models, datas)
    run, tau = getattr(pin, name), np.zeros(3)
    return lambda q, v: run(model, data, q, v, tau, models, datas, settings).copy()


def _linkage() -> pin.Model:
    model = pin.Model()
    model.gravity.linear = np.array([0.0, -G, 0.0])
    for name, parent, place, length in (("crank", 0, _at(0), A), ("coupler", 1, _at(A), B), ("rocker", 0, _at(D), C)):
        joint = model.addJoint(parent, pin.JointModelRZ(), place, name)
        turning = np.diag([1e-9, length**3 / 12, length**3 / 12])
        model.appendBodyToJoint(joint, pin.Inertia(length, np.array([length / 2, 0, 0]), turning), pin.SE3.Identity())
    return model


def _at(x: float) -> pin.SE3:
    return pin.SE3(np.eye(3), np.array([x, 0.0, 0.0]))


def _rk4(accelerate: Callable, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    h = STEP
    for _ in range(round(SPAN / h)):
        a1 = accelerate(q, v)
        a2 = accelerate(q + h / 2 * v, v + h / 2 * a1)
        a3 = accelerate(q + h / 2 * v + h**2 / 4 * a1, v + h / 2 * a2)
        a4 = accelerate(q + h * v + h**2 / 2 * a2, v + h * a3)
        q = q + h * v + h**2 / 6 * (a1 + a2 + a3)
        v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    return q, v


def _absolute(q: np.ndarray) -> np.ndarray:
    """Return directions of the bars from the angles of the joints."""
    return np.array([q[0], q[0] + q[1], q[2]])
