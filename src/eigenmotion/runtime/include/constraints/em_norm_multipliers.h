/* em_norm_multipliers.h: multipliers with friction that is proportional to norms of them, as in a bearing.
 *
 *     Delta lambda + sum_f g_f rho_f = load,   rho_f = sqrt(sum of lambda_k^2 over the rows of f)
 *
 * rho is homogeneous of degree one: rho(lambda) = gradient . lambda, gradient = lambda / rho. So a step of Newton's
 * method is the solution for a known direction, (Delta + sum_f g_f gradient_f^T) lambda = load, and the last matrix is
 * the exact Jacobian. The iteration starts from the direction of the multipliers without this friction, so that its
 * result depends on the state alone. With one norm it converges to the first solution on the path from no friction to
 * full friction, or fails if friction jams: beyond that the determinant has changed its sign. */
#ifndef EM_NORM_MULTIPLIERS_H
#define EM_NORM_MULTIPLIERS_H

#include "constraints/em_multipliers.h"

#ifdef EM_ON_DUALS
enum { EM_STEPS_MORE = 1 }; /* the derivatives lag one step behind */
#else
enum { EM_STEPS_MORE = 0 };
#endif

#define EM_NORM_CONVERGED 1e-9 /* bound on the change of a direction: its square is the remaining error */

/* rho (r) and its gradient (r, m) at lambda (m); the gradient is 0 where rho vanishes. Returns the largest change of
 * the gradients. */
EM_INLINE double em_normal_forces(int m, int r, const unsigned char *among, const real *lambda, real *rho,
                                  real *gradient) {
    double change = 0.0;
    for (int f = 0; f < r; ++f) {
        real largest = em_real(0.0), sum = em_real(0.0);
        for (int k = 0; k < m; ++k)
            if (among[f * m + k] && fabs(em_value(lambda[k])) > em_value(largest)) largest = em_real(fabs(em_value(lambda[k])));
        const int presses = em_value(largest) > 0.0;
        for (int k = 0; k < m && presses; ++k)
            if (among[f * m + k]) sum += lambda[k] / largest * (lambda[k] / largest);
        rho[f] = presses ? largest * sqrt(sum) : em_real(0.0);
        for (int k = 0; k < m; ++k) {
            const real now = presses && among[f * m + k] ? lambda[k] / rho[f] : em_real(0.0);
            change = fmax(change, fabs(em_value(now) - em_value(gradient[f * m + k])));
            gradient[f * m + k] = now;
        }
    }
    return change;
}

/* x (m) <- A^-1 x, A (m, m); unit (m): 1 / length of each row. Returns the sign of the determinant, or 0 if it is
 * zero to rounding. */
EM_INLINE int em_solve_signed(int m, real *A, const double *unit, real *x) {
    int sign = 1;
    double largest = 0.0;
    for (int i = 0; i < m; ++i) {
        x[i] *= unit[i];
        for (int j = 0; j < m; ++j) A[i * m + j] *= unit[i] * unit[j], largest = fmax(largest, fabs(em_value(A[i * m + j])));
    }
    for (int k = 0; k < m; ++k) {
        int best = k;
        for (int i = k + 1; i < m; ++i)
            if (fabs(em_value(A[i * m + k])) > fabs(em_value(A[best * m + k]))) best = i;
        if (!(fabs(em_value(A[best * m + k])) > EM_SINGULAR_PIVOT * largest)) return 0;
        for (int j = k; j < m && best != k; ++j) {
            const real kept = A[k * m + j];
            A[k * m + j] = A[best * m + j], A[best * m + j] = kept;
        }
        const real right = x[k];
        x[k] = x[best], x[best] = right;
        if ((best != k) != (em_value(A[k * m + k]) < 0.0)) sign = -sign;
        for (int i = k + 1; i < m; ++i) {
            const real part = A[i * m + k] / A[k * m + k];
            for (int j = k + 1; j < m; ++j) A[i * m + j] -= part * A[k * m + j];
            x[i] -= part * x[k];
        }
    }
    for (int k = m - 1; k >= 0; --k) {
        for (int j = k + 1; j < m; ++j) x[k] -= A[k * m + j] * x[j];
        x[k] /= A[k * m + k];
    }
    for (int k = 0; k < m; ++k) x[k] *= unit[k];
    return sign;
}

/* The same for the kept rows, or for all; rows that do not hold are zero. */
EM_INLINE int em_solve_norm_friction(int m, real *A, const double *unit, real *x, int flags) {
    em_fill_inactive_rows(m, A);
    for (int i = 0; i < m && flags >= EM_FIRST_KEPT && i < EM_MOST_ROWS; ++i) {
        if (flags & EM_FIRST_KEPT << i) continue;
        for (int j = 0; j < m; ++j) A[i * m + j] = A[j * m + i] = em_real(i == j ? 1.0 / (unit[i] * unit[i]) : 0.0);
        x[i] = em_real(0.0);
    }
    return em_solve_signed(m, A, unit, x);
}

/* unit (m) <- 1 / length of each row; for rows that do not hold, that of the longest row. */
EM_INLINE void em_units_of_rows(int m, const real *own, double *unit) {
    double largest = 0.0;
    for (int i = 0; i < m; ++i) largest = fmax(largest, em_value(own[i * m + i]));
    for (int i = 0; i < m; ++i) {
        const double square = em_value(own[i * m + i]) > 0.0 ? em_value(own[i * m + i]) : largest;
        unit[i] = square > 0.0 ? 1.0 / sqrt(square) : 1.0;
    }
}

/* lambda (m + r) <- multipliers and norms, Delta (m, m + r) lambda = lambda; gradient (r, m) <- of the norms.
 * 0, or -1 and *fault: friction jams. */
EM_INLINE int em_solve_normed(int m, int r, const unsigned char *among, const real *Delta, real *lambda, real *gradient,
                              int flags, em_fault *fault) {
    enum { STEPS = 50 };
    real own[m * m], A[m * m], load[m];
    double unit[m];
    int slides = 0, more = EM_STEPS_MORE;
    for (int i = 0; i < m; ++i) {
        load[i] = lambda[i];
        for (int j = 0; j < m; ++j) own[i * m + j] = A[i * m + j] = Delta[i * (m + r) + j];
        for (int f = 0; f < r; ++f)
            slides |= em_value(Delta[i * (m + r) + m + f]) != 0.0;
    }
    for (int k = 0; k < r * m; ++k) gradient[k] = em_real(0.0);
#ifndef EM_ON_LANES
    const int rests = em_is_square_of_rows(m, own);
    if (rests && em_solve_delta(m, A, lambda, flags, fault)) return -1;
    int kept;
    if ((slides || !rests) && (flags & EM_LEAST_NORM) && flags < EM_FIRST_KEPT && em_independent_rows(m, own, EM_DEPENDENT, &kept) < m)
        flags |= kept;
#else
    const int rests = 0;
#endif
    em_units_of_rows(m, own, unit);
    const int first = rests ? 1 : em_solve_norm_friction(m, A, unit, lambda, flags); /* sliding contacts may change
                                                                                        the sign, too */
    if (first == 0) return em_fail(fault, EM_CONTACTS_CLASH, -1, EM_JAMMED, NAN);
    for (int step = 0; step < STEPS; ++step) {
        const double change = em_normal_forces(m, r, among, lambda, lambda + m, gradient);
        if (!slides || (change <= EM_NORM_CONVERGED && more-- == 0)) return 0;
        for (int i = 0; i < m; ++i) {
            lambda[i] = load[i];
            for (int j = 0; j < m; ++j) {
                A[i * m + j] = own[i * m + j];
                for (int f = 0; f < r; ++f) A[i * m + j] += Delta[i * (m + r) + m + f] * gradient[f * m + j];
            }
        }
        if (em_solve_norm_friction(m, A, unit, lambda, flags) * first <= 0) return em_fail(fault, EM_CONTACTS_CLASH, -1, EM_JAMMED, NAN);
    }
    return em_fail(fault, EM_CONTACTS_CLASH, -1, EM_NORMALS_NOT_FOUND, NAN);
}

#endif
