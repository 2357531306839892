/* eigenmotion generate double_pendulum.py */
/* input sha256:2aa8c78fd5de9dcc95b82b3b59485521f0f69d4545624273923556883aeddf96 */
/* body sha256:1bda4ba0e6101003040d6f52a4d4a5e14549fd1ca2a96369a5ef9288c6d4b3ce */
/* double_pendulum: equations of motion, eigenfactor formulation.
 *
 * State, 10 numbers:
 *   x    y[0 .. 2)
 *   eta  y[2 .. 4)
 *   C    y[4 .. 8)
 *   s    y[8 .. 10)
 *
 * Blocks of M that do not couple:
 *   1: theta1, theta2 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *
 * Operations of the straight-line part:
 *   eigenfactor: 6 additions, 13 multiplications, 4 function calls
 *   triangular root: 7 additions, 16 multiplications, 4 function calls
 *   projection: 4 additions, 11 multiplications, 4 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 2,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 10,         /* numbers of a state */
    N_C = 4,              /* of which C, */
    N_S = 2,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 6,         /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 5,
    N_PREPARED = 13,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 6,          /* inputs, parameters and the time */
    N_ARGUMENTS = 10,     /* x, v and these: what motion depends on */
    N1 = 2,               /* theta1, theta2 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[6];
    const real theta1_dot = v[0];
    const real theta2 = x[1];
    const real cos_theta2 = em_cos(theta2);
    const real theta1 = x[0];
    const real sin_theta1 = em_sin(theta1);
    const real z_2 = cos_theta2*sin_theta1;
    const real theta2_dot = v[1];
    const real cos_theta1 = em_cos(theta1);
    const real sin_theta2 = em_sin(theta2);
    const real z_5 = cos_theta1*sin_theta2;
    Mdot1[0][1] = Mdot1[1][0] = -(c_1*(theta1_dot*z_2 + theta2_dot*z_5) - c_1*(theta1_dot*z_5 + theta2_dot*z_2));
    Mdot1[1][1] = em_real(0.0);
    const real z_6 = theta1_dot*theta2_dot*(c_1*(z_2 - z_5));
    const real c_3 = c[8];
    f1[0] = -(z_6 + sin_theta1*c_3);
    const real c_4 = c[9];
    f1[1] = z_6 - sin_theta2*c_4;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* theta1, theta2: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[2], y[3] };
    const real *const C1 = y + 4, *const s1 = y + 8;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* theta1, theta2: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[2], y[3] };
    const real *const C1 = y + 4, *const s1 = y + 8;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    real Mdot1[N1][N1], f1[N1];
    eigenfactor_motion(y, dy, c, Mdot1, f1);

    /* theta1, theta2: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 4, *const s1_dot = dy + 8;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

    /* etadot = a (45) */
    dy[2] = a1[0];
    dy[3] = a1[1];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[4])
{
    const real c_0 = c[5];
    M1[0][0] = c_0;
    const real c_1 = c[6];
    const real theta1 = x[0];
    const real cos_theta1 = em_cos(theta1);
    const real theta2 = x[1];
    const real cos_theta2 = em_cos(theta2);
    const real sin_theta1 = em_sin(theta1);
    const real sin_theta2 = em_sin(theta2);
    M1[1][0] = c_1*(cos_theta1*cos_theta2 + sin_theta1*sin_theta2);
    const real c_2 = c[7];
    M1[1][1] = c_2;
    shared[0] = cos_theta2;
    shared[1] = sin_theta1;
    shared[2] = cos_theta1;
    shared[3] = sin_theta2;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[4],
                                 real Mdot1[N1][N1], real f1[N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[6];
    const real theta1_dot = v[0];
    const real cos_theta2 = shared[0];
    const real sin_theta1 = shared[1];
    const real z_4 = cos_theta2*sin_theta1;
    const real theta2_dot = v[1];
    const real cos_theta1 = shared[2];
    const real sin_theta2 = shared[3];
    const real z_5 = cos_theta1*sin_theta2;
    Mdot1[0][1] = Mdot1[1][0] = -(c_1*(theta1_dot*z_4 + theta2_dot*z_5) - c_1*(theta1_dot*z_5 + theta2_dot*z_4));
    Mdot1[1][1] = em_real(0.0);
    const real z_6 = theta1_dot*theta2_dot*(c_1*(z_4 - z_5));
    const real c_3 = c[8];
    f1[0] = -(z_6 + sin_theta1*c_3);
    const real c_4 = c[9];
    f1[1] = z_6 - sin_theta2*c_4;
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[4];
    triangular_masses(y, c, M1, shared);

    /* theta1, theta2: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[2], y[3] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    real Mdot1[N1][N1], f1[N1];
    triangular_motion(dy, c, shared, Mdot1, f1);

    /* theta1, theta2: a = L^-1 f - Phi eta */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* etadot = a (45) */
    dy[2] = a1[0];
    dy[3] = a1[1];
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
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1], real shared[4])
{
    const real c_0 = c[5];
    M1[0][0] = c_0;
    const real c_1 = c[6];
    const real theta1 = x[0];
    const real cos_theta1 = em_cos(theta1);
    const real theta2 = x[1];
    const real cos_theta2 = em_cos(theta2);
    const real sin_theta1 = em_sin(theta1);
    const real sin_theta2 = em_sin(theta2);
    M1[0][1] = M1[1][0] = c_1*(cos_theta1*cos_theta2 + sin_theta1*sin_theta2);
    const real c_2 = c[7];
    M1[1][1] = c_2;
    shared[0] = cos_theta2;
    shared[1] = sin_theta1;
    shared[2] = cos_theta1;
    shared[3] = sin_theta2;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[4],
                             real Mdot1[N1][N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[6];
    const real theta1_dot = v[0];
    const real cos_theta2 = shared[0];
    const real sin_theta1 = shared[1];
    const real z_4 = cos_theta2*sin_theta1;
    const real theta2_dot = v[1];
    const real cos_theta1 = shared[2];
    const real sin_theta2 = shared[3];
    const real z_5 = cos_theta1*sin_theta2;
    Mdot1[0][1] = Mdot1[1][0] = -(c_1*(theta1_dot*z_4 + theta2_dot*z_5) - c_1*(theta1_dot*z_5 + theta2_dot*z_4));
    Mdot1[1][1] = em_real(0.0);
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

enum { N_PIVOTS = 2 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], shared[4];
    settled_masses(y, c, M1, shared);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1] };
    if (mode) em_backward(N1, memory + 0, memory + 4, v1);
    else em_velocity_of_eta(N1, y + 4, y + 8, v1);
    v[0] = v1[0];
    v[1] = v1[1];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s.
 * *done becomes 0 in lanes that are settled number by number instead, as where the mode changes;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], shared[4];
    settled_masses(y, c, M1, shared);
    real eta1[N1] = { y[2], y[3] };
    *done &= em_refresh(N1, M1[0], y + 4, y + 8, mode ? NULL : eta1);
    y[2] = eta1[0];
    y[3] = eta1[1];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 4, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 8);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        real time = em_time_on_lanes(N1, y + 4, y + 8, Mdot1[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes double_pendulum_lanes;
em_lanes double_pendulum_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2,
    N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double theta1_dot = v[0];
    const double theta2_dot = v[1];
    const double c_1 = c[6];
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double z_2 = cos_theta2*sin_theta1;
    const double cos_theta1 = em_cos(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double z_5 = cos_theta1*sin_theta2;
    const double z_6 = theta1_dot*theta2_dot*(c_1*(z_2 - z_5));
    const double c_3 = c[8];
    const double z_7 = c_1*(theta1_dot*z_2 + theta2_dot*z_5) - c_1*(theta1_dot*z_5 + theta2_dot*z_2);
    bias[0] = -((z_6 + sin_theta1*c_3) - theta2_dot*z_7);
    const double c_4 = c[9];
    bias[1] = (z_6 - sin_theta2*c_4) + theta1_dot*z_7;
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double theta1_dot = v[0];
    const double c_0 = c[5];
    const double theta2_dot = v[1];
    const double c_1 = c[6];
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double sin_theta1 = em_sin(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double z_4 = c_1*(cos_theta1*cos_theta2 + sin_theta1*sin_theta2);
    const double c_2 = c[7];
    e[0] = 0.5*(theta1_dot*(theta1_dot*c_0 + theta2_dot*z_4) + theta2_dot*(theta1_dot*z_4 + theta2_dot*c_2));
    e[1] = 0.0;
    e[2] = 0.0;
    const double g = c[4];
    const double m2 = c[1];
    const double l1 = c[2];
    const double l2 = c[3];
    const double c_5 = c[10];
    e[3] = -g*(m2*(l1*cos_theta1 + l2*cos_theta2) + cos_theta1*c_5);
}

/* out (n_outputs), from x, v, a = xddot, lambda */
EM_ACROSS void observe(double t, const double *restrict x, const double *restrict v, const double *restrict a,
                       const double *restrict lambda, const double *restrict c, const double *restrict u,
                       double *restrict out)
{
}

/* p: what the drawing is made of, shape by shape */
EM_ACROSS void draw(double t, const double *restrict x, const double *restrict c, double *restrict p)
{
    const double l2 = c[3];
    const double theta2 = x[1];
    const double sin_theta2 = em_sin(theta2);
    const double l1 = c[2];
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double z_2 = l1*sin_theta1;
    p[0] = p[10] = p[15] = l2*sin_theta2 + z_2;
    const double cos_theta1 = em_cos(theta1);
    const double z_4 = l1*cos_theta1;
    const double cos_theta2 = em_cos(theta2);
    p[1] = p[11] = p[16] = -(z_4 + l2*cos_theta2);
    p[2] = p[3] = p[4] = p[5] = 0.0;
    p[6] = p[8] = p[12] = z_2;
    p[7] = p[9] = p[13] = -z_4;
    const double c_6 = c[11];
    p[14] = c_6;
    const double c_7 = c[12];
    p[17] = c_7;
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
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double l2 = c[3];
    const double l1 = c[2];
    const double m2 = c[1];
    const double z_2 = l2*(l1*m2);
    const double cos_theta1 = em_cos(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double z_5 = cos_theta2*sin_theta1*z_2 - cos_theta1*sin_theta2*z_2;
    dM[2] = dM[1] = -z_5;
    dM[6] = dM[5] = z_5;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta1_dot = v[0];
    const double theta2_dot = v[1];
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double l2 = c[3];
    const double l1 = c[2];
    const double m2 = c[1];
    const double z_2 = l1*m2;
    const double z_3 = l2*z_2;
    const double z_4 = cos_theta1*z_3;
    const double z_5 = cos_theta2*z_4;
    const double sin_theta2 = em_sin(theta2);
    const double sin_theta1 = em_sin(theta1);
    const double z_8 = sin_theta1*z_3;
    const double z_9 = sin_theta2*z_8;
    const double z_10 = theta1_dot*theta2_dot*(z_5 + z_9);
    const double m1 = c[0];
    const double g = c[4];
    const double z_11 = (theta1_dot*z_5 - theta2_dot*z_9) + (theta1_dot*z_9 - theta2_dot*z_5);
    const double z_12 = theta2_dot*z_11;
    const double z_13 = cos_theta2*z_8;
    const double z_14 = sin_theta2*z_4;
    const double z_15 = z_13 - z_14;
    const double theta2_ddot = a[1];
    const double z_16 = z_15*theta2_ddot;
    D[0] = ((z_10 + cos_theta1*(m1*l1*g + g*z_2)) - z_12) - z_16;
    D[1] = z_16 - (z_10 - z_12);
    const double z_17 = theta1_dot*z_15;
    const double z_18 = (theta1_dot*z_13 + theta2_dot*z_14) - (theta1_dot*z_14 + theta2_dot*z_13);
    const double z_19 = theta2_dot*z_15;
    D[3] = z_17 - (z_18 - z_19);
    const double z_20 = theta1_dot*z_11;
    const double theta1_ddot = a[0];
    const double z_21 = z_15*theta1_ddot;
    D[4] = -((z_10 + z_20) + z_21);
    D[5] = z_21 + (z_20 + (z_10 + m2*l2*cos_theta2*g));
    D[6] = -(z_19 + (z_18 + z_17));
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double l1 = c[2];
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double g = c[4];
    const double z_1 = l1*sin_theta1*g;
    const double theta1_ddot = a[0];
    const double z_2 = theta1_ddot*(l1*l1);
    D[0] = z_1 + z_2;
    const double cos_theta1 = em_cos(theta1);
    const double theta2 = x[1];
    const double sin_theta2 = em_sin(theta2);
    const double z_5 = cos_theta1*sin_theta2;
    const double l2 = c[3];
    const double z_6 = l1*l2;
    const double cos_theta2 = em_cos(theta2);
    const double z_8 = cos_theta2*sin_theta1;
    const double theta1_dot = v[0];
    const double theta2_dot = v[1];
    const double z_9 = theta1_dot*theta2_dot;
    const double z_10 = (z_5*z_6 - z_8*z_6)*z_9;
    const double z_11 = theta2_dot*z_5;
    const double z_12 = theta1_dot*z_8;
    const double z_13 = theta2_dot*z_8;
    const double z_14 = theta1_dot*z_5;
    const double z_15 = (z_6*z_11 + z_6*z_12) - (z_6*z_13 + z_6*z_14);
    const double theta2_ddot = a[1];
    const double z_16 = sin_theta1*sin_theta2;
    const double z_17 = cos_theta1*cos_theta2;
    const double z_18 = z_6*z_16 + z_6*z_17;
    D[1] = ((z_1 - z_10) - theta2_dot*z_15) + (z_2 + theta2_ddot*z_18);
    const double m2 = c[1];
    const double z_19 = m2*g;
    const double m1 = c[0];
    const double z_20 = m2*l2;
    const double z_21 = (z_20*z_5 - z_20*z_8)*z_9;
    const double z_22 = (z_20*z_11 + z_20*z_12) - (z_20*z_13 + z_20*z_14);
    const double z_23 = l1*m2;
    const double z_24 = m1*l1 + z_23;
    const double z_25 = z_20*z_16 + z_20*z_17;
    D[2] = ((sin_theta1*(z_19 + m1*g) - z_21) - theta2_dot*z_22) + (2.0*theta1_ddot*z_24 + theta2_ddot*z_25);
    const double z_26 = (z_23*z_5 - z_23*z_8)*z_9;
    const double z_27 = (z_23*z_11 + z_23*z_12) - (z_23*z_13 + z_23*z_14);
    const double z_28 = z_23*z_16 + z_23*z_17;
    D[3] = -((z_26 + theta2_dot*z_27) - theta2_ddot*z_28);
    D[4] = sin_theta1*z_24;
    D[7] = ((l2*sin_theta2*g + z_10) - theta1_dot*z_15) + (theta2_ddot*(l2*l2) + theta1_ddot*z_18);
    D[8] = (z_21 - theta1_dot*z_22) + theta1_ddot*z_25;
    D[9] = ((sin_theta2*z_19 + z_26) - theta1_dot*z_27) + (2.0*theta2_ddot*z_20 + theta1_ddot*z_28);
    D[10] = sin_theta2*z_20;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes double_pendulum_lanes;
EM_WEAK em_lanes double_pendulum_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 4, 8, 0, 4 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double m1 = parameters[0];
    const double l1 = parameters[2];
    const double z_0 = l1*l1;
    const double m2 = parameters[1];
    prepared[5] = m1*z_0 + m2*z_0; /* c_0 */
    const double l2 = parameters[3];
    const double z_1 = l1*m2;
    prepared[6] = l2*z_1; /* c_1 */
    prepared[7] = m2*(l2*l2); /* c_2 */
    const double g = parameters[4];
    const double z_2 = m1*l1;
    prepared[8] = g*z_2 + g*z_1; /* c_3 */
    prepared[9] = m2*l2*g; /* c_4 */
    prepared[10] = z_2; /* c_5 */
    prepared[11] = (1.0/12.0)*l1; /* c_6 */
    prepared[12] = (1.0/12.0)*l2; /* c_7 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
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
    const double c_0 = c[5];
    M[0] = c_0;
    const double c_1 = c[6];
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double sin_theta1 = em_sin(theta1);
    const double sin_theta2 = em_sin(theta2);
    M[2] = M[1] = c_1*(cos_theta1*cos_theta2 + sin_theta1*sin_theta2);
    const double c_2 = c[7];
    M[3] = c_2;
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
    real M1[N1][N1], shared[4];
    settled_masses(y, c, M1, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 8);
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
    em_spread(N, N1, coordinate1, y + 4, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 4);
    for (int i = 0; i < N1; ++i) y[8 + i] = s[coordinate1[i]];
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

#include "double_pendulum.h"

static const char *const coordinate_names[] = { "theta1", "theta2", NULL };
static const char *const parameter_names[] = { "m1", "m2", "l1", "l2", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 1.0, 1.0, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 1.5707963267948966, 1.0471975511965979 };
static const double initial_v[N] = { 0.0, 0.0 };
static const int carried[N] = { 1, 1 };
static const em_shape shapes[] = {
    {"trace", 0, 2},
    {"ground", 2, 2},
    {"line", 4, 4},
    {"line", 8, 4},
    {"disk", 12, 3},
    {"disk", 15, 3}
};
static const em_slice layout[] = {
    {"x", 0, 2},
    {"eta", 2, 2},
    {"C", 4, 4},
    {"s", 8, 2}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
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
static int simulate(em_run *run) { return em_simulate(&double_pendulum_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&double_pendulum_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&double_pendulum_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&double_pendulum_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&double_pendulum_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&double_pendulum_model, run, mode); }

const em_model double_pendulum_model = {
    .abi = EM_ABI,
    .name = "double_pendulum",
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
    .n_left_out = 5,
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
    .event = model_events,
    .lanes = &double_pendulum_lanes,
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
    .n_shapes = 6,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .motion_along = em_motion_along,
    .dynamics = &dynamics,
    .declared = declared,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
