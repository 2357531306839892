/* em_lane_run.h: the scalar part of a run in a lane (em_lane_runge_kutta.h): its start, and the steps that need more
 * than lanes can do. If a lane cannot continue a run, em_simulate repeats it from its start. */
#ifndef EM_LANE_RUN_H
#define EM_LANE_RUN_H

#include "loop/em_stepper.h"

#define EM_LANE(table, k) (table)[(size_t)(k) * (size_t)width + (size_t)lane]

/* The number of values that a lane keeps from a run's last step. The caller's model has it: the lanes that this object
 * is linked with may be for the nodes of one run only, and keep none. */
static int em_member_remembers(const em_run_state *w) { return w->run->model->lanes->remembered; }

/* Plans when the lane's steps are checked next. */
static void em_member_plan_checks(const em_run_state *w, em_lane_group *f, int lane) {
    const em_run *run = w->run;
    f->next_check[lane] = w->starts_near ? 0.0 : (double)w->next_energy_check;
    f->t_check[lane] = w->next_t_eval < run->n_t_eval ? run->t_eval[w->next_t_eval] : run->t_end;
}

/* Whether a step would end at a time event, which lanes do not handle. */
static int em_time_events_ahead(const em_run_state *w) {
    return w->model->n_time_events > 0 &&
           (isfinite(w->inside[w->direction > 0.0 ? 0 : 1]) || w->direction * (w->pieces_end - w->run->t_end) <= 0.0);
}

/* em_model.enter */
EM_EXPORT void *em_member_enter(const em_model *model, em_run *run, int *mode) {
    em_run_state *const w = em_open(model, run);
    if (w == NULL) return NULL;
    if (w->ended || run->least_norm || w->t == run->t_end || em_begin(w) || em_time_events_ahead(w) ||
        em_has_rough_tables(w))
        return em_close(w), NULL;
    *mode = w->mode;
    return w;
}

/* em_model.load */
EM_COLD_PATH EM_EXPORT void em_member_load(void *run_state, em_lane_group *f, int lane) {
    const em_run_state *const w = run_state;
    const em_run *const run = w->run;
    const int width = w->lanes->width;
    const double steps = (double)run->n_steps;
    for (int k = 0; k < w->n_state; ++k) {
        EM_LANE(f->y, k) = w->y[k];
        EM_LANE(f->K, k) = w->K[0][k];
    }
    for (int k = 0; k < w->lanes->n_prepared; ++k) EM_LANE(f->c, k) = run->prepared[k];
    for (int k = 0; k < w->n_inputs; ++k) EM_LANE(f->u, k) = w->u[k];
    for (int k = 0; k < em_member_remembers(w); ++k) EM_LANE(f->memory, k) = w->memory[k];
    f->t[lane] = w->t;
    f->h_next[lane] = w->h_next;
    f->last_error[lane] = w->last_error;
    f->longest[lane] = w->longest_step;
    f->retries[lane] = 0.0;
    f->n_steps[lane] = steps;
    f->n_rejected[lane] = (double)run->n_rejected;
    f->n_rhs[lane] = (double)run->n_rhs;
    f->stiff[lane] = w->stiff;
    f->n_stiff[lane] = (double)run->n_stiff;
    f->next_stiffness_check[lane] = EM_STIFF_EVERY * ceil(steps / EM_STIFF_EVERY);
    em_member_plan_checks(w, f, lane);
}

/* Reads the stages of the current step from the lane, and the state and time of its last stage. */
EM_COLD_PATH static void em_member_read_stages(em_run_state *w, const em_lane_group *f, int lane) {
    const em_tableau *const rk = &EM_DOP853_TABLEAU;
    const int width = w->lanes->width, last = rk->stages - 1;
    for (int stage = 1; stage < rk->stages; ++stage)
        for (int k = 0; k < w->n_state; ++k) w->K[stage][k] = EM_LANE(f->K, stage * w->width + k);
    const em_explicit s = em_explicit_of(w);
    em_combine(rk, &s, last, w->argument);
}

/* Reads the ends of the step, and the counts of the run. */
EM_COLD_PATH static void em_member_read(em_run_state *w, const em_lane_group *f, int lane) {
    em_run *const run = w->run;
    const int width = w->lanes->width;
    const long steps = (long)f->n_steps[lane];
    for (int k = 0; k < w->n_state; ++k) {
        w->y[k] = EM_LANE(f->y, k);
        w->y_new[k] = EM_LANE(f->y_new, k);
        w->K[0][k] = EM_LANE(f->K, k);
        w->f_new[k] = EM_LANE(f->f_new, k);
    }
    for (int k = 0; k < em_member_remembers(w); ++k) {
        w->memory[k] = EM_LANE(f->memory, k);
        w->memory_new[k] = EM_LANE(f->memory_new, k);
    }
    w->t = f->t[lane];
    w->t_new = f->t_new[lane];
    w->h = f->h[lane];
    w->h_next = f->h_next[lane];
    w->longest_step = f->longest[lane];
    w->retries = (int)f->retries[lane];
    run->n_bounded += w->mode == 1 ? steps - run->n_steps : 0;
    run->n_steps = steps;
    run->n_rejected = (long)f->n_rejected[lane];
    run->n_stiff = (long)f->n_stiff[lane];
    run->n_rhs = (long)f->n_rhs[lane] + EM_DOP853_TABLEAU.stages;
    w->stiff = f->stiff[lane] > 0.0;
    w->error_norm = w->size_norm = f->error[lane];
    w->log_size = log(w->size_norm);
    w->mode_new = w->mode;
    w->moved = w->dynamics->settles;
    em_set_weights(w, w->y, w->K[0], w->y_new, w->f_new);
}

/* The checks of em_finish_step for a step that has been settled. 0, or -1 */
EM_COLD_PATH static int em_member_check_settled(em_run_state *w, const em_lane_group *f, int lane) {
    if (w->n_events > 0 || em_needs_interpolant(w)) {
        const em_tableau *const rk = &EM_DOP853_TABLEAU;
        em_member_read_stages(w, f, lane);
        const em_explicit s = em_explicit_of(w);
        em_combine(rk, &s, rk->solution, w->y_raw);
    }
    if ((!w->bare && em_check_singularity(w)) || em_check_energy(w) || (w->n_events > 0 && em_detect_events(w))) return -1;
    return em_needs_interpolant(w) ? w->scheme.interpolate(w) : 0;
}

/* em_finish_step, for a step that the lane has not settled, and its result written into the lane. 0, or -1 */
EM_COLD_PATH static int em_member_finish_step(em_run_state *w, em_lane_group *f, int lane) {
    const int width = w->lanes->width, judged = w->run->n_steps % EM_STIFF_EVERY == 0;
    if (w->n_events > 0 || judged || em_needs_interpolant(w)) em_member_read_stages(w, f, lane);
    w->end_rate = NULL;
    --w->run->n_rhs; /* the rate that the lane computed is discarded */
    if (em_finish_step(w) || !(w->error_norm < 1.0) || (w->n_positions > 0 && w->near)) return -1; /* near a singular
                                                                                               position stages are
                                                                                               settled */
    for (int k = 0; k < w->n_state; ++k) {
        EM_LANE(f->y_new, k) = w->y_new[k];
        EM_LANE(f->f_new, k) = w->f_new[k];
    }
    for (int k = 0; k < em_member_remembers(w); ++k) EM_LANE(f->memory_new, k) = w->memory_new[k];
    f->stiff[lane] = w->stiff;
    return 0;
}

/* The lane's state <- that of the run after a change of rotation parameters. */
EM_COLD_PATH static void em_member_write(const em_run_state *w, em_lane_group *f, int lane) {
    const int width = w->lanes->width;
    for (int k = 0; k < w->n_state; ++k) {
        EM_LANE(f->y_new, k) = w->y[k];
        EM_LANE(f->f_new, k) = w->K[0][k];
    }
    for (int k = 0; k < em_member_remembers(w); ++k) EM_LANE(f->memory_new, k) = w->memory[k];
}

/* em_model.check_step: the checks of em_finish_step and em_advance for an accepted step. */
EM_COLD_PATH EM_EXPORT int em_member_check(void *run_state, em_lane_group *f, int lane, em_lane_outcome outcome) {
    em_run_state *const w = run_state;
    int terminal = 0, changed = 0;
    em_member_read(w, f, lane);
    double t_stop = w->t_new;
    if (outcome == EM_UNSETTLED ? em_member_finish_step(w, f, lane) : em_member_check_settled(w, f, lane)) return -1;
    if (em_record(w, &t_stop, &terminal)) return -1;
    em_commit(w);
    w->run->t_reached = t_stop;
    if (terminal) w->run->fault.status = EM_TERMINAL_EVENT;
    if (terminal || w->t == w->run->t_end) return 1;
    if (w->model->n_rotations > 0 && em_change_chart(w, &changed)) return -1;
    if (w->mode != f->mode) return 2;
    if (changed) em_member_write(w, f, lane);
    em_member_plan_checks(w, f, lane);
    f->n_rhs[lane] += (double)(w->run->n_rhs - (long)f->n_rhs[lane] - EM_DOP853_TABLEAU.stages); /* of the interpolant */
    return 0;
}

#undef EM_LANE

#endif
