# eigenmotion generate jansen.py
# input sha256:f744e812ddbbe356574aebfde26a89931e0d70e4b66e96c84fbd1461918df3df
# body sha256:5a281a991a6aad4c88a6df8d4be595cc50be1809e451325b93fec2cefd7ce0c4
# cython: language_level=3
"""jansen, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what jansen.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model jansen_model;
    """
    ctypedef struct em_model:
        pass
    const em_model jansen_model


system = System(PyCapsule_New(<void *>&jansen_model, "eigenmotion.em_model", NULL), __name__)
