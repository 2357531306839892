# eigenmotion generate slider_crank.py
# input sha256:7cb77f22c00e11b906340db647b0e2361b37b4e94c0c24a7db9afc9e3e99b587
# body sha256:797ef149b3d9dea834adfaf2fee84d33be115a4205bc2bef12a6b282ed89b62e
# cython: language_level=3
"""slider_crank, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what slider_crank.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model slider_crank_model;
    """
    ctypedef struct em_model:
        pass
    const em_model slider_crank_model


system = System(PyCapsule_New(<void *>&slider_crank_model, "eigenmotion.em_model", NULL), __name__)
