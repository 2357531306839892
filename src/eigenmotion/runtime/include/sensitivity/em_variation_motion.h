/* em_variation_motion.h: the motion along which the variational equations are integrated, within one of their steps.
 *
 * It is the dense output of the run, which is as accurate as the tolerances of the run, or less. So it is checked
 * against the equations of motion. Its errors at the nodes of a step follow from collocation with its accelerations
 * there,
 *
 *     off_v = v - v_0 - h A a,    off_x = x - x_0 - c h v_0 - h^2 A^2 a,
 *
 * and if they exceed the run's tolerances, the step solves these equations for a motion of its own, by Newton's
 * method.
 *
 * A direction S = shift (v, a) + rest has a part along the motion, a shift in time. Where motions of another speed drift
 * apart for long, nearly all of S is this part, and an error relative to S that changes their speed a little would drive
 * them apart again. So a step integrates only the rest, with an error relative to that. At its end the shift is added,
 * which has not changed:
 *
 *     S_v' = J S + F    =>    rest_v' = J rest + F - shift da/dt at a fixed state.
 *
 * A coordinate that depends much less on the direction's parameter than it moves, as of another machine in the same
 * model, is not shifted: its rest would cancel the shift, with an error relative to that. Then J acts on the shifts of
 * the other coordinates,
 *
 *     rest_i'' = J rest + F + sum over q of J_iq (shift_q - shift_i) (v, a)_q - shift_i da_i/dt at a fixed state. */
#ifndef EM_VARIATION_MOTION_H
#define EM_VARIATION_MOTION_H

#include "sensitivity/em_variation_time_events.h"

#define EM_MOTION_ERROR 10.0 /* the allowed error of the run's motion within a step, in tolerances of the run */
#define EM_NEARLY_ALONG 0.9995    /* the cosine of directions that are nearly along the motion: 2 degrees */
#define EM_MOST_OF_SHIFT 100.0    /* in tolerances: the allowed error of the part of a direction along the motion */
#define EM_MOST_OF_CHANGING 1e4   /* where J changes in a step */
#define EM_MOST_OF_RATE 1e-3      /* of a rate: more is no small part of it, however loose the tolerance */
#define EM_CHANGING 0.1           /* by this part of it */
#define EM_MOST_OF_REST 30.0      /* in sizes of a coordinate in a direction: the most that is left of it without a shift */
#define EM_STIFF 10.0             /* the change of an acceleration in a step, relative to its size, by terms that cancel */
#define EM_LAST_DIGITS (64.0 * DBL_EPSILON)

/* The last kept step of a run that starts at or before t. */
static size_t em_dense_at(const em_run *run, double t) {
    const double sign = run->t_end < run->t_start ? -1.0 : 1.0;
    size_t low = 0, high = run->n_dense;
    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        if (sign * run->dense_steps[middle].t <= sign * t) low = middle;
        else high = middle;
    }
    return low;
}

/* The start of the kept step that is this many steps, or fractions of one, after the one at t. */
static double em_dense_beyond(const em_run *run, double t, double steps) {
    const size_t at = em_dense_at(run, t), after = at + (size_t)steps;
    if (after >= run->n_dense) return run->t_reached;
    const double begin = run->dense_steps[after].t;
    const double end = after + 1 < run->n_dense ? run->dense_steps[after + 1].t : run->t_reached;
    return begin + (steps - floor(steps)) * (end - begin);
}

/* z (2 n) <- x and v of the run at t. */
static int em_recorded_motion(em_pass *p, double t, double *z) {
    em_variations *const w = p->of;
    const em_run *const run = w->run;
    const double low = fmin(run->t_start, run->t_reached), high = fmax(run->t_start, run->t_reached);
    const double at = fmin(fmax(t, low), high);
    if (w->model->interpolate(run, em_dense_at(run, at), at, p->y)) return em_fail(&w->fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    memcpy(z, p->y, p->n * sizeof *z);
    return w->model->velocity(at, p->y, w->c, z + p->n, &w->fault);
}

/* The tolerance of the run for number i of z, of this size. */
static double em_run_tolerance(const em_pass *p, int i, double size) {
    const em_run *const run = p->of->run;
    return run->atol[i % p->n] + fmax(run->rtol, EM_LAST_DIGITS) * size;
}

static double em_node_time(const em_pass *p, double from, double to, int j) {
    return j + 1 < EM_VARIATION_NODES ? from + p->of->place[j] * (to - from) : to;
}

/* drive (n) <- the rate of a at a fixed state, from J there. */
static void em_drive_of(const em_pass *p, const double *J, double *drive) {
    const em_model *const model = p->of->model;
    const int n = p->n, width = model->n_arguments, last = p->columns - 1;
    for (int i = 0; i < n; ++i) {
        const double *const by_forcing = J + i * width + 2 * n;
        drive[i] = by_forcing[p->of->n_forcing - 1];
        for (int u = 0; u < model->n_inputs; ++u) drive[i] += by_forcing[u] * p->P[u * p->columns + last];
    }
}

/* a and J at the nodes of a step. */
static int em_node_jacobians(em_pass *p, double from, double to) {
    em_variations *const w = p->of;
    const int n = p->n, width = w->model->n_arguments;
    for (int j = 0; j < EM_VARIATION_NODES; ++j) {
        const double t = em_node_time(p, from, to, j), *const z = p->Z + j * 2 * n;
        em_pass_inputs(p, t);
        if (w->model->motion_derivatives(em_pass_clock(p, t), z, z + n, p->c, p->u, w->least_norm, p->a + j * n, p->lambda,
                                         p->J + j * n * width, p->dlambda, &w->fault)) return -1;
        em_drive_of(p, p->J + j * n * width, p->drive + j * n);
    }
    return 0;
}

/* off (nodes, 2 n) <- the error of the motion. Returns the largest, relative to the run's tolerances. */
static double em_motion_error(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n;
    double most = 0.0;
    for (int j = 0; j < NODES; ++j)
        for (int i = 0; i < n; ++i) {
            double once = 0.0, twice = 0.0;
            for (int k = 0; k < NODES; ++k) {
                once += p->of->A[j * NODES + k] * p->a[k * n + i];
                twice += p->of->A2[j * NODES + k] * p->a[k * n + i];
            }
            const double *const z = p->Z + j * 2 * n, *const v0 = p->z + n;
            double *const off = p->off + j * 2 * n;
            off[i] = z[i] - p->z[i] - h * (p->of->place[j] * v0[i] + h * twice);
            off[n + i] = z[n + i] - v0[i] - h * once;
            most = fmax(most, fabs(off[i]) / (em_run_tolerance(p, i, fmax(fabs(z[i]), fabs(p->z[i]))) + DBL_MIN));
            most = fmax(most, fabs(off[n + i]) / (em_run_tolerance(p, n + i, fmax(fabs(z[n + i]), fabs(v0[i]))) + DBL_MIN));
        }
    return most;
}

/* Z <- the step's own motion, from the accelerations in the last direction's K. */
static void em_correct_motion(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n, k = p->columns;
    for (int j = 0; j < NODES; ++j)
        for (int i = 0; i < n; ++i) {
            double once = 0.0, twice = 0.0;
            for (int q = 0; q < NODES; ++q) {
                const double change = p->K[(q * n + i) * k + k - 1];
                once += p->of->A[j * NODES + q] * change;
                twice += p->of->A2[j * NODES + q] * change;
            }
            p->Z[j * 2 * n + i] += h * h * twice - p->off[j * 2 * n + i];
            p->Z[j * 2 * n + n + i] += h * once - p->off[j * 2 * n + n + i];
        }
}

/* jerk (nodes + 1, n) <- the rates of a along the motion, at the nodes and at the start of a step. */
static void em_find_jerk(em_pass *p) {
    const int n = p->n, width = p->of->model->n_arguments;
    for (int j = 0; j <= EM_VARIATION_NODES; ++j) {
        const int is_node = j < EM_VARIATION_NODES;
        const double *const v = (is_node ? p->Z + j * 2 * n : p->z) + n, *const a = is_node ? p->a + j * n : p->a0;
        const double *const J = is_node ? p->J + j * n * width : p->J0;
        const double *const drive = is_node ? p->drive + j * n : p->drive0;
        for (int i = 0; i < n; ++i) {
            double sum = drive[i];
            for (int q = 0; q < n; ++q) sum += J[i * width + q] * v[q] + J[i * width + n + q] * a[q];
            p->jerk[j * n + i] = sum;
        }
    }
}

/* off (2 n) <- the error of (v, a) at the end of a solved step, that of the run's motion that starts where the step does.
 * At rest, where (v, a) is rounding, it is all of it. `jump` (2 n): from the step's motion to that with which the next
 * step starts. */
static void em_shift_error(const em_pass *p, double h, const double *jump, double *off) {
    enum { NODES = EM_VARIATION_NODES, LAST = NODES - 1 };
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments;
    double dz[2 * n];
    for (int i = 0; i < n; ++i) {
        dz[i] = jump[i] + p->off[LAST * 2 * n + i], dz[n + i] = jump[n + i] + p->off[LAST * 2 * n + n + i];
        for (int q = 0; q < NODES; ++q) {
            const double change = p->K[(q * n + i) * k + k - 1];
            dz[i] -= h * h * p->of->A2[LAST * NODES + q] * change, dz[n + i] -= h * p->of->A[LAST * NODES + q] * change;
        }
    }
    for (int i = 0; i < n; ++i) {
        const double *const J = p->J + (LAST * n + i) * width;
        off[i] = fabs(dz[n + i]), off[n + i] = 0.0;
        for (int q = 0; q < 2 * n; ++q) off[n + i] += J[q] * dz[q];
    }
}

/* shift (n, columns) <- `whole` (columns), but 0 for coordinates of which it leaves a much larger rest. T0: of S0. */
static void em_shift_coordinates(em_pass *p, double h, const double *whole) {
    const int n = p->n, k = p->columns;
    p->apart = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < k; ++j) {
            const int at = i * k + j;
            const double x = p->S0[at], v = h * p->S0[n * k + at], by = whole[j];
            const double size = fmax(fmax(fabs(x), fabs(v)), h * h * p->T0[at]);
            const double rest = fmax(fabs(x - by * p->z[n + i]), fabs(v - by * h * p->a0[i]));
            const int apart = rest > EM_MOST_OF_REST * size;
            p->shift[at] = apart ? 0.0 : by;
            p->apart |= apart && by != 0.0;
        }
}

/* shift (columns) <- the parts of S0 along the motion, in the mass metric, in which a velocity counts as what it moves in
 * a step of length h. 0 for directions that are not nearly along it. Returns whether one is. */
static int em_project_on_motion(const em_pass *p, double h, double *shift) {
    const int n = p->n, k = p->columns;
    const double *const S[2] = {p->S0, p->S0 + n * k}, *const rate[2] = {p->z + n, p->a0}, by[2] = {1.0, h * h};
    double size[k], MS[k], length = 0.0;
    int found = 0;
    memset(shift, 0, k * sizeof *shift), memset(size, 0, sizeof size);
    for (int half = 0; half < 2; ++half)
        for (int i = 0; i < n; ++i) {
            double Mr = 0.0;
            memset(MS, 0, sizeof MS);
            for (int q = 0; q < n; ++q) {
                const double M = by[half] * p->M[i * n + q];
                Mr += M * rate[half][q];
                em_add_to(k, M, S[half] + q * k, MS);
            }
            length += rate[half][i] * Mr;
            em_add_to(k, Mr, S[half] + i * k, shift);
            for (int j = 0; j < k; ++j) size[j] += S[half][i * k + j] * MS[j];
        }
    for (int j = 0; j < k; ++j) {
        const int nearly = j < p->of->columns && shift[j] * shift[j] >= EM_NEARLY_ALONG * EM_NEARLY_ALONG * length * size[j];
        shift[j] = nearly && length > 0.0 ? shift[j] / length : 0.0;
        found |= shift[j] != 0.0;
    }
    return found;
}

/* The size of the terms of row i of J (v, a) at the start of a step; change <- of those of its change in the step. */
static double em_jerk_terms(const em_pass *p, int i, double *change) {
    const int n = p->n, width = p->of->model->n_arguments;
    const double *const J = p->J0 + i * width, *const end = p->J + ((EM_VARIATION_NODES - 1) * n + i) * width;
    double terms = 0.0;
    *change = 0.0;
    for (int q = 0; q < 2 * n; ++q) {
        const double size = fabs(q < n ? p->z[n + q] : p->a0[q - n]);
        terms += fabs(J[q]) * size, *change += fabs(end[q] - J[q]) * size;
    }
    return terms;
}

/* Whether the terms of row i of J (v, a) cancel in a step, or change a many times: on a slow manifold, the error of a is
 * that of the state times J, which no part of S depends on. */
static int em_row_is_stiff(const em_pass *p, double length, int i, double terms) {
    double size = fabs(p->a0[i]);
    for (int j = 0; j < EM_VARIATION_NODES; ++j) size = fmax(size, fabs(p->a[j * p->n + i]));
    return length * terms > EM_STIFF * size;
}

/* shift <- 0 for directions of which a shift would make a number uncertain: it adds errors that are larger than those
 * numbers and the terms of their rates allow. Where J changes within a step, all of S depends on such errors of the
 * motion, and more is allowed. Where it does not, as in motions that die out, nothing drifts apart. Returns whether there
 * is such a direction. */
static int em_forget_shifts(em_pass *p, double h) {
    const int n = p->n, k = p->columns;
    const double *const off = p->shift_error, length = fabs(h);
    int certain[k], changes = 0, forgotten = 0;
    double most_shift[k];
    for (int j = 0; j < k; ++j) certain[j] = 1, most_shift[j] = 0.0;
    for (int at = 0; at < n * k; ++at) most_shift[at % k] = fmax(most_shift[at % k], fabs(p->shift[at]));
    for (int i = 0; i < n; ++i) {
        double change;
        const double terms = em_jerk_terms(p, i, &change);
        const int changing = change > EM_CHANGING * terms, stiff = em_row_is_stiff(p, length, i, terms);
        const double most = fmin(p->of->tolerance * (changing ? EM_MOST_OF_CHANGING : EM_MOST_OF_SHIFT), EM_MOST_OF_RATE);
        changes |= changing;
        for (int j = 0; j < k; ++j) {
            const double by = most_shift[j], *const S = p->S0 + i * k + j;
            const double rate = fabs(S[n * k]) + by * (fabs(p->a0[i]) + length * terms);
            certain[j] &= !stiff && by * fabs(off[n + i]) <= most * rate && by * off[i] <= most * (fabs(*S) + length * rate);
        }
    }
    for (int at = 0; at < n * k; ++at)
        if (p->shift[at] != 0.0 && !(changes && certain[at % k])) p->shift[at] = 0.0, forgotten = 1;
    return forgotten;
}

static int em_has_shifts(const em_pass *p) {
    for (int at = 0; at < p->n * p->columns; ++at)
        if (p->shift[at] != 0.0) return 1;
    return 0;
}

/* S (2 n, columns) += sign shift (v, a). */
static void em_add_shifts(const em_pass *p, double sign, const double *v, const double *a, double *S) {
    const int n = p->n, k = p->columns;
    for (int i = 0; i < n; ++i) {
        em_add_to(k, sign * v[i], p->shift + i * k, S + i * k);
        em_add_to(k, sign * a[i], p->shift + i * k, S + (n + i) * k);
    }
}

/* S0, K0, K += sign times those of the shifts. */
static void em_add_shifted_step(em_pass *p, double sign) {
    const int n = p->n, k = p->columns;
    em_add_shifts(p, sign, p->z + n, p->a0, p->S0);
    for (int i = 0; i < EM_VARIATION_NODES * n; ++i) em_add_to(k, sign * p->jerk[i], p->shift + i % n * k, p->K + i * k);
    for (int i = 0; i < n; ++i) em_add_to(k, sign * p->jerk[EM_VARIATION_NODES * n + i], p->shift + i * k, p->K0 + i * k);
}

/* The part of the accelerations in a step that a decaying series of eight terms does not represent. It exceeds a
 * tolerance if a force jumps. The effect of the run's tolerances of the state is subtracted. */
static double em_force_roughness(const em_pass *p) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n, width = p->of->model->n_arguments;
    const double *const C = p->of->series, *const z = p->Z + (NODES - 1) * 2 * n, *const J = p->J + (NODES - 1) * n * width;
    const double whole = fabs(p->of->run->t_reached - p->of->run->t_start);
    double most = 0.0;
    for (int i = 0; i < n; ++i) {
        double origin = 0.0, part[3] = {0.0}, size = fabs(p->a0[i]), allowed = em_run_tolerance(p, n + i, fabs(z[n + i])) / whole;
        for (int j = 0; j < NODES; ++j) {
            const double a = p->a[j * n + i];
            origin += p->origin[j] * a;
            for (int d = 0; d < 3; ++d) part[d] += C[(5 + d) * NODES + j] * a;
            size = fmax(size, fabs(a));
        }
        for (int k = 0; k < 2 * n; ++k) allowed += fabs(J[i * width + k]) * em_run_tolerance(p, k, fabs(z[k]));
        const double beyond = fabs(p->a0[i] - origin) / 2.0;
        const double ratio = fmax(beyond, fabs(part[2])) / fmax(fmax(fabs(part[1]), fabs(part[0])), DBL_MIN);
        const double rest = beyond * pow(fmin(ratio, 1.0), 3.0) - 10.0 * allowed - p->a_rounding[i];
        if (rest > 0.0) most = fmax(most, rest / size);
    }
    return most;
}

#endif
