/* em_walk.h: what a run carries from step to step, and what it asks of the model on the way. */
#ifndef EM_WALK_H
#define EM_WALK_H

#include <time.h>

#ifdef EM_BREAKS
#include "em_breaks.h"
#endif
#include "em_motion.h"
#include "em_radau.h"
#include "em_radau_iia.h"
#include "em_signals.h"
#include "em_tableaux.h"

enum {
    EM_PACK = 4,
    EM_WIDTH = (N_STATE + EM_PACK - 1) / EM_PACK * EM_PACK, /* a state padded with zeros */
    EM_SOME_EVENTS = N_EVENTS > 0 ? N_EVENTS : 1,
    EM_GLANCES = 3,    /* states within every step at which events are looked at, */
    EM_NODES = 9,      /* those at its ends included where a closer look is needed, */
    EM_QUARTERS = 26,  /* and ever closer to a start at which one is zero */
    EM_PLACES = EM_QUARTERS + EM_NODES,
    EM_MOST_FOUND = N_EVENTS > 0 ? N_EVENTS * (EM_PLACES + 4 * EM_NODES) : 1, /* four dips a part, less is sampled */
    EM_SOME_INPUTS = N_INPUTS > 0 ? N_INPUTS : 1,
    EM_ROWS_OR_ONE = N_ROWS > 0 ? N_ROWS : 1,
    EM_SOME_MEMORY = N_MEMORY > 0 ? N_MEMORY : 1,
    EM_BUNDLES = EM_NODE_COUNT / EM_LANES,
    EM_FIRST_RATE = EM_SECOND_ORDER ? N : 0 /* of the state: what the rates at nodes are integrated for */
};

/* fmin and fmax for numbers: inline where the library's, which mind NaN, are calls. */
EM_INLINE double em_min(double a, double b) { return a < b ? a : b; }
EM_INLINE double em_max(double a, double b) { return a > b ? a : b; }

typedef struct em_walk em_walk;

enum { EM_FIRST_LEG = 1, EM_NEXT_LEG }; /* of a run, between events that act */

/* A method as the stepper sees it (em_methods.h): how it steps from w->t, w->y by w->h to w->t_new, and what it knows of
 * the states between. What the rows of F mean is its own affair. */
typedef struct em_scheme {
    int error_order;                /* steps are chosen by an error that is O(h^(error_order + 1)), */
    double present, past;           /* with what weight that of this step, and that of the one before, */
    double growth;                  /* and no step is longer than so many times the one before */
    int terms;                      /* of its interpolant */
    int fixed;                      /* whether steps are as long as told, whatever their error, and made once */
    int (*step)(em_walk *w);        /* y_new, end_rate, error, weight, error_norm; 0, or -1 and w->reason */
    int (*judge)(em_walk *w);       /* with f_new known: whether the scene is stiff; error_norm, size_norm anew where a
                                       step alone does not tell; or NULL */
    int (*interpolate)(em_walk *w); /* F, of a step that has been settled; 0, or -1 and w->reason */
    int (*sketch)(em_walk *w);      /* F as far as the step alone tells; its terms, or -1: it does not */
    void (*evaluate)(const double *F, int terms, double theta, double *y); /* y (n_state) at t + theta h */
    int mode;                       /* in which it starts: 0, or EM_MOTION, in which it stays */
    int averages;                   /* whether steps cross the samples of linear signals */
    const em_radau_iia *radau_iia;  /* coefficients of an implicit method, else NULL */
    void (*within)(em_walk *w);     /* error_norm, size_norm anew where a state within the step is asked for; or NULL */
} em_scheme;

/* A number g at a time; two of different signs, and whose they are. */
typedef struct em_point {
    double t, g;
} em_point;

typedef struct em_found {
    em_point before, after;
    int event;
} em_found;

/* Numbers at EM_LANES nodes of a step (em_nodes.h) in one register. */
#if EM_LANES > 1
typedef double em_bundle __attribute__((vector_size(8 * EM_LANES), may_alias));
#else
typedef double em_bundle; /* a loop over the state may then become vectors after all */
#endif

#ifdef EM_MODEL_LANES
#define EM_FOR_LANES (size_t)EM_MODEL_LANES.n_prepared
#else
#define EM_FOR_LANES 0
#endif

/* What a step by nodes carries from one to the next. */
typedef struct em_nodes {
    em_bundle Y[EM_BUNDLES][N_STATE], F[EM_BUNDLES][N_STATE]; /* the states there and their rates */
    em_bundle a[EM_BUNDLES][N_STATE];                         /* the rates that the states were made of */
    em_bundle series[EM_BUNDLES][N_STATE], before[EM_BUNDLES][N_STATE]; /* Legendre's, of this step and the one before */
    em_bundle times[EM_BUNDLES], u[EM_BUNDLES][EM_SOME_INPUTS];
    double weight[N_STATE];                  /* what a rate counts */
    double miss[N_STATE];                    /* by how much the polynomial misses the rate at the end of the step */
    double size[EM_NODE_COUNT], before_size[EM_NODE_COUNT]; /* of each term of these series, so weighed */
    double t, t_new, h, before_h, before_t_new; /* of the step that `series` is of, and `before` */
    double aimed;                            /* the error after as many iterations as a step is made for */
    double within;                           /* the error of the polynomial where the state within the step is asked for */
    int mode, before_mode, converged, known, blind, on_lanes; /* converged: there is a series; known: a step before */
    int drifted;                             /* whether the places at the nodes are those that the rates make */
    int slow;                                /* whether the iteration converges slowly, though it had little to do */
} em_nodes;

/* What a step by implicit stages carries from one to the next (em_stages.h). */
typedef struct em_implicit {
    double K[N * N], D[N * N];                       /* da/dx and da/dv, at slopes_t, or at the end of a coupled step */
    double G[1 + EM_MOST_PAIRS][N * N], H[1 + EM_MOST_PAIRS][N * N]; /* factors made of them, re and im, */
    int pivot[1 + EM_MOST_PAIRS][N];
    double coupled[EM_MOST_NODES * N * EM_MOST_NODES * N]; /* and of slopes at each stage */
    int coupled_pivot[EM_MOST_NODES * N];
    double a[EM_MOST_NODES][N], V[EM_MOST_NODES][N], X[EM_MOST_NODES][N], r[EM_MOST_NODES][N]; /* of the stages */
    double last[EM_MOST_NODES][N];                   /* the accelerations of the last step whose stages were found, */
    double t, t_new, h, error;                       /* which is this one; */
    double before_h, before_error;                   /* of the last accepted one */
    double u[1 + EM_MOST_NODES][EM_SOME_INPUTS];     /* signals at the start and the stages, where they are averaged */
    double slopes_t, factored_h;
    double contraction;                              /* of the iteration's changes, from one to the next */
    int iterations, sloped, outdated, known, accepted, averaged;
    int own;                                         /* for how many steps to come stages have slopes of their own */
} em_implicit;

/* The pivots of M where a step has ended, with which the next one begins (em_chart.h). */
typedef struct em_seen_pivots {
    double t, x[N], pivots[N];
    int known;
} em_seen_pivots;

/* Everything a run carries from step to step. `_new` belongs to the end of the step under way. */
struct em_walk {
    double K[EM_STAGES][EM_WIDTH];             /* K[0] = f(t, y); the others are the method's */
    double y[EM_WIDTH], y_new[EM_WIDTH], f_new[EM_WIDTH];
    double y_raw[EM_WIDTH];                    /* y_new before it was settled */
    double argument[EM_WIDTH], error[EM_WIDTH], weight[EM_WIDTH];
    em_nodes nodes;
    em_implicit stages;
    double F[EM_DENSE_COEFFICIENTS][N_STATE];  /* the interpolant of the step: what it means is the method's */
    double memory[EM_SOME_MEMORY], memory_new[EM_SOME_MEMORY];
    double u[EM_SOME_INPUTS];
    double g[EM_SOME_EVENTS], g_new[EM_SOME_EVENTS];
    double noise[EM_SOME_EVENTS], zero[EM_SOME_EVENTS]; /* of g at the start of the run, and what is no more than 0 there */
    double rounding[EM_SOME_EVENTS], deep;     /* of gaps and slips as the leg begins; how far inside contacts the run starts */
    double stirred[EM_ROWS_OR_ONE];            /* what putting it outside has made of rates */
    double quiet[EM_SOME_EVENTS];              /* beyond which a g that was zero at the start is so no longer */
    em_found found[EM_MOST_FOUND];             /* what passes zero in the step under way */
    long piece[EM_SOME_INPUTS];                /* of each signal, valid within the step */
    double rtol, direction, t, t_new, h;
    double t_goal;                             /* where the loop goes now: no step goes beyond */
    long most_steps;                           /* accepted ones there may be on the way */
    double stretch;                            /* rtol^(-1 / order): h stretch is the time on which the motion varies */
    double h_next;                             /* size the controller proposes, positive */
    double pieces_end;                         /* where the first piece ends: no step goes beyond */
#ifdef EM_BREAKS
    double inside[2];                          /* times between which conditions in the time alone are what they are */
    int crosses;                               /* whether w->t is a break, whose other side the state is not yet on; -1: there is none */
#endif
    double error_norm;                         /* of the step under way: it counts below 1 */
    double size_norm, log_size, last_error;    /* what the next step is chosen by; its log; that of the last accepted one */
    double longest[EM_ROWS_OR_ONE];            /* squared lengths of the rows of B, the largest so far */
    double longest_step, strongest;            /* so far: |h|, and the smallest pivot of Delta with rows in such units */
    double farthest, fastest;                  /* the largest distance and velocity so far, where nothing is settled */
    double energy, energy_tolerance;           /* at the start; what the tolerances make of it, the largest so far */
    double row_rate[EM_ROWS_OR_ONE], row_tolerance[EM_ROWS_OR_ONE]; /* the same of A v + b, where nothing is settled */
    long next_witness;                         /* the number of right-hand sides at which these are looked at again */
    em_fault reason;                           /* why the last attempt at a step failed */
    int rank;                                  /* of the constraint rows, at the start */
    em_seen_pivots seen_pivots;
    int starts_near;                           /* whether the start is near a singularity of the chart */
    int retries;                               /* how many rejected ones the step under way follows */
    int near;                                  /* whether stages are settled: a singular position is near */
    int mode, mode_new, moved, has_interpolant, n_found;
    int stiff;                                 /* whether something else than their error keeps steps short */
    int side[EM_SOME_EVENTS], side_new[EM_SOME_EVENTS]; /* the last sign of g, 0: has been zero so far */
    int fired[EM_SOME_EVENTS], struck[EM_SOME_EVENTS]; /* what acts, and whose number jumps; what has acted */
    int acting, fresh;                         /* whether something acts; which leg no step has ended of: EM_FIRST_LEG */
    em_pile pile[EM_SOME_EVENTS];
    int begun, ended;                          /* the first step is known; the run is over, with run->fault, */
    int refused;                               /* because no motion starts there */
    int stale;                                 /* what K[0] and g were made with is no longer so */
    size_t next_t_eval;
    em_run *run;                               /* from here on: not of the motion, but of this process */
    em_scheme scheme;
    const double *end_rate;                    /* f at t_new, y_raw where the step knows it, else NULL */
    struct timespec looked;                    /* when the time was last looked at, and when poll was last called */
    struct timespec polled;
    unsigned looks_every, attempts_since_look;
    int asked, shares;                         /* em_run.least_norm as the caller has it; as it is but for modes */
    void *block;                               /* what to free */
    em_bundle *c;                              /* (n_prepared) for lanes, behind the walk; and whether they are there */
    int c_is_known;
};

/* The time at which the model is asked for what holds at t in the step under way (em_breaks.h). */
EM_INLINE double em_clock(EM_UNUSED const em_walk *w, double t) {
#ifdef EM_BREAKS
    return em_min(em_max(t, w->inside[0]), w->inside[1]);
#else
    return t;
#endif
}

static void em_signals(em_walk *w, double t) {
    for (int i = 0; i < N_INPUTS; ++i) {
        const em_signal *u = &w->run->inputs[i];
        const int crosses = u->kind == EM_LINEAR && w->scheme.averages;
        w->u[i] = em_signal_at(u, crosses ? em_signal_piece(u, t, w->direction) : w->piece[i], t);
    }
}

/* What stands behind a fault of a right-hand side at y. Returns -1 (em_guard.h). */
EM_RARE static int em_blame(em_walk *w, double t, const double *y);

/* What is asked of constraint rows. */
static int em_constraint_flags(const em_run *run) { return run->least_norm ? EM_LEAST_NORM | run->kept : 0; }

/* dy <- (v, a) at a state of the motion, with the signals in w->u. */
EM_COLD int em_motion_rate_here(em_walk *w, double t, const double *y, double *dy) {
    em_run *run = w->run;
    ++run->n_rhs;
    const int flags = em_constraint_flags(run);
    return em_motion_rhs(em_clock(w, t), y, run->prepared, w->u, w->memory, flags, dy, &w->reason) ? em_blame(w, t, y) : 0;
}

/* dy <- f(t, y) with the signals at t. */
EM_INLINE int em_rhs(em_walk *w, int mode, double t, const double *y, double *memory, double *dy) {
    em_run *run = w->run;
    if (N_INPUTS > 0) em_signals(w, t);
    if (mode == EM_MOTION && !EM_CARRIES_MOTION) return em_motion_rate_here(w, t, y, dy);
    ++run->n_rhs;
    t = em_clock(w, t);
    return model_rhs(mode, t, y, run->prepared, w->u, memory, em_constraint_flags(run), dy, &w->reason) ? em_blame(w, t, y) : 0;
}

/* v (n) <- xdot. 0, or -1 and *fault */
static int em_xdot(const em_run *run, int mode, double t, const double *y, double *v, em_fault *fault) {
    if (mode != EM_MOTION) return model_velocity(mode, t, y, run->prepared, v, fault);
    memcpy(v, y + N, N * sizeof *v);
    return 0;
}

/* ev (n) <- what an error e (n) of y[N .. 2 N) makes of xdot */
static void em_velocity_error(const em_walk *w, const double *e, double *ev) {
    if (w->mode == EM_MOTION) memcpy(ev, e, N * sizeof *ev);
    else model_velocity_error(w->mode, w->y, w->run->prepared, w->memory, e, ev);
}

/* row (n_state) <- y in the published meaning. 0, or -1 and *fault */
EM_UNUSED static int em_publish(const em_run *run, int mode, double t, const double *y, const double *memory,
                                double *row, em_fault *fault) {
    if (mode == EM_MOTION) return em_motion_publish(t, y, run->prepared, row, fault);
    return model_publish(mode, t, y, run->prepared, memory, row, fault);
}

static int em_settle(const em_run *run, int *mode, int flags, double t, double *y, double *memory, double pace,
                     em_fault *fault) {
    if (!SETTLES && run->stabilise && !(flags & EM_BEGIN)) return 0;
    if (run->stabilise) flags |= EM_STABILISE;
    if (!(flags & EM_LEAST_NORM)) flags |= em_constraint_flags(run);
    if (*mode == EM_MOTION) return em_motion_settle(flags, t, y, run->prepared, memory, pace, fault);
    return model_settle(mode, flags, t, y, run->prepared, memory, pace, fault);
}

/* The published state in w->y as that of the scheme's mode, settled. As em_settle. */
EM_UNUSED static int em_enter_mode(em_walk *w) {
    double v[N];
    if (w->scheme.mode == EM_MOTION) {
        if (em_xdot(w->run, 0, w->t, w->y, v, &w->reason)) return -1;
        memcpy(w->y + N, v, sizeof v);
        w->mode = EM_MOTION;
    }
    return em_settle(w->run, &w->mode, EM_BEGIN, w->t, w->y, w->memory, 0.0, &w->reason);
}

/* dy <- f at the nearest point on the constraints. Where their rows lose their directions, as near a singular position,
 * an argument that is off them by e has rates that are off by e over the square of what is left; on them they are not. */
EM_COLD int em_settled_rhs(em_walk *w, double t, const double *y, double *dy) {
    double settled[EM_WIDTH], memory[EM_SOME_MEMORY];
    int mode = w->mode;
    memcpy(settled, y, sizeof settled);
    memcpy(memory, w->memory, sizeof memory);
    if (em_settle(w->run, &mode, EM_KEEP_MODE, em_clock(w, t), settled, memory, 0.0, &w->reason) < 0) return -1;
    return em_rhs(w, mode, t, settled, memory, dy);
}

/* dy <- f within a step. */
EM_INLINE int em_stage_rate(em_walk *w, double t, const double *y, double *dy) {
    return N_POSITIONS > 0 && w->near ? em_settled_rhs(w, t, y, dy) : em_rhs(w, w->mode, t, y, w->memory, dy);
}

/* NaN and infinity survive a product with zero. */
EM_INLINE int em_all_finite(const double *restrict y) {
    double sum[EM_PACK] = {0.0};
    for (int k = 0; k < EM_WIDTH; k += EM_PACK)
        for (int place = 0; place < EM_PACK; ++place) sum[place] += 0.0 * y[k + place];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]) == 0.0;
}

#endif
