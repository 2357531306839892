/* em_impact.h: Newton's law of impact in the mass metric.
 *
 * N v + rate, at which phi(x, t) changes, becomes -e times that, by impulses along N and along the constraint rows A,
 * which go on as they were: v+ = v - M^-1 R^T L, (R M^-1 R^T) L = (0, (1 + e) (N v + rate)) with the rows R = (A, N). */
#ifndef EM_IMPACT_H
#define EM_IMPACT_H

#include "em_mechanics.h"

enum { EM_STRUCK_ROWS = N_ROWS + 1, EM_STRUCK = N + 2 /* numbers an impact is stated by: N (n), rate, e */ };

#define EM_BLOCKED 1e-8 /* the part of a speed that an impact may leave otherwise than it is to */

/* N v + rate */
EM_COLD double em_approach(const double *struck, const double *v) {
    double speed = struck[N];
    for (int k = 0; k < N; ++k) speed += struck[k] * v[k];
    return speed;
}

/* The fastest that anything of this kinetic energy approaches along N, sqrt(N M^-1 N^T v^T M v), and what phi changes by. */
EM_COLD double em_fastest(const em_root *root, const double *struck, const double *v) {
    double along[N], p[N];
    memcpy(along, struck, sizeof along);
    memcpy(p, v, sizeof p);
    em_forward(N, root->L, root->r, along);
    em_transposed(N, root->L, p);
    return em_length(N, along) * em_length(N, p) + fabs(struck[N]);
}

/* Whether the constraints that hold leave nothing free to move along N. */
EM_COLD int em_is_blocked(const em_root *root, const double *struck) {
    double Q[EM_STRUCK_ROWS * N] = {0.0}, row[N];
    int count = 0;
    for (int k = 0; k <= N_ROWS; ++k) {
        memcpy(row, k < N_ROWS ? root->B + k * N : struck, sizeof row);
        if (k == N_ROWS) em_forward(N, root->L, root->r, row);
        const double length = em_length(N, row);
        em_remove_rows(N, count, Q, row);
        const double left = em_length(N, row);
        const int adds = left * left > EM_DEPENDENT * length * length;
        if (k == N_ROWS) return !adds;
        for (int i = 0; adds && i < N; ++i) Q[count * N + i] = row[i] / left;
        count += adds;
    }
    return 0;
}

/* B (m + 1, n) <- R L^-T and Delta <- B B^T, by its lower triangle */
EM_COLD void em_struck_rows(const em_root *root, const double *struck, double *B, double *Delta) {
    memcpy(B, root->B, N_ROWS * N * sizeof *B);
    memcpy(B + N_ROWS * N, struck, N * sizeof *B);
    em_forward(N, root->L, root->r, B + N_ROWS * N);
    for (int i = 0; i < EM_STRUCK_ROWS; ++i)
        for (int j = 0; j <= i; ++j) {
            double sum = i < N_ROWS ? root->Delta[i * N_ROWS + j] : 0.0;
            for (int k = 0; k < N && i == N_ROWS; ++k) sum += B[i * N + k] * B[j * N + k];
            Delta[i * EM_STRUCK_ROWS + j] = sum;
        }
}

/* impulse (m + 1) <- Delta^-1 impulse; of least norm where rows depend on each other. */
EM_COLD void em_solve_impulses(const double *Delta, double *impulse) {
    double copy[EM_STRUCK_ROWS * EM_STRUCK_ROWS], L[EM_STRUCK_ROWS * EM_STRUCK_ROWS], r[EM_STRUCK_ROWS];
    memcpy(copy, Delta, sizeof copy);
    if (em_vanished_row(EM_STRUCK_ROWS, copy) < 0 && em_cholesky(EM_STRUCK_ROWS, copy, L, r, EM_DEPENDENT) < 0) {
        em_forward(EM_STRUCK_ROWS, L, r, impulse);
        em_backward(EM_STRUCK_ROWS, L, r, impulse);
    } else {
        em_least_norm(EM_STRUCK_ROWS, Delta, impulse, NULL);
    }
}

/* v <- after the impact; impulse (m + 1): those of the constraints, then that along N. 0, or -1: the constraints leave no
 * freedom along N. */
EM_COLD int em_strike(const em_root *root, const double *struck, double e, double *v, double *impulse) {
    double B[EM_STRUCK_ROWS * N], Delta[EM_STRUCK_ROWS * EM_STRUCK_ROWS], change[N] = {0.0};
    const double before = em_approach(struck, v), fastest = em_fastest(root, struck, v); /* after it all may rest */
    em_struck_rows(root, struck, B, Delta);
    memset(impulse, 0, EM_STRUCK_ROWS * sizeof *impulse);
    impulse[N_ROWS] = (1.0 + e) * before;
    em_solve_impulses(Delta, impulse);
    for (int row = 0; row < EM_STRUCK_ROWS; ++row)
        for (int k = 0; k < N; ++k) change[k] += B[row * N + k] * impulse[row];
    em_backward(N, root->L, root->r, change);
    for (int k = 0; k < N; ++k) v[k] -= change[k];
    return fabs(em_approach(struck, v) + e * before) <= EM_BLOCKED * fastest ? 0 : -1;
}

#endif
