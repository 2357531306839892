/* em_differentiate.h: Jacobians by central differences that find the size of their steps.
 *
 * Neither the origin nor the unit of a coordinate says on which length a rate varies, and a coordinate at 0 says
 * nothing at all. So steps grow from where rounding hides the difference, and an entry is what three steps in a row
 * agree on, as long as a longer one, less hurt by rounding, agrees better. Beyond that length it does not. */
#ifndef EM_DIFFERENTIATE_H
#define EM_DIFFERENTIATE_H

#include "em_linear.h"

enum { EM_LARGEST_RATE = N_STATE > 2 * N ? N_STATE : 2 * N };

/* rate (size) at z (size); what else it needs is behind `with`. */
typedef int em_rate(const void *with, double t, const double *z, double *rate, em_fault *fault);

/* One entry under way. */
typedef struct em_entry {
    double value, error;    /* the best so far; what it may be off, first by rounding and then by the steps beside it */
    double last;            /* by the step before */
    int agreeing, done;     /* how many in a row agree with the one before */
} em_entry;

/* From f at -2, -1, 1, 2 steps about z: the difference of fourth order, right to the square of what sets those of
 * second order apart. Rounding and then the formula keep steps from agreeing, too short and too long ones. */
EM_COLD void em_see_step(em_entry *entry, const double f[4], double z, double step) {
    const double agreed = 1e-5, enough = 1e-11;
    const double near = (f[2] - f[1]) / (2.0 * step), far = (f[3] - f[0]) / (4.0 * step);
    const double value = near + (near - far) / 3.0, size = fabs(value), apart = fabs(near - far);
    const double doubt = fmax(apart, fabs(value - entry->last));
    const double rounding = DBL_EPSILON * fmax(fmax(fabs(f[0]), fabs(f[3])), fabs(value * z)) / step;
    const int agrees = size > 0.0 && doubt <= agreed * size, found = entry->agreeing >= 2;
    entry->last = value;
    entry->agreeing = agrees ? entry->agreeing + 1 : 0;
    entry->done = rounding == 0.0 || (found && !agrees) || (entry->agreeing >= 2 && doubt <= enough * size);
    if (found && !agrees) return;
    const double error = entry->agreeing >= 2 ? doubt : apart + rounding;
    if (error >= entry->error && entry->agreeing != 2) return;
    entry->value = value;
    entry->error = error;
}

/* The entries (size) of column k with one step more. Returns whether longer ones are worth while. */
static int em_try_step(em_rate *rate, const void *with, int size, double t, double *z, int k, double step,
                       em_entry *entries) {
    static const double at[4] = {-2.0, -1.0, 1.0, 2.0};
    double f[4][EM_LARGEST_RATE] = {{0.0}};
    const double middle = z[k];
    int failed = 0, more = 0;
    for (int point = 0; point < 4 && !failed; ++point) {
        em_fault fault;
        z[k] = middle + at[point] * step;
        failed = rate(with, t, z, f[point], &fault);
        for (int row = 0; row < size && !failed; ++row) failed = !isfinite(f[point][row]);
    }
    z[k] = middle;
    for (int row = 0; row < size && !failed; ++row) {
        const double values[4] = {f[0][row], f[1][row], f[2][row], f[3][row]};
        if (!entries[row].done) em_see_step(&entries[row], values, middle, step);
        more |= !entries[row].done;
    }
    return more;
}

/* J (size, size) = d rate / d z. Entries that all steps leave at 0 are 0. */
EM_COLD int em_differentiate(em_rate *rate, const void *with, int size, double t, const double *z, double *J,
                             em_fault *fault) {
    enum { RATIO = 32, STEPS = 24, STEPS_FROM_ZERO = 48 };
    double moved[EM_LARGEST_RATE], f[EM_LARGEST_RATE] = {0.0};
    if (rate(with, t, z, f, fault)) return -1;
    memcpy(moved, z, (size_t)size * sizeof *z);
    for (int k = 0; k < size; ++k) {
        em_entry entries[EM_LARGEST_RATE];
        for (int row = 0; row < size; ++row) entries[row] = (em_entry){.error = INFINITY};
        const int at_zero = z[k] == 0.0, most = at_zero ? STEPS_FROM_ZERO : STEPS;
        double step = at_zero ? ldexp(1.0, -120) : ldexp(fabs(z[k]), -40);
        for (int tried = 0; tried < most; ++tried, step *= RATIO)
            if (!em_try_step(rate, with, size, t, moved, k, step, entries)) break;
        for (int row = 0; row < size; ++row) J[row * size + k] = entries[row].value;
    }
    return 0;
}

#endif
