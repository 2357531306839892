/* em_table_joins.h: steps that end where the pieces of a table join less smoothly than a step requires.
 *
 * A join is rough if the force or its slope jumps there: the derivative that jumps is at most one higher than the
 * highest derivative of the table in the equations. A step that would pass a rough join ends just beyond it, so that
 * the next step begins on its other side. If the argument depends on time only, the step is shortened beforehand.
 * Otherwise it is repeated with a size from the method of false position (Illinois), but no size below the least: the
 * spacing of times may be coarser than the interval behind a join. */
#ifndef EM_TABLE_JOINS_H
#define EM_TABLE_JOINS_H

#include "stepper/em_table_lookups.h"

enum { EM_MOST_AIMS = 20 };

/* A search for the size of a step that ends at a join: a size that is too short and one that is too long, with the
 * signed distances of the argument from its goal; the size to try next. */
typedef struct em_join_search {
    double low, below, high, above, size;
    int aims, use, side;
} em_join_search;

static int em_is_rough(const em_table_use *use, double jumping) { return jumping - (double)use->order <= 1.0; }

/* The next join after `from` within one period, infinite: there is none. Joins are in order. */
static double em_join_within(const em_axis *axis, const em_table_use *use, double from, double direction) {
    int low = 0, high = axis->n_joins;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (direction > 0.0 ? axis->joins[2 * middle] <= from : axis->joins[2 * middle] < from) low = middle + 1;
        else high = middle;
    }
    for (int k = direction > 0.0 ? low : low - 1; k >= 0 && k < axis->n_joins; k += direction > 0.0 ? 1 : -1)
        if (em_is_rough(use, axis->joins[2 * k + 1])) return axis->joins[2 * k];
    return direction * INFINITY;
}

/* The next rough join after an argument. */
static double em_next_join(const em_axis *axis, const em_table_use *use, int repeats, double from, double direction) {
    const double first = axis->knots[0], period = axis->knots[axis->count] - first;
    const double shift = repeats ? floor((from - first) / period) * period : 0.0;
    const double next = em_join_within(axis, use, from - shift, direction);
    if (isfinite(next) || !repeats) return next + shift;
    const double other = shift + direction * period, begin = direction > 0.0 ? first - period : first + 2.0 * period;
    return em_join_within(axis, use, begin, direction) + other;
}

/* The length of the interval behind a join in which steps may end; the goal is its middle. */
static double em_join_zone(const em_axis *axis, double join) {
    const double range = fabs(axis->knots[0]) + fabs(axis->knots[axis->count]);
    return 64.0 * DBL_EPSILON * (fabs(join) > range ? fabs(join) : range);
}

/* The distance of `to` from the goal behind the first rough join after `from`, if `to` is beyond the zone of the join;
 * else 0. *below <- the (negative) distance of `from`. */
static double em_distance_past_join(const em_run_state *w, const em_table_use *use, double from, double to,
                                    double *below) {
    const double *const table = em_table_of_use(w->model, w->run->prepared, use), direction = to > from ? 1.0 : -1.0;
    if (!em_is_rough(use, table[10 + use->axis]) || !isfinite(to - from) || to == from) return 0.0;
    const em_axis axis = em_axis_of(table, use->axis);
    const double join = em_next_join(&axis, use, (em_outside)(int)table[1] == EM_REPEATS, from, direction);
    const double zone = em_join_zone(&axis, join), goal = join + direction * 0.5 * zone;
    if (!(direction * (to - join) > zone)) return 0.0;
    *below = direction * (from - goal);
    return direction * (to - goal);
}

static int em_has_rough_tables(const em_run_state *w) {
    for (int k = 0; k < w->model->n_table_uses; ++k) {
        const em_table_use *const use = &w->model->table_uses[k];
        if (em_is_rough(use, em_table_of_use(w->model, w->run->prepared, use)[10 + use->axis])) return 1;
    }
    return 0;
}

/* The size of a step in which no argument that depends on time only passes a rough join. */
static double em_size_to_join(em_run_state *w, double size) {
    const int uses = w->model->n_table_uses;
    double at[em_some(uses)], ahead[em_some(uses)], below, least = 1.0, v[w->n];
    memset(v, 0, sizeof v);
    em_arguments_at(w, w->t, w->y, v, at);
    em_arguments_at(w, w->t + w->direction * size, w->y, v, ahead);
    for (int k = 0; k < uses; ++k) {
        if (!w->model->table_uses[k].timed) continue;
        const double above = em_distance_past_join(w, &w->model->table_uses[k], at[k], ahead[k], &below);
        if (above > 0.0) least = em_min(least, below / (below - above));
    }
    return least * size;
}

/* Updates the search with a step of this size, which ends at a distance `way` from the goal, and proposes the next size
 * (Illinois). */
static void em_next_join_size(em_join_search *s, double size, double way) {
    const int side = way > 0.0 ? 1 : -1;
    if (side > 0) s->high = size, s->above = way;
    else s->low = size, s->below = way;
    if (side == s->side && side > 0) s->below *= 0.5;
    if (side == s->side && side < 0) s->above *= 0.5;
    s->side = side;
    s->size = s->low + (s->high - s->low) * (s->below / (s->below - s->above));
}

/* Whether the current step, otherwise acceptable, passes a join and must be repeated with s->size. */
static int em_passes_join(em_run_state *w, em_join_search *s) {
    const int uses = w->model->n_table_uses;
    double at[em_some(uses)], ahead[em_some(uses)], below, worst = 0.0, before = 0.0;
    if (s->aims >= EM_MOST_AIMS || em_table_arguments_of(w, w->mode, w->t, w->y, at)) return 0;
    if (em_table_arguments_of(w, w->mode_new, w->t_new, w->y_new, ahead)) return 0;
    for (int k = 0; k < uses; ++k) {
        const double above = em_distance_past_join(w, &w->model->table_uses[k], at[k], ahead[k], &below);
        if (above > 0.0 && above * before <= worst * below) worst = above, before = below, s->use = k;
    }
    if (!(worst > 0.0)) return 0;
    if (s->aims++ == 0) s->low = 0.0, s->side = 0;
    if (s->low == 0.0) s->below = before;
    em_next_join_size(s, fabs(w->h), worst);
    return s->size > 0.0;
}

#endif
