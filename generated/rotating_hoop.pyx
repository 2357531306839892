# eigenmotion generate rotating_hoop.py
# input sha256:a672e66f4b0d29e372c07c590c827762e68aba35fb998dc3ed2bf848d498158e
# body sha256:befb0f10f88e297befef38d1155908065354ed4546f873a6069b74a9f4527c68
# cython: language_level=3
"""rotating_hoop, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what rotating_hoop.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model rotating_hoop_model;
    """
    ctypedef struct em_model:
        pass
    const em_model rotating_hoop_model


system = System(PyCapsule_New(<void *>&rotating_hoop_model, "eigenmotion.em_model", NULL), __name__)
