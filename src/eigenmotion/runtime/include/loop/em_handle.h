/* em_handle.h: the functions of em_model that open, advance, save and close a run; em_control.h is their public
 * interface. */
#ifndef EM_HANDLE_H
#define EM_HANDLE_H

#include "loop/em_stepper.h"

/* The number of prepared parameters that encode the mode of a run: all of them, if events change it. */
static size_t em_saved_prepared(const em_model *model) { return model->n_switches > 0 ? (size_t)model->n_prepared : 0; }

/* The counts and the mode of a run: the part of it that is saved after the blocks of its run state. */
typedef struct em_run_counts {
    int kept, least_norm;
    long n_rhs, n_steps, n_rejected, n_bounded, n_stiff;
    double t_reached;
} em_run_counts;

/* em_model.open */
EM_EXPORT void *em_handle_open(const em_model *model, em_run *run) { return em_open(model, run); }

/* em_model.close */
EM_EXPORT void em_handle_close(void *run_state) { em_close(run_state); }

/* em_model.again: resets counts and tables, whose memory is kept, to those of a run that has not started. */
EM_EXPORT int em_handle_again(void *run_state) {
    em_run_state *w = run_state;
    em_run *run = w->run;
    em_run_state_free(w);
    w->end_rate = NULL;
    w->c_is_known = 0;
    em_run_state_prepare(w);
    run->kept = 0;
    run->n_rhs = run->n_steps = run->n_rejected = run->n_bounded = run->n_jacobians = run->n_factors = run->n_stiff = 0;
    run->rows.count = run->charts.count = run->last.count = run->segments.count = 0;
    for (int i = 0; i < w->n_events; ++i) run->events[i].count = run->after[i].count = 0;
    run->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    w->refused = w->ended = em_enter(w);
    return (int)run->fault.status;
}

/* Reverses the direction of time. The intervals of signals are then entered from their other ends. */
static void em_reverse_time(em_run_state *w) {
    w->direction = -w->direction;
    w->stale |= em_enter_interval(w);
}

/* em_model.advance: steps to t, after inputs may have jumped. A fault of an earlier advance has no effect: the run
 * continues from where it stopped. */
EM_EXPORT int em_handle_advance(void *run_state, double t, int jumped) {
    em_run_state *w = run_state;
    em_run *run = w->run;
    if (w->refused) return EM_END;
    run->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    w->ended = EM_CONTINUE;
    w->most_steps = run->n_steps + run->max_steps;
    w->stale |= jumped && w->begun;
    if (w->direction * (t - w->t) < 0.0) em_reverse_time(w);
    if (w->stale && w->t != t) {
        if (em_resume(w)) return EM_END;
        if (!em_all_finite(w, w->K[0])) return em_not_finite(w, w->y, w->K[0]), em_end_with(w, w->reason);
        w->stale = 0;
    }
    return em_advance(w, t);
}

/* em_model.now */
EM_EXPORT double em_handle_now(const void *run_state, double *x, double *v) {
    const em_run_state *w = run_state;
    em_fault fault;
    memcpy(x, w->y, (size_t)w->n * sizeof *x);
    if (w->begun && !w->stale) memcpy(v, w->K[0], (size_t)w->n * sizeof *v);
    else if (em_xdot(w, w->mode, w->t, w->y, v, &fault))
        for (int k = 0; k < w->n; ++k) v[k] = NAN;
    return w->t;
}

/* em_model.publish */
EM_EXPORT int em_handle_publish(const void *run_state, double *y, em_fault *fault) {
    const em_run_state *w = run_state;
    return em_publish(w->model, w->run, w->mode, w->t, w->y, w->memory, y, fault);
}

/* em_model.saved */
EM_EXPORT size_t em_handle_saved(const em_model *model) {
    return em_saved_size(model) + sizeof(em_run_counts) + em_saved_prepared(model) * sizeof(double);
}

/* em_model.save */
EM_EXPORT void em_handle_save(const void *run_state, void *saved) {
    em_run_state *const w = (em_run_state *)run_state; /* which is only read */
    const em_run *run = w->run;
    em_memory_block piece[EM_PIECES];
    em_run_counts tally;
    char *to = saved;
    memset(&tally, 0, sizeof tally); /* the padding too, so that the same motion gives the same bytes */
    tally.kept = run->kept, tally.least_norm = run->least_norm, tally.n_rhs = run->n_rhs, tally.n_steps = run->n_steps, tally.n_rejected = run->n_rejected;
    tally.n_bounded = run->n_bounded, tally.n_stiff = run->n_stiff, tally.t_reached = run->t_reached;
    em_saved_blocks(w, piece);
    for (int i = 0; i < EM_PIECES; to += piece[i].size, ++i) memcpy(to, piece[i].at, piece[i].size);
    memcpy(to, &tally, sizeof tally), to += sizeof tally;
    memcpy(to, run->prepared, em_saved_prepared(w->model) * sizeof(double)), to += em_saved_prepared(w->model) * sizeof(double);
    memset(to, 0, em_handle_saved(w->model) - (size_t)(to - (char *)saved)); /* of tables that the method does not have */
}

/* em_model.restore */
EM_EXPORT void em_handle_restore(void *run_state, const void *saved) {
    em_run_state *w = run_state;
    em_run *run = w->run;
    em_memory_block piece[EM_PIECES];
    em_run_counts tally;
    const char *from = saved;
    em_saved_blocks(w, piece);
    for (int i = 0; i < EM_PIECES; from += piece[i].size, ++i) memcpy(piece[i].at, from, piece[i].size);
    memcpy(&tally, from, sizeof tally);
    if (em_saved_prepared(w->model) > 0) { /* in a table of one row, where steppers keep their current mode */
        memcpy(run->segments.y, from + sizeof tally, em_saved_prepared(w->model) * sizeof(double));
        run->prepared = run->segments.y;
    }
    w->c_is_known = 0;
    run->kept = tally.kept;
    run->least_norm = tally.least_norm;
    run->n_rhs = tally.n_rhs;
    run->n_steps = tally.n_steps;
    run->n_rejected = tally.n_rejected;
    run->n_bounded = tally.n_bounded;
    run->n_stiff = tally.n_stiff;
    run->t_reached = tally.t_reached;
}

#endif
