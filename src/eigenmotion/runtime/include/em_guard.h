/* em_guard.h: whether an accepted step is one of the mechanism with its constraints, and which row is to blame if not. */
#ifndef EM_GUARD_H
#define EM_GUARD_H

#include "em_blame.h"
#include "em_kept_constraints.h"

#define EM_DRIFTED 0.3 /* where nothing is settled, x and v are off by no more than this part of the largest */
#define EM_SETTLES_STAGES 0.1 /* the part of the largest pivot below which a singular position is near */
#define EM_NEARBY 100.0 /* how near to a singular position it is near, in tolerances, */
#define EM_SHORT 0.2     /* and how short is short, beside the longest step */

/* The rows at the end of a step, in the mass metric, and the longest that each was. 0, or -1 and w->reason. */
static int em_look_at_constraints(em_walk *w, em_root *root) {
    if (em_root_at(w->t_new, w->y_new, w->run->prepared, root, &w->reason)) return -1;
    for (int row = 0; row < N_ROWS; ++row)
        w->longest[row] = em_max(w->longest[row], root->Delta[row * N_ROWS + row]);
    return 0;
}

/* The row that adds least to the others, of those that are independent, each in units of its longest; *pivot <- the
 * square of what it adds. -1 where nothing is known of the rows. */
static int em_weakest_constraint(em_walk *w, const em_root *root, double *pivot) {
    double Delta[EM_SOME_ROWS * EM_SOME_ROWS], pivots[EM_SOME_ROWS];
    int rows[EM_SOME_ROWS];
    for (int i = 0; i < N_ROWS; ++i)
        for (int j = 0; j <= i; ++j) {
            const double unit = sqrt(w->longest[i]) * sqrt(w->longest[j]);
            Delta[i * N_ROWS + j] = unit > 0.0 ? root->Delta[i * N_ROWS + j] / unit : 0.0;
        }
    if (w->rank == 0) w->rank = em_rank(EM_SOME_ROWS, root->Delta);
    if (w->rank == 0) return -1;
    em_ranked_rows(EM_SOME_ROWS, Delta, pivots, rows);
    *pivot = pivots[w->rank - 1];
    return rows[w->rank - 1];
}

/* A fault that names the weakest constraint row. */
EM_RARE EM_COLD int em_fail_weakest(em_walk *w, double size) {
    em_root root;
    double pivot;
    const int row = em_look_at_constraints(w, &root) == 0 ? em_weakest_constraint(w, &root, &pivot) : -1;
    em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, size);
    return em_blame(w, w->t_new, w->y_new);
}

/* Rows that are not kept must follow from those that are. 0, or -1 and w->reason, which names one that does not. */
static int em_check_dependent(em_walk *w) {
    double a[N], lambda[EM_SOME_ROWS];
    if (N_INPUTS > 0) em_signals(w, w->t_new);
    return em_acceleration(em_clock(w, w->t_new), w->y_new, w->f_new, w->run->prepared, w->u, EM_LEAST_NORM, a, lambda, &w->reason);
}

/* How far q (n) is from `other` in units of the tolerances. */
static double em_apart(const double *q, const double *other, const double *weight) {
    double difference[N];
    for (int k = 0; k < N; ++k) difference[k] = q[k] - other[k];
    return sqrt(em_weighted_squares(N, difference, weight));
}

/* Where nothing is settled, the constraints are met up to drift by the x and v (n) that are integrated. A consistent state
 * nearby differs by as little, in x and in v, except where A turns within the drift: there a motion on the drifted
 * constraints leaves for another branch than that on the constraints. 0, or -1 and w->reason. */
static int em_check_drift(em_walk *w, const double *x, const double *v) {
    const double *const weight = w->weight, still[N] = {0.0};
    double near_x[N], near_v[N];
    memcpy(near_x, x, sizeof near_x);
    memcpy(near_v, v, sizeof near_v);
    w->farthest = em_max(w->farthest, em_apart(x, w->run->y_start, weight));
    w->fastest = em_max(w->fastest, em_apart(v, still, weight + N));
    if (em_project(w->t_new, near_x, near_v, w->run->prepared, w->run->least_norm, &w->reason)) return -1;
    const double distance = em_apart(near_x, x, weight), change = em_apart(near_v, v, weight + N);
    const int lost = !(distance <= EM_DRIFTED * w->farthest + EM_FARTHEST);
    if (!lost && change <= EM_DRIFTED * w->fastest + EM_FARTHEST) return 0;
    return em_fail_weakest(w, lost ? distance : change);
}

/* Positions on the constraints are known to rounding c of phi. Where a row becomes shorter than about sqrt(c) beside
 * what it was, phi = 0 and phi = c are motions on different branches of a singular position: nothing tells which.
 * 0, or -1 and w->reason. */
static int em_check_lengths(em_walk *w, const em_root *root) {
    for (int row = 0; row < N_POSITIONS; ++row) {
        const double square = root->Delta[row * N_ROWS + row], longest = w->longest[row];
        if (!(square > EM_SINGULAR_PIVOT * longest))
            return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, sqrt(square / longest));
    }
    return 0;
}

/* A tolerance on x is one on phi, and where B is shorter than its root beside what it was, motions on phi = 0 and on
 * phi = rtol leave a singular position on different branches: short steps follow now one, now another. Steps that are
 * not short pass it as the smooth motion does. 0, or -1 and w->reason. */
static int em_check_branch(em_walk *w, const em_root *root) {
    const double size = fabs(w->h), near = em_min(1e-2, EM_NEARBY * w->rtol);
    double pivot;
    if (!w->near && w->strongest > 0.0 && size > EM_SHORT * w->longest_step) return 0;
    const int row = em_weakest_constraint(w, root, &pivot);
    if (row < 0) return 0;
    w->strongest = em_max(w->strongest, pivot);
    w->near = w->run->stabilise && pivot < EM_SETTLES_STAGES * w->strongest;
    if (w->strongest > 0.0 && size > EM_SHORT * w->longest_step) return 0;
    if (pivot > near * w->strongest) return 0;
    return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, pivot / w->strongest);
}

/* Where nothing settles them, errors of C and s add up. In a motion they count by what they are of an eigenvalue of M,
 * which may become small later. 0, or -1 and w->reason. */
static int em_check_factors(em_walk *w) {
    enum { DRIFTED = 1000 }; /* tolerances */
    if (N_S == 0 || w->run->stabilise) return 0;
    double M[N * N];
    int first = -1;
    factored(w->t_new, w->y_new, w->run->prepared, M);
    const double error = em_worst_factors(blocks, M, w->y_new, &first);
    if (!(error <= DRIFTED * w->rtol)) return em_fail(&w->reason, EM_FACTORS_DRIFTED, first, -1, error);
    return 0;
}

/* Whether the constraints on positions tell one motion from another here. 0, or -1 and w->reason. */
static int em_check_positions(em_walk *w) {
    em_root root;
    if (em_look_at_constraints(w, &root)) return -1;
    if (!w->run->least_norm && em_check_lengths(w, &root)) return -1;
    return em_check_branch(w, &root);
}

#endif
