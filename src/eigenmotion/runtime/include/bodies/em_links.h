/* em_links.h: the bodies of a tree at a state, for recursions in loops: places, motions of joints, velocities.
 *
 * A spatial vector is (6,): angular, then linear. A table has EM_LINK numbers for each body. Its joint's frame is at
 * `at` on the parent, turned by R; a joint of one coordinate turns about z, or moves along z, by ratio q + offset. Mass,
 * first moment m c and inertia J (xx, xy, xz, yy, yz, zz) about the origin are in the body's frame. */
#ifndef EM_LINKS_H
#define EM_LINKS_H

#include "numeric/em_linear.h"

enum { /* offsets in a table's row */
    EM_LINK_AT = 0,
    EM_LINK_R = 3,
    EM_LINK_RATIO = 12,
    EM_LINK_OFFSET = 13,
    EM_LINK_INERTIA = 14, /* mass, m c, J */
    EM_LINK_GRAVITY = 24,
    EM_LINK = 27
};

/* Trees of `count` bodies, parents before their children. `slots` is the number of coordinates of all joints. */
typedef struct em_tree {
    int count, slots;
    const em_body *bodies;
} em_tree;

/* A body at a state. A point y of it is p + R y in the parent's frame. `first` is the slot of its joint's first motion,
 * v its velocity, c the part of its acceleration less its parent's that does not depend on accelerations. */
typedef struct em_link {
    real R[9], p[3], v[6], c[6];
    int first;
} em_link;

EM_INLINE real em_dot_of(int n, const real *a, const real *b) {
    real sum = a[0] * b[0];
    for (int i = 1; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

/* c <- a x b */
EM_INLINE void em_cross(const real *a, const real *b, real *c) {
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* b <- R a */
EM_INLINE void em_axes_up(const real *R, const real *a, real *b) {
    for (int i = 0; i < 3; ++i) b[i] = R[3 * i] * a[0] + R[3 * i + 1] * a[1] + R[3 * i + 2] * a[2];
}

/* b <- R^T a */
EM_INLINE void em_axes_down(const real *R, const real *a, real *b) {
    for (int i = 0; i < 3; ++i) b[i] = R[i] * a[0] + R[3 + i] * a[1] + R[6 + i] * a[2];
}

/* C <- A B */
EM_INLINE void em_axes_product(const real *A, const real *B, real *C) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) C[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
}

/* down <- a motion of the parent's frame in the body's frame */
EM_INLINE void em_motion_down(const em_link *link, const real *motion, real *down) {
    real v[3];
    em_cross(motion, link->p, v);
    for (int i = 0; i < 3; ++i) v[i] += motion[3 + i];
    em_axes_down(link->R, motion, down);
    em_axes_down(link->R, v, down + 3);
}

/* up += a force on the body in the parent's frame */
EM_INLINE void em_add_force_up(const em_link *link, const real *force, real *up) {
    real n[3], f[3], moment[3];
    em_axes_up(link->R, force, n);
    em_axes_up(link->R, force + 3, f);
    em_cross(link->p, f, moment);
    for (int i = 0; i < 3; ++i) up[i] += n[i] + moment[i], up[3 + i] += f[i];
}

/* out <- motion x other, the rate of a motion that is fixed in a frame that moves so */
EM_INLINE void em_crossed_motion(const real *motion, const real *other, real *out) {
    real v[3];
    em_cross(motion, other, out);
    em_cross(motion + 3, other, v);
    em_cross(motion, other + 3, out + 3);
    for (int i = 0; i < 3; ++i) out[3 + i] += v[i];
}

/* out += motion x* force, the rate of a force that is fixed in a frame that moves so */
EM_INLINE void em_add_crossed_force(const real *motion, const real *force, real *out) {
    real n[3], m[3], f[3];
    em_cross(motion, force, n);
    em_cross(motion + 3, force + 3, m);
    em_cross(motion, force + 3, f);
    for (int i = 0; i < 3; ++i) out[i] += n[i] + m[i], out[3 + i] += f[i];
}

/* b <- J a, J symmetric (6) */
EM_INLINE void em_symmetric_times(const real *J, const real *a, real *b) {
    b[0] = J[0] * a[0] + J[1] * a[1] + J[2] * a[2];
    b[1] = J[1] * a[0] + J[3] * a[1] + J[4] * a[2];
    b[2] = J[2] * a[0] + J[4] * a[1] + J[5] * a[2];
}

/* force <- the momentum of a rigid body (mass, m c, J) that moves so */
EM_INLINE void em_momentum(const real *inertia, const real *motion, real *force) {
    const real *const h = inertia + 1, *const w = motion, *const v = motion + 3;
    real a[3], b[3];
    em_symmetric_times(inertia + 4, w, force);
    em_cross(h, v, a);
    em_cross(h, w, b);
    for (int i = 0; i < 3; ++i) force[i] += a[i], force[3 + i] = inertia[0] * v[i] - b[i];
}

/* A joint about or along z. */
EM_INLINE void em_place_on_z(int joint, const real *row, real q, em_link *link, real (*S)[6]) {
    const real moved = row[EM_LINK_RATIO] * q + row[EM_LINK_OFFSET], *const R = row + EM_LINK_R;
    em_clear(6, S[0]);
    S[0][joint == EM_REVOLUTE ? 2 : 5] = row[EM_LINK_RATIO];
    if (joint == EM_PRISMATIC) {
        for (int i = 0; i < 3; ++i) link->p[i] += R[3 * i + 2] * moved;
        return;
    }
    const real c = em_cos(moved), s = em_sin(moved);
    for (int i = 0; i < 9; i += 3) {
        link->R[i] = c * R[i] + s * R[i + 1];
        link->R[i + 1] = c * R[i + 1] - s * R[i];
    }
}

/* A joint of modified Rodrigues parameters s (Schaub and Junkins 1996): its rotation, and its motions about the origin.
 * A <- diagonal 1 + 8 s s^T / d^2 + factor [s x] for both. */
EM_INLINE void em_rodrigues(const real *s, real diagonal, real factor, real outer, real *A) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) A[3 * i + j] = outer * s[i] * s[j] + (i == j ? diagonal : em_real(0.0));
    A[1] -= factor * s[2], A[3] += factor * s[2];
    A[2] += factor * s[1], A[6] -= factor * s[1];
    A[5] -= factor * s[0], A[7] += factor * s[0];
}

EM_INLINE void em_place_on_rodrigues(const real *row, const real *s, em_link *link, real (*S)[6]) {
    const real square = em_dot_of(3, s, s), d = em_inverse((1.0 + square) * (1.0 + square));
    real R[9], turn[9];
    em_rodrigues(s, 1.0 - 8.0 * square * d, 4.0 * (1.0 - square) * d, 8.0 * d, R);
    em_rodrigues(s, 4.0 * (1.0 - square) * d, -8.0 * d, 8.0 * d, turn);
    em_axes_product(row + EM_LINK_R, R, link->R);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) S[k][i] = turn[3 * i + k], S[k][3 + i] = em_real(0.0);
}

/* A joint that moves freely: S becomes the motions along the axes of its own frame, then those of its rotation. */
EM_INLINE void em_place_freely(const real *row, const real *q, em_link *link, real (*S)[6]) {
    real along[3], turned[9];
    em_place_on_rodrigues(row, q + 3, link, S + 3);
    em_axes_up(row + EM_LINK_R, q, along);
    for (int k = 0; k < 3; ++k) link->p[k] += along[k];
    for (int k = 0; k < 3; ++k) /* the columns of R^T of the joint alone */
        for (int i = 0; i < 3; ++i)
            turned[3 * k + i] = row[EM_LINK_R + k] * link->R[i] + row[EM_LINK_R + 3 + k] * link->R[3 + i] +
                                row[EM_LINK_R + 6 + k] * link->R[6 + i];
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) S[k][i] = em_real(0.0), S[k][3 + i] = turned[3 * k + i];
}

/* link, S <- a body at x */
EM_INLINE void em_place_link(const em_body *body, const real *row, const real *x, em_link *link, real (*S)[6]) {
    real q[6];
    for (int i = 0; i < 3; ++i) link->p[i] = row[EM_LINK_AT + i];
    for (int i = 0; i < 9; ++i) link->R[i] = row[EM_LINK_R + i];
    for (int k = 0; k < body->count; ++k) q[k] = x[body->coordinates[k]];
    if (body->joint == EM_FREE) em_place_freely(row, q, link, S + link->first);
    else if (body->joint == EM_SPHERICAL) em_place_on_rodrigues(row, q, link, S + link->first);
    else em_place_on_z(body->joint, row, q[0], link, S + link->first);
}

/* links (count), S (slots, 6) <- all bodies at x, without velocities */
EM_INLINE void em_place_links(const em_tree *tree, const real *x, const real *table, em_link *links, real (*S)[6]) {
    for (int i = 0, slot = 0; i < tree->count; slot += tree->bodies[i++].count) {
        links[i].first = slot;
        em_place_link(&tree->bodies[i], table + EM_LINK * i, x, &links[i], S);
    }
}

/* rate (6) += Sdot qdot of modified Rodrigues parameters s, which turn the body with w */
EM_INLINE void em_add_rodrigues_rate(const real *s, const real *rates, const real *w, real *rate) {
    const real inverse = em_inverse(1.0 + em_dot_of(3, s, s)), along = -4.0 * em_dot_of(3, s, rates) * inverse;
    const real outwards = 8.0 * em_dot_of(3, rates, rates) * inverse * inverse;
    for (int i = 0; i < 3; ++i) rate[i] += outwards * s[i] + along * w[i];
}

/* Of a joint: own (6) <- S qdot; rate (6) += Sdot qdot */
EM_INLINE void em_joint_motion(const em_body *body, const real *x, const real *v, const real (*S)[6], real *own,
                               real *rate) {
    real s[3], rates[3], turned[3];
    em_clear(6, own);
    for (int k = 0; k < body->count; ++k)
        for (int i = 0; i < 6; ++i) own[i] += S[k][i] * v[body->coordinates[k]];
    if (body->joint != EM_FREE && body->joint != EM_SPHERICAL) return;
    for (int k = 0; k < 3; ++k) {
        s[k] = x[body->coordinates[body->count - 3 + k]];
        rates[k] = v[body->coordinates[body->count - 3 + k]];
    }
    em_add_rodrigues_rate(s, rates, own, rate);
    em_cross(own, own + 3, turned);
    for (int i = 0; i < 3; ++i) rate[3 + i] -= turned[i];
}

/* links (count), S (slots, 6) <- all bodies at x, v */
EM_INLINE void em_move_links(const em_tree *tree, const real *x, const real *v, const real *table, em_link *links,
                             real (*S)[6]) {
    em_place_links(tree, x, table, links, S);
    for (int i = 0; i < tree->count; ++i) {
        em_link *const link = &links[i];
        const int parent = tree->bodies[i].parent;
        real own[6], rate[6];
        em_clear(6, rate);
        em_clear(6, link->v);
        if (parent >= 0) em_motion_down(link, links[parent].v, link->v);
        em_joint_motion(&tree->bodies[i], x, v, (const real(*)[6])(S + link->first), own, rate);
        em_crossed_motion(link->v, own, link->c);
        for (int k = 0; k < 6; ++k) link->c[k] += rate[k], link->v[k] += own[k];
    }
}

/* a (6) <- the acceleration of a body without that of its joint; the ground's stands for gravity */
EM_INLINE void em_acceleration_before(const em_link *link, const real *row, const real *parent, int moving, real *a) {
    real ground[6];
    for (int i = 0; i < 3; ++i) ground[i] = em_real(0.0), ground[3 + i] = -row[EM_LINK_GRAVITY + i];
    em_motion_down(link, parent ? parent : ground, a);
    if (moving)
        for (int k = 0; k < 6; ++k) a[k] += link->c[k];
}

#endif
