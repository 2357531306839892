/* eigenmotion generate andrews.py */
/* input sha256:771d14621a5f8d802c5503cd56f4fa403aba4e013c8e286a7a5a274fd30492b0 */
/* body sha256:da4b3082c807e67386e33b964ae0a1fa87166556ed45244f49df660076d7da8e */
/* andrews: equations of motion, eigenfactor formulation.
 *
 * State, 32 numbers:
 *   x    y[0 .. 7)
 *   eta  y[7 .. 14)
 *   C    y[14 .. 26)
 *   s    y[26 .. 32)
 *
 * Blocks of M that do not couple:
 *   1: beta, theta (C and s are states)
 *   2: gamma (constant, factored once per parameter set)
 *   3: phi, delta (C and s are states)
 *   4: omega, epsilon (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dbeta, dM/dgamma, dM/ddelta, dM/depsilon: M does not depend on them
 *   C, mu, Omega across blocks: {beta, theta}, {gamma}, {phi, delta}, {omega, epsilon} do not couple
 *   C, s, mu, Omega of {gamma}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 66 additions, 132 multiplications, 1 divisions, 1 roots, 14 function calls
 *   triangular root: 78 additions, 146 multiplications, 1 divisions, 1 roots, 14 function calls
 *   projection: 36 additions, 64 multiplications, 14 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 7,                /* coordinates */
    N_ROWS = 6,           /* constraint rows */
    N_POSITIONS = 6,      /* of which holonomic */
    N_STATE = 32,         /* numbers of a state */
    N_C = 12,             /* of which C, */
    N_S = 6,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 18,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 42,
    N_PREPARED = 88,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 43,         /* inputs, parameters and the time */
    N_ARGUMENTS = 57,     /* x, v and these: what motion depends on */
    N1 = 2,               /* beta, theta */
    N2 = 1,               /* gamma */
    N3 = 2,               /* phi, delta */
    N4 = 2,               /* omega, epsilon */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1 };
EM_UNUSED static const int coordinate2[N2] = { 2 };
EM_UNUSED static const int coordinate3[N3] = { 3, 4 };
EM_UNUSED static const int coordinate4[N4] = { 5, 6 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real Mdot3[N3][N3], real Mdot4[N4][N4], real f1[N1],
                                  real f2[N2], real f3[N3], real f4[N4], real A1[N_ROWS][N1],
                                  real A2[N_ROWS][N2], real A3[N_ROWS][N3], real A4[N_ROWS][N4],
                                  real gamma[N_ROWS])
{
    const real c_19 = c[65];
    const real theta_dot = v[1];
    const real theta = x[1];
    const real sin_theta = em_sin(theta);
    const real z_1 = theta_dot*sin_theta;
    const real c_2 = c[48];
    const real cos_theta = em_cos(theta);
    const real z_3 = cos_theta*z_1;
    const real rr = c[24];
    const real da = c[21];
    const real c_3 = c[49];
    const real z_4 = (rr - da*cos_theta)*c_3;
    const real c_20 = c[66];
    const real z_5 = (c_2*z_3 - z_1*z_4) - c_20*z_3;
    Mdot1[0][0] = c_19*z_1 - z_5;
    Mdot1[0][1] = Mdot1[1][0] = -z_5;
    Mdot1[1][1] = em_real(0.0);
    Mdot3[0][0] = em_real(0.0);
    const real c_6 = c[52];
    const real phi_dot = v[3];
    const real phi = x[3];
    const real cos_phi = em_cos(phi);
    const real z_7 = phi_dot*cos_phi;
    const real z_8 = c_6*z_7;
    Mdot3[0][1] = Mdot3[1][0] = -z_8;
    const real c_9 = c[55];
    const real sin_phi = em_sin(phi);
    const real z_10 = c_9*sin_phi;
    const real zt = c[37];
    const real c_7 = c[53];
    const real c_10 = c[56];
    const real z_11 = (zt - c_7*sin_phi)*c_10;
    const real c_21 = c[67];
    const real z_12 = sin_phi*c_21;
    Mdot3[1][1] = -(z_8 + z_7*z_12 - (z_7*z_10 - z_7*z_11));
    Mdot4[0][0] = em_real(0.0);
    const real c_13 = c[59];
    const real omega_dot = v[5];
    const real omega = x[5];
    const real cos_omega = em_cos(omega);
    const real z_14 = omega_dot*cos_omega;
    const real z_15 = c_13*z_14;
    Mdot4[0][1] = Mdot4[1][0] = -z_15;
    const real c_16 = c[62];
    const real sin_omega = em_sin(omega);
    const real z_17 = c_16*sin_omega;
    const real u_ = c[33];
    const real c_14 = c[60];
    const real c_17 = c[63];
    const real z_18 = (u_ - c_14*sin_omega)*c_17;
    const real c_22 = c[68];
    const real z_19 = sin_omega*c_22;
    Mdot4[1][1] = -(z_15 + z_14*z_19 - (z_14*z_17 - z_14*z_18));
    const real mom = c[41];
    f1[0] = mom;
    const real z_20 = cos_theta*sin_theta;
    const real z_21 = (c_2*z_20 - sin_theta*z_4) - c_20*z_20;
    const real beta_dot = v[0];
    f1[1] = 0.5*((sin_theta*c_19 - z_21)*(beta_dot*beta_dot) + 2.0*beta_dot*theta_dot*(-z_21));
    const real gamma_ = x[2];
    const real cos_gamma_ = em_cos(gamma_);
    const real c_23 = c[69];
    const real sin_gamma_ = em_sin(gamma_);
    const real sd = c[30];
    const real sc = c[29];
    const real c_24 = c[70];
    const real z_24 = sin_gamma_*sd + c_24 - cos_gamma_*sc;
    const real c_25 = c[71];
    const real z_25 = sin_gamma_*sc + cos_gamma_*sd + c_25;
    const real z_26 = sqrt(z_25*z_25 + z_24*z_24);
    const real l0 = c[40];
    const real z_27 = (z_26 - l0)/z_26;
    const real z_28 = z_24*z_27;
    const real c_26 = c[72];
    const real z_29 = z_25*z_27;
    f2[0] = -(cos_gamma_*(c_23*z_28 + c_26*z_29) + sin_gamma_*(c_26*z_28 - c_23*z_29));
    const real delta_dot = v[4];
    const real c_27 = c[73];
    f3[0] = (-0.5)*((c_6*cos_phi + cos_phi*z_12 - (cos_phi*z_10 - cos_phi*z_11))*(delta_dot*delta_dot) +
        c_27*(delta_dot*z_7));
    f3[1] = em_real(0.0);
    const real epsilon_dot = v[6];
    const real c_28 = c[74];
    f4[0] = (-0.5)*((c_13*cos_omega + cos_omega*z_19 - (cos_omega*z_17 -
        cos_omega*z_18))*(epsilon_dot*epsilon_dot) + c_28*(epsilon_dot*z_14));
    f4[1] = em_real(0.0);
    const real beta = x[0];
    const real sin_beta = em_sin(beta);
    const real d = c[20];
    const real cos_beta = em_cos(beta);
    const real z_32 = sin_theta*cos_beta + cos_theta*sin_beta;
    const real z_33 = d*z_32;
    A1[0][0] = -(rr*sin_beta - z_33);
    A1[0][1] = z_33;
    const real z_34 = cos_theta*cos_beta - sin_theta*sin_beta;
    const real z_35 = d*z_34;
    A1[1][0] = rr*cos_beta - z_35;
    A1[1][1] = -z_35;
    A1[2][0] = -(rr*sin_beta - z_33);
    A1[2][1] = z_33;
    A1[3][0] = rr*cos_beta - z_35;
    A1[3][1] = -z_35;
    A1[4][0] = -(rr*sin_beta - z_33);
    A1[4][1] = z_33;
    A1[5][0] = rr*cos_beta - z_35;
    A1[5][1] = -z_35;
    const real ss = c[26];
    const real z_36 = ss*cos_gamma_;
    A2[0][0] = -z_36;
    const real z_37 = ss*sin_gamma_;
    A2[1][0] = -z_37;
    A2[2][0] = em_real(0.0);
    A2[3][0] = em_real(0.0);
    A2[4][0] = em_real(0.0);
    A2[5][0] = em_real(0.0);
    A3[0][0] = em_real(0.0);
    A3[0][1] = em_real(0.0);
    A3[1][0] = em_real(0.0);
    A3[1][1] = em_real(0.0);
    const real e = c[22];
    const real delta = x[4];
    const real cos_delta = em_cos(delta);
    const real sin_delta = em_sin(delta);
    const real z_40 = cos_phi*cos_delta - sin_phi*sin_delta;
    const real z_41 = e*z_40;
    A3[2][0] = -z_41;
    A3[2][1] = zt*sin_delta - z_41;
    const real z_42 = sin_phi*cos_delta + cos_phi*sin_delta;
    const real z_43 = e*z_42;
    A3[3][0] = -z_43;
    A3[3][1] = -(zt*cos_delta + z_43);
    A3[4][0] = em_real(0.0);
    A3[4][1] = em_real(0.0);
    A3[5][0] = em_real(0.0);
    A3[5][1] = em_real(0.0);
    A4[0][0] = em_real(0.0);
    A4[0][1] = em_real(0.0);
    A4[1][0] = em_real(0.0);
    A4[1][1] = em_real(0.0);
    A4[2][0] = em_real(0.0);
    A4[2][1] = em_real(0.0);
    A4[3][0] = em_real(0.0);
    A4[3][1] = em_real(0.0);
    const real zf = c[36];
    const real epsilon = x[6];
    const real cos_epsilon = em_cos(epsilon);
    const real sin_epsilon = em_sin(epsilon);
    const real z_46 = sin_omega*cos_epsilon + cos_omega*sin_epsilon;
    const real z_47 = zf*z_46;
    A4[4][0] = z_47;
    A4[4][1] = -(u_*cos_epsilon - z_47);
    const real z_48 = cos_omega*cos_epsilon - sin_omega*sin_epsilon;
    const real z_49 = zf*z_48;
    A4[5][0] = -z_49;
    A4[5][1] = -(u_*sin_epsilon + z_49);
    const real gamma_dot = v[2];
    const real z_50 = gamma_dot*gamma_dot;
    const real z_51 = beta_dot*rr;
    const real z_52 = d*(beta_dot + theta_dot);
    const real z_53 = theta_dot*z_52;
    const real z_54 = beta_dot*(cos_beta*z_51 - z_34*z_52) - z_34*z_53;
    gamma[0] = z_37*z_50 - z_54;
    const real z_55 = beta_dot*(sin_beta*z_51 - z_32*z_52) - z_32*z_53;
    gamma[1] = -(z_36*z_50 + z_55);
    const real z_56 = e*(phi_dot + delta_dot);
    const real z_57 = phi_dot*z_56;
    const real z_58 = delta_dot*zt;
    gamma[2] = -(z_54 - z_42*z_57 - delta_dot*(cos_delta*z_58 + z_42*z_56));
    gamma[3] = -(z_40*z_57 + z_55 - delta_dot*(sin_delta*z_58 - z_40*z_56));
    const real z_59 = zf*(omega_dot + epsilon_dot);
    const real z_60 = omega_dot*z_59;
    const real z_61 = epsilon_dot*u_;
    gamma[4] = -(z_54 - z_48*z_60 - epsilon_dot*(sin_epsilon*z_61 + z_48*z_59));
    gamma[5] = -(epsilon_dot*(cos_epsilon*z_61 - z_46*z_59) + z_55 - z_46*z_60);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* beta, theta: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[7], y[8] };
    const real *const C1 = y + 14, *const s1 = y + 26;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    /* gamma: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[9] };
    const real *const C2 = c + 42, *const s2 = c + 43;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[2] = v2[0];

    /* phi, delta: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[10], y[11] };
    const real *const C3 = y + 18, *const s3 = y + 28;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[3] = v3[0];
    dy[4] = v3[1];

    /* omega, epsilon: xdot = C^T S^-1 eta (20) */
    const real eta4[N4] = { y[12], y[13] };
    const real *const C4 = y + 22, *const s4 = y + 30;
    real r4[N4], w4[N4], v4[N4];
    em_velocity(N4, C4, s4, eta4, r4, w4, v4);
    dy[5] = v4[0];
    dy[6] = v4[1];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* beta, theta: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[7], y[8] };
    const real *const C1 = y + 14, *const s1 = y + 26;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    /* gamma: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[9] };
    const real *const C2 = c + 42, *const s2 = c + 43;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[2] = v2[0];

    /* phi, delta: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[10], y[11] };
    const real *const C3 = y + 18, *const s3 = y + 28;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[3] = v3[0];
    dy[4] = v3[1];

    /* omega, epsilon: xdot = C^T S^-1 eta (20) */
    const real eta4[N4] = { y[12], y[13] };
    const real *const C4 = y + 22, *const s4 = y + 30;
    real r4[N4], w4[N4], v4[N4];
    em_velocity(N4, C4, s4, eta4, r4, w4, v4);
    dy[5] = v4[0];
    dy[6] = v4[1];

    real Mdot1[N1][N1], Mdot3[N3][N3], Mdot4[N4][N4], f1[N1], f2[N2], f3[N3], f4[N4], A1[N_ROWS][N1],
         A2[N_ROWS][N2], A3[N_ROWS][N3], A4[N_ROWS][N4], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, Mdot3, Mdot4, f1, f2, f3, f4, A1, A2, A3, A4, gamma);

    /* beta, theta: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* gamma: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* phi, delta: B = A C^T S^-1 (28) */
    real B3[N_ROWS][N3];
    em_rows_on_eta(N_ROWS, N3, C3, r3, A3[0], B3[0]);

    /* omega, epsilon: B = A C^T S^-1 (28) */
    real B4[N_ROWS][N4];
    em_rows_on_eta(N_ROWS, N4, C4, r4, A4[0], B4[0]);

    /* beta, theta: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 14, *const s1_dot = dy + 26;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a1[N1], q1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, q1);

    /* gamma: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* phi, delta: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T3[N3*N3], mu3[N3*N3], Omega3[N3*N3];
    em_turned_for_tiles(N3, C3, T3);
    em_congruence_below(N3, C3, T3, Mdot3[0], mu3);
    em_omega_apart(N3, s3, mu3, Omega3);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C3_dot = dy + 18, *const s3_dot = dy + 28;
    em_factor_rates(N3, C3, r3, mu3, Omega3, C3_dot, s3_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a3[N3], q3[N3];
    em_turning_push(N3, C3, T3, s3, r3, Omega3, s3_dot, eta3, w3, f3, a3, q3);

    /* omega, epsilon: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T4[N4*N4], mu4[N4*N4], Omega4[N4*N4];
    em_turned_for_tiles(N4, C4, T4);
    em_congruence_below(N4, C4, T4, Mdot4[0], mu4);
    em_omega_apart(N4, s4, mu4, Omega4);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C4_dot = dy + 22, *const s4_dot = dy + 30;
    em_factor_rates(N4, C4, r4, mu4, Omega4, C4_dot, s4_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a4[N4], q4[N4];
    em_turning_push(N4, C4, T4, s4, r4, Omega4, s4_dot, eta4, w4, f4, a4, q4);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        em_add_to_load(N3, row, B3[0], a3, q3, lambda);
        em_add_to_load(N4, row, B4[0], a4, q4, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
            em_add_product(N3, B3[row], B3[column], &Delta[row*N_ROWS + column]);
            em_add_product(N4, B4[row], B4[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[7] = a1[0];
    dy[8] = a1[1];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[9] = a2[0];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    dy[10] = a3[0];
    dy[11] = a3[1];
    em_subtract_reactions(N_ROWS, N4, B4[0], lambda, a4);
    dy[12] = a4[0];
    dy[13] = a4[1];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real M3[N3][N3], real M4[N4][N4], real shared[9])
{
    const real rr = c[24];
    const real da = c[21];
    const real theta = x[1];
    const real cos_theta = em_cos(theta);
    const real z_1 = rr - da*cos_theta;
    const real c_0 = c[46];
    const real c_1 = c[47];
    const real c_2 = c[48];
    const real sin_theta = em_sin(theta);
    const real c_3 = c[49];
    const real z_3 = z_1*c_3;
    const real z_4 = c_2*(sin_theta*sin_theta) - cos_theta*z_3;
    M1[0][0] = z_1*c_0 + c_1 + z_4;
    const real I2 = c[8];
    M1[1][0] = I2 + z_4;
    const real c_4 = c[50];
    M1[1][1] = c_4;
    const real c_5 = c[51];
    M3[0][0] = c_5;
    const real phi = x[3];
    const real sin_phi = em_sin(phi);
    const real c_6 = c[52];
    M3[1][0] = c_5 - sin_phi*c_6;
    const real zt = c[37];
    const real c_7 = c[53];
    const real z_6 = zt - c_7*sin_phi;
    const real c_8 = c[54];
    const real c_9 = c[55];
    const real cos_phi = em_cos(phi);
    const real c_10 = c[56];
    const real z_8 = z_6*c_10;
    const real c_11 = c[57];
    M3[1][1] = z_6*c_8 + c_9*(cos_phi*cos_phi) + c_11 - sin_phi*z_8;
    const real c_12 = c[58];
    M4[0][0] = c_12;
    const real omega = x[5];
    const real sin_omega = em_sin(omega);
    const real c_13 = c[59];
    M4[1][0] = c_12 - sin_omega*c_13;
    const real u_ = c[33];
    const real c_14 = c[60];
    const real z_10 = u_ - c_14*sin_omega;
    const real c_15 = c[61];
    const real c_16 = c[62];
    const real cos_omega = em_cos(omega);
    const real c_17 = c[63];
    const real z_12 = z_10*c_17;
    const real c_18 = c[64];
    M4[1][1] = z_10*c_15 + c_16*(cos_omega*cos_omega) + c_18 - sin_omega*z_12;
    shared[0] = sin_theta;
    shared[1] = cos_theta;
    shared[2] = z_3;
    shared[3] = cos_phi;
    shared[4] = sin_phi;
    shared[5] = z_8;
    shared[6] = cos_omega;
    shared[7] = sin_omega;
    shared[8] = z_12;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[9], real Mdot1[N1][N1], real Mdot3[N3][N3],
                                 real Mdot4[N4][N4], real f1[N1], real f2[N2], real f3[N3], real f4[N4],
                                 real A1[N_ROWS][N1], real A2[N_ROWS][N2], real A3[N_ROWS][N3],
                                 real A4[N_ROWS][N4], real gamma[N_ROWS])
{
    const real c_19 = c[65];
    const real theta_dot = v[1];
    const real sin_theta = shared[0];
    const real z_13 = theta_dot*sin_theta;
    const real c_2 = c[48];
    const real cos_theta = shared[1];
    const real z_14 = cos_theta*z_13;
    const real z_3 = shared[2];
    const real c_20 = c[66];
    const real z_15 = (c_2*z_14 - z_13*z_3) - c_20*z_14;
    Mdot1[0][0] = c_19*z_13 - z_15;
    Mdot1[0][1] = Mdot1[1][0] = -z_15;
    Mdot1[1][1] = em_real(0.0);
    Mdot3[0][0] = em_real(0.0);
    const real c_6 = c[52];
    const real phi_dot = v[3];
    const real cos_phi = shared[3];
    const real z_16 = phi_dot*cos_phi;
    const real z_17 = c_6*z_16;
    Mdot3[0][1] = Mdot3[1][0] = -z_17;
    const real c_9 = c[55];
    const real sin_phi = shared[4];
    const real z_18 = c_9*sin_phi;
    const real z_8 = shared[5];
    const real c_21 = c[67];
    const real z_19 = sin_phi*c_21;
    Mdot3[1][1] = -(z_17 + z_16*z_19 - (z_16*z_18 - z_16*z_8));
    Mdot4[0][0] = em_real(0.0);
    const real c_13 = c[59];
    const real omega_dot = v[5];
    const real cos_omega = shared[6];
    const real z_20 = omega_dot*cos_omega;
    const real z_21 = c_13*z_20;
    Mdot4[0][1] = Mdot4[1][0] = -z_21;
    const real c_16 = c[62];
    const real sin_omega = shared[7];
    const real z_22 = c_16*sin_omega;
    const real z_12 = shared[8];
    const real c_22 = c[68];
    const real z_23 = sin_omega*c_22;
    Mdot4[1][1] = -(z_21 + z_20*z_23 - (z_20*z_22 - z_20*z_12));
    const real mom = c[41];
    f1[0] = mom;
    const real z_24 = cos_theta*sin_theta;
    const real z_25 = (c_2*z_24 - sin_theta*z_3) - c_20*z_24;
    const real beta_dot = v[0];
    f1[1] = 0.5*((sin_theta*c_19 - z_25)*(beta_dot*beta_dot) + 2.0*beta_dot*theta_dot*(-z_25));
    const real gamma_ = x[2];
    const real cos_gamma_ = em_cos(gamma_);
    const real c_23 = c[69];
    const real sin_gamma_ = em_sin(gamma_);
    const real sd = c[30];
    const real sc = c[29];
    const real c_24 = c[70];
    const real z_28 = sin_gamma_*sd + c_24 - cos_gamma_*sc;
    const real c_25 = c[71];
    const real z_29 = sin_gamma_*sc + cos_gamma_*sd + c_25;
    const real z_30 = sqrt(z_29*z_29 + z_28*z_28);
    const real l0 = c[40];
    const real z_31 = (z_30 - l0)/z_30;
    const real z_32 = z_28*z_31;
    const real c_26 = c[72];
    const real z_33 = z_29*z_31;
    f2[0] = -(cos_gamma_*(c_23*z_32 + c_26*z_33) + sin_gamma_*(c_26*z_32 - c_23*z_33));
    const real delta_dot = v[4];
    const real c_27 = c[73];
    f3[0] = (-0.5)*((c_6*cos_phi + cos_phi*z_19 - (cos_phi*z_18 - cos_phi*z_8))*(delta_dot*delta_dot) +
        c_27*(delta_dot*z_16));
    f3[1] = em_real(0.0);
    const real epsilon_dot = v[6];
    const real c_28 = c[74];
    f4[0] = (-0.5)*((c_13*cos_omega + cos_omega*z_23 - (cos_omega*z_22 -
        cos_omega*z_12))*(epsilon_dot*epsilon_dot) + c_28*(epsilon_dot*z_20));
    f4[1] = em_real(0.0);
    const real rr = c[24];
    const real beta = x[0];
    const real sin_beta = em_sin(beta);
    const real d = c[20];
    const real cos_beta = em_cos(beta);
    const real z_36 = sin_theta*cos_beta + cos_theta*sin_beta;
    const real z_37 = d*z_36;
    A1[0][0] = -(rr*sin_beta - z_37);
    A1[0][1] = z_37;
    const real z_38 = cos_theta*cos_beta - sin_theta*sin_beta;
    const real z_39 = d*z_38;
    A1[1][0] = rr*cos_beta - z_39;
    A1[1][1] = -z_39;
    A1[2][0] = -(rr*sin_beta - z_37);
    A1[2][1] = z_37;
    A1[3][0] = rr*cos_beta - z_39;
    A1[3][1] = -z_39;
    A1[4][0] = -(rr*sin_beta - z_37);
    A1[4][1] = z_37;
    A1[5][0] = rr*cos_beta - z_39;
    A1[5][1] = -z_39;
    const real ss = c[26];
    const real z_40 = ss*cos_gamma_;
    A2[0][0] = -z_40;
    const real z_41 = ss*sin_gamma_;
    A2[1][0] = -z_41;
    A2[2][0] = em_real(0.0);
    A2[3][0] = em_real(0.0);
    A2[4][0] = em_real(0.0);
    A2[5][0] = em_real(0.0);
    A3[0][0] = em_real(0.0);
    A3[0][1] = em_real(0.0);
    A3[1][0] = em_real(0.0);
    A3[1][1] = em_real(0.0);
    const real e = c[22];
    const real delta = x[4];
    const real cos_delta = em_cos(delta);
    const real sin_delta = em_sin(delta);
    const real z_44 = cos_phi*cos_delta - sin_phi*sin_delta;
    const real z_45 = e*z_44;
    A3[2][0] = -z_45;
    const real zt = c[37];
    A3[2][1] = zt*sin_delta - z_45;
    const real z_46 = sin_phi*cos_delta + cos_phi*sin_delta;
    const real z_47 = e*z_46;
    A3[3][0] = -z_47;
    A3[3][1] = -(zt*cos_delta + z_47);
    A3[4][0] = em_real(0.0);
    A3[4][1] = em_real(0.0);
    A3[5][0] = em_real(0.0);
    A3[5][1] = em_real(0.0);
    A4[0][0] = em_real(0.0);
    A4[0][1] = em_real(0.0);
    A4[1][0] = em_real(0.0);
    A4[1][1] = em_real(0.0);
    A4[2][0] = em_real(0.0);
    A4[2][1] = em_real(0.0);
    A4[3][0] = em_real(0.0);
    A4[3][1] = em_real(0.0);
    const real zf = c[36];
    const real epsilon = x[6];
    const real cos_epsilon = em_cos(epsilon);
    const real sin_epsilon = em_sin(epsilon);
    const real z_50 = sin_omega*cos_epsilon + cos_omega*sin_epsilon;
    const real z_51 = zf*z_50;
    A4[4][0] = z_51;
    const real u_ = c[33];
    A4[4][1] = -(u_*cos_epsilon - z_51);
    const real z_52 = cos_omega*cos_epsilon - sin_omega*sin_epsilon;
    const real z_53 = zf*z_52;
    A4[5][0] = -z_53;
    A4[5][1] = -(u_*sin_epsilon + z_53);
    const real gamma_dot = v[2];
    const real z_54 = gamma_dot*gamma_dot;
    const real z_55 = beta_dot*rr;
    const real z_56 = d*(beta_dot + theta_dot);
    const real z_57 = theta_dot*z_56;
    const real z_58 = beta_dot*(cos_beta*z_55 - z_38*z_56) - z_38*z_57;
    gamma[0] = z_41*z_54 - z_58;
    const real z_59 = beta_dot*(sin_beta*z_55 - z_36*z_56) - z_36*z_57;
    gamma[1] = -(z_40*z_54 + z_59);
    const real z_60 = e*(phi_dot + delta_dot);
    const real z_61 = phi_dot*z_60;
    const real z_62 = delta_dot*zt;
    gamma[2] = -(z_58 - z_46*z_61 - delta_dot*(cos_delta*z_62 + z_46*z_60));
    gamma[3] = -(z_44*z_61 + z_59 - delta_dot*(sin_delta*z_62 - z_44*z_60));
    const real z_63 = zf*(omega_dot + epsilon_dot);
    const real z_64 = omega_dot*z_63;
    const real z_65 = epsilon_dot*u_;
    gamma[4] = -(z_58 - z_52*z_64 - epsilon_dot*(sin_epsilon*z_65 + z_52*z_63));
    gamma[5] = -(epsilon_dot*(cos_epsilon*z_65 - z_50*z_63) + z_59 - z_50*z_64);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], M3[N3][N3], M4[N4][N4], shared[9];
    triangular_masses(y, c, M1, M3, M4, shared);

    /* beta, theta: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[7], y[8] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    /* gamma: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[9] };
    const real *const C2 = c + 42, *const s2 = c + 43;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[2] = v2[0];

    /* phi, delta: M = L L^T */
    real L3[N3][N3], r3[N3];
    const int singular3 = em_cholesky(N3, M3[0], L3[0], r3, EM_SINGULAR_PIVOT);
    if (singular3 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate3[singular3], -1, 0.0);
    const real eta3[N3] = { y[10], y[11] };
    real v3[N3];
    em_copy(N3, eta3, v3);
    em_backward(N3, L3[0], r3, v3);
    dy[3] = v3[0];
    dy[4] = v3[1];

    /* omega, epsilon: M = L L^T */
    real L4[N4][N4], r4[N4];
    const int singular4 = em_cholesky(N4, M4[0], L4[0], r4, EM_SINGULAR_PIVOT);
    if (singular4 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate4[singular4], -1, 0.0);
    const real eta4[N4] = { y[12], y[13] };
    real v4[N4];
    em_copy(N4, eta4, v4);
    em_backward(N4, L4[0], r4, v4);
    dy[5] = v4[0];
    dy[6] = v4[1];

    real Mdot1[N1][N1], Mdot3[N3][N3], Mdot4[N4][N4], f1[N1], f2[N2], f3[N3], f4[N4], A1[N_ROWS][N1],
         A2[N_ROWS][N2], A3[N_ROWS][N3], A4[N_ROWS][N4], gamma[N_ROWS];
    triangular_motion(y, dy, c, shared, Mdot1, Mdot3, Mdot4, f1, f2, f3, f4, A1, A2, A3, A4, gamma);

    /* beta, theta: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* gamma: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* phi, delta: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a3[N3], q3[N3];
    em_triangular_push(N3, L3[0], r3, Mdot3[0], eta3, f3, a3, q3);

    /* omega, epsilon: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a4[N4], q4[N4];
    em_triangular_push(N4, L4[0], r4, Mdot4[0], eta4, f4, a4, q4);

    /* beta, theta: B = A L^-T */
    real B1[N_ROWS][N1];
    em_rows_of_root(N_ROWS, N1, L1[0], r1, A1[0], B1[0]);
    /* gamma: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);
    /* phi, delta: B = A L^-T */
    real B3[N_ROWS][N3];
    em_rows_of_root(N_ROWS, N3, L3[0], r3, A3[0], B3[0]);
    /* omega, epsilon: B = A L^-T */
    real B4[N_ROWS][N4];
    em_rows_of_root(N_ROWS, N4, L4[0], r4, A4[0], B4[0]);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        em_add_to_load(N3, row, B3[0], a3, q3, lambda);
        em_add_to_load(N4, row, B4[0], a4, q4, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
            em_add_product(N3, B3[row], B3[column], &Delta[row*N_ROWS + column]);
            em_add_product(N4, B4[row], B4[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[7] = a1[0];
    dy[8] = a1[1];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[9] = a2[0];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    dy[10] = a3[0];
    dy[11] = a3[1];
    em_subtract_reactions(N_ROWS, N4, B4[0], lambda, a4);
    dy[12] = a4[0];
    dy[13] = a4[1];
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

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1] };
    if (mode) em_backward(N1, memory + 0, memory + 4, v1);
    else em_velocity_of_eta(N1, y + 14, y + 26, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    real v2[N2] = { e[2] };
    em_velocity_of_eta(N2, c + 42, c + 43, v2);
    v[2] = v2[0];
    real v3[N3] = { e[3], e[4] };
    if (mode) em_backward(N3, memory + 6, memory + 10, v3);
    else em_velocity_of_eta(N3, y + 18, y + 28, v3);
    v[3] = v3[0];
    v[4] = v3[1];
    real v4[N4] = { e[5], e[6] };
    if (mode) em_backward(N4, memory + 12, memory + 16, v4);
    else em_velocity_of_eta(N4, y + 22, y + 30, v4);
    v[5] = v4[0];
    v[6] = v4[1];
}

#define EM_VELOCITY velocity_by_roots

#include "em_flock.h"
#endif

extern em_lanes andrews_lanes;
em_lanes andrews_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double mom = c[41];
    const double beta_dot = v[0];
    const double c_19 = c[65];
    const double theta_dot = v[1];
    const double theta = x[1];
    const double sin_theta = em_sin(theta);
    const double z_1 = theta_dot*sin_theta;
    const double c_2 = c[48];
    const double cos_theta = em_cos(theta);
    const double z_3 = cos_theta*z_1;
    const double rr = c[24];
    const double da = c[21];
    const double c_3 = c[49];
    const double z_4 = (rr - da*cos_theta)*c_3;
    const double c_20 = c[66];
    const double z_5 = (c_2*z_3 - z_1*z_4) - c_20*z_3;
    const double z_6 = -z_5;
    bias[0] = mom - (beta_dot*(c_19*z_1 - z_5) + theta_dot*z_6);
    const double z_7 = cos_theta*sin_theta;
    const double z_8 = (c_2*z_7 - sin_theta*z_4) - c_20*z_7;
    bias[1] = 0.5*(((sin_theta*c_19 - z_8)*(beta_dot*beta_dot) + 2.0*beta_dot*theta_dot*(-z_8)) -
        2.0*beta_dot*z_6);
    const double gamma_ = x[2];
    const double cos_gamma_ = em_cos(gamma_);
    const double c_23 = c[69];
    const double sin_gamma_ = em_sin(gamma_);
    const double sd = c[30];
    const double sc = c[29];
    const double c_24 = c[70];
    const double z_11 = sin_gamma_*sd + c_24 - cos_gamma_*sc;
    const double c_25 = c[71];
    const double z_12 = sin_gamma_*sc + cos_gamma_*sd + c_25;
    const double z_13 = sqrt(z_12*z_12 + z_11*z_11);
    const double l0 = c[40];
    const double z_14 = (z_13 - l0)/z_13;
    const double z_15 = z_11*z_14;
    const double c_26 = c[72];
    const double z_16 = z_12*z_14;
    bias[2] = -(cos_gamma_*(c_23*z_15 + c_26*z_16) + sin_gamma_*(c_26*z_15 - c_23*z_16));
    const double c_6 = c[52];
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double z_18 = c_6*cos_phi;
    const double c_9 = c[55];
    const double sin_phi = em_sin(phi);
    const double z_20 = c_9*sin_phi;
    const double zt = c[37];
    const double c_7 = c[53];
    const double c_10 = c[56];
    const double z_21 = (zt - c_7*sin_phi)*c_10;
    const double c_21 = c[67];
    const double z_22 = sin_phi*c_21;
    const double delta_dot = v[4];
    const double c_27 = c[73];
    const double phi_dot = v[3];
    const double z_23 = phi_dot*cos_phi;
    const double z_24 = c_27*(delta_dot*z_23);
    bias[3] = 0.5*(z_24 - ((z_18 + cos_phi*z_22 - (cos_phi*z_20 - cos_phi*z_21))*(delta_dot*delta_dot) + z_24));
    bias[4] = z_18*(phi_dot*phi_dot) + delta_dot*(c_6*z_23 + z_23*z_22 - (z_23*z_20 - z_23*z_21));
    const double c_13 = c[59];
    const double omega = x[5];
    const double cos_omega = em_cos(omega);
    const double z_26 = c_13*cos_omega;
    const double c_16 = c[62];
    const double sin_omega = em_sin(omega);
    const double z_28 = c_16*sin_omega;
    const double u_ = c[33];
    const double c_14 = c[60];
    const double c_17 = c[63];
    const double z_29 = (u_ - c_14*sin_omega)*c_17;
    const double c_22 = c[68];
    const double z_30 = sin_omega*c_22;
    const double epsilon_dot = v[6];
    const double c_28 = c[74];
    const double omega_dot = v[5];
    const double z_31 = omega_dot*cos_omega;
    const double z_32 = c_28*(epsilon_dot*z_31);
    bias[5] = 0.5*(z_32 - ((z_26 + cos_omega*z_30 - (cos_omega*z_28 - cos_omega*z_29))*(epsilon_dot*epsilon_dot) +
        z_32));
    bias[6] = z_26*(omega_dot*omega_dot) + epsilon_dot*(c_13*z_31 + z_31*z_30 - (z_31*z_28 - z_31*z_29));
    const double ss = c[26];
    const double gamma_dot = v[2];
    const double z_33 = ss*(gamma_dot*gamma_dot);
    const double beta = x[0];
    const double cos_beta = em_cos(beta);
    const double z_35 = beta_dot*rr;
    const double sin_beta = em_sin(beta);
    const double z_37 = cos_theta*cos_beta - sin_theta*sin_beta;
    const double d = c[20];
    const double z_38 = d*(beta_dot + theta_dot);
    const double z_39 = theta_dot*z_38;
    const double z_40 = beta_dot*(cos_beta*z_35 - z_37*z_38) - z_37*z_39;
    gamma[0] = sin_gamma_*z_33 - z_40;
    const double z_41 = sin_theta*cos_beta + cos_theta*sin_beta;
    const double z_42 = beta_dot*(sin_beta*z_35 - z_41*z_38) - z_41*z_39;
    gamma[1] = -(cos_gamma_*z_33 + z_42);
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    const double sin_delta = em_sin(delta);
    const double z_45 = sin_phi*cos_delta + cos_phi*sin_delta;
    const double e = c[22];
    const double z_46 = e*(phi_dot + delta_dot);
    const double z_47 = phi_dot*z_46;
    const double z_48 = delta_dot*zt;
    gamma[2] = -(z_40 - z_45*z_47 - delta_dot*(cos_delta*z_48 + z_45*z_46));
    const double z_49 = cos_phi*cos_delta - sin_phi*sin_delta;
    gamma[3] = -(z_49*z_47 + z_42 - delta_dot*(sin_delta*z_48 - z_49*z_46));
    const double epsilon = x[6];
    const double cos_epsilon = em_cos(epsilon);
    const double sin_epsilon = em_sin(epsilon);
    const double z_52 = cos_omega*cos_epsilon - sin_omega*sin_epsilon;
    const double zf = c[36];
    const double z_53 = zf*(omega_dot + epsilon_dot);
    const double z_54 = omega_dot*z_53;
    const double z_55 = epsilon_dot*u_;
    gamma[4] = -(z_40 - z_52*z_54 - epsilon_dot*(sin_epsilon*z_55 + z_52*z_53));
    const double z_56 = sin_omega*cos_epsilon + cos_omega*sin_epsilon;
    gamma[5] = -(epsilon_dot*(cos_epsilon*z_55 - z_56*z_53) + z_42 - z_56*z_54);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double beta_dot = v[0];
    const double rr = c[24];
    const double da = c[21];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double z_1 = rr - da*cos_theta;
    const double c_0 = c[46];
    const double c_1 = c[47];
    const double c_2 = c[48];
    const double sin_theta = em_sin(theta);
    const double c_3 = c[49];
    const double z_3 = c_2*(sin_theta*sin_theta) - cos_theta*z_1*c_3;
    const double theta_dot = v[1];
    const double I2 = c[8];
    const double z_4 = I2 + z_3;
    const double c_4 = c[50];
    const double c_29 = c[75];
    const double gamma_dot = v[2];
    const double phi_dot = v[3];
    const double c_5 = c[51];
    const double delta_dot = v[4];
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double c_6 = c[52];
    const double z_6 = c_5 - sin_phi*c_6;
    const double zt = c[37];
    const double c_7 = c[53];
    const double z_7 = zt - c_7*sin_phi;
    const double c_8 = c[54];
    const double c_9 = c[55];
    const double cos_phi = em_cos(phi);
    const double c_10 = c[56];
    const double c_11 = c[57];
    const double omega_dot = v[5];
    const double c_12 = c[58];
    const double epsilon_dot = v[6];
    const double omega = x[5];
    const double sin_omega = em_sin(omega);
    const double c_13 = c[59];
    const double z_10 = c_12 - sin_omega*c_13;
    const double u_ = c[33];
    const double c_14 = c[60];
    const double z_11 = u_ - c_14*sin_omega;
    const double c_15 = c[61];
    const double c_16 = c[62];
    const double cos_omega = em_cos(omega);
    const double c_17 = c[63];
    const double c_18 = c[64];
    e[0] = 0.5*(beta_dot*(beta_dot*(z_1*c_0 + c_1 + z_3) + theta_dot*z_4) + theta_dot*(beta_dot*z_4 +
        theta_dot*c_4) + c_29*(gamma_dot*gamma_dot) + phi_dot*(phi_dot*c_5 + delta_dot*z_6) +
        delta_dot*(phi_dot*z_6 + delta_dot*(z_7*c_8 + c_9*(cos_phi*cos_phi) + c_11 - sin_phi*z_7*c_10)) +
        omega_dot*(omega_dot*c_12 + epsilon_dot*z_10) + epsilon_dot*(omega_dot*z_10 + epsilon_dot*(z_11*c_15 +
        c_16*(cos_omega*cos_omega) + c_18 - sin_omega*z_11*c_17)));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c0 = c[39];
    const double gamma = x[2];
    const double sin_gamma = em_sin(gamma);
    const double sc = c[29];
    const double cos_gamma = em_cos(gamma);
    const double sd = c[30];
    const double c_25 = c[71];
    const double z_15 = sin_gamma*sc + cos_gamma*sd + c_25;
    const double c_24 = c[70];
    const double z_16 = sin_gamma*sd + c_24 - cos_gamma*sc;
    const double l0 = c[40];
    const double z_17 = sqrt(z_15*z_15 + z_16*z_16) - l0;
    const double beta = x[0];
    const double c_41 = c[87];
    e[3] = 0.5*(c0*(z_17*z_17) - beta*c_41);
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
    p[0] = p[1] = p[16] = p[17] = 0.0;
    const double xa = c[14];
    p[2] = p[24] = p[32] = xa;
    const double ya = c[15];
    p[3] = p[25] = p[33] = ya;
    const double xb = c[16];
    p[4] = p[10] = xb;
    const double yb = c[17];
    p[5] = p[11] = yb;
    const double xc = c[18];
    p[6] = xc;
    const double yc = c[19];
    p[7] = yc;
    const double gamma = x[2];
    const double sin_gamma = em_sin(gamma);
    const double sc = c[29];
    const double cos_gamma = em_cos(gamma);
    const double sd = c[30];
    p[8] = p[14] = xb + sin_gamma*sc + cos_gamma*sd;
    p[9] = p[15] = yb + sin_gamma*sd - cos_gamma*sc;
    const double ss = c[26];
    p[12] = ss*sin_gamma + xb;
    p[13] = -(ss*cos_gamma - yb);
    const double rr = c[24];
    const double beta = x[0];
    const double cos_beta = em_cos(beta);
    const double z_3 = rr*cos_beta;
    p[18] = p[20] = p[40] = z_3;
    const double sin_beta = em_sin(beta);
    const double z_5 = rr*sin_beta;
    p[19] = p[21] = p[41] = z_5;
    const double d = c[20];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    p[22] = p[30] = p[38] = p[43] = z_3 - d*(cos_theta*cos_beta - sin_theta*sin_beta);
    p[23] = p[31] = p[39] = p[44] = z_5 - d*(sin_theta*cos_beta + cos_theta*sin_beta);
    const double zt = c[37];
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    p[26] = p[28] = zt*cos_delta + xa;
    const double sin_delta = em_sin(delta);
    p[27] = p[29] = zt*sin_delta + ya;
    const double u_ = c[33];
    const double epsilon = x[6];
    const double sin_epsilon = em_sin(epsilon);
    p[34] = p[36] = u_*sin_epsilon + xa;
    const double cos_epsilon = em_cos(epsilon);
    p[35] = p[37] = -(u_*cos_epsilon - ya);
    const double ra = c[25];
    p[42] = ra;
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
    const double rr = c[24];
    const double da = c[21];
    const double m2 = c[1];
    const double theta = x[1];
    const double sin_theta = em_sin(theta);
    const double z_1 = m2*sin_theta;
    const double z_2 = da*z_1;
    const double cos_theta = em_cos(theta);
    const double z_4 = cos_theta*(da*da)*z_1;
    const double z_5 = z_4 - 0.5*(z_4 - (rr - da*cos_theta)*z_2);
    dM[49] = rr*z_2 + 2.0*z_5;
    dM[56] = dM[50] = 2.0*z_5;
    const double zt = c[37];
    const double ea = c[23];
    const double e = c[22];
    const double z_6 = ea - e;
    const double m4 = c[3];
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double z_8 = m4*cos_phi;
    const double z_9 = z_6*z_8;
    const double z_10 = zt*z_9;
    dM[178] = dM[172] = -z_10;
    const double sin_phi = em_sin(phi);
    const double z_12 = sin_phi*(z_6*z_6)*z_8;
    dM[179] = -(z_10 + 2.0*z_12 - (z_12 - (zt - z_6*sin_phi)*z_9));
    const double u_ = c[33];
    const double zf = c[36];
    const double fa = c[38];
    const double z_13 = zf - fa;
    const double m6 = c[5];
    const double omega = x[5];
    const double cos_omega = em_cos(omega);
    const double z_15 = m6*cos_omega;
    const double z_16 = z_13*z_15;
    const double z_17 = u_*z_16;
    dM[292] = dM[286] = -z_17;
    const double sin_omega = em_sin(omega);
    const double z_19 = sin_omega*(z_13*z_13)*z_15;
    dM[293] = -(z_17 + 2.0*z_19 - (z_19 - (u_ - z_13*sin_omega)*z_16));
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double rr = c[24];
    const double beta = x[0];
    const double cos_beta = em_cos(beta);
    const double d = c[20];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    const double sin_beta = em_sin(beta);
    const double z_4 = d*(cos_theta*cos_beta - sin_theta*sin_beta);
    const double z_5 = rr*cos_beta - z_4;
    const double lambda_0 = lambda[0];
    const double z_6 = d*(sin_theta*cos_beta + cos_theta*sin_beta);
    const double z_7 = rr*sin_beta - z_6;
    const double lambda_1 = lambda[1];
    const double lambda_2 = lambda[2];
    const double lambda_3 = lambda[3];
    const double lambda_4 = lambda[4];
    const double lambda_5 = lambda[5];
    D[0] = -(z_5*lambda_0 + z_7*lambda_1 + z_5*lambda_2 + z_7*lambda_3 + z_5*lambda_4 + z_7*lambda_5);
    const double beta_dot = v[0];
    const double theta_dot = v[1];
    const double m2 = c[1];
    const double da = c[21];
    const double z_8 = m2*da;
    const double z_9 = theta_dot*z_8;
    const double z_10 = rr*cos_theta;
    const double z_11 = sin_theta*sin_theta;
    const double z_12 = m2*(da*da);
    const double z_13 = theta_dot*z_12;
    const double z_14 = z_11*z_13;
    const double z_15 = cos_theta*cos_theta;
    const double z_16 = z_14 - z_15*z_13;
    const double z_17 = rr - da*cos_theta;
    const double z_18 = cos_theta*z_17;
    const double z_19 = z_16 - 0.5*(z_16 + (z_14 + z_9*z_18));
    const double z_20 = 2.0*z_19;
    const double z_21 = rr*sin_theta;
    const double z_22 = cos_theta*sin_theta;
    const double z_23 = z_12*z_22;
    const double z_24 = z_17*sin_theta;
    const double z_25 = z_23 - 0.5*(z_23 - z_8*z_24);
    const double z_26 = z_8*z_21 + 2.0*z_25;
    const double beta_ddot = a[0];
    const double z_27 = 2.0*z_25;
    const double theta_ddot = a[1];
    const double z_28 = z_4*lambda_0 + z_6*lambda_1 + z_4*lambda_2 + z_6*lambda_3 + z_4*lambda_4 + z_6*lambda_5;
    D[1] = (beta_dot*(z_9*z_10 - 2.0*z_19) - theta_dot*z_20) + (z_26*beta_ddot + z_27*theta_ddot) + z_28;
    const double z_29 = z_13*z_22;
    const double z_30 = z_29 - 0.5*(z_29 - z_9*z_24);
    D[7] = z_9*z_21 + 2.0*z_30;
    const double z_31 = beta_dot*z_26;
    const double z_32 = 2.0*z_30;
    const double z_33 = theta_dot*z_27;
    D[8] = z_31 + (z_32 + z_33);
    D[14] = z_28;
    const double z_34 = z_11*z_12;
    const double z_35 = z_34 - z_15*z_12;
    const double z_36 = z_35 - 0.5*(z_35 + (z_34 + z_8*z_18));
    D[15] = 0.5*(2.0*z_28 + 2.0*z_27*beta_ddot - (((z_8*z_10 - 2.0*z_36)*(beta_dot*beta_dot) -
        2.0*beta_dot*theta_dot*(2.0*z_36)) + 2.0*beta_dot*z_20));
    D[21] = z_32 - (z_33 + z_31);
    const double gamma = x[2];
    const double sin_gamma = em_sin(gamma);
    const double yb = c[17];
    const double yc = c[19];
    const double sd = c[30];
    const double cos_gamma = em_cos(gamma);
    const double sc = c[29];
    const double z_39 = sin_gamma*sd - cos_gamma*sc;
    const double z_40 = yb + z_39 - yc;
    const double xb = c[16];
    const double xc = c[18];
    const double z_41 = sin_gamma*sc + cos_gamma*sd;
    const double z_42 = xb + z_41 - xc;
    const double z_43 = z_42*z_42 + z_40*z_40;
    const double z_44 = sqrt(z_43);
    const double c0 = c[39];
    const double l0 = c[40];
    const double z_45 = c0*(z_44 - l0);
    const double z_46 = z_45/z_44;
    const double z_47 = sd*z_46;
    const double z_48 = sc*z_46;
    const double z_49 = z_42*z_39 - z_40*z_41;
    const double z_50 = z_45*(z_49/(z_43*z_44));
    const double z_51 = sd*z_40;
    const double z_52 = c0*z_49/z_43;
    const double z_53 = sc*z_42;
    const double z_54 = sc*z_40;
    const double z_55 = sd*z_42;
    const double ss = c[26];
    const double z_56 = ss*sin_gamma;
    const double z_57 = ss*cos_gamma;
    D[30] = -(((sin_gamma*(z_40*z_47 + z_42*z_48) - cos_gamma*((z_41*z_47 + z_50*z_51 - z_52*z_51) - (z_39*z_48 +
        z_52*z_53 - z_50*z_53))) - (cos_gamma*(z_40*z_48 - z_42*z_47) + sin_gamma*((z_41*z_48 + z_50*z_54 -
        z_52*z_54) + (z_39*z_47 + z_52*z_55 - z_50*z_55)))) - (lambda_0*z_56 - lambda_1*z_57));
    const double delta_dot = v[4];
    const double zt = c[37];
    const double m4 = c[3];
    const double ea = c[23];
    const double e = c[22];
    const double z_58 = ea - e;
    const double z_59 = m4*z_58;
    const double z_60 = zt*z_59;
    const double phi_dot = v[3];
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double z_62 = phi_dot*sin_phi;
    const double z_63 = z_60*z_62;
    const double z_64 = delta_dot*z_63;
    const double z_65 = sin_phi*z_60;
    const double cos_phi = em_cos(phi);
    const double z_67 = cos_phi*cos_phi;
    const double z_68 = m4*(z_58*z_58);
    const double z_69 = z_67*z_68;
    const double z_70 = sin_phi*sin_phi;
    const double z_71 = z_69 - z_70*z_68;
    const double z_72 = (zt - z_58*sin_phi)*z_59;
    const double z_73 = cos_phi*z_60;
    const double delta_ddot = a[4];
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    const double sin_delta = em_sin(delta);
    const double z_76 = e*(sin_phi*cos_delta + cos_phi*sin_delta);
    const double z_77 = e*(cos_phi*cos_delta - sin_phi*sin_delta);
    const double z_78 = z_76*lambda_2 - z_77*lambda_3;
    D[45] = 0.5*((2.0*z_64 - (2.0*z_64 + (z_65 + (z_71 + (z_69 + sin_phi*z_72)) -
        2.0*z_71)*(delta_dot*delta_dot))) + 2.0*z_78 - 2.0*z_73*delta_ddot);
    D[46] = z_78;
    const double z_79 = phi_dot*z_73;
    const double z_80 = cos_phi*z_68;
    const double z_81 = sin_phi*z_80;
    const double z_82 = cos_phi*z_72;
    const double z_83 = z_73 + 2.0*z_81 - (z_81 - z_82);
    const double z_84 = delta_dot*z_83;
    D[53] = -(z_79 - (z_79 + z_84));
    const double z_85 = phi_dot*z_68;
    const double z_86 = z_67*z_85;
    const double z_87 = z_86 - z_70*z_85;
    const double phi_ddot = a[3];
    D[59] = z_78 + (z_65*(phi_dot*phi_dot) + delta_dot*(z_63 + (z_87 + (z_86 + z_62*z_72)) - 2.0*z_87)) -
        (z_73*phi_ddot + z_83*delta_ddot);
    const double z_88 = zt*cos_delta + z_76;
    const double z_89 = zt*sin_delta - z_77;
    D[60] = z_88*lambda_2 + z_89*lambda_3;
    D[66] = -(2.0*z_79 + z_84);
    const double z_90 = z_62*z_80;
    D[67] = -(z_79 + 2.0*z_90 - (z_90 - phi_dot*z_82));
    const double epsilon_dot = v[6];
    const double u_ = c[33];
    const double m6 = c[5];
    const double zf = c[36];
    const double fa = c[38];
    const double z_91 = zf - fa;
    const double z_92 = m6*z_91;
    const double z_93 = u_*z_92;
    const double omega_dot = v[5];
    const double omega = x[5];
    const double sin_omega = em_sin(omega);
    const double z_95 = omega_dot*sin_omega;
    const double z_96 = z_93*z_95;
    const double z_97 = epsilon_dot*z_96;
    const double z_98 = sin_omega*z_93;
    const double cos_omega = em_cos(omega);
    const double z_100 = cos_omega*cos_omega;
    const double z_101 = m6*(z_91*z_91);
    const double z_102 = z_100*z_101;
    const double z_103 = sin_omega*sin_omega;
    const double z_104 = z_102 - z_103*z_101;
    const double z_105 = (u_ - z_91*sin_omega)*z_92;
    const double z_106 = cos_omega*z_93;
    const double epsilon_ddot = a[6];
    const double epsilon = x[6];
    const double cos_epsilon = em_cos(epsilon);
    const double sin_epsilon = em_sin(epsilon);
    const double z_109 = zf*(cos_omega*cos_epsilon - sin_omega*sin_epsilon);
    const double z_110 = zf*(sin_omega*cos_epsilon + cos_omega*sin_epsilon);
    const double z_111 = z_109*lambda_4 + z_110*lambda_5;
    D[75] = 0.5*((2.0*z_97 - (2.0*z_97 + (z_98 + (z_104 + (z_102 + sin_omega*z_105)) -
        2.0*z_104)*(epsilon_dot*epsilon_dot))) + 2.0*z_111 - 2.0*z_106*epsilon_ddot);
    D[76] = z_111;
    const double z_112 = omega_dot*z_106;
    const double z_113 = cos_omega*z_101;
    const double z_114 = sin_omega*z_113;
    const double z_115 = cos_omega*z_105;
    const double z_116 = z_106 + 2.0*z_114 - (z_114 - z_115);
    const double z_117 = epsilon_dot*z_116;
    D[83] = -(z_112 - (z_112 + z_117));
    const double z_118 = omega_dot*z_101;
    const double z_119 = z_100*z_118;
    const double z_120 = z_119 - z_103*z_118;
    const double omega_ddot = a[5];
    D[89] = z_111 + (z_98*(omega_dot*omega_dot) + epsilon_dot*(z_96 + (z_120 + (z_119 + z_95*z_105)) - 2.0*z_120))
        - (z_106*omega_ddot + z_116*epsilon_ddot);
    const double z_121 = u_*sin_epsilon + z_109;
    const double z_122 = u_*cos_epsilon - z_110;
    D[90] = z_121*lambda_4 - z_122*lambda_5;
    D[96] = -(2.0*z_112 + z_117);
    const double z_123 = z_95*z_113;
    D[97] = -(z_112 + 2.0*z_123 - (z_123 - omega_dot*z_115));
    const double z_124 = beta_dot*rr;
    const double z_125 = beta_dot + theta_dot;
    const double z_126 = z_125*z_6;
    const double z_127 = sin_beta*z_124 - z_126;
    const double z_128 = theta_dot*z_126;
    const double z_129 = z_4*theta_ddot;
    D[98] = (beta_dot*z_127 - z_128) - (z_5*beta_ddot - z_129);
    D[99] = -((z_128 + beta_dot*z_126) - (z_129 + z_4*beta_ddot));
    const double gamma_dot = v[2];
    const double z_130 = gamma_dot*gamma_dot;
    const double gamma_ddot = a[2];
    D[100] = z_130*z_57 + gamma_ddot*z_56;
    const double z_131 = theta_dot*z_4;
    const double z_132 = z_125*z_4;
    const double z_133 = cos_beta*z_124 - z_132;
    D[105] = z_131 - (z_133 + beta_dot*z_5);
    D[106] = beta_dot*z_4 + (z_132 + z_131);
    D[107] = 2.0*(gamma_dot*z_56);
    const double z_134 = theta_dot*z_132;
    const double z_135 = z_6*theta_ddot;
    D[112] = -((beta_dot*z_133 - z_134) + (z_7*beta_ddot - z_135));
    D[113] = (z_134 + beta_dot*z_132) + (z_135 + z_6*beta_ddot);
    D[114] = z_130*z_56 - gamma_ddot*z_57;
    const double z_136 = theta_dot*z_6;
    D[119] = z_136 - (z_127 + beta_dot*z_7);
    D[120] = beta_dot*z_6 + (z_126 + z_136);
    D[121] = (-2.0)*(gamma_dot*z_57);
    D[126] = (beta_dot*z_127 - z_128) - (z_5*beta_ddot - z_129);
    D[127] = -((z_128 + beta_dot*z_126) - (z_129 + z_4*beta_ddot));
    const double z_137 = phi_dot + delta_dot;
    const double z_138 = z_137*z_77;
    const double z_139 = phi_dot*z_138;
    const double z_140 = z_76*phi_ddot;
    D[129] = (z_139 + delta_dot*z_138) + (z_140 + z_76*delta_ddot);
    const double z_141 = delta_dot*zt;
    const double z_142 = sin_delta*z_141 - z_138;
    D[130] = (z_139 - delta_dot*z_142) + (z_140 + z_88*delta_ddot);
    D[133] = z_131 - (z_133 + beta_dot*z_5);
    D[134] = beta_dot*z_4 + (z_132 + z_131);
    const double z_143 = z_137*z_76;
    const double z_144 = phi_dot*z_76;
    D[136] = delta_dot*z_76 + (z_143 + z_144);
    const double z_145 = cos_delta*z_141 + z_143;
    D[137] = z_144 + (z_145 + delta_dot*z_88);
    D[140] = -((beta_dot*z_133 - z_134) + (z_7*beta_ddot - z_135));
    D[141] = (z_134 + beta_dot*z_132) + (z_135 + z_6*beta_ddot);
    const double z_146 = phi_dot*z_143;
    const double z_147 = z_77*phi_ddot;
    D[143] = (z_146 + delta_dot*z_143) - (z_147 + z_77*delta_ddot);
    D[144] = (z_146 + delta_dot*z_145) - (z_147 - z_89*delta_ddot);
    D[147] = z_136 - (z_127 + beta_dot*z_7);
    D[148] = beta_dot*z_6 + (z_126 + z_136);
    const double z_148 = phi_dot*z_77;
    D[150] = -(delta_dot*z_77 + (z_138 + z_148));
    D[151] = -(z_148 - (z_142 + delta_dot*z_89));
    D[154] = (beta_dot*z_127 - z_128) - (z_5*beta_ddot - z_129);
    D[155] = -((z_128 + beta_dot*z_126) - (z_129 + z_4*beta_ddot));
    const double z_149 = omega_dot + epsilon_dot;
    const double z_150 = z_149*z_110;
    const double z_151 = omega_dot*z_150;
    const double z_152 = z_109*omega_ddot;
    D[159] = -((z_151 + epsilon_dot*z_150) - (z_152 + z_109*epsilon_ddot));
    const double z_153 = epsilon_dot*u_;
    const double z_154 = cos_epsilon*z_153 - z_150;
    D[160] = -((z_151 - epsilon_dot*z_154) - (z_152 + z_121*epsilon_ddot));
    D[161] = z_131 - (z_133 + beta_dot*z_5);
    D[162] = beta_dot*z_4 + (z_132 + z_131);
    const double z_155 = z_149*z_109;
    const double z_156 = omega_dot*z_109;
    D[166] = epsilon_dot*z_109 + (z_155 + z_156);
    const double z_157 = sin_epsilon*z_153 + z_155;
    D[167] = z_156 + (z_157 + epsilon_dot*z_121);
    D[168] = -((beta_dot*z_133 - z_134) + (z_7*beta_ddot - z_135));
    D[169] = (z_134 + beta_dot*z_132) + (z_135 + z_6*beta_ddot);
    const double z_158 = omega_dot*z_155;
    const double z_159 = z_110*omega_ddot;
    D[173] = (z_158 + epsilon_dot*z_155) + (z_159 + z_110*epsilon_ddot);
    D[174] = (z_158 + epsilon_dot*z_157) + (z_159 - z_122*epsilon_ddot);
    D[175] = z_136 - (z_127 + beta_dot*z_7);
    D[176] = beta_dot*z_6 + (z_126 + z_136);
    const double z_160 = omega_dot*z_110;
    D[180] = epsilon_dot*z_110 + (z_150 + z_160);
    D[181] = z_160 - (z_154 + epsilon_dot*z_122);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double beta_ddot = a[0];
    const double ra = c[25];
    D[0] = beta_ddot*(ra*ra);
    const double da = c[21];
    const double rr = c[24];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double z_1 = rr - da*cos_theta;
    const double z_2 = da*z_1;
    const double beta_dot = v[0];
    const double theta_dot = v[1];
    const double z_3 = beta_dot + theta_dot;
    const double sin_theta = em_sin(theta);
    const double z_5 = theta_dot*sin_theta;
    const double z_6 = z_3*z_5;
    const double z_7 = da*da;
    const double z_8 = cos_theta*z_7;
    const double z_9 = (2.0*z_3 - z_3)*z_5;
    const double z_10 = beta_dot*z_5;
    const double z_11 = rr*da;
    const double theta_ddot = a[1];
    const double z_12 = beta_ddot + theta_ddot;
    const double z_13 = cos_theta*z_12;
    const double z_14 = sin_theta*sin_theta;
    const double z_15 = z_12*z_14;
    D[1] = z_2*z_6 + z_8*z_9 + z_10*z_11 + z_7*z_15 + rr*z_1*beta_ddot - z_2*z_13;
    D[7] = beta_ddot;
    D[8] = z_12;
    const double beta = x[0];
    const double cos_beta = em_cos(beta);
    const double sin_beta = em_sin(beta);
    const double z_18 = cos_theta*cos_beta - sin_theta*sin_beta;
    const double lambda_1 = lambda[1];
    const double lambda_3 = lambda[3];
    const double lambda_5 = lambda[5];
    const double z_19 = lambda_1 + lambda_3 + lambda_5;
    const double z_20 = sin_theta*cos_beta + cos_theta*sin_beta;
    const double lambda_0 = lambda[0];
    const double lambda_2 = lambda[2];
    const double lambda_4 = lambda[4];
    const double z_21 = lambda_0 + lambda_2 + lambda_4;
    D[20] = -(z_18*z_19 - z_20*z_21);
    const double m2 = c[1];
    const double z_22 = m2*z_1;
    const double z_23 = m2*da;
    const double z_24 = cos_theta*z_23;
    const double z_25 = m2*rr;
    const double z_26 = z_23*z_6 + beta_ddot*z_25 - z_12*z_24;
    D[21] = z_22*z_6 + 2.0*z_24*z_9 + z_10*z_25 + 2.0*z_23*z_15 - z_22*z_13 - cos_theta*z_26;
    const double z_27 = z_23*z_10;
    D[24] = z_26 + cos_beta*z_19 + z_27 + beta_ddot*z_22 - sin_beta*z_21;
    const double m1 = c[0];
    D[25] = 2.0*(m1*ra*beta_ddot);
    D[41] = -1.0;
    const double z_28 = beta_dot*beta_dot;
    const double z_29 = z_28 + 2.0*beta_dot*theta_dot;
    const double z_30 = sin_theta*z_29;
    const double z_31 = sin_theta*(2.0*z_29 - z_29);
    const double z_32 = sin_theta*z_28;
    const double z_33 = cos_theta*beta_ddot;
    const double z_34 = beta_ddot*z_14;
    D[44] = 0.5*(2.0*z_10*z_2 + 2.0*z_10*z_8 + 2.0*theta_ddot*z_7 + 2.0*z_7*z_34 - z_2*z_30 - z_8*z_31 - z_32*z_11
        - 2.0*z_2*z_33);
    D[51] = z_12;
    D[63] = z_20*lambda_0 + z_20*lambda_2 + z_20*lambda_4 - z_18*lambda_1 - z_18*lambda_3 - z_18*lambda_5;
    const double z_35 = 2.0*z_27 - z_23*z_30 - 2.0*beta_ddot*z_24;
    D[64] = 0.5*(2.0*z_10*z_22 + 4.0*z_10*z_24 + 4.0*theta_ddot*z_23 + 4.0*z_23*z_34 - z_22*z_30 - 2.0*z_24*z_31 -
        z_25*z_32 - 2.0*z_22*z_33 - cos_theta*z_35);
    D[67] = 0.5*(z_35 - z_23*z_32);
    const double gamma_ddot = a[2];
    const double sa = c[27];
    const double sb = c[28];
    D[88] = gamma_ddot*(sa*sa + sb*sb);
    D[95] = gamma_ddot;
    const double gamma = x[2];
    const double cos_gamma = em_cos(gamma);
    const double xb = c[16];
    const double xc = c[18];
    const double sin_gamma = em_sin(gamma);
    const double sc = c[29];
    const double sd = c[30];
    const double z_38 = xb + sin_gamma*sc + cos_gamma*sd - xc;
    const double yb = c[17];
    const double yc = c[19];
    const double z_39 = yb + sin_gamma*sd - yc - cos_gamma*sc;
    const double z_40 = z_38*z_38 + z_39*z_39;
    const double z_41 = sqrt(z_40);
    const double z_42 = 1.0/z_41;
    const double z_43 = cos_gamma*z_42;
    const double c0 = c[39];
    const double l0 = c[40];
    const double z_44 = z_41 - l0;
    const double z_45 = c0*z_44;
    const double z_46 = sc*z_45;
    const double z_47 = sin_gamma*z_42;
    const double z_48 = sd*z_45;
    const double z_49 = 1.0/(z_40*z_41);
    const double z_50 = cos_gamma*z_49;
    const double z_51 = sin_gamma*z_49;
    const double z_52 = z_38*z_43;
    const double z_53 = c0*sc;
    const double z_54 = z_38*z_47;
    const double z_55 = c0*sd;
    const double z_56 = z_39*z_43;
    const double z_57 = z_39*z_47;
    const double z_58 = z_52*z_53 + z_56*z_55 + z_57*z_53 - z_54*z_55;
    const double z_59 = z_38*z_46*z_50 + z_39*z_48*z_50 + z_39*z_46*z_51 - z_38*z_48*z_51 - z_58*z_42;
    const double z_60 = z_43*z_46 - z_47*z_48 - z_38*z_59;
    D[102] = z_60;
    const double z_61 = z_43*z_48 + z_47*z_46 - z_39*z_59;
    D[103] = z_61;
    D[104] = -z_60;
    D[105] = -z_61;
    D[112] = -(cos_gamma*lambda_0 + sin_gamma*lambda_1);
    const double m3 = c[2];
    const double z_62 = m3*gamma_ddot;
    D[113] = 2.0*(sa*z_62);
    D[114] = 2.0*(sb*z_62);
    D[115] = z_45*z_52 + z_45*z_57 + sin_gamma*z_60 - cos_gamma*z_61;
    D[116] = -(z_45*z_54 - z_45*z_56 - sin_gamma*z_61 - cos_gamma*z_60);
    const double z_63 = sc*z_44;
    const double z_64 = sd*z_44;
    D[125] = z_52*z_63 + z_56*z_64 + z_57*z_63 - z_54*z_64;
    D[126] = -z_58;
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double delta_dot = v[4];
    const double z_66 = delta_dot*delta_dot;
    const double z_67 = cos_phi*z_66;
    const double ea = c[23];
    const double e = c[22];
    const double z_68 = ea - e;
    const double zt = c[37];
    const double sin_phi = em_sin(phi);
    const double z_70 = zt - z_68*sin_phi;
    const double z_71 = z_68*z_70;
    const double z_72 = z_68*z_68;
    const double z_73 = sin_phi*z_72;
    const double z_74 = z_68*zt;
    const double delta_ddot = a[4];
    const double z_75 = sin_phi*delta_ddot;
    const double phi_ddot = a[3];
    const double z_76 = phi_ddot + delta_ddot;
    D[132] = 0.5*(z_67*z_71 + z_67*z_73 + z_67*z_74 + 2.0*z_76*z_72 - 2.0*z_74*z_75);
    D[139] = z_76;
    const double m4 = c[3];
    const double z_77 = m4*z_70;
    const double z_78 = m4*z_68;
    const double z_79 = sin_phi*z_78;
    const double z_80 = m4*zt;
    const double z_81 = z_67*z_77 + z_67*z_79 + z_67*z_80 + 4.0*z_76*z_78 - 2.0*z_80*z_75;
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    const double sin_delta = em_sin(delta);
    const double z_84 = cos_phi*cos_delta - sin_phi*sin_delta;
    const double z_85 = sin_phi*cos_delta + cos_phi*sin_delta;
    const double z_86 = z_84*lambda_2 + z_85*lambda_3;
    D[151] = (-0.5)*(z_81 + 2.0*z_86);
    D[152] = 0.5*z_81;
    const double z_87 = z_78*z_75;
    D[166] = z_78*z_67 - z_87;
    const double phi_dot = v[3];
    const double z_88 = cos_phi*(phi_dot*phi_dot);
    const double z_89 = cos_phi*(phi_dot*delta_dot);
    const double z_90 = delta_ddot*(cos_phi*cos_phi);
    const double z_91 = sin_phi*phi_ddot;
    D[175] = -(z_74*z_88 + z_89*z_71 + z_89*z_73 + z_89*z_74 + z_75*z_71 + z_74*z_91 - z_72*z_90 -
        zt*z_70*delta_ddot - phi_ddot*z_72);
    const double ta = c[31];
    const double tb = c[32];
    D[176] = delta_ddot*(ta*ta + tb*tb);
    D[182] = z_76;
    D[183] = delta_ddot;
    const double z_92 = z_78*z_89;
    const double z_93 = z_92 + z_87 - delta_ddot*z_80;
    const double z_94 = z_80*z_88 + z_89*z_77 + 2.0*z_89*z_79 + z_89*z_80 + z_75*z_77 + z_80*z_91 - 2.0*z_78*z_90
        - sin_phi*z_93 - 2.0*phi_ddot*z_78;
    D[194] = -(z_86 - z_94);
    D[195] = -z_94;
    const double m5 = c[4];
    const double z_95 = m5*delta_ddot;
    D[203] = 2.0*(ta*z_95);
    D[204] = 2.0*(tb*z_95);
    D[209] = sin_delta*lambda_2 + delta_ddot*z_77 - cos_delta*lambda_3 - z_92 - z_93 - z_78*z_88 - z_78*z_91;
    const double omega = x[5];
    const double cos_omega = em_cos(omega);
    const double epsilon_dot = v[6];
    const double z_97 = epsilon_dot*epsilon_dot;
    const double z_98 = cos_omega*z_97;
    const double zf = c[36];
    const double fa = c[38];
    const double z_99 = zf - fa;
    const double u_ = c[33];
    const double sin_omega = em_sin(omega);
    const double z_101 = u_ - z_99*sin_omega;
    const double z_102 = z_99*z_101;
    const double z_103 = z_99*z_99;
    const double z_104 = sin_omega*z_103;
    const double z_105 = z_99*u_;
    const double epsilon_ddot = a[6];
    const double z_106 = sin_omega*epsilon_ddot;
    const double omega_ddot = a[5];
    const double z_107 = omega_ddot + epsilon_ddot;
    D[220] = 0.5*(z_98*z_102 + z_98*z_104 + z_98*z_105 + 2.0*z_107*z_103 - 2.0*z_105*z_106);
    D[227] = z_107;
    const double m6 = c[5];
    const double z_108 = m6*z_99;
    const double z_109 = z_108*z_106;
    D[248] = z_108*z_98 - z_109;
    const double z_110 = m6*z_101;
    const double z_111 = sin_omega*z_108;
    const double z_112 = m6*u_;
    const double z_113 = z_98*z_110 + z_98*z_111 + z_98*z_112 + 4.0*z_107*z_108 - 2.0*z_112*z_106;
    const double epsilon = x[6];
    const double cos_epsilon = em_cos(epsilon);
    const double sin_epsilon = em_sin(epsilon);
    const double z_116 = sin_omega*cos_epsilon + cos_omega*sin_epsilon;
    const double z_117 = cos_omega*cos_epsilon - sin_omega*sin_epsilon;
    const double z_118 = z_116*lambda_4 - z_117*lambda_5;
    D[251] = 0.5*(z_113 + 2.0*z_118);
    D[253] = (-0.5)*z_113;
    const double omega_dot = v[5];
    const double z_119 = cos_omega*(omega_dot*omega_dot);
    const double z_120 = cos_omega*(omega_dot*epsilon_dot);
    const double z_121 = epsilon_ddot*(cos_omega*cos_omega);
    const double z_122 = sin_omega*omega_ddot;
    D[263] = -(z_105*z_119 + z_120*z_102 + z_120*z_104 + z_120*z_105 + z_106*z_102 + z_105*z_122 - z_103*z_121 -
        u_*z_101*epsilon_ddot - omega_ddot*z_103);
    const double ua = c[34];
    const double ub = c[35];
    D[264] = epsilon_ddot*(ua*ua + ub*ub);
    D[270] = z_107;
    D[271] = epsilon_ddot;
    const double z_123 = z_108*z_120;
    const double z_124 = z_123 + z_109 - epsilon_ddot*z_112;
    D[291] = -(sin_epsilon*lambda_5 + cos_epsilon*lambda_4 + z_123 + z_124 + z_108*z_119 + z_108*z_122 -
        epsilon_ddot*z_110);
    const double m7 = c[6];
    const double z_125 = m7*epsilon_ddot;
    D[292] = 2.0*(ua*z_125);
    D[293] = 2.0*(ub*z_125);
    const double z_126 = z_112*z_119 + z_120*z_110 + 2.0*z_120*z_111 + z_120*z_112 + z_106*z_110 + z_112*z_122 -
        2.0*z_108*z_121 - sin_omega*z_124 - 2.0*omega_ddot*z_108;
    D[294] = z_118 - z_126;
    D[296] = z_126;
    const double z_127 = theta_dot*z_3;
    const double z_128 = beta_dot*z_3;
    D[321] = z_18*z_127 + z_20*theta_ddot + z_18*z_128 + z_20*beta_ddot;
    D[325] = -(cos_beta*z_28 + sin_beta*beta_ddot);
    const double gamma_dot = v[2];
    const double z_129 = gamma_dot*gamma_dot;
    D[327] = sin_gamma*z_129 - cos_gamma*gamma_ddot;
    D[364] = z_20*z_127 + z_20*z_128 - z_18*theta_ddot - z_18*beta_ddot;
    D[368] = -(sin_beta*z_28 - cos_beta*beta_ddot);
    D[370] = -(cos_gamma*z_129 + sin_gamma*gamma_ddot);
    D[407] = z_18*z_127 + z_20*theta_ddot + z_18*z_128 + z_20*beta_ddot;
    const double z_130 = phi_dot + delta_dot;
    const double z_131 = phi_dot*z_130;
    const double z_132 = delta_dot*z_130;
    D[409] = z_85*z_131 + z_85*z_132 - z_84*phi_ddot - z_84*delta_ddot;
    D[411] = -(cos_beta*z_28 + sin_beta*beta_ddot);
    D[424] = cos_delta*z_66 + sin_delta*delta_ddot;
    D[450] = z_20*z_127 + z_20*z_128 - z_18*theta_ddot - z_18*beta_ddot;
    D[452] = -(z_84*z_131 + z_85*phi_ddot + z_84*z_132 + z_85*delta_ddot);
    D[454] = -(sin_beta*z_28 - cos_beta*beta_ddot);
    D[467] = sin_delta*z_66 - cos_delta*delta_ddot;
    D[493] = z_18*z_127 + z_20*theta_ddot + z_18*z_128 + z_20*beta_ddot;
    D[497] = -(cos_beta*z_28 + sin_beta*beta_ddot);
    D[506] = sin_epsilon*z_97 - cos_epsilon*epsilon_ddot;
    const double z_133 = omega_dot + epsilon_dot;
    const double z_134 = omega_dot*z_133;
    const double z_135 = epsilon_dot*z_133;
    D[509] = z_117*z_134 + z_116*omega_ddot + z_117*z_135 + z_116*epsilon_ddot;
    D[536] = z_20*z_127 + z_20*z_128 - z_18*theta_ddot - z_18*beta_ddot;
    D[540] = -(sin_beta*z_28 - cos_beta*beta_ddot);
    D[549] = -(cos_epsilon*z_97 + sin_epsilon*epsilon_ddot);
    D[552] = z_116*z_134 + z_116*z_135 - z_117*omega_ddot - z_117*epsilon_ddot;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double rr = c[24];
    const double beta = x[0];
    const double sin_beta = em_sin(beta);
    const double d = c[20];
    const double theta = x[1];
    const double sin_theta = em_sin(theta);
    const double cos_beta = em_cos(beta);
    const double cos_theta = em_cos(theta);
    const double z_4 = sin_theta*cos_beta + cos_theta*sin_beta;
    const double z_5 = d*z_4;
    const double z_6 = rr*sin_beta - z_5;
    D[0] = -z_6;
    D[1] = z_5;
    const double ss = c[26];
    const double gamma = x[2];
    const double cos_gamma = em_cos(gamma);
    D[2] = -ss*cos_gamma;
    D[30] = -1.0;
    const double z_8 = cos_theta*cos_beta - sin_theta*sin_beta;
    D[34] = -z_8;
    D[38] = cos_beta;
    const double sin_gamma = em_sin(gamma);
    D[40] = -sin_gamma;
    const double z_10 = d*z_8;
    const double z_11 = rr*cos_beta - z_10;
    D[57] = z_11;
    D[58] = -z_10;
    D[59] = -ss*sin_gamma;
    D[88] = -1.0;
    D[91] = -z_4;
    D[95] = sin_beta;
    D[97] = cos_gamma;
    D[114] = -z_6;
    D[115] = z_5;
    const double e = c[22];
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    const double sin_phi = em_sin(phi);
    const double sin_delta = em_sin(delta);
    const double z_16 = cos_phi*cos_delta - sin_phi*sin_delta;
    const double z_17 = e*z_16;
    D[117] = -z_17;
    const double zt = c[37];
    const double z_18 = zt*sin_delta - z_17;
    D[118] = z_18;
    D[142] = -1.0;
    D[148] = -z_8;
    const double z_19 = sin_phi*cos_delta + cos_phi*sin_delta;
    D[150] = -z_19;
    D[152] = cos_beta;
    D[165] = -cos_delta;
    D[171] = z_11;
    D[172] = -z_10;
    const double z_20 = e*z_19;
    D[174] = -z_20;
    const double z_21 = zt*cos_delta + z_20;
    D[175] = -z_21;
    D[200] = -1.0;
    D[205] = -z_4;
    D[207] = z_16;
    D[209] = sin_beta;
    D[222] = -sin_delta;
    D[228] = -z_6;
    D[229] = z_5;
    const double zf = c[36];
    const double omega = x[5];
    const double sin_omega = em_sin(omega);
    const double epsilon = x[6];
    const double cos_epsilon = em_cos(epsilon);
    const double cos_omega = em_cos(omega);
    const double sin_epsilon = em_sin(epsilon);
    const double z_26 = sin_omega*cos_epsilon + cos_omega*sin_epsilon;
    const double z_27 = zf*z_26;
    D[233] = z_27;
    const double u_ = c[33];
    const double z_28 = u_*cos_epsilon - z_27;
    D[234] = -z_28;
    D[256] = -1.0;
    D[262] = -z_8;
    D[266] = cos_beta;
    D[275] = -sin_epsilon;
    const double z_29 = cos_omega*cos_epsilon - sin_omega*sin_epsilon;
    D[278] = -z_29;
    D[285] = z_11;
    D[286] = -z_10;
    const double z_30 = zf*z_29;
    D[290] = -z_30;
    const double z_31 = u_*sin_epsilon + z_30;
    D[291] = -z_31;
    D[314] = -1.0;
    D[319] = -z_4;
    D[323] = sin_beta;
    D[332] = cos_epsilon;
    D[335] = -z_26;
    const double theta_dot = v[1];
    const double z_32 = theta_dot*z_10;
    const double beta_dot = v[0];
    D[342] = z_32 - beta_dot*z_11;
    D[343] = z_32 + beta_dot*z_10;
    const double gamma_dot = v[2];
    const double z_33 = gamma_dot*ss;
    D[344] = sin_gamma*z_33;
    D[349] = -z_6;
    D[350] = z_5;
    D[351] = -ss*cos_gamma;
    D[376] = theta_dot*z_4 + beta_dot*z_4;
    D[380] = -beta_dot*sin_beta;
    D[382] = -gamma_dot*cos_gamma;
    const double z_34 = theta_dot*z_5;
    D[399] = z_34 - beta_dot*z_6;
    D[400] = z_34 + beta_dot*z_5;
    D[401] = -cos_gamma*z_33;
    D[406] = z_11;
    D[407] = -z_10;
    D[408] = -ss*sin_gamma;
    D[433] = -(theta_dot*z_8 + beta_dot*z_8);
    D[437] = beta_dot*cos_beta;
    D[439] = -gamma_dot*sin_gamma;
    D[456] = z_32 - beta_dot*z_11;
    D[457] = z_32 + beta_dot*z_10;
    const double phi_dot = v[3];
    const double z_35 = phi_dot*z_20;
    const double delta_dot = v[4];
    D[459] = z_35 + delta_dot*z_20;
    D[460] = z_35 + delta_dot*z_21;
    D[463] = -z_6;
    D[464] = z_5;
    D[466] = -z_17;
    D[467] = z_18;
    D[490] = theta_dot*z_4 + beta_dot*z_4;
    D[492] = -(phi_dot*z_16 + delta_dot*z_16);
    D[494] = -beta_dot*sin_beta;
    D[507] = delta_dot*sin_delta;
    D[513] = z_34 - beta_dot*z_6;
    D[514] = z_34 + beta_dot*z_5;
    const double z_36 = phi_dot*z_17;
    D[516] = -(z_36 + delta_dot*z_17);
    D[517] = -(z_36 - delta_dot*z_18);
    D[520] = z_11;
    D[521] = -z_10;
    D[523] = -z_20;
    D[524] = -z_21;
    D[547] = -(theta_dot*z_8 + beta_dot*z_8);
    D[549] = -(phi_dot*z_19 + delta_dot*z_19);
    D[551] = beta_dot*cos_beta;
    D[564] = -delta_dot*cos_delta;
    D[570] = z_32 - beta_dot*z_11;
    D[571] = z_32 + beta_dot*z_10;
    const double omega_dot = v[5];
    const double z_37 = omega_dot*z_30;
    const double epsilon_dot = v[6];
    D[575] = z_37 + epsilon_dot*z_30;
    D[576] = z_37 + epsilon_dot*z_31;
    D[577] = -z_6;
    D[578] = z_5;
    D[582] = z_27;
    D[583] = -z_28;
    D[604] = theta_dot*z_4 + beta_dot*z_4;
    D[608] = -beta_dot*sin_beta;
    D[617] = -epsilon_dot*cos_epsilon;
    D[620] = omega_dot*z_26 + epsilon_dot*z_26;
    D[627] = z_34 - beta_dot*z_6;
    D[628] = z_34 + beta_dot*z_5;
    const double z_38 = omega_dot*z_27;
    D[632] = z_38 + epsilon_dot*z_27;
    D[633] = z_38 - epsilon_dot*z_28;
    D[634] = z_11;
    D[635] = -z_10;
    D[639] = -z_30;
    D[640] = -z_31;
    D[661] = -(theta_dot*z_8 + beta_dot*z_8);
    D[665] = beta_dot*cos_beta;
    D[674] = -epsilon_dot*sin_epsilon;
    D[677] = -(omega_dot*z_29 + epsilon_dot*z_29);
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes andrews_lanes;
EM_WEAK em_lanes andrews_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 1, 2, 2, 3, 3 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 14, 26, 0, 4 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 42, 43, 44, 45 };
static const em_block block3 = { N, N3, coordinate3, scales, EM_IN_STATE, 18, 28, 6, 10 };
static const em_block block4 = { N, N4, coordinate4, scales, EM_IN_STATE, 22, 30, 12, 16 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, &block3, &block4, NULL };

/* M of the constant blocks, and what other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double M2[N2][N2],
                                  double prepared[N_PREPARED])
{
    const double I3 = parameters[9];
    const double m3 = parameters[2];
    const double sa = parameters[27];
    const double sb = parameters[28];
    M2[0][0] = I3 + m3*(sa*sa) + m3*(sb*sb);
    const double m2 = parameters[1];
    const double rr = parameters[24];
    const double z_0 = m2*rr;
    prepared[46] = z_0; /* c_0 */
    const double I1 = parameters[7];
    const double I2 = parameters[8];
    const double m1 = parameters[0];
    const double ra = parameters[25];
    prepared[47] = I1 + I2 + m1*(ra*ra); /* c_1 */
    const double da = parameters[21];
    const double z_1 = m2*(da*da);
    prepared[48] = z_1; /* c_2 */
    prepared[49] = m2*da; /* c_3 */
    prepared[50] = I2 + z_1; /* c_4 */
    const double I4 = parameters[10];
    const double m4 = parameters[3];
    const double ea = parameters[23];
    const double e = parameters[22];
    const double z_2 = ea - e;
    const double z_3 = m4*(z_2*z_2);
    prepared[51] = I4 + z_3; /* c_5 */
    const double zt = parameters[37];
    const double z_4 = m4*z_2;
    const double z_5 = zt*z_4;
    prepared[52] = z_5; /* c_6 */
    prepared[53] = z_2; /* c_7 */
    prepared[54] = m4*zt; /* c_8 */
    prepared[55] = z_3; /* c_9 */
    prepared[56] = z_4; /* c_10 */
    const double I5 = parameters[11];
    const double m5 = parameters[4];
    const double ta = parameters[31];
    const double tb = parameters[32];
    prepared[57] = I4 + I5 + m5*(ta*ta) + m5*(tb*tb); /* c_11 */
    const double I6 = parameters[12];
    const double m6 = parameters[5];
    const double zf = parameters[36];
    const double fa = parameters[38];
    const double z_6 = zf - fa;
    const double z_7 = m6*(z_6*z_6);
    prepared[58] = I6 + z_7; /* c_12 */
    const double u_ = parameters[33];
    const double z_8 = m6*z_6;
    const double z_9 = u_*z_8;
    prepared[59] = z_9; /* c_13 */
    prepared[60] = z_6; /* c_14 */
    prepared[61] = m6*u_; /* c_15 */
    prepared[62] = z_7; /* c_16 */
    prepared[63] = z_8; /* c_17 */
    const double I7 = parameters[13];
    const double m7 = parameters[6];
    const double ua = parameters[34];
    const double ub = parameters[35];
    prepared[64] = I6 + I7 + m7*(ua*ua) + m7*(ub*ub); /* c_18 */
    prepared[65] = da*z_0; /* c_19 */
    prepared[66] = 2.0*z_1; /* c_20 */
    prepared[67] = 2.0*z_3; /* c_21 */
    prepared[68] = 2.0*z_7; /* c_22 */
    const double c0 = parameters[39];
    const double sd = parameters[30];
    prepared[69] = c0*sd; /* c_23 */
    const double yb = parameters[17];
    const double yc = parameters[19];
    prepared[70] = yb - yc; /* c_24 */
    const double xb = parameters[16];
    const double xc = parameters[18];
    prepared[71] = xb - xc; /* c_25 */
    const double sc = parameters[29];
    prepared[72] = c0*sc; /* c_26 */
    prepared[73] = 2.0*z_5; /* c_27 */
    prepared[74] = 2.0*z_9; /* c_28 */
    prepared[75] = I3 + m3*(sa*sa) + m3*(sb*sb); /* c_29 */
    const double ss = parameters[26];
    prepared[76] = fabs(ss); /* c_30 */
    prepared[77] = fabs(xb); /* c_31 */
    prepared[78] = fabs(rr); /* c_32 */
    const double d = parameters[20];
    prepared[79] = fabs(d); /* c_33 */
    prepared[80] = fabs(yb); /* c_34 */
    prepared[81] = fabs(zt); /* c_35 */
    prepared[82] = fabs(e); /* c_36 */
    const double xa = parameters[14];
    prepared[83] = fabs(xa); /* c_37 */
    const double ya = parameters[15];
    prepared[84] = fabs(ya); /* c_38 */
    prepared[85] = fabs(u_); /* c_39 */
    prepared[86] = fabs(zf); /* c_40 */
    const double mom = parameters[41];
    prepared[87] = 2.0*mom; /* c_41 */
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
    {63, ""},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {62, "nonnegative"},
    {62, "nonnegative"},
    {60, "positive"},
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
    double M2[N2][N2];
    prepared_constants(parameters, M2, c);
    if (em_prepare(&block2, M2[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_ACROSS void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double rr = c[24];
    const double da = c[21];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double z_1 = rr - da*cos_theta;
    const double c_0 = c[46];
    const double c_1 = c[47];
    const double c_2 = c[48];
    const double sin_theta = em_sin(theta);
    const double c_3 = c[49];
    const double z_3 = c_2*(sin_theta*sin_theta) - cos_theta*z_1*c_3;
    M[0] = z_1*c_0 + c_1 + z_3;
    const double I2 = c[8];
    M[7] = M[1] = I2 + z_3;
    const double c_4 = c[50];
    M[8] = c_4;
    M[14] = M[2] = 0.0;
    M[15] = M[9] = 0.0;
    const double c_29 = c[75];
    M[16] = c_29;
    M[21] = M[3] = 0.0;
    M[22] = M[10] = 0.0;
    M[23] = M[17] = 0.0;
    const double c_5 = c[51];
    M[24] = c_5;
    M[28] = M[4] = 0.0;
    M[29] = M[11] = 0.0;
    M[30] = M[18] = 0.0;
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double c_6 = c[52];
    M[31] = M[25] = c_5 - sin_phi*c_6;
    const double zt = c[37];
    const double c_7 = c[53];
    const double z_5 = zt - c_7*sin_phi;
    const double c_8 = c[54];
    const double c_9 = c[55];
    const double cos_phi = em_cos(phi);
    const double c_10 = c[56];
    const double c_11 = c[57];
    M[32] = z_5*c_8 + c_9*(cos_phi*cos_phi) + c_11 - sin_phi*z_5*c_10;
    M[35] = M[5] = 0.0;
    M[36] = M[12] = 0.0;
    M[37] = M[19] = 0.0;
    M[38] = M[26] = 0.0;
    M[39] = M[33] = 0.0;
    const double c_12 = c[58];
    M[40] = c_12;
    M[42] = M[6] = 0.0;
    M[43] = M[13] = 0.0;
    M[44] = M[20] = 0.0;
    M[45] = M[27] = 0.0;
    M[46] = M[34] = 0.0;
    const double omega = x[5];
    const double sin_omega = em_sin(omega);
    const double c_13 = c[59];
    M[47] = M[41] = c_12 - sin_omega*c_13;
    const double u_ = c[33];
    const double c_14 = c[60];
    const double z_8 = u_ - c_14*sin_omega;
    const double c_15 = c[61];
    const double c_16 = c[62];
    const double cos_omega = em_cos(omega);
    const double c_17 = c[63];
    const double c_18 = c[64];
    M[48] = z_8*c_15 + c_16*(cos_omega*cos_omega) + c_18 - sin_omega*z_8*c_17;
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
    const double rr = c[24];
    const double beta = x[0];
    const double sin_beta = em_sin(beta);
    const double d = c[20];
    const double theta = x[1];
    const double sin_theta = em_sin(theta);
    const double cos_beta = em_cos(beta);
    const double cos_theta = em_cos(theta);
    const double z_4 = d*(sin_theta*cos_beta + cos_theta*sin_beta);
    A[0] = -(rr*sin_beta - z_4);
    A[1] = z_4;
    const double ss = c[26];
    const double gamma = x[2];
    const double cos_gamma = em_cos(gamma);
    A[2] = -ss*cos_gamma;
    A[3] = 0.0;
    A[4] = 0.0;
    A[5] = 0.0;
    A[6] = 0.0;
    const double z_6 = d*(cos_theta*cos_beta - sin_theta*sin_beta);
    A[7] = rr*cos_beta - z_6;
    A[8] = -z_6;
    const double sin_gamma = em_sin(gamma);
    A[9] = -ss*sin_gamma;
    A[10] = 0.0;
    A[11] = 0.0;
    A[12] = 0.0;
    A[13] = 0.0;
    A[14] = -(rr*sin_beta - z_4);
    A[15] = z_4;
    A[16] = 0.0;
    const double e = c[22];
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    const double sin_phi = em_sin(phi);
    const double sin_delta = em_sin(delta);
    const double z_12 = e*(cos_phi*cos_delta - sin_phi*sin_delta);
    A[17] = -z_12;
    const double zt = c[37];
    A[18] = zt*sin_delta - z_12;
    A[19] = 0.0;
    A[20] = 0.0;
    A[21] = rr*cos_beta - z_6;
    A[22] = -z_6;
    A[23] = 0.0;
    const double z_13 = e*(sin_phi*cos_delta + cos_phi*sin_delta);
    A[24] = -z_13;
    A[25] = -(zt*cos_delta + z_13);
    A[26] = 0.0;
    A[27] = 0.0;
    A[28] = -(rr*sin_beta - z_4);
    A[29] = z_4;
    A[30] = 0.0;
    A[31] = 0.0;
    A[32] = 0.0;
    const double zf = c[36];
    const double omega = x[5];
    const double sin_omega = em_sin(omega);
    const double epsilon = x[6];
    const double cos_epsilon = em_cos(epsilon);
    const double cos_omega = em_cos(omega);
    const double sin_epsilon = em_sin(epsilon);
    const double z_18 = zf*(sin_omega*cos_epsilon + cos_omega*sin_epsilon);
    A[33] = z_18;
    const double u_ = c[33];
    A[34] = -(u_*cos_epsilon - z_18);
    A[35] = rr*cos_beta - z_6;
    A[36] = -z_6;
    A[37] = 0.0;
    A[38] = 0.0;
    A[39] = 0.0;
    const double z_19 = zf*(cos_omega*cos_epsilon - sin_omega*sin_epsilon);
    A[40] = -z_19;
    A[41] = -(u_*sin_epsilon + z_19);
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    b[4] = 0.0;
    b[5] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
EM_ACROSS void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
    const double ss = c[26];
    const double gamma = x[2];
    const double sin_gamma = em_sin(gamma);
    const double xb = c[16];
    const double rr = c[24];
    const double beta = x[0];
    const double cos_beta = em_cos(beta);
    const double d = c[20];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    const double sin_beta = em_sin(beta);
    const double z_5 = cos_theta*cos_beta - sin_theta*sin_beta;
    const double z_6 = rr*cos_beta - d*z_5;
    phi[0] = z_6 - ss*sin_gamma - xb;
    const double cos_gamma = em_cos(gamma);
    const double yb = c[17];
    const double z_8 = sin_theta*cos_beta + cos_theta*sin_beta;
    const double z_9 = rr*sin_beta - d*z_8;
    phi[1] = ss*cos_gamma + z_9 - yb;
    const double zt = c[37];
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    const double e = c[22];
    const double phi_ = x[3];
    const double sin_phi_ = em_sin(phi_);
    const double cos_phi_ = em_cos(phi_);
    const double sin_delta = em_sin(delta);
    const double z_14 = sin_phi_*cos_delta + cos_phi_*sin_delta;
    const double xa = c[14];
    const double z_15 = xa - z_6;
    phi[2] = -zt*cos_delta - e*z_14 - z_15;
    const double z_16 = cos_phi_*cos_delta - sin_phi_*sin_delta;
    const double ya = c[15];
    const double z_17 = ya - z_9;
    phi[3] = e*z_16 - zt*sin_delta - z_17;
    const double u_ = c[33];
    const double epsilon = x[6];
    const double sin_epsilon = em_sin(epsilon);
    const double zf = c[36];
    const double omega = x[5];
    const double cos_omega = em_cos(omega);
    const double cos_epsilon = em_cos(epsilon);
    const double sin_omega = em_sin(omega);
    const double z_22 = cos_omega*cos_epsilon - sin_omega*sin_epsilon;
    phi[4] = -u_*sin_epsilon - zf*z_22 - z_15;
    const double z_23 = sin_omega*cos_epsilon + cos_omega*sin_epsilon;
    phi[5] = u_*cos_epsilon - zf*z_23 - z_17;
    const double c_30 = c[76];
    const double c_31 = c[77];
    const double c_32 = c[78];
    const double c_33 = c[79];
    const double z_24 = fabs(z_5);
    const double z_25 = fabs(theta) + fabs(beta);
    const double z_26 = fabs(z_8);
    const double z_27 = c_32*(fabs(cos_beta) + fabs(beta*sin_beta)) + c_33*(z_24 + z_25*z_26);
    terms[0] = c_30*(fabs(sin_gamma) + fabs(gamma*cos_gamma)) + c_31 + z_27;
    const double c_34 = c[80];
    const double z_28 = c_32*(fabs(sin_beta) + fabs(beta*cos_beta)) + c_33*(z_26 + z_25*z_24);
    terms[1] = c_30*(fabs(cos_gamma) + fabs(gamma*sin_gamma)) + c_34 + z_28;
    const double c_35 = c[81];
    const double c_36 = c[82];
    const double z_29 = fabs(z_14);
    const double z_30 = fabs(phi_) + fabs(delta);
    const double z_31 = fabs(z_16);
    const double c_37 = c[83];
    const double z_32 = c_37 + z_27;
    terms[2] = c_35*(fabs(cos_delta) + fabs(delta*sin_delta)) + c_36*(z_29 + z_30*z_31) + z_32;
    const double c_38 = c[84];
    const double z_33 = c_38 + z_28;
    terms[3] = c_35*(fabs(sin_delta) + fabs(delta*cos_delta)) + c_36*(z_31 + z_30*z_29) + z_33;
    const double c_39 = c[85];
    const double c_40 = c[86];
    const double z_34 = fabs(z_22);
    const double z_35 = fabs(omega) + fabs(epsilon);
    const double z_36 = fabs(z_23);
    terms[4] = c_39*(fabs(sin_epsilon) + fabs(epsilon*cos_epsilon)) + c_40*(z_34 + z_35*z_36) + z_32;
    terms[5] = c_39*(fabs(cos_epsilon) + fabs(epsilon*sin_epsilon)) + c_40*(z_36 + z_35*z_34) + z_33;
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
#include "em_tangent.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const double *restrict x, const double *restrict c, double M1[N1][N1],
                              double M3[N3][N3], double M4[N4][N4], double A1[N_ROWS][N1],
                              double A2[N_ROWS][N2], double A3[N_ROWS][N3], double A4[N_ROWS][N4],
                              double b[N_ROWS], double shared[9])
{
    const double rr = c[24];
    const double da = c[21];
    const double theta = x[1];
    const double cos_theta = em_cos(theta);
    const double z_1 = rr - da*cos_theta;
    const double c_0 = c[46];
    const double c_1 = c[47];
    const double c_2 = c[48];
    const double sin_theta = em_sin(theta);
    const double c_3 = c[49];
    const double z_3 = z_1*c_3;
    const double z_4 = c_2*(sin_theta*sin_theta) - cos_theta*z_3;
    M1[0][0] = z_1*c_0 + c_1 + z_4;
    const double I2 = c[8];
    M1[0][1] = M1[1][0] = I2 + z_4;
    const double c_4 = c[50];
    M1[1][1] = c_4;
    const double c_5 = c[51];
    M3[0][0] = c_5;
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double c_6 = c[52];
    M3[0][1] = M3[1][0] = c_5 - sin_phi*c_6;
    const double zt = c[37];
    const double c_7 = c[53];
    const double z_6 = zt - c_7*sin_phi;
    const double c_8 = c[54];
    const double c_9 = c[55];
    const double cos_phi = em_cos(phi);
    const double c_10 = c[56];
    const double z_8 = z_6*c_10;
    const double c_11 = c[57];
    M3[1][1] = z_6*c_8 + c_9*(cos_phi*cos_phi) + c_11 - sin_phi*z_8;
    const double c_12 = c[58];
    M4[0][0] = c_12;
    const double omega = x[5];
    const double sin_omega = em_sin(omega);
    const double c_13 = c[59];
    M4[0][1] = M4[1][0] = c_12 - sin_omega*c_13;
    const double u_ = c[33];
    const double c_14 = c[60];
    const double z_10 = u_ - c_14*sin_omega;
    const double c_15 = c[61];
    const double c_16 = c[62];
    const double cos_omega = em_cos(omega);
    const double c_17 = c[63];
    const double z_12 = z_10*c_17;
    const double c_18 = c[64];
    M4[1][1] = z_10*c_15 + c_16*(cos_omega*cos_omega) + c_18 - sin_omega*z_12;
    const double beta = x[0];
    const double sin_beta = em_sin(beta);
    const double d = c[20];
    const double cos_beta = em_cos(beta);
    const double z_15 = d*(sin_theta*cos_beta + cos_theta*sin_beta);
    A1[0][0] = -(rr*sin_beta - z_15);
    A1[0][1] = z_15;
    const double z_16 = d*(cos_theta*cos_beta - sin_theta*sin_beta);
    A1[1][0] = rr*cos_beta - z_16;
    A1[1][1] = -z_16;
    A1[2][0] = -(rr*sin_beta - z_15);
    A1[2][1] = z_15;
    A1[3][0] = rr*cos_beta - z_16;
    A1[3][1] = -z_16;
    A1[4][0] = -(rr*sin_beta - z_15);
    A1[4][1] = z_15;
    A1[5][0] = rr*cos_beta - z_16;
    A1[5][1] = -z_16;
    const double ss = c[26];
    const double gamma = x[2];
    const double cos_gamma = em_cos(gamma);
    A2[0][0] = -ss*cos_gamma;
    const double sin_gamma = em_sin(gamma);
    A2[1][0] = -ss*sin_gamma;
    A2[2][0] = 0.0;
    A2[3][0] = 0.0;
    A2[4][0] = 0.0;
    A2[5][0] = 0.0;
    A3[0][0] = 0.0;
    A3[0][1] = 0.0;
    A3[1][0] = 0.0;
    A3[1][1] = 0.0;
    const double e = c[22];
    const double delta = x[4];
    const double cos_delta = em_cos(delta);
    const double sin_delta = em_sin(delta);
    const double z_21 = e*(cos_phi*cos_delta - sin_phi*sin_delta);
    A3[2][0] = -z_21;
    A3[2][1] = zt*sin_delta - z_21;
    const double z_22 = e*(sin_phi*cos_delta + cos_phi*sin_delta);
    A3[3][0] = -z_22;
    A3[3][1] = -(zt*cos_delta + z_22);
    A3[4][0] = 0.0;
    A3[4][1] = 0.0;
    A3[5][0] = 0.0;
    A3[5][1] = 0.0;
    A4[0][0] = 0.0;
    A4[0][1] = 0.0;
    A4[1][0] = 0.0;
    A4[1][1] = 0.0;
    A4[2][0] = 0.0;
    A4[2][1] = 0.0;
    A4[3][0] = 0.0;
    A4[3][1] = 0.0;
    const double zf = c[36];
    const double epsilon = x[6];
    const double cos_epsilon = em_cos(epsilon);
    const double sin_epsilon = em_sin(epsilon);
    const double z_25 = zf*(sin_omega*cos_epsilon + cos_omega*sin_epsilon);
    A4[4][0] = z_25;
    A4[4][1] = -(u_*cos_epsilon - z_25);
    const double z_26 = zf*(cos_omega*cos_epsilon - sin_omega*sin_epsilon);
    A4[5][0] = -z_26;
    A4[5][1] = -(u_*sin_epsilon + z_26);
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    b[4] = 0.0;
    b[5] = 0.0;
    shared[0] = sin_theta;
    shared[1] = cos_theta;
    shared[2] = z_3;
    shared[3] = cos_phi;
    shared[4] = sin_phi;
    shared[5] = z_8;
    shared[6] = cos_omega;
    shared[7] = sin_omega;
    shared[8] = z_12;
}

/* Mdot */
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[9],
                             double Mdot1[N1][N1], double Mdot3[N3][N3], double Mdot4[N4][N4])
{
    const double c_19 = c[65];
    const double theta_dot = v[1];
    const double sin_theta = shared[0];
    const double z_27 = theta_dot*sin_theta;
    const double c_2 = c[48];
    const double cos_theta = shared[1];
    const double z_28 = cos_theta*z_27;
    const double z_3 = shared[2];
    const double c_20 = c[66];
    const double z_29 = (c_2*z_28 - z_27*z_3) - c_20*z_28;
    Mdot1[0][0] = c_19*z_27 - z_29;
    Mdot1[0][1] = Mdot1[1][0] = -z_29;
    Mdot1[1][1] = 0.0;
    Mdot3[0][0] = 0.0;
    const double c_6 = c[52];
    const double phi_dot = v[3];
    const double cos_phi = shared[3];
    const double z_30 = phi_dot*cos_phi;
    const double z_31 = c_6*z_30;
    Mdot3[0][1] = Mdot3[1][0] = -z_31;
    const double c_9 = c[55];
    const double sin_phi = shared[4];
    const double z_32 = sin_phi*z_30;
    const double z_8 = shared[5];
    const double c_21 = c[67];
    Mdot3[1][1] = -(z_31 + c_21*z_32 - (c_9*z_32 - z_30*z_8));
    Mdot4[0][0] = 0.0;
    const double c_13 = c[59];
    const double omega_dot = v[5];
    const double cos_omega = shared[6];
    const double z_33 = omega_dot*cos_omega;
    const double z_34 = c_13*z_33;
    Mdot4[0][1] = Mdot4[1][0] = -z_34;
    const double c_16 = c[62];
    const double sin_omega = shared[7];
    const double z_35 = sin_omega*z_33;
    const double z_12 = shared[8];
    const double c_22 = c[68];
    Mdot4[1][1] = -(z_34 + c_22*z_35 - (c_16*z_35 - z_33*z_12));
}

/* After an accepted step, and at the start: constraints on positions, C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], M3[N3][N3], M4[N4][N4], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], A4[N_ROWS][N4],
           b[N_ROWS], shared[9];
    settled_masses(y, c, M1, M3, M4, A1, A2, A3, A4, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;
    if (changed && em_settle_factors(&block3, *mode, 0, M3[0], y, memory, fault)) return -1;
    if (changed && em_settle_factors(&block4, *mode, 0, M4[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 26);
    gap = fmin(gap, em_gap(N3, y + 28));
    gap = fmin(gap, em_gap(N4, y + 30));
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block2, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block3, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block4, *mode, y + N, y, c, memory, dy);
        double Mdot1[N1][N1], Mdot3[N3][N3], Mdot4[N4][N4];
        settled_rates(dy, c, shared, Mdot1, Mdot3, Mdot4);
        double time = em_time_of_block(&block1, Mdot1[0], y);
        time = fmin(time, em_time_of_block(&block3, Mdot3[0], y));
        time = fmin(time, em_time_of_block(&block4, Mdot4[0], y));
        wanted = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != wanted) {
        if (em_change_mode(&block1, wanted, M1[0], y, memory, fault)) return -1;
        if (em_change_mode(&block3, wanted, M3[0], y, memory, fault)) return -1;
        if (em_change_mode(&block4, wanted, M4[0], y, memory, fault)) return -1;
        *mode = wanted;
        changed = 1;
    }

    if (flags & EM_STABILISE) { /* eta <- eta - B^T Delta^-1 (B eta + b) */
        double B1[N_ROWS][N1], a1[N1];
        em_rows_of_block(&block1, *mode, N_ROWS, y, c, memory, A1[0], B1[0]);
        em_take(&block1, y + N, a1);
        double B2[N_ROWS][N2], a2[N2];
        em_rows_of_block(&block2, *mode, N_ROWS, y, c, memory, A2[0], B2[0]);
        em_take(&block2, y + N, a2);
        double B3[N_ROWS][N3], a3[N3];
        em_rows_of_block(&block3, *mode, N_ROWS, y, c, memory, A3[0], B3[0]);
        em_take(&block3, y + N, a3);
        double B4[N_ROWS][N4], a4[N4];
        em_rows_of_block(&block4, *mode, N_ROWS, y, c, memory, A4[0], B4[0]);
        em_take(&block4, y + N, a4);

        /* Delta = B B^T (43), Delta lambda = B a (46), in one loop */
        real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
        for (int row = 0; row < N_ROWS; ++row) {
            lambda[row] = b[row];
            em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
            em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
            em_add_to_load(N3, row, B3[0], a3, NULL, lambda);
            em_add_to_load(N4, row, B4[0], a4, NULL, lambda);
            for (int column = 0; column <= row; ++column) {
                Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
                em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
                em_add_product(N3, B3[row], B3[column], &Delta[row*N_ROWS + column]);
                em_add_product(N4, B4[row], B4[column], &Delta[row*N_ROWS + column]);
            }
        }
        if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;
        em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
        em_put(&block1, a1, y + N);
        em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
        em_put(&block2, a2, y + N);
        em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
        em_put(&block3, a3, y + N);
        em_subtract_reactions(N_ROWS, N4, B4[0], lambda, a4);
        em_put(&block4, a4, y + N);
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
    if (em_velocity_at(&block3, mode, M, y, c, v, fault)) return -1;
    if (em_velocity_at(&block4, mode, M, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that an error e (n) of eta makes. */
EM_ACROSS void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, mode, e, y, c, memory, ev);
    em_velocity_kept(&block2, mode, e, y, c, memory, ev);
    em_velocity_kept(&block3, mode, e, y, c, memory, ev);
    em_velocity_kept(&block4, mode, e, y, c, memory, ev);
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
    em_publish_block(&block3, v, y, row);
    em_publish_block(&block4, v, y, row);
    return 0;
}

/* y (n_state) from x, v (n); eigenfactors continuous with those y holds, if any */
EM_ACROSS int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    double C[N*N] = {0.0}, s[N], eta[N];
    em_spread(N, N1, coordinate1, y + 14, C);
    em_spread(N, N3, coordinate3, y + 18, C);
    em_spread(N, N4, coordinate4, y + 22, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 14);
    for (int i = 0; i < N1; ++i) y[26 + i] = s[coordinate1[i]];
    em_gather(N, N3, coordinate3, C, y + 18);
    for (int i = 0; i < N3; ++i) y[28 + i] = s[coordinate3[i]];
    em_gather(N, N4, coordinate4, C, y + 22);
    for (int i = 0; i < N4; ++i) y[30 + i] = s[coordinate4[i]];
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
    if (em_coincident_block(&block3, y, fault)) return -1;
    if (em_coincident_block(&block4, y, fault)) return -1;
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "andrews.h"

static const char *const coordinate_names[] = { "beta", "theta", "gamma", "phi", "delta", "omega", "epsilon", NULL };
static const char *const parameter_names[] = { "m1", "m2", "m3", "m4", "m5", "m6", "m7", "I1", "I2", "I3", "I4", "I5",
    "I6", "I7", "xa", "ya", "xb", "yb", "xc", "yc", "d", "da", "e", "ea", "rr", "ra", "ss", "sa", "sb", "sc", "sd",
    "ta", "tb", "u", "ua", "ub", "zf", "zt", "fa", "c0", "l0", "mom", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 0.04325, 0.00365, 0.02373, 0.00706, 0.0705, 0.00706, 0.05498, 2.194e-06,
    4.41e-07, 5.255e-06, 5.667e-07, 1.169e-05, 5.667e-07, 1.912e-05, -0.06934, -0.00227, -0.03635, 0.03273, 0.014,
    0.072, 0.028, 0.0115, 0.02, 0.01421, 0.007, 0.00092, 0.035, 0.01874, 0.01043, 0.018, 0.02, 0.02308, 0.00916, 0.04,
    0.01228, 0.00449, 0.02, 0.04, 0.01421, 4530.0, 0.07785, 0.033, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { -0.06171389001427645, 0.0, 0.45527981916307037, 0.22266839016588588,
    0.48736497954384256, -0.22266839016588588, 1.2305474445498212 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 0, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 2},
    {"ground", 2, 2},
    {"ground", 4, 2},
    {"spring", 6, 4},
    {"body", 10, 6},
    {"line", 16, 4},
    {"line", 20, 4},
    {"line", 24, 4},
    {"line", 28, 4},
    {"line", 32, 4},
    {"line", 36, 4},
    {"disk", 40, 3},
    {"trace", 43, 2}
};
static const em_slice layout[] = {
    {"x", 0, 7},
    {"eta", 7, 7},
    {"C", 14, 12},
    {"s", 26, 6}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dbeta, dM/dgamma, dM/ddelta, dM/depsilon: M does not depend on them",
    "C, mu, Omega across blocks: {beta, theta}, {gamma}, {phi, delta}, {omega, epsilon} do not couple",
    "C, s, mu, Omega of {gamma}: this block is constant, factored once per parameter set",
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
    .rows = em_rows_at,
    .settle_motion = em_settle_motion,
    .reach = em_newton_from_afar,
    .worst_factors = em_worst_factors_of,
};

/* What of the stepper is told which model it is of: a run, */
static int simulate(em_run *run) { return em_simulate(&andrews_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&andrews_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&andrews_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&andrews_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&andrews_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&andrews_model, run, mode); }

const em_model andrews_model = {
    .abi = EM_ABI,
    .name = "andrews",
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
    .n_left_out = 8,
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
    .lanes = &andrews_lanes,
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
    .n_shapes = 13,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .constraint_partials = constraint_partials,
    .motion_along = em_motion_along,
    .tangent = em_tangent,
    .dynamics = &dynamics,
    .declared = declared,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
