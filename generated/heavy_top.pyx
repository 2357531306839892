# eigenmotion generate heavy_top.py
# input sha256:0e18cb0496acfee18350f5d57ff9526a230712937b3ad18789bf499d91e5dec6
# body sha256:cf607dfa5927d1dbfc76bd53d9e8f5943b6c427ad23a2cc528d8ff8dff4763e6
# cython: language_level=3
"""heavy_top, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "heavy_top.h":
    ctypedef struct em_model:
        pass
    const em_model heavy_top_model


system = System(PyCapsule_New(<void *>&heavy_top_model, "eigenmotion.em_model", NULL))
