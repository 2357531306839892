/* em_force_sharing.h: forces of dependent rows where cones stick: shared so that the least reserve is as large as
 * possible.
 *
 * If more rows hold than are independent, as for a body on two rough feet, the forces are p = p0 + Z y, and the
 * motion is the same for every y: Z are the vanishing combinations of rows. The rows hold as long as some y keeps
 * every force within its bounds. For contacts and frictions along lines such a y is among the basic solutions
 * (em_complementarity.h). The bounds of cones are round, and all basic solutions may lie outside. Then y is the
 * solution of the convex problem
 *
 *     maximise t,  p_i >= t of contacts,  L_i - |p_i| >= t of frictions
 *
 * by a logarithmic barrier and Newton's method (Boyd and Vandenberghe 2004, chapter 11), rows at length one. Its
 * solution depends continuously on the state. The reserve t passes through zero where the forces reach their bounds,
 * all those at once that limit it: these rows begin to slide. */
#ifndef EM_FORCE_SHARING_H
#define EM_FORCE_SHARING_H

#include "constraints/em_rank.h"

#define EM_RESERVE_ERROR 1e-13 /* relative to the largest reserve: the part of the forces by which the barrier stays
                                  off the bounds */
#define EM_BARRIER_STEP 0.1    /* ratio of successive barrier weights */

enum { EM_UNKNOWNS = EM_MIXED_ROWS + 1, EM_NEWTON_STEPS = 30 };

/* One bound: u >= |(p1, p2)|, scaled by the size of the forces; gradients with respect to y and t. */
typedef struct em_bound {
    double u, p[2];
    double slope[3][EM_UNKNOWNS];
} em_bound;

typedef struct em_shared {
    int count, bounds;                 /* unknowns: y, followed by t */
    double Z[EM_MIXED_ROWS * EM_MIXED_ROWS]; /* (count - 1, k) vanishing combinations of the rows that hold */
    em_bound bound[EM_MIXED_ROWS];
    double size;                       /* of the forces */
} em_shared;

/* Z <- the vanishing combinations of rows that hold; basic (k) <- 1 for independent rows. Returns their number. */
EM_NOINLINE int em_vanishing_forces(const em_mixed *s, double *Z, int *basic) {
    double Delta[EM_MIXED_ROWS * EM_MIXED_ROWS], L[EM_MIXED_ROWS * EM_MIXED_ROWS], D[EM_MIXED_ROWS], z[EM_MIXED_ROWS];
    int rows[EM_MIXED_ROWS] = {0}, order[EM_MIXED_ROWS] = {0}, m = 0;
    for (int i = 0; i < s->k; ++i) {
        basic[i] = 0;
        if (em_row_holds(s, i)) rows[m++] = i;
    }
    for (int i = 0; i < m; ++i)
        for (int j = 0; j < m; ++j) Delta[i * m + j] = s->G[rows[i] * s->k + rows[j]];
    memset(L, 0, sizeof L);
    const int rank = em_pivoted(m, Delta, EM_MODE_RANK, L, D, order);
    for (int i = 0; i < rank; ++i) basic[rows[order[i]]] = 1;
    memset(Z, 0, (m - rank) * s->k * sizeof *Z);
    for (int i = rank; i < m; ++i) {
        em_vanishing_combination(m, rank, L, order, i, z);
        const double length = em_length(m, z);
        for (int j = 0; j < m; ++j) Z[(i - rank) * s->k + rows[j]] = z[j] / length;
    }
    return m - rank;
}

/* Whether row i is in one of the combinations Z. */
EM_NOINLINE int em_is_shared(const em_mixed *s, const em_shared *z, int i) {
    double largest = 0.0;
    for (int d = 0; d < z->count - 1; ++d) largest = fmax(largest, fabs(z->Z[d * s->k + i]));
    return largest > EM_TAKES_PART;
}

/* Whether the normal force of row i is shared. */
EM_NOINLINE int em_is_pressed_by_shared(const em_mixed *s, const em_shared *z, int i) {
    int any = 0;
    for (int j = 0; j < s->k && s->kind[i] >= EM_ROW_FRICTION; ++j) any |= s->over[i * s->k + j] != 0.0 && em_is_shared(s, z, j);
    return any;
}

/* The bound of row i (a contact, or the first of a friction) at y = 0 and t = 0, and its gradient. */
EM_NOINLINE void em_state_bound(const em_mixed *s, const em_shared *z, int i, em_bound *b) {
    const int contact = s->kind[i] == EM_ROW_CONTACT, last = z->count - 1;
    memset(b, 0, sizeof *b);
    b->u = contact ? s->p[i] : s->at_rest[i] + s->coefficient_at_rest[i] * em_normal_force(s, i);
    b->slope[0][last] = -1.0;
    for (int d = 0; d < last; ++d)
        for (int j = 0; j < s->k; ++j) {
            const double along = z->Z[d * s->k + j];
            if (contact) b->slope[0][d] += j == i ? along : 0.0;
            else if (!s->rooted[i]) b->slope[0][d] += s->coefficient_at_rest[i] * s->over[i * s->k + j] * along;
        }
    for (int way = 0; !contact && way <= (s->kind[i] == EM_ROW_CONE); ++way) {
        b->p[way] = s->p[i + way];
        for (int d = 0; d < last; ++d) b->slope[1 + way][d] = z->Z[d * s->k + i + way];
    }
}

/* Sets up the bounds that depend on y. 0, or -1: a sliding force does, too, or a norm of forces. */
EM_NOINLINE int em_state_bounds(const em_mixed *s, em_shared *z) {
    z->bounds = 0, z->size = 0.0;
    for (int i = 0; i < s->k; ++i) {
        const int pressed = em_is_pressed_by_shared(s, z, i);
        if (pressed && (s->rooted[i] || em_limit_sign(s, i) != 0.0)) return -1;
        if (!em_is_choice_row(s, i) || s->choice[i] != EM_HOLDS_ROW || em_is_unloaded(s, i)) continue;
        if (!pressed && !em_is_shared(s, z, i) && !(s->kind[i] == EM_ROW_CONE && em_is_shared(s, z, i + 1))) continue;
        em_bound *const b = &z->bound[z->bounds++];
        em_state_bound(s, z, i, b);
        z->size = fmax(z->size, fmax(fabs(b->u), hypot(b->p[0], b->p[1])));
    }
    for (int i = 0; i < z->bounds && z->size > 0.0; ++i)
        z->bound[i].u /= z->size, z->bound[i].p[0] /= z->size, z->bound[i].p[1] /= z->size;
    return 0;
}

/* The three numbers of a bound at y, t. */
EM_NOINLINE void em_bound_at(const em_shared *z, const em_bound *b, const double *y, double *at) {
    at[0] = b->u, at[1] = b->p[0], at[2] = b->p[1];
    for (int part = 0; part < 3; ++part)
        for (int d = 0; d < z->count; ++d) at[part] += b->slope[part][d] * y[d];
}

/* The barrier at y, t: INFINITY outside the bounds. g, H: its gradient and Hessian, lower triangle, or NULL. t is at
 * most 1: rows without an upper bound are then loaded no more than necessary. */
EM_NOINLINE double em_barrier(const em_shared *z, double weight, const double *y, double *g, double *H) {
    const int n = z->count, last = n - 1;
    double value = -weight * y[last] - log(1.0 - y[last]), at[3];
    if (!(y[last] < 1.0)) return INFINITY;
    if (g) memset(g, 0, n * sizeof *g), memset(H, 0, n * n * sizeof *H);
    if (g) g[last] = -weight + 1.0 / (1.0 - y[last]), H[last * n + last] = 1.0 / ((1.0 - y[last]) * (1.0 - y[last]));
    for (int d = 0; d < last; ++d) {
        value += 0.5 * y[d] * y[d];
        if (g) g[d] = y[d], H[d * n + d] = 1.0;
    }
    for (int k = 0; k < z->bounds; ++k) {
        const em_bound *const b = &z->bound[k];
        em_bound_at(z, b, y, at);
        const double size = hypot(at[1], at[2]), room = (at[0] - size) * (at[0] + size);
        if (!(at[0] > size) || !(room > 0.0)) return INFINITY;
        value -= log(room);
        for (int i = 0; g && i < n; ++i) {
            const double own = 2.0 * (at[0] * b->slope[0][i] - at[1] * b->slope[1][i] - at[2] * b->slope[2][i]) / room;
            g[i] -= own;
            for (int j = 0; j <= i; ++j) {
                const double other = 2.0 * (at[0] * b->slope[0][j] - at[1] * b->slope[1][j] - at[2] * b->slope[2][j]) / room;
                const double bend = b->slope[0][i] * b->slope[0][j] - b->slope[1][i] * b->slope[1][j] - b->slope[2][i] * b->slope[2][j];
                H[i * n + j] += own * other - 2.0 * bend / room;
            }
        }
    }
    return value;
}

/* y, t <- the minimum of the barrier of this weight, from inside the bounds. */
EM_NOINLINE void em_minimise_barrier(const em_shared *z, double weight, double *y) {
    const int n = z->count;
    double g[EM_UNKNOWNS], H[EM_UNKNOWNS * EM_UNKNOWNS], L[EM_UNKNOWNS * EM_UNKNOWNS], r[EM_UNKNOWNS], step[EM_UNKNOWNS];
    double next[EM_UNKNOWNS], value = em_barrier(z, weight, y, g, H);
    for (int k = 0; k < EM_NEWTON_STEPS; ++k) {
        double falls = 0.0, part = 1.0, then = INFINITY;
        memset(L, 0, sizeof L);
        if (em_cholesky(n, H, L, r, 0.0) >= 0) return;
        for (int i = 0; i < n; ++i) step[i] = -g[i];
        em_forward(n, L, r, step), em_backward(n, L, r, step);
        for (int i = 0; i < n; ++i) falls -= g[i] * step[i];
        if (!(falls > 1e-4)) return;
        for (; part > 1e-8; part *= 0.5) {
            for (int i = 0; i < n; ++i) next[i] = y[i] + part * step[i];
            then = em_barrier(z, weight, next, NULL, NULL);
            if (then < value - 0.1 * part * falls) break;
        }
        if (!(then < value)) return;
        memcpy(y, next, n * sizeof *y);
        value = em_barrier(z, weight, y, g, H);
    }
}

/* p <- with the largest reserve of the shared rows. */
EM_NOINLINE void em_raise_reserve(em_mixed *s, const em_shared *z) {
    const int last = z->count - 1;
    double y[EM_UNKNOWNS] = {0.0}, least = 0.0;
    for (int k = 0; k < z->bounds; ++k)
        least = fmin(least, z->bound[k].u - hypot(z->bound[k].p[0], z->bound[k].p[1]));
    y[last] = least - 1.0;
    for (double weight = 1.0; weight <= 1.0 / EM_RESERVE_ERROR; weight /= EM_BARRIER_STEP)
        em_minimise_barrier(z, weight, y);
    for (int i = 0; i < s->k; ++i)
        for (int d = 0; d < last; ++d) s->p[i] += z->size * y[d] * z->Z[d * s->k + i];
}

/* Whether a cone sticks. */
EM_NOINLINE int em_any_cone_sticks(const em_mixed *s) {
    int any = 0;
    for (int i = 0; i < s->k; ++i) any |= s->kind[i] == EM_ROW_CONE && em_row_holds(s, i);
    return any;
}

/* p <- with the largest reserve, of rows that hold and are dependent, some of them cones. 0, or -1: the problem is
 * of another kind. */
EM_NOINLINE int em_share(em_mixed *s) {
    em_shared z;
    int basic[EM_MIXED_ROWS];
    if (!em_any_cone_sticks(s)) return -1;
    z.count = 1 + em_vanishing_forces(s, z.Z, basic);
    if (z.count == 1 || em_state_bounds(s, &z)) return -1;
    if (z.bounds > 0 && z.size > 0.0) em_raise_reserve(s, &z);
    return 0;
}

#endif
