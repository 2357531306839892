/* em_constraint_monitor.h: the constraint monitor: checks that an accepted step satisfies the constraints, and names
 * the row otherwise. */
#ifndef EM_CONSTRAINT_MONITOR_H
#define EM_CONSTRAINT_MONITOR_H

#include "stepper/em_failure_location.h"
#include "monitors/em_kept_rows.h"

/* Settling removes the component of a step's error that violates the constraints. It moves x and v by about the
 * allowed error of the step, 1 in units of the tolerances. A move beyond this limit does not correct an error but
 * makes one, as near a singular position, where rounding dominates the directions of the rows of A. */
#define EM_MOST_SETTLING 10.0

#define EM_ALLOWED_DRIFT 0.3       /* without settling: the allowed drift of x and v, as a part of the largest so far */
#define EM_SETTLES_STAGES 0.1      /* a singular position is near below this part of the largest pivot */
#define EM_NEARBY_TOLERANCES 100.0 /* a singular position is near within this many tolerances, */
#define EM_SHORT_STEP 0.2          /* and a step is short below this part of the longest step */

/* Delta (m, m) <- of the rows at the end of a step, in the mass metric; updates the largest length of each row. 0,
 * or -1 and w->reason. */
static int em_measure_constraints(em_run_state *w, double *Delta) {
    double B[w->n_rows * w->n];
    if (w->dynamics->rows(w->t_new, w->y_new, w->run->prepared, B, Delta, &w->reason)) return -1;
    for (int row = 0; row < w->n_rows; ++row)
        w->longest[row] = em_max(w->longest[row], Delta[row * w->n_rows + row]);
    return 0;
}

/* The row that adds least to the other independent ones, each in units of its largest length; *pivot <- the square
 * of the part that it adds. -1 if the rows are unknown. */
static int em_weakest_constraint(em_run_state *w, const double *Delta, double *pivot) {
    const int m = w->n_rows;
    double scaled[m * m], pivots[m];
    int rows[m];
    for (int i = 0; i < m; ++i)
        for (int j = 0; j <= i; ++j) {
            const double unit = sqrt(w->longest[i]) * sqrt(w->longest[j]);
            scaled[i * m + j] = unit > 0.0 ? Delta[i * m + j] / unit : 0.0;
        }
    if (w->rank == 0) w->rank = em_rank(m, Delta);
    if (w->rank == 0) return -1;
    em_ranked_rows(m, scaled, pivots, rows);
    *pivot = pivots[w->rank - 1];
    return rows[w->rank - 1];
}

/* A fault that names the weakest constraint row. */
EM_COLD_PATH EM_NOINLINE int em_fail_weakest(em_run_state *w, double size) {
    double pivot, Delta[em_some(w->n_rows * w->n_rows)];
    const int known = !w->bare && em_measure_constraints(w, Delta) == 0, row = known ? em_weakest_constraint(w, Delta, &pivot) : -1;
    em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, size);
    return em_locate_failure(w, w->t_new, w->y_new);
}

/* Checks that the rows that are not kept follow from the kept ones. 0, or -1 and w->reason, which names a row that
 * does not. */
static int em_check_dependent(em_run_state *w) {
    double a[w->n], lambda[em_some(w->n_rows)];
    if (w->n_inputs > 0) em_signals(w, w->t_new);
    return w->dynamics->acceleration(em_clock(w, w->t_new), w->y_new, w->f_new, w->run->prepared, w->u, EM_LEAST_NORM, a, lambda, &w->reason);
}

/* The distance of q (n) from `other` in tolerances. */
static double em_distance(int n, const double *q, const double *other, const double *weight) {
    double difference[n];
    for (int k = 0; k < n; ++k) difference[k] = q[k] - other[k];
    return sqrt(em_weighted_squares(n, difference, weight));
}

/* Without settling, the integrated x and v (n) satisfy the constraints up to drift. A consistent state is then equally
 * close, in x and in v, unless A rotates considerably within the drift: there a motion on the drifted constraints takes
 * another branch than one on the constraints. 0, or -1 and w->reason. */
static int em_check_drift(em_run_state *w, const double *x, const double *v) {
    const int n = w->n;
    const double *const weight = w->weight;
    double near_x[n], near_v[n], still[n];
    memset(still, 0, sizeof still);
    memcpy(near_x, x, sizeof near_x);
    memcpy(near_v, v, sizeof near_v);
    w->farthest = em_max(w->farthest, em_distance(n, x, w->run->y_start, weight));
    w->fastest = em_max(w->fastest, em_distance(n, v, still, weight + n));
    if (w->model->project(w->t_new, near_x, near_v, w->run->prepared, w->run->least_norm, &w->reason)) return -1;
    const double distance = em_distance(n, near_x, x, weight), change = em_distance(n, near_v, v, weight + n);
    const int lost = !(distance <= EM_ALLOWED_DRIFT * w->farthest + EM_MOST_SETTLING);
    if (!lost && change <= EM_ALLOWED_DRIFT * w->fastest + EM_MOST_SETTLING) return 0;
    return em_fail_weakest(w, lost ? distance : change);
}

/* Positions on the constraints are known to the rounding c of phi. Where a row becomes shorter than about sqrt(c)
 * relative to its earlier length, phi = 0 and phi = c have motions on different branches of a singular position,
 * which cannot be distinguished. 0, or -1 and w->reason. */
static int em_check_lengths(em_run_state *w, const double *Delta) {
    for (int row = 0; row < w->n_positions; ++row) {
        const double square = Delta[row * w->n_rows + row], longest = w->longest[row];
        if (!(square > EM_SINGULAR_PIVOT * longest))
            return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, sqrt(square / longest));
    }
    return 0;
}

/* A tolerance on x is also one on phi. Where B is shorter than the root of that tolerance relative to its earlier
 * length, motions on phi = 0 and on phi = rtol leave a singular position on different branches: short steps follow
 * one or the other. Steps that are not short pass it like the smooth motion. 0, or -1 and w->reason. */
static int em_check_branch(em_run_state *w, const double *Delta) {
    const double size = fabs(w->h), near = em_min(1e-2, EM_NEARBY_TOLERANCES * w->rtol);
    double pivot;
    if (!w->near && w->strongest > 0.0 && size > EM_SHORT_STEP * w->longest_step) return 0;
    const int row = em_weakest_constraint(w, Delta, &pivot);
    if (row < 0) return 0;
    w->strongest = em_max(w->strongest, pivot);
    w->near = w->run->stabilise && pivot < EM_SETTLES_STAGES * w->strongest;
    if (w->strongest > 0.0 && size > EM_SHORT_STEP * w->longest_step) return 0;
    if (pivot > near * w->strongest) return 0;
    return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, row, -1, pivot / w->strongest);
}

/* Without settling, errors of C and s accumulate. They are measured relative to an eigenvalue of M, which may become
 * small later in the motion. 0, or -1 and w->reason. */
static int em_check_factors(em_run_state *w) {
    enum { DRIFTED = 1000 }; /* in tolerances */
    if (w->dynamics->worst_factors == NULL || w->run->stabilise) return 0;
    double M[w->n * w->n];
    int first = -1;
    w->dynamics->factored(w->t_new, w->y_new, w->run->prepared, M);
    const double error = w->dynamics->worst_factors(M, w->y_new, &first);
    if (!(error <= DRIFTED * w->rtol)) return em_fail(&w->reason, EM_FACTORS_DRIFTED, first, -1, error);
    return 0;
}

/* Whether the position constraints determine the motion uniquely here. 0, or -1 and w->reason. */
static int em_check_positions(em_run_state *w) {
    double Delta[w->n_rows * w->n_rows];
    if (em_measure_constraints(w, Delta)) return -1;
    if (!w->run->least_norm && em_check_lengths(w, Delta)) return -1;
    return em_check_branch(w, Delta);
}

#endif
