"""Symmetric machines on feet with frictions along lines: equal loads, dependent rows, forces that are not unique.

A basic solution of dependent frictions has them push against each other with forces at their limits. Under a symmetric
machine these limits are equal, and frictions that stick would be at theirs, too, at rest.
"""

from functools import cache

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Friction, Model, System, Tree, t

from ..support.generation import system_for

M, LEG, G, MU = 2.0, 0.1, 9.81, 0.5
WIDE, DEEP, HIGH = 0.5, 0.3, 0.1
CORNERS = ((1, 1), (1, -1), (-1, 1), (-1, -1))
PLACE = tuple(dynamicsymbols("x y z s_1 s_2 s_3"))
SCALES = [(1.0, 1.0), (1e-3, 1e-3), (1e-3, 1e3), (1e3, 1e-3), (1e3, 1e3)]
"""Of masses, of lengths; times are scaled by the root of the length."""


@cache
def machine(*, legs: bool) -> System:
    """A board, its center ahead by a l, on four feet, at the ends of sprung legs or without legs; pushed by X t."""
    m, leg, l, mu, k, d = symbols("m leg l mu k d", positive=True)
    a, X = symbols("a X", real=True)
    tree, contacts, forces = Tree(), {}, {PLACE[0]: X * t}
    inertia = tuple(m * l**2 * part for part in (0.1, 0.2, 0.25))
    board = tree.body("board", joint="free", mass=m, center=(a * l, 0, 0), inertia=inertia, coordinates=PLACE)
    for number, (ahead, aside) in enumerate(CORNERS):
        at = (ahead * WIDE * l, aside * DEEP * l, -HIGH * l)
        body = board
        if legs:
            body = tree.body(f"leg{number}", board, joint="prismatic", axis="z", at=at, mass=leg)
            q, at = body.coordinates[0], (0, 0, 0)
            forces[q] = -k * q - d * q.diff()
        contacts[f"foot{number}"] = Contact(body.position(at)[2])
        for letter, slip in zip("xy", body.velocity(at)[:2], strict=True):
            contacts[f"rub{number}{letter}"] = Friction(slip, limit=mu, normal=f"foot{number}")
    unused = {} if legs else {leg, k, d}
    values = {m: M, leg: LEG, l: 1.0, mu: MU, k: 400.0, d: 20.0, a: 0.0, X: 0.0}
    return system_for(
        Model(
            name="board_on_legs" if legs else "board_on_feet", coordinates=tree.coordinates, contacts=contacts,
            kinetic_energy=tree.kinetic_energy, potential_energy=tree.potential_energy, forces=forces,
            parameters={name: value for name, value in values.items() if name not in unused},
        ), "lagrange",
    )  # fmt: skip


def run_of(span: float, mass: float, length: float, *, legs: bool, drop: float = 0.0, a: float = 0.0, X: float = 0.0):
    """Run in units in which masses and lengths are so many times as large; span [s], X [N/s], drop [m] are scaled."""
    time = np.sqrt(length)
    scaled = {"m": M * mass, "l": length, "a": a, "X": X * mass / time}
    if legs:
        scaled |= {"leg": LEG * mass, "k": 400.0 * mass / length, "d": 20.0 * mass / time}
    atol = np.full(10 if legs else 6, 1e-11 * length)
    atol[3:6] = 1e-11  # of the attitude, which has no unit
    return machine(legs=legs).simulate(
        (0.0, span * time), x0={"z": (HIGH + drop) * length}, parameters=scaled, rtol=1e-9, atol=atol
    )


def loads(run, mass: float) -> tuple[np.ndarray, np.ndarray]:
    """Return what feet bear at the end (4,) and their frictions (4, 2), in units in which the board weighs M G."""
    forces = -run.multipliers[:, -1] / mass
    return forces[:4], forces[4:].reshape(4, 2)


@pytest.mark.parametrize(("mass", "length"), SCALES)
@pytest.mark.parametrize("legs", [False, True], ids=["feet", "legs"])
def test_what_starts_at_rest_on_its_feet_stands(legs, mass, length):
    run = run_of(5.0, mass, length, legs=legs)
    assert run.success, run.message
    normal, along = loads(run, mass)
    weight = (M + 4 * LEG * legs) * G
    assert normal.min() > -1e-9
    assert normal.sum() == pytest.approx(weight, rel=1e-7)
    assert np.array(CORNERS).T @ normal == pytest.approx([0.0, 0.0], abs=1e-7 * weight)
    assert along.sum(axis=0) == pytest.approx([0.0, 0.0], abs=1e-7 * weight)
    assert (np.abs(along) <= MU * normal[:, None] + 1e-9).all()
    assert run.x[:2, -1] / length == pytest.approx([0.0, 0.0], abs=1e-9)
    sag = M * G / 4 / 400.0 if legs else 0.0
    assert run.x[2, -1] / length == pytest.approx(HIGH - sag, abs=1e-8)
    assert len(run.modes) == 1 or not legs  # the loads of a board without legs are not unique: it rests on a diagonal


@pytest.mark.parametrize(("mass", "length"), SCALES)
@pytest.mark.parametrize("ahead", [0.05, 0.1, 0.3])
def test_a_board_begins_to_fall_onto_its_springs(ahead, mass, length):
    """At the start springs have no force: the board falls freely, and feet bear the legs."""
    span = 1e-4
    run = run_of(span, mass, length, legs=True, a=ahead)
    assert run.success, run.message
    forces = -run.multipliers[:, 0] / mass
    assert forces[:4] == pytest.approx([LEG * G] * 4, rel=1e-9)
    assert forces[4:].reshape(4, 2).sum(axis=0) == pytest.approx([0.0, 0.0], abs=1e-9)
    assert run.v[2, -1] / np.sqrt(length) == pytest.approx(-G * span, rel=3e-3)  # dampers take 2e-3 of it


@pytest.mark.parametrize("ahead", [0.05, 0.1, 0.3])
def test_feet_ahead_bear_more(ahead):
    """Forces and moments about the center balance: the legs' own weights are above their feet."""
    run = run_of(8.0, 1.0, 1.0, legs=True, a=ahead)
    assert run.success, run.message
    normal, along = loads(run, 1.0)
    weight = (M + 4 * LEG) * G
    assert normal.sum() == pytest.approx(weight, rel=1e-6)
    assert along.sum(axis=0) == pytest.approx([0.0, 0.0], abs=1e-6 * weight)
    assert (np.abs(along) <= MU * normal[:, None] + 1e-9).all()
    pitch = 4 * np.arctan(run.x[4, -1])
    turned = np.array([[np.cos(pitch), np.sin(pitch)], [-np.sin(pitch), np.cos(pitch)]])  # of x and z
    feet = turned @ [[WIDE * corner[0] for corner in CORNERS], run.x[6:, -1] - HIGH]
    arms = feet[0] - ahead * np.cos(pitch)
    assert feet[1] == pytest.approx([-run.x[2, -1]] * 4, abs=1e-7)
    assert (normal - LEG * G) @ arms == pytest.approx(0.0, abs=1e-6 * weight)
    assert (normal - LEG * G) @ [corner[1] for corner in CORNERS] == pytest.approx(0.0, abs=1e-6 * weight)


@pytest.mark.parametrize(("mass", "length"), SCALES)
@pytest.mark.parametrize("push", [3.0, -5.0])
def test_a_board_slides_when_the_push_is_the_sum_of_the_limits(push, mass, length):
    run = run_of(5.0, mass, length, legs=False, X=push)
    begins = MU * M * G / abs(push)
    assert run.success, run.message
    assert run.modes[-1][0] / np.sqrt(length) == pytest.approx(begins, rel=1e-9)
    assert run.x[0, -1] / length == pytest.approx(push / M / 6 * (5.0 - begins) ** 3, rel=1e-7)
    assert np.abs(run.x[1, -1]) / length < 1e-8


@pytest.mark.parametrize("drop", [1e-3, 1e-6])
def test_standing_is_the_limit_of_dropping(drop):
    dropped, stood = run_of(8.0, 1.0, 1.0, legs=True, drop=drop), run_of(8.0, 1.0, 1.0, legs=True)
    assert dropped.success, dropped.message
    assert dropped.x[2, -1] == pytest.approx(stood.x[2, -1], abs=1e-8)
    assert loads(dropped, 1.0)[0] == pytest.approx(loads(stood, 1.0)[0], rel=1e-6)
