/* em_refine.h: C and the eigenvalues of M from C nearby, by the iterative refinement of Ogita and Aishima (2018):
 * products alone, for orthogonality and diagonality at once, each pass squaring the error. */
#ifndef EM_REFINE_H
#define EM_REFINE_H

#include "em_linear.h"

/* Sizes of E are squares of its Frobenius norm. */
#define EM_REFINABLE 0.1  /* above, C is not near enough */
#define EM_REFINED 1e-16  /* below, what a pass leaves is rounding */
#define EM_CONTRACTS 0.1  /* what a pass leaves of it at most, or two eigenvalues are too close for it */

/* E (n, n) <- what C lacks, C <- (1 + E) C, from R = C C^T and Lambda = C M C^T by their lower triangles; lambda (n) <-
 * the eigenvalues. Returns the size of E; *rough: whether what is off the diagonal still matters to an eigenvalue.
 * Of two eigenvalues that only rounding couples, which may be as close as they like, the rows are left as they are. */
EM_INLINE real em_correction(int n, const real *restrict R, const real *restrict Lambda, real *restrict E,
                             real *restrict lambda, em_truth *rough) {
    real size = em_real(0.0);
    *rough = (em_truth){0};
    for (int i = 0; i < n; ++i) lambda[i] = Lambda[i * n + i] / R[i * n + i];
    for (int i = 0; i < n; ++i) {
        const real lacks = 0.5 * (1.0 - R[i * n + i]);
        E[i * n + i] = lacks;
        size += lacks * lacks;
        for (int j = 0; j < i; ++j) {
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

/* C, lambda <- those of M (n, n) in lanes, of those `going`, where C is near enough and eigenvalues are apart: -1 there.
 * Each lane makes as many passes as it would alone. */
EM_COLD em_truth em_refine(int n, em_truth going, const real *restrict M, real *restrict C, real *restrict lambda) {
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

/* C, lambda <- those of M (n, n), where C is near enough and eigenvalues are apart; otherwise 0, and C is still near. */
EM_COLD int em_refine(int n, const double *restrict M, double *restrict C, double *restrict lambda) {
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

#endif

#endif
