# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""One compiled model: its description, and its functions at one state.

Calls share no memory, so threads need no locks. EvaluationError is raised where a function has no value.
"""

from cpython.pycapsule cimport PyCapsule_GetPointer
from libc.math cimport INFINITY
from libc.stdlib cimport calloc, free, malloc
from libc.string cimport memcpy

from .abi cimport EM_ABI, EM_RADAU5, EM_RADAU9, EM_REFUSED, EM_SHARED, EM_SHARED_FROM_START, em_fault, em_model, em_shape
from .arrays cimport Numbers, constants, floats, is_float_output, texts, zeros
from .start cimport em_time_event_sides, em_factored_gradient, em_factored_matrix, em_inside_contact, em_next_time_event, em_outside_tables, em_start, em_undefined

import numpy as np

from .status.stop_reasons import EvaluationError, StopReason, named_rows
from .status.refusals import refusal, values_by_name
from .tables import arguments_at, is_table_address, packed, unpacked

_REASONS = tuple(StopReason)
_OUTSIDE = ("refuse", "hold", "extend", "periodic")  # as em_outside of em_table.h


cdef object corners_of(const em_shape *shape):
    """The corners (n_corners, 3) of a solid; None for other shapes."""
    if shape.corners == NULL:
        return None
    return np.array([[shape.corners[3 * k + axis] for axis in range(3)] for k in range(shape.n_corners)])


cdef class Prepared:
    """The constants of one parameter set, with constant blocks of M already factored."""

    def __dealloc__(self):
        free(self.c)

    def __repr__(self):
        pairs = ", ".join(f"{name}={value:g}" for name, value in zip(self.model.parameters, self.parameters))
        return f"<parameters of {self.model.name}: {pairs}>"

    def __reduce__(self):
        """Pickle the parameters; they are prepared again when loaded."""
        return _prepared, (self.model, self.parameters, packed(self.parameters) if self.model.tables else {})


def _prepared(PointModel model not None, parameters, tables={}):
    places = [place for place, _ in model.tables.values()]
    return model.prepare(unpacked(np.array(parameters, dtype=np.float64), places, tables))


cdef class PointModel:
    """One `em_model`. The capsule must be named "eigenmotion.em_model" and point to a constant that outlives it."""

    def __cinit__(self, capsule):
        cdef const em_model *c = <const em_model *> PyCapsule_GetPointer(capsule, b"eigenmotion.em_model")
        if c.abi != EM_ABI:
            raise ImportError(f"the compiled model has interface version {c.abi}, this eigenmotion has {EM_ABI}: "
                              "generate and build the model again (`eigenmotion build MODEL.py`)")
        self.writable = <em_model *> malloc(sizeof(em_model))
        if self.writable == NULL:
            raise MemoryError
        memcpy(self.writable, c, sizeof(em_model))
        self.model, self.loaded_parts = self.writable, []
        self.name, self.formulation = c.name.decode("utf-8"), c.formulation.decode("utf-8")
        self.close_eigenvalues, self.schur = c.close_eigenvalues.decode("utf-8"), c.schur.decode("utf-8")
        self.n, self.m, self.h, self.n_state = c.n, c.m, c.h, c.n_state
        self.n_states, self.n_coordinates = c.n_states, c.n - c.n_states
        self.n_inputs, self.n_outputs, self.n_events = c.n_inputs, c.n_outputs, c.n_events
        self.n_arguments, self.conserves_energy = c.n_arguments, c.conserves_energy
        self.extrapolates = self.formulation == "eigenfactor" and self.close_eigenvalues == "extrapolate"
        self.nothing, self.none = zeros((c.n,)), zeros((0,))
        self.nothing.array.flags.writeable = False
        self.known_actuators = {None: Actuators((), (), ())}
        self.vector, self.square = (c.n,), (c.n, c.n)
        self.lanes = c.lanes.width if c.lanes != NULL else 0
        self.lane_groups = c.enter != NULL and self.lanes > 1
        self.read_names()
        self.read_defaults()

    # --- parts that are compiled on demand ---

    cdef int need(self, str part) except -1:
        """Load a part, if this model has a loader. Threads that request it at the same time get the same part."""
        if self.load_part is not None:
            self.add_functions(self.load_part(part))
        return 0

    cdef add_functions(self, PointModel other):
        """Copy the functions that this object lacks from another object of the same model."""
        cdef em_model *mine = self.writable
        cdef const em_model *found = other.model
        self.loaded_parts.append(other)
        if mine.rate_jacobian == NULL:
            mine.rate_jacobian = found.rate_jacobian
        if found.lanes != NULL and found.lanes.run != NULL:
            mine.lanes = found.lanes
        if mine.motion_jacobian == NULL:
            mine.mass_matrix_gradient, mine.factored_gradient = found.mass_matrix_gradient, found.factored_gradient
            mine.motion_derivatives, mine.motion_along = found.motion_derivatives, found.motion_along
            mine.jacobian, mine.tangent = found.jacobian, found.tangent
            mine.constraint_partials, mine.output_partials = found.constraint_partials, found.output_partials
            mine.event_partials, mine.time_event_partials = found.event_partials, found.time_event_partials
            mine.quasi_partials, mine.act_along = found.quasi_partials, found.act_along
            mine.equation_partials = found.equation_partials
            mine.motion_jacobian = found.motion_jacobian

    cdef int need_derivatives(self) except -1:
        if self.model.motion_jacobian == NULL:
            self.need("derivatives")
        if self.model.motion_jacobian == NULL:
            raise RuntimeError(f"{self.name} has been compiled without derivatives, and nothing is there to add them")
        return 0

    cdef int need_gradient(self) except -1:
        return self.need_derivatives() if self.model.mass_matrix_gradient == NULL else 0

    cdef int need_method(self, int method) except -1:
        """Load the parts that a run with this em_method needs."""
        return self.need_derivatives() if method == EM_RADAU5 or method == EM_RADAU9 else 0

    @property
    def mixed_inputs(self):
        """Pairs (i, j) of inputs, i = j among them, for which df / du_i depends on u_j."""
        cdef int i, j, n = self.n_inputs
        return frozenset([(i, j) for i in range(n) for j in range(n) if self.model.mixed_inputs[i * n + j]])

    @property
    def pushes(self):
        """Whether multipliers act along other rows than those of A, with friction that is proportional to them."""
        return self.model.pushes != NULL

    @property
    def inverts(self):
        """Whether it has inverse dynamics, which a model written by hand may lack."""
        return self.model.inverse_dynamics != NULL

    @property
    def differentiates(self):
        """Whether the Jacobian by dual numbers of a right-hand side with eta is loaded."""
        return self.model.rate_jacobian != NULL

    cdef int need_members(self) except -1:
        """Load the part for runs on lanes, if there is one."""
        return self.need("members") if self.lane_groups and self.model.lanes.run == NULL else 0

    cdef read_names(self):
        cdef const em_model *c = self.model
        self.coordinates, self.parameters = texts(c.coordinates, c.n), texts(c.parameters, c.n_parameters)
        self.inputs, self.outputs = texts(c.inputs, c.n_inputs), texts(c.outputs, c.n_outputs)
        self.tables = {self.parameters[c.tables[k].parameter]: (c.tables[k].parameter, <int> c.tables[k].numbers[0])
                       for k in range(c.n_tables)}
        self.prescribed = {self.parameters[c.tables[k].parameter]:
                           max([c.table_uses[i].order for i in range(c.n_table_uses) if c.table_uses[i].table == k])
                           for k in range(c.n_tables) if c.tables[k].is_input}
        self.events, self.left_out = texts(c.events, c.n_events), texts(c.left_out, c.n_left_out)
        self.quasi_velocities, rows = texts(c.quasi_velocities, c.n_quasi), c.m if c.rows != NULL else 0
        self.row_names = named_rows(texts(c.rows, rows), c.m)
        self.layout = tuple([(c.layout[k].name.decode("utf-8"), c.layout[k].start, c.layout[k].length)
                             for k in range(c.n_layout)])
        self.block = tuple([c.block[k] for k in range(c.n)])
        self.carried = tuple([k for k in range(c.n) if c.carried[k]])
        self.acts = c.event_actions != NULL
        self.acting = tuple([self.acts and c.event_actions[k].acts != 0 for k in range(c.n_events)])
        self.switches = tuple([(one["event"], one["holds"], one["slides"], one["row"], one["idles"], one["shift"], one["over"])
                               for one in [c.switches[k] for k in range(c.n_switches)]])
        self.rotations = tuple([(c.rotations[k][0], c.rotations[k][1], c.rotations[k][2]) for k in range(c.n_rotations)])
        self.has_cones = any([c.switches[k].shift >= 0 for k in range(c.n_switches)])

    cdef read_defaults(self):
        cdef const em_model *c = self.model
        self.parameter_defaults = constants(c.parameter_defaults, c.n_parameters)
        self.input_defaults = constants(c.input_defaults, c.n_inputs)
        self.initial_x, self.initial_v = constants(c.initial_x, c.n), constants(c.initial_v, c.n)
        self.initial_y = constants(c.initial_y, c.n) if c.initial_y != NULL else None
        self.shapes = tuple([(c.shapes[k].kind.decode("utf-8"), c.shapes[k].first, c.shapes[k].count,
                              corners_of(&c.shapes[k])) for k in range(c.n_shapes)])
        self.dimension, self.n_drawn = c.dimension, sum([count for _, _, count, _ in self.shapes])
        self.scales = constants(c.scales, c.n)
        self.augmented = c.factored_matrix != NULL

    def __reduce__(self):
        """Pickle the recipe that builds or loads the model again."""
        if self.recipe is None:
            raise TypeError(f"{self.name} was made from a capsule alone, so another process cannot make it; "
                            "what eigenmotion.build returns can be pickled")
        return _compiled, (self.recipe,)

    cdef failure(self, em_fault *fault):
        stop = _REASONS[<int> fault.status]
        return EvaluationError(f"{self.name}: {refusal(self, stop, fault.first, fault.second, fault.size)}", stop)

    cdef failure_at(self, double t, Numbers x, Prepared c, em_fault *fault):
        """As `failure`, at x, or a state that begins with it: what is not finite is not the fault of a pivot."""
        em_undefined(self.model, t, x.data, c.c, fault)
        error = self.failure(fault)
        if error.stop is StopReason.NON_FINITE_STATE:
            error = EvaluationError(f"{error}{self.undefined(t, x.array[:self.n], None, c)}", error.stop)
        return error

    def undefined(self, double t, x, v, Prepared c not None, u=None):
        """Words on terms without a finite value at x, v (n) and u (n_inputs), for a message; None: v, u are not known."""
        return self.undefined_terms(values_by_name(self, t, x, v, c.parameters, u)) if self.undefined_terms else ""

    # --- at one state; x, v, a (n), lambda (m), y (n_state), u (n_inputs) ---

    cdef int check_tables(self, const double *parameters) except -1:
        """Raise if the number of a table parameter is not the address of a table with the right number of arguments."""
        cdef int k, place
        cdef double number
        for k in range(self.model.n_tables):
            place = self.model.tables[k].parameter
            number = parameters[place]
            if number != 0.0 and not (is_table_address(number) and arguments_at(number) == <int> self.model.tables[k].numbers[0]):
                raise EvaluationError(f"{self.name}: '{self.parameters[place]}' is a table and was given the number "
                                      f"{number:g}: give it a Table, an interpolant of SciPy or points with values",
                                      StopReason.VALUE_REFUSED)
        return 0

    cdef int check_arguments_at(self, double t, Numbers y, Prepared c, const double *u) except -1:
        """As `check_arguments`, at a state y."""
        cdef em_fault fault
        cdef Numbers v = zeros((self.n,))
        if self.model.n_tables > 0 and self.model.velocity(t, y.data, c.c, v.data, &fault) == 0:
            self.check_arguments(t, y, v, c, u)
        return 0

    cdef int check_arguments(self, double t, Numbers x, Numbers v, Prepared c, const double *u) except -1:
        """Raise if a table is evaluated outside its range."""
        cdef em_fault fault
        cdef Numbers at
        if self.model.n_tables == 0:
            return 0
        at = zeros((self.model.n_table_uses,))
        self.model.table_arguments(t, x.data, v.data, c.c, u, at.data)
        if em_outside_tables(self.model, c.c, at.data, &fault):
            raise self.failure(&fault)
        return 0

    def check_table_arguments(self, double t, x, v, Prepared c not None):
        """Raise an EvaluationError if a table is evaluated outside its range at x, v."""
        self.check_arguments(t, floats(x, (self.n,), "x"), floats(v, (self.n,), "v"), c, self.model.input_defaults)

    def check_tables_of(self, rows):
        """Check the table parameters in rows (K, n_parameters), as `prepare` does."""
        cdef Numbers P
        for row in rows if self.tables else ():
            P = floats(np.ascontiguousarray(row), (self.model.n_parameters,), "parameters")
            self.check_tables(P.data)

    def outside_of(self, name):
        """The option `outside` of the table of this name."""
        cdef int k
        for k in range(self.model.n_tables):
            if self.parameters[self.model.tables[k].parameter] == name:
                return _OUTSIDE[<int> self.model.tables[k].numbers[1]]
        raise KeyError(name)

    def prepare(self, values):
        """Return the `Prepared` constants of parameter values (n_parameters)."""
        cdef em_fault fault, undefined
        cdef Prepared prepared = Prepared.__new__(Prepared)
        cdef Numbers p = floats(values, (self.model.n_parameters,), "parameters")
        self.check_tables(p.data)
        prepared.model = self
        prepared.parameters = tuple([p.data[k] for k in range(self.model.n_parameters)])
        prepared.c = <double *> calloc(self.model.n_prepared + 1, sizeof(double))
        if prepared.c == NULL:
            raise MemoryError
        if self.model.prepare(p.data, prepared.c, &fault) != 0:
            # a block that is constant: its masses are the same at any state
            if em_undefined(self.model, 0.0, self.model.initial_x, prepared.c, &undefined) and undefined.first == fault.first:
                fault = undefined
            raise self.failure(&fault)
        return prepared

    def rhs(self, double t, y, Prepared c not None, u=None, out=None):
        """dy at t, y, u (None: defaults), written into `out` unless None."""
        cdef em_fault fault
        cdef tuple shape = (self.n_state,)
        cdef Numbers state = floats(y, shape, "y"), inputs, dy = Numbers.__new__(Numbers)
        cdef const double *signals = self.model.input_defaults
        if u is not None:
            inputs = floats(u, (self.n_inputs,), "inputs")
            signals = inputs.data
        # the compiled code reads y after writing dy
        if out is None or not dy.borrow(out, shape) or dy.view.readonly or dy.overlaps(state):
            if out is not None and not is_float_output(out, shape):
                raise ValueError(f"out must be a writable array of floating point numbers of shape {shape}")
            dy = zeros(shape)
        if self.model.rhs(t, state.data, c.c, signals, dy.data, &fault) != 0:
            self.check_arguments_at(t, state, c, signals)
            raise self.failure_at(t, state, c, &fault)
        if self.model.n_tables > 0 and not np.isfinite(dy.array).all():
            self.check_arguments_at(t, state, c, signals)
        if out is None or out is dy.array:
            return dy.array
        out[...] = dy.array
        return out

    def state(self, double t, x, v, Prepared c not None):
        """y, published meaning."""
        cdef em_fault fault
        cdef Numbers q = floats(x, (self.n,), "x"), w = floats(v, (self.n,), "v"), y = zeros((self.n_state,))
        if self.model.state(t, q.data, w.data, c.c, y.data, &fault) != 0:
            self.check_arguments(t, q, w, c, self.model.input_defaults)
            raise self.failure_at(t, q, c, &fault)
        return y.array

    cdef bint starts(self, double t, Numbers x, Numbers v, Prepared c, double rtol, Numbers atol, Numbers y) noexcept:
        """Whether a motion can start at x, v; y (n_state) <- its state there."""
        return em_start(self.model, t, x.data, v.data, c.c, rtol, atol.data, y.data, NULL, NULL) == 0

    def start(self, double t, x, v, Prepared c not None, double rtol, atol):
        """em_refusal, y (n_state), the coordinate without inertia, the residuals of constraint rows (em_start_check.h)."""
        cdef int at
        cdef Numbers q = floats(x, self.vector, "x"), w = floats(v, self.vector, "v"), y = zeros((self.n_state,)), off
        cdef Numbers absolute = floats(atol, self.vector, "atol")
        if self.starts(t, q, w, c, rtol, absolute, y):
            return 0, y.array, -1, None
        off, y = zeros((self.m,)), zeros((self.n_state,))
        refusal = em_start(self.model, t, q.data, w.data, c.c, rtol, absolute.data, y.data, &at, off.data)
        return refusal, y.array, at, off.array

    def inside(self, double t, x, v, Prepared c not None, double rtol, atol):
        """(name, gap) of a contact or impact whose gap is negative at x by more than its tolerance; or None (em_start_check.h)."""
        cdef Numbers q = floats(x, (self.n,), "x"), w = floats(v, (self.n,), "v"), g = zeros((self.n_events,))
        cdef Numbers absolute = floats(atol, (self.n,), "atol")
        cdef int event = em_inside_contact(self.model, t, q.data, w.data, c.c, rtol, absolute.data)
        if event < 0:
            return None
        self.model.event(t, q.data, w.data, c.c, self.model.input_defaults, g.data)
        return self.events[event], g.data[event] * self.model.event_actions[event].keeps_apart

    def identity(self, Prepared c not None):
        """The names and constants that must agree for one model to restore a run that another saved as bytes."""
        cdef bytes numbers = (<char *> c.c)[:self.model.n_prepared * sizeof(double)]
        return (self.name, self.formulation, self.close_eigenvalues, self.schur, self.coordinates, self.parameters,
                self.inputs, self.events, self.layout, self.block, self.left_out, self.lanes, <long> self.model.saved(),
                c.parameters, numbers)

    def smooth_interval(self, double t, double direction, Prepared c not None):
        """(end, low, high): the next time event after t, and the times within which the model is evaluated before it
        (em_time_events.h)."""
        cdef int n = self.model.n_time_events
        cdef double inside[2]
        cdef Numbers at
        if n == 0:
            return direction * INFINITY, -INFINITY, INFINITY
        at = zeros((n, 3))
        self.model.time_events(c.c, at.data)
        cdef double end = em_next_time_event(n, at.data, t, direction)
        em_time_event_sides(n, at.data, t, end, direction, inside)
        return end, inside[0], inside[1]

    def mass_matrix(self, double t, x, Prepared c not None):
        """M (n, n)."""
        cdef Numbers q = floats(x, (self.n,), "x"), M = zeros((self.n, self.n))
        self.model.mass_matrix(t, q.data, c.c, M.data)
        return M.array

    def mass_matrix_gradient(self, double t, x, Prepared c not None):
        """dM (n, n, n), [k, i, j] = dM_ij / dx_k."""
        cdef Numbers q = floats(x, (self.n,), "x"), dM = zeros((self.n, self.n, self.n))
        self.need_gradient()
        self.model.mass_matrix_gradient(t, q.data, c.c, dM.data)
        return dM.array

    def factored_matrix(self, double t, x, Prepared c not None):
        """The factored matrix (n, n): M, or M + A^T W A if M is singular."""
        cdef Numbers q = floats(x, (self.n,), "x"), M = zeros((self.n, self.n))
        em_factored_matrix(self.model, t, q.data, c.c, M.data)
        return M.array

    def factored_gradient(self, double t, x, Prepared c not None):
        """The gradient of `factored_matrix` (n, n, n), indexed as `mass_matrix_gradient`."""
        cdef Numbers q = floats(x, (self.n,), "x"), dM = zeros((self.n, self.n, self.n))
        self.need_gradient()
        em_factored_gradient(self.model, t, q.data, c.c, dM.data)
        return dM.array

    def pfaffian(self, double t, x, Prepared c not None):
        """A (m, n), b (m) of A v + b = 0 (8)."""
        cdef Numbers q = floats(x, (self.n,), "x"), A = zeros((self.m, self.n)), b = zeros((self.m,))
        if self.m > 0:
            self.model.pfaffian(t, q.data, c.c, A.data, b.data)
        return A.array, b.array

    def position(self, double t, x, Prepared c not None):
        """phi (h), the residuals of the holonomic constraints, and (h) the magnitudes of the terms that cancel in them."""
        cdef Numbers q = floats(x, (self.n,), "x"), phi = zeros((self.h,)), terms = zeros((self.h,))
        if self.h > 0:
            self.model.position(t, q.data, c.c, phi.data, terms.data)
        return phi.array, terms.array

    def acceleration(self, double t, x, v, Prepared c not None, u, int least_norm):
        """a, lambda."""
        cdef Numbers q = floats(x, (self.n,), "x"), w = floats(v, (self.n,), "v"), s = floats(u, (self.n_inputs,), "inputs")
        a, multipliers = self.acceleration_at(t, q, w, c, s.data, least_norm)
        return (<Numbers> a).array, (<Numbers> multipliers).array

    cdef tuple acceleration_at(self, double t, Numbers x, Numbers v, Prepared c, const double *u, int least_norm):
        """As `acceleration`, of Numbers."""
        cdef em_fault fault
        cdef Numbers a = zeros(self.vector), multipliers = zeros((self.m,))
        if self.model.acceleration(t, x.data, v.data, c.c, u, least_norm, a.data, multipliers.data, &fault) != 0:
            self.check_arguments(t, x, v, c, u)
            raise self.failure_at(t, x, c, &fault)
        if self.model.n_tables > 0 and not np.isfinite(a.array).all():
            self.check_arguments(t, x, v, c, u)
        return a, multipliers

    cdef int redundant_at(self, double t, const double *x, Prepared c, int *rows) except -1:
        """The number of constraint rows that hold in every mode and depend on others near x; rows (m) <- 1: its multiplier
        is not unique."""
        if self.m == 0 or self.model.redundant == NULL:
            return 0
        return self.model.redundant(t, x, c.c, rows)

    cdef tuple redundant_rows(self, double t, const double *x, Prepared c):
        """As `redundant`."""
        cdef int *rows
        cdef int depend
        if self.m == 0 or self.model.redundant == NULL:
            return 0, ()
        rows = <int *> calloc(self.m, sizeof(int))
        if rows == NULL:
            raise MemoryError
        depend = self.redundant_at(t, x, c, rows)
        dependent = tuple([k for k in range(self.m) if rows[k]]) if depend else ()
        free(rows)
        return depend, dependent

    def redundant(self, double t, x, Prepared c not None):
        """Redundant constraint rows near x.

        Returns the number of rows that hold in every mode and depend on others, and the rows whose multipliers are not unique.
        """
        cdef Numbers q = floats(x, (self.n,), "x")
        return self.redundant_rows(t, q.data, c)

    cdef int treatment(self, double t, const double *x, Prepared c, int option) except -1:
        """The treatment of dependent rows (em_dependent); EM_SHARED_FROM_START is resolved as if x were the start."""
        cdef int depend
        cdef int *rows
        if option != EM_SHARED_FROM_START or self.m == 0 or self.has_cones:  # some modes of cones share forces
            return option
        rows = <int *> malloc(self.m * sizeof(int))
        if rows == NULL:
            raise MemoryError
        depend = self.redundant_at(t, x, c, rows)
        free(rows)
        return EM_SHARED if depend else EM_REFUSED

    def shares(self, double t, x, Prepared c not None, int option):
        """As `treatment`."""
        cdef Numbers q = floats(x, (self.n,), "x")
        return self.treatment(t, q.data, c, option)

    def project(self, double t, x, v, Prepared c not None, int least_norm):
        """x, v: the nearest consistent state in the mass metric."""
        cdef em_fault fault
        cdef Numbers q = floats(np.array(x, dtype=np.float64), (self.n,), "x"), first = floats(x, (self.n,), "x")
        cdef Numbers w = floats(np.array(v, dtype=np.float64), (self.n,), "v")
        if self.model.project(t, q.data, w.data, c.c, least_norm, &fault) != 0:
            self.check_table_arguments(t, x, v, c)
            raise self.failure_at(t, first, c, &fault)
        return q.array, w.array


cdef class Actuators:
    """Where actuators act, in the order of `names`: coordinates and inputs (count,), -1 for none; weights (count,), None: 1.

    count 0: an actuator on every coordinate.
    """

    def __cinit__(self, names, coordinates, inputs, weights=None):
        cdef int k, count = len(names)
        cdef int *places = <int *> calloc(2 * count + 1, sizeof(int))
        cdef double *squares = <double *> calloc(len(weights) + 1, sizeof(double)) if weights is not None else NULL
        self.names, self.weights = tuple(names), None if weights is None else tuple(weights)
        self.list.count, self.list.coordinate, self.list.input, self.list.weight = count, places, places + count, squares
        if places == NULL or (weights is not None and squares == NULL):
            raise MemoryError
        for k in range(count):
            places[k], places[count + k] = coordinates[k], inputs[k]
        for k in range(len(weights) if weights is not None else 0):
            squares[k] = weights[k]

    def __dealloc__(self):
        free(<void *> self.list.coordinate)
        free(<void *> self.list.weight)


def _compiled(recipe):
    return recipe().compiled
