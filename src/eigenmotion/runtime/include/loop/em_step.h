/* em_step.h: one step: attempts of decreasing size, until one is accepted.
 *
 * A step is accepted only if all of it succeeds: its stages, its error, settling, and the right-hand side and the
 * interpolant at its end. A failed attempt is repeated with a smaller size, and is the reason for the end of the run
 * if no size is small enough. */
#ifndef EM_STEP_H
#define EM_STEP_H

#include "loop/em_record.h"
#include "loop/em_table_joins.h"
#include "methods/em_step_size.h"
#include "monitors/em_monitors.h"

/* The distance of t to the next number; not below what is not rounded to zero (em_subnormals.h). */
static double em_spacing(const em_run_state *w) {
    return em_max(fabs(nextafter(w->t, w->direction * INFINITY) - w->t), DBL_MIN);
}

/* t_new and h of a step of size `size`, up to the target time and the end of the smooth interval at most. */
static void em_aim(em_run_state *w, double size) {
    const double bound = w->direction * (w->pieces_end - w->t_goal) < 0.0 ? w->pieces_end : w->t_goal;
    if (w->scheme.fixed) size = em_equal_part(fabs(bound - w->t), size);
    em_aim_step(w->direction, w->t, size, bound, &w->t_new, &w->h);
}

/* Whether a state inside the step is requested. */
static int em_needs_state_within(const em_run_state *w) {
    const em_run *run = w->run;
    if (run->dense == EM_DENSE || w->n_found > 0) return 1;
    return run->t_eval != NULL && em_row_is_due(w, w->t_new) && run->t_eval[w->next_t_eval] != w->t_new;
}

static int em_needs_interpolant(const em_run_state *w) {
    return !w->has_interpolant && (w->run->dense || em_needs_state_within(w));
}

/* Finishes a step whose error is small enough. 0, or -1 and w->reason. */
static int em_finish_step(em_run_state *w) {
    w->mode_new = w->mode;
    em_copy_memory(w, w->memory_new, w->memory);
    em_copy_state(w, w->y_raw, w->y_new);
    w->moved = em_settle(w->model, w->run, &w->mode_new, 0, em_clock(w, w->t_new), w->y_new, w->memory_new, w->h * w->stretch,
                         &w->reason);
    if (w->moved < 0) return -1;
    if (w->mode_new != w->mode) w->moved = 1;
    if (w->end_rate != NULL && !w->moved) em_copy_state(w, w->f_new, w->end_rate);
    else if (em_rhs(w, w->mode_new, w->t_new, w->y_new, w->memory_new, w->f_new)) return -1;
    if (!em_all_finite(w, w->y_new) || !em_all_finite(w, w->f_new)) return em_not_finite(w, w->y_new, w->f_new);
    if (w->scheme.judge != NULL && w->scheme.judge(w)) return -1;
    if (!isfinite(w->error_norm)) return em_not_finite(w, w->y_new, w->f_new);
    if (!(w->error_norm < 1.0)) return 0;
    if (!w->scheme.fixed && em_check_step(w)) return -1;
    if (w->n_events > 0 && em_detect_events(w)) return -1;
    if (w->scheme.within != NULL && em_needs_state_within(w)) w->scheme.within(w);
    return w->error_norm < 1.0 && em_needs_interpolant(w) ? w->scheme.interpolate(w) : 0;
}

/* One attempt. 0, or -1 and w->reason; the error norm may still be 1 or more. */
static int em_attempt(em_run_state *w) {
    w->error_norm = w->size_norm = INFINITY;
    if (w->scheme.step(w)) return -1;
    if (!isfinite(w->error_norm) || !em_all_finite(w, w->y_new)) return em_not_finite(w, w->y_new, w->error);
    return w->error_norm < 1.0 ? em_finish_step(w) : 0;
}

/* No step size is small enough: the fault that prevented the step, if it was not the error alone. */
EM_COLD_PATH static int em_underflow(em_run_state *w, double size, em_fault obstacle) {
    if (em_leaves_table(w, 16.0)) return em_end_with(w, w->reason);
    if (obstacle.status != EM_FINISHED) return em_end_with(w, obstacle);
    return em_end_with(w, (em_fault){EM_STEP_SIZE_UNDERFLOW, em_worst_coordinate(w), -1, size});
}

/* Attempts until one succeeds; proposes the size of the next step. */
static int em_step_forward(em_run_state *w) {
    em_run *run = w->run;
    if (run->n_steps >= w->most_steps) return em_end(w, EM_TOO_MANY_STEPS);
    const double least = 10.0 * em_spacing(w);
    const double proposed = em_max(least, em_min(w->h_next, run->max_step));
    em_fault obstacle = {EM_FINISHED, -1, -1, 0.0};
    em_join_search search = {0};
    const int rough = !w->scheme.fixed && em_has_rough_tables(w);
    double size = rough ? em_first_size_to_join(w, &search, proposed, least) : proposed;
    const int shortened = size < proposed;
    for (int rejected = 0;; ++rejected) {
        if (size < least) return em_underflow(w, size, obstacle);
        if (em_poll(w)) return EM_END;
        em_aim(w, size);
        w->retries = rejected;
        const int failed = em_attempt(w) != 0;
        if (w->scheme.fixed) return failed ? em_end_with(w, w->reason) : EM_CONTINUE;
        if (!failed) w->log_size = log(w->size_norm);
        const double factor = failed ? 0.25 : em_size_ratio(&w->scheme.control, w->log_size, w->last_error);
        size = fabs(w->h) * (rejected ? em_min(1.0, factor) : factor);
        if (!failed && w->error_norm < 1.0) {
            if (!rough || !em_passes_join(w, &search, least)) break;
            size = search.size;
        } else if (!failed && rough) {
            size = em_size_before_join(w, &search, size, least);
        } else if (failed) {
            obstacle = w->reason;
            if (em_leaves_table(w, 0.0)) return em_end_with(w, w->reason);
        }
        ++run->n_rejected;
    }
    /* The error of a step that was cut at the end of an interval or at the target time says little about the next size:
     * the earlier proposal is kept. */
    w->seeks_join = search.aims > 0 || search.tangent;
    const int ends = w->t_new == w->pieces_end || w->t_new == w->t_goal || shortened || w->seeks_join;
    const int cut = ends && size >= fabs(w->h);
    w->h_next = cut ? em_max(size, proposed) : size;
    return EM_CONTINUE;
}

#endif
