# eigenmotion generate sphere.py
# input sha256:05e340b5560a176d60eaba7628c380e1c4df329f4f58343dd20ce5755e07588b
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
