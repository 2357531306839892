/* em_run.h: a run: its task, its results, and the status it ended with.
 *
 * Included by eigenmotion.h alone, whose words and version hold here.
 */
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
    EM_FACTORS_DRIFTED,           /* C and s, carried and not settled, are no longer those of M; fault.first: a coordinate
                                     of the block, fault.size: by how much, relative to an eigenvalue */
    EM_EVENT_UNDEFINED,           /* an event's expression is not a number; fault.first: the event */
    EM_ENERGY_DRIFTED,            /* T2 - T0 + V, a constant of the motion, is not what it was; fault.size: by how much */
    EM_CONSTRAINTS_DRIFTED,       /* A v + b, not settled, is not what it was; fault.first: the row, fault.size: by how much */
    EM_START_REFUSED,             /* of a member of an ensemble: no motion starts there */
    EM_EVENTS_PILE_UP,            /* events that act follow each other without time passing; fault.first: the event */
    EM_IMPACT_UNDEFINED,          /* the constraints leave no freedom along N; fault.first: the event */
    EM_RESET_OFF,                 /* a reset leaves a constraint; fault.first: the event, fault.second: the row */
    EM_MODEL_JUMPS,               /* at a time that the model names, the momentum of coordinate fault.first */
    EM_RESET_INSIDE,              /* a reset puts the state where an impact's phi is negative; fault.first: the event,
                                     fault.second: that of the impact, fault.size: phi */
    EM_CONTACTS_CLASH,            /* no mode of contacts and frictions is consistent; fault.first, fault.second: the events
                                     of conditions that clash, -1: of a constraint */
    EM_VALUE_REFUSED              /* a symbol was declared to have other numbers; fault.first: its place in em_model's
                                     declared, fault.size: what it was given */
} em_status;

/* What a status means more closely, in place of fault.second: each has words of its own. */
typedef enum em_detail {
    EM_NEARLY_SINGULAR = -2,      /* of EM_SINGULAR_MASS_MATRIX: no step is short enough to follow it */
    EM_SINGULAR_START = -3,       /* of EM_DEPENDENT_CONSTRAINTS: at the start only */
    EM_CONTRADICTION = -4,        /* the row contradicts those that it depends on */
    EM_SHARED_LOAD = -5,          /* friction is in proportion to a multiplier that is not unique */
    EM_BAD_RESTITUTION = -6,      /* of EM_IMPACT_UNDEFINED: it is not from 0 to 1 but fault.size */
    EM_RESTITUTION_LOWERED = -7,  /* nobody knows its derivative */
    EM_LAW_NOT_DERIVED = -8,      /* nor that of this law of impacts */
    EM_NO_RATES = -9,             /* of EM_RESET_OFF: it names quasi-velocities where P is singular */
    EM_POSITION_JUMPS = -10,      /* of EM_MODEL_JUMPS: phi of row fault.first */
    EM_CONTACT_JUMPS = -11,       /* the speed of a contact that holds, row fault.first */
    EM_JAMMED = -12,              /* of EM_CONTACTS_CLASH: no acceleration satisfies them with friction */
    EM_TOO_MANY_MODES = -13,      /* to try */
    EM_NORMALS_NOT_FOUND = -14,   /* Newton's method on what presses on frictions */
    EM_INSIDE_CONTACT = -15       /* of EM_START_REFUSED: event fault.first */
} em_detail;

/* Where a failure sits: indices of coordinates, constraint rows or events, -1 where there is none. */
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

/* Those of fixed step are for steppers: first_step is how long their steps are, and nothing says how large their error. */
typedef enum em_method {
    EM_RK34 = 0, EM_DOPRI5, EM_DOP853, EM_RA15, EM_RK4, EM_MIDPOINT, EM_RADAU5, EM_RADAU9
} em_method;

enum { EM_DENSE_COEFFICIENTS = 10 }; /* rows a dense step stores at the most, each (n_state) */

/* A growing table: one time and `width` numbers a row. Owned by the run; em_release frees it. */
typedef struct em_rows {
    size_t count, capacity, width;
    size_t most; /* rows there may be, after which the last is written over and over; 0: as many as come */
    double *t;
    double *y; /* (capacity, width) */
} em_rows;

/* EM_DENSE: to be asked for states, so that steps are as short as that needs. EM_TO_DERIVE: it may be as it is. */
typedef enum em_kept { EM_NOT_KEPT, EM_DENSE, EM_TO_DERIVE } em_kept;

/* One accepted step kept for dense output: t in [t, t + h], coefficients in the run's dense table. */
typedef struct em_dense_step {
    double t, h;
    int mode, kept; /* kept: as em_run's, within the step */
    size_t segment;     /* of em_run's segments */
} em_dense_step;

/* What becomes of constraint rows that depend on each other: a fault; multipliers of least norm; or these where they do
 * from the start, a fault where they come to do so on the way. At one state, from the start is there. */
typedef enum em_dependent { EM_REFUSED, EM_SHARED, EM_SHARED_FROM_START } em_dependent;

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
    int least_norm;              /* em_dependent; once the run has begun, 0 where no rows were redundant at its start */
    int dense;                   /* em_kept: whether to keep every step's interpolant, and for what */
    const double *t_eval;        /* (n_t_eval) in the direction of time, or NULL: a row for every accepted step */
    size_t n_t_eval;
    const int *event_direction;  /* (n_events) -1, 0, 1 */
    const int *event_terminal;   /* (n_events) */
    int (*poll)(void *);         /* called about every 20 ms; non-zero ends the run as EM_INTERRUPTED; or NULL */
    void *poll_argument;

    /* --- what came of it --- */
    em_fault fault;              /* fault.status says how it ended */
    em_rows rows;                /* width n_state, published meaning */
    em_rows *events;             /* (n_events), width n_state */
    em_rows *after;              /* (n_events) the states after those that acted */
    em_rows segments;                /* width n_prepared + 1: between events that change the mode, where a model has modes:
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

#endif
