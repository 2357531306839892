/* eigenmotion generate jansen.py */
/* input sha256:ed5b383ebca52d6aef31c433b70cfaa858804fff4d43e6ad6bba3b16ee634350 */
/* body sha256:f4e6c1c9164e672a8d7210af4c313ec910bde508d0fed8eaa18fe36fe563c512 */
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
 *   M^-1: M is singular; M + A^T W A is factored, with weights W of rows 0, 1, 2, 3, 4, 5
 *
 * Operations of the straight-line part:
 *   eigenfactor: 111 additions, 286 multiplications, 14 function calls
 *   triangular root: 138 additions, 385 multiplications, 14 function calls
 *   projection: 73 additions, 252 multiplications, 14 function calls
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
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 17,
    N_PREPARED = 137,     /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 18,         /* inputs, parameters and the time */
    N_ARGUMENTS = 32,     /* x, v and these: what motion depends on */
    N1 = 7,               /* theta, aj, ab, ak, ac, af, ag */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4, 5, 6 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real c_47 = c[64];
    const real theta = x[0];
    const real sin_theta = em_sin(theta);
    const real theta_dot = v[0];
    const real cos_theta = em_cos(theta);
    const real z_2 = theta_dot*cos_theta;
    Mdot1[0][0] = -c_47*(sin_theta*z_2);
    const real c_3 = c[20];
    const real aj = x[1];
    const real cos_aj = em_cos(aj);
    const real z_4 = theta_dot*sin_theta;
    const real aj_dot = v[1];
    const real sin_aj = em_sin(aj);
    const real z_6 = aj_dot*sin_aj;
    const real c_4 = c[21];
    const real z_7 = aj_dot*cos_aj;
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/3.0))*(c_3*(cos_aj*z_4 + cos_theta*z_6) - c_4*(sin_aj*z_2 +
        sin_theta*z_7));
    const real c_48 = c[65];
    Mdot1[1][1] = -c_48*(sin_aj*z_7);
    const real c_7 = c[24];
    const real ab_dot = v[2];
    const real ab = x[2];
    const real sin_ab = em_sin(ab);
    const real z_9 = ab_dot*sin_ab;
    const real cos_ab = em_cos(ab);
    const real c_8 = c[25];
    const real z_11 = ab_dot*cos_ab;
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/6.0))*(c_7*(cos_theta*z_9 + cos_ab*z_4) - c_8*(sin_theta*z_11 +
        sin_ab*z_2));
    const real c_9 = c[26];
    const real c_10 = c[27];
    Mdot1[1][2] = Mdot1[2][1] = (1.0/3.0)*(c_9*(cos_aj*z_9 + cos_ab*z_6) - c_10*(sin_aj*z_11 + sin_ab*z_7));
    const real c_13 = c[30];
    const real c_14 = c[31];
    const real z_12 = cos_ab*c_13 - sin_ab*c_14;
    const real c_12 = c[29];
    const real z_13 = c_13*z_9 + c_14*z_11;
    const real z_14 = c_12*z_13;
    const real z_15 = sin_ab*c_13 + cos_ab*c_14;
    const real c_15 = c[32];
    const real z_16 = c_13*z_11 - c_14*z_9;
    const real z_17 = c_15*z_16;
    const real c_49 = c[66];
    Mdot1[2][2] = ((-1.0/6.0))*(z_12*z_14 + c_49*(sin_ab*z_11) - z_15*z_17);
    const real c_18 = c[35];
    const real ak = x[3];
    const real cos_ak = em_cos(ak);
    const real ak_dot = v[3];
    const real sin_ak = em_sin(ak);
    const real z_20 = ak_dot*sin_ak;
    const real c_19 = c[36];
    const real z_21 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/3.0))*(c_18*(cos_ak*z_4 + cos_theta*z_20) - c_19*(sin_ak*z_2 +
        sin_theta*z_21));
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    const real c_50 = c[67];
    Mdot1[3][3] = -c_50*(sin_ak*z_21);
    const real c_22 = c[39];
    const real ac = x[4];
    const real cos_ac = em_cos(ac);
    const real ac_dot = v[4];
    const real sin_ac = em_sin(ac);
    const real z_24 = ac_dot*sin_ac;
    const real c_23 = c[40];
    const real z_25 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_22*(cos_ac*z_4 + cos_theta*z_24) - c_23*(sin_ac*z_2 +
        sin_theta*z_25));
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_24 = c[41];
    const real c_25 = c[42];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_24*(z_12*z_24 + cos_ac*z_13) - c_25*(z_15*z_25 + sin_ac*z_16));
    const real c_26 = c[43];
    const real c_27 = c[44];
    Mdot1[3][4] = Mdot1[4][3] = (1.0/3.0)*(c_26*(cos_ak*z_24 + cos_ac*z_20) - c_27*(sin_ak*z_25 + sin_ac*z_21));
    const real c_51 = c[68];
    Mdot1[4][4] = -c_51*(sin_ac*z_25);
    Mdot1[0][5] = Mdot1[5][0] = em_real(0.0);
    Mdot1[1][5] = Mdot1[5][1] = em_real(0.0);
    const real c_31 = c[48];
    const real af = x[5];
    const real sin_af = em_sin(af);
    const real af_dot = v[5];
    const real cos_af = em_cos(af);
    const real z_28 = af_dot*cos_af;
    const real c_32 = c[49];
    const real z_29 = af_dot*sin_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_31*(sin_af*z_16 + z_15*z_28) - c_32*(cos_af*z_13 + z_12*z_29));
    Mdot1[3][5] = Mdot1[5][3] = em_real(0.0);
    const real c_33 = c[50];
    const real c_34 = c[51];
    Mdot1[4][5] = Mdot1[5][4] = (1.0/3.0)*(c_33*(cos_af*z_24 + cos_ac*z_29) - c_34*(sin_af*z_25 + sin_ac*z_28));
    const real c_52 = c[69];
    Mdot1[5][5] = -c_52*(cos_af*z_29);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real c_37 = c[54];
    const real ag = x[6];
    const real cos_ag = em_cos(ag);
    const real ag_dot = v[6];
    const real sin_ag = em_sin(ag);
    const real z_32 = ag_dot*sin_ag;
    const real c_38 = c[55];
    const real z_33 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_37*(cos_ag*z_13 + z_12*z_32) - c_38*(sin_ag*z_16 + z_15*z_33));
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    const real c_53 = c[70];
    const real c_39 = c[56];
    const real c_40 = c[57];
    Mdot1[4][6] = Mdot1[6][4] = (1.0/12.0)*(2.0*c_53*(sin_ag*z_24 - cos_ac*z_33) + 2.0*c_53*(cos_ag*z_25 -
        sin_ac*z_32) + c_40*(sin_ag*z_25 + sin_ac*z_33) - c_39*(cos_ag*z_24 + cos_ac*z_32));
    const real c_42 = c[59];
    const real c_43 = c[60];
    Mdot1[5][6] = Mdot1[6][5] = (1.0/3.0)*(c_42*(cos_af*z_32 + cos_ag*z_29) - c_43*(sin_af*z_33 + sin_ag*z_28));
    const real c_54 = c[71];
    Mdot1[6][6] = -c_54*(sin_ag*z_33);
    const real c_55 = c[72];
    const real z_34 = theta_dot*ab_dot*(c_55*(cos_ab*sin_theta - cos_theta*sin_ab));
    const real c_56 = c[73];
    const real z_35 = theta_dot*ac_dot*(c_56*(sin_theta*cos_ac - cos_theta*sin_ac));
    const real c_57 = c[74];
    const real c_58 = c[75];
    const real m = c[12];
    const real z_36 = m*z_4;
    const real j = c[9];
    const real b = c[1];
    const real z_37 = z_36 + j*z_6 - b*z_9;
    const real c_59 = c[76];
    const real z_38 = m*z_2;
    const real z_39 = z_38 + j*z_7 - b*z_11;
    const real c_60 = c[77];
    const real c_ = c[2];
    const real k = c[10];
    const real z_40 = c_*z_24 - z_36 - k*z_20;
    const real c_61 = c[78];
    const real z_41 = c_*z_25 - z_38 - k*z_21;
    const real c_62 = c[79];
    f1[0] = ((-1.0/6.0))*(((z_34 + z_35) - 3.0*(c_58 - cos_theta*c_57)) - 2.0*(z_37*c_59*z_2 + z_41*c_62*z_4 -
        z_39*c_60*z_4 - z_40*c_61*z_2));
    const real c_63 = c[80];
    const real c_64 = c[81];
    f1[1] = (1.0/3.0)*(z_37*c_63*z_7 - z_39*c_64*z_6);
    const real c_65 = c[82];
    const real z_42 = ab_dot*ac_dot*(c_65*(cos_ac*z_15 - sin_ac*z_12));
    const real c_66 = c[83];
    const real z_43 = ab_dot*ag_dot*(c_66*(z_15*cos_ag - z_12*sin_ag));
    const real c_67 = c[84];
    const real c_68 = c[85];
    const real c_69 = c[86];
    const real c_70 = c[87];
    const real c_71 = c[88];
    const real z_44 = c_69*z_24 + c_70*z_32 - ab_dot*z_15 - c_71*z_29;
    const real z_45 = c_69*z_25 + c_70*z_33 - ab_dot*z_12 - c_71*z_28;
    const real c_72 = c[89];
    const real c_73 = c[90];
    f1[2] = (1.0/12.0)*(((2.0*z_34 - z_42 - z_43) - 3.0*(cos_ab*c_67 - sin_ab*c_68)) - (z_44*z_17 +
        c_72*(z_37*z_11) - z_45*z_14 - c_73*(z_39*z_9)));
    const real c_74 = c[91];
    const real c_75 = c[92];
    f1[3] = ((-1.0/3.0))*(z_40*c_74*z_21 - z_41*c_75*z_20);
    const real c_76 = c[93];
    const real c_41 = c[58];
    const real z_46 = ac_dot*ag_dot*(sin_ac*cos_ag*c_76 - cos_ac*sin_ag*c_76 - c_41*(sin_ac*sin_ag) -
        c_41*(cos_ac*cos_ag));
    const real c_77 = c[94];
    const real c_78 = c[95];
    const real c_79 = c[96];
    const real c_80 = c[97];
    const real c_81 = c[98];
    f1[4] = (1.0/12.0)*(((2.0*z_35 + z_42 - z_46) - cos_ac*c_77) + 2.0*(c_78*z_44*z_25 + c_80*(z_40*z_25) -
        c_79*z_45*z_24 - c_81*(z_41*z_24)));
    f1[5] = ((-1.0/6.0))*(c_31*z_44*z_28 - c_32*z_45*z_29);
    const real c_82 = c[99];
    const real c_83 = c[100];
    const real c_84 = c[101];
    const real c_85 = c[102];
    f1[6] = (1.0/12.0)*(((z_43 + z_46) - 3.0*(cos_ag*c_82 - sin_ag*c_83)) + 2.0*(c_84*z_44*z_33 -
        c_85*z_45*z_32));
    const real z_47 = m*sin_theta;
    A1[0][0] = -z_47;
    const real z_48 = j*sin_aj;
    A1[0][1] = -z_48;
    const real z_49 = b*sin_ab;
    A1[0][2] = z_49;
    A1[0][3] = em_real(0.0);
    A1[0][4] = em_real(0.0);
    A1[0][5] = em_real(0.0);
    A1[0][6] = em_real(0.0);
    const real z_50 = m*cos_theta;
    A1[1][0] = z_50;
    const real z_51 = j*cos_aj;
    A1[1][1] = z_51;
    const real z_52 = b*cos_ab;
    A1[1][2] = -z_52;
    A1[1][3] = em_real(0.0);
    A1[1][4] = em_real(0.0);
    A1[1][5] = em_real(0.0);
    A1[1][6] = em_real(0.0);
    A1[2][0] = -z_47;
    A1[2][1] = em_real(0.0);
    A1[2][2] = em_real(0.0);
    const real z_53 = k*sin_ak;
    A1[2][3] = -z_53;
    const real z_54 = c_*sin_ac;
    A1[2][4] = z_54;
    A1[2][5] = em_real(0.0);
    A1[2][6] = em_real(0.0);
    A1[3][0] = z_50;
    A1[3][1] = em_real(0.0);
    A1[3][2] = em_real(0.0);
    const real z_55 = k*cos_ak;
    A1[3][3] = z_55;
    const real z_56 = c_*cos_ac;
    A1[3][4] = -z_56;
    A1[3][5] = em_real(0.0);
    A1[3][6] = em_real(0.0);
    A1[4][0] = em_real(0.0);
    A1[4][1] = em_real(0.0);
    A1[4][2] = (-0.5)*z_15;
    A1[4][3] = em_real(0.0);
    A1[4][4] = z_54;
    const real f = c[5];
    A1[4][5] = -f*sin_af;
    const real g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = em_real(0.0);
    A1[5][1] = em_real(0.0);
    A1[5][2] = 0.5*z_12;
    A1[5][3] = em_real(0.0);
    A1[5][4] = -z_56;
    A1[5][5] = f*cos_af;
    A1[5][6] = -g*cos_ag;
    const real z_57 = theta_dot*theta_dot;
    const real z_58 = z_50*z_57;
    const real z_59 = aj_dot*aj_dot;
    const real z_60 = ab_dot*ab_dot;
    gamma[0] = -(z_58 + z_51*z_59 - z_52*z_60);
    const real z_61 = z_47*z_57;
    gamma[1] = -(z_61 + z_48*z_59 - z_49*z_60);
    const real z_62 = ak_dot*ak_dot;
    const real z_63 = ac_dot*ac_dot;
    gamma[2] = -(z_58 + z_55*z_62 - z_56*z_63);
    gamma[3] = -(z_61 + z_53*z_62 - z_54*z_63);
    const real z_64 = c_69*z_63;
    const real z_65 = c_71*(af_dot*af_dot);
    const real z_66 = c_70*(ag_dot*ag_dot);
    gamma[4] = 0.5*(cos_ac*z_64 + cos_ag*z_66 - ab_dot*z_16 - cos_af*z_65);
    gamma[5] = 0.5*(sin_ac*z_64 + sin_ag*z_66 - ab_dot*z_13 - sin_af*z_65);
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
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 14, *const s1_dot = dy + 63;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a1[N1], q1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, q1);

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
                                 real shared[20])
{
    const real c_0 = c[17];
    const real c_1 = c[18];
    const real theta = x[0];
    const real cos_theta = em_cos(theta);
    const real c_2 = c[19];
    const real sin_theta = em_sin(theta);
    M1[0][0] = (1.0/3.0)*(c_0 + c_1*(cos_theta*cos_theta) + c_2*(sin_theta*sin_theta));
    const real aj = x[1];
    const real cos_aj = em_cos(aj);
    const real c_3 = c[20];
    const real sin_aj = em_sin(aj);
    const real c_4 = c[21];
    M1[1][0] = (1.0/3.0)*(cos_aj*(cos_theta*c_3) + sin_aj*(sin_theta*c_4));
    const real c_5 = c[22];
    const real c_6 = c[23];
    M1[1][1] = (1.0/3.0)*(c_5*(cos_aj*cos_aj) + c_6*(sin_aj*sin_aj));
    const real ab = x[2];
    const real cos_ab = em_cos(ab);
    const real c_7 = c[24];
    const real sin_ab = em_sin(ab);
    const real c_8 = c[25];
    M1[2][0] = (1.0/6.0)*(cos_theta*(cos_ab*c_7) + sin_theta*(sin_ab*c_8));
    const real c_9 = c[26];
    const real c_10 = c[27];
    M1[2][1] = ((-1.0/3.0))*(cos_aj*(cos_ab*c_9) + sin_aj*(sin_ab*c_10));
    const real c_11 = c[28];
    const real c_12 = c[29];
    const real c_13 = c[30];
    const real c_14 = c[31];
    const real z_6 = cos_ab*c_13 - sin_ab*c_14;
    const real c_15 = c[32];
    const real z_7 = sin_ab*c_13 + cos_ab*c_14;
    const real c_16 = c[33];
    const real c_17 = c[34];
    M1[2][2] = (1.0/12.0)*(c_11 + c_12*(z_6*z_6) + c_15*(z_7*z_7) + c_16*(cos_ab*cos_ab) + c_17*(sin_ab*sin_ab));
    const real ak = x[3];
    const real cos_ak = em_cos(ak);
    const real c_18 = c[35];
    const real sin_ak = em_sin(ak);
    const real c_19 = c[36];
    M1[3][0] = (1.0/3.0)*(cos_ak*(cos_theta*c_18) + sin_ak*(sin_theta*c_19));
    M1[3][1] = em_real(0.0);
    M1[3][2] = em_real(0.0);
    const real c_20 = c[37];
    const real c_21 = c[38];
    M1[3][3] = (1.0/3.0)*(c_20*(cos_ak*cos_ak) + c_21*(sin_ak*sin_ak));
    const real ac = x[4];
    const real cos_ac = em_cos(ac);
    const real c_22 = c[39];
    const real sin_ac = em_sin(ac);
    const real c_23 = c[40];
    M1[4][0] = (1.0/6.0)*(cos_ac*(cos_theta*c_22) + sin_ac*(sin_theta*c_23));
    M1[4][1] = em_real(0.0);
    const real c_24 = c[41];
    const real c_25 = c[42];
    M1[4][2] = (1.0/12.0)*(z_6*(cos_ac*c_24) + z_7*(sin_ac*c_25));
    const real c_26 = c[43];
    const real c_27 = c[44];
    M1[4][3] = ((-1.0/3.0))*(cos_ak*(cos_ac*c_26) + sin_ak*(sin_ac*c_27));
    const real c_28 = c[45];
    const real c_29 = c[46];
    const real c_30 = c[47];
    M1[4][4] = (1.0/6.0)*(c_28 + c_29*(cos_ac*cos_ac) + c_30*(sin_ac*sin_ac));
    M1[5][0] = em_real(0.0);
    M1[5][1] = em_real(0.0);
    const real af = x[5];
    const real sin_af = em_sin(af);
    const real c_31 = c[48];
    const real cos_af = em_cos(af);
    const real c_32 = c[49];
    M1[5][2] = (1.0/6.0)*(sin_af*(z_7*c_31) + cos_af*(z_6*c_32));
    M1[5][3] = em_real(0.0);
    const real c_33 = c[50];
    const real c_34 = c[51];
    M1[5][4] = ((-1.0/3.0))*(cos_af*(cos_ac*c_33) + sin_af*(sin_ac*c_34));
    const real c_35 = c[52];
    const real c_36 = c[53];
    M1[5][5] = (1.0/3.0)*(c_35*(cos_af*cos_af) + c_36*(sin_af*sin_af));
    M1[6][0] = em_real(0.0);
    M1[6][1] = em_real(0.0);
    const real ag = x[6];
    const real cos_ag = em_cos(ag);
    const real c_37 = c[54];
    const real sin_ag = em_sin(ag);
    const real c_38 = c[55];
    M1[6][2] = (1.0/12.0)*(cos_ag*(z_6*c_37) + sin_ag*(z_7*c_38));
    M1[6][3] = em_real(0.0);
    const real c_39 = c[56];
    const real z_16 = cos_ac*cos_ag;
    const real c_40 = c[57];
    const real z_17 = sin_ac*sin_ag;
    const real c_41 = c[58];
    const real z_18 = cos_ac*sin_ag;
    const real z_19 = sin_ac*cos_ag;
    M1[6][4] = ((-1.0/12.0))*(c_41*z_18 - c_39*z_16 - c_40*z_17 - c_41*z_19);
    const real c_42 = c[59];
    const real c_43 = c[60];
    M1[6][5] = ((-1.0/3.0))*(cos_af*(cos_ag*c_42) + sin_af*(sin_ag*c_43));
    const real c_44 = c[61];
    const real c_45 = c[62];
    const real c_46 = c[63];
    M1[6][6] = (1.0/12.0)*(c_44 + c_45*(cos_ag*cos_ag) + c_46*(sin_ag*sin_ag));
    shared[0] = sin_theta;
    shared[1] = cos_theta;
    shared[2] = cos_aj;
    shared[3] = sin_aj;
    shared[4] = sin_ab;
    shared[5] = cos_ab;
    shared[6] = z_6;
    shared[7] = z_7;
    shared[8] = cos_ak;
    shared[9] = sin_ak;
    shared[10] = cos_ac;
    shared[11] = sin_ac;
    shared[12] = sin_af;
    shared[13] = cos_af;
    shared[14] = cos_ag;
    shared[15] = sin_ag;
    shared[16] = z_19;
    shared[17] = z_18;
    shared[18] = z_17;
    shared[19] = z_16;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[20],
                                 real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real c_47 = c[64];
    const real sin_theta = shared[0];
    const real theta_dot = v[0];
    const real cos_theta = shared[1];
    const real z_20 = theta_dot*cos_theta;
    Mdot1[0][0] = -c_47*(sin_theta*z_20);
    const real c_3 = c[20];
    const real cos_aj = shared[2];
    const real z_21 = theta_dot*sin_theta;
    const real aj_dot = v[1];
    const real sin_aj = shared[3];
    const real z_22 = aj_dot*sin_aj;
    const real c_4 = c[21];
    const real z_23 = aj_dot*cos_aj;
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/3.0))*(c_3*(cos_aj*z_21 + cos_theta*z_22) - c_4*(sin_aj*z_20 +
        sin_theta*z_23));
    const real c_48 = c[65];
    Mdot1[1][1] = -c_48*(sin_aj*z_23);
    const real c_7 = c[24];
    const real ab_dot = v[2];
    const real sin_ab = shared[4];
    const real z_24 = ab_dot*sin_ab;
    const real cos_ab = shared[5];
    const real c_8 = c[25];
    const real z_25 = ab_dot*cos_ab;
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/6.0))*(c_7*(cos_theta*z_24 + cos_ab*z_21) - c_8*(sin_theta*z_25 +
        sin_ab*z_20));
    const real c_9 = c[26];
    const real c_10 = c[27];
    Mdot1[1][2] = Mdot1[2][1] = (1.0/3.0)*(c_9*(cos_aj*z_24 + cos_ab*z_22) - c_10*(sin_aj*z_25 + sin_ab*z_23));
    const real z_6 = shared[6];
    const real c_12 = c[29];
    const real c_13 = c[30];
    const real c_14 = c[31];
    const real z_26 = c_13*z_24 + c_14*z_25;
    const real z_27 = c_12*z_26;
    const real z_7 = shared[7];
    const real c_15 = c[32];
    const real z_28 = c_13*z_25 - c_14*z_24;
    const real z_29 = c_15*z_28;
    const real c_49 = c[66];
    Mdot1[2][2] = ((-1.0/6.0))*(z_6*z_27 + c_49*(sin_ab*z_25) - z_7*z_29);
    const real c_18 = c[35];
    const real cos_ak = shared[8];
    const real ak_dot = v[3];
    const real sin_ak = shared[9];
    const real z_30 = ak_dot*sin_ak;
    const real c_19 = c[36];
    const real z_31 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/3.0))*(c_18*(cos_ak*z_21 + cos_theta*z_30) - c_19*(sin_ak*z_20 +
        sin_theta*z_31));
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    const real c_50 = c[67];
    Mdot1[3][3] = -c_50*(sin_ak*z_31);
    const real c_22 = c[39];
    const real cos_ac = shared[10];
    const real ac_dot = v[4];
    const real sin_ac = shared[11];
    const real z_32 = ac_dot*sin_ac;
    const real c_23 = c[40];
    const real z_33 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_22*(cos_ac*z_21 + cos_theta*z_32) - c_23*(sin_ac*z_20 +
        sin_theta*z_33));
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_24 = c[41];
    const real c_25 = c[42];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_24*(z_6*z_32 + cos_ac*z_26) - c_25*(z_7*z_33 + sin_ac*z_28));
    const real c_26 = c[43];
    const real c_27 = c[44];
    Mdot1[3][4] = Mdot1[4][3] = (1.0/3.0)*(c_26*(cos_ak*z_32 + cos_ac*z_30) - c_27*(sin_ak*z_33 + sin_ac*z_31));
    const real c_51 = c[68];
    Mdot1[4][4] = -c_51*(sin_ac*z_33);
    Mdot1[0][5] = Mdot1[5][0] = em_real(0.0);
    Mdot1[1][5] = Mdot1[5][1] = em_real(0.0);
    const real c_31 = c[48];
    const real sin_af = shared[12];
    const real af_dot = v[5];
    const real cos_af = shared[13];
    const real z_34 = af_dot*cos_af;
    const real c_32 = c[49];
    const real z_35 = af_dot*sin_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_31*(sin_af*z_28 + z_7*z_34) - c_32*(cos_af*z_26 + z_6*z_35));
    Mdot1[3][5] = Mdot1[5][3] = em_real(0.0);
    const real c_33 = c[50];
    const real c_34 = c[51];
    Mdot1[4][5] = Mdot1[5][4] = (1.0/3.0)*(c_33*(cos_af*z_32 + cos_ac*z_35) - c_34*(sin_af*z_33 + sin_ac*z_34));
    const real c_52 = c[69];
    Mdot1[5][5] = -c_52*(cos_af*z_35);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real c_37 = c[54];
    const real cos_ag = shared[14];
    const real ag_dot = v[6];
    const real sin_ag = shared[15];
    const real z_36 = ag_dot*sin_ag;
    const real c_38 = c[55];
    const real z_37 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_37*(cos_ag*z_26 + z_6*z_36) - c_38*(sin_ag*z_28 + z_7*z_37));
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    const real c_53 = c[70];
    const real c_39 = c[56];
    const real c_40 = c[57];
    Mdot1[4][6] = Mdot1[6][4] = (1.0/12.0)*(2.0*c_53*(sin_ag*z_32 - cos_ac*z_37) + 2.0*c_53*(cos_ag*z_33 -
        sin_ac*z_36) + c_40*(sin_ag*z_33 + sin_ac*z_37) - c_39*(cos_ag*z_32 + cos_ac*z_36));
    const real c_42 = c[59];
    const real c_43 = c[60];
    Mdot1[5][6] = Mdot1[6][5] = (1.0/3.0)*(c_42*(cos_af*z_36 + cos_ag*z_35) - c_43*(sin_af*z_37 + sin_ag*z_34));
    const real c_54 = c[71];
    Mdot1[6][6] = -c_54*(sin_ag*z_37);
    const real c_55 = c[72];
    const real z_38 = theta_dot*ab_dot*(c_55*(cos_ab*sin_theta - cos_theta*sin_ab));
    const real c_56 = c[73];
    const real z_39 = theta_dot*ac_dot*(c_56*(sin_theta*cos_ac - cos_theta*sin_ac));
    const real c_57 = c[74];
    const real c_58 = c[75];
    const real m = c[12];
    const real z_40 = m*z_21;
    const real j = c[9];
    const real b = c[1];
    const real z_41 = z_40 + j*z_22 - b*z_24;
    const real c_59 = c[76];
    const real z_42 = m*z_20;
    const real z_43 = z_42 + j*z_23 - b*z_25;
    const real c_60 = c[77];
    const real c_ = c[2];
    const real k = c[10];
    const real z_44 = c_*z_32 - z_40 - k*z_30;
    const real c_61 = c[78];
    const real z_45 = c_*z_33 - z_42 - k*z_31;
    const real c_62 = c[79];
    f1[0] = ((-1.0/6.0))*(((z_38 + z_39) - 3.0*(c_58 - cos_theta*c_57)) - 2.0*(z_41*c_59*z_20 + z_45*c_62*z_21 -
        z_43*c_60*z_21 - z_44*c_61*z_20));
    const real c_63 = c[80];
    const real c_64 = c[81];
    f1[1] = (1.0/3.0)*(z_41*c_63*z_23 - z_43*c_64*z_22);
    const real c_65 = c[82];
    const real z_46 = ab_dot*ac_dot*(c_65*(cos_ac*z_7 - sin_ac*z_6));
    const real c_66 = c[83];
    const real z_47 = ab_dot*ag_dot*(c_66*(z_7*cos_ag - z_6*sin_ag));
    const real c_67 = c[84];
    const real c_68 = c[85];
    const real c_69 = c[86];
    const real c_70 = c[87];
    const real c_71 = c[88];
    const real z_48 = c_69*z_32 + c_70*z_36 - ab_dot*z_7 - c_71*z_35;
    const real z_49 = c_69*z_33 + c_70*z_37 - ab_dot*z_6 - c_71*z_34;
    const real c_72 = c[89];
    const real c_73 = c[90];
    f1[2] = (1.0/12.0)*(((2.0*z_38 - z_46 - z_47) - 3.0*(cos_ab*c_67 - sin_ab*c_68)) - (z_48*z_29 +
        c_72*(z_41*z_25) - z_49*z_27 - c_73*(z_43*z_24)));
    const real c_74 = c[91];
    const real c_75 = c[92];
    f1[3] = ((-1.0/3.0))*(z_44*c_74*z_31 - z_45*c_75*z_30);
    const real c_76 = c[93];
    const real z_19 = shared[16];
    const real z_18 = shared[17];
    const real c_41 = c[58];
    const real z_17 = shared[18];
    const real z_16 = shared[19];
    const real z_50 = ac_dot*ag_dot*(c_76*z_19 - c_76*z_18 - c_41*z_17 - c_41*z_16);
    const real c_77 = c[94];
    const real c_78 = c[95];
    const real c_79 = c[96];
    const real c_80 = c[97];
    const real c_81 = c[98];
    f1[4] = (1.0/12.0)*(((2.0*z_39 + z_46 - z_50) - cos_ac*c_77) + 2.0*(c_78*z_48*z_33 + c_80*(z_44*z_33) -
        c_79*z_49*z_32 - c_81*(z_45*z_32)));
    f1[5] = ((-1.0/6.0))*(c_31*z_48*z_34 - c_32*z_49*z_35);
    const real c_82 = c[99];
    const real c_83 = c[100];
    const real c_84 = c[101];
    const real c_85 = c[102];
    f1[6] = (1.0/12.0)*(((z_47 + z_50) - 3.0*(cos_ag*c_82 - sin_ag*c_83)) + 2.0*(c_84*z_48*z_37 -
        c_85*z_49*z_36));
    const real z_51 = m*sin_theta;
    A1[0][0] = -z_51;
    const real z_52 = j*sin_aj;
    A1[0][1] = -z_52;
    const real z_53 = b*sin_ab;
    A1[0][2] = z_53;
    A1[0][3] = em_real(0.0);
    A1[0][4] = em_real(0.0);
    A1[0][5] = em_real(0.0);
    A1[0][6] = em_real(0.0);
    const real z_54 = m*cos_theta;
    A1[1][0] = z_54;
    const real z_55 = j*cos_aj;
    A1[1][1] = z_55;
    const real z_56 = b*cos_ab;
    A1[1][2] = -z_56;
    A1[1][3] = em_real(0.0);
    A1[1][4] = em_real(0.0);
    A1[1][5] = em_real(0.0);
    A1[1][6] = em_real(0.0);
    A1[2][0] = -z_51;
    A1[2][1] = em_real(0.0);
    A1[2][2] = em_real(0.0);
    const real z_57 = k*sin_ak;
    A1[2][3] = -z_57;
    const real z_58 = c_*sin_ac;
    A1[2][4] = z_58;
    A1[2][5] = em_real(0.0);
    A1[2][6] = em_real(0.0);
    A1[3][0] = z_54;
    A1[3][1] = em_real(0.0);
    A1[3][2] = em_real(0.0);
    const real z_59 = k*cos_ak;
    A1[3][3] = z_59;
    const real z_60 = c_*cos_ac;
    A1[3][4] = -z_60;
    A1[3][5] = em_real(0.0);
    A1[3][6] = em_real(0.0);
    A1[4][0] = em_real(0.0);
    A1[4][1] = em_real(0.0);
    A1[4][2] = (-0.5)*z_7;
    A1[4][3] = em_real(0.0);
    A1[4][4] = z_58;
    const real f = c[5];
    A1[4][5] = -f*sin_af;
    const real g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = em_real(0.0);
    A1[5][1] = em_real(0.0);
    A1[5][2] = 0.5*z_6;
    A1[5][3] = em_real(0.0);
    A1[5][4] = -z_60;
    A1[5][5] = f*cos_af;
    A1[5][6] = -g*cos_ag;
    const real z_61 = theta_dot*theta_dot;
    const real z_62 = z_54*z_61;
    const real z_63 = aj_dot*aj_dot;
    const real z_64 = ab_dot*ab_dot;
    gamma[0] = -(z_62 + z_55*z_63 - z_56*z_64);
    const real z_65 = z_51*z_61;
    gamma[1] = -(z_65 + z_52*z_63 - z_53*z_64);
    const real z_66 = ak_dot*ak_dot;
    const real z_67 = ac_dot*ac_dot;
    gamma[2] = -(z_62 + z_59*z_66 - z_60*z_67);
    gamma[3] = -(z_65 + z_57*z_66 - z_58*z_67);
    const real z_68 = c_69*z_67;
    const real z_69 = c_71*(af_dot*af_dot);
    const real z_70 = c_70*(ag_dot*ag_dot);
    gamma[4] = 0.5*(cos_ac*z_68 + cos_ag*z_70 - ab_dot*z_28 - cos_af*z_69);
    gamma[5] = 0.5*(sin_ac*z_68 + sin_ag*z_70 - ab_dot*z_26 - sin_af*z_69);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[20];
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
    triangular_motion(dy, c, shared, Mdot1, f1, A1, gamma);

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

#ifdef EM_NODES_ALONE /* lanes for the nodes of one run, none for runs */
enum { EM_REMEMBERED = 0 };
#define em_flock_run NULL
#else
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
#endif

extern em_lanes jansen_lanes;
em_lanes jansen_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): (M + A^T W A) xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double theta_dot = v[0];
    const double ab_dot = v[2];
    const double c_55 = c[72];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double z_2 = cos_ab*sin_theta;
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double z_5 = cos_theta*sin_ab;
    const double z_6 = theta_dot*ab_dot*(c_55*(z_2 - z_5));
    const double ac_dot = v[4];
    const double c_56 = c[73];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_8 = sin_theta*cos_ac;
    const double sin_ac = em_sin(ac);
    const double z_10 = cos_theta*sin_ac;
    const double z_11 = theta_dot*ac_dot*(c_56*(z_8 - z_10));
    const double c_57 = c[74];
    const double c_58 = c[75];
    const double z_12 = c_55*(ab_dot*z_5 + theta_dot*z_2) - c_55*(ab_dot*z_2 + theta_dot*z_5);
    const double z_13 = ac_dot*sin_ac;
    const double z_14 = ac_dot*cos_ac;
    const double z_15 = c_56*(theta_dot*z_8 + cos_theta*z_13) - c_56*(theta_dot*z_10 + sin_theta*z_14);
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
    const double c_59 = c[76];
    const double z_22 = sin_theta*z_16;
    const double sin_aj = em_sin(aj);
    const double z_24 = z_22 + sin_aj*z_19 - sin_ab*z_20;
    const double c_60 = c[77];
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double k = c[10];
    const double ak_dot = v[3];
    const double z_26 = k*(ak_dot*ak_dot);
    const double c_ = c[2];
    const double z_27 = ac_dot*ac_dot;
    const double z_28 = c_*z_27;
    const double z_29 = z_17 + cos_ak*z_26 - cos_ac*z_28;
    const double c_61 = c[78];
    const double sin_ak = em_sin(ak);
    const double z_31 = z_22 + sin_ak*z_26 - sin_ac*z_28;
    const double c_62 = c[79];
    bias[0] = ((-1.0/6.0))*((((z_6 + z_11) - 3.0*(c_58 - cos_theta*c_57)) - (ab_dot*z_12 + ac_dot*z_15)) +
        2.0*(sin_theta*z_21*c_59 + sin_theta*z_29*c_61 - cos_theta*z_24*c_60 - cos_theta*z_31*c_62));
    const double c_63 = c[80];
    const double c_64 = c[81];
    bias[1] = ((-1.0/3.0))*(sin_aj*z_21*c_63 - cos_aj*z_24*c_64);
    const double c_65 = c[82];
    const double c_13 = c[30];
    const double c_14 = c[31];
    const double z_32 = sin_ab*c_13 + cos_ab*c_14;
    const double z_33 = cos_ab*c_13 - sin_ab*c_14;
    const double z_34 = ab_dot*ac_dot*(c_65*(cos_ac*z_32 - sin_ac*z_33));
    const double ag_dot = v[6];
    const double c_66 = c[83];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    const double z_37 = ab_dot*ag_dot*(c_66*(z_32*cos_ag - z_33*sin_ag));
    const double c_67 = c[84];
    const double c_68 = c[85];
    const double z_38 = ab_dot*sin_ab;
    const double z_39 = ab_dot*cos_ab;
    const double z_40 = c_13*z_38 + c_14*z_39;
    const double z_41 = c_13*z_39 - c_14*z_38;
    const double z_42 = c_65*(z_33*z_13 + cos_ac*z_40) - c_65*(z_32*z_14 + sin_ac*z_41);
    const double z_43 = ag_dot*sin_ag;
    const double z_44 = ag_dot*cos_ag;
    const double z_45 = c_66*(cos_ag*z_40 + z_33*z_43) - c_66*(sin_ag*z_41 + z_32*z_44);
    const double c_15 = c[32];
    const double c_69 = c[86];
    const double z_46 = c_69*z_27;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double c_71 = c[88];
    const double af_dot = v[5];
    const double z_48 = c_71*(af_dot*af_dot);
    const double c_70 = c[87];
    const double z_49 = c_70*(ag_dot*ag_dot);
    const double z_50 = cos_ac*z_46 + cos_ag*z_49 - ab_dot*z_41 - cos_af*z_48;
    const double c_12 = c[29];
    const double sin_af = em_sin(af);
    const double z_52 = sin_ac*z_46 + sin_ag*z_49 - ab_dot*z_40 - sin_af*z_48;
    const double c_72 = c[89];
    const double c_73 = c[90];
    bias[2] = (1.0/12.0)*((((2.0*z_6 - z_34 - z_37) - 3.0*(cos_ab*c_67 - sin_ab*c_68)) + (2.0*theta_dot*z_12 +
        ac_dot*z_42 + ag_dot*z_45)) + (z_32*c_15*z_50 + c_72*(sin_ab*z_21) - z_33*c_12*z_52 -
        c_73*(cos_ab*z_24)));
    const double c_74 = c[91];
    const double c_75 = c[92];
    bias[3] = ((-1.0/3.0))*(sin_ak*z_29*c_74 - cos_ak*z_31*c_75);
    const double c_76 = c[93];
    const double c_41 = c[58];
    const double z_53 = ac_dot*ag_dot*(cos_ag*(sin_ac*c_76) - sin_ag*(cos_ac*c_76) - c_41*(sin_ac*sin_ag) -
        c_41*(cos_ac*cos_ag));
    const double c_77 = c[94];
    const double c_53 = c[70];
    const double z_54 = 2.0*c_53*(sin_ag*z_13 - cos_ac*z_44) + 2.0*c_53*(cos_ag*z_14 - sin_ac*z_43) +
        c_76*(sin_ag*z_14 + sin_ac*z_44) - c_76*(cos_ag*z_13 + cos_ac*z_43);
    const double c_78 = c[95];
    const double c_79 = c[96];
    const double c_80 = c[97];
    const double c_81 = c[98];
    bias[4] = (1.0/12.0)*((((2.0*z_11 + z_34 - z_53) - cos_ac*c_77) + (2.0*theta_dot*z_15 + ab_dot*z_42 -
        ag_dot*z_54)) + 2.0*(cos_ac*c_79*z_52 + c_80*(sin_ac*z_29) - sin_ac*c_78*z_50 - c_81*(cos_ac*z_31)));
    const double c_31 = c[48];
    const double c_32 = c[49];
    bias[5] = (1.0/6.0)*(sin_af*c_31*z_50 - cos_af*c_32*z_52);
    const double c_82 = c[99];
    const double c_83 = c[100];
    const double c_84 = c[101];
    const double c_85 = c[102];
    bias[6] = (1.0/12.0)*((((z_37 + z_53) - 3.0*(cos_ag*c_82 - sin_ag*c_83)) + (ab_dot*z_45 - ac_dot*z_54)) -
        2.0*(sin_ag*c_84*z_50 - cos_ag*c_85*z_52));
    gamma[0] = -z_21;
    gamma[1] = -z_24;
    gamma[2] = -z_29;
    gamma[3] = -z_31;
    gamma[4] = 0.5*z_50;
    gamma[5] = 0.5*z_52;
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double theta_dot = v[0];
    const double ab_dot = v[2];
    const double c_55 = c[72];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double sin_theta = em_sin(theta);
    const double z_4 = c_55*(cos_ab*cos_theta + sin_ab*sin_theta);
    const double ac_dot = v[4];
    const double c_56 = c[73];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double sin_ac = em_sin(ac);
    const double z_7 = c_56*(cos_theta*cos_ac + sin_theta*sin_ac);
    const double c_102 = c[119];
    const double c_11 = c[28];
    const double c_65 = c[82];
    const double c_13 = c[30];
    const double c_14 = c[31];
    const double z_8 = cos_ab*c_13 - sin_ab*c_14;
    const double z_9 = cos_ab*c_14;
    const double z_10 = sin_ab*c_13 + z_9;
    const double z_11 = c_65*(cos_ac*z_8 + sin_ac*z_10);
    const double ag_dot = v[6];
    const double c_66 = c[83];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    const double z_14 = c_66*(z_8*cos_ag + z_10*sin_ag);
    const double c_76 = c[93];
    const double c_41 = c[58];
    const double z_15 = cos_ac*cos_ag*c_76 + sin_ac*sin_ag*c_76 + c_41*(sin_ac*cos_ag) - c_41*(cos_ac*sin_ag);
    const double c_103 = c[120];
    const double c_44 = c[61];
    e[0] = (1.0/24.0)*(2.0*theta_dot*(ab_dot*z_4 + ac_dot*z_7 + theta_dot*c_102) + ab_dot*(2.0*theta_dot*z_4 +
        ab_dot*c_11 + ac_dot*z_11 + ag_dot*z_14) + ac_dot*(2.0*theta_dot*z_7 + ab_dot*z_11 + ag_dot*z_15 +
        ac_dot*c_103) + ag_dot*(ab_dot*z_14 + ac_dot*z_15 + ag_dot*c_44));
    e[1] = 0.0;
    e[2] = 0.0;
    const double d = c[3];
    const double c_104 = c[121];
    const double z_16 = z_10 + c_104;
    const double e_ = c[4];
    const double c_105 = c[122];
    const double f = c[5];
    const double c_69 = c[86];
    const double z_17 = sin_ac*c_69;
    const double c_70 = c[87];
    const double h = c[7];
    const double c_106 = c[123];
    const double c_107 = c[124];
    const double c_108 = c[125];
    const double z_18 = cos_ag*c_107 + (c_104 + sin_ac*c_108);
    const double i = c[8];
    const double c_109 = c[126];
    const double c_110 = c[127];
    const double b = c[1];
    const double z_19 = b*sin_ab;
    const double c_111 = c[128];
    const double c_ = c[2];
    const double z_20 = c_*sin_ac;
    const double g = c[6];
    const double m = c[12];
    const double l = c[11];
    const double z_21 = m*sin_theta - l;
    const double c_112 = c[129];
    const double c_113 = c[130];
    const double c_114 = c[131];
    const double c_115 = c[132];
    e[3] = (-0.25)*(theta*c_115 - (d*z_16 + e_*(c_104 + sin_ab*c_105 + z_9) + f*(z_16 + z_17 + sin_ag*c_70) +
        h*(sin_ag*c_106 + z_18) + i*(sin_ag*c_109 + z_18) + c_110*(z_19 + c_111) + (z_20 + c_111)*c_69 +
        c_70*(g*sin_ag + c_111 + z_17) + (z_19 + z_21)*c_112 + (z_20 + z_21)*c_113)*c_114);
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
    const double c_116 = c[133];
    p[2] = p[18] = p[22] = p[30] = c_116;
    const double c_117 = c[134];
    p[3] = p[19] = p[23] = p[31] = c_117;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_109 = c[126];
    const double c_118 = c[135];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_69 = c[86];
    const double sin_ag = em_sin(ag);
    const double c_107 = c[124];
    p[4] = p[44] = p[48] = p[53] = 0.5*(cos_ag*c_109 + c_118 + cos_ac*c_69 - sin_ag*c_107);
    const double c_111 = c[128];
    const double sin_ac = em_sin(ac);
    p[5] = p[45] = p[49] = p[54] = 0.5*(sin_ag*c_109 + c_111 + sin_ac*c_69 + cos_ag*c_107);
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
    const double c_13 = c[30];
    const double c_14 = c[31];
    p[24] = p[28] = p[34] = 0.5*(cos_ab*c_13 + c_118 - sin_ab*c_14);
    p[25] = p[29] = p[35] = 0.5*(sin_ab*c_13 + c_111 + cos_ab*c_14);
    const double g = c[6];
    p[36] = p[40] = p[46] = g*cos_ag + z_8;
    p[37] = p[41] = p[47] = g*sin_ag + z_9;
    const double c_119 = c[136];
    p[52] = p[55] = c_119;
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
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double m = c[12];
    const double density = c[13];
    const double j = c[9];
    const double b = c[1];
    const double z_2 = m*density*(j*b);
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double z_5 = cos_ab*sin_theta*z_2 - cos_theta*sin_ab*z_2;
    dM[14] = dM[2] = ((-1.0/6.0))*z_5;
    const double k = c[10];
    const double z_6 = m*k;
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_ = c[2];
    const double z_8 = density*c_;
    const double z_9 = cos_ac*z_8;
    const double sin_ac = em_sin(ac);
    const double z_11 = sin_ac*z_8;
    const double z_12 = sin_theta*z_6*z_9 - cos_theta*z_6*z_11;
    dM[28] = dM[4] = ((-1.0/6.0))*z_12;
    dM[112] = dM[100] = (1.0/6.0)*z_5;
    const double f = c[5];
    const double z_13 = b*b;
    const double d = c[3];
    const double z_14 = d*d;
    const double e = c[4];
    const double z_15 = z_13 + z_14 - e*e;
    const double z_16 = z_15/b;
    const double z_17 = d*sqrt(0.25*(4.0 - z_15*z_15/(z_13*z_14)));
    const double z_18 = sin_ab*z_16 + 2.0*cos_ab*z_17;
    const double z_19 = cos_ab*z_16 - 2.0*sin_ab*z_17;
    const double z_20 = f*z_18*z_9 - f*z_19*z_11;
    dM[128] = dM[116] = ((-1.0/12.0))*z_20;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_22 = density*f;
    const double g = c[6];
    const double z_23 = z_22*g;
    const double sin_ag = em_sin(ag);
    const double z_25 = z_18*cos_ag*z_23 - z_19*sin_ag*z_23;
    dM[142] = dM[118] = ((-1.0/12.0))*z_25;
    dM[224] = dM[200] = (1.0/6.0)*z_12;
    dM[226] = dM[214] = (1.0/12.0)*z_20;
    const double h = c[7];
    const double z_26 = density*h;
    const double z_27 = h*z_8;
    const double z_28 = g*g;
    const double i = c[8];
    const double z_29 = i*i;
    const double z_30 = z_28 + z_29 - h*h;
    const double z_31 = 2.0*c_*(density*i + z_26) + i*z_8 + z_27;
    const double z_32 = 2.0*g*(2.0*c_*(z_22 + density*g + z_26) + g*z_8 + z_27) + z_30*z_31/g;
    const double z_33 = sqrt(0.25*(4.0 - z_30*z_30/(z_28*z_29)))*(i*z_31);
    const double z_34 = sin_ac*cos_ag*z_32 - cos_ac*sin_ag*z_32 - 2.0*sin_ac*sin_ag*z_33 - 2.0*cos_ac*cos_ag*z_33;
    dM[242] = dM[230] = ((-1.0/12.0))*z_34;
    dM[338] = dM[314] = (1.0/12.0)*z_25;
    dM[340] = dM[328] = (1.0/12.0)*z_34;
}

/* dM (n, n, n), of what is factored */
EM_RARE /* no step calls it */
EM_ACROSS void factored_gradient(double t, const double *restrict x, const double *restrict c,
                                 double *restrict dM)
{
    memset(dM, 0, sizeof *dM * N * N * N);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    const double m = c[12];
    const double z_2 = m*m;
    const double b = c[1];
    const double z_3 = b*b;
    const double density = c[13];
    const double z_4 = density*b;
    const double j = c[9];
    const double z_5 = density*j;
    const double e = c[4];
    const double z_6 = density*e;
    const double d = c[3];
    const double z_7 = d*d;
    const double z_8 = z_3 + z_7 - e*e;
    const double f = c[5];
    const double z_9 = density*f;
    const double z_10 = z_6 + density*d + z_9;
    const double z_11 = z_8/b;
    const double z_12 = 4.0 - z_8*z_8/(z_3*z_7);
    const double z_13 = 1.0/(4.0*z_3*z_4 + 4.0*(z_5 + z_6)*z_3 + z_6*z_8 + (e*z_4 + z_10*z_11)*z_11 +
        z_10*z_12*z_7);
    const double z_14 = z_3*z_13;
    const double J = c[14];
    const double k = c[10];
    const double z_15 = density*k;
    const double z_16 = z_2/(3.0*J + (z_5 + z_15)*z_2);
    const double z_17 = 1.0/(1.7189244238450625*z_14 + 0.9560643415727004*z_16);
    const double c_ = c[2];
    const double z_18 = c_*c_;
    const double z_19 = density*c_;
    const double g = c[6];
    const double z_20 = density*g;
    const double i = c[8];
    const double z_21 = density*i;
    const double h = c[7];
    const double z_22 = h*z_19;
    const double z_23 = density*h;
    const double z_24 = z_21 + z_23;
    const double z_25 = c_*z_24 + 0.5*i*z_19;
    const double z_26 = z_9 + z_20 + z_23;
    const double z_27 = c_*z_26 + 0.5*g*z_19;
    const double z_28 = z_18/(2.0*z_18*z_19 + 2.0*(z_15 + z_20 + z_21)*z_18 + c_*(2.0*z_22 + 2.0*z_25 + 2.0*z_27)
        + z_20*z_18 + z_21*z_18);
    const double z_29 = 1.0/(0.9560643415727004*z_16 + 2.0220877533087998*z_28);
    const double z_30 = 1.0/(6.281075576154938*z_14 + 1.0439356584272999*z_16);
    const double z_31 = 1.0/(1.0439356584272999*z_16 + 1.9779122466912002*z_28);
    dM[0] = ((-2.0/3.0))*(cos_theta*sin_theta*((z_2*z_17 + z_2*z_29) - (z_2*z_30 + z_2*z_31)));
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double z_33 = sin_theta*cos_aj;
    const double z_34 = m*j;
    const double z_35 = z_17*z_34;
    const double sin_aj = em_sin(aj);
    const double z_37 = cos_theta*sin_aj;
    const double z_38 = z_30*z_34;
    dM[7] = dM[1] = ((-1.0/3.0))*(z_33*z_35 - z_37*z_38);
    const double z_39 = z_34*z_4;
    const double z_40 = m*b;
    const double z_41 = z_39 - 2.0*z_17*z_40;
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double z_43 = cos_ab*sin_theta;
    const double z_44 = z_39 - 2.0*z_30*z_40;
    const double sin_ab = em_sin(ab);
    const double z_46 = cos_theta*sin_ab;
    dM[14] = dM[2] = ((-1.0/6.0))*(z_41*z_43 - z_44*z_46);
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double z_48 = sin_theta*cos_ak;
    const double z_49 = m*k;
    const double z_50 = z_29*z_49;
    const double sin_ak = em_sin(ak);
    const double z_52 = cos_theta*sin_ak;
    const double z_53 = z_31*z_49;
    dM[21] = dM[3] = ((-1.0/3.0))*(z_48*z_50 - z_52*z_53);
    const double z_54 = z_19*z_49;
    const double z_55 = m*c_;
    const double z_56 = z_54 - 2.0*z_29*z_55;
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_58 = sin_theta*cos_ac;
    const double z_59 = z_54 - 2.0*z_31*z_55;
    const double sin_ac = em_sin(ac);
    const double z_61 = cos_theta*sin_ac;
    dM[28] = dM[4] = ((-1.0/6.0))*(z_56*z_58 - z_59*z_61);
    dM[56] = dM[50] = ((-1.0/3.0))*(z_37*z_35 - z_33*z_38);
    const double z_62 = j*j;
    dM[57] = ((-2.0/3.0))*(cos_aj*sin_aj*(z_17*z_62 - z_30*z_62));
    const double z_63 = cos_ab*sin_aj;
    const double z_64 = j*b;
    const double z_65 = z_17*z_64;
    const double z_66 = sin_ab*cos_aj;
    const double z_67 = z_30*z_64;
    dM[64] = dM[58] = (1.0/3.0)*(z_63*z_65 - z_66*z_67);
    dM[112] = dM[100] = ((-1.0/6.0))*(z_41*z_46 - z_44*z_43);
    dM[113] = dM[107] = (1.0/3.0)*(z_66*z_65 - z_63*z_67);
    const double z_68 = d*sqrt(0.25*z_12);
    const double z_69 = cos_ab*z_11 - 2.0*sin_ab*z_68;
    const double z_70 = sin_ab*z_11 + 2.0*cos_ab*z_68;
    const double z_71 = 0.9799867889375745*z_11 + 0.39812507335168834*z_68;
    const double z_72 = 0.7809576093147158*z_11 - 1.2491680630778932*z_68;
    const double z_73 = g*g;
    const double z_74 = i*i;
    const double z_75 = z_73 + z_74 - h*h;
    const double z_76 = z_75/g;
    const double z_77 = 4.0 - z_75*z_75/(z_73*z_74);
    const double z_78 = z_73/(g*(4.0*g*z_26 + z_23*z_76) + (z_20*h + z_24*z_76)*z_76 + z_24*z_77*z_74);
    const double z_79 = 1.0/(1.9779122466912002*z_28 + z_13*(z_71*z_71) + z_13*(z_72*z_72) +
        0.7654631453230909*z_78);
    const double z_80 = 0.6245840315389466*z_11 + 1.5619152186294316*z_68;
    const double z_81 = 0.19906253667584417*z_11 - 1.959973577875149*z_68;
    const double z_82 = 1.0/(2.0220877533087998*z_28 + 7.234536854676909*z_78 + z_13*(z_80*z_80) +
        z_13*(z_81*z_81));
    dM[114] = (1.0/6.0)*(z_69*z_70*(z_79 - z_82) - 4.0*cos_ab*sin_ab*(z_3*z_17 - z_3*z_30));
    const double z_83 = f*z_19;
    const double z_84 = c_*z_82;
    const double z_85 = z_83 - 2.0*z_84;
    const double z_86 = cos_ac*z_70;
    const double z_87 = c_*z_79;
    const double z_88 = z_83 - 2.0*z_87;
    const double z_89 = sin_ac*z_69;
    dM[128] = dM[116] = ((-1.0/12.0))*(z_85*z_86 - z_88*z_89);
    const double af = x[5];
    const double sin_af = em_sin(af);
    const double z_91 = f*sin_af;
    const double z_92 = z_69*z_91;
    const double cos_af = em_cos(af);
    const double z_94 = f*cos_af;
    const double z_95 = z_70*z_94;
    dM[135] = dM[117] = (1.0/6.0)*(z_79*z_92 - z_82*z_95);
    const double z_96 = f*z_20;
    const double z_97 = g*z_82;
    const double z_98 = z_96 - 2.0*z_97;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_100 = z_70*cos_ag;
    const double z_101 = g*z_79;
    const double z_102 = z_96 - 2.0*z_101;
    const double sin_ag = em_sin(ag);
    const double z_104 = z_69*sin_ag;
    dM[142] = dM[118] = ((-1.0/12.0))*(z_98*z_100 - z_102*z_104);
    dM[168] = dM[150] = ((-1.0/3.0))*(z_52*z_50 - z_48*z_53);
    const double z_105 = k*k;
    dM[171] = ((-2.0/3.0))*(cos_ak*sin_ak*(z_29*z_105 - z_31*z_105));
    const double z_106 = cos_ac*sin_ak;
    const double z_107 = k*c_;
    const double z_108 = z_29*z_107;
    const double z_109 = sin_ac*cos_ak;
    const double z_110 = z_31*z_107;
    dM[178] = dM[172] = (1.0/3.0)*(z_106*z_108 - z_109*z_110);
    dM[224] = dM[200] = ((-1.0/6.0))*(z_56*z_61 - z_59*z_58);
    dM[226] = dM[214] = ((-1.0/12.0))*(z_85*z_89 - z_88*z_86);
    dM[227] = dM[221] = (1.0/3.0)*(z_109*z_108 - z_106*z_110);
    dM[228] = ((-2.0/3.0))*(cos_ac*sin_ac*((z_18*z_29 + z_18*z_82) - (z_18*z_31 + z_18*z_79)));
    const double z_111 = sin_ac*z_94;
    const double z_112 = cos_ac*z_91;
    dM[235] = dM[229] = (1.0/3.0)*(z_84*z_111 - z_87*z_112);
    const double z_113 = z_22 + 2.0*z_25;
    const double z_114 = 2.0*g*(z_22 + 2.0*z_27) + z_113*z_76;
    const double z_115 = z_114 + 4.0*g*z_84;
    const double z_116 = sin_ac*cos_ag;
    const double z_117 = z_114 + 4.0*g*z_87;
    const double z_118 = cos_ac*sin_ag;
    const double z_119 = sqrt(0.25*z_77)*(i*z_113);
    const double z_120 = sin_ac*sin_ag*z_119 + cos_ac*cos_ag*z_119;
    dM[242] = dM[230] = (1.0/12.0)*(z_117*z_118 + 2.0*z_120 - z_115*z_116);
    dM[282] = dM[264] = (1.0/6.0)*(z_79*z_95 - z_82*z_92);
    dM[284] = dM[278] = (1.0/3.0)*(z_84*z_112 - z_87*z_111);
    const double z_121 = f*f;
    dM[285] = ((-2.0/3.0))*(sin_af*cos_af*(z_82*z_121 - z_79*z_121));
    const double z_122 = cos_ag*z_91;
    const double z_123 = sin_ag*z_94;
    dM[292] = dM[286] = (1.0/3.0)*(z_97*z_122 - z_101*z_123);
    dM[338] = dM[314] = ((-1.0/12.0))*(z_98*z_104 - z_102*z_100);
    dM[340] = dM[328] = ((-1.0/12.0))*(z_115*z_118 + 2.0*z_120 - z_117*z_116);
    dM[341] = dM[335] = (1.0/3.0)*(z_97*z_123 - z_101*z_122);
    dM[342] = ((-2.0/3.0))*(cos_ag*sin_ag*(z_73*z_82 - z_73*z_79));
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double m = c[12];
    const double lambda_2 = lambda[2];
    const double lambda_0 = lambda[0];
    const double theta_dot = v[0];
    const double z_1 = theta_dot*theta_dot;
    const double z_2 = m*z_1;
    const double z_3 = cos_theta*z_2;
    const double ak_dot = v[3];
    const double z_4 = ak_dot*ak_dot;
    const double k = c[10];
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double z_6 = k*cos_ak;
    const double z_7 = z_4*z_6;
    const double ac_dot = v[4];
    const double z_8 = ac_dot*ac_dot;
    const double c_ = c[2];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_10 = c_*cos_ac;
    const double z_11 = z_8*z_10;
    const double z_12 = z_3 + z_7 - z_11;
    const double z_13 = m*m;
    const double J = c[14];
    const double density = c[13];
    const double j = c[9];
    const double z_14 = density*j;
    const double z_15 = density*k;
    const double z_16 = z_13/(3.0*J + (z_14 + z_15)*z_13);
    const double z_17 = c_*c_;
    const double z_18 = density*c_;
    const double g = c[6];
    const double z_19 = density*g;
    const double i = c[8];
    const double z_20 = density*i;
    const double h = c[7];
    const double z_21 = h*z_18;
    const double z_22 = density*h;
    const double z_23 = z_20 + z_22;
    const double z_24 = c_*z_23 + 0.5*i*z_18;
    const double f = c[5];
    const double z_25 = density*f;
    const double z_26 = z_25 + z_19 + z_22;
    const double z_27 = c_*z_26 + 0.5*g*z_18;
    const double z_28 = z_17/(2.0*z_17*z_18 + 2.0*(z_15 + z_19 + z_20)*z_17 + c_*(2.0*z_21 + 2.0*z_24 + 2.0*z_27)
        + z_19*z_17 + z_20*z_17);
    const double z_29 = 1.0/(1.0439356584272999*z_16 + 1.9779122466912002*z_28);
    const double z_30 = m*z_29;
    const double aj_dot = v[1];
    const double z_31 = aj_dot*aj_dot;
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double z_33 = j*cos_aj;
    const double z_34 = z_31*z_33;
    const double ab_dot = v[2];
    const double z_35 = ab_dot*ab_dot;
    const double b = c[1];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double z_37 = b*cos_ab;
    const double z_38 = z_35*z_37;
    const double z_39 = z_3 + z_34 - z_38;
    const double z_40 = b*b;
    const double z_41 = density*b;
    const double e = c[4];
    const double z_42 = density*e;
    const double d = c[3];
    const double z_43 = d*d;
    const double z_44 = z_40 + z_43 - e*e;
    const double z_45 = z_42 + density*d + z_25;
    const double z_46 = z_44/b;
    const double z_47 = 4.0 - z_44*z_44/(z_40*z_43);
    const double z_48 = 1.0/(4.0*z_40*z_41 + 4.0*(z_14 + z_42)*z_40 + z_42*z_44 + (e*z_41 + z_45*z_46)*z_46 +
        z_45*z_47*z_43);
    const double z_49 = z_40*z_48;
    const double z_50 = 1.0/(6.281075576154938*z_49 + 1.0439356584272999*z_16);
    const double z_51 = m*z_50;
    const double z_52 = m*k;
    const double z_53 = density*z_52;
    const double z_54 = m*j;
    const double z_55 = z_54*z_41;
    const double z_56 = cos_ab*z_55;
    const double z_57 = 1.0/(1.7189244238450625*z_49 + 0.9560643415727004*z_16);
    const double z_58 = m*z_57;
    const double z_59 = 1.0/(0.9560643415727004*z_16 + 2.0220877533087998*z_28);
    const double z_60 = m*z_59;
    const double z_61 = z_58 + z_60;
    const double ac_ddot = a[4];
    const double sin_ac = em_sin(ac);
    const double z_63 = c_*z_53;
    const double z_64 = c_*z_30;
    const double z_65 = z_63 - 2.0*z_64;
    const double z_66 = sin_ac*z_65;
    const double sin_ak = em_sin(ak);
    const double z_68 = sin_ak*z_29;
    const double ak_ddot = a[3];
    const double z_69 = ak_ddot*z_52;
    const double ab_ddot = a[2];
    const double sin_ab = em_sin(ab);
    const double z_71 = b*z_51;
    const double z_72 = z_55 - 2.0*z_71;
    const double z_73 = sin_ab*z_72;
    const double sin_aj = em_sin(aj);
    const double z_75 = sin_aj*z_50;
    const double aj_ddot = a[1];
    const double z_76 = aj_ddot*z_54;
    const double sin_theta = em_sin(theta);
    const double theta_ddot = a[0];
    const double z_78 = sin_theta*theta_ddot;
    const double gravity = c[16];
    const double z_79 = density*gravity;
    const double z_80 = k*z_79;
    const double z_81 = j*z_79;
    const double lambda_3 = lambda[3];
    const double lambda_1 = lambda[1];
    const double z_82 = sin_theta*z_2;
    const double z_83 = k*sin_ak;
    const double z_84 = z_4*z_83;
    const double z_85 = c_*sin_ac;
    const double z_86 = z_8*z_85;
    const double z_87 = z_82 + z_84 - z_86;
    const double z_88 = j*sin_aj;
    const double z_89 = z_31*z_88;
    const double z_90 = b*sin_ab;
    const double z_91 = z_35*z_90;
    const double z_92 = z_82 + z_89 - z_91;
    const double z_93 = sin_ab*z_55;
    const double z_94 = z_51 + z_30;
    const double z_95 = c_*z_60;
    const double z_96 = z_63 - 2.0*z_95;
    const double z_97 = cos_ac*z_96;
    const double z_98 = cos_ak*z_59;
    const double z_99 = b*z_58;
    const double z_100 = z_55 - 2.0*z_99;
    const double z_101 = cos_ab*z_100;
    const double z_102 = cos_aj*z_57;
    const double z_103 = cos_theta*theta_ddot;
    D[0] = ((-1.0/6.0))*(cos_theta*(6.0*m*lambda_2 + 6.0*m*lambda_0 + 2.0*z_3*z_61 - 2.0*z_12*z_30 - 2.0*z_39*z_51
        - z_11*z_53 - z_35*z_56 - ac_ddot*z_66 - 2.0*z_68*z_69 - ab_ddot*z_73 - 2.0*z_75*z_76 - 4.0*(z_13*z_50 +
        z_13*z_29)*z_78) + sin_theta*(3.0*m*(z_80 + z_81) + 6.0*m*lambda_3 + 6.0*m*lambda_1 + 2.0*z_82*z_94 +
        ac_ddot*z_97 + 2.0*z_98*z_69 + ab_ddot*z_101 + 2.0*z_102*z_76 + 4.0*(z_13*z_57 + z_13*z_59)*z_103 -
        2.0*z_87*z_60 - 2.0*z_92*z_58 - z_86*z_53 - z_35*z_93));
    const double z_104 = cos_theta*z_57;
    const double z_105 = z_31*z_54;
    const double z_106 = sin_theta*z_50;
    D[1] = ((-1.0/3.0))*(cos_aj*(z_104*z_105 - z_76*z_106) + sin_aj*(z_106*z_105 + z_76*z_104));
    const double z_107 = sin_theta*z_72;
    const double z_108 = cos_theta*z_100;
    D[2] = (1.0/6.0)*(cos_ab*(ab_ddot*z_107 - z_35*z_108) - sin_ab*(ab_ddot*z_108 + z_35*z_107));
    const double z_109 = cos_theta*z_59;
    const double z_110 = z_4*z_52;
    const double z_111 = sin_theta*z_29;
    D[3] = ((-1.0/3.0))*(cos_ak*(z_109*z_110 - z_69*z_111) + sin_ak*(z_111*z_110 + z_69*z_109));
    const double z_112 = sin_theta*z_65;
    const double z_113 = cos_theta*z_96;
    D[4] = (1.0/6.0)*(cos_ac*(ac_ddot*z_112 - z_8*z_113) - sin_ac*(ac_ddot*z_113 + z_8*z_112));
    const double z_114 = ab_dot*sin_ab;
    const double z_115 = cos_theta*z_55;
    const double z_116 = z_114*z_115;
    const double z_117 = ab_dot*cos_ab;
    const double z_118 = sin_theta*z_55;
    const double z_119 = z_117*z_118;
    const double z_120 = ac_dot*z_85;
    const double z_121 = cos_theta*z_53;
    const double z_122 = z_120*z_121;
    const double z_123 = ac_dot*z_10;
    const double z_124 = sin_theta*z_53;
    const double z_125 = z_123*z_124;
    const double z_126 = z_10*z_124 - z_85*z_121;
    const double z_127 = ac_dot*z_126;
    const double z_128 = sin_theta*z_56 - sin_ab*z_115;
    const double z_129 = ab_dot*z_128;
    const double z_130 = theta_dot*cos_theta;
    D[7] = (1.0/6.0)*(z_116 + z_122 + z_127 + z_129 - z_119 - z_125 - 4.0*sin_theta*(m*z_61 - m*z_94)*z_130);
    const double z_131 = aj_dot*sin_aj;
    const double z_132 = aj_dot*cos_aj;
    D[8] = ((-2.0/3.0))*(z_54*z_131*z_104 - z_54*z_132*z_106);
    const double z_133 = theta_dot*sin_theta;
    const double z_134 = z_133*z_56;
    const double z_135 = z_130*z_93;
    const double z_136 = (z_116 + z_134) - (z_119 + z_135);
    const double z_137 = theta_dot*z_128;
    const double z_138 = z_55 - 4.0*z_99;
    const double z_139 = z_55 - 4.0*z_71;
    D[9] = ((-1.0/6.0))*(z_136 + cos_theta*z_138*z_114 - z_137 - sin_theta*z_139*z_117);
    const double z_140 = ak_dot*sin_ak;
    const double z_141 = ak_dot*cos_ak;
    D[10] = ((-2.0/3.0))*(z_52*z_140*z_109 - z_52*z_141*z_111);
    const double z_142 = z_10*z_53*z_133;
    const double z_143 = z_85*z_53*z_130;
    const double z_144 = (z_142 + z_122) - (z_143 + z_125);
    const double z_145 = theta_dot*z_126;
    const double z_146 = z_63 - 4.0*z_95;
    const double z_147 = ac_dot*sin_ac;
    const double z_148 = z_63 - 4.0*z_64;
    const double z_149 = ac_dot*cos_ac;
    D[11] = ((-1.0/6.0))*(z_144 + cos_theta*z_146*z_147 - z_145 - sin_theta*z_148*z_149);
    const double z_150 = z_54*z_102;
    const double z_151 = z_54*z_75;
    D[14] = ((-1.0/3.0))*(cos_theta*(z_1*z_150 - theta_ddot*z_151) + sin_theta*(z_1*z_151 + theta_ddot*z_150));
    const double z_152 = z_39*z_50;
    const double z_153 = j*j;
    const double z_154 = z_31*z_153;
    const double z_155 = sin_ab*z_50;
    const double z_156 = j*b;
    const double z_157 = ab_ddot*z_156;
    const double z_158 = aj_ddot*z_153;
    const double z_159 = z_92*z_57;
    const double z_160 = cos_ab*z_57;
    D[15] = ((-1.0/3.0))*(cos_aj*(3.0*j*lambda_0 + z_102*z_154 + z_155*z_157 - j*z_152 - 2.0*z_75*z_158 -
        z_50*z_54*z_78) + sin_aj*(3.0*j*lambda_1 + z_75*z_154 + 2.0*z_102*z_158 + z_57*z_54*z_103 - j*z_159 -
        z_160*z_157));
    const double z_161 = z_35*z_156;
    D[16] = (1.0/3.0)*(cos_ab*(z_102*z_161 - z_75*z_157) + sin_ab*(z_75*z_161 + z_102*z_157));
    D[21] = ((-2.0/3.0))*(z_133*z_150 - z_130*z_151);
    D[22] = ((-2.0/3.0))*(sin_aj*(z_57*z_153 - z_50*z_153)*z_132);
    D[23] = (2.0/3.0)*(z_156*z_114*z_102 - z_156*z_117*z_75);
    D[28] = (1.0/6.0)*(cos_theta*(theta_ddot*z_73 - z_1*z_101) - sin_theta*(theta_ddot*z_101 + z_1*z_73));
    const double z_162 = z_31*z_156;
    const double z_163 = aj_ddot*z_156;
    D[29] = (1.0/3.0)*(cos_aj*(z_160*z_162 - z_155*z_163) + sin_aj*(z_155*z_162 + z_160*z_163));
    const double z_164 = d*sqrt(0.25*z_47);
    const double z_165 = e*z_79;
    const double z_166 = z_25*gravity;
    const double z_167 = z_166 + d*z_79;
    const double z_168 = z_40*z_35;
    const double z_169 = z_25*g;
    const double ag_dot = v[6];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_171 = ag_dot*cos_ag;
    const double z_172 = ac_dot*z_25;
    const double z_173 = z_10*z_172;
    const double z_174 = g*g;
    const double z_175 = i*i;
    const double z_176 = z_174 + z_175 - h*h;
    const double z_177 = z_176/g;
    const double z_178 = 4.0 - z_176*z_176/(z_174*z_175);
    const double z_179 = z_174/(g*(4.0*g*z_26 + z_22*z_177) + (z_19*h + z_23*z_177)*z_177 + z_23*z_178*z_175);
    const double z_180 = 0.6245840315389466*z_46 + 1.5619152186294316*z_164;
    const double z_181 = 0.19906253667584417*z_46 - 1.959973577875149*z_164;
    const double z_182 = 1.0/(2.0220877533087998*z_28 + 7.234536854676909*z_179 + z_48*(z_180*z_180) +
        z_48*(z_181*z_181));
    const double z_183 = cos_ab*z_46;
    const double z_184 = sin_ab*z_164;
    const double z_185 = z_183 - 2.0*z_184;
    const double z_186 = ab_dot*z_185;
    const double z_187 = z_169*z_171 + z_173 + z_182*z_186;
    const double z_188 = ab_dot*z_46;
    const double sin_ag = em_sin(ag);
    const double z_190 = ag_dot*sin_ag;
    const double z_191 = z_85*z_172;
    const double z_192 = 0.9799867889375745*z_46 + 0.39812507335168834*z_164;
    const double z_193 = 0.7809576093147158*z_46 - 1.2491680630778932*z_164;
    const double z_194 = 1.0/(1.9779122466912002*z_28 + z_48*(z_192*z_192) + z_48*(z_193*z_193) +
        0.7654631453230909*z_179);
    const double z_195 = sin_ab*z_46;
    const double z_196 = cos_ab*z_164;
    const double z_197 = z_195 + 2.0*z_196;
    const double z_198 = ab_dot*z_197;
    const double z_199 = z_169*z_190 + z_191 + z_194*z_198;
    const double z_200 = ab_dot*z_164;
    const double z_201 = ab_ddot*z_40;
    const double z_202 = ab_dot*z_169;
    const double z_203 = z_46*z_117;
    const double z_204 = z_164*z_114;
    const double z_205 = z_203 - 2.0*z_204;
    const double af_dot = v[5];
    const double z_206 = af_dot*af_dot;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double z_208 = f*cos_af;
    const double z_209 = z_206*z_208;
    const double z_210 = ag_dot*ag_dot;
    const double z_211 = g*cos_ag;
    const double z_212 = z_210*z_211;
    const double z_213 = 2.0*z_11 + 2.0*z_212 - ab_dot*z_205 - 2.0*z_209;
    const double lambda_4 = lambda[4];
    const double z_214 = cos_ag*z_210;
    const double z_215 = z_25*z_10;
    const double ag_ddot = a[6];
    const double z_216 = g*z_194;
    const double z_217 = z_169 - 2.0*z_216;
    const double z_218 = sin_ag*z_217;
    const double af_ddot = a[5];
    const double sin_af = em_sin(af);
    const double z_220 = f*z_194;
    const double z_221 = sin_af*z_220;
    const double z_222 = c_*z_25;
    const double z_223 = c_*z_194;
    const double z_224 = z_222 - 2.0*z_223;
    const double z_225 = sin_ac*z_224;
    const double z_226 = z_197*ab_ddot;
    const double z_227 = z_171*z_202 + ab_dot*z_173 + z_169*z_214 + z_8*z_215 + ag_ddot*z_218 + 2.0*af_ddot*z_221
        + ac_ddot*z_225 + 2.0*z_194*z_226 - z_213*z_194 - 6.0*lambda_4;
    const double z_228 = z_46*z_114;
    const double z_229 = z_164*z_117;
    const double z_230 = z_228 + 2.0*z_229;
    const double z_231 = f*sin_af;
    const double z_232 = z_206*z_231;
    const double z_233 = g*sin_ag;
    const double z_234 = z_210*z_233;
    const double z_235 = 2.0*z_86 + 2.0*z_234 - ab_dot*z_230 - 2.0*z_232;
    const double lambda_5 = lambda[5];
    const double z_236 = sin_ag*z_210;
    const double z_237 = z_25*z_85;
    const double z_238 = g*z_182;
    const double z_239 = z_169 - 2.0*z_238;
    const double z_240 = cos_ag*z_239;
    const double z_241 = f*z_182;
    const double z_242 = cos_af*z_241;
    const double z_243 = c_*z_182;
    const double z_244 = z_222 - 2.0*z_243;
    const double z_245 = cos_ac*z_244;
    const double z_246 = z_185*ab_ddot;
    const double z_247 = z_190*z_202 + ab_dot*z_191 + z_169*z_236 + z_8*z_237 - z_235*z_182 - 6.0*lambda_5 -
        ag_ddot*z_240 - 2.0*af_ddot*z_242 - ac_ddot*z_245 - 2.0*z_182*z_246;
    D[30] = ((-1.0/12.0))*(cos_ab*(6.0*z_164*(z_165 + z_167) + 4.0*b*z_152 + 4.0*z_160*z_168 + z_187*z_188 +
        2.0*z_199*z_200 + 4.0*z_75*z_163 - 12.0*b*lambda_0 - 2.0*z_1*z_115 - 8.0*z_155*z_201 - 2.0*z_72*z_78 -
        z_46*z_227 - 2.0*z_164*z_247) + sin_ab*(3.0*((2.0*b + z_46)*z_165 + 2.0*b*(z_81 + gravity*z_41) +
        z_46*z_167) + 4.0*b*z_159 + 4.0*z_155*z_168 + z_199*z_188 + 8.0*z_160*z_201 + 2.0*z_100*z_103 +
        2.0*z_164*z_227 - 12.0*b*lambda_1 - 2.0*z_1*z_118 - 2.0*z_187*z_200 - 4.0*z_102*z_163 - z_46*z_247));
    const double z_248 = ab_dot*c_;
    const double z_249 = z_172*z_248;
    const double z_250 = c_*z_172;
    const double z_251 = z_197*z_224;
    const double z_252 = z_185*z_244;
    D[32] = ((-1.0/12.0))*(cos_ac*(z_185*z_249 + z_8*z_252 - z_205*z_250 - ac_ddot*z_251) + sin_ac*(z_197*z_249 +
        ac_ddot*z_252 + z_8*z_251 - z_230*z_250));
    const double z_253 = z_197*z_220;
    const double z_254 = z_185*z_241;
    D[33] = ((-1.0/6.0))*(sin_af*(z_206*z_253 + af_ddot*z_254) + cos_af*(z_206*z_254 - af_ddot*z_253));
    const double z_255 = ag_dot*z_202;
    const double z_256 = ag_dot*z_169;
    const double z_257 = z_197*z_217;
    const double z_258 = z_185*z_239;
    D[34] = ((-1.0/12.0))*(cos_ag*(z_185*z_255 + z_210*z_258 - z_205*z_256 - ag_ddot*z_257) + sin_ag*(z_197*z_255
        + ag_ddot*z_258 + z_210*z_257 - z_230*z_256));
    D[35] = ((-1.0/6.0))*(z_136 + z_129 + cos_ab*z_138*z_133 - sin_ab*z_139*z_130);
    D[36] = (2.0/3.0)*(z_156*z_160*z_131 - z_156*z_155*z_132);
    const double z_259 = z_230*z_182;
    const double z_260 = z_205*z_194;
    const double z_261 = z_197*cos_ag;
    const double z_262 = z_185*sin_ag;
    const double z_263 = z_169*z_261 - z_169*z_262;
    const double z_264 = ag_dot*z_263;
    const double z_265 = z_197*z_215 - z_185*z_237;
    const double z_266 = ac_dot*z_265;
    D[37] = ((-1.0/12.0))*(z_185*z_259 + 8.0*sin_ab*(z_40*z_57 - z_40*z_50)*z_117 + 2.0*z_135 + 2.0*z_137 +
        2.0*z_196*z_187 + z_195*z_187 + 2.0*z_184*z_199 - z_197*z_260 - 2.0*z_134 - z_264 - z_266 - z_183*z_199);
    const double z_267 = (z_185*z_191 + z_230*z_215) - (z_197*z_173 + z_205*z_237);
    const double z_268 = ab_dot*z_265;
    D[39] = ((-1.0/12.0))*(z_267 + z_185*(z_222 - 4.0*z_243)*z_147 - z_268 - z_197*(z_222 - 4.0*z_223)*z_149);
    const double z_269 = af_dot*cos_af;
    const double z_270 = af_dot*sin_af;
    D[40] = (1.0/3.0)*(z_269*z_253 - z_270*z_254);
    const double z_271 = z_185*z_190;
    const double z_272 = z_197*z_171;
    const double z_273 = (cos_ag*z_169*z_230 + z_169*z_271) - (sin_ag*z_169*z_205 + z_169*z_272);
    const double z_274 = ab_dot*z_263;
    D[41] = ((-1.0/12.0))*(z_273 + (z_169 - 4.0*z_238)*z_271 - z_274 - (z_169 - 4.0*z_216)*z_272);
    const double z_275 = z_52*z_98;
    const double z_276 = z_52*z_68;
    D[42] = ((-1.0/3.0))*(cos_theta*(z_1*z_275 - theta_ddot*z_276) + sin_theta*(z_1*z_276 + theta_ddot*z_275));
    const double z_277 = k*z_29;
    const double z_278 = k*k;
    const double z_279 = z_4*z_278;
    const double z_280 = z_85*z_277;
    const double z_281 = ak_ddot*z_278;
    const double z_282 = k*z_59;
    const double z_283 = z_10*z_282;
    D[45] = ((-1.0/3.0))*(cos_ak*(3.0*k*lambda_2 + z_98*z_279 + ac_ddot*z_280 - z_12*z_277 - 2.0*z_68*z_281 -
        z_29*z_52*z_78) + sin_ak*(3.0*k*lambda_3 + z_68*z_279 + 2.0*z_98*z_281 + z_59*z_52*z_103 - z_87*z_282 -
        ac_ddot*z_283));
    const double z_284 = k*c_;
    const double z_285 = z_98*z_284;
    const double z_286 = z_68*z_284;
    D[46] = (1.0/3.0)*(cos_ac*(z_8*z_285 - ac_ddot*z_286) + sin_ac*(z_8*z_286 + ac_ddot*z_285));
    D[49] = ((-2.0/3.0))*(z_133*z_275 - z_130*z_276);
    D[52] = ((-2.0/3.0))*(sin_ak*(z_59*z_278 - z_29*z_278)*z_141);
    D[53] = (2.0/3.0)*(k*z_120*z_98 - k*z_123*z_68);
    D[56] = (1.0/6.0)*(cos_theta*(theta_ddot*z_66 - z_1*z_97) - sin_theta*(theta_ddot*z_97 + z_1*z_66));
    const double z_287 = z_46*z_35;
    const double z_288 = z_164*z_35;
    const double z_289 = z_46*ab_ddot;
    const double z_290 = z_164*ab_ddot;
    D[58] = ((-1.0/12.0))*(cos_ab*(z_287*z_245 + 2.0*z_288*z_225 + 2.0*z_290*z_245 - z_289*z_225) -
        sin_ab*(2.0*z_288*z_245 - z_287*z_225 - 2.0*z_290*z_225 - z_289*z_245));
    D[59] = (1.0/3.0)*(cos_ak*(z_4*z_283 - ak_ddot*z_280) + sin_ak*(z_4*z_280 + ak_ddot*z_283));
    const double z_291 = c_*z_29;
    const double z_292 = z_21 + 2.0*z_24;
    const double z_293 = 2.0*g*(z_21 + 2.0*z_27) + z_292*z_177;
    const double z_294 = z_25*z_248;
    const double z_295 = c_*z_1;
    const double z_296 = i*sqrt(0.25*z_178);
    const double z_297 = z_292*z_296;
    const double z_298 = c_*z_59;
    const double z_299 = z_243 + z_298;
    const double z_300 = g*z_223;
    const double z_301 = z_293 + 4.0*z_300;
    const double z_302 = sin_ag*z_301;
    const double z_303 = c_*z_221;
    const double z_304 = cos_ag*z_297;
    const double z_305 = g*z_79;
    const double z_306 = i*z_79;
    const double z_307 = h*z_79;
    const double z_308 = z_306 + z_307;
    const double z_309 = z_223 + z_291;
    const double z_310 = g*z_243;
    const double z_311 = z_293 + 4.0*z_310;
    const double z_312 = cos_ag*z_311;
    const double z_313 = c_*z_242;
    const double z_314 = sin_ag*z_297;
    D[60] = (1.0/12.0)*(cos_ac*(12.0*c_*lambda_4 + 12.0*c_*lambda_2 + 2.0*z_223*z_213 + z_293*z_214 + z_205*z_294
        + 2.0*z_121*z_295 + ag_ddot*z_302 + 8.0*sin_ac*(z_17*z_29 + z_17*z_194)*ac_ddot + z_224*z_226 +
        2.0*z_65*z_78 + 2.0*ag_ddot*z_304 - 4.0*z_12*z_291 - 2.0*z_297*z_236 - 4.0*z_11*z_299 - 4.0*af_ddot*z_303
        - 4.0*ak_ddot*z_286) - sin_ac*(6.0*c_*(z_80 + 2.0*z_305 + c_*z_79 + 2.0*z_308 + z_166) + 4.0*z_87*z_298 +
        4.0*z_86*z_309 + ag_ddot*z_312 + 8.0*cos_ac*(z_17*z_59 + z_17*z_182)*ac_ddot + z_244*z_246 +
        2.0*z_96*z_103 - 12.0*c_*lambda_5 - 12.0*c_*lambda_3 - 2.0*z_243*z_235 - z_293*z_236 - z_230*z_294 -
        2.0*z_124*z_295 - 2.0*z_297*z_214 - 4.0*af_ddot*z_313 - 4.0*ak_ddot*z_285 - 2.0*ag_ddot*z_314));
    const double z_315 = z_220*z_85;
    const double z_316 = z_241*z_10;
    D[61] = (1.0/3.0)*(sin_af*(z_206*z_315 + af_ddot*z_316) + cos_af*(z_206*z_316 - af_ddot*z_315));
    const double z_317 = sin_ac*z_297;
    const double z_318 = sin_ac*z_301;
    const double z_319 = cos_ac*z_297;
    const double z_320 = cos_ac*z_311;
    D[62] = ((-1.0/12.0))*(cos_ag*(2.0*z_210*z_317 + 2.0*ag_ddot*z_319 + z_210*z_320 - ag_ddot*z_318) -
        sin_ag*(2.0*z_210*z_319 - ag_ddot*z_320 - 2.0*ag_ddot*z_317 - z_210*z_318));
    D[63] = ((-1.0/6.0))*(z_144 + z_127 + cos_ac*z_146*z_133 - sin_ac*z_148*z_130);
    D[65] = ((-1.0/12.0))*(z_267 + z_266 + 2.0*z_85*z_260 + 2.0*z_229*z_245 + z_228*z_245 + 2.0*z_204*z_225 -
        2.0*z_10*z_259 - z_203*z_225);
    D[66] = (2.0/3.0)*(z_283*z_140 - z_141*z_280);
    const double z_321 = cos_ac*z_293;
    const double z_322 = z_190*z_321;
    const double z_323 = sin_ac*z_293;
    const double z_324 = z_171*z_323;
    const double z_325 = sin_ag*z_317;
    const double z_326 = cos_ag*z_319;
    const double z_327 = cos_ag*z_323 - sin_ag*z_321 - 2.0*z_325 - 2.0*z_326;
    const double z_328 = ag_dot*z_327;
    const double z_329 = z_171*z_319;
    const double z_330 = z_190*z_317;
    const double z_331 = z_329 + z_330;
    D[67] = (1.0/12.0)*(2.0*z_142 + z_322 + z_215*z_198 + z_328 + 2.0*z_331 - 2.0*z_143 - z_324 - 2.0*z_145 -
        z_268 - z_237*z_186 - 8.0*sin_ac*(c_*z_299 - c_*z_309)*z_149);
    D[68] = (2.0/3.0)*(z_270*z_316 - z_269*z_315);
    const double z_332 = ac_dot*z_325;
    const double z_333 = ac_dot*z_326;
    const double z_334 = cos_ag*z_147;
    const double z_335 = z_293*z_334;
    const double z_336 = sin_ag*z_149;
    const double z_337 = z_293*z_336;
    const double z_338 = 2.0*(z_332 - z_329) + 2.0*(z_333 - z_330) + (z_337 + z_324) - (z_335 + z_322);
    const double z_339 = ac_dot*z_327;
    const double z_340 = z_293 + 8.0*z_310;
    const double z_341 = z_293 + 8.0*z_300;
    D[69] = ((-1.0/12.0))*(cos_ac*z_340*z_190 + 2.0*z_331 - z_338 - z_339 - sin_ac*z_341*z_171);
    D[72] = ((-1.0/6.0))*(cos_ab*(z_287*z_242 + 2.0*z_288*z_221 + 2.0*z_290*z_242 - z_289*z_221) -
        sin_ab*(2.0*z_288*z_242 - z_287*z_221 - 2.0*z_290*z_221 - z_289*z_242));
    D[74] = (1.0/3.0)*(cos_ac*(z_8*z_313 - ac_ddot*z_303) + sin_ac*(z_8*z_303 + ac_ddot*z_313));
    const double z_342 = f*f;
    const double z_343 = z_194*z_342;
    const double z_344 = sin_af*z_343;
    const double z_345 = z_241*z_211;
    const double z_346 = z_182*z_342;
    const double z_347 = cos_af*z_346;
    const double z_348 = z_220*z_233;
    D[75] = ((-1.0/6.0))*(sin_af*(6.0*f*lambda_5 + z_235*z_241 + 2.0*z_206*z_344 + 4.0*af_ddot*z_347 + z_241*z_246
        - 2.0*ag_ddot*z_345 - 2.0*ac_ddot*z_316) + cos_af*(6.0*f*lambda_4 + z_213*z_220 + 2.0*z_206*z_347 +
        2.0*ag_ddot*z_348 + 2.0*ac_ddot*z_315 - 4.0*af_ddot*z_344 - z_220*z_226));
    const double z_349 = g*z_242;
    const double z_350 = g*z_221;
    D[76] = (1.0/3.0)*(cos_ag*(z_210*z_349 - ag_ddot*z_350) + sin_ag*(z_210*z_350 + ag_ddot*z_349));
    D[79] = (1.0/6.0)*(z_205*z_221 + z_203*z_221 - z_230*z_242 - 2.0*z_229*z_242 - z_228*z_242 - 2.0*z_204*z_221);
    D[81] = (2.0/3.0)*(z_120*z_242 - z_123*z_221);
    D[82] = ((-2.0/3.0))*(cos_af*(z_346 - z_343)*z_270);
    D[83] = (2.0/3.0)*(z_190*z_349 - z_171*z_350);
    D[86] = ((-1.0/12.0))*(cos_ab*(z_287*z_240 + 2.0*z_288*z_218 + 2.0*z_290*z_240 - z_289*z_218) -
        sin_ab*(2.0*z_288*z_240 - z_287*z_218 - 2.0*z_290*z_218 - z_289*z_240));
    D[88] = (1.0/12.0)*(cos_ac*(2.0*z_8*z_314 + ac_ddot*z_302 + 2.0*ac_ddot*z_304 - z_8*z_312) -
        sin_ac*(2.0*z_8*z_304 + ac_ddot*z_312 + z_8*z_302 - 2.0*ac_ddot*z_314));
    D[89] = (1.0/3.0)*(sin_af*(z_206*z_348 + af_ddot*z_345) + cos_af*(z_206*z_345 - af_ddot*z_348));
    const double z_351 = z_174*z_182;
    const double z_352 = z_174*z_194;
    D[90] = ((-1.0/12.0))*(cos_ag*(6.0*z_308*z_296 + 4.0*z_351*z_214 + 4.0*af_ddot*z_350 + 2.0*ac_ddot*z_319 -
        12.0*g*lambda_4 - 2.0*z_216*z_213 - z_8*z_321 - z_205*z_202 - 2.0*z_8*z_317 - 8.0*sin_ag*z_352*ag_ddot -
        ac_ddot*z_318 - z_217*z_226) + sin_ag*(3.0*(z_177*z_306 + (2.0*g + z_177)*z_307 + 2.0*g*(z_305 + z_166)) +
        2.0*z_8*z_319 + 4.0*z_352*z_236 + 8.0*cos_ag*z_351*ag_ddot + ac_ddot*z_320 + z_239*z_246 +
        2.0*ac_ddot*z_317 - 12.0*g*lambda_5 - 2.0*z_238*z_235 - z_8*z_323 - z_230*z_202 - 4.0*af_ddot*z_349));
    D[93] = ((-1.0/12.0))*(z_273 + z_264 + 2.0*z_233*z_260 + 2.0*z_229*z_240 + z_228*z_240 + 2.0*z_204*z_218 -
        2.0*z_211*z_259 - z_203*z_218);
    const double z_353 = z_332 + z_333;
    D[95] = (1.0/12.0)*(z_338 + z_341*z_336 + 2.0*z_353 - z_328 - z_340*z_334);
    D[96] = (2.0/3.0)*(z_270*z_345 - z_269*z_348);
    D[97] = ((-1.0/12.0))*(8.0*sin_ag*(z_351 - z_352)*z_171 + z_337 + z_274 + z_339 + z_202*z_262 + 2.0*z_353 -
        z_335 - z_202*z_261);
    D[98] = z_82 - m*z_103;
    D[99] = z_89 - aj_ddot*z_33;
    D[100] = -(z_91 - ab_ddot*z_37);
    D[105] = (-2.0)*(m*z_130);
    D[106] = (-2.0)*(j*z_132);
    D[107] = 2.0*(b*z_117);
    D[112] = -(z_3 + m*z_78);
    D[113] = -(z_34 + aj_ddot*z_88);
    D[114] = z_38 + ab_ddot*z_90;
    D[119] = (-2.0)*(m*z_133);
    D[120] = (-2.0)*(j*z_131);
    D[121] = 2.0*(b*z_114);
    D[126] = z_82 - m*z_103;
    D[129] = z_84 - ak_ddot*z_6;
    D[130] = -(z_86 - ac_ddot*z_10);
    D[133] = (-2.0)*(m*z_130);
    D[136] = (-2.0)*(k*z_141);
    D[137] = 2.0*z_123;
    D[140] = -(z_3 + m*z_78);
    D[143] = -(z_7 + ak_ddot*z_83);
    D[144] = z_11 + ac_ddot*z_85;
    D[147] = (-2.0)*(m*z_133);
    D[150] = (-2.0)*(k*z_140);
    D[151] = 2.0*z_120;
    const double z_354 = 2.0*z_288 - z_289;
    const double z_355 = z_287 + 2.0*z_290;
    D[156] = 0.5*(cos_ab*z_354 + sin_ab*z_355);
    D[158] = -(z_86 - ac_ddot*z_10);
    D[159] = z_232 - af_ddot*z_208;
    D[160] = -(z_234 - ag_ddot*z_211);
    D[163] = (-0.5)*(z_205 + z_205);
    D[165] = 2.0*z_123;
    D[166] = (-2.0)*(f*z_269);
    D[167] = 2.0*(g*z_171);
    D[170] = (-0.5)*(cos_ab*z_355 - sin_ab*z_354);
    D[172] = z_11 + ac_ddot*z_85;
    D[173] = -(z_209 + af_ddot*z_231);
    D[174] = z_212 + ag_ddot*z_233;
    D[177] = (-0.5)*(z_230 + z_230);
    D[179] = 2.0*z_120;
    D[180] = (-2.0)*(f*z_270);
    D[181] = 2.0*(g*z_190);
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
    const double ab_ddot = a[2];
    const double z_1 = sin_ab*ab_ddot;
    const double b = c[1];
    const double z_2 = b*b;
    const double density = c[13];
    const double z_3 = density*b;
    const double j = c[9];
    const double z_4 = density*j;
    const double e = c[4];
    const double z_5 = density*e;
    const double z_6 = z_4 + z_5;
    const double z_7 = z_2;
    const double d = c[3];
    const double z_8 = d*d;
    const double z_9 = z_7 + z_8 - e*e;
    const double f = c[5];
    const double z_10 = density*f;
    const double z_11 = density*d + z_10;
    const double z_12 = z_5 + z_11;
    const double z_13 = 1.0/b;
    const double z_14 = z_9*z_13;
    const double z_15 = e*z_3 + z_12*z_14;
    const double z_16 = 1.0/z_2;
    const double z_17 = z_9*z_9;
    const double z_18 = z_16*z_17;
    const double z_19 = 1.0/z_8;
    const double z_20 = 4.0 - z_18*z_19;
    const double z_21 = z_12*z_8;
    const double z_22 = 4.0*z_2*z_3 + 4.0*z_6*z_2 + z_5*z_9 + z_15*z_14 + z_20*z_21;
    const double z_23 = 1.0/z_22;
    const double z_24 = z_2*z_23;
    const double m = c[12];
    const double z_25 = m*m;
    const double J = c[14];
    const double k = c[10];
    const double z_26 = density*k;
    const double z_27 = z_4 + z_26;
    const double z_28 = 3.0*J + z_27*z_25;
    const double z_29 = 1.0/z_28;
    const double z_30 = z_25*z_29;
    const double z_31 = 6.281075576154938*z_24 + 1.0439356584272999*z_30;
    const double z_32 = 1.0/z_31;
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double z_34 = m*sin_theta;
    const double cos_ab = em_cos(ab);
    const double z_36 = cos_ab*ab_ddot;
    const double z_37 = 1.7189244238450625*z_24 + 0.9560643415727004*z_30;
    const double z_38 = 1.0/z_37;
    const double cos_theta = em_cos(theta);
    const double z_40 = m*cos_theta;
    const double z_41 = m*density;
    const double z_42 = j*z_41;
    const double z_43 = sin_theta*z_1 + cos_theta*z_36;
    const double z_44 = m*z_32;
    const double ab_dot = v[2];
    const double z_45 = ab_dot*ab_dot;
    const double z_46 = cos_ab*z_45;
    const double z_47 = sin_theta*z_46;
    const double z_48 = m*z_38;
    const double z_49 = sin_ab*z_45;
    const double z_50 = cos_theta*z_49;
    const double theta_dot = v[0];
    const double z_51 = theta_dot*theta_dot;
    const double z_52 = z_51*z_34;
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    const double aj_dot = v[1];
    const double z_54 = aj_dot*aj_dot;
    const double z_55 = sin_aj*z_54;
    const double z_56 = z_52 + j*z_55 - b*z_49;
    const double z_57 = 1.0/(z_37*z_37);
    const double z_58 = z_56*z_57;
    const double z_59 = b*z_36;
    const double aj_ddot = a[1];
    const double z_60 = j*aj_ddot;
    const double cos_aj = em_cos(aj);
    const double z_62 = cos_aj*z_57;
    const double z_63 = cos_theta*cos_theta;
    const double theta_ddot = a[0];
    const double z_64 = theta_ddot*z_25;
    const double z_65 = z_63*z_64;
    const double z_66 = z_40*z_58 + z_57*z_40*z_59 - z_40*z_60*z_62 - z_57*z_65;
    const double z_67 = z_51*z_40;
    const double z_68 = cos_aj*z_54;
    const double z_69 = z_67 + j*z_68 - b*z_46;
    const double z_70 = 1.0/(z_31*z_31);
    const double z_71 = z_69*z_70;
    const double z_72 = b*z_1;
    const double z_73 = sin_aj*z_70;
    const double z_74 = sin_theta*sin_theta;
    const double z_75 = z_74*z_64;
    const double z_76 = z_34*z_71 + z_34*z_60*z_73 + z_70*z_75 - z_70*z_34*z_72;
    const double z_77 = 0.5729748079483541*z_66 - 2.0936918587183126*z_76;
    const double z_78 = b*z_23;
    const double z_79 = 1.0/(z_22*z_22);
    const double z_80 = z_12*z_79;
    const double z_81 = z_17*z_80;
    const double z_82 = z_15*z_79;
    const double z_83 = e*z_9;
    const double z_84 = b*z_6;
    const double z_85 = z_2*z_79;
    const double z_86 = z_9*z_80 - b*z_82 - z_5*z_85;
    const double z_87 = z_79*(z_2*z_2);
    const double z_88 = 2.0*z_78 + z_9*z_82 + 2.0*b*z_86 - z_13*z_81 - z_83*z_79*z_3 - 8.0*z_84*z_85 -
        12.0*density*z_87;
    D[1] = ((-1.0/6.0))*(2.0*z_1*z_32*z_34 + 2.0*z_36*z_38*z_40 + (2.0*z_44 - z_42)*z_47 - z_42*z_43 - (2.0*z_48 -
        z_42)*z_50 - 6.0*z_77*z_88);
    const double ac = x[4];
    const double sin_ac = em_sin(ac);
    const double ac_ddot = a[4];
    const double z_90 = sin_ac*ac_ddot;
    const double c_ = c[2];
    const double z_91 = c_*c_;
    const double z_92 = density*c_;
    const double g = c[6];
    const double z_93 = density*g;
    const double i = c[8];
    const double z_94 = density*i;
    const double z_95 = z_26 + z_93 + z_94;
    const double h = c[7];
    const double z_96 = density*h;
    const double z_97 = z_94 + z_96;
    const double z_98 = c_*z_97;
    const double z_99 = z_10 + z_93 + z_96;
    const double z_100 = c_*z_99;
    const double z_101 = h*z_92;
    const double z_102 = g*z_92;
    const double z_103 = i*z_92;
    const double z_104 = z_102 + z_103;
    const double z_105 = 2.0*z_98 + 2.0*z_100 + 2.0*z_101 + z_104;
    const double z_106 = 2.0*z_91*z_92 + 2.0*z_95*z_91 + c_*z_105 + z_93*z_91 + z_94*z_91;
    const double z_107 = 1.0/z_106;
    const double z_108 = z_91*z_107;
    const double z_109 = 1.0439356584272999*z_30 + 1.9779122466912002*z_108;
    const double z_110 = 1.0/z_109;
    const double cos_ac = em_cos(ac);
    const double z_112 = cos_ac*ac_ddot;
    const double z_113 = 0.9560643415727004*z_30 + 2.0220877533087998*z_108;
    const double z_114 = 1.0/z_113;
    const double z_115 = k*z_41;
    const double z_116 = sin_theta*z_90 + cos_theta*z_112;
    const double z_117 = m*z_110;
    const double ac_dot = v[4];
    const double z_118 = ac_dot*ac_dot;
    const double z_119 = cos_ac*z_118;
    const double z_120 = sin_theta*z_119;
    const double z_121 = m*z_114;
    const double z_122 = sin_ac*z_118;
    const double z_123 = cos_theta*z_122;
    const double ak_dot = v[3];
    const double z_124 = ak_dot*ak_dot;
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    const double z_126 = k*sin_ak;
    const double z_127 = c_*sin_ac;
    const double z_128 = z_118*z_127;
    const double z_129 = z_52 + z_124*z_126 - z_128;
    const double z_130 = 1.0/(z_113*z_113);
    const double z_131 = z_129*z_130;
    const double z_132 = c_*cos_ac;
    const double z_133 = ac_ddot*z_132;
    const double cos_ak = em_cos(ak);
    const double z_135 = k*cos_ak;
    const double z_136 = z_130*z_135;
    const double ak_ddot = a[3];
    const double z_137 = ak_ddot*z_40;
    const double z_138 = z_40*z_131 + z_130*z_40*z_133 - z_136*z_137 - z_130*z_65;
    const double z_139 = z_118*z_132;
    const double z_140 = z_67 + z_124*z_135 - z_139;
    const double z_141 = 1.0/(z_109*z_109);
    const double z_142 = z_140*z_141;
    const double z_143 = ac_ddot*z_127;
    const double z_144 = z_141*z_126;
    const double z_145 = ak_ddot*z_34;
    const double z_146 = z_34*z_142 + z_144*z_145 + z_141*z_75 - z_141*z_34*z_143;
    const double z_147 = 0.6740292511029332*z_138 - 0.6593040822304*z_146;
    const double z_148 = 1.0/(z_106*z_106);
    const double z_149 = z_91*z_148;
    const double z_150 = z_92*z_149;
    const double z_151 = c_*z_149;
    const double z_152 = i*z_150 + g*z_150;
    const double z_153 = c_*z_107;
    const double z_154 = z_148*(z_91*z_91);
    const double z_155 = density*z_154;
    const double z_156 = (z_153 - 3.0*z_155) - 0.5*(z_105*z_149 + 4.0*z_95*z_151);
    const double z_157 = 2.0*z_156 - 2.0*h*z_150 - 2.0*z_99*z_151 - 2.0*z_97*z_151 - 3.0*z_152;
    D[2] = ((-1.0/6.0))*(2.0*z_90*z_110*z_34 + 2.0*z_112*z_114*z_40 + (2.0*z_117 - z_115)*z_120 - z_115*z_116 -
        (2.0*z_121 - z_115)*z_123 - 6.0*z_147*z_157);
    const double z_158 = z_20*(d*z_12);
    const double z_159 = z_20*z_8;
    const double z_160 = z_159*z_85 + z_17*z_79;
    const double z_161 = density*z_160;
    const double z_162 = 2.0*z_158*z_85 + 2.0*z_81/d + z_161 - 2.0*d*z_86;
    D[3] = -z_77*z_162;
    const double z_163 = density*z_9;
    const double z_164 = z_160 + 4.0*z_87;
    const double z_165 = 2.0*z_163*z_85 + 2.0*e*z_86 + density*z_164;
    D[4] = -z_77*z_165;
    const double z_166 = z_147*z_154;
    const double z_167 = 2.0*z_166 + z_77*z_160;
    D[5] = -density*z_167;
    D[6] = (-6.0)*(z_147*z_155);
    D[7] = (-6.0)*(z_147*z_155);
    D[8] = (-6.0)*(z_147*z_155);
    const double z_168 = z_46*z_34;
    const double z_169 = z_49*z_40;
    const double gravity = c[16];
    const double z_170 = density*gravity;
    const double z_171 = z_40*z_170;
    const double z_172 = z_55*z_38;
    const double z_173 = z_68*z_32;
    const double z_174 = sin_aj*z_32;
    const double z_175 = aj_ddot*z_174;
    const double z_176 = cos_aj*z_38;
    const double z_177 = aj_ddot*z_176;
    const double z_178 = m*z_43;
    const double z_179 = 0.3186881138575668*z_138 + 0.3186881138575668*z_66 - 0.34797855280909995*z_146 -
        0.34797855280909995*z_76;
    const double z_180 = 1.0/(z_28*z_28);
    const double z_181 = z_25*z_180;
    const double z_182 = theta_ddot - 3.0*z_179*z_181;
    const double z_183 = z_182*z_25;
    const double z_184 = 12.0*z_77*z_87 - z_183;
    D[9] = (1.0/6.0)*(z_3*z_168 + 3.0*z_171 + 2.0*z_34*z_173 + 2.0*z_34*z_175 + 2.0*z_40*z_177 + z_3*z_178 -
        z_3*z_169 - 2.0*z_40*z_172 - 2.0*density*z_184);
    const double z_185 = sin_ak*z_124;
    const double z_186 = z_185*z_114;
    const double z_187 = cos_ak*z_124;
    const double z_188 = z_187*z_110;
    const double z_189 = sin_ak*z_110;
    const double z_190 = cos_ak*z_114;
    const double z_191 = m*z_92;
    const double z_192 = 6.0*z_166 - z_183;
    D[10] = (1.0/6.0)*(z_119*z_92*z_34 + 3.0*z_171 + 2.0*z_34*z_188 + 2.0*z_189*z_145 + 2.0*z_190*z_137 +
        z_116*z_191 - z_122*z_92*z_40 - 2.0*z_40*z_186 - 2.0*density*z_192);
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    const double lambda_2 = lambda[2];
    const double lambda_3 = lambda[3];
    const double z_193 = cos_theta*z_114;
    const double z_194 = sin_theta*z_110;
    const double z_195 = cos_theta*z_38;
    const double z_196 = sin_theta*z_32;
    const double z_197 = k*z_92;
    const double z_198 = j*b;
    const double z_199 = density*z_198;
    const double z_200 = k*z_170;
    const double z_201 = j*z_170;
    const double z_202 = z_110*z_126;
    const double z_203 = ak_ddot*z_202;
    const double z_204 = z_114*z_135;
    const double z_205 = ak_ddot*z_204;
    const double z_206 = z_174*z_60;
    const double z_207 = z_176*z_60;
    const double z_208 = m*z_29;
    const double z_209 = m*z_27;
    const double z_210 = cos_theta*z_51;
    const double z_211 = z_48 + z_121;
    const double z_212 = z_44 + z_117;
    D[12] = ((-1.0/6.0))*(6.0*sin_theta*lambda_0 + 6.0*sin_theta*lambda_2 + 2.0*z_129*z_193 + 2.0*z_56*z_195 +
        z_197*z_123 + z_199*z_50 + 2.0*z_143*z_194 + 2.0*z_133*z_193 + 2.0*z_72*z_196 + 2.0*z_59*z_195 +
        2.0*sin_theta*z_210*(z_211 - z_212) - 6.0*cos_theta*lambda_1 - 6.0*cos_theta*lambda_3 - 2.0*z_140*z_194 -
        2.0*z_69*z_196 - z_197*z_120 - z_199*z_47 - 3.0*cos_theta*(z_200 + z_201) - 2.0*sin_theta*z_203 -
        2.0*cos_theta*z_205 - 2.0*sin_theta*z_206 - 2.0*cos_theta*z_207 - 12.0*z_179*z_208 - z_116*z_197 -
        z_43*z_199 - 4.0*z_182*z_209 - 4.0*theta_ddot*z_212*z_74 - 4.0*theta_ddot*z_211*z_63);
    const double z_213 = m*k;
    const double z_214 = c_*z_213;
    const double z_215 = c_*z_154;
    const double z_216 = i*z_154 + g*z_154;
    const double z_217 = h*z_154 + z_216;
    const double z_218 = z_215 + 3.0*z_217;
    const double z_219 = (d*z_160 + 2.0*z_83*z_85) + (e*z_164 + 4.0*b*z_87);
    D[13] = (1.0/6.0)*(k*z_139*z_34 + z_198*z_168 + z_116*z_214 + z_198*z_178 + 3.0*cos_theta*(m*j*gravity +
        gravity*z_213) - k*z_128*z_40 - z_198*z_169 - 6.0*f*z_167 - 2.0*k*z_192 - 2.0*j*z_184 - 12.0*z_147*z_218 -
        6.0*z_77*z_219);
    D[14] = z_182;
    D[15] = -1.0;
    D[16] = 0.5*(cos_theta*(z_42 + z_115));
    const double z_220 = j*z_176;
    const double z_221 = j*z_174;
    const double z_222 = j*z_62;
    const double z_223 = cos_aj*cos_aj;
    const double z_224 = aj_ddot*(j*j);
    const double z_225 = theta_ddot*z_40;
    const double z_226 = z_56*z_222 + z_36*z_198*z_62 - z_57*z_223*z_224 - z_225*z_222;
    const double z_227 = j*z_73;
    const double z_228 = sin_aj*sin_aj;
    const double z_229 = theta_ddot*z_34;
    const double z_230 = z_69*z_227 + z_70*z_228*z_224 + z_229*z_227 - z_1*z_198*z_73;
    const double z_231 = 0.5729748079483541*z_226 - 2.0936918587183126*z_230;
    D[19] = (1.0/3.0)*(z_49*z_220 + 3.0*z_88*z_231 - z_46*z_221 - z_1*z_221 - z_36*z_220);
    D[21] = -z_162*z_231;
    D[22] = -z_165*z_231;
    D[23] = -z_161*z_231;
    const double z_232 = 0.3186881138575668*z_226 - 0.34797855280909995*z_230;
    const double z_233 = z_180*(z_25*z_25);
    const double z_234 = z_232*z_233;
    const double z_235 = 4.0*z_87*z_231 + z_234;
    D[27] = ((-1.0/3.0))*(3.0*sin_aj*lambda_0 + z_56*z_176 + z_174*z_72 + z_176*z_59 + 3.0*density*z_235 -
        3.0*cos_aj*lambda_1 - z_69*z_174 - 2.0*z_32*z_228*z_60 - 2.0*z_38*z_223*z_60 - z_174*z_229 - z_176*z_225 -
        sin_aj*z_68*(j*z_32 - j*z_38));
    D[28] = -density*z_234;
    const double z_236 = sin_theta*z_51;
    const double z_237 = sin_theta*theta_ddot;
    const double z_238 = cos_theta*theta_ddot;
    const double z_239 = z_208 - z_181*z_209;
    D[30] = ((-1.0/3.0))*(z_236*z_220 - z_210*z_221 - z_237*z_221 - z_238*z_220 - 6.0*z_232*z_239);
    D[31] = -(k*z_234 + j*z_235 + z_231*(z_219 + f*z_160));
    D[32] = (-3.0)*(z_232*z_181);
    const double z_240 = cos_ab*z_38;
    const double z_241 = sin_ab*z_32;
    const double z_242 = sin_ab*z_67;
    const double z_243 = cos_ab*z_52;
    const double z_244 = z_9*z_16;
    const double ag_dot = v[6];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_246 = g*cos_ag;
    const double z_247 = ag_dot*z_246;
    const double z_248 = ac_dot*z_92;
    const double z_249 = cos_ac*z_248;
    const double z_250 = sqrt(0.25*z_20);
    const double z_251 = d*z_250;
    const double z_252 = sin_ab*z_251;
    const double z_253 = cos_ab*z_14 - 2.0*z_252;
    const double z_254 = g*g;
    const double z_255 = g*z_99;
    const double z_256 = i*i;
    const double z_257 = z_254 + z_256 - h*h;
    const double z_258 = 1.0/g;
    const double z_259 = z_257*z_258;
    const double z_260 = 4.0*z_255 + z_96*z_259;
    const double z_261 = g*z_96 + z_97*z_259;
    const double z_262 = 1.0/z_254;
    const double z_263 = z_257*z_257;
    const double z_264 = z_262*z_263;
    const double z_265 = 1.0/z_256;
    const double z_266 = 4.0 - z_264*z_265;
    const double z_267 = z_97*z_266;
    const double z_268 = g*z_260 + z_261*z_259 + z_256*z_267;
    const double z_269 = 1.0/z_268;
    const double z_270 = z_254*z_269;
    const double z_271 = 0.6245840315389466*z_14 + 1.5619152186294316*z_251;
    const double z_272 = z_271*z_271;
    const double z_273 = 0.19906253667584417*z_14 - 1.959973577875149*z_251;
    const double z_274 = z_273*z_273;
    const double z_275 = 2.0220877533087998*z_108 + 7.234536854676909*z_270 + z_23*z_272 + z_23*z_274;
    const double z_276 = 1.0/z_275;
    const double z_277 = z_253*z_276;
    const double z_278 = z_10*z_247 + f*z_249 + ab_dot*z_277;
    const double z_279 = ab_dot*sin_ab;
    const double z_280 = z_278*z_279;
    const double sin_ag = em_sin(ag);
    const double z_282 = g*sin_ag;
    const double z_283 = ag_dot*z_282;
    const double z_284 = sin_ac*z_248;
    const double z_285 = sin_ab*z_14 + 2.0*cos_ab*z_251;
    const double z_286 = 0.9799867889375745*z_14 + 0.39812507335168834*z_251;
    const double z_287 = z_286*z_286;
    const double z_288 = 0.7809576093147158*z_14 - 1.2491680630778932*z_251;
    const double z_289 = z_288*z_288;
    const double z_290 = 1.9779122466912002*z_108 + z_23*z_287 + z_23*z_289 + 0.7654631453230909*z_270;
    const double z_291 = 1.0/z_290;
    const double z_292 = z_285*z_291;
    const double z_293 = z_10*z_283 + f*z_284 + ab_dot*z_292;
    const double z_294 = ab_dot*cos_ab;
    const double z_295 = z_293*z_294;
    const double z_296 = sin_ab*sin_ab;
    const double z_297 = b*ab_ddot;
    const double z_298 = cos_ab*cos_ab;
    const double z_299 = b*cos_ab;
    const double z_300 = ab_ddot*z_2;
    const double z_301 = aj_ddot*z_198;
    const double z_302 = z_299*z_58 + z_57*z_298*z_300 - cos_ab*z_62*z_301 - z_57*z_225*z_299;
    const double z_303 = b*sin_ab;
    const double z_304 = z_303*z_71 + sin_ab*z_73*z_301 + z_70*z_229*z_303 - z_70*z_296*z_300;
    const double z_305 = 0.5729748079483541*z_302 - 2.0936918587183126*z_304;
    const double z_306 = ab_dot*z_10;
    const double z_307 = ab_dot*f;
    const double z_308 = z_14*z_294 - 2.0*z_251*z_279;
    const double af_dot = v[5];
    const double z_309 = af_dot*af_dot;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double z_311 = f*cos_af;
    const double z_312 = ag_dot*ag_dot;
    const double z_313 = z_312*z_246;
    const double z_314 = 2.0*z_139 + 2.0*z_313 - ab_dot*z_308 - 2.0*z_309*z_311;
    const double lambda_4 = lambda[4];
    const double z_315 = f*z_92;
    const double z_316 = z_10*g;
    const double z_317 = g*z_291;
    const double z_318 = z_316 - 2.0*z_317;
    const double ag_ddot = a[6];
    const double z_319 = sin_ag*ag_ddot;
    const double af_ddot = a[5];
    const double sin_af = em_sin(af);
    const double z_321 = f*sin_af;
    const double z_322 = z_291*z_321;
    const double z_323 = af_ddot*z_322;
    const double z_324 = c_*z_291;
    const double z_325 = z_315 - 2.0*z_324;
    const double z_326 = z_285*ab_ddot;
    const double z_327 = z_306*z_247 + z_307*z_249 + z_10*z_313 + z_315*z_119 + z_318*z_319 + 2.0*z_323 +
        z_325*z_90 + 2.0*z_291*z_326 - z_314*z_291 - 6.0*lambda_4;
    const double z_328 = sin_ab*z_327;
    const double z_329 = cos_ab*z_170;
    const double z_330 = z_14*z_279 + 2.0*z_251*z_294;
    const double z_331 = z_312*z_282;
    const double z_332 = 2.0*z_128 + 2.0*z_331 - ab_dot*z_330 - 2.0*z_309*z_321;
    const double z_333 = 1.0/(z_275*z_275);
    const double z_334 = z_253*z_333;
    const double z_335 = z_333*z_246;
    const double z_336 = ag_ddot*z_335;
    const double z_337 = z_333*z_311;
    const double z_338 = af_ddot*z_337;
    const double z_339 = z_332*z_334 + 2.0*z_253*z_338 + ab_ddot*z_333*(z_253*z_253) - 2.0*z_253*z_336 -
        2.0*z_133*z_334;
    const double z_340 = z_273*z_23;
    const double z_341 = z_271*z_23;
    const double z_342 = z_340 + 3.1376272098653435*z_341;
    const double z_343 = 1.0/(z_290*z_290);
    const double z_344 = z_285*z_343;
    const double z_345 = z_343*z_282;
    const double z_346 = ag_ddot*z_345;
    const double z_347 = z_343*z_321;
    const double z_348 = af_ddot*z_347;
    const double z_349 = z_314*z_344 + 2.0*z_285*z_346 + 2.0*z_143*z_344 - 2.0*z_285*z_348 -
        ab_ddot*z_343*(z_285*z_285);
    const double z_350 = z_288*z_23;
    const double z_351 = z_286*z_23;
    const double z_352 = z_350 + 1.2548527311200737*z_351;
    const double z_353 = e*z_329 + 4.0*z_349*(0.13015960155245263*z_352) - 4.0*z_339*(0.03317708944597403*z_342);
    const double lambda_5 = lambda[5];
    const double z_354 = g*z_276;
    const double z_355 = z_316 - 2.0*z_354;
    const double z_356 = cos_ag*ag_ddot;
    const double z_357 = z_276*z_311;
    const double z_358 = af_ddot*z_357;
    const double z_359 = c_*z_276;
    const double z_360 = z_315 - 2.0*z_359;
    const double z_361 = z_253*ab_ddot;
    const double z_362 = z_306*z_283 + z_307*z_284 + z_10*z_331 + z_315*z_122 - z_332*z_276 - 6.0*lambda_5 -
        z_355*z_356 - 2.0*z_358 - z_360*z_112 - 2.0*z_276*z_361;
    const double z_363 = cos_ab*z_362;
    const double z_364 = z_251/z_20;
    const double z_365 = e*z_170;
    const double z_366 = z_10*gravity;
    const double z_367 = z_366 + d*z_170;
    const double z_368 = sin_ab*(z_365 + z_367);
    const double z_369 = z_278*z_294;
    const double z_370 = z_293*z_279;
    const double z_371 = cos_ab*z_327;
    const double z_372 = z_340 - 0.7969062625439771*z_341;
    const double z_373 = z_350 - 0.31871217742368974*z_351;
    const double z_374 = z_339*(0.3266622629791915*z_372) - z_349*(0.20819467717964885*z_373);
    const double z_375 = sin_ab*z_362;
    const double z_376 = z_79*z_274 + z_79*z_272;
    const double z_377 = z_79*z_289 + z_79*z_287;
    const double z_378 = ab_ddot + (12.0*z_305*z_85 + z_339*z_376 - z_349*z_377);
    const double z_379 = (3.0*z_364*z_368 + z_364*z_369 + z_364*z_370 - z_364*z_371 - 6.0*z_374*z_364 -
        z_364*z_375) - z_378*z_21;
    const double z_380 = b*z_2;
    const double z_381 = z_17/(z_380);
    const double z_382 = z_19*z_381;
    const double z_383 = z_19*z_244;
    const double z_384 = z_5 + z_15*z_13 + z_12*z_244;
    const double z_385 = 3.0*cos_ab*z_367*z_13 + z_13*z_295 + z_13*z_328 + 3.0*z_353*z_13 + 2.0*z_379*z_383 +
        z_378*z_384 - z_13*z_280 - z_13*z_363;
    const double z_386 = sin_ab*z_237 + cos_ab*z_238;
    const double z_387 = b*z_170;
    const double z_388 = b*z_32;
    const double z_389 = b*z_38;
    const double z_390 = density*z_2;
    const double z_391 = z_15*z_244 + z_12*z_381 - 8.0*z_84 - 12.0*z_390 - z_5*z_14;
    D[37] = (1.0/12.0)*(12.0*sin_ab*lambda_0 + 4.0*z_56*z_240 + 2.0*z_4*z_242 + z_244*z_280 + 8.0*z_32*z_296*z_297
        + 8.0*z_38*z_298*z_297 + z_244*z_363 + 2.0*b*z_385 + 2.0*z_42*z_386 + 3.0*cos_ab*(2.0*z_387 + 2.0*z_365 +
        2.0*(z_201 + z_387) - z_367*z_244) + 4.0*sin_ab*z_46*(z_388 - z_389) - 12.0*cos_ab*lambda_1 -
        4.0*z_69*z_241 - 2.0*z_4*z_243 - z_244*z_295 - 4.0*sin_ab*z_206 - 4.0*cos_ab*z_207 - 4.0*z_229*z_241 -
        4.0*z_225*z_240 - 24.0*z_78*z_305 - z_244*z_328 - 3.0*z_353*z_244 - 2.0*z_379*z_382 - z_378*z_391);
    const double z_392 = sin_ac*z_308;
    const double z_393 = ac_dot*z_10;
    const double z_394 = cos_ac*z_330;
    const double z_395 = ac_dot*z_253;
    const double z_396 = ac_dot*z_285;
    const double z_397 = z_285*z_90 + z_253*z_112;
    const double z_398 = z_10 - 2.0*z_291;
    const double z_399 = z_285*z_119;
    const double z_400 = z_10 - 2.0*z_276;
    const double z_401 = z_253*z_122;
    const double z_402 = 0.1685073127757333*z_339 - 0.1648260205576*z_349;
    D[38] = (1.0/12.0)*(z_392*z_393 + cos_ac*z_306*z_396 + z_10*z_397 + z_398*z_399 - z_394*z_393 -
        sin_ac*z_306*z_395 - 2.0*z_90*z_292 - 2.0*z_112*z_277 - z_400*z_401 - 12.0*z_157*z_402);
    const double z_403 = z_253*z_170;
    const double z_404 = z_18/(d*z_8);
    const double z_405 = z_159 + z_18;
    const double z_406 = 2.0*z_158 + density*z_405;
    D[39] = ((-1.0/12.0))*(6.0*z_250*z_368 + 2.0*z_250*z_369 + 2.0*z_250*z_370 + 2.0*z_379*z_404 - 3.0*z_403 -
        2.0*z_250*z_371 - 12.0*z_374*z_250 - 2.0*z_250*z_375 - 2.0*d*z_385 - z_378*z_406);
    const double z_407 = 2.0*b + z_14;
    const double z_408 = 4.0*z_7 + z_405;
    const double z_409 = 2.0*z_163 + density*z_408;
    D[40] = (1.0/12.0)*(3.0*z_407*z_329 + z_378*z_409 - 6.0*z_252*z_170 - 2.0*e*z_385);
    const double z_410 = z_308*z_283;
    const double z_411 = z_330*z_247;
    const double z_412 = ab_dot*density;
    const double z_413 = z_253*z_283;
    const double z_414 = z_285*z_247;
    const double z_415 = sin_af*z_309;
    const double z_416 = cos_af*z_309;
    const double z_417 = cos_af*z_276;
    const double z_418 = af_ddot*z_417;
    const double z_419 = sin_af*z_291;
    const double z_420 = af_ddot*z_419;
    const double z_421 = z_285*z_319 + z_253*z_356;
    const double z_422 = 0.6028780712230757*z_339 - 0.0637885954435909*z_349;
    const double z_423 = 1.0/(z_268*z_268);
    const double z_424 = z_254*z_254*z_423;
    const double z_425 = z_402*z_154;
    const double z_426 = 2.0*z_422*z_424 + z_425;
    const double z_427 = 24.0*z_426 + z_378*z_405;
    D[41] = (1.0/12.0)*(density*z_285*z_313 + density*z_410 + z_248*z_392 + z_92*z_399 + z_412*z_414 +
        ab_dot*z_285*z_249 + 3.0*z_403 + 2.0*z_416*z_292 + 2.0*z_253*z_418 + 2.0*z_285*z_420 + z_93*z_421 +
        z_397*z_92 + density*z_427 - density*z_253*z_331 - density*z_411 - z_248*z_394 - z_92*z_401 - z_412*z_413
        - ab_dot*z_253*z_284 - 2.0*z_415*z_277);
    const double z_428 = ag_dot*z_10;
    const double z_429 = sin_ag*z_308;
    const double z_430 = cos_ag*z_330;
    const double z_431 = ag_dot*z_306;
    const double z_432 = z_155*z_402;
    const double z_433 = z_425 + z_426;
    const double z_434 = cos_ag*z_312;
    const double z_435 = sin_ag*z_312;
    const double z_436 = z_97*z_263;
    const double z_437 = z_423*z_436;
    const double z_438 = z_258*z_437;
    const double z_439 = z_257*z_423;
    const double z_440 = z_97*z_439;
    const double z_441 = z_254*z_423;
    const double z_442 = g*z_261*z_423 + z_96*z_441;
    const double z_443 = z_442 - z_440;
    const double z_444 = g*z_269;
    const double z_445 = (z_444 + 0.5*z_261*z_439) - 0.5*(z_260*z_441 + 4.0*z_255*z_441);
    const double z_446 = 2.0*z_445 - z_438 - 2.0*g*z_443;
    D[42] = (1.0/12.0)*(z_428*z_429 + z_285*cos_ag*z_431 + 24.0*z_432 + 24.0*density*z_433 + z_10*z_421 +
        z_285*z_434*z_398 - z_428*z_430 - z_253*sin_ag*z_431 - 2.0*z_319*z_292 - 2.0*z_356*z_277 -
        z_253*z_435*z_400 - 12.0*z_422*z_446);
    const double z_447 = z_266*z_256;
    const double z_448 = z_447*z_441 + z_263*z_423;
    const double z_449 = 2.0*z_425 + z_422*z_448;
    const double z_450 = 2.0*z_426 + z_449;
    const double z_451 = z_257*z_441;
    const double z_452 = density*z_451;
    const double z_453 = z_452 - h*z_443;
    D[43] = 2.0*z_432 + density*z_450 + 2.0*z_422*z_453;
    const double z_454 = 2.0*z_425 + z_449;
    const double z_455 = i*z_267;
    const double z_456 = z_441*z_455 + z_437/i + i*z_443;
    D[44] = 2.0*z_432 + density*z_454 + 2.0*z_422*z_456;
    const double z_457 = m*z_386;
    const double z_458 = 0.3186881138575668*z_302 - 0.34797855280909995*z_304;
    const double z_459 = z_458*z_233;
    const double z_460 = z_378*z_2 + 3.0*z_459;
    D[45] = (1.0/6.0)*(z_3*z_242 + 3.0*z_170*z_299 + 2.0*z_299*z_172 + z_3*z_457 + 2.0*density*z_460 - z_3*z_243 -
        2.0*z_303*z_173 - 2.0*z_303*z_175 - 2.0*z_299*z_177);
    const double z_461 = 2.0*z_425 + z_459;
    D[46] = density*z_461;
    D[48] = ((-1.0/6.0))*(2.0*z_237*z_32*z_303 + 2.0*z_238*z_38*z_299 + sin_ab*z_210*(2.0*z_388 - z_199) +
        12.0*z_239*z_458 - z_199*z_386 - cos_ab*z_236*(2.0*z_389 - z_199));
    const double z_462 = f*z_285;
    const double z_463 = f*z_253;
    const double z_464 = ac_dot*f;
    const double z_465 = z_308*z_127;
    const double z_466 = z_330*z_132;
    const double z_467 = e*gravity;
    const double z_468 = h*z_451;
    const double z_469 = f*g;
    const double z_470 = c_*f;
    const double z_471 = (z_380 + 0.5*z_83) + 0.25*(d*z_405 + e*z_408);
    const double z_472 = 4.0*z_471;
    D[49] = (1.0/12.0)*(z_313*z_462 + f*z_410 + z_464*z_465 + z_139*z_462 + 2.0*z_198*z_242 + z_307*z_414 +
        z_132*z_307*z_396 + 24.0*z_422*z_468 + 12.0*h*z_450 + 12.0*i*z_454 + 24.0*g*z_433 + z_421*z_469 +
        z_397*z_470 + f*z_427 + 2.0*z_198*z_457 + 12.0*k*z_461 + 4.0*j*z_460 + 3.0*z_253*(d*gravity + f*gravity) +
        3.0*cos_ab*(z_407*z_467 + 2.0*gravity*z_2 + 2.0*gravity*z_198) + 24.0*z_402*(z_215 + z_217) + z_378*z_472
        - z_331*z_463 - f*z_411 - z_464*z_466 - z_128*z_463 - 2.0*z_198*z_243 - z_307*z_413 - z_127*z_307*z_395 -
        6.0*z_252*z_467);
    D[50] = 3.0*(z_458*z_181);
    D[52] = (-0.25)*(2.0*z_5*z_252 - z_253*z_11 - cos_ab*(2.0*z_390 + 2.0*z_199 + z_5*z_407));
    const double z_473 = cos_ak*cos_ak;
    const double z_474 = ak_ddot*(k*k);
    const double z_475 = z_129*z_136 + z_133*z_136 - z_130*z_473*z_474 - z_225*z_136;
    const double z_476 = sin_ak*sin_ak;
    const double z_477 = z_140*z_144 + z_141*z_476*z_474 + z_229*z_144 - z_143*z_144;
    const double z_478 = 0.6740292511029332*z_475 - 0.6593040822304*z_477;
    D[56] = (1.0/3.0)*(z_122*z_204 + 3.0*z_157*z_478 - z_119*z_202 - z_90*z_202 - z_112*z_204);
    const double z_479 = z_155*z_478;
    D[59] = (-2.0)*z_479;
    D[60] = (-6.0)*z_479;
    D[61] = (-6.0)*z_479;
    D[62] = (-6.0)*z_479;
    const double z_480 = 0.3186881138575668*z_475 - 0.34797855280909995*z_477;
    const double z_481 = z_480*z_233;
    D[63] = -density*z_481;
    const double z_482 = k*ak_ddot;
    const double z_483 = 2.0*z_478*z_154 + z_481;
    D[64] = ((-1.0/3.0))*(3.0*sin_ak*lambda_2 + z_129*z_190 + z_143*z_189 + z_133*z_190 + 3.0*density*z_483 -
        3.0*cos_ak*lambda_3 - z_140*z_189 - 2.0*z_110*z_476*z_482 - 2.0*z_114*z_473*z_482 - z_229*z_189 -
        z_225*z_190 - sin_ak*z_187*(k*z_110 - k*z_114));
    D[66] = ((-1.0/3.0))*(z_236*z_204 - z_210*z_202 - z_237*z_202 - z_238*z_204 - 6.0*z_239*z_480);
    D[67] = -(k*z_483 + j*z_481 + 2.0*z_478*(z_218 + f*z_154));
    D[68] = (-3.0)*(z_480*z_181);
    const double z_484 = z_49*z_244;
    const double z_485 = cos_ac*z_360;
    const double z_486 = z_46*z_244;
    const double z_487 = sin_ac*z_325;
    const double z_488 = z_1*z_244;
    const double z_489 = z_333*z_132;
    const double z_490 = cos_ac*cos_ac;
    const double z_491 = ac_ddot*z_91;
    const double z_492 = z_490*z_491;
    const double z_493 = z_332*z_489 + 2.0*z_132*z_338 + z_361*z_489 - 2.0*z_132*z_336 - 2.0*z_333*z_492;
    const double z_494 = 0.06635417889194806*z_342;
    const double z_495 = z_343*z_127;
    const double z_496 = sin_ac*sin_ac;
    const double z_497 = z_496*z_491;
    const double z_498 = z_314*z_495 + 2.0*z_127*z_346 + 2.0*z_343*z_497 - 2.0*z_127*z_348 - z_326*z_495;
    const double z_499 = 0.26031920310490525*z_352;
    const double z_500 = z_493*z_494 - z_498*z_499;
    const double z_501 = z_36*z_244;
    const double z_502 = z_46*z_364;
    const double z_503 = z_49*z_364;
    const double z_504 = z_36*z_364;
    const double z_505 = 0.653324525958383*z_372;
    const double z_506 = 0.4163893543592977*z_373;
    const double z_507 = z_493*z_505 - z_498*z_506;
    const double z_508 = z_1*z_364;
    const double z_509 = z_376*z_493 - z_377*z_498;
    const double z_510 = (z_502*z_485 + z_503*z_487 + 6.0*z_507*z_364 + z_508*z_485 - z_504*z_487) +
        2.0*z_509*z_21;
    const double z_511 = z_49*z_13;
    const double z_512 = z_46*z_13;
    const double z_513 = z_1*z_13;
    const double z_514 = z_36*z_13;
    const double z_515 = z_511*z_485 + 2.0*z_384*z_509 - z_512*z_487 - z_513*z_487 - 12.0*z_500*z_13 - z_514*z_485
        - 2.0*z_510*z_383;
    D[73] = (1.0/12.0)*(z_484*z_485 + 2.0*z_391*z_509 - z_486*z_487 - z_488*z_487 - 12.0*z_500*z_244 - z_501*z_485
        - 2.0*z_510*z_382 - 2.0*b*z_515);
    const double z_516 = cos_ac*z_276;
    const double z_517 = sin_ac*z_291;
    const double z_518 = cos_ac*z_114;
    const double z_519 = sin_ac*z_110;
    const double z_520 = sin_ac*z_67;
    const double z_521 = cos_ac*z_52;
    const double z_522 = z_291*z_282;
    const double z_523 = z_276*z_246;
    const double z_524 = ak_ddot*z_132;
    const double z_525 = z_132*z_131 + z_130*z_492 - z_136*z_524 - z_130*z_132*z_225;
    const double z_526 = ak_ddot*z_127;
    const double z_527 = z_127*z_142 + z_144*z_526 + z_141*z_127*z_229 - z_141*z_497;
    const double z_528 = 0.3370146255514666*z_493 + 0.6593040822304*z_527 - 0.3296520411152*z_498 -
        0.6740292511029332*z_525;
    const double z_529 = sqrt(0.25*z_266);
    const double z_530 = i*z_529;
    const double z_531 = sin_ac*z_435;
    const double z_532 = cos_ac*z_434;
    const double z_533 = sin_ac*z_356;
    const double z_534 = cos_ac*z_319;
    const double z_535 = sin_ac*z_434 + sin_ac*z_319 + cos_ac*z_356 - cos_ac*z_435;
    const double z_536 = 2.0*z_530*z_531 + 2.0*z_530*z_532 + 2.0*z_530*z_534 - 2.0*z_530*z_533 - z_259*z_535;
    const double z_537 = g*z_535;
    const double z_538 = ac_ddot - 6.0*z_528*z_149;
    const double z_539 = c_*z_538;
    const double z_540 = z_536 - 2.0*z_537 - 4.0*z_539;
    const double z_541 = sin_ac*z_326 + cos_ac*z_361;
    const double z_542 = sin_ac*z_237 + cos_ac*z_238;
    const double z_543 = gravity*z_92;
    const double z_544 = i*z_170;
    const double z_545 = g*z_170;
    const double z_546 = h*z_170;
    const double z_547 = z_545 + z_546;
    const double z_548 = c_*z_114;
    const double z_549 = z_359 + z_548;
    const double z_550 = c_*z_110;
    const double z_551 = z_324 + z_550;
    const double z_552 = density*z_91;
    const double z_553 = z_536 - 2.0*z_539;
    const double z_554 = z_94 + 2.0*z_97;
    const double z_555 = z_537 + z_539;
    const double z_556 = z_93 + 2.0*z_99;
    D[74] = (1.0/12.0)*(12.0*sin_ac*lambda_2 + 12.0*sin_ac*lambda_4 + 2.0*z_314*z_517 + 4.0*z_129*z_518 +
        z_306*z_392 + 2.0*z_26*z_520 + 4.0*sin_ac*ag_ddot*z_522 + 4.0*cos_ac*ag_ddot*z_523 + 24.0*z_153*z_528 +
        z_10*z_541 + 2.0*z_115*z_542 + 6.0*cos_ac*(z_543 + (z_200 + z_543 + 2.0*z_544 + z_366 + 2.0*z_547)) +
        8.0*ac_ddot*z_551*z_496 + 8.0*ac_ddot*z_549*z_490 + 2.0*z_538*(z_105 + 6.0*z_552 + 4.0*c_*z_95 +
        2.0*z_104) + 2.0*z_555*z_556 - 12.0*cos_ac*lambda_3 - 12.0*cos_ac*lambda_5 - 2.0*z_332*z_516 -
        4.0*z_140*z_519 - z_306*z_394 - 2.0*z_26*z_521 - 4.0*sin_ac*z_323 - 4.0*cos_ac*z_358 - 4.0*sin_ac*z_203 -
        4.0*cos_ac*z_205 - 2.0*z_326*z_517 - 2.0*z_361*z_516 - 4.0*z_229*z_519 - 4.0*z_225*z_518 - z_96*z_540 -
        4.0*sin_ac*z_119*(z_549 - z_551) - z_553*z_554);
    const double z_557 = z_46*z_250;
    const double z_558 = z_49*z_250;
    const double z_559 = z_36*z_250;
    const double z_560 = z_1*z_250;
    D[75] = ((-1.0/6.0))*(z_557*z_485 + z_558*z_487 + 6.0*z_507*z_250 + z_560*z_485 + z_510*z_404 + d*z_515 +
        z_406*z_509 - z_559*z_487);
    D[76] = (1.0/6.0)*(e*z_515 - z_409*z_509);
    const double z_561 = ab_dot*z_92;
    const double z_562 = cos_ac*z_543;
    const double z_563 = z_276*z_132;
    const double z_564 = z_291*z_127;
    const double z_565 = 1.2057561424461514*z_493 - 0.1275771908871818*z_498;
    const double z_566 = 12.0*z_565*z_424 - c_*z_555;
    const double z_567 = 2.0*z_566 + z_405*z_509;
    D[77] = (1.0/12.0)*(z_392*z_561 + 6.0*z_562 + 4.0*z_415*z_563 + z_541*z_92 - z_394*z_561 - 4.0*z_416*z_564 -
        4.0*z_127*z_420 - 4.0*z_132*z_418 - 2.0*density*z_567);
    const double z_568 = z_97*z_256;
    const double z_569 = z_565*z_441;
    const double z_570 = 2.0*z_98 + z_103 + z_101;
    const double z_571 = z_530/z_266;
    const double z_572 = z_570*z_571;
    const double z_573 = 12.0*z_568*z_569 + (z_572*z_531 + z_572*z_532 + z_572*z_534 - z_572*z_533);
    const double z_574 = z_573*z_265;
    const double z_575 = 1.0/(g*z_254);
    const double z_576 = z_263*z_575;
    const double z_577 = z_257*z_262;
    const double z_578 = z_570*z_258;
    const double z_579 = 2.0*z_577*z_574 + z_535*z_578 - 12.0*z_565*(z_440 + z_442);
    const double z_580 = z_538*z_91;
    const double z_581 = z_566 - z_580;
    const double z_582 = 2.0*(2.0*z_100 + z_102 + z_101) - z_570*z_577;
    const double z_583 = z_562 + (1.0/6.0)*z_552*z_538;
    D[78] = (1.0/12.0)*(4.0*z_434*z_564 + 4.0*z_319*z_564 + 4.0*z_356*z_563 + 2.0*g*z_579 + 2.0*z_555*z_92 +
        12.0*z_565*(z_438 + 2.0*z_445) + z_535*z_582 + 12.0*z_583 - 4.0*z_435*z_563 - 2.0*z_574*z_576 -
        4.0*density*z_581);
    const double z_584 = c_*z_553 + 6.0*z_448*z_565;
    const double z_585 = 2.0*z_566 + z_584;
    D[79] = (1.0/12.0)*(12.0*z_562 - 24.0*z_452*z_565 - 2.0*h*z_579 - z_540*z_92 - 2.0*density*z_585);
    const double z_586 = z_570*z_529;
    const double z_587 = z_264/(i*z_256);
    const double z_588 = z_584 - 2.0*z_580;
    D[80] = ((-1.0/12.0))*(2.0*z_586*z_531 + 2.0*z_586*z_532 + 24.0*z_455*z_569 + 2.0*z_586*z_534 +
        2.0*z_573*z_587 + z_553*z_92 + 2.0*density*z_588 - 2.0*z_586*z_533 - 2.0*i*z_579 - 12.0*z_583);
    const double z_589 = 0.3186881138575668*z_525 - 0.34797855280909995*z_527;
    const double z_590 = z_589*z_233;
    const double z_591 = 2.0*z_509*z_2 - 3.0*z_590;
    D[81] = ((-1.0/3.0))*(density*z_591);
    const double z_592 = z_580 + 3.0*z_590;
    D[82] = (1.0/6.0)*(z_92*z_520 + 3.0*z_562 + 2.0*z_132*z_186 + z_542*z_191 + 2.0*density*z_592 - z_92*z_521 -
        2.0*z_127*z_188 - 2.0*z_189*z_526 - 2.0*z_190*z_524);
    D[84] = ((-1.0/6.0))*(2.0*z_237*z_110*z_127 + 2.0*z_238*z_114*z_132 + sin_ac*z_210*(2.0*z_550 - z_197) +
        12.0*z_239*z_589 - z_197*z_542 - cos_ac*z_236*(2.0*z_548 - z_197));
    const double z_593 = c_*h;
    const double z_594 = c_*i;
    const double z_595 = c_*g;
    const double z_596 = c_*gravity;
    D[85] = (1.0/12.0)*(z_307*z_465 + 2.0*k*z_67*z_127 + 2.0*z_555*z_595 + z_541*z_470 + 2.0*z_542*z_214 +
        4.0*k*z_592 + 6.0*cos_ac*(f*z_596 + 2.0*h*z_596 + 2.0*i*z_596 + gravity*z_91 + 2.0*g*z_596 + k*z_596) +
        2.0*z_538*(2.0*c_*z_91 + i*z_91 + g*z_91) - z_307*z_466 - 2.0*k*z_52*z_132 - 24.0*z_565*z_468 -
        z_540*z_593 - z_553*z_594 - 2.0*h*z_585 - 2.0*i*z_588 - 4.0*g*z_581 - 2.0*f*z_567 - 4.0*j*z_591 -
        2.0*z_472*z_509);
    D[86] = 3.0*(z_589*z_181);
    D[88] = 0.5*(cos_ac*(z_315 + 2.0*z_101 + z_552 + z_197 + 2.0*z_104));
    const double z_597 = cos_af*cos_af;
    const double z_598 = af_ddot*(f*f);
    const double z_599 = z_332*z_337 + 2.0*z_333*z_597*z_598 + z_361*z_337 - 2.0*z_311*z_336 - 2.0*z_133*z_337;
    const double z_600 = sin_af*sin_af;
    const double z_601 = z_314*z_347 + 2.0*z_321*z_346 + 2.0*z_143*z_347 - 2.0*z_343*z_600*z_598 - z_326*z_347;
    const double z_602 = z_494*z_599 - z_499*z_601;
    const double z_603 = z_505*z_599 - z_506*z_601;
    const double z_604 = z_376*z_599 - z_377*z_601;
    const double z_605 = (z_502*z_357 + z_503*z_322 + z_508*z_357 - z_504*z_322 - 3.0*z_603*z_364) - z_604*z_21;
    const double z_606 = z_511*z_357 + 6.0*z_602*z_13 - z_512*z_322 - z_513*z_322 - z_514*z_357 - 2.0*z_605*z_383
        - z_384*z_604;
    D[91] = (1.0/6.0)*(z_484*z_357 + 6.0*z_602*z_244 - z_486*z_322 - z_488*z_322 - z_501*z_357 - 2.0*z_605*z_382 -
        2.0*b*z_606 - z_391*z_604);
    const double z_607 = 0.3370146255514666*z_599 - 0.3296520411152*z_601;
    D[92] = (1.0/3.0)*(z_122*z_357 - z_119*z_322 - z_90*z_322 - z_112*z_357 - 3.0*z_157*z_607);
    D[93] = ((-1.0/6.0))*(2.0*z_557*z_357 + 2.0*z_558*z_322 + 2.0*z_560*z_357 + 2.0*z_605*z_404 + 2.0*d*z_606 -
        2.0*z_559*z_322 - 6.0*z_603*z_250 - z_406*z_604);
    D[94] = (1.0/6.0)*(2.0*e*z_606 + z_409*z_604);
    const double z_608 = f*af_ddot;
    const double z_609 = 1.2057561424461514*z_599 - 0.1275771908871818*z_601;
    const double z_610 = z_607*z_154;
    const double z_611 = 2.0*z_609*z_424 + z_610;
    const double z_612 = 12.0*z_611 + z_405*z_604;
    D[95] = ((-1.0/6.0))*(6.0*sin_af*lambda_4 + z_314*z_419 + 2.0*ag_ddot*z_282*z_419 + 2.0*ag_ddot*z_246*z_417 +
        2.0*z_143*z_419 + 2.0*z_133*z_417 - 6.0*cos_af*lambda_5 - z_332*z_417 - 4.0*z_291*z_600*z_608 -
        4.0*z_276*z_597*z_608 - z_361*z_417 - z_326*z_419 - density*z_612 - 2.0*cos_af*z_415*(f*z_291 - f*z_276));
    const double z_613 = z_155*z_607;
    const double z_614 = z_610 + z_611;
    D[96] = (1.0/3.0)*(z_435*z_357 + 6.0*z_613 + 6.0*density*z_614 - z_434*z_322 - z_319*z_322 - z_356*z_357 -
        3.0*z_446*z_609);
    const double z_615 = 2.0*z_610 + z_448*z_609;
    const double z_616 = 2.0*z_611 + z_615;
    D[97] = 2.0*z_613 + density*z_616 + 2.0*z_453*z_609;
    const double z_617 = 2.0*z_610 + z_615;
    D[98] = 2.0*z_613 + density*z_617 + 2.0*z_456*z_609;
    D[99] = (2.0/3.0)*(z_390*z_604);
    D[100] = 2.0*z_613;
    const double z_618 = z_215 + k*z_154;
    const double z_619 = 4.0*j*z_2 + 4.0*z_471;
    D[103] = (1.0/6.0)*(12.0*z_609*z_468 + 6.0*h*z_616 + 6.0*i*z_617 + 12.0*g*z_614 + f*z_612 + 12.0*z_607*(z_217
        + z_618) + z_604*z_619);
    const double z_620 = cos_ag*z_355;
    const double z_621 = sin_ag*z_318;
    const double z_622 = cos_ag*cos_ag;
    const double z_623 = ag_ddot*z_254;
    const double z_624 = z_332*z_335 + 2.0*af_ddot*z_311*z_335 + z_361*z_335 - 2.0*z_333*z_622*z_623 -
        2.0*z_133*z_335;
    const double z_625 = sin_ag*sin_ag;
    const double z_626 = z_314*z_345 + 2.0*z_343*z_625*z_623 + 2.0*z_143*z_345 - 2.0*af_ddot*z_321*z_345 -
        z_326*z_345;
    const double z_627 = z_494*z_624 - z_499*z_626;
    const double z_628 = z_505*z_624 - z_506*z_626;
    const double z_629 = z_376*z_624 - z_377*z_626;
    const double z_630 = (z_502*z_620 + z_503*z_621 + 6.0*z_628*z_364 + z_508*z_620 - z_504*z_621) +
        2.0*z_629*z_21;
    const double z_631 = z_511*z_620 + 2.0*z_384*z_629 - z_512*z_621 - z_513*z_621 - 12.0*z_627*z_13 - z_514*z_620
        - 2.0*z_630*z_383;
    D[109] = (1.0/12.0)*(z_484*z_620 + 2.0*z_391*z_629 - z_486*z_621 - z_488*z_621 - 12.0*z_627*z_244 -
        z_501*z_620 - 2.0*z_630*z_382 - 2.0*b*z_631);
    const double z_632 = cos_ag*z_119;
    const double z_633 = sin_ag*z_122;
    const double z_634 = cos_ag*z_90;
    const double z_635 = sin_ag*z_112;
    const double z_636 = sin_ag*z_119 + sin_ag*z_90 + cos_ag*z_112 - cos_ag*z_122;
    const double z_637 = 2.0*z_530*z_632 + 2.0*z_530*z_633 + 2.0*z_530*z_634 + z_259*z_636 - 2.0*z_530*z_635;
    const double z_638 = g*z_636;
    const double z_639 = 0.3370146255514666*z_624 - 0.3296520411152*z_626;
    const double z_640 = z_639*z_151;
    const double z_641 = z_637 + 2.0*z_638 - 24.0*z_640;
    const double z_642 = z_637 - 12.0*z_640;
    const double z_643 = z_638 - 6.0*z_640;
    D[110] = ((-1.0/12.0))*(4.0*z_122*z_523 - 4.0*z_119*z_522 - 4.0*z_90*z_522 - 4.0*z_112*z_523 - z_96*z_641 -
        12.0*z_639*(2.0*z_156 - 2.0*z_152) - z_554*z_642 - 2.0*z_556*z_643);
    D[111] = ((-1.0/6.0))*(z_557*z_620 + z_558*z_621 + 6.0*z_628*z_250 + z_560*z_620 + z_630*z_404 + d*z_631 +
        z_406*z_629 - z_559*z_621);
    D[112] = (1.0/6.0)*(e*z_631 - z_409*z_629);
    const double z_644 = z_308*z_282;
    const double z_645 = z_330*z_246;
    const double z_646 = sin_ag*z_326 + cos_ag*z_361;
    const double z_647 = 1.2057561424461514*z_624 - 0.1275771908871818*z_626;
    const double z_648 = ag_ddot - 12.0*z_647*z_441;
    const double z_649 = z_648*z_254 + c_*z_643;
    const double z_650 = 2.0*z_649 - z_405*z_629;
    D[113] = (1.0/12.0)*(z_412*z_644 + 6.0*z_246*z_170 + 4.0*z_415*z_523 + z_93*z_646 + 2.0*density*z_650 -
        z_412*z_645 - 4.0*z_416*z_522 - 4.0*z_282*z_420 - 4.0*z_246*z_418);
    const double z_651 = cos_ag*z_276;
    const double z_652 = sin_ag*z_291;
    const double z_653 = g*ag_ddot;
    const double z_654 = z_544 + z_546;
    const double z_655 = z_648*z_568 + (z_572*z_632 + z_572*z_633 + z_572*z_634 - 3.0*sin_ag*z_654*z_571 -
        z_572*z_635);
    const double z_656 = z_655*z_265;
    const double z_657 = 2.0*z_577*z_656 - z_636*z_578 - 3.0*cos_ag*(z_544*z_258 + z_546*z_258) - z_648*(z_96 +
        z_261*z_258 + z_97*z_577);
    const double z_658 = z_155*z_639;
    const double z_659 = z_639*z_154;
    const double z_660 = z_649 - 6.0*z_659;
    D[114] = (1.0/12.0)*(12.0*sin_ag*lambda_4 + 2.0*z_314*z_652 + z_306*z_429 + 8.0*z_291*z_625*z_653 +
        8.0*z_276*z_622*z_653 + 4.0*z_143*z_652 + 4.0*z_133*z_651 + 24.0*z_444*z_647 + 2.0*z_656*z_576 +
        2.0*z_643*z_92 + 4.0*density*z_660 + z_10*z_646 + 3.0*cos_ag*(2.0*(z_545 + z_366) + 2.0*z_547 -
        z_544*z_577 - z_546*z_577) + z_648*(4.0*z_255 + z_260 - z_261*z_577 - z_575*z_436) + z_582*z_636 -
        12.0*cos_ag*lambda_5 - 2.0*z_332*z_651 - z_306*z_430 - 4.0*sin_ag*z_323 - 4.0*cos_ag*z_358 -
        2.0*z_326*z_652 - 2.0*z_361*z_651 - 2.0*g*z_657 - 12.0*z_658 - 4.0*sin_ag*z_434*(z_354 - z_317));
    const double z_661 = 2.0*g + z_259;
    const double z_662 = cos_ag*z_170;
    const double z_663 = z_170*z_530;
    const double z_664 = z_257*z_648;
    const double z_665 = 2.0*c_*z_642 + z_648*(z_447 + z_264);
    const double z_666 = 4.0*z_649 + z_665;
    D[115] = (1.0/12.0)*(3.0*z_661*z_662 + 2.0*density*z_664 + 2.0*h*z_657 + z_641*z_92 + density*z_666 -
        6.0*sin_ag*z_663);
    const double z_667 = z_665 - 24.0*z_659;
    D[116] = (1.0/12.0)*(2.0*z_586*z_632 + 2.0*z_586*z_633 + 3.0*z_259*z_662 + 2.0*z_648*z_455 + 2.0*z_586*z_634 +
        2.0*z_655*z_587 + z_642*z_92 + density*z_667 - 2.0*z_586*z_635 - 2.0*i*z_657 - 12.0*z_658 -
        6.0*sin_ag*(z_663 + z_654*z_529));
    D[117] = ((-2.0/3.0))*(z_390*z_629);
    D[118] = (-2.0)*z_658;
    const double z_668 = h*gravity;
    const double z_669 = z_256*z_529;
    D[121] = (1.0/12.0)*(z_307*z_644 + 2.0*h*z_664 + z_641*z_593 + z_642*z_594 + 2.0*z_643*z_595 + h*z_666 +
        i*z_667 + 4.0*g*z_660 + z_646*z_469 + 2.0*f*z_650 + 3.0*cos_ag*(z_661*z_668 + i*gravity*z_259 +
        2.0*gravity*z_469 + 2.0*gravity*z_254) - z_307*z_645 - 6.0*sin_ag*(z_530*z_668 + gravity*z_669) -
        12.0*z_639*(z_216 + 2.0*z_618) - 2.0*z_619*z_629);
    D[124] = 0.25*(cos_ag*(2.0*z_316 + z_96*z_661 + z_94*z_259 + 2.0*density*z_254) - 2.0*sin_ag*(z_96*z_530 +
        density*z_669));
    D[127] = z_46 + z_1;
    D[135] = -(z_68 + sin_aj*aj_ddot);
    D[138] = -(z_210 + z_237);
    D[145] = z_49 - z_36;
    D[153] = -(z_55 - cos_aj*aj_ddot);
    D[156] = -(z_236 - z_238);
    D[164] = z_119 + z_90;
    D[172] = -(z_187 + sin_ak*ak_ddot);
    D[174] = -(z_210 + z_237);
    D[182] = z_122 - z_112;
    D[190] = -(z_185 - cos_ak*ak_ddot);
    D[192] = -(z_236 - z_238);
    const double z_670 = z_503 - z_504;
    const double z_671 = z_512 + z_513 + 2.0*z_670*z_383;
    D[199] = 0.5*(z_486 + z_488 + 2.0*z_670*z_382 - 2.0*b*z_671);
    D[200] = z_119 + z_90;
    D[201] = z_558 + z_670*z_404 - z_559 - d*z_671;
    D[202] = e*z_671;
    D[203] = -(z_416 + sin_af*af_ddot);
    D[204] = z_434 + z_319;
    const double z_672 = z_502 + z_508;
    const double z_673 = z_511 - z_514 - 2.0*z_672*z_383;
    D[217] = 0.5*(z_484 - z_501 - 2.0*z_672*z_382 - 2.0*b*z_673);
    D[218] = z_122 - z_112;
    D[219] = -(z_557 + z_560 + z_672*z_404 + d*z_673);
    D[220] = e*z_673;
    D[221] = -(z_415 - cos_af*af_ddot);
    D[222] = z_435 - z_356;
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
    const double J = parameters[14];
    const double density = parameters[13];
    const double j = parameters[9];
    const double z_0 = density*j;
    const double k = parameters[10];
    const double z_1 = density*k;
    const double m = parameters[12];
    const double z_2 = m*m;
    const double z_3 = 3.0*J + (z_0 + z_1)*z_2;
    prepared[17] = z_3; /* c_0 */
    const double b = parameters[1];
    const double z_4 = b*b;
    const double z_5 = density*b;
    const double e = parameters[4];
    const double z_6 = density*e;
    const double d = parameters[3];
    const double z_7 = d*d;
    const double z_8 = z_4 + z_7 - e*e;
    const double f = parameters[5];
    const double z_9 = density*f;
    const double z_10 = z_6 + density*d + z_9;
    const double z_11 = z_8/b;
    const double z_12 = 4.0 - z_8*z_8/(z_4*z_7);
    const double z_13 = 4.0*z_4*z_5 + 4.0*(z_0 + z_6)*z_4 + z_6*z_8 + (e*z_5 + z_10*z_11)*z_11 + z_10*z_12*z_7;
    const double z_14 = 1.0/z_13;
    const double z_15 = z_4*z_14;
    const double z_16 = z_2/z_3;
    const double z_17 = 1.0/(1.7189244238450625*z_15 + 0.9560643415727004*z_16);
    const double c_ = parameters[2];
    const double z_18 = c_*c_;
    const double z_19 = density*c_;
    const double g = parameters[6];
    const double z_20 = density*g;
    const double i = parameters[8];
    const double z_21 = density*i;
    const double h = parameters[7];
    const double z_22 = h*z_19;
    const double z_23 = density*h;
    const double z_24 = z_21 + z_23;
    const double z_25 = c_*z_24 + 0.5*i*z_19;
    const double z_26 = z_9 + z_20 + z_23;
    const double z_27 = c_*z_26 + 0.5*g*z_19;
    const double z_28 = 2.0*z_18*z_19 + 2.0*(z_1 + z_20 + z_21)*z_18 + c_*(2.0*z_22 + 2.0*z_25 + 2.0*z_27) +
        z_20*z_18 + z_21*z_18;
    const double z_29 = z_18/z_28;
    const double z_30 = 1.0/(0.9560643415727004*z_16 + 2.0220877533087998*z_29);
    const double z_31 = z_2*z_17 + z_2*z_30;
    prepared[18] = z_31; /* c_1 */
    const double z_32 = 1.0/(6.281075576154938*z_15 + 1.0439356584272999*z_16);
    const double z_33 = 1.0/(1.0439356584272999*z_16 + 1.9779122466912002*z_29);
    const double z_34 = z_2*z_32 + z_2*z_33;
    prepared[19] = z_34; /* c_2 */
    const double z_35 = m*j;
    prepared[20] = z_17*z_35; /* c_3 */
    prepared[21] = z_32*z_35; /* c_4 */
    const double z_36 = j*j;
    const double z_37 = z_17*z_36;
    prepared[22] = z_37; /* c_5 */
    const double z_38 = z_32*z_36;
    prepared[23] = z_38; /* c_6 */
    const double z_39 = z_35*z_5;
    const double z_40 = b*z_17;
    prepared[24] = z_39 - 2.0*m*z_40; /* c_7 */
    const double z_41 = b*z_32;
    prepared[25] = z_39 - 2.0*m*z_41; /* c_8 */
    prepared[26] = j*z_40; /* c_9 */
    prepared[27] = j*z_41; /* c_10 */
    prepared[28] = z_13; /* c_11 */
    const double z_42 = g*g;
    const double z_43 = i*i;
    const double z_44 = z_42 + z_43 - h*h;
    const double z_45 = z_44/g;
    const double z_46 = 4.0 - z_44*z_44/(z_42*z_43);
    const double z_47 = g*(4.0*g*z_26 + z_23*z_45) + (z_20*h + z_24*z_45)*z_45 + z_24*z_46*z_43;
    const double z_48 = z_42/z_47;
    const double z_49 = d*sqrt(0.25*z_12);
    const double z_50 = 0.6245840315389466*z_11 + 1.5619152186294316*z_49;
    const double z_51 = 0.19906253667584417*z_11 - 1.959973577875149*z_49;
    const double z_52 = 1.0/(2.0220877533087998*z_29 + 7.234536854676909*z_48 + z_14*(z_50*z_50) +
        z_14*(z_51*z_51));
    prepared[29] = z_52; /* c_12 */
    prepared[30] = z_11; /* c_13 */
    prepared[31] = 2.0*z_49; /* c_14 */
    const double z_53 = 0.9799867889375745*z_11 + 0.39812507335168834*z_49;
    const double z_54 = 0.7809576093147158*z_11 - 1.2491680630778932*z_49;
    const double z_55 = 1.0/(1.9779122466912002*z_29 + z_14*(z_53*z_53) + z_14*(z_54*z_54) +
        0.7654631453230909*z_48);
    prepared[32] = z_55; /* c_15 */
    const double z_56 = z_4*z_17;
    prepared[33] = 4.0*z_56; /* c_16 */
    const double z_57 = z_4*z_32;
    prepared[34] = 4.0*z_57; /* c_17 */
    const double z_58 = m*k;
    prepared[35] = z_30*z_58; /* c_18 */
    prepared[36] = z_33*z_58; /* c_19 */
    const double z_59 = k*k;
    const double z_60 = z_30*z_59;
    prepared[37] = z_60; /* c_20 */
    const double z_61 = z_33*z_59;
    prepared[38] = z_61; /* c_21 */
    const double z_62 = z_19*z_58;
    const double z_63 = c_*z_30;
    prepared[39] = z_62 - 2.0*m*z_63; /* c_22 */
    const double z_64 = c_*z_33;
    prepared[40] = z_62 - 2.0*m*z_64; /* c_23 */
    const double z_65 = f*z_19;
    const double z_66 = c_*z_52;
    prepared[41] = z_65 - 2.0*z_66; /* c_24 */
    const double z_67 = c_*z_55;
    prepared[42] = z_65 - 2.0*z_67; /* c_25 */
    prepared[43] = k*z_63; /* c_26 */
    prepared[44] = k*z_64; /* c_27 */
    prepared[45] = z_28; /* c_28 */
    const double z_68 = z_18*z_30 + z_18*z_52;
    prepared[46] = 2.0*z_68; /* c_29 */
    const double z_69 = z_18*z_33 + z_18*z_55;
    prepared[47] = 2.0*z_69; /* c_30 */
    prepared[48] = f*z_55; /* c_31 */
    prepared[49] = f*z_52; /* c_32 */
    prepared[50] = f*z_66; /* c_33 */
    prepared[51] = f*z_67; /* c_34 */
    const double z_70 = f*f;
    const double z_71 = z_52*z_70;
    prepared[52] = z_71; /* c_35 */
    const double z_72 = z_55*z_70;
    prepared[53] = z_72; /* c_36 */
    const double z_73 = f*z_20;
    const double z_74 = g*z_52;
    prepared[54] = z_73 - 2.0*z_74; /* c_37 */
    const double z_75 = g*z_55;
    prepared[55] = z_73 - 2.0*z_75; /* c_38 */
    const double z_76 = z_22 + 2.0*z_25;
    const double z_77 = 2.0*g*(z_22 + 2.0*z_27) + z_76*z_45;
    prepared[56] = z_77 + 4.0*g*z_66; /* c_39 */
    prepared[57] = z_77 + 4.0*g*z_67; /* c_40 */
    const double z_78 = i*sqrt(0.25*z_46);
    const double z_79 = z_76*z_78;
    prepared[58] = 2.0*z_79; /* c_41 */
    const double z_80 = f*g;
    prepared[59] = z_52*z_80; /* c_42 */
    prepared[60] = z_55*z_80; /* c_43 */
    prepared[61] = z_47; /* c_44 */
    const double z_81 = z_42*z_52;
    prepared[62] = 4.0*z_81; /* c_45 */
    const double z_82 = z_42*z_55;
    prepared[63] = 4.0*z_82; /* c_46 */
    prepared[64] = (2.0/3.0)*(z_31 - z_34); /* c_47 */
    prepared[65] = (2.0/3.0)*(z_37 - z_38); /* c_48 */
    prepared[66] = 4.0*(z_56 - z_57); /* c_49 */
    prepared[67] = (2.0/3.0)*(z_60 - z_61); /* c_50 */
    prepared[68] = (2.0/3.0)*(z_68 - z_69); /* c_51 */
    prepared[69] = (2.0/3.0)*(z_71 - z_72); /* c_52 */
    prepared[70] = z_79; /* c_53 */
    prepared[71] = (2.0/3.0)*(z_81 - z_82); /* c_54 */
    prepared[72] = z_39; /* c_55 */
    prepared[73] = z_62; /* c_56 */
    const double gravity = parameters[16];
    const double z_83 = density*gravity;
    const double z_84 = k*z_83;
    const double z_85 = j*z_83;
    prepared[74] = m*(z_84 + z_85); /* c_57 */
    const double torque = parameters[15];
    prepared[75] = 2.0*torque; /* c_58 */
    prepared[76] = m*z_32; /* c_59 */
    prepared[77] = m*z_17; /* c_60 */
    prepared[78] = m*z_33; /* c_61 */
    prepared[79] = m*z_30; /* c_62 */
    prepared[80] = j*z_32; /* c_63 */
    prepared[81] = j*z_17; /* c_64 */
    prepared[82] = z_65; /* c_65 */
    prepared[83] = z_73; /* c_66 */
    const double z_86 = 2.0*b + z_11;
    const double z_87 = e*z_83;
    const double z_88 = f*z_83;
    const double z_89 = z_88 + d*z_83;
    prepared[84] = z_86*z_87 + 2.0*b*(z_85 + b*z_83) + z_11*z_89; /* c_67 */
    prepared[85] = 2.0*(z_49*(z_87 + z_89)); /* c_68 */
    prepared[86] = 2.0*c_; /* c_69 */
    prepared[87] = 2.0*g; /* c_70 */
    prepared[88] = 2.0*f; /* c_71 */
    prepared[89] = 4.0*z_41; /* c_72 */
    prepared[90] = 4.0*z_40; /* c_73 */
    prepared[91] = k*z_33; /* c_74 */
    prepared[92] = k*z_30; /* c_75 */
    prepared[93] = z_77; /* c_76 */
    const double z_90 = g*z_83;
    const double z_91 = i*z_83;
    const double z_92 = h*z_83;
    const double z_93 = z_91 + z_92;
    prepared[94] = 6.0*(c_*(z_84 + 2.0*z_90 + c_*z_83 + 2.0*z_93 + z_88)); /* c_77 */
    prepared[95] = z_67; /* c_78 */
    prepared[96] = z_66; /* c_79 */
    prepared[97] = 2.0*z_64; /* c_80 */
    prepared[98] = 2.0*z_63; /* c_81 */
    const double z_94 = 2.0*g + z_45;
    prepared[99] = z_45*z_91 + z_94*z_92 + 2.0*g*(z_90 + z_88); /* c_82 */
    prepared[100] = 2.0*(z_78*z_93); /* c_83 */
    prepared[101] = z_75; /* c_84 */
    prepared[102] = z_74; /* c_85 */
    prepared[103] = (1.0/3.0)*z_3; /* c_86 */
    prepared[104] = (1.0/12.0)*z_13; /* c_87 */
    prepared[105] = (1.0/6.0)*z_28; /* c_88 */
    prepared[106] = (1.0/12.0)*z_47; /* c_89 */
    prepared[107] = fabs(j); /* c_90 */
    prepared[108] = fabs(b); /* c_91 */
    prepared[109] = fabs(m); /* c_92 */
    const double a_ = parameters[0];
    prepared[110] = fabs(a_); /* c_93 */
    const double l = parameters[11];
    prepared[111] = fabs(l); /* c_94 */
    prepared[112] = fabs(k); /* c_95 */
    const double z_95 = fabs(c_);
    prepared[113] = z_95; /* c_96 */
    prepared[114] = fabs(z_11); /* c_97 */
    prepared[115] = 2.0*z_95; /* c_98 */
    prepared[116] = 2.0*fabs(z_49); /* c_99 */
    prepared[117] = 2.0*fabs(f); /* c_100 */
    prepared[118] = 2.0*fabs(g); /* c_101 */
    prepared[119] = 2.0*z_3; /* c_102 */
    prepared[120] = 2.0*z_28; /* c_103 */
    prepared[121] = (-4.0)*l; /* c_104 */
    prepared[122] = z_86; /* c_105 */
    prepared[123] = z_94; /* c_106 */
    prepared[124] = 2.0*z_78; /* c_107 */
    prepared[125] = 4.0*c_; /* c_108 */
    prepared[126] = z_45; /* c_109 */
    prepared[127] = 2.0*b; /* c_110 */
    prepared[128] = (-2.0)*l; /* c_111 */
    prepared[129] = 2.0*j; /* c_112 */
    prepared[130] = 2.0*k; /* c_113 */
    prepared[131] = z_83; /* c_114 */
    prepared[132] = 4.0*torque; /* c_115 */
    prepared[133] = -a_; /* c_116 */
    prepared[134] = -l; /* c_117 */
    prepared[135] = (-2.0)*a_; /* c_118 */
    prepared[136] = (1.0/10.0)*m; /* c_119 */
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
    const double c_86 = c[103];
    M[0] = c_86;
    M[7] = M[1] = 0.0;
    M[8] = 0.0;
    const double c_55 = c[72];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double sin_theta = em_sin(theta);
    M[14] = M[2] = (1.0/6.0)*(c_55*(cos_ab*cos_theta + sin_ab*sin_theta));
    M[15] = M[9] = 0.0;
    const double c_87 = c[104];
    M[16] = c_87;
    M[21] = M[3] = 0.0;
    M[22] = M[10] = 0.0;
    M[23] = M[17] = 0.0;
    M[24] = 0.0;
    const double c_56 = c[73];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double sin_ac = em_sin(ac);
    M[28] = M[4] = (1.0/6.0)*(c_56*(cos_theta*cos_ac + sin_theta*sin_ac));
    M[29] = M[11] = 0.0;
    const double c_65 = c[82];
    const double c_13 = c[30];
    const double c_14 = c[31];
    const double z_6 = cos_ab*c_13 - sin_ab*c_14;
    const double z_7 = sin_ab*c_13 + cos_ab*c_14;
    M[30] = M[18] = (1.0/12.0)*(c_65*(cos_ac*z_6 + sin_ac*z_7));
    M[31] = M[25] = 0.0;
    const double c_88 = c[105];
    M[32] = c_88;
    M[35] = M[5] = 0.0;
    M[36] = M[12] = 0.0;
    M[37] = M[19] = 0.0;
    M[38] = M[26] = 0.0;
    M[39] = M[33] = 0.0;
    M[40] = 0.0;
    M[42] = M[6] = 0.0;
    M[43] = M[13] = 0.0;
    const double c_66 = c[83];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    M[44] = M[20] = (1.0/12.0)*(c_66*(z_6*cos_ag + z_7*sin_ag));
    M[45] = M[27] = 0.0;
    const double c_76 = c[93];
    const double c_41 = c[58];
    M[46] = M[34] = (1.0/12.0)*(cos_ac*cos_ag*c_76 + sin_ac*sin_ag*c_76 + c_41*(sin_ac*cos_ag) -
        c_41*(cos_ac*sin_ag));
    M[47] = M[41] = 0.0;
    const double c_89 = c[106];
    M[48] = c_89;
}

/* M + A^T W A (n, n), which is factored in place of M: M is singular, but not along the constraints */
EM_ACROSS void factored_matrix(double t, const double *restrict x, const double *restrict c,
                               double *restrict M)
{
    const double c_0 = c[17];
    const double c_1 = c[18];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double c_2 = c[19];
    const double sin_theta = em_sin(theta);
    M[0] = (1.0/3.0)*(c_0 + c_1*(cos_theta*cos_theta) + c_2*(sin_theta*sin_theta));
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double c_3 = c[20];
    const double sin_aj = em_sin(aj);
    const double c_4 = c[21];
    M[7] = M[1] = (1.0/3.0)*(cos_theta*cos_aj*c_3 + sin_theta*sin_aj*c_4);
    const double c_5 = c[22];
    const double c_6 = c[23];
    M[8] = (1.0/3.0)*(c_5*(cos_aj*cos_aj) + c_6*(sin_aj*sin_aj));
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double c_7 = c[24];
    const double sin_ab = em_sin(ab);
    const double c_8 = c[25];
    M[14] = M[2] = (1.0/6.0)*(cos_ab*cos_theta*c_7 + sin_ab*sin_theta*c_8);
    const double c_9 = c[26];
    const double c_10 = c[27];
    M[15] = M[9] = ((-1.0/3.0))*(cos_ab*cos_aj*c_9 + sin_ab*sin_aj*c_10);
    const double c_11 = c[28];
    const double c_12 = c[29];
    const double c_13 = c[30];
    const double c_14 = c[31];
    const double z_6 = cos_ab*c_13 - sin_ab*c_14;
    const double c_15 = c[32];
    const double z_7 = sin_ab*c_13 + cos_ab*c_14;
    const double c_16 = c[33];
    const double c_17 = c[34];
    M[16] = (1.0/12.0)*(c_11 + c_12*(z_6*z_6) + c_15*(z_7*z_7) + c_16*(cos_ab*cos_ab) + c_17*(sin_ab*sin_ab));
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double c_18 = c[35];
    const double sin_ak = em_sin(ak);
    const double c_19 = c[36];
    M[21] = M[3] = (1.0/3.0)*(cos_theta*cos_ak*c_18 + sin_theta*sin_ak*c_19);
    M[22] = M[10] = 0.0;
    M[23] = M[17] = 0.0;
    const double c_20 = c[37];
    const double c_21 = c[38];
    M[24] = (1.0/3.0)*(c_20*(cos_ak*cos_ak) + c_21*(sin_ak*sin_ak));
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_22 = c[39];
    const double sin_ac = em_sin(ac);
    const double c_23 = c[40];
    M[28] = M[4] = (1.0/6.0)*(cos_theta*cos_ac*c_22 + sin_theta*sin_ac*c_23);
    M[29] = M[11] = 0.0;
    const double c_24 = c[41];
    const double c_25 = c[42];
    M[30] = M[18] = (1.0/12.0)*(cos_ac*z_6*c_24 + sin_ac*z_7*c_25);
    const double c_26 = c[43];
    const double c_27 = c[44];
    M[31] = M[25] = ((-1.0/3.0))*(cos_ac*cos_ak*c_26 + sin_ac*sin_ak*c_27);
    const double c_28 = c[45];
    const double c_29 = c[46];
    const double c_30 = c[47];
    M[32] = (1.0/6.0)*(c_28 + c_29*(cos_ac*cos_ac) + c_30*(sin_ac*sin_ac));
    M[35] = M[5] = 0.0;
    M[36] = M[12] = 0.0;
    const double af = x[5];
    const double sin_af = em_sin(af);
    const double c_31 = c[48];
    const double cos_af = em_cos(af);
    const double c_32 = c[49];
    M[37] = M[19] = (1.0/6.0)*(z_7*sin_af*c_31 + z_6*cos_af*c_32);
    M[38] = M[26] = 0.0;
    const double c_33 = c[50];
    const double c_34 = c[51];
    M[39] = M[33] = ((-1.0/3.0))*(cos_ac*cos_af*c_33 + sin_ac*sin_af*c_34);
    const double c_35 = c[52];
    const double c_36 = c[53];
    M[40] = (1.0/3.0)*(c_35*(cos_af*cos_af) + c_36*(sin_af*sin_af));
    M[42] = M[6] = 0.0;
    M[43] = M[13] = 0.0;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_37 = c[54];
    const double sin_ag = em_sin(ag);
    const double c_38 = c[55];
    M[44] = M[20] = (1.0/12.0)*(z_6*cos_ag*c_37 + z_7*sin_ag*c_38);
    M[45] = M[27] = 0.0;
    const double c_39 = c[56];
    const double c_40 = c[57];
    const double c_41 = c[58];
    M[46] = M[34] = ((-1.0/12.0))*(c_41*(cos_ac*sin_ag) - cos_ac*cos_ag*c_39 - sin_ac*sin_ag*c_40 -
        c_41*(sin_ac*cos_ag));
    const double c_42 = c[59];
    const double c_43 = c[60];
    M[47] = M[41] = ((-1.0/3.0))*(cos_ag*cos_af*c_42 + sin_ag*sin_af*c_43);
    const double c_44 = c[61];
    const double c_45 = c[62];
    const double c_46 = c[63];
    M[48] = (1.0/12.0)*(c_44 + c_45*(cos_ag*cos_ag) + c_46*(sin_ag*sin_ag));
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
    const double c_13 = c[30];
    const double c_14 = c[31];
    A[30] = (-0.5)*(sin_ab*c_13 + cos_ab*c_14);
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
    A[37] = 0.5*(cos_ab*c_13 - sin_ab*c_14);
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
    const double c_13 = c[30];
    const double c_14 = c[31];
    const double c_69 = c[86];
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double c_71 = c[88];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_70 = c[87];
    phi[4] = 0.5*(cos_ab*c_13 + cos_af*c_71 - sin_ab*c_14 - cos_ac*c_69 - cos_ag*c_70);
    const double sin_af = em_sin(af);
    const double sin_ag = em_sin(ag);
    phi[5] = 0.5*(sin_ab*c_13 + cos_ab*c_14 + sin_af*c_71 - sin_ac*c_69 - sin_ag*c_70);
    const double c_90 = c[107];
    const double c_91 = c[108];
    const double z_16 = fabs(cos_ab) + fabs(ab*sin_ab);
    const double c_92 = c[109];
    const double c_93 = c[110];
    const double z_17 = c_92*(fabs(cos_theta) + fabs(theta*sin_theta)) + c_93;
    terms[0] = c_90*(fabs(cos_aj) + fabs(aj*sin_aj)) + c_91*z_16 + z_17;
    const double z_18 = fabs(sin_ab) + fabs(ab*cos_ab);
    const double c_94 = c[111];
    const double z_19 = c_92*(fabs(sin_theta) + fabs(theta*cos_theta)) + c_94;
    terms[1] = c_90*(fabs(sin_aj) + fabs(aj*cos_aj)) + c_91*z_18 + z_19;
    const double c_95 = c[112];
    const double c_96 = c[113];
    const double z_20 = fabs(cos_ac) + fabs(ac*sin_ac);
    terms[2] = c_95*(fabs(cos_ak) + fabs(ak*sin_ak)) + c_96*z_20 + z_17;
    const double z_21 = fabs(sin_ac) + fabs(ac*cos_ac);
    terms[3] = c_95*(fabs(sin_ak) + fabs(ak*cos_ak)) + c_96*z_21 + z_19;
    const double c_97 = c[114];
    const double c_98 = c[115];
    const double c_99 = c[116];
    const double c_100 = c[117];
    const double c_101 = c[118];
    terms[4] = 0.5*(z_16*c_97 + z_20*c_98 + z_18*c_99 + (fabs(cos_af) + fabs(af*sin_af))*c_100 + (fabs(cos_ag) +
        fabs(ag*sin_ag))*c_101);
    terms[5] = 0.5*(z_18*c_97 + z_21*c_98 + z_16*c_99 + (fabs(sin_af) + fabs(af*cos_af))*c_100 + (fabs(sin_ag) +
        fabs(ag*cos_ag))*c_101);
}

/* crossing (n_events): an event happens where its number passes through zero */
EM_ACROSS void model_events(double t, const double *restrict x, const double *restrict v,
                            const double *restrict c, const double *restrict u, double *restrict crossing)
{
}

#endif
#if !EM_ALONE(EM_ASIDE) && !EM_ALONE(EM_RHS)
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
    const double c_0 = c[17];
    const double c_1 = c[18];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double c_2 = c[19];
    const double sin_theta = em_sin(theta);
    M1[0][0] = (1.0/3.0)*(c_0 + c_1*(cos_theta*cos_theta) + c_2*(sin_theta*sin_theta));
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double c_3 = c[20];
    const double sin_aj = em_sin(aj);
    const double c_4 = c[21];
    M1[0][1] = M1[1][0] = (1.0/3.0)*(cos_aj*(cos_theta*c_3) + sin_aj*(sin_theta*c_4));
    const double c_5 = c[22];
    const double c_6 = c[23];
    M1[1][1] = (1.0/3.0)*(c_5*(cos_aj*cos_aj) + c_6*(sin_aj*sin_aj));
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double c_7 = c[24];
    const double sin_ab = em_sin(ab);
    const double c_8 = c[25];
    M1[0][2] = M1[2][0] = (1.0/6.0)*(cos_theta*(cos_ab*c_7) + sin_theta*(sin_ab*c_8));
    const double c_9 = c[26];
    const double c_10 = c[27];
    M1[1][2] = M1[2][1] = ((-1.0/3.0))*(cos_aj*(cos_ab*c_9) + sin_aj*(sin_ab*c_10));
    const double c_11 = c[28];
    const double c_12 = c[29];
    const double c_13 = c[30];
    const double c_14 = c[31];
    const double z_6 = cos_ab*c_13 - sin_ab*c_14;
    const double c_15 = c[32];
    const double z_7 = sin_ab*c_13 + cos_ab*c_14;
    const double c_16 = c[33];
    const double c_17 = c[34];
    M1[2][2] = (1.0/12.0)*(c_11 + c_12*(z_6*z_6) + c_15*(z_7*z_7) + c_16*(cos_ab*cos_ab) + c_17*(sin_ab*sin_ab));
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double c_18 = c[35];
    const double sin_ak = em_sin(ak);
    const double c_19 = c[36];
    M1[0][3] = M1[3][0] = (1.0/3.0)*(cos_ak*(cos_theta*c_18) + sin_ak*(sin_theta*c_19));
    M1[1][3] = M1[3][1] = 0.0;
    M1[2][3] = M1[3][2] = 0.0;
    const double c_20 = c[37];
    const double c_21 = c[38];
    M1[3][3] = (1.0/3.0)*(c_20*(cos_ak*cos_ak) + c_21*(sin_ak*sin_ak));
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_22 = c[39];
    const double sin_ac = em_sin(ac);
    const double c_23 = c[40];
    M1[0][4] = M1[4][0] = (1.0/6.0)*(cos_ac*(cos_theta*c_22) + sin_ac*(sin_theta*c_23));
    M1[1][4] = M1[4][1] = 0.0;
    const double c_24 = c[41];
    const double c_25 = c[42];
    M1[2][4] = M1[4][2] = (1.0/12.0)*(z_6*(cos_ac*c_24) + z_7*(sin_ac*c_25));
    const double c_26 = c[43];
    const double c_27 = c[44];
    M1[3][4] = M1[4][3] = ((-1.0/3.0))*(cos_ak*(cos_ac*c_26) + sin_ak*(sin_ac*c_27));
    const double c_28 = c[45];
    const double c_29 = c[46];
    const double c_30 = c[47];
    M1[4][4] = (1.0/6.0)*(c_28 + c_29*(cos_ac*cos_ac) + c_30*(sin_ac*sin_ac));
    M1[0][5] = M1[5][0] = 0.0;
    M1[1][5] = M1[5][1] = 0.0;
    const double af = x[5];
    const double sin_af = em_sin(af);
    const double c_31 = c[48];
    const double cos_af = em_cos(af);
    const double c_32 = c[49];
    M1[2][5] = M1[5][2] = (1.0/6.0)*(sin_af*(z_7*c_31) + cos_af*(z_6*c_32));
    M1[3][5] = M1[5][3] = 0.0;
    const double c_33 = c[50];
    const double c_34 = c[51];
    M1[4][5] = M1[5][4] = ((-1.0/3.0))*(cos_af*(cos_ac*c_33) + sin_af*(sin_ac*c_34));
    const double c_35 = c[52];
    const double c_36 = c[53];
    M1[5][5] = (1.0/3.0)*(c_35*(cos_af*cos_af) + c_36*(sin_af*sin_af));
    M1[0][6] = M1[6][0] = 0.0;
    M1[1][6] = M1[6][1] = 0.0;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_37 = c[54];
    const double sin_ag = em_sin(ag);
    const double c_38 = c[55];
    M1[2][6] = M1[6][2] = (1.0/12.0)*(cos_ag*(z_6*c_37) + sin_ag*(z_7*c_38));
    M1[3][6] = M1[6][3] = 0.0;
    const double c_39 = c[56];
    const double c_40 = c[57];
    const double c_41 = c[58];
    M1[4][6] = M1[6][4] = ((-1.0/12.0))*(c_41*(cos_ac*sin_ag) - cos_ag*(cos_ac*c_39) - sin_ag*(sin_ac*c_40) -
        c_41*(sin_ac*cos_ag));
    const double c_42 = c[59];
    const double c_43 = c[60];
    M1[5][6] = M1[6][5] = ((-1.0/3.0))*(cos_af*(cos_ag*c_42) + sin_af*(sin_ag*c_43));
    const double c_44 = c[61];
    const double c_45 = c[62];
    const double c_46 = c[63];
    M1[6][6] = (1.0/12.0)*(c_44 + c_45*(cos_ag*cos_ag) + c_46*(sin_ag*sin_ag));
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
    A1[3][3] = k*cos_ak;
    A1[3][4] = -c_*cos_ac;
    A1[3][5] = 0.0;
    A1[3][6] = 0.0;
    A1[4][0] = 0.0;
    A1[4][1] = 0.0;
    A1[4][2] = (-0.5)*z_7;
    A1[4][3] = 0.0;
    A1[4][4] = c_*sin_ac;
    const double f = c[5];
    A1[4][5] = -f*sin_af;
    const double g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = 0.0;
    A1[5][1] = 0.0;
    A1[5][2] = 0.5*z_6;
    A1[5][3] = 0.0;
    A1[5][4] = -c_*cos_ac;
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
    shared[2] = cos_aj;
    shared[3] = sin_aj;
    shared[4] = sin_ab;
    shared[5] = cos_ab;
    shared[6] = z_6;
    shared[7] = z_7;
    shared[8] = cos_ak;
    shared[9] = sin_ak;
    shared[10] = cos_ac;
    shared[11] = sin_ac;
    shared[12] = sin_af;
    shared[13] = cos_af;
    shared[14] = cos_ag;
    shared[15] = sin_ag;
}

/* Mdot */
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[16],
                             double Mdot1[N1][N1])
{
    const double c_47 = c[64];
    const double sin_theta = shared[0];
    const double theta_dot = v[0];
    const double cos_theta = shared[1];
    const double z_16 = theta_dot*cos_theta;
    Mdot1[0][0] = -c_47*(sin_theta*z_16);
    const double c_3 = c[20];
    const double cos_aj = shared[2];
    const double z_17 = theta_dot*sin_theta;
    const double aj_dot = v[1];
    const double sin_aj = shared[3];
    const double z_18 = aj_dot*sin_aj;
    const double c_4 = c[21];
    const double z_19 = aj_dot*cos_aj;
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/3.0))*(c_3*(cos_aj*z_17 + cos_theta*z_18) - c_4*(sin_aj*z_16 +
        sin_theta*z_19));
    const double c_48 = c[65];
    Mdot1[1][1] = -c_48*(sin_aj*z_19);
    const double c_7 = c[24];
    const double ab_dot = v[2];
    const double sin_ab = shared[4];
    const double z_20 = ab_dot*sin_ab;
    const double cos_ab = shared[5];
    const double c_8 = c[25];
    const double z_21 = ab_dot*cos_ab;
    Mdot1[0][2] = Mdot1[2][0] = ((-1.0/6.0))*(c_7*(cos_theta*z_20 + cos_ab*z_17) - c_8*(sin_theta*z_21 +
        sin_ab*z_16));
    const double c_9 = c[26];
    const double c_10 = c[27];
    Mdot1[1][2] = Mdot1[2][1] = (1.0/3.0)*(c_9*(cos_aj*z_20 + cos_ab*z_18) - c_10*(sin_aj*z_21 + sin_ab*z_19));
    const double z_6 = shared[6];
    const double c_12 = c[29];
    const double c_13 = c[30];
    const double c_14 = c[31];
    const double z_22 = c_13*z_20 + c_14*z_21;
    const double z_7 = shared[7];
    const double c_15 = c[32];
    const double z_23 = c_13*z_21 - c_14*z_20;
    const double c_49 = c[66];
    Mdot1[2][2] = ((-1.0/6.0))*(z_6*c_12*z_22 + c_49*(sin_ab*z_21) - z_7*c_15*z_23);
    const double c_18 = c[35];
    const double cos_ak = shared[8];
    const double ak_dot = v[3];
    const double sin_ak = shared[9];
    const double z_24 = ak_dot*sin_ak;
    const double c_19 = c[36];
    const double z_25 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/3.0))*(c_18*(cos_ak*z_17 + cos_theta*z_24) - c_19*(sin_ak*z_16 +
        sin_theta*z_25));
    Mdot1[1][3] = Mdot1[3][1] = 0.0;
    Mdot1[2][3] = Mdot1[3][2] = 0.0;
    const double c_50 = c[67];
    Mdot1[3][3] = -c_50*(sin_ak*z_25);
    const double c_22 = c[39];
    const double cos_ac = shared[10];
    const double ac_dot = v[4];
    const double sin_ac = shared[11];
    const double z_26 = ac_dot*sin_ac;
    const double c_23 = c[40];
    const double z_27 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_22*(cos_ac*z_17 + cos_theta*z_26) - c_23*(sin_ac*z_16 +
        sin_theta*z_27));
    Mdot1[1][4] = Mdot1[4][1] = 0.0;
    const double c_24 = c[41];
    const double c_25 = c[42];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_24*(z_6*z_26 + cos_ac*z_22) - c_25*(z_7*z_27 + sin_ac*z_23));
    const double c_26 = c[43];
    const double c_27 = c[44];
    Mdot1[3][4] = Mdot1[4][3] = (1.0/3.0)*(c_26*(cos_ak*z_26 + cos_ac*z_24) - c_27*(sin_ak*z_27 + sin_ac*z_25));
    const double c_51 = c[68];
    Mdot1[4][4] = -c_51*(sin_ac*z_27);
    Mdot1[0][5] = Mdot1[5][0] = 0.0;
    Mdot1[1][5] = Mdot1[5][1] = 0.0;
    const double c_31 = c[48];
    const double sin_af = shared[12];
    const double af_dot = v[5];
    const double cos_af = shared[13];
    const double z_28 = af_dot*cos_af;
    const double c_32 = c[49];
    const double z_29 = af_dot*sin_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_31*(sin_af*z_23 + z_7*z_28) - c_32*(cos_af*z_22 + z_6*z_29));
    Mdot1[3][5] = Mdot1[5][3] = 0.0;
    const double c_33 = c[50];
    const double c_34 = c[51];
    Mdot1[4][5] = Mdot1[5][4] = (1.0/3.0)*(c_33*(cos_af*z_26 + cos_ac*z_29) - c_34*(sin_af*z_27 + sin_ac*z_28));
    const double c_52 = c[69];
    Mdot1[5][5] = -c_52*(cos_af*z_29);
    Mdot1[0][6] = Mdot1[6][0] = 0.0;
    Mdot1[1][6] = Mdot1[6][1] = 0.0;
    const double c_37 = c[54];
    const double cos_ag = shared[14];
    const double ag_dot = v[6];
    const double sin_ag = shared[15];
    const double z_30 = ag_dot*sin_ag;
    const double c_38 = c[55];
    const double z_31 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_37*(cos_ag*z_22 + z_6*z_30) - c_38*(sin_ag*z_23 + z_7*z_31));
    Mdot1[3][6] = Mdot1[6][3] = 0.0;
    const double c_53 = c[70];
    const double c_39 = c[56];
    const double c_40 = c[57];
    Mdot1[4][6] = Mdot1[6][4] = (1.0/12.0)*(2.0*c_53*(sin_ag*z_26 - cos_ac*z_31) + 2.0*c_53*(cos_ag*z_27 -
        sin_ac*z_30) + c_40*(sin_ag*z_27 + sin_ac*z_31) - c_39*(cos_ag*z_26 + cos_ac*z_30));
    const double c_42 = c[59];
    const double c_43 = c[60];
    Mdot1[5][6] = Mdot1[6][5] = (1.0/3.0)*(c_42*(cos_af*z_30 + cos_ag*z_29) - c_43*(sin_af*z_31 + sin_ag*z_28));
    const double c_54 = c[71];
    Mdot1[6][6] = -c_54*(sin_ag*z_31);
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
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        double Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
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
#elif EM_HOLDS(EM_METHODS)
#include "em_further_methods.h"
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
    "M^-1: M is singular; M + A^T W A is factored, with weights W of rows 0, 1, 2, 3, 4, 5",
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
    .simulate = em_simulate,
    .interpolate = em_interpolate,
    .release = em_release,
    .event = model_events,
    .factored_matrix = factored_matrix,
    .factored_gradient = factored_gradient,
    .lanes = &jansen_lanes,
    .enter = em_member_enter,
    .board = em_member_board,
    .look = em_member_look,
    .open = em_handle_open,
    .advance = em_handle_advance,
    .now = em_handle_now,
    .publish = em_handle_publish,
    .saved = em_handle_saved,
    .save = em_handle_save,
    .restore = em_handle_restore,
    .close = em_handle_close,
    .again = em_handle_again,
    .n_shapes = 16,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .constraint_partials = constraint_partials,
    .motion_along = em_motion_along,
    .tangent = em_tangent,
    .further = em_further,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
