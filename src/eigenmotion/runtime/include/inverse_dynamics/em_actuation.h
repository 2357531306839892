/* em_actuation.h: the solution tau (k), lambda (m) of B tau - P^T lambda = r (n), with the least sum of w tau^2 where tau
 * is not unique, and of these with the least sum of lambda^2.
 *
 * - With an actuator on every coordinate, lambda is the solution of a least-squares problem, P W P^T lambda = -P W r.
 * - Where actuators on coordinates, and as many others as needed, leave a square system, it is eliminated. This needs no
 *   mass matrix, and is what machines with as many actuators as freedoms need.
 * - All others are solved in the mass metric, M = L L^T: L^-1 r and the columns of L^-1 B without their parts along
 *   L^-1 P^T, which constraints take. What is left of r outside of what is left of B drives a motion that no actuator
 *   drives: the residual. The metric decides what is singular, whatever the units of the coordinates. */
#ifndef EM_ACTUATION_H
#define EM_ACTUATION_H

#include "constraints/em_rank.h"
#include "eigenmotion.h"
#include "numeric/em_complete_pivoting.h"
#include "numeric/em_lu.h"

#define EM_SAFE_PIVOT 1e-6   /* relative to its row and column: smaller ones are left to the mass metric */
#define EM_DRIVES 1e-18      /* the square of the part of a column of length one that drives anything more */
#define EM_ALL_COORDINATES 0 /* the number of actuators if all coordinates have one */

/* The system at one state: n coordinates, which come first in r, rows of P (m, stride) and columns of df/du (stride,
 * inputs). */
typedef struct em_system {
    int n, stride, m, k, inputs;
    const double *r, *P, *columns;
    const em_actuators *of;
} em_system;

/* The entry of B for coordinate i and actuator k. */
static double em_actuated(const em_system *e, int i, int k) {
    const int input = e->of->input[k];
    return input < 0 ? i == e->of->coordinate[k] : e->columns[i * e->inputs + input];
}

static double em_actuator_weight(const em_system *e, int k) { return e->of->weight ? e->of->weight[k] : 1.0; }

/* rhs (m) <- lambda of least norm: Delta lambda = rhs, Delta (m, m) = Y Y^T of rows Y (m, n), rhs = Y y; corrected once by
 * y (n), which is changed. */
static void em_multipliers_of(int m, int n, const double *Y, double *y, double *lambda) {
    double Delta[(m ? m : 1) * (m ? m : 1)], part[m ? m : 1];
    for (int i = 0; i < m; ++i)
        for (int j = 0; j <= i; ++j) Delta[i * m + j] = em_inner(n, Y + i * n, Y + j * n);
    for (int i = 0; i < m; ++i) lambda[i] = 0.0;
    for (int pass = 0; pass < 2 && m; ++pass) {
        for (int i = 0; i < m; ++i) part[i] = em_inner(n, Y + i * n, y);
        em_least_norm(m, Delta, part, NULL);
        for (int i = 0; i < m; ++i) {
            lambda[i] += part[i];
            for (int k = 0; k < n; ++k) y[k] -= part[i] * Y[i * n + k];
        }
    }
}

/* With an actuator on every coordinate: tau = r + P^T lambda. */
static void em_all_actuated(const em_system *e, double *forces, double *lambda) {
    double Y[(e->m ? e->m : 1) * e->n], y[e->n];
    memset(Y, 0, sizeof Y); /* for compilers that do not know that n > 0 */
    for (int k = 0; k < e->n; ++k) {
        const double root = sqrt(em_actuator_weight(e, k));
        y[k] = -root * e->r[k];
        for (int i = 0; i < e->m; ++i) Y[i * e->n + k] = root * e->P[i * e->stride + k];
    }
    em_multipliers_of(e->m, e->n, Y, y, lambda);
    for (int k = 0; k < e->n; ++k) {
        forces[k] = e->r[k];
        for (int i = 0; i < e->m; ++i) forces[k] += e->P[i * e->stride + k] * lambda[i];
    }
}

/* z (q) <- G^-1 z. 0, or -1: G (q, q) is nearly singular; z is then unchanged. Pivots are compared with the largest
 * entries of rows and of columns, so that units do not matter much. */
static int em_solve_square(int q, double *G, double *z) {
    double unit[q], largest[q], y[q];
    int pivot[q];
    memset(largest, 0, sizeof largest);
    memset(unit, 0, sizeof unit); /* for compilers that do not know that q > 0 */
    for (int i = 0; i < q; ++i) {
        double most = 0.0;
        for (int j = 0; j < q; ++j) most = em_max(most, fabs(G[i * q + j]));
        if (!(most > 0.0)) return -1;
        unit[i] = 1.0 / most, y[i] = z[i];
        for (int j = 0; j < q; ++j) largest[j] = em_max(largest[j], unit[i] * fabs(G[i * q + j]));
    }
    if (em_lu(q, G, unit, pivot)) return -1;
    for (int i = 0; i < q; ++i) {
        const double weight = unit[pivot[i]];
        unit[pivot[i]] = unit[i];
        if (!(fabs(G[i * q + i]) * weight > EM_SAFE_PIVOT * largest[i])) return -1;
    }
    em_lu_solve(q, G, pivot, y);
    memcpy(z, y, sizeof y);
    return 0;
}

/* of (n) <- the actuator on each coordinate, or -1; others (k) <- those on none. The number of these, or -1: two actuators
 * share a coordinate. */
static int em_on_coordinates(const em_system *e, int *of, int *others) {
    int count = 0;
    for (int i = 0; i < e->n; ++i) of[i] = -1;
    for (int k = 0; k < e->k; ++k) {
        const int at = e->of->coordinate[k];
        if (at < 0) others[count++] = k;
        else if (of[at] >= 0) return -1;
        else of[at] = k;
    }
    return count;
}

/* The square system of the coordinates that no actuator acts on. 0, or -1: it is none, or nearly singular. */
static int em_square_actuation(const em_system *e, double *forces, double *lambda) {
    int of[e->n], others[e->k], undriven[e->n], q = 0;
    const int inputs = em_on_coordinates(e, of, others);
    for (int i = 0; i < e->n; ++i)
        if (of[i] < 0) undriven[q++] = i;
    if (inputs < 0 || q != e->m + inputs) return -1;
    double G[q * q + 1], z[q + 1];
    for (int i = 0; i < q; ++i) {
        z[i] = e->r[undriven[i]];
        for (int j = 0; j < q; ++j)
            G[i * q + j] = j < e->m ? -e->P[j * e->stride + undriven[i]] : em_actuated(e, undriven[i], others[j - e->m]);
    }
    if (q && em_solve_square(q, G, z)) return -1;
    memcpy(lambda, z, e->m * sizeof *z);
    for (int j = 0; j < inputs; ++j) forces[others[j]] = z[e->m + j];
    for (int i = 0; i < e->n; ++i) {
        if (of[i] < 0) continue;
        double force = e->r[i];
        for (int j = 0; j < e->m; ++j) force += e->P[j * e->stride + i] * lambda[j];
        for (int j = 0; j < inputs; ++j) force -= em_actuated(e, i, others[j]) * z[e->m + j];
        forces[of[i]] = force;
    }
    return 0;
}

/* Q (count, n) <- an orthonormal basis of rows Y (rows, n), which become of length one and lose their parts along it, by
 * the longest first; rows of which less than `least` (a square) is left add nothing. The number of its rows. */
static int em_basis(int n, int rows, double *Y, double least, double *Q) {
    for (int i = 0; i < rows; ++i) {
        const double length = em_length(n, Y + i * n);
        for (int k = 0; k < n && length > 0.0; ++k) Y[i * n + k] /= length;
    }
    for (int count = 0; count < n; ++count) {
        int longest = -1;
        double most = least;
        for (int i = 0; i < rows; ++i) {
            const double square = em_inner(n, Y + i * n, Y + i * n);
            if (square > most) most = square, longest = i;
        }
        if (longest < 0) return count;
        double *const q = Q + count * n;
        memcpy(q, Y + longest * n, n * sizeof *q);
        em_remove_rows(n, count, Q, q);
        const double length = em_length(n, q);
        for (int k = 0; k < n; ++k) q[k] /= length;
        for (int i = 0; i < rows; ++i) em_remove_rows(n, 1, q, Y + i * n);
    }
    return n;
}

/* sigma (k) <- of least norm, K sigma = g (q), K (q, k) of rank q */
static void em_least_forces(int q, int k, const double *K, const double *g, double *sigma) {
    double H[q * q + 1], L[q * q + 1], diagonal[q + 1], y[q + 1], G[q * q + 1];
    if (q == k) {
        memcpy(G, K, q * q * sizeof *G);
        memcpy(sigma, g, q * sizeof *g);
        if (!em_solve_square(q, G, sigma)) return;
    }
    memset(L, 0, sizeof L);
    for (int i = 0; i < q; ++i)
        for (int j = 0; j <= i; ++j) H[i * q + j] = em_inner(k, K + i * k, K + j * k);
    em_cholesky_any(q, H, L, diagonal, 0.0);
    for (int j = 0; j < k; ++j) sigma[j] = 0.0;
    for (int pass = 0; pass < 3; ++pass) {
        for (int i = 0; i < q; ++i) y[i] = g[i] - em_inner(k, K + i * k, sigma);
        em_forward(q, L, diagonal, y);
        em_backward(q, L, diagonal, y);
        for (int j = 0; j < k; ++j)
            for (int i = 0; i < q; ++i) sigma[j] += K[i * k + j] * y[i];
    }
}

/* L (n, n), d (n) <- M = L L^T of the coordinates, or of the matrix that is factored instead. -1, or the coordinate
 * without a pivot. */
static int em_mass_root(const em_model *model, double t, const double *x, const double *c, const em_system *e, double *L,
                        double *d) {
    double M[e->stride * e->stride], own[e->n * e->n];
    (model->factored_matrix ? model->factored_matrix : model->mass_matrix)(t, x, c, M);
    for (int i = 0; i < e->n; ++i) memcpy(own + i * e->n, M + i * e->stride, e->n * sizeof *own);
    memset(L, 0, e->n * e->n * sizeof *L);
    return em_cholesky_any(e->n, own, L, d, EM_SINGULAR_PIVOT);
}

/* Y (m, n), Z (k, n), y (n) <- L^-1 P^T, L^-1 B and L^-1 r, by rows */
static void em_in_metric(const em_system *e, const double *L, const double *d, double *Y, double *Z, double *y) {
    for (int row = 0; row < e->m; ++row) {
        memcpy(Y + row * e->n, e->P + row * e->stride, e->n * sizeof *Y);
        em_forward(e->n, L, d, Y + row * e->n);
    }
    for (int k = 0; k < e->k; ++k) {
        for (int i = 0; i < e->n; ++i) Z[k * e->n + i] = em_actuated(e, i, k);
        em_forward(e->n, L, d, Z + k * e->n);
    }
    memcpy(y, e->r, e->n * sizeof *y);
    em_forward(e->n, L, d, y);
}

/* Z (k, n) <- without the parts along Q (count, n); those that drive nothing become zero. */
static void em_remove_reactions(const em_system *e, int count, const double *Q, double *Z) {
    for (int k = 0; k < e->k; ++k) {
        double *const z = Z + k * e->n;
        const double before = em_inner(e->n, z, z);
        em_remove_rows(e->n, count, Q, z);
        if (!(em_inner(e->n, z, z) > EM_DRIVES * before)) memset(z, 0, e->n * sizeof *z);
    }
}

/* forces (k) of the free parts Z (k, n) of the actuators and y (n) of r; y <- what is left of it */
static void em_free_actuation(const em_system *e, const double *Z, double *y, double *forces) {
    const int n = e->n, k = e->k;
    double unit[k * n + 1], E[n * n], K[n * k + 1], g[n];
    memcpy(unit, Z, k * n * sizeof *unit);
    const int q = em_basis(n, k, unit, EM_DRIVES, E);
    for (int i = 0; i < q; ++i) {
        g[i] = em_inner(n, E + i * n, y);
        for (int j = 0; j < k; ++j) K[i * k + j] = em_inner(n, E + i * n, Z + j * n) / sqrt(em_actuator_weight(e, j));
    }
    em_least_forces(q, k, K, g, forces);
    for (int j = 0; j < k; ++j) forces[j] /= sqrt(em_actuator_weight(e, j));
    em_remove_rows(n, q, E, y);
}

/* In the mass metric. 0, or -1 and *fault: M is singular. */
static int em_general_actuation(const em_model *model, double t, const double *x, const double *c, const em_system *e,
                                double *forces, double *lambda, double *residual, em_inverse_check *check, em_fault *fault) {
    const int n = e->n;
    double L[n * n], d[n], Y[e->m * n + 1], Z[e->k * n + 1], y[n], left[n], rows[e->m * n + 1], Q[n * n], Z_free[e->k * n + 1];
    const int singular = em_mass_root(model, t, x, c, e, L, d);
    if (singular >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, singular, -1, 0.0);
    em_in_metric(e, L, d, Y, Z, y);
    memcpy(rows, Y, sizeof rows);
    memcpy(Z_free, Z, sizeof Z);
    memcpy(left, y, sizeof left);
    const int rank = em_basis(n, e->m, rows, EM_DEPENDENT, Q);
    em_remove_reactions(e, rank, Q, Z_free);
    em_remove_rows(n, rank, Q, left);
    em_free_actuation(e, Z_free, left, forces);
    double size = em_length(n, y);
    for (int i = 0; i < n; ++i) y[i] = left[i] - y[i];
    for (int k = 0; k < e->k; ++k) {
        size += fabs(forces[k]) * em_length(n, Z + k * n);
        for (int i = 0; i < n; ++i) y[i] += forces[k] * Z[k * n + i];
    }
    em_multipliers_of(e->m, n, Y, y, lambda);
    for (int row = 0; row < e->m; ++row) size += fabs(lambda[row]) * em_length(n, Y + row * n);
    const double undriven = em_length(n, left);
    check->undriven = undriven > 0.0 ? undriven / size : 0.0;
    for (int i = 0; i < n; ++i) {
        residual[i] = 0.0;
        for (int k = 0; k <= i; ++k) residual[i] += L[i * n + k] * left[k];
    }
    return 0;
}

/* forces (k, or n without actuators), lambda (m), residual (stride). 0, or -1 and *fault. */
static int em_solve_actuation(const em_model *model, double t, const double *x, const double *c, const em_system *e,
                              double *forces, double *lambda, double *residual, em_inverse_check *check, em_fault *fault) {
    memset(residual, 0, e->stride * sizeof *residual);
    check->undriven = 0.0;
    if (e->k == EM_ALL_COORDINATES) return em_all_actuated(e, forces, lambda), 0;
    if (!em_square_actuation(e, forces, lambda)) return 0;
    return em_general_actuation(model, t, x, c, e, forces, lambda, residual, check, fault);
}

#endif
