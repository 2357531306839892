/* eigenmotion generate cart_pendulums.py */
/* input sha256:2166a7ac83f4a77333ace508537ee820c7acdbe8b322220d50204dc1a7bea13e */
/* body sha256:97a94c3113fc4d5528c701ce20196c8102b9ddaade39e416920ac2c416a674dd */
/* cart_pendulums_3: equations of motion, eigenfactor formulation.
 *
 * State, 28 numbers:
 *   x    y[0 .. 4)
 *   eta  y[4 .. 8)
 *   C    y[8 .. 24)
 *   s    y[24 .. 28)
 *
 * Blocks of M that do not couple:
 *   1: x, q1, q2, q3 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dx: M does not depend on it
 *
 * Operations of the straight-line part:
 *   eigenfactor: 21 additions, 45 multiplications, 6 function calls
 *   triangular root: 24 additions, 57 multiplications, 6 function calls
 *   projection: 12 additions, 36 multiplications, 6 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 4,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 28,         /* numbers of a state */
    N_C = 16,             /* of which C, */
    N_S = 4,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 1,
    N_EVENTS = 0,
    N_MEMORY = 20,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 8,
    N_PREPARED = 25,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 10,         /* inputs, parameters and the time */
    N_ARGUMENTS = 18,     /* x, v and these: what motion depends on */
    N1 = 4,               /* x, q1, q2, q3 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  const real *restrict u, real Mdot1[N1][N1], real f1[N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[9];
    const real q1_dot = v[1];
    const real q1 = x[1];
    const real sin_q1 = em_sin(q1);
    const real z_1 = q1_dot*sin_q1;
    const real z_2 = c_1*z_1;
    Mdot1[0][1] = Mdot1[1][0] = z_2;
    Mdot1[1][1] = em_real(0.0);
    const real c_3 = c[11];
    const real q2_dot = v[2];
    const real q2 = x[2];
    const real sin_q2 = em_sin(q2);
    const real z_4 = q2_dot*sin_q2;
    const real z_5 = c_3*z_4;
    Mdot1[0][2] = Mdot1[2][0] = z_5;
    const real c_4 = c[12];
    const real cos_q2 = em_cos(q2);
    const real cos_q1 = em_cos(q1);
    const real z_8 = q1_dot*cos_q1;
    const real z_9 = q2_dot*cos_q2;
    Mdot1[1][2] = Mdot1[2][1] = -c_4*((cos_q2*z_1 + cos_q1*z_4) - (sin_q2*z_8 + sin_q1*z_9));
    Mdot1[2][2] = em_real(0.0);
    const real c_6 = c[14];
    const real q3_dot = v[3];
    const real q3 = x[3];
    const real sin_q3 = em_sin(q3);
    const real z_11 = q3_dot*sin_q3;
    const real z_12 = c_6*z_11;
    Mdot1[0][3] = Mdot1[3][0] = z_12;
    const real c_7 = c[15];
    const real cos_q3 = em_cos(q3);
    const real z_14 = q3_dot*cos_q3;
    Mdot1[1][3] = Mdot1[3][1] = -c_7*((cos_q3*z_1 + cos_q1*z_11) - (sin_q3*z_8 + sin_q1*z_14));
    const real c_8 = c[16];
    Mdot1[2][3] = Mdot1[3][2] = -c_8*((cos_q3*z_4 + cos_q2*z_11) - (sin_q3*z_9 + sin_q2*z_14));
    Mdot1[3][3] = em_real(0.0);
    const real F = u[0];
    f1[0] = F;
    const real x_dot = v[0];
    const real z_15 = q1_dot*q2_dot*c_4*(cos_q2*sin_q1 - cos_q1*sin_q2);
    const real z_16 = q1_dot*q3_dot*c_7*(cos_q3*sin_q1 - cos_q1*sin_q3);
    const real c_10 = c[18];
    f1[1] = (x_dot*z_2 - z_15 - z_16) + sin_q1*c_10;
    const real z_17 = q2_dot*q3_dot*c_8*(cos_q3*sin_q2 - cos_q2*sin_q3);
    const real c_11 = c[19];
    f1[2] = (z_15 + x_dot*z_5 - z_17) + sin_q2*c_11;
    const real c_12 = c[20];
    f1[3] = (z_16 + z_17 + x_dot*z_12) + sin_q3*c_12;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x, q1, q2, q3: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4], y[5], y[6], y[7] };
    const real *const C1 = y + 8, *const s1 = y + 24;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x, q1, q2, q3: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4], y[5], y[6], y[7] };
    const real *const C1 = y + 8, *const s1 = y + 24;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];

    real Mdot1[N1][N1], f1[N1];
    eigenfactor_motion(y, dy, c, u, Mdot1, f1);

    /* x, q1, q2, q3: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 8, *const s1_dot = dy + 24;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

    /* etadot = a (45) */
    dy[4] = a1[0];
    dy[5] = a1[1];
    dy[6] = a1[2];
    dy[7] = a1[3];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[6])
{
    const real c_0 = c[8];
    M1[0][0] = c_0;
    const real q1 = x[1];
    const real cos_q1 = em_cos(q1);
    const real c_1 = c[9];
    M1[1][0] = -cos_q1*c_1;
    const real c_2 = c[10];
    M1[1][1] = c_2;
    const real q2 = x[2];
    const real cos_q2 = em_cos(q2);
    const real c_3 = c[11];
    M1[2][0] = -cos_q2*c_3;
    const real sin_q1 = em_sin(q1);
    const real sin_q2 = em_sin(q2);
    const real c_4 = c[12];
    M1[2][1] = (cos_q1*cos_q2 + sin_q1*sin_q2)*c_4;
    const real c_5 = c[13];
    M1[2][2] = c_5;
    const real q3 = x[3];
    const real cos_q3 = em_cos(q3);
    const real c_6 = c[14];
    M1[3][0] = -cos_q3*c_6;
    const real sin_q3 = em_sin(q3);
    const real c_7 = c[15];
    M1[3][1] = (cos_q1*cos_q3 + sin_q1*sin_q3)*c_7;
    const real c_8 = c[16];
    M1[3][2] = (cos_q2*cos_q3 + sin_q2*sin_q3)*c_8;
    const real c_9 = c[17];
    M1[3][3] = c_9;
    shared[0] = sin_q1;
    shared[1] = sin_q2;
    shared[2] = cos_q2;
    shared[3] = cos_q1;
    shared[4] = sin_q3;
    shared[5] = cos_q3;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real *restrict u,
                                 const real shared[6], real Mdot1[N1][N1], real f1[N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[9];
    const real q1_dot = v[1];
    const real sin_q1 = shared[0];
    const real z_6 = q1_dot*sin_q1;
    const real z_7 = c_1*z_6;
    Mdot1[0][1] = Mdot1[1][0] = z_7;
    Mdot1[1][1] = em_real(0.0);
    const real c_3 = c[11];
    const real q2_dot = v[2];
    const real sin_q2 = shared[1];
    const real z_8 = q2_dot*sin_q2;
    const real z_9 = c_3*z_8;
    Mdot1[0][2] = Mdot1[2][0] = z_9;
    const real c_4 = c[12];
    const real cos_q2 = shared[2];
    const real cos_q1 = shared[3];
    const real z_10 = q1_dot*cos_q1;
    const real z_11 = q2_dot*cos_q2;
    Mdot1[1][2] = Mdot1[2][1] = -c_4*((cos_q2*z_6 + cos_q1*z_8) - (sin_q2*z_10 + sin_q1*z_11));
    Mdot1[2][2] = em_real(0.0);
    const real c_6 = c[14];
    const real q3_dot = v[3];
    const real sin_q3 = shared[4];
    const real z_12 = q3_dot*sin_q3;
    const real z_13 = c_6*z_12;
    Mdot1[0][3] = Mdot1[3][0] = z_13;
    const real c_7 = c[15];
    const real cos_q3 = shared[5];
    const real z_14 = q3_dot*cos_q3;
    Mdot1[1][3] = Mdot1[3][1] = -c_7*((cos_q3*z_6 + cos_q1*z_12) - (sin_q3*z_10 + sin_q1*z_14));
    const real c_8 = c[16];
    Mdot1[2][3] = Mdot1[3][2] = -c_8*((cos_q3*z_8 + cos_q2*z_12) - (sin_q3*z_11 + sin_q2*z_14));
    Mdot1[3][3] = em_real(0.0);
    const real F = u[0];
    f1[0] = F;
    const real x_dot = v[0];
    const real z_15 = q1_dot*q2_dot*c_4*(cos_q2*sin_q1 - cos_q1*sin_q2);
    const real z_16 = q1_dot*q3_dot*c_7*(cos_q3*sin_q1 - cos_q1*sin_q3);
    const real c_10 = c[18];
    f1[1] = (x_dot*z_7 - z_15 - z_16) + sin_q1*c_10;
    const real z_17 = q2_dot*q3_dot*c_8*(cos_q3*sin_q2 - cos_q2*sin_q3);
    const real c_11 = c[19];
    f1[2] = (z_15 + x_dot*z_9 - z_17) + sin_q2*c_11;
    const real c_12 = c[20];
    f1[3] = (z_16 + z_17 + x_dot*z_13) + sin_q3*c_12;
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[6];
    triangular_masses(y, c, M1, shared);

    /* x, q1, q2, q3: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[4], y[5], y[6], y[7] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];

    real Mdot1[N1][N1], f1[N1];
    triangular_motion(dy, c, u, shared, Mdot1, f1);

    /* x, q1, q2, q3: a = L^-1 f - Phi eta */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* etadot = a (45) */
    dy[4] = a1[0];
    dy[5] = a1[1];
    dy[6] = a1[2];
    dy[7] = a1[3];
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
    const real c_0 = c[8];
    M1[0][0] = c_0;
    const real q1 = x[1];
    const real cos_q1 = em_cos(q1);
    const real c_1 = c[9];
    M1[0][1] = M1[1][0] = -cos_q1*c_1;
    const real c_2 = c[10];
    M1[1][1] = c_2;
    const real q2 = x[2];
    const real cos_q2 = em_cos(q2);
    const real c_3 = c[11];
    M1[0][2] = M1[2][0] = -cos_q2*c_3;
    const real sin_q1 = em_sin(q1);
    const real sin_q2 = em_sin(q2);
    const real c_4 = c[12];
    M1[1][2] = M1[2][1] = (cos_q1*cos_q2 + sin_q1*sin_q2)*c_4;
    const real c_5 = c[13];
    M1[2][2] = c_5;
    const real q3 = x[3];
    const real cos_q3 = em_cos(q3);
    const real c_6 = c[14];
    M1[0][3] = M1[3][0] = -cos_q3*c_6;
    const real sin_q3 = em_sin(q3);
    const real c_7 = c[15];
    M1[1][3] = M1[3][1] = (cos_q1*cos_q3 + sin_q1*sin_q3)*c_7;
    const real c_8 = c[16];
    M1[2][3] = M1[3][2] = (cos_q2*cos_q3 + sin_q2*sin_q3)*c_8;
    const real c_9 = c[17];
    M1[3][3] = c_9;
    shared[0] = sin_q1;
    shared[1] = sin_q2;
    shared[2] = cos_q2;
    shared[3] = cos_q1;
    shared[4] = sin_q3;
    shared[5] = cos_q3;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[6],
                             real Mdot1[N1][N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[9];
    const real q1_dot = v[1];
    const real sin_q1 = shared[0];
    const real z_6 = q1_dot*sin_q1;
    Mdot1[0][1] = Mdot1[1][0] = c_1*z_6;
    Mdot1[1][1] = em_real(0.0);
    const real c_3 = c[11];
    const real q2_dot = v[2];
    const real sin_q2 = shared[1];
    const real z_7 = q2_dot*sin_q2;
    Mdot1[0][2] = Mdot1[2][0] = c_3*z_7;
    const real c_4 = c[12];
    const real cos_q2 = shared[2];
    const real cos_q1 = shared[3];
    const real z_8 = q1_dot*cos_q1;
    const real z_9 = q2_dot*cos_q2;
    Mdot1[1][2] = Mdot1[2][1] = -c_4*((cos_q2*z_6 + cos_q1*z_7) - (sin_q2*z_8 + sin_q1*z_9));
    Mdot1[2][2] = em_real(0.0);
    const real c_6 = c[14];
    const real q3_dot = v[3];
    const real sin_q3 = shared[4];
    const real z_10 = q3_dot*sin_q3;
    Mdot1[0][3] = Mdot1[3][0] = c_6*z_10;
    const real c_7 = c[15];
    const real cos_q3 = shared[5];
    const real z_11 = q3_dot*cos_q3;
    Mdot1[1][3] = Mdot1[3][1] = -c_7*((cos_q3*z_6 + cos_q1*z_10) - (sin_q3*z_8 + sin_q1*z_11));
    const real c_8 = c[16];
    Mdot1[2][3] = Mdot1[3][2] = -c_8*((cos_q3*z_7 + cos_q2*z_10) - (sin_q3*z_9 + sin_q2*z_11));
    Mdot1[3][3] = em_real(0.0);
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

enum { N_PIVOTS = 4 };

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
    real v1[N1] = { e[0], e[1], e[2], e[3] };
    if (mode) em_backward(N1, memory + 0, memory + 16, v1);
    else em_velocity_of_eta(N1, y + 8, y + 24, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
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
    real eta1[N1] = { y[4], y[5], y[6], y[7] };
    *done &= em_refresh(N1, M1[0], y + 8, y + 24, mode ? NULL : eta1);
    y[4] = eta1[0];
    y[5] = eta1[1];
    y[6] = eta1[2];
    y[7] = eta1[3];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 16, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 24);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        real time = em_time_on_lanes(N1, y + 8, y + 24, Mdot1[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes cart_pendulums_3_lanes;
em_lanes cart_pendulums_3_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2,
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
    const double F = u[0];
    const double q1 = x[1];
    const double sin_q1 = em_sin(q1);
    const double c_1 = c[9];
    const double q1_dot = v[1];
    const double q2 = x[2];
    const double sin_q2 = em_sin(q2);
    const double c_3 = c[11];
    const double q2_dot = v[2];
    const double q3 = x[3];
    const double sin_q3 = em_sin(q3);
    const double c_6 = c[14];
    const double q3_dot = v[3];
    bias[0] = F - (sin_q1*c_1*(q1_dot*q1_dot) + sin_q2*c_3*(q2_dot*q2_dot) + sin_q3*c_6*(q3_dot*q3_dot));
    const double x_dot = v[0];
    const double z_3 = q1_dot*sin_q1;
    const double z_4 = x_dot*c_1*z_3;
    const double cos_q2 = em_cos(q2);
    const double cos_q1 = em_cos(q1);
    const double c_4 = c[12];
    const double z_7 = q1_dot*c_4;
    const double z_8 = q2_dot*(cos_q2*sin_q1 - cos_q1*sin_q2)*z_7;
    const double cos_q3 = em_cos(q3);
    const double c_7 = c[15];
    const double z_10 = q1_dot*c_7;
    const double z_11 = q3_dot*(cos_q3*sin_q1 - cos_q1*sin_q3)*z_10;
    const double c_10 = c[18];
    const double z_12 = q2_dot*sin_q2;
    const double z_13 = q1_dot*cos_q1;
    const double z_14 = q2_dot*cos_q2;
    const double z_15 = (cos_q2*z_3 + cos_q1*z_12) - (sin_q2*z_13 + sin_q1*z_14);
    const double z_16 = q3_dot*sin_q3;
    const double z_17 = q3_dot*cos_q3;
    const double z_18 = (cos_q3*z_3 + cos_q1*z_16) - (sin_q3*z_13 + sin_q1*z_17);
    bias[1] = ((z_4 - z_8 - z_11) + sin_q1*c_10) - (z_4 - q2_dot*c_4*z_15 - q3_dot*c_7*z_18);
    const double z_19 = x_dot*c_3*z_12;
    const double c_8 = c[16];
    const double z_20 = q2_dot*c_8;
    const double z_21 = q3_dot*(cos_q3*sin_q2 - cos_q2*sin_q3)*z_20;
    const double c_11 = c[19];
    const double z_22 = (cos_q3*z_12 + cos_q2*z_16) - (sin_q3*z_14 + sin_q2*z_17);
    bias[2] = ((z_8 + z_19 - z_21) + sin_q2*c_11) - (z_19 - z_15*z_7 - q3_dot*c_8*z_22);
    const double z_23 = x_dot*c_6*z_16;
    const double c_12 = c[20];
    bias[3] = ((z_11 + z_21 + z_23) + sin_q3*c_12) - (z_23 - z_18*z_10 - z_22*z_20);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double x_dot = v[0];
    const double c_0 = c[8];
    const double q1_dot = v[1];
    const double q1 = x[1];
    const double cos_q1 = em_cos(q1);
    const double c_1 = c[9];
    const double z_1 = cos_q1*c_1;
    const double q2_dot = v[2];
    const double q2 = x[2];
    const double cos_q2 = em_cos(q2);
    const double c_3 = c[11];
    const double z_3 = cos_q2*c_3;
    const double q3_dot = v[3];
    const double q3 = x[3];
    const double cos_q3 = em_cos(q3);
    const double c_6 = c[14];
    const double z_5 = cos_q3*c_6;
    const double c_2 = c[10];
    const double sin_q1 = em_sin(q1);
    const double sin_q2 = em_sin(q2);
    const double c_4 = c[12];
    const double z_8 = (cos_q1*cos_q2 + sin_q1*sin_q2)*c_4;
    const double sin_q3 = em_sin(q3);
    const double c_7 = c[15];
    const double z_10 = (cos_q1*cos_q3 + sin_q1*sin_q3)*c_7;
    const double c_5 = c[13];
    const double c_8 = c[16];
    const double z_11 = (cos_q2*cos_q3 + sin_q2*sin_q3)*c_8;
    const double c_9 = c[17];
    e[0] = 0.5*(x_dot*(x_dot*c_0 - q1_dot*z_1 - q2_dot*z_3 - q3_dot*z_5) - q1_dot*(x_dot*z_1 - q1_dot*c_2 -
        q2_dot*z_8 - q3_dot*z_10) - q2_dot*(x_dot*z_3 - q1_dot*z_8 - q2_dot*c_5 - q3_dot*z_11) - q3_dot*(x_dot*z_5
        - q1_dot*z_10 - q2_dot*z_11 - q3_dot*c_9));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c_11 = c[19];
    const double c_10 = c[18];
    const double c_12 = c[20];
    e[3] = cos_q2*c_11 + cos_q1*c_10 + cos_q3*c_12;
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
    const double x_dot = v[0];
    y[0] = x_dot;
    const double q1_dot = v[1];
    y[1] = q1_dot;
    const double q2_dot = v[2];
    y[2] = q2_dot;
    const double q3_dot = v[3];
    y[3] = q3_dot;
}

/* p: what the drawing is made of, shape by shape */
EM_ACROSS void draw(double t, const double *restrict x, const double *restrict c, double *restrict p)
{
    const double c_13 = c[21];
    p[0] = c_13;
    const double c_14 = c[22];
    p[1] = p[3] = p[5] = p[7] = c_14;
    const double c_15 = c[23];
    p[2] = c_15;
    const double l1 = c[4];
    const double x_ = x[0];
    p[4] = p[10] = (-0.25)*(l1 - 4.0*x_);
    p[6] = p[8] = 0.25*(l1 + 4.0*x_);
    p[9] = p[11] = p[13] = 0.0;
    p[12] = x_;
    const double q1 = x[1];
    const double sin_q1 = em_sin(q1);
    const double z_1 = x_ - l1*sin_q1;
    p[14] = p[16] = p[24] = z_1;
    const double cos_q1 = em_cos(q1);
    const double z_3 = l1*cos_q1;
    p[15] = p[17] = p[25] = z_3;
    const double l2 = c[5];
    const double q2 = x[2];
    const double sin_q2 = em_sin(q2);
    const double z_5 = z_1 - l2*sin_q2;
    p[18] = p[20] = p[27] = z_5;
    const double cos_q2 = em_cos(q2);
    const double z_7 = z_3 + l2*cos_q2;
    p[19] = p[21] = p[28] = z_7;
    const double l3 = c[6];
    const double q3 = x[3];
    const double sin_q3 = em_sin(q3);
    p[22] = p[30] = p[33] = z_5 - l3*sin_q3;
    const double cos_q3 = em_cos(q3);
    p[23] = p[31] = p[34] = z_7 + l3*cos_q3;
    const double c_16 = c[24];
    p[26] = p[29] = p[32] = c_16;
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
    const double l1 = c[4];
    const double m1 = c[1];
    const double m2 = c[2];
    const double m3 = c[3];
    const double z_0 = m2 + m3;
    const double q1 = x[1];
    const double sin_q1 = em_sin(q1);
    dM[20] = dM[17] = l1*(m1 + z_0)*sin_q1;
    const double q2 = x[2];
    const double cos_q2 = em_cos(q2);
    const double cos_q1 = em_cos(q1);
    const double sin_q2 = em_sin(q2);
    const double l2 = c[5];
    const double z_5 = l2*z_0;
    const double z_6 = l1*(cos_q2*sin_q1 - cos_q1*sin_q2)*z_5;
    dM[25] = dM[22] = -z_6;
    const double q3 = x[3];
    const double cos_q3 = em_cos(q3);
    const double sin_q3 = em_sin(q3);
    const double l3 = c[6];
    const double z_9 = m3*l3;
    const double z_10 = l1*(cos_q3*sin_q1 - cos_q1*sin_q3)*z_9;
    dM[29] = dM[23] = -z_10;
    dM[40] = dM[34] = sin_q2*z_5;
    dM[41] = dM[38] = z_6;
    const double z_11 = l2*(cos_q3*sin_q2 - cos_q2*sin_q3)*z_9;
    dM[46] = dM[43] = -z_11;
    dM[60] = dM[51] = sin_q3*z_9;
    dM[61] = dM[55] = z_10;
    dM[62] = dM[59] = z_11;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double q1 = x[1];
    const double cos_q1 = em_cos(q1);
    const double q1_dot = v[1];
    const double l1 = c[4];
    const double m1 = c[1];
    const double m2 = c[2];
    const double m3 = c[3];
    const double z_1 = m2 + m3;
    const double z_2 = m1 + z_1;
    const double z_3 = l1*z_2;
    const double q1_ddot = a[1];
    const double sin_q1 = em_sin(q1);
    const double z_5 = sin_q1*z_3;
    D[1] = cos_q1*(q1_dot*q1_dot)*z_3 + q1_ddot*z_5;
    const double q2 = x[2];
    const double cos_q2 = em_cos(q2);
    const double q2_dot = v[2];
    const double l2 = c[5];
    const double z_7 = l2*z_1;
    const double q2_ddot = a[2];
    const double sin_q2 = em_sin(q2);
    const double z_9 = sin_q2*z_7;
    D[2] = cos_q2*(q2_dot*q2_dot)*z_7 + q2_ddot*z_9;
    const double q3_dot = v[3];
    const double q3 = x[3];
    const double cos_q3 = em_cos(q3);
    const double l3 = c[6];
    const double z_11 = m3*l3;
    const double z_12 = cos_q3*z_11;
    const double q3_ddot = a[3];
    const double sin_q3 = em_sin(q3);
    const double z_14 = sin_q3*z_11;
    D[3] = q3_dot*q3_dot*z_12 + q3_ddot*z_14;
    const double z_15 = q1_dot*l1;
    const double z_16 = z_2*z_15;
    D[5] = 2.0*(sin_q1*z_16);
    const double z_17 = q2_dot*sin_q2;
    D[6] = 2.0*(z_7*z_17);
    const double z_18 = q3_dot*z_11;
    D[7] = 2.0*(sin_q3*z_18);
    const double g = c[7];
    const double z_19 = l1*g;
    const double x_dot = v[0];
    const double z_20 = x_dot*cos_q1*z_16;
    const double z_21 = z_7*z_15;
    const double z_22 = q2_dot*(cos_q1*cos_q2 + sin_q1*sin_q2)*z_21;
    const double z_23 = (cos_q1*cos_q3 + sin_q1*sin_q3)*z_15*z_18;
    const double z_24 = q1_dot*cos_q1;
    const double z_25 = q1_dot*sin_q1;
    const double z_26 = q2_dot*cos_q2;
    const double z_27 = (cos_q2*z_24 - sin_q1*z_17) + (sin_q2*z_25 - cos_q1*z_26);
    const double z_28 = l1*z_7;
    const double z_29 = q2_dot*z_27*z_28;
    const double z_30 = q3_dot*sin_q3;
    const double z_31 = q3_dot*cos_q3;
    const double z_32 = (cos_q3*z_24 - sin_q1*z_30) + (sin_q3*z_25 - cos_q1*z_31);
    const double z_33 = l1*z_32*z_18;
    const double x_ddot = a[0];
    const double z_34 = cos_q2*sin_q1 - cos_q1*sin_q2;
    const double z_35 = z_34*z_28;
    const double z_36 = q2_ddot*z_35;
    const double z_37 = cos_q3*sin_q1 - cos_q1*sin_q3;
    const double z_38 = l1*z_37;
    const double z_39 = z_11*z_38;
    const double z_40 = q3_ddot*z_39;
    D[9] = -(((cos_q1*(m1*z_19 + m2*z_19 + m3*z_19) + (z_20 - z_22 - z_23)) - (z_20 - z_29 - z_33)) - (x_ddot*z_5
        - z_36 - z_40));
    D[10] = z_36 - (z_22 - z_29);
    D[11] = z_40 - (z_23 - z_33);
    const double z_41 = z_34*z_21;
    const double z_42 = ((cos_q2*z_25 + cos_q1*z_17) - (sin_q2*z_24 + sin_q1*z_26))*z_28;
    const double z_43 = q2_dot*z_35;
    D[14] = z_41 - (z_42 - z_43);
    const double z_44 = z_11*z_15;
    const double z_45 = z_37*z_44;
    const double z_46 = l1*((cos_q3*z_25 + cos_q1*z_30) - (sin_q3*z_24 + sin_q1*z_31))*z_11;
    const double z_47 = z_18*z_38;
    D[15] = z_45 - (z_46 - z_47);
    const double z_48 = z_27*z_21;
    const double z_49 = q1_ddot*z_35;
    D[17] = -((z_22 + z_48) + z_49);
    const double z_50 = l2*g;
    const double z_51 = x_dot*z_7*z_26;
    const double z_52 = l2*z_18;
    const double z_53 = q2_dot*(cos_q2*cos_q3 + sin_q2*sin_q3)*z_52;
    const double z_54 = (cos_q3*z_26 - sin_q2*z_30) + (sin_q3*z_17 - cos_q2*z_31);
    const double z_55 = z_54*z_52;
    const double z_56 = cos_q3*sin_q2 - cos_q2*sin_q3;
    const double z_57 = l2*z_11;
    const double z_58 = z_56*z_57;
    const double z_59 = q3_ddot*z_58;
    D[18] = -(((cos_q2*(m2*z_50 + m3*z_50) - (z_22 + z_53 - z_51)) - (z_48 + z_51 - z_55)) - (z_49 + x_ddot*z_9 -
        z_59));
    D[19] = z_59 - (z_53 - z_55);
    D[21] = -(z_43 + (z_42 + z_41));
    const double z_60 = q2_dot*z_58;
    const double z_61 = ((cos_q3*z_17 + cos_q2*z_30) - (sin_q3*z_26 + sin_q2*z_31))*z_57;
    const double z_62 = z_56*z_52;
    D[23] = z_60 - (z_61 - z_62);
    const double z_63 = z_32*z_44;
    const double z_64 = q1_ddot*z_39;
    D[25] = -((z_23 + z_63) + z_64);
    const double z_65 = q2_dot*z_54*z_57;
    const double z_66 = q2_ddot*z_58;
    D[26] = -((z_53 + z_65) + z_66);
    const double z_67 = x_dot*cos_q3*z_18;
    D[27] = -(((g*z_12 - (z_23 + z_53 - z_67)) - (z_63 + z_65 + z_67)) - (z_64 + z_66 + x_ddot*z_14));
    D[29] = -(z_47 + (z_46 + z_45));
    D[30] = -(z_62 + (z_61 + z_60));
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    D[0] = -1.0;
    const double x_ddot = a[0];
    D[1] = x_ddot;
    const double q1 = x[1];
    const double cos_q1 = em_cos(q1);
    const double l1 = c[4];
    const double q1_ddot = a[1];
    const double z_1 = l1*q1_ddot;
    const double q1_dot = v[1];
    const double z_2 = q1_dot*q1_dot;
    const double sin_q1 = em_sin(q1);
    const double z_4 = l1*sin_q1;
    const double z_5 = x_ddot - (cos_q1*z_1 - z_2*z_4);
    D[2] = z_5;
    const double q2 = x[2];
    const double cos_q2 = em_cos(q2);
    const double l2 = c[5];
    const double q2_ddot = a[2];
    const double z_7 = l2*q2_ddot;
    const double q2_dot = v[2];
    const double z_8 = q2_dot*q2_dot;
    const double sin_q2 = em_sin(q2);
    const double z_10 = l2*sin_q2;
    const double z_11 = (cos_q2*z_7 - z_8*z_10) - z_5;
    D[3] = -z_11;
    const double q3 = x[3];
    const double cos_q3 = em_cos(q3);
    const double l3 = c[6];
    const double q3_ddot = a[3];
    const double z_13 = l3*q3_ddot;
    const double q3_dot = v[3];
    const double z_14 = q3_dot*q3_dot;
    const double sin_q3 = em_sin(q3);
    const double z_16 = l3*sin_q3;
    D[4] = z_14*z_16 - cos_q3*z_13 - z_11;
    const double m1 = c[1];
    const double m2 = c[2];
    const double m3 = c[3];
    const double z_17 = m2 + m3;
    const double z_18 = m1 + z_17;
    const double z_19 = z_18*cos_q1;
    D[5] = -(q1_ddot*z_19 - z_18*sin_q1*z_2);
    const double z_20 = z_17*cos_q2;
    D[6] = -(q2_ddot*z_20 - z_17*sin_q2*z_8);
    const double z_21 = m3*q3_ddot;
    const double z_22 = m3*sin_q3;
    D[7] = -(cos_q3*z_21 - z_14*z_22);
    const double g = c[7];
    const double z_23 = g*z_4 - (q1_ddot*(l1*l1) - l1*cos_q1*x_ddot);
    D[12] = -z_23;
    const double z_24 = cos_q1*cos_q2 + sin_q1*sin_q2;
    const double z_25 = cos_q2*sin_q1;
    const double z_26 = cos_q1*sin_q2;
    const double z_27 = (q1_dot*z_25 + q2_dot*z_26) - (q1_dot*z_26 + q2_dot*z_25);
    const double z_28 = q2_dot*l2;
    const double z_29 = z_25 - z_26;
    const double z_30 = q1_dot*l1;
    const double z_31 = z_29*z_30*z_28;
    const double z_32 = (l1*z_24*z_7 + z_31 - l1*z_27*z_28) - z_23;
    D[13] = -(-z_32);
    const double z_33 = cos_q1*cos_q3 + sin_q1*sin_q3;
    const double z_34 = l1*z_33;
    const double z_35 = q3_dot*l3;
    const double z_36 = cos_q3*sin_q1;
    const double z_37 = cos_q1*sin_q3;
    const double z_38 = (q1_dot*z_36 + q3_dot*z_37) - (q1_dot*z_37 + q3_dot*z_36);
    const double z_39 = l1*z_38;
    const double z_40 = z_36 - z_37;
    const double z_41 = z_40*z_30;
    const double z_42 = z_35*z_41;
    D[14] = z_13*z_34 + z_42 + z_32 - z_35*z_39;
    const double z_43 = m3*l3;
    const double z_44 = q3_ddot*z_43;
    const double z_45 = z_17*z_24;
    const double z_46 = q3_dot*z_43;
    const double z_47 = z_17*z_27;
    const double z_48 = q1_dot*z_40*z_46;
    const double z_49 = z_17*z_29;
    const double z_50 = q1_dot*z_28*z_49;
    const double z_51 = m3*g + m2*g;
    D[15] = 2.0*z_18*z_1 + z_33*z_44 + z_7*z_45 + z_48 + z_50 - x_ddot*z_19 - z_38*z_46 - z_28*z_47 - sin_q1*(m1*g
        + z_51);
    const double z_52 = q2_dot*z_30*z_49;
    D[16] = l1*q2_ddot*z_45 + z_52 - q2_dot*l1*z_47;
    const double z_53 = q3_dot*m3;
    const double z_54 = z_53*z_41;
    D[17] = z_21*z_34 + z_54 - z_53*z_39;
    D[18] = -sin_q1*(m3*l1 + m2*l1 + m1*l1);
    const double z_55 = g*z_10 + (z_31 + l2*cos_q2*x_ddot + l2*z_27*z_30 - q2_ddot*(l2*l2) - l2*z_24*z_1);
    D[23] = -z_55;
    const double z_56 = cos_q2*cos_q3 + sin_q2*sin_q3;
    const double z_57 = l2*z_56;
    const double z_58 = cos_q3*sin_q2;
    const double z_59 = cos_q2*sin_q3;
    const double z_60 = (q2_dot*z_58 + q3_dot*z_59) - (q2_dot*z_59 + q3_dot*z_58);
    const double z_61 = l2*z_60;
    const double z_62 = z_58 - z_59;
    const double z_63 = z_62*z_28;
    const double z_64 = z_35*z_63;
    D[24] = z_13*z_57 + z_64 - z_35*z_61 - z_55;
    D[25] = -(z_50 + q1_dot*l2*z_47 - l2*q1_ddot*z_45);
    const double z_65 = q2_dot*z_62*z_46;
    D[26] = 2.0*z_17*z_7 + z_56*z_44 + z_1*z_45 + z_65 - z_52 - x_ddot*z_20 - z_60*z_46 - z_30*z_47 - sin_q2*z_51;
    const double z_66 = z_53*z_63;
    D[27] = z_21*z_57 + z_66 - z_53*z_61;
    D[28] = -sin_q2*(m3*l2 + m2*l2);
    const double z_67 = z_56*z_7;
    const double z_68 = z_33*z_1;
    const double z_69 = cos_q3*x_ddot;
    const double z_70 = z_60*z_28;
    const double z_71 = z_38*z_30;
    D[34] = -(z_42 + z_64 + l3*z_69 + l3*z_70 + l3*z_71 + g*z_16 - q3_ddot*(l3*l3) - l3*z_67 - l3*z_68);
    D[35] = -(z_48 + q1_dot*z_38*z_43 - z_33*q1_ddot*z_43);
    D[36] = -(z_65 + q2_dot*z_60*z_43 - z_56*q2_ddot*z_43);
    D[37] = 2.0*z_44 + m3*z_67 + m3*z_68 - z_54 - z_66 - m3*z_69 - m3*z_70 - m3*z_71 - g*z_22;
    D[38] = -sin_q3*z_43;
}

/* D (n, n_arguments), of P(x, t) v */
EM_RARE /* no explicit step calls it */
EM_ACROSS void quasi_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * N * N_ARGUMENTS);
    D[4] = 1.0;
    D[23] = 1.0;
    D[42] = 1.0;
    D[61] = 1.0;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes cart_pendulums_3_lanes;
EM_WEAK em_lanes cart_pendulums_3_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 8, 24, 0, 16 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double m0 = parameters[0];
    const double m1 = parameters[1];
    const double m2 = parameters[2];
    const double m3 = parameters[3];
    const double z_0 = m2 + m3;
    const double z_1 = m1 + z_0;
    prepared[8] = m0 + z_1; /* c_0 */
    const double l1 = parameters[4];
    prepared[9] = l1*z_1; /* c_1 */
    prepared[10] = z_1*(l1*l1); /* c_2 */
    const double l2 = parameters[5];
    const double z_2 = l2*z_0;
    prepared[11] = z_2; /* c_3 */
    prepared[12] = l1*z_2; /* c_4 */
    prepared[13] = z_0*(l2*l2); /* c_5 */
    const double l3 = parameters[6];
    const double z_3 = m3*l3;
    prepared[14] = z_3; /* c_6 */
    prepared[15] = l1*z_3; /* c_7 */
    prepared[16] = l2*z_3; /* c_8 */
    prepared[17] = m3*(l3*l3); /* c_9 */
    const double g = parameters[7];
    const double z_4 = l1*g;
    prepared[18] = m1*z_4 + m2*z_4 + m3*z_4; /* c_10 */
    const double z_5 = l2*g;
    prepared[19] = m2*z_5 + m3*z_5; /* c_11 */
    prepared[20] = g*z_3; /* c_12 */
    prepared[21] = 1.5*l1; /* c_13 */
    prepared[22] = (-0.25)*l1; /* c_14 */
    prepared[23] = (-1.5)*l1; /* c_15 */
    prepared[24] = (1.0/20.0)*l1; /* c_16 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {63, ""},
    {63, ""},
    {63, ""},
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
    const double c_0 = c[8];
    M[0] = c_0;
    const double q1 = x[1];
    const double cos_q1 = em_cos(q1);
    const double c_1 = c[9];
    M[4] = M[1] = -cos_q1*c_1;
    const double c_2 = c[10];
    M[5] = c_2;
    const double q2 = x[2];
    const double cos_q2 = em_cos(q2);
    const double c_3 = c[11];
    M[8] = M[2] = -cos_q2*c_3;
    const double sin_q1 = em_sin(q1);
    const double sin_q2 = em_sin(q2);
    const double c_4 = c[12];
    M[9] = M[6] = (cos_q1*cos_q2 + sin_q1*sin_q2)*c_4;
    const double c_5 = c[13];
    M[10] = c_5;
    const double q3 = x[3];
    const double cos_q3 = em_cos(q3);
    const double c_6 = c[14];
    M[12] = M[3] = -cos_q3*c_6;
    const double sin_q3 = em_sin(q3);
    const double c_7 = c[15];
    M[13] = M[7] = (cos_q1*cos_q3 + sin_q1*sin_q3)*c_7;
    const double c_8 = c[16];
    M[14] = M[11] = (cos_q2*cos_q3 + sin_q2*sin_q3)*c_8;
    const double c_9 = c[17];
    M[15] = c_9;
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

    double gap = em_gap(N1, y + 24);
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
    em_spread(N, N1, coordinate1, y + 8, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 8);
    for (int i = 0; i < N1; ++i) y[24 + i] = s[coordinate1[i]];
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

#include "cart_pendulums_3.h"

static const char *const coordinate_names[] = { "x", "q1", "q2", "q3", NULL };
static const char *const parameter_names[] = { "m0", "m1", "m2", "m3", "l1", "l2", "l3", "g", NULL };
static const char *const input_names[] = { "F", NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 2.0, 0.5, 0.5, 0.5, 0.4, 0.4, 0.4, 9.81, 0.0 };
static const double input_defaults[] = { 0.0, 0.0 };
static const double initial_x[N] = { 0.0, 0.1, 0.15000000000000002, 0.2 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 1, 1 };
static const char *const quasi_velocity_names[] = { "v", "u1", "u2", "u3", NULL };
static const em_shape shapes[] = {
    {"ground", 0, 4},
    {"body", 4, 8},
    {"line", 12, 4},
    {"line", 16, 4},
    {"line", 20, 4},
    {"disk", 24, 3},
    {"disk", 27, 3},
    {"disk", 30, 3},
    {"trace", 33, 2}
};
static const em_slice layout[] = {
    {"x", 0, 4},
    {"eta", 4, 4},
    {"C", 8, 16},
    {"s", 24, 4}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dx: M does not depend on it",
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
static int simulate(em_run *run) { return em_simulate(&cart_pendulums_3_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&cart_pendulums_3_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&cart_pendulums_3_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&cart_pendulums_3_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&cart_pendulums_3_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&cart_pendulums_3_model, run, mode); }

const em_model cart_pendulums_3_model = {
    .abi = EM_ABI,
    .name = "cart_pendulums_3",
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
    .conserves_energy = 0,
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
    .quasi = quasi,
    .event = model_events,
    .lanes = &cart_pendulums_3_lanes,
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
    .n_shapes = 9,
    .dimension = 2,
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
