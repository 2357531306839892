/* em_sliding.h: the mode of frictions along a prescribed motion, which inverse dynamics needs.
 *
 * A friction slides as its slip moves or, where that rests, as it begins to. A friction whose slip stays at rest has no
 * part in the forces: it could take anything up to its limit. Contacts stay as c says; whether a closed one holds is not
 * decided here. The same in Python: analysis/inverse/contact_modes.py, with the tolerances of Surfaces. */
#ifndef EM_SLIDING_H
#define EM_SLIDING_H

#include "eigenmotion.h"
#include "numeric/em_linear.h"

#define EM_SLIP_RESTS 1e-9    /* a slip, or its acceleration, relative to its terms, that counts as zero */
#define EM_SLIP_ROUNDED 1e-12 /* the same, relative to all speeds, or to the accelerations of the acting forces */

/* Slips (m) and their accelerations (m), each with the size below which it counts as zero; of the rows of all frictions. */
typedef struct em_slips {
    double *rate, *rate_rests, *along, *along_rests;
} em_slips;

static int em_is_friction(const em_switch *s) { return s->slides >= 0; }

/* parameters (n_parameters) <- with no friction, or with all of them stuck */
static void em_hold_frictions(const em_model *model, double hold, double *parameters) {
    for (int k = 0; k < model->n_switches; ++k) {
        const em_switch *const one = &model->switches[k];
        if (!em_is_friction(one)) continue;
        parameters[one->holds] = hold, parameters[one->slides] = parameters[one->idles] = 0.0;
        if (one->shift >= 0) parameters[one->shift] = parameters[one->shift + 1] = 0.0;
    }
}

/* sqrt(d^T M d) */
static double em_in_mass_metric(int n, const double *M, const double *d) {
    double square = 0.0;
    for (int i = 0; i < n; ++i) square += d[i] * em_inner(n, M + i * n, d);
    return sqrt(fmax(square, 0.0));
}

/* rests (m) <- the rounding of A w + known: of its terms, and of `whole` in the mass metric, where rows have lengths `unit` */
static void em_slip_rests(const em_model *model, const double *A, const double *w, const double *known, const double *unit,
                          double whole, double *rests) {
    for (int row = 0; row < model->m; ++row) {
        double terms = fabs(known[row]);
        for (int k = 0; k < model->n; ++k) terms += fabs(A[row * model->n + k] * w[k]);
        rests[row] = EM_SLIP_RESTS * terms + EM_SLIP_ROUNDED * unit[row] * whole;
    }
}

/* M (n, n) of the metric, and unit (m) <- the lengths of the rows A (m, n) in it. 0, or -1 and *fault. */
static int em_slip_metric(const em_model *model, double t, const double *x, const double *c, const double *A, double *M,
                          double *unit, em_fault *fault) {
    const int n = model->n;
    double L[n * n], d[n], row[n];
    (model->factored_matrix ? model->factored_matrix : model->mass_matrix)(t, x, c, M);
    memset(L, 0, sizeof L);
    const int singular = em_cholesky_any(n, M, L, d, EM_SINGULAR_PIVOT);
    if (singular >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, singular, -1, 0.0);
    for (int i = 0; i < model->m; ++i) {
        memcpy(row, A + i * n, sizeof row);
        em_forward(n, L, d, row);
        unit[i] = sqrt(em_inner(n, row, row));
    }
    return 0;
}

/* The slips along a motion; push: the size of the acceleration without any friction. 0, or -1 and *fault. */
static int em_slips_at(const em_model *model, double t, const double *x, const double *v, const double *a, const double *u,
                       const double *stuck, const double *none, em_slips *slips, em_fault *fault) {
    const int n = model->n, m = model->m;
    double A[m * n], b[m], M[n * n], unit[m], r[n], gamma[m], falls[n], lambda[m];
    model->pfaffian(t, x, stuck, A, b);
    model->required_forces(t, x, v, a, stuck, u, r, slips->along);
    if (em_slip_metric(model, t, x, stuck, A, M, unit, fault)) return -1;
    if (model->acceleration(t, x, v, none, u, 1, falls, lambda, fault)) return -1;
    const double push = em_in_mass_metric(n, M, falls);
    const double speed = em_in_mass_metric(n, M, v) + sqrt(push * em_in_mass_metric(n, M, x));
    for (int i = 0; i < m; ++i) {
        slips->rate[i] = em_inner(n, A + i * n, v) + b[i];
        gamma[i] = slips->along[i] - em_inner(n, A + i * n, a);
    }
    em_slip_rests(model, A, v, b, unit, speed, slips->rate_rests);
    em_slip_rests(model, A, a, gamma, unit, push, slips->along_rests);
    return 0;
}

static int em_slip_is_zero(int rows, const double *value, const double *rests) {
    for (int i = 0; i < rows; ++i)
        if (!(fabs(value[i]) <= rests[i])) return 0;
    return 1;
}

/* parameters (n_parameters) <- of one friction that slides, unless it stays at rest: then it sticks if a closed contact
 * presses it. An open contact presses no friction. A cone has the direction of its slip plus a shift, so that it has one
 * at the start, too. */
static void em_slide(const em_model *model, const em_switch *one, const em_slips *slips, double *parameters) {
    const int row = one->row, cone = one->shift >= 0, pressed = one->over >= 0;
    if (pressed && parameters[model->switches[one->over].holds] == 0.0) return;
    const int begins = em_slip_is_zero(1 + cone, slips->rate + row, slips->rate_rests + row);
    if (begins && em_slip_is_zero(1 + cone, slips->along + row, slips->along_rests + row)) {
        if (pressed) parameters[one->holds] = 1.0;
        return;
    }
    const double *const moves = (begins ? slips->along : slips->rate) + row;
    parameters[one->slides] = cone || moves[0] > 0.0 ? 1.0 : -1.0;
    for (int i = 0; i < 2 && cone && begins; ++i)
        parameters[one->shift + i] = moves[i] / hypot(moves[0], moves[1]) - slips->rate[row + i];
}

/* c (n_prepared), prepared constants <- with the mode of frictions along the motion x, v, a (n), for inverse_dynamics with
 * these actuators, whose inputs are not read. 0, or -1 and *fault. */
EM_UNUSED static int em_slide_along(const em_model *model, double t, const double *x, const double *v, const double *a,
                                    const double *u, const em_actuators *of, double *c, em_fault *fault) {
    int frictions = 0;
    for (int k = 0; k < model->n_switches; ++k) frictions += em_is_friction(&model->switches[k]);
    if (!frictions) return 0;
    const int m = model->m;
    double parameters[model->n_parameters], stuck[model->n_prepared], none[model->n_prepared], values[4 * m];
    double without[model->n_inputs + 1];
    em_slips slips = {values, values + m, values + 2 * m, values + 3 * m};
    if (model->n_inputs) memcpy(without, u, (size_t)model->n_inputs * sizeof *u);
    for (int k = 0; k < of->count; ++k)
        if (of->input[k] >= 0) without[of->input[k]] = 0.0;
    memcpy(parameters, c, sizeof parameters);
    em_hold_frictions(model, 1.0, parameters);
    if (model->prepare(parameters, stuck, fault)) return -1;
    em_hold_frictions(model, 0.0, parameters);
    if (model->prepare(parameters, none, fault)) return -1;
    if (em_slips_at(model, t, x, v, a, without, stuck, none, &slips, fault)) return -1;
    for (int k = 0; k < model->n_switches; ++k)
        if (em_is_friction(&model->switches[k])) em_slide(model, &model->switches[k], &slips, parameters);
    return model->prepare(parameters, c, fault);
}

#endif
