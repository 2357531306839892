/* em_undefined.h: entries of M or A, b that are not finite, which is not the fault of a pivot or a row. */
#ifndef EM_UNDEFINED_H
#define EM_UNDEFINED_H

#include "numeric/em_linear.h"

/* -1 and *fault, if M, A or b is not finite at x: names the coordinate or the constraint row. Else 0. */
EM_COLD_PATH EM_NOINLINE int em_undefined(const em_model *model, double t, const double *x, const double *c, em_fault *fault) {
    const int n = model->n, m = model->m;
    double M[n * n], A[m * n + 1], b[m + 1];
    model->mass_matrix(t, x, c, M);
    for (int k = 0; k < n * n; ++k) /* the lower triangle: the row at which a factorisation ends */
        if (k % n <= k / n && !isfinite(M[k])) return em_fail(fault, EM_NON_FINITE_STATE, k / n, EM_MASS_NOT_FINITE, NAN);
    if (m == 0) return 0;
    model->pfaffian(t, x, c, A, b);
    for (int k = 0; k < m * n; ++k)
        if (!isfinite(A[k])) return em_fail(fault, EM_NON_FINITE_STATE, k / n, EM_ROW_NOT_FINITE, NAN);
    for (int k = 0; k < m; ++k)
        if (!isfinite(b[k])) return em_fail(fault, EM_NON_FINITE_STATE, k, EM_ROW_NOT_FINITE, NAN);
    return 0;
}

#endif
