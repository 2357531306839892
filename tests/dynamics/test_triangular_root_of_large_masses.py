"""Accepted steps of a large M: by the long kernels of the triangular root, which are written and compiled once.

Here those of small models count as long.
"""

from contextlib import contextmanager

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.kernel import kernel

from eigenmotion import build, simulate_ensemble

from ..support.generation import COMPILERS, loaded, model_of, states, system_of

FREE = ("chain", "double_pendulum", "furuta_pendulum", "heavy_top", "puma", "rigid_body", "spatial_arm", "veering")
"""Models without rows, of which some block turns; two read inputs."""
OF_ITS_OWN = "void settled_masses("


@contextmanager
def all_are_long():
    """Count every kernel as long."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kernel, "LONG", 1)
        yield


def written(name, formulation="eigenfactor"):
    """Return the files of a model."""
    with all_are_long():
        return compiler.generate(model_of(name), Choices(formulation))


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky"])
@pytest.mark.parametrize("name", FREE)
def test_all_is_the_same(name, formulation):
    sources = written(name, formulation)
    assert OF_ITS_OWN not in sources.files[1].text
    once, twice = loaded(sources, "-O0"), system_of(name, formulation)
    for x, _, t in states(twice, 3):
        found, right = once.mass_matrix(x, t), twice.mass_matrix(x, t)
        size = np.sqrt(np.outer(right.diagonal(), right.diagonal()))
        np.testing.assert_allclose(found / size, right / size, rtol=0, atol=1e-15)  # sums that kernels share differ
    times = np.linspace(0.0, 1.0, 11)  # of rows: the first steps are a matter of rounding, and so is where others end
    ends = [system.simulate((0.0, 1.0), method="dop853", rtol=1e-11, t_eval=times) for system in (once, twice)]
    assert ends[0].success
    assert abs(ends[0].n_bounded - ends[1].n_bounded) <= 2
    np.testing.assert_allclose(ends[0].x, ends[1].x, rtol=0, atol=1e-9)


def test_some_steps_ask_for_rates():
    """Else the test above would not see them."""
    assert system_of("spatial_arm").simulate((0.0, 1.0), method="dop853", rtol=1e-7).n_bounded > 0


def test_rates_are_of_their_own_where_those_of_the_root_read_inputs():
    """Whoever accepts a step does not know them."""
    assert "void settled_rates(" in written("furuta_pendulum").files[1].text
    assert "void settled_rates(" not in written("chain").files[1].text


@pytest.mark.parametrize("name", ["four_bar", "pendulum", "governor"])
def test_others_keep_theirs(name):
    """Rows want A and b with M; what is fixed or single has no such root."""
    assert "EM_NOINLINE_KERNEL_EXPORT" not in written(name).files[1].text


@pytest.mark.parametrize("one", COMPILERS)
def test_units_apart_and_lanes(one, monkeypatch, tmp_path):
    """As users get them."""
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path))
    monkeypatch.setenv("CC", one)
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-O0 -Wall -Wextra -Werror")
    with all_are_long():
        system = build(model_of("spatial_arm"))
    starts = system.initial[0] + np.linspace(0.0, 0.1, 8)[:, None]
    members = simulate_ensemble(system, (0.0, 1.0), x0=starts, rtol=1e-8, method="dop853")
    assert members.success.all()
    for start, end in zip(starts, members.x, strict=True):
        alone = system.simulate((0.0, 1.0), x0=start, rtol=1e-8, method="dop853")
        np.testing.assert_allclose(end[..., -1], alone.x[:, -1], rtol=0, atol=1e-6)
