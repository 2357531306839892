"""Rules that leave cases for the night; the end of a run says how many each rule left out."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import pytest
from eigenmotion.codegen.choices import FORMULATIONS

from .generation import COMPILERS, NAMES
from .models_table import BY_NAME, DAILY, HEAVY, Scenario

Cases = dict[str, dict[str, dict[str, pytest.Item]]]
"""Case -> test -> choice -> item."""

MARKED = "marked nightly where they are written"
COMPILER = "other compilers: by day a case that goes by all of them takes one"
HEAVY_MODEL = "heavy models: by day test_heavy_models.py has them"
FORMULATION = (
    "other formulations: by day a file's first case takes eigenfactor and another, the others one of the two, in turn"
)

MODEL = "many models: by day a test that goes by twenty or more takes every other, in turn"
PAGE = "pictures and pages of single models: by day those of cam_follower and lugre_oscillator"
CLOSED_FORM = "closed forms against integration: by day every third model's"
SEED = "random cases: by day the first of each kind"

RANDOM = frozenset({"seed", "block", "quarter", "half"})
"""What a test is parametrised with whose cases are drawn at random."""

MODELS = {*NAMES, *BY_NAME}

BY_ALL = ("test_paper_scene", "test_signs")
"""Files that go by every formulation by day, too."""

EVERY_MODEL = ("test_accelerations_and_multipliers",)
"""What goes by every model by day, too, and by both formulations that `DAILY` has of it."""


def mark_nightly(items: list[pytest.Item]) -> None:
    """Mark what is not for every day as nightly, with the rule that says so."""
    for item in list(_not_in_turn(items, COMPILERS)):
        item.add_marker(pytest.mark.nightly(COMPILER))
    for item in items:
        if rule := _rule_of_models(item):
            item.add_marker(pytest.mark.nightly(rule))
    theirs = [item for item in items if not (item.path.stem in BY_ALL or rule_of(item) or _known(item))]
    for item in list(_not_in_turn(theirs, FORMULATIONS[1:])):
        item.add_marker(pytest.mark.nightly(FORMULATION))
    for item in list(_every_other_model([item for item in items if not (_of_every_model(item) or rule_of(item))])):
        item.add_marker(pytest.mark.nightly(MODEL))
    theirs = [item for item in items if not (item.path.stem in BY_ALL or _of_every_model(item) or rule_of(item))]
    for item in list(_one_of_two(theirs)):
        item.add_marker(pytest.mark.nightly(FORMULATION))


def rule_of(item: pytest.Item) -> str | None:
    """Return the rule by which a case runs at night only."""
    marker = item.get_closest_marker("nightly")
    return marker and (marker.args[0] if marker.args else MARKED)


def is_random(item: pytest.Item) -> bool:
    """Whether this is a random case of the night: of one number of many, or of a block of numbers."""
    return bool(rule_of(item) and hasattr(item, "callspec") and RANDOM & item.callspec.params.keys())


def _rule_of_models(item: pytest.Item) -> str | None:
    """Whether a heavy model takes part, or one of the table in a formulation that is not its own by day."""
    models = {_model_of(one) for one in _given(item)}
    if models & HEAVY:
        return None if item.path.stem == "test_heavy_models" else HEAVY_MODEL
    formulations = set(_given_words(item)).intersection(FORMULATIONS)
    return None if all(formulations <= DAILY[name] for name in models & DAILY.keys()) else FORMULATION


def _not_in_turn(items: list[pytest.Item], choices: Sequence[str]) -> Iterator[pytest.Item]:
    """Give all of a case that goes by several choices but the one whose turn it is.

    Turns follow the order of files in their folder and of cases in their file; tests of a file that have a case in
    common, and so its compiled model, take the same.
    """
    for path, in_file in _cases(items, choices).items():
        first = sorted(path.parent.glob("test_*.py")).index(path)
        for turn, tests in enumerate(in_file.values(), first):
            for by in tests.values():
                there = [one for one in choices if one in by]
                yield from (by[one] for one in there if one != there[turn % len(there)])


def _one_of_two(items: list[pytest.Item]) -> Iterator[pytest.Item]:
    """Give, of all cases of a file but its first, one of the two formulations that are left, in turn."""
    for in_file in _cases(items, FORMULATIONS).values():
        for turn, tests in enumerate(in_file.values()):
            for by in tests.values() if turn else ():
                if len(by) == 2 and FORMULATIONS[0] in by:
                    yield next(item for name, item in by.items() if (name == FORMULATIONS[0]) == bool(turn % 2))


def _cases(items: list[pytest.Item], choices: Sequence[str]) -> dict[Path, Cases]:
    """Return file -> cases, of what goes by one of the choices."""
    cases = defaultdict[Path, Cases](dict)
    for item in items:
        words = [one for one in _given_words(item) if one in choices]
        if len(words) == 1:
            case = item.callspec.id.replace(words[0], "", 1)
            cases[item.path].setdefault(case, {}).setdefault(item.originalname, {})[words[0]] = item
    return cases


def _every_other_model(items: list[pytest.Item]) -> Iterator[pytest.Item]:
    """Give, of a test that goes by many models, the cases of every other one.

    Turns follow the order of tests in their file, so what one test leaves out the next one takes.
    """
    tests = defaultdict[Path, dict[str, dict[str, list[pytest.Item]]]](dict)
    for item in items:
        for name in {_name_of(one) for one in _given(item)} & MODELS:
            tests[item.path].setdefault(item.originalname, {}).setdefault(name, []).append(item)
    for path, in_file in tests.items():
        first = sorted(path.parent.glob("test_*.py")).index(path)
        for turn, by_model in enumerate(in_file.values(), first):
            if len(by_model) >= 20:
                for name in list(by_model)[turn % 2 :: 2]:
                    yield from by_model[name]


def _of_every_model(item: pytest.Item) -> bool:
    """Whether this goes by every model, in both of its formulations of the day."""
    return getattr(item, "originalname", "") in EVERY_MODEL


def _known(item: pytest.Item) -> bool:
    """Whether a model of the table takes part."""
    return any(_model_of(one) in DAILY for one in _given(item))


def _given_words(item: pytest.Item) -> Iterator[str]:
    """Give the strings that a test is parametrised with."""
    return (one for one in _given(item) if isinstance(one, str))


def _given(item: pytest.Item) -> Iterable[object]:
    """Return what a test is parametrised with."""
    return item.callspec.params.values() if hasattr(item, "callspec") else ()


def _name_of(given: object) -> str | None:
    """Return the name of a scenario, whose file others may have in common, or of a file."""
    return given.name if isinstance(given, Scenario) else _model_of(given)


def _model_of(given: object) -> str | None:
    """Return the file that a scenario, a path or a name stands for."""
    if isinstance(given, Scenario):
        return given.file
    return given.stem if isinstance(given, Path) else given if isinstance(given, str) else None
