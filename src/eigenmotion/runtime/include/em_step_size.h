/* em_step_size.h: how long the first step is, and how long the next.
 *
 * As in scipy.integrate (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.4), with the error
 * measured in x and v.
 */
#ifndef EM_STEP_SIZE_H
#define EM_STEP_SIZE_H

#include "em_norm.h"

/* By which the size of the next step differs: after an accepted step for its error and that of the one before
 * (Gustafsson, ACM Trans. Math. Softw. 17 (1991)), so that few are rejected; after a rejected one for its error alone.
 * A step that failed otherwise is quartered. */
static double em_size_factor(const em_walk *w, int failed) {
    const double safety = 0.9, least = 0.2, order = w->scheme.error_order + 1;
    if (failed) return 0.25;
    const double error = log(w->size_norm);
    const double wanted = error < 0.0 ? w->scheme.past * w->last_error - w->scheme.present * error : -error;
    return em_min(w->scheme.growth, em_max(least, safety * exp(wanted / order)));
}

#define EM_LEAST_ERROR -9.2 /* log 1e-4: a step by chance without error says nothing of the next */

/* Root mean square, in tolerances, of a vector (n_state) that is a state's rate, */
static double em_rate_norm(em_walk *w, const double *rate) {
    memcpy(w->error, rate, sizeof w->error);
    return sqrt(em_squares_of_error(w, w->error) / em_count(w));
}

/* and of the state itself. */
static double em_state_norm(em_walk *w) {
    memcpy(w->error, w->y, sizeof w->error);
    memcpy(w->error + N, w->K[0], N * sizeof *w->error);
    return sqrt(em_squares(w, w->error) / em_count(w));
}

/* |f(t + h, y + h f) - f| / h, the size of the second derivative; a fault on the way counts as none. */
static double em_second_derivative(em_walk *w, double h) {
    for (int k = 0; k < EM_WIDTH; ++k) w->argument[k] = w->y[k] + w->direction * h * w->K[0][k];
    if (em_rhs(w, w->mode, w->t + w->direction * h, w->argument, w->memory, w->K[1])) return 0.0;
    for (int k = 0; k < EM_WIDTH; ++k) w->K[2][k] = w->K[1][k] - w->K[0][k];
    const double norm = em_rate_norm(w, w->K[2]) / h;
    return isfinite(norm) ? norm : 0.0;
}

/* The first step's size, after Hairer, Norsett & Wanner, II.4, in whatever unit the time is: d0, d1, d2, the sizes of
 * the state and its derivatives in tolerances, tell the rate at which the motion varies, and a step h is off by about
 * d1 h (rate h)^p. A state smaller than its tolerance says as little as one of that size, and a span on which the motion
 * is less than a tolerance as little as a hundredth of it. */
static double em_first_size(em_walk *w) {
    const em_run *run = w->run;
    const double d0 = em_state_norm(w), d1 = em_rate_norm(w, w->K[0]);
    const double span = fabs(w->t_goal - w->t), order = w->scheme.error_order;
    const double h0 = d1 * span > 1.0 ? em_min(0.01 * em_max(d0, 1.0) / d1, span) : 0.01 * span;
    const double d2 = em_second_derivative(w, h0), slope = em_max(d1, d2 * h0);
    if (!(d2 > 0.0)) return em_min(h0, run->max_step); /* at rest: something may set in later */
    const double rate = em_max(sqrt(d2 / em_max(d0, 1.0)), d2 / slope);
    const double h1 = pow(0.01 * rate / slope, 1.0 / (order + 1)) / rate;
    return em_min(em_min(100.0 * h0, h1), em_min(span, run->max_step));
}

#endif
