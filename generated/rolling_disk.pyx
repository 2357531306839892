# eigenmotion generate rolling_disk.py
# input sha256:54f552f8bf8eaf402fe74f441e34761761c25ec8db4dad6aa08f8e7416ea6409
# body sha256:d0c1f6c10ccc54b4076de0976f726a53cf661bc6168488cacbc0651b68d79b09
# cython: language_level=3
"""rolling_disk, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


# the declaration in rolling_disk.h, which is not included because a header of Python may have the same name
cdef extern from *:
    """
    #include "eigenmotion.h"
    extern const em_model rolling_disk_model;
    """
    ctypedef struct em_model:
        pass
    const em_model rolling_disk_model


system = System(PyCapsule_New(<void *>&rolling_disk_model, "eigenmotion.em_model", NULL), __name__)
