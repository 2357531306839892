/* At one size, a constant as in generated code: the compiler unrolls it so. */
#include "mass/em_eigenfactors.h"

enum { n = SIZE };

int refine(const double *M, double *C, double *lambda) { return em_refine(n, M, C, lambda); }
int refresh(const double *M, double *C, double *s, double *eta) { return em_refresh(n, M, C, s, eta); }
int cholesky(const double *M, double *L, double *r) { return em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT); }
