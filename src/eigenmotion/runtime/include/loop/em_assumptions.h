/* em_assumptions.h: check of numbers against the assumptions of their symbols (codegen/model/check/assumptions.py). */
#ifndef EM_ASSUMPTIONS_H
#define EM_ASSUMPTIONS_H

#include <math.h>

#include "eigenmotion.h"

enum { EM_NEGATIVE = 1, EM_ZERO = 2, EM_POSITIVE = 4, EM_EVEN = 8, EM_ODD = 16, EM_BROKEN = 32 };
enum { EM_SIGNS = EM_NEGATIVE | EM_ZERO | EM_POSITIVE, EM_KINDS = EM_EVEN | EM_ODD | EM_BROKEN };

static inline int em_is_declared(int bits, double value) {
    const int sign = value < 0.0 ? EM_NEGATIVE : value > 0.0 ? EM_POSITIVE : EM_ZERO;
    if (!(bits & sign) || (bits & EM_KINDS) == EM_KINDS) return bits & sign;
    return bits & (value != floor(value) ? EM_BROKEN : fmod(value, 2.0) == 0.0 ? EM_EVEN : EM_ODD);
}

/* -1 and *fault if one of `count` values, of the symbols from place `first` on, violates its assumption; else 0. */
static inline int em_check_declared(const em_declared *declared, int first, int count, const double *values,
                                    em_fault *fault) {
    for (int k = 0; k < count; ++k) {
        if (em_is_declared(declared[first + k].bits, values[k])) continue;
        *fault = (em_fault){EM_VALUE_REFUSED, first + k, -1, values[k]};
        return -1;
    }
    return 0;
}

#endif
