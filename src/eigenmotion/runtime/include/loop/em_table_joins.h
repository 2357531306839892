/* em_table_joins.h: steps that end where the pieces of a table join less smoothly than a step requires.
 *
 * A step that would pass a rough join ends just beyond it, so that the next step begins on its other side. If the
 * argument depends on time only, the step is shortened beforehand. Otherwise it is repeated with a size from the method
 * of false position (Illinois), but no size below the least: the spacing of times may be coarser than the interval
 * behind a join. Where a search ends on this side of the join, the tangent gives the next size. Joins at known times at
 * which the rates jump are time events (em_table_lookups.h). */
#ifndef EM_TABLE_JOINS_H
#define EM_TABLE_JOINS_H

#include "stepper/em_table_lookups.h"

enum { EM_MOST_AIMS = 20 };

#define EM_TANGENT_STEP 1e-7 /* of a step: the difference from which the rate of an argument is found */
#define EM_PART_OF_TANGENT 0.5
#define EM_PART_OF_RETURN 0.1

/* A search for the size of a step that ends at a join: a size that is too short and one that is too long, with the
 * signed distances of the argument from its goal; the size to try next. `tangent`: the tangent was tried. */
typedef struct em_join_search {
    double low, below, high, above, size;
    int aims, use, side, tangent;
} em_join_search;

/* The length of the interval behind a join in which steps may end; the goal is its middle. */
static double em_join_zone(const em_axis *axis, double join) {
    const double range = fabs(axis->knots[0]) + fabs(axis->knots[axis->count]);
    return 64.0 * DBL_EPSILON * (fabs(join) > range ? fabs(join) : range);
}

/* The distance of `to` from the goal at the first rough join after `from`, if `to` is too far; else 0. *below <- the
 * (negative) distance of `from`. The goal is in the zone behind the join, and steps are too far beyond the zone. Where
 * the rates jump, a step first ends in the zone before the join, with all its stages on this side; the next crosses. */
static double em_distance_past_join(const em_run_state *w, const em_table_use *use, double from, double to,
                                    double *below) {
    const double *const table = em_table_of_use(w->model, w->run->prepared, use), direction = to > from ? 1.0 : -1.0;
    const double jumping = table[10 + use->axis];
    if (!em_is_rough(use, jumping, EM_ROUGH) || !isfinite(to - from) || to == from) return 0.0;
    const em_axis axis = em_axis_of(table, use->axis);
    const double join = em_next_join(&axis, use, EM_ROUGH, (em_outside)(int)table[1] == EM_REPEATS, from, direction);
    const double zone = em_join_zone(&axis, join);
    const int stops = em_is_rough(use, jumping, EM_JUMPS_THERE) && direction * (join - from) > zone;
    const double goal = join + (stops ? -0.5 : 0.5) * direction * zone;
    if (!(direction * (to - join) > (stops ? 0.0 : zone))) return 0.0;
    *below = direction * (from - goal);
    return direction * (to - goal);
}

static int em_has_rough_tables(const em_run_state *w) {
    for (int k = 0; k < w->model->n_table_uses; ++k) {
        const em_table_use *const use = &w->model->table_uses[k];
        if (em_is_rough(use, em_table_of_use(w->model, w->run->prepared, use)[10 + use->axis], EM_ROUGH)) return 1;
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

/* The size of a step in which no argument passes a rough join, if its rate stays what it is. */
static double em_size_along_tangent(em_run_state *w, double size) {
    const int uses = w->model->n_table_uses;
    const double h = EM_TANGENT_STEP * w->direction * size;
    double at[em_some(uses)], ahead[em_some(uses)], y[w->width], below, least = 1.0;
    for (int k = 0; k < w->width; ++k) y[k] = w->y[k] + h * w->K[0][k];
    if (em_table_arguments_of(w, w->mode, w->t, w->y, at)) return size;
    if (em_table_arguments_of(w, w->mode, w->t + h, y, ahead)) return size;
    for (int k = 0; k < uses; ++k) {
        const double to = at[k] + (ahead[k] - at[k]) / EM_TANGENT_STEP;
        const double above = em_distance_past_join(w, &w->model->table_uses[k], at[k], to, &below);
        if (above > 0.0) least = em_min(least, below / (below - above));
    }
    return least * size;
}

/* The size of the first attempt: where the step before was searched for a join, and may have ended on this side, that
 * which the tangent gives. */
static double em_first_size_to_join(em_run_state *w, em_join_search *s, double size, double least) {
    const double most = em_size_to_join(w, size);
    const double along = w->seeks_join ? em_max(least, em_size_along_tangent(w, most)) : most;
    s->tangent = along < most;
    return along;
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

/* The least size to try in place of the current step, which passes a join, if no size is known that does not: the join
 * is either ahead, or the motion first leaves it and then comes back, and false position knows nothing of the way. */
static double em_least_size_to_join(em_run_state *w, double least) {
    const double size = fabs(w->h), along = em_size_along_tangent(w, size);
    return em_max(least, along < size ? EM_PART_OF_TANGENT * along : EM_PART_OF_RETURN * size);
}

/* Whether the current step, otherwise acceptable, passes a join and must be repeated with s->size. */
static int em_passes_join(em_run_state *w, em_join_search *s, double least) {
    const int uses = w->model->n_table_uses;
    double at[em_some(uses)], ahead[em_some(uses)], below, worst = 0.0, before = 0.0;
    if (s->aims >= EM_MOST_AIMS || fabs(w->h) <= 2.0 * least) return 0;
    if (em_table_arguments_of(w, w->mode, w->t, w->y, at)) return 0;
    if (em_table_arguments_of(w, w->mode_new, w->t_new, w->y_new, ahead)) return 0;
    for (int k = 0; k < uses; ++k) {
        const double above = em_distance_past_join(w, &w->model->table_uses[k], at[k], ahead[k], &below);
        if (above > 0.0 && above * before <= worst * below) worst = above, before = below, s->use = k;
    }
    if (!(worst > 0.0)) return 0;
    if (s->aims++ == 0) s->low = 0.0, s->side = 0;
    if (s->low == 0.0) s->below = before;
    em_next_join_size(s, fabs(w->h), worst);
    s->size = em_max(s->size, s->low > 0.0 ? least : em_least_size_to_join(w, least));
    return s->size > 0.0;
}

/* The size after an attempt whose error was too large, `size` by the error alone: where it passed a join, its error is
 * that of the join, and its end still tells about where that is. */
static double em_size_before_join(em_run_state *w, em_join_search *s, double size, double least) {
    w->mode_new = w->mode;
    return em_passes_join(w, s, least) ? s->size : size;
}

#endif
