/* em_node_interpolant.h: dense output of ra15: the integral of the polynomial through the rates at the nodes and at
 * the end of the step. The step itself does not use the rate at its end, which is computed afterwards. That rate
 * adds miss (P_7 + P_8) / 2 to the polynomial, which is zero at the nodes and has no integral over the step, so that
 * the end does not change. */
#ifndef EM_NODE_INTERPOLANT_H
#define EM_NODE_INTERPOLANT_H

#include "gauss_radau/em_node_predictor.h"

/* F <- y, then h times the coefficients of the rate on P_0 .. P_8. */
static int em_nodes_interpolate(em_run_state *w) {
    em_nodes *q = &w->nodes;
    const double h = w->h;
    em_clear_interpolant(w);
    for (int k = w->first_rate; k < w->n_state; ++k)
        for (int l = 0; l < EM_NODE_COUNT; ++l) w->F[1 + l][k] = h * em_number_at(q->series, k, l);
    for (int k = 0; w->second_order && k < w->n; ++k) {
        w->F[1][k] = h * (w->y[w->n + k] + 0.5 * w->F[1][w->n + k]);
        w->F[2][k] = 0.5 * h * w->F[1][w->n + k];
        for (int l = 1; l < EM_NODE_COUNT; ++l) {
            const double part = h * w->F[1 + l][w->n + k] / (2 * (2 * l + 1));
            w->F[2 + l][k] += part;
            w->F[l][k] -= part;
        }
    }
    for (int k = w->first_rate; k < em_rates_end(w); ++k) { /* positions that are double integrals have smaller
                                                               errors */
        w->F[EM_NODE_COUNT][k] += 0.5 * h * w->nodes.miss[k];
        w->F[EM_NODE_COUNT + 1][k] = 0.5 * h * w->nodes.miss[k];
    }
    return 0;
}

/* If a state within the step is requested, the step must be short enough for that, too: to order 10. */
static void em_nodes_within(em_run_state *w) {
    w->error_norm = em_max(w->error_norm, w->nodes.within);
    w->size_norm = em_max(w->size_norm, pow(w->nodes.within, (w->scheme.control.error_order + 1) / 10.0));
}

static int em_nodes_sketch(em_run_state *w) { return em_nodes_interpolate(w), w->scheme.terms; }

/* y <- F_0 + sum_l F_(l + 1) times the integral of P_l from 0 to theta. */
static void em_nodes_evaluate(int n_state, const double *F, int terms, double theta, double *y) {
    double P[EM_NODE_COUNT + 2], integral[EM_NODE_COUNT + 1];
    const double x = 2.0 * theta - 1.0;
    P[0] = 1.0, P[1] = x;
    EM_UNROLL /* the quotients are then constants, without divisions */
    for (int l = 2; l < EM_NODE_COUNT + 2; ++l) {
        const double before = (l - 1.0) / l, here = (2.0 * l - 1.0) / l;
        P[l] = here * (x * P[l - 1]) - before * P[l - 2];
    }
    integral[0] = theta;
    EM_UNROLL for (int l = 1; l < EM_NODE_COUNT + 1; ++l) integral[l] = (P[l + 1] - P[l - 1]) * (1.0 / (2 * (2 * l + 1)));
    memcpy(y, F, (size_t)n_state * sizeof *y);
    for (int l = 0; l < terms; ++l)
        for (int k = 0; k < n_state; ++k) y[k] += integral[l] * F[(1 + l) * n_state + k];
}

#endif
