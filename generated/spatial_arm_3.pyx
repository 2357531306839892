# eigenmotion generate spatial_arm.py
# input sha256:123f02a70e5ee10d7729d33f668f9b52f582ed1181b23d7ac380899a4ad2caa6
# body sha256:e9dd28d1d362b6d16753ffec3b8f93f8e71d237b0f3d7f541b1da0649a55086f
# cython: language_level=3
"""spatial_arm_3, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what spatial_arm_3.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model spatial_arm_3_model;
    """
    ctypedef struct em_model:
        pass
    const em_model spatial_arm_3_model


system = System(PyCapsule_New(<void *>&spatial_arm_3_model, "eigenmotion.em_model", NULL), __name__)
