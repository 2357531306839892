"""Friction in proportion to the multipliers of constraints: guides, pins, bearings. Against fsolve and closed forms."""

from functools import cache

import numpy as np
import pytest
import sympy
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Friction, Model, System, multiplier

from ..oracles.bearings import Bearings, Rubs
from ..support.generation import FORMULATIONS, system_for

G = 9.81
TIGHT = {"rtol": 1e-10, "atol": 1e-12}
SIZES = {"a": 0.2, "l": 0.5, "I": 0.01, "m2": 0.6, "I2": 0.02, "m3": 1.1, "drive": 3.0, "drag": 0.05}
RUBS = {"mu_guide": 0.25, "mu_pin": 0.04, "mu_end": 0.05}


def slider_crank(x, v, p):
    """Crank phi, rod (X, Y, psi), slider (s, w): masses, forces, rows by name, slips with what presses."""
    phi, X, Y, psi, s, w = x
    masses = [p["I"], p["m2"], p["m2"], p["I2"], p["m3"], p["m3"]]
    forces = [p["drive"] - p["drag"] * v[0], 0, -G * p["m2"], 0, 0, -G * p["m3"]]
    end = p["l"] / 2
    rows = {
        "pin": [X - end * cos(psi) - p["a"] * cos(phi), Y - end * sin(psi) - p["a"] * sin(phi)],
        "end": [X + end * cos(psi) - s, Y + end * sin(psi) - w],
        "guide": w,
    }
    slips = {"guide": v[4], "pin": v[3] - v[0], "end": v[3]}
    return masses, forces, rows, slips


def shaper(x, v, p):
    """Crank phi, block (X, Y) on the lever theta about the origin, ram (s, w) that the lever moves by its slot."""
    phi, X, Y, theta, s, w = x
    high = 0.6
    masses = [p["I"], p["m2"], p["m2"], p["I2"], p["m3"], p["m3"]]
    forces = [p["drive"] - p["drag"] * v[0], 0, -G * p["m2"], 0, -2 * v[4], -G * p["m3"]]
    rows = {
        "pin": [X - p["a"] * cos(phi), Y - 0.35 - p["a"] * sin(phi)],
        "slot": X * cos(theta) - Y * sin(theta),
        "ram": s * cos(theta) - (w + high) * sin(theta),
        "guide": w,
    }
    along = v[1] * sin(theta) + v[2] * cos(theta)
    slips = {"guide": v[4], "pin": v[3] + v[0], "slot": along}
    return masses, forces, rows, slips


MECHANISMS = {
    "slider_crank": (slider_crank, ("guide", "pin", "end"), 0.9),
    "shaper": (shaper, ("guide", "pin", "slot"), 0.4),
}


@cache
def model_of(name: str) -> Model:
    stated, rubbing, _ = MECHANISMS[name]
    x = dynamicsymbols("phi X Y psi s w")
    v = [q.diff() for q in x]
    p = {key: symbols(key, positive=True) for key in SIZES}
    masses, forces, rows, slips = stated(x, v, p)
    mus = [symbols(key, positive=True) for key in RUBS]
    contacts = {f"rub_{row}": Friction(slips[row], limit=mu, normal=row) for row, mu in zip(rubbing, mus, strict=True)}
    return Model(
        name=name, coordinates=x,
        kinetic_energy=sum(mass * w**2 for mass, w in zip(masses, v, strict=True)) / 2,
        forces=forces, holonomic_constraints=rows, contacts=contacts,
        outputs={"reaction": sympy.sqrt(multiplier("pin", 0) ** 2 + multiplier("pin", 1) ** 2)},
        parameters={p[key]: value for key, value in SIZES.items()} | dict(zip(mus, RUBS.values(), strict=True)),
        initial=dict(zip(x, start_of(name)[0], strict=True)))  # fmt: skip


def start_of(name: str) -> tuple[np.ndarray, np.ndarray]:
    """A place on the constraints, and rates there with the crank at 6 rad/s."""
    x, _, rows = rows_of(name)
    phi = MECHANISMS[name][2]
    if name == "slider_crank":
        psi = -np.arcsin(0.2 * np.sin(phi) / 0.5)
        place = [phi, 0.2 * np.cos(phi) + 0.25 * np.cos(psi), 0.2 * np.sin(phi) + 0.25 * np.sin(psi), psi,
                 0.2 * np.cos(phi) + 0.5 * np.cos(psi), 0.0]  # fmt: skip
    else:
        X, Y = 0.2 * np.cos(phi), 0.35 + 0.2 * np.sin(phi)
        theta = np.arctan2(X, Y)
        place = [phi, X, Y, theta, 0.6 * np.tan(theta), 0.0]
    A = np.array([[float(row.diff(q).subs(dict(zip(x, place, strict=True)))) for q in x] for row in rows])
    null = np.linalg.svd(A)[2][-1]
    return np.array(place), 6.0 * null / null[0]


def rows_of(name: str):
    x, v = symbols("phi X Y psi s w"), symbols("v0:6")
    rows = MECHANISMS[name][0](x, v, SIZES)[2]
    return x, v, [row for entry in rows.values() for row in (entry if isinstance(entry, list) else [entry])]


@cache
def oracle_of(name: str) -> Bearings:
    stated, rubbing, _ = MECHANISMS[name]
    x, v, flat = rows_of(name)
    masses, forces, rows, slips = stated(x, v, SIZES)
    first, places = 0, {}
    for key, entry in rows.items():
        count = len(entry) if isinstance(entry, list) else 1
        places[key] = tuple(range(first, first + count))
        first += count
    rubs = [Rubs(value, slips[row], places[row]) for row, value in zip(rubbing, RUBS.values(), strict=True)]
    return Bearings(x, v, masses, [sympy.sympify(force) for force in forces], flat, rubs)


@cache
def truth_of(name: str) -> tuple[np.ndarray, np.ndarray]:
    times = np.linspace(0.0, 1.5, 7)
    return times, oracle_of(name).motion(np.concatenate(start_of(name)), times)


@cache
def system(name: str, formulation: str) -> System:
    return system_for(model_of(name), formulation)


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", MECHANISMS)
def test_accelerations_and_reactions_against_fsolve(name, formulation):
    """Sliding in either direction; and the pin's reaction as an output."""
    place, rates = start_of(name)
    for turns in (1.0, -1.0):
        y = np.concatenate([place, turns * rates])
        signs = np.sign(oracle_of(name).slips(0.0, y))
        a, reactions = oracle_of(name).solved(0.0, y, signs)
        mode = {f"rub_{row}_slides": sign for row, sign in zip(MECHANISMS[name][1], signs, strict=True)}
        found, multipliers = system(name, formulation).acceleration(place, turns * rates, parameters=mode)
        assert found == pytest.approx(a, rel=1e-9, abs=1e-9)
        assert multipliers[: len(reactions)] == pytest.approx(reactions, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("formulation", "method"), [*((f, "dop853") for f in FORMULATIONS), ("lagrange", "ra15"),
                                                     ("cholesky", "radau9"), ("eigenfactor", "ra15")])  # fmt: skip
@pytest.mark.parametrize("name", MECHANISMS)
def test_motion_against_fsolve(name, formulation, method):
    """Through reversals of slip."""
    times, truth = truth_of(name)
    place, rates = start_of(name)
    run = system(name, formulation).simulate((0.0, 1.5), x0=place, v0=rates, method=method, t_eval=times, **TIGHT)
    assert run.success, run.message
    assert sum(map(len, run.t_events)) >= 3
    assert run.x == pytest.approx(truth[:6], abs=2e-8)
    assert run.outputs["reaction"] == pytest.approx(np.hypot(*run.multipliers[:2]))


@pytest.mark.parametrize("name", MECHANISMS)
def test_slopes_where_norms_of_multipliers_push(name):
    """Of accelerations by x and v, against differences; and of the published right-hand side as it runs."""
    place, rates = start_of(name)
    z, made = np.concatenate([place, rates]), system(name, "lagrange")
    signs = np.sign(oracle_of(name).slips(0.0, z))
    mode = {f"rub_{row}_slides": sign for row, sign in zip(MECHANISMS[name][1], signs, strict=True)}
    J, h = made.compiled.motion_jacobian(0.0, z, made.prepare(mode), [], False), 1e-5
    for k, column in enumerate(J[6:].T):
        beside = (z + sign * h * (np.arange(12) == k) for sign in (1, -1))
        there, back = (made.acceleration(one[:6], one[6:], parameters=mode)[0] for one in beside)
        assert column == pytest.approx((there - back) / (2 * h), rel=1e-6, abs=1e-5)
    eta = system(name, "eigenfactor")
    y = eta.state(place, rates)
    along = np.random.default_rng(1).normal(size=len(y))
    apart = eta.rhs(0.0, y + h * along, mode) - eta.rhs(0.0, y - h * along, mode)
    assert eta.jacobian(0.0, y, mode) @ along == pytest.approx(apart / (2 * h), rel=1e-6, abs=1e-5)


def test_friction_takes_what_the_drive_gives_and_the_energy_lacks():
    """The work lost is the integral of mu |lambda| |slip| over all that rubs, as the oracle has it."""
    times, truth = truth_of("slider_crank")
    place, rates = start_of("slider_crank")
    run = system("slider_crank", "cholesky").simulate((0.0, 1.5), x0=place, v0=rates, t_eval=times, **TIGHT)
    fine = np.linspace(0.0, 1.5, 20001)
    turned = system("slider_crank", "cholesky").simulate((0.0, 1.5), x0=place, v0=rates, t_eval=fine, **TIGHT).v[0]
    driven = np.trapezoid(3.0 * turned - 0.05 * turned**2, fine)
    lifted = G * (0.6 * (run.x[2, -1] - run.x[2, 0]))
    kinetic = run.energy[-1] - run.energy[0]
    assert driven - kinetic - lifted == pytest.approx(truth[12, -1], rel=1e-6)


def test_sensitivities_through_reversals_of_slip():
    name, made = "slider_crank", system("slider_crank", "lagrange")
    place, rates = start_of(name)
    given = {"x0": place, "v0": rates, "rtol": 1e-10, "atol": 1e-12}
    run = made.simulate((0.0, 0.8), sensitivities=["mu_guide", "mu_pin"], **given)
    assert sum(map(len, run.t_events)) >= 2
    for key in ("mu_guide", "mu_pin"):
        h, at = 1e-5, RUBS[key]
        beside = [made.simulate((0.0, 0.8), parameters={key: at + d}, **given).x[:, -1] for d in (h, -h)]
        assert run.sensitivity[key].dx[:, -1] == pytest.approx((beside[0] - beside[1]) / (2 * h), rel=1e-4, abs=1e-6)
