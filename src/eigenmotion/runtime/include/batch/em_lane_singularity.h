/* em_lane_singularity.h: the singularity monitor on lanes (em_measure_pivots of em_singularity_monitor.h). The model
 * defines N_PIVOTS, the number of pivots of M that vary, and EM_PIVOTS(t, x, c, pivots, diagonal). */
#ifndef EM_LANE_SINGULARITY_H
#define EM_LANE_SINGULARITY_H

#include "monitors/em_singularity_limits.h"
#include "numeric/em_real.h"

/* -1 in lanes where a pivot changes by no more than the limit. */
EM_INLINE em_truth em_pivot_stays(real before, real after) {
    return (after * EM_RESOLVED >= before) & (before * EM_RESOLVED >= after) & (after > 0.0);
}

#ifdef EM_PIVOTS

/* -1 in lanes whose step resolves M between x and x_new (n); the scalar code checks the others, and names the
 * reason. */
EM_NOINLINE em_truth em_resolved(real t, const real *x, real t_new, const real *x_new, const real *c, double rtol) {
    em_truth resolved = ~(em_truth){0};
    real middle[N], pivots[3][N_PIVOTS], diagonal[N_PIVOTS];
    for (int k = 0; k < N; ++k) middle[k] = 0.5 * (x[k] + x_new[k]);
    EM_PIVOTS(t, x, c, pivots[0], diagonal);
    EM_PIVOTS(0.5 * (t + t_new), middle, c, pivots[1], diagonal);
    EM_PIVOTS(t_new, x_new, c, pivots[2], diagonal);
    for (int k = 0; k < N_PIVOTS; ++k) {
        resolved &= em_pivot_stays(pivots[0][k], pivots[1][k]) & em_pivot_stays(pivots[1][k], pivots[2][k]);
        resolved &= pivots[2][k] * rtol > EM_PASSAGE_ERROR * DBL_EPSILON * diagonal[k];
    }
    return resolved;
}

#endif

#endif
