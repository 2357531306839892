/* em_saltation.h: the saltation matrix of an impact, which maps directions before it to directions after it.
 *
 * With the mode of the impulses fixed, M (v+ - v) + A^T lambda = 0 and A v+ + b = -e (A v + b) of the rows that hold
 * in it, and sliding friction is proportional to the impulse of its contact. Directions after the impact solve the
 * same system with the derivatives of these terms. */
#ifndef EM_SALTATION_H
#define EM_SALTATION_H

#include "contact/em_impacts.h"

/* W (rows, columns) <- D (rows, n_arguments) along the directions. */
EM_NOINLINE void em_along(const em_directions *d, int rows, const double *D, double *W) {
    memset(W, 0, (size_t)rows * d->columns * sizeof *W);
    for (int row = 0; row < rows; ++row) {
        em_add_products(1, 2 * N, d->columns, D + row * N_ARGUMENTS, d->S, W + row * d->columns);
        em_add_products(1, N_FORCING, d->columns, D + row * N_ARGUMENTS + 2 * N, d->P, W + row * d->columns);
    }
}

/* Derivatives, along the directions, of the terms of an impact. */
typedef struct em_impact_partials {
    double *balance, *rates, *levels, *impacts; /* (n + m), (h + m), levels, impacts: each by columns */
} em_impact_partials;

/* X (n, columns) <- v+ - v along the directions, where F (n, columns) is the residual's and G (rows, columns) the
 * rates'. */
EM_NOINLINE int em_solve_impact_along(const em_all_rows *r, const em_impact *b, int columns, double *F, const double *G) {
    int rows[EM_IMPACT_ROWS], count = 0;
    double Q[EM_IMPACT_ROWS * N], A[EM_IMPACT_ROWS * EM_IMPACT_ROWS], y[EM_IMPACT_ROWS];
    memcpy(Q, b->B, sizeof Q);
    for (int f = 0; f < EM_IMPACT_ROWS; ++f) {
        const double sign = em_limit_sign(&b->s, f);
        for (int k = 0; k < EM_IMPACT_ROWS * N && sign != 0.0; ++k)
            Q[k] += sign * b->s.coefficient[f] * b->s.gradient[f * EM_IMPACT_ROWS + k / N] * b->B[f * N + k % N];
        if (em_row_holds(&b->s, f)) rows[count++] = f;
    }
    em_forward_rows(N, columns, r->root.L, r->root.r, F);
    for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < count; ++i) {
            const double scale = b->s.unit[rows[i]];
            y[i] = -scale * G[rows[i] * columns + j];
            for (int k = 0; k < N; ++k) y[i] += scale * b->B[rows[i] * N + k] * F[k * columns + j];
            for (int l = 0; l < count; ++l) {
                A[i * count + l] = 0.0;
                for (int k = 0; k < N; ++k) A[i * count + l] += scale * b->B[rows[i] * N + k] * Q[rows[l] * N + k] * b->s.unit[rows[l]];
            }
        }
        if (em_solve_completely(count, A, y, EM_MODE_RANK, NULL)) return -1;
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < N; ++k) F[k * columns + j] -= Q[rows[i] * N + k] * b->s.unit[rows[i]] * y[i];
    }
    em_backward_rows(N, columns, r->root.L, r->root.r, F);
    return 0;
}

/* G (columns) <- the change of A (v+ - v) of a row through its own derivative, that of the rate before, and that of
 * the restitution. */
EM_NOINLINE void em_impact_rate_along(const em_acting *a, const em_impact *b, const em_impact_partials *of,
                                const double *change, int row, double *G) {
    const int columns = a->along->columns, lands = !b->strikes[row] || b->lands[row];
    const double e = lands ? 0.0 : b->e[row];
    const double *const N_along = of->impacts + b->impact[row] * EM_IMPACT_SIZE * columns;
    for (int j = 0; j < columns; ++j) {
        double sum = 0.0;
        if (row < N_ROWS) sum = -of->balance[(N + row) * columns + j] - (1.0 + e) * of->rates[(N_POSITIONS + row) * columns + j];
        else sum = -(1.0 + e) * b->side * N_along[N * columns + j];
        for (int k = 0; k < N && row == N_ROWS; ++k)
            sum -= b->side * (N_along[k * columns + j] * (change[k] + (1.0 + e) * a->v[k])) +
                   (1.0 + e) * b->extra[k] * a->along->S[(N + k) * columns + j];
        if (!lands) sum -= N_along[(N + 1) * columns + j] * b->before[row];
        G[j] = sum;
    }
}

/* Directions after an impact that changes v by `change`. 0, or -1 and *fault. */
EM_NOINLINE int em_impact_along(em_acting *a, const em_all_rows *r, const em_impact *b, const double *change, int event) {
    const em_directions *const d = a->along;
    const int columns = d->columns;
    double D[(N + N_ROWS) * N_ARGUMENTS], impulse[EM_SOME_ROWS];
    double L[EM_LEVELS * EM_SOME_SWITCHES * N_ARGUMENTS] = {0.0}, I[EM_SOME_IMPACTS * EM_IMPACT_SIZE * N_ARGUMENTS] = {0.0};
    double balance[(N + N_ROWS) * columns], rates[(N_POSITIONS + N_ROWS + 1) * columns], G[EM_IMPACT_ROWS * columns];
    double level[EM_LEVELS * EM_SOME_SWITCHES * columns], impact_data[EM_SOME_IMPACTS * EM_IMPACT_SIZE * columns];
    const em_impact_partials of = {balance, rates, level, impact_data};
    if (b->lowered < 1.0) return em_fail(a->fault, EM_IMPACT_UNDEFINED, event, EM_RESTITUTION_LOWERED, b->lowered);
    for (int row = 0; row < N_ROWS; ++row)
        if (b->poisson || (b->s.kind[row] == EM_ROW_CONE && em_limit_sign(&b->s, row) != 0.0))
            return em_fail(a->fault, EM_IMPACT_UNDEFINED, event, EM_LAW_NOT_DERIVED, NAN);
    for (int row = 0; row < N_ROWS; ++row) impulse[row] = -b->s.p[row];
    impact_balance_partials(a->t, a->x, change, impulse, r->c, D);
#ifdef EM_HAS_ROWS
    double E[(N_POSITIONS + N_ROWS) * N_ARGUMENTS];
    constraint_partials(a->t, a->x, a->v, r->c, E);
    em_along(d, N_POSITIONS + N_ROWS, E, rates);
#endif
    level_partials(a->t, a->x, a->v, a->c, a->u, L);
    impact_partials(a->t, a->x, a->v, a->c, a->u, I);
    em_along(d, N + N_ROWS, D, balance);
    em_along(d, EM_LEVELS * N_SWITCHES, L, level);
    em_along(d, EM_SOME_IMPACTS * EM_IMPACT_SIZE, I, impact_data);
    for (int row = 0; row < EM_IMPACT_ROWS; ++row)
        em_impact_rate_along(a, b, &of, change, row, G + row * columns);
    double F[N * columns];
    for (int k = 0; k < N; ++k)
        for (int j = 0; j < columns; ++j) {
            double sum = -balance[k * columns + j];
            if (b->strikes[N_ROWS]) sum += b->side * impact_data[(b->impact[N_ROWS] * EM_IMPACT_SIZE + k) * columns + j] * b->s.p[N_ROWS];
            for (int f = 0; f < N_SWITCHES; ++f) {
                const int row = switches[f].row;
                const double sign = em_limit_sign(&b->s, row);
                if (sign != 0.0) sum += r->A[row * N + k] * sign * em_normal_force(&b->s, row) * level[EM_LEVELS * f * columns + j];
            }
            F[k * columns + j] = sum;
        }
    if (em_solve_impact_along(r, b, columns, F, G)) return em_fail(a->fault, EM_IMPACT_UNDEFINED, event, -1, NAN);
    for (int k = 0; k < N * columns; ++k) d->S[N * columns + k] += F[k];
    return 0;
}

#endif
