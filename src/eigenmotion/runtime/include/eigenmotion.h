/* eigenmotion.h: the ABI between generated code, its steppers and their callers.
 *
 * A generated NAME.c defines one constant, `const em_model NAME_model`, which gives a caller everything: dimensions,
 * names, defaults and functions. No function keeps state between calls; all memory is the caller's or belongs to an
 * em_run. All matrices are row-major. Plain C11, no Python.
 */
#ifndef EIGENMOTION_H
#define EIGENMOTION_H

#include <stddef.h>

#include "em_state_functions.h"
#include "em_run.h"
#include "em_lanes.h"

#define EM_ABI 40 /* increased whenever anything here or in the three files above changes its meaning */

/* A part of the state vector: y[start .. start + length) is called name ("x", "eta", "C", "s", "v", ...). */
typedef struct em_slice {
    const char *name;
    int start, length;
} em_slice;

/* One shape of a drawing: its numbers are p[first .. first + count), in the order of
 * codegen/model/statement/drawing.py; for a solid also its corners (n_corners, 3), which move with its frame. */
typedef struct em_shape {
    const char *kind;
    int first, count, n_corners;
    const float *corners;
} em_shape;

/* Action of an event: the indices of the model's impact and reset, and of the contact that it closes or opens; -1:
 * none. keeps_apart: the event also fires at zero if the motion is about to leave zero in its direction, 1
 * downwards, -1 upwards; else 0. */
typedef struct em_event_action {
    int impact, reset, held, keeps_apart, acts;
} em_event_action;

/* What a mode changes for one contact or friction: the index of the parameter that is 1 where constraint `row`
 * holds, else 0; of the parameter that is the sign of the slip while it slides, else 0 (-1: a contact, which does
 * not slide); its event; the switch whose multiplier is the normal force (-1: none); the parameter that is the
 * tolerance of `row` while it idles, else 0; whether its impacts follow Poisson's law; for a cone, which has two
 * rows, the first of two parameters that are added to its slips where its direction is computed (-1: no cone). */
typedef struct em_switch {
    int event, holds, slides, over, row, idles, poisson, shift;
} em_switch;

/* Limits of a run that event actions use: its tolerances rtol and atol (n); the rounding of gaps, slips and forces
 * (n_events); the depth inside contacts at the start of the run; the change of rates along rows (m) caused by moving
 * the start outside. All but the tolerances are written when a mode begins. */
typedef struct em_act_limits {
    double rtol;
    const double *atol;
    double *rounding, *depth, *rate_shift;
} em_act_limits;

/* How often an event has acted at nearly the same time, and that time. */
typedef struct em_pile {
    double t, count;
} em_pile;

/* The assumptions on a symbol, which were used to simplify expressions: bits of em_assumptions.h, and words. */
typedef struct em_declared {
    int bits;
    const char *words;
} em_declared;

/* A table: the index of the parameter that gives it other numbers, whether it is an input that prescribes a motion, and
 * its own numbers (tables/em_table.h). */
typedef struct em_table {
    int parameter, is_input;
    const double *numbers;
} em_table;

/* An argument of a table in the equations of motion: the index of the table, which of its arguments it is, the highest
 * derivative with respect to it in the equations, and whether it depends on time only. */
typedef struct em_table_use {
    int table, axis, order, timed;
} em_table_use;

/* A body of a tree: its name ("": a part of a joint made of several); the number of the body that carries it, less than
 * its own, or -1: the ground; the kind of its joint, and the coordinates of that. */
typedef struct em_body {
    const char *name;
    int parent, joint, count, coordinates[6];
} em_body;

/* Actuators: each acts on a coordinate or by an input (-1: it does not), and has a weight of its squared force, where a
 * choice is left (weight NULL: 1). count 0: one on every coordinate, with n weights or NULL. */
typedef struct em_actuators {
    int count;
    const int *coordinate, *input;
    const double *weight;
} em_actuators;

#define EM_ALLOWED 1e-6 /* relative to its terms: a residual of a constraint that counts as zero, as in measured motions */
#define EM_DRIVEN 1e-8  /* relative to them in the mass metric: required forces that count as given by actuators */

/* Of inverse dynamics: the part of the required forces that no actuator gives, relative to their terms, in the mass
 * metric; and the largest residual of a constraint, relative to its terms, with its equation and row. */
typedef struct em_inverse_check {
    double undriven, forbidden;
    int equation, row;
} em_inverse_check;

enum { EM_OF_POSITION, EM_OF_VELOCITY, EM_OF_ACCELERATION }; /* its equations: phi, A v + b, A a + gamma */

enum { EM_FIXED, EM_REVOLUTE, EM_PRISMATIC, EM_SPHERICAL, EM_FREE }; /* kinds of joints, as in codegen/model/tree/body.py */
enum { EM_FRAME = 17 }; /* numbers of a joint: at (3), R (3, 3), axis (3), ratio, offset (em_forward_kinematics.h) */

/* One compiled mechanism. n coordinates, m constraint rows (the first h holonomic).
 * x, v (n); y, dy (n_state); c: the prepared parameters (n_prepared); u (n_inputs).
 * Functions that return int return 0, or -1 and fill *fault. */
typedef struct em_model {
    int abi;
    const char *name, *formulation, *close_eigenvalues, *schur;
    int n, m, h, n_state, n_parameters, n_prepared, n_inputs, n_outputs, n_events, n_layout, n_left_out;
    const char *const *coordinates;      /* (n) the user's names */
    const char *const *parameters;       /* (n_parameters) */
    const double *parameter_defaults;    /* (n_parameters) */
    const char *const *inputs;           /* (n_inputs) */
    const double *input_defaults;        /* (n_inputs) */
    const double *initial_x, *initial_v; /* (n) */
    const char *const *outputs;          /* (n_outputs) */
    const char *const *events;           /* (n_events) */
    const int *event_direction, *event_terminal; /* (n_events) */
    const em_slice *layout;              /* (n_layout) */
    const char *const *left_out;         /* (n_left_out) terms that this model does not need, with the reason */
    const int *block;                    /* (n) the block of M that each coordinate belongs to, 0, 1, ... */
    const double *scales;                /* (n) units of the eigenproblem */
    const int *carried;                  /* (n) 1 where the state holds C and s of the coordinate's block */
    int conserves_energy;                /* 1: T2 - T0 + V is a constant of the motion */

    int (*prepare)(const double *parameters, double *c, em_fault *fault);
    /* y in: a neighbouring state, with which the new eigenfactors are continuous (0: none); y out: the state. */
    int (*state)(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault);
    int (*velocity)(double t, const double *y, const double *c, double *v, em_fault *fault);
    int (*rhs)(double t, const double *y, const double *c, const double *u, double *dy, em_fault *fault);
    void (*mass_matrix)(double t, const double *x, const double *c, double *M);           /* (n, n) */
    void (*mass_matrix_gradient)(double t, const double *x, const double *c, double *dM); /* (n, n, n) [k, i, j] */
    void (*pfaffian)(double t, const double *x, const double *c, double *A, double *b);   /* (m, n), (m) */
    /* phi (h), and terms (h): eps terms is the rounding of phi */
    void (*position)(double t, const double *x, const double *c, double *phi, double *terms);
    int (*acceleration)(double t, const double *x, const double *v, const double *c, const double *u,
                        int least_norm, double *a, double *lambda, em_fault *fault);      /* (n), (m) */
    int (*project)(double t, double *x, double *v, const double *c, int least_norm, em_fault *fault);
    /* The number of rows that hold in every mode and depend on others, at the nearest x on the constraints. rows (m)
     * <- 1 for rows whose multipliers are not unique, else 0. */
    int (*redundant)(double t, const double *x, const double *c, int *rows);
    void (*energy)(double t, const double *x, const double *v, const double *c, double *e); /* (4) T2, T1, T0, V */
    /* C (n, n), s (n) in: neighbouring eigenfactors, with which the result is continuous (C = 0: none); out: those of
     * M(x). */
    int (*eigenfactors)(double t, const double *x, const double *c, double *C, double *s, em_fault *fault);
    int (*output)(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                  double *out, em_fault *fault);                                           /* (n_outputs) */
    /* J (n_state, n_state) of rhs; J (2 n, 2 n) of (x, v) -> (v, xddot), exact (em_derivatives.h). */
    int (*jacobian)(double t, const double *y, const double *c, const double *u, double *J, em_fault *fault);
    int (*motion_jacobian)(double t, const double *z, const double *c, const double *u, int least_norm, double *J,
                           em_fault *fault);
    int (*simulate)(em_run *run);                                             /* the status */
    int (*interpolate)(const em_run *run, size_t step, double t, double *y);  /* y published, projected */
    void (*release)(em_run *run);

    int n_quasi;                          /* n where the model states quasi-velocities y = P(x, t) v (3), else 0 */
    const char *const *quasi_velocities;  /* (n_quasi) */
    const double *initial_y;              /* (n) where the model specifies quasi-velocities at the start, else NULL */
    void (*quasi)(double t, const double *x, const double *v, const double *c, double *y); /* (n_quasi), or NULL */
    void (*event)(double t, const double *x, const double *v, const double *c, const double *u, double *g);

    /* The matrix that is factored if M is singular, though not along the constraints: M + A^T W A (n, n), and its
     * gradient. NULL if that is M itself (see em_factored_matrix of em_start_check.h). */
    void (*factored_matrix)(double t, const double *x, const double *c, double *M);
    void (*factored_gradient)(double t, const double *x, const double *c, double *dM);

    const em_event_action *event_actions;          /* (n_events), or NULL: events change nothing */
    int n_switches;
    const em_switch *switches;     /* (n_switches) */
    /* (n_switches, 2) the limit of each friction as it slides and as it sticks, over the normal force if it has one; of a
     * contact, the rate below which it stays closed. NULL: no switches */
    void (*levels)(double t, const double *x, const double *v, const double *c, const double *u, double *level);
    int n_impacts;
    void (*impacts)(double t, const double *x, const double *v, const double *c, const double *u,
                    double *data); /* (n_impacts, n + 2): N = dphi/dx, dphi/dt, the restitution; NULL without impacts */

    const em_lanes *lanes; /* NULL: the right-hand side has no version for lanes */
    /* Opens a run for steps in lanes, at its start, and sets its mode. NULL: lanes cannot compute this run, and only its
     * fault has changed. */
    void *(*enter)(em_run *run, int *mode);
    void (*load)(void *run_state, em_lane_group *f, int lane); /* the run continues in this lane of a group of its
                                                                  mode */
    /* Checks a step of the run. 0: it continues; 1: it has ended; 2: it continues in the other mode; -1: restart it
     * with scalar steps. */
    int (*check_step)(void *run_state, em_lane_group *f, int lane, em_lane_outcome outcome);

    /* A run that advances to times of the caller's choice (em_control.h calls these; all memory is allocated as it
     * opens). */
    void *(*open)(em_run *run);        /* at its start; run->fault says whether it can start. NULL: no memory */
    int (*advance)(void *run_state, double t, int jumped);  /* to t exactly; 0, or -1 and run->fault: it stays where
                                                               it failed */
    double (*now)(const void *run_state, double *x, double *v); /* t; x, v (n) */
    int (*publish)(const void *run_state, double *y, em_fault *fault); /* y (n_state), published meaning */
    size_t (*saved)(void);             /* number of bytes that hold the whole motion */
    void (*save)(const void *run_state, void *saved);
    void (*restore)(void *run_state, const void *saved);
    void (*close)(void *run_state);
    int (*again)(void *run_state); /* restarts at the start that its run states now, as after open, without
                                      allocation: the status */

    int n_shapes, dimension; /* of the drawing: 0 if there is none; numbers per position */
    const em_shape *shapes;  /* (n_shapes) */
    void (*draw)(double t, const double *x, const double *v, const double *c, double *p); /* all numbers of the shapes */

    /* Exact derivatives, row-major, with respect to the arguments (n_arguments): x, v, inputs, parameters, time. c
     * is held fixed except for the parameters themselves. Derivatives of xddot and lambda: da (n, n_arguments), dlambda
     * (m, n_arguments). */
    int n_arguments;
    int (*motion_derivatives)(double t, const double *x, const double *v, const double *c, const double *u,
                              int least_norm, double *a, double *lambda, double *da, double *dlambda, em_fault *fault);
    void (*constraint_partials)(double t, const double *x, const double *v, const double *c,
                                double *D); /* (h + m, n_arguments), of phi and A v + b; NULL where m is 0 */
    void (*output_partials)(double t, const double *x, const double *v, const double *a, const double *lambda,
                            const double *c, const double *u,
                            double *D); /* (n_outputs, n + m + n_arguments), first with respect to a, lambda; or NULL */
    void (*event_partials)(double t, const double *x, const double *v, const double *c, const double *u,
                           double *D); /* (n_events, n_arguments), or NULL */
    void (*quasi_partials)(double t, const double *x, const double *v, const double *c,
                           double *D); /* (n_quasi, n_arguments), or NULL */
    /* Along `columns` directions, S (2 n, columns) of x, v, and P (n_arguments - 2 n, columns) of the other
     * arguments: W (n + m, columns) <- the changes of a and lambda; S <- the nearest directions along which the
     * constraints stay satisfied. */
    int (*motion_along)(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                        int columns, const double *S, const double *P, double *a, double *lambda, double *W,
                        em_fault *fault);
    int (*tangent)(double t, const double *x, const double *v, const double *c, int least_norm, int columns, double *S,
                   const double *P, em_fault *fault); /* NULL where m is 0 */
    /* Event actions (em_act), with the map of `columns` directions S (2 n, columns), at P (n_arguments - 2 n,
     * columns), across them. NULL if no event acts. */
    int (*act_along)(double t, double *x, double *v, double *c, const double *u, int least_norm, int *fired, em_pile *pile,
                     int columns, double *S, const double *P, em_fault *fault);

    int n_time_events; /* time events: conditions on time alone change at times at + k period, k an integer
                          (em_time_events.h) */
    void (*time_events)(const double *c, double *at);        /* (n_time_events, 3): at, period, eps terms its rounding; or NULL */
    void (*time_event_partials)(const double *c, double *D); /* (n_time_events, 2, n_arguments), of at and period; or NULL */

    /* J (n_state, n_state) of rhs if the state carries eta, NaN where it is singular; NULL: not compiled */
    void (*rate_jacobian)(double t, const double *y, const double *c, const double *u, double *J);
    const char *const *rows; /* (m) names of constraint rows, "" of those without; NULL: none has one */
    const em_dynamics *dynamics; /* functions that steppers call during a run */
    const em_declared *declared; /* (n_parameters + n + n_inputs) of parameters, x, inputs; NULL: no assumptions.
                                    prepare checks the parameters */
    int n_tables, n_table_uses;
    const em_table *tables;         /* (n_tables) */
    const em_table_use *table_uses; /* (n_table_uses) */
    void (*table_arguments)(double t, const double *x, const double *v, const double *c, const double *u,
                            double *at); /* (n_table_uses); NULL: there is no table */
    int n_states;                /* the number of first-order states z, which are the last of the n coordinates:
                                    coordinates[k] is the name of z, v[k] its value, x[k] its integral, initial_v[k]
                                    its initial value */
    int n_bodies;
    const em_body *bodies;                             /* (n_bodies), those that carry others before these */
    void (*frames)(const double *c, double *numbers);  /* (n_bodies, EM_FRAME) those that are not 0; NULL: no bodies */
    int n_rotations;
    const int (*rotations)[3]; /* (n_rotations) coordinates that are modified Rodrigues parameters. Steppers replace them
                                  by their shadow set (em_shadow_parameters.h) */

    /* Inverse dynamics: the forces r (n) = M a - f that must act besides for accelerations a (n), without reactions;
     * s (m) = A a + gamma, which vanishes where the constraints allow a. */
    void (*required_forces)(double t, const double *x, const double *v, const double *a, const double *c, const double *u,
                            double *r, double *s);
    void (*input_columns)(double t, const double *x, const double *v, const double *a, const double *c, const double *u,
                          double *B); /* (n, n_inputs) df / du; NULL: no inputs */
    const unsigned char *mixed_inputs; /* (n_inputs, n_inputs) 1 where df / du_i depends on u_j; NULL: no inputs */
    /* P (m + n_normals, n): reactions are -P^T (lambda, rho), with friction proportional to multipliers; NULL: A */
    void (*pushes)(double t, const double *x, const double *v, const double *c, const double *u, double *P);
    int n_normals;                /* the number of rho: norms of multipliers in friction */
    const unsigned char *normals; /* (n_normals, m) 1 for the multipliers of each */
    /* The forces (count, or n) of actuators for accelerations a (n), through the constraints: of least weighted squares
     * where there is a choice, lambda (m), and the required forces that no actuator gives, residual (n). Contacts and
     * frictions are as their parameters in c say (em_inverse_dynamics.h). */
    int (*inverse_dynamics)(double t, const double *x, const double *v, const double *a, const double *c, const double *u,
                            const em_actuators *actuators, double *forces, double *lambda, double *residual,
                            em_inverse_check *check, em_fault *fault);
    /* D (n + m, n_arguments) of the equations r (n) = M a + P^T (lambda, rho) - bias and s (m) = A a + gamma at fixed a,
     * lambda; M is the mass matrix itself, even if another one is factored (em_derivatives.h). */
    void (*equation_partials)(double t, const double *x, const double *v, const double *a, const double *lambda,
                              const double *c, const double *u, double *D);
    void (*observe)(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
                    const double *u, double *out); /* (n_outputs) at given a, lambda, as of a driven motion; or NULL */
} em_model;

#endif
