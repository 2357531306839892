/* em_variation_rows.h: directions within a step, from the polynomial of their rates. */
#ifndef EM_VARIATION_ROWS_H
#define EM_VARIATION_ROWS_H

#include "sensitivity/em_variation_error.h"

/* once, twice (nodes + 1) <- single and double integrals from 0 to x of the Legendre polynomials on [0, 1]; the last
 * are those of P_8 - P_7, which vanishes at the nodes. */
static void em_integrals(double x, double *once, double *twice) {
    enum { NODES = EM_VARIATION_NODES };
    const double u = 2.0 * x - 1.0;
    double P[NODES + 3] = {1.0, u}, I[NODES + 2] = {x};
    for (int d = 1; d < NODES + 2; ++d) P[d + 1] = ((2 * d + 1) * u * P[d] - d * P[d - 1]) / (d + 1);
    for (int d = 1; d < NODES + 2; ++d) I[d] = (P[d + 1] - P[d - 1]) / (2.0 * (2 * d + 1));
    for (int d = 0; d <= NODES; ++d) {
        once[d] = I[d];
        twice[d] = d == 0 ? 0.5 * x * x : (I[d + 1] - I[d - 1]) / (2.0 * (2 * d + 1));
    }
    once[NODES] -= once[NODES - 1], twice[NODES] -= twice[NODES - 1];
}

/* weight (nodes + 1) of K at the nodes and at the start of the step, from integrals of the terms of a series. */
static void em_row_weights(const em_pass *p, const double *integral, double *weight) {
    enum { NODES = EM_VARIATION_NODES };
    weight[NODES] = 0.5 * integral[NODES];
    for (int j = 0; j < NODES; ++j) {
        weight[j] = -weight[NODES] * p->origin[j];
        for (int d = 0; d < NODES; ++d) weight[j] += p->of->series[d * NODES + j] * integral[d];
    }
}

/* Y <- directions at t, in a step of length h that starts at `from`. */
static void em_directions_within(em_pass *p, double from, double h, double t) {
    enum { NODES = EM_VARIATION_NODES };
    const int block = p->n * p->columns;
    const double x = fmin(fmax((t - from) / h, 0.0), 1.0);
    double once[NODES + 1], twice[NODES + 1], by_once[NODES + 1], by_twice[NODES + 1];
    em_integrals(x, once, twice);
    em_row_weights(p, once, by_once), em_row_weights(p, twice, by_twice);
    memcpy(p->Y, p->S0, 2 * (size_t)block * sizeof *p->Y);
    em_add_to(block, x * h, p->S0 + block, p->Y);
    for (int j = 0; j <= NODES; ++j) {
        const double *const K = j < NODES ? p->K + j * block : p->K0;
        em_add_to(block, h * h * by_twice[j], K, p->Y);
        em_add_to(block, h * by_once[j], K, p->Y + block);
    }
}

/* to (count, requested columns) <- rows of directions. */
static void em_keep_directions(const em_pass *p, const double *from, int count, double *to) {
    const int requested = p->of->columns;
    for (int i = 0; i < count; ++i) memcpy(to + i * requested, from + i * p->columns, requested * sizeof *to);
}

/* Computes the rows that lie within a step, and at its end. */
static void em_step_rows(em_pass *p, double from, double to) {
    em_variations *const w = p->of;
    int whole = !em_has_shifts(p);
    for (; p->row < w->n_rows && w->direction * w->t_rows[p->row] <= w->direction * to; ++p->row) {
        if (!whole) em_add_shifted_step(p, 1.0), whole = 1;
        em_directions_within(p, from, to - from, w->t_rows[p->row]);
        em_keep_directions(p, p->Y, 2 * p->n, w->rows + p->row * 2 * p->n * w->columns);
    }
}

/* The row at the end of a step, if there is one from `first` on: S, which is more accurate there. */
static void em_end_row(em_pass *p, size_t first, double to) {
    em_variations *const w = p->of;
    for (size_t row = p->row; row-- > first && w->t_rows[row] == to;)
        em_keep_directions(p, p->S, 2 * p->n, w->rows + row * 2 * p->n * w->columns);
}

/* The first row that is farther from `from` than `least`. */
static size_t em_next_row(const em_pass *p, double from, double least) {
    const em_variations *const w = p->of;
    size_t row = p->row;
    while (row < w->n_rows && w->direction * (w->t_rows[row] - from) <= least) ++row;
    return row;
}

/* The distance of a row from `from`; infinite: there is no such row. */
static double em_distance_of_row(const em_pass *p, double from, size_t row) {
    return row < p->of->n_rows ? fabs(p->of->t_rows[row] - from) : INFINITY;
}

#endif
