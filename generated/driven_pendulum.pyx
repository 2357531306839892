# eigenmotion generate driven_pendulum.py
# input sha256:f03e70c1bada2a6ab9bc3811e7865c0ae1b77524d6c1f3ea721379785f3676f2
# body sha256:9b73536c138f7703be709faf20d42dbae1c8fc42ad4d454ca38ad69bef138046
# cython: language_level=3
"""driven_pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what driven_pendulum.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model driven_pendulum_model;
    """
    ctypedef struct em_model:
        pass
    const em_model driven_pendulum_model


system = System(PyCapsule_New(<void *>&driven_pendulum_model, "eigenmotion.em_model", NULL), __name__)
