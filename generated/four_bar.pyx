# eigenmotion generate four_bar.py
# input sha256:b4c583928ba1d4df4cfe154941caa7e2d2955825501d803b35f7c71dee2c238e
# body sha256:b9878d8f96c30fe541bf67f8249ed731817346ee39ab32598ba10afb7a28baf3
# cython: language_level=3
"""four_bar, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what four_bar.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model four_bar_model;
    """
    ctypedef struct em_model:
        pass
    const em_model four_bar_model


system = System(PyCapsule_New(<void *>&four_bar_model, "eigenmotion.em_model", NULL), __name__)
