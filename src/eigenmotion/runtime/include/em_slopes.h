/* em_slopes.h: how the acceleration a(t, x, v) of the constrained motion changes with x and with v. */
#ifndef EM_SLOPES_H
#define EM_SLOPES_H

#include "em_blame.h"

#ifdef EM_MECHANICS_H
static int em_slopes_at(em_walk *w, double t, const double *z, double *J) {
#if EM_ALONE(EM_METHODS) /* derivatives are another unit, which may be in another library */
    const em_run *run = w->run;
    return run->model->motion_jacobian(em_clock(w, t), z, run->prepared, w->u, em_constraint_flags(run), J, &w->reason);
#else
    return em_motion_jacobian(em_clock(w, t), z, w->run->prepared, w->u, em_constraint_flags(w->run), J, &w->reason);
#endif
}
#else
/* A model written by hand states no derivatives: differences, which an iteration needs no better. */
static int em_bare_rate(em_walk *w, double t, const double *z, double *rate) {
    double y[EM_WIDTH] = {0.0}, dy[EM_WIDTH], memory[EM_SOME_MEMORY];
    memcpy(y, z, 2 * N * sizeof *y);
    memcpy(memory, w->memory, sizeof memory);
    if (em_motion_rhs(t, y, w->run->prepared, w->u, memory, 0, dy, &w->reason)) return -1;
    memcpy(rate, dy, 2 * N * sizeof *rate);
    for (int k = 0; k < 2 * N; ++k)
        if (!isfinite(rate[k])) return em_not_finite(w, z, rate);
    return 0;
}

/* Column k: over both sides, or the one on which there are rates. */
static int em_bare_slope(em_walk *w, double t, double *at, int k, const double *here, double *J) {
    double up[2 * N], down[2 * N], z = at[k], high = z + 1e-3 * fmax(1.0, fabs(z)), low = z - (high - z);
    at[k] = high;
    if (em_bare_rate(w, t, at, up)) high = z, memcpy(up, here, sizeof up);
    at[k] = low;
    if (em_bare_rate(w, t, at, down)) low = z, memcpy(down, here, sizeof down);
    at[k] = z;
    for (int row = 0; row < 2 * N; ++row) J[row * 2 * N + k] = (up[row] - down[row]) / (high - low);
    return high > low ? 0 : -1;
}

static int em_slopes_at(em_walk *w, double t, const double *z, double *J) {
    double at[2 * N], here[2 * N];
    memcpy(at, z, sizeof at);
    if (em_bare_rate(w, t, at, here)) return -1;
    for (int k = 0; k < 2 * N; ++k)
        if (em_bare_slope(w, t, at, k, here, J)) return -1;
    return 0;
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
