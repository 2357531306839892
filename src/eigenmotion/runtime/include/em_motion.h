/* em_motion.h: the motion itself, x and v, whatever the formulation carries: the mode of methods that solve for it. There
 * y[N .. 2 N) is v, and eigenfactors are those of M(x): found anew after every accepted step and where a row is published.
 *
 * A model written by hand, without em_mechanics.h, carries v in its mode 0. */
#ifndef EM_MOTION_H
#define EM_MOTION_H

#include "em_linear.h"

enum { EM_MOTION = 2 }; /* 0 is the published system, 1 the triangular root */

#ifdef EM_MECHANICS_H
enum { EM_CARRIES_MOTION = EM_SECOND_ORDER };

/* dy <- (v, a, 0). 0, or -1 and *fault */
EM_COLD int em_motion_rhs(double t, const double *y, const double *c, const double *u, double *memory, int flags,
                          double *dy, em_fault *fault) {
    double lambda[EM_SOME_ROWS];
    if (EM_CARRIES_MOTION) return model_rhs(0, t, y, c, u, memory, flags, dy, fault);
    memcpy(dy, y + N, N * sizeof *dy);
    memset(dy + 2 * N, 0, (N_STATE - 2 * N) * sizeof *dy);
    return em_acceleration(t, y, y + N, c, u, flags, dy + N, lambda, fault);
}

/* As model_settle: constraints where they are to be kept, and eigenfactors, but for a state within a step. */
EM_COLD int em_motion_settle(int flags, double t, double *y, const double *c, double *memory, double pace,
                             em_fault *fault) {
    int mode = 0;
    double found[N_STATE];
    if (EM_CARRIES_MOTION) return model_settle(&mode, flags, t, y, c, memory, pace, fault);
    if ((flags & EM_STABILISE) && em_settle_motion(t, y, y + N, c, flags & EM_ABOUT_ROWS, fault)) return -1;
    if (N_STATE == 2 * N || flags & EM_KEEP_MODE) return N_ROWS > 0;
    memcpy(found, y, sizeof found);
    if (state(t, y, y + N, c, found, fault)) return -1;
    memcpy(y + 2 * N, found + 2 * N, (N_STATE - 2 * N) * sizeof *y);
    return N_ROWS > 0;
}

/* row <- y in the published meaning */
EM_COLD int em_motion_publish(double t, const double *y, const double *c, double *row, em_fault *fault) {
    memcpy(row, y, N_STATE * sizeof *row);
    return EM_CARRIES_MOTION ? 0 : state(t, y, y + N, c, row, fault);
}

/* M (n, n), or what is factored in its place */
EM_UNUSED static void em_mass_at(double t, const double *x, const double *c, double *M) { factored(t, x, c, M); }
#else
enum { EM_CARRIES_MOTION = 0 };
static void em_mass_at(double t, const double *x, const double *c, double *M) {
    (void)t, (void)x, (void)c;
    for (int k = 0; k < N * N; ++k) M[k] = k % (N + 1) == 0;
}

EM_COLD int em_motion_rhs(double t, const double *y, const double *c, const double *u, double *memory, int flags,
                          double *dy, em_fault *fault) {
    return model_rhs(0, t, y, c, u, memory, flags, dy, fault);
}

EM_COLD int em_motion_settle(int flags, double t, double *y, const double *c, double *memory, double pace,
                             em_fault *fault) {
    int mode = 0;
    return model_settle(&mode, flags | EM_KEEP_MODE, t, y, c, memory, pace, fault);
}

EM_COLD int em_motion_publish(double t, const double *y, const double *c, double *row, em_fault *fault) {
    return model_publish(0, t, y, c, NULL, row, fault);
}
#endif

#endif
