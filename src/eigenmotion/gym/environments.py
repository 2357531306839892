"""Environments of Gymnasium: many in one `VectorEnv`, or one `Env`. Needs gymnasium."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import gymnasium
import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.spaces import Box
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from ..arguments.named_values import Vector
from ..codegen.model import ModelError
from ..codegen.model.normalise import shown
from .episodes import PARTS, Actions, Observations, Reward, Start, Starts

if TYPE_CHECKING:
    from ..batch.stepper.steppers import Steppers
    from ..system.system import System

Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Episodes:
    """What all environments of one kind have in common; max_steps 0: episodes end by themselves only."""

    actions: Actions
    observations: Observations
    reward: Reward | str
    terminated: Callable[[Vector], Any] | None
    start: Start | None
    period: float
    max_steps: int


class Environments(VectorEnv[Vector, Vector, NDArray[Any]]):
    """K environments of one mechanism, which step together: `eigenmotion.gym_env` makes them.

    `reset(seed=None, options=None)` and `step(actions)` are those of `gymnasium.vector.VectorEnv`. Environment k draws
    its starts with a generator of its own, of the seed `seed + k`, or of the k-th of a list: what happens in it depends
    on no other. `options={"reset_mask": mask}` resets some.

    An environment whose motion cannot continue for a numerical reason is truncated in that step, and `info["failure"]`
    has the reason at its place, where `info["_failure"]` is true. Its observation is that of the last state it reached.

    Attributes
    ----------
    steppers : Steppers
        The mechanisms, with all that a batch of steppers has.
    num_envs, observation_space, action_space, single_observation_space, single_action_space, metadata
        As of any `VectorEnv`.

    Examples
    --------
    >>> import numpy as np
    >>> import eigenmotion as em
    >>> from eigenmotion.models.furuta_pendulum import model
    >>> envs = em.gym_env(em.build(model, formulation="lagrange"), 3, actions={"u": (-0.1, 0.1)}, period=0.02,
    ...                   reward=lambda seen, actions: np.cos(seen[:, 1]), max_steps=100)
    >>> seen, info = envs.reset(seed=1)
    >>> seen, rewards, terminated, truncated, info = envs.step(np.zeros((3, 1)))
    >>> seen.shape, rewards.shape, envs
    ((3, 4), (3,), <3 Environments of furuta_pendulum>)
    """

    def __init__(self, system: "System", steppers: "Steppers", episodes: Episodes, autoreset: AutoresetMode) -> None:
        """Make environments that are not reset yet."""
        count = len(steppers)
        actions, width = episodes.actions, len(episodes.observations.names)
        self.num_envs, self.steppers, self._of, self._mode = count, steppers, episodes, autoreset
        self.metadata = {"render_modes": [], "autoreset_mode": autoreset}
        self.single_observation_space = Box(-np.inf, np.inf, (width,), np.float64)
        self.single_action_space = Box(actions.low, actions.high, dtype=np.float64)
        self.observation_space = batch_space(self.single_observation_space, count)
        self.action_space = batch_space(self.single_action_space, count)
        self._starts = Starts(system, steppers, episodes.start)
        self._generators: list[np.random.Generator | None] = [None] * count
        self._rest = steppers.starts.inputs.copy()
        self._inputs = self._rest.copy()
        self._steps, self._done = np.zeros(count, dtype=np.int64), np.ones(count, dtype=bool)
        self._begun = False

    def __repr__(self) -> str:
        return f"<{self.num_envs} Environments of {self.steppers.model.name}>"

    # --- resetting ---

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Vector, dict[str, Any]]:
        """Start episodes; return observations (K, d) and an empty mapping.

        Parameters
        ----------
        seed
            A number s: environment k has the generator of s + k; or a seed for each. None: generators go on.
        options
            {"reset_mask": (K,) booleans}: only these environments are reset.

        Raises
        ------
        ModelError
            A start is inconsistent; the error names the environment. None was reset.
        """
        chosen = self._chosen(options)
        seeds = self._seeds(seed)
        for k in self._drawn(chosen):
            if seeds[k] is not None or self._generators[k] is None:
                self._generators[k] = seeding.np_random(seeds[k])[0]
        self._restart(chosen)
        self._begun = True
        return self._of.observations.of(self.steppers), {}

    def _chosen(self, options: dict[str, Any] | None) -> Flags:
        mask = (options or {}).get("reset_mask")
        if mask is None:
            return np.ones(self.num_envs, dtype=bool)
        if not isinstance(mask, np.ndarray) or mask.dtype != bool or mask.shape != (self.num_envs,):
            raise ModelError(f"options['reset_mask'] must be an array of {self.num_envs} booleans")
        return mask

    def _seeds(self, seed: int | Sequence[int | None] | None) -> list[int | None]:
        if seed is None or isinstance(seed, int | np.integer):
            return [None if seed is None else int(seed) + k for k in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ModelError(f"{len(seed)} seeds, but {self.num_envs} environments")
        return list(seed)

    def use_generator(self, k: int, generator: np.random.Generator) -> None:
        """Let environment k draw its starts with this generator."""
        self._generators[k] = generator

    def _drawn(self, chosen: Flags) -> list[int]:
        """Return those whose starts are drawn: all, or none if all start alike."""
        drawn: list[int] = [] if self._of.start is None else np.flatnonzero(chosen).tolist()
        return drawn

    def _restart(self, chosen: Flags) -> None:
        for k in self._drawn(chosen):
            generator = self._generators[k]
            if generator is None:
                raise ResetNeeded("these environments have not been reset")
            self._starts.draw(k, generator)
        x0, v0, parameters = (self._starts.columns[part] for part in PARTS)
        self.steppers.reset(chosen, x0=x0, v0=v0, parameters=parameters, inputs=self._rest)
        self._steps[chosen], self._done[chosen] = 0, False

    # --- stepping ---

    def step(self, actions: Vector) -> tuple[Vector, Vector, Flags, Flags, dict[str, Any]]:
        """Advance all environments by a period with actions (K, a).

        Returns observations (K, d), rewards (K,), and whether episodes are terminated or truncated, (K,) each. With
        autoreset in the next step, an environment whose episode is over begins another one in place of a step, and its
        action is ignored.

        Raises
        ------
        gymnasium.error.ResetNeeded
            There has been no reset, or none since an error in a step; or an episode is over, and there is no autoreset.
        ModelError
            An action is outside of its bounds, or not a number, and no environment has changed. Or the result of
            `reward` or `terminated` has the wrong shape: the step has been taken, as with any error of theirs, and all
            environments need a reset.
        """
        waiting = self._waiting()
        used = self._checked(actions, waiting)
        if waiting.any():
            self._restart(waiting)
        try:
            return self._advance(used, waiting)
        except BaseException:  # the motion has gone on, but nobody learns how: no episode can be continued
            self._begun, self._done[:] = False, True
            raise

    def _advance(self, actions: Vector, waiting: Flags) -> tuple[Vector, Vector, Flags, Flags, dict[str, Any]]:
        self._inputs[:, self._of.actions.columns] = actions
        self._steps[~waiting] += 1
        self.steppers.advance(self.steppers.starts.t + self._steps * self._of.period, self._inputs)
        seen = self._of.observations.of(self.steppers)
        terminated, truncated, info = self._ends(seen)
        rewards = np.where(waiting, 0.0, self._rewards(seen, actions))
        self._done = terminated | truncated
        if self._mode is AutoresetMode.SAME_STEP and self._done.any():
            seen, info = self._reset_now(seen, info)
        return seen, rewards, terminated, truncated, info

    def _waiting(self) -> Flags:
        """Return which environments begin an episode in place of a step."""
        if not self._begun:
            raise ResetNeeded("call reset() before step(): there was none yet, or none since an error in a step")
        waiting = self._done.copy()
        if self._mode is AutoresetMode.DISABLED and waiting.any():
            over = ", ".join(map(str, np.flatnonzero(waiting)[:10]))
            raise ResetNeeded(f"the episodes of these environments are over, and they were not reset: {over}")
        return waiting

    def _checked(self, actions: Vector, waiting: Flags) -> Vector:
        """Return the actions (K, a) in use: those of waiting environments are ignored, for their inputs at rest."""
        of, given = self._of.actions, np.asarray(actions, dtype=np.float64)
        if given.shape != (self.num_envs, len(of.names)):
            raise ModelError(f"actions have shape {given.shape}, but must be {(self.num_envs, len(of.names))}")
        if waiting.any():
            given = np.where(waiting[:, None], self._rest[:, of.columns], given)
        inside = (given >= of.low) & (given <= of.high) | waiting[:, None]
        if not inside.all():
            k, column = np.argwhere(~inside)[0].tolist()
            raise ModelError(
                f"the action {of.names[column]} of environment {k} is {given[k, column]}, but must be between "
                f"{of.low[column]} and {of.high[column]}: clip actions where they are chosen"
            )
        return given

    def _rewards(self, seen: Vector, actions: Vector) -> Vector:
        reward = self._of.reward
        if isinstance(reward, str):
            return self.steppers.outputs[reward]
        return self._one_each(np.asarray(reward(seen, actions), dtype=np.float64), "reward")

    def _one_each(self, result: NDArray[Any], name: str) -> NDArray[Any]:
        """Return what a function of the observations returned, if it has the shape (K,)."""
        if result.shape != (self.num_envs,):
            raise ModelError(
                f"{self.steppers.model.name}: the result of {name} has shape {result.shape}, but must have "
                f"({self.num_envs},): return one a row of the observations"
            )
        return result

    def _ends(self, seen: Vector) -> tuple[Flags, Flags, dict[str, Any]]:
        """Return which episodes are terminated or truncated, with the reasons of failures."""
        ended, failed = self.steppers.ended.astype(bool), np.zeros(self.num_envs, dtype=bool)
        if ended.any():
            failed[self.steppers.failed] = True
        terminated = ended & ~failed
        if self._of.terminated is not None:
            told = self._one_each(np.asarray(self._of.terminated(seen), dtype=bool), "terminated")
            terminated |= told & ~failed & (self._steps > 0)
        truncated = failed.copy()
        if self._of.max_steps:
            truncated |= (self._steps >= self._of.max_steps) & ~terminated
        return terminated, truncated, self._failures(failed)

    def _failures(self, failed: Flags) -> dict[str, Any]:
        if not failed.any():
            return {}
        words = np.full(self.num_envs, None, dtype=object)
        for k in np.flatnonzero(failed).tolist():
            words[k] = self.steppers.message(k)
        return {"failure": words, "_failure": failed}

    def _reset_now(self, seen: Vector, info: dict[str, Any]) -> tuple[Vector, dict[str, Any]]:
        done, final = self._done.copy(), np.full(self.num_envs, None, dtype=object)
        for k in np.flatnonzero(done).tolist():
            final[k] = seen[k]
        self._restart(done)
        told = {"final_obs": final, "_final_obs": done, "final_info": info, "_final_info": done.copy()}
        return self._of.observations.of(self.steppers), told


def of(system: "System", steppers: "Steppers", episodes: Episodes, autoreset: str) -> Environments:
    """Return environments with autoreset of a name."""
    return Environments(system, steppers, episodes, AutoresetMode[autoreset.upper()])


class Environment(gymnasium.Env[Vector, Vector]):
    """One environment of a mechanism: `eigenmotion.gym_env` without a number of environments makes it.

    Attributes
    ----------
    environments : Environments
        The batch of one that steps.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.furuta_pendulum import model
    >>> env = em.gym_env(em.build(model, formulation="lagrange"), actions={"u": (-0.1, 0.1)}, period=0.02,
    ...                  observations=["phi", "phi'"], reward=lambda seen, actions: -abs(seen[:, 0]))
    >>> seen, info = env.reset(seed=1)
    >>> env.step([0.05])[0].shape
    (2,)
    """

    def __init__(self, environments: Environments) -> None:
        """Make the environment of a batch of one without autoreset."""
        self.environments, self.metadata = environments, {"render_modes": []}
        self.observation_space = environments.single_observation_space
        self.action_space = environments.single_action_space

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Vector, dict[str, Any]]:
        """Start an episode; return an observation (d,) and an empty mapping."""
        super().reset(seed=seed)
        if options:
            raise ModelError(f"options are {shown(options)}: one environment has none to reset")
        self.environments.use_generator(0, self.np_random)
        return self.environments.reset()[0][0], {}

    def step(self, action: Vector) -> tuple[Vector, float, bool, bool, dict[str, Any]]:
        """Advance by a period with an action (a,); info["failure"] is why the motion cannot continue.

        Raises
        ------
        gymnasium.error.ResetNeeded
            The episode is over, or none has begun.
        ModelError
            The action is outside of its bounds, or not a number.
        """
        seen, rewards, terminated, truncated, info = self.environments.step(np.asarray(action)[None])
        told = {"failure": info["failure"][0]} if info else {}
        return seen[0], float(rewards[0]), bool(terminated[0]), bool(truncated[0]), told
