/* em_model_calls.h: calls of a run to its model: rates, velocities, rows, and settling of a state. */
#ifndef EM_MODEL_CALLS_H
#define EM_MODEL_CALLS_H

#include "stepper/em_motion.h"
#include "stepper/em_run_state.h"

EM_INLINE void em_copy_state(const em_run_state *w, double *restrict to, const double *restrict from) {
    em_copy_packs(w->width, to, from);
}

EM_INLINE void em_copy_memory(const em_run_state *w, double *restrict to, const double *restrict from) {
    em_copy_packs(w->n_memory, to, from);
}

EM_INLINE void em_copy_events(const em_run_state *w, double *restrict to, const double *restrict from) {
    memcpy(to, from, (size_t)w->n_events * sizeof *to);
}

/* The time at which the model is evaluated for time t of the current step (em_time_events.h). */
EM_INLINE double em_clock(const em_run_state *w, double t) { return em_min(em_max(t, w->inside[0]), w->inside[1]); }

static void em_signals(em_run_state *w, double t) {
    for (int i = 0; i < w->n_inputs; ++i) {
        const em_signal *u = &w->run->inputs[i];
        const int crosses = u->kind == EM_LINEAR && w->scheme.averages;
        w->u[i] = em_signal_at(u, crosses ? em_signal_interval(u, t, w->direction) : w->piece[i], t);
    }
}

/* F <- the constant y */
static void em_clear_interpolant(em_run_state *w) {
    const size_t states = (size_t)w->n_state;
    memset(w->F[0], 0, EM_DENSE_COEFFICIENTS * states * sizeof *w->y);
    memcpy(w->F[0], w->y, states * sizeof *w->y);
}

/* Locates the cause of a fault of a right-hand side at y. Returns -1 (em_constraint_monitor.h). */
EM_COLD_PATH static int em_locate_failure(em_run_state *w, double t, const double *y);

/* Flags for the treatment of constraint rows. */
static int em_constraint_flags(const em_run *run) { return run->least_norm ? EM_LEAST_NORM | run->kept : 0; }

/* dy <- (v, a) at a state (x, v), with the signals in w->u. */
EM_NOINLINE int em_motion_rate_here(em_run_state *w, double t, const double *y, double *dy) {
    em_run *run = w->run;
    ++run->n_rhs;
    const int flags = em_constraint_flags(run);
    return em_motion_rhs(w->model, em_clock(w, t), y, run->prepared, w->u, w->memory, flags, dy, &w->reason)
               ? em_locate_failure(w, t, y) : 0;
}

/* dy <- f(t, y) with the signals at t. */
EM_INLINE int em_rhs(em_run_state *w, int mode, double t, const double *y, double *memory, double *dy) {
    em_run *run = w->run;
    if (w->n_inputs > 0) em_signals(w, t);
    if (mode == EM_MOTION && !em_carries_motion(w->model)) return em_motion_rate_here(w, t, y, dy);
    ++run->n_rhs;
    t = em_clock(w, t);
    return w->dynamics->rhs(mode, t, y, run->prepared, w->u, memory, em_constraint_flags(run), dy, &w->reason)
               ? em_locate_failure(w, t, y) : 0;
}

/* v (n) <- xdot. 0, or -1 and *fault */
static int em_xdot(const em_run_state *w, int mode, double t, const double *y, double *v, em_fault *fault) {
    if (mode != EM_MOTION) return w->dynamics->velocity(mode, t, y, w->run->prepared, v, fault);
    memcpy(v, y + w->n, (size_t)w->n * sizeof *v);
    return 0;
}

/* Whether an error of y[n .. 2 n) is an error of xdot itself. */
EM_INLINE int em_is_velocity_error(const em_run_state *w) { return w->mode == EM_MOTION || em_carries_motion(w->model); }

/* ev (n) <- the error of xdot that follows from an error e (n) of y[n .. 2 n) */
static void em_velocity_error(const em_run_state *w, const double *e, double *ev) {
    if (em_is_velocity_error(w)) memcpy(ev, e, (size_t)w->n * sizeof *ev);
    else w->dynamics->velocity_error(w->mode, w->y, w->run->prepared, w->memory, e, ev);
}

/* row (n_state) <- y in the published meaning. 0, or -1 and *fault */
static int em_publish(const em_model *model, const em_run *run, int mode, double t, const double *y, const double *memory,
                      double *row, em_fault *fault) {
    if (mode == EM_MOTION) return em_motion_publish(model, t, y, run->prepared, row, fault);
    return model->dynamics->publish(mode, t, y, run->prepared, memory, row, fault);
}

static int em_settle(const em_model *model, const em_run *run, int *mode, int flags, double t, double *y, double *memory,
                     double pace, em_fault *fault) {
    if (!model->dynamics->settles && run->stabilise && !(flags & EM_BEGIN)) return 0;
    if (run->stabilise) flags |= EM_STABILISE;
    if (!(flags & EM_LEAST_NORM)) flags |= em_constraint_flags(run);
    if (*mode == EM_MOTION) return em_motion_settle(model, flags, t, y, run->prepared, memory, pace, fault);
    return model->dynamics->settle(mode, flags, t, y, run->prepared, memory, pace, fault);
}

/* Converts the published state in w->y to the scheme's mode and settles it. Returns as em_settle. */
static int em_enter_mode(em_run_state *w) {
    double v[w->n];
    if (w->scheme.mode == EM_MOTION) {
        if (em_xdot(w, 0, w->t, w->y, v, &w->reason)) return -1;
        memcpy(w->y + w->n, v, sizeof v);
        w->mode = EM_MOTION;
    }
    return em_settle(w->model, w->run, &w->mode, EM_BEGIN, w->t, w->y, w->memory, 0.0, &w->reason);
}

/* dy <- f at the nearest point on the constraints. Where the rows become dependent, as near a singular position, an
 * argument with a constraint error e has rates with an error of e over the square of the remaining independence; on
 * the constraints it does not. */
EM_NOINLINE int em_settled_rhs(em_run_state *w, double t, const double *y, double *dy) {
    double settled[w->width], memory[em_padded(w->n_memory)];
    int mode = w->mode;
    em_copy_state(w, settled, y);
    em_copy_memory(w, memory, w->memory);
    if (em_settle(w->model, w->run, &mode, EM_KEEP_MODE, em_clock(w, t), settled, memory, 0.0, &w->reason) < 0) return -1;
    return em_rhs(w, mode, t, settled, memory, dy);
}

/* dy <- f at a stage of a step. */
EM_NOINLINE int em_any_stage_rate(em_run_state *w, double t, const double *y, double *dy) {
    return w->near && w->n_positions > 0 ? em_settled_rhs(w, t, y, dy) : em_rhs(w, w->mode, t, y, w->memory, dy);
}

/* Whether the rates at stages are simply the model's right-hand side there, as in most steps. */
EM_INLINE int em_is_plain(const em_run_state *w) {
    return w->n_inputs == 0 && !w->between && !w->near && (w->mode != EM_MOTION || em_carries_motion(w->model));
}

EM_INLINE int em_stage_rate(void *run_state, const double *t, const double *y, double *dy) {
    em_run_state *const w = run_state;
    em_run *const run = w->run;
    if (!w->plain) return em_any_stage_rate(w, *t, y, dy);
    ++run->n_rhs;
    return w->dynamics->rhs(w->mode, *t, y, run->prepared, w->u, w->memory, em_constraint_flags(run), dy, &w->reason)
               ? em_locate_failure(w, *t, y) : 0;
}

/* Whether all numbers of a state, or of a rate, are finite: NaN and infinity survive a product with zero. */
EM_INLINE int em_all_finite(const em_run_state *w, const double *restrict y) {
    const int width = w->width;
    em_pack sum = {0.0};
    for (int k = 0; k < width; k += EM_PACK) sum += 0.0 * EM_PACK_AT(y + k);
    return EM_SUM_OF_PACK(sum) == 0.0;
}

#endif
