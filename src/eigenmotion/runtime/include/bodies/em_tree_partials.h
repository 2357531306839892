/* em_tree_partials.h: partial derivatives of recursive Newton-Euler in loops over a table of bodies (after Singh, Russo
 * and Wensing 2022).
 *
 * A small change of a coordinate of a joint moves all bodies that the joint carries like one rigid body. Seen from this
 * body, they all have the same change of velocity, (w, u), and a particle with velocity y has the change of acceleration
 * of a rigid body and 2 w x y. So the change of the force on a body and all that it carries follows from sums over
 * these: of mass, first and second moments, momentum, and the first moments of momentum. There are at most n^2 pairs of
 * a joint and one that it carries, and each takes a few dozen operations.
 *
 * Vectors have the axes of the ground. A spatial vector of a body refers to the origin of its own frame, because sums
 * about a distant point would cancel. `table` is em_links.h's. */
#ifndef EM_TREE_PARTIALS_H
#define EM_TREE_PARTIALS_H

#include "bodies/em_recursions.h"

/* Where derivatives are added: d force[i] / d x[k] to D[i * row + k * column], that by v[k] to D[i * row + (n + k) *
 * column]. If v is NULL the bodies are at rest, without gravity, and there are no derivatives by v. */
typedef struct em_tree_argument {
    int n;
    const double *x, *v, *a, *table;
    double *D;
    size_t row, column;
} em_tree_argument;

EM_ANY_SIZE void em_add_tree_partials(const em_tree *tree, const em_tree_argument *at);

/* dM (n, n, n) += the derivatives of the mass matrix, dM[k, i, j] = dM_ij / dx_k: M a at a = 1 for one j after the other */
EM_UNUSED static void em_add_tree_mass_gradient(const em_tree *tree, int n, const double *x, const double *table,
                                                double *dM) {
    double a[n];
    em_clear(n, a);
    for (int j = 0; j < n; ++j) {
        a[j] = 1.0;
        em_add_tree_partials(tree, &(em_tree_argument){.n = n, .x = x, .a = a, .table = table, .D = dM + j,
                                                       .row = (size_t)n, .column = (size_t)n * n});
        a[j] = 0.0;
    }
}

#if EM_HOLDS_ANY_SIZE

/* A body. d is its place on its parent, R its axes in those of the ground. Of it and all that it carries: `inertia` (mass,
 * m c, J), the momentum p, the sum Y (3, 3) of mass y r^T over particles at r with velocity y, and the force. */
typedef struct em_carried {
    double R[9], d[3], v[6], a[6], inertia[10], p[3], Y[9], force[6];
} em_carried;

/* The motion S of a joint's slot, and what the forces on it are the products of (em_feel). */
typedef struct em_slot {
    double S[6], by_a[6], by_w[3];
} em_slot;

/* A change of the velocity of a body, of which only the rotation w matters to forces, and of its acceleration less what
 * follows from w. */
typedef struct em_change {
    double w[3], a[6];
} em_change;

/* b <- both parts of a spatial vector in the axes of the ground */
EM_INLINE void em_in_ground(const double *R, const double *a, double *b) {
    em_axes_up(R, a, b);
    em_axes_up(R, a + 3, b + 3);
}

/* b += a x c */
EM_INLINE void em_add_cross(const double *a, const double *c, double *b) {
    double product[3];
    em_cross(a, c, product);
    for (int i = 0; i < 3; ++i) b[i] += product[i];
}

/* up += a force, about a point from which its own origin is at d */
EM_INLINE void em_add_shifted_force(const double *d, const double *force, double *up) {
    for (int i = 0; i < 6; ++i) up[i] += force[i];
    em_add_cross(d, force + 3, up);
}

/* The own values of p and Y of a body: y = v + w x r, so that Y = v (m c)^T + [w x] times the second moments of mass. */
EM_INLINE void em_velocity_moments(em_carried *b) {
    const double *const J = b->inertia + 4, half = 0.5 * (J[0] + J[3] + J[5]);
    const double second[3][3] = {{half - J[0], -J[1], -J[2]}, {-J[1], half - J[3], -J[4]}, {-J[2], -J[4], half - J[5]}};
    double turned[3];
    for (int i = 0; i < 3; ++i) b->p[i] = b->inertia[0] * b->v[3 + i];
    em_add_cross(b->v, b->inertia + 1, b->p);
    for (int j = 0; j < 3; ++j) {
        em_cross(b->v, second[j], turned);
        for (int i = 0; i < 3; ++i) b->Y[3 * i + j] = b->v[3 + i] * b->inertia[1 + j] + turned[i];
    }
}

/* A body's own inertia, force and moments of velocity. */
EM_NOINLINE void em_begin_carried(const double *row, em_carried *b) {
    em_link in_place;
    double momentum[6];
    memcpy(in_place.R, b->R, sizeof b->R);
    em_clear(3, in_place.p);
    em_clear(10, b->inertia);
    em_add_inertia_up(&in_place, row + EM_LINK_INERTIA, b->inertia);
    em_momentum(b->inertia, b->v, momentum);
    em_momentum(b->inertia, b->a, b->force);
    em_add_crossed_force(b->v, momentum, b->force);
    em_velocity_moments(b);
}

/* Adds what a body carries to what its parent carries. */
EM_NOINLINE void em_carry(const em_carried *b, em_carried *parent) {
    em_link shifted = {.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}};
    memcpy(shifted.p, b->d, sizeof b->d);
    em_add_inertia_up(&shifted, b->inertia, parent->inertia);
    em_add_shifted_force(b->d, b->force, parent->force);
    for (int i = 0; i < 3; ++i) {
        parent->p[i] += b->p[i];
        for (int j = 0; j < 3; ++j) parent->Y[3 * i + j] += b->Y[3 * i + j] + b->p[i] * b->d[j];
    }
}

/* a (6) <- a motion of the parent, about the origin of the body; on the ground, that of a ground which stands for gravity */
EM_INLINE void em_parent_acceleration(const em_carried *b, const em_carried *parent, const double *gravity, double *a) {
    em_clear(6, a);
    if (parent) {
        memcpy(a, parent->a, sizeof parent->a);
        em_add_cross(parent->a, b->d, a + 3);
    } else if (gravity)
        for (int i = 0; i < 3; ++i) a[3 + i] = -gravity[i];
}

/* Places a body, whose parent has its place, with its velocity and acceleration. */
EM_NOINLINE void em_place_carried(const em_body *body, const em_link *link, const double *row, const em_tree_argument *at,
                                const em_carried *parent, em_carried *b, const double (*moves)[6], em_slot *slots) {
    double c[6];
    if (parent) em_axes_product(parent->R, link->R, b->R), em_axes_up(parent->R, link->p, b->d);
    else memcpy(b->R, link->R, sizeof b->R), memcpy(b->d, link->p, sizeof b->d);
    em_in_ground(b->R, link->v, b->v);
    em_in_ground(b->R, link->c, c);
    em_parent_acceleration(b, parent, at->v ? row + EM_LINK_GRAVITY : NULL, b->a);
    for (int i = 0; i < 6; ++i) b->a[i] += c[i];
    for (int k = 0; k < body->count; ++k) {
        em_in_ground(b->R, moves[k], slots[k].S);
        for (int i = 0; i < 6; ++i) b->a[i] += slots[k].S[i] * at->a[body->coordinates[k]];
    }
}

/* The force on a slot's motion S by an acceleration of its body and of all that this carries is its product with by_a,
 * that by a change w the product with by_w. */
EM_INLINE void em_feel(const em_carried *b, em_slot *slot) {
    const double *const Y = b->Y, trace = Y[0] + Y[4] + Y[8], *const S = slot->S;
    double down[3];
    em_momentum(b->inertia, S, slot->by_a);
    em_axes_down(Y, S, down);
    em_cross(b->p, S + 3, slot->by_w);
    for (int i = 0; i < 3; ++i) slot->by_w[i] = 2.0 * (slot->by_w[i] + trace * S[i] - down[i]);
}

/* force (6) <- that of a change on a body and all that it carries */
EM_NOINLINE void em_force_of_change(const em_carried *b, const em_change *change, double *force) {
    const double *const Y = b->Y, trace = Y[0] + Y[4] + Y[8], *const w = change->w;
    double turned[3], up[3];
    em_momentum(b->inertia, change->a, force);
    em_axes_up(Y, w, up);
    em_cross(w, b->p, turned);
    for (int i = 0; i < 3; ++i) force[i] += 2.0 * (trace * w[i] - up[i]), force[3 + i] += 2.0 * turned[i];
}

/* --- joints whose motions depend on their own coordinates: modified Rodrigues parameters s --- */

/* A joint in its body's frame. `rates` and `second` (3) are those of s, own (6) = S qdot, S (count, 6). `turning` is the
 * first slot of s; `depends` is 0 for joints of one coordinate, whose S is constant. */
typedef struct em_joint_state {
    double s[3], rates[3], second[3], own[6];
    const double (*S)[6];
    int turning, depends;
} em_joint_state;

/* w (3) <- the change by s[k] of the angular velocity at given rates of s */
EM_INLINE void em_turning_change(const double *s, const double *rates, int k, double *w) {
    const double square = em_dot_of(3, s, s), along = em_dot_of(3, s, rates), f = 1.0 / (1.0 + square), d = f * f;
    const double unit[3] = {k == 0, k == 1, k == 2};
    double across[3], moved[3];
    em_cross(s, rates, across);
    em_cross(unit, rates, moved);
    for (int i = 0; i < 3; ++i) {
        const double velocity = (1.0 - square) * rates[i] + 2.0 * along * s[i] - 2.0 * across[i];
        const double change = -2.0 * s[k] * rates[i] + 2.0 * (rates[k] * s[i] + along * unit[i]) - 2.0 * moved[i];
        w[i] = 4.0 * d * (change - 4.0 * s[k] * f * velocity);
    }
}

/* out (6) <- the change by s[k] of S times given rates, `motion` (6), of which rates (3) are those of s. What moves along
 * axes of the parent turns backwards in the body's frame. */
EM_NOINLINE void em_motion_change(const em_joint_state *joint, int k, const double *rates, const double *motion, double *out) {
    em_turning_change(joint->s, rates, k, out);
    em_cross(motion + 3, joint->S[joint->turning + k], out + 3);
}

/* rate (3) += the change by s[k] of Sdot qdot's angular part, whose angular velocity w changes by w_change */
EM_INLINE void em_add_rate_by_s(const em_joint_state *joint, int k, const double *w_change, double *rate) {
    const double *const s = joint->s, *const rates = joint->rates, *const w = joint->own;
    const double f = 1.0 / (1.0 + em_dot_of(3, s, s)), slope = -2.0 * s[k] * f * f;
    const double along = em_dot_of(3, s, rates), square = em_dot_of(3, rates, rates);
    for (int i = 0; i < 3; ++i)
        rate[i] += 8.0 * square * (2.0 * f * slope * s[i] + (i == k ? f * f : 0.0)) -
                   4.0 * ((rates[k] * f + along * slope) * w[i] + along * f * w_change[i]);
}

/* rate (6) <- the change by the slot's velocity of Sdot qdot */
EM_INLINE void em_rate_by_velocity(const em_joint_state *joint, int slot, double *rate) {
    const double *const S = joint->S[slot], *const s = joint->s, *const rates = joint->rates;
    const double f = 1.0 / (1.0 + em_dot_of(3, s, s)), along = em_dot_of(3, s, rates);
    const int k = slot - joint->turning;
    em_clear(6, rate);
    if (k >= 0)
        for (int i = 0; i < 3; ++i)
            rate[i] = 16.0 * rates[k] * f * f * s[i] - 4.0 * f * (s[k] * joint->own[i] + along * S[i]);
    em_add_cross(S + 3, joint->own, rate + 3);
    em_add_cross(joint->own + 3, S, rate + 3);
}

/* own, rate, accelerated (6) <- the changes by the slot's coordinate of S qdot, Sdot qdot, S qddot */
EM_NOINLINE void em_joint_by_position(const em_joint_state *joint, int slot, const double *acceleration, double *own,
                                    double *rate, double *accelerated) {
    const int k = slot - joint->turning;
    em_clear(6, own), em_clear(6, rate), em_clear(6, accelerated);
    if (k < 0) return;
    em_motion_change(joint, k, joint->rates, joint->own, own);
    em_motion_change(joint, k, joint->second, acceleration, accelerated);
    em_add_rate_by_s(joint, k, own, rate);
    em_add_cross(joint->own + 3, own, rate + 3);
    em_add_cross(own + 3, joint->own, rate + 3);
}

/* acceleration (6) <- S qddot */
EM_INLINE void em_joint_state_at(const em_body *body, const em_tree_argument *at, const double (*S)[6],
                                 em_joint_state *joint, double *acceleration) {
    joint->S = S, joint->depends = body->joint == EM_SPHERICAL || body->joint == EM_FREE;
    joint->turning = joint->depends ? body->count - 3 : body->count;
    em_clear(6, joint->own), em_clear(6, acceleration);
    for (int k = 0; k < body->count; ++k) {
        const int coordinate = body->coordinates[k], turning = k - joint->turning;
        const double rate = at->v ? at->v[coordinate] : 0.0;
        for (int i = 0; i < 6; ++i) {
            joint->own[i] += S[k][i] * rate;
            acceleration[i] += S[k][i] * at->a[coordinate];
        }
        if (turning >= 0) joint->s[turning] = at->x[coordinate], joint->rates[turning] = rate;
        if (turning >= 0) joint->second[turning] = at->a[coordinate];
    }
}

/* --- changes of all forces --- */

/* All bodies at a state. `offset` of those that a body carries is their place from it; `carries` says which these are. */
typedef struct em_tree_state {
    const em_tree *tree;
    const em_tree_argument *at;
    em_link *links;
    em_carried *bodies;
    em_slot *slots;
    double (*moves)[6], (*offset)[3];
    unsigned char *carries;
} em_tree_state;

/* Adds the changes of the forces of joints that body b carries. `column`: of D */
EM_NOINLINE void em_change_outwards(const em_tree_state *state, int b, const em_change *change, double *column) {
    for (int i = b + 1; i < state->tree->count; ++i) {
        if (!state->carries[i]) continue;
        const em_body *const body = &state->tree->bodies[i];
        const em_slot *const slots = state->slots + state->links[i].first;
        double a[6];
        memcpy(a, change->a, sizeof a);
        em_add_cross(change->a, state->offset[i], a + 3);
        for (int k = 0; k < body->count; ++k)
            column[body->coordinates[k] * state->at->row] +=
                em_dot_of(6, slots[k].by_a, a) + em_dot_of(3, slots[k].by_w, change->w);
    }
}

/* Adds what a change of the force (6) on body b does to the force of its joint, and of all that carry it. */
EM_NOINLINE void em_change_inwards(const em_tree_state *state, int b, double *force, double *column) {
    for (int i = b; i >= 0; i = state->tree->bodies[i].parent) {
        const em_body *const body = &state->tree->bodies[i];
        const em_slot *const slots = state->slots + state->links[i].first;
        for (int k = 0; k < body->count; ++k)
            column[body->coordinates[k] * state->at->row] += em_dot_of(6, slots[k].S, force);
        em_add_cross(state->bodies[i].d, force + 3, force);
    }
}

/* Adds what the change of a joint's own motions by its slot does. `em_change_inwards` holds them still, while the
 * force turns; but they turn, too, and change in the body besides. */
EM_NOINLINE void em_change_at_joint(const em_tree_state *state, int b, const em_joint_state *joint, int slot, double *column) {
    const em_body *const body = &state->tree->bodies[b];
    const em_carried *const here = &state->bodies[b];
    const em_slot *const slots = state->slots + state->links[b].first;
    for (int k = 0; k < body->count; ++k) {
        double change[6], turned[6];
        em_crossed_motion(slots[slot].S, slots[k].S, turned);
        if (slot >= joint->turning) {
            const double rates[3] = {k == joint->turning, k == joint->turning + 1, k == joint->turning + 2};
            double in_body[6];
            em_motion_change(joint, slot - joint->turning, rates, joint->S[k], in_body);
            em_in_ground(here->R, in_body, change);
            for (int i = 0; i < 6; ++i) turned[i] += change[i];
        }
        column[body->coordinates[k] * state->at->row] += em_dot_of(6, turned, here->force);
    }
}

/* change <- that by a slot's coordinate. The body's parent has the velocity v and the acceleration a. */
EM_NOINLINE void em_change_by_position(const em_carried *b, const em_joint_state *joint, int slot, const double *S,
                                     const double *acceleration, const double *v, const double *a, em_change *change) {
    double in_body[6], rate[6], accelerated[6], own[6], z[6], terms[3][6];
    em_joint_by_position(joint, slot, acceleration, in_body, rate, accelerated);
    for (int i = 0; i < 6; ++i) rate[i] += accelerated[i];
    em_in_ground(b->R, rate, change->a);
    em_in_ground(b->R, in_body, own);
    em_crossed_motion(v, S, z);
    for (int i = 0; i < 6; ++i) z[i] += own[i];
    em_crossed_motion(a, S, terms[0]);
    em_crossed_motion(b->v, own, terms[1]);
    em_crossed_motion(v, z, terms[2]);
    for (int i = 0; i < 6; ++i) change->a[i] += terms[0][i] + terms[1][i] + terms[2][i];
    memcpy(change->w, z, sizeof change->w);
}

/* change <- that by a slot's velocity */
EM_NOINLINE void em_change_by_velocity(const em_carried *b, const em_joint_state *joint, int slot, const double *S,
                                     const double *v, em_change *change) {
    double rate[6], both[6], turned[6];
    em_clear(6, rate);
    if (joint->depends) em_rate_by_velocity(joint, slot, rate);
    em_in_ground(b->R, rate, change->a);
    for (int i = 0; i < 6; ++i) both[i] = b->v[i] + v[i];
    em_crossed_motion(both, S, turned);
    for (int i = 0; i < 6; ++i) change->a[i] += turned[i];
    memcpy(change->w, S, sizeof change->w);
}

/* Marks the bodies that body b carries. */
EM_NOINLINE void em_find_carried(const em_tree_state *state, int b) {
    em_clear(3, state->offset[b]);
    state->carries[b] = 1;
    for (int i = b + 1; i < state->tree->count; ++i) {
        const int parent = state->tree->bodies[i].parent;
        state->carries[i] = parent >= b && state->carries[parent];
        if (!state->carries[i]) continue;
        for (int k = 0; k < 3; ++k) state->offset[i][k] = state->offset[parent][k] + state->bodies[i].d[k];
    }
}

/* v, a (6) <- the velocity and acceleration of the parent of body b, about the origin of b */
EM_INLINE void em_parent_motion(const em_tree_state *state, int b, double *v, double *a) {
    const int parent = state->tree->bodies[b].parent;
    const em_carried *const here = &state->bodies[b], *const below = parent < 0 ? NULL : &state->bodies[parent];
    em_parent_acceleration(here, below, state->at->v ? state->at->table + EM_LINK * b + EM_LINK_GRAVITY : NULL, a);
    em_clear(6, v);
    if (!below) return;
    memcpy(v, below->v, sizeof below->v);
    em_add_cross(below->v, here->d, v + 3);
}

/* Adds the derivatives by coordinates and velocities of the joint of body b. */
EM_NOINLINE void em_add_joint_partials(const em_tree_state *state, int b) {
    const em_tree_argument *const at = state->at;
    const em_body *const body = &state->tree->bodies[b];
    const em_carried *const here = &state->bodies[b];
    const int first = state->links[b].first;
    em_joint_state joint;
    em_change change;
    double acceleration[6], v[6], a[6], force[6];
    em_find_carried(state, b);
    em_parent_motion(state, b, v, a);
    em_joint_state_at(body, at, (const double(*)[6])(state->moves + first), &joint, acceleration);
    for (int k = 0; k < body->count; ++k) {
        const double *const S = state->slots[first + k].S;
        double *const column = at->D + body->coordinates[k] * at->column;
        em_change_by_position(here, &joint, k, S, acceleration, v, a, &change);
        em_change_outwards(state, b, &change, column);
        em_force_of_change(here, &change, force);
        em_add_crossed_force(S, here->force, force);
        em_change_inwards(state, b, force, column);
        em_change_at_joint(state, b, &joint, k, column);
        if (!at->v) continue;
        em_change_by_velocity(here, &joint, k, S, v, &change);
        em_change_outwards(state, b, &change, column + at->n * at->column);
        em_force_of_change(here, &change, force);
        em_change_inwards(state, b, force, column + at->n * at->column);
    }
}

/* Fills a state: places outwards, what bodies carry inwards. */
EM_NOINLINE void em_tree_state_at(em_tree_state *state) {
    const em_tree *const tree = state->tree;
    const em_tree_argument *const at = state->at;
    double at_rest[at->n];
    em_clear(at->n, at_rest);
    em_move_links(tree, at->x, at->v ? at->v : at_rest, at->table, state->links, state->moves);
    for (int i = 0; i < tree->count; ++i) {
        const double *const row = at->table + EM_LINK * i;
        const em_body *const body = &tree->bodies[i];
        const em_carried *const parent = body->parent < 0 ? NULL : &state->bodies[body->parent];
        em_carried *const b = &state->bodies[i];
        const int first = state->links[i].first;
        em_place_carried(body, &state->links[i], row, at, parent, b,
                         (const double(*)[6])(state->moves + first), state->slots + first);
        em_begin_carried(row, b);
    }
    for (int i = tree->count - 1; i >= 0; --i) {
        const em_body *const body = &tree->bodies[i];
        for (int k = 0; k < body->count; ++k) em_feel(&state->bodies[i], &state->slots[state->links[i].first + k]);
        if (body->parent >= 0) em_carry(&state->bodies[i], &state->bodies[body->parent]);
    }
}

/* Adds the derivatives of the forces that the bodies take at x, v, a, gravity included. */
EM_ANY_SIZE void em_add_tree_partials(const em_tree *tree, const em_tree_argument *at) {
    em_link links[tree->count];
    em_carried bodies[tree->count];
    em_slot slots[tree->slots];
    double moves[tree->slots][6], offset[tree->count][3];
    unsigned char carries[tree->count];
    em_tree_state state = {tree, at, links, bodies, slots, moves, offset, carries};
    em_tree_state_at(&state);
    for (int i = 0; i < tree->count; ++i) em_add_joint_partials(&state, i);
}

#endif

#endif
