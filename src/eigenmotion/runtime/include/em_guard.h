/* em_guard.h: what makes an accepted step trustworthy, and which coordinate or row is to blame where it is not. */
#ifndef EM_GUARD_H
#define EM_GUARD_H

#include "em_step.h"

/* Settling removes the part of a step's error that leaves the constraints: it moves x and v by about the error that
 * the step was allowed, 1 in units of the tolerances. Farther than this it does not correct an error but makes one,
 * as near a singular position, where the rows of A lose their directions to rounding. */
#define EM_FARTHEST 10.0

#define EM_DRIFTED 0.3 /* and where nothing is settled, x and v are off by no more than this part of the largest */

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

/* The coordinate with the largest part of the last error estimate. */
static int em_worst_coordinate(const em_walk *w) {
    int worst = 0;
    for (int k = 1; k < 2 * N; ++k)
        if (fabs(w->error[k] * w->weight[k]) > fabs(w->error[worst] * w->weight[worst])) worst = k;
    return worst % N;
}

/* The row of A that is weakest beside the others, -1 where nothing is known of the rows. */
static int em_weakest_row(em_walk *w) {
#ifdef EM_MECHANICS_H
    em_root root;
    em_fault fault;
    if (em_root_at(w->t_new, w->y_new, w->run->prepared, &root, &fault)) return -1;
    return em_smallest_pivot(EM_SOME_ROWS, root.Delta);
#else
    return (void)w, -1;
#endif
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
    return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, em_weakest_row(w), -1, distance);
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
    return em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, em_weakest_row(w), -1, lost ? distance : change);
#else
    return (void)w, 0;
#endif
}

/* What the end of a step is worth. 0, or -1 and w->reason. */
static int em_check_step(em_walk *w) {
    if (N_ROWS > 0 && w->run->stabilise) return em_check_settled(w);
    return N_POSITIONS > 0 ? em_check_drift(w) : 0;
}

#endif
