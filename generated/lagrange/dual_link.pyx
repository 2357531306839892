# eigenmotion generate dual_link.py --formulation lagrange
# input sha256:7b059552c245cdd53260302a22a4501c7fbc28c7ec192ef324b592c3c23ccf18
# body sha256:a28bcac6d4c99c6d53aba38793773059eac3f7e270390b87d3cf35e54b73349f
# cython: language_level=3
"""dual_link, compiled: `system` is its System (lagrange)."""

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
