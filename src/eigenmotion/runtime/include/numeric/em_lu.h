/* em_lu.h: LU factors of small full matrices, of real and of complex numbers, with row pivoting. One system with many
 * right-hand sides at once: em_elimination.h.
 *
 * Rows are compared in units that the caller supplies, so that the choice of pivots does not depend on the units of
 * the unknowns. Matrices are row-major; complex ones are two, of real and of imaginary parts. */
#ifndef EM_LU_H
#define EM_LU_H

#include "numeric/em_linear.h"

EM_INLINE void em_swap(double *a, double *b) {
    const double kept = *a;
    *a = *b;
    *b = kept;
}

/* G (n, n) <- L and U, pivot (n) <- the row swapped into the place of each. unit (n): the unit of each row. 0, or
 * -1: G is singular. */
EM_INLINE int em_lu_of(int n, double *restrict G, const double *restrict unit, int *restrict pivot) {
    double weight[n];
    memcpy(weight, unit, sizeof weight);
    for (int j = 0; j < n; ++j) {
        int best = j;
        for (int i = j + 1; i < n; ++i)
            if (fabs(G[i * n + j]) * weight[i] > fabs(G[best * n + j]) * weight[best]) best = i;
        pivot[j] = best;
        em_swap(&weight[j], &weight[best]);
        for (int k = 0; best != j && k < n; ++k) em_swap(&G[j * n + k], &G[best * n + k]);
        if (!(fabs(G[j * n + j]) > 0.0)) return -1;
        const double inverse = 1.0 / G[j * n + j];
        for (int i = j + 1; i < n; ++i) {
            const double part = G[i * n + j] *= inverse;
            double *restrict const row = G + i * n;
            const double *restrict const from = G + j * n;
            for (int k = j + 1; k < n; ++k) row[k] -= part * from[k];
        }
    }
    return 0;
}

/* b (n) <- G^-1 b */
EM_INLINE int em_lu_solve_of(int n, const double *restrict G, const int *restrict pivot, double *restrict b) {
    for (int i = 0; i < n; ++i) em_swap(&b[i], &b[pivot[i]]);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < i; ++k) b[i] -= G[i * n + k] * b[k];
    for (int i = n - 1; i >= 0; --i) {
        for (int k = i + 1; k < n; ++k) b[i] -= G[i * n + k] * b[k];
        b[i] /= G[i * n + i];
    }
    return 0;
}

/* The same of G + i H. */
EM_INLINE int em_complex_lu_of(int n, double *restrict G, double *restrict H, const double *restrict unit,
                               int *restrict pivot) {
    double weight[n];
    memcpy(weight, unit, sizeof weight);
    for (int j = 0; j < n; ++j) {
        int best = j;
        double most = 0.0;
        for (int i = j; i < n; ++i) {
            const double re = G[i * n + j] * weight[i], im = H[i * n + j] * weight[i], size = re * re + im * im;
            if (size > most) best = i, most = size;
        }
        pivot[j] = best;
        em_swap(&weight[j], &weight[best]);
        for (int k = 0; best != j && k < n; ++k) {
            em_swap(&G[j * n + k], &G[best * n + k]);
            em_swap(&H[j * n + k], &H[best * n + k]);
        }
        const double g = G[j * n + j], h = H[j * n + j], square = g * g + h * h;
        if (!(square > 0.0)) return -1;
        const double re = g / square, im = -h / square;
        for (int i = j + 1; i < n; ++i) {
            const double a = G[i * n + j] * re - H[i * n + j] * im, b = G[i * n + j] * im + H[i * n + j] * re;
            G[i * n + j] = a, H[i * n + j] = b;
            for (int k = j + 1; k < n; ++k) {
                G[i * n + k] -= a * G[j * n + k] - b * H[j * n + k];
                H[i * n + k] -= a * H[j * n + k] + b * G[j * n + k];
            }
        }
    }
    return 0;
}

/* b + i d (n) <- (G + i H)^-1 (b + i d) */
EM_INLINE int em_complex_lu_solve_of(int n, const double *restrict G, const double *restrict H, const int *restrict pivot,
                                 double *restrict b, double *restrict d) {
    for (int i = 0; i < n; ++i) em_swap(&b[i], &b[pivot[i]]), em_swap(&d[i], &d[pivot[i]]);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < i; ++k) {
            b[i] -= G[i * n + k] * b[k] - H[i * n + k] * d[k];
            d[i] -= G[i * n + k] * d[k] + H[i * n + k] * b[k];
        }
    for (int i = n - 1; i >= 0; --i) {
        for (int k = i + 1; k < n; ++k) {
            b[i] -= G[i * n + k] * b[k] - H[i * n + k] * d[k];
            d[i] -= G[i * n + k] * d[k] + H[i * n + k] * b[k];
        }
        const double g = G[i * n + i], h = H[i * n + i], square = g * g + h * h, re = b[i];
        b[i] = (re * g + d[i] * h) / square;
        d[i] = (d[i] * g - re * h) / square;
    }
    return 0;
}

/* The same for any size; for small sizes by loops that unroll. */
#define EM_OF_SIZE(n, of, ...)        \
    switch (n) {                      \
        case 1: of(1, __VA_ARGS__);   \
        case 2: of(2, __VA_ARGS__);   \
        case 3: of(3, __VA_ARGS__);   \
        case 4: of(4, __VA_ARGS__);   \
        case 5: of(5, __VA_ARGS__);   \
        case 6: of(6, __VA_ARGS__);   \
        default: of(n, __VA_ARGS__);  \
    }

EM_NOINLINE int em_lu(int n, double *G, const double *unit, int *pivot) { EM_OF_SIZE(n, return em_lu_of, G, unit, pivot) }

EM_NOINLINE int em_lu_solve(int n, const double *G, const int *pivot, double *b) { EM_OF_SIZE(n, return em_lu_solve_of, G, pivot, b) }

EM_NOINLINE int em_complex_lu(int n, double *G, double *H, const double *unit, int *pivot) {
    EM_OF_SIZE(n, return em_complex_lu_of, G, H, unit, pivot)
}

EM_NOINLINE int em_complex_lu_solve(int n, const double *G, const double *H, const int *pivot, double *b, double *d) {
    EM_OF_SIZE(n, return em_complex_lu_solve_of, G, H, pivot, b, d)
}

#endif
