/* em_table.h: tables: piecewise polynomials of one argument or of two, whose data is set at run time.
 *
 * A table is one array of doubles (Pieces.numbers of codegen/model/pieces.py):
 *
 *     number of arguments, em_outside;
 *     for each of two axes: pieces, order (coefficients of a piece along it), pieces / range, joins;
 *     for each axis: the lowest derivative that jumps;
 *     for each axis: knots (pieces + 1), starts (pieces + 1), joins (joins, 2); then the coefficients
 *
 * The range is divided into equal cells; `starts` has the piece at the beginning of each cell, which bounds the search
 * for a piece. A join is a knot and the lowest derivative that jumps there. A kernel identifies a table by a number: 0
 * is the model's own, any other is an address. */
#ifndef EM_TABLE_H
#define EM_TABLE_H

#include <math.h>
#include <stdint.h>

#include "numeric/em_real.h"

typedef enum em_outside { EM_REFUSES = 0, EM_HOLDS_ENDS, EM_EXTENDS, EM_REPEATS } em_outside;

enum { EM_TABLE_HEAD = 12 };

/* One argument of a table. */
typedef struct em_axis {
    int count, order, n_joins;
    double scale;
    const double *knots, *starts, *joins;
} em_axis;

EM_INLINE em_axis em_axis_of(const double *table, int k) {
    const double *head = table + 2 + 4 * k, *first = table + EM_TABLE_HEAD;
    if (k > 0) first += 2 * ((int)table[2] + 1) + 2 * (int)table[5];
    const int count = (int)head[0];
    return (em_axis){count, (int)head[1], (int)head[3], head[2], first, first + count + 1, first + 2 * (count + 1)};
}

/* The coefficients begin here; `last` is the last axis. */
EM_INLINE const double *em_table_coefficients(const em_axis *last) { return last->joins + 2 * last->n_joins; }

EM_INLINE const double *em_table_at(double number, const double *own) {
    return number == 0.0 ? own : (const double *)(uintptr_t)number;
}

/* The argument at which the table is evaluated for x, according to `outside`; NaN if extrapolation is refused. */
EM_INLINE double em_table_place(const em_axis *axis, em_outside outside, double x) {
    const double low = axis->knots[0], high = axis->knots[axis->count];
    if ((x >= low && x <= high) || outside == EM_EXTENDS) return x;
    if (outside == EM_HOLDS_ENDS) return x < low ? low : x > high ? high : x;
    if (outside != EM_REPEATS || !isfinite(x)) return NAN;
    const double inside = x - floor((x - low) / (high - low)) * (high - low);
    return inside < low ? low : inside > high ? high : inside;
}

/* The piece that contains x; beyond the knots, the first or the last. Bisection, bounded by `starts`, and then a
 * correction for rounding. */
EM_INLINE int em_table_piece(const em_axis *axis, double x) {
    const double part = (x - axis->knots[0]) * axis->scale;
    const int count = axis->count, cell = part > 0.0 ? part < count ? (int)part : count - 1 : 0;
    int low = (int)axis->starts[cell], high = (int)axis->starts[cell + 1];
    while (high - low > 2) {
        const int middle = (low + high) / 2;
        if (x < axis->knots[middle]) high = middle;
        else low = middle;
    }
    while (low > 0 && x < axis->knots[low]) --low;
    while (low < count - 1 && x >= axis->knots[low + 1]) ++low;
    return low;
}

/* The derivative of order d at s of a polynomial, by ascending powers whose coefficients are `stride` apart. */
EM_INLINE double em_table_polynomial(int order, const double *a, int stride, int d, double s) {
    double value = 0.0;
    for (int m = order - 1; m >= d; --m) {
        double factor = 1.0;
        for (int k = 0; k < d; ++k) factor *= (double)(m - k);
        value = value * s + factor * a[m * stride];
    }
    return value;
}

/* d^d f / dx^d at x */
EM_UNUSED static double em_table_value(const double *table, int d, double x) {
    const em_axis axis = em_axis_of(table, 0);
    const em_outside outside = (em_outside)(int)table[1];
    const double at = em_table_place(&axis, outside, x);
    if (!(at == x) && (at != at || (d > 0 && outside == EM_HOLDS_ENDS))) return at != at ? NAN : 0.0;
    const int piece = em_table_piece(&axis, at);
    return em_table_polynomial(axis.order, em_table_coefficients(&axis) + piece * axis.order, 1, d, at - axis.knots[piece]);
}

/* d^(d + e) f / dx^d dy^e at x, y */
EM_UNUSED static double em_table_value_of_two(const double *table, int d, int e, double x, double y) {
    const em_axis axis = em_axis_of(table, 0), other = em_axis_of(table, 1);
    const em_outside outside = (em_outside)(int)table[1];
    const double at = em_table_place(&axis, outside, x), to = em_table_place(&other, outside, y);
    if (at != at || to != to) return NAN;
    if (outside == EM_HOLDS_ENDS && ((d > 0 && at != x) || (e > 0 && to != y))) return 0.0;
    const int piece = em_table_piece(&axis, at), beside = em_table_piece(&other, to), width = other.order;
    const double *a = em_table_coefficients(&other) + (piece * other.count + beside) * axis.order * width;
    const double s = at - axis.knots[piece], r = to - other.knots[beside];
    double value = 0.0;
    for (int m = axis.order - 1; m >= d; --m) {
        double factor = 1.0;
        for (int k = 0; k < d; ++k) factor *= (double)(m - k);
        value = value * s + factor * em_table_polynomial(width, a + m * width, 1, e, r);
    }
    return value;
}

#if defined(EM_ON_DUALS)

EM_INLINE real em_table_of_one(real number, const double *own, int d, real x) {
    const double *const table = em_table_at(em_value(number), own), a = em_value(x);
    real made = em_table_value(table, d, a);
    if (__imag__ x != 0.0) __imag__ made = em_table_value(table, d + 1, a) * __imag__ x;
    return made;
}

EM_INLINE real em_table_of_two(real number, const double *own, int d, int e, real x, real y) {
    const double *const table = em_table_at(em_value(number), own), a = em_value(x), b = em_value(y);
    real made = em_table_value_of_two(table, d, e, a, b);
    if (__imag__ x != 0.0) __imag__ made += em_table_value_of_two(table, d + 1, e, a, b) * __imag__ x;
    if (__imag__ y != 0.0) __imag__ made += em_table_value_of_two(table, d, e + 1, a, b) * __imag__ y;
    return made;
}

#elif defined(EM_ON_LANES)

EM_INLINE real em_table_of_one(real number, const double *own, int d, real x) {
    for (int lane = 0; lane < EM_LANES; ++lane) x[lane] = em_table_value(em_table_at(number[lane], own), d, x[lane]);
    return x;
}

EM_INLINE real em_table_of_two(real number, const double *own, int d, int e, real x, real y) {
    for (int lane = 0; lane < EM_LANES; ++lane)
        x[lane] = em_table_value_of_two(em_table_at(number[lane], own), d, e, x[lane], y[lane]);
    return x;
}

#else

EM_INLINE real em_table_of_one(real number, const double *own, int d, real x) {
    return em_table_value(em_table_at(number, own), d, x);
}

EM_INLINE real em_table_of_two(real number, const double *own, int d, int e, real x, real y) {
    return em_table_value_of_two(em_table_at(number, own), d, e, x, y);
}

#endif

#endif
