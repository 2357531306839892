/* em_complete_pivoting.h: elimination with complete pivoting, for the linear system of an active set. */
#ifndef EM_COMPLETE_PIVOTING_H
#define EM_COMPLETE_PIVOTING_H

#include "numeric/em_linear.h"

#ifndef EM_MIXED_ROWS
#define EM_MIXED_ROWS EM_IMPACT_ROWS
#endif

#define EM_MODE_RANK 1e-11     /* of rows of length one: the pivot below which a mode's rows count as dependent */

/* x (count) <- A^-1 x by elimination with complete pivoting. 0, or -1: the rows are dependent. *sign, unless NULL:
 * the sign of the determinant. */
EM_NOINLINE int em_solve_mode(int count, double *A, double *x, int *sign) {
    int column[EM_MIXED_ROWS], turns = 0;
    double y[EM_MIXED_ROWS] = {0.0};
    for (int k = 0; k < count; ++k) column[k] = k;
    for (int k = 0; k < count; ++k) {
        int row = k, best = k;
        for (int i = k; i < count; ++i)
            for (int j = k; j < count; ++j)
                if (fabs(A[i * count + j]) > fabs(A[row * count + best])) row = i, best = j;
        const double pivot = A[row * count + best];
        if (!(fabs(pivot) > EM_MODE_RANK)) return -1;
        turns += (row != k) + (best != k) + (pivot < 0.0);
        for (int j = 0; j < count; ++j) {
            const double kept = A[k * count + j];
            A[k * count + j] = A[row * count + j], A[row * count + j] = kept;
        }
        for (int i = 0; i < count; ++i) {
            const double kept = A[i * count + k];
            A[i * count + k] = A[i * count + best], A[i * count + best] = kept;
        }
        const double right = x[k];
        const int place = column[k];
        x[k] = x[row], x[row] = right, column[k] = column[best], column[best] = place;
        for (int i = k + 1; i < count; ++i) {
            const double part = A[i * count + k] / A[k * count + k];
            for (int j = k; j < count; ++j) A[i * count + j] -= part * A[k * count + j];
            x[i] -= part * x[k];
        }
    }
    for (int k = count - 1; k >= 0; --k) {
        for (int j = k + 1; j < count; ++j) x[k] -= A[k * count + j] * x[j];
        x[k] /= A[k * count + k];
    }
    for (int k = 0; k < count; ++k) y[column[k]] = x[k];
    memcpy(x, y, count * sizeof *x);
    if (sign) *sign = turns % 2 ? -1 : 1;
    return 0;
}

#endif
