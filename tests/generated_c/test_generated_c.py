"""The generated C: compiles without a warning, runs without Python, takes any names, and uses all it is given."""

import re
import shutil
import subprocess
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.kernel.identifiers import c_identifier, c_identifiers
from eigenmotion.codegen.kernel.kernel import Kernel
from eigenmotion.codegen.kernel.parts import Part
from eigenmotion.codegen.program import kernel_roles
from eigenmotion.codegen.program import program as codegen_program
from eigenmotion.codegen.program.kernel_roles import Kernels, Stages
from eigenmotion.codegen.program.program import BlockCoordinate, BlockView, EventView, Program, Slice
from eigenmotion.codegen.render.emit import TEMPLATES, environment
from jinja2 import meta, nodes
from sympy import Rational, cos, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, multiplier
from eigenmotion.building.toolchain import INCLUDE, toolchain

from ..support.generation import FORMULATIONS, NAMES, STRICT, loaded, model_of, relative, states, system_for

TEMPLATE_FOLDER = Path(__file__).parents[2] / "templates"
PARTS = sorted(str(path.relative_to(TEMPLATE_FOLDER)) for path in TEMPLATE_FOLDER.rglob("*.jinja"))


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", NAMES)
def test_compiles_without_a_warning(systems, name, formulation):
    """With -std=c11 -Wall -Wextra -Wpedantic -Werror; `generation` compiles so."""
    assert systems(name, formulation).formulation == formulation


def test_runs_without_python(systems, tmp_path):
    sources = compiler.generate(model_of("dual_link"))
    for file in sources.files:
        (tmp_path / file.name).write_text(file.text)
    shutil.copy(Path(__file__).parent / "main.c", tmp_path)
    command = [*toolchain().command, *STRICT, "-O0", "-ffp-contract=fast", f"-I{INCLUDE}", "main.c", "dual_link.c"]
    subprocess.run([*command, "-lm", "-o", "plain"], cwd=tmp_path, check=True)
    done = subprocess.run(["./plain"], cwd=tmp_path, capture_output=True, text=True, check=True, env={})
    title, *lines = done.stdout.splitlines()
    run = systems("dual_link").simulate((0, 10), rtol=1e-9, atol=1e-9)
    assert title == f"dual_link: {run.nsteps} steps, {run.nfev} right-hand sides"
    assert [line.split()[0] for line in lines] == ["theta1", "theta2", "theta3", "theta4"]
    found = np.array([line.split()[1:] for line in lines], dtype=float)
    assert relative(found, np.column_stack([run.x[:, -1], run.v[:, -1]])) < 1e-12


def test_the_sources_hold_nothing_of_python():
    text = {file.name: file.text for file in compiler.generate(model_of("dual_link")).files}
    assert sorted(text) == ["dual_link.c", "dual_link.h", "dual_link.pyx"]
    for name in ("dual_link.c", "dual_link.h"):
        assert "Python.h" not in text[name]
    assert max(map(len, text["dual_link.c"].splitlines())) <= 180


def test_long_lines_are_broken_and_read_the_same():
    """Of a mechanism with 14 coordinates and 8 frictions: no line is too long, and its texts come back whole."""
    model = model_of("quick_return_shaper")
    assert max(map(len, c_text_of(model, "eigenfactor").splitlines()[3:])) <= 120  # below the stamp
    left_out = compiler.program(model, Choices("eigenfactor")).left_out
    assert max(map(len, left_out)) > 120
    assert system_for(model, "eigenfactor").left_out == left_out


def test_every_function_says_what_it_is(systems):
    """No function of generated code without a comment above it."""
    text = c_text_of(model_of("dual_link"), "eigenfactor")
    lines = text.splitlines()
    heads = [
        k
        for k, line in enumerate(lines)
        if re.match(r"(static int|static void|EM_EXPORT int|EM_EXPORT void|EM_INLINE void) \w+\(", line)
    ]
    assert len(heads) > 15
    bare = [lines[k] for k in heads if not lines[k - 1].rstrip().endswith("*/")]
    assert [line for line in bare if not re.match(r"static int (velocity|rhs)\(", line)] == []


# --- templates and the record they get --------------------------------------------------------------------------------

RECORDS = {"program": Program, "b": BlockView, "kernels": Kernels, "p": BlockCoordinate, "kernel": Kernel,
           "section": Part, "part": Slice, "event": EventView, "triangular": Stages}  # fmt: skip
OTHERS = tuple(kind for kind in {**vars(codegen_program), **vars(kernel_roles)}.values() if is_dataclass(kind))


def attributes():
    """Return (variable, attribute) of every access in every template."""
    trees = [environment().parse((TEMPLATE_FOLDER / name).read_text()) for name in PARTS]
    found = {(node.node.name, node.attr) for tree in trees for node in tree.find_all(nodes.Getattr)
             if isinstance(node.node, nodes.Name)}  # fmt: skip
    chained = {(node.node.attr, node.attr) for tree in trees for node in tree.find_all(nodes.Getattr)
               if isinstance(node.node, nodes.Getattr) and node.node.attr == "kernels"}  # fmt: skip
    return {(name, attribute) for name, attribute in found | chained if name != "loop"}


@pytest.mark.parametrize("template", TEMPLATES.values())
def test_files_need_the_program_and_nothing_else(template):
    text = (TEMPLATE_FOLDER / template).read_text()
    assert meta.find_undeclared_variables(environment().parse(text)) == {"program"}


def test_templates_read_no_field_that_is_not_there():
    for variable, attribute in attributes():
        kinds = [RECORDS[variable]] if variable in RECORDS else OTHERS
        assert any(hasattr(kind, attribute) for kind in kinds), (
            variable,
            attribute,
        )  # slots, and what follows from them


@pytest.mark.parametrize("record", [Program, BlockView, Kernels, BlockCoordinate])
def test_templates_read_every_field(record):
    variables = {name for name, kind in RECORDS.items() if kind is record}
    read = {attribute for variable, attribute in attributes() if variable in variables or variable not in RECORDS}
    assert sorted({field.name for field in fields(record)} - read) == []


def test_templates_compute_nothing():
    """Neither `set` nor macros nor calls; arithmetic only on places."""
    forbidden = (nodes.Assign, nodes.Macro, nodes.CallBlock, nodes.Call)
    for name in PARTS:
        tree = environment().parse((TEMPLATE_FOLDER / name).read_text())
        assert [node for kind in forbidden for node in tree.find_all(kind)] == [], name


# --- names ------------------------------------------------------------------------------------------------------------

WORDS = re.compile(r"[A-Za-z_]\w*")
HARD = (
    "double int inline restrict static register yield class None nogil sin cos tan exp log pow sqrt fabs gamma y0 "
    "jn i j k r row sum column product stretch turn isnan NAN INFINITY NULL I errno linux main memset size_t "
    "real em_real velocities em_model "
    "em_fault c_0 c_1 c_2 z_0 z_1 z_2 sin_0 C1 s1 L1 M1 Mdot1 r1 w1 v1 f1 a1 q1 B1 A1 N1 Omega1 C1_dot "
    "singular1 state rhs M N L C s f y dy c eta_dot gap_dot row_ M1_ B2 mu1 eta1 N_ROWS memory shared det1 prepared "
    "parameters mass_matrix eigenfactor_motion A b phi terms bias e out crossing dM fault mode t_"
).split()


def words_of(text):
    """Return every word outside comments."""
    return sorted(set(WORDS.findall(re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL))))


def folded(terms):
    """Mean of many terms in groups of eight: a sum of hundreds takes long to generate."""
    while len(terms) > 1:
        terms = [1 / (1 + (sum(terms[k : k + 8]) / 8) ** 2) for k in range(0, len(terms), 8)]
    return terms[0]


def named(names, symbols):
    """A mechanism that holds all its symbols in every function of the generated code."""
    x, (push, pull) = dynamicsymbols(names[:2]), dynamicsymbols(names[2:])
    p = [sympy.Symbol(name) for name in symbols]
    v = [c.diff() for c in x]
    part = folded(
        [(entry * x[k % 2] + after) ** 2 for k, (entry, after) in enumerate(zip(p, p[1:] + p[:1], strict=True))]
    )
    T = (v[0] ** 2 + v[1] ** 2) * (2 + part) / 2 + part * v[0] * v[1] / 3 + part * v[1] / 5
    return Model(
        name="named",
        coordinates=x,
        kinetic_energy=T,
        potential_energy=part * cos(x[0]),
        forces={x[0]: push * part - pull * v[0]},
        nonholonomic_constraints=[v[0] * sin(x[1]) + v[1] * (2 + part) + part],
        parameters={entry: 0.2 + 0.003 * (k % 97) for k, entry in enumerate(p)},
        inputs={push: 0.4, pull: 1.2},
        outputs={"seen": part + x[1].diff().diff() + multiplier(0) + push},
        events={"through": Event(part - 10)},
        initial={x[0]: Rational(1, 3), x[1]: 1},
    )


ODD = ("eta", "gap", "lambda", "u")


@cache
def oddly_named(formulation):
    """Sources of the mechanism with every hard name: seconds of work."""
    return compiler.generate(named(ODD, HARD), Choices(formulation))


@pytest.fixture(scope="module")
def harmless():
    """The mechanism with names that mean nothing in C."""
    return system_for(named(("p1", "p2", "w1", "w2"), [f"k{k}" for k in range(len(HARD))]), "lagrange")


@pytest.mark.parametrize(
    "formulation", ["eigenfactor", *(pytest.param(one, marks=pytest.mark.nightly) for one in FORMULATIONS[1:])]
)
def test_any_name_will_do(formulation, harmless):
    odd = loaded(oddly_named(formulation), "-O0")
    assert (odd.coordinates, tuple(odd.inputs)) == (ODD[:2], ODD[2:])
    assert list(odd.parameters) == HARD
    for x, v, t in states(harmless, 2):
        assert relative(odd.acceleration(x, v, t)[0], harmless.acceleration(x, v, t)[0]) < 1e-12
        assert relative(odd.mass_matrix_gradient(x, t), harmless.mass_matrix_gradient(x, t)) < 1e-12
        assert odd.energy(x, v, t) == pytest.approx(harmless.energy(x, v, t), rel=1e-13)
    v0 = harmless.project_initial_state()[1]
    runs = [system.simulate((0, 0.5), v0=v0, rtol=1e-11, atol=1e-12) for system in (odd, harmless)]
    assert relative(runs[0].outputs["seen"][-1:], runs[1].outputs["seen"][-1:]) < 1e-8
    assert relative(runs[0].x[:, -1], runs[1].x[:, -1]) < 1e-9


def c_text(sources):
    return next(file.text for file in sources.files if file.name.endswith(".c"))


def c_text_of(model, formulation):
    return c_text(compiler.generate(model, Choices(formulation)))


@pytest.mark.nightly
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_any_word_of_the_file_is_a_name_to_have(formulation, tmp_path):
    """Exhaustive where the test above samples: every word of a generated file at once, the names of C among them."""
    plain = ("p1", "p2", "w1", "w2")
    words = [word for word in words_of(c_text_of(named(plain, ["k1", "k2"]), formulation)) if word not in (*plain, "t")]
    assert len(words) > 200
    (tmp_path / "named.h").write_text('#include "eigenmotion.h"\nextern const em_model named_model;\n')
    (tmp_path / "named.c").write_text(c_text_of(named(plain, words), formulation))
    command = [*toolchain().command, *STRICT, "-fsyntax-only", f"-I{INCLUDE}", "named.c"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[:2000]


def test_a_kernel_declares_each_name_once_and_hides_no_function_it_calls():
    text = c_text(oddly_named("eigenfactor"))
    kernels = re.findall(
        r"^(?:static|EM_EXPORT|EM_INLINE) void \w+\(([^)]*)\)\n\{\n(.*?)^\}", text, re.MULTILINE | re.DOTALL
    )
    assert len(kernels) > 10
    for head, inside in kernels:
        declared = re.findall(r"(\w+)(?:\[\w+\])*(?:,|$)", head) + re.findall(r"const double (\w+) =", inside)
        assert len(set(declared)) == len(declared)
        assert not set(declared) & set(re.findall(r"(\w+)\(", inside))


def test_no_symbol_gets_the_name_of_a_macro_or_function_of_the_runtime():
    declared = re.compile(r"#define\s+(\w+)|^(?:EM_INLINE|EM_NOINLINE|EM_EXPORT|static)[\w\s*]*?(\w+)\(", re.MULTILINE)
    found = {a or b for path in INCLUDE.rglob("*.h") for a, b in declared.findall(path.read_text())}
    assert len(found) > 50
    assert sorted(word for word in found if c_identifier(word) in found) == []


def test_identifiers_are_all_different():
    names = [*HARD, "a b", "a_b", "a.b", "2x", "_2x", "ä", "_", r"\theta", "theta'", "row__"]
    identifiers = c_identifiers(names)
    assert len(set(identifiers.values())) == len(names)
    assert [i for i in identifiers.values() if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", i)] == []


def test_names_are_told_as_they_were_given():
    theta, tau = dynamicsymbols(r"\theta"), sympy.Symbol(r'\tau "??/ %d')
    out = {'a"b': theta, r"back\new": theta, "é": theta}
    T = tau * theta.diff() ** 2 * (2 + sin(theta))
    system = system_for(Model(name="told", coordinates=[theta], kinetic_energy=T, parameters={tau: 1.0}, outputs=out))
    assert system.coordinates == (r"\theta",)
    assert list(system.parameters) == [tau.name]
    assert system.outputs == tuple(out)
    assert any(r"{\theta}" in line for line in system.left_out)


@pytest.mark.parametrize(
    "name", ["int", "main", "state", "rhs", "N", "sin", "math", "stdio", "model", "prepare", "NULL"]
)
def test_models_may_be_called_like_what_is_in_c(name):
    x, m = dynamicsymbols("x"), sympy.Symbol("m")
    T = m * x.diff() ** 2 * (2 + x**2)
    system = system_for(Model(name=name, coordinates=[x], kinetic_energy=T, parameters={m: 1.0}))
    assert system.acceleration([1.0], [1.0])[0] == pytest.approx([-1 / 3], rel=1e-14)
