# Declarations of at_state.pyx: arguments of users at one state.

from ..runtime.point cimport PointModel, Prepared


cdef Prepared constants(object system, PointModel model, Prepared defaults, object parameters)
cdef tuple motion(object system, PointModel model, Prepared defaults, object x0, object v0, double t, object parameters)
