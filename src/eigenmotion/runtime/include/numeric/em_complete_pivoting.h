/* em_complete_pivoting.h: elimination with complete pivoting, for linear systems that may be indefinite and singular. */
#ifndef EM_COMPLETE_PIVOTING_H
#define EM_COMPLETE_PIVOTING_H

#include "numeric/em_linear.h"

/* x (count) <- A^-1 x by elimination with complete pivoting. 0, or -1: a pivot is at most `least`, so that the rows are
 * dependent. *sign, unless NULL: the sign of the determinant. */
EM_NOINLINE int em_solve_completely(int count, double *A, double *x, double least, int *sign) {
    int column[count > 0 ? count : 1], turns = 0;
    double y[count > 0 ? count : 1];
    for (int k = 0; k < count; ++k) column[k] = k;
    for (int k = 0; k < count; ++k) {
        int row = k, best = k;
        for (int i = k; i < count; ++i)
            for (int j = k; j < count; ++j)
                if (fabs(A[i * count + j]) > fabs(A[row * count + best])) row = i, best = j;
        const double pivot = A[row * count + best];
        if (!(fabs(pivot) > least)) return -1;
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
