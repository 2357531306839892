/* em_mechanics.h: acceleration, outputs and eigenfactors of any model, written once in terms of the model's own
 * functions.
 *
 * Included by NAME.c after it defined N, N_ROWS, N_POSITIONS, blocks, scales, factored, pfaffian, position,
 * motion_bias and observe. Nothing here is on the path of a right-hand side. */
#ifndef EM_MECHANICS_H
#define EM_MECHANICS_H

#include "dynamics/em_blocks.h"

#ifdef EM_NORMALS
enum { EM_PUSHED = N_PUSHED }; /* multipliers, and norms of them */
#else
enum { EM_PUSHED = N_ROWS };
#endif
enum { EM_SOME_ROWS = N_ROWS ? N_ROWS : 1, EM_SOME_POSITIONS = N_POSITIONS ? N_POSITIONS : 1 };

/* M = L L^T of all coordinates and B = A L^-T (m, n), b (m), Delta = B B^T by its lower triangle. If multipliers act
 * along other rows than A, Q = P L^-T (m, n) and pushed = B Q^T; if norms of multipliers act, the rows of Q are at
 * the direction of the multipliers, followed by those of the norms. */
typedef struct em_root {
    double L[N * N], r[N];
    double B[EM_SOME_ROWS * N], b[EM_SOME_ROWS], Delta[EM_SOME_ROWS * EM_SOME_ROWS];
#ifdef EM_PUSHES
    double Q[EM_PUSHED * N], pushed[N_ROWS * EM_PUSHED];
#endif
} em_root;

EM_NOINLINE int em_root_at(double t, const double *x, const double *c, em_root *root, em_fault *fault) {
    double M[N * N];
    factored(t, x, c, M);
    memset(root->L, 0, sizeof root->L);
    const int singular = em_cholesky_aside(N, M, root->L, root->r, EM_SINGULAR_PIVOT);
    if (singular >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, singular, -1, 0.0);
    pfaffian(t, x, c, root->B, root->b);
    for (int row = 0; row < N_ROWS; ++row) {
        em_forward(N, root->L, root->r, root->B + row * N);
        for (int column = 0; column <= row; ++column) {
            double sum = 0.0;
            for (int k = 0; k < N; ++k) sum += root->B[row * N + k] * root->B[column * N + k];
            root->Delta[row * N_ROWS + column] = sum;
        }
    }
    em_fill_inactive_rows(N_ROWS, root->Delta);
    return 0;
}

/* em_dynamics.rows: B and the lower triangle of Delta. */
EM_NOINLINE int em_rows_at(double t, const double *x, const double *c, double *B, double *Delta, em_fault *fault) {
    em_root root;
    if (em_root_at(t, x, c, &root, fault)) return -1;
    memcpy(B, root.B, sizeof root.B);
    memcpy(Delta, root.Delta, sizeof root.Delta);
    return 0;
}

/* em_dynamics.worst_factors */
EM_NOINLINE double em_worst_factors_of(const double *M, const double *y, int *first) { return em_worst_factors(blocks, M, y, first); }

/* Flags for a solution with Delta; least_norm: em_dependent, or the flags of the kept rows. */
EM_NOINLINE int em_flags_at(const em_root *root, int least_norm) {
    if (least_norm == EM_SHARED_FROM_START) return em_rank(EM_SOME_ROWS, root->Delta) < N_ROWS ? EM_LEAST_NORM : 0;
    return least_norm ? EM_LEAST_NORM | (least_norm & EM_ABOUT_ROWS) : 0;
}

/* lambda (m) <- Delta^-1 lambda. least_norm as above; terms as in em_least_norm. */
EM_NOINLINE int em_delta(em_root *root, double *lambda, const double *terms, int least_norm, em_fault *fault) {
    if (N_ROWS == 0) return 0;
    const int flags = em_flags_at(root, least_norm);
    if (flags == EM_LEAST_NORM) return em_solve_dependent(EM_SOME_ROWS, root->Delta, lambda, terms, 0, flags, fault);
    return em_solve_delta(EM_SOME_ROWS, root->Delta, lambda, flags, fault);
}

#ifdef EM_REACTION_RATES
#include "dynamics/em_reaction_rates.h"
#endif
#ifdef EM_PUSHES
#include "constraints/em_row_forces.h"
#define EM_REACTIONS(root) (root)->Q
#else
#define EM_REACTIONS(root) (root)->B
#endif

#ifdef EM_CONES
/* em_active_set.h */
EM_EXPORT void em_share_multipliers(double t, const double *x, const double *v, const double *c, const double *u,
                                    const double *Delta, double *lambda);
#endif

/* a (n), lambda (m): M a + A^T lambda = bias, A a + gamma = 0, with the root at x. */
EM_NOINLINE int em_acceleration_of(em_root *root, double t, const double *x, const double *v, const double *c,
                               const double *u, int least_norm, double *a, double *lambda, em_fault *fault) {
    double gamma[EM_SOME_ROWS], terms[EM_SOME_ROWS];
    motion_bias(t, x, v, c, u, a, gamma);
    em_forward(N, root->L, root->r, a);
    for (int row = 0; row < N_ROWS; ++row) {
        terms[row] = fabs(gamma[row]);
        for (int k = 0; k < N; ++k) {
            gamma[row] += root->B[row * N + k] * a[k];
            terms[row] += fabs(root->B[row * N + k] * a[k]);
        }
    }
#ifdef EM_PUSHES
    em_push(t, x, v, c, u, root);
#ifdef EM_NORMALS
    if (em_solve_norm_push(root, gamma, least_norm ? EM_LEAST_NORM | (least_norm & EM_ABOUT_ROWS) : 0, fault)) return -1;
#else
    if (em_solve_push(root, gamma, least_norm, fault)) return -1;
#endif
#else
    if (em_delta(root, gamma, terms, least_norm, fault)) return -1;
#endif
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        for (int k = 0; k < N; ++k) a[k] -= EM_REACTIONS(root)[row * N + k] * gamma[row];
    }
    em_backward(N, root->L, root->r, a);
#ifdef EM_REACTION_RATES
    em_add_reaction_rates(t, x, v, lambda, c, u, a);
#endif
#ifdef EM_CONES
    if (least_norm && least_norm < EM_FIRST_KEPT) em_share_multipliers(t, x, v, c, u, root->Delta, lambda);
#endif
    return 0;
}

EM_NOINLINE int em_acceleration(double t, const double *x, const double *v, const double *c, const double *u,
                            int least_norm, double *a, double *lambda, em_fault *fault) {
#ifdef EM_ACCELERATES_IN_RHS
    double y[2 * N], dy[2 * N];
    memcpy(y, x, N * sizeof *y);
    memcpy(y + N, v, N * sizeof *y);
    if (model_rhs(0, t, y, c, u, NULL, 0, dy, fault)) return -1;
    memcpy(a, dy + N, N * sizeof *a);
    return 0;
#else
    em_root root;
    if (em_root_at(t, x, c, &root, fault)) return -1;
    return em_acceleration_of(&root, t, x, v, c, u, least_norm, a, lambda, fault);
#endif
}

/* x (n) <- x - M^-1 A^T Delta^-1 e, e (m) the residual: the least change in the mass metric that removes it. */
EM_NOINLINE int em_correct(em_root *root, double *x, double *residual, const double *terms, int least_norm,
                       em_fault *fault) {
    double change[N] = {0.0};
    if (em_delta(root, residual, terms, least_norm, fault)) return -1;
    for (int row = 0; row < N_ROWS; ++row)
        for (int k = 0; k < N; ++k) change[k] += root->B[row * N + k] * residual[row];
    em_backward(N, root->L, root->r, change);
    for (int k = 0; k < N; ++k) x[k] -= change[k];
    return 0;
}

/* C (n, n), s (n) of M(x) in units of `scales`; close to the given C, or from scratch if C is 0. */
EM_NOINLINE int em_eigenfactors_of(double t, const double *x, const double *c, double *C, double *s, em_fault *fault) {
    double M[N * N];
    factored(t, x, c, M);
    for (int k = 0; k < N * N; ++k) M[k] *= scales[k / N] * scales[k % N];
    return em_eigenfactors_of_blocks(blocks, M, C, s, fault);
}

/* out (n_outputs) at x, v */
EM_NOINLINE int em_observe(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                       double *out, em_fault *fault) {
    double a[N], lambda[EM_SOME_ROWS];
    if (em_acceleration(t, x, v, c, u, least_norm, a, lambda, fault)) return -1;
    observe(t, x, v, a, lambda, c, u, out);
    return 0;
}

#endif
