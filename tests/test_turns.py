"""Units of one build are compiled as cores become free, and the one that takes longest does not wait for others."""

import sys
from concurrent.futures import ThreadPoolExecutor
from concurrent.futures import TimeoutError as Late
from contextlib import ExitStack

import pytest

from eigenmotion.building.errors import BuildError
from eigenmotion.building.toolchain import Toolchain
from eigenmotion.building.turns import Briefly, Turns


@pytest.fixture
def one_core(monkeypatch):
    """A compiler that says what it is to compile, on one core."""
    tools, asked = Toolchain(("cc",)), []

    def compiler(_, *arguments, **__):
        asked.append(arguments[-1])
        if "bad_model.o" in arguments:
            raise BuildError("bad")

    monkeypatch.setattr(Toolchain, "_run", compiler)
    monkeypatch.setattr(Toolchain, "optimised", ())
    object.__setattr__(tools, "_turns", Turns(1))
    return tools, asked


def test_the_stepper_takes_the_turn_kept_for_it_and_others_wait(one_core, tmp_path):
    tools, asked = one_core
    with ThreadPoolExecutor() as pool, tools.stepper_first():
        model = pool.submit(tools.compile_unit, tmp_path, "a", "model")
        with pytest.raises(Late):
            model.result(0.1)
        assert tools.compile_unit(tmp_path, "a", "stepper") == "a_stepper.o"
        assert model.result(10.0) == "a_model.o"
    assert asked == ["a_stepper.o", "a_model.o"]


def test_a_turn_kept_for_nothing_is_given_back(one_core, tmp_path):
    tools, _ = one_core
    with tools.stepper_first():
        pass
    with pytest.raises(ZeroDivisionError), tools.stepper_first():
        raise ZeroDivisionError
    assert tools.compile_unit(tmp_path, "a", "model") == "a_model.o"
    assert tools.compile_unit(tmp_path, "a", "stepper") == "a_stepper.o"


def test_a_unit_that_fails_gives_its_turn_back(one_core, tmp_path):
    tools, _ = one_core
    with pytest.raises(BuildError, match="bad"):
        tools.compile_unit(tmp_path, "bad", "model")
    assert tools.compile_unit(tmp_path, "a", "model") == "a_model.o"


def test_whoever_waits_already_takes_the_turn_that_is_kept():
    """Else whoever keeps it could wait for what that one is about to leave in the cache, and that one for the turn."""
    turns = Turns(1)

    def take() -> bool:
        with turns.taken(kept=True):
            return True

    with ThreadPoolExecutor() as pool, ExitStack() as another, ExitStack() as keeper:
        another.enter_context(turns.taken(kept=False))
        waits = pool.submit(take)
        with pytest.raises(Late):
            waits.result(0.1)
        with turns._changed:  # nobody gets between the two
            another.close()
            keeper.enter_context(turns.keeping())
        assert waits.result(10.0)
    with turns.taken(kept=False):
        pass


def test_turns_on_the_interpreter_are_short_until_the_last_has_left():
    before, briefly = sys.getswitchinterval(), Briefly()
    with briefly:
        with pytest.raises(ZeroDivisionError), briefly:
            raise ZeroDivisionError
        assert sys.getswitchinterval() == pytest.approx(Briefly.SECONDS)
    assert sys.getswitchinterval() == before


def test_turns_that_are_shorter_already_stay_so():
    before = sys.getswitchinterval()
    sys.setswitchinterval(Briefly.SECONDS / 10)
    try:
        with Briefly():
            assert sys.getswitchinterval() == pytest.approx(Briefly.SECONDS / 10)
        assert sys.getswitchinterval() == pytest.approx(Briefly.SECONDS / 10)
    finally:
        sys.setswitchinterval(before)
