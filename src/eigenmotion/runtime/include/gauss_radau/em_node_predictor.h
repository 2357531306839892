/* em_node_predictor.h: the predictor of ra15: rates at the nodes, extrapolated from the polynomial of the previous
 * step. */
#ifndef EM_NODE_PREDICTOR_H
#define EM_NODE_PREDICTOR_H

#include "gauss_radau/em_node_vectors.h"

enum {
    EM_MOST_ITERATIONS = 9,          /* iterations that a step may take, */
    EM_MOST_AT_START = 14 /* the same if no predictor is known */
};

/* The end of the numbers whose rates are computed: with the triangular root the eigenfactors are constant. */
EM_INLINE int em_rates_end(const em_run_state *w) { return w->mode == 1 ? 2 * w->n : w->n_state; }

/* P (8, 8) <- P_l(start + ratio z) at the nodes z, l first. */
EM_INLINE void em_legendre(double start, double ratio, double (*P)[EM_NODE_COUNT]) {
    for (int b = 0; b < EM_NODE_VECTORS; ++b) {
        const em_node_vector x = 2.0 * ratio * em_node_vector_at(em_node_place + b * EM_LANES) + (2.0 * start - 1.0);
        em_node_vector before = x - x + 1.0, here = x;
        EM_UNROLL
        for (int l = 0; l < EM_NODE_COUNT; ++l) {
            *(em_node_vector *)&P[l][b * EM_LANES] = before;
            const em_node_vector next = (2.0 * l + 3.0) / (l + 2.0) * x * here - (l + 1.0) / (l + 2.0) * before;
            before = here, here = next;
        }
    }
}

#define EM_GROWN 10.0 /* a series is not extrapolated with a last term above this multiple of its smallest term */

/* The number of terms of the series that are extrapolated beyond the previous step; P: the polynomials there. All of
 * them, unless they grow, as after steps with the largest allowed error; then those up to the smallest, as in any
 * asymptotic series. If stability limits the steps, all terms are used: slow convergence despite a good predictor is
 * then visible. */
static int em_terms_to_extrapolate(const em_run_state *w, double (*P)[EM_NODE_COUNT]) {
    if (w->nodes.slow) return EM_NODE_COUNT;
    double least = INFINITY, last = 0.0;
    int terms = EM_NODE_COUNT;
    for (int l = 1; l < EM_NODE_COUNT; ++l) {
        last = w->nodes.before_size[l] * fabs(P[l][EM_NODE_COUNT - 1]);
        if (last <= least) least = last, terms = l + 1;
    }
    return last > EM_GROWN * least ? terms : EM_NODE_COUNT;
}

/* a <- the polynomial of `series` at start + ratio nodes, in units of its step, shifted to begin with the current
 * rate. */
static void em_extrapolate_series(em_run_state *w, em_node_vector *const *series, double start, double ratio) {
    double P[EM_NODE_COUNT][EM_NODE_COUNT] EM_ALIGNED, jump[w->n_state];
    const int end = em_rates_end(w);
    em_legendre(start, ratio, P);
    const int terms = start > 0.0 ? em_terms_to_extrapolate(w, P) : EM_NODE_COUNT;
    if (terms < EM_NODE_COUNT) memset(P[terms], 0, (size_t)(EM_NODE_COUNT - terms) * sizeof *P);
    for (int k = w->first_rate; k < end; ++k) {
        jump[k] = w->K[0][k];
        for (int l = 0; l < EM_NODE_COUNT; ++l) jump[k] -= P[l][0] * em_number_at(series, k, l);
    }
    em_map(end - w->first_rate, (const double (*)[EM_NODE_COUNT])P, series, w->first_rate, jump + w->first_rate, 1.0,
           w->nodes.a, w->first_rate);
}

/* Keeps the series of the step before, once it has been accepted. */
static void em_remember(em_run_state *w) {
    em_nodes *q = &w->nodes;
    if (!q->converged || q->t_new != w->t || q->mode != w->mode) return;
    for (int b = 0; b < EM_NODE_VECTORS; ++b) memcpy(q->before[b], q->series[b], (size_t)w->n_state * sizeof *q->before[b]);
    memcpy(q->before_size, q->size, sizeof q->before_size);
    q->before_h = q->h;
    q->before_t_new = q->t_new;
    q->before_mode = q->mode;
    q->known = 1;
    q->converged = 0;
}

/* Predicts the rates. Returns the maximal number of iterations. */
static int em_predict(em_run_state *w) {
    em_nodes *q = &w->nodes;
    em_remember(w);
    if (q->converged && q->t == w->t && q->mode == w->mode)
        return em_extrapolate_series(w, q->series, 0.0, w->h / q->h), EM_MOST_ITERATIONS;
    if (q->known && q->before_t_new == w->t && q->before_mode == w->mode)
        return em_extrapolate_series(w, q->before, 1.0, w->h / q->before_h), EM_MOST_ITERATIONS;
    for (int b = 0; b < EM_NODE_VECTORS; ++b)
        for (int k = w->first_rate; k < w->n_state; ++k) q->a[b][k] = (em_node_vector){0.0} + w->K[0][k];
    return EM_MOST_AT_START;
}

#endif
