# eigenmotion generate clock.py
# input sha256:5eb67c8748c02dcc6bbf57a5b1dbe700de17cc670abb7136047bcfa5d3ee7185
# body sha256:34fec3cd08dbece5b0fe86d8acacc6c91ad35831a694c9ba4a28997ac79a47f2
# cython: language_level=3
"""clock, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what clock.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model clock_model;
    """
    ctypedef struct em_model:
        pass
    const em_model clock_model


system = System(PyCapsule_New(<void *>&clock_model, "eigenmotion.em_model", NULL), __name__)
