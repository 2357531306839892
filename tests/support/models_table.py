"""The scenes of every test: one row a model, with its span and its oracle."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em

from ..oracles import Lagrange, State, elementary, elliptic, published, reduced, trajectory

MODELS = Path(__file__).parents[2] / "models"


@dataclass(frozen=True, slots=True)
class Scenario:
    """A model file, a span from t = 0 [s], and what is known about the motion.

    closed_form : (model, t) -> State, or None: the reference is a high-precision integration
    conserved : "energy", "jacobi_integral", or None where time enters or forces act
    spread : random states differ from the start by at most this, in every coordinate and rate
    heavy : what all models go through, this one goes through at night (`conftest.py`); by day `test_heavy_models.py`
    """

    file: str
    t_end: float
    closed_form: Callable[[em.Model, float], State] | None = None
    keywords: tuple[tuple[str, int], ...] = ()
    conserved: str | None = "energy"
    spread: float = 0.3
    heavy: bool = False

    @property
    def path(self) -> Path:
        return MODELS / f"{self.file}.py"

    @property
    def name(self) -> str:
        return "_".join([self.file, *(str(value) for _, value in self.keywords)])

    def model(self) -> em.Model:
        """Return the model, loaded once a process."""
        return _model(self)

    def lagrange(self) -> Lagrange:
        """Return Lagrange's equations of the model in double precision, formed once a process."""
        return _lagrange(self)

    def reference(self) -> State:
        """Return the state at t_end, good to about 1e-15 times the growth of perturbations; NaN where unknown."""
        return _reference(self)

    def random_states(self, count: int, seed: int = 0) -> list[State]:
        """Return states about the start; they need not satisfy constraints."""
        rng, model = np.random.default_rng(seed), self.model()
        x, v = np.array(model.initial_x), np.array(model.initial_v)
        return [
            State(
                x + rng.uniform(-self.spread, self.spread, x.shape), v + rng.uniform(-self.spread, self.spread, v.shape)
            )
            for _ in range(count)
        ]

    def random_parameters(self, seed: int = 0) -> dict[str, float]:
        """Return parameters within a quarter of their defaults."""
        rng = np.random.default_rng(seed)
        return {str(symbol): value * rng.uniform(0.8, 1.25) for symbol, value in self.model().parameters}


SCENARIOS = (
    Scenario("dual_link", 10.0, published.dual_link),
    Scenario("pendulum", 10.0, elliptic.pendulum),
    Scenario("double_pendulum", 4.0),
    Scenario("chain", 3.0, keywords=(("n", 5),)),
    Scenario("chaplygin_sleigh", 10.0, elementary.chaplygin_sleigh),
    Scenario("polar_particle", 5.0, elementary.kepler, spread=0.05),
    Scenario("spatial_arm", 3.0, keywords=(("n", 3),)),
    Scenario("elastic_pendulum", 5.0),
    Scenario("rotating_spring", 10.0, elementary.rotating_spring, conserved="jacobi_integral"),
    Scenario("rotating_hoop", 5.0, elliptic.rotating_hoop, conserved="jacobi_integral"),
    Scenario("rigid_body", 5.0, elliptic.rigid_body),
    Scenario("heavy_top", 2.0, elliptic.heavy_top),
    Scenario("quaternion_top", 1.0, elliptic.quaternion_top),
    Scenario("rolling_disk", 5.0, elementary.rolling_disk),
    Scenario("four_bar", 2.0, reduced.four_bar),
    Scenario("slider_crank", 2.0, reduced.slider_crank, spread=0.1),
    Scenario("driven_pendulum", 5.0, reduced.driven_pendulum, conserved=None),
    Scenario("veering", 22.0),
    Scenario("furuta_pendulum", 2.0, conserved=None),
    Scenario("sphere", 1.0, elementary.sphere),
    Scenario("andrews", 0.03, published.andrews, spread=0.1, heavy=True),
    Scenario("bicycle", 1.0, spread=0.1, heavy=True),
    Scenario("bricard", 1.0, spread=0.2, heavy=True),
    Scenario("cart_pendulums", 1.0, keywords=(("n", 3),), conserved=None, heavy=True),
    Scenario("drone", 2.0, conserved=None, heavy=True),
    Scenario("four_bars", 2.0, reduced.four_bars, keywords=(("n", 2),), spread=0.15, heavy=True),
    Scenario("governor", 0.02, conserved=None, spread=0.05, heavy=True),
    Scenario("jansen", 1.0, spread=0.1, heavy=True),
    Scenario("puma", 0.5, conserved=None, heavy=True),
    Scenario("snakeboard", 5.0, reduced.snakeboard, conserved=None, heavy=True),
)

ROBOTS = ("humanoid", "quadruped")
"""Large trees: what goes by all models has them at night, and so do their tests in `tests/bodies/test_robots.py`."""
HEAVY = frozenset({*ROBOTS, *(name for one in SCENARIOS if one.heavy for name in (one.file, one.name))})
ACTING = (
    "block_on_incline",
    "bouncing_ball",
    "clock",
    "compass_gait",
    "newtons_cradle",
    "pendulum_with_stop",
    "rimless_wheel",
)
"""Models whose events act: `contact/test_impacts.py` and `test_contacts.py` hold their runs against what is known."""

WITH_TESTS_OF_THEIR_OWN = (
    "cam_follower",
    "gripper",
    "lugre_oscillator",
    "quick_return_shaper",
    "robot_arm",
    "servo_pendulums",
    *ROBOTS,
)
"""Models with states or trees, or whose tables, contacts or bearings rub: `oracles.Lagrange` knows none of these. Each
has a file of its name in `tests/states/`, `tests/tables/` or `tests/bodies/`; robots share one."""

DAILY = {
    name: {"eigenfactor", ("cholesky", "lagrange", "inverse")[row % 3]}
    for row, names in enumerate(
        [*((one.file, one.name) for one in SCENARIOS), *((name,) for name in (*ACTING, *WITH_TESTS_OF_THEIR_OWN))]
    )
    for name in names
}
"""The formulations in which a model goes through its tests by day; in the others at night."""

BY_NAME = {scenario.name: scenario for scenario in SCENARIOS}
EVERY = pytest.mark.parametrize("scenario", SCENARIOS, ids=lambda scenario: scenario.name)


@cache
def _model(scenario: Scenario) -> em.Model:
    return em.load_model(scenario.path, **dict(scenario.keywords))


@cache
def _lagrange(scenario: Scenario) -> Lagrange:
    return Lagrange(_model(scenario))


@cache
def _reference(scenario: Scenario) -> State:
    oracle = scenario.closed_form or trajectory
    return oracle(_model(scenario), scenario.t_end)
