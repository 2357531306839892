# eigenmotion generate dual_link.py
# input sha256:ed71627c20e7d84c368bacf9bb633f178992fb7d32b71d3830e7002e4289f2e0
# body sha256:23f31166585f3e692c419c8da4a94543a1479ac68dfe622bb36b742c2d49f04b
# cython: language_level=3
"""dual_link, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "dual_link.h":
    ctypedef struct em_model:
        pass
    const em_model dual_link_model


system = System(PyCapsule_New(<void *>&dual_link_model, "eigenmotion.em_model", NULL))
