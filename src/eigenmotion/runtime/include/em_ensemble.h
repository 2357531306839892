/* em_ensemble.h: many runs of one em_model, member by member, into tables that the caller owns.
 *
 * For the runtime, not for generated code. Members know nothing of each other: what comes of one does not depend on which
 * others run beside it, in which order, or on how many threads. */
#ifndef EM_ENSEMBLE_H
#define EM_ENSEMBLE_H

#include <stdint.h>
#include <stdlib.h>
#include <time.h>

#include "em_start.h"

enum { EM_COUNTS = 5 };

/* `count` members. Of what differs from member to member each has its row; a stride of 0 is a row that all share. */
typedef struct em_ensemble {
    const em_model *model;
    em_run task;               /* what is asked of every run; prepared, y_start and inputs are the member's */
    size_t count, n_rows;
    const double *parameters, *x, *v; /* rows of n_parameters, n, n */
    const em_signal *inputs;          /* rows of n_inputs */
    size_t parameters_stride, x_stride, v_stride, inputs_stride; /* in numbers, or signals */
    const unsigned char *skip; /* (count) 1: refused already */
    int end_only;              /* rows are where runs end: at t_eval, or before where an event ends them */
    const volatile int *stop;  /* set to 1 by whoever wants an end */

    double *y;                 /* (count, n_rows, n_state), in: NaN; published meaning */
    double *t_end;             /* (count) where the run came to */
    em_fault *fault;           /* (count) how it ended */
    long *counts;              /* (count, EM_COUNTS) right-hand sides, steps, rejected ones, those of another root, stiff ones */
    em_rows events;            /* of all members, in the order in which they ended */
    long *event_starts;        /* (count, n_events) where those of a member's event begin, */
    long *event_counts;        /* and how many they are */
    struct timespec polled;
} em_ensemble;

/* Whether somebody wants an end. Runs that take long ask themselves (em_end.h). */
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

/* events <- with all rows of another table. 0, or -1 without memory */
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

/* What came of a run, into the rows of its member. */
static void em_ensemble_keep(em_ensemble *e, size_t member, const em_run *run) {
    const em_model *model = e->model;
    const size_t width = (size_t)model->n_state;
    double *const y = e->y + member * e->n_rows * width;
    const long counts[EM_COUNTS] = {run->n_rhs, run->n_steps, run->n_rejected, run->n_bounded, run->n_stiff};
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
    if (em_start(model, e->task.t_start, x, v, c, e->task.rtol, e->task.atol, y)) return 0;
    return em_fail(fault, EM_START_REFUSED, -1, -1, 0.0);
}

/* One member by the model's own stepper. c (n_prepared), y (n_state): to work with */
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

/* Members first ... last - 1. 0, or -1 without memory. */
static int em_ensemble_by_numbers(em_ensemble *e, size_t first, size_t last) {
    const size_t width = (size_t)e->model->n_prepared + 1, states = (size_t)e->model->n_state;
    double *const memory = malloc((width + states) * sizeof *memory);
    if (memory == NULL) return -1;
    for (size_t member = first; member < last; ++member) em_ensemble_member(e, member, memory, memory + width);
    free(memory);
    return 0;
}

/* --- side by side (em_flock.h) --- */

/* The runs in lanes: of each its member, and what it works with. */
typedef struct em_ensemble_flock {
    em_ensemble *e;
    em_run runs[EM_MOST_LANES];
    void *walks[EM_MOST_LANES];
    size_t member[EM_MOST_LANES], next;
    double *c[EM_MOST_LANES], *y[EM_MOST_LANES];
} em_ensemble_flock;

/* Whether runs of this task are made in lanes. That follows from the task and the model, so that all members' are. */
static int em_ensemble_has_lanes(const em_ensemble *e) {
    const em_model *model = e->model;
    if (model->enter == NULL || model->lanes == NULL || model->lanes->run == NULL || model->lanes->width < 2) return 0;
    if (e->task.method != EM_DOP853 || model->lanes->width > EM_MOST_LANES) return 0;
    return model->m == 0 || (e->task.stabilise && !e->task.least_norm);
}

/* Whether a member's inputs rest, as those of lanes do. */
static int em_ensemble_rests(const em_ensemble *e, size_t member) {
    const em_signal *inputs = e->inputs ? e->inputs + member * e->inputs_stride : NULL;
    for (int k = 0; k < e->model->n_inputs; ++k)
        if (inputs[k].kind != EM_CONSTANT) return 0;
    return 1;
}

/* A member into a lane. Returns whether it runs there; else all that came of it is kept already. */
static int em_ensemble_enter(em_ensemble_flock *w, em_flock *f, int lane, size_t member) {
    em_ensemble *const e = w->e;
    em_run *const run = &w->runs[lane];
    *run = e->task;
    if (!em_ensemble_stopped(e) && em_ensemble_rests(e, member) &&
        em_ensemble_start(e, member, w->c[lane], w->y[lane], &run->fault) == 0) {
        run->prepared = w->c[lane];
        run->y_start = w->y[lane];
        run->inputs = e->inputs ? e->inputs + member * e->inputs_stride : NULL;
        w->walks[lane] = e->model->enter(run, f, lane);
        w->member[lane] = member;
        if (w->walks[lane] != NULL) return 1;
        e->model->release(run);
    }
    em_ensemble_member(e, member, w->c[lane], w->y[lane]);
    return 0;
}

/* The next member that runs in a lane. */
static void em_ensemble_fill(em_ensemble_flock *w, em_flock *f, int lane) {
    f->live[lane] = 0;
    while (!f->live[lane] && w->next < w->e->count) f->live[lane] = em_ensemble_enter(w, f, lane, w->next++);
    f->n_live += f->live[lane];
    if (f->live[lane]) return;
    f->t[lane] = f->task->t_end; /* an empty lane stands still */
    f->h_next[lane] = 0.0;
}

/* em_flock.look */
static int em_ensemble_look(em_flock *f, int lane, int lost) {
    em_ensemble_flock *const w = f->with;
    em_ensemble *const e = w->e;
    const int ended = lost ? -1 : e->model->look(w->walks[lane], f, lane);
    if (ended == 0) return 0;
    e->model->close(w->walks[lane]);
    if (ended > 0) em_ensemble_keep(e, w->member[lane], &w->runs[lane]);
    e->model->release(&w->runs[lane]);
    if (ended < 0) em_ensemble_member(e, w->member[lane], w->c[lane], w->y[lane]);
    --f->n_live;
    em_ensemble_fill(w, f, lane);
    return 1;
}

static int em_ensemble_all_stop(em_flock *f) { return em_ensemble_stopped(((em_ensemble_flock *)f->with)->e); }

/* Runs that were on their way when an end was asked for. */
static void em_ensemble_give_up(em_ensemble_flock *w, em_flock *f) {
    for (int lane = 0; lane < EM_MOST_LANES; ++lane) {
        if (!f->live[lane]) continue;
        em_run *const run = &w->runs[lane];
        run->fault = (em_fault){EM_INTERRUPTED, -1, -1, 0.0};
        run->t_reached = f->t[lane];
        w->e->model->close(w->walks[lane]);
        em_ensemble_keep(w->e, w->member[lane], run);
        w->e->model->release(run);
    }
    while (w->next < w->e->count) em_ensemble_member(w->e, w->next++, w->c[0], w->y[0]);
}

/* Tables of a flock, one after the other in one block of memory, and what each lane's run starts from. */
static double *em_ensemble_tables(em_ensemble_flock *w, em_flock *f) {
    enum { LINE = 8, STAGES = 12, ROWS = 16 };
    const em_model *model = w->e->model;
    const size_t width = (size_t)model->lanes->width, c = (size_t)model->n_prepared + 1, n = (size_t)model->n_state;
    const size_t states = (n + 3) / 4 * 4, inputs = (size_t)model->n_inputs + 1;
    const size_t rows = (STAGES + 3) * states + c + inputs + ROWS;
    double *const block = calloc(rows * width + LINE + EM_MOST_LANES * (c + n), sizeof *block);
    if (block == NULL) return NULL;
    double *place = (double *)(((uintptr_t)block + LINE * sizeof *block - 1) / (LINE * sizeof *block) * (LINE * sizeof *block));
    double **const tables[] = {&f->K, &f->y, &f->y_new, &f->f_new, &f->c, &f->u};
    const size_t sizes[] = {STAGES * states, states, states, states, c, inputs};
    double **const numbers[ROWS] = {&f->t, &f->t_new, &f->h, &f->h_next, &f->error, &f->last_error, &f->longest, &f->n_steps,
                                    &f->n_rejected, &f->retries, &f->n_rhs, &f->stiff, &f->n_stiff, &f->next_judge,
                                    &f->next_look, &f->t_look};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; ++k) *tables[k] = place, place += sizes[k] * width;
    for (int k = 0; k < ROWS; ++k) *numbers[k] = place, place += width;
    for (int lane = 0; lane < EM_MOST_LANES; ++lane) {
        w->c[lane] = place, place += c;
        w->y[lane] = place, place += n;
    }
    return block;
}

/* All members in lanes, as far as they can. 0, or -1 without memory. */
static int em_ensemble_in_lanes(em_ensemble *e) {
    em_ensemble_flock w = {.e = e};
    em_flock f = {.task = &e->task, .look = em_ensemble_look, .stopped = em_ensemble_all_stop, .with = &w};
    double *const block = em_ensemble_tables(&w, &f);
    if (block == NULL) return -1;
    f.rtol = e->task.rtol > 100.0 * DBL_EPSILON ? e->task.rtol : 100.0 * DBL_EPSILON;
    f.direction = e->task.t_end < e->task.t_start ? -1.0 : 1.0;
    f.always = e->model->n_events > 0 || f.rtol > 1e-5; /* EM_LOOSE of em_chart.h */
    for (int lane = 0; lane < e->model->lanes->width; ++lane) em_ensemble_fill(&w, &f, lane);
    if (f.n_live > 0) e->model->lanes->run(&f);
    em_ensemble_give_up(&w, &f);
    free(block);
    return 0;
}

/* All of them. 0, or -1 without memory. */
static int em_ensemble_run(em_ensemble *e) {
    timespec_get(&e->polled, TIME_UTC);
    return em_ensemble_has_lanes(e) ? em_ensemble_in_lanes(e) : em_ensemble_by_numbers(e, 0, e->count);
}

#endif
