# eigenmotion generate spatial_arm.py
# input sha256:0f7279d0cecc46f32a75b8e3ab9428b069bfc2e0b0520613abeb925864269d53
# body sha256:ed6a0e3fc60fec08892dd77e3307ef4502a90659f861d1efcea2490b6b0afcbe
# cython: language_level=3
"""spatial_arm_3, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "spatial_arm_3.h":
    ctypedef struct em_model:
        pass
    const em_model spatial_arm_3_model


system = System(PyCapsule_New(<void *>&spatial_arm_3_model, "eigenmotion.em_model", NULL))
