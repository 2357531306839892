/* em_lane_factors.h: refresh of C and s on lanes, after a step in all lanes. The result marks the lanes that keep their
 * root of M; the scalar code settles the others (em_blocks.h). */
#ifndef EM_LANE_FACTORS_H
#define EM_LANE_FACTORS_H

#include "mass/em_eigen_refinement.h"
#include "mass/em_jacobi_rotations.h"
#include "mass/em_root_switching.h"

/* Bound on the sum of the squares of the remaining rotations, below which em_refine continues. */
#define EM_LANE_CONVERGED 1e-6

/* C <- rotated close enough to the eigenfactors of M (n, n) for em_refine, by Jacobi sweeps in the lanes that are `far`
 * from them, as after a step during which C was constant. Each lane makes as many sweeps as it would alone. */
EM_NOINLINE void em_sweep_lanes(int n, em_truth far, const real *restrict M, real *restrict C) {
    real Lambda[n * n];
    em_congruence(n, C, M, Lambda);
    for (int sweep = 0; em_any(far) && sweep < 6; ++sweep) {
        for (int p = 0; p < n; ++p)
            for (int q = p + 1; q < n; ++q) em_rotate(n, p, q, far & em_rotates(n, p, q, Lambda), Lambda, C);
        em_truth turned = ~(em_truth){0};
        for (int p = 0; p < n; ++p)
            for (int q = p + 1; q < n; ++q) {
                const real off = Lambda[p * n + q], apart = Lambda[p * n + p] - Lambda[q * n + q];
                turned &= off * off <= EM_LANE_CONVERGED * apart * apart;
            }
        far &= ~turned;
    }
}

/* C, s <- eigenfactors of M (n, n), close to the given C; eta (NULL: of another root) is rotated with C. Returns -1 in
 * lanes where they are found, with eigenvalues that are clearly positive. */
EM_INLINE em_truth em_refresh(int n, const real *restrict M, real *restrict C, real *restrict s, real *restrict eta) {
    real before[n * n];
    if (eta) em_copy(n * n, C, before);
    em_truth found = em_refine(n, ~(em_truth){0}, M, C, s);
    if (em_any(~found)) {
        em_sweep_lanes(n, ~found, M, C);
        found |= em_refine(n, ~found, M, C, s);
    }
    if (eta) em_turn(n, before, C, eta);
    real least = s[0], largest = s[0];
    for (int i = 0; i < n; ++i) {
        least = em_min(s[i], least);
        largest = em_max(s[i], largest);
        s[i] = sqrt(s[i]);
    }
    return found & (least > 10.0 * EM_SINGULAR_PIVOT * largest);
}

/* The time to the nearest crossing of eigenvalues, as M (n, n) changes by Mdot. */
EM_INLINE real em_time_on_lanes(int n, const real *restrict C, const real *restrict s, const real *restrict Mdot) {
    real mu[n * n];
    em_congruence(n, C, Mdot, mu);
    return em_time_to_crossing(n, s, mu);
}

/* -1 in lanes whose runs stay in the mode (em_mode_by_gaps, em_mode_by_time). */
EM_INLINE em_truth em_keeps_mode(int mode, real gap, real time, real pace) {
    const em_truth apart = gap > EM_APART;
    if (mode) return ~apart & ((gap < EM_CLOSE) | (time < EM_FAR * fabs(pace)));
    return apart | ~(time < EM_NEAR * fabs(pace));
}

/* D (n) of M = L D L^T, and the diagonal of M. Where M is not positive definite, D is NaN or not positive. */
EM_INLINE void em_pivots(int n, const real *restrict M, real *restrict pivots, real *restrict diagonal) {
    real L[n * n], r[n];
    em_ldlt(n, M, L, r, 0.0);
    for (int k = 0; k < n; ++k) {
        pivots[k] = L[k * n + k];
        diagonal[k] = M[k * n + k];
    }
}

#endif
