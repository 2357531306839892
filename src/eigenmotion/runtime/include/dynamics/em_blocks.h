/* em_blocks.h: blocks of M in a run: where the root of a block is stored, and how it acts on velocities, errors and
 * accepted steps. A function that is called with a constant block is compiled for that block. */
#ifndef EM_BLOCKS_H
#define EM_BLOCKS_H

#include "mass/em_eigenfactors.h"
#include "dynamics/em_close_eigenvalues.h"
#include "mass/em_root_switching.h"

/* The location of the root of a block. L includes 1 / diag L. */
typedef enum em_root_location {
    EM_IN_STATE,         /* C and s; in mode 1 L in the run's memory */
    EM_IN_MEMORY,        /* L */
    EM_PREPARED_FACTORS, /* C and s, constant */
    EM_PREPARED_ROOT     /* L, constant */
} em_root_location;

typedef struct em_block {
    int n, size;
    const int *coordinate; /* (size), of n */
    const double *scales;  /* (n): units in which it is factored; NULL: none */
    em_root_location location;
    int C, s, L, r; /* offsets there */
} em_block;

/* Rows that Delta couples, whose eigenfactors are in the state (47). */
typedef struct em_group {
    int size;
    const int *rows; /* (size) */
    int C, s;        /* offsets in the state */
    int kept;        /* offset in memory of Omega_D and its rate */
} em_group;

/* Functions of blocks of any size; the comments are below. */
EM_COLD_PATH EM_ANY_SIZE int em_prepare(const em_block *b, const double *M, double *c, em_fault *fault);
EM_ANY_SIZE int em_velocity_of_root(const em_block *b, const double *M, double *eta, em_fault *fault);
EM_COLD_PATH EM_ANY_SIZE int em_eta_of_root(const em_block *b, const double *M, double *v, em_fault *fault);
EM_COLD_PATH EM_ANY_SIZE int em_change_mode(const em_block *b, int mode, const double *M, double *y, double *memory,
                                            em_fault *fault);
EM_COLD_PATH EM_ANY_SIZE int em_begin_group(const em_group *g, int m, const double *Delta, double *y, em_fault *fault);
EM_ANY_SIZE int em_eigenfactors_of_blocks(const em_block *const *blocks, const double *M, double *C, double *s,
                                          em_fault *fault);
EM_ANY_SIZE int em_coincident_block(const em_block *b, const double *y, em_fault *fault);
EM_ANY_SIZE int em_coincident_group(const em_group *g, const double *y, em_fault *fault);
EM_ANY_SIZE double em_worst_factors(const em_block *const *blocks, const double *M, const double *y, int *first);

EM_INLINE double em_scale(const em_block *b, int i) { return b->scales ? b->scales[b->coordinate[i]] : 1.0; }

/* part (size) <- of `whole` (n) */
EM_INLINE void em_take(const em_block *b, const double *whole, double *part) {
    for (int i = 0; i < b->size; ++i) part[i] = whole[b->coordinate[i]];
}

/* whole (n) <- with `part` (size) */
EM_INLINE void em_put(const em_block *b, const double *part, double *whole) {
    for (int i = 0; i < b->size; ++i) whole[b->coordinate[i]] = part[i];
}

/* M (n, n) <- with the block whose lower triangle is Mb (size, size) */
EM_INLINE void em_put_masses(const em_block *b, const double *Mb, double *M) {
    for (int i = 0; i < b->size; ++i)
        for (int j = 0; j <= i; ++j) {
            const int row = b->coordinate[i], column = b->coordinate[j];
            M[row * b->n + column] = M[column * b->n + row] = Mb[i * b->size + j] / (em_scale(b, i) * em_scale(b, j));
        }
}

/* The same with velocities, which are in units of the block. */
EM_INLINE void em_put_velocity(const em_block *b, const double *part, double *v) {
    for (int i = 0; i < b->size; ++i) v[b->coordinate[i]] = em_scale(b, i) * part[i];
}

EM_COLD_PATH EM_NOINLINE int em_fail_block(const em_block *b, int singular, double size, em_fault *fault) {
    return em_fail(fault, EM_SINGULAR_MASS_MATRIX, b->coordinate[singular], -1, size);
}

/* part (size, size) <- of M (n, n), in units of the block */
EM_INLINE void em_block_of(const em_block *b, const double *M, double *part) {
    for (int i = 0; i < b->size; ++i)
        for (int j = 0; j < b->size; ++j)
            part[i * b->size + j] = em_scale(b, i) * em_scale(b, j) * M[b->coordinate[i] * b->n + b->coordinate[j]];
}

/* eta (size) <- the velocities, with a root that is known without computing M(x) (em_root_location) */
EM_INLINE void em_velocity_in_run(const em_block *b, int mode, const double *y, const double *c, const double *memory,
                                  double *eta) {
    if (b->location == EM_PREPARED_FACTORS) em_velocity_of_eta(b->size, c + b->C, c + b->s, eta);
    else if (b->location == EM_PREPARED_ROOT) em_backward(b->size, c + b->L, c + b->r, eta);
    else if (b->location == EM_IN_MEMORY || mode) em_backward(b->size, memory + b->L, memory + b->r, eta);
    else em_velocity_of_eta(b->size, y + b->C, y + b->s, eta);
}

/* v (n) <- xdot of this block, or the error of xdot that follows from an error `eta` (n) */
EM_INLINE void em_velocity_kept(const em_block *b, int mode, const double *eta, const double *y, const double *c,
                                const double *memory, double *v) {
    double part[b->size];
    em_take(b, eta, part);
    em_velocity_in_run(b, mode, y, c, memory, part);
    em_put_velocity(b, part, v);
}

/* v (n) <- xdot of this block, from a state alone; M (n, n) if L is in a run's memory. 0, or -1 and *fault */
EM_INLINE int em_velocity_at(const em_block *b, int mode, const double *M, const double *y, const double *c, double *v,
                             em_fault *fault) {
    double part[b->size];
    em_take(b, y + b->n, part);
    if (b->location == EM_IN_MEMORY || (b->location == EM_IN_STATE && mode)) {
        if (em_velocity_of_root(b, M, part, fault)) return -1;
    } else
        em_velocity_in_run(b, 0, y, c, NULL, part);
    em_put_velocity(b, part, v);
    return 0;
}

/* y <- with eta = L^T v of this block, whose order is that of the triangular root; M (n, n). 0, or -1 and *fault */
EM_INLINE int em_eta_at(const em_block *b, const double *M, const double *c, const double *v, double *y,
                        em_fault *fault) {
    double part[b->size];
    em_take(b, v, part);
    if (b->location == EM_PREPARED_ROOT) em_transposed(b->size, c + b->L, part);
    else if (em_eta_of_root(b, M, part, fault)) return -1;
    em_put(b, part, y + b->n);
    return 0;
}

/* row (n_state) <- with the quasi-velocities of eigenfactors in the state y */
EM_INLINE void em_publish_block(const em_block *b, const double *v, const double *y, double *row) {
    double eta[b->size];
    for (int i = 0; i < b->size; ++i) eta[i] = v[b->coordinate[i]] / em_scale(b, i);
    em_eta_of_velocity(b->size, y + b->C, y + b->s, eta);
    em_put(b, eta, row + b->n);
}

/* memory <- the root of M (size, size), a block that varies. 0, or -1 and *fault */
EM_INLINE int em_keep_root(const em_block *b, const double *M, double *memory, em_fault *fault) {
    double *const L = memory + b->L, *const r = memory + b->r;
    if (b->size == 1) {
        if (!(M[0] > 0.0)) return em_fail_block(b, 0, M[0], fault);
        L[0] = sqrt(M[0]);
        r[0] = 1.0 / L[0];
        return 0;
    }
    const int singular = em_cholesky_aside(b->size, M, L, r, EM_SINGULAR_PIVOT);
    return singular < 0 ? 0 : em_fail_block(b, singular, 0.0, fault);
}

/* y <- with the eigenfactors of M (size, size). eta is rotated with them; in mode 1 it belongs to the root that is
 * stored in memory, and is unchanged. If Omega was extrapolated (`continued`), the momenta C^T S eta are correct, and
 * not the velocities C^T S^-1 eta. */
EM_INLINE int em_settle_factors(const em_block *b, int mode, int continued, const double *M, double *y, double *memory,
                                em_fault *fault) {
    double eta[b->size];
    em_take(b, y + b->n, eta);
    if (continued) em_momentum_of_eta(b->size, y + b->C, y + b->s, eta);
    const int singular = em_refresh(b->size, M, y + b->C, y + b->s, mode || continued ? NULL : eta);
    if (singular >= 0) return em_fail_block(b, singular, 0.0, fault);
    if (continued) em_force_on_eta(b->size, y + b->C, y + b->s, eta);
    em_put(b, eta, y + b->n);
    return mode ? em_keep_root(b, M, memory, fault) : 0;
}

/* The time to the nearest crossing of eigenvalues of M (size, size) in the state. */
EM_INLINE double em_time_of_block(const em_block *b, const double *Mdot, const double *y) {
    double mu[b->size * b->size];
    em_congruence(b->size, y + b->C, Mdot, mu);
    return em_time_to_crossing(b->size, y + b->s, mu);
}

/* B (m, size) <- the rows A (m, size) in terms of eta (28) */
EM_INLINE void em_rows_of_block(const em_block *b, int mode, int m, const double *y, const double *c,
                                const double *memory, const double *A, double *B) {
    if (b->location == EM_PREPARED_FACTORS) em_rows_of_factors(m, b->size, c + b->C, c + b->s, A, B);
    else if (b->location == EM_PREPARED_ROOT) em_rows_of_root(m, b->size, c + b->L, c + b->r, A, B);
    else if (b->location == EM_IN_MEMORY || mode) em_rows_of_root(m, b->size, memory + b->L, memory + b->r, A, B);
    else em_rows_of_factors(m, b->size, y + b->C, y + b->s, A, B);
}

/* memory <- Omega of (32) and its rate over `elapsed` (0: none yet) */
EM_INLINE void em_remember_block(const em_block *b, const double *Mdot, const double *y, double elapsed,
                                 double *memory) {
    double mu[b->size * b->size];
    em_congruence(b->size, y + b->C, Mdot, mu);
    em_remember_omega(b->size, y + b->s, mu, elapsed, memory + b->L);
}

/* y <- with the eigenfactors of Delta (m, m), of these rows. 0, or -1 and *fault */
EM_INLINE int em_settle_group(const em_group *g, int m, const double *Delta, double *y, em_fault *fault) {
    double part[g->size * g->size];
    em_part_of_delta(m, g->size, g->rows, Delta, part);
    const int singular = em_refresh(g->size, part, y + g->C, y + g->s, NULL);
    return singular < 0 ? 0 : em_fail(fault, EM_DEPENDENT_CONSTRAINTS, g->rows[singular], -1, 0.0);
}

/* Delta_dot (m, m) += the part of one block (51); Mdot NULL where it is constant */
EM_INLINE void em_add_delta_rate_of(const em_block *b, int m, const double *y, const double *c, const double *memory,
                                    const double *A, const double *Adot, const double *Mdot, double *Delta_dot) {
    double Y[m * b->size]; /* A M^-1 */
    em_rows_of_block(b, 0, m, y, c, memory, A, Y);
    for (int row = 0; row < m; ++row) em_velocity_in_run(b, 0, y, c, memory, Y + row * b->size);
    em_add_delta_rate(m, b->size, Adot, Y, Mdot, Delta_dot);
}

/* memory <- Omega_D of (53) and its rate over `elapsed` (0: none yet), beta = C_D Deltadot C_D^T (50) */
EM_INLINE void em_remember_group(const em_group *g, int m, const double *Delta_dot, const double *y, double elapsed,
                                 double *memory) {
    double part[g->size * g->size], beta[g->size * g->size];
    em_part_of_delta(m, g->size, g->rows, Delta_dot, part);
    em_congruence(g->size, y + g->C, part, beta);
    em_remember_omega(g->size, y + g->s, beta, elapsed, memory + g->kept);
}

#if EM_HOLDS_ANY_SIZE

/* c <- both factors of a constant block M (size, size) */
EM_COLD_PATH EM_ANY_SIZE int em_prepare(const em_block *b, const double *M, double *c, em_fault *fault) {
    const int singular = em_prepare_block(b->size, M, c + b->C, c + b->s, c + b->L, c + b->r);
    return singular < 0 ? 0 : em_fail_block(b, singular, 0.0, fault);
}

/* eta (n) <- L^-T eta, with the root of a block of n coordinates */
EM_INLINE int em_velocity_of_size(int n, const em_block *b, const double *M, double *eta, em_fault *fault) {
    double part[n * n], L[n * n], r[n];
    em_block_of(b, M, part);
    const int singular = em_cholesky_any(n, part, L, r, EM_SINGULAR_PIVOT);
    if (singular >= 0) return em_fail_block(b, singular, 0.0, fault);
    em_backward(n, L, r, eta);
    return 0;
}

/* eta (size) <- L^-T eta, M (n, n) = L L^T. Steps call it: small sizes are constants, for which loops are unrolled. */
EM_ANY_SIZE int em_velocity_of_root(const em_block *b, const double *M, double *eta, em_fault *fault) {
    switch (b->size) {
    case 1: return em_velocity_of_size(1, b, M, eta, fault);
    case 2: return em_velocity_of_size(2, b, M, eta, fault);
    case 3: return em_velocity_of_size(3, b, M, eta, fault);
    case 4: return em_velocity_of_size(4, b, M, eta, fault);
    case 6: return em_velocity_of_size(6, b, M, eta, fault);
    default: return em_velocity_of_size(b->size, b, M, eta, fault);
    }
}

/* v (size) <- L^T v, M (n, n) = L L^T */
EM_COLD_PATH EM_ANY_SIZE int em_eta_of_root(const em_block *b, const double *M, double *v, em_fault *fault) {
    double part[b->size * b->size], L[b->size * b->size], r[b->size];
    em_block_of(b, M, part);
    const int singular = em_cholesky_aside(b->size, part, L, r, EM_SINGULAR_PIVOT);
    if (singular >= 0) return em_fail_block(b, singular, 0.0, fault);
    em_transposed(b->size, L, v);
    return 0;
}

/* y <- with the quasi-velocities of the other root of M (size, size), that of `mode`. 0, or -1 and *fault */
EM_COLD_PATH EM_ANY_SIZE int em_change_mode(const em_block *b, int mode, const double *M, double *y, double *memory,
                                            em_fault *fault) {
    double eta[b->size];
    if (mode && em_keep_root(b, M, memory, fault)) return -1;
    em_take(b, y + b->n, eta);
    em_change_root(b->size, mode, y + b->C, y + b->s, memory + b->L, memory + b->r, eta);
    em_put(b, eta, y + b->n);
    return 0;
}

/* y <- with the eigenfactors of Delta (m, m), of these rows, from scratch. 0, or -1 and *fault */
EM_COLD_PATH EM_ANY_SIZE int em_begin_group(const em_group *g, int m, const double *Delta, double *y, em_fault *fault) {
    double part[g->size * g->size];
    em_part_of_delta(m, g->size, g->rows, Delta, part);
    const int singular = em_eigenfactors(g->size, part, y + g->C, y + g->s);
    return singular < 0 ? 0 : em_fail(fault, EM_DEPENDENT_CONSTRAINTS, g->rows[singular], -1, 0.0);
}

/* C (n, n), s (n) of M (n, n), block by block; close to the given C, or from scratch if C is 0. `blocks` ends with
 * NULL. */
EM_ANY_SIZE int em_eigenfactors_of_blocks(const em_block *const *blocks, const double *M, double *C, double *s,
                                          em_fault *fault) {
    for (; *blocks; ++blocks) {
        const em_block *const b = *blocks;
        const int n = b->size;
        double part[n * n], part_C[n * n], part_s[n], size = 0.0;
        em_gather(b->n, n, b->coordinate, M, part);
        em_gather(b->n, n, b->coordinate, C, part_C);
        for (int k = 0; k < n * n; ++k) size += fabs(part_C[k]);
        const int singular = size > 0.0 ? em_refresh_any(n, part, part_C, part_s) : em_eigenfactors(n, part, part_C, part_s);
        if (singular >= 0) return em_fail_block(b, singular, 0.0, fault);
        em_spread(b->n, n, b->coordinate, part_C, C);
        em_put(b, part_s, s);
    }
    return 0;
}

/* Whether two eigenvalues are equal: the published right-hand side does not exist there. */
EM_NOINLINE int em_coincident(int size, const double *s, int *first, int *second) {
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < i; ++j)
            if (s[i] == s[j]) return *first = j, *second = i, 1;
    return 0;
}

EM_ANY_SIZE int em_coincident_block(const em_block *b, const double *y, em_fault *fault) {
    int i, j;
    if (!em_coincident(b->size, y + b->s, &i, &j)) return 0;
    return em_fail(fault, EM_COINCIDENT_EIGENVALUES, b->coordinate[i], b->coordinate[j], 0.0);
}

EM_ANY_SIZE int em_coincident_group(const em_group *g, const double *y, em_fault *fault) {
    int i, j;
    if (!em_coincident(g->size, y + g->s, &i, &j)) return 0;
    return em_fail(fault, EM_COINCIDENT_EIGENVALUES, -1, g->rows[0], 0.0);
}

/* The largest error of C and s in the state as eigenfactors of M (n, n), relative to each eigenvalue; *first <- a
 * coordinate of that block. `blocks` ends with NULL. */
EM_ANY_SIZE double em_worst_factors(const em_block *const *blocks, const double *M, const double *y, int *first) {
    double worst = 0.0;
    for (; *blocks; ++blocks) {
        const em_block *const b = *blocks;
        double part[b->size * b->size];
        if (b->location != EM_IN_STATE) continue;
        em_block_of(b, M, part);
        const double error = em_factor_error(b->size, part, y + b->C, y + b->s);
        if (error <= worst) continue;
        worst = error;
        *first = b->coordinate[0];
    }
    return worst;
}

#endif

#endif
