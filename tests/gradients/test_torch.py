"""Motions as functions of PyTorch: against differences, ensembles and the adjoint of single runs."""

from typing import Any

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion import ModelError
from eigenmotion.analysis.gradients import motion_map

from ..support.generation import system_of

torch = pytest.importorskip("torch", reason="PyTorch is not here: `make nightly` installs it")
pytestmark = pytest.mark.filterwarnings("ignore:`torch.jit.script` is deprecated:DeprecationWarning")  # its own use

TIGHT = {"rtol": 1e-11, "atol": 1e-13}
EVERY = ("x", "v", "states", "outputs")
MOTIONS = {
    "bouncing_ball": {"x'": 0.5, "z": 1.0, "e": 0.8, "g": 9.81},
    "block_on_incline": {"s'": 3.0, "mu": 0.6, "alpha": 0.4},
    "servo_pendulums": {"q1": 0.15, "q2'": 0.1, "i": 0.5, "target": 0.05, "K": 0.1},
}
BALL = MOTIONS["bouncing_ball"]


def function(name: str = "bouncing_ball", **options: Any) -> Any:
    system, by = system_of(name, "lagrange"), list(MOTIONS[name])
    return em.to_torch(system, (0.0, 0.6), [0.2, 0.6], by=by, **{"of": EVERY} | TIGHT | options)


def tensors(values: dict[str, float], **options: Any) -> dict[str, Any]:
    return {name: torch.tensor(value, dtype=torch.float64, **options) for name, value in values.items()}


def summed(found: dict[str, Any]) -> Any:
    """Return a number that depends on all rows, each weighed otherwise."""
    leaves = [found["x"], found["v"], *found["states"].values(), *found["outputs"].values()]
    return sum((k + 1.0) * (leaf * torch.arange(1.0, 3.0)).sum() for k, leaf in enumerate(leaves))


@pytest.mark.parametrize("name", MOTIONS)
def test_derivatives_against_differences(name: str):
    """Backwards and forwards, of motions with impacts, friction, states, inputs and outputs."""
    f, values = function(name), tensors(MOTIONS[name], requires_grad=True)

    def number(*given: Any) -> Any:
        return summed(f(dict(zip(values, given, strict=True))))

    given = tuple(values.values())
    assert torch.autograd.gradcheck(number, given, eps=1e-6, atol=1e-5, rtol=1e-6, check_forward_ad=True)


def test_gradients_are_those_of_runs():
    f, values = function(of=("x", "v")), tensors(BALL, requires_grad=True)
    found = f(values)
    run, pullback = em.vjp(
        system_of("bouncing_ball", "lagrange"), (0.0, 0.6), by=list(BALL), t_eval=[0.2, 0.6], x0={"z": 1.0},
        v0={"x": 0.5}, parameters={"e": 0.8}, **TIGHT,
    )  # fmt: skip
    np.testing.assert_array_equal(found["x"].detach(), run.x)
    np.testing.assert_array_equal(found["v"].detach(), run.v)
    (found["x"] * found["x"].detach()).sum().backward()
    for name, right in pullback(dx=run.x).items():
        assert values[name].grad.item() == right


def test_vmap_is_one_ensemble(monkeypatch):
    """Bit for bit; gradients of many are those of each, by all of torch.func."""
    f, given = function(), {name: value * (1.0 + 0.02 * torch.arange(4.0).double()) for name, value in BALL.items()}
    each = [{name: row[k] for name, row in given.items()} for k in range(4)]
    right = [torch.func.grad(lambda at: summed(f(at)))(one) for one in each]
    for derivative in (torch.func.grad, torch.func.jacrev, torch.func.jacfwd):
        found = torch.func.vmap(derivative(lambda at: summed(f(at))))(given)
        for name, rows in found.items():
            np.testing.assert_allclose(rows, [one[name] for one in right], rtol=1e-8)
    monkeypatch.setattr(motion_map, "simulate", None)  # no single run
    runs = em.simulate_ensemble(
        system_of("bouncing_ball", "lagrange"), (0.0, 0.6), t_eval=[0.2, 0.6], x0={"z": given["z"].numpy()},
        v0={"x": given["x'"].numpy()}, parameters={"e": given["e"].numpy(), "g": given["g"].numpy()}, **TIGHT,
    )  # fmt: skip
    np.testing.assert_array_equal(torch.func.vmap(f)(given)["x"], runs.x)
    shared = torch.func.vmap(lambda height: f(tensors(BALL) | {"z": height})["x"])(given["z"])
    assert shared.shape == (4, 2, 2)


def test_mistakes():
    f = function()
    for wrong, words in (
        ({"z": 1.0}, "no value for"), (BALL | {"q": 1.0}, "unknown name 'q'"), (BALL | {"g": np.inf}, "not a finite"),
        (BALL | {"z": torch.tensor(1.0)}, r"'z' is torch.float32\[\]; give a torch.float64"),
        (BALL | {"z": torch.ones(2, dtype=torch.float64)}, r"'z' is torch.float64\[2\]"),
    ):  # fmt: skip
        with pytest.raises(ModelError, match=words):
            f(wrong)
    with pytest.raises(ModelError, match=r"bouncing_ball: .*max_steps"):
        function(max_steps=3)(BALL)
    with pytest.raises(ModelError, match=r"motion 1 \(of 0 to 1\): "):
        torch.func.vmap(lambda gravity: f(tensors(BALL) | {"g": gravity}))(torch.tensor([9.0, torch.nan]).double())


def test_second_derivatives_are_refused():
    with pytest.raises(ModelError, match="first derivatives only"):
        torch.func.hessian(lambda at: summed(function()(at)))(tensors(BALL))
    values = tensors(BALL, requires_grad=True)
    first = torch.autograd.grad(summed(function()(values)), values["z"], create_graph=True)
    with pytest.raises(ModelError, match="first derivatives only"):
        first[0].backward()
