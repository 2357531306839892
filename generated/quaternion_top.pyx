# eigenmotion generate quaternion_top.py
# input sha256:0cb8bde97f7a54b959afa6233ef8b22ba968fd2b37b477c410a8abc46e5c03d5
# body sha256:a5b16b1e02bcf0f96f0db8440e0b2c1f94518942798bbb1854ad3bbde51e3e58
# cython: language_level=3
"""quaternion_top, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what quaternion_top.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model quaternion_top_model;
    """
    ctypedef struct em_model:
        pass
    const em_model quaternion_top_model


system = System(PyCapsule_New(<void *>&quaternion_top_model, "eigenmotion.em_model", NULL), __name__)
