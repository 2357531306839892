# eigenmotion generate rotating_spring.py
# input sha256:1a07572f289ff6b7f9e6d9fd78f4908fca44ebfff9dfb47a11d63b694d6aa118
# body sha256:4b7db4064f6905bc4303d9d8816e02eb38a3cac876f037528036e231d8958a51
# cython: language_level=3
"""rotating_spring, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "rotating_spring.h":
    ctypedef struct em_model:
        pass
    const em_model rotating_spring_model


system = System(PyCapsule_New(<void *>&rotating_spring_model, "eigenmotion.em_model", NULL))
