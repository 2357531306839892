/* em_jacobi_rotations.h: Jacobi rotations of C, by which Lambda = C M C^T becomes diagonal (Golub & Van Loan, 8.5),
 * for doubles and for lanes. */
#ifndef EM_JACOBI_ROTATIONS_H
#define EM_JACOBI_ROTATIONS_H

#include "numeric/em_linear.h"

/* Whether Lambda_pq is above rounding. */
EM_INLINE em_truth em_rotates(int n, int p, int q, const real *restrict Lambda) {
    const real off = Lambda[p * n + q];
    return off * off > DBL_EPSILON * DBL_EPSILON * fabs(Lambda[p * n + p] * Lambda[q * n + q]);
}

/* One rotation that makes Lambda_pq zero, in the `active` lanes; C is rotated, too. */
EM_INLINE void em_rotate(int n, int p, int q, em_truth active, real *restrict Lambda, real *restrict C) {
    const real none = em_real(0.0), off = em_where(active, Lambda[p * n + q], none);
    const real theta = 0.5 * (Lambda[q * n + q] - Lambda[p * n + p]) / em_where(active, off, em_real(1.0));
    const real sign = em_where(theta < 0.0, em_real(-1.0), em_real(1.0));
    const real tangent = em_where(active, sign / (fabs(theta) + sqrt(theta * theta + 1.0)), none);
    const real cosine = 1.0 / sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
    Lambda[p * n + p] -= tangent * off;
    Lambda[q * n + q] += tangent * off;
    Lambda[p * n + q] = Lambda[q * n + p] = em_where(active, none, Lambda[p * n + q]);
    for (int k = 0; k < n; ++k) {
        const real Cp = C[p * n + k], Cq = C[q * n + k];
        C[p * n + k] = cosine * Cp - sine * Cq;
        C[q * n + k] = sine * Cp + cosine * Cq;
        if (k == p || k == q) continue;
        const real Lp = Lambda[p * n + k], Lq = Lambda[q * n + k];
        Lambda[p * n + k] = Lambda[k * n + p] = cosine * Lp - sine * Lq;
        Lambda[q * n + k] = Lambda[k * n + q] = sine * Lp + cosine * Lq;
    }
}

#endif
