/* em_norms.h: the norms of multipliers that press on frictions, by number: em_switch.over is -2 less the number. */
#ifndef EM_NORMS_H
#define EM_NORMS_H

/* The number of the norm that presses on a friction; -1: none does. */
EM_COLD int em_norm_of(const em_switch *s) { return s->over < -1 ? -2 - s->over : -1; }

/* Whether a row is among those of a norm. */
EM_COLD int em_is_among(int norm, int row) {
#ifdef EM_NORMALS
    return normals[norm][row];
#else
    return (void)norm, (void)row, 0;
#endif
}

EM_COLD double em_norm_of_multipliers(int norm, const double *lambda) {
    double sum = 0.0;
    for (int row = 0; row < N_ROWS; ++row)
        if (em_is_among(norm, row)) sum = hypot(sum, lambda[row]);
    return sum;
}

/* The derivative of a norm along dlambda, of which rows are `width` apart; that of one side where it vanishes. */
EM_COLD double em_norm_along(int norm, const double *lambda, const double *dlambda, int width) {
    const double whole = em_norm_of_multipliers(norm, lambda);
    double sum = 0.0;
    for (int row = 0; row < N_ROWS; ++row) {
        const double part = dlambda[row * width];
        if (em_is_among(norm, row)) sum = whole > 0.0 ? sum + lambda[row] / whole * part : hypot(sum, part);
    }
    return sum;
}

#endif
