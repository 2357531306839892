# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Options of runs: conversion to numbers, and the check of each option.

Compiled, because short runs take no longer than these checks. Floats, integers and arrays of float64 in C order are read
directly; other values are converted, or rejected, in Python (`real`, `number`, `vector`, `overlay`).
"""

from collections.abc import Mapping

from cpython.exc cimport PyErr_Clear, PyErr_Occurred
from cpython.float cimport PyFloat_AS_DOUBLE, PyFloat_Check
from cpython.long cimport PyLong_CheckExact
from libc.math cimport floor, isfinite
from libc.string cimport memcpy

from ..runtime.abi cimport EM_REFUSED, EM_SHARED, EM_SHARED_FROM_START
from ..runtime.arrays cimport Numbers, floats, zeros
from ..runtime.point cimport PointModel

import numpy as np

from ..codegen.model.normalise import ModelError, number, real, shown
from ..runtime import CompiledModel
from .named_values import overlay, unknown, vector

cdef extern from *:
    double PyLong_AsDouble(object) noexcept  # the exception is checked below

cdef object _array = np.ndarray, _double = np.dtype(np.float64)
cdef double MOST_STEPS = 1e15  # exactly representable; at one nanosecond a step, twelve days

DEFAULT_ATOL = 1e-9
DEPENDENT = {"auto": EM_SHARED_FROM_START, "refuse": EM_REFUSED, "least_norm": EM_SHARED}
SHARED_FROM_START = DEPENDENT["auto"]
STABILISATIONS = {"project": True, "none": False}
SCIPY_OPTIONS = {
    "args": "parameters={...}, by name",
    "events": "Model(events={...}): they belong to the mechanism, and are compiled",
    "fun": "nothing: the system has its right-hand side",
    "jac": "nothing: implicit methods have their Jacobian",
    "y0": "x0 and v0, by name or as arrays",
}
"""Options of `solve_ivp` -> the corresponding argument here."""


class OptionError(ModelError, TypeError):
    """An unknown option of `simulate`: a TypeError as Python's own, and a ValueError as all our argument errors."""


def is_system(argument):
    """Return whether an object is a `System`."""
    return isinstance(getattr(argument, "compiled", None), CompiledModel)


def no_system(call, argument, more=""):
    """Return the error of a call without a System; `more` are the other arguments of the call."""
    return OptionError(
        f"{call}: system is {shown(argument)}, not a System. Compile the model, or the file that defines it, "
        f"first: {call}(em.build(model){more})"
    )


cpdef choice(argument, known, str what):
    """Return the value of a keyword option, in upper or lower case; the keys of `known` are in lower case.

    Raises
    ------
    ModelError
        The word is unknown; lists the known ones.
    """
    if type(argument) is str and argument in known:
        return known[argument]
    if not isinstance(argument, str):
        raise ModelError(f"{what} is {shown(argument)}, not one of the words {', '.join(known)}")
    if argument.lower() not in known:
        raise ModelError(unknown(what, [argument], list(known)))
    return known[argument.lower()]


cpdef least_norm_of(dependent_constraints):
    """Return the treatment of dependent constraint rows, em_dependent of em_run.h: e.g. multipliers of least norm."""
    return choice(dependent_constraints, DEPENDENT, "dependent_constraints")


cdef bint is_number(object argument, double *value) noexcept:
    """Whether it is a float or an integer, infinite or NaN included, and not a bool."""
    if PyFloat_Check(argument):
        value[0] = PyFloat_AS_DOUBLE(argument)
        return True
    if not PyLong_CheckExact(argument):
        return False
    value[0] = PyLong_AsDouble(argument)
    if value[0] == -1.0 and PyErr_Occurred() != NULL:
        PyErr_Clear()
        return False
    return True


cdef double real_of(object argument, str what) except? -1.0:
    """As `real`."""
    cdef double value
    return value if is_number(argument, &value) else real(argument, what)


cdef double number_of(object argument, str what) except? -1.0:
    """As `number`."""
    cdef double value
    return value if is_number(argument, &value) and isfinite(value) else number(argument, what)


cdef Numbers array_of(object argument, tuple shape):
    """The numbers of an array of that shape that needs no conversion, or None. All are finite."""
    cdef Py_ssize_t k
    cdef double sum = 0.0
    if type(argument) is not _array or argument.dtype is not _double:
        return None
    cdef Numbers numbers = Numbers.__new__(Numbers)
    if not numbers.borrow(argument, shape):
        return None
    for k in range(numbers.view.shape[0]):
        sum += 0.0 * numbers.data[k]  # NaN and infinity survive
    return numbers if sum == 0.0 else None


cpdef (double, double) span(t_span) except *:
    """Return the start and end of a time span, two finite numbers [s]."""
    try:
        start, end = t_span
    except (TypeError, ValueError) as error:
        raise ModelError(f"t_span is {shown(t_span)}, not a pair of numbers (start, end)") from error
    return number_of(start, "the start of t_span"), number_of(end, "the end of t_span")


cpdef rows_at(t_eval, double start, double end):
    """Return t_eval (k,), strictly sorted in the direction of time and inside the span."""
    cdef Numbers times
    cdef Py_ssize_t k
    cdef double *t
    if t_eval is None:
        return None
    values = vector(t_eval, "t_eval")
    if values.ndim != 1:
        raise ModelError(f"t_eval has shape {values.shape}, but must be one-dimensional")
    times = floats(values, (len(values),), "t_eval")
    t = times.data
    for k in range(times.view.shape[0]):
        if not min(start, end) <= t[k] <= max(start, end):
            if not np.isfinite(values).all():
                raise ModelError("t_eval holds a number that is not finite")
            raise ModelError(f"t_eval: {t[k]:.9g} is outside t_span ({start:g}, {end:g})")
    for k in range(1, times.view.shape[0]):
        if not (t[k] < t[k - 1] if end < start else t[k - 1] < t[k]):
            way = "decrease" if end < start else "increase"
            raise ModelError(f"t_eval must {way} strictly, as t_span runs from {start:g} to {end:g}")
    return times.array


def tolerances(PointModel model not None, rtol, atol):
    """Return rtol and atol (n,); coordinates missing from a mapping get 1e-9."""
    cdef double relative = real_of(rtol, "rtol")
    return relative, checked_atol(model, relative, atol).array


cdef Numbers checked_atol(PointModel model, double relative, object atol):
    """atol (n,), after a check of both tolerances."""
    cdef Numbers absolute = absolute_tolerances(model, atol)
    cdef Py_ssize_t k, least = 0
    if not 0.0 <= relative < 1.0:
        raise ModelError(f"rtol is {relative}, but must be at least 0 and less than 1")
    for k in range(1, model.n):
        if absolute.data[k] < absolute.data[least]:
            least = k
    if absolute.data[least] < 0.0:
        raise ModelError(f"atol of {model.coordinates[least]!r} is {absolute.data[least]}, but must not be negative")
    if relative == absolute.data[least] == 0.0:
        raise ModelError(f"rtol and the atol of {model.coordinates[least]!r} are both 0: no step can be that accurate")
    return absolute


cdef Numbers absolute_tolerances(PointModel model, object atol):
    """atol (n,); an array is copied, since the user may change it."""
    cdef double value
    cdef Numbers copy, given
    if is_number(atol, &value):
        return everywhere(model, number_of(atol, "atol"))
    given = array_of(atol, model.vector)
    if given is not None:
        copy = zeros(model.vector)
        memcpy(copy.data, given.data, given.view.len)
        return copy
    if isinstance(atol, Mapping | list | tuple) or getattr(atol, "ndim", 0) != 0:
        values = overlay(atol, model.coordinates, np.full(model.n, DEFAULT_ATOL), "coordinate of atol")
        return floats(values, model.vector, "atol")
    return everywhere(model, number(atol, "atol"))


cdef Numbers everywhere(PointModel model, double value):
    """One number as an array (n,). It is read-only and reused by the next call with the same number."""
    cdef Numbers numbers = model.everywhere
    cdef Py_ssize_t k
    if numbers is not None and numbers.data[0] == value:
        return numbers
    numbers = zeros(model.vector)
    for k in range(model.n):
        numbers.data[k] = value
    numbers.array.flags.writeable = False
    model.everywhere = numbers
    return numbers


cpdef (double, double, long long) step_limits(first_step, max_step, max_steps, double length) except *:
    """Return first_step (0: estimated), max_step and max_steps."""
    cdef double first = 0.0, longest, most
    if first_step is not None:
        first = real_of(first_step, "first_step")
        if not 0.0 < first <= length:
            raise ModelError(f"first_step is {first}, but must be above 0 and at most the length of t_span, {length:g}")
    longest = real_of(max_step, "max_step")
    if not longest > 0.0:
        raise ModelError(f"max_step is {longest}, but must be above 0")
    most = real_of(max_steps, "max_steps")
    if not (1.0 <= most <= MOST_STEPS and most == floor(most)):
        raise ModelError(f"max_steps is {shown(max_steps)}, but must be a whole number from 1 to {MOST_STEPS:.0e}")
    return first, longest, <long long> most
