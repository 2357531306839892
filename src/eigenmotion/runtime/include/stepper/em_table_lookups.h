/* em_table_lookups.h: the arguments at which a run evaluates its tables, and the end of their ranges. */
#ifndef EM_TABLE_LOOKUPS_H
#define EM_TABLE_LOOKUPS_H

#include "stepper/em_model_calls.h"
#include "tables/em_table_ranges.h"

#define EM_END_OF_TABLE (64.0 * DBL_EPSILON) /* a run this close to it, relative to the argument, is at the end */

/* at (n_table_uses) <- the arguments at x, v and t. */
static void em_arguments_at(em_run_state *w, double t, const double *x, const double *v, double *at) {
    if (w->n_inputs > 0) em_signals(w, t);
    w->model->table_arguments(em_clock(w, t), x, v, w->run->prepared, w->u, at);
}

/* The same at a state y in a mode. 0, or -1: it has no velocities. */
static int em_table_arguments_of(em_run_state *w, int mode, double t, const double *y, double *at) {
    double v[w->n];
    em_fault none;
    if (em_xdot(w, mode, t, y, v, &none)) return -1;
    em_arguments_at(w, t, y, v, at);
    return 0;
}

/* Whether a state is outside of the range of a table; then w->reason names it. */
EM_COLD_PATH EM_UNUSED static int em_outside_table(em_run_state *w, double t, const double *y) {
    double at[em_some(w->model->n_table_uses)];
    if (w->model->n_tables == 0 || em_table_arguments_of(w, w->mode, t, y, at)) return 0;
    return em_outside_tables(w->model, w->run->prepared, at, &w->reason);
}

/* Whether an argument is at one end of the range of its table: within rounding, or within `slack` times its change to
 * `ahead`, which must not be closer to the inside. */
static int em_at_end_of_range(em_run_state *w, const em_table_use *use, int side, double at, double ahead, double slack) {
    const double beyond = em_table_excess(w->model, w->run->prepared, use, side, at);
    const double later = em_table_excess(w->model, w->run->prepared, use, side, ahead);
    return beyond >= -(EM_END_OF_TABLE * fabs(at) + slack * fabs(later - beyond)) && later >= beyond;
}

/* Whether the run is at the end of a table and about to leave it by this end. */
static int em_at_end_of_table(em_run_state *w, const double *at, const double *ahead, double slack) {
    for (int k = 0; k < w->model->n_table_uses; ++k) {
        const em_table_use *const use = &w->model->table_uses[k];
        if (!em_at_end_of_range(w, use, -1, at[k], ahead[k], slack) && !em_at_end_of_range(w, use, 1, at[k], ahead[k], slack))
            continue;
        return em_fail(&w->reason, EM_OUTSIDE_TABLE, use->table, -1, at[k]), 1;
    }
    return 0;
}

/* Whether the last attempt, which has failed, would have left a table. */
EM_COLD_PATH EM_NOINLINE int em_leaves_table(em_run_state *w, double slack) {
    const int n = w->n, uses = w->model->n_table_uses;
    double at[em_some(uses)], ahead[em_some(uses)], x[n], v[n];
    em_fault none;
    if (w->model->n_tables == 0 || em_xdot(w, w->mode, w->t, w->y, v, &none)) return 0;
    em_arguments_at(w, w->t, w->y, v, at);
    for (int k = 0; k < n; ++k) x[k] = w->y[k] + w->h * v[k];
    em_arguments_at(w, w->t + w->h, x, v, ahead);
    return em_at_end_of_table(w, at, ahead, slack);
}

#endif
