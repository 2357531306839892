/* em_norm.h: how large an error is beside the tolerances, in x and v whatever the formulation carries: the root mean square
 * of e_k / (atol_k + rtol max(|y_k| before, after)), to which eigenfactors add where nothing settles them. */
#ifndef EM_NORM_H
#define EM_NORM_H

#include "em_walk.h"

/* sum_k (e_k weight_k)^2, in EM_PACK partial sums so that it is vectorised. */
EM_INLINE double em_weighted_squares(int n, const double *restrict e, const double *restrict weight) {
    double sum[EM_PACK] = {0.0}, rest = 0.0;
    int k = 0;
    for (; k + EM_PACK <= n; k += EM_PACK)
        for (int place = 0; place < EM_PACK; ++place) {
            const double r = e[k + place] * weight[k + place];
            sum[place] += r * r;
        }
    for (; k < n; ++k) rest += e[k] * weight[k] * (e[k] * weight[k]);
    return (sum[0] + sum[1]) + (sum[2] + sum[3]) + rest;
}

/* 1 / (atol + rtol max(|before|, |after|)); finite where both tolerances vanish. */
EM_INLINE void em_weigh(int n, const double *restrict atol, double rtol, const double *restrict before,
                        const double *restrict after, double *restrict weight) {
    for (int k = 0; k < n; ++k) {
        weight[k] = 1.0 / (atol[k] + rtol * em_max(fabs(before[k]), fabs(after[k])) + DBL_MIN);
    }
}

/* Eigenfactors, which count where nothing settles them: C is of size one, s scales with itself. */
static void em_weigh_factors(em_walk *w, const double *before, const double *after) {
    const int start[] = {2 * N, 2 * N + N_C, 2 * N + N_C + N_S, 2 * N + N_C + N_S + N_CD, N_STATE};
    for (int part = 0; part < 4; ++part)
        for (int k = start[part]; k < start[part + 1]; ++k) {
            const double size = part % 2 == 0 ? 1.0 : em_max(fabs(before[k]), fabs(after[k]));
            w->weight[k] = 1.0 / (w->rtol * size + DBL_MIN);
        }
}

/* Whether errors of eigenfactors count: where they are integrated and nothing settles them. */
static int em_counts_factors(const em_walk *w) { return w->mode == 0 || (w->mode != EM_MOTION && !w->run->stabilise); }

/* The weights of x and v (and, unless settled, of the eigenfactors) between two states and their right-hand sides. */
static void em_set_weights(em_walk *w, const double *y, const double *dy, const double *y_new, const double *dy_new) {
    em_weigh(N, w->run->atol, w->rtol, y, y_new, w->weight);
    em_weigh(N, w->run->atol, w->rtol, dy, dy_new, w->weight + N);
    if (em_counts_factors(w)) em_weigh_factors(w, y, y_new);
}

/* Weights of the state at the start; what is 0 and has no absolute tolerance says nothing of its size. */
static void em_weigh_start(em_walk *w) {
    em_set_weights(w, w->y, w->K[0], w->y, w->K[0]);
    for (int k = 0; k < N_STATE; ++k)
        if (w->weight[k] >= 1.0 / DBL_MIN) w->weight[k] = 0.0;
}

/* The weighted sum of squares of q (n_state): x, v and factors. */
static double em_squares(const em_walk *w, const double *q) {
    double sum = em_weighted_squares(2 * N, q, w->weight);
    if (em_counts_factors(w)) sum += em_weighted_squares(N_STATE - 2 * N, q + 2 * N, w->weight + 2 * N);
    return sum;
}

/* The same of e, an error or a rate of the state, whose part of eta becomes one of v in place. */
static double em_squares_of_error(const em_walk *w, double *restrict e) {
    double ev[N];
    em_velocity_error(w, e + N, ev);
    memcpy(e + N, ev, sizeof ev);
    return em_squares(w, e);
}

static double em_count(const em_walk *w) { return w->run->stabilise ? 2.0 * N : (double)N_STATE; }

#endif
