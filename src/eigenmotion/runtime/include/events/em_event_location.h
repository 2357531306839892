/* em_event_location.h: event location: a zero of g_i to rounding, on the projected trajectory. */
#ifndef EM_EVENT_LOCATION_H
#define EM_EVENT_LOCATION_H

#include "events/em_event_functions.h"

/* A bracket of a root: the newest point a, its counterpart b across the root, and the point c before them. */
typedef struct em_bracket {
    double a, fa, b, fb, c, fc;
} em_bracket;

/* The next point to evaluate, as a fraction of the way from a to b: inverse quadratic interpolation where it is
 * safe, bisection elsewhere (Chandrupatla, Adv. Eng. Software 28 (1997) 145). Never closer to an end than `margin`. */
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

static double em_spacing_at(const em_run_state *w, double t) {
    return 2.0 * DBL_EPSILON * em_max(fabs(t), DBL_EPSILON * fabs(w->h));
}

/* *g <- g_i at t. If it is 0 there and beyond t, it has not passed zero yet: *g <- a tiny number of the sign that it
 * had before. 1: t is the root; 0; or -1 and w->reason. */
static int em_at_root(em_run_state *w, const em_found *found, double t, double *g) {
    double here[em_some(w->n_events)], beyond[em_some(w->n_events)];
    const double later = t + w->direction * em_spacing_at(w, t);
    if (em_events_inside(w, t, here)) return -1;
    *g = here[found->event];
    if (*g != 0.0 || found->after.g == 0.0) return *g == 0.0;
    if (w->direction * (found->after.t - later) <= 0.0) return 1;
    if (em_events_inside(w, later, beyond)) return -1;
    *g = copysign(DBL_MIN, -found->after.g);
    return em_side_of(beyond[found->event], 0.0) == em_side_of(found->after.g, 0.0);
}

/* *root <- the zero of g_i between the points found; of an interval of zeros, its end. 0, or -1 and w->reason. */
static int em_locate(em_run_state *w, const em_found *found, double *root) {
    enum { ENOUGH = 200 }; /* bisection alone needs 60 steps */
    const em_point *end = &found->after, *start = &found->before;
    em_bracket r = {end->t, end->g, start->t, start->g, start->t, start->g};
    double fraction = 0.5, g = 0.0;
    int is_root = 0;
    if (start->g == 0.0 && start->t != end->t) is_root = em_at_root(w, found, *root = start->t, &r.fb), r.fc = r.fb;
    for (int n = 0; n < ENOUGH && is_root == 0; ++n) {
        *root = fabs(r.fa) < fabs(r.fb) ? r.a : r.b;
        const double margin = em_spacing_at(w, *root) / fabs(r.b - r.a);
        if (!(margin < 0.5)) break;
        fraction = n == 0 ? 0.5 : em_bracket_fraction(&r, margin);
        const double t = r.a + fraction * (r.b - r.a);
        is_root = em_at_root(w, found, t, &g);
        if (is_root) *root = t;
        em_bracket_add(&r, t, g);
    }
    return is_root < 0 ? -1 : 0;
}

#endif
