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

/* The larger number, or b. Unlike fmax it is one instruction: compilers keep to its rule for NaN. */
EM_INLINE double em_larger(double a, double b) { return a > b ? a : b; }

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
    return (em_step_errors){per * end, per * fmax(end, off * sqrt(falls))};
}

/* The size of S_v[i] in a step: its own, and that of the terms that change it. */
EM_INLINE double em_rate_size(const em_pass *p, double length, int at) {
    const int v = at + p->n * p->columns;
    return em_larger(em_larger(fabs(p->S0[v]), fabs(p->S[v])), 0.25 * length * em_larger(p->T0[at], p->T[at]));
}

/* One row of the series of K: the absolute values of its last coefficients and of the next one. part (4, columns). */
EM_INLINE void em_last_terms(const em_pass *p, int i, double *part) {
    enum { NODES = EM_VARIATION_NODES };
    const int n = p->n, k = p->columns;
    const double *const C = p->of->series;
    memset(part, 0, 4 * (size_t)k * sizeof *part);
    for (int q = 0; q < NODES; ++q) {
        const double *const K = p->K + (q * n + i) * k;
        const double five = C[5 * NODES + q], six = C[6 * NODES + q], seven = C[7 * NODES + q], at = p->origin[q];
        for (int j = 0; j < k; ++j) {
            part[j] += five * K[j], part[k + j] += six * K[j], part[2 * k + j] += seven * K[j];
            part[3 * k + j] += at * K[j];
        }
    }
    for (int j = 0; j < k; ++j) part[3 * k + j] = 0.5 * (p->K0[i * k + j] - part[3 * k + j]);
}

/* The largest errors of a direction. K_rounding (n, columns): the rounding of K; NULL: unknown. */
EM_INLINE em_step_errors em_step_error(em_pass *p, double h, const double *K_rounding) {
    const int n = p->n, k = p->columns;
    const double tolerance = p->of->tolerance, length = fabs(h);
    double part[4 * k];
    em_step_errors most = {0.0, 0.0};
    em_series_size sizes[k];
    memset(sizes, 0, sizeof sizes);
    if (!K_rounding) em_sum_terms(p, p->J + (EM_VARIATION_NODES - 1) * n * p->of->model->n_arguments, p->S, p->T);
    for (int i = 0; i < n; ++i) {
        em_last_terms(p, i, part);
        for (int j = 0; j < p->of->columns; ++j) {
            const double rounding = K_rounding ? length * K_rounding[i * k + j] / tolerance : 0.0;
            const double per = length / (em_rate_size(p, length, i * k + j) + rounding + DBL_MIN);
            sizes[j].five = em_larger(sizes[j].five, per * fabs(part[j]));
            sizes[j].six = em_larger(sizes[j].six, per * fabs(part[k + j]));
            sizes[j].seven = em_larger(sizes[j].seven, per * fabs(part[2 * k + j]));
            sizes[j].eight = em_larger(sizes[j].eight, per * fabs(part[3 * k + j]));
        }
    }
    for (int j = 0; j < p->of->columns; ++j) most = em_larger_errors(most, em_direction_errors(&sizes[j], 1.0 / tolerance));
    return most;
}

#endif
