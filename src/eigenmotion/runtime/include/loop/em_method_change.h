/* em_method_change.h: change of the method at an accepted step, of runs whose method is chosen automatically.
 *
 * Such a run has an explicit and an implicit method, and keeps the one that costs less per unit of time. Costs are
 * counted in right-hand sides, never timed: the same run changes at the same steps.
 *
 * From the explicit method to the implicit one: once stability, not the error, has limited so many steps that they cost
 * as much as a trial of the implicit method, and at least as many would follow; or a few steps, if the trial costs less
 * than a hundredth of those that would follow. So a trial in vain costs little beside what the run takes anyway. Back:
 * the largest eigenvalue of the Jacobian gives the step that stability would allow. If explicit steps of that size, or
 * of the present one if that is shorter, cost clearly less, the run changes back. The error may allow shorter explicit steps than that: if they then
 * cost clearly more than the implicit ones did, the run returns. Each return from a trial in vain doubles the wait for
 * the next one. */
#ifndef EM_METHOD_CHANGE_H
#define EM_METHOD_CHANGE_H

#include "loop/em_chart_change.h"

#define EM_CLEARLY_LESS 0.7      /* of the cost: else a change does not pay */
#define EM_STABLE_SIZE 4.0       /* of explicit steps, times the largest eigenvalue; EM_DOP853_STABLE */
#define EM_EXPLICIT_STEP 12.0    /* right-hand sides of an explicit step */
#define EM_NODE_RATE (EM_LANES > 2 ? 0.3 : 1.0) /* cost of a right-hand side on lanes, in scalar ones; */
#define EM_STAGE_RATE 1.5        /* of one in an implicit stage, with its share of the linear equations; */
#define EM_SLOPES_RATE 8.0       /* of a Jacobian; */
#define EM_FACTORS_RATE 6.0      /* and of the factors of all stages: measured on models of 2 to 10 coordinates */

enum {
    EM_STRAINED_STEPS = 48,  /* explicit steps that cost as much as a trial of the implicit method */
    EM_STRAINED_NODES = 10,  /* the same if a step has nodes */
    EM_STEPS_AHEAD = 200,    /* fewer explicit steps to the end do not pay for a change */
    EM_NODES_AHEAD = 50,
    EM_TRIAL_SHARE = 2,      /* a trial that costs a hundredth of what follows is made after this part of them */
    EM_HUNDREDTH = 100,
    EM_WINDOW = 8,           /* steps whose cost is counted */
    EM_DEAR_WINDOWS = 2,     /* windows in a row in which the other method would have cost less */
    EM_SHORT_TRIAL = 3,      /* windows, the fewest: a trial of the implicit method that lasted no longer was in vain; */
    EM_TRIAL = 6,            /* and one of the explicit method */
    EM_LONGEST_PATIENCE = 6, /* doublings of the wait after trials in vain */
    EM_POWERS = 24           /* of the Jacobian; the growth over two thirds of them counts */
};

/* What the run has cost so far, in right-hand sides, if the present method made all steps: differences are used. */
static double em_cost_so_far(const em_run_state *w) {
    const em_run *const run = w->run;
    const double rate = w->scheme.at_nodes ? EM_NODE_RATE : w->scheme.radau_iia ? EM_STAGE_RATE : 1.0;
    return rate * (double)run->n_rhs + EM_SLOPES_RATE * (double)run->n_jacobians + EM_FACTORS_RATE * (double)run->n_factors;
}

static em_cost_window em_window_from_here(const em_run_state *w) { return (em_cost_window){w->t, em_cost_so_far(w), 0}; }

/* The cost of the steps in a window, per unit of time. */
static double em_cost_rate(const em_run_state *w, const em_cost_window *window) {
    return (em_cost_so_far(w) - window->cost) / fabs(w->t - window->t);
}

/* next (2 n) <- (v, K x + D v) for z = (x, v). Returns its length. */
static double em_apply_slopes(const em_run_state *w, const double *z, double *next) {
    const em_implicit *const q = &w->stages;
    const int n = w->n;
    double squares = 0.0;
    memcpy(next, z + n, (size_t)n * sizeof *z);
    for (int i = 0; i < n; ++i) {
        next[n + i] = 0.0;
        for (int k = 0; k < n; ++k) next[n + i] += q->K[i * n + k] * z[k] + q->D[i * n + k] * z[n + k];
    }
    for (int i = 0; i < 2 * n; ++i) squares += next[i] * next[i];
    return sqrt(squares);
}

/* The size of the largest eigenvalue of the motion [1 / time], at the last Jacobian, by power iteration: within some
 * per cent, less if others are as large. */
static double em_fastest_rate(const em_run_state *w) {
    double z[2 * w->n], next[2 * w->n], grown = 0.0;
    for (int i = 0; i < 2 * w->n; ++i) z[i] = cos(1.0 + i);
    for (int power = 0; power < EM_POWERS; ++power) {
        const double size = em_apply_slopes(w, z, next);
        if (!(size > 0.0) || !isfinite(size)) return size;
        if (power > 0 && power >= EM_POWERS / 3) grown += log(size);
        for (int i = 0; i < 2 * w->n; ++i) z[i] = next[i] / size;
    }
    return exp(grown / (EM_POWERS - EM_POWERS / 3));
}

/* Records the method from w->t on. */
static int em_note_method(em_run_state *w) {
    em_run *const run = w->run;
    run->methods.width = 1;
    double *const row = em_rows_next(&run->methods, &w->reason);
    if (row == NULL) return em_end_with(w, w->reason);
    *row = (double)run->method;
    em_rows_keep(&run->methods, w->t);
    return EM_CONTINUE;
}

/* Continues by the other method, from the same motion with the same signs of events. The explicit method after an
 * implicit one is dop853: the iteration for nodes converges slowly long before stability limits its steps. Returns as a
 * step. */
static int em_change_method(em_run_state *w) {
    em_run *const run = w->run;
    const em_method left = run->method;
    double row[w->n_state];
    if (em_publish(w->model, run, w->mode, w->t, w->y, w->memory, row, &w->reason)) return em_end_with(w, w->reason);
    run->method = run->other, run->other = w->scheme.radau_iia ? left : EM_DOP853;
    w->scheme = em_scheme_of(run->method);
    w->stretch = pow(w->rtol, -1.0 / (w->scheme.control.error_order + 1));
    em_discard_steps(w);
    memcpy(w->y, row, sizeof row);
    w->stiff = 0, w->last_error = 0.0;
    if (em_enter_mode(w) < 0 || em_enter_interval(w) < 0) return em_end_with(w, w->reason);
    w->crosses = 0; /* a time event that is now, the step that ended here has crossed */
    if (em_rhs(w, w->mode, w->t, w->y, w->memory, w->K[0])) return em_end_with(w, w->reason);
    if (w->n_events > 0 && em_events_at(w, w->t, w->y, w->K[0], w->g)) return em_end_with(w, w->reason);
    w->choice.windows = w->choice.dear = 0;
    w->choice.window = w->choice.limited = em_window_from_here(w);
    return em_note_method(w);
}

/* Ends a full window of steps, and counts it as dear if `other`, the cost of the other method per unit of
 * time, is clearly less. The first after a change does not count, since its steps may be short. */
static void em_end_window(em_run_state *w, double other, double rate) {
    em_choice *const c = &w->choice;
    c->dear = c->windows > 0 && other < EM_CLEARLY_LESS * rate ? c->dear + 1 : 0;
    ++c->windows;
    c->window = em_window_from_here(w);
}

/* After an explicit step: whether stability has limited so many that the implicit method should be tried. */
static int em_explicit_is_strained(em_run_state *w) {
    em_cost_window *const limited = &w->choice.limited;
    const int nodes = w->scheme.at_nodes, many = (nodes ? EM_STRAINED_NODES : EM_STRAINED_STEPS) << w->choice.patience;
    limited->steps = w->stiff ? limited->steps + 1 : limited->steps > 2 ? limited->steps - 2 : 0;
    if (limited->steps == 0) *limited = em_window_from_here(w);
    if (limited->steps < many / EM_TRIAL_SHARE) return 0;
    const double ahead = fabs(w->run->t_end - w->t) / fabs(w->h);
    const double least = em_max(many, nodes ? EM_NODES_AHEAD : EM_STEPS_AHEAD);
    return ahead > (limited->steps < many ? EM_HUNDREDTH * (double)many : least);
}

static int em_more_doublings(int doublings) { return doublings + (doublings < EM_LONGEST_PATIENCE); }

/* After an explicit step: whether the implicit method would cost less, because stability limits the steps, or because it
 * has cost less before, which is seen in the first windows after a change. */
static int em_explicit_is_dear(em_run_state *w) {
    em_choice *const c = &w->choice;
    const int strained = em_explicit_is_strained(w);
    if (++c->window.steps >= EM_WINDOW && c->implicit_rate > 0.0 && c->windows < EM_TRIAL) {
        em_end_window(w, c->implicit_rate, c->explicit_rate = em_cost_rate(w, &c->window));
    }
    if (!strained && c->dear < EM_DEAR_WINDOWS) return 0;
    if (strained) c->explicit_rate = em_cost_rate(w, &c->limited);
    c->reluctance = c->implicit_rate > 0.0 && c->windows < EM_TRIAL ? em_more_doublings(c->reluctance) : 0;
    return 1;
}

/* The cost of explicit steps per unit of time: of steps as long as stability allows, but no longer than the present ones.
 * For some windows after explicit steps their cost counts: if it was less, for the implicit method may be a trial in
 * vain; if it was more after a trial of explicit steps, for their errors need shorter steps. */
static double em_explicit_cost(const em_run_state *w, double present) {
    const em_choice *const c = &w->choice;
    const double stable = EM_EXPLICIT_STEP / em_min(EM_STABLE_SIZE / em_fastest_rate(w), present);
    if (!(c->windows < EM_SHORT_TRIAL << c->reluctance && c->explicit_rate > 0.0)) return stable;
    return c->reluctance > 0 ? em_max(stable, c->explicit_rate) : em_min(stable, c->explicit_rate);
}

/* After an implicit step: whether the explicit method would cost less, in windows in a row. */
static int em_implicit_is_dear(em_run_state *w) {
    em_choice *const c = &w->choice;
    if (++c->window.steps < EM_WINDOW) return 0;
    const double rate = em_cost_rate(w, &c->window), step = fabs(w->t - c->window.t) / c->window.steps;
    em_end_window(w, em_explicit_cost(w, step), rate);
    if (c->dear < EM_DEAR_WINDOWS) return 0;
    c->patience = c->windows > EM_SHORT_TRIAL ? 0 : em_more_doublings(c->patience);
    c->implicit_rate = rate;
    w->h_next = em_min(em_min(w->h_next, step), EM_STABLE_SIZE / em_fastest_rate(w));
    return 1;
}

/* Where the implicit method makes no step, for example because derivatives are not finite where the motion is, the run
 * goes on by the explicit one and keeps it. Returns as a step. */
static int em_leave_implicit(em_run_state *w) {
    em_run *const run = w->run;
    if (!run->changes || w->scheme.radau_iia == NULL || run->fault.status != EM_STEP_SIZE_UNDERFLOW) return EM_END;
    run->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    if (em_change_method(w)) return EM_END;
    run->changes = 0;
    w->h_next = em_first_size(w);
    return EM_CONTINUE;
}

/* After an accepted step: changes the method if the other one costs less. A run waits before it takes the implicit
 * method: the caller may have to load derivatives. Returns as a step. */
static int em_consider_method(em_run_state *w) {
    em_run *const run = w->run;
    if (w->scheme.radau_iia == NULL) return run->waits = em_explicit_is_dear(w), EM_CONTINUE;
    return em_implicit_is_dear(w) ? em_change_method(w) : EM_CONTINUE;
}

#endif
