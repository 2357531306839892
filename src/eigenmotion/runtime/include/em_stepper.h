/* em_stepper.h: em_model.simulate, the stepping loop. Included at the end of a generated NAME.c, whose enumerators and
 * static functions it uses (docs/architecture.md); no state of its own, all memory belongs to the run.
 *
 * Step sizes as in scipy.integrate (Hairer, Norsett & Wanner, II.4), with the error measured in x and v. A step counts
 * only when everything about it worked: its stages, its error, settling, the right-hand side and the interpolant at its
 * end. Whatever did not is tried again with a shorter step, and names the end of the run if no step is short enough.
 */
#ifndef EM_STEPPER_H
#define EM_STEPPER_H

#include "em_rows.h"
#include "em_signals.h"

#include "em_step.h"

#include "em_dense.h"
#include "em_roots.h"
#include "em_guard.h"
#include "em_chart.h"
#include "em_witness.h"

_Static_assert(N_STATE == 2 * N + N_C + N_S + N_CD + N_SD, "y is x, eta or v, C, s, C_delta, s_delta");

/* --- the methods --- */

static int em_rk34_step(em_walk *w) { return em_take_step(&EM_RK34_TABLEAU, w); }
static int em_dopri5_step(em_walk *w) { return em_take_step(&EM_DOPRI5_TABLEAU, w); }
static int em_dop853_step(em_walk *w) { return em_take_step(&EM_DOP853_TABLEAU, w); }

static int em_no_extra(em_walk *w) { return (void)w, 0; }
static int em_dop853_extra(em_walk *w) { return em_stages(&EM_DOP853_TABLEAU, w, 13, 15); }

static void em_rk34_correct(em_walk *w) { em_corrections(&EM_RK34_TABLEAU, w); }
static void em_dopri5_correct(em_walk *w) { em_corrections(&EM_DOPRI5_TABLEAU, w); }
static void em_dop853_correct(em_walk *w) { em_corrections(&EM_DOP853_TABLEAU, w); }

static const em_scheme em_schemes[] = {
    [EM_RK34] = {&EM_RK34_TABLEAU, em_rk34_step, em_no_extra, em_rk34_correct},
    [EM_DOPRI5] = {&EM_DOPRI5_TABLEAU, em_dopri5_step, em_no_extra, em_dopri5_correct},
    [EM_DOP853] = {&EM_DOP853_TABLEAU, em_dop853_step, em_dop853_extra, em_dop853_correct},
};

/* --- the end of a run --- */

/* What a function of the loop answers: go on, or the run has ended with run->fault. */
enum { EM_GO_ON = 0, EM_END = -1 };

static int em_end_with(em_walk *w, em_fault fault) {
    w->run->fault = fault;
    return EM_END;
}

static int em_end(em_walk *w, em_status status) { return em_end_with(w, (em_fault){status, -1, -1, 0.0}); }

/* --- the caller's wish to stop --- */

static double em_seconds_since(const struct timespec *then, const struct timespec *now) {
    return difftime(now->tv_sec, then->tv_sec) + 1e-9 * (double)(now->tv_nsec - then->tv_nsec);
}

/* Looking at the clock costs as much as a small right-hand side: look so seldom that it costs nothing, and so often
 * that a millisecond or a single step passes between two looks. */
static void em_pace_looks(em_walk *w, double seconds) {
    enum { AT_MOST = 1024 };
    if (seconds > 2e-3) w->looks_every = 1;
    else if (seconds < 5e-4 && w->looks_every < AT_MOST) w->looks_every *= 2;
}

/* Calls poll about every 20 ms. A clock that was set back counts as time passed. */
static int em_poll(em_walk *w) {
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

/* --- rows --- */

static int em_append(em_walk *w, em_rows *rows, int mode, double t, const double *y, const double *memory) {
    em_fault fault;
    double *row = em_rows_next(rows, &fault);
    if (row == NULL || model_publish(mode, t, y, w->run->prepared, memory, row, &fault)) return em_end_with(w, fault);
    em_rows_keep(rows, t);
    return EM_GO_ON;
}

/* A row at t, inside the step under way or at its end. */
static int em_append_at(em_walk *w, em_rows *rows, double t) {
    double memory[EM_SOME_MEMORY];
    if (t == w->t_new) return em_append(w, rows, w->mode_new, t, w->y_new, w->memory_new);
    if (em_inside(w, t, w->argument, memory)) return em_end_with(w, w->reason);
    return em_append(w, rows, w->mode, t, w->argument, memory);
}

/* Whether the next row of t_eval is due when the run has come to t. */
static int em_row_is_due(const em_walk *w, double t) {
    const em_run *run = w->run;
    return w->next_t_eval < run->n_t_eval && w->direction * (run->t_eval[w->next_t_eval] - t) <= 0.0;
}

/* The rows of this step up to t_stop. */
static int em_append_rows(em_walk *w, double t_stop) {
    em_run *run = w->run;
    if (run->t_eval == NULL) return t_stop == w->t ? EM_GO_ON : em_append_at(w, &run->rows, t_stop);
    while (em_row_is_due(w, t_stop)) {
        if (em_append_at(w, &run->rows, run->t_eval[w->next_t_eval++]) || em_poll(w)) return EM_END;
    }
    return EM_GO_ON;
}

static int em_append_first_rows(em_walk *w) {
    em_run *run = w->run;
    if (run->t_eval == NULL) return em_append(w, &run->rows, w->mode, w->t, w->y, w->memory);
    for (; em_row_is_due(w, w->t); ++w->next_t_eval)
        if (em_append(w, &run->rows, w->mode, run->t_eval[w->next_t_eval], w->y, w->memory)) return EM_END;
    return EM_GO_ON;
}

/* Record the crossings up to the first terminal one, whose time becomes *t_stop, and what else happens then. */
static int em_append_crossings(em_walk *w, double *t_stop, int *terminal) {
    em_crossing list[EM_MOST_FOUND];
    const int count = em_locate_crossings(w, list);
    if (count < 0) return em_end_with(w, w->reason);
    for (int i = 0; i < count && (!*terminal || list[i].t == *t_stop); ++i) {
        *terminal |= w->run->event_terminal[list[i].event];
        if (*terminal) *t_stop = list[i].t;
        if (em_append_at(w, &w->run->events[list[i].event], list[i].t)) return EM_END;
    }
    return EM_GO_ON;
}

/* --- the signals --- */

/* The pieces that hold after w->t. Returns whether one of them jumps there, so that f does too. */
static int em_enter_pieces(em_walk *w) {
    int jumps = 0;
    w->signals_end = w->direction * INFINITY;
    for (int i = 0; i < N_INPUTS; ++i) {
        const em_signal *u = &w->run->inputs[i];
        if (u->kind == EM_CONSTANT) continue;
        w->piece[i] = em_signal_piece(u, w->t, w->direction);
        const double end = em_signal_end(u, w->piece[i], w->direction);
        if (w->direction * (end - w->signals_end) < 0.0) w->signals_end = end;
        jumps |= u->kind == EM_HOLD;
    }
    return jumps;
}

/* --- one step --- */

static double em_spacing(const em_walk *w) { return fabs(nextafter(w->t, w->direction * INFINITY) - w->t); }

/* t_new and h of a step of size `size`, no further than t_end or the signals' next sample. */
static void em_aim(em_walk *w, double size) {
    const double t_end = w->run->t_end;
    const double bound = w->direction * (w->signals_end - t_end) < 0.0 ? w->signals_end : t_end;
    w->t_new = w->t + w->direction * size;
    if (w->direction * (w->t_new - bound) > 0.0) w->t_new = bound;
    w->h = w->t_new - w->t;
}

/* Whether somebody asks for a state inside the step. */
static int em_needs_interpolant(const em_walk *w) {
    const em_run *run = w->run;
    if (w->has_interpolant) return 0;
    if (run->dense) return 1;
    return run->t_eval != NULL && em_row_is_due(w, w->t_new) && run->t_eval[w->next_t_eval] != w->t_new;
}

/* Where nothing settles them, errors of C and s add up. In a motion they count by what they are of an eigenvalue of M,
 * which may become small later. 0, or -1 and w->reason. */
static int em_check_factors(em_walk *w) {
#ifdef EM_CARRIES_FACTORS
    enum { DRIFTED = 1000 }; /* tolerances */
    if (w->run->stabilise) return 0;
    int first = -1;
    const double error = model_factor_error(w->t_new, w->y_new, w->run->prepared, &first);
    if (!(error <= DRIFTED * w->rtol)) return em_fail(&w->reason, EM_FACTORS_DRIFTED, first, -1, error);
#endif
    return (void)w, 0;
}

/* What follows a step whose error is small enough. 0, or -1 and w->reason. */
static int em_land(em_walk *w) {
    const em_tableau *rk = w->scheme->tableau;
    const int last_is_first = rk->solution < rk->stages;
    w->mode_new = w->mode;
    memcpy(w->memory_new, w->memory, sizeof w->memory);
    memcpy(w->y_raw, w->y_new, sizeof w->y_new);
    w->moved = em_settle(w->run, &w->mode_new, 0, w->t_new, w->y_new, w->memory_new, w->h * w->stretch,
                         &w->reason);
    if (w->moved < 0) return -1;
    if (w->mode_new != w->mode) w->moved = 1;
    if (last_is_first && !w->moved) memcpy(w->f_new, w->K[rk->solution], sizeof w->f_new);
    else if (em_rhs(w, w->mode_new, w->t_new, w->y_new, w->memory_new, w->f_new)) return -1;
    if (!em_all_finite(w->y_new) || !em_all_finite(w->f_new)) return em_not_finite(w, w->y_new, w->f_new);
    if (em_check_chart(w) || em_check_step(w) || em_check_factors(w) || em_check_energy(w)) return -1;
    if (N_EVENTS > 0 && em_watch(w)) return -1;
    return em_needs_interpolant(w) ? em_build_interpolant(w) : 0;
}

/* 0, or -1 and w->reason; then the error norm may still be 1 or more. */
static int em_attempt(em_walk *w) {
    w->error_norm = INFINITY;
    if (w->scheme->step(w)) return -1;
    if (!isfinite(w->error_norm) || !em_all_finite(w->y_new)) return em_not_finite(w, w->y_new, w->error);
    return w->error_norm < 1.0 ? em_land(w) : 0;
}

/* By which the size of the next step differs: after an accepted step for its error and that of the one before
 * (Gustafsson, ACM Trans. Math. Softw. 17 (1991)), so that few are rejected; after a rejected one for its error alone.
 * A step that failed otherwise is quartered. */
static double em_size_factor(const em_walk *w, int failed) {
    const double safety = 0.9, least = 0.2, most = 4.0, order = w->scheme->tableau->error_order + 1;
    if (failed) return 0.25;
    const double error = log(w->error_norm);
    const double wanted = error < 0.0 ? 0.4 * w->last_error - 0.7 * error : -error;
    return em_min(most, em_max(least, safety * exp(wanted / order)));
}

/* No step is short enough: the fault that stood in the way, if it was not the error alone. */
static int em_underflow(em_walk *w, double size, em_fault obstacle) {
    if (obstacle.status != EM_FINISHED) return em_end_with(w, obstacle);
    return em_end_with(w, (em_fault){EM_STEP_SIZE_UNDERFLOW, em_worst_coordinate(w), -1, size});
}

/* Attempts until one succeeds; proposes the size of the next step. */
static int em_step_forward(em_walk *w) {
    em_run *run = w->run;
    if (run->n_steps >= run->max_steps) return em_end(w, EM_TOO_MANY_STEPS);
    const double least = 10.0 * em_spacing(w);
    const double proposed = em_max(least, em_min(w->h_next, run->max_step));
    em_fault obstacle = {EM_FINISHED, -1, -1, 0.0};
    double size = proposed;
    for (int rejected = 0;; ++rejected) {
        if (size < least) return em_underflow(w, size, obstacle);
        if (em_poll(w)) return EM_END;
        em_aim(w, size);
        w->retries = rejected;
        const int failed = em_attempt(w) != 0;
        const double factor = em_size_factor(w, failed);
        size = fabs(w->h) * (rejected ? em_min(1.0, factor) : factor);
        if (failed) obstacle = w->reason;
        else if (w->error_norm < 1.0) break;
        ++run->n_rejected;
    }
    /* A step cut short at a sample says little: the size proposed before stands. */
    const int cut = w->t_new == w->signals_end && size >= fabs(w->h);
    w->h_next = cut ? em_max(size, proposed) : size;
    return EM_GO_ON;
}

#define EM_LEAST_ERROR -9.2 /* log 1e-4: a step by chance without error says nothing of the next */

/* The end of the step becomes the start of the next. */
static void em_commit(em_walk *w) {
    em_run *run = w->run;
    ++run->n_steps;
    w->longest_step = em_max(w->longest_step, fabs(w->h));
    run->n_bounded += w->mode != 0;
    w->t = w->t_new;
    w->mode = w->mode_new;
    w->last_error = em_max(log(w->error_norm), EM_LEAST_ERROR);
    memcpy(w->y, w->y_new, sizeof w->y);
    memcpy(w->K[0], w->f_new, sizeof w->f_new);
    memcpy(w->memory, w->memory_new, sizeof w->memory);
    memcpy(w->g, w->g_new, sizeof w->g);
    memcpy(w->side, w->side_new, sizeof w->side);
}

/* All that is recorded of an accepted step; *t_stop is where a terminal event ends it. */
static int em_record(em_walk *w, double *t_stop, int *terminal) {
    const em_dense_step kept = {w->t, w->h, w->mode, em_row_flags(w->run)};
    em_fault fault;
    if (N_EVENTS > 0 && em_append_crossings(w, t_stop, terminal)) return EM_END;
    if (em_append_rows(w, *t_stop)) return EM_END;
    return w->run->dense && *t_stop != w->t && em_dense_keep(w->run, kept, w->F[0], &fault) ? em_end_with(w, fault) : EM_GO_ON;
}

/* One accepted step, and f anew where a signal jumps at its end. */
static int em_advance(em_walk *w) {
    if (em_step_forward(w)) return EM_END;
    if (w->run->least_norm && em_keep_rows(w, w->t_new, w->y_new)) return em_end_with(w, w->reason);
    double t_stop = w->t_new;
    int terminal = 0;
    if (em_record(w, &t_stop, &terminal)) return EM_END;
    em_commit(w);
    w->run->t_reached = t_stop;
    if (terminal) return em_end(w, EM_TERMINAL_EVENT);
    if (w->t != w->signals_end || !em_enter_pieces(w)) return EM_GO_ON;
    if (em_rhs(w, w->mode, w->t, w->y, w->memory, w->K[0])) return em_end_with(w, w->reason);
    return N_EVENTS > 0 && em_events_at(w, w->t, w->y, w->K[0], w->g) ? em_end_with(w, w->reason) : EM_GO_ON;
}

/* --- the start of a run --- */

/* Root mean square of the weighted (x, v) of a vector (n_state) that is a state's rate. */
static double em_rate_norm(em_walk *w, const double *rate) {
    memcpy(w->error, rate, sizeof w->error);
    return sqrt(em_squares(w, w->error) / em_count(w));
}

/* Root mean square of the weighted (x, v) and factors of the state itself. */
static double em_state_norm(const em_walk *w) {
    double sum = em_weighted_squares(N, w->y, w->weight) + em_weighted_squares(N, w->K[0], w->weight + N);
    if (!w->run->stabilise) sum += em_weighted_squares(N_STATE - 2 * N, w->y + 2 * N, w->weight + 2 * N);
    return sqrt(sum / em_count(w));
}

/* |f(t + h, y + h f) - f| / h, the size of the second derivative; a fault on the way counts as none. */
static double em_second_derivative(em_walk *w, double h) {
    for (int k = 0; k < EM_WIDTH; ++k) w->argument[k] = w->y[k] + w->direction * h * w->K[0][k];
    if (em_rhs(w, w->mode, w->t + w->direction * h, w->argument, w->memory, w->K[1])) return 0.0;
    for (int k = 0; k < EM_WIDTH; ++k) w->K[2][k] = w->K[1][k] - w->K[0][k];
    const double norm = em_rate_norm(w, w->K[2]) / h;
    return isfinite(norm) ? norm : 0.0;
}

/* The first step's size, after Hairer, Norsett & Wanner, II.4, in whatever unit the time is: d0, d1, d2, the sizes of
 * the state and its derivatives in tolerances, tell the rate at which the motion varies, and a step h is off by about
 * d1 h (rate h)^p. A state smaller than its tolerance says as little as one of that size. */
static double em_first_size(em_walk *w, double d0, double d1) {
    const em_run *run = w->run;
    const double span = fabs(run->t_end - run->t_start), order = w->scheme->tableau->error_order;
    const double h0 = d1 * span > 1.0 ? em_min(0.01 * em_max(d0, 1.0) / d1, span) : 1e-6 * span;
    const double d2 = em_second_derivative(w, h0), slope = em_max(d1, d2 * h0);
    if (!(d2 > 0.0)) return em_min(100.0 * h0, em_min(span, run->max_step));
    const double rate = em_max(sqrt(d2 / em_max(d0, 1.0)), d2 / slope);
    const double h1 = pow(0.01 * rate / slope, 1.0 / (order + 1)) / rate;
    return em_min(em_min(100.0 * h0, h1), em_min(span, run->max_step));
}

/* The published state as the internal one, and the first rows. */
static int em_enter(em_walk *w) {
    em_run *run = w->run;
    run->t_reached = w->t = run->t_start;
    memcpy(w->y, run->y_start, N_STATE * sizeof *w->y);
    if (!em_all_finite(w->y)) return em_not_finite(w, w->y, w->y), em_end_with(w, w->reason);
    if (run->least_norm && em_keep_rows_at_start(w)) return em_append_first_rows(w) ? EM_END : em_end_with(w, w->reason);
    const int settled = em_settle(run, &w->mode, EM_BEGIN, w->t, w->y, w->memory, 0.0, &w->reason);
    if (settled < 0) memcpy(w->y, run->y_start, N_STATE * sizeof *w->y), w->mode = 0;
    if (em_append_first_rows(w)) return EM_END;
    return settled < 0 ? em_end_with(w, w->reason) : EM_GO_ON;
}

/* Weights of the state at the start; what is 0 and has no absolute tolerance says nothing of its size. */
static void em_weigh_start(em_walk *w) {
    em_set_weights(w, w->y, w->K[0], w->y, w->K[0]);
    for (int k = 0; k < N_STATE; ++k)
        if (w->weight[k] >= 1.0 / DBL_MIN) w->weight[k] = 0.0;
}

/* The first right-hand side, event values and step size. */
static int em_begin(em_walk *w) {
    em_run *run = w->run;
    em_enter_pieces(w);
    if (em_rhs(w, w->mode, w->t, w->y, w->memory, w->K[0])) return em_end_with(w, w->reason);
    em_weigh_start(w);
    const double d0 = em_state_norm(w), d1 = em_rate_norm(w, w->K[0]);
    if (!em_all_finite(w->y) || !em_all_finite(w->K[0])) return em_not_finite(w, w->y, w->K[0]), em_end_with(w, w->reason);
    em_begin_chart(w);
    if (em_begin_witness(w) || (N_EVENTS > 0 && em_begin_events(w))) return em_end_with(w, w->reason);
    w->h_next = run->first_step > 0.0 ? run->first_step : em_first_size(w, d0, d1);
    return EM_GO_ON;
}

/* A zeroed walk on cache lines of its own, or NULL. */
static em_walk *em_walk_create(em_run *run) {
    enum { LINE = 64 };
    void *block = calloc(1, sizeof(em_walk) + LINE);
    if (block == NULL) return NULL;
    em_walk *w = (em_walk *)(((uintptr_t)block + LINE - 1) / LINE * LINE);
    w->block = block;
    w->run = run;
    w->scheme = &em_schemes[run->method];
    w->rtol = em_max(run->rtol, 100.0 * DBL_EPSILON); /* less cannot be met */
    w->stretch = pow(w->rtol, -1.0 / (w->scheme->tableau->error_order + 1));
    w->direction = run->t_end < run->t_start ? -1.0 : 1.0;
    w->looks_every = 1;
    timespec_get(&w->looked, TIME_UTC);
    w->polled = w->looked;
    return w;
}

/* em_model.simulate: run from t_start to t_end. Returns run->fault.status. */
static int em_simulate(em_run *run) {
    run->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    if (em_rows_prepare(run)) return run->fault.status;
    em_walk *w = em_walk_create(run);
    if (w == NULL) return em_fail(&run->fault, EM_OUT_OF_MEMORY, -1, -1, sizeof *w), run->fault.status;
    int ended = em_enter(w);
    if (!ended && w->t != run->t_end) ended = em_begin(w);
    while (!ended && w->t != run->t_end) ended = em_advance(w);
    free(w->block);
    return (int)run->fault.status;
}

#endif
