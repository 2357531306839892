/* em_real.h: `real`, the scalar type of right-hand sides: a double, a vector, or a dual number.
 *
 * NAME.c by default computes with doubles. Compiled a second time with EM_ON_LANES defined it computes with vectors
 * of EM_LANES numbers, at about the cost of one: as many independent states side by side. An operation that fails in
 * a lane leaves NaN there; the caller then repeats that state with doubles, which give the fault. With EM_ON_DUALS
 * as well a vector is one number and its derivative along a direction (em_dual_functions.h). */
#ifndef EM_REAL_H
#define EM_REAL_H

#include <float.h>
#include <math.h>

#ifdef EM_NODES_ALONE /* lanes, too, but only for the nodes of one run, without what ensembles need */
#define EM_ON_LANES
#endif

#ifdef __OPTIMIZE__
#define EM_INLINE static inline __attribute__((always_inline, unused))
#else /* inlining would gain nothing, and take the compiler half as long again */
#define EM_INLINE static inline __attribute__((unused))
#endif
#define EM_NOINLINE static __attribute__((noinline, unused))
#define EM_NOINLINE_KERNEL EM_NOINLINE /* so long that the cost of a call is negligible, while copies take compilers
                                          long */
#define EM_UNUSED __attribute__((unused))
#define EM_WEAK __attribute__((weak))
#define EM_COLD_PATH __attribute__((cold)) /* cold path: called by no step, or by few; optimised for size, which
                                              compiles faster */
#define EM_HOT __attribute__((hot)) /* optimised for speed, although its callers are cold, from which compilers infer
                                       the opposite */

/* The parts of NAME.c that an object file holds: all of it, or the units that -DEM_UNIT=... names
 * (docs/architecture.md). Functions that units share are then not static; the linked library hides them
 * (-fvisibility=hidden). */
#define EM_MODEL 1       /* functions that every step calls, except right-hand sides */
#define EM_ASIDE 2       /* functions that no step calls, and event actions */
#define EM_DERIVATIVES 4 /* partial derivatives, also across event actions */
#define EM_STEPPER 8     /* runs, if the stepper is not an object of its own (em_stepper.c) */
#define EM_RHS 32        /* right-hand sides */
#ifdef EM_UNIT
#define EM_ALONE(unit) ((EM_UNIT) == (unit))
#define EM_HOLDS(unit) ((EM_UNIT) & (unit))
#define EM_EXPORT
#define EM_NOINLINE_KERNEL_EXPORT __attribute__((noinline))
#else
#define EM_ALONE(unit) 0
#define EM_HOLDS(unit) 1
#define EM_EXPORT EM_UNUSED static
#define EM_NOINLINE_KERNEL_EXPORT EM_NOINLINE_KERNEL
#endif

/* A function of matrices of any size, on no path of a right-hand side: units of a model declare it, and the stepper's
 * object, which is compiled once for all models, has it (EM_HOLDS_ANY_SIZE). Functions
 * that steps call need constant sizes to be fast. Units leave them to that object for the sizes of arms and of free
 * bodies (EM_IS_SHARED_SIZE), and compile them themselves for other sizes. */
#if defined(EM_UNIT) && !defined(EM_ON_LANES)
#define EM_ANY_SIZE __attribute__((noinline))
#define EM_HOLDS_ANY_SIZE EM_HOLDS(EM_STEPPER)
#define EM_IS_SHARED_SIZE(n) ((n) == 6 || (n) == 7)
#else
#define EM_ANY_SIZE EM_NOINLINE
#define EM_HOLDS_ANY_SIZE 1
#define EM_IS_SHARED_SIZE(n) 0
#endif

/* Before a loop with a constant count: unroll it completely, so that its numbers become constants. */
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpass-failed" /* below -O2 it does not unroll, and warns: slower, not wrong */
#define EM_UNROLL _Pragma("unroll")
#else
#define EM_UNROLL _Pragma("GCC unroll 16")
#endif

/* The vector width of the machine: wider vectors than it has are slower than none. */
#ifndef EM_LANES
#if defined(__AVX512F__)
#define EM_LANES 8
#elif defined(__AVX__)
#define EM_LANES 4
#elif defined(__SSE2__) || defined(__ARM_NEON)
#define EM_LANES 2
#else
#define EM_LANES 1
#endif
#endif

/* Whether rows of matrices are vectorised by hand. */
#if EM_LANES > 1 && !defined(EM_ON_LANES)
#define EM_PACKED
#endif

#if defined(EM_ON_DUALS)

/* a + i e a', e so small that its square is zero: C's complex arithmetic then computes derivatives. */
typedef double _Complex real;
typedef int em_truth;

#define em_value(a) (__real__(a)) /* the part that is compared */

EM_INLINE real em_real(double a) { return a; }
EM_INLINE real em_where(em_truth condition, real yes, real no) { return condition ? yes : no; }
EM_INLINE double em_number(real a) { return em_value(a); }
EM_INLINE real em_inverse(real a) { return 1.0 / a; }

EM_INLINE int em_fails(real *value, em_truth holds) {
    if (!holds) *value = NAN;
    return 0;
}

#elif defined(EM_ON_LANES)

#define em_value(a) (a)

typedef double real __attribute__((vector_size(8 * EM_LANES), may_alias));
typedef long long em_truth __attribute__((vector_size(8 * EM_LANES))); /* of a comparison: -1 or 0 */

typedef unsigned long long em_bits __attribute__((vector_size(8 * EM_LANES)));

/* a in every lane */
EM_INLINE real em_real(double a) { return a - (real){0.0}; }

EM_INLINE real em_where(em_truth condition, real yes, real no) {
    return (real)((condition & (em_truth)yes) | (~condition & (em_truth)no));
}

/* 1 / a to a unit in the last place. A division of wide vectors costs as much as sixteen products: if the machine
 * has an estimate of fourteen bits, two Newton steps double them twice. NaN where the inverse does not exist. */
EM_INLINE real em_inverse(real a) {
#if defined(__AVX512F__) && EM_LANES == 8
    real inverse = __builtin_ia32_rcp14pd512_mask(a, (real){0.0}, 0xff);
    inverse += inverse * (1.0 - a * inverse);
    return inverse + inverse * (1.0 - a * inverse);
#else
    return 1.0 / a;
#endif
}

/* Whether the condition holds in any lane. */
EM_INLINE int em_any(em_truth condition) {
#if defined(__AVX__) && EM_LANES == 4
    return __builtin_ia32_movmskpd256((real)condition) != 0;
#else
    long long any = 0;
    for (int lane = 0; lane < EM_LANES; ++lane) any |= condition[lane];
    return any != 0;
#endif
}

/* The number in some lane of a, for messages. */
EM_INLINE double em_number(real a) { return a[0]; }

/* In lanes where `holds` is false, *value becomes NaN; all continue. */
EM_INLINE int em_fails(real *value, em_truth holds) {
    *value = em_where(holds, *value, em_real(NAN));
    return 0;
}

#else

#define em_value(a) (a)

typedef double real;
typedef int em_truth;

EM_INLINE real em_real(double a) { return a; }
EM_INLINE real em_where(em_truth condition, real yes, real no) { return condition ? yes : no; }
EM_INLINE int em_any(em_truth condition) { return condition; }
EM_INLINE double em_number(real a) { return a; }
EM_INLINE real em_inverse(real a) { return 1.0 / a; }
EM_INLINE int em_fails(EM_UNUSED const real *value, em_truth holds) { return !holds; }

#endif

/* fmin and fmax for numbers that are not NaN: inline, where the library's are calls. */
EM_INLINE real em_min(real a, real b) { return em_where(em_value(a) < em_value(b), a, b); }
EM_INLINE real em_max(real a, real b) { return em_where(em_value(a) > em_value(b), a, b); }

#endif
