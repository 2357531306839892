# eigenmotion generate chaplygin_sleigh.py
# input sha256:3d5f0048bd7d07f166f5e27e487e5ada2df1ffaf99a10809e7c8523799804238
# body sha256:b2f12360cf882c8e88caf74568b7e0e3f78ddfcaa968002766db55dd8a39d8bd
# cython: language_level=3
"""chaplygin_sleigh, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what chaplygin_sleigh.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model chaplygin_sleigh_model;
    """
    ctypedef struct em_model:
        pass
    const em_model chaplygin_sleigh_model


system = System(PyCapsule_New(<void *>&chaplygin_sleigh_model, "eigenmotion.em_model", NULL), __name__)
