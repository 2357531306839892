"""Judgement of a motion that seems to close: it is run once more, and measured."""

from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from .cycle import Cycle
from .multipliers import Multipliers, multipliers_of
from .newton import Found, Search, growth, noise, size
from .periodic_problem import Problem
from .quantities import TIME
from .returns import NoReturnError, Return, returned, run
from .segments import chain_of, joined
from .time_dependence import unrepeated

_LATER = 0.31830988
"""Part of a period by which the other run begins later, if equations do not depend on time."""
_MET = 1e-6
"""Value of a condition that is not listed where a search fails."""
_TOUCHES = 1e-3
"""Change of a section's expression in a period, by its rate at the start and relative to sizes, that is none."""
_UNSTABLE = 1e6
"""Growth of deviations in one period above which a single run decides little."""


def judged(search: Search, found: Found, note: str = "") -> Cycle:
    """Return the result of a search, after a run at another tolerance and, if it must not matter, time."""
    search = replace(search, problem=found.last.problem)
    return replace(_judged(search, found, note), search=search)


def _judged(search: Search, found: Found, note: str) -> Cycle:
    problem, section = search.problem, search.section
    failure, last = found.failure or _other_side(search, found.last), found.last
    nothing = Multipliers(np.zeros(0, dtype=complex), np.zeros(0))
    if failure:
        failure = failure if "no cycle" in failure else f"not converged: {failure}{_unmet(search, last)}"
        return _cycle(problem, last, failure, nothing, False)
    problem.count.most += 3 + len(found.nodes)
    later = problem.t if problem.clock else problem.t + _LATER * last.period
    other = replace(problem, by=()).with_tolerance(max(problem.rtol / 10.0, 1e-13), last.scale, later)
    try:
        if found.nodes:
            check = joined(other, chain_of(other, found.nodes, last.period))
        else:
            check = returned(other, section, last.q, last.period)
    except NoReturnError as error:
        return _cycle(problem, last, f"not converged: the motion cannot be run again: {error}", nothing, False)
    if check.order != last.order:
        names = problem.c.events
        orders = " but ".join(", ".join(names[k] for k in one) or "none" for one in (last.order, check.order))
        message = f"not converged: events differ between runs of different tolerance: {orders}"
        return _cycle(problem, check, message, nothing, False)
    if size(problem, check) > 10.0 * noise(problem, check):
        message = f"not converged: another run does not close, by {size(problem, check):.3g} of the motion"
        return _cycle(problem, check, message, nothing, False)
    if problem.clock and (failure := unrepeated(other, section, check, found.nodes)):
        message = f"no cycle: {failure}. Give the period of the forcing, or a multiple"
        return _cycle(problem, check, message, nothing, False)
    multipliers = multipliers_of(other, check)
    return _cycle(problem, check, _words(problem, check, multipliers) + note, multipliers, True)


def _unmet(search: Search, last: Return) -> str:
    """Return the values of conditions that are not met, or ""."""
    numbers = last.problem.numbers(last.q, last.period)
    values = [(one.text, float(one.value(numbers))) for one in search.unknowns.conditions]
    texts = [f"{text} = {value:.4g}" for text, value in values if not abs(value) <= _MET]
    return f". Conditions are not met: {', '.join(texts)}" if texts else ""


def _other_side(search: Search, last: Return) -> str:
    """Return that the motion does not cross its section as stated, or ""."""
    problem, section = last.problem, search.section
    if section.quantity is None:
        return ""
    slopes = section.quantity.slopes(problem.numbers(last.q, last.period))
    places = dict(zip(problem.names, problem.places, strict=True))
    terms = [slope * last.flow[places[name]] for name, slope in slopes.items() if name in places]
    sizes = [slope * last.scale[places[name]] for name, slope in slopes.items() if name in places]
    rate = sum(terms) + slopes.get(TIME, 0.0)
    if abs(rate) * last.period <= _TOUCHES * float(np.abs(sizes).max(initial=0.0)):
        return f"the motion touches {section.quantity.text} = 0, and does not cross it. Give another section"
    if rate * section.direction < 0.0:
        which = "decreases" if section.direction > 0 else "increases"
        return f"where the motion starts, {section.quantity.text} {which}. Give direction={-section.direction}"
    return ""


def _words(problem: Problem, one: Return, multipliers: Multipliers) -> str:
    kind = {True: "stable", False: "unstable", None: "neither stable nor unstable by its multipliers"}
    words = [kind[multipliers.stable]]
    if multipliers.neutral:
        beside = "" if problem.clock else " beside that of the motion"
        many = f"{multipliers.neutral} multipliers are 1" if multipliers.neutral > 1 else "a multiplier is 1"
        words.append(f"{many}{beside}: one of a family of cycles, or at a bifurcation")
    if growth(one) > _UNSTABLE:
        words.append(f"deviations grow by {growth(one):.2g} in a period, so small multipliers are uncertain")
    return "; ".join(words)


def _cycle(problem: Problem, one: Return, message: str, multipliers: Multipliers, success: bool) -> Cycle:
    c, n = problem.c, problem.c.n_coordinates
    x0, rates = problem.start(one.q)
    solution = None
    if success:
        problem.count.most += 1
        solution = run(problem, one.q, problem.t + one.period, dense_output=True)
    stable = multipliers.stable if success else None
    return Cycle(
        problem.system, success, message, problem.t, one.period, _named(c.coordinates, x0),
        _named(c.coordinates[:n], rates), multipliers.values, multipliers.errors, stable, multipliers.neutral,
        {c.coordinates[k]: float(one.end[k] - one.q[k]) for k in problem.free_advance}, size(problem, one),
        tuple(c.events[k] for k in one.order), solution, problem.count.runs,
        _named(c.parameters, np.array(problem.prepared.parameters)),
        {name: problem.value(name) for name in problem.by},
    )  # fmt: skip


def _named(names: tuple[str, ...], values: Vector) -> dict[str, float]:
    return dict(zip(names, values.tolist(), strict=True))
