/* em_dependent_rows.h: constraint rows that follow from others, at a state and along any motion from it.
 *
 * At a singular position, such as a dead centre, rows are dependent, too, but only there: at neighbouring positions
 * that the independent rows allow, the others are violated. */
#ifndef EM_DEPENDENT_ROWS_H
#define EM_DEPENDENT_ROWS_H

#include "dynamics/em_projection.h"

#define EM_SURELY 1e-3   /* rows of length one whose added part, squared, exceeds this nearby are independent on the
                            constraints */
#define EM_FOLLOWS 1e-10 /* the allowed residual, relative to its terms, of a row that follows from others where
                            these are satisfied */
#define EM_PROBE_DISTANCE 1e-2   /* distance of a neighbouring position, as a part of the displacement that changes a
                                    row entirely */
#define EM_CLOSEST 1e-4  /* the smallest such distance, if the first is too large: the residual of a row that does
                            not follow is its square */

/* Delta of the rows that hold in every mode; rows of contacts and frictions are in it as if they were decoupled. */
EM_NOINLINE void em_lasting_rows(const em_root *root, double *Delta) {
    memcpy(Delta, root->Delta, sizeof root->Delta);
#ifdef EM_SWITCHED_ROWS
    for (int i = 0; i < N_ROWS; ++i)
        for (int j = 0; j < i; ++j)
            if ((EM_SWITCHED_ROWS >> i | EM_SWITCHED_ROWS >> j) & 1) Delta[i * N_ROWS + j] = 0.0;
#endif
}

/* The root at x, and Delta of its permanent rows. 0, or -1. */
EM_NOINLINE int em_lasting_at(double t, const double *x, const double *c, em_root *root, double *Delta) {
    em_fault fault;
    if (em_root_at(t, x, c, root, &fault)) return -1;
    return em_lasting_rows(root, Delta), 0;
}

/* unit (n) <- the change of each coordinate that balances the terms of a row; its own size, or 1, if no row contains
 * it. */
EM_NOINLINE void em_turns_over(double t, const double *x, const double *c, double *unit) {
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

/* x <- a point that satisfies the kept rows, whatever the others; terms (h) <- the largest terms of phi on the way:
 * where all terms vanish, rounding is of these. Returns whether it converged. */
EM_NOINLINE int em_meet_kept(double t, double *x, const double *c, int kept, double *terms) {
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
        if (em_largest_residual(residual, terms, &worst) <= ROUNDINGS) return 1;
        if (em_root_at(t, x, c, &root, &fault)) return 0;
        if (em_correct(&root, x, residual, NULL, EM_LEAST_NORM | kept, &fault)) return 0;
    }
    return 0;
}

/* Whether the rows that are not kept follow from the kept ones at x, which satisfies the latter, and whether the
 * rank is the same there. */
EM_NOINLINE int em_follow_at(double t, const double *x, const double *c, int kept, int rank, const double *terms) {
    double residual[EM_SOME_ROWS], here[EM_SOME_POSITIONS], Delta[EM_SOME_ROWS * EM_SOME_ROWS];
    int there;
    em_root root;
    em_position_residual(t, x, c, residual, here);
    for (int row = 0; row < N_POSITIONS; ++row)
        if (!(kept & EM_FIRST_KEPT << row) && !(fabs(residual[row]) <= EM_FOLLOWS * terms[row])) return 0;
    if (em_lasting_at(t, x, c, &root, Delta)) return 0;
    return em_independent_rows(EM_SOME_ROWS, Delta, EM_DEPENDENT, &there) <= rank;
}

/* x moved by a part of `unit` (n), by a different multiple for each coordinate, in one direction or the other. */
EM_NOINLINE void em_move(const double *x, const double *unit, double part, double *beside) {
    for (int k = 0; k < N; ++k) {
        const double some = 1.0 + k * 5 % 7 / 7.0, sign = k % 3 == 1 ? -1.0 : 1.0;
        beside[k] = x[k] + part * some * sign * unit[k];
    }
}

/* The same at positions on either side of x. */
EM_NOINLINE int em_follow_beside(double t, const double *x, const double *c, int kept, int rank) {
    double unit[N], beside[N], terms[EM_SOME_POSITIONS];
    em_turns_over(t, x, c, unit);
    for (int side = 0; side < 2; ++side) {
        int met = 0;
        for (double part = EM_PROBE_DISTANCE; !met && part >= 0.5 * EM_CLOSEST; part *= 0.1) {
            em_move(x, unit, side ? -part : part, beside);
            met = em_meet_kept(t, beside, c, kept, terms);
        }
        if (!met || !em_follow_at(t, beside, c, kept, rank, terms)) return 0;
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
    if (N_ROWS == 0 || em_lasting_at(t, x, c, &root, Delta)) return 0;
    if (em_independent_rows(EM_SOME_ROWS, Delta, EM_SURELY, &kept) == N_ROWS) return 0;
    memcpy(near, x, sizeof near);
    if (N_POSITIONS > 0 && em_newton_from_afar(t, near, c, EM_SHARED, &fault) < 0) return 0;
    if (em_lasting_at(t, near, c, &root, Delta)) return 0;
    const int rank = em_independent_rows(EM_SOME_ROWS, Delta, EM_DEPENDENT, &kept);
    if (rank == N_ROWS || ((int)N_ROWS <= (int)EM_MOST_ROWS && !em_follow_beside(t, near, c, kept, rank))) return 0;
    return em_rows_in_doubt(EM_SOME_ROWS, Delta, rows);
}

#endif
