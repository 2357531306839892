/* em_events.h: where the trajectory's g_i change sign.
 *
 * An event fires where g_i goes over from one sign to the other, or reaches zero at t_end. Directions are those of the
 * run: 1 fires where g_i grows on the way from t_start to t_end. A g_i that is zero at the start, to rounding, takes its
 * sign from what follows: it does not fire as it leaves zero, and does when it comes back. One that touches zero and
 * turns back keeps its sign. What the step's interpolant shows is not missed: see em_search.
 */
#ifndef EM_EVENTS_H
#define EM_EVENTS_H

#include "em_dense.h"

#define EM_PROBE 0.38196601125010515 /* by no fraction of small numbers: what repeats itself from node to node shows there */
#define EM_SLACK 0.25 /* how far from zero, beside how much it varies, g is far enough by a glance */

/* g at places of a step, in the order of the run: at its start, `near` places close to that, the other nodes; and at one
 * more, EM_PROBE, where no node is. */
typedef struct em_survey {
    int count, near;
    double t[EM_PLACES], g[EM_PLACES][EM_SOME_EVENTS], probe[EM_SOME_EVENTS];
} em_survey;

static int em_side_of(double g, double noise) { return (g > noise) - (g < -noise); }

/* g (n_events) at a state whose velocities are known. 0, or -1 and w->reason: an event has no value there. */
static int em_events_at(em_walk *w, double t, const double *y, const double *v, double *g) {
    em_signals(w, t);
    model_events(t, y, v, w->run->prepared, w->u, g);
    for (int i = 0; i < N_EVENTS; ++i)
        if (isnan(g[i])) return em_fail(&w->reason, EM_EVENT_UNDEFINED, i, -1, NAN);
    return 0;
}

/* The same at a state of the step under way. */
static int em_events_of(em_walk *w, double t, const double *y, double *g) {
    double v[N];
    if (model_velocity(w->mode, t, y, w->run->prepared, v, &w->reason)) return -1;
    return em_events_at(w, t, y, v, g);
}

/* g (n_events) at t inside the step, on the settled trajectory. 0, or -1 and w->reason. */
static int em_events_inside(em_walk *w, double t, double *g) {
    double memory[EM_SOME_MEMORY];
    if (t == w->t || t == w->t_new) {
        memcpy(g, t == w->t ? w->g : w->g_new, sizeof w->g);
        return 0;
    }
    return em_inside(w, t, w->argument, memory) ? -1 : em_events_of(w, t, w->argument, g);
}

/* --- the start of a run --- */

#define EM_LAST_PLACES (256.0 * DBL_EPSILON)
#define EM_OF_TOLERANCE 1e-3

/* What g changes by from one to the other adds to what is zero at the start, and `part` of it to noise. */
static void em_add_noise(em_walk *w, const double *g, double part) {
    for (int i = 0; i < N_EVENTS; ++i) {
        const double change = fabs(g[i] - w->g[i]);
        w->zero[i] += change;
        w->noise[i] += part * change;
    }
}

/* noise[i] <- what g_i changes by when the time, and one of x and v after the other, change in their last places;
 * zero[i] <- the same with a part of their tolerances. Where g has no value that way nothing is added. */
static void em_events_noise(em_walk *w) {
    const double later = EM_LAST_PLACES * fabs(w->t);
    double z[2 * N], g[EM_SOME_EVENTS];
    for (int k = 0; k < EM_WIDTH; ++k) w->argument[k] = w->y[k] + w->direction * later * w->K[0][k];
    if (!em_events_of(w, w->t + w->direction * later, w->argument, g)) em_add_noise(w, g, 1.0);
    for (int k = 0; k < N; ++k) z[k] = w->y[k], z[N + k] = w->K[0][k];
    for (int k = 0; k < 2 * N; ++k) {
        const double kept = z[k], last = EM_LAST_PLACES * fabs(kept), more = last + EM_OF_TOLERANCE / w->weight[k];
        z[k] += more;
        if (more > 0.0 && !em_events_at(w, w->t, z, z + N, g)) em_add_noise(w, g, last / more);
        z[k] = kept;
    }
}

/* g and its noise at the start. 0, or -1 and w->reason. */
static int em_begin_events(em_walk *w) {
    if (em_events_at(w, w->t, w->y, w->K[0], w->g)) return -1;
    em_events_noise(w);
    return 0;
}

/* --- a glance at every step --- */

/* Few states of a step before its interpolant is built, from what is there already: with the rate at the end, and one
 * within where the interpolant takes more stages than the step. Returns how many corrections, or -1: nothing is known. */
static int em_sketch(em_walk *w) {
    const em_tableau *rk = w->scheme->tableau;
    const int last_is_first = rk->solution < rk->stages, stage = rk->last_extra > 0 ? rk->stages - 2 : 0;
    if (!last_is_first && w->mode_new != w->mode) return -1;
    if (last_is_first) em_hermite(w, w->y_raw, w->K[rk->solution]);
    else em_hermite(w, w->y_new, w->f_new);
    if (stage == 0) return w->scheme->correct(w), rk->corrections;
    const double c = rk->c[stage], unit = 2.0 * c * (1.0 - c) * (1.0 - 2.0 * c);
    for (int k = 0; k < N_STATE; ++k) {
        const double rate = w->F[1][k] + (1.0 - 2.0 * c) * w->F[2][k] + c * (2.0 - 3.0 * c) * w->F[3][k];
        w->F[4][k] = (w->h * w->K[stage][k] - rate) / unit;
    }
    return 1;
}

/* g (EM_GLANCES, n_events) on that sketch. How many, or 0: nothing is known. */
static int em_glance(em_walk *w, double (*g)[EM_SOME_EVENTS]) {
    static const double at[EM_GLANCES] = {0.14644660940672624, 0.5, 0.85355339059327376};
    const int corrections = em_sketch(w);
    if (corrections < 0) return 0;
    for (int j = 0; j < EM_GLANCES; ++j) {
        em_evaluate(w->F[0], corrections, at[j], w->argument);
        if (em_events_of(w, w->t + at[j] * w->h, w->argument, g[j])) return 0;
    }
    return EM_GLANCES;
}

/* cos(pi j / 8) */
static double em_eighth(int j) {
    static const double quarter[] = {1.0, 0.92387953251128674, 0.70710678118654752, 0.38268343236508977, 0.0};
    j %= 16;
    if (j > 8) j = 16 - j;
    return j <= 4 ? quarter[j] : -quarter[8 - j];
}

/* Whether the glances say that g_i varies faster than they could show: with the ends they are Chebyshev's five nodes, and
 * its coefficients do not fall off. */
static int em_is_restless(const em_walk *w, double (*g)[EM_SOME_EVENTS], int i) {
    const double at[EM_GLANCES + 2] = {0.5 * w->g[i], g[0][i], g[1][i], g[2][i], 0.5 * w->g_new[i]};
    double size[EM_GLANCES + 2] = {0.0};
    for (int k = 1; k < EM_GLANCES + 2; ++k) {
        for (int j = 0; j < EM_GLANCES + 2; ++j) size[k] += at[j] * em_eighth(2 * j * k);
        size[k] = fabs(size[k]);
    }
    return size[3] + 0.5 * size[4] > 0.25 * (size[1] + size[2]);
}

/* Whether g_i may come to zero in this step: it changes sign, comes close to it beside how much it varies,
 * or varies too fast to say. */
static int em_may_cross(const em_walk *w, int count, double (*g)[EM_SOME_EVENTS], int i) {
    const double side = w->side[i], noise = w->quiet[i];
    double low = em_min(side * w->g[i], side * w->g_new[i]), high = em_max(side * w->g[i], side * w->g_new[i]);
    int leaves = em_side_of(w->g_new[i], noise) != 0;
    for (int j = 0; j < count; ++j) {
        low = em_min(low, side * g[j][i]);
        high = em_max(high, side * g[j][i]);
        leaves |= em_side_of(g[j][i], noise) != 0;
    }
    return w->side[i] == 0 ? leaves || count == 0 : count == 0 || !(low > EM_SLACK * (high - low)) || em_is_restless(w, g, i);
}

/* In the first step: which g_i are zero, to rounding beside what follows or a part of the tolerances, and beyond which
 * number they are so no longer. */
static void em_begin_sides(em_walk *w, int count, double (*g)[EM_SOME_EVENTS]) {
    for (int i = 0; i < N_EVENTS; ++i) {
        double size = fabs(w->g_new[i]);
        for (int j = 0; j < count; ++j) size = em_max(size, fabs(g[j][i]));
        const double rounding = w->noise[i] + (isfinite(size) ? EM_LAST_PLACES * size : 0.0);
        w->side[i] = em_side_of(w->g[i], em_max(rounding, w->zero[i]));
        w->quiet[i] = rounding + 4.0 * fabs(w->g[i]);
    }
}

/* --- a search where that is not enough --- */

/* The nodes of Chebyshev's polynomials, in [0, 1]. */
static double em_node(int j) { return 0.5 - 0.5 * em_eighth(j); }

static int em_look(em_walk *w, em_survey *s, double t) {
    s->t[s->count] = t;
    return em_events_inside(w, t, s->g[s->count++]);
}

/* How far in the step the first place is at which no g_i that was zero at the start is so still, in quarters: 4^-n. */
static int em_quarters(em_walk *w, int *quarters) {
    double g[EM_SOME_EVENTS];
    for (*quarters = 1; *quarters < EM_QUARTERS; ++*quarters) {
        int left = 0;
        if (em_events_inside(w, w->t + ldexp(w->h, -2 * *quarters), g)) return -1;
        for (int i = 0; i < N_EVENTS; ++i) left |= w->side[i] == 0 && em_side_of(g[i], w->quiet[i]);
        if (!left) break;
    }
    return 0;
}

/* g at the nodes and, where something was zero at the start of the step, ever closer to that. 0, or -1 and w->reason. */
static int em_survey_step(em_walk *w, em_survey *s) {
    int zero = 0, quarters = 0;
    for (int i = 0; i < N_EVENTS; ++i) zero |= w->side[i] == 0;
    if (zero && em_quarters(w, &quarters)) return -1;
    s->count = 0;
    if (em_look(w, s, w->t)) return -1;
    for (; quarters > 2; --quarters)
        if (em_look(w, s, w->t + ldexp(w->h, -2 * quarters))) return -1;
    s->near = s->count - 1;
    for (int j = 1; j < EM_NODES - 1; ++j)
        if (em_look(w, s, w->t + em_node(j) * w->h)) return -1;
    return em_look(w, s, w->t_new) || em_events_inside(w, w->t + EM_PROBE * w->h, s->probe) ? -1 : 0;
}

static double em_at_node(const em_survey *s, int j, int i) { return s->g[j > 0 ? j + s->near : 0][i]; }

/* a (9): the coefficients of the polynomial through g_i at the nodes, in Chebyshev's polynomials of 1 - 2 theta. */
static void em_polynomial(const em_survey *s, int i, double *a) {
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

/* Whether nine nodes tell nothing of g_i: its coefficients, `size` the sum of their sizes, do not fall off, or their
 * polynomial is not g_i elsewhere. A shorter step may tell more, but not of a jump: short beside others a step is good
 * enough. */
static int em_is_wild(const em_walk *w, const double *a, double size, double probe) {
    enum { RETRIES = 5 };
    const double tail = fabs(a[EM_NODES - 3]) + fabs(a[EM_NODES - 2]) + fabs(a[EM_NODES - 1]);
    const double off = fabs(em_polynomial_at(a, EM_PROBE) - probe);
    return w->retries < RETRIES && fabs(w->h) > 1e-3 * w->longest_step && em_max(tail, off) > 0.02 * size;
}

/* Between nodes j and j + 1, where g_i has the sign `side`: *theta <- where the polynomial is lowest, *low <- how low.
 * Whether that is lower than at both. */
static int em_lowest(const em_survey *s, int i, const double *a, int j, double side, double *theta, double *low) {
    enum { PARTS = 8 };
    const double left = em_node(j), width = em_node(j + 1) - left;
    const double ends = em_min(side * em_at_node(s, j, i), side * em_at_node(s, j + 1, i));
    *low = ends;
    for (int part = 1; part < PARTS; ++part) {
        const double at = left + width * part / PARTS, value = side * em_polynomial_at(a, at);
        if (value < *low) *low = value, *theta = at;
    }
    return *low < ends;
}

/* Whether g_i has the other sign near a lowest place *theta, which becomes one where it has, by parabolas through ever
 * closer places. 1, 0, or -1 and w->reason. */
static int em_dips(em_walk *w, int i, double side, double *theta, double *value) {
    double apart = 1.0 / 128.0, f[3], g[EM_SOME_EVENTS];
    for (int n = 0; n < 5; ++n, apart /= 8.0) {
        *theta = em_min(1.0 - apart, em_max(apart, *theta));
        for (int place = 0; place < 3; ++place) {
            const double at = *theta + (place - 1) * apart;
            if (em_events_inside(w, w->t + at * w->h, g)) return -1;
            f[place] = side * g[i];
            if (f[place] < 0.0) return *theta = at, *value = g[i], 1;
        }
        const double slope = 0.5 * (f[2] - f[0]), bend = f[0] - 2.0 * f[1] + f[2];
        if (!(bend > 0.0)) return 0;
        if (f[1] - 0.5 * slope * slope / bend > 0.3 * f[1] && fabs(slope) < bend) return 0;
        *theta += apart * em_min(1.0, em_max(-1.0, -slope / bend));
    }
    return 0;
}

static int em_fires(int direction, int before) { return direction == 0 || direction == -before; }

/* One sign after the other: where they differ g_i passed zero between `before` and `after`. */
static void em_pass(em_walk *w, int i, const em_point *before, const em_point *after) {
    const int sign = em_side_of(after->g, w->side_new[i] == 0 ? w->quiet[i] : 0.0);
    if (sign == 0) return;
    if (sign == -w->side_new[i] && em_fires(w->run->event_direction[i], w->side_new[i]))
        w->found[w->n_found++] = (em_found){*before, *after, i};
    w->side_new[i] = sign;
}

/* The crossings of event i by the signs at the places of the survey and in the dips between the nodes: of nine nodes
 * a polynomial is made, which is g_i wherever g_i is smooth within a step. 0, or -1 and w->reason. */
static int em_search(em_walk *w, const em_survey *s, int i) {
    double a[EM_NODES], size = 0.0, theta = 0.0, low;
    em_polynomial(s, i, a);
    for (int k = 0; k < EM_NODES; ++k) size += fabs(a[k]);
    if (em_is_wild(w, a, size, s->probe[i])) return em_fail(&w->reason, EM_STEP_SIZE_UNDERFLOW, -1, -1, w->h);
    em_point before = {w->t, w->g[i]};
    em_pass(w, i, &before, &before);
    for (int k = 0; k < s->count; ++k) {
        em_point here = {s->t[k], s->g[k][i]};
        const double side = w->side_new[i];
        const int node = k - s->near - 1; /* before this one */
        if (node >= (s->near > 0) && side * here.g > 0.0 && side * s->g[k - 1][i] > 0.0 &&
            em_lowest(s, i, a, node, side, &theta, &low) && low < 0.05 * size) {
            em_point dip;
            const int dips = em_dips(w, i, side, &theta, &dip.g);
            if (dips < 0) return -1;
            dip.t = w->t + theta * w->h;
            if (dips) em_pass(w, i, &before, &dip), before = dip;
        }
        em_pass(w, i, &before, &here);
        if (here.g != 0.0) before = here;
    }
    return 0;
}

/* What is zero at the end of the run has come there, unless it rested at zero before. */
static void em_arrive(em_walk *w, const em_survey *s, int i) {
    const em_point end = {w->t_new, w->g_new[i]};
    if (w->t_new != w->run->t_end || end.g != 0.0 || w->side[i] == 0) return;
    if (s->g[s->count - 2][i] == 0.0) return;
    if (em_fires(w->run->event_direction[i], w->side_new[i])) w->found[w->n_found++] = (em_found){end, end, i};
}

/* w->found <- what passes zero in the step under way, and the signs after it. 0, or -1 and w->reason. */
static int em_watch(em_walk *w) {
    double glances[EM_GLANCES][EM_SOME_EVENTS];
    em_survey survey = {0, 0, {0.0}, {{0.0}}, {0.0}};
    w->n_found = 0;
    if (em_events_at(w, w->t_new, w->y_new, w->f_new, w->g_new)) return -1;
    const int count = em_glance(w, glances);
    if (w->run->n_steps == 0) em_begin_sides(w, count, glances);
    memcpy(w->side_new, w->side, sizeof w->side);
    for (int i = 0; i < N_EVENTS; ++i) {
        if (!em_may_cross(w, count, glances, i)) continue;
        if (survey.count == 0 && (em_build_interpolant(w) || em_survey_step(w, &survey))) return -1;
        if (em_search(w, &survey, i)) return -1;
        em_arrive(w, &survey, i);
    }
    w->has_interpolant = survey.count > 0;
    return 0;
}

#endif
