/* em_legendre_series.h: the Legendre series of the rates within a step, and its error: from the decay of its
 * coefficients, and from its difference to the rate at the end of the step. */
#ifndef EM_LEGENDRE_SERIES_H
#define EM_LEGENDRE_SERIES_H

#include "gauss_radau/em_node_vectors.h"
#include "gauss_radau/em_node_predictor.h"
#include "stepper/em_error_norm.h"

#define EM_INTEGRAL_SHARE 0.03 /* ratio of the first missing term of a polynomial of rates to its integral within the
                                  step */
#define EM_MINOR_CHANGE 20.0 /* relative to the last coefficients: a smaller change no longer alters the polynomial
                                considerably */

static int em_rates_count(const em_run_state *w) { return w->second_order ? w->n : em_norm_count(w); }

EM_INLINE em_node_vector em_weighted_series(const em_tables *at, int b, int k) {
    return at->series[b][k] * at->weight[k];
}

/* Computes the series, and the size of each term. */
static void em_find_series(em_run_state *w) {
    em_nodes *const q = &w->nodes;
    em_node_vector squares[EM_NODE_VECTORS];
    const int first = w->first_rate, end = em_rates_end(w);
    em_map(end - first, em_series_of, q->a, first, NULL, 1.0, q->series, first);
    const em_tables at = em_tables_of(w);
    for (int b = 0; b < EM_NODE_VECTORS; ++b) squares[b] = em_sum_of_squares(&at, b, first, end, em_weighted_series);
    const double *const square = (const double *)squares;
    for (int l = 0; l < EM_NODE_COUNT; ++l) q->size[l] = sqrt(square[l]);
}

/* Marks the series as that of this step. */
static void em_keep_series(em_run_state *w) {
    em_nodes *const q = &w->nodes;
    q->t = w->t;
    q->t_new = w->t_new;
    q->h = w->h;
    q->mode = w->mode;
    q->converged = 1;
}

/* The error of the polynomial, by the sizes of its last two coefficients and of the two `before`, and their decay.
 * Pairs are used because a single coefficient may vanish by chance or by symmetry. */
static double em_truncation(em_run_state *w, double before, double last) {
    const double falls = em_min(1.0, last / (before + DBL_MIN));
    const double next = fabs(w->h) * last * falls / sqrt(em_rates_count(w));
    w->nodes.within = EM_INTEGRAL_SHARE * next;
    return next * falls * falls * sqrt(falls);
}

/* The norm that controls step sizes: the error to the power 12 / 16, with a safety factor. */
static double em_size_by_truncation(double truncation) {
    const double root = sqrt(truncation);
    return root * sqrt(root);
}

enum { EM_UPPER = EM_NODE_VECTORS / 2 }; /* the first node vector of the upper four of eight */

/* Coefficients of a row of the series, at the current iterate. */
EM_INLINE em_node_vector em_weighted_terms(const em_tables *at, int b, int k) {
    em_node_vector term = {0.0};
    EM_UNROLL
    for (int j = 0; j < EM_NODE_COUNT; ++j)
        term += em_node_vector_at(em_series_of[j] + b * EM_LANES) * em_number_at(at->a, k, j);
    return term * at->weight[k];
}

/* The predicted error of the polynomial to which the iteration converges, from its coefficients; 0 if the last change
 * may still alter it considerably. If the prediction is too large, the iteration is abandoned. */
static double em_predicted_error(em_run_state *w, double change) {
    double square[EM_NODE_COUNT] EM_ALIGNED = {0.0};
    const em_tables at = em_tables_of(w);
    const int first = w->first_rate, end = em_rates_end(w);
    for (int b = EM_UPPER; b < EM_NODE_VECTORS; ++b)
        *(em_node_vector *)(square + b * EM_LANES) = em_sum_of_squares(&at, b, first, end, em_weighted_terms);
    const double last = sqrt(square[6] + square[7]), counts = fabs(w->h) * last / sqrt(em_rates_count(w));
    return change < EM_MINOR_CHANGE * counts ? em_truncation(w, sqrt(square[4] + square[5]), last) : 0.0;
}

/* The difference between the polynomial and the rate f at the end of the step. */
static double em_end_difference(em_run_state *w, const double *f) {
    em_nodes *const q = &w->nodes;
    double missed = 0.0;
    for (int k = w->first_rate; k < em_rates_end(w); ++k) {
        em_node_vector end = {0.0};
        for (int b = 0; b < EM_NODE_VECTORS; ++b) end += q->series[b][k];
        q->miss[k] = f[k] - em_sum_of(end);
        const double miss = q->miss[k] * q->weight[k];
        missed += miss * miss;
    }
    return sqrt(missed);
}

/* The error of a polynomial with this difference at the end of the step. Only this difference shows a kink after the
 * last node; a kink at 0.64 of the step shows weakly in both estimates, which are therefore added. */
static double em_error_of_series(em_run_state *w, double missed) {
    const double *const size = w->nodes.size;
    const double before = sqrt(size[4] * size[4] + size[5] * size[5]), last = sqrt(size[6] * size[6] + size[7] * size[7]);
    return em_truncation(w, before, last + missed);
}

/* An estimate of that difference by the last coefficients, which a smooth polynomial hardly exceeds: it controls the
 * size before the difference is known. */
static double em_estimated_end_difference(const em_run_state *w) {
    const double *const size = w->nodes.size;
    return sqrt(size[6] * size[6] + size[7] * size[7]);
}

#endif
