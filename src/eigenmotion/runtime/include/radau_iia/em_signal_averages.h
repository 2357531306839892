/* em_signal_averages.h: steps across samples of linear signals. Inside such a step each signal is a polynomial with
 * the value of the signal at the end, and with its integrals against all Legendre polynomials but the last. So the
 * step uses all samples, and no stage sees a kink. The error inside the step is estimated; if it is too large the
 * step ends at a sample. */
#ifndef EM_SIGNAL_AVERAGES_H
#define EM_SIGNAL_AVERAGES_H

#include "stepper/em_error_norm.h"

#define EM_SIGNAL_ERROR 0.5 /* the part of the tolerances allowed for this error */

/* The samples of a signal inside the step, in the order of the run, and its value between them. */
typedef struct em_inside_step {
    const em_signal *u;
    long first, count, stride;
    double t, h, start, end; /* of the step; the values at its ends */
} em_inside_step;

/* The position of sample k, as a fraction of the step; before the first it is the start, after the last the end. */
static double em_part_at(const em_inside_step *in, long k) {
    if (k < 0) return 0.0;
    return k < in->count ? (in->u->times[in->first + k * in->stride] - in->t) / in->h : 1.0;
}

static double em_value_at(const em_inside_step *in, long k) {
    if (k < 0) return in->start;
    return k < in->count ? in->u->values[in->first + k * in->stride] : in->end;
}

static em_inside_step em_samples_inside(const em_run_state *w, const em_signal *u) {
    const int forward = w->direction > 0.0;
    const long here = em_signal_interval(u, w->t, w->direction), there = em_signal_interval(u, w->t_new, -w->direction);
    const long first = forward ? here + 1 : here, beyond = forward ? there + 1 : there;
    const long count = u->kind == EM_LINEAR ? (forward ? beyond - first : first - beyond) : 0;
    return (em_inside_step){u, first, count > 0 ? count : 0, forward ? 1 : -1, w->t, w->h,
                            em_signal_at(u, em_signal_interval(u, w->t, w->direction), w->t),
                            em_signal_at(u, em_signal_interval(u, w->t_new, w->direction), w->t_new)};
}

/* P (count) <- Legendre's polynomials at theta in [0, 1] */
static void em_legendre_at(int count, double theta, double *P) {
    const double x = 2.0 * theta - 1.0;
    P[0] = 1.0, P[1] = x;
    for (int l = 2; l < count; ++l) P[l] = ((2 * l - 1) * x * P[l - 1] - (l - 1) * P[l - 2]) / l;
}

static double em_series_at(int count, const double *series, double theta) {
    double P[EM_MOST_NODES], sum = 0.0;
    em_legendre_at(count, theta, P);
    for (int l = 0; l < count; ++l) sum += series[l] * P[l];
    return sum;
}

/* sum (count) <- with the integrals of u P_l over the interval after sample k, by Gauss quadrature: exact up to l =
 * 4. */
static void em_add_interval(const em_inside_step *in, long k, int count, double *sum) {
    static const double place[] = {0.1127016653792583, 0.5, 0.8872983346207417}, share[] = {5.0 / 18, 4.0 / 9, 5.0 / 18};
    const double from = em_part_at(in, k), to = em_part_at(in, k + 1);
    const double before = em_value_at(in, k), after = em_value_at(in, k + 1);
    for (int j = 0; j < 3; ++j) {
        double P[EM_MOST_NODES];
        em_legendre_at(count, from + (to - from) * place[j], P);
        const double part = (to - from) * share[j] * (before + (after - before) * place[j]);
        for (int l = 0; l < count; ++l) sum[l] += part * P[l];
    }
}

/* series (count) <- the Legendre coefficients of the polynomial */
static void em_average(const em_inside_step *in, int count, double *series) {
    memset(series, 0, (size_t)count * sizeof *series);
    for (long k = -1; k < in->count; ++k) em_add_interval(in, k, count - 1, series);
    series[count - 1] = in->end;
    for (int l = 0; l < count - 1; ++l) {
        series[l] *= 2 * l + 1;
        series[count - 1] -= series[l];
    }
}

/* The largest integral, from the start of the step and relative to its length, of the difference of u and the
 * polynomial. */
static double em_signal_remainder(const em_inside_step *in, int count, const double *series) {
    double sum = 0.0, most = 0.0;
    for (long k = -1; k < in->count; ++k) {
        const double from = em_part_at(in, k), to = em_part_at(in, k + 1), middle = 0.5 * (from + to);
        const double polynomial = em_series_at(count, series, from) + 4.0 * em_series_at(count, series, middle) +
                                  em_series_at(count, series, to);
        sum += (to - from) * (0.5 * (em_value_at(in, k) + em_value_at(in, k + 1)) - polynomial / 6.0);
        most = em_max(most, fabs(sum));
    }
    return most;
}

/* The error of v inside the step that follows from this error of signal i, in tolerances. 0 if the rate does not
 * exist. */
static double em_signal_error(em_run_state *w, int i, double left_out) {
    double dy[w->width], off[w->n];
    em_signals(w, w->t);
    w->u[i] += left_out;
    if (em_motion_rate_here(w, w->t, w->y, dy)) return 0.0;
    for (int k = 0; k < w->n; ++k) off[k] = w->h * (dy[w->n + k] - w->K[0][w->n + k]);
    return sqrt(em_weighted_squares(w->n, off, w->weight + w->n) / (2 * w->n));
}

/* The values of signal i at the start and the stages. Returns their error. */
static double em_average_signal(const em_radau_iia *rk, em_run_state *w, int i) {
    double series[EM_MOST_NODES];
    const em_inside_step in = em_samples_inside(w, &w->run->inputs[i]);
    if (in.count == 0) {
        for (int j = -1; j < rk->stages; ++j) {
            em_signals(w, j < 0 ? w->t : w->t + rk->c[j] * w->h);
            w->stages.u[(1 + j) * w->n_inputs + i] = w->u[i];
        }
        return 0.0;
    }
    em_average(&in, rk->stages, series);
    for (int j = -1; j < rk->stages; ++j)
        w->stages.u[(1 + j) * w->n_inputs + i] = em_series_at(rk->stages, series, j < 0 ? 0.0 : rk->c[j]);
    w->stages.averaged = 1;
    return em_signal_error(w, i, em_signal_remainder(&in, rk->stages, series));
}

/* Ends the step at a sample: the middle one of the signal that has most. */
static void em_end_at_sample(em_run_state *w) {
    em_inside_step most = {NULL, 0, 0, 1, 0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < w->n_inputs; ++i) {
        const em_inside_step in = em_samples_inside(w, &w->run->inputs[i]);
        if (in.count > most.count) most = in;
    }
    w->t_new = most.u->times[most.first + (most.count - 1) / 2 * most.stride];
    w->h = w->t_new - w->t;
}

/* Computes the signals for the stages; shortens the step if they are too rough. */
static void em_average_signals(const em_radau_iia *rk, em_run_state *w) {
    for (double off = 1.0; w->n_inputs > 0 && off > EM_SIGNAL_ERROR;) {
        w->stages.averaged = 0;
        off = 0.0;
        for (int i = 0; i < w->n_inputs; ++i) off = em_max(off, em_average_signal(rk, w, i));
        if (off > EM_SIGNAL_ERROR) em_end_at_sample(w);
    }
}

#endif
