/* em_unit.h: a mechanism whose parameters, start and inputs are set one by one, and which then moves: the content of an
 * FMU.
 *
 * It steps (em_control.h), or flows: then an importing tool integrates its states (em_flow.h).
 * Its numbers have references, one after the other: parameters, x, v, inputs; then the model's outputs, the rates of v,
 * and the event functions. */
#ifndef EM_UNIT_H
#define EM_UNIT_H

#include "em_control.h"
#include "em_flow.h"
#include "em_unit_words.h"
#include "loop/em_start_check.h"

/* What is asked of every run. */
typedef struct em_unit_options {
    em_method method;
    double rtol, atol, step; /* step: of a method of fixed step, else 0 */
    const double *v;         /* (n) at the start */
} em_unit_options;

typedef struct em_unit {
    const em_model *model;
    em_unit_options options;
    int flows;               /* whether its states are integrated by others */
    int steps;               /* whether initialisation is over: parameters and start stand */
    double t_start, rtol;
    double *given;           /* (n_given) parameters, x and v at the start, inputs */
    em_stepper *stepper;     /* or NULL: to be opened with what is given; or it flows */
    em_flow *flow;           /* or NULL: to be opened with what is given; or it steps */
    char words[EM_WORDS];    /* what went wrong last */
} em_unit;

static size_t em_unit_given(const em_model *m) { return (size_t)(m->n_parameters + 2 * m->n + m->n_inputs); }
static double *em_unit_x(const em_unit *unit) { return unit->given + unit->model->n_parameters; }
static double *em_unit_v(const em_unit *unit) { return em_unit_x(unit) + unit->model->n; }
static double *em_unit_u(const em_unit *unit) { return em_unit_v(unit) + unit->model->n; }

static void em_unit_copy(double *to, const double *from, int count) {
    for (int k = 0; k < count; ++k) to[k] = from[k];
}

static void em_unit_close(em_unit *unit) {
    em_stepper_close(unit->stepper);
    em_flow_close(unit->flow);
    unit->stepper = NULL;
    unit->flow = NULL;
}

static int em_unit_is_open(const em_unit *unit) { return unit->stepper != NULL || unit->flow != NULL; }

/* Where the motion is: time, state and constants, and the treatment of dependent rows (em_dependent). */
typedef struct em_place {
    double t;
    const double *x, *v, *c;
    int shares;
} em_place;

/* Of one that is open. */
static em_place em_unit_place(const em_unit *unit) {
    const em_stepper *const s = unit->stepper;
    const em_flow *const flow = unit->flow;
    if (s != NULL) return (em_place){s->t, s->x, s->v, s->run.prepared, s->run.least_norm};
    return (em_place){*flow->t, flow->x, flow->v, flow->c, flow->shares};
}

/* Before initialisation: the time, and the tolerance or 0. */
static void em_unit_begin(em_unit *unit, double t, double rtol) {
    em_unit_close(unit);
    unit->t_start = t;
    if (rtol > 0.0) unit->rtol = rtol;
}

static double em_unit_time(const em_unit *unit) { return em_unit_is_open(unit) ? em_unit_place(unit).t : unit->t_start; }

/* The model's own values. */
static void em_unit_reset(em_unit *unit) {
    const em_model *m = unit->model;
    em_unit_close(unit);
    unit->steps = 0;
    unit->t_start = 0.0;
    unit->rtol = unit->options.rtol;
    em_unit_copy(unit->given, m->parameter_defaults, m->n_parameters);
    em_unit_copy(em_unit_x(unit), m->initial_x, m->n);
    em_unit_copy(em_unit_v(unit), unit->options.v, m->n);
    em_unit_copy(em_unit_u(unit), m->input_defaults, m->n_inputs);
}

static void em_unit_free(em_unit *unit) {
    if (unit == NULL) return;
    em_unit_close(unit);
    free(unit->given);
    free(unit);
}

/* NULL without memory. */
static em_unit *em_unit_create(const em_model *model, em_unit_options options) {
    em_unit *unit = calloc(1, sizeof *unit);
    if (unit == NULL) return NULL;
    unit->model = model;
    unit->options = options;
    unit->given = calloc(em_unit_given(model) + 1, sizeof *unit->given);
    if (unit->given == NULL) return em_unit_free(unit), NULL;
    em_unit_reset(unit);
    return unit;
}

/* -1, and words that say where a fault sits. */
static int em_unit_fail(em_unit *unit, const em_fault *fault) {
    return em_words_of_fault(unit->model, fault, em_unit_time(unit), unit->words);
}

/* The stepper at a start, with c, y and atol. 0, or -1 and words. */
static int em_unit_open_stepper(em_unit *unit, const double *c, const double *y, const double *atol) {
    const em_unit_options *o = &unit->options;
    const em_run task = {.t_start = unit->t_start, .y_start = y, .prepared = c, .method = o->method, .rtol = unit->rtol,
                         .atol = atol, .first_step = o->step, .max_step = INFINITY, .max_steps = 1000000000,
                         .stabilise = 1, .least_norm = EM_SHARED_FROM_START, .model = unit->model};
    em_fault fault = {EM_OUT_OF_MEMORY, -1, -1, 0.0};
    unit->stepper = em_stepper_open(unit->model, &task, em_unit_u(unit));
    if (unit->stepper != NULL) fault = unit->stepper->run.fault;
    if (fault.status == EM_FINISHED) return 0;
    em_unit_close(unit);
    return em_unit_fail(unit, &fault);
}

/* The flow at a start, with c and atol. 0, or -1 and words. */
static int em_unit_open_flow(em_unit *unit, const double *c, const double *atol) {
    const em_model *m = unit->model;
    em_fault fault = {EM_OUT_OF_MEMORY, -1, -1, 0.0};
    em_flow *const flow = unit->flow = em_flow_create(m);
    if (flow == NULL) return em_unit_fail(unit, &fault);
    *flow->t = unit->t_start;
    flow->rtol = unit->rtol;
    em_unit_copy(flow->x, em_unit_x(unit), m->n);
    em_unit_copy(flow->v, em_unit_v(unit), m->n);
    em_unit_copy(flow->atol, atol, m->n);
    em_unit_copy(flow->c, c, m->n_prepared);
    em_flow_choose_dependent(flow);
    if (!em_flow_check_tables(flow, em_unit_u(unit), &fault) && !em_flow_begin(flow, em_unit_u(unit), &fault)) return 0;
    em_unit_close(unit);
    return em_unit_fail(unit, &fault);
}

/* Opens it with memory for c, y and atol. 0, or -1 and words. */
static int em_unit_start(em_unit *unit, double *c, double *y, double *atol) {
    const em_model *m = unit->model;
    em_fault fault;
    for (int k = 0; k < m->n; ++k) atol[k] = unit->options.atol * (unit->rtol / unit->options.rtol);
    if (m->prepare(unit->given, c, &fault)) return em_unit_fail(unit, &fault);
    if (em_start(m, unit->t_start, em_unit_x(unit), em_unit_v(unit), c, unit->rtol, atol, y, NULL, NULL)) {
        fault = (em_fault){EM_START_REFUSED, -1, -1, 0.0};
        return em_unit_fail(unit, &fault);
    }
    return unit->flows ? em_unit_open_flow(unit, c, atol) : em_unit_open_stepper(unit, c, y, atol);
}

/* Opens it unless it is open. 0, or -1 and words: no motion starts there. */
static int em_unit_open(em_unit *unit) {
    if (em_unit_is_open(unit)) return 0;
    const em_model *m = unit->model;
    const size_t c = (size_t)m->n_prepared, y = (size_t)m->n_state;
    double *const memory = calloc(c + y + (size_t)m->n, sizeof *memory);
    const em_fault none = {EM_OUT_OF_MEMORY, -1, -1, 0.0};
    if (memory == NULL) return em_unit_fail(unit, &none);
    const int failed = em_unit_start(unit, memory, memory + c, memory + c + y);
    free(memory);
    return failed;
}

/* The end of initialisation. 0, or -1 and words. */
static int em_unit_enter(em_unit *unit) {
    const int failed = em_unit_open(unit);
    unit->steps = !failed;
    return failed;
}

/* The place of a number among those that may be declared: parameters, x, inputs; -1: a rate. */
static int em_unit_declared(const em_model *m, unsigned reference) {
    const unsigned n = (unsigned)m->n, v = (unsigned)m->n_parameters + n;
    return reference < v ? (int)reference : reference < v + n ? -1 : (int)(reference - n);
}

/* A number by its reference. 0, or -1 and words. */
static int em_unit_set(em_unit *unit, unsigned reference, double value) {
    const size_t inputs = (size_t)(unit->model->n_parameters + 2 * unit->model->n);
    if (reference >= em_unit_given(unit->model) || (unit->steps && reference < inputs) || !isfinite(value)) {
        snprintf(unit->words, sizeof unit->words, "value reference %u: %s", reference,
                 !isfinite(value) ? "not a finite number" : reference < inputs ? "parameters and start are fixed while stepping"
                                                                               : "no number that can be set");
        return -1;
    }
    if (em_words_of_value(unit->model, em_unit_declared(unit->model, reference), value, unit->words)) return -1;
    if (reference < inputs) em_unit_close(unit);
    unit->given[reference] = value;
    return 0;
}

/* Numbers that follow from the state: outputs, rates of v, event functions. */
enum { EM_OUTPUTS, EM_RATES, EM_EVENTS, EM_GROUPS };

/* first (EM_GROUPS + 1) <- the reference at which each group begins */
static void em_unit_groups(const em_model *m, size_t *first) {
    first[EM_OUTPUTS] = em_unit_given(m);
    first[EM_RATES] = first[EM_OUTPUTS] + (size_t)m->n_outputs;
    first[EM_EVENTS] = first[EM_RATES] + (size_t)m->n;
    first[EM_GROUPS] = first[EM_EVENTS] + (size_t)m->n_events;
}

/* out <- the numbers of a group. 0, or -1 and words. */
static int em_unit_calculate(em_unit *unit, int group, double *out) {
    const em_model *const m = unit->model;
    const double *const u = em_unit_u(unit);
    em_fault fault;
    int failed = 0;
    if (em_unit_open(unit)) return -1;
    const em_place at = em_unit_place(unit);
    double lambda[m->m + 1];
    if (group == EM_OUTPUTS) failed = m->output(at.t, at.x, at.v, at.c, u, at.shares, out, &fault);
    else if (group == EM_RATES) failed = m->acceleration(at.t, at.x, at.v, at.c, u, at.shares, out, lambda, &fault);
    else m->event(at.t, at.x, at.v, at.c, u, out);
    return failed ? em_unit_fail(unit, &fault) : 0;
}

/* The place of a number given among the arguments of derivatives: x, v, inputs, parameters, time. */
static size_t em_unit_argument(const em_model *m, unsigned reference) {
    const unsigned p = (unsigned)m->n_parameters, states = 2 * (unsigned)m->n;
    if (reference < p) return states + (unsigned)m->n_inputs + reference;
    return reference - p; /* x, v and inputs follow each other there, too */
}

/* The change of one number along `d` (n_arguments), of which a and lambda change by `da` (n + m); D:
 * em_model.output_partials, then event_partials */
static double em_unit_change(const em_unit *unit, unsigned reference, const double *d, const double *da, const double *D) {
    const em_model *m = unit->model;
    const size_t reactions = (size_t)(m->n + m->m), width = reactions + (size_t)m->n_arguments;
    size_t first[EM_GROUPS + 1];
    em_unit_groups(m, first);
    const size_t given = first[EM_OUTPUTS];
    if (reference < given) return d[em_unit_argument(m, reference)];
    double sum = 0.0;
    if (reference >= first[EM_EVENTS]) {
        const size_t row = (size_t)m->n_outputs * width + (reference - first[EM_EVENTS]) * (size_t)m->n_arguments;
        for (int k = 0; k < m->n_arguments; ++k) sum += D[row + (size_t)k] * d[k];
        return sum;
    }
    if (reference >= first[EM_RATES]) return da[reference - first[EM_RATES]];
    for (size_t k = 0; k < width; ++k) sum += D[(reference - given) * width + k] * (k < reactions ? da[k] : d[k - reactions]);
    return sum;
}

/* changes (unknowns) of numbers where the motion stands, along `d` (n_arguments), exactly; work: em_unit_partials numbers.
 * 0, or -1 and *fault. */
static int em_unit_changes(const em_unit *unit, const unsigned *unknown, size_t unknowns, const double *d, double *work,
                           double *changes, em_fault *fault) {
    const em_model *const m = unit->model;
    const em_place at = em_unit_place(unit);
    const int reactions = m->n + m->m, arguments = m->n_arguments;
    double *const a = work, *const along = a + reactions, *const slopes = along + reactions;
    double *const D = slopes + reactions * arguments;
    if (m->motion_derivatives(at.t, at.x, at.v, at.c, em_unit_u(unit), at.shares, a, a + m->n, slopes,
                              slopes + m->n * arguments, fault))
        return -1;
    if (m->n_outputs > 0) m->output_partials(at.t, at.x, at.v, a, a + m->n, at.c, em_unit_u(unit), D);
    double *const events = D + m->n_outputs * (reactions + arguments);
    if (m->event_partials != NULL) m->event_partials(at.t, at.x, at.v, at.c, em_unit_u(unit), events);
    for (int row = 0; row < reactions; ++row) {
        along[row] = 0.0;
        for (int k = 0; k < arguments; ++k) along[row] += slopes[row * arguments + k] * d[k];
    }
    for (size_t k = 0; k < unknowns; ++k) changes[k] = em_unit_change(unit, unknown[k], d, along, D);
    return 0;
}

static size_t em_unit_partials(const em_model *m) {
    const size_t reactions = (size_t)(m->n + m->m), arguments = (size_t)m->n_arguments;
    const size_t events = (size_t)m->n_events * arguments;
    return 2 * reactions + reactions * arguments + (size_t)m->n_outputs * (reactions + arguments) + events;
}

/* -1, and words: a reference that is none, or a parameter's where those have no change of their own. */
static int em_unit_check(em_unit *unit, const unsigned *references, size_t count, size_t first, size_t end) {
    for (size_t k = 0; k < count; ++k) {
        if (references[k] >= first && references[k] < end) continue;
        snprintf(unit->words, sizeof unit->words, "value reference %u: no %s", references[k],
                 first > 0 ? "output" : "parameter, coordinate, rate or input");
        return -1;
    }
    return 0;
}

/* changes (unknowns) of outputs, coordinates, rates, accelerations and event functions along dknown (count) of
 * numbers given. 0, or -1 and words. */
static int em_unit_along(em_unit *unit, const unsigned *unknown, size_t unknowns, const unsigned *known, size_t count,
                         const double *dknown, double *changes) {
    const em_model *const m = unit->model;
    const size_t given = em_unit_given(m), events = m->event_partials == NULL ? 0 : (size_t)m->n_events;
    const size_t all = given + (size_t)(m->n_outputs + m->n) + events;
    if (em_unit_check(unit, unknown, unknowns, (size_t)m->n_parameters, all) || em_unit_check(unit, known, count, 0, given) ||
        em_unit_open(unit))
        return -1;
    em_fault fault = {EM_OUT_OF_MEMORY, -1, -1, 0.0};
    double *const work = calloc((size_t)m->n_arguments + em_unit_partials(m), sizeof *work);
    if (work == NULL) return em_unit_fail(unit, &fault);
    for (size_t k = 0; k < count; ++k) work[em_unit_argument(m, known[k])] += dknown[k];
    const int failed = em_unit_changes(unit, unknown, unknowns, work, work + m->n_arguments, changes, &fault);
    free(work);
    return failed ? em_unit_fail(unit, &fault) : 0;
}

/* One of those given, or x or v as they are now. */
static double em_unit_number(const em_unit *unit, unsigned reference) {
    const unsigned p = (unsigned)unit->model->n_parameters, n = (unsigned)unit->model->n;
    if (!em_unit_is_open(unit) || reference < p || reference >= p + 2 * n) return unit->given[reference];
    const em_place at = em_unit_place(unit);
    return reference < p + n ? at.x[reference - p] : at.v[reference - p - n];
}

/* *value <- a number that follows from the state; calculated, known: memory of all of these, and of which groups are
 * there. 0, or -1 and words. */
static int em_unit_find(em_unit *unit, size_t reference, double *calculated, int *known, double *value) {
    size_t first[EM_GROUPS + 1];
    em_unit_groups(unit->model, first);
    for (int group = 0; group < EM_GROUPS; ++group) {
        if (reference >= first[group + 1]) continue;
        double *const out = calculated + (first[group] - first[0]);
        if (!(*known >> group & 1) && em_unit_calculate(unit, group, out)) return -1;
        *known |= 1 << group;
        *value = calculated[reference - first[0]];
        return 0;
    }
    return em_words_of_no_reference((unsigned)reference, unit->words);
}

/* value (count) <- numbers by their references. 0, or -1 and words. */
static int em_unit_read(em_unit *unit, const unsigned *reference, size_t count, double *value) {
    const em_model *const m = unit->model;
    const size_t given = em_unit_given(m);
    double *const calculated = calloc((size_t)(m->n_outputs + m->n + m->n_events) + 1, sizeof *calculated);
    const em_fault none = {EM_OUT_OF_MEMORY, -1, -1, 0.0};
    int known = 0, failed = 0;
    if (calculated == NULL) return em_unit_fail(unit, &none);
    for (size_t k = 0; k < count && !failed; ++k) {
        if (reference[k] < given) value[k] = em_unit_number(unit, reference[k]);
        else failed = em_unit_find(unit, reference[k], calculated, &known, &value[k]);
    }
    free(calculated);
    return failed ? -1 : 0;
}

static int em_unit_advance(em_unit *unit, double t) {
    if (em_unit_open(unit)) return -1;
    if (!em_stepper_advance(unit->stepper, t, em_unit_u(unit))) return 0;
    return em_unit_fail(unit, &unit->stepper->run.fault);
}

/* --- as it flows: its 2 n states are x, v --- */

/* From here on it flows. */
static void em_unit_let_flow(em_unit *unit) {
    em_unit_close(unit);
    unit->flows = 1;
}

static int em_unit_set_time(em_unit *unit, double t) {
    if (em_unit_open(unit)) return -1;
    *unit->flow->t = t;
    return 0;
}

/* 0, or -1 and words. */
static int em_unit_set_states(em_unit *unit, const double *states) {
    const int n = unit->model->n;
    em_fault fault = {EM_NON_FINITE_STATE, -1, -1, NAN};
    if (em_unit_open(unit)) return -1;
    for (int k = 0; k < 2 * n; ++k)
        if (!isfinite(states[k])) return fault.first = k % n, em_unit_fail(unit, &fault);
    em_unit_copy(unit->flow->x, states, 2 * n);
    return 0;
}

static int em_unit_states(em_unit *unit, double *states) {
    if (em_unit_open(unit)) return -1;
    em_unit_copy(states, unit->flow->x, 2 * unit->model->n);
    return 0;
}

/* rates (2 n) <- v and its rates. 0, or -1 and words. */
static int em_unit_rates(em_unit *unit, double *rates) {
    const int n = unit->model->n;
    em_fault fault;
    if (em_unit_open(unit)) return -1;
    em_unit_copy(rates, unit->flow->v, n);
    return em_flow_rates(unit->flow, em_unit_u(unit), rates + n, &fault) ? em_unit_fail(unit, &fault) : 0;
}

/* g (n_events) <- the event functions. 0, or -1 and words. */
static int em_unit_indicators(em_unit *unit, double *g) {
    em_fault fault;
    if (em_unit_open(unit)) return -1;
    return em_flow_events(unit->flow, em_unit_u(unit), g, &fault) ? em_unit_fail(unit, &fault) : 0;
}

/* *event <- whether an event has to be handled after a step. 0, or -1 and words. */
static int em_unit_accepted(em_unit *unit, int *event) {
    em_fault fault;
    if (em_unit_open(unit)) return -1;
    *event = em_flow_accepted(unit->flow, em_unit_u(unit), &fault);
    return *event < 0 ? em_unit_fail(unit, &fault) : 0;
}

/* Handles events; *changed <- whether x, v are others now. 0, or -1 and words. */
static int em_unit_update(em_unit *unit, int *changed) {
    em_fault fault;
    if (em_unit_open(unit)) return -1;
    *changed = em_flow_update(unit->flow, em_unit_u(unit), &fault);
    return *changed < 0 ? em_unit_fail(unit, &fault) : 0;
}

/* --- all of it in one block of memory that can be moved --- */

typedef struct em_unit_state {
    int steps, open;
    double t_start, rtol;
} em_unit_state;

/* Bytes of the motion itself. */
static size_t em_unit_motion(const em_unit *unit) {
    const em_model *m = unit->model;
    if (unit->flows) return em_flow_count(m) * sizeof(double);
    return m->saved() + (size_t)m->n_inputs * sizeof(double);
}

static size_t em_unit_size(const em_unit *unit) {
    return sizeof(em_unit_state) + em_unit_given(unit->model) * sizeof(double) + em_unit_motion(unit);
}

static void em_unit_save(const em_unit *unit, void *saved) {
    const size_t numbers = em_unit_given(unit->model) * sizeof(double);
    const em_unit_state state = {unit->steps, em_unit_is_open(unit), unit->t_start, unit->rtol};
    char *const place = saved;
    memcpy(place, &state, sizeof state);
    memcpy(place + sizeof state, unit->given, numbers);
    if (unit->flow != NULL) memcpy(place + sizeof state + numbers, unit->flow->numbers, em_unit_motion(unit));
    else if (state.open) em_stepper_save(unit->stepper, place + sizeof state + numbers);
}

/* 0, or -1 and words. */
static int em_unit_restore(em_unit *unit, const void *saved) {
    const size_t numbers = em_unit_given(unit->model) * sizeof(double);
    const char *const place = saved;
    em_unit_state state;
    memcpy(&state, place, sizeof state);
    em_unit_close(unit);
    memcpy(unit->given, place + sizeof state, numbers);
    unit->steps = state.steps;
    unit->t_start = state.t_start;
    unit->rtol = state.rtol;
    if (!state.open) return 0;
    if (em_unit_open(unit)) return -1;
    if (unit->flow != NULL) memcpy(unit->flow->numbers, place + sizeof state + numbers, em_unit_motion(unit));
    else em_stepper_restore(unit->stepper, place + sizeof state + numbers);
    return 0;
}

#endif
