/* em_fixed_steps.h: Runge-Kutta steps of fixed size on lanes, one motion in each lane.
 *
 * For the runtime, not for generated code; for models whose state is x, xdot and that have no constraints. The
 * numbers of a motion do not depend on the other lanes. If a lane has no finite result, the scalar code repeats its
 * step, which names the fault or succeeds (lanes have no sine beyond 1e6). */
#ifndef EM_FIXED_STEPS_H
#define EM_FIXED_STEPS_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "numeric/em_real.h"
#include "eigenmotion.h"
#include "tableaux/em_butcher.h"

enum { EM_LOCKSTEP_STAGES = 4 };

/* Working memory of a step, for one thread: tables (..., EM_MOST_LANES), aligned to 64 bytes. */
typedef struct em_fixed_steps {
    const em_model *model;
    const em_tableau *rk;
    double size; /* upper bound of step sizes */
    double *t_stage, *t_new, *h, *sound; /* sound: 0 where y_new is finite, else NaN */
    double *y_new, *argument, *K;        /* (n_state, ...), (n_state, ...), (4, n_state, ...) */
} em_fixed_steps;

/* The number of doubles in these tables. */
static size_t em_fixed_numbers(const em_model *model) {
    return (4 + (2 + EM_LOCKSTEP_STAGES) * (size_t)model->n_state) * EM_MOST_LANES;
}

static em_fixed_steps em_fixed_at(const em_model *model, const em_tableau *rk, double size, double *place) {
    const size_t states = (size_t)model->n_state * EM_MOST_LANES;
    em_fixed_steps w = {.model = model, .rk = rk, .size = size, .t_stage = place, .t_new = place + EM_MOST_LANES};
    w.h = place + 2 * EM_MOST_LANES;
    w.sound = place + 3 * EM_MOST_LANES;
    w.y_new = place + 4 * EM_MOST_LANES;
    w.argument = w.y_new + states;
    w.K = w.argument + states;
    return w;
}

/* ceil, without a call of the C library. */
EM_INLINE double em_fixed_ceil(double a) {
    if (!(fabs(a) < 0x1p52)) return a;
    const double whole = (double)(long long)a;
    return whole < a ? whole + 1.0 : whole;
}

/* t_new and h of one motion's next step towards t_goal: one of equal parts of the interval (em_step.h). */
static void em_fixed_aim(const em_fixed_steps *w, int lane, double t, double t_goal) {
    const double direction = t_goal < t ? -1.0 : 1.0, way = fabs(t_goal - t), count = em_fixed_ceil(way / w->size - 1e-6);
    const double t_new = t + direction * (count > 1.0 ? way / count : 2.0 * way);
    w->t_new[lane] = direction * (t_new - t_goal) > 0.0 ? t_goal : t_new;
    w->h[lane] = w->t_new[lane] - t;
}

/* out <- y + h sum_j a_j K_j over j < stages */
EM_INLINE void em_fixed_combine(const int width, const em_fixed_steps *w, const double *a, int stages, const double *y,
                                   double *out) {
    const int n = w->model->n_state;
    for (int k = 0; k < n; ++k) {
        double sum[EM_MOST_LANES] = {0.0};
        for (int j = 0; j < stages; ++j) {
            const double *const K = w->K + (j * n + k) * width;
            if (a[j] == 0.0) continue;
            for (int lane = 0; lane < width; ++lane) sum[lane] += a[j] * K[lane];
        }
        for (int lane = 0; lane < width; ++lane) out[k * width + lane] = y[k * width + lane] + w->h[lane] * sum[lane];
    }
}

/* K (n_state, width) <- the rates; in one lane by the scalar code: 0, or -1 and *fault. */
EM_INLINE int em_fixed_rate(const int width, const em_model *model, const double *t, const double *y, const double *c,
                            const double *u, double *K, em_fault *fault) {
    if (width == 1) return model->rhs(*t, y, c, u, K, fault);
    model->lanes->rhs(0, t, y, c, u, 0, K);
    return 0;
}

/* y_new <- a step from y at t; NaN in lanes that fail. 0, or -1 as em_fixed_rate. */
EM_INLINE int em_fixed_step(const int width, const em_fixed_steps *w, const double *t, const double *y, const double *c,
                            const double *u, em_fault *fault) {
    const em_tableau *const rk = w->rk;
    for (int stage = 0; stage < rk->stages; ++stage) {
        double *const K = w->K + stage * w->model->n_state * width;
        for (int lane = 0; lane < width; ++lane) w->t_stage[lane] = t[lane] + rk->c[stage] * w->h[lane];
        if (stage > 0) em_fixed_combine(width, w, rk->a[stage], stage, y, w->argument);
        if (em_fixed_rate(width, w->model, w->t_stage, stage > 0 ? w->argument : y, c, u, K, fault)) return -1;
    }
    em_fixed_combine(width, w, rk->a[rk->stages], rk->stages, y, w->y_new);
    for (int lane = 0; lane < width; ++lane) w->sound[lane] = 0.0;
    for (int k = 0; k < w->model->n_state; ++k) /* NaN and infinity survive a product with zero */
        for (int lane = 0; lane < width; ++lane) w->sound[lane] += 0.0 * w->y_new[k * width + lane];
    return 0;
}

static void em_fixed_any(int width, const em_fixed_steps *w, const double *t, const double *y, const double *c,
                            const double *u) {
    if (width == 8) em_fixed_step(8, w, t, y, c, u, NULL);
    else if (width == 4) em_fixed_step(4, w, t, y, c, u, NULL);
    else em_fixed_step(2, w, t, y, c, u, NULL);
}

/* Copies the numbers of one lane out of a table (count, width). */
static void em_lane_out(int width, int lane, int count, const double *table, double *numbers) {
    for (int k = 0; k < count; ++k) numbers[k] = table[k * width + lane];
}

static void em_lane_in(int width, int lane, int count, const double *numbers, double *table) {
    for (int k = 0; k < count; ++k) table[k * width + lane] = numbers[k];
}

/* Makes one lane's step by the scalar code, into y_new. 0, or -1 and *fault. */
EM_NOINLINE int em_fixed_alone(int width, int lane, const em_fixed_steps *w, double t, const double *y, const double *c,
                              const double *u, em_fault *fault) {
    const em_model *const model = w->model;
    const int n = model->n_state;
    double place[em_fixed_numbers(model)], before[n], constants[model->n_prepared + 1], inputs[model->n_inputs + 1];
    const em_fixed_steps one = em_fixed_at(model, w->rk, w->size, place);
    em_lane_out(width, lane, n, y, before);
    em_lane_out(width, lane, model->n_prepared, c, constants);
    em_lane_out(width, lane, model->n_inputs, u, inputs);
    *one.h = w->h[lane];
    if (em_fixed_step(1, &one, &t, before, constants, inputs, fault)) return -1;
    for (int k = 0; k < n; ++k)
        if (!isfinite(one.y_new[k])) return *fault = (em_fault){EM_NON_FINITE_STATE, k % model->n, -1, t}, -1;
    em_lane_in(width, lane, n, one.y_new, w->y_new);
    return 0;
}

#endif
