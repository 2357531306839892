/* em_monitors.h: all checks of a step whose error is small enough. */
#ifndef EM_MONITORS_H
#define EM_MONITORS_H

#include "monitors/em_singularity_monitor.h"
#include "monitors/em_constraint_monitor.h"
#include "monitors/em_energy_monitor.h"

#define EM_SPACINGS 4.0 /* rates beside a time event are evaluated at times that are off by up to two spacings at either end */

/* How far x and v move in this many spacings of the times, in tolerances, at the mean rates of the step: late runs are
 * not known better. */
EM_COLD_PATH EM_NOINLINE double em_move_in_spacings(const em_run_state *w) {
    const int n = w->n;
    const double part = EM_SPACINGS * fabs((nextafter(w->t_new, INFINITY) - w->t_new) / w->h);
    double moved[2 * n];
    for (int k = 0; k < n; ++k) {
        moved[k] = part * (w->y_new[k] - w->y[k]);
        moved[n + k] = part * (w->f_new[k] - w->K[0][k]);
    }
    return sqrt(em_mean(em_weighted_squares(2 * n, moved, w->weight), 2 * n));
}

/* Checks that settling moved y_raw to y_new, with f_new there, no further than allowed. 0, or -1 and w->reason. */
static int em_check_settled(em_run_state *w) {
    const int n = w->n;
    double *const v = w->spare, *const moved = w->argument;
    if (em_xdot(w, w->mode, em_clock(w, w->t_new), w->y_raw, v, &w->reason)) return -1;
    for (int k = 0; k < n; k += EM_PACK) EM_PUT_PACK(moved + k, EM_PACK_AT(w->y_new + k) - EM_PACK_AT(w->y_raw + k));
    for (int k = 0; k < n; k += EM_PACK) EM_PUT_PACK(moved + n + k, EM_PACK_AT(w->f_new + k) - EM_PACK_AT(v + k));
    const double distance = sqrt(em_mean(em_weighted_squares(2 * n, moved, w->weight), 2 * n));
    if (distance <= EM_MOST_SETTLING || distance <= EM_MOST_SETTLING + em_move_in_spacings(w)) return 0;
    return em_fail_weakest(w, distance);
}

/* Checks that the current step, settled, follows the motion; a bare model has no terms to check it against. 0, or -1
 * and w->reason. */
static int em_check_step(em_run_state *w) {
    if (!w->bare && em_check_singularity(w)) return -1;
    if (!w->bare && w->n_positions > 0 && em_check_positions(w)) return -1;
    if (!w->bare && w->n_rows > 0 && w->run->least_norm && em_check_dependent(w)) return -1;
    if (w->n_rows > 0 && w->run->stabilise && em_check_settled(w)) return -1;
    if (!w->bare && w->n_positions > 0 && !(w->run->stabilise) && em_check_drift(w, w->y_new, w->f_new)) return -1;
    return (!w->bare && em_check_factors(w)) || em_check_energy(w) ? -1 : 0;
}

#endif
