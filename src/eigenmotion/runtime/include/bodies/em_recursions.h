/* em_recursions.h: recursive Newton-Euler and composite rigid bodies in loops over a table of bodies (Featherstone 2008,
 * chapters 5 and 6), which takes a compiler less time than straight-line code, and calls more. `table` is em_links.h's. */
#ifndef EM_RECURSIONS_H
#define EM_RECURSIONS_H

#include "bodies/em_links.h"

EM_ANY_SIZE void em_add_tree_forces(const em_tree *tree, const real *x, const real *v, const real *a, const real *table,
                                    double sign, real *forces);
EM_ANY_SIZE void em_add_tree_masses(const em_tree *tree, int n, const real *x, const real *table, real *M);
EM_ANY_SIZE void em_add_tree_energies(const em_tree *tree, const real *x, const real *v, const real *table, real *e);

/* part (size, size) <- the entries of M (n, n) of some coordinates (size) */
EM_INLINE void em_take_masses(int n, int size, const int *coordinate, const real *M, real *part) {
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) part[i * size + j] = M[coordinate[i] * n + coordinate[j]];
}

#if EM_HOLDS_ANY_SIZE

/* forces (n) += sign times the forces that the bodies take at accelerations xddot (n), NULL for 0; gravity included */
EM_ANY_SIZE void em_add_tree_forces(const em_tree *tree, const real *x, const real *v, const real *xddot, const real *table,
                                    double sign, real *forces) {
    em_link links[tree->count];
    real S[tree->slots][6], a[tree->count][6], force[tree->count][6], momentum[6];
    em_move_links(tree, x, v, table, links, S);
    for (int i = 0; i < tree->count; ++i) {
        const real *const row = table + EM_LINK * i;
        const int parent = tree->bodies[i].parent;
        em_acceleration_before(&links[i], row, parent >= 0 ? a[parent] : NULL, 1, a[i]);
        for (int k = 0; xddot && k < tree->bodies[i].count; ++k)
            for (int j = 0; j < 6; ++j) a[i][j] += S[links[i].first + k][j] * xddot[tree->bodies[i].coordinates[k]];
        em_momentum(row + EM_LINK_INERTIA, links[i].v, momentum);
        em_momentum(row + EM_LINK_INERTIA, a[i], force[i]);
        em_add_crossed_force(links[i].v, momentum, force[i]);
    }
    for (int i = tree->count - 1; i >= 0; --i) {
        const em_body *const body = &tree->bodies[i];
        for (int k = 0; k < body->count; ++k)
            forces[body->coordinates[k]] += sign * em_dot_of(6, S[links[i].first + k], force[i]);
        if (body->parent >= 0) em_add_force_up(&links[i], force[i], force[body->parent]);
    }
}

/* composite (count, 10) <- the bodies themselves, as rigid bodies (mass, m c, J) */
EM_INLINE void em_own_bodies(const em_tree *tree, const real *table, real (*composite)[10]) {
    for (int i = 0; i < tree->count; ++i)
        for (int k = 0; k < 10; ++k) composite[i][k] = table[EM_LINK * i + EM_LINK_INERTIA + k];
}

/* up (10) += a rigid body (mass, m c, J) in the parent's frame */
EM_INLINE void em_add_inertia_up(const em_link *link, const real *inertia, real *up) {
    static const int full[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5}, symmetric[6] = {0, 1, 2, 4, 5, 8};
    const real *const p = link->p;
    real J[9], turned[9], h[3], a[3], rows[9];
    for (int i = 0; i < 9; ++i) J[i] = inertia[4 + full[i]];
    em_axes_product(link->R, J, rows);
    for (int i = 0; i < 3; ++i) em_axes_up(link->R, rows + 3 * i, turned + 3 * i); /* R J R^T */
    em_axes_up(link->R, inertia + 1, h);
    for (int i = 0; i < 3; ++i) a[i] = h[i] + 0.5 * inertia[0] * p[i];
    const real around = 2.0 * em_dot_of(3, a, p);
    for (int i = 0; i < 6; ++i) {
        const int row = symmetric[i] / 3, column = symmetric[i] % 3;
        up[4 + i] += turned[symmetric[i]] - a[row] * p[column] - p[row] * a[column] + (row == column ? around : em_real(0.0));
    }
    up[0] += inertia[0];
    for (int i = 0; i < 3; ++i) up[1 + i] += h[i] + inertia[0] * p[i];
}

/* M (n, n) += the forces of all joints that carry body i for a force on it, of its slot's coordinate */
EM_INLINE void em_add_column(const em_tree *tree, const em_link *links, const real (*S)[6], int n, int i, int slot,
                             const real *force, real *M) {
    const int column = tree->bodies[i].coordinates[slot];
    real here[6], up[6];
    for (int k = 0; k < 6; ++k) here[k] = force[k];
    for (int at = i; at >= 0; at = tree->bodies[at].parent) {
        const em_body *const body = &tree->bodies[at];
        for (int k = 0; k < (at == i ? slot + 1 : body->count); ++k) {
            const int row = body->coordinates[k];
            const real entry = em_dot_of(6, S[links[at].first + k], here);
            M[row * n + column] += entry;
            if (at != i || k != slot) M[column * n + row] += entry;
        }
        em_clear(6, up);
        em_add_force_up(&links[at], here, up);
        memcpy(here, up, sizeof here);
    }
}

/* M (n, n) += the mass matrix of the bodies */
EM_ANY_SIZE void em_add_tree_masses(const em_tree *tree, int n, const real *x, const real *table, real *M) {
    em_link links[tree->count];
    real S[tree->slots][6], composite[tree->count][10], force[6];
    em_place_links(tree, x, table, links, S);
    em_own_bodies(tree, table, composite);
    for (int i = tree->count - 1; i >= 0; --i) {
        const em_body *const body = &tree->bodies[i];
        for (int k = 0; k < body->count; ++k) {
            em_momentum(composite[i], S[links[i].first + k], force);
            em_add_column(tree, links, (const real(*)[6])S, n, i, k, force, M);
        }
        if (body->parent >= 0) em_add_inertia_up(&links[i], composite[i], composite[body->parent]);
    }
}

/* R (9), p (3) <- a body in the ground's frame; those of its parent are NULL on the ground */
EM_INLINE void em_place_on_ground(const em_link *link, const real *R, const real *p, real *R_here, real *p_here) {
    if (R == NULL) {
        memcpy(R_here, link->R, sizeof link->R);
        memcpy(p_here, link->p, sizeof link->p);
        return;
    }
    em_axes_product(R, link->R, R_here);
    em_axes_up(R, link->p, p_here);
    for (int i = 0; i < 3; ++i) p_here[i] += p[i];
}

/* e (4): e[0] += the kinetic energy of the bodies, e[3] += their potential energy -g . sum of m c */
EM_ANY_SIZE void em_add_tree_energies(const em_tree *tree, const real *x, const real *v, const real *table, real *e) {
    em_link links[tree->count];
    real S[tree->slots][6], R[tree->count][9], p[tree->count][3], momentum[6], moment[3];
    em_move_links(tree, x, v, table, links, S);
    for (int i = 0; i < tree->count; ++i) {
        const real *const row = table + EM_LINK * i, *const inertia = row + EM_LINK_INERTIA;
        const int parent = tree->bodies[i].parent;
        em_place_on_ground(&links[i], parent < 0 ? NULL : R[parent], parent < 0 ? NULL : p[parent], R[i], p[i]);
        em_momentum(inertia, links[i].v, momentum);
        em_axes_up(R[i], inertia + 1, moment);
        for (int k = 0; k < 3; ++k) moment[k] += inertia[0] * p[i][k];
        e[0] += 0.5 * em_dot_of(6, momentum, links[i].v);
        e[3] -= em_dot_of(3, row + EM_LINK_GRAVITY, moment);
    }
}

#endif

#endif
