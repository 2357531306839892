# eigenmotion generate dual_link.py
# input sha256:265d8892a5a4b7aeb90d2a04585617a209d831a7a9ea64b4efac5e5060f02063
# body sha256:f05b7911c70e5eefd1489f4c4dff5dc00983cd8ba810a115c71f7a81be166b96
# cython: language_level=3
"""dual_link, compiled: `system` is its System (eigenfactor)."""

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
