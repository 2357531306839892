/* em_rank.h: independent constraint rows, and multipliers of least norm where rows depend on each other.
 *
 * Rows that depend on each other on the constraints are independent beside them, by the square of the distance: what is
 * asked of Delta there is noise. A run therefore keeps the rows that were independent at its last accepted step (bits
 * of `flags`), and its right-hand sides solve for those: between two accepted steps it integrates the smooth system of
 * independent rows, whose motion is the same. Multipliers of least norm are for what is asked at one state. */
#ifndef EM_RANK_H
#define EM_RANK_H

#include "numeric/em_linear.h"

#define EM_DEPENDENT 1e-11 /* the square of what a row of length one must add to others to be independent of them */
#define EM_TAKES_PART 1e-6 /* a row's part, at length one, in a combination that vanishes: less is rounding's */
#define EM_CONTRADICTS 1e-4 /* of the terms that cancel in a row: what is left where rows do not contradict each other */
#define EM_NOTHING 1e-290   /* what is left of numbers so small that their rounding is not in proportion to them */

enum { EM_ABOUT_ROWS = ~(EM_FIRST_KEPT - 1) | EM_LEAST_NORM };

/* Units (m) in which the rows of B are of length one; rows that vanish beside the others keep theirs. */
EM_NOINLINE void em_row_units(int m, const double *Delta, double *unit) {
    double largest = 0.0;
    for (int i = 0; i < m; ++i) largest = fmax(largest, Delta[i * m + i]);
    for (int i = 0; i < m; ++i) {
        const double square = fmax(Delta[i * m + i], EM_VANISHED * largest);
        unit[i] = square > 0.0 ? 1.0 / sqrt(square) : 1.0;
    }
}

/* Delta = L D L^T by its lower triangle, in the order `row` (m) in which rows add most to those before: L (m, m) by the
 * rows' own numbers, ones not stored; D (m) the squares of what they add, 0 behind the last that is above `tolerance`.
 * Returns how many are. */
EM_NOINLINE int em_pivoted(int m, const double *Delta, double tolerance, double *L, double *D, int *row) {
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

/* The same with all rows at length one, in the units given. */
EM_NOINLINE int em_pivoted_units(int m, const double *Delta, const double *unit, double tolerance, double *L, double *D,
                             int *row) {
    double scaled[m * m];
    for (int i = 0; i < m; ++i)
        for (int j = 0; j <= i; ++j) scaled[i * m + j] = Delta[i * m + j] * unit[i] * unit[j];
    return em_pivoted(m, scaled, tolerance, L, D, row);
}

/* pivot, row (m) <- the rows in the order in which they add most to those before, and the squares of what they add. */
EM_NOINLINE void em_ranked_rows(int m, const double *Delta, double *pivot, int *row) {
    double L[m * m];
    em_pivoted(m, Delta, 0.0, L, pivot, row);
}

/* How many rows are independent, judged with all rows at length one. *kept <- their bits, 0 where they are too many. */
EM_NOINLINE int em_independent_rows(int m, const double *Delta, double tolerance, int *kept) {
    double unit[m], L[m * m], D[m];
    int row[m];
    em_row_units(m, Delta, unit);
    const int rank = em_pivoted_units(m, Delta, unit, tolerance, L, D, row);
    *kept = 0;
    for (int k = 0; k < rank && m <= EM_MOST_ROWS; ++k) *kept |= EM_FIRST_KEPT << row[k];
    return rank;
}

EM_NOINLINE int em_rank(int m, const double *Delta) {
    int kept;
    return em_independent_rows(m, Delta, EM_DEPENDENT, &kept);
}

/* z <- L^-T z, for the first `rank` rows in that order; z by the rows' own numbers. */
EM_NOINLINE void em_pivoted_backward(int m, int rank, const double *L, const int *row, double *z) {
    for (int k = rank - 1; k >= 0; --k)
        for (int i = k + 1; i < rank; ++i) z[row[k]] -= L[row[i] * m + k] * z[row[i]];
}

/* z (m) <- the combination that vanishes of row number `dependent` of the order, behind the first `rank`, and of these. */
EM_NOINLINE void em_vanishing_combination(int m, int rank, const double *L, const int *row, int dependent, double *z) {
    for (int j = 0; j < m; ++j) z[j] = 0.0;
    for (int j = 0; j < rank; ++j) z[row[j]] = -L[row[dependent] * m + j];
    z[row[dependent]] = 1.0;
    em_pivoted_backward(m, rank, L, row, z);
}

/* r (n) <- r without its parts along the `count` orthonormal rows of Q; twice, as once leaves rounding of what is gone. */
EM_NOINLINE void em_remove_rows(int n, int count, const double *Q, double *r) {
    for (int pass = 0; pass < 2 * count; ++pass) {
        const double *const q = Q + pass % count * n;
        double along = 0.0;
        for (int k = 0; k < n; ++k) along += q[k] * r[k];
        for (int k = 0; k < n; ++k) r[k] -= along * q[k];
    }
}

/* How many rows depend on others; rows (m) <- 1 for those that take part in a combination that vanishes, else 0. */
EM_NOINLINE int em_rows_in_doubt(int m, const double *Delta, int *rows) {
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

EM_NOINLINE double em_length(int n, const double *r) {
    double square = 0.0;
    for (int k = 0; k < n; ++k) square += r[k] * r[k];
    return sqrt(square);
}

/* x (m) <- x without its part along the `count` rows (m) of `null`, which become orthonormal. */
EM_NOINLINE void em_remove_parts(int m, int count, double *null, double *x) {
    for (int k = 0; k < count; ++k) {
        double *const row = null + k * m;
        em_remove_rows(m, k, null, row);
        const double length = em_length(m, row);
        for (int j = 0; j < m; ++j) row[j] /= length;
    }
    em_remove_rows(m, count, null, x);
}

/* rhs (m) <- least-norm solution of Delta x = rhs for a positive semi-definite Delta of which the lower triangle is
 * given. Which rows depend on others is judged with all rows at length one. Returns -1, or a row that contradicts those
 * it depends on, by more than rounding of `terms` (m), the sizes of what cancels in rhs (NULL: that is not asked). */
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

/* rhs (m) <- least-norm solution of Delta x = rhs where row `row` depends on those before it, if that is asked for. */
EM_COLD_PATH EM_NOINLINE int em_solve_dependent(int m, const double *Delta, double *rhs, const double *terms, int row, int flags,
                               em_fault *fault) {
    for (int i = 0; i < m; ++i)
        if (!isfinite(Delta[i * m + i]) || !isfinite(rhs[i])) return em_fail(fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    if (!(flags & EM_LEAST_NORM)) return em_fail(fault, EM_DEPENDENT_CONSTRAINTS, row, -1, NAN);
    const int wrong = em_least_norm(m, Delta, rhs, terms);
    return wrong < 0 ? 0 : em_fail(fault, EM_DEPENDENT_CONSTRAINTS, wrong, EM_CONTRADICTION, NAN);
}

#endif
