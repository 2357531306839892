# eigenmotion generate furuta_pendulum.py
# input sha256:dced2f2c1ea16d2797caf600d1ec2362b8e6a46eb1ab952a01482755b88fb96a
# body sha256:3ff5ae93297dfa3fb40d466c8aa79e4a32f16c4e2fef8c81a34bad82011b6d8a
# cython: language_level=3
"""furuta_pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what furuta_pendulum.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model furuta_pendulum_model;
    """
    ctypedef struct em_model:
        pass
    const em_model furuta_pendulum_model


system = System(PyCapsule_New(<void *>&furuta_pendulum_model, "eigenmotion.em_model", NULL), __name__)
