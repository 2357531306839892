# Declarations of arrays.pyx for the other modules of the runtime.

cimport cython
from libc.math cimport NAN


@cython.final
cdef class Numbers:
    cdef Py_buffer view
    cdef object array
    cdef double *data
    cdef Py_ssize_t width

    cdef int hold(self, object array, int flags) except -1
    cdef bint read(self, object array) noexcept
    cdef bint borrow(self, object a, tuple shape) except -1
    cdef bint overlaps(self, Numbers other) noexcept

    cdef inline double *row(self, Py_ssize_t i) noexcept nogil:
        """The numbers at index i of the first axis."""
        return self.data + i * self.width


cdef Numbers floats(object a, tuple shape, str name)
cdef bint is_float_output(object out, tuple shape) except -1
cdef Numbers unset(tuple shape)
cdef Numbers zeros(tuple shape)
cdef object constants(const double *values, int count)
cdef tuple texts(const char *const *names, int count)


cdef inline void blank(double *a, Py_ssize_t count) noexcept nogil:
    cdef Py_ssize_t k
    for k in range(count):
        a[k] = NAN
