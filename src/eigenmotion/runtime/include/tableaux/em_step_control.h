/* em_step_control.h: formulas of step-size control, for one run and for runs in the lanes of vectors (em_real.h). */
#ifndef EM_STEP_CONTROL_H
#define EM_STEP_CONTROL_H

#include "numeric/em_real.h"

#define EM_LEAST_ERROR -9.2 /* log 1e-4: a smaller error is accidental */

/* The PI controller of a method. */
typedef struct em_size_control {
    int error_order;       /* the error that controls the step size is O(h^(error_order + 1)) */
    double present, past;  /* gains: of the error of this step, and of the one before */
    double growth;         /* the largest ratio of a step to the one before */
} em_size_control;

#define EM_RUNGE_KUTTA_CONTROL(tableau) ((em_size_control){(tableau).error_order, 0.7, 0.4, 4.0})

/* The ratio of the next step size to this one, from logarithms of errors: after an accepted step of its error and
 * that of the one before (Gustafsson, ACM Trans. Math. Softw. 17 (1991)), so that few are rejected; after a
 * rejected one of its error alone. */
EM_INLINE real em_size_ratio(const em_size_control *of, real error, real last_error) {
    const double safety = 0.9, least = 0.2, order = of->error_order + 1;
    real log_factor = -error; /* a branch for one run, a selection among lanes */
    if (em_any(error < 0.0)) log_factor = em_where(error < 0.0, of->past * last_error - of->present * error, -error);
    return em_min(em_real(of->growth), em_max(em_real(least), safety * exp(log_factor / order)));
}

/* *t_new and *h of a step from t of a size, up to `bound` at most. direction: 1 or -1 */
EM_INLINE void em_aim_step(double direction, real t, real size, real bound, real *t_new, real *h) {
    const real aimed = t + direction * size;
    *t_new = em_where(direction * (aimed - bound) > 0.0, bound, aimed);
    *h = *t_new - t;
}

/* ceil, without a call of the C library. */
EM_INLINE double em_ceil(double a) {
    if (!(fabs(a) < 0x1p52)) return a;
    const double whole = (double)(long long)a;
    return whole < a ? whole + 1.0 : whole;
}

/* Steps of fixed size divide the interval into equal parts, none longer than `size`; the last one overshoots and is
 * cut, so that rounding does not matter. */
EM_INLINE double em_equal_part(double way, double size) {
    const double count = em_ceil(way / size - 1e-6);
    return count > 1.0 ? way / count : 2.0 * way;
}

#define EM_LEAST_SIZE 1e-140 /* added to tolerances, so that of a number that is 0 without an absolute tolerance the
                                weight, and its square, are finite */

/* The weight of an error of a number: 1 / (atol + rtol max(|before|, |after|)). */
EM_INLINE real em_weight(double atol, double rtol, real before, real after) {
    return 1.0 / (atol + rtol * em_max(fabs(before), fabs(after)) + EM_LEAST_SIZE);
}

/* The error of two estimates e_0, e_1 with these weighted sums of squares over `count` numbers: |h| e_0^2 / sqrt(e_0^2 +
 * 0.01 e_1^2) (Hairer, Norsett & Wanner, II.10). */
EM_INLINE real em_error_of_two(real h, real first, real second, double count) {
    const real denominator = first + 0.01 * second;
    return em_where(denominator == 0.0, em_real(0.0), fabs(h) * first / sqrt(denominator * count));
}

#define EM_NEAR_ROUNDING 1e-11 /* rtol */

/* The bound that is compared: near rounding, the rounding of stiff forces keeps steps a few times shorter than stability
 * does, and far longer than accuracy asks of smooth motions. */
EM_INLINE double em_stability_bound(double stable, double rtol) { return rtol < EM_NEAR_ROUNDING ? 0.3 * stable : stable; }

/* Whether stability limits the step size (Hairer & Wanner, Solving Ordinary Differential Equations II, IV.2): two
 * states at the same time, and their rates, with these weighted sums of squares of their differences, give an
 * estimate of the dominant eigenvalue; `stable` bounds the stability region of the method. */
EM_INLINE em_truth em_is_stiff(double stable, real h, real apart, real driven) {
    return h * h * driven > stable * stable * apart;
}

#endif
