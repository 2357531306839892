/* em_dependent_rows.h: constraint rows that follow from others, at a state and along any motion from it.
 *
 * At a singular position, such as a dead centre, rows are dependent, too, but only there: neighbouring positions that
 * satisfy the independent rows violate the others. */
#ifndef EM_DEPENDENT_ROWS_H
#define EM_DEPENDENT_ROWS_H

#include "dynamics/em_projection.h"

#define EM_CLEARLY_INDEPENDENT 1e-3  /* rows of length one are independent on the constraints if the part that they
                                        add, squared, exceeds this nearby */
#define EM_FOLLOWING_RESIDUAL 1e-10  /* the allowed residual, relative to its terms, of a row that follows from others
                                        which are satisfied */
#define EM_PROBE_DISTANCE 1e-2       /* distance of a neighbouring position, as a part of the displacement that changes
                                        a row entirely */
#define EM_LEAST_PROBE_DISTANCE 1e-4 /* the smallest such distance, if the first is too large: the residual of a row
                                        that does not follow is proportional to its square */

/* Delta of the rows that hold in every mode; rows of contacts and frictions are decoupled from all others. */
EM_NOINLINE void em_permanent_rows(const em_root *root, double *Delta) {
    memcpy(Delta, root->Delta, sizeof root->Delta);
#ifdef EM_SWITCHED_ROWS
    for (int i = 0; i < N_ROWS; ++i)
        for (int j = 0; j < i; ++j)
            if ((EM_SWITCHED_ROWS >> i | EM_SWITCHED_ROWS >> j) & 1) Delta[i * N_ROWS + j] = 0.0;
#endif
}

/* The root at x, and Delta of its permanent rows. 0, or -1. */
EM_NOINLINE int em_permanent_rows_at(double t, const double *x, const double *c, em_root *root, double *Delta) {
    em_fault fault;
    if (em_root_at(t, x, c, root, &fault)) return -1;
    return em_permanent_rows(root, Delta), 0;
}

/* unit (n) <- the scale of each coordinate: the displacement that changes a row by as much as its terms; if no row
 * contains the coordinate, its own magnitude, or 1. */
EM_NOINLINE void em_coordinate_scales(double t, const double *x, const double *c, double *unit) {
    double A[EM_SOME_ROWS * N], b[EM_SOME_ROWS], phi[EM_SOME_POSITIONS], terms[EM_SOME_POSITIONS];
    pfaffian(t, x, c, A, b);
    if (N_POSITIONS > 0) position(t, x, c, phi, terms);
    for (int k = 0; k < N; ++k) {
        unit[k] = INFINITY;
        for (int row = 0; row < N_POSITIONS; ++row) {
            const double change = terms[row] / fabs(A[row * N + k]);
            if (change > 0.0 && isfinite(change)) unit[k] = fmin(unit[k], change);
        }
        if (isinf(unit[k])) unit[k] = x[k] != 0.0 ? fabs(x[k]) : 1.0;
    }
}

/* x <- a point that satisfies the kept rows; the others are ignored. terms (h) <- the largest terms of phi during the
 * iteration: if all terms vanish at the end, rounding is relative to these. Returns whether it converged. */
EM_NOINLINE int em_satisfy_kept_rows(double t, double *x, const double *c, int kept, double *terms) {
    enum { STEPS = 30, ROUNDINGS = 1000 };
    double residual[EM_SOME_ROWS], here[EM_SOME_POSITIONS];
    em_root root;
    em_fault fault;
    memset(terms, 0, EM_SOME_POSITIONS * sizeof *terms);
    for (int step = 0; step < STEPS; ++step) {
        int worst;
        em_position_residual(t, x, c, residual, here);
        for (int row = 0; row < N_POSITIONS; ++row) {
            terms[row] = fmax(terms[row], here[row]);
            if (!(kept & EM_FIRST_KEPT << row)) residual[row] = 0.0;
        }
        if (em_largest_residual(residual, terms, NULL, &worst) <= ROUNDINGS) return 1;
        if (em_root_at(t, x, c, &root, &fault)) return 0;
        if (em_correct(&root, x, residual, NULL, EM_LEAST_NORM | kept, &fault)) return 0;
    }
    return 0;
}

/* Whether the rows that are not kept follow from the kept ones at x, which satisfies the latter, and whether the
 * rank is the same there. */
EM_NOINLINE int em_rows_follow_at(double t, const double *x, const double *c, int kept, int rank, const double *terms) {
    double residual[EM_SOME_ROWS], here[EM_SOME_POSITIONS], Delta[EM_SOME_ROWS * EM_SOME_ROWS];
    int there;
    em_root root;
    em_position_residual(t, x, c, residual, here);
    for (int row = 0; row < N_POSITIONS; ++row)
        if (!(kept & EM_FIRST_KEPT << row) && !(fabs(residual[row]) <= EM_FOLLOWING_RESIDUAL * terms[row])) return 0;
    if (em_permanent_rows_at(t, x, c, &root, Delta)) return 0;
    return em_independent_rows(EM_SOME_ROWS, Delta, EM_DEPENDENT, &there) <= rank;
}

/* nearby (n) <- x displaced by `part` of `unit` (n), times a different factor of either sign for each coordinate. */
EM_NOINLINE void em_displace(const double *x, const double *unit, double part, double *nearby) {
    for (int k = 0; k < N; ++k) {
        const double some = 1.0 + k * 5 % 7 / 7.0, sign = k % 3 == 1 ? -1.0 : 1.0;
        nearby[k] = x[k] + part * some * sign * unit[k];
    }
}

/* The same at positions on either side of x. */
EM_NOINLINE int em_rows_follow_nearby(double t, const double *x, const double *c, int kept, int rank) {
    double unit[N], nearby[N], terms[EM_SOME_POSITIONS];
    em_coordinate_scales(t, x, c, unit);
    for (int side = 0; side < 2; ++side) {
        int met = 0;
        for (double part = EM_PROBE_DISTANCE; !met && part >= 0.5 * EM_LEAST_PROBE_DISTANCE; part *= 0.1) {
            em_displace(x, unit, side ? -part : part, nearby);
            met = em_satisfy_kept_rows(t, nearby, c, kept, terms);
        }
        if (!met || !em_rows_follow_at(t, nearby, c, kept, rank, terms)) return 0;
    }
    return 1;
}

/* em_model.redundant */
EM_NOINLINE int em_redundant(double t, const double *x, const double *c, int *rows) {
    double near[N], Delta[EM_SOME_ROWS * EM_SOME_ROWS];
    int kept;
    em_root root;
    em_fault fault;
    memset(rows, 0, N_ROWS * sizeof *rows);
    if (N_ROWS == 0 || em_permanent_rows_at(t, x, c, &root, Delta)) return 0;
    if (em_independent_rows(EM_SOME_ROWS, Delta, EM_CLEARLY_INDEPENDENT, &kept) == N_ROWS) return 0;
    memcpy(near, x, sizeof near);
    if (N_POSITIONS > 0 && em_newton_from_afar(t, near, c, EM_SHARED, &fault) < 0) return 0;
    if (em_permanent_rows_at(t, near, c, &root, Delta)) return 0;
    const int rank = em_independent_rows(EM_SOME_ROWS, Delta, EM_DEPENDENT, &kept);
    if (rank == N_ROWS || ((int)N_ROWS <= (int)EM_MOST_ROWS && !em_rows_follow_nearby(t, near, c, kept, rank))) return 0;
    return em_rows_in_doubt(EM_SOME_ROWS, Delta, rows);
}

#endif
