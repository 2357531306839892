# eigenmotion generate double_pendulum.py
# input sha256:2ee79731755da9daa20574f88d3a26c7e7b015041bc7044129593c19b6fd90b1
# body sha256:3e92a7829e1b2757265232b260664d89e1d01476c929f0b67c56d2d2c090f1d4
# cython: language_level=3
"""double_pendulum, compiled: `system` is its System (eigenfactor)."""

from cpython.pycapsule cimport PyCapsule_New

from eigenmotion.system import System


cdef extern from "double_pendulum.h":
    ctypedef struct em_model:
        pass
    const em_model double_pendulum_model


system = System(PyCapsule_New(<void *>&double_pendulum_model, "eigenmotion.em_model", NULL))
