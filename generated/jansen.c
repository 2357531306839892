/* eigenmotion generate jansen.py */
/* input sha256:f744e812ddbbe356574aebfde26a89931e0d70e4b66e96c84fbd1461918df3df */
/* body sha256:34c44d8925cb8a497436e7bf7eebd1646bd5d593a12dd311688dc76806b43672 */
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
 *   M^-1: M is singular; M + A^T W A is factored, with weights W of rows 1, 2, 3, 4, 5
 *
 * Operations of the straight-line part:
 *   eigenfactor: 102 additions, 270 multiplications, 14 function calls
 *   triangular root: 125 additions, 358 multiplications, 14 function calls
 *   projection: 65 additions, 234 multiplications, 14 function calls
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
    N_STATE = 70,         /* numbers of a state */
    N_C = 49,             /* of which C, */
    N_S = 7,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 56,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 17,
    N_PREPARED = 130,     /* the parameters, factors of constant blocks, shared constants c_0, ... */
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
    const real c_43 = c[60];
    const real theta = x[0];
    const real cos_theta = em_cos(theta);
    const real theta_dot = v[0];
    const real sin_theta = em_sin(theta);
    const real z_2 = theta_dot*sin_theta;
    Mdot1[0][0] = c_43*(cos_theta*z_2);
    const real c_44 = c[61];
    const real aj = x[1];
    const real cos_aj = em_cos(aj);
    const real aj_dot = v[1];
    const real sin_aj = em_sin(aj);
    const real z_5 = aj_dot*sin_aj;
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/3.0))*(c_44*(cos_aj*z_2 + cos_theta*z_5));
    const real c_45 = c[62];
    Mdot1[1][1] = -c_45*(cos_aj*z_5);
    const real c_5 = c[22];
    const real ab_dot = v[2];
    const real ab = x[2];
    const real cos_ab = em_cos(ab);
    const real z_7 = ab_dot*cos_ab;
    const real sin_ab = em_sin(ab);
    const real z_9 = theta_dot*cos_theta;
    const real c_6 = c[23];
    const real z_10 = ab_dot*sin_ab;
    Mdot1[0][2] = Mdot1[2][0] = (1.0/6.0)*(c_5*(sin_theta*z_7 + sin_ab*z_9) - c_6*(cos_theta*z_10 + cos_ab*z_2));
    const real c_46 = c[63];
    Mdot1[1][2] = Mdot1[2][1] = (1.0/3.0)*(c_46*(cos_aj*z_10 + cos_ab*z_5));
    const real c_10 = c[27];
    const real c_11 = c[28];
    const real z_11 = cos_ab*c_10 - sin_ab*c_11;
    const real c_9 = c[26];
    const real z_12 = c_10*z_10 + c_11*z_7;
    const real z_13 = c_9*z_12;
    const real z_14 = sin_ab*c_10 + cos_ab*c_11;
    const real c_12 = c[29];
    const real z_15 = c_10*z_7 - c_11*z_10;
    const real z_16 = c_12*z_15;
    const real c_13 = c[30];
    Mdot1[2][2] = ((-1.0/6.0))*(z_11*z_13 + c_13*(cos_ab*z_10) - z_14*z_16);
    const real c_14 = c[31];
    const real ak = x[3];
    const real cos_ak = em_cos(ak);
    const real ak_dot = v[3];
    const real sin_ak = em_sin(ak);
    const real z_19 = ak_dot*sin_ak;
    const real c_15 = c[32];
    const real z_20 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/3.0))*(c_14*(cos_ak*z_2 + cos_theta*z_19) - c_15*(sin_ak*z_9 +
        sin_theta*z_20));
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    const real c_47 = c[64];
    Mdot1[3][3] = -c_47*(sin_ak*z_20);
    const real c_18 = c[35];
    const real ac = x[4];
    const real cos_ac = em_cos(ac);
    const real ac_dot = v[4];
    const real sin_ac = em_sin(ac);
    const real z_23 = ac_dot*sin_ac;
    const real c_19 = c[36];
    const real z_24 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_18*(cos_ac*z_2 + cos_theta*z_23) - c_19*(sin_ac*z_9 +
        sin_theta*z_24));
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_20 = c[37];
    const real c_21 = c[38];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_20*(z_11*z_23 + cos_ac*z_12) - c_21*(z_14*z_24 + sin_ac*z_15));
    const real c_22 = c[39];
    const real c_23 = c[40];
    Mdot1[3][4] = Mdot1[4][3] = (1.0/3.0)*(c_22*(cos_ak*z_23 + cos_ac*z_19) - c_23*(sin_ak*z_24 + sin_ac*z_20));
    const real c_48 = c[65];
    Mdot1[4][4] = -c_48*(sin_ac*z_24);
    Mdot1[0][5] = Mdot1[5][0] = em_real(0.0);
    Mdot1[1][5] = Mdot1[5][1] = em_real(0.0);
    const real c_27 = c[44];
    const real af = x[5];
    const real sin_af = em_sin(af);
    const real af_dot = v[5];
    const real cos_af = em_cos(af);
    const real z_27 = af_dot*cos_af;
    const real c_28 = c[45];
    const real z_28 = af_dot*sin_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_27*(sin_af*z_15 + z_14*z_27) - c_28*(cos_af*z_12 + z_11*z_28));
    Mdot1[3][5] = Mdot1[5][3] = em_real(0.0);
    const real c_29 = c[46];
    const real c_30 = c[47];
    Mdot1[4][5] = Mdot1[5][4] = (1.0/3.0)*(c_29*(cos_af*z_23 + cos_ac*z_28) - c_30*(sin_af*z_24 + sin_ac*z_27));
    const real c_49 = c[66];
    Mdot1[5][5] = -c_49*(cos_af*z_28);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real c_33 = c[50];
    const real ag = x[6];
    const real cos_ag = em_cos(ag);
    const real ag_dot = v[6];
    const real sin_ag = em_sin(ag);
    const real z_31 = ag_dot*sin_ag;
    const real c_34 = c[51];
    const real z_32 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_33*(cos_ag*z_12 + z_11*z_31) - c_34*(sin_ag*z_15 + z_14*z_32));
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    const real c_50 = c[67];
    const real c_35 = c[52];
    const real c_36 = c[53];
    Mdot1[4][6] = Mdot1[6][4] = (1.0/12.0)*(2.0*c_50*(sin_ag*z_23 - cos_ac*z_32) + 2.0*c_50*(cos_ag*z_24 -
        sin_ac*z_31) + c_36*(sin_ag*z_24 + sin_ac*z_32) - c_35*(cos_ag*z_23 + cos_ac*z_31));
    const real c_38 = c[55];
    const real c_39 = c[56];
    Mdot1[5][6] = Mdot1[6][5] = (1.0/3.0)*(c_38*(cos_af*z_31 + cos_ag*z_28) - c_39*(sin_af*z_32 + sin_ag*z_27));
    const real c_51 = c[68];
    Mdot1[6][6] = -c_51*(sin_ag*z_32);
    const real z_33 = theta_dot*ab_dot*(c_5*(cos_ab*sin_theta - cos_theta*sin_ab));
    const real c_52 = c[69];
    const real z_34 = theta_dot*ac_dot*(c_52*(sin_theta*cos_ac - cos_theta*sin_ac));
    const real c_53 = c[70];
    const real c_54 = c[71];
    const real m = c[12];
    const real z_35 = m*z_9;
    const real j = c[9];
    const real z_36 = j*cos_aj;
    const real b = c[1];
    const real z_37 = z_35 + aj_dot*z_36 - b*z_7;
    const real c_55 = c[72];
    const real c_ = c[2];
    const real k = c[10];
    const real z_38 = c_*z_23 - m*z_2 - k*z_19;
    const real c_56 = c[73];
    const real z_39 = c_*z_24 - z_35 - k*z_20;
    const real c_57 = c[74];
    f1[0] = ((-1.0/6.0))*(((z_33 + z_34) - 3.0*(c_54 - cos_theta*c_53)) + 2.0*(z_37*c_55*z_2 + z_38*c_56*z_9 -
        z_39*c_57*z_2));
    const real c_58 = c[75];
    f1[1] = -c_58*(z_37*z_5);
    const real c_59 = c[76];
    const real z_40 = ab_dot*ac_dot*(c_59*(cos_ac*z_14 - sin_ac*z_11));
    const real c_60 = c[77];
    const real z_41 = ab_dot*ag_dot*(c_60*(z_14*cos_ag - z_11*sin_ag));
    const real c_61 = c[78];
    const real c_62 = c[79];
    const real c_63 = c[80];
    const real c_64 = c[81];
    const real c_65 = c[82];
    const real z_42 = c_63*z_23 + c_64*z_31 - ab_dot*z_14 - c_65*z_28;
    const real z_43 = c_63*z_24 + c_64*z_32 - ab_dot*z_11 - c_65*z_27;
    const real c_66 = c[83];
    f1[2] = (1.0/12.0)*(((2.0*z_33 - z_40 - z_41) - 3.0*(cos_ab*c_61 - sin_ab*c_62)) + (z_43*z_13 +
        c_66*(z_37*z_10) - z_42*z_16));
    const real c_67 = c[84];
    const real c_68 = c[85];
    f1[3] = ((-1.0/3.0))*(z_38*c_67*z_20 - z_39*c_68*z_19);
    const real c_69 = c[86];
    const real c_37 = c[54];
    const real z_44 = ac_dot*ag_dot*(sin_ac*cos_ag*c_69 - cos_ac*sin_ag*c_69 - c_37*(sin_ac*sin_ag) -
        c_37*(cos_ac*cos_ag));
    const real c_70 = c[87];
    const real c_71 = c[88];
    const real c_72 = c[89];
    const real c_73 = c[90];
    const real c_74 = c[91];
    f1[4] = (1.0/12.0)*(((2.0*z_34 + z_40 - z_44) - cos_ac*c_70) + 2.0*(c_71*z_42*z_24 + c_73*(z_38*z_24) -
        c_72*z_43*z_23 - c_74*(z_39*z_23)));
    f1[5] = ((-1.0/6.0))*(c_27*z_42*z_27 - c_28*z_43*z_28);
    const real c_75 = c[92];
    const real c_76 = c[93];
    const real c_77 = c[94];
    const real c_78 = c[95];
    f1[6] = (1.0/12.0)*(((z_41 + z_44) - 3.0*(cos_ag*c_75 - sin_ag*c_76)) + 2.0*(c_77*z_42*z_32 -
        c_78*z_43*z_31));
    const real z_45 = m*sin_theta;
    A1[0][0] = -z_45;
    const real z_46 = j*sin_aj;
    A1[0][1] = -z_46;
    const real z_47 = b*sin_ab;
    A1[0][2] = z_47;
    A1[0][3] = em_real(0.0);
    A1[0][4] = em_real(0.0);
    A1[0][5] = em_real(0.0);
    A1[0][6] = em_real(0.0);
    const real z_48 = m*cos_theta;
    A1[1][0] = z_48;
    A1[1][1] = z_36;
    const real z_49 = b*cos_ab;
    A1[1][2] = -z_49;
    A1[1][3] = em_real(0.0);
    A1[1][4] = em_real(0.0);
    A1[1][5] = em_real(0.0);
    A1[1][6] = em_real(0.0);
    A1[2][0] = -z_45;
    A1[2][1] = em_real(0.0);
    A1[2][2] = em_real(0.0);
    const real z_50 = k*sin_ak;
    A1[2][3] = -z_50;
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
    A1[4][2] = (-0.5)*z_14;
    A1[4][3] = em_real(0.0);
    A1[4][4] = z_51;
    const real f = c[5];
    A1[4][5] = -f*sin_af;
    const real g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = em_real(0.0);
    A1[5][1] = em_real(0.0);
    A1[5][2] = 0.5*z_11;
    A1[5][3] = em_real(0.0);
    A1[5][4] = -z_53;
    A1[5][5] = f*cos_af;
    A1[5][6] = -g*cos_ag;
    const real z_54 = theta_dot*theta_dot;
    const real z_55 = z_48*z_54;
    const real z_56 = aj_dot*aj_dot;
    const real z_57 = ab_dot*ab_dot;
    gamma[0] = -(z_55 + z_36*z_56 - z_49*z_57);
    const real z_58 = z_45*z_54;
    gamma[1] = -(z_58 + z_46*z_56 - z_47*z_57);
    const real z_59 = ak_dot*ak_dot;
    const real z_60 = ac_dot*ac_dot;
    gamma[2] = -(z_55 + z_52*z_59 - z_53*z_60);
    gamma[3] = -(z_58 + z_50*z_59 - z_51*z_60);
    const real z_61 = c_63*z_60;
    const real z_62 = c_65*(af_dot*af_dot);
    const real z_63 = c_64*(ag_dot*ag_dot);
    gamma[4] = 0.5*(cos_ac*z_61 + cos_ag*z_63 - ab_dot*z_15 - cos_af*z_62);
    gamma[5] = 0.5*(sin_ac*z_61 + sin_ag*z_63 - ab_dot*z_12 - sin_af*z_62);
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
                                 real shared[19])
{
    const real c_0 = c[17];
    const real c_1 = c[18];
    const real theta = x[0];
    const real sin_theta = em_sin(theta);
    const real c_2 = c[19];
    const real cos_theta = em_cos(theta);
    M1[0][0] = (1.0/3.0)*(c_0 + c_1*(sin_theta*sin_theta) + c_2*(cos_theta*cos_theta));
    const real c_3 = c[20];
    const real aj = x[1];
    const real cos_aj = em_cos(aj);
    M1[1][0] = c_3*(cos_theta*cos_aj);
    const real c_4 = c[21];
    M1[1][1] = c_4*(cos_aj*cos_aj);
    const real ab = x[2];
    const real sin_ab = em_sin(ab);
    const real c_5 = c[22];
    const real cos_ab = em_cos(ab);
    const real c_6 = c[23];
    M1[2][0] = (1.0/6.0)*(sin_theta*(sin_ab*c_5) + cos_theta*(cos_ab*c_6));
    const real c_7 = c[24];
    M1[2][1] = -c_7*(cos_ab*cos_aj);
    const real c_8 = c[25];
    const real c_9 = c[26];
    const real c_10 = c[27];
    const real c_11 = c[28];
    const real z_5 = cos_ab*c_10 - sin_ab*c_11;
    const real c_12 = c[29];
    const real z_6 = sin_ab*c_10 + cos_ab*c_11;
    const real c_13 = c[30];
    M1[2][2] = (1.0/12.0)*(c_8 + c_9*(z_5*z_5) + c_12*(z_6*z_6) + c_13*(cos_ab*cos_ab));
    const real ak = x[3];
    const real cos_ak = em_cos(ak);
    const real c_14 = c[31];
    const real sin_ak = em_sin(ak);
    const real c_15 = c[32];
    M1[3][0] = (1.0/3.0)*(cos_ak*(cos_theta*c_14) + sin_ak*(sin_theta*c_15));
    M1[3][1] = em_real(0.0);
    M1[3][2] = em_real(0.0);
    const real c_16 = c[33];
    const real c_17 = c[34];
    M1[3][3] = (1.0/3.0)*(c_16*(cos_ak*cos_ak) + c_17*(sin_ak*sin_ak));
    const real ac = x[4];
    const real cos_ac = em_cos(ac);
    const real c_18 = c[35];
    const real sin_ac = em_sin(ac);
    const real c_19 = c[36];
    M1[4][0] = (1.0/6.0)*(cos_ac*(cos_theta*c_18) + sin_ac*(sin_theta*c_19));
    M1[4][1] = em_real(0.0);
    const real c_20 = c[37];
    const real c_21 = c[38];
    M1[4][2] = (1.0/12.0)*(z_5*(cos_ac*c_20) + z_6*(sin_ac*c_21));
    const real c_22 = c[39];
    const real c_23 = c[40];
    M1[4][3] = ((-1.0/3.0))*(cos_ak*(cos_ac*c_22) + sin_ak*(sin_ac*c_23));
    const real c_24 = c[41];
    const real c_25 = c[42];
    const real c_26 = c[43];
    M1[4][4] = (1.0/6.0)*(c_24 + c_25*(cos_ac*cos_ac) + c_26*(sin_ac*sin_ac));
    M1[5][0] = em_real(0.0);
    M1[5][1] = em_real(0.0);
    const real af = x[5];
    const real sin_af = em_sin(af);
    const real c_27 = c[44];
    const real cos_af = em_cos(af);
    const real c_28 = c[45];
    M1[5][2] = (1.0/6.0)*(sin_af*(z_6*c_27) + cos_af*(z_5*c_28));
    M1[5][3] = em_real(0.0);
    const real c_29 = c[46];
    const real c_30 = c[47];
    M1[5][4] = ((-1.0/3.0))*(cos_af*(cos_ac*c_29) + sin_af*(sin_ac*c_30));
    const real c_31 = c[48];
    const real c_32 = c[49];
    M1[5][5] = (1.0/3.0)*(c_31*(cos_af*cos_af) + c_32*(sin_af*sin_af));
    M1[6][0] = em_real(0.0);
    M1[6][1] = em_real(0.0);
    const real ag = x[6];
    const real cos_ag = em_cos(ag);
    const real c_33 = c[50];
    const real sin_ag = em_sin(ag);
    const real c_34 = c[51];
    M1[6][2] = (1.0/12.0)*(cos_ag*(z_5*c_33) + sin_ag*(z_6*c_34));
    M1[6][3] = em_real(0.0);
    const real c_35 = c[52];
    const real z_15 = cos_ac*cos_ag;
    const real c_36 = c[53];
    const real z_16 = sin_ac*sin_ag;
    const real c_37 = c[54];
    const real z_17 = cos_ac*sin_ag;
    const real z_18 = sin_ac*cos_ag;
    M1[6][4] = ((-1.0/12.0))*(c_37*z_17 - c_35*z_15 - c_36*z_16 - c_37*z_18);
    const real c_38 = c[55];
    const real c_39 = c[56];
    M1[6][5] = ((-1.0/3.0))*(cos_af*(cos_ag*c_38) + sin_af*(sin_ag*c_39));
    const real c_40 = c[57];
    const real c_41 = c[58];
    const real c_42 = c[59];
    M1[6][6] = (1.0/12.0)*(c_40 + c_41*(cos_ag*cos_ag) + c_42*(sin_ag*sin_ag));
    shared[0] = cos_theta;
    shared[1] = sin_theta;
    shared[2] = cos_aj;
    shared[3] = cos_ab;
    shared[4] = sin_ab;
    shared[5] = z_5;
    shared[6] = z_6;
    shared[7] = cos_ak;
    shared[8] = sin_ak;
    shared[9] = cos_ac;
    shared[10] = sin_ac;
    shared[11] = sin_af;
    shared[12] = cos_af;
    shared[13] = cos_ag;
    shared[14] = sin_ag;
    shared[15] = z_18;
    shared[16] = z_17;
    shared[17] = z_16;
    shared[18] = z_15;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[19], real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1],
                                 real gamma[N_ROWS])
{
    const real c_43 = c[60];
    const real cos_theta = shared[0];
    const real theta_dot = v[0];
    const real sin_theta = shared[1];
    const real z_19 = theta_dot*sin_theta;
    Mdot1[0][0] = c_43*(cos_theta*z_19);
    const real c_44 = c[61];
    const real cos_aj = shared[2];
    const real aj_dot = v[1];
    const real aj = x[1];
    const real sin_aj = em_sin(aj);
    const real z_21 = aj_dot*sin_aj;
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/3.0))*(c_44*(cos_aj*z_19 + cos_theta*z_21));
    const real c_45 = c[62];
    Mdot1[1][1] = -c_45*(cos_aj*z_21);
    const real c_5 = c[22];
    const real ab_dot = v[2];
    const real cos_ab = shared[3];
    const real z_22 = ab_dot*cos_ab;
    const real sin_ab = shared[4];
    const real z_23 = theta_dot*cos_theta;
    const real c_6 = c[23];
    const real z_24 = ab_dot*sin_ab;
    Mdot1[0][2] = Mdot1[2][0] = (1.0/6.0)*(c_5*(sin_theta*z_22 + sin_ab*z_23) - c_6*(cos_theta*z_24 +
        cos_ab*z_19));
    const real c_46 = c[63];
    Mdot1[1][2] = Mdot1[2][1] = (1.0/3.0)*(c_46*(cos_aj*z_24 + cos_ab*z_21));
    const real z_5 = shared[5];
    const real c_9 = c[26];
    const real c_10 = c[27];
    const real c_11 = c[28];
    const real z_25 = c_10*z_24 + c_11*z_22;
    const real z_26 = c_9*z_25;
    const real z_6 = shared[6];
    const real c_12 = c[29];
    const real z_27 = c_10*z_22 - c_11*z_24;
    const real z_28 = c_12*z_27;
    const real c_13 = c[30];
    Mdot1[2][2] = ((-1.0/6.0))*(z_5*z_26 + c_13*(cos_ab*z_24) - z_6*z_28);
    const real c_14 = c[31];
    const real cos_ak = shared[7];
    const real ak_dot = v[3];
    const real sin_ak = shared[8];
    const real z_29 = ak_dot*sin_ak;
    const real c_15 = c[32];
    const real z_30 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/3.0))*(c_14*(cos_ak*z_19 + cos_theta*z_29) - c_15*(sin_ak*z_23 +
        sin_theta*z_30));
    Mdot1[1][3] = Mdot1[3][1] = em_real(0.0);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    const real c_47 = c[64];
    Mdot1[3][3] = -c_47*(sin_ak*z_30);
    const real c_18 = c[35];
    const real cos_ac = shared[9];
    const real ac_dot = v[4];
    const real sin_ac = shared[10];
    const real z_31 = ac_dot*sin_ac;
    const real c_19 = c[36];
    const real z_32 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_18*(cos_ac*z_19 + cos_theta*z_31) - c_19*(sin_ac*z_23 +
        sin_theta*z_32));
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_20 = c[37];
    const real c_21 = c[38];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_20*(z_5*z_31 + cos_ac*z_25) - c_21*(z_6*z_32 + sin_ac*z_27));
    const real c_22 = c[39];
    const real c_23 = c[40];
    Mdot1[3][4] = Mdot1[4][3] = (1.0/3.0)*(c_22*(cos_ak*z_31 + cos_ac*z_29) - c_23*(sin_ak*z_32 + sin_ac*z_30));
    const real c_48 = c[65];
    Mdot1[4][4] = -c_48*(sin_ac*z_32);
    Mdot1[0][5] = Mdot1[5][0] = em_real(0.0);
    Mdot1[1][5] = Mdot1[5][1] = em_real(0.0);
    const real c_27 = c[44];
    const real sin_af = shared[11];
    const real af_dot = v[5];
    const real cos_af = shared[12];
    const real z_33 = af_dot*cos_af;
    const real c_28 = c[45];
    const real z_34 = af_dot*sin_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_27*(sin_af*z_27 + z_6*z_33) - c_28*(cos_af*z_25 + z_5*z_34));
    Mdot1[3][5] = Mdot1[5][3] = em_real(0.0);
    const real c_29 = c[46];
    const real c_30 = c[47];
    Mdot1[4][5] = Mdot1[5][4] = (1.0/3.0)*(c_29*(cos_af*z_31 + cos_ac*z_34) - c_30*(sin_af*z_32 + sin_ac*z_33));
    const real c_49 = c[66];
    Mdot1[5][5] = -c_49*(cos_af*z_34);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real c_33 = c[50];
    const real cos_ag = shared[13];
    const real ag_dot = v[6];
    const real sin_ag = shared[14];
    const real z_35 = ag_dot*sin_ag;
    const real c_34 = c[51];
    const real z_36 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_33*(cos_ag*z_25 + z_5*z_35) - c_34*(sin_ag*z_27 + z_6*z_36));
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    const real c_50 = c[67];
    const real c_35 = c[52];
    const real c_36 = c[53];
    Mdot1[4][6] = Mdot1[6][4] = (1.0/12.0)*(2.0*c_50*(sin_ag*z_31 - cos_ac*z_36) + 2.0*c_50*(cos_ag*z_32 -
        sin_ac*z_35) + c_36*(sin_ag*z_32 + sin_ac*z_36) - c_35*(cos_ag*z_31 + cos_ac*z_35));
    const real c_38 = c[55];
    const real c_39 = c[56];
    Mdot1[5][6] = Mdot1[6][5] = (1.0/3.0)*(c_38*(cos_af*z_35 + cos_ag*z_34) - c_39*(sin_af*z_36 + sin_ag*z_33));
    const real c_51 = c[68];
    Mdot1[6][6] = -c_51*(sin_ag*z_36);
    const real z_37 = theta_dot*ab_dot*(c_5*(cos_ab*sin_theta - cos_theta*sin_ab));
    const real c_52 = c[69];
    const real z_38 = theta_dot*ac_dot*(c_52*(sin_theta*cos_ac - cos_theta*sin_ac));
    const real c_53 = c[70];
    const real c_54 = c[71];
    const real m = c[12];
    const real z_39 = m*z_23;
    const real j = c[9];
    const real z_40 = j*cos_aj;
    const real b = c[1];
    const real z_41 = z_39 + aj_dot*z_40 - b*z_22;
    const real c_55 = c[72];
    const real c_ = c[2];
    const real k = c[10];
    const real z_42 = c_*z_31 - m*z_19 - k*z_29;
    const real c_56 = c[73];
    const real z_43 = c_*z_32 - z_39 - k*z_30;
    const real c_57 = c[74];
    f1[0] = ((-1.0/6.0))*(((z_37 + z_38) - 3.0*(c_54 - cos_theta*c_53)) + 2.0*(z_41*c_55*z_19 + z_42*c_56*z_23 -
        z_43*c_57*z_19));
    const real c_58 = c[75];
    f1[1] = -c_58*(z_41*z_21);
    const real c_59 = c[76];
    const real z_44 = ab_dot*ac_dot*(c_59*(cos_ac*z_6 - sin_ac*z_5));
    const real c_60 = c[77];
    const real z_45 = ab_dot*ag_dot*(c_60*(z_6*cos_ag - z_5*sin_ag));
    const real c_61 = c[78];
    const real c_62 = c[79];
    const real c_63 = c[80];
    const real c_64 = c[81];
    const real c_65 = c[82];
    const real z_46 = c_63*z_31 + c_64*z_35 - ab_dot*z_6 - c_65*z_34;
    const real z_47 = c_63*z_32 + c_64*z_36 - ab_dot*z_5 - c_65*z_33;
    const real c_66 = c[83];
    f1[2] = (1.0/12.0)*(((2.0*z_37 - z_44 - z_45) - 3.0*(cos_ab*c_61 - sin_ab*c_62)) + (z_47*z_26 +
        c_66*(z_41*z_24) - z_46*z_28));
    const real c_67 = c[84];
    const real c_68 = c[85];
    f1[3] = ((-1.0/3.0))*(z_42*c_67*z_30 - z_43*c_68*z_29);
    const real c_69 = c[86];
    const real z_18 = shared[15];
    const real z_17 = shared[16];
    const real c_37 = c[54];
    const real z_16 = shared[17];
    const real z_15 = shared[18];
    const real z_48 = ac_dot*ag_dot*(c_69*z_18 - c_69*z_17 - c_37*z_16 - c_37*z_15);
    const real c_70 = c[87];
    const real c_71 = c[88];
    const real c_72 = c[89];
    const real c_73 = c[90];
    const real c_74 = c[91];
    f1[4] = (1.0/12.0)*(((2.0*z_38 + z_44 - z_48) - cos_ac*c_70) + 2.0*(c_71*z_46*z_32 + c_73*(z_42*z_32) -
        c_72*z_47*z_31 - c_74*(z_43*z_31)));
    f1[5] = ((-1.0/6.0))*(c_27*z_46*z_33 - c_28*z_47*z_34);
    const real c_75 = c[92];
    const real c_76 = c[93];
    const real c_77 = c[94];
    const real c_78 = c[95];
    f1[6] = (1.0/12.0)*(((z_45 + z_48) - 3.0*(cos_ag*c_75 - sin_ag*c_76)) + 2.0*(c_77*z_46*z_36 -
        c_78*z_47*z_35));
    const real z_49 = m*sin_theta;
    A1[0][0] = -z_49;
    const real z_50 = j*sin_aj;
    A1[0][1] = -z_50;
    const real z_51 = b*sin_ab;
    A1[0][2] = z_51;
    A1[0][3] = em_real(0.0);
    A1[0][4] = em_real(0.0);
    A1[0][5] = em_real(0.0);
    A1[0][6] = em_real(0.0);
    const real z_52 = m*cos_theta;
    A1[1][0] = z_52;
    A1[1][1] = z_40;
    const real z_53 = b*cos_ab;
    A1[1][2] = -z_53;
    A1[1][3] = em_real(0.0);
    A1[1][4] = em_real(0.0);
    A1[1][5] = em_real(0.0);
    A1[1][6] = em_real(0.0);
    A1[2][0] = -z_49;
    A1[2][1] = em_real(0.0);
    A1[2][2] = em_real(0.0);
    const real z_54 = k*sin_ak;
    A1[2][3] = -z_54;
    const real z_55 = c_*sin_ac;
    A1[2][4] = z_55;
    A1[2][5] = em_real(0.0);
    A1[2][6] = em_real(0.0);
    A1[3][0] = z_52;
    A1[3][1] = em_real(0.0);
    A1[3][2] = em_real(0.0);
    const real z_56 = k*cos_ak;
    A1[3][3] = z_56;
    const real z_57 = c_*cos_ac;
    A1[3][4] = -z_57;
    A1[3][5] = em_real(0.0);
    A1[3][6] = em_real(0.0);
    A1[4][0] = em_real(0.0);
    A1[4][1] = em_real(0.0);
    A1[4][2] = (-0.5)*z_6;
    A1[4][3] = em_real(0.0);
    A1[4][4] = z_55;
    const real f = c[5];
    A1[4][5] = -f*sin_af;
    const real g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = em_real(0.0);
    A1[5][1] = em_real(0.0);
    A1[5][2] = 0.5*z_5;
    A1[5][3] = em_real(0.0);
    A1[5][4] = -z_57;
    A1[5][5] = f*cos_af;
    A1[5][6] = -g*cos_ag;
    const real z_58 = theta_dot*theta_dot;
    const real z_59 = z_52*z_58;
    const real z_60 = aj_dot*aj_dot;
    const real z_61 = ab_dot*ab_dot;
    gamma[0] = -(z_59 + z_40*z_60 - z_53*z_61);
    const real z_62 = z_49*z_58;
    gamma[1] = -(z_62 + z_50*z_60 - z_51*z_61);
    const real z_63 = ak_dot*ak_dot;
    const real z_64 = ac_dot*ac_dot;
    gamma[2] = -(z_59 + z_56*z_63 - z_57*z_64);
    gamma[3] = -(z_62 + z_54*z_63 - z_55*z_64);
    const real z_65 = c_63*z_64;
    const real z_66 = c_65*(af_dot*af_dot);
    const real z_67 = c_64*(ag_dot*ag_dot);
    gamma[4] = 0.5*(cos_ac*z_65 + cos_ag*z_67 - ab_dot*z_27 - cos_af*z_66);
    gamma[5] = 0.5*(sin_ac*z_65 + sin_ag*z_67 - ab_dot*z_25 - sin_af*z_66);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[19];
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
    const double c_5 = c[22];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double z_2 = cos_ab*sin_theta;
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double z_5 = cos_theta*sin_ab;
    const double z_6 = theta_dot*ab_dot*(c_5*(z_2 - z_5));
    const double ac_dot = v[4];
    const double c_52 = c[69];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_8 = sin_theta*cos_ac;
    const double sin_ac = em_sin(ac);
    const double z_10 = cos_theta*sin_ac;
    const double z_11 = theta_dot*ac_dot*(c_52*(z_8 - z_10));
    const double c_53 = c[70];
    const double c_54 = c[71];
    const double z_12 = c_5*(ab_dot*z_2 + theta_dot*z_5) - c_5*(ab_dot*z_5 + theta_dot*z_2);
    const double z_13 = ac_dot*sin_ac;
    const double z_14 = ac_dot*cos_ac;
    const double z_15 = c_52*(theta_dot*z_8 + cos_theta*z_13) - c_52*(theta_dot*z_10 + sin_theta*z_14);
    const double m = c[12];
    const double z_16 = m*(theta_dot*theta_dot);
    const double z_17 = sin_theta*z_16;
    const double aj = x[1];
    const double sin_aj = em_sin(aj);
    const double j = c[9];
    const double aj_dot = v[1];
    const double z_19 = j*(aj_dot*aj_dot);
    const double b = c[1];
    const double z_20 = b*(ab_dot*ab_dot);
    const double z_21 = z_17 + sin_aj*z_19 - sin_ab*z_20;
    const double c_55 = c[72];
    const double z_22 = cos_theta*z_16;
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double k = c[10];
    const double ak_dot = v[3];
    const double z_24 = k*(ak_dot*ak_dot);
    const double c_ = c[2];
    const double z_25 = ac_dot*ac_dot;
    const double z_26 = c_*z_25;
    const double z_27 = z_22 + cos_ak*z_24 - cos_ac*z_26;
    const double c_56 = c[73];
    const double sin_ak = em_sin(ak);
    const double z_29 = z_17 + sin_ak*z_24 - sin_ac*z_26;
    const double c_57 = c[74];
    bias[0] = ((-1.0/6.0))*((((z_6 + z_11) - 3.0*(c_54 - cos_theta*c_53)) + (ab_dot*z_12 - ac_dot*z_15)) -
        2.0*(cos_theta*z_21*c_55 + cos_theta*z_29*c_57 - sin_theta*z_27*c_56));
    const double c_58 = c[75];
    const double cos_aj = em_cos(aj);
    bias[1] = c_58*(cos_aj*z_21);
    const double c_59 = c[76];
    const double c_10 = c[27];
    const double c_11 = c[28];
    const double z_31 = sin_ab*c_10 + cos_ab*c_11;
    const double z_32 = cos_ab*c_10 - sin_ab*c_11;
    const double z_33 = ab_dot*ac_dot*(c_59*(cos_ac*z_31 - sin_ac*z_32));
    const double ag_dot = v[6];
    const double c_60 = c[77];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    const double z_36 = ab_dot*ag_dot*(c_60*(z_31*cos_ag - z_32*sin_ag));
    const double c_61 = c[78];
    const double c_62 = c[79];
    const double z_37 = ab_dot*sin_ab;
    const double z_38 = ab_dot*cos_ab;
    const double z_39 = c_10*z_37 + c_11*z_38;
    const double z_40 = c_10*z_38 - c_11*z_37;
    const double z_41 = c_59*(z_32*z_13 + cos_ac*z_39) - c_59*(z_31*z_14 + sin_ac*z_40);
    const double z_42 = ag_dot*sin_ag;
    const double z_43 = ag_dot*cos_ag;
    const double z_44 = c_60*(cos_ag*z_39 + z_32*z_42) - c_60*(sin_ag*z_40 + z_31*z_43);
    const double c_12 = c[29];
    const double c_63 = c[80];
    const double z_45 = c_63*z_25;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double c_65 = c[82];
    const double af_dot = v[5];
    const double z_47 = c_65*(af_dot*af_dot);
    const double c_64 = c[81];
    const double z_48 = c_64*(ag_dot*ag_dot);
    const double z_49 = cos_ac*z_45 + cos_ag*z_48 - ab_dot*z_40 - cos_af*z_47;
    const double c_9 = c[26];
    const double sin_af = em_sin(af);
    const double z_51 = sin_ac*z_45 + sin_ag*z_48 - ab_dot*z_39 - sin_af*z_47;
    const double c_66 = c[83];
    bias[2] = (1.0/12.0)*((((2.0*z_6 - z_33 - z_36) - 3.0*(cos_ab*c_61 - sin_ab*c_62)) - (2.0*theta_dot*z_12 -
        ac_dot*z_41 - ag_dot*z_44)) - (z_32*c_9*z_51 + c_66*(cos_ab*z_21) - z_31*c_12*z_49));
    const double c_67 = c[84];
    const double c_68 = c[85];
    bias[3] = ((-1.0/3.0))*(sin_ak*z_27*c_67 - cos_ak*z_29*c_68);
    const double c_69 = c[86];
    const double c_37 = c[54];
    const double z_52 = ac_dot*ag_dot*(cos_ag*(sin_ac*c_69) - sin_ag*(cos_ac*c_69) - c_37*(sin_ac*sin_ag) -
        c_37*(cos_ac*cos_ag));
    const double c_70 = c[87];
    const double c_50 = c[67];
    const double z_53 = 2.0*c_50*(sin_ag*z_13 - cos_ac*z_43) + 2.0*c_50*(cos_ag*z_14 - sin_ac*z_42) +
        c_69*(sin_ag*z_14 + sin_ac*z_43) - c_69*(cos_ag*z_13 + cos_ac*z_42);
    const double c_71 = c[88];
    const double c_72 = c[89];
    const double c_73 = c[90];
    const double c_74 = c[91];
    bias[4] = (1.0/12.0)*((((2.0*z_11 + z_33 - z_52) - cos_ac*c_70) + (2.0*theta_dot*z_15 + ab_dot*z_41 -
        ag_dot*z_53)) + 2.0*(cos_ac*c_72*z_51 + c_73*(sin_ac*z_27) - sin_ac*c_71*z_49 - c_74*(cos_ac*z_29)));
    const double c_27 = c[44];
    const double c_28 = c[45];
    bias[5] = (1.0/6.0)*(sin_af*c_27*z_49 - cos_af*c_28*z_51);
    const double c_75 = c[92];
    const double c_76 = c[93];
    const double c_77 = c[94];
    const double c_78 = c[95];
    bias[6] = (1.0/12.0)*((((z_36 + z_52) - 3.0*(cos_ag*c_75 - sin_ag*c_76)) + (ab_dot*z_44 - ac_dot*z_53)) -
        2.0*(sin_ag*c_77*z_49 - cos_ag*c_78*z_51));
    gamma[0] = -(z_22 + cos_aj*z_19 - cos_ab*z_20);
    gamma[1] = -z_21;
    gamma[2] = -z_27;
    gamma[3] = -z_29;
    gamma[4] = 0.5*z_49;
    gamma[5] = 0.5*z_51;
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double theta_dot = v[0];
    const double ab_dot = v[2];
    const double c_5 = c[22];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double sin_theta = em_sin(theta);
    const double z_4 = c_5*(cos_ab*cos_theta + sin_ab*sin_theta);
    const double ac_dot = v[4];
    const double c_52 = c[69];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double sin_ac = em_sin(ac);
    const double z_7 = c_52*(cos_theta*cos_ac + sin_theta*sin_ac);
    const double c_95 = c[112];
    const double c_8 = c[25];
    const double c_59 = c[76];
    const double c_10 = c[27];
    const double c_11 = c[28];
    const double z_8 = cos_ab*c_10 - sin_ab*c_11;
    const double z_9 = cos_ab*c_11;
    const double z_10 = sin_ab*c_10 + z_9;
    const double z_11 = c_59*(cos_ac*z_8 + sin_ac*z_10);
    const double ag_dot = v[6];
    const double c_60 = c[77];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    const double z_14 = c_60*(z_8*cos_ag + z_10*sin_ag);
    const double c_69 = c[86];
    const double c_37 = c[54];
    const double z_15 = cos_ac*cos_ag*c_69 + sin_ac*sin_ag*c_69 + c_37*(sin_ac*cos_ag) - c_37*(cos_ac*sin_ag);
    const double c_96 = c[113];
    const double c_40 = c[57];
    e[0] = (1.0/24.0)*(2.0*theta_dot*(ab_dot*z_4 + ac_dot*z_7 + theta_dot*c_95) + ab_dot*(2.0*theta_dot*z_4 +
        ab_dot*c_8 + ac_dot*z_11 + ag_dot*z_14) + ac_dot*(2.0*theta_dot*z_7 + ab_dot*z_11 + ag_dot*z_15 +
        ac_dot*c_96) + ag_dot*(ab_dot*z_14 + ac_dot*z_15 + ag_dot*c_40));
    e[1] = 0.0;
    e[2] = 0.0;
    const double d = c[3];
    const double c_97 = c[114];
    const double z_16 = z_10 + c_97;
    const double e_ = c[4];
    const double c_98 = c[115];
    const double f = c[5];
    const double c_63 = c[80];
    const double z_17 = sin_ac*c_63;
    const double c_64 = c[81];
    const double h = c[7];
    const double c_99 = c[116];
    const double c_100 = c[117];
    const double c_101 = c[118];
    const double z_18 = cos_ag*c_100 + (c_97 + sin_ac*c_101);
    const double i = c[8];
    const double c_102 = c[119];
    const double c_103 = c[120];
    const double b = c[1];
    const double z_19 = b*sin_ab;
    const double c_104 = c[121];
    const double c_ = c[2];
    const double z_20 = c_*sin_ac;
    const double g = c[6];
    const double m = c[12];
    const double l = c[11];
    const double z_21 = m*sin_theta - l;
    const double c_105 = c[122];
    const double c_106 = c[123];
    const double c_107 = c[124];
    const double c_108 = c[125];
    e[3] = (-0.25)*(theta*c_108 - (d*z_16 + e_*(c_97 + sin_ab*c_98 + z_9) + f*(z_16 + z_17 + sin_ag*c_64) +
        h*(sin_ag*c_99 + z_18) + i*(sin_ag*c_102 + z_18) + c_103*(z_19 + c_104) + (z_20 + c_104)*c_63 +
        c_64*(g*sin_ag + c_104 + z_17) + (z_19 + z_21)*c_105 + (z_20 + z_21)*c_106)*c_107);
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
    const double c_109 = c[126];
    p[2] = p[18] = p[22] = p[30] = c_109;
    const double c_110 = c[127];
    p[3] = p[19] = p[23] = p[31] = c_110;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_102 = c[119];
    const double c_111 = c[128];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_63 = c[80];
    const double sin_ag = em_sin(ag);
    const double c_100 = c[117];
    p[4] = p[44] = p[48] = p[53] = 0.5*(cos_ag*c_102 + c_111 + cos_ac*c_63 - sin_ag*c_100);
    const double c_104 = c[121];
    const double sin_ac = em_sin(ac);
    p[5] = p[45] = p[49] = p[54] = 0.5*(sin_ag*c_102 + c_104 + sin_ac*c_63 + cos_ag*c_100);
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
    const double c_10 = c[27];
    const double c_11 = c[28];
    p[24] = p[28] = p[34] = 0.5*(cos_ab*c_10 + c_111 - sin_ab*c_11);
    p[25] = p[29] = p[35] = 0.5*(sin_ab*c_10 + c_104 + cos_ab*c_11);
    const double g = c[6];
    p[36] = p[40] = p[46] = g*cos_ag + z_8;
    p[37] = p[41] = p[47] = g*sin_ag + z_9;
    const double c_112 = c[129];
    p[52] = p[55] = c_112;
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
    const double J = c[14];
    const double density = c[13];
    const double j = c[9];
    const double z_3 = density*j;
    const double k = c[10];
    const double z_4 = density*k;
    const double z_5 = z_2/(3.0*J + (z_3 + z_4)*z_2);
    const double c_ = c[2];
    const double z_6 = c_*c_;
    const double z_7 = density*c_;
    const double g = c[6];
    const double z_8 = density*g;
    const double i = c[8];
    const double z_9 = density*i;
    const double h = c[7];
    const double z_10 = h*z_7;
    const double z_11 = density*h;
    const double z_12 = z_9 + z_11;
    const double z_13 = c_*z_12 + 0.5*i*z_7;
    const double f = c[5];
    const double z_14 = density*f;
    const double z_15 = z_14 + z_8 + z_11;
    const double z_16 = c_*z_15 + 0.5*g*z_7;
    const double z_17 = z_6/(2.0*z_6*z_7 + 2.0*(z_4 + z_8 + z_9)*z_6 + c_*(2.0*z_10 + 2.0*z_13 + 2.0*z_16) +
        z_8*z_6 + z_9*z_6);
    const double z_18 = 1.0/(1.0439356584272999*z_5 + 1.9779122466912002*z_17);
    const double b = c[1];
    const double z_19 = b*b;
    const double z_20 = density*b;
    const double e = c[4];
    const double z_21 = density*e;
    const double d = c[3];
    const double z_22 = d*d;
    const double z_23 = z_19 + z_22 - e*e;
    const double z_24 = z_21 + density*d + z_14;
    const double z_25 = z_23/b;
    const double z_26 = 4.0 - z_23*z_23/(z_19*z_22);
    const double z_27 = 1.0/(4.0*z_19*z_20 + 4.0*(z_3 + z_21)*z_19 + z_21*z_23 + (e*z_20 + z_24*z_25)*z_25 +
        z_24*z_26*z_22);
    const double z_28 = 1.0/(0.9560643415727004*z_5 + 1.7189244238450625*z_19*z_27);
    const double z_29 = 1.0/(0.9560643415727004*z_5 + 2.0220877533087998*z_17);
    dM[0] = (2.0/3.0)*(cos_theta*sin_theta*(z_2*z_18 - (z_2*z_28 + z_2*z_29)));
    const double z_30 = m*j;
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double z_32 = cos_aj*z_28;
    dM[7] = dM[1] = ((-1.0/3.0))*(sin_theta*z_30*z_32);
    const double z_33 = z_30*z_20;
    const double ab = x[2];
    const double sin_ab = em_sin(ab);
    const double z_35 = cos_theta*sin_ab;
    const double z_36 = b*z_28;
    const double z_37 = z_33 - 2.0*m*z_36;
    const double cos_ab = em_cos(ab);
    const double z_39 = cos_ab*sin_theta;
    dM[14] = dM[2] = (1.0/6.0)*(z_33*z_35 - z_37*z_39);
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double z_41 = sin_theta*cos_ak;
    const double z_42 = m*k;
    const double z_43 = z_29*z_42;
    const double sin_ak = em_sin(ak);
    const double z_45 = cos_theta*sin_ak;
    const double z_46 = z_18*z_42;
    dM[21] = dM[3] = ((-1.0/3.0))*(z_41*z_43 - z_45*z_46);
    const double z_47 = z_7*z_42;
    const double z_48 = m*c_;
    const double z_49 = z_47 - 2.0*z_29*z_48;
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double z_51 = sin_theta*cos_ac;
    const double z_52 = z_47 - 2.0*z_18*z_48;
    const double sin_ac = em_sin(ac);
    const double z_54 = cos_theta*sin_ac;
    dM[28] = dM[4] = ((-1.0/6.0))*(z_49*z_51 - z_52*z_54);
    const double sin_aj = em_sin(aj);
    dM[56] = dM[50] = ((-1.0/3.0))*(cos_theta*sin_aj*z_28*z_30);
    dM[57] = ((-2.0/3.0))*(sin_aj*(j*j)*z_32);
    const double z_56 = j*z_36;
    dM[64] = dM[58] = (1.0/3.0)*(cos_ab*sin_aj*z_56);
    dM[112] = dM[100] = (1.0/6.0)*(z_33*z_39 - z_37*z_35);
    dM[113] = dM[107] = (1.0/3.0)*(sin_ab*cos_aj*z_56);
    const double z_57 = d*sqrt(0.25*z_26);
    const double z_58 = cos_ab*z_25 - 2.0*sin_ab*z_57;
    const double z_59 = sin_ab*z_25 + 2.0*cos_ab*z_57;
    const double z_60 = 0.9799867889375745*z_25 + 0.39812507335168834*z_57;
    const double z_61 = 0.7809576093147158*z_25 - 1.2491680630778932*z_57;
    const double z_62 = g*g;
    const double z_63 = i*i;
    const double z_64 = z_62 + z_63 - h*h;
    const double z_65 = z_64/g;
    const double z_66 = 4.0 - z_64*z_64/(z_62*z_63);
    const double z_67 = z_62/(g*(4.0*g*z_15 + z_11*z_65) + (z_8*h + z_12*z_65)*z_65 + z_12*z_66*z_63);
    const double z_68 = 1.0/(1.9779122466912002*z_17 + z_27*(z_60*z_60) + z_27*(z_61*z_61) +
        0.7654631453230909*z_67);
    const double z_69 = 0.6245840315389466*z_25 + 1.5619152186294316*z_57;
    const double z_70 = 0.19906253667584417*z_25 - 1.959973577875149*z_57;
    const double z_71 = 1.0/(2.0220877533087998*z_17 + 7.234536854676909*z_67 + z_27*(z_69*z_69) +
        z_27*(z_70*z_70));
    dM[114] = ((-1.0/6.0))*(4.0*cos_ab*sin_ab*z_19*z_28 - z_58*z_59*(z_68 - z_71));
    const double z_72 = f*z_7;
    const double z_73 = c_*z_71;
    const double z_74 = z_72 - 2.0*z_73;
    const double z_75 = cos_ac*z_59;
    const double z_76 = c_*z_68;
    const double z_77 = z_72 - 2.0*z_76;
    const double z_78 = sin_ac*z_58;
    dM[128] = dM[116] = ((-1.0/12.0))*(z_74*z_75 - z_77*z_78);
    const double af = x[5];
    const double sin_af = em_sin(af);
    const double z_80 = f*sin_af;
    const double z_81 = z_58*z_80;
    const double cos_af = em_cos(af);
    const double z_83 = f*cos_af;
    const double z_84 = z_59*z_83;
    dM[135] = dM[117] = (1.0/6.0)*(z_68*z_81 - z_71*z_84);
    const double z_85 = f*z_8;
    const double z_86 = g*z_71;
    const double z_87 = z_85 - 2.0*z_86;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_89 = z_59*cos_ag;
    const double z_90 = g*z_68;
    const double z_91 = z_85 - 2.0*z_90;
    const double sin_ag = em_sin(ag);
    const double z_93 = z_58*sin_ag;
    dM[142] = dM[118] = ((-1.0/12.0))*(z_87*z_89 - z_91*z_93);
    dM[168] = dM[150] = ((-1.0/3.0))*(z_45*z_43 - z_41*z_46);
    const double z_94 = k*k;
    dM[171] = ((-2.0/3.0))*(cos_ak*sin_ak*(z_29*z_94 - z_18*z_94));
    const double z_95 = cos_ac*sin_ak;
    const double z_96 = k*c_;
    const double z_97 = z_29*z_96;
    const double z_98 = sin_ac*cos_ak;
    const double z_99 = z_18*z_96;
    dM[178] = dM[172] = (1.0/3.0)*(z_95*z_97 - z_98*z_99);
    dM[224] = dM[200] = ((-1.0/6.0))*(z_49*z_54 - z_52*z_51);
    dM[226] = dM[214] = ((-1.0/12.0))*(z_74*z_78 - z_77*z_75);
    dM[227] = dM[221] = (1.0/3.0)*(z_98*z_97 - z_95*z_99);
    dM[228] = ((-2.0/3.0))*(cos_ac*sin_ac*((z_6*z_29 + z_6*z_71) - (z_6*z_18 + z_6*z_68)));
    const double z_100 = sin_ac*z_83;
    const double z_101 = cos_ac*z_80;
    dM[235] = dM[229] = (1.0/3.0)*(z_73*z_100 - z_76*z_101);
    const double z_102 = z_10 + 2.0*z_13;
    const double z_103 = 2.0*g*(z_10 + 2.0*z_16) + z_102*z_65;
    const double z_104 = z_103 + 4.0*g*z_73;
    const double z_105 = sin_ac*cos_ag;
    const double z_106 = z_103 + 4.0*g*z_76;
    const double z_107 = cos_ac*sin_ag;
    const double z_108 = sqrt(0.25*z_66)*(i*z_102);
    const double z_109 = sin_ac*sin_ag*z_108 + cos_ac*cos_ag*z_108;
    dM[242] = dM[230] = (1.0/12.0)*(z_106*z_107 + 2.0*z_109 - z_104*z_105);
    dM[282] = dM[264] = (1.0/6.0)*(z_68*z_84 - z_71*z_81);
    dM[284] = dM[278] = (1.0/3.0)*(z_73*z_101 - z_76*z_100);
    const double z_110 = f*f;
    dM[285] = ((-2.0/3.0))*(sin_af*cos_af*(z_71*z_110 - z_68*z_110));
    const double z_111 = cos_ag*z_80;
    const double z_112 = sin_ag*z_83;
    dM[292] = dM[286] = (1.0/3.0)*(z_86*z_111 - z_90*z_112);
    dM[338] = dM[314] = ((-1.0/12.0))*(z_87*z_93 - z_91*z_89);
    dM[340] = dM[328] = ((-1.0/12.0))*(z_104*z_107 + 2.0*z_109 - z_106*z_105);
    dM[341] = dM[335] = (1.0/3.0)*(z_86*z_112 - z_90*z_111);
    dM[342] = ((-2.0/3.0))*(cos_ag*sin_ag*(z_62*z_71 - z_62*z_68));
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
    const double z_2 = m*cos_theta;
    const double z_3 = z_1*z_2;
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
    const double z_30 = z_12*z_29;
    const double z_31 = m*density;
    const double z_32 = k*c_;
    const double z_33 = z_31*z_32;
    const double z_34 = cos_ac*z_33;
    const double b = c[1];
    const double z_35 = j*b;
    const double z_36 = z_31*z_35;
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double ab_dot = v[2];
    const double z_38 = ab_dot*ab_dot;
    const double z_39 = cos_ab*z_38;
    const double z_40 = b*b;
    const double e = c[4];
    const double z_41 = density*e;
    const double d = c[3];
    const double z_42 = d*d;
    const double z_43 = z_40 + z_42 - e*e;
    const double z_44 = z_41 + density*d + z_25;
    const double z_45 = z_43/b;
    const double z_46 = 4.0 - z_43*z_43/(z_40*z_42);
    const double z_47 = 1.0/(4.0*density*b*z_40 + 4.0*(z_14 + z_41)*z_40 + z_41*z_43 + (b*z_41 + z_44*z_45)*z_45 +
        z_44*z_46*z_42);
    const double z_48 = 1.0/(0.9560643415727004*z_16 + 1.7189244238450625*z_40*z_47);
    const double z_49 = m*z_48;
    const double z_50 = 1.0/(0.9560643415727004*z_16 + 2.0220877533087998*z_28);
    const double z_51 = m*z_50;
    const double z_52 = z_49 + z_51;
    const double z_53 = c_*z_29;
    const double z_54 = m*z_53;
    const double z_55 = z_33 - 2.0*z_54;
    const double sin_ac = em_sin(ac);
    const double ac_ddot = a[4];
    const double z_57 = sin_ac*ac_ddot;
    const double ak_ddot = a[3];
    const double z_58 = m*k;
    const double sin_ak = em_sin(ak);
    const double z_60 = sin_ak*z_29;
    const double z_61 = z_58*z_60;
    const double theta_ddot = a[0];
    const double sin_theta = em_sin(theta);
    const double z_63 = sin_theta*z_29;
    const double z_64 = z_13*z_63;
    const double ab_ddot = a[2];
    const double sin_ab = em_sin(ab);
    const double z_66 = sin_ab*z_36;
    const double gravity = c[16];
    const double z_67 = density*gravity;
    const double z_68 = k*z_67;
    const double z_69 = j*z_67;
    const double lambda_3 = lambda[3];
    const double lambda_1 = lambda[1];
    const double aj_ddot = a[1];
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double z_71 = cos_aj*z_48;
    const double z_72 = j*z_71;
    const double z_73 = m*sin_theta;
    const double z_74 = z_1*z_73;
    const double z_75 = k*sin_ak;
    const double z_76 = z_4*z_75;
    const double z_77 = c_*sin_ac;
    const double z_78 = z_8*z_77;
    const double z_79 = z_74 + z_76 - z_78;
    const double aj_dot = v[1];
    const double z_80 = aj_dot*aj_dot;
    const double sin_aj = em_sin(aj);
    const double z_82 = j*sin_aj;
    const double z_83 = z_80*z_82;
    const double z_84 = b*sin_ab;
    const double z_85 = z_38*z_84;
    const double z_86 = z_74 + z_83 - z_85;
    const double z_87 = c_*z_51;
    const double z_88 = z_33 - 2.0*z_87;
    const double z_89 = cos_ac*ac_ddot;
    const double z_90 = cos_ak*z_50;
    const double z_91 = z_58*z_90;
    const double z_92 = b*z_49;
    const double z_93 = z_36 - 2.0*z_92;
    const double z_94 = cos_ab*z_93;
    D[0] = ((-1.0/6.0))*(cos_theta*(6.0*m*lambda_2 + 6.0*m*lambda_0 + 2.0*z_3*z_52 - 2.0*m*z_30 - z_8*z_34 -
        z_36*z_39 - z_55*z_57 - 2.0*ak_ddot*z_61 - 4.0*theta_ddot*z_64 - ab_ddot*z_66) + sin_theta*(3.0*m*(z_68 +
        z_69) + 6.0*m*lambda_3 + 6.0*m*lambda_1 + 2.0*m*aj_ddot*z_72 + 2.0*z_1*z_64 + z_88*z_89 + 2.0*ak_ddot*z_91
        + ab_ddot*z_94 + 4.0*cos_theta*(z_13*z_48 + z_13*z_50)*theta_ddot - 2.0*z_79*z_51 - 2.0*z_86*z_49 -
        sin_ac*z_33*z_8 - z_38*z_66));
    const double z_95 = aj_ddot*z_82;
    const double z_96 = z_48*z_2;
    D[1] = ((-1.0/3.0))*(z_80*z_2*z_72 + z_95*z_96);
    const double z_97 = sin_theta*z_36;
    const double z_98 = cos_theta*z_93;
    D[2] = (1.0/6.0)*(cos_ab*(ab_ddot*z_97 - z_38*z_98) - sin_ab*(z_38*z_97 + ab_ddot*z_98));
    const double z_99 = cos_theta*z_58;
    const double z_100 = z_50*z_99;
    const double z_101 = z_58*z_63;
    D[3] = ((-1.0/3.0))*(cos_ak*(z_4*z_100 - ak_ddot*z_101) + sin_ak*(z_4*z_101 + ak_ddot*z_100));
    const double z_102 = sin_theta*z_55;
    const double z_103 = cos_theta*z_88;
    D[4] = (1.0/6.0)*(cos_ac*(ac_ddot*z_102 - z_8*z_103) - sin_ac*(ac_ddot*z_103 + z_8*z_102));
    const double z_104 = ab_dot*cos_ab;
    const double z_105 = z_104*z_97;
    const double z_106 = ab_dot*sin_ab;
    const double z_107 = cos_theta*z_36;
    const double z_108 = z_106*z_107;
    const double z_109 = ac_dot*sin_ac;
    const double z_110 = cos_theta*z_33;
    const double z_111 = z_109*z_110;
    const double z_112 = ac_dot*cos_ac;
    const double z_113 = sin_theta*z_33;
    const double z_114 = z_112*z_113;
    const double z_115 = sin_ac*z_110;
    const double z_116 = cos_ac*z_113 - z_115;
    const double z_117 = ac_dot*z_116;
    const double z_118 = cos_ab*z_97 - cos_theta*z_66;
    const double z_119 = ab_dot*z_118;
    const double z_120 = theta_dot*sin_theta;
    D[7] = ((-1.0/6.0))*(z_105 + z_114 - z_108 - z_111 - z_117 - z_119 - 4.0*cos_theta*(z_13*z_29 -
        m*z_52)*z_120);
    const double z_121 = aj_dot*z_82;
    D[8] = ((-2.0/3.0))*(z_121*z_96);
    const double z_122 = theta_dot*cos_theta;
    const double z_123 = z_66*z_122;
    const double z_124 = cos_ab*z_120;
    const double z_125 = z_36*z_124;
    const double z_126 = (z_105 + z_123) - (z_108 + z_125);
    const double z_127 = theta_dot*z_118;
    const double z_128 = z_36 - 4.0*z_92;
    D[9] = (1.0/6.0)*(z_105 + z_126 + z_127 - cos_theta*z_128*z_106);
    const double z_129 = ak_dot*sin_ak;
    const double z_130 = ak_dot*cos_ak;
    D[10] = ((-2.0/3.0))*(z_100*z_129 - z_130*z_101);
    const double z_131 = z_120*z_34;
    const double z_132 = theta_dot*z_115;
    const double z_133 = (z_131 + z_111) - (z_132 + z_114);
    const double z_134 = theta_dot*z_116;
    const double z_135 = z_33 - 4.0*z_87;
    const double z_136 = z_33 - 4.0*z_54;
    D[11] = ((-1.0/6.0))*(z_133 + cos_theta*z_135*z_109 - z_134 - sin_theta*z_136*z_112);
    const double z_137 = theta_ddot*z_73;
    D[14] = ((-1.0/3.0))*(z_3*z_72 + z_137*z_72);
    const double z_138 = j*j*z_71;
    const double z_139 = cos_ab*z_48;
    const double z_140 = z_35*z_139;
    const double z_141 = z_86*z_48;
    D[15] = ((-1.0/3.0))*(cos_aj*(3.0*j*lambda_0 + z_80*z_138) + sin_aj*(3.0*j*lambda_1 + 2.0*aj_ddot*z_138 +
        j*theta_ddot*z_96 - ab_ddot*z_140 - j*z_141));
    const double z_142 = z_35*z_71;
    D[16] = (1.0/3.0)*(z_142*z_39 + sin_ab*ab_ddot*z_142);
    const double z_143 = m*z_120;
    D[21] = ((-2.0/3.0))*(z_143*z_72);
    const double z_144 = aj_dot*sin_aj;
    D[22] = ((-2.0/3.0))*(z_138*z_144);
    D[23] = (2.0/3.0)*(z_106*z_142);
    D[28] = (1.0/6.0)*(cos_theta*(theta_ddot*z_66 - z_1*z_94) - sin_theta*(z_1*z_66 + theta_ddot*z_94));
    D[29] = (1.0/3.0)*(cos_ab*z_80*z_142 + sin_aj*aj_ddot*z_140);
    const double z_145 = d*sqrt(0.25*z_46);
    const double z_146 = e*z_67;
    const double z_147 = z_25*gravity;
    const double z_148 = z_147 + d*z_67;
    const double z_149 = z_40*z_139;
    const double z_150 = z_25*g;
    const double ag_dot = v[6];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_152 = ag_dot*cos_ag;
    const double z_153 = c_*z_25;
    const double z_154 = cos_ab*z_45;
    const double z_155 = sin_ab*z_145;
    const double z_156 = z_154 - 2.0*z_155;
    const double z_157 = g*g;
    const double z_158 = i*i;
    const double z_159 = z_157 + z_158 - h*h;
    const double z_160 = z_159/g;
    const double z_161 = 4.0 - z_159*z_159/(z_157*z_158);
    const double z_162 = z_157/(g*(4.0*g*z_26 + z_22*z_160) + (z_19*h + z_23*z_160)*z_160 + z_23*z_161*z_158);
    const double z_163 = 0.6245840315389466*z_45 + 1.5619152186294316*z_145;
    const double z_164 = 0.19906253667584417*z_45 - 1.959973577875149*z_145;
    const double z_165 = 1.0/(2.0220877533087998*z_28 + 7.234536854676909*z_162 + z_47*(z_163*z_163) +
        z_47*(z_164*z_164));
    const double z_166 = z_150*z_152 + z_153*z_112 + ab_dot*z_156*z_165;
    const double z_167 = ab_dot*z_45;
    const double sin_ag = em_sin(ag);
    const double z_169 = ag_dot*sin_ag;
    const double z_170 = sin_ab*z_45;
    const double z_171 = cos_ab*z_145;
    const double z_172 = z_170 + 2.0*z_171;
    const double z_173 = 0.9799867889375745*z_45 + 0.39812507335168834*z_145;
    const double z_174 = 0.7809576093147158*z_45 - 1.2491680630778932*z_145;
    const double z_175 = 1.0/(1.9779122466912002*z_28 + z_47*(z_173*z_173) + z_47*(z_174*z_174) +
        0.7654631453230909*z_162);
    const double z_176 = z_150*z_169 + z_153*z_109 + ab_dot*z_172*z_175;
    const double z_177 = ab_dot*z_145;
    const double z_178 = ab_dot*z_150;
    const double z_179 = ab_dot*z_153;
    const double z_180 = z_45*z_104;
    const double z_181 = z_145*z_106;
    const double z_182 = z_180 - 2.0*z_181;
    const double af_dot = v[5];
    const double z_183 = af_dot*af_dot;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double z_185 = f*cos_af;
    const double z_186 = z_183*z_185;
    const double z_187 = ag_dot*ag_dot;
    const double z_188 = g*cos_ag;
    const double z_189 = z_187*z_188;
    const double z_190 = 2.0*z_11 + 2.0*z_189 - ab_dot*z_182 - 2.0*z_186;
    const double lambda_4 = lambda[4];
    const double z_191 = cos_ag*z_150;
    const double z_192 = cos_ac*z_153;
    const double ag_ddot = a[6];
    const double z_193 = g*z_175;
    const double z_194 = z_150 - 2.0*z_193;
    const double z_195 = sin_ag*z_194;
    const double af_ddot = a[5];
    const double sin_af = em_sin(af);
    const double z_197 = f*z_175;
    const double z_198 = sin_af*z_197;
    const double z_199 = c_*z_175;
    const double z_200 = z_153 - 2.0*z_199;
    const double z_201 = sin_ac*z_200;
    const double z_202 = z_172*ab_ddot;
    const double z_203 = z_152*z_178 + z_112*z_179 + z_187*z_191 + z_8*z_192 + ag_ddot*z_195 + 2.0*af_ddot*z_198 +
        ac_ddot*z_201 + 2.0*z_175*z_202 - z_190*z_175 - 6.0*lambda_4;
    const double z_204 = z_45*z_106;
    const double z_205 = z_145*z_104;
    const double z_206 = z_204 + 2.0*z_205;
    const double z_207 = f*sin_af;
    const double z_208 = z_183*z_207;
    const double z_209 = g*sin_ag;
    const double z_210 = z_187*z_209;
    const double z_211 = 2.0*z_78 + 2.0*z_210 - ab_dot*z_206 - 2.0*z_208;
    const double lambda_5 = lambda[5];
    const double z_212 = sin_ag*z_150;
    const double z_213 = sin_ac*z_153;
    const double z_214 = g*z_165;
    const double z_215 = z_150 - 2.0*z_214;
    const double z_216 = cos_ag*z_215;
    const double z_217 = f*z_165;
    const double z_218 = cos_af*z_217;
    const double z_219 = c_*z_165;
    const double z_220 = z_153 - 2.0*z_219;
    const double z_221 = cos_ac*z_220;
    const double z_222 = z_156*ab_ddot;
    const double z_223 = z_169*z_178 + z_109*z_179 + z_187*z_212 + z_8*z_213 - z_211*z_165 - 6.0*lambda_5 -
        ag_ddot*z_216 - 2.0*af_ddot*z_218 - ac_ddot*z_221 - 2.0*z_165*z_222;
    D[30] = ((-1.0/12.0))*(cos_ab*(6.0*z_145*(z_146 + z_148) + 4.0*z_38*z_149 + z_166*z_167 + 2.0*z_176*z_177 -
        12.0*b*lambda_0 - 2.0*z_1*z_107 - z_45*z_203 - 2.0*z_145*z_223 - 2.0*theta_ddot*z_97) +
        sin_ab*(3.0*((2.0*b + z_45)*z_146 + 2.0*b*(z_69 + b*z_67) + z_45*z_148) + 4.0*b*z_141 + z_176*z_167 +
        8.0*ab_ddot*z_149 + 2.0*theta_ddot*z_98 + 2.0*z_145*z_203 - 12.0*b*lambda_1 - 4.0*aj_ddot*z_142 -
        2.0*z_1*z_97 - 2.0*z_166*z_177 - z_45*z_223));
    const double z_224 = ac_dot*z_179;
    const double z_225 = ac_dot*z_153;
    const double z_226 = z_172*z_200;
    const double z_227 = z_156*z_220;
    D[32] = ((-1.0/12.0))*(cos_ac*(z_156*z_224 + z_8*z_227 - z_182*z_225 - ac_ddot*z_226) + sin_ac*(z_172*z_224 +
        ac_ddot*z_227 + z_8*z_226 - z_206*z_225));
    const double z_228 = z_172*z_197;
    const double z_229 = z_156*z_217;
    D[33] = ((-1.0/6.0))*(sin_af*(z_183*z_228 + af_ddot*z_229) + cos_af*(z_183*z_229 - af_ddot*z_228));
    const double z_230 = ag_dot*z_178;
    const double z_231 = ag_dot*z_150;
    const double z_232 = z_172*z_194;
    const double z_233 = z_156*z_215;
    D[34] = ((-1.0/12.0))*(cos_ag*(z_156*z_230 + z_187*z_233 - z_182*z_231 - ag_ddot*z_232) + sin_ag*(z_172*z_230
        + ag_ddot*z_233 + z_187*z_232 - z_206*z_231));
    D[35] = (1.0/6.0)*(z_123 + z_126 - z_119 - z_128*z_124);
    D[36] = (2.0/3.0)*(z_140*z_144);
    const double z_234 = z_206*z_165;
    const double z_235 = z_182*z_175;
    const double z_236 = z_172*z_191 - z_156*z_212;
    const double z_237 = ag_dot*z_236;
    const double z_238 = z_172*z_192 - z_156*z_213;
    const double z_239 = ac_dot*z_238;
    D[37] = ((-1.0/12.0))*(2.0*z_123 + z_156*z_234 + 8.0*z_106*z_149 + 2.0*z_127 + 2.0*z_171*z_166 + z_170*z_166 +
        2.0*z_155*z_176 - z_172*z_235 - 2.0*z_125 - z_237 - z_239 - z_154*z_176);
    const double z_240 = z_156*z_109;
    const double z_241 = z_172*z_112;
    const double z_242 = (z_153*z_240 + z_206*z_192) - (z_153*z_241 + z_182*z_213);
    const double z_243 = ab_dot*z_238;
    D[39] = ((-1.0/12.0))*(z_242 + (z_153 - 4.0*z_219)*z_240 - z_243 - (z_153 - 4.0*z_199)*z_241);
    const double z_244 = af_dot*cos_af;
    const double z_245 = af_dot*sin_af;
    D[40] = (1.0/3.0)*(z_244*z_228 - z_245*z_229);
    const double z_246 = z_156*z_169;
    const double z_247 = z_172*z_152;
    const double z_248 = (z_206*z_191 + z_150*z_246) - (z_182*z_212 + z_150*z_247);
    const double z_249 = ab_dot*z_236;
    D[41] = ((-1.0/12.0))*(z_248 + (z_150 - 4.0*z_214)*z_246 - z_249 - (z_150 - 4.0*z_193)*z_247);
    D[42] = ((-1.0/3.0))*(cos_theta*(z_1*z_91 - theta_ddot*z_61) + sin_theta*(z_1*z_61 + theta_ddot*z_91));
    const double z_250 = k*k;
    const double z_251 = z_4*z_250;
    const double z_252 = ak_ddot*z_250;
    D[45] = ((-1.0/3.0))*(cos_ak*(3.0*k*lambda_2 + z_90*z_251 + z_29*z_32*z_57 - k*z_30 - 2.0*z_60*z_252 -
        theta_ddot*z_101) + sin_ak*(3.0*k*lambda_3 + z_60*z_251 + 2.0*z_90*z_252 + theta_ddot*z_100 - k*z_79*z_50
        - z_50*z_32*z_89));
    const double z_253 = z_32*z_90;
    const double z_254 = z_32*z_60;
    D[46] = (1.0/3.0)*(cos_ac*(z_8*z_253 - ac_ddot*z_254) + sin_ac*(z_8*z_254 + ac_ddot*z_253));
    D[49] = ((-2.0/3.0))*(z_120*z_91 - theta_dot*z_60*z_99);
    D[52] = ((-2.0/3.0))*(sin_ak*(z_50*z_250 - z_29*z_250)*z_130);
    D[53] = (2.0/3.0)*(z_109*z_253 - z_112*z_254);
    const double z_255 = sin_ac*z_55;
    const double z_256 = cos_ac*z_88;
    D[56] = (1.0/6.0)*(cos_theta*(theta_ddot*z_255 - z_1*z_256) - sin_theta*(theta_ddot*z_256 + z_1*z_255));
    const double z_257 = z_45*z_38;
    const double z_258 = z_145*z_38;
    const double z_259 = z_45*ab_ddot;
    const double z_260 = z_145*ab_ddot;
    D[58] = ((-1.0/12.0))*(cos_ab*(z_257*z_221 + 2.0*z_258*z_201 + 2.0*z_260*z_221 - z_259*z_201) -
        sin_ab*(2.0*z_258*z_221 - z_257*z_201 - 2.0*z_260*z_201 - z_259*z_221));
    const double z_261 = cos_ac*z_50;
    const double z_262 = z_4*z_32;
    const double z_263 = ak_ddot*z_32;
    const double z_264 = sin_ac*z_29;
    D[59] = (1.0/3.0)*(cos_ak*(z_261*z_262 - z_263*z_264) + sin_ak*(z_264*z_262 + z_263*z_261));
    const double z_265 = z_21 + 2.0*z_24;
    const double z_266 = 2.0*g*(z_21 + 2.0*z_27) + z_265*z_160;
    const double z_267 = cos_ag*z_266;
    const double z_268 = i*sqrt(0.25*z_161);
    const double z_269 = z_265*z_268;
    const double z_270 = sin_ag*z_269;
    const double z_271 = c_*z_50;
    const double z_272 = z_219 + z_271;
    const double z_273 = g*z_199;
    const double z_274 = z_266 + 4.0*z_273;
    const double z_275 = sin_ag*z_274;
    const double z_276 = c_*z_198;
    const double z_277 = cos_ag*z_269;
    const double z_278 = g*z_67;
    const double z_279 = i*z_67;
    const double z_280 = h*z_67;
    const double z_281 = z_279 + z_280;
    const double z_282 = sin_ag*z_266;
    const double z_283 = z_199 + z_53;
    const double z_284 = g*z_219;
    const double z_285 = z_266 + 4.0*z_284;
    const double z_286 = cos_ag*z_285;
    const double z_287 = c_*z_218;
    D[60] = (1.0/12.0)*(cos_ac*(12.0*c_*lambda_4 + 12.0*c_*lambda_2 + 2.0*z_199*z_190 + z_187*z_267 + z_182*z_179
        + 2.0*z_1*z_110 + ag_ddot*z_275 + 8.0*(z_17*z_29 + z_17*z_175)*z_57 + z_200*z_202 + 2.0*theta_ddot*z_102 +
        2.0*ag_ddot*z_277 - 4.0*z_12*z_53 - 2.0*z_187*z_270 - 4.0*z_11*z_272 - 4.0*af_ddot*z_276 - 4.0*z_60*z_263)
        - sin_ac*(6.0*c_*(z_68 + 2.0*z_278 + c_*z_67 + 2.0*z_281 + z_147) + 4.0*z_79*z_271 + 4.0*z_78*z_283 +
        ag_ddot*z_286 + 8.0*(z_17*z_50 + z_17*z_165)*z_89 + z_220*z_222 + 2.0*theta_ddot*z_103 - 12.0*c_*lambda_5
        - 12.0*c_*lambda_3 - 2.0*z_219*z_211 - z_187*z_282 - z_206*z_179 - 2.0*z_1*z_113 - 2.0*z_187*z_277 -
        4.0*af_ddot*z_287 - 4.0*z_90*z_263 - 2.0*ag_ddot*z_270));
    const double z_288 = z_197*z_77;
    const double z_289 = z_217*z_10;
    D[61] = (1.0/3.0)*(sin_af*(z_183*z_288 + af_ddot*z_289) + cos_af*(z_183*z_289 - af_ddot*z_288));
    const double z_290 = sin_ac*z_269;
    const double z_291 = sin_ac*z_274;
    const double z_292 = cos_ac*z_269;
    const double z_293 = cos_ac*z_285;
    D[62] = ((-1.0/12.0))*(cos_ag*(2.0*z_187*z_290 + 2.0*ag_ddot*z_292 + z_187*z_293 - ag_ddot*z_291) -
        sin_ag*(2.0*z_187*z_292 - ag_ddot*z_293 - 2.0*ag_ddot*z_290 - z_187*z_291));
    D[63] = ((-1.0/6.0))*(z_133 + z_117 + cos_ac*z_135*z_120 - sin_ac*z_136*z_122);
    D[65] = ((-1.0/12.0))*(z_242 + z_239 + 2.0*z_77*z_235 + 2.0*z_205*z_221 + z_204*z_221 + 2.0*z_181*z_201 -
        2.0*z_10*z_234 - z_180*z_201);
    D[66] = (2.0/3.0)*(z_32*z_129*z_261 - z_32*z_130*z_264);
    const double z_294 = cos_ac*z_266;
    const double z_295 = z_169*z_294;
    const double z_296 = sin_ac*z_266;
    const double z_297 = z_152*z_296;
    const double z_298 = cos_ag*z_296 - sin_ag*z_294 - 2.0*sin_ag*z_290 - 2.0*cos_ag*z_292;
    const double z_299 = ag_dot*z_298;
    const double z_300 = z_152*z_292;
    const double z_301 = z_169*z_290;
    const double z_302 = z_300 + z_301;
    D[67] = (1.0/12.0)*(2.0*z_131 + z_295 + cos_ac*z_172*z_179 + z_299 + 2.0*z_302 - 2.0*z_132 - z_297 - 2.0*z_134
        - z_243 - sin_ac*z_156*z_179 - 8.0*sin_ac*(c_*z_272 - c_*z_283)*z_112);
    D[68] = (2.0/3.0)*(z_245*z_289 - z_244*z_288);
    const double z_303 = z_109*z_270;
    const double z_304 = z_112*z_277;
    const double z_305 = z_109*z_267;
    const double z_306 = z_112*z_282;
    const double z_307 = 2.0*(z_303 - z_300) + 2.0*(z_304 - z_301) + (z_306 + z_297) - (z_305 + z_295);
    const double z_308 = ac_dot*z_298;
    const double z_309 = z_266 + 8.0*z_284;
    const double z_310 = z_266 + 8.0*z_273;
    D[69] = ((-1.0/12.0))*(cos_ac*z_309*z_169 + 2.0*z_302 - z_307 - z_308 - sin_ac*z_310*z_152);
    D[72] = ((-1.0/6.0))*(cos_ab*(z_257*z_218 + 2.0*z_258*z_198 + 2.0*z_260*z_218 - z_259*z_198) -
        sin_ab*(2.0*z_258*z_218 - z_257*z_198 - 2.0*z_260*z_198 - z_259*z_218));
    D[74] = (1.0/3.0)*(cos_ac*(z_8*z_287 - ac_ddot*z_276) + sin_ac*(z_8*z_276 + ac_ddot*z_287));
    const double z_311 = f*f;
    const double z_312 = z_175*z_311;
    const double z_313 = sin_af*z_312;
    const double z_314 = z_217*z_188;
    const double z_315 = z_165*z_311;
    const double z_316 = cos_af*z_315;
    const double z_317 = z_197*z_209;
    D[75] = ((-1.0/6.0))*(sin_af*(6.0*f*lambda_5 + z_211*z_217 + 2.0*z_183*z_313 + 4.0*af_ddot*z_316 + z_217*z_222
        - 2.0*ag_ddot*z_314 - 2.0*ac_ddot*z_289) + cos_af*(6.0*f*lambda_4 + z_190*z_197 + 2.0*z_183*z_316 +
        2.0*ag_ddot*z_317 + 2.0*ac_ddot*z_288 - 4.0*af_ddot*z_313 - z_197*z_202));
    const double z_318 = g*z_218;
    const double z_319 = g*z_198;
    D[76] = (1.0/3.0)*(cos_ag*(z_187*z_318 - ag_ddot*z_319) + sin_ag*(z_187*z_319 + ag_ddot*z_318));
    D[79] = (1.0/6.0)*(z_182*z_198 + z_180*z_198 - z_206*z_218 - 2.0*z_205*z_218 - z_204*z_218 - 2.0*z_181*z_198);
    D[81] = (2.0/3.0)*(z_109*z_287 - z_112*z_276);
    D[82] = ((-2.0/3.0))*(cos_af*(z_315 - z_312)*z_245);
    D[83] = (2.0/3.0)*(z_169*z_318 - z_152*z_319);
    D[86] = ((-1.0/12.0))*(cos_ab*(z_257*z_216 + 2.0*z_258*z_195 + 2.0*z_260*z_216 - z_259*z_195) -
        sin_ab*(2.0*z_258*z_216 - z_257*z_195 - 2.0*z_260*z_195 - z_259*z_216));
    D[88] = (1.0/12.0)*(cos_ac*(2.0*z_8*z_270 + ac_ddot*z_275 + 2.0*ac_ddot*z_277 - z_8*z_286) -
        sin_ac*(2.0*z_8*z_277 + ac_ddot*z_286 + z_8*z_275 - 2.0*ac_ddot*z_270));
    D[89] = (1.0/3.0)*(sin_af*(z_183*z_317 + af_ddot*z_314) + cos_af*(z_183*z_314 - af_ddot*z_317));
    const double z_320 = z_157*z_165;
    const double z_321 = cos_ag*z_320;
    const double z_322 = z_157*z_175;
    const double z_323 = sin_ag*z_322;
    D[90] = ((-1.0/12.0))*(cos_ag*(6.0*z_281*z_268 + 4.0*z_187*z_321 + 4.0*af_ddot*z_319 + 2.0*ac_ddot*z_292 -
        12.0*g*lambda_4 - 2.0*z_193*z_190 - z_8*z_294 - z_182*z_178 - 2.0*z_8*z_290 - 8.0*ag_ddot*z_323 -
        z_274*z_57 - z_194*z_202) + sin_ag*(3.0*(z_160*z_279 + (2.0*g + z_160)*z_280 + 2.0*g*(z_278 + z_147)) +
        2.0*z_8*z_292 + 4.0*z_187*z_323 + 8.0*ag_ddot*z_321 + z_285*z_89 + z_215*z_222 + 2.0*ac_ddot*z_290 -
        12.0*g*lambda_5 - 2.0*z_214*z_211 - z_8*z_296 - z_206*z_178 - 4.0*af_ddot*z_318));
    D[93] = ((-1.0/12.0))*(z_248 + z_237 + 2.0*z_209*z_235 + 2.0*z_205*z_216 + z_204*z_216 + 2.0*z_181*z_195 -
        2.0*z_188*z_234 - z_180*z_195);
    const double z_324 = z_303 + z_304;
    D[95] = (1.0/12.0)*(z_307 + sin_ag*z_310*z_112 + 2.0*z_324 - z_299 - cos_ag*z_309*z_109);
    D[96] = (2.0/3.0)*(z_245*z_314 - z_244*z_317);
    D[97] = ((-1.0/12.0))*(8.0*sin_ag*(z_320 - z_322)*z_152 + z_306 + z_249 + z_308 + z_156*sin_ag*z_178 +
        2.0*z_324 - z_305 - z_172*cos_ag*z_178);
    D[98] = z_74 - theta_ddot*z_2;
    const double z_325 = j*cos_aj;
    D[99] = z_83 - aj_ddot*z_325;
    D[100] = -(z_85 - b*cos_ab*ab_ddot);
    D[105] = (-2.0)*(theta_dot*z_2);
    D[106] = (-2.0)*(aj_dot*z_325);
    D[107] = 2.0*(b*z_104);
    D[112] = -(z_3 + z_137);
    D[113] = -(z_80*z_325 + z_95);
    D[114] = b*z_39 + ab_ddot*z_84;
    D[119] = (-2.0)*z_143;
    D[120] = (-2.0)*z_121;
    D[121] = 2.0*(b*z_106);
    D[126] = z_74 - theta_ddot*z_2;
    D[129] = z_76 - ak_ddot*z_6;
    D[130] = -(z_78 - ac_ddot*z_10);
    D[133] = (-2.0)*(theta_dot*z_2);
    D[136] = (-2.0)*(k*z_130);
    D[137] = 2.0*(c_*z_112);
    D[140] = -(z_3 + z_137);
    D[143] = -(z_7 + ak_ddot*z_75);
    D[144] = z_11 + ac_ddot*z_77;
    D[147] = (-2.0)*z_143;
    D[150] = (-2.0)*(k*z_129);
    D[151] = 2.0*(c_*z_109);
    const double z_326 = 2.0*z_258 - z_259;
    const double z_327 = z_257 + 2.0*z_260;
    D[156] = 0.5*(cos_ab*z_326 + sin_ab*z_327);
    D[158] = -(z_78 - ac_ddot*z_10);
    D[159] = z_208 - af_ddot*z_185;
    D[160] = -(z_210 - ag_ddot*z_188);
    D[163] = (-0.5)*(z_182 + z_182);
    D[165] = 2.0*(c_*z_112);
    D[166] = (-2.0)*(f*z_244);
    D[167] = 2.0*(g*z_152);
    D[170] = (-0.5)*(cos_ab*z_327 - sin_ab*z_326);
    D[172] = z_11 + ac_ddot*z_77;
    D[173] = -(z_186 + af_ddot*z_207);
    D[174] = z_189 + ag_ddot*z_209;
    D[177] = (-0.5)*(z_206 + z_206);
    D[179] = 2.0*(c_*z_109);
    D[180] = (-2.0)*(f*z_245);
    D[181] = 2.0*(g*z_169);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double density = c[13];
    const double j = c[9];
    const double z_0 = density*j;
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double ab_dot = v[2];
    const double z_2 = ab_dot*ab_dot;
    const double z_3 = cos_ab*z_2;
    const double m = c[12];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double z_5 = m*sin_theta;
    const double z_6 = z_3*z_5;
    const double sin_ab = em_sin(ab);
    const double ab_ddot = a[2];
    const double z_8 = sin_ab*ab_ddot;
    const double z_9 = z_8*z_5;
    const double z_10 = m*m;
    const double J = c[14];
    const double k = c[10];
    const double z_11 = density*k;
    const double z_12 = z_0 + z_11;
    const double z_13 = 3.0*J + z_12*z_10;
    const double z_14 = 1.0/z_13;
    const double z_15 = z_10*z_14;
    const double b = c[1];
    const double z_16 = b*b;
    const double z_17 = density*b;
    const double e = c[4];
    const double z_18 = density*e;
    const double z_19 = z_0 + z_18;
    const double z_20 = z_16;
    const double d = c[3];
    const double z_21 = d*d;
    const double z_22 = z_20 + z_21 - e*e;
    const double f = c[5];
    const double z_23 = density*f;
    const double z_24 = density*d + z_23;
    const double z_25 = z_18 + z_24;
    const double z_26 = 1.0/b;
    const double z_27 = z_22*z_26;
    const double z_28 = e*z_17 + z_25*z_27;
    const double z_29 = 1.0/z_16;
    const double z_30 = z_22*z_22;
    const double z_31 = z_29*z_30;
    const double z_32 = 1.0/z_21;
    const double z_33 = 4.0 - z_31*z_32;
    const double z_34 = z_25*z_21;
    const double z_35 = 4.0*z_16*z_17 + 4.0*z_19*z_16 + z_18*z_22 + z_28*z_27 + z_33*z_34;
    const double z_36 = 1.0/z_35;
    const double z_37 = 0.9560643415727004*z_15 + 1.7189244238450625*z_16*z_36;
    const double z_38 = 1.0/z_37;
    const double z_39 = m*z_38;
    const double z_40 = m*z_0;
    const double z_41 = 2.0*z_39 - z_40;
    const double cos_theta = em_cos(theta);
    const double z_43 = sin_ab*z_2;
    const double z_44 = cos_theta*z_43;
    const double z_45 = cos_ab*ab_ddot;
    const double z_46 = cos_theta*z_45;
    const double z_47 = 1.0/(z_37*z_37);
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    const double z_49 = j*cos_aj;
    const double z_50 = z_47*z_49;
    const double aj_ddot = a[1];
    const double z_51 = m*cos_theta;
    const double z_52 = aj_ddot*z_51;
    const double theta_dot = v[0];
    const double z_53 = theta_dot*theta_dot;
    const double z_54 = z_53*z_5;
    const double sin_aj = em_sin(aj);
    const double aj_dot = v[1];
    const double z_56 = aj_dot*aj_dot;
    const double z_57 = sin_aj*z_56;
    const double z_58 = z_54 + j*z_57 - b*z_43;
    const double z_59 = z_58*z_47;
    const double z_60 = b*z_45;
    const double z_61 = cos_theta*cos_theta;
    const double theta_ddot = a[0];
    const double z_62 = theta_ddot*z_10;
    const double z_63 = z_61*z_62;
    const double z_64 = z_50*z_52 + z_47*z_63 - z_51*z_59 - z_47*z_51*z_60;
    const double z_65 = b*z_36;
    const double z_66 = 1.0/(z_35*z_35);
    const double z_67 = z_25*z_66;
    const double z_68 = z_30*z_67;
    const double z_69 = z_28*z_66;
    const double z_70 = e*z_22;
    const double z_71 = b*z_19;
    const double z_72 = z_16*z_66;
    const double z_73 = z_22*z_67 - b*z_69 - z_18*z_72;
    const double z_74 = z_66*(z_16*z_16);
    const double z_75 = 1.1459496158967082*z_65 + 0.5729748079483541*z_22*z_69 + 1.1459496158967082*b*z_73 -
        0.5729748079483541*z_26*z_68 - 0.5729748079483541*z_70*z_66*z_17 - 4.583798463586833*z_71*z_72 -
        6.875697695380249*density*z_74;
    D[1] = (1.0/6.0)*(z_0*z_6 + z_0*z_9 + z_41*z_44 - z_41*z_46 - 6.0*z_64*z_75);
    const double ac = x[4];
    const double sin_ac = em_sin(ac);
    const double ac_ddot = a[4];
    const double z_77 = sin_ac*ac_ddot;
    const double c_ = c[2];
    const double z_78 = c_*c_;
    const double z_79 = density*c_;
    const double g = c[6];
    const double z_80 = density*g;
    const double i = c[8];
    const double z_81 = density*i;
    const double z_82 = z_11 + z_80 + z_81;
    const double h = c[7];
    const double z_83 = density*h;
    const double z_84 = z_81 + z_83;
    const double z_85 = c_*z_84;
    const double z_86 = z_23 + z_80 + z_83;
    const double z_87 = c_*z_86;
    const double z_88 = h*z_79;
    const double z_89 = g*z_79;
    const double z_90 = i*z_79;
    const double z_91 = z_89 + z_90;
    const double z_92 = 2.0*z_85 + 2.0*z_87 + 2.0*z_88 + z_91;
    const double z_93 = 2.0*z_78*z_79 + 2.0*z_82*z_78 + c_*z_92 + z_80*z_78 + z_81*z_78;
    const double z_94 = 1.0/z_93;
    const double z_95 = z_78*z_94;
    const double z_96 = 1.0439356584272999*z_15 + 1.9779122466912002*z_95;
    const double z_97 = 1.0/z_96;
    const double cos_ac = em_cos(ac);
    const double z_99 = cos_ac*ac_ddot;
    const double z_100 = 0.9560643415727004*z_15 + 2.0220877533087998*z_95;
    const double z_101 = 1.0/z_100;
    const double z_102 = m*k;
    const double z_103 = density*z_102;
    const double z_104 = sin_theta*z_77 + cos_theta*z_99;
    const double z_105 = m*z_97;
    const double ac_dot = v[4];
    const double z_106 = ac_dot*ac_dot;
    const double z_107 = cos_ac*z_106;
    const double z_108 = sin_theta*z_107;
    const double z_109 = m*z_101;
    const double z_110 = sin_ac*z_106;
    const double z_111 = cos_theta*z_110;
    const double ak_dot = v[3];
    const double z_112 = ak_dot*ak_dot;
    const double ak = x[3];
    const double sin_ak = em_sin(ak);
    const double z_114 = k*sin_ak;
    const double z_115 = c_*sin_ac;
    const double z_116 = z_106*z_115;
    const double z_117 = z_54 + z_112*z_114 - z_116;
    const double z_118 = 1.0/(z_100*z_100);
    const double z_119 = z_117*z_118;
    const double z_120 = c_*cos_ac;
    const double z_121 = ac_ddot*z_120;
    const double cos_ak = em_cos(ak);
    const double z_123 = k*cos_ak;
    const double z_124 = z_118*z_123;
    const double ak_ddot = a[3];
    const double z_125 = ak_ddot*z_51;
    const double z_126 = z_51*z_119 + z_118*z_51*z_121 - z_124*z_125 - z_118*z_63;
    const double z_127 = z_53*z_51;
    const double z_128 = z_106*z_120;
    const double z_129 = z_127 + z_112*z_123 - z_128;
    const double z_130 = 1.0/(z_96*z_96);
    const double z_131 = z_129*z_130;
    const double z_132 = ac_ddot*z_115;
    const double z_133 = z_130*z_114;
    const double z_134 = ak_ddot*z_5;
    const double z_135 = sin_theta*sin_theta;
    const double z_136 = z_5*z_131 + z_133*z_134 + z_130*z_135*z_62 - z_130*z_5*z_132;
    const double z_137 = 0.6740292511029332*z_126 - 0.6593040822304*z_136;
    const double z_138 = 1.0/(z_93*z_93);
    const double z_139 = z_78*z_138;
    const double z_140 = z_79*z_139;
    const double z_141 = c_*z_139;
    const double z_142 = i*z_140 + g*z_140;
    const double z_143 = c_*z_94;
    const double z_144 = z_138*(z_78*z_78);
    const double z_145 = density*z_144;
    const double z_146 = (z_143 - 3.0*z_145) - 0.5*(z_92*z_139 + 4.0*z_82*z_141);
    const double z_147 = 2.0*z_146 - 2.0*h*z_140 - 2.0*z_86*z_141 - 2.0*z_84*z_141 - 3.0*z_142;
    D[2] = ((-1.0/6.0))*(2.0*z_77*z_97*z_5 + 2.0*z_99*z_101*z_51 + (2.0*z_105 - z_103)*z_108 - z_103*z_104 -
        (2.0*z_109 - z_103)*z_111 - 6.0*z_137*z_147);
    const double z_148 = z_33*(d*z_25);
    const double z_149 = z_33*z_21;
    const double z_150 = z_149*z_72 + z_30*z_66;
    const double z_151 = 1.1459496158967082*z_148*z_72 + 1.1459496158967082*z_68/d +
        0.5729748079483541*density*z_150 - 1.1459496158967082*d*z_73;
    D[3] = z_64*z_151;
    const double z_152 = density*z_22;
    const double z_153 = 0.5729748079483541*z_150 + 2.2918992317934164*z_74;
    const double z_154 = 1.1459496158967082*z_152*z_72 + 1.1459496158967082*e*z_73 + density*z_153;
    D[4] = z_64*z_154;
    const double z_155 = z_137*z_144;
    const double z_156 = 2.0*z_155 - 0.5729748079483541*z_64*z_150;
    D[5] = -density*z_156;
    D[6] = (-6.0)*(z_137*z_145);
    D[7] = (-6.0)*(z_137*z_145);
    D[8] = (-6.0)*(z_137*z_145);
    const double z_157 = cos_aj*z_38;
    const double z_158 = z_43*z_51;
    const double gravity = c[16];
    const double z_159 = density*gravity;
    const double z_160 = z_51*z_159;
    const double z_161 = z_57*z_38;
    const double z_162 = z_45*z_51;
    const double z_163 = 0.3186881138575668*z_126 - 0.34797855280909995*z_136 - 0.3186881138575668*z_64;
    const double z_164 = 1.0/(z_13*z_13);
    const double z_165 = z_10*z_164;
    const double z_166 = theta_ddot - 3.0*z_163*z_165;
    const double z_167 = z_166*z_10;
    const double z_168 = 2.2918992317934164*z_64*z_74 + (1.0/3.0)*z_167;
    D[9] = (1.0/6.0)*(2.0*z_157*z_52 + z_17*z_6 + 3.0*z_160 + z_17*z_162 + z_17*z_9 + 6.0*density*z_168 -
        z_17*z_158 - 2.0*z_51*z_161);
    const double z_169 = sin_ak*z_112;
    const double z_170 = z_169*z_101;
    const double z_171 = cos_ak*z_112;
    const double z_172 = z_171*z_97;
    const double z_173 = sin_ak*z_97;
    const double z_174 = cos_ak*z_101;
    const double z_175 = m*z_79;
    const double z_176 = 6.0*z_155 - z_167;
    D[10] = (1.0/6.0)*(z_107*z_79*z_5 + 3.0*z_160 + 2.0*z_5*z_172 + 2.0*z_173*z_134 + 2.0*z_174*z_125 +
        z_104*z_175 - z_110*z_79*z_51 - 2.0*z_51*z_170 - 2.0*density*z_176);
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    const double lambda_2 = lambda[2];
    const double lambda_3 = lambda[3];
    const double z_177 = z_38*z_49;
    const double z_178 = aj_ddot*z_177;
    const double z_179 = cos_theta*z_101;
    const double z_180 = sin_theta*z_97;
    const double z_181 = z_58*z_38;
    const double z_182 = k*z_79;
    const double z_183 = j*z_17;
    const double z_184 = sin_theta*z_183;
    const double z_185 = k*z_159;
    const double z_186 = j*z_159;
    const double z_187 = z_97*z_114;
    const double z_188 = ak_ddot*z_187;
    const double z_189 = z_101*z_123;
    const double z_190 = ak_ddot*z_189;
    const double z_191 = m*z_14;
    const double z_192 = m*z_12;
    const double z_193 = sin_theta*z_53;
    const double z_194 = z_39 + z_109;
    const double z_195 = b*z_38;
    const double z_196 = 2.0*z_195 - z_183;
    D[12] = ((-1.0/6.0))*(6.0*sin_theta*lambda_0 + 6.0*sin_theta*lambda_2 + 2.0*z_117*z_179 + 2.0*cos_theta*z_181
        + z_182*z_111 + z_183*z_44 + 2.0*z_132*z_180 + 2.0*z_121*z_179 + z_196*z_46 - 6.0*cos_theta*lambda_1 -
        6.0*cos_theta*lambda_3 - 2.0*cos_theta*z_178 - 2.0*z_129*z_180 - z_182*z_108 - z_3*z_184 -
        3.0*cos_theta*(z_185 + z_186) - 2.0*sin_theta*z_188 - 2.0*cos_theta*z_190 - 4.0*z_105*theta_ddot*z_135 -
        12.0*z_163*z_191 - z_104*z_182 - z_8*z_184 - 4.0*z_166*z_192 - 2.0*cos_theta*z_193*(z_105 - z_194) -
        4.0*theta_ddot*z_194*z_61);
    const double z_197 = j*b;
    const double z_198 = c_*z_102;
    const double z_199 = c_*z_144;
    const double z_200 = i*z_144 + g*z_144;
    const double z_201 = h*z_144 + z_200;
    const double z_202 = z_199 + 3.0*z_201;
    const double z_203 = (d*z_150 + 2.0*z_70*z_72) + 1.7452774295272968*(e*z_153 + 2.2918992317934164*b*z_74);
    D[13] = (1.0/6.0)*(k*z_128*z_5 + z_197*z_6 + z_104*z_198 + z_197*z_162 + z_197*z_9 + 6.0*j*z_168 +
        3.0*cos_theta*(m*j*gravity + gravity*z_102) + 6.0*z_64*(0.5729748079483541*z_203) - k*z_116*z_51 -
        z_197*z_158 - 6.0*f*z_156 - 2.0*k*z_176 - 12.0*z_137*z_202);
    D[14] = z_166;
    D[15] = -1.0;
    D[16] = 0.5*(cos_theta*(z_40 + z_103));
    const double z_204 = aj_ddot*(cos_aj*cos_aj);
    const double z_205 = theta_ddot*z_51;
    const double z_206 = z_50*z_60 + z_58*z_50 - z_47*(j*j)*z_204 - z_205*z_50;
    D[19] = ((-1.0/3.0))*(z_45*z_177 - z_43*z_177 - 3.0*z_75*z_206);
    D[21] = -z_151*z_206;
    D[22] = -z_154*z_206;
    const double z_207 = density*z_206;
    D[23] = (-0.5729748079483541)*(z_150*z_207);
    const double z_208 = z_164*(z_10*z_10);
    const double z_209 = 2.2918992317934164*z_74 + 0.3186881138575668*z_208;
    D[27] = ((-1.0/3.0))*(3.0*sin_aj*lambda_0 + z_157*z_60 + z_58*z_157 + z_57*z_177 + 3.0*z_209*z_207 -
        3.0*cos_aj*lambda_1 - 2.0*j*z_38*z_204 - z_205*z_157);
    D[28] = (-0.3186881138575668)*(z_208*z_207);
    const double z_210 = cos_theta*theta_ddot;
    const double z_211 = z_191 - z_165*z_192;
    D[30] = (1.0/3.0)*z_210*z_177 + 0.6373762277151336*z_206*z_211 - (1.0/3.0)*z_193*z_177;
    D[31] = -z_206*(0.5729748079483541*f*z_150 + 0.3186881138575668*k*z_208 + j*z_209 + 0.5729748079483541*z_203);
    D[32] = (-0.9560643415727004)*(z_206*z_165);
    const double z_212 = cos_ab*z_54;
    const double z_213 = sin_ab*z_127;
    const double z_214 = b*cos_ab;
    const double z_215 = z_22*z_29;
    const double ag_dot = v[6];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double z_217 = g*cos_ag;
    const double z_218 = ag_dot*z_217;
    const double z_219 = ac_dot*z_79;
    const double z_220 = cos_ac*z_219;
    const double z_221 = sqrt(0.25*z_33);
    const double z_222 = d*z_221;
    const double z_223 = sin_ab*z_222;
    const double z_224 = cos_ab*z_27 - 2.0*z_223;
    const double z_225 = g*g;
    const double z_226 = g*z_86;
    const double z_227 = i*i;
    const double z_228 = z_225 + z_227 - h*h;
    const double z_229 = 1.0/g;
    const double z_230 = z_228*z_229;
    const double z_231 = 4.0*z_226 + z_83*z_230;
    const double z_232 = g*z_83 + z_84*z_230;
    const double z_233 = 1.0/z_225;
    const double z_234 = z_228*z_228;
    const double z_235 = z_233*z_234;
    const double z_236 = 1.0/z_227;
    const double z_237 = 4.0 - z_235*z_236;
    const double z_238 = z_84*z_237;
    const double z_239 = g*z_231 + z_232*z_230 + z_227*z_238;
    const double z_240 = 1.0/z_239;
    const double z_241 = z_225*z_240;
    const double z_242 = 0.6245840315389466*z_27 + 1.5619152186294316*z_222;
    const double z_243 = z_242*z_242;
    const double z_244 = 0.19906253667584417*z_27 - 1.959973577875149*z_222;
    const double z_245 = z_244*z_244;
    const double z_246 = 2.0220877533087998*z_95 + 7.234536854676909*z_241 + z_36*z_243 + z_36*z_245;
    const double z_247 = 1.0/z_246;
    const double z_248 = z_224*z_247;
    const double z_249 = z_23*z_218 + f*z_220 + ab_dot*z_248;
    const double z_250 = ab_dot*sin_ab;
    const double z_251 = z_249*z_250;
    const double sin_ag = em_sin(ag);
    const double z_253 = g*sin_ag;
    const double z_254 = ag_dot*z_253;
    const double z_255 = sin_ac*z_219;
    const double z_256 = sin_ab*z_27 + 2.0*cos_ab*z_222;
    const double z_257 = 0.9799867889375745*z_27 + 0.39812507335168834*z_222;
    const double z_258 = z_257*z_257;
    const double z_259 = 0.7809576093147158*z_27 - 1.2491680630778932*z_222;
    const double z_260 = z_259*z_259;
    const double z_261 = 1.9779122466912002*z_95 + z_36*z_258 + z_36*z_260 + 0.7654631453230909*z_241;
    const double z_262 = 1.0/z_261;
    const double z_263 = z_256*z_262;
    const double z_264 = z_23*z_254 + f*z_255 + ab_dot*z_263;
    const double z_265 = ab_dot*cos_ab;
    const double z_266 = z_264*z_265;
    const double z_267 = ab_ddot*(cos_ab*cos_ab);
    const double z_268 = aj_ddot*z_214;
    const double z_269 = z_50*z_268 + z_47*z_205*z_214 - z_214*z_59 - z_16*z_47*z_267;
    const double z_270 = ab_dot*z_23;
    const double z_271 = ab_dot*f;
    const double z_272 = z_27*z_265 - 2.0*z_222*z_250;
    const double af_dot = v[5];
    const double z_273 = af_dot*af_dot;
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double z_275 = f*cos_af;
    const double z_276 = ag_dot*ag_dot;
    const double z_277 = z_276*z_217;
    const double z_278 = 2.0*z_128 + 2.0*z_277 - ab_dot*z_272 - 2.0*z_273*z_275;
    const double lambda_4 = lambda[4];
    const double z_279 = f*z_79;
    const double z_280 = z_23*g;
    const double z_281 = g*z_262;
    const double z_282 = z_280 - 2.0*z_281;
    const double ag_ddot = a[6];
    const double z_283 = sin_ag*ag_ddot;
    const double af_ddot = a[5];
    const double sin_af = em_sin(af);
    const double z_285 = f*sin_af;
    const double z_286 = z_262*z_285;
    const double z_287 = af_ddot*z_286;
    const double z_288 = c_*z_262;
    const double z_289 = z_279 - 2.0*z_288;
    const double z_290 = z_256*ab_ddot;
    const double z_291 = z_270*z_218 + z_271*z_220 + z_23*z_277 + z_279*z_107 + z_282*z_283 + 2.0*z_287 +
        z_289*z_77 + 2.0*z_262*z_290 - z_278*z_262 - 6.0*lambda_4;
    const double z_292 = sin_ab*z_291;
    const double z_293 = cos_ab*z_159;
    const double z_294 = z_27*z_250 + 2.0*z_222*z_265;
    const double z_295 = z_276*z_253;
    const double z_296 = 2.0*z_116 + 2.0*z_295 - ab_dot*z_294 - 2.0*z_273*z_285;
    const double z_297 = 1.0/(z_246*z_246);
    const double z_298 = z_224*z_297;
    const double z_299 = z_297*z_217;
    const double z_300 = ag_ddot*z_299;
    const double z_301 = z_297*z_275;
    const double z_302 = af_ddot*z_301;
    const double z_303 = z_296*z_298 + 2.0*z_224*z_302 + ab_ddot*z_297*(z_224*z_224) - 2.0*z_224*z_300 -
        2.0*z_121*z_298;
    const double z_304 = z_244*z_36;
    const double z_305 = z_242*z_36;
    const double z_306 = z_304 + 3.1376272098653435*z_305;
    const double z_307 = 1.0/(z_261*z_261);
    const double z_308 = z_256*z_307;
    const double z_309 = z_307*z_253;
    const double z_310 = ag_ddot*z_309;
    const double z_311 = z_307*z_285;
    const double z_312 = af_ddot*z_311;
    const double z_313 = z_278*z_308 + 2.0*z_256*z_310 + 2.0*z_132*z_308 - 2.0*z_256*z_312 -
        ab_ddot*z_307*(z_256*z_256);
    const double z_314 = z_259*z_36;
    const double z_315 = z_257*z_36;
    const double z_316 = z_314 + 1.2548527311200737*z_315;
    const double z_317 = e*z_293 + 4.0*z_313*(0.13015960155245263*z_316) - 4.0*z_303*(0.03317708944597403*z_306);
    const double lambda_5 = lambda[5];
    const double z_318 = g*z_247;
    const double z_319 = z_280 - 2.0*z_318;
    const double z_320 = cos_ag*ag_ddot;
    const double z_321 = z_247*z_275;
    const double z_322 = af_ddot*z_321;
    const double z_323 = c_*z_247;
    const double z_324 = z_279 - 2.0*z_323;
    const double z_325 = z_224*ab_ddot;
    const double z_326 = z_270*z_254 + z_271*z_255 + z_23*z_295 + z_279*z_110 - z_296*z_247 - 6.0*lambda_5 -
        z_319*z_320 - 2.0*z_322 - z_324*z_99 - 2.0*z_247*z_325;
    const double z_327 = cos_ab*z_326;
    const double z_328 = z_222/z_33;
    const double z_329 = e*z_159;
    const double z_330 = z_23*gravity;
    const double z_331 = z_330 + d*z_159;
    const double z_332 = sin_ab*(z_329 + z_331);
    const double z_333 = z_249*z_265;
    const double z_334 = z_264*z_250;
    const double z_335 = cos_ab*z_291;
    const double z_336 = z_304 - 0.7969062625439771*z_305;
    const double z_337 = z_314 - 0.31871217742368974*z_315;
    const double z_338 = z_303*(0.3266622629791915*z_336) - z_313*(0.20819467717964885*z_337);
    const double z_339 = sin_ab*z_326;
    const double z_340 = z_66*z_245 + z_66*z_243;
    const double z_341 = z_66*z_260 + z_66*z_258;
    const double z_342 = ab_ddot - 12.0*(0.5729748079483541*z_269*z_72 + (1.0/12.0)*z_313*z_341 -
        (1.0/12.0)*z_303*z_340);
    const double z_343 = (3.0*z_328*z_332 + z_328*z_333 + z_328*z_334 - z_328*z_335 - 6.0*z_338*z_328 -
        z_328*z_339) - z_342*z_34;
    const double z_344 = b*z_16;
    const double z_345 = z_30/(z_344);
    const double z_346 = z_32*z_345;
    const double z_347 = z_32*z_215;
    const double z_348 = z_18 + z_28*z_26 + z_25*z_215;
    const double z_349 = 3.0*cos_ab*z_331*z_26 + z_26*z_266 + z_26*z_292 + 3.0*z_317*z_26 + 2.0*z_343*z_347 +
        z_342*z_348 - z_26*z_251 - z_26*z_327;
    const double z_350 = theta_ddot*z_5;
    const double z_351 = sin_ab*z_350;
    const double z_352 = b*z_159;
    const double z_353 = cos_ab*z_210;
    const double z_354 = density*z_16;
    const double z_355 = z_28*z_215 + z_25*z_345 - 8.0*z_71 - 12.0*z_354 - z_18*z_27;
    D[37] = sin_ab*lambda_0 + (1.0/3.0)*cos_ab*z_181 + (1.0/6.0)*z_0*z_213 + (1.0/12.0)*z_215*z_251 +
        (2.0/3.0)*z_195*z_267 + 1.1459496158967082*z_65*z_269 + (1.0/12.0)*z_215*z_327 + (1.0/6.0)*b*z_349 +
        (1.0/6.0)*z_0*z_351 + 0.25*cos_ab*(2.0*z_352 + 2.0*z_329 + 2.0*(z_186 + z_352) - z_331*z_215) -
        cos_ab*lambda_1 - (1.0/3.0)*cos_ab*z_178 - (1.0/6.0)*z_0*z_212 - (1.0/3.0)*z_43*z_38*z_214 -
        (1.0/12.0)*z_215*z_266 - (1.0/12.0)*z_215*z_292 - 0.25*z_317*z_215 - (1.0/6.0)*z_343*z_346 -
        (1.0/6.0)*z_41*z_353 - (1.0/12.0)*z_342*z_355;
    const double z_356 = sin_ac*z_272;
    const double z_357 = ac_dot*z_23;
    const double z_358 = cos_ac*z_294;
    const double z_359 = ac_dot*z_224;
    const double z_360 = ac_dot*z_256;
    const double z_361 = z_256*z_77 + z_224*z_99;
    const double z_362 = z_23 - 2.0*z_262;
    const double z_363 = z_256*z_107;
    const double z_364 = z_23 - 2.0*z_247;
    const double z_365 = z_224*z_110;
    const double z_366 = 0.1685073127757333*z_303 - 0.1648260205576*z_313;
    D[38] = (1.0/12.0)*(z_356*z_357 + cos_ac*z_270*z_360 + z_23*z_361 + z_362*z_363 - z_358*z_357 -
        sin_ac*z_270*z_359 - 2.0*z_77*z_263 - 2.0*z_99*z_248 - z_364*z_365 - 12.0*z_147*z_366);
    const double z_367 = z_224*z_159;
    const double z_368 = z_31/(d*z_21);
    const double z_369 = z_149 + z_31;
    const double z_370 = 2.0*z_148 + density*z_369;
    D[39] = ((-1.0/12.0))*(6.0*z_221*z_332 + 2.0*z_221*z_333 + 2.0*z_221*z_334 + 2.0*z_343*z_368 - 3.0*z_367 -
        2.0*z_221*z_335 - 12.0*z_338*z_221 - 2.0*z_221*z_339 - 2.0*d*z_349 - z_342*z_370);
    const double z_371 = 2.0*b + z_27;
    const double z_372 = 4.0*z_20 + z_369;
    const double z_373 = 2.0*z_152 + density*z_372;
    D[40] = (1.0/12.0)*(3.0*z_371*z_293 + z_342*z_373 - 6.0*z_223*z_159 - 2.0*e*z_349);
    const double z_374 = z_272*z_254;
    const double z_375 = z_294*z_218;
    const double z_376 = ab_dot*density;
    const double z_377 = z_224*z_254;
    const double z_378 = z_256*z_218;
    const double z_379 = sin_af*z_273;
    const double z_380 = cos_af*z_273;
    const double z_381 = cos_af*z_247;
    const double z_382 = af_ddot*z_381;
    const double z_383 = sin_af*z_262;
    const double z_384 = af_ddot*z_383;
    const double z_385 = z_256*z_283 + z_224*z_320;
    const double z_386 = 0.6028780712230757*z_303 - 0.0637885954435909*z_313;
    const double z_387 = 1.0/(z_239*z_239);
    const double z_388 = z_225*z_225*z_387;
    const double z_389 = z_366*z_144;
    const double z_390 = 2.0*z_386*z_388 + z_389;
    const double z_391 = 24.0*z_390 + z_342*z_369;
    D[41] = (1.0/12.0)*(density*z_256*z_277 + density*z_374 + z_219*z_356 + z_79*z_363 + z_376*z_378 +
        ab_dot*z_256*z_220 + 3.0*z_367 + 2.0*z_380*z_263 + 2.0*z_224*z_382 + 2.0*z_256*z_384 + z_80*z_385 +
        z_361*z_79 + density*z_391 - density*z_224*z_295 - density*z_375 - z_219*z_358 - z_79*z_365 - z_376*z_377
        - ab_dot*z_224*z_255 - 2.0*z_379*z_248);
    const double z_392 = ag_dot*z_23;
    const double z_393 = sin_ag*z_272;
    const double z_394 = cos_ag*z_294;
    const double z_395 = ag_dot*z_270;
    const double z_396 = z_145*z_366;
    const double z_397 = z_389 + z_390;
    const double z_398 = cos_ag*z_276;
    const double z_399 = sin_ag*z_276;
    const double z_400 = z_84*z_234;
    const double z_401 = z_387*z_400;
    const double z_402 = z_229*z_401;
    const double z_403 = z_228*z_387;
    const double z_404 = z_84*z_403;
    const double z_405 = z_225*z_387;
    const double z_406 = g*z_232*z_387 + z_83*z_405;
    const double z_407 = z_406 - z_404;
    const double z_408 = g*z_240;
    const double z_409 = (z_408 + 0.5*z_232*z_403) - 0.5*(z_231*z_405 + 4.0*z_226*z_405);
    const double z_410 = 2.0*z_409 - z_402 - 2.0*g*z_407;
    D[42] = (1.0/12.0)*(z_392*z_393 + z_256*cos_ag*z_395 + 24.0*z_396 + 24.0*density*z_397 + z_23*z_385 +
        z_256*z_398*z_362 - z_392*z_394 - z_224*sin_ag*z_395 - 2.0*z_283*z_263 - 2.0*z_320*z_248 -
        z_224*z_399*z_364 - 12.0*z_386*z_410);
    const double z_411 = z_237*z_227;
    const double z_412 = z_411*z_405 + z_234*z_387;
    const double z_413 = 2.0*z_389 + z_386*z_412;
    const double z_414 = 2.0*z_390 + z_413;
    const double z_415 = z_228*z_405;
    const double z_416 = density*z_415;
    const double z_417 = z_416 - h*z_407;
    D[43] = 2.0*z_396 + density*z_414 + 2.0*z_386*z_417;
    const double z_418 = 2.0*z_389 + z_413;
    const double z_419 = i*z_238;
    const double z_420 = z_405*z_419 + z_401/i + i*z_407;
    D[44] = 2.0*z_396 + density*z_418 + 2.0*z_386*z_420;
    const double z_421 = cos_ab*z_205;
    const double z_422 = z_208*z_269;
    const double z_423 = (1.0/3.0)*z_342*z_16 - 0.3186881138575668*z_422;
    D[45] = ((-1.0/6.0))*(2.0*z_157*z_268 + z_17*z_212 - z_17*z_213 - 3.0*z_159*z_214 - 2.0*z_214*z_161 -
        z_17*z_421 - z_17*z_351 - 6.0*density*z_423);
    const double z_424 = 2.0*z_389 - 0.3186881138575668*z_422;
    D[46] = density*z_424;
    const double z_425 = cos_theta*z_53;
    const double z_426 = sin_ab*z_183;
    const double z_427 = sin_theta*theta_ddot;
    D[48] = (1.0/6.0)*z_425*z_426 + (1.0/6.0)*z_427*z_426 + (1.0/6.0)*cos_ab*z_193*z_196 +
        0.6373762277151336*z_211*z_269 - (1.0/6.0)*z_196*z_353;
    const double z_428 = f*z_256;
    const double z_429 = f*z_224;
    const double z_430 = ac_dot*f;
    const double z_431 = z_272*z_115;
    const double z_432 = z_294*z_120;
    const double z_433 = e*gravity;
    const double z_434 = h*z_415;
    const double z_435 = f*g;
    const double z_436 = c_*f;
    const double z_437 = (z_344 + 0.5*z_70) + 0.25*(d*z_369 + e*z_372);
    const double z_438 = 4.0*z_437;
    D[49] = (1.0/12.0)*(z_277*z_428 + f*z_374 + z_430*z_431 + z_128*z_428 + 2.0*z_197*z_213 + z_271*z_378 +
        z_120*z_271*z_360 + 24.0*z_386*z_434 + 12.0*h*z_414 + 12.0*i*z_418 + 24.0*g*z_397 + z_385*z_435 +
        z_361*z_436 + f*z_391 + 2.0*z_197*z_421 + 2.0*z_197*z_351 + 12.0*k*z_424 + 12.0*j*z_423 +
        3.0*z_224*(d*gravity + f*gravity) + 3.0*cos_ab*(z_371*z_433 + 2.0*gravity*z_16 + 2.0*gravity*z_197) +
        24.0*z_366*(z_199 + z_201) + z_342*z_438 - z_295*z_429 - f*z_375 - z_430*z_432 - z_116*z_429 -
        2.0*z_197*z_212 - z_271*z_377 - z_115*z_271*z_359 - 6.0*z_223*z_433);
    D[50] = (-0.9560643415727004)*(z_269*z_165);
    D[52] = (-0.25)*(2.0*z_18*z_223 - z_224*z_24 - cos_ab*(2.0*z_354 + 2.0*z_183 + z_18*z_371));
    const double z_439 = cos_ak*cos_ak;
    const double z_440 = ak_ddot*(k*k);
    const double z_441 = z_117*z_124 + z_121*z_124 - z_118*z_439*z_440 - z_205*z_124;
    const double z_442 = sin_ak*sin_ak;
    const double z_443 = z_129*z_133 + z_130*z_442*z_440 + z_350*z_133 - z_132*z_133;
    const double z_444 = 0.6740292511029332*z_441 - 0.6593040822304*z_443;
    D[56] = (1.0/3.0)*(z_110*z_189 + 3.0*z_147*z_444 - z_107*z_187 - z_77*z_187 - z_99*z_189);
    const double z_445 = z_145*z_444;
    D[59] = (-2.0)*z_445;
    D[60] = (-6.0)*z_445;
    D[61] = (-6.0)*z_445;
    D[62] = (-6.0)*z_445;
    const double z_446 = 0.3186881138575668*z_441 - 0.34797855280909995*z_443;
    const double z_447 = z_208*z_446;
    D[63] = -density*z_447;
    const double z_448 = k*ak_ddot;
    const double z_449 = 2.0*z_444*z_144 + z_447;
    D[64] = ((-1.0/3.0))*(3.0*sin_ak*lambda_2 + z_117*z_174 + z_132*z_173 + z_121*z_174 + 3.0*density*z_449 -
        3.0*cos_ak*lambda_3 - z_129*z_173 - 2.0*z_97*z_442*z_448 - 2.0*z_101*z_439*z_448 - z_350*z_173 -
        z_205*z_174 - sin_ak*z_171*(k*z_97 - k*z_101));
    D[66] = ((-1.0/3.0))*(z_193*z_189 - z_425*z_187 - z_427*z_187 - z_210*z_189 - 6.0*z_211*z_446);
    D[67] = -(k*z_449 + j*z_447 + 2.0*z_444*(z_202 + f*z_144));
    D[68] = (-3.0)*(z_446*z_165);
    const double z_450 = z_43*z_215;
    const double z_451 = cos_ac*z_324;
    const double z_452 = z_3*z_215;
    const double z_453 = sin_ac*z_289;
    const double z_454 = z_8*z_215;
    const double z_455 = z_297*z_120;
    const double z_456 = cos_ac*cos_ac;
    const double z_457 = ac_ddot*z_78;
    const double z_458 = z_456*z_457;
    const double z_459 = z_296*z_455 + 2.0*z_120*z_302 + z_325*z_455 - 2.0*z_120*z_300 - 2.0*z_297*z_458;
    const double z_460 = 0.06635417889194806*z_306;
    const double z_461 = z_307*z_115;
    const double z_462 = sin_ac*sin_ac;
    const double z_463 = z_462*z_457;
    const double z_464 = z_278*z_461 + 2.0*z_115*z_310 + 2.0*z_307*z_463 - 2.0*z_115*z_312 - z_290*z_461;
    const double z_465 = 0.26031920310490525*z_316;
    const double z_466 = z_459*z_460 - z_464*z_465;
    const double z_467 = z_45*z_215;
    const double z_468 = z_3*z_328;
    const double z_469 = z_43*z_328;
    const double z_470 = z_45*z_328;
    const double z_471 = 0.653324525958383*z_336;
    const double z_472 = 0.4163893543592977*z_337;
    const double z_473 = z_459*z_471 - z_464*z_472;
    const double z_474 = z_8*z_328;
    const double z_475 = z_340*z_459 - z_341*z_464;
    const double z_476 = (z_468*z_451 + z_469*z_453 + 6.0*z_473*z_328 + z_474*z_451 - z_470*z_453) +
        2.0*z_475*z_34;
    const double z_477 = z_43*z_26;
    const double z_478 = z_3*z_26;
    const double z_479 = z_8*z_26;
    const double z_480 = z_45*z_26;
    const double z_481 = z_477*z_451 + 2.0*z_348*z_475 - z_478*z_453 - z_479*z_453 - 12.0*z_466*z_26 - z_480*z_451
        - 2.0*z_476*z_347;
    D[73] = (1.0/12.0)*(z_450*z_451 + 2.0*z_355*z_475 - z_452*z_453 - z_454*z_453 - 12.0*z_466*z_215 - z_467*z_451
        - 2.0*z_476*z_346 - 2.0*b*z_481);
    const double z_482 = cos_ac*z_247;
    const double z_483 = sin_ac*z_262;
    const double z_484 = cos_ac*z_101;
    const double z_485 = sin_ac*z_97;
    const double z_486 = sin_ac*z_127;
    const double z_487 = cos_ac*z_54;
    const double z_488 = z_262*z_253;
    const double z_489 = z_247*z_217;
    const double z_490 = ak_ddot*z_120;
    const double z_491 = z_120*z_119 + z_118*z_458 - z_124*z_490 - z_118*z_120*z_205;
    const double z_492 = ak_ddot*z_115;
    const double z_493 = z_115*z_131 + z_133*z_492 + z_130*z_115*z_350 - z_130*z_463;
    const double z_494 = 0.3370146255514666*z_459 + 0.6593040822304*z_493 - 0.3296520411152*z_464 -
        0.6740292511029332*z_491;
    const double z_495 = sqrt(0.25*z_237);
    const double z_496 = i*z_495;
    const double z_497 = sin_ac*z_399;
    const double z_498 = cos_ac*z_398;
    const double z_499 = sin_ac*z_320;
    const double z_500 = cos_ac*z_283;
    const double z_501 = sin_ac*z_398 + sin_ac*z_283 + cos_ac*z_320 - cos_ac*z_399;
    const double z_502 = 2.0*z_496*z_497 + 2.0*z_496*z_498 + 2.0*z_496*z_500 - 2.0*z_496*z_499 - z_230*z_501;
    const double z_503 = g*z_501;
    const double z_504 = ac_ddot - 6.0*z_494*z_139;
    const double z_505 = c_*z_504;
    const double z_506 = z_502 - 2.0*z_503 - 4.0*z_505;
    const double z_507 = sin_ac*z_290 + cos_ac*z_325;
    const double z_508 = sin_ac*z_427 + cos_ac*z_210;
    const double z_509 = gravity*z_79;
    const double z_510 = i*z_159;
    const double z_511 = g*z_159;
    const double z_512 = h*z_159;
    const double z_513 = z_511 + z_512;
    const double z_514 = c_*z_101;
    const double z_515 = z_323 + z_514;
    const double z_516 = c_*z_97;
    const double z_517 = z_288 + z_516;
    const double z_518 = density*z_78;
    const double z_519 = z_502 - 2.0*z_505;
    const double z_520 = z_81 + 2.0*z_84;
    const double z_521 = z_503 + z_505;
    const double z_522 = z_80 + 2.0*z_86;
    D[74] = (1.0/12.0)*(12.0*sin_ac*lambda_2 + 12.0*sin_ac*lambda_4 + 2.0*z_278*z_483 + 4.0*z_117*z_484 +
        z_270*z_356 + 2.0*z_11*z_486 + 4.0*sin_ac*ag_ddot*z_488 + 4.0*cos_ac*ag_ddot*z_489 + 24.0*z_143*z_494 +
        z_23*z_507 + 2.0*z_103*z_508 + 6.0*cos_ac*(z_509 + (z_185 + z_509 + 2.0*z_510 + z_330 + 2.0*z_513)) +
        8.0*ac_ddot*z_517*z_462 + 8.0*ac_ddot*z_515*z_456 + 2.0*z_504*(z_92 + 6.0*z_518 + 4.0*c_*z_82 + 2.0*z_91)
        + 2.0*z_521*z_522 - 12.0*cos_ac*lambda_3 - 12.0*cos_ac*lambda_5 - 2.0*z_296*z_482 - 4.0*z_129*z_485 -
        z_270*z_358 - 2.0*z_11*z_487 - 4.0*sin_ac*z_287 - 4.0*cos_ac*z_322 - 4.0*sin_ac*z_188 - 4.0*cos_ac*z_190 -
        2.0*z_290*z_483 - 2.0*z_325*z_482 - 4.0*z_350*z_485 - 4.0*z_205*z_484 - z_83*z_506 -
        4.0*sin_ac*z_107*(z_515 - z_517) - z_519*z_520);
    const double z_523 = z_3*z_221;
    const double z_524 = z_43*z_221;
    const double z_525 = z_45*z_221;
    const double z_526 = z_8*z_221;
    D[75] = ((-1.0/6.0))*(z_523*z_451 + z_524*z_453 + 6.0*z_473*z_221 + z_526*z_451 + z_476*z_368 + d*z_481 +
        z_370*z_475 - z_525*z_453);
    D[76] = (1.0/6.0)*(e*z_481 - z_373*z_475);
    const double z_527 = ab_dot*z_79;
    const double z_528 = cos_ac*z_509;
    const double z_529 = z_247*z_120;
    const double z_530 = z_262*z_115;
    const double z_531 = 1.2057561424461514*z_459 - 0.1275771908871818*z_464;
    const double z_532 = 12.0*z_531*z_388 - c_*z_521;
    const double z_533 = 2.0*z_532 + z_369*z_475;
    D[77] = (1.0/12.0)*(z_356*z_527 + 6.0*z_528 + 4.0*z_379*z_529 + z_507*z_79 - z_358*z_527 - 4.0*z_380*z_530 -
        4.0*z_115*z_384 - 4.0*z_120*z_382 - 2.0*density*z_533);
    const double z_534 = z_84*z_227;
    const double z_535 = z_531*z_405;
    const double z_536 = 2.0*z_85 + z_90 + z_88;
    const double z_537 = z_496/z_237;
    const double z_538 = z_536*z_537;
    const double z_539 = 12.0*z_534*z_535 + (z_538*z_497 + z_538*z_498 + z_538*z_500 - z_538*z_499);
    const double z_540 = z_539*z_236;
    const double z_541 = 1.0/(g*z_225);
    const double z_542 = z_234*z_541;
    const double z_543 = z_228*z_233;
    const double z_544 = z_536*z_229;
    const double z_545 = 2.0*z_543*z_540 + z_501*z_544 - 12.0*z_531*(z_404 + z_406);
    const double z_546 = z_504*z_78;
    const double z_547 = z_532 - z_546;
    const double z_548 = 2.0*(2.0*z_87 + z_89 + z_88) - z_536*z_543;
    const double z_549 = z_528 + (1.0/6.0)*z_518*z_504;
    D[78] = (1.0/12.0)*(4.0*z_398*z_530 + 4.0*z_283*z_530 + 4.0*z_320*z_529 + 2.0*g*z_545 + 2.0*z_521*z_79 +
        12.0*z_531*(z_402 + 2.0*z_409) + z_501*z_548 + 12.0*z_549 - 4.0*z_399*z_529 - 2.0*z_540*z_542 -
        4.0*density*z_547);
    const double z_550 = c_*z_519 + 6.0*z_412*z_531;
    const double z_551 = 2.0*z_532 + z_550;
    D[79] = (1.0/12.0)*(12.0*z_528 - 24.0*z_416*z_531 - 2.0*h*z_545 - z_506*z_79 - 2.0*density*z_551);
    const double z_552 = z_536*z_495;
    const double z_553 = z_235/(i*z_227);
    const double z_554 = z_550 - 2.0*z_546;
    D[80] = ((-1.0/12.0))*(2.0*z_552*z_497 + 2.0*z_552*z_498 + 24.0*z_419*z_535 + 2.0*z_552*z_500 +
        2.0*z_539*z_553 + z_519*z_79 + 2.0*density*z_554 - 2.0*z_552*z_499 - 2.0*i*z_545 - 12.0*z_549);
    const double z_555 = 0.3186881138575668*z_491 - 0.34797855280909995*z_493;
    const double z_556 = z_208*z_555;
    const double z_557 = 2.0*z_475*z_16 - 3.0*z_556;
    D[81] = ((-1.0/3.0))*(density*z_557);
    const double z_558 = z_546 + 3.0*z_556;
    D[82] = (1.0/6.0)*(z_79*z_486 + 3.0*z_528 + 2.0*z_120*z_170 + z_508*z_175 + 2.0*density*z_558 - z_79*z_487 -
        2.0*z_115*z_172 - 2.0*z_173*z_492 - 2.0*z_174*z_490);
    D[84] = ((-1.0/6.0))*(2.0*z_427*z_97*z_115 + 2.0*z_210*z_101*z_120 + sin_ac*z_425*(2.0*z_516 - z_182) +
        12.0*z_211*z_555 - z_182*z_508 - cos_ac*z_193*(2.0*z_514 - z_182));
    const double z_559 = c_*h;
    const double z_560 = c_*i;
    const double z_561 = c_*g;
    const double z_562 = c_*gravity;
    D[85] = (1.0/12.0)*(z_271*z_431 + 2.0*k*z_127*z_115 + 2.0*z_521*z_561 + z_507*z_436 + 2.0*z_508*z_198 +
        4.0*k*z_558 + 6.0*cos_ac*(f*z_562 + 2.0*h*z_562 + 2.0*i*z_562 + gravity*z_78 + 2.0*g*z_562 + k*z_562) +
        2.0*z_504*(2.0*c_*z_78 + i*z_78 + g*z_78) - z_271*z_432 - 2.0*k*z_54*z_120 - 24.0*z_531*z_434 -
        z_506*z_559 - z_519*z_560 - 2.0*h*z_551 - 2.0*i*z_554 - 4.0*g*z_547 - 2.0*f*z_533 - 4.0*j*z_557 -
        2.0*z_438*z_475);
    D[86] = 3.0*(z_555*z_165);
    D[88] = 0.5*(cos_ac*(z_279 + 2.0*z_88 + z_518 + z_182 + 2.0*z_91));
    const double z_563 = cos_af*cos_af;
    const double z_564 = af_ddot*(f*f);
    const double z_565 = z_296*z_301 + 2.0*z_297*z_563*z_564 + z_325*z_301 - 2.0*z_275*z_300 - 2.0*z_121*z_301;
    const double z_566 = sin_af*sin_af;
    const double z_567 = z_278*z_311 + 2.0*z_285*z_310 + 2.0*z_132*z_311 - 2.0*z_307*z_566*z_564 - z_290*z_311;
    const double z_568 = z_460*z_565 - z_465*z_567;
    const double z_569 = z_471*z_565 - z_472*z_567;
    const double z_570 = z_340*z_565 - z_341*z_567;
    const double z_571 = (z_468*z_321 + z_469*z_286 + z_474*z_321 - z_470*z_286 - 3.0*z_569*z_328) - z_570*z_34;
    const double z_572 = z_477*z_321 + 6.0*z_568*z_26 - z_478*z_286 - z_479*z_286 - z_480*z_321 - 2.0*z_571*z_347
        - z_348*z_570;
    D[91] = (1.0/6.0)*(z_450*z_321 + 6.0*z_568*z_215 - z_452*z_286 - z_454*z_286 - z_467*z_321 - 2.0*z_571*z_346 -
        2.0*b*z_572 - z_355*z_570);
    const double z_573 = 0.3370146255514666*z_565 - 0.3296520411152*z_567;
    D[92] = (1.0/3.0)*(z_110*z_321 - z_107*z_286 - z_77*z_286 - z_99*z_321 - 3.0*z_147*z_573);
    D[93] = ((-1.0/6.0))*(2.0*z_523*z_321 + 2.0*z_524*z_286 + 2.0*z_526*z_321 + 2.0*z_571*z_368 + 2.0*d*z_572 -
        2.0*z_525*z_286 - 6.0*z_569*z_221 - z_370*z_570);
    D[94] = (1.0/6.0)*(2.0*e*z_572 + z_373*z_570);
    const double z_574 = f*af_ddot;
    const double z_575 = 1.2057561424461514*z_565 - 0.1275771908871818*z_567;
    const double z_576 = z_573*z_144;
    const double z_577 = 2.0*z_575*z_388 + z_576;
    const double z_578 = 12.0*z_577 + z_369*z_570;
    D[95] = ((-1.0/6.0))*(6.0*sin_af*lambda_4 + z_278*z_383 + 2.0*ag_ddot*z_253*z_383 + 2.0*ag_ddot*z_217*z_381 +
        2.0*z_132*z_383 + 2.0*z_121*z_381 - 6.0*cos_af*lambda_5 - z_296*z_381 - 4.0*z_262*z_566*z_574 -
        4.0*z_247*z_563*z_574 - z_325*z_381 - z_290*z_383 - density*z_578 - 2.0*cos_af*z_379*(f*z_262 - f*z_247));
    const double z_579 = z_145*z_573;
    const double z_580 = z_576 + z_577;
    D[96] = (1.0/3.0)*(z_399*z_321 + 6.0*z_579 + 6.0*density*z_580 - z_398*z_286 - z_283*z_286 - z_320*z_321 -
        3.0*z_410*z_575);
    const double z_581 = 2.0*z_576 + z_412*z_575;
    const double z_582 = 2.0*z_577 + z_581;
    D[97] = 2.0*z_579 + density*z_582 + 2.0*z_417*z_575;
    const double z_583 = 2.0*z_576 + z_581;
    D[98] = 2.0*z_579 + density*z_583 + 2.0*z_420*z_575;
    D[99] = (2.0/3.0)*(z_354*z_570);
    D[100] = 2.0*z_579;
    const double z_584 = z_199 + k*z_144;
    const double z_585 = 4.0*j*z_16 + 4.0*z_437;
    D[103] = (1.0/6.0)*(12.0*z_575*z_434 + 6.0*h*z_582 + 6.0*i*z_583 + 12.0*g*z_580 + f*z_578 + 12.0*z_573*(z_201
        + z_584) + z_570*z_585);
    const double z_586 = cos_ag*z_319;
    const double z_587 = sin_ag*z_282;
    const double z_588 = cos_ag*cos_ag;
    const double z_589 = ag_ddot*z_225;
    const double z_590 = z_296*z_299 + 2.0*af_ddot*z_275*z_299 + z_325*z_299 - 2.0*z_297*z_588*z_589 -
        2.0*z_121*z_299;
    const double z_591 = sin_ag*sin_ag;
    const double z_592 = z_278*z_309 + 2.0*z_307*z_591*z_589 + 2.0*z_132*z_309 - 2.0*af_ddot*z_285*z_309 -
        z_290*z_309;
    const double z_593 = z_460*z_590 - z_465*z_592;
    const double z_594 = z_471*z_590 - z_472*z_592;
    const double z_595 = z_340*z_590 - z_341*z_592;
    const double z_596 = (z_468*z_586 + z_469*z_587 + 6.0*z_594*z_328 + z_474*z_586 - z_470*z_587) +
        2.0*z_595*z_34;
    const double z_597 = z_477*z_586 + 2.0*z_348*z_595 - z_478*z_587 - z_479*z_587 - 12.0*z_593*z_26 - z_480*z_586
        - 2.0*z_596*z_347;
    D[109] = (1.0/12.0)*(z_450*z_586 + 2.0*z_355*z_595 - z_452*z_587 - z_454*z_587 - 12.0*z_593*z_215 -
        z_467*z_586 - 2.0*z_596*z_346 - 2.0*b*z_597);
    const double z_598 = cos_ag*z_107;
    const double z_599 = sin_ag*z_110;
    const double z_600 = cos_ag*z_77;
    const double z_601 = sin_ag*z_99;
    const double z_602 = sin_ag*z_107 + sin_ag*z_77 + cos_ag*z_99 - cos_ag*z_110;
    const double z_603 = 2.0*z_496*z_598 + 2.0*z_496*z_599 + 2.0*z_496*z_600 + z_230*z_602 - 2.0*z_496*z_601;
    const double z_604 = g*z_602;
    const double z_605 = 0.3370146255514666*z_590 - 0.3296520411152*z_592;
    const double z_606 = z_605*z_141;
    const double z_607 = z_603 + 2.0*z_604 - 24.0*z_606;
    const double z_608 = z_603 - 12.0*z_606;
    const double z_609 = z_604 - 6.0*z_606;
    D[110] = ((-1.0/12.0))*(4.0*z_110*z_489 - 4.0*z_107*z_488 - 4.0*z_77*z_488 - 4.0*z_99*z_489 - z_83*z_607 -
        12.0*z_605*(2.0*z_146 - 2.0*z_142) - z_520*z_608 - 2.0*z_522*z_609);
    D[111] = ((-1.0/6.0))*(z_523*z_586 + z_524*z_587 + 6.0*z_594*z_221 + z_526*z_586 + z_596*z_368 + d*z_597 +
        z_370*z_595 - z_525*z_587);
    D[112] = (1.0/6.0)*(e*z_597 - z_373*z_595);
    const double z_610 = z_272*z_253;
    const double z_611 = z_294*z_217;
    const double z_612 = sin_ag*z_290 + cos_ag*z_325;
    const double z_613 = 1.2057561424461514*z_590 - 0.1275771908871818*z_592;
    const double z_614 = ag_ddot - 12.0*z_613*z_405;
    const double z_615 = z_614*z_225 + c_*z_609;
    const double z_616 = 2.0*z_615 - z_369*z_595;
    D[113] = (1.0/12.0)*(z_376*z_610 + 6.0*z_217*z_159 + 4.0*z_379*z_489 + z_80*z_612 + 2.0*density*z_616 -
        z_376*z_611 - 4.0*z_380*z_488 - 4.0*z_253*z_384 - 4.0*z_217*z_382);
    const double z_617 = cos_ag*z_247;
    const double z_618 = sin_ag*z_262;
    const double z_619 = g*ag_ddot;
    const double z_620 = z_510 + z_512;
    const double z_621 = z_614*z_534 + (z_538*z_598 + z_538*z_599 + z_538*z_600 - 3.0*sin_ag*z_620*z_537 -
        z_538*z_601);
    const double z_622 = z_621*z_236;
    const double z_623 = 2.0*z_543*z_622 - z_602*z_544 - 3.0*cos_ag*(z_510*z_229 + z_512*z_229) - z_614*(z_83 +
        z_232*z_229 + z_84*z_543);
    const double z_624 = z_145*z_605;
    const double z_625 = z_605*z_144;
    const double z_626 = z_615 - 6.0*z_625;
    D[114] = (1.0/12.0)*(12.0*sin_ag*lambda_4 + 2.0*z_278*z_618 + z_270*z_393 + 8.0*z_262*z_591*z_619 +
        8.0*z_247*z_588*z_619 + 4.0*z_132*z_618 + 4.0*z_121*z_617 + 24.0*z_408*z_613 + 2.0*z_622*z_542 +
        2.0*z_609*z_79 + 4.0*density*z_626 + z_23*z_612 + 3.0*cos_ag*(2.0*(z_511 + z_330) + 2.0*z_513 -
        z_510*z_543 - z_512*z_543) + z_614*(4.0*z_226 + z_231 - z_232*z_543 - z_541*z_400) + z_548*z_602 -
        12.0*cos_ag*lambda_5 - 2.0*z_296*z_617 - z_270*z_394 - 4.0*sin_ag*z_287 - 4.0*cos_ag*z_322 -
        2.0*z_290*z_618 - 2.0*z_325*z_617 - 2.0*g*z_623 - 12.0*z_624 - 4.0*sin_ag*z_398*(z_318 - z_281));
    const double z_627 = 2.0*g + z_230;
    const double z_628 = cos_ag*z_159;
    const double z_629 = z_159*z_496;
    const double z_630 = z_228*z_614;
    const double z_631 = 2.0*c_*z_608 + z_614*(z_411 + z_235);
    const double z_632 = 4.0*z_615 + z_631;
    D[115] = (1.0/12.0)*(3.0*z_627*z_628 + 2.0*density*z_630 + 2.0*h*z_623 + z_607*z_79 + density*z_632 -
        6.0*sin_ag*z_629);
    const double z_633 = z_631 - 24.0*z_625;
    D[116] = (1.0/12.0)*(2.0*z_552*z_598 + 2.0*z_552*z_599 + 3.0*z_230*z_628 + 2.0*z_614*z_419 + 2.0*z_552*z_600 +
        2.0*z_621*z_553 + z_608*z_79 + density*z_633 - 2.0*z_552*z_601 - 2.0*i*z_623 - 12.0*z_624 -
        6.0*sin_ag*(z_629 + z_620*z_495));
    D[117] = ((-2.0/3.0))*(z_354*z_595);
    D[118] = (-2.0)*z_624;
    const double z_634 = h*gravity;
    const double z_635 = z_227*z_495;
    D[121] = (1.0/12.0)*(z_271*z_610 + 2.0*h*z_630 + z_607*z_559 + z_608*z_560 + 2.0*z_609*z_561 + h*z_632 +
        i*z_633 + 4.0*g*z_626 + z_612*z_435 + 2.0*f*z_616 + 3.0*cos_ag*(z_627*z_634 + i*gravity*z_230 +
        2.0*gravity*z_435 + 2.0*gravity*z_225) - z_271*z_611 - 6.0*sin_ag*(z_496*z_634 + gravity*z_635) -
        12.0*z_605*(z_200 + 2.0*z_584) - 2.0*z_585*z_595);
    D[124] = 0.25*(cos_ag*(2.0*z_280 + z_83*z_627 + z_81*z_230 + 2.0*density*z_225) - 2.0*sin_ag*(z_83*z_496 +
        density*z_635));
    D[127] = z_3 + z_8;
    D[135] = -(cos_aj*z_56 + sin_aj*aj_ddot);
    D[138] = -(z_425 + z_427);
    D[145] = z_43 - z_45;
    D[153] = -(z_57 - cos_aj*aj_ddot);
    D[156] = -(z_193 - z_210);
    D[164] = z_107 + z_77;
    D[172] = -(z_171 + sin_ak*ak_ddot);
    D[174] = -(z_425 + z_427);
    D[182] = z_110 - z_99;
    D[190] = -(z_169 - cos_ak*ak_ddot);
    D[192] = -(z_193 - z_210);
    const double z_636 = z_469 - z_470;
    const double z_637 = z_478 + z_479 + 2.0*z_636*z_347;
    D[199] = 0.5*(z_452 + z_454 + 2.0*z_636*z_346 - 2.0*b*z_637);
    D[200] = z_107 + z_77;
    D[201] = z_524 + z_636*z_368 - z_525 - d*z_637;
    D[202] = e*z_637;
    D[203] = -(z_380 + sin_af*af_ddot);
    D[204] = z_398 + z_283;
    const double z_638 = z_468 + z_474;
    const double z_639 = z_477 - z_480 - 2.0*z_638*z_347;
    D[217] = 0.5*(z_450 - z_467 - 2.0*z_638*z_346 - 2.0*b*z_639);
    D[218] = z_110 - z_99;
    D[219] = -(z_523 + z_526 + z_638*z_368 + d*z_639);
    D[220] = e*z_639;
    D[221] = -(z_379 - cos_af*af_ddot);
    D[222] = z_399 - z_320;
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

#include "em_blocks.h"
#include "em_assumptions.h"

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
    const double z_4 = z_2/z_3;
    const double c_ = parameters[2];
    const double z_5 = c_*c_;
    const double z_6 = density*c_;
    const double g = parameters[6];
    const double z_7 = density*g;
    const double i = parameters[8];
    const double z_8 = density*i;
    const double h = parameters[7];
    const double z_9 = h*z_6;
    const double z_10 = density*h;
    const double z_11 = z_8 + z_10;
    const double z_12 = c_*z_11 + 0.5*i*z_6;
    const double f = parameters[5];
    const double z_13 = density*f;
    const double z_14 = z_13 + z_7 + z_10;
    const double z_15 = c_*z_14 + 0.5*g*z_6;
    const double z_16 = 2.0*z_5*z_6 + 2.0*(z_1 + z_7 + z_8)*z_5 + c_*(2.0*z_9 + 2.0*z_12 + 2.0*z_15) + z_7*z_5 +
        z_8*z_5;
    const double z_17 = z_5/z_16;
    const double z_18 = 1.0/(1.0439356584272999*z_4 + 1.9779122466912002*z_17);
    const double z_19 = z_2*z_18;
    prepared[18] = z_19; /* c_1 */
    const double b = parameters[1];
    const double z_20 = b*b;
    const double z_21 = density*b;
    const double e = parameters[4];
    const double z_22 = density*e;
    const double d = parameters[3];
    const double z_23 = d*d;
    const double z_24 = z_20 + z_23 - e*e;
    const double z_25 = z_22 + density*d + z_13;
    const double z_26 = z_24/b;
    const double z_27 = 4.0 - z_24*z_24/(z_20*z_23);
    const double z_28 = 4.0*z_20*z_21 + 4.0*(z_0 + z_22)*z_20 + z_22*z_24 + (e*z_21 + z_25*z_26)*z_26 +
        z_25*z_27*z_23;
    const double z_29 = 1.0/z_28;
    const double z_30 = 1.0/(0.9560643415727004*z_4 + 1.7189244238450625*z_20*z_29);
    const double z_31 = 1.0/(0.9560643415727004*z_4 + 2.0220877533087998*z_17);
    const double z_32 = z_2*z_30 + z_2*z_31;
    prepared[19] = z_32; /* c_2 */
    const double z_33 = m*z_30;
    const double z_34 = j*z_33;
    prepared[20] = (1.0/3.0)*z_34; /* c_3 */
    const double z_35 = z_30*(j*j);
    prepared[21] = (1.0/3.0)*z_35; /* c_4 */
    const double z_36 = m*j*z_21;
    prepared[22] = z_36; /* c_5 */
    prepared[23] = z_36 - 2.0*b*z_33; /* c_6 */
    const double z_37 = j*z_30;
    const double z_38 = b*z_37;
    prepared[24] = (1.0/3.0)*z_38; /* c_7 */
    prepared[25] = z_28; /* c_8 */
    const double z_39 = g*g;
    const double z_40 = i*i;
    const double z_41 = z_39 + z_40 - h*h;
    const double z_42 = z_41/g;
    const double z_43 = 4.0 - z_41*z_41/(z_39*z_40);
    const double z_44 = g*(4.0*g*z_14 + z_10*z_42) + (z_7*h + z_11*z_42)*z_42 + z_11*z_43*z_40;
    const double z_45 = z_39/z_44;
    const double z_46 = d*sqrt(0.25*z_27);
    const double z_47 = 0.6245840315389466*z_26 + 1.5619152186294316*z_46;
    const double z_48 = 0.19906253667584417*z_26 - 1.959973577875149*z_46;
    const double z_49 = 1.0/(2.0220877533087998*z_17 + 7.234536854676909*z_45 + z_29*(z_47*z_47) +
        z_29*(z_48*z_48));
    prepared[26] = z_49; /* c_9 */
    prepared[27] = z_26; /* c_10 */
    prepared[28] = 2.0*z_46; /* c_11 */
    const double z_50 = 0.9799867889375745*z_26 + 0.39812507335168834*z_46;
    const double z_51 = 0.7809576093147158*z_26 - 1.2491680630778932*z_46;
    const double z_52 = 1.0/(1.9779122466912002*z_17 + z_29*(z_50*z_50) + z_29*(z_51*z_51) +
        0.7654631453230909*z_45);
    prepared[29] = z_52; /* c_12 */
    prepared[30] = 4.0*(z_20*z_30); /* c_13 */
    const double z_53 = m*k;
    prepared[31] = z_31*z_53; /* c_14 */
    prepared[32] = z_18*z_53; /* c_15 */
    const double z_54 = k*k;
    const double z_55 = z_31*z_54;
    prepared[33] = z_55; /* c_16 */
    const double z_56 = z_18*z_54;
    prepared[34] = z_56; /* c_17 */
    const double z_57 = z_6*z_53;
    const double z_58 = c_*z_31;
    prepared[35] = z_57 - 2.0*m*z_58; /* c_18 */
    const double z_59 = c_*z_18;
    prepared[36] = z_57 - 2.0*m*z_59; /* c_19 */
    const double z_60 = f*z_6;
    const double z_61 = c_*z_49;
    prepared[37] = z_60 - 2.0*z_61; /* c_20 */
    const double z_62 = c_*z_52;
    prepared[38] = z_60 - 2.0*z_62; /* c_21 */
    prepared[39] = k*z_58; /* c_22 */
    prepared[40] = k*z_59; /* c_23 */
    prepared[41] = z_16; /* c_24 */
    const double z_63 = z_5*z_31 + z_5*z_49;
    prepared[42] = 2.0*z_63; /* c_25 */
    const double z_64 = z_5*z_18 + z_5*z_52;
    prepared[43] = 2.0*z_64; /* c_26 */
    prepared[44] = f*z_52; /* c_27 */
    prepared[45] = f*z_49; /* c_28 */
    prepared[46] = f*z_61; /* c_29 */
    prepared[47] = f*z_62; /* c_30 */
    const double z_65 = f*f;
    const double z_66 = z_49*z_65;
    prepared[48] = z_66; /* c_31 */
    const double z_67 = z_52*z_65;
    prepared[49] = z_67; /* c_32 */
    const double z_68 = f*z_7;
    const double z_69 = g*z_49;
    prepared[50] = z_68 - 2.0*z_69; /* c_33 */
    const double z_70 = g*z_52;
    prepared[51] = z_68 - 2.0*z_70; /* c_34 */
    const double z_71 = z_9 + 2.0*z_12;
    const double z_72 = 2.0*g*(z_9 + 2.0*z_15) + z_71*z_42;
    prepared[52] = z_72 + 4.0*g*z_61; /* c_35 */
    prepared[53] = z_72 + 4.0*g*z_62; /* c_36 */
    const double z_73 = i*sqrt(0.25*z_43);
    const double z_74 = z_71*z_73;
    prepared[54] = 2.0*z_74; /* c_37 */
    const double z_75 = f*g;
    prepared[55] = z_49*z_75; /* c_38 */
    prepared[56] = z_52*z_75; /* c_39 */
    prepared[57] = z_44; /* c_40 */
    const double z_76 = z_39*z_49;
    prepared[58] = 4.0*z_76; /* c_41 */
    const double z_77 = z_39*z_52;
    prepared[59] = 4.0*z_77; /* c_42 */
    prepared[60] = (2.0/3.0)*(z_19 - z_32); /* c_43 */
    prepared[61] = z_34; /* c_44 */
    prepared[62] = (2.0/3.0)*z_35; /* c_45 */
    prepared[63] = z_38; /* c_46 */
    prepared[64] = (2.0/3.0)*(z_55 - z_56); /* c_47 */
    prepared[65] = (2.0/3.0)*(z_63 - z_64); /* c_48 */
    prepared[66] = (2.0/3.0)*(z_66 - z_67); /* c_49 */
    prepared[67] = z_74; /* c_50 */
    prepared[68] = (2.0/3.0)*(z_76 - z_77); /* c_51 */
    prepared[69] = z_57; /* c_52 */
    const double gravity = parameters[16];
    const double z_78 = density*gravity;
    const double z_79 = k*z_78;
    const double z_80 = j*z_78;
    prepared[70] = m*(z_79 + z_80); /* c_53 */
    const double torque = parameters[15];
    prepared[71] = 2.0*torque; /* c_54 */
    prepared[72] = z_33; /* c_55 */
    prepared[73] = m*z_18; /* c_56 */
    prepared[74] = m*z_31; /* c_57 */
    prepared[75] = (1.0/3.0)*z_37; /* c_58 */
    prepared[76] = z_60; /* c_59 */
    prepared[77] = z_68; /* c_60 */
    const double z_81 = 2.0*b + z_26;
    const double z_82 = e*z_78;
    const double z_83 = f*z_78;
    const double z_84 = z_83 + d*z_78;
    prepared[78] = z_81*z_82 + 2.0*b*(z_80 + b*z_78) + z_26*z_84; /* c_61 */
    prepared[79] = 2.0*(z_46*(z_82 + z_84)); /* c_62 */
    prepared[80] = 2.0*c_; /* c_63 */
    prepared[81] = 2.0*g; /* c_64 */
    prepared[82] = 2.0*f; /* c_65 */
    prepared[83] = 4.0*(b*z_30); /* c_66 */
    prepared[84] = k*z_18; /* c_67 */
    prepared[85] = k*z_31; /* c_68 */
    prepared[86] = z_72; /* c_69 */
    const double z_85 = g*z_78;
    const double z_86 = i*z_78;
    const double z_87 = h*z_78;
    const double z_88 = z_86 + z_87;
    prepared[87] = 6.0*(c_*(z_79 + 2.0*z_85 + c_*z_78 + 2.0*z_88 + z_83)); /* c_70 */
    prepared[88] = z_62; /* c_71 */
    prepared[89] = z_61; /* c_72 */
    prepared[90] = 2.0*z_59; /* c_73 */
    prepared[91] = 2.0*z_58; /* c_74 */
    const double z_89 = 2.0*g + z_42;
    prepared[92] = z_42*z_86 + z_89*z_87 + 2.0*g*(z_85 + z_83); /* c_75 */
    prepared[93] = 2.0*(z_73*z_88); /* c_76 */
    prepared[94] = z_70; /* c_77 */
    prepared[95] = z_69; /* c_78 */
    prepared[96] = (1.0/3.0)*z_3; /* c_79 */
    prepared[97] = (1.0/12.0)*z_28; /* c_80 */
    prepared[98] = (1.0/6.0)*z_16; /* c_81 */
    prepared[99] = (1.0/12.0)*z_44; /* c_82 */
    prepared[100] = fabs(j); /* c_83 */
    prepared[101] = fabs(b); /* c_84 */
    prepared[102] = fabs(m); /* c_85 */
    const double a_ = parameters[0];
    prepared[103] = fabs(a_); /* c_86 */
    const double l = parameters[11];
    prepared[104] = fabs(l); /* c_87 */
    prepared[105] = fabs(k); /* c_88 */
    const double z_90 = fabs(c_);
    prepared[106] = z_90; /* c_89 */
    prepared[107] = fabs(z_26); /* c_90 */
    prepared[108] = 2.0*z_90; /* c_91 */
    prepared[109] = 2.0*fabs(z_46); /* c_92 */
    prepared[110] = 2.0*fabs(f); /* c_93 */
    prepared[111] = 2.0*fabs(g); /* c_94 */
    prepared[112] = 2.0*z_3; /* c_95 */
    prepared[113] = 2.0*z_16; /* c_96 */
    prepared[114] = (-4.0)*l; /* c_97 */
    prepared[115] = z_81; /* c_98 */
    prepared[116] = z_89; /* c_99 */
    prepared[117] = 2.0*z_73; /* c_100 */
    prepared[118] = 4.0*c_; /* c_101 */
    prepared[119] = z_42; /* c_102 */
    prepared[120] = 2.0*b; /* c_103 */
    prepared[121] = (-2.0)*l; /* c_104 */
    prepared[122] = 2.0*j; /* c_105 */
    prepared[123] = 2.0*k; /* c_106 */
    prepared[124] = z_78; /* c_107 */
    prepared[125] = 4.0*torque; /* c_108 */
    prepared[126] = -a_; /* c_109 */
    prepared[127] = -l; /* c_110 */
    prepared[128] = (-2.0)*a_; /* c_111 */
    prepared[129] = (1.0/10.0)*m; /* c_112 */
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
    {60, "positive"},
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
    const double c_79 = c[96];
    M[0] = c_79;
    M[7] = M[1] = 0.0;
    M[8] = 0.0;
    const double c_5 = c[22];
    const double ab = x[2];
    const double cos_ab = em_cos(ab);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double sin_ab = em_sin(ab);
    const double sin_theta = em_sin(theta);
    M[14] = M[2] = (1.0/6.0)*(c_5*(cos_ab*cos_theta + sin_ab*sin_theta));
    M[15] = M[9] = 0.0;
    const double c_80 = c[97];
    M[16] = c_80;
    M[21] = M[3] = 0.0;
    M[22] = M[10] = 0.0;
    M[23] = M[17] = 0.0;
    M[24] = 0.0;
    const double c_52 = c[69];
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double sin_ac = em_sin(ac);
    M[28] = M[4] = (1.0/6.0)*(c_52*(cos_theta*cos_ac + sin_theta*sin_ac));
    M[29] = M[11] = 0.0;
    const double c_59 = c[76];
    const double c_10 = c[27];
    const double c_11 = c[28];
    const double z_6 = cos_ab*c_10 - sin_ab*c_11;
    const double z_7 = sin_ab*c_10 + cos_ab*c_11;
    M[30] = M[18] = (1.0/12.0)*(c_59*(cos_ac*z_6 + sin_ac*z_7));
    M[31] = M[25] = 0.0;
    const double c_81 = c[98];
    M[32] = c_81;
    M[35] = M[5] = 0.0;
    M[36] = M[12] = 0.0;
    M[37] = M[19] = 0.0;
    M[38] = M[26] = 0.0;
    M[39] = M[33] = 0.0;
    M[40] = 0.0;
    M[42] = M[6] = 0.0;
    M[43] = M[13] = 0.0;
    const double c_60 = c[77];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double sin_ag = em_sin(ag);
    M[44] = M[20] = (1.0/12.0)*(c_60*(z_6*cos_ag + z_7*sin_ag));
    M[45] = M[27] = 0.0;
    const double c_69 = c[86];
    const double c_37 = c[54];
    M[46] = M[34] = (1.0/12.0)*(cos_ac*cos_ag*c_69 + sin_ac*sin_ag*c_69 + c_37*(sin_ac*cos_ag) -
        c_37*(cos_ac*sin_ag));
    M[47] = M[41] = 0.0;
    const double c_82 = c[99];
    M[48] = c_82;
}

/* M + A^T W A (n, n), which is factored in place of M: M is singular, but not along the constraints */
EM_ACROSS void factored_matrix(double t, const double *restrict x, const double *restrict c,
                               double *restrict M)
{
    const double c_0 = c[17];
    const double c_1 = c[18];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double c_2 = c[19];
    const double cos_theta = em_cos(theta);
    M[0] = (1.0/3.0)*(c_0 + c_1*(sin_theta*sin_theta) + c_2*(cos_theta*cos_theta));
    const double c_3 = c[20];
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    M[7] = M[1] = c_3*(cos_theta*cos_aj);
    const double c_4 = c[21];
    M[8] = c_4*(cos_aj*cos_aj);
    const double ab = x[2];
    const double sin_ab = em_sin(ab);
    const double c_5 = c[22];
    const double cos_ab = em_cos(ab);
    const double c_6 = c[23];
    M[14] = M[2] = (1.0/6.0)*(sin_ab*sin_theta*c_5 + cos_ab*cos_theta*c_6);
    const double c_7 = c[24];
    M[15] = M[9] = -c_7*(cos_ab*cos_aj);
    const double c_8 = c[25];
    const double c_9 = c[26];
    const double c_10 = c[27];
    const double c_11 = c[28];
    const double z_5 = cos_ab*c_10 - sin_ab*c_11;
    const double c_12 = c[29];
    const double z_6 = sin_ab*c_10 + cos_ab*c_11;
    const double c_13 = c[30];
    M[16] = (1.0/12.0)*(c_8 + c_9*(z_5*z_5) + c_12*(z_6*z_6) + c_13*(cos_ab*cos_ab));
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double c_14 = c[31];
    const double sin_ak = em_sin(ak);
    const double c_15 = c[32];
    M[21] = M[3] = (1.0/3.0)*(cos_theta*cos_ak*c_14 + sin_theta*sin_ak*c_15);
    M[22] = M[10] = 0.0;
    M[23] = M[17] = 0.0;
    const double c_16 = c[33];
    const double c_17 = c[34];
    M[24] = (1.0/3.0)*(c_16*(cos_ak*cos_ak) + c_17*(sin_ak*sin_ak));
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_18 = c[35];
    const double sin_ac = em_sin(ac);
    const double c_19 = c[36];
    M[28] = M[4] = (1.0/6.0)*(cos_theta*cos_ac*c_18 + sin_theta*sin_ac*c_19);
    M[29] = M[11] = 0.0;
    const double c_20 = c[37];
    const double c_21 = c[38];
    M[30] = M[18] = (1.0/12.0)*(cos_ac*z_5*c_20 + sin_ac*z_6*c_21);
    const double c_22 = c[39];
    const double c_23 = c[40];
    M[31] = M[25] = ((-1.0/3.0))*(cos_ac*cos_ak*c_22 + sin_ac*sin_ak*c_23);
    const double c_24 = c[41];
    const double c_25 = c[42];
    const double c_26 = c[43];
    M[32] = (1.0/6.0)*(c_24 + c_25*(cos_ac*cos_ac) + c_26*(sin_ac*sin_ac));
    M[35] = M[5] = 0.0;
    M[36] = M[12] = 0.0;
    const double af = x[5];
    const double sin_af = em_sin(af);
    const double c_27 = c[44];
    const double cos_af = em_cos(af);
    const double c_28 = c[45];
    M[37] = M[19] = (1.0/6.0)*(z_6*sin_af*c_27 + z_5*cos_af*c_28);
    M[38] = M[26] = 0.0;
    const double c_29 = c[46];
    const double c_30 = c[47];
    M[39] = M[33] = ((-1.0/3.0))*(cos_ac*cos_af*c_29 + sin_ac*sin_af*c_30);
    const double c_31 = c[48];
    const double c_32 = c[49];
    M[40] = (1.0/3.0)*(c_31*(cos_af*cos_af) + c_32*(sin_af*sin_af));
    M[42] = M[6] = 0.0;
    M[43] = M[13] = 0.0;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_33 = c[50];
    const double sin_ag = em_sin(ag);
    const double c_34 = c[51];
    M[44] = M[20] = (1.0/12.0)*(z_5*cos_ag*c_33 + z_6*sin_ag*c_34);
    M[45] = M[27] = 0.0;
    const double c_35 = c[52];
    const double c_36 = c[53];
    const double c_37 = c[54];
    M[46] = M[34] = ((-1.0/12.0))*(c_37*(cos_ac*sin_ag) - cos_ac*cos_ag*c_35 - sin_ac*sin_ag*c_36 -
        c_37*(sin_ac*cos_ag));
    const double c_38 = c[55];
    const double c_39 = c[56];
    M[47] = M[41] = ((-1.0/3.0))*(cos_ag*cos_af*c_38 + sin_ag*sin_af*c_39);
    const double c_40 = c[57];
    const double c_41 = c[58];
    const double c_42 = c[59];
    M[48] = (1.0/12.0)*(c_40 + c_41*(cos_ag*cos_ag) + c_42*(sin_ag*sin_ag));
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
    const double c_10 = c[27];
    const double c_11 = c[28];
    A[30] = (-0.5)*(sin_ab*c_10 + cos_ab*c_11);
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
    A[37] = 0.5*(cos_ab*c_10 - sin_ab*c_11);
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
    const double c_10 = c[27];
    const double c_11 = c[28];
    const double c_63 = c[80];
    const double af = x[5];
    const double cos_af = em_cos(af);
    const double c_65 = c[82];
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_64 = c[81];
    phi[4] = 0.5*(cos_ab*c_10 + cos_af*c_65 - sin_ab*c_11 - cos_ac*c_63 - cos_ag*c_64);
    const double sin_af = em_sin(af);
    const double sin_ag = em_sin(ag);
    phi[5] = 0.5*(sin_ab*c_10 + cos_ab*c_11 + sin_af*c_65 - sin_ac*c_63 - sin_ag*c_64);
    const double c_83 = c[100];
    const double c_84 = c[101];
    const double z_16 = fabs(cos_ab) + fabs(ab*sin_ab);
    const double c_85 = c[102];
    const double c_86 = c[103];
    const double z_17 = c_85*(fabs(cos_theta) + fabs(theta*sin_theta)) + c_86;
    terms[0] = c_83*(fabs(cos_aj) + fabs(aj*sin_aj)) + c_84*z_16 + z_17;
    const double z_18 = fabs(sin_ab) + fabs(ab*cos_ab);
    const double c_87 = c[104];
    const double z_19 = c_85*(fabs(sin_theta) + fabs(theta*cos_theta)) + c_87;
    terms[1] = c_83*(fabs(sin_aj) + fabs(aj*cos_aj)) + c_84*z_18 + z_19;
    const double c_88 = c[105];
    const double c_89 = c[106];
    const double z_20 = fabs(cos_ac) + fabs(ac*sin_ac);
    terms[2] = c_88*(fabs(cos_ak) + fabs(ak*sin_ak)) + c_89*z_20 + z_17;
    const double z_21 = fabs(sin_ac) + fabs(ac*cos_ac);
    terms[3] = c_88*(fabs(sin_ak) + fabs(ak*cos_ak)) + c_89*z_21 + z_19;
    const double c_90 = c[107];
    const double c_91 = c[108];
    const double c_92 = c[109];
    const double c_93 = c[110];
    const double c_94 = c[111];
    terms[4] = 0.5*(z_16*c_90 + z_20*c_91 + z_18*c_92 + (fabs(cos_af) + fabs(af*sin_af))*c_93 + (fabs(cos_ag) +
        fabs(ag*sin_ag))*c_94);
    terms[5] = 0.5*(z_18*c_90 + z_21*c_91 + z_16*c_92 + (fabs(sin_af) + fabs(af*cos_af))*c_93 + (fabs(sin_ag) +
        fabs(ag*cos_ag))*c_94);
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
                              double A1[N_ROWS][N1], double b[N_ROWS], double shared[16])
{
    const double c_0 = c[17];
    const double c_1 = c[18];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double c_2 = c[19];
    const double cos_theta = em_cos(theta);
    M1[0][0] = (1.0/3.0)*(c_0 + c_1*(sin_theta*sin_theta) + c_2*(cos_theta*cos_theta));
    const double c_3 = c[20];
    const double aj = x[1];
    const double cos_aj = em_cos(aj);
    M1[0][1] = M1[1][0] = c_3*(cos_theta*cos_aj);
    const double c_4 = c[21];
    M1[1][1] = c_4*(cos_aj*cos_aj);
    const double ab = x[2];
    const double sin_ab = em_sin(ab);
    const double c_5 = c[22];
    const double cos_ab = em_cos(ab);
    const double c_6 = c[23];
    M1[0][2] = M1[2][0] = (1.0/6.0)*(sin_theta*(sin_ab*c_5) + cos_theta*(cos_ab*c_6));
    const double c_7 = c[24];
    M1[1][2] = M1[2][1] = -c_7*(cos_ab*cos_aj);
    const double c_8 = c[25];
    const double c_9 = c[26];
    const double c_10 = c[27];
    const double c_11 = c[28];
    const double z_5 = cos_ab*c_10 - sin_ab*c_11;
    const double c_12 = c[29];
    const double z_6 = sin_ab*c_10 + cos_ab*c_11;
    const double c_13 = c[30];
    M1[2][2] = (1.0/12.0)*(c_8 + c_9*(z_5*z_5) + c_12*(z_6*z_6) + c_13*(cos_ab*cos_ab));
    const double ak = x[3];
    const double cos_ak = em_cos(ak);
    const double c_14 = c[31];
    const double sin_ak = em_sin(ak);
    const double c_15 = c[32];
    M1[0][3] = M1[3][0] = (1.0/3.0)*(cos_ak*(cos_theta*c_14) + sin_ak*(sin_theta*c_15));
    M1[1][3] = M1[3][1] = 0.0;
    M1[2][3] = M1[3][2] = 0.0;
    const double c_16 = c[33];
    const double c_17 = c[34];
    M1[3][3] = (1.0/3.0)*(c_16*(cos_ak*cos_ak) + c_17*(sin_ak*sin_ak));
    const double ac = x[4];
    const double cos_ac = em_cos(ac);
    const double c_18 = c[35];
    const double sin_ac = em_sin(ac);
    const double c_19 = c[36];
    M1[0][4] = M1[4][0] = (1.0/6.0)*(cos_ac*(cos_theta*c_18) + sin_ac*(sin_theta*c_19));
    M1[1][4] = M1[4][1] = 0.0;
    const double c_20 = c[37];
    const double c_21 = c[38];
    M1[2][4] = M1[4][2] = (1.0/12.0)*(z_5*(cos_ac*c_20) + z_6*(sin_ac*c_21));
    const double c_22 = c[39];
    const double c_23 = c[40];
    M1[3][4] = M1[4][3] = ((-1.0/3.0))*(cos_ak*(cos_ac*c_22) + sin_ak*(sin_ac*c_23));
    const double c_24 = c[41];
    const double c_25 = c[42];
    const double c_26 = c[43];
    M1[4][4] = (1.0/6.0)*(c_24 + c_25*(cos_ac*cos_ac) + c_26*(sin_ac*sin_ac));
    M1[0][5] = M1[5][0] = 0.0;
    M1[1][5] = M1[5][1] = 0.0;
    const double af = x[5];
    const double sin_af = em_sin(af);
    const double c_27 = c[44];
    const double cos_af = em_cos(af);
    const double c_28 = c[45];
    M1[2][5] = M1[5][2] = (1.0/6.0)*(sin_af*(z_6*c_27) + cos_af*(z_5*c_28));
    M1[3][5] = M1[5][3] = 0.0;
    const double c_29 = c[46];
    const double c_30 = c[47];
    M1[4][5] = M1[5][4] = ((-1.0/3.0))*(cos_af*(cos_ac*c_29) + sin_af*(sin_ac*c_30));
    const double c_31 = c[48];
    const double c_32 = c[49];
    M1[5][5] = (1.0/3.0)*(c_31*(cos_af*cos_af) + c_32*(sin_af*sin_af));
    M1[0][6] = M1[6][0] = 0.0;
    M1[1][6] = M1[6][1] = 0.0;
    const double ag = x[6];
    const double cos_ag = em_cos(ag);
    const double c_33 = c[50];
    const double sin_ag = em_sin(ag);
    const double c_34 = c[51];
    M1[2][6] = M1[6][2] = (1.0/12.0)*(cos_ag*(z_5*c_33) + sin_ag*(z_6*c_34));
    M1[3][6] = M1[6][3] = 0.0;
    const double c_35 = c[52];
    const double c_36 = c[53];
    const double c_37 = c[54];
    M1[4][6] = M1[6][4] = ((-1.0/12.0))*(c_37*(cos_ac*sin_ag) - cos_ag*(cos_ac*c_35) - sin_ag*(sin_ac*c_36) -
        c_37*(sin_ac*cos_ag));
    const double c_38 = c[55];
    const double c_39 = c[56];
    M1[5][6] = M1[6][5] = ((-1.0/3.0))*(cos_af*(cos_ag*c_38) + sin_af*(sin_ag*c_39));
    const double c_40 = c[57];
    const double c_41 = c[58];
    const double c_42 = c[59];
    M1[6][6] = (1.0/12.0)*(c_40 + c_41*(cos_ag*cos_ag) + c_42*(sin_ag*sin_ag));
    const double m = c[12];
    A1[0][0] = -m*sin_theta;
    const double j = c[9];
    const double sin_aj = em_sin(aj);
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
    A1[4][2] = (-0.5)*z_6;
    A1[4][3] = 0.0;
    A1[4][4] = c_*sin_ac;
    const double f = c[5];
    A1[4][5] = -f*sin_af;
    const double g = c[6];
    A1[4][6] = g*sin_ag;
    A1[5][0] = 0.0;
    A1[5][1] = 0.0;
    A1[5][2] = 0.5*z_5;
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
    shared[0] = cos_theta;
    shared[1] = sin_theta;
    shared[2] = cos_aj;
    shared[3] = sin_aj;
    shared[4] = cos_ab;
    shared[5] = sin_ab;
    shared[6] = z_5;
    shared[7] = z_6;
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
    const double c_43 = c[60];
    const double cos_theta = shared[0];
    const double theta_dot = v[0];
    const double sin_theta = shared[1];
    const double z_16 = theta_dot*sin_theta;
    Mdot1[0][0] = c_43*(cos_theta*z_16);
    const double c_44 = c[61];
    const double cos_aj = shared[2];
    const double aj_dot = v[1];
    const double sin_aj = shared[3];
    const double z_17 = aj_dot*sin_aj;
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/3.0))*(c_44*(cos_aj*z_16 + cos_theta*z_17));
    const double c_45 = c[62];
    Mdot1[1][1] = -c_45*(cos_aj*z_17);
    const double c_5 = c[22];
    const double ab_dot = v[2];
    const double cos_ab = shared[4];
    const double z_18 = ab_dot*cos_ab;
    const double sin_ab = shared[5];
    const double z_19 = theta_dot*cos_theta;
    const double c_6 = c[23];
    const double z_20 = ab_dot*sin_ab;
    Mdot1[0][2] = Mdot1[2][0] = (1.0/6.0)*(c_5*(sin_theta*z_18 + sin_ab*z_19) - c_6*(cos_theta*z_20 +
        cos_ab*z_16));
    const double c_46 = c[63];
    Mdot1[1][2] = Mdot1[2][1] = (1.0/3.0)*(c_46*(cos_aj*z_20 + cos_ab*z_17));
    const double z_5 = shared[6];
    const double c_9 = c[26];
    const double c_10 = c[27];
    const double c_11 = c[28];
    const double z_21 = c_10*z_20 + c_11*z_18;
    const double z_6 = shared[7];
    const double c_12 = c[29];
    const double z_22 = c_10*z_18 - c_11*z_20;
    const double c_13 = c[30];
    Mdot1[2][2] = ((-1.0/6.0))*(z_5*c_9*z_21 + c_13*(cos_ab*z_20) - z_6*c_12*z_22);
    const double c_14 = c[31];
    const double cos_ak = shared[8];
    const double ak_dot = v[3];
    const double sin_ak = shared[9];
    const double z_23 = ak_dot*sin_ak;
    const double c_15 = c[32];
    const double z_24 = ak_dot*cos_ak;
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/3.0))*(c_14*(cos_ak*z_16 + cos_theta*z_23) - c_15*(sin_ak*z_19 +
        sin_theta*z_24));
    Mdot1[1][3] = Mdot1[3][1] = 0.0;
    Mdot1[2][3] = Mdot1[3][2] = 0.0;
    const double c_47 = c[64];
    Mdot1[3][3] = -c_47*(sin_ak*z_24);
    const double c_18 = c[35];
    const double cos_ac = shared[10];
    const double ac_dot = v[4];
    const double sin_ac = shared[11];
    const double z_25 = ac_dot*sin_ac;
    const double c_19 = c[36];
    const double z_26 = ac_dot*cos_ac;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(c_18*(cos_ac*z_16 + cos_theta*z_25) - c_19*(sin_ac*z_19 +
        sin_theta*z_26));
    Mdot1[1][4] = Mdot1[4][1] = 0.0;
    const double c_20 = c[37];
    const double c_21 = c[38];
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/12.0))*(c_20*(z_5*z_25 + cos_ac*z_21) - c_21*(z_6*z_26 + sin_ac*z_22));
    const double c_22 = c[39];
    const double c_23 = c[40];
    Mdot1[3][4] = Mdot1[4][3] = (1.0/3.0)*(c_22*(cos_ak*z_25 + cos_ac*z_23) - c_23*(sin_ak*z_26 + sin_ac*z_24));
    const double c_48 = c[65];
    Mdot1[4][4] = -c_48*(sin_ac*z_26);
    Mdot1[0][5] = Mdot1[5][0] = 0.0;
    Mdot1[1][5] = Mdot1[5][1] = 0.0;
    const double c_27 = c[44];
    const double sin_af = shared[12];
    const double af_dot = v[5];
    const double cos_af = shared[13];
    const double z_27 = af_dot*cos_af;
    const double c_28 = c[45];
    const double z_28 = af_dot*sin_af;
    Mdot1[2][5] = Mdot1[5][2] = (1.0/6.0)*(c_27*(sin_af*z_22 + z_6*z_27) - c_28*(cos_af*z_21 + z_5*z_28));
    Mdot1[3][5] = Mdot1[5][3] = 0.0;
    const double c_29 = c[46];
    const double c_30 = c[47];
    Mdot1[4][5] = Mdot1[5][4] = (1.0/3.0)*(c_29*(cos_af*z_25 + cos_ac*z_28) - c_30*(sin_af*z_26 + sin_ac*z_27));
    const double c_49 = c[66];
    Mdot1[5][5] = -c_49*(cos_af*z_28);
    Mdot1[0][6] = Mdot1[6][0] = 0.0;
    Mdot1[1][6] = Mdot1[6][1] = 0.0;
    const double c_33 = c[50];
    const double cos_ag = shared[14];
    const double ag_dot = v[6];
    const double sin_ag = shared[15];
    const double z_29 = ag_dot*sin_ag;
    const double c_34 = c[51];
    const double z_30 = ag_dot*cos_ag;
    Mdot1[2][6] = Mdot1[6][2] = ((-1.0/12.0))*(c_33*(cos_ag*z_21 + z_5*z_29) - c_34*(sin_ag*z_22 + z_6*z_30));
    Mdot1[3][6] = Mdot1[6][3] = 0.0;
    const double c_50 = c[67];
    const double c_35 = c[52];
    const double c_36 = c[53];
    Mdot1[4][6] = Mdot1[6][4] = (1.0/12.0)*(2.0*c_50*(sin_ag*z_25 - cos_ac*z_30) + 2.0*c_50*(cos_ag*z_26 -
        sin_ac*z_29) + c_36*(sin_ag*z_26 + sin_ac*z_30) - c_35*(cos_ag*z_25 + cos_ac*z_29));
    const double c_38 = c[55];
    const double c_39 = c[56];
    Mdot1[5][6] = Mdot1[6][5] = (1.0/3.0)*(c_38*(cos_af*z_29 + cos_ag*z_28) - c_39*(sin_af*z_30 + sin_ag*z_27));
    const double c_51 = c[68];
    Mdot1[6][6] = -c_51*(sin_ag*z_30);
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
    "M^-1: M is singular; M + A^T W A is factored, with weights W of rows 1, 2, 3, 4, 5",
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
static int simulate(em_run *run) { return em_simulate(&jansen_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&jansen_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&jansen_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&jansen_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&jansen_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&jansen_model, run, mode); }

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
    .redundant = em_redundant,
    .energy = energy,
    .eigenfactors = em_eigenfactors_of,
    .output = em_observe,
    .motion_jacobian = em_motion_jacobian,
    .simulate = simulate,
    .interpolate = interpolate,
    .release = release,
    .event = model_events,
    .factored_matrix = factored_matrix,
    .factored_gradient = factored_gradient,
    .lanes = &jansen_lanes,
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
    .n_shapes = 16,
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
