/* eigenmotion generate chain.py */
/* input sha256:6bbbcf8677f055b932628a08180eff4ad8cf7573a6c8f3a2f34ed490ef046cfd */
/* body sha256:bb51130205b5f73c3917b388bb9ba4d48f02ff2fb6b077b0515d2dc0ebb626c7 */
/* chain_5: equations of motion, eigenfactor formulation.
 *
 * State, 40 numbers:
 *   x    y[0 .. 5)
 *   eta  y[5 .. 10)
 *   C    y[10 .. 35)
 *   s    y[35 .. 40)
 *
 * Blocks of M that do not couple:
 *   1: theta_1, theta_2, theta_3, theta_4, theta_5 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *
 * Operations of the straight-line part:
 *   eigenfactor: 60 additions, 125 multiplications, 10 function calls
 *   triangular root: 70 additions, 155 multiplications, 10 function calls
 *   projection: 40 additions, 100 multiplications, 10 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 5,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 40,         /* numbers of a state */
    N_C = 25,             /* of which C, */
    N_S = 5,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 30,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 11,
    N_PREPARED = 42,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 12,         /* inputs, parameters and the time */
    N_ARGUMENTS = 22,     /* x, v and these: what motion depends on */
    N1 = 5,               /* theta_1, theta_2, theta_3, theta_4, theta_5 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[12];
    const real theta_2 = x[1];
    const real cos_theta_2 = em_cos(theta_2);
    const real theta_1_dot = v[0];
    const real theta_1 = x[0];
    const real sin_theta_1 = em_sin(theta_1);
    const real z_2 = theta_1_dot*sin_theta_1;
    const real cos_theta_1 = em_cos(theta_1);
    const real theta_2_dot = v[1];
    const real sin_theta_2 = em_sin(theta_2);
    const real z_5 = theta_2_dot*sin_theta_2;
    const real z_6 = theta_1_dot*cos_theta_1;
    const real z_7 = theta_2_dot*cos_theta_2;
    Mdot1[0][1] = Mdot1[1][0] = -(c_1*(cos_theta_2*z_2 + cos_theta_1*z_5) - c_1*(sin_theta_2*z_6 +
        sin_theta_1*z_7));
    Mdot1[1][1] = em_real(0.0);
    const real c_3 = c[14];
    const real theta_3 = x[2];
    const real cos_theta_3 = em_cos(theta_3);
    const real theta_3_dot = v[2];
    const real sin_theta_3 = em_sin(theta_3);
    const real z_10 = theta_3_dot*sin_theta_3;
    const real z_11 = theta_3_dot*cos_theta_3;
    Mdot1[0][2] = Mdot1[2][0] = -(c_3*(cos_theta_3*z_2 + cos_theta_1*z_10) - c_3*(sin_theta_3*z_6 +
        sin_theta_1*z_11));
    const real c_4 = c[15];
    Mdot1[1][2] = Mdot1[2][1] = -(c_4*(cos_theta_3*z_5 + cos_theta_2*z_10) - c_4*(sin_theta_3*z_7 +
        sin_theta_2*z_11));
    Mdot1[2][2] = em_real(0.0);
    const real c_6 = c[17];
    const real theta_4 = x[3];
    const real cos_theta_4 = em_cos(theta_4);
    const real theta_4_dot = v[3];
    const real sin_theta_4 = em_sin(theta_4);
    const real z_14 = theta_4_dot*sin_theta_4;
    const real z_15 = theta_4_dot*cos_theta_4;
    Mdot1[0][3] = Mdot1[3][0] = -(c_6*(cos_theta_4*z_2 + cos_theta_1*z_14) - c_6*(sin_theta_4*z_6 +
        sin_theta_1*z_15));
    const real c_7 = c[18];
    Mdot1[1][3] = Mdot1[3][1] = -(c_7*(cos_theta_4*z_5 + cos_theta_2*z_14) - c_7*(sin_theta_4*z_7 +
        sin_theta_2*z_15));
    const real c_8 = c[19];
    Mdot1[2][3] = Mdot1[3][2] = -(c_8*(cos_theta_4*z_10 + cos_theta_3*z_14) - c_8*(sin_theta_4*z_11 +
        sin_theta_3*z_15));
    Mdot1[3][3] = em_real(0.0);
    const real c_10 = c[21];
    const real theta_5 = x[4];
    const real cos_theta_5 = em_cos(theta_5);
    const real theta_5_dot = v[4];
    const real sin_theta_5 = em_sin(theta_5);
    const real z_18 = theta_5_dot*sin_theta_5;
    const real z_19 = theta_5_dot*cos_theta_5;
    Mdot1[0][4] = Mdot1[4][0] = -(c_10*(cos_theta_5*z_2 + cos_theta_1*z_18) - c_10*(sin_theta_5*z_6 +
        sin_theta_1*z_19));
    const real c_11 = c[22];
    Mdot1[1][4] = Mdot1[4][1] = -(c_11*(cos_theta_5*z_5 + cos_theta_2*z_18) - c_11*(sin_theta_5*z_7 +
        sin_theta_2*z_19));
    const real c_12 = c[23];
    Mdot1[2][4] = Mdot1[4][2] = -(c_12*(cos_theta_5*z_10 + cos_theta_3*z_18) - c_12*(sin_theta_5*z_11 +
        sin_theta_3*z_19));
    const real c_13 = c[24];
    Mdot1[3][4] = Mdot1[4][3] = -(c_13*(cos_theta_5*z_14 + cos_theta_4*z_18) - c_13*(sin_theta_5*z_15 +
        sin_theta_4*z_19));
    Mdot1[4][4] = em_real(0.0);
    const real z_20 = theta_1_dot*theta_2_dot*(c_1*(cos_theta_2*sin_theta_1 - cos_theta_1*sin_theta_2));
    const real z_21 = theta_1_dot*theta_3_dot*(c_3*(sin_theta_1*cos_theta_3 - cos_theta_1*sin_theta_3));
    const real z_22 = theta_1_dot*theta_4_dot*(c_6*(sin_theta_1*cos_theta_4 - cos_theta_1*sin_theta_4));
    const real z_23 = theta_1_dot*theta_5_dot*(c_10*(sin_theta_1*cos_theta_5 - cos_theta_1*sin_theta_5));
    const real c_15 = c[26];
    f1[0] = -((z_20 + z_21 + z_22 + z_23) + sin_theta_1*c_15);
    const real z_24 = theta_2_dot*theta_3_dot*(c_4*(sin_theta_2*cos_theta_3 - cos_theta_2*sin_theta_3));
    const real z_25 = theta_2_dot*theta_4_dot*(c_7*(sin_theta_2*cos_theta_4 - cos_theta_2*sin_theta_4));
    const real z_26 = theta_2_dot*theta_5_dot*(c_11*(sin_theta_2*cos_theta_5 - cos_theta_2*sin_theta_5));
    const real c_16 = c[27];
    f1[1] = (z_20 - z_24 - z_25 - z_26) - sin_theta_2*c_16;
    const real z_27 = theta_3_dot*theta_4_dot*(c_8*(sin_theta_3*cos_theta_4 - cos_theta_3*sin_theta_4));
    const real z_28 = theta_3_dot*theta_5_dot*(c_12*(sin_theta_3*cos_theta_5 - cos_theta_3*sin_theta_5));
    const real c_17 = c[28];
    f1[2] = (z_21 + z_24 - z_27 - z_28) - sin_theta_3*c_17;
    const real z_29 = theta_4_dot*theta_5_dot*(c_13*(sin_theta_4*cos_theta_5 - cos_theta_4*sin_theta_5));
    const real c_18 = c[29];
    f1[3] = (z_22 + z_25 + z_27 - z_29) - sin_theta_4*c_18;
    const real c_19 = c[30];
    f1[4] = (z_23 + z_26 + z_28 + z_29) - sin_theta_5*c_19;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* theta_1, theta_2, theta_3, theta_4, theta_5: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    const real *const C1 = y + 10, *const s1 = y + 35;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* theta_1, theta_2, theta_3, theta_4, theta_5: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    const real *const C1 = y + 10, *const s1 = y + 35;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];

    real Mdot1[N1][N1], f1[N1];
    eigenfactor_motion(y, dy, c, Mdot1, f1);

    /* theta_1, theta_2, theta_3, theta_4, theta_5: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 10, *const s1_dot = dy + 35;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

    /* etadot = a (45) */
    dy[5] = a1[0];
    dy[6] = a1[1];
    dy[7] = a1[2];
    dy[8] = a1[3];
    dy[9] = a1[4];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[10])
{
    const real c_0 = c[11];
    M1[0][0] = c_0;
    const real c_1 = c[12];
    const real theta_1 = x[0];
    const real cos_theta_1 = em_cos(theta_1);
    const real theta_2 = x[1];
    const real cos_theta_2 = em_cos(theta_2);
    const real sin_theta_1 = em_sin(theta_1);
    const real sin_theta_2 = em_sin(theta_2);
    M1[1][0] = c_1*(cos_theta_1*cos_theta_2 + sin_theta_1*sin_theta_2);
    const real c_2 = c[13];
    M1[1][1] = c_2;
    const real c_3 = c[14];
    const real theta_3 = x[2];
    const real cos_theta_3 = em_cos(theta_3);
    const real sin_theta_3 = em_sin(theta_3);
    M1[2][0] = c_3*(cos_theta_1*cos_theta_3 + sin_theta_1*sin_theta_3);
    const real c_4 = c[15];
    M1[2][1] = c_4*(cos_theta_2*cos_theta_3 + sin_theta_2*sin_theta_3);
    const real c_5 = c[16];
    M1[2][2] = c_5;
    const real c_6 = c[17];
    const real theta_4 = x[3];
    const real cos_theta_4 = em_cos(theta_4);
    const real sin_theta_4 = em_sin(theta_4);
    M1[3][0] = c_6*(cos_theta_1*cos_theta_4 + sin_theta_1*sin_theta_4);
    const real c_7 = c[18];
    M1[3][1] = c_7*(cos_theta_2*cos_theta_4 + sin_theta_2*sin_theta_4);
    const real c_8 = c[19];
    M1[3][2] = c_8*(cos_theta_3*cos_theta_4 + sin_theta_3*sin_theta_4);
    const real c_9 = c[20];
    M1[3][3] = c_9;
    const real c_10 = c[21];
    const real theta_5 = x[4];
    const real cos_theta_5 = em_cos(theta_5);
    const real sin_theta_5 = em_sin(theta_5);
    M1[4][0] = c_10*(cos_theta_1*cos_theta_5 + sin_theta_1*sin_theta_5);
    const real c_11 = c[22];
    M1[4][1] = c_11*(cos_theta_2*cos_theta_5 + sin_theta_2*sin_theta_5);
    const real c_12 = c[23];
    M1[4][2] = c_12*(cos_theta_3*cos_theta_5 + sin_theta_3*sin_theta_5);
    const real c_13 = c[24];
    M1[4][3] = c_13*(cos_theta_4*cos_theta_5 + sin_theta_4*sin_theta_5);
    const real c_14 = c[25];
    M1[4][4] = c_14;
    shared[0] = cos_theta_2;
    shared[1] = sin_theta_1;
    shared[2] = cos_theta_1;
    shared[3] = sin_theta_2;
    shared[4] = cos_theta_3;
    shared[5] = sin_theta_3;
    shared[6] = cos_theta_4;
    shared[7] = sin_theta_4;
    shared[8] = cos_theta_5;
    shared[9] = sin_theta_5;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[10],
                                 real Mdot1[N1][N1], real f1[N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[12];
    const real cos_theta_2 = shared[0];
    const real theta_1_dot = v[0];
    const real sin_theta_1 = shared[1];
    const real z_10 = theta_1_dot*sin_theta_1;
    const real cos_theta_1 = shared[2];
    const real theta_2_dot = v[1];
    const real sin_theta_2 = shared[3];
    const real z_11 = theta_2_dot*sin_theta_2;
    const real z_12 = theta_1_dot*cos_theta_1;
    const real z_13 = theta_2_dot*cos_theta_2;
    Mdot1[0][1] = Mdot1[1][0] = -(c_1*(cos_theta_2*z_10 + cos_theta_1*z_11) - c_1*(sin_theta_2*z_12 +
        sin_theta_1*z_13));
    Mdot1[1][1] = em_real(0.0);
    const real c_3 = c[14];
    const real cos_theta_3 = shared[4];
    const real theta_3_dot = v[2];
    const real sin_theta_3 = shared[5];
    const real z_14 = theta_3_dot*sin_theta_3;
    const real z_15 = theta_3_dot*cos_theta_3;
    Mdot1[0][2] = Mdot1[2][0] = -(c_3*(cos_theta_3*z_10 + cos_theta_1*z_14) - c_3*(sin_theta_3*z_12 +
        sin_theta_1*z_15));
    const real c_4 = c[15];
    Mdot1[1][2] = Mdot1[2][1] = -(c_4*(cos_theta_3*z_11 + cos_theta_2*z_14) - c_4*(sin_theta_3*z_13 +
        sin_theta_2*z_15));
    Mdot1[2][2] = em_real(0.0);
    const real c_6 = c[17];
    const real cos_theta_4 = shared[6];
    const real theta_4_dot = v[3];
    const real sin_theta_4 = shared[7];
    const real z_16 = theta_4_dot*sin_theta_4;
    const real z_17 = theta_4_dot*cos_theta_4;
    Mdot1[0][3] = Mdot1[3][0] = -(c_6*(cos_theta_4*z_10 + cos_theta_1*z_16) - c_6*(sin_theta_4*z_12 +
        sin_theta_1*z_17));
    const real c_7 = c[18];
    Mdot1[1][3] = Mdot1[3][1] = -(c_7*(cos_theta_4*z_11 + cos_theta_2*z_16) - c_7*(sin_theta_4*z_13 +
        sin_theta_2*z_17));
    const real c_8 = c[19];
    Mdot1[2][3] = Mdot1[3][2] = -(c_8*(cos_theta_4*z_14 + cos_theta_3*z_16) - c_8*(sin_theta_4*z_15 +
        sin_theta_3*z_17));
    Mdot1[3][3] = em_real(0.0);
    const real c_10 = c[21];
    const real cos_theta_5 = shared[8];
    const real theta_5_dot = v[4];
    const real sin_theta_5 = shared[9];
    const real z_18 = theta_5_dot*sin_theta_5;
    const real z_19 = theta_5_dot*cos_theta_5;
    Mdot1[0][4] = Mdot1[4][0] = -(c_10*(cos_theta_5*z_10 + cos_theta_1*z_18) - c_10*(sin_theta_5*z_12 +
        sin_theta_1*z_19));
    const real c_11 = c[22];
    Mdot1[1][4] = Mdot1[4][1] = -(c_11*(cos_theta_5*z_11 + cos_theta_2*z_18) - c_11*(sin_theta_5*z_13 +
        sin_theta_2*z_19));
    const real c_12 = c[23];
    Mdot1[2][4] = Mdot1[4][2] = -(c_12*(cos_theta_5*z_14 + cos_theta_3*z_18) - c_12*(sin_theta_5*z_15 +
        sin_theta_3*z_19));
    const real c_13 = c[24];
    Mdot1[3][4] = Mdot1[4][3] = -(c_13*(cos_theta_5*z_16 + cos_theta_4*z_18) - c_13*(sin_theta_5*z_17 +
        sin_theta_4*z_19));
    Mdot1[4][4] = em_real(0.0);
    const real z_20 = theta_1_dot*theta_2_dot*(c_1*(cos_theta_2*sin_theta_1 - cos_theta_1*sin_theta_2));
    const real z_21 = theta_1_dot*theta_3_dot*(c_3*(sin_theta_1*cos_theta_3 - cos_theta_1*sin_theta_3));
    const real z_22 = theta_1_dot*theta_4_dot*(c_6*(sin_theta_1*cos_theta_4 - cos_theta_1*sin_theta_4));
    const real z_23 = theta_1_dot*theta_5_dot*(c_10*(sin_theta_1*cos_theta_5 - cos_theta_1*sin_theta_5));
    const real c_15 = c[26];
    f1[0] = -((z_20 + z_21 + z_22 + z_23) + sin_theta_1*c_15);
    const real z_24 = theta_2_dot*theta_3_dot*(c_4*(sin_theta_2*cos_theta_3 - cos_theta_2*sin_theta_3));
    const real z_25 = theta_2_dot*theta_4_dot*(c_7*(sin_theta_2*cos_theta_4 - cos_theta_2*sin_theta_4));
    const real z_26 = theta_2_dot*theta_5_dot*(c_11*(sin_theta_2*cos_theta_5 - cos_theta_2*sin_theta_5));
    const real c_16 = c[27];
    f1[1] = (z_20 - z_24 - z_25 - z_26) - sin_theta_2*c_16;
    const real z_27 = theta_3_dot*theta_4_dot*(c_8*(sin_theta_3*cos_theta_4 - cos_theta_3*sin_theta_4));
    const real z_28 = theta_3_dot*theta_5_dot*(c_12*(sin_theta_3*cos_theta_5 - cos_theta_3*sin_theta_5));
    const real c_17 = c[28];
    f1[2] = (z_21 + z_24 - z_27 - z_28) - sin_theta_3*c_17;
    const real z_29 = theta_4_dot*theta_5_dot*(c_13*(sin_theta_4*cos_theta_5 - cos_theta_4*sin_theta_5));
    const real c_18 = c[29];
    f1[3] = (z_22 + z_25 + z_27 - z_29) - sin_theta_4*c_18;
    const real c_19 = c[30];
    f1[4] = (z_23 + z_26 + z_28 + z_29) - sin_theta_5*c_19;
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[10];
    triangular_masses(y, c, M1, shared);

    /* theta_1, theta_2, theta_3, theta_4, theta_5: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];

    real Mdot1[N1][N1], f1[N1];
    triangular_motion(dy, c, shared, Mdot1, f1);

    /* theta_1, theta_2, theta_3, theta_4, theta_5: a = L^-1 f - Phi eta */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* etadot = a (45) */
    dy[5] = a1[0];
    dy[6] = a1[1];
    dy[7] = a1[2];
    dy[8] = a1[3];
    dy[9] = a1[4];
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
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                              real shared[10])
{
    const real c_0 = c[11];
    M1[0][0] = c_0;
    const real c_1 = c[12];
    const real theta_1 = x[0];
    const real cos_theta_1 = em_cos(theta_1);
    const real theta_2 = x[1];
    const real cos_theta_2 = em_cos(theta_2);
    const real sin_theta_1 = em_sin(theta_1);
    const real sin_theta_2 = em_sin(theta_2);
    M1[0][1] = M1[1][0] = c_1*(cos_theta_1*cos_theta_2 + sin_theta_1*sin_theta_2);
    const real c_2 = c[13];
    M1[1][1] = c_2;
    const real c_3 = c[14];
    const real theta_3 = x[2];
    const real cos_theta_3 = em_cos(theta_3);
    const real sin_theta_3 = em_sin(theta_3);
    M1[0][2] = M1[2][0] = c_3*(cos_theta_1*cos_theta_3 + sin_theta_1*sin_theta_3);
    const real c_4 = c[15];
    M1[1][2] = M1[2][1] = c_4*(cos_theta_2*cos_theta_3 + sin_theta_2*sin_theta_3);
    const real c_5 = c[16];
    M1[2][2] = c_5;
    const real c_6 = c[17];
    const real theta_4 = x[3];
    const real cos_theta_4 = em_cos(theta_4);
    const real sin_theta_4 = em_sin(theta_4);
    M1[0][3] = M1[3][0] = c_6*(cos_theta_1*cos_theta_4 + sin_theta_1*sin_theta_4);
    const real c_7 = c[18];
    M1[1][3] = M1[3][1] = c_7*(cos_theta_2*cos_theta_4 + sin_theta_2*sin_theta_4);
    const real c_8 = c[19];
    M1[2][3] = M1[3][2] = c_8*(cos_theta_3*cos_theta_4 + sin_theta_3*sin_theta_4);
    const real c_9 = c[20];
    M1[3][3] = c_9;
    const real c_10 = c[21];
    const real theta_5 = x[4];
    const real cos_theta_5 = em_cos(theta_5);
    const real sin_theta_5 = em_sin(theta_5);
    M1[0][4] = M1[4][0] = c_10*(cos_theta_1*cos_theta_5 + sin_theta_1*sin_theta_5);
    const real c_11 = c[22];
    M1[1][4] = M1[4][1] = c_11*(cos_theta_2*cos_theta_5 + sin_theta_2*sin_theta_5);
    const real c_12 = c[23];
    M1[2][4] = M1[4][2] = c_12*(cos_theta_3*cos_theta_5 + sin_theta_3*sin_theta_5);
    const real c_13 = c[24];
    M1[3][4] = M1[4][3] = c_13*(cos_theta_4*cos_theta_5 + sin_theta_4*sin_theta_5);
    const real c_14 = c[25];
    M1[4][4] = c_14;
    shared[0] = cos_theta_2;
    shared[1] = sin_theta_1;
    shared[2] = cos_theta_1;
    shared[3] = sin_theta_2;
    shared[4] = cos_theta_3;
    shared[5] = sin_theta_3;
    shared[6] = cos_theta_4;
    shared[7] = sin_theta_4;
    shared[8] = cos_theta_5;
    shared[9] = sin_theta_5;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[10],
                             real Mdot1[N1][N1])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[12];
    const real cos_theta_2 = shared[0];
    const real theta_1_dot = v[0];
    const real sin_theta_1 = shared[1];
    const real z_10 = theta_1_dot*sin_theta_1;
    const real cos_theta_1 = shared[2];
    const real theta_2_dot = v[1];
    const real sin_theta_2 = shared[3];
    const real z_11 = theta_2_dot*sin_theta_2;
    const real z_12 = theta_1_dot*cos_theta_1;
    const real z_13 = theta_2_dot*cos_theta_2;
    Mdot1[0][1] = Mdot1[1][0] = -(c_1*(cos_theta_2*z_10 + cos_theta_1*z_11) - c_1*(sin_theta_2*z_12 +
        sin_theta_1*z_13));
    Mdot1[1][1] = em_real(0.0);
    const real c_3 = c[14];
    const real cos_theta_3 = shared[4];
    const real theta_3_dot = v[2];
    const real sin_theta_3 = shared[5];
    const real z_14 = theta_3_dot*sin_theta_3;
    const real z_15 = theta_3_dot*cos_theta_3;
    Mdot1[0][2] = Mdot1[2][0] = -(c_3*(cos_theta_3*z_10 + cos_theta_1*z_14) - c_3*(sin_theta_3*z_12 +
        sin_theta_1*z_15));
    const real c_4 = c[15];
    Mdot1[1][2] = Mdot1[2][1] = -(c_4*(cos_theta_3*z_11 + cos_theta_2*z_14) - c_4*(sin_theta_3*z_13 +
        sin_theta_2*z_15));
    Mdot1[2][2] = em_real(0.0);
    const real c_6 = c[17];
    const real cos_theta_4 = shared[6];
    const real theta_4_dot = v[3];
    const real sin_theta_4 = shared[7];
    const real z_16 = theta_4_dot*sin_theta_4;
    const real z_17 = theta_4_dot*cos_theta_4;
    Mdot1[0][3] = Mdot1[3][0] = -(c_6*(cos_theta_4*z_10 + cos_theta_1*z_16) - c_6*(sin_theta_4*z_12 +
        sin_theta_1*z_17));
    const real c_7 = c[18];
    Mdot1[1][3] = Mdot1[3][1] = -(c_7*(cos_theta_4*z_11 + cos_theta_2*z_16) - c_7*(sin_theta_4*z_13 +
        sin_theta_2*z_17));
    const real c_8 = c[19];
    Mdot1[2][3] = Mdot1[3][2] = -(c_8*(cos_theta_4*z_14 + cos_theta_3*z_16) - c_8*(sin_theta_4*z_15 +
        sin_theta_3*z_17));
    Mdot1[3][3] = em_real(0.0);
    const real c_10 = c[21];
    const real cos_theta_5 = shared[8];
    const real theta_5_dot = v[4];
    const real sin_theta_5 = shared[9];
    const real z_18 = theta_5_dot*sin_theta_5;
    const real z_19 = theta_5_dot*cos_theta_5;
    Mdot1[0][4] = Mdot1[4][0] = -(c_10*(cos_theta_5*z_10 + cos_theta_1*z_18) - c_10*(sin_theta_5*z_12 +
        sin_theta_1*z_19));
    const real c_11 = c[22];
    Mdot1[1][4] = Mdot1[4][1] = -(c_11*(cos_theta_5*z_11 + cos_theta_2*z_18) - c_11*(sin_theta_5*z_13 +
        sin_theta_2*z_19));
    const real c_12 = c[23];
    Mdot1[2][4] = Mdot1[4][2] = -(c_12*(cos_theta_5*z_14 + cos_theta_3*z_18) - c_12*(sin_theta_5*z_15 +
        sin_theta_3*z_19));
    const real c_13 = c[24];
    Mdot1[3][4] = Mdot1[4][3] = -(c_13*(cos_theta_5*z_16 + cos_theta_4*z_18) - c_13*(sin_theta_5*z_17 +
        sin_theta_4*z_19));
    Mdot1[4][4] = em_real(0.0);
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

enum { N_PIVOTS = 5 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], shared[10];
    settled_masses(y, c, M1, shared);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1], e[2], e[3], e[4] };
    if (mode) em_backward(N1, memory + 0, memory + 25, v1);
    else em_velocity_of_eta(N1, y + 10, y + 35, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
    v[4] = v1[4];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s.
 * *done becomes 0 in lanes that are settled number by number instead, as where the mode changes;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], shared[10];
    settled_masses(y, c, M1, shared);
    real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    *done &= em_refresh(N1, M1[0], y + 10, y + 35, mode ? NULL : eta1);
    y[5] = eta1[0];
    y[6] = eta1[1];
    y[7] = eta1[2];
    y[8] = eta1[3];
    y[9] = eta1[4];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 25, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 35);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        real time = em_time_on_lanes(N1, y + 10, y + 35, Mdot1[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes chain_5_lanes;
em_lanes chain_5_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double theta_1_dot = v[0];
    const double l_1 = c[5];
    const double z_0 = theta_1_dot*l_1;
    const double theta_1 = x[0];
    const double cos_theta_1 = em_cos(theta_1);
    const double m_5 = c[4];
    const double sin_theta_1 = em_sin(theta_1);
    const double theta_2 = x[1];
    const double sin_theta_2 = em_sin(theta_2);
    const double theta_2_dot = v[1];
    const double l_2 = c[6];
    const double z_4 = theta_2_dot*l_2;
    const double z_5 = sin_theta_1*z_0 + sin_theta_2*z_4;
    const double theta_3 = x[2];
    const double sin_theta_3 = em_sin(theta_3);
    const double theta_3_dot = v[2];
    const double l_3 = c[7];
    const double z_7 = theta_3_dot*l_3;
    const double z_8 = z_5 + sin_theta_3*z_7;
    const double theta_4 = x[3];
    const double sin_theta_4 = em_sin(theta_4);
    const double theta_4_dot = v[3];
    const double l_4 = c[8];
    const double z_10 = theta_4_dot*l_4;
    const double z_11 = z_8 + sin_theta_4*z_10;
    const double l_5 = c[9];
    const double theta_5_dot = v[4];
    const double theta_5 = x[4];
    const double sin_theta_5 = em_sin(theta_5);
    const double z_13 = theta_5_dot*sin_theta_5;
    const double z_14 = z_11 + l_5*z_13;
    const double m_4 = c[3];
    const double z_15 = m_5*z_14 + m_4*z_11;
    const double m_3 = c[2];
    const double z_16 = z_15 + m_3*z_8;
    const double m_2 = c[1];
    const double z_17 = z_16 + m_2*z_5;
    const double z_18 = cos_theta_1*z_17;
    const double cos_theta_2 = em_cos(theta_2);
    const double z_20 = cos_theta_1*z_0 + cos_theta_2*z_4;
    const double cos_theta_3 = em_cos(theta_3);
    const double z_22 = z_20 + cos_theta_3*z_7;
    const double cos_theta_4 = em_cos(theta_4);
    const double z_24 = z_22 + cos_theta_4*z_10;
    const double cos_theta_5 = em_cos(theta_5);
    const double z_26 = theta_5_dot*cos_theta_5;
    const double z_27 = z_24 + l_5*z_26;
    const double z_28 = m_5*z_27 + m_4*z_24;
    const double z_29 = z_28 + m_3*z_22;
    const double z_30 = z_29 + m_2*z_20;
    const double c_15 = c[26];
    const double z_31 = theta_1_dot*theta_1_dot;
    const double z_32 = theta_2_dot*theta_2_dot;
    const double z_33 = z_31*(l_1*cos_theta_1) + z_32*(l_2*cos_theta_2);
    const double z_34 = theta_3_dot*theta_3_dot;
    const double z_35 = z_33 + z_34*(l_3*cos_theta_3);
    const double z_36 = theta_4_dot*theta_4_dot;
    const double z_37 = z_35 + z_36*(l_4*cos_theta_4);
    const double z_38 = l_5*(theta_5_dot*theta_5_dot);
    const double z_39 = z_37 + cos_theta_5*z_38;
    const double z_40 = m_5*z_39 + m_4*z_37;
    const double z_41 = m_3*z_35 + z_40;
    const double z_42 = m_2*z_33 + z_41;
    const double z_43 = z_31*(l_1*sin_theta_1) + z_32*(l_2*sin_theta_2);
    const double z_44 = z_43 + z_34*(l_3*sin_theta_3);
    const double z_45 = z_44 + z_36*(l_4*sin_theta_4);
    const double z_46 = z_45 + sin_theta_5*z_38;
    const double z_47 = m_5*z_46 + m_4*z_45;
    const double z_48 = m_3*z_44 + z_47;
    const double z_49 = m_2*z_43 + z_48;
    bias[0] = (z_0*z_18 - sin_theta_1*(z_30*z_0 + c_15)) - (l_1*(theta_1_dot*z_18 + sin_theta_1*z_42) -
        l_1*(theta_1_dot*(sin_theta_1*z_30) + cos_theta_1*z_49));
    const double z_50 = cos_theta_2*z_17;
    const double c_16 = c[27];
    bias[1] = (z_4*z_50 - sin_theta_2*(z_30*z_4 + c_16)) - (l_2*(theta_2_dot*z_50 + sin_theta_2*z_42) -
        l_2*(theta_2_dot*(sin_theta_2*z_30) + cos_theta_2*z_49));
    const double z_51 = cos_theta_3*z_16;
    const double c_17 = c[28];
    bias[2] = (z_7*z_51 - sin_theta_3*(z_29*z_7 + c_17)) - (l_3*(theta_3_dot*z_51 + sin_theta_3*z_41) -
        l_3*(theta_3_dot*(sin_theta_3*z_29) + cos_theta_3*z_48));
    const double z_52 = cos_theta_4*z_15;
    const double c_18 = c[29];
    bias[3] = (z_10*z_52 - sin_theta_4*(z_28*z_10 + c_18)) - (l_4*(theta_4_dot*z_52 + sin_theta_4*z_40) -
        l_4*(theta_4_dot*(sin_theta_4*z_28) + cos_theta_4*z_47));
    const double c_20 = c[31];
    const double z_53 = z_14*z_26;
    const double c_19 = c[30];
    bias[4] = (c_20*z_53 - sin_theta_5*(theta_5_dot*(z_27*c_20) + c_19)) - (c_20*(z_53 + sin_theta_5*z_39) -
        c_20*(z_27*z_13 + cos_theta_5*z_46));
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double theta_1_dot = v[0];
    const double c_0 = c[11];
    const double theta_2_dot = v[1];
    const double c_1 = c[12];
    const double theta_1 = x[0];
    const double cos_theta_1 = em_cos(theta_1);
    const double theta_2 = x[1];
    const double cos_theta_2 = em_cos(theta_2);
    const double sin_theta_1 = em_sin(theta_1);
    const double sin_theta_2 = em_sin(theta_2);
    const double z_4 = c_1*(cos_theta_1*cos_theta_2 + sin_theta_1*sin_theta_2);
    const double theta_3_dot = v[2];
    const double c_3 = c[14];
    const double theta_3 = x[2];
    const double cos_theta_3 = em_cos(theta_3);
    const double sin_theta_3 = em_sin(theta_3);
    const double z_7 = c_3*(cos_theta_1*cos_theta_3 + sin_theta_1*sin_theta_3);
    const double theta_4_dot = v[3];
    const double c_6 = c[17];
    const double theta_4 = x[3];
    const double cos_theta_4 = em_cos(theta_4);
    const double sin_theta_4 = em_sin(theta_4);
    const double z_10 = c_6*(cos_theta_1*cos_theta_4 + sin_theta_1*sin_theta_4);
    const double theta_5_dot = v[4];
    const double c_10 = c[21];
    const double theta_5 = x[4];
    const double cos_theta_5 = em_cos(theta_5);
    const double sin_theta_5 = em_sin(theta_5);
    const double z_13 = c_10*(cos_theta_1*cos_theta_5 + sin_theta_1*sin_theta_5);
    const double c_2 = c[13];
    const double c_4 = c[15];
    const double z_14 = c_4*(cos_theta_2*cos_theta_3 + sin_theta_2*sin_theta_3);
    const double c_7 = c[18];
    const double z_15 = c_7*(cos_theta_2*cos_theta_4 + sin_theta_2*sin_theta_4);
    const double c_11 = c[22];
    const double z_16 = c_11*(cos_theta_2*cos_theta_5 + sin_theta_2*sin_theta_5);
    const double c_5 = c[16];
    const double c_8 = c[19];
    const double z_17 = c_8*(cos_theta_3*cos_theta_4 + sin_theta_3*sin_theta_4);
    const double c_12 = c[23];
    const double z_18 = c_12*(cos_theta_3*cos_theta_5 + sin_theta_3*sin_theta_5);
    const double c_9 = c[20];
    const double c_13 = c[24];
    const double z_19 = c_13*(cos_theta_4*cos_theta_5 + sin_theta_4*sin_theta_5);
    const double c_14 = c[25];
    e[0] = 0.5*(theta_1_dot*(theta_1_dot*c_0 + theta_2_dot*z_4 + theta_3_dot*z_7 + theta_4_dot*z_10 +
        theta_5_dot*z_13) + theta_2_dot*(theta_1_dot*z_4 + theta_2_dot*c_2 + theta_3_dot*z_14 + theta_4_dot*z_15 +
        theta_5_dot*z_16) + theta_3_dot*(theta_1_dot*z_7 + theta_2_dot*z_14 + theta_3_dot*c_5 + theta_4_dot*z_17 +
        theta_5_dot*z_18) + theta_4_dot*(theta_1_dot*z_10 + theta_2_dot*z_15 + theta_3_dot*z_17 + theta_4_dot*c_9
        + theta_5_dot*z_19) + theta_5_dot*(theta_1_dot*z_13 + theta_2_dot*z_16 + theta_3_dot*z_18 +
        theta_4_dot*z_19 + theta_5_dot*c_14));
    e[1] = 0.0;
    e[2] = 0.0;
    const double l_1 = c[5];
    const double l_2 = c[6];
    const double z_20 = l_1*cos_theta_1 + l_2*cos_theta_2;
    const double c_21 = c[32];
    const double l_3 = c[7];
    const double z_21 = z_20 + l_3*cos_theta_3;
    const double c_22 = c[33];
    const double l_4 = c[8];
    const double z_22 = z_21 + l_4*cos_theta_4;
    const double c_23 = c[34];
    const double l_5 = c[9];
    const double c_24 = c[35];
    const double c_25 = c[36];
    e[3] = -(z_20*c_21 + z_21*c_22 + z_22*c_23 + (z_22 + l_5*cos_theta_5)*c_24 + cos_theta_1*c_25);
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
    p[0] = p[1] = p[2] = p[3] = 0.0;
    const double l_1 = c[5];
    const double theta_1 = x[0];
    const double sin_theta_1 = em_sin(theta_1);
    const double z_1 = l_1*sin_theta_1;
    p[4] = p[6] = p[9] = z_1;
    const double cos_theta_1 = em_cos(theta_1);
    const double z_3 = l_1*cos_theta_1;
    p[5] = p[7] = p[10] = -z_3;
    const double c_26 = c[37];
    p[8] = c_26;
    const double l_2 = c[6];
    const double theta_2 = x[1];
    const double sin_theta_2 = em_sin(theta_2);
    const double z_5 = l_2*sin_theta_2 + z_1;
    p[11] = p[13] = p[16] = z_5;
    const double cos_theta_2 = em_cos(theta_2);
    const double z_7 = z_3 + l_2*cos_theta_2;
    p[12] = p[14] = p[17] = -z_7;
    const double c_27 = c[38];
    p[15] = c_27;
    const double l_3 = c[7];
    const double theta_3 = x[2];
    const double sin_theta_3 = em_sin(theta_3);
    const double z_9 = l_3*sin_theta_3 + z_5;
    p[18] = p[20] = p[23] = z_9;
    const double cos_theta_3 = em_cos(theta_3);
    const double z_11 = z_7 + l_3*cos_theta_3;
    p[19] = p[21] = p[24] = -z_11;
    const double c_28 = c[39];
    p[22] = c_28;
    const double l_4 = c[8];
    const double theta_4 = x[3];
    const double sin_theta_4 = em_sin(theta_4);
    const double z_13 = l_4*sin_theta_4 + z_9;
    p[25] = p[27] = p[30] = z_13;
    const double cos_theta_4 = em_cos(theta_4);
    const double z_15 = z_11 + l_4*cos_theta_4;
    p[26] = p[28] = p[31] = -z_15;
    const double c_29 = c[40];
    p[29] = c_29;
    const double l_5 = c[9];
    const double theta_5 = x[4];
    const double sin_theta_5 = em_sin(theta_5);
    p[32] = p[34] = p[37] = l_5*sin_theta_5 + z_13;
    const double cos_theta_5 = em_cos(theta_5);
    p[33] = p[35] = p[38] = -(z_15 + l_5*cos_theta_5);
    const double c_30 = c[41];
    p[36] = c_30;
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
    const double theta_2 = x[1];
    const double cos_theta_2 = em_cos(theta_2);
    const double theta_1 = x[0];
    const double sin_theta_1 = em_sin(theta_1);
    const double l_1 = c[5];
    const double m_2 = c[1];
    const double m_3 = c[2];
    const double m_4 = c[3];
    const double m_5 = c[4];
    const double z_2 = l_1*m_4 + l_1*m_5;
    const double z_3 = l_1*m_3 + z_2;
    const double l_2 = c[6];
    const double z_4 = (l_1*m_2 + z_3)*l_2;
    const double cos_theta_1 = em_cos(theta_1);
    const double sin_theta_2 = em_sin(theta_2);
    const double z_7 = cos_theta_2*sin_theta_1*z_4 - cos_theta_1*sin_theta_2*z_4;
    dM[5] = dM[1] = -z_7;
    const double l_3 = c[7];
    const double theta_3 = x[2];
    const double cos_theta_3 = em_cos(theta_3);
    const double z_9 = l_3*cos_theta_3;
    const double sin_theta_3 = em_sin(theta_3);
    const double z_11 = l_3*sin_theta_3;
    const double z_12 = sin_theta_1*z_3*z_9 - cos_theta_1*z_3*z_11;
    dM[10] = dM[2] = -z_12;
    const double l_4 = c[8];
    const double theta_4 = x[3];
    const double cos_theta_4 = em_cos(theta_4);
    const double z_14 = l_4*cos_theta_4;
    const double sin_theta_4 = em_sin(theta_4);
    const double z_16 = l_4*sin_theta_4;
    const double z_17 = sin_theta_1*z_2*z_14 - cos_theta_1*z_2*z_16;
    dM[15] = dM[3] = -z_17;
    const double theta_5 = x[4];
    const double cos_theta_5 = em_cos(theta_5);
    const double l_5 = c[9];
    const double z_19 = m_5*l_5;
    const double z_20 = cos_theta_5*z_19;
    const double sin_theta_5 = em_sin(theta_5);
    const double z_22 = sin_theta_5*z_19;
    const double z_23 = l_1*sin_theta_1*z_20 - l_1*cos_theta_1*z_22;
    dM[20] = dM[4] = -z_23;
    dM[30] = dM[26] = z_7;
    const double z_24 = m_4*l_2 + m_5*l_2;
    const double z_25 = m_3*l_2 + z_24;
    const double z_26 = sin_theta_2*z_25*z_9 - cos_theta_2*z_25*z_11;
    dM[36] = dM[32] = -z_26;
    const double z_27 = sin_theta_2*z_24*z_14 - cos_theta_2*z_24*z_16;
    dM[41] = dM[33] = -z_27;
    const double z_28 = l_2*sin_theta_2*z_20 - l_2*cos_theta_2*z_22;
    dM[46] = dM[34] = -z_28;
    dM[60] = dM[52] = z_12;
    dM[61] = dM[57] = z_26;
    const double z_29 = m_4*l_3 + m_5*l_3;
    const double z_30 = sin_theta_3*z_29*z_14 - cos_theta_3*z_29*z_16;
    dM[67] = dM[63] = -z_30;
    const double z_31 = z_20*z_11 - z_22*z_9;
    dM[72] = dM[64] = -z_31;
    dM[90] = dM[78] = z_17;
    dM[91] = dM[83] = z_27;
    dM[92] = dM[88] = z_30;
    const double z_32 = z_16*z_20 - z_14*z_22;
    dM[98] = dM[94] = -z_32;
    dM[120] = dM[104] = z_23;
    dM[121] = dM[109] = z_28;
    dM[122] = dM[114] = z_31;
    dM[123] = dM[119] = z_32;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta_1 = x[0];
    const double cos_theta_1 = em_cos(theta_1);
    const double m_5 = c[4];
    const double theta_1_dot = v[0];
    const double l_1 = c[5];
    const double z_1 = theta_1_dot*l_1;
    const double z_2 = cos_theta_1*z_1;
    const double theta_2_dot = v[1];
    const double l_2 = c[6];
    const double theta_2 = x[1];
    const double cos_theta_2 = em_cos(theta_2);
    const double z_4 = l_2*cos_theta_2;
    const double z_5 = theta_2_dot*z_4;
    const double z_6 = z_2 + z_5;
    const double theta_3_dot = v[2];
    const double l_3 = c[7];
    const double theta_3 = x[2];
    const double cos_theta_3 = em_cos(theta_3);
    const double z_8 = l_3*cos_theta_3;
    const double z_9 = theta_3_dot*z_8;
    const double z_10 = z_6 + z_9;
    const double theta_4_dot = v[3];
    const double l_4 = c[8];
    const double theta_4 = x[3];
    const double cos_theta_4 = em_cos(theta_4);
    const double z_12 = l_4*cos_theta_4;
    const double z_13 = theta_4_dot*z_12;
    const double z_14 = z_10 + z_13;
    const double theta_5_dot = v[4];
    const double l_5 = c[9];
    const double theta_5 = x[4];
    const double cos_theta_5 = em_cos(theta_5);
    const double z_16 = l_5*cos_theta_5;
    const double z_17 = z_14 + theta_5_dot*z_16;
    const double m_4 = c[3];
    const double z_18 = m_5*z_17 + m_4*z_14;
    const double m_3 = c[2];
    const double z_19 = z_18 + m_3*z_10;
    const double m_2 = c[1];
    const double z_20 = z_19 + m_2*z_6;
    const double z_21 = z_20*z_1;
    const double m_1 = c[0];
    const double g = c[10];
    const double z_22 = m_4*g + m_5*g;
    const double z_23 = m_3*g + z_22;
    const double z_24 = m_2*g + z_23;
    const double z_25 = l_1*(theta_1_dot*theta_1_dot);
    const double z_26 = theta_2_dot*theta_2_dot;
    const double z_27 = cos_theta_1*z_25 + z_26*z_4;
    const double z_28 = theta_3_dot*theta_3_dot;
    const double z_29 = z_27 + z_28*z_8;
    const double z_30 = theta_4_dot*theta_4_dot;
    const double z_31 = z_29 + z_30*z_12;
    const double z_32 = theta_5_dot*theta_5_dot;
    const double z_33 = z_31 + z_32*z_16;
    const double z_34 = m_5*z_33 + m_4*z_31;
    const double z_35 = m_3*z_29 + z_34;
    const double z_36 = m_2*z_27 + z_35;
    const double z_37 = l_1*m_4 + l_1*m_5;
    const double z_38 = l_1*m_3 + z_37;
    const double z_39 = l_1*m_2 + z_38;
    const double z_40 = z_39*cos_theta_1;
    const double theta_5_ddot = a[4];
    const double sin_theta_5 = em_sin(theta_5);
    const double z_42 = m_5*l_5;
    const double z_43 = sin_theta_5*z_42;
    const double z_44 = theta_5_ddot*z_43;
    const double theta_4_ddot = a[3];
    const double sin_theta_4 = em_sin(theta_4);
    const double z_46 = l_4*sin_theta_4;
    const double z_47 = theta_4_ddot*z_46;
    const double theta_3_ddot = a[2];
    const double sin_theta_3 = em_sin(theta_3);
    const double z_49 = l_3*sin_theta_3;
    const double z_50 = theta_3_ddot*z_49;
    const double sin_theta_2 = em_sin(theta_2);
    const double z_52 = l_2*sin_theta_2;
    const double theta_2_ddot = a[1];
    const double z_53 = z_39*theta_2_ddot;
    const double sin_theta_1 = em_sin(theta_1);
    const double z_55 = sin_theta_1*z_25 + z_26*z_52;
    const double z_56 = z_55 + z_28*z_49;
    const double z_57 = z_56 + z_30*z_46;
    const double z_58 = z_57 + l_5*sin_theta_5*z_32;
    const double z_59 = m_5*z_58 + m_4*z_57;
    const double z_60 = m_3*z_56 + z_59;
    const double z_61 = m_2*z_55 + z_60;
    const double z_62 = z_39*sin_theta_1;
    const double z_63 = cos_theta_5*z_42;
    const double z_64 = theta_5_ddot*z_63;
    const double z_65 = theta_4_ddot*z_12;
    const double z_66 = theta_3_ddot*z_8;
    D[0] = -(cos_theta_1*(z_21 + z_25*z_40 - (l_1*m_1*g + z_21 + l_1*z_24) - l_1*z_36 - l_1*z_44 - z_37*z_47 -
        z_38*z_50 - z_52*z_53) - sin_theta_1*(l_1*z_61 - z_25*z_62 - l_1*z_64 - z_37*z_65 - z_38*z_66 -
        z_4*z_53));
    const double z_67 = l_2*z_26;
    const double z_68 = l_2*theta_2_ddot;
    D[1] = -(cos_theta_2*(z_67*z_40 - z_62*z_68) + sin_theta_2*(z_67*z_62 + z_40*z_68));
    const double z_69 = l_3*z_28;
    const double z_70 = cos_theta_1*z_38;
    const double z_71 = l_3*theta_3_ddot;
    const double z_72 = sin_theta_1*z_38;
    D[2] = -(cos_theta_3*(z_69*z_70 - z_71*z_72) + sin_theta_3*(z_69*z_72 + z_71*z_70));
    const double z_73 = l_4*z_30;
    const double z_74 = cos_theta_1*z_37;
    const double z_75 = l_4*theta_4_ddot;
    const double z_76 = sin_theta_1*z_37;
    D[3] = -(cos_theta_4*(z_73*z_74 - z_75*z_76) + sin_theta_4*(z_73*z_76 + z_75*z_74));
    const double z_77 = z_32*z_42;
    const double z_78 = l_1*cos_theta_1;
    const double z_79 = theta_5_ddot*z_42;
    const double z_80 = l_1*sin_theta_1;
    D[4] = -(cos_theta_5*(z_77*z_78 - z_79*z_80) + sin_theta_5*(z_77*z_80 + z_79*z_78));
    const double z_81 = theta_2_dot*z_52;
    D[6] = (-2.0)*(z_40*z_81 - z_5*z_62);
    const double z_82 = theta_3_dot*z_49;
    D[7] = (-2.0)*(z_82*z_70 - z_9*z_72);
    const double z_83 = theta_4_dot*z_46;
    D[8] = (-2.0)*(z_83*z_74 - z_13*z_76);
    const double z_84 = theta_5_dot*z_43;
    const double z_85 = theta_5_dot*z_63;
    D[9] = (-2.0)*(z_84*z_78 - z_85*z_80);
    const double z_86 = m_4*l_2 + m_5*l_2;
    const double z_87 = m_3*l_2 + z_86;
    const double z_88 = m_2*l_2 + z_87;
    const double z_89 = cos_theta_2*z_88;
    const double theta_1_ddot = a[0];
    const double z_90 = z_39*theta_1_ddot;
    const double z_91 = sin_theta_2*z_88;
    D[10] = -(cos_theta_1*(z_25*z_89 - z_52*z_90) + sin_theta_1*(z_25*z_91 + z_4*z_90));
    const double z_92 = theta_2_dot*l_2*z_20;
    const double z_93 = z_88*z_26;
    const double z_94 = l_2*theta_1_ddot;
    D[11] = -(cos_theta_2*(z_92 + z_4*z_93 - (z_92 + l_2*z_24) - l_2*z_36 - l_2*z_44 - z_86*z_47 - z_87*z_50 -
        z_62*z_94) - sin_theta_2*(l_2*z_61 - z_52*z_93 - l_2*z_64 - z_86*z_65 - z_87*z_66 - z_40*z_94));
    const double z_95 = cos_theta_2*z_87;
    const double z_96 = sin_theta_2*z_87;
    D[12] = -(cos_theta_3*(z_69*z_95 - z_71*z_96) + sin_theta_3*(z_69*z_96 + z_71*z_95));
    const double z_97 = cos_theta_2*z_86;
    const double z_98 = sin_theta_2*z_86;
    D[13] = -(cos_theta_4*(z_73*z_97 - z_75*z_98) + sin_theta_4*(z_73*z_98 + z_75*z_97));
    D[14] = -(cos_theta_5*(z_4*z_77 - z_52*z_79) + sin_theta_5*(z_52*z_77 + z_4*z_79));
    const double z_99 = sin_theta_1*z_1;
    D[15] = 2.0*(z_2*z_91 - z_99*z_89);
    D[17] = (-2.0)*(z_82*z_95 - z_9*z_96);
    D[18] = (-2.0)*(z_83*z_97 - z_13*z_98);
    D[19] = (-2.0)*(z_4*z_84 - z_52*z_85);
    const double z_100 = m_4*l_3 + m_5*l_3;
    const double z_101 = m_3*l_3 + z_100;
    const double z_102 = cos_theta_3*z_101;
    const double z_103 = z_38*theta_1_ddot;
    const double z_104 = sin_theta_3*z_101;
    D[20] = -(cos_theta_1*(z_25*z_102 - z_49*z_103) + sin_theta_1*(z_25*z_104 + z_8*z_103));
    const double z_105 = z_87*theta_2_ddot;
    D[21] = -(cos_theta_2*(z_67*z_102 - z_49*z_105) + sin_theta_2*(z_67*z_104 + z_8*z_105));
    const double z_106 = theta_3_dot*l_3*z_19;
    const double z_107 = z_101*z_28;
    const double z_108 = l_3*theta_2_ddot;
    const double z_109 = l_3*theta_1_ddot;
    D[22] = -(cos_theta_3*(z_106 + z_8*z_107 - (z_106 + l_3*z_23) - l_3*z_35 - l_3*z_44 - z_100*z_47 - z_96*z_108
        - z_72*z_109) - sin_theta_3*(l_3*z_60 - z_49*z_107 - l_3*z_64 - z_100*z_65 - z_95*z_108 - z_70*z_109));
    const double z_110 = cos_theta_3*z_100;
    const double z_111 = sin_theta_3*z_100;
    D[23] = -(cos_theta_4*(z_73*z_110 - z_75*z_111) + sin_theta_4*(z_73*z_111 + z_75*z_110));
    D[24] = -(cos_theta_5*(z_8*z_77 - z_49*z_79) + sin_theta_5*(z_49*z_77 + z_8*z_79));
    D[25] = 2.0*(z_2*z_104 - z_99*z_102);
    D[26] = 2.0*(z_5*z_104 - z_81*z_102);
    D[28] = (-2.0)*(z_83*z_110 - z_13*z_111);
    D[29] = (-2.0)*(z_8*z_84 - z_49*z_85);
    const double z_112 = m_4*l_4 + m_5*l_4;
    const double z_113 = cos_theta_4*z_112;
    const double z_114 = z_37*theta_1_ddot;
    const double z_115 = sin_theta_4*z_112;
    D[30] = -(cos_theta_1*(z_25*z_113 - z_46*z_114) + sin_theta_1*(z_25*z_115 + z_12*z_114));
    const double z_116 = z_86*theta_2_ddot;
    D[31] = -(cos_theta_2*(z_67*z_113 - z_46*z_116) + sin_theta_2*(z_67*z_115 + z_12*z_116));
    const double z_117 = z_100*theta_3_ddot;
    D[32] = -(cos_theta_3*(z_69*z_113 - z_46*z_117) + sin_theta_3*(z_69*z_115 + z_12*z_117));
    const double z_118 = theta_4_dot*l_4*z_18;
    const double z_119 = z_112*z_30;
    const double z_120 = l_4*theta_3_ddot;
    const double z_121 = l_4*theta_2_ddot;
    const double z_122 = l_4*theta_1_ddot;
    D[33] = -(cos_theta_4*(z_118 + z_12*z_119 - (z_118 + l_4*z_22) - l_4*z_34 - l_4*z_44 - z_111*z_120 -
        z_98*z_121 - z_76*z_122) - sin_theta_4*(l_4*z_59 - z_46*z_119 - l_4*z_64 - z_110*z_120 - z_97*z_121 -
        z_74*z_122));
    D[34] = -(cos_theta_5*(z_12*z_77 - z_46*z_79) + sin_theta_5*(z_46*z_77 + z_12*z_79));
    D[35] = 2.0*(z_2*z_115 - z_113*z_99);
    D[36] = 2.0*(z_5*z_115 - z_113*z_81);
    D[37] = 2.0*(z_9*z_115 - z_113*z_82);
    D[39] = (-2.0)*(z_12*z_84 - z_46*z_85);
    const double z_123 = l_1*theta_1_ddot;
    D[40] = -(cos_theta_1*(z_63*z_25 - z_43*z_123) + sin_theta_1*(z_43*z_25 + z_63*z_123));
    D[41] = -(cos_theta_2*(z_63*z_67 - z_43*z_68) + sin_theta_2*(z_43*z_67 + z_63*z_68));
    D[42] = -(cos_theta_3*(z_63*z_69 - z_43*z_71) + sin_theta_3*(z_43*z_69 + z_63*z_71));
    D[43] = -(cos_theta_4*(z_63*z_73 - z_43*z_75) + sin_theta_4*(z_43*z_73 + z_63*z_75));
    const double z_124 = theta_5_dot*z_17*z_42;
    const double z_125 = l_5*l_5*(m_5*z_32);
    const double z_126 = theta_2_ddot*z_42;
    const double z_127 = theta_1_ddot*z_42;
    D[44] = -(cos_theta_5*(z_124 + cos_theta_5*z_125 - (z_124 + g*z_42) - z_33*z_42 - z_42*z_47 - z_42*z_50 -
        z_52*z_126 - z_80*z_127) - sin_theta_5*(z_58*z_42 - sin_theta_5*z_125 - z_42*z_65 - z_42*z_66 - z_4*z_126
        - z_78*z_127));
    D[45] = (-2.0)*(z_63*z_99 - z_2*z_43);
    D[46] = (-2.0)*(z_63*z_81 - z_5*z_43);
    D[47] = (-2.0)*(z_63*z_82 - z_9*z_43);
    D[48] = (-2.0)*(z_63*z_83 - z_13*z_43);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double g = c[10];
    const double l_1 = c[5];
    const double theta_1 = x[0];
    const double sin_theta_1 = em_sin(theta_1);
    const double z_1 = l_1*sin_theta_1;
    const double z_2 = g*z_1;
    const double theta_1_ddot = a[0];
    D[0] = z_2 + theta_1_ddot*(l_1*l_1);
    const double theta_1_dot = v[0];
    const double z_3 = theta_1_dot*theta_1_dot;
    const double theta_2_dot = v[1];
    const double z_4 = theta_2_dot*theta_2_dot;
    const double l_2 = c[6];
    const double theta_2 = x[1];
    const double sin_theta_2 = em_sin(theta_2);
    const double z_6 = l_2*sin_theta_2;
    const double z_7 = z_3*z_1 + z_4*z_6;
    const double cos_theta_1 = em_cos(theta_1);
    const double z_9 = l_1*cos_theta_1;
    const double cos_theta_2 = em_cos(theta_2);
    const double z_11 = l_2*cos_theta_2;
    const double z_12 = z_3*z_9 + z_4*z_11;
    const double theta_2_ddot = a[1];
    const double z_13 = theta_2_ddot*z_6;
    const double z_14 = theta_2_ddot*z_11;
    const double z_15 = sin_theta_1*z_13 + cos_theta_1*z_14 + l_1*theta_1_ddot;
    D[1] = -(z_7*z_9 - z_12*z_1 - z_2 - l_1*z_15);
    const double theta_3_dot = v[2];
    const double z_16 = theta_3_dot*theta_3_dot;
    const double l_3 = c[7];
    const double theta_3 = x[2];
    const double sin_theta_3 = em_sin(theta_3);
    const double z_18 = l_3*sin_theta_3;
    const double z_19 = z_7 + z_16*z_18;
    const double cos_theta_3 = em_cos(theta_3);
    const double z_21 = l_3*cos_theta_3;
    const double z_22 = z_12 + z_16*z_21;
    const double theta_3_ddot = a[2];
    const double z_23 = theta_3_ddot*z_18;
    const double z_24 = theta_3_ddot*z_21;
    const double z_25 = (sin_theta_1*z_23 + cos_theta_1*z_24) + z_15;
    D[2] = -(z_19*z_9 - z_22*z_1 - z_2 - l_1*z_25);
    const double theta_4_dot = v[3];
    const double z_26 = theta_4_dot*theta_4_dot;
    const double l_4 = c[8];
    const double theta_4 = x[3];
    const double sin_theta_4 = em_sin(theta_4);
    const double z_28 = l_4*sin_theta_4;
    const double z_29 = z_19 + z_26*z_28;
    const double cos_theta_4 = em_cos(theta_4);
    const double z_31 = l_4*cos_theta_4;
    const double z_32 = z_22 + z_26*z_31;
    const double theta_4_ddot = a[3];
    const double z_33 = theta_4_ddot*z_28;
    const double z_34 = theta_4_ddot*z_31;
    const double z_35 = (sin_theta_1*z_33 + cos_theta_1*z_34) + z_25;
    const double z_36 = z_2 + l_1*z_35;
    D[3] = -(z_29*z_9 - z_32*z_1 - z_36);
    const double theta_5_dot = v[4];
    const double z_37 = theta_5_dot*theta_5_dot;
    const double l_5 = c[9];
    const double theta_5 = x[4];
    const double sin_theta_5 = em_sin(theta_5);
    const double z_39 = l_5*sin_theta_5;
    const double z_40 = z_29 + z_37*z_39;
    const double cos_theta_5 = em_cos(theta_5);
    const double z_42 = l_5*cos_theta_5;
    const double z_43 = z_32 + z_37*z_42;
    const double theta_5_ddot = a[4];
    const double z_44 = l_5*theta_5_ddot;
    const double z_45 = sin_theta_5*z_44;
    const double z_46 = cos_theta_5*z_44;
    D[4] = -(z_40*z_9 - z_43*z_1 - z_1*z_45 - z_9*z_46 - z_36);
    const double m_2 = c[1];
    const double m_3 = c[2];
    const double m_5 = c[4];
    const double m_4 = c[3];
    const double z_47 = m_5*z_43 + m_4*z_32;
    const double z_48 = m_3*z_22 + z_47;
    const double z_49 = m_2*z_12 + z_48;
    const double z_50 = m_5*z_40 + m_4*z_29;
    const double z_51 = m_3*z_19 + z_50;
    const double z_52 = m_2*z_7 + z_51;
    const double z_53 = m_5*sin_theta_5;
    const double z_54 = z_53*z_44;
    const double z_55 = m_5*cos_theta_5;
    const double z_56 = z_55*z_44;
    const double z_57 = m_4*g + m_5*g;
    const double z_58 = m_3*g + z_57;
    const double z_59 = m_2*g + z_58;
    const double m_1 = c[0];
    const double z_60 = l_1*m_4 + l_1*m_5;
    const double z_61 = l_1*m_3 + z_60;
    const double z_62 = l_1*m_2 + z_61;
    const double z_63 = l_1*m_1;
    const double z_64 = m_4 + m_5;
    D[5] = sin_theta_1*z_49 + sin_theta_1*z_54 + cos_theta_1*z_56 + m_3*z_25 + m_2*z_15 + sin_theta_1*(z_59 +
        m_1*g) + theta_1_ddot*(z_62 + 2.0*z_63) + z_35*z_64 - cos_theta_1*z_52;
    const double z_65 = cos_theta_2*z_4;
    const double z_66 = z_62*sin_theta_1;
    const double z_67 = sin_theta_2*z_4;
    const double z_68 = z_62*cos_theta_1;
    const double z_69 = sin_theta_2*theta_2_ddot;
    const double z_70 = cos_theta_2*theta_2_ddot;
    D[6] = z_65*z_66 + z_69*z_66 + z_70*z_68 - z_67*z_68;
    const double z_71 = cos_theta_3*z_16;
    const double z_72 = sin_theta_1*z_61;
    const double z_73 = sin_theta_3*z_16;
    const double z_74 = cos_theta_1*z_61;
    const double z_75 = sin_theta_3*theta_3_ddot;
    const double z_76 = cos_theta_3*theta_3_ddot;
    D[7] = z_71*z_72 + z_75*z_72 + z_76*z_74 - z_73*z_74;
    const double z_77 = cos_theta_4*z_26;
    const double z_78 = sin_theta_1*z_60;
    const double z_79 = sin_theta_4*z_26;
    const double z_80 = cos_theta_1*z_60;
    const double z_81 = sin_theta_4*theta_4_ddot;
    const double z_82 = cos_theta_4*theta_4_ddot;
    D[8] = z_77*z_78 + z_81*z_78 + z_82*z_80 - z_79*z_80;
    const double z_83 = z_37*z_55;
    const double z_84 = z_37*z_53;
    const double z_85 = theta_5_ddot*z_53;
    const double z_86 = theta_5_ddot*z_55;
    D[9] = z_1*z_83 + z_1*z_85 + z_9*z_86 - z_9*z_84;
    D[10] = sin_theta_1*(z_62 + z_63);
    const double z_87 = sin_theta_1*theta_1_ddot;
    const double z_88 = cos_theta_1*theta_1_ddot;
    const double z_89 = z_6*z_87 + z_11*z_88;
    const double z_90 = g*z_6 + l_1*z_89;
    D[13] = -(z_7*z_11 - z_12*z_6 - theta_2_ddot*(l_2*l_2) - z_90);
    const double z_91 = l_2*theta_2_ddot + (sin_theta_2*z_23 + cos_theta_2*z_24);
    D[14] = -(z_19*z_11 - z_22*z_6 - l_2*z_91 - z_90);
    const double z_92 = (sin_theta_2*z_33 + cos_theta_2*z_34) + z_91;
    const double z_93 = l_2*z_92 + z_90;
    D[15] = -(z_29*z_11 - z_32*z_6 - z_93);
    D[16] = -(z_40*z_11 - z_43*z_6 - z_6*z_45 - z_11*z_46 - z_93);
    const double z_94 = m_2*l_2;
    const double z_95 = m_4*l_2 + m_5*l_2;
    const double z_96 = m_3*l_2 + z_95;
    const double z_97 = z_94 + z_96;
    const double z_98 = sin_theta_2*z_97;
    const double z_99 = cos_theta_1*z_3;
    const double z_100 = sin_theta_1*z_3;
    const double z_101 = m_3 + z_64;
    D[17] = z_98*z_99 + z_89*(m_2 + z_101) - cos_theta_2*z_97*z_100;
    D[18] = sin_theta_2*z_49 + sin_theta_2*z_59 + sin_theta_2*z_54 + cos_theta_2*z_56 + m_3*z_91 +
        z_62*sin_theta_2*z_87 + z_62*cos_theta_2*z_88 + theta_2_ddot*(z_94 + z_97) + z_64*z_92 - cos_theta_2*z_52;
    const double z_102 = sin_theta_2*z_96;
    const double z_103 = cos_theta_2*z_96;
    D[19] = z_71*z_102 + z_75*z_102 + z_76*z_103 - z_73*z_103;
    const double z_104 = sin_theta_2*z_95;
    const double z_105 = cos_theta_2*z_95;
    D[20] = z_77*z_104 + z_81*z_104 + z_82*z_105 - z_79*z_105;
    D[21] = z_6*z_83 + z_6*z_85 + z_11*z_86 - z_11*z_84;
    D[22] = z_98;
    const double z_106 = z_18*z_87 + z_21*z_88;
    const double z_107 = z_18*z_69 + z_21*z_70;
    const double z_108 = l_1*z_106 + (g*z_18 + l_2*z_107);
    D[26] = -(z_19*z_21 - z_22*z_18 - theta_3_ddot*(l_3*l_3) - z_108);
    const double z_109 = l_3*theta_3_ddot + (sin_theta_3*z_33 + cos_theta_3*z_34);
    const double z_110 = l_3*z_109 + z_108;
    D[27] = -(z_29*z_21 - z_32*z_18 - z_110);
    D[28] = -(z_40*z_21 - z_43*z_18 - z_18*z_45 - z_21*z_46 - z_110);
    const double z_111 = m_3*l_3;
    const double z_112 = m_4*l_3 + m_5*l_3;
    const double z_113 = z_111 + z_112;
    const double z_114 = sin_theta_3*z_113;
    const double z_115 = cos_theta_3*z_113;
    D[29] = z_114*z_99 + z_106*z_101 - z_100*z_115;
    D[30] = z_114*z_65 + z_107*z_101 - z_67*z_115;
    D[31] = sin_theta_3*z_48 + sin_theta_3*z_58 + sin_theta_3*z_54 + cos_theta_3*z_56 + sin_theta_3*z_96*z_69 +
        cos_theta_3*z_96*z_70 + z_61*sin_theta_3*z_87 + z_61*cos_theta_3*z_88 + theta_3_ddot*(z_111 + z_113) +
        z_64*z_109 - cos_theta_3*z_51;
    const double z_116 = sin_theta_3*z_112;
    const double z_117 = cos_theta_3*z_112;
    D[32] = z_77*z_116 + z_81*z_116 + z_82*z_117 - z_79*z_117;
    D[33] = z_18*z_83 + z_18*z_85 + z_21*z_86 - z_21*z_84;
    D[34] = z_114;
    const double z_118 = z_28*z_75 + z_31*z_76;
    const double z_119 = z_28*z_69 + z_31*z_70;
    const double z_120 = z_28*z_87 + z_31*z_88;
    const double z_121 = (l_3*z_118 + l_2*z_119) + (l_1*z_120 + (g*z_28 + theta_4_ddot*(l_4*l_4)));
    D[39] = -(z_29*z_31 - z_32*z_28 - z_121);
    D[40] = -(z_40*z_31 - z_43*z_28 - z_28*z_45 - z_31*z_46 - z_121);
    const double z_122 = m_4*l_4 + m_5*l_4;
    const double z_123 = sin_theta_4*z_122;
    const double z_124 = cos_theta_4*z_122;
    D[41] = z_123*z_99 + z_64*z_120 - z_100*z_124;
    D[42] = z_123*z_65 + z_64*z_119 - z_67*z_124;
    D[43] = z_123*z_71 + z_64*z_118 - z_73*z_124;
    D[44] = sin_theta_4*z_47 + sin_theta_4*z_57 + sin_theta_4*z_54 + cos_theta_4*z_56 + sin_theta_4*z_112*z_75 +
        cos_theta_4*z_112*z_76 + sin_theta_4*z_95*z_69 + cos_theta_4*z_95*z_70 + z_60*sin_theta_4*z_87 +
        z_60*cos_theta_4*z_88 + theta_4_ddot*(z_122 + z_122) - cos_theta_4*z_50;
    D[45] = z_28*z_83 + z_28*z_85 + z_31*z_86 - z_31*z_84;
    D[46] = z_123;
    const double z_125 = theta_1_ddot*z_1;
    const double z_126 = theta_1_ddot*z_9;
    D[52] = theta_5_ddot*(l_5*l_5) + z_43*z_39 + g*z_39 + z_39*z_33 + z_42*z_34 + z_39*z_23 + z_42*z_24 +
        z_39*z_13 + z_42*z_14 + z_39*z_125 + z_42*z_126 - z_40*z_42;
    const double z_127 = l_5*z_53;
    const double z_128 = l_5*z_55;
    D[53] = z_127*z_99 + z_127*z_87 + z_128*z_88 - z_128*z_100;
    D[54] = z_127*z_65 + z_127*z_69 + z_128*z_70 - z_128*z_67;
    D[55] = z_127*z_71 + z_127*z_75 + z_128*z_76 - z_128*z_73;
    D[56] = z_127*z_77 + z_127*z_81 + z_128*z_82 - z_128*z_79;
    D[57] = 2.0*m_5*z_44 + z_43*z_53 + g*z_53 + z_53*z_33 + z_55*z_34 + z_53*z_23 + z_55*z_24 + z_53*z_13 +
        z_55*z_14 + z_53*z_125 + z_55*z_126 - z_40*z_55;
    D[58] = z_127;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes chain_5_lanes;
EM_WEAK em_lanes chain_5_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 10, 35, 0, 25 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double l_1 = parameters[5];
    const double m_2 = parameters[1];
    const double m_3 = parameters[2];
    const double m_4 = parameters[3];
    const double m_5 = parameters[4];
    const double z_0 = l_1*m_4 + l_1*m_5;
    const double z_1 = l_1*m_3 + z_0;
    const double z_2 = l_1*m_2 + z_1;
    const double m_1 = parameters[0];
    prepared[11] = l_1*z_2 + m_1*(l_1*l_1); /* c_0 */
    const double l_2 = parameters[6];
    prepared[12] = z_2*l_2; /* c_1 */
    const double z_3 = m_4*l_2 + m_5*l_2;
    const double z_4 = m_3*l_2 + z_3;
    prepared[13] = l_2*(m_2*l_2 + z_4); /* c_2 */
    const double l_3 = parameters[7];
    prepared[14] = l_3*z_1; /* c_3 */
    prepared[15] = l_3*z_4; /* c_4 */
    const double z_5 = m_4*l_3 + m_5*l_3;
    prepared[16] = l_3*(m_3*l_3 + z_5); /* c_5 */
    const double l_4 = parameters[8];
    prepared[17] = l_4*z_0; /* c_6 */
    prepared[18] = l_4*z_3; /* c_7 */
    prepared[19] = l_4*z_5; /* c_8 */
    prepared[20] = l_4*(m_4*l_4 + m_5*l_4); /* c_9 */
    const double l_5 = parameters[9];
    const double z_6 = m_5*l_5;
    prepared[21] = l_1*z_6; /* c_10 */
    prepared[22] = l_2*z_6; /* c_11 */
    prepared[23] = l_3*z_6; /* c_12 */
    prepared[24] = l_4*z_6; /* c_13 */
    prepared[25] = m_5*(l_5*l_5); /* c_14 */
    const double g = parameters[10];
    const double z_7 = l_1*m_1*g;
    const double z_8 = m_2*g;
    const double z_9 = m_3*g;
    const double z_10 = m_4*g;
    const double z_11 = m_5*g;
    const double z_12 = z_10 + z_11;
    const double z_13 = z_9 + z_12;
    const double z_14 = z_8 + z_13;
    prepared[26] = z_7 + l_1*z_14; /* c_15 */
    prepared[27] = l_2*z_14; /* c_16 */
    prepared[28] = l_3*z_13; /* c_17 */
    prepared[29] = l_4*z_12; /* c_18 */
    prepared[30] = g*z_6; /* c_19 */
    prepared[31] = z_6; /* c_20 */
    prepared[32] = z_8; /* c_21 */
    prepared[33] = z_9; /* c_22 */
    prepared[34] = z_10; /* c_23 */
    prepared[35] = z_11; /* c_24 */
    prepared[36] = z_7; /* c_25 */
    prepared[37] = (1.0/12.0)*l_1; /* c_26 */
    prepared[38] = (1.0/12.0)*l_2; /* c_27 */
    prepared[39] = (1.0/12.0)*l_3; /* c_28 */
    prepared[40] = (1.0/12.0)*l_4; /* c_29 */
    prepared[41] = (1.0/12.0)*l_5; /* c_30 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {62, "nonnegative"},
    {62, "nonnegative"},
    {62, "nonnegative"},
    {62, "nonnegative"},
    {62, "nonnegative"},
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
    const double c_0 = c[11];
    M[0] = c_0;
    const double c_1 = c[12];
    const double theta_1 = x[0];
    const double cos_theta_1 = em_cos(theta_1);
    const double theta_2 = x[1];
    const double cos_theta_2 = em_cos(theta_2);
    const double sin_theta_1 = em_sin(theta_1);
    const double sin_theta_2 = em_sin(theta_2);
    M[5] = M[1] = c_1*(cos_theta_1*cos_theta_2 + sin_theta_1*sin_theta_2);
    const double c_2 = c[13];
    M[6] = c_2;
    const double c_3 = c[14];
    const double theta_3 = x[2];
    const double cos_theta_3 = em_cos(theta_3);
    const double sin_theta_3 = em_sin(theta_3);
    M[10] = M[2] = c_3*(cos_theta_1*cos_theta_3 + sin_theta_1*sin_theta_3);
    const double c_4 = c[15];
    M[11] = M[7] = c_4*(cos_theta_2*cos_theta_3 + sin_theta_2*sin_theta_3);
    const double c_5 = c[16];
    M[12] = c_5;
    const double c_6 = c[17];
    const double theta_4 = x[3];
    const double cos_theta_4 = em_cos(theta_4);
    const double sin_theta_4 = em_sin(theta_4);
    M[15] = M[3] = c_6*(cos_theta_1*cos_theta_4 + sin_theta_1*sin_theta_4);
    const double c_7 = c[18];
    M[16] = M[8] = c_7*(cos_theta_2*cos_theta_4 + sin_theta_2*sin_theta_4);
    const double c_8 = c[19];
    M[17] = M[13] = c_8*(cos_theta_3*cos_theta_4 + sin_theta_3*sin_theta_4);
    const double c_9 = c[20];
    M[18] = c_9;
    const double c_10 = c[21];
    const double theta_5 = x[4];
    const double cos_theta_5 = em_cos(theta_5);
    const double sin_theta_5 = em_sin(theta_5);
    M[20] = M[4] = c_10*(cos_theta_1*cos_theta_5 + sin_theta_1*sin_theta_5);
    const double c_11 = c[22];
    M[21] = M[9] = c_11*(cos_theta_2*cos_theta_5 + sin_theta_2*sin_theta_5);
    const double c_12 = c[23];
    M[22] = M[14] = c_12*(cos_theta_3*cos_theta_5 + sin_theta_3*sin_theta_5);
    const double c_13 = c[24];
    M[23] = M[19] = c_13*(cos_theta_4*cos_theta_5 + sin_theta_4*sin_theta_5);
    const double c_14 = c[25];
    M[24] = c_14;
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
    real M1[N1][N1], shared[10];
    settled_masses(y, c, M1, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 35);
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
    em_spread(N, N1, coordinate1, y + 10, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 10);
    for (int i = 0; i < N1; ++i) y[35 + i] = s[coordinate1[i]];
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

#include "chain_5.h"

static const char *const coordinate_names[] = { "theta_1", "theta_2", "theta_3", "theta_4", "theta_5", NULL };
static const char *const parameter_names[] = { "m_1", "m_2", "m_3", "m_4", "m_5", "l_1", "l_2", "l_3", "l_4", "l_5",
    "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.7853981633974483, 0.7853981633974483, 0.7853981633974483, 0.7853981633974483,
    0.7853981633974483 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 2},
    {"line", 2, 4},
    {"disk", 6, 3},
    {"line", 9, 4},
    {"disk", 13, 3},
    {"line", 16, 4},
    {"disk", 20, 3},
    {"line", 23, 4},
    {"disk", 27, 3},
    {"line", 30, 4},
    {"disk", 34, 3},
    {"trace", 37, 2}
};
static const em_slice layout[] = {
    {"x", 0, 5},
    {"eta", 5, 5},
    {"C", 10, 25},
    {"s", 35, 5}
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
static int simulate(em_run *run) { return em_simulate(&chain_5_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&chain_5_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&chain_5_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&chain_5_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&chain_5_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&chain_5_model, run, mode); }

const em_model chain_5_model = {
    .abi = EM_ABI,
    .name = "chain_5",
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
    .lanes = &chain_5_lanes,
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
    .n_shapes = 12,
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
