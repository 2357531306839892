# eigenmotion generate veering.py
# input sha256:2e6e02de90e32e30ee3c86801410d8aa09018f181e6fefb7533073d61b039c6d
# body sha256:99a86f1150cdecb929056ee14847f0de29831edb2b8b38af2b4d65379cd6209a
# cython: language_level=3
"""veering, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what veering.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model veering_model;
    """
    ctypedef struct em_model:
        pass
    const em_model veering_model


system = System(PyCapsule_New(<void *>&veering_model, "eigenmotion.em_model", NULL), __name__)
