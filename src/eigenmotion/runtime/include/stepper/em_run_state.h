/* em_run_state.h: the state of a run, carried from step to step. em_model_calls.h has its calls to the model. */
#ifndef EM_RUN_STATE_H
#define EM_RUN_STATE_H

#include <time.h>

#include "stepper/em_time_events.h"
#include "numeric/em_packs.h"
#include "tableaux/em_radau_nodes.h"
#include "tableaux/em_radau_iia.h"
#include "stepper/em_signals.h"
#include "tableaux/em_butcher.h"

enum {
    EM_MOTION = 2,     /* the mode of methods that solve for x and v (em_motion.h); 0 is the published system, 1 the triangular root */
    EM_SCREENED_STATES = 3,    /* states within every step at which events are looked at, */
    EM_NODES = 9,      /* those at its ends included where a closer look is needed, */
    EM_QUARTERS = 26,  /* and ever closer to a start at which one is zero */
    EM_PLACES = EM_QUARTERS + EM_NODES,
    EM_MOST_FOUND = EM_PLACES + 4 * EM_NODES, /* of each event: four dips a part, less is sampled */
    EM_NODE_VECTORS = EM_NODE_COUNT / EM_LANES
};

typedef struct em_run_state em_run_state;

enum { EM_FIRST_SEGMENT = 1, EM_NEXT_SEGMENT }; /* of a run, between events that act */

/* A method as the stepper sees it (em_methods.h): how it steps from w->t, w->y by w->h to w->t_new, and what it knows of
 * the states between. What the rows of F mean is its own affair. */
typedef struct em_scheme {
    int error_order;                /* steps are chosen by an error that is O(h^(error_order + 1)), */
    double present, past;           /* with what weight that of this step, and that of the one before, */
    double growth;                  /* and no step is longer than so many times the one before */
    int terms;                      /* of its interpolant */
    int fixed;                      /* whether steps are as long as told, whatever their error, and made once */
    int (*step)(em_run_state *w);        /* y_new, end_rate, error, weight, error_norm; 0, or -1 and w->reason */
    int (*judge)(em_run_state *w);       /* with f_new known: whether the scene is stiff; error_norm, size_norm anew where a
                                       step alone does not tell; or NULL */
    int (*interpolate)(em_run_state *w); /* F, of a step that has been settled; 0, or -1 and w->reason */
    int (*sketch)(em_run_state *w);      /* F as far as the step alone tells; its terms, or -1: it does not */
    void (*evaluate)(int n_state, const double *F, int terms, double theta, double *y); /* y (n_state) at t + theta h */
    int mode;                       /* in which it starts: 0, or EM_MOTION, in which it stays */
    int averages;                   /* whether steps cross the samples of linear signals */
    const em_radau_iia *radau_iia;  /* coefficients of an implicit method, else NULL */
    void (*within)(em_run_state *w);     /* error_norm, size_norm anew where a state within the step is asked for; or NULL */
} em_scheme;

/* A number g at a time; two of different signs, and whose they are. */
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
typedef double em_node_vector; /* a loop over the state may then become vectors after all */
#endif

/* What a step by nodes carries from one to the next: numbers, and tables by bundles of nodes. */
typedef struct em_nodes {
    double size[EM_NODE_COUNT], before_size[EM_NODE_COUNT]; /* of each term of these series, so weighed */
    double t, t_new, h, before_h, before_t_new; /* of the step that `series` is of, and `before` */
    double aimed;                            /* the error after as many iterations as a step is made for */
    double within;                           /* the error of the polynomial where the state within the step is asked for */
    int mode, before_mode, converged, known, blind, on_lanes; /* converged: there is a series; known: a step before */
    int drifted;                             /* whether the places at the nodes are those that the rates make */
    int slow;                                /* whether the iteration converges slowly, though it had little to do */
    em_node_vector *Y[EM_NODE_VECTORS], *F[EM_NODE_VECTORS]; /* (n_state) the states there and their rates */
    em_node_vector *a[EM_NODE_VECTORS];                /* the rates that the states were made of */
    em_node_vector *series[EM_NODE_VECTORS], *before[EM_NODE_VECTORS]; /* Legendre's, of this step and the one before */
    em_node_vector *times, *u[EM_NODE_VECTORS];        /* (EM_NODE_VECTORS), (n_inputs) */
    double *weight;                          /* (n_state) what a rate counts */
    double *miss;                            /* by how much the polynomial misses the rate at the end of the step */
} em_nodes;

/* What a step by implicit stages carries from one to the next (em_stages.h): numbers, and tables. */
typedef struct em_implicit {
    double t, t_new, h, error;               /* of the last step whose stages were found, which is this one; */
    double before_h, before_error;           /* of the last accepted one */
    double slopes_t, factored_h;
    double contraction;                      /* of the iteration's changes, from one to the next */
    int iterations, sloped, outdated, known, accepted, averaged;
    int own;                                 /* for how many steps to come stages have slopes of their own */
    double *K, *D;                           /* (n, n) da/dx and da/dv, at slopes_t, or at the end of a coupled step */
    double *G[1 + EM_MOST_PAIRS], *H[1 + EM_MOST_PAIRS]; /* (n, n) factors made of them, re and im, */
    int *pivot[1 + EM_MOST_PAIRS];           /* (n) */
    double *coupled;                         /* and of slopes at each stage */
    int *coupled_pivot;
    double *a, *V, *X, *r;                   /* (EM_MOST_NODES, stride) of the stages */
    double *last;                            /* the accelerations of the last step whose stages were found */
    double *u;                               /* (1 + EM_MOST_NODES, n_inputs) signals at the start and the stages, where they are averaged */
} em_implicit;

/* Everything a run carries from step to step. `_new` belongs to the end of the step under way. What is saved of it is its
 * beginning, that of `nodes` and of `stages`, and all tables but the last (em_run_memory.h). */
struct em_run_state {
    double rtol, direction, t, t_new, h;
    double t_goal;                             /* where the loop goes now: no step goes beyond */
    long most_steps;                           /* accepted ones there may be on the way */
    double stretch;                            /* rtol^(-1 / order): h stretch is the time on which the motion varies */
    double h_next;                             /* size the controller proposes, positive */
    double pieces_end;                         /* where the first piece ends: no step goes beyond */
    double inside[2];                          /* times between which conditions in the time alone are what they are */
    int crosses;                               /* whether w->t is a break, whose other side the state is not yet on; -1: there is none */
    double error_norm;                         /* of the step under way: it counts below 1 */
    double size_norm, log_size, last_error;    /* what the next step is chosen by; its log; that of the last accepted one */
    double longest_step, strongest;            /* so far: |h|, and the smallest pivot of Delta with rows in such units */
    double farthest, fastest;                  /* the largest distance and velocity so far, where nothing is settled */
    double energy, energy_tolerance;           /* at the start; what the tolerances make of it, the largest so far */
    double deep;                               /* how far inside contacts the run starts */
    long next_energy_check;                         /* the number of right-hand sides at which these are looked at again */
    em_fault reason;                           /* why the last attempt at a step failed */
    int rank;                                  /* of the constraint rows, at the start */
    double seen_t;                             /* where `seen_pivots` are of; */
    int seen;                                  /* whether they are known */
    int starts_near;                           /* whether the start is near a singularity of the chart */
    int retries;                               /* how many rejected ones the step under way follows */
    int near;                                  /* whether stages are settled: a singular position is near */
    int mode, mode_new, moved, has_interpolant, n_found;
    int stiff;                                 /* whether something else than their error keeps steps short */
    int acting, fresh;                         /* whether something acts; which segment no step has ended of: EM_FIRST_SEGMENT */
    int begun, ended;                          /* the first step is known; the run is over, with run->fault, */
    int refused;                               /* because no motion starts there */
    int stale;                                 /* what K[0] and g were made with is no longer so */
    size_t next_t_eval;
    em_run *run;                               /* from here on: not of the motion, but of this process */
    const em_model *model;
    const em_dynamics *of;                     /* what is asked of it */
    const em_lanes *lanes;                     /* its; of width 0 where there are none */
    int n, n_rows, n_positions, n_state, width, n_inputs, n_events, n_memory; /* width: n_state, padded, */
    int stride;                                /* and n */
    int second_order, bare, first_rate;        /* bare: states no terms; of the state: what the rates at nodes are integrated for */
    em_scheme scheme;
    const double *end_rate;                    /* f at t_new, y_raw where the step knows it, else NULL */
    struct timespec looked;                    /* when the time was last looked at, and when poll was last called */
    struct timespec polled;
    unsigned looks_every, attempts_since_look;
    int asked, shares;                         /* em_run.least_norm as the caller has it; as it is but for modes */
    int c_is_known;
    em_nodes nodes;
    em_implicit stages;
    void *block;                               /* what to free; tables are in it, */
    char *tables, *node_tables;                /* those of the motion, and of nodes among them, */
    size_t tables_size, node_tables_size;
    double *K[EM_STAGES];                      /* (width) K[0] = f(t, y); the others are the method's */
    double *y, *y_new, *f_new;                 /* (width) */
    double *y_raw;                             /* y_new before it was settled */
    double *argument, *error, *weight;
    double *atol;                              /* (n) and zeros */
    double *spare;                             /* to work with, as long as nobody else is called */
    double *F[EM_DENSE_COEFFICIENTS];          /* (n_state) the interpolant of the step: what it means is the method's */
    double *memory, *memory_new;               /* (n_memory) */
    double *u;                                 /* (n_inputs) */
    double *g, *g_new;                         /* (n_events) */
    double *noise, *zero;                      /* of g at the start of the run, and what is no more than 0 there */
    double *rounding;                          /* of gaps and slips as the segment begins */
    double *stirred;                           /* (m) what putting a start outside contacts has made of rates along rows */
    double *quiet;                             /* beyond which a g that was zero at the start is so no longer */
    double *longest;                           /* (m) squared lengths of the rows of B, the largest so far */
    double *row_rate, *row_tolerance;          /* (m) as the energy's of A v + b, where nothing is settled */
    double *seen_x, *seen_pivots;              /* (n) where a step has ended, and the pivots of M there, with which the next begins */
    em_found *found;                           /* what passes zero in the step under way */
    em_pile *pile;                             /* (n_events) */
    long *piece;                               /* (n_inputs) of each signal, valid within the step */
    int *side, *side_new;                      /* (n_events) the last sign of g, 0: has been zero so far */
    int *fired, *acted;                       /* what acts, and whose number jumps; what has acted */
    em_node_vector *c;                              /* (n_prepared) for lanes */
};

#endif
