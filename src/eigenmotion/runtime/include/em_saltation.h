/* em_saltation.h: what becomes of directions where events act.
 *
 * Directions are those of the state as the event happens: whoever calls has added what the change of its time makes of
 * them. Impacts change v by M (v+ - v) + R^T L = 0, R the rows that hold and that which is struck (em_impact.h); what they
 * make of directions solves the same equations, with the same factors, for the derivatives of these terms. */
#ifndef EM_SALTATION_H
#define EM_SALTATION_H

#include "em_reset.h"

/* --- impacts --- */

/* The rows R that hold and that which is struck: B = R L^-T, Delta = B B^T = D D^T, rows that depend on others left out. */
typedef struct em_struck {
    em_root root;
    double B[EM_STRUCK_ROWS * N], D[EM_STRUCK_ROWS * EM_STRUCK_ROWS], r[EM_STRUCK_ROWS];
    int left_out[EM_STRUCK_ROWS];
} em_struck;

EM_COLD int em_struck_at(double t, const double *x, const double *c, const double *struck, em_struck *f, em_fault *fault) {
    double Delta[EM_STRUCK_ROWS * EM_STRUCK_ROWS];
    int kept;
    if (em_root_at(t, x, c, &f->root, fault)) return -1;
    em_struck_rows(&f->root, struck, f->B, Delta);
    const int all = em_independent_rows(EM_STRUCK_ROWS, Delta, EM_DEPENDENT, &kept) == EM_STRUCK_ROWS;
    for (int i = 0; i < EM_STRUCK_ROWS; ++i) {
        f->left_out[i] = !all && !(kept & EM_FIRST_KEPT << i);
        for (int j = 0; j <= i; ++j)
            if (f->left_out[i] || f->left_out[j]) Delta[i * EM_STRUCK_ROWS + j] = i == j;
    }
    if (f->left_out[N_ROWS]) return em_fail(fault, EM_IMPACT_UNDEFINED, -1, -1, NAN);
    return em_cholesky(EM_STRUCK_ROWS, Delta, f->D, f->r, 0.0) < 0 ? 0 : em_fail(fault, EM_IMPACT_UNDEFINED, -1, -1, NAN);
}

/* F (n, columns), G (m + 1, columns) <- X, Y of M X + R^T Y = F, R X = G. */
EM_COLD void em_solve_struck(const em_struck *f, int columns, double *F, double *G) {
    em_forward_rows(N, columns, f->root.L, f->root.r, F);
    for (int row = 0; row < EM_STRUCK_ROWS; ++row) {
        em_scale_row(columns, f->left_out[row] ? 0.0 : -1.0, G + row * columns);
        for (int k = 0; k < N && !f->left_out[row]; ++k)
            em_add_row(columns, f->B[row * N + k], F + k * columns, G + row * columns);
    }
    em_forward_rows(EM_STRUCK_ROWS, columns, f->D, f->r, G);
    em_backward_rows(EM_STRUCK_ROWS, columns, f->D, f->r, G);
    for (int k = 0; k < N; ++k)
        for (int row = 0; row < EM_STRUCK_ROWS; ++row)
            em_add_row(columns, -f->B[row * N + k], G + row * columns, F + k * columns);
    em_backward_rows(N, columns, f->root.L, f->root.r, F);
}

/* Directions after impact number `impact` made `after` of v; e: what came of the restitution, 0 where it lands. */
EM_COLD int em_strike_along(const em_directions *d, double t, const double *x, const double *v, const double *c,
                            const double *u, int impact, const double *struck, double e, int lands, const double *after,
                            em_fault *fault) {
    enum { NUMBERS = EM_SOME_IMPACTS * EM_STRUCK };
    const int columns = d->columns;
    double by[NUMBERS * N_ARGUMENTS], blow[(N + N_ROWS) * N_ARGUMENTS], W[EM_STRUCK * columns], F[(N + N_ROWS) * columns];
    double G[EM_STRUCK_ROWS * columns], change[N], impulse[EM_STRUCK_ROWS] = {0.0};
    em_struck f;
    if (em_struck_at(t, x, c, struck, &f, fault)) return -1;
    const double speed = em_approach(struck, v);
    impulse[N_ROWS] = -(1.0 + e) * speed;
    memset(change, 0, sizeof change);
    em_solve_struck(&f, 1, change, impulse); /* v+ - v, and what it takes */
    impact_partials(t, x, v, c, u, by);
    blow_partials(t, x, change, impulse, c, blow);
    em_along(d, EM_STRUCK, by + impact * EM_STRUCK * N_ARGUMENTS, W);
    em_along(d, N + N_ROWS, blow, F);
    const double *const rate = W + N * columns, *const restitution = rate + columns;
    for (int j = 0; j < columns; ++j) {
        double sum = -(1.0 + e) * rate[j] - (lands ? 0.0 : speed * restitution[j]);
        for (int k = 0; k < N; ++k) {
            sum -= (after[k] + e * v[k]) * W[k * columns + j] + (1.0 + e) * struck[k] * d->S[(N + k) * columns + j];
            F[k * columns + j] = -F[k * columns + j] - impulse[N_ROWS] * W[k * columns + j];
        }
        for (int row = 0; row < N_ROWS; ++row) G[row * columns + j] = -F[(N + row) * columns + j];
        G[N_ROWS * columns + j] = sum;
    }
    em_solve_struck(&f, columns, F, G);
    for (int k = 0; k < N * columns; ++k) d->S[N * columns + k] += F[k];
    return 0;
}

/* --- what switches that hold watch --- */

/* Row of D (n_events, n_arguments): the derivatives of the number of a switch, of those of the multipliers. */
EM_COLD void em_switch_partials(const em_switch *s, const double *lambda, const double *dlambda, double level,
                                const double *dlevel, double *row) {
    const double *const own = dlambda + s->row * N_ARGUMENTS;
    const int presses = s->over < 0 ? -1 : switches[s->over].row;
    const double sign = em_is_contact(s) || lambda[s->row] > 0.0 ? 1.0 : -1.0;
    for (int k = 0; k < N_ARGUMENTS; ++k) {
        row[k] = -sign * own[k];
        if (em_is_contact(s)) continue;
        if (presses < 0) row[k] += dlevel[k];
        else if (lambda[presses] < 0.0) row[k] -= dlevel[k] * lambda[presses] + level * dlambda[presses * N_ARGUMENTS + k];
    }
}

/* D (n_events, n_arguments) <- with those of em_watch_modes. 0, or -1: there are none. */
EM_COLD int em_watch_partials(double t, const double *x, const double *v, const double *c, const double *u, double *D) {
    double a[N], lambda[EM_SOME_ROWS], da[N * N_ARGUMENTS], dlambda[EM_SOME_ROWS * N_ARGUMENTS];
    double level[2 * EM_SOME_SWITCHES], dlevel[2 * EM_SOME_SWITCHES * N_ARGUMENTS];
    em_fault fault;
    int some = 0;
    for (int k = 0; k < N_SWITCHES; ++k) some |= em_holds(&switches[k], c);
    if (!some) return 0;
    if (em_motion_derivatives(t, x, v, c, u, EM_LEAST_NORM, a, lambda, da, dlambda, &fault)) return -1;
    levels(t, x, v, c, u, level);
    level_partials(t, x, v, c, u, dlevel);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (em_holds(s, c))
            em_switch_partials(s, lambda, dlambda, level[2 * k], dlevel + 2 * k * N_ARGUMENTS, D + s->event * N_ARGUMENTS);
    }
    return 0;
}

#endif
