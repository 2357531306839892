/* em_tangent.h: projection of directions onto the tangent of the constraints; included for models that have
 * constraints. */
#ifndef EM_TANGENT_H
#define EM_TANGENT_H

#include "dynamics/em_derivatives.h"

/* X (n, columns) <- X - M^-1 A^T Delta^-1 E, of the first `rows` constraint rows, of which E (rows, columns) is the
 * residual. */
EM_NOINLINE void em_correct_along(const em_factors *f, int rows, int columns, double *E, double *X) {
    double L[EM_SOME_ROWS * EM_SOME_ROWS];
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k <= i; ++k) L[i * rows + k] = f->L[i * N_ROWS + k];
    for (int row = 0; row < rows && f->rows >= EM_FIRST_KEPT; ++row)
        if (!(f->rows & EM_FIRST_KEPT << row)) memset(E + row * columns, 0, columns * sizeof *E);
    em_forward_rows(rows, columns, L, f->r, E);
    em_backward_rows(rows, columns, L, f->r, E);
    double change[N * columns];
    memset(change, 0, sizeof change);
    for (int k = 0; k < N; ++k) em_add_rows_to(columns, rows, -1.0, f->root.B + k, N, E, 1.0, change + k * columns);
    em_backward_rows(N, columns, f->root.L, f->root.r, change);
    for (int k = 0; k < N * columns; ++k) X[k] += change[k];
}

/* Whether rows of contacts and frictions that are open, or directions on the tangent, leave nothing to correct. */
EM_INLINE int em_are_on_tangent(int count, const double *E) {
    for (int i = 0; i < count; ++i)
        if (E[i] != 0.0) return 0;
    return 1;
}

/* S (2 n, columns) <- the nearest directions, in the mass metric, along which the constraints stay satisfied. */
EM_EXPORT int em_tangent(double t, const double *x, const double *v, const double *c, int least_norm, int columns,
                         double *S, const double *P, em_fault *fault) {
    enum { ALL = N_POSITIONS + N_ROWS };
    em_factors f;
    double D[ALL * N_ARGUMENTS], by_state[ALL * 2 * N], by_forcing[ALL * N_FORCING], E[EM_SOME_ROWS * columns];
    if (em_factors_at(t, x, c, least_norm, &f, fault)) return -1;
    constraint_partials(t, x, v, c, D);
    for (int row = 0; row < ALL; ++row) {
        memcpy(by_state + row * 2 * N, D + row * N_ARGUMENTS, 2 * N * sizeof *D);
        memcpy(by_forcing + row * N_FORCING, D + row * N_ARGUMENTS + 2 * N, N_FORCING * sizeof *D);
    }
    for (int level = N_POSITIONS ? 0 : 1; level < 2; ++level) { /* positions, then velocities */
        const int first = level * N_POSITIONS, rows = level ? N_ROWS : N_POSITIONS;
        memset(E, 0, (size_t)rows * columns * sizeof *E);
        em_add_products(rows, 2 * N, columns, by_state + first * 2 * N, S, E);
        em_add_products(rows, N_FORCING, columns, by_forcing + first * N_FORCING, P, E);
        if (!em_are_on_tangent(rows * columns, E)) em_correct_along(&f, rows, columns, E, S + level * N * columns);
    }
    return 0;
}

#endif
