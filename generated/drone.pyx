# eigenmotion generate drone.py
# input sha256:03661c6d20f5a8cb88cd034f411466fa0dcf11c1fb135347a853d98d37b52765
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
