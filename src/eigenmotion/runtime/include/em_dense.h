/* em_dense.h: the state inside a step, settled like accepted ones, and em_model.interpolate.
 *
 * The interpolant belongs to the unsettled step: it joins y and y_raw with the right-hand sides there, in the mode of
 * the step's start. Settling what it gives makes the trajectory continuous with the accepted states.
 */
#ifndef EM_DENSE_H
#define EM_DENSE_H

#include "em_rows.h"
#include "em_step.h"

/* F_3 + i = h sum_j d_ij K_j */
EM_INLINE void em_corrections(const em_tableau *rk, em_walk *w) {
    const int stages = rk->last_extra > 0 ? rk->last_extra + 1 : rk->stages;
    EM_UNROLL
    for (int i = 0; i < rk->corrections; ++i) {
        em_combine(rk->d[i], stages, 0, w->h, em_zero, w->K, w->argument);
        memcpy(w->F[4 + i], w->argument, sizeof w->F[0]);
    }
}

/* F_0 .. F_2: y, f at both ends. */
static void em_hermite(em_walk *w, const double *y_end, const double *f_end) {
    memcpy(w->F[0], w->y, sizeof w->F[0]);
    for (int k = 0; k < N_STATE; ++k) {
        const double delta = y_end[k] - w->y[k];
        w->F[1][k] = delta;
        w->F[2][k] = w->h * w->K[0][k] - delta;
        w->F[3][k] = 2.0 * delta - w->h * (w->K[0][k] + f_end[k]);
    }
}

/* f at the unsettled end of the step: the last stage, f_new, or one more evaluation. */
static const double *em_raw_end(em_walk *w) {
    const em_tableau *rk = w->scheme->tableau;
    if (rk->solution < rk->stages) return w->K[rk->solution];
    double *f_raw = w->K[rk->solution];
    if (!w->moved) memcpy(f_raw, w->f_new, sizeof w->f_new);
    else if (em_rhs(w, w->mode, w->t_new, w->y_raw, w->memory, f_raw)) return NULL;
    return f_raw;
}

/* The interpolant of the step from t to t_new. 0, or -1 and w->reason. */
static int em_build_interpolant(em_walk *w) {
    const double *f_raw = em_raw_end(w);
    if (f_raw == NULL || w->scheme->extra(w)) return -1;
    em_hermite(w, w->y_raw, f_raw);
    w->scheme->correct(w);
    return 0;
}

/* y <- the interpolant F (., n_state) at theta, with `corrections` rows beyond the cubic. */
static void em_evaluate(const double *F, int corrections, double theta, double *y) {
    const int last = 2 + corrections;
    memset(y, 0, N_STATE * sizeof *y);
    for (int j = last; j >= 0; --j) {
        const double factor = j % 2 == 0 ? theta : 1.0 - theta;
        for (int k = 0; k < N_STATE; ++k) y[k] = (y[k] + F[(1 + j) * N_STATE + k]) * factor;
    }
    for (int k = 0; k < N_STATE; ++k) y[k] += F[k];
}

/* y, memory <- the settled state at t inside the step under way, in the mode of its start. */
static int em_inside(em_walk *w, double t, double *y, double *memory) {
    int mode = w->mode;
    em_evaluate(w->F[0], w->scheme->tableau->corrections, (t - w->t) / w->h, y);
    memcpy(memory, w->memory, sizeof w->memory);
    return em_settle(w->run, &mode, EM_KEEP_MODE, t, y, memory, t - w->t, &w->reason) < 0 ? -1 : 0;
}

static int em_corrections_of(em_method method) {
    const em_tableau *tableaux[] = {&EM_RK34_TABLEAU, &EM_DOPRI5_TABLEAU, &EM_DOP853_TABLEAU};
    return tableaux[method]->corrections;
}

/* em_model.interpolate: y (n_state) at t from the kept step number `step`, settled and published. 0, or -1. */
static int em_interpolate(const em_run *run, size_t step, double t, double *y) {
    const em_dense_step *kept = &run->dense_steps[step];
    const double *F = run->dense_table + step * EM_DENSE_COEFFICIENTS * N_STATE;
    double inside[N_STATE], memory[EM_SOME_MEMORY] = {0.0};
    em_fault fault;
    int mode = kept->mode;
    em_evaluate(F, em_corrections_of(run->method), (t - kept->t) / kept->h, inside);
    if (em_settle(run, &mode, EM_KEEP_MODE | kept->rows, t, inside, memory, t - kept->t, &fault) < 0) return -1;
    return model_publish(mode, t, inside, run->prepared, memory, y, &fault);
}

#endif
