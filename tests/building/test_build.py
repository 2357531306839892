"""Sources -> compiled System: the cache, two at once, and failures that say why."""

import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from eigenmotion.codegen.render.emit import Sources
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.building.build import cached_sources, compiled, make
from eigenmotion.building.request import generator_hash, request
from eigenmotion.building.shared_library import load
from eigenmotion.building.toolchain import EXTENSION_SUFFIX, INCLUDE, OPTIMISED, Toolchain, toolchain

ROOT = Path(__file__).parents[2]
PENDULUM = ROOT / "models" / "pendulum.py"


@pytest.fixture(autouse=True)
def in_a_hurry(shared_cache, monkeypatch):
    """One cache for these tests, none of the user's."""
    monkeypatch.setenv("EIGENMOTION_CACHE", shared_cache)
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-O0")


@pytest.fixture
def own_cache(in_a_hurry, tmp_path, monkeypatch):
    """An empty one."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def swing(name="swing", gravity=9.81):
    angle = dynamicsymbols("angle")
    m, g, length = symbols("m g l", positive=True)
    return em.Model(
        name=name,
        coordinates=[angle],
        kinetic_energy=m * length**2 * angle.diff() ** 2 / 2,
        potential_energy=-m * g * length * cos(angle),
        parameters={m: 2.0, g: gravity, length: 0.5},
        initial={angle: 0.3},
    )


def entries(cache, kind):
    return sorted(path.name for path in (cache / kind).glob("*"))


def test_a_model_becomes_a_system():
    acceleration, _ = em.build(swing()).acceleration([0.3], [0.0])
    assert acceleration == pytest.approx([-9.81 / 0.5 * np.sin(0.3)], rel=1e-14)


def test_what_differs_is_built_apart_and_nothing_twice(own_cache, monkeypatch):
    def built(formulation="lagrange", **given):
        return em.build(swing(**given), formulation=formulation)

    built()
    assert built(gravity=1.62).parameters["g"] == 1.62
    assert built("eigenfactor").formulation == "eigenfactor"
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-O0 -DOTHER")
    built()
    before = entries(own_cache, "binaries"), entries(own_cache, "sources")
    assert list(map(len, before)) == [4, 3]  # flags make another binary of the same sources
    for name in ("compile_in", "_generate"):
        monkeypatch.delattr(sys.modules["eigenmotion.building.build"], name)
    em.build(swing(), formulation="lagrange", flags="-O0 -DOTHER")
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-O0")
    assert built().parameters["g"] == 9.81
    assert (entries(own_cache, "binaries"), entries(own_cache, "sources")) == before


def test_all_models_share_the_stepper(own_cache):
    """Compiled once, by each compiler with each of its flags; what models run is their own."""
    for gravity in (9.81, 1.62):
        acceleration, _ = em.build(swing(gravity=gravity)).acceleration([0.3], [0.0])
        assert acceleration == pytest.approx([-gravity / 0.5 * np.sin(0.3)], rel=1e-14)
    assert len(entries(own_cache, "binaries")) == 2
    assert em.build(swing(), formulation="lagrange").simulate((0.0, 0.1)).success
    assert em.build(Path(__file__).parents[2] / "models" / "four_bar.py").simulate((0.0, 0.1)).success
    assert len(entries(own_cache, "steppers")) == 1
    em.build(swing(), flags="-O0 -DOTHER")
    assert len(entries(own_cache, "steppers")) == 2


def test_the_processor_is_part_of_the_compilers_identity():
    native = toolchain()
    other = replace(native, flags=("-march=x86-64",)) if sys.platform == "linux" else replace(native, flags=("-O0",))
    assert native.identity == toolchain().identity
    assert native.identity != other.identity


@pytest.mark.parametrize("package", ["sympy", "jinja2"])
def test_what_writes_the_sources_is_part_of_what_finds_them(monkeypatch, package):
    before = generator_hash.__wrapped__()
    known = generator_hash.__wrapped__.__globals__["version"]
    monkeypatch.setitem(generator_hash.__wrapped__.__globals__, "version",
                        lambda name: "another" if name == package else known(name))  # fmt: skip
    assert generator_hash.__wrapped__() != before


def test_output_gets_sources_and_an_importable_module(tmp_path):
    """Which pickles by its name; and nothing of the process is changed."""
    before = Path.cwd(), list(sys.path), dict(os.environ)
    em.build(PENDULUM, output=tmp_path / "generated")
    assert (Path.cwd(), list(sys.path), dict(os.environ)) == before
    names = {path.name.partition(".")[0] + path.suffix for path in (tmp_path / "generated").iterdir()}
    assert names == {"pendulum.c", "pendulum.h", "pendulum.pyx", f"pendulum{Path(EXTENSION_SUFFIX).suffix}"}
    script = ("import pickle; from generated import pendulum as one; text = pickle.dumps(one.system);"
              "print(one.system.name, pickle.loads(text) is one.system, b'generated.pendulum' in text)")  # fmt: skip
    done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["pendulum", "True", "True"]


def test_the_cython_source_makes_the_same_module(tmp_path):
    """For those who build it themselves: NAME.pyx by Cython, with NAME.c beside it."""
    for file in cached_sources(request(PENDULUM)).files:
        (tmp_path / file.name).write_text(file.text)
    (tmp_path / "glue").mkdir()  # NAME.c is there already
    headers = [f"-I{path}" for path in (INCLUDE, sysconfig.get_path("include"))]
    target = f"pendulum{EXTENSION_SUFFIX}"
    for command in (
        [sys.executable, "-m", "cython", "-3", "--module-name=pendulum", "pendulum.pyx", "-o", "glue/pendulum.c"],
        ["cc", "-O0", "-fPIC", "-shared", *headers, "glue/pendulum.c", "pendulum.c", "-lm", "-o", target],
    ):
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    script = "from pendulum import system; print(system.name, system.compiled.recipe.args)"
    done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "pendulum ('pendulum',)"


def test_two_processes_build_the_same_model_at_once(own_cache):
    script = f"import eigenmotion as em; print(em.build({str(PENDULUM)!r}).state()[0])"
    started = [
        subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    answers = [process.communicate(timeout=1200) for process in started]
    assert [process.returncode for process in started] == [0, 0], answers
    assert answers[0] == answers[1]
    assert len(entries(own_cache, "binaries")) == 1


def test_threads_build_the_same_model_at_once(own_cache):
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(em.build, [swing("of_threads")] * 4))
    assert len(set(map(id, found))) == 1
    assert len(entries(own_cache, "binaries")) == 1


@pytest.mark.parametrize("where", ["CC", "argument"])
def test_a_missing_compiler_is_named_with_a_remedy(own_cache, monkeypatch, where):
    if where == "CC":
        monkeypatch.setenv("CC", "no-such-compiler -m64")
    with pytest.raises(em.CompilerNotFoundError, match=r"no-such-compiler not found\. Install GCC") as caught:
        em.build(swing(), compiler="no-such-compiler" if where == "argument" else None)
    assert isinstance(caught.value, em.ModelError)
    assert isinstance(caught.value, em.BuildError)
    assert not own_cache.exists()


def test_no_compiler_at_all(monkeypatch, tmp_path):
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("eigenmotion.building.toolchain.find_spec", lambda name: None)
    with pytest.raises(
        em.CompilerNotFoundError, match=r"cc gcc clang not found.*pip install 'eigenmotion\[compiler\]'"
    ):
        em.build(swing())


def with_function(text: str) -> Sources:
    """The sources of a swing with a function more."""
    sources = cached_sources(request(swing()))
    files = (replace(f, text=f"{f.text}\n{text}\n") if f.name == "swing.c" else f for f in sources.files)
    return replace(sources, files=tuple(files))


def test_a_failed_compilation_shows_the_compilers_words(own_cache):
    with pytest.raises(em.BuildError) as caught:
        compiled(with_function("int broken(void) { return undeclared_name; }"), toolchain())
    assert "undeclared_name" in str(caught.value)
    assert "the command was: " in str(caught.value)
    assert entries(own_cache, "binaries") == []


def test_a_warning_is_no_failure():
    """What a compiler of tomorrow finds to say is nothing that whoever runs a model could mend."""
    idle = "static int idle(int n) { int unset[2]; if (n) unset[0] = 1; return unset[0] < (unsigned)n; }"
    assert load(compiled(with_function(idle), toolchain())).n == 1


def test_flags_that_a_compiler_does_not_know_are_left_out(tmp_path):
    script = tmp_path / "old-cc"
    script.write_text('#!/bin/sh\ncase "$*" in *slp*|*march*) echo "unknown option" >&2; exit 1;; esac\nexec cc "$@"\n')
    script.chmod(0o755)
    kept = toolchain(str(script)).optimised
    assert kept == tuple(flag for flag in OPTIMISED if "slp" not in flag and "march" not in flag)
    assert len(kept) == len(OPTIMISED) - 2
    assert em.build(swing(), compiler=str(script)).n == 1
    assert toolchain("cc").optimised == OPTIMISED


def test_a_compiler_is_asked_about_itself_once_until_it_is_another(tmp_path):
    script, log = tmp_path / "counting-cc", tmp_path / "log"

    def write(more: str) -> None:
        script.write_text(f'#!/bin/sh\necho >> {log}\nexec cc {more} "$@"\n')
        script.chmod(0o755)

    write("")
    first = toolchain(str(script)).identity
    asked = len(log.read_text())
    assert asked > 0
    assert toolchain(str(script)).identity == first
    assert len(log.read_text()) == asked
    write("-DANOTHER")
    assert toolchain(str(script)).identity != first


@pytest.mark.parametrize("what", ["compiler", "flags"])
@pytest.mark.parametrize("given", ["'", 3, "a\0b"])
def test_what_is_no_command_is_named(what, given):
    with pytest.raises(em.BuildError, match=what):
        em.build(swing(), **{what: given})


def test_a_compiler_given_by_a_relative_path_is_found_from_everywhere(tmp_path, monkeypatch):
    (tmp_path / "cc").symlink_to(shutil.which("cc"))
    monkeypatch.chdir(tmp_path)
    assert em.build(swing(), compiler="./cc").n == 1


def test_an_output_folder_that_cannot_be_written_to_is_named(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(em.BuildError, match=r"output folder .*file"):
        em.build(PENDULUM, output=tmp_path / "file")
    with pytest.raises(em.BuildError, match="output is 3"):
        em.build(PENDULUM, output=3)


def test_keywords_go_to_the_models_function():
    chain = ROOT / "models" / "chain.py"
    assert em.build(chain, n=2, flags="-O0").n == 2
    with pytest.raises(em.ModelError, match="no argument `links`"):
        em.build(chain, links=2)
    with pytest.raises(em.ModelError, match=r"unknown option 'formulatoin'.*Did you mean 'formulation'"):
        em.build(swing(), formulatoin="lagrange")


def test_headers_name_no_file_that_is_not_there():
    first = cached_sources(request(swing(), formulation="lagrange")).files[1].text.splitlines()[0]
    assert "swing.py" not in first
    assert "eigenmotion.build(<Model swing>, formulation='lagrange'" in first


@pytest.mark.parametrize("name", ["Python", "code", "EOF", "Py_None", "a" * 200])
def test_a_model_may_be_called_like_a_header_a_function_or_a_macro(name):
    assert em.build(swing(name), formulation="lagrange", flags="-O0").name == name


@pytest.mark.parametrize("name", ["__init__", "__main__", "cython", "em_x", "a" * 201])
def test_other_names_are_refused(name):
    with pytest.raises(em.ModelError, match=r"Model .*(Choose another|at most 200)"):
        swing(name)


def test_a_failed_build_leaves_the_output_alone(tmp_path):
    with pytest.raises(em.BuildError, match="no-such-flag"):
        make(request(PENDULUM), Toolchain(("cc",), ("-fno-such-flag",)), tmp_path / "generated")
    assert not (tmp_path / "generated").exists()


def test_a_compiler_that_dies_is_reported_with_its_exit_code(tmp_path):
    script = tmp_path / "crash"
    script.write_text("#!/bin/sh\nexit 70\n")
    script.chmod(0o755)
    with pytest.raises(em.BuildError, match="exit code 70"):
        em.build(swing(), compiler=str(script))


@pytest.mark.skipif(shutil.which("clang") is None, reason="needs Clang")
def test_clang_builds_it_too():
    assert em.build(swing(), compiler="clang").n == 1


def test_no_room_has_the_name_of_a_function():
    """The import system binds a loaded submodule to the package, over a function of its name."""
    script = (
        "import eigenmotion as em, pkgutil; print(*{m.name for m in pkgutil.iter_modules(em.__path__)} & {*em._HOME})"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def test_every_public_name_is_there():
    for name in ("Model", "ModelError", "Event", "t", "multiplier", "load_model", "build", "simulate", "System",
                 "Solution", "StopReason", "BuildError"):  # fmt: skip
        assert getattr(em, name) is not None
        assert name in dir(em)
    with pytest.raises(AttributeError, match="no attribute 'absent'"):
        _ = em.absent


SLOW_COMPILER = r"""#!/bin/sh
case "$*" in *.c\ -o*.o*) sleep 600 > {alive} & echo $! >> {started}; wait;; esac
exec {compiler} "$@"
"""


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="signals of POSIX")
def test_ctrl_c_ends_compilers(own_cache, tmp_path):
    """A signal to this process alone, as by a notebook: compilers are killed, no other starts, nothing is left."""
    started, alive, script = tmp_path / "started", tmp_path / "alive", tmp_path / "slow-cc"
    os.mkfifo(alive)
    reader = os.open(alive, os.O_RDONLY | os.O_NONBLOCK)
    compiler = shutil.which("cc") or "gcc"
    script.write_text(SLOW_COMPILER.format(started=started, alive=alive, compiler=compiler), encoding="ascii")
    script.chmod(0o700)
    environment = {**os.environ, "CC": str(script)}
    with subprocess.Popen([sys.executable, "-m", "eigenmotion", "build", str(PENDULUM)], env=environment, text=True,
                          stderr=subprocess.PIPE, start_new_session=True) as build:  # fmt: skip
        for _ in range(600):
            if started.exists() and started.read_text(encoding="ascii").count("\n") >= 2:
                break
            time.sleep(0.1)
        begun = started.read_text(encoding="ascii").split()
        with pytest.raises(BlockingIOError):  # there are writers
            os.read(reader, 1)
        os.kill(build.pid, signal.SIGINT)
        _, words = build.communicate(timeout=60)
    assert "interrupted" in words
    assert build.returncode in (130, -signal.SIGINT)  # CPython ends so if an `exec` of an import was interrupted
    assert begun == started.read_text(encoding="ascii").split()
    assert os.read(reader, 1) == b""  # no process can write
    os.close(reader)
    assert not [path for path in own_cache.glob("*/.*") if path.is_dir()]
