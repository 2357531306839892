# eigenmotion generate elastic_pendulum.py
# input sha256:0ef93e4c29cf9a08fc935e31d47b41a8de7fcfb3b1c1f5e770622d5afc8920a2
# body sha256:26054fef6e909f486d914bf9047a2240e743e0dfd511565c6d96bf41382c1bb5
# cython: language_level=3
"""elastic_pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what elastic_pendulum.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model elastic_pendulum_model;
    """
    ctypedef struct em_model:
        pass
    const em_model elastic_pendulum_model


system = System(PyCapsule_New(<void *>&elastic_pendulum_model, "eigenmotion.em_model", NULL), __name__)
