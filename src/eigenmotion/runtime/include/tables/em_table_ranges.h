/* em_table_ranges.h: the ranges of a model's tables, and the check of arguments against them. */
#ifndef EM_TABLE_RANGES_H
#define EM_TABLE_RANGES_H

#include "eigenmotion.h"
#include "tables/em_table.h"

/* The data of the table that an argument belongs to, for a parameter set c. */
static const double *em_table_of_use(const em_model *model, const double *c, const em_table_use *use) {
    const em_table *const table = &model->tables[use->table];
    return em_table_at(c[table->parameter], table->numbers);
}

/* The distance of an argument beyond one end of the range of its table, the lower (side < 0) or the upper: positive
 * outside, negative inside; -INFINITY if the table allows extrapolation. */
static double em_table_excess(const em_model *model, const double *c, const em_table_use *use, int side,
                              double argument) {
    const double *const table = em_table_of_use(model, c, use);
    const em_axis axis = em_axis_of(table, use->axis);
    if ((em_outside)(int)table[1] != EM_REFUSES) return -INFINITY;
    return side < 0 ? axis.knots[0] - argument : argument - axis.knots[axis.count];
}

/* Whether one of the arguments `at` (n_table_uses) is outside of the range of its table; then *fault names it. */
EM_UNUSED static int em_outside_tables(const em_model *model, const double *c, const double *at, em_fault *fault) {
    for (int k = 0; k < model->n_table_uses; ++k) {
        const em_table_use *const use = &model->table_uses[k];
        if (!(em_table_excess(model, c, use, -1, at[k]) > 0.0 || em_table_excess(model, c, use, 1, at[k]) > 0.0)) continue;
        *fault = (em_fault){EM_OUTSIDE_TABLE, use->table, -1, at[k]};
        return 1;
    }
    return 0;
}

#endif
