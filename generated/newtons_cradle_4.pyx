# eigenmotion generate newtons_cradle.py
# input sha256:b7b2f2f815633c0c13ec47b71b8d50d30eeb9cbde0c35a3d76e313769a9245db
# body sha256:5a2a62b4a5ad2a2fee7e5747b9bae159b371b23de33fbe01eb0d5cd9a4dfdbab
# cython: language_level=3
"""newtons_cradle_4, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what newtons_cradle_4.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model newtons_cradle_4_model;
    """
    ctypedef struct em_model:
        pass
    const em_model newtons_cradle_4_model


system = System(PyCapsule_New(<void *>&newtons_cradle_4_model, "eigenmotion.em_model", NULL), __name__)
