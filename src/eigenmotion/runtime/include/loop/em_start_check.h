/* em_start_check.h: consistency check of a start (x, v), for any em_model.
 *
 * For the runtime, not for generated code. simulation/initial_state/consistency.py writes the messages. */
#ifndef EM_START_CHECK_H
#define EM_START_CHECK_H

#include "loop/em_assumptions.h"
#include "tables/em_table_ranges.h"
#include "stepper/em_time_events.h"
#include "dynamics/em_undefined.h"
#include "numeric/em_linear.h"
#include "constraints/em_start_tolerance.h"

/* Why the motion cannot start at a state. */
typedef enum em_refusal {
    EM_MAY_START = 0,
    EM_UNDECLARED,       /* a coordinate has a value that violates the assumption of its symbol */
    EM_WITHOUT_INERTIA,  /* the mass matrix is not positive definite */
    EM_OFF_POSITION,     /* phi = 0 does not hold */
    EM_OFF_VELOCITY,     /* A v + b = 0 does not hold */
    EM_WITHIN_CONTACT,   /* x is inside a contact or an impact */
    EM_WITHOUT_STATE     /* C, s and eta cannot be found, or are not finite */
} em_refusal;

#define EM_STATE_ROUNDING 8.0 /* spacings of x and v in the mass metric: a smaller change is rounding, whatever
                                     it changes in a row */

/* M (n, n) <- the matrix that is factored: the mass matrix, or the model's replacement. */
static void em_factored_matrix(const em_model *model, double t, const double *x, const double *c, double *M) {
    (model->factored_matrix ? model->factored_matrix : model->mass_matrix)(t, x, c, M);
}

/* dM (n, n, n) <- its gradient */
static void em_factored_gradient(const em_model *model, double t, const double *x, const double *c, double *dM) {
    (model->factored_gradient ? model->factored_gradient : model->mass_matrix_gradient)(t, x, c, dM);
}

/* Whether all pivots of M are positive, by a function of the model that computes them without M. */
static int em_has_inertia(const em_model *model, double t, const double *x, const double *c) {
    double pivots[model->n], diagonal[model->n];
    if (model->dynamics->pivots == NULL) return 0;
    model->dynamics->pivots(t, x, c, pivots, diagonal);
    for (int k = 0; k < model->n; ++k)
        if (!(pivots[k] > EM_SINGULAR_PIVOT * diagonal[k])) return 0;
    return 1;
}

/* M = L L^T, as em_cholesky. Returns the first coordinate whose pivot is not positive, or -1. */
static int em_lacks_inertia(const em_model *model, double t, const double *x, const double *c, double *L, double *r) {
    const int n = model->n;
    double M[n * n];
    em_factored_matrix(model, t, x, c, M);
    return em_cholesky(n, M, L, r, EM_SINGULAR_PIVOT);
}

/* |L^T x|, the length of x (n) in the mass metric */
static double em_mass_length(int n, const double *L, const double *x) {
    double y[n], square = 0.0;
    for (int i = 0; i < n; ++i) y[i] = x[i];
    em_transposed(n, L, y);
    for (int i = 0; i < n; ++i) square += y[i] * y[i];
    return sqrt(square);
}

/* |L^-1 a|, the length of a row (n) */
static double em_row_length(int n, const double *L, const double *r, const double *a) {
    double y[n], square = 0.0;
    for (int i = 0; i < n; ++i) y[i] = a[i];
    em_forward(n, L, r, y);
    for (int i = 0; i < n; ++i) square += y[i] * y[i];
    return sqrt(square);
}

/* Whether a residual exceeds its limit; NaN does. off, unless NULL <- the residual if so, else 0 */
static int em_is_off(double residual, double limit, double *off) {
    const int wrong = !(fabs(residual) <= limit);
    if (off != NULL) *off = !wrong ? 0.0 : residual == 0.0 ? NAN : residual;
    return wrong;
}

/* Whether A v + b = 0 and phi = 0 are violated. The allowed residual is the sum of: em_start_tolerance of the terms
 * that cancel in a row; the effect of a change of x and v by EM_START_STEPS atol (n); and the effect of a change in the
 * last digits of x and v as a whole, because the residual is rounding if all terms of a row are. Returns em_refusal.
 * off (m), unless NULL <- the residuals of violated rows */
static int em_constraints_refuse(const em_model *model, double t, const double *x, const double *v, const double *c,
                                 const double *L, const double *r, double rtol, const double *atol, double *off) {
    const int n = model->n, m = model->m;
    if (m == 0) return EM_MAY_START;
    const double tolerance = em_start_tolerance(rtol), last = EM_STATE_ROUNDING * DBL_EPSILON;
    const double all_x = last * em_mass_length(n, L, x), all_v = last * em_mass_length(n, L, v);
    double A[m * n], b[m], phi[m], terms[m], reach[m], length[m];
    int wrong = 0;
    model->pfaffian(t, x, c, A, b);
    if (model->h > 0) model->position(t, x, c, phi, terms);
    for (int row = 0; row < m; ++row) {
        reach[row] = 0.0;
        for (int k = 0; k < n; ++k) reach[row] += fabs(A[row * n + k]) * EM_START_STEPS * atol[k];
        length[row] = em_row_length(n, L, r, A + row * n);
    }
    for (int row = 0; row < model->h; ++row)
        wrong |= em_is_off(phi[row], tolerance * terms[row] + reach[row] + length[row] * all_x, off ? off + row : NULL);
    if (wrong) return EM_OFF_POSITION;
    for (int row = 0; row < m; ++row) {
        double residual = b[row], size = fabs(b[row]);
        for (int k = 0; k < n; ++k) {
            residual += A[row * n + k] * v[k];
            size += fabs(A[row * n + k] * v[k]);
        }
        wrong |= em_is_off(residual, tolerance * size + reach[row] + length[row] * all_v, off ? off + row : NULL);
    }
    return wrong ? EM_OFF_VELOCITY : EM_MAY_START;
}

/* Whether an event is an impact that happens where phi falls through zero, and does not belong to a contact. */
static int em_impact_is_alone(const em_event_action *action) { return action->impact >= 0 && action->keeps_apart && action->held < 0; }

static int em_has_contacts(const em_model *model) {
    for (int i = 0; model->event_actions != NULL && i < model->n_events; ++i)
        if (em_impact_is_alone(&model->event_actions[i])) return 1;
    return model->n_switches > 0;
}

/* Whether an impact's phi grows: a start that is inside by rounding then causes no impact. */
static int em_leaves_contact(const em_model *model, int event, double t, const double *x, const double *v,
                             const double *c) {
    const int n = model->n, width = n + 2;
    double data[model->n_impacts * width];
    model->impacts(t, x, v, c, model->input_defaults, data);
    const double *const own = data + model->event_actions[event].impact * width;
    double rate = own[n];
    for (int k = 0; k < n; ++k) rate += own[k] * v[k];
    return model->event_actions[event].keeps_apart * rate > 0.0;
}

/* The event of the contact or impact that x is inside of, by more than the effect of a change of x by `step` (n); -1:
 * none. */
static int em_inside_by_more(const em_model *model, double t, const double *x, const double *v, const double *c,
                             const double *step) {
    const int n = model->n, events = model->n_events;
    double gap[events], elsewhere[events], reach[events], near[n];
    model->event(t, x, v, c, model->input_defaults, gap);
    for (int i = 0; i < events; ++i) reach[i] = 0.0;
    for (int k = 0; k < n; ++k) {
        for (int j = 0; j < n; ++j) near[j] = x[j];
        near[k] += step[k];
        model->event(t, near, v, c, model->input_defaults, elsewhere);
        for (int i = 0; i < events; ++i) reach[i] += fabs(elsewhere[i] - gap[i]);
    }
    for (int k = 0; k < model->n_switches; ++k) {
        const em_switch *const s = &model->switches[k];
        if (s->slides < 0 && c[s->holds] == 0.0 && gap[s->event] < -reach[s->event]) return s->event;
    }
    for (int i = 0; i < events; ++i)
        if (em_impact_is_alone(&model->event_actions[i]) && model->event_actions[i].keeps_apart * gap[i] < 0.0 &&
            (fabs(gap[i]) > reach[i] || !em_leaves_contact(model, i, t, x, v, c))) return i;
    return -1;
}

/* The same with the changes that are allowed for constraints: by tolerances, and in the last digits of x as a whole. With
 * rtol 0 the state is not an initial state, and this is not checked. */
static int em_inside_contact(const em_model *model, double t, const double *x, const double *v, const double *c,
                             double rtol, const double *atol) {
    if (!em_has_contacts(model) || rtol == 0.0) return -1;
    const int n = model->n;
    double step[n], M[n * n], L[n * n], r[n];
    for (int k = 0; k < n; ++k) step[k] = EM_START_STEPS * atol[k] + em_start_tolerance(rtol) * fabs(x[k]);
    const int inside = em_inside_by_more(model, t, x, v, c, step);
    if (inside < 0 || em_lacks_inertia(model, t, x, c, L, r) >= 0) return inside;
    em_factored_matrix(model, t, x, c, M);
    const double whole = EM_STATE_ROUNDING * DBL_EPSILON * em_mass_length(n, L, x);
    for (int k = 0; k < n; ++k) step[k] += whole / sqrt(M[k * n + k]);
    return em_inside_by_more(model, t, x, v, c, step);
}

/* y (n_state, in: 0) <- the state at x, v (n). Returns em_refusal. `at` and off (m), unless NULL <- the coordinate
 * without inertia, and the residuals of violated constraint rows */
static int em_start(const em_model *model, double t, const double *x, const double *v, const double *c,
                    double rtol, const double *atol, double *y, int *at, double *off) {
    em_fault fault;
    if (model->declared && em_check_declared(model->declared, model->n_parameters, model->n, x, &fault))
        return EM_UNDECLARED;
    double L[model->n * model->n], r[model->n];
    const int lacking = model->m == 0 && em_has_inertia(model, t, x, c) ? -1 : em_lacks_inertia(model, t, x, c, L, r);
    if (at != NULL) *at = lacking;
    if (lacking >= 0) return EM_WITHOUT_INERTIA;
    const int refusal = em_constraints_refuse(model, t, x, v, c, L, r, rtol, atol, off);
    if (refusal != EM_MAY_START) return refusal;
    if (em_inside_contact(model, t, x, v, c, rtol, atol) >= 0) return EM_WITHIN_CONTACT;
    if (model->state(t, x, v, c, y, &fault)) return EM_WITHOUT_STATE;
    for (int k = 0; k < model->n_state; ++k)
        if (!isfinite(y[k])) return EM_WITHOUT_STATE;
    return EM_MAY_START;
}

#endif
