# eigenmotion generate chaplygin_sleigh.py
# input sha256:35e27e9d3d20f61168b3296735ce61a8edf1a8e47039a3921c2c69cbaca2e61e
# body sha256:75e129edc206249a53ab6b2e2f57a5ee6b50b7d93486a63d3a76b9d358d43e63
# cython: language_level=3
"""chaplygin_sleigh, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "chaplygin_sleigh.h":
    ctypedef struct em_model:
        pass
    const em_model chaplygin_sleigh_model


system = System(PyCapsule_New(<void *>&chaplygin_sleigh_model, "eigenmotion.em_model", NULL))
