/* em_norm_friction.h: friction limits proportional to norms of multipliers, within the complementarity problem.
 *
 * The norm is homogeneous of degree one, so that a step of Newton's method is a solution at a known direction
 * (em_norm_multipliers.h). The iteration begins without these frictions, so that its result is a function of the
 * state alone. */
#ifndef EM_NORM_FRICTION_H
#define EM_NORM_FRICTION_H

/* The norm that is the normal force of a friction; -1: none. Norms are numbered, and em_switch.over is -2 less the
 * number. */
EM_NOINLINE int em_norm_of(const em_switch *s) { return s->over < -1 ? -2 - s->over : -1; }

/* Whether a row belongs to a norm. */
EM_NOINLINE int em_is_in_norm(int norm, int row) {
#ifdef EM_NORMALS
    return normals[norm][row];
#else
    return (void)norm, (void)row, 0;
#endif
}

EM_NOINLINE double em_norm_of_multipliers(int norm, const double *lambda) {
    double sum = 0.0;
    for (int row = 0; row < N_ROWS; ++row)
        if (em_is_in_norm(norm, row)) sum = hypot(sum, lambda[row]);
    return sum;
}

/* The derivative of a norm along dlambda, whose rows are `width` apart; the one-sided derivative where the norm
 * vanishes. */
EM_NOINLINE double em_norm_along(int norm, const double *lambda, const double *dlambda, int width) {
    const double whole = em_norm_of_multipliers(norm, lambda);
    double sum = 0.0;
    for (int row = 0; row < N_ROWS; ++row) {
        const double part = dlambda[row * width];
        if (em_is_in_norm(norm, row)) sum = whole > 0.0 ? sum + lambda[row] / whole * part : hypot(sum, part);
    }
    return sum;
}

#define EM_NORM_TOLERANCE 1e-9 /* bound on the change of a direction: its square is the remaining error */

EM_NOINLINE int em_any_rooted(const em_mixed *s) {
    int some = 0;
    for (int i = 0; i < s->k; ++i) some |= s->rooted[i];
    return some;
}

/* gradient <- of the norms at p. Returns the largest change, over rooted rows at their limit. */
EM_NOINLINE double em_update_norm_gradients(em_mixed *s) {
    const int k = s->k;
    double change = 0.0;
    for (int f = 0; f < k; ++f) {
        if (!s->rooted[f]) continue;
        const double whole = em_normal_force(s, f);
        for (int j = 0; j < k; ++j) {
            const double over = s->over[f * k + j], part = over * (s->p[j] + s->known_p[j]);
            const double now = whole > 0.0 ? over * (part / whole) : 0.0;
            if (em_limit_sign(s, f) != 0.0 && over > 0.0)
                change = fmax(change, fabs(now - s->gradient[f * k + j]) / over);
            s->gradient[f * k + j] = now;
        }
    }
    return change;
}

/* p <- of the mode without resting rows. 0, or -1: its rows are dependent, or friction jams. */
EM_NOINLINE int em_forces_of_independent(em_mixed *s) {
    enum { STEPS = 50 };
    for (int i = 0; i < s->k * s->k; ++i) s->gradient[i] = s->rooted[i / s->k] ? 0.0 : s->over[i];
    for (int step = 0, first = 0; step < STEPS; ++step) {
        int sign;
        if (em_forces_linearised(s, &sign) || sign * first < 0) return -1;
        first = sign;
        if (em_update_norm_gradients(s) <= EM_NORM_TOLERANCE) return 0;
    }
    return -1;
}

/* The same for all rows; if some are dependent and cones stick, for independent rows, while the others rest. */
EM_NOINLINE int em_forces_of_mode(em_mixed *s) {
    double Z[EM_MIXED_ROWS * EM_MIXED_ROWS];
    int basic[EM_MIXED_ROWS];
    memset(s->rests, 0, sizeof s->rests);
    if (em_forces_of_independent(s) == 0) return 0;
    if (!em_any_cone_sticks(s) || em_vanishing_forces(s, Z, basic) == 0) return -1;
    for (int i = 0; i < s->k; ++i) s->rests[i] = em_row_holds(s, i) && !basic[i];
    return em_forces_of_independent(s);
}

EM_NOINLINE int em_any_rests(const em_mixed *s) {
    int some = 0;
    for (int i = 0; i < s->k; ++i) some |= s->rests[i];
    return some;
}

/* Whether resting rows hold although they have no force, here and nearby; if so, p <- shared with them. */
EM_NOINLINE int em_share_with_resting(em_mixed *s, double terms) {
    for (int i = 0; i < s->k; ++i)
        if (s->rests[i] && !(fabs(s->w[i]) <= EM_MODE_VERIFIED * terms)) return 0;
    return (s->follow_nearby == NULL || s->follow_nearby(s->where, s)) && em_share(s) == 0;
}

#endif
