# eigenmotion generate rigid_body.py
# input sha256:276c660397e2ef4679bd5a8f04ffbe6e44cccaf28dd659ac5f5d4d48735d7f33
# body sha256:50ad0d2a7058b0bca3fe210a694b3b08dfead855a0d32e3624396b5822149927
# cython: language_level=3
"""rigid_body, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "rigid_body.h":
    ctypedef struct em_model:
        pass
    const em_model rigid_body_model


system = System(PyCapsule_New(<void *>&rigid_body_model, "eigenmotion.em_model", NULL))
