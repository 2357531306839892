/* em_fixed_steps.h: Runge-Kutta steps of fixed size on lanes, one motion in each lane.
 *
 * For the runtime, not for generated code; for models whose state is x, xdot and that have no constraints. The
 * numbers of a motion do not depend on the other lanes. If a lane has no finite result, the scalar code repeats its
 * step, which names the fault or succeeds (lanes have no sine beyond 1e6). */
#ifndef EM_FIXED_STEPS_H
#define EM_FIXED_STEPS_H

#include <string.h>

#include "eigenmotion.h"
#include "methods/em_explicit_stages.h"
#include "tableaux/em_step_control.h"

enum { EM_LOCKSTEP_STAGES = 4 };

/* Working memory of a step, for one thread; y_new, argument, K are aligned to 64 bytes. */
typedef struct em_fixed_steps {
    const em_model *model;
    const em_tableau *rk;
    int width;                    /* lanes */
    double size;                  /* upper bound of step sizes */
    const double *c, *u;          /* (n_prepared, width), (n_inputs, width) of the motions in progress */
    em_fault *fault;              /* of a motion alone */
    double *y_new, *argument, *K; /* (n_state, width), (n_state, width), (4, n_state, width) */
    double t[EM_MOST_LANES], t_new[EM_MOST_LANES], h[EM_MOST_LANES];
    double sound[EM_MOST_LANES];  /* 0 where y_new is finite, else NaN */
} em_fixed_steps;

/* The number of doubles in y_new, argument, K. */
static size_t em_fixed_numbers(const em_model *model) {
    return (2 + EM_LOCKSTEP_STAGES) * (size_t)model->n_state * EM_MOST_LANES;
}

static em_fixed_steps em_fixed_at(const em_model *model, const em_tableau *rk, int width, double size, double *place) {
    const size_t states = (size_t)model->n_state * EM_MOST_LANES;
    return (em_fixed_steps){.model = model, .rk = rk, .width = width, .size = size, .y_new = place,
                            .argument = place + states, .K = place + 2 * states};
}

/* t_new and h of one motion's next step towards t_goal: one of equal parts of the interval. */
static void em_fixed_aim(em_fixed_steps *w, int lane, double t_goal) {
    const double t = w->t[lane], size = em_equal_part(fabs(t_goal - t), w->size);
    em_aim_step(t_goal < t ? -1.0 : 1.0, t, size, t_goal, w->t_new + lane, w->h + lane);
}

/* em_explicit_rate: of all lanes, or of one by the scalar code, which names a fault. */
EM_INLINE int em_fixed_rate(void *steps, const double *t, const double *y, double *dy) {
    const em_fixed_steps *const w = steps;
    if (w->width == 1) return w->model->rhs(*t, y, w->c, w->u, dy, w->fault);
    w->model->lanes->rhs(0, t, y, w->c, w->u, 0, dy);
    return 0;
}

/* sound <- 0 in lanes whose numbers of y_new are finite, else NaN: NaN and infinity survive a product with zero. */
static void em_fixed_test(em_fixed_steps *w, int size) {
    memset(w->sound, 0, sizeof w->sound);
    for (int k = 0; k < size; ++k) w->sound[k & (w->width - 1)] += 0.0 * w->y_new[k];
}

/* y_new <- a step from y (padded to a pack); NaN in lanes that fail. In one lane: 0, or -1 and w->fault. */
static int em_fixed_step(em_fixed_steps *w, const double *y) {
    const int size = em_padded(w->model->n_state * w->width);
    const em_explicit s = {size, size, w->width, 0, w->t, w->h, y, w->K, w->argument, w->y_new};
    for (int k = w->width; k < EM_MOST_LANES; ++k) w->h[k] = w->h[k - w->width];
    const int failed = w->rk == &EM_RK4_TABLEAU ? em_explicit_step(&EM_RK4_TABLEAU, &s, 0, em_fixed_rate, w)
                                                : em_explicit_step(&EM_MIDPOINT_TABLEAU, &s, 0, em_fixed_rate, w);
    em_fixed_test(w, size);
    return failed;
}

/* Copies the numbers of one lane out of a table (count, width). */
static void em_lane_out(int width, int lane, int count, const double *table, double *numbers) {
    for (int k = 0; k < count; ++k) numbers[k] = table[k * width + lane];
}

static void em_lane_in(int width, int lane, int count, const double *numbers, double *table) {
    for (int k = 0; k < count; ++k) table[k * width + lane] = numbers[k];
}

/* Makes one lane's step by the scalar code, into y_new. 0, or -1 and *fault. */
EM_NOINLINE int em_fixed_alone(em_fixed_steps *w, int lane, const double *y, em_fault *fault) {
    const em_model *const model = w->model;
    const int n = model->n_state;
    double place[em_fixed_numbers(model)], before[em_padded(n)], c[model->n_prepared + 1], u[model->n_inputs + 1];
    em_fixed_steps one = em_fixed_at(model, w->rk, 1, w->size, place);
    one.c = c, one.u = u, one.fault = fault;
    memset(before, 0, sizeof before);
    em_lane_out(w->width, lane, n, y, before);
    em_lane_out(w->width, lane, model->n_prepared, w->c, c);
    em_lane_out(w->width, lane, model->n_inputs, w->u, u);
    *one.t = w->t[lane], *one.h = w->h[lane];
    if (em_fixed_step(&one, before)) return -1;
    for (int k = 0; k < n; ++k)
        if (!isfinite(one.y_new[k])) return *fault = (em_fault){EM_NON_FINITE_STATE, k % model->n, -1, w->t[lane]}, -1;
    em_lane_in(w->width, lane, n, one.y_new, w->y_new);
    return 0;
}

#endif
