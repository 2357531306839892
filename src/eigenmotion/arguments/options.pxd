# Declarations of options.pyx: arguments as numbers.

from ..runtime.arrays cimport Numbers
from ..runtime.point cimport PointModel


cdef double real_of(object argument, str what) except? -1.0
cdef double number_of(object argument, str what) except? -1.0
cdef Numbers array_of(object argument, tuple shape)
cpdef (double, double) span(t_span) except *
cpdef rows_at(t_eval, double start, double end)
cdef Numbers checked_atol(PointModel model, double relative, object atol)
cpdef (double, double, long long) step_limits(first_step, max_step, max_steps, double length) except *
cpdef choice(argument, known, str what)
cpdef least_norm_of(dependent_constraints)
