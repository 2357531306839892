/* eigenmotion generate jansen.py */
/* input sha256:ed5b383ebca52d6aef31c433b70cfaa858804fff4d43e6ad6bba3b16ee634350 */
/* body sha256:9c6add0216bf4c5dc1fff68412ac6d7c66cac2da4f3db010a07390bac3e8fd50 */
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
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* The shape: all that the stepper knows of this model. */
enum {
    N = 7,                /* coordinates */
    N_ROWS = 6,           /* constraint rows */
    N_POSITIONS = 6,      /* of which holonomic */
    N_STATE = 70,         /* numbers of a state */
    N_C = 49,             /* of which C, */
    N_S = 7,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 56,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
    SETTLES = 1,          /* whether an accepted step leaves anything to put right */
};
#define EM_MODEL_LANES (*lanes_here())
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if !EM_ALONE(EM_STEPPER)

enum {
    N_PARAMETERS = 17,
    N_PREPARED = 115,     /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 18,         /* inputs, parameters and the time */
    N_ARGUMENTS = 32,     /* x, v and these: what motion depends on */
    N1 = 7,               /* theta, aj, ab, ak, ac, af, ag */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4, 5, 6 };
#endif

#if EM_HOLDS(EM_MODEL)

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

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
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

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
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

#include "em_lane_factors.h"

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1], e[2], e[3], e[4], e[5], e[6] };
    if (mode) em_backward(N1, memory + 0, memory + 49, v1);
    else em_velocity_of_eta(N1, y + 14, y + 63, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
    v[4] = v1[4];
    v[5] = v1[5];
    v[6] = v1[6];
}

#define EM_VELOCITY velocity_by_roots

#include "em_flock.h"

extern em_lanes jansen_lanes;
em_lanes jansen_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* dM (n, n, n): dM[k, i, j] = dM_ij / dx_k */
EM_RARE /* no step calls it */
EM_ACROSS void mass_matrix_gradient(double t, const double *restrict x, const double *restrict c,
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
EM_ACROSS void factored_gradient(double t, const double *restrict x, const double *restrict c,
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
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
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
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
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
EM_ACROSS void observe(double t, const double *restrict x, const double *restrict v, const double *restrict a,
                       const double *restrict lambda, const double *restrict c, const double *restrict u,
                       double *restrict out)
{
}

/* p: what the drawing is made of, shape by shape */
EM_ACROSS void draw(double t, const double *restrict x, const double *restrict c, double *restrict p)
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
#if EM_HOLDS(EM_DERIVATIVES)

/* --- partial derivatives --- */

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta_dot = v[0];
    const double ab_dot = v[2];
    const double m = c[12];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double z_1 = m*cos_theta;
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double density = c[13];
    const double j = c[9];
    const double b = c[1];
    const double z_3 = j*b;
    const double z_4 = density*z_3;
    const double z_5 = cos_ab*z_4;
    const double sin_theta = em_sin(theta);
    const double z_7 = m*sin_theta;
    const double sin_ab = em_sin(ab);
    const double z_9 = sin_ab*z_4;
    const double z_10 = theta_dot*ab_dot*(z_1*z_5 + z_7*z_9);
    const double ac_dot = v[4];
    const double k = c[10];
    const double z_11 = density*k;
    const double c_ = c[2];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_13 = c_*cos_ac;
    const double z_14 = z_11*z_13;
    const double sin_ac = em_sin(ac);
    const double z_16 = c_*sin_ac;
    const double z_17 = z_11*z_16;
    const double z_18 = theta_dot*ac_dot*(z_1*z_14 + z_7*z_17);
    const double gravity = c[16];
    const double z_19 = z_11*gravity;
    const double z_20 = density*gravity;
    const double z_21 = j*z_20;
    const double z_22 = ab_dot*z_9;
    const double z_23 = theta_dot*z_1;
    const double z_24 = theta_dot*z_7;
    const double z_25 = ab_dot*cos_ab;
    const double z_26 = z_4*z_25;
    const double z_27 = (z_7*z_22 - z_23*z_5) - (z_24*z_9 - z_1*z_26);
    const double z_28 = ab_dot*z_27;
    const double z_29 = ac_dot*z_17;
    const double z_30 = ac_dot*z_13;
    const double z_31 = z_11*z_30;
    const double z_32 = (z_7*z_29 - z_23*z_14) - (z_24*z_17 - z_1*z_31);
    const double z_33 = ac_dot*z_32;
    const double z_34 = theta_dot*theta_dot;
    const double z_35 = z_34*z_1;
    const double aj_dot = v[1];
    const double z_36 = aj_dot*aj_dot;
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double z_38 = j*cos_aj;
    const double z_39 = z_36*z_38;
    const double z_40 = ab_dot*ab_dot;
    const double z_41 = b*cos_ab;
    const double z_42 = z_40*z_41;
    const double z_43 = b*b;
    const double z_44 = density*j;
    const double e = c[4];
    const double z_45 = density*e;
    const double d = c[3];
    const double z_46 = d*d;
    const double z_47 = z_43 + z_46 - e*e;
    const double f = c[5];
    const double z_48 = density*f;
    const double z_49 = z_45 + density*d + z_48;
    const double z_50 = z_47/b;
    const double z_51 = 4.0 - z_47*z_47/(z_43*z_46);
    const double z_52 = 1.0/(4.0*density*b*z_43 + 4.0*(z_44 + z_45)*z_43 + z_45*z_47 + (b*z_45 + z_49*z_50)*z_50 +
        z_49*z_51*z_46);
    const double z_53 = m*m;
    const double J = c[14];
    const double z_54 = z_53/(3.0*J + (z_44 + z_11)*z_53);
    const double z_55 = 1.0/(6.281075576154938*z_43*z_52 + 1.0439356584272999*z_54);
    const double z_56 = (z_35 + z_39 - z_42)*z_55;
    const double z_57 = z_53*z_55;
    const double z_58 = z_34*(sin_theta*sin_theta);
    const double ak_dot = v[3];
    const double z_59 = ak_dot*ak_dot;
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double z_61 = k*cos_ak;
    const double z_62 = z_59*z_61;
    const double z_63 = ac_dot*ac_dot;
    const double z_64 = z_63*z_13;
    const double z_65 = z_35 + z_62 - z_64;
    const double z_66 = c_*c_;
    const double z_67 = density*c_;
    const double g = c[6];
    const double z_68 = density*g;
    const double i = c[8];
    const double z_69 = density*i;
    const double h = c[7];
    const double z_70 = h*z_67;
    const double z_71 = density*h;
    const double z_72 = z_69 + z_71;
    const double z_73 = c_*z_72 + 0.5*i*z_67;
    const double z_74 = z_48 + z_68 + z_71;
    const double z_75 = c_*z_74 + 0.5*g*z_67;
    const double z_76 = z_66/(2.0*z_66*z_67 + 2.0*(z_11 + z_68 + z_69)*z_66 + c_*(2.0*z_70 + 2.0*z_73 + 2.0*z_75)
        + z_68*z_66 + z_69*z_66);
    const double z_77 = 1.0/(1.0439356584272999*z_54 + 1.9779122466912002*z_76);
    const double z_78 = z_65*z_77;
    const double z_79 = z_53*z_77;
    const double theta_ddot = a[0];
    const double z_80 = (z_57 + z_79)*(cos_theta*sin_theta);
    const double aj_ddot = a[1];
    const double sin_aj = em_sin(aj);
    const double z_82 = sin_aj*z_55;
    const double z_83 = j*z_82;
    const double z_84 = z_7*z_5;
    const double z_85 = m*z_4 - 2.0*m*b*z_55;
    const double z_86 = z_84 - cos_theta*sin_ab*z_85;
    const double ab_ddot = a[2];
    const double ak_ddot = a[3];
    const double sin_ak = em_sin(ak);
    const double z_88 = k*z_77;
    const double z_89 = sin_ak*z_88;
    const double z_90 = ak_ddot*z_89;
    const double z_91 = z_7*z_14;
    const double z_92 = m*c_;
    const double z_93 = z_11*z_92 - 2.0*z_77*z_92;
    const double z_94 = z_91 - cos_theta*sin_ac*z_93;
    const double ac_ddot = a[4];
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    const double lambda_2 = lambda[2];
    const double lambda_3 = lambda[3];
    D[0] = (1.0/6.0)*(((((z_10 + z_18) - 3.0*(z_19 + z_21)*z_7) + (z_28 + z_33)) + 2.0*((z_1*z_56 - z_57*z_58) +
        (z_1*z_78 - z_79*z_58))) + (4.0*theta_ddot*z_80 + 2.0*aj_ddot*z_1*z_83 + 2.0*z_1*z_90 - z_86*ab_ddot -
        z_94*ac_ddot) - 6.0*(lambda_0*z_1 + lambda_1*z_7 + lambda_2*z_1 + lambda_3*z_7));
    const double z_95 = z_55*z_7;
    const double z_96 = z_38*z_95;
    D[1] = ((-1.0/3.0))*(z_36*z_7*z_83 - aj_ddot*z_96);
    const double z_97 = sin_ab*z_55;
    const double z_98 = b*z_97;
    const double z_99 = z_1*z_9;
    const double z_100 = z_99 - cos_ab*sin_theta*z_85;
    D[2] = ((-1.0/6.0))*(((z_10 + z_28) - 2.0*z_40*z_7*z_98) + z_100*ab_ddot);
    const double z_101 = z_59*z_89;
    const double z_102 = cos_ak*z_88;
    const double z_103 = z_7*z_102;
    D[3] = ((-1.0/3.0))*(z_7*z_101 - ak_ddot*z_103);
    const double z_104 = z_63*z_16;
    const double z_105 = z_77*z_7;
    const double z_106 = z_1*z_17;
    const double z_107 = z_106 - sin_theta*cos_ac*z_93;
    D[4] = ((-1.0/6.0))*(((z_18 + z_33) - 2.0*z_104*z_105) + z_107*ac_ddot);
    D[7] = (2.0/3.0)*(theta_dot*z_80);
    D[8] = (2.0/3.0)*(aj_dot*z_96);
    const double z_108 = b*z_25;
    const double z_109 = z_84 - z_99;
    const double z_110 = theta_dot*z_109;
    const double z_111 = (z_1*z_22 + z_24*z_5) - (z_7*z_26 + z_23*z_9);
    const double z_112 = ab_dot*z_109;
    D[9] = ((-1.0/6.0))*(4.0*z_108*z_95 - (z_110 - (z_111 - z_112)));
    D[10] = (2.0/3.0)*(ak_dot*z_103);
    const double z_113 = z_91 - z_106;
    const double z_114 = theta_dot*z_113;
    const double z_115 = (z_24*z_14 + z_1*z_29) - (z_23*z_17 + z_7*z_31);
    const double z_116 = ac_dot*z_113;
    D[11] = ((-1.0/6.0))*(4.0*z_30*z_105 - (z_114 - (z_115 - z_116)));
    const double z_117 = theta_ddot*z_1;
    const double z_118 = z_34*z_7;
    D[14] = (1.0/3.0)*(z_117*z_83 - z_118*z_83);
    const double z_119 = j*j;
    const double z_120 = z_82*(cos_aj*z_119);
    const double z_121 = z_97*(cos_aj*z_3);
    const double z_122 = j*sin_aj;
    D[15] = (1.0/3.0)*((z_38*z_56 - z_55*z_36*z_119*(sin_aj*sin_aj)) + (theta_ddot*z_96 + 2.0*aj_ddot*z_120 -
        ab_ddot*z_121) - 3.0*(lambda_0*z_38 + lambda_1*z_122));
    const double z_123 = z_3*z_82;
    const double z_124 = cos_ab*z_123;
    const double z_125 = sin_ab*z_123;
    D[16] = ((-1.0/3.0))*(ab_ddot*z_124 - z_40*z_125);
    D[21] = (2.0/3.0)*(z_23*z_83);
    D[22] = (2.0/3.0)*(aj_dot*z_120);
    D[23] = ((-2.0/3.0))*(z_25*z_123);
    const double z_126 = theta_dot*z_27;
    D[28] = ((-1.0/6.0))*(((z_10 - z_126) - 2.0*z_118*z_98) + z_86*theta_ddot);
    D[29] = (1.0/3.0)*(z_36*z_125 - aj_ddot*z_121);
    const double z_127 = d*sqrt(0.25*z_51);
    const double z_128 = cos_ab*z_50 - 2.0*sin_ab*z_127;
    const double z_129 = z_48*z_128;
    const double z_130 = cos_ab*z_127;
    const double z_131 = sin_ab*z_50 + 2.0*z_130;
    const double z_132 = z_48*z_131;
    const double z_133 = ab_dot*ac_dot*(z_13*z_129 + z_16*z_132);
    const double ag_dot = v[6];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_135 = g*cos_ag;
    const double sin_ag = em_sin(ag);
    const double z_137 = g*sin_ag;
    const double z_138 = ab_dot*ag_dot*(z_135*z_129 + z_137*z_132);
    const double z_139 = e*z_20;
    const double z_140 = z_48*gravity;
    const double z_141 = z_140 + d*z_20;
    const double z_142 = ac_dot*z_16;
    const double z_143 = ab_dot*sin_ab;
    const double z_144 = z_50*z_25 - 2.0*z_127*z_143;
    const double z_145 = z_48*z_144;
    const double z_146 = z_50*z_143 + 2.0*z_127*z_25;
    const double z_147 = z_48*z_146;
    const double z_148 = (z_142*z_132 - z_13*z_145) + (z_30*z_129 - z_16*z_147);
    const double z_149 = ac_dot*z_148;
    const double z_150 = ag_dot*z_137;
    const double z_151 = ag_dot*z_135;
    const double z_152 = (z_135*z_145 - z_150*z_132) + (z_137*z_147 - z_151*z_129);
    const double z_153 = ag_dot*z_152;
    const double z_154 = ab_dot*z_144;
    const double af_dot = v[5];
    const double z_155 = af_dot*af_dot;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double z_157 = f*cos_af;
    const double z_158 = z_155*z_157;
    const double z_159 = ag_dot*ag_dot;
    const double z_160 = z_159*z_135;
    const double z_161 = 2.0*z_64 + 2.0*z_160 - z_154 - 2.0*z_158;
    const double z_162 = 0.9799867889375745*z_50 + 0.39812507335168834*z_127;
    const double z_163 = 0.7809576093147158*z_50 - 1.2491680630778932*z_127;
    const double z_164 = g*g;
    const double z_165 = i*i;
    const double z_166 = z_164 + z_165 - h*h;
    const double z_167 = z_166/g;
    const double z_168 = 4.0 - z_166*z_166/(z_164*z_165);
    const double z_169 = 1.0/(1.9779122466912002*z_76 + z_52*(z_162*z_162) + z_52*(z_163*z_163) +
        0.7654631453230909*z_164/(g*(4.0*g*z_74 + z_71*z_167) + (z_68*h + z_72*z_167)*z_167 + z_72*z_168*z_165));
    const double z_170 = z_161*z_169;
    const double z_171 = ab_dot*z_146;
    const double z_172 = z_131*z_169;
    const double z_173 = z_43*z_97;
    const double z_174 = z_13*z_132;
    const double z_175 = c_*z_169;
    const double z_176 = c_*z_48 - 2.0*z_175;
    const double z_177 = z_174 - sin_ac*z_128*z_176;
    const double af_ddot = a[5];
    const double sin_af = em_sin(af);
    const double z_179 = f*z_169;
    const double z_180 = sin_af*z_179;
    const double z_181 = af_ddot*z_180;
    const double z_182 = z_135*z_132;
    const double z_183 = z_48*g - 2.0*g*z_169;
    const double z_184 = z_182 - z_128*sin_ag*z_183;
    const double ag_ddot = a[6];
    const double z_185 = b*sin_ab;
    const double lambda_4 = lambda[4];
    const double lambda_5 = lambda[5];
    D[30] = (1.0/12.0)*(((((2.0*z_10 + z_133 + z_138) - 3.0*(sin_ab*((2.0*b + z_50)*z_139 + 2.0*b*(z_21 + b*z_20)
        + z_50*z_141) + 2.0*z_130*(z_139 + z_141))) - (2.0*z_126 + z_153 - z_149)) - (4.0*(z_41*z_56 +
        z_43*z_55*z_40*(sin_ab*sin_ab)) + (z_128*z_170 + z_171*z_172))) + 6.0*(2.0*lambda_0*z_41 +
        2.0*lambda_1*z_185 - z_128*lambda_4 - z_131*lambda_5) - (2.0*z_100*theta_ddot + 4.0*aj_ddot*z_124 +
        z_177*ac_ddot + z_184*ag_ddot - 2.0*(z_128*z_172 + 4.0*cos_ab*z_173)*ab_ddot - 2.0*z_128*z_181));
    const double z_186 = z_16*z_129;
    const double z_187 = z_186 - cos_ac*z_131*z_176;
    D[32] = ((-1.0/12.0))*(((z_133 + z_149) - 2.0*z_104*z_172) + z_187*ac_ddot);
    const double z_188 = z_155*z_180;
    const double z_189 = cos_af*z_179;
    const double z_190 = af_ddot*z_189;
    D[33] = ((-1.0/6.0))*(z_131*z_188 - z_131*z_190);
    const double z_191 = z_159*z_137;
    const double z_192 = z_137*z_129;
    const double z_193 = z_192 - z_131*cos_ag*z_183;
    D[34] = ((-1.0/12.0))*(((z_138 - z_153) - 2.0*z_191*z_172) + z_193*ag_ddot);
    D[35] = ((-1.0/6.0))*(4.0*z_23*z_98 + (z_112 + (z_111 + z_110)));
    D[36] = ((-2.0/3.0))*(aj_dot*z_121);
    const double z_194 = z_144 + ab_dot*z_128;
    D[37] = (1.0/12.0)*(8.0*z_25*z_173 + z_194*z_172);
    const double z_195 = z_174 - z_186;
    const double z_196 = ab_dot*z_195;
    const double z_197 = (z_142*z_129 + z_13*z_147) - (z_30*z_132 + z_16*z_145);
    const double z_198 = ac_dot*z_195;
    D[39] = ((-1.0/12.0))*(4.0*z_30*z_172 - (z_196 - (z_197 - z_198)));
    const double z_199 = af_dot*z_189;
    D[40] = (1.0/3.0)*(z_131*z_199);
    const double z_200 = z_182 - z_192;
    const double z_201 = ab_dot*z_200;
    const double z_202 = (z_135*z_147 + z_150*z_129) - (z_137*z_145 + z_151*z_132);
    const double z_203 = ag_dot*z_200;
    D[41] = ((-1.0/12.0))*(4.0*z_151*z_172 - (z_201 - (z_202 - z_203)));
    D[42] = (1.0/3.0)*(z_117*z_89 - z_118*z_89);
    const double z_204 = z_77*(k*k);
    const double z_205 = z_204*(sin_ak*cos_ak);
    const double z_206 = ac_ddot*z_16;
    const double z_207 = k*sin_ak;
    D[45] = (1.0/3.0)*((z_65*z_102 - z_59*(sin_ak*sin_ak)*z_204) + (theta_ddot*z_103 + 2.0*ak_ddot*z_205 -
        z_206*z_102) - 3.0*(lambda_2*z_61 + lambda_3*z_207));
    const double z_208 = ac_ddot*z_13;
    D[46] = ((-1.0/3.0))*(z_208*z_89 - z_104*z_89);
    D[49] = (2.0/3.0)*(z_23*z_89);
    D[52] = (2.0/3.0)*(ak_dot*z_205);
    D[53] = ((-2.0/3.0))*(z_30*z_89);
    const double z_209 = theta_dot*z_32;
    const double z_210 = z_77*z_16;
    D[56] = ((-1.0/6.0))*(((z_18 - z_209) - 2.0*z_118*z_210) + z_94*theta_ddot);
    const double z_211 = ab_dot*z_148;
    const double z_212 = z_169*z_16;
    D[58] = ((-1.0/12.0))*(((z_133 - z_211) - 2.0*z_171*z_212) + z_177*ab_ddot);
    const double z_213 = z_16*z_102;
    D[59] = (1.0/3.0)*(z_16*z_101 - ak_ddot*z_213);
    const double z_214 = z_70 + 2.0*z_73;
    const double z_215 = 2.0*g*(z_70 + 2.0*z_75) + z_214*z_167;
    const double z_216 = cos_ac*cos_ag;
    const double z_217 = sin_ac*sin_ag;
    const double z_218 = i*sqrt(0.25*z_168);
    const double z_219 = z_214*z_218;
    const double z_220 = cos_ac*sin_ag;
    const double z_221 = sin_ac*cos_ag;
    const double z_222 = ac_dot*ag_dot*(z_215*z_216 + z_215*z_217 + 2.0*z_219*z_221 - 2.0*z_219*z_220);
    const double z_223 = g*z_20;
    const double z_224 = i*z_20;
    const double z_225 = h*z_20;
    const double z_226 = z_224 + z_225;
    const double z_227 = ac_dot*z_215;
    const double z_228 = ag_dot*z_215;
    const double z_229 = ac_dot*z_219;
    const double z_230 = ag_dot*z_219;
    const double z_231 = (z_216*z_227 - z_217*z_228) + 2.0*(z_221*z_229 + z_220*z_230) + (z_217*z_227 -
        z_216*z_228) - 2.0*(z_220*z_229 + z_221*z_230);
    const double z_232 = ag_dot*z_231;
    const double z_233 = z_66*z_77;
    const double z_234 = z_63*(sin_ac*sin_ac);
    const double z_235 = z_66*z_169;
    const double z_236 = (z_233 + z_235)*(cos_ac*sin_ac);
    const double z_237 = z_215 + 4.0*g*z_175;
    const double z_238 = z_219*z_217 + z_219*z_216;
    const double z_239 = z_215*z_221 - 2.0*z_238;
    const double z_240 = z_239 - z_237*z_220;
    D[60] = (1.0/12.0)*(((((2.0*z_18 + z_133 + z_222) - 6.0*(z_19 + 2.0*z_223 + c_*z_20 + 2.0*z_226 + z_140)*z_16)
        - (2.0*z_209 + z_211 + z_232)) - 2.0*(2.0*(z_13*z_78 + z_233*z_234) - (z_13*z_170 - 2.0*z_235*z_234))) +
        12.0*(lambda_2*z_13 + lambda_3*z_16 + lambda_4*z_13 + lambda_5*z_16) - (2.0*z_107*theta_ddot +
        z_187*ab_ddot + 4.0*z_13*z_90 + 4.0*z_13*z_181 + z_240*ag_ddot - 8.0*ac_ddot*z_236));
    D[61] = (1.0/3.0)*(z_16*z_188 - z_16*z_190);
    const double z_241 = z_169*z_137;
    const double z_242 = z_215*z_220;
    const double z_243 = z_242 + 2.0*z_238 - z_237*z_221;
    D[62] = ((-1.0/12.0))*(((z_222 - z_232) + 4.0*z_159*z_16*z_241) + z_243*ag_ddot);
    D[63] = ((-1.0/6.0))*(4.0*z_23*z_210 + (z_116 + (z_115 + z_114)));
    D[65] = ((-1.0/12.0))*((z_198 + (z_197 + z_196)) + 2.0*z_194*z_212);
    D[66] = ((-2.0/3.0))*(ak_dot*z_213);
    D[67] = (2.0/3.0)*(ac_dot*z_236);
    D[68] = ((-2.0/3.0))*(z_16*z_199);
    const double z_244 = z_239 - z_242;
    const double z_245 = ac_dot*z_244;
    const double z_246 = (z_221*z_227 + z_220*z_228) - 2.0*(z_217*z_229 - z_216*z_230) - 2.0*(z_216*z_229 -
        z_217*z_230) - (z_220*z_227 + z_221*z_228);
    const double z_247 = ag_dot*z_244;
    D[69] = (1.0/12.0)*(8.0*z_151*z_212 + (z_245 - (z_246 - z_247)));
    const double z_248 = z_128*ab_ddot;
    D[72] = ((-1.0/6.0))*(z_171*z_180 - z_248*z_180);
    D[74] = ((-1.0/3.0))*(z_208*z_180 - z_104*z_180);
    const double z_249 = z_169*(f*f);
    const double z_250 = z_131*ab_ddot;
    const double z_251 = z_249*(sin_af*cos_af);
    const double z_252 = ag_ddot*z_137;
    const double z_253 = f*sin_af;
    D[75] = ((-1.0/6.0))*((z_161*z_189 + 2.0*z_155*(sin_af*sin_af)*z_249) + 6.0*(lambda_4*z_157 + lambda_5*z_253)
        - (z_250*z_189 + 4.0*af_ddot*z_251 - 2.0*z_206*z_189 - 2.0*z_252*z_189));
    const double z_254 = ag_ddot*z_135;
    D[76] = ((-1.0/3.0))*(z_254*z_180 - z_191*z_180);
    D[79] = (1.0/6.0)*(z_194*z_180);
    D[81] = ((-2.0/3.0))*(z_30*z_180);
    D[82] = (2.0/3.0)*(af_dot*z_251);
    D[83] = ((-2.0/3.0))*(z_151*z_180);
    const double z_255 = ab_dot*z_152;
    D[86] = ((-1.0/12.0))*(((z_138 + z_255) - 2.0*z_171*z_241) + z_184*ab_ddot);
    const double z_256 = ac_dot*z_231;
    D[88] = ((-1.0/12.0))*(((z_222 + z_256) + 4.0*z_104*z_241) + z_240*ac_ddot);
    D[89] = (1.0/3.0)*(z_137*z_188 - z_137*z_190);
    const double z_257 = z_164*z_169;
    const double z_258 = z_257*(cos_ag*sin_ag);
    D[90] = (1.0/12.0)*(((((z_138 + z_222) - 3.0*(sin_ag*(z_167*z_224 + (2.0*g + z_167)*z_225 + 2.0*g*(z_223 +
        z_140)) + 2.0*cos_ag*z_226*z_218)) + (z_255 + z_256)) + 2.0*(z_135*z_170 -
        2.0*z_159*(sin_ag*sin_ag)*z_257)) + 12.0*(lambda_4*z_135 + lambda_5*z_137) - (z_193*ab_ddot +
        z_243*ac_ddot + 4.0*z_135*z_181 - 8.0*ag_ddot*z_258));
    D[93] = ((-1.0/12.0))*((z_203 + (z_202 + z_201)) + 2.0*z_194*z_241);
    D[95] = (1.0/12.0)*(8.0*z_30*z_241 - (z_247 + (z_246 + z_245)));
    D[96] = ((-2.0/3.0))*(z_137*z_199);
    D[97] = (2.0/3.0)*(ag_dot*z_258);
    D[98] = z_118 - z_117;
    D[99] = z_36*z_122 - aj_ddot*z_38;
    D[100] = -(z_40*z_185 - ab_ddot*z_41);
    D[105] = (-2.0)*z_23;
    D[106] = (-2.0)*(aj_dot*z_38);
    D[107] = 2.0*z_108;
    D[112] = -(z_35 + theta_ddot*z_7);
    D[113] = -(z_39 + aj_ddot*z_122);
    D[114] = z_42 + ab_ddot*z_185;
    D[119] = (-2.0)*z_24;
    D[120] = (-2.0)*(aj_dot*z_122);
    D[121] = 2.0*(ab_dot*z_185);
    D[126] = z_118 - z_117;
    D[129] = z_59*z_207 - ak_ddot*z_61;
    D[130] = -(z_104 - z_208);
    D[133] = (-2.0)*z_23;
    D[136] = (-2.0)*(ak_dot*z_61);
    D[137] = 2.0*z_30;
    D[140] = -(z_35 + theta_ddot*z_7);
    D[143] = -(z_62 + ak_ddot*z_207);
    D[144] = z_64 + z_206;
    D[147] = (-2.0)*z_24;
    D[150] = (-2.0)*(ak_dot*z_207);
    D[151] = 2.0*z_142;
    D[156] = 0.5*(z_171 - z_248);
    D[158] = -(z_104 - z_208);
    D[159] = z_155*z_253 - af_ddot*z_157;
    D[160] = -(z_191 - z_254);
    D[163] = (-0.5)*z_194;
    D[165] = 2.0*z_30;
    D[166] = (-2.0)*(af_dot*z_157);
    D[167] = 2.0*z_151;
    D[170] = (-0.5)*(z_154 + z_250);
    D[172] = z_64 + z_206;
    D[173] = -(z_158 + af_ddot*z_253);
    D[174] = z_160 + z_252;
    D[177] = (-0.5)*(z_146 + ab_dot*z_131);
    D[179] = 2.0*z_142;
    D[180] = (-2.0)*(af_dot*z_253);
    D[181] = 2.0*z_150;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double ab = x[2];
    const double sin_ab = em_sin(ab);
    const double ab_dot = v[2];
    const double z_1 = ab_dot*ab_dot;
    const double z_2 = sin_ab*z_1;
    const double j = c[9];
    const double density = c[13];
    const double m = c[12];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double z_4 = m*cos_theta;
    const double z_5 = density*z_4;
    const double z_6 = j*z_5;
    const double cos_ab = em_cos(ab);
    const double ab_ddot = a[2];
    const double z_8 = cos_ab*ab_ddot;
    const double b = c[1];
    const double z_9 = b*b;
    const double z_10 = density*b;
    const double z_11 = density*j;
    const double e = c[4];
    const double z_12 = density*e;
    const double z_13 = z_11 + z_12;
    const double z_14 = z_9;
    const double d = c[3];
    const double z_15 = d*d;
    const double z_16 = z_14 + z_15 - e*e;
    const double f = c[5];
    const double z_17 = density*f;
    const double z_18 = density*d + z_17;
    const double z_19 = z_12 + z_18;
    const double z_20 = 1.0/b;
    const double z_21 = z_16*z_20;
    const double z_22 = e*z_10 + z_19*z_21;
    const double z_23 = 1.0/z_9;
    const double z_24 = z_16*z_16;
    const double z_25 = z_23*z_24;
    const double z_26 = 1.0/z_15;
    const double z_27 = 4.0 - z_25*z_26;
    const double z_28 = z_27*z_15;
    const double z_29 = 4.0*z_9*z_10 + 4.0*z_13*z_9 + z_12*z_16 + z_22*z_21 + z_19*z_28;
    const double z_30 = 1.0/z_29;
    const double z_31 = m*m;
    const double J = c[14];
    const double k = c[10];
    const double z_32 = density*k;
    const double z_33 = z_11 + z_32;
    const double z_34 = 3.0*J + z_33*z_31;
    const double z_35 = 1.0/z_34;
    const double z_36 = z_31*z_35;
    const double z_37 = 6.281075576154938*z_9*z_30 + 1.0439356584272999*z_36;
    const double z_38 = 1.0/z_37;
    const double z_39 = m*z_38;
    const double z_40 = m*z_11;
    const double z_41 = 2.0*z_39 - z_40;
    const double sin_theta = em_sin(theta);
    const double z_43 = cos_ab*z_1;
    const double z_44 = sin_theta*z_43;
    const double z_45 = sin_ab*ab_ddot;
    const double z_46 = sin_theta*z_45;
    const double z_47 = 1.0/(z_37*z_37);
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    const double z_49 = j*sin_aj;
    const double z_50 = z_47*z_49;
    const double aj_ddot = a[1];
    const double z_51 = m*sin_theta;
    const double z_52 = aj_ddot*z_51;
    const double theta_dot = v[0];
    const double z_53 = theta_dot*theta_dot;
    const double z_54 = z_53*z_4;
    const double cos_aj = em_cos(aj);
    const double aj_dot = v[1];
    const double z_56 = aj_dot*aj_dot;
    const double z_57 = cos_aj*z_56;
    const double z_58 = z_54 + j*z_57 - b*z_43;
    const double z_59 = z_58*z_47;
    const double z_60 = b*z_45;
    const double theta_ddot = a[0];
    const double z_61 = theta_ddot*(sin_theta*sin_theta);
    const double z_62 = z_31*z_61;
    const double z_63 = z_50*z_52 + z_51*z_59 + z_47*z_62 - z_47*z_51*z_60;
    const double z_64 = b*z_30;
    const double z_65 = 1.0/(z_29*z_29);
    const double z_66 = z_19*z_65;
    const double z_67 = z_24*z_66;
    const double z_68 = z_22*z_65;
    const double z_69 = e*z_16;
    const double z_70 = b*z_13;
    const double z_71 = z_9*z_65;
    const double z_72 = z_16*z_66 - b*z_68 - z_12*z_71;
    const double z_73 = z_65*(z_9*z_9);
    const double z_74 = 4.187383717436625*z_64 + 2.0936918587183126*z_16*z_68 + 4.187383717436625*b*z_72 -
        2.0936918587183126*z_20*z_67 - 2.0936918587183126*z_69*z_65*z_10 - 16.7495348697465*z_70*z_71 -
        25.124302304619754*density*z_73;
    D[1] = ((-1.0/6.0))*(z_2*z_6 + z_41*z_44 + z_41*z_46 + 6.0*z_63*z_74 - z_8*z_6);
    const double ac = x[4];
    const double sin_ac = em_sin(ac);
    const double ac_dot = v[4];
    const double z_76 = ac_dot*ac_dot;
    const double z_77 = sin_ac*z_76;
    const double z_78 = k*z_5;
    const double cos_ac = em_cos(ac);
    const double ac_ddot = a[4];
    const double z_80 = cos_ac*ac_ddot;
    const double z_81 = cos_ac*z_76;
    const double c_ = c[2];
    const double z_82 = c_*c_;
    const double z_83 = density*c_;
    const double g = c[6];
    const double z_84 = density*g;
    const double i = c[8];
    const double z_85 = density*i;
    const double z_86 = z_32 + z_84 + z_85;
    const double h = c[7];
    const double z_87 = density*h;
    const double z_88 = z_85 + z_87;
    const double z_89 = c_*z_88;
    const double z_90 = z_17 + z_84 + z_87;
    const double z_91 = c_*z_90;
    const double z_92 = h*z_83;
    const double z_93 = g*z_83;
    const double z_94 = i*z_83;
    const double z_95 = z_93 + z_94;
    const double z_96 = 2.0*z_89 + 2.0*z_91 + 2.0*z_92 + z_95;
    const double z_97 = 2.0*z_82*z_83 + 2.0*z_86*z_82 + c_*z_96 + z_84*z_82 + z_85*z_82;
    const double z_98 = 1.0/z_97;
    const double z_99 = z_82*z_98;
    const double z_100 = 1.0439356584272999*z_36 + 1.9779122466912002*z_99;
    const double z_101 = 1.0/z_100;
    const double z_102 = m*z_101;
    const double z_103 = m*z_32;
    const double z_104 = 2.0*z_102 - z_103;
    const double z_105 = sin_ac*ac_ddot;
    const double z_106 = sin_theta*z_105;
    const double z_107 = 1.0/(z_100*z_100);
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    const double z_109 = k*sin_ak;
    const double z_110 = z_107*z_109;
    const double ak_ddot = a[3];
    const double z_111 = ak_ddot*z_51;
    const double cos_ak = em_cos(ak);
    const double ak_dot = v[3];
    const double z_113 = ak_dot*ak_dot;
    const double z_114 = cos_ak*z_113;
    const double z_115 = c_*z_81;
    const double z_116 = z_54 + k*z_114 - z_115;
    const double z_117 = z_116*z_107;
    const double z_118 = c_*sin_ac;
    const double z_119 = ac_ddot*z_118;
    const double z_120 = z_110*z_111 + z_51*z_117 + z_107*z_62 - z_107*z_51*z_119;
    const double z_121 = 1.0/(z_97*z_97);
    const double z_122 = z_82*z_121;
    const double z_123 = c_*z_122;
    const double z_124 = z_83*z_122;
    const double z_125 = i*z_124 + g*z_124;
    const double z_126 = c_*z_98;
    const double z_127 = z_121*(z_82*z_82);
    const double z_128 = density*z_127;
    const double z_129 = (z_126 - 3.0*z_128) - 0.5*(z_96*z_122 + 4.0*z_86*z_123);
    const double z_130 = (z_88*z_123 + 1.5*z_125) - (z_129 - (h*z_124 + z_90*z_123));
    const double z_131 = -1.3186081644608*z_130;
    D[2] = ((-1.0/6.0))*(z_77*z_78 + sin_theta*z_81*z_104 + z_104*z_106 + 6.0*z_120*z_131 - z_80*z_78);
    const double z_132 = d*z_27;
    const double z_133 = z_19*z_132;
    const double z_134 = z_28*z_71 + z_24*z_65;
    const double z_135 = 4.187383717436625*z_133*z_71 + 4.187383717436625*z_67/d +
        2.0936918587183126*density*z_134 - 4.187383717436625*d*z_72;
    D[3] = z_63*z_135;
    const double z_136 = density*z_16;
    const double z_137 = 2.0936918587183126*z_134 + 8.37476743487325*z_73;
    const double z_138 = 4.187383717436625*z_136*z_71 + 4.187383717436625*e*z_72 + density*z_137;
    D[4] = z_63*z_138;
    const double z_139 = z_120*z_127;
    const double z_140 = 1.3186081644608*z_139 + 2.0936918587183126*z_63*z_134;
    D[5] = density*z_140;
    D[6] = 3.9558244933824005*(z_120*z_128);
    D[7] = 3.9558244933824005*(z_120*z_128);
    D[8] = 3.9558244933824005*(z_120*z_128);
    const double z_141 = sin_aj*z_38;
    const double z_142 = z_43*z_51;
    const double z_143 = z_4*z_10;
    const double gravity = c[16];
    const double z_144 = density*gravity;
    const double z_145 = z_4*z_144;
    const double z_146 = z_57*z_38;
    const double z_147 = z_45*z_51;
    const double z_148 = z_120 + z_63;
    const double z_149 = 1.0/(z_34*z_34);
    const double z_150 = z_31*z_149;
    const double z_151 = theta_ddot + 1.0439356584272999*z_148*z_150;
    const double z_152 = (1.0/3.0)*z_151;
    const double z_153 = z_152*z_31;
    const double z_154 = 8.37476743487325*z_63*z_73 + z_153;
    D[9] = (1.0/6.0)*(2.0*z_141*z_52 + z_10*z_142 + 3.0*z_145 + 2.0*z_51*z_146 + z_10*z_147 + z_8*z_143 +
        6.0*density*z_154 - z_2*z_143);
    const double z_155 = sin_ak*z_101;
    const double z_156 = cos_ac*z_83;
    const double z_157 = z_76*z_156;
    const double z_158 = sin_ac*z_83;
    const double z_159 = z_76*z_158;
    const double z_160 = z_114*z_101;
    const double z_161 = z_105*z_83;
    const double z_162 = ac_ddot*z_156;
    const double z_163 = 1.3186081644608*z_139 + z_153;
    D[10] = (1.0/6.0)*(2.0*z_155*z_111 + z_51*z_157 + 3.0*z_145 + 2.0*z_51*z_160 + z_51*z_161 + z_4*z_162 +
        6.0*density*z_163 - z_4*z_159);
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    const double lambda_2 = lambda[2];
    const double lambda_3 = lambda[3];
    const double z_164 = z_101*z_109;
    const double z_165 = ak_ddot*z_164;
    const double z_166 = z_38*z_49;
    const double z_167 = aj_ddot*z_166;
    const double z_168 = z_116*z_101;
    const double z_169 = z_58*z_38;
    const double z_170 = k*z_156;
    const double z_171 = j*z_10;
    const double z_172 = cos_theta*z_171;
    const double z_173 = k*z_144;
    const double z_174 = j*z_144;
    const double z_175 = cos_theta*z_53;
    const double z_176 = z_39 + z_102;
    const double z_177 = m*z_35;
    const double z_178 = m*z_33;
    const double z_179 = c_*z_101;
    const double z_180 = k*z_83;
    const double z_181 = 2.0*z_179 - z_180;
    const double z_182 = b*z_38;
    const double z_183 = 2.0*z_182 - z_171;
    D[12] = -(sin_theta*lambda_0 + sin_theta*lambda_2 + (1.0/6.0)*k*cos_theta*z_159 + (1.0/6.0)*z_2*z_172 +
        0.6959571056181999*z_148*z_177 + (1.0/6.0)*z_181*z_106 + (1.0/6.0)*z_183*z_46 - cos_theta*lambda_1 -
        cos_theta*lambda_3 - (1.0/3.0)*sin_theta*z_165 - (1.0/3.0)*sin_theta*z_167 - (1.0/3.0)*sin_theta*z_168 -
        (1.0/3.0)*sin_theta*z_169 - (1.0/6.0)*sin_theta*z_76*z_170 - (1.0/6.0)*z_171*z_44 - 0.5*cos_theta*(z_173 +
        z_174) - (1.0/3.0)*sin_theta*z_175*z_176 - (1.0/6.0)*cos_theta*ac_ddot*z_170 - (1.0/6.0)*z_8*z_172 -
        2.0*z_152*z_178 - (2.0/3.0)*z_176*z_61);
    const double z_184 = k*z_51;
    const double z_185 = j*b;
    const double z_186 = k*z_118;
    const double z_187 = z_4*z_185;
    const double z_188 = k*z_4;
    const double z_189 = c_*z_80;
    const double z_190 = m*gravity;
    const double z_191 = c_*z_127;
    const double z_192 = i*z_127 + g*z_127;
    const double z_193 = h*z_127 + z_192;
    const double z_194 = z_191 + 3.0*z_193;
    const double z_195 = (d*z_134 + 2.0*z_69*z_71) + 0.4776252034586246*(e*z_137 + 8.37476743487325*b*z_73);
    D[13] = (1.0/6.0)*(z_115*z_184 + z_185*z_142 + 6.0*f*z_140 + z_119*z_184 + z_188*z_189 + z_185*z_147 +
        z_8*z_187 + 6.0*k*z_163 + 6.0*j*z_154 + 3.0*cos_theta*(j*z_190 + k*z_190) +
        6.0*z_120*(1.3186081644608*z_194) + 6.0*z_63*(2.0936918587183126*z_195) - z_76*z_4*z_186 - z_2*z_187);
    D[14] = z_151;
    D[15] = -1.0;
    D[16] = 0.5*(cos_theta*(z_40 + z_103));
    const double z_196 = aj_ddot*(sin_aj*sin_aj);
    const double z_197 = theta_ddot*z_51;
    const double z_198 = z_50*z_60 - z_47*(j*j)*z_196 - z_197*z_50 - z_58*z_50;
    D[19] = ((-1.0/3.0))*(z_45*z_166 + z_43*z_166 - 3.0*z_74*z_198);
    D[21] = -z_135*z_198;
    D[22] = -z_138*z_198;
    const double z_199 = density*z_198;
    D[23] = (-2.0936918587183126)*(z_134*z_199);
    const double z_200 = z_149*(z_31*z_31);
    const double z_201 = 8.37476743487325*z_73 + 0.34797855280909995*z_200;
    D[27] = ((-1.0/3.0))*(3.0*sin_aj*lambda_0 + z_141*z_60 + 3.0*z_201*z_199 - 3.0*cos_aj*lambda_1 -
        2.0*j*z_38*z_196 - z_197*z_141 - z_58*z_141 - z_57*z_166);
    D[28] = (-0.34797855280909995)*(z_200*z_199);
    const double z_202 = sin_theta*theta_ddot;
    const double z_203 = z_177 - z_150*z_178;
    D[30] = (1.0/3.0)*z_202*z_166 + (1.0/3.0)*z_175*z_166 + 0.6959571056181999*z_198*z_203;
    D[31] = -z_198*(2.0936918587183126*f*z_134 + 0.34797855280909995*k*z_200 + j*z_201 +
        2.0936918587183126*z_195);
    D[32] = (-1.0439356584272999)*(z_198*z_150);
    const double z_204 = z_53*z_51;
    const double z_205 = cos_ab*z_204;
    const double z_206 = b*sin_ab;
    const double z_207 = z_16*z_23;
    const double ag_dot = v[6];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_209 = g*cos_ag;
    const double z_210 = z_17*z_209;
    const double z_211 = ag_dot*z_210;
    const double z_212 = f*z_156;
    const double z_213 = ac_dot*z_212;
    const double z_214 = z_211 + z_213;
    const double z_215 = ab_dot*sin_ab;
    const double z_216 = z_214*z_215;
    const double sin_ag = em_sin(ag);
    const double z_218 = g*sin_ag;
    const double z_219 = ag_dot*z_218;
    const double z_220 = ac_dot*z_158;
    const double z_221 = sqrt(0.25*z_27);
    const double z_222 = d*z_221;
    const double z_223 = 0.9799867889375745*z_21 + 0.39812507335168834*z_222;
    const double z_224 = z_223*z_223;
    const double z_225 = 0.7809576093147158*z_21 - 1.2491680630778932*z_222;
    const double z_226 = z_225*z_225;
    const double z_227 = g*g;
    const double z_228 = g*z_90;
    const double z_229 = i*i;
    const double z_230 = z_227 + z_229 - h*h;
    const double z_231 = 1.0/g;
    const double z_232 = z_230*z_231;
    const double z_233 = 4.0*z_228 + z_87*z_232;
    const double z_234 = g*z_87 + z_88*z_232;
    const double z_235 = 1.0/z_227;
    const double z_236 = z_230*z_230;
    const double z_237 = z_235*z_236;
    const double z_238 = 1.0/z_229;
    const double z_239 = 4.0 - z_237*z_238;
    const double z_240 = z_88*z_239;
    const double z_241 = g*z_233 + z_234*z_232 + z_229*z_240;
    const double z_242 = 1.0/z_241;
    const double z_243 = 1.9779122466912002*z_99 + z_30*z_224 + z_30*z_226 + 0.7654631453230909*z_227*z_242;
    const double z_244 = 1.0/z_243;
    const double z_245 = sin_ab*z_21 + 2.0*cos_ab*z_222;
    const double z_246 = ab_dot*z_245;
    const double z_247 = z_17*z_219 + f*z_220 + z_244*z_246;
    const double z_248 = ab_dot*cos_ab;
    const double z_249 = z_247*z_248;
    const double z_250 = ab_ddot*(sin_ab*sin_ab);
    const double z_251 = aj_ddot*z_206;
    const double z_252 = z_50*z_251 + z_206*z_59 + z_47*z_197*z_206 - z_9*z_47*z_250;
    const double z_253 = z_21*z_248 - 2.0*z_222*z_215;
    const double z_254 = ab_dot*z_253;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double af_dot = v[5];
    const double z_256 = af_dot*af_dot;
    const double z_257 = cos_af*z_256;
    const double z_258 = ag_dot*ag_dot;
    const double z_259 = z_258*z_209;
    const double z_260 = 2.0*z_115 + 2.0*z_259 - z_254 - 2.0*f*z_257;
    const double z_261 = z_260*z_244;
    const double lambda_4 = lambda[4];
    const double af_ddot = a[5];
    const double sin_af = em_sin(af);
    const double z_263 = f*sin_af;
    const double z_264 = z_244*z_263;
    const double z_265 = af_ddot*z_264;
    const double ag_ddot = a[6];
    const double z_266 = z_17*g;
    const double z_267 = g*z_244;
    const double z_268 = sin_ag*(z_266 - 2.0*z_267);
    const double z_269 = f*z_83;
    const double z_270 = c_*z_244;
    const double z_271 = z_269 - 2.0*z_270;
    const double z_272 = z_245*ab_ddot;
    const double z_273 = ab_dot*z_211 + ab_dot*z_213 + 2.0*z_265 + z_258*z_210 + z_76*z_212 + ag_ddot*z_268 +
        z_271*z_105 + 2.0*z_244*z_272 - z_261 - 6.0*lambda_4;
    const double z_274 = sin_ab*z_273;
    const double z_275 = cos_ab*z_144;
    const double z_276 = 1.0/(z_243*z_243);
    const double z_277 = z_276*z_263;
    const double z_278 = af_ddot*z_277;
    const double z_279 = z_245*z_276;
    const double z_280 = ag_ddot*z_218;
    const double z_281 = 2.0*z_245*z_278 + ab_ddot*z_276*(z_245*z_245) - z_260*z_279 - 2.0*z_280*z_279 -
        2.0*z_119*z_279;
    const double z_282 = z_225*z_30;
    const double z_283 = z_223*z_30;
    const double z_284 = z_282 + 1.2548527311200737*z_283;
    const double z_285 = e*z_275 - 4.0*z_281*(0.13015960155245263*z_284);
    const double z_286 = ab_dot*z_17;
    const double z_287 = ab_dot*f;
    const double lambda_5 = lambda[5];
    const double z_288 = z_258*z_218;
    const double z_289 = z_286*z_219 + z_287*z_220 + z_17*z_288 + f*z_159 - 6.0*lambda_5 - ag_ddot*z_210 -
        ac_ddot*z_212;
    const double z_290 = cos_ab*z_289;
    const double z_291 = z_222/z_27;
    const double z_292 = e*z_144;
    const double z_293 = z_17*gravity;
    const double z_294 = z_293 + d*z_144;
    const double z_295 = sin_ab*(z_292 + z_294);
    const double z_296 = z_214*z_248;
    const double z_297 = z_247*z_215;
    const double z_298 = cos_ab*z_273;
    const double z_299 = z_282 - 0.31871217742368974*z_283;
    const double z_300 = z_281*(0.20819467717964885*z_299);
    const double z_301 = sin_ab*z_289;
    const double z_302 = z_65*z_226 + z_65*z_224;
    const double z_303 = ab_ddot - 12.0*(2.0936918587183126*z_252*z_71 - (1.0/12.0)*z_281*z_302);
    const double z_304 = (3.0*z_291*z_295 + z_291*z_296 + z_291*z_297 - z_291*z_298 - 6.0*z_291*z_300 -
        z_291*z_301) - z_19*z_303*z_15;
    const double z_305 = b*z_9;
    const double z_306 = z_24/(z_305);
    const double z_307 = z_26*z_306;
    const double z_308 = z_26*z_207;
    const double z_309 = 3.0*cos_ab*z_294*z_20 + z_20*z_249 + z_20*z_274 + 3.0*z_285*z_20 + 2.0*z_304*z_308 +
        z_303*(z_12 + z_22*z_20 + z_19*z_207) - z_20*z_216 - z_20*z_290;
    const double z_310 = cos_ab*theta_ddot;
    const double z_311 = b*z_144;
    const double z_312 = sin_ab*z_202;
    const double z_313 = density*z_9;
    const double z_314 = z_12*z_21;
    D[37] = sin_ab*lambda_0 + (1.0/6.0)*sin_ab*z_53*z_6 + (1.0/3.0)*z_43*z_38*z_206 + (1.0/12.0)*z_207*z_216 +
        (2.0/3.0)*z_182*z_250 + 4.187383717436625*z_64*z_252 + (1.0/12.0)*z_207*z_290 + (1.0/6.0)*b*z_309 +
        (1.0/6.0)*z_6*z_310 + 0.25*cos_ab*(2.0*z_311 + 2.0*z_292 + 2.0*(z_174 + z_311) - z_294*z_207) -
        cos_ab*lambda_1 - (1.0/3.0)*sin_ab*z_167 - (1.0/3.0)*sin_ab*z_169 - (1.0/6.0)*z_11*z_205 -
        (1.0/12.0)*z_207*z_249 - (1.0/12.0)*z_207*z_274 - 0.25*z_285*z_207 - (1.0/6.0)*z_304*z_307 -
        (1.0/6.0)*z_41*z_312 - (1.0/12.0)*z_303*(z_22*z_207 + z_19*z_306 - 8.0*z_70 - 12.0*z_313 - z_314);
    const double z_315 = ac_dot*sin_ac;
    const double z_316 = z_17*z_253;
    const double z_317 = z_21*z_215 + 2.0*z_222*z_248;
    const double z_318 = ac_dot*z_317;
    const double z_319 = sin_ab*z_222;
    const double z_320 = cos_ab*z_21 - 2.0*z_319;
    const double z_321 = z_17*z_320;
    const double z_322 = z_320*z_286;
    const double z_323 = ac_dot*z_245;
    const double z_324 = cos_ac*z_286;
    const double z_325 = z_17 - 2.0*z_244;
    const double z_326 = z_245*z_325;
    D[38] = (1.0/12.0)*(z_315*z_316 + z_323*z_324 + z_80*z_321 + z_81*z_326 + z_105*z_326 - cos_ac*z_17*z_318 -
        z_77*z_321 - z_315*z_322 - 12.0*z_281*(-0.3296520411152*z_130));
    const double z_327 = z_320*z_144;
    const double z_328 = z_25/(d*z_15);
    const double z_329 = z_28 + z_25;
    D[39] = ((-1.0/12.0))*(6.0*z_221*z_295 + 2.0*z_221*z_296 + 2.0*z_221*z_297 + 2.0*z_304*z_328 - 3.0*z_327 -
        2.0*z_221*z_298 - 12.0*z_221*z_300 - 2.0*z_221*z_301 - 2.0*d*z_309 - z_303*(2.0*z_133 + density*z_329));
    const double z_330 = 2.0*b + z_21;
    const double z_331 = 4.0*z_14 + z_329;
    D[40] = (1.0/12.0)*(3.0*z_330*z_275 + z_303*(2.0*z_136 + density*z_331) - 6.0*z_319*z_144 - 2.0*e*z_309);
    const double z_332 = sin_af*z_244;
    const double z_333 = af_ddot*z_332;
    const double z_334 = density*z_209;
    const double z_335 = density*z_219;
    const double z_336 = density*z_218;
    const double z_337 = ag_dot*z_317;
    const double z_338 = ab_dot*z_320;
    const double z_339 = 1.0/(z_241*z_241);
    const double z_340 = z_227*z_227*z_339;
    const double z_341 = z_127 + 0.7740112298749502*z_340;
    const double z_342 = 0.3296520411152*z_341;
    const double z_343 = 12.0*z_281*z_342 + z_303*z_329;
    D[41] = (1.0/12.0)*(2.0*z_245*z_333 + z_245*z_258*z_334 + z_253*z_335 + z_253*z_220 + z_245*z_157 +
        ag_dot*z_334*z_246 + ac_dot*z_156*z_246 + 3.0*z_327 + 2.0*z_245*z_257*z_244 + density*z_245*z_280 +
        z_320*ag_ddot*z_334 + z_245*z_161 + z_320*z_162 + density*z_343 - z_320*z_258*z_336 - z_334*z_337 -
        z_156*z_318 - z_320*z_159 - z_338*z_335 - z_220*z_338);
    const double z_344 = ag_dot*sin_ag;
    const double z_345 = sin_ag*z_258;
    const double z_346 = ag_dot*z_245;
    const double z_347 = cos_ag*z_286;
    const double z_348 = cos_ag*ag_ddot;
    const double z_349 = cos_ag*z_258;
    const double z_350 = sin_ag*ag_ddot;
    const double z_351 = 0.3296520411152*z_127 + z_342;
    const double z_352 = z_88*z_236;
    const double z_353 = z_339*z_352;
    const double z_354 = z_231*z_353;
    const double z_355 = z_230*z_339;
    const double z_356 = z_88*z_355;
    const double z_357 = z_227*z_339;
    const double z_358 = g*z_234*z_339 + z_87*z_357;
    const double z_359 = z_358 - z_356;
    const double z_360 = g*z_242;
    const double z_361 = (z_360 + 0.5*z_234*z_355) - 0.5*(z_233*z_357 + 4.0*z_228*z_357);
    const double z_362 = (z_128 + 0.19350280746873755*z_354) + 0.3870056149374751*(g*z_359 - z_361);
    D[42] = (1.0/12.0)*(z_344*z_316 + z_346*z_347 + z_348*z_321 + z_349*z_326 + z_350*z_326 +
        12.0*z_281*(density*z_351 + 0.3296520411152*z_362) - z_345*z_321 - z_17*cos_ag*z_337 - z_344*z_322);
    const double z_363 = z_239*z_229;
    const double z_364 = z_363*z_357 + z_236*z_339;
    const double z_365 = z_127 + 0.19350280746873755*z_364;
    const double z_366 = 0.3296520411152*z_365;
    const double z_367 = z_342 + z_366;
    const double z_368 = density*z_230;
    const double z_369 = h*z_359 - 2.5839418380572092*(z_128 + 0.3870056149374751*z_357*z_368);
    D[43] = z_281*(density*z_367 - 0.1275771908871818*z_369);
    const double z_370 = 0.3296520411152*z_127 + z_366;
    const double z_371 = i*z_240;
    const double z_372 = (z_128 + 0.3870056149374751*z_357*z_371) + 0.3870056149374751*(z_353/i + i*z_359);
    D[44] = z_281*(density*z_370 + 0.3296520411152*z_372);
    const double z_373 = sin_ab*z_54;
    const double z_374 = sin_ab*z_197;
    const double z_375 = z_200*z_252;
    const double z_376 = (1.0/3.0)*z_303*z_9 - 0.34797855280909995*z_375;
    D[45] = ((-1.0/6.0))*(2.0*z_141*z_251 + z_10*z_205 + 2.0*z_206*z_146 - z_10*z_373 - 3.0*b*z_275 - z_10*z_374 -
        z_310*z_143 - 6.0*density*z_376);
    const double z_377 = 0.3296520411152*z_127*z_281 - 0.34797855280909995*z_375;
    D[46] = density*z_377;
    const double z_378 = sin_theta*z_53;
    D[48] = -((1.0/6.0)*cos_ab*z_378*z_171 + (1.0/6.0)*sin_ab*z_175*z_183 + (1.0/6.0)*z_183*z_312 -
        (1.0/6.0)*z_310*z_172 - 0.6959571056181999*z_203*z_252);
    const double z_379 = f*z_245;
    const double z_380 = f*z_253;
    const double z_381 = ac_dot*z_118;
    const double z_382 = f*z_320;
    const double z_383 = c_*cos_ac;
    const double z_384 = z_320*z_287;
    const double z_385 = e*gravity;
    const double z_386 = f*gravity;
    const double z_387 = h*z_230;
    const double z_388 = z_357*z_387;
    const double z_389 = z_193 + (z_191 + 0.3870056149374751*z_388);
    D[49] = (1.0/12.0)*(z_259*z_379 + z_219*z_380 + z_381*z_380 + z_115*z_379 + 2.0*z_185*z_373 +
        z_209*z_287*z_346 + z_287*z_383*z_323 + z_280*z_379 + ag_ddot*z_209*z_382 + z_119*z_379 + z_382*z_189 +
        f*z_343 + 2.0*z_185*z_374 + 2.0*z_310*z_187 + 12.0*k*z_377 + 12.0*j*z_376 + 3.0*z_320*(d*gravity + z_386)
        + 3.0*cos_ab*(z_330*z_385 + 2.0*gravity*z_9 + 2.0*gravity*z_185) + 12.0*z_281*(h*z_367 + i*z_370 + g*z_351
        + 0.3296520411152*z_389) + z_303*(4.0*z_305 + 2.0*z_69 + d*z_329 + e*z_331) - z_382*z_288 - f*z_209*z_337
        - f*z_383*z_318 - z_76*z_118*z_382 - 2.0*z_185*z_205 - z_219*z_384 - z_381*z_384 - 6.0*z_319*z_385);
    D[50] = (-1.0439356584272999)*(z_252*z_150);
    D[52] = (-0.25)*(2.0*z_12*z_319 - z_320*z_18 - cos_ab*(2.0*z_313 + 2.0*z_171 + z_12*z_330));
    const double z_390 = ak_ddot*(sin_ak*sin_ak);
    const double z_391 = z_119*z_110 - z_107*(k*k)*z_390 - z_197*z_110 - z_116*z_110;
    D[56] = ((-1.0/3.0))*(z_105*z_164 + z_81*z_164 - 3.0*z_131*z_391);
    const double z_392 = z_128*z_391;
    D[59] = (-1.3186081644608)*z_392;
    D[60] = (-3.9558244933824005)*z_392;
    D[61] = (-3.9558244933824005)*z_392;
    D[62] = (-3.9558244933824005)*z_392;
    const double z_393 = density*z_391;
    D[63] = (-0.34797855280909995)*(z_200*z_393);
    const double z_394 = 1.3186081644608*z_127 + 0.34797855280909995*z_200;
    D[64] = ((-1.0/3.0))*(3.0*sin_ak*lambda_2 + z_119*z_155 + 3.0*z_394*z_393 - 3.0*cos_ak*lambda_3 -
        2.0*k*z_101*z_390 - z_197*z_155 - z_116*z_155 - z_114*z_164);
    D[66] = (1.0/3.0)*z_202*z_164 + (1.0/3.0)*z_175*z_164 + 0.6959571056181999*z_203*z_391;
    D[67] = -z_391*(1.3186081644608*f*z_127 + k*z_394 + 0.34797855280909995*j*z_200 + 1.3186081644608*z_194);
    D[68] = (-1.0439356584272999)*(z_391*z_150);
    const double z_395 = z_2*z_207;
    const double z_396 = z_43*z_207;
    const double z_397 = sin_ac*z_271;
    const double z_398 = z_45*z_207;
    const double z_399 = z_8*z_207;
    const double z_400 = z_43*z_291;
    const double z_401 = z_2*z_291;
    const double z_402 = z_8*z_291;
    const double z_403 = z_276*z_118;
    const double z_404 = ac_ddot*(sin_ac*sin_ac);
    const double z_405 = z_82*z_404;
    const double z_406 = 2.0*z_118*z_278 + z_272*z_403 - z_260*z_403 - 2.0*z_280*z_403 - 2.0*z_276*z_405;
    const double z_407 = 0.4163893543592977*z_299;
    const double z_408 = z_407*z_291;
    const double z_409 = z_45*z_291;
    const double z_410 = z_19*z_302;
    const double z_411 = z_15*z_410;
    const double z_412 = (z_400*z_212 + z_401*z_397 + 6.0*z_406*z_408 + z_409*z_212 - z_402*z_397) +
        2.0*z_406*z_411;
    const double z_413 = z_2*z_20;
    const double z_414 = z_43*z_20;
    const double z_415 = z_45*z_20;
    const double z_416 = z_8*z_20;
    const double z_417 = 0.26031920310490525*z_284;
    const double z_418 = z_22*z_302;
    const double z_419 = 6.0*z_417*z_20 - z_20*z_418 - z_207*z_410 - z_12*z_302;
    const double z_420 = z_413*z_212 - z_414*z_397 - z_415*z_397 - z_416*z_212 - 2.0*z_412*z_308 -
        2.0*z_406*z_419;
    const double z_421 = z_302*z_9;
    const double z_422 = density*z_421;
    const double z_423 = 6.0*z_417*z_207 + z_302*z_314 + 8.0*z_70*z_302 + 12.0*z_422 - z_207*z_418 - z_306*z_410;
    D[73] = (1.0/12.0)*(z_395*z_212 - z_396*z_397 - z_398*z_397 - z_399*z_212 - 2.0*z_412*z_307 - 2.0*b*z_420 -
        2.0*z_406*z_423);
    const double z_424 = z_253*z_286;
    const double z_425 = z_270 + z_179;
    const double z_426 = ak_ddot*z_118;
    const double z_427 = z_110*z_426 + z_118*z_117 + z_107*z_118*z_197 - z_107*z_405;
    const double z_428 = 0.3296520411152*z_406 + 0.6593040822304*z_427;
    const double z_429 = sqrt(0.25*z_239);
    const double z_430 = i*z_429;
    const double z_431 = sin_ag*z_430;
    const double z_432 = sin_ac*z_258;
    const double z_433 = cos_ac*z_349;
    const double z_434 = sin_ac*z_348;
    const double z_435 = cos_ac*ag_ddot;
    const double z_436 = sin_ac*z_349 + sin_ac*z_350 + cos_ac*z_348 - cos_ac*z_345;
    const double z_437 = 2.0*z_431*z_432 + 2.0*z_430*z_433 + 2.0*z_431*z_435 - 2.0*z_430*z_434 - z_232*z_436;
    const double z_438 = g*z_436;
    const double z_439 = ac_ddot - 6.0*z_428*z_122;
    const double z_440 = c_*z_439;
    const double z_441 = z_437 - 2.0*z_438 - 4.0*z_440;
    const double z_442 = ab_ddot*z_321;
    const double z_443 = gravity*z_83;
    const double z_444 = i*z_144;
    const double z_445 = g*z_144;
    const double z_446 = h*z_144;
    const double z_447 = z_445 + z_446;
    const double z_448 = z_325*z_272;
    const double z_449 = sin_ac*z_202;
    const double z_450 = density*z_82;
    const double z_451 = z_437 - 2.0*z_440;
    const double z_452 = z_438 + z_440;
    D[74] = (1.0/12.0)*(12.0*sin_ac*lambda_2 + 12.0*sin_ac*lambda_4 + 2.0*sin_ac*z_261 + sin_ac*z_424 +
        2.0*sin_ac*z_53*z_78 + 4.0*sin_ac*z_81*z_425 + 4.0*sin_ac*z_244*z_280 + 24.0*z_126*z_428 + cos_ac*z_442 +
        2.0*cos_ac*theta_ddot*z_78 + 6.0*cos_ac*(z_443 + (z_173 + z_443 + 2.0*z_444 + z_293 + 2.0*z_447)) +
        8.0*z_425*z_404 + sin_ac*z_448 + 2.0*z_439*(z_96 + 6.0*z_450 + 4.0*c_*z_86 + 2.0*z_95) + 2.0*z_452*(z_84 +
        2.0*z_90) - 12.0*cos_ac*lambda_3 - 12.0*cos_ac*lambda_5 - 4.0*sin_ac*z_265 - 4.0*sin_ac*z_165 -
        4.0*sin_ac*z_168 - z_317*z_324 - 2.0*z_32*cos_ac*z_204 - z_87*z_441 - 2.0*z_104*z_449 - z_451*(z_85 +
        2.0*z_88));
    const double z_453 = z_43*z_221;
    const double z_454 = z_2*z_221;
    const double z_455 = z_8*z_221;
    const double z_456 = z_45*z_221;
    const double z_457 = z_28*z_302 + z_302*z_25;
    const double z_458 = 6.0*z_407*z_221 + 2.0*z_410*z_132 + density*z_457;
    D[75] = ((-1.0/6.0))*(z_453*z_212 + z_454*z_397 + z_456*z_212 + z_412*z_328 + d*z_420 + z_406*z_458 -
        z_455*z_397);
    const double z_459 = z_457 + 4.0*z_421;
    const double z_460 = 2.0*z_136*z_302 + density*z_459;
    D[76] = (1.0/6.0)*(e*z_420 - z_406*z_460);
    const double z_461 = ab_dot*z_317;
    const double z_462 = gravity*z_156;
    const double z_463 = z_244*z_118;
    const double z_464 = z_320*ab_ddot;
    const double z_465 = 0.5103087635487272*z_340*z_406 - (1.0/3.0)*c_*z_452;
    const double z_466 = 6.0*z_465 + z_406*z_457;
    D[77] = ((-1.0/12.0))*(4.0*z_118*z_333 + z_156*z_461 + 4.0*z_257*z_463 + 2.0*density*z_466 - z_254*z_158 -
        6.0*z_462 - z_158*z_272 - z_156*z_464);
    const double z_467 = z_406*z_357;
    const double z_468 = z_88*z_229;
    const double z_469 = 2.0*z_89 + z_94 + z_92;
    const double z_470 = 1.0/z_239;
    const double z_471 = z_469*z_470;
    const double z_472 = z_431*z_471;
    const double z_473 = z_430*z_471;
    const double z_474 = 0.1275771908871818*z_467*z_468 + (1.0/12.0)*(z_472*z_432 + z_433*z_473 + z_472*z_435 -
        z_434*z_473);
    const double z_475 = z_474*z_238;
    const double z_476 = 1.0/(g*z_227);
    const double z_477 = z_236*z_476;
    const double z_478 = z_230*z_235;
    const double z_479 = z_469*z_231;
    const double z_480 = 2.0*z_478*z_475 + (1.0/12.0)*z_436*z_479 - 0.1275771908871818*z_406*(z_356 + z_358);
    const double z_481 = z_439*z_82;
    const double z_482 = 3.0*z_465 - z_481;
    const double z_483 = 2.0*(2.0*z_91 + z_93 + z_92) - z_469*z_478;
    const double z_484 = z_462 + (1.0/6.0)*z_450*z_439;
    D[78] = (1.0/12.0)*(4.0*z_349*z_463 + 4.0*z_350*z_463 + 24.0*g*z_480 + 2.0*z_452*z_83 +
        12.0*z_406*(0.1275771908871818*z_354 + 0.2551543817743636*z_361) + z_436*z_483 + 12.0*z_484 -
        24.0*z_475*z_477 - 4.0*density*z_482);
    const double z_485 = (1.0/6.0)*c_*z_451 + 0.1275771908871818*z_406*z_364;
    const double z_486 = z_465 + z_485;
    D[79] = z_462 - 0.2551543817743636*z_368*z_467 - 2.0*h*z_480 - (1.0/12.0)*z_441*z_83 - density*z_486;
    const double z_487 = z_469*z_429;
    const double z_488 = z_237/(i*z_229);
    const double z_489 = 3.0*z_485 - z_481;
    D[80] = -((1.0/6.0)*sin_ac*z_345*z_487 + (1.0/6.0)*z_487*z_433 + 0.2551543817743636*z_371*z_467 +
        (1.0/6.0)*cos_ac*z_350*z_487 + 2.0*z_474*z_488 + (1.0/12.0)*z_451*z_83 + (1.0/3.0)*density*z_489 -
        (1.0/6.0)*z_487*z_434 - 2.0*i*z_480 - z_484);
    const double z_490 = z_200*z_427;
    const double z_491 = (2.0/3.0)*z_406*z_421 + 0.34797855280909995*z_490;
    D[81] = -density*z_491;
    const double z_492 = (1.0/3.0)*z_481 - 0.34797855280909995*z_490;
    D[82] = ((-1.0/6.0))*(2.0*z_155*z_426 + z_156*z_204 + 2.0*z_118*z_160 - z_54*z_158 - 3.0*z_462 - z_158*z_197 -
        theta_ddot*z_156*z_4 - 6.0*density*z_492);
    const double z_493 = cos_theta*theta_ddot;
    D[84] = -((1.0/6.0)*z_378*z_170 + (1.0/6.0)*sin_ac*z_175*z_181 + (1.0/6.0)*z_181*z_449 - (1.0/6.0)*z_493*z_170
        - 0.6959571056181999*z_203*z_427);
    const double z_494 = z_253*z_287;
    const double z_495 = z_317*z_287;
    const double z_496 = c_*h;
    const double z_497 = c_*i;
    const double z_498 = c_*g;
    const double z_499 = f*z_272;
    const double z_500 = ab_ddot*z_382;
    const double z_501 = c_*gravity;
    const double z_502 = (d*z_457 + 2.0*z_69*z_302) + (e*z_459 + 4.0*b*z_421);
    D[85] = (1.0/12.0)*(z_118*z_494 + 2.0*z_54*z_186 + 2.0*z_452*z_498 + z_118*z_499 + z_383*z_500 +
        2.0*z_197*z_186 + 2.0*theta_ddot*z_383*z_188 + 12.0*k*z_492 + 6.0*cos_ac*(f*z_501 + 2.0*h*z_501 +
        2.0*i*z_501 + gravity*z_82 + 2.0*g*z_501 + k*z_501) + 2.0*z_439*(2.0*c_*z_82 + i*z_82 + g*z_82) -
        z_383*z_495 - 2.0*k*z_383*z_204 - z_441*z_496 - z_451*z_497 - 12.0*h*z_486 - 4.0*i*z_489 - 4.0*g*z_482 -
        2.0*f*z_466 - 12.0*j*z_491 - 12.0*z_406*(0.2551543817743636*z_388 + (1.0/6.0)*z_502));
    D[86] = (-1.0439356584272999)*(z_427*z_150);
    D[88] = 0.5*(cos_ac*(z_269 + 2.0*z_92 + z_450 + z_180 + 2.0*z_95));
    const double z_503 = af_ddot*(sin_af*sin_af);
    const double z_504 = 2.0*z_280*z_277 + 2.0*z_119*z_277 + z_260*z_277 - 2.0*z_276*(f*f)*z_503 - z_272*z_277;
    const double z_505 = (z_401*z_264 + 3.0*z_504*z_408 - z_402*z_264) + z_504*z_411;
    const double z_506 = z_414*z_264 + z_415*z_264 + 2.0*z_505*z_308 + z_419*z_504;
    D[91] = ((-1.0/6.0))*(z_396*z_264 + z_398*z_264 + 2.0*z_505*z_307 + z_423*z_504 - 2.0*b*z_506);
    D[92] = ((-1.0/3.0))*(z_105*z_264 + z_81*z_264 - 3.0*z_504*(-0.6593040822304*z_130));
    D[93] = ((-1.0/6.0))*(2.0*z_454*z_264 + 2.0*z_505*z_328 + z_458*z_504 - 2.0*z_455*z_264 - 2.0*d*z_506);
    D[94] = ((-1.0/6.0))*(2.0*e*z_506 + z_460*z_504);
    const double z_507 = 0.6593040822304*z_341;
    const double z_508 = z_457 + 6.0*z_507;
    D[95] = ((-1.0/6.0))*(6.0*sin_af*lambda_4 + 2.0*z_332*z_280 + 2.0*z_119*z_332 + z_260*z_332 +
        density*z_504*z_508 - 6.0*cos_af*lambda_5 - 4.0*f*z_244*z_503 - z_272*z_332 - 2.0*z_257*z_264);
    const double z_509 = 0.6593040822304*z_127 + z_507;
    D[96] = ((-1.0/3.0))*(z_350*z_264 + z_349*z_264 + 3.0*z_504*(density*z_509 + 0.6593040822304*z_362));
    const double z_510 = 0.6593040822304*z_365;
    const double z_511 = z_507 + z_510;
    D[97] = -z_504*(density*z_511 - 0.2551543817743636*z_369);
    const double z_512 = 0.6593040822304*z_127 + z_510;
    D[98] = -z_504*(density*z_512 + 0.6593040822304*z_372);
    D[99] = ((-2.0/3.0))*(z_422*z_504);
    D[100] = (-0.6593040822304)*(z_128*z_504);
    const double z_513 = z_502 + 3.9558244933824005*(k*z_127 + 1.0111672058989218*j*z_421);
    D[103] = -z_504*(h*z_511 + i*z_512 + g*z_509 + (1.0/6.0)*f*z_508 + 0.6593040822304*z_389 + (1.0/6.0)*z_513);
    const double z_514 = z_276*z_218;
    const double z_515 = ag_ddot*(sin_ag*sin_ag);
    const double z_516 = 2.0*z_218*z_278 + z_272*z_514 - z_260*z_514 - 2.0*z_227*z_276*z_515 - 2.0*z_119*z_514;
    const double z_517 = (z_400*z_210 + z_401*z_268 + 6.0*z_516*z_408 + z_409*z_210 - z_402*z_268) +
        2.0*z_516*z_411;
    const double z_518 = z_413*z_210 - z_414*z_268 - z_415*z_268 - z_416*z_210 - 2.0*z_517*z_308 -
        2.0*z_419*z_516;
    D[109] = (1.0/12.0)*(z_395*z_210 - z_396*z_268 - z_398*z_268 - z_399*z_210 - 2.0*z_517*z_307 - 2.0*b*z_518 -
        2.0*z_423*z_516);
    const double z_519 = z_244*z_218;
    const double z_520 = cos_ag*z_430;
    const double z_521 = z_81*z_520;
    const double z_522 = z_105*z_520;
    const double z_523 = sin_ag*z_81 + sin_ag*z_105 + cos_ag*z_80 - cos_ag*z_77;
    const double z_524 = 2.0*z_521 + 2.0*z_77*z_431 + 2.0*z_522 + z_232*z_523 - 2.0*z_80*z_431;
    const double z_525 = g*z_523;
    const double z_526 = z_516*z_123;
    const double z_527 = (1.0/12.0)*z_524 + (1.0/6.0)*z_525 - 0.6593040822304*z_526;
    const double z_528 = z_524 - 3.9558244933824005*z_526;
    const double z_529 = (1.0/12.0)*z_528;
    const double z_530 = z_525 - 1.9779122466912002*z_526;
    const double z_531 = (1.0/6.0)*z_530;
    const double z_532 = (1.0/3.0)*z_530;
    const double z_533 = (1.0/6.0)*z_528;
    D[110] = (1.0/3.0)*(z_81*z_519 + z_105*z_519 + 3.0*z_87*z_527 + 3.0*z_85*z_529 + 3.0*z_84*z_531 +
        3.0*z_90*z_532 + 3.0*z_88*z_533 + 3.0*z_516*(0.6593040822304*z_129 - 0.6593040822304*z_125));
    D[111] = ((-1.0/6.0))*(z_453*z_210 + z_454*z_268 + z_456*z_210 + z_517*z_328 + d*z_518 + z_458*z_516 -
        z_455*z_268);
    D[112] = (1.0/6.0)*(e*z_518 - z_460*z_516);
    const double z_534 = (1.0/12.0)*ag_ddot - 0.1275771908871818*z_516*z_357;
    const double z_535 = 4.0*z_534*z_227 + c_*z_532;
    const double z_536 = 6.0*z_535 - z_457*z_516;
    D[113] = ((-1.0/12.0))*(4.0*z_218*z_333 + z_334*z_461 + 4.0*z_257*z_519 - z_254*z_336 - 6.0*z_209*z_144 -
        z_272*z_336 - z_334*z_464 - 2.0*density*z_536);
    const double z_537 = z_444 + z_446;
    const double z_538 = 12.0*z_534*z_468 + (z_521*z_471 + z_77*z_472 + z_522*z_471 - 3.0*z_537*z_470*z_431 -
        z_80*z_472);
    const double z_539 = z_538*z_238;
    const double z_540 = 2.0*z_478*z_539 - z_523*z_479 - 3.0*cos_ag*(z_444*z_231 + z_446*z_231) - 12.0*z_534*(z_87
        + z_234*z_231 + z_88*z_478);
    const double z_541 = z_127*z_516;
    const double z_542 = z_535 - 0.6593040822304*z_541;
    D[114] = (1.0/12.0)*(12.0*sin_ag*lambda_4 + 2.0*sin_ag*z_261 + sin_ag*z_424 + 4.0*z_349*z_519 +
        8.0*z_267*z_515 + 4.0*sin_ag*z_244*z_119 + 2.0*z_539*z_477 + 12.0*z_531*z_83 + 12.0*density*z_542 +
        cos_ag*z_442 + 3.0*cos_ag*(2.0*(z_445 + z_293) + 2.0*z_447 - z_444*z_478 - z_446*z_478) + sin_ag*z_448 +
        12.0*z_534*(4.0*z_228 + z_233 - z_234*z_478 - z_476*z_352) + z_483*z_523 - 12.0*cos_ag*lambda_5 -
        4.0*sin_ag*z_265 - z_317*z_347 - 2.0*g*z_540 - 12.0*z_516*(0.3296520411152*z_128 -
        0.2551543817743636*z_360));
    const double z_543 = 2.0*g + z_232;
    const double z_544 = cos_ag*z_144;
    const double z_545 = c_*z_533 + z_534*(z_363 + z_237);
    const double z_546 = z_535 + z_545;
    D[115] = (1.0/12.0)*(3.0*z_543*z_544 + 24.0*z_534*z_368 + 2.0*h*z_540 + 12.0*z_527*z_83 + 12.0*density*z_546 -
        6.0*z_144*z_431);
    const double z_547 = cos_ag*z_487;
    const double z_548 = sin_ag*z_487;
    const double z_549 = z_128*z_516;
    const double z_550 = z_545 - 0.6593040822304*z_541;
    D[116] = (1.0/6.0)*z_81*z_547 + (1.0/6.0)*z_77*z_548 + 0.25*z_232*z_544 + 2.0*z_534*z_371 +
        (1.0/6.0)*z_105*z_547 + (1.0/6.0)*z_538*z_488 + z_529*z_83 + density*z_550 - (1.0/6.0)*z_80*z_548 -
        (1.0/6.0)*i*z_540 - 0.3296520411152*z_549 - 0.5*sin_ag*(z_144*z_430 + z_537*z_429);
    D[117] = ((-2.0/3.0))*(z_422*z_516);
    D[118] = (-0.6593040822304)*z_549;
    const double z_551 = h*gravity;
    const double z_552 = z_229*z_429;
    D[121] = (1.0/12.0)*(z_218*z_494 + 24.0*z_534*z_387 + 12.0*z_527*z_496 + 12.0*z_529*z_497 + 12.0*z_531*z_498 +
        12.0*h*z_546 + 12.0*i*z_550 + 12.0*g*z_542 + z_218*z_499 + z_209*z_500 + 2.0*f*z_536 +
        3.0*cos_ag*(z_543*z_551 + i*gravity*z_232 + 2.0*g*z_386 + 2.0*gravity*z_227) - z_209*z_495 -
        6.0*sin_ag*(z_430*z_551 + gravity*z_552) - 12.0*z_516*(0.6593040822304*z_191 + 0.3296520411152*z_192 +
        (1.0/6.0)*z_513));
    D[124] = 0.25*(cos_ag*(2.0*z_266 + z_87*z_543 + z_85*z_232 + 2.0*density*z_227) - 2.0*sin_ag*(z_87*z_430 +
        density*z_552));
    D[127] = z_43 + z_45;
    D[135] = -(z_57 + sin_aj*aj_ddot);
    D[138] = -(z_175 + z_202);
    D[145] = z_2 - z_8;
    D[153] = -(sin_aj*z_56 - cos_aj*aj_ddot);
    D[156] = -(z_378 - z_493);
    D[164] = z_81 + z_105;
    D[172] = -(z_114 + sin_ak*ak_ddot);
    D[174] = -(z_175 + z_202);
    D[182] = z_77 - z_80;
    D[190] = -(sin_ak*z_113 - cos_ak*ak_ddot);
    D[192] = -(z_378 - z_493);
    const double z_553 = z_401 - z_402;
    const double z_554 = z_414 + z_415 + 2.0*z_553*z_308;
    D[199] = 0.5*(z_396 + z_398 + 2.0*z_553*z_307 - 2.0*b*z_554);
    D[200] = z_81 + z_105;
    D[201] = z_454 + z_553*z_328 - z_455 - d*z_554;
    D[202] = e*z_554;
    D[203] = -(z_257 + sin_af*af_ddot);
    D[204] = z_349 + z_350;
    const double z_555 = z_400 + z_409;
    const double z_556 = z_413 - z_416 - 2.0*z_555*z_308;
    D[217] = 0.5*(z_395 - z_399 - 2.0*z_555*z_307 - 2.0*b*z_556);
    D[218] = z_77 - z_80;
    D[219] = -(z_453 + z_456 + z_555*z_328 + d*z_556);
    D[220] = e*z_556;
    D[221] = -(sin_af*z_256 - cos_af*af_ddot);
    D[222] = z_345 - z_348;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double m = c[12];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    D[0] = -m*sin_theta;
    const double j = c[9];
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    D[1] = -j*sin_aj;
    const double b = c[1];
    const double ab = x[2];
    const double sin_ab = em_sin(ab);
    D[2] = b*sin_ab;
    D[14] = 1.0;
    const double cos_ab = em_cos(ab);
    D[15] = -cos_ab;
    const double cos_aj = em_cos(aj);
    D[23] = cos_aj;
    const double cos_theta = em_cos(theta);
    D[26] = cos_theta;
    D[32] = m*cos_theta;
    D[33] = j*cos_aj;
    D[34] = -b*cos_ab;
    D[47] = -sin_ab;
    D[55] = sin_aj;
    D[57] = 1.0;
    D[58] = sin_theta;
    D[64] = -m*sin_theta;
    const double k = c[10];
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    D[67] = -k*sin_ak;
    const double c_ = c[2];
    const double ac = x[4];
    const double sin_ac = em_sin(ac);
    D[68] = c_*sin_ac;
    D[78] = 1.0;
    const double cos_ac = em_cos(ac);
    D[80] = -cos_ac;
    const double cos_ak = em_cos(ak);
    D[88] = cos_ak;
    D[90] = cos_theta;
    D[96] = m*cos_theta;
    D[99] = k*cos_ak;
    D[100] = -c_*cos_ac;
    D[112] = -sin_ac;
    D[120] = sin_ak;
    D[121] = 1.0;
    D[122] = sin_theta;
    const double z_10 = b*b;
    const double d = c[3];
    const double z_11 = d*d;
    const double e = c[4];
    const double z_12 = z_10 + z_11 - e*e;
    const double z_13 = 1.0/b;
    const double z_14 = sin_ab*z_13;
    const double z_15 = 1.0/z_11;
    const double z_16 = 1.0/z_10;
    const double z_17 = z_12*z_12;
    const double z_18 = z_16*z_17;
    const double z_19 = 4.0 - z_15*z_18;
    const double z_20 = sqrt(0.25*z_19);
    const double z_21 = d*z_20;
    const double z_22 = z_12*z_14 + 2.0*cos_ab*z_21;
    D[130] = (-0.5)*z_22;
    D[132] = c_*sin_ac;
    const double f = c[5];
    const double af = x[5];
    const double sin_af = em_sin(af);
    D[133] = -f*sin_af;
    const double g = c[6];
    const double ag = x[6];
    const double sin_ag = em_sin(ag);
    D[134] = g*sin_ag;
    const double z_25 = z_12*z_16;
    const double z_26 = 2.0 - z_25;
    const double z_27 = 1.0/z_19;
    const double z_28 = z_27*z_21;
    const double z_29 = (z_15*z_17/(b*z_10) - 2.0*z_12*z_15*z_13)*z_28;
    const double z_30 = cos_ab*z_26 - 2.0*sin_ab*z_29;
    D[143] = 0.5*z_30;
    D[144] = -cos_ac;
    const double z_31 = cos_ab*z_13;
    const double z_32 = z_25/d;
    const double z_33 = z_20 + (z_18/(d*z_11) - 2.0*z_32)*z_28;
    const double z_34 = d*z_31 - sin_ab*z_33;
    D[145] = z_34;
    const double z_35 = e*z_32*(z_20*z_27);
    const double z_36 = e*z_31 + 2.0*sin_ab*z_35;
    D[146] = -z_36;
    const double cos_af = em_cos(af);
    D[147] = cos_af;
    const double cos_ag = em_cos(ag);
    D[148] = -cos_ag;
    const double z_39 = z_12*z_31 - 2.0*sin_ab*z_21;
    D[162] = 0.5*z_39;
    D[164] = -c_*cos_ac;
    D[165] = f*cos_af;
    D[166] = -g*cos_ag;
    const double z_40 = sin_ab*z_26 + 2.0*cos_ab*z_29;
    D[175] = 0.5*z_40;
    D[176] = -sin_ac;
    const double z_41 = d*z_14 + cos_ab*z_33;
    D[177] = z_41;
    const double z_42 = e*z_14 - 2.0*cos_ab*z_35;
    D[178] = -z_42;
    D[179] = sin_af;
    D[180] = -sin_ag;
    const double theta_dot = v[0];
    const double z_43 = theta_dot*m;
    D[192] = -cos_theta*z_43;
    const double aj_dot = v[1];
    const double z_44 = aj_dot*j;
    D[193] = -cos_aj*z_44;
    const double ab_dot = v[2];
    const double z_45 = ab_dot*b;
    D[194] = cos_ab*z_45;
    D[199] = -m*sin_theta;
    D[200] = -j*sin_aj;
    D[201] = b*sin_ab;
    D[207] = ab_dot*sin_ab;
    D[215] = -aj_dot*sin_aj;
    D[218] = -theta_dot*sin_theta;
    D[224] = -sin_theta*z_43;
    D[225] = -sin_aj*z_44;
    D[226] = sin_ab*z_45;
    D[231] = m*cos_theta;
    D[232] = j*cos_aj;
    D[233] = -b*cos_ab;
    D[239] = -ab_dot*cos_ab;
    D[247] = aj_dot*cos_aj;
    D[250] = theta_dot*cos_theta;
    D[256] = -cos_theta*z_43;
    const double ak_dot = v[3];
    const double z_46 = ak_dot*k;
    D[259] = -cos_ak*z_46;
    const double ac_dot = v[4];
    const double z_47 = ac_dot*c_;
    D[260] = cos_ac*z_47;
    D[263] = -m*sin_theta;
    D[266] = -k*sin_ak;
    D[267] = c_*sin_ac;
    D[272] = ac_dot*sin_ac;
    D[280] = -ak_dot*sin_ak;
    D[282] = -theta_dot*sin_theta;
    D[288] = -sin_theta*z_43;
    D[291] = -sin_ak*z_46;
    D[292] = sin_ac*z_47;
    D[295] = m*cos_theta;
    D[298] = k*cos_ak;
    D[299] = -c_*cos_ac;
    D[304] = -ac_dot*cos_ac;
    D[312] = ak_dot*cos_ak;
    D[314] = theta_dot*cos_theta;
    D[322] = (-0.5)*(ab_dot*z_39);
    D[324] = cos_ac*z_47;
    const double af_dot = v[5];
    const double z_48 = af_dot*f;
    D[325] = -cos_af*z_48;
    const double ag_dot = v[6];
    const double z_49 = ag_dot*g;
    D[326] = cos_ag*z_49;
    D[329] = (-0.5)*z_22;
    D[331] = c_*sin_ac;
    D[332] = -f*sin_af;
    D[333] = g*sin_ag;
    D[335] = (-0.5)*(ab_dot*z_40);
    D[336] = ac_dot*sin_ac;
    D[337] = -ab_dot*z_41;
    D[338] = ab_dot*z_42;
    D[339] = -af_dot*sin_af;
    D[340] = ag_dot*sin_ag;
    D[354] = (-0.5)*(ab_dot*z_22);
    D[356] = sin_ac*z_47;
    D[357] = -sin_af*z_48;
    D[358] = sin_ag*z_49;
    D[361] = 0.5*z_39;
    D[363] = -c_*cos_ac;
    D[364] = f*cos_af;
    D[365] = -g*cos_ag;
    D[367] = 0.5*(ab_dot*z_30);
    D[368] = -ac_dot*cos_ac;
    D[369] = ab_dot*z_34;
    D[370] = -ab_dot*z_36;
    D[371] = af_dot*cos_af;
    D[372] = -ag_dot*cos_ag;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes jansen_lanes;
EM_WEAK em_lanes jansen_lanes = {0, NULL, NULL, NULL, 0, 0, 0};
EM_ACROSS const em_lanes *lanes_here(void) { return &jansen_lanes; }

#include "em_blocks.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 14, 63, 0, 49 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

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
    const double z_10 = 4.0 - z_6*z_6/(z_1*z_5);
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
    const double z_29 = 1.0/(1.0439356584272999*z_15 + 1.9779122466912002*z_28);
    const double z_30 = z_0*z_16 + z_0*z_29;
    prepared[17] = (2.0/3.0)*z_30; /* c_0 */
    const double z_31 = m*z_16;
    const double z_32 = j*z_31;
    prepared[18] = z_32; /* c_1 */
    const double z_33 = z_16*(j*j);
    prepared[19] = (2.0/3.0)*z_33; /* c_2 */
    const double z_34 = m*j*z_2;
    prepared[20] = z_34; /* c_3 */
    prepared[21] = z_34 - 2.0*b*z_31; /* c_4 */
    const double z_35 = j*z_16;
    const double z_36 = b*z_35;
    prepared[22] = z_36; /* c_5 */
    prepared[23] = z_9; /* c_6 */
    const double z_37 = d*sqrt(0.25*z_10);
    prepared[24] = 2.0*z_37; /* c_7 */
    const double z_38 = 0.9799867889375745*z_9 + 0.39812507335168834*z_37;
    const double z_39 = 0.7809576093147158*z_9 - 1.2491680630778932*z_37;
    const double z_40 = g*g;
    const double z_41 = i*i;
    const double z_42 = z_40 + z_41 - h*h;
    const double z_43 = z_42/g;
    const double z_44 = 4.0 - z_42*z_42/(z_40*z_41);
    const double z_45 = g*(4.0*g*z_25 + z_22*z_43) + (z_19*h + z_23*z_43)*z_43 + z_23*z_44*z_41;
    const double z_46 = 1.0/(1.9779122466912002*z_28 + z_12*(z_38*z_38) + z_12*(z_39*z_39) +
        0.7654631453230909*z_40/z_45);
    prepared[25] = z_46; /* c_8 */
    prepared[26] = 4.0*(z_1*z_16); /* c_9 */
    const double z_47 = m*z_29;
    const double z_48 = k*z_47;
    prepared[27] = z_48; /* c_10 */
    const double z_49 = z_29*(k*k);
    prepared[28] = (2.0/3.0)*z_49; /* c_11 */
    const double z_50 = m*k*z_18;
    prepared[29] = z_50; /* c_12 */
    prepared[30] = z_50 - 2.0*c_*z_47; /* c_13 */
    const double z_51 = f*z_18;
    prepared[31] = z_51; /* c_14 */
    const double z_52 = c_*z_46;
    prepared[32] = z_51 - 2.0*z_52; /* c_15 */
    const double z_53 = k*z_29;
    const double z_54 = c_*z_53;
    prepared[33] = z_54; /* c_16 */
    const double z_55 = z_17*z_29 + z_17*z_46;
    prepared[34] = (2.0/3.0)*z_55; /* c_17 */
    const double z_56 = f*z_46;
    prepared[35] = z_56; /* c_18 */
    const double z_57 = f*z_52;
    prepared[36] = z_57; /* c_19 */
    const double z_58 = z_46*(f*f);
    prepared[37] = (2.0/3.0)*z_58; /* c_20 */
    const double z_59 = f*z_19;
    prepared[38] = z_59; /* c_21 */
    const double z_60 = g*z_46;
    prepared[39] = z_59 - 2.0*z_60; /* c_22 */
    const double z_61 = z_21 + 2.0*z_24;
    const double z_62 = 2.0*g*(z_21 + 2.0*z_26) + z_61*z_43;
    prepared[40] = z_62; /* c_23 */
    const double z_63 = i*sqrt(0.25*z_44);
    const double z_64 = z_61*z_63;
    prepared[41] = z_64; /* c_24 */
    prepared[42] = z_62 + 4.0*g*z_52; /* c_25 */
    const double z_65 = g*z_56;
    prepared[43] = z_65; /* c_26 */
    const double z_66 = z_40*z_46;
    prepared[44] = (2.0/3.0)*z_66; /* c_27 */
    const double gravity = parameters[16];
    const double z_67 = density*gravity;
    const double z_68 = k*z_67;
    const double z_69 = j*z_67;
    prepared[45] = m*(z_68 + z_69); /* c_28 */
    const double torque = parameters[15];
    prepared[46] = 2.0*torque; /* c_29 */
    prepared[47] = z_31; /* c_30 */
    prepared[48] = z_47; /* c_31 */
    prepared[49] = (1.0/3.0)*z_35; /* c_32 */
    const double z_70 = 2.0*b + z_9;
    const double z_71 = e*z_67;
    const double z_72 = f*z_67;
    const double z_73 = z_72 + d*z_67;
    prepared[50] = z_70*z_71 + 2.0*b*(z_69 + b*z_67) + z_9*z_73; /* c_33 */
    prepared[51] = 2.0*(z_37*(z_71 + z_73)); /* c_34 */
    prepared[52] = 2.0*c_; /* c_35 */
    prepared[53] = 2.0*g; /* c_36 */
    prepared[54] = 2.0*f; /* c_37 */
    prepared[55] = 4.0*(b*z_16); /* c_38 */
    prepared[56] = (1.0/3.0)*z_53; /* c_39 */
    prepared[57] = 2.0*z_64; /* c_40 */
    const double z_74 = g*z_67;
    const double z_75 = i*z_67;
    const double z_76 = h*z_67;
    const double z_77 = z_75 + z_76;
    prepared[58] = 6.0*(c_*(z_68 + 2.0*z_74 + c_*z_67 + 2.0*z_77 + z_72)); /* c_41 */
    prepared[59] = z_52; /* c_42 */
    prepared[60] = 2.0*(c_*z_29); /* c_43 */
    prepared[61] = (1.0/6.0)*z_56; /* c_44 */
    const double z_78 = 2.0*g + z_43;
    prepared[62] = z_43*z_75 + z_78*z_76 + 2.0*g*(z_74 + z_72); /* c_45 */
    prepared[63] = 2.0*(z_63*z_77); /* c_46 */
    prepared[64] = 2.0*z_60; /* c_47 */
    prepared[65] = (1.0/3.0)*z_14; /* c_48 */
    prepared[66] = (1.0/12.0)*z_11; /* c_49 */
    prepared[67] = (1.0/6.0)*z_27; /* c_50 */
    prepared[68] = (1.0/12.0)*z_45; /* c_51 */
    prepared[69] = fabs(j); /* c_52 */
    prepared[70] = fabs(b); /* c_53 */
    prepared[71] = fabs(m); /* c_54 */
    const double a_ = parameters[0];
    prepared[72] = fabs(a_); /* c_55 */
    const double l = parameters[11];
    prepared[73] = fabs(l); /* c_56 */
    prepared[74] = fabs(k); /* c_57 */
    const double z_79 = fabs(c_);
    prepared[75] = z_79; /* c_58 */
    prepared[76] = fabs(z_9); /* c_59 */
    prepared[77] = 2.0*z_79; /* c_60 */
    prepared[78] = 2.0*fabs(z_37); /* c_61 */
    prepared[79] = 2.0*fabs(f); /* c_62 */
    prepared[80] = 2.0*fabs(g); /* c_63 */
    prepared[81] = 2.0*z_14; /* c_64 */
    prepared[82] = z_11; /* c_65 */
    prepared[83] = 2.0*z_27; /* c_66 */
    prepared[84] = z_45; /* c_67 */
    prepared[85] = (-4.0)*l; /* c_68 */
    prepared[86] = z_70; /* c_69 */
    prepared[87] = z_78; /* c_70 */
    prepared[88] = 2.0*z_63; /* c_71 */
    prepared[89] = 4.0*c_; /* c_72 */
    prepared[90] = z_43; /* c_73 */
    prepared[91] = 2.0*b; /* c_74 */
    prepared[92] = (-2.0)*l; /* c_75 */
    prepared[93] = 2.0*j; /* c_76 */
    prepared[94] = 2.0*k; /* c_77 */
    prepared[95] = z_67; /* c_78 */
    prepared[96] = 4.0*torque; /* c_79 */
    prepared[97] = z_14; /* c_80 */
    prepared[98] = z_30; /* c_81 */
    prepared[99] = (1.0/3.0)*z_32; /* c_82 */
    prepared[100] = (1.0/3.0)*z_33; /* c_83 */
    prepared[101] = (1.0/3.0)*z_36; /* c_84 */
    prepared[102] = (1.0/3.0)*z_48; /* c_85 */
    prepared[103] = (1.0/3.0)*z_49; /* c_86 */
    prepared[104] = (1.0/3.0)*z_54; /* c_87 */
    prepared[105] = z_27; /* c_88 */
    prepared[106] = 2.0*z_55; /* c_89 */
    prepared[107] = (1.0/3.0)*z_57; /* c_90 */
    prepared[108] = (1.0/3.0)*z_58; /* c_91 */
    prepared[109] = (1.0/3.0)*z_65; /* c_92 */
    prepared[110] = 4.0*z_66; /* c_93 */
    prepared[111] = -a_; /* c_94 */
    prepared[112] = -l; /* c_95 */
    prepared[113] = (-2.0)*a_; /* c_96 */
    prepared[114] = (1.0/10.0)*m; /* c_97 */
}

/* What depends on parameters only, once per parameter set: c (N_PREPARED). */
EM_ACROSS int prepare(const double *parameters, double *c, em_fault *fault)
{
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    prepared_constants(parameters, c);
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_ACROSS void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
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
EM_ACROSS void factored_matrix(double t, const double *restrict x, const double *restrict c,
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

/* What is factored: motion_bias and its partial derivatives go with it */
EM_ACROSS void factored(double t, const double *x, const double *c, double *M)
{
    factored_matrix(t, x, c, M);
}

/* A (m, n), b (m): A xdot + b = 0                                                                               (8) */
EM_ACROSS void pfaffian(double t, const double *restrict x, const double *restrict c, double *restrict A,
                        double *restrict b)
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
EM_ACROSS void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
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
EM_ACROSS void model_events(double t, const double *restrict x, const double *restrict v,
                            const double *restrict c, const double *restrict u, double *restrict crossing)
{
}

#endif
#if !EM_ALONE(EM_ASIDE)
#include "em_mechanics.h"
#endif
#if EM_HOLDS(EM_DERIVATIVES)
#include "em_tangent.h"
#endif
#if EM_HOLDS(EM_MODEL)

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
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[16];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 63);
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double v[N];
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, v);
        double Mdot1[N1][N1];
        settled_rates(v, c, shared, Mdot1);
        double time = em_time_of_block(&block1, Mdot1[0], y);
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

        /* Delta = B B^T (43), Delta lambda = B a (46), in one loop */
        real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
        for (int row = 0; row < N_ROWS; ++row) {
            lambda[row] = b[row];
            em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
            for (int column = 0; column <= row; ++column) {
                Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            }
        }
        if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;
        em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
        em_put(&block1, a1, y + N);
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

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "jansen.h"

static const char *const coordinate_names[] = { "theta", "aj", "ab", "ak", "ac", "af", "ag", NULL };
static const char *const parameter_names[] = { "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m",
    "density", "J", "torque", "gravity", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 0.38, 0.415, 0.393, 0.401, 0.558, 0.394, 0.367, 0.657, 0.49, 0.5, 0.619,
    0.078, 0.15, 1.0, 0.02, 1.2, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.5, 2.602262465075601, 1.3703951072340697, 4.107268260719168, -1.1528510374935115,
    -1.0331924236898824, 2.791190455017301 };
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
    .motion_jacobian = em_motion_jacobian,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .motion_along = em_motion_along,
    .tangent = em_tangent,
    .constraint_partials = constraint_partials,
    .simulate = em_simulate,
    .interpolate = em_interpolate,
    .release = em_release,
    .open = em_handle_open,
    .advance = em_handle_advance,
    .now = em_handle_now,
    .publish = em_handle_publish,
    .saved = em_handle_saved,
    .save = em_handle_save,
    .restore = em_handle_restore,
    .close = em_handle_close,
    .again = em_handle_again,
    .event = model_events,
    .factored_matrix = factored_matrix,
    .factored_gradient = factored_gradient,
    .lanes = &jansen_lanes,
    .enter = em_member_enter,
    .board = em_member_board,
    .look = em_member_look,
    .n_shapes = 16,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
};

#endif
#endif
