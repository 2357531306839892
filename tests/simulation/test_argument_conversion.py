"""Arguments read directly, and arguments converted first: both give the same bits and the same errors."""

import numpy as np
import pytest
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for, system_of

CONVERTED = {
    "a list": lambda x: x.tolist(),
    "float32": lambda x: x.astype(np.float32),
    "big-endian": lambda x: x.astype(">f8"),
    "integers": lambda x: x.astype(int),
    "objects": lambda x: x.astype(object),
    "strided": lambda x: np.repeat(x, 2)[::2],
}
REFUSED = {
    "complex": lambda x: x + 0j,
    "truth values": lambda x: x > 0,
    "too long": lambda x: np.append(x, 0.0),
    "a column": lambda x: x[:, None],
    "masked": np.ma.masked_array,
    "NaN": lambda x: np.where(x == x[0], np.nan, x),
    "infinite": lambda x: np.where(x == x[0], -np.inf, x),
}


@pytest.fixture
def system():
    return system_of("dual_link", "lagrange")


def at(system, x, v, **more):
    """What each function says of one state, as one array."""
    a, multipliers = system.acceleration(x, v, 0.3, **more)
    energies = [system.energy(x, v, 0.3, **more), system.jacobi_integral(x, v, 0.3, **more)]
    return np.concatenate([system.mass_matrix(x, 0.3, **more).ravel(), energies, a, multipliers])


@pytest.mark.parametrize("change", CONVERTED.values(), ids=CONVERTED)
def test_converted_arrays_give_the_same_bits(system, change):
    x, v = system.initial
    q, w = (np.array([float(value) for value in change(given)]) for given in (x, v))
    assert (at(system, change(x), v) == at(system, q, v)).all()
    assert (at(system, x, change(v)) == at(system, x, w)).all()


def test_names_give_the_same_bits(system):
    x, v = system.initial
    q, w = (dict(zip(system.coordinates, given.tolist(), strict=True)) for given in (x, v))
    assert (at(system, q, w) == at(system, x, v)).all()


@pytest.mark.parametrize("change", REFUSED.values(), ids=REFUSED)
def test_other_arrays_are_refused(system, change):
    x, v = system.initial
    for call in (system.mass_matrix, system.energy, system.acceleration):
        more = () if call == system.mass_matrix else (v,)
        with pytest.raises(em.ModelError):
            call(change(x), *more)
    for call in (system.energy, system.acceleration):
        with pytest.raises(em.ModelError):
            call(x, change(v))
    for given in ({"x0": change(x)}, {"v0": change(v)}, {"t_eval": change(np.array([0.1, 0.2]))}):
        if "t_eval" not in given or not np.array_equal(given["t_eval"], [0.1, 0.2, 0.0]):
            with pytest.raises(em.ModelError):
                system.simulate((0.0, 1.0), **given)


def rows(system, **given):
    """Rows and counts of a run, of which some options are given."""
    x, v = system.initial
    usual = {"t_span": (0.0, 0.05), "x0": x, "v0": v, "rtol": 1e-8, "atol": 1e-9, "dense_output": True}
    solution = system.simulate(**(usual | given))
    return solution.y, solution.t, solution.sol(0.02), (solution.nfev, solution.nsteps, solution.message)


@pytest.mark.parametrize("formulation", ["lagrange", "eigenfactor"])
@pytest.mark.parametrize(
    ("given", "same"),
    [
        ({"t_span": [0, 0.05]}, {}),
        ({"t_span": np.array([0.0, 0.05])}, {}),
        ({"x0": None, "v0": None}, {}),
        ({"x0": {}, "v0": {}}, {}),
        ({"parameters": {}}, {}),
        ({"rtol": np.float32(0.5) ** 20}, {"rtol": 0.5**20}),
        ({"atol": {}}, {}),
        ({"atol": [1e-9] * 4}, {}),
        ({"atol": np.full(4, 1e-7)}, {"atol": 1e-7}),
        ({"max_steps": 1e3}, {"max_steps": 1000}),
        ({"max_step": 1}, {"max_step": 1.0}),
        ({"first_step": np.array(0.0078125)}, {"first_step": 0.0078125}),
        ({"dense_output": 1}, {}),
        ({"stabilisation": "Project"}, {}),
        ({"t_eval": [0.0, 0.01, 0.05]}, {"t_eval": np.array([0.0, 0.01, 0.05])}),
        ({"t_eval": range(1)}, {"t_eval": np.array([0.0])}),
    ],
    ids=lambda given: repr(given)[:40],
)
def test_converted_options_give_the_same_bits(formulation, given, same):
    system = system_of("dual_link", formulation)
    for one, other in zip(rows(system, **given), rows(system, **same), strict=True):
        assert np.array_equal(one, other)


@pytest.mark.parametrize(
    "given",
    [
        {"t_span": (0.0,)}, {"t_span": (0.0, np.inf)}, {"t_span": (True, 1.0)}, {"t_span": (0.0, 10**400)},
        {"t_span": "01"}, {"rtol": 1.0}, {"rtol": -1e-9}, {"rtol": np.nan}, {"rtol": "1e-6"},
        {"rtol": True}, {"rtol": 0.0, "atol": 0.0}, {"atol": -1.0}, {"atol": np.nan},
        {"atol": np.array([1e-9, 1e-9, -1e-9, 1e-9])}, {"atol": np.full(3, 1e-9)},
        {"atol": np.array([1e-9, np.nan, 1e-9, 1e-9])}, {"dense_output": 2}, {"first_step": 0.0}, {"first_step": 2.0},
        {"first_step": np.nan}, {"max_step": 0.0}, {"max_step": np.nan}, {"max_steps": 0}, {"max_steps": 1.5},
        {"max_steps": 10**16}, {"max_steps": np.inf}, {"max_steps": True}, {"stabilisation": "projects"},
        {"stabilisation": ["none"]}, {"dependent_constraints": "none"}, {"t_eval": np.array([0.0, 1.5])},
        {"t_eval": np.array([-0.1, 0.5])}, {"t_eval": np.array([0.1, 0.1])}, {"t_eval": np.array([0.2, 0.1])},
        {"t_eval": np.array(0.5)}, {"t_eval": np.array([0.1, np.nan])}, {"v0": np.array([1.0, 0.0, 0.0, 0.0])},
    ],
    ids=lambda given: repr(given)[:40],
)  # fmt: skip
def test_other_options_are_refused(system, given):
    """The last: a velocity that the constraint forbids."""
    x, v = system.initial
    with pytest.raises(em.ModelError, match=next(iter(given)) if "v0" not in given else "v0 does not satisfy"):
        system.simulate(**({"t_span": (0.0, 1.0), "x0": x, "v0": v} | given))


def test_rows_of_a_run_backwards_decrease(system):
    x, v = system.initial
    assert (system.simulate((0.1, 0.0), x0=x, v0=v, t_eval=np.array([0.1, 0.05])).t == [0.1, 0.05]).all()
    with pytest.raises(em.ModelError, match="must decrease strictly"):
        system.simulate((0.1, 0.0), x0=x, v0=v, t_eval=np.array([0.05, 0.1]))


def test_prepared_parameters_are_of_one_system(system):
    x, v = system.initial
    named = {"parameters": {"K1": 2.0}}
    assert (at(system, x, v, **named) == at(system, x, v, parameters=system.prepare({"K1": 2.0}))).all()
    other = system_of("dual_link", "eigenfactor").prepare()
    for call in (system.mass_matrix, system.energy, system.acceleration):
        with pytest.raises(em.ModelError, match="another compiled model"):
            call(*(x,) if call == system.mass_matrix else (x, v), parameters=other)


def test_a_run_keeps_what_it_was_given(system):
    """Whoever changes an array afterwards changes no solution."""
    x, v = system.initial
    x, v, times, atol = x.copy(), v.copy(), np.array([0.0, 0.02, 0.05]), np.full(4, 1e-9)
    solution = system.simulate((0.0, 0.05), x0=x, v0=v, t_eval=times, atol=atol)
    assert (solution.t == [0.0, 0.02, 0.05]).all()
    for array in (x, v, times, atol):
        array[:] = 7.0
    same = system.simulate((0.0, 0.05), t_eval=[0.0, 0.02, 0.05], atol=1e-9)
    for name in ("t", "y", "x", "v"):
        assert (getattr(solution, name) == getattr(same, name)).all()
    assert (solution.energy == same.energy).all()


def test_a_start_is_a_copy(system):
    """A start that is the model's own, or the user's, does not change with what `start` returned."""
    x, v = (given.copy() for given in system.initial)
    for given in (system.start(), system.start(x, v)):
        for array in given:
            array[:] = 7.0
    assert all((one == two).all() for one, two in zip(system.start(), (x, v), strict=True))
    assert all((one == two).all() for one, two in zip(system.initial, (x, v), strict=True))


def test_inputs_in_order_are_those_by_name():
    (F,) = dynamicsymbols("F_pull,")
    q = dynamicsymbols("q_driven")
    model = em.Model(name="driven", coordinates=[q], kinetic_energy=q.diff() ** 2, forces={q: F}, inputs={F: 0})
    system = system_for(model, "lagrange")
    x = np.zeros(1)
    for given in ({"F_pull": 3.0}, np.array([3.0]), [3]):
        assert system.acceleration(x, x, inputs=given)[0][0] == pytest.approx(1.5, rel=1e-15)  # 2 q'' = F


def test_quasi_velocities_of_the_model_apply_at_any_position():
    """2 q' = w = 1, wherever q is; rates that are given come first."""
    system = system_for(quasi(), "lagrange")
    assert system.energy(np.array([0.7]), None) == 0.5
    assert system.energy(np.array([0.7]), np.array([0.25])) == 0.125
    assert system.simulate((0.0, 1.0), x0=np.array([0.7])).v[0, 0] == 0.5
    assert system.simulate((0.0, 1.0)).v[0, 0] == 0.5


def quasi() -> em.Model:
    q, w = dynamicsymbols("q w")
    return em.Model(
        name="with_quasi",
        coordinates=[q],
        kinetic_energy=w**2 / 2,
        quasi_velocities={w: 2 * q.diff()},
        initial={q: 0.1, w: 1.0},
    )
