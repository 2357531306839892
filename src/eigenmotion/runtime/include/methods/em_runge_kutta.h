/* em_runge_kutta.h: explicit Runge-Kutta methods: a step, its error and its interpolant.
 *
 * EM_INLINE functions are inlined once for each method, with its tableau a constant. The loops over stages and
 * coefficients then unroll, zero coefficients vanish, and vector loops over the states remain. */
#ifndef EM_RUNGE_KUTTA_H
#define EM_RUNGE_KUTTA_H

#include "stepper/em_error_norm.h"
#include "tableaux/em_butcher.h"

/* out <- y, or 0, + h sum_j a_j K_j over j < n, with a constant. If the rates of K_(n - 1) are `fresh`, just written
 * one by one, a vector load would wait until all of them have reached the cache (store forwarding). They are then
 * read one by one, which volatile enforces. */
EM_INLINE void em_combine(const em_run_state *w, const double *restrict a, int n, int fresh, double h,
                          int from_zero, const double *restrict y, double *restrict out) {
    const int width = w->width;
    const double *const restrict K = w->K[0];
    const volatile double *const last = K + (n - 1) * width;
    const int motion = fresh ? 2 * w->n : 0;
    for (int k = 0; k < width; k += EM_PACK) {
        em_pack sum = {0.0};
        EM_UNROLL
        for (int j = 0; j < n; ++j) {
            if (a[j] == 0.0) continue;
            if (j == n - 1 && k < motion) sum += a[j] * (em_pack){last[k], last[k + 1], last[k + 2], last[k + 3]};
            else sum += a[j] * *(const em_pack *)&K[j * width + k];
        }
        *(em_pack *)(out + k) = (from_zero ? (em_pack){0.0} : EM_PACK_AT(y + k)) + h * sum;
    }
}

/* one <- sum_j a_j K_j and two <- sum_j b_j K_j over j < n, reading each number once. */
EM_INLINE void em_combine_both(const em_run_state *w, const double *restrict a, const double *restrict b, int n,
                               double *restrict one, double *restrict two) {
    const int width = w->width;
    const double *const restrict K = w->K[0];
    for (int k = 0; k < width; k += EM_PACK) {
        em_pack sum[2] = {{0.0}};
        EM_UNROLL
        for (int j = 0; j < n; ++j) {
            if (a[j] != 0.0) sum[0] += a[j] * EM_PACK_AT(K + j * width + k);
            if (b[j] != 0.0) sum[1] += b[j] * EM_PACK_AT(K + j * width + k);
        }
        EM_PUT_PACK(one + k, sum[0]);
        EM_PUT_PACK(two + k, sum[1]);
    }
}

/* K_first .. K_last; if stage `solution` is among them its argument is y_new. */
EM_INLINE int em_stages(const em_tableau *rk, em_run_state *w, int first, int last) {
    const int plain = em_is_plain(w);
    EM_UNROLL
    for (int i = first; i <= last; ++i) {
        double *argument = i == rk->solution ? w->y_new : w->argument;
        em_combine(w, rk->a[i], i, 1, w->h, 0, w->y, argument);
        if (em_stage_rate(w, plain, w->t + rk->c[i] * w->h, argument, w->K[i])) return -1;
    }
    return 0;
}

/* The root mean square of the error; with two estimates e_0, e_1: |h| e_0^2 / sqrt(e_0^2 + 0.01 e_1^2). */
EM_INLINE double em_error_norm(const em_tableau *rk, em_run_state *w) {
    em_set_weights_of(w, w->y, w->K[0], w->y_new, w->K[rk->velocity_stage]);
    if (rk->errors == 0) return 0.0;
    if (rk->errors == 1) {
        em_combine(w, rk->e[0], rk->stages, 0, 1.0, 1, w->y, w->error);
        return fabs(w->h) * sqrt(em_mean(em_squares_of_error(w, w->error), em_norm_count(w)));
    }
    double *const first = w->y_raw; /* not used yet at this point */
    em_combine_both(w, rk->e[0], rk->e[1], rk->stages, first, w->error);
    const double square = em_squares_of_error(w, first), denominator = square + 0.01 * em_squares_of_error(w, w->error);
    return denominator == 0.0 ? 0.0 : fabs(w->h) * square / sqrt(denominator * em_norm_count(w));
}

/* First same as last: the last stage is the rate at the end. */
EM_INLINE int em_is_fsal(const em_tableau *rk) { return rk->solution < rk->stages; }

EM_INLINE int em_rk_step(const em_tableau *rk, em_run_state *w) {
    if (em_stages(rk, w, 1, rk->stages - 1)) return -1;
    w->end_rate = em_is_fsal(rk) ? w->K[rk->solution] : NULL;
    if (!em_is_fsal(rk)) em_combine(w, rk->a[rk->solution], rk->stages, 1, w->h, 0, w->y, w->y_new);
    w->error_norm = w->size_norm = em_error_norm(rk, w);
    return 0;
}

/* Whether stability limits the step size (Hairer & Wanner, Solving Ordinary Differential Equations II, IV.2): the
 * last stage's state and the state at the end of the step give an estimate of the dominant eigenvalue; `stable`
 * bounds the stability region of the method. */
EM_INLINE int em_rk_judge(const em_tableau *rk, double stable, em_run_state *w) {
    if (w->run->n_steps % EM_STIFF_EVERY || w->mode_new != w->mode) return 0;
    const int last = em_is_fsal(rk) ? rk->solution - 1 : rk->stages - 1;
    double state[2 * w->n], rate[2 * w->n];
    for (int k = 0; k < 2 * w->n; ++k) {
        state[k] = w->y_new[k] - w->argument[k];
        rate[k] = w->f_new[k] - w->K[last][k];
    }
    const double apart = em_weighted_squares(2 * w->n, state, w->weight), driven = em_weighted_squares(2 * w->n, rate, w->weight);
    w->stiff = w->h * w->h * driven > stable * stable * apart;
    return 0;
}

/* --- the interpolant: F holds y, F_0, F_1, ... of em_butcher.h --- */

/* F_3 + i = h sum_j d_ij K_j */
EM_INLINE void em_corrections(const em_tableau *rk, em_run_state *w) {
    const int stages = rk->last_extra > 0 ? rk->last_extra + 1 : rk->stages;
    EM_UNROLL
    for (int i = 0; i < rk->corrections; ++i) {
        em_combine(w, rk->d[i], stages, 0, w->h, 1, w->y, w->argument);
        memcpy(w->F[4 + i], w->argument, (size_t)w->n_state * sizeof *w->argument);
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
    if (f_raw == NULL || em_stages(rk, w, rk->solution + 1, rk->last_extra)) return -1;
    em_hermite(w, w->y_raw, f_raw);
    em_corrections(rk, w);
    return 0;
}

/* y <- the interpolant F (., n_state) at theta, by its first terms: 3 give the cubic. */
static void em_rk_evaluate(int n_state, const double *F, int terms, double theta, double *y) {
    memset(y, 0, (size_t)n_state * sizeof *y);
    for (int j = terms - 1; j >= 0; --j) {
        const double factor = j % 2 == 0 ? theta : 1.0 - theta;
        for (int k = 0; k < n_state; ++k) y[k] = (y[k] + F[(1 + j) * n_state + k]) * factor;
    }
    for (int k = 0; k < n_state; ++k) y[k] += F[k];
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
        return (em_scheme){tableau.error_order, 0.7, 0.4, 4.0, 3 + tableau.corrections,                \
                           tableau.errors == 0, em_##name##_step, judge,                                 \
                           em_##name##_interpolate, em_##name##_sketch, em_rk_evaluate, 0, 0, NULL, NULL}; \
    }

#endif
