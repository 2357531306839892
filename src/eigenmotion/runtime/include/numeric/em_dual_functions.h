/* em_dual_functions.h: C's mathematical functions on dual numbers (a value and a derivative), under their usual
 * names.
 *
 * f(a + i e a') = f(a) + i e f'(a) a'. If a' is zero so is the derivative, even where f' does not exist; where f'
 * has two one-sided values, one of them is taken. */
#ifndef EM_DUAL_FUNCTIONS_H
#define EM_DUAL_FUNCTIONS_H

#include "numeric/em_real.h"

/* A value whose derivative is `slope` times that of a */
EM_INLINE real em_dual(double value, double slope, real a) {
    real made = value;
    __imag__ made = __imag__ a == 0.0 ? 0.0 : slope * __imag__ a;
    return made;
}

#define EM_DUAL(name, value, slope)                     \
    EM_INLINE real em_dual_##name(real dual) {          \
        const double a = em_value(dual), f = (value);   \
        return em_dual(f, (slope), dual);               \
    }

EM_DUAL(fabs, fabs(a), copysign(1.0, a))
EM_DUAL(sqrt, sqrt(a), 0.5 / f)
EM_DUAL(sin, sin(a), cos(a))
EM_DUAL(cos, cos(a), -sin(a))
EM_DUAL(tan, tan(a), 1.0 + f * f)
EM_DUAL(asin, asin(a), 1.0 / sqrt((1.0 - a) * (1.0 + a)))
EM_DUAL(acos, acos(a), -1.0 / sqrt((1.0 - a) * (1.0 + a)))
EM_DUAL(atan, atan(a), 1.0 / (1.0 + a * a))
EM_DUAL(sinh, sinh(a), cosh(a))
EM_DUAL(cosh, cosh(a), sinh(a))
EM_DUAL(tanh, tanh(a), 1.0 / (cosh(a) * cosh(a)))
EM_DUAL(asinh, asinh(a), 1.0 / hypot(1.0, a))
EM_DUAL(acosh, acosh(a), 1.0 / sqrt((a - 1.0) * (a + 1.0)))
EM_DUAL(atanh, atanh(a), 1.0 / ((1.0 - a) * (1.0 + a)))
EM_DUAL(exp, exp(a), f)
EM_DUAL(log, log(a), 1.0 / a)
EM_DUAL(erf, erf(a), 1.12837916709551257390 * exp(-a * a))
EM_DUAL(floor, floor(a), 0.0)
EM_DUAL(ceil, ceil(a), 0.0)

EM_INLINE real em_sin(real a) { return em_dual_sin(a); }
EM_INLINE real em_cos(real a) { return em_dual_cos(a); }

/* A value that depends on two numbers */
EM_INLINE real em_dual_of_two(double value, double slope_a, real a, double slope_b, real b) {
    real made = em_dual(value, slope_a, a);
    __imag__ made += __imag__ em_dual(value, slope_b, b);
    return made;
}

EM_INLINE real em_dual_pow(real base, real exponent) {
    const double a = em_value(base), b = em_value(exponent), f = pow(a, b);
    return em_dual_of_two(f, b * pow(a, b - 1.0), base, f * log(a), exponent);
}

EM_INLINE real em_dual_atan2(real y, real x) {
    const double a = em_value(y), b = em_value(x), square = a * a + b * b;
    return em_dual_of_two(atan2(a, b), b / square, y, -a / square, x);
}

#define EM_OF_REAL(name) em_dual_##name
#include "numeric/em_generic_functions.h"

#endif
