/* em_restart.h: restart after an event action (em_event_actions.h), from the state after it. */
#ifndef EM_RESTART_H
#define EM_RESTART_H

#include "loop/em_chart_change.h"

static int em_begin(em_run_state *w);

/* Whether rows may be dependent in some modes, because cones stick. */
static int em_may_share(const em_run_state *w) { return w->dynamics->cones && w->requested_least_norm != EM_REFUSED; }

/* run->least_norm <- for the current mode. 0, or -1 and w->reason. */
static int em_share_in_mode(em_run_state *w, const double *y) {
    const int m = w->n_rows;
    double B[em_some(m * w->n)], Delta[em_some(m * m)];
    if (!em_may_share(w) || w->base_least_norm) return 0;
    if (w->dynamics->rows(w->t, y, w->run->prepared, B, Delta, &w->reason)) return -1;
    w->run->least_norm = em_rank(m, Delta) < m ? EM_SHARED : EM_REFUSED;
    return 0;
}

/* Begins a segment at w->t in the mode c (n_prepared), if the mode has changed. 0, or -1 and w->reason. */
static int em_segment_begin(em_run_state *w, const double *c) {
    em_run *run = w->run;
    const size_t prepared = (size_t)w->model->n_prepared;
    if (w->model->n_switches == 0) return 0;
    if (run->segments.count > 0 && !memcmp(run->prepared, c, (size_t)w->model->n_parameters * sizeof *c)) return 0;
    run->segments.width = prepared + 1;
    double *const segment = em_rows_next(&run->segments, &w->reason);
    if (segment == NULL) return -1;
    memmove(segment, c, prepared * sizeof *c);
    segment[prepared] = (double)run->rows.count;
    run->prepared = segment;
    em_rows_keep(&run->segments, w->t);
    return 0;
}

/* row (n_state), published <- the state after the events w->fired at t; begins a segment. 0, or -1 and w->reason. */
static int em_apply_events(em_run_state *w, double t, double *row) {
    const em_run *run = w->run;
    double x[w->n], v[w->n], c[w->model->n_prepared + 1];
    memset(c, 0, sizeof c);
    memcpy(x, row, sizeof x);
    memcpy(c, run->prepared, (size_t)w->model->n_prepared * sizeof *c);
    if (w->dynamics->velocity(0, t, row, c, v, &w->reason)) return -1;
    em_signals(w, t);
    const em_act_limits within = {w->rtol, run->atol, w->rounding, &w->depth, w->rate_shift};
    const int least_norm = run->least_norm || em_may_share(w) ? EM_LEAST_NORM : 0;
    if (w->dynamics->act(t, x, v, c, w->u, least_norm, &within, w->fired, w->pile, &w->reason)) return -1;
    w->t = t;
    return em_segment_begin(w, c) || em_share_in_mode(w, x) || w->model->state(t, x, v, run->prepared, row, &w->reason) ? -1 : 0;
}

/* Finds the mode at the start of a run. 0, or -1 and w->reason. */
static int em_first_segment(em_run_state *w) {
    if (w->model->n_switches == 0) return 0;
    em_enter_interval(w);
    if (em_apply_events(w, w->t, w->y)) return -1;
    return w->run->least_norm && !w->base_least_norm ? em_keep_constraints_at_start(w) : 0;
}

/* Discards the history of earlier steps: it belongs to another motion. */
static void em_discard_history(em_run_state *w) {
    em_discard_steps(w);
    memset(w->longest, 0, (size_t)w->n_rows * sizeof *w->longest);
    memset(w->row_tolerance, 0, (size_t)w->n_rows * sizeof *w->row_tolerance);
    memset(w->zero, 0, (size_t)w->n_events * sizeof *w->zero);
    memset(w->noise, 0, (size_t)w->n_events * sizeof *w->noise);
    w->longest_step = w->strongest = w->farthest = w->fastest = w->energy_tolerance = w->last_error = 0.0;
    w->rank = w->near = w->run->kept = 0;
    w->next_energy_check = 0;
    w->new_segment = EM_NEXT_SEGMENT;
}

static int em_append_after(em_run_state *w) {
    em_run *run = w->run;
    for (int i = 0; i < w->n_events; ++i)
        if (w->acted[i] && em_append(w, &run->after[i], w->mode, w->t, w->y, w->memory)) return EM_END;
    return run->t_eval == NULL ? em_append(w, &run->rows, w->mode, w->t, w->y, w->memory) : EM_CONTINUE;
}

/* Ends the step at t, where events act, and begins the next segment. */
static int em_next_segment(em_run_state *w, double t, int terminal) {
    double row[w->n_state], memory[em_padded(w->n_memory)];
    em_run *run = w->run;
    em_fault fault;
    if (em_settled_state_at(w, t, w->argument, memory)) return em_end_with(w, w->reason);
    if (em_publish(w->model, run, w->mode, t, w->argument, memory, row, &fault)) return em_end_with(w, w->reason);
    ++run->n_steps;
    run->t_reached = t;
    memcpy(w->acted, w->fired, (size_t)w->n_events * sizeof *w->acted);
    if (em_apply_events(w, t, row)) return em_end_with(w, w->reason);
    em_discard_history(w);
    memcpy(w->y, row, sizeof row);
    if (run->least_norm && em_keep_constraints_at_start(w)) return em_end_with(w, w->reason);
    if (em_enter_mode(w) < 0) return em_end_with(w, w->reason);
    if (em_append_after(w)) return EM_END;
    if (terminal) return em_end(w, EM_TERMINAL_EVENT);
    return em_begin(w);
}
#endif
