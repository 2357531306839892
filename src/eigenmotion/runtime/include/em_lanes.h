/* em_lanes.h: the functions a model offers on lanes, one run in each lane of a vector.
 *
 * Included by eigenmotion.h alone, whose conventions and version apply here. */
#ifndef EM_LANES_H
#define EM_LANES_H

#include "em_run.h"

/* A lane group: runs side by side, one in each lane. em_lanes.run works on it. Tables are (..., width), the lanes of
 * one number next to each other, aligned to 64 bytes, and 0 where nothing has been written; rows of states are
 * padded to a multiple of 4. */
enum { EM_MOST_LANES = 8 };
typedef enum em_lane_outcome {
    EM_SETTLED,
    EM_UNSETTLED, /* the scalar code finishes the step */
    EM_LOST       /* the scalar code repeats the whole run */
} em_lane_outcome;
typedef struct em_lane_group {
    const em_run *task;   /* the task of all runs */
    int mode;             /* of all runs */
    double rtol, direction, stretch; /* as in em_run_state.h */
    double *y, *y_new, *f_new; /* (n_state, width) */
    double *memory, *memory_new; /* (remembered, width) */
    double *K;            /* (12, n_state, width): K_0 is f at y */
    double *c, *u;        /* (n_prepared, width), (n_inputs, width) */
    double *t, *t_new, *h, *h_next, *error, *last_error, *longest; /* (width) */
    double *n_steps, *n_rejected, *retries, *n_rhs;
    double *stiff, *n_stiff;      /* (width) 1 where stability limits the step size; the number of such steps */
    double *next_stiffness_check; /* (width) the step at which stiffness is tested next */
    double *next_check, *t_check; /* (width) the number of right-hand sides, and the time, at which the scalar code
                                     checks a step */
    int live[EM_MOST_LANES], n_live; /* lanes that hold a run */
    int check_always;     /* the scalar code checks every step */
    int yields;           /* the other group continues first */
    /* Checks the step that a lane has made. 0: its run continues; else the lane now holds another run, or none. */
    int (*check_step)(struct em_lane_group *f, int lane, em_lane_outcome outcome);
    int (*stopped)(struct em_lane_group *f); /* whether the caller has requested the end of all runs */
    void *owner;          /* of the group */
} em_lane_group;

/* The right-hand side of `width` states side by side: y[k width + lane], and so t, c, u, dy. Where a lane is
 * singular its dy is NaN. width 0: there is no such function. */
typedef struct em_lanes {
    int width;
    void (*rhs)(int mode, const double *t, const double *y, const double *c, const double *u, int flags, double *dy);
    /* v (n): xdot alone, of states in mode 0, where it is cheap; or NULL */
    void (*velocity)(const double *t, const double *y, const double *c, double *v);
    void (*run)(em_lane_group *f); /* until no lane holds a run; dop853, stabilised, constant inputs; or NULL */
    int remembered, modes;    /* numbers that a run keeps from its last step; modes of runs, each with lane groups of
                                 its own */
    int n_prepared;
} em_lanes;

#endif
