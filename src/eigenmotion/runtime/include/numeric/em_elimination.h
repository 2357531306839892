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

#include "numeric/em_packs.h"

/* Attribute of a function that is also compiled for vectors of four and fused multiply-adds, if the processor may
 * have them. */
#if defined(__x86_64__) && defined(__GNUC__)
#define EM_FOR_AVX2 __attribute__((target("avx2,fma")))
#define EM_IS_WIDE (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#else
#define EM_FOR_AVX2
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

/* to (count) -= the sum of four rows times their `part`; count is a multiple of four. */
EM_INLINE void em_subtract_four(int count, const double *part, const double *a, const double *b, const double *c, const double *d,
                                double *to) {
    const double p[4] = {part[0], part[1], part[2], part[3]};
    for (int j = 0; j < count; j += EM_PACK) {
        em_pack sum = EM_PACK_AT(to + j) - p[0] * EM_PACK_AT(a + j) - p[1] * EM_PACK_AT(b + j);
        sum = sum - p[2] * EM_PACK_AT(c + j) - p[3] * EM_PACK_AT(d + j);
        EM_PUT_PACK(to + j, sum);
    }
}

/* to, beside (count) -= the sums of four rows times their `part` and `other`; both share the loads of the four. */
EM_INLINE void em_subtract_from_two(int count, const double *part, const double *other, const double *a, const double *b,
                                    const double *c, const double *d, double *to, double *beside) {
    const double p[4] = {part[0], part[1], part[2], part[3]}, q[4] = {other[0], other[1], other[2], other[3]};
    for (int j = 0; j < count; j += EM_PACK) {
        const em_pack x = EM_PACK_AT(a + j), y = EM_PACK_AT(b + j), z = EM_PACK_AT(c + j), w = EM_PACK_AT(d + j);
        em_pack sum = EM_PACK_AT(to + j), next = EM_PACK_AT(beside + j);
        sum -= p[0] * x, next -= q[0] * x, sum -= p[1] * y, next -= q[1] * y;
        sum -= p[2] * z, next -= q[2] * z, sum -= p[3] * w, next -= q[3] * w;
        EM_PUT_PACK(to + j, sum), EM_PUT_PACK(beside + j, next);
    }
}

/* The row with the largest entry in this column, among `rows` from `from` on. */
EM_INLINE int em_best_row(int size, double *const *rows, int from, int column) {
    int best = from;
    double most = 0.0;
    for (int r = from; r < size; ++r) {
        const double here = fabs(rows[r][column]);
        if (here > most) most = here, best = r;
    }
    return best;
}

/* Eliminates with the pivots from `first` on; the factors are stored in place. The row of the next pivot is found as its
 * column is computed. 0, or -1: a pivot is zero. */
EM_INLINE int em_eliminate_pivots(int size, int first, double **restrict rows) {
    int best = em_best_row(size, rows, first, first);
    EM_UNROLL for (int i = 0; i < EM_PIVOTS; ++i) {
        double *const chosen = rows[best], *const pivot = chosen + first;
        rows[best] = rows[first + i], rows[first + i] = chosen;
        if (!(fabs(pivot[i]) > 0.0)) return -1;
        const double inverse = 1.0 / pivot[i], beside[EM_PIVOTS] = {pivot[0], pivot[1], pivot[2], pivot[3]};
        double most = 0.0;
        best = first + i + 1;
        for (int r = first + i + 1; r < size; ++r) {
            double *const row = rows[r] + first, part = row[i] *= inverse;
            EM_UNROLL for (int j = i + 1; j < EM_PIVOTS; ++j) row[j] -= part * beside[j];
            if (i + 1 < EM_PIVOTS && fabs(row[i + 1]) > most) most = fabs(row[i + 1]), best = r;
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

/* X <- the solution in four rows, of which those after them are solved. */
EM_INLINE void em_substitute_back(int size, int first, int columns, double *const *rows) {
    const double *const a = rows[first], *const b = rows[first + 1], *const c = rows[first + 2], *const d = rows[first + 3];
    for (int j = size; j < size + columns; j += EM_PACK) {
        em_pack w = EM_PACK_AT(a + j), x = EM_PACK_AT(b + j), y = EM_PACK_AT(c + j), z = EM_PACK_AT(d + j);
        for (int r = first + EM_PIVOTS; r < size; ++r) {
            const em_pack solved = EM_PACK_AT(rows[r] + j);
            w -= a[r] * solved, x -= b[r] * solved, y -= c[r] * solved, z -= d[r] * solved;
        }
        z *= 1.0 / d[first + 3];
        y = (y - c[first + 3] * z) * (1.0 / c[first + 2]);
        x = (x - b[first + 3] * z - b[first + 2] * y) * (1.0 / b[first + 1]);
        w = (w - a[first + 3] * z - a[first + 2] * y - a[first + 1] * x) * (1.0 / a[first]);
        EM_PUT_PACK(rows[first] + j, w), EM_PUT_PACK(rows[first + 1] + j, x);
        EM_PUT_PACK(rows[first + 2] + j, y), EM_PUT_PACK(rows[first + 3] + j, z);
    }
}

/* rows (size) of G (size, size) followed by X (size, columns): X <- G^-1 X, in the order of the permuted rows. size
 * and columns are multiples of four. 0, or -1: G is singular. */
EM_INLINE int em_eliminate(int size, int columns, double **rows) {
    for (int first = 0; first < size; first += EM_PIVOTS) {
        if (em_eliminate_pivots(size, first, rows)) return -1;
        em_eliminate_right(size, first, size + columns, rows);
    }
    for (int first = size - EM_PIVOTS; first >= 0; first -= EM_PIVOTS) em_substitute_back(size, first, columns, rows);
    return 0;
}

#endif
