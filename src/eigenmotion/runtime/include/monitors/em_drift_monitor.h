/* em_drift_monitor.h: the drift monitor, for constraints that are not restored. In a run without stabilisation A v + b
 * of every row is a constant of the equations. Errors of steps change it, and add up; rounding of the multipliers
 * changes it by an amount that no tolerance removes, for example where forces cancel reactions on a small inertia. */
#ifndef EM_DRIFT_MONITOR_H
#define EM_DRIFT_MONITOR_H

#include "stepper/em_error_norm.h"

/* The allowed change of a row, in its tolerances, for a run and for each step; changes up to 0.06 a step were
 * measured. */
#define EM_ROW_DRIFT_PER_RUN 100.0
#define EM_ROW_DRIFT_PER_STEP 0.3

/* Whether there are such rows. Rows that depend on others follow from them on the constraints only
 * (em_check_dependent). */
static int em_drifts(const em_run_state *w) {
    const em_run *run = w->run;
    return w->n_rows > 0 && !run->stabilise && run->model != NULL && (!run->least_norm || w->rank == w->n_rows);
}

/* rate (m) <- A v + b; terms (m), which may be NULL: the sum of the magnitudes of the terms */
static void em_rates_of_rows(const em_run_state *w, double t, const double *x, const double *v, double *rate, double *terms) {
    double A[em_some(w->n_rows) * w->n];
    w->run->model->pfaffian(t, x, w->run->prepared, A, rate);
    for (int row = 0; row < w->n_rows; ++row) {
        double size = fabs(rate[row]);
        for (int k = 0; k < w->n; ++k) {
            rate[row] += A[row * w->n + k] * v[k];
            size += fabs(A[row * w->n + k] * v[k]);
        }
        if (terms) terms[row] = size;
    }
}

/* row_tolerance <- the largest so far of the change of A v + b when x and v, one after the other, change by their
 * tolerances, plus the rounding of its terms */
EM_NOINLINE void em_update_row_tolerance(em_run_state *w, double t, const double *x, const double *v) {
    double z[2 * w->n], here[em_some(w->n_rows)], there[em_some(w->n_rows)], sum[em_some(w->n_rows)];
    memcpy(z, x, (size_t)w->n * sizeof *z);
    memcpy(z + w->n, v, (size_t)w->n * sizeof *z);
    em_rates_of_rows(w, t, z, z + w->n, here, sum);
    for (int row = 0; row < w->n_rows; ++row) sum[row] *= DBL_EPSILON;
    for (int k = 0; k < 2 * w->n; ++k) {
        const double kept = z[k];
        z[k] += em_tolerance_of(w, k);
        em_rates_of_rows(w, t, z, z + w->n, there, NULL);
        for (int row = 0; row < w->n_rows; ++row)
            if (isfinite(there[row])) sum[row] += fabs(there[row] - here[row]);
        z[k] = kept;
    }
    for (int row = 0; row < w->n_rows; ++row) w->row_tolerance[row] = em_max(w->row_tolerance[row], sum[row]);
}

static void em_begin_drift(em_run_state *w) {
    if (!em_drifts(w)) return;
    em_rates_of_rows(w, w->t, w->y, w->K[0], w->row_rate, NULL);
    em_update_row_tolerance(w, w->t, w->y, w->K[0]);
}

/* 0, or -1 and w->reason, which names a row that has drifted. */
EM_NOINLINE int em_measure_drift(em_run_state *w) {
    double rate[em_some(w->n_rows)];
    if (!em_drifts(w)) return 0;
    em_rates_of_rows(w, w->t_new, w->y_new, w->f_new, rate, NULL);
    const double may = EM_ROW_DRIFT_PER_RUN + EM_ROW_DRIFT_PER_STEP * (double)w->run->n_steps;
    em_update_row_tolerance(w, w->t_new, w->y_new, w->f_new);
    for (int row = 0; row < w->n_rows; ++row) {
        const double drift = fabs(rate[row] - w->row_rate[row]);
        if (!(drift <= may * w->row_tolerance[row])) return em_fail(&w->reason, EM_CONSTRAINTS_DRIFTED, row, -1, drift);
    }
    return 0;
}

#endif
