/* em_inverse_dynamics.h: forces of actuators for given accelerations, through constraints.
 *
 *     B tau - P^T lambda = r,   r = M a - f                                                                     (11)
 *
 * for the forces tau (k) of the actuators and the multipliers lambda (m): B (n, k) is where actuators act, P is A, or
 * the rows along which multipliers act with their friction. em_actuation.h solves it. Friction that is proportional to
 * norms rho of multipliers adds rows of P times rho. These are homogeneous of degree one, so that a step of Newton's
 * method is the solution with P at the direction of the last multipliers. */
#ifndef EM_INVERSE_DYNAMICS_H
#define EM_INVERSE_DYNAMICS_H

#ifdef EM_FOR_PAGES /* they draw motions and ask for no forces */
#include "numeric/em_linear.h"

EM_EXPORT int em_inverse_dynamics(EM_UNUSED const em_model *model, EM_UNUSED double t, EM_UNUSED const double *x,
                                  EM_UNUSED const double *v, EM_UNUSED const double *a, EM_UNUSED const double *c,
                                  EM_UNUSED const double *u, EM_UNUSED const em_actuators *of, EM_UNUSED double *forces,
                                  EM_UNUSED double *lambda, EM_UNUSED double *residual, EM_UNUSED em_inverse_check *check,
                                  em_fault *fault) {
    return em_fail(fault, EM_NON_FINITE_STATE, -1, -1, NAN);
}

#else
#include "constraints/em_norm_multipliers.h"
#include "inverse_dynamics/em_actuation.h"

#define EM_ROW_ROUNDED 1e-14 /* relative to the largest entry of a row and of v or a: terms that are rounding of zeros, as
                                those of a row across a plane in which all moves */

enum { EM_NORM_STEPS = 50 };

/* r (n), s (m) <- at the accelerations, without the inputs that are actuators; columns (n, n_inputs) <- df / du, if any is */
static void em_required_at(const em_model *model, double t, const double *x, const double *v, const double *a,
                           const double *c, const double *u, const em_actuators *of, double *columns, double *r, double *s) {
    double without[model->n_inputs + 1];
    int any = 0;
    memcpy(without, u, model->n_inputs * sizeof *u);
    for (int k = 0; k < of->count; ++k)
        if (of->input[k] >= 0) without[of->input[k]] = 0.0, any = 1;
    model->required_forces(t, x, v, a, c, without, r, s);
    if (any) model->input_columns(t, x, v, a, c, without, columns);
}

/* The worst of some rows: |residual| over the sizes of the terms that should cancel. Of positions off a constraint,
 * velocities and accelerations say nothing. */
static void em_check_rows(int equation, int rows, const double *residual, const double *size, em_inverse_check *check) {
    if (check->forbidden > EM_ALLOWED) return;
    for (int row = 0; row < rows; ++row) {
        const double part = residual[row] == 0.0 ? 0.0 : fabs(residual[row]) / size[row];
        if (!(part <= check->forbidden)) *check = (em_inverse_check){check->undriven, part, equation, row};
    }
}

/* residual (m) <- A w + its part that is known, given as residual or, with `whole`, the sum; size (m) <- of their terms */
static void em_row_residuals(const em_system *e, const double *A, const double *w, int whole, double *residual, double *size) {
    for (int row = 0; row < e->m; ++row) {
        double along = 0.0, terms = 0.0, entry = 0.0, largest = 0.0;
        for (int k = 0; k < e->n; ++k) {
            const double term = A[row * e->stride + k] * w[k];
            along += term, terms += fabs(term);
            entry = em_max(entry, fabs(A[row * e->stride + k])), largest = em_max(largest, fabs(w[k]));
        }
        size[row] = terms + fabs(whole ? residual[row] - along : residual[row]);
        if (!whole) residual[row] += along;
        if (size[row] < EM_ROW_ROUNDED * entry * largest) residual[row] = 0.0;
    }
}

/* Whether x, v and a satisfy the constraints: A (m, n), b (m) of A v + b, s (m) = A a + gamma; b and s change. */
static void em_check_motion(const em_model *model, double t, const double *x, const double *v, const double *a, const double *c,
                            const em_system *e, const double *A, double *b, double *s, em_inverse_check *check) {
    double phi[model->h + 1], size[model->m + model->h + 1];
    if (model->h) {
        model->position(t, x, c, phi, size);
        em_check_rows(EM_OF_POSITION, model->h, phi, size, check);
    }
    em_row_residuals(e, A, v, 0, b, size);
    em_check_rows(EM_OF_VELOCITY, e->m, b, size, check);
    em_row_residuals(e, A, a, 1, s, size);
    em_check_rows(EM_OF_ACCELERATION, e->m, s, size, check);
}

/* P (m, n) <- rows + sum over norms of gradient^T (their row) */
static void em_rows_with_norms(const em_model *model, const double *rows, const double *gradient, double *P) {
    const int m = model->m, n = model->n;
    memcpy(P, rows, m * n * sizeof *P);
    for (int f = 0; f < model->n_normals; ++f)
        for (int i = 0; i < m; ++i)
            for (int k = 0; k < n; ++k) P[i * n + k] += gradient[f * m + i] * rows[(m + f) * n + k];
}

/* forces (k), lambda (m), residual (n): what no actuator gives. Without actuators, all coordinates have one (k = n). c
 * holds the mode of contacts and frictions. 0, or -1 and *fault. */
EM_EXPORT int em_inverse_dynamics(const em_model *model, double t, const double *x, const double *v, const double *a,
                                  const double *c, const double *u, const em_actuators *of, double *forces, double *lambda,
                                  double *residual, em_inverse_check *check, em_fault *fault) {
    const int n = model->n, m = model->m, some = m ? m : 1, pushed = some + model->n_normals;
    double r[n], s[some], A[some * n], b[some], rows[pushed * n], P[some * n], columns[n * model->n_inputs + 1];
    double rho[model->n_normals + 1], gradient[(model->n_normals + 1) * some];
    em_system e = {n - model->n_states, n, m, of->count, model->n_inputs, r, P, columns, of};
    *check = (em_inverse_check){0.0, 0.0, EM_OF_POSITION, -1};
    em_required_at(model, t, x, v, a, c, u, of, columns, r, s);
    if (m) model->pfaffian(t, x, c, A, b);
    em_check_motion(model, t, x, v, a, c, &e, A, b, s, check);
    if (!model->pushes) e.P = A;
    else model->pushes(t, x, v, c, u, rows), memcpy(P, rows, m * n * sizeof *P);
    memset(gradient, 0, sizeof gradient);
    if (em_solve_actuation(model, t, x, c, &e, forces, lambda, residual, check, fault)) return -1;
    for (int step = 0; model->n_normals; ++step) {
        if (em_normal_forces(m, model->n_normals, model->normals, lambda, rho, gradient) <= EM_NORM_CONVERGED) break;
        if (step == EM_NORM_STEPS) return em_fail(fault, EM_CONTACTS_CLASH, -1, EM_NORMALS_NOT_FOUND, NAN);
        em_rows_with_norms(model, rows, gradient, P);
        if (em_solve_actuation(model, t, x, c, &e, forces, lambda, residual, check, fault)) return -1;
    }
    for (int k = 0; k < (of->count ? of->count : e.n); ++k)
        if (!isfinite(forces[k])) return em_fail(fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    return 0;
}

#endif

#endif
