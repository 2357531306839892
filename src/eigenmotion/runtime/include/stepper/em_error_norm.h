/* em_error_norm.h: the error norm, in x and v for every formulation: the root mean square of e_k / (atol_k + rtol
 * max(|y_k| before, after)); eigenfactors contribute where nothing restores them. */
#ifndef EM_ERROR_NORM_H
#define EM_ERROR_NORM_H

#include "stepper/em_model_calls.h"

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

/* The weights of n numbers. Computed in packs, the last of which may extend beyond them. */
EM_INLINE void em_weigh(int n, const double *restrict atol, double rtol, const double *restrict before,
                        const double *restrict after, double *restrict weight) {
    for (int k = 0; k < n; k += EM_PACK)
        for (int place = k; place < k + EM_PACK; ++place)
            weight[place] = em_weight(atol[place], rtol, before[place], after[place]);
}

/* Weights of eigenfactors, which contribute where nothing settles them: C is of order one, s scales with itself. */
EM_NOINLINE void em_weigh_factors(em_run_state *w, const double *before, const double *after) {
    const int count[] = {w->dynamics->n_C, w->dynamics->n_s, w->dynamics->n_C_delta, w->dynamics->n_s_delta};
    for (int part = 0, k = 2 * w->n, end = k; part < 4; ++part)
        for (end += count[part]; k < end; ++k) {
            const double size = part % 2 == 0 ? 1.0 : em_max(fabs(before[k]), fabs(after[k]));
            w->weight[k] = 1.0 / (w->rtol * size + EM_LEAST_SIZE);
        }
}

/* Whether some number has no absolute tolerance. */
EM_INLINE int em_is_relative(const em_run_state *w) {
    int relative = 0;
    for (int k = 0; k < w->n; ++k) relative |= !(w->run->atol[k] > 0.0);
    return relative;
}

/* Whether errors of eigenfactors contribute: where they are integrated and nothing settles them. */
EM_INLINE int em_counts_factors(const em_run_state *w) {
    return w->n_state > 2 * w->n && (w->mode == 0 || (w->mode != EM_MOTION && !w->run->stabilise));
}

/* The weights of x and v (and, unless settled, of the eigenfactors) between two states and their right-hand sides. */
EM_INLINE void em_set_weights_of(em_run_state *w, const double *y, const double *dy, const double *y_new, const double *dy_new) {
    em_weigh(w->n, w->atol, w->rtol, y, y_new, w->weight);
    em_weigh(w->n, w->atol, w->rtol, dy, dy_new, w->weight + w->n); /* after x, over what its last pack has
                                                                       overwritten */
    if (em_counts_factors(w)) em_weigh_factors(w, y, y_new);
}

#define EM_MOTION_ROUNDING (1000.0 * DBL_EPSILON) /* the rounding of the motion as a whole, as a part of it */

/* v^T M v */
static double em_square_of_motion(int n, const double *M, const double *v) {
    double sum = 0.0;
    for (int k = 0; k < n * n; ++k) sum += M[k] * v[k / n] * v[k % n];
    return em_max(sum, 0.0);
}

/* Without an absolute tolerance the rounding of the motion as a whole, in the mass metric, takes its place: the solution
 * of linear equations spreads rounding to a coordinate that does not move. v_new (n): the velocities at the end of the
 * step. */
EM_COLD_PATH EM_NOINLINE void em_weigh_rounding_of_motion(em_run_state *w, const double *v_new) {
    double M[w->n * w->n], least[2 * w->n];
    em_mass_at(w->model, w->t, w->y, w->run->prepared, M);
    const double speed = sqrt(em_max(em_square_of_motion(w->n, M, w->K[0]), em_square_of_motion(w->n, M, v_new)));
    for (int k = 0; k < w->n; ++k) {
        least[w->n + k] = EM_MOTION_ROUNDING * speed / sqrt(M[k * w->n + k]);
        least[k] = fabs(w->h) * least[w->n + k];
    }
    for (int k = 0; k < 2 * w->n; ++k)
        if (least[k] * w->weight[k] > 1.0) w->weight[k] = 1.0 / least[k];
        else if (w->weight[k] >= 1.0 / EM_LEAST_SIZE) w->weight[k] = 0.0;
}

static void em_set_weights(em_run_state *w, const double *y, const double *dy, const double *y_new, const double *dy_new) {
    em_set_weights_of(w, y, dy, y_new, dy_new);
}

/* Weights of the state at the start. A number that is 0 without an absolute tolerance gives no scale. */
static void em_weigh_start(em_run_state *w) {
    em_set_weights(w, w->y, w->K[0], w->y, w->K[0]);
    for (int k = 0; k < w->n_state; ++k)
        if (w->weight[k] >= 1.0 / EM_LEAST_SIZE) w->weight[k] = 0.0;
}

/* The tolerance of number k of x and v at these weights; 0 where nothing gives a scale. */
EM_INLINE double em_tolerance_of(const em_run_state *w, int k) { return w->weight[k] > 0.0 ? 1.0 / w->weight[k] : 0.0; }

/* The weighted sum of squares of q (n_state): x, v and factors. */
EM_INLINE double em_squares(const em_run_state *w, const double *q) {
    double sum = em_weighted_squares(2 * w->n, q, w->weight);
    if (em_counts_factors(w)) sum += em_weighted_squares(w->n_state - 2 * w->n, q + 2 * w->n, w->weight + 2 * w->n);
    return sum;
}

/* The same for e, an error or a rate of the state, whose part of eta is replaced by the corresponding v. */
EM_INLINE double em_squares_of_error(const em_run_state *w, double *restrict e) {
    if (!em_is_velocity_error(w)) {
        em_velocity_error(w, e + w->n, w->spare);
        memcpy(e + w->n, w->spare, (size_t)w->n * sizeof *e);
    }
    return em_squares(w, e);
}

/* The number of terms in the norm. */
static int em_norm_count(const em_run_state *w) { return w->run->stabilise ? 2 * w->n : w->n_state; }

/* sum / count. If count is a power of two, the product with its inverse is exact, and the inverse is known before
 * the sum is. */
EM_INLINE double em_mean(double sum, int count) {
    const double inverse = 1.0 / count;
    return count & (count - 1) ? sum / count : sum * inverse;
}

#endif
