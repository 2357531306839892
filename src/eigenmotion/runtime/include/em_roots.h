/* em_roots.h: a zero of g_i located to rounding, on the settled trajectory. */
#ifndef EM_ROOTS_H
#define EM_ROOTS_H

#include "em_events.h"

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

/* *root <- where g_i = 0 between the points found. 0, or -1 and w->reason. */
static int em_locate(em_walk *w, const em_found *found, double *root) {
    enum { ENOUGH = 200 }; /* bisection alone needs 60 */
    const em_point *end = &found->after, *start = &found->before;
    em_bracket r = {end->t, end->g, start->t, start->g, start->t, start->g};
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
        em_bracket_add(&r, t, g[found->event]);
    }
    return 0;
}

#endif
