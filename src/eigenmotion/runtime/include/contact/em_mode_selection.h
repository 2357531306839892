/* em_mode_selection.h: the active set that a state determines: complementarity of accelerations and forces of the
 * rows at rest.
 *
 * At gap = 0 and without speed a contact's acceleration w and force p satisfy w >= 0, p >= 0, w p = 0. The force of
 * a friction at rest is at most its limit, and below it only if the friction does not begin to slip. With the
 * constraints and the sliding frictions, this is the problem of em_complementarity.h with w = A a + gamma. */
#ifndef EM_MODE_SELECTION_H
#define EM_MODE_SELECTION_H

#include "dynamics/em_dependent_rows.h"
#include "contact/em_reset.h"
#include "constraints/em_start_tolerance.h"

#define EM_SIMULTANEOUS_SPACINGS 4096.0     /* spacings of t: events closer than that are simultaneous */
#define EM_ZERO_SPEED 1e-12                 /* a speed counts as zero below this part of its terms */
#define EM_CLOSED_GAP (256.0 * DBL_EPSILON) /* a gap counts as closed below this part of its terms */
#define EM_DEPENDENT_RATE 1e-8              /* the allowed rate of a dependent row, as a part of its terms */
#define EM_GAP_ROUNDING (8.0 * DBL_EPSILON) /* the rounding of a gap, as a part of its terms */
#define EM_CONE_ROUNDING 1e-11              /* the slip of a cone has no direction below this part of its terms */
#define EM_CONE_STOP_SLIP (4.0 * sqrt(2.0 * N)) /* in tolerances: errors may reverse such a slip. The norm is a mean over
                                               2 n numbers, and all of the error may be that of the slip */
#define EM_CONE_SHIFT 8.0                   /* the shift of the slip of a cone that begins to slide, in units of that slip */
#define EM_NEIGHBOUR_DISTANCE 3e-4          /* distance of a neighbouring position, as a part of the displacement that
                                               changes a row entirely */
#define EM_IDLE 1e-3                        /* the tolerance of idle rows, as a part of the run's */
#define EM_AT_LIMIT 1e-9                    /* a force counts as at its limit if it is below it by at most this part */

struct em_acting;
struct em_impact;

/* S (2 n, columns) of x, v, and P (n_forcing, columns) of inputs, parameters, time; what maps S across an impact that
 * changes v by `change`, across a reset, and from quasi-velocities to rates (em_event_directions.h). The maps belong to
 * derivatives, which a run does not need. */
typedef struct em_directions {
    int columns;
    double *S;
    const double *P;
    int (*impact)(struct em_acting *a, const em_all_rows *r, const struct em_impact *b, const double *change, int event);
    void (*reset)(const struct em_acting *a, int number);
    int (*quasi)(const struct em_acting *a);
} em_directions;

/* The event actions at one time, with the state and the mode that they change; `along`: directions that are mapped
 * across them, or NULL. rtol, atol (n): of the run, or NULL; starts: whether the run starts here. */
typedef struct em_acting {
    double t, *x, *v, *c;
    const double *u;
    int least_norm, *fired;
    em_fault *fault;
    const em_directions *along;
    double rtol;
    const double *atol;
    int starts;
    double depth;                       /* depth inside contacts at the start, rows at length one */
    double rate_shift[EM_SOME_ROWS];   /* change of rates caused by moving the start outside */
    double *rounding;                  /* (n_events) <- rounding of gaps, slips and forces, or NULL */
    double force_terms[EM_SOME_ROWS];  /* sums of the magnitudes of the terms of forces along rows, in the mode decided */
    int moved;                         /* whether velocities, or positions, have jumped */
    int closed[EM_SOME_SWITCHES];      /* contacts whose gap is zero */
    int released[EM_SOME_SWITCHES];    /* switches that held and have fired */
    double ahead;                      /* with released switches: a time within the error of the event's (em_find_ahead) */
    double last[2 * EM_SOME_SWITCHES]; /* of released cones: the direction opposite to their forces */
    double rest_rate[EM_SOME_ROWS];    /* rates below which rows are at rest */
    double separation_rate[EM_SOME_SWITCHES]; /* rates below which contacts stay closed, unless an impact has separated
                                                 them */
} em_acting;

EM_NOINLINE int em_none_fired(const int *fired) {
    for (int i = 0; i < N_EVENTS; ++i)
        if (fired[i]) return 0;
    return 1;
}

/* The change of a row that a change of x (or of v, with the same scale) within tolerances causes. */
EM_NOINLINE double em_reach(const em_acting *a, const double *row, const double *z, double times, double rtol) {
    double sum = 0.0;
    for (int k = 0; k < N; ++k) sum += fabs(row[k]) * (times * a->atol[k] + rtol * fabs(z[k]));
    return sum;
}

/* rest_rate <- the rates that count as zero: the rounding of their terms, now or before; the rates of rows that hold,
 * unless an action has changed velocities; the change caused by moving the start outside; and at the start of a run a
 * part of its tolerances. */
EM_NOINLINE void em_find_rest_rates(em_acting *a, const em_all_rows *r) {
    for (int row = 0; row < N_ROWS; ++row) {
        a->rest_rate[row] = fmax(a->rest_rate[row], fmax(EM_ZERO_SPEED * r->rate_terms[row], 2.0 * a->rate_shift[row]));
        if (!a->starts || !a->atol) continue;
        a->rest_rate[row] = fmax(a->rest_rate[row], em_reach(a, r->A + row * N, a->v, EM_IDLE, 0.0));
    }
    for (int k = 0; k < N_SWITCHES && !a->moved; ++k) {
        const int row = switches[k].row;
        if (!em_holds(&switches[k], a->c) && !em_is_idle(&switches[k], a->c)) continue;
        for (int also = row; also <= row + em_is_cone(&switches[k]); ++also)
            a->rest_rate[also] = fmax(a->rest_rate[also], 2.0 * fabs(r->rate[also]));
    }
}

/* closed <- contacts that touch: those that held, and those whose gap has just closed or closes at the same time. */
EM_NOINLINE void em_find_closed(em_acting *a, const em_all_rows *r) {
    const double soon = EM_SIMULTANEOUS_SPACINGS * DBL_EPSILON * fabs(a->t);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (!em_is_contact(s)) continue;
        const double *const A = r->A + s->row * N;
        double within = EM_CLOSED_GAP * r->gap_terms[s->row] + soon * fabs(r->rate[s->row]);
        if (a->starts && a->atol) within = fmax(within, em_reach(a, A, a->x, EM_IDLE, 0.0));
        within = fmax(within, 4.0 * a->depth * em_length(N, r->root.B + s->row * N));
        a->closed[k] = em_holds(s, a->c) || em_is_idle(s, a->c) || a->fired[s->event] || r->gap[s->row] <= within;
    }
}

/* x (n) <- with no negative gap and phi = 0, by the least change in the mass metric. 0, or -1: there is none. */
EM_NOINLINE int em_push_out(const em_all_rows *r, double *x) {
    em_mixed s;
    double change[N] = {0.0};
    em_begin_mixed(r, &s);
    for (int row = 0; row < N_POSITIONS; ++row) s.q[row] = r->gap[row], s.size[row] = fabs(r->gap[row]);
    for (int row = N_POSITIONS; row < N_ROWS; ++row) s.kind[row] = EM_ROW_OUT;
    for (int k = 0; k < N_SWITCHES; ++k)
        if (em_is_contact(&switches[k])) s.kind[switches[k].row] = EM_ROW_CONTACT;
    if (em_solve_mixed(&s) < 1) return -1;
    for (int row = 0; row < N_POSITIONS; ++row)
        for (int k = 0; k < N; ++k) change[k] += r->root.B[row * N + k] * s.p[row];
    em_backward(N, r->root.L, r->root.r, change);
    for (int k = 0; k < N; ++k) x[k] += change[k];
    return 0;
}

/* Whether an idle row has moved by its tolerance: no other row holds it any more. */
EM_NOINLINE int em_has_left(const em_acting *a, const em_all_rows *r, int k) {
    const em_switch *const s = &switches[k];
    if (em_is_cone(s) || !em_is_idle(s, a->c) || !a->fired[s->event]) return 0;
    return (em_is_contact(s) ? r->gap[s->row] : fabs(r->rate[s->row])) >= 0.5 * a->c[s->idles];
}

/* separation_rate <- `rest` of contacts, if nothing has moved: a contact that touches at an event and opens no faster
 * than that stays closed. Otherwise ever faster bounces would become smaller than rounding can resolve. */
EM_NOINLINE void em_find_separation_rates(em_acting *a) {
    double level[EM_LEVELS * EM_SOME_SWITCHES];
    if (a->starts || a->moved) return;
    levels(a->t, a->x, a->v, a->c, a->u, level);
    for (int k = 0; k < N_SWITCHES; ++k)
        a->separation_rate[k] = em_is_contact(&switches[k]) ? level[EM_LEVELS * k] : 0.0;
}

/* pressing (m) <- the accelerations with which rows would close in the present motion. */
EM_NOINLINE void em_find_pressing(const em_acting *a, const em_all_rows *r, double *pressing) {
    double free_a[N], gamma[EM_SOME_ROWS], acceleration[N], lambda[EM_SOME_ROWS];
    em_fault none;
    for (int row = 0; row < N_ROWS; ++row) pressing[row] = 0.0;
    if (em_acceleration(a->t, a->x, a->v, a->c, a->u, EM_LEAST_NORM, acceleration, lambda, &none)) return;
    motion_bias(a->t, a->x, a->v, r->c, a->u, free_a, gamma);
    for (int row = 0; row < N_ROWS; ++row) {
        pressing[row] = -gamma[row];
        for (int k = 0; k < N; ++k) pressing[row] -= r->A[row * N + k] * acceleration[k];
    }
}

/* rest_rate <- with the rates of contacts that have landed. This ends a sequence of ever faster bounces: a flight whose
 * height is rounding of the gap, or whose duration is rounding of the time, cannot be told from rest. The height of a
 * flight that begins or ends with a rate is rate^2 / 2 over the acceleration that presses; if the rate is at most
 * `rest`, also that of the flight that has ended, a quarter of the rate times its duration. */
EM_NOINLINE void em_find_landed(em_acting *a, const em_all_rows *r, const em_pile *before) {
    double level[EM_LEVELS * EM_SOME_SWITCHES], pressing[EM_SOME_ROWS];
    const double soon = EM_SIMULTANEOUS_SPACINGS * DBL_EPSILON * fabs(a->t);
    if (a->starts) return;
    levels(a->t, a->x, a->v, a->c, a->u, level);
    em_find_pressing(a, r, pressing);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const int row = switches[k].row;
        const em_pile last = before[switches[k].event];
        const double closes = -r->rate[row], least = EM_CLOSED_GAP * r->gap_terms[row];
        if (!em_is_contact(&switches[k]) || !a->closed[k] || !(closes > 0.0)) continue;
        const int flew = last.count > 0.0 && closes <= level[EM_LEVELS * k] && 0.25 * closes * fabs(a->t - last.t) <= least;
        if (flew || closes * closes <= 2.0 * pressing[row] * (least + soon * closes))
            a->rest_rate[row] = fmax(a->rest_rate[row], closes);
    }
}

/* Whether a row is at rest: it held and no action has changed its speed; or its slip has just stopped or its gap
 * just closed (if it opens nevertheless, the motion returns within rounding); or its speed is rounding. */
EM_NOINLINE int em_is_at_rest(const em_acting *a, const em_all_rows *r, int k) {
    const em_switch *const s = &switches[k];
    const int came = em_holds(s, a->c) || em_is_idle(s, a->c) || a->fired[s->event];
    if ((em_is_contact(s) && !a->closed[k]) || em_has_left(a, r, k)) return 0;
    if (came && !a->moved) return 1;
    return em_along_switch(s, r->rate) <= fmax(em_along_switch(s, a->rest_rate), a->separation_rate[k]);
}

/* q <- the accelerations of the rows without forces along the choice rows, and size <- their terms. 0, or -1 and
 * *fault. */
EM_NOINLINE int em_free_row_accelerations(const em_acting *a, double t, const double *x, const double *v,
                                          const em_all_rows *r, em_mixed *s) {
    double free_a[N], gamma[EM_SOME_ROWS];
    motion_bias(t, x, v, r->c, a->u, free_a, gamma);
    em_forward(N, r->root.L, r->root.r, free_a);
    for (int row = 0; row < N_ROWS; ++row) {
        s->q[row] = gamma[row], s->size[row] = fabs(gamma[row]);
        for (int k = 0; k < N; ++k) {
            s->q[row] += r->root.B[row * N + k] * free_a[k];
            s->size[row] += fabs(r->root.B[row * N + k] * free_a[k]);
        }
        if (!isfinite(s->q[row])) return em_fail(a->fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    }
    return 0;
}

/* q and size, for the mode after the event. Where a force has reached zero, or its limit, its sign at the time of the
 * event is that of the error of this time, and terms that cancel leave no size. The motion goes on through it: so they
 * are those a little later in the motion that holds. 0, or -1 and *fault. */
EM_NOINLINE int em_row_accelerations_after(const em_acting *a, const em_all_rows *r, em_mixed *s) {
    double x[N], v[N], acceleration[N], lambda[EM_SOME_ROWS];
    em_all_rows later;
    em_fault none;
    if (!(a->ahead > 0.0) || a->moved || em_acceleration(a->t, a->x, a->v, a->c, a->u, EM_LEAST_NORM, acceleration, lambda, &none))
        return em_free_row_accelerations(a, a->t, a->x, a->v, r, s);
    for (int k = 0; k < N; ++k) x[k] = a->x[k] + a->ahead * a->v[k], v[k] = a->v[k] + a->ahead * acceleration[k];
    if (em_all_rows_at(a->t + a->ahead, x, v, a->c, &later, &none)) return em_free_row_accelerations(a, a->t, a->x, a->v, r, s);
    return em_free_row_accelerations(a, a->t + a->ahead, x, v, &later, s);
}

/* Sets up the problem of the rows at rest. 0, or -1 and *fault. */
EM_NOINLINE int em_mode_problem(const em_acting *a, const em_all_rows *r, em_mixed *s) {
    double level[EM_LEVELS * EM_SOME_SWITCHES];
    const int shared = em_shared_normal(r);
    if (shared >= 0) return em_fail(a->fault, EM_DEPENDENT_CONSTRAINTS, shared, EM_SHARED_LOAD, NAN);
    em_begin_mixed(r, s);
    levels(a->t, a->x, a->v, a->c, a->u, level);
    if (em_row_accelerations_after(a, r, s)) return -1;
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const one = &switches[k];
        const int at_rest = em_is_at_rest(a, r, k);
        if (em_is_contact(one)) {
            if (!at_rest) continue;
            s->kind[one->row] = EM_ROW_CONTACT;
            s->choice[one->row] = em_holds(one, a->c) != a->released[k] ? EM_HOLDS_ROW : EM_OPENS;
        } else {
            em_friction_row(s, k, level, at_rest ? NULL : r->rate, a->c);
            if (at_rest && a->c[one->slides] != 0.0 && !a->fired[one->event])
                s->choice[one->row] = a->c[one->slides] > 0.0 ? EM_FORWARD : EM_BACK;
        }
        if (!a->released[k] || a->moved) continue;
        s->barred[one->row] = EM_HOLDS_ROW;
        if (em_is_cone(one)) memcpy(s->last + one->row, a->last + 2 * k, 2 * sizeof *s->last);
    }
    return 0;
}

/* Q (count, n) <- row at length one without its component along those before. Returns the count including it, if it
 * does not vanish. */
EM_NOINLINE int em_add_direction(int count, double *Q, const double *row) {
    double rest[N];
    memcpy(rest, row, sizeof rest);
    em_remove_rows(N, count, Q, rest);
    const double left = em_length(N, rest);
    if (!(left * left > EM_DEPENDENT * em_length(N, row) * em_length(N, row))) return count;
    for (int k = 0; k < N; ++k) Q[count * N + k] = rest[k] / left;
    return count + 1;
}

/* Q (n, n) <- an orthonormal basis of the rows of B that hold in the mode. Returns its size. */
EM_NOINLINE int em_held_directions(const em_all_rows *r, const em_mixed *s, double *Q) {
    int count = 0;
    for (int i = 0; i < N_ROWS && count < N; ++i)
        if (em_row_holds(s, i)) count = em_add_direction(count, Q, r->root.B + i * N);
    return count;
}

/* The state at which em_mixed.follow_nearby is evaluated. */
typedef struct em_mode_at_state {
    const em_acting *a;
    const em_all_rows *r;
} em_mode_at_state;

/* em_mixed.follow_nearby: whether the mode has the same number of independent rows at neighbouring positions that it
 * allows. */
EM_NOINLINE int em_resting_rows_follow(const void *where, const em_mixed *s) {
    const em_mode_at_state *const here = where;
    const em_acting *const a = here->a;
    double Q[N * N], there_Q[N * N], unit[N];
    em_all_rows there;
    em_fault fault;
    const int held = em_held_directions(here->r, s, Q);
    em_coordinate_scales(a->t, a->x, here->r->c, unit);
    for (int k = 0, count = held; k < N && count < N; ++k) {
        double way[N] = {0.0}, x[N], size = 0.0;
        way[k] = 1.0;
        const int more = em_add_direction(count, Q, way);
        if (more == count) continue;
        memcpy(way, Q + count * N, sizeof way), count = more;
        em_backward(N, here->r->root.L, here->r->root.r, way);
        for (int i = 0; i < N; ++i) size = fmax(size, fabs(way[i]) / unit[i]);
        for (int i = 0; i < N; ++i) x[i] = a->x[i] + EM_NEIGHBOUR_DISTANCE / size * way[i];
        if (em_all_rows_at(a->t, x, a->v, a->c, &there, &fault) || em_held_directions(&there, s, there_Q) > held) return 0;
    }
    return 1;
}

/* Whether row B_row is a combination of the rows of the mode that hold. */
EM_NOINLINE int em_depends_on_mode(const em_all_rows *r, const em_mixed *s, int row) {
    double Q[N * N], rest[N];
    const int count = em_held_directions(r, s, Q);
    memcpy(rest, r->root.B + row * N, sizeof rest);
    const double length = em_length(N, rest);
    em_remove_rows(N, count, Q, rest);
    const double left = em_length(N, rest);
    return left * left <= EM_DEPENDENT * length * length;
}

/* Whether the acceleration along a row is zero, to rounding. */
EM_NOINLINE int em_is_still(const em_mixed *s, int row) {
    double terms = s->size[row];
    for (int j = 0; j < N_ROWS; ++j) terms += fabs(s->G[row * s->k + j] * s->p[j]);
    return !(fabs(s->w[row]) > EM_DEPENDENT_RATE * terms);
}

/* The tolerance of an idle row; 0: it is not idle. */
EM_NOINLINE double em_idle_slack(const em_acting *a, const em_all_rows *r, const em_mixed *s, int row, int contact) {
    if (!em_is_still(s, row) || !em_depends_on_mode(r, s, row)) return 0.0;
    const double slack = EM_ZERO_SPEED * (contact ? r->gap_terms[row] : r->rate_terms[row]);
    if (a->atol == NULL) return fmax(slack, DBL_MIN);
    return fmax(slack + em_reach(a, r->A + row * N, contact ? a->x : a->v, EM_IDLE, EM_IDLE * a->rtol), DBL_MIN);
}

/* --- dependent frictions along lines: forces within their limits --- */

/* Whether a friction along a line sticks with a force at its limit. */
EM_NOINLINE int em_sticks_at_limit(const em_mixed *s, int i) {
    if (s->kind[i] != EM_ROW_FRICTION || !em_row_holds(s, i)) return 0;
    return fabs(s->p[i]) >= (1.0 - EM_AT_LIMIT) * em_limit_of_row(s, i, 1);
}

/* Whether a friction along a line has a force at its limit, but neither slip nor an acceleration along it. */
EM_NOINLINE int em_stays_at_limit(const em_mixed *s, int i) {
    return s->kind[i] == EM_ROW_FRICTION && em_limit_sign(s, i) != 0.0 && em_is_still(s, i);
}

/* The number of frictions whose events rounding decides, without any motion: that stick with forces at their limits, or
 * stay at them though no row that holds keeps them. */
EM_NOINLINE int em_undecided(const em_all_rows *r, const em_mixed *s) {
    int count = 0;
    for (int i = 0; i < N_ROWS; ++i)
        count += em_sticks_at_limit(s, i) || (em_stays_at_limit(s, i) && !em_depends_on_mode(r, s, i));
    return count;
}

/* Whether the accelerations along all rows are those of `before`: then the motion is, since forces act along rows. */
EM_NOINLINE int em_moves_as(em_mixed *s, const em_mixed *before) {
    const double within = EM_MODE_VERIFIED * em_rates_of_mode(s);
    for (int i = 0; i < s->k; ++i)
        if (!(fabs(s->w[i] - before->w[i]) <= within)) return 0;
    return 1;
}

/* Whether the rows that `less` changes are within their conditions, without being at a limit. */
EM_NOINLINE int em_is_decided(const em_acting *a, const em_all_rows *r, const em_mixed *less, const em_mixed *s) {
    for (int i = 0; i < N_ROWS; ++i) {
        if (less->choice[i] == s->choice[i]) continue;
        const int idles = less->choice[i] == EM_IDLES;
        if (idles ? em_idle_slack(a, r, less, i, 0) == 0.0 : em_sticks_at_limit(less, i)) return 0;
    }
    return 1;
}

/* Frictions in rows `from` to `to` that stay at their limits <- stick, or idle without force if they depend on rows
 * that hold; if then fewer are undecided, and the motion is the same. Returns whether they do. */
EM_NOINLINE int em_leave_limits(const em_acting *a, const em_all_rows *r, em_mixed *s, int from, int to) {
    em_mixed less = *s;
    int any = 0;
    for (int i = from; i < to; ++i) {
        if (!em_stays_at_limit(s, i)) continue;
        less.choice[i] = em_depends_on_mode(r, &less, i) ? EM_IDLES : EM_HOLDS_ROW, any = 1;
    }
    if (!any || !em_is_consistent(&less) || !em_moves_as(&less, s) || !em_is_decided(a, r, &less, s)) return 0;
    if (em_undecided(r, &less) >= em_undecided(r, s)) return 0;
    *s = less;
    return 1;
}

/* p <- without frictions that load each other up to their limits. Forces of dependent rows are not unique, and in a
 * basic solution those of idle frictions are at their limits. Where normal forces are equal, as under a symmetric body,
 * they bring frictions that stick to their limits, too: rounding then decides whether these let go, again and again. */
EM_NOINLINE void em_relieve_frictions(const em_acting *a, const em_all_rows *r, em_mixed *s) {
    em_scale_mixed(s, 0);
    s->tolerance = EM_MODE_VERIFIED;
    if (em_undecided(r, s) > 0 && !em_any_cone_sticks(s) && !em_leave_limits(a, r, s, 0, N_ROWS))
        for (int i = 0; i < N_ROWS; ++i) em_leave_limits(a, r, s, i, i + 1);
    em_scale_mixed(s, 1);
}

/* --- the mode --- */

/* The slip below which a cone has stopped: the tolerances cannot distinguish it from zero. If the slip is a
 * difference of speeds, its errors are parts of these speeds: steps would alternate around zero. */
EM_NOINLINE double em_cone_stop_slip(const em_acting *a, const em_all_rows *r, const em_switch *s) {
    double slip = 1e-150;
    for (int row = s->row; row <= s->row + 1 && row < N_ROWS; ++row) {
        slip = fmax(slip, EM_CONE_ROUNDING * r->rate_terms[row]);
        if (!a->atol) continue;
        slip = fmax(slip, em_reach(a, r->A + row * N, a->v, EM_CONE_STOP_SLIP, EM_CONE_STOP_SLIP * a->rtol));
    }
    return slip;
}

/* The state of a sliding cone: idle if both its rows depend on rows that hold; else the slip at which it stops. If
 * it begins to slide, the slip is shifted along the direction in which it begins; if it continues, by the earlier
 * shift. */
EM_NOINLINE void em_cone_slides(const em_acting *a, const em_all_rows *r, const em_mixed *s, const em_switch *one,
                            em_state_of_switch *after) {
    const int row = one->row, begins = s->kind[row] == EM_ROW_CONE, slid = !begins && a->c[one->slides] != 0.0;
    const double one_slack = begins ? em_idle_slack(a, r, s, row, 0) : 0.0;
    const double other = one_slack > 0.0 ? em_idle_slack(a, r, s, row + 1, 0) : 0.0;
    const double stops = em_cone_stop_slip(a, r, one);
    after->slides = 1;
    for (int i = 0; i < 2; ++i)
        after->shift[i] = begins ? EM_CONE_SHIFT * stops * s->side[row + i] : slid ? a->c[one->shift + i] : 0.0;
    const double slip = hypot(r->rate[row] + after->shift[0], r->rate[row + 1] + after->shift[1]);
    after->idles = other > 0.0 ? fmax(one_slack, other) : -fmin(stops, 0.25 * slip);
}

/* The state of a switch that follows from the solution. */
EM_NOINLINE em_state_of_switch em_switch_after(const em_acting *a, const em_all_rows *r, const em_mixed *s, int k) {
    const em_switch *const one = &switches[k];
    const int row = one->row, contact = em_is_contact(one);
    em_state_of_switch after = {.holds = em_row_holds(s, row)};
    if (s->kind[row] == EM_ROW_OUT || after.holds || em_is_unloaded(s, row)) return after;
    if (em_is_cone(one)) return em_cone_slides(a, r, s, one, &after), after;
    if (!contact && s->choice[row] != EM_IDLES) after.slides = em_limit_sign(s, row) < 0.0 ? 1 : -1;
    if (em_is_choice_row(s, row)) after.idles = em_idle_slack(a, r, s, row, contact);
    return after;
}

/* The event of the switch whose row this is; -1: of none. */
EM_NOINLINE int em_event_of_row(int row) {
    for (int k = 0; k < N_SWITCHES; ++k)
        if (switches[k].row == row) return switches[k].event;
    return -1;
}

/* force_terms <- the forces that each term of the acceleration along a row would need alone. */
EM_NOINLINE void em_find_force_terms(em_acting *a, const em_mixed *s) {
    for (int row = 0; row < N_ROWS; ++row) {
        const double inverse = s->G[row * s->k + row];
        double terms = s->size[row];
        for (int j = 0; j < s->k; ++j) terms += fabs(s->G[row * s->k + j] * s->p[j]);
        a->force_terms[row] = inverse > 0.0 ? terms / inverse : 0.0;
    }
}

/* c <- the mode that follows from the state. 0, or -1 and *fault: there is none. */
EM_NOINLINE int em_decide_mode(em_acting *a, const em_all_rows *r) {
    em_state_of_switch mode[EM_SOME_SWITCHES];
    em_mixed s;
    const em_mode_at_state here = {a, r};
    if (em_mode_problem(a, r, &s)) return -1;
    s.follow_nearby = em_resting_rows_follow, s.where = &here;
    const int found = em_solve_mixed(&s);
    if (found < 1) {
        const int first = em_event_of_row(s.clash[0]), second = found < 0 ? EM_TOO_MANY_MODES : em_event_of_row(s.clash[1]);
        return em_fail(a->fault, EM_CONTACTS_CLASH, first, first < 0 && second == -1 ? EM_JAMMED : second, NAN);
    }
    em_relieve_frictions(a, r, &s);
    em_find_force_terms(a, &s);
    for (int k = 0; k < N_SWITCHES; ++k) mode[k] = em_switch_after(a, r, &s, k);
    return em_set_mode(a->c, mode, a->fault);
}

#endif
