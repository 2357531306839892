/* em_variation_steps.h: steps of the equations of variation, along a motion that is known within them.
 *
 * They are linear: S_v' = J_x S_x + J_v S_v + F, S_x' = S_v, with J and F at the nodes of a step by Radau IIA. So a step is
 * one linear system for K = S_v' at all nodes, of all directions, (I - h^2 A^2 J_x - h A J_v) K = J_x (S_x + c h S_v) +
 * J_v S_v + F: by elimination, or by iteration where it is large and that converges. */
#ifndef EM_VARIATION_STEPS_H
#define EM_VARIATION_STEPS_H

#include "em_variation_breaks.h"

/* W (rows, columns) += D (rows, inner; `width` apart) S (inner, columns) */
EM_INLINE void em_add_product(int rows, int inner, int width, int columns, const double *D, const double *S, double *W) {
    for (int i = 0; i < rows; ++i) {
        int k = 0;
        for (; k + 4 <= inner; k += 4)
            em_add_four(columns, D + i * width + k, S + k * columns, columns, W + i * columns);
        for (; k < inner; ++k) em_add_to(columns, D[i * width + k], S + k * columns, W + i * columns);
    }
}

/* G at a node: what does not hang on K. */
EM_INLINE void em_node_directions(em_pass *p, int j, double h) {
    const int n = p->n, k = p->columns, block = n * k, width = p->of->model->n_arguments;
    const double *const J = p->J + j * n * width;
    double *const G = p->G + j * block;
    memcpy(p->Y, p->S, (size_t)block * sizeof *p->Y);
    em_add_to(block, p->of->place[j] * h, p->S + block, p->Y);
    memset(G, 0, (size_t)block * sizeof *G);
    em_add_product(n, n, width, k, J, p->Y, G);
    em_add_product(n, n, width, k, J + n, p->S + block, G);
    for (const int(*at)[2] = p->places; at < p->places + p->n_places; ++at) {
        const double given = p->P[(*at)[0] * k + (*at)[1]];
        for (int q = 0; q < n; ++q) G[q * k + (*at)[1]] += J[q * width + 2 * n + (*at)[0]] * given;
    }
}

EM_WIDE static void em_node_wide(em_pass *p, int j, double h) { em_node_directions(p, j, h); }
static void em_node_narrow(em_pass *p, int j, double h) { em_node_directions(p, j, h); }

/* J at the nodes of a step, and all that does not hang on K: G. */
static int em_variation_nodes(em_pass *p, size_t step) {
    em_variations *const w = p->of;
    const int n = p->n, width = w->model->n_arguments;
    const double h = w->to[step] - w->from[step];
    for (int j = 0; j < EM_VARIATION_NODES; ++j) {
        const double t = j + 1 < EM_VARIATION_NODES ? w->from[step] + w->place[j] * h : w->to[step];
        const double *const z = w->nodes + (step * EM_VARIATION_NODES + j) * 2 * n;
        em_pass_inputs(p, t);
        if (w->model->motion_derivatives(em_pass_clock(p, t), z, z + n, p->c, p->u, w->least_norm, p->a, p->lambda, p->J + j * n * width,
                                         p->dlambda, &w->fault)) return -1;
        (p->wide ? em_node_wide : em_node_narrow)(p, j, h);
    }
    return 0;
}

/* K <- by elimination, of unknowns and equations in the order of coordinates, and then nodes. 0, or -1: singular. */
EM_INLINE int em_solve_nodes(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n, size = NODES * n, k = p->columns, width = p->of->model->n_arguments;
    for (int row = 0; row < n; ++row)
        for (int i = 0; i < NODES; ++i) {
            const double *const J = p->J + (i * n + row) * width;
            const double *const A = p->of->A + i * NODES, *const A2 = p->of->A2 + i * NODES;
            double *const at = p->rows[row * NODES + i] = p->L + (row * NODES + i) * (size + k);
            for (int q = 0; q < n; ++q) {
                const double by_x = -h * h * J[q], by_v = -h * J[n + q];
                for (int j = 0; j < NODES; ++j) at[q * NODES + j] = by_x * A2[j] + by_v * A[j];
            }
            at[row * NODES + i] += 1.0;
            memcpy(at + size, p->G + (i * n + row) * k, k * sizeof *at);
        }
    if (em_eliminate(size, k, p->rows)) return -1;
    for (int i = 0; i < size; ++i)
        memcpy(p->K + (i % NODES * n + i / NODES) * k, p->rows[i] + size, k * sizeof *p->K);
    return 0;
}

/* K <- by iteration from G. 0, or -1: does not converge. */
EM_INLINE int em_iterate_nodes(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES, MOST = 25 };
    const int n = p->n, k = p->columns, block = n * k, width = p->of->model->n_arguments;
    double before = INFINITY;
    memcpy(p->K, p->G, (size_t)NODES * block * sizeof *p->K);
    for (int round = 0; round < MOST; ++round) {
        double change = 0.0, size = 0.0;
        memcpy(p->W, p->G, (size_t)NODES * block * sizeof *p->W);
        for (int i = 0; i < NODES; ++i) {
            memset(p->Y, 0, 2 * (size_t)block * sizeof *p->Y);
            for (int j = 0; j < NODES; ++j) {
                em_add_to(block, h * h * p->of->A2[i * NODES + j], p->K + j * block, p->Y);
                em_add_to(block, h * p->of->A[i * NODES + j], p->K + j * block, p->Y + block);
            }
            em_add_product(n, 2 * n, width, k, p->J + i * n * width, p->Y, p->W + i * block);
        }
        for (int i = 0; i < NODES * block; ++i) {
            change = fmax(change, fabs(p->W[i] - p->K[i])), size = fmax(size, fabs(p->W[i]));
            p->K[i] = p->W[i];
        }
        if (change <= 1e-15 * size) return 0;
        if (!(change < 0.5 * before) && round > 1) return change <= 1e-13 * size ? 0 : -1;
        before = change;
    }
    return -1;
}

/* How far the witness is off (v, a) at the end of a step, relative to the largest acceleration; and it is one again. */
static double em_check_witness(em_pass *p, double h, const double *z) {
    const int n = p->n, k = p->columns;
    double apart = 0.0, size = 0.0;
    for (int i = 0; i < n; ++i) size = fmax(size, EM_UNIFORM * fabs(z[n + i] / h));
    for (int i = 0; i < n; ++i) {
        const double witness = p->S[(n + i) * k + k - 1];
        apart = fmax(apart, fabs(witness - p->a[i]));
        size = fmax(size, fmax(fabs(witness), fabs(p->a[i])));
    }
    for (int i = 0; i < n; ++i) p->S[i * k + k - 1] = z[n + i], p->S[(n + i) * k + k - 1] = p->a[i];
    return apart > 0.0 ? apart / size : 0.0;
}

/* K, and S at the end of a step. 0, or -1: singular. */
EM_INLINE int em_step_directions(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES };
    const int block = p->n * p->columns;
    const double *const A = p->of->A + (NODES - 1) * NODES, *const A2 = p->of->A2 + (NODES - 1) * NODES;
    const int iterated = NODES * p->n > EM_BY_ELIMINATION && em_iterate_nodes(p, h) == 0;
    if (!iterated && em_solve_nodes(p, h)) return -1;
    em_add_to(block, h, p->S + block, p->S);
    for (int j = 0; j < NODES; j += 4) {
        const double once[4] = {h * A[j], h * A[j + 1], h * A[j + 2], h * A[j + 3]};
        const double twice[4] = {h * h * A2[j], h * h * A2[j + 1], h * h * A2[j + 2], h * h * A2[j + 3]};
        em_add_four(block, twice, p->K + j * block, block, p->S);
        em_add_four(block, once, p->K + j * block, block, p->S + block);
    }
    return 0;
}

EM_WIDE static int em_step_wide(em_pass *p, double h) { return em_step_directions(p, h); }
static int em_step_narrow(em_pass *p, double h) { return em_step_directions(p, h); }

/* What rows of a step follow from: S where it begins, and K. */
static void em_keep_step(const em_pass *p, size_t step, const double *from, int count, double *to) {
    const int asked = p->of->columns;
    for (int i = 0; i < count && to; ++i)
        memcpy(to + (step * count + i) * asked, from + i * p->columns, asked * sizeof *to);
}

static int em_is_finite(size_t count, const double *a) {
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(a[i])) return 0;
    return 1;
}

/* S <- at the end of a step. */
static int em_variation_step(em_pass *p, size_t step) {
    em_variations *const w = p->of;
    const int n = p->n;
    const double h = w->to[step] - w->from[step];
    const double *const z = w->nodes + (step * EM_VARIATION_NODES + EM_VARIATION_NODES - 1) * 2 * n;
    if (em_pass_pieces(p, w->from[step])) {
        double rate[2 * n];
        if (em_motion_rate(p, w->from[step], p->z, rate)) return -1;
        em_set_witness(p, rate);
    }
    if (em_pass_breaks(p, w->from[step], w->to[step], step == 0)) return -1;
    if (em_variation_nodes(p, step)) return -1;
    em_keep_step(p, step, p->S, 2 * n, w->S_from);
    if ((p->wide ? em_step_wide : em_step_narrow)(p, h)) return em_fail(&w->fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    em_keep_step(p, step, p->K, EM_VARIATION_NODES * n, w->K);
    w->t_reached = w->to[step];
    w->apart[step] = em_check_witness(p, h, z);
    memcpy(p->z, z, 2 * n * sizeof *z);
    if (!em_is_finite((size_t)2 * n * p->columns, p->S)) return em_fail(&w->fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    if (!w->stabilise || !w->model->m) return 0;
    return w->model->tangent(em_pass_clock(p, w->to[step]), z, z + n, p->c, w->least_norm, p->columns, p->S, p->P, &w->fault);
}

#endif
