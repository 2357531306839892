/* em_flock.h: runs side by side, one in each lane, by dop853: what is done for all lanes at once.
 *
 * Included by NAME.c where that is compiled for lanes. Each lane has its own time, step size and error, and none looks at
 * another: a member's numbers are the same in whatever lane and company. Most steps need no more than this; at others
 * the lane's run is looked at number by number (em_member.h). */
#ifndef EM_FLOCK_H
#define EM_FLOCK_H

#include "em_linear.h"
#include "em_tableaux.h"

enum {
    EM_TOGETHER = 4, /* states whose sums are made together */
    EM_FLOCK_STATE = (N_STATE + EM_TOGETHER - 1) / EM_TOGETHER * EM_TOGETHER,
    EM_FLOCK_STAGES = 12,
    EM_FLOCK_LOOKS = 64 /* attempts between two looks at whether an end is wanted */
};

/* The arrays of a flock (eigenmotion.h), as vectors. */
typedef struct em_lane_state {
    real *y, *y_new, *f_new, *c, *u;
    real (*K)[EM_FLOCK_STATE];
    real *t, *t_new, *h, *h_next, *error, *last_error, *longest, *n_steps, *n_rejected, *retries, *n_rhs;
    real *stiff, *n_stiff, *next_judge, *next_look, *t_look;
} em_lane_state;

EM_INLINE real em_lane_max(real a, real b) { return em_where(a > b, a, b); }
EM_INLINE real em_lane_min(real a, real b) { return em_where(a < b, a, b); }

/* out <- y + h sum_j a_j K_j over j < n; y NULL: 0 */
static void em_flock_combine(const double *a, int n, real h, const real *y, real (*K)[EM_FLOCK_STATE], real *out) {
    for (int k = 0; k < EM_FLOCK_STATE; k += EM_TOGETHER) {
        real sum[EM_TOGETHER] = {{0.0}};
        for (int j = 0; j < n; ++j) {
            if (a[j] == 0.0) continue;
            for (int i = 0; i < EM_TOGETHER; ++i) sum[i] += a[j] * K[j][k + i];
        }
        for (int i = 0; i < EM_TOGETHER; ++i) out[k + i] = y ? y[k + i] + h * sum[i] : h * sum[i];
    }
}

/* The part of a lane's time that is no step: the spacing of numbers there, times ten. */
EM_INLINE real em_flock_least(real t) { return 10.0 * DBL_EPSILON * em_lane_max(fabs(t), em_real(DBL_MIN / DBL_EPSILON)); }

/* t_new and h of the step under way: of the size that was chosen, no further than t_end. */
EM_INLINE void em_flock_aim(const em_flock *f, em_lane_state *w) {
    const real end = em_real(f->task->t_end), least = em_flock_least(*w->t);
    const real first = em_lane_max(least, em_lane_min(*w->h_next, em_real(f->task->max_step)));
    const real size = em_where(*w->retries > 0.0, *w->h_next, first);
    const real aimed = *w->t + f->direction * size;
    *w->t_new = em_where(f->direction * (aimed - end) > 0.0, end, aimed);
    *w->h = *w->t_new - *w->t;
}

/* The weights of x and v, and the norm of the error in them (em_runge_kutta.h). */
EM_INLINE void em_flock_norm(const em_flock *f, em_lane_state *w, real *weight) {
    const em_tableau *const rk = &EM_DOP853_TABLEAU;
    real error[2][EM_FLOCK_STATE], sum[2] = {em_real(0.0), em_real(0.0)};
    for (int e = 0; e < 2; ++e) em_flock_combine(rk->e[e], rk->stages, em_real(1.0), NULL, w->K, error[e]);
    for (int k = 0; k < 2 * N; ++k) {
        const real after = k < N ? w->y_new[k] : w->K[rk->velocity_stage][k - N];
        const real size = em_lane_max(fabs(w->y[k]), fabs(after));
        weight[k] = 1.0 / (f->task->atol[k % N] + f->rtol * size + DBL_MIN);
        for (int e = 0; e < 2; ++e) sum[e] += (error[e][k] * weight[k]) * (error[e][k] * weight[k]);
    }
    const real under = sum[0] + 0.01 * sum[1];
    *w->error = em_where(under == 0.0, em_real(0.0), fabs(*w->h) * sum[0] / sqrt(under * (2.0 * N)));
}

/* y_new on the constraints. Returns how far that moved v, in tolerances (em_trust.h). */
EM_INLINE real em_flock_settle(EM_UNUSED const em_flock *f, EM_UNUSED em_lane_state *w, EM_UNUSED const real *weight) {
#ifdef EM_SETTLE
    real before[N], sum = em_real(0.0);
    em_copy(N, w->y_new + N, before);
    EM_SETTLE(*w->t_new, w->y_new, w->c);
    for (int k = 0; k < N; ++k) {
        const real moved = (w->y_new[N + k] - before[k]) * weight[N + k];
        sum += moved * moved;
    }
    return sqrt(sum / (2.0 * N));
#else
    return em_real(0.0);
#endif
}

/* NaN and infinity survive a product with zero. */
EM_INLINE em_truth em_flock_finite(const real *a) {
    real sum = em_real(0.0);
    for (int k = 0; k < N_STATE; ++k) sum += 0.0 * a[k];
    return sum == 0.0;
}

/* Whether stability keeps steps short, of lanes of which that is judged now (em_rk_judge); argument: of the last stage. */
EM_INLINE void em_flock_judge(em_lane_state *w, const real *argument, const real *weight) {
    const int last = EM_DOP853_TABLEAU.stages - 1;
    real apart = em_real(0.0), driven = em_real(0.0);
    for (int k = 0; k < 2 * N; ++k) {
        const real state = (w->y_new[k] - argument[k]) * weight[k], rate = (w->f_new[k] - w->K[last][k]) * weight[k];
        apart += state * state;
        driven += rate * rate;
    }
    const em_truth stiff = *w->h * *w->h * driven > EM_DOP853_STABLE * EM_DOP853_STABLE * apart;
    *w->stiff = em_where(*w->n_steps >= *w->next_judge, em_where(stiff, em_real(1.0), em_real(0.0)), *w->stiff);
}

/* An attempt at a step in every lane; -1 in *sound where it gave numbers that can be judged. Returns how far settling moved. */
static real em_flock_attempt(const em_flock *f, em_lane_state *w, em_truth *sound) {
    const em_tableau *const rk = &EM_DOP853_TABLEAU;
    real argument[EM_FLOCK_STATE], weight[2 * N], moved = em_real(0.0);
    for (int stage = 1; stage <= rk->stages; ++stage) {
        const int last = stage == rk->stages;
        real *const place = last ? w->y_new : argument;
        em_flock_combine(rk->a[stage], stage, *w->h, w->y, w->K, place);
        if (last) {
            em_flock_norm(f, w, weight);
            moved = em_flock_settle(f, w, weight);
        }
        real t = *w->t + rk->c[stage] * *w->h;
        if (last) t = *w->t_new;
        rhs_on_lanes(0, (const double *)&t, (const double *)place, (const double *)w->c, (const double *)w->u, 0,
                     (double *)(last ? w->f_new : w->K[stage]));
    }
    em_flock_judge(w, argument, weight);
    *sound = em_flock_finite(w->y_new) & (em_flock_finite(w->f_new) | ~(*w->error < 1.0)) & (*w->error < INFINITY);
    return moved;
}

/* The size of the next step, as in em_step_size.h and em_step.h. */
EM_INLINE void em_flock_resize(em_lane_state *w, em_truth accepted) {
    enum { ORDER = 8 };
    const real error = log(em_lane_max(*w->error, em_real(1e-300)));
    const real wanted = em_where(error < 0.0, 0.4 * *w->last_error - 0.7 * error, -error);
    real factor = em_lane_min(em_real(4.0), em_lane_max(em_real(0.2), 0.9 * exp(wanted / (double)ORDER)));
    factor = em_where(*w->retries > 0.0, em_lane_min(em_real(1.0), factor), factor);
    *w->h_next = fabs(*w->h) * factor;
    *w->last_error = em_where(accepted, em_lane_max(error, em_real(-9.2)), *w->last_error);
}

/* -1 in lanes whose accepted step is looked at number by number: the short ones, at which a singularity may be near
 * (em_chart.h), and those at which the energy, a row or the end is due. */
EM_INLINE em_truth em_flock_due(const em_flock *f, const em_lane_state *w) {
    return (fabs(*w->h) < 0.25 * *w->longest) | (*w->longest == 0.0) | (*w->retries > 0.0) |
           (*w->n_rhs + (double)EM_FLOCK_STAGES >= *w->next_look) | (f->direction * (*w->t_new - *w->t_look) >= 0.0);
}

/* -1 in lanes whose run goes on number by number, from its start: what a step made is not sound, or was moved far
 * (em_trust.h), or steps become too short, or too many. */
EM_INLINE em_truth em_flock_lost(const em_flock *f, const em_lane_state *w, em_truth sound, em_truth small, real moved) {
    return ~sound | (small & (moved > 10.0)) | (~small & (*w->h_next < em_flock_least(*w->t))) |
           (small & (*w->n_steps + 1.0 >= (double)f->task->max_steps));
}

/* The end of a step becomes the start of the next, in lanes that took it. */
static void em_flock_commit(em_lane_state *w, em_truth tried, em_truth took) {
    const real none = em_real(0.0), one = em_real(1.0);
    for (int k = 0; k < N_STATE; ++k) {
        w->y[k] = em_where(took, w->y_new[k], w->y[k]);
        w->K[0][k] = em_where(took, w->f_new[k], w->K[0][k]);
    }
    *w->t = em_where(took, *w->t_new, *w->t);
    *w->longest = em_where(took, em_lane_max(*w->longest, fabs(*w->h)), *w->longest);
    *w->n_stiff += em_where(took, *w->stiff, none);
    *w->next_judge += em_where(took & (*w->n_steps >= *w->next_judge), em_real(EM_STIFF_EVERY), none);
    *w->n_steps += em_where(took, one, none);
    *w->n_rejected += em_where(tried & ~took, one, none);
    *w->retries = em_where(took, none, *w->retries + em_where(tried, one, none));
    *w->n_rhs += em_where(took, one, none) + em_where(tried, em_real(EM_FLOCK_STAGES - 1.0), none);
}

/* One attempt at a step in every lane, and what follows from it. */
static void em_flock_step(em_flock *f, em_lane_state *w) {
    em_truth sound, stays = {0};
    em_flock_aim(f, w);
    const real moved = em_flock_attempt(f, w, &sound);
    const em_truth small = sound & (*w->error < 1.0);
    const em_truth due = em_flock_due(f, w);
    em_flock_resize(w, small);
    const em_truth lost = em_flock_lost(f, w, sound, small, moved);
    for (int lane = 0; lane < EM_LANES; ++lane) {
        if (!f->live[lane]) continue;
        if (lost[lane]) f->look(f, lane, 1);
        else if (!small[lane] || !(f->always || due[lane]) || f->look(f, lane, 0) == 0) stays[lane] = -1;
    } /* where it does not stay, there is another member now, or none */
    em_flock_commit(w, stays, stays & small);
}

/* All members: f->look puts them into lanes. */
static void em_flock_run(em_flock *f) {
    em_lane_state w = {
        (real *)f->y, (real *)f->y_new, (real *)f->f_new, (real *)f->c, (real *)f->u, (real (*)[EM_FLOCK_STATE])f->K,
        (real *)f->t, (real *)f->t_new, (real *)f->h, (real *)f->h_next, (real *)f->error, (real *)f->last_error,
        (real *)f->longest, (real *)f->n_steps, (real *)f->n_rejected, (real *)f->retries, (real *)f->n_rhs,
        (real *)f->stiff, (real *)f->n_stiff, (real *)f->next_judge, (real *)f->next_look, (real *)f->t_look};
    for (unsigned attempt = 1; f->n_live > 0; ++attempt) {
        em_flock_step(f, &w);
        if (attempt % EM_FLOCK_LOOKS == 0 && f->stopped(f)) return;
    }
}

#endif
