/* em_event_screening.h: event screening: whether g_i may change its sign in a step. Called at every step, before dense
 * output is built. */
#ifndef EM_EVENT_SCREENING_H
#define EM_EVENT_SCREENING_H

#include "events/em_event_functions.h"
#include "constraints/em_start_tolerance.h"

#define EM_SCREENING_MARGIN 0.25 /* g, relative to its variation, is safely off zero beyond this */

/* g (EM_SCREENED_STATES, n_events) on the approximate interpolant. Returns the number of states, or 0: unknown. */
static int em_screen_event(em_run_state *w, double *g) {
    static const double at[EM_SCREENED_STATES] = {0.14644660940672624, 0.5, 0.85355339059327376};
    const int terms = w->scheme.sketch(w);
    if (terms < 0) return 0;
    for (int j = 0; j < EM_SCREENED_STATES; ++j) {
        w->scheme.evaluate(w->n_state, w->F[0], terms, at[j], w->argument);
        if (em_events_of(w, w->t + at[j] * w->h, w->argument, g + j * w->n_events)) return 0;
    }
    return EM_SCREENED_STATES;
}

/* cos(pi j / 8) */
static double em_eighth(int j) {
    static const double quarter[] = {1.0, 0.92387953251128674, 0.70710678118654752, 0.38268343236508977, 0.0};
    j %= 16;
    if (j > 8) j = 16 - j;
    return j <= 4 ? quarter[j] : -quarter[8 - j];
}

/* Whether the states screened undersample g_i: with the ends they are the five Chebyshev nodes, and its coefficients
 * do not decay. */
static int em_is_undersampled(const em_run_state *w, const double *g, int i) {
    const double at[EM_SCREENED_STATES + 2] = {0.5 * w->g[i], g[i], g[w->n_events + i], g[2 * w->n_events + i], 0.5 * w->g_new[i]};
    double size[EM_SCREENED_STATES + 2] = {0.0};
    for (int k = 1; k < EM_SCREENED_STATES + 2; ++k) {
        for (int j = 0; j < EM_SCREENED_STATES + 2; ++j) size[k] += at[j] * em_eighth(2 * j * k);
        size[k] = fabs(size[k]);
    }
    return size[3] + 0.5 * size[4] > 0.25 * (size[1] + size[2]);
}

/* Whether g_i may reach zero in this step: it changes sign, comes close to zero relative to its variation, or is
 * undersampled. */
static int em_may_cross(const em_run_state *w, int count, const double *g, int i) {
    const double side = w->side[i], noise = w->quiet[i];
    double low = em_min(side * w->g[i], side * w->g_new[i]), high = em_max(side * w->g[i], side * w->g_new[i]);
    int leaves = em_side_of(w->g_new[i], noise) != 0;
    for (int j = 0; j < count; ++j) {
        const double here = g[j * w->n_events + i];
        low = em_min(low, side * here);
        high = em_max(high, side * here);
        leaves |= em_side_of(here, noise) != 0;
    }
    if (count == 0) return 1;
    if (w->side[i] == 0) return leaves;
    return !(low > EM_SCREENING_MARGIN * (high - low)) || em_is_undersampled(w, g, i);
}

/* Whether g_i of an impact that has not happened is beyond zero only by rounding: of bodies that touch at rest or fall
 * side by side, or of successive impacts. */
static int em_is_touching(const em_run_state *w, int i) {
    const int through = w->run->event_direction[i];
    return w->new_segment != EM_FIRST_SEGMENT && em_keeps_apart(w, i) && w->side[i] != through && em_side_of(w->g[i], 0.0) == through;
}

/* Whether an impact leaves its bodies inside each other by more than a start may be: flights that are shorter than the
 * rounding of the gap have been missed, one after the other and each deeper. */
static int em_has_sunk(const em_run_state *w, int i) {
    const double tolerance = w->noise[i] + EM_START_STEPS / EM_START_ZERO * w->zero[i];
    return w->fired[i] && em_is_touching(w, i) && em_event_acts(w, i) && fabs(w->g[i]) > tolerance;
}

/* At the start of a segment a condition of the mode holds, or is zero to rounding: a value beyond that ends the mode
 * immediately, whatever follows. */
static void em_begin_condition(em_run_state *w, int i, double zero) {
    w->side[i] = w->g[i] > zero || w->g[i] < -zero;
    w->quiet[i] = zero;
}

/* In the first step of a segment: finds which g_i are zero, to rounding relative to their later values or to a part
 * of the tolerances, and the size above which they no longer are. Events that fired at the start of the segment are
 * zero by definition; others that are zero keep their sign. A touching contact always counts as zero: otherwise its
 * impact would be missed. 0, or -1 and w->reason. */
static int em_begin_sides(em_run_state *w, int count, const double *g) {
    for (int i = 0; i < w->n_events; ++i) {
        if (em_has_sunk(w, i)) return em_fail(&w->reason, EM_EVENTS_PILE_UP, i, -1, NAN);
        double size = fabs(w->g_new[i]);
        for (int j = 0; j < count; ++j) size = em_max(size, fabs(g[j * w->n_events + i]));
        const double rounding = w->noise[i] + (isfinite(size) ? EM_INPUT_ROUNDING * size : 0.0);
        const int meant = w->new_segment == EM_FIRST_SEGMENT || w->fired[i], touches = em_is_touching(w, i);
        const int side = em_side_of(w->g[i], meant ? em_max(rounding, w->zero[i]) : rounding);
        if (touches) w->side[i] = 0;
        else if (meant || side) w->side[i] = side;
        w->quiet[i] = rounding + 4.0 * fabs(w->g[i]);
        if (em_watches_mode(w, i)) em_begin_condition(w, i, em_max(rounding, w->zero[i]));
    }
    return 0;
}

#endif
