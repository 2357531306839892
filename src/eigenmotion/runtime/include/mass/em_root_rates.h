/* em_root_rates.h: rates of the roots of M along the motion, and their effect on the quasi-velocities. */
#ifndef EM_ROOT_RATES_H
#define EM_ROOT_RATES_H

#include "mass/em_quasivelocities.h"

#ifdef EM_BY_TILES
/* Four rows from i on of em_omega_apart, and their mirrored entries in the columns above them. */
EM_INLINE void em_omega_of_rows(int n, int i, const double *restrict s, const double *restrict mu,
                                double *restrict Omega) {
    for (int j = 0; j <= i; j += EM_TILE) {
        const em_numbers_4 across = *(const em_stored_4 *)(s + j);
        em_tile X, turned;
        em_load_tile(n, mu + i * n + j, X);
        for (int row = 0; row < EM_TILE; ++row) {
            X[row] *= 1.0 / ((across - s[i + row]) * (across + s[i + row]));
            if (i == j) X[row] = em_marked(em_before[row], X[row]);
        }
        em_transpose_tile(-1.0, X, turned);
        if (i == j) for (int row = 0; row < EM_TILE; ++row) X[row] += turned[row];
        else em_store_tile(n, turned, Omega + j * n + i);
        em_store_tile(n, X, Omega + i * n + j);
    }
}
#endif

/* Omega (n, n) <- (32) as published, if eigenvalues are separated; only the lower triangle of mu is used. */
EM_INLINE void em_omega_apart(int n, const real *restrict s, const real *restrict mu, real *restrict Omega) {
    int tiled = 0;
#ifdef EM_BY_TILES
    for (tiled = 0; tiled < em_tiled(n); tiled += EM_TILE) em_omega_of_rows(n, tiled, s, mu, Omega);
#endif
    for (int i = tiled; i < n; ++i) {
        Omega[i * n + i] = em_real(0.0);
        for (int j = 0; j < i; ++j) {
            const real gap = (s[j] - s[i]) * (s[j] + s[i]);
            Omega[i * n + j] = mu[i * n + j] * em_inverse(gap); /* the reciprocal is ready before mu is */
            Omega[j * n + i] = -Omega[i * n + j];
        }
    }
}

/* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35); r = 1 / s. */
EM_INLINE void em_factor_rates(int n, const real *restrict C, const real *restrict r, const real *restrict mu,
                               const real *restrict Omega, real *restrict C_dot, real *restrict s_dot) {
    for (int i = 0; i < n; ++i) s_dot[i] = 0.5 * mu[i * n + i] * r[i];
    if (n >= EM_TILE) em_multiply(n, 0, -1.0, Omega, C, C_dot);
    for (int i = 0; i < n && n < EM_TILE; ++i) /* without Omega_ii = 0 */
        for (int j = 0; j < n; ++j) {
            real sum = em_real(0.0);
            for (int k = 0; k < n; ++k) {
                if (k == i) continue;
                sum = k == (i == 0) ? -Omega[i * n + k] * C[k * n + j] : sum - Omega[i * n + k] * C[k * n + j];
            }
            C_dot[i * n + j] = sum;
        }
}

/* The same as em_turning_push, with sums formed side by side along rows, in vectors; T = C^T. The product with a row
 * of Omega is minus that with its column. */
EM_INLINE void em_turning_push_along(int n, const real *restrict T, const real *restrict s, const real *restrict r,
                                     const real *restrict Omega, const real *restrict s_dot,
                                     const real *restrict eta, const real *restrict w, const real *restrict f,
                                     real *restrict a, real *restrict q) {
    real momentum[n], push[n], drag[n], turn[n];
    for (int i = 0; i < n; ++i) momentum[i] = s[i] * eta[i];
    em_transposed_product(n, T, f, push);
    em_transposed_product(n, Omega, momentum, drag);
    for (int i = 0; i < n; ++i) a[i] = r[i] * (push[i] + drag[i] - s_dot[i] * eta[i]);
    if (!q) return;
    em_transposed_product(n, Omega, w, turn);
    for (int i = 0; i < n; ++i) q[i] = -(s[i] * turn[i] + s_dot[i] * w[i]);
}

/* a <- S^-1 (C f - Omega S eta - Sdot eta) (41), and q (NULL: not needed) <- S Omega S^-1 eta - S^-1 Sdot eta:
 * Bdot eta = Adot xdot + B q (40); w = S^-1 eta; T = C^T where rows are tiled. */
EM_INLINE void em_turning_push(int n, const real *restrict C, const real *restrict T, const real *restrict s,
                               const real *restrict r, const real *restrict Omega, const real *restrict s_dot,
                               const real *restrict eta, const real *restrict w, const real *restrict f,
                               real *restrict a, real *restrict q) {
    if (em_tiled(n)) {
        em_turning_push_along(n, T, s, r, Omega, s_dot, eta, w, f, a, q);
        return;
    }
    for (int i = 0; i < n; ++i) {
        real drag = s_dot[i] * eta[i], turn = em_real(0.0);
        for (int j = 0; j < n; ++j) {
            if (n < EM_TILE && j == i) continue; /* Omega_ii = 0 */
            drag += Omega[i * n + j] * (s[j] * eta[j]);
            turn = n < EM_TILE && j == (i == 0) ? Omega[i * n + j] * w[j] : turn + Omega[i * n + j] * w[j];
        }
        a[i] = r[i] * (em_inner(n, C + i * n, f) - drag);
        if (q) q[i] = s[i] * turn - s_dot[i] * w[i];
    }
}

/* a <- L^-1 f - Phi eta, q <- -Phi^T eta: Bdot eta = Adot xdot + B q. Phi is the lower triangle, with half the
 * diagonal, of L^-1 Mdot L^-T; Mdot is overwritten. */
EM_INLINE void em_triangular_push(int n, const real *restrict L, const real *restrict r, real *restrict Mdot,
                                  const real *restrict eta, const real *restrict f, real *restrict a,
                                  real *restrict q) {
    em_copy(n, f, a);
    em_forward(n, L, r, a);
    real X[n * n]; /* transposed, which it is equal to */
    if (em_tiled(n) > 0 ? n > EM_TILE : n >= 2 * EM_TILE) {
        em_forward_columns(n, 0, L, r, Mdot);
        em_transpose(n, Mdot, X);
        em_forward_columns(n, 1, L, r, X);
    } else {
        for (int j = 0; j < n; ++j) em_forward(n, L, r, Mdot + j * n);
        em_forward_columns(n, 0, L, r, Mdot);
        em_transpose(n, Mdot, X);
    }
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            const real Phi = (i == j ? 0.5 : 1.0) * X[j * n + i];
            a[i] -= Phi * eta[j];
            q[j] = i == j ? -Phi * eta[i] : q[j] - Phi * eta[i];
        }
}

#endif
