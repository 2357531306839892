/* em_events.h: zero crossings g_i = 0 of the trajectory, located to rounding.
 *
 * An event fires when g_i changes sign, or reaches zero, between two accepted states. Directions are those of the run:
 * 1 fires where g_i grows on the way from t_start to t_end. A g_i that is zero at the start of a step has fired already
 * or is not to fire. Two crossings within one step cancel; max_step bounds what can be missed.
 */
#ifndef EM_EVENTS_H
#define EM_EVENTS_H

#include "em_dense.h"

typedef struct em_crossing {
    double t;
    int event;
} em_crossing;

static int em_crosses(int direction, double before, double after) {
    const int up = before < 0.0 && after >= 0.0, down = before > 0.0 && after <= 0.0;
    return (up && direction >= 0) || (down && direction <= 0);
}

/* g (n_events) at a state whose velocities are known. */
static void em_events_at(em_walk *w, double t, const double *y, const double *v, double *g) {
    em_signals(w, t);
    model_events(t, y, v, w->run->prepared, w->u, g);
}

/* How many events the step under way crosses. */
static int em_count_crossings(const em_walk *w) {
    int count = 0;
    for (int i = 0; i < N_EVENTS; ++i) count += em_crosses(w->run->event_direction[i], w->g[i], w->g_new[i]);
    return count;
}

/* g (n_events) at t inside the step. 0, or -1 and w->reason. */
static int em_events_inside(em_walk *w, double t, double *g) {
    double *y = w->argument, v[N], memory[EM_SOME_MEMORY];
    if (em_inside(w, t, y, memory)) return -1;
    if (model_velocity(w->mode, t, y, w->run->prepared, v, &w->reason)) return -1;
    em_events_at(w, t, y, v, g);
    return 0;
}

/* A bracket of a root: the newest point a, its counterpart b across the root, and the point c before them. */
typedef struct em_bracket {
    double a, fa, b, fb, c, fc;
} em_bracket;

/* Where to look next, as a fraction of the way from a to b: inverse quadratic interpolation where it is safe, the
 * middle elsewhere (Chandrupatla, Adv. Eng. Software 28 (1997) 145). Never closer to an end than `margin`. */
static double em_bracket_fraction(const em_bracket *r, double margin) {
    const double xi = (r->a - r->b) / (r->c - r->b), phi = (r->fa - r->fb) / (r->fc - r->fb);
    double fraction = 0.5;
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)
        fraction = r->fa / (r->fb - r->fa) * r->fc / (r->fb - r->fc) +
                   (r->c - r->a) / (r->b - r->a) * r->fa / (r->fc - r->fa) * r->fb / (r->fc - r->fb);
    return em_min(1.0 - margin, em_max(margin, fraction));
}

static void em_bracket_add(em_bracket *r, double t, double f) {
    if ((f > 0.0) == (r->fa > 0.0)) {
        r->c = r->a, r->fc = r->fa;
    } else {
        r->c = r->b, r->fc = r->fb;
        r->b = r->a, r->fb = r->fa;
    }
    r->a = t, r->fa = f;
}

/* *root <- where g_i = 0 within the step, given its signs at both ends. 0, or -1 and w->reason. */
static int em_locate(em_walk *w, int i, double *root) {
    enum { ENOUGH = 200 }; /* bisection alone needs 60 */
    em_bracket r = {w->t_new, w->g_new[i], w->t, w->g[i], w->t, w->g[i]};
    double g[EM_SOME_EVENTS], fraction = 0.5;
    for (int n = 0; n < ENOUGH; ++n) {
        const int a_is_best = fabs(r.fa) < fabs(r.fb);
        *root = a_is_best ? r.a : r.b;
        const double spacing = 2.0 * DBL_EPSILON * em_max(fabs(*root), DBL_EPSILON * fabs(w->h));
        const double margin = spacing / fabs(r.b - r.a);
        if (!(margin < 0.5) || (a_is_best ? r.fa : r.fb) == 0.0) break;
        fraction = n == 0 ? 0.5 : em_bracket_fraction(&r, margin);
        const double t = r.a + fraction * (r.b - r.a);
        if (em_events_inside(w, t, g)) return -1;
        em_bracket_add(&r, t, g[i]);
    }
    return 0;
}

/* Insert in the order of the run. */
static void em_crossing_insert(em_crossing *list, int count, em_crossing crossing, double direction) {
    for (; count > 0 && direction * (list[count - 1].t - crossing.t) > 0.0; --count) list[count] = list[count - 1];
    list[count] = crossing;
}

/* list (n_events) <- the crossings of this step in the order of the run. Their number, or -1 and w->reason. */
static int em_locate_crossings(em_walk *w, em_crossing *list) {
    int count = 0;
    for (int i = 0; i < N_EVENTS; ++i) {
        em_crossing crossing = {w->t_new, i};
        if (!em_crosses(w->run->event_direction[i], w->g[i], w->g_new[i])) continue;
        if (em_locate(w, i, &crossing.t)) return -1;
        em_crossing_insert(list, count++, crossing, w->direction);
    }
    return count;
}

#endif
