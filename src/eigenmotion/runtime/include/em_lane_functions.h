/* em_lane_functions.h: C's functions by their names, of vectors as well as of numbers.
 *
 * sin and cos: a = n pi/2 + r, reduced by pi/2 in three parts of which n times the first two is exact, so that it does
 * not matter whether multiplication and subtraction are one operation (Cody & Waite 1980); then the polynomials of
 * em_trigonometry.h. Within two units in the last place of the true value; NaN where |a| is not below 1e6. What the
 * machine has no vectors for is asked of C's library lane by lane. */
#ifndef EM_LANE_FUNCTIONS_H
#define EM_LANE_FUNCTIONS_H

#include "em_real.h"

#define EM_LARGEST_LANE_ANGLE 1e6

EM_INLINE real em_lane_reduce(real a, em_truth *n) {
    const double shift = 0x1.8p52;
    const real shifted = a * 0.63661977236758134 + shift, nearest = shifted - shift;
    *n = (em_truth)shifted;
    const real r = ((a - nearest * 0x1.921fb544p+0) - nearest * 0x1.0b4611a6p-34) - nearest * 0x1.3198a2e037073p-69;
    return em_where((a < EM_LARGEST_LANE_ANGLE) & (a > -EM_LARGEST_LANE_ANGLE), r, em_real(NAN));
}

EM_INLINE real em_lane_sine_near_zero(real r) {
    const real z = r * r;
    real p = z * (-1.0 / 1307674368000.0) + 1.0 / 6227020800.0;
    p = p * z - 1.0 / 39916800.0;
    p = p * z + 1.0 / 362880.0;
    p = p * z - 1.0 / 5040.0;
    p = p * z + 1.0 / 120.0;
    p = p * z - 1.0 / 6.0;
    return (p * z) * r + r;
}

EM_INLINE real em_lane_cosine_near_zero(real r) {
    const real z = r * r;
    real p = z * (1.0 / 20922789888000.0) - 1.0 / 87178291200.0;
    p = p * z + 1.0 / 479001600.0;
    p = p * z - 1.0 / 3628800.0;
    p = p * z + 1.0 / 40320.0;
    p = p * z - 1.0 / 720.0;
    p = p * z + 1.0 / 24.0;
    p = p * z - 0.5;
    return p * z + 1.0;
}

/* The sine of a + quarter pi/2 */
EM_INLINE real em_lane_sine(real a, int quarter) {
    em_truth n;
    const real r = em_lane_reduce(a, &n), s = em_lane_sine_near_zero(r), c = em_lane_cosine_near_zero(r);
    n += quarter;
    const real value = em_where((n & 1) != 0, c, s);
    return (real)((em_truth)value ^ ((n & 2) << 62)); /* bit 1 of n becomes the sign */
}

EM_INLINE real em_sin(real a) { return em_lane_sine(a, 0); }
EM_INLINE real em_cos(real a) { return em_lane_sine(a, 1); }

EM_INLINE real em_lane_fabs(real a) { return (real)((em_truth)a & 0x7fffffffffffffffLL); }

#if defined(__has_builtin)
#if __has_builtin(__builtin_elementwise_sqrt)
#define EM_ELEMENTWISE_SQRT
#endif
#endif

EM_INLINE real em_lane_sqrt(real a) {
#ifdef EM_ELEMENTWISE_SQRT
    return __builtin_elementwise_sqrt(a);
#else
    for (int i = 0; i < EM_LANES; ++i) a[i] = sqrt(a[i]);
    return a;
#endif
}

#define EM_BY_LANE(name)                                           \
    EM_INLINE real em_lane_##name(real a) {                        \
        for (int i = 0; i < EM_LANES; ++i) a[i] = name(a[i]);      \
        return a;                                                  \
    }
#define EM_BY_TWO_LANES(name)                                      \
    EM_INLINE real em_lane_##name(real a, real b) {                \
        for (int i = 0; i < EM_LANES; ++i) a[i] = name(a[i], b[i]); \
        return a;                                                  \
    }

EM_BY_LANE(tan)
EM_BY_LANE(asin)
EM_BY_LANE(acos)
EM_BY_LANE(atan)
EM_BY_LANE(sinh)
EM_BY_LANE(cosh)
EM_BY_LANE(tanh)
EM_BY_LANE(asinh)
EM_BY_LANE(acosh)
EM_BY_LANE(atanh)
EM_BY_LANE(exp)
EM_BY_LANE(log)
EM_BY_LANE(erf)
EM_BY_LANE(floor)
EM_BY_LANE(ceil)
EM_BY_TWO_LANES(pow)
EM_BY_TWO_LANES(atan2)

/* What is written with C's names is meant for either. */
#define EM_EITHER(name, a) _Generic((a), real: em_lane_##name, default: name)
#define fabs(a) EM_EITHER(fabs, a)(a)
#define sqrt(a) EM_EITHER(sqrt, a)(a)
#define tan(a) EM_EITHER(tan, a)(a)
#define asin(a) EM_EITHER(asin, a)(a)
#define acos(a) EM_EITHER(acos, a)(a)
#define atan(a) EM_EITHER(atan, a)(a)
#define sinh(a) EM_EITHER(sinh, a)(a)
#define cosh(a) EM_EITHER(cosh, a)(a)
#define tanh(a) EM_EITHER(tanh, a)(a)
#define asinh(a) EM_EITHER(asinh, a)(a)
#define acosh(a) EM_EITHER(acosh, a)(a)
#define atanh(a) EM_EITHER(atanh, a)(a)
#define exp(a) EM_EITHER(exp, a)(a)
#define log(a) EM_EITHER(log, a)(a)
#define erf(a) EM_EITHER(erf, a)(a)
#define floor(a) EM_EITHER(floor, a)(a)
#define ceil(a) EM_EITHER(ceil, a)(a)
#define pow(a, b) EM_EITHER(pow, a)(a, b)
#define atan2(a, b) EM_EITHER(atan2, a)(a, b)

#endif
