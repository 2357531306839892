/* em_eigenfactors.h: M = C^T S^2 C. How C and s are found and kept, and what they make of velocities and forces. */
#ifndef EM_EIGENFACTORS_H
#define EM_EIGENFACTORS_H

#include "em_linear.h"

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

/* The same where n is known at run time only. */
EM_COLD int em_refresh_any(int n, const double *M, double *C, double *s) { return em_refresh(n, M, C, s, NULL); }

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

/* The largest |S^-1 C M C^T S^-1 - 1|: how far C, s are from the eigenfactors of M, relative to each eigenvalue. */
EM_COLD double em_factor_error(int n, const double *M, const double *C, const double *s) {
    double Lambda[n * n], worst = 0.0;
    em_congruence(n, C, M, Lambda);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) worst = fmax(worst, fabs(Lambda[i * n + j] / (s[i] * s[j]) - (i == j)));
    return worst;
}

/* eta <- C^T S^-1 eta, the velocities (20) */
EM_INLINE void em_velocity_of_eta(int n, const double *restrict C, const double *restrict s, double *restrict eta) {
    double v[n];
    for (int j = 0; j < n; ++j) {
        v[j] = 0.0;
        for (int i = 0; i < n; ++i) v[j] += C[i * n + j] * eta[i] / s[i];
    }
    memcpy(eta, v, sizeof v);
}

/* v <- S C v, the quasi-velocities (17) */
EM_INLINE void em_eta_of_velocity(int n, const double *restrict C, const double *restrict s, double *restrict v) {
    double eta[n];
    for (int i = 0; i < n; ++i) {
        eta[i] = 0.0;
        for (int j = 0; j < n; ++j) eta[i] += C[i * n + j] * v[j];
        eta[i] *= s[i];
    }
    memcpy(v, eta, sizeof eta);
}

/* eta <- C^T S eta, the momenta M xdot. Whatever Omega turns C and eta, they are what the forces make of them. */
EM_INLINE void em_momentum_of_eta(int n, const double *restrict C, const double *restrict s, double *restrict eta) {
    double p[n];
    for (int j = 0; j < n; ++j) {
        p[j] = 0.0;
        for (int i = 0; i < n; ++i) p[j] += C[i * n + j] * (s[i] * eta[i]);
    }
    memcpy(eta, p, sizeof p);
}

/* f <- S^-1 C f: a force, or a constraint row, as the quasi-velocities feel it (28) */
EM_INLINE void em_force_on_eta(int n, const double *restrict C, const double *restrict s, double *restrict f) {
    double a[n];
    for (int i = 0; i < n; ++i) {
        a[i] = 0.0;
        for (int j = 0; j < n; ++j) a[i] += C[i * n + j] * f[j];
        a[i] /= s[i];
    }
    memcpy(f, a, sizeof a);
}

/* whole (n, n) <- with the entries of a block (size, size) at its coordinates */
EM_INLINE void em_spread(int n, int size, const int *coordinate, const double *block, double *whole) {
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) whole[coordinate[i] * n + coordinate[j]] = block[i * size + j];
}

/* block (size, size) <- the entries of `whole` (n, n) at its coordinates */
EM_INLINE void em_gather(int n, int size, const int *coordinate, const double *whole, double *block) {
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) block[i * size + j] = whole[coordinate[i] * n + coordinate[j]];
}

/* v <- C^T S^-1 eta (20), and on the way r = 1 / s and w = S^-1 eta. */
EM_INLINE void em_velocity(int n, const double *restrict C, const double *restrict s, const double *restrict eta,
                           double *restrict r, double *restrict w, double *restrict v) {
    for (int i = 0; i < n; ++i) {
        r[i] = 1.0 / s[i];
        w[i] = r[i] * eta[i];
        v[i] = n == 1 ? w[i] : 0.0;
    }
    for (int i = 0; n > 1 && i < n; ++i)
        for (int j = 0; j < n; ++j) v[j] += C[i * n + j] * w[i];
}

/* B (m, n) <- A C^T S^-1 (28), r = 1 / s; of one row, a force: a = S^-1 C f. */
EM_INLINE void em_rows_on_eta(int m, int n, const double *restrict C, const double *restrict r,
                              const double *restrict A, double *restrict B) {
    for (int row = 0; row < m; ++row)
        for (int i = 0; i < n; ++i) {
            double sum = n == 1 ? A[row] : 0.0;
            for (int j = 0; n > 1 && j < n; ++j) sum += A[row * n + j] * C[i * n + j];
            B[row * n + i] = r[i] * sum;
        }
}

#endif
