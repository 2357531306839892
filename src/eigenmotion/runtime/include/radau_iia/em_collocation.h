/* em_collocation.h: Radau IIA steps of the motion (x, v): stages, error, next step size and dense output.
 *
 * As in Hairer & Wanner, Solving Ordinary Differential Equations II, IV.8. The error is that of a solution of order
 * s, multiplied by (1 - h J / mu_0)^-1, so that stiff components that have decayed do not contribute. The Jacobian
 * is kept as long as the iteration converges well, and its factors as long as the step would grow only little; sizes
 * follow from two errors (Gustafsson 1994). States within the step are those of the collocation polynomial, which
 * have the same error. */
#ifndef EM_COLLOCATION_H
#define EM_COLLOCATION_H

#include "radau_iia/em_signal_averages.h"
#include "radau_iia/em_stages.h"

#define EM_GOOD_CONTRACTION 1e-3       /* above this contraction the Jacobian is recomputed */
#define EM_KEPT_SIZE_GROWTH 1.2        /* a step that would grow by less keeps its size */
#define EM_FAILED_ITERATION_FACTOR 0.5 /* factor of the step size if the iteration does not converge */
#define EM_SAFETY 0.9                  /* safety factor of em_size_ratio */
#define EM_LEAST_PREVIOUS_ERROR 1e-2   /* a smaller error is accidental */

enum { EM_COUPLED_STEPS = 16 }; /* steps with a Jacobian for each stage, before a shared Jacobian is tried again */

/* --- the initial guess of the accelerations --- */

/* The polynomial that is 1 at c_j and 0 at the other nodes. */
EM_INLINE double em_lagrange(const em_radau_iia *rk, int j, double theta) {
    double above = 1.0, below = 1.0;
    for (int l = 0; l < rk->stages; ++l)
        if (l != j) above *= theta - rk->c[l], below *= rk->c[j] - rk->c[l];
    return above / below;
}

/* a <- the polynomial through the last accelerations at start + ratio c_i, in units of their step. */
EM_INLINE void em_extend_last(const em_radau_iia *rk, em_run_state *w, double start, double ratio) {
    em_implicit *q = &w->stages;
    const int stride = w->stride;
    memset(q->a, 0, (size_t)(EM_MOST_NODES * stride) * sizeof *q->a);
    for (int i = 0; i < rk->stages; ++i)
        for (int j = 0; j < rk->stages; ++j) {
            const double share = em_lagrange(rk, j, start + ratio * rk->c[i]);
            for (int k = 0; k < stride; k += EM_PACK) {
                double *const a = q->a + i * stride + k;
                EM_PUT_PACK(a, EM_PACK_AT(a) + share * EM_PACK_AT(q->last + j * stride + k));
            }
        }
}

/* The stages by extrapolation of the last step or of a rejected attempt; or with the acceleration at the start. */
EM_INLINE void em_guess_stages(const em_radau_iia *rk, em_run_state *w) {
    em_implicit *q = &w->stages;
    if (q->known && w->t == q->t) em_extend_last(rk, w, 0.0, w->h / q->h);
    else if (q->known && w->t == q->t_new) em_extend_last(rk, w, 1.0, w->h / q->h);
    else
        for (int i = 0; i < rk->stages; ++i) em_copy_packs(w->n, q->a + i * w->stride, w->K[0] + w->n);
    em_stage_states(rk, w, w->stride);
    em_weigh_stages(rk, w);
}

/* --- their solution --- */

/* With a Jacobian shared by the stages, recomputed if the old one does not suffice. EM_SOLVED and so on. */
EM_INLINE int em_solve_shared(const em_radau_iia *rk, em_run_state *w) {
    em_implicit *q = &w->stages;
    for (int old = q->sloped && !q->outdated;; old = 0) {
        if (!old && em_take_slopes(w)) return EM_NO_RATE;
        old = old && !em_slopes_are_fresh(w);
        em_guess_stages(rk, w);
        const int found = em_factor_shared(rk, w) ? EM_NOT_SOLVED : em_iterate_stages(rk, w);
        if (found == EM_SOLVED || !old) return found;
    }
}

EM_INLINE int em_solve_coupled(const em_radau_iia *rk, em_run_state *w) {
    int singular = 0;
    em_guess_stages(rk, w);
    if (em_couple_stages(rk, w, &singular)) return EM_NO_RATE;
    return singular ? EM_NOT_SOLVED : em_iterate_stages(rk, w);
}

/* Tries the iterations in the order of their cost, but first the one that converged before. */
EM_INLINE int em_solve_stages(const em_radau_iia *rk, em_run_state *w) {
    em_implicit *q = &w->stages;
    if (q->own > 0) return em_solve_coupled(rk, w);
    const int found = em_solve_shared(rk, w);
    if (found == EM_SOLVED) return found;
    q->own = EM_COUPLED_STEPS;
    return em_solve_coupled(rk, w);
}

/* --- the error --- */

/* error (2 n) <- (1 - h J / mu_0)^-1 (h / mu_0 rate + h sum_i e_i rate_i), `rate` (2 n) at the start of the step. */
EM_INLINE void em_filtered_error(const em_radau_iia *rk, em_run_state *w, const double *rate, double *error) {
    em_implicit *q = &w->stages;
    const double sigma = rk->mu[0][0] / w->h;
    double raw[w->n];
    for (int k = 0; k < w->n; ++k) {
        double p = rate[k] / sigma, r = rate[w->n + k] / sigma;
        for (int i = 0; i < rk->stages; ++i) p += w->h * rk->e[i] * q->V[i * w->stride + k], r += w->h * rk->e[i] * q->a[i * w->stride + k];
        raw[k] = p;
        error[k] = sigma * (r + sigma * p);
    }
    for (int i = 0; i < w->n; ++i)
        for (int k = 0; k < w->n; ++k) error[i] -= sigma * q->D[i * w->n + k] * raw[k];
    em_lu_solve(w->n, q->G[0], q->pivot[0], error);
    for (int k = 0; k < w->n; ++k) error[w->n + k] = sigma * (error[k] - raw[k]);
}

/* 0, or -1 and w->reason. A large error at the start of a motion, or of a further attempt, is filtered again: it may
 * be of components that decay. */
EM_INLINE int em_estimate_stages(const em_radau_iia *rk, em_run_state *w) {
    em_implicit *q = &w->stages;
    double rate[w->width], shifted[2 * w->n + EM_PACK];
    em_copy_state(w, rate, w->K[0]);
    if (q->averaged && em_rate_of_stage(w, -1, w->t, w->y, w->y + w->n, rate)) return -1;
    em_filtered_error(rk, w, rate, w->error);
    w->error_norm = sqrt(em_weighted_squares(2 * w->n, w->error, w->weight) / (2 * w->n));
    if (w->error_norm < 1.0 || (q->accepted && !w->retries) || !isfinite(w->error_norm)) return 0;
    for (int k = 0; k < 2 * w->n; ++k) shifted[k] = w->y[k] + w->error[k];
    if (em_rate_of_stage(w, -1, w->t, shifted, shifted + w->n, rate)) return -1;
    em_filtered_error(rk, w, rate, w->error);
    w->error_norm = sqrt(em_weighted_squares(2 * w->n, w->error, w->weight) / (2 * w->n));
    return 0;
}

/* The norm that controls the next step: this error, also relative to the one before; a larger one if the iteration
 * took long; and one that keeps the size as long as Jacobian and factors can be reused. */
EM_INLINE double em_size_by(const em_radau_iia *rk, const em_run_state *w, double error) {
    const em_implicit *q = &w->stages;
    const int order = rk->stages + 1, most = em_most_iterations(rk);
    double size = error * em_power((2.0 * most + q->iterations) / (2.0 * most + 1.0), order);
    if (error < 1.0 && q->accepted)
        size = em_max(size, error * error / q->before_error * em_power(q->before_h / w->h, order));
    const double factor = EM_SAFETY * pow(size, -1.0 / order);
    return error < 1.0 && !q->outdated && !q->own && factor >= 1.0 && factor <= EM_KEPT_SIZE_GROWTH ? em_power(EM_SAFETY, order) : size;
}

/* --- the step --- */

/* Keeps the step before, once it has been accepted. */
static void em_remember_stages(em_run_state *w) {
    em_implicit *q = &w->stages;
    if (!q->known || q->t_new != w->t || w->retries) return;
    q->before_h = q->h;
    q->before_error = em_max(q->error, EM_LEAST_PREVIOUS_ERROR);
    q->accepted = 1;
    q->own -= q->own > 0;
}

/* Ends an attempt whose stages did not converge: the next one is shorter. */
static int em_fail_stages(const em_radau_iia *rk, em_run_state *w) {
    em_copy_state(w, w->y_new, w->y);
    w->error_norm = w->size_norm = pow(EM_SAFETY / EM_FAILED_ITERATION_FACTOR, rk->stages + 1);
    return 0;
}

/* y_new, the error and the norm for the next size. 0, or -1 and w->reason */
EM_INLINE int em_finish_stages(const em_radau_iia *rk, em_run_state *w) {
    em_implicit *q = &w->stages;
    em_copy_state(w, w->y_new, w->y);
    memcpy(w->y_new, q->X + (rk->stages - 1) * w->stride, (size_t)w->n * sizeof *q->X);
    memcpy(w->y_new + w->n, q->V + (rk->stages - 1) * w->stride, (size_t)w->n * sizeof *q->V);
    em_weigh_stages(rk, w);
    if (em_estimate_stages(rk, w)) return -1;
    q->outdated = q->contraction > EM_GOOD_CONTRACTION || (w->error_norm >= 1.0 && !em_slopes_are_fresh(w));
    w->size_norm = em_size_by(rk, w, em_max(w->error_norm, 1e-10));
    em_copy_packs(EM_MOST_NODES * w->stride, q->last, q->a);
    q->t = w->t, q->t_new = w->t_new, q->h = w->h;
    q->error = w->error_norm;
    q->known = 1;
    return 0;
}

/* With the coefficients as constants. */
EM_INLINE int em_collocation_step(const em_radau_iia *rk, em_run_state *w) {
    em_remember_stages(w);
    em_weigh_start(w);
    em_average_signals(rk, w);
    w->end_rate = NULL;
    const int found = em_solve_stages(rk, w);
    if (found == EM_NO_RATE) return -1;
    return found == EM_SOLVED ? em_finish_stages(rk, w) : em_fail_stages(rk, w);
}

static int em_radau5_step(em_run_state *w) { return em_collocation_step(&EM_RADAU5_TABLEAU, w); }
static int em_radau9_step(em_run_state *w) { return em_collocation_step(&EM_RADAU9_TABLEAU, w); }

/* --- the states within --- */

/* F <- the collocation polynomial's coefficients, by powers of theta. */
static int em_collocation_interpolate(em_run_state *w) {
    const em_radau_iia *const rk = w->scheme.radau_iia;
    const em_implicit *q = &w->stages;
    em_clear_interpolant(w);
    for (int j = 0; j < rk->stages; ++j)
        for (int i = 0; i < rk->stages; ++i)
            for (int k = 0; k < w->n; ++k) {
                w->F[1 + j][k] += rk->powers[j][i] * (q->X[i * w->stride + k] - w->y[k]);
                w->F[1 + j][w->n + k] += rk->powers[j][i] * (q->V[i * w->stride + k] - w->y[w->n + k]);
            }
    return 0;
}

static int em_collocation_sketch(em_run_state *w) { return em_collocation_interpolate(w), w->scheme.terms; }

static void em_collocation_evaluate(int n_state, const double *F, int terms, double theta, double *y) {
    memset(y, 0, (size_t)n_state * sizeof *y);
    for (int j = terms; j >= 0; --j)
        for (int k = 0; k < n_state; ++k) y[k] = y[k] * theta + F[j * n_state + k];
}

#endif
