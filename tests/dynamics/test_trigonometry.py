"""sin and cos of em_trigonometry.h against mpmath, in units of the last place."""

import math
import subprocess

import mpmath
import numpy as np
import pytest

from eigenmotion.building.toolchain import INCLUDE

PROGRAM = """
#include <stdio.h>
#include "numeric/em_trigonometry.h"
int main(void) {
    double a;
    while (scanf("%la", &a) == 1) printf("%a %a\\n", em_sin(a), em_cos(a));
    return 0;
}
"""


@pytest.fixture(scope="module", params=[["-march=native"], []], ids=["native", "portable"])
def computed(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("trigonometry")
    (folder / "main.c").write_text(PROGRAM)
    flags = ["-O3", "-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", *request.param, f"-I{INCLUDE}"]
    subprocess.run(["cc", *flags, "main.c", "-o", "main", "-lm"], cwd=folder, check=True)

    def run(angles):
        text = "\n".join(float(a).hex() for a in angles)
        out = subprocess.run(["./main"], cwd=folder, input=text, capture_output=True, text=True, check=True).stdout
        return np.array([[float.fromhex(word) for word in line.split()] for line in out.splitlines()])

    return run


def angles():
    rng = np.random.default_rng(5)
    near = [math.nextafter(k * math.pi / 2, way) for k in range(-200, 200) for way in (-math.inf, math.inf)]
    spread = [*rng.uniform(-8, 8, 3000), *rng.uniform(-9.9e4, 9.9e4, 3000), *(10.0 ** rng.uniform(-300, 0, 200))]
    return [0.0, -0.0, 1e5, -1e5, 1e22, *near, *spread]


def test_within_two_units_in_the_last_place(computed):
    given = angles()
    with mpmath.workdps(60):
        for angle, (sine, cosine) in zip(given, computed(given), strict=True):
            for value, true in ((sine, mpmath.sin(angle)), (cosine, mpmath.cos(angle))):
                assert abs(mpmath.mpf(value) - true) <= 2 * math.ulp(float(true)) + 1e-26, angle


def test_what_is_not_finite_stays_so(computed):
    assert np.isnan(computed([math.nan, math.inf, -math.inf])).all()
