# eigenmotion generate rolling_disk.py
# input sha256:3f0531d46c92721d28c96849a9efaa2bd4564a5e64984ea08e3c5e0763af2068
# body sha256:dde3c6362b67572b230596ed165110b9fa0e7e6eada4abf8e1f645f74c1a4c76
# cython: language_level=3
"""rolling_disk, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "rolling_disk.h":
    ctypedef struct em_model:
        pass
    const em_model rolling_disk_model


system = System(PyCapsule_New(<void *>&rolling_disk_model, "eigenmotion.em_model", NULL))
