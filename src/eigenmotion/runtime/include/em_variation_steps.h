/* em_variation_steps.h: steps of the equations of variation, along a motion that is known within them.
 *
 * They are linear: S_v' = J_x S_x + J_v S_v + F, S_x' = S_v, with J and F at the nodes of a step by Radau IIA. So a step is
 * one linear system for K = S_v' at all nodes, of all directions, (I - h^2 A^2 J_x - h A J_v) K = J_x (S_x + c h S_v) +
 * J_v S_v + F: by elimination, or by iteration where it is large and that converges. */
#ifndef EM_VARIATION_STEPS_H
#define EM_VARIATION_STEPS_H

#include <stdlib.h>

#include "em_signals.h"

#define EM_UNIFORM 1e-9 /* of what would stop it in a step: accelerations of a motion that are rounding */

/* What ends a pass but faults of the model. */
enum { EM_BY_FAULT, EM_EVENTS_MEET, EM_EVENT_GRAZES, EM_OTHER_MOTION };

enum { EM_VARIATION_NODES = 8, EM_BY_ELIMINATION = 64 /* unknowns of a direction up to which that takes less */ };

/* Stops are the start, events, and the end: t, z (n_stops, 2 n) = x, v; where what happens at one acts, the next is what
 * comes of it. Between two of them lie `steps`, each from `from` to `to`, with z at its nodes. Marks are events, in the
 * order of their stops. P (n_given, columns). */
typedef struct em_variations {
    const em_model *model;
    const double *c; /* of the first stop */
    const em_signal *inputs;
    int columns, least_norm, stabilise, n_given;
    double direction;
    size_t n_stops, n_marks, n_steps;
    const double *t, *z, *P;
    const long *steps, *mark_stop;
    const int *mark_event;
    const double *from, *to, *nodes;       /* (n_steps), (n_steps), (n_steps, EM_VARIATION_NODES, 2 n) */
    const double *place, *A, *A2;          /* of the nodes in a step; A, and its square */
    double *S, *dt;                        /* (n_stops, 2 n, columns), row 0 given; (n_marks, columns): of times of events */
    double *S_from, *K, *apart;            /* (n_steps, 2 n, columns), (n_steps, nodes, n, columns), and how far the witness is off */
    int (*poll)(void *);
    void *poll_argument;
    em_fault fault;
    int why;
    double t_reached;
} em_variations;

/* What a pass works with: S (2 n, columns) of directions, the last the witness; z where it is; J (n, n_arguments) at each
 * node, the linear system L (nodes n) and its right-hand sides K; Y of sums. */
typedef struct em_pass {
    em_variations *of;
    int n, m, columns; /* of directions, the witness counted */
    double *S, *z, *P, *u, *a, *lambda, *dlambda, *c, *J, *L, *K, *G, *Y, *W;
    em_pile *pile;
    long *piece;
} em_pass;

static int em_end_pass(em_variations *w, int why, int first, int second) {
    w->why = why;
    return em_fail(&w->fault, EM_NON_FINITE_STATE, first, second, NAN);
}

static double em_signal_rate(const em_signal *u, long piece, double t) {
    const long last = (long)u->count - 1;
    if (u->kind == EM_LINEAR && piece >= 0 && piece < last)
        return (u->values[piece + 1] - u->values[piece]) / (u->times[piece + 1] - u->times[piece]);
    if (u->kind != EM_CUBIC || t < u->times[0] || t > u->times[last]) return 0.0;
    long at = em_signal_piece(u, t, 1.0);
    if (at > last - 1) at = last - 1;
    const double *b = u->values + 4 * at, x = t - u->times[at];
    return (3.0 * b[0] * x + 2.0 * b[1]) * x + b[2];
}

/* The inputs at t, and their rates, with which the witness goes. */
static void em_pass_inputs(em_pass *p, double t) {
    for (int i = 0; i < p->of->model->n_inputs; ++i) {
        p->u[i] = em_signal_at(&p->of->inputs[i], p->piece[i], t);
        p->P[i * p->columns + p->columns - 1] = em_signal_rate(&p->of->inputs[i], p->piece[i], t);
    }
}

/* The pieces of inputs that hold after t. Returns whether others did before. */
static int em_pass_pieces(em_pass *p, double t) {
    int other = 0;
    for (int i = 0; i < p->of->model->n_inputs; ++i) {
        const long piece = em_signal_piece(&p->of->inputs[i], t, p->of->direction);
        other |= piece != p->piece[i];
        p->piece[i] = piece;
    }
    return other;
}

/* rate (2 n) <- (v, a) at z. */
static int em_motion_rate(em_pass *p, double t, const double *z, double *rate) {
    em_variations *const w = p->of;
    em_pass_inputs(p, t);
    memcpy(rate, z + p->n, p->n * sizeof *rate);
    return w->model->acceleration(t, z, z + p->n, p->c, p->u, w->least_norm, rate + p->n, p->lambda, &w->fault);
}

/* The witness <- rates (2 n) of z. */
static void em_set_witness(em_pass *p, const double *rate) {
    for (int i = 0; i < 2 * p->n; ++i) p->S[i * p->columns + p->columns - 1] = rate[i];
}

/* to (columns) += factor from */
static inline void em_add_to(int columns, double factor, const double *restrict from, double *restrict to) {
    for (int j = 0; j < columns; ++j) to[j] += factor * from[j];
}

/* W (rows, columns) += D (rows, inner; `width` apart) S (inner, columns) */
static void em_add_product(int rows, int inner, int width, int columns, const double *D, const double *S, double *W) {
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < inner; ++k)
            if (D[i * width + k] != 0.0) em_add_to(columns, D[i * width + k], S + k * columns, W + i * columns);
}

/* J at node j of a step, and G there: all that does not hang on K. */
static int em_variation_node(em_pass *p, size_t step, int j) {
    em_variations *const w = p->of;
    const int n = p->n, k = p->columns, width = w->model->n_arguments;
    const double h = w->to[step] - w->from[step], t = j + 1 < EM_VARIATION_NODES ? w->from[step] + w->place[j] * h : w->to[step];
    const double *const z = w->nodes + (step * EM_VARIATION_NODES + j) * 2 * n;
    double *const J = p->J + j * n * width, *const G = p->G + j * n * k;
    em_pass_inputs(p, t);
    if (w->model->motion_derivatives(t, z, z + n, p->c, p->u, w->least_norm, p->a, p->lambda, J, p->dlambda, &w->fault))
        return -1;
    memcpy(p->Y, p->S, (size_t)n * k * sizeof *p->Y);
    em_add_to(n * k, w->place[j] * h, p->S + n * k, p->Y);
    memset(G, 0, (size_t)n * k * sizeof *G);
    em_add_product(n, n, width, k, J, p->Y, G);
    em_add_product(n, n, width, k, J + n, p->S + n * k, G);
    em_add_product(n, w->n_given, width, k, J + 2 * n, p->P, G);
    return 0;
}

/* K <- L^-1 K by elimination, rows of the largest pivot first. 0, or -1: singular. */
static int em_eliminate_all(int size, int columns, double *L, double *K) {
    for (int i = 0; i < size; ++i) {
        int best = i;
        for (int r = i + 1; r < size; ++r)
            if (fabs(L[r * size + i]) > fabs(L[best * size + i])) best = r;
        if (!(fabs(L[best * size + i]) > 0.0)) return -1;
        for (int j = i; j < size && best != i; ++j) {
            const double kept = L[best * size + j];
            L[best * size + j] = L[i * size + j], L[i * size + j] = kept;
        }
        for (int j = 0; j < columns && best != i; ++j) {
            const double kept = K[best * columns + j];
            K[best * columns + j] = K[i * columns + j], K[i * columns + j] = kept;
        }
        for (int r = i + 1; r < size; ++r) {
            const double part = L[r * size + i] / L[i * size + i];
            if (part == 0.0) continue;
            em_add_to(size - i - 1, -part, L + i * size + i + 1, L + r * size + i + 1);
            em_add_to(columns, -part, K + i * columns, K + r * columns);
        }
    }
    for (int i = size - 1; i >= 0; --i) {
        for (int r = i + 1; r < size; ++r) em_add_to(columns, -L[i * size + r], K + r * columns, K + i * columns);
        for (int j = 0; j < columns; ++j) K[i * columns + j] /= L[i * size + i];
    }
    return 0;
}

static int em_solve_nodes(em_pass *p, double h) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n, size = NODES * n, width = p->of->model->n_arguments;
    for (int i = 0; i < NODES; ++i)
        for (int row = 0; row < n; ++row)
            for (int j = 0; j < NODES; ++j) {
                const double by_x = -h * h * p->of->A2[i * NODES + j], by_v = -h * p->of->A[i * NODES + j];
                const double *const J = p->J + (i * n + row) * width;
                double *const at = p->L + (i * n + row) * size + j * n;
                for (int q = 0; q < n; ++q) at[q] = by_x * J[q] + by_v * J[n + q] + (i == j && row == q);
            }
    memcpy(p->K, p->G, (size_t)size * p->columns * sizeof *p->K);
    return em_eliminate_all(size, p->columns, p->L, p->K);
}

/* K <- by iteration from G. 0, or -1: does not converge. */
static int em_iterate_nodes(em_pass *p, double h) {
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

/* S <- at the end of a step. */
static int em_variation_step(em_pass *p, size_t step) {
    enum { NODES = EM_VARIATION_NODES };
    em_variations *const w = p->of;
    const int n = p->n, k = p->columns, block = n * k;
    const double h = w->to[step] - w->from[step];
    const double *const z = w->nodes + (step * NODES + NODES - 1) * 2 * n;
    if (em_pass_pieces(p, w->from[step])) {
        double rate[2 * n];
        if (em_motion_rate(p, w->from[step], p->z, rate)) return -1;
        em_set_witness(p, rate);
    }
    for (int j = 0; j < NODES; ++j)
        if (em_variation_node(p, step, j)) return -1;
    const int iterated = NODES * n > EM_BY_ELIMINATION && em_iterate_nodes(p, h) == 0;
    if (!iterated && em_solve_nodes(p, h)) return em_fail(&w->fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    for (int i = 0; i < 2 * n; ++i) memcpy(w->S_from + (step * 2 * n + i) * (k - 1), p->S + i * k, (k - 1) * sizeof *p->S);
    for (int i = 0; i < NODES * n; ++i) memcpy(w->K + (step * NODES * n + i) * (k - 1), p->K + i * k, (k - 1) * sizeof *p->K);
    em_add_to(block, h, p->S + block, p->S);
    for (int j = 0; j < NODES; ++j) {
        em_add_to(block, h * h * w->A2[(NODES - 1) * NODES + j], p->K + j * block, p->S);
        em_add_to(block, h * w->A[(NODES - 1) * NODES + j], p->K + j * block, p->S + block);
    }
    w->t_reached = w->to[step];
    w->apart[step] = em_check_witness(p, h, z);
    memcpy(p->z, z, 2 * n * sizeof *z);
    for (int i = 0; i < 2 * block; ++i)
        if (!isfinite(p->S[i])) return em_fail(&w->fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    if (!w->stabilise || !w->model->m) return 0;
    return w->model->tangent(w->to[step], z, z + n, p->c, w->least_norm, k, p->S, p->P, &w->fault);
}

#endif
