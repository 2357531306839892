"""Environments of Gymnasium for a mechanism: `gym_env`."""

from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from ..arguments.named_values import Vector
from ..codegen.model import ModelError
from ..codegen.model.normalise import real, shown
from ..system.system import System
from .episodes import Reward, Start, actions_of, observations_of, rewards_of

if TYPE_CHECKING:
    from .environments import Environment, Environments

AUTORESET = ("next_step", "same_step", "disabled")
"""When an episode that is over is followed by another, as in Gymnasium's AutoresetMode."""


def gym_env(
    system: System,
    num_envs: int | None = None,
    *,
    actions: Mapping[Any, tuple[float, float]],
    period: float,
    reward: Reward | str,
    observations: Iterable[Any] | None = None,
    terminated: Callable[[Vector], Any] | None = None,
    start: Start | None = None,
    max_steps: int | None = None,
    autoreset: str = "next_step",
    **stepping: Any,
) -> "Environments | Environment":
    """Make K environments of a mechanism that step together, a `gymnasium.vector.VectorEnv` over `System.steppers`.

    An episode is terminated by a terminal event of the model, or by `terminated`; it is truncated after `max_steps`
    steps, and where the motion cannot continue for a numerical reason, which `info["failure"]` names.

    Parameters
    ----------
    num_envs
        K; None: one `gymnasium.Env`.
    actions
        Bounds (low, high) by name of an input: the inputs that are actions, constant during a step.
    period
        [s] the time of a step.
    reward
        A function of the observations (K, d) after a step and the actions (K, a), which returns (K,) rewards; or the
        name of an output.
    observations
        Names of coordinates, rates such as theta', states and outputs. Default: all but outputs.
    terminated
        A function of the observations (K, d) that returns (K,) booleans.
    start
        A function of the environment's random generator that returns numbers by name in {"x0": ..., "v0": ...,
        "parameters": ...}; what it leaves out is given by the options x0, v0 and parameters, and by the model.
    max_steps
        The number of steps after which an episode is truncated.
    autoreset
        "next_step", "same_step" or "disabled", as in Gymnasium's AutoresetMode.
    stepping
        Options of `System.steppers`: method, step, rtol, atol, workers and others; x0, v0, parameters, inputs and t
        are those of every start.

    Raises
    ------
    ModelError
        A name or an option is unknown, a number is not what it must be, or gymnasium is not installed.

    Examples
    --------
    >>> import numpy as np
    >>> import eigenmotion as em
    >>> from eigenmotion.models.furuta_pendulum import model
    >>> envs = em.gym_env(em.build(model, formulation="lagrange"), 2, actions={"u": (-0.1, 0.1)}, period=0.02,
    ...                   reward=lambda seen, actions: np.cos(seen[:, 1]), max_steps=100,
    ...                   start=lambda random: {"x0": {"phi": random.uniform(-0.1, 0.1)}})
    >>> envs.reset(seed=3)[0].shape
    (2, 4)
    """
    environments = _environments()
    episodes = environments.Episodes(
        actions_of(system, actions), observations_of(system, observations), rewards_of(system, reward), terminated,
        start, _period(period), _limit(max_steps),
    )  # fmt: skip
    if autoreset not in AUTORESET:
        raise ModelError(f"autoreset is {shown(autoreset)}, but must be one of {', '.join(AUTORESET)}")
    steppers = system.steppers(1 if num_envs is None else num_envs, **stepping)
    if num_envs is None:
        one: Environment = environments.Environment(environments.of(system, steppers, episodes, "disabled"))
        return one
    many: Environments = environments.of(system, steppers, episodes, autoreset)
    return many


def _environments() -> ModuleType:
    """Return the module that needs gymnasium.

    Raises
    ------
    ModelError
        It is not installed.
    """
    try:
        return import_module(f"{__package__}.environments")
    except ImportError as error:
        raise ModelError("gym_env needs gymnasium: pip install 'eigenmotion[gym]'") from error


def _period(period: float) -> float:
    seconds = real(period, "period")
    if not seconds > 0:
        raise ModelError(f"period is {seconds}, but must be above 0")
    return seconds


def _limit(max_steps: int | None) -> int:
    if max_steps is None:
        return 0
    if isinstance(max_steps, bool) or not isinstance(max_steps, int) or max_steps < 1:
        raise ModelError(f"max_steps is {shown(max_steps)}, but must be a whole number of at least 1")
    return max_steps
