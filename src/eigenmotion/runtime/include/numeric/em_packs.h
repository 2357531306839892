/* em_packs.h: arrays padded to packs of four numbers, so that loops over them have no remainder; sums of rows of a
 * matrix. */
#ifndef EM_PACKS_H
#define EM_PACKS_H

#include "numeric/em_linear.h"

enum { EM_PACK = 4 }; /* states are padded to a multiple of this, with zeros */

/* The length of an array on the stack, which must not be 0; and that of an array accessed by packs. */
EM_INLINE int em_some(int count) { return count > 0 ? count : 1; }
EM_INLINE int em_padded(int count) { return (em_some(count) + EM_PACK - 1) / EM_PACK * EM_PACK; }

/* EM_PACK numbers in one register, from any address. */
typedef double em_pack __attribute__((vector_size(8 * EM_PACK), aligned(8), may_alias));

#define EM_PACK_AT(numbers) (*(const em_pack *)(numbers)) /* macros: functions with vectors that the machine lacks */
#define EM_PUT_PACK(numbers, pack) (*(em_pack *)(numbers) = (pack)) /* cause compiler warnings */
#define EM_SUM_OF_PACK(a) (((a)[0] + (a)[1]) + ((a)[2] + (a)[3]))

/* em_sum_rows of columns from j on, this many packs at a time. Returns the first column that is left. */
EM_INLINE int em_sum_packs(int packs, int j, int columns, int count, double sign, const double *part, int apart,
                           const double *X, double factor, double *to) {
    for (; j + packs * EM_PACK <= columns; j += packs * EM_PACK) {
        em_pack sum[4];
        for (int q = 0; q < packs; ++q) sum[q] = EM_PACK_AT(to + j + q * EM_PACK);
        EM_ALONG
        for (int k = 0; k < count; ++k)
            for (int q = 0; q < packs; ++q) sum[q] += sign * part[k * apart] * EM_PACK_AT(X + k * columns + j + q * EM_PACK);
        for (int q = 0; q < packs; ++q) EM_PUT_PACK(to + j + q * EM_PACK, factor * sum[q]);
    }
    return j;
}

/* to (columns) <- factor (to + sign sum_k part[k apart] X[k]), X (count, columns); sign: 1 or -1. The sums stay in
 * registers. */
EM_INLINE void em_sum_rows(int columns, int count, double sign, const double *part, int apart, const double *X,
                           double factor, double *to) {
    int j = em_sum_packs(4, 0, columns, count, sign, part, apart, X, factor, to);
    j = em_sum_packs(1, j, columns, count, sign, part, apart, X, factor, to);
    for (; j < columns; ++j) {
        for (int k = 0; k < count; ++k) to[j] += sign * part[k * apart] * X[k * columns + j];
        to[j] *= factor;
    }
}

/* base to the power of `times`, 0 or more: a call of pow takes longer than a few products. */
EM_INLINE double em_power(double base, int times) {
    double power = 1.0;
    for (; times > 0; --times) power *= base;
    return power;
}

/* *to <- number, in a loop that compilers must not turn into memcpy or memset, whose calls take longer. */
EM_INLINE void em_put_number(double *to, double number) {
    *to = number;
    __asm__ volatile("");
}

/* Copies a state or its rate pack by pack, as it was written: memcpy loads wider words, and waits until all have
 * reached the cache. The form of the loop keeps compilers from turning it into memcpy. */
EM_INLINE void em_copy_packs(int count, double *restrict to, const double *restrict from) {
    for (int k = 0; k < count; k += EM_PACK) {
        EM_PUT_PACK(to + k, EM_PACK_AT(from + k));
        __asm__ volatile("");
    }
}

#endif
