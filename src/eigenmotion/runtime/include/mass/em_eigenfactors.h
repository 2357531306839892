/* em_eigenfactors.h: the eigenfactors of M = C^T S^2 C: C and s from M, and their refresh after a step. */
#ifndef EM_EIGENFACTORS_H
#define EM_EIGENFACTORS_H

#include "mass/em_quasivelocities.h"
#include "mass/em_eigen_refinement.h"
#include "mass/em_jacobi_rotations.h"

/* Functions of matrices of any size; the comments are below. */
EM_COLD_PATH EM_ANY_SIZE int em_first_unsound_pivot(int n, const double *M);
EM_ANY_SIZE void em_sweep(int n, const double *M, double *C, double *lambda);
EM_ANY_SIZE int em_refresh_shared(int n, const double *M, double *C, double *s, double *eta);
EM_ANY_SIZE int em_refresh_any(int n, const double *M, double *C, double *s);
EM_COLD_PATH EM_ANY_SIZE int em_eigenfactors(int n, const double *M, double *C, double *s);
EM_COLD_PATH EM_ANY_SIZE int em_prepare_block(int n, const double *M, double *C, double *s, double *L, double *r);
EM_ANY_SIZE double em_factor_error(int n, const double *M, const double *C, const double *s);

/* Index of the first pivot of M (n, n) with fewer than three correct digits, -1 if there is none; least and largest:
 * its eigenvalues. A pivot is at most M_ii and at least the least eigenvalue: pivots are only computed if that is
 * small. */
EM_INLINE int em_unsound_pivot(int n, const double *restrict M, double least, double largest) {
    return least > 10.0 * EM_SINGULAR_PIVOT * largest ? -1 : em_first_unsound_pivot(n, M);
}

/* s <- the roots of the eigenvalues of M (n, n), which s holds. Returns -1, or an index where M is singular. */
EM_INLINE int em_roots(int n, const double *restrict M, double *restrict s) {
    double least = s[0], largest = s[0];
    for (int i = 0; i < n; ++i) {
        if (!(s[i] > 0.0)) return i;
        least = fmin(least, s[i]);
        largest = fmax(largest, s[i]);
        s[i] = sqrt(s[i]);
    }
    return em_unsound_pivot(n, M, least, largest);
}

/* C, s <- eigenfactors of M (n, n), close to the given C; eta is rotated with C. Returns -1, or an index where M is
 * singular. */
EM_INLINE int em_refresh(int n, const double *restrict M, double *restrict C, double *restrict s,
                         double *restrict eta) {
    if (EM_IS_SHARED_SIZE(n)) return em_refresh_shared(n, M, C, s, eta);
    double before[n * n];
    if (eta) em_copy(n * n, C, before);
    if (!em_refine(n, M, C, s)) em_sweep(n, M, C, s);
    if (eta) em_turn(n, before, C, eta);
    return em_roots(n, M, s);
}

/* whole (n, n) <- with the entries of a block (size, size) at its coordinates */
EM_INLINE void em_spread(int n, int size, const int *coordinate, const double *block, double *whole) {
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) whole[coordinate[i] * n + coordinate[j]] = block[i * size + j];
}

/* block (size, size) <- the entries of `whole` (n, n) at its coordinates */
EM_INLINE void em_gather(int n, int size, const int *coordinate, const double *whole, double *block) {
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) block[i * size + j] = whole[coordinate[i] * n + coordinate[j]];
}

#if EM_HOLDS_ANY_SIZE

/* Index of the first pivot of M (n, n) with fewer than three correct digits; -1: none. */
EM_COLD_PATH EM_ANY_SIZE int em_first_unsound_pivot(int n, const double *M) {
    double L[n * n], r[n];
    return em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT);
}

/* C orthonormalised to rounding: C <- (3 I - C C^T) C / 2 (Newton-Schulz), which squares the deviation, repeated
 * until it vanishes. */
EM_INLINE void em_orthonormalise(int n, double *restrict C) {
    double K[n * n], D[n * n], deviation = 1.0;
    for (int pass = 0; pass < 8 && deviation > 1e-8; ++pass) {
        deviation = 0.0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= i; ++j) {
                double sum = i == j ? 1.0 : 0.0;
                for (int k = 0; k < n; ++k) sum -= C[i * n + k] * C[j * n + k];
                deviation = fmax(deviation, fabs(sum));
                K[i * n + j] = K[j * n + i] = 0.5 * sum;
            }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                double sum = C[i * n + j];
                for (int k = 0; k < n; ++k) sum += K[i * n + k] * C[k * n + j];
                D[i * n + j] = sum;
            }
        memcpy(C, D, sizeof D);
    }
}

/* Cyclic Jacobi sweeps on Lambda = C M C^T until off-diagonal entries are rounding (Golub & Van Loan, 8.5). If
 * Lambda is nearly diagonal all rotations are small: rows of C keep their order and sign. */
EM_INLINE void em_jacobi(int n, double *restrict Lambda, double *restrict C) {
    for (int sweep = 0, rotated = 1; rotated && sweep < 40; ++sweep) {
        rotated = 0;
        for (int p = 0; p < n; ++p)
            for (int q = p + 1; q < n; ++q)
                if (em_rotates(n, p, q, Lambda)) {
                    em_rotate(n, p, q, 1, Lambda, C);
                    rotated = 1;
                }
    }
}

/* C, lambda <- those of M (n, n), starting from the given C, which need not be close. */
EM_INLINE void em_sweeps(int n, const double *restrict M, double *restrict C, double *restrict lambda) {
    double Lambda[n * n];
    em_orthonormalise(n, C);
    em_congruence(n, C, M, Lambda);
    em_jacobi(n, Lambda, C);
    for (int i = 0; i < n; ++i) lambda[i] = Lambda[i * n + i];
}

/* The same in a run. */
EM_ANY_SIZE void em_sweep(int n, const double *M, double *C, double *lambda) { em_sweeps(n, M, C, lambda); }

/* The same outside of runs, optimised for size. */
EM_COLD_PATH EM_NOINLINE void em_sweep_any(int n, const double *M, double *C, double *lambda) {
    em_sweeps(n, M, C, lambda);
}

/* em_refresh of shared sizes. Sweeps are seldom: n need not be a constant there. */
EM_ANY_SIZE int em_refresh_shared(int n, const double *M, double *C, double *s, double *eta) {
    double before[n * n];
    em_copy(n * n, C, before);
    if (!(n == 6 ? em_refine_of(6, M, C, s) : em_refine_of(7, M, C, s))) em_sweep(n, M, C, s);
    if (eta && n == 6) em_turn(6, before, C, eta);
    else if (eta) em_turn(7, before, C, eta);
    return em_roots(n, M, s);
}

/* C, s <- eigenfactors of M (n, n), starting from the given C, outside of runs. Returns -1, or an index where M is
 * singular. */
EM_ANY_SIZE int em_refresh_any(int n, const double *M, double *C, double *s) {
    em_sweep_any(n, M, C, s);
    return em_roots(n, M, s);
}

/* Eigenfactors of M from scratch: s ascending; in each row of C the entry of largest magnitude is positive. */
EM_COLD_PATH EM_ANY_SIZE int em_eigenfactors(int n, const double *M, double *C, double *s) {
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) C[i * n + j] = i == j;
    const int singular = em_refresh_any(n, M, C, s);
    if (singular >= 0) return singular;
    for (int i = 0; i < n; ++i) {
        int least = i, largest = 0;
        for (int k = i + 1; k < n; ++k)
            if (s[k] < s[least]) least = k;
        const double root = s[i];
        s[i] = s[least];
        s[least] = root;
        for (int j = 0; j < n; ++j) {
            const double entry = C[i * n + j];
            C[i * n + j] = C[least * n + j];
            C[least * n + j] = entry;
            if (fabs(C[i * n + j]) > fabs(C[i * n + largest]) * (1.0 + 1e-9)) largest = j;
        }
        if (C[i * n + largest] < 0.0)
            for (int j = 0; j < n; ++j) C[i * n + j] = -C[i * n + j];
    }
    return -1;
}

/* Both factors of a constant block: M = C^T S^2 C = L L^T. */
EM_COLD_PATH EM_ANY_SIZE int em_prepare_block(int n, const double *M, double *C, double *s, double *L, double *r) {
    memset(L, 0, sizeof *L * (size_t)(n * n));
    const int singular = em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT);
    return singular >= 0 ? singular : em_eigenfactors(n, M, C, s);
}

/* The largest |S^-1 C M C^T S^-1 - 1|: the error of C, s as eigenfactors of M, relative to each eigenvalue. */
EM_ANY_SIZE double em_factor_error(int n, const double *M, const double *C, const double *s) {
    double Lambda[n * n], worst = 0.0;
    em_congruence(n, C, M, Lambda);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) worst = fmax(worst, fabs(Lambda[i * n + j] / (s[i] * s[j]) - (i == j)));
    return worst;
}

#endif

#endif
