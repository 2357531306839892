/* em_table_lookups.h: the arguments at which a run evaluates its tables, the end of their ranges, and the joins that
 * they reach at known times. */
#ifndef EM_TABLE_LOOKUPS_H
#define EM_TABLE_LOOKUPS_H

#include "stepper/em_model_calls.h"
#include "stepper/em_time_events.h"
#include "tables/em_table_next_join.h"
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

/* --- joins at which the rates jump, as time events (em_time_events.h) ---
 *
 * Each argument that is linear in the time has two: the join that it reaches next, and the last that it has reached.
 * Steps end there, and see each side from that side alone. An argument that depends on the time in another way has
 * none: steps end at its joins as at those of a coordinate (em_table_joins.h). */

#define EM_OFF_A_LINE 1e-12 /* a function of the time that is off a line by less than this part is linear */

/* Whether the rates jump at joins of this argument, which depends on the time alone. */
static int em_jumps_in_time(const em_run_state *w, const em_table_use *use) {
    const double *const table = em_table_of_use(w->model, w->run->prepared, use);
    return use->timed && em_is_rough(use, table[10 + use->axis], EM_JUMPS_THERE);
}

/* The number of time events of tables. Fixed steps go their way. */
static int em_table_time_events(const em_run_state *w) {
    int count = 0;
    for (int k = 0; k < w->model->n_table_uses && !w->scheme.fixed; ++k)
        count += 2 * em_jumps_in_time(w, &w->model->table_uses[k]);
    return count;
}

/* The slope of an argument with values a (3) at times t (3), equally far apart; 0: it is no line. */
static double em_slope_of_line(const double *t, const double *a, int stride) {
    const double first = a[0], middle = a[stride], last = a[2 * stride], slope = (middle - first) / (t[1] - t[0]);
    const double off = fabs(last - (first + slope * (t[2] - t[0])));
    return isfinite(slope) && off <= EM_OFF_A_LINE * (fabs(first) + fabs(middle) + fabs(last)) ? slope : 0.0;
}

/* at (2, 3) <- the next join and the last one as time events, for an argument with the value `from` now. Those of the
 * time itself are exact. */
static void em_join_times(const em_run_state *w, const em_table_use *use, double from, double slope, double *at) {
    const double *const table = em_table_of_use(w->model, w->run->prepared, use);
    const em_axis axis = em_axis_of(table, use->axis);
    const int repeats = (em_outside)(int)table[1] == EM_REPEATS;
    const double way = w->direction * slope > 0.0 ? 1.0 : -1.0;
    const int is_time = slope == 1.0 && from == w->t && !repeats;
    const double here[3] = {w->t, 0.0, is_time ? EM_EXACT_TIME : 2.0 * fabs(from) / fabs(slope)};
    const double clear = from + way * 2.0 * fabs(slope) * em_time_event_slack(here, w->t);
    for (int k = 0; k < 2; ++k) {
        const double join = em_next_join(&axis, use, EM_JUMPS_THERE, repeats, clear, k == 0 ? way : -way);
        at[3 * k] = is_time ? join : w->t + (join - from) / slope, at[3 * k + 1] = 0.0;
        at[3 * k + 2] = is_time ? EM_EXACT_TIME : (fabs(from) + fabs(join)) / fabs(slope);
    }
}

/* at (em_table_time_events, 3) <- the time events of tables around w->t. */
static void em_find_table_time_events(em_run_state *w, double *at) {
    const em_model *const model = w->model;
    const int uses = model->n_table_uses;
    const double goal = isfinite(w->run->t_end) ? w->run->t_end : w->t_goal;
    const double step = goal != w->t && isfinite(goal) ? (goal - w->t) / 2.0 : w->direction * (1.0 + fabs(w->t));
    const double t[3] = {w->t, w->t + step, w->t + 2.0 * step};
    double a[3 * em_some(uses)], v[w->n];
    memset(v, 0, sizeof v);
    for (int k = 0; k < 3; ++k) model->table_arguments(t[k], w->y, v, w->run->prepared, w->u, a + k * uses);
    for (int k = 0; k < uses; ++k) {
        if (!em_jumps_in_time(w, &model->table_uses[k])) continue;
        const double slope = em_slope_of_line(t, a + k, uses);
        for (int i = 0; i < 6; ++i) at[i] = i % 3 == 0 ? INFINITY : 0.0;
        if (slope != 0.0) em_join_times(w, &model->table_uses[k], a[k], slope, at);
        at += 6;
    }
}

#endif
