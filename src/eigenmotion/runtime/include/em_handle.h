/* em_handle.h: a run that goes on as far as it is told, as em_model has it (em_control.h is for whoever wants one). */
#ifndef EM_HANDLE_H
#define EM_HANDLE_H

#include "em_stepper.h"

/* How many of the prepared parameters say in which mode a run is: all, where events change it. */
#ifdef EM_ACTS
enum { EM_SAVED_PREPARED = N_SWITCHES > 0 ? N_PREPARED : 0 };
#else
enum { EM_SAVED_PREPARED = 0 };
#endif

/* What a run has counted so far, and its mode: the part of it that is saved. */
typedef struct em_tally {
    int kept, least_norm;
    long n_rhs, n_steps, n_rejected, n_bounded, n_stiff;
    double t_reached, prepared[EM_SAVED_PREPARED + 1];
} em_tally;

enum { EM_SAVED_WALK = offsetof(em_walk, run) };

/* em_model.open */
EM_ACROSS void *em_handle_open(em_run *run) { return em_open(run); }

/* em_model.close */
EM_ACROSS void em_handle_close(void *walk) { em_close(walk); }

/* em_model.again: counts and tables, but for their memory, are those of a run that has not begun. */
EM_ACROSS int em_handle_again(void *walk) {
    em_walk *w = walk;
    em_run *run = w->run;
    memset(w, 0, EM_SAVED_WALK);
    w->end_rate = NULL;
    w->c_is_known = 0;
    em_walk_prepare(w);
    run->kept = 0;
    run->n_rhs = run->n_steps = run->n_rejected = run->n_bounded = run->n_jacobians = run->n_factors = run->n_stiff = 0;
    run->rows.count = run->legs.count = 0;
    for (int i = 0; i < N_EVENTS; ++i) run->events[i].count = run->after[i].count = 0;
    run->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    w->refused = w->ended = em_enter(w);
    return (int)run->fault.status;
}

/* The other way in time, where pieces of signals are entered from their other ends. */
static void em_turn_back(em_walk *w) {
    w->direction = -w->direction;
    w->stale |= em_enter_pieces(w);
}

/* em_model.advance: steps up to t, after what inputs may have jumped. Whatever ended an advance before does not count:
 * the run stands where it came to, and tries again. */
EM_ACROSS int em_handle_advance(void *walk, double t, int jumped) {
    em_walk *w = walk;
    em_run *run = w->run;
    if (w->refused) return EM_END;
    run->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    w->ended = EM_GO_ON;
    w->most_steps = run->n_steps + run->max_steps;
    w->stale |= jumped && w->begun;
    if (w->direction * (t - w->t) < 0.0) em_turn_back(w);
    if (w->stale && w->t != t) {
        if (em_resume(w)) return EM_END;
        if (!em_all_finite(w->K[0])) return em_not_finite(w, w->y, w->K[0]), em_end_with(w, w->reason);
        w->stale = 0;
    }
    return em_advance(w, t);
}

/* em_model.now */
EM_ACROSS double em_handle_now(const void *walk, double *x, double *v) {
    const em_walk *w = walk;
    em_fault fault;
    memcpy(x, w->y, N * sizeof *x);
    if (w->begun && !w->stale) memcpy(v, w->K[0], N * sizeof *v);
    else if (em_xdot(w->run, w->mode, w->t, w->y, v, &fault))
        for (int k = 0; k < N; ++k) v[k] = NAN;
    return w->t;
}

/* em_model.publish */
EM_ACROSS int em_handle_publish(const void *walk, double *y, em_fault *fault) {
    const em_walk *w = walk;
    return em_publish(w->run, w->mode, w->t, w->y, w->memory, y, fault);
}

/* em_model.saved */
EM_ACROSS size_t em_handle_saved(void) { return EM_SAVED_WALK + sizeof(em_tally); }

/* em_model.save */
EM_ACROSS void em_handle_save(const void *walk, void *saved) {
    const em_walk *w = walk;
    const em_run *run = w->run;
    em_tally tally;
    memset(&tally, 0, sizeof tally); /* with what pads it: the same motion gives the same bytes */
    tally.kept = run->kept, tally.least_norm = run->least_norm, tally.n_rhs = run->n_rhs, tally.n_steps = run->n_steps, tally.n_rejected = run->n_rejected;
    tally.n_bounded = run->n_bounded, tally.n_stiff = run->n_stiff, tally.t_reached = run->t_reached;
    memcpy(tally.prepared, run->prepared, EM_SAVED_PREPARED * sizeof *tally.prepared);
    memcpy(saved, w, EM_SAVED_WALK);
    memcpy((char *)saved + EM_SAVED_WALK, &tally, sizeof tally);
}

/* em_model.restore */
EM_ACROSS void em_handle_restore(void *walk, const void *saved) {
    em_walk *w = walk;
    em_run *run = w->run;
    em_tally tally;
    memcpy(w, saved, EM_SAVED_WALK);
    memcpy(&tally, (const char *)saved + EM_SAVED_WALK, sizeof tally);
    if (EM_SAVED_PREPARED > 0) { /* in a table of one row, where steppers have the mode they are in */
        memcpy(run->legs.y, tally.prepared, EM_SAVED_PREPARED * sizeof *tally.prepared);
        run->prepared = run->legs.y;
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
