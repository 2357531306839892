"""Runs the linkage in Drake: three revolute joints and a ball constraint."""

from collections.abc import Iterator
from time import perf_counter

import numpy as np
from four_bar import SPAN, A, B, C, D, G, Trial, start
from pydrake.math import RigidTransform
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import FixedOffsetFrame, RevoluteJoint, SpatialInertia, UnitInertia
from pydrake.systems.analysis import Simulator

STEP = 1e-3


def trials() -> Iterator[Trial]:
    """Three revolute joints and a ball constraint: a discrete plant; a continuous one if it takes the constraint."""
    (q1, q2, q3), v = start()
    for step in (STEP, STEP / 10, 0.0):
        plant = MultibodyPlant(step)
        bars = []
        for name, length in (("crank", A), ("coupler", B), ("rocker", C)):
            inertia = UnitInertia.SolidCylinder(1e-3, length, [1, 0, 0]).ShiftFromCenterOfMass([-length / 2, 0, 0])
            bars.append(plant.AddRigidBody(name, SpatialInertia(length, [length / 2, 0, 0], inertia)))
        frames = (plant.world_frame(), bars[0].body_frame(), plant.world_frame())
        at = ([0, 0, 0], [A, 0, 0], [D, 0, 0])
        joints = []
        for name, frame, place, bar in zip("abc", frames, at, bars, strict=True):
            fixed = plant.AddFrame(FixedOffsetFrame(name, frame, RigidTransform(place)))
            joints.append(plant.AddJoint(RevoluteJoint(name, fixed, bar.body_frame(), [0, -1, 0])))
        plant.mutable_gravity_field().set_gravity_vector([0, 0, -G])
        try:
            plant.AddBallConstraint(bars[1], [B, 0, 0], bars[2], [C, 0, 0])
            plant.Finalize()
            simulator = Simulator(plant)
            context = simulator.get_mutable_context()
            for joint, angle, rate in zip(joints, (q1, q2 - q1, q3), (v[0], v[1] - v[0], v[2]), strict=True):
                joint.set_angle(context, angle)
                joint.set_angular_rate(context, rate)
            before = perf_counter()
            simulator.AdvanceTo(SPAN)
            seconds = perf_counter() - before
        except RuntimeError as error:
            print(f"  continuous plant: {str(error).split('. ')[1]}")
            continue
        q = np.array([joint.get_angle(context) for joint in joints])
        w = np.array([joint.get_angular_rate(context) for joint in joints])
        how = f"discrete, {step:g} s" if step else "continuous, its own steps"
        yield Trial(how, _absolute(q), _absolute(w), seconds)


def _absolute(q: np.ndarray) -> np.ndarray:
    """Return directions of the bars from the angles of the joints."""
    return np.array([q[0], q[0] + q[1], q[2]])
