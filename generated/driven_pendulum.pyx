# eigenmotion generate driven_pendulum.py
# input sha256:3f6cc5d134084e792e8603a9722d4a89baa4d6c6873c687c0030b4244b9a1841
# body sha256:e28a624deef4ac3288ad644248c98a83b0e0008d7b653e55c79400d8610d7b2b
# cython: language_level=3
"""driven_pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "driven_pendulum.h":
    ctypedef struct em_model:
        pass
    const em_model driven_pendulum_model


system = System(PyCapsule_New(<void *>&driven_pendulum_model, "eigenmotion.em_model", NULL))
