/* em_smooth_intervals.h: smooth intervals of a motion: between samples of signals, and between time events. */
#ifndef EM_SMOOTH_INTERVALS_H
#define EM_SMOOTH_INTERVALS_H

#include "stepper/em_model_calls.h"
#include "stepper/em_table_lookups.h"

#define EM_BLUR 1e-5 /* relative to the interval: evaluating the model at a time that is off by this part changes the
                        result by its square */

/* Whether the rounding of a time event at w->t, or before the end, is a considerable part of the interval, as for
 * exp(-t / 1e20) < 1. */
static int em_is_blurred(const em_run_state *w, int count, const double *at, double next) {
    const double goal = isfinite(w->run->t_end) ? w->run->t_end : w->t_goal;
    const double most = EM_BLUR * em_max(fabs(goal - w->run->t_start), 1e-3 * fabs(w->t));
    const double there = isfinite(next) ? em_time_event_reach(count, at, next) : 0.0;
    const int matters = w->direction * (next - goal) < there;
    return most > 0.0 && (em_time_event_reach(count, at, w->t) > most || (matters && there > most));
}

/* Enters the interval between time events after w->t. Returns whether w->t is a time event, or -1 and w->reason. */
static int em_enter_time_event(em_run_state *w) {
    const int own = w->model->n_time_events, count = own + em_table_time_events(w);
    double at[em_some(3 * count)];
    w->between = count > 0;
    if (count == 0) return 0;
    if (own > 0) w->model->time_events(w->run->prepared, at);
    if (count > own) em_find_table_time_events(w, at + 3 * own);
    for (int i = 0; i < own; ++i)
        if (em_time_event_is_blurred(at + 3 * i, w->t))
            return w->crosses = em_fail(&w->reason, EM_STEP_SIZE_UNDERFLOW, -1, -1, fabs(at[3 * i + 1]));
    const double next = em_next_time_event(count, at, w->t, w->direction);
    if (em_is_blurred(w, count, at, next)) return w->crosses = em_fail(&w->reason, EM_STEP_SIZE_UNDERFLOW, -1, -1, 0.0);
    if (w->direction * (next - w->pieces_end) < 0.0) w->pieces_end = next;
    return w->crosses = em_time_event_sides(count, at, w->t, next, w->direction, w->inside);
}

/* Enters the intervals of all signals after w->t. Returns whether a signal jumps there, so that f does too, or the
 * status that ends the run. */
static int em_enter_interval(em_run_state *w) {
    int jumps = 0;
    w->pieces_end = w->direction * INFINITY;
    for (int i = 0; i < w->n_inputs; ++i) {
        const em_signal *u = &w->run->inputs[i];
        if (u->kind == EM_CONSTANT) continue;
        w->piece[i] = em_signal_interval(u, w->t, w->direction);
        const double end = em_signal_end(u, w->piece[i], w->direction, w->scheme.averages);
        if (w->direction * (end - w->pieces_end) < 0.0) w->pieces_end = end;
        jumps |= u->kind == EM_HOLD;
    }
    return em_enter_time_event(w) | jumps;
}

#endif
