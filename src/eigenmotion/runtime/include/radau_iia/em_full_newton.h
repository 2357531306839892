/* em_full_newton.h: Newton's method for all stages together, with a Jacobian for each stage: s n unknowns.
 *
 * With a Jacobian shared by the stages the iteration converges only if stiff directions turn by less than about 1 /
 * (h sqrt(k)) in a step, k the stiffness per mass: steps of a stiff link that swings would be no longer than
 * k^(-1/4), whatever the error (Lubich, BIT 33 (1993)). Jacobians at the stages' own states account for that
 * rotation. */
#ifndef EM_FULL_NEWTON_H
#define EM_FULL_NEWTON_H

#include "radau_iia/em_simplified_newton.h"

/* Rows of the matrix for stage i, whose Jacobian is in K and D. */
static void em_put_rows(const em_radau_iia *rk, em_run_state *w, int i) {
    em_implicit *q = &w->stages;
    const int s = rk->stages;
    for (int j = 0; j < s; ++j) {
        double twice = 0.0;
        for (int l = 0; l < s; ++l) twice += rk->a[i][l] * rk->a[l][j];
        const double by_x = w->h * w->h * twice, by_v = w->h * rk->a[i][j];
        for (int k = 0; k < w->n; ++k) {
            double *const row = q->coupled + ((i * w->n + k) * s + j) * w->n;
            for (int l = 0; l < w->n; ++l) row[l] = -by_x * q->K[k * w->n + l] - by_v * q->D[k * w->n + l];
            row[k] += i == j;
        }
    }
}

/* The matrix with Jacobians at the current states of the stages, and its factors; K, D and G[0] <- of the last
 * stage. 0, or -1 and w->reason; *singular <- whether there are no factors */
static int em_couple_stages(const em_radau_iia *rk, em_run_state *w, int *singular) {
    em_implicit *q = &w->stages;
    double unit[EM_MOST_NODES * w->n];
    q->sloped = 0;
    q->factored_h = 0.0;
    for (int i = 0; i < rk->stages; ++i) {
        const double t = w->t + rk->c[i] * w->h;
        em_copy_packs(w->n, w->argument, q->X + i * w->stride);
        em_copy_packs(w->n, w->argument + w->n, q->V + i * w->stride);
        if (w->n_inputs > 0) em_signals(w, t);
        if (em_acceleration_slopes(w, t, w->argument, q->K, q->D)) return -1;
        em_put_rows(rk, w, i);
    }
    em_stage_units(w, rk->stages, unit);
    ++w->run->n_factors;
    *singular = em_factor_real(rk, w) || em_lu(rk->stages * w->n, q->coupled, unit, q->coupled_pivot);
    return 0;
}

/* change (stages, n) of the accelerations that removes the residuals r */
static void em_coupled_changes(const em_radau_iia *rk, em_run_state *w, double *change) {
    const int n = w->n, stages = rk->stages;
    double all[stages * n]; /* without the padding of rows */
    for (int i = 0; i < stages * n; ++i) all[i] = w->stages.r[i / n * w->stride + i % n];
    em_lu_solve(stages * n, w->stages.coupled, w->stages.coupled_pivot, all);
    memset(change, 0, (size_t)(stages * w->stride) * sizeof *change);
    for (int i = 0; i < stages * n; ++i) change[i / n * w->stride + i % n] = all[i];
}

#endif
