"""Runs the linkage in Exudyn: redundant coordinates, four joints, generalised alpha."""

from collections.abc import Iterator
from math import cos, sin
from time import perf_counter

import exudyn as exu
import numpy as np
from exudyn.itemInterface import (
    MarkerBodyPosition,
    NodeRigidBody2D,
    ObjectGround,
    ObjectJointRevolute2D,
    ObjectRigidBody2D,
)
from exudyn.utilities import LoadMassProportional, MarkerBodyMass
from four_bar import RATE, SPAN, A, B, C, D, G, Trial, start

STEP = 1e-3


def trials() -> Iterator[Trial]:
    """Three bodies in the plane with redundant coordinates, four joints, generalised alpha."""
    exu.SetWriteToConsole(False)
    container = exu.SystemContainer()
    system = container.AddSystem()
    q, v = start()
    ends = np.array([[0, 0], [A * cos(q[0]), A * sin(q[0])], [D, 0]])
    feet = np.array([[0, 0], [-A * sin(q[0]), A * cos(q[0])], [0, 0]]) * np.array([[0], [RATE], [0]])
    ground = system.AddObject(ObjectGround())
    bars, nodes = [], []
    for length, angle, rate, foot, moving in zip((A, B, C), q, v, ends, feet, strict=True):
        along, across = np.array([cos(angle), sin(angle)]), np.array([-sin(angle), cos(angle)])
        centre, velocity = foot + along * length / 2, moving + across * rate * length / 2
        node = system.AddNode(
            NodeRigidBody2D(referenceCoordinates=[*centre, angle], initialVelocities=[*velocity, rate])
        )
        nodes.append(node)
        bars.append(
            system.AddObject(ObjectRigidBody2D(physicsMass=length, physicsInertia=length**3 / 12, nodeNumber=node))
        )
        mass = system.AddMarker(MarkerBodyMass(bodyNumber=bars[-1]))
        system.AddLoad(LoadMassProportional(markerNumber=mass, loadVector=[0, -G, 0]))

    def marker(body: int, x: float) -> int:
        return system.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=[x, 0, 0]))

    pins = (((ground, 0), (bars[0], -A / 2)), ((bars[0], A / 2), (bars[1], -B / 2)),
            ((ground, D), (bars[2], -C / 2)), ((bars[1], B / 2), (bars[2], C / 2)))  # fmt: skip
    for one, other in pins:
        system.AddObject(ObjectJointRevolute2D(markerNumbers=[marker(*one), marker(*other)]))
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(SPAN / STEP)
    settings.timeIntegration.endTime = SPAN
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.timeIntegration.newton.useModifiedNewton = True
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.verboseMode = 0
    before = perf_counter()
    system.SolveDynamic(settings)
    seconds = perf_counter() - before
    found = [system.GetNodeOutput(node, exu.OutputVariableType.Coordinates) for node in nodes]
    rates = [system.GetNodeOutput(node, exu.OutputVariableType.Coordinates_t) for node in nodes]
    angles = np.array([one[2] for one in found]) + q
    yield Trial(f"generalised alpha, {STEP:g} s", angles, np.array([one[2] for one in rates]), seconds)
