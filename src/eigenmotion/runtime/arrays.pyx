# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Arrays in the layout of the ABI: float64, C-contiguous, with the shape that a model needs."""

cimport cython
from cpython.buffer cimport PyBUF_FULL_RO
from cpython.buffer cimport PyBuffer_IsContiguous, PyBuffer_Release, PyObject_CheckBuffer, PyObject_GetBuffer
from libc.string cimport memset

import numpy as np

cdef extern from *:
    """
    /* PyArrayObject_fields of NumPy's headers, which every extension compiles in: part of NumPy's ABI. */
    typedef struct {
        PyObject_HEAD
        char *data;
        int nd;
        Py_ssize_t *dimensions, *strides;
        PyObject *base, *descr;
        int flags;
    } em_ndarray;
    """
    ctypedef struct em_ndarray:
        char *data
        int nd
        Py_ssize_t *dimensions
        Py_ssize_t *strides
        void *descr
        int flags

cdef enum:
    C_CONTIGUOUS = 0x1
    ALIGNED = 0x100
    WRITEABLE = 0x400
    AS_IT_IS = C_CONTIGUOUS | ALIGNED

cdef object _array = np.ndarray, _double = np.dtype(np.float64), _empty = np.empty


@cython.final
@cython.freelist(16)
cdef class Numbers:
    """The numbers of a float64, C-contiguous array, valid as long as this object lives."""

    def __dealloc__(self):
        PyBuffer_Release(&self.view)

    cdef int hold(self, object array, int flags) except -1:
        cdef int axis
        PyObject_GetBuffer(array, &self.view, flags)
        self.array, self.data, self.width = array, <double *> self.view.buf, 1
        for axis in range(1, self.view.ndim):
            self.width *= self.view.shape[axis]
        return 0

    cdef bint read(self, object array) noexcept:
        """As `hold`, but only for NumPy arrays of float64 in C order, and without the buffer protocol, which is slower."""
        cdef em_ndarray *fields = <em_ndarray *> array
        cdef int axis
        if not _LAYOUT_IS_KNOWN or type(array) is not _array or fields.descr != <void *> _double:
            return False
        if fields.flags & AS_IT_IS != AS_IT_IS:
            return False
        self.view.buf, self.view.ndim, self.view.shape = fields.data, fields.nd, fields.dimensions
        self.view.readonly, self.view.len = not fields.flags & WRITEABLE, sizeof(double)
        self.array, self.data, self.width = array, <double *> fields.data, 1
        for axis in range(fields.nd):
            self.view.len *= fields.dimensions[axis]
            if axis > 0:
                self.width *= fields.dimensions[axis]
        return True

    cdef bint borrow(self, object a, tuple shape) except -1:
        """Hold a if it is a float64, C-contiguous array of that shape; return whether it is."""
        cdef int axis
        cdef bint fits
        if self.read(a):
            fits = self.view.ndim == len(shape)
            for axis in range(self.view.ndim if fits else 0):
                fits = fits and self.view.shape[axis] == <Py_ssize_t> shape[axis]
            return fits
        if not PyObject_CheckBuffer(a):
            return False
        self.hold(a, PyBUF_FULL_RO)
        fits = (self.view.ndim == len(shape) and self.view.format[0] == c"d" and self.view.format[1] == 0
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


cdef Numbers floats(object a, tuple shape, str name):
    """The numbers of a as float64; a may have any strides and type, but must have that shape."""
    cdef Numbers numbers = Numbers.__new__(Numbers)
    if numbers.borrow(a, shape):
        return numbers
    if np.iscomplexobj(a):
        raise ValueError(f"{name} is complex; give real numbers")
    # aligned, which an array received over a network may not be
    if not numbers.borrow(np.require(a, np.float64, ("C", "A")), shape):
        raise ValueError(f"{name} has shape {np.shape(a)}, but this model needs {shape}")
    return numbers


cdef bint is_float_output(object out, tuple shape) except -1:
    """Whether `out` is a writable array of floating point numbers (integers would lose the fraction)."""
    return isinstance(out, np.ndarray) and out.dtype.kind == "f" and out.shape == shape and out.flags.writeable


cdef Numbers unset(tuple shape):
    """A new, uninitialised array."""
    cdef Numbers numbers = Numbers.__new__(Numbers)
    array = _empty(shape)
    if not numbers.read(array):
        numbers.hold(array, PyBUF_FULL_RO)
    return numbers


cdef Numbers zeros(tuple shape):
    """A new array of zeros."""
    cdef Numbers numbers = unset(shape)
    memset(numbers.data, 0, numbers.view.len)
    return numbers


cdef object constants(const double *values, int count):
    """A copy of `count` numbers of a model as an array."""
    return np.array([values[k] for k in range(count)], dtype=np.float64)


cdef tuple texts(const char *const *names, int count):
    """C strings of a model as a tuple."""
    return tuple([names[k].decode("utf-8") for k in range(count)])


cdef bint layout_is_known() except -1:
    """Whether NumPy's arrays have the fields of em_ndarray: compares them with what the buffer protocol returns."""
    cdef Py_buffer view
    cdef em_ndarray *fields
    cdef bint known = True
    cdef int axis
    for array, flags in ((np.zeros((2, 3)), AS_IT_IS | WRITEABLE), (np.zeros((2, 3))[:, 1:], ALIGNED | WRITEABLE)):
        for writes in (True, False):
            array.flags.writeable = writes
            fields = <em_ndarray *> array
            PyObject_GetBuffer(array, &view, PyBUF_FULL_RO)
            known = known and fields.data == <char *> view.buf and fields.nd == view.ndim == 2
            for axis in range(2 if known else 0):
                known = known and fields.dimensions[axis] == view.shape[axis] and fields.strides[axis] == view.strides[axis]
            known = known and fields.descr == <void *> array.dtype and fields.descr == <void *> _double
            known = known and fields.flags & (AS_IT_IS | WRITEABLE) == (flags if writes else flags & ~WRITEABLE)
            PyBuffer_Release(&view)
    return known


cdef bint _LAYOUT_IS_KNOWN = False
_LAYOUT_IS_KNOWN = layout_is_known()
