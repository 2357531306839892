/* em_generic_functions.h: type-generic mathematical functions of C, under their usual names: for double, and for a
 * `real` that is not double (EM_OF_REAL(name)). */
#ifndef EM_GENERIC_FUNCTIONS_H
#define EM_GENERIC_FUNCTIONS_H

#define EM_GENERIC(name, a) _Generic((a), real: EM_OF_REAL(name), default: name)
#define fabs(a) EM_GENERIC(fabs, a)(a)
#define sqrt(a) EM_GENERIC(sqrt, a)(a)
#define tan(a) EM_GENERIC(tan, a)(a)
#define asin(a) EM_GENERIC(asin, a)(a)
#define acos(a) EM_GENERIC(acos, a)(a)
#define atan(a) EM_GENERIC(atan, a)(a)
#define sinh(a) EM_GENERIC(sinh, a)(a)
#define cosh(a) EM_GENERIC(cosh, a)(a)
#define tanh(a) EM_GENERIC(tanh, a)(a)
#define asinh(a) EM_GENERIC(asinh, a)(a)
#define acosh(a) EM_GENERIC(acosh, a)(a)
#define atanh(a) EM_GENERIC(atanh, a)(a)
#define exp(a) EM_GENERIC(exp, a)(a)
#define log(a) EM_GENERIC(log, a)(a)
#define erf(a) EM_GENERIC(erf, a)(a)
#define floor(a) EM_GENERIC(floor, a)(a)
#define ceil(a) EM_GENERIC(ceil, a)(a)
#define pow(a, b) EM_GENERIC(pow, a)(a, b)
#define atan2(a, b) EM_GENERIC(atan2, a)(a, b)

#endif
