# eigenmotion generate pendulum.py
# input sha256:1d29c9c54ee1d964305b3fed8997b249573cb5c2ca5c6367d604281b594a43ab
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
