# eigenmotion generate sphere.py
# input sha256:87fcfceb530674a524220a6812c1bd35ccba13b97f87d16d8ddc76de85c67965
# body sha256:913666d32f7b1c8f0bedede469dd3df1439cba132305e6db137738240d71b597
# cython: language_level=3
"""sphere, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what sphere.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model sphere_model;
    """
    ctypedef struct em_model:
        pass
    const em_model sphere_model


system = System(PyCapsule_New(<void *>&sphere_model, "eigenmotion.em_model", NULL), __name__)
