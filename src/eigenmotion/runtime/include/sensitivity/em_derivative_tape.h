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

#define EM_SHORTEST_FORCING 1e-2 /* in steps of the run: what shorter steps would resolve of df/dp is rounding */
#define EM_FORCING_ROUNDING 1e-12 /* the least relative error of df/dp that steps are shortened for */

enum { EM_FORCING_SAMPLES = 16 };

typedef enum em_map_kind { EM_NO_MAP, EM_MATRIX_MAP, EM_STEP_MAP, EM_READING } em_map_kind;

/* One factor. `at`: its numbers on the tape. A step: from `from` over h, rows first to last - 1; a reading: stop
 * `first`. */
typedef struct em_map {
    em_map_kind kind;
    size_t at, first, last;
    double from, h;
} em_map;

/* Factors in the order of the pass. width: of a matrix, 2 n + basis; columns: of the pass. */
typedef struct em_tape {
    int n, basis, width, columns;
    uint64_t random;      /* the state of a generator */
    double *F, *size;     /* of the step that is being solved (em_step_numbers); (n, width): the size of df/dp along
                             the run */
    int *acts;            /* (n, width) whether df/dp is more than rounding */
    em_map *maps;
    double *numbers;
    size_t n_maps, maps_capacity, n_numbers, numbers_capacity;
} em_tape;

static void em_tape_close(em_tape *tape) {
    free(tape->maps);
    free(tape->numbers);
    free(tape->size);
    free(tape->acts);
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

/* Room for this many numbers at the end of the tape; NULL: out of memory. */
static double *em_tape_room(em_pass *p, size_t count) {
    em_tape *const tape = p->tape;
    double *const numbers = em_tape_grow(tape->numbers, &tape->numbers_capacity, tape->n_numbers + count + 1, sizeof *numbers);
    if (!numbers) return em_fail(&p->of->fault, EM_OUT_OF_MEMORY, -1, -1, 0.0), NULL;
    tape->numbers = numbers;
    return numbers + tape->n_numbers;
}

/* Appends a factor with this many numbers; NULL: out of memory. */
static double *em_tape_append(em_pass *p, em_map map, size_t count) {
    em_tape *const tape = p->tape;
    double *const numbers = em_tape_room(p, count);
    em_map *const maps = em_tape_grow(tape->maps, &tape->maps_capacity, tape->n_maps + 1, sizeof *maps);
    if (maps) tape->maps = maps;
    if (!numbers) return NULL;
    if (!maps) return em_fail(&p->of->fault, EM_OUT_OF_MEMORY, -1, -1, 0.0), NULL;
    map.at = tape->n_numbers;
    maps[tape->n_maps++] = map;
    tape->n_numbers += count;
    return numbers;
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

/* The numbers of a step on the tape: its linear system as it is factored, rows of (size + columns) numbers; the place of
 * the row of each pivot; the units of coordinates in it; F (nodes + 1, n, width): J at the start of the step and at its nodes, with respect to the state
 * and the basis. */
typedef struct em_step_numbers {
    double *L, *order, *units, *F;
} em_step_numbers;

static em_step_numbers em_step_numbers_at(const em_tape *tape, double *numbers) {
    const size_t size = (size_t)EM_VARIATION_NODES * tape->n, system = size * (size + tape->columns);
    return (em_step_numbers){numbers, numbers + system, numbers + system + size, numbers + system + size + tape->n};
}

static size_t em_step_count(const em_tape *tape) {
    const size_t size = (size_t)EM_VARIATION_NODES * tape->n;
    return size * (size + tape->columns) + size + tape->n + (EM_VARIATION_NODES + 1) * (size_t)tape->n * tape->width;
}

/* The next step is solved where its numbers are kept if it is accepted. 0, or -1. */
static int em_begin_step_on_tape(em_pass *p) {
    em_tape *const tape = p->tape;
    double *const numbers = em_tape_room(p, em_step_count(tape));
    if (!numbers) return -1;
    const em_step_numbers s = em_step_numbers_at(tape, numbers);
    p->L = s.L, tape->F = s.F;
    return 0;
}

/* to (n, width) <- J (n, n_arguments), with respect to the state and the basis, of whose directions each has one entry. */
static void em_along_basis(const em_pass *p, const double *J, double *to) {
    const em_pass *const q = p->over_basis;
    const int n = p->n, width = p->tape->width, arguments = p->of->model->n_arguments;
    double value[q->n_nonzeros + 1];
    for (int k = 0; k < q->n_nonzeros; ++k) value[k] = q->P[q->nonzeros[k][0] * q->columns + q->nonzeros[k][1]];
    for (int i = 0; i < n; ++i) {
        const double *restrict const from = J + i * arguments, *restrict const by_forcing = from + 2 * n;
        double *restrict const row = to + i * width;
        memcpy(row, from, 2 * n * sizeof *to);
        for (int k = 0; k < q->n_nonzeros; ++k) row[q->nonzeros[k][1]] = by_forcing[q->nonzeros[k][0]] * value[k];
    }
}

/* F <- J at the start and at the nodes of a step that has been solved. */
static void em_step_along_basis(const em_pass *p) {
    const int block = p->n * p->tape->width, arguments = p->of->model->n_arguments;
    em_along_basis(p, p->J0, p->tape->F);
    for (int j = 0; j < EM_VARIATION_NODES; ++j)
        em_along_basis(p, p->J + j * p->n * arguments, p->tape->F + (size_t)(j + 1) * block);
}

/* --- the error of a step, of directions that the pass does not follow --- */

/* D (n, n_arguments) <- the rounding of all terms that cancel in an acceleration, as far as they depend on a parameter
 * (em_add_parameter_cancellation). */
static void em_cancellation_by_parameters(const em_pass *p, const double *z, double *D) {
    const em_model *const model = p->of->model;
    const int n = p->n, width = model->n_arguments, first = 2 * n + model->n_inputs;
    memset(D, 0, (size_t)n * width * sizeof *D);
    for (int i = 0; i < n; ++i) {
        const double sum = em_terms_of_acceleration(p, z, i);
        for (int g = 0; g < model->n_parameters; ++g)
            if (p->c[g] != 0.0) D[i * width + first + g] = EM_ROUNDINGS * EM_CANCELLATION * sum / fabs(p->c[g]);
    }
}

/* to (n, width) <- |D| (n, n_arguments) along the basis, coupled by M; work (n, width) follows it. */
static void em_rounding_along_basis(const em_pass *p, double t, const double *z, const double *D, double *to) {
    const em_pass *const q = p->over_basis;
    const int n = p->n, arguments = p->of->model->n_arguments, width = p->tape->width;
    memset(to, 0, (size_t)n * width * sizeof *to);
    for (const int(*at)[2] = q->nonzeros; at < q->nonzeros + q->n_nonzeros; ++at)
        for (int i = 0; i < n; ++i)
            to[i * width + (*at)[1]] += D[i * arguments + 2 * n + (*at)[0]] * fabs(q->P[(*at)[0] * q->columns + (*at)[1]]);
    em_couple_rounding(p, em_pass_clock(p, t), z, width, to + n * width, to);
}

/* size (n, width) <- the largest |df/dp| of the basis at z at t, and what is rounding of it: p->J, p->a there. */
static void em_sample_forcing(em_pass *p, double t, const double *z) {
    enum { LAST = EM_VARIATION_NODES - 1 };
    em_variations *const w = p->of;
    em_tape *const tape = p->tape;
    const int n = p->n, arguments = w->model->n_arguments, entries = n * tape->width;
    double D[n * arguments];
    em_fault none;
    em_pass_inputs(p, t);
    if (w->model->motion_derivatives(em_pass_clock(p, t), z, z + n, p->c, p->u, w->least_norm, p->a + LAST * n, p->lambda,
                                     p->J + LAST * n * arguments, p->dlambda, &none)) return;
    em_along_basis(p, p->J + LAST * n * arguments, tape->F);
    em_cancellation_by_parameters(p, z, D);
    em_rounding_along_basis(p, t, z, D, tape->F + entries);
    for (int i = 0; i < entries; ++i) {
        const double size = fabs(tape->F[i]);
        if (isfinite(size)) tape->size[i] = fmax(tape->size[i], size);
        if (size > tape->F[entries + i]) tape->acts[i] = 1;
    }
}

/* Samples df/dp of the basis along the run: its size, and where it is more than rounding. */
static void em_sample_forcings(em_pass *p) {
    const em_variations *const w = p->of;
    double z[2 * p->n];
    for (int s = 0; w->run && s <= EM_FORCING_SAMPLES; ++s) {
        const double t = w->t[0] + (w->t[w->n_stops - 1] - w->t[0]) * s / EM_FORCING_SAMPLES;
        if (em_recorded_motion(p, t, z) == 0) em_sample_forcing(p, t, z);
    }
    p->of->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
}

/* whole (n, basis) <- the largest |df/dp| in a step and along the run. */
EM_INLINE void em_forcing_size(const em_tape *tape, double *restrict whole) {
    const int n = tape->n, width = tape->width, basis = tape->basis;
    for (int i = 0; i < n; ++i) {
        const double *restrict const along = tape->size + i * width + 2 * n;
        double *restrict const row = whole + i * basis;
        for (int b = 0; b < basis; ++b) row[b] = along[b];
        for (int q = 0; q <= EM_VARIATION_NODES; ++q) {
            const double *restrict const f = tape->F + (q * n + i) * width + 2 * n;
            for (int b = 0; b < basis; ++b) row[b] = em_max(row[b], fabs(f[b]));
        }
    }
}

/* size (basis) <- that of the terms of S_v'[i] in a step that starts without directions: df/dp, and what S has by the
 * df/dp of other rows. Of a decay within the step not more is left than that in comparable units. */
EM_INLINE void em_forced_rate(const em_pass *p, int i, const double *whole, double *restrict size) {
    const int n = p->n, basis = p->tape->basis;
    memcpy(size, whole + i * basis, basis * sizeof *size);
    for (int q = 0; q < n; ++q) {
        const double by = q == i ? 0.0 : em_min(p->B[i * n + q], p->units[i] / p->units[q]);
        for (int b = 0; b < basis; ++b) size[b] = em_max(size[b], by * whole[q * basis + b]);
    }
}

/* The largest errors of df/dp of the basis as a series in a step, relative to the size of the terms that it is added
 * to (em_variation_error.h). What is rounding all along the run is left out. */
EM_INLINE em_step_errors em_forcing_error(em_pass *p) {
    const em_tape *const tape = p->tape;
    const int n = p->n, width = tape->width, basis = tape->basis;
    double five[basis], six[basis], seven[basis], eight[basis], whole[n * basis], rate[basis];
    em_series_size sizes[basis];
    em_step_errors most = {0.0, 0.0};
    memset(sizes, 0, sizeof sizes);
    em_forcing_size(tape, whole);
    for (int i = 0; i < n; ++i) {
        const double *const start = tape->F + i * width + 2 * n;
        em_last_terms(p, basis, start, start + n * width, (size_t)n * width, five, six, seven, eight);
        em_forced_rate(p, i, whole, rate);
        for (int b = 0; b < basis; ++b)
            if (tape->acts[i * width + 2 * n + b])
                em_count_terms(&sizes[b], 1.0 / (rate[b] + DBL_MIN), five[b], six[b], seven[b], eight[b]);
    }
    for (int b = 0; b < basis; ++b)
        most = em_larger_errors(most, em_direction_errors(&sizes[b], 1.0 / fmax(p->of->tolerance, EM_FORCING_ROUNDING)));
    return most;
}

/* S, in the columns after the global probe <- directions at random: the steps must resolve all motions, also those of
 * which the probe has little. The scale of x is that of the motion within a step of this length. Constraints hold along
 * them. */
static void em_set_local_probes(em_pass *p, double t) {
    const em_variations *const w = p->of;
    em_fault none;
    const int n = p->n, k = p->columns;
    const double h = p->h > 0.0 ? p->h : 1.0;
    for (int i = 0; i < n; ++i) {
        double scale = fmax(fabs(p->z[i]), fmax(h * fabs(p->z[n + i]), h * h * fabs(p->a0[i])));
        if (!(scale > 0.0)) scale = 1.0;
        for (int j = EM_GLOBAL_PROBES; j < p->of->columns; ++j)
            for (int half = 0; half < 2; ++half) {
                p->tape->random = p->tape->random * 6364136223846793005u + 1442695040888963407u;
                const double draw = (double)(p->tape->random >> 11) * 0x1p-52 - 1.0;
                p->S[(half * n + i) * k + j] = scale * (half ? 1.0 / h : 1.0) * (draw < 0.0 ? draw - 0.5 : draw + 0.5);
            }
    }
    if (w->stabilise && p->m > 0)
        w->model->tangent(em_pass_clock(p, t), p->z, p->z + n, p->c, w->least_norm, k, p->S, p->P, &none);
}

/* Appends the step that has just been solved, whose rows are first to last - 1. */
static int em_append_step(em_pass *p, double from, double to, size_t first, size_t last) {
    const em_tape *const tape = p->tape;
    const int size = EM_VARIATION_NODES * p->n, apart = size + p->columns;
    double *const numbers = em_tape_append(
        p, (em_map){.kind = EM_STEP_MAP, .first = first, .last = last, .from = from, .h = to - from}, em_step_count(tape));
    if (!numbers) return -1;
    const em_step_numbers s = em_step_numbers_at(tape, numbers);
    for (int i = 0; i < size; ++i) s.order[i] = (double)((p->rows[i] - p->L) / apart);
    memcpy(s.units, p->units, p->n * sizeof *s.units);
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
