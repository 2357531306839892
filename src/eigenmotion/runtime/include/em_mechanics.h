/* em_mechanics.h: what every model can be asked, written once over the model's own functions.
 *
 * Included by NAME.c after it defined N, N_ROWS, N_POSITIONS, blocks, scales, factored, pfaffian, position,
 * motion_bias and observe. Nothing here is on the path of a right-hand side. */
#ifndef EM_MECHANICS_H
#define EM_MECHANICS_H

#include "em_blocks.h"

#ifdef EM_NORMALS
enum { EM_PUSHED = N_PUSHED }; /* multipliers, and norms of them */
#else
enum { EM_PUSHED = N_ROWS };
#endif
enum { EM_SOME_ROWS = N_ROWS ? N_ROWS : 1, EM_SOME_POSITIONS = N_POSITIONS ? N_POSITIONS : 1 };

/* M = L L^T of all coordinates and B = A L^-T (m, n), b (m), Delta = B B^T by its lower triangle. Where multipliers push by
 * other rows than A, Q = P L^-T (m, n) and pushed = B Q^T; where norms of multipliers do, rows of Q are those at the direction
 * that multipliers have, behind them those of the norms. */
typedef struct em_root {
    double L[N * N], r[N];
    double B[EM_SOME_ROWS * N], b[EM_SOME_ROWS], Delta[EM_SOME_ROWS * EM_SOME_ROWS];
#ifdef EM_PUSHES
    double Q[EM_PUSHED * N], pushed[N_ROWS * EM_PUSHED];
#endif
} em_root;

EM_COLD int em_root_at(double t, const double *x, const double *c, em_root *root, em_fault *fault) {
    double M[N * N];
    factored(t, x, c, M);
    memset(root->L, 0, sizeof root->L);
    const int singular = em_cholesky(N, M, root->L, root->r, EM_SINGULAR_PIVOT);
    if (singular >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, singular, -1, 0.0);
    pfaffian(t, x, c, root->B, root->b);
    for (int row = 0; row < N_ROWS; ++row) {
        em_forward(N, root->L, root->r, root->B + row * N);
        for (int column = 0; column <= row; ++column) {
            double sum = 0.0;
            for (int k = 0; k < N; ++k) sum += root->B[row * N + k] * root->B[column * N + k];
            root->Delta[row * N_ROWS + column] = sum;
        }
    }
    em_rest_rows(N_ROWS, root->Delta);
    return 0;
}

/* lambda (m) <- Delta^-1 lambda. least_norm: 0, 1, or flags that say which rows are kept; terms as in em_least_norm. */
EM_COLD int em_delta(em_root *root, double *lambda, const double *terms, int least_norm, em_fault *fault) {
    if (N_ROWS == 0) return 0;
    const int flags = least_norm ? EM_LEAST_NORM | (least_norm & EM_ABOUT_ROWS) : 0;
    if (flags == EM_LEAST_NORM) return em_solve_dependent(EM_SOME_ROWS, root->Delta, lambda, terms, 0, flags, fault);
    return em_solve_delta(EM_SOME_ROWS, root->Delta, lambda, flags, fault);
}

#ifdef EM_PUSHES
#include "em_pushes.h"
#define EM_REACTIONS(root) (root)->Q
#else
#define EM_REACTIONS(root) (root)->B
#endif

/* a (n), lambda (m): M a + A^T lambda = bias, A a + gamma = 0, with the root at x. */
EM_COLD int em_acceleration_of(em_root *root, double t, const double *x, const double *v, const double *c,
                               const double *u, int least_norm, double *a, double *lambda, em_fault *fault) {
    double gamma[EM_SOME_ROWS], terms[EM_SOME_ROWS];
    motion_bias(t, x, v, c, u, a, gamma);
    em_forward(N, root->L, root->r, a);
    for (int row = 0; row < N_ROWS; ++row) {
        terms[row] = fabs(gamma[row]);
        for (int k = 0; k < N; ++k) {
            gamma[row] += root->B[row * N + k] * a[k];
            terms[row] += fabs(root->B[row * N + k] * a[k]);
        }
    }
#ifdef EM_PUSHES
    em_push(t, x, v, c, u, root);
#ifdef EM_NORMALS
    if (em_solve_push_anew(root, gamma, least_norm ? EM_LEAST_NORM | (least_norm & EM_ABOUT_ROWS) : 0, fault)) return -1;
#else
    if (em_solve_push(root, gamma, least_norm, fault)) return -1;
#endif
#else
    if (em_delta(root, gamma, terms, least_norm, fault)) return -1;
#endif
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        for (int k = 0; k < N; ++k) a[k] -= EM_REACTIONS(root)[row * N + k] * gamma[row];
    }
    em_backward(N, root->L, root->r, a);
    return 0;
}

EM_COLD int em_acceleration(double t, const double *x, const double *v, const double *c, const double *u,
                            int least_norm, double *a, double *lambda, em_fault *fault) {
    em_root root;
    if (em_root_at(t, x, c, &root, fault)) return -1;
    return em_acceleration_of(&root, t, x, v, c, u, least_norm, a, lambda, fault);
}

/* x (n) <- x - M^-1 A^T Delta^-1 e, e (m) the residual: the least change in the mass metric that removes it. */
EM_COLD int em_correct(em_root *root, double *x, double *residual, const double *terms, int least_norm,
                       em_fault *fault) {
    double change[N] = {0.0};
    if (em_delta(root, residual, terms, least_norm, fault)) return -1;
    for (int row = 0; row < N_ROWS; ++row)
        for (int k = 0; k < N; ++k) change[k] += root->B[row * N + k] * residual[row];
    em_backward(N, root->L, root->r, change);
    for (int k = 0; k < N; ++k) x[k] -= change[k];
    return 0;
}

/* |phi| in units of its rounding, infinite where it is not known. No number below DBL_MIN has digits to round. */
static double em_in_roundings(double phi, double terms) {
    if (phi == 0.0) return 0.0;
    return isfinite(phi) && isfinite(terms) ? fabs(phi) / fmax(terms * DBL_EPSILON, DBL_MIN) : INFINITY;
}

/* residual (m) <- phi, 0 in the rows of velocities; terms (h): what phi is the sum of. */
EM_COLD void em_position_residual(double t, const double *x, const double *c, double *residual, double *terms) {
    double phi[EM_SOME_POSITIONS];
    memset(residual, 0, EM_SOME_ROWS * sizeof *residual);
    position(t, x, c, phi, terms);
    for (int row = 0; row < N_POSITIONS; ++row) residual[row] = phi[row];
}

/* The largest residual in units of its rounding, and *worst, its row. */
EM_COLD double em_largest_residual(const double *residual, const double *terms, int *worst) {
    double largest = 0.0;
    *worst = 0;
    for (int row = 0; row < N_POSITIONS; ++row) {
        const double size = em_in_roundings(residual[row], terms[row]);
        if (size > largest) largest = size, *worst = row;
    }
    return largest;
}

/* A row that depends on others is met as well as they are: what rounding leaves of those that are kept, in units of
 * their lengths, it leaves of all. */
EM_COLD void em_share_rounding(const em_root *root, int rows, double *terms) {
    double most = 0.0;
    for (int row = 0; row < N_POSITIONS; ++row)
        if (rows & EM_FIRST_KEPT << row) most = fmax(most, terms[row] / sqrt(root->Delta[row * N_ROWS + row]));
    for (int row = 0; row < N_POSITIONS; ++row)
        terms[row] = fmax(terms[row], most * sqrt(root->Delta[row * N_ROWS + row]));
}

/* terms <- the larger of those here and before the last step, which become those here: where all terms vanish with phi,
 * what is left is rounding of what they were. */
EM_COLD void em_widen_terms(double *terms, double *before) {
    for (int row = 0; row < N_POSITIONS; ++row) {
        const double here = terms[row];
        terms[row] = fmax(here, before[row]);
        before[row] = here;
    }
}

/* terms += what cancels in each row of Delta lambda, the change of phi that a correction made: of a coordinate that is 0
 * but for the corrections of others, phi's own terms know nothing. lengths (m): the roots of Delta's diagonal. */
EM_COLD void em_add_correction(const double *lengths, const double *lambda, double *terms) {
    double whole = 0.0;
    for (int row = 0; row < N_ROWS; ++row) whole += lengths[row] * fabs(lambda[row]);
    for (int row = 0; row < N_POSITIONS; ++row) terms[row] += lengths[row] * whole;
}

EM_COLD void em_row_lengths(const em_root *root, double *lengths) {
    for (int row = 0; row < N_ROWS; ++row) lengths[row] = sqrt(root->Delta[row * N_ROWS + row]);
}

/* x <- a point with phi(x, t) = 0 by Newton's method in the mass metric, `steps` at the most. Where rows may depend on
 * each other and none are said to be kept, each step keeps those that add more than `tolerance` to others.
 * Returns whether x changed, or -1. */
EM_COLD int em_newton_of(double t, double *x, const double *c, int steps, int least_norm, double tolerance,
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
        const double size = em_largest_residual(residual, terms, &worst);
        if (size <= 1.0) return step > 0;
        if (isinf(size) || (step == steps && size > 1e3))
            return em_fail(fault, EM_POSITION_NOT_REACHED, worst, -1, fabs(residual[worst]));
        if (step == steps) return 1;
        if (!least_norm && em_root_at(t, x, c, &root, fault)) return -1;
        em_row_lengths(&root, lengths);
        if (em_correct(&root, x, residual, NULL, rows, fault)) return -1;
        em_add_correction(lengths, residual, before);
    }
}

EM_COLD int em_newton(double t, double *x, const double *c, int steps, int least_norm, em_fault *fault) {
    return em_newton_of(t, x, c, steps, least_norm, EM_DEPENDENT, fault);
}

/* The same from afar. Off the constraints, rows that depend on each other on them differ, by little: first only rows
 * that clearly add to others count, which is right unless phi = 0 is not reached so. */
EM_RARE EM_COLD int em_newton_from_afar(double t, double *x, const double *c, int least_norm, em_fault *fault) {
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
EM_COLD int em_project_velocity(double t, const double *x, double *v, const double *c, int least_norm, em_fault *fault) {
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
EM_COLD int em_project(double t, double *x, double *v, const double *c, int least_norm, em_fault *fault) {
    if (N_POSITIONS > 0 && em_newton_from_afar(t, x, c, least_norm, fault) < 0) return -1;
    return N_ROWS > 0 ? em_project_velocity(t, x, v, c, least_norm, fault) : 0;
}

/* The same after a step, from nearby. */
EM_COLD int em_settle_motion(double t, double *x, double *v, const double *c, int least_norm, em_fault *fault) {
    if (N_POSITIONS > 0 && em_newton(t, x, c, 3, least_norm, fault) < 0) return -1;
    return N_ROWS > 0 ? em_project_velocity(t, x, v, c, least_norm, fault) : 0;
}

/* C (n, n), s (n) of M(x) in units of `scales`, block by block; near the C given, or from scratch where C is 0. */
EM_COLD int em_eigenfactors_of(double t, const double *x, const double *c, double *C, double *s, em_fault *fault) {
    double M[N * N], Mb[N * N], Cb[N * N], sb[N];
    factored(t, x, c, M);
    for (int k = 0; k < N * N; ++k) M[k] *= scales[k / N] * scales[k % N];
    for (const em_block *const *next = blocks; *next; ++next) {
        const em_block *const b = *next;
        double given = 0.0;
        em_gather(N, b->size, b->coordinate, M, Mb);
        em_gather(N, b->size, b->coordinate, C, Cb);
        for (int k = 0; k < b->size * b->size; ++k) given += fabs(Cb[k]);
        const int singular = given > 0.0 ? em_refresh_any(b->size, Mb, Cb, sb) : em_eigenfactors(b->size, Mb, Cb, sb);
        if (singular >= 0) return em_fail_block(b, singular, 0.0, fault);
        em_spread(N, b->size, b->coordinate, Cb, C);
        em_put(b, sb, s);
    }
    return 0;
}

/* out (n_outputs) at x, v */
EM_COLD int em_observe(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                       double *out, em_fault *fault) {
    double a[N], lambda[EM_SOME_ROWS];
    if (em_acceleration(t, x, v, c, u, least_norm, a, lambda, fault)) return -1;
    observe(t, x, v, a, lambda, c, u, out);
    return 0;
}

#endif
