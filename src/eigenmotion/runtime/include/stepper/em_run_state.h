/* em_run_state.h: the state of a run, carried from step to step. em_model_calls.h has its calls to the model. */
#ifndef EM_RUN_STATE_H
#define EM_RUN_STATE_H

#include <time.h>

#include "stepper/em_time_events.h"
#include "numeric/em_packs.h"
#include "tableaux/em_radau_nodes.h"
#include "tableaux/em_radau_iia.h"
#include "tableaux/em_step_control.h"
#include "stepper/em_signals.h"
#include "tableaux/em_butcher.h"

enum {
    EM_MOTION = 2,     /* the mode of methods that solve for x and v (em_motion.h); 0 is the published system, 1 the triangular root */
    EM_SCREENED_STATES = 3,    /* states within every step at which events are screened */
    EM_NODES = 9,      /* nodes of root isolation, both ends included */
    EM_QUARTERS = 26,  /* further points, ever closer to the start, if an event function is zero there */
    EM_POINTS = EM_QUARTERS + EM_NODES,
    EM_MOST_FOUND = EM_POINTS + 4 * EM_NODES, /* of each event: four minima an interval; more indicate undersampling */
    EM_NODE_VECTORS = EM_NODE_COUNT / EM_LANES
};

typedef struct em_run_state em_run_state;

enum { EM_FIRST_SEGMENT = 1, EM_NEXT_SEGMENT }; /* segments of a run, between event actions */

/* A method as the stepper sees it (em_methods.h): how it steps from w->t, w->y by w->h to w->t_new, and its
 * interpolant. The meaning of the rows of F is up to the method. */
typedef struct em_scheme {
    em_size_control control;
    int terms;                           /* rows of its interpolant */
    int fixed;                           /* whether steps have the size that the caller sets, whatever their error,
                                            and are attempted once */
    int (*step)(em_run_state *w);        /* y_new, end_rate, error, weight, error_norm; 0, or -1 and w->reason */
    int (*judge)(em_run_state *w);       /* with f_new known: whether stiffness limits the step; also error_norm,
                                            size_norm if a step alone does not give them; or NULL */
    int (*interpolate)(em_run_state *w); /* F, of a step that has been settled; 0, or -1 and w->reason */
    int (*sketch)(em_run_state *w);      /* F as far as the stages alone give it; its terms, or -1: not available */
    void (*evaluate)(int n_state, const double *F, int terms, double theta, double *y); /* y (n_state) at t + theta h */
    int mode;                            /* its mode at the start: 0, or EM_MOTION, which does not change */
    int averages;                        /* whether steps cross the samples of linear signals */
    const em_radau_iia *radau_iia;       /* coefficients of an implicit method, else NULL */
    void (*within)(em_run_state *w);     /* recomputes error_norm, size_norm if a state within the step is requested;
                                            or NULL */
    int at_nodes;                        /* whether its steps need `nodes` */
} em_scheme;

/* A value g of an event function at a time; a pair of opposite signs, and the event. */
typedef struct em_point {
    double t, g;
} em_point;

typedef struct em_found {
    em_point before, after;
    int event;
} em_found;

/* Numbers at EM_LANES nodes of a step (em_gauss_radau.h) in one register. */
#if EM_LANES > 1
typedef double em_node_vector __attribute__((vector_size(8 * EM_LANES), may_alias));
#else
typedef double em_node_vector; /* a loop over the state may still be vectorised */
#endif

/* Data that a collocation step carries to the next: numbers, and tables of node vectors. */
typedef struct em_nodes {
    double size[EM_NODE_COUNT], before_size[EM_NODE_COUNT]; /* weighted size of each term of `series` and `before` */
    double t, t_new, h, before_h, before_t_new; /* of the steps of `series` and of `before` */
    double aimed;                            /* the error after the number of iterations that a step is designed for */
    double within;                           /* the error of the polynomial if the state within the step is requested */
    int mode, before_mode, converged, known, unpredicted, on_lanes; /* converged: `series` is valid; known: `before` is
                                                                 valid */
    int drifted;                             /* whether the positions at the nodes no longer agree with the integrals
                                                of the rates */
    int without_size;                        /* whether some number has no size within the step, so far, and no weight */
    int slow;                                /* whether the iteration converges slowly despite a good start */
    em_node_vector *Y[EM_NODE_VECTORS], *F[EM_NODE_VECTORS]; /* (n_state) the states at the nodes and their rates */
    em_node_vector *a[EM_NODE_VECTORS];                /* the rates from which the states were computed */
    em_node_vector *series[EM_NODE_VECTORS], *before[EM_NODE_VECTORS]; /* Legendre coefficients, of this step and the
                                                                          one before */
    em_node_vector *times, *u[EM_NODE_VECTORS];        /* (EM_NODE_VECTORS), (n_inputs) */
    double *weight;                          /* (n_state) the weight of a rate */
    double *miss;                            /* the difference between the polynomial and the rate at the end of the
                                                step */
} em_nodes;

/* Data that an implicit step carries to the next (em_stages.h): numbers, and tables. */
typedef struct em_implicit {
    double t, t_new, h, error;               /* of the last step whose stages were found: this one */
    double before_h, before_error;           /* of the last accepted step */
    double slopes_t, factored_h;
    double contraction;                      /* ratio of successive changes of the iteration */
    int iterations, sloped, outdated, known, accepted, averaged;
    int own;                                 /* for how many more steps each stage has its own slopes */
    double *K, *D;                           /* (n, n) da/dx and da/dv, at slopes_t, or at the end of a coupled step */
    double *G[1 + EM_MOST_PAIRS], *H[1 + EM_MOST_PAIRS]; /* (n, n) factors of the stage matrices, real and imaginary parts */
    int *pivot[1 + EM_MOST_PAIRS];           /* (n) */
    double *coupled;                         /* factors with slopes at each stage */
    int *coupled_pivot;
    double *a, *V, *X, *r;                   /* (EM_MOST_NODES, stride) at the stages */
    double *last;                            /* the accelerations of the last step whose stages were found */
    double *u;                               /* (1 + EM_MOST_NODES, n_inputs) signals at the start and the stages, if
                                                they are averaged */
} em_implicit;

/* Steps whose cost is counted, from a time on; cost: of the run until then, in right-hand sides. */
typedef struct em_cost_window {
    double t, cost;
    int steps;
} em_cost_window;

/* What the choice of the method carries from step to step (em_method_change.h). */
typedef struct em_choice {
    em_cost_window window; /* the last steps */
    em_cost_window limited; /* the explicit steps that stability has limited, about in a row */
    double explicit_rate;  /* cost per unit of time of the explicit method when it was left, 0: unknown; */
    double implicit_rate;  /* and of the implicit one */
    int windows, dear;     /* since the change; the last ones in a row in which the other method would have cost less */
    int patience;          /* after trials of the implicit method in vain: doublings of the strained steps before the
                              next; */
    int reluctance;        /* after those of the explicit method: of the windows in which its cost is remembered */
} em_choice;

/* Everything a run carries from step to step. `_new` is at the end of the current step. Saved are its first part,
 * the first parts of `nodes` and of `stages`, and all tables but the last (em_run_memory.h). */
struct em_run_state {
    double rtol, direction, t, t_new, h;
    double t_goal;                             /* the target time of the loop, which no step passes */
    long most_steps;                           /* accepted steps allowed on the way there */
    double stretch;                            /* rtol^(-1 / order): h stretch is the time scale of the motion */
    double h_next;                             /* step size that the controller proposes, positive */
    double pieces_end;                         /* the end of the current smooth interval, which no step passes */
    double inside[2];                          /* times between which the model is evaluated: between time events */
    int between;                               /* whether there are time events */
    int seeks_join;                            /* whether the last step was searched for a join of a table's pieces */
    int crosses;                               /* whether w->t is a time event that the state has not yet crossed;
                                                  -1: there is none */
    double error_norm;                         /* of the current step, which is accepted below 1 */
    double size_norm, log_size, last_error;    /* the norm that controls the next step size; its logarithm; that of
                                                  the last accepted step */
    double longest_step, strongest;            /* so far: |h|, and the smallest pivot of Delta with rows scaled to
                                                  length one */
    double farthest, fastest;                  /* the largest position and velocity so far, if nothing is settled */
    double energy, energy_tolerance;           /* at the start; its tolerance, the largest so far */
    double energy_time;                        /* the time of energy_start */
    int energy_changes;                        /* how many numbers of energy_start the tolerance counts so far */
    double depth;                               /* depth inside contacts at the start */
    long next_energy_check;                         /* the number of right-hand sides at which energy and drift are
                                                       checked next */
    em_fault reason;                           /* why the last attempt failed */
    int rank;                                  /* of the constraint rows, at the start */
    double last_pivots_t;                      /* the time of `last_pivots` */
    int pivots_known;                          /* whether they are known */
    int starts_near;                           /* whether the start is near a coordinate singularity */
    int retries;                               /* rejected attempts before this one */
    int near;                                  /* whether stages are settled, because a singular position is near */
    int mode, mode_new, moved, has_interpolant, n_found;
    int stiff;                                 /* whether something other than the error limits the step size */
    int acting, new_segment;                   /* whether an event acts; EM_FIRST_SEGMENT or EM_NEXT_SEGMENT before the
                                                  first accepted step of a segment, else 0 */
    int begun, ended;                          /* the first step size is known; the run has ended, with run->fault */
    int refused;                               /* it ended because the motion cannot start */
    int stale;                                 /* K[0] and g are out of date */
    size_t next_t_eval;
    em_choice choice;
    int plain;                                 /* whether the stages of the step are (em_is_plain) */
    em_run *run;                               /* from here on: belongs to the process, not to the motion */
    const em_model *model;
    const em_dynamics *dynamics;               /* functions of the model's state */
    const em_lanes *lanes;                     /* of the model; width 0 if there are none */
    int n, n_rows, n_positions, n_state, width, n_inputs, n_events, n_memory; /* width: n_state, padded */
    int stride;                                /* n, padded */
    int second_order, bare, first_rate;        /* bare: the model states no terms; first_rate: the first number of
                                                  the state whose rates at nodes are integrated */
    em_scheme scheme;
    const double *end_rate;                    /* f at t_new, y_raw if the step computes it, else NULL */
    struct timespec clock_read;                    /* when the clock was last read, and when poll was last called */
    struct timespec polled;
    unsigned clock_interval, attempts_since_clock; /* attempts between two readings of the clock */
    int requested_least_norm, base_least_norm; /* em_run.least_norm: set by the caller; chosen for all modes */
    int c_is_known;
    em_nodes nodes;
    em_implicit stages;
    void *block;                               /* the allocation, which contains the tables */
    char *tables, *node_tables;                /* the tables of the motion, and those of the nodes among them */
    size_t tables_size, node_tables_size;
    double *K[EM_STAGES];                      /* (width) K[0] = f(t, y); the others belong to the method */
    double *y, *y_new, *f_new;                 /* (width) */
    double *y_raw;                             /* y_new before it was settled */
    double *argument, *error, *weight;
    double *atol;                              /* (n), followed by zeros */
    double *spare;                             /* scratch, valid until another function is called */
    double *F[EM_DENSE_COEFFICIENTS];          /* (n_state) the interpolant of the step; its meaning is up to the
                                                  method */
    double *memory, *memory_new;               /* (n_memory) */
    double *u;                                 /* (n_inputs) */
    double *g, *g_new;                         /* (n_events) */
    double *noise, *zero;                      /* of g at the start of the run; the size below which g counts as 0
                                                  there */
    double *rounding;                          /* of gaps, slips and forces at the start of the segment */
    double *rate_shift;                        /* (m) change of rates along rows, caused by moving a start outside
                                                  contacts */
    double *quiet;                             /* the size above which a g that was zero at the start counts as
                                                  non-zero */
    double *longest;                           /* (m) squared lengths of the rows of B, the largest so far */
    double *row_rate, *row_tolerance;          /* (m) as those of the energy, for A v + b, if nothing is settled */
    double *last_pivots_x, *last_pivots;       /* (n) x at the end of a step, and the pivots of M there, where the next
                                                  step begins */
    double *energy_start;                      /* (4 n) x and v where the monitor of the energy began; the tolerances of
                                                  both there */
    em_found *found;                           /* sign changes in the current step */
    em_pile *pile;                             /* (n_events) */
    long *piece;                               /* (n_inputs) of each signal, valid within the step */
    int *side, *side_new;                      /* (n_events) the last non-zero sign of g, 0: none so far */
    int *fired, *acted;                       /* events that act, and those whose function jumps; events that have
                                                 acted */
    em_node_vector *c;                              /* (n_prepared) on lanes, if the method needs `nodes` */
};

#endif
