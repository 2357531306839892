/* em_time_event_jump.h: jump conditions at a time event, where a condition on time alone changes (em_time_events.h).
 *
 * Forces may jump there. So may rows of velocity constraints: velocities then change by an impulse along the rows that
 * hold afterwards, to the nearest velocities, in the mass metric, that satisfy these rows. If phi jumps, no motion
 * continues. If the momenta of T jump, as with a mass that changes suddenly, T alone does not determine the
 * velocities. Both end the run with a named reason. */
#ifndef EM_TIME_EVENT_JUMP_H
#define EM_TIME_EVENT_JUMP_H

#include "stepper/em_smooth_intervals.h"

#define EM_JUMPS 1e-9 /* a number jumps if it changes by this part of its terms */

/* Two times on each side of a time event: just outside its rounding, and further away. */
typedef struct em_sides {
    double t[4]; /* far before, before, after, far after */
} em_sides;

static em_sides em_sides_of(const em_run_state *w) {
    const double after = w->direction > 0.0 ? w->inside[0] : w->inside[1], reach = after - w->t;
    return (em_sides){{w->t - 100.0 * reach, w->t - reach, after, w->t + 100.0 * reach}};
}

/* Whether a number with values g (4) at these times jumps: a continuous one changes more at the times further away. */
static int em_number_jumps(const double *g, double size) {
    const double near = fabs(g[2] - g[1]), far = fabs(g[3] - g[0]);
    return near > EM_JUMPS * size && near > 0.1 * far;
}

/* The index of the first of `count` numbers g (4, most), with `terms` of each, that jumps; or -1. */
static int em_first_jump(int count, int most, const double *g, const double *terms) {
    for (int i = 0; i < count; ++i) {
        const double one[4] = {g[i], g[most + i], g[2 * most + i], g[3 * most + i]};
        if (em_number_jumps(one, terms[i])) return i;
    }
    return -1;
}

/* The first coordinate whose momentum M v + G jumps, or -1. */
static int em_momentum_jumps(const em_run_state *w, const em_sides *at) {
    const int n = w->n, numbers = n * n + n;
    double g[4][numbers], terms[numbers], e[4], one[n];
    for (int side = 0; side < 4; ++side) {
        w->model->mass_matrix(at->t[side], w->y, w->run->prepared, g[side]);
        for (int k = 0; k < n; ++k) {
            memset(one, 0, sizeof one);
            one[k] = 1.0;
            w->model->energy(at->t[side], w->y, one, w->run->prepared, e);
            g[side][n * n + k] = e[1];
        }
    }
    for (int i = 0; i < n * n; ++i) terms[i] = sqrt(fabs(g[1][i / n * (n + 1)] * g[1][i % n * (n + 1)]));
    for (int k = 0; k < n; ++k) terms[n * n + k] = fabs(g[1][n * n + k]) + fabs(g[2][n * n + k]);
    const int first = em_first_jump(numbers, numbers, g[0], terms);
    return first < 0 ? -1 : first < n * n ? first / n : first - n * n;
}

/* The contact whose row jumps while it holds, or -1: a contact may push, but the projection would also pull. */
static int em_contact_jumps(const em_run_state *w, const em_sides *at) {
    const int n = w->n, m = w->n_rows, numbers = m * n + m;
    if (w->dynamics->switched_rows == 0) return -1;
    double rows[4][numbers], terms[numbers];
    for (int side = 0; side < 4; ++side)
        w->model->pfaffian(at->t[side], w->y, w->run->prepared, rows[side], rows[side] + m * n);
    for (int i = 0; i < numbers; ++i) terms[i] = fabs(rows[1][i]) + fabs(rows[2][i]);
    const int first = em_first_jump(numbers, numbers, rows[0], terms);
    const int row = first < m * n ? first / n : first - m * n;
    return first >= 0 && (w->dynamics->switched_rows >> row & 1) ? row : -1;
}

/* Projects velocities onto the rows after a time event. 0, or -1 and w->reason. */
static int em_project_after_time_event(em_run_state *w, const em_sides *at) {
    const int m = w->n_rows;
    double phi[4][em_some(m)], terms[em_some(m)];
    memset(phi, 0, sizeof phi), memset(terms, 0, sizeof terms);
    if (m == 0) return 0;
    for (int side = 0; w->n_positions > 0 && side < 4; ++side) w->model->position(at->t[side], w->y, w->run->prepared, phi[side], terms);
    const int row = em_first_jump(w->n_positions, m, phi[0], terms);
    if (row >= 0) return em_fail(&w->reason, EM_MODEL_JUMPS, row, EM_POSITION_JUMPS, fabs(phi[2][row] - phi[1][row]));
    const int contact = em_contact_jumps(w, at);
    if (contact >= 0) return em_fail(&w->reason, EM_MODEL_JUMPS, contact, EM_CONTACT_JUMPS, NAN);
    return em_settle(w->model, w->run, &w->mode, EM_STABILISE, at->t[2], w->y, w->memory, 0.0, &w->reason) < 0 ? -1 : 0;
}

/* Crosses a time event. 0, or -1 and w->reason. */
EM_NOINLINE int em_cross_time_event(em_run_state *w) {
    const em_sides at = em_sides_of(w);
    const int first = em_momentum_jumps(w, &at);
    if (first >= 0) return em_fail(&w->reason, EM_MODEL_JUMPS, first, -1, NAN);
    return em_project_after_time_event(w, &at);
}

#endif
