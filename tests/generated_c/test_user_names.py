"""The user's names in generated files: any text comes back as it was, whatever it means in C, Cython or a comment."""

import subprocess

import pytest
import sympy
from eigenmotion.codegen.choices import FORMULATIONS, Choices
from eigenmotion.codegen.compiler import generate
from eigenmotion.codegen.kernel.identifiers import c_identifier
from eigenmotion.codegen.render.emit import commented, quoted

import eigenmotion as em
from eigenmotion.building.request import request
from eigenmotion.building.toolchain import INCLUDE, toolchain

from ..support.generation import loaded

COORDINATES = ("*/", "a\nb", "\\", "/*")
OTHERS = (
    'q"', "??/", "\u03b8\u202e", "x" * 3000, " ", "", "a\\\nb", "%s{{x}}{% if", "\'\'\'\"\"\"", "\r\v\x1b\u2028", "# x",
    "hypot", "printf", "DBL_MAX", "FP_NAN", "M_PI", "EXIT_FAILURE", "isnan",
)  # fmt: skip


def named() -> em.Model:
    x = [sympy.Function(name)(em.t) for name in COORDINATES]
    p = [sympy.Symbol(name) for name in OTHERS]
    v = [one.diff() for one in x]
    T = sum(mass * rate**2 for mass, rate in zip(p, v, strict=False)) / 2 + v[0] * v[1] * sympy.sin(x[0]) / 4
    return em.Model(
        name="named",
        coordinates=x,
        kinetic_energy=T,
        potential_energy=sum(p) * sympy.cos(x[2]),
        nonholonomic_constraints=[v[2] - sympy.cos(x[0]) * v[3]],
        parameters=dict.fromkeys(p, 1.0),
        outputs={"*/ \n": x[0]},
        events={"*/ ??/": x[1]},
    )


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_every_name_comes_back(formulation):
    system = loaded(generate(named(), Choices(formulation)), "-O0")
    assert system.coordinates == COORDINATES
    assert tuple(system.parameters) == OTHERS
    assert (system.outputs, system.events) == (("*/ \n",), ("*/ ??/",))


@pytest.mark.parametrize("name", ["a\0b", "\ud800"])
def test_what_no_text_of_c_holds_is_refused(name):
    x, p = sympy.Function("x")(em.t), sympy.Symbol(name)
    with pytest.raises(em.ModelError, match="no text of C"):
        em.Model(name="refused", coordinates=[x], kinetic_energy=p * x.diff() ** 2, parameters={p: 1.0})
    with pytest.raises(em.ModelError, match="no text of C"):
        em.Model(name="refused", coordinates=[x], kinetic_energy=x.diff() ** 2, outputs={name: x})


def test_the_command_of_a_file_stays_on_its_line(tmp_path):
    path = tmp_path / "a\nb.py"
    path.write_text(
        "from sympy.physics.mechanics import dynamicsymbols\nfrom eigenmotion import Model\nq = dynamicsymbols('q')\n"
        "def model(label: str = ''): return Model(name='scene', coordinates=[q], kinetic_energy=q.diff()**2)\n"
    )
    for file in request(path, {"label": "*/\nimport os\u202e"}).sources().files:
        assert r"a\nb.py -D label=* /\nimport os\u202e" in file.text.splitlines()[0]


def test_texts_are_escaped():
    assert commented("a*/\n/*/ ??/\ud800") == r"a* /\n/ * / ? ?/\ud800"
    assert quoted('a\r"\\?\u202e') == r"a\015\"\\\?\342\200\256"


def test_no_macro_of_the_headers_takes_a_users_name():
    """A macro is replaced wherever its name stands; what begins with an underscore is the compiler's."""
    text = (
        "".join(
            f'#include "{name}"\n'
            for name in (
                "eigenmotion.h",
                "numeric/em_functions.h",
                "constraints/em_multipliers.h",
                "mass/em_eigenfactors.h",
                "mass/em_root_switching.h",
            )
        )
        + "#include <stdlib.h>\n"
    )
    command = (*toolchain().command, "-std=c11", f"-I{INCLUDE}", "-dM", "-E", "-")
    said = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    macros = {line.split()[1] for line in said.splitlines()}
    names = [name for name in macros if "(" not in name and not name.startswith("_")]
    assert len(names) > 50
    assert not [name for name in names if c_identifier(name) == name]
