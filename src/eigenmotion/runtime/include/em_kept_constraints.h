/* em_kept_constraints.h: which constraint rows a run solves for where some depend on others ("least_norm", em_rank.h). */
#ifndef EM_KEPT_CONSTRAINTS_H
#define EM_KEPT_CONSTRAINTS_H

#include "em_redundant.h"
#include "em_walk.h"

#define EM_SAME_ROW 3e-12 /* the part of a row that may be left beside others: rounding, and of positions on the constraints */

/* A row of B that is not kept is one of the others' to rounding. What is a little different states another motion, which
 * squares, of which Delta is made, do not show. 0, or -1 and w->reason, which names it. */
static int em_check_dropped(em_walk *w, const em_root *root, int kept) {
    double Q[EM_SOME_ROWS * N], r[N];
    int count = 0;
    for (int number = 0; number < 2 * N_ROWS; ++number) {
        const int row = number % EM_SOME_ROWS, keeps = (kept & EM_FIRST_KEPT << row) != 0;
        if (keeps == (number >= N_ROWS)) continue; /* those that are kept first */
        memcpy(r, root->B + row * N, sizeof r);
        const double length = em_length(N, r);
        em_remove_rows(N, count, Q, r);
        const double left = em_length(N, r);
        if (!keeps && left > EM_SAME_ROW * length)
            return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, left / length);
        for (int k = 0; keeps && k < N; ++k) Q[count * N + k] = r[k] / left;
        count += keeps;
    }
    return 0;
}

/* What becomes of dependent rows in a run at its start: em_run.least_norm. */
static int em_shares(em_walk *w) {
    int rows[EM_SOME_ROWS];
    if (w->asked != EM_SHARED_FROM_START) return w->asked;
    return em_redundant(w->run->t_start, w->run->y_start, w->run->prepared, rows) ? w->asked : EM_REFUSED;
}

/* A row that was kept, and follows from the others here. */
static int em_fail_dependent_here(em_walk *w, int kept) {
    int row = 0;
    while (row + 1 < N_ROWS && !(w->run->kept & ~kept & EM_FIRST_KEPT << row)) ++row;
    return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, NAN);
}

/* run->kept <- rows that are independent at x, of which there are as many as at the start. -1 and w->reason where there
 * are more, on the constraints: it was a singular position, and the rows kept do not hold what starts there. */
static int em_keep_constraints(em_walk *w, double t, const double *x) {
    em_root root;
    int kept;
    if (N_ROWS == 0) return 0;
    if (em_root_at(t, x, w->run->prepared, &root, &w->reason)) return -1;
    const int rank = em_independent_rows(EM_SOME_ROWS, root.Delta, EM_DEPENDENT, &kept);
    if (kept && rank < N_ROWS && (w->run->stabilise || w->rank == 0) && em_check_dropped(w, &root, kept)) return -1;
    if (w->rank == 0) w->rank = rank;
    if (rank < w->rank && w->run->least_norm == EM_SHARED_FROM_START) return em_fail_dependent_here(w, kept);
    if (rank == w->rank) w->run->kept = kept;
    if (rank > w->rank && w->run->stabilise) {
        for (int row = 0; row < N_ROWS; ++row)
            if (kept & ~w->run->kept & EM_FIRST_KEPT << row) return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -2, NAN);
    }
    return 0;
}

/* The same at the nearest point on the constraints: off them rows are independent that are not on them. */
static int em_keep_constraints_at_start(em_walk *w) {
    double x[N];
    memcpy(x, w->y, sizeof x);
    if (N_POSITIONS > 0 && em_newton_from_afar(w->t, x, w->run->prepared, EM_LEAST_NORM, &w->reason) < 0) return -1;
    return em_keep_constraints(w, w->t, x);
}

#endif
