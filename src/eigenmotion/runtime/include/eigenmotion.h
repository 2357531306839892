/* eigenmotion.h: the one contract between generated code, its steppers and whoever calls them.
 *
 * A generated NAME.c defines one constant, `const em_model NAME_model`. Everything a caller needs hangs on it:
 * dimensions, names, defaults and functions. No function keeps state between calls; all memory is the caller's or
 * belongs to an em_run. All matrices are row-major. Plain C11, no Python.
 */
#ifndef EIGENMOTION_H
#define EIGENMOTION_H

#include <stddef.h>

#define EM_ABI 13 /* changes whenever anything in this file changes its meaning */

/* How a call or a run ended. Every value but the first two names a failure. */
typedef enum em_status {
    EM_FINISHED = 0,
    EM_TERMINAL_EVENT,
    EM_STEP_SIZE_UNDERFLOW,       /* fault.first: the coordinate with the largest error */
    EM_TOO_MANY_STEPS,
    EM_NON_FINITE_STATE,          /* fault.first: the coordinate, -1: unknown */
    EM_SINGULAR_MASS_MATRIX,      /* fault.first: the coordinate whose pivot vanished */
    EM_DEPENDENT_CONSTRAINTS,     /* fault.first: the row that depends on those before it, fault.second: the same row
                                     where it contradicts them, -2 where it does so at the start only */
    EM_COINCIDENT_EIGENVALUES,    /* fault.first, fault.second: coordinates of the block */
    EM_POSITION_NOT_REACHED,      /* Newton on phi(x, t) = 0 did not converge; fault.first: the row */
    EM_INTERRUPTED,
    EM_OUT_OF_MEMORY,
    EM_FACTORS_DRIFTED,           /* C and s, carried and not settled, are no longer those of M; fault.first: a coordinate
                                     of the block, fault.size: by how much, relative to an eigenvalue */
    EM_EVENT_UNDEFINED,           /* an event's expression is not a number; fault.first: the event */
    EM_ENERGY_DRIFTED,            /* T2 - T0 + V, a constant of the motion, is not what it was; fault.size: by how much */
    EM_CONSTRAINTS_DRIFTED,       /* A v + b, not settled, is not what it was; fault.first: the row, fault.size: by how much */
    EM_START_REFUSED,             /* of a member of an ensemble: no motion starts there */
    EM_EVENTS_PILE_UP,            /* events that act follow each other without time passing; fault.first: the event */
    EM_IMPACT_UNDEFINED,          /* the constraints leave no freedom along N, or, fault.second = 1, the restitution is not
                                     from 0 to 1 but fault.size; fault.first: the event */
    EM_RESET_OFF                  /* a reset leaves a constraint; fault.first: the event, fault.second: the row, -1: it
                                     names quasi-velocities where P is singular */
} em_status;

/* Where a failure sits: indices of coordinates or constraint rows, -1 where there is none. */
typedef struct em_fault {
    em_status status;
    int first, second;
    double size; /* the pivot, gap or residual that was too small or too large */
} em_fault;

/* A part of the state vector: y[start .. start + length) is called name ("x", "eta", "C", "s", "v", ...). */
typedef struct em_slice {
    const char *name;
    int start, length;
} em_slice;

/* A part of a drawing: p[first .. first + count) are its points, and what else it has (codegen/model/drawing.py). */
typedef struct em_shape {
    const char *kind;
    int first, count;
} em_shape;

/* One run-time signal u_i(t). count = 0 with values[0]: constant. */
typedef enum em_signal_kind { EM_CONSTANT = 0, EM_HOLD, EM_LINEAR, EM_CUBIC } em_signal_kind;
typedef struct em_signal {
    em_signal_kind kind;
    size_t count;              /* samples */
    const double *times;       /* (count), increasing */
    const double *values;      /* (count); EM_CUBIC: (count - 1, 4) coefficients, highest power first, local time */
} em_signal;

/* Those of fixed step are for steppers: first_step is how long their steps are, and nothing says how large their error.
 * EM_TOLD makes no steps: the caller makes them, and tells them (em_piece). */
typedef enum em_method {
    EM_RK34 = 0, EM_DOPRI5, EM_DOP853, EM_RA15, EM_RK4, EM_MIDPOINT, EM_RADAU5, EM_RADAU9, EM_TOLD
} em_method;

enum { EM_DENSE_COEFFICIENTS = 10 }; /* rows a dense step stores at the most, each (n_state) */

/* What an event does: which of the model's impacts and resets, which contact it closes or opens; -1: none. keeps_apart:
 * it happens at zero, too, where the motion is about to leave that in its direction. */
typedef struct em_deed {
    int impact, reset, held, keeps_apart, acts;
} em_deed;

/* What of a model changes with its mode: the parameter that is 1 where constraint `row` holds, else 0; that which is the
 * sign of slip where it slides, else 0 (-1: a contact, which does not); its event; of which switch the multiplier is what
 * presses (-1: of none). */
typedef struct em_switch {
    int event, holds, slides, over, row;
} em_switch;

/* How often an event acted at about one time: then when. */
typedef struct em_pile {
    double t, count;
} em_pile;

/* A growing table: one time and `width` numbers a row. Owned by the run; em_release frees it. */
typedef struct em_rows {
    size_t count, capacity, width;
    size_t most; /* rows there may be, after which the last is written over and over; 0: as many as come */
    double *t;
    double *y; /* (capacity, width) */
} em_rows;

/* One accepted step kept for dense output: t in [t, t + h], coefficients in the run's dense table. */
typedef struct em_dense_step {
    double t, h;
    int mode, kept; /* kept: as em_run's, within the step */
    size_t leg;     /* of em_run's legs */
} em_dense_step;

/* A step that the caller of EM_TOLD has made, from t on; the run is advanced to its end and no further. */
typedef struct em_piece {
    double t, h;
    const double *y; /* (EM_DENSE_COEFFICIENTS, n_state) x and v at the nodes of em_told.h; the rest counts for nothing */
    int left;        /* whether an event acted in it, and the motion goes on as another */
} em_piece;

struct em_model;

/* One simulation. The caller fills the first part (zero the whole struct before), em_model.simulate the second;
 * em_release(run) frees what simulate allocated. */
typedef struct em_run {
    /* --- what to do --- */
    double t_start, t_end;
    const double *y_start;       /* (n_state), published meaning */
    const double *prepared;      /* (n_prepared), from em_model.prepare */
    const em_signal *inputs;     /* (n_inputs) or NULL */
    em_method method;
    double rtol;
    const double *atol;          /* (n): of x_k [u_k] and of its velocity [u_k / s] */
    double first_step;           /* 0: chosen */
    double max_step;             /* INFINITY: none */
    long max_steps;              /* accepted ones */
    int stabilise;               /* 1 "project", 0 "none" */
    int least_norm;              /* 1: dependent rows get multipliers of least norm, 0: they are a fault */
    int dense;                   /* 1: keep every step's interpolant */
    const double *t_eval;        /* (n_t_eval) in the direction of time, or NULL: a row for every accepted step */
    size_t n_t_eval;
    const int *event_direction;  /* (n_events) -1, 0, 1 */
    const int *event_terminal;   /* (n_events) */
    int (*poll)(void *);         /* called about every 20 ms; non-zero ends the run as EM_INTERRUPTED; or NULL */
    void *poll_argument;
    em_piece *piece;             /* of EM_TOLD */

    /* --- what came of it --- */
    em_fault fault;              /* fault.status says how it ended */
    em_rows rows;                /* width n_state, published meaning */
    em_rows *events;             /* (n_events), width n_state */
    em_rows *after;              /* (n_events) the states after those that acted */
    em_rows legs;                /* width n_prepared + 1: between events that change the mode, where a model has modes:
                                    since when, the constants then (`prepared` is the last), its first row of `rows` */
    em_dense_step *dense_steps;  /* (n_dense) */
    double *dense_table;         /* (n_dense, EM_DENSE_COEFFICIENTS, n_state) */
    size_t n_dense, dense_capacity;
    int kept;                    /* flags of the constraint rows kept at the last accepted step (em_rank.h) */
    long n_rhs, n_steps, n_rejected;
    long n_bounded;              /* accepted steps that did not run the published equations */
    long n_jacobians, n_factors; /* of implicit methods: slopes of the acceleration, and sets of factors made of them */
    long n_stiff;                /* that stability kept short, or the convergence of an iteration, and not their error */
    double t_reached;
    const struct em_model *model; /* the caller's, where the run is to be held against its energy, or NULL */
} em_run;

/* Runs side by side, one in each lane: what em_lanes.run works with. Tables are (..., width), number by number, on
 * addresses that are multiples of 64, and 0 where nobody wrote; rows of states are padded to a multiple of 4. */
enum { EM_MOST_LANES = 8 };
typedef enum em_landing {
    EM_SETTLED,
    EM_UNSETTLED, /* that is to be done number by number; */
    EM_LOST       /* so are all of the run's steps, from its start */
} em_landing;
typedef struct em_flock {
    const em_run *task;   /* what is asked of all */
    int mode;             /* of all */
    double rtol, direction, stretch; /* as a walk has them (em_walk.h) */
    double *y, *y_new, *f_new; /* (n_state, width) */
    double *memory, *memory_new; /* (remembered, width) */
    double *K;            /* (12, n_state, width): K_0 is f at y */
    double *c, *u;        /* (n_prepared, width), (n_inputs, width) */
    double *t, *t_new, *h, *h_next, *error, *last_error, *longest; /* (width) */
    double *n_steps, *n_rejected, *retries, *n_rhs;
    double *stiff, *n_stiff, *next_judge; /* (width) 1 where stability keeps steps short; how many; the step at which that is judged */
    double *next_look;    /* (width) right-hand sides, and a time, at which a step is looked at */
    double *t_look;
    int live[EM_MOST_LANES], n_live; /* lanes with a run */
    int always;           /* every step is looked at */
    int pauses;           /* another flock is to go on first */
    /* Looks at the step that a lane has taken. 0: goes on; else the lane has another run now, or none. */
    int (*look)(struct em_flock *f, int lane, em_landing landing);
    int (*stopped)(struct em_flock *f); /* whether all are to end */
    void *with;           /* whose they are */
} em_flock;

/* The right-hand side of `width` states side by side, number by number: y[k width + lane], and so t, c, u, dy. Where a
 * lane is singular its dy is NaN. width 0: there is none. */
typedef struct em_lanes {
    int width;
    void (*rhs)(int mode, const double *t, const double *y, const double *c, const double *u, int flags, double *dy);
    /* v (n): xdot alone, of states in mode 0, where it costs little; or NULL */
    void (*velocity)(const double *t, const double *y, const double *c, double *v);
    void (*run)(em_flock *f); /* until no lane has a run; dop853, stabilised, inputs constant; or NULL */
    int remembered, modes;    /* numbers that a run keeps of its last step; modes of runs, each in flocks of its own */
    int n_prepared;
} em_lanes;

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
    const char *const *left_out;         /* (n_left_out) what this scene does not need, and why */
    const int *block;                    /* (n) the block of M each coordinate belongs to, 0, 1, ... */
    const double *scales;                /* (n) units of the eigenproblem */
    const int *carried;                  /* (n) 1 where the state holds C and s of the coordinate's block */
    int conserves_energy;                /* 1: T2 - T0 + V is a constant of the motion */

    int (*prepare)(const double *parameters, double *c, em_fault *fault);
    /* y: in, a neighbour's state for its eigenfactors to stay continuous with (0: none); out, the state. */
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
    void (*energy)(double t, const double *x, const double *v, const double *c, double *e); /* (4) T2, T1, T0, V */
    /* C (n, n), s (n): in, a neighbour's eigenfactors to stay continuous with (C = 0: none); out, those of M(x). */
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
    const double *initial_y;              /* (n) where the model starts from given quasi-velocities, else NULL */
    void (*quasi)(double t, const double *x, const double *v, const double *c, double *y); /* (n_quasi), or NULL */
    void (*event)(double t, const double *x, const double *v, const double *c, const double *u, double *g);

    /* What is factored where M is singular but not along the constraints, M + A^T W A (n, n), and its gradient; NULL
     * where M is (em_factored_matrix of em_start.h knows). */
    void (*factored_matrix)(double t, const double *x, const double *c, double *M);
    void (*factored_gradient)(double t, const double *x, const double *c, double *dM);

    const em_deed *deeds;          /* (n_events), or NULL: events change nothing */
    int n_switches;
    const em_switch *switches;     /* (n_switches) */

    const em_lanes *lanes; /* NULL: the right-hand side is not for lanes */
    /* A run whose steps are to be made in lanes, at its start, and its mode. NULL: it cannot, and run is as it was but for
     * its fault. */
    void *(*enter)(em_run *run, int *mode);
    void (*board)(void *walk, em_flock *f, int lane); /* goes on in this lane, of a flock of its mode */
    /* At a step. 0: goes on; 1: has ended; 2: goes on in the other mode; -1: begin anew, number by number */
    int (*look)(void *walk, em_flock *f, int lane, em_landing landing);

    /* A run that goes on as far as it is told (em_control.h calls these; all memory is taken as it opens). */
    void *(*open)(em_run *run);        /* at its start: run->fault says whether there is one. NULL: no memory */
    int (*advance)(void *walk, double t, int jumped);  /* exactly there; 0, or -1 and run->fault: it stands where it came to */
    double (*now)(const void *walk, double *x, double *v); /* t; x, v (n) */
    int (*publish)(const void *walk, double *y, em_fault *fault); /* y (n_state), published meaning */
    size_t (*saved)(void);             /* how many bytes hold all of its motion */
    void (*save)(const void *walk, void *saved);
    void (*restore)(void *walk, const void *saved);
    void (*close)(void *walk);
    int (*again)(void *walk); /* at the start that its run says now, as after open, with no memory taken: the status */

    int n_shapes, dimension; /* of the drawing: 0 where there is none; numbers a position has */
    const em_shape *shapes;  /* (n_shapes) */
    void (*draw)(double t, const double *x, const double *c, double *p); /* all numbers of the shapes */

    /* Exact derivatives, row-major, by the arguments (n_arguments): x, v, inputs, parameters, time; in c only what the
     * parameters are counts. Those of xddot and lambda: da (n, n_arguments), dlambda (m, n_arguments). */
    int n_arguments;
    int (*motion_derivatives)(double t, const double *x, const double *v, const double *c, const double *u,
                              int least_norm, double *a, double *lambda, double *da, double *dlambda, em_fault *fault);
    void (*constraint_partials)(double t, const double *x, const double *v, const double *c,
                                double *D); /* (h + m, n_arguments), of phi and A v + b; NULL where m is 0 */
    void (*output_partials)(double t, const double *x, const double *v, const double *a, const double *lambda,
                            const double *c, const double *u,
                            double *D); /* (n_outputs, n + m + n_arguments), first by a, lambda; or NULL */
    void (*event_partials)(double t, const double *x, const double *v, const double *c, const double *u,
                           double *D); /* (n_events, n_arguments), or NULL */
    void (*quasi_partials)(double t, const double *x, const double *v, const double *c,
                           double *D); /* (n_quasi, n_arguments), or NULL */
    /* Along `columns` directions, S (2 n, columns) of x, v, and P (n_arguments - 2 n, columns) of the rest: W (n + m,
     * columns), the changes of a and lambda; S <- the nearest along which the constraints stay satisfied. */
    int (*motion_along)(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                        int columns, const double *S, const double *P, double *a, double *lambda, double *W,
                        em_fault *fault);
    int (*tangent)(double t, const double *x, const double *v, const double *c, int least_norm, int columns, double *S,
                   const double *P, em_fault *fault); /* NULL where m is 0 */
    /* What events do (em_act), and what becomes of `columns` directions S (2 n, columns), at P (n_arguments - 2 n, columns),
     * of the state before. NULL where nothing acts. */
    int (*act_along)(double t, double *x, double *v, double *c, const double *u, int least_norm, int *fired, em_pile *pile,
                     int columns, double *S, const double *P, em_fault *fault);
} em_model;

#endif
