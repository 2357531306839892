"""The extra `compiler`: models are compiled where GCC and Clang are not to be found, with the ziglang wheel."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import eigenmotion as em
from eigenmotion.building.toolchain import INCLUDE, OPTIMISED, ZIG, Toolchain, toolchain, zig_is_there

PENDULUM = Path(__file__).parents[2] / "models" / "pendulum.py"
HERE = pytest.mark.skipif(not zig_is_there(), reason="the ziglang wheel is not installed")
SCRIPT = """
import shutil, sys
import eigenmotion as em
assert not any(map(shutil.which, ("cc", "gcc", "clang")))
run = em.build(sys.argv[1], formulation="lagrange").simulate((0.0, 5.0), rtol=1e-10, atol=1e-10)
print(run.success, *map(repr, run.x[:, -1].tolist()))
"""


def hidden(folder: Path) -> dict[str, str]:
    """An environment in which no compiler is on the PATH."""
    rest = {name: value for name, value in os.environ.items() if name not in ("CC", "EIGENMOTION_CFLAGS")}
    return rest | {"PATH": str(folder), "EIGENMOTION_CACHE": str(folder / "cache")}


@HERE
@pytest.mark.parametrize("flags", ["-O0", pytest.param("", marks=pytest.mark.nightly)], ids=["hurried", "default"])
def test_a_model_is_built_and_runs_without_gcc_and_clang(flags, tmp_path):
    """It is the motion that the compiler of this machine gives."""
    done = subprocess.run([sys.executable, "-c", SCRIPT, str(PENDULUM)], capture_output=True, text=True, check=False,
                          env=hidden(tmp_path) | {"EIGENMOTION_CFLAGS": flags})  # fmt: skip
    assert done.returncode == 0, done.stderr
    success, *x = done.stdout.split()
    native = em.build(PENDULUM, formulation="lagrange", flags="-O0").simulate((0.0, 5.0), rtol=1e-10, atol=1e-10)
    assert success == "True"
    assert list(map(float, x)) == pytest.approx(native.x[:, -1].tolist(), abs=1e-9)


@HERE
def test_it_takes_the_flags_that_gcc_and_clang_take(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False)
    tools = toolchain()
    assert tools.command == ZIG
    gccs_alone = {"--param=vect-epilogues-nomask=0"}
    assert tools.optimised == tuple(flag for flag in OPTIMISED if flag not in gccs_alone)


@pytest.mark.nightly
@HERE
def test_it_does_not_stop_at_what_c_leaves_open(tmp_path):
    """As it would where nothing is optimised; asked for, it does."""
    (tmp_path / "open.c").write_text("int main(int c, char **v) { (void)v; return (2147483647 + c) == 0; }\n")
    for flags, survives in (((), True), (("-fsanitize=undefined",), False)):
        command = (*Toolchain(ZIG).command, "-O0", *flags, "open.c", "-o", "open")
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
        done = subprocess.run([tmp_path / "open"], capture_output=True, check=False)
        assert (done.returncode == 0) is survives


def test_compilers_on_the_path_come_first():
    assert "ziglang" not in toolchain("cc").command


@HERE
@pytest.mark.nightly
@pytest.mark.parametrize("macro", ["EM_UNIT=EM_MODEL", "EM_UNIT=EM_RHS", "EM_UNIT=EM_STEPPER", "EM_ON_LANES"])
@pytest.mark.parametrize("target", ["aarch64-linux-gnu", "aarch64-macos", "x86_64-windows-gnu"])
def test_generated_c_compiles_for_other_systems(target, macro, tmp_path):
    """As numbers, and in the vectors of their processors; nothing of it is run."""
    source = Path(__file__).parents[2] / "generated" / "dual_link.c"
    command = (*ZIG, "-target", target, "-std=c11", "-O2", "-Wall", "-Werror", f"-I{INCLUDE}", f"-D{macro}")
    done = subprocess.run([*command, "-c", str(source), "-o", "model.o"], cwd=tmp_path, capture_output=True, text=True,
                          check=False)  # fmt: skip
    assert done.returncode == 0, done.stderr
