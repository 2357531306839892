# eigenmotion generate driven_pendulum.py
# input sha256:4e9893cc5e7c5dc0d481cf1470a3ef3a5e1a3b84e5f7e00dadf8b82698fb15df
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
