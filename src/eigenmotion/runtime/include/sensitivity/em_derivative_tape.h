/* em_derivative_tape.h: the derivative of a run as a product of linear maps, and its transpose (adjoint).
 *
 * A pass (em_variation_pass.h) is linear in S at its start and in P. With a tape it stores each factor of that map:
 *
 *     a matrix    S <- B [S; p]      across events, margins, time events, projections onto tangents
 *     a step      S <- of Radau IIA  (em_variation_steps.h): its Jacobians, and the factors of its linear system
 *     a reading   S at a stop
 *
 * p are the coefficients of a basis of the directions P. The transpose applies the factors in reverse order, to
 * cotangents (2 n) of S: its cost does not depend on the number of directions, apart from the products with df/dp. */
#ifndef EM_DERIVATIVE_TAPE_H
#define EM_DERIVATIVE_TAPE_H

#include "sensitivity/em_variation_rows.h"

typedef enum em_map_kind { EM_NO_MAP, EM_MATRIX_MAP, EM_STEP_MAP, EM_READING } em_map_kind;

/* One factor. `at`: its numbers on the tape. A step: from `from` over h, rows first to last - 1; a reading: stop
 * `first`. */
typedef struct em_map {
    em_map_kind kind;
    size_t at, first, last;
    double from, h;
} em_map;

/* Factors in the order of the pass. width: of a matrix, 2 n + basis. */
typedef struct em_tape {
    int n, basis, width;
    em_map *maps;
    double *numbers;
    size_t n_maps, maps_capacity, n_numbers, numbers_capacity;
} em_tape;

static void em_tape_close(em_tape *tape) {
    free(tape->maps);
    free(tape->numbers);
    *tape = (em_tape){0};
}

/* Makes a table of `size` bytes an entry large enough for `count` entries. */
static void *em_tape_grow(void *table, size_t *capacity, size_t count, size_t size) {
    if (count <= *capacity) return table;
    const size_t larger = count + count / 2 + 64;
    void *const grown = realloc(table, larger * size);
    if (grown) *capacity = larger;
    return grown;
}

/* Appends a factor with this many numbers; NULL: out of memory. */
static double *em_tape_append(em_pass *p, em_map map, size_t count) {
    em_tape *const tape = p->tape;
    em_map *const maps = em_tape_grow(tape->maps, &tape->maps_capacity, tape->n_maps + 1, sizeof *maps);
    if (maps) tape->maps = maps;
    double *const numbers = em_tape_grow(tape->numbers, &tape->numbers_capacity, tape->n_numbers + count + 1, sizeof *numbers);
    if (numbers) tape->numbers = numbers;
    if (!maps || !numbers) return em_fail(&p->of->fault, EM_OUT_OF_MEMORY, -1, -1, 0.0), NULL;
    map.at = tape->n_numbers;
    maps[tape->n_maps++] = map;
    tape->n_numbers += count;
    return numbers + map.at;
}

/* --- matrices: what a part of the pass does to a basis --- */

static void em_set_identity(em_pass *q) {
    memset(q->S, 0, 2 * (size_t)q->n * q->columns * sizeof *q->S);
    for (int i = 0; i < 2 * q->n; ++i) q->S[i * q->columns + i] = 1.0;
}

static int em_is_identity(const em_pass *q) {
    for (int i = 0; i < 2 * q->n; ++i)
        for (int j = 0; j < q->of->columns; ++j)
            if (q->S[i * q->columns + j] != (i == j ? 1.0 : 0.0)) return 0;
    return 1;
}

/* Copies the state of a pass to the pass over the basis, with S the identity. */
static void em_begin_matrix(const em_pass *p) {
    em_pass *const q = p->over_basis;
    const em_model *const model = p->of->model;
    memcpy(q->z, p->z, 2 * p->n * sizeof *q->z);
    memcpy(q->c, p->c, model->n_prepared * sizeof *q->c);
    memcpy(q->piece, p->piece, model->n_inputs * sizeof *q->piece);
    memcpy(q->pile, p->pile, model->n_events * sizeof *q->pile);
    memcpy(q->inside, p->inside, sizeof q->inside);
    em_set_identity(q);
}

/* Appends S of the pass over the basis, unless it is the identity. */
static int em_append_matrix(em_pass *p) {
    em_pass *const q = p->over_basis;
    if (em_is_identity(q)) return 0;
    double *to = em_tape_append(p, (em_map){.kind = EM_MATRIX_MAP}, 2 * (size_t)p->n * p->tape->width);
    if (!to) return -1;
    for (int i = 0; i < 2 * p->n; ++i) memcpy(to + i * p->tape->width, q->S + i * q->columns, p->tape->width * sizeof *to);
    return 0;
}

/* Ends a matrix, with the status of the part of the pass over the basis. */
static int em_end_matrix(em_pass *p, int status) {
    if (status == 0) return em_append_matrix(p);
    p->of->fault = p->over_basis->of->fault;
    p->of->why = p->over_basis->of->why;
    return -1;
}

/* Appends a reading at a stop; the last one at a stop counts. */
static int em_append_reading(em_pass *p, size_t stop) {
    em_tape *const tape = p->tape;
    for (size_t i = tape->n_maps; i-- > 0 && tape->maps[i].kind != EM_STEP_MAP;)
        if (tape->maps[i].kind == EM_READING && tape->maps[i].first == stop) tape->maps[i].kind = EM_NO_MAP;
    return em_tape_append(p, (em_map){.kind = EM_READING, .first = stop}, 0) ? 0 : -1;
}

/* S at a stop, as a result of the pass. In a pass over the basis, what has been done so far becomes a matrix. */
static int em_keep_at_stop(em_pass *p, size_t stop) {
    em_variations *const w = p->of;
    if (p->records_for) {
        em_pass *const of = p->records_for;
        if (em_append_matrix(of) || em_append_reading(of, stop)) return -1;
        em_set_identity(p);
        return 0;
    }
    em_keep_directions(p, p->S, 2 * p->n, w->S + stop * 2 * p->n * w->columns);
    return p->tape ? em_append_reading(p, stop) : 0;
}

/* --- steps --- */

/* The numbers of a step on the tape: the factors, the order of their rows, and J (n, width) at the start and at the
 * nodes, with respect to the state and the basis. */
typedef struct em_step_numbers {
    double *factors, *order, *J;
} em_step_numbers;

static em_step_numbers em_step_numbers_at(const em_tape *tape, double *numbers) {
    const size_t size = (size_t)EM_VARIATION_NODES * tape->n;
    return (em_step_numbers){numbers, numbers + size * size, numbers + size * size + size};
}

static size_t em_step_count(const em_tape *tape) {
    const size_t size = (size_t)EM_VARIATION_NODES * tape->n;
    return size * size + size + (EM_VARIATION_NODES + 1) * (size_t)tape->n * tape->width;
}

/* to (n, width) <- J (n, n_arguments), with respect to the state and the basis. */
static void em_along_basis(const em_pass *p, const double *J, double *to) {
    const em_pass *const q = p->over_basis;
    const int n = p->n, width = p->tape->width, arguments = p->of->model->n_arguments;
    for (int i = 0; i < n; ++i) {
        memcpy(to + i * width, J + i * arguments, 2 * n * sizeof *to);
        memset(to + i * width + 2 * n, 0, p->tape->basis * sizeof *to);
    }
    for (const int(*at)[2] = q->nonzeros; at < q->nonzeros + q->n_nonzeros; ++at)
        for (int i = 0; i < n; ++i)
            to[i * width + (*at)[1]] += J[i * arguments + 2 * n + (*at)[0]] * q->P[(*at)[0] * q->columns + (*at)[1]];
}

/* Appends the step that has just been solved, whose rows are first to last - 1. */
static int em_append_step(em_pass *p, double from, double to, size_t first, size_t last) {
    enum { NODES = EM_VARIATION_NODES };
    const em_tape *const tape = p->tape;
    const int n = p->n, size = NODES * n, apart = size + p->columns, arguments = p->of->model->n_arguments;
    double *const numbers = em_tape_append(
        p, (em_map){.kind = EM_STEP_MAP, .first = first, .last = last, .from = from, .h = to - from}, em_step_count(tape));
    if (!numbers) return -1;
    const em_step_numbers s = em_step_numbers_at(tape, numbers);
    for (int i = 0; i < size; ++i) {
        memcpy(s.factors + (size_t)i * size, p->rows[i], size * sizeof *s.factors);
        s.order[i] = (double)((p->rows[i] - p->L) / apart);
    }
    em_along_basis(p, p->J0, s.J);
    for (int j = 0; j < NODES; ++j)
        em_along_basis(p, p->J + j * n * arguments, s.J + (size_t)(j + 1) * n * tape->width);
    return 0;
}

/* Appends the projection of a state onto the tangent of the constraints. */
static int em_append_tangent(em_pass *p, double t, const double *z) {
    em_pass *const q = p->over_basis;
    em_variations *const w = p->of;
    em_set_identity(q);
    if (w->model->tangent(t, z, z + p->n, p->c, w->least_norm, q->columns, q->S, q->P, &w->fault)) return -1;
    return em_append_matrix(p);
}

#endif
