/* em_trigonometry.h: sin and cos that the compiler can inline, pair and interleave.
 *
 * For |a| < 1e5: a = n pi/2 + r with |r| <= pi/4, reduced by two fused multiply-adds (Cody & Waite 1980), then the
 * Taylor polynomials of sin and cos, whose remainders on that range are below a quarter of the last place. Results
 * are within two units in the last place of the true value (tests/dynamics/test_trigonometry.py). For larger |a|,
 * and without fused multiply-add, the C library is used. */
#ifndef EM_TRIGONOMETRY_H
#define EM_TRIGONOMETRY_H

#include "numeric/em_real.h"

#if defined(__FMA__) || defined(__ARM_FEATURE_FMA) /* x86 with a flag, 64-bit ARM always */

#define EM_LARGEST_ANGLE 1e5

/* n and r of a = n pi/2 + r */
EM_INLINE double em_reduce(double a, long *n) {
    const double shift = 0x1.8p52, nearest = (fma(a, 0.63661977236758134, shift)) - shift;
    *n = (long)nearest;
    return fma(-nearest, 6.123233995736766e-17, fma(-nearest, 1.5707963267948966, a));
}

EM_INLINE double em_sine_near_zero(double r) {
    const double z = r * r;
    double p = -1.0 / 1307674368000.0;
    p = fma(p, z, 1.0 / 6227020800.0);
    p = fma(p, z, -1.0 / 39916800.0);
    p = fma(p, z, 1.0 / 362880.0);
    p = fma(p, z, -1.0 / 5040.0);
    p = fma(p, z, 1.0 / 120.0);
    p = fma(p, z, -1.0 / 6.0);
    return fma(p * z, r, r);
}

EM_INLINE double em_cosine_near_zero(double r) {
    const double z = r * r;
    double p = 1.0 / 20922789888000.0;
    p = fma(p, z, -1.0 / 87178291200.0);
    p = fma(p, z, 1.0 / 479001600.0);
    p = fma(p, z, -1.0 / 3628800.0);
    p = fma(p, z, 1.0 / 40320.0);
    p = fma(p, z, -1.0 / 720.0);
    p = fma(p, z, 1.0 / 24.0);
    p = fma(p, z, -0.5);
    return fma(p, z, 1.0);
}

EM_INLINE double em_sin(double a) {
    if (!(fabs(a) < EM_LARGEST_ANGLE)) return sin(a);
    long n;
    const double r = em_reduce(a, &n), s = em_sine_near_zero(r), c = em_cosine_near_zero(r);
    const double value = n & 1 ? c : s;
    return n & 2 ? -value : value;
}

EM_INLINE double em_cos(double a) {
    if (!(fabs(a) < EM_LARGEST_ANGLE)) return cos(a);
    long n;
    const double r = em_reduce(a, &n), s = em_sine_near_zero(r), c = em_cosine_near_zero(r);
    const double value = n & 1 ? s : c;
    return (n + 1) & 2 ? -value : value;
}

#else

EM_INLINE double em_sin(double a) { return sin(a); }
EM_INLINE double em_cos(double a) { return cos(a); }

#endif

#endif
