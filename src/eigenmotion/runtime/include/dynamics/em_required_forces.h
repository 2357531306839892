/* em_required_forces.h: inverse dynamics from M and the bias, for models whose forces no recursion gives.
 *
 * Included by NAME.c after it defined N, N_ROWS, mass_matrix, motion_bias and pfaffian. */
#ifndef EM_REQUIRED_FORCES_H
#define EM_REQUIRED_FORCES_H

#include "numeric/em_products.h"

/* r (n) = M a - bias, the forces that must act besides for accelerations a (n); s (m) = A a + gamma */
EM_EXPORT void em_required_forces(double t, const double *x, const double *v, const double *a, const double *c,
                                  const double *u, double *r, double *s) {
    double M[N * N], A[N * (N_ROWS ? N_ROWS : 1)], b[N_ROWS ? N_ROWS : 1];
    mass_matrix(t, x, c, M);
    motion_bias(t, x, v, c, u, r, s);
    em_product_plus(N, N, M, a, -1.0, r);
    if (N_ROWS == 0) return;
    pfaffian(t, x, c, A, b);
    em_product_plus(N_ROWS, N, A, a, 1.0, s);
}

#endif
