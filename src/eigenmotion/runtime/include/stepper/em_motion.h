/* em_motion.h: the mode (x, v): the state of methods that solve for the motion itself, in every formulation. There
 * y[n .. 2 n) is v, and eigenfactors are those of M(x), computed after every accepted step and where a row is
 * published.
 *
 * A model written by hand that states no terms of its equations carries v in its mode 0. */
#ifndef EM_MOTION_H
#define EM_MOTION_H

#include "constraints/em_rank.h"
#include "numeric/em_packs.h"

EM_INLINE int em_is_bare(const em_model *model) { return model->dynamics->factored == NULL; }

/* Whether the state is (x, v) in mode 0 already. */
EM_INLINE int em_carries_motion(const em_model *model) { return model->dynamics->second_order && !em_is_bare(model); }

/* dy <- (v, a, 0). 0, or -1 and *fault */
EM_INLINE int em_motion_rhs(const em_model *model, double t, const double *y, const double *c, const double *u,
                          double *memory, int flags, double *dy, em_fault *fault) {
    const int n = model->n;
    double lambda[model->m + 1];
    if (em_carries_motion(model) || em_is_bare(model))
        return model->dynamics->rhs(0, t, y, c, u, memory, flags, dy, fault);
    for (int k = 0; k < n; ++k) em_put_number(dy + k, y[k + n]);
    for (int k = 2 * n; k < model->n_state; ++k) em_put_number(dy + k, 0.0);
    return model->dynamics->acceleration(t, y, y + n, c, u, flags, dy + n, lambda, fault);
}

/* As em_dynamics.settle: restores the constraints, if requested, and the eigenfactors; the latter not for a state
 * within a step. */
EM_NOINLINE int em_motion_settle(const em_model *model, int flags, double t, double *y, const double *c, double *memory,
                             double pace, em_fault *fault) {
    const em_dynamics *const of = model->dynamics;
    const int n = model->n;
    int mode = 0;
    double found[model->n_state];
    if (em_carries_motion(model)) return of->settle(&mode, flags, t, y, c, memory, pace, fault);
    if (em_is_bare(model)) return of->settle(&mode, flags | EM_KEEP_MODE, t, y, c, memory, pace, fault);
    if (model->m > 0 && (flags & EM_STABILISE) && of->settle_motion(t, y, y + n, c, flags & EM_ABOUT_ROWS, fault)) return -1;
    if (model->n_state == 2 * n || flags & EM_KEEP_MODE) return model->m > 0;
    memcpy(found, y, sizeof found);
    if (model->state(t, y, y + n, c, found, fault)) return -1;
    memcpy(y + 2 * n, found + 2 * n, (size_t)(model->n_state - 2 * n) * sizeof *y);
    return model->m > 0;
}

/* row <- y in the published meaning */
EM_NOINLINE int em_motion_publish(const em_model *model, double t, const double *y, const double *c, double *row, em_fault *fault) {
    if (em_is_bare(model)) return model->dynamics->publish(0, t, y, c, NULL, row, fault);
    memcpy(row, y, (size_t)model->n_state * sizeof *row);
    return em_carries_motion(model) ? 0 : model->state(t, y, y + model->n, c, row, fault);
}

/* M (n, n), or the matrix that is factored in its place; 1 if the model states neither */
EM_NOINLINE void em_mass_at(const em_model *model, double t, const double *x, const double *c, double *M) {
    const int n = model->n;
    if (!em_is_bare(model)) {
        model->dynamics->factored(t, x, c, M);
        return;
    }
    for (int k = 0; k < n * n; ++k) M[k] = k % (n + 1) == 0;
}

#endif
