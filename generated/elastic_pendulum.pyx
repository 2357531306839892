# eigenmotion generate elastic_pendulum.py
# input sha256:39e60f85e6f5c9138edbea7b5f97cbd3c8cf4aaad2f86d8dfe5ab9121ba1fa69
# body sha256:e86985e0974be5acdc04a8665cc4bf0c5c7c51923d1abd9d8f382db5b3ef7755
# cython: language_level=3
"""elastic_pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "elastic_pendulum.h":
    ctypedef struct em_model:
        pass
    const em_model elastic_pendulum_model


system = System(PyCapsule_New(<void *>&elastic_pendulum_model, "eigenmotion.em_model", NULL))
