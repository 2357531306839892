"""Calls that go straight to compiled code: which ones do, and that they give what the checked ones give, bit by bit."""

import numpy as np
import pytest
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.arguments import options
from eigenmotion.runtime import plain

from ..support.generation import system_for, system_of

NOT_PLAIN = {
    "a list": lambda x: x.tolist(),
    "float32": lambda x: x.astype(np.float32),
    "big-endian": lambda x: x.astype(">f8"),
    "integers": lambda x: x.astype(int),
    "complex": lambda x: x + 0j,
    "truth values": lambda x: x > 0,
    "objects": lambda x: x.astype(object),
    "strided": lambda x: np.repeat(x, 2)[::2],
    "too long": lambda x: np.append(x, 0.0),
    "a column": lambda x: x[:, None],
    "masked": np.ma.masked_array,
    "NaN": lambda x: np.where(x == x[0], np.nan, x),
    "infinite": lambda x: np.where(x == x[0], -np.inf, x),
    "nothing": lambda x: None,
}


@pytest.fixture
def system():
    return system_of("dual_link", "lagrange")


def asked(system, **changed):
    """What `plain.task` says of a run with one argument or the other changed."""
    x, v = system.initial
    given = {
        "t_span": (0.0, 1.0), "x0": x, "v0": v, "parameters": None, "rtol": 1e-6, "atol": 1e-9, "t_eval": None,
        "dense": False, "first_step": None, "max_step": np.inf, "max_steps": 1000, "stabilisation": "project",
        "stabilisations": {"project": True, "none": False}, "dependent": "refuse", "dependents": options.DEPENDENT,
    }  # fmt: skip
    return plain.task(options.Task, system.compiled, system.prepare(), system.bind(), *(given | changed).values())


def at(system, x, v, t=0.3, parameters=None, inputs=None):
    """What each function says of one place."""
    c, defaults = system.compiled, system.prepare()
    return (plain.mass_matrix(c, defaults, x, t, parameters), plain.energies(c, defaults, x, v, t, parameters),
            plain.acceleration(c, defaults, x, v, t, parameters, inputs, 0))  # fmt: skip


def test_ndarrays_are_plain_and_give_what_lists_give(system):
    x, v = system.initial
    M, e, (a, multipliers) = at(system, x, v)
    listed = system.acceleration(x.tolist(), v.tolist(), 0.3)
    assert (system.mass_matrix(x.tolist(), 0.3) == M).all()
    assert (listed[0] == a).all()
    assert (listed[1] == multipliers).all()
    assert system.energy(x.tolist(), v.tolist(), 0.3) == system.energy(x, v, 0.3) == sum(e)
    assert system.jacobi_integral(x.tolist(), v.tolist()) == system.jacobi_integral(x, v)


@pytest.mark.parametrize("formulation", ["lagrange", "eigenfactor"])
@pytest.mark.parametrize("t_eval", [None, [0.0, 0.01, 0.05]])
def test_a_plain_run_is_the_checked_one(formulation, t_eval):
    system, given = system_of("dual_link", formulation), {"rtol": 1e-8, "dense_output": True}
    x, v = system.initial
    times = None if t_eval is None else np.array(t_eval)
    assert asked(system, t_eval=times) is not None
    runs = [system.simulate((0, 0.05), x0=x, v0=v, t_eval=times, **given),
            system.simulate((0, 0.05), x0=x.tolist(), v0=v.tolist(), t_eval=t_eval, **given)]  # fmt: skip
    assert (runs[0].y == runs[1].y).all()
    assert (runs[0].t == runs[1].t).all()
    assert set(runs[0].keys()) == set(runs[1].keys())
    assert (runs[0].sol(0.02) == runs[1].sol(0.02)).all()
    for name in ("nfev", "nsteps", "status", "message", "stop"):
        assert runs[0][name] == runs[1][name]


@pytest.mark.parametrize("change", NOT_PLAIN.values(), ids=NOT_PLAIN)
def test_other_arrays_are_for_the_checks(system, change):
    x, v = system.initial
    assert all(one is None for one in at(system, change(x), v))
    assert at(system, x, change(v))[1:] == (None, None)
    assert change(x) is None or asked(system, x0=change(x)) is None
    assert change(v) is None or asked(system, v0=change(v)) is None
    assert change(v) is None or asked(system, t_eval=change(np.linspace(1.0, 0.1, 4))) is None


@pytest.mark.parametrize(
    "changed",
    [
        {"t_span": (0.0,)}, {"t_span": (0.0, np.inf)}, {"t_span": (True, 1.0)}, {"t_span": np.array([0.0, 1.0])},
        {"t_span": (0.0, 10**400)}, {"t_span": "01"}, {"x0": {}}, {"parameters": {}}, {"parameters": [1.0]},
        {"rtol": 1.0}, {"rtol": -1e-9}, {"rtol": np.nan}, {"rtol": "1e-6"}, {"rtol": True}, {"rtol": 0.0, "atol": 0.0},
        {"atol": -1.0}, {"atol": np.nan}, {"atol": {}}, {"atol": np.array([1e-9, 1e-9, -1e-9, 1e-9])},
        {"atol": np.full(3, 1e-9)}, {"dense": 1}, {"first_step": 0.0}, {"first_step": 2.0}, {"first_step": np.nan},
        {"max_step": 0.0}, {"max_step": np.nan}, {"max_steps": 0}, {"max_steps": 1.5}, {"max_steps": 10**16},
        {"max_steps": True}, {"stabilisation": "Project"}, {"stabilisation": ["none"]}, {"dependent": "none"},
        {"t_eval": np.array([0.0, 1.5])}, {"t_eval": np.array([-0.1, 0.5])}, {"t_eval": np.array([0.1, 0.1])},
        {"t_eval": np.array([0.2, 0.1])}, {"t_eval": np.array(0.5)}, {"t_eval": [0.5]},
        {"v0": np.array([1.0, 0.0, 0.0, 0.0])},
    ],
    ids=lambda changed: repr(changed)[:40],
)  # fmt: skip
def test_other_options_are_for_the_checks(system, changed):
    """The last: a velocity that the constraint forbids."""
    assert asked(system) is not None
    assert asked(system, **changed) is None


def test_parameters_of_another_model_are_for_the_checks(system):
    other = system_of("dual_link", "eigenfactor").prepare()
    assert asked(system, parameters=other) is None
    assert all(one is None for one in at(system, *system.initial, parameters=other))
    assert asked(system, parameters=system.prepare({"K1": 2.0})) is not None


def test_a_run_keeps_what_it_was_given(system):
    """Whoever changes an array afterwards changes no solution."""
    x, v = system.initial
    atol, times = np.full(4, 1e-9), np.array([0.0, 0.5, 1.0])
    task = asked(system, x0=x, v0=v, atol=atol, t_eval=times)
    before = [part.copy() for part in (task.y, task.atol, task.t_eval)]
    for array in (x, v, atol, times):
        array[:] = 7.0
    assert all((one == two).all() for one, two in zip(before, (task.y, task.atol, task.t_eval), strict=True))
    assert (asked(system, atol=1e-7).atol == 1e-7).all()
    assert (asked(system, atol=1e-9).atol == 1e-9).all()


def test_a_start_at_given_quasi_velocities_is_for_the_checks():
    """Their rates are found in Python; rates that are given are plain."""
    system = system_for(quasi(), "lagrange")
    assert asked(system, x0=None, v0=None) is None
    assert asked(system) is not None


def quasi() -> em.Model:
    q, w = dynamicsymbols("q w")
    return em.Model(
        name="with_quasi",
        coordinates=[q],
        kinetic_energy=w**2 / 2,
        quasi_velocities={w: 2 * q.diff()},
        initial={q: 0.1, w: 1.0},
    )
