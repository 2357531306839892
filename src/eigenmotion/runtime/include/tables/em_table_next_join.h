/* em_table_next_join.h: the next join of pieces, of those that are as rough as asked. */
#ifndef EM_TABLE_NEXT_JOIN_H
#define EM_TABLE_NEXT_JOIN_H

#include "eigenmotion.h"
#include "tables/em_table.h"

/* How a join is rough: the rates jump there, or they or their slopes do. It is the most that the derivative that jumps
 * is higher than the highest derivative of the table in the equations. */
typedef enum em_roughness { EM_JUMPS_THERE = 0, EM_ROUGH = 1 } em_roughness;

EM_UNUSED static int em_is_rough(const em_table_use *use, double jumping, em_roughness most) {
    return jumping - (double)use->order <= (double)most;
}

/* The next join after `from` within one period, infinite: there is none. Joins are in order. */
EM_UNUSED static double em_join_within(const em_axis *axis, const em_table_use *use, em_roughness most, double from,
                                       double direction) {
    int low = 0, high = axis->n_joins;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (direction > 0.0 ? axis->joins[2 * middle] <= from : axis->joins[2 * middle] < from) low = middle + 1;
        else high = middle;
    }
    for (int k = direction > 0.0 ? low : low - 1; k >= 0 && k < axis->n_joins; k += direction > 0.0 ? 1 : -1)
        if (em_is_rough(use, axis->joins[2 * k + 1], most)) return axis->joins[2 * k];
    return direction * INFINITY;
}

/* The next rough join after an argument. */
EM_UNUSED static double em_next_join(const em_axis *axis, const em_table_use *use, em_roughness most, int repeats,
                                     double from, double direction) {
    const double first = axis->knots[0], period = axis->knots[axis->count] - first;
    const double shift = repeats ? floor((from - first) / period) * period : 0.0;
    const double next = em_join_within(axis, use, most, from - shift, direction);
    if (isfinite(next) || !repeats) return next + shift;
    const double other = shift + direction * period, begin = direction > 0.0 ? first - period : first + 2.0 * period;
    return em_join_within(axis, use, most, begin, direction) + other;
}

#endif
