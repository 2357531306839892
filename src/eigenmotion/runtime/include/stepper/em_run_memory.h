/* em_run_memory.h: the memory of a run: one block, allocated when the run opens, and the parts of it that are saved. */
#ifndef EM_RUN_MEMORY_H
#define EM_RUN_MEMORY_H

#include <stdint.h>
#include <stdlib.h>

#include "stepper/em_model_calls.h"

enum { EM_LINE = 64 }; /* bytes of a cache line; every table is aligned to one */

/* Allocates tables one after the other; without a base address it only counts their size. */
typedef struct em_layout {
    char *place;
    size_t used;
} em_layout;

static void *em_take_bytes(em_layout *at, size_t bytes) {
    char *const table = at->place ? at->place + at->used : NULL;
    at->used += (bytes + EM_LINE - 1) / EM_LINE * EM_LINE;
    return table;
}

static double *em_take_numbers(em_layout *at, size_t count) { return em_take_bytes(at, count * sizeof(double)); }
static int *em_take_ints(em_layout *at, size_t count) { return em_take_bytes(at, count * sizeof(int)); }

/* rows (count) <- tables of `width` numbers, without gaps */
static void em_take_rows(em_layout *at, double **rows, int count, size_t width) {
    double *const first = em_take_numbers(at, (size_t)count * width);
    for (int i = 0; i < count; ++i) rows[i] = first ? first + (size_t)i * width : NULL;
}

static void em_take_node_vectors(em_layout *at, em_node_vector **rows, size_t width) {
    for (int b = 0; b < EM_NODE_VECTORS; ++b) rows[b] = em_take_bytes(at, width * sizeof(em_node_vector));
}

static void em_lay_out_nodes(em_run_state *w, em_layout *at) {
    em_nodes *const q = &w->nodes;
    const size_t states = (size_t)w->n_state;
    em_take_node_vectors(at, q->Y, states), em_take_node_vectors(at, q->F, states), em_take_node_vectors(at, q->a, states);
    em_take_node_vectors(at, q->series, states), em_take_node_vectors(at, q->before, states);
    em_take_node_vectors(at, q->u, (size_t)w->n_inputs);
    q->times = em_take_bytes(at, EM_NODE_VECTORS * sizeof(em_node_vector));
    q->weight = em_take_numbers(at, states + EM_PACK), q->miss = em_take_numbers(at, states);
}

static void em_lay_out_stages(em_run_state *w, em_layout *at) {
    em_implicit *const q = &w->stages;
    const size_t n = (size_t)w->n, all = EM_MOST_NODES * n, rows = EM_MOST_NODES * (size_t)w->stride;
    q->K = em_take_numbers(at, n * n), q->D = em_take_numbers(at, n * n);
    em_take_rows(at, q->G, 1 + EM_MOST_PAIRS, n * n), em_take_rows(at, q->H, 1 + EM_MOST_PAIRS, n * n);
    for (int p = 0; p <= EM_MOST_PAIRS; ++p) q->pivot[p] = em_take_ints(at, n);
    q->coupled = em_take_numbers(at, all * all), q->coupled_pivot = em_take_ints(at, all);
    q->a = em_take_numbers(at, rows), q->V = em_take_numbers(at, rows), q->X = em_take_numbers(at, rows);
    q->r = em_take_numbers(at, rows), q->last = em_take_numbers(at, rows);
    q->u = em_take_numbers(at, (1 + EM_MOST_NODES) * (size_t)w->n_inputs);
}

static void em_lay_out_events(em_run_state *w, em_layout *at) {
    const size_t events = (size_t)w->n_events;
    double **const numbers[] = {&w->g, &w->g_new, &w->noise, &w->zero, &w->rounding, &w->quiet};
    int **const whole[] = {&w->side, &w->side_new, &w->fired, &w->acted};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) *numbers[i] = em_take_numbers(at, events);
    for (size_t i = 0; i < sizeof whole / sizeof *whole; ++i) *whole[i] = em_take_ints(at, events);
    w->found = em_take_bytes(at, EM_MOST_FOUND * events * sizeof *w->found);
    w->pile = em_take_bytes(at, events * sizeof *w->pile);
}

/* The tables of nodes and of implicit stages are the largest: only methods that need them have them. */
static void em_lay_out(em_run_state *w, em_layout *at) {
    const size_t width = (size_t)w->width, rows = (size_t)w->n_rows, n = (size_t)w->n;
    double **const states[] = {&w->y, &w->y_new, &w->f_new, &w->y_raw, &w->argument, &w->error, &w->weight, &w->spare};
    em_take_rows(at, w->K, EM_STAGES, width);
    for (size_t i = 0; i < sizeof states / sizeof *states; ++i) *states[i] = em_take_numbers(at, width + EM_PACK);
    w->atol = em_take_numbers(at, n + EM_PACK);
    em_take_rows(at, w->F, EM_DENSE_COEFFICIENTS, (size_t)w->n_state);
    w->memory = em_take_numbers(at, (size_t)em_padded(w->n_memory)), w->memory_new = em_take_numbers(at, (size_t)em_padded(w->n_memory));
    w->u = em_take_numbers(at, (size_t)w->n_inputs);
    w->piece = em_take_bytes(at, (size_t)w->n_inputs * sizeof *w->piece);
    w->longest = em_take_numbers(at, rows), w->row_rate = em_take_numbers(at, rows), w->row_tolerance = em_take_numbers(at, rows);
    w->rate_shift = em_take_numbers(at, rows);
    w->last_pivots_x = em_take_numbers(at, n), w->last_pivots = em_take_numbers(at, n);
    w->energy_start = em_take_numbers(at, 4 * n);
    em_lay_out_events(w, at);
    const size_t before = at->used;
    if (w->scheme.at_nodes) em_lay_out_nodes(w, at);
    w->node_tables = at->place ? at->place + before : NULL, w->node_tables_size = at->used - before;
    if (w->scheme.radau_iia) em_lay_out_stages(w, at);
    w->tables = at->place, w->tables_size = at->used;
    if (w->scheme.at_nodes) w->c = em_take_bytes(at, (size_t)w->lanes->n_prepared * sizeof *w->c);
}

/* Sizes of the run state, from its model. */
static void em_run_state_sizes(em_run_state *w, const em_model *model) {
    static const em_lanes none = {0};
    w->model = model;
    w->dynamics = model->dynamics;
    w->lanes = model->lanes ? model->lanes : &none;
    w->n = model->n, w->n_rows = model->m, w->n_positions = model->h, w->n_state = model->n_state;
    w->width = (model->n_state + EM_PACK - 1) / EM_PACK * EM_PACK;
    w->stride = em_padded(model->n);
    w->n_inputs = model->n_inputs, w->n_events = model->n_events, w->n_memory = w->dynamics->n_memory;
    w->second_order = w->dynamics->second_order, w->bare = em_is_bare(model), w->first_rate = w->second_order ? w->n : 0;
}

/* A zeroed run state with its tables, aligned to cache lines; or NULL. */
static em_run_state *em_run_state_allocate(const em_model *model, em_scheme scheme) {
    const size_t own = (sizeof(em_run_state) + EM_LINE - 1) / EM_LINE * EM_LINE;
    em_run_state counted = {.scheme = scheme};
    em_layout at = {NULL, 0};
    em_run_state_sizes(&counted, model);
    em_lay_out(&counted, &at);
    void *const block = calloc(1, own + at.used + EM_LINE);
    if (block == NULL) return NULL;
    char *const place = (char *)(((uintptr_t)block + EM_LINE - 1) / EM_LINE * EM_LINE);
    em_run_state *const w = (em_run_state *)place;
    w->scheme = scheme;
    at = (em_layout){place + own, 0};
    em_run_state_sizes(w, model);
    em_lay_out(w, &at);
    w->block = block;
    return w;
}

/* The blocks that are saved: four, one after the other, without pointers. */
typedef struct em_memory_block {
    void *at;
    size_t size;
} em_memory_block;
enum { EM_PIECES = 4 };

EM_NOINLINE void em_saved_blocks(em_run_state *w, em_memory_block *piece) {
    piece[0] = (em_memory_block){w, offsetof(em_run_state, run)};
    piece[1] = (em_memory_block){&w->nodes, offsetof(em_nodes, Y)};
    piece[2] = (em_memory_block){&w->stages, offsetof(em_implicit, K)};
    piece[3] = (em_memory_block){w->tables, w->tables_size};
}

/* Their total size in bytes, whatever the method. */
EM_NOINLINE size_t em_saved_size(const em_model *model) {
    em_run_state counted = {.scheme = {.at_nodes = 1, .radau_iia = &EM_RADAU9_TABLEAU}};
    em_layout at = {NULL, 0};
    em_run_state_sizes(&counted, model);
    em_lay_out(&counted, &at);
    return offsetof(em_run_state, run) + offsetof(em_nodes, Y) + offsetof(em_implicit, K) + counted.tables_size;
}

/* Frees the block at its unaligned address. */
EM_NOINLINE void em_run_state_free(em_run_state *w) {
    em_memory_block piece[EM_PIECES];
    em_saved_blocks(w, piece);
    for (int i = 0; i < EM_PIECES; ++i) memset(piece[i].at, 0, piece[i].size);
}

#endif
