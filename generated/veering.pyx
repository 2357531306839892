# eigenmotion generate veering.py
# input sha256:c0628f6e11b50e2406d57ef2cd6afc060053c05a03b45712e1c9a6cf369da9c7
# body sha256:c6b91e8ffc8252306553ee6a341e4bb6b3fdc7638b8607ead8fd5317fed466ef
# cython: language_level=3
"""veering, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "veering.h":
    ctypedef struct em_model:
        pass
    const em_model veering_model


system = System(PyCapsule_New(<void *>&veering_model, "eigenmotion.em_model", NULL))
