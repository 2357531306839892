# eigenmotion generate dual_link.py --formulation inverse
# input sha256:e6ddb15e469a0bd43c4b0cb8aeadde7cfcb573a5863a772371f4b6ef5fb93f76
# body sha256:f0c4186187de0ac2d9907de5c08c05d111e3622cd194b354e06beacb360c3bc4
# cython: language_level=3
"""dual_link, compiled: `system` is its System (inverse)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what dual_link.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model dual_link_model;
    """
    ctypedef struct em_model:
        pass
    const em_model dual_link_model


system = System(PyCapsule_New(<void *>&dual_link_model, "eigenmotion.em_model", NULL), __name__)
