/* em_bundles.h: the numbers at the nodes of a step, in vectors of the machine's width: bundle b holds nodes b EM_LANES on. */
#ifndef EM_BUNDLES_H
#define EM_BUNDLES_H

#include "em_radau.h"
#include "em_walk.h"

EM_INLINE em_bundle em_bundle_at(const double *numbers) { return *(const em_bundle *)numbers; }

/* Number j of eight. */
EM_INLINE double em_number_at(em_bundle (*at)[N_STATE], int k, int j) {
    return ((const double *)&at[j / EM_LANES][k])[j % EM_LANES];
}

EM_INLINE void em_put_at(em_bundle (*at)[N_STATE], int k, int j, double number) {
    ((double *)&at[j / EM_LANES][k])[j % EM_LANES] = number;
}

/* By name: a loop would go through memory, and wait. */
EM_INLINE double em_sum_of(em_bundle a) {
#if EM_LANES == 8
    return ((a[0] + a[4]) + (a[1] + a[5])) + ((a[2] + a[6]) + (a[3] + a[7]));
#elif EM_LANES == 4
    return (a[0] + a[2]) + (a[1] + a[3]);
#elif EM_LANES == 2
    return a[0] + a[1];
#else
    return a;
#endif
}

/* Bundle b of sum_j column_j a_jk: what a linear map (8, 8), column by column, makes of row k. */
EM_INLINE em_bundle em_mapped(const double (*column)[EM_NODE_COUNT], em_bundle (*a)[N_STATE], int k, int b) {
    em_bundle even = {0.0}, odd = {0.0};
    EM_UNROLL
    for (int j = 0; j < EM_NODE_COUNT; j += 2) {
        even += em_bundle_at(column[j] + b * EM_LANES) * em_number_at(a, k, j);
        odd += em_bundle_at(column[j + 1] + b * EM_LANES) * em_number_at(a, k, j + 1);
    }
    return even + odd;
}

#endif
