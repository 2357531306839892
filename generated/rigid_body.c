/* eigenmotion generate rigid_body.py */
/* input sha256:6a1fe9ffd82e911c66db48438e1fdf5de1dc79f32cda1ff870839cf9ae9e6072 */
/* body sha256:d55a970aae9447b5bcab666d4fb5965b3d1de4ca31af68c947dc2a39e2696adc */
/* rigid_body: equations of motion, eigenfactor formulation.
 *
 * State, 18 numbers:
 *   x    y[0 .. 3)
 *   eta  y[3 .. 6)
 *   C    y[6 .. 15)
 *   s    y[15 .. 18)
 *
 * Blocks of M that do not couple:
 *   1: psi, theta, phi (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   dV/dx: there is no potential energy
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dpsi: M does not depend on it
 *
 * Operations of the straight-line part:
 *   eigenfactor: 14 additions, 43 multiplications, 4 function calls
 *   triangular root: 17 additions, 54 multiplications, 4 function calls
 *   projection: 9 additions, 33 multiplications, 4 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 3,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 18,         /* numbers of a state */
    N_C = 9,              /* of which C, */
    N_S = 3,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 12,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 3,
    N_PREPARED = 9,       /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 4,          /* inputs, parameters and the time */
    N_ARGUMENTS = 10,     /* x, v and these: what motion depends on */
    N1 = 3,               /* psi, theta, phi */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1])
{
    const real J3 = c[2];
    const real theta = x[1];
    const real sin_theta = em_sin(theta);
    const real theta_dot = v[1];
    const real cos_theta = em_cos(theta);
    const real z_2 = theta_dot*cos_theta;
    const real z_3 = sin_theta*z_2;
    const real J1 = c[0];
    const real phi_dot = v[2];
    const real phi = x[2];
    const real sin_phi = em_sin(phi);
    const real cos_phi = em_cos(phi);
    const real z_6 = sin_phi*cos_phi;
    const real z_7 = phi_dot*z_6;
    const real z_8 = sin_theta*sin_theta*z_7;
    const real z_9 = sin_phi*sin_phi;
    const real J2 = c[1];
    const real z_10 = cos_phi*cos_phi;
    Mdot1[0][0] = (-2.0)*(J3*z_3 - J1*(z_8 + z_9*z_3) - J2*(-(z_8 - z_10*z_3)));
    const real c_0 = c[3];
    const real z_11 = phi_dot*sin_theta;
    Mdot1[0][1] = Mdot1[1][0] = c_0*(z_10*z_11 + z_2*z_6 - z_9*z_11);
    const real c_1 = c[4];
    Mdot1[1][1] = -c_1*z_7;
    Mdot1[0][2] = Mdot1[2][0] = -theta_dot*J3*sin_theta;
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real psi_dot = v[0];
    const real z_12 = psi_dot*sin_theta;
    const real z_13 = J2*(theta_dot*sin_phi - cos_phi*z_12);
    const real z_14 = J1*(theta_dot*cos_phi + sin_phi*z_12);
    f1[1] = -(cos_theta*(psi_dot*cos_phi*z_13 - psi_dot*sin_phi*z_14) + J3*(phi_dot + psi_dot*cos_theta)*z_12);
    f1[2] = sin_phi*(z_12*z_13 - theta_dot*z_14) + cos_phi*(theta_dot*z_13 + z_12*z_14);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* psi, theta, phi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[3], y[4], y[5] };
    const real *const C1 = y + 6, *const s1 = y + 15;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* psi, theta, phi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[3], y[4], y[5] };
    const real *const C1 = y + 6, *const s1 = y + 15;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];

    real Mdot1[N1][N1], f1[N1];
    eigenfactor_motion(y, dy, c, Mdot1, f1);

    /* psi, theta, phi: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 6, *const s1_dot = dy + 15;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

    /* etadot = a (45) */
    dy[3] = a1[0];
    dy[4] = a1[1];
    dy[5] = a1[2];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[8])
{
    const real J3 = c[2];
    const real theta = x[1];
    const real cos_theta = em_cos(theta);
    const real sin_theta = em_sin(theta);
    const real z_2 = sin_theta*sin_theta;
    const real J1 = c[0];
    const real phi = x[2];
    const real sin_phi = em_sin(phi);
    const real z_4 = sin_phi*sin_phi;
    const real J2 = c[1];
    const real cos_phi = em_cos(phi);
    const real z_6 = cos_phi*cos_phi;
    M1[0][0] = J3*(cos_theta*cos_theta) + z_2*(J1*z_4) + z_2*(J2*z_6);
    const real c_0 = c[3];
    const real z_7 = sin_phi*cos_phi;
    M1[1][0] = sin_theta*(c_0*z_7);
    M1[1][1] = J1*z_6 + J2*z_4;
    M1[2][0] = J3*cos_theta;
    M1[2][1] = em_real(0.0);
    M1[2][2] = J3;
    shared[0] = sin_theta;
    shared[1] = cos_theta;
    shared[2] = z_2;
    shared[3] = z_7;
    shared[4] = z_4;
    shared[5] = z_6;
    shared[6] = cos_phi;
    shared[7] = sin_phi;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[8],
                                 real Mdot1[N1][N1], real f1[N1])
{
    const real J3 = c[2];
    const real sin_theta = shared[0];
    const real theta_dot = v[1];
    const real cos_theta = shared[1];
    const real z_8 = theta_dot*cos_theta;
    const real z_9 = sin_theta*z_8;
    const real J1 = c[0];
    const real z_2 = shared[2];
    const real phi_dot = v[2];
    const real z_7 = shared[3];
    const real z_10 = phi_dot*z_7;
    const real z_11 = z_2*z_10;
    const real z_4 = shared[4];
    const real J2 = c[1];
    const real z_6 = shared[5];
    Mdot1[0][0] = (-2.0)*(J3*z_9 - J1*(z_11 + z_4*z_9) - J2*(-(z_11 - z_6*z_9)));
    const real c_0 = c[3];
    const real z_12 = phi_dot*sin_theta;
    Mdot1[0][1] = Mdot1[1][0] = c_0*(z_6*z_12 + z_7*z_8 - z_4*z_12);
    const real c_1 = c[4];
    Mdot1[1][1] = -c_1*z_10;
    Mdot1[0][2] = Mdot1[2][0] = -theta_dot*J3*sin_theta;
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real psi_dot = v[0];
    const real cos_phi = shared[6];
    const real sin_phi = shared[7];
    const real z_13 = psi_dot*sin_theta;
    const real z_14 = J2*(theta_dot*sin_phi - cos_phi*z_13);
    const real z_15 = J1*(theta_dot*cos_phi + sin_phi*z_13);
    f1[1] = -(cos_theta*(psi_dot*cos_phi*z_14 - psi_dot*sin_phi*z_15) + J3*(phi_dot + psi_dot*cos_theta)*z_13);
    f1[2] = sin_phi*(z_13*z_14 - theta_dot*z_15) + cos_phi*(theta_dot*z_14 + z_13*z_15);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[8];
    triangular_masses(y, c, M1, shared);

    /* psi, theta, phi: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[3], y[4], y[5] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];

    real Mdot1[N1][N1], f1[N1];
    triangular_motion(dy, c, shared, Mdot1, f1);

    /* psi, theta, phi: a = L^-1 f - Phi eta */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* etadot = a (45) */
    dy[3] = a1[0];
    dy[4] = a1[1];
    dy[5] = a1[2];
    for (int k = 2*N; k < N_STATE; ++k) dy[k] = em_real(0.0);
    return 0;
}

/* dy <- f(t, y): the published equations, or in mode 1 those of the triangular root. */
EM_ACROSS int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags,
                        real *dy, em_fault *fault)
{
    if (mode) return rhs_cholesky(t, y, c, u, flags, dy, fault);
    return rhs_eigenfactor(t, y, c, u, memory, flags, dy, fault);
}

#endif
#if EM_HOLDS(EM_MODEL) && !defined(EM_NODES_ALONE)

/* M of the blocks that vary */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1], real shared[6])
{
    const real J3 = c[2];
    const real theta = x[1];
    const real cos_theta = em_cos(theta);
    const real sin_theta = em_sin(theta);
    const real z_2 = sin_theta*sin_theta;
    const real J1 = c[0];
    const real phi = x[2];
    const real sin_phi = em_sin(phi);
    const real z_4 = sin_phi*sin_phi;
    const real J2 = c[1];
    const real cos_phi = em_cos(phi);
    const real z_6 = cos_phi*cos_phi;
    M1[0][0] = J3*(cos_theta*cos_theta) + z_2*(J1*z_4) + z_2*(J2*z_6);
    const real c_0 = c[3];
    const real z_7 = sin_phi*cos_phi;
    M1[0][1] = M1[1][0] = sin_theta*(c_0*z_7);
    M1[1][1] = J1*z_6 + J2*z_4;
    M1[0][2] = M1[2][0] = J3*cos_theta;
    M1[1][2] = M1[2][1] = em_real(0.0);
    M1[2][2] = J3;
    shared[0] = sin_theta;
    shared[1] = cos_theta;
    shared[2] = z_2;
    shared[3] = z_7;
    shared[4] = z_4;
    shared[5] = z_6;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[6],
                             real Mdot1[N1][N1])
{
    const real J3 = c[2];
    const real sin_theta = shared[0];
    const real theta_dot = v[1];
    const real cos_theta = shared[1];
    const real z_8 = theta_dot*cos_theta;
    const real z_9 = sin_theta*z_8;
    const real J1 = c[0];
    const real z_2 = shared[2];
    const real phi_dot = v[2];
    const real z_7 = shared[3];
    const real z_10 = phi_dot*z_7;
    const real z_11 = z_2*z_10;
    const real z_4 = shared[4];
    const real J2 = c[1];
    const real z_6 = shared[5];
    Mdot1[0][0] = (-2.0)*(J3*z_9 - J1*(z_11 + z_4*z_9) - J2*(-(z_11 - z_6*z_9)));
    const real c_0 = c[3];
    const real z_12 = phi_dot*sin_theta;
    Mdot1[0][1] = Mdot1[1][0] = c_0*(z_6*z_12 + z_7*z_8 - z_4*z_12);
    const real c_1 = c[4];
    Mdot1[1][1] = -c_1*z_10;
    Mdot1[0][2] = Mdot1[2][0] = -theta_dot*J3*sin_theta;
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
}

#endif
#ifdef EM_ON_LANES

#ifdef EM_ON_DUALS
#include "em_rate_jacobian.h"
#else
/* Compiled with -DEM_ON_LANES this file is its right-hand side on vectors, to be linked beside. */
__attribute__((noinline)) /* once, though stages call it from several places */
static void rhs_on_lanes(int mode, const double *t, const double *y, const double *c, const double *u, int flags,
                         double *dy)
{
    em_fault fault;
    model_rhs(mode, *(const real *)t, (const real *)y, (const real *)c, (const real *)u, NULL, flags, (real *)dy,
              &fault);
}

/* xdot alone (20) */
static void velocity_on_lanes(const double *t, const double *y, const double *c, double *v)
{
    em_fault fault;
    velocities(*(const real *)t, (const real *)y, (const real *)c, (real *)v, &fault);
}

#ifdef EM_NODES_ALONE /* lanes for the nodes of one run, none for runs */
enum { EM_REMEMBERED = 0 };
#define em_flock_run NULL
#else
#include "em_lane_factors.h"

enum { N_PIVOTS = 3 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], shared[6];
    settled_masses(y, c, M1, shared);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1], e[2] };
    if (mode) em_backward(N1, memory + 0, memory + 9, v1);
    else em_velocity_of_eta(N1, y + 6, y + 15, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s.
 * *done becomes 0 in lanes that are settled number by number instead, as where the mode changes;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], shared[6];
    settled_masses(y, c, M1, shared);
    real eta1[N1] = { y[3], y[4], y[5] };
    *done &= em_refresh(N1, M1[0], y + 6, y + 15, mode ? NULL : eta1);
    y[3] = eta1[0];
    y[4] = eta1[1];
    y[5] = eta1[2];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 9, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 15);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        real time = em_time_on_lanes(N1, y + 6, y + 15, Mdot1[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes rigid_body_lanes;
em_lanes rigid_body_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double psi_dot = v[0];
    const double J3 = c[2];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double theta_dot = v[1];
    const double sin_theta = em_sin(theta);
    const double z_2 = theta_dot*sin_theta;
    const double z_3 = cos_theta*z_2;
    const double J1 = c[0];
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double cos_phi = em_cos(phi);
    const double z_6 = sin_phi*cos_phi;
    const double phi_dot = v[2];
    const double z_7 = z_6*(phi_dot*(sin_theta*sin_theta));
    const double z_8 = sin_phi*sin_phi;
    const double J2 = c[1];
    const double z_9 = cos_phi*cos_phi;
    const double c_0 = c[3];
    const double z_10 = phi_dot*z_2;
    bias[0] = 2.0*psi_dot*(J3*z_3 - J1*(z_7 + z_8*z_3) - J2*(-(z_7 - z_9*z_3))) + J3*z_10 - c_0*(z_9*z_10 +
        z_6*(cos_theta*(theta_dot*theta_dot)) - z_8*z_10);
    const double z_11 = psi_dot*sin_theta;
    const double z_12 = J2*(theta_dot*sin_phi - cos_phi*z_11);
    const double z_13 = J1*(theta_dot*cos_phi + sin_phi*z_11);
    const double z_14 = psi_dot*cos_theta;
    const double z_15 = theta_dot*z_6;
    const double z_16 = phi_dot*z_11;
    const double c_1 = c[4];
    bias[1] = -((cos_theta*(psi_dot*cos_phi*z_12 - psi_dot*sin_phi*z_13) + J3*(phi_dot + z_14)*z_11) +
        (c_0*(z_14*z_15 + z_9*z_16 - z_8*z_16) - phi_dot*c_1*z_15));
    bias[2] = (sin_phi*(z_11*z_12 - theta_dot*z_13) + cos_phi*(theta_dot*z_12 + z_11*z_13)) + psi_dot*J3*z_2;
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double psi_dot = v[0];
    const double J3 = c[2];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double J1 = c[0];
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double z_2 = sin_phi*sin_phi;
    const double sin_theta = em_sin(theta);
    const double z_4 = sin_theta*sin_theta;
    const double J2 = c[1];
    const double cos_phi = em_cos(phi);
    const double z_6 = cos_phi*cos_phi;
    const double theta_dot = v[1];
    const double c_0 = c[3];
    const double z_7 = sin_phi*sin_theta*(cos_phi*c_0);
    const double phi_dot = v[2];
    e[0] = 0.5*(psi_dot*(psi_dot*(J3*(cos_theta*cos_theta) + J1*z_2*z_4 + J2*z_4*z_6) + theta_dot*z_7 +
        cos_theta*(phi_dot*J3)) + theta_dot*(psi_dot*z_7 + theta_dot*(J1*z_6 + J2*z_2)) + phi_dot*(J3*(phi_dot +
        psi_dot*cos_theta)));
    e[1] = 0.0;
    e[2] = 0.0;
    e[3] = 0.0;
}

/* out (n_outputs), from x, v, a = xddot, lambda */
EM_ACROSS void observe(double t, const double *restrict x, const double *restrict v, const double *restrict a,
                       const double *restrict lambda, const double *restrict c, const double *restrict u,
                       double *restrict out)
{
}

/* y (n) = P(x, t) v: the quasi-velocities                                                                       (3) */
EM_ACROSS void quasi(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                     double *restrict y)
{
    const double theta_dot = v[1];
    const double phi = x[2];
    const double cos_phi = em_cos(phi);
    const double sin_phi = em_sin(phi);
    const double psi_dot = v[0];
    const double theta = x[1];
    const double sin_theta = em_sin(theta);
    const double z_3 = psi_dot*sin_theta;
    y[0] = theta_dot*cos_phi + sin_phi*z_3;
    y[1] = -(theta_dot*sin_phi - cos_phi*z_3);
    const double phi_dot = v[2];
    const double cos_theta = em_cos(theta);
    y[2] = phi_dot + psi_dot*cos_theta;
}

/* p: what the drawing is made of, shape by shape */
EM_ACROSS void draw(double t, const double *restrict x, const double *restrict c, double *restrict p)
{
    const double phi = x[2];
    const double cos_phi = em_cos(phi);
    const double psi = x[0];
    const double cos_psi = em_cos(psi);
    const double sin_psi = em_sin(psi);
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double sin_phi = em_sin(phi);
    const double z_5 = cos_theta*sin_phi;
    const double z_6 = cos_phi*cos_psi - sin_psi*z_5;
    const double c_2 = c[5];
    const double z_7 = z_6*c_2;
    const double sin_theta = em_sin(theta);
    const double c_3 = c[6];
    const double z_9 = sin_theta*c_3;
    const double z_10 = sin_psi*z_9;
    const double z_11 = cos_theta*cos_phi;
    const double c_4 = c[7];
    const double z_12 = (sin_phi*cos_psi + sin_psi*z_11)*c_4;
    const double z_13 = z_10 - z_12;
    const double z_14 = -z_7 - z_13;
    p[0] = (1.0/20.0)*z_14;
    const double z_15 = cos_phi*sin_psi + cos_psi*z_5;
    const double z_16 = z_15*c_2;
    const double z_17 = cos_psi*z_9;
    const double z_18 = (sin_phi*sin_psi - cos_psi*z_11)*c_4;
    const double z_19 = z_17 + z_18;
    const double z_20 = z_19 - z_16;
    p[1] = (1.0/20.0)*z_20;
    const double z_21 = sin_phi*sin_theta;
    const double z_22 = c_2*z_21;
    const double z_23 = cos_theta*c_3;
    const double z_24 = c_4*(sin_theta*cos_phi);
    const double z_25 = z_23 + z_24;
    const double z_26 = z_22 + z_25;
    p[2] = ((-1.0/20.0))*z_26;
    const double z_27 = z_10 + z_12;
    const double z_28 = z_27 - z_7;
    p[3] = (1.0/20.0)*z_28;
    const double z_29 = z_17 - z_18;
    const double z_30 = -z_16 - z_29;
    p[4] = (1.0/20.0)*z_30;
    const double z_31 = z_23 - z_24;
    const double z_32 = z_31 - z_22;
    p[5] = (1.0/20.0)*z_32;
    const double z_33 = z_7 + z_27;
    p[6] = ((-1.0/20.0))*z_33;
    const double z_34 = z_16 - z_29;
    p[7] = ((-1.0/20.0))*z_34;
    const double z_35 = z_22 + z_31;
    p[8] = ((-1.0/20.0))*z_35;
    const double z_36 = z_7 - z_13;
    p[9] = ((-1.0/20.0))*z_36;
    const double z_37 = z_16 + z_19;
    p[10] = ((-1.0/20.0))*z_37;
    const double z_38 = z_25 - z_22;
    p[11] = (1.0/20.0)*z_38;
    p[12] = (1.0/20.0)*z_36;
    p[13] = (1.0/20.0)*z_37;
    p[14] = ((-1.0/20.0))*z_38;
    p[15] = (1.0/20.0)*z_33;
    p[16] = (1.0/20.0)*z_34;
    p[17] = (1.0/20.0)*z_35;
    p[18] = ((-1.0/20.0))*z_28;
    p[19] = ((-1.0/20.0))*z_30;
    p[20] = ((-1.0/20.0))*z_32;
    p[21] = ((-1.0/20.0))*z_14;
    p[22] = ((-1.0/20.0))*z_20;
    p[23] = (1.0/20.0)*z_26;
    const double c_5 = c[8];
    p[24] = z_6*c_5;
    p[25] = z_15*c_5;
    p[26] = c_5*z_21;
}

#endif
#if EM_HOLDS(EM_DERIVATIVES)

/* --- partial derivatives --- */

/* dM (n, n, n): dM[k, i, j] = dM_ij / dx_k */
EM_RARE /* no step calls it */
EM_ACROSS void mass_matrix_gradient(double t, const double *restrict x, const double *restrict c,
                                    double *restrict dM)
{
    memset(dM, 0, sizeof *dM * N * N * N);
    const double J3 = c[2];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    const double z_2 = cos_theta*sin_theta;
    const double J1 = c[0];
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double z_4 = sin_phi*sin_phi;
    const double J2 = c[1];
    const double cos_phi = em_cos(phi);
    const double z_6 = cos_phi*cos_phi;
    dM[9] = (-2.0)*(J3*z_2 - J1*z_4*z_2 - J2*z_6*z_2);
    const double z_7 = J1 - J2;
    const double z_8 = z_7*(sin_phi*cos_phi);
    dM[12] = dM[10] = cos_theta*z_8;
    dM[15] = dM[11] = -J3*sin_theta;
    dM[18] = 2.0*(z_8*(sin_theta*sin_theta));
    const double z_9 = sin_theta*z_7;
    dM[21] = dM[19] = z_6*z_9 - z_4*z_9;
    dM[22] = (-2.0)*z_8;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double psi_dot = v[0];
    const double J3 = c[2];
    const double theta_dot = v[1];
    const double theta = x[1];
    const double sin_theta = em_sin(theta);
    const double z_1 = sin_theta*sin_theta;
    const double z_2 = theta_dot*z_1;
    const double cos_theta = em_cos(theta);
    const double z_4 = theta_dot*(cos_theta*cos_theta);
    const double J1 = c[0];
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double cos_phi = em_cos(phi);
    const double z_7 = sin_phi*cos_phi;
    const double z_8 = J1*z_7;
    const double phi_dot = v[2];
    const double z_9 = cos_theta*sin_theta;
    const double z_10 = phi_dot*z_9;
    const double z_11 = sin_phi*sin_phi;
    const double z_12 = J1*z_11;
    const double J2 = c[1];
    const double z_13 = cos_phi*cos_phi;
    const double z_14 = J2*z_13;
    const double z_15 = J2*z_7;
    const double z_16 = theta_dot*cos_theta;
    const double z_17 = J1 - J2;
    const double z_18 = z_17*z_13;
    const double z_19 = phi_dot*z_18;
    const double z_20 = theta_dot*theta_dot;
    const double z_21 = z_17*z_7;
    const double z_22 = z_17*z_11;
    const double z_23 = phi_dot*z_22;
    const double z_24 = J3*sin_theta;
    const double z_25 = cos_theta*z_24 - z_12*z_9 - z_14*z_9;
    const double psi_ddot = a[0];
    const double theta_ddot = a[1];
    const double z_26 = cos_theta*z_21;
    const double phi_ddot = a[2];
    D[1] = (2.0*psi_dot*((J3*z_2 - J3*z_4) + (2.0*z_8*z_10 - (z_12*z_2 - z_12*z_4)) - ((z_14*z_2 - z_14*z_4) +
        2.0*z_15*z_10)) + (z_16*z_19 - sin_theta*z_20*z_21 - z_16*z_23) - phi_dot*J3*z_16) - (2.0*z_25*psi_ddot +
        phi_ddot*z_24 - theta_ddot*z_26);
    const double z_27 = phi_dot*z_1;
    const double z_28 = sin_theta*z_16;
    const double z_29 = phi_dot*z_21;
    const double z_30 = theta_dot*sin_theta;
    const double z_31 = cos_theta*z_20;
    const double z_32 = z_1*z_21;
    const double z_33 = sin_theta*theta_ddot;
    D[2] = (2.0*psi_dot*(((J1*z_13*z_27 - z_12*z_27) + 2.0*z_28*z_8) - (2.0*z_28*z_15 + (z_14*z_27 -
        J2*z_11*z_27))) - (4.0*z_29*z_30 - (z_18*z_31 - z_22*z_31))) + (2.0*psi_ddot*z_32 + (z_18*z_33 -
        z_22*z_33));
    D[3] = (-2.0)*(z_16*z_24 - (z_27*z_8 + z_12*z_28) - (z_14*z_28 - z_27*z_15));
    const double z_34 = z_16*z_21;
    const double z_35 = sin_theta*z_19 - sin_theta*z_23;
    D[4] = -(phi_dot*z_24 + 2.0*psi_dot*z_25 - (2.0*z_34 + z_35));
    const double z_36 = theta_dot*z_24;
    D[5] = -(z_36 + (z_22*z_30 - z_18*z_30) - 2.0*psi_dot*z_32);
    const double z_37 = theta_dot*sin_phi;
    const double z_38 = psi_dot*sin_theta;
    const double z_39 = cos_phi*z_38;
    const double z_40 = z_37 - z_39;
    const double z_41 = J2*z_40;
    const double z_42 = psi_dot*cos_phi;
    const double z_43 = theta_dot*cos_phi;
    const double z_44 = sin_phi*z_38;
    const double z_45 = z_43 + z_44;
    const double z_46 = J1*z_45;
    const double z_47 = psi_dot*sin_phi;
    const double z_48 = psi_dot*psi_dot;
    const double z_49 = cos_theta*z_48;
    const double z_50 = psi_dot*cos_theta;
    const double z_51 = phi_dot + z_50;
    const double z_52 = theta_dot*z_21;
    D[7] = -((((sin_theta*(z_41*z_42 - z_46*z_47) + cos_theta*(z_14*z_49 + z_12*z_49)) - (J3*z_50*z_51 -
        J3*z_1*z_48)) + (z_52*z_38 + z_50*z_23 - z_50*z_19)) - psi_ddot*z_26);
    const double z_53 = J2*z_45;
    const double z_54 = J1*z_40;
    const double z_55 = psi_dot*z_16;
    const double z_56 = sin_theta*psi_ddot;
    D[8] = -((cos_theta*((z_41*z_47 - z_42*z_53) + (z_46*z_42 - z_47*z_54)) + ((4.0*z_29*z_38 - (z_18*z_55 -
        z_22*z_55)) - 2.0*(theta_dot*z_23 - theta_dot*z_19))) + (2.0*theta_ddot*z_21 - (z_18*z_56 - z_22*z_56)));
    const double z_57 = J3*z_38;
    D[9] = (z_34 + z_35) + (cos_theta*((cos_phi*z_41 - z_38*z_14) - (sin_phi*z_46 + z_38*z_12)) + (cos_theta*z_57
        + z_51*z_24));
    const double z_58 = z_50*z_21;
    D[10] = -(z_58 + (2.0*z_29 - z_58));
    D[11] = z_57 - (2.0*z_52 + (z_38*z_22 - z_38*z_18));
    const double z_59 = J1*z_47;
    const double z_60 = J2*cos_phi;
    const double z_61 = z_48*z_9;
    const double z_62 = J2*z_42;
    const double z_63 = J1*sin_phi;
    D[13] = -(psi_ddot*z_24 + (J3*z_55 - (sin_phi*(z_16*z_59 - (z_50*z_41 - z_60*z_61)) + cos_phi*(z_16*z_62 -
        (z_50*z_46 + z_63*z_61)))));
    D[14] = -((cos_phi*(z_41*z_38 - theta_dot*z_46) + sin_phi*(z_38*z_53 + theta_dot*z_54)) -
        (sin_phi*(theta_dot*z_41 + z_46*z_38) - cos_phi*(theta_dot*z_53 - z_38*z_54)));
    D[15] = -(z_36 + (sin_phi*((sin_theta*z_41 - z_1*z_62) - z_30*z_63) - cos_phi*(z_30*z_60 - (sin_theta*z_46 +
        z_1*z_59))));
    D[16] = -(z_57 + (sin_phi*(J2*z_44 - (z_46 + J1*z_43)) + cos_phi*(J1*z_39 + (z_41 + J2*z_37))));
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double phi_dot = v[2];
    const double theta_dot = v[1];
    const double theta = x[1];
    const double sin_theta = em_sin(theta);
    const double z_1 = theta_dot*sin_theta;
    const double z_2 = phi_dot*z_1;
    const double phi = x[2];
    const double cos_phi = em_cos(phi);
    const double z_4 = cos_phi*cos_phi;
    const double cos_theta = em_cos(theta);
    const double sin_phi = em_sin(phi);
    const double z_7 = sin_phi*cos_phi;
    const double z_8 = sin_phi*sin_phi;
    const double z_9 = z_2*z_4 + cos_theta*(theta_dot*theta_dot)*z_7 - z_2*z_8;
    const double psi_dot = v[0];
    const double z_10 = sin_theta*sin_theta;
    const double z_11 = phi_dot*z_10*z_7;
    const double z_12 = cos_theta*z_1;
    const double theta_ddot = a[1];
    const double z_13 = sin_theta*z_7;
    const double z_14 = theta_ddot*z_13;
    const double psi_ddot = a[0];
    const double z_15 = psi_ddot*z_10;
    D[0] = (z_9 + 2.0*psi_dot*(z_11 + z_8*z_12)) + (z_14 + z_8*z_15);
    D[1] = -((z_9 + 2.0*psi_dot*(z_11 - z_4*z_12)) + (z_14 - z_4*z_15));
    const double z_16 = psi_dot*sin_theta;
    const double z_17 = theta_dot*z_16;
    const double phi_ddot = a[2];
    D[2] = -((z_2 + 2.0*cos_theta*z_17) - (cos_theta*phi_ddot + psi_ddot*(cos_theta*cos_theta)));
    const double z_18 = theta_dot*cos_phi;
    const double z_19 = sin_phi*z_16;
    const double z_20 = z_18 + z_19;
    const double z_21 = psi_dot*cos_theta;
    const double z_22 = theta_dot*z_7;
    const double z_23 = phi_dot*z_16;
    const double z_24 = 2.0*phi_dot*z_22 - (z_21*z_22 + z_4*z_23 - z_8*z_23);
    const double z_25 = psi_ddot*z_13;
    D[4] = -((sin_phi*z_20*z_21 + z_24) - (z_25 + theta_ddot*z_4));
    const double z_26 = theta_dot*sin_phi;
    const double z_27 = cos_phi*z_16;
    const double z_28 = z_26 - z_27;
    D[5] = (cos_phi*z_28*z_21 + z_24) - (z_25 - theta_ddot*z_8);
    D[6] = (phi_dot + z_21)*z_16;
    D[8] = z_20*z_26 - z_20*z_27;
    D[9] = -(z_18*z_28 + z_19*z_28);
    D[10] = -(z_17 - (phi_ddot + cos_theta*psi_ddot));
}

/* D (n, n_arguments), of P(x, t) v */
EM_RARE /* no explicit step calls it */
EM_ACROSS void quasi_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * N * N_ARGUMENTS);
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double psi_dot = v[0];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double z_2 = psi_dot*cos_theta;
    D[1] = sin_phi*z_2;
    const double theta_dot = v[1];
    const double cos_phi = em_cos(phi);
    const double sin_theta = em_sin(theta);
    const double z_5 = psi_dot*sin_theta;
    D[2] = -(theta_dot*sin_phi - cos_phi*z_5);
    D[3] = sin_phi*sin_theta;
    D[4] = cos_phi;
    D[11] = cos_phi*z_2;
    D[12] = -(theta_dot*cos_phi + sin_phi*z_5);
    D[13] = sin_theta*cos_phi;
    D[14] = -sin_phi;
    D[21] = -z_5;
    D[23] = cos_theta;
    D[25] = 1.0;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes rigid_body_lanes;
EM_WEAK em_lanes rigid_body_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 6, 15, 0, 9 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double J1 = parameters[0];
    const double J2 = parameters[1];
    const double z_0 = J1 - J2;
    prepared[3] = z_0; /* c_0 */
    prepared[4] = 2.0*z_0; /* c_1 */
    const double J3 = parameters[2];
    const double z_1 = sqrt(J3 - z_0);
    prepared[5] = 10.0*z_1; /* c_2 */
    prepared[6] = sqrt(J3); /* c_3 */
    prepared[7] = 10.0*(sqrt(J3 + z_0)); /* c_4 */
    prepared[8] = 0.5*z_1; /* c_5 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {63, ""},
    {63, ""},
    {63, ""}
};

/* What depends on parameters only, once per parameter set: c (N_PREPARED). */
EM_ACROSS int prepare(const double *parameters, double *c, em_fault *fault)
{
    if (em_refuse(declared, 0, N_PARAMETERS, parameters, fault)) return -1;
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    prepared_constants(parameters, c);
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_ACROSS void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double J3 = c[2];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double J1 = c[0];
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double z_2 = sin_phi*sin_phi;
    const double sin_theta = em_sin(theta);
    const double z_4 = sin_theta*sin_theta;
    const double J2 = c[1];
    const double cos_phi = em_cos(phi);
    const double z_6 = cos_phi*cos_phi;
    M[0] = J3*(cos_theta*cos_theta) + J1*z_2*z_4 + J2*z_4*z_6;
    const double c_0 = c[3];
    M[3] = M[1] = sin_phi*sin_theta*cos_phi*c_0;
    M[4] = J1*z_6 + J2*z_2;
    M[6] = M[2] = J3*cos_theta;
    M[7] = M[5] = 0.0;
    M[8] = J3;
}

/* What is factored: motion_bias and its partial derivatives go with it */
EM_ACROSS void factored(double t, const double *x, const double *c, double *M)
{
    mass_matrix(t, x, c, M);
}

/* A (m, n), b (m): A xdot + b = 0                                                                               (8) */
EM_ACROSS void pfaffian(double t, const double *restrict x, const double *restrict c, double *restrict A,
                        double *restrict b)
{
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
EM_ACROSS void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
}

/* crossing (n_events): an event happens where its number passes through zero */
EM_ACROSS void model_events(double t, const double *restrict x, const double *restrict v,
                            const double *restrict c, const double *restrict u, double *restrict crossing)
{
}

#endif
#if !EM_ALONE(EM_ASIDE) && !EM_ALONE(EM_RHS)
#include "em_redundant.h"
#endif
#if EM_HOLDS(EM_DERIVATIVES)
#include "em_derivatives.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* After an accepted step, and at the start: C and s.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    real M1[N1][N1], shared[6];
    settled_masses(y, c, M1, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 15);
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        double time = em_time_of_block(&block1, Mdot1[0], y);
        wanted = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != wanted) {
        if (em_change_mode(&block1, wanted, M1[0], y, memory, fault)) return -1;
        *mode = wanted;
        changed = 1;
    }
    return changed;
}

/* v (n): xdot from a state, in the meaning of its mode. */
EM_ACROSS int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    double M[N*N];
    factored(t, y, c, M);
    if (em_velocity_at(&block1, mode, M, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that an error e (n) of eta makes. */
EM_ACROSS void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, mode, e, y, c, memory, ev);
}

/* row (n_state): a state in the published meaning. */
EM_ACROSS int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                            em_fault *fault)
{
    memcpy(row, y, N_STATE * sizeof *row);
    if (mode == 0) return 0;
    double v[N];
    if (model_velocity(mode, t, y, c, v, fault)) return -1;
    em_publish_block(&block1, v, y, row);
    return 0;
}

/* y (n_state) from x, v (n); eigenfactors continuous with those y holds, if any */
EM_ACROSS int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    double C[N*N] = {0.0}, s[N], eta[N];
    em_spread(N, N1, coordinate1, y + 6, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 6);
    for (int i = 0; i < N1; ++i) y[15 + i] = s[coordinate1[i]];
    memcpy(y, x, N * sizeof *y);
    return 0;
}

/* What follows takes states in the published meaning. */
static int velocity(double t, const double *y, const double *c, double *v, em_fault *fault)
{
    return model_velocity(0, t, y, c, v, fault);
}

static int rhs(double t, const double *y, const double *c, const double *u, double *dy, em_fault *fault)
{
    if (em_coincident_block(&block1, y, fault)) return -1;
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "rigid_body.h"

static const char *const coordinate_names[] = { "psi", "theta", "phi", NULL };
static const char *const parameter_names[] = { "J1", "J2", "J3", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 2.0, 3.0, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 1.2, 1.4 };
static const double initial_v[N] = { 1.971111170334329, 0.15611102464058085, -0.47267558118845315 };
static const int carried[N] = { 1, 1, 1 };
static const char *const quasi_velocity_names[] = { "omega_1", "omega_2", "omega_3", NULL };
static const double initial_y[N] = { 1.8369553312101887, 0.15841602051320158, 0.24157183631778242 };
static const em_shape shapes[] = {
    {"body", 0, 24},
    {"trace", 24, 3}
};
static const em_slice layout[] = {
    {"x", 0, 3},
    {"eta", 3, 3},
    {"C", 6, 9},
    {"s", 15, 3}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "dV/dx: there is no potential energy",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dpsi: M does not depend on it",
    NULL
};

/* What steppers ask of it. */
static const em_dynamics dynamics = {
    .n_C = N_C,
    .n_s = N_S,
    .n_C_delta = N_CD,
    .n_s_delta = N_SD,
    .n_memory = N_MEMORY,
    .second_order = EM_SECOND_ORDER,
    .settles = 1,
    .rhs = model_rhs,
    .settle = model_settle,
    .velocity = model_velocity,
    .velocity_error = model_velocity_error,
    .publish = model_publish,
    .events = model_events,
    .factored = factored,
    .acceleration = em_acceleration,
    .worst_factors = em_worst_factors_of,
};

/* What of the stepper is told which model it is of: a run, */
static int simulate(em_run *run) { return em_simulate(&rigid_body_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&rigid_body_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&rigid_body_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&rigid_body_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&rigid_body_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&rigid_body_model, run, mode); }

const em_model rigid_body_model = {
    .abi = EM_ABI,
    .name = "rigid_body",
    .formulation = "eigenfactor",
    .close_eigenvalues = "bounded",
    .schur = "auto",
    .n = N,
    .m = N_ROWS,
    .h = N_POSITIONS,
    .n_state = N_STATE,
    .n_parameters = N_PARAMETERS,
    .n_prepared = N_PREPARED,
    .n_inputs = N_INPUTS,
    .n_outputs = N_OUTPUTS,
    .n_events = N_EVENTS,
    .n_layout = 4,
    .n_left_out = 7,
    .coordinates = coordinate_names,
    .parameters = parameter_names,
    .parameter_defaults = parameter_defaults,
    .inputs = input_names,
    .input_defaults = input_defaults,
    .initial_x = initial_x,
    .initial_v = initial_v,
    .outputs = output_names,
    .events = event_names,
    .event_direction = event_direction,
    .event_terminal = event_terminal,
    .layout = layout,
    .left_out = left_out,
    .block = block,
    .scales = scales,
    .carried = carried,
    .conserves_energy = 1,
    .prepare = prepare,
    .state = state,
    .velocity = velocity,
    .rhs = rhs,
    .mass_matrix = mass_matrix,
    .mass_matrix_gradient = mass_matrix_gradient,
    .pfaffian = pfaffian,
    .position = position,
    .acceleration = em_acceleration,
    .project = em_project,
    .redundant = em_redundant,
    .energy = energy,
    .eigenfactors = em_eigenfactors_of,
    .output = em_observe,
    .motion_jacobian = em_motion_jacobian,
    .simulate = simulate,
    .interpolate = interpolate,
    .release = release,
    .n_quasi = N,
    .quasi_velocities = quasi_velocity_names,
    .initial_y = initial_y,
    .quasi = quasi,
    .event = model_events,
    .lanes = &rigid_body_lanes,
    .enter = enter,
    .board = em_member_board,
    .look = em_member_look,
    .open = open_run,
    .advance = em_handle_advance,
    .now = em_handle_now,
    .publish = em_handle_publish,
    .saved = saved,
    .save = em_handle_save,
    .restore = em_handle_restore,
    .close = em_handle_close,
    .again = em_handle_again,
    .n_shapes = 2,
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .quasi_partials = quasi_partials,
    .motion_along = em_motion_along,
    .dynamics = &dynamics,
    .declared = declared,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
