/* em_elimination.h: Gaussian elimination of one full system with many right-hand sides. em_lu.h is for small matrices,
 * also complex ones, whose factors are used for many solutions one after the other.
 *
 * Elimination proceeds by four pivots at a time: the entries to the right of them are updated once for all four, so
 * that a row is read and written a quarter as often. The function is compiled twice, once for the vectors that many
 * processors have; which version runs is decided at run time. */
#ifndef EM_ELIMINATION_H
#define EM_ELIMINATION_H

#include <math.h>
#include <stddef.h>

#include "numeric/em_real.h"

/* Attribute of a function that is also compiled for vectors of four and fused multiply-adds, if the processor may
 * have them. */
#if defined(__x86_64__) && defined(__GNUC__)
#define EM_WIDE __attribute__((target("avx2,fma")))
#define EM_IS_WIDE (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#else
#define EM_WIDE
#define EM_IS_WIDE 0
#endif

enum { EM_PIVOTS = 4 };

/* to (count) += factor from */
EM_INLINE void em_add_to(int count, double factor, const double *restrict from, double *restrict to) {
    for (int j = 0; j < count; ++j) to[j] += factor * from[j];
}

/* to (count) += the sum of four rows, `apart` numbers apart, times their `part` */
EM_INLINE void em_add_four(int count, const double *restrict part, const double *restrict from, int apart,
                           double *restrict to) {
    const double *const b = from + apart, *const c = b + apart, *const d = c + apart;
    const double by_a = part[0], by_b = part[1], by_c = part[2], by_d = part[3];
    for (int j = 0; j < count; ++j) to[j] = to[j] + by_a * from[j] + by_b * b[j] + by_c * c[j] + by_d * d[j];
}

/* to (count) -= the sum of four rows times their `part` */
EM_INLINE void em_subtract_four(int count, const double *restrict part, const double *restrict a,
                                const double *restrict b, const double *restrict c, const double *restrict d,
                                double *restrict to) {
    const double by_a = part[0], by_b = part[1], by_c = part[2], by_d = part[3];
    for (int j = 0; j < count / 4 * 4; ++j) to[j] = to[j] - by_a * a[j] - by_b * b[j] - by_c * c[j] - by_d * d[j];
}

/* The same for two rows, which share the loads of the four. */
EM_INLINE void em_subtract_from_two(int count, const double *restrict part, const double *restrict other,
                                    const double *restrict a, const double *restrict b, const double *restrict c,
                                    const double *restrict d, double *restrict to, double *restrict beside) {
    const double p[4] = {part[0], part[1], part[2], part[3]}, q[4] = {other[0], other[1], other[2], other[3]};
    for (int j = 0; j < count / 4 * 4; ++j) {
        to[j] = to[j] - p[0] * a[j] - p[1] * b[j] - p[2] * c[j] - p[3] * d[j];
        beside[j] = beside[j] - q[0] * a[j] - q[1] * b[j] - q[2] * c[j] - q[3] * d[j];
    }
}

/* Swaps the row with the largest entry in this column, among `rows` from `from` on, to the front. */
EM_INLINE void em_best_row_first(int size, double **restrict rows, int from, int column) {
    int best = from;
    double most = fabs(rows[from][column]);
    for (int r = from + 1; r < size; ++r) {
        const double here = fabs(rows[r][column]);
        if (here > most) most = here, best = r;
    }
    double *const kept = rows[best];
    rows[best] = rows[from], rows[from] = kept;
}

/* Eliminates with the pivots from `first` on; the factors are stored in place. 0, or -1: a pivot is zero. */
EM_INLINE int em_eliminate_pivots(int size, int first, double **restrict rows) {
    EM_UNROLL for (int i = 0; i < EM_PIVOTS; ++i) {
        em_best_row_first(size, rows, first + i, first + i);
        const double *const pivot = rows[first + i] + first;
        if (!(fabs(pivot[i]) > 0.0)) return -1;
        const double inverse = 1.0 / pivot[i], beside[EM_PIVOTS] = {pivot[0], pivot[1], pivot[2], pivot[3]};
        for (int r = first + i + 1; r < size; ++r) {
            double *const row = rows[r] + first, part = row[i] *= inverse;
            EM_UNROLL for (int j = i + 1; j < EM_PIVOTS; ++j) row[j] -= part * beside[j];
        }
    }
    return 0;
}

EM_INLINE int em_are_zero(const double *part) {
    return part[0] == 0.0 && part[1] == 0.0 && part[2] == 0.0 && part[3] == 0.0;
}

/* Updates the entries to the right of four pivots, in `width` columns. Rows without entries below the pivots are left
 * as they are: coordinates that are not coupled. */
EM_INLINE void em_eliminate_right(int size, int first, int width, double **rows) {
    const int after = first + EM_PIVOTS, count = width - after;
    double *const *const p = rows + first;
    for (int i = 1; i < EM_PIVOTS; ++i)
        for (int k = 0; k < i; ++k) em_add_to(count, -p[i][first + k], p[k] + after, p[i] + after);
    for (int r = after; r < size; r += 2)
        if (!em_are_zero(rows[r] + first) || !em_are_zero(rows[r + 1] + first)) em_subtract_from_two(count, rows[r] + first, rows[r + 1] + first, p[0] + after, p[1] + after, p[2] + after,
                             p[3] + after, rows[r] + after, rows[r + 1] + after);
}

/* rows (size) of G (size, size) followed by X (size, columns): X <- G^-1 X, in the order of the permuted rows. size
 * and columns are multiples of four. 0, or -1: G is singular. */
EM_INLINE int em_eliminate(int size, int columns, double **rows) {
    for (int first = 0; first < size; first += EM_PIVOTS) {
        if (em_eliminate_pivots(size, first, rows)) return -1;
        em_eliminate_right(size, first, size + columns, rows);
    }
    for (int i = size - 1; i >= 0; --i) {
        double *const x = rows[i] + size;
        int r = i + 1;
        for (; r % EM_PIVOTS; ++r) em_add_to(columns, -rows[i][r], rows[r] + size, x);
        for (; r < size; r += EM_PIVOTS)
            if (!em_are_zero(rows[i] + r)) em_subtract_four(columns, rows[i] + r, rows[r] + size, rows[r + 1] + size, rows[r + 2] + size,
                             rows[r + 3] + size, x);
        const double inverse = 1.0 / rows[i][i];
        for (int j = 0; j < columns; ++j) x[j] *= inverse;
    }
    return 0;
}

#endif
