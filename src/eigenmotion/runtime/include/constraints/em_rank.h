/* em_rank.h: independent constraint rows, and multipliers of least norm where rows depend on each other.
 *
 * Rows that are dependent on the constraints are independent off them, by the square of the distance: the part of
 * Delta that belongs to them is noise. A run therefore keeps the rows that were independent at its last accepted
 * step (bits of `flags`), and its right-hand sides solve for those. Between two accepted steps it thus integrates
 * the smooth system of independent rows, whose motion is the same. Multipliers of least norm are used where a single
 * state is evaluated. */
#ifndef EM_RANK_H
#define EM_RANK_H

#include "numeric/em_linear.h"

#define EM_DEPENDENT 1e-11 /* a row of length one is independent of others if the square of the part that it adds
                              exceeds this */
#define EM_TAKES_PART 1e-6 /* the coefficient of a row of length one in a vanishing combination: smaller ones are
                              rounding */
#define EM_CONTRADICTS 1e-4 /* relative to the terms that cancel in a row: a residual of rows that do not contradict
                               each other */
#define EM_NOTHING 1e-290   /* below this, the rounding of a number is not proportional to it */

enum { EM_ABOUT_ROWS = ~(EM_FIRST_KEPT - 1) | EM_LEAST_NORM }; /* the flags that concern constraint rows */

EM_NOINLINE double em_length(int n, const double *r) {
    double square = 0.0;
    for (int k = 0; k < n; ++k) square += r[k] * r[k];
    return sqrt(square);
}

/* Functions of any number of rows; the comments are below. */
EM_ANY_SIZE int em_pivoted(int m, const double *Delta, double tolerance, double *L, double *D, int *row);
EM_ANY_SIZE void em_ranked_rows(int m, const double *Delta, double *pivot, int *row);
EM_ANY_SIZE int em_independent_rows(int m, const double *Delta, double tolerance, int *kept);
EM_ANY_SIZE int em_rank(int m, const double *Delta);
EM_ANY_SIZE void em_vanishing_combination(int m, int rank, const double *L, const int *row, int dependent, double *z);
EM_ANY_SIZE void em_remove_rows(int n, int count, const double *Q, double *r);
EM_ANY_SIZE int em_rows_in_doubt(int m, const double *Delta, int *rows);
EM_COLD_PATH EM_ANY_SIZE int em_solve_dependent(int m, const double *Delta, double *rhs, const double *terms, int row,
                                                int flags, em_fault *fault);

#if EM_HOLDS_ANY_SIZE

/* Units (m) in which the rows of B have length one; rows that vanish relative to the others keep their unit. */
EM_NOINLINE void em_row_units(int m, const double *Delta, double *unit) {
    double largest = 0.0;
    for (int i = 0; i < m; ++i) largest = fmax(largest, Delta[i * m + i]);
    for (int i = 0; i < m; ++i) {
        const double square = fmax(Delta[i * m + i], EM_VANISHED * largest);
        unit[i] = square > 0.0 ? 1.0 / sqrt(square) : 1.0;
    }
}

/* Pivoted Delta = L D L^T by the lower triangle, in the order `row` (m) in which rows add most to those before: L
 * (m, m) indexed by the original rows, ones not stored; D (m) the squares of the added parts, 0 after the last one
 * above `tolerance`. Returns the rank. */
EM_ANY_SIZE int em_pivoted(int m, const double *Delta, double tolerance, double *L, double *D, int *row) {
    double left[m];
    for (int i = 0; i < m; ++i) left[i] = Delta[i * m + i], row[i] = i, D[i] = 0.0;
    for (int k = 0; k < m; ++k) {
        int most = k;
        for (int i = k + 1; i < m; ++i)
            if (left[row[i]] > left[row[most]]) most = i;
        const int best = row[most];
        if (!(left[best] > tolerance)) return k;
        row[most] = row[k], row[k] = best, D[k] = left[best];
        for (int i = k + 1; i < m; ++i) {
            const int at = row[i];
            double sum = at > best ? Delta[at * m + best] : Delta[best * m + at];
            for (int j = 0; j < k; ++j) sum -= L[at * m + j] * D[j] * L[best * m + j];
            L[at * m + k] = sum / D[k];
            left[at] -= sum * L[at * m + k];
        }
    }
    return m;
}

/* The same with all rows scaled to length one, by the units given. */
EM_NOINLINE int em_pivoted_units(int m, const double *Delta, const double *unit, double tolerance, double *L, double *D,
                             int *row) {
    double scaled[m * m];
    for (int i = 0; i < m; ++i)
        for (int j = 0; j <= i; ++j) scaled[i * m + j] = Delta[i * m + j] * unit[i] * unit[j];
    return em_pivoted(m, scaled, tolerance, L, D, row);
}

/* pivot, row (m) <- the squares of the parts that rows add to those before, and the rows in the order of the
 * largest. */
EM_ANY_SIZE void em_ranked_rows(int m, const double *Delta, double *pivot, int *row) {
    double L[m * m];
    em_pivoted(m, Delta, 0.0, L, pivot, row);
}

/* The number of independent rows, judged with all rows at length one. *kept <- their bits, 0 if there are too many
 * rows for bits. */
EM_ANY_SIZE int em_independent_rows(int m, const double *Delta, double tolerance, int *kept) {
    double unit[m], L[m * m], D[m];
    int row[m];
    em_row_units(m, Delta, unit);
    const int rank = em_pivoted_units(m, Delta, unit, tolerance, L, D, row);
    *kept = 0;
    for (int k = 0; k < rank && m <= EM_MOST_ROWS; ++k) *kept |= EM_FIRST_KEPT << row[k];
    return rank;
}

EM_ANY_SIZE int em_rank(int m, const double *Delta) {
    int kept;
    return em_independent_rows(m, Delta, EM_DEPENDENT, &kept);
}

/* z <- L^-T z, for the first `rank` rows in that order; z is indexed by the original rows. */
EM_NOINLINE void em_pivoted_backward(int m, int rank, const double *L, const int *row, double *z) {
    for (int k = rank - 1; k >= 0; --k)
        for (int i = k + 1; i < rank; ++i) z[row[k]] -= L[row[i] * m + k] * z[row[i]];
}

/* z (m) <- the vanishing combination of row number `dependent` of the order, after the first `rank`, and of these. */
EM_ANY_SIZE void em_vanishing_combination(int m, int rank, const double *L, const int *row, int dependent, double *z) {
    for (int j = 0; j < m; ++j) z[j] = 0.0;
    for (int j = 0; j < rank; ++j) z[row[j]] = -L[row[dependent] * m + j];
    z[row[dependent]] = 1.0;
    em_pivoted_backward(m, rank, L, row, z);
}

/* r (n) <- r without its components along the `count` orthonormal rows of Q; done twice, because once leaves the
 * rounding of what was removed. */
EM_ANY_SIZE void em_remove_rows(int n, int count, const double *Q, double *r) {
    for (int pass = 0; pass < 2 * count; ++pass) {
        const double *const q = Q + pass % count * n;
        double along = 0.0;
        for (int k = 0; k < n; ++k) along += q[k] * r[k];
        for (int k = 0; k < n; ++k) r[k] -= along * q[k];
    }
}

/* The number of rows that depend on others; rows (m) <- 1 for those in a vanishing combination, else 0. */
EM_ANY_SIZE int em_rows_in_doubt(int m, const double *Delta, int *rows) {
    double unit[m], L[m * m], D[m], z[m];
    int order[m];
    memset(L, 0, sizeof L);
    em_row_units(m, Delta, unit);
    const int rank = em_pivoted_units(m, Delta, unit, EM_DEPENDENT, L, D, order);
    for (int i = 0; i < m; ++i) rows[i] = 0;
    for (int i = rank; i < m; ++i) {
        em_vanishing_combination(m, rank, L, order, i, z);
        for (int j = 0; j < m; ++j) rows[j] |= fabs(z[j]) > EM_TAKES_PART;
    }
    return m - rank;
}

/* x (m) <- x without its components along the `count` rows (m) of `null`, which become orthonormal. */
EM_NOINLINE void em_remove_parts(int m, int count, double *null, double *x) {
    for (int k = 0; k < count; ++k) {
        double *const row = null + k * m;
        em_remove_rows(m, k, null, row);
        const double length = em_length(m, row);
        for (int j = 0; j < m; ++j) row[j] /= length;
    }
    em_remove_rows(m, count, null, x);
}

/* rhs (m) <- least-norm solution of Delta x = rhs for a positive semi-definite Delta, given by its lower triangle.
 * Dependence is judged with all rows at length one. Returns -1, or a row that contradicts those it depends on, by
 * more than the rounding of `terms` (m), the sizes of the terms that cancel in rhs (NULL: not checked). */
EM_COLD_PATH EM_NOINLINE int em_least_norm(int m, const double *Delta, double *rhs, const double *terms) {
    double unit[m], L[m * m], D[m], null[m * m], largest = EM_NOTHING;
    int row[m], worst = -1;
    memset(L, 0, sizeof L);
    memset(null, 0, sizeof null);
    em_row_units(m, Delta, unit);
    const int rank = em_pivoted_units(m, Delta, unit, EM_DEPENDENT, L, D, row);
    for (int i = 0; terms && i < m; ++i) largest = fmax(largest, EM_CONTRADICTS * unit[i] * terms[i]);
    for (int i = 0; i < m; ++i) {
        double *const at = rhs + row[i];
        *at *= unit[row[i]];
        for (int j = 0; j < i && j < rank; ++j) *at -= L[row[i] * m + j] * rhs[row[j]];
        if (i >= rank && terms && !(fabs(*at) <= largest)) largest = fabs(*at), worst = row[i];
    }
    for (int i = 0; i < m; ++i) rhs[row[i]] = i < rank ? rhs[row[i]] / D[i] : 0.0;
    em_pivoted_backward(m, rank, L, row, rhs);
    for (int i = rank; i < m; ++i) {
        double *const z = null + (i - rank) * m;
        em_vanishing_combination(m, rank, L, row, i, z);
        for (int j = 0; j < m; ++j) z[j] *= unit[j];
    }
    for (int i = 0; i < m; ++i) rhs[i] *= unit[i];
    em_remove_parts(m, m - rank, null, rhs);
    return worst;
}

/* rhs (m) <- least-norm solution of Delta x = rhs if row `row` depends on those before it and the flags allow it. */
EM_COLD_PATH EM_ANY_SIZE int em_solve_dependent(int m, const double *Delta, double *rhs, const double *terms, int row,
                                                int flags, em_fault *fault) {
    for (int i = 0; i < m; ++i)
        if (!isfinite(Delta[i * m + i]) || !isfinite(rhs[i])) return em_fail(fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    if (!(flags & EM_LEAST_NORM)) return em_fail(fault, EM_DEPENDENT_CONSTRAINTS, row, -1, NAN);
    const int wrong = em_least_norm(m, Delta, rhs, terms);
    return wrong < 0 ? 0 : em_fail(fault, EM_DEPENDENT_CONSTRAINTS, wrong, EM_CONTRADICTION, NAN);
}

#endif

#endif
