"""The dense algebra of the headers as users compile it, for NumPy: every function, every size, every compiler.

GCC 12 once ranked the rows of each Delta of four rows wrongly where it vectorised straight-line code for AVX-512.
"""

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

from eigenmotion.building.toolchain import INCLUDE, STANDARD, toolchain

from ...support.generation import COMPILERS

HERE = Path(__file__).parent
SIZES = range(1, 9)


def each(sizes=SIZES, by_night=(5, 7)):
    """Parameters of a fixture: (compiler, n); by day in turn, the even sizes, those of whole vectors, by GCC.

    What is left of a vector is one, two or three numbers: by day at sizes below 5, and at 6.
    """
    params = [
        pytest.param(
            (compiler, n),
            marks=() if COMPILERS[n % len(COMPILERS)] == compiler and n not in by_night else pytest.mark.nightly,
        )
        for compiler in COMPILERS
        for n in sizes
    ]
    return {"params": params, "ids": lambda one: f"{one[0]}-{one[1]}"}


TINY = 1e-11
DOUBLES = ("factor_error", "gap", "time_to_crossing", "time_of_block", "worst_factors")
"""What returns one."""


class Kernels:
    """The compiled functions on arrays; those that return doubles are named."""

    def __init__(self, library: Path) -> None:
        self._library = ctypes.CDLL(str(library))
        for name in DOUBLES:
            if hasattr(self._library, name):
                getattr(self._library, name).restype = ctypes.c_double

    def __call__(self, name, *arguments):
        return getattr(self._library, name)(
            *(one.ctypes.data_as(ctypes.c_void_p) if isinstance(one, np.ndarray) else one for one in arguments)
        )


def kernels_of(subject, compiler, n, folder):
    """(kernels, n): SUBJECT.c at the default flags."""
    library = folder / f"{subject}.so"
    flags = (*STANDARD, *toolchain(compiler).optimised, "-fPIC", "-shared", f"-DSIZE={n}", f"-I{INCLUDE}")
    subprocess.run([compiler, *flags, str(HERE / f"{subject}.c"), "-lm", "-o", str(library)], check=True)
    return Kernels(library), n


def definite(random, n):
    """A positive definite matrix, eigenvalues apart, and its eigenfactors with rows at random."""
    C = np.linalg.qr(random.normal(size=(n, n)))[0]
    s = np.sqrt(random.permutation(np.arange(1, n + 1) + random.uniform(-0.3, 0.3, n)))
    M = C.T * s**2 @ C
    return (M + M.T) / 2, np.ascontiguousarray(C), s


def cases(n, count=100):
    random = np.random.default_rng(n)
    for _ in range(count):
        yield random, *definite(random, n)


def near(found, right):
    assert np.abs(found - right).max(initial=0.0) <= TINY * max(1.0, np.abs(right).max(initial=0.0))


def triangular(M):
    L = np.linalg.cholesky(M)
    return L, 1.0 / np.diag(L)
