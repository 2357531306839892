/* em_multipliers.h: Delta = B B^T and the multipliers, block by block of M; the eigenfactors of Delta. */
#ifndef EM_MULTIPLIERS_H
#define EM_MULTIPLIERS_H

#include "mass/em_root_rates.h"
#ifndef EM_ON_LANES
#include "constraints/em_rank.h"
#include "numeric/em_complete_pivoting.h"
#endif

#define EM_SQUARE_ROUNDING (256.0 * DBL_EPSILON) /* by which Delta of rows at length one may differ from its transpose */

/* B (m, n) <- A L^-T */
EM_INLINE void em_rows_of_root(int m, int n, const real *restrict L, const real *restrict r,
                               const real *restrict A, real *restrict B) {
    em_copy(m * n, A, B);
    for (int row = 0; row < m; ++row) em_forward(n, L, r, B + row * n);
}

/* B (m, n) <- A L^-T, BD <- B D^-1, M = L D L^T */
EM_INLINE void em_rows_of_ldlt(int m, int n, const real *restrict L, const real *restrict r, const real *restrict A,
                               real *restrict B, real *restrict BD) {
    em_copy(m * n, A, B);
    for (int row = 0; row < m; ++row) {
        em_forward_unit(n, L, B + row * n);
        for (int i = 0; i < n; ++i) BD[row * n + i] = B[row * n + i] * r[i];
    }
}

/* B (m, n) <- A C^T S^-1 (28) */
EM_INLINE void em_rows_of_factors(int m, int n, const real *restrict C, const real *restrict s,
                                  const real *restrict A, real *restrict B) {
    em_copy(m * n, A, B);
    for (int row = 0; row < m; ++row) em_force_on_eta(n, C, s, B + row * n);
}

/* load[row] += B (a + q), of one block: the right-hand side of (46). q NULL if B is constant. */
EM_INLINE void em_add_to_load(int n, int row, const real *restrict B, const real *restrict a,
                              const real *restrict q, real *restrict load) {
    real sum = load[row];
    for (int i = 0; i < n; ++i) {
        real part = a[i];
        if (q) part += q[i];
        sum += B[row * n + i] * part;
    }
    load[row] = sum;
}

/* *sum += a . b */
EM_INLINE void em_add_product(int n, const real *restrict a, const real *restrict b, real *restrict sum) {
    real whole = *sum;
    for (int i = 0; i < n; ++i) whole += a[i] * b[i];
    *sum = whole;
}

/* a (n) -= B^T lambda (45) */
EM_INLINE void em_subtract_reactions(int m, int n, const real *restrict B, const real *restrict lambda,
                                     real *restrict a) {
    for (int i = 0; i < n; ++i) {
        real sum = a[i];
        for (int row = 0; row < m; ++row) sum -= B[row * n + i] * lambda[row];
        a[i] = sum;
    }
}

/* The first row that is zero to rounding relative to the others; -1: none. */
EM_INLINE int em_vanished_row(int m, real *restrict Delta) {
    real largest = em_real(0.0);
    for (int i = 0; i < m; ++i) largest = em_where(em_value(Delta[i * m + i]) > em_value(largest), Delta[i * m + i], largest);
    for (int i = 0; i < m; ++i)
        if (em_fails(&Delta[i * m + i], em_value(Delta[i * m + i]) > EM_VANISHED * em_value(largest))) return i;
    return -1;
}

/* Delta <- with a non-zero diagonal for inactive rows. Rows that do not hold in the mode are zero, and so are their
 * right-hand sides; with the largest diagonal entry in their place, Delta is regular and their multipliers are zero. */
EM_INLINE void em_fill_inactive_rows(int m, real *restrict Delta) {
#ifdef EM_SWITCHED_ROWS
    real largest = em_real(0.0);
    for (int i = 0; i < m; ++i) largest = em_where(em_value(Delta[i * m + i]) > em_value(largest), Delta[i * m + i], largest);
    largest = em_where(em_value(largest) > 0.0, largest, em_real(1.0));
    for (int i = 0; i < m; ++i)
        if (EM_SWITCHED_ROWS >> i & 1)
            Delta[i * m + i] = em_where(em_value(Delta[i * m + i]) == 0.0, largest, Delta[i * m + i]);
#else
    (void)m, (void)Delta;
#endif
}

/* Delta, rhs <- with ones and zeros for the rows that are not kept, so that their multipliers are zero. */
EM_INLINE void em_drop_rows(int m, real *restrict Delta, real *restrict rhs, int flags) {
    for (int i = 0; i < m && i < EM_MOST_ROWS; ++i) {
        if (flags & EM_FIRST_KEPT << i) continue;
        for (int j = 0; j < i; ++j) Delta[i * m + j] = em_real(0.0);
        for (int j = i + 1; j < m; ++j) Delta[j * m + i] = em_real(0.0);
        Delta[i * m + i] = em_real(1.0);
        rhs[i] = em_real(0.0);
    }
}

/* rhs (m) <- Delta^-1 rhs, of the rows that are kept or of all; Delta (m, m) by its lower triangle. Returns -1, or a
 * row that depends on those before it. */
EM_INLINE int em_solve_independent(int m, real *restrict Delta, real *restrict rhs, int flags) {
    if (m == 1) {
        if (em_fails(&Delta[0], em_value(Delta[0]) > 0.0)) return 0;
        rhs[0] *= em_inverse(Delta[0]); /* the inverse is ready before rhs is */
        return -1;
    }
    real L[m * m], r[m];
    int row = -1;
    if (flags >= EM_FIRST_KEPT) em_drop_rows(m, Delta, rhs, flags);
    else row = em_vanished_row(m, Delta);
    if (row < 0) row = em_ldlt(m, Delta, L, r, EM_SINGULAR_PIVOT);
    if (row >= 0) return row;
    em_forward_unit(m, L, rhs);
    em_backward_unit(m, L, r, rhs);
    return -1;
}

/* The same; if dependent rows are allowed and the kept rows are not known, the multipliers of least norm. 0, or -1 and
 * *fault. */
EM_INLINE int em_solve_delta(int m, real *restrict Delta, real *restrict rhs, int flags, em_fault *fault) {
    em_fill_inactive_rows(m, Delta);
#ifdef EM_ON_LANES
    return (void)fault, em_solve_independent(m, Delta, rhs, flags), 0;
#else
    const int least_norm = (flags & EM_LEAST_NORM) && flags < EM_FIRST_KEPT;
    if (m > 1 && least_norm) return em_solve_dependent(m, Delta, rhs, NULL, 0, flags, fault);
    const int row = em_solve_independent(m, Delta, rhs, flags);
    return row < 0 ? 0 : em_solve_dependent(m, Delta, rhs, NULL, row, m == 1 ? flags : 0, fault);
#endif
}

#ifndef EM_ON_LANES
/* Whether Delta is B B^T, to rounding, as it is if no friction slides: its factors are then the same rows, but from
 * different expressions. A friction this small changes nothing. */
EM_INLINE int em_is_square_of_rows(int m, const double *Delta) {
    for (int i = 0; i < m; ++i) {
        if (!(Delta[i * m + i] >= 0.0)) return 0;
        for (int j = 0; j < i; ++j) {
            const double apart = Delta[i * m + j] - Delta[j * m + i], within = EM_SQUARE_ROUNDING * EM_SQUARE_ROUNDING;
            if (!(apart * apart <= within * Delta[i * m + i] * Delta[j * m + j])) return 0;
        }
    }
    return 1;
}
#endif

#ifndef EM_ON_LANES
/* rhs (m) <- Delta^-1 right with complete pivoting, of the rows that are kept. 0, or -1 and *fault. */
EM_NOINLINE int em_solve_pushed_pivoted(int m, double *Delta, const double *right, double *rhs, int flags, em_fault *fault) {
    em_fill_inactive_rows(m, Delta);
    for (int i = 0; i < m; ++i) {
        const int kept = flags < EM_FIRST_KEPT || (flags & EM_FIRST_KEPT << i);
        for (int j = 0; j < m && !kept; ++j) Delta[i * m + j] = Delta[j * m + i] = i == j;
        rhs[i] = kept ? right[i] : 0.0;
    }
    for (int i = 0; i < m; ++i) {
        double unit = 0.0;
        for (int j = 0; j < m; ++j) unit = fmax(unit, fabs(Delta[i * m + j]));
        for (int j = 0; j < m && unit > 0.0; ++j) Delta[i * m + j] /= unit;
        if (unit > 0.0) rhs[i] /= unit;
    }
    if (em_solve_completely(m, Delta, rhs, EM_SINGULAR_PIVOT, NULL)) return em_fail(fault, EM_CONTACTS_CLASH, -1, EM_JAMMED, NAN);
    return 0;
}
#endif

/* rhs (m) <- Delta^-1 rhs if multipliers act along other rows than those that hold. Delta (m, m) is then full, and
 * regular unless friction jams. If it is indefinite, as in consistent modes with large friction, rows are pivoted.
 * 0, or -1 and *fault. */
EM_INLINE int em_solve_pushed(int m, real *restrict Delta, real *restrict rhs, int flags, em_fault *fault) {
    real whole[m];
#ifndef EM_ON_LANES
    if (em_is_square_of_rows(m, Delta)) return em_solve_delta(m, Delta, rhs, flags, fault);
    real original[m * m], right[m];
    memcpy(original, Delta, sizeof original);
    memcpy(right, rhs, sizeof right);
#endif
    em_fill_inactive_rows(m, Delta);
    for (int i = 0; i < m; ++i) whole[i] = Delta[i * m + i];
    for (int i = 0; i < m && flags >= EM_FIRST_KEPT; ++i) {
        if (flags & EM_FIRST_KEPT << i) continue;
        for (int j = 0; j < m; ++j) Delta[i * m + j] = Delta[j * m + i] = em_real(i == j ? 1.0 : 0.0);
        whole[i] = em_real(1.0);
        rhs[i] = em_real(0.0);
    }
    for (int k = 0; k < m; ++k) {
        real pivot = Delta[k * m + k];
        if (em_fails(&pivot, em_value(pivot * pivot) > EM_SMALL_PIVOT * EM_SMALL_PIVOT * em_value(whole[k] * whole[k])))
#ifdef EM_ON_LANES
            return em_fail(fault, EM_CONTACTS_CLASH, -1, EM_JAMMED, em_number(pivot));
#else
            return em_solve_pushed_pivoted(m, original, right, rhs, flags, fault);
#endif
        for (int i = k + 1; i < m; ++i) {
            const real part = Delta[i * m + k] / pivot;
            for (int j = k + 1; j < m; ++j) Delta[i * m + j] -= part * Delta[k * m + j];
            rhs[i] -= part * rhs[k];
        }
    }
    for (int k = m - 1; k >= 0; --k) {
        for (int j = k + 1; j < m; ++j) rhs[k] -= Delta[k * m + j] * rhs[j];
        rhs[k] /= Delta[k * m + k];
    }
    return 0;
}

/* part (g, g) <- the rows and columns listed of the lower triangle of Delta (m, m) */
EM_INLINE void em_part_of_delta(int m, int g, const int *rows, const real *restrict Delta, real *restrict part) {
    for (int i = 0; i < g; ++i)
        for (int j = 0; j <= i; ++j) part[i * g + j] = part[j * g + i] = Delta[rows[i] * m + rows[j]];
}

/* Bdot (m, n) <- (Adot C^T + A Cdot^T - B Sdot) S^-1 (40); C_dot NULL if C is constant */
EM_INLINE void em_row_rates(int m, int n, const real *restrict C, const real *restrict r,
                            const real *restrict C_dot, const real *restrict s_dot, const real *restrict A,
                            const real *restrict A_dot, const real *restrict B, real *restrict B_dot) {
    for (int row = 0; row < m; ++row)
        for (int i = 0; i < n; ++i) {
            real sum = -B[row * n + i] * s_dot[i];
            for (int j = 0; j < n; ++j) {
                sum += A_dot[row * n + j] * C[i * n + j];
                if (C_dot) sum += A[row * n + j] * C_dot[i * n + j];
            }
            B_dot[row * n + i] = r[i] * sum;
        }
}

/* Delta_dot (g, g) += Bdot B^T + B Bdot^T (51), of one block, for the rows listed */
EM_INLINE void em_add_to_delta_rate(int g, int n, const int *rows, const real *restrict B,
                                    const real *restrict B_dot, real *restrict Delta_dot) {
    for (int i = 0; i < g; ++i)
        for (int j = 0; j <= i; ++j) {
            real sum = Delta_dot[i * g + j];
            for (int k = 0; k < n; ++k)
                sum += B_dot[rows[i] * n + k] * B[rows[j] * n + k] + B[rows[i] * n + k] * B_dot[rows[j] * n + k];
            Delta_dot[i * g + j] = Delta_dot[j * g + i] = sum;
        }
}

/* With the eigenfactors of Delta (m, m), of the rows listed: C_Ddot = -Omega_D C_D (55), s_Ddot = beta_ii / (2 s_D)
 * (54), and lambda <- C_D^T S_D^-2 C_D lambda (48). */
EM_INLINE void em_delta_rates(int m, const int *rows, const real *restrict C, const real *restrict s,
                              const real *restrict beta, const real *restrict Omega, real *restrict C_dot,
                              real *restrict s_dot, real *restrict lambda) {
    real part[m];
    for (int i = 0; i < m; ++i) {
        part[i] = em_real(0.0);
        for (int j = 0; j < m; ++j) {
            real sum = em_real(0.0);
            for (int k = 0; k < m; ++k) sum -= Omega[i * m + k] * C[k * m + j];
            C_dot[i * m + j] = sum;
            part[i] += C[i * m + j] * lambda[rows[j]];
        }
        part[i] /= s[i] * s[i];
        s_dot[i] = 0.5 * beta[i * m + i] / s[i];
    }
    for (int j = 0; j < m; ++j) {
        lambda[rows[j]] = em_real(0.0);
        for (int i = 0; i < m; ++i) lambda[rows[j]] += C[i * m + j] * part[i];
    }
}

#endif
