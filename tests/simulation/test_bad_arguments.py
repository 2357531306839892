"""Bad arguments of public functions: each ends with an error of ours that names the argument, and none is taken."""

from collections import defaultdict
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.runtime import EvaluationError

from ..support.generation import system_for

Case = tuple[str, str, str, Callable[[], object]]

q, r, u = dynamicsymbols("q r u")
k, c = sympy.symbols("k c")
OURS = (em.ModelError, EvaluationError)
HUGE = 10**400
INFINITE = ("nan", "inf", "sympy nan", "sympy inf")  # solvers try such states
READ = (
    "digits", "bytes", "truth", "numpy truth", "numpy complex", "all digits", "truths", "all complex", "dates", "date",
    "masked", "sympy huge",
)  # fmt: skip
"""What the right-hand side takes as NumPy reads it: it is called in loops, and looks at its arguments if they fail."""
START: dict[str, Any] = {"x": [0.5, 0.0], "v": [0.0, 0.0]}
BEGIN: dict[str, Any] = {"x0": [0.5, 0.0], "v0": [0.0, 0.0]}
PLACE: dict[str, Any] = {"x": [0.5, 0.0]}
FUNCTIONS = {
    "state": BEGIN, "start": BEGIN, "project_initial_state": BEGIN, "mass_matrix": PLACE, "pfaffian": PLACE,
    "mass_matrix_gradient": PLACE, "eigenfactor_gradient": PLACE, "acceleration": START, "energy": START,
    "jacobi_integral": START, "eta_sensitivity": START,
}  # fmt: skip
MODEL: dict[str, Any] = {
    "name": "oddities",
    "coordinates": [q, r],
    "kinetic_energy": (q.diff() ** 2 + (2 + sympy.cos(q)) * r.diff() ** 2) / 2,
    "potential_energy": k * q**2 / 2,
    "forces": {q: u},
    "nonholonomic_constraints": [r.diff() - c * q.diff()],
    "parameters": {k: 3.0, c: 0.5},
    "inputs": {u: 0.0},
    "outputs": {"sum": q + r},
    "events": {"crossing": q},
    "initial": {q: 0.5},
}
TAKEN = {  # what of the odd values below an argument of Model may well be given
    "name": ("text",), "forces": ("numbers",), "scales": ("numbers",), "holonomic_constraints": ("a sum",),
    "outputs": ("mapping", "pairs of text", "text keys"), "events": ("mapping", "pairs of text", "text keys"),
}  # fmt: skip


@cache
def system() -> em.System:
    return system_for(em.Model(**MODEL))


def run(**given: Any) -> em.Solution:
    return em.simulate(system(), **({"t_span": (0.0, 0.1)} | given))


def no_numbers(*but: str) -> dict[str, Any]:
    """What is not a finite real number, made anew: a generator serves once."""
    given = {
        "text": "x", "digits": "1.5", "bytes": b"1", "none": None, "list": [0.5, [1.0]], "mapping": {"a": 1},
        "set": {1.0}, "generator": (n for n in (1.0,)), "truth": True, "numpy truth": np.True_, "complex": 1j,
        "numpy complex": np.complex128(1), "huge": HUGE, "huge fraction": Fraction(HUGE), "nan": np.nan, "inf": np.inf,
        "sympy huge": sympy.Integer(HUGE), "object": object(), "function": print, "type": float, "dots": ...,
        "symbol": sympy.Symbol("z"), "pole": sympy.zoo, "sympy nan": sympy.nan, "sympy inf": sympy.oo,
        "imaginary": sympy.I, "array": np.array([1.0, 2.0, 3.0]), "matrix": np.eye(3),
        "date": np.datetime64("2020-01-01"),
    }  # fmt: skip
    return {kind: value for kind, value in given.items() if kind not in but}


def no_vectors(length: int, *but: str) -> dict[str, Any]:
    """What is not an array of `length` finite real numbers."""
    entries = {f"of {kind}": [value] + [0.5] * (length - 1) for kind, value in no_numbers().items()}
    shapes = {
        "empty": [], "longer": [0.5] * (length + 1), "ragged": [[0.5], [0.5, 0.5]], "column": np.full((length, 1), 0.5),
        "row": np.full((1, length), 0.5), "texts": ["a"] * length, "all digits": ["0.5"] * length,
        "truths": np.ones(length, bool), "all complex": np.ones(length, complex),
        "objects": np.array([object()] * length), "dates": np.full(length, np.datetime64("2020-01-01")),
        "masked": np.ma.masked_all(length),
    }  # fmt: skip
    given = entries | no_numbers("none", "mapping") | shapes
    return {kind: value for kind, value in given.items() if kind not in but}


def no_mappings(name: str) -> dict[str, Any]:
    """Mappings of a known name to what is no number, of names that are not known, and of one name twice."""
    values = {f"{name} = {kind}": {name: value} for kind, value in no_numbers().items()}
    keys = ("nobody", "", 3, None, (1, 2), sympy.Symbol("nobody"), 1.5, b"q")
    twice = {"twice": {name: 0.5, sympy.Symbol(name): 0.5}}
    return values | {f"key {key!r}": {key: 0.5} for key in keys} | twice


def cases() -> Iterator[Case]:
    """Give (function, argument, what is given, call)."""
    yield from of_simulate()
    yield from of_system()
    yield from of_model()
    yield from of_records()


def of_simulate() -> Iterator[Case]:
    ends = {f"to {kind}": (0.0, value) for kind, value in no_numbers().items()}
    begins = {f"from {kind}": (value, 1.0) for kind, value in no_numbers().items()}
    samples = {f"values {kind}": {"u": ([0.0, 1.0], value)} for kind, value in no_vectors(2).items()}
    times = {f"times {kind}": {"u": (value, [0.0, 1.0])} for kind, value in no_vectors(2).items()}
    bad: dict[str, dict[str, Any]] = {
        "rtol": no_numbers() | {"negative": -1e-6, "one": 1.0},
        "atol": no_numbers() | no_vectors(2) | no_mappings("q") | {"negative": -1e-9, "negative of q": {"q": -1.0}},
        "first_step": no_numbers("none") | {"zero": 0.0, "negative": -0.1, "longer": 7.0},
        "max_step": no_numbers("inf", "sympy inf") | {"zero": 0.0, "negative": -1.0},
        "max_steps": no_numbers() | {"half": 10.5, "zero": 0, "negative": -3, "beyond long": 2**70},
        "t_span": no_numbers() | ends | begins | {"three": (0, 1, 2), "one": (1,), "none": (), "texts": ("0", "1")},
        "t_eval": no_vectors(2, "empty", "longer") | {"outside": [0, 2], "unsorted": [0.1, 0], "twice": [0, 0]},
        "x0": no_vectors(2) | no_mappings("q"),
        "v0": no_vectors(2) | no_mappings("q"),
        "parameters": no_vectors(2) | no_mappings("k") | {"short array": {"k": np.ones(1)}},
        "inputs": no_numbers("none", "mapping") | no_mappings("u") | samples | times,
        "method": no_numbers() | {"euler": "euler", "empty": ""},
        "dense_output": no_numbers("truth", "numpy truth") | {"two": 2},
        "estimate_error": no_numbers("truth", "numpy truth") | {"model": em.Model(**MODEL)},
    }
    for argument, values in bad.items():
        for kind, value in values.items():
            yield "simulate", argument, kind, lambda argument=argument, value=value: run(**{argument: value})
    for kind, value in (no_numbers() | {"a model": em.Model(**MODEL), "a path": "models/pendulum.py"}).items():
        yield "simulate", "em.build", kind, lambda value=value: em.simulate(value, (0.0, 1.0))
    for kind, value in (no_numbers() | {"a mapping": {"q": 1.0}}).items():
        yield "simulate", "by keyword; did you mean x0=", kind, lambda value=value: em.simulate(system(), (0, 1), value)
    for kind, value in no_vectors(2, "empty", "longer").items():
        yield "sol", "t", kind, lambda value=value: run(dense_output=True).sol(value)


def of_system() -> Iterator[Case]:
    """Methods of a System, each argument in turn."""
    for name, fine in FUNCTIONS.items():
        for argument in (*fine, "t", "parameters"):
            bad = no_vectors(2) | no_mappings("k" if argument == "parameters" else "q")
            for kind, value in (no_numbers() if argument == "t" else bad).items():
                yield (
                    name,
                    argument,
                    kind,
                    lambda name=name, given=fine | {argument: value}: getattr(system(), name)(**given),
                )
    y = system().state()
    for name, read in (("rhs", (*INFINITE, *READ)), ("jacobian", INFINITE)):
        for kind, value in no_numbers(*read).items():
            yield name, "t", kind, lambda name=name, value=value: getattr(system(), name)(value, y)
        for kind, value in no_vectors(len(y), *read, *(f"of {kind}" for kind in read)).items():
            yield name, "y", kind, lambda name=name, value=value: getattr(system(), name)(0.0, value)
    for kind, value in (no_vectors(2) | no_mappings("k")).items():
        yield "prepare", "parameter", kind, lambda value=value: system().prepare(value)
    for kind, value in (no_vectors(1, "of mapping") | no_mappings("u")).items():
        yield "acceleration", "input", kind, lambda value=value: system().acceleration(**START, inputs=value)


def of_model() -> Iterator[Case]:
    """Every argument of Model with every odd value; sequences may be given as generators."""
    odd = no_numbers("generator") | {
        "lists": [[q], [r]], "numbers": [1.0, 2.0], "texts": ["q", "r"], "nones": [None, None], "a sum": [q + r],
        "pairs of text": [("q", 1)], "symbols": [sympy.Symbol("q")], "one text": "q r", "text keys": {"q": 1.0},
        "none keys": {None: 1.0}, "q none": {q: None}, "q text": {q: "1"}, "q list": {q: [1]}, "q nan": {q: np.nan},
        "q huge": {q: HUGE}, "k none": {k: None, c: 1}, "k huge": {k: HUGE, c: 1}, "sympy matrix": sympy.eye(3),
        "relation": q < 1, "three": [1.0, 2.0, 3.0], "nested": {q: {r: 1}}, "tuple key": {(1, 2): 3},
        "list key": [([q], 1.0)], "huge inside": HUGE * q, "tiny inside": sympy.Rational(1, HUGE) * q,
    }  # fmt: skip
    for argument in (*MODEL, "holonomic_constraints", "quasi_velocities", "scales"):
        for kind, value in odd.items():
            if kind not in TAKEN.get(argument, ()):
                yield "Model", argument, kind, lambda given=MODEL | {argument: value}: em.Model(**given)
    for scale in (*no_numbers().values(), 0, -1.0, 1e200, 1e-200):
        yield "Model", "scales", repr(scale)[:9], lambda scale=scale: em.Model(**MODEL, scales={q: scale})


def of_records() -> Iterator[Case]:
    for kind, value in no_vectors(3, "array").items():
        yield "Signal", "times", kind, lambda value=value: em.Signal(value, [0.0, 1.0, 2.0])
        yield "Signal", "values", kind, lambda value=value: em.Signal([0.0, 1.0, 2.0], value)
    for kind, value in no_numbers().items():
        yield "Signal", "kind", kind, lambda value=value: em.Signal([0.0, 1.0], [0.0, 1.0], value)
        yield "Event", "direction", kind, lambda value=value: em.Event(q, direction=value)
    for kind, value in no_numbers("text").items():  # that is the name of constraints
        yield "multiplier", "multiplier", kind, lambda value=value: em.multiplier(value)
    for kind, value in no_numbers("truth", "numpy truth").items():
        yield "Event", "terminal", kind, lambda value=value: em.Event(q, terminal=value)
    for kind, value in no_numbers("symbol").items():
        yield "Event", "expression", kind, lambda value=value: em.Event(value)
    yield "Signal", "times", "unsorted", lambda: em.Signal([1.0, 0.0], [0.0, 1.0])


def complaint(call: Callable[[], object], argument: str) -> str:
    """Say what is wrong with how a call is refused, or nothing."""
    try:
        call()
    except OURS as error:
        words = str(error).replace("-", "_")
        return "" if argument.removesuffix("ies").removesuffix("s") in words and len(words) < 500 else words
    except BaseException as error:
        return f"{type(error).__name__}: {error}"
    return "taken"


SUBJECTS: dict[tuple[str, str], list[tuple[str, Callable[[], object]]]] = defaultdict(list)
for function, argument, *case in cases():
    SUBJECTS[function, argument].append(tuple(case))


@pytest.mark.parametrize(("function", "argument"), SUBJECTS, ids=[".".join(subject) for subject in SUBJECTS])
def test_bad_values_are_refused_by_name(function, argument):
    calls = SUBJECTS[function, argument]
    assert {kind: words for kind, call in calls if (words := complaint(call, argument))} == {}


def test_there_are_thousands_of_them():
    assert sum(map(len, SUBJECTS.values())) > 5000
    assert min(map(len, SUBJECTS.values())) > 15


@pytest.mark.parametrize(
    "third",
    [Fraction(1, 3), Decimal(1) / 3, sympy.Rational(1, 3), np.float64(1 / 3), np.array(1 / 3), mpmath.mpf(1) / 3],
)
def test_what_looks_odd_and_is_a_number_is_taken(third):
    found = run(t_span=(0, third), x0={q: third}, v0=[third, float(third) / 2], rtol=third)
    assert found.t[-1] == pytest.approx(1 / 3, rel=1e-15)
    assert found.x[0, 0] == pytest.approx(1 / 3, rel=1e-15)
    assert system().mass_matrix([0, third])[1, 1] == 3
    assert em.Signal([0, third], (sympy.pi, 1)).values[0] == np.pi


def test_truth_values_are_taken_where_they_are_meant():
    assert em.Event(q, direction=-1, terminal=np.True_).terminal is True
    assert run(dense_output=np.False_).sol is None
