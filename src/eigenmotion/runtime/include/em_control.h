/* em_control.h: the C stepper for control loops: em_stepper_open, _advance, _save, _restore, _close.
 *
 *     em_stepper *s = em_stepper_open(&NAME_model, &task, u);
 *     while (!em_stepper_advance(s, s->t + 0.001, u)) u[0] = controller(s->t, s->x, s->v);
 *     em_stepper_close(s);
 *
 * All memory is allocated as a stepper opens. Steppers are independent: any number may be open, each used by one
 * thread at a time. If an advance fails, s->run.fault says why. The stepper then stays at the last state it reached:
 * t, x, v are there, and the next advance continues from it. */
#ifndef EM_CONTROL_H
#define EM_CONTROL_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "eigenmotion.h"

typedef struct em_stepper {
    const em_model *model;
    double t, *x, *v;    /* the current state: x, v (n) */
    double *u;           /* (n_inputs) values of those inputs that are constant */
    em_run run;          /* the task, the counts, the fault of the last advance, the event crossings in it */
    em_signal *inputs;   /* (n_inputs) */
    double *start, *c;   /* the state (n_state) and the constants (n_prepared) at the start */
    void *run_state;
} em_stepper;

enum { EM_EVENTS_KEPT = 64 }; /* crossings kept of one event in one advance; the last replaces any further ones */

static inline void em_stepper_close(em_stepper *s) {
    if (s == NULL) return;
    if (s->run_state != NULL) s->model->close(s->run_state);
    s->model->release(&s->run);
    free(s);
}

/* Allocates a table of fixed size. 0, or -1 without memory. */
static inline int em_stepper_allocate_rows(em_rows *rows) {
    rows->t = calloc(EM_EVENTS_KEPT, sizeof *rows->t);
    rows->y = calloc(EM_EVENTS_KEPT * rows->width, sizeof *rows->y);
    rows->capacity = rows->most = EM_EVENTS_KEPT;
    return rows->t == NULL || rows->y == NULL ? -1 : 0;
}

/* Allocates tables of events, of fixed size; of the modes only the last is kept. 0, or -1 without memory. */
static inline int em_stepper_allocate_tables(em_stepper *s) {
    s->run.segments.most = 1;
    for (int k = 0; s->run.events != NULL && k < s->model->n_events; ++k)
        if (em_stepper_allocate_rows(&s->run.events[k]) || em_stepper_allocate_rows(&s->run.after[k])) return -1;
    return 0;
}

/* Copies the task next to the stepper, in one block with it: numbers (doubles), and the inputs. */
static inline em_stepper *em_stepper_copy(const em_model *model, const em_run *task, const double *u) {
    const size_t n = (size_t)model->n, states = (size_t)model->n_state, c = (size_t)model->n_prepared;
    const size_t inputs = (size_t)model->n_inputs, numbers = 3 * n + states + c + inputs;
    const size_t events = (size_t)model->n_events;
    em_stepper *s = calloc(1, sizeof *s + inputs * sizeof(em_signal) + numbers * sizeof(double) + events * sizeof(int));
    if (s == NULL) return NULL;
    s->inputs = (em_signal *)(s + 1);
    double *place = (double *)(s->inputs + inputs);
    s->x = place, s->v = place + n, s->u = place + 2 * n;
    double *const atol = s->u + inputs, *const y = atol + n, *const prepared = y + states;
    s->model = model;
    s->run = *task;
    s->run.atol = memcpy(atol, task->atol, n * sizeof *atol);
    s->run.y_start = s->start = memcpy(y, task->y_start, states * sizeof *y);
    if (c > 0) memcpy(prepared, task->prepared, c * sizeof *prepared);
    s->run.prepared = s->c = prepared;
    s->run.event_terminal = (int *)(prepared + c); /* no event is terminal: the caller of the stepper decides */
    s->run.event_direction = model->event_direction;
    s->run.inputs = s->inputs;
    for (size_t k = 0; k < inputs; ++k) {
        s->inputs[k] = task->inputs != NULL ? task->inputs[k] : (em_signal){EM_CONSTANT, 0, NULL, NULL};
        if (s->inputs[k].kind != EM_CONSTANT) continue;
        s->u[k] = u != NULL ? u[k] : s->inputs[k].values != NULL ? s->inputs[k].values[0] : model->input_defaults[k];
        s->inputs[k].values = &s->u[k];
    }
    return s;
}

/* A stepper at task->t_start and y_start, with any method; a method of fixed step takes task->first_step as its
 * step. u (n_inputs): the inputs, or NULL: those of the task, or the model's defaults. Rows, end and dense output of
 * the task have no effect here. NULL without memory; otherwise s->run.fault.status is EM_FINISHED, or says why the
 * motion cannot start. Samples of inputs and the model remain the caller's. */
static inline em_stepper *em_stepper_open(const em_model *model, const em_run *task, const double *u) {
    em_stepper *s = em_stepper_copy(model, task, u);
    if (s == NULL) return NULL;
    s->run.t_end = INFINITY;
    s->run.t_eval = &s->run.t_start; /* none of them: no rows are kept */
    s->run.n_t_eval = 0;
    s->run.dense = 0;
    s->run_state = model->open(&s->run);
    if (s->run_state == NULL || em_stepper_allocate_tables(s)) return em_stepper_close(s), NULL;
    s->t = model->now(s->run_state, s->x, s->v);
    return s;
}

/* Restarts at another state, as if opened there: y (n_state) at t, with these constants and inputs; NULL: as they
 * were. Allocates nothing. Returns s->run.fault.status. */
static inline int em_stepper_begin(em_stepper *s, double t, const double *y, const double *prepared, const double *u) {
    const em_model *model = s->model;
    if (y != NULL) memcpy(s->start, y, (size_t)model->n_state * sizeof *y);
    if (prepared != NULL && model->n_prepared > 0) memcpy(s->c, prepared, (size_t)model->n_prepared * sizeof *prepared);
    for (int k = 0; u != NULL && k < model->n_inputs; ++k)
        if (s->inputs[k].kind == EM_CONSTANT) s->u[k] = u[k];
    s->run.t_start = t;
    s->run.prepared = s->c;
    model->again(s->run_state);
    s->t = model->now(s->run_state, s->x, s->v);
    return (int)s->run.fault.status;
}

/* Whether u (n_inputs) changes an input. Inputs that are signals stay signals. */
static inline int em_stepper_set(em_stepper *s, const double *u) {
    int jumped = 0;
    for (int k = 0; k < s->model->n_inputs; ++k) {
        if (s->inputs[k].kind != EM_CONSTANT || u[k] == s->u[k]) continue;
        s->u[k] = u[k];
        jumped = 1;
    }
    return jumped;
}

/* Advances to t exactly, forwards or, if no event acts, backwards, with inputs u (n_inputs) from here on; NULL: as
 * they are. 0, or -1 and s->run.fault. */
static inline int em_stepper_advance(em_stepper *s, double t, const double *u) {
    if (!isfinite(t)) {
        s->run.fault = (em_fault){EM_NON_FINITE_STATE, -1, -1, t};
        return -1;
    }
    const int jumped = u != NULL && em_stepper_set(s, u);
    for (int k = 0; s->run.events != NULL && k < s->model->n_events; ++k)
        s->run.events[k].count = s->run.after[k].count = 0;
    const int failed = s->model->advance(s->run_state, t, jumped);
    s->t = s->model->now(s->run_state, s->x, s->v);
    return failed;
}

/* The number of bytes that em_stepper_save needs. */
static inline size_t em_stepper_size(const em_stepper *s) {
    return s->model->saved() + (size_t)s->model->n_inputs * sizeof(double);
}

/* Saves the whole motion. After em_stepper_restore every number is reproduced to the last bit, in the same program
 * and by a stepper of the same task. */
static inline void em_stepper_save(const em_stepper *s, void *saved) {
    s->model->save(s->run_state, saved);
    memcpy((char *)saved + s->model->saved(), s->u, (size_t)s->model->n_inputs * sizeof(double));
}

static inline void em_stepper_restore(em_stepper *s, const void *saved) {
    s->model->restore(s->run_state, saved);
    memcpy(s->u, (const char *)saved + s->model->saved(), (size_t)s->model->n_inputs * sizeof(double));
    s->t = s->model->now(s->run_state, s->x, s->v);
}

#endif
