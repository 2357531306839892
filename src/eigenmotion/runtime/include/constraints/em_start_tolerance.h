/* em_start_tolerance.h: tolerances of a start: how far off its constraints and contacts it may be. */
#ifndef EM_START_TOLERANCE_H
#define EM_START_TOLERANCE_H

#include "numeric/em_linear.h"

#define EM_START_STEPS 10      /* how many times the tolerances of a run its start may be off the constraints; */
#define EM_START_TIGHTEST 1e-9 /* rounding in what the user computed is forgiven up to this, relative to the terms that */
#define EM_START_LOOSEST 1e-4  /* cancel in them, and more than this never is */

EM_INLINE double em_start_tolerance(double rtol) {
    return fmin(fmax(EM_START_STEPS * rtol, EM_START_TIGHTEST), EM_START_LOOSEST);
}

#endif
