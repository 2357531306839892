/* em_ensemble.h: many runs of one em_model, into tables that the caller owns.
 *
 * For the runtime, not for generated code. Members know nothing of each other: what comes of one does not depend on which
 * others run beside it, in which order, or on how many threads. */
#ifndef EM_ENSEMBLE_H
#define EM_ENSEMBLE_H

#include "em_flocks.h"

/* All of them. 0, or -1 without memory. */
static int em_ensemble_run(em_ensemble *e) {
    timespec_get(&e->polled, TIME_UTC);
    return em_ensemble_has_lanes(e) ? em_ensemble_in_lanes(e) : em_ensemble_by_numbers(e, 0, e->count);
}

#endif
