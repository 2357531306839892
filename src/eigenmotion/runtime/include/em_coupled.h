/* em_coupled.h: the same with the slopes of each stage, s n numbers square.
 *
 * With slopes that stages share the iteration converges only where stiff directions turn by less than about
 * 1 / (h sqrt(k)) in a step, k the stiffness per mass: steps of a stiff link that swings would be no longer than
 * k^(-1/4), whatever the error (Lubich, BIT 33 (1993)). Slopes at the stages' own states know how they turn. */
#ifndef EM_COUPLED_H
#define EM_COUPLED_H

#include "em_shared.h"

/* Rows of the matrix: of stage i, with its slopes in K and D. */
static void em_put_rows(const em_radau_iia *rk, em_walk *w, int i) {
    em_implicit *q = &w->stages;
    const int s = rk->stages;
    for (int j = 0; j < s; ++j) {
        double twice = 0.0;
        for (int l = 0; l < s; ++l) twice += rk->a[i][l] * rk->a[l][j];
        const double by_x = w->h * w->h * twice, by_v = w->h * rk->a[i][j];
        for (int k = 0; k < N; ++k) {
            double *const row = q->coupled + ((i * N + k) * s + j) * N;
            for (int l = 0; l < N; ++l) row[l] = -by_x * q->K[k * N + l] - by_v * q->D[k * N + l];
            row[k] += i == j;
        }
    }
}

/* The matrix with slopes at the states that stages have at present, and its factors; K, D and G[0] <- of the last stage.
 * 0, or -1 and w->reason; *singular <- whether there are no factors */
static int em_couple_stages(const em_radau_iia *rk, em_walk *w, int *singular) {
    em_implicit *q = &w->stages;
    double unit[EM_MOST_NODES * N];
    q->sloped = 0;
    q->factored_h = 0.0;
    for (int i = 0; i < rk->stages; ++i) {
        const double t = w->t + rk->c[i] * w->h;
        memcpy(w->argument, q->X[i], sizeof q->X[i]);
        memcpy(w->argument + N, q->V[i], sizeof q->V[i]);
        if (N_INPUTS > 0) em_signals(w, t);
        if (em_acceleration_slopes(w, t, w->argument, q->K, q->D)) return -1;
        em_put_rows(rk, w, i);
    }
    em_stage_units(w, rk->stages, unit);
    ++w->run->n_factors;
    *singular = em_factor_real(rk, w) || em_lu(rk->stages * N, q->coupled, unit, q->coupled_pivot);
    return 0;
}

/* change (stages, n) of the accelerations that removes the residuals r */
static void em_coupled_changes(const em_radau_iia *rk, em_walk *w, double (*change)[N]) {
    memcpy(change, w->stages.r, (size_t)rk->stages * sizeof *change);
    em_lu_solve(rk->stages * N, w->stages.coupled, w->stages.coupled_pivot, change[0]);
}

#endif
