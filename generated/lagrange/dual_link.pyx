# eigenmotion generate dual_link.py --formulation lagrange
# input sha256:831cacef6d0f2b457bc168580b239f60e0d317722a8f3f92538eb5b78a31990d
# body sha256:22b52f4d6784b9d85f82de5bd8d2da6934b62007d6309031cba0260bebdd316a
# cython: language_level=3
"""dual_link, compiled: `system` is its System (lagrange)."""

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
