"""Identifiable combinations, and their values from forces with noise."""

import numpy as np
import pytest
import sympy
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import model_of, system_for
from .mechanisms import REACH, crank_four_bar, crank_motion, two_links

TIMES = np.linspace(0.0, 6.0, 120)


def waves(n, times=TIMES, seed=1):
    """x, v, a (n, k) of n coordinates that move as Fourier series."""
    random = np.random.default_rng(seed)
    x, v, a = (np.zeros((n, len(times))) for _ in range(3))
    for w in (1.0, 2.3, 3.7, 5.1):
        s, c = random.normal(0, 0.5, (2, n, 1))
        x += s * np.sin(w * times) + c * np.cos(w * times)
        v += w * (s * np.cos(w * times) - c * np.sin(w * times))
        a -= w**2 * (s * np.sin(w * times) + c * np.cos(w * times))
    return x, v, a


def four_bar_names(system):
    return [name for name in system.parameters if name != "g"]


def test_two_links_have_their_textbook_base_parameters():
    """J_1 + l^2 m_2, mx_1 + l m_2, my_1, J_2, mx_2, my_2, whichever of each stands for it; no force depends on m_1."""
    system = system_for(two_links(), "articulated_body")
    found = em.identifiable(system, system.parameters, waves(2))
    textbook = np.zeros((6, 8))
    names = list(found.parameters)
    for row, terms in enumerate(({"J_1": 1, "m_2": REACH**2}, {"mx_1": 1, "m_2": REACH}, {"my_1": 1}, {"J_2": 1},
                                 {"mx_2": 1}, {"my_2": 1})):  # fmt: skip
        for name, factor in terms.items():
            textbook[row, names.index(name)] = factor
    assert found.rank == 6
    assert found.unseen == ("m_1",)
    assert len(found.dependent) == 1
    columns = [names.index(name) for name in found.base]
    assert found.combinations == pytest.approx(np.linalg.solve(textbook[:, columns], textbook), abs=1e-9)
    assert found.condition < 100
    assert any(f"{found.dependent[0]}" in text for text in found.texts)
    assert "no force depends on m_1" in str(found)


def test_poses_at_rest_tell_first_moments_alone():
    system = system_for(two_links(), "articulated_body")
    x = waves(2)[0]
    found = em.identifiable(system, system.parameters, (x, 0 * x, 0 * x))
    assert found.rank == 4
    assert set(found.unseen) == {"m_1", "J_1", "J_2"}


def test_the_rank_of_a_four_bar_is_that_of_its_power():
    """The crank's torque is the power of inertia and gravity over its speed: columns by differences of the energies."""
    system = system_for(crank_four_bar())
    names, motion = four_bar_names(system), crank_motion(TIMES)
    found = em.identifiable(system, names, motion)
    columns = []
    for name in names:
        forces = [system.inverse_dynamics(*motion, actuators=["q_1"], parameters={name: system.parameters[name] + step})
                  .forces[0] for step in (1.0, 0.0)]  # fmt: skip
        columns.append(forces[0] - forces[1])
    W = np.array(columns).T
    scaled = W / np.maximum(np.linalg.norm(W, axis=0), 1e-300)
    sizes = np.linalg.svd(scaled, compute_uv=False)
    assert found.rank == (sizes > 1e-8 * sizes[0]).sum()
    chosen = [names.index(name) for name in found.base]
    assert np.abs(W[:, chosen] @ found.combinations - W).max() < 1e-7 * np.abs(W).max()
    assert set(found.unseen) == {"m_1", "m_3"}


def test_confidence_intervals_hold_what_they_should():
    """Torques of a crank with 1 % noise: 95 of 100 intervals hold, within a binomial band."""
    system, motion = system_for(crank_four_bar()), crank_motion(TIMES)
    names = four_bar_names(system)
    exact = system.inverse_dynamics(*motion, actuators=["q_1"]).forces
    noise, truth = 0.01 * np.sqrt((exact**2).mean()), np.array([system.parameters[name] for name in names])
    held, sizes = [], []
    for seed in range(100):
        measured = exact + np.random.default_rng(seed).normal(0, noise, exact.shape)
        fit = em.fit_forces(system, names, motion, measured, actuators=["q_1"])
        right = fit.identifiable.combinations @ truth
        held.append((fit.intervals[:, 0] < right) & (right < fit.intervals[:, 1]))
        sizes.append(fit.noise)
    counts = np.array(held).sum(axis=0)
    assert counts.min() >= 88
    assert counts.max() <= 100
    assert 91 <= counts.mean() <= 99
    assert np.mean(sizes) == pytest.approx(noise, rel=0.03)


def test_exact_torques_give_exact_parameters():
    """Dependent ones keep their values, and base ones make up for them."""
    system, motion = system_for(two_links(), "articulated_body"), waves(2)
    truth = {"m_1": 4.0, "mx_1": 1.1, "my_1": 0.1, "J_1": 0.7, "m_2": 1.5, "mx_2": 0.3, "my_2": 0.1, "J_2": 0.2}
    forces = system.inverse_dynamics(*motion, parameters=truth).forces
    fit = em.fit_forces(system, truth, motion, dict(zip(system.coordinates, forces, strict=True)))
    assert fit.estimates == pytest.approx(fit.identifiable.combinations @ np.array(list(truth.values())), abs=1e-12)
    assert set(fit.kept) == {"m_1", *fit.identifiable.dependent}
    assert all(fit.parameters[name] == system.parameters[name] for name in fit.kept)
    assert "kept as given: " in str(fit)
    again = system.inverse_dynamics(*motion, parameters=fit.parameters).forces
    assert again == pytest.approx(forces, abs=1e-12 * np.abs(forces).max())
    known = em.fit_forces(system, truth, motion, forces, values=truth)
    assert known.parameters == pytest.approx(truth, abs=1e-10)


def test_a_motor_constant_is_identified_with_its_current():
    """An input that is an actuator multiplies a parameter; the second joint is at a measured torque."""
    system, motion = system_for(two_links(actuated=True), "articulated_body"), waves(2)
    truth = {"J_1": 0.8, "mx_1": 1.0, "J_2": 0.3, "constant": 2.0}
    forces = system.inverse_dynamics(*motion, actuators=["current", "q_2"], parameters=truth).forces
    fit = em.fit_forces(system, truth, motion, forces, actuators=["current", "q_2"])
    assert {name: fit.parameters[name] for name in truth} == pytest.approx(truth, abs=1e-10)


def test_a_run_is_a_motion():
    """Of a free motion: the forces are those of dampers and gravity alone."""
    system = system_for(two_links(), "articulated_body")
    run = system.simulate((0, 3), x0=[0.3, 0.5], t_eval=np.linspace(0, 3, 50))
    found = em.identifiable(system, system.parameters, run)
    a = run.trajectory.accelerations.T
    for motion in ((run.x, run.v, a, run.t), [run.x, run.v, a], np.array([run.x, run.v, a])):
        assert found.base == em.identifiable(system, system.parameters, motion).base
    fit = em.fit_forces(system, ["J_1", "mx_1"], run, np.zeros((2, 50)))
    assert fit.parameters == pytest.approx({"J_1": 0.5, "mx_1": 0.9}, abs=1e-9)


def test_motions_that_no_actuator_drives_have_no_noise():
    """A pole on a cart: the pole's row is exact; intervals of the damper of the cart hold, and so do others."""
    x, q = dynamicsymbols("x q")
    M, m, h, J, d = sympy.symbols("M m h J d")
    T = (M + m) * x.diff() ** 2 / 2 + h * sympy.cos(q) * x.diff() * q.diff() + J * q.diff() ** 2 / 2
    V, values = 9.81 * h * sympy.cos(q), {M: 2.0, m: 0.5, h: 0.3, J: 0.2, d: 0.7}
    model = em.Model(name="pole_on_cart", coordinates=[x, q], kinetic_energy=T, potential_energy=V,
                     forces={x: -d * x.diff()}, parameters=values)  # fmt: skip
    system, force = system_for(model), dynamicsymbols("u")
    driven = em.Model(name="driven_pole", coordinates=[x, q], kinetic_energy=T, potential_energy=V,
                      forces={x: force - d * x.diff()}, parameters=values, inputs={force: 0.0})  # fmt: skip
    times = np.linspace(0, 4, 80)
    u = em.Signal(times, 3 * np.sin(2 * times) + 2 * np.sin(5.3 * times))
    run = system_for(driven).simulate((0, 4), x0={"q": 2.8}, inputs={"u": u}, t_eval=times, rtol=1e-10)
    motion = run.x, run.v, run.trajectory.accelerations.T
    exact, names = run.trajectory.u.T, ["M", "h", "d"]
    held = []
    for seed in range(60):
        measured = exact + np.random.default_rng(seed).normal(0, 0.05, exact.shape)
        fit = em.fit_forces(system, names, motion, measured, actuators=["x"], weights=[2.0])
        right = fit.identifiable.combinations @ [2.0, 0.3, 0.7]
        held.append((fit.intervals[:, 0] <= right + 1e-9) & (right - 1e-9 <= fit.intervals[:, 1]))
        assert fit.noise == pytest.approx(0.05 * np.sqrt(2), rel=0.4)
        assert fit.parameters["h"] == pytest.approx(0.3, rel=1e-2)
    assert np.array(held).sum(axis=0).min() >= 50


@pytest.mark.parametrize(("change", "words"), [
    ({"motion": 3}, "motion is 3. Give a Solution"),
    ({"forces": np.zeros((2, 3))}, r"Give \(2, 120\): q_1, q_2"),
    ({"forces": np.full((2, 120), np.nan)}, "not finite"),
    ({"forces": {"q_1": np.zeros(120)}}, "unknown actuator 'q_2'"),
    ({"weights": [1.0, 0.0]}, "weights are positive"),
    ({"actuators": ["q_3"], "forces": np.zeros((1, 120))}, "unknown actuator 'q_3'"),
    ({"level": 95}, "between 0 and 1"),
    ({"parameters": ["m_1"]}, "no force along this motion depends on m_1"),
])  # fmt: skip
def test_mistakes_are_named(change, words):
    given = {"parameters": ["J_1", "mx_1"], "motion": waves(2), "forces": np.ones((2, 120))} | change
    with pytest.raises(em.ModelError, match=words):
        em.fit_forces(system_for(two_links(), "articulated_body"), **given)


def test_too_few_forces_are_refused():
    system = system_for(two_links(), "articulated_body")
    with pytest.raises(em.ModelError, match="do not tell the errors of 2 base parameters"):
        em.fit_forces(system, ["J_1", "J_2"], ([0.1, 0.2], [1.0, 2.0], [3.0, -1.0]), [1.0, 2.0])


def test_runs_of_other_models_are_refused():
    run = system_for(model_of("pendulum")).simulate((0, 1))
    with pytest.raises(em.ModelError, match="the run is one of pendulum"):
        em.identifiable(system_for(two_links(), "articulated_body"), ["J_1"], run)


def test_units_of_parameters_do_not_matter():
    """Two forces of equal size, one of a parameter of 1e13, are both told."""
    x = dynamicsymbols("x")
    stiffness, damping = sympy.symbols("stiffness damping")
    model = em.Model(
        name="units",
        coordinates=[x],
        kinetic_energy=x.diff() ** 2 / 2,
        forces={x: -stiffness * x / sympy.Integer(10) ** 13 - damping * x.diff()},
        parameters={stiffness: 1e13, damping: 1.0},
    )
    system, names = em.build(model, formulation="lagrange"), ["stiffness", "damping"]
    motion = tuple(np.random.default_rng(0).normal(size=(3, 1, 20)))
    forces = system.inverse_dynamics(*motion, parameters={"stiffness": 3e13, "damping": 2.0}).forces
    fit = em.fit_forces(system, names, motion, forces)
    assert np.abs(np.array([fit.parameters[name] for name in names]) / [3e13, 2.0] - 1.0).max() < 1e-9
    for wrong in (0.0, 2.0, -1.0, float("nan")):
        with pytest.raises(em.ModelError, match="tolerance"):
            em.identifiable(system, names, motion, tolerance=wrong)
