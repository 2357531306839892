# eigenmotion generate pendulum_with_stop.py
# input sha256:96f15be48b86c6215654e00a5f375071dfab39de7f4d0f3ef60b1bd7711716fd
# body sha256:f08ce14904e1bac0556911ffdf1e36b31008b878738231c44899013c62422711
# cython: language_level=3
"""pendulum_with_stop, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what pendulum_with_stop.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model pendulum_with_stop_model;
    """
    ctypedef struct em_model:
        pass
    const em_model pendulum_with_stop_model


system = System(PyCapsule_New(<void *>&pendulum_with_stop_model, "eigenmotion.em_model", NULL), __name__)
