/* em_linear.h: small dense linear algebra: products, L L^T and L D L^T, and solves with them. Dimensions are
 * constants at every call, so that the compiler unrolls small ones. Matrices are row-major. */
#ifndef EM_LINEAR_H
#define EM_LINEAR_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "eigenmotion.h"
#include "numeric/em_products.h"
#if defined(EM_ON_DUALS)
#include "numeric/em_dual_functions.h"
#elif defined(EM_ON_LANES)
#include "numeric/em_lane_functions.h"
#else
#include "numeric/em_trigonometry.h"
#endif

/* Flags of right-hand sides and of settling; from EM_FIRST_KEPT on one bit for each constraint row that is kept; no
 * such bit: unknown (em_rank.h). */
enum { EM_STABILISE = 1, EM_KEEP_MODE = 2, EM_LEAST_NORM = 4, EM_BEGIN = 8, EM_FIRST_KEPT = 16, EM_MOST_ROWS = 26 };

#define EM_VANISHED 1e-26 /* a row of B whose square, relative to the longest, is below this counts as zero */
#define EM_SMALL_PIVOT 1e-4 /* below this part of the original diagonal entry, another pivot is searched for */
#define EM_SINGULAR_PIVOT 1e-13 /* a pivot below this part of its diagonal entry has fewer than three correct digits */

EM_COLD_PATH EM_NOINLINE int em_fail(em_fault *fault, em_status status, int first, int second, double size) {
    fault->status = status;
    fault->first = first;
    fault->second = second;
    fault->size = size;
    return -1;
}

#ifdef EM_PACKED
enum { EM_LONG = 8 }; /* from here on rows of a factor are formed in vectors */

/* em_factor row by row of D L^T: each row is subtracted from those after it, in vectors of EM_LANES numbers. */
EM_NOINLINE int em_factor_along(int n, int roots, const double *restrict M, double *restrict L, double *restrict r,
                            double tolerance) {
    enum { WIDTH = EM_LANES };
    const int padded = (n + WIDTH - 1) / WIDTH;
    em_numbers rows[n * padded];
    double *const U = (double *)rows;
    memset(rows, 0, sizeof rows);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) U[j * padded * WIDTH + i] = M[i * n + j];
    EM_UNROLL
    for (int k = 0; k < n; ++k) {
        const double *const row = U + k * padded * WIDTH, pivot = row[k];
        if (!(pivot > tolerance * M[k * n + k])) return k;
        const double inverse = 1.0 / pivot;
        r[k] = roots ? sqrt(inverse) : inverse;
        EM_UNROLL
        for (int i = k + 1; i < n; ++i) {
            const double part = row[i] * inverse;
            for (int at = i / WIDTH; at < padded; ++at) rows[i * padded + at] -= part * rows[k * padded + at];
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i; ++j) L[i * n + j] = U[j * padded * WIDTH + i] * r[j];
        L[i * n + i] = roots ? U[i * padded * WIDTH + i] * r[i] : U[i * padded * WIDTH + i];
    }
    return -1;
}
#endif

/* M (n, n), by its lower triangle, = L D L^T with ones on the diagonal of L, where D is stored; r (n): D^-1. Or,
 * with `roots`, = L L^T; r: 1 / L_ii. Returns -1, or the index of the first pivot that is not above `tolerance`
 * M_ii. The critical path from pivot to pivot has one division and no square root. */
EM_INLINE int em_factor(int n, int roots, const real *restrict M, real *restrict L, real *restrict r, double tolerance) {
#ifdef EM_PACKED
    if (em_tiled(n) >= EM_LONG) return em_factor_along(n, roots, M, L, r, tolerance);
#endif
    real LD[n * n], sound[n]; /* sound: 1, or NaN, off the critical path */
    for (int j = 0; j < n; ++j) {
        real pivot = M[j * n + j];
        for (int k = 0; k < j; ++k) pivot -= LD[j * n + k] * L[j * n + k];
        sound[j] = em_real(1.0);
        if (em_fails(&sound[j], em_value(pivot) > tolerance * em_value(M[j * n + j]))) return j;
        L[j * n + j] = pivot;
        r[j] = em_inverse(pivot);
        for (int i = j + 1; i < n; ++i) {
            real sum = M[i * n + j];
            for (int k = 0; k < j; ++k) sum -= LD[i * n + k] * L[j * n + k];
            LD[i * n + j] = sum;
            L[i * n + j] = sum * r[j];
        }
    }
    for (int j = 0; j < n; ++j) {
        r[j] = roots ? sqrt(r[j]) * sound[j] : r[j] * sound[j];
        if (!roots) continue;
        L[j * n + j] *= r[j];
        for (int i = j + 1; i < n; ++i) L[i * n + j] = LD[i * n + j] * r[j];
    }
    return -1;
}

/* M = L L^T */
EM_INLINE int em_cholesky(int n, const real *restrict M, real *restrict L, real *restrict r, double tolerance) {
    return em_factor(n, 1, M, L, r, tolerance);
}

/* The same where n is known at run time only. */
EM_INLINE int em_cholesky_any(int n, const real *restrict M, real *restrict L, real *restrict r, double tolerance) {
#ifdef EM_PACKED
    if (n >= EM_LONG) return em_factor_along(n, 1, M, L, r, tolerance);
#endif
    return em_cholesky(n, M, L, r, tolerance);
}

EM_ANY_SIZE int em_cholesky_shared(int n, const real *M, real *L, real *r, double tolerance);
#if EM_HOLDS_ANY_SIZE
EM_ANY_SIZE int em_cholesky_shared(int n, const real *M, real *L, real *r, double tolerance) {
    return n == 6 ? em_cholesky(6, M, L, r, tolerance) : em_cholesky(7, M, L, r, tolerance);
}
#endif

/* em_cholesky on no path of a right-hand side. */
EM_INLINE int em_cholesky_aside(int n, const real *M, real *L, real *r, double tolerance) {
    return EM_IS_SHARED_SIZE(n) ? em_cholesky_shared(n, M, L, r, tolerance) : em_cholesky(n, M, L, r, tolerance);
}

/* M = L D L^T, where no square roots are needed. */
EM_INLINE int em_ldlt(int n, const real *restrict M, real *restrict L, real *restrict r, double tolerance) {
    return em_factor(n, 0, M, L, r, tolerance);
}

/* b <- L^-1 b, with ones on the diagonal of L */
EM_INLINE void em_forward_unit(int n, const real *restrict L, real *restrict b) {
    for (int i = 1; i < n; ++i)
        for (int k = 0; k < i; ++k) b[i] -= L[i * n + k] * b[k];
}

/* b <- L^-T D^-1 b, with ones on the diagonal of L */
EM_INLINE void em_backward_unit(int n, const real *restrict L, const real *restrict r, real *restrict b) {
    for (int i = n - 1; i >= 0; --i) {
        real sum = b[i] * r[i];
        for (int k = i + 1; k < n; ++k) sum -= L[k * n + i] * b[k];
        b[i] = sum;
    }
}

/* b <- L^-1 b */
EM_INLINE void em_forward(int n, const real *restrict L, const real *restrict r, real *restrict b) {
    for (int i = 0; i < n; ++i) {
        real sum = b[i];
        for (int k = 0; k < i; ++k) sum -= L[i * n + k] * b[k];
        b[i] = sum * r[i];
    }
}

/* b <- L^-T b */
EM_INLINE void em_backward(int n, const real *restrict L, const real *restrict r, real *restrict b) {
    for (int i = n - 1; i >= 0; --i) {
        real sum = b[i];
        for (int k = i + 1; k < n; ++k) sum -= L[k * n + i] * b[k];
        b[i] = sum * r[i];
    }
}

/* eta = S C v <-> eta = L^T v: the same velocities with another root of M. */
EM_INLINE void em_transposed(int n, const real *restrict L, real *restrict v) {
    for (int i = 0; i < n; ++i) {
        real sum = L[i * n + i] * v[i];
        for (int k = i + 1; k < n; ++k) sum += L[k * n + i] * v[k];
        v[i] = sum;
    }
}

/* b <- a, number by number: memcpy would load wider words than were just stored, and wait for them. */
EM_INLINE void em_copy(int n, const real *restrict a, real *restrict b) {
    for (int i = 0; i < n; ++i) b[i] = a[i];
}

/* b <- 0 */
EM_INLINE void em_clear(int n, real *restrict b) {
    for (int i = 0; i < n; ++i) b[i] = em_real(0.0);
}

/* a . b, starting with the first product: a sum that began at zero would cost an addition, for the sign of zero. */
EM_INLINE real em_inner(int n, const real *restrict a, const real *restrict b) {
    real sum = a[0] * b[0];
    for (int i = 1; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

/* Y (m, n) <- A W^T */
EM_INLINE void em_product(int m, int n, const real *restrict A, const real *restrict W, real *restrict Y) {
    for (int row = 0; row < m; ++row)
        for (int i = 0; i < n; ++i) Y[row * n + i] = em_inner(n, W + i * n, A + row * n);
}

/* T <- C^T if rows are tiled; otherwise it is not used. */
EM_INLINE void em_transpose_for_tiles(int n, const real *restrict C, real *restrict T) {
    if (em_tiled(n)) em_transpose(n, C, T);
}

/* The lower triangle of Lambda (n, n) <- C M C^T; M full, T of em_transpose_for_tiles. */
EM_INLINE void em_congruence_below(int n, const real *restrict C, const real *restrict T, const real *restrict M,
                                   real *restrict Lambda) {
    real W[n * n];
    if (em_tiled(n)) {
        em_multiply(n, 0, 1.0, M, T, W);
        em_multiply(n, 1, 1.0, C, W, Lambda);
        return;
    }
    em_multiply(n, 0, 1.0, C, M, W);
    em_lane_tiles(n, 1, 1.0, W, C, 1, n, Lambda);
    for (int i = 0; i < n; ++i)
        for (int j = em_lane_tiled(n, i); j <= i; ++j) Lambda[i * n + j] = em_inner(n, W + i * n, C + j * n);
}

/* Lambda (n, n) <- C M C^T, both triangles; M full. */
EM_INLINE void em_congruence(int n, const real *restrict C, const real *restrict M, real *restrict Lambda) {
    real T[n * n];
    em_transpose_for_tiles(n, C, T);
    em_congruence_below(n, C, T, M, Lambda);
    em_mirror(n, Lambda);
}

#endif
