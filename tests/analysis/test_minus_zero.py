"""No table says -0: it is 0, and the sign is that of rounding or of a product's factors."""

import numpy as np
import pytest

from eigenmotion.analysis.linear.linearization import eigenvalue_text
from eigenmotion.cli import main

AT_REST = """\
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model
x, f = dynamicsymbols("x f")
k = Symbol("k")
model = Model(name="at_rest", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=k * x**2 / 2,
              forces={x: f}, parameters={k: 1.0}, inputs={f: 0.0}, initial={x: -0.0})
"""


@pytest.mark.parametrize(
    "command",
    [["equilibrium"], ["equilibrium", "--set", "x=-0"], ["equilibrium", "--free", "f", "--set", "x=-0"],
     ["linearize", "--at", "x=-0"], ["run", "--t-end", "1", "--set", "x=-0", "--set", "x'=-0"]],
)  # fmt: skip
def test_no_table_says_minus_zero(scene, capsys, command):
    scene.write_text(AT_REST)
    assert main([command[0], "scene.py", "--formulation", "lagrange", *command[1:]]) == 0
    words = capsys.readouterr().out.replace("=", " ").split()
    assert "0" in words
    assert "-0" not in words


def test_an_eigenvalue_is_not_minus_zero():
    assert eigenvalue_text(complex(-0.0, 0.0)) == "0"
    assert eigenvalue_text(complex(-0.0, 2.0)) == "0 ± 2 i"
    assert np.signbit(-0.0)
