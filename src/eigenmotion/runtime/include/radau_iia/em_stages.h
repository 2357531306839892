/* em_stages.h: the stage equations of an implicit step, and the iteration that solves them.
 *
 * The unknowns are the accelerations a_i at the stages; from them follow V = v + h A a and X = x + h A V. With a
 * Jacobian K = da/dx, D = da/dv shared by all stages, an eigenvalue mu of A^-1 and sigma = mu / h, the equations
 * decouple into systems with the matrix sigma^2 - sigma D - K of size n: one real, the others complex
 * (em_simplified_newton.h). With a Jacobian for each stage they are one system of s n equations (em_full_newton.h). */
#ifndef EM_STAGES_H
#define EM_STAGES_H

#include "stepper/em_failure_location.h"
#include "radau_iia/em_full_newton.h"
#include "radau_iia/em_simplified_newton.h"

#ifndef EM_ITERATION_TOLERANCE
#define EM_ITERATION_TOLERANCE 0.01 /* the part of the tolerances left to the iteration; tests of the order use less */
#endif
#define EM_STAGNANT 0.5     /* contraction above which the iteration stagnates */
#define EM_STAGE_ROUNDING (16.0 * DBL_EPSILON)

enum { EM_SOLVED, EM_NOT_SOLVED, EM_NO_RATE }; /* a stage failed; w->reason says why */

/* With three stages seven iterations; two and a half more for each further one (Hairer & Wanner, IV.8). */
static int em_most_iterations(const em_radau_iia *rk) { return 7 + 5 * (rk->stages - 3) / 2; }

/* X, V of the stages, from their accelerations. */
EM_INLINE void em_stage_states(const em_radau_iia *rk, em_run_state *w, int stride) {
    em_implicit *q = &w->stages;
    em_by_stages(rk, w->h, stride, w->y + w->n, q->a, q->V);
    em_by_stages(rk, w->h, stride, w->y, q->V, q->X);
}

/* Weights of x and v, from the start of the step to its end. */
static void em_weigh_stages(const em_radau_iia *rk, em_run_state *w) {
    const em_implicit *q = &w->stages;
    const double *const v = q->V + (rk->stages - 1) * w->stride;
    em_set_weights(w, w->y, w->K[0], q->X + (rk->stages - 1) * w->stride, v);
    if (em_is_relative(w)) em_weigh_rounding_of_motion(w, v);
}

/* dy <- the rate at t, x, v (n), of stage i; i = -1: at the start. Signals are those of em_signal_averages.h if the
 * step crosses samples. 0, or -1 and w->reason */
static int em_rate_of_stage(em_run_state *w, int i, double t, const double *x, const double *v, double *dy) {
    em_implicit *q = &w->stages;
    em_copy_packs(w->n, w->argument, x);
    em_copy_packs(w->n, w->argument + w->n, v); /* over what the last pack has overwritten */
    if (w->n_positions > 0 && w->near && !q->averaged) return em_settled_rhs(w, t, w->argument, dy);
    if (q->averaged) memcpy(w->u, q->u + (1 + i) * w->n_inputs, (size_t)w->n_inputs * sizeof *w->u);
    else if (w->n_inputs > 0) em_signals(w, t);
    return em_motion_rate_here(w, t, w->argument, dy);
}

/* r (n) of every stage <- its rate minus its acceleration. 0, or -1 and w->reason */
EM_INLINE int em_stage_residuals(const em_radau_iia *rk, em_run_state *w, int stride) {
    em_implicit *q = &w->stages;
    double dy[w->width];
    for (int i = 0; i < rk->stages; ++i) {
        if (em_rate_of_stage(w, i, w->t + rk->c[i] * w->h, q->X + i * stride, q->V + i * stride, dy)) return -1;
        for (int k = 0; k < w->n; ++k) q->r[i * stride + k] = dy[w->n + k] - q->a[i * stride + k];
    }
    return 0;
}

/* Adds the changes of the accelerations; X and V are recomputed, because updates of a poor guess would leave
 * rounding in them. Returns the norm of the changes of x and v, in tolerances. */
EM_INLINE double em_take_changes(const em_radau_iia *rk, em_run_state *w, int stride, const double *change) {
    em_implicit *q = &w->stages;
    const int n = w->n, last = (rk->stages - 1) * stride;
    double faster[EM_MOST_NODES * stride], farther[EM_MOST_NODES * stride], sum = 0.0;
    em_by_stages(rk, w->h, stride, NULL, change, faster);
    em_by_stages(rk, w->h, stride, NULL, faster, farther);
    for (int i = 0; i < rk->stages; ++i) {
        double *const a = q->a + i * stride;
        for (int k = 0; k < stride; k += EM_PACK) EM_PUT_PACK(a + k, EM_PACK_AT(a + k) + EM_PACK_AT(change + i * stride + k));
        sum += em_weighted_squares(n, farther + i * stride, w->weight) + em_weighted_squares(n, faster + i * stride, w->weight + n);
    }
    em_stage_states(rk, w, stride);
    em_copy_packs(n, w->error, farther + last);
    em_copy_packs(n, w->error + n, faster + last);
    return sqrt(em_mean(sum, 2 * n * rk->stages));
}

/* The change of the stages by rounding of x and v, in tolerances. */
static double em_stage_noise(const em_run_state *w) {
    double sum = em_weighted_squares(2 * w->n, w->y, w->weight);
    for (int k = 0; k < w->n; ++k) {
        const double shaken = w->y[k] / w->h * w->weight[w->n + k];
        sum += shaken * shaken;
    }
    return em_min(0.3, EM_STAGE_ROUNDING * sqrt(sum / (2 * w->n)));
}

/* size (stages) <- the change of the velocities by the residuals of each stage if it were not stiff, in tolerances. */
EM_INLINE void em_sizes_of_residuals(const em_radau_iia *rk, const em_run_state *w, double *size) {
    for (int i = 0; i < rk->stages; ++i)
        size[i] = fabs(w->h) * sqrt(em_mean(em_weighted_squares(w->n, w->stages.r + i * w->stride, w->weight + w->n), w->n));
}

/* What rounding of x and v leaves of a residual, in the same measure. */
static double em_residual_noise(const em_run_state *w) {
    const em_implicit *q = &w->stages;
    double noise[w->n];
    for (int k = 0; k < w->n; ++k) {
        noise[k] = 0.0;
        for (int l = 0; l < w->n; ++l) noise[k] += fabs(q->K[k * w->n + l] * w->y[l]) + fabs(q->D[k * w->n + l] * w->y[w->n + l]);
    }
    return fabs(w->h) * DBL_EPSILON * sqrt(em_mean(em_weighted_squares(w->n, noise, w->weight + w->n), w->n));
}

/* Whether changes are small because the stages are solved. They may also be small because the Jacobian is stiffer than
 * the motion at a stage, where stiffness has ended: then its residual does not decrease. */
EM_INLINE int em_trusts_slopes(const em_radau_iia *rk, const em_run_state *w, const double *residual, const double *before) {
    const double least = em_max(EM_ITERATION_TOLERANCE, em_residual_noise(w));
    for (int i = 0; i < rk->stages; ++i)
        if (residual[i] > em_max(least, EM_STAGNANT * before[i])) return 0;
    return 1;
}

/* Iterates to convergence; q->contraction <- the rate of convergence. */
EM_INLINE int em_iterate_stages_of(const em_radau_iia *rk, em_run_state *w, int stride) {
    em_implicit *q = &w->stages;
    const int most = em_most_iterations(rk);
    double change[EM_MOST_NODES * stride], residual[EM_MOST_NODES] = {0.0}, last[EM_MOST_NODES], before = 0.0, left = 1.0;
    q->contraction = 0.0;
    for (q->iterations = 1; q->iterations <= most; ++q->iterations) {
        memcpy(last, residual, sizeof last);
        if (em_stage_residuals(rk, w, stride)) return EM_NO_RATE;
        em_sizes_of_residuals(rk, w, residual);
        if (q->own) em_coupled_changes(rk, w, change);
        else em_shared_changes(rk, w, stride, change);
        const double size = em_take_changes(rk, w, stride, change);
        if (!isfinite(size)) return em_not_finite(w, w->argument, w->error), EM_NO_RATE;
        if (q->iterations > 1) {
            const double factor = before > 0.0 ? size / before : 0.0;
            if (factor > EM_STAGNANT && size <= em_stage_noise(w)) return EM_SOLVED;
            left = factor < 1.0 ? factor / (1.0 - factor) : INFINITY;
            q->contraction = factor;
            if (!(left * size * em_power(factor, most - q->iterations) <= EM_ITERATION_TOLERANCE)) return EM_NOT_SOLVED;
        }
        if (left * size <= EM_ITERATION_TOLERANCE) {
            if (q->own || em_trusts_slopes(rk, w, residual, last)) return EM_SOLVED;
            if (q->iterations > 1) return EM_NOT_SOLVED;
        }
        before = size;
    }
    return EM_NOT_SOLVED;
}

/* With the coefficients, and a small number of packs, as constants. */
EM_NOINLINE int em_iterate_stages(const em_radau_iia *rk, em_run_state *w) {
    const int small = w->stride == EM_PACK;
    if (rk->stages == EM_RADAU5_TABLEAU.stages)
        return small ? em_iterate_stages_of(&EM_RADAU5_TABLEAU, w, EM_PACK) : em_iterate_stages_of(&EM_RADAU5_TABLEAU, w, w->stride);
    return small ? em_iterate_stages_of(&EM_RADAU9_TABLEAU, w, EM_PACK) : em_iterate_stages_of(&EM_RADAU9_TABLEAU, w, w->stride);
}

#endif
