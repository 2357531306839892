/* At one size, a constant as in generated code, and with what the units of a model share (EM_IS_SHARED_SIZE). */
#define EM_UNIT EM_STEPPER
#include "mass/em_eigenfactors.h"

enum { n = SIZE };

int refine(const double *M, double *C, double *lambda) { return em_refine(n, M, C, lambda); }
int refresh(const double *M, double *C, double *s, double *eta) { return em_refresh(n, M, C, s, eta); }
int cholesky(const double *M, double *L, double *r) { return em_cholesky_aside(n, M, L, r, EM_SINGULAR_PIVOT); }
