/* em_variation_error.h: the error of a step of the variational equations.
 *
 * Within a step K = S_v' is a polynomial of degree 7. Its residual at the start of the step, which is not a node, is
 * twice the next coefficient of its Legendre series, k_8. So within the step the error of S_v is about h k_8 / 32,
 * that of S_x is smaller. At the end both are much smaller, since the nodes are those of Radau: their order is the
 * product of k_8 and the seventh coefficient of S, or that of coefficients of twice the degree, which are assumed to
 * decay as the known ones do. All errors are relative to the size of directions and of the terms of their rates,
 * number by number, so that units do not matter. No shorter step reduces the part that is rounding
 * (em_variation_rounding.h). */
#ifndef EM_VARIATION_ERROR_H
#define EM_VARIATION_ERROR_H

#include "sensitivity/em_variation_rounding.h"

#define EM_STEP_SHARE (1.0 / 32.0)
#define EM_END_SAFETY 2.0

/* The sizes of the coefficients of one direction that determine its error, relative to its size. */
typedef struct em_series_size {
    double five, six, seven, eight;
} em_series_size;

/* The errors of a step, in tolerances: at its end, and anywhere in it. */
typedef struct em_step_errors {
    double end, within;
} em_step_errors;

EM_INLINE em_step_errors em_larger_errors(em_step_errors a, em_step_errors b) {
    return (em_step_errors){fmax(a.end, b.end), fmax(a.within, b.within)};
}

/* The errors of a direction, relative to its size, times `per`. */
EM_INLINE em_step_errors em_direction_errors(const em_series_size *s, double per) {
    const double before = fmax(s->five, s->six), after = fmax(s->seven, s->eight);
    const double falls = before > after ? after / before : 1.0; /* the decay over two terms */
    const double off = EM_STEP_SHARE * s->eight, end = off * EM_END_SAFETY * (fmax(s->six, s->seven) / 26.0 + falls * falls * falls);
    if (!isfinite(end)) return (em_step_errors){INFINITY, INFINITY}; /* what is no number is not small */
    return (em_step_errors){per * end, per * fmax(end, off * sqrt(falls))};
}

/* The size of S_v[i] in a step: its own, and that of the terms that change it. */
EM_INLINE double em_rate_size(const em_pass *p, double length, int at) {
    const int v = at + p->n * p->columns;
    return em_max(em_max(fabs(p->S0[v]), fabs(p->S[v])), 0.25 * length * em_max(p->T0[at], p->T[at]));
}

/* The rounding of S_v[i] by its part along the motion, relative to the tolerance, for a shift of one. */
EM_INLINE double em_shift_rounding(const em_pass *p, int i) {
    const double *const end = p->a + (EM_VARIATION_NODES - 1) * p->n;
    return EM_CANCELLATION / p->of->tolerance * em_max(fabs(p->a0[i]), fabs(end[i]));
}

/* Series in a step, of `count` columns, from their values at the start and at the nodes, which are `apart` numbers apart:
 * the last coefficients, and the next one. */
EM_INLINE void em_last_terms(const em_pass *p, int count, const double *restrict start, const double *restrict nodes,
                             size_t apart, double *restrict five, double *restrict six, double *restrict seven,
                             double *restrict eight) {
    enum { NODES = EM_VARIATION_NODES };
    const double *const C = p->of->series;
    for (int j = 0; j < count; ++j) five[j] = six[j] = seven[j] = eight[j] = 0.0;
    for (int q = 0; q < NODES; ++q) {
        const double *restrict const f = nodes + q * apart;
        const double c_five = C[5 * NODES + q], c_six = C[6 * NODES + q], c_seven = C[7 * NODES + q], at = p->origin[q];
        for (int j = 0; j < count; ++j)
            five[j] += c_five * f[j], six[j] += c_six * f[j], seven[j] += c_seven * f[j], eight[j] += at * f[j];
    }
    for (int j = 0; j < count; ++j) eight[j] = 0.5 * (start[j] - eight[j]);
}

/* s <- the largest absolute values, of it and of these terms times `per`. */
EM_INLINE void em_count_terms(em_series_size *s, double per, double five, double six, double seven, double eight) {
    s->five = em_max(s->five, per * fabs(five)), s->six = em_max(s->six, per * fabs(six));
    s->seven = em_max(s->seven, per * fabs(seven)), s->eight = em_max(s->eight, per * fabs(eight));
}

/* The largest errors of a direction. K_rounding (n, columns): the rounding of K; NULL: unknown. */
EM_INLINE em_step_errors em_step_error(em_pass *p, double h, const double *K_rounding) {
    const int n = p->n, k = p->columns;
    const double tolerance = p->of->tolerance, length = fabs(h);
    double five[k], six[k], seven[k], eight[k];
    em_step_errors most = {0.0, 0.0};
    em_series_size sizes[k];
    memset(sizes, 0, sizeof sizes);
    if (!K_rounding) em_sum_terms(p, p->J + (EM_VARIATION_NODES - 1) * n * p->of->model->n_arguments, p->S, p->T);
    for (int i = 0; i < n; ++i) {
        const double shifted = em_shift_rounding(p, i);
        em_last_terms(p, k, p->K0 + i * k, p->K + i * k, (size_t)n * k, five, six, seven, eight);
        for (int j = 0; j < p->of->columns; ++j) {
            const double rounding = K_rounding ? length * K_rounding[i * k + j] / tolerance : 0.0;
            const double size = em_rate_size(p, length, i * k + j) + rounding + shifted * fabs(p->shift[i * k + j]);
            em_count_terms(&sizes[j], em_min(length / (size + DBL_MIN), 1.0 / DBL_MIN), five[j], six[j], seven[j], eight[j]);
        }
    }
    for (int j = 0; j < p->of->columns; ++j) most = em_larger_errors(most, em_direction_errors(&sizes[j], 1.0 / tolerance));
    return most;
}

#endif
