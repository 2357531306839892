/* em_close_eigenvalues.h: Omega of (32), (53) where two eigenvalues are close: extrapolated from the last accepted
 * step. */
#ifndef EM_CLOSE_EIGENVALUES_H
#define EM_CLOSE_EIGENVALUES_H

#include "constraints/em_multipliers.h"

#ifdef EM_ON_LANES
/* Without the memory of a run, (32), (53) are evaluated as published. */
EM_INLINE int em_omega(int n, const real *restrict s, const real *restrict mu, const double *kept, double since,
                       real *restrict Omega) {
    return (void)kept, (void)since, em_omega_apart(n, s, mu, Omega), 0;
}
#else

/* Whether two eigenvalues are so close that (32) is replaced by extrapolation; gap = s_j^2 - s_i^2. */
#define EM_EPSILON 1e-6
EM_INLINE int em_is_close(double gap, double s_i, double s_j) {
    const double larger = fmax(s_i, s_j);
    return fabs(gap) < EM_EPSILON * larger * larger;
}

/* Omega (n, n) <- (32), (53). If two eigenvalues are close and `kept` is given, (2, n, n) of the last accepted step,
 * Omega(t_0) + Omegadot(t_0) since. Returns whether that was the case. */
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

/* Delta_dot (m, m) += Adot Y^T + Y Adot^T - Y Mdot Y^T, the part of one block in the rate of A M^-1 A^T;
 * Y (m, n) = A M^-1, Mdot NULL where M is constant. (51) without Bdot. */
EM_NOINLINE void em_add_delta_rate(int m, int n, const double *Adot, const double *Y, const double *Mdot,
                               double *Delta_dot) {
    for (int row = 0; row < m; ++row)
        for (int column = 0; column < m; ++column)
            for (int i = 0; i < n; ++i) {
                double sum = Adot[row * n + i] * Y[column * n + i] + Y[row * n + i] * Adot[column * n + i];
                for (int j = 0; Mdot && j < n; ++j) sum -= Y[row * n + i] * Mdot[i * n + j] * Y[column * n + j];
                Delta_dot[row * m + column] += sum;
            }
}

#endif
#endif
