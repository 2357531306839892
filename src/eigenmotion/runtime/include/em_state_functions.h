/* em_state_functions.h: functions of a state that a stepper calls: rates, velocities, errors, each according to the
 * state's mode (docs/architecture.md).
 *
 * Included by eigenmotion.h alone, whose conventions apply here. `mode` 0 is the published system, 1 the triangular
 * root. */
#ifndef EM_STATE_FUNCTIONS_H
#define EM_STATE_FUNCTIONS_H

#include "em_run.h"

struct em_act_limits;
struct em_pile;

/* Flags are those of em_linear.h; memory (n_memory) belongs to the run. */
typedef struct em_dynamics {
    int n_C, n_s, n_C_delta, n_s_delta; /* y = x (n), eta or v (n), C, s, C_delta, s_delta */
    int n_memory;                       /* numbers that a run keeps from one accepted step to the next */
    int second_order;                   /* whether the state is x, xdot */
    int settles;                        /* whether an accepted step needs settling */
    int switched_rows;                  /* bits of constraint rows that hold in some modes only */
    int cones;                          /* whether some friction is a cone */
    int (*rhs)(int mode, double t, const double *y, const double *c, const double *u, double *memory, int flags,
               double *dy, em_fault *fault);
    /* 0: y unchanged, 1: y changed, -1: *fault */
    int (*settle)(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace, em_fault *fault);
    int (*velocity)(int mode, double t, const double *y, const double *c, double *v, em_fault *fault);
    /* ev (n): the error of xdot that follows from an error e (n) of y[n .. 2 n) */
    void (*velocity_error)(int mode, const double *y, const double *c, const double *memory, const double *e, double *ev);
    int (*publish)(int mode, double t, const double *y, const double *c, const double *memory, double *row, em_fault *fault);
    void (*events)(double t, const double *x, const double *v, const double *c, const double *u, double *g);

    /* Terms of the equations, which the monitors of a step need. All NULL for a model written by hand without them.
     * The matrix that is factored, M (n, n) or its replacement; if there are constraint rows, B = A L^-T (m, n), M =
     * L L^T, and the lower triangle of Delta = B B^T (m, m). */
    void (*factored)(double t, const double *x, const double *c, double *M);
    /* D (n) of M = L D L^T or M = L^T D L, and the diagonal of M, where that takes less time than with M; or NULL */
    void (*pivots)(double t, const double *x, const double *c, double *pivots, double *diagonal);
    int (*rows)(double t, const double *x, const double *c, double *B, double *Delta, em_fault *fault);
    /* a (n), lambda (m): as em_model.acceleration, except for multipliers that are not unique */
    int (*acceleration)(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                        double *a, double *lambda, em_fault *fault);
    /* x, v <- the nearest state that satisfies the constraints, which is close */
    int (*settle_motion)(double t, double *x, double *v, const double *c, int least_norm, em_fault *fault);
    int (*reach)(double t, double *x, const double *c, int least_norm, em_fault *fault); /* a point with phi = 0,
                                                                                            which may be far away */
    double (*worst_factors)(const double *M, const double *y, int *first); /* error of C and s; or NULL: the state has none */

    /* Where events act (em_event_actions.h), else NULL. */
    int (*act)(double t, double *x, double *v, double *c, const double *u, int least_norm,
               const struct em_act_limits *within, int *fired, struct em_pile *pile, em_fault *fault);
    int (*watch_modes)(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                       double *g, em_fault *fault);
} em_dynamics;

#endif
