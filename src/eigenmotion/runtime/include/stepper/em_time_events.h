/* em_time_events.h: time events: times at which conditions on time alone change.
 *
 * A time event is three numbers: at, period, terms. It happens at the times at + k period, k an integer; period 0
 * means once; eps terms is the rounding of `at`, EM_EXACT_TIME in place of `terms` says that `at` is exact. If `at` is
 * not finite there is none. Steps end at time events.
 * Within a step the model is evaluated no closer to either end than rounding may move a condition there, so that
 * each side of a jump is seen from that side alone. Time events that are closer to each other than that are one. */
#ifndef EM_TIME_EVENTS_H
#define EM_TIME_EVENTS_H

#include <float.h>
#include <math.h>

#include "numeric/em_real.h"

#define EM_TIME_EVENT_ROUNDINGS (8.0 * DBL_EPSILON)
#define EM_EXACT_TIME (-1.0)

/* The rounding of a time event near t: its condition may change this far from its time. */
EM_UNUSED static double em_time_event_slack(const double *b, double t) {
    const double size = fabs(t) + fabs(b[0]);
    if (b[2] == EM_EXACT_TIME) return DBL_EPSILON * fabs(t) + DBL_MIN / DBL_EPSILON;
    return EM_TIME_EVENT_ROUNDINGS * (b[2] > size && b[2] < INFINITY ? b[2] : size) + DBL_MIN / DBL_EPSILON; /* at t = 0 too */
}

EM_UNUSED static int em_is_time_event(const double *b) { return isfinite(b[0]) && isfinite(b[1]); }

/* Whether a time event repeats faster than rounding near t can separate. */
EM_UNUSED static int em_time_event_is_blurred(const double *b, double t) {
    return em_is_time_event(b) && b[1] != 0.0 && fabs(b[1]) <= 2.0 * em_time_event_slack(b, t);
}

/* The time of a time event that is nearest to t. */
EM_UNUSED static double em_nearest_time_event(const double *b, double t) {
    return b[1] != 0.0 ? b[0] + round((t - b[0]) / b[1]) * b[1] : b[0];
}

/* The next time of a time event beyond t by more than its slack; infinite: there is none. A blurred one has no
 * definite time. */
EM_UNUSED static double em_time_event_after(const double *b, double t, double direction) {
    const double slack = em_time_event_slack(b, t), clear = t + direction * slack;
    double next = b[0];
    if (em_time_event_is_blurred(b, t)) return clear;
    if (b[1] != 0.0) {
        const double period = fabs(b[1]), turns = (clear - b[0]) / period;
        next = b[0] + (direction > 0.0 ? floor(turns) + 1.0 : ceil(turns) - 1.0) * period;
        if (!(direction * (next - clear) > 0.0)) next += direction * period;
    }
    return em_is_time_event(b) && direction * (next - clear) > 0.0 ? next : direction * INFINITY;
}

/* The next of `count` time events (count, 3) beyond t; infinite: there is none. */
EM_UNUSED static double em_next_time_event(int count, const double *at, double t, double direction) {
    double next = direction * INFINITY;
    for (int i = 0; i < count; ++i) {
        const double after = em_time_event_after(at + 3 * i, t, direction);
        if (direction * (after - next) < 0.0) next = after;
    }
    return next;
}

/* The distance from t up to which the time events at t extend, that is, those within their slack or `near`; 0: t is no
 * time event. */
EM_UNUSED static double em_time_event_reach_near(int count, const double *at, double t, double near) {
    double reach = 0.0;
    for (int i = 0; i < count && isfinite(t); ++i) {
        const double *const b = at + 3 * i, slack = em_time_event_slack(b, t), apart = fabs(t - em_nearest_time_event(b, t));
        if (em_is_time_event(b) && apart <= fmax(slack, near)) reach = fmax(reach, apart + slack);
    }
    return reach;
}

EM_UNUSED static double em_time_event_reach(int count, const double *at, double t) { return em_time_event_reach_near(count, at, t, 0.0); }

/* inside (2) <- the times between which a step from t to the time event `next` evaluates the model. Returns whether
 * t is a time event. */
EM_UNUSED static int em_time_event_sides(int count, const double *at, double t, double next, double direction, double *inside) {
    const double here = em_time_event_reach(count, at, t), there = em_time_event_reach(count, at, next);
    double begin = here > 0.0 ? t + direction * here : -direction * INFINITY, end = next - direction * there;
    if (direction * (end - begin) < 0.0) begin = end = t + (next - t) / 2.0;
    inside[0] = direction > 0.0 ? begin : end;
    inside[1] = direction > 0.0 ? end : begin;
    return here > 0.0;
}

#endif
