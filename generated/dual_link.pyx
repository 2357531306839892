# eigenmotion generate dual_link.py
# input sha256:db7ffc172ffdf80cd8a7345118304d621e67bf6a384cc2081b57636f2bda4deb
# body sha256:8e7848d838dd9b669e0c91051cd5f2061c099146a4f1aac961dcceb2840f0244
# cython: language_level=3
"""dual_link, compiled: `system` is its System (eigenfactor)."""

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
