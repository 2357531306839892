"""Budget of an examination, on clocks that only advance with counted work."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from eigenmotion.models import pendulum

from eigenmotion import StopReason
from eigenmotion.comparison.deadline import NONE, Deadline, TooLateError
from eigenmotion.reference.integration import NotReachedError
from eigenmotion.stability.limits import survey
from eigenmotion.stability.limits.families import families
from eigenmotion.stability.limits.subject import subject


class Work:
    """A clock, and runs of `needed` steps that take `each` seconds."""

    def __init__(self, needed: int = 10_000, each: float = 1e-3) -> None:
        self.time, self.needed, self.each, self.steps = 0.0, needed, each, 0

    def now(self) -> float:
        return self.time

    def run(self, most: int) -> SimpleNamespace:
        done = min(most, self.needed)
        self.steps, self.time = done, self.time + done * self.each
        reached = done == self.needed
        return SimpleNamespace(stop=StopReason.FINISHED if reached else StopReason.TOO_MANY_STEPS)


def test_a_run_that_fits_is_run_whole():
    work = Work()
    assert Deadline(20.0, work.now).complete(work.run, 50_000).stop is StopReason.FINISHED
    assert work.time <= 10.0 + 2.5  # the trial is a part of the run's most steps


@pytest.mark.parametrize("seconds", [0.5, 5.0, 9.0])
def test_a_run_that_does_not_fit_ends_at_the_deadline(seconds):
    work = Work()
    with pytest.raises(TooLateError):
        Deadline(seconds, work.now).complete(work.run, 50_000)
    assert work.time <= max(seconds, 2.5) + 1e-9


def test_too_many_steps_is_an_outcome_where_there_was_time_for_all():
    work = Work(needed=10**9)
    assert Deadline(1e3, work.now).complete(work.run, 20_000).stop is StopReason.TOO_MANY_STEPS
    assert work.steps == 20_000


def test_without_a_deadline_nothing_is_cut():
    assert NONE.complete(Work(needed=10**6).run, 10**6).stop is StopReason.FINISHED


def test_no_run_begins_after_the_deadline():
    work = Work()
    work.time = 2.0
    for begin in (Deadline(1.0, work.now).run, Deadline(1.0, work.now).complete):
        with pytest.raises(TooLateError):
            begin(work.run, 100)
    assert work.steps == 0


def points(seconds: float, budget: float, monkeypatch) -> tuple[int, float]:
    """Return how many points were run within a budget, and the time that they took, if each takes some seconds."""
    work = Work()

    def examined(case, value, seconds_each=0.0, **_):
        work.time += seconds
        return SimpleNamespace(cells=(1,))

    monkeypatch.setattr(survey, "examine", examined)
    cases = {"a": None}
    pace = survey.Pace(Deadline(budget, work.now))
    done = list(survey._stream(cases, [("a", float(k)) for k in range(100)], pace, 1.0, workers=1))
    return len(done), work.time


@pytest.mark.parametrize(("seconds", "budget"), [(1.0, 10.0), (3.0, 10.0), (7.0, 60.0), (0.1, 5.0)])
def test_points_take_the_budget_and_no_more_than_half_a_point(seconds, budget, monkeypatch):
    count, taken = points(seconds, budget, monkeypatch)
    assert taken <= budget + seconds / 2
    assert taken >= budget - seconds
    assert count == round(taken / seconds)


def test_the_first_point_is_run_however_long_it_takes(monkeypatch):
    assert points(50.0, 1.0, monkeypatch) == (1, 50.0)


def test_references_and_runs_end_at_the_deadline():
    """A clock that is past it: neither the reference nor a run goes on, and no run is judged."""
    late = Deadline(0.0, lambda: 1.0)
    own = subject(pendulum.model, ("lagrange",), {}, 1.0, patience=20.0)
    stopped = replace(own, deadline=late)
    trial = stopped.trial("")
    with pytest.raises(NotReachedError, match="takes too long"):
        trial.truth.rows(trial.row, trial.times, 0)
    with pytest.raises(NotReachedError, match="do not end in time"):
        trial.otherwise("a reason").rows(trial.row, trial.times, 0)
    point = survey.examine(families(stopped, ())[0], 1e-8)
    assert point.cells == ()
    assert point.left_out == 6


def test_points_without_runs_are_no_results(monkeypatch):
    """A point for which no time was left when it began stays among those that were not run."""

    def examined(case, value, **_):
        return SimpleNamespace(cells=(1,) if value == 1.0 else ())

    monkeypatch.setattr(survey, "examine", examined)
    cases = [SimpleNamespace(name="a", title="a")]
    clock = survey._Clock(survey.time.monotonic(), 60.0, lambda *_: None)
    places = [("a", float(k)) for k in range(3)]
    assert list(survey._examined(cases, places, clock, 1)[0]) == [("a", 1.0)]
    assert list(survey._examined(cases, places[:1], clock, 1)[0]) == [("a", 0.0)]
