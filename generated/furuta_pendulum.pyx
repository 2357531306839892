# eigenmotion generate furuta_pendulum.py
# input sha256:ff36814f2b05e1933e30609683e774f079afb7c3e2680d8a3357697eb6b0dfaf
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
