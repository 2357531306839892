/* em_linear.h: small dense linear algebra: products, L L^T and what solves with it. Dimensions are constants at every
 * call, so that the compiler unrolls what is small. Matrices are row-major. */
#ifndef EM_LINEAR_H
#define EM_LINEAR_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "eigenmotion.h"
#include "em_trigonometry.h"

enum { EM_STABILISE = 1, EM_KEEP_MODE = 2, EM_LEAST_NORM = 4, EM_BEGIN = 8 };

#define EM_SINGULAR_PIVOT 1e-13 /* a pivot below this part of its diagonal entry leaves fewer than three right digits */

#define EM_INLINE static inline __attribute__((always_inline, unused))
#define EM_COLD static __attribute__((noinline, unused))
#define EM_UNUSED __attribute__((unused))
#define EM_RARE __attribute__((cold)) /* called by no step: for size, which takes a compiler less time */

EM_COLD int em_fail(em_fault *fault, em_status status, int first, int second, double size) {
    fault->status = status;
    fault->first = first;
    fault->second = second;
    fault->size = size;
    return -1;
}

/* L (n, n) lower with M = L L^T; reads the lower triangle of M. r (n): 1 / L_ii.
 * Returns -1, or the index of the first pivot that is not above `tolerance` M_ii.
 * By way of L D L^T: from pivot to pivot leads one division then, and the roots are not waited for. */
EM_INLINE int em_cholesky(int n, const double *restrict M, double *restrict L, double *restrict r, double tolerance) {
    double W[n * n]; /* L D^-1, while L D is in L and D^-1 in r */
    for (int j = 0; j < n; ++j) {
        double pivot = M[j * n + j];
        for (int k = 0; k < j; ++k) pivot -= L[j * n + k] * W[j * n + k];
        if (!(pivot > tolerance * M[j * n + j])) return j;
        L[j * n + j] = pivot;
        r[j] = 1.0 / pivot;
        for (int i = j + 1; i < n; ++i) {
            double sum = M[i * n + j];
            for (int k = 0; k < j; ++k) sum -= L[i * n + k] * W[j * n + k];
            L[i * n + j] = sum;
            W[i * n + j] = sum * r[j];
        }
    }
    for (int j = 0; j < n; ++j) {
        r[j] = sqrt(r[j]);
        for (int i = j; i < n; ++i) L[i * n + j] *= r[j];
    }
    return -1;
}

/* b <- L^-1 b */
EM_INLINE void em_forward(int n, const double *restrict L, const double *restrict r, double *restrict b) {
    for (int i = 0; i < n; ++i) {
        double sum = b[i];
        for (int k = 0; k < i; ++k) sum -= L[i * n + k] * b[k];
        b[i] = sum * r[i];
    }
}

/* b <- L^-T b */
EM_INLINE void em_backward(int n, const double *restrict L, const double *restrict r, double *restrict b) {
    for (int i = n - 1; i >= 0; --i) {
        double sum = b[i];
        for (int k = i + 1; k < n; ++k) sum -= L[k * n + i] * b[k];
        b[i] = sum * r[i];
    }
}

/* X (n, n) <- L^-1 X */
EM_INLINE void em_forward_columns(int n, const double *restrict L, const double *restrict r, double *restrict X) {
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            double sum = X[i * n + j];
            for (int k = 0; k < i; ++k) sum -= L[i * n + k] * X[k * n + j];
            X[i * n + j] = sum * r[i];
        }
}

/* eta = S C v <-> eta = L^T v: the same velocities under another root of M. */
EM_INLINE void em_transposed(int n, const double *restrict L, double *restrict v) {
    for (int i = 0; i < n; ++i) {
        double sum = 0.0;
        for (int k = i; k < n; ++k) sum += L[k * n + i] * v[k];
        v[i] = sum;
    }
}

/* b <- a, number by number: memcpy would read wider words than were just written, and wait for them. */
EM_INLINE void em_copy(int n, const double *restrict a, double *restrict b) {
    for (int i = 0; i < n; ++i) b[i] = a[i];
}

/* Y (m, n) <- A W^T */
EM_INLINE void em_product(int m, int n, const double *restrict A, const double *restrict W, double *restrict Y) {
    for (int row = 0; row < m; ++row)
        for (int i = 0; i < n; ++i) {
            double sum = 0.0;
            for (int j = 0; j < n; ++j) sum += W[i * n + j] * A[row * n + j];
            Y[row * n + i] = sum;
        }
}

/* Lambda (n, n) <- C M C^T, both triangles; M full. */
EM_INLINE void em_congruence(int n, const double *restrict C, const double *restrict M, double *restrict Lambda) {
    double W[n * n];
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            double sum = 0.0;
            for (int k = 0; k < n; ++k) sum += C[i * n + k] * M[k * n + j];
            W[i * n + j] = sum;
        }
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            double sum = 0.0;
            for (int k = 0; k < n; ++k) sum += W[i * n + k] * C[j * n + k];
            Lambda[i * n + j] = sum;
            Lambda[j * n + i] = sum;
        }
}

#endif
