/* em_linear.h: the small dense linear algebra that generated code shares. Dimensions are constants at every call,
 * so that the compiler unrolls what is small. Matrices are row-major. */
#ifndef EM_LINEAR_H
#define EM_LINEAR_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "eigenmotion.h"
#include "em_trigonometry.h"

enum { EM_STABILISE = 1, EM_KEEP_MODE = 2, EM_LEAST_NORM = 4, EM_BEGIN = 8 };

#define EM_SINGULAR_PIVOT 1e-13 /* a pivot below this part of its diagonal entry leaves fewer than three right digits */

#define EM_INLINE static inline __attribute__((always_inline, unused))
#define EM_COLD static __attribute__((noinline, unused))
#define EM_UNUSED __attribute__((unused))

EM_COLD int em_fail(em_fault *fault, em_status status, int first, int second, double size) {
    fault->status = status;
    fault->first = first;
    fault->second = second;
    fault->size = size;
    return -1;
}

/* L (n, n) lower with M = L L^T; reads the lower triangle of M. r (n): 1 / L_ii.
 * Returns -1, or the index of the first pivot that is not above `tolerance` M_ii.
 * By way of L D L^T: from pivot to pivot leads one division then, and the roots are not waited for. */
EM_INLINE int em_cholesky(int n, const double *restrict M, double *restrict L, double *restrict r, double tolerance) {
    double W[n * n]; /* L D^-1, while L D is in L and D^-1 in r */
    for (int j = 0; j < n; ++j) {
        double pivot = M[j * n + j];
        for (int k = 0; k < j; ++k) pivot -= L[j * n + k] * W[j * n + k];
        if (!(pivot > tolerance * M[j * n + j])) return j;
        L[j * n + j] = pivot;
        r[j] = 1.0 / pivot;
        for (int i = j + 1; i < n; ++i) {
            double sum = M[i * n + j];
            for (int k = 0; k < j; ++k) sum -= L[i * n + k] * W[j * n + k];
            L[i * n + j] = sum;
            W[i * n + j] = sum * r[j];
        }
    }
    for (int j = 0; j < n; ++j) {
        r[j] = sqrt(r[j]);
        for (int i = j; i < n; ++i) L[i * n + j] *= r[j];
    }
    return -1;
}

/* b <- L^-1 b */
EM_INLINE void em_forward(int n, const double *restrict L, const double *restrict r, double *restrict b) {
    for (int i = 0; i < n; ++i) {
        double sum = b[i];
        for (int k = 0; k < i; ++k) sum -= L[i * n + k] * b[k];
        b[i] = sum * r[i];
    }
}

/* b <- L^-T b */
EM_INLINE void em_backward(int n, const double *restrict L, const double *restrict r, double *restrict b) {
    for (int i = n - 1; i >= 0; --i) {
        double sum = b[i];
        for (int k = i + 1; k < n; ++k) sum -= L[k * n + i] * b[k];
        b[i] = sum * r[i];
    }
}

/* C orthonormalised to rounding: C <- (3 I - C C^T) C / 2 (Newton-Schulz), which squares the deviation, as often as
 * it takes. */
EM_INLINE void em_orthonormalise(int n, double *restrict C) {
    double K[n * n], D[n * n], deviation = 1.0;
    for (int pass = 0; pass < 8 && deviation > 1e-8; ++pass) {
        deviation = 0.0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= i; ++j) {
                double sum = i == j ? 1.0 : 0.0;
                for (int k = 0; k < n; ++k) sum -= C[i * n + k] * C[j * n + k];
                deviation = fmax(deviation, fabs(sum));
                K[i * n + j] = K[j * n + i] = 0.5 * sum;
            }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                double sum = C[i * n + j];
                for (int k = 0; k < n; ++k) sum += K[i * n + k] * C[k * n + j];
                D[i * n + j] = sum;
            }
        memcpy(C, D, sizeof D);
    }
}

/* Lambda (n, n) <- C M C^T, both triangles; M full. */
EM_INLINE void em_congruence(int n, const double *restrict C, const double *restrict M, double *restrict Lambda) {
    double W[n * n];
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            double sum = 0.0;
            for (int k = 0; k < n; ++k) sum += C[i * n + k] * M[k * n + j];
            W[i * n + j] = sum;
        }
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            double sum = 0.0;
            for (int k = 0; k < n; ++k) sum += W[i * n + k] * C[j * n + k];
            Lambda[i * n + j] = sum;
            Lambda[j * n + i] = sum;
        }
}

/* X (n, n) <- L^-1 X */
EM_INLINE void em_forward_columns(int n, const double *restrict L, const double *restrict r, double *restrict X) {
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            double sum = X[i * n + j];
            for (int k = 0; k < i; ++k) sum -= L[i * n + k] * X[k * n + j];
            X[i * n + j] = sum * r[i];
        }
}

/* One Jacobi rotation that makes Lambda_pq zero; C and eta (which may be NULL) turn with it. */
EM_INLINE void em_rotate(int n, int p, int q, double *restrict Lambda, double *restrict C, double *restrict eta) {
    const double off = Lambda[p * n + q];
    const double theta = 0.5 * (Lambda[q * n + q] - Lambda[p * n + p]) / off;
    const double tangent = copysign(1.0, theta) / (fabs(theta) + sqrt(theta * theta + 1.0));
    const double cosine = 1.0 / sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
    Lambda[p * n + p] -= tangent * off;
    Lambda[q * n + q] += tangent * off;
    Lambda[p * n + q] = Lambda[q * n + p] = 0.0;
    for (int k = 0; k < n; ++k) {
        const double Cp = C[p * n + k], Cq = C[q * n + k];
        C[p * n + k] = cosine * Cp - sine * Cq;
        C[q * n + k] = sine * Cp + cosine * Cq;
        if (k == p || k == q) continue;
        const double Lp = Lambda[p * n + k], Lq = Lambda[q * n + k];
        Lambda[p * n + k] = Lambda[k * n + p] = cosine * Lp - sine * Lq;
        Lambda[q * n + k] = Lambda[k * n + q] = sine * Lp + cosine * Lq;
    }
    if (eta) {
        const double eta_p = eta[p], eta_q = eta[q];
        eta[p] = cosine * eta_p - sine * eta_q;
        eta[q] = sine * eta_p + cosine * eta_q;
    }
}

/* Cyclic Jacobi sweeps on Lambda = C M C^T until what is off the diagonal is at rounding (Golub & Van Loan, 8.5).
 * Small rotations only where Lambda is nearly diagonal: rows of C keep their order and sign. */
EM_INLINE void em_jacobi(int n, double *restrict Lambda, double *restrict C, double *restrict eta) {
    for (int sweep = 0, rotated = 1; rotated && sweep < 40; ++sweep) {
        rotated = 0;
        for (int p = 0; p < n; ++p)
            for (int q = p + 1; q < n; ++q)
                if (Lambda[p * n + q] * Lambda[p * n + q] >
                    DBL_EPSILON * DBL_EPSILON * fabs(Lambda[p * n + p] * Lambda[q * n + q])) {
                    em_rotate(n, p, q, Lambda, C, eta);
                    rotated = 1;
                }
    }
}

/* Index of the first pivot of M (n, n) that leaves fewer than three right digits, -1 where all are sound; least and
 * largest: its eigenvalues. None is above M_ii, nor below the least: pivots are only looked at where that is small. */
EM_INLINE int em_unsound_pivot(int n, const double *restrict M, double least, double largest) {
    if (least > 10.0 * EM_SINGULAR_PIVOT * largest) return -1;
    double L[n * n], r[n];
    return em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT);
}

/* C, s <- eigenfactors of M (n, n), near the C given; eta turns with C. Returns -1, or an index where M is singular. */
EM_INLINE int em_refresh(int n, const double *restrict M, double *restrict C, double *restrict s, double *restrict eta) {
    double Lambda[n * n];
    em_orthonormalise(n, C);
    em_congruence(n, C, M, Lambda);
    em_jacobi(n, Lambda, C, eta);
    double least = Lambda[0], largest = Lambda[0];
    for (int i = 0; i < n; ++i) {
        if (!(Lambda[i * n + i] > 0.0)) return i;
        s[i] = sqrt(Lambda[i * n + i]);
        least = fmin(least, Lambda[i * n + i]);
        largest = fmax(largest, Lambda[i * n + i]);
    }
    return em_unsound_pivot(n, M, least, largest);
}

/* The largest |S^-1 C M C^T S^-1 - 1|: how far C, s are from the eigenfactors of M, relative to each eigenvalue. */
EM_COLD double em_factor_error(int n, const double *M, const double *C, const double *s) {
    double Lambda[n * n], worst = 0.0;
    em_congruence(n, C, M, Lambda);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) worst = fmax(worst, fabs(Lambda[i * n + j] / (s[i] * s[j]) - (i == j)));
    return worst;
}

/* The smallest distance of two eigenvalues, relative to the larger. */
EM_INLINE double em_gap(int n, const double *restrict s) {
    double gap = INFINITY;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) {
            const double larger = fmax(s[i], s[j]);
            gap = fmin(gap, fabs((s[i] - s[j]) * (s[i] + s[j])) / (larger * larger));
        }
    return gap;
}

/* The same where n is known at run time only. */
EM_COLD int em_refresh_any(int n, const double *M, double *C, double *s) { return em_refresh(n, M, C, s, NULL); }

/* How far in time the nearest crossing is: with M(t + z) = M + z Mdot the eigenvalues i, j meet at a complex z of
 * size |l_i - l_j| / sqrt((mu_ii - mu_jj)^2 + 4 mu_ij^2). A step that is not well inside sees a spike in Omega. */
EM_INLINE double em_time_to_crossing(int n, const double *restrict s, const double *restrict mu) {
    double least = INFINITY;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) {
            const double apart = mu[i * n + i] - mu[j * n + j], across = 2.0 * mu[i * n + j];
            const double speed = sqrt(apart * apart + across * across);
            least = fmin(least, fabs((s[i] - s[j]) * (s[i] + s[j])) / fmax(speed, DBL_MIN));
        }
    return least;
}

/* Whether two eigenvalues are as close as (32) leaves to extrapolation; gap = s_j^2 - s_i^2. */
#define EM_EPSILON 1e-6
EM_INLINE int em_is_close(double gap, double s_i, double s_j) {
    const double larger = fmax(s_i, s_j);
    return fabs(gap) < EM_EPSILON * larger * larger;
}

/* Omega (n, n) <- (32), (53). Where two eigenvalues are close and `kept` is given, (2, n, n) of the last accepted step,
 * Omega(t_0) + Omegadot(t_0) since. Returns whether that was so anywhere. */
EM_INLINE int em_omega(int n, const double *restrict s, const double *restrict mu, const double *kept, double since,
                       double *restrict Omega) {
    int continued = 0;
    for (int i = 0; i < n; ++i) {
        Omega[i * n + i] = 0.0;
        for (int j = 0; j < i; ++j) {
            const int at = i * n + j;
            const double gap = (s[j] - s[i]) * (s[j] + s[i]);
            const int close = kept && em_is_close(gap, s[i], s[j]);
            Omega[at] = close ? kept[at] + since * kept[n * n + at] : mu[at] / gap;
            Omega[j * n + i] = -Omega[at];
            continued |= close;
        }
    }
    return continued;
}

/* kept (2, n, n) <- Omega of (32), (53) here and its difference quotient over `elapsed` (0: none yet). */
EM_INLINE void em_remember_omega(int n, const double *s, const double *mu, double elapsed, double *kept) {
    double Omega[n * n];
    em_omega(n, s, mu, kept, elapsed, Omega);
    for (int at = 0; at < n * n; ++at) {
        kept[n * n + at] = elapsed == 0.0 ? 0.0 : (Omega[at] - kept[at]) / elapsed;
        kept[at] = Omega[at];
    }
}

/* Eigenfactors of M from scratch: s ascending, in each row of C the entry largest in size positive. */
EM_COLD int em_eigenfactors(int n, const double *M, double *C, double *s) {
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) C[i * n + j] = i == j;
    const int singular = em_refresh_any(n, M, C, s);
    if (singular >= 0) return singular;
    for (int i = 0; i < n; ++i) {
        int least = i, largest = 0;
        for (int k = i + 1; k < n; ++k)
            if (s[k] < s[least]) least = k;
        const double root = s[i];
        s[i] = s[least];
        s[least] = root;
        for (int j = 0; j < n; ++j) {
            const double entry = C[i * n + j];
            C[i * n + j] = C[least * n + j];
            C[least * n + j] = entry;
            if (fabs(C[i * n + j]) > fabs(C[i * n + largest]) * (1.0 + 1e-9)) largest = j;
        }
        if (C[i * n + largest] < 0.0)
            for (int j = 0; j < n; ++j) C[i * n + j] = -C[i * n + j];
    }
    return -1;
}

/* Both factors of a constant block: M = C^T S^2 C = L L^T. */
EM_COLD int em_prepare_block(int n, const double *M, double *C, double *s, double *L, double *r) {
    memset(L, 0, sizeof *L * (size_t)(n * n));
    const int singular = em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT);
    return singular >= 0 ? singular : em_eigenfactors(n, M, C, s);
}

/* eta = S C v <-> eta = L^T v: the same velocities under another root of M. */
EM_INLINE void em_transposed(int n, const double *restrict L, double *restrict v) {
    for (int i = 0; i < n; ++i) {
        double sum = 0.0;
        for (int k = i; k < n; ++k) sum += L[k * n + i] * v[k];
        v[i] = sum;
    }
}

/* v <- C^T S^-1 eta */
EM_INLINE void em_from_axes(int n, const double *restrict C, const double *restrict s, double *restrict eta) {
    double v[n];
    for (int j = 0; j < n; ++j) {
        v[j] = 0.0;
        for (int i = 0; i < n; ++i) v[j] += C[i * n + j] * eta[i] / s[i];
    }
    memcpy(eta, v, sizeof v);
}

/* b <- S^-1 C b */
EM_INLINE void em_to_axes(int n, const double *restrict C, const double *restrict s, double *restrict b) {
    double a[n];
    for (int i = 0; i < n; ++i) {
        a[i] = 0.0;
        for (int j = 0; j < n; ++j) a[i] += C[i * n + j] * b[j];
        a[i] /= s[i];
    }
    memcpy(b, a, sizeof a);
}

/* eta <- S C v */
EM_INLINE void em_onto_axes(int n, const double *restrict C, const double *restrict s, double *restrict v) {
    double eta[n];
    for (int i = 0; i < n; ++i) {
        eta[i] = 0.0;
        for (int j = 0; j < n; ++j) eta[i] += C[i * n + j] * v[j];
        eta[i] *= s[i];
    }
    memcpy(v, eta, sizeof eta);
}

/* The eigenfactors of Delta (m, m), of the rows listed: C_Ddot = -Omega_D C_D (55), s_Ddot = beta_ii / (2 s_D) (54),
 * Omega_D of (53), continued from `kept` as in em_omega, and lambda <- C_D^T S_D^-2 C_D lambda (48). */
EM_INLINE int em_delta_rates_near(int m, const int *rows, const double *restrict C, const double *restrict s,
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

/* The same as published. */
EM_INLINE void em_delta_rates(int m, const int *rows, const double *restrict C, const double *restrict s,
                              const double *restrict Delta_dot, double *restrict C_dot, double *restrict s_dot,
                              double *restrict lambda) {
    em_delta_rates_near(m, rows, C, s, Delta_dot, NULL, 0.0, C_dot, s_dot, lambda);
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

EM_INLINE double em_sign(double a) {
    return a != a ? a : (a > 0.0) - (a < 0.0);
}

EM_INLINE double em_heaviside(double a) {
    return a != a ? a : a > 0.0 ? 1.0 : a < 0.0 ? 0.0 : 0.5;
}

/* Unlike fmin and fmax these pass on what is not a number: a potential that is undefined must not look defined. */
EM_INLINE double em_least(double a, double b) {
    return a < b || a != a ? a : b;
}

EM_INLINE double em_greatest(double a, double b) {
    return a > b || a != a ? a : b;
}

#endif
