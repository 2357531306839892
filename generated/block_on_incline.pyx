# eigenmotion generate block_on_incline.py
# input sha256:4e77346be5abf3a7f0fe4d15f59885874f78e36aee412330700bde3f765b0ca6
# body sha256:1308f920d794b25ae602c2c26fd1046d7592d5a0fffaf52c837c15d17895b50a
# cython: language_level=3
"""block_on_incline, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what block_on_incline.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model block_on_incline_model;
    """
    ctypedef struct em_model:
        pass
    const em_model block_on_incline_model


system = System(PyCapsule_New(<void *>&block_on_incline_model, "eigenmotion.em_model", NULL), __name__)
