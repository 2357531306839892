/* em_kept_rows.h: the independent constraint rows that a run solves for ("least_norm", em_rank.h). */
#ifndef EM_KEPT_ROWS_H
#define EM_KEPT_ROWS_H

#include "stepper/em_model_calls.h"

#define EM_SAME_ROW 3e-12 /* the remainder of a row after projection onto the others: rounding, and that of positions
                             on the constraints */

/* Checks that the rows of B that are not kept are combinations of the others to rounding. A row that differs
 * slightly defines another motion, and Delta, which has squares, does not show it. 0, or -1 and w->reason, which names
 * the row. */
static int em_check_dropped(em_run_state *w, const double *B, int kept) {
    double Q[w->n_rows * w->n], r[w->n];
    int count = 0;
    for (int number = 0; number < 2 * w->n_rows; ++number) {
        const int row = number % w->n_rows, keeps = (kept & EM_FIRST_KEPT << row) != 0;
        if (keeps == (number >= w->n_rows)) continue; /* kept rows first */
        memcpy(r, B + row * w->n, sizeof r);
        const double length = em_length(w->n, r);
        em_remove_rows(w->n, count, Q, r);
        const double left = em_length(w->n, r);
        if (!keeps && left > EM_SAME_ROW * length)
            return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, left / length);
        for (int k = 0; keeps && k < w->n; ++k) Q[count * w->n + k] = r[k] / left;
        count += keeps;
    }
    return 0;
}

/* Chooses the treatment of dependent rows at the start of a run: em_run.least_norm. */
static int em_choose_dependent(em_run_state *w) {
    int rows[em_some(w->n_rows)];
    if (w->bare || w->n_rows == 0) return w->requested_least_norm == EM_SHARED ? EM_SHARED : EM_REFUSED;
    if (w->requested_least_norm != EM_SHARED_FROM_START) return w->requested_least_norm;
    const int redundant = w->model->redundant(w->run->t_start, w->run->y_start, w->run->prepared, rows);
    return redundant ? w->requested_least_norm : EM_REFUSED;
}

/* Fails with a row that was kept and follows from the others here. */
static int em_fail_dependent_here(em_run_state *w, int kept) {
    int row = 0;
    while (row + 1 < w->n_rows && !(w->run->kept & ~kept & EM_FIRST_KEPT << row)) ++row;
    return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, NAN);
}

/* run->kept <- rows that are independent at x, as many as at the start. -1 and w->reason if there are more, on the
 * constraints: the start was a singular position, and the kept rows do not hold the motion that begins there. */
static int em_keep_constraints(em_run_state *w, double t, const double *x) {
    const int m = w->n_rows;
    double B[em_some(m * w->n)], Delta[em_some(m * m)];
    int kept;
    if (m == 0 || w->bare) return 0;
    if (w->dynamics->rows(t, x, w->run->prepared, B, Delta, &w->reason)) return -1;
    const int rank = em_independent_rows(m, Delta, EM_DEPENDENT, &kept);
    if (kept && rank < w->n_rows && (w->run->stabilise || w->rank == 0) && em_check_dropped(w, B, kept)) return -1;
    if (w->rank == 0) w->rank = rank;
    if (rank < w->rank && w->run->least_norm == EM_SHARED_FROM_START) return em_fail_dependent_here(w, kept);
    if (rank == w->rank) w->run->kept = kept;
    if (rank > w->rank && w->run->stabilise) {
        for (int row = 0; row < w->n_rows; ++row)
            if (kept & ~w->run->kept & EM_FIRST_KEPT << row) return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, EM_SINGULAR_START, NAN);
    }
    return 0;
}

/* The same at the nearest point on the constraints: rows that are dependent there may be independent off the
 * constraints. */
static int em_keep_constraints_at_start(em_run_state *w) {
    double x[w->n];
    if (w->bare) return 0;
    memcpy(x, w->y, sizeof x);
    if (w->n_positions > 0 && w->dynamics->reach(w->t, x, w->run->prepared, EM_LEAST_NORM, &w->reason) < 0) return -1;
    return em_keep_constraints(w, w->t, x);
}

#endif
