/* em_flow.h: a motion whose states an importing tool integrates: x, v as a solver sets them, their rates, and events.
 *
 * A solver asks for rates and event functions, and says when it has accepted a step. After that, an event may have to
 * be handled: one of the model's has happened, constraints have drifted, or the parameters of a rotation have to be
 * replaced. Contacts and frictions, whose mode a run of the stepper decides, do not flow. */
#ifndef EM_FLOW_H
#define EM_FLOW_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "constraints/em_start_tolerance.h"
#include "eigenmotion.h"
#include "kinematics/em_shadow_parameters.h"
#include "tables/em_table_ranges.h"

/* Constraints are restored where that changes x or v by more than this part of rtol |x| + atol. */
#define EM_FLOW_DRIFT 0.1

/* All that changes in a motion is in `numbers`, so that a copy of these is a copy of it. */
typedef struct em_flow {
    const em_model *model;
    double rtol;
    int shares;                /* em_dependent: whether rows were redundant where it began */
    double *numbers;
    double *t, *x, *v;         /* 1; (n) */
    double *atol, *c;          /* (n); (n_prepared) */
    double *side, *last;       /* (n_events) the sign of each event function before it changes, and its last value */
    em_pile *pile;             /* (n_events) */
} em_flow;

static void em_flow_close(em_flow *flow) {
    if (flow == NULL) return;
    free(flow->numbers);
    free(flow);
}

/* How many numbers there are. */
static size_t em_flow_count(const em_model *m) {
    const size_t pile = sizeof(em_pile) / sizeof(double);
    return 1 + 3 * (size_t)m->n + (size_t)m->n_prepared + (2 + pile) * (size_t)m->n_events;
}

/* NULL without memory. */
static em_flow *em_flow_create(const em_model *m) {
    const size_t n = (size_t)m->n, events = (size_t)m->n_events;
    em_flow *const flow = calloc(1, sizeof *flow);
    if (flow == NULL) return NULL;
    flow->model = m;
    flow->numbers = calloc(em_flow_count(m), sizeof *flow->numbers);
    if (flow->numbers == NULL) return em_flow_close(flow), NULL;
    flow->t = flow->numbers;
    flow->x = flow->t + 1, flow->v = flow->x + n, flow->atol = flow->v + n, flow->c = flow->atol + n;
    flow->side = flow->c + m->n_prepared, flow->last = flow->side + events;
    flow->pile = (em_pile *)(flow->last + events);
    return flow;
}

static int em_flow_fault(em_fault *fault, em_status status, int first, double size) {
    *fault = (em_fault){status, first, -1, size};
    return -1;
}

/* g (n_events) <- the event functions. 0, or -1 and *fault: one has no value. */
static int em_flow_events(const em_flow *flow, const double *u, double *g, em_fault *fault) {
    const em_model *const m = flow->model;
    if (m->n_events > 0) m->event(*flow->t, flow->x, flow->v, flow->c, u, g);
    for (int i = 0; i < m->n_events; ++i)
        if (isnan(g[i])) return em_flow_fault(fault, EM_EVENT_UNDEFINED, i, NAN);
    return 0;
}

/* a (n) <- the rates of v. 0, or -1 and *fault. */
static int em_flow_rates(const em_flow *flow, const double *u, double *a, em_fault *fault) {
    const em_model *const m = flow->model;
    double lambda[m->m + 1];
    return m->acceleration(*flow->t, flow->x, flow->v, flow->c, u, flow->shares, a, lambda, fault);
}

/* Chooses the treatment of dependent rows where it begins: as long as no mode changes, redundant rows stay so. */
static void em_flow_choose_dependent(em_flow *flow) {
    const em_model *const m = flow->model;
    int rows[m->m + 1];
    flow->shares = m->m > 0 && m->redundant(*flow->t, flow->x, flow->c, rows) ? EM_SHARED : EM_REFUSED;
}

static double em_flow_sign(double g) { return (g > 0.0) - (g < 0.0); }

/* The side on which an impact keeps its event function, 1 or -1; 2: the one that it is on; 0: it is no such impact. */
static int em_flow_keeps(const em_model *m, int i) {
    if (m->event_actions == NULL || m->event_actions[i].impact < 0) return 0;
    if (m->event_actions[i].keeps_apart != 0) return m->event_actions[i].keeps_apart;
    return m->event_direction[i] == 0 ? 2 : 0;
}

/* Begins on the side of each event function that it is on. 0, or -1 and *fault. */
static int em_flow_begin(em_flow *flow, const double *u, em_fault *fault) {
    if (em_flow_events(flow, u, flow->last, fault)) return -1;
    for (int i = 0; i < flow->model->n_events; ++i) {
        const int keeps = em_flow_keeps(flow->model, i);
        flow->side[i] = keeps == 1 || keeps == -1 ? keeps : em_flow_sign(flow->last[i]);
    }
    return 0;
}

/* --- which events have happened --- */

/* Whether an event has happened: its function has crossed zero in its direction, from the side on which it was. One
 * that is zero has crossed. Where an impact has acted, the function may be across by rounding; then it has to fall
 * further. */
static int em_flow_happens(const em_flow *flow, int i, double g) {
    const double side = flow->side[i], direction = flow->model->event_direction[i];
    if (side == 0.0 || direction * side > 0.0) return 0; /* it leaves zero, or crosses the other way */
    if (em_flow_keeps(flow->model, i) && !(side * g < side * flow->last[i])) return 0;
    return side * g <= 0.0;
}

/* fired (n_events) <- events that have happened at g (n_events); returns their number. */
static int em_flow_fired(const em_flow *flow, const double *g, int *fired) {
    int count = 0;
    for (int i = 0; i < flow->model->n_events; ++i) count += fired[i] = em_flow_happens(flow, i, g[i]);
    return count;
}

/* side, last <- after a step, or after the events `fired`. An impact leaves its function on the side where it was. */
static void em_flow_settle_sides(em_flow *flow, const double *g, const int *fired) {
    for (int i = 0; i < flow->model->n_events; ++i) {
        const double sign = em_flow_sign(g[i]);
        const int stays = em_flow_keeps(flow->model, i) && flow->side[i] != 0.0;
        if (!stays) flow->side[i] = sign != 0.0 ? sign : fired[i] ? -flow->side[i] : flow->side[i];
        flow->last[i] = g[i];
    }
}

/* --- what changes x and v --- */

/* x, v (n, the state) <- the nearest state that satisfies the constraints. Returns whether that changes them by more
 * than `part` of their tolerances; -1 and *fault: there is none. */
static int em_flow_project(const em_flow *flow, double *x, double *v, double part, em_fault *fault) {
    const em_model *const m = flow->model;
    int moved = 0;
    if (m->m == 0) return 0;
    if (m->project(*flow->t, x, v, flow->c, flow->shares, fault)) return -1;
    for (int k = 0; k < m->n; ++k) {
        moved |= fabs(x[k] - flow->x[k]) > part * (flow->atol[k] + flow->rtol * fabs(x[k]));
        moved |= fabs(v[k] - flow->v[k]) > part * (flow->atol[k] + flow->rtol * fabs(v[k]));
    }
    return moved;
}

static int em_flow_leaves_chart(const em_flow *flow) {
    for (int k = 0; k < flow->model->n_rotations; ++k)
        if (em_leaves_chart(flow->model, k, flow->x)) return 1;
    return 0;
}

/* 0, or -1 and *fault: the motion has left the range of a table. */
static int em_flow_check_tables(const em_flow *flow, const double *u, em_fault *fault) {
    const em_model *const m = flow->model;
    double at[m->n_table_uses + 1];
    if (m->table_arguments == NULL) return 0;
    m->table_arguments(*flow->t, flow->x, flow->v, flow->c, u, at);
    return em_outside_tables(m, flow->c, at, fault) ? -1 : 0;
}

/* After a step that a solver has accepted. Returns whether an event has to be handled; or -1 and *fault. */
static int em_flow_accepted(em_flow *flow, const double *u, em_fault *fault) {
    const em_model *const m = flow->model;
    double g[m->n_events + 1], x[m->n], v[m->n];
    int fired[m->n_events + 1];
    if (em_flow_check_tables(flow, u, fault) || em_flow_events(flow, u, g, fault)) return -1;
    if (em_flow_fired(flow, g, fired) > 0 || em_flow_leaves_chart(flow)) return 1;
    em_flow_settle_sides(flow, g, fired);
    memcpy(x, flow->x, sizeof x);
    memcpy(v, flow->v, sizeof v);
    return em_flow_project(flow, x, v, EM_FLOW_DRIFT, fault);
}

/* Whether an event function is further across zero than the allowed changes of x (EM_START_STEPS) move it. */
static int em_flow_is_across(const em_flow *flow, const double *u, int i, const double *g) {
    const em_model *const m = flow->model;
    double near[m->n], elsewhere[m->n_events], reach = 0.0;
    memcpy(near, flow->x, sizeof near);
    for (int k = 0; k < m->n; ++k) {
        near[k] = flow->x[k] + EM_START_STEPS * (flow->atol[k] + flow->rtol * fabs(flow->x[k]));
        m->event(*flow->t, near, flow->v, flow->c, u, elsewhere);
        reach += fabs(elsewhere[i] - g[i]);
        near[k] = flow->x[k];
    }
    return flow->side[i] * g[i] < -reach;
}

/* 0, or -1 and *fault: an impact is needed again though its bodies have not been apart, and they are inside each other.
 * The bounces have become too short for the solver's steps, as at the end of infinitely many. */
static int em_flow_check_pile(const em_flow *flow, const double *u, const double *g, const int *fired, em_fault *fault) {
    for (int i = 0; i < flow->model->n_events; ++i) {
        const int again = fired[i] && em_flow_keeps(flow->model, i) && flow->side[i] * flow->last[i] <= 0.0;
        if (again && em_flow_is_across(flow, u, i, g)) return em_flow_fault(fault, EM_EVENTS_PILE_UP, i, g[i]);
    }
    return 0;
}

/* x, v <- after the events `fired` (n_events): impacts and resets. 0, or -1 and *fault. */
static int em_flow_act(em_flow *flow, const double *u, int *fired, em_fault *fault) {
    const em_model *const m = flow->model;
    double rounding[m->n_events + 1], depth = 0.0, shift[m->m + 1];
    const em_act_limits within = {flow->rtol, flow->atol, rounding, &depth, shift};
    memset(rounding, 0, sizeof rounding), memset(shift, 0, sizeof shift);
    return m->dynamics->act(*flow->t, flow->x, flow->v, flow->c, u, flow->shares, &within, fired, flow->pile, fault);
}

/* Whether one of the events `fired` changes the motion. */
static int em_flow_acts(const em_model *m, const int *fired) {
    for (int i = 0; m->event_actions != NULL && i < m->n_events; ++i)
        if (fired[i] && m->event_actions[i].acts) return 1;
    return 0;
}

/* Handles an event: x, v <- after it. Returns whether they have changed; or -1 and *fault. */
static int em_flow_update(em_flow *flow, const double *u, em_fault *fault) {
    const em_model *const m = flow->model;
    double g[m->n_events + 1], x[m->n], v[m->n];
    int fired[m->n_events + 1];
    if (em_flow_events(flow, u, g, fault)) return -1;
    const int any = em_flow_fired(flow, g, fired) > 0, acts = any && em_flow_acts(m, fired);
    if (any && em_flow_check_pile(flow, u, g, fired, fault)) return -1;
    if (acts && em_flow_act(flow, u, fired, fault)) return -1;
    memcpy(x, flow->x, sizeof x), memcpy(v, flow->v, sizeof v);
    const int moved = em_flow_project(flow, x, v, 0.0, fault);
    if (moved < 0) return -1;
    memcpy(flow->x, x, sizeof x), memcpy(flow->v, v, sizeof v);
    const int turned = em_turn_to_shadow(m, flow->x, flow->v);
    if ((acts || turned) && em_flow_events(flow, u, g, fault)) return -1;
    em_flow_settle_sides(flow, g, fired);
    return acts || moved || turned;
}

#endif
