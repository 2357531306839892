/* em_variation_steps.h: a step of the variational equations, along a motion that is known within it.
 *
 * They are linear: S_v' = J_x S_x + J_v S_v + F, S_x' = S_v, with J and F at the nodes of a step by Radau IIA. So a
 * step is one linear system for K = S_v' at all nodes, of all directions, (I - h^2 A^2 J_x - h A J_v) K = J_x (S_x +
 * c h S_v) + J_v S_v + F. It is solved by elimination, or by iteration if it is large and the iteration converges. The
 * last direction starts from zero, and has -J off in place of F: its K is the Newton correction of the motion's own
 * accelerations. */
#ifndef EM_VARIATION_STEPS_H
#define EM_VARIATION_STEPS_H

#include "numeric/em_packs.h"
#include "sensitivity/em_variation_motion.h"

#define EM_BALANCED 4096.0 /* the ratio of two dependences up to which they are left as they are */

/* W (rows, columns) += D (rows, inner; `width` apart) S (inner, columns) */
EM_INLINE void em_add_jacobian_product(int rows, int inner, int width, int columns, const double *D, const double *S, double *W) {
    for (int i = 0; i < rows; ++i) em_sum_rows(columns, inner, 1.0, D + i * width, 1, S, 1.0, W + i * columns);
}

/* to (n, columns) += F, the effect of P. One product if much of P is not zero, as in random directions. */
EM_INLINE void em_add_forcing(const em_pass *p, const double *J, double *to) {
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments, rows = p->of->n_forcing;
    if (2 * p->n_nonzeros > rows * (k / 4)) {
        double last[n];
        for (int i = 0; i < n; ++i) last[i] = to[i * k + k - 1];
        em_add_jacobian_product(n, rows, width, k, J + 2 * n, p->P, to);
        for (int i = 0; i < n; ++i) to[i * k + k - 1] = last[i];
        return;
    }
    for (const int(*at)[2] = p->nonzeros; at < p->nonzeros + p->n_nonzeros; ++at) {
        const double forcing = p->P[(*at)[0] * k + (*at)[1]];
        for (int q = 0; q < n; ++q) to[q * k + (*at)[1]] += J[q * width + 2 * n + (*at)[0]] * forcing;
    }
}

/* to (n, columns) <- J S + F; the last direction has no F. */
EM_INLINE void em_rates_of(const em_pass *p, const double *J, const double *S, double *to) {
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments;
    memset(to, 0, (size_t)n * k * sizeof *to);
    em_add_jacobian_product(n, 2 * n, width, k, J, S, to);
    em_add_forcing(p, J, to);
}

/* to (n, columns) += the rates of the rest of directions that follow from shifts, where J, drive, v, a are these. */
EM_INLINE void em_add_rates_of_shifts(const em_pass *p, const double *J, const double *drive, const double *v, const double *a,
                                      double *to) {
    const int n = p->n, k = p->columns, width = p->of->model->n_arguments;
    for (int i = 0; i < n; ++i) {
        em_add_to(k, -drive[i], p->shift + i * k, to + i * k);
        for (int q = 0; p->apart && q < n; ++q) {
            const double by = J[i * width + q] * v[q] + J[i * width + n + q] * a[q];
            for (int j = 0; j < k; ++j) to[i * k + j] += by * (p->shift[q * k + j] - p->shift[i * k + j]);
        }
    }
}

/* G at the nodes: the part that does not depend on K. */
EM_INLINE void em_node_directions(em_pass *p, double h) {
    const int n = p->n, k = p->columns, block = n * k, width = p->of->model->n_arguments, shifted = em_has_shifts(p);
    for (int j = 0; j < EM_VARIATION_NODES; ++j) {
        memcpy(p->Y, p->S0, 2 * (size_t)block * sizeof *p->Y);
        em_add_to(block, p->of->place[j] * h, p->S0 + block, p->Y);
        for (int i = 0; i < 2 * n; ++i) p->Y[i * k + k - 1] = -p->off[j * 2 * n + i];
        em_rates_of(p, p->J + j * n * width, p->Y, p->G + j * block);
        if (shifted)
            em_add_rates_of_shifts(p, p->J + j * n * width, p->drive + j * n, p->Z + j * 2 * n + n, p->a + j * n, p->G + j * block);
    }
}

/* B <- the size of the terms of the linear system of a step that couple coordinates. */
EM_INLINE void em_couplings(em_pass *p, double h) {
    double *const B = p->B;
    const int n = p->n, width = p->of->model->n_arguments;
    memset(B, 0, (size_t)n * n * sizeof *B);
    for (int j = 0; j < EM_VARIATION_NODES; ++j)
        for (int i = 0; i < n; ++i) {
            const double *const J = p->J + (j * n + i) * width;
            for (int q = 0; q < n; ++q) B[i * n + q] = em_max(B[i * n + q], h * h * fabs(J[q]) + fabs(h * J[n + q]));
        }
}

/* units <- powers of two, in which each coordinate depends on others about as much as others on it (Osborne, J. ACM
 * 7 (1960) 338): pivots are compared in these, so that the user's units do not matter. */
EM_INLINE void em_balance_step(em_pass *p, double h) {
    enum { MOST = 20 };
    const int n = p->n;
    const double *const B = p->B;
    double *const units = p->units;
    em_couplings(p, h);
    for (int i = 0; i < n; ++i) units[i] = 1.0;
    for (int round = 0, changes = 1; changes && round < MOST; ++round) {
        changes = 0;
        for (int i = 0; i < n; ++i) {
            double on = 0.0, by = 0.0;
            for (int q = 0; q < n; ++q) {
                if (q == i) continue;
                on = em_max(on, B[i * n + q] * units[q]), by = em_max(by, B[q * n + i] / units[q]);
            }
            if (on == 0.0 && by == 0.0) continue;
            const double ratio = (on > 0.0 ? on / units[i] : 1.0) / (by > 0.0 ? by * units[i] : 1.0);
            if (!(ratio > 0.0 && ratio < INFINITY) || (ratio < EM_BALANCED && ratio * EM_BALANCED > 1.0)) continue;
            units[i] = ldexp(units[i], (int)lrint(0.5 * log2(ratio))), ++changes;
        }
    }
}

/* K <- by elimination, with unknowns and equations ordered by coordinates, and then nodes. 0, or -1: singular. */
EM_INLINE int em_solve_collocation(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n, size = NODES * n, k = p->columns, width = p->of->model->n_arguments;
    const double *const d = p->units;
    em_balance_step(p, h);
    for (int row = 0; row < n; ++row)
        for (int i = 0; i < NODES; ++i) {
            const double *const J = p->J + (i * n + row) * width;
            double A[NODES], A2[NODES];
            memcpy(A, p->of->A + i * NODES, sizeof A), memcpy(A2, p->of->A2 + i * NODES, sizeof A2);
            double *restrict const at = p->rows[row * NODES + i] = p->L + (row * NODES + i) * (size + k);
            for (int q = 0; q < n; ++q) {
                const double by = d[q] / d[row], by_x = -h * h * J[q] * by, by_v = -h * J[n + q] * by;
                for (int j = 0; j < NODES; ++j) at[q * NODES + j] = by_x * A2[j] + by_v * A[j];
            }
            at[row * NODES + i] += 1.0;
            for (int j = 0; j < k; ++j) at[size + j] = p->G[(i * n + row) * k + j] / d[row];
        }
    if (em_eliminate(size, k, p->rows)) return -1;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < k; ++j) p->K[(i % NODES * n + i / NODES) * k + j] = p->rows[i][size + j] * d[i / NODES];
    return 0;
}

/* The largest change from K to W of a direction, relative to its size; K <- W. */
EM_INLINE double em_largest_change(em_pass *p, int rows) {
    const int k = p->columns;
    double change[k], size[k], most = 0.0;
    memset(change, 0, sizeof change), memset(size, 0, sizeof size);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < k; ++j) {
            const double now = p->W[i * k + j];
            change[j] = fmax(change[j], fabs(now - p->K[i * k + j])), size[j] = fmax(size[j], fabs(now));
            p->K[i * k + j] = now;
        }
    for (int j = 0; j < p->of->columns; ++j)
        if (change[j] > 0.0) most = fmax(most, change[j] / size[j]);
    return most;
}

/* K <- by iteration from G. 0, or -1: does not converge. */
EM_INLINE int em_iterate_nodes(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES, MOST = 25 };
    const int n = p->n, k = p->columns, block = n * k, width = p->of->model->n_arguments;
    double before = INFINITY;
    memcpy(p->K, p->G, (size_t)NODES * block * sizeof *p->K);
    for (int round = 0; round < MOST; ++round) {
        memcpy(p->W, p->G, (size_t)NODES * block * sizeof *p->W);
        for (int i = 0; i < NODES; ++i) {
            memset(p->Y, 0, 2 * (size_t)block * sizeof *p->Y);
            for (int j = 0; j < NODES; ++j) {
                em_add_to(block, h * h * p->of->A2[i * NODES + j], p->K + j * block, p->Y);
                em_add_to(block, h * p->of->A[i * NODES + j], p->K + j * block, p->Y + block);
            }
            em_add_jacobian_product(n, 2 * n, width, k, p->J + i * n * width, p->Y, p->W + i * block);
        }
        const double change = em_largest_change(p, NODES * n);
        if (change <= 1e-15) return 0;
        if (!(change < 0.5 * before) && round > 1) return change <= 1e-13 ? 0 : -1;
        before = change;
    }
    return -1;
}

/* K, of a step that begins with S0, and S at its end. 0, or -1: singular. */
EM_INLINE int em_step_directions(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES };
    const int block = p->n * p->columns;
    const double *const A = p->of->A + (NODES - 1) * NODES, *const A2 = p->of->A2 + (NODES - 1) * NODES;
    em_node_directions(p, h);
    const int iterated = !p->tape && NODES * p->n > EM_BY_ELIMINATION && em_iterate_nodes(p, h) == 0;
    if (!iterated && em_solve_collocation(p, h)) return -1;
    memcpy(p->S, p->S0, 2 * (size_t)block * sizeof *p->S);
    em_add_to(block, h, p->S + block, p->S);
    for (int j = 0; j < NODES; j += 4) {
        const double once[4] = {h * A[j], h * A[j + 1], h * A[j + 2], h * A[j + 3]};
        const double twice[4] = {h * h * A2[j], h * h * A2[j + 1], h * h * A2[j + 2], h * h * A2[j + 3]};
        em_add_four(block, twice, p->K + j * block, block, p->S);
        em_add_four(block, once, p->K + j * block, block, p->S + block);
    }
    return 0;
}

#endif
