# eigenmotion generate rolling_disk.py
# input sha256:79152ce9a70780f4325278032ef1389f2d102285d0e7bce6c3bcb5c1a5a4850c
# body sha256:bffc5ee6c7bd3bba7c27ac8343456692afaa97845629efeff6577967438b082e
# cython: language_level=3
"""rolling_disk, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# what rolling_disk.h says, without the name of a file that could be one of Python's
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model rolling_disk_model;
    """
    ctypedef struct em_model:
        pass
    const em_model rolling_disk_model


system = System(PyCapsule_New(<void *>&rolling_disk_model, "eigenmotion.em_model", NULL), __name__)
