/* em_variation_rounding.h: rounding errors of rates of directions, and of accelerations.
 *
 * The effect of rounding of the state is measured by a second evaluation with other last digits. Accelerations that
 * constraints prevent cancel against their multipliers, and only rounding remains of them everywhere: for a coordinate
 * that does not move at all, for a common factor of all forces, for the heading of a bicycle at rest. That rounding is
 * relative to the terms that cancel, |M^-1| |A|^T |dlambda|: to the largest such term of a row, with respect to any
 * number of the state, in units of M. If shorter steps do not have a smaller error, the derivative with respect to a
 * parameter is known only to the rounding of all terms that balance. */
#ifndef EM_VARIATION_ROUNDING_H
#define EM_VARIATION_ROUNDING_H

#include "numeric/em_linear.h"
#include "sensitivity/em_variation_steps.h"

#define EM_ROUNDINGS 32.0 /* multiple of the rounding that a single evaluation shows */
#define EM_CANCELLATION (8.0 * DBL_EPSILON) /* relative to the terms that cancel */

/* The number of successive rejected steps after which the remaining error may be rounding: each was as short as the
 * error of the previous one required, and an error that depends on the length would have become smaller. */
enum { EM_ROUNDING_RETRIES = 2 };

/* T (n, columns) <- the sum of the absolute values of the terms of K. */
EM_INLINE void em_sum_terms(const em_pass *p, const double *J, const double *S, double *T) {
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments;
    memset(T, 0, (size_t)n * k * sizeof *T);
    for (int i = 0; i < n; ++i) {
        double *const row = T + i * k;
        for (int q = 0; q < 2 * n; ++q) {
            const double part = fabs(J[i * width + q]), *const s = S + q * k;
            for (int j = 0; j < k; ++j) row[j] += part * fabs(s[j]);
        }
        for (const int(*at)[2] = p->nonzeros; at < p->nonzeros + p->n_nonzeros; ++at)
            row[(*at)[1]] += fabs(J[i * width + 2 * n + (*at)[0]] * p->P[(*at)[0] * k + (*at)[1]]);
    }
}

/* Multipliers solve one linear system, so that each is as uncertain as the largest. w (n) <- the units in which
 * coordinates are comparable, square roots of the diagonal of M; s (m) <- those of multipliers, square roots of the
 * diagonal of |A| R, R = |M^-1| |A|^T; reach (n) <- the size of the accelerations that multipliers of one unit cause.
 * 0, or -1: M has no inverse. */
static int em_reaction_sizes(const em_pass *p, double t, const double *z, double *w, double *s, double *reach) {
    const em_model *const model = p->of->model;
    const int n = p->n, m = p->m;
    double M[n * n], L[n * n], r[n], A[m * n], b[m], column[n], R[n * m];
    if (!model->mass_matrix) return -1;
    (model->factored_matrix ? model->factored_matrix : model->mass_matrix)(t, z, p->c, M);
    for (int i = 0; i < n; ++i) w[i] = sqrt(M[i * n + i]);
    if (em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT) >= 0) return -1;
    memset(R, 0, sizeof R);
    memset(reach, 0, n * sizeof *reach);
    model->pfaffian(t, z, p->c, A, b);
    for (int k = 0; k < n; ++k) {
        for (int i = 0; i < n; ++i) column[i] = i == k;
        em_forward(n, L, r, column);
        em_backward(n, L, r, column);
        for (int i = 0; i < n; ++i)
            for (int row = 0; row < m; ++row) R[i * m + row] += fabs(column[i]) * fabs(A[row * n + k]);
    }
    for (int row = 0; row < m; ++row) {
        double sum = 0.0;
        for (int i = 0; i < n; ++i) sum += fabs(A[row * n + i]) * R[i * m + row];
        s[row] = sqrt(sum);
        for (int i = 0; s[row] > 0.0 && i < n; ++i) reach[i] += R[i * m + row] / s[row];
    }
    return 0;
}

/* The largest of m multipliers in units s; they are `width` apart. */
static double em_largest_reaction(int m, const double *s, const double *lambda, int width) {
    double most = 0.0;
    for (int row = 0; row < m; ++row) most = fmax(most, s[row] * fabs(lambda[row * width]));
    return most;
}

/* length (columns) <- the lengths of n rows of directions in units w. */
static void em_lengths(int n, int columns, const double *w, const double *S, double *length) {
    memset(length, 0, columns * sizeof *length);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < columns; ++j) length[j] += w[i] * S[i * columns + j] * (w[i] * S[i * columns + j]);
    for (int j = 0; j < columns; ++j) length[j] = sqrt(length[j]);
}

/* K_rounding (n, columns) and a_rounding (n) += the rounding of accelerations that reactions cancel. */
static void em_add_cancellation(em_pass *p, double t, const double *z, double *K_rounding) {
    const int n = p->n, m = p->m, k = p->columns, width = p->of->model->n_arguments;
    double w[n], s[m + 1], reach[n], length[2][k], largest[width];
    if (m == 0 || em_reaction_sizes(p, t, z, w, s, reach)) return;
    for (int q = 0; q < width; ++q) largest[q] = em_largest_reaction(m, s, p->dlambda + q, width);
    const double whole = em_largest_reaction(m, s, p->lambda, 1);
    for (int half = 0; half < 2; ++half) em_lengths(n, k, w, p->S + half * n * k, length[half]);
    for (int i = 0; i < n; ++i) {
        const double held = EM_CANCELLATION * reach[i];
        p->a_rounding[i] += held * whole;
        for (int half = 0; half < 2; ++half) {
            double most = 0.0;
            for (int q = 0; q < n; ++q) most = fmax(most, largest[half * n + q] / w[q]);
            em_add_to(k, held * most, length[half], K_rounding + i * k);
        }
        for (const int(*at)[2] = p->nonzeros; at < p->nonzeros + p->n_nonzeros; ++at)
            K_rounding[i * k + (*at)[1]] += held * largest[2 * n + (*at)[0]] * fabs(p->P[(*at)[0] * k + (*at)[1]]);
    }
}

/* The sizes of the terms of acceleration i at the end of a step, at z: of what balances it, what follows from
 * velocities, and what is proportional to parameters. */
static double em_terms_of_acceleration(const em_pass *p, const double *z, int i) {
    const em_model *const model = p->of->model;
    const int n = p->n, first = 2 * n + model->n_inputs;
    const double *const J = p->J + ((EM_VARIATION_NODES - 1) * n + i) * model->n_arguments;
    double sum = fabs(p->a[(EM_VARIATION_NODES - 1) * n + i]);
    for (int k = 0; k < n; ++k) sum += fabs(J[n + k] * z[n + k]);
    for (int g = 0; g < model->n_parameters; ++g) sum += fabs(J[first + g] * p->c[g]);
    return sum;
}

/* K_rounding (n, columns) += the rounding of all terms that cancel in an acceleration, as far as they depend on a
 * parameter. Terms are assumed proportional to parameters, so that their sizes are |da/dp| |p|, and likewise
 * |dlambda/dp| |p|. */
static void em_add_parameter_cancellation(em_pass *p, double t, const double *z, double *K_rounding) {
    const em_model *const model = p->of->model;
    const int n = p->n, m = p->m, width = model->n_arguments, first = 2 * n + model->n_inputs;
    double w[n], s[m + 1], reach[n];
    if (m == 0 || em_reaction_sizes(p, t, z, w, s, reach)) memset(s, 0, sizeof s), memset(reach, 0, sizeof reach);
    double reactions = em_largest_reaction(m, s, p->lambda, 1);
    for (int g = 0; g < model->n_parameters; ++g)
        reactions += em_largest_reaction(m, s, p->dlambda + first + g, width) * fabs(p->c[g]);
    for (int i = 0; i < n; ++i) {
        const double sum = reach[i] * reactions + em_terms_of_acceleration(p, z, i);
        for (const int(*at)[2] = p->nonzeros; at < p->nonzeros + p->n_nonzeros; ++at) {
            const int g = (*at)[0] - model->n_inputs, j = (*at)[1];
            if (g < 0 || g >= model->n_parameters || p->c[g] == 0.0) continue;
            K_rounding[i * p->columns + j] += EM_CANCELLATION * sum * fabs(p->P[(*at)[0] * p->columns + j] / p->c[g]);
        }
    }
}

/* rounding (n, k) <- |M^-1| |M| rounding: accelerations solve one linear system, so that each is as uncertain as those
 * with which M couples it (Skeel's condition number). work (n, k). */
static void em_couple_rounding(const em_pass *p, double t, const double *z, int k, double *work, double *rounding) {
    const em_model *const model = p->of->model;
    const int n = p->n;
    double M[n * n], L[n * n], r[n], column[n];
    if (!model->mass_matrix) return;
    (model->factored_matrix ? model->factored_matrix : model->mass_matrix)(t, z, p->c, M);
    if (em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT) >= 0) return;
    memset(work, 0, (size_t)n * k * sizeof *work);
    for (int i = 0; i < n; ++i)
        for (int q = 0; q < n; ++q) em_add_to(k, fabs(M[i * n + q]), rounding + q * k, work + i * k);
    memset(rounding, 0, (size_t)n * k * sizeof *rounding);
    for (int q = 0; q < n; ++q) {
        for (int i = 0; i < n; ++i) column[i] = i == q;
        em_forward(n, L, r, column);
        em_backward(n, L, r, column);
        for (int i = 0; i < n; ++i) em_add_to(k, fabs(column[i]), work + q * k, rounding + i * k);
    }
}

/* K_rounding (n, columns) += its own effect on K, by way of S: since the start, S_v has taken up a rounding of the
 * elapsed time times K_rounding. A number that only depends on others that are rounding has no more digits than these. */
static void em_add_propagated_rounding(em_pass *p, double t, double *K_rounding) {
    const double elapsed = fabs(t - p->of->t[0]);
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments;
    const double *const J = p->J + (EM_VARIATION_NODES - 1) * n * width;
    memcpy(p->W, K_rounding, (size_t)n * k * sizeof *p->W);
    for (int i = 0; i < n; ++i)
        for (int q = 0; q < n; ++q)
            em_add_to(k, elapsed * (fabs(J[i * width + n + q]) + elapsed * fabs(J[i * width + q])), p->W + q * k, K_rounding + i * k);
}

/* K_rounding (n, columns), a_rounding (n) <- the rounding of K and of accelerations, for a step that ends at t. 0, or
 * -1. */
static int em_rounding_of(em_pass *p, double t, double *K_rounding) {
    enum { LAST = EM_VARIATION_NODES - 1 };
    em_variations *const w = p->of;
    const int n = p->n, width = w->model->n_arguments;
    const double *const J = p->J + LAST * n * width;
    double z[2 * n], a[n], D[n * width];
    for (int i = 0; i < 2 * n; ++i) z[i] = p->Z[LAST * 2 * n + i] * (1.0 + (i % 2 ? -4.0 : 4.0) * DBL_EPSILON);
    em_pass_inputs(p, t);
    if (w->model->motion_derivatives(em_pass_clock(p, t), z, z + n, p->c, p->u, w->least_norm, a, p->lambda, D, p->dlambda,
                                     &w->fault)) return -1;
    for (int i = 0; i < n * width; ++i) D[i] = EM_ROUNDINGS * (D[i] - J[i]);
    em_sum_terms(p, D, p->S, K_rounding);
    for (int i = 0; i < n; ++i) p->a_rounding[i] = EM_ROUNDINGS * fabs(a[i] - p->a[LAST * n + i]);
    em_add_cancellation(p, em_pass_clock(p, t), z, K_rounding);
    if (p->n_again >= EM_ROUNDING_RETRIES) {
        em_add_parameter_cancellation(p, em_pass_clock(p, t), z, K_rounding);
        em_couple_rounding(p, em_pass_clock(p, t), z, p->columns, p->W, K_rounding);
        em_add_propagated_rounding(p, t, K_rounding);
    }
    return 0;
}

#endif
