/* em_forward_kinematics.h: places of the bodies of a tree, and Jacobians of their points, from joint to joint inwards.
 *
 * frames (n_bodies, EM_FRAME) are the numbers that em_model.frames gives: at (3), R (3, 3), axis (3), ratio, offset. A
 * point y of the joint's frame is at + R y in the parent's frame. Matrices are row-major. */
#ifndef EM_FORWARD_KINEMATICS_H
#define EM_FORWARD_KINEMATICS_H

#include <math.h>
#include <string.h>

#include "eigenmotion.h"

/* A joint at its coordinates: a point y of the body is p + R y in the joint's frame. At a rate of 1 of coordinate k the
 * body turns with turn[k] about its origin, which moves with slide[k]. */
typedef struct em_joint_state {
    int count;
    double R[9], p[3], turn[6][3], slide[6][3];
} em_joint_state;

/* b <- R a */
static inline void em_rotated(const double *R, const double *a, double *b)
{
    for (int i = 0; i < 3; ++i) b[i] = R[3 * i] * a[0] + R[3 * i + 1] * a[1] + R[3 * i + 2] * a[2];
}

/* C <- A B */
static inline void em_rotations(const double *A, const double *B, double *C)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) C[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
}

/* c <- a x b */
static inline void em_crossed(const double *a, const double *b, double *c)
{
    for (int i = 0; i < 3; ++i) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* R <- diagonal 1 + outer a a^T + factor [a x] */
static inline void em_rotation_of(const double *a, double diagonal, double outer, double factor, double *R)
{
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) R[3 * i + j] = outer * a[i] * a[j];
        R[4 * i] += diagonal;
        R[3 * i + (i + 1) % 3] -= factor * a[(i + 2) % 3];
        R[3 * i + (i + 2) % 3] += factor * a[(i + 1) % 3];
    }
}

/* A rotation by modified Rodrigues parameters s, whose coordinates are the last three of the joint. */
static inline void em_rodrigues_joint(const double *s, em_joint_state *joint)
{
    const double square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2], d = (1.0 + square) * (1.0 + square);
    double turn[9];
    em_rotation_of(s, 1.0 - 8.0 * square / d, 8.0 / d, 4.0 * (1.0 - square) / d, joint->R);
    em_rotation_of(s, 4.0 * (1.0 - square) / d, 8.0 / d, 8.0 / d, turn);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) joint->turn[joint->count - 3 + k][i] = turn[3 * i + k];
}

/* The joint of a body at x. */
static inline void em_joint_at(const em_body *body, const double *frame, const double *x, em_joint_state *joint)
{
    const double *axis = frame + 12, ratio = frame[15];
    double q[6];
    *joint = (em_joint_state){.count = body->count, .R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}};
    for (int k = 0; k < body->count; ++k) q[k] = x[body->coordinates[k]];
    if (body->joint == EM_REVOLUTE || body->joint == EM_PRISMATIC) {
        const double moved = ratio * q[0] + frame[16];
        for (int i = 0; i < 3; ++i) (body->joint == EM_REVOLUTE ? joint->turn : joint->slide)[0][i] = ratio * axis[i];
        if (body->joint == EM_REVOLUTE) em_rotation_of(axis, cos(moved), 1.0 - cos(moved), sin(moved), joint->R);
        else for (int i = 0; i < 3; ++i) joint->p[i] = moved * axis[i];
    }
    if (body->joint == EM_SPHERICAL || body->joint == EM_FREE) em_rodrigues_joint(q + body->count - 3, joint);
    if (body->joint == EM_FREE)
        for (int i = 0; i < 3; ++i) joint->p[i] = q[i], joint->slide[i][i] = 1.0;
}

/* R (3, 3), p (3): a point y of the body is p + R y in the ground's frame. */
static inline void em_body_pose(const em_model *model, int body, const double *x, const double *frames, double *R,
                                double *p)
{
    em_joint_state joint;
    double inner[9], y[3];
    memcpy(R, (const double[]){1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, 9 * sizeof *R);
    memset(p, 0, 3 * sizeof *p);
    for (; body >= 0; body = model->bodies[body].parent) {
        const double *frame = frames + EM_FRAME * body;
        em_joint_at(&model->bodies[body], frame, x, &joint);
        em_rotations(joint.R, R, inner);
        em_rotations(frame + 3, inner, R);
        em_rotated(joint.R, p, y);
        for (int i = 0; i < 3; ++i) y[i] += joint.p[i];
        em_rotated(frame + 3, y, p);
        for (int i = 0; i < 3; ++i) p[i] += frame[i];
    }
}

/* Turns the columns of J (6, n), velocities and angular velocities. */
static inline void em_turned_columns(const double *R, int n, double *J)
{
    for (int k = 0; k < n; ++k)
        for (double *part = J + k; part < J + 6 * n; part += 3 * n) {
            const double a[3] = {part[0], part[n], part[2 * n]};
            double b[3];
            em_rotated(R, a, b);
            for (int i = 0; i < 3; ++i) part[i * n] = b[i];
        }
}

/* J (6, n): in the ground's axes, the velocity of a point (3) of the body and the angular velocity, by xdot (n). */
static inline void em_body_jacobian(const em_model *model, int body, const double *point, const double *x,
                                    const double *frames, int n, double *J)
{
    em_joint_state joint;
    double r[3] = {point[0], point[1], point[2]}, turned[3], v[3];
    memset(J, 0, 6 * n * sizeof *J);
    for (; body >= 0; body = model->bodies[body].parent) {
        const double *frame = frames + EM_FRAME * body;
        em_joint_at(&model->bodies[body], frame, x, &joint);
        em_rotated(joint.R, r, turned);
        em_turned_columns(joint.R, n, J);
        for (int k = 0; k < joint.count; ++k) {
            double *column = J + model->bodies[body].coordinates[k];
            em_crossed(joint.turn[k], turned, v);
            for (int i = 0; i < 3; ++i)
                column[i * n] += joint.slide[k][i] + v[i], column[(3 + i) * n] += joint.turn[k][i];
        }
        em_turned_columns(frame + 3, n, J);
        for (int i = 0; i < 3; ++i) turned[i] += joint.p[i];
        em_rotated(frame + 3, turned, r);
        for (int i = 0; i < 3; ++i) r[i] += frame[i];
    }
}

#endif
