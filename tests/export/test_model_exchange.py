"""Model exchange: events, constraints and rotations of motions that a solver of fmpy integrates."""

import re

import numpy as np
import pytest
from sympy import Piecewise, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, t

from ..support.fmu_slaves import Slave, exchanged, fmi3, fmpy
from ..support.generation import MODELS, system_for, system_of
from .test_fmu_contacts import hopper

validation = pytest.importorskip("fmpy.validation")
pytestmark = pytest.mark.usefixtures("hurried")

x, z, q = dynamicsymbols("x z q")
g, e, k = symbols("g e k", positive=True)


def room(**more) -> Model:
    """A ball on a spring bounces on a floor and between walls, and is thrown up again at x = 0; q is a filter of x."""
    events = {
        "floor": Event(z, direction=-1, impact=(z, e)),
        "wall": Event(x - 1, impact=(x - 1, 1)),
        "other wall": Event(x + 1, direction=-1, impact=(x + 1, e)),
        "kick": Event(x, direction=1, reset={z.diff(): z.diff() + 1}),
        "high": Event(z.diff(), direction=-1),
    }
    return Model(
        name="room",
        coordinates=[x, z],
        states={q: x - q},
        kinetic_energy=(x.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=g * z + k * x**4 / 4,
        parameters={g: 9.81, e: 0.8, k: 2.0},
        initial={z: 1.0, x.diff(): 2.0},
        **{"events": events} | more,
    )


def unit_of(model, folder, **options):
    path = em.export_fmu(model, folder / "unit.fmu", **{"formulation": "lagrange"} | options)
    assert validation.validate_fmu(str(path)) == []
    return path


@pytest.mark.parametrize("fmi", [2, 3])
def test_impacts_and_resets_are_applied_at_their_times(tmp_path, fmi):
    """Found by a solver of another kind, from the event indicators: the motion after 10 of them is that of our run."""
    path = unit_of(room(), tmp_path, fmi=fmi)
    assert fmpy.read_model_description(str(path)).numberOfEventIndicators == 5
    rows = exchanged(path, 2.9, record_events=False)
    run = system_for(room(), "lagrange").simulate((0, 2.9), rtol=1e-11, atol=1e-13, t_eval=rows["time"])
    assert [len(one) for one in run.t_events[:4]] == [6, 2, 1, 1]
    found = np.array([rows[name] for name in ("x", "z", "der(x)", "der(z)", "q")])
    near = np.abs(rows["time"][:, None] - np.concatenate(run.t_events)).min(axis=1) < 1e-6
    assert not near.any()
    assert np.abs(found - np.vstack([run.x[:2], run.v, run.states["q"]])).max() < 1e-6


def test_directional_derivatives_of_event_indicators(tmp_path):
    """Of z, x - 1, and the rate of z."""
    unit = Slave(unit_of(room(), tmp_path, fmi=3), tmp_path / "a").begin()
    rows = [unit.places[f"indicator({name})"] for name in ("floor", "wall", "high")]
    columns = [unit.places[name] for name in ("x", "z", "der(z)", "g")]
    found = [unit.slave.getDirectionalDerivative(rows, [one], [2.0]) for one in columns]
    assert found == [[0.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 0.0, 0.0]]


def test_bounces_without_end_are_named(tmp_path):
    """A ball at e = 1/2 comes to rest after 3 sqrt(2 / g) = 1.3546 s; a solver would let it sink through the floor."""
    ball = Model(name="ball", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
                 parameters={g: 9.81, e: 0.5}, events={"floor": Event(z, direction=-1, impact=(z, e))},
                 initial={z: 1.0})  # fmt: skip
    said, path = [], unit_of(ball, tmp_path, fmi=3)
    assert exchanged(path, 1.3, record_events=False)["z"].min() > -1e-9
    with pytest.raises(Exception, match="fmi3UpdateDiscreteStates failed"):
        exchanged(path, 3.0, record_events=False, logger=lambda *told: said.append(told[-1].decode()))
    assert re.fullmatch(r"at t = 1\.(35\d*|36): events pile up.*", said[-1])


def test_constraints_do_not_drift(tmp_path):
    """A four-bar for 20 s: its loop stays closed to the tolerance of the unit, whatever the solver."""
    path = unit_of(MODELS / "four_bar.py", tmp_path, rtol=1e-8, atol=1e-10)
    rows = fmpy.simulate_fmu(str(path), stop_time=20.0, output_interval=0.01, relative_tolerance=1e-6,
                             fmi_type="ModelExchange", record_events=False)  # fmt: skip
    system = system_of("four_bar", "lagrange")
    names = system.coordinates
    state = np.array([rows[name] for name in (*names, *(f"der({name})" for name in names))])
    closed = [
        np.abs(system.compiled.position(0.0, one[: len(names)], system.prepare(None))[0]).max() for one in state.T
    ]
    assert max(closed) < 1e-8


def test_rotations_turn_on(tmp_path):
    """A top's parameters are replaced by their shadow set, as events: s would be infinite after a turn."""
    tree = em.Tree()
    tree.body("top", joint="spherical", mass=1.0, inertia=(0.3, 0.2, 0.1))
    s = tree.coordinates
    turning = Model(name="turning", coordinates=s, kinetic_energy=tree.kinetic_energy, initial={s[0].diff(): 0.5})
    rows = exchanged(unit_of(turning, tmp_path, fmi=3, formulation="articulated_body"), 5.0, record_events=False)
    found = np.array([rows[str(name).removesuffix("(t)")] for name in s])
    assert found[1:] == pytest.approx(0.0, abs=1e-9)
    assert 4 * np.arctan(found[0]) % (2 * np.pi) == pytest.approx(2 * rows["time"] % (2 * np.pi), abs=1e-6)


def test_what_has_a_mode_is_for_co_simulation_and_says_why(tmp_path):
    """Contacts, frictions, conditions on time: asked for model exchange, the unit names what has a mode."""
    timed = room(events={}, forces={x: Piecewise((1, t < 1), (0, True))})
    for model, words in ((hopper(), "the contact 'floor' has a mode"), (timed, "changes at certain times")):
        path = unit_of(model, tmp_path, fmi=3)
        assert fmpy.read_model_description(str(path)).modelExchange is None
        slave = Slave(path, tmp_path / model.name)
        with pytest.raises(Exception, match="Failed to instantiate"):
            exchanging(slave).instantiate(logMessage=slave.log)
        assert words in slave.said[-1]


def exchanging(slave):
    """The same unit, opened for model exchange."""
    of = slave.description
    return fmi3.FMU3Model(guid=of.guid, unzipDirectory=str(slave.folder), instanceName="one",
                          modelIdentifier=of.coSimulation.modelIdentifier)  # fmt: skip
