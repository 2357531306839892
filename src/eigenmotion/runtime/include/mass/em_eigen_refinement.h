/* em_eigen_refinement.h: iterative refinement of C and the eigenvalues of M (Ogita and Aishima, 2018): matrix
 * products alone, for orthogonality and diagonality at once; each pass squares the error. */
#ifndef EM_EIGEN_REFINEMENT_H
#define EM_EIGEN_REFINEMENT_H

#include "numeric/em_linear.h"

/* Sizes of E are squares of its Frobenius norm. */
#define EM_REFINABLE 0.1  /* above, C is not close enough */
#define EM_REFINED 1e-16  /* below, the remaining error of a pass is rounding */
#define EM_CONTRACTS 0.1  /* largest contraction of a pass; else two eigenvalues are too close for it */

#ifdef EM_BY_TILES
/* em_correction for four rows from i on, without the diagonal. */
EM_INLINE void em_correction_of_rows(int n, int i, const double *restrict R, const double *restrict Lambda,
                                     const double *restrict lambda, double *restrict E, em_numbers_4 *size,
                                     em_marks_4 *rough) {
    for (int j = 0; j <= i; j += EM_TILE) {
        const em_numbers_4 across = *(const em_stored_4 *)(lambda + j);
        em_tile off, half, below, above, turned;
        em_load_tile(n, R + i * n + j, half);
        em_load_tile(n, Lambda + i * n + j, off);
        for (int row = 0; row < EM_TILE; ++row) {
            const double here = lambda[i + row];
            half[row] *= 0.5;
            off[row] -= half[row] * (here + across);
            if (i == j) {
                half[row] = em_marked(em_before[row], half[row]);
                off[row] = em_marked(em_before[row], off[row]);
            }
            const em_numbers_4 ratio = off[row] * off[row], product = here * across;
            const em_marks_4 coupled = ratio > n * n * DBL_EPSILON * DBL_EPSILON * product;
            const em_numbers_4 turn = em_marked(coupled, off[row] / (here - across));
            *size += 2.0 * (turn * turn + half[row] * half[row]);
            *rough |= ratio > EM_REFINED * product;
            below[row] = turn - half[row];
            above[row] = -turn - half[row];
        }
        em_transpose_tile(1.0, above, turned);
        if (i == j) for (int row = 0; row < EM_TILE; ++row) below[row] += turned[row];
        else em_store_tile(n, turned, E + j * n + i);
        em_store_tile(n, below, E + i * n + j);
    }
}
#endif

/* E (n, n) <- the correction of C, C <- (1 + E) C, from R = C C^T and Lambda = C M C^T by their lower triangles;
 * lambda (n) <- the eigenvalues. Returns the size of E; *rough: whether off-diagonal entries still affect an
 * eigenvalue. If two eigenvalues are coupled by rounding only, however close, their rows are not changed. */
EM_INLINE real em_correction(int n, const real *restrict R, const real *restrict Lambda, real *restrict E,
                             real *restrict lambda, em_truth *rough) {
    real size = em_real(0.0);
    int tiled = 0;
    *rough = (em_truth){0};
    for (int i = 0; i < n; ++i) lambda[i] = Lambda[i * n + i] / R[i * n + i];
#ifdef EM_BY_TILES
    em_numbers_4 sizes = {0.0};
    em_marks_4 roughs = {0};
    for (; tiled < em_tiled(n); tiled += EM_TILE)
        em_correction_of_rows(n, tiled, R, Lambda, lambda, E, &sizes, &roughs);
    size = (sizes[0] + sizes[1]) + (sizes[2] + sizes[3]);
    *rough = (roughs[0] | roughs[1] | roughs[2] | roughs[3]) != 0;
#endif
    for (int i = 0; i < n; ++i) {
        const real lacks = 0.5 * (1.0 - R[i * n + i]);
        E[i * n + i] = lacks;
        size += lacks * lacks;
        for (int j = 0; i >= tiled && j < i; ++j) {
            const real half = 0.5 * R[i * n + j], off = Lambda[i * n + j] - half * (lambda[i] + lambda[j]);
            const real ratio = off * off, product = lambda[i] * lambda[j];
            const em_truth coupled = ratio > n * n * DBL_EPSILON * DBL_EPSILON * product;
            const real turn = em_where(coupled, off / (lambda[i] - lambda[j]), em_real(0.0));
            E[i * n + j] = turn - half;
            E[j * n + i] = -turn - half;
            size += 2.0 * (turn * turn + half * half);
            *rough |= ratio > EM_REFINED * product;
        }
    }
    return size;
}

#ifdef EM_ON_LANES

/* C, lambda <- those of M (n, n) in the lanes `going` where C is close enough and eigenvalues are separated: -1
 * there. Each lane makes as many passes as it would alone. */
EM_NOINLINE em_truth em_refine(int n, em_truth going, const real *restrict M, real *restrict C, real *restrict lambda) {
    real limit = em_real(EM_REFINABLE);
    em_truth done = {0};
    while (em_any(going)) {
        real T[n * n], R[n * n], W[n * n], Lambda[n * n], found[n];
        em_truth rough;
        em_transpose(n, C, T);
        em_multiply(n, 1, 1.0, C, T, R);
        em_multiply(n, 0, 1.0, M, T, W);
        em_multiply(n, 1, 1.0, C, W, Lambda);
        const real size = em_correction(n, R, Lambda, T, found, &rough);
        going &= size <= limit;
        em_multiply(n, 0, 1.0, T, C, W);
        for (int k = 0; k < n * n; ++k) C[k] = em_where(going, C[k] + W[k], C[k]);
        for (int i = 0; i < n; ++i) lambda[i] = em_where(going, found[i], lambda[i]);
        done |= going & (size <= EM_REFINED) & ~rough;
        going &= ~done;
        limit = EM_CONTRACTS * size;
    }
    return done;
}

#else

/* C, lambda <- those of M (n, n), if C is close enough and eigenvalues are separated; otherwise 0, and C is still
 * close. */
EM_INLINE int em_refine_of(int n, const double *restrict M, double *restrict C, double *restrict lambda) {
    double limit = EM_REFINABLE;
    for (;;) {
        double T[n * n], R[n * n], W[n * n], Lambda[n * n];
        int rough;
        em_transpose(n, C, T);
        em_multiply(n, 1, 1.0, C, T, R);
        em_multiply(n, 0, 1.0, M, T, W);
        em_multiply(n, 1, 1.0, C, W, Lambda);
        const double size = em_correction(n, R, Lambda, T, lambda, &rough);
        if (!(size <= limit)) return 0;
        em_multiply(n, 0, 1.0, T, C, W);
        for (int k = 0; k < n * n; ++k) C[k] += W[k];
        if (size <= EM_REFINED && !rough) return 1;
        limit = EM_CONTRACTS * size;
    }
}

EM_NOINLINE int em_refine(int n, const double *M, double *C, double *lambda) { return em_refine_of(n, M, C, lambda); }

#endif

#endif
