/* em_variation_time_events.h: directions across time events (em_time_events.h).
 *
 * If a time event happens dtau later, the motion before it lasts that much longer: dz+ = dz- + (f- - f+) dtau, f the
 * rates (v, a) on both sides. This holds for forces that jump. If constraint rows jump, or if coinciding time events
 * have different derivatives, there are no directions after it. */
#ifndef EM_VARIATION_TIME_EVENTS_H
#define EM_VARIATION_TIME_EVENTS_H

#include "sensitivity/em_variation_pass.h"

#define EM_SIMULTANEOUS_DERIVATIVE 1e-9 /* relative: difference of the derivatives of times that stay simultaneous */
#define EM_ROWS_JUMP 1e-9        /* an entry of a constraint row jumps if it changes by this part of its terms */

/* dtau (columns) <- the derivative of the times of all time events at t, or within `near`; `at` has their times. 0,
 * or -1: the derivatives differ. */
static int em_time_event_shift(const em_pass *p, const double *at, double t, double near, double *dtau) {
    const em_model *const model = p->of->model;
    const int width = model->n_arguments, k = p->columns;
    double D[model->n_time_events * 2 * width];
    int found = 0;
    model->time_event_partials(p->c, D);
    for (int i = 0; i < model->n_time_events; ++i) {
        const double *const b = at + 3 * i, *const by = D + 2 * i * width + 2 * p->n;
        if (!(em_time_event_reach_near(1, b, t, near) > 0.0)) continue;
        const double turns = b[1] != 0.0 ? round((t - b[0]) / b[1]) : 0.0;
        for (int j = 0; j + 1 < k; ++j) {
            double change = 0.0;
            for (int g = 0; g < p->of->n_forcing; ++g)
                if (p->P[g * k + j] != 0.0) change += (by[g] + turns * by[width + g]) * p->P[g * k + j];
            if (found && !p->records_for && !(fabs(change - dtau[j]) <= EM_SIMULTANEOUS_DERIVATIVE * fmax(fabs(change), fabs(dtau[j])))) return -1;
            dtau[j] = change;
        }
        found = 1;
    }
    return 0;
}

/* Whether an entry of A or b jumps: a continuous one changes more at the times further away. */
static int em_rows_jump(const em_pass *p, double t, double reach) {
    const int size = p->m * p->n + p->m;
    const double times[4] = {t - 100.0 * reach, t - reach, t + reach, t + 100.0 * reach};
    double rows[4][size];
    for (int side = 0; side < 4; ++side)
        p->of->model->pfaffian(times[side], p->z, p->c, rows[side], rows[side] + p->m * p->n);
    for (int i = 0; i < size; ++i) {
        const double near = fabs(rows[2][i] - rows[1][i]), terms = fabs(rows[1][i]) + fabs(rows[2][i]);
        if (near > EM_ROWS_JUMP * terms && near > 0.1 * fabs(rows[3][i] - rows[0][i])) return 1;
    }
    return 0;
}

/* S <- directions after a time event at t, with rates (2 n) before and after. `first`: the motion starts there. */
static int em_cross_directions(em_pass *p, const double *at, double t, int first, const double *before, const double *after) {
    const int n = p->n, k = p->columns;
    double dtau[k];
    int jumps = 0;
    memset(dtau, 0, sizeof dtau);
    for (int i = n; i < 2 * n; ++i) jumps |= fabs(after[i] - before[i]) > EM_JUMP_ROUNDING * (fabs(after[i]) + fabs(before[i]));
    if (em_time_event_shift(p, at, t, 0.0, dtau)) return em_end_pass(p->of, EM_TIME_EVENTS_MEET, -1, -1);
    for (int j = 0; jumps && j + 1 < k; ++j) {
        if (dtau[j] == 0.0) continue;
        if (first || !isfinite(dtau[j])) return em_end_pass(p->of, EM_TIME_EVENTS_MEET, -1, -1);
        for (int i = n; i < 2 * n; ++i) p->S[i * k + j] += (before[i] - after[i]) * dtau[j];
    }
    return 0;
}

/* Restricts the evaluation of the model to one side of t, if t is a time event or close to one. Returns the distance up
 * to which the time event extends, 0: there is none. */
static double em_pass_side(em_pass *p, double t, double near, int after) {
    const em_model *const model = p->of->model;
    p->inside[0] = -INFINITY, p->inside[1] = INFINITY;
    if (model->n_time_events == 0) return 0.0;
    double at[3 * model->n_time_events];
    model->time_events(p->c, at);
    const double reach = em_time_event_reach_near(model->n_time_events, at, t, near), way = after ? p->of->direction : -p->of->direction;
    if (reach > 0.0) p->inside[way > 0.0 ? 0 : 1] = t + way * reach;
    return reach;
}

/* Whether another stop is as close to a time event as this one. */
static int em_is_crowded(const em_variations *w, size_t stop, double reach) {
    const double before = stop > 0 ? fabs(w->t[stop] - w->t[stop - 1]) : 0.0;
    const double after = stop + 1 < w->n_stops ? fabs(w->t[stop + 1] - w->t[stop]) : 0.0;
    return (before > 0.0 && before <= reach) || (after > 0.0 && after <= reach);
}

/* dtau (columns) <- the derivative of the time of a time event at a stop; jump (2 n) <- the jump of the rates at z that
 * this time event causes. 1; 0: there is none that matters; or -1. The model is then evaluated on the side after it. */
static int em_time_event_at(em_pass *p, size_t stop, double near, double *dtau, double *jump) {
    const em_model *const model = p->of->model;
    const double t = p->of->t[stop], reach = em_pass_side(p, t, near, 0);
    double at[3 * model->n_time_events + 1], before[2 * p->n], after[2 * p->n];
    int jumps = 0;
    if (!(reach > 0.0)) return 0;
    if (em_motion_rate(p, t, p->z, before)) return -1;
    em_pass_side(p, t, near, 1);
    if (em_motion_rate(p, t, p->z, after)) return -1;
    for (int i = 0; i < 2 * p->n; ++i) {
        jump[i] = before[i] - after[i];
        jumps |= i >= p->n && fabs(jump[i]) > EM_JUMP_ROUNDING * (fabs(after[i]) + fabs(before[i]));
    }
    if (p->m > 0 && em_rows_jump(p, t, reach)) return em_end_pass(p->of, EM_ROWS_BREAK, -1, -1);
    memset(dtau, 0, p->columns * sizeof *dtau);
    model->time_events(p->c, at);
    if (jumps && (em_is_crowded(p->of, stop, reach) || em_time_event_shift(p, at, t, near, dtau)))
        return em_end_pass(p->of, EM_TIME_EVENTS_MEET, -1, -1);
    return jumps;
}

/* Sets the interval between time events for a span; if the span starts at a time event, S <- directions after it. 0, or
 * -1. */
static int em_pass_time_events(em_pass *p, double from, double to, int first) {
    const em_model *const model = p->of->model;
    const double direction = p->of->direction;
    if (model->n_time_events == 0) return 0;
    double at[3 * model->n_time_events], before[2 * p->n], after[2 * p->n];
    model->time_events(p->c, at);
    const double reach = em_time_event_reach(model->n_time_events, at, from);
    p->inside[0] = p->inside[1] = from - direction * reach;
    if (reach > 0.0 && em_motion_rate(p, from, p->z, before)) return -1;
    em_time_event_sides(model->n_time_events, at, from, to, direction, p->inside);
    if (!(reach > 0.0)) return 0;
    if (em_motion_rate(p, from, p->z, after)) return -1;
    if (p->m > 0 && !first && em_rows_jump(p, from, reach)) return em_end_pass(p->of, EM_ROWS_BREAK, -1, -1);
    if (em_cross_directions(p, at, from, first, before, after)) return -1;
    return 0;
}

#endif
