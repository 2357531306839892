"""Search for a periodic motion."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.differentiation import variable_name
from ...arguments.named_values import Vector, is_named, spelled, unknown
from ...arguments.options import is_system, no_system
from ...arguments.tables import refuse_tables
from ...codegen.model.normalise import ModelError, number, shown
from ...compiled.compiled_system import CompiledSystem
from ..equilibrium.assemble import assemble
from .cycle import Cycle
from .judgement import judged
from .newton import Found, Search, Unknowns, converged, noise
from .period_guess import at_event, at_section, first_motion
from .periodic_problem import NO_LIMIT, Count, Problem, named_values
from .quantities import PERIOD, TIME, Quantity, quantity_of, stated_period
from .returns import NoReturnError, Return, Section, firings, returned, run
from .segments import found_in_segments, number_of_segments
from .symmetry import symmetry_of
from .time_dependence import advancing, check_symmetry, depends_on_time, is_constant

_LATER = 10
"""Number of periods after which a search begins again,"""
_AGAIN = 3
"""and how often."""
_FEW = 3
"""Number of segments below which one run is enough."""
_PARTS = 60
"""Largest number of periods that a guess may have taken for one."""


def find_cycle(
    system: CompiledSystem,
    *,
    x0: Mapping[Any, float] | ArrayLike | None = None,
    v0: Mapping[Any, float] | ArrayLike | None = None,
    period: Any = None,
    section: Any = None,
    direction: int | None = None,
    t: float = 0.0,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | None = None,
    free: Sequence[Any] | None = None,
    conditions: Sequence[Any] | None = None,
    symmetry: Mapping[Any, Any] | None = None,
    method: str = "dop853",
    rtol: float = 1e-11,
    atol: Any = None,
    max_runs: int = 100,
    segments: int | None = None,
) -> Cycle:
    """Return a periodic motion near a guess, by Newton's method with exact derivatives of the runs.

    Motions go through events, impacts, contacts and friction; their derivatives do, too. Constraints hold at the start.

    Parameters
    ----------
    x0, v0
        A guess of the start, over the model's `initial`; x0 may also name states.
    period
        [s] A guess, or None: the first return. If equations depend on time, by an input that is a signal for example,
        the period is required and exact: that of the forcing or a multiple. It is checked: the motion must repeat in
        the next period, too, as far as the samples of a signal reach. With an event as section, the guess says
        how often the event happens in a period.
    section
        The name of an event of the model: motions start right after it and end right after it. Or the name of a
        coordinate, rate ("theta'") or state that keeps the value of the guess at the start. Or an expression of these,
        of parameters and of `em.t` that is zero at the start, in SymPy or as text: "theta - 2*phi'". None: the start
        moves across the motion only. If equations depend on time, the time of the start is found, too.
    direction
        With an expression as section: 1 if it increases through zero where the motion starts, -1 if it decreases; None:
        as where the motion from x0, v0 first crosses the section.
    t
        Start [s], for equations that depend on time.
    free
        Names of what may vary, of coordinates, rates, states, "period", parameters, constant inputs and "t". What is
        not free keeps the value of the guess, which selects a member of a family, as of a pendulum's swings. None: the
        state and the period; these vary, too, if only parameters, inputs or "t" are named. A mapping has guesses of
        parameters and inputs: {"gamma": 0.02}.
    conditions
        Expressions that are zero at the start, of coordinates, rates, states, parameters, constant inputs, t and
        period, in SymPy or as text: "period - 1.2". There must be one for each parameter or input that is free. If
        there is one less, and no forcing gives the period, `period` is exact: the motion has that one.
    symmetry
        Coordinate or state -> its value after a period, as an expression of their values before: {"x": "x + L"} for
        one that advances, {"left": "right", "right": "left"} for a step after which legs change roles. Coordinates on
        which nothing depends advance freely without it: `Cycle.advance`.
    rtol, atol, method
        As in `simulate`; atol is by default rtol times the size of the motion.
    max_runs
        Number of runs after which the search ends; with segments, of each round.
    segments
        Number of segments of a period, whose starts are unknowns, too: for motions from which deviations grow so fast
        that one run goes astray. None: one, and as many as the growth asks for if that fails. With an event as section,
        there is one.

    Returns
    -------
    Cycle
        Also if no motion that closes was found: see `success` and `message`.

    Raises
    ------
    ModelError
        Unknown names; an inconsistent start; no period for equations that depend on time; the motion does not return;
        the symmetry is none of the equations; fewer conditions than names that are free.

    Notes
    -----
    Deviations are measured relative to the sizes of coordinates and rates along the motion, so units make no
    difference. Multipliers are the eigenvalues of the derivative of the motion over a period in independent coordinates
    and velocities. Hartman, Ordinary Differential Equations, chapter IX.

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/rimless_wheel.py")
    >>> cycle = em.find_cycle(system, x0={"theta": -0.3}, v0={"theta": 1.2}, section="step")
    >>> cycle.stable, cycle.multipliers.real.round(9)
    (True, array([0.5]))
    """
    if not is_system(system):
        raise no_system("find_cycle", system)
    with np.errstate(all="ignore"):  # numbers that are not finite are reported by name
        options = {"method": method} | ({} if atol is None else {"atol": atol})
        given = (*_with_guesses(system, parameters, inputs, free), number(t, "t"))
        problem, q = _problem(system, (x0, v0), given[2], given[:2], symmetry, options,
                              (number(rtol, "rtol"), max_runs))  # fmt: skip
        known = (*problem.c.inputs, *problem.c.parameters)
        problem = replace(problem, stated_period=stated_period(problem.c.name, period, known))
        guess = None if period is None else _period(problem, period)
        if guess is not None and not guess > 0.0:
            raise ModelError(f"{system.name}: period is {guess:g}. Give a positive time")
        where = _section(problem, section, direction)
        return _searched(problem, q, guess, (where, (free, conditions), _checked(problem, segments, section)))


def _with_guesses(system: CompiledSystem, parameters: Any, inputs: Any, free: Any) -> tuple[Any, Any]:
    """Return parameters and inputs with the guesses of what is free."""
    if not is_named(free):
        return parameters, inputs
    c, guesses = system.compiled, {spelled(name): value for name, value in free.items()}
    known = (*c.inputs, *c.parameters)
    if wrong := set(guesses) - set(known):
        raise ModelError(f"{c.name}: {unknown('guess in free', wrong, known)} Guesses of the state are x0 and v0")
    values = {name: number(value, f"guess of {name!r}") for name, value in guesses.items()}
    return tuple(
        named_values(given, names) | {name: value for name, value in values.items() if name in names}
        for given, names in ((parameters, c.parameters), (inputs, c.inputs))
    )  # type: ignore[return-value]


def _period(problem: Problem, period: Any) -> float:
    stated = problem.stated_period
    return float(stated.value(problem.constants)) if stated else number(period, "period")


def _problem(system: CompiledSystem, start: tuple[Any, Any], t: float, given: tuple[Any, Any], symmetry: Any,
             options: dict[str, Any], limits: tuple[float, int]) -> tuple[Problem, Vector]:  # fmt: skip
    problem, q = problem_of(system, start, t, given, options)
    stated = symmetry_of(system.compiled, problem.prepared, symmetry)
    return replace(problem, symmetry=stated, rtol=limits[0], count=Count(limits[1])).with_tolerance(limits[0], None), q


def problem_of(system: CompiledSystem, start: tuple[Any, Any], t: float, given: tuple[Any, Any],
               options: dict[str, Any]) -> tuple[Problem, Vector]:  # fmt: skip
    """Return the problem of motions from a start (x0, v0) with given parameters and inputs, and the start (2 n,)."""
    prepared = system.prepare_both(*given)[0]
    x, v = (each.copy() for each in system.begin(*start, t, prepared))
    if system.m:
        x[: system.n], v[: system.n] = assemble(system, *start, t=t, parameters=prepared)
    symmetry = symmetry_of(system.compiled, prepared, None)
    problem = Problem(system, *given, prepared, t, symmetry, False, options, options.get("rtol", 0.0), Count(NO_LIMIT))
    q = np.concatenate([x, v])
    q[system.compiled.n_coordinates : system.compiled.n] = 0.0
    return problem, q


def _checked(problem: Problem, segments: Any, section: Any) -> int | None:
    if segments is None or (isinstance(segments, int) and segments >= 1 and str(section) not in problem.c.events):
        return segments
    raise ModelError(f"{problem.c.name}: segments is {shown(segments)}. Give a whole number from 1 on, and no event as "
                     "section")  # fmt: skip


def _searched(problem: Problem, q: Vector, guess: float | None, choices: tuple[Section, tuple[Any, Any], int | None]
              ) -> Cycle:  # fmt: skip
    (where, (free, conditions), segments), c = choices, problem.c
    size_of_time = guess or 10.0 * problem.point(q, problem.t, problem.prepared).time
    problem = replace(problem, clock=depends_on_time(problem, q, size_of_time))
    if problem.clock and guess is None:
        raise ModelError(f"{c.name}: the equations depend on time. Give the period, that of the forcing or a multiple")
    check_symmetry(problem, q, guess or size_of_time)
    stated = range(problem.c.n_coordinates) if problem.symmetry.stated else ()
    candidates = tuple(k for k in advancing(problem, q, size_of_time) if k not in stated and k != where.place)
    problem = replace(problem, free_advance=candidates)
    unknowns = _unknowns(problem, where, free, _conditions(problem, conditions), guess)
    if segments is not None and segments > 1 and (unknowns.names or unknowns.conditions or where.quantity):
        raise ModelError(f"{c.name}: segments is {segments}, and parameters are free, or conditions or a section are "
                         "expressions: these are for one segment. Leave out segments")  # fmt: skip
    problem = replace(problem, by=unknowns.names)
    problem, q, period, where = _begun(problem, where, q, guess)
    try:
        problem, here = _first(problem, where, q, period)
        search = Search(problem, where, unknowns)
        if segments is not None and segments > 1:
            return _in_segments(search, here, segments)
        found = _closed(search, here, guess is None)
        no_use = segments or where.event is not None or unknowns.kept or unknowns.names or "no cycle" in found.message
        if found.success or no_use or where.quantity or unknowns.conditions:
            return found
        problem.count.most = NO_LIMIT
        many = number_of_segments(problem, here)
        if many < _FEW:
            return found
        other = _in_segments(search, here, many)
        return other if other.success else found
    except NoReturnError as error:
        raise ModelError(f"{c.name}: no motion from x0, v0 over {period:.6g} s: {error}") from error


def _in_segments(search: Search, first: Return, count: int) -> Cycle:
    """Return the cycle near a motion, of whose period there are several segments."""
    search.problem.count.most *= count
    found = found_in_segments(search, first, count)
    return judged(search, found, f"; in {count} segments")


def _closed(search: Search, first: Return, guessed: bool) -> Cycle:
    """Return the cycle near a motion, or else near what the motion has become some periods later."""
    problem, where, unknowns = search.problem, search.section, search.unknowns
    here, later, count = first, 0, problem.count
    share = max(1, count.most // (_AGAIN + 1))
    count.until = count.runs + share
    found = converged(search, here)
    while found.failure and later < _LATER * _AGAIN and not unknowns.kept:
        count.until = NO_LIMIT
        try:
            here = _later(problem, where, here)
        except NoReturnError:
            break
        later += _LATER
        count.until = NO_LIMIT if later == _LATER * _AGAIN else count.runs + share
        found = converged(search, here)
    count.until = NO_LIMIT
    whole = any(PERIOD in one.names for one in unknowns.conditions)
    if guessed and where.event is None and not found.failure and not problem.symmetry.stated and not whole:
        found = _shortest(search, found)
    return judged(search, found, f"; the motion from x0, v0, {later} periods later" if later else "")


def _later(problem: Problem, where: Section, here: Return) -> Return:
    """Return the motion some periods later."""
    if where.event is not None:
        for _ in range(_LATER):
            q = problem.symmetry.back(here.end, here.q, problem.free_advance)
            problem = replace(problem, t=problem.t + here.period) if problem.clock else problem
            here = returned(problem, where, q, here.period)
        return here
    q, period = here.q, here.period
    for _ in range(_LATER):
        end = problem.rows(run(problem, q, problem.t + period))[-1]
        q = problem.symmetry.back(end, q, problem.free_advance)
    return returned(problem, where, q, period)


def _shortest(search: Search, found: Found) -> Found:
    """Return the motion over the shortest period, where several were found as one."""
    last, problem, where = found.last, found.last.problem, search.section
    parts = np.arange(_PARTS, 1, -1)
    try:
        rows = problem.rows(run(problem, last.q, problem.t + last.period, t_eval=problem.t + last.period / parts))
        gaps = np.abs((rows - last.q) / last.scale)[:, problem.own].max(axis=1)
        near = np.flatnonzero(gaps <= 1e3 * noise(problem, last))
        if not len(near):
            return found
        part = returned(problem, where, last.q, last.period / float(parts[near[0]]))
        shorter = converged(search, part)
    except NoReturnError:
        return found
    return found if shorter.failure else shorter


def _begun(problem: Problem, where: Section, q: Vector, guess: float | None
           ) -> tuple[Problem, Vector, float, Section]:  # fmt: skip
    """Return the problem, the start, the period and the section of the first motion."""
    if where.quantity is not None:
        q, t, where = at_section(problem, where, q, guess)
        problem = replace(problem, t=t) if problem.clock else problem
    elif problem.clock and where.event is not None and not problem.c.acting[where.event]:
        q, t = at_event(problem, where.event, q, guess or 0.0)
        problem = replace(problem, t=t)
    if guess is None:
        return problem, *first_motion(problem, where, q)
    if where.event is None:
        return problem, q, guess, where
    q, once, where = first_motion(problem, where, q)
    try:
        times = firings(problem, run(problem, q, problem.t + 1.5 * max(guess, once)), where.event or 0, once)
    except NoReturnError as error:
        raise ModelError(f"{problem.c.name}: the motion from x0, v0 does not return: {error}") from error
    count = int(np.abs(times - problem.t - guess).argmin())
    return problem, q, float(times[count]) - problem.t, replace(where, times=count + 1)


def _first(problem: Problem, where: Section, q: Vector, period: float) -> tuple[Problem, Any]:
    """Return the first motion, with tolerances relative to its sizes, and without advances that are none."""
    rough = returned(problem, where, q, period)
    problem = replace(problem, free_advance=tuple(k for k in problem.free_advance if rough.drift[k] < 1e-7))
    problem = problem.with_tolerance(problem.rtol, rough.scale)
    return problem, returned(problem, where, rough.q, rough.period)


def _section(problem: Problem, section: Any, direction: Any) -> Section:
    c = problem.c
    if direction is not None and direction not in (1, -1):
        raise ModelError(f"{c.name}: direction is {shown(direction)}. Give 1 or -1")
    places = dict(zip(problem.names, problem.places, strict=True))
    named = section is not None and (str(section) in c.events or variable_name(section) in places)
    if direction is not None and (section is None or named):
        what = "there is no section" if section is None else f"section {str(section)!r} is a name"
        raise ModelError(f"{c.name}: direction is {direction}, but {what}. Give a section that is an expression")
    if section is None:
        return Section()
    if str(section) in c.events:
        return Section(event=c.events.index(str(section)))
    if named:
        return Section(place=places[variable_name(section)])
    if isinstance(section, str) and re.fullmatch(r"[\w\s']+", section) and section not in (*c.parameters, TIME):
        raise ModelError(f"{c.name}: {unknown('section', [section], (*c.events, *places))} Or give an expression")
    quantity = quantity_of(c.name, "section", section, (*places, *c.parameters, TIME, *c.events))
    if not set(quantity.names) & {*places, TIME}:
        raise ModelError(f"{c.name}: section {quantity.text} does not depend on the state. Name a coordinate, a rate "
                         "or a state in it")  # fmt: skip
    if events := set(quantity.names) & set(c.events):
        raise ModelError(f"{c.name}: section {quantity.text} contains the event {min(events)!r}. Give its name alone, "
                         "or an expression of coordinates and rates")  # fmt: skip
    return Section(quantity=quantity, direction=direction or 0)


def _conditions(problem: Problem, conditions: Any) -> tuple[Quantity, ...]:
    if conditions is None:
        return ()
    c = problem.c
    if isinstance(conditions, str) or not isinstance(conditions, Sequence):
        raise ModelError(f"{c.name}: conditions is {shown(conditions)}. Give a list of expressions that are zero")
    known = (*problem.names, *c.inputs, *c.parameters, TIME, PERIOD)
    return tuple(quantity_of(c.name, "conditions", one, known) for one in conditions)


def _unknowns(problem: Problem, where: Section, free: Any, conditions: tuple[Quantity, ...], guess: float | None
              ) -> Unknowns:  # fmt: skip
    """Return what varies. A period that forcing gives does not; on a section, the time of the start does."""
    c = problem.c
    names, kept, timed = _freed(problem, free)
    sections = (where.event, where.place, where.quantity) != (None, None, None)
    if problem.clock and sections and TIME not in names:
        names = (*names, TIME)
    exact = _exact_period(problem, where, guess)
    missing = len(names) - len(conditions) - (problem.clock and sections)
    if exact is not None and (problem.clock or missing == 1):
        conditions, missing = (*conditions, exact), missing if problem.clock else 0
    if missing > 0:
        remedy = "" if problem.clock or guess else ", or the period"
        raise ModelError(f"{c.name}: free names {', '.join(names)}, and {len(conditions)} conditions are stated. State "
                         f"one for each, an expression that is zero at the start{remedy}")  # fmt: skip
    sizes = tuple(abs(problem.value(name)) or 1.0 for name in names if name != TIME)
    sizes = (*sizes, *([guess or 1.0] if TIME in names else []))
    return Unknowns(timed, kept, names, sizes, conditions)


def _exact_period(problem: Problem, where: Section, guess: float | None) -> Quantity | None:
    """Return the condition that the period is the given one, where it is not so by the equations, or None."""
    if guess is None or (problem.clock and where.event is None):
        return None
    stated = problem.stated_period
    text = f"{PERIOD} - ({stated.text})" if stated else f"{PERIOD} - {guess!r}"
    return quantity_of(problem.c.name, PERIOD, text, (PERIOD, *problem.c.inputs, *problem.c.parameters))


def _freed(problem: Problem, free: Any) -> tuple[tuple[str, ...], tuple[int, ...], bool]:
    """Return the names of constants that are free, the places that keep their values, and whether the period varies."""
    c = problem.c
    if free is None:
        return (), (), not problem.clock
    if isinstance(free, str) or not (is_named(free) or isinstance(free, Sequence)):
        raise ModelError(f"{c.name}: free is {shown(free)}. Give a list of names")
    places = dict(zip(problem.names, problem.places, strict=True))
    constants = (*c.inputs, *c.parameters, TIME)
    known = (*places, *(() if problem.clock else (PERIOD,)), *constants)
    given = dict.fromkeys(PERIOD if str(one) == PERIOD else variable_name(one) for one in free)
    if wrong := set(given) - set(known):
        listed = tuple(name for name in known if name != TIME or problem.clock)
        raise ModelError(f"{c.name}: {unknown('name in free', wrong, listed)}")
    names = tuple(name for name in given if name in constants and name not in places and name != PERIOD)
    refuse_tables(c, names, "free")
    if TIME in names and not problem.clock:
        raise ModelError(f"{c.name}: free names t, but the equations do not depend on time. Leave it out")
    if moved := set(names) & problem.symmetry.names:
        raise ModelError(f"{c.name}: the symmetry depends on {min(moved)}, so it cannot be free")
    if sampled := [name for name in names if name in c.inputs and not is_constant(problem, name)]:
        raise ModelError(f"{c.name}: input {sampled[0]!r} is a signal. Only a constant input can be free")
    names = (*(name for name in names if name != TIME), *(name for name in names if name == TIME))
    if set(given) <= set(names):
        return names, (), not problem.clock
    return names, tuple(k for name, k in places.items() if name not in given), PERIOD in given
