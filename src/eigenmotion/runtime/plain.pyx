# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Fast path for calls with plain arguments, which need no conversion or checks in Python.

Plain: NumPy arrays of float64, C-contiguous, of the right shape and finite; finite Python numbers; default or prepared
parameters; a model without states; options spelt as documented. For other arguments a function returns None; the caller
then converts or rejects them in Python.
"""

from cpython.exc cimport PyErr_Clear, PyErr_Occurred
from cpython.float cimport PyFloat_AS_DOUBLE, PyFloat_Check
from cpython.long cimport PyLong_CheckExact
from cpython.ref cimport Py_INCREF
from cpython.tuple cimport PyTuple_SET_ITEM
from libc.math cimport fabs, floor, isfinite
from libc.stdlib cimport free, malloc
from libc.string cimport memcpy

from .abi cimport EM_REFUSED, EM_SHARED, EM_SHARED_FROM_START, em_fault
from .arrays cimport Numbers, zeros
from .point cimport PointModel, Prepared
from .start cimport em_start

import numpy as np

cdef extern from *:
    double PyLong_AsDouble(object) noexcept  # the exception is checked below
    object PyType_GenericAlloc(type, Py_ssize_t)

MOST_STEPS = 10**15
"""Exactly representable as a double; at one nanosecond a step, twelve days."""
cdef object _array = np.ndarray, _double = np.dtype(np.float64)
cdef double _MOST_STEPS = MOST_STEPS


cdef bint is_number(object argument, double *value) noexcept:
    """Whether it is a real number (also infinite or NaN), not a bool."""
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


cdef bint is_finite(object argument, double *value) noexcept:
    return is_number(argument, value) and isfinite(value[0])


cdef bint are_finite(const double *numbers, Py_ssize_t count) noexcept nogil:
    cdef Py_ssize_t k
    cdef double sum = 0.0
    for k in range(count):
        sum += 0.0 * numbers[k]  # NaN and infinity survive
    return sum == 0.0


cdef Numbers vector(object argument, tuple shape):
    """The numbers of a plain array, or None."""
    if type(argument) is not _array or argument.dtype is not _double:
        return None
    cdef Numbers numbers = Numbers.__new__(Numbers)
    return numbers if numbers.borrow(argument, shape) and are_finite(numbers.data, numbers.view.shape[0]) else None


cdef const double *constants(PointModel model, Prepared defaults, object parameters) noexcept:
    """The constants c (n_prepared) of plain parameters, or NULL."""
    if parameters is None:
        return defaults.c
    if type(parameters) is not Prepared or (<Prepared> parameters).model is not model:
        return NULL
    return (<Prepared> parameters).c


def mass_matrix(PointModel model not None, Prepared defaults not None, x, t, parameters):
    """M (n, n) at x (n,), t; or None."""
    cdef double at
    cdef const double *c = constants(model, defaults, parameters)
    cdef Numbers q = vector(x, model.vector), M
    if model.n_states or q is None or c == NULL or not is_finite(t, &at):
        return None
    M = zeros(model.square)
    model.model.mass_matrix(at, q.data, c, M.data)
    return M.array


def energies(PointModel model not None, Prepared defaults not None, x, v, t, parameters):
    """T2, T1, T0, V at x, v (n,), t; or None."""
    cdef double at
    cdef double[4] e
    cdef const double *c = constants(model, defaults, parameters)
    cdef Numbers q = vector(x, model.vector), w = vector(v, model.vector)
    if model.n_states or q is None or w is None or c == NULL or not is_finite(t, &at):
        return None
    model.model.energy(at, q.data, w.data, c, e)
    return e[0], e[1], e[2], e[3]


cdef int redundant_at(PointModel model, double t, const double *x, const double *c) except -1:
    """The number of rows that hold in every mode and depend on others."""
    cdef int depend, *rows
    if model.model.redundant == NULL:
        return 0
    rows = <int *> malloc(model.m * sizeof(int))
    if rows == NULL:
        raise MemoryError
    depend = model.model.redundant(t, x, c, rows)
    free(rows)
    return depend


def acceleration(PointModel model not None, Prepared defaults not None, x, v, t, parameters, inputs, least_norm):
    """a (n,), lambda (m,) at x, v (n,), t; or None. inputs: None, the defaults, or (n_inputs,)."""
    cdef double at
    cdef em_fault fault
    cdef const double *c = constants(model, defaults, parameters)
    cdef const double *u = model.model.input_defaults
    cdef Numbers q = vector(x, model.vector), w = vector(v, model.vector), signals, a, multipliers
    if model.n_states or model.model.n_tables > 0 or q is None or w is None or c == NULL:
        return None
    if not is_finite(t, &at) or type(least_norm) is not int:
        return None
    if inputs is not None:
        signals = vector(inputs, (model.n_inputs,))
        if signals is None:
            return None
        u = signals.data
    a, multipliers = zeros(model.vector), zeros((model.m,))
    if least_norm == EM_SHARED_FROM_START and model.m > 0 and not model.has_cones: # this state is the start
        least_norm = EM_SHARED if redundant_at(model, at, q.data, c) else EM_REFUSED
    if model.model.acceleration(at, q.data, w.data, c, u, least_norm, a.data, multipliers.data, &fault) != 0:
        raise model.failure(&fault)
    return a.array, multipliers.array


# --- runs: each function below checks whether its options are plain, and reads them (rules: arguments/options.py) ---

cdef object meaning(object word, dict known):
    """The value of a keyword, or None."""
    return known.get(word) if type(word) is str else None


cdef bint read_span(object t_span, double *start, double *end) noexcept:
    if type(t_span) is tuple:
        return len(<tuple> t_span) == 2 and is_finite((<tuple> t_span)[0], start) and is_finite((<tuple> t_span)[1], end)
    if type(t_span) is list:
        return len(<list> t_span) == 2 and is_finite((<list> t_span)[0], start) and is_finite((<list> t_span)[1], end)
    return False


cdef Numbers read_tolerances(PointModel model, object rtol, object atol, double *relative):
    """atol (n,), or None."""
    cdef double one
    cdef Numbers absolute
    cdef Py_ssize_t k
    if not is_number(rtol, relative) or not (0.0 <= relative[0] < 1.0):
        return None
    if is_finite(atol, &one):
        absolute = everywhere(model, one)
    else:
        absolute = vector(atol, model.vector)
        if absolute is None:
            return None
        absolute = copied(absolute)
    for k in range(model.n):
        if absolute.data[k] < 0.0 or absolute.data[k] == relative[0] == 0.0:
            return None
    return absolute


cdef Numbers everywhere(PointModel model, double one):
    """One number as an array (n,). It is read-only and reused by the next call with the same number."""
    cdef Numbers numbers = model.everywhere
    cdef Py_ssize_t k
    if numbers is not None and numbers.data[0] == one:
        return numbers
    numbers = zeros(model.vector)
    for k in range(model.n):
        numbers.data[k] = one
    numbers.array.flags.writeable = False
    model.everywhere = numbers
    return numbers


cdef Numbers copied(Numbers numbers):
    """A copy (one axis), since the user may change the original."""
    cdef Numbers made = zeros((numbers.view.shape[0],))
    memcpy(made.data, numbers.data, numbers.view.len)
    return made


cdef bint read_limits(object first_step, object max_step, object max_steps, double length, double *first,
                      double *longest, double *most) noexcept:
    first[0] = 0.0
    if first_step is not None and not (is_number(first_step, first) and 0.0 < first[0] <= length):
        return False
    if not is_number(max_step, longest) or not longest[0] > 0.0:
        return False
    return is_number(max_steps, most) and 1.0 <= most[0] <= _MOST_STEPS and most[0] == floor(most[0])


cdef Numbers read_rows(object t_eval, double start, double end):
    """Times of the rows (k,), or None."""
    cdef Py_ssize_t k
    cdef double sign = -1.0 if end < start else 1.0
    if type(t_eval) is not _array or t_eval.ndim != 1:
        return None
    cdef Numbers times = vector(t_eval, (len(t_eval),))
    if times is None:
        return None
    for k in range(times.view.shape[0]):
        if sign * (times.data[k] - start) < 0.0 or sign * (times.data[k] - end) > 0.0:
            return None
        if k > 0 and not sign * (times.data[k] - times.data[k - 1]) > 0.0:
            return None
    return copied(times)


cdef Numbers read_start(PointModel model, object x0, object v0, double t, const double *c, double rtol, Numbers atol):
    """y (n_state,) if a run can start, or None."""
    cdef Numbers x = vector(model.initial_x if x0 is None else x0, model.vector)
    cdef Numbers v = vector(model.initial_v if v0 is None else v0, model.vector)
    cdef Numbers y
    if x is None or v is None or (v0 is None and model.initial_y is not None) or model.extrapolates:
        return None
    if model.n_states and not (x0 is None and v0 is None): # users' arrays have other lengths
        return None
    y = zeros((model.n_state,))
    return y if em_start(model.model, t, x.data, v.data, c, rtol, atol.data, y.data, NULL, NULL) == 0 else None


cdef object named(type kind, tuple fields):
    """tuple.__new__(kind, fields) for a named tuple type."""
    cdef Py_ssize_t k
    made = PyType_GenericAlloc(kind, len(fields))
    for k in range(len(fields)):
        field = fields[k]
        Py_INCREF(field)
        PyTuple_SET_ITEM(made, k, field)
    return made


def task(type Task not None, PointModel model not None, Prepared defaults not None, inputs, t_span, x0, v0, parameters,
         rtol, atol, t_eval, dense, first_step, max_step, max_steps, stabilisation, dict stabilisations not None,
         dependent, dict dependents not None):
    """A Task (arguments/options.py) from plain options, if a run can start from it; or None."""
    cdef double start, end, relative, first, longest, most
    cdef const double *c = constants(model, defaults, parameters)
    cdef Numbers absolute, times = None, y
    stabilise, least_norm = meaning(stabilisation, stabilisations), meaning(dependent, dependents)
    if c == NULL or stabilise is None or least_norm is None or type(dense) is not bool:
        return None
    if not read_span(t_span, &start, &end):
        return None
    if not read_limits(first_step, max_step, max_steps, fabs(end - start), &first, &longest, &most):
        return None
    absolute = read_tolerances(model, rtol, atol, &relative)
    if absolute is None:
        return None
    if t_eval is not None:
        times = read_rows(t_eval, start, end)
        if times is None:
            return None
    y = read_start(model, x0, v0, start, c, relative, absolute)
    if y is None:
        return None
    return named(Task, (model, defaults if parameters is None else parameters, inputs, start, end, y.array, relative,
                        absolute.array, None if times is None else times.array, dense, first, longest, <long> most,
                        stabilise, least_norm))
