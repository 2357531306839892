/* Every kernel of em_linear.h and em_rank.h at one size, a constant as in generated code: the compiler unrolls it so. */
#include "em_rank.h"

enum { n = SIZE };

int cholesky(const double *M, double *L, double *r) { return em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT); }
void forward(const double *L, const double *r, double *b) { em_forward(n, L, r, b); }
void backward(const double *L, const double *r, double *b) { em_backward(n, L, r, b); }
void forward_columns(const double *L, const double *r, double *X) { em_forward_columns(n, L, r, X); }
void transposed(const double *L, double *v) { em_transposed(n, L, v); }
void orthonormalise(double *C) { em_orthonormalise(n, C); }
void congruence(const double *C, const double *M, double *Lambda) { em_congruence(n, C, M, Lambda); }
void jacobi(double *Lambda, double *C, double *eta) { em_jacobi(n, Lambda, C, eta); }
int refresh(const double *M, double *C, double *s, double *eta) { return em_refresh(n, M, C, s, eta); }
int refresh_any(const double *M, double *C, double *s) { return em_refresh_any(n, M, C, s); }
int eigenfactors(const double *M, double *C, double *s) { return em_eigenfactors(n, M, C, s); }
int prepare_block(const double *M, double *C, double *s, double *L, double *r) { return em_prepare_block(n, M, C, s, L, r); }
double factor_error(const double *M, const double *C, const double *s) { return em_factor_error(n, M, C, s); }
double gap(const double *s) { return em_gap(n, s); }
double time_to_crossing(const double *s, const double *mu) { return em_time_to_crossing(n, s, mu); }
void omega(const double *s, const double *mu, double *Omega) { em_omega(n, s, mu, NULL, 0.0, Omega); }
void remember_omega(const double *s, const double *mu, double elapsed, double *kept) { em_remember_omega(n, s, mu, elapsed, kept); }
void from_axes(const double *C, const double *s, double *eta) { em_from_axes(n, C, s, eta); }
void to_axes(const double *C, const double *s, double *b) { em_to_axes(n, C, s, b); }
void onto_axes(const double *C, const double *s, double *v) { em_onto_axes(n, C, s, v); }
void ranked_rows(const double *Delta, double *pivot, int *row) { em_ranked_rows(n, Delta, pivot, row); }
int rank_of(const double *Delta) { return em_rank(n, Delta); }
int vanished_row(const double *Delta) { return em_vanished_row(n, Delta); }
int least_norm(const double *Delta, double *rhs) { return em_least_norm(n, Delta, rhs, NULL); }
int solve_delta(double *Delta, double *rhs, int flags) {
    em_fault fault;
    return em_solve_delta(n, Delta, rhs, flags, &fault);
}
void delta_rates(const int *rows, const double *C, const double *s, const double *Delta_dot, double *C_dot, double *s_dot,
                 double *lambda) {
    em_delta_rates(n, rows, C, s, Delta_dot, C_dot, s_dot, lambda);
}
void add_delta_rate(const double *Adot, const double *Y, const double *Mdot, double *Delta_dot) {
    em_add_delta_rate(n, n, Adot, Y, Mdot, Delta_dot);
}
