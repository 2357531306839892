/* em_quasivelocities.h: quasi-velocities: eta from xdot and back, and forces and constraint rows in terms of C and
 * s. */
#ifndef EM_QUASIVELOCITIES_H
#define EM_QUASIVELOCITIES_H

#include "numeric/em_linear.h"

/* eta <- C^T S^-1 eta, the velocities (20) */
EM_INLINE void em_velocity_of_eta(int n, const real *restrict C, const real *restrict s, real *restrict eta) {
    real v[n], w[n];
    for (int i = 0; i < n; ++i) w[i] = eta[i] / s[i];
    em_transposed_product(n, C, w, v);
    memcpy(eta, v, sizeof v);
}

/* v <- S C v, the quasi-velocities (17) */
EM_INLINE void em_eta_of_velocity(int n, const real *restrict C, const real *restrict s, real *restrict v) {
    real eta[n];
    for (int i = 0; i < n; ++i) eta[i] = s[i] * em_inner(n, C + i * n, v);
    memcpy(v, eta, sizeof eta);
}

/* eta <- C^T S eta, the momenta M xdot. They follow from the forces alone, however Omega turns C and eta. */
EM_INLINE void em_momentum_of_eta(int n, const real *restrict C, const real *restrict s, real *restrict eta) {
    real p[n], w[n];
    for (int i = 0; i < n; ++i) w[i] = s[i] * eta[i];
    em_transposed_product(n, C, w, p);
    memcpy(eta, p, sizeof p);
}

/* f <- S^-1 C f: a force, or a constraint row, in quasi-velocities (28) */
EM_INLINE void em_force_on_eta(int n, const real *restrict C, const real *restrict s, real *restrict f) {
    real a[n];
    for (int i = 0; i < n; ++i) a[i] = em_inner(n, C + i * n, f) / s[i];
    memcpy(f, a, sizeof a);
}

/* eta (n) <- rotated from the rows `before` to the rows of C, correct to first order in the deviation of `before` from
 * orthonormality. */
EM_INLINE void em_turn(int n, const real *restrict before, const real *restrict C, real *restrict eta) {
    real v[n], back[n];
    em_transposed_product(n, before, eta, v);
    em_product(1, n, v, before, back);
    for (int i = 0; i < n; ++i) eta[i] += 0.5 * (eta[i] - back[i]);
    em_transposed_product(n, before, eta, v);
    em_product(1, n, v, C, eta);
}

/* v <- C^T S^-1 eta (20); also r = 1 / s and w = S^-1 eta. */
EM_INLINE void em_velocity(int n, const real *restrict C, const real *restrict s, const real *restrict eta,
                           real *restrict r, real *restrict w, real *restrict v) {
    for (int i = 0; i < n; ++i) {
        r[i] = em_inverse(s[i]);
        w[i] = r[i] * eta[i];
        if (n == 1) v[i] = w[i];
    }
    if (n > 1) em_transposed_product(n, C, w, v);
}

/* B (m, n) <- A C^T S^-1 (28), r = 1 / s; of one row, a force: a = S^-1 C f. */
EM_INLINE void em_rows_on_eta(int m, int n, const real *restrict C, const real *restrict r,
                              const real *restrict A, real *restrict B) {
    for (int row = 0; row < m; ++row)
        for (int i = 0; i < n; ++i) B[row * n + i] = r[i] * (n == 1 ? A[row] : em_inner(n, A + row * n, C + i * n));
}

#endif
