/* em_step_size.h: the size of the first step; em_step_control.h has those of the others.
 *
 * Errors are measured in x and v. The first step depends on the tolerances and on how rates change, never on the
 * size of coordinates, which depends on the choice of origin. */
#ifndef EM_STEP_SIZE_H
#define EM_STEP_SIZE_H

#include "stepper/em_error_norm.h"

#define EM_PROBE_TOO_SHORT 1e-4 /* of the time scale of the motion: second differences over shorter times are rounding, */
#define EM_PROBE_TOO_LONG 0.5   /* and those over longer times belong to a different part of the motion */

/* The start of a motion, probed over a time h: d1, d2, norms of the first two derivatives of the state in
 * tolerances; V, A, sums of squares of xdot and its rate, both in tolerances of x; and the rate [1 / time] at which
 * the motion changes them, 0 if none is found. */
typedef struct em_start_probe {
    double h, d1, d2, V, A, rate;
} em_start_probe;

/* Root mean square, in tolerances, of a rate of the state (n_state). */
static double em_rate_norm(em_run_state *w, const double *rate) {
    em_copy_state(w, w->error, rate);
    return sqrt(em_mean(em_squares_of_error(w, w->error), em_norm_count(w)));
}

/* places, speeds <- sums of squares of the rates of x (and of eigenfactors that contribute) and of v, as they follow
 * from a rate of the state; both in tolerances of x, so that their ratio is a time squared. */
static void em_rate_squares(em_run_state *w, const double *rate, double *places, double *speeds) {
    em_copy_state(w, w->error, rate);
    em_velocity_error(w, rate + w->n, w->error + w->n);
    *places = em_weighted_squares(w->n, w->error, w->weight);
    if (em_counts_factors(w)) *places += em_weighted_squares(w->n_state - 2 * w->n, w->error + 2 * w->n, w->weight + 2 * w->n);
    *speeds = 0.0;
    for (int k = 0; k < w->n; ++k) {
        const double r = w->error[w->n + k] * (w->weight[k] > 0.0 ? w->weight[k] : w->weight[w->n + k]);
        *speeds += r * r;
    }
}

/* K[1], K[2] <- f at h / 2 and h (Kutta's method of third order). 0, or -1. */
static int em_probe_ahead(em_run_state *w, double h) {
    const double step = w->direction * h;
    for (int k = 0; k < w->width; ++k) w->argument[k] = w->y[k] + 0.5 * step * w->K[0][k];
    if (em_any_stage_rate(w, w->t + 0.5 * step, w->argument, w->K[1])) return -1;
    for (int k = 0; k < w->width; ++k) w->argument[k] = w->y[k] + step * (2.0 * w->K[1][k] - w->K[0][k]);
    if (em_any_stage_rate(w, w->t + step, w->argument, w->K[2])) return -1;
    return em_all_finite(w, w->K[1]) && em_all_finite(w, w->K[2]) ? 0 : -1;
}

/* The solution z of z^2 (a z + b) = c z + d, with no negative coefficient; if there is none, not a finite positive
 * number. */
static double em_balance(double a, double b, double c, double d) {
    double z = 1.0;
    for (int i = 0; i < 10; ++i) z = sqrt((c * z + d) / (a * z + b)); /* at least halves the error of log z */
    return z;
}

/* d2 and rate over `at->h`. With the sizes V, A, J, S of the first four derivatives of x, rate^2 is the ratio of (J,
 * S / rate) to (V, A / rate). At rest that is S / A, at the middle of an oscillation J / V, and at any phase of it
 * the square of its frequency. It does not contain |x|, which depends on the origin. 0, or -1. */
static int em_measure_rates(em_run_state *w, em_start_probe *at) {
    double J, S;
    const double h = at->h;
    at->d2 = at->rate = 0.0;
    if (em_probe_ahead(w, h)) return -1;
    for (int k = 0; k < w->width; ++k) {
        const double first = w->K[1][k] - w->K[0][k];
        w->K[2][k] = w->K[2][k] - w->K[1][k] - first;
        w->K[1][k] = first;
    }
    em_rate_squares(w, w->K[2], &J, &S);
    const double d2 = em_rate_norm(w, w->K[1]) * 2.0 / h;
    const double rate = J + S > 0.0 ? sqrt(em_balance(at->V, at->A * h * h, J, S * h * h)) / h : 0.0;
    if (!isfinite(rate) || !isfinite(d2)) return -1;
    at->d2 = d2, at->rate = rate;
    return 0;
}

/* The first probing time: long enough to move by far more than a tolerance, and by far less than the scale to which
 * rtol refers, at the given speed or from rest. */
static double em_first_probe(const em_run_state *w, const em_start_probe *at, double span) {
    const double far = 1.0 / sqrt(w->rtol), h = em_min(far / sqrt(at->V), sqrt(far / sqrt(at->A)));
    return h < span ? h : 0.01 * span;
}

/* The next probing time, after one of at->h that gave at->rate, or failed. */
static double em_next_probe(const em_start_probe *at, int failed, double span) {
    const double part = at->h * at->rate;
    if (failed) return 0.01 * at->h;
    if (part > EM_PROBE_TOO_LONG) return em_max(1e-4 * at->h, 0.1 * EM_PROBE_TOO_LONG / at->rate);
    if (part < EM_PROBE_TOO_SHORT) return em_max(at->h, em_min(em_min(1e3 * at->h, 0.01 / at->rate), span));
    return at->h;
}

/* Probes the start of the motion. Where speed and acceleration vanish to rounding, as where a force begins to exceed a
 * friction, every probing time is too long: the change is not small relative to the rates, and no rate is found. */
static em_start_probe em_estimate_first_rates(em_run_state *w, double span) {
    em_start_probe at = {.d1 = em_rate_norm(w, w->K[0])};
    em_rate_squares(w, w->K[0], &at.V, &at.A);
    const double first = em_first_probe(w, &at, span);
    double next = first;
    for (int probes = 0; probes < 3 && next != at.h; ++probes) {
        at.h = next;
        next = em_next_probe(&at, em_measure_rates(w, &at), span);
    }
    if (at.h * at.rate > EM_PROBE_TOO_LONG) at.rate = 0.0, at.h = 1e-4 * first;
    return at;
}

/* The size if a motion shows no rate, as in a fall: an effect that has not set in may do so later. After an impact
 * it may be soon: a step much longer than the time scale of damping would be too coarse for the flight. */
static double em_size_without_rate(const em_run_state *w, const em_start_probe *at, double span) {
    const double part = at->d1 * span > 1.0 ? 0.1 : at->d1 > 0.0 ? 1.0 : 0.01, size = em_min(100.0 * at->h, part * span);
    return w->new_segment == EM_NEXT_SEGMENT ? em_min(size, em_max(sqrt(at->V / at->A), 1.0 / at->d1)) : size;
}

/* The size of the first step, as in Hairer, Norsett & Wanner (II.4), but independent of the unit of time: a motion
 * of `size` tolerances that changes at a `rate` has an error of about size (rate h)^(order + 1) after a step h. */
static double em_first_size(em_run_state *w) {
    const double span = fabs(w->t_goal - w->t), longest = em_min(span, w->run->max_step);
    const em_start_probe at = em_estimate_first_rates(w, span);
    if (!(at.rate * at.h >= EM_PROBE_TOO_SHORT)) return em_min(em_size_without_rate(w, &at, span), longest);
    const double size = em_max(at.d1, at.d2 / at.rate) / at.rate, far = em_max(100.0 * at.h, 1.0 / at.rate);
    return em_min(em_min(pow(0.01 / size, 1.0 / (w->scheme.control.error_order + 1)) / at.rate, far), longest);
}

#endif
