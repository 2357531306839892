/* em_lanes.h: the functions a model offers on lanes, one run in each lane of a vector.
 *
 * Included by eigenmotion.h alone, whose words and version hold here.
 */
#ifndef EM_LANES_H
#define EM_LANES_H

#include "em_run.h"

/* Runs side by side, one in each lane: what em_lanes.run works with. Tables are (..., width), number by number, on
 * addresses that are multiples of 64, and 0 where nobody wrote; rows of states are padded to a multiple of 4. */
enum { EM_MOST_LANES = 8 };
typedef enum em_landing {
    EM_SETTLED,
    EM_UNSETTLED, /* that is to be done number by number; */
    EM_LOST       /* so are all of the run's steps, from its start */
} em_landing;
typedef struct em_lane_group {
    const em_run *task;   /* what is asked of all */
    int mode;             /* of all */
    double rtol, direction, stretch; /* as a run_state has them (em_run_state.h) */
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
    int (*look)(struct em_lane_group *f, int lane, em_landing landing);
    int (*stopped)(struct em_lane_group *f); /* whether all are to end */
    void *with;           /* whose they are */
} em_lane_group;

/* The right-hand side of `width` states side by side, number by number: y[k width + lane], and so t, c, u, dy. Where a
 * lane is singular its dy is NaN. width 0: there is none. */
typedef struct em_lanes {
    int width;
    void (*rhs)(int mode, const double *t, const double *y, const double *c, const double *u, int flags, double *dy);
    /* v (n): xdot alone, of states in mode 0, where it costs little; or NULL */
    void (*velocity)(const double *t, const double *y, const double *c, double *v);
    void (*run)(em_lane_group *f); /* until no lane has a run; dop853, stabilised, inputs constant; or NULL */
    int remembered, modes;    /* numbers that a run keeps of its last step; modes of runs, each in flocks of its own */
    int n_prepared;
} em_lanes;

#endif
