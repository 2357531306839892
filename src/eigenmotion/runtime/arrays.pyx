# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Arrays as the ABI takes them: float64, C-contiguous, of the shape that a model has."""

cimport cython
from cpython.buffer cimport PyBUF_FULL_RO, PyBUF_ND
from cpython.buffer cimport PyBuffer_IsContiguous, PyBuffer_Release, PyObject_CheckBuffer, PyObject_GetBuffer

import numpy as np

_zeros = np.zeros


@cython.final
@cython.freelist(16)
cdef class Numbers:
    """The numbers of an array as the ABI takes them, float64 and C-contiguous, for as long as this object lives."""

    def __dealloc__(self):
        PyBuffer_Release(&self.view)

    cdef int hold(self, object array, int flags) except -1:
        cdef int axis
        PyObject_GetBuffer(array, &self.view, flags)
        self.array, self.data, self.width = array, <double *> self.view.buf, 1
        for axis in range(1, self.view.ndim):
            self.width *= self.view.shape[axis]
        return 0

    cdef bint borrow(self, object a, tuple shape) except -1:
        """Hold a, if it is such an array, and of that shape."""
        cdef int axis
        if not PyObject_CheckBuffer(a):
            return False
        self.hold(a, PyBUF_FULL_RO)
        cdef bint fits = (self.view.ndim == len(shape) and self.view.format[0] == c"d" and self.view.format[1] == 0
                          and PyBuffer_IsContiguous(&self.view, b"C"))
        for axis in range(self.view.ndim if fits else 0):
            fits = fits and self.view.shape[axis] == <Py_ssize_t> shape[axis]
        if not fits:
            PyBuffer_Release(&self.view)
        return fits

    cdef bint overlaps(self, Numbers other) noexcept:
        cdef char *mine = <char *> self.view.buf
        cdef char *theirs = <char *> other.view.buf
        return mine < theirs + other.view.len and theirs < mine + self.view.len


cdef Numbers given(object a, tuple shape, str name):
    """The numbers of a, of any stride and type; it must have that shape."""
    cdef Numbers made = Numbers.__new__(Numbers)
    if made.borrow(a, shape):
        return made
    if np.iscomplexobj(a):
        raise ValueError(f"{name} is complex; give real numbers")
    # aligned, which what came over a network need not be
    if not made.borrow(np.require(a, np.float64, ("C", "A")), shape):
        raise ValueError(f"{name} has shape {np.shape(a)}, but this model needs {shape}")
    return made


cdef bint takes(object out, tuple shape) except -1:
    """Whether it is an array that floating point numbers can be written to: integers would lose what is behind the point."""
    return isinstance(out, np.ndarray) and out.dtype.kind == "f" and out.shape == shape and out.flags.writeable


cdef Numbers zeros(tuple shape):
    """A new array of zeros."""
    cdef Numbers made = Numbers.__new__(Numbers)
    made.hold(_zeros(shape), PyBUF_ND)
    return made
