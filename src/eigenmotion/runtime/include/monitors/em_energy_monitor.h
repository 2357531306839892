/* em_energy_monitor.h: the energy monitor. If T2 - T0 + V is a constant of the motion, its change is compared with
 * the tolerances at regular intervals and at the end: a run that violates it does not follow the motion. */
#ifndef EM_ENERGY_MONITOR_H
#define EM_ENERGY_MONITOR_H

#include "monitors/em_drift_monitor.h"

/* In right-hand sides: the energy is evaluated so rarely that its cost is negligible. */
#define EM_ENERGY_INTERVAL 256

/* The allowed change of the energy, in its tolerances, for every step including settling, and for a run as a whole. */
#define EM_ENERGY_DRIFT_PER_STEP 10.0
#define EM_ENERGY_DRIFT_PER_RUN 100.0
#define EM_ENERGY_DRIFT_UNSTABILISED 1000.0 /* in place of the latter, if C and s may drift by as much */

/* Whether the energy can be monitored: a motion that drifts off constraints does work against them. */
static int em_has_energy_monitor(const em_run_state *w) {
    const em_run *const run = w->run;
    const int drifts = w->n_rows > 0 && !run->stabilise;
    return !drifts && run->model != NULL && run->model->conserves_energy;
}

static double em_jacobi_integral(const em_run_state *w, double t, const double *x, const double *v) {
    double e[4];
    w->run->model->energy(t, x, v, w->run->prepared, e);
    return e[0] - e[2] + e[3];
}

/* The change of the energy when x and v, one after the other, change by their tolerances, plus the rounding of its
 * terms. */
EM_NOINLINE double em_energy_tolerance(const em_run_state *w, double t, const double *x, const double *v) {
    double z[2 * w->n], e[4], sum = 0.0;
    memcpy(z, x, (size_t)w->n * sizeof *z);
    memcpy(z + w->n, v, (size_t)w->n * sizeof *z);
    const double here = em_jacobi_integral(w, t, z, z + w->n);
    for (int k = 0; k < 2 * w->n; ++k) {
        const double kept = z[k];
        z[k] += em_tolerance_of(w, k);
        const double change = fabs(em_jacobi_integral(w, t, z, z + w->n) - here);
        if (isfinite(change)) sum += change;
        z[k] = kept;
    }
    w->run->model->energy(t, x, v, w->run->prepared, e);
    return sum + DBL_EPSILON * (fabs(e[0]) + fabs(e[2]) + fabs(e[3]));
}

/* Evaluates energy and constraints at the start. 0, or -1 and w->reason: the energy is not finite. */
static int em_begin_energy_monitor(em_run_state *w) {
    double e[4];
    em_begin_drift(w);
    if (!em_has_energy_monitor(w)) return 0;
    w->run->model->energy(w->t, w->y, w->K[0], w->run->prepared, e);
    w->energy = e[0] - e[2] + e[3];
    w->energy_tolerance = DBL_EPSILON * (fabs(e[0]) + fabs(e[2]) + fabs(e[3]));
    w->energy_time = w->t, w->energy_changes = 0;
    for (int k = 0; k < 2 * w->n; ++k) {
        w->energy_start[k] = k < w->n ? w->y[k] : w->K[0][k - w->n];
        w->energy_start[2 * w->n + k] = em_tolerance_of(w, k);
    }
    return isfinite(w->energy) ? 0 : em_fail(&w->reason, EM_ENERGY_DRIFTED, -1, -1, w->energy);
}

/* Adds the changes of the energy at the start to its tolerance, until it is enough: all 2 n would take as long as 2 n
 * energies, and one or two are nearly always enough. */
EM_NOINLINE void em_count_energy_changes(em_run_state *w, double enough) {
    const int count = 2 * w->n;
    double z[count];
    memcpy(z, w->energy_start, sizeof z);
    while (w->energy_changes < count && !(w->energy_tolerance >= enough)) {
        const int k = w->energy_changes++;
        z[k] += w->energy_start[count + k];
        const double change = fabs(em_jacobi_integral(w, w->energy_time, z, z + w->n) - w->energy);
        if (isfinite(change)) w->energy_tolerance += change;
        z[k] = w->energy_start[k];
    }
}

EM_NOINLINE int em_measure_energy(em_run_state *w) {
    const em_run *run = w->run;
    if (!em_has_energy_monitor(w)) return 0;
    const double drift = fabs(em_jacobi_integral(w, w->t_new, w->y_new, w->f_new) - w->energy);
    const double per_run = run->stabilise ? EM_ENERGY_DRIFT_PER_RUN : EM_ENERGY_DRIFT_UNSTABILISED;
    const double steps = per_run + EM_ENERGY_DRIFT_PER_STEP * (double)run->n_steps;
    em_count_energy_changes(w, drift / (0.1 * steps));
    if (!(drift <= 0.1 * steps * w->energy_tolerance))
        w->energy_tolerance = em_max(w->energy_tolerance, em_energy_tolerance(w, w->t_new, w->y_new, w->f_new));
    return drift <= steps * w->energy_tolerance ? 0 : em_fail(&w->reason, EM_ENERGY_DRIFTED, -1, -1, drift);
}

/* Checks energy and constraints at t_new. 0, or -1 and w->reason. */
EM_INLINE int em_check_energy(em_run_state *w) {
    if (w->run->n_rhs < w->next_energy_check && w->t_new != w->run->t_end) return 0;
    w->next_energy_check = w->run->n_rhs + EM_ENERGY_INTERVAL;
    return em_measure_drift(w) || em_measure_energy(w) ? -1 : 0;
}

#endif
