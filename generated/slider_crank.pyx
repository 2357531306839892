# eigenmotion generate slider_crank.py
# input sha256:ec762a02c93cc8269d579033fc99edddab6d23bbe9acf64e06e026178f6ef306
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
