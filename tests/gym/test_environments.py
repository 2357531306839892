"""Environments of Gymnasium: what its checker says, episodes against steppers, seeds, ends and failures."""

import warnings

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, ModelError

from ..support.generation import system_for

gymnasium = pytest.importorskip("gymnasium")

from gymnasium.utils.env_checker import check_env  # noqa: E402
from gymnasium.vector import AutoresetMode, VectorEnv  # noqa: E402

x, theta, u = dynamicsymbols("x theta u")
M, m, l, g = symbols("M m l g", positive=True)


def cart_pole(**more) -> Model:
    """A pole on a cart, pushed by u; it has fallen at 0.5 rad."""
    swing = x.diff() ** 2 + 2 * l * cos(theta) * x.diff() * theta.diff() + (l * theta.diff()) ** 2
    return Model(
        name="cart_pole",
        coordinates=[x, theta],
        kinetic_energy=M * x.diff() ** 2 / 2 + m * swing / 2,
        potential_energy=m * g * l * cos(theta),
        parameters={M: 1.0, m: 0.1, l: 0.5, g: 9.81},
        **{
            "forces": {x: u},
            "inputs": {u: 0.0},
            "outputs": {"height": l * cos(theta), "push": u},
            "events": {"fall": Event(theta**2 - 0.25, terminal=True)},
        }
        | more,
    )


def start(random):
    return {"x0": {"theta": random.uniform(-0.1, 0.1)}, "v0": {x: random.uniform(-1.0, 1.0)},
            "parameters": {"m": random.uniform(0.05, 0.2)}}  # fmt: skip


def alive(seen, actions):
    return 1.0 - 0.1 * actions[:, 0] ** 2 - seen[:, 0] ** 2


def envs_of(count=None, model=None, **options):
    system = system_for(model or cart_pole(), "lagrange")
    given = {"actions": {"u": (-10.0, 10.0)}, "period": 0.02, "reward": alive, "start": start, "max_steps": 40}
    return em.gym_env(system, count, **given | options)


def test_gymnasiums_checker_passes_it():
    """Its only remark is that coordinates have no bounds."""
    with warnings.catch_warnings(record=True) as remarks:
        warnings.simplefilter("always")
        check_env(envs_of(actions={"u": (-1.0, 1.0)}), skip_render_check=True)
    assert [str(one.message) for one in remarks if "infinity" not in str(one.message)] == []


def test_an_episode_is_that_of_a_single_stepper():
    """Bit for bit, with the actions of a random agent; the reward is that of the state after each step."""
    envs = envs_of(5)
    assert isinstance(envs, VectorEnv)
    seen, info = envs.reset(seed=3)
    assert info == {}
    first, drawn = seen.copy(), envs.steppers.t.copy()
    assert drawn.tolist() == [0.0] * 5
    envs.action_space.seed(1)
    actions = [envs.action_space.sample() for _ in range(10)]
    told = [envs.step(one) for one in actions]
    for k in range(5):
        begun = start(gymnasium.utils.seeding.np_random(3 + k)[0])
        stepper = system_for(cart_pole(), "lagrange").stepper(**begun)
        assert [*stepper.x, *stepper.v] == first[k].tolist()
        for step, (action, (seen, rewards, terminated, truncated, _)) in enumerate(zip(actions, told, strict=True)):
            stepper.advance((step + 1) * 0.02, {"u": action[k, 0]})
            assert [*stepper.x, *stepper.v] == seen[k].tolist()
            assert rewards[k] == 1.0 - 0.1 * action[k, 0] ** 2 - stepper.x[0] ** 2
            assert not terminated[k] | truncated[k]


def played(envs, seed, steps=120):
    """All that a random agent is told."""
    rows = [(envs.reset(seed=seed)[0],)]
    envs.action_space.seed(7)
    return [*rows, *(envs.step(envs.action_space.sample())[:4] for _ in range(steps))]


def test_the_same_seed_is_the_same_motion_and_others_are_others():
    envs = envs_of(4)
    first, again, other = played(envs, 5), played(envs, 5), played(envs, 6)
    for one, two in zip(first, again, strict=True):
        assert all(np.array_equal(a, b) for a, b in zip(one, two, strict=True))
    assert sum(row[2].sum() + row[3].sum() for row in first[1:]) > 6
    assert not np.array_equal(first[0][0], other[0][0])
    assert np.array_equal(first[0][0][1:], other[0][0][:3])  # seeds 6, 7 and 8
    assert len({*map(tuple, first[0][0].tolist())}) == 4


def test_an_environment_depends_on_no_other():
    """Environment 2 of four and of three, with the same actions, though others fall at other times."""
    push = np.random.default_rng(2).uniform(-10, 10, (100, 1))

    def told(count):
        envs = envs_of(count)
        envs.reset(seed=11)
        filled = [
            np.vstack([np.full((2, 1), 3.0 * (count == 4)), one, *np.full((count - 3, 1, 1), -2.0)]) for one in push
        ]
        return [[part[2].tolist() for part in envs.step(one)[:4]] for one in filled]

    assert told(3) == told(4)


def test_ends_and_the_next_step():
    """A pole that is pushed falls by the model's event; the step after that begins the next episode."""
    envs = envs_of(2, start=lambda random: {"x0": {"theta": random.uniform(0.2, 0.3)}})
    assert envs.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
    envs.reset(seed=1)
    push = np.array([[-8.0], [8.0]])
    count = 0
    while True:
        seen, rewards, terminated, truncated, info = envs.step(push)
        count += 1
        if terminated.any():
            break
    assert terminated.tolist() == [True, False]
    assert not truncated.any()
    assert info == {}
    assert seen[0, 1] == pytest.approx(0.5, abs=1e-9)
    last = seen.copy()
    seen, rewards, terminated, truncated, info = envs.step(push)
    assert 0.2 < seen[0, 1] < 0.3
    assert seen[0, 2:].tolist() == [0.0, 0.0]
    assert rewards[0] == 0.0
    assert not terminated[0]
    assert seen[1, 0] != last[1, 0]
    assert envs.steppers.t == pytest.approx([0.0, 0.02 * (count + 1)])


def test_truncation_after_the_most_steps_and_resets_in_the_same_step():
    envs = envs_of(2, max_steps=3, autoreset="same_step")
    envs.reset(seed=1)
    for _ in range(2):
        seen, _, terminated, truncated, info = envs.step(np.zeros((2, 1)))
        assert not truncated.any()
        assert info == {}
    seen, _, terminated, truncated, info = envs.step(np.zeros((2, 1)))
    assert truncated.all()
    assert not terminated.any()
    assert envs.steppers.t.tolist() == [0.0, 0.0]
    assert info["_final_obs"].all()
    assert np.abs(info["final_obs"][0] - seen[0]).max() > 1e-3


def test_without_autoreset_an_episode_that_is_over_takes_no_step():
    envs = envs_of(3, max_steps=2, autoreset="disabled")
    with pytest.raises(gymnasium.error.ResetNeeded, match=r"reset\(\) before"):
        envs.step(np.zeros((3, 1)))
    envs.reset(seed=1)
    for _ in range(2):
        envs.step(np.zeros((3, 1)))
    with pytest.raises(gymnasium.error.ResetNeeded, match="0, 1, 2"):
        envs.step(np.zeros((3, 1)))
    envs.reset(options={"reset_mask": np.array([True, False, True])})
    with pytest.raises(gymnasium.error.ResetNeeded, match=r"over, and they were not reset: 1$"):
        envs.step(np.zeros((3, 1)))


def runaway() -> Model:
    """A mass whose force grows beyond all bounds in finite time if it starts to the right."""
    return Model(
        name="runaway", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: 6 * x**3 + u}, inputs={u: 0.0}
    )


@pytest.mark.parametrize("autoreset", ["next_step", "same_step"])
def test_a_motion_that_cannot_continue_is_named(autoreset):
    """Truncated in its step, with the reason at its place; the other environment is not affected."""
    envs = envs_of(2, runaway(), start=lambda random: {"x0": {"x": float(random.random() > 0.5)}}, max_steps=200,
                   reward=lambda seen, actions: seen[:, 0], autoreset=autoreset)  # fmt: skip
    seen, _ = envs.reset(seed=[3, 4])
    assert sorted(seen[:, 0]) == [0.0, 1.0]
    k = int(np.argmax(seen[:, 0]))
    for _ in range(200):
        seen, _, terminated, truncated, info = envs.step(np.zeros((2, 1)))
        if truncated.any():
            break
    told = info["final_info"] if autoreset == "same_step" else info
    assert truncated.tolist() == [k == 0, k == 1] == told["_failure"].tolist()
    assert not terminated.any()
    assert f"runaway: member {k} at t = 0.7569228" in told["failure"][k]
    assert told["failure"][1 - k] is None
    last = info["final_obs"][k] if autoreset == "same_step" else seen[k]
    assert np.isfinite(last).all()
    assert last[0] > 100.0


def test_observations_and_rewards_by_name():
    envs = envs_of(3, observations=["theta'", "height", "x", "push"], reward="height")
    envs.reset(seed=1)
    seen, rewards, *_ = envs.step(np.full((3, 1), 2.0))
    steppers = envs.steppers
    expected = [steppers.v[:, 1], steppers.outputs["height"], steppers.x[:, 0], [2.0] * 3]
    assert np.array_equal(seen, np.column_stack(expected))
    assert np.array_equal(rewards, seen[:, 1])
    envs = envs_of(3, cart_pole(events={}), terminated=lambda seen: seen[:, 0] > -100.0)
    assert envs.reset(seed=1)[0].shape == (3, 4)
    assert envs.step(np.zeros((3, 1)))[2].all()


def test_what_a_start_leaves_out_is_the_models_again():
    """Environments that have had other episodes start as new ones do: a start depends on its seed alone."""

    def some(random):
        """One of the parts, or none."""
        part = random.integers(4)
        parts = [("x0", "theta"), ("v0", "x"), ("parameters", "m")][part : part + 1]
        return {name: {number: random.uniform(0.1, 0.2)} for name, number in parts}

    def begun(envs, seed):
        seen = envs.reset(seed=seed)[0].tolist()
        return [seen, *(envs.step(np.full((3, 1), 2.0))[0].tolist() for _ in range(3))]

    old = envs_of(3, start=some)
    told = [begun(old, seed) for seed in range(12)]
    assert told == [begun(envs_of(3, start=some), seed) for seed in range(12)]
    firsts = {tuple(episode[0][0]) for episode in told}
    assert (0.0, 0.0, 0.0, 0.0) in firsts
    assert len(firsts) > 4


@pytest.mark.parametrize("autoreset", ["next_step", "same_step", "disabled"])
def test_a_refused_action_changes_nothing(autoreset):
    """What follows is bit for bit what follows without it, also where episodes were to begin in that step."""
    calm, tried = (envs_of(3, max_steps=4, autoreset=autoreset) for _ in range(2))
    assert np.array_equal(calm.reset(seed=1)[0], tried.reset(seed=1)[0])
    for _ in range(4 if autoreset == "disabled" else 11):
        if not tried._done.all():
            for wrong in (np.full((3, 1), np.nan), np.full((3, 1), 11.0)):
                with pytest.raises(ModelError, match="u of environment 0"):
                    tried.step(wrong)
        with pytest.raises(ModelError, match=r"\(2, 1\)"):
            tried.step(np.zeros((2, 1)))
        one, two = (envs.step(np.full((3, 1), 2.0)) for envs in (calm, tried))
        assert all(np.array_equal(a, b) for a, b in zip(one[:4], two[:4], strict=True))
        assert tried.steppers.t.tolist() == calm.steppers.t.tolist()


def test_an_action_is_ignored_where_an_episode_begins():
    """Whatever it is, also for the reward function; those of the other environments are checked all the same."""
    used = []

    def reward(seen, actions):
        used.append(actions.copy())
        return actions[:, 0]

    envs = envs_of(2, actions={"u": (1.0, 9.0)}, reward=reward, start=lambda random: {"x0": {"theta": 0.4}},
                   terminated=lambda seen: seen[:, 0] > 0.01)  # fmt: skip
    envs.reset(seed=1)
    while not (over := envs.step(np.array([[9.0], [1.0]]))[2]).any():
        pass
    assert over.tolist() == [True, False]
    for wrong in ([[np.nan], [np.nan]], [[2.0], [0.5]]):
        with pytest.raises(ModelError, match="u of environment 1"):
            envs.step(np.array(wrong))
    seen, rewards, *_ = envs.step(np.array([[np.nan], [2.0]]))
    assert seen[0].tolist() == [0.0, 0.4, 0.0, 0.0]
    assert rewards.tolist() == [0.0, 2.0]
    assert used[-1].tolist() == [[0.0], [2.0]]  # the input of the model where no action applies
    assert envs.steppers.u[:, 0].tolist() == [0.0, 2.0]


@pytest.mark.parametrize("part", ["reward", "terminated"])
@pytest.mark.parametrize("autoreset", ["next_step", "same_step", "disabled"])
def test_an_error_of_a_function_asks_for_a_reset(part, autoreset):
    """The step was taken, and what it would have returned is lost; a reset gives the episodes of new environments."""
    calls = []

    def raises(seen, *actions):
        calls.append(len(seen))
        if len(calls) == 3:
            raise ZeroDivisionError("of the user")
        return np.zeros(len(seen))

    envs, new = envs_of(2, autoreset=autoreset, **{part: raises}), envs_of(2)
    envs.reset(seed=1)
    for _ in range(2):
        envs.step(np.zeros((2, 1)))
    with pytest.raises(ZeroDivisionError, match="of the user"):
        envs.step(np.zeros((2, 1)))
    for _ in range(2):
        with pytest.raises(gymnasium.error.ResetNeeded, match="since an error in a step"):
            envs.step(np.zeros((2, 1)))
    assert np.array_equal(envs.reset(seed=5)[0], new.reset(seed=5)[0])
    for _ in range(3):
        one, two = (some.step(np.ones((2, 1))) for some in (envs, new))
        assert np.array_equal(one[0], two[0])
        assert np.array_equal(one[3], two[3])


def test_after_an_error_a_reset_of_some_continues_no_other():
    """The other environment begins an episode of its own in the next step."""
    fails = []
    envs = envs_of(2, reward=lambda seen, actions: fails[0] if fails else seen[:, 0])
    envs.reset(seed=1)
    envs.step(np.ones((2, 1)))
    fails.append(np.zeros(3))
    with pytest.raises(ModelError, match="result of reward"):
        envs.step(np.ones((2, 1)))
    fails.clear()
    envs.reset(seed=1, options={"reset_mask": np.array([True, False])})
    envs.step(np.ones((2, 1)))
    assert envs.steppers.t.tolist() == [0.02, 0.0]


@pytest.mark.parametrize("part", ["reward", "terminated"])
def test_functions_return_one_result_an_environment(part):
    for result in (False, np.zeros(1), np.zeros((3, 1)), np.zeros((1, 3)), np.zeros(2)):
        envs = envs_of(3, **{part: lambda seen, *actions, result=result: result})
        envs.reset(seed=1)
        words = rf"cart_pole: the result of {part} has shape .*, but must have \(3,\)"
        with pytest.raises(ModelError, match=words):
            envs.step(np.zeros((3, 1)))
    envs = envs_of(3, **{part: lambda seen, *actions: [False, True, False]})
    envs.reset(seed=1)
    assert envs.step(np.zeros((3, 1)))[2 if part == "terminated" else 1].tolist() == [0, 1, 0]


def test_what_is_refused():
    for options, words in (
        ({"actions": {}}, "give bounds"),
        ({"actions": {"v": (0, 1)}}, "'v'"),
        ({"actions": {"u": (1, 0)}}, "must increase"),
        ({"observations": ["phi"]}, "'phi'"),
        ({"observations": ["x", "x"]}, "each once"),
        ({"reward": "joy"}, "'joy'"),
        ({"period": 0.0}, "period is 0.0"),
        ({"max_steps": 0}, "max_steps is 0"),
        ({"autoreset": "never"}, "never"),
        ({"method": "Radau"}, "Radau"),
    ):
        with pytest.raises(ModelError, match=words):
            envs_of(2, **options)
    envs = envs_of(2)
    envs.reset(seed=1)
    for actions, words in ((np.zeros((2, 2)), r"\(2, 2\)"), ([[0.0], [11.0]], "u of environment 1 is 11.0"),
                           ([[np.nan], [0.0]], "u of environment 0 is nan")):  # fmt: skip
        with pytest.raises(ModelError, match=words):
            envs.step(actions)
    for drawn, words in (({"x": 1.0}, "with the keys x0, v0, parameters"), ({"x0": {"y": 1.0}}, "'y'"),
                         ({"x0": [1.0, 2.0]}, r"start\(\)\['x0'\] is \[1.0, 2.0\]: return numbers by name"),
                         ({"x0": {"x": [1.0, 2.0]}}, r"x of start\(\)\['x0'\]"),
                         ({"v0": {"x": float("nan")}}, r"x of start\(\)\['v0'\]")):  # fmt: skip
        with pytest.raises(ModelError, match=words):
            envs_of(1, start=lambda random, drawn=drawn: drawn).reset(seed=1)
    with pytest.raises(ModelError, match="member 0 of 1"):
        envs_of(1, start=lambda random: {"parameters": {"m": -1.0}}).reset(seed=1)
    for mask in (np.array([1, 0]), np.array([True])):
        with pytest.raises(ModelError, match="reset_mask"):
            envs.reset(options={"reset_mask": mask})
    with pytest.raises(ModelError, match="3 seeds"):
        envs.reset(seed=[1, 2, 3])


def test_options_of_steppers_are_those_of_every_start():
    """x0, v0, parameters, inputs and t beside `start`, which replaces only what it returns; at the first reset and on.

    The motions are those of single steppers of the same start.
    """
    given = {"x0": {x: 0.3}, "v0": {theta: 0.2}, "parameters": {"m": 0.2, "l": [0.4, 0.6]}, "inputs": {"v": 1.5}}
    v = dynamicsymbols("v")
    model = cart_pole(forces={x: u + v * sin(dynamicsymbols._t)}, inputs={u: 0.0, v: 0.5})
    for begin in (None, lambda random: {"x0": {"theta": 0.1}, "parameters": {"m": 0.1}}):
        envs = envs_of(2, model, start=begin, max_steps=3, autoreset="same_step", t=2.0, **given)
        seen = envs.reset(seed=1)[0]
        begun = begin(None) if begin else {"x0": {}, "parameters": {}}
        for step in range(5):
            for k in range(2):
                one = system_for(model, "lagrange").stepper(
                    t=2.0, x0={x: 0.3, **begun["x0"]}, v0=given["v0"], inputs={"v": 1.5, "u": 0.7},
                    parameters={"m": 0.2, "l": (0.4, 0.6)[k], **begun["parameters"]},
                )  # fmt: skip
                if step % 3:
                    one.advance(2.0 + 0.02)
                    if step % 3 == 2:
                        one.advance(2.0 + 0.04)
                assert [*one.x, *one.v] == seen[k].tolist()
            seen = envs.step(np.full((2, 1), 0.7))[0]
