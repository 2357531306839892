# eigenmotion generate pendulum.py
# input sha256:1d29c9c54ee1d964305b3fed8997b249573cb5c2ca5c6367d604281b594a43ab
# body sha256:09037d51b2b2b2550ff8094f27bf8bb2ad11c1611dea9c9fa59879e08f99317b
# cython: language_level=3
"""pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what pendulum.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model pendulum_model;
    """
    ctypedef struct em_model:
        pass
    const em_model pendulum_model


system = System(PyCapsule_New(<void *>&pendulum_model, "eigenmotion.em_model", NULL), __name__)
