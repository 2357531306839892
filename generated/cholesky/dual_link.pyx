# eigenmotion generate dual_link.py --formulation cholesky
# input sha256:ee6f21131ce26700b20eff2c6c1d1414598ccb2d41634016406f7e75ca1151d6
# body sha256:49511aa0673d22a717f1f1d4cbba16e26ccc969acfcbbf3a4d84a6c621ddd5ab
# cython: language_level=3
"""dual_link, compiled: `system` is its System (cholesky)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# the declaration in dual_link.h, which is not included because a header of Python may have the same name
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model dual_link_model;
    """
    ctypedef struct em_model:
        pass
    const em_model dual_link_model


system = System(PyCapsule_New(<void *>&dual_link_model, "eigenmotion.em_model", NULL), __name__)
