# eigenmotion generate pendulum.py
# input sha256:747372358c3f115f509f99a239330acefa4cd44def4742bcb2d1d0d38724b30b
# body sha256:5aefb83399097e17c1a56e5aaad4ccdee8fa18ffbb3b611a3c519c00cbcd3abe
# cython: language_level=3
"""pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "pendulum.h":
    ctypedef struct em_model:
        pass
    const em_model pendulum_model


system = System(PyCapsule_New(<void *>&pendulum_model, "eigenmotion.em_model", NULL))
