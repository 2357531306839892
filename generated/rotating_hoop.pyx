# eigenmotion generate rotating_hoop.py
# input sha256:27c9b161d2897126bbb058401d1b419c4a8abb4619b4a198898b8f5f4d863812
# body sha256:e618e61a267a61a20f91f451729d9ad5079518697ce78ebc84e2ab8f0ce33231
# cython: language_level=3
"""rotating_hoop, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "rotating_hoop.h":
    ctypedef struct em_model:
        pass
    const em_model rotating_hoop_model


system = System(PyCapsule_New(<void *>&rotating_hoop_model, "eigenmotion.em_model", NULL))
