"""The picture of `eigenmotion explain --plot`: what it shows of M, A and savings, and whether it is legible."""

from itertools import combinations

import numpy as np
import pytest
from eigenmotion.codegen.anatomy import Variation

from eigenmotion.building.operation_count import operations
from eigenmotion.building.request import request
from eigenmotion.cli import main
from eigenmotion.explanation import figure, savings_of, table

from ..support.generation import system_of
from ..support.models_table import MODELS

NAMES = ("dual_link", "four_bar", "elastic_pendulum", "bouncing_ball", "robot_arm", "polar_particle")


def explained(name):
    return savings_of(request(MODELS / f"{name}.py"))


@pytest.fixture(scope="module")
def found():
    """Counting compiles five programs a model: only those of one model are counted."""
    made = {}

    def one(name):
        if name not in made:
            with pytest.MonkeyPatch.context() as patch:
                if name != "dual_link":
                    patch.setattr("eigenmotion.explanation.savings.operations", lambda sources: 123456)
                made[name] = explained(name)
        return made[name]

    return one


@pytest.mark.parametrize("name", ["dual_link", "four_bar", "elastic_pendulum"])
def test_entries_are_what_numbers_say(found, name):
    """Zero, constant and varying entries of M and A, against compiled values at random positions."""
    system, random = system_of(name), np.random.default_rng(1)
    places = [random.uniform(0.5, 1.5, system.n) for _ in range(6)]
    for entries, values in (
        (found(name).anatomy.M, np.array([system.mass_matrix(x) for x in places])),
        (found(name).anatomy.A, np.array([system.pfaffian(x)[0] for x in places])),
    ):
        for (i, j), kind in np.ndenumerate(np.array(entries, dtype=object)):
            several = values[:, i, j]
            is_zero, is_constant = not several.any(), np.ptp(several) <= 1e-12 * np.abs(several).max()
            seen = Variation.ABSENT if is_zero else Variation.CONSTANT if is_constant else Variation.VARYING
            assert kind is seen, (i, j)


def test_states_and_operations_with_and_without_savings(found):
    prices = {one.name: one for one in found("dual_link").prices}
    assert {name: one.n_state for name, one in prices.items()} == {
        "as generated": 20, "without uncoupled": 28, "without fixed": 20, "without single": 20, "without all three": 28,
    }  # fmt: skip
    if found("dual_link").obstacle:
        pytest.skip(found("dual_link").obstacle)
    base, whole = prices["as generated"].operations, prices["without all three"].operations
    assert base == operations(request(MODELS / "dual_link.py").sources(whole=False))
    assert whole == prices["without uncoupled"].operations > 2 * base
    assert f"M as one block: 28 states, {whole:,} operations" in table(found("dual_link"))


def test_without_a_counting_compiler_it_is_said(monkeypatch):
    monkeypatch.setattr("eigenmotion.building.operation_count.which", lambda name: None)
    made = explained("elastic_pendulum")
    assert "apt-get install clang" in table(made)
    assert {one.operations for one in made.prices} == {None}


def texts(drawn):
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415, an optional package

    FigureCanvasAgg(drawn).draw()
    renderer = drawn.canvas.get_renderer()
    ticks = [tick for axes in drawn.axes for axis in (axes.xaxis, axes.yaxis) for tick in axis.get_ticklabels()]
    return [(t.get_text(), t.get_window_extent(renderer)) for t in (*drawn.texts, *ticks) if t.get_text()]


@pytest.mark.parametrize("name", NAMES)
def test_the_picture_is_legible(found, name):
    pytest.importorskip("matplotlib")
    drawn = figure(found(name))
    written = texts(drawn)
    assert set(found(name).anatomy.names) <= {text for text, _ in written}
    assert_legible(drawn, written)


def assert_legible(drawn, written):
    for text, box in written:
        assert box.x0 >= 0, text
        assert box.y0 >= 0, text
        assert box.x1 <= drawn.bbox.x1, text
        assert box.y1 <= drawn.bbox.y1, text
    for (one, a), (two, b) in combinations(written, 2):
        assert not a.shrunk(0.9, 0.9).overlaps(b.shrunk(0.9, 0.9)), f"{one!r} and {two!r} overlap"


def test_forty_coordinates_are_legible(found):
    """The structure of a small model, repeated: names are thinned out, blocks counted."""
    pytest.importorskip("matplotlib")
    from dataclasses import replace  # noqa: PLC0415

    small = found("elastic_pendulum")
    n, zero = 20, Variation.ABSENT
    M = tuple(tuple(small.anatomy.M[i % 2][j % 2] if i // 2 == j // 2 else zero for j in range(2 * n))
              for i in range(2 * n))  # fmt: skip
    blocks = tuple(replace(b, coordinates=tuple(2 * k + c for c in b.coordinates))
                   for k in range(n) for b in small.anatomy.blocks)  # fmt: skip
    names = tuple(f"a_rather_long_name_of_coordinate_{k}" for k in range(2 * n))
    large = replace(small, anatomy=replace(small.anatomy, names=names, M=M, blocks=blocks))
    drawn = figure(large)
    written = texts(drawn)
    assert_legible(drawn, written)
    assert "20 blocks: constant, factored once" in {text for text, _ in written}


def test_the_command(tmp_path, capsys, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr("eigenmotion.explanation.savings.operations", lambda sources: 7)
    file = tmp_path / "structure.svg"
    assert main(["explain", str(MODELS / "elastic_pendulum.py"), "--plot", str(file)]) == 0
    assert file.read_text().count("<svg") == 1
    assert "Savings, each switched off alone" in capsys.readouterr().out
    assert main(["explain", str(MODELS / "elastic_pendulum.py"), "--plot", "a.txt"]) == 2
    assert main(["explain", str(MODELS / "elastic_pendulum.py"), "--plot", str(file), "--latex"]) == 2
