/* em_event_detection.h: the events of a step, in the order of their times. */
#ifndef EM_EVENT_DETECTION_H
#define EM_EVENT_DETECTION_H

#include "events/em_event_location.h"
#include "events/em_root_isolation.h"

/* w->found <- the sign changes in the current step, and the signs after it. 0, or -1 and w->reason. */
static int em_detect_events(em_run_state *w) {
    double screened[EM_SCREENED_STATES * w->n_events], end[w->n_events], g[EM_POINTS * w->n_events], probe[w->n_events];
    em_isolation isolation = {.n_events = w->n_events, .g = g, .probe = probe};
    w->n_found = 0;
    if (em_events_at(w, w->t_new, w->y_new, w->f_new, w->g_new)) return -1;
    const int count = em_screen_event(w, screened);
    em_events_at_end(w, end);
    if (w->new_segment && em_begin_sides(w, count, screened)) return -1;
    memcpy(w->side_new, w->side, (size_t)w->n_events * sizeof *w->side);
    for (int i = 0; i < w->n_events; ++i) {
        if (!em_may_cross(w, count, screened, i) && end[i] * w->side[i] >= 0.0) continue;
        if (isolation.count == 0 && (w->scheme.interpolate(w) || em_isolate_roots(w, &isolation))) return -1;
        if (em_search(w, &isolation, i)) return -1;
        em_event_at_run_end(w, &isolation, i, end[i]);
    }
    w->has_interpolant = isolation.count > 0;
    return 0;
}

typedef struct em_crossing {
    double t;
    int event;
} em_crossing;

/* Inserts in the order of the run. */
static void em_crossing_insert(em_crossing *list, int count, em_crossing crossing, double direction) {
    for (; count > 0 && direction * (list[count - 1].t - crossing.t) > 0.0; --count) list[count] = list[count - 1];
    list[count] = crossing;
}

/* list (n_found) <- the crossings of this step in the order of the run. Returns their number, or -1 and w->reason. */
static int em_locate_crossings(em_run_state *w, em_crossing *list) {
    for (int k = 0; k < w->n_found; ++k) {
        em_crossing crossing = {w->t_new, w->found[k].event};
        if (em_locate(w, &w->found[k], &crossing.t)) return -1;
        em_crossing_insert(list, k, crossing, w->direction);
    }
    return w->n_found;
}

#endif
