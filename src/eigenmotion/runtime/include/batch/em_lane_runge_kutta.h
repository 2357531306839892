/* em_lane_runge_kutta.h: dop853 on lanes: one run of an ensemble in each lane of a vector.
 *
 * Included by NAME.c if it is compiled for lanes. Each lane has its own time, step size and error, and does not depend
 * on the others: a member's numbers are the same in any lane and next to any other members. Most steps need no more
 * than this; the scalar code checks the others (em_lane_run.h). */
#ifndef EM_LANE_RUNGE_KUTTA_H
#define EM_LANE_RUNGE_KUTTA_H

#include "kinematics/em_shadow_parameters.h"
#include "batch/em_lane_singularity.h"
#include "batch/em_lane_factors.h"
#include "methods/em_explicit_stages.h"
#include "tableaux/em_step_control.h"

enum {
    EM_PARTIAL_SUMS = 4, /* partial sums that do not depend on each other */
    EM_GROUP_STATE = (N_STATE + 3) / 4 * 4,
    EM_GROUP_STAGES = 12,
    EM_REMEMBERED = EM_SECOND_ORDER ? 0 : N_MEMORY, /* the roots of M at the start of a step */
    EM_ATTEMPTS_PER_POLL = 64 /* attempts between two checks whether the caller has requested an end */
};

/* The arrays of a lane group (em_lanes.h), as vectors. */
typedef struct em_lane_state {
    const em_lane_group *group;
    real *y, *y_new, *f_new, *c, *u;
    real (*K)[EM_GROUP_STATE];
    real *t, *t_new, *h, *h_next, *error, *last_error, *longest, *n_steps, *n_rejected, *retries, *n_rhs;
    real *stiff, *n_stiff, *next_stiffness_check, *next_check, *t_check, *memory, *memory_new;
} em_lane_state;

/* The part of xdot that follows from e (n), eta or an error of it; for a state x, xdot it is e itself. */
#ifndef EM_VELOCITY
#define EM_VELOCITY(mode, y, c, memory, e, v) em_copy(N, e, v)
#endif

/* How many numbers of a state change within a step: in mode 1 C and s are constant. */
EM_INLINE int em_group_moving(const em_lane_group *f) { return f->mode ? 2 * N : N_STATE; }

/* The smallest step of a lane: ten spacings of its time. */
EM_INLINE real em_group_least(real t) { return 10.0 * DBL_EPSILON * em_max(fabs(t), em_real(DBL_MIN / DBL_EPSILON)); }

/* t_new and h of the current step: of the chosen size, up to t_end at most. */
EM_INLINE void em_group_aim(const em_lane_group *f, em_lane_state *w) {
    const real end = em_real(f->task->t_end), least = em_group_least(*w->t);
    const real first = em_max(least, em_min(*w->h_next, em_real(f->task->max_step)));
    const real size = em_where(*w->retries > 0.0, *w->h_next, first);
    em_aim_step(f->direction, *w->t, size, end, w->t_new, w->h);
}

/* How many numbers contribute to the error norm: eigenfactors do where they are integrated (em_error_norm.h). */
EM_INLINE int em_group_counted(const em_lane_group *f) { return f->mode == 0 ? N_STATE : 2 * N; }

/* The weights of errors of the state; errors of eta are weighted by those of v that follow from them. */
EM_INLINE void em_group_weigh(const em_lane_group *f, const em_lane_state *w, real *weight) {
    const real *const v_new = w->K[EM_DOP853_TABLEAU.velocity_stage];
    for (int k = 0; k < N; ++k) {
        weight[k] = em_weight(f->task->atol[k], f->rtol, w->y[k], w->y_new[k]);
        weight[N + k] = em_weight(f->task->atol[k], f->rtol, w->K[0][k], v_new[k]);
    }
    for (int k = 2 * N; k < em_group_counted(f); ++k) {
        const int scales = (k >= 2 * N + N_C && k < 2 * N + N_C + N_S) || k >= N_STATE - N_SD;
        const real size = scales ? em_max(fabs(w->y[k]), fabs(w->y_new[k])) : em_real(1.0);
        weight[k] = 1.0 / (f->rtol * size + EM_LEAST_SIZE);
    }
}

/* The sum of EM_PARTIAL_SUMS partial sums. */
EM_INLINE real em_group_whole(const real *part) { return (part[0] + part[1]) + (part[2] + part[3]); }

/* sum_k (a_k b_k)^2 */
EM_INLINE real em_group_squares(int n, const real *a, const real *b) {
    real part[EM_PARTIAL_SUMS] = {{0.0}};
    for (int k = 0; k < n; ++k) part[k % EM_PARTIAL_SUMS] += (a[k] * b[k]) * (a[k] * b[k]);
    return em_group_whole(part);
}

/* The norm of the error (em_runge_kutta.h). */
EM_INLINE void em_group_norm(const em_lane_group *f, em_lane_state *w, const em_explicit *s, const real *weight) {
    real sum[2], error[2][EM_GROUP_STATE], v[N];
    real *const both[] = {error[0], error[1]};
    em_combine_rates(s, 2, EM_DOP853_TABLEAU.e, EM_DOP853_TABLEAU.stages, 0, both);
    for (int e = 0; e < 2; ++e) {
        EM_VELOCITY(f->mode, w->y, w->c, w->memory, error[e] + N, v);
        em_copy(N, v, error[e] + N);
        sum[e] = em_group_squares(em_group_counted(f), error[e], weight);
    }
    *w->error = em_error_of_two(*w->h, sum[0], sum[1], 2.0 * N);
}

/* Settles y_new in the lanes where *done stays set; v (n) <- the velocities before. */
EM_INLINE void em_group_settle(const em_lane_group *f, em_lane_state *w, EM_UNUSED real *v, EM_UNUSED em_truth *done) {
#ifdef EM_SETTLE
    real raw[N_STATE];
    if (EM_SECOND_ORDER) { /* settling changes v alone, in all lanes */
        em_copy(N, w->y_new + N, v);
        EM_SETTLE(f->mode, *w->t_new, w->y_new, w->c, NULL, *w->h * f->stretch, done);
        return;
    }
    em_copy(N_STATE, w->y_new, raw);
    EM_SETTLE(f->mode, *w->t_new, w->y_new, w->c, w->memory_new, *w->h * f->stretch, done);
    EM_VELOCITY(f->mode, raw, w->c, w->memory_new, raw + N, v);
    for (int k = 0; k < N_STATE; ++k) w->y_new[k] = em_where(*done, w->y_new[k], raw[k]);
#else
    (void)f, (void)w;
    if (N_POSITIONS > 0) *done = (em_truth){0}; /* Newton's method on positions is left to the scalar code */
#endif
}

/* The distance by which settling moved v, in tolerances (em_monitors.h). */
EM_INLINE real em_group_moved(EM_UNUSED const em_lane_state *w, EM_UNUSED const real *v, EM_UNUSED const real *weight) {
    real sum = em_real(0.0);
#ifdef EM_SETTLE
    for (int k = 0; k < N; ++k) {
        const real moved = (w->f_new[k] - v[k]) * weight[N + k];
        sum += moved * moved;
    }
#endif
    return N_ROWS > 0 ? sqrt(sum / (2.0 * N)) : sum;
}

/* Whether all numbers are finite: NaN and infinity survive a product with zero. */
EM_INLINE em_truth em_group_finite(const real *a) {
    real part[EM_PARTIAL_SUMS] = {{0.0}};
    for (int k = 0; k < N_STATE; ++k) part[k % EM_PARTIAL_SUMS] += 0.0 * a[k];
    return em_group_whole(part) == 0.0;
}

EM_INLINE int em_group_rate(void *lane_state, const real *t, const real *y, real *dy) {
    const em_lane_state *const w = lane_state;
    rhs_on_lanes(w->group->mode, (const double *)t, (const double *)y, (const double *)w->c, (const double *)w->u, 0, (double *)dy);
    return 0;
}

/* stiff <- whether stability limits the step size, in the lanes where this is due (em_rk_judge); argument: of the last
 * stage. */
EM_INLINE void em_group_judge(em_lane_state *w, const real *argument, const real *weight) {
    const int last = EM_DOP853_TABLEAU.stages - 1;
    const em_truth judged = *w->n_steps >= *w->next_stiffness_check;
    real apart = em_real(0.0), driven = em_real(0.0);
    if (!em_any(judged)) return;
    for (int k = 0; k < 2 * N; ++k) {
        const real state = (w->y_new[k] - argument[k]) * weight[k], rate = (w->f_new[k] - w->K[last][k]) * weight[k];
        apart += state * state;
        driven += rate * rate;
    }
    const em_truth stiff = em_is_stiff(em_stability_bound(EM_DOP853_STABLE, w->group->rtol), *w->h, apart, driven);
    *w->stiff = em_where(judged, em_where(stiff, em_real(1.0), em_real(0.0)), *w->stiff);
}

/* Results of an attempt at a step. */
typedef struct em_attempts {
    em_truth sound, settled; /* -1: its numbers are finite; its end is settled */
    real moved, error, factor; /* distance of settling; log of the error; ratio of the next step size */
} em_attempts;

/* error and factor */
EM_INLINE void em_group_control(const em_lane_state *w, em_attempts *found) {
    const em_size_control control = EM_RUNGE_KUTTA_CONTROL(EM_DOP853_TABLEAU);
    found->error = log(em_max(*w->error, em_real(1e-300)));
    const real factor = em_size_ratio(&control, found->error, *w->last_error);
    found->factor = em_where(*w->retries > 0.0, em_min(em_real(1.0), factor), factor);
}

/* Makes an attempt at a step in every lane. */
static em_attempts em_group_attempt(const em_lane_group *f, em_lane_state *w) {
    em_attempts found = {.settled = ~(em_truth){0}};
    real argument[EM_GROUP_STATE], weight[N_STATE], v[N];
    const em_explicit s = {em_group_moving(f), EM_GROUP_STATE, 1, 0, w->t, w->h, w->y, w->K[0], argument, w->y_new};
    for (int k = em_group_moving(f); k < N_STATE; ++k) w->y_new[k] = w->y[k];
    em_explicit_step(&EM_DOP853_TABLEAU, &s, 1, em_group_rate, w);
    em_group_weigh(f, w, weight);
    em_group_norm(f, w, &s, weight);
    em_group_control(w, &found); /* here, where its latency overlaps with settling */
    em_group_settle(f, w, v, &found.settled);
    em_group_rate(w, w->t_new, w->y_new, w->f_new);
    em_group_judge(w, argument, weight);
    found.moved = em_group_moved(w, v, weight);
    found.sound = em_group_finite(w->y_new) & (em_group_finite(w->f_new) | ~(*w->error < 1.0)) & (*w->error < INFINITY);
    return found;
}

/* -1 in lanes where parameters of a rotation have become too large (em_shadow_parameters.h). */
EM_INLINE em_truth em_group_leaves_chart(EM_UNUSED const em_lane_state *w) {
    em_truth leaves = {0};
#ifdef EM_ROTATIONS
    for (int k = 0; k < N_ROTATIONS; ++k) {
        const real *const y = w->y_new, a = y[rotations[k][0]], b = y[rotations[k][1]], c = y[rotations[k][2]];
        leaves |= a * a + b * b + c * c > EM_MOST_RODRIGUES;
    }
#endif
    return leaves;
}

/* -1 in lanes whose `accepted` step the scalar code must check: the first step, short steps at which a singularity may
 * be near (em_singularity_monitor.h), and steps at which the energy, a row, the end or a change of rotation parameters
 * is due. */
EM_INLINE em_truth em_group_needs_check(const em_lane_group *f, const em_lane_state *w, em_truth accepted) {
    em_truth unresolved = accepted & ((fabs(*w->h) < EM_CHECKED_STEP * *w->longest) | (*w->retries > 0.0));
#ifdef EM_PIVOTS
    if (em_any(unresolved)) unresolved &= ~em_resolved(*w->t, w->y, *w->t_new, w->y_new, w->c, f->rtol);
#endif
    return unresolved | em_group_leaves_chart(w) | (*w->longest == 0.0) |
           (*w->n_rhs + (double)EM_GROUP_STAGES >= *w->next_check) |
           (f->direction * (*w->t_new - *w->t_check) >= 0.0);
}

/* -1 in lanes whose run the scalar code must repeat from its start: a step is not finite, or settling moved it far
 * (em_monitors.h), or steps become too short or too many. */
EM_INLINE em_truth em_group_lost(const em_lane_group *f, const em_lane_state *w, const em_attempts *found,
                                 em_truth accepted) {
    return ~found->sound | (accepted & (found->moved > 10.0)) | (~accepted & (*w->h_next < em_group_least(*w->t))) |
           (accepted & (*w->n_steps + 1.0 >= (double)f->task->max_steps));
}

/* Makes the end of a step the start of the next, in lanes that took it. */
static void em_group_commit(em_lane_state *w, em_truth tried, em_truth took) {
    const real none = em_real(0.0), one = em_real(1.0);
    for (int k = 0; k < N_STATE; ++k) {
        w->y[k] = em_where(took, w->y_new[k], w->y[k]);
        w->K[0][k] = em_where(took, w->f_new[k], w->K[0][k]);
    }
    for (int k = 0; k < EM_REMEMBERED; ++k) w->memory[k] = em_where(took, w->memory_new[k], w->memory[k]);
    *w->t = em_where(took, *w->t_new, *w->t);
    *w->longest = em_where(took, em_max(*w->longest, fabs(*w->h)), *w->longest);
    *w->n_stiff += em_where(took, *w->stiff, none);
    const em_truth tested = took & (*w->n_steps >= *w->next_stiffness_check);
    *w->next_stiffness_check += em_where(tested, em_real(EM_STIFF_EVERY), none);
    *w->n_steps += em_where(took, one, none);
    *w->n_rejected += em_where(tried & ~took, one, none);
    *w->retries = em_where(took, none, *w->retries + em_where(tried, one, none));
    *w->n_rhs += em_where(took, one, none) + em_where(tried, em_real(EM_GROUP_STAGES - 1.0), none);
}

/* -1 in lanes that hold a run. */
EM_INLINE em_truth em_group_live(const em_lane_group *f) {
    em_truth live;
    for (int lane = 0; lane < EM_LANES; ++lane) live[lane] = -f->live[lane];
    return live;
}

/* Makes one attempt at a step in every lane, and accepts or rejects it. */
static void em_group_step(em_lane_group *f, em_lane_state *w) {
    em_group_aim(f, w);
    const em_attempts found = em_group_attempt(f, w);
    const em_truth accepted = found.sound & (*w->error < 1.0), live = em_group_live(f);
    const em_truth needs_check =
        f->check_always ? accepted : accepted & (em_group_needs_check(f, w, accepted) | ~found.settled);
    *w->h_next = fabs(*w->h) * found.factor;
    *w->last_error = em_where(accepted, em_max(found.error, em_real(EM_LEAST_ERROR)), *w->last_error);
    const em_truth lost = em_group_lost(f, w, &found, accepted), checked = live & (lost | needs_check);
    em_truth stays = live & ~checked;
    for (int lane = 0; lane < EM_LANES && em_any(checked); ++lane) {
        const em_lane_outcome outcome = lost[lane] ? EM_LOST : found.settled[lane] ? EM_SETTLED : EM_UNSETTLED;
        if (checked[lane] && f->check_step(f, lane, outcome) == 0) stays[lane] = -1;
    } /* if its run does not continue, the lane now holds another member, or none */
    em_group_commit(w, stays, stays & accepted);
}

/* Makes steps as long as the group has members and does not yield to the other group; f->check_step loads members into
 * lanes. */
static void em_group_run(em_lane_group *f) {
    em_lane_state w = {
        f, (real *)f->y, (real *)f->y_new, (real *)f->f_new, (real *)f->c, (real *)f->u, (real (*)[EM_GROUP_STATE])f->K,
        (real *)f->t, (real *)f->t_new, (real *)f->h, (real *)f->h_next, (real *)f->error, (real *)f->last_error,
        (real *)f->longest, (real *)f->n_steps, (real *)f->n_rejected, (real *)f->retries, (real *)f->n_rhs,
        (real *)f->stiff, (real *)f->n_stiff, (real *)f->next_stiffness_check, (real *)f->next_check, (real *)f->t_check,
        (real *)f->memory, (real *)f->memory_new};
    for (unsigned attempt = 1; f->n_live > 0 && !f->yields; ++attempt) {
        em_group_step(f, &w);
        if (attempt % EM_ATTEMPTS_PER_POLL == 0 && f->stopped(f)) return;
    }
}

#endif
