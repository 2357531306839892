/* em_complementarity.h: the mixed linear complementarity problem of contacts and frictions, solved by enumeration or
 * by pivoting.
 *
 *     w = q + G p      G (k, k) = B B^T; p the forces along the rows, w the accelerations (or velocities after an impact)
 *
 *     free row        w = 0
 *     contact         p >= 0, w >= 0, p w = 0
 *     friction        |p| <= L; p = -L where w > 0, p = L where w < 0
 *     cone            two rows: |p| <= L; p = -L d where w = beta d, beta > 0, |d| = 1
 *     sliding         p = -side L (of a cone two rows, side their direction)
 *
 * with L = level + coefficient (over . p), over (k) of the rows of the normal force, or for a rooted row the root of
 * the sum of the squares of these terms (em_norm_friction.h). A mode states for every row which of these conditions
 * holds as an equation. Each mode is one linear system, and its solution is verified by the inequalities. If rows
 * are dependent the forces are not unique: the modes tried are basic solutions, in which the rows with unbounded
 * forces are independent; or, if cones stick, all rows with shared forces (em_force_sharing.h).
 *
 * If several modes are consistent (Painleve), the result is the one that changes the fewest of the initial choices, and
 * among those the first in the order of rows. Of many rows one change at most is tried before pivoting,
 * whose result may be far from these choices: frictions that begin to slide together, one event after the other, would
 * stick again at each. If no mode is consistent, `clash` has the conditions that conflict. */
#ifndef EM_COMPLEMENTARITY_H
#define EM_COMPLEMENTARITY_H

#include "numeric/em_complete_pivoting.h"

#ifndef EM_MIXED_ROWS
#define EM_MIXED_ROWS EM_IMPACT_ROWS
#endif

#define EM_MODE_RANK 1e-11 /* of rows of length one: the pivot below which the rows of a mode count as dependent */

#define EM_MODE_EXACT (64.0 * DBL_EPSILON) /* the part of its terms by which rounding may violate a condition, */
#define EM_MODE_VERIFIED 1e-10 /* and the allowed violation if no mode is better */

enum { EM_ENUMERATED = 8, EM_MOST_TRIED = 200000 }; /* up to so many rows modes are enumerated before pivoting; modes
                                                       tried before giving up */

/* The second row of a cone is EM_ROW_CONE_SECOND, after the first; their choice is the same. */
typedef enum em_row_kind {
    EM_ROW_OUT, EM_ROW_FREE, EM_ROW_CONTACT, EM_ROW_FRICTION, EM_ROW_CONE, EM_ROW_CONE_SECOND, EM_ROW_SLIDES
} em_row_kind;

/* EM_HOLDS_ROW: w = 0. Of a contact EM_OPENS: p = 0. Of a friction EM_FORWARD: p = -L, w >= 0; EM_BACK: p = L, w <=
 * 0; EM_IDLES: p = 0 and w = 0, because rows that hold keep it at rest. */
typedef enum em_row_choice { EM_OPENS = 0, EM_HOLDS_ROW, EM_FORWARD, EM_BACK, EM_NO_CHOICE, EM_IDLES } em_row_choice;

typedef struct em_mixed em_mixed;

struct em_mixed {
    int k;
    em_row_kind kind[EM_MIXED_ROWS];
    em_row_choice choice[EM_MIXED_ROWS];
    em_row_choice barred[EM_MIXED_ROWS]; /* choices that are taken only if nothing else is consistent */
    double over[EM_MIXED_ROWS * EM_MIXED_ROWS]; /* row i: the linear form of p that its limit is proportional to */
    double gradient[EM_MIXED_ROWS * EM_MIXED_ROWS]; /* its derivative with respect to p */
    int rooted[EM_MIXED_ROWS];
    double last[EM_MIXED_ROWS];       /* of a cone whose force has reached its limit: the direction opposite to it,
                                         else 0 */
    int by_last;                      /* whether such cones slide in that direction */
    int rests[EM_MIXED_ROWS];         /* rows that hold because others do; their force in a basic solution is zero */
    double known_p[EM_MIXED_ROWS];    /* known forces that are added to p in the norms of rooted rows */
    double level[EM_MIXED_ROWS], at_rest[EM_MIXED_ROWS];    /* of the limit of sliding, and of sticking */
    double coefficient[EM_MIXED_ROWS], coefficient_at_rest[EM_MIXED_ROWS], side[EM_MIXED_ROWS];
    double G[EM_MIXED_ROWS * EM_MIXED_ROWS], q[EM_MIXED_ROWS];
    double size[EM_MIXED_ROWS];       /* the sum of the magnitudes of the terms in q */
    double p[EM_MIXED_ROWS + 1], w[EM_MIXED_ROWS + 1]; /* one more, because compilers assume that any row may be the
                                                          first of a cone */
    double tolerance, unit[EM_MIXED_ROWS], least; /* 1 / length of each row; the smallest violation of any mode */
    int clash[2], tried;              /* rows whose conditions are violated in the closest modes */
    int (*follow_nearby)(const void *where, const em_mixed *s); /* whether resting rows follow from others at
                                                                   neighbouring positions, too; or NULL */
    const void *where;
};

EM_NOINLINE int em_is_choice_row(const em_mixed *s, int i) {
    return s->kind[i] == EM_ROW_CONTACT || s->kind[i] == EM_ROW_FRICTION || s->kind[i] == EM_ROW_CONE;
}

/* Whether a friction is without load: its contacts are open, so that it has no force and no condition. */
EM_NOINLINE int em_is_unloaded(const em_mixed *s, int i) {
    int presses = 0;
    if (s->kind[i] < EM_ROW_FRICTION || s->level[i] != 0.0) return 0;
    for (int j = 0; j < s->k; ++j) {
        if (s->over[i * s->k + j] == 0.0) continue;
        presses = 1;
        if (s->kind[j] != EM_ROW_OUT && (s->kind[j] != EM_ROW_CONTACT || s->choice[j] != EM_OPENS)) return 0;
    }
    return presses;
}

EM_NOINLINE int em_row_holds(const em_mixed *s, int i) {
    if (s->kind[i] == EM_ROW_FREE) return 1;
    if (s->kind[i] == EM_ROW_CONE_SECOND) return em_row_holds(s, i - 1);
    return em_is_choice_row(s, i) && s->choice[i] == EM_HOLDS_ROW && !em_is_unloaded(s, i);
}

/* The sign of p / L of a row at its limit: -1 forward, 1 back, 0: it is not at its limit. */
EM_NOINLINE double em_limit_sign(const em_mixed *s, int i) {
    if (em_is_unloaded(s, i)) return 0.0;
    if (s->kind[i] == EM_ROW_SLIDES) return -s->side[i];
    if (s->kind[i] == EM_ROW_CONE || s->kind[i] == EM_ROW_CONE_SECOND)
        return s->choice[s->kind[i] == EM_ROW_CONE ? i : i - 1] == EM_FORWARD ? -s->side[i] : 0.0;
    if (s->kind[i] != EM_ROW_FRICTION) return 0.0;
    return s->choice[i] == EM_FORWARD ? -1.0 : s->choice[i] == EM_BACK ? 1.0 : 0.0;
}

/* The normal force of row i. */
EM_NOINLINE double em_normal_force(const em_mixed *s, int i) {
    double sum = 0.0;
    for (int j = 0; j < s->k; ++j) {
        const double over = s->over[i * s->k + j];
        sum = s->rooted[i] ? hypot(sum, over * (s->p[j] + s->known_p[j])) : sum + over * s->p[j];
    }
    return sum;
}

/* The part of it that comes from known_p, at the current direction of the norm. */
EM_NOINLINE double em_known_normal_force(const em_mixed *s, int i) {
    double sum = 0.0;
    for (int j = 0; j < s->k && s->rooted[i]; ++j) sum += s->gradient[i * s->k + j] * s->known_p[j];
    return sum;
}

EM_NOINLINE double em_limit_of_row(const em_mixed *s, int i, int at_rest) {
    const double normal = fmax(em_normal_force(s, i), 0.0);
    return at_rest ? s->at_rest[i] + s->coefficient_at_rest[i] * normal : s->level[i] + s->coefficient[i] * normal;
}

/* p <- of the mode with limits linearised by `gradient`. 0, or -1: its rows are dependent. */
EM_NOINLINE int em_forces_linearised(em_mixed *s, int *sign_of_all) {
    const int k = s->k;
    int rows[EM_MIXED_ROWS], count = 0;
    double A[EM_MIXED_ROWS * EM_MIXED_ROWS], x[EM_MIXED_ROWS];
    for (int i = 0; i < k; ++i) {
        s->p[i] = 0.0;
        if (em_row_holds(s, i) && !s->rests[i]) rows[count++] = i;
    }
    for (int i = 0; i < count; ++i) {
        x[i] = -s->q[rows[i]];
        for (int j = 0; j < count; ++j) A[i * count + j] = s->G[rows[i] * k + rows[j]];
        for (int f = 0; f < k; ++f) {
            const double sign = em_limit_sign(s, f);
            if (sign == 0.0) continue;
            x[i] -= sign * (s->level[f] + s->coefficient[f] * em_known_normal_force(s, f)) * s->G[rows[i] * k + f];
            for (int j = 0; j < count; ++j)
                A[i * count + j] += sign * s->coefficient[f] * s->gradient[f * k + rows[j]] * s->G[rows[i] * k + f];
        }
    }
    if (em_solve_completely(count, A, x, EM_MODE_RANK, sign_of_all)) return -1;
    for (int i = 0; i < count; ++i) s->p[rows[i]] = x[i];
    for (int f = 0; f < k; ++f) {
        const double sign = em_limit_sign(s, f);
        double presses = em_known_normal_force(s, f);
        for (int j = 0; j < k && sign != 0.0; ++j) presses += s->gradient[f * k + j] * s->p[j];
        if (sign != 0.0) s->p[f] = sign * (s->level[f] + s->coefficient[f] * presses);
    }
    return 0;
}

#include "contact/em_force_sharing.h"

#include "contact/em_norm_friction.h"

/* w <- q + G p. Returns the largest of the sums of magnitudes in it. */
EM_NOINLINE double em_rates_of_mode(em_mixed *s) {
    double largest = 0.0;
    for (int i = 0; i < s->k; ++i) {
        double terms = s->size[i];
        s->w[i] = s->q[i];
        for (int j = 0; j < s->k && s->kind[i] != EM_ROW_OUT; ++j) {
            const double part = s->G[i * s->k + j] * s->p[j];
            s->w[i] += part, terms += fabs(part);
        }
        if (s->kind[i] != EM_ROW_OUT) largest = fmax(largest, terms);
    }
    return largest;
}

/* By how much a cone violates its conditions: a force above its limit, or a slip that is not opposite to the force. */
EM_NOINLINE double em_cone_violation(const em_mixed *s, int i) {
    const double *const d = s->side + i, *const w = s->w + i;
    if (s->choice[i] == EM_HOLDS_ROW) return hypot(s->p[i], s->p[i + 1]) - em_limit_of_row(s, i, 1);
    return fmax(-(d[0] * w[0] + d[1] * w[1]), fabs(d[0] * w[1] - d[1] * w[0]));
}

/* By how much row i violates the inequality of its mode. */
EM_NOINLINE double em_violation(const em_mixed *s, int i) {
    if (!em_is_choice_row(s, i) || em_is_unloaded(s, i)) return 0.0;
    if (s->kind[i] == EM_ROW_CONTACT) return s->choice[i] == EM_HOLDS_ROW ? -s->p[i] : -s->w[i];
    if (s->kind[i] == EM_ROW_CONE) return em_cone_violation(s, i);
    if (s->choice[i] == EM_HOLDS_ROW) return fabs(s->p[i]) - em_limit_of_row(s, i, 1);
    if (s->choice[i] == EM_IDLES) return fabs(s->w[i]);
    return s->choice[i] == EM_FORWARD ? -s->w[i] : s->w[i];
}

#include "contact/em_cone_directions.h"

/* Whether a cone slides with a slip that has a direction, or begins to slide opposite to its last force, still
 * without slip. */
EM_NOINLINE int em_has_direction(const em_mixed *s, int i, double terms) {
    if (s->kind[i] != EM_ROW_CONE || s->choice[i] != EM_FORWARD || em_is_unloaded(s, i)) return 1;
    return (s->by_last && em_has_last(s, i)) || hypot(s->w[i], s->w[i + 1]) > EM_MODE_VERIFIED * terms;
}

/* Whether the chosen mode has a solution that satisfies all conditions. */
EM_NOINLINE int em_is_mode_consistent(em_mixed *s) {
    if (em_find_directions(s) || em_forces_of_mode(s)) return 0;
    const double terms = em_rates_of_mode(s);
    double most = 0.0;
    if (em_any_rests(s) && !em_share_with_resting(s, terms)) return 0;
    int worst = -1;
    for (int i = 0; i < s->k; ++i) {
        if (!em_has_direction(s, i, terms)) return 0;
        const double off = em_violation(s, i);
        if (!(off <= most)) most = off, worst = i;
    }
    if (worst < 0 || most <= s->tolerance * terms) return 1;
    if (most < s->least || s->clash[0] < 0) {
        s->least = most;
        if (worst != s->clash[0]) s->clash[1] = s->clash[0], s->clash[0] = worst;
    } else if (s->clash[1] < 0 && worst != s->clash[0]) {
        s->clash[1] = worst;
    }
    return 0;
}

EM_NOINLINE int em_is_consistent(em_mixed *s) {
    int slide[EM_MIXED_ROWS], some = 0;
    ++s->tried;
    s->by_last = 0;
    if (em_is_mode_consistent(s)) return 1;
    for (int c = em_sliding_cones(s, slide) - 1; c >= 0; --c) some |= em_has_last(s, slide[c]);
    s->by_last = some;
    return some && em_is_mode_consistent(s);
}

/* Whether there is a consistent mode that differs from the current one in `left` of the rows from `from` on. */
EM_NOINLINE int em_try_changes(em_mixed *s, int from, int left, int bars) {
    if (s->tried > EM_MOST_TRIED) return 0;
    if (left == 0) {
        for (int i = 0; bars && i < s->k; ++i)
            if (em_is_choice_row(s, i) && s->choice[i] == s->barred[i] && !em_is_unloaded(s, i)) return 0;
        return em_is_consistent(s);
    }
    for (int i = from; i + left <= s->k; ++i) {
        const em_row_choice given = s->choice[i];
        if (!em_is_choice_row(s, i) || em_is_unloaded(s, i)) continue;
        const em_row_choice contact[] = {EM_HOLDS_ROW, EM_OPENS, EM_NO_CHOICE};
        const em_row_choice friction[] = {EM_HOLDS_ROW, EM_FORWARD, EM_BACK};
        const int ways = s->kind[i] == EM_ROW_FRICTION ? 3 : 2;
        for (int way = 0; way < ways; ++way) {
            s->choice[i] = s->kind[i] == EM_ROW_CONTACT ? contact[way] : friction[way];
            if (s->choice[i] == EM_NO_CHOICE || s->choice[i] == given) continue;
            if (em_try_changes(s, i + 1, left - 1, bars)) return 1;
        }
        s->choice[i] = given;
    }
    return 0;
}

/* Scales rows to length one, so that p and w of all rows have one unit, that of the root of an energy. `back`:
 * undoes it. */
EM_NOINLINE void em_scale_mixed(em_mixed *s, int back) {
    double by[EM_MIXED_ROWS];
    for (int i = 0; i < s->k; ++i) {
        const double square = s->G[i * s->k + i];
        if (!back) s->unit[i] = square > 0.0 && s->kind[i] != EM_ROW_OUT ? 1.0 / sqrt(square) : 1.0;
        if (!back && s->kind[i] == EM_ROW_CONE_SECOND) /* one unit for both, so that the length of the vector is
                                                       meaningful */
            s->unit[i] = s->unit[i - 1] = sqrt(2.0) / hypot(1.0 / s->unit[i], 1.0 / s->unit[i - 1]);
    }
    for (int i = 0; i < s->k; ++i) {
        by[i] = back ? 1.0 / s->unit[i] : s->unit[i];
    }
    for (int i = 0; i < s->k; ++i) {
        for (int j = 0; j < s->k; ++j)
            s->G[i * s->k + j] *= by[i] * by[j], s->over[i * s->k + j] *= by[j], s->gradient[i * s->k + j] *= by[j];
        s->q[i] *= by[i], s->size[i] *= by[i], s->w[i] *= by[i], s->p[i] /= by[i], s->known_p[i] /= by[i];
        s->level[i] /= by[i], s->at_rest[i] /= by[i];
        s->coefficient[i] /= by[i], s->coefficient_at_rest[i] /= by[i];
    }
}

EM_NOINLINE int em_enumerate_modes(em_mixed *s, int bars) {
    int most = 0;
    for (int i = 0; i < s->k; ++i) most += em_is_choice_row(s, i);
    for (int changes = 0; changes <= most; ++changes)
        if (em_try_changes(s, 0, changes, bars)) return 1;
    return 0;
}

/* Lets idle contacts share the load of sticking cones: each that touches because others hold is made to hold, too,
 * if the mode stays consistent. */
EM_NOINLINE void em_hold_idle_contacts(em_mixed *s) {
    for (int i = 0; i < s->k && em_any_cone_sticks(s); ++i) {
        if (s->kind[i] != EM_ROW_CONTACT || s->choice[i] != EM_OPENS) continue;
        em_mixed more = *s;
        more.choice[i] = EM_HOLDS_ROW;
        if (fabs(s->w[i]) <= EM_MODE_VERIFIED * fabs(s->size[i]) && em_is_consistent(&more)) *s = more;
    }
}

#include "contact/em_lemke.h"

/* Finds the mode, p and w of a consistent solution. 1; 0: there is none, and `clash` says why; -1: too many modes to
 * try. */
EM_NOINLINE int em_solve_mixed(em_mixed *s) {
    em_row_choice given[EM_MIXED_ROWS];
    int found = 0, choices = 0;
    memcpy(given, s->choice, sizeof given);
    s->clash[0] = s->clash[1] = -1, s->least = INFINITY, s->tried = 0;
    em_scale_mixed(s, 0);
    for (int i = 0; i < s->k; ++i) choices += em_is_choice_row(s, i);
    for (int pass = 0; pass < 4 && !found; ++pass) {
        const int bars = pass < 2;
        s->tolerance = pass % 2 == 0 ? EM_MODE_EXACT : EM_MODE_VERIFIED;
        memcpy(s->choice, given, sizeof given);
        if (choices > EM_ENUMERATED && !em_any_rooted(s)) {
            found = em_try_changes(s, 0, 0, bars) || em_try_changes(s, 0, 1, bars) ||
                    (em_pivot_modes(s, bars) && em_is_consistent(s));
            if (found) break;
        }
        found = em_enumerate_modes(s, bars);
    }
    if (found) em_hold_idle_contacts(s);
    em_scale_mixed(s, 1);
    return found ? 1 : s->tried > EM_MOST_TRIED ? -1 : 0;
}

#endif
