/* eigenmotion generate spatial_arm.py */
/* input sha256:123f02a70e5ee10d7729d33f668f9b52f582ed1181b23d7ac380899a4ad2caa6 */
/* body sha256:730202a7bc0156f7658eecb4ebcf5d69a94d11d9a5b10223332e85ad0b76a071 */
/* spatial_arm_3: equations of motion, eigenfactor formulation.
 *
 * State, 18 numbers:
 *   x    y[0 .. 3)
 *   eta  y[3 .. 6)
 *   C    y[6 .. 15)
 *   s    y[15 .. 18)
 *
 * Blocks of M that do not couple:
 *   1: q_1, q_2, q_3 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dq_1: M does not depend on it
 *
 * Operations of the straight-line part:
 *   eigenfactor: 56 additions, 124 multiplications, 4 function calls
 *   triangular root: 69 additions, 149 multiplications, 4 function calls
 *   projection: 45 additions, 96 multiplications, 4 function calls
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
    N_PARAMETERS = 8,
    N_PREPARED = 38,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 9,          /* inputs, parameters and the time */
    N_ARGUMENTS = 15,     /* x, v and these: what motion depends on */
    N1 = 3,               /* q_1, q_2, q_3 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1])
{
    const real q_2 = x[1];
    const real cos_q_2 = em_cos(q_2);
    const real c_0 = c[8];
    const real l_3 = c[5];
    const real l_1 = c[3];
    const real l_2 = c[4];
    const real z_1 = l_2*cos_q_2;
    const real z_2 = l_1 + z_1;
    const real q_3 = x[2];
    const real cos_q_3 = em_cos(q_3);
    const real z_4 = cos_q_2*l_3 + 2.0*z_2*cos_q_3;
    const real c_1 = c[9];
    const real q_2_dot = v[1];
    const real sin_q_2 = em_sin(q_2);
    const real z_6 = q_2_dot*sin_q_2;
    const real q_3_dot = v[2];
    const real sin_q_3 = em_sin(q_3);
    const real z_8 = q_3_dot*sin_q_3;
    const real z_9 = l_3*z_6 + 2.0*(cos_q_3*(l_2*z_6) + z_2*z_8);
    const real z_10 = c_0*z_6 + z_9*c_1;
    const real m_2 = c[1];
    const real c_5 = c[13];
    const real c_6 = c[14];
    const real c_9 = c[17];
    const real z_11 = sin_q_3*sin_q_3;
    const real c_18 = c[26];
    const real z_12 = c_18*z_6;
    const real m_3 = c[2];
    const real c_19 = c[27];
    const real z_13 = cos_q_3*z_8;
    const real z_14 = m_3*(z_4*z_8 + cos_q_3*z_9) + 2.0*(c_19*z_11*z_6 - z_2*c_6*z_13);
    const real c_3 = c[11];
    const real z_15 = sin_q_2*sin_q_2*z_13;
    const real z_16 = cos_q_2*z_6;
    const real c_20 = c[28];
    const real z_17 = cos_q_3*cos_q_3;
    const real c_7 = c[15];
    const real c_21 = c[29];
    Mdot1[0][0] = ((-1.0/12.0))*(((cos_q_2*c_0 + z_4*c_1)*z_6 + cos_q_2*z_10) + 3.0*l_2*((m_2*(c_5 + z_1) +
        cos_q_3*z_4*c_6 + z_2*c_9*z_11)*z_6 + cos_q_2*(z_12 + 2.0*z_14)) + 12.0*c_20*(z_15 - z_17*z_16) + (z_12 +
        z_14)*c_7 - 2.0*c_3*(z_15 + z_11*z_16) - c_21*z_16);
    const real c_12 = c[20];
    const real z_18 = q_3_dot*sin_q_2;
    const real z_19 = q_2_dot*sin_q_3;
    const real z_20 = cos_q_2*z_19;
    const real c_22 = c[30];
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/12.0))*(c_12*(z_11*z_18 - z_17*z_18 - cos_q_3*z_20) -
        6.0*c_22*(cos_q_3*z_18 + z_20));
    const real c_14 = c[22];
    const real c_23 = c[31];
    const real c_13 = c[21];
    Mdot1[1][1] = (1.0/12.0)*(c_23*z_13 - (c_3*z_13 + (cos_q_3*c_0 + (c_14 + l_3*cos_q_3)*c_1)*z_8) - c_13*z_8);
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/12.0))*z_10;
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real q_1_dot = v[0];
    const real z_21 = q_1_dot*sin_q_2;
    const real z_22 = q_2_dot*cos_q_3 + sin_q_3*z_21;
    const real z_23 = c_0*z_22 + (l_3*z_22 + q_2_dot*c_14)*c_1;
    const real c_24 = c[32];
    const real c_8 = c[16];
    const real z_24 = q_1_dot*q_1_dot;
    const real c_11 = c[19];
    const real z_25 = c_11*(z_19 - cos_q_3*z_21);
    const real c_25 = c[33];
    const real c_2 = c[10];
    const real z_26 = q_3_dot + q_1_dot*cos_q_2;
    const real z_27 = q_1_dot*z_1;
    const real z_28 = q_1_dot*l_1 + z_27;
    const real z_29 = l_3*z_26 + 2.0*cos_q_3*z_28;
    const real c_10 = c[18];
    f1[1] = (1.0/12.0)*(cos_q_2*(q_1_dot*sin_q_3*z_23 + c_24 + c_8*(sin_q_2*z_24) + cos_q_3*c_25 -
        z_25*(q_1_dot*cos_q_3)) - sin_q_2*(cos_q_2*c_2*z_24 + q_1_dot*(c_0*z_26 + z_29*c_1) +
        c_10*(q_1_dot*(2.0*m_3*(2.0*z_28*z_11 + cos_q_3*z_29) + m_2*(z_27 + q_1_dot*c_5)))));
    const real c_26 = c[34];
    const real c_27 = c[35];
    f1[2] = (1.0/12.0)*(cos_q_3*(z_23*z_21 + q_2_dot*z_25 + c_26*(sin_q_3*(z_28*z_28))) + sin_q_3*(z_21*z_25 -
        q_2_dot*z_23 - z_28*z_29*c_27 - sin_q_2*c_25));
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* q_1, q_2, q_3: xdot = C^T S^-1 eta (20) */
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

    /* q_1, q_2, q_3: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[3], y[4], y[5] };
    const real *const C1 = y + 6, *const s1 = y + 15;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];

    real Mdot1[N1][N1], f1[N1];
    eigenfactor_motion(y, dy, c, Mdot1, f1);

    /* q_1, q_2, q_3: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
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
                                 real shared[13])
{
    const real q_2 = x[1];
    const real cos_q_2 = em_cos(q_2);
    const real c_0 = c[8];
    const real l_3 = c[5];
    const real l_1 = c[3];
    const real l_2 = c[4];
    const real z_1 = l_2*cos_q_2;
    const real z_2 = l_1 + z_1;
    const real q_3 = x[2];
    const real cos_q_3 = em_cos(q_3);
    const real z_4 = cos_q_2*l_3 + 2.0*z_2*cos_q_3;
    const real c_1 = c[9];
    const real z_5 = cos_q_2*c_0 + z_4*c_1;
    const real c_2 = c[10];
    const real sin_q_2 = em_sin(q_2);
    const real z_7 = sin_q_2*sin_q_2;
    const real c_3 = c[11];
    const real sin_q_3 = em_sin(q_3);
    const real z_9 = sin_q_3*sin_q_3;
    const real c_4 = c[12];
    const real m_2 = c[1];
    const real c_5 = c[13];
    const real z_10 = m_2*(c_5 + z_1);
    const real m_3 = c[2];
    const real c_6 = c[14];
    const real z_11 = z_2*z_9;
    const real c_7 = c[15];
    const real c_8 = c[16];
    const real c_9 = c[17];
    const real z_12 = z_10 + cos_q_3*z_4*c_6 + c_9*z_11;
    const real c_10 = c[18];
    const real c_11 = c[19];
    const real z_13 = cos_q_3*cos_q_3;
    M1[0][0] = (1.0/12.0)*(cos_q_2*z_5 + c_2*(cos_q_2*cos_q_2) + z_7*(c_3*z_9) + c_4 + (z_10 + z_4*(m_3*cos_q_3) +
        c_6*z_11)*c_7 + c_8*z_7 + cos_q_2*z_12*c_10 + c_11*z_7*z_13);
    const real z_14 = sin_q_3*sin_q_2;
    const real c_12 = c[20];
    const real c_13 = c[21];
    M1[1][0] = (1.0/12.0)*(z_14*(cos_q_3*c_12) + c_13*z_14);
    const real c_14 = c[22];
    const real z_15 = c_14 + l_3*cos_q_3;
    const real z_16 = cos_q_3*c_0 + z_15*c_1;
    const real c_15 = c[23];
    const real c_16 = c[24];
    M1[1][1] = (1.0/12.0)*(cos_q_3*z_16 + c_15 + z_15*c_16 + c_11*z_9);
    M1[2][0] = (1.0/12.0)*z_5;
    M1[2][1] = em_real(0.0);
    const real c_17 = c[25];
    M1[2][2] = c_17;
    shared[0] = z_5;
    shared[1] = sin_q_2;
    shared[2] = cos_q_2;
    shared[3] = cos_q_3;
    shared[4] = z_2;
    shared[5] = sin_q_3;
    shared[6] = z_12;
    shared[7] = z_4;
    shared[8] = z_9;
    shared[9] = z_7;
    shared[10] = z_13;
    shared[11] = z_16;
    shared[12] = z_1;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[13],
                                 real Mdot1[N1][N1], real f1[N1])
{
    const real z_5 = shared[0];
    const real q_2_dot = v[1];
    const real sin_q_2 = shared[1];
    const real z_17 = q_2_dot*sin_q_2;
    const real cos_q_2 = shared[2];
    const real c_0 = c[8];
    const real l_3 = c[5];
    const real cos_q_3 = shared[3];
    const real l_2 = c[4];
    const real z_2 = shared[4];
    const real q_3_dot = v[2];
    const real sin_q_3 = shared[5];
    const real z_18 = q_3_dot*sin_q_3;
    const real z_19 = l_3*z_17 + 2.0*(cos_q_3*(l_2*z_17) + z_2*z_18);
    const real c_1 = c[9];
    const real z_20 = c_0*z_17 + z_19*c_1;
    const real z_12 = shared[6];
    const real c_18 = c[26];
    const real z_21 = c_18*z_17;
    const real m_3 = c[2];
    const real z_4 = shared[7];
    const real c_19 = c[27];
    const real z_9 = shared[8];
    const real c_6 = c[14];
    const real z_22 = cos_q_3*z_18;
    const real z_23 = m_3*(z_4*z_18 + cos_q_3*z_19) + 2.0*(c_19*z_9*z_17 - c_6*(z_2*z_22));
    const real c_3 = c[11];
    const real z_7 = shared[9];
    const real z_24 = z_7*z_22;
    const real z_25 = cos_q_2*z_17;
    const real c_20 = c[28];
    const real z_13 = shared[10];
    const real c_7 = c[15];
    const real c_21 = c[29];
    Mdot1[0][0] = ((-1.0/12.0))*((z_5*z_17 + cos_q_2*z_20) + 3.0*l_2*(z_12*z_17 + cos_q_2*(z_21 + 2.0*z_23)) +
        12.0*c_20*(z_24 - z_13*z_25) + (z_21 + z_23)*c_7 - 2.0*c_3*(z_24 + z_9*z_25) - c_21*z_25);
    const real c_12 = c[20];
    const real z_26 = q_3_dot*sin_q_2;
    const real z_27 = q_2_dot*sin_q_3;
    const real z_28 = cos_q_2*z_27;
    const real c_22 = c[30];
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/12.0))*(c_12*(z_9*z_26 - z_13*z_26 - cos_q_3*z_28) - 6.0*c_22*(cos_q_3*z_26
        + z_28));
    const real z_16 = shared[11];
    const real c_23 = c[31];
    const real c_13 = c[21];
    Mdot1[1][1] = (1.0/12.0)*(c_23*z_22 - (c_3*z_22 + z_16*z_18) - c_13*z_18);
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/12.0))*z_20;
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real q_1_dot = v[0];
    const real z_29 = q_1_dot*sin_q_2;
    const real z_30 = q_2_dot*cos_q_3 + sin_q_3*z_29;
    const real c_14 = c[22];
    const real z_31 = c_0*z_30 + (l_3*z_30 + q_2_dot*c_14)*c_1;
    const real c_24 = c[32];
    const real c_8 = c[16];
    const real z_32 = q_1_dot*q_1_dot;
    const real c_11 = c[19];
    const real z_33 = c_11*(z_27 - cos_q_3*z_29);
    const real c_25 = c[33];
    const real c_2 = c[10];
    const real z_34 = q_3_dot + q_1_dot*cos_q_2;
    const real l_1 = c[3];
    const real z_1 = shared[12];
    const real z_35 = q_1_dot*z_1;
    const real z_36 = q_1_dot*l_1 + z_35;
    const real z_37 = l_3*z_34 + 2.0*cos_q_3*z_36;
    const real c_10 = c[18];
    const real m_2 = c[1];
    const real c_5 = c[13];
    f1[1] = (1.0/12.0)*(cos_q_2*(q_1_dot*sin_q_3*z_31 + c_24 + c_8*(sin_q_2*z_32) + cos_q_3*c_25 -
        z_33*(q_1_dot*cos_q_3)) - sin_q_2*(cos_q_2*c_2*z_32 + q_1_dot*(c_0*z_34 + z_37*c_1) +
        c_10*(q_1_dot*(2.0*m_3*(2.0*z_36*z_9 + cos_q_3*z_37) + m_2*(z_35 + q_1_dot*c_5)))));
    const real c_26 = c[34];
    const real c_27 = c[35];
    f1[2] = (1.0/12.0)*(cos_q_3*(z_31*z_29 + q_2_dot*z_33 + c_26*(sin_q_3*(z_36*z_36))) + sin_q_3*(z_29*z_33 -
        q_2_dot*z_31 - z_36*z_37*c_27 - sin_q_2*c_25));
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[13];
    triangular_masses(y, c, M1, shared);

    /* q_1, q_2, q_3: M = L L^T */
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

    /* q_1, q_2, q_3: a = L^-1 f - Phi eta */
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
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                              real shared[12])
{
    const real q_2 = x[1];
    const real cos_q_2 = em_cos(q_2);
    const real c_0 = c[8];
    const real l_3 = c[5];
    const real l_1 = c[3];
    const real l_2 = c[4];
    const real z_1 = l_2*cos_q_2;
    const real z_2 = l_1 + z_1;
    const real q_3 = x[2];
    const real cos_q_3 = em_cos(q_3);
    const real z_4 = cos_q_2*l_3 + 2.0*z_2*cos_q_3;
    const real c_1 = c[9];
    const real z_5 = cos_q_2*c_0 + z_4*c_1;
    const real c_2 = c[10];
    const real sin_q_2 = em_sin(q_2);
    const real z_7 = sin_q_2*sin_q_2;
    const real c_3 = c[11];
    const real sin_q_3 = em_sin(q_3);
    const real z_9 = sin_q_3*sin_q_3;
    const real c_4 = c[12];
    const real m_2 = c[1];
    const real c_5 = c[13];
    const real z_10 = m_2*(c_5 + z_1);
    const real m_3 = c[2];
    const real c_6 = c[14];
    const real z_11 = z_2*z_9;
    const real c_7 = c[15];
    const real c_8 = c[16];
    const real c_9 = c[17];
    const real z_12 = z_10 + cos_q_3*z_4*c_6 + c_9*z_11;
    const real c_10 = c[18];
    const real c_11 = c[19];
    const real z_13 = cos_q_3*cos_q_3;
    M1[0][0] = (1.0/12.0)*(cos_q_2*z_5 + c_2*(cos_q_2*cos_q_2) + z_7*(c_3*z_9) + c_4 + (z_10 + z_4*(m_3*cos_q_3) +
        c_6*z_11)*c_7 + c_8*z_7 + cos_q_2*z_12*c_10 + c_11*z_7*z_13);
    const real z_14 = sin_q_3*sin_q_2;
    const real c_12 = c[20];
    const real c_13 = c[21];
    M1[0][1] = M1[1][0] = (1.0/12.0)*(z_14*(cos_q_3*c_12) + c_13*z_14);
    const real c_14 = c[22];
    const real z_15 = c_14 + l_3*cos_q_3;
    const real z_16 = cos_q_3*c_0 + z_15*c_1;
    const real c_15 = c[23];
    const real c_16 = c[24];
    M1[1][1] = (1.0/12.0)*(cos_q_3*z_16 + c_15 + z_15*c_16 + c_11*z_9);
    M1[0][2] = M1[2][0] = (1.0/12.0)*z_5;
    M1[1][2] = M1[2][1] = em_real(0.0);
    const real c_17 = c[25];
    M1[2][2] = c_17;
    shared[0] = z_5;
    shared[1] = sin_q_2;
    shared[2] = cos_q_2;
    shared[3] = cos_q_3;
    shared[4] = z_2;
    shared[5] = sin_q_3;
    shared[6] = z_12;
    shared[7] = z_4;
    shared[8] = z_9;
    shared[9] = z_7;
    shared[10] = z_13;
    shared[11] = z_16;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[12],
                             real Mdot1[N1][N1])
{
    const real z_5 = shared[0];
    const real q_2_dot = v[1];
    const real sin_q_2 = shared[1];
    const real z_17 = q_2_dot*sin_q_2;
    const real cos_q_2 = shared[2];
    const real c_0 = c[8];
    const real l_3 = c[5];
    const real cos_q_3 = shared[3];
    const real l_2 = c[4];
    const real z_2 = shared[4];
    const real q_3_dot = v[2];
    const real sin_q_3 = shared[5];
    const real z_18 = q_3_dot*sin_q_3;
    const real z_19 = l_3*z_17 + 2.0*(cos_q_3*(l_2*z_17) + z_2*z_18);
    const real c_1 = c[9];
    const real z_20 = c_0*z_17 + z_19*c_1;
    const real z_12 = shared[6];
    const real c_18 = c[26];
    const real z_21 = c_18*z_17;
    const real m_3 = c[2];
    const real z_4 = shared[7];
    const real c_19 = c[27];
    const real z_9 = shared[8];
    const real c_6 = c[14];
    const real z_22 = cos_q_3*z_18;
    const real z_23 = m_3*(z_4*z_18 + cos_q_3*z_19) + 2.0*(c_19*z_9*z_17 - c_6*(z_2*z_22));
    const real c_3 = c[11];
    const real z_7 = shared[9];
    const real z_24 = z_7*z_22;
    const real z_25 = cos_q_2*z_17;
    const real c_20 = c[28];
    const real z_13 = shared[10];
    const real c_7 = c[15];
    const real c_21 = c[29];
    Mdot1[0][0] = ((-1.0/12.0))*((z_5*z_17 + cos_q_2*z_20) + 3.0*l_2*(z_12*z_17 + cos_q_2*(z_21 + 2.0*z_23)) +
        12.0*c_20*(z_24 - z_13*z_25) + (z_21 + z_23)*c_7 - 2.0*c_3*(z_24 + z_9*z_25) - c_21*z_25);
    const real c_12 = c[20];
    const real z_26 = q_3_dot*sin_q_2;
    const real z_27 = sin_q_3*(q_2_dot*cos_q_2);
    const real c_22 = c[30];
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/12.0))*(c_12*(z_9*z_26 - z_13*z_26 - cos_q_3*z_27) - 6.0*c_22*(cos_q_3*z_26
        + z_27));
    const real z_16 = shared[11];
    const real c_23 = c[31];
    const real c_13 = c[21];
    Mdot1[1][1] = (1.0/12.0)*(c_23*z_22 - (c_3*z_22 + z_16*z_18) - c_13*z_18);
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/12.0))*z_20;
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
    real M1[N1][N1], shared[12];
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
    real M1[N1][N1], shared[12];
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

extern em_lanes spatial_arm_3_lanes;
em_lanes spatial_arm_3_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2,
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
    const double c_20 = c[28];
    const double q_2_dot = v[1];
    const double q_3 = x[2];
    const double sin_q_3 = em_sin(q_3);
    const double cos_q_3 = em_cos(q_3);
    const double q_1_dot = v[0];
    const double q_2 = x[1];
    const double sin_q_2 = em_sin(q_2);
    const double z_3 = q_1_dot*sin_q_2;
    const double z_4 = q_2_dot*sin_q_3 - cos_q_3*z_3;
    const double q_3_dot = v[2];
    const double z_5 = q_3_dot*sin_q_3;
    const double cos_q_2 = em_cos(q_2);
    const double z_7 = q_2_dot*cos_q_2;
    const double z_8 = cos_q_3*z_4;
    const double z_9 = q_3_dot*cos_q_3;
    const double z_10 = q_2_dot*z_9 + (z_3*z_5 - q_1_dot*cos_q_3*z_7);
    const double c_0 = c[8];
    const double z_11 = q_2_dot*cos_q_3 + sin_q_3*z_3;
    const double l_3 = c[5];
    const double c_14 = c[22];
    const double c_1 = c[9];
    const double z_12 = c_0*z_11 + (l_3*z_11 + q_2_dot*c_14)*c_1;
    const double c_3 = c[11];
    const double z_13 = q_1_dot*sin_q_3;
    const double z_14 = q_2_dot*z_5 - (z_3*z_9 + z_7*z_13);
    const double z_15 = c_3*z_14;
    const double z_16 = q_3_dot + q_1_dot*cos_q_2;
    const double l_1 = c[3];
    const double l_2 = c[4];
    const double z_17 = cos_q_2*(q_1_dot*l_2);
    const double z_18 = q_1_dot*l_1 + z_17;
    const double z_19 = l_3*z_16 + 2.0*cos_q_3*z_18;
    const double z_20 = c_0*z_16 + z_19*c_1;
    const double z_21 = q_2_dot*sin_q_2;
    const double z_22 = q_2_dot*z_3;
    const double z_23 = z_18*z_5;
    const double z_24 = l_3*z_22 + 2.0*(z_23 + l_2*cos_q_3*z_22);
    const double z_25 = c_0*z_22 + c_1*z_24;
    const double m_3 = c[2];
    const double z_26 = sin_q_3*sin_q_3;
    const double m_2 = c[1];
    const double c_5 = c[13];
    const double z_27 = 2.0*m_3*(2.0*z_18*z_26 + cos_q_3*z_19) + m_2*(z_17 + q_1_dot*c_5);
    const double c_19 = c[27];
    const double c_6 = c[14];
    const double z_28 = 2.0*(cos_q_3*c_6*z_23 - c_19*z_26*z_22) - m_3*(z_19*z_5 + cos_q_3*z_24);
    const double c_18 = c[26];
    const double z_29 = c_18*z_22;
    const double c_7 = c[15];
    const double c_21 = c[29];
    bias[0] = ((-1.0/12.0))*(6.0*c_20*(z_4*(sin_q_2*z_5) - z_7*z_8 - z_10*(cos_q_3*sin_q_2)) + (sin_q_2*z_12*z_9 +
        sin_q_3*z_12*z_7 - sin_q_3*sin_q_2*z_15) + c_7*(z_28 - z_29) + c_21*(z_3*z_7) - (z_20*z_21 + cos_q_2*z_25)
        - 3.0*l_2*(z_27*z_21 - cos_q_2*(2.0*z_28 - z_29)));
    const double c_24 = c[32];
    const double c_8 = c[16];
    const double z_30 = q_1_dot*q_1_dot;
    const double c_11 = c[19];
    const double c_25 = c[33];
    const double c_2 = c[10];
    const double c_10 = c[18];
    const double c_13 = c[21];
    bias[1] = (1.0/12.0)*((cos_q_2*(z_12*z_13 + c_24 + c_8*(sin_q_2*z_30) + cos_q_3*c_25 - q_1_dot*c_11*z_8) -
        sin_q_2*(cos_q_2*c_2*z_30 + q_1_dot*z_20 + q_1_dot*z_27*c_10)) - (6.0*c_20*(q_3_dot*z_8 + sin_q_3*z_10) -
        (z_12*z_5 + cos_q_3*z_15) - c_13*z_14));
    const double z_31 = c_11*z_4;
    const double c_26 = c[34];
    const double c_27 = c[35];
    bias[2] = (1.0/12.0)*((cos_q_3*(z_12*z_3 + q_2_dot*z_31 + c_26*(sin_q_3*(z_18*z_18))) + sin_q_3*(z_3*z_31 -
        q_2_dot*z_12 - z_18*z_19*c_27 - sin_q_2*c_25)) + z_25);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double q_1_dot = v[0];
    const double q_2 = x[1];
    const double cos_q_2 = em_cos(q_2);
    const double c_0 = c[8];
    const double l_3 = c[5];
    const double l_1 = c[3];
    const double l_2 = c[4];
    const double z_1 = l_2*cos_q_2;
    const double z_2 = l_1 + z_1;
    const double q_3 = x[2];
    const double cos_q_3 = em_cos(q_3);
    const double z_4 = cos_q_2*l_3 + 2.0*z_2*cos_q_3;
    const double c_1 = c[9];
    const double z_5 = cos_q_2*c_0 + z_4*c_1;
    const double c_2 = c[10];
    const double c_3 = c[11];
    const double sin_q_3 = em_sin(q_3);
    const double z_7 = sin_q_3*sin_q_3;
    const double sin_q_2 = em_sin(q_2);
    const double z_9 = sin_q_2*sin_q_2;
    const double c_4 = c[12];
    const double m_2 = c[1];
    const double c_5 = c[13];
    const double z_10 = m_2*(c_5 + z_1);
    const double m_3 = c[2];
    const double z_11 = cos_q_3*z_4;
    const double c_6 = c[14];
    const double z_12 = z_2*z_7;
    const double c_7 = c[15];
    const double c_8 = c[16];
    const double c_9 = c[17];
    const double c_10 = c[18];
    const double c_11 = c[19];
    const double q_2_dot = v[1];
    const double c_12 = c[20];
    const double z_13 = sin_q_3*sin_q_2;
    const double c_13 = c[21];
    const double z_14 = cos_q_3*c_12*z_13 + c_13*z_13;
    const double q_3_dot = v[2];
    const double c_14 = c[22];
    const double z_15 = l_3*cos_q_3;
    const double z_16 = c_14 + z_15;
    const double c_15 = c[23];
    const double c_16 = c[24];
    e[0] = (1.0/24.0)*(q_1_dot*(q_1_dot*(cos_q_2*z_5 + c_2*(cos_q_2*cos_q_2) + c_3*z_7*z_9 + c_4 + (z_10 +
        m_3*z_11 + c_6*z_12)*c_7 + c_8*z_9 + cos_q_2*(z_10 + c_6*z_11 + c_9*z_12)*c_10 +
        c_11*(z_9*(cos_q_3*cos_q_3))) + q_2_dot*z_14 + q_3_dot*z_5) + q_2_dot*(q_1_dot*z_14 +
        q_2_dot*(cos_q_3*(cos_q_3*c_0 + z_16*c_1) + c_15 + z_16*c_16 + c_11*z_7)) + q_3_dot*(q_1_dot*z_5 +
        q_3_dot*c_3));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c_28 = c[36];
    const double c_29 = c[37];
    e[3] = (-0.5)*((sin_q_2*z_15 + sin_q_2*c_14)*c_28 + sin_q_2*c_29);
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
    p[0] = p[1] = p[2] = p[3] = p[4] = p[5] = p[8] = p[9] = p[10] = p[11] = p[15] = p[21] = 0.0;
    const double l_1 = c[3];
    const double q_1 = x[0];
    const double cos_q_1 = em_cos(q_1);
    const double z_1 = l_1*cos_q_1;
    p[6] = p[13] = p[19] = z_1;
    const double sin_q_1 = em_sin(q_1);
    const double z_3 = l_1*sin_q_1;
    p[7] = p[14] = p[20] = z_3;
    const double rho = c[6];
    p[12] = p[22] = p[32] = rho;
    const double l_2 = c[4];
    const double q_2 = x[1];
    const double cos_q_2 = em_cos(q_2);
    const double z_5 = l_2*cos_q_2;
    const double z_6 = z_1 + cos_q_1*z_5;
    p[16] = p[23] = p[29] = z_6;
    const double z_7 = z_3 + sin_q_1*z_5;
    p[17] = p[24] = p[30] = z_7;
    const double sin_q_2 = em_sin(q_2);
    const double z_9 = l_2*sin_q_2;
    p[18] = p[25] = p[31] = -z_9;
    const double l_3 = c[5];
    const double q_3 = x[2];
    const double sin_q_3 = em_sin(q_3);
    const double cos_q_3 = em_cos(q_3);
    const double z_12 = cos_q_2*cos_q_3;
    p[26] = p[33] = z_6 - l_3*(sin_q_3*sin_q_1 - cos_q_1*z_12);
    p[27] = p[34] = z_7 + l_3*(sin_q_3*cos_q_1 + sin_q_1*z_12);
    p[28] = p[35] = -(z_9 + l_3*cos_q_3*sin_q_2);
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
    const double l_1 = c[3];
    const double m_2 = c[1];
    const double l_2 = c[4];
    const double q_2 = x[1];
    const double sin_q_2 = em_sin(q_2);
    const double z_1 = l_2*sin_q_2;
    const double z_2 = m_2*z_1;
    const double l_3 = c[5];
    const double q_3 = x[2];
    const double cos_q_3 = em_cos(q_3);
    const double z_4 = cos_q_3*z_1;
    const double z_5 = l_3*sin_q_2 + 2.0*z_4;
    const double m_3 = c[2];
    const double z_6 = m_3*cos_q_3;
    const double sin_q_3 = em_sin(q_3);
    const double z_8 = sin_q_3*sin_q_3;
    const double z_9 = m_3*z_8;
    const double z_10 = z_5*z_6 + 2.0*z_1*z_9;
    const double cos_q_2 = em_cos(q_2);
    const double rho = c[6];
    const double z_12 = rho*rho;
    const double z_13 = z_12;
    const double z_14 = l_3*l_3;
    const double z_15 = 3.0*z_13 + z_14;
    const double z_16 = m_3*z_15;
    const double z_17 = l_2*cos_q_2;
    const double z_18 = l_1 + z_17;
    const double z_19 = cos_q_2*l_3 + 2.0*z_18*cos_q_3;
    const double z_20 = m_3*l_3;
    const double z_21 = z_16*sin_q_2 + 3.0*z_5*z_20;
    const double z_22 = z_16 + 3.0*m_3*z_14;
    const double z_23 = cos_q_2*sin_q_2;
    const double z_24 = m_3*z_12;
    const double z_25 = cos_q_3*cos_q_3;
    dM[9] = ((-1.0/12.0))*(6.0*l_1*(z_2 + z_10) + ((cos_q_2*z_16 + 3.0*z_19*z_20)*sin_q_2 + cos_q_2*z_21) +
        3.0*((m_2*(2.0*l_1 + z_17) + 2.0*z_19*z_6 + 4.0*z_18*z_9)*z_1 + z_17*(z_2 + 2.0*z_10)) - 2.0*z_22*z_8*z_23
        - 12.0*z_24*z_25*z_23 - 2.0*(6.0*m_2*z_12 - m_2*(3.0*z_13 + l_2*l_2))*z_23);
    const double z_26 = z_22 - 6.0*z_24;
    const double z_27 = cos_q_3*sin_q_3;
    const double z_28 = sin_q_3*z_20;
    dM[12] = dM[10] = (1.0/12.0)*(cos_q_2*z_26*z_27 + 6.0*z_17*z_28);
    dM[15] = dM[11] = ((-1.0/12.0))*z_21;
    const double z_29 = sin_q_3*z_6;
    const double z_30 = z_18*z_29;
    const double z_31 = 4.0*z_30 - (m_3*z_19*sin_q_3 + 2.0*z_30);
    const double z_32 = z_18*z_28;
    dM[18] = (1.0/6.0)*(3.0*l_1*z_31 + 3.0*z_17*z_31 + (z_26)*(sin_q_2*sin_q_2)*z_27 - 3.0*cos_q_2*z_32);
    const double z_33 = sin_q_2*z_26;
    dM[21] = dM[19] = ((-1.0/12.0))*((z_8*z_33 - z_25*z_33) - 6.0*z_4*z_20);
    dM[22] = ((-1.0/12.0))*(6.0*l_2*z_28 + (z_22*z_27 + sin_q_3*(z_15*z_6 + 3.0*(2.0*l_2 + l_3*cos_q_3)*z_20)) -
        12.0*z_12*z_29);
    dM[24] = dM[20] = (-0.5)*z_32;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double q_2 = x[1];
    const double cos_q_2 = em_cos(q_2);
    const double q_2_dot = v[1];
    const double l_2 = c[4];
    const double z_1 = q_2_dot*l_2;
    const double q_1_dot = v[0];
    const double l_1 = c[3];
    const double z_2 = q_1_dot*l_1;
    const double z_3 = l_2*cos_q_2;
    const double z_4 = q_1_dot*z_3;
    const double z_5 = z_2 + z_4;
    const double m_3 = c[2];
    const double q_3 = x[2];
    const double sin_q_3 = em_sin(q_3);
    const double z_7 = sin_q_3*sin_q_3;
    const double z_8 = m_3*z_7;
    const double l_3 = c[5];
    const double q_3_dot = v[2];
    const double z_9 = q_1_dot*cos_q_2;
    const double z_10 = q_3_dot + z_9;
    const double cos_q_3 = em_cos(q_3);
    const double z_12 = l_3*z_10 + 2.0*cos_q_3*z_5;
    const double z_13 = m_3*cos_q_3;
    const double m_2 = c[1];
    const double z_14 = 2.0*(2.0*z_5*z_8 + z_12*z_13) + m_2*(2.0*z_2 + z_4);
    const double rho = c[6];
    const double z_15 = rho*rho;
    const double z_16 = z_15;
    const double z_17 = l_3*l_3;
    const double z_18 = 3.0*z_16 + z_17;
    const double z_19 = m_3*z_18;
    const double z_20 = m_3*l_3;
    const double z_21 = z_19*z_10 + 3.0*z_12*z_20;
    const double z_22 = q_3_dot*sin_q_3;
    const double z_23 = q_2_dot*z_22;
    const double sin_q_2 = em_sin(q_2);
    const double z_25 = q_1_dot*sin_q_2;
    const double z_26 = cos_q_3*z_25;
    const double z_27 = q_2_dot*cos_q_2;
    const double z_28 = q_1_dot*sin_q_3;
    const double z_29 = z_27*z_28;
    const double z_30 = z_23 - (q_3_dot*z_26 + z_29);
    const double z_31 = z_19 + 3.0*m_3*z_17;
    const double z_32 = sin_q_3*z_31;
    const double z_33 = q_2_dot*cos_q_3;
    const double z_34 = z_33 + sin_q_3*z_25;
    const double z_35 = z_19*z_34 + 3.0*(l_3*z_34 + 2.0*z_1)*z_20;
    const double z_36 = q_3_dot*z_35;
    const double z_37 = q_1_dot*cos_q_3;
    const double z_38 = q_3_dot*z_33 + (z_22*z_25 - z_27*z_37);
    const double z_39 = m_3*z_15;
    const double z_40 = cos_q_3*z_39;
    const double z_41 = q_2_dot*sin_q_3;
    const double z_42 = z_41 - z_26;
    const double z_43 = z_39*z_42;
    const double z_44 = m_2*(2.0*l_1 + z_3);
    const double z_45 = q_1_dot*z_1;
    const double z_46 = l_1 + z_3;
    const double z_47 = m_3*z_46;
    const double z_48 = z_7*z_47;
    const double z_49 = cos_q_2*z_20;
    const double z_50 = cos_q_3*z_47;
    const double z_51 = z_49 + 2.0*z_50;
    const double z_52 = z_1*z_51;
    const double z_53 = q_2_dot*l_3;
    const double z_54 = z_51*z_53;
    const double z_55 = z_40*z_27;
    const double z_56 = sin_q_2*z_39;
    const double z_57 = z_55 - z_22*z_56;
    const double z_58 = cos_q_3*sin_q_2;
    const double z_59 = sin_q_3*z_27;
    const double z_60 = q_3_dot*z_58 + z_59;
    const double z_61 = z_31*z_28;
    const double q_2_ddot = a[1];
    const double z_62 = l_2*z_20;
    const double z_63 = sin_q_3*z_62;
    const double z_64 = z_31 - 6.0*z_39;
    const double z_65 = sin_q_3*z_64;
    const double z_66 = cos_q_3*q_2_ddot;
    const double q_1_ddot = a[0];
    const double z_67 = cos_q_3*cos_q_3;
    const double z_68 = z_67*z_56;
    const double z_69 = sin_q_2*z_31;
    const double z_70 = z_7*z_69;
    const double z_71 = m_2*z_15;
    const double z_72 = sin_q_2*q_1_ddot;
    const double z_73 = m_2*(3.0*z_16 + l_2*l_2);
    const double z_74 = 6.0*z_71 - z_73;
    const double z_75 = z_19 - 2.0*z_74;
    const double z_76 = q_1_dot*z_27;
    const double z_77 = z_64;
    const double z_78 = q_2_dot*z_19;
    const double z_79 = z_5*z_22;
    const double z_80 = z_25*z_53 + 2.0*(z_79 + z_1*z_26);
    const double z_81 = cos_q_2*l_3 + 2.0*z_46*cos_q_3;
    const double z_82 = z_1*z_25;
    const double z_83 = m_3*z_12;
    const double z_84 = q_2_dot*z_40;
    const double z_85 = z_39*z_25;
    const double z_86 = z_67*z_85;
    const double z_87 = z_31*z_25;
    const double z_88 = z_87*z_7;
    const double z_89 = sin_q_2*z_1;
    const double z_90 = 2.0*z_22*z_47 + q_2_dot*sin_q_2*z_20 + 2.0*z_13*z_89;
    const double z_91 = sin_q_2*z_78 + 3.0*l_3*z_90;
    const double z_92 = m_2*z_89;
    const double z_93 = 2.0*z_89*z_8 + z_22*z_51 + cos_q_3*z_90 - 4.0*z_22*z_50;
    const double z_94 = z_92 + 2.0*z_93;
    const double z_95 = q_1_dot*l_2;
    const double z_96 = cos_q_2*z_73;
    const double q_3_ddot = a[2];
    const double z_97 = q_3_ddot + cos_q_2*q_1_ddot;
    const double z_98 = z_3*q_1_ddot;
    const double z_99 = l_1*q_1_ddot;
    const double z_100 = z_98 + z_99;
    const double z_101 = z_97*z_20 + 2.0*z_100*z_13;
    D[1] = ((-1.0/12.0))*(cos_q_2*(3.0*z_1*z_14 + q_2_dot*z_21 + z_30*z_32 + 6.0*z_38*z_40 + 3.0*z_44*z_45 +
        12.0*z_48*z_45 + 6.0*z_37*z_52 + 3.0*q_1_dot*z_54 + z_75*z_76 - cos_q_3*z_36 - 6.0*z_22*z_43 -
        6.0*z_57*z_37 - z_60*z_61 - 6.0*q_2_ddot*z_63 - z_65*z_66 - 12.0*q_1_ddot*z_68 - 2.0*q_1_ddot*z_70 -
        12.0*z_71*z_72 - z_26*z_77*z_22) - sin_q_2*((z_25*z_78 + 3.0*z_80*z_20) + 6.0*z_42*z_84 + q_1_dot*z_91 +
        3.0*z_94*z_95 - (cos_q_2*z_19 + 3.0*z_81*z_20)*q_1_ddot - 2.0*q_2_dot*z_74*z_25 -
        3.0*l_2*(2.0*(2.0*(2.0*z_79*z_13 - z_8*z_82) - (z_22*z_83 + z_80*z_13)) - m_2*z_82) - z_41*z_35 -
        6.0*q_2_dot*z_86 - q_2_dot*z_88 - 2.0*q_1_ddot*z_96 - 3.0*l_2*(z_44 + 2.0*z_81*z_13 + 4.0*z_48)*q_1_ddot -
        z_19*z_97 - 3.0*l_3*z_101 - 3.0*l_2*(2.0*(2.0*z_100*z_8 + cos_q_3*z_101) + m_2*(z_98 + 2.0*z_99))));
    const double z_102 = q_3_dot*z_56;
    const double z_103 = sin_q_3*z_47;
    const double z_104 = q_3_dot*z_5;
    const double z_105 = sin_q_2*sin_q_2;
    const double z_106 = q_1_dot*q_3_dot;
    const double z_107 = sin_q_3*z_5;
    const double z_108 = m_3*z_107;
    const double z_109 = sin_q_2*q_2_ddot;
    const double z_110 = z_64*z_58;
    const double z_111 = q_1_ddot*z_105;
    const double z_112 = z_22*z_105;
    const double z_113 = q_2_dot*z_31;
    D[2] = ((-1.0/12.0))*(cos_q_3*(z_30*z_69 + 6.0*q_3_dot*z_12*z_47 + 24.0*z_82*z_103 + 6.0*z_105*z_40*z_106 +
        z_23*z_69 + 6.0*z_51*z_104 + 24.0*z_89*z_108 + 6.0*q_2_dot*z_57 - z_35*z_27 - 6.0*z_42*z_102 -
        24.0*z_50*z_104 - z_59*z_87 - z_60*z_87 - 6.0*z_62*z_109 - q_2_ddot*z_110 - 2.0*z_32*z_111 -
        24.0*z_100*z_103) + sin_q_3*(sin_q_2*z_36 + 24.0*z_79*z_47 + 6.0*z_55*z_25 + q_1_dot*z_31*z_112 +
        6.0*z_57*z_25 + z_60*z_113 + z_65*z_109 + 12.0*z_40*z_111 + 6.0*m_3*z_81*z_100 + 6.0*z_46*z_101 -
        6.0*z_38*z_56 - 6.0*z_27*z_43 - 6.0*z_80*z_47 - 6.0*q_3_dot*sin_q_2*z_84 - 6.0*z_51*z_82 - 6.0*z_89*z_83 -
        6.0*z_5*z_90));
    const double z_114 = sin_q_3*z_69;
    const double z_115 = cos_q_3*z_77;
    D[3] = (1.0/12.0)*(z_27*z_70 + 6.0*z_27*z_68 + 6.0*z_57*z_58 + z_60*z_114 + z_115*z_112 - 3.0*z_44*z_89 -
        12.0*z_48*z_89 - 6.0*z_58*z_52 - 3.0*sin_q_2*z_54 - cos_q_2*z_91 - 3.0*z_3*z_94 - 6.0*l_1*(z_92 + z_93) -
        sin_q_2*z_75*z_27);
    const double z_116 = l_2*z_25;
    const double z_117 = cos_q_3*z_31;
    const double z_118 = cos_q_2*z_25;
    const double z_119 = sin_q_3*z_35;
    const double z_120 = z_42*z_40;
    const double z_121 = (l_2*sin_q_2*z_14 + (1.0/3.0)*sin_q_2*z_21) - (1.0/3.0)*(cos_q_2*z_119 -
        6.0*cos_q_2*z_120);
    D[4] = ((-1.0/12.0))*(3.0*z_44*z_116 + 12.0*z_48*z_116 + 6.0*q_3_dot*z_68 + q_3_dot*z_70 +
        6.0*cos_q_3*z_51*z_116 + 3.0*l_3*z_51*z_25 + 6.0*sin_q_3*z_57 + z_75*z_118 + 3.0*z_121 - 6.0*cos_q_2*z_86
        - cos_q_2*z_88 - 6.0*z_62*z_60 - z_60*z_117);
    const double z_122 = z_35*z_58;
    const double z_123 = sin_q_3*z_42;
    D[5] = (1.0/12.0)*(z_122 + 6.0*z_56*z_123 + 24.0*z_50*z_107 + z_105*z_28*z_115 - 6.0*z_12*z_103 -
        6.0*q_2_dot*z_68 - q_2_dot*z_70 - 6.0*z_51*z_107 - z_91);
    const double z_124 = q_1_dot*q_1_dot;
    const double z_125 = 6.0*z_62 + z_117;
    const double z_126 = q_3_dot*z_125;
    const double z_127 = q_3_dot*z_40 + z_9*z_40;
    const double z_128 = cos_q_2*z_28;
    const double z_129 = z_22 + z_128;
    const double z_130 = cos_q_3*q_1_ddot;
    const double g = c[7];
    const double z_131 = sin_q_2*z_124;
    const double z_132 = g*z_20;
    const double z_133 = l_2*m_3;
    const double z_134 = z_25*z_20 + 2.0*z_13*z_116;
    const double z_135 = z_19*z_25 + 3.0*l_3*z_134;
    const double z_136 = m_2*z_116;
    const double z_137 = 2.0*z_116*z_8 + cos_q_3*z_134;
    const double z_138 = z_136 + 2.0*z_137;
    D[7] = (1.0/12.0)*(cos_q_2*((z_124*z_96 + q_1_dot*z_21 + 3.0*z_14*z_95) + 6.0*z_39*z_7*z_106 + z_37*z_126 +
        6.0*q_1_ddot*z_63 + z_65*z_130 - 6.0*cos_q_2*z_71*z_124 - 6.0*z_127*z_37 - z_129*z_61) +
        sin_q_2*((6.0*m_2*l_2*g + 6.0*z_71*z_131 + z_35*z_28 + 6.0*cos_q_3*z_132 + 12.0*g*z_133 -
        6.0*q_1_dot*z_120) + 6.0*z_84*z_28 - q_2_dot*z_125*z_28 - z_73*z_131 - q_1_dot*z_135 - 3.0*z_138*z_95));
    const double z_139 = z_18*z_13;
    D[8] = ((-1.0/12.0))*(cos_q_3*(z_36 + q_2_dot*z_126 + z_9*z_35 + z_129*z_87 - 6.0*z_39*z_38 - 6.0*z_22*z_85 -
        z_125*z_76 - 24.0*z_116*z_108 - 6.0*q_2_dot*z_127 - 12.0*sin_q_3*z_39*q_2_ddot - 6.0*z_62*z_72 -
        q_1_ddot*z_110) - sin_q_3*(z_31*z_30 + 6.0*z_39*z_29 + 6.0*cos_q_2*z_132 + 6.0*z_127*z_25 + z_129*z_113 -
        6.0*q_3_dot*z_43 - 6.0*z_39*z_23 - z_25*z_126 - 6.0*z_116*z_83 - 6.0*z_9*z_43 - 6.0*z_5*z_134 - (z_139 +
        3.0*(2.0*l_2 + l_3*cos_q_3)*z_20)*q_2_ddot - 3.0*l_3*(2.0*q_2_ddot*z_133 + z_20*z_66) - z_139*q_2_ddot -
        z_65*z_72));
    D[9] = ((-1.0/12.0))*(2.0*z_74*z_118 + 6.0*z_59*z_40 + 6.0*z_127*z_58 + z_129*z_114 - 6.0*z_7*z_102 -
        z_59*z_125 - z_58*z_126 - cos_q_2*z_135 - 3.0*z_3*z_138 - 6.0*l_1*(z_136 + z_137) - 3.0*z_121);
    D[10] = (1.0/12.0)*(6.0*z_22*z_40 + z_128*z_125 + 6.0*sin_q_3*z_127 - 6.0*z_128*z_40 - z_22*z_125 -
        6.0*z_62*z_129 - z_117*z_129);
    D[11] = (1.0/12.0)*(6.0*z_120 + 6.0*z_7*z_85 + 6.0*sin_q_3*z_84 + z_26*z_125 + z_135 - z_119 - z_41*z_125);
    const double z_140 = z_1*z_20;
    const double z_141 = z_84 + sin_q_3*z_85;
    const double z_142 = sin_q_3*z_83 - 2.0*z_13*z_107 - z_22*z_20;
    D[13] = ((-1.0/12.0))*(cos_q_2*(6.0*z_37*z_140 + z_35*z_37 + q_1_dot*z_113 - 6.0*sin_q_3*z_132 -
        6.0*z_141*z_37 - z_42*z_77*z_28) + sin_q_2*(6.0*z_5*z_20*z_28 + 6.0*z_142*z_95 + 6.0*z_62*z_130 +
        z_31*q_1_ddot));
    const double z_143 = z_5*z_5;
    const double z_144 = m_3*sin_q_3*z_143;
    D[14] = ((-1.0/12.0))*(cos_q_3*((6.0*z_25*z_43 - q_2_dot*z_35 - 6.0*z_5*z_83 - 6.0*sin_q_2*z_132) +
        6.0*z_20*z_104 + 12.0*z_143*z_13 + 6.0*q_2_dot*z_141 - z_42*z_87) + sin_q_3*(12.0*z_144 + 6.0*z_141*z_25 +
        z_42*z_113 + 6.0*z_46*q_1_ddot*z_20 - (6.0*q_2_dot*z_43 + 12.0*z_144 + z_35*z_25) - 6.0*z_20*z_82));
    D[15] = ((-1.0/12.0))*(z_122 + q_2_dot*z_69 + 6.0*z_58*z_140 - 6.0*z_141*z_58 - 6.0*z_49*z_107 - 6.0*z_3*z_142
        - 6.0*l_1*z_142 - sin_q_2*z_77*z_123);
    D[16] = (1.0/12.0)*(z_119 + 6.0*z_62*z_42 + z_42*z_115 - 6.0*z_62*z_26 - 6.0*sin_q_3*z_141 - z_87);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double q_1_ddot = a[0];
    const double l_1 = c[3];
    const double z_0 = l_1*l_1;
    const double rho = c[6];
    const double z_1 = rho*rho;
    const double z_2 = z_1;
    D[0] = (1.0/12.0)*(q_1_ddot*(3.0*z_0 + (z_0 + 3.0*z_2)));
    const double l_2 = c[4];
    const double z_3 = l_2*l_2;
    const double z_4 = z_3;
    const double z_5 = 3.0*z_2 + z_4;
    const double q_2 = x[1];
    const double cos_q_2 = em_cos(q_2);
    const double q_2_dot = v[1];
    const double q_1_dot = v[0];
    const double sin_q_2 = em_sin(q_2);
    const double z_8 = q_1_dot*sin_q_2;
    const double z_9 = q_2_dot*z_8;
    const double z_10 = cos_q_2*z_9;
    const double z_11 = q_1_dot*l_1;
    const double z_12 = l_2*cos_q_2;
    const double z_13 = q_1_dot*z_12;
    const double z_14 = 2.0*z_11 + z_13;
    const double z_15 = q_2_dot*sin_q_2;
    const double z_16 = l_2*z_15;
    const double z_17 = l_2*z_9;
    const double z_18 = cos_q_2*cos_q_2;
    const double z_19 = sin_q_2*sin_q_2;
    const double z_20 = z_1*z_19;
    const double z_21 = 2.0*l_1 + z_12;
    D[1] = (1.0/12.0)*((2.0*(6.0*z_2 - z_5)*z_10 - 3.0*(z_14*z_16 + z_3*z_10) - 6.0*l_1*z_17) + q_1_ddot*(z_5*z_18
        + 6.0*z_20 + 6.0*l_1*z_21 + 3.0*z_12*z_21));
    const double q_3 = x[2];
    const double cos_q_3 = em_cos(q_3);
    const double q_3_dot = v[2];
    const double z_23 = q_3_dot*cos_q_3;
    const double sin_q_3 = em_sin(q_3);
    const double z_25 = q_3_dot*sin_q_3;
    const double z_26 = q_1_dot*cos_q_2;
    const double z_27 = q_2_dot*cos_q_3;
    const double z_28 = q_2_dot*z_23 + (z_8*z_25 - z_26*z_27);
    const double z_29 = sin_q_2*z_28;
    const double z_30 = q_2_dot*sin_q_3;
    const double z_31 = cos_q_3*z_8;
    const double z_32 = z_30 - z_31;
    const double z_33 = z_32*z_1;
    const double z_34 = sin_q_2*z_25;
    const double l_3 = c[5];
    const double z_35 = z_27 + sin_q_3*z_8;
    const double z_36 = l_3*z_35 + 2.0*q_2_dot*l_2;
    const double z_37 = l_3*l_3;
    const double z_38 = 3.0*z_2 + z_37;
    const double z_39 = 3.0*l_3*z_36 + z_38*z_35;
    const double z_40 = sin_q_2*z_23;
    const double z_41 = cos_q_2*z_30;
    const double z_42 = sin_q_3*sin_q_2;
    const double z_43 = q_2_dot*z_25;
    const double z_44 = z_43 - (z_8*z_23 + z_26*z_30);
    const double z_45 = z_37 + (1.0/3.0)*z_38;
    const double z_46 = 3.0*z_45;
    const double z_47 = z_44*z_46;
    const double z_48 = q_3_dot + z_26;
    const double z_49 = z_11 + z_13;
    const double z_50 = cos_q_3*z_49;
    const double z_51 = l_3*z_48 + 2.0*z_50;
    const double z_52 = 3.0*l_3*z_51 + z_38*z_48;
    const double z_53 = l_3*z_9 + 2.0*(z_49*z_25 + cos_q_3*z_17);
    const double z_54 = 3.0*l_3*z_53 + z_38*z_9;
    const double z_55 = sin_q_3*sin_q_3;
    const double z_56 = 2.0*z_49*z_55 + cos_q_3*z_51;
    const double z_57 = (z_51*z_25 + cos_q_3*z_53) - 2.0*(2.0*z_50*z_25 - z_55*z_17);
    const double z_58 = cos_q_3*cos_q_3;
    const double z_59 = l_1 + z_12;
    const double z_60 = cos_q_2*l_3 + 2.0*z_59*cos_q_3;
    const double z_61 = cos_q_3*z_60 + 2.0*z_59*z_55;
    const double z_62 = 3.0*l_3*z_60 + cos_q_2*z_38;
    const double z_63 = z_19*z_55;
    const double q_2_ddot = a[1];
    const double z_64 = l_2*l_3;
    const double z_65 = 6.0*z_42*z_64 - cos_q_3*(6.0*z_2 - 3.0*z_45)*z_42;
    const double q_3_ddot = a[2];
    D[2] = ((-1.0/12.0))*((6.0*(cos_q_3*z_1*z_29 + cos_q_2*z_27*z_33 - z_33*z_34) + (z_52*z_15 + cos_q_2*z_54) +
        6.0*(z_56*z_16 + z_12*z_57) + 6.0*l_1*z_57 - (z_39*z_40 + z_39*z_41 - z_42*z_47)) -
        (q_1_ddot*(6.0*z_20*z_58 + 6.0*l_1*z_61 + cos_q_2*z_62 + 6.0*z_12*z_61 + z_46*z_63) + q_2_ddot*z_65 +
        q_3_ddot*z_62));
    const double m_3 = c[2];
    const double z_66 = m_3*cos_q_3;
    const double z_67 = z_49*z_66;
    const double z_68 = m_3*z_55;
    const double z_69 = m_3*z_51;
    const double z_70 = 2.0*(2.0*z_25*z_67 - z_17*z_68) - (z_69*z_25 + z_53*z_66);
    const double m_2 = c[1];
    const double z_71 = m_2*z_17;
    const double z_72 = l_3*z_66;
    const double z_73 = z_26*z_25;
    const double z_74 = m_3*l_3;
    const double z_75 = m_2 + 2.0*m_3;
    const double m_1 = c[0];
    const double z_76 = cos_q_2*z_72;
    const double z_77 = m_2*z_21;
    const double z_78 = z_60*z_66 + 2.0*z_59*z_68;
    D[3] = (1.0/6.0)*(3.0*((z_70 - z_71) - (z_72*z_9 + z_73*z_74) - z_75*z_17) + (q_1_ddot*(4.0*l_1*m_1 + 3.0*z_76
        + 3.0*((z_77 + z_78) + 2.0*l_1*(m_2 + m_3)) + 3.0*z_12*z_75) + 3.0*q_3_ddot*z_72));
    const double z_79 = cos_q_2*z_74;
    const double z_80 = q_2_dot*q_2_dot;
    const double z_81 = cos_q_3*z_9 + z_73;
    const double z_82 = 2.0*(2.0*z_49*z_68 + z_51*z_66) + m_2*z_14;
    const double z_83 = m_2 + 4.0*m_3;
    const double z_84 = z_12*z_83;
    const double z_85 = m_2*z_9;
    const double z_86 = z_73*z_66;
    const double z_87 = (z_9*z_68 - 2.0*z_86) + (z_86 + z_81*z_66);
    const double z_88 = m_2*z_12;
    const double z_89 = z_74*z_42;
    const double z_90 = l_1*cos_q_2;
    const double z_91 = m_2*l_2;
    D[4] = (1.0/12.0)*((6.0*(q_3_dot*z_72*z_15 + sin_q_3*z_79*z_80) - 6.0*(z_76*z_9 + z_79*z_81) - 3.0*((z_82*z_15
        + z_9*z_84) - (cos_q_2*(2.0*z_70 - z_71) - z_12*(z_85 + 4.0*z_87))) - 6.0*l_1*(z_85 + 2.0*z_87) -
        4.0*z_9*z_88) + (6.0*q_2_ddot*z_89 + q_1_ddot*(6.0*z_75*z_90 + 6.0*z_72*z_18 + 3.0*(cos_q_2*(z_77 +
        2.0*z_78) + l_2*z_83*z_18) + 2.0*z_91*z_18) + 6.0*q_3_ddot*z_76));
    const double z_92 = z_35*z_74;
    const double z_93 = 2.0*z_92 + 3.0*(m_3*z_36 + z_92);
    const double z_94 = z_48*z_74;
    const double z_95 = 2.0*z_94 + 3.0*(z_69 + z_94);
    const double z_96 = z_9*z_74;
    const double z_97 = 2.0*z_96 + 3.0*(m_3*z_53 + z_96);
    const double z_98 = l_2*z_66;
    const double z_99 = z_48*z_15;
    const double z_100 = m_3*z_48;
    const double z_101 = z_25*z_100 + z_66*z_9;
    const double z_102 = 2.0*z_79 + 3.0*(m_3*z_60 + z_79);
    const double z_103 = l_2*m_3;
    const double z_104 = 3.0*z_103*z_42 + 4.0*z_72*z_42;
    D[5] = (1.0/12.0)*(((z_93*z_40 + z_93*z_41 - 8.0*z_44*z_89) - (z_95*z_15 + cos_q_2*z_97) - 6.0*(z_98*z_99 +
        z_12*z_101) - 6.0*l_1*z_101) + (q_1_ddot*(6.0*z_66*z_90 + cos_q_2*z_102 + 6.0*z_98*z_18 + 8.0*z_74*z_63) +
        2.0*q_2_ddot*z_104 + q_3_ddot*z_102));
    const double z_105 = m_2*rho;
    const double z_106 = rho*z_66;
    const double z_107 = z_32*z_106;
    const double z_108 = m_3*rho;
    const double z_109 = z_32*z_108;
    const double z_110 = z_35*z_108;
    const double z_111 = z_42*z_106;
    const double z_112 = z_108*z_58;
    const double z_113 = cos_q_2*z_108;
    D[6] = 0.5*((2.0*z_105*z_10 + (q_3_dot*sin_q_2*z_35*z_106 + z_110*z_41 - z_44*z_108*z_42) - 2.0*(z_106*z_29 +
        q_2_dot*cos_q_2*z_107 - z_109*z_34) - (z_108*z_99 + z_108*z_10)) - (q_2_ddot*z_111 -
        q_1_ddot*(2.0*z_112*z_19 + 2.0*z_105*z_19 + m_1*rho + z_108*z_63 + (z_108 + z_105)*z_18) -
        q_3_ddot*z_113));
    const double g = c[7];
    const double z_114 = l_2*g;
    const double z_115 = q_1_dot*q_1_dot;
    const double z_116 = sin_q_2*z_115;
    const double z_117 = cos_q_2*z_115;
    const double z_118 = q_1_dot*l_2;
    D[10] = (1.0/12.0)*(q_2_ddot*(3.0*z_4 + z_5) - (6.0*cos_q_2*(z_114 + z_1*z_116) - sin_q_2*(z_5*z_117 +
        3.0*z_14*z_118)));
    const double z_119 = l_3*cos_q_3;
    const double z_120 = q_1_dot*sin_q_3;
    const double z_121 = sin_q_3*z_28;
    const double z_122 = 2.0*l_2 + z_119;
    D[11] = ((-1.0/12.0))*(((cos_q_2*(12.0*z_114 + 6.0*z_119*g + z_39*z_120 - 6.0*q_1_dot*cos_q_3*z_33) -
        sin_q_2*(q_1_dot*z_52 + 6.0*z_56*z_118)) + (6.0*z_44*z_64 + (z_39*z_25 + cos_q_3*z_47) - 6.0*(z_1*z_121 +
        z_33*z_23))) - (q_1_ddot*z_65 + q_2_ddot*(6.0*z_1*z_55 + 6.0*l_2*z_122 + cos_q_3*(3.0*l_3*z_122 +
        cos_q_3*z_38))));
    D[12] = 0.5*(sin_q_2*(z_72*z_115 + l_2*z_75*z_115));
    const double z_123 = m_3*g;
    const double z_124 = q_1_dot*z_74;
    const double z_125 = m_3*z_122;
    D[13] = ((-1.0/12.0))*(((6.0*cos_q_2*(2.0*z_123 + m_2*g + z_30*z_124) - sin_q_2*(2.0*z_115*z_88 +
        6.0*z_76*z_115 + 3.0*(q_1_dot*z_82 + z_115*z_84))) + 6.0*(z_44*z_74 + z_43*z_74)) - 2.0*(3.0*q_1_ddot*z_89
        + q_2_ddot*(4.0*z_91 + 3.0*z_72 + 3.0*(2.0*z_103 + z_125))));
    const double z_126 = q_1_dot*z_48;
    D[14] = ((-1.0/12.0))*(((cos_q_2*(6.0*g*z_66 + z_93*z_120) - sin_q_2*(q_1_dot*z_95 + 6.0*z_98*z_126)) +
        (6.0*z_103*z_44 + (z_93*z_25 + 8.0*z_44*z_72))) - (2.0*q_1_ddot*z_104 + q_2_ddot*(6.0*z_98 +
        cos_q_3*(2.0*z_72 + 3.0*(z_72 + z_125)))));
    D[15] = 0.5*(((cos_q_2*(2.0*q_1_dot*z_107 - 2.0*z_105*z_116 - z_110*z_120) + sin_q_2*(z_105*z_117 +
        z_108*z_126)) + (2.0*(z_108*z_121 + q_3_dot*z_107) - (z_25*z_110 + z_44*z_106))) - (q_1_ddot*z_111 -
        q_2_ddot*(z_105 + 2.0*z_108*z_55 + z_112)));
    D[16] = (-0.5)*(cos_q_2*(2.0*z_103 + z_91 + z_72));
    D[20] = ((-1.0/12.0))*((z_54 + (cos_q_3*(12.0*sin_q_3*(z_49*z_49) + 6.0*q_2_dot*z_33 + z_39*z_8) -
        sin_q_3*(6.0*z_49*z_51 + 6.0*l_3*sin_q_2*g + q_2_dot*z_39 - 6.0*z_8*z_33))) - (q_3_ddot*z_46 +
        q_1_ddot*z_62));
    D[21] = 0.5*(q_1_ddot*z_72 - (z_25*z_124 + (4.0*z_120*z_67 - sin_q_3*(q_1_dot*z_69 + 2.0*q_1_dot*z_67))));
    D[22] = 0.5*(q_1_ddot*z_76 - (z_81*z_74 + (cos_q_3*(z_96 + 4.0*m_3*sin_q_3*z_26*z_49) - sin_q_3*(z_80*z_74 +
        (z_26*z_69 + 2.0*z_26*z_67)))));
    D[23] = ((-1.0/12.0))*((z_97 + (z_31*z_93 - sin_q_3*(6.0*sin_q_2*z_123 + q_2_dot*z_93 + 6.0*z_49*z_100))) -
        (8.0*q_3_ddot*z_74 + q_1_ddot*z_102));
    D[24] = (-0.5)*((z_108*z_9 + (cos_q_3*(2.0*q_2_dot*z_109 + z_8*z_110) + sin_q_3*(2.0*z_8*z_109 -
        q_2_dot*z_110))) - (q_1_ddot*z_113 + q_3_ddot*z_108));
    D[25] = 0.5*z_89;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes spatial_arm_3_lanes;
EM_WEAK em_lanes spatial_arm_3_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

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
    const double m_3 = parameters[2];
    const double rho = parameters[6];
    const double z_0 = rho*rho;
    const double z_1 = z_0;
    const double l_3 = parameters[5];
    const double z_2 = l_3*l_3;
    const double z_3 = m_3*(3.0*z_1 + z_2);
    prepared[8] = z_3; /* c_0 */
    const double z_4 = m_3*l_3;
    prepared[9] = 3.0*z_4; /* c_1 */
    const double m_2 = parameters[1];
    const double l_2 = parameters[4];
    const double z_5 = l_2*l_2;
    const double z_6 = m_2*(3.0*z_1 + z_5);
    prepared[10] = z_6; /* c_2 */
    const double z_7 = z_3 + 3.0*m_3*z_2;
    prepared[11] = z_7; /* c_3 */
    const double m_1 = parameters[0];
    const double l_1 = parameters[3];
    const double z_8 = l_1*l_1;
    prepared[12] = 3.0*m_1*z_8 + m_1*(z_8 + 3.0*z_1); /* c_4 */
    prepared[13] = 2.0*l_1; /* c_5 */
    prepared[14] = 2.0*m_3; /* c_6 */
    prepared[15] = 6.0*l_1; /* c_7 */
    const double z_9 = m_2*z_0;
    prepared[16] = 6.0*z_9; /* c_8 */
    prepared[17] = 4.0*m_3; /* c_9 */
    prepared[18] = 3.0*l_2; /* c_10 */
    const double z_10 = m_3*z_0;
    prepared[19] = 6.0*z_10; /* c_11 */
    prepared[20] = z_7 - 6.0*z_10; /* c_12 */
    const double z_11 = l_2*m_3;
    const double z_12 = l_3*z_11;
    prepared[21] = 6.0*z_12; /* c_13 */
    prepared[22] = 2.0*l_2; /* c_14 */
    prepared[23] = z_6 + 3.0*m_2*z_5; /* c_15 */
    prepared[24] = 6.0*z_11; /* c_16 */
    prepared[25] = (1.0/12.0)*z_7; /* c_17 */
    const double z_13 = m_2*l_2;
    prepared[26] = z_13; /* c_18 */
    prepared[27] = z_11; /* c_19 */
    prepared[28] = z_10; /* c_20 */
    prepared[29] = 2.0*(6.0*z_9 - z_6); /* c_21 */
    prepared[30] = z_12; /* c_22 */
    prepared[31] = 12.0*z_10; /* c_23 */
    const double g = parameters[7];
    const double z_14 = g*z_13;
    prepared[32] = 6.0*(z_14 + 2.0*z_11*g); /* c_24 */
    prepared[33] = 6.0*(z_4*g); /* c_25 */
    prepared[34] = 12.0*m_3; /* c_26 */
    prepared[35] = 6.0*m_3; /* c_27 */
    prepared[36] = m_3*g; /* c_28 */
    prepared[37] = z_14; /* c_29 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {62, "nonnegative"},
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
    const double q_2 = x[1];
    const double cos_q_2 = em_cos(q_2);
    const double c_0 = c[8];
    const double l_3 = c[5];
    const double l_1 = c[3];
    const double l_2 = c[4];
    const double z_1 = l_2*cos_q_2;
    const double z_2 = l_1 + z_1;
    const double q_3 = x[2];
    const double cos_q_3 = em_cos(q_3);
    const double z_4 = cos_q_2*l_3 + 2.0*z_2*cos_q_3;
    const double c_1 = c[9];
    const double z_5 = cos_q_2*c_0 + z_4*c_1;
    const double c_2 = c[10];
    const double c_3 = c[11];
    const double sin_q_3 = em_sin(q_3);
    const double z_7 = sin_q_3*sin_q_3;
    const double sin_q_2 = em_sin(q_2);
    const double z_9 = sin_q_2*sin_q_2;
    const double c_4 = c[12];
    const double m_2 = c[1];
    const double c_5 = c[13];
    const double z_10 = m_2*(c_5 + z_1);
    const double m_3 = c[2];
    const double z_11 = cos_q_3*z_4;
    const double c_6 = c[14];
    const double z_12 = z_2*z_7;
    const double c_7 = c[15];
    const double c_8 = c[16];
    const double c_9 = c[17];
    const double c_10 = c[18];
    const double c_11 = c[19];
    M[0] = (1.0/12.0)*(cos_q_2*z_5 + c_2*(cos_q_2*cos_q_2) + c_3*z_7*z_9 + c_4 + (z_10 + m_3*z_11 + c_6*z_12)*c_7
        + c_8*z_9 + cos_q_2*(z_10 + c_6*z_11 + c_9*z_12)*c_10 + c_11*(z_9*(cos_q_3*cos_q_3)));
    const double c_12 = c[20];
    const double z_13 = sin_q_3*sin_q_2;
    const double c_13 = c[21];
    M[3] = M[1] = (1.0/12.0)*(cos_q_3*c_12*z_13 + c_13*z_13);
    const double c_14 = c[22];
    const double z_14 = c_14 + l_3*cos_q_3;
    const double c_15 = c[23];
    const double c_16 = c[24];
    M[4] = (1.0/12.0)*(cos_q_3*(cos_q_3*c_0 + z_14*c_1) + c_15 + z_14*c_16 + c_11*z_7);
    M[6] = M[2] = (1.0/12.0)*z_5;
    M[7] = M[5] = 0.0;
    const double c_17 = c[25];
    M[8] = c_17;
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
    real M1[N1][N1], shared[12];
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

#include "spatial_arm_3.h"

static const char *const coordinate_names[] = { "q_1", "q_2", "q_3", NULL };
static const char *const parameter_names[] = { "m_1", "m_2", "m_3", "l_1", "l_2", "l_3", "rho", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 1.0, 0.6, 0.6, 0.6, 0.05, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.5, 0.7, 0.9 };
static const double initial_v[N] = { 1.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 3},
    {"line", 3, 6},
    {"disk", 9, 4},
    {"line", 13, 6},
    {"disk", 19, 4},
    {"line", 23, 6},
    {"disk", 29, 4},
    {"trace", 33, 3}
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
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dq_1: M does not depend on it",
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
static int simulate(em_run *run) { return em_simulate(&spatial_arm_3_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&spatial_arm_3_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&spatial_arm_3_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&spatial_arm_3_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&spatial_arm_3_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&spatial_arm_3_model, run, mode); }

const em_model spatial_arm_3_model = {
    .abi = EM_ABI,
    .name = "spatial_arm_3",
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
    .n_left_out = 6,
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
    .lanes = &spatial_arm_3_lanes,
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
    .n_shapes = 8,
    .dimension = 3,
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
