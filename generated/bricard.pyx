# eigenmotion generate bricard.py
# input sha256:84c95ed96c00d0f879f20a64f2de802bc07fecba092ce5dcb4db62e1a3957270
# body sha256:0d66ef3a20d4fe41a185a0d19fe180d1aa73f53cf00c722e720caa87f38cacad
# cython: language_level=3
"""bricard, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what bricard.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model bricard_model;
    """
    ctypedef struct em_model:
        pass
    const em_model bricard_model


system = System(PyCapsule_New(<void *>&bricard_model, "eigenmotion.em_model", NULL), __name__)
