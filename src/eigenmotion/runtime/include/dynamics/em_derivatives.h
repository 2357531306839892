/* em_derivatives.h: exact derivatives of the constrained acceleration and its multipliers.
 *
 *   r = M a + P^T lambda - bias = 0,  s = A a + gamma = 0                                                     (11) (39)
 *
 * hold at every x, v, u, p, t. So the derivatives of a and lambda solve the same linear system as a and lambda, with
 * the same factors: M da + P^T dlambda = -dr, A da = -ds, where dr, ds are the partial derivatives at fixed a, lambda
 * (derivatives/derivatives.c.jinja). P is A, unless friction is proportional to multipliers. If rows depend on each
 * other, only the rows that are independent at this state are used: off the constraints they form the smooth system
 * that has the same motion. */
#ifndef EM_DERIVATIVES_H
#define EM_DERIVATIVES_H

#include "dynamics/em_mechanics.h"
#include "numeric/em_packs.h"

/* The factors of the system at a state: L, B = A L^-T, and D = L_D L_D^T of B B^T. rows: flags of the rows used. */
typedef struct em_factors {
    em_root root;
    double L[EM_SOME_ROWS * EM_SOME_ROWS], r[EM_SOME_ROWS];
#ifdef EM_REACTION_RATES
    double rates_by_lambda[EM_REACTION_RATES * N_ROWS];
#endif
    int rows;
} em_factors;

/* least_norm: 0, 1, or the flags of the kept rows */
EM_NOINLINE int em_factors_at(double t, const double *x, const double *c, int least_norm, em_factors *f, em_fault *fault) {
    double unused[EM_SOME_ROWS] = {0.0};
    double *const Delta = f->root.Delta;
    if (em_root_at(t, x, c, &f->root, fault)) return -1;
    f->rows = least_norm ? EM_LEAST_NORM | (least_norm & EM_ABOUT_ROWS) : 0;
    if (N_ROWS == 0) return 0;
    if (f->rows == EM_LEAST_NORM) {
        int kept;
        if (em_independent_rows(EM_SOME_ROWS, Delta, EM_DEPENDENT, &kept) < N_ROWS) f->rows |= kept;
        else f->rows = 0;
    }
    if (f->rows >= EM_FIRST_KEPT) em_drop_rows(EM_SOME_ROWS, Delta, unused, f->rows);
    int row = f->rows ? -1 : em_vanished_row(EM_SOME_ROWS, Delta);
    if (row < 0) row = em_cholesky(EM_SOME_ROWS, Delta, f->L, f->r, EM_SINGULAR_PIVOT);
    return row < 0 ? 0 : em_fail(fault, EM_DEPENDENT_CONSTRAINTS, row, -1, NAN);
}

/* to (columns) += factor from */
EM_INLINE void em_add_row(int columns, double factor, const double *restrict from, double *restrict to) {
    EM_ALONG
    for (int j = 0; j < columns; ++j) to[j] += factor * from[j];
}

/* row (columns) *= factor, in exports for CasADi (casadi/elimination.py) */
EM_INLINE void em_scale_row(int columns, double factor, double *restrict row) {
    EM_ALONG
    for (int j = 0; j < columns; ++j) row[j] *= factor;
}

/* em_sum_rows, compiled once. */
EM_NOINLINE EM_HOT void em_add_rows_to(int columns, int count, double sign, const double *part, int apart, const double *X,
                                       double factor, double *to) {
    em_sum_rows(columns, count, sign, part, apart, X, factor, to);
}

/* X (n, columns) <- L^-1 X, or L^-T X */
EM_INLINE void em_forward_rows(int n, int columns, const double *L, const double *r, double *X) {
    for (int i = 0; i < n; ++i) em_add_rows_to(columns, i, -1.0, L + i * n, 1, X, r[i], X + i * columns);
}

EM_INLINE void em_backward_rows(int n, int columns, const double *L, const double *r, double *X) {
    for (int i = n - 1; i >= 0; --i) {
        const int below = n - 1 - i, next = below > 0 ? i + 1 : i; /* below the last row is no memory, even to point at */
        em_add_rows_to(columns, below, -1.0, L + next * n + i, n, X + next * columns, r[i], X + i * columns);
    }
}

/* X (m, columns) <- Delta^-1 X; if multipliers act along rows of their own, pushed^-1 X. */
EM_INLINE void em_solve_multipliers(const em_factors *f, int columns, double *X) {
#ifdef EM_PUSHES
    em_fault none; /* a and lambda have been solved from the same matrix */
    for (int j = 0; j < columns; ++j) {
        double column[N_ROWS];
        for (int row = 0; row < N_ROWS; ++row) column[row] = X[row * columns + j];
        em_solve_push(&f->root, column, f->rows, &none);
        for (int row = 0; row < N_ROWS; ++row) X[row * columns + j] = column[row];
    }
#else
    em_forward_rows(N_ROWS, columns, f->L, f->r, X);
    em_backward_rows(N_ROWS, columns, f->L, f->r, X);
#endif
}

/* W (n + m, columns): partial derivatives of r, s -> derivatives of a, lambda. Multipliers of rows that are not used
 * are zero. */
EM_INLINE void em_solve_columns(const em_factors *f, int columns, double *W) {
    double *const a = W, *const lambda = W + N * columns;
    for (int i = 0; i < N * columns; ++i) a[i] = -a[i];
    em_forward_rows(N, columns, f->root.L, f->root.r, a);
    for (int row = 0; row < N_ROWS; ++row)
        em_add_rows_to(columns, N, 1.0, f->root.B + row * N, 1, a, 1.0, lambda + row * columns);
    for (int row = 0; row < N_ROWS && f->rows >= EM_FIRST_KEPT; ++row)
        if (!(f->rows & EM_FIRST_KEPT << row)) memset(lambda + row * columns, 0, columns * sizeof *lambda);
    em_solve_multipliers(f, columns, lambda);
    for (int k = 0; k < N; ++k)
        em_add_rows_to(columns, N_ROWS, -1.0, EM_REACTIONS(&f->root) + k, N, lambda, 1.0, a + k * columns);
    em_backward_rows(N, columns, f->root.L, f->root.r, a);
#ifdef EM_REACTION_RATES
    em_add_changes_of_rates(columns, f->rates_by_lambda, lambda, a);
#endif
}

EM_NOINLINE EM_HOT void em_solve_motion(const em_factors *f, int columns, double *W) { em_solve_columns(f, columns, W); }

/* Partial derivatives with respect to the state (n + m, 2 n) and to the other arguments (n + m, n_forcing) -> da (n,
 * n_arguments), dlambda (m, n_arguments). Rows are padded to full vectors, a length that the compiler knows. */
EM_NOINLINE EM_HOT void em_solve_arguments(const em_factors *f, const double *by_state, const double *by_forcing,
                                           double *da, double *dlambda) {
    enum { WIDTH = (N_ARGUMENTS + 3) / 4 * 4 };
    double W[(N + N_ROWS) * WIDTH];
    for (int row = 0; row < N + N_ROWS; ++row) {
        double *const to = W + row * WIDTH;
        memcpy(to, by_state + row * 2 * N, 2 * N * sizeof *to);
        memcpy(to + 2 * N, by_forcing + row * N_FORCING, N_FORCING * sizeof *to);
        for (int j = N_ARGUMENTS; j < WIDTH; ++j) to[j] = 0.0;
    }
    em_solve_columns(f, WIDTH, W);
    for (int row = 0; row < N; ++row) memcpy(da + row * N_ARGUMENTS, W + row * WIDTH, N_ARGUMENTS * sizeof *da);
    for (int row = 0; row < N_ROWS; ++row)
        memcpy(dlambda + row * N_ARGUMENTS, W + (N + row) * WIDTH, N_ARGUMENTS * sizeof *dlambda);
}

/* D (n + m, n_arguments) of r and s at any a (n), lambda (m). If M + A^T W A is factored, state_partials are those of
 * r + A^T W s, and `equation_partials` of derivatives.c.jinja is this function. */
EM_EXPORT void em_equation_partials(double t, const double *x, const double *v, const double *a, const double *lambda,
                                    const double *c, const double *u, double *D) {
    double by_state[(N + N_ROWS) * 2 * N], by_forcing[(N + N_ROWS) * N_FORCING];
    state_partials(t, x, v, a, lambda, c, u, by_state);
    forcing_partials(t, x, v, a, lambda, c, u, by_forcing);
    for (int row = 0; row < N + N_ROWS; ++row) {
        memcpy(D + row * N_ARGUMENTS, by_state + row * 2 * N, 2 * N * sizeof *D);
        memcpy(D + row * N_ARGUMENTS + 2 * N, by_forcing + row * N_FORCING, N_FORCING * sizeof *D);
    }
}

/* a (n), lambda (m) of the rows that are used, and the factors there. */
EM_NOINLINE int em_motion_at(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                         em_factors *f, double *a, double *lambda, em_fault *fault) {
    if (em_factors_at(t, x, c, least_norm, f, fault)) return -1;
    if (em_acceleration_of(&f->root, t, x, v, c, u, f->rows, a, lambda, fault)) return -1;
#ifdef EM_REACTION_RATES
    reaction_rate_partials(t, x, v, lambda, c, u, f->rates_by_lambda);
#endif
    return 0;
}

/* J (2 n, 2 n) of z = (x, v) -> (v, xddot), constraints included. */
EM_EXPORT int em_motion_jacobian(double t, const double *z, const double *c, const double *u, int least_norm, double *J,
                                 em_fault *fault) {
    em_factors factors;
    double a[N], lambda[EM_SOME_ROWS], W[(N + N_ROWS) * 2 * N];
    if (em_motion_at(t, z, z + N, c, u, least_norm, &factors, a, lambda, fault)) return -1;
    state_partials(t, z, z + N, a, lambda, c, u, W);
    em_solve_motion(&factors, 2 * N, W);
    memset(J, 0, 2 * N * N * sizeof *J);
    for (int k = 0; k < N; ++k) J[k * 2 * N + N + k] = 1.0;
    memcpy(J + 2 * N * N, W, 2 * N * N * sizeof *J);
    return 0;
}

/* da (n, n_arguments), dlambda (m, n_arguments): with respect to x, v, inputs, parameters, time; a (n), lambda (m). */
EM_EXPORT int em_motion_derivatives(double t, const double *x, const double *v, const double *c, const double *u,
                                    int least_norm, double *a, double *lambda, double *da, double *dlambda,
                                    em_fault *fault) {
    em_factors factors;
    double by_state[(N + N_ROWS) * 2 * N], by_forcing[(N + N_ROWS) * N_FORCING];
    if (em_motion_at(t, x, v, c, u, least_norm, &factors, a, lambda, fault)) return -1;
    state_partials(t, x, v, a, lambda, c, u, by_state);
    forcing_partials(t, x, v, a, lambda, c, u, by_forcing);
    em_solve_arguments(&factors, by_state, by_forcing, da, dlambda);
    return 0;
}

/* W (rows, columns) += D (rows, inner) S (inner, columns) */
EM_NOINLINE void em_add_products(int rows, int inner, int columns, const double *D, const double *S, double *W) {
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < inner; ++k)
            if (D[i * inner + k] != 0.0) em_add_row(columns, D[i * inner + k], S + k * columns, W + i * columns);
}

/* Along `columns` directions, S (2 n, columns) of x, v and P (n_forcing, columns) of inputs, parameters, time:
 * W (n + m, columns) <- the changes of a and lambda; a (n), lambda (m). */
EM_EXPORT int em_motion_along(double t, const double *x, const double *v, const double *c, const double *u,
                              int least_norm, int columns, const double *S, const double *P, double *a, double *lambda,
                              double *W, em_fault *fault) {
    em_factors factors;
    double by_state[(N + N_ROWS) * 2 * N], by_forcing[(N + N_ROWS) * N_FORCING];
    if (em_motion_at(t, x, v, c, u, least_norm, &factors, a, lambda, fault)) return -1;
    state_partials(t, x, v, a, lambda, c, u, by_state);
    forcing_partials(t, x, v, a, lambda, c, u, by_forcing);
    memset(W, 0, (size_t)(N + N_ROWS) * columns * sizeof *W);
    em_add_products(N + N_ROWS, 2 * N, columns, by_state, S, W);
    em_add_products(N + N_ROWS, N_FORCING, columns, by_forcing, P, W);
    em_solve_motion(&factors, columns, W);
    return 0;
}

#endif
