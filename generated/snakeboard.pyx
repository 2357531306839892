# eigenmotion generate snakeboard.py
# input sha256:d70ece58f05e5f9e65f4727d2ec66dffb4d52447c0fb6fbf54b7fa75292c5627
# body sha256:182bab93e2be4587f4fae5b6c13c78a2bdc16fd27b20a3a7b20aaeffc94577b5
# cython: language_level=3
"""snakeboard, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what snakeboard.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model snakeboard_model;
    """
    ctypedef struct em_model:
        pass
    const em_model snakeboard_model


system = System(PyCapsule_New(<void *>&snakeboard_model, "eigenmotion.em_model", NULL), __name__)
