# eigenmotion generate dual_link.py --formulation inverse
# input sha256:1093f8d0de759d8d08dc9d63d3112a5f4c2f8bfe33f09048d1984c6e4a0efdf7
# body sha256:1be0be9958a47e7c1b74228744108863c66865e31247fae273ea6bdf39a2411a
# cython: language_level=3
"""dual_link, compiled: `system` is its System (inverse)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# the declaration in dual_link.h, which is not included because a header of Python may have the same name
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model dual_link_model;
    """
    ctypedef struct em_model:
        pass
    const em_model dual_link_model


system = System(PyCapsule_New(<void *>&dual_link_model, "eigenmotion.em_model", NULL), __name__)
