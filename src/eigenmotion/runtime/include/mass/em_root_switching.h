/* em_root_switching.h: switching between the published system and the triangular root, where eigenvalues come close.
 *
 * The triangular root is used as soon as a crossing of eigenvalues is nearer than EM_NEAR times the time scale of the
 * motion, and until it is further away than EM_FAR times that. Eigenvalues further apart than EM_APART, relative to
 * the larger, are ignored; those closer than EM_CLOSE never count as far. For eigenvalues of Delta the criterion is
 * their relative gap; with the triangular root Delta is factored numerically. */
#ifndef EM_ROOT_SWITCHING_H
#define EM_ROOT_SWITCHING_H

#include "mass/em_quasivelocities.h"

#define EM_NEAR 1.0
#define EM_FAR 1.4
#define EM_APART 0.5
#define EM_CLOSE 1e-3
#define EM_DELTA_CLOSE 0.05
#define EM_DELTA_APART 0.1

enum { EM_BY_TIME = -1 }; /* the time to the nearest crossing decides */

/* The smallest number of a (n), none of which is NaN. */
EM_INLINE real em_smallest(int n, const real *restrict a) {
    real least = em_real(INFINITY);
    for (int i = 0; i < n; ++i) least = em_where(a[i] < least, a[i], least);
    return least;
}

/* The smallest distance of two eigenvalues, relative to the larger. */
EM_INLINE real em_gap(int n, const real *restrict s) {
    real gap[n]; /* from each eigenvalue to those before */
    for (int j = 0; j < n; ++j) gap[j] = em_real(INFINITY);
    for (int i = 0; i < n; ++i) {
        EM_ALONG
        for (int j = 0; j < n; ++j) {
            const real larger = em_where(s[j] > s[i], s[j], s[i]), apart = fabs((s[i] - s[j]) * (s[i] + s[j]));
            real here = apart / (larger * larger);
            if (j >= i) here = em_real(INFINITY);
            gap[j] = em_where(here < gap[j], here, gap[j]);
        }
    }
    return em_smallest(n, gap);
}

/* The time to the nearest crossing: with M(t + z) = M + z Mdot the eigenvalues i, j meet at a complex z of size |l_i
 * - l_j| / sqrt((mu_ii - mu_jj)^2 + 4 mu_ij^2). A step that is not well inside that distance sees a spike in Omega. */
EM_INLINE real em_time_to_crossing(int n, const real *restrict s, const real *restrict mu) {
    real time[n], rate[n];
    for (int j = 0; j < n; ++j) time[j] = em_real(INFINITY), rate[j] = mu[j * n + j];
    for (int i = 0; i < n; ++i) {
        EM_ALONG
        for (int j = 0; j < n; ++j) {
            const real apart = rate[i] - rate[j], across = 2.0 * mu[i * n + j];
            const real speed = sqrt(apart * apart + across * across);
            real here = fabs((s[i] - s[j]) * (s[i] + s[j])) / em_where(speed > DBL_MIN, speed, em_real(DBL_MIN));
            if (j >= i) here = em_real(INFINITY);
            time[j] = em_where(here < time[j], here, time[j]);
        }
    }
    return em_smallest(n, time);
}

/* The next mode, by the relative gaps of the eigenvalues of M and of Delta; or EM_BY_TIME. */
EM_INLINE int em_mode_by_gaps(int mode, int flags, double gap, double delta_gap) {
    if (flags & EM_BEGIN) return gap < EM_CLOSE;
    if (flags & EM_KEEP_MODE) return mode;
    if (delta_gap < (mode ? EM_DELTA_APART : EM_DELTA_CLOSE)) return 1;
    return gap > EM_APART ? 0 : EM_BY_TIME;
}

/* The same by the time to the nearest crossing; pace: the time scale of the motion. */
EM_INLINE int em_mode_by_time(int mode, double gap, double time, double pace) {
    return mode ? gap < EM_CLOSE || time < EM_FAR * fabs(pace) : time < EM_NEAR * fabs(pace);
}

/* eta <- the same velocities with the other root: L^T xdot if `triangular`, else S C xdot. */
EM_INLINE void em_change_root(int n, int triangular, const real *restrict C, const real *restrict s,
                              const real *restrict L, const real *restrict r, real *restrict eta) {
    if (triangular) {
        em_velocity_of_eta(n, C, s, eta);
        em_transposed(n, L, eta);
    } else {
        em_backward(n, L, r, eta);
        em_eta_of_velocity(n, C, s, eta);
    }
}

#endif
