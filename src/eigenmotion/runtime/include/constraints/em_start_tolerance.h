/* em_start_tolerance.h: tolerances of a start: the allowed residuals of its constraints and contacts. */
#ifndef EM_START_TOLERANCE_H
#define EM_START_TOLERANCE_H

#include "numeric/em_linear.h"

#define EM_START_STEPS 10      /* the residuals that this many times the tolerances of a run make are allowed; */
#define EM_START_TIGHTEST 1e-9 /* at least this is allowed, relative to the terms that cancel in a row, for rounding
                                  in */
#define EM_START_LOOSEST 1e-4  /* the user's own computation, and never more than this */

EM_INLINE double em_start_tolerance(double rtol) {
    return fmin(fmax(EM_START_STEPS * rtol, EM_START_TIGHTEST), EM_START_LOOSEST);
}

#endif
