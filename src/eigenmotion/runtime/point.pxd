# A model at one place, for the modules of the runtime that ask it for more.

from .abi cimport em_fault, em_model
from .arrays cimport Numbers


cdef class PointModel:
    cdef const em_model *model  # a copy that stays for good, for whoever has its address calls it
    cdef em_model *taken        # the same, to take what is compiled later
    cdef list others            # whose functions these are
    cdef readonly str name, formulation, close_eigenvalues, schur
    cdef readonly int n, m, h, n_state, n_inputs, n_outputs, n_events, n_arguments, lanes, dimension, n_drawn
    cdef readonly tuple coordinates, parameters, inputs, outputs, events, left_out, layout, block, carried
    cdef readonly tuple row_names, quasi_velocities, shapes, switches, acting
    cdef readonly bint acts  # events change the state, or what holds
    cdef readonly bint has_cones  # frictions in a plane, of which some modes share forces
    cdef readonly bint augmented
    cdef readonly bint flocks  # runs of an ensemble go in lanes
    cdef readonly object parameter_defaults, input_defaults, initial_x, initial_v, initial_y, scales
    cdef readonly bint conserves_energy
    # whether Omega is continued by extrapolation (32), which cannot start everywhere
    cdef readonly bint extrapolates
    cdef tuple vector, square  # shapes (n,), (n, n)
    cdef Numbers everywhere    # what plain.pyx made of one number last
    # returns, in any process, the System of this model; None where there is no way to it but the capsule
    cdef public object recipe
    # part -> a CompiledModel that has what this one lacks, compiled where it is asked first (building/lazy_units.py); None:
    # there is no more
    cdef public object later

    cdef take(self, PointModel other)
    cdef int need(self, str part) except -1
    cdef int need_derivatives(self) except -1
    cdef int need_gradient(self) except -1
    cdef int need_method(self, int method) except -1
    cdef int need_members(self) except -1
    cdef read_names(self)
    cdef read_defaults(self)
    cdef failure(self, em_fault *fault)


cdef class Prepared:
    cdef readonly PointModel model
    cdef readonly object parameters
    cdef double *c
