/* em_rates.h: how the roots of M change along the motion, and what that does to the quasi-velocities. */
#ifndef EM_RATES_H
#define EM_RATES_H

#include "em_eigenfactors.h"

/* Whether two eigenvalues are as close as (32) leaves to extrapolation; gap = s_j^2 - s_i^2. */
#define EM_EPSILON 1e-6
EM_INLINE int em_is_close(double gap, double s_i, double s_j) {
    const double larger = fmax(s_i, s_j);
    return fabs(gap) < EM_EPSILON * larger * larger;
}

/* Omega (n, n) <- (32), (53). Where two eigenvalues are close and `kept` is given, (2, n, n) of the last accepted step,
 * Omega(t_0) + Omegadot(t_0) since. Returns whether that was so anywhere. */
EM_INLINE int em_omega(int n, const double *restrict s, const double *restrict mu, const double *kept, double since,
                       double *restrict Omega) {
    int continued = 0;
    for (int i = 0; i < n; ++i) {
        Omega[i * n + i] = 0.0;
        for (int j = 0; j < i; ++j) {
            const int at = i * n + j;
            const double gap = (s[j] - s[i]) * (s[j] + s[i]);
            const int close = kept && em_is_close(gap, s[i], s[j]);
            Omega[at] = close ? kept[at] + since * kept[n * n + at] : mu[at] / gap;
            Omega[j * n + i] = -Omega[at];
            continued |= close;
        }
    }
    return continued;
}

/* kept (2, n, n) <- Omega of (32), (53) here and its difference quotient over `elapsed` (0: none yet). */
EM_INLINE void em_remember_omega(int n, const double *s, const double *mu, double elapsed, double *kept) {
    double Omega[n * n];
    em_omega(n, s, mu, kept, elapsed, Omega);
    for (int at = 0; at < n * n; ++at) {
        kept[n * n + at] = elapsed == 0.0 ? 0.0 : (Omega[at] - kept[at]) / elapsed;
        kept[at] = Omega[at];
    }
}

/* Omega (n, n) <- (32) as published, where eigenvalues are apart. */
EM_INLINE void em_omega_apart(int n, const double *restrict s, const double *restrict mu, double *restrict Omega) {
    for (int i = 0; i < n; ++i) {
        Omega[i * n + i] = 0.0;
        for (int j = 0; j < i; ++j) {
            const double gap = (s[j] - s[i]) * (s[j] + s[i]);
            Omega[i * n + j] = mu[i * n + j] * (1.0 / gap); /* the reciprocal is ready before mu is */
            Omega[j * n + i] = -Omega[i * n + j];
        }
    }
}

/* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35); r = 1 / s. */
EM_INLINE void em_factor_rates(int n, const double *restrict C, const double *restrict r, const double *restrict mu,
                               const double *restrict Omega, double *restrict C_dot, double *restrict s_dot) {
    for (int i = 0; i < n; ++i) {
        s_dot[i] = 0.5 * mu[i * n + i] * r[i];
        for (int j = 0; j < n; ++j) {
            double sum = 0.0;
            for (int k = 0; k < n; ++k) sum -= Omega[i * n + k] * C[k * n + j];
            C_dot[i * n + j] = sum;
        }
    }
}

/* a <- S^-1 (C f - Omega S eta - Sdot eta) (41), and q (NULL: not asked) <- S Omega S^-1 eta - S^-1 Sdot eta:
 * Bdot eta = Adot xdot + B q (40); w = S^-1 eta. */
EM_INLINE void em_turning_push(int n, const double *restrict C, const double *restrict s, const double *restrict r,
                               const double *restrict Omega, const double *restrict s_dot, const double *restrict eta,
                               const double *restrict w, const double *restrict f, double *restrict a,
                               double *restrict q) {
    for (int i = 0; i < n; ++i) {
        double push = 0.0, drag = s_dot[i] * eta[i], turn = 0.0;
        for (int j = 0; j < n; ++j) {
            push += C[i * n + j] * f[j];
            drag += Omega[i * n + j] * (s[j] * eta[j]);
            turn += Omega[i * n + j] * w[j];
        }
        a[i] = r[i] * (push - drag);
        if (q) q[i] = s[i] * turn - s_dot[i] * w[i];
    }
}

/* a <- L^-1 f - Phi eta, q <- -Phi^T eta: Bdot eta = Adot xdot + B q. Phi is the lower triangle, with half the
 * diagonal, of L^-1 Mdot L^-T; Mdot is overwritten. */
EM_INLINE void em_triangular_push(int n, const double *restrict L, const double *restrict r, double *restrict Mdot,
                                  const double *restrict eta, const double *restrict f, double *restrict a,
                                  double *restrict q) {
    for (int i = 0; i < n; ++i) a[i] = f[i], q[i] = 0.0;
    em_forward(n, L, r, a);
    for (int j = 0; j < n; ++j) em_forward(n, L, r, Mdot + j * n);
    em_forward_columns(n, L, r, Mdot);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            const double Phi = (i == j ? 0.5 : 1.0) * Mdot[i * n + j];
            a[i] -= Phi * eta[j];
            q[j] -= Phi * eta[i];
        }
}

#endif
