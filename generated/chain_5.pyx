# eigenmotion generate chain.py
# input sha256:8ba68851fee814b346c973e9ca6c1ce5f61de93200b6b9bac0ec2ec403af0c06
# body sha256:aa8a45672f18f8d1c527a03443c91911f0437b9fc1296629b627d94a760c4c77
# cython: language_level=3
"""chain_5, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "chain_5.h":
    ctypedef struct em_model:
        pass
    const em_model chain_5_model


system = System(PyCapsule_New(<void *>&chain_5_model, "eigenmotion.em_model", NULL))
