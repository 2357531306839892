/* The dense algebra of the headers at one size, a constant as in generated code: the compiler unrolls it so. */
#include "em_multipliers.h"
#include "em_takeover.h"

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
void velocity_of_eta(const double *C, const double *s, double *eta) { em_velocity_of_eta(n, C, s, eta); }
void force_on_eta(const double *C, const double *s, double *f) { em_force_on_eta(n, C, s, f); }
void momentum_of_eta(const double *C, const double *s, double *eta) { em_momentum_of_eta(n, C, s, eta); }
void eta_of_velocity(const double *C, const double *s, double *v) { em_eta_of_velocity(n, C, s, v); }
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

enum { m = n + 1 }; /* rows */

void product(const double *A, const double *W, double *Y) { em_product(m, n, A, W, Y); }
void velocity(const double *C, const double *s, const double *eta, double *r, double *w, double *v) {
    em_velocity(n, C, s, eta, r, w, v);
}
void rows_on_eta(const double *C, const double *r, const double *A, double *B) { em_rows_on_eta(m, n, C, r, A, B); }
void rows_of_factors(const double *C, const double *s, const double *A, double *B) { em_rows_of_factors(m, n, C, s, A, B); }
void rows_of_root(const double *L, const double *r, const double *A, double *B) { em_rows_of_root(m, n, L, r, A, B); }
void omega_apart(const double *s, const double *mu, double *Omega) { em_omega_apart(n, s, mu, Omega); }
void factor_rates(const double *C, const double *r, const double *mu, const double *Omega, double *C_dot, double *s_dot) {
    em_factor_rates(n, C, r, mu, Omega, C_dot, s_dot);
}
void turning_push(const double *C, const double *s, const double *r, const double *Omega, const double *s_dot,
                  const double *eta, const double *w, const double *f, double *a, double *q) {
    em_turning_push(n, C, s, r, Omega, s_dot, eta, w, f, a, q);
}
void triangular_push(const double *L, const double *r, double *Mdot, const double *eta, const double *f, double *a, double *q) {
    em_triangular_push(n, L, r, Mdot, eta, f, a, q);
}
void add_to_load(const double *B, const double *a, const double *q, double *load) {
    for (int row = 0; row < m; ++row) em_add_to_load(n, row, B, a, q, load);
}
void subtract_reactions(const double *B, const double *lambda, double *a) { em_subtract_reactions(m, n, B, lambda, a); }
void row_rates(const double *C, const double *r, const double *C_dot, const double *s_dot, const double *A,
               const double *A_dot, const double *B, double *B_dot) {
    em_row_rates(m, n, C, r, C_dot, s_dot, A, A_dot, B, B_dot);
}
void add_to_delta_rate(const int *rows, const double *B, const double *B_dot, double *Delta_dot) {
    em_add_to_delta_rate(n, n, rows, B, B_dot, Delta_dot);
}
void part_of_delta(const int *rows, const double *Delta, double *part) { em_part_of_delta(m, n, rows, Delta, part); }
void spread(const int *coordinate, const double *block, double *whole) { em_spread(m, n, coordinate, block, whole); }
void gather(const int *coordinate, const double *whole, double *block) { em_gather(m, n, coordinate, whole, block); }
void change_root(int triangular, const double *C, const double *s, const double *L, const double *r, double *eta) {
    em_change_root(n, triangular, C, s, L, r, eta);
}
void velocity_of_triangular(const double *M, double *eta) { em_velocity_of_triangular(n, M, eta); }
int mode_by_gaps(int mode, int flags, double gap, double delta_gap) { return em_mode_by_gaps(mode, flags, gap, delta_gap); }
int mode_by_time(int mode, double gap, double time, double pace) { return em_mode_by_time(mode, gap, time, pace); }
