/* em_reaction_rates.h: rates of first-order states that depend on multipliers, as that of a bristle under a reaction.
 *
 * A state is the velocity of a coordinate of unit mass that no row constrains and that no force depends on the rate of:
 * the multipliers do not depend on its rate, which is evaluated after them. */
#ifndef EM_REACTION_RATES_H
#define EM_REACTION_RATES_H

/* a (n) += the rates at lambda (m); their places in a are 0 before. */
EM_NOINLINE void em_add_reaction_rates(double t, const double *x, const double *v, const double *lambda, const double *c,
                                       const double *u, double *a) {
    double rate[EM_REACTION_RATES];
    reaction_rates(t, x, v, lambda, c, u, rate);
    for (int k = 0; k < EM_REACTION_RATES; ++k) a[reaction_states[k]] += rate[k];
}

/* da (n, columns) += what changes dlambda (m, columns) make of the rates; by: d rate / d lambda. */
EM_INLINE void em_add_changes_of_rates(int columns, const double *by, const double *dlambda, double *da) {
    for (int k = 0; k < EM_REACTION_RATES; ++k)
        for (int row = 0; row < N_ROWS; ++row)
            for (int j = 0; j < columns; ++j)
                da[reaction_states[k] * columns + j] += by[k * N_ROWS + row] * dlambda[row * columns + j];
}

#endif
