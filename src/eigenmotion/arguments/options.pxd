# Declarations of options.pyx: arguments as numbers.

from ..runtime.arrays cimport Numbers
from ..runtime.point cimport PointModel


cdef double number_of(object argument, str what) except? -1.0
cdef Numbers array_of(object argument, tuple shape)
cpdef span(t_span)
cpdef rows_at(t_eval, double start, double end)
cpdef tolerances(PointModel model, rtol, atol)
cpdef step_limits(first_step, max_step, max_steps, double length)
cpdef choice(argument, known, str what)
cpdef least_norm_of(dependent_constraints)
