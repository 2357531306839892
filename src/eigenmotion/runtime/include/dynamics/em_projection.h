/* em_projection.h: projection of a state onto the constraints, in the mass metric. */
#ifndef EM_PROJECTION_H
#define EM_PROJECTION_H

#include "dynamics/em_mechanics.h"

/* |phi| in units of its rounding, infinite if that is unknown. A number below DBL_MIN has no digits to round, and
 * `least` is the one whose correction has none. */
static double em_in_roundings(double phi, double terms, double least) {
    if (phi == 0.0) return 0.0;
    return isfinite(phi) && isfinite(terms) ? fabs(phi) / fmax(terms * DBL_EPSILON, least) : INFINITY;
}

/* residual (m) <- phi, 0 in the rows of velocities; terms (h): the magnitudes of the terms of phi. */
EM_NOINLINE void em_position_residual(double t, const double *x, const double *c, double *residual, double *terms) {
    double phi[EM_SOME_POSITIONS];
    memset(residual, 0, EM_SOME_ROWS * sizeof *residual);
    position(t, x, c, phi, terms);
    for (int row = 0; row < N_POSITIONS; ++row) residual[row] = phi[row];
}

/* The largest residual in units of its rounding, and *worst, its row. root: if known, else NULL */
EM_NOINLINE double em_largest_residual(const double *residual, const double *terms, const em_root *root, int *worst) {
    double largest = 0.0;
    *worst = 0;
    for (int row = 0; row < N_POSITIONS; ++row) {
        const double least = root ? fmax(DBL_MIN, DBL_MIN * root->Delta[row * N_ROWS + row]) : DBL_MIN;
        const double size = em_in_roundings(residual[row], terms[row], least);
        if (size > largest) largest = size, *worst = row;
    }
    return largest;
}

/* A row that depends on others is satisfied as well as they are: the rounding of the kept rows, in units of their
 * lengths, is allowed for all. */
EM_NOINLINE void em_share_rounding(const em_root *root, int rows, double *terms) {
    double most = 0.0;
    for (int row = 0; row < N_POSITIONS; ++row)
        if (rows & EM_FIRST_KEPT << row) most = fmax(most, terms[row] / sqrt(root->Delta[row * N_ROWS + row]));
    for (int row = 0; row < N_POSITIONS; ++row)
        terms[row] = fmax(terms[row], most * sqrt(root->Delta[row * N_ROWS + row]));
}

/* terms <- the larger of the terms here and before the last step; before <- the terms here. Where all terms vanish
 * with phi, the residual is the rounding of the former terms. */
EM_NOINLINE void em_widen_terms(double *terms, double *before) {
    for (int row = 0; row < N_POSITIONS; ++row) {
        const double here = terms[row];
        terms[row] = fmax(here, before[row]);
        before[row] = here;
    }
}

/* terms += the terms that cancel in each row of Delta lambda, the change of phi by a correction: if a coordinate is 0
 * up to the rounding of corrections of others, phi's own terms do not contain that rounding. lengths (m): the roots of
 * Delta's diagonal. */
EM_NOINLINE void em_add_correction(const double *lengths, const double *lambda, double *terms) {
    double whole = 0.0;
    for (int row = 0; row < N_ROWS; ++row) whole += lengths[row] * fabs(lambda[row]);
    for (int row = 0; row < N_POSITIONS; ++row) terms[row] += lengths[row] * whole;
}

EM_NOINLINE void em_row_lengths(const em_root *root, double *lengths) {
    for (int row = 0; row < N_ROWS; ++row) lengths[row] = sqrt(root->Delta[row * N_ROWS + row]);
}

/* x <- a point with phi(x, t) = 0 by Newton's method in the mass metric, `steps` iterations at most. If rows may be
 * dependent and the kept rows are not given, each iteration keeps those that add more than `tolerance` to others.
 * Returns whether x changed, or -1. */
EM_NOINLINE int em_newton_of(double t, double *x, const double *c, int steps, int least_norm, double tolerance,
                         em_fault *fault) {
    double residual[EM_SOME_ROWS], terms[EM_SOME_POSITIONS], before[EM_SOME_POSITIONS] = {0.0}, lengths[EM_SOME_ROWS];
    em_root root;
    for (int step = 0;; ++step) {
        int worst, rows = least_norm;
        em_position_residual(t, x, c, residual, terms);
        em_widen_terms(terms, before);
        if (least_norm) {
            if (em_root_at(t, x, c, &root, fault)) return -1;
            if (least_norm < EM_FIRST_KEPT) em_independent_rows(EM_SOME_ROWS, root.Delta, tolerance, &rows);
            rows |= EM_LEAST_NORM;
            em_share_rounding(&root, rows, terms);
        }
        double size = em_largest_residual(residual, terms, NULL, &worst);
        if (size > 1.0 && isfinite(size)) {
            if (!least_norm && em_root_at(t, x, c, &root, fault)) return -1;
            size = em_largest_residual(residual, terms, &root, &worst);
        }
        if (size <= 1.0) return step > 0;
        if (isinf(size) || (step == steps && size > 1e3))
            return em_fail(fault, EM_POSITION_NOT_REACHED, worst, -1, fabs(residual[worst]));
        if (step == steps) return 1;
        em_row_lengths(&root, lengths);
        if (em_correct(&root, x, residual, NULL, rows, fault)) return -1;
        em_add_correction(lengths, residual, before);
    }
}

EM_NOINLINE int em_newton(double t, double *x, const double *c, int steps, int least_norm, em_fault *fault) {
    return em_newton_of(t, x, c, steps, least_norm, EM_DEPENDENT, fault);
}

/* The same from far away. Rows that are dependent on the constraints differ slightly off them. So the first attempts
 * use only clearly independent rows; later ones use more, if phi = 0 was not reached. */
EM_COLD_PATH EM_NOINLINE int em_newton_from_afar(double t, double *x, const double *c, int least_norm, em_fault *fault) {
    enum { STEPS = 50 };
    static const double tolerance[] = {1e-2, 1e-4, 1e-6, 1e-8};
    double near[N];
    for (int k = 0; least_norm && k < 4; ++k) {
        memcpy(near, x, sizeof near);
        if (em_newton_of(t, near, c, STEPS, least_norm, tolerance[k], fault) < 0) continue;
        memcpy(x, near, sizeof near);
        return 1;
    }
    return em_newton(t, x, c, STEPS, least_norm, fault);
}

/* v <- the nearest velocity in the mass metric that satisfies the constraints at x. */
EM_NOINLINE int em_project_velocity(double t, const double *x, double *v, const double *c, int least_norm, em_fault *fault) {
    em_root root;
    double A[EM_SOME_ROWS * N], b[EM_SOME_ROWS], terms[EM_SOME_ROWS];
    if (em_root_at(t, x, c, &root, fault)) return -1;
    pfaffian(t, x, c, A, b);
    for (int row = 0; row < N_ROWS; ++row) {
        terms[row] = fabs(b[row]);
        for (int k = 0; k < N; ++k) b[row] += A[row * N + k] * v[k], terms[row] += fabs(A[row * N + k] * v[k]);
    }
    return em_correct(&root, v, b, terms, least_norm, fault);
}

/* x, v <- the nearest state in the mass metric that satisfies the constraints on positions and velocities. */
EM_NOINLINE int em_project(double t, double *x, double *v, const double *c, int least_norm, em_fault *fault) {
    if (N_POSITIONS > 0 && em_newton_from_afar(t, x, c, least_norm, fault) < 0) return -1;
    return N_ROWS > 0 ? em_project_velocity(t, x, v, c, least_norm, fault) : 0;
}

/* The same after a step, from nearby. */
EM_NOINLINE int em_settle_motion(double t, double *x, double *v, const double *c, int least_norm, em_fault *fault) {
    if (N_POSITIONS > 0 && em_newton(t, x, c, 3, least_norm, fault) < 0) return -1;
    return N_ROWS > 0 ? em_project_velocity(t, x, v, c, least_norm, fault) : 0;
}

#endif
