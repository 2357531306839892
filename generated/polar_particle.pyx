# eigenmotion generate polar_particle.py
# input sha256:a5a4c120f61c6010893266c3b8388733a7ed17cc17263602f481dafbf1da45e9
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
