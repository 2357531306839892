/* em_trust.h: what the end of a step is worth, all checks of it together. */
#ifndef EM_TRUST_H
#define EM_TRUST_H

#include "em_witness.h"

/* Settling removes the part of a step's error that leaves the constraints: it moves x and v by about the error that
 * the step was allowed, 1 in units of the tolerances. Farther than this it does not correct an error but makes one,
 * as near a singular position, where the rows of A lose their directions to rounding. */
#define EM_FARTHEST 10.0

/* A model written by hand may give its right-hand side alone; generated ones state the terms of their equations. */
#ifdef EM_MECHANICS_H
#include "em_chart.h"
#include "em_guard.h"
#else
#include "em_bare.h"
#endif

/* Whether y_raw, settled to y_new with f_new there, moved no farther than it may. 0, or -1 and w->reason. */
static int em_check_settled(em_walk *w) {
    double v[N], moved[2 * N];
    if (em_xdot(w->run, w->mode, em_clock(w, w->t_new), w->y_raw, v, &w->reason)) return -1;
    for (int k = 0; k < N; ++k) {
        moved[k] = w->y_new[k] - w->y_raw[k];
        moved[N + k] = w->f_new[k] - v[k];
    }
    const double distance = sqrt(em_weighted_squares(2 * N, moved, w->weight) / (2.0 * N));
    if (distance <= EM_FARTHEST) return 0;
    return em_fail_weakest(w, distance);
}

/* Whether the step under way, settled, is one of the motion asked for. 0, or -1 and w->reason. */
static int em_check_step(em_walk *w) {
    if (em_check_chart(w)) return -1;
    if (N_POSITIONS > 0 && em_check_positions(w)) return -1;
    if (N_ROWS > 0 && w->run->least_norm && em_check_dependent(w)) return -1;
    if (N_ROWS > 0 && w->run->stabilise && em_check_settled(w)) return -1;
    if (N_POSITIONS > 0 && !(w->run->stabilise) && em_check_drift(w, w->y_new, w->f_new)) return -1;
    return em_check_factors(w) || em_check_witness(w) ? -1 : 0;
}

#endif
