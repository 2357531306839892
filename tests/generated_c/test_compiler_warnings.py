"""Generated code gives no warning, at the flags that users have, with any compiler: over many small mechanisms.

Users never see warnings; what they would say is looked at here: there a compiler reads the code otherwise than we do.
Clang gives all of its warnings as it reads, GCC some as it optimises, which takes ten seconds where the stepper is in
the same file. So each model, shape and choice is compiled once with the stepper, and all pairs of them without.
"""

import os
import subprocess
from pathlib import Path

import pytest
import sympy
from eigenmotion.codegen.choices import FORMULATIONS, Choices
from eigenmotion.codegen.compiler import generate
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.building.toolchain import INCLUDE, toolchain

from ..dynamics.kernels import HERE
from ..support.generation import COMPILERS, NAMES, STRICT, choices_for, model_of

SHAPES = [(n, m) for n in range(1, 5) for m in range(min(n, 3) + 1)]
OPTIONS = [{"formulation": name} for name in FORMULATIONS] + [
    {"close_eigenvalues": "extrapolate"},
    {"schur": "eigenfactor"},
    {"schur": "eigenfactor", "close_eigenvalues": "extrapolate"},
]
EVERY_DAY = SHAPES[::2]
"""Every n and m, and, as `test_models_of_every_small_shape` pairs them, every choice."""
CASES = [pytest.param(n, m, 0, False) for n, m in EVERY_DAY]
CASES += [
    pytest.param(n, m, draw, draw == 0, marks=pytest.mark.nightly)
    for n, m in SHAPES
    for draw in range(2 * len(OPTIONS))
]
"""At night every shape with every choice, twice, and in one file with the stepper every shape and every choice."""
q, r = dynamicsymbols("q r")


def shapeless(n: int, m: int, draw: int) -> em.Model:
    """A mechanism with terms of many kinds at random places: blocks that vary or do not, rows that vanish somewhere."""
    random = sympy.core.random.rng
    random.seed(1000 * draw + 10 * n + m)
    x, k = dynamicsymbols(f"x:{n}"), sympy.symbols("k", positive=True)
    v = [one.diff() for one in x]

    def term() -> sympy.Expr:
        one, other = random.choice(x), random.choice(x)
        return random.choice([
            sympy.Integer(1), k, one, one**2, sympy.sin(one), sympy.cos(one - other), sympy.sqrt(1 + one**2), k * em.t,
            sympy.exp(-one), abs(one),
        ])  # fmt: skip

    T = sum((1 + term() ** 2) * rate**2 for rate in v) / 2
    T += sum(term() * random.choice(v) * random.choice(v) for _ in range(random.randrange(n + 1))) / 4
    rows = [v[-1 - row] + sum(term() * random.choice(v) for _ in range(random.randrange(2))) for row in range(m)]
    h = random.randrange(m + 1)
    return em.Model(
        name="shapeless",
        coordinates=x,
        kinetic_energy=T + random.choice([0, term() * v[0], term()]),
        potential_energy=random.choice([0, x[0] ** 2 / 2, term()]),
        forces={x[-1]: random.choice([0, -v[-1], term()])},
        holonomic_constraints=[x[-1 - row] - term().subs(x[-1 - row], x[0] + 1) / 3 for row in range(h)],
        nonholonomic_constraints=rows[h:],
        parameters={k: 1.0},
        events={"passes": x[0]} if random.random() < 0.5 else {},
        outputs={"felt": x[0].diff(em.t, 2)} if random.random() < 0.5 else {},
    )


KNOWN = {  # each once gave a warning
    "one coordinate": em.Model(name="known", coordinates=[q], kinetic_energy=(1 + q**2) * q.diff() ** 2 / 2,
                               potential_energy=q**2 / 2, initial={q: 0.5}),
    "one row": em.Model(name="known", coordinates=[q, r], kinetic_energy=(q.diff() ** 2 + q**2 * r.diff() ** 2) / 2,
                        nonholonomic_constraints=[r.diff() - 1], initial={q: 0.5}),
    "contact with friction": em.Model(
        name="known", coordinates=[q, r], kinetic_energy=(q.diff() ** 2 + r.diff() ** 2) / 2,
        potential_energy=9.81 * r, initial={r: 1.0},
        contacts={"floor": em.Contact(r, 0.5), "rub": em.Friction(q.diff(), 0.3, "floor")},
    ),
    "cone, impact": em.Model(name="known", coordinates=[q, r], kinetic_energy=(q.diff() ** 2 + r.diff() ** 2) / 2,
                             contacts={"rub": em.Friction((q.diff(), r.diff()), 0.3)}, initial={r: -1.0},
                             events={"wall": em.Event(r, impact=(r, 0.5))}),
    "guide that rubs": em.Model(name="known", coordinates=[q, r], kinetic_energy=(q.diff() ** 2 + r.diff() ** 2) / 2,
                                holonomic_constraints=[r - q**2], initial={q: 0.5, r: 0.25},
                                contacts={"rub": em.Friction(q.diff(), 0.3, 0)}),
}  # fmt: skip


BY_DAY = ("one row", "contact with friction")
KNOWN_CASES = [name if name in BY_DAY else pytest.param(name, marks=pytest.mark.nightly) for name in KNOWN]


def warnings_of(model: em.Model, folder: Path, compiler: str, stepper: bool = False, **options: str) -> str:
    """What a compiler says, of numbers and of lanes. GCC finds what may be unset where it optimises, Clang before.

    `stepper`: in one file with the stepper, as other tools compile it; that knows no model, and takes most of the time.
    """
    sources = generate(model, Choices(**options))
    for file in sources.files:
        (folder / file.name).write_text(file.text)
    aim = ("-fsyntax-only",) if compiler == "clang" else ("-c", "-o", os.devnull)
    command = (compiler, *STRICT, *toolchain(compiler).optimised, f"-I{INCLUDE}", *aim, f"{sources.name}.c")
    numbers = () if stepper else ("-DEM_UNIT=EM_MODEL|EM_RHS|EM_ASIDE|EM_DERIVATIVES",)
    both = ((*command, *numbers), (*command, "-DEM_ON_LANES"))
    return "".join(subprocess.run(one, cwd=folder, capture_output=True, text=True, check=False).stderr for one in both)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("formulation", ["eigenfactor", "inverse"])
@pytest.mark.parametrize("name", KNOWN_CASES)
def test_models_that_once_gave_one(name, formulation, compiler, tmp_path):
    whole = name == "contact with friction"
    assert not warnings_of(KNOWN[name], tmp_path, compiler, whole, formulation=formulation)


@pytest.mark.nightly
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", NAMES)
def test_our_models(name, formulation, compiler, tmp_path):
    choices_for(name, formulation)
    stepper = compiler == "clang" or formulation == FORMULATIONS[0]
    assert not warnings_of(model_of(name), tmp_path, compiler, stepper, formulation=formulation)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("n", [9, 24, 32])
def test_algebra_of_large_blocks(n, compiler):
    """In loops over the columns of a factor GCC feared a first column n where n is a multiple of eight."""
    command = (compiler, *STRICT, *toolchain(compiler).optimised, f"-I{INCLUDE}", f"-DSIZE={n}", "-c", "-o", os.devnull)
    subprocess.run([*command, str(HERE / "rates.c")], check=True)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize(("n", "m", "draw", "stepper"), CASES)
def test_models_of_every_small_shape(n, m, draw, stepper, compiler, tmp_path):
    """Every choice in turn: each once here, all of them for every shape with `make nightly`."""
    options = OPTIONS[(SHAPES.index((n, m)) + draw) % len(OPTIONS)]
    assert not warnings_of(shapeless(n, m, draw), tmp_path, compiler, stepper, **options)


def test_what_is_compiled_once_with_the_stepper_meets_every_choice():
    with_stepper = [case.values for case in CASES if case.values[3]]
    assert {(n, m) for n, m, *_ in with_stepper} == set(SHAPES)
    assert {(SHAPES.index((n, m)) + draw) % len(OPTIONS) for n, m, draw, _ in with_stepper} == set(range(len(OPTIONS)))
