/* em_inverse_unit.h: the forces of a motion that is given number by number: the content of an FMU of inverse dynamics.
 *
 * Its numbers have references, one after the other: parameters; x, v, a; inputs; forces of the actuators; the model's
 * outputs. The motion of the independent coordinates is given, and that of the others follows from the constraints, on
 * the branch of the position at the last communication point: what is set in between has no effect on it. */
#ifndef EM_INVERSE_UNIT_H
#define EM_INVERSE_UNIT_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "em_unit_words.h"
#include "em_branch.h"
#include "inverse_dynamics/em_sliding.h"
#include "tables/em_table_ranges.h"

#define EM_UNIT_ROUNDED 1e3 /* a residual is rounding if changes of x, v, a in the last place change it by this part of it */

/* What is asked of every unit. */
typedef struct em_unit_options {
    em_actuators actuators;   /* by name, count > 0 */
    const int *is_given;      /* (n) 1 for coordinates whose motion is given */
    const double *v;          /* (n) at the start */
} em_unit_options;

typedef struct em_unit {
    const em_model *model;
    em_unit_options options;
    int steps, current;       /* whether initialisation is over; whether what is calculated belongs to what is given */
    double t, t_last, usual;  /* time; that of `last`; the least pivot of A_D (em_branch.h) at the start */
    double *numbers;          /* by their references */
    double *last;             /* (n) x at the last communication point, or a guess before the first */
    double *c, *unit;         /* (n_prepared), in the mode of the motion; (n) units of coordinates */
    int *dependent, d;        /* coordinates that follow from the constraints */
    char words[EM_WORDS];     /* what went wrong last */
} em_unit;

static double *em_unit_x(const em_unit *unit) { return unit->numbers + unit->model->n_parameters; }
static double *em_unit_v(const em_unit *unit) { return em_unit_x(unit) + unit->model->n; }
static double *em_unit_a(const em_unit *unit) { return em_unit_v(unit) + unit->model->n; }
static double *em_unit_u(const em_unit *unit) { return em_unit_a(unit) + unit->model->n; }
static double *em_unit_forces(const em_unit *unit) { return em_unit_u(unit) + unit->model->n_inputs; }
static double *em_unit_observed(const em_unit *unit) { return em_unit_forces(unit) + unit->options.actuators.count; }

static size_t em_unit_numbers(const em_unit *unit) {
    const em_model *m = unit->model;
    return (size_t)(m->n_parameters + 3 * m->n + m->n_inputs + unit->options.actuators.count + m->n_outputs);
}

static int em_unit_coordinates(const em_unit *unit) { return unit->model->n - unit->model->n_states; }

static void em_unit_begin(em_unit *unit, double t, double rtol) {
    (void)rtol; /* nothing is integrated */
    unit->t = unit->t_last = t;
    unit->current = unit->steps = 0;
}

static double em_unit_time(const em_unit *unit) { return unit->t; }

/* The model's own values. */
static void em_unit_reset(em_unit *unit) {
    const em_model *m = unit->model;
    em_unit_begin(unit, 0.0, 0.0);
    unit->usual = 0.0;
    memset(unit->numbers, 0, em_unit_numbers(unit) * sizeof *unit->numbers);
    if (m->n_parameters) memcpy(unit->numbers, m->parameter_defaults, (size_t)m->n_parameters * sizeof(double));
    memcpy(em_unit_x(unit), m->initial_x, (size_t)m->n * sizeof(double));
    memcpy(em_unit_v(unit), unit->options.v, (size_t)m->n * sizeof(double));
    if (m->n_inputs) memcpy(em_unit_u(unit), m->input_defaults, (size_t)m->n_inputs * sizeof(double));
    memcpy(unit->last, m->initial_x, (size_t)m->n * sizeof(double));
}

static void em_unit_free(em_unit *unit) {
    if (unit == NULL) return;
    free(unit->numbers);
    free(unit->dependent);
    free(unit);
}

/* NULL without memory. */
static em_unit *em_unit_create(const em_model *model, em_unit_options options) {
    em_unit *unit = calloc(1, sizeof *unit);
    if (unit == NULL) return NULL;
    unit->model = model;
    unit->options = options;
    const size_t numbers = em_unit_numbers(unit), n = (size_t)model->n;
    unit->numbers = calloc(numbers + 2 * n + (size_t)model->n_prepared, sizeof *unit->numbers);
    unit->dependent = calloc(n, sizeof *unit->dependent);
    if (unit->numbers == NULL || unit->dependent == NULL) return em_unit_free(unit), NULL;
    unit->last = unit->numbers + numbers, unit->unit = unit->last + n, unit->c = unit->unit + n;
    for (int k = 0; k < em_unit_coordinates(unit); ++k)
        if (!options.is_given[k]) unit->dependent[unit->d++] = k;
    em_unit_reset(unit);
    return unit;
}

/* --- words --- */

static int em_unit_fail(em_unit *unit, const em_fault *fault) {
    return em_words_of_fault(unit->model, fault, unit->t, unit->words);
}

/* Adds to the words. */
static void em_unit_add(em_unit *unit, const char *more, const char *name) {
    const size_t used = strlen(unit->words);
    snprintf(unit->words + used, sizeof unit->words - used, "%s%s", more, name);
}

static const char *em_unit_actuator(const em_unit *unit, int k) {
    const em_actuators *of = &unit->options.actuators;
    return of->input[k] < 0 ? unit->model->coordinates[of->coordinate[k]] : unit->model->inputs[of->input[k]];
}

/* Adds a constraint, by its name if it has one. */
static void em_unit_add_row(em_unit *unit, int row) {
    char number[24];
    const int named = unit->model->rows != NULL && unit->model->rows[row][0] != '\0';
    snprintf(number, sizeof number, "number %d", row);
    em_unit_add(unit, " constraint ", named ? unit->model->rows[row] : number);
}

/* --- positions, rates and accelerations of the dependent coordinates --- */

/* -1, and words: x is where the dependent coordinates are not determined, or do not close. */
static int em_unit_stuck(em_unit *unit, const em_branch *of, double t, const double *x, em_branch_rows *at) {
    const em_model *m = unit->model;
    double loose[unit->d], most = 0.0, residual = 0.0;
    const double least = em_branch_independence(of, t, x, at, loose);
    int others = 0;
    if (least > 0.03 * unit->usual && least > EM_BRANCH_SINGULAR) {
        snprintf(unit->words, sizeof unit->words, "at t = %.9g: the mechanism does not close:", t);
        const int row = em_branch_open_row(of, t, x, at, &residual);
        em_unit_add_row(unit, row < 0 ? 0 : row);
        em_unit_add(unit, " stays open. The given coordinates are out of its reach", "");
        return -1;
    }
    for (int j = 0; j < unit->d; ++j) most = fmax(most, fabs(loose[j]));
    snprintf(unit->words, sizeof unit->words, "at t = %.9g: a dead centre, at which", t);
    for (int k = 0; k < em_unit_coordinates(unit); ++k)
        if (unit->options.is_given[k]) em_unit_add(unit, others++ ? " and " : " ", m->coordinates[k]);
    em_unit_add(unit, others > 1 ? " do not determine" : " does not determine", "");
    others = 0;
    for (int j = 0; j < unit->d; ++j)
        if (fabs(loose[j]) > 0.01 * most) em_unit_add(unit, others++ ? " and " : " ", m->coordinates[unit->dependent[j]]);
    return -1;
}

/* Whether a guess of the dependent coordinates was set. */
static int em_unit_is_guessed(const em_unit *unit) {
    for (int j = 0; j < unit->d; ++j)
        if (unit->last[unit->dependent[j]] != unit->model->initial_x[unit->dependent[j]]) return 1;
    return 0;
}

/* x (n) <- the position: from the last one, or at first from a guess, or from the model's own start. 0, or -1 and words. */
static int em_unit_follow(em_unit *unit, const em_branch *of, double *x, em_branch_rows *at) {
    const int n = unit->model->n;
    double from[n], loose[unit->d];
    const double *const given = em_unit_x(unit);
    const int begins = !unit->steps, guessed = begins && em_unit_is_guessed(unit);
    const em_line line = {{begins ? unit->t : unit->t_last, unit->t}, {from, given}};
    memcpy(from, begins ? unit->model->initial_x : unit->last, sizeof from);
    memcpy(x, guessed ? given : from, sizeof from);
    for (int j = 0; j < unit->d && guessed; ++j) x[unit->dependent[j]] = unit->last[unit->dependent[j]];
    if (begins && em_branch_close(of, unit->t, x, 1.0, EM_GUESS_CORRECTIONS, at)) /* the start may be rough, too */
        return em_unit_stuck(unit, of, unit->t, x, at);
    if (begins) unit->usual = em_branch_independence(of, unit->t, x, at, loose);
    int rests = line.t[0] == line.t[1];
    for (int k = 0; k < em_unit_coordinates(unit); ++k) rests &= !unit->options.is_given[k] || x[k] == given[k];
    if (rests) return 0;
    const double reached = em_branch_follow(of, &line, x);
    return reached == 1.0 ? 0 : em_unit_stuck(unit, of, em_on_line(line.t[0], line.t[1], reached), x, at);
}

/* unit (n) of coordinates, at the last position. */
static void em_unit_scales(em_unit *unit) {
    const em_model *m = unit->model;
    double M[m->n * m->n];
    (m->factored_matrix ? m->factored_matrix : m->mass_matrix)(unit->t, unit->last, unit->c, M);
    for (int k = 0; k < m->n; ++k) unit->unit[k] = M[k * m->n + k] > 0.0 ? 1.0 / sqrt(M[k * m->n + k]) : 1.0;
}

/* x, v, a (n) <- the whole motion. 0, or -1 and words. */
static int em_unit_motion(em_unit *unit, double *x, double *v, double *a) {
    const em_model *m = unit->model;
    const int n = m->n, d = unit->d;
    memcpy(x, em_unit_x(unit), (size_t)n * sizeof *x);
    memcpy(v, em_unit_v(unit), (size_t)n * sizeof *v);
    memcpy(a, em_unit_a(unit), (size_t)n * sizeof *a);
    if (d == 0) return 0;
    double memory[m->m * (n + d + 2)], rate[m->m], r[n], loose[d];
    int chosen[d];
    em_branch_rows at = {memory, memory + m->m * d, memory + m->m * (d + 1), memory + m->m * (d + 2), chosen};
    const em_branch of = {m, unit->c, d, unit->dependent, unit->unit};
    if (em_unit_follow(unit, &of, x, &at)) return -1;
    const double least = em_branch_independence(&of, unit->t, x, &at, loose);
    if (!(least > EM_BRANCH_SINGULAR)) return em_unit_stuck(unit, &of, unit->t, x, &at);
    for (int j = 0; j < d; ++j) v[unit->dependent[j]] = a[unit->dependent[j]] = 0.0;
    for (int i = 0; i < m->m; ++i) rate[i] = at.b[i] + em_inner(n, at.A + i * n, v);
    em_branch_dependent(&of, &at, rate, v);
    m->required_forces(unit->t, x, v, a, unit->c, em_unit_u(unit), r, rate);
    em_branch_dependent(&of, &at, rate, a);
    return 0;
}

/* --- forces --- */

/* What inverse dynamics says of a motion. */
typedef struct em_asked {
    double *forces, *lambda, *residual;
    em_inverse_check check;
} em_asked;

static int em_unit_ask(em_unit *unit, const double *x, const double *v, const double *a, em_asked *of) {
    em_fault fault;
    if (!unit->model->inverse_dynamics(unit->t, x, v, a, unit->c, em_unit_u(unit), &unit->options.actuators, of->forces,
                                       of->lambda, of->residual, &of->check, &fault))
        return 0;
    return em_unit_fail(unit, &fault);
}

/* The residual of a constraint in one of its equations. */
static double em_unit_residual(const em_unit *unit, const double *x, const double *v, const double *a, int equation, int row) {
    const em_model *m = unit->model;
    double A[m->m * m->n + 1], b[m->m + 1], r[m->n];
    b[row] = 0.0;
    if (equation == EM_OF_POSITION) m->position(unit->t, x, unit->c, b, A);
    if (equation == EM_OF_VELOCITY) m->pfaffian(unit->t, x, unit->c, A, b), b[row] += em_inner(m->n, A + row * m->n, v);
    if (equation == EM_OF_ACCELERATION) m->required_forces(unit->t, x, v, a, unit->c, em_unit_u(unit), r, b);
    return b[row];
}

/* Whether what is left of a constraint (row >= 0), or of the required forces, is of the size of its changes if x, v and a
 * change by a few units in the last place. */
static int em_unit_is_rounding(em_unit *unit, const double *x, const double *v, const double *a, const em_asked *found) {
    enum { TRIES = 4, SPREAD = 9 };
    const int n = unit->model->n, rows = found->check.forbidden > EM_ALLOWED, row = found->check.row;
    const double *const all[3] = {x, v, a};
    double near[3 * n], lambda[unit->model->m + 1], residual[n], forces[unit->options.actuators.count];
    double changed = 0.0, size = 0.0;
    const double left = rows ? em_unit_residual(unit, x, v, a, found->check.equation, row) : 0.0;
    for (int k = 0; k < n; ++k) size = rows ? fabs(left) : fmax(size, fabs(found->residual[k]));
    for (int try = 1; try <= TRIES; ++try) {
        em_asked other = {.forces = forces, .lambda = lambda, .residual = residual};
        for (int k = 0; k < 3 * n; ++k)
            near[k] = all[k / n][k % n] * (1.0 + ((k + 1) * (2 * try + 3) % SPREAD - SPREAD / 2) * DBL_EPSILON);
        if (rows) {
            const double here = em_unit_residual(unit, near, near + n, near + 2 * n, found->check.equation, row);
            changed = fmax(changed, fabs(here - left));
        } else {
            if (em_unit_ask(unit, near, near + n, near + 2 * n, &other)) return 0;
            for (int k = 0; k < n; ++k) changed = fmax(changed, fabs(residual[k] - found->residual[k]));
        }
    }
    return size <= EM_UNIT_ROUNDED * changed;
}

/* -1, and words: a constraint does not allow the motion, or no actuator drives it. */
static int em_unit_refuse(em_unit *unit, const em_asked *found) {
    static const char *const what[] = {"positions", "velocities", "accelerations"};
    int k = 0, worst = 0;
    snprintf(unit->words, sizeof unit->words, "at t = %.9g: ", unit->t);
    if (found->check.forbidden > EM_ALLOWED) {
        em_unit_add(unit, "the ", what[found->check.equation]);
        em_unit_add(unit, " do not satisfy", "");
        em_unit_add_row(unit, found->check.row);
        return -1;
    }
    for (; k < unit->options.actuators.count; ++k) em_unit_add(unit, k ? " and " : "", em_unit_actuator(unit, k));
    for (k = 0; k < em_unit_coordinates(unit); ++k)
        if (fabs(found->residual[k]) * unit->unit[k] > fabs(found->residual[worst]) * unit->unit[worst]) worst = k;
    em_unit_add(unit, " cannot drive this motion: a force is missing on ", unit->model->coordinates[worst]);
    return -1;
}

/* Whether a number of a table or of a symbol is none that it takes; then words. */
static int em_unit_outside(em_unit *unit, const double *x, const double *v) {
    const em_model *m = unit->model;
    double at[m->n_table_uses + 1];
    em_fault fault;
    for (int j = 0; j < unit->d; ++j)
        if (em_words_of_value(m, m->n_parameters + unit->dependent[j], x[unit->dependent[j]], unit->words)) return 1;
    if (m->table_arguments == NULL) return 0;
    m->table_arguments(unit->t, x, v, unit->c, em_unit_u(unit), at);
    return em_outside_tables(m, unit->c, at, &fault) && em_unit_fail(unit, &fault);
}

/* The model's outputs at the whole motion, with the forces as inputs. 0, or -1 and words. */
static int em_unit_observe(em_unit *unit, const double *x, const double *v, double *a, const double *lambda) {
    const em_model *m = unit->model;
    const em_actuators *of = &unit->options.actuators;
    double r[m->n], s[m->m + 1], *const out = em_unit_observed(unit);
    for (int k = 0; k < of->count; ++k)
        if (of->input[k] >= 0) em_unit_u(unit)[of->input[k]] = em_unit_forces(unit)[k];
    if (m->n_outputs == 0) return 0;
    m->required_forces(unit->t, x, v, a, unit->c, em_unit_u(unit), r, s);
    for (int k = em_unit_coordinates(unit); k < m->n; ++k) a[k] = m->m ? NAN : -r[k]; /* reactions might change them */
    m->observe(unit->t, x, v, a, lambda, unit->c, em_unit_u(unit), out);
    for (int k = em_unit_coordinates(unit); k < m->n; ++k) a[k] = 0.0;
    for (int k = 0; k < m->n_outputs; ++k) {
        if (isfinite(out[k])) continue;
        snprintf(unit->words, sizeof unit->words, "at t = %.9g: output %s has no value", unit->t, m->outputs[k]);
        return -1;
    }
    return 0;
}

/* What is calculated <- of what is given. 0, or -1 and words. */
static int em_unit_calculate(em_unit *unit) {
    const em_model *m = unit->model;
    const int n = m->n;
    double x[n], v[n], a[n], lambda[m->m + 1], residual[n];
    em_asked asked = {.forces = em_unit_forces(unit), .lambda = lambda, .residual = residual};
    em_fault fault;
    if (m->prepare(unit->numbers, unit->c, &fault)) return em_unit_fail(unit, &fault);
    em_unit_scales(unit);
    if (em_unit_motion(unit, x, v, a) || em_unit_outside(unit, x, v)) return -1;
    if (em_slide_along(m, unit->t, x, v, a, em_unit_u(unit), &unit->options.actuators, unit->c, &fault))
        return em_unit_fail(unit, &fault);
    if (em_unit_ask(unit, x, v, a, &asked)) return -1;
    if ((asked.check.forbidden > EM_ALLOWED || asked.check.undriven > EM_DRIVEN) &&
        !em_unit_is_rounding(unit, x, v, a, &asked))
        return em_unit_refuse(unit, &asked);
    if (em_unit_observe(unit, x, v, a, lambda)) return -1;
    memcpy(em_unit_x(unit), x, sizeof x);
    memcpy(em_unit_v(unit), v, sizeof v);
    memcpy(em_unit_a(unit), a, sizeof a);
    return 0;
}

static int em_unit_evaluate(em_unit *unit) {
    if (!unit->current && em_unit_calculate(unit)) return -1;
    unit->current = 1;
    return 0;
}

/* The position becomes that of a communication point. */
static void em_unit_keep(em_unit *unit) {
    memcpy(unit->last, em_unit_x(unit), (size_t)unit->model->n * sizeof *unit->last);
    unit->t_last = unit->t;
}

/* The end of initialisation. 0, or -1 and words. */
static int em_unit_enter(em_unit *unit) {
    if (unit->steps) return 0;
    if (em_unit_evaluate(unit)) return -1;
    unit->steps = 1;
    em_unit_keep(unit);
    return 0;
}

/* To another time, with the motion that is given. 0, or -1 and words: it stays where it is. */
static int em_unit_advance(em_unit *unit, double t) {
    const double before = unit->t;
    if (!isfinite(t)) return snprintf(unit->words, sizeof unit->words, "the time is not finite"), -1;
    if (em_unit_enter(unit)) return -1;
    unit->current &= t == before;
    unit->t = t;
    if (!em_unit_evaluate(unit)) return em_unit_keep(unit), 0;
    unit->t = before;
    return -1;
}

/* --- numbers --- */

/* Whether a number is given, and may be so now; *place <- as one that may be declared, or -1. */
static int em_unit_takes(const em_unit *unit, unsigned reference, int *place) {
    const em_model *m = unit->model;
    const int p = m->n_parameters, n = m->n, at = (int)reference, u = at - p - 3 * n;
    *place = at < p + n ? at : u >= 0 ? p + n + u : -1;
    if (at < p) return !unit->steps;
    if (u >= m->n_inputs || at < 0) return 0;
    if (u >= 0) {
        for (int k = 0; k < unit->options.actuators.count; ++k)
            if (unit->options.actuators.input[k] == u) return 0;
        return 1;
    }
    const int k = (at - p) % n, order = (at - p) / n;
    if (k >= em_unit_coordinates(unit)) return order == 1; /* the value of a state */
    return unit->options.is_given[k] || (order == 0 && !unit->steps);
}

/* A number by its reference. 0, or -1 and words. */
static int em_unit_set(em_unit *unit, unsigned reference, double value) {
    int place;
    if (!isfinite(value) || !em_unit_takes(unit, reference, &place)) {
        const int fixed = unit->steps && reference < (unsigned)(unit->model->n_parameters + unit->model->n);
        snprintf(unit->words, sizeof unit->words, "value reference %u: %s", reference,
                 !isfinite(value) ? "not a finite number"
                 : fixed          ? "parameters and guesses of positions are fixed after initialisation"
                                  : "no number that can be set");
        return -1;
    }
    if (em_words_of_value(unit->model, place, value, unit->words)) return -1;
    const int k = (int)reference - unit->model->n_parameters;
    if (k >= 0 && k < em_unit_coordinates(unit) && !unit->options.is_given[k]) unit->last[k] = value;
    unit->numbers[reference] = value;
    unit->current = 0;
    return 0;
}

/* Whether a number follows from those that are given. */
static int em_unit_is_calculated(const em_unit *unit, unsigned reference) {
    const int n = unit->model->n, at = (int)reference - unit->model->n_parameters;
    if (at < 0 || at >= 3 * n) return at >= 3 * n + unit->model->n_inputs;
    return at % n < em_unit_coordinates(unit) && !unit->options.is_given[at % n];
}

/* value (count) <- numbers by their references. 0, or -1 and words. */
static int em_unit_read(em_unit *unit, const unsigned *reference, size_t count, double *value) {
    for (size_t k = 0; k < count; ++k) {
        if (reference[k] >= em_unit_numbers(unit)) return em_words_of_no_reference(reference[k], unit->words);
        if (em_unit_is_calculated(unit, reference[k]) && em_unit_evaluate(unit)) return -1;
        value[k] = unit->numbers[reference[k]];
    }
    return 0;
}

static int em_unit_along(em_unit *unit, const unsigned *unknown, size_t unknowns, const unsigned *known, size_t count,
                         const double *dknown, double *changes) {
    (void)unknown, (void)unknowns, (void)known, (void)count, (void)dknown, (void)changes;
    return snprintf(unit->words, sizeof unit->words, "a unit of inverse dynamics has no directional derivatives"), -1;
}

/* --- all of it in one block of memory that can be moved --- */

typedef struct em_unit_state {
    int steps, current;
    double t, t_last, usual;
} em_unit_state;

static size_t em_unit_size(const em_unit *unit) {
    return sizeof(em_unit_state) + (em_unit_numbers(unit) + (size_t)unit->model->n) * sizeof(double);
}

static void em_unit_save(const em_unit *unit, void *saved) {
    const em_unit_state state = {unit->steps, unit->current, unit->t, unit->t_last, unit->usual};
    memcpy(saved, &state, sizeof state);
    memcpy((char *)saved + sizeof state, unit->numbers, em_unit_size(unit) - sizeof state); /* `last` is behind them */
}

static int em_unit_restore(em_unit *unit, const void *saved) {
    em_unit_state state;
    memcpy(&state, saved, sizeof state);
    memcpy(unit->numbers, (const char *)saved + sizeof state, em_unit_size(unit) - sizeof state);
    unit->steps = state.steps, unit->current = state.current;
    unit->t = state.t, unit->t_last = state.t_last, unit->usual = state.usual;
    return 0;
}

#include "em_no_flow.h"

#endif
