# eigenmotion generate dual_link.py --formulation lagrange
# input sha256:7b059552c245cdd53260302a22a4501c7fbc28c7ec192ef324b592c3c23ccf18
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
