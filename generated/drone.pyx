# eigenmotion generate drone.py
# input sha256:4f11df1f7d176811d0bb3694586688568505c1f4ec024bed8c913586a1914019
# body sha256:165e0e338f3befec29b9235f390a556396c96745503de3a652dc7e85df50afb6
# cython: language_level=3
"""drone, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what drone.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model drone_model;
    """
    ctypedef struct em_model:
        pass
    const em_model drone_model


system = System(PyCapsule_New(<void *>&drone_model, "eigenmotion.em_model", NULL), __name__)
