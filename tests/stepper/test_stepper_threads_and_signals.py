"""Steppers among threads, signals and allocators: what goes on around them is none of their business."""

import shutil
import signal
import subprocess
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from eigenmotion.codegen import compiler

from eigenmotion.building.toolchain import INCLUDE, toolchain

from ..support.generation import STRICT, model_of, system_of
from .test_stepper import stepped


def test_two_at_once_know_nothing_of_each_other():
    system, times = system_of("dual_link"), np.linspace(0, 20, 2001)[1:]
    alone = stepped(system.stepper(), times)
    found: dict[int, np.ndarray] = {}

    def work(k):
        found[k] = stepped(system.stepper(), times)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(3)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert all(np.array_equal(rows, alone) for rows in found.values())


def test_one_stepper_is_one_threads():
    stepper = system_of("dual_link").stepper(rtol=1e-9, max_steps=10**9)
    thread = threading.Thread(target=stepper.advance, args=(3000.0,))
    thread.start()
    refused = []
    while thread.is_alive():
        try:
            stepper.save()
        except RuntimeError as error:
            refused.append(str(error))
            break
    thread.join()
    assert "each thread needs one of its own" in refused[0]
    assert stepper.t == 3000.0


class AlarmError(Exception):
    pass


def test_a_signal_ends_an_advance_which_can_go_on():
    def ring(*_):
        raise AlarmError

    stepper = system_of("dual_link").stepper(max_steps=10**12)
    before = signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.1)
        start = time.perf_counter()
        with pytest.raises(AlarmError):
            stepper.advance(1e7)
        assert time.perf_counter() - start < 30.0
    finally:
        signal.signal(signal.SIGALRM, before)
    t = stepper.t
    assert 0.0 < t < 1e7
    stepper.advance(t + 1.0)
    assert stepper.t == t + 1.0


# --- in C ---

COUNTED = r"""
void *__real_malloc(size_t); void *__real_calloc(size_t, size_t); void *__real_realloc(void *, size_t);
void *__wrap_malloc(size_t a); void *__wrap_calloc(size_t a, size_t b); void *__wrap_realloc(void *p, size_t a);
int allocations;
void *__wrap_malloc(size_t a) { ++allocations; return __real_malloc(a); }
void *__wrap_calloc(size_t a, size_t b) { ++allocations; return __real_calloc(a, b); }
void *__wrap_realloc(void *p, size_t a) { ++allocations; return __real_realloc(p, a); }
"""


def compiled(folder: Path, program: str, *flags: str) -> list[str]:
    for file in compiler.generate(model_of("furuta_pendulum")).files:
        (folder / file.name).write_text(file.text)
    (folder / "control.c").write_text(program)
    command = [*toolchain().command, *STRICT, "-O0", "-ffp-contract=fast", f"-I{INCLUDE}", *flags]
    subprocess.run([*command, "control.c", "furuta_pendulum.c", "-lm", "-o", "plain"], cwd=folder, check=True)
    done = subprocess.run(["./plain"], cwd=folder, capture_output=True, text=True, check=True, env={})
    return done.stdout.splitlines()


PROGRAM = (Path(__file__).parent / "control.c").read_text(encoding="utf-8")


@pytest.mark.skipif(shutil.which("ld") is None, reason="counts calls with the linker's help")
def test_in_c_without_python_nor_memory_taken_on_the_way(tmp_path):
    """The example program, the same motion in Python; between opening and closing nothing is allocated."""
    loop, said = "for (int k = 1; k <= 1000; ++k) {", 'printf("%s: %ld steps'
    counted = PROGRAM.replace("int main(void)", COUNTED + "int main(void)")
    counted = counted.replace(loop, "allocations = 0;\n    " + loop).replace(
        said, "if (allocations) return 6;\n    " + said
    )
    lines = compiled(
        tmp_path, counted, "-D_GNU_SOURCE", *(f"-Wl,--wrap={name}" for name in ("malloc", "calloc", "realloc"))
    )
    stepper = system_of("furuta_pendulum").stepper(rtol=1e-9, atol=1e-9)
    for k in range(1, 1001):
        x, v = stepper.x, stepper.v
        stepper.advance(1e-3 * k, {"u": 0.083 * x[0] + 1.036 * x[1] + 0.057 * v[0] + 0.105 * v[1]})
    assert lines[0] == f"furuta_pendulum: {stepper.nsteps} steps, {stepper.nfev} right-hand sides"
    found = np.array([line.split()[1:] for line in lines[1:]], dtype=float)
    assert np.abs(found - np.column_stack([stepper.x, stepper.v])).max() < 1e-12
