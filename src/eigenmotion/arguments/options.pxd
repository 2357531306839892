# Declarations of options.pyx: arguments as numbers.

from ..runtime.arrays cimport Numbers


cdef double number_of(object argument, str what) except? -1.0
cdef Numbers array_of(object argument, tuple shape)
