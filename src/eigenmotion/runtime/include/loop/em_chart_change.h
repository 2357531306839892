/* em_chart_change.h: change of the parameters of rotations between two steps (em_shadow_parameters.h).
 *
 * The step that makes parameters too large is accepted: its rows and its interpolant are in these parameters. The next
 * step starts from the same motion in their shadow set, with the same energy, events and step size. */
#ifndef EM_CHART_CHANGE_H
#define EM_CHART_CHANGE_H

#include "kinematics/em_shadow_parameters.h"
#include "stepper/em_smooth_intervals.h"
#include "loop/em_step.h"

/* Discards what earlier steps leave to the next: it belongs to another motion, or to other coordinates. */
static void em_discard_steps(em_run_state *w) {
    memset(&w->nodes, 0, offsetof(em_nodes, Y));
    memset(w->node_tables, 0, w->node_tables_size);
    memset(w->memory, 0, (size_t)w->n_memory * sizeof *w->memory);
    w->stages.known = w->stages.accepted = w->stages.sloped = w->stages.own = 0;
    w->c_is_known = w->pivots_known = w->has_interpolant = w->mode = 0;
}

/* Records the state before the change, or that after it; the latter also as a row, if every step has one. */
static int em_append_chart(em_run_state *w, int after) {
    em_run *const run = w->run;
    if (run->dense && em_append(w, &run->charts, w->mode, w->t, w->y, w->memory)) return EM_END;
    return after && run->t_eval == NULL ? em_append(w, &run->rows, w->mode, w->t, w->y, w->memory) : EM_CONTINUE;
}

/* g and its signs. A function of the parameters themselves may have another sign in the shadow set: that is no event. */
static int em_events_after_change(em_run_state *w) {
    double before[em_some(w->n_events)];
    memcpy(before, w->g, (size_t)w->n_events * sizeof *before);
    if (em_events_at(w, w->t, w->y, w->K[0], w->g)) return em_end_with(w, w->reason);
    for (int i = 0; i < w->n_events; ++i)
        if (before[i] * w->g[i] < 0.0 && em_side_of(w->g[i], w->noise[i]) != 0) w->side[i] = em_side_of(w->g[i], w->noise[i]);
    return EM_CONTINUE;
}

/* w->y <- the published state row (n_state), with its rate. Returns as a step. */
static int em_continue_at(em_run_state *w, const double *row) {
    em_discard_steps(w);
    memcpy(w->y, row, (size_t)w->n_state * sizeof *row);
    if (em_enter_mode(w) < 0) return em_end_with(w, w->reason);
    if (em_append_chart(w, 1)) return EM_END;
    if (em_rhs(w, w->mode, w->t, w->y, w->memory, w->K[0])) return em_end_with(w, w->reason);
    return w->n_events > 0 ? em_events_after_change(w) : EM_CONTINUE;
}

/* After a step, but not at the end of a run: changes the parameters that are too large; *changed: whether there are
 * any. Returns as a step. */
static int em_change_chart(em_run_state *w, int *changed) {
    double row[w->n_state], x[w->n], v[w->n];
    const double t = em_clock(w, w->t);
    memcpy(x, w->y, sizeof x);
    memcpy(v, w->K[0], sizeof v); /* xdot, in every mode */
    *changed = w->t != w->run->t_end && em_turn_to_shadow(w->model, x, v);
    if (!*changed) return EM_CONTINUE;
    if (em_append_chart(w, 0)) return EM_END;
    /* eigenfactors of blocks without such a rotation stay continuous with those in `row` */
    if (em_publish(w->model, w->run, w->mode, w->t, w->y, w->memory, row, &w->reason) ||
        w->model->state(t, x, v, w->run->prepared, row, &w->reason)) return em_end_with(w, w->reason);
    return em_continue_at(w, row);
}

#endif
