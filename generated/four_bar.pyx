# eigenmotion generate four_bar.py
# input sha256:9fe7bdb78b834e7e8475b88925014a030ceb5850e7b22ac03d9a6ab39c8b7da4
# body sha256:65712e7bb12fd96083e2730537367d00421fd88c397d91e8a760174b59fa556c
# cython: language_level=3
"""four_bar, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "four_bar.h":
    ctypedef struct em_model:
        pass
    const em_model four_bar_model


system = System(PyCapsule_New(<void *>&four_bar_model, "eigenmotion.em_model", NULL))
