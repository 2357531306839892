/* em_steppers.h: K steppers of one em_model, advanced together.
 *
 * For the runtime, not for generated code. They use lanes (em_fixed_steps.h) if the method has a fixed step size and
 * the model allows it; otherwise each is an em_stepper (em_control.h). Members are independent: the results of one
 * depend neither on their number nor on threads. All memory is allocated when they are opened. A member that fails, or
 * reaches a terminal event, has ended: it stays there until it is restarted. */
#ifndef EM_STEPPERS_H
#define EM_STEPPERS_H

#include <stdint.h>
#include <time.h>

#include "em_control.h"
#include "kinematics/em_shadow_parameters.h"
#include "batch/em_fixed_steps.h"
#include "loop/em_subnormals.h"

/* The arrays of the first part are the caller's: (count), (count, n), (count, n_inputs). */
typedef struct em_steppers {
    const em_model *model;
    em_run task;             /* the task of all; t_start, y_start, prepared are the member's */
    size_t count;
    double *t, *x, *v, *u;   /* the current states; the inputs that are constant */
    unsigned char *ended;
    long *n_rhs, *n_steps;   /* since the start of the member */
    const volatile int *stop; /* the caller sets it to 1 to request an end */

    em_fault *fault;         /* (count) why a member has ended, or has stopped for now (EM_INTERRUPTED) */
    int width, workers;      /* width: number of lanes, or 1: one by one */
    em_stepper **steppers;   /* (count), or NULL: in lanes. Then the tables of each group of `width` members are: */
    double *Y, *C, *U;       /* (n_state, width), (n_prepared, width), (n_inputs, width) */
    double *scratch;         /* of each worker */
    void *block;
} em_steppers;

/* The number of lanes that members use; u (n_inputs) of the task says which inputs are constant. */
static int em_steppers_width(const em_model *model, const em_run *task) {
    const int fixed = task->method == EM_RK4 || task->method == EM_MIDPOINT;
    const em_lanes *const lanes = model->lanes;
    const int disturbed = model->m > 0 || model->n_events > 0 || model->n_time_events > 0;
    if (!fixed || !model->dynamics->second_order || disturbed || lanes == NULL || lanes->run == NULL) return 1;
    for (int k = 0; k < model->n_inputs; ++k)
        if (task->inputs != NULL && task->inputs[k].kind != EM_CONSTANT) return 1;
    return lanes->width == 2 || lanes->width == 4 || lanes->width == 8 ? lanes->width : 1;
}

/* Allocates the tables of lanes, aligned to cache lines. 0, or -1 without memory. */
static int em_steppers_tables(em_steppers *s) {
    enum { LINE = 8 };
    const em_model *const model = s->model;
    const size_t members = (s->count + EM_MOST_LANES - 1) / EM_MOST_LANES * EM_MOST_LANES;
    const size_t y = (size_t)model->n_state, c = (size_t)model->n_prepared + 1, u = (size_t)model->n_inputs + 1;
    const size_t scratch = em_fixed_numbers(s->model) * (size_t)s->workers;
    double *const block = calloc(members * (y + c + u) + scratch + LINE, sizeof *block);
    if (block == NULL) return -1;
    s->block = block;
    s->Y = (double *)(((uintptr_t)block + LINE * sizeof *block - 1) / (LINE * sizeof *block) * (LINE * sizeof *block));
    s->C = s->Y + members * y;
    s->U = s->C + members * c;
    s->scratch = s->U + members * u;
    return 0;
}

static void em_steppers_close(em_steppers *s) {
    for (size_t k = 0; s->steppers != NULL && k < s->count; ++k) em_stepper_close(s->steppers[k]);
    free(s->steppers);
    free(s->block);
    free(s->fault);
    s->steppers = NULL;
    s->block = NULL;
    s->fault = NULL;
}

/* Allocates all memory; no member has a state yet. The caller fills the first part. 0, or -1 without memory. */
static int em_steppers_open(em_steppers *s, int workers) {
    s->width = em_steppers_width(s->model, &s->task);
    s->workers = workers;
    s->fault = calloc(s->count, sizeof *s->fault);
    if (s->fault == NULL) return -1;
    if (s->width > 1) return em_steppers_tables(s);
    s->steppers = calloc(s->count, sizeof *s->steppers);
    return s->steppers == NULL ? -1 : 0;
}

/* --- in lanes --- */

/* The tables of the group that a member is in, and its lane in them. */
static double *em_steppers_of(const em_steppers *s, double *table, size_t member, int numbers) {
    return table + member / (size_t)s->width * (size_t)s->width * (size_t)numbers;
}

/* Copies x and v (n) of a member out of its lane: y is x, xdot. */
static void em_steppers_copy_out(em_steppers *s, size_t member) {
    const int n = s->model->n, lane = (int)(member % (size_t)s->width);
    const double *const y = em_steppers_of(s, s->Y, member, s->model->n_state);
    em_lane_out(s->width, lane, n, y, s->x + member * (size_t)n);
    em_lane_out(s->width, lane, n, y + n * s->width, s->v + member * (size_t)n);
}

static void em_steppers_put(em_steppers *s, size_t member, double t, const double *y, const double *c) {
    const em_model *const model = s->model;
    const int lane = (int)(member % (size_t)s->width);
    em_lane_in(s->width, lane, model->n_state, y, em_steppers_of(s, s->Y, member, model->n_state));
    em_lane_in(s->width, lane, model->n_prepared, c, em_steppers_of(s, s->C, member, model->n_prepared + 1));
    s->t[member] = t;
    em_steppers_copy_out(s, member);
}

/* Changes parameters of rotations that are too large after a step (em_chart_change.h). y: as in em_steppers_copy_out */
static void em_steppers_change_chart(em_steppers *s, int lane, double *y) {
    const int n = s->model->n;
    double x[n], v[n];
    em_lane_out(s->width, lane, n, y, x);
    em_lane_out(s->width, lane, n, y + n * s->width, v);
    if (!em_turn_to_shadow(s->model, x, v)) return;
    em_lane_in(s->width, lane, n, x, y);
    em_lane_in(s->width, lane, n, v, y + n * s->width);
}

/* Accepts the step of one lane, or ends its member. Returns whether the member has not reached its target time. */
static int em_steppers_take_step(em_steppers *s, em_fixed_steps *w, size_t member, double t_goal, double *y) {
    const int lane = (int)(member % (size_t)s->width), n = s->model->n_state;
    s->n_rhs[member] += w->rk->stages;
    if (w->sound[lane] != 0.0 && em_fixed_alone(w, lane, y, &s->fault[member])) {
        s->ended[member] = 1;
        return 0;
    }
    for (int k = 0; k < n; ++k) y[k * s->width + lane] = w->y_new[k * s->width + lane];
    if (s->model->n_rotations > 0) em_steppers_change_chart(s, lane, y);
    s->t[member] = w->t_new[lane];
    ++s->n_steps[member];
    return s->t[member] != t_goal;
}

/* Whether an end is requested; calls poll at most every 20 ms. */
static int em_steppers_stopped(const em_steppers *s, struct timespec *polled) {
    struct timespec now;
    if (*s->stop) return 1;
    if (s->task.poll == NULL) return 0;
    timespec_get(&now, TIME_UTC);
    const double seconds = difftime(now.tv_sec, polled->tv_sec) + 1e-9 * (double)(now.tv_nsec - polled->tv_nsec);
    if (fabs(seconds) < 0.02) return 0;
    *polled = now;
    return s->task.poll(s->task.poll_argument);
}

/* Stops the members of a group: for now, or for good. */
static int em_steppers_stop_group(em_steppers *s, size_t first, int *live, em_status status) {
    for (int lane = 0; lane < s->width; ++lane) {
        if (!live[lane]) continue;
        s->fault[first + (size_t)lane] = (em_fault){status, -1, -1, 0.0};
        s->ended[first + (size_t)lane] = status != EM_INTERRUPTED;
        live[lane] = 0;
    }
    return 0;
}

/* Advances one group to its members' times. */
static void em_steppers_group(em_steppers *s, em_fixed_steps *w, size_t first, const double *t_goal,
                              struct timespec *polled) {
    enum { STEPS_PER_POLL = 256 };
    const em_model *const model = s->model;
    const int width = s->width;
    double *const y = em_steppers_of(s, s->Y, first, model->n_state), *const u = em_steppers_of(s, s->U, first, model->n_inputs + 1);
    int live[EM_MOST_LANES] = {0}, n_live = 0;
    w->c = em_steppers_of(s, s->C, first, model->n_prepared + 1), w->u = u;
    for (int lane = 0; lane < width && first + (size_t)lane < s->count; ++lane) {
        const size_t member = first + (size_t)lane;
        live[lane] = !s->ended[member] && s->t[member] != t_goal[member];
        if (live[lane]) s->fault[member] = (em_fault){EM_FINISHED, -1, -1, 0.0};
        n_live += live[lane];
        em_lane_in(width, lane, model->n_inputs, s->u + member * (size_t)model->n_inputs, u);
    }
    for (long step = 1; n_live > 0; ++step) {
        for (int lane = 0; lane < width; ++lane) {
            w->t[lane] = first + (size_t)lane < s->count ? s->t[first + (size_t)lane] : 0.0;
            w->h[lane] = 0.0;
            if (live[lane]) em_fixed_aim(w, lane, t_goal[first + (size_t)lane]);
        }
        em_fixed_step(w, y);
        for (int lane = 0; lane < width; ++lane)
            if (live[lane] && !em_steppers_take_step(s, w, first + (size_t)lane, t_goal[first + (size_t)lane], y))
                live[lane] = 0, --n_live;
        if (n_live > 0 && step >= s->task.max_steps) n_live = em_steppers_stop_group(s, first, live, EM_TOO_MANY_STEPS);
        if (n_live > 0 && step % STEPS_PER_POLL == 0 && em_steppers_stopped(s, polled))
            n_live = em_steppers_stop_group(s, first, live, EM_INTERRUPTED);
    }
    for (int lane = 0; lane < width && first + (size_t)lane < s->count; ++lane)
        em_steppers_copy_out(s, first + (size_t)lane);
}

/* --- one by one --- */

/* Copies the state of a member's stepper to the member's rows. */
static void em_steppers_read(em_steppers *s, size_t member) {
    const em_stepper *const one = s->steppers[member];
    const size_t n = (size_t)s->model->n;
    s->t[member] = one->t;
    memcpy(s->x + member * n, one->x, n * sizeof *s->x);
    memcpy(s->v + member * n, one->v, n * sizeof *s->v);
    s->n_rhs[member] = one->run.n_rhs;
    s->n_steps[member] = one->run.n_steps;
    s->fault[member] = one->run.fault;
    s->ended[member] = one->run.fault.status != EM_FINISHED && one->run.fault.status != EM_INTERRUPTED;
}

/* Moves a member from the end of its last step back to the terminal event within it: `row` (n_state) at t. Its
 * counts are kept, but not its step size and history: it does not continue from there. */
static void em_steppers_move_to_event(em_steppers *s, size_t member, double t, const double *row) {
    em_stepper *const one = s->steppers[member];
    const int events = s->model->n_events;
    const double *const c = one->run.prepared == one->c ? NULL : one->run.prepared;
    size_t counts[events];
    for (int k = 0; k < events; ++k) counts[k] = one->run.events[k].count;
    em_stepper_begin(one, t, row, c, NULL);
    for (int k = 0; k < events; ++k) one->run.events[k].count = counts[k];
    const long n_rhs = s->n_rhs[member], n_steps = s->n_steps[member];
    em_steppers_read(s, member);
    s->fault[member] = (em_fault){EM_TERMINAL_EVENT, -1, -1, 0.0};
    s->ended[member] = 1;
    s->n_rhs[member] = n_rhs;
    s->n_steps[member] = n_steps;
}

/* Moves a member that ended at an event to that event. */
static void em_steppers_end_at_event(em_steppers *s, size_t member) {
    const em_run *const run = &s->steppers[member]->run;
    if (run->fault.status != EM_TERMINAL_EVENT || run->t_reached == s->t[member]) return;
    for (int k = 0; k < s->model->n_events; ++k) {
        const em_rows *const rows = &run->events[k];
        if (!run->event_terminal[k] || rows->count == 0 || rows->t[rows->count - 1] != run->t_reached) continue;
        em_steppers_move_to_event(s, member, run->t_reached, rows->y + (rows->count - 1) * rows->width);
        return;
    }
}

static void em_steppers_one(em_steppers *s, size_t member, double t_goal) {
    em_stepper *const one = s->steppers[member];
    for (int k = 0; one->run.events != NULL && k < s->model->n_events; ++k) one->run.events[k].count = 0;
    if (s->ended[member]) return;
    em_stepper_advance(one, t_goal, s->u + member * (size_t)s->model->n_inputs);
    em_steppers_read(s, member);
    em_steppers_end_at_event(s, member);
}

/* Starts a member: y (n_state), published; c (n_prepared); its inputs are those of s->u. Allocates memory the first
 * time only. 0, or -1 without memory; s->ended says whether the motion can start. */
static int em_steppers_begin(em_steppers *s, size_t member, double t, const double *y, const double *c) {
    const double *const u = s->u + member * (size_t)s->model->n_inputs;
    s->ended[member] = 0;
    s->fault[member] = (em_fault){EM_FINISHED, -1, -1, 0.0};
    s->n_rhs[member] = s->n_steps[member] = 0;
    if (s->steppers == NULL) return em_steppers_put(s, member, t, y, c), 0;
    if (s->steppers[member] != NULL) em_stepper_begin(s->steppers[member], t, y, c, u);
    else {
        em_run run = s->task;
        run.t_start = t, run.y_start = y, run.prepared = c;
        em_stepper *const one = s->steppers[member] = em_stepper_open(s->model, &run, u);
        if (one == NULL) return -1;
        one->run.event_terminal = s->model->event_terminal;
    }
    em_steppers_read(s, member);
    return 0;
}

/* --- all --- */

/* Advances members first ... last - 1 to t_goal (count), with the scratch of this worker; `first` is a multiple of
 * EM_MOST_LANES. */
static void em_steppers_advance(em_steppers *s, size_t first, size_t last, int worker, const double *t_goal) {
    struct timespec polled;
    timespec_get(&polled, TIME_UTC);
    if (s->steppers != NULL) {
        for (size_t member = first; member < last && !em_steppers_stopped(s, &polled); ++member)
            em_steppers_one(s, member, t_goal[member]);
        return;
    }
    const em_tableau *const rk = s->task.method == EM_RK4 ? &EM_RK4_TABLEAU : &EM_MIDPOINT_TABLEAU;
    double *const place = s->scratch + em_fixed_numbers(s->model) * (size_t)worker;
    em_fixed_steps w = em_fixed_at(s->model, rk, s->width, s->task.first_step, place);
    const uint64_t subnormals = em_flush_subnormals();
    for (size_t member = first; member < last && !em_steppers_stopped(s, &polled); member += (size_t)s->width)
        em_steppers_group(s, &w, member, t_goal, &polled);
    em_restore_subnormals(subnormals);
}

/* The constants of a member in its current contact mode. c (n_prepared): memory for them */
static const double *em_steppers_constants(const em_steppers *s, size_t member, double *c) {
    if (s->steppers != NULL) return s->steppers[member]->run.prepared;
    em_lane_out(s->width, (int)(member % (size_t)s->width), s->model->n_prepared,
                em_steppers_of(s, s->C, member, s->model->n_prepared + 1), c);
    return c;
}

/* y (n_state) of a member in the published meaning. 0, or -1 and *fault */
static int em_steppers_state(const em_steppers *s, size_t member, double *y, em_fault *fault) {
    if (s->steppers != NULL) return s->model->publish(s->steppers[member]->run_state, y, fault);
    em_lane_out(s->width, (int)(member % (size_t)s->width), s->model->n_state,
                em_steppers_of(s, s->Y, member, s->model->n_state), y);
    return 0;
}

#endif
