# eigenmotion generate polar_particle.py
# input sha256:2ebb6373cfc4d6f8793f1aa682c138d933aea6a77484dc28ef97956eddbfc9f3
# body sha256:1ffd528941677918bda82f9db62249b8698defcc0d76634f3e7906e1533800b6
# cython: language_level=3
"""polar_particle, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what polar_particle.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model polar_particle_model;
    """
    ctypedef struct em_model:
        pass
    const em_model polar_particle_model


system = System(PyCapsule_New(<void *>&polar_particle_model, "eigenmotion.em_model", NULL), __name__)
