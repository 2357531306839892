"""Massless bodies that constraints hold, in random units, against the same mechanisms without their coordinates."""

from functools import cache

import numpy as np
import pytest
from sympy import cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System

from ..support.generation import FORMULATIONS, system_for

X, Y, Z, RHO, A, B = dynamicsymbols("x y z rho a b")
m, g, k, L, e = symbols("m g k L e", positive=True)
PLACES = {"planar": [X, Y], "spatial": [X, Y, Z]}
HELD = {"planar": [RHO * cos(A), RHO * sin(A)],
        "spatial": [RHO * cos(A) * cos(B), RHO * sin(A) * cos(B), RHO * sin(B)]}  # fmt: skip
TOLERANCE = 1e-10


@cache
def systems(name: str, formulation: str) -> tuple[System, System]:
    """A mass on a telescope without mass, with a spring and a weight in it: by length and angles, and without them."""
    place, held = PLACES[name], HELD[name]
    angles = [RHO, A, B][: len(place)]
    parameters = {m: 1.0, g: 9.81, k: 40.0, L: 1.0, e: 0.3}
    energy = m * sum(q.diff() ** 2 for q in place) / 2
    whole = Model(
        name=f"telescope_{name}", coordinates=[*place, *angles], kinetic_energy=energy,
        potential_energy=k * (RHO - L) ** 2 / 2 + e * m * g * RHO * sin(A), parameters=parameters,
        holonomic_constraints=[q - p for q, p in zip(place, held, strict=True)], initial={X: 1.0, RHO: 1.0},
    )  # fmt: skip
    length = sqrt(sum(q**2 for q in place))
    height = Y / length if name == "planar" else Y / sqrt(X**2 + Y**2)
    alone = Model(name=f"mass_{name}", coordinates=place, kinetic_energy=energy, parameters=parameters, initial={X: 1},
                  potential_energy=k * (length - L) ** 2 / 2 + e * m * g * length * height)  # fmt: skip
    return system_for(whole, formulation), system_for(alone, "lagrange")


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", list(PLACES))
def test_a_massless_telescope_moves_its_mass_as_if_it_were_not_there(name, formulation, seed):
    random = np.random.default_rng(seed)
    length, mass, time = 10.0 ** random.uniform(-6, 6, 3)
    (whole, alone), n = systems(name, formulation), len(PLACES[name])
    p = {"m": mass, "g": 9.81 * length / time**2, "k": random.uniform(10, 60) * mass / time**2, "L": length,
         "e": random.uniform(0, 0.5)}  # fmt: skip
    rho, a, b = random.uniform(0.7, 1.3), *random.uniform(-1, 1, 2)
    angles = np.array([rho * length, a, b])[:n]
    direction = np.array([np.cos(a), np.sin(a)] if n == 2 else
                         [np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)])  # fmt: skip
    x = np.concatenate([rho * length * direction, angles])
    v = np.concatenate([random.uniform(-1, 1, n) * length / time, np.zeros(n)])
    rows = whole.pfaffian(x, parameters=p)[0]
    v[n:] = np.linalg.solve(rows[:, n:], -rows[:, :n] @ v[:n])
    at = [0.5 * time, time]
    for method in ("dop853", "ra15", "radau9"):
        options = {"t_eval": at, "rtol": TOLERANCE, "parameters": p, "method": method, "atol": 1e-30}
        found = whole.simulate((0, time), x0=x, v0=v, **options)
        right = alone.simulate((0, time), x0=x[:n], v0=v[:n], **options | {"method": "dop853"})
        assert found.success, f"{method}: {found.message}"
        np.testing.assert_allclose(found.x[:n] / length, right.x / length, atol=1e-7)
        np.testing.assert_allclose(found.v[:n] / length * time, right.v / length * time, atol=1e-6)
        assert found.nsteps < 4 * right.nsteps + 20
