/* em_blame.h: which coordinate or constraint row is to blame where a step is not what it should be. */
#ifndef EM_BLAME_H
#define EM_BLAME_H

#include "em_norm.h"

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

#endif
