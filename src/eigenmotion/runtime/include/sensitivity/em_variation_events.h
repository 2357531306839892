/* em_variation_events.h: directions across events (saltation).
 *
 * The time of an event changes by dt = -dg / gdot. The event, and the motion after it, are then that much later:
 *
 *     dz+ = D (dz- + f- dt) - f+ dt
 *
 * at fixed time, f the rates (v, a) before and after, D the derivative of the event actions on z (the identity
 * without any), with respect to the state, the other arguments and the time (em_saltation.h). */
#ifndef EM_VARIATION_EVENTS_H
#define EM_VARIATION_EVENTS_H

#include "kinematics/em_shadow_parameters.h"
#include "sensitivity/em_variation_control.h"

#define EM_EVENT_MARGIN 1e-9 /* of the time between stops: the distance from an event at which both sides are
                                evaluated */
#define EM_SAME_RATE 1e-6 /* relative: difference of rates on one side of a jump, at the event and at the margin */
#define EM_SAME_STATE 1e-8 /* relative: difference of the state after events in the run and in the pass */

/* Whether rates (v, a) are equal, apart from their continuous change over the margin of an event. */
static int em_is_same_rate(int n, const double *a, const double *b) {
    double apart = 0.0, size = 0.0;
    for (int i = n; i < 2 * n; ++i) {
        apart = fmax(apart, fabs(a[i] - b[i]));
        size = fmax(size, fmax(fabs(a[i]), fabs(b[i])));
    }
    return apart <= EM_SAME_RATE * size;
}

/* rate (2 n) <- (v, a) at z or, if that is on the other side of a jump, at a time `ahead` of it. */
static int em_rate_on_side(em_pass *p, double t, double ahead, double *rate) {
    const int n = p->n;
    double there[2 * n], near[2 * n];
    if (em_motion_rate(p, t, p->z, rate)) return -1;
    for (int i = 0; i < 2 * n; ++i) there[i] = p->z[i] + ahead * rate[i];
    if (em_motion_rate(p, t + ahead, there, near)) return -1;
    if (!em_is_same_rate(n, rate, near)) memcpy(rate, near, 2 * n * sizeof *rate);
    em_pass_inputs(p, t);
    return 0;
}

/* S <- extrapolated by `ahead` from t: from an event to its margin, or from the margin to the event. */
static int em_extrapolate_linearly(em_pass *p, double t, double ahead) {
    em_variations *const w = p->of;
    const int n = p->n, block = n * p->columns;
    em_pass_inputs(p, t);
    if (w->model->motion_along(t, p->z, p->z + n, p->c, p->u, w->least_norm, p->columns, p->S, p->P, p->a, p->lambda,
                               p->W, &w->fault)) return -1;
    em_add_to(block, ahead, p->S + block, p->S);
    em_add_to(block, ahead, p->W, p->S + block);
    return 0;
}

static int em_extrapolate_directions(em_pass *p, double t, double ahead) {
    if (p->tape) {
        em_begin_matrix(p);
        if (em_end_matrix(p, em_extrapolate_linearly(p->over_basis, t, ahead))) return -1;
    }
    return em_extrapolate_linearly(p, t, ahead);
}

/* The rate of an event's function, with the row g of its derivatives. */
static double em_event_rate(const em_pass *p, const double *g, const double *rate) {
    double gdot = 0.0;
    for (int i = 0; i < 2 * p->n; ++i) gdot += g[i] * rate[i];
    for (int i = 0; i < p->of->n_forcing; ++i) gdot += g[2 * p->n + i] * p->P[i * p->columns + p->columns - 1];
    return gdot;
}

/* dt (columns) <- the derivative of the time of an event; for the direction of the motion itself it is -1. */
static void em_event_shift(em_pass *p, double t, int event, const double *rate, double *dt) {
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments;
    double G[width * p->of->model->n_events];
    p->of->model->event_partials(t, p->z, p->z + n, p->c, p->u, G);
    const double *const g = G + event * width, gdot = em_event_rate(p, g, rate);
    for (int column = 0; column < k; ++column) {
        double change = 0.0;
        for (int i = 0; i < 2 * n; ++i) change += g[i] * p->S[i * k + column];
        for (int i = 0; i < p->of->n_forcing; ++i) change += g[2 * n + i] * p->P[i * k + column];
        dt[column] = -change / gdot;
    }
}

/* --- stops of friction cones ---
 *
 * The event of a cone is a slip that the tolerances of the run cannot tell from zero, so there the direction of the slip
 * is noise. Its derivatives by the state follow from larger slips, at several times before the stop: y = g S + g_p P and
 * gdot are extrapolated to the stop, and dt = -y / gdot. The effect of the noise of the direction is of second order,
 * and less where the slip is larger; that of the extrapolation is less where it is smaller. So the two predictions next
 * to each other that differ least are used, and their difference is the error. */

#define EM_CONE_LEAST 4.0   /* the slips of predictions, in slips of the event: the least */
#define EM_CONE_MOST 1e4    /* the largest */
#define EM_CONE_RATIO 2.0   /* of the times to the stop of predictions next to each other */
#define EM_CONE_CHANGE 1e-3 /* the interval of differences, as a part of the time to the stop */
#define EM_CONE_DOUBT 3e-3  /* the allowed difference of predictions, relative to the size of their terms */

/* The switch of the cone that slides, and that this event stops; -1: none. A cone that idles has a positive tolerance. */
static int em_sliding_cone(const em_pass *p, int event) {
    const em_model *const model = p->of->model;
    for (int s = 0; s < model->n_switches && event >= 0; ++s) {
        const em_switch *const one = &model->switches[s];
        if (one->event == event && one->shift >= 0 && p->c[one->slides] != 0.0 && p->c[one->idles] < 0.0) return s;
    }
    return -1;
}

/* Forgets predictions. */
static void em_begin_cone_stops(em_pass *p) {
    for (int s = 0; s < p->of->model->n_switches; ++s) {
        p->of_stops[s].doubt = INFINITY;
        for (int j = 0; j < p->columns; ++j) p->of_stops[s].dt[j] = p->of_stops[s].last[j] = NAN;
    }
}

/* The longest time that a cone which stops at a stop needs from the slip of its event to zero; 0: none stops there. */
static double em_cones_stop_within(em_pass *p, size_t stop) {
    const em_variations *const w = p->of;
    const em_model *const model = w->model;
    const int n = p->n;
    const double t = em_pass_clock(p, w->t[stop]), *const z = w->z + stop * 2 * n;
    double G[model->n_events * model->n_arguments + 1], rate[2 * n], most = 0.0;
    for (size_t mark = 0; mark < w->n_marks; ++mark) {
        const int s = w->mark_stop[mark] == (long)stop ? em_sliding_cone(p, w->mark_event[mark]) : -1;
        if (s < 0 || em_motion_rate(p, w->t[stop], z, rate)) continue;
        model->event_partials(t, z, z + n, p->c, p->u, G);
        const double within = p->c[model->switches[s].idles] / em_event_rate(p, G + w->mark_event[mark] * model->n_arguments, rate);
        if (isfinite(within)) most = fmax(most, fabs(within));
    }
    return most;
}

/* The derivatives of all event functions, and the rates (2 n), at z at t and on both sides of it along the motion. */
typedef struct em_event_slopes {
    double *G[3], *rate[3];
} em_event_slopes;

static int em_find_event_slopes(em_pass *p, double t, double apart, const em_event_slopes *of) {
    const int n = p->n;
    const double ahead[3] = {0.0, apart, -apart};
    double z[2 * n];
    if (em_motion_rate(p, t, p->z, of->rate[0])) return -1;
    for (int side = 2; side >= 0; --side) { /* the middle one last, whose inputs remain */
        for (int i = 0; i < 2 * n; ++i) z[i] = p->z[i] + ahead[side] * of->rate[0][i];
        if (em_motion_rate(p, t + ahead[side], z, of->rate[side])) return -1;
        p->of->model->event_partials(em_pass_clock(p, t + ahead[side]), z, z + n, p->c, p->u, of->G[side]);
    }
    return 0;
}

/* Keeps a prediction dt (columns), whose terms have these sizes, if it is nearer to the last one than those before. */
static void em_keep_cone_stop(const em_pass *p, em_cone_stop *of, const double *dt, const double *size) {
    const int columns = p->tape ? EM_GLOBAL_PROBES : p->of->columns;
    double apart = 0.0;
    for (int j = 0; j < columns; ++j)
        if (size[j] > 0.0) apart = fmax(apart, fabs(dt[j] - of->last[j]) / size[j]);
    if (isfinite(of->last[0]) && apart < of->doubt) of->doubt = apart, memcpy(of->dt, dt, p->columns * sizeof *dt);
    memcpy(of->last, dt, p->columns * sizeof *dt);
}

/* dt (columns) <- of the stop of a cone, extrapolated by `ahead` with the rates of the directions in W; size (columns) <-
 * of its terms. `apart`: the distance of the slopes. */
static void em_predict_cone_stop(const em_pass *p, int event, const em_event_slopes *of, double ahead, double apart,
                                 double *dt, double *size) {
    const int n = p->n, k = p->columns, forcing = p->of->n_forcing;
    const double *g[3], part = 0.5 * ahead / apart;
    for (int side = 0; side < 3; ++side) g[side] = of->G[side] + event * p->of->model->n_arguments;
    const double change = em_event_rate(p, g[1], of->rate[1]) - em_event_rate(p, g[2], of->rate[2]);
    const double gdot = em_event_rate(p, g[0], of->rate[0]) + part * change;
    for (int j = 0; j < k; ++j) {
        double y = 0.0, terms = 0.0;
        for (int i = 0; i < 2 * n + forcing; ++i) {
            const double at_stop = g[0][i] + part * (g[1][i] - g[2][i]);
            const double rate = i < n ? p->S[(n + i) * k + j] : i < 2 * n ? p->W[(i - n) * k + j] : 0.0;
            const double term = at_stop * (i < 2 * n ? p->S[i * k + j] : p->P[(i - 2 * n) * k + j]) + ahead * g[0][i] * rate;
            y += term, terms += fabs(term);
        }
        dt[j] = j + 1 < k ? -y / gdot : -1.0, size[j] = terms / fabs(gdot);
    }
}

/* Predicts the stops of all cones that slide, extrapolated by `ahead` from t. 0, or -1. */
static int em_predict_cone_stops(em_pass *p, double t, double ahead) {
    em_variations *const w = p->of;
    const em_model *const model = w->model;
    const int n = p->n, k = p->columns, all = model->n_events * model->n_arguments + 1;
    const double apart = EM_CONE_CHANGE * ahead;
    double G[3 * all], rate[6 * n], dt[k], size[k];
    const em_event_slopes of = {{G, G + all, G + 2 * all}, {rate, rate + 2 * n, rate + 4 * n}};
    if (em_find_event_slopes(p, t, apart, &of)) return -1;
    if (model->motion_along(em_pass_clock(p, t), p->z, p->z + n, p->c, p->u, w->least_norm, k, p->S, p->P, p->a, p->lambda,
                            p->W, &w->fault)) return -1;
    for (int s = 0; s < model->n_switches; ++s) {
        if (em_sliding_cone(p, model->switches[s].event) != s) continue;
        em_predict_cone_stop(p, model->switches[s].event, &of, ahead, apart, dt, size);
        em_keep_cone_stop(p, &p->of_stops[s], dt, size);
    }
    return 0;
}

/* dt <- of the stop of a cone, as predicted. At the stop all directions of the slip are parallel, and noise of that of
 * the event changes all dt by the same factor. A pass over a basis has it from the pass with the tape. 0, or -1. */
static int em_correct_cone_shift(em_pass *p, double t, int event, const double *rate, double *dt) {
    em_pass *const of = p->records_for ? p->records_for : p;
    const int s = em_sliding_cone(p, event), k = p->columns;
    if (s < 0) return 0;
    const em_cone_stop *const stop = &of->of_stops[s];
    if (!(stop->doubt <= EM_CONE_DOUBT)) return em_end_pass(p->of, EM_CONE_STOPS, event, -1);
    if (of == p) return memcpy(dt, stop->dt, k * sizeof *dt), 0;
    double probe[of->columns];
    em_pass_inputs(of, t);
    em_event_shift(of, t, event, rate, probe);
    for (int j = 0; j + 1 < k; ++j) dt[j] *= stop->dt[0] / probe[0];
    return 0;
}

/* --- events at the same time --- */

/* Whether two events, or an event and a time event, stay simultaneous for every change of the arguments, relative to
 * the larger change. */
static int em_stay_simultaneous(const em_pass *p, const double *one, const double *other) {
    if (p->records_for) return 1; /* the pass with the tape decides, whose directions can happen */
    const int columns = p->tape ? EM_GLOBAL_PROBES : p->columns - 1;
    for (int column = 0; column < columns; ++column)
        if (!(fabs(one[column] - other[column]) <= 1e-6 * fmax(fabs(one[column]), fabs(other[column])) + DBL_MIN)) return 0;
    return 1;
}

/* Whether the state of the run equals z; velocities v and a time give the scales of x and v. */
static int em_is_same_state(int n, const double *y, const double *z, const double *v, double length) {
    double apart[2] = {0.0, 0.0}, size[2] = {0.0, 0.0};
    for (int i = 0; i < n; ++i) {
        apart[0] = fmax(apart[0], fabs(y[i] - z[i])), size[0] = fmax(size[0], fmax(fabs(z[i]), length * fabs(v[i])));
        apart[1] = fmax(apart[1], fabs(y[n + i] - z[n + i])), size[1] = fmax(size[1], fmax(fabs(z[n + i]), fabs(v[i])));
    }
    return apart[0] <= EM_SAME_STATE * size[0] && apart[1] <= EM_SAME_STATE * size[1];
}

/* The first of the events that act. */
static int em_first_fired(const em_variations *w, const int *fired) {
    int event = 0;
    while (event < w->model->n_events - 1 && !fired[event]) ++event;
    return event;
}

/* Applies the event actions at a stop: z and the mode <- after them, as in the next stop of the run; S <- the
 * directions. */
static int em_variation_act(em_pass *p, size_t stop, int *fired, const double *before, const double *dt, double margin) {
    em_variations *const w = p->of;
    const int n = p->n, k = p->columns;
    const double t = w->t[stop], near = fabs(margin), *const next = w->z + (stop + 1) * 2 * n;
    double P[w->n_forcing * k], after[2 * n], v[n], of_time_event[k], by_time_event[2 * n];
    const int time_events = em_time_event_at(p, stop, near, of_time_event, by_time_event);
    if (time_events < 0) return -1;
    if (time_events && !em_stay_simultaneous(p, of_time_event, dt))
        return em_end_pass(w, EM_TIME_EVENT_MEETS, em_first_fired(w, fired), -1);
    memcpy(v, p->z + n, sizeof v);
    for (int i = 0; i < w->n_forcing; ++i)
        for (int j = 0; j < k; ++j) P[i * k + j] = p->P[i * k + j] + p->P[i * k + k - 1] * dt[j];
    for (int i = 0; i < 2 * n; ++i)
        for (int j = 0; j < k; ++j) p->S[i * k + j] += before[i] * dt[j];
    if (w->model->act_along(t, p->z, p->z + n, p->c, p->u, w->least_norm, fired, p->pile, k, p->S, P, &w->fault))
        return -1;
    if (!em_is_same_state(n, p->z, next, v, fabs(margin) / EM_EVENT_MARGIN)) return em_end_pass(w, EM_OTHER_MOTION, -1, -1);
    memcpy(p->z, next, 2 * n * sizeof *next);
    const int time_events_then = em_time_event_at(p, stop, near, of_time_event, by_time_event);
    if (time_events_then < 0) return -1;
    if (time_events_then && !em_stay_simultaneous(p, of_time_event, dt))
        return em_end_pass(w, EM_TIME_EVENT_MEETS, em_first_fired(w, fired), -1);
    if (em_rate_on_side(p, t, margin, after)) return -1;
    for (int i = 0; i < 2 * n; ++i)
        for (int j = 0; j < k; ++j) p->S[i * k + j] -= after[i] * dt[j];
    return 0;
}

/* The events at a stop: the first of those that act, or of the others; the derivative of its time; and whether all
 * stay simultaneous. */
typedef struct em_simultaneous_events {
    int acting, event, apart;
    double *dt;
} em_simultaneous_events;

static void em_add_simultaneous(const em_pass *p, em_simultaneous_events *h, int event, const double *dt) {
    if (h->event >= 0 && !em_stay_simultaneous(p, h->dt, dt)) h->apart = event;
    if (h->event < 0) h->event = event, memcpy(h->dt, dt, p->columns * sizeof *dt);
    ++h->acting;
}

/* S <- after a jump of accelerations: at a time event, or at events that do not act. */
static int em_variation_jump(em_pass *p, size_t stop, const em_simultaneous_events *events, const double *before, double margin) {
    const int n = p->n, k = p->columns;
    const double t = p->of->t[stop], near = fabs(margin);
    double after[2 * n], of_time_event[k], by_time_event[2 * n], rest[2 * n];
    const int time_events = em_time_event_at(p, stop, near, of_time_event, by_time_event);
    if (time_events < 0 || em_rate_on_side(p, t, margin, after)) return -1;
    if (em_is_same_rate(n, before, after)) return 0;
    for (int i = 0; time_events && i < 2 * n; ++i) rest[i] = before[i] - by_time_event[i];
    const int alone = time_events && em_is_same_rate(n, rest, after), both = !alone && events->event >= 0;
    if (both && events->apart >= 0) return em_end_pass(p->of, EM_JUMPS_MEET, events->event, events->apart);
    if (both && time_events && !em_stay_simultaneous(p, of_time_event, events->dt))
        return em_end_pass(p->of, EM_TIME_EVENT_MEETS, events->event, -1);
    if (!time_events && !both) return 0;
    const double *const dt = time_events ? of_time_event : events->dt;
    for (int column = 0; column + 1 < k; ++column)
        for (int i = n; i < 2 * n; ++i) p->S[i * k + column] += (before[i] - after[i]) * dt[column];
    return 0;
}

/* z, S <- after a change of rotation parameters at a stop, as in the next stop. That is a map of coordinates: its time
 * has no effect. */
static int em_variation_change_chart(em_pass *p, size_t stop) {
    em_variations *const w = p->of;
    if (em_keep_at_stop(p, stop)) return -1;
    em_shadow_along(w->model, p->z, p->z + p->n, p->columns, p->S);
    memcpy(p->z, w->z + (stop + 1) * 2 * p->n, 2 * p->n * sizeof *p->z);
    return 0;
}

/* Processes the marks from `mark` on that are at a stop: dt, directions and, if some act, z and the mode of the next
 * stop. Returns the number of changes of the state, or -1. */
static int em_pass_marks(em_pass *p, size_t stop, size_t *mark, double margin) {
    em_variations *const w = p->of;
    const int k = p->columns;
    const double t = w->t[stop];
    double dt[k], of_act[k], of_pass[k], before[2 * p->n];
    int changes = 0, fired[w->model->n_events + 1];
    em_simultaneous_events act = {0, -1, -1, of_act}, pass = {0, -1, -1, of_pass};
    memset(fired, 0, sizeof fired);
    em_pass_side(p, t, fabs(margin), 0);
    if (em_rate_on_side(p, t, -margin, before)) return -1;
    em_set_last(p, before);
    for (; *mark < w->n_marks && w->mark_stop[*mark] == (long)stop; ++*mark) {
        const int event = w->mark_event[*mark];
        if (event == EM_CHART_CHANGE && ++changes) continue;
        const int acts = w->model->event_actions && w->model->event_actions[event].acts;
        em_event_shift(p, t, event, before, dt);
        if (em_correct_cone_shift(p, t, event, before, dt)) return -1;
        if (!p->records_for) memcpy(w->dt + *mark * w->columns, dt, w->columns * sizeof *dt);
        for (int j = 0; acts && j < k; ++j)
            if (!isfinite(dt[j])) return em_end_pass(w, EM_EVENT_GRAZES, event, -1);
        if (acts) em_add_simultaneous(p, &act, event, dt), fired[event] = 1;
        else if (isfinite(dt[k - 1])) em_add_simultaneous(p, &pass, event, dt);
    }
    if (act.apart >= 0) return em_end_pass(w, EM_EVENTS_MEET, act.event, act.apart);
    if (act.acting) return em_variation_act(p, stop, fired, before, of_act, margin) ? -1 : act.acting;
    if (stop + 1 < w->n_stops && em_variation_jump(p, stop, &pass, before, margin)) return -1;
    if (changes && em_variation_change_chart(p, stop)) return -1;
    return changes;
}

/* The same, stored on the tape of the pass. */
static int em_variation_marks(em_pass *p, size_t stop, size_t *mark, double margin) {
    if (p->tape) {
        size_t first = *mark;
        em_begin_matrix(p);
        if (em_end_matrix(p, em_pass_marks(p->over_basis, stop, &first, margin) < 0 ? -1 : 0)) return -1;
    }
    return em_pass_marks(p, stop, mark, margin);
}

#endif
