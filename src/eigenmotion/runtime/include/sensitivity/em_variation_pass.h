/* em_variation_pass.h: the task and the memory of one integration ("pass") of the variational equations
 * (em_variations.h). */
#ifndef EM_VARIATION_PASS_H
#define EM_VARIATION_PASS_H

#include <stdlib.h>

#include "stepper/em_time_events.h"
#include "numeric/em_elimination.h"
#include "stepper/em_signals.h"

struct em_tape;

#define EM_JUMP_ROUNDING 1e-9 /* a jump of accelerations that is smaller than this part of them is rounding */

/* Reasons for the end of a pass, apart from faults of the model. */
enum {
    EM_BY_FAULT, EM_EVENTS_MEET, EM_EVENT_GRAZES, EM_OTHER_MOTION, EM_TIME_EVENTS_MEET, EM_ROWS_BREAK, EM_JUMPS_MEET,
    EM_FORCE_JUMPS, EM_UNRESOLVED, EM_TIME_EVENT_MEETS, EM_CONE_STOPS
};

enum { EM_GLOBAL_PROBES = 1 }; /* of a pass with a tape: columns from the start on; the others are drawn at every step */

enum { EM_CHART_CHANGE = -1 }; /* in place of the event of a mark: a change of rotation parameters */

enum { EM_VARIATION_NODES = 8, EM_BY_ELIMINATION = 64 /* unknowns of a direction up to which elimination is cheaper */ };

/* Stops are the start, events, changes of rotation parameters, and the end: t, z (n_stops, 2 n) = x, v. If the state
 * changes at a stop, the next stop is the state after that. Between two stops are `spans`, intervals from `from` to `to` in which no signal has a kink and
 * no time event happens. Marks are events and such changes, in the order of their stops. P (n_forcing, columns). */
typedef struct em_variations {
    const em_model *model;
    const em_run *run;       /* its dense output is the motion between stops */
    const double *c;         /* at the first stop */
    const em_signal *inputs;
    int columns, least_norm, stabilise, n_forcing;
    double direction, tolerance, initial_steps; /* initial_steps: initial length of a step here, in steps of the run */
    size_t n_stops, n_marks, n_spans, n_rows;
    const double *t, *z, *P;
    const long *spans, *mark_stop;
    const int *mark_event;
    const double *from, *to;               /* (n_spans) */
    const double *place, *A, *A2, *series; /* of the nodes in a step; A, and its square; the map from values to the
                                              Legendre series */
    const double *t_rows;                  /* (n_rows), in the direction of time */
    double *S, *dt;                        /* (n_stops, 2 n, columns), row 0 is input; (n_marks, columns): of times
                                              of events */
    double *rows;                          /* (n_rows, 2 n, columns), at t_rows, if these lie within steps */
    size_t n_steps, n_refused, n_own_motion;   /* <- numbers of steps: made, shortened, with their own motion */
    int (*poll)(void *);
    void *poll_argument;
    em_fault fault;
    int why;
    double t_reached;
} em_variations;

/* Derivatives (columns) of the time at which a cone stops: those with the least doubt, and the last predicted; NaN:
 * none. doubt: by how much predictions differ. */
typedef struct em_cone_stop {
    double *dt, *last, doubt;
} em_cone_stop;

/* Working memory of a pass. Directions are rows of `columns` numbers. The last column is for additional directions
 * (the motion itself, or its Newton correction); zeros before it pad the columns to a multiple of four: S (2 n,
 * columns) and P (n_forcing, columns), whose non-zero entries `nonzeros` lists as (row, column). z is the current
 * state; L the linear system with its right-hand sides, in `rows`; `inside`: times between which the model is evaluated
 * (em_time_events.h). At the nodes of a step: Z (2 n), a (n), J (n, n_arguments), K = S_v' and G, the part of it
 * that does not depend on K (n, columns). At the start of a step: S0, K0, J0, a0, and T0, the sum of the absolute
 * values of the terms of K; T, at its end. K_rounding (n, columns), a_rounding (n): the rounding of K and a.
 * units (n), B (n, n): of coordinates, and their couplings, in the linear system of a step. shift (n, columns): the
 * parts along the motion that directions have lost for this step (em_variation_motion.h); drive0, drive (n; nodes, n): the
 * partial derivative of a with respect to time, inputs included; jerk (nodes + 1, n); M (n, n), at the start; shift_error
 * (2 n), of the last step. */
typedef struct em_pass {
    em_variations *of;
    int n, m, columns, wide, n_nonzeros, (*nonzeros)[2];
    double *S, *z, *P, *u, *a, *lambda, *dlambda, *c, *J, *L, *K, *G, *Y, *W, **rows;
    double *Z, *off, *S0, *K0, *J0, *a0, *T0, *T, *K_rounding, *a_rounding, *units, *B, *y, *predictions,
        *shift, *drive0, *drive, *jerk, *M, *shift_error;
    em_cone_stop *of_stops; /* (n_switches) */
    double origin[EM_VARIATION_NODES]; /* weights of a series at the start of a step, from values at nodes */
    double inside[2], h, h_within;     /* the length of the next step that follows from the last one; with rows in it */
    size_t row;
    double longest;                         /* of the accepted steps */
    int n_least, n_crawling, n_again; /* n_again: rejected since a step of about the longest length */
    int by_rounding, own_motion;      /* of the step: only rounding explains its error; it has its own motion */
    int apart;                        /* of the step: not all coordinates of a direction are shifted */
    em_pile *pile;
    long *piece;
    struct em_tape *tape;                   /* stores the maps of the pass, or NULL (em_derivative_tape.h) */
    struct em_pass *over_basis, *records_for; /* with a tape: the pass over a basis; of that pass: the one with the tape */
} em_pass;

static int em_end_pass(em_variations *w, int why, int first, int second) {
    w->why = why;
    return em_fail(&w->fault, EM_NON_FINITE_STATE, first, second, NAN);
}

static double em_signal_rate(const em_signal *u, long piece, double t) {
    const long last = (long)u->count - 1;
    if (u->kind == EM_LINEAR && piece >= 0 && piece < last)
        return (u->values[piece + 1] - u->values[piece]) / (u->times[piece + 1] - u->times[piece]);
    if (u->kind != EM_CUBIC || t < u->times[0] || t > u->times[last]) return 0.0;
    long at = em_signal_interval(u, t, 1.0);
    if (at > last - 1) at = last - 1;
    const double *b = u->values + 4 * at, x = t - u->times[at];
    return (3.0 * b[0] * x + 2.0 * b[1]) * x + b[2];
}

/* The inputs at t, and their rates, which the direction of the motion itself needs. */
static void em_pass_inputs(em_pass *p, double t) {
    for (int i = 0; i < p->of->model->n_inputs; ++i) {
        p->u[i] = em_signal_at(&p->of->inputs[i], p->piece[i], t);
        p->P[i * p->columns + p->columns - 1] = em_signal_rate(&p->of->inputs[i], p->piece[i], t);
    }
}

/* The intervals of inputs that hold after t. Returns whether they have changed. */
static int em_pass_pieces(em_pass *p, double t) {
    int other = 0;
    for (int i = 0; i < p->of->model->n_inputs; ++i) {
        const long piece = em_signal_interval(&p->of->inputs[i], t, p->of->direction);
        other |= piece != p->piece[i];
        p->piece[i] = piece;
    }
    return other;
}

/* The time at which the model is evaluated for time t. */
static double em_pass_clock(const em_pass *p, double t) { return fmin(fmax(t, p->inside[0]), p->inside[1]); }

/* rate (2 n) <- (v, a) at z. */
static int em_motion_rate(em_pass *p, double t, const double *z, double *rate) {
    em_variations *const w = p->of;
    em_pass_inputs(p, t);
    memcpy(rate, z + p->n, p->n * sizeof *rate);
    return w->model->acceleration(em_pass_clock(p, t), z, z + p->n, p->c, p->u, w->least_norm, rate + p->n, p->lambda, &w->fault);
}

/* The last direction <- that of the motion itself, with rates (2 n). */
static void em_set_last(em_pass *p, const double *rate) {
    for (int i = 0; i < 2 * p->n; ++i) p->S[i * p->columns + p->columns - 1] = rate[i];
}

#endif
