/* em_termination.h: the end of a run before t_end: by a fault, or at the caller's request. */
#ifndef EM_TERMINATION_H
#define EM_TERMINATION_H

#include "stepper/em_model_calls.h"

/* Result of a function of the loop: continue, or the run has ended with run->fault. */
enum { EM_GO_ON = 0, EM_END = -1 };

static int em_end_with(em_run_state *w, em_fault fault) {
    w->run->fault = fault;
    return EM_END;
}

static int em_end(em_run_state *w, em_status status) { return em_end_with(w, (em_fault){status, -1, -1, 0.0}); }

static double em_seconds_since(const struct timespec *then, const struct timespec *now) {
    return difftime(now->tv_sec, then->tv_sec) + 1e-9 * (double)(now->tv_nsec - then->tv_nsec);
}

/* Sets how often the clock is read. Reading it costs as much as a small right-hand side: it is read so rarely that
 * its cost is negligible, and often enough that at most a millisecond or a single step passes in between. */
static void em_pace_looks(em_run_state *w, double seconds) {
    enum { AT_MOST = 1024 };
    if (seconds > 2e-3) w->looks_every = 1;
    else if (seconds < 5e-4 && w->looks_every < AT_MOST) w->looks_every *= 2;
}

/* Calls poll about every 20 ms. A clock that was set back counts as elapsed time. */
static int em_poll(em_run_state *w) {
    const em_run *run = w->run;
    struct timespec now;
    if (run->poll == NULL || ++w->attempts_since_look < w->looks_every) return EM_GO_ON;
    timespec_get(&now, TIME_UTC);
    em_pace_looks(w, fabs(em_seconds_since(&w->looked, &now)));
    w->looked = now;
    w->attempts_since_look = 0;
    if (fabs(em_seconds_since(&w->polled, &now)) < 0.02) return EM_GO_ON;
    w->polled = now;
    return run->poll(run->poll_argument) ? em_end(w, EM_INTERRUPTED) : EM_GO_ON;
}

#endif
