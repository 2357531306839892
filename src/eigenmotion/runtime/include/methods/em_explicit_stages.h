/* em_explicit_stages.h: the stages of an explicit Runge-Kutta step, and weighted sums of their rates:
 * of one run, of runs in the lanes of vectors, and of steps of fixed size in lanes.
 *
 * EM_INLINE functions are inlined once for each method, with its tableau a constant. The loops over stages and
 * coefficients then unroll, zero coefficients vanish, and vector loops over the states remain. */
#ifndef EM_EXPLICIT_STAGES_H
#define EM_EXPLICIT_STAGES_H

#include "em_lanes.h"
#include "tableaux/em_butcher.h"

#ifdef EM_ON_LANES
#include "numeric/em_real.h"
typedef real em_chunk; /* what is added at once: a number of every lane, or EM_PACK numbers */
enum { EM_CHUNK = 1 };
#define EM_READ_ONE_BY_ONE(a) (*(a))
#else
#include "numeric/em_packs.h"
typedef em_pack em_chunk;
enum { EM_CHUNK = EM_PACK };
#define EM_READ_ONE_BY_ONE(a) ((em_pack){(a)[0], (a)[1], (a)[2], (a)[3]})
#endif
#define EM_CHUNK_AT(numbers) (*(const em_chunk *)(numbers))

/* A step from y at t by h. Numbers of lanes at run time are next to each other, and the first lanes' step sizes are
 * repeated in h up to EM_MOST_LANES, so that those of a pack are next to each other, too. */
typedef struct em_explicit {
    int size, row;             /* numbers that are integrated, in whole chunks; numbers in a row of K */
    int times, scattered;      /* lanes at run time, else 1; how many of a new row of rates were written one by one */
    const real *t, *h, *y;     /* (times), (times or EM_MOST_LANES), (size) */
    real *K, *argument, *y_new; /* (stages, row), K_0 the rate at y; (size) of a stage; (size) the end of the step */
} em_explicit;

/* dy <- f(t, y). 0, or -1 */
typedef int em_explicit_rate(void *caller, const real *t, const real *y, real *dy);

/* out_i (size) <- y + h sum_j a_ij K_j over j < n, i < sums, or the sums alone: each number is read once. Rates of
 * K_(n - 1) that have just been written one by one are read one by one, which volatile enforces: a vector load
 * would wait until all of them have reached the cache (store forwarding). On lanes a sum begins with its first
 * product, elsewhere with 0, since the first coefficient may be zero: which product a compiler fuses with a sum,
 * and so rounding, depends on that. */
EM_INLINE void em_combine_rates(const em_explicit *s, int sums, const double (*restrict a)[EM_STAGES], int n,
                                int integrated, real *const *out) {
    const real h = *s->h;
    for (int k = 0; k < s->size; k += EM_CHUNK) {
        em_chunk sum[2] = {{0.0}};
        EM_UNROLL
        for (int j = 0; j < n; ++j) {
            const real *restrict const K = s->K + j * s->row + k;
            const volatile real *const last = K;
            for (int i = 0; i < sums; ++i) {
                if (a[i][j] == 0.0) continue;
                if (EM_CHUNK == 1 && j == 0) sum[i] = a[i][j] * EM_CHUNK_AT(K);
                else if (integrated && j == n - 1 && k < s->scattered) sum[i] += a[i][j] * EM_READ_ONE_BY_ONE(last);
                else sum[i] += a[i][j] * EM_CHUNK_AT(K);
            }
        }
        for (int i = 0; i < sums; ++i) {
            em_chunk *const to = (em_chunk *)(out[i] + k);
            if (!integrated) *to = sum[i];
            else if (s->times == 1) *to = EM_CHUNK_AT(s->y + k) + h * sum[i];
            else *to = EM_CHUNK_AT(s->y + k) + EM_CHUNK_AT(s->h + k % EM_MOST_LANES) * sum[i];
        }
    }
}

/* out <- the argument of stage i, or the end of the step if that is the row `solution` */
EM_INLINE void em_combine(const em_tableau *rk, const em_explicit *s, int i, real *out) {
    em_combine_rates(s, 1, rk->a + i, i, 1, &out);
}

/* K_first .. K_last. The argument of the stage `solution`, if it is among them, is y_new. 0, or -1 */
EM_INLINE int em_stages(const em_tableau *rk, const em_explicit *s, int first, int last, em_explicit_rate *rate,
                        void *caller) {
    real t[EM_MOST_LANES] __attribute__((aligned(64)));
    EM_UNROLL
    for (int i = first; i <= last; ++i) {
        real *const argument = i == rk->solution ? s->y_new : s->argument;
        for (int k = 0; k < s->times; ++k) t[k] = s->t[k] + rk->c[i] * s->h[k];
        if (i > 0) em_combine(rk, s, i, argument);
        if (rate(caller, t, i > 0 ? argument : s->y, s->K + i * s->row)) return -1;
    }
    return 0;
}

/* First same as last: the last stage is the rate at the end. */
EM_INLINE int em_is_fsal(const em_tableau *rk) { return rk->solution < rk->stages; }

/* The stages from `first`, 0 or 1, on, and y_new. 0, or -1 */
EM_INLINE int em_explicit_step(const em_tableau *rk, const em_explicit *s, int first, em_explicit_rate *rate,
                               void *caller) {
    if (em_stages(rk, s, first, rk->stages - 1, rate, caller)) return -1;
    if (!em_is_fsal(rk)) em_combine(rk, s, rk->solution, s->y_new);
    return 0;
}

#endif
