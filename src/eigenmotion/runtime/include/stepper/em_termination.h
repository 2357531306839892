/* em_termination.h: the end of a run before t_end: by a fault, or at the caller's request. */
#ifndef EM_TERMINATION_H
#define EM_TERMINATION_H

#include "stepper/em_model_calls.h"

/* Result of a function of the loop: continue, or the run has ended with run->fault. */
enum { EM_CONTINUE = 0, EM_END = -1 };

static int em_end_with(em_run_state *w, em_fault fault) {
    w->run->fault = fault;
    return EM_END;
}

static int em_end(em_run_state *w, em_status status) { return em_end_with(w, (em_fault){status, -1, -1, 0.0}); }

static double em_seconds_since(const struct timespec *then, const struct timespec *now) {
    return difftime(now->tv_sec, then->tv_sec) + 1e-9 * (double)(now->tv_nsec - then->tv_nsec);
}

/* Adapts how often the clock is read. Reading it costs as much as a small right-hand side. It is read so rarely that
 * its cost is negligible, and so often that at most a millisecond or a single step passes in between. */
static void em_adapt_clock_interval(em_run_state *w, double seconds) {
    enum { AT_MOST = 1024 };
    if (seconds > 2e-3) w->clock_interval = 1;
    else if (seconds < 5e-4 && w->clock_interval < AT_MOST) w->clock_interval *= 2;
}

/* Calls poll about every 20 ms. A clock that was set back counts as elapsed time. */
static int em_poll(em_run_state *w) {
    const em_run *run = w->run;
    struct timespec now;
    if (run->poll == NULL || ++w->attempts_since_clock < w->clock_interval) return EM_CONTINUE;
    timespec_get(&now, TIME_UTC);
    em_adapt_clock_interval(w, fabs(em_seconds_since(&w->clock_read, &now)));
    w->clock_read = now;
    w->attempts_since_clock = 0;
    if (fabs(em_seconds_since(&w->polled, &now)) < 0.02) return EM_CONTINUE;
    w->polled = now;
    return run->poll(run->poll_argument) ? em_end(w, EM_INTERRUPTED) : EM_CONTINUE;
}

#endif
