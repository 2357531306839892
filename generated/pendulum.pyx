# eigenmotion generate pendulum.py
# input sha256:4cb3d75cfa750254dd7c7a92a151c59bb658f7285d3817bfdd1092f33379d1ad
# body sha256:b17700f659ed3ff64b304e033594638d00b1445ee386c165e776ba596ab6b809
# cython: language_level=3
"""pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# the declaration in pendulum.h, which is not included because a header of Python may have the same name
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model pendulum_model;
    """
    ctypedef struct em_model:
        pass
    const em_model pendulum_model


system = System(PyCapsule_New(<void *>&pendulum_model, "eigenmotion.em_model", NULL), __name__)
