/* eigenmotion generate jansen.py */
/* input sha256:9113c7d3da69da5ecbaab47b3131a16b8c566b951a7903843a9a629179d381f5 */
/* body sha256:255621e952eebabdd4c4535ce678d59bfe9c4292a89c2ad6a23a9563e77a91f3 */
/* jansen: equations of motion, eigenfactor formulation.
 *
 * State, 70 numbers:
 *   x    y[0 .. 7)
 *   eta  y[7 .. 14)
 *   C    y[14 .. 63)
 *   s    y[63 .. 70)
 *
 * Blocks of M that do not couple:
 *   1: theta, aj, ab, ak, ac, af, ag (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   M^-1: M is singular; M + A^T W A is factored, with weights W of rows 0, 2, 4
 *
 * Operations of the straight-line part:
 *   eigenfactor: 79 additions, 229 multiplications, 14 function calls
 *   triangular root: 91 additions, 288 multiplications, 14 function calls
 *   projection: 43 additions, 186 multiplications, 14 function calls
 */
#include "jansen.h"

#include "em_functions.h"
#include "em_multipliers.h"

enum {
    N = 7,              /* coordinates */
    N_ROWS = 6,         /* constraint rows */
    N_POSITIONS = 6,    /* of which holonomic */
    N_STATE = 70,       /* numbers of a state */
    N_C = 49,           /* of which C, */
    N_S = 7,            /* s, */
    N_CD = 0,           /* C of Delta, */
    N_SD = 0,           /* s of Delta */
    N_INPUTS = 0,
    N_OUTPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 56,      /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,/* whether the state is x, xdot */
    SETTLES = 1,        /* whether an accepted step leaves anything to put right */
    N_PARAMETERS = 17,
    N_PREPARED = 115,   /* the parameters, factors of constant blocks, shared constants */
    N1 = 7,             /* theta, aj, ab, ak, ac, af, ag */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4, 5, 6 };

#ifndef EM_ASIDE_ALONE

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real c_0 = c[17];
    const real theta = x[0];
    const real sin_theta = em_sin(theta);
    const real theta_dot = v[0];
    const real cos_theta = em_cos(theta);
    const real z_2 = theta_dot*cos_theta;
    Mdot1[0][0] = c_0*(sin_theta*z_2);
    const real c_1 = c[18];
    const real aj = x[1];
    const real sin_aj = em_sin(aj);
    const real aj_dot = v[1];
    const real cos_aj = em_cos(aj);
    const real z_5 = aj_dot*cos_aj;
    Mdot1[0][1] = Mdot1[1][0] = (1.0/3.0)*(c_1*(sin_aj*z_2 + sin_theta*z_5));
    const real c_2 = c[19];
    Mdot1[1][1] = c_2*(sin_aj*z_5);
    const real c_3 = c[20];
    const real ab_dot = v[2];
    const real ab = x[2];
    const real sin_ab = em_sin(ab);
    const real z_7 = ab_dot*sin_ab;
    const real cos_ab = em_cos(ab);
    const real z_9 = theta_dot*sin_theta;
    const real c_4 = c[21];
    const real z_10 = ab_dot*cos_ab;
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/6.0))*(c_3*(cos_theta*z_7 + cos_ab*z_9) - c_4*(sin_theta*z_10 +
        sin_ab*z_2));
    const real c_5 = c[22];
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/3.0))*(c_5*(sin_aj*z_10 + sin_ab*z_5));
    const real c_6 = c[23];
    const real c_7 = c[24];
    const real z_11 = sin_ab*c_6 + cos_ab*c_7;
    const real c_8 = c[25];
    const real z_12 = c_6*z_10 - c_7*z_7;
    const real z_13 = c_8*z_12;
    const real c_9 = c[26];
    Mdot1[2][2] = (1.0/6.0)*(z_11*z_13 + c_9*(sin_ab*z_10));
    const real c_10 = c[27];
    const real ak = x[3];
    const real sin_ak = em_sin(ak);
    const real ak_dot = v[3];
    const real cos_ak = em_cos(ak);
    const real z_16 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = (1.0/3.0)*(c_10*(sin_ak*z_2 + sin_theta*z_16));
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    const real c_11 = c[28];
    Mdot1[3][3] = c_11*(sin_ak*z_16);
    const real c_12 = c[29];
    const real ac = x[4];
    const real cos_ac = em_cos(ac);
    const real ac_dot = v[4];
    const real sin_ac = em_sin(ac);
    const real z_19 = ac_dot*sin_ac;
    const real c_13 = c[30];
    const real z_20 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_12*(cos_ac*z_9 + cos_theta*z_19) - c_13*(sin_ac*z_2 +
        sin_theta*z_20));
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_14 = c[31];
    const real z_21 = cos_ab*c_6 - sin_ab*c_7;
    const real z_22 = c_6*z_7 + c_7*z_10;
    const real c_15 = c[32];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_14*(z_21*z_19 + cos_ac*z_22) - c_15*(z_11*z_20 + sin_ac*z_12));
    const real c_16 = c[33];
    Mdot1[3][4] = Mdot1[4][3] = ((-1.0/3.0))*(c_16*(sin_ak*z_20 + sin_ac*z_16));
    const real c_17 = c[34];
    Mdot1[4][4] = c_17*(sin_ac*z_20);
    Mdot1[0][5] = Mdot1[5][0] = em_real(0.0);
    Mdot1[1][5] = Mdot1[5][1] = em_real(0.0);
    const real c_18 = c[35];
    const real af = x[5];
    const real sin_af = em_sin(af);
    const real af_dot = v[5];
    const real cos_af = em_cos(af);
    const real z_25 = af_dot*cos_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_18*(sin_af*z_12 + z_11*z_25));
    Mdot1[3][5] = Mdot1[5][3] = em_real(0.0);
    const real c_19 = c[36];
    Mdot1[4][5] = Mdot1[5][4] = ((-1.0/3.0))*(c_19*(sin_af*z_20 + sin_ac*z_25));
    const real c_20 = c[37];
    Mdot1[5][5] = c_20*(sin_af*z_25);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real c_21 = c[38];
    const real ag = x[6];
    const real cos_ag = em_cos(ag);
    const real ag_dot = v[6];
    const real sin_ag = em_sin(ag);
    const real z_28 = ag_dot*sin_ag;
    const real c_22 = c[39];
    const real z_29 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_21*(cos_ag*z_22 + z_21*z_28) - c_22*(sin_ag*z_12 + z_11*z_29));
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    const real c_23 = c[40];
    const real c_24 = c[41];
    const real c_25 = c[42];
    Mdot1[4][6] = Mdot1[6][4] = ((-1.0/12.0))*(c_23*(cos_ag*z_19 + cos_ac*z_28) - 2.0*c_24*(sin_ag*z_19 -
        cos_ac*z_29) - 2.0*c_24*(cos_ag*z_20 - sin_ac*z_28) - c_25*(sin_ag*z_20 + sin_ac*z_29));
    const real c_26 = c[43];
    Mdot1[5][6] = Mdot1[6][5] = ((-1.0/3.0))*(c_26*(sin_af*z_29 + sin_ag*z_25));
    const real c_27 = c[44];
    Mdot1[6][6] = c_27*(sin_ag*z_29);
    const real z_30 = theta_dot*ab_dot*(c_3*(cos_ab*sin_theta - cos_theta*sin_ab));
    const real z_31 = theta_dot*ac_dot*(c_12*(sin_theta*cos_ac - cos_theta*sin_ac));
    const real c_28 = c[45];
    const real c_29 = c[46];
    const real m = c[12];
    const real z_32 = m*z_9;
    const real j = c[9];
    const real z_33 = j*sin_aj;
    const real b = c[1];
    const real z_34 = z_32 + aj_dot*z_33 - b*z_7;
    const real c_30 = c[47];
    const real c_ = c[2];
    const real k = c[10];
    const real z_35 = k*sin_ak;
    const real z_36 = c_*z_19 - z_32 - ak_dot*z_35;
    const real c_31 = c[48];
    f1[0] = ((-1.0/6.0))*(((z_30 + z_31) - 3.0*(c_29 - cos_theta*c_28)) - 2.0*(z_34*c_30*z_2 - z_36*c_31*z_2));
    const real c_32 = c[49];
    f1[1] = c_32*(z_34*z_5);
    const real z_37 = ab_dot*ac_dot*(c_14*(cos_ac*z_11 - sin_ac*z_21));
    const real z_38 = ab_dot*ag_dot*(c_21*(z_11*cos_ag - z_21*sin_ag));
    const real c_33 = c[50];
    const real c_34 = c[51];
    const real c_35 = c[52];
    const real c_36 = c[53];
    const real c_37 = c[54];
    const real z_39 = sin_af*c_37;
    const real z_40 = c_35*z_19 + c_36*z_28 - ab_dot*z_11 - af_dot*z_39;
    const real c_38 = c[55];
    f1[2] = (1.0/12.0)*(((2.0*z_30 - z_37 - z_38) - 3.0*(cos_ab*c_33 - sin_ab*c_34)) - (z_40*z_13 +
        c_38*(z_34*z_10)));
    const real c_39 = c[56];
    f1[3] = -c_39*(z_36*z_16);
    const real c_40 = c[57];
    const real z_41 = ac_dot*ag_dot*(sin_ac*(cos_ag*c_23) - sin_ag*(cos_ac*c_23) - c_40*(sin_ac*sin_ag) -
        c_40*(cos_ac*cos_ag));
    const real c_41 = c[58];
    const real c_42 = c[59];
    const real c_43 = c[60];
    f1[4] = (1.0/12.0)*(((2.0*z_31 + z_37 - z_41) - cos_ac*c_41) + 2.0*(c_42*z_40*z_20 + c_43*(z_36*z_20)));
    const real c_44 = c[61];
    f1[5] = -c_44*(z_40*z_25);
    const real c_45 = c[62];
    const real c_46 = c[63];
    const real c_47 = c[64];
    f1[6] = (1.0/12.0)*(((z_38 + z_41) - 3.0*(cos_ag*c_45 - sin_ag*c_46)) + c_47*(z_40*z_29));
    const real z_42 = m*sin_theta;
    A1[0][0] = -z_42;
    A1[0][1] = -z_33;
    const real z_43 = b*sin_ab;
    A1[0][2] = z_43;
    A1[0][3] = em_real(0.0);
    A1[0][4] = em_real(0.0);
    A1[0][5] = em_real(0.0);
    A1[0][6] = em_real(0.0);
    const real z_44 = m*cos_theta;
    A1[1][0] = z_44;
    const real z_45 = j*cos_aj;
    A1[1][1] = z_45;
    const real z_46 = b*cos_ab;
    A1[1][2] = -z_46;
    A1[1][3] = em_real(0.0);
    A1[1][4] = em_real(0.0);
    A1[1][5] = em_real(0.0);
    A1[1][6] = em_real(0.0);
    A1[2][0] = -z_42;
    A1[2][1] = em_real(0.0);
    A1[2][2] = em_real(0.0);
    A1[2][3] = -z_35;
    const real z_47 = c_*sin_ac;
    A1[2][4] = z_47;
    A1[2][5] = em_real(0.0);
    A1[2][6] = em_real(0.0);
    A1[3][0] = z_44;
    A1[3][1] = em_real(0.0);
    A1[3][2] = em_real(0.0);
    const real z_48 = k*cos_ak;
    A1[3][3] = z_48;
    const real z_49 = c_*cos_ac;
    A1[3][4] = -z_49;
    A1[3][5] = em_real(0.0);
    A1[3][6] = em_real(0.0);
    A1[4][0] = em_real(0.0);
    A1[4][1] = em_real(0.0);
    A1[4][2] = (-0.5)*z_11;
    A1[4][3] = em_real(0.0);
    A1[4][4] = z_47;
    const real f = c[5];
    A1[4][5] = -f*sin_af;
    const real g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = em_real(0.0);
    A1[5][1] = em_real(0.0);
    A1[5][2] = 0.5*z_21;
    A1[5][3] = em_real(0.0);
    A1[5][4] = -z_49;
    A1[5][5] = f*cos_af;
    A1[5][6] = -g*cos_ag;
    const real z_50 = theta_dot*theta_dot;
    const real z_51 = z_44*z_50;
    const real z_52 = aj_dot*aj_dot;
    const real z_53 = ab_dot*ab_dot;
    gamma[0] = -(z_51 + z_45*z_52 - z_46*z_53);
    const real z_54 = z_42*z_50;
    gamma[1] = -(z_54 + z_33*z_52 - z_43*z_53);
    const real z_55 = ak_dot*ak_dot;
    const real z_56 = ac_dot*ac_dot;
    gamma[2] = -(z_51 + z_48*z_55 - z_49*z_56);
    gamma[3] = -(z_54 + z_35*z_55 - z_47*z_56);
    const real z_57 = c_35*z_56;
    const real z_58 = af_dot*af_dot;
    const real z_59 = c_36*(ag_dot*ag_dot);
    gamma[4] = 0.5*(cos_ac*z_57 + cos_ag*z_59 - ab_dot*z_12 - cos_af*c_37*z_58);
    gamma[5] = 0.5*(sin_ac*z_57 + sin_ag*z_59 - ab_dot*z_22 - z_58*z_39);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{
    (void)t, (void)c, (void)fault;

    /* theta, aj, ab, ak, ac, af, ag: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[7], y[8], y[9], y[10], y[11], y[12], y[13] };
    const real *const C1 = y + 14, *const s1 = y + 63;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];
    dy[6] = v1[6];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{
    (void)t, (void)c, (void)u, (void)memory, (void)flags, (void)fault;

    /* theta, aj, ab, ak, ac, af, ag: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[7], y[8], y[9], y[10], y[11], y[12], y[13] };
    const real *const C1 = y + 14, *const s1 = y + 63;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];
    dy[6] = v1[6];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, f1, A1, gamma);

    /* theta, aj, ab, ak, ac, af, ag: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* theta, aj, ab, ak, ac, af, ag: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real mu1[N1*N1], Omega1[N1*N1];
    em_congruence(N1, C1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 14, *const s1_dot = dy + 63;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a1[N1], q1[N1];
    em_turning_push(N1, C1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, q1);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46): one loop, which is ready soonest */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_real(0.0);
            em_add_product(N1, B1[row], B1[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[7] = a1[0];
    dy[8] = a1[1];
    dy[9] = a1[2];
    dy[10] = a1[3];
    dy[11] = a1[4];
    dy[12] = a1[5];
    dy[13] = a1[6];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[17])
{
    const real c_80 = c[97];
    const real c_81 = c[98];
    const real theta = x[0];
    const real sin_theta = em_sin(theta);
    M1[0][0] = (1.0/3.0)*(c_80 + c_81*(sin_theta*sin_theta));
    const real c_82 = c[99];
    const real aj = x[1];
    const real sin_aj = em_sin(aj);
    M1[1][0] = c_82*(sin_theta*sin_aj);
    const real c_83 = c[100];
    M1[1][1] = c_83*(sin_aj*sin_aj);
    const real cos_theta = em_cos(theta);
    const real ab = x[2];
    const real cos_ab = em_cos(ab);
    const real c_3 = c[20];
    const real sin_ab = em_sin(ab);
    const real c_4 = c[21];
    M1[2][0] = (1.0/6.0)*(cos_theta*(cos_ab*c_3) + sin_theta*(sin_ab*c_4));
    const real c_84 = c[101];
    M1[2][1] = -c_84*(sin_ab*sin_aj);
    const real c_65 = c[82];
    const real c_8 = c[25];
    const real c_6 = c[23];
    const real c_7 = c[24];
    const real z_5 = sin_ab*c_6 + cos_ab*c_7;
    const real c_9 = c[26];
    M1[2][2] = (1.0/12.0)*(c_65 + c_8*(z_5*z_5) + c_9*(sin_ab*sin_ab));
    const real c_85 = c[102];
    const real ak = x[3];
    const real sin_ak = em_sin(ak);
    M1[3][0] = c_85*(sin_theta*sin_ak);
    M1[3][1] = em_real(0.0);
    M1[3][2] = em_real(0.0);
    const real c_86 = c[103];
    M1[3][3] = c_86*(sin_ak*sin_ak);
    const real ac = x[4];
    const real cos_ac = em_cos(ac);
    const real c_12 = c[29];
    const real sin_ac = em_sin(ac);
    const real c_13 = c[30];
    M1[4][0] = (1.0/6.0)*(cos_ac*(cos_theta*c_12) + sin_ac*(sin_theta*c_13));
    M1[4][1] = em_real(0.0);
    const real z_9 = cos_ab*c_6 - sin_ab*c_7;
    const real c_14 = c[31];
    const real c_15 = c[32];
    M1[4][2] = (1.0/12.0)*(z_9*(cos_ac*c_14) + z_5*(sin_ac*c_15));
    const real c_87 = c[104];
    M1[4][3] = -c_87*(sin_ac*sin_ak);
    const real c_88 = c[105];
    const real c_89 = c[106];
    M1[4][4] = (1.0/6.0)*(c_88 + c_89*(sin_ac*sin_ac));
    M1[5][0] = em_real(0.0);
    M1[5][1] = em_real(0.0);
    const real c_44 = c[61];
    const real af = x[5];
    const real sin_af = em_sin(af);
    M1[5][2] = c_44*(z_5*sin_af);
    M1[5][3] = em_real(0.0);
    const real c_90 = c[107];
    M1[5][4] = -c_90*(sin_ac*sin_af);
    const real c_91 = c[108];
    M1[5][5] = c_91*(sin_af*sin_af);
    M1[6][0] = em_real(0.0);
    M1[6][1] = em_real(0.0);
    const real ag = x[6];
    const real cos_ag = em_cos(ag);
    const real c_21 = c[38];
    const real sin_ag = em_sin(ag);
    const real c_22 = c[39];
    M1[6][2] = (1.0/12.0)*(cos_ag*(z_9*c_21) + sin_ag*(z_5*c_22));
    M1[6][3] = em_real(0.0);
    const real c_23 = c[40];
    const real z_13 = cos_ac*cos_ag;
    const real c_25 = c[42];
    const real z_14 = sin_ac*sin_ag;
    const real c_40 = c[57];
    const real z_15 = cos_ac*sin_ag;
    const real z_16 = sin_ac*cos_ag;
    M1[6][4] = (1.0/12.0)*(c_23*z_13 + c_25*z_14 + c_40*z_16 - c_40*z_15);
    const real c_92 = c[109];
    M1[6][5] = -c_92*(sin_ag*sin_af);
    const real c_67 = c[84];
    const real c_93 = c[110];
    M1[6][6] = (1.0/12.0)*(c_67 + c_93*(sin_ag*sin_ag));
    shared[0] = sin_theta;
    shared[1] = cos_theta;
    shared[2] = sin_aj;
    shared[3] = sin_ab;
    shared[4] = cos_ab;
    shared[5] = z_5;
    shared[6] = sin_ak;
    shared[7] = cos_ac;
    shared[8] = sin_ac;
    shared[9] = z_9;
    shared[10] = sin_af;
    shared[11] = cos_ag;
    shared[12] = sin_ag;
    shared[13] = z_16;
    shared[14] = z_15;
    shared[15] = z_14;
    shared[16] = z_13;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[17], real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1],
                                 real gamma[N_ROWS])
{
    const real c_0 = c[17];
    const real sin_theta = shared[0];
    const real theta_dot = v[0];
    const real cos_theta = shared[1];
    const real z_17 = theta_dot*cos_theta;
    Mdot1[0][0] = c_0*(sin_theta*z_17);
    const real c_1 = c[18];
    const real sin_aj = shared[2];
    const real aj_dot = v[1];
    const real aj = x[1];
    const real cos_aj = em_cos(aj);
    const real z_19 = aj_dot*cos_aj;
    Mdot1[0][1] = Mdot1[1][0] = (1.0/3.0)*(c_1*(sin_aj*z_17 + sin_theta*z_19));
    const real c_2 = c[19];
    Mdot1[1][1] = c_2*(sin_aj*z_19);
    const real c_3 = c[20];
    const real ab_dot = v[2];
    const real sin_ab = shared[3];
    const real z_20 = ab_dot*sin_ab;
    const real cos_ab = shared[4];
    const real z_21 = theta_dot*sin_theta;
    const real c_4 = c[21];
    const real z_22 = ab_dot*cos_ab;
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/6.0))*(c_3*(cos_theta*z_20 + cos_ab*z_21) - c_4*(sin_theta*z_22 +
        sin_ab*z_17));
    const real c_5 = c[22];
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/3.0))*(c_5*(sin_aj*z_22 + sin_ab*z_19));
    const real z_5 = shared[5];
    const real c_8 = c[25];
    const real c_6 = c[23];
    const real c_7 = c[24];
    const real z_23 = c_6*z_22 - c_7*z_20;
    const real z_24 = c_8*z_23;
    const real c_9 = c[26];
    Mdot1[2][2] = (1.0/6.0)*(z_5*z_24 + c_9*(sin_ab*z_22));
    const real c_10 = c[27];
    const real sin_ak = shared[6];
    const real ak_dot = v[3];
    const real ak = x[3];
    const real cos_ak = em_cos(ak);
    const real z_26 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = (1.0/3.0)*(c_10*(sin_ak*z_17 + sin_theta*z_26));
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    const real c_11 = c[28];
    Mdot1[3][3] = c_11*(sin_ak*z_26);
    const real c_12 = c[29];
    const real cos_ac = shared[7];
    const real ac_dot = v[4];
    const real sin_ac = shared[8];
    const real z_27 = ac_dot*sin_ac;
    const real c_13 = c[30];
    const real z_28 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_12*(cos_ac*z_21 + cos_theta*z_27) - c_13*(sin_ac*z_17 +
        sin_theta*z_28));
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_14 = c[31];
    const real z_9 = shared[9];
    const real z_29 = c_6*z_20 + c_7*z_22;
    const real c_15 = c[32];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_14*(z_9*z_27 + cos_ac*z_29) - c_15*(z_5*z_28 + sin_ac*z_23));
    const real c_16 = c[33];
    Mdot1[3][4] = Mdot1[4][3] = ((-1.0/3.0))*(c_16*(sin_ak*z_28 + sin_ac*z_26));
    const real c_17 = c[34];
    Mdot1[4][4] = c_17*(sin_ac*z_28);
    Mdot1[0][5] = Mdot1[5][0] = em_real(0.0);
    Mdot1[1][5] = Mdot1[5][1] = em_real(0.0);
    const real c_18 = c[35];
    const real sin_af = shared[10];
    const real af_dot = v[5];
    const real af = x[5];
    const real cos_af = em_cos(af);
    const real z_31 = af_dot*cos_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_18*(sin_af*z_23 + z_5*z_31));
    Mdot1[3][5] = Mdot1[5][3] = em_real(0.0);
    const real c_19 = c[36];
    Mdot1[4][5] = Mdot1[5][4] = ((-1.0/3.0))*(c_19*(sin_af*z_28 + sin_ac*z_31));
    const real c_20 = c[37];
    Mdot1[5][5] = c_20*(sin_af*z_31);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real c_21 = c[38];
    const real cos_ag = shared[11];
    const real ag_dot = v[6];
    const real sin_ag = shared[12];
    const real z_32 = ag_dot*sin_ag;
    const real c_22 = c[39];
    const real z_33 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_21*(cos_ag*z_29 + z_9*z_32) - c_22*(sin_ag*z_23 + z_5*z_33));
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    const real c_23 = c[40];
    const real c_24 = c[41];
    const real c_25 = c[42];
    Mdot1[4][6] = Mdot1[6][4] = ((-1.0/12.0))*(c_23*(cos_ag*z_27 + cos_ac*z_32) - 2.0*c_24*(sin_ag*z_27 -
        cos_ac*z_33) - 2.0*c_24*(cos_ag*z_28 - sin_ac*z_32) - c_25*(sin_ag*z_28 + sin_ac*z_33));
    const real c_26 = c[43];
    Mdot1[5][6] = Mdot1[6][5] = ((-1.0/3.0))*(c_26*(sin_af*z_33 + sin_ag*z_31));
    const real c_27 = c[44];
    Mdot1[6][6] = c_27*(sin_ag*z_33);
    const real z_34 = theta_dot*ab_dot*(c_3*(cos_ab*sin_theta - cos_theta*sin_ab));
    const real z_35 = theta_dot*ac_dot*(c_12*(sin_theta*cos_ac - cos_theta*sin_ac));
    const real c_28 = c[45];
    const real c_29 = c[46];
    const real m = c[12];
    const real z_36 = m*z_21;
    const real j = c[9];
    const real z_37 = j*sin_aj;
    const real b = c[1];
    const real z_38 = z_36 + aj_dot*z_37 - b*z_20;
    const real c_30 = c[47];
    const real c_ = c[2];
    const real k = c[10];
    const real z_39 = k*sin_ak;
    const real z_40 = c_*z_27 - z_36 - ak_dot*z_39;
    const real c_31 = c[48];
    f1[0] = ((-1.0/6.0))*(((z_34 + z_35) - 3.0*(c_29 - cos_theta*c_28)) - 2.0*(z_38*c_30*z_17 - z_40*c_31*z_17));
    const real c_32 = c[49];
    f1[1] = c_32*(z_38*z_19);
    const real z_41 = ab_dot*ac_dot*(c_14*(cos_ac*z_5 - sin_ac*z_9));
    const real z_42 = ab_dot*ag_dot*(c_21*(z_5*cos_ag - z_9*sin_ag));
    const real c_33 = c[50];
    const real c_34 = c[51];
    const real c_35 = c[52];
    const real c_36 = c[53];
    const real c_37 = c[54];
    const real z_43 = sin_af*c_37;
    const real z_44 = c_35*z_27 + c_36*z_32 - ab_dot*z_5 - af_dot*z_43;
    const real c_38 = c[55];
    f1[2] = (1.0/12.0)*(((2.0*z_34 - z_41 - z_42) - 3.0*(cos_ab*c_33 - sin_ab*c_34)) - (z_44*z_24 +
        c_38*(z_38*z_22)));
    const real c_39 = c[56];
    f1[3] = -c_39*(z_40*z_26);
    const real z_16 = shared[13];
    const real z_15 = shared[14];
    const real c_40 = c[57];
    const real z_14 = shared[15];
    const real z_13 = shared[16];
    const real z_45 = ac_dot*ag_dot*(c_23*z_16 - c_23*z_15 - c_40*z_14 - c_40*z_13);
    const real c_41 = c[58];
    const real c_42 = c[59];
    const real c_43 = c[60];
    f1[4] = (1.0/12.0)*(((2.0*z_35 + z_41 - z_45) - cos_ac*c_41) + 2.0*(c_42*z_44*z_28 + c_43*(z_40*z_28)));
    const real c_44 = c[61];
    f1[5] = -c_44*(z_44*z_31);
    const real c_45 = c[62];
    const real c_46 = c[63];
    const real c_47 = c[64];
    f1[6] = (1.0/12.0)*(((z_42 + z_45) - 3.0*(cos_ag*c_45 - sin_ag*c_46)) + c_47*(z_44*z_33));
    const real z_46 = m*sin_theta;
    A1[0][0] = -z_46;
    A1[0][1] = -z_37;
    const real z_47 = b*sin_ab;
    A1[0][2] = z_47;
    A1[0][3] = em_real(0.0);
    A1[0][4] = em_real(0.0);
    A1[0][5] = em_real(0.0);
    A1[0][6] = em_real(0.0);
    const real z_48 = m*cos_theta;
    A1[1][0] = z_48;
    const real z_49 = j*cos_aj;
    A1[1][1] = z_49;
    const real z_50 = b*cos_ab;
    A1[1][2] = -z_50;
    A1[1][3] = em_real(0.0);
    A1[1][4] = em_real(0.0);
    A1[1][5] = em_real(0.0);
    A1[1][6] = em_real(0.0);
    A1[2][0] = -z_46;
    A1[2][1] = em_real(0.0);
    A1[2][2] = em_real(0.0);
    A1[2][3] = -z_39;
    const real z_51 = c_*sin_ac;
    A1[2][4] = z_51;
    A1[2][5] = em_real(0.0);
    A1[2][6] = em_real(0.0);
    A1[3][0] = z_48;
    A1[3][1] = em_real(0.0);
    A1[3][2] = em_real(0.0);
    const real z_52 = k*cos_ak;
    A1[3][3] = z_52;
    const real z_53 = c_*cos_ac;
    A1[3][4] = -z_53;
    A1[3][5] = em_real(0.0);
    A1[3][6] = em_real(0.0);
    A1[4][0] = em_real(0.0);
    A1[4][1] = em_real(0.0);
    A1[4][2] = (-0.5)*z_5;
    A1[4][3] = em_real(0.0);
    A1[4][4] = z_51;
    const real f = c[5];
    A1[4][5] = -f*sin_af;
    const real g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = em_real(0.0);
    A1[5][1] = em_real(0.0);
    A1[5][2] = 0.5*z_9;
    A1[5][3] = em_real(0.0);
    A1[5][4] = -z_53;
    A1[5][5] = f*cos_af;
    A1[5][6] = -g*cos_ag;
    const real z_54 = theta_dot*theta_dot;
    const real z_55 = z_48*z_54;
    const real z_56 = aj_dot*aj_dot;
    const real z_57 = ab_dot*ab_dot;
    gamma[0] = -(z_55 + z_49*z_56 - z_50*z_57);
    const real z_58 = z_46*z_54;
    gamma[1] = -(z_58 + z_37*z_56 - z_47*z_57);
    const real z_59 = ak_dot*ak_dot;
    const real z_60 = ac_dot*ac_dot;
    gamma[2] = -(z_55 + z_52*z_59 - z_53*z_60);
    gamma[3] = -(z_58 + z_39*z_59 - z_51*z_60);
    const real z_61 = c_35*z_60;
    const real z_62 = af_dot*af_dot;
    const real z_63 = c_36*(ag_dot*ag_dot);
    gamma[4] = 0.5*(cos_ac*z_61 + cos_ag*z_63 - ab_dot*z_23 - cos_af*c_37*z_62);
    gamma[5] = 0.5*(sin_ac*z_61 + sin_ag*z_63 - ab_dot*z_29 - z_62*z_43);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    (void)t, (void)c, (void)u, (void)flags, (void)fault;
    real M1[N1][N1], shared[17];
    triangular_masses(y, c, M1, shared);

    /* theta, aj, ab, ak, ac, af, ag: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[7], y[8], y[9], y[10], y[11], y[12], y[13] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];
    dy[6] = v1[6];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    triangular_motion(y, dy, c, shared, Mdot1, f1, A1, gamma);

    /* theta, aj, ab, ak, ac, af, ag: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* theta, aj, ab, ak, ac, af, ag: B = A L^-T */
    real B1[N_ROWS][N1];
    em_rows_of_root(N_ROWS, N1, L1[0], r1, A1[0], B1[0]);
    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46): one loop, which is ready soonest */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_real(0.0);
            em_add_product(N1, B1[row], B1[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[7] = a1[0];
    dy[8] = a1[1];
    dy[9] = a1[2];
    dy[10] = a1[3];
    dy[11] = a1[4];
    dy[12] = a1[5];
    dy[13] = a1[6];
    for (int k = 2*N; k < N_STATE; ++k) dy[k] = em_real(0.0);
    return 0;
}

/* dy <- f(t, y): the published equations, or in mode 1 those of the triangular root. */
static int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags, real *dy,
                     em_fault *fault)
{
    (void)mode, (void)memory;
    if (mode) return rhs_cholesky(t, y, c, u, flags, dy, fault);
    return rhs_eigenfactor(t, y, c, u, memory, flags, dy, fault);
}

#endif
#ifdef EM_ON_LANES

/* Compiled with -DEM_ON_LANES this file is its right-hand side on vectors, to be linked beside. */
static void rhs_on_lanes(int mode, const double *t, const double *y, const double *c, const double *u, int flags,
                         double *dy)
{
    em_fault fault;
    model_rhs(mode, *(const real *)t, (const real *)y, (const real *)c, (const real *)u, NULL, flags, (real *)dy, &fault);
}

/* xdot alone (20) */
static void velocity_on_lanes(const double *t, const double *y, const double *c, double *v)
{
    em_fault fault;
    velocities(*(const real *)t, (const real *)y, (const real *)c, (real *)v, &fault);
}

extern em_lanes jansen_lanes;
em_lanes jansen_lanes = {EM_LANES, rhs_on_lanes, velocity_on_lanes, NULL};

#else

/* What no step calls. As it stands this file holds all; compilers may work side by side on this part alone, with
 * -DEM_ASIDE_ALONE, and on the others, with -DEM_ASIDE_ELSEWHERE. */
#ifdef EM_ASIDE_ELSEWHERE

extern void mass_matrix_gradient(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                                   double *restrict dM);
extern void factored_gradient(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                                double *restrict dM);
extern void motion_bias(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                          const double *restrict c, EM_UNUSED const double *restrict u, double *restrict bias,
                          double *restrict gamma);
extern void energy(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                     const double *restrict c, double *restrict e);
extern void observe(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                      EM_UNUSED const double *restrict v, EM_UNUSED const double *restrict a,
                      EM_UNUSED const double *restrict lambda, EM_UNUSED const double *restrict c,
                      EM_UNUSED const double *restrict u, EM_UNUSED double *restrict out);
extern void draw(EM_UNUSED double t, const double *restrict x, const double *restrict c, double *restrict p);

#else

/* dM (n, n, n): dM[k, i, j] = dM_ij / dx_k */
EM_RARE /* no step calls it */
EM_ASIDE void mass_matrix_gradient(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                                   double *restrict dM)
{
    memset(dM, 0, sizeof *dM * N * N * N);
    const double c_3 = c[20];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double z_4 = c_3*(cos_ab*sin_theta - cos_theta*sin_ab);
    dM[14] = dM[2] = ((-1.0/6.0))*z_4;
    const double c_12 = c[29];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double sin_ac = em_sin(ac);
    const double z_7 = c_12*(sin_theta*cos_ac - cos_theta*sin_ac);
    dM[28] = dM[4] = ((-1.0/6.0))*z_7;
    dM[112] = dM[100] = (1.0/6.0)*z_4;
    const double c_14 = c[31];
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_8 = sin_ab*c_6 + cos_ab*c_7;
    const double z_9 = cos_ab*c_6 - sin_ab*c_7;
    const double z_10 = c_14*(cos_ac*z_8 - sin_ac*z_9);
    dM[128] = dM[116] = ((-1.0/12.0))*z_10;
    const double c_21 = c[38];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    const double z_13 = c_21*(z_8*cos_ag - z_9*sin_ag);
    dM[142] = dM[118] = ((-1.0/12.0))*z_13;
    dM[224] = dM[200] = (1.0/6.0)*z_7;
    dM[226] = dM[214] = (1.0/12.0)*z_10;
    const double c_23 = c[40];
    const double c_40 = c[57];
    const double z_14 = sin_ac*cos_ag*c_23 - cos_ac*sin_ag*c_23 - c_40*(sin_ac*sin_ag) - c_40*(cos_ac*cos_ag);
    dM[242] = dM[230] = ((-1.0/12.0))*z_14;
    dM[338] = dM[314] = (1.0/12.0)*z_13;
    dM[340] = dM[328] = (1.0/12.0)*z_14;
}

/* dM (n, n, n), of what is factored */
EM_RARE /* no step calls it */
EM_ASIDE void factored_gradient(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                                double *restrict dM)
{
    memset(dM, 0, sizeof *dM * N * N * N);
    const double c_0 = c[17];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    dM[0] = c_0*(cos_theta*sin_theta);
    const double c_82 = c[99];
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    dM[7] = dM[1] = c_82*(cos_theta*sin_aj);
    const double c_3 = c[20];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double z_4 = cos_ab*sin_theta;
    const double c_4 = c[21];
    const double sin_ab = em_sin(ab);
    const double z_6 = cos_theta*sin_ab;
    dM[14] = dM[2] = ((-1.0/6.0))*(c_3*z_4 - c_4*z_6);
    const double c_85 = c[102];
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    dM[21] = dM[3] = c_85*(cos_theta*sin_ak);
    const double c_12 = c[29];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_9 = sin_theta*cos_ac;
    const double c_13 = c[30];
    const double sin_ac = em_sin(ac);
    const double z_11 = cos_theta*sin_ac;
    dM[28] = dM[4] = ((-1.0/6.0))*(c_12*z_9 - c_13*z_11);
    const double cos_aj = em_cos(aj);
    dM[56] = dM[50] = c_82*(sin_theta*cos_aj);
    const double c_2 = c[19];
    dM[57] = c_2*(sin_aj*cos_aj);
    const double c_84 = c[101];
    dM[64] = dM[58] = -c_84*(sin_ab*cos_aj);
    dM[112] = dM[100] = ((-1.0/6.0))*(c_3*z_6 - c_4*z_4);
    dM[113] = dM[107] = -c_84*(cos_ab*sin_aj);
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_13 = cos_ab*c_6 - sin_ab*c_7;
    const double z_14 = sin_ab*c_6 + cos_ab*c_7;
    const double c_8 = c[25];
    const double c_9 = c[26];
    dM[114] = (1.0/6.0)*(z_13*z_14*c_8 + c_9*(cos_ab*sin_ab));
    const double c_14 = c[31];
    const double z_15 = cos_ac*z_14;
    const double c_15 = c[32];
    const double z_16 = sin_ac*z_13;
    dM[128] = dM[116] = ((-1.0/12.0))*(c_14*z_15 - c_15*z_16);
    const double c_44 = c[61];
    const double af = x[5];
    const double sin_af = em_sin(af);
    dM[135] = dM[117] = c_44*(z_13*sin_af);
    const double c_21 = c[38];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_19 = z_14*cos_ag;
    const double c_22 = c[39];
    const double sin_ag = em_sin(ag);
    const double z_21 = z_13*sin_ag;
    dM[142] = dM[118] = ((-1.0/12.0))*(c_21*z_19 - c_22*z_21);
    const double cos_ak = em_cos(ak);
    dM[168] = dM[150] = c_85*(sin_theta*cos_ak);
    const double c_11 = c[28];
    dM[171] = c_11*(sin_ak*cos_ak);
    const double c_87 = c[104];
    dM[178] = dM[172] = -c_87*(sin_ac*cos_ak);
    dM[224] = dM[200] = ((-1.0/6.0))*(c_12*z_11 - c_13*z_9);
    dM[226] = dM[214] = ((-1.0/12.0))*(c_14*z_16 - c_15*z_15);
    dM[227] = dM[221] = -c_87*(cos_ac*sin_ak);
    const double c_17 = c[34];
    dM[228] = c_17*(cos_ac*sin_ac);
    const double c_90 = c[107];
    dM[235] = dM[229] = -c_90*(cos_ac*sin_af);
    const double c_23 = c[40];
    const double z_23 = sin_ac*cos_ag;
    const double c_25 = c[42];
    const double z_24 = cos_ac*sin_ag;
    const double c_40 = c[57];
    const double z_25 = c_40*(sin_ac*sin_ag) + c_40*(cos_ac*cos_ag);
    dM[242] = dM[230] = ((-1.0/12.0))*(c_23*z_23 - c_25*z_24 - z_25);
    const double cos_af = em_cos(af);
    dM[282] = dM[264] = c_44*(z_14*cos_af);
    dM[284] = dM[278] = -c_90*(sin_ac*cos_af);
    const double c_20 = c[37];
    dM[285] = c_20*(sin_af*cos_af);
    const double c_92 = c[109];
    dM[292] = dM[286] = -c_92*(sin_ag*cos_af);
    dM[338] = dM[314] = ((-1.0/12.0))*(c_21*z_21 - c_22*z_19);
    dM[340] = dM[328] = ((-1.0/12.0))*(c_23*z_24 + z_25 - c_25*z_23);
    dM[341] = dM[335] = -c_92*(cos_ag*sin_af);
    const double c_27 = c[44];
    dM[342] = c_27*(cos_ag*sin_ag);
}

/* bias (n): (M + A^T W A) xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ASIDE void motion_bias(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                          const double *restrict c, EM_UNUSED const double *restrict u, double *restrict bias,
                          double *restrict gamma)
{
    const double theta_dot = v[0];
    const double ab_dot = v[2];
    const double c_3 = c[20];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double z_2 = cos_ab*sin_theta;
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double z_5 = cos_theta*sin_ab;
    const double z_6 = theta_dot*ab_dot*(c_3*(z_2 - z_5));
    const double ac_dot = v[4];
    const double c_12 = c[29];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_8 = sin_theta*cos_ac;
    const double sin_ac = em_sin(ac);
    const double z_10 = cos_theta*sin_ac;
    const double z_11 = theta_dot*ac_dot*(c_12*(z_8 - z_10));
    const double c_28 = c[45];
    const double c_29 = c[46];
    const double z_12 = c_3*(ab_dot*z_5 + theta_dot*z_2) - c_3*(ab_dot*z_2 + theta_dot*z_5);
    const double z_13 = ac_dot*sin_ac;
    const double z_14 = ac_dot*cos_ac;
    const double z_15 = c_12*(theta_dot*z_8 + cos_theta*z_13) - c_12*(theta_dot*z_10 + sin_theta*z_14);
    const double m = c[12];
    const double z_16 = m*(theta_dot*theta_dot);
    const double z_17 = cos_theta*z_16;
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double j = c[9];
    const double aj_dot = v[1];
    const double z_19 = j*(aj_dot*aj_dot);
    const double b = c[1];
    const double z_20 = b*(ab_dot*ab_dot);
    const double z_21 = z_17 + cos_aj*z_19 - cos_ab*z_20;
    const double c_30 = c[47];
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double k = c[10];
    const double ak_dot = v[3];
    const double z_23 = k*(ak_dot*ak_dot);
    const double c_ = c[2];
    const double z_24 = ac_dot*ac_dot;
    const double z_25 = c_*z_24;
    const double z_26 = z_17 + cos_ak*z_23 - cos_ac*z_25;
    const double c_31 = c[48];
    bias[0] = ((-1.0/6.0))*((((z_6 + z_11) - 3.0*(c_29 - cos_theta*c_28)) - (ab_dot*z_12 + ac_dot*z_15)) +
        2.0*(sin_theta*z_21*c_30 + sin_theta*z_26*c_31));
    const double c_32 = c[49];
    const double sin_aj = em_sin(aj);
    bias[1] = -c_32*(sin_aj*z_21);
    const double c_14 = c[31];
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_28 = sin_ab*c_6 + cos_ab*c_7;
    const double z_29 = cos_ab*c_6 - sin_ab*c_7;
    const double z_30 = ab_dot*ac_dot*(c_14*(cos_ac*z_28 - sin_ac*z_29));
    const double ag_dot = v[6];
    const double c_21 = c[38];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    const double z_33 = ab_dot*ag_dot*(c_21*(z_28*cos_ag - z_29*sin_ag));
    const double c_33 = c[50];
    const double c_34 = c[51];
    const double z_34 = ab_dot*sin_ab;
    const double z_35 = ab_dot*cos_ab;
    const double z_36 = c_6*z_34 + c_7*z_35;
    const double z_37 = c_6*z_35 - c_7*z_34;
    const double z_38 = c_14*(z_29*z_13 + cos_ac*z_36) - c_14*(z_28*z_14 + sin_ac*z_37);
    const double z_39 = ag_dot*sin_ag;
    const double z_40 = ag_dot*cos_ag;
    const double z_41 = c_21*(cos_ag*z_36 + z_29*z_39) - c_21*(sin_ag*z_37 + z_28*z_40);
    const double c_8 = c[25];
    const double c_35 = c[52];
    const double z_42 = c_35*z_24;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double c_37 = c[54];
    const double af_dot = v[5];
    const double z_44 = c_37*(af_dot*af_dot);
    const double c_36 = c[53];
    const double z_45 = c_36*(ag_dot*ag_dot);
    const double z_46 = cos_ac*z_42 + cos_ag*z_45 - ab_dot*z_37 - cos_af*z_44;
    const double c_38 = c[55];
    bias[2] = (1.0/12.0)*((((2.0*z_6 - z_30 - z_33) - 3.0*(cos_ab*c_33 - sin_ab*c_34)) + (2.0*theta_dot*z_12 +
        ac_dot*z_38 + ag_dot*z_41)) + (z_28*c_8*z_46 + c_38*(sin_ab*z_21)));
    const double c_39 = c[56];
    const double sin_ak = em_sin(ak);
    bias[3] = -c_39*(sin_ak*z_26);
    const double c_23 = c[40];
    const double c_40 = c[57];
    const double z_48 = ac_dot*ag_dot*(cos_ag*(sin_ac*c_23) - sin_ag*(cos_ac*c_23) - c_40*(sin_ac*sin_ag) -
        c_40*(cos_ac*cos_ag));
    const double c_41 = c[58];
    const double c_24 = c[41];
    const double z_49 = c_23*(cos_ag*z_13 + cos_ac*z_39) - 2.0*c_24*(sin_ag*z_13 - cos_ac*z_40) -
        2.0*c_24*(cos_ag*z_14 - sin_ac*z_39) - c_23*(sin_ag*z_14 + sin_ac*z_40);
    const double c_42 = c[59];
    const double c_43 = c[60];
    bias[4] = (1.0/12.0)*((((2.0*z_11 + z_30 - z_48) - cos_ac*c_41) + (2.0*theta_dot*z_15 + ab_dot*z_38 +
        ag_dot*z_49)) + 2.0*(c_43*(sin_ac*z_26) - sin_ac*c_42*z_46));
    const double c_44 = c[61];
    const double sin_af = em_sin(af);
    bias[5] = c_44*(sin_af*z_46);
    const double c_45 = c[62];
    const double c_46 = c[63];
    const double c_47 = c[64];
    bias[6] = (1.0/12.0)*((((z_33 + z_48) - 3.0*(cos_ag*c_45 - sin_ag*c_46)) + (ab_dot*z_41 + ac_dot*z_49)) -
        c_47*(sin_ag*z_46));
    gamma[0] = -z_21;
    const double z_51 = sin_theta*z_16;
    gamma[1] = -(z_51 + sin_aj*z_19 - sin_ab*z_20);
    gamma[2] = -z_26;
    gamma[3] = -(z_51 + sin_ak*z_23 - sin_ac*z_25);
    gamma[4] = 0.5*z_46;
    gamma[5] = 0.5*(sin_ac*z_42 + sin_ag*z_45 - ab_dot*z_36 - sin_af*z_44);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ASIDE void energy(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                     const double *restrict c, double *restrict e)
{
    const double theta_dot = v[0];
    const double ab_dot = v[2];
    const double c_3 = c[20];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double sin_theta = em_sin(theta);
    const double z_4 = c_3*(cos_ab*cos_theta + sin_ab*sin_theta);
    const double ac_dot = v[4];
    const double c_12 = c[29];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double sin_ac = em_sin(ac);
    const double z_7 = c_12*(cos_theta*cos_ac + sin_theta*sin_ac);
    const double c_64 = c[81];
    const double c_65 = c[82];
    const double c_14 = c[31];
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_8 = cos_ab*c_6 - sin_ab*c_7;
    const double z_9 = cos_ab*c_7;
    const double z_10 = sin_ab*c_6 + z_9;
    const double z_11 = c_14*(cos_ac*z_8 + sin_ac*z_10);
    const double ag_dot = v[6];
    const double c_21 = c[38];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    const double z_14 = c_21*(z_8*cos_ag + z_10*sin_ag);
    const double c_23 = c[40];
    const double c_40 = c[57];
    const double z_15 = cos_ac*cos_ag*c_23 + sin_ac*sin_ag*c_23 + c_40*(sin_ac*cos_ag) - c_40*(cos_ac*sin_ag);
    const double c_66 = c[83];
    const double c_67 = c[84];
    e[0] = (1.0/24.0)*(2.0*theta_dot*(ab_dot*z_4 + ac_dot*z_7 + theta_dot*c_64) + ab_dot*(2.0*theta_dot*z_4 +
        ab_dot*c_65 + ac_dot*z_11 + ag_dot*z_14) + ac_dot*(2.0*theta_dot*z_7 + ab_dot*z_11 + ag_dot*z_15 +
        ac_dot*c_66) + ag_dot*(ab_dot*z_14 + ac_dot*z_15 + ag_dot*c_67));
    e[1] = 0.0;
    e[2] = 0.0;
    const double d = c[3];
    const double c_68 = c[85];
    const double z_16 = z_10 + c_68;
    const double e_ = c[4];
    const double c_69 = c[86];
    const double f = c[5];
    const double c_35 = c[52];
    const double z_17 = sin_ac*c_35;
    const double c_36 = c[53];
    const double h = c[7];
    const double c_70 = c[87];
    const double c_71 = c[88];
    const double c_72 = c[89];
    const double z_18 = cos_ag*c_71 + (c_68 + sin_ac*c_72);
    const double i = c[8];
    const double c_73 = c[90];
    const double c_74 = c[91];
    const double b = c[1];
    const double z_19 = b*sin_ab;
    const double c_75 = c[92];
    const double c_ = c[2];
    const double z_20 = c_*sin_ac;
    const double g = c[6];
    const double m = c[12];
    const double l = c[11];
    const double z_21 = m*sin_theta - l;
    const double c_76 = c[93];
    const double c_77 = c[94];
    const double c_78 = c[95];
    const double c_79 = c[96];
    e[3] = (-0.25)*(theta*c_79 - (d*z_16 + e_*(c_68 + sin_ab*c_69 + z_9) + f*(z_16 + z_17 + sin_ag*c_36) +
        h*(sin_ag*c_70 + z_18) + i*(sin_ag*c_73 + z_18) + c_74*(z_19 + c_75) + (z_20 + c_75)*c_35 + c_36*(g*sin_ag
        + c_75 + z_17) + (z_19 + z_21)*c_76 + (z_20 + z_21)*c_77)*c_78);
}

/* out (n_outputs), from x, v, a = xddot, lambda */
EM_ASIDE void observe(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                      EM_UNUSED const double *restrict v, EM_UNUSED const double *restrict a,
                      EM_UNUSED const double *restrict lambda, EM_UNUSED const double *restrict c,
                      EM_UNUSED const double *restrict u, EM_UNUSED double *restrict out)
{
}

/* p: what the drawing is made of, shape by shape */
EM_ASIDE void draw(EM_UNUSED double t, const double *restrict x, const double *restrict c, double *restrict p)
{
    p[0] = p[1] = p[6] = p[7] = 0.0;
    const double c_94 = c[111];
    p[2] = p[18] = p[22] = p[30] = c_94;
    const double c_95 = c[112];
    p[3] = p[19] = p[23] = p[31] = c_95;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_73 = c[90];
    const double c_96 = c[113];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_35 = c[52];
    const double sin_ag = em_sin(ag);
    const double c_71 = c[88];
    p[4] = p[44] = p[48] = p[53] = 0.5*(cos_ag*c_73 + c_96 + cos_ac*c_35 - sin_ag*c_71);
    const double c_75 = c[92];
    const double sin_ac = em_sin(ac);
    p[5] = p[45] = p[49] = p[54] = 0.5*(sin_ag*c_73 + c_75 + sin_ac*c_35 + cos_ag*c_71);
    const double m = c[12];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    p[8] = p[10] = p[14] = p[50] = m*cos_theta;
    const double sin_theta = em_sin(theta);
    p[9] = p[11] = p[15] = p[51] = m*sin_theta;
    const double b = c[1];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double a_ = c[0];
    p[12] = p[20] = p[26] = b*cos_ab - a_;
    const double sin_ab = em_sin(ab);
    const double l = c[11];
    p[13] = p[21] = p[27] = b*sin_ab - l;
    const double c_ = c[2];
    const double z_8 = c_*cos_ac - a_;
    p[16] = p[32] = p[38] = p[42] = z_8;
    const double z_9 = c_*sin_ac - l;
    p[17] = p[33] = p[39] = p[43] = z_9;
    const double c_6 = c[23];
    const double c_7 = c[24];
    p[24] = p[28] = p[34] = 0.5*(cos_ab*c_6 + c_96 - sin_ab*c_7);
    p[25] = p[29] = p[35] = 0.5*(sin_ab*c_6 + c_75 + cos_ab*c_7);
    const double g = c[6];
    p[36] = p[40] = p[46] = g*cos_ag + z_8;
    p[37] = p[41] = p[47] = g*sin_ag + z_9;
    const double c_97 = c[114];
    p[52] = p[55] = c_97;
}

#endif
#ifndef EM_ASIDE_ALONE

/* Where the other is linked it takes the place of this. */
extern em_lanes jansen_lanes;
EM_WEAK em_lanes jansen_lanes = {0, NULL, NULL, NULL};
#define EM_MODEL_LANES jansen_lanes

#include "em_blocks.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0, 0, 0 };
static const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 14, 63, 0, 49 };
static const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double m = parameters[12];
    const double z_0 = m*m;
    const double b = parameters[1];
    const double z_1 = b*b;
    const double density = parameters[13];
    const double z_2 = density*b;
    const double j = parameters[9];
    const double z_3 = density*j;
    const double e = parameters[4];
    const double z_4 = density*e;
    const double d = parameters[3];
    const double z_5 = d*d;
    const double z_6 = z_1 + z_5 - e*e;
    const double f = parameters[5];
    const double z_7 = density*f;
    const double z_8 = z_4 + density*d + z_7;
    const double z_9 = z_6/b;
    const double z_10 = 4.0*1.0 - z_6*z_6/(z_1*z_5);
    const double z_11 = 4.0*z_1*z_2 + 4.0*(z_3 + z_4)*z_1 + z_4*z_6 + (e*z_2 + z_8*z_9)*z_9 + z_8*z_10*z_5;
    const double z_12 = 1.0/z_11;
    const double J = parameters[14];
    const double k = parameters[10];
    const double z_13 = density*k;
    const double z_14 = 3.0*J + (z_3 + z_13)*z_0;
    const double z_15 = z_0/z_14;
    const double z_16 = 1.0/(6.281075576154938*z_1*z_12 + 1.0439356584272999*z_15);
    const double c_ = parameters[2];
    const double z_17 = c_*c_;
    const double z_18 = density*c_;
    const double g = parameters[6];
    const double z_19 = density*g;
    const double i = parameters[8];
    const double z_20 = density*i;
    const double h = parameters[7];
    const double z_21 = h*z_18;
    const double z_22 = density*h;
    const double z_23 = z_20 + z_22;
    const double z_24 = c_*z_23 + 0.5*i*z_18;
    const double z_25 = z_7 + z_19 + z_22;
    const double z_26 = c_*z_25 + 0.5*g*z_18;
    const double z_27 = 2.0*z_17*z_18 + 2.0*(z_13 + z_19 + z_20)*z_17 + c_*(2.0*z_21 + 2.0*z_24 + 2.0*z_26) +
        z_19*z_17 + z_20*z_17;
    const double z_28 = z_17/z_27;
    const double z_29 = 1.0/(1.0439356584272999*z_15 + 1.977912246691201*z_28);
    const double z_30 = z_0*z_16 + z_0*z_29;
    prepared[17] = (2.0/3.0)*z_30;
    const double z_31 = m*z_16;
    const double z_32 = j*z_31;
    prepared[18] = z_32;
    const double z_33 = z_16*(j*j);
    prepared[19] = (2.0/3.0)*z_33;
    const double z_34 = m*j*z_2;
    prepared[20] = z_34;
    prepared[21] = z_34 - 2.0*b*z_31;
    const double z_35 = j*z_16;
    const double z_36 = b*z_35;
    prepared[22] = z_36;
    prepared[23] = z_9;
    const double z_37 = d*sqrt(0.25*z_10);
    prepared[24] = 2.0*z_37;
    const double z_38 = 0.9799867889375745*z_9 + 0.39812507335168834*z_37;
    const double z_39 = 0.7809576093147158*z_9 - 1.2491680630778932*z_37;
    const double z_40 = g*g;
    const double z_41 = i*i;
    const double z_42 = z_40 + z_41 - h*h;
    const double z_43 = z_42/g;
    const double z_44 = 4.0*1.0 - z_42*z_42/(z_40*z_41);
    const double z_45 = g*(4.0*g*z_25 + z_22*z_43) + (z_19*h + z_23*z_43)*z_43 + z_23*z_44*z_41;
    const double z_46 = 1.0/(1.977912246691201*z_28 + z_12*(z_38*z_38) + z_12*(z_39*z_39) +
        0.7654631453230911*z_40/z_45);
    prepared[25] = z_46;
    prepared[26] = 4.0*(z_1*z_16);
    const double z_47 = m*z_29;
    const double z_48 = k*z_47;
    prepared[27] = z_48;
    const double z_49 = z_29*(k*k);
    prepared[28] = (2.0/3.0)*z_49;
    const double z_50 = m*k*z_18;
    prepared[29] = z_50;
    prepared[30] = z_50 - 2.0*c_*z_47;
    const double z_51 = f*z_18;
    prepared[31] = z_51;
    const double z_52 = c_*z_46;
    prepared[32] = z_51 - 2.0*z_52;
    const double z_53 = k*z_29;
    const double z_54 = c_*z_53;
    prepared[33] = z_54;
    const double z_55 = z_17*z_29 + z_17*z_46;
    prepared[34] = (2.0/3.0)*z_55;
    const double z_56 = f*z_46;
    prepared[35] = z_56;
    const double z_57 = f*z_52;
    prepared[36] = z_57;
    const double z_58 = z_46*(f*f);
    prepared[37] = (2.0/3.0)*z_58;
    const double z_59 = f*z_19;
    prepared[38] = z_59;
    const double z_60 = g*z_46;
    prepared[39] = z_59 - 2.0*z_60;
    const double z_61 = z_21 + 2.0*z_24;
    const double z_62 = 2.0*g*(z_21 + 2.0*z_26) + z_61*z_43;
    prepared[40] = z_62;
    const double z_63 = i*sqrt(0.25*z_44);
    const double z_64 = z_61*z_63;
    prepared[41] = z_64;
    prepared[42] = z_62 + 4.0*g*z_52;
    const double z_65 = g*z_56;
    prepared[43] = z_65;
    const double z_66 = z_40*z_46;
    prepared[44] = (2.0/3.0)*z_66;
    const double gravity = parameters[16];
    const double z_67 = density*gravity;
    const double z_68 = k*z_67;
    const double z_69 = j*z_67;
    prepared[45] = m*(z_68 + z_69);
    const double torque = parameters[15];
    prepared[46] = 2.0*torque;
    prepared[47] = z_31;
    prepared[48] = z_47;
    prepared[49] = (1.0/3.0)*z_35;
    const double z_70 = 2.0*b + z_9;
    const double z_71 = e*z_67;
    const double z_72 = f*z_67;
    const double z_73 = z_72 + d*z_67;
    prepared[50] = z_70*z_71 + 2.0*b*(z_69 + b*z_67) + z_9*z_73;
    prepared[51] = 2.0*(z_37*(z_71 + z_73));
    prepared[52] = 2.0*c_;
    prepared[53] = 2.0*g;
    prepared[54] = 2.0*f;
    prepared[55] = 4.0*(b*z_16);
    prepared[56] = (1.0/3.0)*z_53;
    prepared[57] = 2.0*z_64;
    const double z_74 = g*z_67;
    const double z_75 = i*z_67;
    const double z_76 = h*z_67;
    const double z_77 = z_75 + z_76;
    prepared[58] = 6.0*(c_*(z_68 + 2.0*z_74 + c_*z_67 + 2.0*z_77 + z_72));
    prepared[59] = z_52;
    prepared[60] = 2.0*(c_*z_29);
    prepared[61] = (1.0/6.0)*z_56;
    const double z_78 = 2.0*g + z_43;
    prepared[62] = z_43*z_75 + z_78*z_76 + 2.0*g*(z_74 + z_72);
    prepared[63] = 2.0*(z_63*z_77);
    prepared[64] = 2.0*z_60;
    prepared[65] = (1.0/3.0)*z_14;
    prepared[66] = (1.0/12.0)*z_11;
    prepared[67] = (1.0/6.0)*z_27;
    prepared[68] = (1.0/12.0)*z_45;
    prepared[69] = fabs(j);
    prepared[70] = fabs(b);
    prepared[71] = fabs(m);
    const double a_ = parameters[0];
    prepared[72] = fabs(a_);
    const double l = parameters[11];
    prepared[73] = fabs(l);
    prepared[74] = fabs(k);
    const double z_79 = fabs(c_);
    prepared[75] = z_79;
    prepared[76] = fabs(z_9);
    prepared[77] = 2.0*z_79;
    prepared[78] = 2.0*fabs(z_37);
    prepared[79] = 2.0*fabs(f);
    prepared[80] = 2.0*fabs(g);
    prepared[81] = 2.0*z_14;
    prepared[82] = z_11;
    prepared[83] = 2.0*z_27;
    prepared[84] = z_45;
    prepared[85] = (-4.0)*l;
    prepared[86] = z_70;
    prepared[87] = z_78;
    prepared[88] = 2.0*z_63;
    prepared[89] = 4.0*c_;
    prepared[90] = z_43;
    prepared[91] = 2.0*b;
    prepared[92] = (-2.0)*l;
    prepared[93] = 2.0*j;
    prepared[94] = 2.0*k;
    prepared[95] = z_67;
    prepared[96] = 4.0*torque;
    prepared[97] = z_14;
    prepared[98] = z_30;
    prepared[99] = (1.0/3.0)*z_32;
    prepared[100] = (1.0/3.0)*z_33;
    prepared[101] = (1.0/3.0)*z_36;
    prepared[102] = (1.0/3.0)*z_48;
    prepared[103] = (1.0/3.0)*z_49;
    prepared[104] = (1.0/3.0)*z_54;
    prepared[105] = z_27;
    prepared[106] = 2.0*z_55;
    prepared[107] = (1.0/3.0)*z_57;
    prepared[108] = (1.0/3.0)*z_58;
    prepared[109] = (1.0/3.0)*z_65;
    prepared[110] = 4.0*z_66;
    prepared[111] = -a_;
    prepared[112] = -l;
    prepared[113] = (-2.0)*a_;
    prepared[114] = (1.0/10.0)*m;
}

/* What depends on parameters only, once per parameter set: c (N_PREPARED). */
static int prepare(const double *parameters, double *c, em_fault *fault)
{
    (void)fault;
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    prepared_constants(parameters, c);
    return 0;
}

/* M (n, n)                                                                                                      (5) */
static void mass_matrix(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                        double *restrict M)
{
    const double c_48 = c[65];
    M[0] = c_48;
    M[7] = M[1] = 0.0;
    M[8] = 0.0;
    const double c_3 = c[20];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double sin_theta = em_sin(theta);
    M[14] = M[2] = (1.0/6.0)*(c_3*(cos_ab*cos_theta + sin_ab*sin_theta));
    M[15] = M[9] = 0.0;
    const double c_49 = c[66];
    M[16] = c_49;
    M[21] = M[3] = 0.0;
    M[22] = M[10] = 0.0;
    M[23] = M[17] = 0.0;
    M[24] = 0.0;
    const double c_12 = c[29];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double sin_ac = em_sin(ac);
    M[28] = M[4] = (1.0/6.0)*(c_12*(cos_theta*cos_ac + sin_theta*sin_ac));
    M[29] = M[11] = 0.0;
    const double c_14 = c[31];
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_6 = cos_ab*c_6 - sin_ab*c_7;
    const double z_7 = sin_ab*c_6 + cos_ab*c_7;
    M[30] = M[18] = (1.0/12.0)*(c_14*(cos_ac*z_6 + sin_ac*z_7));
    M[31] = M[25] = 0.0;
    const double c_50 = c[67];
    M[32] = c_50;
    M[35] = M[5] = 0.0;
    M[36] = M[12] = 0.0;
    M[37] = M[19] = 0.0;
    M[38] = M[26] = 0.0;
    M[39] = M[33] = 0.0;
    M[40] = 0.0;
    M[42] = M[6] = 0.0;
    M[43] = M[13] = 0.0;
    const double c_21 = c[38];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    M[44] = M[20] = (1.0/12.0)*(c_21*(z_6*cos_ag + z_7*sin_ag));
    M[45] = M[27] = 0.0;
    const double c_23 = c[40];
    const double c_40 = c[57];
    M[46] = M[34] = (1.0/12.0)*(cos_ac*cos_ag*c_23 + sin_ac*sin_ag*c_23 + c_40*(sin_ac*cos_ag) -
        c_40*(cos_ac*sin_ag));
    M[47] = M[41] = 0.0;
    const double c_51 = c[68];
    M[48] = c_51;
}

/* M + A^T W A (n, n), which is factored in place of M: M is singular, but not along the constraints */
static void factored_matrix(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                            double *restrict M)
{
    const double c_80 = c[97];
    const double c_81 = c[98];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    M[0] = (1.0/3.0)*(c_80 + c_81*(sin_theta*sin_theta));
    const double c_82 = c[99];
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    M[7] = M[1] = c_82*(sin_theta*sin_aj);
    const double c_83 = c[100];
    M[8] = c_83*(sin_aj*sin_aj);
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double cos_theta = em_cos(theta);
    const double c_3 = c[20];
    const double sin_ab = em_sin(ab);
    const double c_4 = c[21];
    M[14] = M[2] = (1.0/6.0)*(cos_ab*cos_theta*c_3 + sin_ab*sin_theta*c_4);
    const double c_84 = c[101];
    M[15] = M[9] = -c_84*(sin_ab*sin_aj);
    const double c_65 = c[82];
    const double c_8 = c[25];
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_5 = sin_ab*c_6 + cos_ab*c_7;
    const double c_9 = c[26];
    M[16] = (1.0/12.0)*(c_65 + c_8*(z_5*z_5) + c_9*(sin_ab*sin_ab));
    const double c_85 = c[102];
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    M[21] = M[3] = c_85*(sin_theta*sin_ak);
    M[22] = M[10] = 0.0;
    M[23] = M[17] = 0.0;
    const double c_86 = c[103];
    M[24] = c_86*(sin_ak*sin_ak);
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_12 = c[29];
    const double sin_ac = em_sin(ac);
    const double c_13 = c[30];
    M[28] = M[4] = (1.0/6.0)*(cos_theta*cos_ac*c_12 + sin_theta*sin_ac*c_13);
    M[29] = M[11] = 0.0;
    const double z_9 = cos_ab*c_6 - sin_ab*c_7;
    const double c_14 = c[31];
    const double c_15 = c[32];
    M[30] = M[18] = (1.0/12.0)*(cos_ac*z_9*c_14 + sin_ac*z_5*c_15);
    const double c_87 = c[104];
    M[31] = M[25] = -c_87*(sin_ac*sin_ak);
    const double c_88 = c[105];
    const double c_89 = c[106];
    M[32] = (1.0/6.0)*(c_88 + c_89*(sin_ac*sin_ac));
    M[35] = M[5] = 0.0;
    M[36] = M[12] = 0.0;
    const double c_44 = c[61];
    const double af = x[5];
    const double sin_af = em_sin(af);
    M[37] = M[19] = c_44*(z_5*sin_af);
    M[38] = M[26] = 0.0;
    const double c_90 = c[107];
    M[39] = M[33] = -c_90*(sin_ac*sin_af);
    const double c_91 = c[108];
    M[40] = c_91*(sin_af*sin_af);
    M[42] = M[6] = 0.0;
    M[43] = M[13] = 0.0;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_21 = c[38];
    const double sin_ag = em_sin(ag);
    const double c_22 = c[39];
    M[44] = M[20] = (1.0/12.0)*(z_9*cos_ag*c_21 + z_5*sin_ag*c_22);
    M[45] = M[27] = 0.0;
    const double c_23 = c[40];
    const double c_25 = c[42];
    const double c_40 = c[57];
    M[46] = M[34] = (1.0/12.0)*(cos_ac*cos_ag*c_23 + sin_ac*sin_ag*c_25 + c_40*(sin_ac*cos_ag) -
        c_40*(cos_ac*sin_ag));
    const double c_92 = c[109];
    M[47] = M[41] = -c_92*(sin_ag*sin_af);
    const double c_67 = c[84];
    const double c_93 = c[110];
    M[48] = (1.0/12.0)*(c_67 + c_93*(sin_ag*sin_ag));
}

/* What is factored, of which motion_bias is */
static void (*const factored)(double t, const double *restrict x, const double *restrict c, double *restrict M) =
    factored_matrix;

/* A (m, n), b (m): A xdot + b = 0                                                                               (8) */
static void pfaffian(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                     double *restrict A, double *restrict b)
{
    const double m = c[12];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    A[0] = -m*sin_theta;
    const double j = c[9];
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    A[1] = -j*sin_aj;
    const double b_ = c[1];
    const double ab = x[2];
    const double sin_ab = em_sin(ab);
    A[2] = b_*sin_ab;
    A[3] = 0.0;
    A[4] = 0.0;
    A[5] = 0.0;
    A[6] = 0.0;
    const double cos_theta = em_cos(theta);
    A[7] = m*cos_theta;
    const double cos_aj = em_cos(aj);
    A[8] = j*cos_aj;
    const double cos_ab = em_cos(ab);
    A[9] = -b_*cos_ab;
    A[10] = 0.0;
    A[11] = 0.0;
    A[12] = 0.0;
    A[13] = 0.0;
    A[14] = -m*sin_theta;
    A[15] = 0.0;
    A[16] = 0.0;
    const double k = c[10];
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    A[17] = -k*sin_ak;
    const double c_ = c[2];
    const double ac = x[4];
    const double sin_ac = em_sin(ac);
    A[18] = c_*sin_ac;
    A[19] = 0.0;
    A[20] = 0.0;
    A[21] = m*cos_theta;
    A[22] = 0.0;
    A[23] = 0.0;
    const double cos_ak = em_cos(ak);
    A[24] = k*cos_ak;
    const double cos_ac = em_cos(ac);
    A[25] = -c_*cos_ac;
    A[26] = 0.0;
    A[27] = 0.0;
    A[28] = 0.0;
    A[29] = 0.0;
    const double c_6 = c[23];
    const double c_7 = c[24];
    A[30] = (-0.5)*(sin_ab*c_6 + cos_ab*c_7);
    A[31] = 0.0;
    A[32] = c_*sin_ac;
    const double f = c[5];
    const double af = x[5];
    const double sin_af = em_sin(af);
    A[33] = -f*sin_af;
    const double g = c[6];
    const double ag = x[6];
    const double sin_ag = em_sin(ag);
    A[34] = g*sin_ag;
    A[35] = 0.0;
    A[36] = 0.0;
    A[37] = 0.5*(cos_ab*c_6 - sin_ab*c_7);
    A[38] = 0.0;
    A[39] = -c_*cos_ac;
    const double cos_af = em_cos(af);
    A[40] = f*cos_af;
    const double cos_ag = em_cos(ag);
    A[41] = -g*cos_ag;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    b[4] = 0.0;
    b[5] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
static void position(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                     double *restrict phi, double *restrict terms)
{
    const double j = c[9];
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double b = c[1];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double m = c[12];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double a_ = c[0];
    const double z_3 = m*cos_theta + a_;
    phi[0] = j*cos_aj + z_3 - b*cos_ab;
    const double sin_aj = em_sin(aj);
    const double sin_ab = em_sin(ab);
    const double sin_theta = em_sin(theta);
    const double l = c[11];
    const double z_7 = m*sin_theta + l;
    phi[1] = j*sin_aj + z_7 - b*sin_ab;
    const double k = c[10];
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double c_ = c[2];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    phi[2] = k*cos_ak + z_3 - c_*cos_ac;
    const double sin_ak = em_sin(ak);
    const double sin_ac = em_sin(ac);
    phi[3] = k*sin_ak + z_7 - c_*sin_ac;
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double c_35 = c[52];
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double c_37 = c[54];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_36 = c[53];
    phi[4] = 0.5*(cos_ab*c_6 + cos_af*c_37 - sin_ab*c_7 - cos_ac*c_35 - cos_ag*c_36);
    const double sin_af = em_sin(af);
    const double sin_ag = em_sin(ag);
    phi[5] = 0.5*(sin_ab*c_6 + cos_ab*c_7 + sin_af*c_37 - sin_ac*c_35 - sin_ag*c_36);
    const double c_52 = c[69];
    const double c_53 = c[70];
    const double z_16 = fabs(cos_ab) + fabs(ab*sin_ab);
    const double c_54 = c[71];
    const double c_55 = c[72];
    const double z_17 = c_54*(fabs(cos_theta) + fabs(theta*sin_theta)) + c_55;
    terms[0] = c_52*(fabs(cos_aj) + fabs(aj*sin_aj)) + c_53*z_16 + z_17;
    const double z_18 = fabs(sin_ab) + fabs(ab*cos_ab);
    const double c_56 = c[73];
    const double z_19 = c_54*(fabs(sin_theta) + fabs(theta*cos_theta)) + c_56;
    terms[1] = c_52*(fabs(sin_aj) + fabs(aj*cos_aj)) + c_53*z_18 + z_19;
    const double c_57 = c[74];
    const double c_58 = c[75];
    const double z_20 = fabs(cos_ac) + fabs(ac*sin_ac);
    terms[2] = c_57*(fabs(cos_ak) + fabs(ak*sin_ak)) + c_58*z_20 + z_17;
    const double z_21 = fabs(sin_ac) + fabs(ac*cos_ac);
    terms[3] = c_57*(fabs(sin_ak) + fabs(ak*cos_ak)) + c_58*z_21 + z_19;
    const double c_59 = c[76];
    const double c_60 = c[77];
    const double c_61 = c[78];
    const double c_62 = c[79];
    const double c_63 = c[80];
    terms[4] = 0.5*(z_16*c_59 + z_20*c_60 + z_18*c_61 + (fabs(cos_af) + fabs(af*sin_af))*c_62 + (fabs(cos_ag) +
        fabs(ag*sin_ag))*c_63);
    terms[5] = 0.5*(z_18*c_59 + z_21*c_60 + z_16*c_61 + (fabs(sin_af) + fabs(af*cos_af))*c_62 + (fabs(sin_ag) +
        fabs(ag*cos_ag))*c_63);
}

/* crossing (n_events): an event happens where its number passes through zero */
static void model_events(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                         EM_UNUSED const double *restrict v, EM_UNUSED const double *restrict c,
                         EM_UNUSED const double *restrict u, EM_UNUSED double *restrict crossing)
{
}

#include "em_mechanics.h"

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const double *restrict x, const double *restrict c, double M1[N1][N1],
                              double A1[N_ROWS][N1], double b[N_ROWS], double shared[16])
{
    const double c_80 = c[97];
    const double c_81 = c[98];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    M1[0][0] = (1.0/3.0)*(c_80 + c_81*(sin_theta*sin_theta));
    const double c_82 = c[99];
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    M1[0][1] = M1[1][0] = c_82*(sin_theta*sin_aj);
    const double c_83 = c[100];
    M1[1][1] = c_83*(sin_aj*sin_aj);
    const double cos_theta = em_cos(theta);
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double c_3 = c[20];
    const double sin_ab = em_sin(ab);
    const double c_4 = c[21];
    M1[0][2] = M1[2][0] = (1.0/6.0)*(cos_theta*(cos_ab*c_3) + sin_theta*(sin_ab*c_4));
    const double c_84 = c[101];
    M1[1][2] = M1[2][1] = -c_84*(sin_ab*sin_aj);
    const double c_65 = c[82];
    const double c_8 = c[25];
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_5 = sin_ab*c_6 + cos_ab*c_7;
    const double c_9 = c[26];
    M1[2][2] = (1.0/12.0)*(c_65 + c_8*(z_5*z_5) + c_9*(sin_ab*sin_ab));
    const double c_85 = c[102];
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    M1[0][3] = M1[3][0] = c_85*(sin_theta*sin_ak);
    M1[1][3] = M1[3][1] = 0.0;
    M1[2][3] = M1[3][2] = 0.0;
    const double c_86 = c[103];
    M1[3][3] = c_86*(sin_ak*sin_ak);
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_12 = c[29];
    const double sin_ac = em_sin(ac);
    const double c_13 = c[30];
    M1[0][4] = M1[4][0] = (1.0/6.0)*(cos_ac*(cos_theta*c_12) + sin_ac*(sin_theta*c_13));
    M1[1][4] = M1[4][1] = 0.0;
    const double z_9 = cos_ab*c_6 - sin_ab*c_7;
    const double c_14 = c[31];
    const double c_15 = c[32];
    M1[2][4] = M1[4][2] = (1.0/12.0)*(z_9*(cos_ac*c_14) + z_5*(sin_ac*c_15));
    const double c_87 = c[104];
    M1[3][4] = M1[4][3] = -c_87*(sin_ac*sin_ak);
    const double c_88 = c[105];
    const double c_89 = c[106];
    M1[4][4] = (1.0/6.0)*(c_88 + c_89*(sin_ac*sin_ac));
    M1[0][5] = M1[5][0] = 0.0;
    M1[1][5] = M1[5][1] = 0.0;
    const double c_44 = c[61];
    const double af = x[5];
    const double sin_af = em_sin(af);
    M1[2][5] = M1[5][2] = c_44*(z_5*sin_af);
    M1[3][5] = M1[5][3] = 0.0;
    const double c_90 = c[107];
    M1[4][5] = M1[5][4] = -c_90*(sin_ac*sin_af);
    const double c_91 = c[108];
    M1[5][5] = c_91*(sin_af*sin_af);
    M1[0][6] = M1[6][0] = 0.0;
    M1[1][6] = M1[6][1] = 0.0;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_21 = c[38];
    const double sin_ag = em_sin(ag);
    const double c_22 = c[39];
    M1[2][6] = M1[6][2] = (1.0/12.0)*(cos_ag*(z_9*c_21) + sin_ag*(z_5*c_22));
    M1[3][6] = M1[6][3] = 0.0;
    const double c_23 = c[40];
    const double c_25 = c[42];
    const double c_40 = c[57];
    M1[4][6] = M1[6][4] = (1.0/12.0)*(cos_ag*(cos_ac*c_23) + sin_ag*(sin_ac*c_25) + c_40*(sin_ac*cos_ag) -
        c_40*(cos_ac*sin_ag));
    const double c_92 = c[109];
    M1[5][6] = M1[6][5] = -c_92*(sin_ag*sin_af);
    const double c_67 = c[84];
    const double c_93 = c[110];
    M1[6][6] = (1.0/12.0)*(c_67 + c_93*(sin_ag*sin_ag));
    const double m = c[12];
    A1[0][0] = -m*sin_theta;
    const double j = c[9];
    A1[0][1] = -j*sin_aj;
    const double b_ = c[1];
    A1[0][2] = b_*sin_ab;
    A1[0][3] = 0.0;
    A1[0][4] = 0.0;
    A1[0][5] = 0.0;
    A1[0][6] = 0.0;
    A1[1][0] = m*cos_theta;
    const double cos_aj = em_cos(aj);
    A1[1][1] = j*cos_aj;
    A1[1][2] = -b_*cos_ab;
    A1[1][3] = 0.0;
    A1[1][4] = 0.0;
    A1[1][5] = 0.0;
    A1[1][6] = 0.0;
    A1[2][0] = -m*sin_theta;
    A1[2][1] = 0.0;
    A1[2][2] = 0.0;
    const double k = c[10];
    A1[2][3] = -k*sin_ak;
    const double c_ = c[2];
    A1[2][4] = c_*sin_ac;
    A1[2][5] = 0.0;
    A1[2][6] = 0.0;
    A1[3][0] = m*cos_theta;
    A1[3][1] = 0.0;
    A1[3][2] = 0.0;
    const double cos_ak = em_cos(ak);
    A1[3][3] = k*cos_ak;
    A1[3][4] = -c_*cos_ac;
    A1[3][5] = 0.0;
    A1[3][6] = 0.0;
    A1[4][0] = 0.0;
    A1[4][1] = 0.0;
    A1[4][2] = (-0.5)*z_5;
    A1[4][3] = 0.0;
    A1[4][4] = c_*sin_ac;
    const double f = c[5];
    A1[4][5] = -f*sin_af;
    const double g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = 0.0;
    A1[5][1] = 0.0;
    A1[5][2] = 0.5*z_9;
    A1[5][3] = 0.0;
    A1[5][4] = -c_*cos_ac;
    const double cos_af = em_cos(af);
    A1[5][5] = f*cos_af;
    A1[5][6] = -g*cos_ag;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    b[4] = 0.0;
    b[5] = 0.0;
    shared[0] = sin_theta;
    shared[1] = cos_theta;
    shared[2] = sin_aj;
    shared[3] = cos_aj;
    shared[4] = sin_ab;
    shared[5] = cos_ab;
    shared[6] = z_5;
    shared[7] = sin_ak;
    shared[8] = cos_ak;
    shared[9] = cos_ac;
    shared[10] = sin_ac;
    shared[11] = z_9;
    shared[12] = sin_af;
    shared[13] = cos_af;
    shared[14] = cos_ag;
    shared[15] = sin_ag;
}

/* Mdot */
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[16],
                             double Mdot1[N1][N1])
{
    const double c_0 = c[17];
    const double sin_theta = shared[0];
    const double theta_dot = v[0];
    const double cos_theta = shared[1];
    const double z_16 = theta_dot*cos_theta;
    Mdot1[0][0] = c_0*(sin_theta*z_16);
    const double c_1 = c[18];
    const double sin_aj = shared[2];
    const double aj_dot = v[1];
    const double cos_aj = shared[3];
    const double z_17 = aj_dot*cos_aj;
    Mdot1[0][1] = Mdot1[1][0] = (1.0/3.0)*(c_1*(sin_aj*z_16 + sin_theta*z_17));
    const double c_2 = c[19];
    Mdot1[1][1] = c_2*(sin_aj*z_17);
    const double c_3 = c[20];
    const double ab_dot = v[2];
    const double sin_ab = shared[4];
    const double z_18 = ab_dot*sin_ab;
    const double cos_ab = shared[5];
    const double z_19 = theta_dot*sin_theta;
    const double c_4 = c[21];
    const double z_20 = ab_dot*cos_ab;
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/6.0))*(c_3*(cos_theta*z_18 + cos_ab*z_19) - c_4*(sin_theta*z_20 +
        sin_ab*z_16));
    const double c_5 = c[22];
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/3.0))*(c_5*(sin_aj*z_20 + sin_ab*z_17));
    const double z_5 = shared[6];
    const double c_8 = c[25];
    const double c_6 = c[23];
    const double c_7 = c[24];
    const double z_21 = c_6*z_20 - c_7*z_18;
    const double c_9 = c[26];
    Mdot1[2][2] = (1.0/6.0)*(z_5*c_8*z_21 + c_9*(sin_ab*z_20));
    const double c_10 = c[27];
    const double sin_ak = shared[7];
    const double ak_dot = v[3];
    const double cos_ak = shared[8];
    const double z_22 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = (1.0/3.0)*(c_10*(sin_ak*z_16 + sin_theta*z_22));
    Mdot1[1][3] = Mdot1[3][1] = 0.0;
    Mdot1[2][3] = Mdot1[3][2] = 0.0;
    const double c_11 = c[28];
    Mdot1[3][3] = c_11*(sin_ak*z_22);
    const double c_12 = c[29];
    const double cos_ac = shared[9];
    const double ac_dot = v[4];
    const double sin_ac = shared[10];
    const double z_23 = ac_dot*sin_ac;
    const double c_13 = c[30];
    const double z_24 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_12*(cos_ac*z_19 + cos_theta*z_23) - c_13*(sin_ac*z_16 +
        sin_theta*z_24));
    Mdot1[1][4] = Mdot1[4][1] = 0.0;
    const double c_14 = c[31];
    const double z_9 = shared[11];
    const double z_25 = c_6*z_18 + c_7*z_20;
    const double c_15 = c[32];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_14*(z_9*z_23 + cos_ac*z_25) - c_15*(z_5*z_24 + sin_ac*z_21));
    const double c_16 = c[33];
    Mdot1[3][4] = Mdot1[4][3] = ((-1.0/3.0))*(c_16*(sin_ak*z_24 + sin_ac*z_22));
    const double c_17 = c[34];
    Mdot1[4][4] = c_17*(sin_ac*z_24);
    Mdot1[0][5] = Mdot1[5][0] = 0.0;
    Mdot1[1][5] = Mdot1[5][1] = 0.0;
    const double c_18 = c[35];
    const double sin_af = shared[12];
    const double af_dot = v[5];
    const double cos_af = shared[13];
    const double z_26 = af_dot*cos_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_18*(sin_af*z_21 + z_5*z_26));
    Mdot1[3][5] = Mdot1[5][3] = 0.0;
    const double c_19 = c[36];
    Mdot1[4][5] = Mdot1[5][4] = ((-1.0/3.0))*(c_19*(sin_af*z_24 + sin_ac*z_26));
    const double c_20 = c[37];
    Mdot1[5][5] = c_20*(sin_af*z_26);
    Mdot1[0][6] = Mdot1[6][0] = 0.0;
    Mdot1[1][6] = Mdot1[6][1] = 0.0;
    const double c_21 = c[38];
    const double cos_ag = shared[14];
    const double ag_dot = v[6];
    const double sin_ag = shared[15];
    const double z_27 = ag_dot*sin_ag;
    const double c_22 = c[39];
    const double z_28 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_21*(cos_ag*z_25 + z_9*z_27) - c_22*(sin_ag*z_21 + z_5*z_28));
    Mdot1[3][6] = Mdot1[6][3] = 0.0;
    const double c_23 = c[40];
    const double c_24 = c[41];
    const double c_25 = c[42];
    Mdot1[4][6] = Mdot1[6][4] = ((-1.0/12.0))*(c_23*(cos_ag*z_23 + cos_ac*z_27) - 2.0*c_24*(sin_ag*z_23 -
        cos_ac*z_28) - 2.0*c_24*(cos_ag*z_24 - sin_ac*z_27) - c_25*(sin_ag*z_24 + sin_ac*z_28));
    const double c_26 = c[43];
    Mdot1[5][6] = Mdot1[6][5] = ((-1.0/3.0))*(c_26*(sin_af*z_28 + sin_ag*z_26));
    const double c_27 = c[44];
    Mdot1[6][6] = c_27*(sin_ag*z_28);
}

/* After an accepted step, and at the start: constraints on positions, C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
static int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                        em_fault *fault)
{
    (void)mode, (void)flags, (void)t, (void)y, (void)c, (void)memory, (void)pace, (void)fault;
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[16];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = INFINITY, delta_gap = INFINITY;
    gap = fmin(gap, em_gap(N1, y + 63));
    int wanted = em_mode_by_gaps(*mode, flags, gap, delta_gap);
    if (wanted == EM_LOOK) {
        double v[N];
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, v);
        double Mdot1[N1][N1];
        settled_rates(v, c, shared, Mdot1);
        double time = INFINITY;
        time = fmin(time, em_time_of_block(&block1, Mdot1[0], y));
        wanted = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != wanted) {
        if (em_change_mode(&block1, wanted, M1[0], y, memory, fault)) return -1;
        *mode = wanted;
        changed = 1;
    }

    if (flags & EM_STABILISE) { /* eta <- eta - B^T Delta^-1 (B eta + b) */
        double B1[N_ROWS][N1], a1[N1];
        em_rows_of_block(&block1, *mode, N_ROWS, y, c, memory, A1[0], B1[0]);
        em_take(&block1, y + N, a1);
        /* Delta = B B^T (43), Delta lambda = B a (46): one loop, which is ready soonest */
        real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
        for (int row = 0; row < N_ROWS; ++row) {
            lambda[row] = b[row];
            em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
            for (int column = 0; column <= row; ++column) {
                Delta[row*N_ROWS + column] = em_real(0.0);
                em_add_product(N1, B1[row], B1[column], &Delta[row*N_ROWS + column]);
            }
        }
        if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;
        em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
        em_put(&block1, a1, y + N);
    }
    return changed;
}

/* v (n): xdot from a state, in the meaning of its mode. */
static int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    (void)mode, (void)t, (void)c, (void)fault;
    double M[N*N];
    factored(t, y, c, M);
    if (em_velocity_at(&block1, mode, M, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that an error e (n) of eta makes. */
static void model_velocity_error(int mode, const double *y, const double *c, const double *memory,
                                 const double *e, double *ev)
{
    (void)mode, (void)y, (void)c, (void)memory;
    em_velocity_kept(&block1, mode, e, y, c, memory, ev);
}

/* row (n_state): a state in the published meaning. */
static int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                         em_fault *fault)
{
    (void)mode, (void)t, (void)c, (void)memory, (void)fault;
    memcpy(row, y, N_STATE * sizeof *row);
    if (mode == 0) return 0;
    double v[N];
    if (model_velocity(mode, t, y, c, v, fault)) return -1;
    em_publish_block(&block1, v, y, row);
    return 0;
}

/* y (n_state) from x, v (n); eigenfactors continuous with those y holds, if any */
static int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    (void)t, (void)c, (void)fault;
    double C[N*N] = {0.0}, s[N], eta[N];
    em_spread(N, N1, coordinate1, y + 14, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 14);
    for (int i = 0; i < N1; ++i) y[63 + i] = s[coordinate1[i]];
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

static int published_rate(const void *with, double t, const double *y, double *dy, em_fault *fault)
{
    const em_forces *forces = with;
    return rhs(t, y, forces->c, forces->u, dy, fault);
}

/* J (n_state, n_state) = d rhs / d y */
static int jacobian(double t, const double *y, const double *c, const double *u, double *J, em_fault *fault)
{
    const em_forces forces = {c, u, 0};
    return em_differentiate(published_rate, &forces, N_STATE, t, y, J, fault);
}

#include "em_stepper.h"

static const char *const coordinate_names[] = { "theta", "aj", "ab", "ak", "ac", "af", "ag", NULL };
static const char *const parameter_names[] = { "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "density", "J", "torque", "gravity", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 3.8, 4.15, 3.93, 4.01, 5.58, 3.94, 3.67, 6.57, 4.9, 5.0, 6.19, 0.78, 1.5, 0.1, 2.0, 12.0, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.5, 2.602262465075601, 1.3703951072340697, 4.107268260719168, -1.1528510374935117, -1.0331924236898824, 2.7911904550173006 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 1, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 2},
    {"ground", 2, 2},
    {"trace", 4, 2},
    {"line", 6, 4},
    {"line", 10, 4},
    {"line", 14, 4},
    {"line", 18, 4},
    {"line", 22, 4},
    {"line", 26, 4},
    {"line", 30, 4},
    {"line", 34, 4},
    {"line", 38, 4},
    {"line", 42, 4},
    {"line", 46, 4},
    {"disk", 50, 3},
    {"disk", 53, 3}
};
static const em_slice layout[] = {
    {"x", 0, 7},
    {"eta", 7, 7},
    {"C", 14, 49},
    {"s", 63, 7}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "M^-1: M is singular; M + A^T W A is factored, with weights W of rows 0, 2, 4",
    NULL
};

const em_model jansen_model = {
    .abi = EM_ABI,
    .name = "jansen",
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
    .energy = energy,
    .eigenfactors = em_eigenfactors_of,
    .output = em_observe,
    .jacobian = jacobian,
    .motion_jacobian = em_motion_jacobian,
    .simulate = em_simulate,
    .interpolate = em_interpolate,
    .release = em_release,
    .event = model_events,
    .factored_matrix = factored_matrix,
    .factored_gradient = factored_gradient,
    .lanes = &jansen_lanes,
    .n_shapes = 16,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
};

#endif
#endif
