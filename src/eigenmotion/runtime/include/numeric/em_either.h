/* em_either.h: C's mathematical functions under their usual names, for double and for a `real` that is not double
 * (EM_OF_REAL(name)). */
#ifndef EM_EITHER_H
#define EM_EITHER_H

#define EM_EITHER(name, a) _Generic((a), real: EM_OF_REAL(name), default: name)
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
