/* em_failure_location.h: the coordinate or the constraint row that a failure is reported for. */
#ifndef EM_FAILURE_LOCATION_H
#define EM_FAILURE_LOCATION_H

#include "stepper/em_error_norm.h"
#include "stepper/em_table_lookups.h"
#include "dynamics/em_undefined.h"

/* The first coordinate of which x, v or their rates are not finite, -1 where all are. */
static int em_non_finite_coordinate(int n, const double *y) {
    for (int k = 0; k < 2 * n; ++k)
        if (!isfinite(y[k])) return k % n;
    return -1;
}

/* -1 and w->reason: a state or its rate (n_state) is not finite; the reason names the coordinate. */
EM_COLD_PATH EM_NOINLINE int em_not_finite(em_run_state *w, const double *y, const double *rate) {
    if (em_outside_table(w, w->t, w->y)) return -1;
    int first = em_non_finite_coordinate(w->n, y);
    if (first < 0) first = em_non_finite_coordinate(w->n, rate);
    return em_fail(&w->reason, EM_NON_FINITE_STATE, first, -1, NAN);
}

/* Corrects w->reason after a failed evaluation at y: a state outside of a table; or an overflow of y or M, which is not
 * the fault of pivots or rows (em_undefined.h); or a coordinate that has lost the inertia it had at the start, which makes a row that
 * contains it infinitely long in the mass metric. Returns -1. */
EM_COLD_PATH EM_NOINLINE int em_locate_failure(em_run_state *w, double t, const double *y) {
    if (em_outside_table(w, w->t, w->y)) return -1;
    const int first = em_non_finite_coordinate(w->n, y);
    if (first >= 0) return em_fail(&w->reason, EM_NON_FINITE_STATE, first, -1, NAN);
    if (w->bare) return -1;
    if (em_undefined(w->model, t, y, w->run->prepared, &w->reason)) return -1;
    const int n = w->n;
    double M[n * n], before[n * n];
    w->dynamics->factored(t, y, w->run->prepared, M);
    w->dynamics->factored(w->run->t_start, w->run->y_start, w->run->prepared, before);
    if (w->reason.status != EM_DEPENDENT_CONSTRAINTS) return -1;
    for (int k = 0; k < n * n; k += n + 1)
        if (!(M[k] > EM_SINGULAR_PIVOT * before[k]))
            return em_fail(&w->reason, EM_SINGULAR_MASS_MATRIX, k / (n + 1), -1, M[k]);
    return -1;
}

/* The coordinate with the largest contribution to the last error estimate. */
EM_UNUSED static int em_worst_coordinate(const em_run_state *w) {
    int worst = 0;
    for (int k = 1; k < 2 * w->n; ++k)
        if (fabs(w->error[k] * w->weight[k]) > fabs(w->error[worst] * w->weight[worst])) worst = k;
    return worst % w->n;
}

#endif
