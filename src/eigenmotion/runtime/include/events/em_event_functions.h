/* em_event_functions.h: event functions g_i, whose sign changes along the trajectory are events.
 *
 * An event fires where g_i changes its sign, or reaches zero at t_end. Directions are those of the run: 1 fires
 * where g_i grows on the way from t_start to t_end. A g_i that is zero at the start, to rounding, takes its sign
 * from the values that follow: it does not fire when it leaves zero, but does when it returns. A g_i that touches zero
 * and returns keeps its sign. Every sign change that the step's interpolant shows is found: em_event_screening.h
 * examines every step, em_root_isolation.h the steps for which that is not enough, em_event_location.h locates the
 * roots, and em_event_detection.h combines them. */
#ifndef EM_EVENT_FUNCTIONS_H
#define EM_EVENT_FUNCTIONS_H

#include "methods/em_dense_output.h"

static int em_keeps_apart(const em_run_state *w, int i) { return w->model->event_actions ? w->model->event_actions[i].keeps_apart : 0; }
static int em_event_acts(const em_run_state *w, int i) { return w->model->event_actions ? w->model->event_actions[i].acts : 0; }
static int em_is_contact_event(const em_run_state *w, int i) {
    return w->model->event_actions && w->model->event_actions[i].held >= 0;
}

/* Whether g_i is a condition of the mode: the margin of a row before it releases, slips, or moves. */
static int em_watches_mode(const em_run_state *w, int i) {
    const double *const c = w->run->prepared;
    for (int k = 0; k < w->model->n_switches; ++k) {
        const em_switch *const s = &w->model->switches[k];
        if (s->event == i) return c[s->holds] != 0.0 || c[s->idles] != 0.0 || (s->slides >= 0 && c[s->slides] != 0.0);
    }
    return 0;
}

/* g (n_events) in the mode of c. 0, or -1 and w->reason. */
static int em_events_in_mode(em_run_state *w, double t, const double *x, const double *v, double *g) {
    const double *const c = w->run->prepared;
    w->dynamics->events(t, x, v, c, w->u, g);
    if (w->dynamics->watch_modes == NULL) return 0;
    return w->dynamics->watch_modes(t, x, v, c, w->u, w->run->least_norm ? EM_LEAST_NORM : 0, g, &w->reason);
}

static int em_side_of(double g, double noise) { return (g > noise) - (g < -noise); }

/* g (n_events) at a state whose velocities are known. 0, or -1 and w->reason: an event has no value there. */
static int em_events_at(em_run_state *w, double t, const double *y, const double *v, double *g) {
    em_signals(w, t);
    if (em_events_in_mode(w, em_clock(w, t), y, v, g)) return -1;
    for (int i = 0; i < w->n_events; ++i)
        if (isnan(g[i])) return em_fail(&w->reason, EM_EVENT_UNDEFINED, i, -1, NAN);
    return 0;
}

/* The same at a state within the current step. */
static int em_events_of(em_run_state *w, double t, const double *y, double *g) {
    double v[w->n];
    if (em_xdot(w, w->mode, t, y, v, &w->reason)) return -1;
    return em_events_at(w, t, y, v, g);
}

/* g (n_events) at t inside the step, on the settled trajectory. 0, or -1 and w->reason. */
static int em_events_inside(em_run_state *w, double t, double *g) {
    double memory[em_padded(w->n_memory)];
    if (t == w->t || t == w->t_new) {
        em_copy_events(w, g, t == w->t ? w->g : w->g_new);
        return 0;
    }
    return em_settled_state_at(w, t, w->argument, memory) ? -1 : em_events_of(w, t, w->argument, g);
}

/* --- the start of a run --- */

#define EM_INPUT_ROUNDING (256.0 * DBL_EPSILON) /* relative: the rounding of numbers that the user computed before the
                                                start */
#define EM_START_ZERO 1e-3                 /* a start within this part of a tolerance counts as on zero */

/* Adds the change of g from one to the other to `zero`, and `part` of it to `noise`. */
static void em_add_noise(em_run_state *w, const double *g, double part) {
    for (int i = 0; i < w->n_events; ++i) {
        const double change = fabs(g[i] - w->g[i]);
        w->zero[i] += change;
        w->noise[i] += part * change;
    }
}

/* noise[i] <- the change of g_i when the time, and one of x and v after the other, change in their last places;
 * zero[i] <- the same for a part of their tolerances. Where g has no value nothing is added. */
static void em_events_noise(em_run_state *w) {
    const double later = EM_INPUT_ROUNDING * fabs(w->t);
    double z[2 * w->n], g[em_some(w->n_events)];
    for (int i = 0; i < w->n_events; ++i) w->noise[i] += w->rounding[i], w->zero[i] += w->rounding[i];
    for (int k = 0; k < w->width; ++k) w->argument[k] = w->y[k] + w->direction * later * w->K[0][k];
    if (!em_events_of(w, w->t + w->direction * later, w->argument, g)) em_add_noise(w, g, 1.0);
    for (int k = 0; k < w->n; ++k) z[k] = w->y[k], z[w->n + k] = w->K[0][k];
    for (int k = 0; k < 2 * w->n; ++k) {
        const double kept = z[k], last = EM_INPUT_ROUNDING * fabs(kept), more = last + EM_START_ZERO * em_tolerance_of(w, k);
        z[k] += more;
        if (more > 0.0 && !em_events_at(w, w->t, z, z + w->n, g)) em_add_noise(w, g, last / more);
        z[k] = kept;
    }
}

/* g and its noise at the start. 0, or -1 and w->reason. */
static int em_begin_events(em_run_state *w) {
    if (em_events_at(w, w->t, w->y, w->K[0], w->g)) return -1;
    em_events_noise(w);
    return 0;
}

#endif
