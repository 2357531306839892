/* em_unit.h: a mechanism whose parameters, start and inputs are set one by one, and which then steps: the content of an FMU.
 *
 * Its numbers have references, one after the other: parameters, x, v, inputs; then the model's outputs. */
#ifndef EM_UNIT_H
#define EM_UNIT_H

#include "em_control.h"
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
    int steps;               /* whether initialisation is over: parameters and start stand */
    double t_start, rtol;
    double *given;           /* (n_given) parameters, x and v at the start, inputs */
    em_stepper *stepper;     /* or NULL: to be opened with what is given */
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
    unit->stepper = NULL;
}

/* Before initialisation: the time, and the tolerance or 0. */
static void em_unit_begin(em_unit *unit, double t, double rtol) {
    em_unit_close(unit);
    unit->t_start = t;
    if (rtol > 0.0) unit->rtol = rtol;
}

static double em_unit_time(const em_unit *unit) { return unit->stepper != NULL ? unit->stepper->t : unit->t_start; }

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
static int em_unit_fail(em_unit *unit, const em_fault *fault, double t) {
    return em_words_of_fault(unit->model, fault, t, unit->words);
}

/* The run of a stepper, in memory for c, y and atol. 0, or -1 and words. */
static int em_unit_start(em_unit *unit, double *c, double *y, double *atol) {
    const em_model *m = unit->model;
    const em_unit_options *o = &unit->options;
    em_fault fault;
    for (int k = 0; k < m->n; ++k) atol[k] = o->atol * (unit->rtol / o->rtol);
    if (m->prepare(unit->given, c, &fault)) return em_unit_fail(unit, &fault, unit->t_start);
    if (em_start(m, unit->t_start, em_unit_x(unit), em_unit_v(unit), c, unit->rtol, atol, y, NULL, NULL)) {
        fault = (em_fault){EM_START_REFUSED, -1, -1, 0.0};
        return em_unit_fail(unit, &fault, unit->t_start);
    }
    const em_run task = {.t_start = unit->t_start, .y_start = y, .prepared = c, .method = o->method, .rtol = unit->rtol,
                         .atol = atol, .first_step = o->step, .max_step = INFINITY, .max_steps = 1000000000,
                         .stabilise = 1, .model = m};
    unit->stepper = em_stepper_open(m, &task, em_unit_u(unit));
    if (unit->stepper == NULL) fault = (em_fault){EM_OUT_OF_MEMORY, -1, -1, 0.0};
    else fault = unit->stepper->run.fault;
    if (fault.status == EM_FINISHED) return 0;
    em_unit_close(unit);
    return em_unit_fail(unit, &fault, unit->t_start);
}

/* Opens the stepper unless it is open. 0, or -1 and words: no motion starts there. */
static int em_unit_open(em_unit *unit) {
    if (unit->stepper != NULL) return 0;
    const em_model *m = unit->model;
    const size_t c = (size_t)m->n_prepared, y = (size_t)m->n_state;
    double *const memory = calloc(c + y + (size_t)m->n, sizeof *memory);
    const em_fault none = {EM_OUT_OF_MEMORY, -1, -1, 0.0};
    if (memory == NULL) return em_unit_fail(unit, &none, unit->t_start);
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

/* out (n_outputs) <- the model's outputs. 0, or -1 and words. */
static int em_unit_outputs(em_unit *unit, double *out) {
    em_fault fault;
    if (em_unit_open(unit)) return -1;
    const em_stepper *s = unit->stepper;
    if (!s->model->output(s->t, s->x, s->v, s->run.prepared, em_unit_u(unit), 0, out, &fault)) return 0;
    return em_unit_fail(unit, &fault, s->t);
}

/* The place of a number given among the arguments of derivatives: x, v, inputs, parameters, time. */
static size_t em_unit_argument(const em_model *m, unsigned reference) {
    const unsigned p = (unsigned)m->n_parameters, states = 2 * (unsigned)m->n;
    if (reference < p) return states + (unsigned)m->n_inputs + reference;
    return reference - p; /* x, v and inputs follow each other there, too */
}

/* The change of one number along `d` (n_arguments), of which a and lambda change by `da` (n + m); D: em_model.output_partials */
static double em_unit_change(const em_unit *unit, unsigned reference, const double *d, const double *da, const double *D) {
    const em_model *m = unit->model;
    const size_t given = em_unit_given(m), reactions = (size_t)(m->n + m->m), width = reactions + (size_t)m->n_arguments;
    if (reference < given) return d[em_unit_argument(m, reference)];
    double sum = 0.0;
    for (size_t k = 0; k < width; ++k) sum += D[(reference - given) * width + k] * (k < reactions ? da[k] : d[k - reactions]);
    return sum;
}

/* changes (unknowns) of numbers where the motion stands, along `d` (n_arguments), exactly; work: em_unit_partials numbers.
 * 0, or -1 and *fault. */
static int em_unit_changes(const em_unit *unit, const unsigned *unknown, size_t unknowns, const double *d, double *work,
                           double *changes, em_fault *fault) {
    const em_model *const m = unit->model;
    const em_stepper *const s = unit->stepper;
    const int reactions = m->n + m->m, arguments = m->n_arguments;
    double *const a = work, *const along = a + reactions, *const slopes = along + reactions;
    double *const D = slopes + reactions * arguments;
    if (m->motion_derivatives(s->t, s->x, s->v, s->run.prepared, em_unit_u(unit), 0, a, a + m->n, slopes,
                              slopes + m->n * arguments, fault))
        return -1;
    if (m->n_outputs > 0) m->output_partials(s->t, s->x, s->v, a, a + m->n, s->run.prepared, em_unit_u(unit), D);
    for (int row = 0; row < reactions; ++row) {
        along[row] = 0.0;
        for (int k = 0; k < arguments; ++k) along[row] += slopes[row * arguments + k] * d[k];
    }
    for (size_t k = 0; k < unknowns; ++k) changes[k] = em_unit_change(unit, unknown[k], d, along, D);
    return 0;
}

static size_t em_unit_partials(const em_model *m) {
    const size_t reactions = (size_t)(m->n + m->m), arguments = (size_t)m->n_arguments;
    return 2 * reactions + reactions * arguments + (size_t)m->n_outputs * (reactions + arguments);
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

/* changes (unknowns) of outputs, coordinates and rates along dknown (count) of numbers given. 0, or -1 and words. */
static int em_unit_along(em_unit *unit, const unsigned *unknown, size_t unknowns, const unsigned *known, size_t count,
                         const double *dknown, double *changes) {
    const em_model *const m = unit->model;
    const size_t given = em_unit_given(m), all = given + (size_t)m->n_outputs;
    if (em_unit_check(unit, unknown, unknowns, (size_t)m->n_parameters, all) || em_unit_check(unit, known, count, 0, given) ||
        em_unit_open(unit))
        return -1;
    em_fault fault = {EM_OUT_OF_MEMORY, -1, -1, 0.0};
    double *const work = calloc((size_t)m->n_arguments + em_unit_partials(m), sizeof *work);
    if (work == NULL) return em_unit_fail(unit, &fault, unit->stepper->t);
    for (size_t k = 0; k < count; ++k) work[em_unit_argument(m, known[k])] += dknown[k];
    const int failed = em_unit_changes(unit, unknown, unknowns, work, work + m->n_arguments, changes, &fault);
    free(work);
    return failed ? em_unit_fail(unit, &fault, unit->stepper->t) : 0;
}

/* One of those given, or x or v as they are now. */
static double em_unit_number(const em_unit *unit, unsigned reference) {
    const unsigned p = (unsigned)unit->model->n_parameters, n = (unsigned)unit->model->n;
    if (unit->stepper == NULL || reference < p || reference >= p + 2 * n) return unit->given[reference];
    return reference < p + n ? unit->stepper->x[reference - p] : unit->stepper->v[reference - p - n];
}

/* value (count) <- numbers and outputs by their references. 0, or -1 and words. */
static int em_unit_read(em_unit *unit, const unsigned *reference, size_t count, double *value) {
    const unsigned given = (unsigned)em_unit_given(unit->model), n = (unsigned)unit->model->n_outputs;
    double *outputs = NULL;
    int failed = 0;
    for (size_t k = 0; k < count && !failed; ++k) {
        if (reference[k] < given) {
            value[k] = em_unit_number(unit, reference[k]);
        } else if (reference[k] < given + n) {
            if (outputs == NULL) {
                outputs = calloc(n, sizeof *outputs);
                failed = outputs == NULL || em_unit_outputs(unit, outputs);
            }
            if (!failed) value[k] = outputs[reference[k] - given];
        } else {
            failed = em_words_of_no_reference(reference[k], unit->words);
        }
    }
    free(outputs);
    return failed ? -1 : 0;
}

static int em_unit_advance(em_unit *unit, double t) {
    if (em_unit_open(unit)) return -1;
    if (!em_stepper_advance(unit->stepper, t, em_unit_u(unit))) return 0;
    return em_unit_fail(unit, &unit->stepper->run.fault, unit->stepper->t);
}

/* --- all of it in one block of memory that can be moved --- */

typedef struct em_unit_state {
    int steps, open;
    double t_start, rtol;
} em_unit_state;

static size_t em_unit_size(const em_unit *unit) {
    const em_model *m = unit->model;
    return sizeof(em_unit_state) + em_unit_given(m) * sizeof(double) + m->saved() + (size_t)m->n_inputs * sizeof(double);
}

static void em_unit_save(const em_unit *unit, void *saved) {
    const size_t numbers = em_unit_given(unit->model) * sizeof(double);
    const em_unit_state state = {unit->steps, unit->stepper != NULL, unit->t_start, unit->rtol};
    char *const place = saved;
    memcpy(place, &state, sizeof state);
    memcpy(place + sizeof state, unit->given, numbers);
    if (state.open) em_stepper_save(unit->stepper, place + sizeof state + numbers);
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
    em_stepper_restore(unit->stepper, place + sizeof state + numbers);
    return 0;
}

#endif
