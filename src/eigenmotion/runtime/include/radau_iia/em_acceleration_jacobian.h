/* em_acceleration_jacobian.h: Jacobian blocks da/dx and da/dv of the constrained acceleration a(t, x, v). */
#ifndef EM_ACCELERATION_JACOBIAN_H
#define EM_ACCELERATION_JACOBIAN_H

#include "stepper/em_error_norm.h"
#include "stepper/em_failure_location.h"

/* A model written by hand has no derivatives: finite differences are good enough for the iteration. */
static int em_bare_rate(em_run_state *w, double t, const double *z, double *rate) {
    const int n = w->n;
    double y[w->width], dy[w->width], memory[em_padded(w->n_memory)];
    memset(y, 0, sizeof y);
    memcpy(y, z, 2 * (size_t)n * sizeof *y);
    em_copy_memory(w, memory, w->memory);
    if (em_motion_rhs(w->model, t, y, w->run->prepared, w->u, memory, 0, dy, &w->reason)) return -1;
    memcpy(rate, dy, 2 * (size_t)n * sizeof *rate);
    for (int k = 0; k < 2 * n; ++k)
        if (!isfinite(rate[k])) return em_not_finite(w, z, rate);
    return 0;
}

#define EM_SLOPE_PART 1e-2     /* of the change in the step */
#define EM_SLOPE_ROUNDING 6e-6 /* relative: the part of a number that central differences change at
                                  least, about the cube root of its rounding */

/* The change of number k of x and v over which a slope is taken: a part of its change in the step, no less than its
 * tolerance, and far more than its rounding. Where all of these vanish, any change will do. */
static double em_slope_change(const em_run_state *w, const double *at, int k) {
    const int n = w->n;
    double change = EM_SLOPE_PART * fabs(w->h * w->K[0][k]);
    change = em_max(change, em_max(em_tolerance_of(w, k), EM_SLOPE_ROUNDING * fabs(at[k])));
    if (k < n) change = em_max(change, fabs(w->h) * em_slope_change(w, at, n + k));
    return change > 0.0 ? change : sqrt(EM_LEAST_SIZE);
}

/* Column k: by central differences, or one-sided ones if only one side can be evaluated. */
static int em_bare_slope(em_run_state *w, double t, double *at, int k, const double *here, double *J) {
    double up[2 * w->n], down[2 * w->n], z = at[k], high = z + em_slope_change(w, at, k), low = z - (high - z);
    at[k] = high;
    if (em_bare_rate(w, t, at, up)) high = z, memcpy(up, here, sizeof up);
    at[k] = low;
    if (em_bare_rate(w, t, at, down)) low = z, memcpy(down, here, sizeof down);
    at[k] = z;
    for (int row = 0; row < 2 * w->n; ++row) J[row * 2 * w->n + k] = (up[row] - down[row]) / (high - low);
    return high > low ? 0 : -1;
}

static int em_bare_slopes(em_run_state *w, double t, const double *z, double *J) {
    double at[2 * w->n], here[2 * w->n];
    memcpy(at, z, sizeof at);
    if (em_bare_rate(w, t, at, here)) return -1;
    for (int k = 0; k < 2 * w->n; ++k)
        if (em_bare_slope(w, t, at, k, here, J)) return -1;
    return 0;
}

/* By the model that the caller names, which may have derivatives that the stepper's own does not have. */
static int em_slopes_at(em_run_state *w, double t, const double *z, double *J) {
    const em_run *const run = w->run;
    const em_model *const model = run->model ? run->model : w->model;
    if (w->bare) return em_bare_slopes(w, t, z, J);
    t = em_clock(w, t);
    return model->motion_jacobian(t, z, run->prepared, w->u, em_constraint_flags(run), J, &w->reason)
               ? em_locate_failure(w, t, z) : 0;
}

/* K (n, n) = da/dx and D (n, n) = da/dv at z = (x, v), signals in w->u. 0, or -1 and w->reason */
static int em_acceleration_slopes(em_run_state *w, double t, const double *z, double *K, double *D) {
    const int n = w->n;
    double J[4 * n * n];
    ++w->run->n_jacobians;
    if (em_slopes_at(w, t, z, J)) return -1;
    for (int i = 0; i < n; ++i) {
        const double *const row = J + (n + i) * 2 * n;
        for (int k = 0; k < n; ++k) K[i * n + k] = row[k], D[i * n + k] = row[n + k];
    }
    return 0;
}

#endif
