/* em_variation_steps.h: steps of the equations of variation between two rows of a run. */
#ifndef EM_VARIATION_STEPS_H
#define EM_VARIATION_STEPS_H

#include <stdlib.h>

#include "em_signals.h"
#include "em_tableaux.h"

#define EM_JUMP 1e-3  /* of an acceleration, relative to what it was: a force has jumped */
#define EM_UNIFORM 1e-9 /* of what would stop it in a step: accelerations of a motion that are rounding */

/* What ends a pass but faults of the model. */
enum { EM_BY_FAULT, EM_FORCE_JUMPS, EM_EVENTS_MEET, EM_EVENT_GRAZES, EM_OTHER_MOTION };

/* t, z (n_rows): rows of a run, z (2 n) = x, v. S (n_rows, 2 n, columns): row 0 is given. P (n_given, columns).
 * Marks are events that happen at rows, in their order; where some act, the next row is what they make of that one. */
typedef struct em_variations {
    const em_model *model;
    const double *c; /* of the first row */
    const em_signal *inputs;
    int columns, least_norm, stabilise, n_given;
    double rtol;
    const double *atol, *size; /* (n), and (columns), how large what is differentiated by is itself */
    long max_steps;
    size_t n_rows, n_marks;
    const double *t, *z, *P;
    const long *mark_row; /* (n_marks) */
    const int *mark_event;
    double *S, *dt; /* dt (n_marks, columns): how the times of events change */
    int (*poll)(void *);
    void *poll_argument;
    em_fault fault;
    int why;
    double t_reached;
    long n_rhs, n_steps;
} em_variations;

/* What a pass works with: y (2 n + 2 n (columns + 1)): x, v, and directions, the last the witness. */
typedef struct em_pass {
    em_variations *of;
    int n, m, columns, size, renew; /* renew: the witness is none any more */
    double direction, *y, *next, *P, *u, *W, *a, *lambda, *c, *K[EM_STAGES];
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

static int em_variation_rate(em_pass *p, double t, const double *y, double *dy) {
    em_variations *const w = p->of;
    const int n = p->n, k = p->columns, n_inputs = w->model->n_inputs;
    const double *const S = y + 2 * n;
    for (int i = 0; i < n_inputs; ++i) {
        p->u[i] = em_signal_at(&w->inputs[i], p->piece[i], t);
        p->P[i * k + k - 1] = em_signal_rate(&w->inputs[i], p->piece[i], t);
    }
    ++w->n_rhs;
    if (w->model->motion_along(t, y, y + n, p->c, p->u, w->least_norm, k, S, p->P, p->a, p->lambda, p->W, &w->fault))
        return -1;
    memcpy(dy, y + n, n * sizeof *dy);
    memcpy(dy + n, p->a, n * sizeof *dy);
    memcpy(dy + 2 * n, S + n * k, (size_t)n * k * sizeof *dy);
    memcpy(dy + 2 * n + n * k, p->W, (size_t)n * k * sizeof *dy);
    return 0;
}

/* The error beside the tolerances: of a direction relative to itself, or to a hundredth of the largest of its kind, and
 * what the absolute tolerance of a coordinate is for a change as large as what is differentiated by. */
static double em_variation_error(const em_pass *p, double h) {
    const em_tableau *const T = &EM_DOP853_TABLEAU;
    const int n = p->n, k = p->columns;
    double fifth = 0.0, third = 0.0;
    long count = 0;
    for (int part = 0; part < 2; ++part)
        for (int column = -1; column < k; ++column) {
            const int start = column < 0 ? part * n : 2 * n + part * n * k + column, stride = column < 0 ? 1 : k;
            double largest = 0.0;
            for (int i = 0; i < n; ++i) {
                const int at = start + i * stride;
                largest = fmax(largest, fmax(fabs(p->y[at]), fabs(p->next[at])));
            }
            for (int i = 0; i < n; ++i, ++count) {
                const int at = start + i * stride;
                const double size = fmax(fmax(fabs(p->y[at]), fabs(p->next[at])), 0.01 * largest);
                double e[2] = {0.0, 0.0};
                for (int stage = 0; stage < T->stages; ++stage)
                    for (int row = 0; row < 2; ++row) e[row] += T->e[row][stage] * p->K[stage][at];
                const double least = p->of->atol[i] / (column < 0 || column + 1 == k ? 1.0 : p->of->size[column]);
                const double weight = 1.0 / (p->of->rtol * size + least + DBL_MIN);
                fifth += e[0] * weight * (e[0] * weight), third += e[1] * weight * (e[1] * weight);
            }
        }
    const double both = fifth + 0.01 * third;
    return both > 0.0 ? fabs(h) * fifth / sqrt(both * count) : 0.0;
}

/* next <- y after a step; its error, or infinity where there is none. */
static double em_variation_step(em_pass *p, double t, double h) {
    const em_tableau *const T = &EM_DOP853_TABLEAU;
    for (int stage = 1; stage <= T->stages; ++stage) {
        memcpy(p->next, p->y, p->size * sizeof *p->next);
        for (int j = 0; j < stage; ++j) {
            const double factor = h * T->a[stage][j];
            if (factor != 0.0)
                for (int i = 0; i < p->size; ++i) p->next[i] += factor * p->K[j][i];
        }
        if (stage < T->stages && em_variation_rate(p, t + T->c[stage] * h, p->next, p->K[stage])) return INFINITY;
    }
    const double error = em_variation_error(p, h);
    return isfinite(error) ? error : INFINITY;
}

/* The witness <- (v, a), of which K_0 knows a. */
static void em_renew_witness(em_pass *p) {
    const int n = p->n, k = p->columns;
    for (int i = 0; i < 2 * n; ++i) {
        p->y[2 * n + i * k + k - 1] = p->K[0][i];
    }
}

/* Whether a force has jumped: the witness is not (v, a), relative to the largest acceleration. */
static int em_has_jumped(const em_pass *p, const double *rate, double h) {
    const int n = p->n, k = p->columns;
    double apart = 0.0, size = 0.0;
    for (int i = 0; i < n; ++i) size = fmax(size, EM_UNIFORM * fabs(rate[i] / h));
    for (int i = n; i < 2 * n; ++i) {
        const double witness = p->y[2 * n + i * k + k - 1];
        apart = fmax(apart, fabs(witness - rate[i]));
        size = fmax(size, fmax(fabs(witness), fabs(rate[i])));
    }
    return !(apart <= EM_JUMP * size);
}

/* K_0 <- the rate at y, with the pieces of inputs that begin there, and a witness of its own where they are others. */
static int em_begin_piece(em_pass *p, double t) {
    int other = p->renew;
    for (int i = 0; i < p->of->model->n_inputs; ++i) {
        const long piece = em_signal_piece(&p->of->inputs[i], t, p->direction);
        other |= piece != p->piece[i];
        p->piece[i] = piece;
    }
    p->renew = 0;
    if (em_variation_rate(p, t, p->y, p->K[0])) return -1;
    if (!other) return 0;
    em_renew_witness(p);
    return em_variation_rate(p, t, p->y, p->K[0]);
}

static double em_piece_end(const em_pass *p, double end) {
    for (int i = 0; i < p->of->model->n_inputs; ++i) {
        const double next = em_signal_end(&p->of->inputs[i], p->piece[i], p->direction, 0);
        if (p->direction * (next - end) < 0.0) end = next;
    }
    return end;
}

/* From t to `end`, with steps about *h long. */
static int em_variation_leg(em_pass *p, double t, double end, double *h) {
    em_variations *const w = p->of;
    while (t != end) {
        if (em_begin_piece(p, t)) return -1;
        const double stop = em_piece_end(p, end);
        while (t != stop) {
            const int last = fabs(*h) >= fabs(stop - t) * (1.0 - 1e-9);
            const double step = last ? stop - t : *h, error = em_variation_step(p, t, step);
            const double factor = error > 0.0 ? 0.9 * pow(error, -0.125) : 6.0;
            if (++w->n_steps > w->max_steps) return em_fail(&w->fault, EM_TOO_MANY_STEPS, -1, -1, 0.0);
            if (w->poll && w->n_steps % 64 == 0 && w->poll(w->poll_argument))
                return em_fail(&w->fault, EM_INTERRUPTED, -1, -1, 0.0);
            if (!(error <= 1.0)) {
                *h = step * fmax(0.2, fmin(factor, 0.9));
                if (!(fabs(*h) > 16.0 * DBL_EPSILON * fabs(t)) || *h == 0.0)
                    return em_fail(&w->fault, w->fault.status ? w->fault.status : EM_STEP_SIZE_UNDERFLOW, -1, -1, 0.0);
                continue;
            }
            t = last ? stop : t + step;
            w->t_reached = t;
            if (!last || fabs(*h) < 6.0 * fabs(step)) *h = fmax(fabs(*h), fabs(step)) * fmin(factor, 6.0) * p->direction;
            memcpy(p->y, p->next, p->size * sizeof *p->y);
            if (w->stabilise && w->model->m) {
                if (w->model->project(t, p->y, p->y + p->n, p->c, w->least_norm, &w->fault) < 0) return -1;
                if (w->model->tangent(t, p->y, p->y + p->n, p->c, w->least_norm, p->columns, p->y + 2 * p->n, p->P,
                                      &w->fault)) return -1;
            }
            if (em_variation_rate(p, t, p->y, p->K[0])) return -1;
            if (em_has_jumped(p, p->K[0], step)) return em_end_pass(w, EM_FORCE_JUMPS, -1, -1);
        }
    }
    return 0;
}

#endif
