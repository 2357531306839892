# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Functions of one compiled model, evaluated at k states: t (k,), x and v (k, n), y (k, n_state), u (k, n_inputs).

Rows at which a function has no value are NaN.
"""

from libc.math cimport fabs, isnan
from libc.string cimport memcpy

from .abi cimport em_fault, em_inverse_check
from .arrays cimport Numbers, blank, floats, zeros
from .assumptions cimport em_check_declared
from .kinematics cimport EM_FRAME, em_body_jacobian, em_body_pose
from .point cimport Actuators, PointModel, Prepared
from .start cimport em_factored_matrix


cdef class CompiledModel(PointModel):
    """One `em_model`: adds evaluation at many states to `PointModel`."""

    @property
    def declared(self):
        """The declared assumptions of parameters, coordinates and inputs as text, "" for none; () if no symbol has any."""
        cdef int count = 0 if self.model.declared == NULL else self.model.n_parameters + self.n + self.n_inputs
        return tuple([self.model.declared[k].words.decode("utf-8") for k in range(count)])

    cdef int refuse(self, int first, int count, values, str what) except -1:
        cdef em_fault fault
        cdef Numbers numbers
        if self.model.declared != NULL and count > 0:
            numbers = floats(values, (count,), what)
            if em_check_declared(self.model.declared, first, count, numbers.data, &fault) != 0:
                raise self.failure(&fault)
        return 0

    def check_parameters(self, values):
        """Raise EvaluationError if a value violates the assumption of its symbol (as `prepare` does)."""
        self.refuse(0, self.model.n_parameters, values, "parameters")

    def check_start(self, x):
        """As `check_parameters`, for the x (n) of a start."""
        self.refuse(self.model.n_parameters, self.n, x, "x")

    def check_inputs(self, u):
        """As `check_parameters`, for u (n_inputs)."""
        self.refuse(self.model.n_parameters + self.n, self.n_inputs, u, "inputs")

    @property
    def bodies(self):
        """Names of the bodies; "" of a part of a joint made of several."""
        return tuple([self.model.bodies[k].name.decode("utf-8") for k in range(self.model.n_bodies)])

    cdef Numbers frames(self, Prepared c):
        """The numbers (n_bodies, EM_FRAME) of the joints."""
        cdef Numbers numbers = zeros((self.model.n_bodies, EM_FRAME))
        self.model.frames(c.c, numbers.data)
        return numbers

    def pose_rows(self, int body, x, Prepared c not None):
        """R (k, 3, 3), p (k, 3) of a body, given by its number."""
        cdef Py_ssize_t i, k = len(x)
        cdef Numbers q = floats(x, (k, self.n), "x"), R = zeros((k, 3, 3)), p = zeros((k, 3)), numbers = self.frames(c)
        with nogil:
            for i in range(k):
                em_body_pose(self.model, body, q.row(i), numbers.data, R.row(i), p.row(i))
        return R.array, p.array

    def body_jacobian_rows(self, int body, point, x, Prepared c not None):
        """J (k, 6, n) of a point (3) of a body, without the columns of first-order states."""
        cdef Py_ssize_t i, k = len(x)
        cdef Numbers q = floats(x, (k, self.n), "x"), at = floats(point, (3,), "point"), numbers = self.frames(c)
        cdef Numbers J = zeros((k, 6, self.n_coordinates))
        with nogil:
            for i in range(k):
                em_body_jacobian(self.model, body, at.data, q.row(i), numbers.data, self.n_coordinates, J.row(i))
        return J.array

    def state_rows(self, t, x, v, Prepared c not None):
        """y (k, n_state), published meaning; eigenfactors are continuous from row to row."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers y = zeros((k, self.n_state))
        with nogil:
            for i in range(k):
                if i > 0:
                    memcpy(y.row(i), y.row(i - 1), self.n_state * sizeof(double))
                if self.model.state(T.data[i], q.row(i), w.row(i), c.c, y.row(i), &fault) != 0:
                    blank(y.row(i), self.n_state)
        return y.array

    def velocity_rows(self, t, y, Prepared c not None):
        """v (k, n)."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), Y = floats(y, (k, self.n_state), "y"), v = zeros((k, self.n))
        with nogil:
            for i in range(k):
                if self.model.velocity(T.data[i], Y.row(i), c.c, v.row(i), &fault) != 0:
                    blank(v.row(i), self.n)
        return v.array

    def energy_rows(self, t, x, v, Prepared c not None):
        """T2, T1, T0, V as (k, 4)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers e = zeros((k, 4))
        with nogil:
            for i in range(k):
                self.model.energy(T.data[i], q.row(i), w.row(i), c.c, e.row(i))
        return e.array

    def acceleration_rows(self, t, x, v, u, Prepared c not None, int least_norm):
        """a (k, n), lambda (k, m)."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers s = floats(u, (k, self.n_inputs), "inputs"), a = zeros((k, self.n)), L = zeros((k, self.m))
        with nogil:
            for i in range(k):
                if self.model.acceleration(T.data[i], q.row(i), w.row(i), c.c, s.row(i), least_norm, a.row(i), L.row(i),
                                           &fault) != 0:
                    blank(a.row(i), self.n)
                    blank(L.row(i), self.m)
        return a.array, L.array

    def required_rows(self, t, x, v, a, u, Prepared c not None):
        """M a - f (k, n), the forces that must act besides, and A a + gamma (k, m)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers b = floats(a, (k, self.n), "a"), o = floats(u, (k, self.n_inputs), "inputs")
        cdef Numbers r = zeros((k, self.n)), s = zeros((k, self.m))
        with nogil:
            for i in range(k):
                self.model.required_forces(T.data[i], q.row(i), w.row(i), b.row(i), c.c, o.row(i), r.row(i), s.row(i))
        return r.array, s.array

    def actuated_rows(self, t, x, v, a, u, Prepared c not None, Actuators of not None):
        """Forces (k, count), lambda (k, m), residual (k, n) and checks (k, 4) of em_model.inverse_dynamics; checks are
        undriven, forbidden, equation, row. A row without a solution is NaN."""
        cdef em_fault fault
        cdef em_inverse_check check
        cdef Py_ssize_t i, k = len(t)
        cdef int count = of.list.count or self.n_coordinates
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers b = floats(a, (k, self.n), "a"), o = floats(u, (k, self.n_inputs), "inputs")
        cdef Numbers forces = zeros((k, count)), L = zeros((k, self.m)), left = zeros((k, self.n)), checks = zeros((k, 4))
        with nogil:
            for i in range(k):
                if self.model.inverse_dynamics(T.data[i], q.row(i), w.row(i), b.row(i), c.c, o.row(i), &of.list,
                                               forces.row(i), L.row(i), left.row(i), &check, &fault) != 0:
                    blank(forces.row(i), count)
                checks.row(i)[0], checks.row(i)[1] = check.undriven, check.forbidden
                checks.row(i)[2], checks.row(i)[3] = check.equation, check.row
        return forces.array, L.array, left.array, checks.array

    def refuse_actuated(self, double t, x, v, a, u, Prepared c not None, Actuators of not None):
        """Raise the EvaluationError of inverse dynamics at one state."""
        cdef em_fault fault
        cdef em_inverse_check check
        cdef Numbers q = floats(x, (self.n,), "x"), w = floats(v, (self.n,), "v"), b = floats(a, (self.n,), "a")
        cdef Numbers o = floats(u, (self.n_inputs,), "inputs"), forces = zeros((of.list.count + self.n,))
        cdef Numbers L = zeros((self.m,)), left = zeros((self.n,))
        self.check_arguments(t, q, w, c, o.data)
        if self.model.inverse_dynamics(t, q.data, w.data, b.data, c.c, o.data, &of.list, forces.data, L.data, left.data,
                                       &check, &fault) != 0:
            raise self.failure(&fault)

    def constraint_rows(self, t, x, v, Prepared c not None):
        """A v + b as (k, m)."""
        cdef Py_ssize_t i, r, j, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers A = zeros((self.m, self.n)), residual = zeros((k, self.m))
        with nogil:
            for i in range(k if self.m > 0 else 0):
                self.model.pfaffian(T.data[i], q.row(i), c.c, A.data, residual.row(i))
                for r in range(self.m):
                    for j in range(self.n):
                        residual.row(i)[r] += A.row(r)[j] * w.row(i)[j]
        return residual.array

    def position_rows(self, t, x, Prepared c not None):
        """phi as (k, h)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), phi = zeros((k, self.h))
        cdef Numbers terms = zeros((self.h,))
        with nogil:
            for i in range(k if self.h > 0 else 0):
                self.model.position(T.data[i], q.row(i), c.c, phi.row(i), terms.data)
        return phi.array

    def quasi_rows(self, t, x, v, Prepared c not None):
        """y = P(x, t) v as (k, n_quasi)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers y = zeros((k, self.model.n_quasi))
        with nogil:
            for i in range(k if self.model.n_quasi > 0 else 0):
                self.model.quasi(T.data[i], q.row(i), w.row(i), c.c, y.row(i))
        return y.array

    def event_rows(self, t, x, v, u, Prepared c not None):
        """The event functions, as (k, n_events)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers s = floats(u, (k, self.n_inputs), "inputs"), g = zeros((k, self.n_events))
        with nogil:
            for i in range(k if self.n_events > 0 else 0):
                self.model.event(T.data[i], q.row(i), w.row(i), c.c, s.row(i), g.row(i))
        return g.array

    def drawn_rows(self, t, x, v, Prepared c not None):
        """The coordinates and sizes of the drawing as (k, n_drawn)."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers p = zeros((k, self.n_drawn))
        with nogil:
            for i in range(k if self.n_drawn > 0 else 0):
                self.model.draw(T.data[i], q.row(i), w.row(i), c.c, p.row(i))
        return p.array

    def output_rows(self, t, x, v, u, Prepared c not None, int least_norm):
        """The outputs as (k, n_outputs)."""
        cdef em_fault fault
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers s = floats(u, (k, self.n_inputs), "inputs"), z = zeros((k, self.n_outputs))
        with nogil:
            for i in range(k if self.n_outputs > 0 else 0):
                if self.model.output(T.data[i], q.row(i), w.row(i), c.c, s.row(i), least_norm, z.row(i), &fault) != 0:
                    blank(z.row(i), self.n_outputs)
        return z.array

    def observed_rows(self, t, x, v, a, multipliers, u, Prepared c not None):
        """The outputs (k, n_outputs) at given accelerations (k, n) and multipliers (k, m), as of a driven motion."""
        cdef Py_ssize_t i, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x"), w = floats(v, (k, self.n), "v")
        cdef Numbers b = floats(a, (k, self.n), "a"), L = floats(multipliers, (k, self.m), "multipliers")
        cdef Numbers s = floats(u, (k, self.n_inputs), "inputs"), z = zeros((k, self.n_outputs))
        with nogil:
            for i in range(k if self.n_outputs > 0 else 0):
                self.model.observe(T.data[i], q.row(i), w.row(i), b.row(i), L.row(i), c.c, s.row(i), z.row(i))
        return z.array

    def eigenfactor_rows(self, t, x, Prepared c not None):
        """C (k, n, n), s (k, n) of M(x); each row continues the signs and the order of the last row that has a value."""
        cdef em_fault fault
        cdef Py_ssize_t i, last = -1, k = len(t)
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, self.n), "x")
        cdef Numbers C = zeros((k, self.n, self.n)), s = zeros((k, self.n))
        with nogil:
            for i in range(k):
                if last >= 0:
                    memcpy(C.row(i), C.row(last), C.width * sizeof(double))
                    memcpy(s.row(i), s.row(last), s.width * sizeof(double))
                if self.model.eigenfactors(T.data[i], q.row(i), c.c, C.row(i), s.row(i), &fault) == 0:
                    last = i
                else:
                    blank(C.row(i), C.width)
                    blank(s.row(i), s.width)
        return C.array, s.array

    def factor_rows(self, t, x, C, s, Prepared c not None):
        """max|M - C^T S^2 C| / max|M| as (k,), where M is the factored matrix in the units of the eigenproblem."""
        cdef Py_ssize_t i, k = len(t), n = self.n
        cdef Numbers T = floats(t, (k,), "t"), q = floats(x, (k, n), "x"), R = floats(C, (k, n, n), "C")
        cdef Numbers root = floats(s, (k, n), "s"), M = zeros((n, n)), residual = zeros((k,))
        with nogil:
            for i in range(k):
                em_factored_matrix(self.model, T.data[i], q.row(i), c.c, M.data)
                residual.data[i] = self.factor_residual(M, R.row(i), root.row(i))
        return residual.array

    cdef double factor_residual(self, Numbers M, const double *C, const double *s) noexcept nogil:
        cdef Py_ssize_t i, j, r, n = self.n
        cdef double error = 0.0, largest = 0.0, entry, product
        for i in range(n):
            for j in range(n):
                entry, product = M.row(i)[j] * self.model.scales[i] * self.model.scales[j], 0.0
                for r in range(n):
                    product += C[r * n + i] * s[r] * s[r] * C[r * n + j]
                # keep NaN: every comparison with it is false
                if fabs(entry - product) > error or isnan(entry - product):
                    error = fabs(entry - product)
                largest = max(largest, fabs(entry))
        return error / largest

    # --- derivatives at one state ---

    def jacobian(self, double t, y, Prepared c not None, u):
        """(n_state, n_state): d rhs / d y."""
        cdef em_fault fault
        cdef Numbers q = floats(y, (self.n_state,), "y"), s = floats(u, (self.n_inputs,), "inputs")
        cdef Numbers J = zeros((self.n_state, self.n_state)), dy = zeros((self.n_state,))
        if self.formulation not in ("eigenfactor", "cholesky"):  # the state is (x, xdot)
            self.need_derivatives()
        elif self.model.rate_jacobian == NULL:
            self.need("duals")
        if self.model.jacobian != NULL:
            if self.model.jacobian(t, q.data, c.c, s.data, J.data, &fault) != 0:
                raise self.failure(&fault)
            return J.array
        # where the right-hand side has no value, its derivative has none: report the fault
        if self.model.rhs(t, q.data, c.c, s.data, dy.data, &fault) != 0:
            raise self.failure(&fault)
        with nogil:
            self.model.rate_jacobian(t, q.data, c.c, s.data, J.data)
        return J.array

    def motion_jacobian(self, double t, z, Prepared c not None, u, int least_norm):
        """(2 n, 2 n): d (v, a) / d (x, v)."""
        cdef em_fault fault
        cdef Numbers q = floats(z, (2 * self.n,), "z"), s = floats(u, (self.n_inputs,), "inputs")
        cdef Numbers J = zeros((2 * self.n, 2 * self.n))
        self.need_derivatives()
        if self.model.motion_jacobian(t, q.data, c.c, s.data, least_norm, J.data, &fault) != 0:
            raise self.failure(&fault)
        return J.array
