/* em_articulated_bodies.h: articulated bodies in loops over a table of bodies (Featherstone 2008, chapter 7). */
#ifndef EM_ARTICULATED_BODIES_H
#define EM_ARTICULATED_BODIES_H

#include "bodies/em_recursions.h"

/* The forces and results of trees, of all n coordinates; the m rows of P become those of W = (M^-1 P^T)^T. */
typedef struct em_tree_motion {
    int n, m;
    const real *x, *v, *table, *force, *armature, *P;
    real *pivots, *a, *W;
} em_tree_motion;

EM_ANY_SIZE void em_tree_accelerations(const em_tree *tree, const em_tree_motion *motion);
EM_ANY_SIZE void em_tree_pivots(const em_tree *tree, const em_tree_motion *motion, real *diagonal);

#if EM_HOLDS_ANY_SIZE

/* The map [J H; H^T M] from an acceleration to the force that it takes; J and M symmetric (6), H by rows */
typedef struct em_articulated {
    real J[6], H[9], M[6];
} em_articulated;

/* A joint that gives way, by motions S and forces U = I S: rows of D^-1, and gains D^-1 U^T. */
typedef struct em_yield {
    real inverse[6], gain[6];
} em_yield;

/* force (6) <- I a */
EM_INLINE void em_articulated_force(const em_articulated *I, const real *a, real *force) {
    real b[3];
    em_symmetric_times(I->J, a, force);
    em_axes_up(I->H, a + 3, b);
    for (int i = 0; i < 3; ++i) force[i] += b[i];
    em_symmetric_times(I->M, a + 3, force + 3);
    em_axes_down(I->H, a, b);
    for (int i = 0; i < 3; ++i) force[3 + i] += b[i];
}

static const int em_row_of[6] = {0, 0, 0, 1, 1, 2}, em_column_of[6] = {0, 1, 2, 1, 2, 2};

/* I <- I less U gain^T */
EM_INLINE void em_give_way(const real *U, const real *gain, em_articulated *I) {
    for (int k = 0; k < 6; ++k) {
        I->J[k] -= U[em_row_of[k]] * gain[em_column_of[k]];
        I->M[k] -= U[3 + em_row_of[k]] * gain[3 + em_column_of[k]];
    }
    for (int k = 0; k < 9; ++k) I->H[k] -= U[k / 3] * gain[3 + k % 3];
}

/* B <- R J R^T, all of it; J symmetric (6) */
EM_INLINE void em_turned_symmetric(const real *R, const real *J, real *B) {
    real rows[9];
    for (int i = 0; i < 9; i += 3) em_symmetric_times(J, R + i, rows + i);
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) B[3 * i + j] = B[3 * j + i] = em_dot_of(3, rows + 3 * i, R + 3 * j);
}

/* B <- R A R^T */
EM_INLINE void em_turned_map(const real *R, const real *A, real *B) {
    real rows[9];
    em_axes_product(R, A, rows);
    for (int i = 0; i < 3; ++i) em_axes_up(R, rows + 3 * i, B + 3 * i);
}

/* up += I in the parent's frame: H' = H + P M, J' = J + P H'^T - H P, with P = [p x] */
EM_INLINE void em_add_articulated_up(const em_link *link, const em_articulated *I, em_articulated *up) {
    real J[9], H[9], M[9], moved[9], column[3], left[9], right[9];
    em_turned_symmetric(link->R, I->J, J);
    em_turned_map(link->R, I->H, H);
    em_turned_symmetric(link->R, I->M, M);
    for (int j = 0; j < 3; ++j) {
        em_cross(link->p, M + 3 * j, column); /* M is symmetric: its row is its column */
        for (int i = 0; i < 3; ++i) moved[3 * i + j] = H[3 * i + j] + column[i];
    }
    for (int j = 0; j < 3; ++j) {
        em_cross(link->p, moved + 3 * j, column);
        for (int i = 0; i < 3; ++i) left[3 * i + j] = column[i];
        em_cross(H + 3 * j, link->p, right + 3 * j);
    }
    for (int k = 0; k < 6; ++k) {
        const int at = 3 * em_row_of[k] + em_column_of[k];
        up->J[k] += J[at] + left[at] - right[at];
        up->M[k] += M[at];
    }
    for (int k = 0; k < 9; ++k) up->H[k] += moved[k];
}

/* rows[k].inverse <- the inverse of D (count, count), positive definite, by elimination */
EM_INLINE void em_invert_pivots(int count, real (*D)[6], em_yield *rows) {
    for (int k = 0; k < count; ++k) {
        em_clear(6, rows[k].inverse);
        rows[k].inverse[k] = em_real(1.0);
    }
    for (int k = 0; k < count; ++k) {
        const real pivot = em_inverse(D[k][k]);
        for (int j = 0; j < count; ++j) D[k][j] *= pivot, rows[k].inverse[j] *= pivot;
        for (int other = 0; other < count; ++other) {
            const real factor = D[other][k];
            for (int j = 0; j < count && other != k; ++j)
                D[other][j] -= factor * D[k][j], rows[other].inverse[j] -= factor * rows[k].inverse[j];
        }
    }
}

/* Of a joint about or along z, S has one entry that is not 0, and U is a multiple of a column of I. */
EM_INLINE void em_yield_on_z(const em_body *body, const em_tree_motion *motion, const real *S, em_articulated *I,
                             em_yield *row) {
    const int turns = body->joint == EM_REVOLUTE, k = body->coordinates[0];
    const real ratio = S[turns ? 2 : 5], *const H = I->H, *const B = turns ? I->J : I->M;
    real U[6];
    for (int i = 0; i < 3; ++i) {
        U[turns ? i : 3 + i] = ratio * B[i == 0 ? 2 : i == 1 ? 4 : 5];
        U[turns ? 3 + i : i] = ratio * (turns ? H[6 + i] : H[3 * i + 2]);
    }
    motion->pivots[k] = ratio * U[turns ? 2 : 5] + motion->armature[k];
    em_clear(6, row->inverse);
    row->inverse[0] = em_inverse(motion->pivots[k]);
    for (int i = 0; i < 6; ++i) row->gain[i] = row->inverse[0] * U[i];
    em_give_way(U, row->gain, I);
}

/* What a joint yields: its pivots, and I less what it does not pass on. S, rows: those of its slots. */
EM_INLINE void em_yield_of(const em_body *body, const em_tree_motion *motion, const real (*S)[6], em_articulated *I,
                           em_yield *rows) {
    real U[6][6], D[6][6];
    const int count = body->count;
    if (count == 1) {
        em_yield_on_z(body, motion, S[0], I, rows);
        return;
    }
    for (int k = 0; k < count; ++k) em_articulated_force(I, S[k], U[k]);
    for (int k = 0; k < count; ++k) {
        for (int j = 0; j < count; ++j) D[k][j] = em_dot_of(6, S[k], U[j]);
        D[k][k] += motion->armature[body->coordinates[k]];
        motion->pivots[body->coordinates[k]] = D[k][k];
    }
    em_invert_pivots(count, D, rows);
    for (int k = 0; k < count; ++k) {
        em_clear(6, rows[k].gain);
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < 6; ++i) rows[k].gain[i] += rows[k].inverse[j] * U[j][i];
    }
    for (int k = 0; k < count; ++k) em_give_way(U[k], rows[k].gain, I);
}

/* I <- the bodies' own inertias */
EM_INLINE void em_own_inertias(const em_tree *tree, const real *table, em_articulated *I) {
    for (int i = 0; i < tree->count; ++i) {
        const real *const inertia = table + EM_LINK * i + EM_LINK_INERTIA, *const h = inertia + 1;
        const real none = em_real(0.0), m = inertia[0];
        I[i] = (em_articulated){.H = {none, -h[2], h[1], h[2], none, -h[0], -h[1], h[0], none},
                                .M = {m, none, none, m, none, m}};
        memcpy(I[i].J, inertia + 4, sizeof I[i].J);
    }
}

/* bias (count, 6) <- the forces that keep velocities */
EM_INLINE void em_begin_bias(const em_tree *tree, const real *table, const em_link *links, real (*bias)[6]) {
    for (int i = 0; i < tree->count; ++i) {
        const real *const inertia = table + EM_LINK * i + EM_LINK_INERTIA;
        real momentum[6];
        em_momentum(inertia, links[i].v, momentum);
        em_clear(6, bias[i]);
        em_add_crossed_force(links[i].v, momentum, bias[i]);
    }
}

/* Inwards: rest (slots) <- the forces to which the joints yield; bias (count, 6) of the bodies becomes that of all that
 * they carry. I: what the joints pass on; NULL: links do not move. */
EM_INLINE void em_forces_inwards(const em_tree *tree, const em_link *links, const real (*S)[6], const em_yield *yields,
                                 const em_articulated *I, const real *force, real (*bias)[6], real *rest) {
    for (int i = tree->count - 1; i >= 0; --i) {
        const em_body *const body = &tree->bodies[i];
        const int first = links[i].first;
        real passed[6];
        em_clear(6, passed);
        for (int k = 0; k < body->count; ++k)
            rest[first + k] = force[body->coordinates[k]] - em_dot_of(6, S[first + k], bias[i]);
        if (body->parent < 0) continue;
        if (I != NULL) em_articulated_force(&I[i], links[i].c, passed);
        for (int j = 0; j < 6; ++j) passed[j] += bias[i][j];
        for (int k = 0; k < body->count; ++k)
            for (int j = 0; j < 6; ++j) passed[j] += yields[first + k].gain[j] * rest[first + k];
        em_add_force_up(&links[i], passed, bias[body->parent]);
    }
}

/* Outwards: result (n) <- the accelerations of the joints */
EM_INLINE void em_accelerations_outwards(const em_tree *tree, const em_link *links, const real (*S)[6],
                                         const em_yield *yields, const real *table, const real *rest, real *result) {
    real a[tree->count][6], still[6];
    em_clear(6, still);
    for (int i = 0; i < tree->count; ++i) {
        const em_body *const body = &tree->bodies[i];
        const int first = links[i].first, count = body->count;
        const real *const parent = body->parent >= 0 ? a[body->parent] : table ? NULL : still;
        real before[6];
        em_acceleration_before(&links[i], table ? table + EM_LINK * i : still, parent, table != NULL, before);
        memcpy(a[i], before, sizeof before);
        for (int k = 0; k < count; ++k) {
            const em_yield *const one = &yields[first + k];
            const real found = em_dot_of(count, one->inverse, rest + first) - em_dot_of(6, one->gain, before);
            result[body->coordinates[k]] = found;
            for (int j = 0; j < 6; ++j) a[i][j] += S[first + k][j] * found;
        }
    }
}

/* Inwards: what the joints yield and pass on, from the bodies' own inertias I */
EM_INLINE void em_yields_inwards(const em_tree *tree, const em_tree_motion *motion, const em_link *links,
                                 const real (*S)[6], em_articulated *I, em_yield *yields) {
    em_own_inertias(tree, motion->table, I);
    for (int i = tree->count - 1; i >= 0; --i) {
        const em_body *const body = &tree->bodies[i];
        em_yield_of(body, motion, S + links[i].first, &I[i], yields + links[i].first);
        if (body->parent >= 0) em_add_articulated_up(&links[i], &I[i], &I[body->parent]);
    }
}

/* Of the coordinates of trees: pivots (n), the inertia that each feels with the joints further out free, and diagonal
 * (n), that with them locked. */
EM_ANY_SIZE void em_tree_pivots(const em_tree *tree, const em_tree_motion *motion, real *diagonal) {
    em_link links[tree->count];
    em_articulated I[tree->count];
    em_yield yields[tree->slots];
    real moves[tree->slots][6], composite[tree->count][10], force[6];
    const real(*const S)[6] = (const real(*)[6])moves;
    em_place_links(tree, motion->x, motion->table, links, moves);
    em_yields_inwards(tree, motion, links, S, I, yields);
    em_own_bodies(tree, motion->table, composite);
    for (int i = tree->count - 1; i >= 0; --i) {
        const em_body *const body = &tree->bodies[i];
        for (int k = 0; k < body->count; ++k) {
            em_momentum(composite[i], S[links[i].first + k], force);
            diagonal[body->coordinates[k]] =
                em_dot_of(6, S[links[i].first + k], force) + motion->armature[body->coordinates[k]];
        }
        if (body->parent >= 0) em_add_inertia_up(&links[i], composite[i], composite[body->parent]);
    }
}

/* pivots, a, W of all coordinates of the trees */
EM_ANY_SIZE void em_tree_accelerations(const em_tree *tree, const em_tree_motion *motion) {
    em_link links[tree->count];
    em_articulated I[tree->count];
    em_yield yields[tree->slots];
    real moves[tree->slots][6], bias[tree->count][6], rest[tree->slots];
    const real(*const S)[6] = (const real(*)[6])moves;
    em_move_links(tree, motion->x, motion->v, motion->table, links, moves);
    em_begin_bias(tree, motion->table, links, bias);
    em_yields_inwards(tree, motion, links, S, I, yields);
    em_forces_inwards(tree, links, S, yields, I, motion->force, bias, rest);
    em_accelerations_outwards(tree, links, S, yields, motion->table, rest, motion->a);
    for (int row = 0; row < motion->m; ++row) {
        for (int i = 0; i < tree->count; ++i) em_clear(6, bias[i]);
        em_forces_inwards(tree, links, S, yields, NULL, motion->P + row * motion->n, bias, rest);
        em_accelerations_outwards(tree, links, S, yields, NULL, rest, motion->W + row * motion->n);
    }
}

#endif

#endif
