/* em_guard.h: what makes an accepted step trustworthy, and which coordinate or row is to blame where it is not. */
#ifndef EM_GUARD_H
#define EM_GUARD_H

#include "em_step.h"

/* Settling removes the part of a step's error that leaves the constraints: it moves x and v by about the error that
 * the step was allowed, 1 in units of the tolerances. Farther than this it does not correct an error but makes one,
 * as near a singular position, where the rows of A lose their directions to rounding. */
#define EM_FARTHEST 10.0

#define EM_DRIFTED 0.3 /* and where nothing is settled, x and v are off by no more than this part of the largest */

#define EM_SETTLES_STAGES 0.1 /* the part of the largest pivot below which a singular position is near */

#define EM_NEARBY 100.0 /* how near to a singular position it is near, in tolerances, */
#define EM_SHORT 0.2     /* and how short is short, beside the longest step */

/* The first coordinate of which x, v or their rates are not finite, -1 where all are. */
static int em_non_finite_coordinate(const double *y) {
    for (int k = 0; k < 2 * N; ++k)
        if (!isfinite(y[k])) return k % N;
    return -1;
}

/* -1 and w->reason: a state or its rate (n_state) is not finite, which names the coordinate. */
EM_COLD int em_not_finite(em_walk *w, const double *y, const double *rate) {
    int first = em_non_finite_coordinate(y);
    if (first < 0) first = em_non_finite_coordinate(rate);
    return em_fail(&w->reason, EM_NON_FINITE_STATE, first, -1, NAN);
}

/* Where y has overflowed, or M there, neither pivots nor rows are to blame; nor are rows where a coordinate has lost the
 * inertia it had at the start: in the mass metric each row with a part of it is infinitely long. */
EM_COLD int em_blame(em_walk *w, double t, const double *y) {
    const int first = em_non_finite_coordinate(y);
    if (first >= 0) return em_fail(&w->reason, EM_NON_FINITE_STATE, first, -1, NAN);
#ifdef EM_MECHANICS_H
    double M[N * N], before[N * N];
    EM_FACTORED(t, y, w->run->prepared, M);
    EM_FACTORED(w->run->t_start, w->run->y_start, w->run->prepared, before);
    for (int k = 0; k < N * N; ++k)
        if (!isfinite(M[k])) return em_fail(&w->reason, EM_NON_FINITE_STATE, k % N, -1, NAN);
    if (w->reason.status != EM_DEPENDENT_CONSTRAINTS) return -1;
    for (int k = 0; k < N * N; k += N + 1)
        if (!(M[k] > EM_SINGULAR_PIVOT * before[k]))
            return em_fail(&w->reason, EM_SINGULAR_MASS_MATRIX, k / (N + 1), -1, M[k]);
#endif
    return (void)t, -1;
}

/* The coordinate with the largest part of the last error estimate. */
static int em_worst_coordinate(const em_walk *w) {
    int worst = 0;
    for (int k = 1; k < 2 * N; ++k)
        if (fabs(w->error[k] * w->weight[k]) > fabs(w->error[worst] * w->weight[worst])) worst = k;
    return worst % N;
}

#ifdef EM_MECHANICS_H
/* The rows at the end of a step, in the mass metric, and the longest that each was. 0, or -1 and w->reason. */
static int em_look_at_rows(em_walk *w, em_root *root) {
    if (em_root_at(w->t_new, w->y_new, w->run->prepared, root, &w->reason)) return -1;
    for (int row = 0; row < N_ROWS; ++row)
        w->longest[row] = em_max(w->longest[row], root->Delta[row * N_ROWS + row]);
    return 0;
}

/* The row that adds least to the others, of those that are independent, each in units of its longest; *pivot <- the
 * square of what it adds. -1 where nothing is known of the rows. */
static int em_weakest_row(em_walk *w, const em_root *root, double *pivot) {
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
#endif

#ifdef EM_MECHANICS_H
#define EM_SAME_ROW 3e-12 /* the part of a row that may be left beside others: rounding, and of positions on the constraints */

/* r (n) <- r without its parts along the `count` orthonormal rows of Q; twice, as once leaves rounding of what is gone. */
static void em_remove_rows(int count, const double *Q, double *r) {
    for (int pass = 0; pass < 2 * count; ++pass) {
        const double *const q = Q + pass % count * N;
        double along = 0.0;
        for (int k = 0; k < N; ++k) along += q[k] * r[k];
        for (int k = 0; k < N; ++k) r[k] -= along * q[k];
    }
}

static double em_length(const double *r) {
    double square = 0.0;
    for (int k = 0; k < N; ++k) square += r[k] * r[k];
    return sqrt(square);
}

/* A row of B that is not kept is one of the others' to rounding. What is a little different states another motion, which
 * squares, of which Delta is made, do not show. 0, or -1 and w->reason, which names it. */
static int em_check_dropped(em_walk *w, const em_root *root, int kept) {
    double Q[EM_SOME_ROWS * N], r[N];
    int count = 0;
    for (int number = 0; number < 2 * N_ROWS; ++number) {
        const int row = number % EM_SOME_ROWS, keeps = (kept & EM_FIRST_KEPT << row) != 0;
        if (keeps == (number >= N_ROWS)) continue; /* those that are kept first */
        memcpy(r, root->B + row * N, sizeof r);
        const double length = em_length(r);
        em_remove_rows(count, Q, r);
        const double left = em_length(r);
        if (!keeps && left > EM_SAME_ROW * length)
            return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, left / length);
        for (int k = 0; keeps && k < N; ++k) Q[count * N + k] = r[k] / left;
        count += keeps;
    }
    return 0;
}
#endif

/* run->kept <- rows that are independent at x, of which there are as many as at the start. -1 and w->reason where there
 * are more, on the constraints: it was a singular position, and the rows kept do not hold what starts there. */
static int em_keep_rows(em_walk *w, double t, const double *x) {
#ifdef EM_MECHANICS_H
    em_root root;
    int kept;
    if (N_ROWS == 0) return 0;
    if (em_root_at(t, x, w->run->prepared, &root, &w->reason)) return -1;
    const int rank = em_independent_rows(EM_SOME_ROWS, root.Delta, EM_DEPENDENT, &kept);
    if (kept && rank < N_ROWS && (w->run->stabilise || w->rank == 0) && em_check_dropped(w, &root, kept)) return -1;
    if (w->rank == 0) w->rank = rank;
    if (rank == w->rank) w->run->kept = kept;
    if (rank > w->rank && w->run->stabilise) {
        for (int row = 0; row < N_ROWS; ++row)
            if (kept & ~w->run->kept & EM_FIRST_KEPT << row) return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -2, NAN);
    }
#endif
    return (void)w, (void)t, (void)x, 0;
}

/* The same at the nearest point on the constraints: off them rows are independent that are not on them. */
static int em_keep_rows_at_start(em_walk *w) {
#ifdef EM_MECHANICS_H
    double x[N];
    memcpy(x, w->y, sizeof x);
    if (N_POSITIONS > 0 && em_newton_from_afar(w->t, x, w->run->prepared, EM_LEAST_NORM, &w->reason) < 0) return -1;
    return em_keep_rows(w, w->t, x);
#else
    return (void)w, 0;
#endif
}

/* Rows that are not kept must follow from those that are. 0, or -1 and w->reason, which names one that does not. */
static int em_check_dependent(em_walk *w) {
#ifdef EM_MECHANICS_H
    double a[N], lambda[EM_SOME_ROWS];
    if (N_INPUTS > 0) em_signals(w, w->t_new);
    return em_acceleration(w->t_new, w->y_new, w->f_new, w->run->prepared, w->u, EM_LEAST_NORM, a, lambda, &w->reason);
#else
    return (void)w, 0;
#endif
}

/* A fault that names the weakest row. */
EM_COLD int em_fail_weakest(em_walk *w, double size) {
    int row = -1;
#ifdef EM_MECHANICS_H
    em_root root;
    double pivot;
    if (em_look_at_rows(w, &root) == 0) row = em_weakest_row(w, &root, &pivot);
#endif
    em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, size);
    return em_blame(w, w->t_new, w->y_new);
}

/* Whether y_raw, settled to y_new with f_new there, moved no farther than it may. 0, or -1 and w->reason. */
static int em_check_settled(em_walk *w) {
    double v[N], moved[2 * N];
    if (model_velocity(w->mode, w->t_new, w->y_raw, w->run->prepared, v, &w->reason)) return -1;
    for (int k = 0; k < N; ++k) {
        moved[k] = w->y_new[k] - w->y_raw[k];
        moved[N + k] = w->f_new[k] - v[k];
    }
    const double distance = sqrt(em_weighted_squares(2 * N, moved, w->weight) / (2.0 * N));
    if (distance <= EM_FARTHEST) return 0;
    return em_fail_weakest(w, distance);
}

#ifdef EM_MECHANICS_H
/* How far q (n) is from `other` in units of the tolerances. */
static double em_apart(const double *q, const double *other, const double *weight) {
    double difference[N];
    for (int k = 0; k < N; ++k) difference[k] = q[k] - other[k];
    return sqrt(em_weighted_squares(N, difference, weight));
}
#endif

/* Where nothing is settled, the constraints are met up to drift. A consistent state nearby differs by as little, in x
 * and in v, except where A turns within the drift: there a motion on the drifted constraints leaves for another branch
 * than that on the constraints. 0, or -1 and w->reason. */
static int em_check_drift(em_walk *w) {
#ifdef EM_MECHANICS_H
    const double *const weight = w->weight, still[N] = {0.0};
    double x[N], v[N];
    memcpy(x, w->y_new, sizeof x);
    memcpy(v, w->f_new, sizeof v);
    w->farthest = em_max(w->farthest, em_apart(x, w->run->y_start, weight));
    w->fastest = em_max(w->fastest, em_apart(v, still, weight + N));
    if (em_project(w->t_new, x, v, w->run->prepared, w->run->least_norm, &w->reason)) return -1;
    const double distance = em_apart(x, w->y_new, weight), change = em_apart(v, w->f_new, weight + N);
    const int lost = !(distance <= EM_DRIFTED * w->farthest + EM_FARTHEST);
    if (!lost && change <= EM_DRIFTED * w->fastest + EM_FARTHEST) return 0;
    return em_fail_weakest(w, lost ? distance : change);
#else
    return (void)w, 0;
#endif
}

#ifdef EM_MECHANICS_H
/* Positions on the constraints are known to rounding c of phi. Where a row becomes shorter than about sqrt(c) beside
 * what it was, phi = 0 and phi = c are motions on different branches of a singular position: nothing tells which.
 * 0, or -1 and w->reason. */
static int em_check_rows(em_walk *w, const em_root *root) {
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
    const int row = em_weakest_row(w, root, &pivot);
    if (row < 0) return 0;
    w->strongest = em_max(w->strongest, pivot);
    w->near = w->run->stabilise && pivot < EM_SETTLES_STAGES * w->strongest;
    if (w->strongest > 0.0 && size > EM_SHORT * w->longest_step) return 0;
    if (pivot > near * w->strongest) return 0;
    return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, pivot / w->strongest);
}
#endif

/* Whether the constraints on positions tell one motion from another here. 0, or -1 and w->reason. */
static int em_check_positions(em_walk *w) {
#ifdef EM_MECHANICS_H
    em_root root;
    if (em_look_at_rows(w, &root)) return -1;
    if (!w->run->least_norm && em_check_rows(w, &root)) return -1;
    return em_check_branch(w, &root);
#else
    return (void)w, 0;
#endif
}

/* What the end of a step is worth. 0, or -1 and w->reason. */
static int em_check_step(em_walk *w) {
    if (N_POSITIONS > 0 && em_check_positions(w)) return -1;
    if (N_ROWS > 0 && w->run->least_norm && em_check_dependent(w)) return -1;
    if (N_ROWS > 0 && w->run->stabilise) return em_check_settled(w);
    return N_POSITIONS > 0 ? em_check_drift(w) : 0;
}

#endif
