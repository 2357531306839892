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

/* A row of three numbers: one vector of a machine that has such, or three numbers on lanes. */
#if defined(EM_PACKED) && EM_LANES >= 4
typedef double em_row __attribute__((vector_size(32)));
#define EM_ROW(a, b, c) ((em_row){a, b, c, 0.0})
#define EM_AT(row, k) ((row)[k])
EM_INLINE em_row em_row_sum(em_row a, real factor, em_row b) { return a + factor * b; }
#else
typedef struct em_row {
    real at[3];
} em_row;
#define EM_ROW(a, b, c) ((em_row){{a, b, c}})
#define EM_AT(row, k) ((row).at[k])
EM_INLINE em_row em_row_sum(em_row a, real factor, em_row b) {
    for (int k = 0; k < 3; ++k) a.at[k] += factor * b.at[k];
    return a;
}
#endif

/* The map [J H; H^T M] from an acceleration to the force that it takes; J and M symmetric */
typedef struct em_articulated {
    em_row J[3], H[3], M[3];
} em_articulated;

/* A joint that gives way, by motions S and forces U = I S: rows of D^-1, and gains D^-1 U^T. */
typedef struct em_yield {
    real inverse[6], gain[6];
} em_yield;

/* row + a A, A of three rows */
EM_INLINE em_row em_add_rows(em_row row, const real *a, const em_row *A) {
    return em_row_sum(em_row_sum(em_row_sum(row, a[0], A[0]), a[1], A[1]), a[2], A[2]);
}

EM_INLINE em_row em_no_row(void) {
    const real none = em_real(0.0);
    return EM_ROW(none, none, none);
}

/* force (6) <- I a */
EM_INLINE void em_articulated_force(const em_articulated *I, const real *a, real *force) {
    const em_row turn = em_add_rows(em_no_row(), a, I->J);
    const em_row push = em_add_rows(em_add_rows(em_no_row(), a, I->H), a + 3, I->M);
    for (int i = 0; i < 3; ++i) {
        force[i] = EM_AT(turn, i) + EM_AT(I->H[i], 0) * a[3] + EM_AT(I->H[i], 1) * a[4] + EM_AT(I->H[i], 2) * a[5];
        force[3 + i] = EM_AT(push, i);
    }
}

/* I <- I less U gain^T */
EM_INLINE void em_give_way(const real *U, const real *gain, em_articulated *I) {
    const em_row turn = EM_ROW(gain[0], gain[1], gain[2]), push = EM_ROW(gain[3], gain[4], gain[5]);
    for (int i = 0; i < 3; ++i) {
        I->J[i] = em_row_sum(I->J[i], -U[i], turn);
        I->H[i] = em_row_sum(I->H[i], -U[i], push);
        I->M[i] = em_row_sum(I->M[i], -U[3 + i], push);
    }
}

/* B <- R A R^T; columns: those of R */
EM_INLINE void em_turned_map(const real *R, const em_row *columns, const em_row *A, em_row *B) {
    em_row rows[3];
    for (int i = 0; i < 3; ++i) {
        const real a[3] = {EM_AT(A[i], 0), EM_AT(A[i], 1), EM_AT(A[i], 2)};
        rows[i] = em_add_rows(em_no_row(), a, columns);
    }
    for (int i = 0; i < 3; ++i) B[i] = em_add_rows(em_no_row(), R + 3 * i, rows);
}

/* up += I in the parent's frame: H' = H + P M, J' = J - Y - Y^T - P M P, with P = [p x] and Y = H P */
EM_INLINE void em_add_articulated_up(const em_link *link, const em_articulated *I, em_articulated *up) {
    const real *const R = link->R, *const p = link->p, none = em_real(0.0);
    const em_row P[3] = {EM_ROW(none, -p[2], p[1]), EM_ROW(p[2], none, -p[0]), EM_ROW(-p[1], p[0], none)};
    em_row columns[3], J[3], H[3], M[3], moved[3], Y[3];
    for (int k = 0; k < 3; ++k) columns[k] = EM_ROW(R[k], R[3 + k], R[6 + k]);
    em_turned_map(R, columns, I->J, J);
    em_turned_map(R, columns, I->H, H);
    em_turned_map(R, columns, I->M, M);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        moved[i] = em_row_sum(em_row_sum(H[i], p[j], M[k]), -p[k], M[j]);
    }
    for (int i = 0; i < 3; ++i) {
        const real h[3] = {EM_AT(H[i], 0), EM_AT(H[i], 1), EM_AT(H[i], 2)};
        const real m[3] = {EM_AT(moved[i], 0), EM_AT(moved[i], 1), EM_AT(moved[i], 2)};
        J[i] = em_row_sum(J[i], em_real(-1.0), em_add_rows(em_no_row(), h, P));
        Y[i] = em_add_rows(em_no_row(), m, P);
    }
    for (int i = 0; i < 3; ++i) {
        const em_row column = EM_ROW(EM_AT(Y[0], i), EM_AT(Y[1], i), EM_AT(Y[2], i));
        up->J[i] = em_row_sum(up->J[i], em_real(1.0), em_row_sum(J[i], em_real(-1.0), column));
        up->H[i] = em_row_sum(up->H[i], em_real(1.0), moved[i]);
        up->M[i] = em_row_sum(up->M[i], em_real(1.0), M[i]);
    }
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
    const real ratio = S[turns ? 2 : 5];
    real U[6];
    for (int i = 0; i < 3; ++i) {
        U[i] = ratio * (turns ? EM_AT(I->J[2], i) : EM_AT(I->H[i], 2));
        U[3 + i] = ratio * (turns ? EM_AT(I->H[2], i) : EM_AT(I->M[2], i));
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
        const real none = em_real(0.0), m = inertia[0], *const J = inertia + 4;
        I[i] = (em_articulated){.J = {EM_ROW(J[0], J[1], J[2]), EM_ROW(J[1], J[3], J[4]), EM_ROW(J[2], J[4], J[5])},
                                .H = {EM_ROW(none, -h[2], h[1]), EM_ROW(h[2], none, -h[0]), EM_ROW(-h[1], h[0], none)},
                                .M = {EM_ROW(m, none, none), EM_ROW(none, m, none), EM_ROW(none, none, m)}};
    }
}

/* bias (6) += the force that keeps the velocity of a body */
EM_INLINE void em_add_bias(const real *row, const em_link *link, real *bias) {
    real momentum[6];
    em_momentum(row + EM_LINK_INERTIA, link->v, momentum);
    em_add_crossed_force(link->v, momentum, bias);
}

/* Inwards, of body i: rest (slots) <- the forces to which its joint yields; the bias (count, 6) of the body becomes that
 * of all that it carries. I: what its joint passes on; NULL: links do not move. */
EM_INLINE void em_force_inwards(const em_tree *tree, int i, const em_link *links, const real (*S)[6],
                                const em_yield *yields, const em_articulated *I, const real *force, real (*bias)[6],
                                real *rest) {
    const em_body *const body = &tree->bodies[i];
    const int first = links[i].first;
    real passed[6];
    em_clear(6, passed);
    for (int k = 0; k < body->count; ++k)
        rest[first + k] = force[body->coordinates[k]] - em_dot_of(6, S[first + k], bias[i]);
    if (body->parent < 0) return;
    if (I != NULL) em_articulated_force(I, links[i].c, passed);
    for (int j = 0; j < 6; ++j) passed[j] += bias[i][j];
    for (int k = 0; k < body->count; ++k)
        for (int j = 0; j < 6; ++j) passed[j] += yields[first + k].gain[j] * rest[first + k];
    em_add_force_up(&links[i], passed, bias[body->parent]);
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

/* Inwards, of body i: what its joint yields, and passes on to the parent; I (count): first the bodies' own inertias */
EM_INLINE void em_yield_inwards(const em_tree *tree, int i, const em_tree_motion *motion, const em_link *links,
                                const real (*S)[6], em_articulated *I, em_yield *yields) {
    const em_body *const body = &tree->bodies[i];
    em_yield_of(body, motion, S + links[i].first, &I[i], yields + links[i].first);
    if (body->parent >= 0) em_add_articulated_up(&links[i], &I[i], &I[body->parent]);
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
    em_own_inertias(tree, motion->table, I);
    em_own_bodies(tree, motion->table, composite);
    for (int i = tree->count - 1; i >= 0; --i) {
        const em_body *const body = &tree->bodies[i];
        em_yield_inwards(tree, i, motion, links, S, I, yields);
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
    em_own_inertias(tree, motion->table, I);
    em_clear(6 * tree->count, bias[0]);
    for (int i = tree->count - 1; i >= 0; --i) { /* side by side: each waits for the results of the body before */
        em_yield_inwards(tree, i, motion, links, S, I, yields);
        em_add_bias(motion->table + EM_LINK * i, &links[i], bias[i]);
        em_force_inwards(tree, i, links, S, yields, &I[i], motion->force, bias, rest);
    }
    em_accelerations_outwards(tree, links, S, yields, motion->table, rest, motion->a);
    for (int row = 0; row < motion->m; ++row) {
        for (int i = 0; i < tree->count; ++i) em_clear(6, bias[i]);
        for (int i = tree->count - 1; i >= 0; --i)
            em_force_inwards(tree, i, links, S, yields, NULL, motion->P + row * motion->n, bias, rest);
        em_accelerations_outwards(tree, links, S, yields, NULL, rest, motion->W + row * motion->n);
    }
}

#endif

#endif
