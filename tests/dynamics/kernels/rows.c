/* At one size, a constant as in generated code: the compiler unrolls it so. */
#include "constraints/em_multipliers.h"
#include "mass/em_eigenfactors.h"
#include "mass/em_root_switching.h"

enum { n = SIZE, m = n + 1 /* rows */ };

void ranked_rows(const double *Delta, double *pivot, int *row) { em_ranked_rows(n, Delta, pivot, row); }
int rank_of(const double *Delta) { return em_rank(n, Delta); }
int vanished_row(const double *Delta) { return em_vanished_row(n, Delta); }
int least_norm(const double *Delta, double *rhs) { return em_least_norm(n, Delta, rhs, NULL); }
int solve_delta(double *Delta, double *rhs, int flags) {
    em_fault fault;
    return em_solve_delta(n, Delta, rhs, flags, &fault);
}
void product(const double *A, const double *W, double *Y) { em_product(m, n, A, W, Y); }
void velocity(const double *C, const double *s, const double *eta, double *r, double *w, double *v) {
    em_velocity(n, C, s, eta, r, w, v);
}
void rows_on_eta(const double *C, const double *r, const double *A, double *B) { em_rows_on_eta(m, n, C, r, A, B); }
void rows_of_factors(const double *C, const double *s, const double *A, double *B) { em_rows_of_factors(m, n, C, s, A, B); }
void rows_of_root(const double *L, const double *r, const double *A, double *B) { em_rows_of_root(m, n, L, r, A, B); }
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
void products(const double *B, const double *W, double *Delta) {
    for (int row = 0; row < m; ++row)
        for (int column = 0; column < m; ++column) em_add_product(n, B + row * n, W + column * n, Delta + row * m + column);
}
