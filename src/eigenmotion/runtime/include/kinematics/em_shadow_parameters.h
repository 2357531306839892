/* em_shadow_parameters.h: rotations without singularities: modified Rodrigues parameters s and their shadow set.
 *
 * s and -s / |s|^2 are the same rotation (Schaub and Junkins 1996). The change from one to the other is a change of
 * coordinates: it may happen at any time, and has no effect on the motion. */
#ifndef EM_SHADOW_PARAMETERS_H
#define EM_SHADOW_PARAMETERS_H

#include "eigenmotion.h"

/* Parameters are replaced where |s|^2 exceeds this, at 201 degrees, by those of 159 degrees. The distance between the
 * two keeps a body that swings about half a turn from changing at every swing. */
#define EM_MOST_RODRIGUES 1.44

/* |s|^2 of the rotation number k at x (n) */
static inline double em_square_of_rotation(const em_model *model, int k, const double *x) {
    const int *const at = model->rotations[k];
    return x[at[0]] * x[at[0]] + x[at[1]] * x[at[1]] + x[at[2]] * x[at[2]];
}

static inline int em_leaves_chart(const em_model *model, int k, const double *x) {
    return em_square_of_rotation(model, k, x) > EM_MOST_RODRIGUES;
}

/* x, v (n) <- with the shadow of the parameters that are too large. 1; 0: there are none */
static inline int em_turn_to_shadow(const em_model *model, double *x, double *v) {
    int turned = 0;
    for (int k = 0; k < model->n_rotations; ++k) {
        if (!em_leaves_chart(model, k, x)) continue;
        const int *const at = model->rotations[k];
        const double q = em_square_of_rotation(model, k, x);
        const double sv = x[at[0]] * v[at[0]] + x[at[1]] * v[at[1]] + x[at[2]] * v[at[2]];
        for (int i = 0; i < 3; ++i) {
            v[at[i]] = (2.0 * sv / q * x[at[i]] - v[at[i]]) / q;
            x[at[i]] = -x[at[i]] / q;
        }
        turned = 1;
    }
    return turned;
}

/* S (2 n, columns) <- the directions of x, v after em_turn_to_shadow, from those before at x, v (n). */
static inline void em_shadow_along(const em_model *model, const double *x, const double *v, int columns, double *S) {
    for (int k = 0; k < model->n_rotations; ++k) {
        if (!em_leaves_chart(model, k, x)) continue;
        const int *const at = model->rotations[k];
        const double q = em_square_of_rotation(model, k, x);
        const double sv = x[at[0]] * v[at[0]] + x[at[1]] * v[at[1]] + x[at[2]] * v[at[2]];
        for (int j = 0; j < columns; ++j) {
            double *const dx[3] = {S + at[0] * columns + j, S + at[1] * columns + j, S + at[2] * columns + j};
            double *const dv[3] = {dx[0] + model->n * columns, dx[1] + model->n * columns, dx[2] + model->n * columns};
            double dq = 0.0, dsv = 0.0;
            for (int i = 0; i < 3; ++i) {
                dq += 2.0 * x[at[i]] * *dx[i];
                dsv += *dx[i] * v[at[i]] + x[at[i]] * *dv[i];
            }
            for (int i = 0; i < 3; ++i) {
                const double s = x[at[i]], by_q = (v[at[i]] - 4.0 * sv / q * s) / q * (dq / q);
                *dv[i] = (2.0 * (dsv * s + sv * *dx[i]) / q - *dv[i]) / q + by_q;
                *dx[i] = (dq / q * s - *dx[i]) / q;
            }
        }
    }
}

#endif
