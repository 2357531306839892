/* At one size, a constant as in generated code: the compiler unrolls it so. */
#include "dynamics/em_close_eigenvalues.h"

enum { n = SIZE };

void omega(const double *s, const double *mu, double *Omega) { em_omega(n, s, mu, NULL, 0.0, Omega); }
void remember_omega(const double *s, const double *mu, double elapsed, double *kept) { em_remember_omega(n, s, mu, elapsed, kept); }
void delta_rates(const int *rows, const double *C, const double *s, const double *Delta_dot, double *C_dot, double *s_dot,
                 double *lambda) {
    double beta[n * n], Omega[n * n];
    em_congruence(n, C, Delta_dot, beta);
    em_omega_apart(n, s, beta, Omega);
    em_delta_rates(n, rows, C, s, beta, Omega, C_dot, s_dot, lambda);
}
void add_delta_rate(const double *Adot, const double *Y, const double *Mdot, double *Delta_dot) {
    em_add_delta_rate(n, n, Adot, Y, Mdot, Delta_dot);
}
void omega_apart(const double *s, const double *mu, double *Omega) { em_omega_apart(n, s, mu, Omega); }
void factor_rates(const double *C, const double *r, const double *mu, const double *Omega, double *C_dot, double *s_dot) {
    em_factor_rates(n, C, r, mu, Omega, C_dot, s_dot);
}
void turning_push(const double *C, const double *s, const double *r, const double *Omega, const double *s_dot,
                  const double *eta, const double *w, const double *f, double *a, double *q) {
    double T[n * n];
    em_transpose_for_tiles(n, C, T);
    em_turning_push(n, C, T, s, r, Omega, s_dot, eta, w, f, a, q);
}
void triangular_push(const double *L, const double *r, double *Mdot, const double *eta, const double *f, double *a, double *q) {
    em_triangular_push(n, L, r, Mdot, eta, f, a, q);
}
