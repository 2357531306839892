/* em_node_rates.h: the rates at the nodes of a step: on lanes where the model has them, else one by one. */
#ifndef EM_NODE_RATES_H
#define EM_NODE_RATES_H

#include "gauss_radau/em_node_vectors.h"

/* F <- f at the nodes, one by one. 0, or -1 and w->reason. */
EM_NOINLINE int em_rates_one_by_one(em_run_state *w) {
    em_nodes *q = &w->nodes;
    double y[w->width], dy[w->width];
    memset(y, 0, sizeof y);
    for (int i = 0; i < EM_NODE_COUNT; ++i) {
        for (int k = 0; k < w->n_state; ++k) y[k] = em_number_at(q->Y, k, i);
        if (em_any_stage_rate(w, w->t + em_node_place[i] * w->h, y, dy)) return -1;
        for (int k = 0; k < w->n_state; ++k) em_put_at(q->F, k, i, dy[k]);
    }
    return 0;
}

/* Whether the model's lanes can be used: they are linked for the same machine, stages are not settled, and no
 * multipliers of least norm are needed. */
static int em_can_use_lanes(const em_run_state *w) {
    const int flags = em_constraint_flags(w->run), least_norm = (flags & EM_LEAST_NORM) && flags < EM_FIRST_KEPT;
    return w->lanes->width == EM_LANES && !least_norm && !(w->n_positions > 0 && w->near);
}

/* Data that are constant during the iteration of a step: times, signals, parameters. */
static void em_begin_nodes(em_run_state *w) {
    em_nodes *q = &w->nodes;
    q->on_lanes = em_can_use_lanes(w);
    for (int i = 0; q->on_lanes && i < EM_NODE_COUNT; ++i) {
        const int b = i / EM_LANES, lane = i % EM_LANES;
        const double t = w->t + em_node_place[i] * w->h;
        ((double *)&q->times[b])[lane] = em_clock(w, t);
        if (w->n_inputs > 0) em_signals(w, t);
        for (int k = 0; k < w->n_inputs; ++k) ((double *)&q->u[b][k])[lane] = w->u[k];
    }
    if (w->c_is_known) return;
    for (int k = 0; k < w->lanes->n_prepared; ++k) w->c[k] = (em_node_vector){0.0} + w->run->prepared[k];
    w->c_is_known = 1;
}

/* F <- f at the nodes; NaN at those that fail. 0, or -1 and w->reason. */
static int em_rates_at_nodes(em_run_state *w) {
    em_nodes *q = &w->nodes;
    if (!q->on_lanes) return em_rates_one_by_one(w);
    for (int b = 0; b < EM_NODE_VECTORS; ++b)
        w->lanes->rhs(w->mode, (double *)&q->times[b], (double *)q->Y[b], (double *)w->c, (double *)q->u[b],
                           em_constraint_flags(w->run), (double *)q->F[b]);
    w->run->n_rhs += EM_NODE_COUNT;
    return 0;
}

/* x of Y <- the integral of Y's velocities, before the forces are evaluated; velocities that depend on x use the
 * former x. */
static void em_positions_at_nodes(em_run_state *w) {
    em_nodes *q = &w->nodes;
    em_map(w->n, em_integral, q->a, 0, w->y, w->h, q->Y, 0);
    q->drifted = 1;
}

/* a <- the velocities at the nodes, and the positions that follow from them, if these are cheap. */
static void em_velocities_at_nodes(em_run_state *w) {
    em_nodes *q = &w->nodes;
    if (!q->on_lanes || w->mode != 0 || w->lanes->velocity == NULL) return;
    for (int b = 0; b < EM_NODE_VECTORS; ++b)
        w->lanes->velocity((double *)&q->times[b], (double *)q->Y[b], (double *)w->c, (double *)q->a[b]);
    em_positions_at_nodes(w);
}

#endif
