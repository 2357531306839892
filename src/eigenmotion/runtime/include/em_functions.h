/* em_functions.h: functions of expressions that C does not have, or not as a potential needs them. */
#ifndef EM_FUNCTIONS_H
#define EM_FUNCTIONS_H

#include "em_linear.h"

EM_INLINE double em_sign(double a) {
    return a != a ? a : (a > 0.0) - (a < 0.0);
}

EM_INLINE double em_heaviside(double a) {
    return a != a ? a : a > 0.0 ? 1.0 : a < 0.0 ? 0.0 : 0.5;
}

/* Unlike fmin and fmax these pass on what is not a number: a potential that is undefined must not look defined. */
EM_INLINE double em_least(double a, double b) {
    return a < b || a != a ? a : b;
}

EM_INLINE double em_greatest(double a, double b) {
    return a > b || a != a ? a : b;
}

#endif
