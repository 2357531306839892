/* em_simplified_newton.h: the simplified Newton iteration: one Jacobian for all stages, taken at the start of this
 * step or of an earlier one; systems of n unknowns, along the eigenvectors of A^-1. */
#ifndef EM_SIMPLIFIED_NEWTON_H
#define EM_SIMPLIFIED_NEWTON_H

#include "numeric/em_lu.h"
#include "stepper/em_error_norm.h"
#include "radau_iia/em_acceleration_jacobian.h"

/* out_i (n) <- start (NULL: 0) + h sum_j a_ij in_j. The numbers of each stage are a row of length `stride`, n
 * padded. */
EM_INLINE void em_by_stages(const em_radau_iia *rk, double h, int stride, const double *restrict start,
                            const double *restrict in, double *restrict out) {
    for (int k = 0; k < stride; k += EM_PACK) {
        const em_pack first = start ? EM_PACK_AT(start + k) : (em_pack){0.0};
        EM_UNROLL
        for (int i = 0; i < rk->stages; ++i) {
            em_pack sum = {0.0};
            EM_UNROLL
            for (int j = 0; j < rk->stages; ++j) sum += rk->a[i][j] * EM_PACK_AT(in + j * stride + k);
            EM_PUT_PACK(out + i * stride + k, first + h * sum);
        }
    }
}

/* unit (count of n) <- units of the rows of the systems */
static void em_stage_units(const em_run_state *w, int count, double *unit) {
    for (int k = 0; k < count * w->n; ++k) unit[k] = em_min(w->weight[w->n + k % w->n], 1e100);
}

static int em_slopes_are_fresh(const em_run_state *w) { return w->stages.sloped && w->stages.slopes_t == w->t; }

/* K and D at the start of the step. 0, or -1 and w->reason */
static int em_take_slopes(em_run_state *w) {
    em_implicit *q = &w->stages;
    if (w->n_inputs > 0) em_signals(w, w->t);
    if (em_acceleration_slopes(w, w->t, w->y, q->K, q->D)) return -1;
    q->slopes_t = w->t;
    q->sloped = 1;
    q->outdated = 0;
    q->factored_h = 0.0;
    return 0;
}

/* G + i H (n, n) <- sigma^2 - sigma D - K, sigma = re + i im; H may be NULL */
static void em_stage_matrix(const em_run_state *w, double re, double im, double *G, double *H) {
    const em_implicit *const q = &w->stages;
    const int n = w->n;
    for (int k = 0; k < n * n; ++k) G[k] = -re * q->D[k] - q->K[k];
    for (int k = 0; k < n * n; k += n + 1) G[k] += re * re - im * im;
    for (int k = 0; H != NULL && k < n * n; ++k) H[k] = -im * q->D[k];
    for (int k = 0; H != NULL && k < n * n; k += n + 1) H[k] += 2.0 * re * im;
}

/* The factors of the real matrix. 0, or -1: it is singular */
static int em_factor_real(const em_radau_iia *rk, em_run_state *w) {
    em_implicit *q = &w->stages;
    double unit[w->n];
    em_stage_units(w, 1, unit);
    em_stage_matrix(w, rk->mu[0][0] / w->h, 0.0, q->G[0], NULL);
    return em_lu(w->n, q->G[0], unit, q->pivot[0]);
}

/* The factors for a step of this size. 0, or -1: a matrix is singular */
static int em_factor_shared(const em_radau_iia *rk, em_run_state *w) {
    em_implicit *q = &w->stages;
    double unit[w->n];
    if (q->factored_h == w->h) return 0;
    em_stage_units(w, 1, unit);
    q->factored_h = 0.0;
    ++w->run->n_factors;
    if (em_factor_real(rk, w)) return -1;
    for (int p = 1; p <= rk->stages / 2; ++p) {
        em_stage_matrix(w, rk->mu[p][0] / w->h, rk->mu[p][1] / w->h, q->G[p], q->H[p]);
        if (em_complex_lu(w->n, q->G[p], q->H[p], unit, q->pivot[p])) return -1;
    }
    q->factored_h = w->h;
    return 0;
}

/* re + i im (n) <- sigma^2 (sigma^2 - sigma D - K)^-1 of r along an eigenvector, the first of which is real */
EM_INLINE void em_solve_along(const em_radau_iia *rk, em_run_state *w, int stride, int p, double *re, double *im) {
    em_implicit *q = &w->stages;
    const double a = rk->mu[p][0] / w->h, b = rk->mu[p][1] / w->h, square = a * a - b * b, twice = 2.0 * a * b;
    for (int k = 0; k < stride; k += EM_PACK) {
        em_pack x = {0.0}, y = {0.0};
        EM_UNROLL
        for (int i = 0; i < rk->stages; ++i) {
            const em_pack r = EM_PACK_AT(q->r + i * stride + k);
            x += rk->to[p][i][0] * r, y += rk->to[p][i][1] * r;
        }
        EM_PUT_PACK(re + k, square * x - twice * y);
        EM_PUT_PACK(im + k, square * y + twice * x);
    }
    if (p == 0) em_lu_solve(w->n, q->G[0], q->pivot[0], re);
    else em_complex_lu_solve(w->n, q->G[p], q->H[p], q->pivot[p], re, im);
}

/* change (stages, n) of the accelerations that removes the residuals r */
EM_INLINE void em_shared_changes(const em_radau_iia *rk, em_run_state *w, int stride, double *change) {
    double re[stride], im[stride];
    for (int p = 0; p <= rk->stages / 2; ++p) {
        em_solve_along(rk, w, stride, p, re, im);
        for (int k = 0; k < stride; k += EM_PACK) {
            const em_pack x = EM_PACK_AT(re + k), y = EM_PACK_AT(im + k);
            EM_UNROLL
            for (int i = 0; i < rk->stages; ++i) {
                double *const to = change + i * stride + k;
                const em_pack before = p > 0 ? EM_PACK_AT(to) : (em_pack){0.0};
                EM_PUT_PACK(to, before + (rk->from[p][i][0] * x - rk->from[p][i][1] * y));
            }
        }
    }
}

#endif
