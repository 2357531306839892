/* At one size, a constant as in generated code: the compiler unrolls it so. */
#include "mass/em_eigenfactors.h"
#include "mass/em_root_switching.h"

enum { n = SIZE };

int cholesky(const double *M, double *L, double *r) { return em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT); }
int ldlt(const double *M, double *L, double *r) { return em_ldlt(n, M, L, r, EM_SINGULAR_PIVOT); }
void forward_unit(const double *L, double *b) { em_forward_unit(n, L, b); }
void backward_unit(const double *L, const double *r, double *b) { em_backward_unit(n, L, r, b); }
void forward(const double *L, const double *r, double *b) { em_forward(n, L, r, b); }
void backward(const double *L, const double *r, double *b) { em_backward(n, L, r, b); }
void forward_columns(const double *L, const double *r, double *X) { em_forward_columns(n, 0, L, r, X); }
void transposed(const double *L, double *v) { em_transposed(n, L, v); }
void orthonormalise(double *C) { em_orthonormalise(n, C); }
void congruence(const double *C, const double *M, double *Lambda) { em_congruence(n, C, M, Lambda); }
void upper_forward_columns(const double *L, const double *r, double *X) { em_forward_columns(n, 1, L, r, X); }
void multiply(double sign, const double *A, const double *B, double *O) { em_multiply(n, 0, sign, A, B, O); }
void lower_multiply(double sign, const double *A, const double *B, double *O) { em_multiply(n, 1, sign, A, B, O); }
void transposed_product(const double *C, const double *w, double *v) { em_transposed_product(n, C, w, v); }
void jacobi(double *Lambda, double *C) { em_jacobi(n, Lambda, C); }
int refine(const double *M, double *C, double *lambda) { return em_refine(n, M, C, lambda); }
void sweep(const double *M, double *C, double *lambda) { em_sweep(n, M, C, lambda); }
int refresh(const double *M, double *C, double *s, double *eta) { return em_refresh(n, M, C, s, eta); }
int refresh_any(const double *M, double *C, double *s) { return em_refresh_any(n, M, C, s); }
int eigenfactors(const double *M, double *C, double *s) { return em_eigenfactors(n, M, C, s); }
int prepare_block(const double *M, double *C, double *s, double *L, double *r) { return em_prepare_block(n, M, C, s, L, r); }
double factor_error(const double *M, const double *C, const double *s) { return em_factor_error(n, M, C, s); }
double gap(const double *s) { return em_gap(n, s); }
double time_to_crossing(const double *s, const double *mu) { return em_time_to_crossing(n, s, mu); }
void velocity_of_eta(const double *C, const double *s, double *eta) { em_velocity_of_eta(n, C, s, eta); }
void force_on_eta(const double *C, const double *s, double *f) { em_force_on_eta(n, C, s, f); }
void momentum_of_eta(const double *C, const double *s, double *eta) { em_momentum_of_eta(n, C, s, eta); }
void eta_of_velocity(const double *C, const double *s, double *v) { em_eta_of_velocity(n, C, s, v); }
int mode_by_gaps(int mode, int flags, double gap, double delta_gap) { return em_mode_by_gaps(mode, flags, gap, delta_gap); }
int mode_by_time(int mode, double gap, double time, double pace) { return em_mode_by_time(mode, gap, time, pace); }
