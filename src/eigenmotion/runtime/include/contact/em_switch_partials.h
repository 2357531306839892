/* em_switch_partials.h: derivatives of the conditions of an active set: of multipliers and of limits. */
#ifndef EM_SWITCH_PARTIALS_H
#define EM_SWITCH_PARTIALS_H

#include "contact/em_reset.h"

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

#endif
