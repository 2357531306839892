# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Functions of a compiled model at one state, with the arguments of users.

Compiled, because one evaluation takes no longer than its arguments. Arrays of float64 in C order are read directly;
other arguments are converted, or rejected, in Python. In each function `system` is the `CompiledSystem` of the model.
"""

from ..arguments.options cimport array_of, number_of
from ..runtime.arrays cimport Numbers, floats, unset, zeros
from ..runtime.abi cimport em_fault, em_inverse_check
from ..runtime.point cimport Actuators, PointModel, Prepared

from ..arguments.prescribed import with_prescribed
from ..arguments.states import split_states, whole_x
from .velocities import converted_start


cdef extern from "eigenmotion.h" nogil:
    const double EM_ALLOWED  # parts that count as zero: of constraints, and of required forces that no actuator gives
    const double EM_DRIVEN

cdef enum:
    MOST = 64  # coordinates of which an array of no residual is shared


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


cdef class InverseDynamics:
    """The forces of a motion; with k states, the last axis of each array is theirs. Unpacks in this order.

    Attributes
    ----------
    forces
        (n,) on the coordinates [J / u_i]; with actuators (count,), in their order: forces, or values of inputs.
    multipliers
        (m,); the constraints push with -A^T lambda (7).
    residual
        (n,) required forces that no actuator gives: zero, or the call would have been refused.
    """

    cdef readonly object forces, multipliers, residual

    def __init__(self, forces, multipliers, residual):
        self.forces, self.multipliers, self.residual = forces, multipliers, residual

    def __iter__(self):
        return iter((self.forces, self.multipliers, self.residual))

    def __repr__(self):
        return f"InverseDynamics(forces={self.forces}, multipliers={self.multipliers}, residual={self.residual})"

    def __reduce__(self):
        return InverseDynamics, tuple(self)


cdef Actuators known(PointModel model, object actuators):
    """The actuators of a tuple of names that was given before, or None."""
    try:
        return model.known_actuators.get(actuators) if actuators is None or type(actuators) is tuple else None
    except TypeError:  # something in it has no hash, and is no name
        return None


def inverse_dynamics(system, x, v, a, t, parameters, inputs, actuators):
    """Return the InverseDynamics of one state given by float64 arrays; None for what takes more care.

    That are other arguments, models with states, modes or prescribed motions, faults, and what actuators drive in part.
    """
    cdef em_fault fault
    cdef em_inverse_check check
    cdef PointModel model = system._compiled
    cdef Numbers q, w, b, u, forces, multipliers, residual
    cdef Prepared c
    cdef Actuators of = known(model, actuators)
    cdef InverseDynamics made
    cdef double[MOST] left
    cdef const double *signals = model.model.input_defaults
    if of is None or model.n_states or model.model.n_switches or model.prescribed or type(t) is not float:
        return None
    q, w, b = array_of(x, model.vector), array_of(v, model.vector), array_of(a, model.vector)
    if q is None or w is None or b is None:
        return None
    if inputs is not None:
        u = array_of(inputs, (model.n_inputs,))
        if u is None:
            return None
        signals = u.data
    c = constants(system, model, system._defaults, parameters)
    forces = unset((of.list.count,)) if of.list.count else unset(model.vector)
    multipliers = unset((model.m,)) if model.m else model.none
    residual = model.nothing if model.n <= MOST else zeros(model.vector)
    if model.model.inverse_dynamics(t, q.data, w.data, b.data, c.c, signals, &of.list, forces.data, multipliers.data,
                                    residual.data if model.n > MOST else &left[0], &check, &fault) != 0:
        return None
    if check.undriven > EM_DRIVEN or check.forbidden > EM_ALLOWED:
        return None
    made = InverseDynamics.__new__(InverseDynamics)
    made.forces, made.multipliers, made.residual = forces.array, multipliers.array, residual.array
    return made


cdef Numbers signals(object system, PointModel model, object inputs, double t):
    """The inputs u (n_inputs,), or None for the defaults."""
    if inputs is None:
        return None
    cdef Numbers u = array_of(inputs, (model.n_inputs,))
    if u is None:
        return floats(system.signals(inputs, t), (model.n_inputs,), "inputs")
    model.check_inputs(inputs)
    return u
