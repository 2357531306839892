/* em_impacts.h: impacts of several contacts at once, with friction: complementarity of velocities and impulses.
 *
 * Moreau's form of Newton's law: for contacts that approach, with rates w- before and w+ after,
 *
 *     P >= 0,  w+ + e w- >= 0,  P (w+ + e w-) = 0
 *
 * in one problem (em_complementarity.h) with the contacts that touch (w- = 0), the constraints, and the frictions on
 * these contacts. The impulse of a friction is at most its coefficient times that of the contact, and less only if
 * it does not slip afterwards. Poisson's law, for contacts that use it, consists of two such problems: in
 * compression e = 0; in expansion the impulse of a contact is at least e times that of its compression, and friction
 * is bounded in each phase by the impulse of that phase (Glocker and Pfeiffer 1995).
 *
 * A rebound no faster than `rest` is suppressed: e = 0. If friction lets Newton's law raise the energy, all
 * restitutions are lowered by one factor until it does not: with e = 0 energy never rises (Moreau 1988). */
#ifndef EM_IMPACTS_H
#define EM_IMPACTS_H

#include "contact/em_mode_selection.h"

#define EM_SEPARATING 1e-13 /* the part of the largest speed below which bodies count as separating */
#define EM_ENERGY_ROUNDING 1e-12 /* the part of the work of impulses by which rounding may raise the energy */

/* The problem of one impact: which rows strike, their restitutions (0 if they land), and impacts; rates before; the
 * results. The last row is that of an event's impact, without a contact, if there is one: oriented so that it
 * approaches with w < 0. */
typedef struct em_impact {
    int strikes[EM_IMPACT_ROWS], lands[EM_IMPACT_ROWS], impact[EM_IMPACT_ROWS];
    double e[EM_IMPACT_ROWS], rest[EM_IMPACT_ROWS], before[EM_IMPACT_ROWS], terms[EM_IMPACT_ROWS];
    double impulse[EM_IMPACT_ROWS], after[EM_IMPACT_ROWS], lowered, side, extra[N];
    int poisson;
    double B[EM_IMPACT_ROWS * N];
    em_mixed s;
} em_impact;

/* Whether the normal force of a friction may have an impulse: that of a contact that strikes or holds, or of
 * constraint rows. */
EM_NOINLINE int em_takes_impact(const em_mixed *s, const em_switch *friction) {
    int any = friction->over >= 0 && s->kind[switches[friction->over].row] == EM_ROW_CONTACT;
    for (int row = 0; row < N_ROWS && em_norm_of(friction) >= 0; ++row)
        any |= em_is_in_norm(em_norm_of(friction), row) && s->kind[row] != EM_ROW_OUT;
    return any;
}

/* The rows of an impact: constraints, contacts that strike or touch, frictions on them; rates before. */
EM_NOINLINE void em_impact_rows(const em_acting *a, const em_all_rows *r, em_impact *b) {
    em_mixed *const s = &b->s;
    double level[EM_LEVELS * EM_SOME_SWITCHES];
    em_begin_mixed(r, s);
    levels(a->t, a->x, a->v, a->c, a->u, level);
    memcpy(b->B, r->root.B, N_ROWS * N * sizeof *b->B);
    for (int row = 0; row < N_ROWS; ++row) {
        b->before[row] = s->kind[row] == EM_ROW_FREE ? 0.0 : r->rate[row];
        b->terms[row] = r->rate_terms[row];
    }
    for (int i = 0; i < 2 * N_SWITCHES; ++i) { /* contacts first, then frictions, which may precede them in the model */
        const int contacts = i < N_SWITCHES, k = contacts ? i : i - N_SWITCHES;
        const em_switch *const one = &switches[k];
        const int row = one->row;
        if (em_is_contact(one) != contacts) continue;
        b->rest[row] = level[EM_LEVELS * k];
        if (contacts && a->closed[k] && r->rate[row] <= a->rest_rate[row])
            s->kind[row] = EM_ROW_CONTACT, s->choice[row] = EM_HOLDS_ROW;
        else if (!contacts && em_takes_impact(s, one))
            em_friction_row(s, k, level, NULL, a->c), s->coefficient_at_rest[row] = s->coefficient[row];
    }
}

/* q = w-; (1 + e) w- for rows that strike. */
EM_NOINLINE void em_impact_rates(em_impact *b) {
    for (int row = 0; row < EM_IMPACT_ROWS; ++row) {
        const double e = b->strikes[row] && !b->lands[row] ? b->lowered * b->e[row] : 0.0;
        b->s.q[row] = (1.0 + e) * b->before[row], b->s.size[row] = b->terms[row];
    }
}

/* The work of the impulses on the relative velocities, divided by the sum of its magnitudes. */
EM_NOINLINE double em_impact_work(const em_impact *b) {
    double work = 0.0, size = 0.0;
    for (int row = 0; row < EM_IMPACT_ROWS; ++row) {
        const double after = b->after[row];
        if (b->s.kind[row] == EM_ROW_OUT || b->s.kind[row] == EM_ROW_FREE) continue;
        work += 0.5 * b->impulse[row] * (after + b->before[row]);
        size += 0.5 * fabs(b->impulse[row]) * (fabs(after) + fabs(b->before[row]));
    }
    return size > 0.0 ? work / size : 0.0;
}

/* Expansion after compression: impulse (m + 1) so far, rates s.w. As em_solve_mixed. */
EM_NOINLINE int em_impact_expands(em_impact *b) {
    em_mixed *const s = &b->s;
    double least_impulse[EM_IMPACT_ROWS], level[EM_IMPACT_ROWS], at_rest[EM_IMPACT_ROWS];
    memcpy(level, s->level, sizeof level), memcpy(at_rest, s->at_rest, sizeof at_rest);
    for (int row = 0; row < EM_IMPACT_ROWS; ++row)
        least_impulse[row] = b->strikes[row] && !b->lands[row] ? b->lowered * b->e[row] * b->impulse[row] : 0.0;
    for (int row = 0; row < EM_IMPACT_ROWS; ++row) {
        double presses = 0.0;
        s->q[row] = s->w[row];
        for (int j = 0; j < EM_IMPACT_ROWS; ++j) {
            const double part = s->G[row * EM_IMPACT_ROWS + j] * least_impulse[j];
            s->q[row] += part, s->size[row] += fabs(part);
            presses += s->over[row * EM_IMPACT_ROWS + j] * least_impulse[j];
        }
        if (s->rooted[row]) continue;
        s->level[row] += s->coefficient[row] * presses, s->at_rest[row] += s->coefficient_at_rest[row] * presses;
    }
    memcpy(s->known_p, least_impulse, sizeof least_impulse);
    const int found = em_solve_mixed(s);
    memset(s->known_p, 0, sizeof s->known_p);
    for (int row = 0; row < EM_IMPACT_ROWS; ++row) b->impulse[row] += least_impulse[row] + s->p[row];
    memcpy(s->level, level, sizeof level), memcpy(s->at_rest, at_rest, sizeof at_rest);
    return found;
}

/* Solves the impact with restitutions lowered by this factor: impulse and rates after. As em_solve_mixed. */
EM_NOINLINE int em_impact_solve(em_impact *b, double lowered) {
    b->lowered = b->poisson ? 0.0 : lowered;
    em_impact_rates(b);
    int found = em_solve_mixed(&b->s);
    b->lowered = lowered;
    memcpy(b->impulse, b->s.p, sizeof b->impulse);
    if (found == 1 && b->poisson) found = em_impact_expands(b);
    for (int row = 0; row < EM_IMPACT_ROWS; ++row)
        b->after[row] = b->poisson ? b->s.w[row] : b->s.w[row] - (b->s.q[row] - b->before[row]);
    return found;
}

/* The same with the largest factor at which the energy does not grow. */
EM_NOINLINE int em_impact_within_energy(em_impact *b) {
    double low = 0.0, high = 1.0;
    const int found = em_impact_solve(b, high);
    if (found < 1 || em_impact_work(b) <= EM_ENERGY_ROUNDING) return found;
    while (high - low > 4.0 * DBL_EPSILON) {
        const double middle = 0.5 * (low + high);
        if (em_impact_solve(b, middle) == 1 && em_impact_work(b) <= EM_ENERGY_ROUNDING) low = middle;
        else high = middle;
    }
    return em_impact_solve(b, low);
}

/* The same without the restitution of contacts that would rebound no faster than their `rest`: these land. 1, or as
 * em_solve_mixed. */
EM_NOINLINE int em_impact_with_landings(em_impact *b) {
    for (int more = 1; more;) {
        const int found = em_impact_within_energy(b);
        if (found < 1) return found;
        more = 0;
        for (int row = 0; row < EM_IMPACT_ROWS; ++row) {
            if (!b->strikes[row] || b->lands[row] || !(b->after[row] <= b->rest[row])) continue;
            b->lands[row] = 1;
            more |= b->e[row] > 0.0;
        }
    }
    return 1;
}

/* change (n) <- M^-1 B^T P */
EM_NOINLINE void em_change_by_impact(const em_all_rows *r, const em_impact *b, double *change) {
    memset(change, 0, N * sizeof *change);
    for (int row = 0; row < EM_IMPACT_ROWS; ++row)
        for (int k = 0; k < N; ++k) change[k] += b->B[row * N + k] * b->impulse[row];
    em_backward(N, r->root.L, r->root.r, change);
}

/* Applies the impact that has been set up; a fault names `event`. 1, or -1 and *fault. */
EM_NOINLINE int em_apply_impact(em_acting *a, const em_all_rows *r, em_impact *b, int event) {
    double change[N];
    for (int row = 0; row < EM_IMPACT_ROWS; ++row)
        if (b->strikes[row] && !(b->e[row] >= 0.0 && b->e[row] <= 1.0))
            return em_fail(a->fault, EM_IMPACT_UNDEFINED, event, EM_BAD_RESTITUTION, b->e[row]);
    if (em_impact_with_landings(b) < 1) return em_fail(a->fault, EM_IMPACT_UNDEFINED, event, -1, NAN);
    em_change_by_impact(r, b, change);
    if (a->along && a->along->impact(a, r, b, change, event)) return -1;
    for (int k = 0; k < N; ++k) a->v[k] += change[k];
    a->moved = 1;
    return 1;
}

/* One impact of all contacts that approach. Returns whether there was one, or -1 and *fault. */
EM_NOINLINE int em_impact_contacts(em_acting *a, em_all_rows *r) {
    em_impact b = {.lowered = 1.0};
    double impact_data[EM_SOME_IMPACTS * EM_IMPACT_SIZE];
    int first = -1;
    em_rates_along(r, a->v);
    em_find_rest_rates(a, r);
    impacts(a->t, a->x, a->v, a->c, a->u, impact_data);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const one = &switches[k];
        const int impact = event_actions[one->event].impact;
        if (!em_is_contact(one) || impact < 0 || !a->closed[k]) continue;
        if (!(r->rate[one->row] < -a->rest_rate[one->row])) continue;
        b.strikes[one->row] = 1, b.poisson |= one->poisson;
        b.impact[one->row] = impact;
        b.e[one->row] = impact_data[impact * EM_IMPACT_SIZE + N + 1];
        if (first < 0) first = one->event;
        a->fired[one->event] = 1;
    }
    if (first < 0) return 0;
    em_impact_rows(a, r, &b);
    return em_apply_impact(a, r, &b, first);
}

/* The impact of an event without a contact; *side: the sign of the approach. Returns whether it approaches, or -1 and
 * *fault. */
EM_NOINLINE int em_impact_event(em_acting *a, em_all_rows *r, int event, double *side) {
    em_impact b = {.lowered = 1.0};
    double impact_data[EM_SOME_IMPACTS * EM_IMPACT_SIZE], *const own = b.B + N_ROWS * N;
    const int first = *side == 0.0;
    impacts(a->t, a->x, a->v, a->c, a->u, impact_data);
    const double *const at = impact_data + event_actions[event].impact * EM_IMPACT_SIZE;
    const double approach = em_approach(at, a->v);
    if (first) *side = event_actions[event].keeps_apart || approach < 0.0 ? -1.0 : 1.0;
    if (!(*side * approach > (first ? 0.0 : EM_SEPARATING * em_fastest(&r->root, at, a->v)))) return 0;
    em_rates_along(r, a->v);
    em_find_rest_rates(a, r);
    em_impact_rows(a, r, &b);
    b.side = -*side, b.strikes[N_ROWS] = 1, b.impact[N_ROWS] = event_actions[event].impact;
    b.e[N_ROWS] = at[N + 1], b.rest[N_ROWS] = -INFINITY;
    b.before[N_ROWS] = b.side * approach;
    b.terms[N_ROWS] = fabs(at[N]);
    for (int k = 0; k < N; ++k) own[k] = b.extra[k] = b.side * at[k], b.terms[N_ROWS] += fabs(at[k] * a->v[k]);
    em_forward(N, r->root.L, r->root.r, own);
    for (int row = 0; row < EM_IMPACT_ROWS; ++row) {
        double sum = 0.0;
        for (int k = 0; k < N; ++k) sum += b.B[row * N + k] * own[k];
        b.s.G[row * EM_IMPACT_ROWS + N_ROWS] = sum;
        b.s.G[N_ROWS * EM_IMPACT_ROWS + row] = sum;
    }
    b.s.kind[N_ROWS] = EM_ROW_CONTACT, b.s.choice[N_ROWS] = EM_HOLDS_ROW;
    return em_apply_impact(a, r, &b, event);
}

#endif
