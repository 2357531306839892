/* em_record.h: recording of a run: rows, events and dense output. */
#ifndef EM_RECORD_H
#define EM_RECORD_H

#include "stepper/em_termination.h"
#include "stepper/em_tables.h"
#include "events/em_event_detection.h"

/* Appends a row at t, of the state y. */
static int em_append(em_run_state *w, em_rows *rows, int mode, double t, const double *y, const double *memory) {
    em_fault fault;
    double *row = em_rows_next(rows, &fault);
    if (row == NULL || em_publish(w->model, w->run, mode, t, y, memory, row, &fault)) return em_end_with(w, fault);
    em_rows_keep(rows, t);
    return EM_CONTINUE;
}

/* The same at t, within the current step or at its end. */
static int em_append_at(em_run_state *w, em_rows *rows, double t) {
    double memory[em_padded(w->n_memory)];
    if (t == w->t_new) return em_append(w, rows, w->mode_new, t, w->y_new, w->memory_new);
    if (em_settled_state_at(w, t, w->argument, memory)) return em_end_with(w, w->reason);
    return em_append(w, rows, w->mode, t, w->argument, memory);
}

/* Whether the next row of t_eval is due once the run has reached t. */
static int em_row_is_due(const em_run_state *w, double t) {
    const em_run *run = w->run;
    return w->next_t_eval < run->n_t_eval && w->direction * (run->t_eval[w->next_t_eval] - t) <= 0.0;
}

/* Appends the rows of this step up to t_stop. */
static int em_append_rows(em_run_state *w, double t_stop) {
    em_run *run = w->run;
    if (run->t_eval == NULL) return t_stop == w->t ? EM_CONTINUE : em_append_at(w, &run->rows, t_stop);
    while (em_row_is_due(w, t_stop)) {
        if (em_append_at(w, &run->rows, run->t_eval[w->next_t_eval++]) || em_poll(w)) return EM_END;
    }
    return EM_CONTINUE;
}

static int em_append_first_rows(em_run_state *w) {
    em_run *run = w->run;
    if (run->t_eval == NULL) return em_append(w, &run->rows, w->mode, w->t, w->y, w->memory);
    for (; em_row_is_due(w, w->t); ++w->next_t_eval)
        if (em_append(w, &run->rows, w->mode, run->t_eval[w->next_t_eval], w->y, w->memory)) return EM_END;
    return EM_CONTINUE;
}

/* Events that act within this many spacings of the time act at once. */
#define EM_SAME_TIME (8.0 * DBL_EPSILON)

/* Whether a crossing at t is recorded; stops: whether the step ends at t_stop. */
static int em_is_reached(const em_run_state *w, double t, double t_stop, int stops) {
    return !stops || t == t_stop || (w->acting && fabs(t - t_stop) <= EM_SAME_TIME * fabs(t_stop));
}

/* Records the crossings up to the first that is terminal or acts, whose time becomes *t_stop, and the others at that
 * time. */
static int em_append_crossings(em_run_state *w, double *t_stop, int *terminal) {
    em_crossing list[EM_MOST_FOUND * w->n_events];
    const int count = em_locate_crossings(w, list);
    int stops = 0;
    memset(w->fired, 0, (size_t)w->n_events * sizeof *w->fired);
    w->acting = 0;
    if (count < 0) return em_end_with(w, w->reason);
    for (int i = 0; i < count && em_is_reached(w, list[i].t, *t_stop, stops); ++i) {
        const int event = list[i].event, acts = em_event_acts(w, event);
        if (w->fired[event]) continue;
        if (!stops && (acts || w->run->event_terminal[event])) stops = 1, *t_stop = list[i].t;
        *terminal |= w->run->event_terminal[event];
        w->fired[event] = acts;
        w->acting |= acts;
        w->side[event] = -w->side[event];
        if (em_append_at(w, &w->run->events[event], stops ? *t_stop : list[i].t)) return EM_END;
    }
    return EM_CONTINUE;
}

/* Records an accepted step; *t_stop is the time of a terminal event that ends it. */
static int em_record(em_run_state *w, double *t_stop, int *terminal) {
    const em_dense_step kept = {w->t, w->h, w->mode, em_constraint_flags(w->run),
                                w->run->segments.count, w->run->method};
    em_fault fault;
    if (w->n_events > 0 && em_append_crossings(w, t_stop, terminal)) return EM_END;
    if (em_append_rows(w, *t_stop)) return EM_END;
    if (!w->run->dense || *t_stop == w->t) return EM_CONTINUE;
    return em_dense_keep(w->run, (size_t)w->n_state, kept, w->F[0], &fault) ? em_end_with(w, fault) : EM_CONTINUE;
}

#endif
