/* em_slopes.h: how the acceleration a(t, x, v) of the constrained motion changes with x and with v. */
#ifndef EM_SLOPES_H
#define EM_SLOPES_H

#include "em_differentiate.h"
#include "em_walk.h"

#ifdef EM_MECHANICS_H
static int em_slopes_at(em_walk *w, double t, const double *z, double *J) {
    return em_motion_jacobian(em_clock(w, t), z, w->run->prepared, w->u, em_constraint_flags(w->run), J, &w->reason);
}
#else
static int em_bare_rate(const void *with, double t, const double *z, double *rate, em_fault *fault) {
    const em_walk *w = with;
    double y[EM_WIDTH] = {0.0}, dy[EM_WIDTH], memory[EM_SOME_MEMORY];
    memcpy(y, z, 2 * N * sizeof *y);
    memcpy(memory, w->memory, sizeof memory);
    if (em_motion_rhs(t, y, w->run->prepared, w->u, memory, 0, dy, fault)) return -1;
    memcpy(rate, dy, 2 * N * sizeof *rate);
    return 0;
}

static int em_slopes_at(em_walk *w, double t, const double *z, double *J) {
    return em_differentiate(em_bare_rate, w, 2 * N, t, z, J, &w->reason);
}
#endif

/* K (n, n) = da/dx and D (n, n) = da/dv at z = (x, v), signals in w->u. 0, or -1 and w->reason */
static int em_acceleration_slopes(em_walk *w, double t, const double *z, double *K, double *D) {
    double J[4 * N * N];
    ++w->run->n_jacobians;
    if (em_slopes_at(w, t, z, J)) return -1;
    for (int i = 0; i < N; ++i) {
        memcpy(K + i * N, J + (N + i) * 2 * N, N * sizeof *K);
        memcpy(D + i * N, J + (N + i) * 2 * N + N, N * sizeof *D);
    }
    return 0;
}

#endif
