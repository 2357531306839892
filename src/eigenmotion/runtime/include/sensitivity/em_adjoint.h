/* em_adjoint.h: the transpose of the derivative of a run: cotangents through the factors of a tape
 * (em_derivative_tape.h), from the last to the first. */
#ifndef EM_ADJOINT_H
#define EM_ADJOINT_H

#include "sensitivity/em_variations.h"

/* Cotangents (2 n) of S, those of its values at rows (n_rows, 2 n) and stops (n_stops, 2 n), and the gradient (basis). */
typedef struct em_adjoint {
    double *lambda;
    const double *rows, *stops;
    double *gradient;
} em_adjoint;

/* lambda (2 n), gradient (basis) += J^T mu, for J (n, width) and the node's place c h: x there is x + c h v. */
EM_INLINE void em_add_transposed(const em_tape *tape, const double *J, const double *mu, double shift, em_adjoint *by) {
    const int n = tape->n, width = tape->width;
    double *restrict const of_x = by->lambda, *restrict const of_v = of_x + n, *restrict const gradient = by->gradient;
    for (int i = 0; i < n; ++i) {
        const double *restrict const row = J + i * width, *restrict const by_v = row + n, *restrict const by_p = row + 2 * n;
        if (mu[i] == 0.0) continue;
        for (int k = 0; k < n; ++k) of_x[k] += row[k] * mu[i], of_v[k] += (by_v[k] + shift * row[k]) * mu[i];
        for (int k = 0; k < tape->basis; ++k) gradient[k] += by_p[k] * mu[i];
    }
}

/* b (size) <- the solution of G^T y = b, G as factored by em_eliminate: its rows, `apart` numbers apart, are L U in this
 * order. Four rows at a time. */
EM_INLINE void em_solve_transposed(int size, int apart, const double *factors, const double *order, double *restrict b) {
    double y[size];
    const double *row[size];
    for (int i = 0; i < size; ++i) row[i] = factors + (size_t)order[i] * apart;
    for (int i = 0; i < size; i += EM_PIVOTS) {
        const double *const *const u = row + i;
        for (int k = 0; k < EM_PIVOTS; ++k) {
            b[i + k] /= u[k][i + k];
            for (int j = k + 1; j < EM_PIVOTS; ++j) b[i + j] -= u[k][i + j] * b[i + k];
        }
        const int after = i + EM_PIVOTS;
        em_subtract_four(size - after, b + i, u[0] + after, u[1] + after, u[2] + after, u[3] + after, b + after);
    }
    for (int i = size - EM_PIVOTS; i >= 0; i -= EM_PIVOTS) {
        const double *const *const l = row + i;
        for (int k = EM_PIVOTS - 1; k > 0; --k)
            for (int j = 0; j < k; ++j) b[i + j] -= l[k][i + j] * b[i + k];
        em_subtract_four(i, b + i, l[0], l[1], l[2], l[3], b);
    }
    for (int i = 0; i < size; ++i) y[(int)order[i]] = b[i];
    memcpy(b, y, size * sizeof *b);
}

/* The cotangents of K (nodes + 1, n), the last at the start of the step, += those of a row within it; lambda alike. */
static void em_add_row_within(const em_pass *p, const em_map *map, size_t row, em_adjoint *by, double *kappa) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n;
    const double h = map->h, x = fmin(fmax((p->of->t_rows[row] - map->from) / h, 0.0), 1.0);
    const double *const of_x = by->rows + row * 2 * n, *const of_v = of_x + n;
    double once[NODES + 1], twice[NODES + 1], by_once[NODES + 1], by_twice[NODES + 1];
    em_integrals(x, once, twice);
    em_row_weights(p, once, by_once), em_row_weights(p, twice, by_twice);
    for (int i = 0; i < n; ++i) by->lambda[i] += of_x[i], by->lambda[n + i] += of_v[i] + x * h * of_x[i];
    for (int j = 0; j <= NODES; ++j)
        for (int i = 0; i < n; ++i) kappa[j * n + i] += h * (h * by_twice[j] * of_x[i] + by_once[j] * of_v[i]);
}

/* The transpose of a step. */
EM_INLINE void em_pull_step(const em_pass *p, const em_map *map, em_adjoint *by) {
    enum { NODES = EM_VARIATION_NODES };
    const em_tape *const tape = p->tape;
    const int n = p->n, size = NODES * n;
    const double h = map->h;
    const double *const A = p->of->A + (NODES - 1) * NODES, *const A2 = p->of->A2 + (NODES - 1) * NODES;
    const em_step_numbers s = em_step_numbers_at(tape, tape->numbers + map->at);
    double kappa[size + n], b[size];
    memset(kappa + size, 0, n * sizeof *kappa), memset(b, 0, sizeof b); /* GCC cannot see that all of b is set */
    for (int j = 0; j < NODES; ++j)
        for (int i = 0; i < n; ++i) kappa[j * n + i] = h * (h * A2[j] * by->lambda[i] + A[j] * by->lambda[n + i]);
    for (int i = 0; i < n; ++i) by->lambda[n + i] += h * by->lambda[i];
    for (size_t row = map->first; row < map->last; ++row) em_add_row_within(p, map, row, by, kappa);
    for (int i = 0; i < size; ++i) b[i] = kappa[i % NODES * n + i / NODES] * s.units[i / NODES];
    em_solve_transposed(size, size + tape->columns, s.L, s.order, b);
    for (int i = 0; i < size; ++i) kappa[i % NODES * n + i / NODES] = b[i] / s.units[i / NODES];
    for (int j = 0; j < NODES; ++j)
        em_add_transposed(tape, s.F + (size_t)(j + 1) * n * tape->width, kappa + j * n, p->of->place[j] * h, by);
    em_add_transposed(tape, s.F, kappa + size, 0.0, by);
}

EM_FOR_AVX2 static void em_pull_wide(const em_pass *p, const em_map *map, em_adjoint *by) { em_pull_step(p, map, by); }
static void em_pull_narrow(const em_pass *p, const em_map *map, em_adjoint *by) { em_pull_step(p, map, by); }

/* The transpose of a matrix. */
static void em_pull_matrix(const em_tape *tape, const double *B, em_adjoint *by) {
    const int n = tape->n, width = tape->width;
    double all[width];
    memset(all, 0, sizeof all);
    for (int i = 0; i < 2 * n; ++i) em_add_to(width, by->lambda[i], B + (size_t)i * width, all);
    memcpy(by->lambda, all, 2 * n * sizeof *all);
    for (int k = 2 * n; k < width; ++k) by->gradient[k - 2 * n] += all[k];
}

/* lambda, gradient <- of the start, from zero at the end. p: the pass that recorded the tape. */
static void em_pull(const em_pass *p, em_adjoint *by) {
    const em_tape *const tape = p->tape;
    for (size_t i = tape->n_maps; i-- > 0;) {
        const em_map *const map = tape->maps + i;
        if (map->kind == EM_STEP_MAP) (p->wide ? em_pull_wide : em_pull_narrow)(p, map, by);
        else if (map->kind == EM_MATRIX_MAP) em_pull_matrix(tape, tape->numbers + map->at, by);
        else if (map->kind == EM_READING) em_add_to(2 * p->n, 1.0, by->stops + map->first * 2 * p->n, by->lambda);
    }
}

/* A pass with a tape. The pass itself follows directions `probes`, which decide its steps and check the transpose;
 * basis: of its columns P (n_forcing, columns), a basis of the directions of inputs, parameters and time. */
typedef struct em_taped_pass {
    em_variations of, of_basis;
    em_pass pass, basis;
    em_tape tape;
} em_taped_pass;

static void em_taped_close(em_taped_pass *taped) {
    em_pass_close(&taped->pass);
    em_pass_close(&taped->basis);
    em_tape_close(&taped->tape);
}

/* Takes memory for as many steps as the pass begins with: to grow it copies it. */
static void em_tape_reserve(em_taped_pass *taped) {
    const em_variations *const w = &taped->of;
    em_tape *const tape = &taped->tape;
    const double steps = (w->run ? (double)w->run->n_dense / w->initial_steps : 0.0) + (double)w->n_spans;
    const size_t count = (size_t)steps * em_step_count(tape);
    tape->numbers = malloc((count + 1) * sizeof *tape->numbers);
    tape->numbers_capacity = tape->numbers ? count : 0;
}

/* Integrates the pass `taped->of` and records its tape, for a basis P (n_forcing, basis). 0, or -1. */
static int em_record_tape(em_taped_pass *taped, int basis, const double *P) {
    em_variations *const w = &taped->of, *const over = &taped->of_basis;
    const int n = w->model->n, width = 2 * n + basis;
    double *const all = calloc((size_t)w->n_forcing * width, sizeof *all);
    taped->tape = (em_tape){.n = n, .basis = basis, .width = width, .random = 1};
    taped->tape.size = calloc((size_t)n * width, sizeof *P);
    taped->tape.acts = calloc((size_t)n * width, sizeof *taped->tape.acts);
    if (!all || !taped->tape.size || !taped->tape.acts) return free(all), em_fail(&w->fault, EM_OUT_OF_MEMORY, -1, -1, 0.0);
    for (int i = 0; i < w->n_forcing; ++i) memcpy(all + (size_t)i * width + 2 * n, P + (size_t)i * basis, basis * sizeof *P);
    *over = *w;
    over->columns = width, over->P = all, over->S = NULL, over->poll = NULL;
    int status = em_pass_begin(&taped->pass, w);
    if (status == 0 && (status = em_pass_begin(&taped->basis, over))) w->fault = over->fault;
    if (status == 0) {
        taped->pass.tape = &taped->tape, taped->pass.over_basis = &taped->basis;
        taped->basis.records_for = &taped->pass;
        taped->tape.columns = taped->pass.columns;
        em_tape_reserve(taped);
        if ((status = em_begin_step_on_tape(&taped->pass)) == 0) em_sample_forcings(&taped->pass);
        if (status == 0) status = em_pass_integrate(&taped->pass);
    }
    over->P = NULL;
    free(all);
    return status;
}

#endif
