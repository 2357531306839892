# eigenmotion generate sphere.py
# input sha256:fbd5f25b368f8e9a515de98d41a0d309d988e20f65c0862d1dd5d5e53c4ea918
# body sha256:ad7d3022684d80b2355320232a2d83e089d5ac1818aba55b09ccffb2a3c3940e
# cython: language_level=3
"""sphere, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "sphere.h":
    ctypedef struct em_model:
        pass
    const em_model sphere_model


system = System(PyCapsule_New(<void *>&sphere_model, "eigenmotion.em_model", NULL))
