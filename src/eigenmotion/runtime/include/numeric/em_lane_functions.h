/* em_lane_functions.h: C's mathematical functions on vectors, under their usual names.
 *
 * sin and cos: a = n pi/2 + r, reduced by pi/2 in three parts of which n times the first two is exact, so that fused
 * multiply-add makes no difference (Cody & Waite 1980); then the minimax polynomials on |r| < pi/4 of Sun's fdlibm,
 * whose algorithms exp and log use, too. Results are within two units in the last place of the true value; sin and
 * cos are NaN unless |a| is below 1e6. Functions without a vector form call the C library lane by lane. */
#ifndef EM_LANE_FUNCTIONS_H
#define EM_LANE_FUNCTIONS_H

#include "numeric/em_real.h"

#define EM_LARGEST_LANE_ANGLE 1e6

EM_INLINE real em_lane_fabs(real a) { return (real)((em_truth)a & 0x7fffffffffffffffLL); }

/* a - *n pi/2; if the angle is too large all bits are set, which is NaN */
EM_INLINE real em_lane_reduce(real a, em_truth *n) {
    const double shift = 0x1.8p52;
    const real shifted = a * 0.63661977236758134 + shift, nearest = shifted - shift;
    *n = (em_truth)shifted;
    const real r = ((a - nearest * 0x1.921fb544p+0) - nearest * 0x1.0b4611a6p-34) - nearest * 0x1.3198a2e037073p-69;
    return (real)((em_truth)r | ~(em_lane_fabs(a) < EM_LARGEST_LANE_ANGLE));
}

EM_INLINE real em_lane_sine_near_zero(real r) {
    const real z = r * r;
    real p = z * 1.58969099521155010221e-10 - 2.50507602534068634195e-08;
    p = p * z + 2.75573137070700676789e-06;
    p = p * z - 1.98412698298579493134e-04;
    p = p * z + 8.33333333332248946124e-03;
    p = p * z - 1.66666666666666324348e-01;
    return (p * z) * r + r;
}

EM_INLINE real em_lane_cosine_near_zero(real r) {
    const real z = r * r;
    real p = z * -1.13596475577881948265e-11 + 2.08757232129817482790e-09;
    p = p * z - 2.75573143513906633035e-07;
    p = p * z + 2.48015872894767294178e-05;
    p = p * z - 1.38888888888741095749e-03;
    p = p * z + 4.16666666666666019037e-02;
    p = p * z - 0.5;
    return p * z + 1.0;
}

/* The sine of a + quarter pi/2; quarter: 0 or 1 */
EM_INLINE real em_lane_sine(real a, int quarter) {
    em_truth n;
    const real r = em_lane_reduce(a, &n), s = em_lane_sine_near_zero(r), c = em_lane_cosine_near_zero(r);
    const real value = em_where((n & 1) != 0, quarter ? s : c, quarter ? c : s);
    return (real)((em_truth)value ^ (((n + quarter) & 2) << 62)); /* bit 1 of n becomes the sign */
}

EM_INLINE real em_sin(real a) { return em_lane_sine(a, 0); }
EM_INLINE real em_cos(real a) { return em_lane_sine(a, 1); }

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

/* a = n log 2 + r; 2^n in two factors, each of which is representable. */
EM_INLINE real em_lane_exp(real a) {
    const double shift = 0x1.8p52;
    const real within = em_where(a < 710.0, em_where(a > -746.0, a, em_real(-746.0)), em_real(710.0));
    const real n = (within * 1.44269504088896338700 + shift) - shift, half = (n * 0.5 + shift) - shift;
    const real high = within - n * 6.93147180369123816490e-01, low = n * 1.90821492927058770002e-10, r = high - low;
    const real z = r * r;
    real p = z * 4.13813679705723846039e-08 - 1.65339022054652515390e-06;
    p = p * z + 6.61375632143793436117e-05;
    p = p * z - 2.77777777770155933842e-03;
    p = p * z + 1.66666666666666019037e-01;
    const real c = r - z * p, value = 1.0 + (high + ((r * c) / (2.0 - c) - low));
    const real first = (real)((em_truth)(half + (shift + 1023.0)) << 52);
    const real second = (real)((em_truth)((n - half) + (shift + 1023.0)) << 52);
    return em_where(a == a, (value * first) * second, a);
}

/* a = 2^n (1 + f), 1 + f between sqrt 1/2 and sqrt 2 */
EM_INLINE real em_lane_log(real a) {
    const long long one = 0x3ff0000000000000LL, root = 0x3fe6a09e00000000LL, fraction = 0x000fffffffffffffLL;
    const em_truth tiny = a < DBL_MIN;
    const em_bits bits = (em_bits)em_where(tiny, a * 0x1p54, a) + (unsigned long long)(one - root);
    const real shifted = (real)((bits >> 52) | 0x4330000000000000ULL); /* 2^52 + n + 1023 */
    const real n = shifted - em_where(tiny, em_real(0x1p52 + 1077.0), em_real(0x1p52 + 1023.0));
    const real f = (real)((bits & (unsigned long long)fraction) + (unsigned long long)root) - 1.0;
    const real s = f / (2.0 + f), z = s * s, w = z * z, square = 0.5 * f * f;
    const real even = w * (w * (w * 1.531383769920937332e-01 + 2.222219843214978396e-01) + 3.999999999940941908e-01);
    const real odd = z * (w * (w * (w * 1.479819860511658591e-01 + 1.818357216161805012e-01) + 2.857142874366239149e-01) +
                          6.666666666666735130e-01);
    const real rest = s * (square + (odd + even)) + n * 1.90821492927058770002e-10;
    const real value = n * 6.93147180369123816490e-01 - ((square - rest) - f);
    const real beyond = em_where(a == 0.0, em_real(-INFINITY), em_where(a > 0.0, a, em_real(NAN))); /* 0, infinity, NaN */
    return em_where((a > 0.0) & (a < INFINITY), value, beyond);
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
EM_BY_LANE(erf)
EM_BY_LANE(floor)
EM_BY_LANE(ceil)
EM_BY_TWO_LANES(pow)
EM_BY_TWO_LANES(atan2)

#define EM_OF_REAL(name) em_lane_##name
#include "numeric/em_generic_functions.h"

#endif
