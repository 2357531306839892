/* em_start_tolerance.h: tolerances of a start: the allowed residuals of its constraints and contacts. */
#ifndef EM_START_TOLERANCE_H
#define EM_START_TOLERANCE_H

#include "numeric/em_linear.h"

/* The allowed residual of a constraint row is that of a change by EM_START_STEPS times the tolerances of the run.
 * Relative to the terms that cancel in the row, it is at least EM_START_TIGHTEST, because users compute initial states
 * with rounding, and at most EM_START_LOOSEST. */
#define EM_START_STEPS 10
#define EM_START_TIGHTEST 1e-9
#define EM_START_LOOSEST 1e-4

EM_INLINE double em_start_tolerance(double rtol) {
    return fmin(fmax(EM_START_STEPS * rtol, EM_START_TIGHTEST), EM_START_LOOSEST);
}

#endif
