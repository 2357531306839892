/* em_stepper.h: a run as a handle: opened, advanced and closed; em_simulate does all three.
 *
 * The stepper uses a model only through em_model. It is compiled once for all models (em_stepper.c), or at the end of a
 * NAME.c that is compiled as a whole (docs/architecture.md). It has no state of its own: all memory belongs to the run
 * and is allocated when the run is opened, except tables of rows. From the inside out: em_run_state.h (the state of a
 * run), em_model_calls.h, em_error_norm.h, em_methods.h (the methods), em_dense_output.h, em_event_detection.h
 * (events), em_monitors.h (checks of an accepted step), em_record.h (rows), em_step_size.h, em_step.h (one step), and
 * here the loop.
 */
#ifndef EM_STEPPER_H
#define EM_STEPPER_H

#include "events/em_time_event_jump.h"
#include "loop/em_method_change.h"
#include "loop/em_restart.h"
#include "loop/em_subnormals.h"
#include "stepper/em_run_memory.h"

/* --- the start of a run --- */

/* Converts the published state to the internal one, and records the first rows. */
static int em_enter(em_run_state *w) {
    em_run *run = w->run;
    run->t_reached = w->t = run->t_start;
    memcpy(w->y, run->y_start, (size_t)w->n_state * sizeof *w->y);
    if (!em_all_finite(w, w->y)) return em_not_finite(w, w->y, w->y), em_end_with(w, w->reason);
    run->least_norm = em_choose_dependent(w);
    if (run->least_norm && em_keep_constraints_at_start(w)) return em_append_first_rows(w) ? EM_END : em_end_with(w, w->reason);
    w->base_least_norm = run->least_norm;
    if (w->dynamics->act != NULL && em_first_segment(w)) return em_append_first_rows(w) ? EM_END : em_end_with(w, w->reason);
    const int settled = em_enter_mode(w);
    if (settled < 0) memcpy(w->y, run->y_start, (size_t)w->n_state * sizeof *w->y), w->mode = 0;
    if (em_append_first_rows(w)) return EM_END;
    return settled < 0 ? em_end_with(w, w->reason) : EM_CONTINUE;
}

/* Computes the first right-hand side, event values and step size. */
static int em_begin(em_run_state *w) {
    em_run *run = w->run;
    if (em_enter_interval(w) < 0) return em_end_with(w, w->reason);
    w->crosses = 0; /* a motion that begins at a time event begins after it */
    if (em_rhs(w, w->mode, w->t, w->y, w->memory, w->K[0])) return em_end_with(w, w->reason);
    em_weigh_start(w);
    if (!em_all_finite(w, w->y) || !em_all_finite(w, w->K[0])) return em_not_finite(w, w->y, w->K[0]), em_end_with(w, w->reason);
    if (!w->bare) em_begin_singularity_monitor(w);
    if (em_begin_energy_monitor(w) || (w->n_events > 0 && em_begin_events(w))) return em_end_with(w, w->reason);
    w->h_next = run->first_step > 0.0 ? run->first_step : em_first_size(w);
    w->begun = 1;
    return EM_CONTINUE;
}

/* Initialises a zeroed run state from its run. */
static void em_run_state_prepare(em_run_state *w) {
    const em_run *run = w->run;
    memcpy(w->atol, run->atol, (size_t)w->n * sizeof *w->atol);
    w->rtol = em_max(run->rtol, 100.0 * DBL_EPSILON); /* a smaller tolerance cannot be met */
    w->stretch = pow(w->rtol, -1.0 / (w->scheme.control.error_order + 1));
    w->new_segment = EM_FIRST_SEGMENT;
    w->direction = run->t_end < run->t_start ? -1.0 : 1.0;
    w->t_goal = run->t_end;
    w->inside[0] = -INFINITY, w->inside[1] = INFINITY;
    w->most_steps = run->max_steps;
}

/* An initialised run state, not yet at a state; or NULL. */
static em_run_state *em_run_state_create(const em_model *model, em_run *run) {
    em_scheme both = em_scheme_of(run->method);
    if (run->changes) both.at_nodes |= em_scheme_of(run->other).at_nodes, both.radau_iia = &EM_RADAU9_TABLEAU; /* tables for either */
    em_run_state *const w = em_run_state_allocate(model, both);
    if (w == NULL) return NULL;
    w->scheme = em_scheme_of(run->method);
    w->run = run;
    w->requested_least_norm = run->least_norm;
    em_run_state_prepare(w);
    w->clock_interval = 1;
    timespec_get(&w->clock_read, TIME_UTC);
    w->polled = w->clock_read;
    return w;
}

/* --- steps --- */

/* Makes the end of the step the start of the next. */
static void em_commit(em_run_state *w) {
    em_run *run = w->run;
    ++run->n_steps;
    w->longest_step = em_max(w->longest_step, fabs(w->h));
    run->n_bounded += w->mode == 1;
    run->n_stiff += w->stiff;
    w->t = w->t_new;
    w->mode = w->mode_new;
    w->last_error = em_max(w->log_size, EM_LEAST_ERROR);
    em_copy_state(w, w->y, w->y_new);
    em_copy_state(w, w->K[0], w->f_new);
    em_copy_memory(w, w->memory, w->memory_new);
    if (w->n_events > 0) {
        em_copy_events(w, w->g, w->g_new);
        memcpy(w->side, w->side_new, (size_t)w->n_events * sizeof *w->side);
    }
    w->new_segment = 0;
    w->depth = 0.0;
    if (w->dynamics->act != NULL) memset(w->rate_shift, 0, (size_t)w->n_rows * sizeof *w->rate_shift);
}

/* Recomputes rates and event values where the rates have jumped, at the start of another smooth interval. */
static int em_resume(em_run_state *w) {
    if (w->crosses < 0 || (w->crosses && em_cross_time_event(w))) return em_end_with(w, w->reason);
    w->crosses = 0;
    if (em_rhs(w, w->mode, w->t, w->y, w->memory, w->K[0])) return em_end_with(w, w->reason);
    return w->n_events > 0 && em_events_at(w, w->t, w->y, w->K[0], w->g) ? em_end_with(w, w->reason) : EM_CONTINUE;
}

/* Resumes at the start of the next smooth interval; at the target time, this is deferred until the run continues. */
static int em_enter_next_interval(em_run_state *w) {
    if (w->crosses && w->t == w->t_goal) return w->stale = 1, EM_CONTINUE;
    return em_resume(w);
}

/* Makes one accepted step. */
static int em_accepted_step(em_run_state *w) {
    if (em_step_forward(w)) return em_leave_implicit(w);
    if (w->run->least_norm && em_keep_constraints(w, w->t_new, w->y_new)) return em_end_with(w, w->reason);
    double t_stop = w->t_new;
    int terminal = 0, changed = 0;
    if (em_record(w, &t_stop, &terminal)) return EM_END;
    if (w->acting) return em_next_segment(w, t_stop, terminal);
    em_commit(w);
    w->run->t_reached = t_stop;
    if (terminal) return em_end(w, EM_TERMINAL_EVENT);
    if (w->model->n_rotations > 0 && em_change_chart(w, &changed)) return EM_END;
    if (w->t == w->pieces_end && em_enter_interval(w) && em_enter_next_interval(w)) return EM_END;
    return w->run->changes && !changed && !w->stale ? em_consider_method(w) : EM_CONTINUE;
}

/* --- the handle --- */

static void em_close(em_run_state *w) { free(w->block); }

/* A run at its start, or NULL without memory. `ended` says whether it is already over, and run->fault why. */
static em_run_state *em_open(const em_model *model, em_run *run) {
    run->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    if (em_rows_prepare(model, run)) return NULL;
    em_run_state *w = em_run_state_create(model, run);
    if (w == NULL) return em_fail(&run->fault, EM_OUT_OF_MEMORY, -1, -1, sizeof *w), NULL;
    if (w->scheme.step == NULL) return em_fail(&run->fault, EM_START_REFUSED, -1, -1, 0.0), em_close(w), NULL;
    w->refused = w->ended = em_enter(w);
    return w;
}

/* Keeps the last accepted state of a run that has failed. */
EM_COLD_PATH EM_NOINLINE void em_keep_last(em_run_state *w) {
    const em_fault fault = w->run->fault;
    w->run->last.count = 0;
    em_append(w, &w->run->last, w->mode, w->t, w->y, w->memory);
    w->run->fault = fault;
}

/* Steps to t_goal exactly. Returns `ended`: whether the run is over. */
static int em_advance(em_run_state *w, double t_goal) {
    const uint64_t subnormals = em_flush_subnormals();
    w->t_goal = t_goal;
    if (!w->ended && !w->begun && w->t != t_goal) w->ended = em_begin(w);
    if (w->run->waits) w->run->waits = 0, w->ended = em_change_method(w);
    while (!w->ended && w->t != w->t_goal && !w->run->waits) w->ended = em_accepted_step(w);
    if (w->ended && w->run->fault.status > EM_TERMINAL_EVENT) em_keep_last(w);
    em_restore_subnormals(subnormals);
    return w->ended;
}

/* em_model.simulate: runs from t_start to t_end. Returns run->fault.status. */
EM_EXPORT int em_simulate(const em_model *model, em_run *run) {
    em_run_state *w = em_open(model, run);
    if (w == NULL) return (int)run->fault.status;
    em_advance(w, run->t_end);
    em_close(w);
    return (int)run->fault.status;
}

#endif
