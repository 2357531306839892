"""Random bodies on feet, with frictions, at rest, sliding, striking: against an enumeration of all modes.

None wrong, none refused where exactly one consistent motion exists, and names where there is none; by ensembles,
steppers and units, too. Along longer runs the four conditions hold at every row.
"""

from collections import Counter
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion.runtime import EvaluationError

from ..support.by_day import SEED
from ..support.fmu_slaves import Unit, fmpy
from ..support.generation import FORMULATIONS
from .contact_cases import FLAVOURS, Case, Shape, drawn
from .contact_models import model_for, rows_of, scaled, shaped, simulated
from .contact_rows import faults, let_go
from .contact_verdicts import FATAL, SPAN, Judged, Verdict, judged, of_refusal, started, state_of

FMICallException = fmpy.fmi1.FMICallException
BLOCK = 20
DAY = (
    Shape(1, 1, 1), Shape(2, 2), Shape(3, 2, 1), Shape(2, 2, law="poisson"), Shape(2, 2, unequal=True),
    Shape(2, 2, 0, False), Shape(3, 3, 0, False), Shape(1, 1, 0, False, True), Shape(3, 2, 0, False, True),
    Shape(4, 0, 2),
)  # fmt: skip
"""A quarter of a block of each by day: 50 cases."""
NIGHT = {
    Shape(1, 0): 10, Shape(1, 1): 50, Shape(1, 0, 2): 20, Shape(1, 1, 2): 20, Shape(2, 0): 20, Shape(2, 1): 50,
    Shape(2, 2): 60, Shape(2, 2, 1): 20, Shape(3, 0): 10, Shape(3, 2, 1): 30, Shape(3, 3): 20, Shape(4, 2): 10,
    Shape(4, 4): 10, Shape(1, 1, 0, unequal=True): 10, Shape(2, 2, 0, unequal=True): 10, Shape(2, 2, law="poisson"): 20,
    Shape(3, 3, law="poisson"): 10, Shape(1, 0, 0, False): 5, Shape(2, 2, 0, False): 30, Shape(3, 3, 0, False): 30,
    Shape(4, 1, 1, False): 10, Shape(1, 1, 0, False, True): 20, Shape(2, 2, 0, False, True): 10,
    Shape(3, 2, 0, False, True): 10, Shape(3, 3, 0, False, True): 5,
}  # fmt: skip
"""So many blocks of each: 10,000 cases."""
FOUND = {
    Shape(1, 1): [362], Shape(1, 1, 2): [333], Shape(2, 2): [207], Shape(2, 2, law="poisson"): [207],
    Shape(3, 2, 1): [272, 275, 420, 452, 585], Shape(3, 3): [169], Shape(3, 3, 0, False): [335],
}  # fmt: skip
"""Judged wrong or refused by night: slips that are left where a start is put on its contacts; a judge who came late."""
ON_THEIR_WAY = {
    Shape(1, 0, 2): [48], Shape(1, 1, 2): [11, 12, 120], Shape(1, 1, 0, unequal=True): [83], Shape(2, 2): [73],
    Shape(3, 3): [8], Shape(2, 2, 0, False, True): [68], Shape(3, 2, 0, False, True): [126],
}  # fmt: skip
"""Longer runs: what idled goes, touches by rounding as a slip stops, lets go of a contact, rocks ever faster; forces
that grow without bound; rolls about the line between two rough feet."""
ALIKE = Shape(2, 2)


def ids(shape: Shape) -> str:
    return shape.name


def verdicts(shape: Shape, seeds: Iterable[int], formulation: str = "lagrange") -> dict[int, Judged]:
    return {seed: judged(case := drawn(shape, seed), started(case, formulation)) for seed in seeds}


def check(shape: Shape, seeds: Iterable[int], formulation: str = "lagrange") -> None:
    found = verdicts(shape, seeds, formulation)
    bad = {seed: one for seed, one in found.items() if one.verdict in FATAL}
    lines = [f"{shape.name} seed {seed}: {one.verdict}: {one.why}" for seed, one in bad.items()]
    assert not bad, "\n".join(lines)
    counts = Counter(one.verdict for one in found.values())
    assert counts[Verdict.BLURRED] <= len(found) // 4, counts


@pytest.mark.parametrize("quarter", [0, *(pytest.param(k, marks=pytest.mark.nightly(SEED)) for k in (1, 2, 3))])
@pytest.mark.parametrize("shape", DAY, ids=ids)
def test_starts_of_random_bodies(shape, quarter):
    check(shape, range(BLOCK)[quarter::4])


@pytest.mark.parametrize("shape", FOUND, ids=ids)
def test_starts_that_the_night_has_found(shape):
    check(shape, FOUND[shape])


@pytest.mark.nightly
@pytest.mark.parametrize(("shape", "block"), [(shape, k) for shape, blocks in NIGHT.items() for k in range(blocks)])
def test_many_starts_of_random_bodies(shape, block):
    check(shape, range(block * BLOCK, (block + 1) * BLOCK), FORMULATIONS[block % len(FORMULATIONS)])


def test_there_are_ten_thousand():
    assert sum(NIGHT.values()) * BLOCK == 10_000
    assert len(DAY) * BLOCK == 200


# --- longer runs ------------------------------------------------------------------------------------------------------


def on_their_way(shape: Shape, seeds: Iterable[int]) -> Iterable[tuple[int, Case]]:
    """Give cases on ground that rests: on it, or above."""
    for seed in seeds:
        case = drawn(shape, seed)
        if case.flavour == "flat":
            yield seed, let_go(case, 0.5 if seed % 2 else 0.0)


def comes_down_ever_sooner(run: em.Solution) -> bool:
    """Whether a run ended among impacts that follow ever faster: rounding decides in which state they end."""
    ends = [np.diff(times[-3:]) for times in run.t_events if len(times) > 2 and run.t[-1] - times[-1] < 1e-4]
    return any(then < 0.5 * before < 1e-3 for before, then in ends)


def check_rows(shape: Shape, seeds: Iterable[int]) -> None:
    wrong = []
    for seed, case in on_their_way(shape, seeds):
        run = simulated(case, 2.0, max_steps=20_000)
        wrong += [f"{shape.name} seed {seed}: {what}" for what in faults(case, run)[:2]]
        if not run.success and not comes_down_ever_sooner(run):
            end = of_refusal(case.body, state_of(rows_of(case, run)[-1]), run.message)
            wrong += [f"{shape.name} seed {seed}: {end.verdict}: {end.why}"] * (end.verdict in FATAL)
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("half", [0, pytest.param(1, marks=pytest.mark.nightly(SEED))])
@pytest.mark.parametrize("shape", [Shape(1, 1, 1), Shape(2, 2), Shape(3, 3, 0, False)], ids=ids)
def test_every_row_satisfies_the_four_conditions(shape, half):
    check_rows(shape, range(12 * half, 12 * (half + 1)))


@pytest.mark.parametrize("shape", ON_THEIR_WAY, ids=ids)
def test_rows_that_the_night_has_found(shape):
    check_rows(shape, ON_THEIR_WAY[shape])


@pytest.mark.nightly
@pytest.mark.parametrize("shape", [shape for shape in NIGHT if shape.contacts < 4], ids=ids)
@pytest.mark.parametrize("block", range(4))
def test_every_row_of_many_satisfies_them(shape, block):
    check_rows(shape, range(60 * block, 60 * (block + 1)))


# --- by ensembles, steppers, units ------------------------------------------------------------------------------------


def alike(seeds: Iterable[int]) -> list[Case]:
    """Cases of one shape in one unit of time."""
    return [replace(drawn(ALIKE, seed), units=(1.0, 1.0, 1.0)) for seed in seeds]


def together(cases: list[Case]) -> dict[str, object]:
    """Return what ensembles and steppers take for cases side by side."""
    each = [scaled(case) for case in cases]
    column = lambda name: {key: [getattr(one, name)[key] for one in each] for key in getattr(each[0], name)}  # noqa: E731
    return {
        **{name: column(name) for name in ("x0", "v0", "parameters")},
        "rtol": 1e-9,
        "atol": 1e-11,
        "max_steps": 5_000,
    }


def alone(case: Case, span: float) -> em.Solution | None:
    """Return a run by itself; None: refused."""
    try:
        run = simulated(case, span)
    except (em.ModelError, EvaluationError):
        return None
    return run if run.success else None


def check_alike(cases: list[Case], span: float, states: list[np.ndarray | None]) -> None:
    """The same motions, and the same refusals, as by runs of their own."""
    for case, found in zip(cases, states, strict=True):
        run = alone(case, span)
        assert (run is None) == (found is None)
        if run is not None and found is not None:
            right = np.concatenate([run.x[:, -1], run.v[:, -1]])
            assert found == pytest.approx(right, rel=1e-8, abs=1e-8)


def check_ensembles(seeds: Iterable[int], span: float) -> None:
    cases = alike(seeds)
    runs = em.simulate_ensemble(shaped(ALIKE), (0.0, span), **together(cases))
    ends = [
        np.concatenate([runs.x[k, :, -1], runs.v[k, :, -1]]) if runs.success[k] else None for k in range(len(cases))
    ]
    check_alike(cases, span, ends)


def check_steppers(seeds: Iterable[int], span: float) -> None:
    cases = alike(seeds)
    steppers = shaped(ALIKE).steppers(len(cases), **together(cases))
    for t in np.linspace(0.0, span, 4)[1:]:
        steppers.advance(float(t))
    failed = set(steppers.failed.tolist())
    ends = [None if k in failed else np.concatenate([steppers.x[k], steppers.v[k]]) for k in range(len(cases))]
    check_alike(cases, span, ends)


def test_ensembles_decide_as_runs_do():
    check_ensembles(range(40), SPAN)


def test_steppers_decide_as_runs_do():
    check_steppers(range(40), SPAN)


def test_a_stepper_decides_as_a_run_does():
    ends: list[np.ndarray | None] = []
    cases = alike(range(20))
    for case in cases:
        one = scaled(case)
        try:
            stepper = shaped(ALIKE).stepper(x0=one.x0, v0=one.v0, parameters=one.parameters, rtol=1e-9, atol=one.atol)
            stepper.advance(SPAN)
        except (em.ModelError, EvaluationError):
            ends.append(None)
        else:
            ends.append(np.concatenate([stepper.x, stepper.v]))
    check_alike(cases, SPAN, ends)


@pytest.mark.nightly
@pytest.mark.parametrize("block", range(5))
def test_many_decide_as_runs_do(block):
    seeds = range(100 * block, 100 * (block + 1))
    check_ensembles(seeds, SPAN)
    check_steppers(seeds, SPAN)


def test_units_decide_as_runs_do(tmp_path, hurried):
    path = em.export_fmu(model_for(ALIKE), tmp_path / "feet.fmu", formulation="lagrange", rtol=1e-9)
    names = ("x", "y", "c", "der(x)", "der(y)", "der(c)")
    for case in alike(range(12)):
        run, one = alone(case, SPAN), scaled(case)
        start = one.parameters | one.x0 | {f"der({name})": value for name, value in one.v0.items()}
        unit = Unit(path, tmp_path / "unit", case.shape.name)
        found = None
        with suppress(FMICallException):
            found = np.array(unit.begin(**start).step(0.0, SPAN).get(*names))
        assert (run is None) == (found is None), case
        if run is not None:
            assert found == pytest.approx(np.concatenate([run.x[:, -1], run.v[:, -1]]), rel=1e-7, abs=1e-7)


def test_all_kinds_are_drawn():
    drawn_kinds = Counter((case.kind, case.flavour) for case in (drawn(ALIKE, seed) for seed in range(60)))
    assert set(drawn_kinds) == {(kind, flavour) for kind, flavours in FLAVOURS.items() for flavour in flavours}
