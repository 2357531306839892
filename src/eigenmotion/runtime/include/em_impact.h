/* em_impact.h: what an impact is stated by, N = dphi/dx, dphi/dt and the restitution e, and how fast it approaches. */
#ifndef EM_IMPACT_H
#define EM_IMPACT_H

#include "em_mechanics.h"

enum { EM_STRUCK_ROWS = N_ROWS + 1, EM_STRUCK = N + 2 /* numbers an impact is stated by: N (n), rate, e */ };

/* N v + rate */
EM_COLD double em_approach(const double *struck, const double *v) {
    double speed = struck[N];
    for (int k = 0; k < N; ++k) speed += struck[k] * v[k];
    return speed;
}

/* The fastest that anything of this kinetic energy approaches along N, sqrt(N M^-1 N^T v^T M v), and what phi changes by. */
EM_COLD double em_fastest(const em_root *root, const double *struck, const double *v) {
    double along[N], p[N];
    memcpy(along, struck, sizeof along);
    memcpy(p, v, sizeof p);
    em_forward(N, root->L, root->r, along);
    em_transposed(N, root->L, p);
    return em_length(N, along) * em_length(N, p) + fabs(struck[N]);
}

#endif
