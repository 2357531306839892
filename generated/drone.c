/* eigenmotion generate drone.py */
/* input sha256:4f11df1f7d176811d0bb3694586688568505c1f4ec024bed8c913586a1914019 */
/* body sha256:f51bd899d73cc06a082ccb1dedde8004cf5892582705bf78cb8b3448226381c9 */
/* drone: equations of motion, eigenfactor formulation.
 *
 * State, 58 numbers:
 *   x    y[0 .. 8)
 *   eta  y[8 .. 16)
 *   C    y[16 .. 50)
 *   s    y[50 .. 58)
 *
 * Blocks of M that do not couple:
 *   1: x, y, z, sway, heave (C and s are states)
 *   2: yaw, pitch, roll (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dx, dM/dy, dM/dz, dM/dyaw: M does not depend on them
 *   C, mu, Omega across blocks: {x, y, z, sway, heave}, {yaw, pitch, roll} do not couple
 *
 * Operations of the straight-line part:
 *   eigenfactor: 41 additions, 106 multiplications, 10 function calls
 *   triangular root: 44 additions, 122 multiplications, 10 function calls
 *   projection: 13 additions, 60 multiplications, 8 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 8,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 58,         /* numbers of a state */
    N_C = 34,             /* of which C, */
    N_S = 8,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 4,
    N_EVENTS = 0,
    N_MEMORY = 42,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 8,
    N_PREPARED = 20,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 1,
    N_GIVEN = 13,         /* inputs, parameters and the time */
    N_ARGUMENTS = 29,     /* x, v and these: what motion depends on */
    N1 = 5,               /* x, y, z, sway, heave */
    N2 = 3,               /* yaw, pitch, roll */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 6, 7 };
EM_UNUSED static const int coordinate2[N2] = { 3, 4, 5 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  const real *restrict u, real Mdot1[N1][N1], real Mdot2[N2][N2], real f1[N1],
                                  real f2[N2])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    Mdot1[0][2] = Mdot1[2][0] = em_real(0.0);
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
    const real c_1 = c[9];
    const real sway = x[6];
    const real cos_sway = em_cos(sway);
    const real heave_dot = v[7];
    const real heave = x[7];
    const real sin_heave = em_sin(heave);
    const real z_2 = heave_dot*sin_heave;
    const real sin_sway = em_sin(sway);
    const real sway_dot = v[6];
    const real cos_heave = em_cos(heave);
    const real z_5 = sway_dot*cos_heave;
    Mdot1[0][3] = Mdot1[3][0] = -c_1*(cos_sway*z_2 + sin_sway*z_5);
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    Mdot1[2][3] = Mdot1[3][2] = c_1*(cos_sway*z_5 - sin_sway*z_2);
    const real c_4 = c[12];
    Mdot1[3][3] = -cos_heave*c_4*z_2;
    const real z_6 = heave_dot*cos_heave;
    const real z_7 = sway_dot*sin_heave;
    Mdot1[0][4] = Mdot1[4][0] = -c_1*(sin_sway*z_6 + cos_sway*z_7);
    const real z_8 = c_1*z_2;
    Mdot1[1][4] = Mdot1[4][1] = -z_8;
    Mdot1[2][4] = Mdot1[4][2] = -c_1*(sin_sway*z_7 - cos_sway*z_6);
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    const real pitch_dot = v[4];
    const real pitch = x[4];
    const real sin_pitch = em_sin(pitch);
    const real z_10 = pitch_dot*sin_pitch;
    const real J = c[2];
    const real cos_pitch = em_cos(pitch);
    const real z_12 = J*cos_pitch;
    const real roll = x[5];
    const real sin_roll = em_sin(roll);
    const real z_14 = cos_pitch*(sin_roll*sin_roll);
    const real z_15 = cos_pitch*cos_pitch;
    const real roll_dot = v[5];
    const real cos_roll = em_cos(roll);
    const real z_17 = sin_roll*cos_roll;
    const real z_18 = roll_dot*z_17;
    const real z_19 = z_15*z_18;
    const real J_up = c[3];
    const real z_20 = cos_pitch*(cos_roll*cos_roll);
    Mdot2[0][0] = 2.0*(z_10*z_12 - J*(z_14*z_10 - z_19) - J_up*(z_19 + z_20*z_10));
    const real c_3 = c[11];
    Mdot2[0][1] = Mdot2[1][0] = -c_3*(z_17*z_10 + roll_dot*z_14 - roll_dot*z_20);
    const real c_5 = c[13];
    Mdot2[1][1] = -c_5*z_18;
    Mdot2[0][2] = Mdot2[2][0] = -pitch_dot*z_12;
    Mdot2[1][2] = Mdot2[2][1] = em_real(0.0);
    Mdot2[2][2] = em_real(0.0);
    const real yaw = x[3];
    const real sin_yaw = em_sin(yaw);
    const real cos_yaw = em_cos(yaw);
    const real z_23 = sin_pitch*cos_roll;
    const real f1_ = u[0];
    const real f3 = u[2];
    const real z_24 = f1_ + f3;
    const real f2_ = u[1];
    const real f4 = u[3];
    const real z_25 = f2_ + f4;
    const real z_26 = z_24 + z_25;
    f1[0] = (sin_roll*sin_yaw + cos_yaw*z_23)*z_26;
    f1[1] = -z_26*(sin_roll*cos_yaw - sin_yaw*z_23);
    const real z_27 = cos_pitch*cos_roll;
    const real c_6 = c[14];
    f1[2] = z_26*z_27 - c_6;
    const real x_dot = v[0];
    const real z_dot = v[2];
    const real c_7 = c[15];
    f1[3] = -(c_1*(sin_sway*(x_dot*z_5) + cos_sway*(x_dot*z_2) + sin_sway*(z_dot*z_2) - cos_sway*(z_dot*z_5)) +
        cos_heave*sin_sway*c_7);
    const real z_28 = cos_sway*c_1;
    const real z_29 = sin_sway*c_1;
    const real c_2 = c[10];
    const real y_dot = v[1];
    f1[4] = -((x_dot*(z_28*z_7) + z_dot*(z_29*z_7) + sin_heave*(sway_dot*sway_dot)*(cos_heave*c_2) +
        x_dot*(z_29*z_6) + y_dot*z_8 - z_dot*(z_28*z_6)) + cos_sway*sin_heave*c_7);
    const real a_ = c[4];
    const real z_30 = a_*(f2_ - f4);
    const real drag = c[5];
    const real z_31 = drag*(z_24 - z_25);
    const real z_32 = a_*(f1_ - f3);
    f2[0] = -(sin_pitch*z_30 + cos_pitch*sin_roll*z_32 - z_27*z_31);
    const real yaw_dot = v[3];
    const real z_33 = yaw_dot*yaw_dot;
    const real z_34 = c_3*z_17;
    f2[1] = -((sin_roll*z_31 + cos_roll*z_32) - ((sin_pitch*z_12 - sin_pitch*(J*z_14) -
        sin_pitch*(J_up*z_20))*z_33 - yaw_dot*(z_10*z_34) - yaw_dot*roll_dot*z_12));
    f2[2] = z_30 + (z_15*z_33*z_34 + yaw_dot*pitch_dot*(c_3*(z_20 - z_14)) - pitch_dot*pitch_dot*z_34);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x, y, z, sway, heave: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[8], y[9], y[10], y[14], y[15] };
    const real *const C1 = y + 16, *const s1 = y + 50;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[6] = v1[3];
    dy[7] = v1[4];

    /* yaw, pitch, roll: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[11], y[12], y[13] };
    const real *const C2 = y + 41, *const s2 = y + 55;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[3] = v2[0];
    dy[4] = v2[1];
    dy[5] = v2[2];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x, y, z, sway, heave: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[8], y[9], y[10], y[14], y[15] };
    const real *const C1 = y + 16, *const s1 = y + 50;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[6] = v1[3];
    dy[7] = v1[4];

    /* yaw, pitch, roll: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[11], y[12], y[13] };
    const real *const C2 = y + 41, *const s2 = y + 55;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[3] = v2[0];
    dy[4] = v2[1];
    dy[5] = v2[2];

    real Mdot1[N1][N1], Mdot2[N2][N2], f1[N1], f2[N2];
    eigenfactor_motion(y, dy, c, u, Mdot1, Mdot2, f1, f2);

    /* x, y, z, sway, heave: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 16, *const s1_dot = dy + 50;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

    /* yaw, pitch, roll: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T2[N2*N2], mu2[N2*N2], Omega2[N2*N2];
    em_turned_for_tiles(N2, C2, T2);
    em_congruence_below(N2, C2, T2, Mdot2[0], mu2);
    em_omega_apart(N2, s2, mu2, Omega2);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C2_dot = dy + 41, *const s2_dot = dy + 55;
    em_factor_rates(N2, C2, r2, mu2, Omega2, C2_dot, s2_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a2[N2];
    em_turning_push(N2, C2, T2, s2, r2, Omega2, s2_dot, eta2, w2, f2, a2, NULL);

    /* etadot = a (45) */
    dy[8] = a1[0];
    dy[9] = a1[1];
    dy[10] = a1[2];
    dy[14] = a1[3];
    dy[15] = a1[4];
    dy[11] = a2[0];
    dy[12] = a2[1];
    dy[13] = a2[2];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real M2[N2][N2], real shared[16])
{
    const real c_0 = c[8];
    M1[0][0] = c_0;
    M1[1][0] = em_real(0.0);
    M1[1][1] = c_0;
    M1[2][0] = em_real(0.0);
    M1[2][1] = em_real(0.0);
    M1[2][2] = c_0;
    const real sway = x[6];
    const real cos_sway = em_cos(sway);
    const real heave = x[7];
    const real cos_heave = em_cos(heave);
    const real c_1 = c[9];
    const real z_2 = cos_heave*c_1;
    M1[3][0] = cos_sway*z_2;
    M1[3][1] = em_real(0.0);
    const real sin_sway = em_sin(sway);
    M1[3][2] = sin_sway*z_2;
    const real c_2 = c[10];
    M1[3][3] = c_2*(cos_heave*cos_heave);
    const real sin_heave = em_sin(heave);
    const real z_5 = sin_heave*c_1;
    M1[4][0] = -sin_sway*z_5;
    M1[4][1] = z_2;
    M1[4][2] = cos_sway*z_5;
    M1[4][3] = em_real(0.0);
    M1[4][4] = c_2;
    const real J = c[2];
    const real pitch = x[4];
    const real sin_pitch = em_sin(pitch);
    const real cos_pitch = em_cos(pitch);
    const real z_8 = cos_pitch*cos_pitch;
    const real roll = x[5];
    const real sin_roll = em_sin(roll);
    const real z_10 = sin_roll*sin_roll;
    const real J_up = c[3];
    const real cos_roll = em_cos(roll);
    const real z_12 = cos_roll*cos_roll;
    M2[0][0] = J*(sin_pitch*sin_pitch) + J*z_8*z_10 + J_up*z_8*z_12;
    const real c_3 = c[11];
    const real z_13 = sin_roll*cos_roll;
    const real z_14 = c_3*z_13;
    M2[1][0] = cos_pitch*z_14;
    M2[1][1] = J*z_12 + J_up*z_10;
    const real z_15 = J*sin_pitch;
    M2[2][0] = -z_15;
    M2[2][1] = em_real(0.0);
    M2[2][2] = J;
    shared[0] = cos_sway;
    shared[1] = sin_heave;
    shared[2] = cos_heave;
    shared[3] = sin_sway;
    shared[4] = sin_pitch;
    shared[5] = cos_pitch;
    shared[6] = z_10;
    shared[7] = z_8;
    shared[8] = z_13;
    shared[9] = z_12;
    shared[10] = sin_roll;
    shared[11] = cos_roll;
    shared[12] = z_5;
    shared[13] = z_2;
    shared[14] = z_15;
    shared[15] = z_14;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real *restrict u, const real shared[16], real Mdot1[N1][N1],
                                 real Mdot2[N2][N2], real f1[N1], real f2[N2])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    Mdot1[0][2] = Mdot1[2][0] = em_real(0.0);
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
    const real c_1 = c[9];
    const real cos_sway = shared[0];
    const real heave_dot = v[7];
    const real sin_heave = shared[1];
    const real z_16 = heave_dot*sin_heave;
    const real cos_heave = shared[2];
    const real sway_dot = v[6];
    const real sin_sway = shared[3];
    const real z_17 = sway_dot*sin_sway;
    Mdot1[0][3] = Mdot1[3][0] = -c_1*(cos_sway*z_16 + cos_heave*z_17);
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    const real z_18 = sway_dot*cos_sway;
    Mdot1[2][3] = Mdot1[3][2] = c_1*(cos_heave*z_18 - sin_sway*z_16);
    const real c_4 = c[12];
    Mdot1[3][3] = -cos_heave*c_4*z_16;
    const real z_19 = heave_dot*cos_heave;
    Mdot1[0][4] = Mdot1[4][0] = -c_1*(sin_sway*z_19 + sin_heave*z_18);
    const real z_20 = c_1*z_16;
    Mdot1[1][4] = Mdot1[4][1] = -z_20;
    Mdot1[2][4] = Mdot1[4][2] = -c_1*(sin_heave*z_17 - cos_sway*z_19);
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    const real pitch_dot = v[4];
    const real sin_pitch = shared[4];
    const real z_21 = pitch_dot*sin_pitch;
    const real J = c[2];
    const real cos_pitch = shared[5];
    const real z_22 = J*cos_pitch;
    const real z_10 = shared[6];
    const real z_23 = cos_pitch*z_10;
    const real z_8 = shared[7];
    const real roll_dot = v[5];
    const real z_13 = shared[8];
    const real z_24 = roll_dot*z_13;
    const real z_25 = z_8*z_24;
    const real J_up = c[3];
    const real z_12 = shared[9];
    const real z_26 = cos_pitch*z_12;
    Mdot2[0][0] = 2.0*(z_21*z_22 - J*(z_23*z_21 - z_25) - J_up*(z_25 + z_26*z_21));
    const real c_3 = c[11];
    Mdot2[0][1] = Mdot2[1][0] = -c_3*(z_13*z_21 + roll_dot*z_23 - roll_dot*z_26);
    const real c_5 = c[13];
    Mdot2[1][1] = -c_5*z_24;
    Mdot2[0][2] = Mdot2[2][0] = -pitch_dot*z_22;
    Mdot2[1][2] = Mdot2[2][1] = em_real(0.0);
    Mdot2[2][2] = em_real(0.0);
    const real sin_roll = shared[10];
    const real yaw = x[3];
    const real sin_yaw = em_sin(yaw);
    const real cos_yaw = em_cos(yaw);
    const real cos_roll = shared[11];
    const real z_29 = sin_pitch*cos_roll;
    const real f1_ = u[0];
    const real f3 = u[2];
    const real z_30 = f1_ + f3;
    const real f2_ = u[1];
    const real f4 = u[3];
    const real z_31 = f2_ + f4;
    const real z_32 = z_30 + z_31;
    f1[0] = (sin_roll*sin_yaw + cos_yaw*z_29)*z_32;
    f1[1] = -z_32*(sin_roll*cos_yaw - sin_yaw*z_29);
    const real z_33 = cos_pitch*cos_roll;
    const real c_6 = c[14];
    f1[2] = z_32*z_33 - c_6;
    const real x_dot = v[0];
    const real z_dot = v[2];
    const real c_7 = c[15];
    f1[3] = -(c_1*(cos_heave*(x_dot*z_17) + z_16*(x_dot*cos_sway) + z_16*(z_dot*sin_sway) -
        cos_heave*(z_dot*z_18)) + cos_heave*sin_sway*c_7);
    const real z_5 = shared[12];
    const real c_2 = c[10];
    const real z_2 = shared[13];
    const real z_34 = heave_dot*z_2;
    const real y_dot = v[1];
    f1[4] = -((x_dot*(z_18*z_5) + z_dot*(z_17*z_5) + sin_heave*(sway_dot*sway_dot)*(cos_heave*c_2) +
        x_dot*(sin_sway*z_34) + y_dot*z_20 - z_dot*(cos_sway*z_34)) + cos_sway*sin_heave*c_7);
    const real a_ = c[4];
    const real z_35 = a_*(f2_ - f4);
    const real drag = c[5];
    const real z_36 = drag*(z_30 - z_31);
    const real z_37 = a_*(f1_ - f3);
    f2[0] = -(sin_pitch*z_35 + cos_pitch*sin_roll*z_37 - z_33*z_36);
    const real z_15 = shared[14];
    const real yaw_dot = v[3];
    const real z_38 = yaw_dot*yaw_dot;
    const real z_14 = shared[15];
    f2[1] = -((sin_roll*z_36 + cos_roll*z_37) - ((sin_pitch*z_22 - z_15*z_23 - sin_pitch*(J_up*z_26))*z_38 -
        yaw_dot*(z_21*z_14) - yaw_dot*roll_dot*z_22));
    f2[2] = z_35 + (z_8*z_38*z_14 + yaw_dot*pitch_dot*(c_3*(z_26 - z_23)) - pitch_dot*pitch_dot*z_14);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], M2[N2][N2], shared[16];
    triangular_masses(y, c, M1, M2, shared);

    /* x, y, z, sway, heave: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[8], y[9], y[10], y[14], y[15] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[6] = v1[3];
    dy[7] = v1[4];

    /* yaw, pitch, roll: M = L L^T */
    real L2[N2][N2], r2[N2];
    const int singular2 = em_cholesky(N2, M2[0], L2[0], r2, EM_SINGULAR_PIVOT);
    if (singular2 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate2[singular2], -1, 0.0);
    const real eta2[N2] = { y[11], y[12], y[13] };
    real v2[N2];
    em_copy(N2, eta2, v2);
    em_backward(N2, L2[0], r2, v2);
    dy[3] = v2[0];
    dy[4] = v2[1];
    dy[5] = v2[2];

    real Mdot1[N1][N1], Mdot2[N2][N2], f1[N1], f2[N2];
    triangular_motion(y, dy, c, u, shared, Mdot1, Mdot2, f1, f2);

    /* x, y, z, sway, heave: a = L^-1 f - Phi eta */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* yaw, pitch, roll: a = L^-1 f - Phi eta */
    real a2[N2], q2[N2];
    em_triangular_push(N2, L2[0], r2, Mdot2[0], eta2, f2, a2, q2);

    /* etadot = a (45) */
    dy[8] = a1[0];
    dy[9] = a1[1];
    dy[10] = a1[2];
    dy[14] = a1[3];
    dy[15] = a1[4];
    dy[11] = a2[0];
    dy[12] = a2[1];
    dy[13] = a2[2];
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
                              real M2[N2][N2], real shared[10])
{
    const real c_0 = c[8];
    M1[0][0] = c_0;
    M1[0][1] = M1[1][0] = em_real(0.0);
    M1[1][1] = c_0;
    M1[0][2] = M1[2][0] = em_real(0.0);
    M1[1][2] = M1[2][1] = em_real(0.0);
    M1[2][2] = c_0;
    const real sway = x[6];
    const real cos_sway = em_cos(sway);
    const real heave = x[7];
    const real cos_heave = em_cos(heave);
    const real c_1 = c[9];
    const real z_2 = cos_heave*c_1;
    M1[0][3] = M1[3][0] = cos_sway*z_2;
    M1[1][3] = M1[3][1] = em_real(0.0);
    const real sin_sway = em_sin(sway);
    M1[2][3] = M1[3][2] = sin_sway*z_2;
    const real c_2 = c[10];
    M1[3][3] = c_2*(cos_heave*cos_heave);
    const real sin_heave = em_sin(heave);
    const real z_5 = sin_heave*c_1;
    M1[0][4] = M1[4][0] = -sin_sway*z_5;
    M1[1][4] = M1[4][1] = z_2;
    M1[2][4] = M1[4][2] = cos_sway*z_5;
    M1[3][4] = M1[4][3] = em_real(0.0);
    M1[4][4] = c_2;
    const real J = c[2];
    const real pitch = x[4];
    const real sin_pitch = em_sin(pitch);
    const real cos_pitch = em_cos(pitch);
    const real z_8 = cos_pitch*cos_pitch;
    const real roll = x[5];
    const real sin_roll = em_sin(roll);
    const real z_10 = sin_roll*sin_roll;
    const real J_up = c[3];
    const real cos_roll = em_cos(roll);
    const real z_12 = cos_roll*cos_roll;
    M2[0][0] = J*(sin_pitch*sin_pitch) + z_8*(J*z_10) + z_8*(J_up*z_12);
    const real c_3 = c[11];
    const real z_13 = sin_roll*cos_roll;
    M2[0][1] = M2[1][0] = cos_pitch*(c_3*z_13);
    M2[1][1] = J*z_12 + J_up*z_10;
    M2[0][2] = M2[2][0] = -J*sin_pitch;
    M2[1][2] = M2[2][1] = em_real(0.0);
    M2[2][2] = J;
    shared[0] = cos_sway;
    shared[1] = sin_heave;
    shared[2] = cos_heave;
    shared[3] = sin_sway;
    shared[4] = cos_pitch;
    shared[5] = sin_pitch;
    shared[6] = z_10;
    shared[7] = z_8;
    shared[8] = z_13;
    shared[9] = z_12;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[10],
                             real Mdot1[N1][N1], real Mdot2[N2][N2])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    Mdot1[0][2] = Mdot1[2][0] = em_real(0.0);
    Mdot1[1][2] = Mdot1[2][1] = em_real(0.0);
    Mdot1[2][2] = em_real(0.0);
    const real c_1 = c[9];
    const real cos_sway = shared[0];
    const real heave_dot = v[7];
    const real sin_heave = shared[1];
    const real z_14 = heave_dot*sin_heave;
    const real cos_heave = shared[2];
    const real sway_dot = v[6];
    const real sin_sway = shared[3];
    const real z_15 = sway_dot*sin_sway;
    Mdot1[0][3] = Mdot1[3][0] = -c_1*(cos_sway*z_14 + cos_heave*z_15);
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    const real z_16 = sway_dot*cos_sway;
    Mdot1[2][3] = Mdot1[3][2] = c_1*(cos_heave*z_16 - sin_sway*z_14);
    const real c_4 = c[12];
    Mdot1[3][3] = -c_4*(cos_heave*z_14);
    const real z_17 = heave_dot*cos_heave;
    Mdot1[0][4] = Mdot1[4][0] = -c_1*(sin_sway*z_17 + sin_heave*z_16);
    Mdot1[1][4] = Mdot1[4][1] = -c_1*z_14;
    Mdot1[2][4] = Mdot1[4][2] = -c_1*(sin_heave*z_15 - cos_sway*z_17);
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    const real J = c[2];
    const real cos_pitch = shared[4];
    const real pitch_dot = v[4];
    const real sin_pitch = shared[5];
    const real z_18 = pitch_dot*sin_pitch;
    const real z_19 = cos_pitch*z_18;
    const real z_10 = shared[6];
    const real z_8 = shared[7];
    const real roll_dot = v[5];
    const real z_13 = shared[8];
    const real z_20 = roll_dot*z_13;
    const real z_21 = z_8*z_20;
    const real J_up = c[3];
    const real z_12 = shared[9];
    Mdot2[0][0] = 2.0*(J*z_19 - J*(z_10*z_19 - z_21) - J_up*(z_21 + z_12*z_19));
    const real c_3 = c[11];
    const real z_22 = roll_dot*cos_pitch;
    Mdot2[0][1] = Mdot2[1][0] = -c_3*(z_13*z_18 + z_10*z_22 - z_12*z_22);
    const real c_5 = c[13];
    Mdot2[1][1] = -c_5*z_20;
    Mdot2[0][2] = Mdot2[2][0] = -pitch_dot*J*cos_pitch;
    Mdot2[1][2] = Mdot2[2][1] = em_real(0.0);
    Mdot2[2][2] = em_real(0.0);
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

enum { N_PIVOTS = 8 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], M2[N2][N2], shared[10];
    settled_masses(y, c, M1, M2, shared);
    em_pivots(N1, M1[0], pivots, diagonal);
    pivots += N1, diagonal += N1;
    em_pivots(N2, M2[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1], e[2], e[6], e[7] };
    if (mode) em_backward(N1, memory + 0, memory + 25, v1);
    else em_velocity_of_eta(N1, y + 16, y + 50, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[6] = v1[3];
    v[7] = v1[4];
    real v2[N2] = { e[3], e[4], e[5] };
    if (mode) em_backward(N2, memory + 30, memory + 39, v2);
    else em_velocity_of_eta(N2, y + 41, y + 55, v2);
    v[3] = v2[0];
    v[4] = v2[1];
    v[5] = v2[2];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s.
 * *done becomes 0 in lanes that are settled number by number instead, as where the mode changes;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], M2[N2][N2], shared[10];
    settled_masses(y, c, M1, M2, shared);
    real eta1[N1] = { y[8], y[9], y[10], y[14], y[15] };
    *done &= em_refresh(N1, M1[0], y + 16, y + 50, mode ? NULL : eta1);
    y[8] = eta1[0];
    y[9] = eta1[1];
    y[10] = eta1[2];
    y[14] = eta1[3];
    y[15] = eta1[4];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 25, EM_SINGULAR_PIVOT);
    real eta2[N2] = { y[11], y[12], y[13] };
    *done &= em_refresh(N2, M2[0], y + 41, y + 55, mode ? NULL : eta2);
    y[11] = eta2[0];
    y[12] = eta2[1];
    y[13] = eta2[2];
    if (mode) em_cholesky(N2, M2[0], memory + 30, memory + 39, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 50);
    gap = em_lane_min(gap, em_gap(N2, y + 55));
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1], Mdot2[N2][N2];
        settled_rates(dy, c, shared, Mdot1, Mdot2);
        real time = em_time_on_lanes(N1, y + 16, y + 50, Mdot1[0]);
        time = em_lane_min(time, em_time_on_lanes(N2, y + 41, y + 55, Mdot2[0]));
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes drone_lanes;
em_lanes drone_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double roll = x[5];
    const double sin_roll = em_sin(roll);
    const double yaw = x[3];
    const double sin_yaw = em_sin(yaw);
    const double cos_yaw = em_cos(yaw);
    const double pitch = x[4];
    const double sin_pitch = em_sin(pitch);
    const double cos_roll = em_cos(roll);
    const double z_5 = sin_pitch*cos_roll;
    const double f1 = u[0];
    const double f3 = u[2];
    const double z_6 = f1 + f3;
    const double f2 = u[1];
    const double f4 = u[3];
    const double z_7 = f2 + f4;
    const double z_8 = z_6 + z_7;
    const double c_1 = c[9];
    const double sway = x[6];
    const double cos_sway = em_cos(sway);
    const double sway_dot = v[6];
    const double heave_dot = v[7];
    const double heave = x[7];
    const double sin_heave = em_sin(heave);
    const double z_11 = heave_dot*sin_heave;
    const double z_12 = sway_dot*z_11;
    const double z_13 = cos_sway*z_12;
    const double z_14 = sway_dot*sway_dot;
    const double cos_heave = em_cos(heave);
    const double sin_sway = em_sin(sway);
    const double z_17 = cos_heave*sin_sway;
    const double z_18 = heave_dot*heave_dot;
    bias[0] = (sin_roll*sin_yaw + cos_yaw*z_5)*z_8 + (c_1*(z_13 + z_14*z_17) + c_1*(z_13 + z_18*z_17));
    bias[1] = -(z_8*(sin_roll*cos_yaw - sin_yaw*z_5) - sin_heave*(c_1*z_18));
    const double cos_pitch = em_cos(pitch);
    const double z_20 = cos_pitch*cos_roll;
    const double c_6 = c[14];
    const double z_21 = sin_sway*z_12;
    const double z_22 = cos_heave*cos_sway;
    bias[2] = (z_8*z_20 - c_6) + (c_1*(z_21 - z_14*z_22) + c_1*(z_21 - z_18*z_22));
    const double a_ = c[4];
    const double z_23 = a_*(f2 - f4);
    const double drag = c[5];
    const double z_24 = drag*(z_6 - z_7);
    const double z_25 = a_*(f1 - f3);
    const double yaw_dot = v[3];
    const double J = c[2];
    const double pitch_dot = v[4];
    const double z_26 = pitch_dot*cos_pitch;
    const double z_27 = sin_pitch*z_26;
    const double z_28 = sin_roll*sin_roll;
    const double z_29 = cos_pitch*cos_pitch;
    const double roll_dot = v[5];
    const double z_30 = sin_roll*cos_roll;
    const double z_31 = roll_dot*z_30;
    const double z_32 = z_29*z_31;
    const double J_up = c[3];
    const double z_33 = cos_roll*cos_roll;
    const double c_3 = c[11];
    const double z_34 = pitch_dot*pitch_dot;
    const double z_35 = sin_pitch*z_30;
    const double z_36 = roll_dot*z_26;
    bias[3] = -((sin_pitch*z_23 + cos_pitch*sin_roll*z_25 - z_20*z_24) + (2.0*yaw_dot*(J*z_27 - J*(z_28*z_27 -
        z_32) - J_up*(z_32 + z_33*z_27)) - c_3*(z_34*z_35 + z_28*z_36 - z_33*z_36) - J*z_36));
    const double z_37 = J*sin_pitch;
    const double z_38 = cos_pitch*z_28;
    const double z_39 = cos_pitch*z_33;
    const double z_40 = yaw_dot*yaw_dot;
    const double z_41 = yaw_dot*pitch_dot;
    const double z_42 = z_35*z_41;
    const double z_43 = yaw_dot*roll_dot;
    const double c_5 = c[13];
    bias[4] = -(((sin_roll*z_24 + cos_roll*z_25) - ((cos_pitch*z_37 - z_38*z_37 - sin_pitch*J_up*z_39)*z_40 -
        c_3*z_42 - J*cos_pitch*z_43)) - (c_3*(z_42 + z_38*z_43 - z_39*z_43) + c_5*(pitch_dot*z_31)));
    bias[5] = (z_23 + (c_3*z_29*z_40*z_30 + c_3*(z_39 - z_38)*z_41 - z_30*(c_3*z_34))) + yaw_dot*J*z_26;
    const double x_dot = v[0];
    const double z_44 = x_dot*z_17;
    const double z_45 = x_dot*cos_sway;
    const double z_46 = sway_dot*z_44 + z_11*z_45;
    const double z_dot = v[2];
    const double z_47 = z_dot*z_22;
    const double z_48 = z_dot*sin_sway;
    const double z_49 = sway_dot*z_47 - z_11*z_48;
    const double c_7 = c[15];
    const double c_4 = c[12];
    bias[6] = -((c_1*(z_46 - z_49) + c_7*z_17) - (c_1*z_46 + cos_heave*c_4*z_12 - c_1*z_49));
    const double z_50 = sin_heave*(sway_dot*c_1);
    const double c_2 = c[10];
    const double z_51 = heave_dot*c_1;
    const double y_dot = v[1];
    const double z_52 = y_dot*(c_1*z_11);
    const double z_53 = sway_dot*sin_heave;
    bias[7] = -(((z_45*z_50 + z_48*z_50 + sin_heave*z_14*(cos_heave*c_2) + z_44*z_51 + z_52 - z_47*z_51) +
        cos_sway*sin_heave*c_7) - (z_52 + c_1*(z_45*z_53 + heave_dot*z_44) + c_1*(z_48*z_53 - heave_dot*z_47)));
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double x_dot = v[0];
    const double c_0 = c[8];
    const double sway = x[6];
    const double cos_sway = em_cos(sway);
    const double sway_dot = v[6];
    const double heave = x[7];
    const double cos_heave = em_cos(heave);
    const double c_1 = c[9];
    const double z_2 = cos_heave*c_1;
    const double z_3 = sway_dot*z_2;
    const double sin_sway = em_sin(sway);
    const double heave_dot = v[7];
    const double sin_heave = em_sin(heave);
    const double z_6 = sin_heave*c_1;
    const double z_7 = heave_dot*z_6;
    const double y_dot = v[1];
    const double z_dot = v[2];
    const double yaw_dot = v[3];
    const double J = c[2];
    const double pitch = x[4];
    const double sin_pitch = em_sin(pitch);
    const double cos_pitch = em_cos(pitch);
    const double z_10 = cos_pitch*cos_pitch;
    const double roll = x[5];
    const double sin_roll = em_sin(roll);
    const double z_12 = sin_roll*sin_roll;
    const double J_up = c[3];
    const double cos_roll = em_cos(roll);
    const double z_14 = cos_roll*cos_roll;
    const double pitch_dot = v[4];
    const double c_3 = c[11];
    const double z_15 = cos_pitch*sin_roll*(cos_roll*c_3);
    const double roll_dot = v[5];
    const double c_2 = c[10];
    e[0] = 0.5*(x_dot*(x_dot*c_0 + cos_sway*z_3 - sin_sway*z_7) + y_dot*(y_dot*c_0 + heave_dot*z_2) +
        z_dot*(z_dot*c_0 + sin_sway*z_3 + cos_sway*z_7) + yaw_dot*(yaw_dot*(J*(sin_pitch*sin_pitch) + J*z_10*z_12
        + J_up*z_10*z_14) + pitch_dot*z_15 - sin_pitch*(roll_dot*J)) + pitch_dot*(yaw_dot*z_15 + pitch_dot*(J*z_14
        + J_up*z_12)) + sway_dot*(x_dot*cos_sway*z_2 + z_dot*sin_sway*z_2 + sway_dot*c_2*(cos_heave*cos_heave)) -
        roll_dot*(J*(-(roll_dot - yaw_dot*sin_pitch))) - heave_dot*(x_dot*sin_sway*z_6 - y_dot*z_2 -
        z_dot*cos_sway*z_6 - heave_dot*c_2));
    e[1] = 0.0;
    e[2] = 0.0;
    const double g = c[7];
    const double m = c[0];
    const double z = x[2];
    const double load = c[1];
    const double L = c[6];
    e[3] = g*(m*z + load*(z - L*cos_heave*cos_sway));
}

/* out (n_outputs), from x, v, a = xddot, lambda */
EM_ACROSS void observe(double t, const double *restrict x, const double *restrict v, const double *restrict a,
                       const double *restrict lambda, const double *restrict c, const double *restrict u,
                       double *restrict out)
{
    const double c_8 = c[16];
    const double c_1 = c[9];
    const double heave = x[7];
    const double sin_heave = em_sin(heave);
    const double heave_dot = v[7];
    const double z_1 = heave_dot*heave_dot;
    const double L = c[6];
    const double z_2 = L*sin_heave;
    const double y_ddot = a[1];
    const double heave_ddot = a[7];
    const double cos_heave = em_cos(heave);
    const double z_4 = L*cos_heave;
    const double sway_dot = v[6];
    const double z_5 = sway_dot*sway_dot;
    const double sway = x[6];
    const double sin_sway = em_sin(sway);
    const double z_7 = sin_sway*z_4;
    const double x_ddot = a[0];
    const double sway_ddot = a[6];
    const double cos_sway = em_cos(sway);
    const double z_9 = cos_sway*z_4;
    const double c_9 = c[17];
    const double z_10 = sway_dot*heave_dot*(sin_heave*c_9);
    const double g = c[7];
    const double z_ddot = a[2];
    out[0] = c_8*(c_1*(sin_heave*(z_1*z_2 - y_ddot - heave_ddot*z_4) + (z_5*z_7 + z_1*z_7 +
        heave_ddot*(sin_sway*z_2) + cos_sway*z_10 - x_ddot - sway_ddot*z_9)*(cos_heave*sin_sway) + (g + z_1*z_9 +
        z_5*z_9 + z_ddot + heave_ddot*(cos_sway*z_2) + sway_ddot*z_7 - sin_sway*z_10)*(cos_heave*cos_sway)));
}

/* p: what the drawing is made of, shape by shape */
EM_ACROSS void draw(double t, const double *restrict x, const double *restrict c, double *restrict p)
{
    const double x_ = x[0];
    const double yaw = x[3];
    const double cos_yaw = em_cos(yaw);
    const double pitch = x[4];
    const double cos_pitch = em_cos(pitch);
    const double a_ = c[4];
    const double z_2 = cos_pitch*a_;
    const double z_3 = cos_yaw*z_2;
    p[0] = p[12] = x_ + z_3;
    const double y = x[1];
    const double sin_yaw = em_sin(yaw);
    const double z_5 = sin_yaw*z_2;
    p[1] = p[13] = y + z_5;
    const double z = x[2];
    const double sin_pitch = em_sin(pitch);
    const double z_7 = sin_pitch*a_;
    p[2] = p[14] = z - z_7;
    p[3] = p[26] = x_ - z_3;
    p[4] = p[27] = y - z_5;
    p[5] = p[28] = z + z_7;
    const double roll = x[5];
    const double cos_roll = em_cos(roll);
    const double sin_roll = em_sin(roll);
    const double z_10 = sin_pitch*sin_roll;
    const double z_11 = a_*(cos_roll*sin_yaw - cos_yaw*z_10);
    p[6] = p[19] = x_ - z_11;
    const double z_12 = a_*(cos_roll*cos_yaw + sin_yaw*z_10);
    p[7] = p[20] = y + z_12;
    const double z_13 = sin_roll*z_2;
    p[8] = p[21] = z + z_13;
    p[9] = p[33] = x_ + z_11;
    p[10] = p[34] = y - z_12;
    p[11] = p[35] = z - z_13;
    const double c_10 = c[18];
    p[15] = p[22] = p[29] = p[36] = c_10;
    const double z_14 = sin_pitch*cos_roll;
    p[16] = p[23] = p[30] = p[37] = sin_roll*sin_yaw + cos_yaw*z_14;
    p[17] = p[24] = p[31] = p[38] = -(sin_roll*cos_yaw - sin_yaw*z_14);
    p[18] = p[25] = p[32] = p[39] = cos_pitch*cos_roll;
    p[40] = x_;
    p[41] = y;
    p[42] = z;
    const double sway = x[6];
    const double sin_sway = em_sin(sway);
    const double L = c[6];
    const double heave = x[7];
    const double cos_heave = em_cos(heave);
    const double z_17 = L*cos_heave;
    p[43] = p[46] = p[50] = x_ + sin_sway*z_17;
    const double sin_heave = em_sin(heave);
    p[44] = p[47] = p[51] = y + L*sin_heave;
    const double cos_sway = em_cos(sway);
    p[45] = p[48] = p[52] = z - cos_sway*z_17;
    const double c_11 = c[19];
    p[49] = c_11;
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
    const double pitch = x[4];
    const double sin_pitch = em_sin(pitch);
    const double J = c[2];
    const double cos_pitch = em_cos(pitch);
    const double z_2 = J*cos_pitch;
    const double z_3 = sin_pitch*z_2;
    const double roll = x[5];
    const double sin_roll = em_sin(roll);
    const double z_5 = sin_roll*sin_roll;
    const double J_up = c[3];
    const double cos_roll = em_cos(roll);
    const double z_7 = cos_roll*cos_roll;
    dM[283] = 2.0*(z_3 - z_3*z_5 - sin_pitch*cos_pitch*J_up*z_7);
    const double z_8 = J - J_up;
    const double z_9 = z_8*(sin_roll*cos_roll);
    dM[291] = dM[284] = -sin_pitch*z_9;
    dM[299] = dM[285] = -z_2;
    dM[347] = 2.0*(z_9*(cos_pitch*cos_pitch));
    const double z_10 = cos_pitch*z_8;
    dM[355] = dM[348] = z_7*z_10 - z_5*z_10;
    dM[356] = (-2.0)*z_9;
    const double sway = x[6];
    const double sin_sway = em_sin(sway);
    const double heave = x[7];
    const double cos_heave = em_cos(heave);
    const double load = c[1];
    const double L = c[6];
    const double z_13 = load*L;
    const double z_14 = cos_heave*z_13;
    dM[432] = dM[390] = -sin_sway*z_14;
    const double cos_sway = em_cos(sway);
    dM[434] = dM[406] = cos_sway*z_14;
    const double sin_heave = em_sin(heave);
    const double z_17 = sin_heave*z_13;
    dM[440] = dM[391] = -cos_sway*z_17;
    dM[442] = dM[407] = -sin_sway*z_17;
    dM[496] = dM[454] = -cos_sway*z_17;
    dM[498] = dM[470] = -sin_sway*z_17;
    dM[502] = (-2.0)*(load*cos_heave*sin_heave*(L*L));
    dM[504] = dM[455] = -sin_sway*z_14;
    dM[505] = dM[463] = -z_17;
    dM[506] = dM[471] = cos_sway*z_14;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double yaw = x[3];
    const double sin_yaw = em_sin(yaw);
    const double f1 = u[0];
    const double f3 = u[2];
    const double z_1 = f1 + f3;
    const double f2 = u[1];
    const double f4 = u[3];
    const double z_2 = f2 + f4;
    const double z_3 = z_1 + z_2;
    const double pitch = x[4];
    const double sin_pitch = em_sin(pitch);
    const double roll = x[5];
    const double cos_roll = em_cos(roll);
    const double z_6 = sin_pitch*cos_roll;
    const double z_7 = z_3*z_6;
    const double cos_yaw = em_cos(yaw);
    const double sin_roll = em_sin(roll);
    const double z_10 = sin_roll*z_3;
    D[3] = sin_yaw*z_7 - cos_yaw*z_10;
    const double cos_pitch = em_cos(pitch);
    const double z_12 = cos_roll*z_3;
    const double z_13 = cos_pitch*z_12;
    D[4] = -cos_yaw*z_13;
    const double z_14 = sin_pitch*z_10;
    D[5] = cos_yaw*z_14 - sin_yaw*z_12;
    const double sway = x[6];
    const double cos_sway = em_cos(sway);
    const double sway_dot = v[6];
    const double z_16 = sway_dot*sway_dot;
    const double heave = x[7];
    const double cos_heave = em_cos(heave);
    const double load = c[1];
    const double L = c[6];
    const double z_18 = load*L;
    const double z_19 = cos_heave*z_18;
    const double heave_ddot = a[7];
    const double sin_heave = em_sin(heave);
    const double z_21 = sin_heave*z_18;
    const double heave_dot = v[7];
    const double z_22 = heave_dot*heave_dot;
    const double z_23 = heave_ddot*z_21 + z_22*z_19;
    const double z_24 = z_16*z_19 + z_23;
    const double sin_sway = em_sin(sway);
    const double sway_ddot = a[6];
    const double z_26 = heave_dot*sin_heave;
    const double z_27 = sway_dot*z_26;
    const double z_28 = sway_ddot*z_19 - 2.0*z_18*z_27;
    D[6] = -(cos_sway*z_24 + sin_sway*z_28);
    const double z_29 = sin_sway*z_18;
    const double z_30 = cos_sway*z_18;
    const double z_31 = sway_dot*heave_dot;
    D[7] = -(cos_heave*(heave_ddot*z_29 + 2.0*z_30*z_31) + sin_heave*(sway_ddot*z_30 - z_22*z_29 - z_16*z_29));
    const double z_32 = cos_heave*z_29;
    D[14] = (-2.0)*(sway_dot*z_32 + z_30*z_26);
    const double z_33 = sway_dot*sin_heave;
    D[15] = (-2.0)*(heave_dot*z_32 + z_30*z_33);
    D[19] = -(sin_yaw*z_10 + cos_yaw*z_7);
    D[20] = -sin_yaw*z_13;
    D[21] = cos_yaw*z_12 + sin_yaw*z_14;
    D[23] = -z_23;
    D[31] = (-2.0)*(z_18*z_26);
    D[36] = z_7;
    D[37] = cos_pitch*z_10;
    D[38] = cos_sway*z_28 - sin_sway*z_24;
    D[39] = cos_heave*(heave_ddot*z_30 - 2.0*z_29*z_31) - sin_heave*(sway_ddot*z_29 + z_22*z_30 + z_16*z_30);
    const double z_34 = cos_heave*z_30;
    D[46] = 2.0*(sway_dot*z_34 - z_29*z_26);
    D[47] = (-2.0)*(z_29*z_33 - heave_dot*z_34);
    const double pitch_ddot = a[4];
    const double J = c[2];
    const double J_up = c[3];
    const double z_35 = J - J_up;
    const double z_36 = sin_roll*z_35;
    const double z_37 = cos_roll*z_36;
    const double pitch_dot = v[4];
    const double roll_dot = v[5];
    const double z_38 = pitch_dot*roll_dot;
    const double z_39 = sin_roll*sin_roll;
    const double z_40 = z_35*z_39;
    const double z_41 = cos_roll*cos_roll;
    const double z_42 = z_35*z_41;
    const double yaw_dot = v[3];
    const double z_43 = yaw_dot*pitch_dot;
    const double z_44 = z_41*(sin_pitch*J_up);
    const double z_45 = J*sin_pitch;
    const double z_46 = z_39*z_45;
    const double a_ = c[4];
    const double z_47 = a_*(f1 - f3);
    const double drag = c[5];
    const double z_48 = drag*(z_1 - z_2);
    const double yaw_ddot = a[3];
    const double z_49 = cos_pitch*J_up;
    const double z_50 = z_41*z_49;
    const double z_51 = J*cos_pitch;
    const double z_52 = z_39*z_51;
    const double z_53 = yaw_dot*roll_dot;
    const double z_54 = cos_pitch*z_35;
    const double z_55 = sin_roll*z_54;
    const double z_56 = cos_roll*z_55;
    const double z_57 = pitch_dot*pitch_dot;
    const double roll_ddot = a[5];
    D[52] = -(sin_pitch*(pitch_ddot*z_37 + z_38*z_42 + 2.0*z_43*z_45 + sin_roll*z_47 + 2.0*yaw_ddot*z_50 +
        2.0*yaw_ddot*z_52 + 4.0*z_53*z_56 - J*z_38 - z_38*z_40 - 2.0*z_43*z_44 - 2.0*z_43*z_46 - cos_roll*z_48) -
        cos_pitch*(a_*(f2 - f4) + 2.0*z_51*z_43 + 2.0*yaw_ddot*z_45 - z_57*z_37 - J*roll_ddot - 2.0*z_43*z_50 -
        2.0*z_43*z_52));
    const double z_58 = cos_roll*z_54;
    const double z_59 = z_57*z_36;
    const double z_60 = z_49*z_6;
    const double z_61 = cos_pitch*cos_pitch;
    const double z_62 = cos_roll*z_61;
    const double z_63 = J_up*z_62;
    const double z_64 = z_61*z_36;
    const double z_65 = sin_pitch*z_51;
    const double z_66 = sin_roll*z_65;
    const double z_67 = z_35*z_62;
    D[53] = -(sin_roll*(pitch_ddot*z_55 + 2.0*z_38*z_58 + 2.0*yaw_ddot*z_63 + 2.0*z_53*z_64 - sin_pitch*z_59 -
        4.0*z_43*z_60 - cos_pitch*z_48) - cos_roll*(pitch_ddot*z_58 + cos_pitch*z_47 +
        2.0*J*sin_roll*yaw_ddot*z_61 + 2.0*z_53*z_67 - 2.0*z_38*z_55 - z_35*z_57*z_6 - 4.0*z_43*z_66));
    const double z_68 = z_65*z_39;
    const double z_69 = roll_dot*sin_roll;
    const double z_70 = sin_pitch*z_50;
    D[59] = 2.0*(pitch_dot*z_65 - (pitch_dot*z_68 - J*z_62*z_69) - (pitch_dot*z_70 + z_69*z_63));
    const double z_71 = roll_dot*z_51;
    const double z_72 = z_41*z_54;
    const double z_73 = z_39*z_54;
    const double z_74 = roll_dot*z_72 - roll_dot*z_73;
    D[60] = -(2.0*pitch_dot*z_36*z_6 + z_71 + 2.0*yaw_dot*z_70 + 2.0*yaw_dot*z_68 - 2.0*yaw_dot*z_65 - z_74);
    const double z_75 = pitch_dot*z_51;
    const double z_76 = yaw_dot*z_36*z_62;
    D[61] = -(z_75 + pitch_dot*z_73 - pitch_dot*z_72 - 2.0*z_76);
    const double z_77 = yaw_dot*yaw_dot;
    D[68] = -(sin_pitch*(J*z_53 + yaw_ddot*z_37 + z_53*z_42 + z_77*z_44 + z_77*z_46 - z_77*z_45 - z_53*z_40) -
        cos_pitch*(z_77*z_50 + z_77*z_52 - z_77*z_51));
    const double z_78 = cos_roll*z_35;
    D[69] = -(sin_roll*(yaw_ddot*z_55 + 2.0*z_53*z_58 + 2.0*z_77*z_60 + z_47 + 2.0*J*cos_roll*pitch_ddot -
        2.0*z_36*z_38) - cos_roll*(yaw_ddot*z_58 + 2.0*z_77*z_66 + z_48 + 2.0*sin_roll*J_up*pitch_ddot -
        2.0*z_38*z_78 - 2.0*z_53*z_55));
    D[75] = z_71 + z_74 - 2.0*yaw_dot*(z_65 - z_68 - z_70);
    D[76] = (-2.0)*(roll_dot*z_37);
    const double z_79 = pitch_dot*z_37 - 0.5*yaw_dot*z_51;
    D[77] = -(yaw_dot*z_73 + 2.0*z_79 - yaw_dot*z_72);
    D[84] = -(yaw_ddot*z_51 - sin_pitch*(J*z_43 + 2.0*z_77*z_56 + z_43*z_42 - z_43*z_40));
    D[85] = sin_roll*(2.0*z_43*z_58 + z_77*z_64 - z_59) + cos_roll*(2.0*z_43*z_55 + z_57*z_78 - z_77*z_67);
    const double z_80 = z_72 - z_73;
    D[91] = -(z_75 + 2.0*z_76 + pitch_dot*z_80);
    D[92] = 2.0*z_79 - yaw_dot*z_80;
    const double g = c[7];
    const double z_ddot = a[2];
    const double x_ddot = a[0];
    D[102] = cos_sway*(g*z_19 + z_ddot*z_19) - x_ddot*z_32;
    const double z_81 = load*(L*L);
    const double z_82 = cos_heave*z_81;
    const double z_83 = x_ddot*z_30;
    D[103] = -(2.0*cos_heave*cos_heave*z_81*z_31 + sin_heave*(2.0*sway_ddot*z_82 + z_ddot*z_29 + z_83 + g*z_29 -
        2.0*z_81*z_27));
    D[110] = (-2.0)*(z_26*z_82);
    const double z_84 = z_82*z_33;
    D[111] = (-2.0)*z_84;
    D[118] = -(sin_heave*z_83 + sin_sway*(z_ddot*z_21 + g*z_21));
    const double y_ddot = a[1];
    D[119] = cos_heave*(g*z_30 + z_16*z_82 + z_ddot*z_30 - x_ddot*z_29) - sin_heave*(y_ddot*z_18 +
        sin_heave*z_16*z_81);
    D[126] = 2.0*z_84;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double roll = x[5];
    const double sin_roll = em_sin(roll);
    const double yaw = x[3];
    const double sin_yaw = em_sin(yaw);
    const double cos_yaw = em_cos(yaw);
    const double pitch = x[4];
    const double sin_pitch = em_sin(pitch);
    const double cos_roll = em_cos(roll);
    const double z_5 = sin_pitch*cos_roll;
    D[0] = -(sin_roll*sin_yaw + cos_yaw*z_5);
    D[1] = -(sin_roll*sin_yaw + cos_yaw*z_5);
    D[2] = -(sin_roll*sin_yaw + cos_yaw*z_5);
    D[3] = -(sin_roll*sin_yaw + cos_yaw*z_5);
    const double x_ddot = a[0];
    D[4] = x_ddot;
    const double sway_dot = v[6];
    const double heave_dot = v[7];
    const double z_6 = sway_dot*heave_dot;
    const double sway = x[6];
    const double cos_sway = em_cos(sway);
    const double L = c[6];
    const double heave = x[7];
    const double sin_heave = em_sin(heave);
    const double z_9 = L*sin_heave;
    const double z_10 = cos_sway*z_9;
    const double z_11 = sway_dot*sway_dot;
    const double sin_sway = em_sin(sway);
    const double cos_heave = em_cos(heave);
    const double z_14 = L*cos_heave;
    const double z_15 = sin_sway*z_14;
    const double z_16 = heave_dot*heave_dot;
    const double sway_ddot = a[6];
    const double z_17 = cos_sway*z_14;
    const double heave_ddot = a[7];
    const double z_18 = sin_sway*z_9;
    D[5] = -(2.0*z_6*z_10 + z_11*z_15 + z_16*z_15 + heave_ddot*z_18 - x_ddot - sway_ddot*z_17);
    const double load = c[1];
    const double z_19 = load*sin_heave;
    const double z_20 = sin_sway*z_19;
    const double z_21 = load*cos_heave;
    const double z_22 = cos_sway*z_21;
    const double z_23 = sin_sway*z_21;
    const double z_24 = cos_sway*z_19;
    D[10] = -(heave_ddot*z_20 + z_16*z_23 + z_11*z_23 + 2.0*z_6*z_24 - sway_ddot*z_22);
    D[13] = sin_roll*cos_yaw - sin_yaw*z_5;
    D[14] = sin_roll*cos_yaw - sin_yaw*z_5;
    D[15] = sin_roll*cos_yaw - sin_yaw*z_5;
    D[16] = sin_roll*cos_yaw - sin_yaw*z_5;
    const double y_ddot = a[1];
    D[17] = y_ddot;
    D[18] = -(z_16*z_9 - y_ddot - heave_ddot*z_14);
    D[23] = heave_ddot*z_21 - z_16*z_19;
    const double cos_pitch = em_cos(pitch);
    const double z_26 = cos_pitch*cos_roll;
    D[26] = -z_26;
    D[27] = -z_26;
    D[28] = -z_26;
    D[29] = -z_26;
    const double g = c[7];
    const double z_ddot = a[2];
    const double z_27 = g + z_ddot;
    D[30] = z_27;
    D[31] = z_16*z_17 + z_11*z_17 + heave_ddot*z_10 + sway_ddot*z_15 + z_27 - 2.0*z_6*z_18;
    D[36] = heave_ddot*z_24 + sway_ddot*z_23 + z_16*z_22 + z_11*z_22 - 2.0*z_6*z_20;
    const double m = c[0];
    D[37] = load + m;
    const double a_ = c[4];
    const double z_28 = cos_pitch*sin_roll;
    const double z_29 = a_*z_28;
    const double drag = c[5];
    const double z_30 = drag*z_26;
    D[39] = z_29 - z_30;
    const double z_31 = sin_pitch*a_;
    D[40] = z_31 + z_30;
    D[41] = -(z_29 + z_30);
    D[42] = -(z_31 - z_30);
    const double pitch_dot = v[4];
    const double roll_dot = v[5];
    const double z_32 = pitch_dot*roll_dot;
    const double z_33 = cos_pitch*z_32;
    const double yaw_dot = v[3];
    const double z_34 = yaw_dot*cos_pitch;
    const double z_35 = pitch_dot*z_34;
    const double z_36 = sin_pitch*z_35;
    const double roll_ddot = a[5];
    const double z_37 = sin_roll*sin_roll;
    const double yaw_ddot = a[3];
    const double z_38 = cos_pitch*cos_pitch;
    const double z_39 = yaw_ddot*z_38;
    const double z_40 = sin_roll*cos_roll;
    const double z_41 = z_38*z_40;
    const double z_42 = pitch_dot*pitch_dot*z_40;
    const double z_43 = cos_roll*cos_roll;
    const double pitch_ddot = a[4];
    const double z_44 = cos_pitch*z_40;
    const double z_45 = yaw_dot*roll_dot*z_41 - 0.5*(sin_pitch*z_42 + z_33*z_37 - z_33*z_43 - pitch_ddot*z_44);
    D[45] = -(z_33 + sin_pitch*roll_ddot + 2.0*z_36*z_37 - 2.0*z_36 - z_37*z_39 - yaw_ddot*(sin_pitch*sin_pitch) -
        2.0*z_45);
    D[46] = -(2.0*z_36*z_43 + 2.0*z_45 - z_43*z_39);
    const double f2 = u[1];
    const double f4 = u[3];
    const double z_46 = f2 - f4;
    const double f1 = u[0];
    const double f3 = u[2];
    const double z_47 = f1 - f3;
    D[47] = sin_pitch*z_46 + z_47*z_28;
    const double z_48 = f1 + f3 - f2 - f4;
    D[48] = -z_48*z_26;
    const double z_49 = cos_roll*a_;
    const double z_50 = sin_roll*drag;
    D[52] = z_49 + z_50;
    D[53] = -z_50;
    D[54] = -(z_49 - z_50);
    D[55] = -z_50;
    const double z_51 = roll_dot*z_34;
    const double z_52 = yaw_dot*yaw_dot;
    const double z_53 = z_52*(sin_pitch*cos_pitch);
    const double z_54 = z_51*z_43 + yaw_ddot*z_44 - z_51*z_37 - 2.0*z_40*z_32;
    D[58] = z_51 + z_53*z_37 + pitch_ddot*z_43 + z_54 - z_53;
    D[59] = z_53*z_43 + pitch_ddot*z_37 - z_54;
    D[60] = cos_roll*z_47;
    D[61] = sin_roll*z_48;
    D[66] = -a_;
    D[68] = a_;
    const double z_55 = z_52*z_41 + z_35*z_43 - z_42 - z_35*z_37;
    D[71] = -(z_35 + sin_pitch*yaw_ddot + z_55 - roll_ddot);
    D[72] = z_55;
    D[73] = -z_46;
    const double z_56 = L*L;
    const double z_57 = sway_ddot*(cos_heave*cos_heave);
    const double z_58 = z_56*(cos_heave*sin_heave);
    D[83] = z_56*z_57 + z_ddot*z_15 + x_ddot*z_17 + g*z_15 - 2.0*z_6*z_58;
    const double z_59 = load*L;
    const double z_60 = z_21*z_9;
    D[88] = 2.0*z_59*z_57 + z_ddot*z_23 + x_ddot*z_22 + g*z_23 - 4.0*z_6*z_60;
    D[89] = L*z_23;
    D[96] = heave_ddot*z_56 + z_ddot*z_10 + y_ddot*z_14 + g*z_10 + z_11*z_58 - x_ddot*z_18;
    D[101] = 2.0*heave_ddot*z_59 + z_ddot*z_24 + y_ddot*z_21 + g*z_24 + 2.0*z_11*z_60 - x_ddot*z_20;
    D[102] = load*z_10;
}

/* D (n_outputs, n + m + n_arguments), of the outputs by a, lambda and the arguments */
EM_RARE /* no explicit step calls it */
EM_ACROSS void output_partials(double t, const double *restrict x, const double *restrict v,
                               const double *restrict a, const double *restrict lambda,
                               const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_OUTPUTS * (N + N_ROWS + N_ARGUMENTS));
    const double load = c[1];
    const double heave = x[7];
    const double cos_heave = em_cos(heave);
    const double sway = x[6];
    const double sin_sway = em_sin(sway);
    const double z_2 = cos_heave*sin_sway;
    D[0] = -load*z_2;
    const double sin_heave = em_sin(heave);
    const double z_4 = load*sin_heave;
    D[1] = -z_4;
    const double cos_sway = em_cos(sway);
    const double z_6 = cos_heave*cos_sway;
    D[2] = load*z_6;
    const double sway_ddot = a[6];
    const double z_7 = cos_heave*cos_heave;
    const double L = c[6];
    const double z_8 = load*L;
    const double z_9 = z_7*z_8;
    const double z_10 = cos_sway*z_9;
    const double sway_dot = v[6];
    const double heave_dot = v[7];
    const double z_11 = sway_dot*heave_dot;
    const double z_12 = L*sin_heave;
    const double z_13 = cos_sway*z_12;
    const double z_14 = sway_dot*sway_dot;
    const double z_15 = L*z_2;
    const double z_16 = heave_dot*heave_dot;
    const double x_ddot = a[0];
    const double z_17 = L*z_6;
    const double heave_ddot = a[7];
    const double z_18 = sin_sway*z_12;
    const double z_19 = 2.0*z_11*z_13 + z_14*z_15 + z_16*z_15 + heave_ddot*z_18 - x_ddot - sway_ddot*z_17;
    const double z_20 = load*z_19;
    const double z_21 = sin_heave*z_8;
    const double z_22 = heave_ddot*z_21;
    const double z_23 = z_21*z_11;
    const double z_24 = sin_sway*z_9;
    const double g = c[7];
    const double z_ddot = a[2];
    const double z_25 = g + z_16*z_17 + z_14*z_17 + z_ddot + heave_ddot*z_13 + sway_ddot*z_15 - 2.0*z_11*z_18;
    const double z_26 = load*z_25;
    D[14] = cos_sway*(sway_ddot*z_10 + cos_heave*z_20 + z_22*z_2 + z_16*z_24 + z_14*z_24 - 2.0*z_6*z_23) -
        sin_sway*(cos_heave*z_26 + z_22*z_6 + z_14*z_10 + z_16*z_10 + 2.0*z_2*z_23 - sway_ddot*z_24);
    const double z_27 = cos_heave*z_8;
    const double y_ddot = a[1];
    const double z_28 = z_16*z_12 - y_ddot - L*cos_heave*heave_ddot;
    D[15] = cos_heave*(z_16*z_21 + heave_ddot*z_27 + load*z_28) + sin_heave*(z_22 - z_16*z_27 - z_14*z_27 -
        cos_sway*z_26 - sin_sway*z_20);
    D[22] = 2.0*(sway_dot*z_9);
    D[23] = 2.0*(heave_dot*z_8);
    const double z_29 = z_19*z_2;
    const double z_30 = z_25*z_6;
    D[29] = sin_heave*z_28 + z_29 + z_30;
    const double z_31 = 1.0/L;
    D[34] = -((z_28*z_21 + z_29*z_8 + z_30*z_8)/(L*L) - z_31*z_6*z_26 - z_31*z_2*z_20 - z_28*z_4*z_31 -
        load*z_14*z_7 - load*z_16);
    D[35] = load*z_6;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes drone_lanes;
EM_WEAK em_lanes drone_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 1, 1, 1, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 16, 50, 0, 25 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_IN_STATE, 41, 55, 30, 39 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double load = parameters[1];
    const double m = parameters[0];
    prepared[8] = load + m; /* c_0 */
    const double L = parameters[6];
    const double z_0 = load*L;
    prepared[9] = z_0; /* c_1 */
    const double z_1 = load*(L*L);
    prepared[10] = z_1; /* c_2 */
    const double J = parameters[2];
    const double J_up = parameters[3];
    const double z_2 = J - J_up;
    prepared[11] = z_2; /* c_3 */
    prepared[12] = 2.0*z_1; /* c_4 */
    prepared[13] = 2.0*z_2; /* c_5 */
    const double g = parameters[7];
    prepared[14] = load*g + m*g; /* c_6 */
    prepared[15] = g*z_0; /* c_7 */
    prepared[16] = 1.0/L; /* c_8 */
    prepared[17] = 2.0*L; /* c_9 */
    const double a_ = parameters[4];
    prepared[18] = 0.5*a_; /* c_10 */
    prepared[19] = 0.25*a_; /* c_11 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {62, "nonnegative"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {62, "nonnegative"},
    {60, "positive"},
    {63, ""},
    {63, ""},
    {63, ""},
    {63, ""},
    {63, ""},
    {63, ""},
    {63, ""},
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
    M[8] = M[1] = 0.0;
    M[9] = c_0;
    M[16] = M[2] = 0.0;
    M[17] = M[10] = 0.0;
    M[18] = c_0;
    M[24] = M[3] = 0.0;
    M[25] = M[11] = 0.0;
    M[26] = M[19] = 0.0;
    const double J = c[2];
    const double pitch = x[4];
    const double sin_pitch = em_sin(pitch);
    const double cos_pitch = em_cos(pitch);
    const double z_2 = cos_pitch*cos_pitch;
    const double roll = x[5];
    const double sin_roll = em_sin(roll);
    const double z_4 = sin_roll*sin_roll;
    const double J_up = c[3];
    const double cos_roll = em_cos(roll);
    const double z_6 = cos_roll*cos_roll;
    M[27] = J*(sin_pitch*sin_pitch) + J*z_2*z_4 + J_up*z_2*z_6;
    M[32] = M[4] = 0.0;
    M[33] = M[12] = 0.0;
    M[34] = M[20] = 0.0;
    const double c_3 = c[11];
    M[35] = M[28] = cos_pitch*sin_roll*cos_roll*c_3;
    M[36] = J*z_6 + J_up*z_4;
    M[40] = M[5] = 0.0;
    M[41] = M[13] = 0.0;
    M[42] = M[21] = 0.0;
    M[43] = M[29] = -J*sin_pitch;
    M[44] = M[37] = 0.0;
    M[45] = J;
    const double sway = x[6];
    const double cos_sway = em_cos(sway);
    const double heave = x[7];
    const double cos_heave = em_cos(heave);
    const double c_1 = c[9];
    const double z_9 = cos_heave*c_1;
    M[48] = M[6] = cos_sway*z_9;
    M[49] = M[14] = 0.0;
    const double sin_sway = em_sin(sway);
    M[50] = M[22] = sin_sway*z_9;
    M[51] = M[30] = 0.0;
    M[52] = M[38] = 0.0;
    M[53] = M[46] = 0.0;
    const double c_2 = c[10];
    M[54] = c_2*(cos_heave*cos_heave);
    const double sin_heave = em_sin(heave);
    const double z_12 = sin_heave*c_1;
    M[56] = M[7] = -sin_sway*z_12;
    M[57] = M[15] = z_9;
    M[58] = M[23] = cos_sway*z_12;
    M[59] = M[31] = 0.0;
    M[60] = M[39] = 0.0;
    M[61] = M[47] = 0.0;
    M[62] = M[55] = 0.0;
    M[63] = c_2;
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
    real M1[N1][N1], M2[N2][N2], shared[10];
    settled_masses(y, c, M1, M2, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;
    if (changed && em_settle_factors(&block2, *mode, 0, M2[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 50);
    gap = fmin(gap, em_gap(N2, y + 55));
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block2, *mode, y + N, y, c, memory, dy);
        real Mdot1[N1][N1], Mdot2[N2][N2];
        settled_rates(dy, c, shared, Mdot1, Mdot2);
        double time = em_time_of_block(&block1, Mdot1[0], y);
        time = fmin(time, em_time_of_block(&block2, Mdot2[0], y));
        wanted = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != wanted) {
        if (em_change_mode(&block1, wanted, M1[0], y, memory, fault)) return -1;
        if (em_change_mode(&block2, wanted, M2[0], y, memory, fault)) return -1;
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
    if (em_velocity_at(&block2, mode, M, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that an error e (n) of eta makes. */
EM_ACROSS void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, mode, e, y, c, memory, ev);
    em_velocity_kept(&block2, mode, e, y, c, memory, ev);
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
    em_publish_block(&block2, v, y, row);
    return 0;
}

/* y (n_state) from x, v (n); eigenfactors continuous with those y holds, if any */
EM_ACROSS int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    double C[N*N] = {0.0}, s[N], eta[N];
    em_spread(N, N1, coordinate1, y + 16, C);
    em_spread(N, N2, coordinate2, y + 41, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 16);
    for (int i = 0; i < N1; ++i) y[50 + i] = s[coordinate1[i]];
    em_gather(N, N2, coordinate2, C, y + 41);
    for (int i = 0; i < N2; ++i) y[55 + i] = s[coordinate2[i]];
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
    if (em_coincident_block(&block2, y, fault)) return -1;
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "drone.h"

static const char *const coordinate_names[] = { "x", "y", "z", "yaw", "pitch", "roll", "sway", "heave", NULL };
static const char *const parameter_names[] = { "m", "load", "J", "J_up", "a", "drag", "L", "g", NULL };
static const char *const input_names[] = { "f1", "f2", "f3", "f4", NULL };
static const char *const output_names[] = { "tension", NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.2, 0.4, 0.012, 0.022, 0.2, 0.016, 0.8, 9.81, 0.0 };
static const double input_defaults[] = { 3.9240000000000004, 3.9240000000000004, 3.9240000000000004, 3.9240000000000004,
    0.0 };
static const double initial_x[N] = { 0.0, 0.0, 1.0, 0.0, 0.0, 0.05, 0.5, 0.2 };
static const double initial_v[N] = { 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 1, 1, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"line", 0, 6},
    {"line", 6, 6},
    {"disk", 12, 7},
    {"disk", 19, 7},
    {"disk", 26, 7},
    {"disk", 33, 7},
    {"line", 40, 6},
    {"disk", 46, 4},
    {"trace", 50, 3}
};
static const em_slice layout[] = {
    {"x", 0, 8},
    {"eta", 8, 8},
    {"C", 16, 34},
    {"s", 50, 8}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dx, dM/dy, dM/dz, dM/dyaw: M does not depend on them",
    "C, mu, Omega across blocks: {x, y, z, sway, heave}, {yaw, pitch, roll} do not couple",
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
static int simulate(em_run *run) { return em_simulate(&drone_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&drone_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&drone_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&drone_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&drone_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&drone_model, run, mode); }

const em_model drone_model = {
    .abi = EM_ABI,
    .name = "drone",
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
    .event = model_events,
    .lanes = &drone_lanes,
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
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .output_partials = output_partials,
    .motion_along = em_motion_along,
    .dynamics = &dynamics,
    .declared = declared,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
