# eigenmotion generate polar_particle.py
# input sha256:ed5cf79bd8522a8ce3241ac845364961f899831169ae8ec52c04780226a388fd
# body sha256:5470eb4fc0595f4155247e9500c4bded1114c52b2602329f3a0b5db9780e5405
# cython: language_level=3
"""polar_particle, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "polar_particle.h":
    ctypedef struct em_model:
        pass
    const em_model polar_particle_model


system = System(PyCapsule_New(<void *>&polar_particle_model, "eigenmotion.em_model", NULL))
