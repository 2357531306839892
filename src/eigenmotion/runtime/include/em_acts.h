/* em_acts.h: what events do to a state.
 *
 * In this order: impacts, one after the other as the model lists them, until nothing approaches what struck it; resets;
 * then contacts that would pull let go, and frictions at rest stick where they can. */
#ifndef EM_ACTS_H
#define EM_ACTS_H

#include "em_saltation.h"

#define EM_AT_ONCE 4096.0 /* times the spacing of t: what follows sooner happens at the same time */
#define EM_PARTED 1e-13   /* the part of the terms of a speed below which nothing approaches */
#define EM_RESTS 1e-12    /* the same of a slip */

/* What acts at one time, and the state and the mode that it acts on; `along`: directions that go with it, or NULL. */
typedef struct em_acting {
    double t, *x, *v, *c;
    const double *u;
    int least_norm, *fired;
    em_fault *fault;
    const em_directions *along;
    int slipped, rests[EM_SOME_SWITCHES];
} em_acting;

/* Events that pile up: each so soon after the one before that no time passes. 0, or -1 and *fault. */
EM_COLD int em_check_pile(const em_acting *a, em_pile *pile) {
    enum { MANY = 200 };
    const double soon = EM_AT_ONCE * DBL_EPSILON * fabs(a->t);
    for (int i = 0; i < N_EVENTS; ++i) {
        if (!a->fired[i]) continue;
        pile[i].count = pile[i].count > 0 && fabs(a->t - pile[i].t) <= soon ? pile[i].count + 1 : 1;
        pile[i].t = a->t;
        if (pile[i].count > MANY) return em_fail(a->fault, EM_EVENTS_PILE_UP, i, -1, NAN);
    }
    return 0;
}

/* --- impacts --- */

/* The contact held whose impulse pulls most, or -1. */
EM_COLD int em_pulled(const em_acting *a, const double *impulse) {
    double most = 0.0;
    int pulled = -1;
    for (int row = 0; row < EM_STRUCK_ROWS; ++row) most = fmax(most, EM_PARTED * fabs(impulse[row]));
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (em_is_contact(s) && em_holds(s, a->c) && impulse[s->row] > most) most = impulse[s->row], pulled = k;
    }
    return pulled;
}

/* One impact; contacts that it pulls apart let go. 0, or -1 and *fault. */
EM_COLD int em_strike_once(em_acting *a, int event, const double *struck, int lands) {
    const double e = lands ? 0.0 : struck[N + 1];
    double v[N], impulse[EM_STRUCK_ROWS];
    for (;;) {
        em_root root;
        memcpy(v, a->v, sizeof v);
        if (em_root_at(a->t, a->x, a->c, &root, a->fault)) return -1;
        if (em_strike(&root, struck, e, v, impulse)) return em_fail(a->fault, EM_IMPACT_UNDEFINED, event, -1, NAN);
        const int pulled = em_pulled(a, impulse);
        if (pulled < 0) break;
        if (em_hold(&switches[pulled], a->c, 0, a->fault)) return -1;
        a->fired[switches[pulled].event] = 1;
    }
    if (a->along && em_strike_along(a->along, a->t, a->x, a->v, a->c, a->u, deeds[event].impact, struck, e, lands, v, a->fault))
        return -1;
    memcpy(a->v, v, sizeof v);
    return 0;
}

/* Up to which speed an event's contact holds after an impact; -1: it never does. */
EM_COLD double em_rest_speed(const em_acting *a, int event) {
    double level[2 * EM_SOME_SWITCHES];
    if (N_SWITCHES == 0 || deeds[event].held < 0) return -1.0;
    levels(a->t, a->x, a->v, a->c, a->u, level);
    return level[2 * deeds[event].held];
}

/* What holds already keeps a contact closed: its row depends on theirs. 0, or -1 and *fault. */
EM_COLD int em_close_too(const em_acting *a, const em_switch *s) {
    if (!a->least_norm) return em_fail(a->fault, EM_DEPENDENT_CONSTRAINTS, s->row, -1, NAN);
    return em_hold(s, a->c, 1, a->fault);
}

/* Impact number `event`, which `first` happens for the first time now: whether it does, or -1 and *fault. */
EM_COLD int em_strike_event(em_acting *a, int event, const double *struck, double side, int first) {
    const double approach = em_approach(struck, a->v), e = struck[N + 1], rest = em_rest_speed(a, event);
    em_root root;
    if (em_root_at(a->t, a->x, a->c, &root, a->fault)) return -1;
    const int nears = side * approach > (first ? 0.0 : EM_PARTED * em_fastest(&root, struck, a->v));
    const int lands = (nears && e * fabs(approach) <= rest) || (!nears && first && fabs(approach) <= rest);
    if (!nears && !lands) return 0;
    if (lands && em_is_blocked(&root, struck)) return em_close_too(a, &switches[deeds[event].held]);
    if (!(e >= 0.0 && e <= 1.0)) return em_fail(a->fault, EM_IMPACT_UNDEFINED, event, 1, e);
    if (em_strike_once(a, event, struck, lands)) return -1;
    return lands && em_hold(&switches[deeds[event].held], a->c, 1, a->fault) ? -1 : 1;
}

EM_COLD int em_is_closed(const em_acting *a, int event) {
    return deeds[event].held >= 0 && em_holds(&switches[deeds[event].held], a->c);
}

/* Whether an event that has fired is an impact. */
EM_COLD int em_strikes(const em_acting *a, int event) {
    return a->fired[event] == 1 && deeds[event].impact >= 0 && !em_is_closed(a, event);
}

/* One round of impacts: whether there was any, or -1 and *fault. side (n_events): the sign of approach, 0: not known */
EM_COLD int em_strike_round(em_acting *a, double *side) {
    double struck[EM_SOME_IMPACTS * EM_STRUCK];
    int any = 0;
    for (int i = 0; i < N_EVENTS; ++i) {
        if (!em_strikes(a, i)) continue;
        impacts(a->t, a->x, a->v, a->c, a->u, struck);
        const double *const at = struck + deeds[i].impact * EM_STRUCK;
        const int first = side[i] == 0.0;
        if (first) side[i] = deeds[i].keeps_apart || em_approach(at, a->v) < 0.0 ? -1.0 : 1.0;
        const int struck_now = em_strike_event(a, i, at, side[i], first);
        if (struck_now < 0) return -1;
        any |= struck_now;
    }
    return any;
}

/* All impacts. Whatever slides or sticks takes no impulse: its force is finite. 0, or -1 and *fault. */
EM_COLD int em_strike_all(em_acting *a) {
    enum { ROUNDS = 1000 };
    double side[N_EVENTS] = {0.0};
    int some = 0, any = 1;
    if (N_IMPACTS == 0) return 0;
    for (int i = 0; i < N_EVENTS; ++i) some |= em_strikes(a, i);
    if (!some) return 0;
    for (int k = 0; k < N_SWITCHES; ++k)
        if (!em_is_contact(&switches[k]) && em_hold(&switches[k], a->c, 0, a->fault)) return -1;
    a->slipped = 1;
    for (int round = 0; round < ROUNDS && any > 0; ++round) any = em_strike_round(a, side);
    if (any < 0) return -1;
    for (int i = 0; any && i < N_EVENTS; ++i)
        if (em_strikes(a, i)) return em_fail(a->fault, EM_EVENTS_PILE_UP, i, -1, NAN);
    return 0;
}

/* --- resets --- */

/* What a reset leaves of the constraints. 0, or -1 and *fault. */
EM_COLD int em_check_reset(const em_acting *a, int event) {
    double phi[EM_SOME_POSITIONS], terms[EM_SOME_POSITIONS], A[EM_SOME_ROWS * N], b[EM_SOME_ROWS];
    position(a->t, a->x, a->c, phi, terms);
    for (int row = 0; row < N_POSITIONS; ++row)
        if (!(fabs(phi[row]) <= EM_RESET_MAY * terms[row]))
            return em_fail(a->fault, EM_RESET_OFF, event, row, phi[row]);
    pfaffian(a->t, a->x, a->c, A, b);
    for (int row = 0; row < N_ROWS; ++row) {
        double rate = b[row], size = fabs(b[row]);
        for (int k = 0; k < N; ++k) rate += A[row * N + k] * a->v[k], size += fabs(A[row * N + k] * a->v[k]);
        if (!(fabs(rate) <= EM_RESET_MAY * size)) return em_fail(a->fault, EM_RESET_OFF, event, row, rate);
    }
    return 0;
}

EM_COLD int em_reset(em_acting *a, int event) {
    double after[EM_SOME_RESETS * 2 * N];
    const int number = deeds[event].reset;
    if (N_RESETS == 0) return 0; /* that compilers see it, too */
    resets(a->t, a->x, a->v, a->c, a->u, after);
    const double *const at = after + number * 2 * N;
    for (int k = 0; k < 2 * N; ++k)
        if (!isfinite(at[k])) return em_fail(a->fault, EM_NON_FINITE_STATE, k % N, -1, NAN);
    if (a->along) em_reset_along(a->along, a->t, a->x, a->v, a->c, a->u, number);
    memcpy(a->x, at, N * sizeof *at);
    if (!resets_quasi[number]) memcpy(a->v, at + N, N * sizeof *at);
    else if (em_rates_of_quasi(a->t, a->x, at + N, a->c, a->v)) return em_fail(a->fault, EM_RESET_OFF, event, -1, NAN);
#ifdef EM_QUASI
    if (a->along && resets_quasi[number] && em_quasi_along(a->along, a->t, a->x, a->v, a->c))
        return em_fail(a->fault, EM_RESET_OFF, event, -1, NAN);
#endif
    a->slipped = 1;
    return em_check_reset(a, event);
}

/* --- what holds afterwards --- */

/* The sizes of what is added in the slip of a friction. */
EM_COLD double em_slip_terms(const em_acting *a, int number) {
    double level[2 * EM_SOME_SWITCHES], v[N] = {0.0};
    levels(a->t, a->x, v, a->c, a->u, level);
    const double still = level[2 * number + 1];
    double terms = fabs(still);
    for (int k = 0; k < N; ++k) {
        v[k] = a->v[k];
        levels(a->t, a->x, v, a->c, a->u, level);
        terms += fabs(level[2 * number + 1] - still);
        v[k] = 0.0;
    }
    return terms;
}

/* Which frictions are at rest: all that stuck, or came to rest; after a jump of the velocities those without slip. */
EM_COLD void em_find_rests(em_acting *a) {
    double level[2 * EM_SOME_SWITCHES];
    levels(a->t, a->x, a->v, a->c, a->u, level);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (em_is_contact(s)) continue;
        const int came = em_holds(s, a->c) || a->fired[s->event];
        a->rests[k] = (came && !a->slipped) || fabs(level[2 * k + 1]) <= EM_RESTS * em_slip_terms(a, k);
    }
}

/* A friction that takes more than its limit slides the way it is pulled; a contact that pulls opens. */
EM_COLD int em_release_fired(em_acting *a) {
    double rate[N], lambda[EM_SOME_ROWS];
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (!a->fired[s->event] || !em_holds(s, a->c)) continue;
        if (!em_is_contact(s) && em_acceleration(a->t, a->x, a->v, a->c, a->u, a->least_norm, rate, lambda, a->fault)) return -1;
        if (em_hold(s, a->c, 0, a->fault)) return -1;
        if (!em_is_contact(s) && em_set_mode(a->c, s->slides, lambda[s->row] > 0.0 ? 1.0 : -1.0, a->fault)) return -1;
        a->fired[s->event] = 2; /* has let go */
    }
    return 0;
}

/* The mode that follows from the state. 0, or -1 and *fault. */
EM_COLD int em_settle_modes(em_acting *a) {
    int before[EM_SOME_SWITCHES];
    if (N_SWITCHES == 0) return 0;
    for (int k = 0; k < N_SWITCHES; ++k) before[k] = em_holds(&switches[k], a->c);
    if (em_let_go(a->t, a->x, a->v, a->c, a->u, a->least_norm, a->fault)) return -1;
    em_find_rests(a);
    if (em_grip(a->t, a->x, a->v, a->c, a->u, a->least_norm, a->rests, a->fired, a->fault)) return -1;
    for (int k = 0; k < N_SWITCHES; ++k)
        if (before[k] != em_holds(&switches[k], a->c)) a->fired[switches[k].event] = 1;
    return em_project(a->t, a->x, a->v, a->c, a->least_norm, a->fault);
}

EM_COLD int em_act_on_all(em_acting *a, em_pile *pile) {
    int some = 0, last = -1;
    double from[N];
    if (em_check_pile(a, pile) || em_release_fired(a) || em_strike_all(a)) return -1;
    memcpy(from, a->x, sizeof from);
    for (int i = 0; i < N_EVENTS; ++i) {
        some |= a->fired[i];
        if (a->fired[i] && deeds[i].reset >= 0) last = i;
        if (last == i && em_reset(a, i)) return -1;
    }
    if (last >= 0 && em_check_apart(a->t, from, a->x, a->v, a->c, a->u, last, a->fault)) return -1;
    a->slipped |= !some;
    return em_settle_modes(a);
}

/* x, v (n) and c, the mode, after the events `fired` (n_events) at t, in the order of the model; none fired: at the start
 * of a run. `fired` grows by events whose number jumps then; pile (n_events) is of the run. 0, or -1 and *fault. */
EM_ACROSS int em_act(double t, double *x, double *v, double *c, const double *u, int least_norm, int *fired,
                     em_pile *pile, em_fault *fault) {
    em_acting a = {t, x, v, c, u, least_norm, fired, fault, NULL, 0, {0}};
    return em_act_on_all(&a, pile);
}

/* em_model.act_along: the same, and what becomes of directions. */
EM_ACROSS int em_act_along(double t, double *x, double *v, double *c, const double *u, int least_norm, int *fired,
                           em_pile *pile, int columns, double *S, const double *P, em_fault *fault) {
    const em_directions along = {columns, S, P};
    em_acting a = {t, x, v, c, u, least_norm, fired, fault, &along, 0, {0}};
    if (em_act_on_all(&a, pile)) return -1;
#ifdef EM_TANGENT_H
    return em_tangent(t, x, v, c, least_norm, columns, S, P, fault);
#else
    return 0;
#endif
}

/* em_model.event: g (n_events) in the mode of c; NaN where it has no value */
EM_ACROSS void em_watched(double t, const double *x, const double *v, const double *c, const double *u, double *g) {
    em_fault fault;
    model_events(t, x, v, c, u, g);
    if (em_watch_modes(t, x, v, c, u, EM_LEAST_NORM, g, &fault))
        for (int k = 0; k < N_EVENTS; ++k) g[k] = NAN;
}

/* em_model.event_partials: D (n_events, n_arguments), likewise */
EM_ACROSS void em_watched_partials(double t, const double *x, const double *v, const double *c, const double *u,
                                   double *D) {
    event_partials(t, x, v, c, u, D);
    if (em_watch_partials(t, x, v, c, u, D))
        for (int k = 0; k < N_EVENTS * N_ARGUMENTS; ++k) D[k] = NAN;
}

#endif
