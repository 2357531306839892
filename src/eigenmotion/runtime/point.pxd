# Declarations of point.pyx for the other modules of the runtime.

from .abi cimport em_actuators, em_fault, em_model
from .arrays cimport Numbers


cdef class Prepared


cdef class PointModel:
    cdef const em_model *model   # a copy that is never freed: its address may be in use
    cdef em_model *writable      # the same memory, to add functions of parts that are loaded later
    cdef list loaded_parts       # models whose functions were added, kept alive
    cdef readonly str name, formulation, close_eigenvalues, schur
    cdef readonly int n, m, h, n_state, n_states, n_coordinates, n_inputs, n_outputs, n_events, n_arguments, lanes, dimension, n_drawn
    cdef readonly tuple coordinates, parameters, inputs, outputs, events, left_out, layout, block, carried
    cdef readonly dict tables  # name -> (place among the parameters, number of arguments)
    cdef readonly dict prescribed  # name of a prescribed motion, which is a table -> its highest derivative in constraints
    cdef readonly tuple row_names, quasi_velocities, shapes, switches, acting, rotations
    cdef readonly bint acts  # events change the state or the mode
    cdef readonly bint has_cones  # friction cones, which share forces in some modes
    cdef readonly bint augmented
    cdef readonly bint lane_groups  # ensembles run on lanes
    cdef readonly object parameter_defaults, input_defaults, initial_x, initial_v, initial_y, scales
    cdef readonly bint conserves_energy
    # Omega is extrapolated (32), which not every start allows
    cdef readonly bint extrapolates
    cdef tuple vector, square  # shapes (n,), (n, n)
    cdef readonly dict known_actuators  # names, or None -> Actuators
    cdef Numbers nothing, none     # zeros (n,) and (0,), which nobody may write to
    cdef Numbers everywhere    # cache of options.pyx: the last array that repeats one number
    # function that returns the System of this model in any process; None for a model made from a capsule alone
    cdef public object recipe
    # function that compiles a part by name and returns a CompiledModel with its functions (building/lazy_units.py);
    # None: no parts can be loaded
    cdef public object load_part
    # function that returns words on the terms that have no finite value at values by name (building/undefined_terms.py);
    # None for a model whose expressions are not at hand
    cdef public object undefined_terms
    # name -> unit, the user's words; None for a model without
    cdef public object units

    cdef add_functions(self, PointModel other)
    cdef int need(self, str part) except -1
    cdef int need_derivatives(self) except -1
    cdef int need_gradient(self) except -1
    cdef int need_method(self, int method) except -1
    cdef int need_members(self) except -1
    cdef int check_tables(self, const double *parameters) except -1
    cdef tuple acceleration_at(self, double t, Numbers x, Numbers v, Prepared c, const double *u, int least_norm)
    cdef bint starts(self, double t, Numbers x, Numbers v, Prepared c, double rtol, Numbers atol, Numbers y) noexcept
    cdef int redundant_at(self, double t, const double *x, Prepared c, int *rows) except -1
    cdef tuple redundant_rows(self, double t, const double *x, Prepared c)
    cdef int treatment(self, double t, const double *x, Prepared c, int option) except -1
    cdef int check_arguments(self, double t, Numbers x, Numbers v, Prepared c, const double *u) except -1
    cdef int check_arguments_at(self, double t, Numbers y, Prepared c, const double *u) except -1
    cdef read_names(self)
    cdef read_defaults(self)
    cdef failure(self, em_fault *fault)
    cdef failure_at(self, double t, Numbers x, Prepared c, em_fault *fault)


cdef class Prepared:
    cdef readonly PointModel model
    cdef readonly object parameters
    cdef double *c


cdef class Actuators:
    cdef em_actuators list
    cdef readonly tuple names, weights
