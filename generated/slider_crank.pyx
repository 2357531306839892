# eigenmotion generate slider_crank.py
# input sha256:079df517fdc6f2d3f404d5dd758d5cbf813e088173c8cf4c4fae6d88d9586fc6
# body sha256:5668146972009326cf929ccebe62b0cf0dd3045d724115b3a1b409d2c5c53f00
# cython: language_level=3
"""slider_crank, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "slider_crank.h":
    ctypedef struct em_model:
        pass
    const em_model slider_crank_model


system = System(PyCapsule_New(<void *>&slider_crank_model, "eigenmotion.em_model", NULL))
