# eigenmotion generate quaternion_top.py
# input sha256:bf6259fcdfc628508d0a3ec4939020d96e3c787e9b0acbb82fc8715aa5a14141
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
