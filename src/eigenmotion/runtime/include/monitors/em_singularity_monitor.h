/* em_singularity_monitor.h: the singularity monitor: checks that steps resolve the motion near a singularity of the
 * coordinates, where they become short. There eta may be constant to all digits while v = L^-T eta grows without bound
 * within the tolerance on x, and no tolerance removes the rounding of a small pivot of M. The error of a step shows
 * neither. */
#ifndef EM_SINGULARITY_MONITOR_H
#define EM_SINGULARITY_MONITOR_H

#include "monitors/em_singularity_limits.h"
#include "stepper/em_error_norm.h"

#define EM_NEAR_START 300.0 /* within this many tolerances of the start, M must be resolved, or every step is checked */
#define EM_LOOSE 1e-5      /* rtol above which long steps are checked, too, because their error may be small by chance;
                              implicit steps are always checked, because they need not be short there */
#define EM_EXAMINED_PARTS 8         /* if a half of the step is not resolved, the number of parts that are examined */
#define EM_CROSSED 8.0     /* (x - a)^2 changes by a factor of 9 or more within one of the parts next to a */

/* D (n) of M = L D L^T, and the diagonal of M; 0 from the first pivot on that is not positive. No square roots. */
EM_INLINE void em_pivots_of(int n, double *M, double *pivots, double *diagonal) {
    double column[n];
    for (int k = 0; k < n; ++k) diagonal[k] = M[k * n + k], pivots[k] = 0.0;
    for (int k = 0; k < n && M[k * n + k] > 0.0; ++k) {
        const double inverse = 1.0 / (pivots[k] = M[k * n + k]);
        for (int i = k + 1; i < n; ++i) {
            column[i] = M[i * n + k];
            const double part = column[i] * inverse;
            for (int j = k + 1; j <= i; ++j) M[i * n + j] -= part * column[j];
        }
    }
}

/* The same of M at x; for small M by loops that unroll. */
static void em_monitored_pivots(const em_run_state *w, double t, const double *x, double *pivots, double *diagonal) {
    if (w->dynamics->pivots) {
        w->dynamics->pivots(t, x, w->run->prepared, pivots, diagonal);
        return;
    }
    double M[w->n * w->n];
    w->dynamics->factored(t, x, w->run->prepared, M);
    switch (w->n) {
        case 1: em_pivots_of(1, M, pivots, diagonal); break;
        case 2: em_pivots_of(2, M, pivots, diagonal); break;
        case 3: em_pivots_of(3, M, pivots, diagonal); break;
        case 4: em_pivots_of(4, M, pivots, diagonal); break;
        default: em_pivots_of(w->n, M, pivots, diagonal);
    }
}

/* The same at the start of the current step, usually known from the end of the step before. */
static void em_pivots_at_start(const em_run_state *w, double *pivots) {
    const size_t size = (size_t)w->n * sizeof *pivots;
    double diagonal[w->n];
    if (w->pivots_known && w->last_pivots_t == w->t && !memcmp(w->last_pivots_x, w->y, size))
        memcpy(pivots, w->last_pivots, size);
    else em_monitored_pivots(w, w->t, w->y, pivots, diagonal);
}

/* The same at its end. */
static void em_pivots_at_end(em_run_state *w, double *pivots, double *diagonal) {
    const size_t size = (size_t)w->n * sizeof *pivots;
    em_monitored_pivots(w, w->t_new, w->y_new, pivots, diagonal);
    w->pivots_known = 1;
    w->last_pivots_t = w->t_new;
    memcpy(w->last_pivots_x, w->y_new, size);
    memcpy(w->last_pivots, pivots, size);
}

/* The first coordinate whose pivot changes by more than allowed from `before` to `after`, or -1. */
static int em_first_unresolved_between(int n, const double *before, const double *after, double most) {
    for (int k = 0; k < n; ++k)
        if (!(after[k] * most >= before[k] && before[k] * most >= after[k] && after[k] > 0.0)) return k;
    return -1;
}

/* The first coordinate whose pivot changes by more than allowed from x to the midpoint or from there to x_new, or
 * -1; pivots and diagonal (n) <- at x_new. A passage through 0 between two of three points is visible in one of
 * them. */
static int em_first_unresolved_in_step(const em_run_state *w, double t, const double *x, double t_new,
                                       const double *x_new, double *pivots, double *diagonal) {
    double middle[w->n], before[2][w->n];
    for (int k = 0; k < w->n; ++k) middle[k] = 0.5 * (x[k] + x_new[k]);
    em_monitored_pivots(w, t, x, before[0], diagonal);
    em_monitored_pivots(w, 0.5 * (t + t_new), middle, before[1], diagonal);
    em_monitored_pivots(w, t_new, x_new, pivots, diagonal);
    const int first = em_first_unresolved_between(w->n, before[0], before[1], EM_RESOLVED);
    return first >= 0 ? first : em_first_unresolved_between(w->n, before[1], pivots, EM_RESOLVED);
}

/* x (n) at the fraction s of the current step, by the cubic through both ends. */
static void em_position_within_step(const em_run_state *w, double s, double *x) {
    const double r = 1.0 - s, h = w->h;
    for (int k = 0; k < w->n; ++k)
        x[k] = r * r * ((1.0 + 2.0 * s) * w->y[k] + s * h * w->K[0][k]) +
               s * s * ((1.0 + 2.0 * r) * w->y_new[k] - r * h * w->f_new[k]);
}

/* The first coordinate whose pivot changes by more than `most` within one of the equal parts of the step, or -1. */
static int em_first_unresolved_in_parts(em_run_state *w, int parts, double most) {
    double x[w->n], pivots[2][w->n], diagonal[w->n];
    em_pivots_at_start(w, pivots[0]);
    for (int j = 1; j < parts; ++j) {
        em_position_within_step(w, (double)j / parts, x);
        em_monitored_pivots(w, w->t + w->h * j / parts, x, pivots[j % 2], diagonal);
        const int first = em_first_unresolved_between(w->n, pivots[(j + 1) % 2], pivots[j % 2], most);
        if (first >= 0) return first;
    }
    em_pivots_at_end(w, pivots[parts % 2], diagonal);
    return em_first_unresolved_between(w->n, pivots[(parts + 1) % 2], pivots[parts % 2], most);
}

/* The first coordinate whose pivot has fewer correct digits, after rounding, than rtol requires, or -1. */
static int em_first_rounded_pivot(const em_run_state *w, const double *pivots, const double *diagonal) {
    for (int k = 0; k < w->n; ++k)
        if (!(pivots[k] * w->rtol > EM_PASSAGE_ERROR * DBL_EPSILON * diagonal[k])) return k;
    return -1;
}

EM_NOINLINE int em_measure_pivots(em_run_state *w) {
    double pivots[w->n], diagonal[w->n];
    int lost = em_first_unresolved_in_step(w, w->t, w->y, w->t_new, w->y_new, pivots, diagonal);
    if (lost < 0) lost = em_first_rounded_pivot(w, pivots, diagonal);
    return lost < 0 ? 0 : em_fail(&w->reason, EM_SINGULAR_MASS_MATRIX, lost, EM_NEARLY_SINGULAR, NAN);
}

EM_NOINLINE int em_measure_pivots_across(em_run_state *w) {
    if (em_first_unresolved_in_parts(w, 2, EM_RESOLVED) < 0) return 0;
    const int lost = em_first_unresolved_in_parts(w, EM_EXAMINED_PARTS, EM_CROSSED);
    return lost < 0 ? 0 : em_fail(&w->reason, EM_SINGULAR_MASS_MATRIX, lost, EM_NEARLY_SINGULAR, NAN);
}

/* Determines whether the start is near a singularity. If so every step is checked, because the first step is then
 * short and gives no scale. */
static void em_begin_singularity_monitor(em_run_state *w) {
    const double rate = sqrt(em_weighted_squares(w->n, w->K[0], w->weight));
    double ahead[w->n], behind[w->n], pivots[w->n], diagonal[w->n];
    for (int k = 0; k < w->n; ++k) {
        const double away = rate > 0.0 ? EM_NEAR_START / rate * w->K[0][k] : 0.0;
        ahead[k] = w->y[k] + away;
        behind[k] = w->y[k] - away;
    }
    w->starts_near = em_first_unresolved_in_step(w, w->t, behind, w->t, ahead, pivots, diagonal) >= 0;
}

/* Checks that the current step resolves the motion. 0, or -1 and w->reason. */
EM_INLINE int em_check_singularity(em_run_state *w) {
    if (fabs(w->h) < EM_CHECKED_STEP * w->longest_step || w->longest_step == 0.0 || w->retries || w->starts_near)
        return em_measure_pivots(w);
    return w->rtol > EM_LOOSE || w->scheme.radau_iia != NULL ? em_measure_pivots_across(w) : 0;
}

#endif
