# eigenmotion generate rotating_spring.py
# input sha256:eececf7da8524af92b5fbfbe220e13e1ff2df8274451addce864432085de9820
# body sha256:465acb7f3bf147e62b010abbde7dbcaeda7430290437557116c7285f2feda8cc
# cython: language_level=3
"""rotating_spring, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what rotating_spring.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model rotating_spring_model;
    """
    ctypedef struct em_model:
        pass
    const em_model rotating_spring_model


system = System(PyCapsule_New(<void *>&rotating_spring_model, "eigenmotion.em_model", NULL), __name__)
