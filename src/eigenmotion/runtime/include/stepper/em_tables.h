/* em_tables.h: the tables that a run fills, which grow by doubling, and their release. */
#ifndef EM_TABLES_H
#define EM_TABLES_H

#include <stdint.h>
#include <stdlib.h>

#include "numeric/em_linear.h"

/* *table <- room for `rows` rows of `width` numbers each. 0, or -1 without memory; *table stays valid. */
EM_NOINLINE int em_resize(double **table, size_t rows, size_t width, em_fault *fault) {
    double *larger = NULL;
    if (rows <= SIZE_MAX / sizeof **table / width) larger = realloc(*table, rows * width * sizeof **table);
    if (larger == NULL) return em_fail(fault, EM_OUT_OF_MEMORY, -1, -1, (double)rows);
    *table = larger;
    return 0;
}

EM_NOINLINE int em_rows_grow(em_rows *rows, em_fault *fault) {
    const size_t capacity = rows->capacity > 0 ? 2 * rows->capacity : 64;
    if (em_resize(&rows->t, capacity, 1, fault)) return -1;
    if (em_resize(&rows->y, capacity, rows->width, fault)) return -1;
    rows->capacity = capacity;
    return 0;
}

/* The row after the last one. The caller fills it and then counts it by em_rows_keep. NULL without memory. */
static double *em_rows_next(em_rows *rows, em_fault *fault) {
    if (rows->most > 0 && rows->count == rows->most) --rows->count;
    if (rows->count == rows->capacity && em_rows_grow(rows, fault)) return NULL;
    return rows->y + rows->count * rows->width;
}

static void em_rows_keep(em_rows *rows, double t) { rows->t[rows->count++] = t; }

EM_NOINLINE int em_dense_grow(em_run *run, size_t n_state, em_fault *fault) {
    const size_t capacity = run->dense_capacity > 0 ? 2 * run->dense_capacity : 64;
    em_dense_step *steps = realloc(run->dense_steps, capacity * sizeof *steps);
    if (steps == NULL) return em_fail(fault, EM_OUT_OF_MEMORY, -1, -1, (double)capacity);
    run->dense_steps = steps;
    if (em_resize(&run->dense_table, capacity, EM_DENSE_COEFFICIENTS * n_state, fault)) return -1;
    run->dense_capacity = capacity;
    return 0;
}

/* Keeps the interpolant F (EM_DENSE_COEFFICIENTS, n_state) of one step. */
static int em_dense_keep(em_run *run, size_t n_state, em_dense_step step, const double *F, em_fault *fault) {
    const size_t size = EM_DENSE_COEFFICIENTS * n_state;
    if (run->n_dense == run->dense_capacity && em_dense_grow(run, n_state, fault)) return -1;
    memcpy(run->dense_table + run->n_dense * size, F, size * sizeof *F);
    run->dense_steps[run->n_dense++] = step;
    return 0;
}

/* Empty tables of the run's width. */
static int em_rows_prepare(const em_model *model, em_run *run) {
    const size_t events = (size_t)model->n_events, width = (size_t)model->n_state;
    run->rows.width = run->charts.width = run->last.width = width;
    if (events == 0) return 0;
    run->events = calloc(events, sizeof *run->events);
    if (run->events == NULL) return em_fail(&run->fault, EM_OUT_OF_MEMORY, -1, -1, (double)events);
    run->after = calloc(events, sizeof *run->after);
    if (run->after == NULL) return em_fail(&run->fault, EM_OUT_OF_MEMORY, -1, -1, (double)events);
    for (size_t i = 0; i < events; ++i) run->events[i].width = run->after[i].width = width;
    return 0;
}

static void em_rows_free(em_rows *rows) {
    free(rows->t);
    free(rows->y);
    *rows = (em_rows){0};
}

/* em_model.release: frees what simulate allocated; may be called repeatedly, and after a failed run. */
EM_COLD_PATH EM_EXPORT void em_release(const em_model *model, em_run *run) {
    em_rows_free(&run->rows);
    for (int i = 0; run->events != NULL && i < model->n_events; ++i) em_rows_free(&run->events[i]);
    for (int i = 0; run->after != NULL && i < model->n_events; ++i) em_rows_free(&run->after[i]);
    em_rows_free(&run->charts);
    em_rows_free(&run->last);
    em_rows_free(&run->segments);
    em_rows_free(&run->methods);
    free(run->events);
    free(run->after);
    free(run->dense_steps);
    free(run->dense_table);
    run->events = run->after = NULL;
    run->dense_steps = NULL;
    run->dense_table = NULL;
    run->n_dense = run->dense_capacity = 0;
}

#endif
