/* em_modes.h: what holds at times: contacts that are closed, frictions that stick or slide.
 *
 * A mode is the set of constraint rows that hold. It is in the prepared parameters: a switched row has its parameter in
 * front, 1 or 0, and a row that is 0 has no multiplier (em_rest_rows). A contact holds until it would pull, a friction
 * sticks until it would take more than its limit; both show in the multiplier, which is then what their event watches. */
#ifndef EM_MODES_H
#define EM_MODES_H

#include "em_impact.h"

enum { EM_SOME_SWITCHES = N_SWITCHES > 0 ? N_SWITCHES : 1 };

EM_COLD int em_is_contact(const em_switch *s) { return s->slides < 0; }

EM_COLD int em_holds(const em_switch *s, const double *c) { return c[s->holds] != 0.0; }

/* Up to which force a friction sticks. */
EM_COLD double em_limit(const em_switch *s, double level, const double *lambda) {
    return s->over < 0 ? level : level * fmax(0.0, -lambda[switches[s->over].row]);
}

/* A parameter of the mode anew, and what is prepared of it. 0, or -1 and *fault. */
EM_COLD int em_set_mode(double *c, int parameter, double value, em_fault *fault) {
    double parameters[N_PARAMETERS + 1];
    memcpy(parameters, c, N_PARAMETERS * sizeof *parameters);
    parameters[parameter] = value;
    return prepare(parameters, c, fault);
}

/* Holds or not; what slid rests, what rests does not slide yet. 0, or -1 and *fault. */
EM_COLD int em_hold(const em_switch *s, double *c, int holds, em_fault *fault) {
    if (s->slides >= 0 && em_set_mode(c, s->slides, 0.0, fault)) return -1;
    return em_set_mode(c, s->holds, holds, fault);
}

/* g (n_events) <- with what switches that hold watch: how far the multiplier is from letting go. 0, or -1 and *fault. */
EM_ACROSS int em_watch_modes(double t, const double *x, const double *v, const double *c, const double *u,
                             int least_norm, double *g, em_fault *fault) {
    double a[N], lambda[EM_SOME_ROWS], level[2 * EM_SOME_SWITCHES];
    int some = 0;
    for (int k = 0; k < N_SWITCHES; ++k) some |= em_holds(&switches[k], c);
    if (!some) return 0;
    if (em_acceleration(t, x, v, c, u, least_norm, a, lambda, fault)) return -1;
    levels(t, x, v, c, u, level);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (em_holds(s, c)) g[s->event] = em_is_contact(s) ? -lambda[s->row] : em_limit(s, level[2 * k], lambda) - fabs(lambda[s->row]);
    }
    return 0;
}

/* Contacts that pull let go, the one that pulls most first. 0, or -1 and *fault. */
EM_COLD int em_let_go(double t, const double *x, const double *v, double *c, const double *u, int least_norm,
                      em_fault *fault) {
    double a[N], lambda[EM_SOME_ROWS];
    for (int count = 0; count < N_SWITCHES; ++count) {
        int worst = -1;
        if (em_acceleration(t, x, v, c, u, least_norm, a, lambda, fault)) return -1;
        for (int k = 0; k < N_SWITCHES; ++k) {
            const em_switch *const s = &switches[k];
            if (!em_is_contact(s) || !em_holds(s, c) || !(lambda[s->row] > 0.0)) continue;
            if (worst < 0 || lambda[s->row] > lambda[switches[worst].row]) worst = k;
        }
        if (worst < 0) return 0;
        if (em_hold(&switches[worst], c, 0, fault)) return -1;
    }
    return 0;
}

/* Frictions at rest, as `rests` (n_switches) says, stick if they can; the others slide as their slip says, at rest as
 * they are pulled, and those that have just let go as they do. 0, or -1 and *fault. */
EM_COLD int em_grip(double t, const double *x, const double *v, double *c, const double *u, int least_norm,
                    const int *rests, const int *fired, em_fault *fault) {
    double a[N], lambda[EM_SOME_ROWS], level[2 * EM_SOME_SWITCHES];
    levels(t, x, v, c, u, level);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (em_is_contact(s)) continue;
        if (s->over >= 0 && !em_holds(&switches[s->over], c)) {
            if (em_hold(s, c, 0, fault)) return -1;
            continue;
        }
        if (fired[s->event] == 2) continue;
        if (em_hold(s, c, rests[k], fault)) return -1;
        const double slip = level[2 * k + 1];
        if (!rests[k] && em_set_mode(c, s->slides, (slip > 0.0) - (slip < 0.0), fault)) return -1;
    }
    for (int round = 0; round < N_SWITCHES; ++round) {
        int worst = -1;
        double most = 1.0;
        if (em_acceleration(t, x, v, c, u, least_norm, a, lambda, fault)) return -1;
        levels(t, x, v, c, u, level);
        for (int k = 0; k < N_SWITCHES; ++k) {
            const em_switch *const s = &switches[k];
            if (em_is_contact(s) || !em_holds(s, c)) continue;
            const double limit = em_limit(s, level[2 * k], lambda), size = fabs(lambda[s->row]);
            const double part = limit > 0.0 ? size / limit : INFINITY * size;
            if (part > most) most = part, worst = k;
        }
        if (worst < 0) return 0;
        const em_switch *const s = &switches[worst];
        const double slides = lambda[s->row] > 0.0 ? 1.0 : -1.0;
        if (em_hold(s, c, 0, fault) || em_set_mode(c, s->slides, slides, fault)) return -1;
    }
    return 0;
}

#endif
