/* em_multipliers.h: Delta = B B^T and the multipliers, block by block of M; and the eigenfactors of Delta. */
#ifndef EM_MULTIPLIERS_H
#define EM_MULTIPLIERS_H

#include "em_rank.h"
#include "em_rates.h"

/* B (m, n) <- A L^-T */
EM_INLINE void em_rows_of_root(int m, int n, const double *restrict L, const double *restrict r,
                               const double *restrict A, double *restrict B) {
    em_copy(m * n, A, B);
    for (int row = 0; row < m; ++row) em_forward(n, L, r, B + row * n);
}

/* B (m, n) <- A C^T S^-1 (28) */
EM_INLINE void em_rows_of_factors(int m, int n, const double *restrict C, const double *restrict s,
                                  const double *restrict A, double *restrict B) {
    em_copy(m * n, A, B);
    for (int row = 0; row < m; ++row) em_force_on_eta(n, C, s, B + row * n);
}

/* load[row] += B (a + q), of one block: what stands on the right of (46). q NULL where B rests. */
EM_INLINE void em_add_to_load(int n, int row, const double *restrict B, const double *restrict a,
                              const double *restrict q, double *restrict load) {
    double sum = load[row];
    for (int i = 0; i < n; ++i) sum += B[row * n + i] * (q ? a[i] + q[i] : a[i]);
    load[row] = sum;
}

/* *sum += a . b */
EM_INLINE void em_add_product(int n, const double *restrict a, const double *restrict b, double *restrict sum) {
    double whole = *sum;
    for (int i = 0; i < n; ++i) whole += a[i] * b[i];
    *sum = whole;
}

/* a (n) -= B^T lambda (45) */
EM_INLINE void em_subtract_reactions(int m, int n, const double *restrict B, const double *restrict lambda,
                                     double *restrict a) {
    for (int i = 0; i < n; ++i) {
        double sum = a[i];
        for (int row = 0; row < m; ++row) sum -= B[row * n + i] * lambda[row];
        a[i] = sum;
    }
}

/* part (g, g) <- the rows and columns listed of the lower triangle of Delta (m, m) */
EM_INLINE void em_part_of_delta(int m, int g, const int *rows, const double *restrict Delta, double *restrict part) {
    for (int i = 0; i < g; ++i)
        for (int j = 0; j <= i; ++j) part[i * g + j] = part[j * g + i] = Delta[rows[i] * m + rows[j]];
}

/* Bdot (m, n) <- (Adot C^T + A Cdot^T - B Sdot) S^-1 (40); C_dot NULL where C rests */
EM_INLINE void em_row_rates(int m, int n, const double *restrict C, const double *restrict r,
                            const double *restrict C_dot, const double *restrict s_dot, const double *restrict A,
                            const double *restrict A_dot, const double *restrict B, double *restrict B_dot) {
    for (int row = 0; row < m; ++row)
        for (int i = 0; i < n; ++i) {
            double sum = -B[row * n + i] * s_dot[i];
            for (int j = 0; j < n; ++j)
                sum += A_dot[row * n + j] * C[i * n + j] + (C_dot ? A[row * n + j] * C_dot[i * n + j] : 0.0);
            B_dot[row * n + i] = r[i] * sum;
        }
}

/* Delta_dot (g, g) += Bdot B^T + B Bdot^T (51), of one block, for the rows listed */
EM_INLINE void em_add_to_delta_rate(int g, int n, const int *rows, const double *restrict B,
                                    const double *restrict B_dot, double *restrict Delta_dot) {
    for (int i = 0; i < g; ++i)
        for (int j = 0; j <= i; ++j) {
            double sum = Delta_dot[i * g + j];
            for (int k = 0; k < n; ++k)
                sum += B_dot[rows[i] * n + k] * B[rows[j] * n + k] + B[rows[i] * n + k] * B_dot[rows[j] * n + k];
            Delta_dot[i * g + j] = Delta_dot[j * g + i] = sum;
        }
}

/* The eigenfactors of Delta (m, m), of the rows listed: C_Ddot = -Omega_D C_D (55), s_Ddot = beta_ii / (2 s_D) (54),
 * Omega_D of (53), continued from `kept` (NULL: not) as in em_omega, and lambda <- C_D^T S_D^-2 C_D lambda (48). */
EM_INLINE int em_delta_rates(int m, const int *rows, const double *restrict C, const double *restrict s,
                             const double *restrict Delta_dot, const double *kept, double since,
                             double *restrict C_dot, double *restrict s_dot, double *restrict lambda) {
    double beta[m * m], Omega[m * m], part[m];
    em_congruence(m, C, Delta_dot, beta);
    const int continued = em_omega(m, s, beta, kept, since, Omega);
    for (int i = 0; i < m; ++i) {
        part[i] = 0.0;
        for (int j = 0; j < m; ++j) {
            double sum = 0.0;
            for (int k = 0; k < m; ++k) sum -= Omega[i * m + k] * C[k * m + j];
            C_dot[i * m + j] = sum;
            part[i] += C[i * m + j] * lambda[rows[j]];
        }
        part[i] /= s[i] * s[i];
        s_dot[i] = 0.5 * beta[i * m + i] / s[i];
    }
    for (int j = 0; j < m; ++j) {
        lambda[rows[j]] = 0.0;
        for (int i = 0; i < m; ++i) lambda[rows[j]] += C[i * m + j] * part[i];
    }
    return continued;
}

/* Delta_dot (m, m) += Adot Y^T + Y Adot^T - Y Mdot Y^T, the part of one block in the rate of A M^-1 A^T;
 * Y (m, n) = A M^-1, Mdot NULL where M is constant. (51) without Bdot. */
EM_COLD void em_add_delta_rate(int m, int n, const double *Adot, const double *Y, const double *Mdot,
                               double *Delta_dot) {
    for (int row = 0; row < m; ++row)
        for (int column = 0; column < m; ++column)
            for (int i = 0; i < n; ++i) {
                double sum = Adot[row * n + i] * Y[column * n + i] + Y[row * n + i] * Adot[column * n + i];
                for (int j = 0; Mdot && j < n; ++j) sum -= Y[row * n + i] * Mdot[i * n + j] * Y[column * n + j];
                Delta_dot[row * m + column] += sum;
            }
}

#endif
