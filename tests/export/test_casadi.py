"""Functions for CasADi: what it calls them with and gets from them, against our own system and its own derivatives."""

import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from eigenmotion.codegen.equations.tree import link_table
from scipy.interpolate import CubicSpline
from sympy import cos
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, ModelError
from eigenmotion.building.toolchain import toolchain
from eigenmotion.casadi import one_piece
from eigenmotion.cli import main

from ..support.generation import MODELS, system_of

casadi = pytest.importorskip("casadi")
pytestmark = pytest.mark.usefixtures("hurried")

NAMES = ("double_pendulum", "four_bar", "furuta_pendulum", "servo_pendulums", "robot_arm")
"""A chain, a loop, inputs and outputs, first-order states, a tree of bodies."""
FUNCTIONS = ("acceleration", "rhs", "inverse_dynamics", "outputs")


@pytest.fixture(scope="module")
def libraries(tmp_path_factory, hurried) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("functions")
    return {name: em.export_casadi(MODELS / f"{name}.py", folder / f"{name}.so") for name in NAMES}


def function_of(library: Path, name: str):
    return casadi.external(name, str(library))


def functions_in(name: str) -> tuple[str, ...]:
    return FUNCTIONS if system_of(name).outputs else FUNCTIONS[:3]


def moving(name: str, seed: int, scale: float = 1.0):
    """A state beside the start of a model, at random inputs; in a small scale, limits of a controller are not met."""
    system, random = system_of(name), np.random.default_rng(seed)
    x, v = (one.copy() for one in system.begin())  # its own are those of the system
    n = system.n
    x[:n] += 0.1 * random.standard_normal(n) * (not system.m)
    v = v + 0.3 * random.standard_normal(len(v))
    if not system.m:
        x, v = scale * x, scale * v
    if system.m:
        there = system.project_initial_state(x[:n], v[:n])
        x[:n], v[:n] = there.x, there.v
    given = {"x": x[:n], "v": v[:n], "z": v[n:], "p": np.array(list(system.parameters.values())),
             "u": 0.1 * scale * random.standard_normal(len(system.inputs)), "a": random.standard_normal(n),
             "multipliers": random.standard_normal(system.m), "t": np.array([0.3])}  # fmt: skip
    return given | {"state": np.concatenate([x[:n], v])}


def arguments(function, given) -> list[np.ndarray]:
    return [given[name] for name in function.name_in()]


def own_values(name: str, given) -> dict[str, np.ndarray]:
    """The values of our own system."""
    system = system_of(name)
    x, v = np.concatenate([given["x"], 0 * given["z"]]), np.concatenate([given["v"], given["z"]])
    c, u = system.prepare(), given["u"]
    a, multipliers = system.compiled.acceleration(0.3, x, v, c, u, 1)
    M, A = system.mass_matrix(given["x"], 0.3), system.pfaffian(given["x"], 0.3)[0]
    more = given["a"] - a[: system.n]  # M a + A^T lambda = f and A a + gamma = 0 hold at those of the motion
    found = {"a": a[: system.n], "multipliers": multipliers, "rate": np.concatenate([v[: system.n], a]),
             "tau": M @ more + A.T @ (given["multipliers"] - multipliers), "residual": A @ more}  # fmt: skip
    if system.outputs:
        t = np.array([0.3])
        found["y"] = system.compiled.output_rows(t, x[None], v[None], u[None], c, 1)[0]
    return found


@pytest.mark.parametrize("name", NAMES)
def test_values_are_those_of_the_system(libraries, name):
    given = moving(name, 1)
    own = own_values(name, given)
    for each in functions_in(name):
        function = function_of(libraries[name], each)
        for output, value in zip(function.name_out(), function.call(arguments(function, given)), strict=True):
            assert np.asarray(value).ravel() == pytest.approx(own[output], rel=1e-11, abs=1e-11), (each, output)


def jacobians(function, given) -> list[np.ndarray]:
    """All blocks, as they are published, by output and input."""
    found = function.jacobian().call([*arguments(function, given), *[casadi.DM(0, 0)] * function.n_out()])
    return [np.asarray(block.full()) for block in found]


def by_differences(function, given, k: int) -> list[np.ndarray]:
    """d outputs / d input k, by central differences of fourth order."""
    at = arguments(function, given)
    columns = []
    for j in range(len(at[k])):
        rows = []
        for steps in (-2, -1, 1, 2):
            moved = at[k].copy()
            h = 3e-4 * (abs(moved[j]) or 1.0)
            moved[j] += steps * h
            values = function.call([*at[:k], moved, *at[k + 1 :]])
            rows.append([np.asarray(value).ravel() / (12 * h) for value in values])
        columns.append([a - 8 * b + 8 * c - d for a, b, c, d in zip(*rows, strict=True)])
    return [np.stack(column, axis=1) for column in zip(*columns, strict=True)]


@pytest.mark.parametrize("name", NAMES)
def test_jacobians_are_those_of_differences(libraries, name):
    given = moving(name, 2)
    for each in functions_in(name):
        function = function_of(libraries[name], each)
        blocks = jacobians(function, given)
        for k in range(function.n_in()):
            for o, expected in enumerate(by_differences(function, given, k)):
                got = blocks[o * function.n_in() + k]
                size = max(1.0, np.abs(expected).max(initial=0.0))
                assert np.abs(got - expected).max(initial=0.0) < 2e-7 * size, (each, o, function.name_in()[k])


@pytest.mark.parametrize("name", ["double_pendulum", "four_bar"])
def test_jacobians_are_those_of_casadi(libraries, name):
    """The same equations written in CasADi and differentiated by it."""
    from ..oracles import casadi_mechanics  # noqa: PLC0415, needs casadi

    system, given = system_of(name), moving(name, 3)
    oracle = casadi_mechanics.acceleration(getattr(casadi_mechanics, name), system.n, len(given["p"]))
    function = function_of(libraries[name], "acceleration")
    count = function.n_out()
    ours = zip(jacobians(function, given), range(9), strict=False)
    expected = oracle.jacobian().call([*arguments(function, given), *[casadi.DM(0, 0)] * 2])
    for block, k in ours:
        size = np.abs(block).max(initial=1.0)
        assert np.abs(block - expected[k].full()).max(initial=0.0) < 1e-11 * size
        published, own = function.jacobian().sparsity_out(k), oracle.jacobian().sparsity_out(k)
        assert published.is_subset(own), "no more than CasADi finds"
    assert count == (2 if system.m else 1)


def published(function, k: int) -> np.ndarray:
    return np.asarray(casadi.DM(function.jacobian().sparsity_out(k), 1.0).full()) != 0


@pytest.mark.parametrize("name", NAMES)
def test_sparsity_is_what_samples_show(libraries, name):
    """Blocks hold all that differences show to differ from zero, and no entry that is zero in all samples."""
    for each in functions_in(name):
        function = function_of(libraries[name], each)
        count = function.n_in()
        samples = [jacobians(function, moving(name, 4 + k, 10.0 ** (-3 * k))) for k in range(2)]
        for k in range(count):
            for o, by_steps in enumerate(by_differences(function, moving(name, 4), k)):
                held = published(function, o * count + k)
                where = each, function.name_out()[o], function.name_in()[k]
                assert not (np.abs(by_steps[~held]) > 1e-6 * np.abs(by_steps).max(initial=1.0)).any(), where
                shown = np.any([one[o * count + k] != 0.0 for one in samples], axis=0)
                if (name, where[2]) == ("four_bar", "p") and where[1] in ("a", "rate"):
                    shown[:, 4] |= held[:, 4]  # of the density of all bars, by which every force is multiplied
                assert (shown == held).all(), where


X, Y, SPIN = dynamicsymbols("x y phi")
LIFT = em.Table(CubicSpline([-2.0, -1.0, 0.0, 1.0, 2.0], [0.3, -0.2, 0.5, 0.1, 0.4]), name="lift")
SMALL = {
    "twice": Model(
        name="twice", coordinates=[X, Y], kinetic_energy=X.diff() ** 2 / 2 + Y.diff() ** 2, potential_energy=3 * X * Y,
        holonomic_constraints=[X**2 + Y**2 - 1, 2 * X**2 + 2 * Y**2 - 2], initial={X: 0.6, Y: 0.8},
    ),
    "timed": Model(
        name="timed", coordinates=[X, SPIN], kinetic_energy=X.diff() ** 2 / 2 + (1 + X**2) * SPIN.diff() ** 2 / 2,
        potential_energy=X**2 * cos(3 * em.t), forces={SPIN: LIFT(X) * em.t}, outputs={"pull": X.diff(em.t, 2) + SPIN},
    ),
}  # fmt: skip
"""Constraint rows that depend on each other; the time, and a table."""


@pytest.mark.parametrize("name", SMALL)
def test_small_models_of_every_kind(name, tmp_path):
    library = em.export_casadi(SMALL[name], tmp_path / "small.so")
    x, v = np.array([0.6, 0.8]), np.array([0.4, -0.3])
    given = {"x": x, "v": v, "a": np.array([0.2, 0.5]), "multipliers": np.array([0.7, 0.4]), "t": np.array([0.3])}
    given["state"] = np.concatenate([x, v])
    for each in ("acceleration", "rhs", "inverse_dynamics", *(["outputs"] if SMALL[name].outputs else [])):
        function = function_of(library, each)
        assert ("t" in function.name_in()) == (name == "timed")
        blocks = jacobians(function, given)
        for k in range(function.n_in()):
            for o, expected in enumerate(by_differences(function, given, k)):
                assert blocks[o * function.n_in() + k] == pytest.approx(expected, abs=1e-8), (each, k)
    a, _ = em.build(SMALL[name]).acceleration(x, v, 0.3)
    function = function_of(library, "acceleration")
    assert np.asarray(function.call(arguments(function, given))[0]).ravel() == pytest.approx(a, rel=1e-12)


def test_loops_over_columns_find_the_same(libraries, tmp_path, monkeypatch):
    """Mechanisms too large for straight-line text are solved in loops."""
    monkeypatch.setattr(one_piece, "LARGEST", 0)
    looping = em.export_casadi(MODELS / "four_bar.py", tmp_path / "loops.so")
    given = moving("four_bar", 8)
    for name in ("acceleration", "rhs"):
        ours, theirs = (jacobians(function_of(library, name), given) for library in (libraries["four_bar"], looping))
        assert len(ours) == len(theirs) > 0
        for one, other in zip(ours, theirs, strict=True):
            assert one == pytest.approx(other, rel=1e-11, abs=1e-11)


def test_blocks_without_structure_are_empty(libraries):
    """Rates do not depend on some numbers: v on x, tau of a chain on its far masses."""
    rates = function_of(libraries["double_pendulum"], "rhs").jacobian().sparsity_out(0)
    assert rates.nnz() == 2 + 8
    assert function_of(libraries["servo_pendulums"], "rhs").jacobian().sparsity_out(0).nnz() < 100


def test_one_file_needs_no_other(libraries, tmp_path):
    """A user compiles FILE.c strictly, with nothing beside it, and it finds the same."""
    source = em.export_casadi(MODELS / "four_bar.py", tmp_path / "loop.c", parameters=["a", "density"], prefix="loop_")
    flags = ("-std=c11", "-Wall", "-Werror", "-Wno-unused", "-O0", "-fPIC", "-shared")
    subprocess.run([*toolchain().command, *flags, source.name, "-lm", "-o", "loop.so"], cwd=tmp_path, check=True)
    given = moving("four_bar", 7)
    ours, whole = (function_of(path, name) for path, name in
                   ((tmp_path / "loop.so", "loop_acceleration"), (libraries["four_bar"], "acceleration")))  # fmt: skip
    p = given["p"]
    found = ours(given["x"], given["v"], p[[0, 4]])
    assert np.asarray(found[0]) == pytest.approx(np.asarray(whole(given["x"], given["v"], p)[0]), rel=1e-12)
    blocks = jacobians(ours, given | {"p": p[[0, 4]]})
    assert blocks[2] == pytest.approx(jacobians(whole, given)[2][:, [0, 4]], rel=1e-9, abs=1e-9)


def test_threads_share_the_functions(libraries):
    function = function_of(libraries["four_bar"], "acceleration").jacobian()
    given = [moving("four_bar", seed) for seed in range(4)]
    calls = [[one["x"], one["v"], one["p"], casadi.DM(0, 0), casadi.DM(0, 0)] for one in given]
    alone = [np.asarray(function.call(call)[0].full()) for call in calls]
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda k: np.asarray(function.call(calls[k % 4])[0].full()), range(400)))
    assert all((found[k] == alone[k % 4]).all() for k in range(400))


def test_failures_of_a_state_are_failures_of_the_call(libraries):
    """A mass of zero, which the model refuses, and numbers that are not given, are no numbers."""
    function = function_of(libraries["double_pendulum"], "acceleration")
    with pytest.raises(RuntimeError, match="failed"):
        function([0.1, 0.2], [0.0, 0.0], [-1.0, 1.0, 1.0, 1.0, 9.81])
    with pytest.raises(RuntimeError, match="failed"):
        function(x=[0.1, 0.2], v=[0.0, 0.0])  # parameters that are left out are no zeros


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("cam_follower", "whether 'cam' holds, which a run decides"),
        ("block_on_incline", "which a run decides"),
    ],
)
def test_models_with_modes_are_refused_by_name(name, words, tmp_path):
    with pytest.raises(ModelError, match=words):
        em.export_casadi(MODELS / f"{name}.py", tmp_path / "no.c")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"parameters": ["mass"]}, "no parameter 'mass'|parameter"),
        ({"parameters": ["l1", "l1"]}, "'l1' is given twice"),
        ({"prefix": "2"}, "names of C functions"),
        ({"prefix": "em_"}, "those with em_ are ours"),
    ],
)
def test_mistakes_are_named(options, words, tmp_path):
    with pytest.raises(ModelError, match=words):
        em.export_casadi(MODELS / "double_pendulum.py", tmp_path / "no.c", **options)
    with pytest.raises(ModelError, match=r"FILE\.so, or a FILE\.c"):
        em.export_casadi(MODELS / "double_pendulum.py", tmp_path / "no.txt")
    assert list(tmp_path.iterdir()) == []


def test_the_command_writes_them(tmp_path, capsys):
    target = tmp_path / "p.so"
    assert main(["export", str(MODELS / "pendulum.py"), "--casadi", str(target), "--parameters", "none"]) == 0
    assert "casadi.external('acceleration'" in capsys.readouterr().out
    assert function_of(target, "acceleration").name_in() == ["x", "v"]
    for wrong in (["--casadi", str(target), "--rtol", "1e-3"], ["--fmu", str(tmp_path / "p.fmu"), "--prefix", "a"], []):
        assert main(["export", str(MODELS / "pendulum.py"), *wrong]) == 2


def branches() -> Model:
    """Two arms on a turning base."""
    tree = em.Tree()
    link = {"joint": "revolute", "mass": 1.0, "center": (0.2, 0.1, 0), "inertia": (0.02, 0.03, 0.01)}
    base = tree.body("base", axis="z", **link)
    for k, axis in enumerate(("y", "x")):
        upper = tree.body(f"upper{k}", base, at=(0.3 - k, 0, 0.2), axis=axis, **link)
        tree.body(f"lower{k}", upper, at=(0.4, 0, 0), axis="y", **link)
    return Model(name="branches", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                 potential_energy=tree.potential_energy)  # fmt: skip


def test_trees_in_loops_find_the_same(tmp_path, monkeypatch):
    """Large trees, of which C adds the forces and their derivatives in loops, have the zeros of their branches."""
    straight = em.export_casadi(branches(), tmp_path / "straight.so")
    monkeypatch.setattr(link_table, "LARGE", 1)
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / "cache"))
    looping = em.export_casadi(branches(), tmp_path / "looping.so")
    assert "own_state_partials(" in em.export_casadi(branches(), tmp_path / "looping.c").read_text(encoding="utf-8")
    random = np.random.default_rng(3)
    given = {name: random.standard_normal(5) for name in ("x", "v", "a")}
    given["state"] = np.concatenate([given["x"], given["v"]])
    for name in ("acceleration", "rhs", "inverse_dynamics"):
        ours, theirs = (function_of(library, name) for library in (looping, straight))
        for k, (one, other) in enumerate(zip(jacobians(ours, given), jacobians(theirs, given), strict=True)):
            assert one == pytest.approx(other, rel=1e-9, abs=1e-9), (name, k)
    masses = published(function_of(looping, "inverse_dynamics"), 2)
    assert (masses == published(function_of(straight, "inverse_dynamics"), 2)).all()
    assert masses.sum() == 25 - 2 * 4, "the arms do not couple but by the base"
