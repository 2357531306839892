/* em_event_actions.h: event actions: impacts, resets and changes of the active set.
 *
 * They act in this order: impacts, until no touching bodies approach: first those of events, in the order of the
 * model, then those of all contacts at once (em_impacts.h); resets; then the mode that follows from the state
 * (em_mode_selection.h). */
#ifndef EM_EVENT_ACTIONS_H
#define EM_EVENT_ACTIONS_H

#include "dynamics/em_projection.h"
#include "contact/em_impacts.h"

/* Detects events that accumulate: each follows the one before without time passing. 0, or -1 and *fault. */
EM_NOINLINE int em_check_pile(const em_acting *a, em_pile *pile) {
    enum { MANY = 200 };
    const double soon = EM_SIMULTANEOUS_SPACINGS * DBL_EPSILON * fabs(a->t);
    for (int i = 0; i < N_EVENTS; ++i) {
        if (!a->fired[i]) continue;
        pile[i].count = pile[i].count > 0 && fabs(a->t - pile[i].t) <= soon ? pile[i].count + 1 : 1;
        pile[i].t = a->t;
        if (pile[i].count > MANY) return em_fail(a->fault, EM_EVENTS_PILE_UP, i, -1, NAN);
    }
    return 0;
}

/* --- impacts --- */

/* Whether an event that has fired is an impact that does not belong to a contact. */
EM_NOINLINE int em_is_event_impact(const em_acting *a, int event) {
    return a->fired[event] && event_actions[event].impact >= 0 && event_actions[event].held < 0;
}

/* One round of impacts. Returns whether there was any, or -1 and *fault. side (n_events): the sign of the approach,
 * 0: unknown */
EM_NOINLINE int em_impact_round(em_acting *a, em_all_rows *r, double *side) {
    int any = 0;
    for (int i = 0; i < N_EVENTS; ++i) {
        if (!em_is_event_impact(a, i)) continue;
        const int any_here = em_impact_event(a, r, i, &side[i]);
        if (any_here < 0) return -1;
        any |= any_here;
    }
    const int any_here = em_impact_contacts(a, r);
    return any_here < 0 ? -1 : any | any_here;
}

/* Applies all impacts. 0, or -1 and *fault. */
EM_NOINLINE int em_impact_all(em_acting *a, em_all_rows *r) {
    enum { ROUNDS = 1000 };
    double side[N_EVENTS] = {0.0};
    int any = 1;
    if (N_IMPACTS == 0) return 0;
    for (int round = 0; round < ROUNDS && any > 0; ++round) any = em_impact_round(a, r, side);
    if (any < 0) return -1;
    for (int i = 0; any && i < N_EVENTS; ++i)
        if (a->fired[i] && event_actions[i].impact >= 0) return em_fail(a->fault, EM_EVENTS_PILE_UP, i, -1, NAN);
    return 0;
}

/* --- resets --- */

/* Residuals of the constraints and the terms that cancel in them: of positions, and of rates along rows. */
typedef struct em_residuals {
    double phi[EM_SOME_POSITIONS], phi_terms[EM_SOME_POSITIONS], rate[EM_SOME_ROWS], rate_terms[EM_SOME_ROWS];
} em_residuals;

EM_NOINLINE void em_find_residuals(const em_acting *a, em_residuals *r) {
    double A[EM_SOME_ROWS * N], b[EM_SOME_ROWS];
    position(a->t, a->x, a->c, r->phi, r->phi_terms);
    pfaffian(a->t, a->x, a->c, A, b);
    for (int row = 0; row < N_ROWS; ++row) {
        r->rate[row] = b[row], r->rate_terms[row] = fabs(b[row]);
        for (int k = 0; k < N; ++k) {
            r->rate[row] += A[row * N + k] * a->v[k];
            r->rate_terms[row] += fabs(A[row * N + k] * a->v[k]);
        }
    }
}

/* Whether a reset has moved a row off zero: by more than a part of its terms, and than it was before. */
EM_NOINLINE int em_leaves_row(double before, double after, double terms) {
    return !(fabs(after) <= EM_RESET_TOLERANCE * terms + 2.0 * fabs(before));
}

/* Checks that a reset satisfies the constraints as well as the state before it did. 0, or -1 and *fault. */
EM_NOINLINE int em_check_reset(const em_acting *a, int event, const em_residuals *before) {
    em_residuals after;
    em_find_residuals(a, &after);
    for (int row = 0; row < N_POSITIONS; ++row)
        if (em_leaves_row(before->phi[row], after.phi[row], after.phi_terms[row]))
            return em_fail(a->fault, EM_RESET_OFF, event, row, after.phi[row]);
    for (int row = 0; row < N_ROWS; ++row)
        if (em_leaves_row(before->rate[row], after.rate[row], after.rate_terms[row]))
            return em_fail(a->fault, EM_RESET_OFF, event, row, after.rate[row]);
    return 0;
}

EM_NOINLINE int em_reset(em_acting *a, int event) {
    double after[EM_SOME_RESETS * 2 * N];
    em_residuals before;
    const int number = event_actions[event].reset;
    if (N_RESETS == 0) return 0; /* so that compilers see it, too */
    resets(a->t, a->x, a->v, a->c, a->u, after);
    const double *const at = after + number * 2 * N;
    em_find_residuals(a, &before);
    for (int k = 0; k < 2 * N; ++k)
        if (!isfinite(at[k])) return em_fail(a->fault, EM_NON_FINITE_STATE, k % N, -1, NAN);
    if (a->along) a->along->reset(a, number);
    memcpy(a->x, at, N * sizeof *at);
    if (!resets_quasi[number]) memcpy(a->v, at + N, N * sizeof *at);
    else if (em_rates_of_quasi(a->t, a->x, at + N, a->c, a->v)) return em_fail(a->fault, EM_RESET_OFF, event, EM_NO_RATES, NAN);
    if (a->along && resets_quasi[number] && a->along->quasi(a))
        return em_fail(a->fault, EM_RESET_OFF, event, EM_NO_RATES, NAN);
    a->moved = 1;
    return em_check_reset(a, event, &before);
}

/* --- the mode afterwards --- */

/* released and last <- of sticking cones: cones that share a load reach their limits at the same time, up to
 * rounding. */
EM_NOINLINE void em_find_released_cones(em_acting *a) {
    double acceleration[N], lambda[EM_SOME_ROWS], level[EM_LEVELS * EM_SOME_SWITCHES];
    em_fault fault;
    if (em_acceleration(a->t, a->x, a->v, a->c, a->u, EM_LEAST_NORM, acceleration, lambda, &fault)) return;
    levels(a->t, a->x, a->v, a->c, a->u, level);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const one = &switches[k];
        if (!em_is_cone(one) || !em_holds(one, a->c)) continue;
        const double force = em_along_switch(one, lambda), limit = em_limit(one, level[EM_LEVELS * k + 1], lambda);
        a->released[k] |= force > 0.0 && force >= (1.0 - EM_AT_LIMIT) * limit;
        for (int i = 0; i < 2 && force > 0.0; ++i) a->last[2 * k + i] = lambda[one->row + i] / force;
    }
}

/* lets_go <- switches whose row held and whose event has fired: their force has reached its limit. */
EM_NOINLINE void em_find_released(em_acting *a) {
    int cones = 0;
    for (int k = 0; k < N_SWITCHES; ++k) {
        a->released[k] = a->fired[switches[k].event] && em_holds(&switches[k], a->c);
        cones |= a->released[k] && em_is_cone(&switches[k]);
    }
    if (cones) em_find_released_cones(a);
}

/* ahead <- if switches are released, the error of the time of an event; and four times more each time that the same
 * event happens again without time passing, until the forces after it can be told from rounding. */
EM_NOINLINE void em_find_ahead(em_acting *a, const em_pile *pile) {
    double times = 0.0;
    for (int k = 0; k < N_SWITCHES; ++k)
        if (a->released[k]) times = fmax(times, pow(4.0, fmin(pile[switches[k].event].count, 20.0) - 1.0));
    a->ahead = times * EM_SIMULTANEOUS_SPACINGS * DBL_EPSILON * fabs(a->t);
}

/* Whether a friction may have a normal force: from a contact at rest, a constraint, or the terms of its limit. */
EM_NOINLINE int em_may_have_normal_force(const em_acting *a, const em_all_rows *r, const em_switch *friction) {
    const int norm = em_norm_of(friction);
    int switched[EM_SOME_ROWS] = {0};
    if (norm < 0) return friction->over < 0 || em_is_at_rest(a, r, friction->over);
    for (int k = 0; k < N_SWITCHES; ++k) {
        switched[switches[k].row] = 1;
        if (em_is_contact(&switches[k]) && em_is_in_norm(norm, switches[k].row) && em_is_at_rest(a, r, k)) return 1;
    }
    for (int row = 0; row < N_ROWS; ++row)
        if (!switched[row] && em_is_in_norm(norm, row)) return 1;
    return 0;
}

/* v <- without the speed along the rows at rest, which is rounding. A friction on a contact that opens stops nothing.
 * 0, or -1 and *fault. */
EM_NOINLINE int em_stop_at_rest(em_acting *a, em_all_rows *r) {
    em_state_of_switch mode[EM_SOME_SWITCHES];
    double c[N_PREPARED + 1];
    memcpy(c, a->c, N_PREPARED * sizeof *c);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        const int stops = em_is_at_rest(a, r, k) && (em_is_contact(s) || em_may_have_normal_force(a, r, s));
        mode[k] = (em_state_of_switch){.holds = stops};
    }
    if (em_set_mode(c, mode, a->fault)) return -1;
    if (em_project_velocity(a->t, a->x, a->v, c, EM_LEAST_NORM, a->fault)) return -1;
    em_rates_along(r, a->v);
    return 0;
}

/* rounding <- of what the event of a switch watches in the mode decided: of the force of a row that holds; of a gap or a
 * slip; for a slip at rest plus its remaining value; for a cone also its shift. */
EM_NOINLINE void em_set_rounding(const em_acting *a, const em_all_rows *r, int k, int at_rest) {
    const int row = switches[k].row, contact = em_is_contact(&switches[k]);
    double *const rounding = &a->rounding[switches[k].event];
    *rounding = EM_GAP_ROUNDING * (contact ? r->gap_terms : r->rate_terms)[row];
    if (em_holds(&switches[k], a->c)) *rounding = EM_GAP_ROUNDING * em_along_switch(&switches[k], a->force_terms);
    else if (em_is_cone(&switches[k])) *rounding = 2.0 * EM_CONE_SHIFT * em_cone_stop_slip(a, r, &switches[k]);
    else if (!contact && at_rest) *rounding += 2.0 * fabs(r->rate[row]);
}

/* Finds the mode that follows from the state, and projects the state onto its rows. 0, or -1 and *fault. */
EM_NOINLINE int em_settle_modes(em_acting *a) {
    em_state_of_switch before[EM_SOME_SWITCHES], after[EM_SOME_SWITCHES];
    int rests[EM_SOME_SWITCHES];
    em_all_rows r;
    if (N_SWITCHES == 0) return 0;
    if (em_all_rows_at(a->t, a->x, a->v, a->c, &r, a->fault)) return -1;
    em_find_rest_rates(a, &r);
    em_find_separation_rates(a);
    if (em_stop_at_rest(a, &r)) return -1;
    em_mode_of(a->c, before);
    for (int k = 0; k < N_SWITCHES; ++k) rests[k] = em_is_at_rest(a, &r, k);
    if (em_decide_mode(a, &r)) return -1;
    em_mode_of(a->c, after);
    for (int k = 0; k < N_SWITCHES; ++k)
        if (before[k].holds != after[k].holds || before[k].slides != after[k].slides || before[k].idles != after[k].idles)
            a->fired[switches[k].event] = 1;
    if (em_project(a->t, a->x, a->v, a->c, a->least_norm, a->fault)) return -1;
    pfaffian(a->t, a->x, r.c, r.A, r.b);
    em_rates_along(&r, a->v);
    for (int k = 0; a->rounding && k < N_SWITCHES; ++k) em_set_rounding(a, &r, k, rests[k]);
    return 0;
}

/* Resets in the order of the model, each applied to the state after the one before. Returns whether there was one,
 * or -1 and *fault. */
EM_NOINLINE int em_reset_all(em_acting *a) {
    int last = -1;
    double from[N];
    memcpy(from, a->x, sizeof from);
    for (int i = 0; i < N_EVENTS; ++i) {
        if (!a->fired[i] || event_actions[i].reset < 0) continue;
        last = i;
        if (em_reset(a, i)) return -1;
    }
    return last >= 0 && em_check_apart(a->t, from, a->x, a->v, a->c, a->u, last, a->fault) ? -1 : last >= 0;
}

/* The event of the first contact whose gap is negative; -1: none. */
EM_NOINLINE int em_first_inside(const em_all_rows *r) {
    for (int k = 0; k < N_SWITCHES; ++k)
        if (em_is_contact(&switches[k]) && r->gap[switches[k].row] < 0.0) return switches[k].event;
    return -1;
}

/* Whether the start is inside a contact: 1; 0; or -1 and *fault if by more than its tolerance. */
EM_NOINLINE int em_starts_inside(em_acting *a, const em_all_rows *r) {
    int inside = 0;
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (!em_is_contact(s) || em_holds(s, a->c) || !(r->gap[s->row] < -EM_CLOSED_GAP * r->gap_terms[s->row])) continue;
        if (a->atol && -r->gap[s->row] > em_reach(a, r->A + s->row * N, a->x, EM_START_STEPS, em_start_tolerance(a->rtol)))
            return em_fail(a->fault, EM_START_REFUSED, s->event, EM_INSIDE_CONTACT, r->gap[s->row]);
        a->depth = fmax(a->depth, -r->gap[s->row] / em_length(N, r->root.B + s->row * N));
        inside = 1;
    }
    return inside;
}

/* At the start of a run: moves a state that is inside contacts by less than its tolerance onto their surfaces. 0, or
 * -1 and *fault. */
EM_NOINLINE int em_move_outside_contacts(em_acting *a, em_all_rows *r) {
    enum { STEPS = 20 };
    double before[EM_SOME_ROWS];
    memcpy(before, r->rate, sizeof before);
    for (int step = 0; step <= STEPS; ++step) {
        const int inside = em_starts_inside(a, r);
        if (inside < 1) return inside;
        if (em_push_out(r, a->x)) break;
        if (em_all_rows_at(a->t, a->x, a->v, a->c, r, a->fault)) return -1;
        for (int row = 0; row < N_ROWS; ++row) a->rate_shift[row] = fabs(r->rate[row] - before[row]);
    }
    const int event = em_first_inside(r);
    return em_fail(a->fault, EM_START_REFUSED, event, event < 0 ? -1 : EM_INSIDE_CONTACT, NAN);
}

/* Whether a contact that touches approaches. */
EM_NOINLINE int em_approaches(const em_acting *a, const em_all_rows *r) {
    for (int k = 0; k < N_SWITCHES; ++k)
        if (em_is_contact(&switches[k]) && a->closed[k] && r->rate[switches[k].row] < -a->rest_rate[switches[k].row])
            return 1;
    return 0;
}

/* 0, or -1 and *fault. */
EM_EXPORT int em_act_on_all(em_acting *a, em_pile *pile) {
    em_pile before[N_EVENTS];
    em_all_rows r;
    memcpy(before, pile, sizeof before);
    if (em_check_pile(a, pile)) return -1;
    if (N_SWITCHES > 0 || N_IMPACTS > 0) {
        if (em_all_rows_at(a->t, a->x, a->v, a->c, &r, a->fault)) return -1;
        em_find_released(a);
        em_find_ahead(a, pile);
        if (a->starts && em_move_outside_contacts(a, &r)) return -1;
        em_find_closed(a, &r);
        em_find_rest_rates(a, &r);
        em_find_landed(a, &r, before);
        if (a->starts && em_approaches(a, &r)) return 0; /* its impact happens first, as an event */
        if (!a->starts && em_impact_all(a, &r)) return -1;
    }
    if (em_reset_all(a) < 0) return -1;
    return em_settle_modes(a);
}

/* x, v (n) and c (the mode) <- after the events `fired` (n_events) at t, in the order of the model; if none has fired,
 * at the start of a run. Events whose function jumps are added to `fired`; pile (n_events) belongs to the run. 0, or
 * -1 and *fault. */
EM_EXPORT int em_act(double t, double *x, double *v, double *c, const double *u, int least_norm, const em_act_limits *within,
                     int *fired, em_pile *pile, em_fault *fault) {
    em_acting a = {.t = t, .x = x, .v = v, .c = c, .u = u, .least_norm = least_norm, .fired = fired, .fault = fault,
                   .rtol = within->rtol, .atol = within->atol, .rounding = within->rounding, .depth = *within->depth,
                   .starts = em_none_fired(fired)};
    memcpy(a.rate_shift, within->rate_shift, N_ROWS * sizeof *a.rate_shift);
    const int failed = em_act_on_all(&a, pile);
    *within->depth = a.depth;
    memcpy(within->rate_shift, a.rate_shift, N_ROWS * sizeof *a.rate_shift);
    return failed;
}

/* em_model.event: g (n_events) in the mode of c; NaN where it has no value */
EM_EXPORT void em_watched(double t, const double *x, const double *v, const double *c, const double *u, double *g) {
    em_fault fault;
    model_events(t, x, v, c, u, g);
    if (em_watch_modes(t, x, v, c, u, EM_LEAST_NORM, g, &fault))
        for (int k = 0; k < N_EVENTS; ++k) g[k] = NAN;
}

#endif
