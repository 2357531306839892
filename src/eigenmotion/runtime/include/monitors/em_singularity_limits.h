/* em_singularity_limits.h: thresholds of the singularity monitor, scalar (em_singularity_monitor.h) and on lanes
 * (em_lane_singularity.h). */
#ifndef EM_SINGULARITY_LIMITS_H
#define EM_SINGULARITY_LIMITS_H

#define EM_CHECKED_STEP 0.25 /* the first step, retries, and steps below this part of the longest one are checked */
#define EM_RESOLVED 4.0      /* the factor by which a pivot of M may change within half a step */

/* The error that a passage adds, as a part of eps / p, p the least pivot relative to its entry of M (measured). */
#define EM_PASSAGE_ERROR 1e-4

#endif
