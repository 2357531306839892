# eigenmotion generate dual_link.py --formulation cholesky
# input sha256:df7bb6a0e8a7ccae115ffd5a4199255e043926e1730038f5561b0029f974f77b
# body sha256:6ac60c48ec97cc436d4d412dcc348a4a1d490724b5dbce8167952319c50df9dd
# cython: language_level=3
"""dual_link, compiled: `system` is its System (cholesky)."""

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
