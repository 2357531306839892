# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Functions of a compiled model at one state, with the arguments of users.

Compiled, because one evaluation takes no longer than its arguments. Arrays of float64 in C order are read directly;
other arguments are converted, or rejected, in Python. In each function `system` is the `CompiledSystem` of the model.
"""

from ..arguments.options cimport array_of, number_of
from ..runtime.arrays cimport Numbers, floats, zeros
from ..runtime.abi cimport em_fault, em_inverse_check
from ..runtime.point cimport Actuators, PointModel, Prepared

from ..arguments.prescribed import with_prescribed
from ..arguments.states import split_states, whole_x
from .velocities import converted_start


cdef Prepared constants(object system, PointModel model, Prepared defaults, object parameters):
    if parameters is None:
        return defaults
    if type(parameters) is Prepared and (<Prepared> parameters).model is model:
        return parameters
    return system.prepare(parameters)


cdef Numbers position(PointModel model, object x):
    """x (n + p,)."""
    cdef Numbers q = None if model.n_states else array_of(x, model.vector)
    return floats(whole_x(model, split_states(model, x)[0], "coordinate of x"), model.vector, "x") if q is None else q


cdef Numbers given_or(object argument, object default, tuple shape):
    """The numbers of an array that needs no conversion, or of the default for None; or None."""
    return array_of(default if argument is None else argument, shape)


cdef tuple motion(object system, PointModel model, Prepared defaults, object x0, object v0, double t, object parameters):
    """(x, v) (n + p,) as Numbers, over the model's `initial`."""
    cdef Numbers x = None, v = None
    if not model.n_states or (x0 is None and v0 is None):
        if v0 is not None or model.initial_y is None:  # otherwise `initial` has quasi-velocities
            x, v = given_or(x0, model.initial_x, model.vector), given_or(v0, model.initial_v, model.vector)
    if x is not None and v is not None:
        return x, v
    q, w = converted_start(model, constants(system, model, defaults, parameters), t, x0, v0)
    return floats(q, model.vector, "x"), floats(w, model.vector, "v")


def begin(system, PointModel model not None, Prepared defaults not None, x0, v0, t, parameters):
    """Return x, v (n + p,) of compiled functions: x0 and v0 over the model's `initial`. Arrays are not copied."""
    cdef Numbers x, v
    x, v = motion(system, model, defaults, x0, v0, number_of(t, "t"), parameters)
    return x.array, v.array


def mass_matrix(system, PointModel model not None, Prepared defaults not None, x, t, parameters):
    """Return M (n, n)."""
    cdef double at = number_of(t, "t")
    cdef Numbers q = position(model, x), M
    cdef Prepared c = constants(system, model, defaults, parameters)
    cdef int n = model.n_coordinates
    M = zeros(model.square)
    model.model.mass_matrix(at, q.data, c.c, M.data)
    return M.array[:n, :n] if model.n_states else M.array


def energies(system, PointModel model not None, Prepared defaults not None, x, v, t, parameters):
    """Return T2, T1, T0, V."""
    cdef double[4] e
    cdef Prepared c = constants(system, model, defaults, parameters)
    cdef double at = number_of(t, "t")
    cdef Numbers q, w
    q, w = motion(system, model, c, x, v, at, None)
    model.model.energy(at, q.data, w.data, c.c, e)
    return e[0], e[1], e[2], e[3]


def acceleration(system, PointModel model not None, Prepared defaults not None, x, v, t, parameters, inputs,
                 int least_norm):
    """Return a (n,), lambda (m,); least_norm: em_dependent."""
    cdef Numbers q, w, u, a, multipliers
    cdef Prepared c
    cdef double at
    if model.prescribed:
        parameters, inputs = with_prescribed(model, parameters, inputs)
    c, at = constants(system, model, defaults, parameters), number_of(t, "t")
    q, w = motion(system, model, c, x, v, at, None)
    u = signals(system, model, inputs, at)
    least_norm = model.treatment(at, q.data, c, least_norm)
    a, multipliers = model.acceleration_at(at, q, w, c, model.model.input_defaults if u is None else u.data, least_norm)
    return a.array[:model.n_coordinates] if model.n_states else a.array, multipliers.array


def inverse_dynamics(system, PointModel model not None, Prepared defaults not None, x, v, a, t, parameters, inputs,
                     Actuators of not None):
    """Return forces (count,), lambda (m,), residual (n,) and the larger of both checks; None for what needs more care.

    That is all but float64 arrays of one state of a model without states, modes or prescribed motions; and faults.
    """
    cdef em_fault fault
    cdef em_inverse_check check
    cdef Numbers q, w, b, u, forces, multipliers, residual
    cdef Prepared c
    cdef const double *signals = model.model.input_defaults
    if model.n_states or model.model.n_switches or model.prescribed or model.model.inverse_dynamics == NULL:
        return None
    q, w, b = array_of(x, model.vector), array_of(v, model.vector), array_of(a, model.vector)
    if q is None or w is None or b is None or type(t) is not float:
        return None
    if inputs is not None:
        u = array_of(inputs, (model.n_inputs,))
        if u is None:
            return None
        signals = u.data
    c = constants(system, model, defaults, parameters)
    forces, multipliers, residual = zeros((of.list.count or model.n,)), zeros((model.m,)), zeros(model.vector)
    if model.model.inverse_dynamics(t, q.data, w.data, b.data, c.c, signals, &of.list, forces.data, multipliers.data,
                                    residual.data, &check, &fault) != 0:
        return None
    return forces.array, multipliers.array, residual.array, check.undriven, check.forbidden


cdef Numbers signals(object system, PointModel model, object inputs, double t):
    """The inputs u (n_inputs,), or None for the defaults."""
    if inputs is None:
        return None
    cdef Numbers u = array_of(inputs, (model.n_inputs,))
    if u is None:
        return floats(system.signals(inputs, t), (model.n_inputs,), "inputs")
    model.check_inputs(inputs)
    return u
