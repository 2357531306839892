/* em_variation_events.h: what becomes of directions at events.
 *
 * The time of an event changes by dt = -dg / gdot. What happens there is then that much later, and the motion after it, too:
 *
 *     dz+ = D (dz- + f- dt) - f+ dt
 *
 * at fixed time, f the rates (v, a) before and after, D the derivative of what the events that act do to z (one where none
 * does), by the state, what is given and the time (em_saltation.h). */
#ifndef EM_VARIATION_EVENTS_H
#define EM_VARIATION_EVENTS_H

#include "em_variation_steps.h"

#define EM_BESIDE 1e-9 /* of the length of a step: how far beside an event both sides are looked at */
#define EM_SAME_RATE 1e-6 /* relative: rates on one side of a jump, at it and beside it */
#define EM_SAME_STATE 1e-8 /* relative: what events made of a state in the run, and in the pass */

/* Whether rates (v, a) are the same but for how they change beside an event. */
static int em_is_same_rate(int n, const double *a, const double *b) {
    double apart = 0.0, size = 0.0;
    for (int i = n; i < 2 * n; ++i) {
        apart = fmax(apart, fabs(a[i] - b[i]));
        size = fmax(size, fmax(fabs(a[i]), fabs(b[i])));
    }
    return apart <= EM_SAME_RATE * size;
}

/* rate (2 n) <- (v, a) at y, or, where that is on the other side of a jump, beside it. */
static int em_rate_on_side(em_pass *p, double t, double ahead, double *rate) {
    const int n = p->n;
    double *const there = p->next, *const near = p->K[3];
    if (em_variation_rate(p, t, p->y, p->K[0])) return -1;
    memcpy(rate, p->K[0], 2 * n * sizeof *rate);
    memcpy(there, p->y, p->size * sizeof *there);
    for (int i = 0; i < 2 * n; ++i) there[i] += ahead * p->K[0][i];
    if (em_variation_rate(p, t + ahead, there, near)) return -1;
    if (!em_is_same_rate(n, rate, near)) memcpy(rate, near, 2 * n * sizeof *rate);
    return 0;
}

/* dt (columns) <- how the time of an event changes; the witness's is -1. */
static void em_event_shift(em_pass *p, double t, int event, const double *rate, double *dt) {
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments;
    double G[width * p->of->model->n_events], gdot = 0.0;
    p->of->model->event_partials(t, p->y, p->y + n, p->c, p->u, G);
    const double *const g = G + event * width;
    for (int i = 0; i < 2 * n; ++i) gdot += g[i] * rate[i];
    for (int i = 0; i < p->of->n_given; ++i) gdot += g[2 * n + i] * p->P[i * k + k - 1];
    for (int column = 0; column < k; ++column) {
        double change = 0.0;
        for (int i = 0; i < 2 * n; ++i) change += g[i] * p->y[2 * n + i * k + column];
        for (int i = 0; i < p->of->n_given; ++i) change += g[2 * n + i] * p->P[i * k + column];
        dt[column] = -change / gdot;
    }
}

/* Where accelerations jump, directions do. */
static int em_variation_jump(em_pass *p, double t, const double *before, const double *dt, double beside) {
    const int n = p->n, k = p->columns;
    double *const after = p->K[2];
    if (em_rate_on_side(p, t, beside, after)) return -1;
    if (em_is_same_rate(n, before, after)) return 0;
    for (int column = 0; column + 1 < k; ++column)
        for (int i = n; i < 2 * n; ++i) p->y[2 * n + i * k + column] += (before[i] - after[i]) * dt[column];
    return 0;
}

/* Whether two events that act happen together however what is given changes, relative to the larger change. */
static int em_go_together(const em_pass *p, const double *one, const double *other) {
    for (int column = 0; column + 1 < p->columns; ++column)
        if (!(fabs(one[column] - other[column]) <= 1e-6 * fmax(fabs(one[column]), fabs(other[column])) + DBL_MIN)) return 0;
    return 1;
}

/* Whether the run says z, too, where velocities v, and lengths of time, say how large x and v are. */
static int em_is_same_state(int n, const double *y, const double *z, const double *v, double length) {
    double apart[2] = {0.0, 0.0}, size[2] = {0.0, 0.0};
    for (int i = 0; i < n; ++i) {
        apart[0] = fmax(apart[0], fabs(y[i] - z[i])), size[0] = fmax(size[0], fmax(fabs(z[i]), length * fabs(v[i])));
        apart[1] = fmax(apart[1], fabs(y[n + i] - z[n + i])), size[1] = fmax(size[1], fmax(fabs(z[n + i]), fabs(v[i])));
    }
    return apart[0] <= EM_SAME_STATE * size[0] && apart[1] <= EM_SAME_STATE * size[1];
}

/* At t events act: y and the mode after them, which the run says is z, and the directions. */
static int em_variation_act(em_pass *p, double t, int *fired, const double *before, const double *dt, const double *z,
                            double beside) {
    em_variations *const w = p->of;
    const int n = p->n, k = p->columns;
    double P[w->n_given * k], *const after = p->K[2], v[n];
    memcpy(v, p->y + n, sizeof v);
    for (int i = 0; i < w->n_given; ++i)
        for (int j = 0; j < k; ++j) P[i * k + j] = p->P[i * k + j] + p->P[i * k + k - 1] * dt[j];
    for (int i = 0; i < 2 * n; ++i)
        for (int j = 0; j < k; ++j) p->y[2 * n + i * k + j] += before[i] * dt[j];
    if (w->model->act_along(t, p->y, p->y + n, p->c, p->u, w->least_norm, fired, p->pile, k, p->y + 2 * n, P, &w->fault))
        return -1;
    if (!em_is_same_state(n, p->y, z, v, fabs(beside) / EM_BESIDE)) return em_end_pass(w, EM_OTHER_MOTION, -1, -1);
    memcpy(p->y, z, 2 * n * sizeof *z);
    if (em_rate_on_side(p, t, beside, after)) return -1;
    for (int i = 0; i < 2 * n; ++i)
        for (int j = 0; j < k; ++j) p->y[2 * n + i * k + j] -= after[i] * dt[j];
    return 0;
}

/* The marks from `mark` on that are at `row`: dt, directions and, where some act, y and the mode of the next row. Returns
 * how many events act, or -1. */
static int em_variation_marks(em_pass *p, size_t row, size_t *mark, double beside) {
    em_variations *const w = p->of;
    const int k = p->columns, n_events = w->model->n_events;
    const double t = w->t[row], *const z = w->z + row * 2 * p->n;
    double dt[k], of_act[k], *const before = p->K[1];
    int fired[n_events + 1], acting = 0, first = -1;
    memset(fired, 0, sizeof fired);
    if (em_rate_on_side(p, t, -beside, before)) return -1;
    for (; *mark < w->n_marks && w->mark_row[*mark] == (long)row; ++*mark) {
        const int event = w->mark_event[*mark];
        em_event_shift(p, t, event, before, dt);
        memcpy(w->dt + *mark * (k - 1), dt, (k - 1) * sizeof *dt);
        if (w->model->deeds && w->model->deeds[event].acts) {
            if (acting && !em_go_together(p, of_act, dt)) return em_end_pass(w, EM_EVENTS_MEET, first, event);
            for (int j = 0; j < k; ++j)
                if (!isfinite(dt[j])) return em_end_pass(w, EM_EVENT_GRAZES, event, -1);
            memcpy(of_act, dt, sizeof dt);
            first = event, fired[event] = 1, ++acting;
        } else if (!acting && isfinite(dt[k - 1]) && em_variation_jump(p, t, before, dt, beside)) {
            return -1;
        }
    }
    p->renew = 1;
    if (acting && em_variation_act(p, t, fired, before, of_act, z + 2 * p->n, beside)) return -1;
    return acting;
}

#endif
