"""Runs the linkage in MuJoCo: two hinged bars, a third one, and a soft `connect` between them."""

from collections.abc import Iterator
from time import perf_counter

import mujoco as mj
import numpy as np
from four_bar import SPAN, A, B, C, D, G, Trial, start

STEP = 1e-3


def trials() -> Iterator[Trial]:
    """Two hinged bars, a third one, and a soft `connect` between them, as stiff as by default and ten times stiffer."""
    (q1, q2, q3), v = start()
    bar = '<inertial pos="{1} 0 0" mass="{0}" diaginertia="1e-9 {2} {2}"/>'

    def body(length: float, inner: str, where: str, turn: float) -> str:
        shape = bar.format(length, length / 2, length**3 / 12)
        joint = '<joint type="hinge" axis="0 -1 0"/>'
        return f'<body pos="{where}" euler="0 {-turn} 0">{joint}{shape}{inner}</body>'

    coupler = body(B, f'<site name="end" pos="{B} 0 0"/>', f"{A} 0 0", q2 - q1)
    rocker = body(C, f'<site name="tip" pos="{C} 0 0"/>', f"{D} 0 0", q3)
    for integrator, stiff in (("RK4", 0.02), ("RK4", 0.002), ("implicitfast", 0.02)):
        model = mj.MjModel.from_xml_string(
            f'<mujoco><compiler angle="radian"/><option timestep="{STEP}" integrator="{integrator}" gravity="0 0 -{G}">'
            f'<flag contact="disable"/></option><worldbody>{body(A, coupler, "0 0 0", q1)}{rocker}</worldbody>'
            '<equality><connect site1="end" site2="tip" solref="' + f"{stiff}" + ' 1"/></equality></mujoco>'
        )
        data = mj.MjData(model)
        data.qvel[:] = v[0], v[1] - v[0], v[2]
        before = perf_counter()
        mj.mj_step(model, data, round(SPAN / STEP))
        seconds = perf_counter() - before
        q, v_end = np.array(data.qpos), np.array(data.qvel)
        q_all = np.array([q1 + q[0], q2 + q[0] + q[1], q3 + q[2]])
        yield Trial(
            f"{integrator}, {STEP:g} s, solref {stiff:g}",
            q_all,
            np.array([v_end[0], v_end[0] + v_end[1], v_end[2]]),
            seconds,
        )
