# eigenmotion generate four_bar.py
# input sha256:10ea64c65b0625c37ac606379d8e7cc0bf2575aa65b654f2e2d516bf1b2ce748
# body sha256:bae5c2f26671f34790b45b86208e7ce0c094b4396b137ee50af4696d68a7b010
# cython: language_level=3
"""four_bar, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# the declaration in four_bar.h, which is not included because a header of Python may have the same name
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model four_bar_model;
    """
    ctypedef struct em_model:
        pass
    const em_model four_bar_model


system = System(PyCapsule_New(<void *>&four_bar_model, "eigenmotion.em_model", NULL), __name__)
