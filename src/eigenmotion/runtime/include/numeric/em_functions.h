/* em_functions.h: functions of expressions that C does not have, or not in the form a potential needs. Comparisons
 * are numbers, 1 and 0, as in kernels that are evaluated once per parameter set. */
#ifndef EM_FUNCTIONS_H
#define EM_FUNCTIONS_H

#include "numeric/em_linear.h"

EM_INLINE real em_is(em_truth condition) { return em_where(condition, em_real(1.0), em_real(0.0)); }

EM_INLINE em_truth em_is_nan(real a) { return em_value(a) != em_value(a); }

/* A condition on NaN is undefined: neither it nor its negation holds. */
EM_INLINE real em_of_numbers(real a, real b, em_truth condition) {
    return em_where(em_is_nan(a) | em_is_nan(b), em_real(NAN), em_is(condition));
}

EM_INLINE real em_less(real a, real b) { return em_of_numbers(a, b, em_value(a) < em_value(b)); }
EM_INLINE real em_not_above(real a, real b) { return em_of_numbers(a, b, em_value(a) <= em_value(b)); }
EM_INLINE real em_equal(real a, real b) { return em_of_numbers(a, b, em_value(a) == em_value(b)); }
EM_INLINE real em_not(real a) { return 1.0 - a; }

/* If one condition decides, the other may be undefined: x > 0 and log(x) > 1. */
EM_INLINE real em_and(real a, real b) {
    return em_where((em_value(a) == 0.0) | (em_value(b) == 0.0), em_real(0.0), a * b);
}

EM_INLINE real em_or(real a, real b) { return em_not(em_and(em_not(a), em_not(b))); }

EM_INLINE real em_select(real condition, real yes, real no) {
    return em_where(em_is_nan(condition), condition, em_where(em_value(condition) != 0.0, yes, no));
}

EM_INLINE real em_sign(real a) {
    return em_where(em_is_nan(a), a, em_is(em_value(a) > 0.0) - em_is(em_value(a) < 0.0));
}

EM_INLINE real em_heaviside(real a) {
    return em_where(em_is_nan(a), a, em_is(em_value(a) > 0.0) + 0.5 * em_is(em_value(a) == 0.0));
}

/* Unlike fmin and fmax these propagate NaN: a potential that is undefined must not appear defined. */
EM_INLINE real em_least(real a, real b) { return em_where((em_value(a) < em_value(b)) | em_is_nan(a), a, b); }

EM_INLINE real em_greatest(real a, real b) { return em_where((em_value(a) > em_value(b)) | em_is_nan(a), a, b); }

#endif
