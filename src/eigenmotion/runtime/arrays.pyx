# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Arrays in the layout of the ABI: float64, C-contiguous, of the shape that a model has."""

cimport cython
from cpython.buffer cimport PyBUF_FULL_RO
from cpython.buffer cimport PyBuffer_IsContiguous, PyBuffer_Release, PyObject_CheckBuffer, PyObject_GetBuffer
from libc.string cimport memset

import numpy as np

cdef extern from *:
    """
    /* What NumPy's headers compile into every extension as PyArrayObject_fields, which is therefore part of its ABI. */
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
    """The numbers of an array in the layout of the ABI, float64 and C-contiguous, valid as long as this object lives."""

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
        """As `hold`, for NumPy arrays of float64 in C order. A request for their buffer would take longer than its use."""
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
        """Hold a, if it is such an array, and of that shape."""
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


cdef Numbers given(object a, tuple shape, str name):
    """The numbers of a, of any stride and type; a must have that shape."""
    cdef Numbers made = Numbers.__new__(Numbers)
    if made.borrow(a, shape):
        return made
    if np.iscomplexobj(a):
        raise ValueError(f"{name} is complex; give real numbers")
    # aligned, which an array received over a network may not be
    if not made.borrow(np.require(a, np.float64, ("C", "A")), shape):
        raise ValueError(f"{name} has shape {np.shape(a)}, but this model needs {shape}")
    return made


cdef bint takes(object out, tuple shape) except -1:
    """Whether it is an array that floating point numbers can be written to: integers would lose the fraction."""
    return isinstance(out, np.ndarray) and out.dtype.kind == "f" and out.shape == shape and out.flags.writeable


cdef Numbers unset(tuple shape):
    """A new, uninitialised array."""
    cdef Numbers made = Numbers.__new__(Numbers)
    array = _empty(shape)
    if not made.read(array):
        made.hold(array, PyBUF_FULL_RO)
    return made


cdef Numbers zeros(tuple shape):
    """A new array of zeros."""
    cdef Numbers made = unset(shape)
    memset(made.data, 0, made.view.len)
    return made


cdef object constants(const double *values, int count):
    """Numbers of a model as an array (count,)."""
    return np.array([values[k] for k in range(count)], dtype=np.float64)


cdef tuple texts(const char *const *names, int count):
    """Its strings as a tuple."""
    return tuple([names[k].decode("utf-8") for k in range(count)])


cdef bint layout_is_known() except -1:
    """Whether the fields of an array are where this module reads them, compared with their buffers."""
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
