/* em_members.h: tasks and results of many runs of one em_model, and a driver that computes them one after the other. */
#ifndef EM_MEMBERS_H
#define EM_MEMBERS_H

#include <stdlib.h>
#include <time.h>

#include "loop/em_start_check.h"

enum { EM_COUNTS = 7 };

/* `count` members. Data that differ between members have a row for each; a stride of 0 means one row shared by all. */
typedef struct em_ensemble {
    const em_model *model;
    em_run task;               /* the task of every run; prepared, y_start and inputs are the member's */
    size_t count, n_rows;
    const double *parameters, *x, *v; /* rows of n_parameters, n, n */
    const em_signal *inputs;          /* rows of n_inputs */
    size_t parameters_stride, x_stride, v_stride, inputs_stride; /* in numbers, or signals */
    const unsigned char *skip; /* (count) 1: already refused */
    int end_only;              /* record only the row at the end of a run: at t_eval, or earlier if an event ends it */
    const volatile int *stop;  /* the caller sets it to 1 to request an end */

    double *y;                 /* (count, n_rows, n_state), in: NaN; published meaning */
    double *t_end;             /* (count) the time that the run reached */
    em_fault *fault;           /* (count) how it ended */
    long *counts;              /* (count, EM_COUNTS) right-hand sides, steps, rejected ones, those with another root,
                                  stiff ones, Jacobians, factorisations */
    em_rows events;            /* of all members, in the order in which they ended */
    long *event_starts;        /* (count, n_events) index of the first row of a member's event, */
    long *event_counts;        /* and the number of its rows */
    struct timespec polled;
} em_ensemble;

/* Whether an end is requested. Long runs also check that themselves (em_termination.h). */
static int em_ensemble_stopped(em_ensemble *e) {
    struct timespec now;
    if (*e->stop) return 1;
    if (e->task.poll == NULL) return 0;
    timespec_get(&now, TIME_UTC);
    const double seconds = difftime(now.tv_sec, e->polled.tv_sec) + 1e-9 * (double)(now.tv_nsec - e->polled.tv_nsec);
    if (fabs(seconds) < 0.02) return 0;
    e->polled = now;
    return e->task.poll(e->task.poll_argument);
}

/* Appends all rows of another table to events. 0, or -1 without memory */
static int em_ensemble_append(em_rows *all, const em_rows *rows) {
    const size_t count = all->count + rows->count, width = rows->width;
    if (count > all->capacity) {
        const size_t capacity = count > 2 * all->capacity ? count : 2 * all->capacity;
        double *const t = realloc(all->t, capacity * sizeof *t);
        if (t == NULL) return -1;
        all->t = t;
        double *const y = realloc(all->y, capacity * width * sizeof *y);
        if (y == NULL) return -1;
        all->y = y;
        all->capacity = capacity;
    }
    memcpy(all->t + all->count, rows->t, rows->count * sizeof *rows->t);
    memcpy(all->y + all->count * width, rows->y, rows->count * width * sizeof *rows->y);
    all->count = count;
    return 0;
}

/* The row of the terminal event that ended a run, or NULL. */
static const double *em_ensemble_last_event(const em_model *model, const em_run *run) {
    for (int k = 0; k < model->n_events; ++k) {
        const em_rows *rows = &run->events[k];
        if (model->event_terminal[k] && rows->count && rows->t[rows->count - 1] == run->t_reached)
            return rows->y + (rows->count - 1) * rows->width;
    }
    return NULL;
}

/* Stores the results of a run in the rows of its member. */
static void em_ensemble_keep(em_ensemble *e, size_t member, const em_run *run) {
    const em_model *model = e->model;
    const size_t width = (size_t)model->n_state;
    double *const y = e->y + member * e->n_rows * width;
    const long counts[EM_COUNTS] = {run->n_rhs, run->n_steps, run->n_rejected, run->n_bounded, run->n_stiff,
                                    run->n_jacobians, run->n_factors};
    if (run->rows.count) memcpy(y, run->rows.y, run->rows.count * width * sizeof *y);
    if (e->end_only && run->fault.status == EM_TERMINAL_EVENT && run->rows.count == 0) {
        const double *const row = em_ensemble_last_event(model, run);
        if (row != NULL) memcpy(y, row, width * sizeof *y);
    }
    e->t_end[member] = run->t_reached;
    e->fault[member] = run->fault;
    memcpy(e->counts + EM_COUNTS * member, counts, sizeof counts);
    for (int k = 0; run->events != NULL && k < model->n_events; ++k) {
        const em_rows *rows = &run->events[k];
        if (rows->count == 0) continue;
        const size_t place = member * (size_t)model->n_events + (size_t)k;
        e->event_starts[place] = (long)e->events.count;
        if (em_ensemble_append(&e->events, rows)) e->fault[member].status = EM_OUT_OF_MEMORY;
        else e->event_counts[place] = (long)rows->count;
    }
}

/* c (n_prepared), y (n_state) <- of a member at its start. 0, or -1 and *fault */
static int em_ensemble_start(const em_ensemble *e, size_t member, double *c, double *y, em_fault *fault) {
    const em_model *model = e->model;
    if (e->skip[member]) return em_fail(fault, EM_START_REFUSED, -1, -1, 0.0);
    if (model->prepare(e->parameters + member * e->parameters_stride, c, fault))
        return em_fail(fault, EM_START_REFUSED, -1, -1, 0.0);
    memset(y, 0, (size_t)model->n_state * sizeof *y);
    const double *const x = e->x + member * e->x_stride, *const v = e->v + member * e->v_stride;
    const int refusal = em_start(model, e->task.t_start, x, v, c, e->task.rtol, e->task.atol, y, NULL, NULL);
    return refusal == EM_MAY_START ? 0 : em_fail(fault, EM_START_REFUSED, -1, -1, 0.0);
}

/* Runs one member by the model's own stepper. c (n_prepared), y (n_state): scratch */
static void em_ensemble_member(em_ensemble *e, size_t member, double *c, double *y) {
    em_run run = e->task;
    run.t_reached = run.t_start;
    run.fault = (em_fault){EM_INTERRUPTED, -1, -1, 0.0};
    if (!em_ensemble_stopped(e) && em_ensemble_start(e, member, c, y, &run.fault) == 0) {
        run.prepared = c;
        run.y_start = y;
        run.inputs = e->inputs ? e->inputs + member * e->inputs_stride : NULL;
        e->model->simulate(&run);
    }
    em_ensemble_keep(e, member, &run);
    e->model->release(&run);
}

/* Runs members first ... last - 1 by the scalar code. 0, or -1 without memory. */
static int em_ensemble_scalar(em_ensemble *e, size_t first, size_t last) {
    const size_t width = (size_t)e->model->n_prepared + 1, states = (size_t)e->model->n_state;
    double *const memory = malloc((width + states) * sizeof *memory);
    if (memory == NULL) return -1;
    for (size_t member = first; member < last; ++member) em_ensemble_member(e, member, memory, memory + width);
    free(memory);
    return 0;
}

#endif
