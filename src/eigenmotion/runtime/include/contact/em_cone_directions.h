/* em_cone_directions.h: the direction in which each friction cone begins to slide: w = beta d, by Newton's method on
 * the angles of d.
 *
 * The force -L d of a cone determines w, and w must have the direction of d. */
#ifndef EM_CONE_DIRECTIONS_H
#define EM_CONE_DIRECTIONS_H

#define EM_TWO_PI 6.283185307179586

enum { EM_DIRECTIONS = 8, EM_DIRECTION_STEPS = 40, EM_RELAXATIONS = 100 };

/* Whether the force of a cone has reached its limit. */
EM_NOINLINE int em_has_last(const em_mixed *s, int i) { return s->last[i] != 0.0 || s->last[i + 1] != 0.0; }

/* Lists the cones that slide in this mode by their first rows. Returns their number. */
EM_NOINLINE int em_sliding_cones(const em_mixed *s, int *cones) {
    int count = 0;
    for (int i = 0; i < s->k; ++i)
        if (s->kind[i] == EM_ROW_CONE && s->choice[i] == EM_FORWARD && !em_is_unloaded(s, i)) cones[count++] = i;
    return count;
}

/* off (count) <- the angles from d to w if d has these angles. Returns the largest, or -1: the mode's rows are
 * dependent. */
EM_NOINLINE double em_slip_direction_errors(em_mixed *s, int count, const int *cones, const double *angle, double *off) {
    double largest = 0.0;
    for (int c = 0; c < count; ++c) s->side[cones[c]] = cos(angle[c]), s->side[cones[c] + 1] = sin(angle[c]);
    if (em_forces_of_mode(s)) return -1.0;
    em_rates_of_mode(s);
    for (int c = 0; c < count; ++c) {
        const double *const d = s->side + cones[c], *const w = s->w + cones[c];
        off[c] = atan2(d[0] * w[1] - d[1] * w[0], d[0] * w[0] + d[1] * w[1]);
        largest = fmax(largest, fabs(off[c]));
    }
    return largest;
}

/* step (count) <- Newton's step, with a Jacobian by finite differences. 0, or -1. */
EM_NOINLINE int em_direction_step(em_mixed *s, int count, const int *cones, const double *angle, const double *off, double *step) {
    double A[EM_MIXED_ROWS * EM_MIXED_ROWS], near[EM_MIXED_ROWS], there[EM_MIXED_ROWS];
    const double apart = 1e-7;
    for (int c = 0; c < count; ++c) {
        memcpy(near, angle, count * sizeof *near);
        near[c] += apart;
        if (em_slip_direction_errors(s, count, cones, near, there) < 0.0) return -1;
        for (int i = 0; i < count; ++i) A[i * count + c] = remainder(there[i] - off[i], EM_TWO_PI) / apart;
    }
    for (int c = 0; c < count; ++c) step[c] = -off[c];
    int sign;
    return em_solve_completely(count, A, step, EM_MODE_RANK, &sign);
}

/* Newton's iteration from these angles. Returns whether it converged. */
EM_NOINLINE int em_iterate_directions(em_mixed *s, int count, const int *cones, double *angle) {
    double off[EM_MIXED_ROWS], step[EM_MIXED_ROWS], next[EM_MIXED_ROWS], then[EM_MIXED_ROWS];
    double size = em_slip_direction_errors(s, count, cones, angle, off);
    for (int k = 0; k < EM_DIRECTION_STEPS && size > 4.0 * DBL_EPSILON; ++k) {
        if (size < 0.0 || em_direction_step(s, count, cones, angle, off, step)) return 0;
        double part = 1.0, after = INFINITY;
        for (; part > 1e-3; part *= 0.5) {
            for (int c = 0; c < count; ++c) next[c] = angle[c] + part * fmax(-1.0, fmin(1.0, step[c]));
            after = em_slip_direction_errors(s, count, cones, next, then);
            if (after >= 0.0 && after < size) break;
        }
        if (!(after >= 0.0 && after < size)) break;
        size = after;
        memcpy(angle, next, count * sizeof *next), memcpy(off, then, count * sizeof *then);
    }
    em_slip_direction_errors(s, count, cones, angle, off);
    return size >= 0.0 && size < 1e-9;
}

/* Lists the sliding cones whose direction is unknown; that of the others is opposite to their last force, and is set
 * here. Returns their number. */
EM_NOINLINE int em_unknown_directions(em_mixed *s, int *cones) {
    int all[EM_MIXED_ROWS], count = 0;
    const int slide = em_sliding_cones(s, all);
    for (int c = 0; c < slide; ++c) {
        const int i = all[c];
        if (!s->by_last || !em_has_last(s, i)) cones[count++] = i;
        else s->side[i] = s->last[i], s->side[i + 1] = s->last[i + 1];
    }
    return count;
}

/* angle (count) <- of w without the forces of the cones. 0, or -1. */
EM_NOINLINE int em_directions_without_friction(em_mixed *s, int count, const int *cones, double *angle) {
    for (int c = 0; c < count; ++c) s->side[cones[c]] = s->side[cones[c] + 1] = 0.0;
    if (em_forces_of_mode(s)) return -1;
    em_rates_of_mode(s);
    for (int c = 0; c < count; ++c) angle[c] = atan2(s->w[cones[c] + 1], s->w[cones[c]]);
    return 0;
}

/* angle (count) <- by relaxation: forces follow the slip within their limits (Moreau's proximal form). 0, or -1. */
EM_NOINLINE int em_relax_directions(em_mixed *s, int count, const int *cones, double *angle) {
    const double part = 0.5 / count;
    for (int c = 0; c < count; ++c) s->side[cones[c]] = s->side[cones[c] + 1] = 0.0;
    for (int k = 0; k < EM_RELAXATIONS; ++k) {
        if (em_forces_of_mode(s)) return -1;
        em_rates_of_mode(s);
        for (int c = 0; c < count; ++c) {
            double *const d = s->side + cones[c], *const w = s->w + cones[c], limit = em_limit_of_row(s, cones[c], 0);
            const double x = d[0] * limit + part * w[0], y = d[1] * limit + part * w[1], size = fmax(hypot(x, y), limit);
            d[0] = size > 0.0 ? x / size : 0.0, d[1] = size > 0.0 ? y / size : 0.0;
        }
    }
    for (int c = 0; c < count; ++c) angle[c] = atan2(s->side[cones[c] + 1], s->side[cones[c]]);
    return 0;
}

/* angle (count) <- initial guess number `start`; the guesses fill all angles evenly, by powers of an irrational
 * number. */
EM_NOINLINE void em_initial_directions(int start, int count, const double *first, double *angle) {
    const double root = 1.0 / pow(2.0, 1.0 / (count + 1));
    double step = root;
    for (int c = 0; c < count; ++c, step *= root) angle[c] = first[c] + EM_TWO_PI * fmod(start * step, 1.0);
}

/* side of the sliding cones <- their directions: by relaxation first, then from the directions without friction,
 * then from guesses over all angles. 0, or -1: not found. */
EM_NOINLINE int em_find_directions(em_mixed *s) {
    int cones[EM_MIXED_ROWS];
    double first[EM_MIXED_ROWS], angle[EM_MIXED_ROWS];
    const int count = em_unknown_directions(s, cones), starts = count > 1 ? EM_DIRECTIONS * EM_DIRECTIONS : EM_DIRECTIONS;
    if (count == 0) return 0;
    if (em_directions_without_friction(s, count, cones, first)) return -1;
    for (int start = -1; start < starts; ++start) {
        if (start < 0 && em_relax_directions(s, count, cones, angle)) continue;
        if (start >= 0) em_initial_directions(start, count, first, angle);
        if (em_iterate_directions(s, count, cones, angle)) return 0;
    }
    return -1;
}

#endif
