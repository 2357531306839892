/* em_root_isolation.h: root isolation: intervals of a step in which g_i changes its sign, where screening cannot
 * exclude one. */
#ifndef EM_ROOT_ISOLATION_H
#define EM_ROOT_ISOLATION_H

#include "events/em_event_screening.h"

#define EM_PROBE 0.38196601125010515 /* in (0, 1), not a ratio of small integers, so that a function periodic in the
                                        nodes shows there */

/* g at points of a step, in the order of the run: at its start, at `near` points close to that, at the other nodes;
 * and at one more point, EM_PROBE, which is no node. */
typedef struct em_isolation {
    int count, near;
    double t[EM_POINTS];
    int n_events;
    double *g, *probe; /* (EM_POINTS, n_events), (n_events) */
} em_isolation;

/* The Chebyshev nodes, in [0, 1]. */
static double em_node(int j) { return 0.5 - 0.5 * em_eighth(j); }

/* Appends t and g(t) to the points. */
static int em_evaluate_at(em_run_state *w, em_isolation *s, double t) {
    s->t[s->count] = t;
    return em_events_inside(w, t, s->g + s->count++ * w->n_events);
}

/* The position in the step of the first point at which no g_i that was zero at the start is still zero, in powers
 * 4^-n. */
static int em_quarters(em_run_state *w, int *quarters) {
    double g[em_some(w->n_events)];
    for (*quarters = 1; *quarters < EM_QUARTERS; ++*quarters) {
        int left = 0;
        if (em_events_inside(w, w->t + ldexp(w->h, -2 * *quarters), g)) return -1;
        for (int i = 0; i < w->n_events; ++i) left |= w->side[i] == 0 && em_side_of(g[i], w->quiet[i]);
        if (!left) break;
    }
    return 0;
}

/* Evaluates g at the nodes and, if some g_i was zero at the start of the step, ever closer to the start. 0, or -1
 * and w->reason. */
static int em_isolate_roots(em_run_state *w, em_isolation *s) {
    int zero = 0, quarters = 0;
    for (int i = 0; i < w->n_events; ++i) zero |= w->side[i] == 0;
    if (zero && em_quarters(w, &quarters)) return -1;
    s->count = 0;
    if (em_evaluate_at(w, s, w->t)) return -1;
    for (; quarters > 2; --quarters)
        if (em_evaluate_at(w, s, w->t + ldexp(w->h, -2 * quarters))) return -1;
    s->near = s->count - 1;
    for (int j = 1; j < EM_NODES - 1; ++j)
        if (em_evaluate_at(w, s, w->t + em_node(j) * w->h)) return -1;
    return em_evaluate_at(w, s, w->t_new) || em_events_inside(w, w->t + EM_PROBE * w->h, s->probe) ? -1 : 0;
}

static double em_at_node(const em_isolation *s, int j, int i) { return s->g[(j > 0 ? j + s->near : 0) * s->n_events + i]; }

/* a (9): the Chebyshev coefficients, in 1 - 2 theta, of the polynomial through g_i at the nodes. */
static void em_polynomial(const em_isolation *s, int i, double *a) {
    for (int k = 0; k < EM_NODES; ++k) {
        double sum = 0.0;
        for (int j = 0; j < EM_NODES; ++j)
            sum += (j % (EM_NODES - 1) ? 1.0 : 0.5) * em_at_node(s, j, i) * em_eighth(j * k);
        a[k] = (k % (EM_NODES - 1) ? 0.25 : 0.125) * sum;
    }
}

/* Clenshaw's sum. */
static double em_polynomial_at(const double *a, double theta) {
    const double z = 1.0 - 2.0 * theta;
    double b = 0.0, before = 0.0;
    for (int k = EM_NODES - 1; k > 0; --k) {
        const double next = a[k] + 2.0 * z * b - before;
        before = b, b = next;
    }
    return a[0] + z * b - before;
}

/* Whether nine nodes do not represent g_i: its coefficients, `size` the sum of their magnitudes, do not decay, or the
 * polynomial differs from g_i at the probe. A shorter step may represent g_i, unless it jumps: a step that is short
 * relative to others is accepted. So is a g_i that is all rounding. */
static int em_is_unresolved(const em_run_state *w, int i, const double *a, double size, double probe) {
    enum { RETRIES = 5 };
    const double brief = 1e-3, wild = 0.02; /* of the longest step; of `size` */
    const double tail = fabs(a[EM_NODES - 3]) + fabs(a[EM_NODES - 2]) + fabs(a[EM_NODES - 1]);
    const double off = fabs(em_polynomial_at(a, EM_PROBE) - probe);
    if (size <= w->noise[i]) return 0;
    return w->retries < RETRIES && fabs(w->h) > brief * w->longest_step && em_max(tail, off) > wild * size;
}

/* The interval between two points, divided into equal parts. */
typedef struct em_subinterval {
    double left, right, part; /* in theta */
    int next;                 /* index of the next part */
} em_subinterval;

enum { EM_SUBINTERVALS = 8 };

static em_subinterval em_subinterval_to(const em_run_state *w, const em_isolation *s, int k) {
    const double left = (s->t[k - 1] - w->t) / w->h, right = (s->t[k] - w->t) / w->h;
    return (em_subinterval){left, right, (right - left) / EM_SUBINTERVALS, 0};
}

/* *theta <- the next local minimum of the polynomial, times `side`, on the interval; *low <- its value. Returns
 * whether there is one: a minimum close to an end of the interval may lie on either side of it. */
static int em_next_minimum(const double *a, em_subinterval *way, double side, double *theta, double *low) {
    double before = side * em_polynomial_at(a, way->left + (way->next - 1) * way->part);
    double here = side * em_polynomial_at(a, way->left + way->next * way->part);
    while (way->next <= EM_SUBINTERVALS) {
        const double at = way->left + way->next * way->part, after = side * em_polynomial_at(a, at + way->part);
        ++way->next;
        if (here < before && here <= after) return *low = here, *theta = at, 1;
        before = here, here = after;
    }
    return 0;
}

/* Whether g_i has the other sign near a minimum *theta, which then becomes such a point: by parabolas through ever
 * closer points, at first `apart` from each other. 1, 0, or -1 and w->reason. */
static int em_crosses_at_minimum(em_run_state *w, int i, double side, double apart, double *theta, double *value) {
    double f[3], g[em_some(w->n_events)];
    for (int n = 0; n < 8; ++n) {
        *theta = em_min(1.0 - apart, em_max(apart, *theta));
        for (int place = 0; place < 3; ++place) {
            const double at = *theta + (place - 1) * apart;
            if (em_events_inside(w, w->t + at * w->h, g)) return -1;
            f[place] = side * g[i];
            if (f[place] < 0.0) return *theta = at, *value = g[i], 1;
        }
        const double slope = 0.5 * (f[2] - f[0]), bend = f[0] - 2.0 * f[1] + f[2];
        if (!(bend > 0.0)) return 0;
        if (f[1] - 0.5 * slope * slope / bend > 0.1 * bend && fabs(slope) < bend) return 0;
        *theta += apart * em_min(1.0, em_max(-1.0, -slope / bend));
        if (fabs(slope) <= bend) apart /= 8.0; /* else the minimum lies further away, and the step length stays */
    }
    return 0;
}

static int em_fires(int direction, int before) { return direction == 0 || direction == -before; }

/* Whether g_i, zero so far, has entered the forbidden side: then it fires where it left zero. */
static int em_enters(const em_run_state *w, int i, double g) {
    return w->side_new[i] == 0 && em_keeps_apart(w, i) && em_side_of(g, 0.0) == w->run->event_direction[i];
}

/* Whether the first step of a segment enters the contact that it left, by more than rounding: a gap that opens as
 * slowly as t^3 needs a shorter step. */
static int em_first_step_too_long(const em_run_state *w, int i, double g) {
    enum { RETRIES = 10 };
    return w->new_segment == EM_NEXT_SEGMENT && em_is_contact_event(w, i) && w->retries < RETRIES && em_enters(w, i, g) &&
           em_side_of(g, w->quiet[i]) != 0;
}

/* Compares two successive signs: if they differ, g_i has passed zero between `before` and `after`. */
static void em_check_sign_change(em_run_state *w, int i, const em_point *before, const em_point *after) {
    const int sign = em_side_of(after->g, w->side_new[i] == 0 ? w->quiet[i] : 0.0);
    if (sign == 0) return;
    if (em_enters(w, i, after->g)) {
        const em_point *const end = before->g * after->g < 0.0 ? after : before;
        w->found[w->n_found++] = (em_found){*before, *end, i};
    }
    if (sign == -w->side_new[i] && em_fires(w->run->event_direction[i], w->side_new[i]))
        w->found[w->n_found++] = (em_found){*before, *after, i};
    w->side_new[i] = sign;
}

/* Finds the crossings of event i in the interval that ends at point k and whose ends do not show them: it examines each
 * minimum of the polynomial towards zero, from the side on which g_i then is, in order. *before <- the last point
 * evaluated. 0, or -1 and w->reason. */
static int em_search_subinterval(em_run_state *w, const em_isolation *s, int i, int k, const double *a, double size,
                                 em_point *before) {
    const double coarse = 1.0 / 128.0, close = 0.05; /* of the step; of `size` */
    em_subinterval way = em_subinterval_to(w, s, k);
    double theta = 0.0, low;
    while (w->side_new[i] != 0 && em_next_minimum(a, &way, w->side_new[i], &theta, &low)) {
        em_point minimum;
        if (!(low < close * size)) continue;
        const int crosses = em_crosses_at_minimum(w, i, w->side_new[i], em_min(coarse, 0.5 * way.part), &theta, &minimum.g);
        if (crosses < 0) return -1;
        minimum.t = w->t + theta * w->h;
        if (!crosses || !(theta > way.left && theta < way.right && (minimum.t - before->t) * w->direction > 0.0)) continue;
        em_check_sign_change(w, i, before, &minimum);
        *before = minimum;
    }
    return 0;
}

/* The crossings of event i by the signs at the points evaluated and at the minima between them, which are those of
 * the polynomial through nine nodes; the polynomial represents g_i wherever g_i is smooth within a step. 0, or -1
 * and w->reason. */
static int em_search(em_run_state *w, const em_isolation *s, int i) {
    double a[EM_NODES], size = 0.0;
    em_polynomial(s, i, a);
    for (int k = 0; k < EM_NODES; ++k) size += fabs(a[k]);
    if (em_is_unresolved(w, i, a, size, s->probe[i])) return em_fail(&w->reason, EM_STEP_SIZE_UNDERFLOW, -1, -1, w->h);
    em_point before = {w->t, w->g[i]};
    em_check_sign_change(w, i, &before, &before);
    for (int k = 0; k < s->count; ++k) {
        const em_point here = {s->t[k], s->g[k * s->n_events + i]};
        if (k > 0 && em_search_subinterval(w, s, i, k, a, size, &before)) return -1;
        if (em_first_step_too_long(w, i, here.g)) return em_fail(&w->reason, EM_STEP_SIZE_UNDERFLOW, -1, -1, w->h);
        em_check_sign_change(w, i, &before, &here);
        if (here.g != 0.0 && !em_enters(w, i, here.g)) before = here;
    }
    return 0;
}

/* g (n_events) at the very end of the run: before a time event the model is evaluated slightly earlier. */
static void em_events_at_end(em_run_state *w, double *g) {
    em_copy_events(w, g, w->g_new);
    if (w->t_new == w->run->t_end && em_clock(w, w->t_new) != w->t_new && em_events_in_mode(w, w->t_new, w->y_new, w->f_new, g))
        em_copy_events(w, g, w->g_new);
}

/* At the end of the run, where g_i is g: a g_i that is zero has reached zero there, unless it was zero before; one
 * of the other sign has jumped there. */
static void em_event_at_run_end(em_run_state *w, const em_isolation *s, int i, double g) {
    const em_point end = {w->t_new, g};
    const int sign = em_side_of(g, 0.0);
    if (w->t_new != w->run->t_end || sign == w->side_new[i] || w->side[i] == 0) return;
    if (sign == 0 && s->g[(s->count - 2) * s->n_events + i] == 0.0) return;
    if (em_fires(w->run->event_direction[i], w->side_new[i])) w->found[w->n_found++] = (em_found){end, end, i};
}

#endif
