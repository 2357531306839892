/* em_event_directions.h: directional derivatives across event actions: of resets and of impacts (em_saltation.h);
 * derivatives of the conditions of an active set: of multipliers and of limits. */
#ifndef EM_EVENT_DIRECTIONS_H
#define EM_EVENT_DIRECTIONS_H

#include "contact/em_saltation.h"

#ifdef EM_QUASI
/* Directions of v after a reset has set the quasi-velocities y = P v: P dv = dy - dP v. S holds dy in place of dv. */
EM_NOINLINE int em_quasi_along(const em_acting *a) {
    const em_directions *const d = a->along;
    double by[N * N_ARGUMENTS], P[N * N], W[N * d->columns];
    quasi_partials(a->t, a->x, a->v, a->c, by);
    for (int j = 0; j < d->columns; ++j) {
        double column[N];
        for (int i = 0; i < N; ++i) {
            const double *const row = by + i * N_ARGUMENTS;
            column[i] = d->S[(N + i) * d->columns + j];
            for (int k = 0; k < N; ++k) P[i * N + k] = row[N + k], column[i] -= row[k] * d->S[k * d->columns + j];
            for (int k = 0; k < N_FORCING; ++k) column[i] -= row[2 * N + k] * d->P[k * d->columns + j];
        }
        if (em_solve_completely(N, P, column, 0.0, NULL)) return -1;
        for (int i = 0; i < N; ++i) W[i * d->columns + j] = column[i];
    }
    memcpy(d->S + N * d->columns, W, sizeof W);
    return 0;
}
#else
EM_NOINLINE int em_quasi_along(const em_acting *a) { return (void)a, 0; }
#endif

/* Directions after reset `number` of x, v; those of rates are directions of the quasi-velocities if these are set. */
EM_NOINLINE void em_reset_along(const em_acting *a, int number) {
    const em_directions *const d = a->along;
    double by[EM_SOME_RESETS * 2 * N * N_ARGUMENTS], W[2 * N * d->columns];
    if (N_RESETS == 0) return;
    reset_partials(a->t, a->x, a->v, a->c, a->u, by);
    em_along(d, 2 * N, by + number * 2 * N * N_ARGUMENTS, W);
    memcpy(d->S, W, sizeof W);
}

/* em_model.act_along: em_act, with the map of directions across the events. */
EM_EXPORT int em_act_along(double t, double *x, double *v, double *c, const double *u, int least_norm, int *fired,
                           em_pile *pile, int columns, double *S, const double *P, em_fault *fault) {
    const em_directions along = {columns, S, P, em_impact_along, em_reset_along, em_quasi_along};
    em_acting a = {.t = t, .x = x, .v = v, .c = c, .u = u, .least_norm = least_norm, .fired = fired, .fault = fault,
                   .along = &along, .starts = em_none_fired(fired)};
    if (em_act_on_all(&a, pile)) return -1;
#ifdef EM_TANGENT_H
    return em_tangent(t, x, v, c, least_norm, columns, S, P, fault);
#else
    return 0;
#endif
}

/* Row of D (n_events, n_arguments): the derivatives of the condition of a switch, from those of the multipliers. */
EM_NOINLINE void em_switch_partials(const em_switch *s, const double *lambda, const double *dlambda, double level,
                                const double *dlevel, double *row) {
    const double *const own = dlambda + s->row * N_ARGUMENTS;
    const int presses = s->over < 0 ? -1 : switches[s->over].row;
    const double sign = em_is_contact(s) || lambda[s->row] > 0.0 ? 1.0 : -1.0;
    const double size = em_is_cone(s) ? em_along_switch(s, lambda) : 1.0;
    for (int k = 0; k < N_ARGUMENTS; ++k) {
        row[k] = em_is_cone(s) ? -(lambda[s->row] * own[k] + lambda[s->row + 1] * own[N_ARGUMENTS + k]) / size : -sign * own[k];
        if (em_is_contact(s)) continue;
        if (em_norm_of(s) >= 0)
            row[k] += dlevel[k] * em_norm_of_multipliers(em_norm_of(s), lambda) +
                      level * em_norm_along(em_norm_of(s), lambda, dlambda + k, N_ARGUMENTS);
        else if (presses < 0) row[k] += dlevel[k];
        else if (lambda[presses] < 0.0) row[k] -= dlevel[k] * lambda[presses] + level * dlambda[presses * N_ARGUMENTS + k];
    }
}

/* D (n_events, n_arguments) <- with those of em_watch_modes. 0, or -1: there are none. */
EM_NOINLINE int em_watch_partials(double t, const double *x, const double *v, const double *c, const double *u, double *D) {
    double a[N], lambda[EM_SOME_ROWS], da[N * N_ARGUMENTS], dlambda[EM_SOME_ROWS * N_ARGUMENTS];
    double level[EM_LEVELS * EM_SOME_SWITCHES], dlevel[EM_LEVELS * EM_SOME_SWITCHES * N_ARGUMENTS];
    em_fault fault;
    int some = 0;
    for (int k = 0; k < N_SWITCHES; ++k) some |= em_holds(&switches[k], c);
    if (!some) return 0;
    if (em_motion_derivatives(t, x, v, c, u, EM_LEAST_NORM, a, lambda, da, dlambda, &fault)) return -1;
    levels(t, x, v, c, u, level);
    level_partials(t, x, v, c, u, dlevel);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (em_holds(s, c))
            em_switch_partials(s, lambda, dlambda, level[EM_LEVELS * k + 1], dlevel + (EM_LEVELS * k + 1) * N_ARGUMENTS,
                               D + s->event * N_ARGUMENTS);
    }
    return 0;
}

/* em_model.event_partials: D (n_events, n_arguments) in the mode of c; NaN where they have no value */
EM_EXPORT void em_watched_partials(double t, const double *x, const double *v, const double *c, const double *u,
                                   double *D) {
    event_partials(t, x, v, c, u, D);
    if (em_watch_partials(t, x, v, c, u, D))
        for (int k = 0; k < N_EVENTS * N_ARGUMENTS; ++k) D[k] = NAN;
}

#endif
