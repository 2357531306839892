/* em_reset.h: resets: states that events set, in rates or in quasi-velocities. */
#ifndef EM_RESET_H
#define EM_RESET_H

#include "contact/em_active_set.h"
#include "numeric/em_complete_pivoting.h"

#define EM_RESET_TOLERANCE 1e-8 /* the part of its terms by which a reset may violate a constraint */

enum { EM_SOME_IMPACTS = N_IMPACTS > 0 ? N_IMPACTS : 1, EM_SOME_RESETS = N_RESETS > 0 ? N_RESETS : 1 };

/* v (n) <- the solution of P(x, t) v = y (3). 0, or -1: P is singular. */
EM_NOINLINE int em_rates_of_quasi(double t, const double *x, const double *y, const double *c, double *v) {
#ifdef EM_QUASI
    double P[N * N], unit[N] = {0.0}, column[N];
    for (int j = 0; j < N; ++j) {
        unit[j] = 1.0;
        quasi(t, x, unit, c, column);
        unit[j] = 0.0;
        for (int i = 0; i < N; ++i) P[i * N + j] = column[i];
    }
    memcpy(v, y, N * sizeof *v);
    return em_solve_completely(N, P, v, 0.0, NULL);
#else
    (void)t, (void)x, (void)c;
    return memcpy(v, y, N * sizeof *v), 0;
#endif
}

/* Checks that resets, the last of which is that of `event`, have not moved x beyond the surface of an impact, further
 * than at `from` and by more than rounding. 0, or -1 and *fault. */
EM_NOINLINE int em_check_apart(double t, const double *from, const double *x, const double *v, const double *c,
                           const double *u, int event, em_fault *fault) {
    double g[N_EVENTS], near[N], there[N_EVENTS], before[N_EVENTS];
    model_events(t, from, v, c, u, before);
    model_events(t, x, v, c, u, g);
    for (int i = 0; i < N_EVENTS; ++i) {
        if (event_actions[i].impact < 0 || !(g[i] * event_actions[i].keeps_apart < 0.0)) continue;
        double reach = 2.0 * fmax(0.0, -before[i] * event_actions[i].keeps_apart);
        for (int k = 0; k < N; ++k) {
            memcpy(near, x, sizeof near);
            near[k] += EM_RESET_TOLERANCE * fabs(near[k]);
            model_events(t, near, v, c, u, there);
            reach += fabs(there[i] - g[i]);
        }
        if (fabs(g[i]) > reach) return em_fail(fault, EM_RESET_INSIDE, event, i, g[i] * event_actions[i].keeps_apart);
    }
    return 0;
}

#endif
