/* em_variation_motion.h: the motion along which the variational equations are integrated, within one of their steps.
 *
 * It is the dense output of the run, which is as accurate as the tolerances of the run, or less. So it is checked
 * against the equations of motion. Its errors at the nodes of a step follow from collocation with its accelerations
 * there,
 *
 *     off_v = v - v_0 - h A a,    off_x = x - x_0 - c h v_0 - h^2 A^2 a,
 *
 * and if they exceed the run's tolerances, the step solves these equations for a motion of its own, by Newton's
 * method. */
#ifndef EM_VARIATION_MOTION_H
#define EM_VARIATION_MOTION_H

#include "sensitivity/em_variation_time_events.h"

#define EM_MOTION_ERROR 10.0 /* the allowed error of the run's motion within a step, in tolerances of the run */
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
static int em_motion_at(em_pass *p, double t, double *z) {
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

/* a and J at the nodes of a step. */
static int em_motion_derivatives(em_pass *p, double from, double to) {
    em_variations *const w = p->of;
    const int n = p->n, width = w->model->n_arguments;
    for (int j = 0; j < EM_VARIATION_NODES; ++j) {
        const double t = em_node_time(p, from, to, j), *const z = p->Z + j * 2 * n;
        em_pass_inputs(p, t);
        if (w->model->motion_derivatives(em_pass_clock(p, t), z, z + n, p->c, p->u, w->least_norm, p->a + j * n, p->lambda,
                                         p->J + j * n * width, p->dlambda, &w->fault)) return -1;
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
