# eigenmotion generate puma.py
# input sha256:44f9309bb8b2d719e1a6d8e72a68752f8590b0520274b45dad0cbd7ef656c8aa
# body sha256:58dc20839a2b91691b8388baf2b01826469812b78ee322a696ab78869cd3dee2
# cython: language_level=3
"""puma, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what puma.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model puma_model;
    """
    ctypedef struct em_model:
        pass
    const em_model puma_model


system = System(PyCapsule_New(<void *>&puma_model, "eigenmotion.em_model", NULL), __name__)
