/* em_step.h: one step of an explicit Runge-Kutta method and its error in x and v.
 *
 * em_take_step is inlined once for each method, with its tableau a constant: the loops over stages and coefficients
 * unroll, zero coefficients vanish, and what stays are vector loops over the states.
 */
#ifndef EM_STEP_H
#define EM_STEP_H

#include <time.h>

#include "em_linear.h"
#include "em_tableaux.h"

/* Before a loop over stages or coefficients: unroll it wholly, so that the tableau's numbers become constants. */
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpass-failed" /* below -O2 it does not, and says so: slower, not wrong */
#define EM_UNROLL _Pragma("unroll")
#else
#define EM_UNROLL _Pragma("GCC unroll 16")
#endif

enum {
    EM_LANES = 4,
    EM_WIDTH = (N_STATE + EM_LANES - 1) / EM_LANES * EM_LANES, /* a state padded with zeros */
    EM_SOME_EVENTS = N_EVENTS > 0 ? N_EVENTS : 1,
    EM_GLANCES = 3,    /* states within every step at which events are looked at, */
    EM_NODES = 9,      /* those at its ends included where a closer look is needed, */
    EM_QUARTERS = 26,  /* and ever closer to a start at which one is zero */
    EM_PLACES = EM_QUARTERS + EM_NODES,
    EM_MOST_FOUND = N_EVENTS > 0 ? N_EVENTS * (EM_PLACES + EM_NODES) : 1,
    EM_SOME_INPUTS = N_INPUTS > 0 ? N_INPUTS : 1,
    EM_SOME_MEMORY = N_MEMORY > 0 ? N_MEMORY : 1
};

/* fmin and fmax for numbers: inline where the library's, which mind NaN, are calls. */
EM_INLINE double em_min(double a, double b) { return a < b ? a : b; }
EM_INLINE double em_max(double a, double b) { return a > b ? a : b; }

struct em_scheme;

/* A number g at a time; two of different signs, and whose they are. */
typedef struct em_point {
    double t, g;
} em_point;

typedef struct em_found {
    em_point before, after;
    int event;
} em_found;

/* Everything a run carries from step to step. `_new` belongs to the end of the step under way. */
typedef struct em_walk {
    double K[EM_STAGES][EM_WIDTH]; /* K[0] = f(t, y) */
    double y[EM_WIDTH], y_new[EM_WIDTH], f_new[EM_WIDTH];
    double y_raw[EM_WIDTH];                    /* y_new before it was settled */
    double argument[EM_WIDTH], error[EM_WIDTH], weight[EM_WIDTH];
    double F[EM_DENSE_COEFFICIENTS][N_STATE];  /* the interpolant of the step: y, F_0, F_1, ... */
    double memory[EM_SOME_MEMORY], memory_new[EM_SOME_MEMORY];
    double u[EM_SOME_INPUTS];
    double g[EM_SOME_EVENTS], g_new[EM_SOME_EVENTS];
    double noise[EM_SOME_EVENTS], zero[EM_SOME_EVENTS]; /* of g at the start of the run, and what is no more than 0 there */
    double quiet[EM_SOME_EVENTS];              /* beyond which a g that was zero at the start is so no longer */
    em_found found[EM_MOST_FOUND];             /* what passes zero in the step under way */
    long piece[EM_SOME_INPUTS];                /* of each signal, valid within the step */
    em_run *run;
    const struct em_scheme *scheme;
    double rtol, direction, t, t_new, h;
    double stretch;                            /* rtol^(-1 / order): h stretch is the time on which the motion varies */
    double h_next;                             /* size the controller proposes, positive */
    double signals_end;                        /* where the first piece ends: no step goes beyond */
    double error_norm, last_error;             /* of the step under way; log of that of the last accepted one */
    double longest[N_ROWS > 0 ? N_ROWS : 1];   /* squared lengths of the rows of B, the largest so far */
    double longest_step, strongest;            /* so far: |h|, and the smallest pivot of Delta with rows in such units */
    double farthest, fastest;                  /* the largest distance and velocity so far, where nothing is settled */
    double energy, energy_tolerance;           /* at the start; what the tolerances make of it, the largest so far */
    long next_witness;                         /* the number of right-hand sides at which it is looked at again */
    em_fault reason;                           /* why the last attempt at a step failed */
    int rank;                                  /* of the constraint rows, at the start */
    int starts_near;                           /* whether the start is near a singularity of the chart */
    int retries;                               /* how many rejected ones the step under way follows */
    int near;                                  /* whether stages are settled: a singular position is near */
    int mode, mode_new, moved, has_interpolant, n_found;
    int side[EM_SOME_EVENTS], side_new[EM_SOME_EVENTS]; /* the last sign of g, 0: has been zero so far */
    size_t next_t_eval;
    struct timespec looked;                    /* when the time was last looked at, and when poll was last called */
    struct timespec polled;
    unsigned looks_every, attempts_since_look;
    void *block;                               /* what to free */
} em_walk;

/* The three methods as the stepping loop sees them. */
typedef struct em_scheme {
    const em_tableau *tableau;
    int (*step)(em_walk *w);   /* stages, y_new and error_norm; 0, or -1 and w->reason */
    int (*extra)(em_walk *w);  /* the stages that only the interpolant needs */
    void (*correct)(em_walk *w); /* F_3 ... */
} em_scheme;

static void em_signals(em_walk *w, double t) {
    for (int i = 0; i < N_INPUTS; ++i) w->u[i] = em_signal_at(&w->run->inputs[i], w->piece[i], t);
}

/* What stands behind a fault of a right-hand side at y. Returns -1 (em_guard.h). */
static int em_blame(em_walk *w, double t, const double *y);

/* What is asked of constraint rows. */
static int em_row_flags(const em_run *run) { return run->least_norm ? EM_LEAST_NORM | run->kept : 0; }

/* dy <- f(t, y) with the signals at t. */
EM_INLINE int em_rhs(em_walk *w, int mode, double t, const double *y, const double *memory, double *dy) {
    em_run *run = w->run;
    if (N_INPUTS > 0) em_signals(w, t);
    ++run->n_rhs;
    return model_rhs(mode, t, y, run->prepared, w->u, memory, em_row_flags(run), dy, &w->reason) ? em_blame(w, t, y) : 0;
}

static int em_settle(const em_run *run, int *mode, int flags, double t, double *y, double *memory, double pace,
                     em_fault *fault) {
    if (!SETTLES && run->stabilise && !(flags & EM_BEGIN)) return 0;
    if (run->stabilise) flags |= EM_STABILISE;
    if (!(flags & EM_LEAST_NORM)) flags |= em_row_flags(run);
    return model_settle(mode, flags, t, y, run->prepared, memory, pace, fault);
}

/* dy <- f at the nearest point on the constraints. Where their rows lose their directions, as near a singular position,
 * an argument that is off them by e has rates that are off by e over the square of what is left; on them they are not. */
EM_COLD int em_settled_rhs(em_walk *w, double t, const double *y, double *dy) {
    double settled[EM_WIDTH], memory[EM_SOME_MEMORY];
    int mode = w->mode;
    memcpy(settled, y, sizeof settled);
    memcpy(memory, w->memory, sizeof memory);
    if (em_settle(w->run, &mode, EM_KEEP_MODE, t, settled, memory, 0.0, &w->reason) < 0) return -1;
    return em_rhs(w, mode, t, settled, memory, dy);
}

/* EM_LANES numbers in one register, from wherever they stand. */
typedef double em_lanes __attribute__((vector_size(8 * EM_LANES), aligned(8), may_alias));

/* out <- y + h sum_j a_j K_j over j < n, with a constant. Where the rates of K_(n - 1) are `fresh`, written number by
 * number just now, a read of several at once would wait until all have reached the cache: they are read one by one,
 * which volatile sees to. */
EM_INLINE void em_combine(const double *restrict a, int n, int fresh, double h, const double *restrict y,
                          double (*restrict K)[EM_WIDTH], double *restrict out) {
    const volatile double *const last = K[n - 1];
    for (int k = 0; k < EM_WIDTH; k += EM_LANES) {
        em_lanes sum = {0.0};
        EM_UNROLL
        for (int j = 0; j < n; ++j) {
            if (a[j] == 0.0) continue;
            if (fresh && j == n - 1 && k < 2 * N) sum += a[j] * (em_lanes){last[k], last[k + 1], last[k + 2], last[k + 3]};
            else sum += a[j] * *(const em_lanes *)&K[j][k];
        }
        *(em_lanes *)(out + k) = *(const em_lanes *)(y + k) + h * sum;
    }
}

/* K_first .. K_last; where stage `solution` is among them its argument is y_new. */
EM_INLINE int em_stages(const em_tableau *rk, em_walk *w, int first, int last) {
    EM_UNROLL
    for (int i = first; i <= last; ++i) {
        double *argument = i == rk->solution ? w->y_new : w->argument;
        em_combine(rk->a[i], i, 1, w->h, w->y, w->K, argument);
        if (N_POSITIONS > 0 && w->near) {
            if (em_settled_rhs(w, w->t + rk->c[i] * w->h, argument, w->K[i])) return -1;
        } else if (em_rhs(w, w->mode, w->t + rk->c[i] * w->h, argument, w->memory, w->K[i])) return -1;
    }
    return 0;
}

/* sum_k (e_k weight_k)^2, in EM_LANES partial sums so that it is vectorised. */
EM_INLINE double em_weighted_squares(int n, const double *restrict e, const double *restrict weight) {
    double sum[EM_LANES] = {0.0}, rest = 0.0;
    int k = 0;
    for (; k + EM_LANES <= n; k += EM_LANES)
        for (int lane = 0; lane < EM_LANES; ++lane) {
            const double r = e[k + lane] * weight[k + lane];
            sum[lane] += r * r;
        }
    for (; k < n; ++k) rest += e[k] * weight[k] * (e[k] * weight[k]);
    return (sum[0] + sum[1]) + (sum[2] + sum[3]) + rest;
}

/* NaN and infinity survive a product with zero. */
EM_INLINE int em_all_finite(const double *restrict y) {
    double sum[EM_LANES] = {0.0};
    for (int k = 0; k < EM_WIDTH; k += EM_LANES)
        for (int lane = 0; lane < EM_LANES; ++lane) sum[lane] += 0.0 * y[k + lane];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]) == 0.0;
}

/* 1 / (atol + rtol max(|before|, |after|)); finite where both tolerances vanish. */
EM_INLINE void em_weigh(int n, const double *restrict atol, double rtol, const double *restrict before,
                        const double *restrict after, double *restrict weight) {
    for (int k = 0; k < n; ++k) {
        weight[k] = 1.0 / (atol[k] + rtol * em_max(fabs(before[k]), fabs(after[k])) + DBL_MIN);
    }
}

/* Eigenfactors, which count where nothing settles them: C is of size one, s scales with itself. */
static void em_weigh_factors(em_walk *w, const double *before, const double *after) {
    const int start[] = {2 * N, 2 * N + N_C, 2 * N + N_C + N_S, 2 * N + N_C + N_S + N_CD, N_STATE};
    for (int part = 0; part < 4; ++part)
        for (int k = start[part]; k < start[part + 1]; ++k) {
            const double size = part % 2 == 0 ? 1.0 : em_max(fabs(before[k]), fabs(after[k]));
            w->weight[k] = 1.0 / (w->rtol * size + DBL_MIN);
        }
}

/* The weights of x and v (and, unless settled, of the eigenfactors) between two states and their right-hand sides. */
static void em_set_weights(em_walk *w, const double *y, const double *dy, const double *y_new, const double *dy_new) {
    em_weigh(N, w->run->atol, w->rtol, y, y_new, w->weight);
    em_weigh(N, w->run->atol, w->rtol, dy, dy_new, w->weight + N);
    if (!w->run->stabilise || w->mode == 0) em_weigh_factors(w, y, y_new);
}

/* The weighted sum of squares of e (n_state), whose part of eta becomes one of v in place. */
static double em_squares(const em_walk *w, double *restrict e) {
    double ev[N];
    model_velocity_error(w->mode, w->y, w->run->prepared, w->memory, e + N, ev);
    memcpy(e + N, ev, sizeof ev);
    double sum = em_weighted_squares(2 * N, e, w->weight);
    if (!w->run->stabilise || w->mode == 0) sum += em_weighted_squares(N_STATE - 2 * N, e + 2 * N, w->weight + 2 * N);
    return sum;
}

static double em_count(const em_walk *w) { return w->run->stabilise ? 2.0 * N : (double)N_STATE; }

static const double em_zero[EM_WIDTH] = {0.0};

/* The root mean square of the error; with two estimates e_0, e_1: |h| e_0^2 / sqrt(e_0^2 + 0.01 e_1^2). */
EM_INLINE double em_error_norm(const em_tableau *rk, em_walk *w) {
    em_set_weights(w, w->y, w->K[0], w->y_new, w->K[rk->velocity_stage]);
    em_combine(rk->e[0], rk->stages, 0, 1.0, em_zero, w->K, w->error);
    const double first = em_squares(w, w->error);
    if (rk->errors == 1) return fabs(w->h) * sqrt(first / em_count(w));
    em_combine(rk->e[1], rk->stages, 0, 1.0, em_zero, w->K, w->error);
    const double denominator = first + 0.01 * em_squares(w, w->error);
    return denominator == 0.0 ? 0.0 : fabs(w->h) * first / sqrt(denominator * em_count(w));
}

EM_INLINE int em_take_step(const em_tableau *rk, em_walk *w) {
    if (em_stages(rk, w, 1, rk->stages - 1)) return -1;
    if (rk->solution == rk->stages) em_combine(rk->a[rk->solution], rk->stages, 1, w->h, w->y, w->K, w->y_new);
    w->error_norm = em_error_norm(rk, w);
    return 0;
}

#endif
