/* em_differentiate.h: Jacobians by central differences that find the size of their steps.
 *
 * Differences at three steps, each eight times the one before, extrapolate to sixth order; what those of fourth order
 * are apart, and rounding, are what an entry may be off. Neither the origin nor the unit of a coordinate says on which
 * length a rate varies, and a coordinate at 0 says nothing at all: so steps start from the size of the coordinate, and
 * get longer as long as rounding leaves more of an entry than the formula, or shorter. An entry is where it is off
 * least. That takes 7 to 12 right-hand sides a column, 2 for each further step: some 15 in the mean over models, up to
 * 90 where many coordinates are 0, from where the first step is a guess. */
#ifndef EM_DIFFERENTIATE_H
#define EM_DIFFERENTIATE_H

#include "em_linear.h"

enum { EM_LARGEST_RATE = N_STATE > 2 * N ? N_STATE : 2 * N, EM_STEP_RATIO = 8 };

/* rate (size) at z (size); what else it needs is behind `with`. */
typedef int em_rate(const void *with, double t, const double *z, double *rate, em_fault *fault);

/* What is differentiated, at z, where it is f, in which terms are rounded that may cancel; column k at present. */
typedef struct em_column {
    em_rate *rate;
    const void *with;
    int size, k;
    double t, z[EM_LARGEST_RATE], f[EM_LARGEST_RATE], rounding[EM_LARGEST_RATE];
} em_column;

/* Differences over one step; by how much rounding of f and z moves each, and whether f moved. */
typedef struct em_slopes {
    double slope[EM_LARGEST_RATE], rounding[EM_LARGEST_RATE];
    int moved[EM_LARGEST_RATE];
} em_slopes;

enum { EM_SHORTER = -1, EM_FOUND = 0, EM_LONGER = 1 };

/* One entry under way: the best so far, what it may be off, whether its steps agree, and where a better one may be. */
typedef struct em_entry {
    double value, error;
    int agrees, wanted, hidden; /* hidden: f moves in the distance, but not yet here */
} em_entry;

/* f at z + step e_k, or -1 where there is none. */
static int em_rate_beside(em_column *at, double step, double *f, em_fault *fault) {
    const double middle = at->z[at->k];
    at->z[at->k] = middle + step;
    int failed = at->rate(at->with, at->t, at->z, f, fault);
    for (int row = 0; row < at->size && !failed; ++row)
        if (!isfinite(f[row])) failed = em_fail(fault, EM_NON_FINITE_STATE, at->k % N, -1, 0.0);
    at->z[at->k] = middle;
    return failed;
}

EM_COLD int em_slopes_over(em_column *at, double step, em_slopes *over, em_fault *fault) {
    double up[EM_LARGEST_RATE], down[EM_LARGEST_RATE];
    const double z = at->z[at->k], high = z + step, low = z - step;
    if (em_rate_beside(at, step, up, fault) || em_rate_beside(at, -step, down, fault)) return -1;
    for (int row = 0; row < at->size; ++row) {
        const double slope = high > low ? (up[row] - down[row]) / (high - low) : 0.0;
        over->slope[row] = slope;
        const double size = fmax(fmax(fabs(up[row]), fabs(down[row])), fabs(slope * z));
        over->rounding[row] = fmax(at->rounding[row], DBL_EPSILON * size) / step;
        over->moved[row] = up[row] != at->f[row] || down[row] != at->f[row];
    }
    return 0;
}

/* What three steps, the shortest first, say of the entry in this row. */
EM_COLD void em_judge(const em_slopes over[3], int row, int direction, em_entry *entry) {
    const double enough = 1e-9, agreed = 1e-4, seen = 1e3, by_chance = 1e3, grown = 4.0;
    const double square = EM_STEP_RATIO * EM_STEP_RATIO;
    const double near = over[0].slope[row] + (over[0].slope[row] - over[1].slope[row]) / (square - 1.0);
    const double far = over[1].slope[row] + (over[1].slope[row] - over[2].slope[row]) / (square - 1.0);
    const double value = near + (near - far) / (square * square - 1.0), apart = fabs(near - far);
    const double rounding = over[0].rounding[row], error = apart + rounding, size = fabs(value);
    const int moved = over[2].moved[row], agrees = apart <= agreed * size && seen * rounding <= size;
    if (entry->wanted != direction || !moved) return;
    const int lost = entry->agrees && (!agrees || error > grown * entry->error);
    const int fresh = direction == EM_FOUND || entry->hidden;
    if (agrees > entry->agrees || (agrees == entry->agrees && error < entry->error))
        *entry = (em_entry){.value = value, .error = error, .agrees = agrees};
    const int longer = apart <= by_chance * rounding && over[2].rounding[row] < rounding;
    const int wanted = longer ? EM_LONGER : EM_SHORTER, found = entry->error <= enough * fabs(entry->value);
    entry->hidden = 0;
    entry->wanted = !found && !lost && error > 0.0 && (fresh || wanted == direction) ? wanted : EM_FOUND;
}

/* Judges all entries. Returns whether one of them is looked for in this direction. */
EM_COLD int em_judge_all(const em_column *at, const em_slopes over[3], int direction, em_entry *entries) {
    for (int row = 0; row < at->size; ++row) em_judge(over, row, direction, &entries[row]);
    for (int row = 0; row < at->size; ++row)
        if (direction && entries[row].wanted == direction) return 1;
    return 0;
}

/* Three steps from `first` on; shorter ones where f does not exist. */
static int em_first_slopes(em_column *at, double *first, double least, em_slopes over[3], em_fault *fault) {
    for (; *first >= least; *first /= EM_STEP_RATIO) {
        double step = *first;
        int failed = 0;
        for (int k = 0; k < 3 && !failed; ++k, step *= EM_STEP_RATIO)
            failed = em_slopes_over(at, step, &over[k], fault);
        if (!failed) return 0;
    }
    return -1;
}

/* Entries that did not move: whether f does in the distance, as far as it exists. */
EM_COLD void em_look_far(em_column *at, double step, const int *moved, em_entry *entries) {
    double f[EM_LARGEST_RATE];
    em_fault fault;
    int power = 90;
    while (power > 0 && em_rate_beside(at, ldexp(step, power), f, &fault)) power -= 30;
    for (int row = 0; row < at->size && power > 0; ++row)
        if (!moved[row] && f[row] != at->f[row])
            entries[row] = (em_entry){.error = INFINITY, .wanted = EM_LONGER, .hidden = 1};
}

/* Steps in this direction as long as they are of use. over: those at `first`. */
EM_COLD void em_walk_steps(em_column *at, const em_slopes first_over[3], double first, double least, int direction,
                           em_entry *entries) {
    enum { MOST = 40 };
    em_slopes over[3];
    em_fault fault;
    double step = direction == EM_LONGER ? first * EM_STEP_RATIO * EM_STEP_RATIO : first;
    memcpy(over, first_over, sizeof over);
    int more = 0;
    for (int row = 0; row < at->size; ++row) more |= entries[row].wanted == direction;
    for (int tried = 0; more && tried < MOST; ++tried) {
        const int longer = direction == EM_LONGER;
        step = longer ? step * EM_STEP_RATIO : step / EM_STEP_RATIO;
        memmove(longer ? over : over + 1, longer ? over + 1 : over, 2 * sizeof *over);
        if (step < least || em_slopes_over(at, step, longer ? &over[2] : &over[0], &fault)) return;
        more = em_judge_all(at, over, direction, entries);
    }
}

/* The entries of one column. */
EM_COLD int em_differentiate_column(em_column *at, em_entry *entries, em_fault *fault) {
    em_slopes over[3];
    int exponent = 0;
    const double z = at->z[at->k];
    if (z != 0.0) frexp(z, &exponent);
    double first = ldexp(1.0, exponent - 12);
    const double least = ldexp(1.0, exponent - (z != 0.0 ? 40 : 120));
    for (int row = 0; row < at->size; ++row) entries[row] = (em_entry){.error = INFINITY};
    if (em_first_slopes(at, &first, least, over, fault)) return -1;
    em_judge_all(at, over, EM_FOUND, entries);
    em_look_far(at, first, over[2].moved, entries);
    em_walk_steps(at, over, first, least, EM_LONGER, entries);
    em_walk_steps(at, over, first, least, EM_SHORTER, entries);
    return 0;
}

/* f may be a small difference of large terms: what it moves by when all of z do in their last digits tells how they
 * are rounded. */
EM_COLD void em_find_rounding(em_column *at, const double *z) {
    enum { TRIALS = 4 };
    double f[EM_LARGEST_RATE];
    em_fault fault;
    for (int trial = 0; trial < TRIALS; ++trial) {
        for (int k = 0; k < at->size; ++k) at->z[k] = z[k] * (1.0 + (k >> trial & 1 ? 2.0 : -2.0) * DBL_EPSILON);
        if (at->rate(at->with, at->t, at->z, f, &fault)) continue;
        for (int row = 0; row < at->size; ++row) {
            const double moved = fabs(f[row] - at->f[row]);
            if (moved > at->rounding[row] && isfinite(moved)) at->rounding[row] = moved;
        }
    }
    memcpy(at->z, z, (size_t)at->size * sizeof *z);
}

/* J (size, size) = d rate / d z. Entries that all steps leave at 0 are 0. */
EM_COLD int em_differentiate(em_rate *rate, const void *with, int size, double t, const double *z, double *J,
                             em_fault *fault) {
    em_column at = {rate, with, size, 0, t, {0.0}, {0.0}, {0.0}};
    em_entry entries[EM_LARGEST_RATE];
    if (rate(with, t, z, at.f, fault)) return -1;
    em_find_rounding(&at, z);
    for (at.k = 0; at.k < size; ++at.k) {
        if (em_differentiate_column(&at, entries, fault)) return -1;
        for (int row = 0; row < size; ++row) J[row * size + at.k] = entries[row].value;
    }
    return 0;
}

#endif
