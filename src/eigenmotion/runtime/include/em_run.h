/* em_run.h: a run: its task, its results, and the status it ended with.
 *
 * Included by eigenmotion.h alone, whose conventions and version apply here. */
#ifndef EM_RUN_H
#define EM_RUN_H

#include <stddef.h>

/* How a call or a run ended. Every value but the first two names a failure. */
typedef enum em_status {
    EM_FINISHED = 0,
    EM_TERMINAL_EVENT,
    EM_STEP_SIZE_UNDERFLOW,       /* fault.first: the coordinate with the largest error */
    EM_TOO_MANY_STEPS,
    EM_NON_FINITE_STATE,          /* fault.first: the coordinate, -1: unknown */
    EM_SINGULAR_MASS_MATRIX,      /* fault.first: the coordinate whose pivot vanished */
    EM_DEPENDENT_CONSTRAINTS,     /* fault.first: the row that depends on those before it */
    EM_COINCIDENT_EIGENVALUES,    /* fault.first, fault.second: coordinates of the block */
    EM_POSITION_NOT_REACHED,      /* Newton on phi(x, t) = 0 did not converge; fault.first: the row */
    EM_INTERRUPTED,
    EM_OUT_OF_MEMORY,
    EM_FACTORS_DRIFTED,           /* C and s, integrated and not restored, are no longer those of M; fault.first: a
                                     coordinate of the block, fault.size: the relative error of an eigenvalue */
    EM_EVENT_UNDEFINED,           /* an event function is not a number; fault.first: the event */
    EM_ENERGY_DRIFTED,            /* T2 - T0 + V, a constant of the motion, has changed; fault.size: by how much */
    EM_CONSTRAINTS_DRIFTED,       /* A v + b, not restored, has changed; fault.first: the row, fault.size: by how
                                     much */
    EM_START_REFUSED,             /* of a member of an ensemble: the motion cannot start */
    EM_EVENTS_PILE_UP,            /* event actions accumulate at one time; fault.first: the event */
    EM_IMPACT_UNDEFINED,          /* the constraints leave no freedom along N; fault.first: the event */
    EM_RESET_OFF,                 /* the state after a reset violates a constraint; fault.first: the event,
                                     fault.second: the row */
    EM_MODEL_JUMPS,               /* at a time event, the momentum of coordinate fault.first jumps */
    EM_RESET_INSIDE,              /* the state after a reset has phi < 0 of an impact; fault.first: the event of the
                                     reset, fault.second: that of the impact, fault.size: phi */
    EM_CONTACTS_CLASH,            /* no mode of contacts and frictions is consistent; fault.first, fault.second: the
                                     events of the conditions that conflict, -1: of a constraint */
    EM_VALUE_REFUSED,             /* a value violates the assumption of its symbol; fault.first: its place in
                                     em_model's declared, fault.size: the value */
    EM_OUTSIDE_TABLE              /* the motion leaves the range of a table; fault.first: its place in em_model's
                                     tables, fault.size: the argument */
} em_status;

/* The precise meaning of a status, in place of fault.second: each has a message of its own. */
typedef enum em_detail {
    EM_NEARLY_SINGULAR = -2,      /* of EM_SINGULAR_MASS_MATRIX: nearly singular, no step size is small enough */
    EM_SINGULAR_START = -3,       /* of EM_DEPENDENT_CONSTRAINTS: at the start only */
    EM_CONTRADICTION = -4,        /* the row contradicts the rows that it depends on */
    EM_SHARED_LOAD = -5,          /* friction is proportional to a multiplier that is not unique */
    EM_BAD_RESTITUTION = -6,      /* of EM_IMPACT_UNDEFINED: the restitution is not in [0, 1] but fault.size */
    EM_RESTITUTION_LOWERED = -7,  /* the derivative of a lowered restitution is not available */
    EM_LAW_NOT_DERIVED = -8,      /* nor is that of this law of impacts */
    EM_NO_RATES = -9,             /* of EM_RESET_OFF: it sets quasi-velocities where P is singular */
    EM_POSITION_JUMPS = -10,      /* of EM_MODEL_JUMPS: phi of row fault.first */
    EM_CONTACT_JUMPS = -11,       /* the speed of a contact that holds, row fault.first */
    EM_JAMMED = -12,              /* of EM_CONTACTS_CLASH: no acceleration satisfies the constraints with friction */
    EM_TOO_MANY_MODES = -13,      /* the search has too many modes */
    EM_NORMALS_NOT_FOUND = -14,   /* Newton's method for the normal forces of frictions did not converge */
    EM_INSIDE_CONTACT = -15,      /* of EM_START_REFUSED: event fault.first */
    EM_MASS_NOT_FINITE = -16,     /* of EM_NON_FINITE_STATE: the mass matrix, at coordinate fault.first */
    EM_ROW_NOT_FINITE = -17       /* constraint row fault.first */
} em_detail;

/* The location of a failure: indices of coordinates, constraint rows or events, -1 where there is none. */
typedef struct em_fault {
    em_status status;
    int first, second; /* second: or an em_detail */
    double size; /* the pivot, gap or residual that was too small or too large */
} em_fault;

/* One run-time signal u_i(t). count = 0 with values[0]: constant. */
typedef enum em_signal_kind { EM_CONSTANT = 0, EM_HOLD, EM_LINEAR, EM_CUBIC } em_signal_kind;
typedef struct em_signal {
    em_signal_kind kind;
    size_t count;              /* samples */
    const double *times;       /* (count), increasing */
    const double *values;      /* (count); EM_CUBIC: (count - 1, 4) coefficients, highest power first, local time */
} em_signal;

/* Methods of fixed step are for steppers: first_step is their step size, and there is no error estimate. */
typedef enum em_method {
    EM_RK34 = 0, EM_DOPRI5, EM_DOP853, EM_RA15, EM_RK4, EM_MIDPOINT, EM_RADAU5, EM_RADAU9
} em_method;

enum { EM_DENSE_COEFFICIENTS = 10 }; /* rows that a dense step stores at most, each (n_state) */

/* A growing table: one time and `width` numbers a row. Owned by the run; em_release frees it. */
typedef struct em_rows {
    size_t count, capacity, width;
    size_t most; /* the most rows there may be, after which the last one is overwritten; 0: no limit */
    double *t;
    double *y; /* (capacity, width) */
} em_rows;

/* EM_DENSE: states within steps will be requested, so that steps are as short as that needs. EM_TO_DERIVE: the
 * interpolant may have any accuracy. */
typedef enum em_kept { EM_NOT_KEPT, EM_DENSE, EM_TO_DERIVE } em_kept;

/* One accepted step kept for dense output: t in [t, t + h], coefficients in the run's dense table. */
typedef struct em_dense_step {
    double t, h;
    int mode, kept; /* kept: as em_run's, within the step */
    size_t segment;     /* index in em_run's segments */
    em_method method;   /* that made the step */
} em_dense_step;

/* How dependent constraint rows are handled: as a fault; by multipliers of least norm; or by the latter if they
 * depend at the start, and as a fault if they become dependent later. At a single state, the third is the second. */
typedef enum em_dependent { EM_REFUSED, EM_SHARED, EM_SHARED_FROM_START } em_dependent;

struct em_model;

/* One simulation. The caller fills the first part (zero the whole struct before), em_model.simulate the second;
 * em_release(run) frees what simulate allocated. */
typedef struct em_run {
    /* --- the task --- */
    double t_start, t_end;
    const double *y_start;       /* (n_state), published meaning */
    const double *prepared;      /* (n_prepared), from em_model.prepare */
    const em_signal *inputs;     /* (n_inputs) or NULL */
    em_method method;            /* changes with `other` if the run changes its method */
    int changes;                 /* whether it may: at accepted steps, from an explicit method to an implicit one, or
                                    back (em_method_change.h) */
    em_method other;             /* the method to which it may change */
    double rtol;
    const double *atol;          /* (n): of x_k [u_k] and of its velocity [u_k / s] */
    double first_step;           /* 0: chosen automatically */
    double max_step;             /* INFINITY: none */
    long max_steps;              /* accepted ones */
    int stabilise;               /* 1 "project", 0 "none" */
    int least_norm;              /* em_dependent; after the start of the run, 0 if no rows were redundant there */
    int dense;                   /* em_kept: whether to keep the interpolant of every step, and for what */
    const double *t_eval;        /* (n_t_eval) in the direction of time, or NULL: a row for every accepted step */
    size_t n_t_eval;
    const int *event_direction;  /* (n_events) -1, 0, 1 */
    const int *event_terminal;   /* (n_events) */
    int (*poll)(void *);         /* called about every 20 ms; a non-zero result ends the run as EM_INTERRUPTED; or
                                    NULL */
    void *poll_argument;

    /* --- the results --- */
    em_fault fault;              /* fault.status says how the run ended */
    em_rows rows;                /* width n_state, published meaning */
    em_rows *events;             /* (n_events), width n_state */
    em_rows *after;              /* (n_events) the states after event actions */
    em_rows charts;              /* width n_state: the state before a change of rotation parameters, and that after it
                                    (em_chart_change.h); of runs with dense output only */
    em_rows last;                /* width n_state, one row: the last accepted state, if the run has failed */
    em_rows segments;                /* width n_prepared + 1: segments between events that change the mode, of models
                                        that have modes: the time of its start, its constants (`prepared` is the
                                        last), its first row of `rows` */
    em_rows methods;             /* width 1: changes of the method: the method from then on */
    int waits;                   /* whether the run has stopped at a step because the other method is implicit and
                                    costs less. It changes when it is advanced again, for which the model needs
                                    motion_jacobian */
    em_dense_step *dense_steps;  /* (n_dense) */
    double *dense_table;         /* (n_dense, EM_DENSE_COEFFICIENTS, n_state) */
    size_t n_dense, dense_capacity;
    int kept;                    /* flags of the constraint rows kept at the last accepted step (em_rank.h) */
    long n_rhs, n_steps, n_rejected;
    long n_bounded;              /* accepted steps that did not use the published equations */
    long n_jacobians, n_factors; /* of implicit methods: Jacobians of the acceleration, and factorisations */
    long n_stiff;                /* steps limited by stability, or by the convergence of an iteration, and not by
                                    their error */
    double t_reached;
    const struct em_model *model; /* the caller's, if the energy of the run should be monitored, or NULL */
} em_run;

#endif
