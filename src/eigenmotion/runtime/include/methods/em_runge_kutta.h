/* em_runge_kutta.h: explicit Runge-Kutta methods: a step of a run, its error and its interpolant. */
#ifndef EM_RUNGE_KUTTA_H
#define EM_RUNGE_KUTTA_H

#include "stepper/em_error_norm.h"
#include "methods/em_explicit_stages.h"

/* The current step of a run. */
EM_INLINE em_explicit em_explicit_of(em_run_state *w) {
    w->plain = em_is_plain(w);
    return (em_explicit){w->width, w->width, 1, 2 * w->n, &w->t, &w->h, w->y, w->K[0], w->argument, w->y_new};
}

/* The root mean square of the error; with two estimates e_0, e_1: |h| e_0^2 / sqrt(e_0^2 + 0.01 e_1^2). */
EM_INLINE double em_error_norm(const em_tableau *rk, em_run_state *w) {
    em_set_weights_of(w, w->y, w->K[0], w->y_new, w->K[rk->velocity_stage]);
    if (w->model->n_switches > 0 && em_is_relative(w)) em_weigh_rounding_of_motion(w, w->K[rk->velocity_stage]);
    if (rk->errors == 0) return 0.0;
    const em_explicit s = em_explicit_of(w);
    double *const both[] = {w->y_raw, w->error}; /* y_raw is not used yet at this point */
    em_combine_rates(&s, rk->errors, rk->e, rk->stages, 0, rk->errors == 1 ? both + 1 : both);
    const double last = em_squares_of_error(w, w->error);
    if (rk->errors == 1) return fabs(w->h) * sqrt(em_mean(last, em_norm_count(w)));
    return em_error_of_two(w->h, em_squares_of_error(w, w->y_raw), last, em_norm_count(w));
}

EM_INLINE int em_rk_step(const em_tableau *rk, em_run_state *w) {
    const em_explicit s = em_explicit_of(w);
    if (em_explicit_step(rk, &s, 1, em_stage_rate, w)) return -1;
    w->end_rate = em_is_fsal(rk) ? w->K[rk->solution] : NULL;
    w->error_norm = w->size_norm = em_error_norm(rk, w);
    return 0;
}

/* Whether stability limits the step size (em_is_stiff): the last stage's state and the state at the end of the step. */
EM_INLINE int em_rk_judge(const em_tableau *rk, double stable, em_run_state *w) {
    if (w->run->n_steps % EM_STIFF_EVERY || w->mode_new != w->mode) return 0;
    const int last = rk->solution - 1;
    double state[2 * w->n], rate[2 * w->n];
    for (int k = 0; k < 2 * w->n; ++k) {
        state[k] = w->y_new[k] - w->argument[k];
        rate[k] = w->f_new[k] - w->K[last][k];
    }
    const double apart = em_weighted_squares(2 * w->n, state, w->weight), driven = em_weighted_squares(2 * w->n, rate, w->weight);
    w->stiff = em_is_stiff(em_stability_bound(stable, w->rtol), w->h, apart, driven);
    return 0;
}

/* --- the interpolant: F holds y, F_0, F_1, ... of em_butcher.h --- */

/* F_3 + i = h sum_j d_ij K_j */
EM_INLINE void em_corrections(const em_tableau *rk, em_run_state *w) {
    const int stages = rk->last_extra > 0 ? rk->last_extra + 1 : rk->stages;
    const em_explicit s = em_explicit_of(w);
    EM_UNROLL
    for (int i = 0; i < rk->corrections; ++i) {
        em_combine_rates(&s, 1, rk->d + i, stages, 0, &w->argument);
        for (int k = 0; k < w->n_state; ++k) w->F[4 + i][k] = w->h * w->argument[k];
    }
}

/* F_0 .. F_2: y, f at both ends. */
static void em_hermite(em_run_state *w, const double *y_end, const double *f_end) {
    memcpy(w->F[0], w->y, (size_t)w->n_state * sizeof *w->y);
    for (int k = 0; k < w->n_state; ++k) {
        const double delta = y_end[k] - w->y[k];
        w->F[1][k] = delta;
        w->F[2][k] = w->h * w->K[0][k] - delta;
        w->F[3][k] = 2.0 * delta - w->h * (w->K[0][k] + f_end[k]);
    }
}

/* f at the unsettled end of the step: the last stage, f_new, or one more evaluation. NULL and w->reason: it failed. */
EM_INLINE const double *em_raw_end(const em_tableau *rk, em_run_state *w) {
    double *const f_raw = w->K[rk->solution];
    if (em_is_fsal(rk)) return f_raw;
    if (!w->moved) em_copy_state(w, f_raw, w->f_new);
    else if (em_rhs(w, w->mode, w->t_new, w->y_raw, w->memory, f_raw)) return NULL;
    return f_raw;
}

EM_INLINE int em_rk_interpolate(const em_tableau *rk, em_run_state *w) {
    const double *f_raw = em_raw_end(rk, w);
    const em_explicit s = em_explicit_of(w);
    if (f_raw == NULL || em_stages(rk, &s, rk->solution + 1, rk->last_extra, em_stage_rate, w)) return -1;
    em_hermite(w, w->y_raw, f_raw);
    em_corrections(rk, w);
    return 0;
}

/* y (count) <- `count` numbers from F on of the interpolant at theta; its terms are n_state numbers apart. */
EM_INLINE void em_rk_evaluate_some(int count, int n_state, const double *restrict F, int terms, double theta, double *restrict y) {
    double sum[EM_PACK] = {0.0};
    for (int j = terms - 1; j >= 0; --j) {
        const double factor = j % 2 == 0 ? theta : 1.0 - theta, *const term = F + (1 + j) * n_state;
        for (int k = 0; k < count; ++k) sum[k] = (sum[k] + term[k]) * factor;
    }
    for (int k = 0; k < count; ++k) y[k] = sum[k] + F[k];
}

/* y <- the interpolant F (., n_state) at theta, by its first terms: 3 give the cubic. Sums stay in registers. */
static void em_rk_evaluate(int n_state, const double *F, int terms, double theta, double *y) {
    int k = 0;
    for (; k + EM_PACK <= n_state; k += EM_PACK) em_rk_evaluate_some(EM_PACK, n_state, F + k, terms, theta, y + k);
    for (; k + 2 <= n_state; k += 2) em_rk_evaluate_some(2, n_state, F + k, terms, theta, y + k);
    for (; k < n_state; ++k) em_rk_evaluate_some(1, n_state, F + k, terms, theta, y + k);
}

/* The interpolant without further stages: with the rate at the end, and with one within the step if the full one
 * would need more. */
EM_INLINE int em_rk_sketch(const em_tableau *rk, em_run_state *w) {
    const int stage = rk->last_extra > 0 ? rk->stages - 2 : 0;
    if (!em_is_fsal(rk) && w->mode_new != w->mode) return -1;
    if (em_is_fsal(rk)) em_hermite(w, w->y_raw, w->K[rk->solution]);
    else em_hermite(w, w->y_new, w->f_new);
    if (stage == 0) return em_corrections(rk, w), 3 + rk->corrections;
    const double c = rk->c[stage], unit = 2.0 * c * (1.0 - c) * (1.0 - 2.0 * c);
    for (int k = 0; k < w->n_state; ++k) {
        const double rate = w->F[1][k] + (1.0 - 2.0 * c) * w->F[2][k] + c * (2.0 - 3.0 * c) * w->F[3][k];
        w->F[4][k] = (w->h * w->K[stage][k] - rate) / unit;
    }
    return 4;
}

/* --- the method of a tableau (em_scheme) --- */

#define EM_RUNGE_KUTTA(name, tableau, judge)                                                             \
    static int em_##name##_step(em_run_state *w) { return em_rk_step(&tableau, w); }                          \
    static int em_##name##_interpolate(em_run_state *w) { return em_rk_interpolate(&tableau, w); }            \
    static int em_##name##_sketch(em_run_state *w) { return em_rk_sketch(&tableau, w); }                      \
    static em_scheme em_##name(void) {                                                                   \
        return (em_scheme){EM_RUNGE_KUTTA_CONTROL(tableau), 3 + tableau.corrections,                   \
                           tableau.errors == 0, em_##name##_step, judge,                                 \
                           em_##name##_interpolate, em_##name##_sketch, em_rk_evaluate, 0, 0, NULL, NULL, 0}; \
    }

#endif
