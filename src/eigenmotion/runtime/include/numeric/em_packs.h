/* em_packs.h: arrays padded to packs of four numbers, so that loops over them have no remainder. */
#ifndef EM_PACKS_H
#define EM_PACKS_H

#include "numeric/em_linear.h"

enum { EM_PACK = 4 }; /* numbers of a state are padded to a multiple of it, with zeros */

/* fmin and fmax for numbers: inline where the library's, which mind NaN, are calls. */
EM_INLINE double em_min(double a, double b) { return a < b ? a : b; }
EM_INLINE double em_max(double a, double b) { return a > b ? a : b; }

/* How long an array on the stack is, which has one number at least; and one that is read and written by packs. */
EM_INLINE int em_some(int count) { return count > 0 ? count : 1; }
EM_INLINE int em_padded(int count) { return (em_some(count) + EM_PACK - 1) / EM_PACK * EM_PACK; }

/* EM_PACK numbers in one register, from wherever they stand. */
typedef double em_pack __attribute__((vector_size(8 * EM_PACK), aligned(8), may_alias));

#define EM_PACK_AT(numbers) (*(const em_pack *)(numbers)) /* no functions: those that take vectors which the machine lacks */
#define EM_PUT_PACK(numbers, pack) (*(em_pack *)(numbers) = (pack)) /* are called in ways that compilers warn of */
#define EM_SUM_OF_PACK(a) (((a)[0] + (a)[1]) + ((a)[2] + (a)[3]))

/* Copies numbers, a state or a rate of one, pack by pack as they were written: memcpy reads wider, and waits until all has
 * reached the cache. Compilers turn a loop into a call of it that does not look as if it did more. */
EM_INLINE void em_copy_packs(int count, double *restrict to, const double *restrict from) {
    for (int k = 0; k < count; k += EM_PACK) {
        EM_PUT_PACK(to + k, EM_PACK_AT(from + k));
        __asm__ volatile("");
    }
}

#endif
