/* em_told.h: a motion that the caller tells step by step, as methods do whose steps are made in Python.
 *
 * What is told is a polynomial for x and v, by its values at Chebyshev's nodes. A step of the run is all of it, or a part,
 * where a look at events or a sample of the inputs needs a shorter one: it costs one right-hand side, at its end. So
 * everything about a run but the steps themselves is that of other methods. */
#ifndef EM_TOLD_H
#define EM_TOLD_H

#include "em_norm.h"

enum { EM_TOLD_DEGREE = EM_DENSE_COEFFICIENTS - 1, EM_TOLD_ORDER = 5 };

/* 1/2 - cos(pi j / 9) / 2 */
static const double EM_TOLD_NODES[EM_DENSE_COEFFICIENTS] = {
    0.0, 0.030153689607045808, 0.11697777844051098, 0.25, 0.41317591116653483,
    0.58682408883346517, 0.75, 0.88302222155948902, 0.96984631039295419, 1.0};

/* The barycentric formula (Berrut & Trefethen, SIAM Rev. 46 (2004) 501, section 5). */
EM_RARE static void em_told_evaluate(const double *F, int degree, double theta, double *y) {
    double sum = 0.0;
    memset(y, 0, N_STATE * sizeof *y);
    for (int j = 0; j <= degree; ++j, F += N_STATE) {
        const double apart = theta - EM_TOLD_NODES[j];
        if (apart == 0.0) {
            memcpy(y, F, N_STATE * sizeof *y);
            return;
        }
        const double share = (j % 2 ? -1.0 : 1.0) * (j % degree ? 1.0 : 0.5) / apart;
        sum += share;
        for (int k = 0; k < N_STATE; ++k) y[k] += share * F[k];
    }
    for (int k = 0; k < N_STATE; ++k) y[k] /= sum;
}

/* y (n_state) at t; of C and s what the step begins with. */
static void em_told_at(const em_walk *w, double t, double *y) {
    const em_piece *piece = w->run->piece;
    em_told_evaluate(piece->y, EM_TOLD_DEGREE, (t - piece->t) / piece->h, y);
    memcpy(y + 2 * N, w->y + 2 * N, (N_STATE - 2 * N) * sizeof *y);
}

EM_RARE static int em_told_step(em_walk *w) {
    if (w->run->piece == NULL) return em_fail(&w->reason, EM_STEP_SIZE_UNDERFLOW, -1, -1, w->h); /* nothing is told */
    memcpy(w->y_new, w->y, sizeof w->y_new);
    em_told_at(w, w->t_new, w->y_new);
    em_set_weights(w, w->y, w->y + N, w->y_new, w->y_new + N);
    w->end_rate = NULL;
    w->error_norm = w->size_norm = DBL_MIN;
    return 0;
}

EM_RARE static int em_told_interpolate(em_walk *w) {
    for (int j = 0; j <= EM_TOLD_DEGREE; ++j) em_told_at(w, w->t + EM_TOLD_NODES[j] * w->h, w->F[j]);
    return 0;
}

/* These steps are long beside what happens in them, and dear: a glance is not enough. */
EM_RARE static int em_told_sketch(em_walk *w) { return (void)w, -1; }

#endif
