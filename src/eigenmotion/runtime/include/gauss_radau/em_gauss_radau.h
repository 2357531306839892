/* em_gauss_radau.h: ra15, a collocation step of order 15: a polynomial through the rates at eight left Radau nodes,
 * which are all evaluated side by side.
 *
 * The method is of order 15 (Everhart 1985; Rein & Spiegel, MNRAS 446 (2015)). The rates at the nodes are found by
 * fixed point iteration, starting from the extrapolated polynomial of the step before. If the state is (x, v), x is
 * the double integral of the rates of v. Two errors are monitored: that of the iteration, by the decay of its
 * changes; and that of the polynomial, by the decay of its Legendre coefficients and by its difference from the rate
 * at the end of the step (em_nodes_judge). */
#ifndef EM_GAUSS_RADAU_H
#define EM_GAUSS_RADAU_H

#include "stepper/em_failure_location.h"
#include "gauss_radau/em_node_vectors.h"
#include "gauss_radau/em_node_rates.h"
#include "gauss_radau/em_legendre_series.h"
#include "gauss_radau/em_node_predictor.h"

enum {
    EM_LAST_ABORT = 4,      /* after this iteration, a step that is too long is not abandoned any more */
    EM_STEP_SIZE_ORDER = 13 /* after em_target_iterations the error is of the order 1 + 8 + 5 in the step size, or more */
};

#define EM_ERROR_UNPREDICTED 0.01 /* the error that controls the step size, if there was no predictor */
#define EM_RATE_ROUNDING (16.0 * DBL_EPSILON) /* a smaller relative change of a rate is rounding */
#define EM_ROUNDING_NORM 0.1      /* the error norm if the changes are rounding: it cannot become smaller */
#define EM_GOOD_PREDICTOR 1e3     /* in tolerances: the first change is below this if the predictor is good; */
#define EM_SLOW_CONTRACTION 0.25  /* later changes should then decrease by this factor, or faster */
#define EM_DIVERGES 3748.0        /* (2 * 0.9)^14: the error norm that halves the step */

/* The number of iterations that a step is designed for: more if they are cheaper. One fewer shows whether the
 * iteration converges slowly. */
EM_INLINE int em_target_iterations(const em_run_state *w) { return w->second_order ? 6 : 5; }

/* The error of the iteration that is allowed, in tolerances: it is small because one more iteration costs less than
 * the shorter steps that it saves. */
EM_INLINE double em_iteration_tolerance(const em_run_state *w) { return w->second_order ? 0.01 : 0.03; }

/* --- the iteration --- */

/* The weights of the rates of the state between its start and y_new, with velocities v_new: x by its tolerance, eta by
 * the v and, within the step, the x that follow from it. */
static void em_weigh_rates(em_run_state *w, const double *y_new, const double *v_new) {
    double *const weight = w->nodes.weight;
    const double h = w->h, *const restrict in_x = w->weight, *const restrict in_v = in_x + w->n;
    double *const restrict of_v = weight + w->n;
    em_set_weights_of(w, w->y, w->K[0], y_new, v_new);
    if (w->model->n_switches > 0 && em_is_relative(w)) em_weigh_rounding_of_motion(w, v_new);
    em_copy_packs(w->n, weight, w->weight);
    for (int k = 0; w->second_order && k < w->n; k += EM_PACK)
        for (int place = k; place < k + EM_PACK; ++place) {
            const double by_x = h * in_x[place], by_v = in_v[place];
            of_v[place] = sqrt(by_v * by_v + by_x * by_x);
        }
    for (int i = 0; !w->second_order && i < w->n; ++i) {
        double e[w->n], ev[w->n], sum = 0.0;
        memset(e, 0, sizeof e);
        e[i] = 1.0;
        em_velocity_error(w, e, ev);
        for (int k = 0; k < w->n; ++k) {
            const double by_x = w->h * w->weight[k], by_v = w->weight[w->n + k];
            sum += ev[k] * ev[k] * (by_v * by_v + by_x * by_x);
        }
        weight[w->n + i] = sqrt(sum);
    }
    const int counts = em_counts_factors(w);
    for (int k = 2 * w->n; k < w->n_state; ++k) weight[k] = counts ? w->weight[k] : 0.0;
}

/* The same without an absolute tolerance, to where the rates at the nodes lead: a number that starts from zero has a size
 * there. One that has none there either is weighed at the end of the step. */
static void em_weigh_rates_ahead(em_run_state *w) {
    em_nodes *const q = &w->nodes;
    const int n = w->n, end = em_rates_end(w);
    double y[w->width], v[w->width];
    memcpy(y, w->y, (size_t)w->n_state * sizeof *y);
    for (int k = w->first_rate; k < end; ++k) y[k] += w->h * em_integral_to_end(q->F, k);
    for (int k = 0; k < n; ++k) {
        if (w->second_order) y[k] += w->h * (w->K[0][k] + w->h * em_second_integral_to_end(q->F, n + k));
        v[k] = w->second_order ? y[n + k] : em_number_at(q->F, k, EM_NODE_COUNT - 1);
    }
    em_weigh_rates(w, y, v);
    for (int k = 0; k < end; ++k)
        if (q->weight[k] >= 1.0 / EM_LEAST_SIZE) q->weight[k] = 0.0, q->without_size = 1;
}

/* Y, F, a, series <- of the numbers of the state that are constant within the step. */
static void em_fill_constant_states(em_run_state *w) {
    em_nodes *q = &w->nodes;
    for (int b = 0; b < EM_NODE_VECTORS; ++b)
        for (int k = em_rates_end(w); k < w->n_state; ++k) {
            q->Y[b][k] = (em_node_vector){0.0} + w->y[k];
            q->F[b][k] = q->a[b][k] = q->series[b][k] = (em_node_vector){0.0};
        }
}

/* Y <- v by the integral of its rates, and x by the integral of v, for `rows` coordinates from k on. */
EM_INLINE void em_motion_states(em_run_state *w, int rows, int k) {
    em_nodes *q = &w->nodes;
    const double h = w->h;
    em_node_vector sum[EM_TOGETHER][2][EM_NODE_VECTORS] = {{{{0.0}}}};
    em_both_rows(rows, em_integral, em_integral_twice, q->a, w->n + k, sum);
    for (int r = 0; r < rows; ++r)
        for (int b = 0; b < EM_NODE_VECTORS; ++b) {
            const em_node_vector part = h * em_node_vector_at(em_node_place + b * EM_LANES);
            q->Y[b][w->n + k + r] = w->y[w->n + k + r] + h * sum[r][0][b];
            q->Y[b][k + r] = w->y[k + r] + (part * w->y[w->n + k + r] + h * h * sum[r][1][b]);
        }
}

/* Y <- the integrals of the rates. */
static void em_node_states(em_run_state *w) {
    em_nodes *q = &w->nodes;
    if (!w->second_order) {
        const int first = q->drifted ? w->n : 0; /* positions are already those of the last iteration's velocities */
        em_map(em_rates_end(w) - first, em_integral, q->a, first, w->y + first, w->h, q->Y, first);
        return;
    }
    int k = 0;
    for (; k + EM_TOGETHER <= w->n; k += EM_TOGETHER) em_motion_states(w, EM_TOGETHER, k);
    if (k < w->n) em_motion_states(w, 1, k);
}

/* The norm, in tolerances, of a quantity at the nodes, with the weights of the rates. */
EM_INLINE double em_over_nodes(em_run_state *w, em_term *term) {
    const em_tables at = em_tables_of(w);
    const int first = w->first_rate, end = em_rates_end(w);
    double sum = 0.0;
    for (int b = 0; b < EM_NODE_VECTORS; ++b) {
        const em_node_vector square = em_sum_of_squares(&at, b, first, end, term);
        sum += em_sum_of(square * em_node_vector_at(em_end_weight + b * EM_LANES));
    }
    return fabs(w->h) * sqrt(em_mean(sum, em_rates_count(w)));
}

/* a <- F. Returns the difference. */
EM_INLINE em_node_vector em_take_rate(const em_tables *at, int b, int k) {
    const em_node_vector rate = at->F[b][k], change = rate - at->a[b][k];
    at->a[b][k] = rate;
    return change * at->weight[k];
}

EM_INLINE em_node_vector em_weighted_rate(const em_tables *at, int b, int k) { return at->a[b][k] * at->weight[k]; }

EM_INLINE double em_take_rates(em_run_state *w) { return em_over_nodes(w, em_take_rate); }

/* The norm of the rates. */
EM_NOINLINE double em_rates_size(em_run_state *w) { return em_over_nodes(w, em_weighted_rate); }

/* -1 and w->reason: rates are not finite; the reason names the first coordinate at the first node. */
EM_COLD_PATH EM_NOINLINE int em_fail_nodes(em_run_state *w) {
    double y[w->width], dy[w->width];
    memset(y, 0, sizeof y), memset(dy, 0, sizeof dy);
    for (int i = 0; i < EM_NODE_COUNT; ++i) {
        for (int k = 0; k < w->n_state; ++k) y[k] = em_number_at(w->nodes.Y, k, i), dy[k] = em_number_at(w->nodes.F, k, i);
        if (!em_all_finite(w, y) || !em_all_finite(w, dy)) return em_not_finite(w, y, dy);
    }
    return em_not_finite(w, w->y, w->K[0]); /* all are finite, but their squares overflow */
}

/* One iteration; `weighs`: weights follow from its rates. Returns its change in tolerances, or NaN if it failed, and
 * w->reason. */
static double em_iterate(em_run_state *w, int weighs) {
    em_node_states(w);
    em_velocities_at_nodes(w);
    if (em_rates_at_nodes(w)) return NAN;
    if (weighs) em_weigh_rates_ahead(w);
    double change = em_take_rates(w);
    if (isfinite(change)) return change;
    if (w->nodes.on_lanes) { /* a lane failed: the scalar code finds out why */
        if (em_rates_one_by_one(w)) return NAN;
        if (weighs) em_weigh_rates_ahead(w);
        change = em_take_rates(w);
    }
    if (!isfinite(change)) em_fail_nodes(w);
    return change;
}

/* The estimated remaining error after an iteration with this change, if the one before changed the rates by
 * `before`. */
static double em_remaining_error(double change, double before) {
    return change < 0.9 * before ? change * change / (before - change) : change > 0.0 ? EM_DIVERGES : 0.0;
}

/* Iterates until the remaining error is small. *aimed <- the error after the number of iterations that a step is
 * designed for. Returns the remaining error; EM_DIVERGES if it does not converge; NaN if it failed; or the predicted
 * error, if the step turns out to be too long for its polynomial, which is then kept as the predictor of a shorter
 * one. */
static double em_solve_nodes(em_run_state *w, int most, double *aimed) {
    double first = 0.0, earlier = 0.0, before = 0.0, left = EM_DIVERGES, rounding = 0.0;
    const int target = em_target_iterations(w), relative = em_is_relative(w);
    *aimed = EM_DIVERGES;
    w->nodes.slow = 0;
    for (int k = 1; k <= most; ++k) {
        const double change = em_iterate(w, k == 1 && relative);
        if (!isfinite(change)) return NAN;
        if (k == 1) first = change;
        else left = em_remaining_error(change, before);
        if (k >= target - 1)
            w->nodes.slow = first < EM_GOOD_PREDICTOR && change > first * em_power(EM_SLOW_CONTRACTION, k - 1);
        if (k == target) *aimed = left;
        if (left < em_iteration_tolerance(w)) {
            if (k < target) *aimed = left * em_power(em_max(change / (before + DBL_MIN), 1e-3), target - k);
            return left;
        }
        if (k >= 2 && k <= EM_LAST_ABORT && left >= 1.0) {
            const double foreseen = em_predicted_error(w, change);
            if (foreseen >= 1.0) return em_find_series(w), em_keep_series(w), foreseen;
        }
        if (k == target) rounding = EM_RATE_ROUNDING * em_rates_size(w);
        if (k >= target && change <= rounding) return EM_ROUNDING_NORM;
        if (k > 2 && change > em_max(before, earlier)) return EM_DIVERGES; /* x and v may change alternately */
        earlier = before, before = change;
    }
    return EM_DIVERGES;
}

/* --- the step --- */

/* The norm that controls the step size. */
static double em_size_of_nodes(const em_run_state *w, double truncation) {
    return em_max(w->nodes.unpredicted ? EM_ERROR_UNPREDICTED : w->nodes.aimed, em_size_by_truncation(truncation));
}

/* y_new, the series of the rates, and the norm that controls the next size unless the end of the step changes it. */
static void em_finish_nodes(em_run_state *w) {
    em_nodes *q = &w->nodes;
    const double h = w->h;
    em_find_series(w);
    for (int k = w->first_rate; k < em_rates_end(w); ++k)
        w->y_new[k] = w->y[k] + h * em_number_at(q->series, k, 0); /* the integrals of the other terms vanish */
    for (int k = 0; w->second_order && k < w->n; ++k) {
        const double twice = em_number_at(q->series, w->n + k, 0) / 2.0 - em_number_at(q->series, w->n + k, 1) / 6.0;
        w->y_new[k] = w->y[k] + h * (w->y[w->n + k] + h * twice);
    }
    em_keep_series(w);
    w->size_norm = em_size_of_nodes(w, em_error_of_series(w, em_estimated_end_difference(w)));
}

/* w->error <- the change of the rates in a step that does not converge; its largest entry names the coordinate. */
EM_COLD_PATH EM_NOINLINE void em_record_changes(em_run_state *w) {
    double ev[w->n];
    memset(w->error, 0, (size_t)w->width * sizeof *w->error);
    for (int k = w->first_rate; k < 2 * w->n; ++k) w->error[k] = em_number_at(w->nodes.F, k, EM_NODE_COUNT - 1) - w->K[0][k];
    em_velocity_error(w, w->error + w->n, ev);
    memcpy(w->error + w->n, ev, sizeof ev);
}

static int em_nodes_step(em_run_state *w) {
    em_nodes *q = &w->nodes;
    const int most = em_predict(w);
    q->unpredicted = most == EM_MOST_AT_START; /* the number of iterations says nothing about the next step */
    q->converged = q->without_size = 0;
    em_weigh_rates(w, w->y, w->K[0]);
    em_fill_constant_states(w);
    em_begin_nodes(w);
    q->drifted = 0;
    const double left = em_solve_nodes(w, most, &q->aimed);
    w->end_rate = NULL;
    w->error_norm = em_min(left, EM_DIVERGES);
    w->size_norm = q->converged ? em_size_by_truncation(left) : w->error_norm;
    if (left != left) return -1;
    em_copy_state(w, w->y_new, w->y);
    if (left < 1.0) em_finish_nodes(w);
    else em_record_changes(w);
    return 0;
}

/* The error of a step whose end has been settled, with f_new there. 0, or -1 and w->reason. */
static int em_nodes_judge(em_run_state *w) {
    const double *f = w->f_new, usual = em_estimated_end_difference(w);
    if (w->mode_new != w->mode) {
        if (em_rhs(w, w->mode, w->t_new, w->y_raw, w->memory, w->K[1])) return -1;
        f = w->K[1];
    }
    if (w->nodes.without_size) em_weigh_rates(w, w->y_new, w->f_new), em_find_series(w);
    const double missed = em_end_difference(w, f), truncation = em_error_of_series(w, missed);
    w->error_norm = em_max(w->error_norm, truncation);
    w->stiff = w->nodes.slow && truncation < 1.0;
    if (!(truncation < 1.0)) em_record_changes(w);
    if (missed > usual) w->size_norm = em_size_of_nodes(w, truncation);
    return 0;
}

#endif
