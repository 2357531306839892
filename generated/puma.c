/* eigenmotion generate puma.py */
/* input sha256:44f9309bb8b2d719e1a6d8e72a68752f8590b0520274b45dad0cbd7ef656c8aa */
/* body sha256:b62c057054e8cbf156246e9a4cc4654cfee4c7840d40362f28cf60d58ed9d015 */
/* puma: equations of motion, eigenfactor formulation.
 *
 * State, 54 numbers:
 *   x    y[0 .. 6)
 *   eta  y[6 .. 12)
 *   C    y[12 .. 48)
 *   s    y[48 .. 54)
 *
 * Blocks of M that do not couple:
 *   1: q1, q2, q3, q4, q5, q6 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dq1, dM/dq6: M does not depend on them
 *
 * Operations of the straight-line part:
 *   eigenfactor: 439 additions, 742 multiplications, 10 function calls
 *   triangular root: 480 additions, 831 multiplications, 10 function calls
 *   projection: 344 additions, 596 multiplications, 8 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 6,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 54,         /* numbers of a state */
    N_C = 36,             /* of which C, */
    N_S = 6,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 6,
    N_EVENTS = 0,
    N_MEMORY = 42,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 2,
    N_PREPARED = 31,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 9,          /* inputs, parameters and the time */
    N_ARGUMENTS = 21,     /* x, v and these: what motion depends on */
    N1 = 6,               /* q1, q2, q3, q4, q5, q6 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4, 5 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_BY_ITSELF void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                     const real *restrict u, real Mdot1[N1][N1], real f1[N1])
{
    const real q2 = x[1];
    const real cos_q2 = em_cos(q2);
    const real q2_dot = v[1];
    const real sin_q2 = em_sin(q2);
    const real z_2 = q2_dot*sin_q2;
    const real q3 = x[2];
    const real sin_q3 = em_sin(q3);
    const real z_4 = cos_q2*sin_q3;
    const real cos_q3 = em_cos(q3);
    const real z_6 = sin_q2*cos_q3;
    const real z_7 = z_4 + z_6;
    const real q4 = x[3];
    const real sin_q4 = em_sin(q4);
    const real z_9 = z_7*sin_q4;
    const real q5 = x[4];
    const real cos_q5 = em_cos(q5);
    const real sin_q5 = em_sin(q5);
    const real z_12 = z_7*sin_q5;
    const real z_13 = sin_q2*sin_q3;
    const real z_14 = cos_q2*cos_q3;
    const real z_15 = z_13 - z_14;
    const real z_16 = 4318.0*cos_q2 - 203.0*z_15;
    const real cos_q4 = em_cos(q4);
    const real z_18 = sin_q4*z_16 - 1500.5*z_15*cos_q4;
    const real z_19 = 8636.0*z_9 - 2.0*z_18;
    const real z_20 = z_12 + (1.0/3001.0)*z_19*cos_q5;
    const real z_21 = 4000.0*z_9 + 3001.0*z_20;
    const real c_0 = c[2];
    const real z_22 = 5760.0*z_9 + z_21*c_0 + 129043.0*z_20;
    const real z_23 = cos_q5*z_22;
    const real z_24 = z_7*cos_q5;
    const real z_25 = sin_q5*z_19 - 3001.0*z_24;
    const real c_1 = c[3];
    const real z_26 = sin_q5*c_1;
    const real z_27 = 739312.0*z_9 + z_23 + z_25*z_26 - 164.0*z_18;
    const real z_28 = z_7*cos_q4;
    const real z_29 = sin_q5*z_15 - cos_q5*z_28;
    const real z_30 = sin_q4*z_15 + (2.0/3001.0)*z_16*cos_q4;
    const real z_31 = z_28 - (3001.0/8636.0)*z_30;
    const real z_32 = 8636.0*z_31 - 4000.0*z_29;
    const real c_2 = c[4];
    const real z_33 = 222132.0*z_28 + z_32*c_2 - 75025.0*z_30 - 1152.0*z_29;
    const real z_34 = sin_q4*z_27 + 5.0*cos_q4*z_33;
    const real z_35 = q2_dot*cos_q2;
    const real z_36 = sin_q3*z_2;
    const real q3_dot = v[2];
    const real z_37 = q3_dot*cos_q3;
    const real z_38 = cos_q2*z_37;
    const real z_39 = cos_q3*z_35;
    const real z_40 = q3_dot*sin_q3;
    const real z_41 = sin_q2*z_40;
    const real z_42 = (z_36 - z_38) - (z_39 - z_41);
    const real q4_dot = v[3];
    const real z_43 = q4_dot*cos_q4;
    const real z_44 = sin_q4*z_42 - z_7*z_43;
    const real z_45 = sin_q3*z_35;
    const real z_46 = sin_q2*z_37;
    const real z_47 = cos_q3*z_2;
    const real z_48 = cos_q2*z_40;
    const real z_49 = (z_45 + z_46) + (z_47 + z_48);
    const real z_50 = 4318.0*z_2 + 203.0*z_49;
    const real z_51 = q4_dot*sin_q4;
    const real z_52 = (z_16*z_43 - sin_q4*z_50) - 1500.5*(cos_q4*z_49 - z_15*z_51);
    const real q5_dot = v[4];
    const real z_53 = q5_dot*sin_q5;
    const real z_54 = q5_dot*cos_q5;
    const real z_55 = 8636.0*z_44 + 2.0*z_52;
    const real z_56 = (sin_q5*z_42 - z_7*z_54) + (1.0/3001.0)*(cos_q5*z_55 + z_19*z_53);
    const real z_57 = 4000.0*z_44 + 3001.0*z_56;
    const real z_58 = 5760.0*z_44 + c_0*z_57 + 129043.0*z_56;
    const real z_59 = (z_19*z_54 - sin_q5*z_55) + 3001.0*(cos_q5*z_42 + z_7*z_53);
    const real z_60 = (z_22*z_53 + cos_q5*z_58) - c_1*(z_25*z_54 + sin_q5*z_59);
    const real z_61 = 739312.0*z_44 + 164.0*z_52 + z_60;
    const real z_62 = cos_q4*z_42 + z_7*z_51;
    const real z_63 = cos_q4*cos_q5;
    const real z_64 = (z_15*z_54 + sin_q5*z_49) + (z_63*z_42 + z_24*z_51 + z_28*z_53);
    const real z_65 = (z_15*z_43 + sin_q4*z_49) - (2.0/3001.0)*(cos_q4*z_50 + z_16*z_51);
    const real z_66 = z_62 + (3001.0/8636.0)*z_65;
    const real z_67 = 4000.0*z_64 + 8636.0*z_66;
    const real z_68 = 222132.0*z_62 + z_67*c_2 + 75025.0*z_65 + 1152.0*z_64;
    const real z_69 = (z_27*z_43 - sin_q4*z_61) - 5.0*(z_33*z_51 + cos_q4*z_68);
    const real c_3 = c[5];
    const real z_70 = z_32*c_3 + 77724.0*z_31 - 33885.0*z_29;
    const real z_71 = z_15*cos_q5 + sin_q5*z_28;
    const real z_72 = sin_q4*z_33 - (1.0/5.0)*cos_q4*z_27;
    const real z_73 = 5725482720.0*z_15 + 13600000.0*cos_q5*z_71 + 406.0*z_34 - 640.0*sin_q5*z_70 - 15005.0*z_72;
    const real z_74 = (z_33*z_43 - sin_q4*z_68) + (1.0/5.0)*(z_27*z_51 + cos_q4*z_61);
    const real z_75 = z_67*c_3 + 33885.0*z_64 + 77724.0*z_66;
    const real z_76 = sin_q5*cos_q4;
    const real z_77 = (cos_q5*z_49 - z_15*z_53) - (z_76*z_42 + z_12*z_51 - z_28*z_54);
    const real z_78 = (z_70*z_54 - sin_q5*z_75) + 21250.0*(z_71*z_53 - cos_q5*z_77);
    const real z_79 = 5725482720.0*z_49 + 406.0*z_69 - 15005.0*z_74 - 640.0*z_78;
    const real z_80 = sin_q5*z_22;
    const real c_4 = c[6];
    const real z_81 = 497229916.0*z_28 + 32.0*cos_q5*z_70 + 680000.0*sin_q5*z_71 + z_32*c_4 - 166654533.0*z_30 -
        2487168.0*z_29;
    const real c_5 = c[7];
    const real c_6 = c[8];
    const real z_82 = sin_q5*c_6;
    const real z_83 = 1690830848.0*z_9 + 2159.0*z_23 + z_21*c_5 + z_25*z_82 + 4321440.0*z_20 - 369656.0*z_18;
    const real c_7 = c[9];
    const real z_84 = 5803392000.0*cos_q2 + cos_q5*z_25*c_7 - 9492774802.0*z_7 - 3001.0*z_80 - 20.0*cos_q4*z_81 -
        4.0*sin_q4*z_83;
    const real z_85 = 497229916.0*z_62 + 32.0*(z_70*z_53 + cos_q5*z_75) + z_67*c_4 + 166654533.0*z_65 +
        2487168.0*z_64 - 680000.0*(z_71*z_54 + sin_q5*z_77);
    const real z_86 = 1690830848.0*z_44 + z_57*c_5 + 4321440.0*z_56 + 369656.0*z_52 + 2159.0*z_60;
    const real z_87 = (z_22*z_54 - sin_q5*z_58) + c_1*(z_25*z_53 - cos_q5*z_59);
    const real z_88 = 5803392000.0*z_2 + 4.0*(z_83*z_43 - sin_q4*z_86) + 3001.0*z_87 - 9492774802.0*z_42 -
        20.0*(z_81*z_51 + cos_q4*z_85);
    Mdot1[0][0] = ((-1.0/40000000000.0))*(31520000000.0*cos_q2*z_2 + (z_84*z_39 - z_84*z_41 - z_6*z_88) -
        4.0*((70992000.0*sin_q2 + 1450848000.0*z_7 + 2159.0*z_34 - 18759823020.0*cos_q2)*z_2 -
        cos_q2*(70992000.0*z_35 + 18759823020.0*z_2 + 2159.0*z_69 - 1450848000.0*z_42)) -
        174000.0*((207169.0*sin_q2 - 1632.0*cos_q2)*z_35 + sin_q2*(207169.0*z_35 + 1632.0*z_2)) - (z_73*z_45 +
        z_73*z_46 + z_13*z_79) - (z_84*z_36 + z_4*z_88 - z_84*z_38) - (z_73*z_47 + z_73*z_48 - z_14*z_79));
    const real z_89 = cos_q5*c_1;
    const real z_90 = ((z_81*z_43 - sin_q4*z_85) + (1.0/5.0)*(z_83*z_51 + cos_q4*z_86)) + (203.0/10.0)*(z_87 -
        246082.0*(z_42 + (78792000.0/3568189.0)*z_49));
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/20000000000.0))*(5383560000.0*z_35 + 4318.0*((1575840.0*z_15 -
        5.0*z_72)*z_37 + sin_q3*(1575840.0*z_49 - 5.0*z_74)) + 10.0*z_90 - 475020000.0*z_2 -
        4318.0*((1821922.0*z_7 + z_80 - z_25*z_89)*z_40 + cos_q3*(1821922.0*z_42 - z_87)));
    const real z_91 = sin_q3*cos_q4;
    const real z_92 = 4318.0*cos_q3 + 203.0;
    const real z_93 = cos_q4 - z_91;
    const real z_94 = sin_q5*z_92 - 4318.0*cos_q5*z_93;
    const real z_95 = 2000.0*cos_q4 - z_94;
    const real z_96 = 2880.0*cos_q4 + c_0*z_95 - 43.0*z_94;
    const real z_97 = cos_q5*z_96;
    const real z_98 = cos_q5*z_92 + 4318.0*sin_q5*z_93;
    const real z_99 = 369656.0*cos_q4 + z_97 + z_98*z_26 - 354076.0*z_91;
    const real z_100 = sin_q3*sin_q4;
    const real z_101 = sin_q4*cos_q5;
    const real z_102 = sin_q4 - z_100;
    const real z_103 = 1000.0*z_101 + 2159.0*z_102;
    const real z_104 = 55533.0*sin_q4 + 288.0*z_101 + z_103*c_2 - 53975.0*z_100;
    const real z_105 = cos_q4*z_37 - sin_q3*z_51;
    const real z_106 = z_51 + z_105;
    const real z_107 = (z_92*z_54 - 4318.0*sin_q5*z_40) + 4318.0*(z_93*z_53 + cos_q5*z_106);
    const real z_108 = 2000.0*z_51 + z_107;
    const real z_109 = 2880.0*z_51 + c_0*z_108 + 43.0*z_107;
    const real z_110 = (z_92*z_53 + 4318.0*cos_q5*z_40) - 4318.0*(z_93*z_54 - sin_q5*z_106);
    const real z_111 = (z_96*z_53 + cos_q5*z_109) - c_1*(z_98*z_54 - sin_q5*z_110);
    const real z_112 = sin_q4*z_37 + sin_q3*z_43;
    const real z_113 = cos_q5*z_43 - sin_q4*z_53;
    const real z_114 = z_43 - z_112;
    const real z_115 = 1000.0*z_113 + 2159.0*z_114;
    const real z_116 = (z_96*z_54 - sin_q5*z_109) + c_1*(z_98*z_53 + cos_q5*z_110);
    const real c_9 = c[11];
    const real z_117 = 33885.0*z_101 + z_103*c_9 + 77724.0*z_102;
    const real z_118 = sin_q5*sin_q5;
    const real z_119 = sin_q4*z_118 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_101);
    const real z_120 = 33885.0*z_113 + z_115*c_9 + 77724.0*z_114;
    const real z_121 = cos_q5*z_53;
    const real z_122 = (2.0*sin_q4*z_121 + z_43*z_118) + (124307479.0/170000.0)*(z_43 +
        (621792.0/124307479.0)*z_113);
    const real z_123 = (((8.0*cos_q5*z_117 + z_103*c_4 + 170000.0*z_119 - 119895747.0*z_100)*z_43 +
        sin_q4*(z_115*c_4 + 170000.0*z_122 - 119895747.0*z_112 - 8.0*(z_117*z_53 - cos_q5*z_120))) -
        (1.0/10.0)*((845415424.0*cos_q4 + 2159.0*z_97 + z_95*c_5 + z_98*z_82 - 798087304.0*z_91 -
        1440.0*z_94)*z_51 + cos_q4*(845415424.0*z_51 + 798087304.0*z_105 + z_108*c_5 + 1440.0*z_107 +
        2159.0*z_111))) - (203.0/20.0)*(z_116 + (207264000.0/29.0)*(z_37 + (1189.0/24000.0)*z_40));
    Mdot1[1][1] = ((-1.0/10000000000.0))*(4318.0*((336000.0 + cos_q4*z_99 + 10.0*sin_q4*z_104 -
        2072640.0*sin_q3)*z_37 - sin_q3*(2072640.0*z_37 + (z_99*z_51 + cos_q4*(369656.0*z_51 + 354076.0*z_105 +
        z_111)) - 10.0*(z_104*z_43 + sin_q4*(55533.0*z_43 + 288.0*z_113 + z_115*c_2 - 53975.0*z_112)))) +
        4318.0*((2426716.0*cos_q3 + 16646.0 + z_98*z_89 - sin_q5*z_96)*z_40 + cos_q3*(2426716.0*z_40 + z_116)) -
        20.0*z_123);
    Mdot1[0][2] = Mdot1[2][0] = (1.0/20000000000.0)*(-10.0*z_90);
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/10000000000.0))*(-20.0*z_123);
    const real z_124 = 2159.0*sin_q4 + 1000.0*z_101;
    const real z_125 = 77724.0*sin_q4 + 33885.0*z_101 + z_124*c_9;
    const real z_126 = 2159.0*z_43 + 1000.0*z_113;
    const real z_127 = 77724.0*z_43 + 33885.0*z_113 + z_126*c_9;
    const real z_128 = sin_q5 - (4318.0/203.0)*z_63;
    const real z_129 = 203.0*z_128 - 2000.0*cos_q4;
    const real z_130 = c_0*z_129 + 8729.0*z_128 - 2880.0*cos_q4;
    const real z_131 = 203.0*cos_q5 + 4318.0*z_76;
    const real z_132 = z_54 + (4318.0/203.0)*(cos_q5*z_51 + cos_q4*z_53);
    const real z_133 = 2000.0*z_51 + 203.0*z_132;
    const real z_134 = 2880.0*z_51 + c_0*z_133 + 8729.0*z_132;
    const real z_135 = 203.0*z_53 - 4318.0*(cos_q4*z_54 - sin_q5*z_51);
    Mdot1[2][2] = (1.0/10000000000.0)*(20.0*((8.0*cos_q5*z_125 + z_124*c_4 + 170000.0*z_119)*z_43 +
        sin_q4*(z_126*c_4 + 170000.0*z_122 - 8.0*(z_125*z_53 - cos_q5*z_127))) + 2.0*((2159.0*cos_q5*z_130 +
        z_129*c_5 + 292320.0*z_128 - 845415424.0*cos_q4 - z_131*z_82)*z_51 - cos_q4*(845415424.0*z_51 + z_133*c_5
        + 292320.0*z_132 - 2159.0*(z_130*z_53 - cos_q5*z_134) - 2159.0*c_1*(z_131*z_54 - sin_q5*z_135))) +
        203.0*(z_130*z_54 + sin_q5*z_134) - 203.0*c_1*(z_131*z_53 + cos_q5*z_135));
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/62500000.0))*(81250.0*z_49 - z_78);
    const real z_136 = q5_dot*sin_q4;
    const real z_137 = sin_q5*z_43;
    const real z_138 = cos_q5*cos_q5*z_136 + cos_q5*z_137 - z_118*z_136;
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/62500000.0))*((z_117*z_54 + sin_q5*z_120) - 21250.0*z_138);
    Mdot1[2][3] = Mdot1[3][2] = (1.0/62500000.0)*(21250.0*z_138 - (z_125*z_54 + sin_q5*z_127));
    const real c_14 = c[16];
    Mdot1[3][3] = -c_14*z_121;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/62500000.0))*(40135.0*z_44 + z_57*c_3 + 27009.0*z_56);
    const real c_12 = c[14];
    Mdot1[1][4] = Mdot1[4][1] = ((-1.0/62500000.0))*(40135.0*z_51 + z_108*c_12 + 18.0*z_107);
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/62500000.0))*(40135.0*z_51 + z_133*c_12 + 3654.0*z_132);
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    Mdot1[0][5] = Mdot1[5][0] = ((-1.0/25000.0))*z_77;
    Mdot1[1][5] = Mdot1[5][1] = (1.0/25000.0)*(sin_q4*z_54 + z_137);
    Mdot1[2][5] = Mdot1[5][2] = (1.0/25000.0)*(sin_q4*z_54 + z_137);
    Mdot1[3][5] = Mdot1[5][3] = ((-1.0/25000.0))*z_53;
    Mdot1[4][5] = Mdot1[5][4] = em_real(0.0);
    Mdot1[5][5] = em_real(0.0);
    const real tau1 = u[0];
    f1[0] = tau1;
    const real tau2 = u[1];
    const real q1_dot = v[0];
    const real z_139 = q1_dot*q1_dot;
    const real z_140 = q1_dot*cos_q2;
    const real z_141 = q1_dot*sin_q2;
    const real z_142 = sin_q3*z_140 + cos_q3*z_141;
    const real z_143 = 350.0*z_142 - 2159.0*z_140;
    const real z_144 = 34.0*z_140 - 3.0*z_141;
    const real z_145 = q2_dot + q3_dot;
    const real z_146 = sin_q4*z_145 - cos_q4*z_142;
    const real z_147 = sin_q3*z_141 - cos_q3*z_140;
    const real z_148 = q2_dot*sin_q3;
    const real z_149 = 3001.0*z_147 - 8636.0*z_148;
    const real z_150 = 203.0*z_147 - 4318.0*z_140;
    const real z_151 = sin_q4*z_149 - 2.0*cos_q4*z_150;
    const real z_152 = 9016.0*z_146 + z_151;
    const real z_153 = 8636.0*z_146 + z_151;
    const real q6 = x[5];
    const real cos_q6 = em_cos(q6);
    const real z_155 = q4_dot - z_147;
    const real z_156 = cos_q5*z_146 - sin_q5*z_155;
    const real z_157 = cos_q4*z_145 + sin_q4*z_142;
    const real z_158 = q5_dot + z_157;
    const real sin_q6 = em_sin(q6);
    const real z_160 = z_156*cos_q6 + z_158*sin_q6;
    const real z_161 = cos_q4*z_149 + 2.0*sin_q4*z_150;
    const real z_162 = 8636.0*z_157 + z_161;
    const real z_163 = q2_dot*cos_q3;
    const real z_164 = 406.0*z_145 + 8636.0*z_163 - 3001.0*z_142;
    const real z_165 = cos_q5*z_162 - sin_q5*z_164;
    const real z_166 = cos_q6*z_153 + sin_q6*z_165;
    const real z_167 = 640.0*z_160 + z_166;
    const real z_168 = 4000.0*z_160 + z_166;
    const real z_169 = 9.0*z_167 + c_0*z_168;
    const real z_170 = z_156*sin_q6 - z_158*cos_q6;
    const real z_171 = cos_q6*z_165 - sin_q6*z_153;
    const real z_172 = 640.0*z_170 - z_171;
    const real z_173 = 4000.0*z_170 - z_171;
    const real z_174 = 9.0*z_172 + c_0*z_173;
    const real z_175 = 34.0*z_153 + cos_q6*z_169 + sin_q6*z_174;
    const real z_176 = 82.0*z_152 + z_175;
    const real z_177 = 9016.0*z_157 + z_161;
    const real z_178 = cos_q5*z_164 + sin_q5*z_162;
    const real z_179 = 34.0*z_165 + sin_q6*z_169 - cos_q6*z_174;
    const real z_180 = z_178*z_26 + cos_q5*z_179;
    const real z_181 = 82.0*z_177 + z_180;
    const real z_182 = cos_q4*z_176 - sin_q4*z_181;
    const real z_183 = 3283.0*z_142 - 8636.0*z_163;
    const real z_184 = 82.0*z_164 + z_178*z_89 - sin_q5*z_179;
    const real z_185 = 9375.0*z_170 + 9.0*z_172 + z_173*c_3;
    const real z_186 = 9375.0*z_160 + 9.0*z_167 + z_168*c_3;
    const real z_187 = 18750.0*z_156 + sin_q6*z_185 + cos_q6*z_186;
    const real q6_dot = v[5];
    const real z_188 = sin_q5*z_146 + cos_q5*z_155;
    const real z_189 = 2.0*(q6_dot + z_188) + 15.0*z_188;
    const real z_190 = 184828.0*z_152 + 2159.0*z_175 + 160.0*(112500.0*z_146 + cos_q5*z_187 +
        1250.0*sin_q5*z_189);
    const real z_191 = 18000000.0*z_157 + 184828.0*z_177 + 2159.0*z_180 + 160.0*(25000.0*z_158 + sin_q6*z_186 -
        cos_q6*z_185);
    const real z_192 = 2688000.0*z_143 + 1575840.0*z_183 + 4.0*(660000000.0*z_142 + sin_q4*z_191 - cos_q4*z_190) -
        3001.0*z_184;
    const real z_193 = q1_dot*sin_q3;
    const real z_194 = 3283.0*z_147 + 1400.0*z_145 - 8636.0*z_148;
    const real z_195 = sin_q4*z_176 + cos_q4*z_181;
    const real z_196 = 500000000.0*z_147 + 1575840.0*z_194 + 3001.0*z_195 - 406.0*z_182 - 640.0*(81250.0*z_155 +
        1250.0*cos_q5*z_189 - sin_q5*z_187);
    const real z_197 = q1_dot*cos_q3;
    const real c_15 = c[17];
    const real c_16 = c[18];
    const real z_198 = c_15 + cos_q5*c_16;
    const real c_17 = c[19];
    const real c_18 = c[20];
    const real z_199 = c_17 - z_76*c_18;
    const real c_19 = c[21];
    const real c_20 = c[22];
    f1[1] = (1.0/40000000000.0)*(40000000000.0*tau2 + (sin_q2*(4.0*q1_dot*(4145280.0*z_143 +
        19792500.0*(12.0*q2_dot - 455.0*z_140) - 23664000.0*z_144 - 2159.0*z_182) + z_196*z_197 +
        400000.0*cos_q3*z_198 + 200000.0*sin_q3*z_199 + c_19 - 20960000000.0*cos_q2*z_139 - z_192*z_193) -
        cos_q2*(174000.0*q1_dot*(48.0*z_144 + 455.0*(136.0*q2_dot - 455.0*z_141)) + 200000.0*cos_q3*z_199 + c_20 -
        5200000000.0*sin_q2*z_139 - z_192*z_197 - z_196*z_193 - 400000.0*sin_q3*z_198)));
    const real tau3 = u[2];
    f1[2] = (1.0/40000000000.0)*(40000000000.0*tau3 + (sin_q3*(8636.0*q2_dot*(480.0*z_183 - z_184) + z_140*z_196 +
        400000.0*cos_q2*z_198 + 200000.0*sin_q2*z_199 - z_141*z_192) - cos_q3*(8636.0*q2_dot*(480.0*z_194 + z_195)
        + 200000.0*cos_q2*z_199 - z_140*z_192 - z_141*z_196 - 400000.0*sin_q2*z_198)));
    const real tau4 = u[3];
    const real c_21 = c[23];
    f1[3] = (1.0/40000000000.0)*(40000000000.0*tau4 + (sin_q4*(2.0*z_150*z_176 + 4.0*z_142*z_190 - z_149*z_181 -
        4.0*z_145*z_191 - z_12*c_21) + cos_q4*(z_149*z_176 + 2.0*z_150*z_181 + 4.0*z_145*z_190 +
        4.0*z_142*z_191)));
    const real tau5 = u[4];
    const real z_200 = c_1*z_178;
    f1[4] = (1.0/40000000000.0)*(40000000000.0*tau5 - (sin_q5*(z_164*z_200 + z_162*z_179 + 640.0*z_146*z_187 +
        800000.0*z_155*z_189 + z_15*c_21) - cos_q5*(z_162*z_200 + 800000.0*z_146*z_189 + z_28*c_21 - z_164*z_179 -
        640.0*z_155*z_187)));
    const real tau6 = u[5];
    f1[5] = (1.0/40000000000.0)*(40000000000.0*tau6 + (cos_q6*(z_165*z_169 + z_153*z_174 + 640.0*z_156*z_185 +
        640.0*z_158*z_186) - sin_q6*(z_153*z_169 + 640.0*z_156*z_186 - z_165*z_174 - 640.0*z_158*z_185)));
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* q1, q2, q3, q4, q5, q6: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[6], y[7], y[8], y[9], y[10], y[11] };
    const real *const C1 = y + 12, *const s1 = y + 48;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* q1, q2, q3, q4, q5, q6: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[6], y[7], y[8], y[9], y[10], y[11] };
    const real *const C1 = y + 12, *const s1 = y + 48;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];

    real Mdot1[N1][N1], f1[N1];
    eigenfactor_motion(y, dy, c, u, Mdot1, f1);

    /* q1, q2, q3, q4, q5, q6: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 12, *const s1_dot = dy + 48;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

    /* etadot = a (45) */
    dy[6] = a1[0];
    dy[7] = a1[1];
    dy[8] = a1[2];
    dy[9] = a1[3];
    dy[10] = a1[4];
    dy[11] = a1[5];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[56])
{
    const real q2 = x[1];
    const real sin_q2 = em_sin(q2);
    const real cos_q2 = em_cos(q2);
    const real q3 = x[2];
    const real sin_q3 = em_sin(q3);
    const real z_3 = cos_q2*sin_q3;
    const real cos_q3 = em_cos(q3);
    const real z_5 = sin_q2*cos_q3;
    const real z_6 = z_3 + z_5;
    const real q4 = x[3];
    const real sin_q4 = em_sin(q4);
    const real z_8 = z_6*sin_q4;
    const real q5 = x[4];
    const real cos_q5 = em_cos(q5);
    const real sin_q5 = em_sin(q5);
    const real z_11 = z_6*sin_q5;
    const real z_12 = sin_q2*sin_q3;
    const real z_13 = cos_q2*cos_q3;
    const real z_14 = z_12 - z_13;
    const real z_15 = 4318.0*cos_q2 - 203.0*z_14;
    const real cos_q4 = em_cos(q4);
    const real z_17 = sin_q4*z_15 - 1500.5*z_14*cos_q4;
    const real z_18 = 8636.0*z_8 - 2.0*z_17;
    const real z_19 = z_11 + (1.0/3001.0)*z_18*cos_q5;
    const real z_20 = 4000.0*z_8 + 3001.0*z_19;
    const real c_0 = c[2];
    const real z_21 = 5760.0*z_8 + z_20*c_0 + 129043.0*z_19;
    const real z_22 = cos_q5*z_21;
    const real z_23 = z_6*cos_q5;
    const real z_24 = sin_q5*z_18 - 3001.0*z_23;
    const real c_1 = c[3];
    const real z_25 = sin_q5*c_1;
    const real z_26 = 739312.0*z_8 + z_22 + z_24*z_25 - 164.0*z_17;
    const real z_27 = z_6*cos_q4;
    const real z_28 = sin_q5*z_14 - cos_q5*z_27;
    const real z_29 = sin_q4*z_14 + (2.0/3001.0)*z_15*cos_q4;
    const real z_30 = z_27 - (3001.0/8636.0)*z_29;
    const real z_31 = 8636.0*z_30 - 4000.0*z_28;
    const real c_2 = c[4];
    const real z_32 = 222132.0*z_27 + z_31*c_2 - 75025.0*z_29 - 1152.0*z_28;
    const real z_33 = sin_q4*z_26 + 5.0*cos_q4*z_32;
    const real z_34 = 70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_33 - 18759823020.0*cos_q2;
    const real z_35 = 207169.0*sin_q2 - 1632.0*cos_q2;
    const real z_36 = sin_q4*z_32 - (1.0/5.0)*cos_q4*z_26;
    const real c_3 = c[5];
    const real z_37 = z_31*c_3 + 77724.0*z_30 - 33885.0*z_28;
    const real z_38 = z_14*cos_q5 + sin_q5*z_27;
    const real z_39 = sin_q5*z_37 - 21250.0*cos_q5*z_38;
    const real z_40 = 5725482720.0*z_14 + 406.0*z_33 - 15005.0*z_36 - 640.0*z_39;
    const real z_41 = sin_q5*z_21;
    const real c_4 = c[6];
    const real z_42 = 497229916.0*z_27 + 32.0*cos_q5*z_37 + 680000.0*sin_q5*z_38 + z_31*c_4 - 166654533.0*z_29 -
        2487168.0*z_28;
    const real c_5 = c[7];
    const real c_6 = c[8];
    const real z_43 = sin_q5*c_6;
    const real z_44 = 1690830848.0*z_8 + 2159.0*z_22 + z_20*c_5 + z_24*z_43 + 4321440.0*z_19 - 369656.0*z_17;
    const real c_7 = c[9];
    const real z_45 = cos_q5*z_24;
    const real z_46 = 5803392000.0*cos_q2 + c_7*z_45 - 9492774802.0*z_6 - 3001.0*z_41 - 20.0*cos_q4*z_42 -
        4.0*sin_q4*z_44;
    M1[0][0] = (1.0/1000000000000.0)*(130000000000.0*sin_q2*sin_q2 + 524000000000.0*cos_q2*cos_q2 +
        4350000.0*sin_q2*z_35 + 25.0*z_12*z_40 + 1134029968642.0 - 100.0*cos_q2*z_34 - 25.0*z_3*z_46 -
        25.0*z_5*z_46 - 25.0*z_13*z_40);
    const real z_47 = cos_q5*c_1;
    const real z_48 = 1821922.0*z_6 + z_41 - z_24*z_47;
    const real z_49 = 1575840.0*z_14 - 5.0*z_36;
    const real c_8 = c[10];
    const real z_50 = (cos_q4*z_44 + 0.5*c_8*z_45) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_14) +
        (1.0/246082.0)*(z_41 + (10.0/203.0)*sin_q4*z_42));
    M1[1][0] = ((-1.0/20000000000.0))*(5383560000.0*sin_q2 + 475020000.0*cos_q2 + 4318.0*cos_q3*z_48 +
        4318.0*sin_q3*z_49 - 2.0*z_50);
    const real z_51 = sin_q3*cos_q4;
    const real z_52 = 4318.0*cos_q3 + 203.0;
    const real z_53 = cos_q4 - z_51;
    const real z_54 = sin_q5*z_52 - 4318.0*cos_q5*z_53;
    const real z_55 = 2000.0*cos_q4 - z_54;
    const real z_56 = 2880.0*cos_q4 + c_0*z_55 - 43.0*z_54;
    const real z_57 = cos_q5*z_56;
    const real z_58 = cos_q5*z_52 + 4318.0*sin_q5*z_53;
    const real z_59 = 369656.0*cos_q4 + z_57 + z_58*z_25 - 354076.0*z_51;
    const real z_60 = sin_q3*sin_q4;
    const real z_61 = sin_q4*cos_q5;
    const real z_62 = sin_q4 - z_60;
    const real z_63 = 1000.0*z_61 + 2159.0*z_62;
    const real z_64 = 55533.0*sin_q4 + 288.0*z_61 + z_63*c_2 - 53975.0*z_60;
    const real z_65 = 336000.0 + cos_q4*z_59 + 10.0*sin_q4*z_64 - 2072640.0*sin_q3;
    const real z_66 = sin_q5*z_56;
    const real z_67 = 2426716.0*cos_q3 + 16646.0 + z_58*z_47 - z_66;
    const real z_68 = 845415424.0*cos_q4 + 2159.0*z_57 + z_55*c_5 + z_58*z_43 - 798087304.0*z_51 - 1440.0*z_54;
    const real c_9 = c[11];
    const real z_69 = 33885.0*z_61 + z_63*c_9 + 77724.0*z_62;
    const real z_70 = sin_q5*sin_q5;
    const real z_71 = sin_q4*z_70 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_61);
    const real z_72 = 8.0*cos_q5*z_69 + z_63*c_4 + 170000.0*z_71 - 119895747.0*z_60;
    const real z_73 = (cos_q4*z_68 + 0.5*cos_q5*z_58*c_8) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_66 - (20.0/203.0)*sin_q4*z_72));
    M1[1][1] = (1.0/10000000000.0)*(4318.0*cos_q3*z_67 + 30547567588.0 + 2.0*z_73 - 4318.0*sin_q3*z_65);
    M1[2][0] = ((-1.0/20000000000.0))*(-2.0*z_50);
    M1[2][1] = (1.0/10000000000.0)*(1098579138.0 + 2.0*z_73);
    const real z_74 = 2159.0*sin_q4 + 1000.0*z_61;
    const real z_75 = 77724.0*sin_q4 + 33885.0*z_61 + z_74*c_9;
    const real z_76 = 8.0*cos_q5*z_75 + z_74*c_4 + 170000.0*z_71;
    const real z_77 = cos_q4*cos_q5;
    const real z_78 = sin_q5 - (4318.0/203.0)*z_77;
    const real z_79 = 203.0*z_78 - 2000.0*cos_q4;
    const real z_80 = c_0*z_79 + 8729.0*z_78 - 2880.0*cos_q4;
    const real z_81 = sin_q5*cos_q4;
    const real z_82 = 203.0*cos_q5 + 4318.0*z_81;
    const real z_83 = 2159.0*cos_q5*z_80 + z_79*c_5 + 292320.0*z_78 - 845415424.0*cos_q4 - z_82*z_43;
    const real c_10 = c[12];
    M1[2][2] = (1.0/500000000000.0)*(1000.0*sin_q4*z_76 + 10150.0*sin_q5*z_80 + 343365622869.0 + cos_q5*z_82*c_10
        - 100.0*cos_q4*z_83);
    M1[3][0] = ((-1.0/62500000.0))*(81250.0*z_14 - z_39);
    const real z_84 = sin_q5*z_61;
    M1[3][1] = ((-1.0/62500000.0))*(sin_q5*z_69 - 21250.0*z_84);
    M1[3][2] = (1.0/62500000.0)*(21250.0*z_84 - sin_q5*z_75);
    const real z_85 = cos_q5*cos_q5;
    const real c_11 = c[13];
    M1[3][3] = (1.0/6250000000000.0)*(2125000000.0*z_85 + 1200566413273.0 + c_11*z_70);
    M1[4][0] = (1.0/62500000.0)*(40135.0*z_8 + z_20*c_3 + 27009.0*z_19);
    const real c_12 = c[14];
    M1[4][1] = (1.0/62500000.0)*(40135.0*cos_q4 + z_55*c_12 - 18.0*z_54);
    M1[4][2] = ((-1.0/62500000.0))*(z_79*c_12 + 3654.0*z_78 - 40135.0*cos_q4);
    M1[4][3] = em_real(0.0);
    const real c_13 = c[15];
    M1[4][4] = c_13;
    M1[5][0] = ((-1.0/25000.0))*z_38;
    M1[5][1] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[5][2] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[5][3] = (1.0/25000.0)*cos_q5;
    M1[5][4] = em_real(0.0);
    M1[5][5] = em_real(48526126417.0/250000000000.0);
    shared[0] = cos_q2;
    shared[1] = sin_q2;
    shared[2] = z_34;
    shared[3] = sin_q3;
    shared[4] = cos_q3;
    shared[5] = z_26;
    shared[6] = cos_q4;
    shared[7] = sin_q4;
    shared[8] = z_6;
    shared[9] = z_15;
    shared[10] = z_14;
    shared[11] = z_21;
    shared[12] = sin_q5;
    shared[13] = cos_q5;
    shared[14] = z_18;
    shared[15] = z_24;
    shared[16] = z_32;
    shared[17] = z_77;
    shared[18] = z_23;
    shared[19] = z_27;
    shared[20] = z_35;
    shared[21] = z_40;
    shared[22] = z_12;
    shared[23] = z_37;
    shared[24] = z_38;
    shared[25] = z_81;
    shared[26] = z_11;
    shared[27] = z_46;
    shared[28] = z_3;
    shared[29] = z_42;
    shared[30] = z_44;
    shared[31] = z_5;
    shared[32] = z_13;
    shared[33] = z_48;
    shared[34] = z_49;
    shared[35] = z_65;
    shared[36] = z_59;
    shared[37] = z_56;
    shared[38] = z_52;
    shared[39] = z_53;
    shared[40] = z_58;
    shared[41] = z_64;
    shared[42] = z_67;
    shared[43] = z_72;
    shared[44] = z_69;
    shared[45] = z_61;
    shared[46] = z_70;
    shared[47] = z_68;
    shared[48] = z_76;
    shared[49] = z_75;
    shared[50] = z_83;
    shared[51] = z_80;
    shared[52] = z_82;
    shared[53] = z_85;
    shared[54] = z_25;
    shared[55] = z_47;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real *restrict u, const real shared[56], real Mdot1[N1][N1],
                                 real f1[N1])
{
    const real cos_q2 = shared[0];
    const real q2_dot = v[1];
    const real sin_q2 = shared[1];
    const real z_86 = q2_dot*sin_q2;
    const real z_34 = shared[2];
    const real z_87 = q2_dot*cos_q2;
    const real sin_q3 = shared[3];
    const real z_88 = sin_q3*z_86;
    const real q3_dot = v[2];
    const real cos_q3 = shared[4];
    const real z_89 = q3_dot*cos_q3;
    const real z_90 = cos_q2*z_89;
    const real z_91 = cos_q3*z_87;
    const real z_92 = q3_dot*sin_q3;
    const real z_93 = sin_q2*z_92;
    const real z_94 = (z_88 - z_90) - (z_91 - z_93);
    const real z_26 = shared[5];
    const real q4_dot = v[3];
    const real cos_q4 = shared[6];
    const real z_95 = q4_dot*cos_q4;
    const real sin_q4 = shared[7];
    const real z_6 = shared[8];
    const real z_96 = sin_q4*z_94 - z_6*z_95;
    const real z_15 = shared[9];
    const real z_97 = sin_q3*z_87;
    const real z_98 = sin_q2*z_89;
    const real z_99 = cos_q3*z_86;
    const real z_100 = cos_q2*z_92;
    const real z_101 = (z_97 + z_98) + (z_99 + z_100);
    const real z_102 = 4318.0*z_86 + 203.0*z_101;
    const real z_14 = shared[10];
    const real z_103 = q4_dot*sin_q4;
    const real z_104 = (z_15*z_95 - sin_q4*z_102) - 1500.5*(cos_q4*z_101 - z_14*z_103);
    const real z_21 = shared[11];
    const real q5_dot = v[4];
    const real sin_q5 = shared[12];
    const real z_105 = q5_dot*sin_q5;
    const real cos_q5 = shared[13];
    const real c_0 = c[2];
    const real z_106 = q5_dot*cos_q5;
    const real z_107 = 8636.0*z_96 + 2.0*z_104;
    const real z_18 = shared[14];
    const real z_108 = (sin_q5*z_94 - z_6*z_106) + (1.0/3001.0)*(cos_q5*z_107 + z_18*z_105);
    const real z_109 = 4000.0*z_96 + 3001.0*z_108;
    const real z_110 = 5760.0*z_96 + c_0*z_109 + 129043.0*z_108;
    const real c_1 = c[3];
    const real z_24 = shared[15];
    const real z_111 = (z_18*z_106 - sin_q5*z_107) + 3001.0*(cos_q5*z_94 + z_6*z_105);
    const real z_112 = (z_21*z_105 + cos_q5*z_110) - c_1*(z_24*z_106 + sin_q5*z_111);
    const real z_113 = 739312.0*z_96 + 164.0*z_104 + z_112;
    const real z_32 = shared[16];
    const real z_114 = cos_q4*z_94 + z_6*z_103;
    const real z_77 = shared[17];
    const real z_23 = shared[18];
    const real z_27 = shared[19];
    const real z_115 = (z_14*z_106 + sin_q5*z_101) + (z_77*z_94 + z_23*z_103 + z_27*z_105);
    const real z_116 = (z_14*z_95 + sin_q4*z_101) - (2.0/3001.0)*(cos_q4*z_102 + z_15*z_103);
    const real z_117 = z_114 + (3001.0/8636.0)*z_116;
    const real z_118 = 4000.0*z_115 + 8636.0*z_117;
    const real c_2 = c[4];
    const real z_119 = 222132.0*z_114 + z_118*c_2 + 75025.0*z_116 + 1152.0*z_115;
    const real z_120 = (z_26*z_95 - sin_q4*z_113) - 5.0*(z_32*z_103 + cos_q4*z_119);
    const real z_35 = shared[20];
    const real z_40 = shared[21];
    const real z_12 = shared[22];
    const real z_121 = (z_32*z_95 - sin_q4*z_119) + (1.0/5.0)*(z_26*z_103 + cos_q4*z_113);
    const real z_37 = shared[23];
    const real c_3 = c[5];
    const real z_122 = z_118*c_3 + 33885.0*z_115 + 77724.0*z_117;
    const real z_38 = shared[24];
    const real z_81 = shared[25];
    const real z_11 = shared[26];
    const real z_123 = (cos_q5*z_101 - z_14*z_105) - (z_81*z_94 + z_11*z_103 - z_27*z_106);
    const real z_124 = (z_37*z_106 - sin_q5*z_122) + 21250.0*(z_38*z_105 - cos_q5*z_123);
    const real z_125 = 5725482720.0*z_101 + 406.0*z_120 - 15005.0*z_121 - 640.0*z_124;
    const real z_46 = shared[27];
    const real z_3 = shared[28];
    const real z_42 = shared[29];
    const real c_4 = c[6];
    const real z_126 = 497229916.0*z_114 + 32.0*(z_37*z_105 + cos_q5*z_122) + z_118*c_4 + 166654533.0*z_116 +
        2487168.0*z_115 - 680000.0*(z_38*z_106 + sin_q5*z_123);
    const real z_44 = shared[30];
    const real c_5 = c[7];
    const real z_127 = 1690830848.0*z_96 + z_109*c_5 + 4321440.0*z_108 + 369656.0*z_104 + 2159.0*z_112;
    const real z_128 = (z_21*z_106 - sin_q5*z_110) + c_1*(z_24*z_105 - cos_q5*z_111);
    const real z_129 = 5803392000.0*z_86 + 4.0*(z_44*z_95 - sin_q4*z_127) + 3001.0*z_128 - 9492774802.0*z_94 -
        20.0*(z_42*z_103 + cos_q4*z_126);
    const real z_5 = shared[31];
    const real z_13 = shared[32];
    Mdot1[0][0] = ((-1.0/40000000000.0))*(31520000000.0*cos_q2*z_86 + (z_46*z_91 - z_46*z_93 - z_5*z_129) -
        4.0*(z_34*z_86 - cos_q2*(70992000.0*z_87 + 18759823020.0*z_86 + 2159.0*z_120 - 1450848000.0*z_94)) -
        174000.0*(z_35*z_87 + sin_q2*(207169.0*z_87 + 1632.0*z_86)) - (z_40*z_97 + z_40*z_98 + z_12*z_125) -
        (z_46*z_88 + z_3*z_129 - z_46*z_90) - (z_40*z_99 + z_40*z_100 - z_13*z_125));
    const real z_48 = shared[33];
    const real z_49 = shared[34];
    const real z_130 = ((z_42*z_95 - sin_q4*z_126) + (1.0/5.0)*(z_44*z_103 + cos_q4*z_127)) + (203.0/10.0)*(z_128
        - 246082.0*(z_94 + (78792000.0/3568189.0)*z_101));
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/20000000000.0))*(5383560000.0*z_87 + 4318.0*(z_49*z_89 +
        sin_q3*(1575840.0*z_101 - 5.0*z_121)) + 10.0*z_130 - 475020000.0*z_86 - 4318.0*(z_48*z_92 +
        cos_q3*(1821922.0*z_94 - z_128)));
    const real z_65 = shared[35];
    const real z_59 = shared[36];
    const real z_131 = cos_q4*z_89 - sin_q3*z_103;
    const real z_56 = shared[37];
    const real z_52 = shared[38];
    const real z_53 = shared[39];
    const real z_132 = z_103 + z_131;
    const real z_133 = (z_52*z_106 - 4318.0*sin_q5*z_92) + 4318.0*(z_53*z_105 + cos_q5*z_132);
    const real z_134 = 2000.0*z_103 + z_133;
    const real z_135 = 2880.0*z_103 + c_0*z_134 + 43.0*z_133;
    const real z_58 = shared[40];
    const real z_136 = (z_52*z_105 + 4318.0*cos_q5*z_92) - 4318.0*(z_53*z_106 - sin_q5*z_132);
    const real z_137 = (z_56*z_105 + cos_q5*z_135) - c_1*(z_58*z_106 - sin_q5*z_136);
    const real z_64 = shared[41];
    const real z_138 = sin_q4*z_89 + sin_q3*z_95;
    const real z_139 = cos_q5*z_95 - sin_q4*z_105;
    const real z_140 = z_95 - z_138;
    const real z_141 = 1000.0*z_139 + 2159.0*z_140;
    const real z_67 = shared[42];
    const real z_142 = (z_56*z_106 - sin_q5*z_135) + c_1*(z_58*z_105 + cos_q5*z_136);
    const real z_72 = shared[43];
    const real z_69 = shared[44];
    const real c_9 = c[11];
    const real z_143 = 33885.0*z_139 + z_141*c_9 + 77724.0*z_140;
    const real z_61 = shared[45];
    const real z_70 = shared[46];
    const real z_144 = (2.0*z_61*z_105 + z_95*z_70) + (124307479.0/170000.0)*(z_95 +
        (621792.0/124307479.0)*z_139);
    const real z_68 = shared[47];
    const real z_145 = ((z_72*z_95 + sin_q4*(z_141*c_4 + 170000.0*z_144 - 119895747.0*z_138 - 8.0*(z_69*z_105 -
        cos_q5*z_143))) - (1.0/10.0)*(z_68*z_103 + cos_q4*(845415424.0*z_103 + 798087304.0*z_131 + z_134*c_5 +
        1440.0*z_133 + 2159.0*z_137))) - (203.0/20.0)*(z_142 + (207264000.0/29.0)*(z_89 + (1189.0/24000.0)*z_92));
    Mdot1[1][1] = ((-1.0/10000000000.0))*(4318.0*(z_65*z_89 - sin_q3*(2072640.0*z_89 + (z_59*z_103 +
        cos_q4*(369656.0*z_103 + 354076.0*z_131 + z_137)) - 10.0*(z_64*z_95 + sin_q4*(55533.0*z_95 + 288.0*z_139 +
        z_141*c_2 - 53975.0*z_138)))) + 4318.0*(z_67*z_92 + cos_q3*(2426716.0*z_92 + z_142)) - 20.0*z_145);
    Mdot1[0][2] = Mdot1[2][0] = (1.0/20000000000.0)*(-10.0*z_130);
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/10000000000.0))*(-20.0*z_145);
    const real z_76 = shared[48];
    const real z_75 = shared[49];
    const real z_146 = 2159.0*z_95 + 1000.0*z_139;
    const real z_147 = 77724.0*z_95 + 33885.0*z_139 + z_146*c_9;
    const real z_83 = shared[50];
    const real z_80 = shared[51];
    const real z_148 = z_106 + (4318.0/203.0)*(cos_q5*z_103 + cos_q4*z_105);
    const real z_149 = 2000.0*z_103 + 203.0*z_148;
    const real z_150 = 2880.0*z_103 + c_0*z_149 + 8729.0*z_148;
    const real z_82 = shared[52];
    const real z_151 = 203.0*z_105 - 4318.0*(cos_q4*z_106 - sin_q5*z_103);
    Mdot1[2][2] = (1.0/10000000000.0)*(20.0*(z_76*z_95 + sin_q4*(z_146*c_4 + 170000.0*z_144 - 8.0*(z_75*z_105 -
        cos_q5*z_147))) + 2.0*(z_83*z_103 - cos_q4*(845415424.0*z_103 + z_149*c_5 + 292320.0*z_148 -
        2159.0*(z_80*z_105 - cos_q5*z_150) - 2159.0*c_1*(z_82*z_106 - sin_q5*z_151))) + 203.0*(z_80*z_106 +
        sin_q5*z_150) - 203.0*c_1*(z_82*z_105 + cos_q5*z_151));
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/62500000.0))*(81250.0*z_101 - z_124);
    const real z_85 = shared[53];
    const real z_152 = q5_dot*sin_q4;
    const real z_153 = sin_q5*z_95;
    const real z_154 = z_85*z_152 + cos_q5*z_153 - z_70*z_152;
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/62500000.0))*((z_69*z_106 + sin_q5*z_143) - 21250.0*z_154);
    Mdot1[2][3] = Mdot1[3][2] = (1.0/62500000.0)*(21250.0*z_154 - (z_75*z_106 + sin_q5*z_147));
    const real c_14 = c[16];
    Mdot1[3][3] = -c_14*(cos_q5*z_105);
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/62500000.0))*(40135.0*z_96 + z_109*c_3 + 27009.0*z_108);
    const real c_12 = c[14];
    Mdot1[1][4] = Mdot1[4][1] = ((-1.0/62500000.0))*(40135.0*z_103 + z_134*c_12 + 18.0*z_133);
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/62500000.0))*(40135.0*z_103 + z_149*c_12 + 3654.0*z_148);
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    Mdot1[0][5] = Mdot1[5][0] = ((-1.0/25000.0))*z_123;
    Mdot1[1][5] = Mdot1[5][1] = (1.0/25000.0)*(sin_q4*z_106 + z_153);
    Mdot1[2][5] = Mdot1[5][2] = (1.0/25000.0)*(sin_q4*z_106 + z_153);
    Mdot1[3][5] = Mdot1[5][3] = ((-1.0/25000.0))*z_105;
    Mdot1[4][5] = Mdot1[5][4] = em_real(0.0);
    Mdot1[5][5] = em_real(0.0);
    const real tau1 = u[0];
    f1[0] = tau1;
    const real tau2 = u[1];
    const real q1_dot = v[0];
    const real z_155 = q1_dot*q1_dot;
    const real z_156 = q1_dot*cos_q2;
    const real z_157 = q1_dot*sin_q2;
    const real z_158 = sin_q3*z_156 + cos_q3*z_157;
    const real z_159 = 350.0*z_158 - 2159.0*z_156;
    const real z_160 = 34.0*z_156 - 3.0*z_157;
    const real z_161 = q2_dot + q3_dot;
    const real z_162 = sin_q4*z_161 - cos_q4*z_158;
    const real z_163 = sin_q3*z_157 - cos_q3*z_156;
    const real z_164 = q2_dot*sin_q3;
    const real z_165 = 3001.0*z_163 - 8636.0*z_164;
    const real z_166 = 203.0*z_163 - 4318.0*z_156;
    const real z_167 = sin_q4*z_165 - 2.0*cos_q4*z_166;
    const real z_168 = 9016.0*z_162 + z_167;
    const real z_169 = 8636.0*z_162 + z_167;
    const real q6 = x[5];
    const real cos_q6 = em_cos(q6);
    const real z_171 = q4_dot - z_163;
    const real z_172 = cos_q5*z_162 - sin_q5*z_171;
    const real z_173 = cos_q4*z_161 + sin_q4*z_158;
    const real z_174 = q5_dot + z_173;
    const real sin_q6 = em_sin(q6);
    const real z_176 = z_172*cos_q6 + z_174*sin_q6;
    const real z_177 = cos_q4*z_165 + 2.0*sin_q4*z_166;
    const real z_178 = 8636.0*z_173 + z_177;
    const real z_179 = q2_dot*cos_q3;
    const real z_180 = 406.0*z_161 + 8636.0*z_179 - 3001.0*z_158;
    const real z_181 = cos_q5*z_178 - sin_q5*z_180;
    const real z_182 = cos_q6*z_169 + sin_q6*z_181;
    const real z_183 = 640.0*z_176 + z_182;
    const real z_184 = 4000.0*z_176 + z_182;
    const real z_185 = 9.0*z_183 + c_0*z_184;
    const real z_186 = z_172*sin_q6 - z_174*cos_q6;
    const real z_187 = cos_q6*z_181 - sin_q6*z_169;
    const real z_188 = 640.0*z_186 - z_187;
    const real z_189 = 4000.0*z_186 - z_187;
    const real z_190 = 9.0*z_188 + c_0*z_189;
    const real z_191 = 34.0*z_169 + cos_q6*z_185 + sin_q6*z_190;
    const real z_192 = 82.0*z_168 + z_191;
    const real z_193 = 9016.0*z_173 + z_177;
    const real z_194 = cos_q5*z_180 + sin_q5*z_178;
    const real z_25 = shared[54];
    const real z_195 = 34.0*z_181 + sin_q6*z_185 - cos_q6*z_190;
    const real z_196 = z_194*z_25 + cos_q5*z_195;
    const real z_197 = 82.0*z_193 + z_196;
    const real z_198 = cos_q4*z_192 - sin_q4*z_197;
    const real z_199 = 3283.0*z_158 - 8636.0*z_179;
    const real z_47 = shared[55];
    const real z_200 = 82.0*z_180 + z_194*z_47 - sin_q5*z_195;
    const real z_201 = 9375.0*z_186 + 9.0*z_188 + z_189*c_3;
    const real z_202 = 9375.0*z_176 + 9.0*z_183 + z_184*c_3;
    const real z_203 = 18750.0*z_172 + sin_q6*z_201 + cos_q6*z_202;
    const real q6_dot = v[5];
    const real z_204 = sin_q5*z_162 + cos_q5*z_171;
    const real z_205 = 2.0*(q6_dot + z_204) + 15.0*z_204;
    const real z_206 = 184828.0*z_168 + 2159.0*z_191 + 160.0*(112500.0*z_162 + cos_q5*z_203 +
        1250.0*sin_q5*z_205);
    const real z_207 = 18000000.0*z_173 + 184828.0*z_193 + 2159.0*z_196 + 160.0*(25000.0*z_174 + sin_q6*z_202 -
        cos_q6*z_201);
    const real z_208 = 2688000.0*z_159 + 1575840.0*z_199 + 4.0*(660000000.0*z_158 + sin_q4*z_207 - cos_q4*z_206) -
        3001.0*z_200;
    const real z_209 = q1_dot*sin_q3;
    const real z_210 = 3283.0*z_163 + 1400.0*z_161 - 8636.0*z_164;
    const real z_211 = sin_q4*z_192 + cos_q4*z_197;
    const real z_212 = 500000000.0*z_163 + 1575840.0*z_210 + 3001.0*z_211 - 406.0*z_198 - 640.0*(81250.0*z_171 +
        1250.0*cos_q5*z_205 - sin_q5*z_203);
    const real z_213 = q1_dot*cos_q3;
    const real c_15 = c[17];
    const real c_16 = c[18];
    const real z_214 = c_15 + cos_q5*c_16;
    const real c_17 = c[19];
    const real c_18 = c[20];
    const real z_215 = c_17 - z_81*c_18;
    const real c_19 = c[21];
    const real c_20 = c[22];
    f1[1] = (1.0/40000000000.0)*(40000000000.0*tau2 + (sin_q2*(4.0*q1_dot*(4145280.0*z_159 +
        19792500.0*(12.0*q2_dot - 455.0*z_156) - 23664000.0*z_160 - 2159.0*z_198) + z_212*z_213 +
        400000.0*cos_q3*z_214 + 200000.0*sin_q3*z_215 + c_19 - 20960000000.0*cos_q2*z_155 - z_208*z_209) -
        cos_q2*(174000.0*q1_dot*(48.0*z_160 + 455.0*(136.0*q2_dot - 455.0*z_157)) + 200000.0*cos_q3*z_215 + c_20 -
        5200000000.0*sin_q2*z_155 - z_208*z_213 - z_212*z_209 - 400000.0*sin_q3*z_214)));
    const real tau3 = u[2];
    f1[2] = (1.0/40000000000.0)*(40000000000.0*tau3 + (sin_q3*(8636.0*q2_dot*(480.0*z_199 - z_200) + z_156*z_212 +
        400000.0*cos_q2*z_214 + 200000.0*sin_q2*z_215 - z_157*z_208) - cos_q3*(8636.0*q2_dot*(480.0*z_210 + z_211)
        + 200000.0*cos_q2*z_215 - z_156*z_208 - z_157*z_212 - 400000.0*sin_q2*z_214)));
    const real tau4 = u[3];
    const real c_21 = c[23];
    f1[3] = (1.0/40000000000.0)*(40000000000.0*tau4 + (sin_q4*(2.0*z_166*z_192 + 4.0*z_158*z_206 - z_165*z_197 -
        4.0*z_161*z_207 - z_11*c_21) + cos_q4*(z_165*z_192 + 2.0*z_166*z_197 + 4.0*z_161*z_206 +
        4.0*z_158*z_207)));
    const real tau5 = u[4];
    const real z_216 = c_1*z_194;
    f1[4] = (1.0/40000000000.0)*(40000000000.0*tau5 - (sin_q5*(z_180*z_216 + z_178*z_195 + 640.0*z_162*z_203 +
        800000.0*z_171*z_205 + z_14*c_21) - cos_q5*(z_178*z_216 + 800000.0*z_162*z_205 + z_27*c_21 - z_180*z_195 -
        640.0*z_171*z_203)));
    const real tau6 = u[5];
    f1[5] = (1.0/40000000000.0)*(40000000000.0*tau6 + (cos_q6*(z_181*z_185 + z_169*z_190 + 640.0*z_172*z_201 +
        640.0*z_174*z_202) - sin_q6*(z_169*z_185 + 640.0*z_172*z_202 - z_181*z_190 - 640.0*z_174*z_201)));
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[56];
    triangular_masses(y, c, M1, shared);

    /* q1, q2, q3, q4, q5, q6: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[6], y[7], y[8], y[9], y[10], y[11] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];

    real Mdot1[N1][N1], f1[N1];
    triangular_motion(y, dy, c, u, shared, Mdot1, f1);

    /* q1, q2, q3, q4, q5, q6: a = L^-1 f - Phi eta */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* etadot = a (45) */
    dy[6] = a1[0];
    dy[7] = a1[1];
    dy[8] = a1[2];
    dy[9] = a1[3];
    dy[10] = a1[4];
    dy[11] = a1[5];
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
                              real shared[50])
{
    const real q2 = x[1];
    const real sin_q2 = em_sin(q2);
    const real cos_q2 = em_cos(q2);
    const real q3 = x[2];
    const real sin_q3 = em_sin(q3);
    const real z_3 = cos_q2*sin_q3;
    const real cos_q3 = em_cos(q3);
    const real z_5 = sin_q2*cos_q3;
    const real z_6 = z_3 + z_5;
    const real q4 = x[3];
    const real sin_q4 = em_sin(q4);
    const real z_8 = z_6*sin_q4;
    const real q5 = x[4];
    const real cos_q5 = em_cos(q5);
    const real sin_q5 = em_sin(q5);
    const real z_11 = sin_q2*sin_q3;
    const real z_12 = cos_q2*cos_q3;
    const real z_13 = z_11 - z_12;
    const real z_14 = 4318.0*cos_q2 - 203.0*z_13;
    const real cos_q4 = em_cos(q4);
    const real z_16 = sin_q4*z_14 - 1500.5*z_13*cos_q4;
    const real z_17 = 8636.0*z_8 - 2.0*z_16;
    const real z_18 = z_6*sin_q5 + (1.0/3001.0)*z_17*cos_q5;
    const real z_19 = 4000.0*z_8 + 3001.0*z_18;
    const real c_0 = c[2];
    const real z_20 = 5760.0*z_8 + z_19*c_0 + 129043.0*z_18;
    const real z_21 = cos_q5*z_20;
    const real z_22 = sin_q5*z_17 - 3001.0*z_6*cos_q5;
    const real c_1 = c[3];
    const real z_23 = sin_q5*c_1;
    const real z_24 = 739312.0*z_8 + z_21 + z_22*z_23 - 164.0*z_16;
    const real z_25 = z_6*cos_q4;
    const real z_26 = sin_q5*z_13 - cos_q5*z_25;
    const real z_27 = sin_q4*z_13 + (2.0/3001.0)*z_14*cos_q4;
    const real z_28 = z_25 - (3001.0/8636.0)*z_27;
    const real z_29 = 8636.0*z_28 - 4000.0*z_26;
    const real c_2 = c[4];
    const real z_30 = 222132.0*z_25 + z_29*c_2 - 75025.0*z_27 - 1152.0*z_26;
    const real z_31 = sin_q4*z_24 + 5.0*cos_q4*z_30;
    const real z_32 = 70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_31 - 18759823020.0*cos_q2;
    const real z_33 = 207169.0*sin_q2 - 1632.0*cos_q2;
    const real z_34 = sin_q4*z_30 - (1.0/5.0)*cos_q4*z_24;
    const real c_3 = c[5];
    const real z_35 = z_29*c_3 + 77724.0*z_28 - 33885.0*z_26;
    const real z_36 = z_13*cos_q5 + sin_q5*z_25;
    const real z_37 = sin_q5*z_35 - 21250.0*cos_q5*z_36;
    const real z_38 = 5725482720.0*z_13 + 406.0*z_31 - 15005.0*z_34 - 640.0*z_37;
    const real z_39 = sin_q5*z_20;
    const real c_4 = c[6];
    const real z_40 = 497229916.0*z_25 + 32.0*cos_q5*z_35 + 680000.0*sin_q5*z_36 + z_29*c_4 - 166654533.0*z_27 -
        2487168.0*z_26;
    const real c_5 = c[7];
    const real c_6 = c[8];
    const real z_41 = sin_q5*c_6;
    const real z_42 = 1690830848.0*z_8 + 2159.0*z_21 + z_19*c_5 + z_22*z_41 + 4321440.0*z_18 - 369656.0*z_16;
    const real c_7 = c[9];
    const real z_43 = cos_q5*z_22;
    const real z_44 = 5803392000.0*cos_q2 + c_7*z_43 - 9492774802.0*z_6 - 3001.0*z_39 - 20.0*cos_q4*z_40 -
        4.0*sin_q4*z_42;
    M1[0][0] = (1.0/1000000000000.0)*(130000000000.0*sin_q2*sin_q2 + 524000000000.0*cos_q2*cos_q2 +
        4350000.0*sin_q2*z_33 + 25.0*z_11*z_38 + 1134029968642.0 - 100.0*cos_q2*z_32 - 25.0*z_3*z_44 -
        25.0*z_5*z_44 - 25.0*z_12*z_38);
    const real z_45 = cos_q5*c_1;
    const real z_46 = 1821922.0*z_6 + z_39 - z_22*z_45;
    const real z_47 = 1575840.0*z_13 - 5.0*z_34;
    const real c_8 = c[10];
    const real z_48 = (cos_q4*z_42 + 0.5*c_8*z_43) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_13) +
        (1.0/246082.0)*(z_39 + (10.0/203.0)*sin_q4*z_40));
    M1[0][1] = M1[1][0] = ((-1.0/20000000000.0))*(5383560000.0*sin_q2 + 475020000.0*cos_q2 + 4318.0*cos_q3*z_46 +
        4318.0*sin_q3*z_47 - 2.0*z_48);
    const real z_49 = sin_q3*cos_q4;
    const real z_50 = 4318.0*cos_q3 + 203.0;
    const real z_51 = cos_q4 - z_49;
    const real z_52 = sin_q5*z_50 - 4318.0*cos_q5*z_51;
    const real z_53 = 2000.0*cos_q4 - z_52;
    const real z_54 = 2880.0*cos_q4 + c_0*z_53 - 43.0*z_52;
    const real z_55 = cos_q5*z_54;
    const real z_56 = cos_q5*z_50 + 4318.0*sin_q5*z_51;
    const real z_57 = 369656.0*cos_q4 + z_55 + z_56*z_23 - 354076.0*z_49;
    const real z_58 = sin_q3*sin_q4;
    const real z_59 = sin_q4*cos_q5;
    const real z_60 = sin_q4 - z_58;
    const real z_61 = 1000.0*z_59 + 2159.0*z_60;
    const real z_62 = 55533.0*sin_q4 + 288.0*z_59 + z_61*c_2 - 53975.0*z_58;
    const real z_63 = 336000.0 + cos_q4*z_57 + 10.0*sin_q4*z_62 - 2072640.0*sin_q3;
    const real z_64 = sin_q5*z_54;
    const real z_65 = 2426716.0*cos_q3 + 16646.0 + z_56*z_45 - z_64;
    const real z_66 = 845415424.0*cos_q4 + 2159.0*z_55 + z_53*c_5 + z_56*z_41 - 798087304.0*z_49 - 1440.0*z_52;
    const real c_9 = c[11];
    const real z_67 = 33885.0*z_59 + z_61*c_9 + 77724.0*z_60;
    const real z_68 = sin_q5*sin_q5;
    const real z_69 = sin_q4*z_68 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_59);
    const real z_70 = 8.0*cos_q5*z_67 + z_61*c_4 + 170000.0*z_69 - 119895747.0*z_58;
    const real z_71 = (cos_q4*z_66 + 0.5*cos_q5*z_56*c_8) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_64 - (20.0/203.0)*sin_q4*z_70));
    M1[1][1] = (1.0/10000000000.0)*(4318.0*cos_q3*z_65 + 30547567588.0 + 2.0*z_71 - 4318.0*sin_q3*z_63);
    M1[0][2] = M1[2][0] = ((-1.0/20000000000.0))*(-2.0*z_48);
    M1[1][2] = M1[2][1] = (1.0/10000000000.0)*(1098579138.0 + 2.0*z_71);
    const real z_72 = 2159.0*sin_q4 + 1000.0*z_59;
    const real z_73 = 77724.0*sin_q4 + 33885.0*z_59 + z_72*c_9;
    const real z_74 = 8.0*cos_q5*z_73 + z_72*c_4 + 170000.0*z_69;
    const real z_75 = sin_q5 - (4318.0/203.0)*cos_q4*cos_q5;
    const real z_76 = 203.0*z_75 - 2000.0*cos_q4;
    const real z_77 = c_0*z_76 + 8729.0*z_75 - 2880.0*cos_q4;
    const real z_78 = 203.0*cos_q5 + 4318.0*sin_q5*cos_q4;
    const real z_79 = 2159.0*cos_q5*z_77 + z_76*c_5 + 292320.0*z_75 - 845415424.0*cos_q4 - z_78*z_41;
    const real c_10 = c[12];
    M1[2][2] = (1.0/500000000000.0)*(1000.0*sin_q4*z_74 + 10150.0*sin_q5*z_77 + 343365622869.0 + cos_q5*z_78*c_10
        - 100.0*cos_q4*z_79);
    M1[0][3] = M1[3][0] = ((-1.0/62500000.0))*(81250.0*z_13 - z_37);
    const real z_80 = sin_q5*z_59;
    M1[1][3] = M1[3][1] = ((-1.0/62500000.0))*(sin_q5*z_67 - 21250.0*z_80);
    M1[2][3] = M1[3][2] = (1.0/62500000.0)*(21250.0*z_80 - sin_q5*z_73);
    const real z_81 = cos_q5*cos_q5;
    const real c_11 = c[13];
    M1[3][3] = (1.0/6250000000000.0)*(2125000000.0*z_81 + 1200566413273.0 + c_11*z_68);
    M1[0][4] = M1[4][0] = (1.0/62500000.0)*(40135.0*z_8 + z_19*c_3 + 27009.0*z_18);
    const real c_12 = c[14];
    M1[1][4] = M1[4][1] = (1.0/62500000.0)*(40135.0*cos_q4 + z_53*c_12 - 18.0*z_52);
    M1[2][4] = M1[4][2] = ((-1.0/62500000.0))*(z_76*c_12 + 3654.0*z_75 - 40135.0*cos_q4);
    M1[3][4] = M1[4][3] = em_real(0.0);
    const real c_13 = c[15];
    M1[4][4] = c_13;
    M1[0][5] = M1[5][0] = ((-1.0/25000.0))*z_36;
    M1[1][5] = M1[5][1] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[2][5] = M1[5][2] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[3][5] = M1[5][3] = (1.0/25000.0)*cos_q5;
    M1[4][5] = M1[5][4] = em_real(0.0);
    M1[5][5] = em_real(48526126417.0/250000000000.0);
    shared[0] = cos_q2;
    shared[1] = sin_q2;
    shared[2] = z_32;
    shared[3] = sin_q3;
    shared[4] = cos_q3;
    shared[5] = z_24;
    shared[6] = cos_q4;
    shared[7] = sin_q4;
    shared[8] = z_6;
    shared[9] = z_14;
    shared[10] = z_13;
    shared[11] = z_20;
    shared[12] = sin_q5;
    shared[13] = cos_q5;
    shared[14] = z_17;
    shared[15] = z_22;
    shared[16] = z_30;
    shared[17] = z_25;
    shared[18] = z_33;
    shared[19] = z_38;
    shared[20] = z_11;
    shared[21] = z_35;
    shared[22] = z_36;
    shared[23] = z_44;
    shared[24] = z_3;
    shared[25] = z_40;
    shared[26] = z_42;
    shared[27] = z_5;
    shared[28] = z_12;
    shared[29] = z_46;
    shared[30] = z_47;
    shared[31] = z_63;
    shared[32] = z_57;
    shared[33] = z_54;
    shared[34] = z_50;
    shared[35] = z_51;
    shared[36] = z_56;
    shared[37] = z_62;
    shared[38] = z_65;
    shared[39] = z_70;
    shared[40] = z_67;
    shared[41] = z_59;
    shared[42] = z_68;
    shared[43] = z_66;
    shared[44] = z_74;
    shared[45] = z_73;
    shared[46] = z_79;
    shared[47] = z_77;
    shared[48] = z_78;
    shared[49] = z_81;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[50],
                             real Mdot1[N1][N1])
{
    const real cos_q2 = shared[0];
    const real q2_dot = v[1];
    const real sin_q2 = shared[1];
    const real z_82 = q2_dot*sin_q2;
    const real z_32 = shared[2];
    const real z_83 = q2_dot*cos_q2;
    const real sin_q3 = shared[3];
    const real z_84 = sin_q3*z_82;
    const real q3_dot = v[2];
    const real cos_q3 = shared[4];
    const real z_85 = q3_dot*cos_q3;
    const real z_86 = cos_q2*z_85;
    const real z_87 = cos_q3*z_83;
    const real z_88 = q3_dot*sin_q3;
    const real z_89 = sin_q2*z_88;
    const real z_90 = (z_84 - z_86) - (z_87 - z_89);
    const real z_24 = shared[5];
    const real q4_dot = v[3];
    const real cos_q4 = shared[6];
    const real z_91 = q4_dot*cos_q4;
    const real sin_q4 = shared[7];
    const real z_6 = shared[8];
    const real z_92 = sin_q4*z_90 - z_6*z_91;
    const real z_14 = shared[9];
    const real z_93 = sin_q3*z_83;
    const real z_94 = sin_q2*z_85;
    const real z_95 = cos_q3*z_82;
    const real z_96 = cos_q2*z_88;
    const real z_97 = (z_93 + z_94) + (z_95 + z_96);
    const real z_98 = 4318.0*z_82 + 203.0*z_97;
    const real z_13 = shared[10];
    const real z_99 = q4_dot*sin_q4;
    const real z_100 = (z_14*z_91 - sin_q4*z_98) - 1500.5*(cos_q4*z_97 - z_13*z_99);
    const real z_20 = shared[11];
    const real q5_dot = v[4];
    const real sin_q5 = shared[12];
    const real z_101 = q5_dot*sin_q5;
    const real cos_q5 = shared[13];
    const real c_0 = c[2];
    const real z_102 = q5_dot*cos_q5;
    const real z_103 = 8636.0*z_92 + 2.0*z_100;
    const real z_17 = shared[14];
    const real z_104 = (sin_q5*z_90 - z_6*z_102) + (1.0/3001.0)*(cos_q5*z_103 + z_17*z_101);
    const real z_105 = 4000.0*z_92 + 3001.0*z_104;
    const real z_106 = 5760.0*z_92 + c_0*z_105 + 129043.0*z_104;
    const real c_1 = c[3];
    const real z_22 = shared[15];
    const real z_107 = (z_17*z_102 - sin_q5*z_103) + 3001.0*(cos_q5*z_90 + z_6*z_101);
    const real z_108 = (z_20*z_101 + cos_q5*z_106) - c_1*(z_22*z_102 + sin_q5*z_107);
    const real z_109 = 739312.0*z_92 + 164.0*z_100 + z_108;
    const real z_30 = shared[16];
    const real z_110 = cos_q4*z_90;
    const real z_111 = z_6*z_99;
    const real z_112 = z_110 + z_111;
    const real z_25 = shared[17];
    const real z_113 = (z_13*z_102 + sin_q5*z_97) + (cos_q5*z_110 + cos_q5*z_111 + z_25*z_101);
    const real z_114 = (z_13*z_91 + sin_q4*z_97) - (2.0/3001.0)*(cos_q4*z_98 + z_14*z_99);
    const real z_115 = z_112 + (3001.0/8636.0)*z_114;
    const real z_116 = 4000.0*z_113 + 8636.0*z_115;
    const real c_2 = c[4];
    const real z_117 = 222132.0*z_112 + z_116*c_2 + 75025.0*z_114 + 1152.0*z_113;
    const real z_118 = (z_24*z_91 - sin_q4*z_109) - 5.0*(z_30*z_99 + cos_q4*z_117);
    const real z_33 = shared[18];
    const real z_38 = shared[19];
    const real z_11 = shared[20];
    const real z_119 = (z_30*z_91 - sin_q4*z_117) + (1.0/5.0)*(z_24*z_99 + cos_q4*z_109);
    const real z_35 = shared[21];
    const real c_3 = c[5];
    const real z_120 = z_116*c_3 + 33885.0*z_113 + 77724.0*z_115;
    const real z_36 = shared[22];
    const real z_121 = (cos_q5*z_97 - z_13*z_101) - (sin_q5*z_110 + sin_q5*z_111 - z_25*z_102);
    const real z_122 = (z_35*z_102 - sin_q5*z_120) + 21250.0*(z_36*z_101 - cos_q5*z_121);
    const real z_123 = 5725482720.0*z_97 + 406.0*z_118 - 15005.0*z_119 - 640.0*z_122;
    const real z_44 = shared[23];
    const real z_3 = shared[24];
    const real z_40 = shared[25];
    const real c_4 = c[6];
    const real z_124 = 497229916.0*z_112 + 32.0*(z_35*z_101 + cos_q5*z_120) + z_116*c_4 + 166654533.0*z_114 +
        2487168.0*z_113 - 680000.0*(z_36*z_102 + sin_q5*z_121);
    const real z_42 = shared[26];
    const real c_5 = c[7];
    const real z_125 = 1690830848.0*z_92 + z_105*c_5 + 4321440.0*z_104 + 369656.0*z_100 + 2159.0*z_108;
    const real z_126 = (z_20*z_102 - sin_q5*z_106) + c_1*(z_22*z_101 - cos_q5*z_107);
    const real z_127 = 5803392000.0*z_82 + 4.0*(z_42*z_91 - sin_q4*z_125) + 3001.0*z_126 - 9492774802.0*z_90 -
        20.0*(z_40*z_99 + cos_q4*z_124);
    const real z_5 = shared[27];
    const real z_12 = shared[28];
    Mdot1[0][0] = ((-1.0/40000000000.0))*(31520000000.0*cos_q2*z_82 + (z_44*z_87 - z_44*z_89 - z_5*z_127) -
        4.0*(z_32*z_82 - cos_q2*(70992000.0*z_83 + 18759823020.0*z_82 + 2159.0*z_118 - 1450848000.0*z_90)) -
        174000.0*(z_33*z_83 + sin_q2*(207169.0*z_83 + 1632.0*z_82)) - (z_38*z_93 + z_38*z_94 + z_11*z_123) -
        (z_44*z_84 + z_3*z_127 - z_44*z_86) - (z_38*z_95 + z_38*z_96 - z_12*z_123));
    const real z_46 = shared[29];
    const real z_47 = shared[30];
    const real z_128 = ((z_40*z_91 - sin_q4*z_124) + (1.0/5.0)*(z_42*z_99 + cos_q4*z_125)) + (203.0/10.0)*(z_126 -
        246082.0*(z_90 + (78792000.0/3568189.0)*z_97));
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/20000000000.0))*(5383560000.0*z_83 + 4318.0*(z_47*z_85 +
        sin_q3*(1575840.0*z_97 - 5.0*z_119)) + 10.0*z_128 - 475020000.0*z_82 - 4318.0*(z_46*z_88 +
        cos_q3*(1821922.0*z_90 - z_126)));
    const real z_63 = shared[31];
    const real z_57 = shared[32];
    const real z_129 = cos_q4*z_85 - sin_q3*z_99;
    const real z_54 = shared[33];
    const real z_50 = shared[34];
    const real z_51 = shared[35];
    const real z_130 = z_99 + z_129;
    const real z_131 = (z_50*z_102 - 4318.0*sin_q5*z_88) + 4318.0*(z_51*z_101 + cos_q5*z_130);
    const real z_132 = 2000.0*z_99 + z_131;
    const real z_133 = 2880.0*z_99 + c_0*z_132 + 43.0*z_131;
    const real z_56 = shared[36];
    const real z_134 = (z_50*z_101 + 4318.0*cos_q5*z_88) - 4318.0*(z_51*z_102 - sin_q5*z_130);
    const real z_135 = (z_54*z_101 + cos_q5*z_133) - c_1*(z_56*z_102 - sin_q5*z_134);
    const real z_62 = shared[37];
    const real z_136 = sin_q4*z_85 + sin_q3*z_91;
    const real z_137 = cos_q5*z_91 - sin_q4*z_101;
    const real z_138 = z_91 - z_136;
    const real z_139 = 1000.0*z_137 + 2159.0*z_138;
    const real z_65 = shared[38];
    const real z_140 = (z_54*z_102 - sin_q5*z_133) + c_1*(z_56*z_101 + cos_q5*z_134);
    const real z_70 = shared[39];
    const real z_67 = shared[40];
    const real c_9 = c[11];
    const real z_141 = 33885.0*z_137 + z_139*c_9 + 77724.0*z_138;
    const real z_59 = shared[41];
    const real z_68 = shared[42];
    const real z_142 = (2.0*z_59*z_101 + z_91*z_68) + (124307479.0/170000.0)*(z_91 +
        (621792.0/124307479.0)*z_137);
    const real z_66 = shared[43];
    const real z_143 = ((z_70*z_91 + sin_q4*(z_139*c_4 + 170000.0*z_142 - 119895747.0*z_136 - 8.0*(z_67*z_101 -
        cos_q5*z_141))) - (1.0/10.0)*(z_66*z_99 + cos_q4*(845415424.0*z_99 + 798087304.0*z_129 + z_132*c_5 +
        1440.0*z_131 + 2159.0*z_135))) - (203.0/20.0)*(z_140 + (207264000.0/29.0)*(z_85 + (1189.0/24000.0)*z_88));
    Mdot1[1][1] = ((-1.0/10000000000.0))*(4318.0*(z_63*z_85 - sin_q3*(2072640.0*z_85 + (z_57*z_99 +
        cos_q4*(369656.0*z_99 + 354076.0*z_129 + z_135)) - 10.0*(z_62*z_91 + sin_q4*(55533.0*z_91 + 288.0*z_137 +
        z_139*c_2 - 53975.0*z_136)))) + 4318.0*(z_65*z_88 + cos_q3*(2426716.0*z_88 + z_140)) - 20.0*z_143);
    Mdot1[0][2] = Mdot1[2][0] = (1.0/20000000000.0)*(-10.0*z_128);
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/10000000000.0))*(-20.0*z_143);
    const real z_74 = shared[44];
    const real z_73 = shared[45];
    const real z_144 = 2159.0*z_91 + 1000.0*z_137;
    const real z_145 = 77724.0*z_91 + 33885.0*z_137 + z_144*c_9;
    const real z_79 = shared[46];
    const real z_77 = shared[47];
    const real z_146 = z_102 + (4318.0/203.0)*(cos_q5*z_99 + cos_q4*z_101);
    const real z_147 = 2000.0*z_99 + 203.0*z_146;
    const real z_148 = 2880.0*z_99 + c_0*z_147 + 8729.0*z_146;
    const real z_78 = shared[48];
    const real z_149 = 203.0*z_101 - 4318.0*(cos_q4*z_102 - sin_q5*z_99);
    Mdot1[2][2] = (1.0/10000000000.0)*(20.0*(z_74*z_91 + sin_q4*(z_144*c_4 + 170000.0*z_142 - 8.0*(z_73*z_101 -
        cos_q5*z_145))) + 2.0*(z_79*z_99 - cos_q4*(845415424.0*z_99 + z_147*c_5 + 292320.0*z_146 -
        2159.0*(z_77*z_101 - cos_q5*z_148) - 2159.0*c_1*(z_78*z_102 - sin_q5*z_149))) + 203.0*(z_77*z_102 +
        sin_q5*z_148) - 203.0*c_1*(z_78*z_101 + cos_q5*z_149));
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/62500000.0))*(81250.0*z_97 - z_122);
    const real z_81 = shared[49];
    const real z_150 = q5_dot*sin_q4;
    const real z_151 = sin_q5*z_91;
    const real z_152 = z_81*z_150 + cos_q5*z_151 - z_68*z_150;
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/62500000.0))*((z_67*z_102 + sin_q5*z_141) - 21250.0*z_152);
    Mdot1[2][3] = Mdot1[3][2] = (1.0/62500000.0)*(21250.0*z_152 - (z_73*z_102 + sin_q5*z_145));
    const real c_14 = c[16];
    Mdot1[3][3] = -c_14*(cos_q5*z_101);
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/62500000.0))*(40135.0*z_92 + z_105*c_3 + 27009.0*z_104);
    const real c_12 = c[14];
    Mdot1[1][4] = Mdot1[4][1] = ((-1.0/62500000.0))*(40135.0*z_99 + z_132*c_12 + 18.0*z_131);
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/62500000.0))*(40135.0*z_99 + z_147*c_12 + 3654.0*z_146);
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    Mdot1[0][5] = Mdot1[5][0] = ((-1.0/25000.0))*z_121;
    Mdot1[1][5] = Mdot1[5][1] = (1.0/25000.0)*(sin_q4*z_102 + z_151);
    Mdot1[2][5] = Mdot1[5][2] = (1.0/25000.0)*(sin_q4*z_102 + z_151);
    Mdot1[3][5] = Mdot1[5][3] = ((-1.0/25000.0))*z_101;
    Mdot1[4][5] = Mdot1[5][4] = em_real(0.0);
    Mdot1[5][5] = em_real(0.0);
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

enum { N_PIVOTS = 6 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], shared[50];
    settled_masses(y, c, M1, shared);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1], e[2], e[3], e[4], e[5] };
    if (mode) em_backward(N1, memory + 0, memory + 36, v1);
    else em_velocity_of_eta(N1, y + 12, y + 48, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
    v[4] = v1[4];
    v[5] = v1[5];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s.
 * *done becomes 0 in lanes that are settled number by number instead, as where the mode changes;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], shared[50];
    settled_masses(y, c, M1, shared);
    real eta1[N1] = { y[6], y[7], y[8], y[9], y[10], y[11] };
    *done &= em_refresh(N1, M1[0], y + 12, y + 48, mode ? NULL : eta1);
    y[6] = eta1[0];
    y[7] = eta1[1];
    y[8] = eta1[2];
    y[9] = eta1[3];
    y[10] = eta1[4];
    y[11] = eta1[5];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 36, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 48);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        real time = em_time_on_lanes(N1, y + 12, y + 48, Mdot1[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes puma_lanes;
em_lanes puma_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double tau1 = u[0];
    const double q1_dot = v[0];
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_1 = q1_dot*sin_q2;
    const double q2_dot = v[1];
    const double cos_q2 = em_cos(q2);
    const double z_3 = q2_dot*cos_q2;
    const double z_4 = q1_dot*cos_q2;
    const double z_5 = 34.0*z_4 - 3.0*z_1;
    const double z_6 = 48.0*z_5 + 455.0*(136.0*q2_dot - 455.0*z_1);
    const double z_7 = q2_dot*z_4;
    const double z_8 = q2_dot*z_1;
    const double z_9 = 34.0*z_8 + 3.0*z_7;
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double cos_q3 = em_cos(q3);
    const double z_12 = sin_q3*z_4 + cos_q3*z_1;
    const double z_13 = 350.0*z_12 - 2159.0*z_4;
    const double q4 = x[3];
    const double cos_q4 = em_cos(q4);
    const double sin_q4 = em_sin(q4);
    const double q3_dot = v[2];
    const double z_16 = q2_dot + q3_dot;
    const double z_17 = sin_q4*z_16 - cos_q4*z_12;
    const double z_18 = sin_q3*z_1 - cos_q3*z_4;
    const double z_19 = q2_dot*sin_q3;
    const double z_20 = 3001.0*z_18 - 8636.0*z_19;
    const double z_21 = 203.0*z_18 - 4318.0*z_4;
    const double z_22 = sin_q4*z_20 - 2.0*cos_q4*z_21;
    const double z_23 = 9016.0*z_17 + z_22;
    const double z_24 = 8636.0*z_17 + z_22;
    const double q6 = x[5];
    const double cos_q6 = em_cos(q6);
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double sin_q5 = em_sin(q5);
    const double q4_dot = v[3];
    const double z_28 = q4_dot - z_18;
    const double z_29 = cos_q5*z_17 - sin_q5*z_28;
    const double q5_dot = v[4];
    const double z_30 = cos_q4*z_16 + sin_q4*z_12;
    const double z_31 = q5_dot + z_30;
    const double sin_q6 = em_sin(q6);
    const double z_33 = z_29*cos_q6 + z_31*sin_q6;
    const double z_34 = cos_q4*z_20 + 2.0*sin_q4*z_21;
    const double z_35 = 8636.0*z_30 + z_34;
    const double z_36 = q2_dot*cos_q3;
    const double z_37 = 406.0*z_16 + 8636.0*z_36 - 3001.0*z_12;
    const double z_38 = cos_q5*z_35 - sin_q5*z_37;
    const double z_39 = cos_q6*z_24 + sin_q6*z_38;
    const double z_40 = 640.0*z_33 + z_39;
    const double c_0 = c[2];
    const double z_41 = 4000.0*z_33 + z_39;
    const double z_42 = 9.0*z_40 + c_0*z_41;
    const double z_43 = z_29*sin_q6 - z_31*cos_q6;
    const double z_44 = cos_q6*z_38 - sin_q6*z_24;
    const double z_45 = 640.0*z_43 - z_44;
    const double z_46 = 4000.0*z_43 - z_44;
    const double z_47 = 9.0*z_45 + c_0*z_46;
    const double z_48 = 34.0*z_24 + cos_q6*z_42 + sin_q6*z_47;
    const double z_49 = 82.0*z_23 + z_48;
    const double z_50 = 9016.0*z_30 + z_34;
    const double c_1 = c[3];
    const double z_51 = cos_q5*z_37 + sin_q5*z_35;
    const double z_52 = c_1*z_51;
    const double z_53 = 34.0*z_38 + sin_q6*z_42 - cos_q6*z_47;
    const double z_54 = sin_q5*z_52 + cos_q5*z_53;
    const double z_55 = 82.0*z_50 + z_54;
    const double z_56 = cos_q4*z_49 - sin_q4*z_55;
    const double z_57 = 4145280.0*z_13 + 19792500.0*(12.0*q2_dot - 455.0*z_4) - 23664000.0*z_5 - 2159.0*z_56;
    const double z_58 = q3_dot*cos_q3;
    const double z_59 = q3_dot*sin_q3;
    const double z_60 = (z_19*z_1 - z_4*z_58) - (z_4*z_36 - z_1*z_59);
    const double z_61 = 350.0*z_60 - 2159.0*z_8;
    const double z_62 = q4_dot*sin_q4;
    const double z_63 = q4_dot*cos_q4;
    const double z_64 = z_16*z_63 + (z_12*z_62 + cos_q4*z_60);
    const double z_65 = (z_4*z_19 + z_1*z_58) + (z_36*z_1 + z_4*z_59);
    const double z_66 = q3_dot*z_36;
    const double z_67 = 3001.0*z_65 - 8636.0*z_66;
    const double z_68 = 203.0*z_65 + 4318.0*z_8;
    const double z_69 = (z_20*z_63 + sin_q4*z_67) + 2.0*(z_21*z_62 - cos_q4*z_68);
    const double z_70 = 9016.0*z_64 + z_69;
    const double z_71 = 8636.0*z_64 + z_69;
    const double q6_dot = v[5];
    const double z_72 = q6_dot*sin_q6;
    const double z_73 = q5_dot*sin_q5;
    const double z_74 = q5_dot*cos_q5;
    const double z_75 = (z_17*z_73 - cos_q5*z_64) + (z_28*z_74 - sin_q5*z_65);
    const double z_76 = z_16*z_62 - (z_12*z_63 - sin_q4*z_60);
    const double z_77 = q6_dot*cos_q6;
    const double z_78 = (cos_q6*z_75 + z_29*z_72) + (sin_q6*z_76 - z_31*z_77);
    const double z_79 = (z_20*z_62 - cos_q4*z_67) - 2.0*(z_21*z_63 + sin_q4*z_68);
    const double z_80 = 8636.0*z_76 + z_79;
    const double z_81 = q3_dot*z_19;
    const double z_82 = 3001.0*z_60 - 8636.0*z_81;
    const double z_83 = (z_35*z_73 + cos_q5*z_80) + (z_37*z_74 + sin_q5*z_82);
    const double z_84 = (z_24*z_72 - cos_q6*z_71) - (z_38*z_77 - sin_q6*z_83);
    const double z_85 = 640.0*z_78 + z_84;
    const double z_86 = 4000.0*z_78 + z_84;
    const double z_87 = 9.0*z_85 + c_0*z_86;
    const double z_88 = (sin_q6*z_75 - z_29*z_77) - (cos_q6*z_76 + z_31*z_72);
    const double z_89 = (z_38*z_72 + cos_q6*z_83) + (z_24*z_77 + sin_q6*z_71);
    const double z_90 = 640.0*z_88 - z_89;
    const double z_91 = 4000.0*z_88 - z_89;
    const double z_92 = 9.0*z_90 + c_0*z_91;
    const double z_93 = 34.0*z_71 + (z_47*z_77 - sin_q6*z_92) - (z_42*z_72 + cos_q6*z_87);
    const double z_94 = 82.0*z_70 + z_93;
    const double z_95 = 9016.0*z_76 + z_79;
    const double z_96 = (z_37*z_73 - cos_q5*z_82) - (z_35*z_74 - sin_q5*z_80);
    const double z_97 = 34.0*z_83 - (z_42*z_77 - sin_q6*z_87) - (z_47*z_72 + cos_q6*z_92);
    const double z_98 = c_1*(z_51*z_74 - sin_q5*z_96) - (z_53*z_73 + cos_q5*z_97);
    const double z_99 = 82.0*z_95 - z_98;
    const double z_100 = (z_49*z_62 - cos_q4*z_94) + (z_55*z_63 - sin_q4*z_99);
    const double z_101 = 3283.0*z_12 - 8636.0*z_36;
    const double z_102 = 82.0*z_37 + cos_q5*z_52 - sin_q5*z_53;
    const double c_3 = c[5];
    const double z_103 = 9375.0*z_43 + 9.0*z_45 + z_46*c_3;
    const double z_104 = 9375.0*z_33 + 9.0*z_40 + z_41*c_3;
    const double z_105 = 18750.0*z_29 + sin_q6*z_103 + cos_q6*z_104;
    const double z_106 = sin_q5*z_17 + cos_q5*z_28;
    const double z_107 = 2.0*(q6_dot + z_106) + 15.0*z_106;
    const double z_108 = 184828.0*z_23 + 2159.0*z_48 + 160.0*(112500.0*z_17 + cos_q5*z_105 + 1250.0*sin_q5*z_107);
    const double z_109 = 18000000.0*z_30 + 184828.0*z_50 + 2159.0*z_54 + 160.0*(25000.0*z_31 + sin_q6*z_104 -
        cos_q6*z_103);
    const double z_110 = 2688000.0*z_13 + 1575840.0*z_101 + 4.0*(660000000.0*z_12 + sin_q4*z_109 - cos_q4*z_108) -
        3001.0*z_102;
    const double z_111 = cos_q2*z_110;
    const double z_112 = sin_q2*z_110;
    const double z_113 = sin_q2*cos_q3;
    const double z_114 = 3283.0*z_60 - 8636.0*z_81;
    const double z_115 = 82.0*z_82 - c_1*(z_51*z_73 + cos_q5*z_96) - (z_53*z_74 - sin_q5*z_97);
    const double z_116 = 9375.0*z_88 + 9.0*z_90 + c_3*z_91;
    const double z_117 = 9375.0*z_78 + 9.0*z_85 + c_3*z_86;
    const double z_118 = 18750.0*z_75 + (z_104*z_72 + cos_q6*z_117) - (z_103*z_77 - sin_q6*z_116);
    const double z_119 = (z_17*z_74 + sin_q5*z_64) - (z_28*z_73 + cos_q5*z_65);
    const double z_120 = 184828.0*z_70 + 2159.0*z_93 + 160.0*(112500.0*z_64 + 1250.0*(z_107*z_74 +
        17.0*sin_q5*z_119) - (z_105*z_73 + cos_q5*z_118));
    const double z_121 = 25000.0*z_76 - (z_103*z_72 + cos_q6*z_116) - (z_104*z_77 - sin_q6*z_117);
    const double z_122 = 18000000.0*z_76 + 184828.0*z_95 + 160.0*z_121 - 2159.0*z_98;
    const double z_123 = 2688000.0*z_61 + 1575840.0*z_114 + 3001.0*z_115 + 4.0*(660000000.0*z_60 - (z_108*z_62 -
        cos_q4*z_120) - (z_109*z_63 - sin_q4*z_122));
    const double z_124 = cos_q2*sin_q3;
    const double z_125 = 3283.0*z_18 + 1400.0*z_16 - 8636.0*z_19;
    const double z_126 = sin_q4*z_49 + cos_q4*z_55;
    const double z_127 = 500000000.0*z_18 + 1575840.0*z_125 + 3001.0*z_126 - 406.0*z_56 - 640.0*(81250.0*z_28 +
        1250.0*cos_q5*z_107 - sin_q5*z_105);
    const double z_128 = sin_q2*z_127;
    const double z_129 = cos_q2*z_127;
    const double z_130 = cos_q2*cos_q3;
    const double z_131 = 3283.0*z_65 - 8636.0*z_66;
    const double z_132 = (z_49*z_63 + sin_q4*z_94) - (z_55*z_62 + cos_q4*z_99);
    const double z_133 = 81250.0*z_65 + (z_105*z_74 - sin_q5*z_118) + 1250.0*(z_107*z_73 - 17.0*cos_q5*z_119);
    const double z_134 = 500000000.0*z_65 + 1575840.0*z_131 + 406.0*z_100 + 3001.0*z_132 + 640.0*z_133;
    const double z_135 = sin_q2*sin_q3;
    bias[0] = (1.0/40000000000.0)*(40000000000.0*tau1 + (31520000000.0*z_1*z_3 + 174000.0*(z_6*z_3 -
        sin_q2*(207025.0*z_7 + 48.0*z_9)) + (z_19*z_112 + z_124*z_123 - z_58*z_111) - 4.0*(q2_dot*sin_q2*z_57 -
        cos_q2*(9005587500.0*z_8 + 23664000.0*z_9 + 2159.0*z_100 - 4145280.0*z_61)) - (z_36*z_111 - z_59*z_112 -
        z_113*z_123) - (z_36*z_128 + z_59*z_129 - z_130*z_134) - (z_19*z_129 + z_58*z_128 + z_135*z_134)));
    const double tau2 = u[1];
    const double z_136 = q1_dot*q1_dot;
    const double z_137 = q1_dot*sin_q3;
    const double z_138 = q1_dot*cos_q3;
    const double c_15 = c[17];
    const double c_16 = c[18];
    const double z_139 = c_15 + cos_q5*c_16;
    const double c_17 = c[19];
    const double c_18 = c[20];
    const double z_140 = c_17 - c_18*(sin_q5*cos_q4);
    const double c_19 = c[21];
    const double c_20 = c[22];
    const double z_141 = 480.0*z_125 + z_126;
    const double z_142 = 480.0*z_101 - z_102;
    const double z_143 = ((z_108*z_63 + sin_q4*z_120) - (z_109*z_62 + cos_q4*z_122)) + 168000.0*(z_131 +
        (29.0/48000.0)*z_115);
    bias[1] = (1.0/40000000000.0)*((40000000000.0*tau2 + (sin_q2*(4.0*q1_dot*z_57 + z_127*z_138 +
        400000.0*cos_q3*z_139 + 200000.0*sin_q3*z_140 + c_19 - 20960000000.0*cos_q2*z_136 - z_110*z_137) -
        cos_q2*(174000.0*q1_dot*z_6 + 200000.0*cos_q3*z_140 + c_20 - 5200000000.0*sin_q2*z_136 - z_110*z_138 -
        z_127*z_137 - 400000.0*sin_q3*z_139))) - 2.0*(475020000.0*z_8 + 4318.0*(z_142*z_59 + cos_q3*(480.0*z_114 +
        z_115)) + 2.0*z_143 - 5383560000.0*z_7 - 4318.0*(z_141*z_58 + sin_q3*(480.0*z_131 + z_132))));
    const double tau3 = u[2];
    bias[2] = (1.0/40000000000.0)*((40000000000.0*tau3 + (sin_q3*(8636.0*q2_dot*z_142 + z_4*z_127 +
        400000.0*cos_q2*z_139 + 200000.0*sin_q2*z_140 - z_1*z_110) - cos_q3*(8636.0*q2_dot*z_141 +
        200000.0*cos_q2*z_140 - z_4*z_110 - z_1*z_127 - 400000.0*sin_q2*z_139))) - 2.0*(2.0*z_143));
    const double tau4 = u[3];
    const double c_21 = c[23];
    const double z_144 = z_124 + z_113;
    bias[3] = (1.0/40000000000.0)*((40000000000.0*tau4 + (sin_q4*(2.0*z_21*z_49 + 4.0*z_12*z_108 - z_20*z_55 -
        4.0*z_16*z_109 - c_21*(z_144*sin_q5)) + cos_q4*(z_20*z_49 + 2.0*z_21*z_55 + 4.0*z_16*z_108 +
        4.0*z_12*z_109))) + 640.0*z_133);
    const double tau5 = u[4];
    bias[4] = (1.0/40000000000.0)*((40000000000.0*tau5 - (sin_q5*(z_37*z_52 + z_35*z_53 + 640.0*z_17*z_105 +
        800000.0*z_28*z_107 + (z_135 - z_130)*c_21) - cos_q5*(z_35*z_52 + 800000.0*z_17*z_107 +
        c_21*(z_144*cos_q4) - z_37*z_53 - 640.0*z_28*z_105))) + 640.0*z_121);
    const double tau6 = u[5];
    bias[5] = (1.0/40000000000.0)*((40000000000.0*tau6 + (cos_q6*(z_38*z_42 + z_24*z_47 + 640.0*z_29*z_103 +
        640.0*z_31*z_104) - sin_q6*(z_24*z_42 + 640.0*z_29*z_104 - z_38*z_47 - 640.0*z_31*z_103))) -
        1600000.0*z_119);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double q1_dot = v[0];
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double cos_q2 = em_cos(q2);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_3 = cos_q2*sin_q3;
    const double cos_q3 = em_cos(q3);
    const double z_5 = sin_q2*cos_q3;
    const double z_6 = z_3 + z_5;
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double z_8 = z_6*sin_q4;
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double sin_q5 = em_sin(q5);
    const double z_11 = sin_q2*sin_q3;
    const double z_12 = cos_q2*cos_q3;
    const double z_13 = z_11 - z_12;
    const double z_14 = 4318.0*cos_q2 - 203.0*z_13;
    const double cos_q4 = em_cos(q4);
    const double z_16 = sin_q4*z_14 - 1500.5*z_13*cos_q4;
    const double z_17 = 8636.0*z_8 - 2.0*z_16;
    const double z_18 = z_6*sin_q5 + (1.0/3001.0)*z_17*cos_q5;
    const double z_19 = 4000.0*z_8 + 3001.0*z_18;
    const double c_0 = c[2];
    const double z_20 = 5760.0*z_8 + z_19*c_0 + 129043.0*z_18;
    const double z_21 = cos_q5*z_20;
    const double z_22 = sin_q5*z_17 - 3001.0*z_6*cos_q5;
    const double c_1 = c[3];
    const double z_23 = sin_q5*c_1;
    const double z_24 = 739312.0*z_8 + z_21 + z_22*z_23 - 164.0*z_16;
    const double z_25 = z_6*cos_q4;
    const double z_26 = sin_q5*z_13 - cos_q5*z_25;
    const double z_27 = sin_q4*z_13 + (2.0/3001.0)*z_14*cos_q4;
    const double z_28 = z_25 - (3001.0/8636.0)*z_27;
    const double z_29 = 8636.0*z_28 - 4000.0*z_26;
    const double c_2 = c[4];
    const double z_30 = 222132.0*z_25 + z_29*c_2 - 75025.0*z_27 - 1152.0*z_26;
    const double z_31 = sin_q4*z_24 + 5.0*cos_q4*z_30;
    const double z_32 = sin_q4*z_30 - (1.0/5.0)*cos_q4*z_24;
    const double c_3 = c[5];
    const double z_33 = z_29*c_3 + 77724.0*z_28 - 33885.0*z_26;
    const double z_34 = z_13*cos_q5 + sin_q5*z_25;
    const double z_35 = sin_q5*z_33 - 21250.0*cos_q5*z_34;
    const double z_36 = 5725482720.0*z_13 + 406.0*z_31 - 15005.0*z_32 - 640.0*z_35;
    const double z_37 = sin_q5*z_20;
    const double c_4 = c[6];
    const double z_38 = 497229916.0*z_25 + 32.0*cos_q5*z_33 + 680000.0*sin_q5*z_34 + z_29*c_4 - 166654533.0*z_27 -
        2487168.0*z_26;
    const double c_5 = c[7];
    const double c_6 = c[8];
    const double z_39 = sin_q5*c_6;
    const double z_40 = 1690830848.0*z_8 + 2159.0*z_21 + z_19*c_5 + z_22*z_39 + 4321440.0*z_18 - 369656.0*z_16;
    const double c_7 = c[9];
    const double z_41 = cos_q5*z_22;
    const double z_42 = 5803392000.0*cos_q2 + c_7*z_41 - 9492774802.0*z_6 - 3001.0*z_37 - 20.0*cos_q4*z_38 -
        4.0*sin_q4*z_40;
    const double q2_dot = v[1];
    const double z_43 = cos_q5*c_1;
    const double z_44 = sin_q2 + (3.0/34.0)*cos_q2;
    const double c_8 = c[10];
    const double z_45 = (cos_q4*z_40 + 0.5*c_8*z_41) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_13) +
        (1.0/246082.0)*(z_37 + (10.0/203.0)*sin_q4*z_38));
    const double z_46 = 4318.0*cos_q3*(1821922.0*z_6 + z_37 - z_22*z_43) + 4318.0*sin_q3*(1575840.0*z_13 -
        5.0*z_32) + 5383560000.0*z_44 - 2.0*z_45;
    const double q3_dot = v[2];
    const double z_47 = -2.0*z_45;
    const double q4_dot = v[3];
    const double z_48 = 81250.0*z_13 - z_35;
    const double q5_dot = v[4];
    const double z_49 = 40135.0*z_8 + z_19*c_3 + 27009.0*z_18;
    const double q6_dot = v[5];
    const double z_50 = sin_q3*cos_q4;
    const double z_51 = 4318.0*cos_q3 + 203.0;
    const double z_52 = cos_q4 - z_50;
    const double z_53 = sin_q5*z_51 - 4318.0*cos_q5*z_52;
    const double z_54 = 2000.0*cos_q4 - z_53;
    const double z_55 = 2880.0*cos_q4 + c_0*z_54 - 43.0*z_53;
    const double z_56 = cos_q5*z_55;
    const double z_57 = cos_q5*z_51 + 4318.0*sin_q5*z_52;
    const double z_58 = sin_q3*sin_q4;
    const double z_59 = sin_q4*cos_q5;
    const double z_60 = sin_q4 - z_58;
    const double z_61 = 1000.0*z_59 + 2159.0*z_60;
    const double z_62 = sin_q5*z_55;
    const double c_9 = c[11];
    const double z_63 = 33885.0*z_59 + z_61*c_9 + 77724.0*z_60;
    const double z_64 = sin_q5*sin_q5;
    const double z_65 = sin_q4*z_64 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_59);
    const double z_66 = (cos_q4*(845415424.0*cos_q4 + 2159.0*z_56 + z_54*c_5 + z_57*z_39 - 798087304.0*z_50 -
        1440.0*z_53) + 0.5*cos_q5*z_57*c_8) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_62 - (20.0/203.0)*sin_q4*(8.0*cos_q5*z_63 + z_61*c_4 + 170000.0*z_65 -
        119895747.0*z_58)));
    const double z_67 = 1098579138.0 + 2.0*z_66;
    const double z_68 = sin_q5*sin_q4;
    const double z_69 = cos_q5*z_68;
    const double z_70 = sin_q5*z_63 - 21250.0*z_69;
    const double c_12 = c[14];
    const double z_71 = 40135.0*cos_q4 + z_54*c_12 - 18.0*z_53;
    const double z_72 = q6_dot*z_68;
    const double z_73 = 2159.0*sin_q4 + 1000.0*z_59;
    const double z_74 = 77724.0*sin_q4 + 33885.0*z_59 + z_73*c_9;
    const double z_75 = sin_q5 - (4318.0/203.0)*cos_q4*cos_q5;
    const double z_76 = 203.0*z_75 - 2000.0*cos_q4;
    const double z_77 = c_0*z_76 + 8729.0*z_75 - 2880.0*cos_q4;
    const double z_78 = 203.0*cos_q5 + 4318.0*sin_q5*cos_q4;
    const double c_10 = c[12];
    const double z_79 = 21250.0*z_69 - sin_q5*z_74;
    const double z_80 = z_76*c_12 + 3654.0*z_75 - 40135.0*cos_q4;
    const double c_11 = c[13];
    const double c_22 = c[24];
    e[0] = (1.0/50000000000000.0)*(25.0*q1_dot*(q1_dot*(130000000000.0*sin_q2*sin_q2 +
        524000000000.0*cos_q2*cos_q2 + 4350000.0*sin_q2*(207169.0*sin_q2 - 1632.0*cos_q2) + 25.0*z_11*z_36 +
        1134029968642.0 - 100.0*cos_q2*(70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_31 - 18759823020.0*cos_q2)
        - 25.0*z_3*z_42 - 25.0*z_5*z_42 - 25.0*z_12*z_36) + 16000.0*q5_dot*z_49 - 50.0*q2_dot*z_46 -
        50.0*q3_dot*z_47 - 16000.0*q4_dot*z_48 - 40000000.0*q6_dot*z_34) + 50.0*q3_dot*(20000000.0*z_72 +
        50.0*q2_dot*z_67 + q3_dot*(1000.0*sin_q4*(8.0*cos_q5*z_74 + z_73*c_4 + 170000.0*z_65) +
        10150.0*sin_q5*z_77 + 343365622869.0 + cos_q5*z_78*c_10 - 100.0*cos_q4*(2159.0*cos_q5*z_77 + z_76*c_5 +
        292320.0*z_75 - 845415424.0*cos_q4 - z_78*z_39)) + 8000.0*q4_dot*z_79 - 25.0*q1_dot*z_47 -
        8000.0*q5_dot*z_80) + 25.0*q5_dot*(16000.0*q1_dot*z_49 + 16000.0*q2_dot*z_71 + q5_dot*c_22 -
        16000.0*q3_dot*z_80) + 100.0*q6_dot*(48526126417.0*q6_dot + 10000000.0*q2_dot*z_68 +
        10000000.0*q3_dot*z_68 + 10000000.0*q4_dot*cos_q5 - 10000000.0*q1_dot*z_34) - 1250.0*q2_dot*(q1_dot*z_46 +
        320.0*q4_dot*z_70 - 2.0*q2_dot*(4318.0*cos_q3*(2426716.0*cos_q3 + 16646.0 + z_57*z_43 - z_62) +
        30547567588.0 + 2.0*z_66 - 4318.0*sin_q3*(336000.0 + cos_q4*(369656.0*cos_q4 + z_56 + z_57*z_23 -
        354076.0*z_50) + 10.0*sin_q4*(55533.0*sin_q4 + 288.0*z_59 + z_61*c_2 - 53975.0*z_58) - 2072640.0*sin_q3))
        - 2.0*q3_dot*z_67 - 320.0*q5_dot*z_71 - 800000.0*z_72) - 4.0*q4_dot*(100000.0*q1_dot*z_48 +
        100000.0*q2_dot*z_70 - 100000.0*q3_dot*z_79 - q4_dot*(2125000000.0*cos_q5*cos_q5 + 1200566413273.0 +
        c_11*z_64) - 250000000.0*q6_dot*cos_q5));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c_23 = c[25];
    const double z_81 = sin_q2 + (203.0/4318.0)*z_6;
    const double z_82 = z_13 - z_81;
    const double c_24 = c[26];
    const double c_25 = c[27];
    const double c_26 = c[28];
    const double c_27 = c[29];
    const double c_28 = c[30];
    e[3] = (1.0/1000000.0)*((2159.0*sin_q2 - 350.0*z_13)*c_23 + (-320.0*z_34 - 4318.0*z_82)*c_24 +
        (-4318.0*z_82)*c_25 + (4318.0*z_81 - 4508.0*z_13)*c_26 + (34.0*z_44)*c_27 + (-2000.0*z_34 -
        4318.0*z_82)*c_28);
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
    p[0] = p[1] = p[3] = p[4] = p[6] = p[7] = p[8] = p[9] = p[10] = p[11] = p[13] = p[14] = p[17] = p[18] = p[19]
        = p[23] = p[24] = p[25] = p[29] = 0.0;
    p[2] = p[5] = -0.5;
    p[12] = p[26] = p[40] = 1.0/20.0;
    p[15] = 1.0;
    const double q1 = x[0];
    p[16] = q1;
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double cos_q1 = em_cos(q1);
    const double z_2 = cos_q2*cos_q1;
    p[20] = p[31] = p[37] = (2159.0/5000.0)*z_2;
    const double sin_q1 = em_sin(q1);
    const double z_4 = cos_q2*sin_q1;
    p[21] = p[32] = p[38] = (2159.0/5000.0)*z_4;
    const double sin_q2 = em_sin(q2);
    p[22] = p[33] = p[39] = (2159.0/5000.0)*sin_q2;
    p[27] = sin_q1;
    p[28] = -cos_q1;
    p[30] = q2;
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_7 = sin_q2*sin_q3;
    const double cos_q3 = em_cos(q3);
    const double z_9 = cos_q2*cos_q3;
    const double z_10 = z_7*cos_q1 - z_9*cos_q1;
    const double z_11 = z_10 - (4318.0/203.0)*(z_2 + (3001.0/8636.0)*sin_q1);
    p[34] = p[45] = (1.0/20000.0)*(-406.0*z_11);
    const double z_12 = z_7*sin_q1 - z_9*sin_q1;
    const double z_13 = z_12 + (3001.0/406.0)*(cos_q1 - (8636.0/3001.0)*z_4);
    p[35] = p[46] = ((-1.0/20000.0))*(406.0*z_13);
    const double z_14 = cos_q2*sin_q3;
    const double z_15 = sin_q2*cos_q3;
    const double z_16 = z_14 + z_15;
    const double z_17 = sin_q2 + (203.0/4318.0)*z_16;
    p[36] = p[47] = (1.0/10000.0)*(4318.0*z_17);
    const double z_18 = z_14*cos_q1 + z_15*cos_q1;
    p[41] = -z_18;
    const double z_19 = z_14*sin_q1 + z_15*sin_q1;
    p[42] = -z_19;
    const double z_20 = z_7 - z_9;
    p[43] = -z_20;
    p[44] = q3;
    const double z_21 = z_18 + (203.0/4318.0)*z_11;
    p[48] = p[51] = (1.0/20000.0)*(-8636.0*z_21);
    const double z_22 = z_19 + (203.0/4318.0)*z_13;
    p[49] = p[52] = ((-1.0/20000.0))*(8636.0*z_22);
    const double z_23 = z_20 - z_17;
    p[50] = p[53] = (1.0/10000.0)*(-4318.0*z_23);
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double sin_q5 = em_sin(q5);
    const double q4 = x[3];
    const double cos_q4 = em_cos(q4);
    const double sin_q4 = em_sin(q4);
    p[54] = p[57] = p[61] = (1.0/20000.0)*(4000.0*sin_q5*(cos_q4*z_10 + sin_q4*sin_q1) - 4000.0*cos_q5*z_18 -
        8636.0*z_21);
    p[55] = p[58] = p[62] = ((-1.0/20000.0))*(4000.0*cos_q5*z_19 + 8636.0*z_22 - 4000.0*sin_q5*(cos_q4*z_12 -
        sin_q4*cos_q1));
    p[56] = p[59] = p[63] = (1.0/10000.0)*(-2000.0*z_20*cos_q5 - 2000.0*z_16*sin_q5*cos_q4 - 4318.0*z_23);
    p[60] = 1.0/30.0;
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
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double cos_q2 = em_cos(q2);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_3 = cos_q2*sin_q3;
    const double cos_q3 = em_cos(q3);
    const double z_5 = sin_q2*cos_q3;
    const double z_6 = z_3 + z_5;
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double z_8 = z_6*sin_q4;
    const double z_9 = sin_q2*sin_q3;
    const double z_10 = cos_q2*cos_q3;
    const double z_11 = z_9 - z_10;
    const double z_12 = 4318.0*cos_q2 - 203.0*z_11;
    const double cos_q4 = em_cos(q4);
    const double z_14 = z_11*cos_q4;
    const double z_15 = sin_q4*z_12 - 1500.5*z_14;
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double load = c[1];
    const double sin_q5 = em_sin(q5);
    const double z_18 = z_6*sin_q5;
    const double z_19 = z_8 - (1.0/4318.0)*z_15;
    const double z_20 = 8636.0*z_19;
    const double z_21 = z_18 + (1.0/3001.0)*z_20*cos_q5;
    const double z_22 = load*(4000.0*z_8 + 3001.0*z_21);
    const double z_23 = 5760.0*z_8 + 100.0*z_22 + 129043.0*z_21;
    const double z_24 = cos_q5*z_23;
    const double z_25 = z_6*cos_q5;
    const double z_26 = sin_q5*z_20 - 3001.0*z_25;
    const double z_27 = 43.0 + 100.0*load;
    const double z_28 = sin_q5*z_27;
    const double z_29 = z_26*z_28;
    const double z_30 = z_24 + z_29;
    const double z_31 = 739312.0*z_8 + z_30 - 164.0*z_15;
    const double z_32 = sin_q4*z_31;
    const double z_33 = z_6*cos_q4;
    const double z_34 = sin_q4*z_11;
    const double z_35 = z_34 + (2.0/3001.0)*z_12*cos_q4;
    const double z_36 = sin_q5*z_11;
    const double z_37 = cos_q4*cos_q5;
    const double z_38 = z_36 - z_6*z_37;
    const double z_39 = z_33 - (3001.0/8636.0)*z_35;
    const double z_40 = load*(8636.0*z_39 - 4000.0*z_38);
    const double z_41 = z_40 - (288.0/5.0)*z_38;
    const double z_42 = 222132.0*z_33 + 20.0*z_41 - 75025.0*z_35;
    const double z_43 = cos_q4*z_42;
    const double z_44 = z_32 + 5.0*z_43;
    const double z_45 = 4318.0*sin_q2 + 203.0*z_6;
    const double z_46 = z_33 + (2.0/3001.0)*sin_q4*z_45;
    const double z_47 = 3001.0*z_46 - 8636.0*z_34;
    const double z_48 = z_36 - (1.0/3001.0)*cos_q5*z_47;
    const double z_49 = load*(4000.0*z_34 + 3001.0*z_48);
    const double z_50 = 5760.0*z_34 + 100.0*z_49 + 129043.0*z_48;
    const double z_51 = z_11*cos_q5;
    const double z_52 = 3001.0*z_51 + sin_q5*z_47;
    const double z_53 = cos_q5*z_50 - z_52*z_28;
    const double z_54 = 246082.0*z_46 - 739312.0*z_34 - z_53;
    const double z_55 = cos_q4*z_45;
    const double z_56 = z_8 + (222132.0/75025.0)*z_14;
    const double z_57 = z_18 + z_11*z_37;
    const double z_58 = z_8 + (8636.0/3001.0)*z_14;
    const double z_59 = z_55 - 1500.5*z_58;
    const double z_60 = load*(4000.0*z_57 - 2.0*z_59);
    const double z_61 = z_60 + (288.0/5.0)*z_57;
    const double z_62 = 75025.0*z_56 + 20.0*z_61 - 50.0*z_55;
    const double z_63 = sin_q4*z_54 - 5.0*cos_q4*z_62;
    const double z_64 = 625.0*z_40 + 77724.0*z_39 - 33885.0*z_38;
    const double z_65 = sin_q5*z_64;
    const double z_66 = sin_q5*cos_q4;
    const double z_67 = z_51 + z_6*z_66;
    const double z_68 = cos_q5*z_67;
    const double z_69 = sin_q4*z_42;
    const double z_70 = cos_q4*z_31;
    const double z_71 = z_69 - (1.0/5.0)*z_70;
    const double z_72 = 5725482720.0*z_11 + 13600000.0*z_68 + 406.0*z_44 - 640.0*z_65 - 15005.0*z_71;
    const double z_73 = z_3*z_72;
    const double z_74 = 625.0*z_60 + 33885.0*z_57 - 18.0*z_59;
    const double z_75 = sin_q5*z_74;
    const double z_76 = z_25 - z_11*z_66;
    const double z_77 = cos_q5*z_76;
    const double z_78 = z_6 + (85000.0/35784267.0)*z_77;
    const double z_79 = sin_q4*z_62 + (1.0/5.0)*cos_q4*z_54;
    const double z_80 = 640.0*z_75 + 5725482720.0*z_78 + 406.0*z_63 + 15005.0*z_79;
    const double z_81 = cos_q5*z_64;
    const double z_82 = sin_q5*z_67;
    const double z_83 = 497229916.0*z_33 + 32.0*z_81 + 680000.0*z_82 + 43180.0*z_41 - 166654533.0*z_35;
    const double z_84 = cos_q4*z_83;
    const double z_85 = 1690830848.0*z_8 + 100000.0*z_22 + 4321440.0*z_21 + 2159.0*z_30 - 369656.0*z_15;
    const double z_86 = sin_q4*z_85;
    const double z_87 = sin_q5*z_23;
    const double z_88 = cos_q5*z_27;
    const double z_89 = z_26*z_88;
    const double z_90 = z_87 - z_89;
    const double z_91 = 5803392000.0*cos_q2 - 9492774802.0*z_6 - 20.0*z_84 - 4.0*z_86 - 3001.0*z_90;
    const double z_92 = z_9*z_91;
    const double z_93 = sin_q5*z_76 - (166654533.0/680000.0)*(z_8 + (497229916.0/166654533.0)*z_14);
    const double z_94 = 32.0*cos_q5*z_74 + 43180.0*z_61 - 111066.0*z_55 - 680000.0*z_93;
    const double z_95 = z_49 + (27009.0/625.0)*z_48;
    const double z_96 = 554668828.0*z_46 - 1690830848.0*z_34 - 100000.0*z_95 - 2159.0*z_53;
    const double z_97 = sin_q5*z_50 + z_52*z_88;
    const double z_98 = 5803392000.0*sin_q2 + 4.0*sin_q4*z_96 - 9492774802.0*z_11 - 20.0*cos_q4*z_94 -
        3001.0*z_97;
    const double z_99 = z_10*z_91;
    const double z_100 = z_5*z_72;
    dM[36] = ((-1.0/40000000000.0))*(31520000000.0*sin_q2*cos_q2 + (z_99 - z_5*z_98) -
        4.0*(sin_q2*(70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_44 - 18759823020.0*cos_q2) -
        cos_q2*(18759823020.0*sin_q2 + 70992000.0*cos_q2 + 2159.0*z_63 - 1450848000.0*z_11)) -
        174000.0*(cos_q2*(207169.0*sin_q2 - 1632.0*cos_q2) + sin_q2*(1632.0*sin_q2 + 207169.0*cos_q2)) - (z_73 +
        z_9*z_80) - (z_92 + z_3*z_98) - (z_100 - z_10*z_80));
    const double z_101 = z_6 + (3568189.0/78792000.0)*z_11;
    const double z_102 = (sin_q4*z_94 + (1.0/5.0)*cos_q4*z_96) + 110308800.0*(z_101 + (29.0/157584000.0)*z_97);
    dM[42] = dM[37] = (1.0/20000000000.0)*(475020000.0*sin_q2 + 4318.0*cos_q3*(1821922.0*z_11 + z_97) + 10.0*z_102
        - 5383560000.0*cos_q2 - 4318.0*sin_q3*(1575840.0*z_6 + 5.0*z_79));
    dM[48] = dM[38] = (1.0/20000000000.0)*(10.0*z_102);
    const double z_103 = z_6 + (17.0/65.0)*z_77;
    dM[54] = dM[39] = ((-1.0/62500000.0))*(z_75 + 81250.0*z_103);
    dM[60] = dM[40] = ((-1.0/62500000.0))*(40135.0*z_34 + 625.0*z_95);
    dM[66] = dM[41] = ((-1.0/25000.0))*z_76;
    const double z_104 = z_8 + (3001.0/406.0)*z_33;
    const double z_105 = 406.0*z_104 - 8636.0*z_34;
    const double z_106 = z_36 - (1.0/3001.0)*cos_q5*z_105;
    const double z_107 = load*(4000.0*z_34 + 3001.0*z_106);
    const double z_108 = 5760.0*z_34 + 100.0*z_107 + 129043.0*z_106;
    const double z_109 = 3001.0*z_51 + sin_q5*z_105;
    const double z_110 = cos_q5*z_108 - z_109*z_28;
    const double z_111 = 33292.0*z_104 - 739312.0*z_34 - z_110;
    const double z_112 = z_33 - (3001.0/406.0)*z_58;
    const double z_113 = load*(4000.0*z_57 - 406.0*z_112);
    const double z_114 = z_113 + (288.0/5.0)*z_57;
    const double z_115 = 75025.0*z_56 + 20.0*z_114 - 10150.0*z_33;
    const double z_116 = sin_q4*z_111 - 5.0*cos_q4*z_115;
    const double z_117 = 625.0*z_113 + 33885.0*z_57 - 3654.0*z_112;
    const double z_118 = sin_q5*z_117;
    const double z_119 = sin_q4*z_115 + (1.0/5.0)*cos_q4*z_111;
    const double z_120 = 640.0*z_118 + 5725482720.0*z_78 + 406.0*z_116 + 15005.0*z_119;
    const double z_121 = 32.0*cos_q5*z_117 + 43180.0*z_114 - 22546398.0*z_33 - 680000.0*z_93;
    const double z_122 = z_107 + (27009.0/625.0)*z_106;
    const double z_123 = 75040168.0*z_104 - 1690830848.0*z_34 - 100000.0*z_122 - 2159.0*z_110;
    const double z_124 = sin_q5*z_108 + z_109*z_88;
    const double z_125 = 9492774802.0*z_11 + 20.0*cos_q4*z_121 + 3001.0*z_124 - 4.0*sin_q4*z_123;
    dM[72] = (1.0/40000000000.0)*(8636.0*cos_q2*(672000.0*z_11 - z_116) + (z_100 + z_9*z_120) + (z_92 - z_5*z_125)
        + (z_73 - z_10*z_120) - (z_99 + z_3*z_125));
    const double z_126 = (sin_q4*z_121 + (1.0/5.0)*cos_q4*z_123) + 110308800.0*(z_101 + (29.0/157584000.0)*z_124);
    dM[78] = dM[73] = (1.0/20000000000.0)*(4318.0*(sin_q3*(1821922.0*z_6 + z_90) + cos_q3*(1821922.0*z_11 +
        z_124)) + 10.0*z_126 - 4318.0*(cos_q3*(1575840.0*z_11 - 5.0*z_71) + sin_q3*(1575840.0*z_6 + 5.0*z_119)));
    const double z_127 = sin_q3*cos_q4;
    const double z_128 = 203.0 + 4318.0*cos_q3;
    const double z_129 = cos_q4 - z_127;
    const double z_130 = sin_q5*z_128 - 4318.0*cos_q5*z_129;
    const double z_131 = load*(2000.0*cos_q4 - z_130);
    const double z_132 = 2880.0*cos_q4 + 100.0*z_131 - 43.0*z_130;
    const double z_133 = cos_q5*z_132;
    const double z_134 = cos_q5*z_128 + 4318.0*sin_q5*z_129;
    const double z_135 = z_134*z_28;
    const double z_136 = z_133 + z_135;
    const double z_137 = 369656.0*cos_q4 + z_136 - 354076.0*z_127;
    const double z_138 = sin_q3*sin_q4;
    const double z_139 = sin_q4*cos_q5;
    const double z_140 = sin_q4 - z_138;
    const double z_141 = load*(1000.0*z_139 + 2159.0*z_140);
    const double z_142 = 55533.0*sin_q4 + 288.0*z_139 + 20.0*z_141 - 53975.0*z_138;
    const double z_143 = cos_q3*cos_q4;
    const double z_144 = sin_q3*sin_q5 - cos_q3*z_37;
    const double z_145 = load*z_144;
    const double z_146 = 43.0*z_144 + 100.0*z_145;
    const double z_147 = sin_q3*cos_q5 + cos_q3*z_66;
    const double z_148 = cos_q5*z_146 - z_147*z_28;
    const double z_149 = sin_q4*sin_q4;
    const double z_150 = sin_q5*z_132;
    const double z_151 = z_134*z_88;
    const double z_152 = sin_q5*z_146 + z_147*z_88;
    const double z_153 = 9.0 + 625.0*load;
    const double z_154 = cos_q3*sin_q4;
    const double z_155 = z_144 + (625.0/9.0)*z_145;
    const double z_156 = (sin_q4*(32.0*cos_q3*z_139*z_153 + (55533.0 + 43180.0*load)*z_154) -
        (1.0/5.0)*cos_q4*(1440.0*z_155 + 2159.0*z_148 - 184828.0*z_143)) + (203.0/10.0)*(z_152 + 82.0*(sin_q3 +
        (24000.0/1189.0)*cos_q3));
    dM[79] = ((-2159.0/5000000000.0))*((cos_q3*(336000.0 + cos_q4*z_137 + 10.0*sin_q4*z_142 - 2072640.0*sin_q3) -
        4318.0*sin_q3*(480.0*cos_q3 + cos_q4*(82.0*z_143 - z_148) + 25.0*cos_q3*(5.0 + 4.0*load)*z_149)) +
        (sin_q3*(16646.0 + 2426716.0*cos_q3 + z_151 - z_150) + 4318.0*cos_q3*(562.0*sin_q3 + z_152)) +
        10.0*z_156);
    dM[84] = dM[74] = (1.0/20000000000.0)*(10.0*z_126);
    dM[85] = dM[80] = ((-2159.0/5000000000.0))*(10.0*z_156);
    dM[90] = dM[75] = ((-1.0/62500000.0))*(z_118 + 81250.0*z_103);
    const double z_157 = sin_q5*z_153;
    dM[91] = dM[81] = (2159.0/15625000.0)*(z_157*z_154);
    dM[96] = dM[76] = ((-1.0/62500000.0))*(40135.0*z_34 + 625.0*z_122);
    dM[97] = dM[82] = (2159.0/15625000.0)*(9.0*z_155);
    dM[102] = dM[77] = ((-1.0/25000.0))*z_76;
    const double z_158 = 8636.0*z_39;
    const double z_159 = cos_q5*z_158;
    const double z_160 = load*(4000.0*z_33 + z_159);
    const double z_161 = 5760.0*z_33 + 43.0*z_159 + 100.0*z_160;
    const double z_162 = sin_q5*sin_q5;
    const double z_163 = z_27*z_162;
    const double z_164 = cos_q5*z_161 + z_158*z_163;
    const double z_165 = 739312.0*z_33 + z_164 - 246082.0*z_35;
    const double z_166 = z_6*z_139;
    const double z_167 = load*(4000.0*z_166 + 8636.0*z_19);
    const double z_168 = z_166 + (5.0/288.0)*z_167;
    const double z_169 = 222132.0*z_8 + 1152.0*z_168 - 50.0*z_15;
    const double z_170 = (z_70 + sin_q4*z_165) - 5.0*(z_69 + cos_q4*z_169);
    const double z_171 = 33885.0*z_166 + 625.0*z_167 + 77724.0*z_19;
    const double z_172 = sin_q5*z_171 - 21250.0*z_18*z_139;
    const double z_173 = (z_43 - sin_q4*z_169) + (1.0/5.0)*(z_32 - cos_q4*z_165);
    const double z_174 = 406.0*z_170 + 640.0*z_172 - 15005.0*z_173;
    const double z_175 = sin_q4*z_162;
    const double z_176 = 497229916.0*z_8 + 32.0*cos_q5*z_171 + 680000.0*z_6*z_175 + 2487168.0*z_168 -
        111066.0*z_15;
    const double z_177 = z_159 + (625.0/9.0)*z_160;
    const double z_178 = 1690830848.0*z_33 + 1440.0*z_177 + 2159.0*z_164 - 554668828.0*z_35;
    const double z_179 = sin_q5*z_161 - z_159*z_28;
    const double z_180 = 4.0*(cos_q4*z_85 + sin_q4*z_178) + 3001.0*z_179 - 20.0*(sin_q4*z_83 + cos_q4*z_176);
    dM[108] = ((-1.0/40000000000.0))*(8636.0*cos_q2*z_170 + z_10*z_174 - z_9*z_174 - z_3*z_180 - z_5*z_180);
    const double z_181 = (z_86 - cos_q4*z_178) + 101.5*(z_179 + (10.0/203.0)*(z_84 - sin_q4*z_176));
    dM[114] = dM[109] = ((-1.0/20000000000.0))*(4318.0*cos_q3*z_179 + 2.0*z_181 - 4318.0*sin_q3*(5.0*z_173));
    const double z_182 = cos_q5*z_140;
    const double z_183 = load*(1000.0*sin_q4 + 2159.0*z_182);
    const double z_184 = 1440.0*sin_q4 + 92837.0*z_182 + 100.0*z_183;
    const double z_185 = cos_q5*z_184 + 2159.0*z_140*z_163;
    const double z_186 = load*(2159.0*z_129 + 1000.0*z_37);
    const double z_187 = sin_q5*z_184 - 2159.0*z_182*z_28;
    const double z_188 = 33885.0*z_139 + 2500.0*z_141 + 77724.0*z_140;
    const double z_189 = cos_q5*z_188;
    const double z_190 = z_175 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_139);
    const double z_191 = 77724.0*z_129 + 33885.0*z_37 + 2500.0*z_186;
    const double z_192 = cos_q4*z_162 + (124307479.0/170000.0)*(cos_q4 + (621792.0/124307479.0)*z_37);
    const double z_193 = z_182 + (625.0/19431.0)*z_183;
    const double z_194 = z_187 + (10.0/203.0)*((cos_q4*(43180.0*z_141 + 8.0*z_189 + 170000.0*z_190 -
        119895747.0*z_138) + sin_q4*(43180.0*z_186 + 8.0*cos_q5*z_191 + 170000.0*z_192 - 119895747.0*z_127)) -
        (1.0/10.0)*(sin_q4*(845415424.0*cos_q4 + 100000.0*z_131 + 2159.0*z_136 - 798087304.0*z_127 - 1440.0*z_130)
        + 2.0*cos_q4*(422707712.0*sin_q4 + 3108960.0*z_193 + 2159.0*z_185 - 399043652.0*z_138)));
    dM[115] = (1.0/5000000000.0)*(2159.0*sin_q3*((sin_q4*z_137 + 2.0*cos_q4*(184828.0*sin_q4 + z_185 -
        177038.0*z_138)) - 10.0*(cos_q4*z_142 + sin_q4*(55533.0*cos_q4 + 288.0*z_37 + 20.0*z_186 -
        53975.0*z_127))) + 4318.0*cos_q3*z_187 + 203.0*z_194);
    dM[120] = dM[110] = ((-1.0/20000000000.0))*(2.0*z_181);
    dM[121] = dM[116] = (1.0/5000000000.0)*(203.0*z_194);
    const double z_195 = load*(2159.0*sin_q4 + 1000.0*z_139);
    const double z_196 = 77724.0*sin_q4 + 33885.0*z_139 + 2500.0*z_195;
    const double z_197 = cos_q5*z_196;
    const double z_198 = load*(2159.0*cos_q4 + 1000.0*z_37);
    const double z_199 = 77724.0*cos_q4 + 33885.0*z_37 + 2500.0*z_198;
    const double z_200 = sin_q5 - (4318.0/203.0)*z_37;
    const double z_201 = load*(203.0*z_200 - 2000.0*cos_q4);
    const double z_202 = 100.0*z_201 + 8729.0*z_200 - 2880.0*cos_q4;
    const double z_203 = cos_q5*z_202;
    const double z_204 = cos_q5 + (4318.0/203.0)*z_66;
    const double z_205 = 203.0*z_204;
    const double z_206 = z_205*z_28;
    const double z_207 = load*(1000.0*sin_q4 + 2159.0*z_139);
    const double z_208 = 1440.0*sin_q4 + 92837.0*z_139 + 100.0*z_207;
    const double z_209 = z_139 + (625.0/19431.0)*z_207;
    dM[122] = (1.0/5000000000.0)*(10.0*(cos_q4*(43180.0*z_195 + 8.0*z_197 + 170000.0*z_190) +
        sin_q4*(43180.0*z_198 + 8.0*cos_q5*z_199 + 170000.0*z_192)) + (sin_q4*(100000.0*z_201 + 2159.0*z_203 +
        292320.0*z_200 - 845415424.0*cos_q4 - 2159.0*z_206) - 2.0*cos_q4*(422707712.0*sin_q4 + 2159.0*cos_q5*z_208
        + 4661281.0*z_27*z_175 + 3108960.0*z_209)) + 203.0*sin_q5*z_208 - 438277.0*z_139*z_28);
    dM[126] = dM[111] = ((-1.0/62500000.0))*z_172;
    const double z_210 = cos_q5*z_66;
    dM[127] = dM[117] = ((-1.0/62500000.0))*(sin_q5*z_191 - 21250.0*z_210);
    dM[128] = dM[123] = (1.0/62500000.0)*(21250.0*z_210 - sin_q5*z_199);
    dM[132] = dM[112] = (1.0/62500000.0)*(40135.0*z_33 + 9.0*z_177);
    dM[133] = dM[118] = ((-1.0/62500000.0))*(40135.0*sin_q4 + 77724.0*z_193);
    dM[134] = dM[124] = ((-1.0/62500000.0))*(40135.0*sin_q4 + 77724.0*z_209);
    dM[138] = dM[113] = (1.0/25000.0)*(z_18*sin_q4);
    dM[139] = dM[119] = (1.0/25000.0)*z_66;
    dM[140] = dM[125] = (1.0/25000.0)*z_66;
    const double z_211 = load*z_26;
    const double z_212 = 43.0*z_26 + 100.0*z_211;
    const double z_213 = 3001.0*z_21;
    const double z_214 = (z_87 + cos_q5*z_212) - (z_89 + z_213*z_28);
    const double z_215 = load*z_67;
    const double z_216 = z_67 + (625.0/9.0)*z_215;
    const double z_217 = 9.0*z_216;
    const double z_218 = sin_q4*z_214 + 640.0*cos_q4*z_217;
    const double z_219 = 6777.0*z_67 + 500000.0*z_215;
    const double z_220 = (z_81 - 5.0*sin_q5*z_219) + 21250.0*(z_82 + cos_q5*z_38);
    const double z_221 = sin_q4*z_217 - (1.0/640.0)*cos_q4*z_214;
    const double z_222 = 406.0*z_218 + 640.0*z_220 - 1920640.0*z_221;
    const double z_223 = (z_65 + 5.0*cos_q5*z_219) + 77724.0*z_216 - 21250.0*(z_68 - sin_q5*z_38);
    const double z_224 = z_26 + (625.0/9.0)*z_211;
    const double z_225 = 2159.0*z_214 + 1440.0*z_224;
    const double z_226 = (z_24 - sin_q5*z_212) + (z_29 - z_213*z_88);
    const double z_227 = 3001.0*z_226 - 640.0*cos_q4*z_223 - 4.0*sin_q4*z_225;
    dM[144] = (1.0/40000000000.0)*(8636.0*cos_q2*z_218 + z_3*z_227 + z_5*z_227 + z_10*z_222 - z_9*z_222);
    const double z_228 = cos_q4*z_225 + 101.5*(z_226 - (320.0/203.0)*sin_q4*z_223);
    dM[150] = dM[145] = ((-1.0/20000000000.0))*(4318.0*cos_q3*z_226 + 4318.0*sin_q3*(640.0*z_221) + 2.0*z_228);
    const double z_229 = load*z_134;
    const double z_230 = 43.0*z_134 + 100.0*z_229;
    const double z_231 = (z_150 + cos_q5*z_230) - (z_151 - z_130*z_28);
    const double z_232 = (z_133 - sin_q5*z_230) + (z_135 + z_130*z_88);
    const double z_233 = sin_q5*z_139;
    const double z_234 = 6777.0 + 500000.0*load;
    const double z_235 = z_233*z_234;
    const double z_236 = z_233 - (127.0/625.0)*sin_q4*z_157;
    const double z_237 = z_134 + (625.0/9.0)*z_229;
    const double z_238 = z_232 - (160.0/203.0)*(sin_q4*(42500.0*z_236 - (sin_q5*z_188 + 5.0*z_235)) -
        (1.0/80.0)*cos_q4*(2159.0*z_231 + 1440.0*z_237));
    dM[151] = (1.0/10000000000.0)*(4318.0*sin_q3*(cos_q4*z_231 + 320.0*z_149*z_157) - 4318.0*cos_q3*z_232 -
        203.0*z_238);
    dM[156] = dM[146] = ((-1.0/20000000000.0))*(2.0*z_228);
    dM[157] = dM[152] = ((-1.0/10000000000.0))*(203.0*z_238);
    const double z_239 = load*z_205;
    const double z_240 = 100.0*z_239 + 8729.0*z_204;
    const double z_241 = 203.0*z_200;
    const double z_242 = z_239 + (1827.0/625.0)*z_204;
    dM[158] = (1.0/10000000000.0)*(160.0*sin_q4*(42500.0*z_236 - (sin_q5*z_196 + 5.0*z_235)) + 203.0*(z_203 +
        sin_q5*z_240) - 2.0*cos_q4*(100000.0*z_242 - 2159.0*(sin_q5*z_202 - cos_q5*z_240) - 2159.0*(z_205*z_88 -
        z_241*z_28)) - 203.0*(z_206 + z_241*z_88));
    dM[162] = dM[147] = (1.0/62500000.0)*z_220;
    const double z_243 = z_175*z_234;
    const double z_244 = z_175 - sin_q4*(cos_q5*cos_q5);
    dM[163] = dM[153] = ((-1.0/62500000.0))*((z_189 - 5.0*z_243) + 21250.0*z_244);
    dM[164] = dM[159] = ((-1.0/62500000.0))*(21250.0*z_244 + (z_197 - 5.0*z_243));
    dM[165] = ((-1.0/6250000.0))*(sin_q5*cos_q5*(4250.0 - z_234));
    dM[168] = dM[148] = ((-1.0/62500000.0))*(9.0*z_224);
    dM[169] = dM[154] = ((-1.0/31250000.0))*(9.0*z_237);
    dM[170] = dM[160] = ((-1.0/31250000.0))*(625.0*z_242);
    dM[174] = dM[149] = (1.0/25000.0)*z_38;
    dM[175] = dM[155] = (1.0/25000.0)*z_139;
    dM[176] = dM[161] = (1.0/25000.0)*z_139;
    dM[177] = dM[167] = ((-1.0/25000.0))*sin_q5;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double q2_dot = v[1];
    const double q1_dot = v[0];
    const double z_1 = q1_dot*sin_q2;
    const double z_2 = q2_dot*z_1;
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_4 = q2_dot*sin_q3;
    const double cos_q2 = em_cos(q2);
    const double z_6 = q1_dot*cos_q2;
    const double q3_dot = v[2];
    const double cos_q3 = em_cos(q3);
    const double z_8 = q3_dot*cos_q3;
    const double z_9 = q2_dot*cos_q3;
    const double z_10 = q3_dot*sin_q3;
    const double z_11 = (z_4*z_1 - z_6*z_8) - (z_6*z_9 - z_1*z_10);
    const double z_12 = 350.0*z_11 - 2159.0*z_2;
    const double z_13 = q2_dot*z_6;
    const double z_14 = 34.0*z_2 + 3.0*z_13;
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double z_16 = q2_dot + q3_dot;
    const double z_17 = sin_q4*z_16;
    const double cos_q4 = em_cos(q4);
    const double z_19 = sin_q3*z_6;
    const double z_20 = cos_q3*z_1;
    const double z_21 = z_19 + z_20;
    const double z_22 = cos_q4*z_21;
    const double z_23 = z_17 - z_22;
    const double z_24 = sin_q3*z_1;
    const double z_25 = cos_q3*z_6;
    const double z_26 = z_24 - z_25;
    const double z_27 = z_26 - (8636.0/3001.0)*z_4;
    const double z_28 = 3001.0*z_27;
    const double z_29 = sin_q4*z_28;
    const double z_30 = 203.0*z_26 - 4318.0*z_6;
    const double z_31 = cos_q4*z_30;
    const double z_32 = z_29 - 2.0*z_31;
    const double z_33 = z_23 + (1.0/9016.0)*z_32;
    const double z_34 = 9016.0*z_33;
    const double z_35 = z_23 + (1.0/8636.0)*z_32;
    const double z_36 = 8636.0*z_35;
    const double q6 = x[5];
    const double cos_q6 = em_cos(q6);
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double sin_q5 = em_sin(q5);
    const double q4_dot = v[3];
    const double z_40 = q4_dot - z_26;
    const double z_41 = cos_q5*z_23 - sin_q5*z_40;
    const double z_42 = z_41*cos_q6;
    const double q5_dot = v[4];
    const double z_43 = cos_q4*z_16;
    const double z_44 = sin_q4*z_21;
    const double z_45 = z_43 + z_44;
    const double z_46 = q5_dot + z_45;
    const double sin_q6 = em_sin(q6);
    const double z_48 = z_46*sin_q6;
    const double z_49 = z_42 + z_48;
    const double z_50 = cos_q6*z_36;
    const double z_51 = cos_q4*z_28;
    const double z_52 = sin_q4*z_30;
    const double z_53 = z_51 + 2.0*z_52;
    const double z_54 = z_45 + (1.0/8636.0)*z_53;
    const double z_55 = 8636.0*z_54;
    const double z_56 = cos_q5*z_55;
    const double z_57 = z_21 - (8636.0/3001.0)*z_9;
    const double z_58 = 406.0*z_16 - 3001.0*z_57;
    const double z_59 = sin_q5*z_58;
    const double z_60 = z_56 - z_59;
    const double z_61 = sin_q6*z_60;
    const double z_62 = z_50 + z_61;
    const double z_63 = z_49 + (1.0/640.0)*z_62;
    const double z_64 = 640.0*z_63;
    const double load = c[1];
    const double z_65 = z_49 + (1.0/4000.0)*z_62;
    const double z_66 = load*(4000.0*z_65);
    const double z_67 = 9.0*z_64 + 100.0*z_66;
    const double z_68 = cos_q6*z_67;
    const double z_69 = z_41*sin_q6;
    const double z_70 = z_46*cos_q6;
    const double z_71 = z_69 - z_70;
    const double z_72 = cos_q6*z_60;
    const double z_73 = sin_q6*z_36;
    const double z_74 = z_72 - z_73;
    const double z_75 = z_71 - (1.0/640.0)*z_74;
    const double z_76 = 640.0*z_75;
    const double z_77 = z_71 - (1.0/4000.0)*z_74;
    const double z_78 = load*(4000.0*z_77);
    const double z_79 = 9.0*z_76 + 100.0*z_78;
    const double z_80 = sin_q6*z_79;
    const double z_81 = z_68 + z_80;
    const double z_82 = 34.0*z_36 + z_81;
    const double z_83 = 82.0*z_34 + z_82;
    const double z_84 = q4_dot*sin_q4;
    const double z_85 = q4_dot*cos_q4;
    const double z_86 = z_16*z_85 + (z_21*z_84 + cos_q4*z_11);
    const double z_87 = (z_6*z_4 + z_1*z_8) + (z_9*z_1 + z_6*z_10);
    const double z_88 = q3_dot*z_9;
    const double z_89 = 3001.0*z_87 - 8636.0*z_88;
    const double z_90 = 203.0*z_87 + 4318.0*z_2;
    const double z_91 = (z_28*z_85 + sin_q4*z_89) + 2.0*(z_30*z_84 - cos_q4*z_90);
    const double z_92 = 9016.0*z_86 + z_91;
    const double z_93 = 8636.0*z_86 + z_91;
    const double q6_dot = v[5];
    const double z_94 = q6_dot*sin_q6;
    const double z_95 = q5_dot*sin_q5;
    const double z_96 = z_23*z_95;
    const double z_97 = cos_q5*z_86;
    const double z_98 = q5_dot*cos_q5;
    const double z_99 = z_40*z_98;
    const double z_100 = sin_q5*z_87;
    const double z_101 = (z_96 - z_97) + (z_99 - z_100);
    const double z_102 = cos_q6*z_101;
    const double z_103 = z_41*z_94;
    const double z_104 = z_16*z_84 - (z_21*z_85 - sin_q4*z_11);
    const double z_105 = sin_q6*z_104;
    const double z_106 = q6_dot*cos_q6;
    const double z_107 = z_46*z_106;
    const double z_108 = (z_102 + z_103) + (z_105 - z_107);
    const double z_109 = cos_q6*z_93;
    const double z_110 = (z_28*z_84 - cos_q4*z_89) - 2.0*(z_30*z_85 + sin_q4*z_90);
    const double z_111 = 8636.0*z_104 + z_110;
    const double z_112 = q3_dot*z_4;
    const double z_113 = 3001.0*z_11 - 8636.0*z_112;
    const double z_114 = (z_55*z_95 + cos_q5*z_111) + (z_58*z_98 + sin_q5*z_113);
    const double z_115 = sin_q6*z_114;
    const double z_116 = (z_36*z_94 - z_109) - (z_60*z_106 - z_115);
    const double z_117 = 640.0*z_108 + z_116;
    const double z_118 = load*(4000.0*z_108 + z_116);
    const double z_119 = 9.0*z_117 + 100.0*z_118;
    const double z_120 = sin_q6*z_101;
    const double z_121 = z_41*z_106;
    const double z_122 = cos_q6*z_104;
    const double z_123 = z_46*z_94;
    const double z_124 = (z_120 - z_121) - (z_122 + z_123);
    const double z_125 = cos_q6*z_114;
    const double z_126 = sin_q6*z_93;
    const double z_127 = (z_60*z_94 + z_125) + (z_36*z_106 + z_126);
    const double z_128 = 640.0*z_124 - z_127;
    const double z_129 = load*(4000.0*z_124 - z_127);
    const double z_130 = 9.0*z_128 + 100.0*z_129;
    const double z_131 = 34.0*z_93 + (z_79*z_106 - sin_q6*z_130) - (z_67*z_94 + cos_q6*z_119);
    const double z_132 = 82.0*z_92 + z_131;
    const double z_133 = z_45 + (1.0/9016.0)*z_53;
    const double z_134 = 9016.0*z_133;
    const double z_135 = 43.0 + 100.0*load;
    const double z_136 = cos_q5*z_58;
    const double z_137 = sin_q5*z_55;
    const double z_138 = z_136 + z_137;
    const double z_139 = z_135*z_138;
    const double z_140 = sin_q6*z_67;
    const double z_141 = cos_q6*z_79;
    const double z_142 = z_140 - z_141;
    const double z_143 = 34.0*z_60 + z_142;
    const double z_144 = sin_q5*z_139 + cos_q5*z_143;
    const double z_145 = 82.0*z_134 + z_144;
    const double z_146 = 9016.0*z_104 + z_110;
    const double z_147 = (z_58*z_95 - cos_q5*z_113) - (z_55*z_98 - sin_q5*z_111);
    const double z_148 = sin_q5*z_135;
    const double z_149 = 34.0*z_114 - (z_67*z_106 - sin_q6*z_119) - (z_79*z_94 + cos_q6*z_130);
    const double z_150 = (z_98*z_139 - z_147*z_148) - (z_143*z_95 + cos_q5*z_149);
    const double z_151 = 82.0*z_146 - z_150;
    const double z_152 = (z_83*z_84 - cos_q4*z_132) + (z_145*z_85 - sin_q4*z_151);
    const double q2_ddot = a[1];
    const double z_153 = z_26 - (8636.0/3283.0)*z_4;
    const double z_154 = 1400.0*z_16 + 3283.0*z_153;
    const double z_155 = sin_q4*z_145;
    const double z_156 = cos_q4*z_83 - z_155;
    const double z_157 = sin_q4*z_83;
    const double z_158 = cos_q4*z_145;
    const double z_159 = z_157 + z_158;
    const double z_160 = 9375.0*z_71 + 9.0*z_76 + 625.0*z_78;
    const double z_161 = sin_q6*z_160;
    const double z_162 = 9375.0*z_49 + 9.0*z_64 + 625.0*z_66;
    const double z_163 = cos_q6*z_162;
    const double z_164 = z_161 + z_163;
    const double z_165 = 18750.0*z_41 + z_164;
    const double z_166 = sin_q5*z_23;
    const double z_167 = cos_q5*z_40;
    const double z_168 = z_166 + z_167;
    const double z_169 = 2.0*(q6_dot + z_168) + 15.0*z_168;
    const double z_170 = sin_q5*z_165 - 1250.0*cos_q5*z_169;
    const double z_171 = 500000000.0*z_26 + 1575840.0*z_154 + 3001.0*z_159 - 406.0*z_156 - 640.0*(81250.0*z_40 -
        z_170);
    const double z_172 = 3283.0*z_87 - 8636.0*z_88;
    const double z_173 = (z_83*z_85 + sin_q4*z_132) - (z_145*z_84 + cos_q4*z_151);
    const double z_174 = 9375.0*z_124 + 9.0*z_128 + 625.0*z_129;
    const double z_175 = 9375.0*z_108 + 9.0*z_117 + 625.0*z_118;
    const double z_176 = 18750.0*z_101 + (z_162*z_94 + cos_q6*z_175) - (z_160*z_106 - sin_q6*z_174);
    const double z_177 = z_23*z_98;
    const double z_178 = sin_q5*z_86;
    const double z_179 = z_40*z_95;
    const double z_180 = cos_q5*z_87;
    const double z_181 = (z_177 + z_178) - (z_179 + z_180);
    const double z_182 = 500000000.0*z_87 + 1575840.0*z_172 + 406.0*z_152 + 3001.0*z_173 + 640.0*(81250.0*z_87 +
        (z_165*z_98 - sin_q5*z_176) + 1250.0*(z_169*z_95 - 17.0*cos_q5*z_181));
    const double z_183 = 3283.0*z_11 - 8636.0*z_112;
    const double z_184 = cos_q5*z_135;
    const double z_185 = 82.0*z_113 - (z_95*z_139 + z_184*z_147) - (z_143*z_98 - sin_q5*z_149);
    const double z_186 = cos_q5*z_165 + 1250.0*sin_q5*z_169;
    const double z_187 = 184828.0*z_34 + 2159.0*z_82 + 160.0*(112500.0*z_23 + z_186);
    const double z_188 = 184828.0*z_92 + 2159.0*z_131 + 160.0*(112500.0*z_86 + 1250.0*(z_169*z_98 +
        17.0*sin_q5*z_181) - (z_165*z_95 + cos_q5*z_176));
    const double z_189 = cos_q6*z_160;
    const double z_190 = sin_q6*z_162;
    const double z_191 = z_189 - z_190;
    const double z_192 = 18000000.0*z_45 + 184828.0*z_134 + 2159.0*z_144 + 160.0*(25000.0*z_46 - z_191);
    const double z_193 = 18000000.0*z_104 + 184828.0*z_146 + 160.0*(25000.0*z_104 - (z_160*z_94 + cos_q6*z_174) -
        (z_162*z_106 - sin_q6*z_175)) - 2159.0*z_150;
    const double z_194 = 2688000.0*z_12 + 1575840.0*z_183 + 3001.0*z_185 + 4.0*(660000000.0*z_11 - (z_187*z_84 -
        cos_q4*z_188) - (z_192*z_85 - sin_q4*z_193));
    const double z_195 = 350.0*z_21 - 2159.0*z_6;
    const double z_196 = z_21 - (8636.0/3283.0)*z_9;
    const double z_197 = 3283.0*z_196;
    const double z_198 = cos_q5*z_139;
    const double z_199 = sin_q5*z_143;
    const double z_200 = z_198 - z_199;
    const double z_201 = 82.0*z_58 + z_200;
    const double z_202 = cos_q4*z_187 - sin_q4*z_192;
    const double z_203 = 2688000.0*z_195 + 1575840.0*z_197 + 4.0*(660000000.0*z_21 - z_202) - 3001.0*z_201;
    const double z_204 = 34.0*z_6 - 3.0*z_1;
    const double z_205 = 48.0*z_204 + 455.0*(136.0*q2_dot - 455.0*z_1);
    const double z_206 = q1_dot*q2_dot;
    const double z_207 = 3.0*sin_q2 - 34.0*cos_q2;
    const double z_208 = 207025.0*sin_q2 + 48.0*z_207;
    const double z_209 = cos_q2*sin_q3;
    const double z_210 = sin_q2*cos_q3;
    const double z_211 = z_209 + z_210;
    const double z_212 = z_211*sin_q4;
    const double z_213 = sin_q2*sin_q3;
    const double z_214 = cos_q2*cos_q3;
    const double z_215 = z_213 - z_214;
    const double z_216 = z_215*cos_q4;
    const double z_217 = cos_q2 - (203.0/4318.0)*z_215;
    const double z_218 = 4318.0*z_217;
    const double z_219 = 3001.0*z_216 - 2.0*sin_q4*z_218;
    const double z_220 = 8636.0*z_212 + z_219;
    const double z_221 = 3001.0*z_211*z_184 - z_220*z_148;
    const double z_222 = z_211*sin_q5;
    const double z_223 = 3001.0*z_222 + cos_q5*z_220;
    const double z_224 = sin_q5*z_215;
    const double z_225 = cos_q4*cos_q5;
    const double z_226 = z_211*z_225;
    const double z_227 = z_224 - z_226;
    const double z_228 = cos_q6*z_227 + z_212*sin_q6;
    const double z_229 = z_211*cos_q4;
    const double z_230 = sin_q4*z_215;
    const double z_231 = 3001.0*z_230 + 2.0*cos_q4*z_218;
    const double z_232 = 8636.0*z_229 - z_231;
    const double z_233 = cos_q6*z_232 - sin_q6*z_223;
    const double z_234 = load*(4000.0*z_228 - z_233);
    const double z_235 = 640.0*z_228 - z_233;
    const double z_236 = 100.0*z_234 + 9.0*z_235;
    const double z_237 = sin_q6*z_227 - z_212*cos_q6;
    const double z_238 = cos_q6*z_223 + sin_q6*z_232;
    const double z_239 = load*(4000.0*z_237 - z_238);
    const double z_240 = 640.0*z_237 - z_238;
    const double z_241 = 100.0*z_239 + 9.0*z_240;
    const double z_242 = 34.0*z_223 + sin_q6*z_236 - cos_q6*z_241;
    const double z_243 = 246082.0*z_211 + cos_q5*z_221 + sin_q5*z_242;
    const double z_244 = 2159.0*cos_q2 - 350.0*z_211;
    const double z_245 = 9016.0*z_229 - z_231;
    const double z_246 = 34.0*z_232 - cos_q6*z_236 - sin_q6*z_241;
    const double z_247 = z_215*cos_q5;
    const double z_248 = sin_q5*cos_q4;
    const double z_249 = z_211*z_248;
    const double z_250 = z_247 + z_249;
    const double z_251 = sin_q5*z_250;
    const double z_252 = 9375.0*z_237 + 625.0*z_239 + 9.0*z_240;
    const double z_253 = 9375.0*z_228 + 625.0*z_234 + 9.0*z_235;
    const double z_254 = 18750.0*z_227 + sin_q6*z_252 + cos_q6*z_253;
    const double z_255 = 184828.0*z_245 + 2159.0*z_246 + 160.0*(112500.0*z_229 + 21250.0*z_251 - cos_q5*z_254);
    const double z_256 = 9016.0*z_212 + z_219;
    const double z_257 = sin_q5*z_221 - cos_q5*z_242;
    const double z_258 = 184828.0*z_256 + 160.0*(137500.0*z_212 + sin_q6*z_253 - cos_q6*z_252) - 2159.0*z_257;
    const double z_259 = 5173482720.0*z_211 + 3001.0*z_243 + 4.0*(660000000.0*z_211 + cos_q4*z_255 + sin_q4*z_258)
        - 2688000.0*z_244;
    const double z_260 = q1_dot*cos_q3;
    const double z_261 = q2_dot*z_260;
    const double z_262 = q3_dot*z_260;
    const double z_263 = 82.0*z_245 + z_246;
    const double z_264 = 82.0*z_256 - z_257;
    const double z_265 = cos_q4*z_263 + sin_q4*z_264;
    const double z_266 = sin_q4*z_263 - cos_q4*z_264;
    const double z_267 = cos_q5*z_250;
    const double z_268 = 5173482720.0*z_215 + 406.0*z_265 + 640.0*(862500.0*z_215 + 21250.0*z_267 + sin_q5*z_254)
        - 3001.0*z_266;
    const double z_269 = q1_dot*sin_q3;
    const double z_270 = q3_dot*z_269;
    const double z_271 = q2_dot*z_269;
    const double z_272 = q2_dot*sin_q2;
    const double z_273 = q2_dot*cos_q2;
    const double z_274 = 3.0*z_273 + 34.0*z_272;
    const double z_275 = sin_q2*z_4;
    const double z_276 = cos_q2*z_8;
    const double z_277 = cos_q2*z_9;
    const double z_278 = sin_q2*z_10;
    const double z_279 = z_275 + z_278 - z_276 - z_277;
    const double z_280 = z_211*z_84 + cos_q4*z_279;
    const double z_281 = cos_q2*z_4;
    const double z_282 = sin_q2*z_8;
    const double z_283 = sin_q2*z_9;
    const double z_284 = cos_q2*z_10;
    const double z_285 = z_281 + z_282 + z_283 + z_284;
    const double z_286 = 4318.0*z_272 + 203.0*z_285;
    const double z_287 = 3001.0*z_215*z_85 + 3001.0*sin_q4*z_285 - 2.0*z_84*z_218 - 2.0*cos_q4*z_286;
    const double z_288 = 9016.0*z_280 + z_287;
    const double z_289 = 8636.0*z_280 + z_287;
    const double z_290 = z_215*z_98 + q5_dot*z_249 + cos_q5*z_280 + sin_q5*z_285;
    const double z_291 = z_211*z_85 - sin_q4*z_279;
    const double z_292 = z_227*z_94 - z_212*z_106 - cos_q6*z_290 - sin_q6*z_291;
    const double z_293 = 3001.0*z_215*z_84 + 2.0*z_85*z_218 - 3001.0*cos_q4*z_285 - 2.0*sin_q4*z_286;
    const double z_294 = 8636.0*z_291 - z_293;
    const double z_295 = 3001.0*z_211*z_98 + cos_q5*z_294 - z_95*z_220 - 3001.0*sin_q5*z_279;
    const double z_296 = z_94*z_232 + z_106*z_223 + cos_q6*z_289 + sin_q6*z_295;
    const double z_297 = load*(4000.0*z_292 - z_296);
    const double z_298 = 640.0*z_292 - z_296;
    const double z_299 = 100.0*z_297 + 9.0*z_298;
    const double z_300 = z_227*z_106 + z_212*z_94 + sin_q6*z_290 - cos_q6*z_291;
    const double z_301 = z_94*z_223 + sin_q6*z_289 - z_106*z_232 - cos_q6*z_295;
    const double z_302 = load*(4000.0*z_300 + z_301);
    const double z_303 = 640.0*z_300 + z_301;
    const double z_304 = 100.0*z_302 + 9.0*z_303;
    const double z_305 = z_94*z_236 + cos_q6*z_299 - z_106*z_241 - 34.0*z_289 - sin_q6*z_304;
    const double z_306 = 82.0*z_288 - z_305;
    const double z_307 = 9016.0*z_291 - z_293;
    const double z_308 = z_135*z_95;
    const double z_309 = z_135*z_98;
    const double z_310 = 3001.0*z_211*z_308 + z_220*z_309 + 3001.0*z_184*z_279 + z_294*z_148;
    const double z_311 = z_106*z_236 + z_94*z_241 + 34.0*z_295 - sin_q6*z_299 - cos_q6*z_304;
    const double z_312 = z_98*z_221 + z_95*z_242 - sin_q5*z_310 - cos_q5*z_311;
    const double z_313 = 82.0*z_307 - z_312;
    const double z_314 = z_84*z_263 + cos_q4*z_306 - z_85*z_264 - sin_q4*z_313;
    const double z_315 = 2159.0*z_272 - 350.0*z_279;
    const double z_316 = 9005587500.0*z_272 + 23664000.0*z_274 + 4145280.0*z_315 - 2159.0*z_314;
    const double z_317 = z_95*z_221 + 246082.0*z_279 + cos_q5*z_310 - z_98*z_242 - sin_q5*z_311;
    const double z_318 = 9375.0*z_300 + 625.0*z_302 + 9.0*z_303;
    const double z_319 = 9375.0*z_292 + 625.0*z_297 + 9.0*z_298;
    const double z_320 = z_106*z_252 + 18750.0*z_290 + sin_q6*z_318 - z_94*z_253 - cos_q6*z_319;
    const double z_321 = z_215*z_95 + sin_q5*z_280 - z_229*z_98 - cos_q5*z_285;
    const double z_322 = 184828.0*z_288 - 2159.0*z_305 - 160.0*(21250.0*z_250*z_98 + z_95*z_254 - 112500.0*z_280 -
        cos_q5*z_320 - 21250.0*sin_q5*z_321);
    const double z_323 = z_94*z_252 + z_106*z_253 + 25000.0*z_291 - cos_q6*z_318 - sin_q6*z_319;
    const double z_324 = 18000000.0*z_291 + 184828.0*z_307 + 160.0*z_323 - 2159.0*z_312;
    const double z_325 = 5173482720.0*z_279 + 3001.0*z_317 + 4.0*(z_84*z_255 + 660000000.0*z_279 + cos_q4*z_322 -
        z_85*z_258 - sin_q4*z_324) - 2688000.0*z_315;
    const double z_326 = z_85*z_263 + z_84*z_264 - sin_q4*z_306 - cos_q4*z_313;
    const double z_327 = 21250.0*z_250*z_95 + 21250.0*cos_q5*z_321 - z_98*z_254 - 81250.0*z_285 - sin_q5*z_320;
    const double z_328 = 5673482720.0*z_285 - 406.0*z_314 - 3001.0*z_326 - 640.0*z_327;
    const double z_329 = 4318.0*z_217;
    const double z_330 = z_230 + (2.0/3001.0)*z_329*cos_q4;
    const double z_331 = z_229 - (3001.0/8636.0)*z_330;
    const double z_332 = load*(8636.0*z_331 - 4000.0*z_227);
    const double z_333 = 625.0*z_332 + 77724.0*z_331 - 33885.0*z_227;
    const double z_334 = sin_q4*z_329 - 1500.5*z_216;
    const double z_335 = 8636.0*z_212 - 2.0*z_334;
    const double z_336 = z_222 + (1.0/3001.0)*z_335*cos_q5;
    const double z_337 = load*(4000.0*z_212 + 3001.0*z_336);
    const double z_338 = 5760.0*z_212 + 100.0*z_337 + 129043.0*z_336;
    const double z_339 = z_211*cos_q5;
    const double z_340 = sin_q5*z_335 - 3001.0*z_339;
    const double z_341 = cos_q5*z_338 + z_340*z_148;
    const double z_342 = 739312.0*z_212 + z_341 - 164.0*z_334;
    const double z_343 = z_332 - (288.0/5.0)*z_227;
    const double z_344 = 222132.0*z_229 + 20.0*z_343 - 75025.0*z_330;
    const double z_345 = sin_q4*z_342 + 5.0*cos_q4*z_344;
    const double z_346 = sin_q4*z_344 - (1.0/5.0)*cos_q4*z_342;
    const double z_347 = 5725482720.0*z_215 + 13600000.0*z_267 + 406.0*z_345 - 640.0*sin_q5*z_333 - 15005.0*z_346;
    const double q1_ddot = a[0];
    const double z_348 = cos_q3*q1_ddot;
    const double z_349 = 497229916.0*z_229 + 32.0*cos_q5*z_333 + 680000.0*z_251 + 43180.0*z_343 -
        166654533.0*z_330;
    const double z_350 = 1690830848.0*z_212 + 100000.0*z_337 + 4321440.0*z_336 + 2159.0*z_341 - 369656.0*z_334;
    const double z_351 = sin_q5*z_338 - z_340*z_184;
    const double z_352 = 5803392000.0*cos_q2 - 9492774802.0*z_211 - 20.0*cos_q4*z_349 - 4.0*sin_q4*z_350 -
        3001.0*z_351;
    const double z_353 = sin_q3*q1_ddot;
    const double z_354 = z_210*q1_ddot + cos_q2*z_353;
    const double z_355 = sin_q2*q1_ddot;
    const double z_356 = cos_q2*q1_ddot;
    const double q3_ddot = a[2];
    const double z_357 = q2_ddot + q3_ddot;
    const double z_358 = sin_q4*z_357;
    const double z_359 = z_358 - cos_q4*z_354;
    const double z_360 = sin_q3*q2_ddot;
    const double z_361 = z_214*q1_ddot - sin_q2*z_353;
    const double z_362 = 8636.0*z_360 + 3001.0*z_361;
    const double z_363 = 203.0*z_361 + 4318.0*z_356;
    const double z_364 = sin_q4*z_362 - 2.0*cos_q4*z_363;
    const double q4_ddot = a[3];
    const double z_365 = q4_ddot + z_361;
    const double z_366 = cos_q5*z_359 - sin_q5*z_365;
    const double z_367 = z_359 - (1.0/8636.0)*z_364;
    const double z_368 = load*(4000.0*z_366 + 8636.0*z_367);
    const double z_369 = z_366 + (5.0/288.0)*z_368;
    const double z_370 = 222132.0*z_359 + 1152.0*z_369 - 25.0*z_364;
    const double z_371 = cos_q4*z_357;
    const double z_372 = z_371 + sin_q4*z_354;
    const double z_373 = cos_q4*z_362 + 2.0*sin_q4*z_363;
    const double z_374 = cos_q3*q2_ddot;
    const double z_375 = z_357 + (4318.0/203.0)*z_374;
    const double z_376 = 406.0*z_375 - 3001.0*z_354;
    const double z_377 = 8636.0*z_372 - z_373;
    const double z_378 = z_184*z_376 + z_377*z_148;
    const double z_379 = sin_q5*z_376 - cos_q5*z_377;
    const double q5_ddot = a[4];
    const double z_380 = q5_ddot + z_372;
    const double z_381 = load*(4000.0*z_380 - z_379);
    const double z_382 = 100.0*z_381 + 5760.0*z_380 - 43.0*z_379;
    const double z_383 = sin_q5*z_378 + cos_q5*z_382;
    const double z_384 = 739312.0*z_372 + z_383 - 82.0*z_373;
    const double z_385 = 5.0*cos_q4*z_370 - sin_q4*z_384;
    const double q6_ddot = a[5];
    const double z_386 = 2.0*q6_ddot + 17.0*sin_q5*z_359 + 17.0*cos_q5*z_365;
    const double z_387 = 33885.0*z_366 + 625.0*z_368 + 77724.0*z_367;
    const double z_388 = z_360 - (350.0/2159.0)*z_357;
    const double z_389 = -52000000.0*q4_ddot - 5725482720.0*z_361 - (800000.0*cos_q5*z_386 - 640.0*sin_q5*z_387 -
        15005.0*sin_q4*z_370 - 3001.0*cos_q4*z_384) - 406.0*z_385 - 13608954240.0*z_388;
    const double z_390 = 497229916.0*z_359 + 2487168.0*z_369 - 55533.0*z_364;
    const double z_391 = 6421600.0*q5_ddot + 1690830848.0*z_372 + 100000.0*z_381 + 2159.0*z_383 - 184828.0*z_373 -
        1440.0*z_379;
    const double z_392 = 99909292.0*z_357 + 15734118392.0*z_374 + 5803392000.0*z_356 + (800000.0*z_248*z_386 +
        640.0*z_225*z_387 + 20.0*cos_q4*z_390 + 3001.0*cos_q5*z_378 - 4.0*sin_q4*z_391 - 3001.0*sin_q5*z_382) -
        9492774802.0*z_354;
    const double z_393 = 4145280.0*z_195 + 19792500.0*(12.0*q2_dot - 455.0*z_6) - 23664000.0*z_204 - 2159.0*z_156;
    const double z_394 = 9005587500.0*cos_q2 + 4145280.0*z_244 - 23664000.0*z_207 - 2159.0*z_265;
    const double z_395 = 207025.0*z_273 + 48.0*z_274;
    D[1] = (1.0/40000000000.0)*(sin_q2*(31520000000.0*z_2 + 4.0*(9005587500.0*z_2 + 23664000.0*z_14 + 2159.0*z_152
        - 4145280.0*z_12) + 950040000.0*q2_ddot + cos_q3*z_182 + sin_q3*z_194 + 174000.0*q2_dot*z_205 +
        4.0*q1_dot*z_316 + z_325*z_269 + z_328*z_260 + z_347*z_348 + z_352*z_353 + 5803392000.0*z_354 +
        283968000.0*z_355 + 4.0*(70992000.0*sin_q2 + 1450848000.0*z_211 + 2159.0*z_345 -
        18759823020.0*cos_q2)*q1_ddot + cos_q3*z_389 + sin_q3*z_392 - z_4*z_171 - z_171*z_10 - z_203*z_8 -
        z_9*z_203 - 174000.0*z_206*z_208 - z_259*z_261 - z_259*z_262 - z_268*z_270 - z_268*z_271 -
        116959292080.0*z_356 - 8636.0*z_385) - cos_q2*(31520000000.0*z_13 + 10767120000.0*q2_ddot + z_4*z_203 +
        cos_q3*z_194 + z_203*z_10 + 4.0*z_206*z_394 + z_259*z_270 + z_259*z_271 + z_325*z_260 + z_352*z_348 +
        283968000.0*z_356 + cos_q3*z_392 - 174000.0*(207025.0*z_13 + 48.0*z_14) - sin_q3*z_182 - z_171*z_8 -
        z_9*z_171 - 4.0*q2_dot*z_393 - z_268*z_261 - z_268*z_262 - 174000.0*q1_dot*z_395 - z_328*z_269 -
        z_347*z_353 - 174000.0*(207169.0*sin_q2 - 1632.0*cos_q2)*q1_ddot - 46447406000.0*z_355 - sin_q3*z_389));
    const double z_396 = q3_dot*sin_q2;
    const double z_397 = q3_dot*cos_q2;
    const double z_398 = 1575840.0*z_215 - z_266;
    const double z_399 = q2_dot*q3_dot;
    const double z_400 = q3_dot*z_6;
    const double z_401 = q3_dot*z_1;
    const double z_402 = 1575840.0*z_279 + z_317;
    const double z_403 = 1821922.0*z_211 + z_351;
    const double z_404 = 1575840.0*z_211 + z_243;
    const double z_405 = 1575840.0*z_285 - z_326;
    const double z_406 = 1575840.0*z_215 - 5.0*z_346;
    D[2] = ((-1.0/40000000000.0))*(sin_q3*(z_171*z_396 + z_171*z_272 + z_203*z_397 + z_203*z_273 + z_13*z_259 +
        z_259*z_400 + z_2*z_268 + z_268*z_401 + 8636.0*q2_dot*z_402 - cos_q2*z_182 - sin_q2*z_194 -
        8636.0*z_398*z_399 - z_1*z_325 - z_6*z_328 - 8636.0*z_403*q2_ddot - z_347*z_356 - z_352*z_355 -
        cos_q2*z_389 - sin_q2*z_392) - cos_q3*(sin_q2*z_182 + z_171*z_273 + z_171*z_397 + 8636.0*z_404*z_399 +
        z_268*z_400 + z_13*z_268 + z_1*z_328 + z_347*z_355 + sin_q2*z_389 - cos_q2*z_194 - z_203*z_272 -
        z_203*z_396 - z_259*z_401 - z_2*z_259 - 8636.0*q2_dot*z_405 - z_6*z_325 - 8636.0*z_406*q2_ddot -
        z_352*z_356 - cos_q2*z_392));
    const double z_407 = q4_dot*z_211;
    const double z_408 = q4_dot*z_145;
    const double z_409 = q4_dot*z_83;
    const double z_410 = q4_dot*z_28;
    const double z_411 = q4_dot*z_30;
    const double z_412 = q4_dot*z_16;
    const double z_413 = q4_dot*z_21;
    D[3] = ((-1.0/40000000000.0))*(sin_q4*(4.0*z_192*z_407 + 3001.0*z_215*z_409 + 2.0*z_132*z_218 + 2.0*z_90*z_263
        + 2.0*z_264*z_411 + z_89*z_264 + 4.0*z_258*z_413 + 4.0*z_187*z_279 + 3001.0*z_145*z_285 + z_28*z_313 +
        4.0*z_16*z_324 + 4.0*z_350*z_357 + 20.0*z_349*z_354 + 10.0*z_329*z_370 + 3001.0*z_215*z_384 -
        4.0*z_211*z_188 - 3001.0*z_215*z_151 - 2.0*z_218*z_408 - z_263*z_410 - 4.0*z_11*z_255 - 4.0*z_255*z_412 -
        2.0*z_83*z_286 - 2.0*z_30*z_306 - 4.0*z_21*z_322 - 800000.0*z_222*z_386 - z_342*z_362 - 10.0*z_344*z_363 -
        640.0*z_339*z_387 - 20.0*z_211*z_390) + cos_q4*(4.0*z_211*z_193 + 3001.0*z_215*z_408 + 2.0*z_218*z_409 +
        2.0*z_263*z_411 + z_89*z_263 + z_264*z_410 + 4.0*z_255*z_413 + 4.0*z_11*z_258 + 4.0*z_258*z_412 +
        4.0*z_192*z_279 + 20.0*z_349*z_357 + 2.0*z_342*z_363 + 2.0*z_329*z_384 - 4.0*z_187*z_407 - 2.0*z_151*z_218
        - 3001.0*z_215*z_132 - 2.0*z_90*z_264 - 2.0*z_145*z_286 - 3001.0*z_83*z_285 - z_28*z_306 - 2.0*z_30*z_313
        - 4.0*z_16*z_322 - 4.0*z_21*z_324 - 4.0*z_350*z_354 - 5.0*z_344*z_362 - 15005.0*z_215*z_370 -
        4.0*z_211*z_391));
    const double z_414 = q5_dot*z_169;
    const double z_415 = q5_dot*z_165;
    const double z_416 = q5_dot*z_143;
    const double z_417 = z_135*z_147;
    const double z_418 = q5_dot*z_139;
    const double z_419 = q5_dot*z_55;
    const double z_420 = q5_dot*z_58;
    const double z_421 = q5_dot*z_40;
    const double z_422 = q5_dot*z_23;
    const double z_423 = z_135*z_340;
    D[4] = (1.0/40000000000.0)*(sin_q5*(800000.0*z_229*z_414 + 13600000.0*z_215*z_181 + z_149*z_220 + z_221*z_419
        + z_113*z_221 + z_242*z_420 + z_111*z_242 + 640.0*z_254*z_421 + 13600000.0*z_250*z_422 +
        800000.0*z_169*z_285 + 640.0*z_333*z_359 + 13600000.0*z_250*z_365 + 800000.0*z_215*z_386 +
        640.0*z_229*z_387 + 3001.0*z_211*z_378 - 640.0*z_229*z_176 - 640.0*z_215*z_415 - 3001.0*z_211*z_416 -
        3001.0*z_211*z_417 - z_220*z_418 - 640.0*z_86*z_254 - 13600000.0*z_250*z_87 - 640.0*z_165*z_280 -
        z_143*z_294 - 3001.0*z_279*z_139 - z_58*z_310 - z_55*z_311 - 640.0*z_23*z_320 - 13600000.0*z_40*z_321 -
        z_376*z_423 - z_338*z_377 - z_335*z_382) - cos_q5*(13600000.0*z_229*z_181 + 640.0*z_215*z_176 +
        z_220*z_416 + 3001.0*z_211*z_149 + z_220*z_417 + z_113*z_242 + z_242*z_419 + 640.0*z_254*z_422 +
        13600000.0*z_250*z_86 + 3001.0*z_143*z_279 + z_58*z_311 + 640.0*z_40*z_320 + 13600000.0*z_250*z_359 +
        z_338*z_376 + 800000.0*z_229*z_386 - 800000.0*z_215*z_414 - 640.0*z_229*z_415 - 3001.0*z_211*z_418 -
        z_111*z_221 - z_221*z_420 - 640.0*z_87*z_254 - 13600000.0*z_250*z_421 - 800000.0*z_169*z_280 -
        640.0*z_165*z_285 - z_294*z_139 - z_55*z_310 - 13600000.0*z_23*z_321 - 640.0*z_333*z_365 -
        640.0*z_215*z_387 - z_377*z_423 - z_335*z_378 - 3001.0*z_211*z_382));
    const double z_424 = q6_dot*z_162;
    const double z_425 = q6_dot*z_160;
    const double z_426 = q6_dot*z_79;
    const double z_427 = q6_dot*z_67;
    const double z_428 = q6_dot*z_36;
    const double z_429 = q6_dot*z_60;
    const double z_430 = q6_dot*z_46;
    const double z_431 = q6_dot*z_41;
    D[5] = ((-1.0/40000000000.0))*(cos_q6*(640.0*z_227*z_424 + 640.0*z_212*z_175 + 640.0*z_227*z_174 + z_119*z_223
        + z_114*z_236 + z_236*z_428 + 640.0*z_101*z_252 + 640.0*z_104*z_253 + 640.0*z_253*z_431 + z_60*z_299 +
        640.0*z_46*z_319 - 640.0*z_212*z_425 - z_223*z_426 - z_130*z_232 - z_232*z_427 - z_93*z_241 - z_241*z_429
        - 640.0*z_252*z_430 - 640.0*z_162*z_291 - 640.0*z_160*z_290 - z_79*z_289 - z_67*z_295 - z_36*z_304 -
        640.0*z_41*z_318) - sin_q6*(640.0*z_227*z_175 + z_232*z_426 + 640.0*z_101*z_253 + 640.0*z_160*z_291 +
        z_79*z_295 + z_36*z_299 + z_60*z_304 + 640.0*z_46*z_318 + 640.0*z_41*z_319 - 640.0*z_212*z_424 -
        640.0*z_227*z_425 - 640.0*z_212*z_174 - z_130*z_223 - z_119*z_232 - z_223*z_427 - z_236*z_429 - z_93*z_236
        - z_241*z_428 - z_114*z_241 - 640.0*z_104*z_252 - 640.0*z_252*z_431 - 640.0*z_253*z_430 -
        640.0*z_162*z_290 - z_67*z_289));
    D[6] = ((-1.0/40000000000.0))*(31520000000.0*cos_q2*z_272 + 4.0*z_272*z_394 + z_278*z_259 + z_275*z_259 +
        4.0*cos_q2*z_316 + z_210*z_325 + z_209*z_325 + z_214*z_328 - 174000.0*z_273*z_208 - z_277*z_259 -
        z_276*z_259 - z_284*z_268 - z_283*z_268 - z_282*z_268 - z_281*z_268 - 174000.0*sin_q2*z_395 -
        z_213*z_328);
    const double z_432 = (z_210*z_171 + z_209*z_171) + (z_214*z_203 - z_213*z_203);
    const double z_433 = (sin_q2*z_393 - 43500.0*cos_q2*z_205) - 7880000000.0*(cos_q2*z_1 -
        (1.0/31520000000.0)*z_432);
    const double z_434 = ((z_85*z_255 + z_84*z_258 - sin_q4*z_322 - cos_q4*z_324) + 0.25*(z_24*z_259 -
        z_25*z_259)) - 0.25*((z_19*z_268 + z_20*z_268) + 2206176000.0*(z_285 + (29.0/157584000.0)*z_317));
    D[7] = ((-1.0/40000000000.0))*(10767120000.0*z_273 + 8636.0*z_8*z_398 + 4.0*z_1*z_394 + 8636.0*sin_q3*z_405 +
        4.0*z_434 - 950040000.0*z_272 - 174000.0*z_6*z_208 - 8636.0*z_10*z_404 - 8636.0*cos_q3*z_402 - 4.0*z_433);
    D[8] = (1.0/40000000000.0)*(8636.0*z_4*z_404 + z_432 - 8636.0*z_9*z_398 - 4.0*z_434);
    D[9] = (1.0/40000000000.0)*(4.0*z_229*z_192 + 4.0*z_212*z_187 + 3001.0*z_216*z_83 + 2.0*z_31*z_264 +
        4.0*z_22*z_258 + 640.0*z_327 - 3001.0*z_215*z_155 - 2.0*z_158*z_218 - 2.0*z_157*z_218 - 2.0*z_52*z_263 -
        z_51*z_263 - z_29*z_264 - 4.0*z_44*z_255 - 4.0*z_43*z_255 - 4.0*z_17*z_258);
    D[10] = ((-1.0/40000000000.0))*(800000.0*z_226*z_169 + z_199*z_220 + z_56*z_221 + z_136*z_242 + z_137*z_242 +
        640.0*z_167*z_254 + 640.0*z_166*z_254 + 13600000.0*z_267*z_23 - 800000.0*z_224*z_169 - 640.0*z_249*z_165 -
        640.0*z_247*z_165 - 3001.0*z_339*z_143 - 3001.0*z_222*z_139 - z_198*z_220 - z_59*z_221 -
        13600000.0*z_251*z_40 - 640.0*z_323);
    D[11] = ((-1.0/40000000000.0))*(640.0*z_190*z_227 + z_141*z_232 + z_73*z_236 + 640.0*z_69*z_253 -
        640.0*z_212*z_163 - 640.0*z_189*z_227 - 640.0*z_212*z_161 - z_80*z_223 - z_140*z_232 - z_68*z_223 -
        z_72*z_236 - z_50*z_241 - z_61*z_241 - 640.0*z_48*z_252 - 640.0*z_42*z_252 - 640.0*z_70*z_253 -
        1600000.0*z_321);
    const double z_435 = q1_dot*q1_dot;
    const double z_436 = sin_q2*z_435;
    const double g = c[0];
    const double z_437 = load*g;
    const double z_438 = 9.0*g + 625.0*z_437;
    const double z_439 = 89133.0*g + 43180.0*z_437 + 32.0*cos_q5*z_438;
    const double z_440 = 5075.0*g + 4060.0*z_437 - 64.0*z_248*z_438;
    const double z_441 = (z_203*z_260 + z_171*z_269) + 400000.0*(sin_q3*z_439 - 0.5*cos_q3*z_440);
    const double z_442 = 203.0 + 4318.0*cos_q3;
    const double z_443 = sin_q3*cos_q4;
    const double z_444 = cos_q4 - z_443;
    const double z_445 = z_442*z_184 + 4318.0*z_444*z_148;
    const double z_446 = sin_q5*z_442;
    const double z_447 = z_446 - 4318.0*cos_q5*z_444;
    const double z_448 = sin_q4*cos_q5;
    const double z_449 = z_448*cos_q6 + cos_q4*sin_q6;
    const double z_450 = sin_q3*sin_q4;
    const double z_451 = sin_q4 - z_450;
    const double z_452 = 4318.0*cos_q6*z_451 - sin_q6*z_447;
    const double z_453 = load*(2000.0*z_449 + z_452);
    const double z_454 = 320.0*z_449 + z_452;
    const double z_455 = 100.0*z_453 + 9.0*z_454;
    const double z_456 = z_448*sin_q6 - cos_q4*cos_q6;
    const double z_457 = cos_q6*z_447 + 4318.0*sin_q6*z_451;
    const double z_458 = load*(2000.0*z_456 + z_457);
    const double z_459 = 320.0*z_456 + z_457;
    const double z_460 = 100.0*z_458 + 9.0*z_459;
    const double z_461 = 34.0*z_447 + cos_q6*z_460 - sin_q6*z_455;
    const double z_462 = 82.0*z_442 + cos_q5*z_445 + sin_q5*z_461;
    const double z_463 = 2254.0*sin_q4 - 2159.0*z_450;
    const double z_464 = 146812.0*z_451 + cos_q6*z_455 + sin_q6*z_460;
    const double z_465 = 9375.0*z_456 + 1250.0*z_458 + 18.0*z_459;
    const double z_466 = 9375.0*z_449 + 1250.0*z_453 + 18.0*z_454;
    const double z_467 = 18750.0*z_448 + sin_q6*z_465 + cos_q6*z_466;
    const double z_468 = sin_q5*sin_q5;
    const double z_469 = sin_q4*z_468;
    const double z_470 = sin_q4 + (17.0/90.0)*z_469;
    const double z_471 = 369656.0*z_463 + 2159.0*z_464 + 80.0*(cos_q5*z_467 + 112500.0*z_470);
    const double z_472 = cos_q4 - (2159.0/2254.0)*z_443;
    const double z_473 = 2254.0*z_472;
    const double z_474 = sin_q5*z_445 - cos_q5*z_461;
    const double z_475 = 369656.0*z_473 + 2159.0*z_474 + 80.0*(137500.0*cos_q4 + sin_q6*z_466 - cos_q6*z_465);
    const double z_476 = 6804477120.0*cos_q3 + 3001.0*z_462 + 4.0*(cos_q4*z_471 - sin_q4*z_475);
    const double z_477 = 164.0*z_463 + z_464;
    const double z_478 = 164.0*z_473 + z_474;
    const double z_479 = cos_q4*z_477 - sin_q4*z_478;
    const double z_480 = sin_q4*z_477 + cos_q4*z_478;
    const double z_481 = 1.0 - (2159.0/350.0)*sin_q3;
    const double z_482 = 350.0*z_481;
    const double z_483 = sin_q5*z_448;
    const double z_484 = 406.0*z_479 + 320.0*(21250.0*z_483 - sin_q5*z_467) - 3001.0*z_480 - 3151680.0*z_482;
    const double z_485 = 3.0*z_6 + 34.0*z_1;
    const double z_486 = z_85 - cos_q4*z_26;
    const double z_487 = 3001.0*z_21 + 8636.0*z_8;
    const double z_488 = 203.0*z_21 + 4318.0*z_1;
    const double z_489 = 8636.0*sin_q3*z_85 + sin_q4*z_487 - 2.0*cos_q4*z_488;
    const double z_490 = 9016.0*z_486 - z_489;
    const double z_491 = 8636.0*z_486 - z_489;
    const double z_492 = sin_q4*z_95;
    const double z_493 = z_492 + sin_q5*z_21 - cos_q5*z_486;
    const double z_494 = z_84 - sin_q4*z_26;
    const double z_495 = z_448*z_94 + cos_q6*z_493 + sin_q6*z_494 - cos_q4*z_106;
    const double z_496 = 8636.0*sin_q3*z_84 - cos_q4*z_487 - 2.0*sin_q4*z_488;
    const double z_497 = 8636.0*z_494 - z_496;
    const double z_498 = 3001.0*z_26 + 8636.0*z_10;
    const double z_499 = 2.0*z_442*z_98 + 8636.0*z_444*z_95 + cos_q5*z_497 - sin_q5*z_498;
    const double z_500 = 8636.0*z_451*z_94 + 2.0*z_447*z_106 + sin_q6*z_499 - cos_q6*z_491;
    const double z_501 = load*(4000.0*z_495 + z_500);
    const double z_502 = 640.0*z_495 + z_500;
    const double z_503 = 100.0*z_501 + 9.0*z_502;
    const double z_504 = z_448*z_106 + cos_q4*z_94 + cos_q6*z_494 - sin_q6*z_493;
    const double z_505 = 2.0*z_447*z_94 - 8636.0*z_451*z_106 - cos_q6*z_499 - sin_q6*z_491;
    const double z_506 = load*(4000.0*z_504 - z_505);
    const double z_507 = 640.0*z_504 - z_505;
    const double z_508 = 100.0*z_506 + 9.0*z_507;
    const double z_509 = 2.0*z_94*z_455 + cos_q6*z_503 - 2.0*z_106*z_460 - 34.0*z_491 - sin_q6*z_508;
    const double z_510 = 82.0*z_490 - z_509;
    const double z_511 = 9016.0*z_494 - z_496;
    const double z_512 = 2.0*z_442*z_308 + z_184*z_498 + z_497*z_148 - 8636.0*z_444*z_309;
    const double z_513 = 2.0*z_106*z_455 + 2.0*z_94*z_460 - 34.0*z_499 - sin_q6*z_503 - cos_q6*z_508;
    const double z_514 = 2.0*z_98*z_445 + 2.0*z_95*z_461 + cos_q5*z_513 - sin_q5*z_512;
    const double z_515 = 82.0*z_511 - z_514;
    const double z_516 = 2.0*z_84*z_477 + 2.0*z_85*z_478 - cos_q4*z_510 - sin_q4*z_515;
    const double z_517 = 350.0*z_26 - 2159.0*z_1;
    const double z_518 = 9005587500.0*z_1 + 23664000.0*z_485 - 2159.0*z_516 - 4145280.0*z_517;
    const double z_519 = 2.0*z_95*z_445 + 82.0*z_498 + cos_q5*z_512 + sin_q5*z_513 - 2.0*z_98*z_461;
    const double z_520 = 3283.0*z_26 + 8636.0*z_10;
    const double z_521 = 9375.0*z_504 + 625.0*z_506 + 9.0*z_507;
    const double z_522 = 9375.0*z_495 + 625.0*z_501 + 9.0*z_502;
    const double z_523 = z_106*z_465 + sin_q6*z_521 - z_94*z_466 - 18750.0*z_493 - cos_q6*z_522;
    const double z_524 = q5_dot*z_448 + sin_q5*z_486 + cos_q5*z_21;
    const double z_525 = sin_q5*z_524 + (z_448*z_95 + (90.0/17.0)*z_486);
    const double z_526 = 184828.0*z_490 + 160.0*(cos_q5*z_523 + 21250.0*z_525 - z_95*z_467) - 2159.0*z_509;
    const double z_527 = z_94*z_465 + z_106*z_466 - 25000.0*z_494 - cos_q6*z_521 - sin_q6*z_522;
    const double z_528 = 18000000.0*z_494 + 184828.0*z_511 - 2159.0*z_514 - 160.0*z_527;
    const double z_529 = 3001.0*z_519 + 1575840.0*z_520 + 2688000.0*z_517 + 4.0*(660000000.0*z_26 + 2.0*z_84*z_471
        + 2.0*z_85*z_475 - cos_q4*z_526 - sin_q4*z_528);
    const double z_530 = 2.0*z_85*z_477 + sin_q4*z_510 - 2.0*z_84*z_478 - cos_q4*z_515;
    const double z_531 = 3283.0*z_21 + 8636.0*z_8;
    const double z_532 = cos_q5*z_524 + (65.0/17.0)*(z_21 - (17.0/65.0)*q5_dot*z_469);
    const double z_533 = 21250.0*z_532 - z_98*z_467 - sin_q5*z_523;
    const double z_534 = 500000000.0*z_21 + 1575840.0*z_531 + 640.0*z_533 - 406.0*z_516 - 3001.0*z_530;
    const double z_535 = sin_q4*z_353;
    const double z_536 = sin_q4*q1_ddot;
    const double z_537 = z_448*q1_ddot;
    const double z_538 = z_536 + (1000.0/2159.0)*z_537;
    const double z_539 = load*(2159.0*z_538 - 2159.0*z_535);
    const double z_540 = z_536 + (96.0/18511.0)*z_537;
    const double z_541 = 20.0*z_539 + 55533.0*z_540 - 53975.0*z_535;
    const double z_542 = cos_q4*q1_ddot;
    const double z_543 = cos_q4*z_353;
    const double z_544 = 203.0*q1_ddot + 4318.0*z_348;
    const double z_545 = z_542 - z_543;
    const double z_546 = z_184*z_544 + 4318.0*z_545*z_148;
    const double z_547 = sin_q5*z_544 - 4318.0*cos_q5*z_545;
    const double z_548 = load*(2000.0*z_542 - z_547);
    const double z_549 = 2880.0*z_542 + 100.0*z_548 - 43.0*z_547;
    const double z_550 = sin_q5*z_546 + cos_q5*z_549;
    const double z_551 = 369656.0*z_542 + z_550 - 354076.0*z_543;
    const double z_552 = 10.0*cos_q4*z_541 - sin_q4*z_551;
    const double z_553 = sin_q5*q1_ddot;
    const double z_554 = z_448*z_553;
    const double z_555 = z_536 + (3765.0/8636.0)*z_537;
    const double z_556 = 2500.0*z_539 + 77724.0*z_555 - 77724.0*z_535;
    const double z_557 = 1103088000.0*q1_ddot - 6804477120.0*z_353 - (6800000.0*z_554 - 320.0*sin_q5*z_556 -
        30010.0*sin_q4*z_541 - 3001.0*cos_q4*z_551) - 406.0*z_552;
    const double z_558 = z_469*z_542;
    const double z_559 = z_536 + (621792.0/124307479.0)*z_537;
    const double z_560 = 43180.0*z_539 + 124307479.0*z_559 - 119895747.0*z_535;
    const double z_561 = 845415424.0*z_542 + 100000.0*z_548 + 2159.0*z_550 - 798087304.0*z_543 - 1440.0*z_547;
    const double z_562 = 49954646.0*q1_ddot + 7867059196.0*z_348 + (6800000.0*z_558 + 320.0*z_225*z_556 +
        40.0*cos_q4*z_560 + 3001.0*cos_q5*z_546 - 4.0*sin_q4*z_561 - 3001.0*sin_q5*z_549);
    const double z_563 = cos_q2*z_435;
    const double z_564 = (z_203*z_269 - z_171*z_260) - 400000.0*(cos_q3*z_439 + 0.5*sin_q3*z_440);
    const double z_565 = 118755000.0 - 2159.0*z_479;
    const double z_566 = 207025.0*z_6 + 48.0*z_485;
    D[13] = ((-1.0/40000000000.0))*(sin_q2*(20960000000.0*z_436 + (151823600000.0*g + 17272000000.0*z_437 +
        174000.0*q1_dot*z_205 - 5200000000.0*z_436 - z_441) + 4.0*q1_dot*z_518 + z_529*z_269 + z_534*z_260 +
        17272.0*z_552 - 10767120000.0*z_206 - 950040000.0*q1_ddot - 2.0*z_476*z_261 - 2.0*z_476*z_262 -
        2.0*z_484*z_270 - 2.0*z_484*z_271 - 2.0*cos_q3*z_557 - 2.0*sin_q3*z_562) + cos_q2*(5200000000.0*z_563 +
        (4176000000.0*g + 4.0*q1_dot*z_393 - 20960000000.0*z_563 - z_564) + 10767120000.0*q1_ddot +
        2.0*z_484*z_261 + 2.0*z_484*z_262 + 174000.0*q1_dot*z_566 + z_534*z_269 + 2.0*cos_q3*z_562 -
        8.0*z_206*z_565 - 2.0*z_476*z_270 - 2.0*z_476*z_271 - z_529*z_260 - 2.0*sin_q3*z_557));
    const double z_567 = 480.0*z_154 + z_159;
    const double z_568 = z_480 + 960.0*z_482;
    const double z_569 = z_519 + 480.0*z_520;
    const double z_570 = load*(2000.0*cos_q4 - z_447);
    const double z_571 = 2880.0*cos_q4 + 100.0*z_570 - 43.0*z_447;
    const double z_572 = cos_q5*z_442;
    const double z_573 = z_572 + 4318.0*sin_q5*z_444;
    const double z_574 = 203.0*z_375;
    const double z_575 = cos_q4*z_360;
    const double z_576 = z_371 - z_575;
    const double z_577 = z_184*z_574 + 4318.0*z_576*z_148;
    const double z_578 = sin_q5*z_574 - 4318.0*cos_q5*z_576;
    const double z_579 = q5_ddot + z_371;
    const double z_580 = load*(2000.0*z_579 - z_578);
    const double z_581 = 100.0*z_580 + 2880.0*z_579 - 43.0*z_578;
    const double z_582 = (z_6*z_203 + z_1*z_171) + 400000.0*(sin_q2*z_439 - 0.5*cos_q2*z_440);
    const double z_583 = 480.0*z_197 - z_201;
    const double z_584 = 2072640.0*cos_q3 + z_462;
    const double z_585 = z_530 - 480.0*z_531;
    const double z_586 = cos_q5*z_571 + z_573*z_148;
    const double z_587 = 369656.0*z_472 + z_586;
    const double z_588 = load*(1000.0*z_448 + 2159.0*z_451);
    const double z_589 = 55533.0*sin_q4 + 288.0*z_448 + 20.0*z_588 - 53975.0*z_450;
    const double z_590 = sin_q4*z_360;
    const double z_591 = sin_q5*q4_ddot;
    const double z_592 = z_448*z_357;
    const double z_593 = z_591 - z_592;
    const double z_594 = z_358 - z_590;
    const double z_595 = load*(2159.0*z_594 - 1000.0*z_593);
    const double z_596 = z_593 - (5.0/72.0)*z_595;
    const double z_597 = 55533.0*z_358 - 53975.0*z_590 - 288.0*z_596;
    const double z_598 = sin_q5*z_577 + cos_q5*z_581;
    const double z_599 = 369656.0*z_371 + z_598 - 354076.0*z_575;
    const double z_600 = (z_1*z_203 - z_6*z_171) - 400000.0*(cos_q2*z_439 + 0.5*sin_q2*z_440);
    D[14] = (1.0/40000000000.0)*(sin_q3*(8636.0*q3_dot*z_567 + 17272.0*z_568*z_399 + 2.0*z_13*z_476 +
        2.0*z_476*z_400 + 2.0*z_2*z_484 + 2.0*z_484*z_401 + 8636.0*q2_dot*z_569 + 8636.0*z_403*q1_ddot +
        2.0*cos_q2*z_557 + 2.0*sin_q2*z_562 + z_582 - 8636.0*(480.0*z_183 + z_185) - 287509712.0*z_357 -
        41914238752.0*z_374 - z_1*z_529 - z_6*z_534 - 17272.0*(16646.0 + 2426716.0*cos_q3 + z_573*z_184 -
        sin_q5*z_571)*q2_ddot - 17272.0*(cos_q5*z_577 - sin_q5*z_581)) + cos_q3*(8636.0*q3_dot*z_583 +
        2.0*z_476*z_401 + 2.0*z_2*z_476 + z_6*z_529 + 2.0*sin_q2*z_557 + 35798638080.0*z_388 + z_600 -
        8636.0*(480.0*z_172 + z_173) - 17272.0*z_584*z_399 - 2.0*z_484*z_400 - 2.0*z_13*z_484 -
        8636.0*q2_dot*z_585 - z_1*z_534 - 17272.0*(cos_q4*z_587 + 10.0*sin_q4*z_589 + 336000.0*z_481)*q2_ddot -
        172720.0*sin_q4*z_597 - 17272.0*cos_q4*z_599 - 8636.0*z_406*q1_ddot - 2.0*cos_q2*z_562));
    const double z_601 = 845415424.0*cos_q4 + 100000.0*z_570 + 2159.0*z_586 - 798087304.0*z_443 - 1440.0*z_447;
    const double z_602 = q1_ddot*z_468;
    const double z_603 = (z_212*z_602 - (16.0/17.0)*(z_224*z_438 - (1.0/3200000.0)*z_193)) -
        (8027.0/4250.0)*((q5_ddot + (1.0/6421600.0)*q4_dot*z_187) - (1.0/6421600.0)*(z_26*z_187 - z_350*q1_ddot));
    const double z_604 = 33885.0*z_448 + 2500.0*z_588 + 77724.0*z_451;
    const double z_605 = z_469 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_448);
    const double z_606 = 43180.0*z_588 + 8.0*cos_q5*z_604 + 170000.0*z_605 - 119895747.0*z_450;
    const double z_607 = 2500.0*z_595 + 77724.0*z_594 - 33885.0*z_593;
    const double z_608 = sin_q5*cos_q5;
    const double z_609 = (q4_ddot*z_608 - (1.0/680000.0)*z_349*q1_ddot) + (1.0/3400000.0)*((z_188 - q4_dot*z_192)
        + 400000.0*(sin_q5*q6_ddot + (1.0/400000.0)*z_26*z_192));
    D[15] = ((-1.0/40000000000.0))*(sin_q4*(6763323392.0*z_371 + 8636.0*sin_q3*z_151 + 2.0*z_477*z_410 +
        4.0*z_478*z_411 + 2.0*z_89*z_478 + 8.0*z_11*z_471 + 8.0*z_471*z_412 + 8.0*z_475*z_413 + 2.0*z_83*z_488 +
        8.0*z_601*z_357 + 800000.0*z_580 + 17272.0*z_598 + 40.0*z_329*z_541 + 6002.0*z_215*z_551 -
        8636.0*sin_q3*z_409 - 4.0*z_90*z_477 - z_145*z_487 - 2.0*z_30*z_510 - z_28*z_515 - 4.0*z_21*z_526 -
        4.0*z_16*z_528 - 17272.0*z_587*z_360 - 6384698432.0*z_575 - 11520.0*z_578 - 17272.0*sin_q3*z_599 -
        8636.0*z_342*z_353 - 640.0*z_339*z_556 - 80.0*z_211*z_560 - 13600000.0*z_603) - cos_q4*(9944598320.0*z_358
        + 8636.0*sin_q3*z_408 + 4.0*z_477*z_411 + 2.0*z_89*z_477 + 4.0*z_90*z_478 + 8.0*z_471*z_413 + z_28*z_510 +
        4.0*z_16*z_526 + 80.0*z_606*z_357 + 13600000.0*z_469*z_357 + 640.0*cos_q5*z_607 + 43180.0*z_344*z_353 +
        60020.0*z_215*z_541 + 8.0*z_211*z_561 + 13600000.0*z_609 - 8636.0*sin_q3*z_132 - 2.0*z_478*z_410 -
        8.0*z_11*z_475 - 8.0*z_475*z_412 - 2.0*z_145*z_488 - z_83*z_487 - 2.0*z_30*z_515 - 4.0*z_21*z_528 -
        172720.0*z_589*z_360 - 9591659760.0*z_590 - 172720.0*sin_q3*z_597 - 4.0*z_329*z_551 - 49743360.0*z_596));
    const double z_610 = z_135*z_573;
    const double z_611 = sin_q4*z_604;
    const double z_612 = sin_q5*sin_q4;
    const double z_613 = z_215*q1_ddot;
    const double z_614 = ((z_165*z_486 + 21250.0*z_40*z_524) + 21250.0*(q4_ddot*z_612 -
        (1.0/21250.0)*z_333*z_536)) - 21250.0*((z_613*z_612 - (1.0/17.0)*(sin_q4*z_414 -
        (1.0/1250.0)*sin_q4*z_176)) + ((z_87*z_612 - z_23*z_492) + (16.0/17.0)*(z_211*z_438 -
        0.0625*z_21*z_169)));
    const double z_615 = z_248*q1_ddot;
    const double z_616 = ((z_23*z_524 + z_448*q4_ddot) - (z_250*z_536 + z_212*z_615)) +
        (2.0/17.0)*(((sin_q4*q6_ddot + 8.5*sin_q4*z_181) - (1.0/2500.0)*(sin_q4*z_415 + 21250.0*z_40*z_492)) +
        8.5*((z_86*z_612 + (16.0/17.0)*z_216*z_438) + (1.0/17.0)*(z_169*z_486 - (1.0/1250.0)*z_21*z_165)));
    D[16] = ((-1.0/40000000000.0))*(sin_q5*(8636.0*z_444*z_418 + 2.0*z_445*z_419 + 2.0*z_113*z_445 +
        2.0*z_461*z_420 + 2.0*z_111*z_461 + 640.0*z_86*z_467 + z_55*z_513 + 640.0*z_23*z_523 + 4.0*z_574*z_610 +
        640.0*z_357*z_611 + 640.0*sin_q4*z_607 + 4.0*z_442*z_577 + 17272.0*z_571*z_576 + 17272.0*z_444*z_581 +
        2.0*z_544*z_423 + 8636.0*z_338*z_545 + 2.0*z_335*z_549 + 640.0*z_614 - 8636.0*z_444*z_149 -
        2.0*z_442*z_416 - 2.0*z_442*z_417 - 640.0*z_421*z_467 - z_143*z_497 - z_498*z_139 - z_58*z_512 -
        640.0*z_229*z_556 - 6002.0*z_211*z_546) - cos_q5*(2.0*z_442*z_149 + 2.0*z_113*z_461 + 2.0*z_461*z_419 +
        640.0*z_87*z_467 + z_143*z_498 + 27200000.0*sin_q5*z_357*(sin_q4*sin_q4) + 17272.0*z_576*z_610 +
        17272.0*z_444*z_577 + 640.0*z_215*z_556 + 8636.0*z_545*z_423 + 2.0*z_335*z_546 + 6002.0*z_211*z_549 +
        13600000.0*z_616 - 8636.0*z_444*z_416 - 2.0*z_442*z_418 - 8636.0*z_444*z_417 - 2.0*z_111*z_445 -
        2.0*z_445*z_420 - 640.0*z_422*z_467 - z_497*z_139 - z_55*z_512 - z_58*z_513 - 640.0*z_40*z_523 -
        640.0*z_604*q4_ddot - 4.0*z_571*z_574 - 4.0*z_442*z_581 - 2.0*z_338*z_544));
    const double z_617 = (z_162*z_494 + z_160*z_493) + ((z_448*z_424 + cos_q4*z_175) + (z_448*z_174 -
        cos_q4*z_425));
    const double z_618 = (z_162*z_493 - z_160*z_494) + ((z_448*z_175 - cos_q4*z_424) - (z_448*z_425 +
        cos_q4*z_174));
    D[17] = ((-1.0/40000000000.0))*(cos_q6*(2.0*z_447*z_426 + 8636.0*z_451*z_130 + 8636.0*z_451*z_427 +
        2.0*z_114*z_455 + 2.0*z_455*z_428 + 640.0*z_101*z_465 + 640.0*z_104*z_466 + 640.0*z_466*z_431 + z_67*z_499
        + z_60*z_503 + 640.0*z_46*z_522 + 640.0*z_617 - 2.0*z_447*z_119 - 2.0*z_93*z_460 - 2.0*z_460*z_429 -
        640.0*z_465*z_430 - z_79*z_491 - z_36*z_508 - 640.0*z_41*z_521) - sin_q6*(2.0*z_447*z_130 +
        8636.0*z_451*z_119 + 2.0*z_447*z_427 + 640.0*z_101*z_466 + z_36*z_503 + z_60*z_508 + 640.0*z_46*z_521 +
        640.0*z_41*z_522 + 640.0*z_618 - 8636.0*z_451*z_426 - 2.0*z_455*z_429 - 2.0*z_93*z_455 - 2.0*z_460*z_428 -
        2.0*z_114*z_460 - 640.0*z_104*z_465 - 640.0*z_465*z_431 - 640.0*z_466*z_430 - z_79*z_499 - z_67*z_491));
    D[18] = ((-1.0/40000000000.0))*(10767120000.0*z_273 + 2.0*z_277*z_476 + 2.0*z_276*z_476 + 2.0*z_284*z_484 +
        2.0*z_283*z_484 + 2.0*z_282*z_484 + 2.0*z_281*z_484 + 174000.0*sin_q2*z_566 + z_213*z_534 + 4.0*z_433 -
        8.0*z_272*z_565 - 2.0*z_278*z_476 - 2.0*z_275*z_476 - 4.0*cos_q2*z_518 - z_210*z_529 - z_209*z_529 -
        z_214*z_534);
    const double z_619 = ((2.0*z_85*z_471 + sin_q4*z_526 - 2.0*z_84*z_475 - cos_q4*z_528) + 0.5*(z_24*z_476 -
        z_25*z_476)) - 0.5*((z_19*z_484 + z_20*z_484) + 203.0*(z_519 + (48000.0/29.0)*z_531));
    D[19] = ((-1.0/20000000000.0))*(475020000.0*z_1 + 8636.0*z_8*z_568 + 8636.0*z_10*z_584 + 4318.0*sin_q3*z_585 +
        4318.0*cos_q3*z_569 - 4.0*z_1*z_565 - 2.0*z_619);
    const double z_620 = sin_q3*z_583 - cos_q3*z_567;
    D[20] = (1.0/20000000000.0)*(4318.0*z_620 + 2.0*z_619 - 8636.0*z_9*z_568 - 8636.0*z_4*z_584);
    D[21] = (1.0/20000000000.0)*(4318.0*sin_q3*z_155 + 2.0*z_52*z_477 + z_51*z_477 + 2.0*z_31*z_478 +
        4.0*z_44*z_471 + 4.0*z_43*z_471 + 4.0*z_22*z_475 + 320.0*z_533 + 2.0*z_202 - 4318.0*z_443*z_83 -
        z_29*z_478 - 4.0*z_17*z_475);
    const double z_621 = (z_448*z_169 - (1.0/1250.0)*z_165*z_612) - 17.0*(z_469*z_40 - z_448*z_166);
    D[22] = (1.0/20000000000.0)*(4318.0*z_444*z_198 + z_56*z_445 + z_136*z_461 + z_137*z_461 + 320.0*z_527 +
        400000.0*z_621 - 4318.0*z_444*z_199 - z_572*z_143 - z_446*z_139 - z_59*z_445 - 320.0*z_167*z_467 -
        320.0*z_166*z_467);
    const double z_622 = (z_448*z_189 + cos_q4*z_161) + 2500.0*(z_524 - (1.0/2500.0)*(z_448*z_190 -
        cos_q4*z_163));
    D[23] = ((-1.0/20000000000.0))*(z_80*z_447 + 4318.0*z_140*z_451 + z_68*z_447 + z_73*z_455 + 320.0*z_69*z_466 -
        4318.0*z_141*z_451 - z_72*z_455 - z_50*z_460 - z_61*z_460 - 320.0*z_48*z_465 - 320.0*z_42*z_465 -
        320.0*z_70*z_466 - 320.0*z_622);
    const double z_623 = z_135*z_248;
    const double z_624 = 203.0*z_184 + 4318.0*z_623;
    const double z_625 = sin_q5 - (4318.0/203.0)*z_225;
    const double z_626 = 203.0*z_625;
    const double z_627 = 4318.0*sin_q4*cos_q6 - sin_q6*z_626;
    const double z_628 = load*(2000.0*z_449 + z_627);
    const double z_629 = 320.0*z_449 + z_627;
    const double z_630 = 100.0*z_628 + 9.0*z_629;
    const double z_631 = cos_q6*z_626 + 4318.0*sin_q4*sin_q6;
    const double z_632 = load*(2000.0*z_456 + z_631);
    const double z_633 = 320.0*z_456 + z_631;
    const double z_634 = 100.0*z_632 + 9.0*z_633;
    const double z_635 = 34.0*z_626 + cos_q6*z_634 - sin_q6*z_630;
    const double z_636 = 16646.0 + cos_q5*z_624 + sin_q5*z_635;
    const double z_637 = 146812.0*sin_q4 + cos_q6*z_630 + sin_q6*z_634;
    const double z_638 = 9375.0*z_456 + 1250.0*z_632 + 18.0*z_633;
    const double z_639 = 9375.0*z_449 + 1250.0*z_628 + 18.0*z_629;
    const double z_640 = 18750.0*z_448 + sin_q6*z_638 + cos_q6*z_639;
    const double z_641 = 833204624.0*sin_q4 + 2159.0*z_637 + 80.0*(cos_q5*z_640 + 112500.0*z_470);
    const double z_642 = sin_q5*z_624 - cos_q5*z_635;
    const double z_643 = 833204624.0*cos_q4 + 2159.0*z_642 + 80.0*(137500.0*cos_q4 + sin_q6*z_639 - cos_q6*z_638);
    const double z_644 = 3001.0*z_636 + 4.0*(cos_q4*z_641 - sin_q4*z_643);
    const double z_645 = 369656.0*sin_q4 + z_637;
    const double z_646 = 369656.0*cos_q4 + z_642;
    const double z_647 = cos_q4*z_645 - sin_q4*z_646;
    const double z_648 = sin_q4*z_645 + cos_q4*z_646;
    const double z_649 = 1103088000.0 + 3001.0*z_648 - 406.0*z_647 - 320.0*(21250.0*z_483 - sin_q5*z_640);
    const double z_650 = 3001.0*z_57;
    const double z_651 = 406.0*z_22 - sin_q4*z_650;
    const double z_652 = 9016.0*z_486 + z_651;
    const double z_653 = 8636.0*z_486 + z_651;
    const double z_654 = 406.0*z_44 + cos_q4*z_650;
    const double z_655 = 8636.0*z_494 + z_654;
    const double z_656 = 3001.0*z_27;
    const double z_657 = 406.0*z_98 + 8636.0*q5_dot*z_248 + cos_q5*z_655 - sin_q5*z_656;
    const double z_658 = 8636.0*sin_q4*z_94 + 2.0*z_626*z_106 + sin_q6*z_657 - cos_q6*z_653;
    const double z_659 = load*(4000.0*z_495 + z_658);
    const double z_660 = 640.0*z_495 + z_658;
    const double z_661 = 100.0*z_659 + 9.0*z_660;
    const double z_662 = 2.0*z_626*z_94 - 8636.0*sin_q4*z_106 - cos_q6*z_657 - sin_q6*z_653;
    const double z_663 = load*(4000.0*z_504 - z_662);
    const double z_664 = 640.0*z_504 - z_662;
    const double z_665 = 100.0*z_663 + 9.0*z_664;
    const double z_666 = 2.0*z_94*z_630 + cos_q6*z_661 - 2.0*z_106*z_634 - 34.0*z_653 - sin_q6*z_665;
    const double z_667 = 82.0*z_652 - z_666;
    const double z_668 = 9016.0*z_494 + z_654;
    const double z_669 = 406.0*z_308 + z_184*z_656 + z_655*z_148 - 8636.0*cos_q4*z_309;
    const double z_670 = 2.0*z_106*z_630 + 2.0*z_94*z_634 - 34.0*z_657 - sin_q6*z_661 - cos_q6*z_665;
    const double z_671 = 2.0*z_98*z_624 + 2.0*z_95*z_635 + cos_q5*z_670 - sin_q5*z_669;
    const double z_672 = 82.0*z_668 - z_671;
    const double z_673 = 2.0*z_84*z_645 + 2.0*z_85*z_646 - cos_q4*z_667 - sin_q4*z_672;
    const double z_674 = 672000.0*z_26 + z_673;
    const double z_675 = 2.0*z_95*z_624 + 82.0*z_656 + cos_q5*z_669 + sin_q5*z_670 - 2.0*z_98*z_635;
    const double z_676 = 3283.0*z_153;
    const double z_677 = 9375.0*z_504 + 625.0*z_663 + 9.0*z_664;
    const double z_678 = 9375.0*z_495 + 625.0*z_659 + 9.0*z_660;
    const double z_679 = 18750.0*z_493 + z_94*z_639 + cos_q6*z_678 - z_106*z_638 - sin_q6*z_677;
    const double z_680 = 184828.0*z_652 + 160.0*(21250.0*z_525 - z_95*z_640 - cos_q5*z_679) - 2159.0*z_666;
    const double z_681 = 25000.0*z_494 + cos_q6*z_677 + sin_q6*z_678 - z_94*z_638 - z_106*z_639;
    const double z_682 = 18000000.0*z_494 + 184828.0*z_668 + 160.0*z_681 - 2159.0*z_671;
    const double z_683 = 940800000.0*z_26 + 3001.0*z_675 + 1575840.0*z_676 + 4.0*(660000000.0*z_26 +
        2.0*z_84*z_641 + 2.0*z_85*z_643 - cos_q4*z_680 - sin_q4*z_682);
    const double z_684 = 2.0*z_85*z_645 + sin_q4*z_667 - 2.0*z_84*z_646 - cos_q4*z_672;
    const double z_685 = 3283.0*z_196;
    const double z_686 = sin_q5*z_679 + 21250.0*z_532 - z_98*z_640;
    const double z_687 = 500000000.0*z_21 + 1575840.0*z_685 + 640.0*z_686 - 406.0*z_673 - 3001.0*z_684;
    const double z_688 = load*(2159.0*z_538);
    const double z_689 = 20.0*z_688 + 55533.0*z_540;
    const double z_690 = 203.0*z_184*q1_ddot + 4318.0*z_135*z_615;
    const double z_691 = 203.0*z_553 - 4318.0*z_225*q1_ddot;
    const double z_692 = load*(2000.0*z_542 - z_691);
    const double z_693 = 2880.0*z_542 + 100.0*z_692 - 43.0*z_691;
    const double z_694 = sin_q5*z_690 + cos_q5*z_693;
    const double z_695 = 369656.0*z_542 + z_694;
    const double z_696 = 10.0*cos_q4*z_689 - sin_q4*z_695;
    const double z_697 = 2500.0*z_688 + 77724.0*z_555;
    const double z_698 = 1103088000.0*q1_ddot - (6800000.0*z_554 - 320.0*sin_q5*z_697 - 30010.0*sin_q4*z_689 -
        3001.0*cos_q4*z_695) - 406.0*z_696;
    const double z_699 = 43180.0*z_688 + 124307479.0*z_559;
    const double z_700 = 845415424.0*z_542 + 100000.0*z_692 + 2159.0*z_694 - 1440.0*z_691;
    const double z_701 = 49954646.0*q1_ddot + (6800000.0*z_558 + 320.0*z_225*z_697 + 40.0*cos_q4*z_699 +
        3001.0*cos_q5*z_690 - 4.0*sin_q4*z_700 - 3001.0*sin_q5*z_693);
    D[25] = (1.0/40000000000.0)*(sin_q2*(2.0*z_644*z_261 + 2.0*z_644*z_262 + 8636.0*q1_dot*z_674 +
        2.0*cos_q3*z_698 + 2.0*sin_q3*z_701 + z_441 - 2.0*z_649*z_270 - 2.0*z_649*z_271 - z_683*z_269 -
        z_687*z_260 - 17272.0*z_696) + cos_q2*(2.0*z_644*z_270 + 2.0*z_644*z_271 + 2.0*z_649*z_261 +
        2.0*z_649*z_262 + z_683*z_260 + 2.0*sin_q3*z_698 + z_564 - 17272.0*z_206*z_647 - z_687*z_269 -
        2.0*cos_q3*z_701));
    const double z_702 = 336000.0 + z_648;
    const double z_703 = z_675 + 480.0*z_676;
    const double z_704 = 203.0*z_184*q2_ddot + 4318.0*q2_ddot*z_623;
    const double z_705 = cos_q4*q2_ddot;
    const double z_706 = sin_q5*q2_ddot;
    const double z_707 = 203.0*z_706 - 4318.0*z_225*q2_ddot;
    const double z_708 = load*(2000.0*z_705 - z_707);
    const double z_709 = 2880.0*z_705 + 100.0*z_708 - 43.0*z_707;
    const double z_710 = z_684 - 480.0*z_685;
    const double z_711 = sin_q4*q2_ddot;
    const double z_712 = z_448*q2_ddot;
    const double z_713 = load*(2159.0*z_711 + 1000.0*z_712);
    const double z_714 = 55533.0*z_711 + 288.0*z_712 + 20.0*z_713;
    const double z_715 = sin_q5*z_704 + cos_q5*z_709;
    const double z_716 = 369656.0*z_705 + z_715;
    D[26] = ((-1.0/40000000000.0))*(sin_q3*((8636.0*q2_dot*z_567 - z_582) + 287509712.0*q2_ddot + 2.0*z_2*z_649 +
        2.0*z_649*z_401 + z_1*z_683 + z_6*z_687 + 17272.0*(cos_q5*z_704 - sin_q5*z_709) - 17272.0*z_702*z_399 -
        2.0*z_13*z_644 - 2.0*z_644*z_400 - 8636.0*q2_dot*z_703 - 2.0*cos_q2*z_698 - 2.0*sin_q2*z_701) +
        cos_q3*((8636.0*q2_dot*z_583 - z_600) + 5803392000.0*q2_ddot + 17272.0*z_636*z_399 + 8636.0*q2_dot*z_710 +
        z_1*z_687 + 172720.0*sin_q4*z_714 + 17272.0*cos_q4*z_716 + 2.0*cos_q2*z_701 - 2.0*z_644*z_401 -
        2.0*z_2*z_644 - 2.0*z_649*z_400 - 2.0*z_13*z_649 - z_6*z_683 - 2.0*sin_q2*z_698));
    const double z_717 = load*(203.0*z_625 - 2000.0*cos_q4);
    const double z_718 = 100.0*z_717 + 8729.0*z_625 - 2880.0*cos_q4;
    const double z_719 = 203.0*cos_q5 + 4318.0*z_248;
    const double z_720 = cos_q4*q3_ddot;
    const double z_721 = 203.0*z_184*q3_ddot + 4318.0*q3_ddot*z_623;
    const double z_722 = sin_q5*q3_ddot;
    const double z_723 = 203.0*z_722 - 4318.0*z_225*q3_ddot;
    const double z_724 = q5_ddot + z_720;
    const double z_725 = load*(2000.0*z_724 - z_723);
    const double z_726 = z_724 - (43.0/2880.0)*(z_723 - (100.0/43.0)*z_725);
    const double z_727 = 2880.0*z_726;
    const double z_728 = load*(2159.0*sin_q4 + 1000.0*z_448);
    const double z_729 = 77724.0*sin_q4 + 33885.0*z_448 + 2500.0*z_728;
    const double z_730 = sin_q4*q3_ddot;
    const double z_731 = z_730 + z_711;
    const double z_732 = z_591 - z_448*q3_ddot;
    const double z_733 = z_732 - z_712;
    const double z_734 = load*(2159.0*z_730 - 1000.0*z_732) + z_713;
    const double z_735 = 77724.0*z_731 + 2500.0*z_734 - 33885.0*z_733;
    D[27] = ((-1.0/40000000000.0))*(sin_q4*(2.0*z_645*z_410 + 4.0*z_646*z_411 + 2.0*z_89*z_646 + 8.0*z_11*z_641 +
        8.0*z_641*z_412 + 8.0*z_643*z_413 + 406.0*z_21*z_83 + 6763323392.0*z_720 + 17272.0*sin_q5*z_721 +
        800000.0*z_725 + 17272.0*cos_q5*z_727 + 8.0*z_601*q2_ddot + 6763323392.0*z_705 + 800000.0*z_708 +
        17272.0*z_715 + 40.0*z_329*z_689 + 6002.0*z_215*z_695 - 4.0*z_90*z_645 - z_145*z_650 - 2.0*z_30*z_667 -
        z_28*z_672 - 4.0*z_21*z_680 - 4.0*z_16*z_682 - 8.0*(100000.0*z_717 + 2159.0*cos_q5*z_718 + 292320.0*z_625
        - 845415424.0*cos_q4 - 2159.0*z_719*z_148)*q3_ddot - 11520.0*z_723 - 11520.0*z_707 - 17272.0*sin_q3*z_716
        - 640.0*z_339*z_697 - 80.0*z_211*z_699 - 13600000.0*z_603) - cos_q4*(4.0*z_645*z_411 + 2.0*z_89*z_645 +
        4.0*z_90*z_646 + 8.0*z_641*z_413 + z_28*z_667 + 4.0*z_16*z_680 + 80.0*(43180.0*z_728 + 8.0*cos_q5*z_729 +
        170000.0*z_605)*q3_ddot + 80.0*z_606*q2_ddot + 9944598320.0*z_731 + 13600000.0*z_731*z_468 +
        640.0*cos_q5*z_735 + 60020.0*z_215*z_689 + 8.0*z_211*z_700 + 3454400.0*z_734 + 13600000.0*z_609 -
        2.0*z_646*z_410 - 8.0*z_11*z_643 - 8.0*z_643*z_412 - 406.0*z_21*z_145 - z_83*z_650 - 2.0*z_30*z_672 -
        4.0*z_21*z_682 - 172720.0*sin_q3*z_714 - 4.0*z_329*z_695 - 49743360.0*z_733));
    const double z_736 = z_135*z_719;
    D[28] = (1.0/40000000000.0)*(sin_q5*(406.0*z_416 + 406.0*z_417 + 8636.0*cos_q4*z_149 + 640.0*z_421*z_640 +
        z_143*z_655 + z_656*z_139 + z_58*z_669 + 640.0*z_23*z_679 + 17272.0*z_718*z_720 + 640.0*z_229*z_697 +
        6002.0*z_211*z_690 - 8636.0*cos_q4*z_418 - 2.0*z_624*z_419 - 2.0*z_113*z_624 - 2.0*z_635*z_420 -
        2.0*z_111*z_635 - 640.0*z_86*z_640 - z_55*z_670 - 812.0*q3_ddot*z_736 - 812.0*z_721 - 17272.0*cos_q4*z_727
        - 640.0*z_729*z_730 - 812.0*q2_ddot*z_610 - 640.0*q2_ddot*z_611 - 640.0*sin_q4*z_735 - 4.0*z_442*z_704 -
        17272.0*z_571*z_705 - 17272.0*z_444*z_709 - 406.0*q1_ddot*z_423 - 8636.0*z_338*z_542 - 2.0*z_335*z_693 -
        640.0*z_614) + cos_q5*(406.0*z_149 + 2.0*z_113*z_635 + 2.0*z_635*z_419 + 640.0*z_87*z_640 + z_143*z_656 +
        640.0*z_40*z_679 + 812.0*z_718*q3_ddot + 17272.0*z_720*z_736 + 17272.0*cos_q4*z_721 +
        27200000.0*z_731*z_612 + 17272.0*z_705*z_610 + 17272.0*z_444*z_704 + 640.0*z_215*z_697 +
        8636.0*z_542*z_423 + 2.0*z_335*z_690 + 6002.0*z_211*z_693 + 13600000.0*z_616 - 406.0*z_418 -
        8636.0*cos_q4*z_416 - 8636.0*cos_q4*z_417 - 2.0*z_111*z_624 - 2.0*z_624*z_420 - 640.0*z_422*z_640 -
        z_655*z_139 - z_55*z_669 - z_58*z_670 - 640.0*z_729*q4_ddot - 812.0*z_571*q2_ddot - 4.0*z_442*z_709 -
        406.0*z_338*q1_ddot - 2338560.0*z_726));
    D[29] = ((-1.0/40000000000.0))*(cos_q6*(2.0*z_626*z_426 + 8636.0*sin_q4*z_130 + 8636.0*sin_q4*z_427 +
        2.0*z_114*z_630 + 2.0*z_630*z_428 + 640.0*z_101*z_638 + 640.0*z_104*z_639 + 640.0*z_639*z_431 + z_67*z_657
        + z_60*z_661 + 640.0*z_46*z_678 + 640.0*z_617 - 2.0*z_626*z_119 - 2.0*z_93*z_634 - 2.0*z_634*z_429 -
        640.0*z_638*z_430 - z_79*z_653 - z_36*z_665 - 640.0*z_41*z_677) - sin_q6*(2.0*z_626*z_130 +
        8636.0*sin_q4*z_119 + 2.0*z_626*z_427 + 640.0*z_101*z_639 + z_36*z_661 + z_60*z_665 + 640.0*z_46*z_677 +
        640.0*z_41*z_678 + 640.0*z_618 - 8636.0*sin_q4*z_426 - 2.0*z_630*z_429 - 2.0*z_93*z_630 - 2.0*z_634*z_428
        - 2.0*z_114*z_634 - 640.0*z_104*z_638 - 640.0*z_638*z_431 - 640.0*z_639*z_430 - z_79*z_657 - z_67*z_653));
    D[30] = ((-1.0/40000000000.0))*(17272.0*z_272*z_647 + 2.0*z_277*z_644 + 2.0*z_276*z_644 + 8636.0*cos_q2*z_674
        + z_213*z_687 + z_432 - 2.0*z_278*z_644 - 2.0*z_275*z_644 - 2.0*z_284*z_649 - 2.0*z_283*z_649 -
        2.0*z_282*z_649 - 2.0*z_281*z_649 - z_210*z_683 - z_209*z_683 - z_214*z_687);
    const double z_737 = ((2.0*z_85*z_641 + sin_q4*z_680 - 2.0*z_84*z_643 - cos_q4*z_682) + 0.5*(z_24*z_644 -
        z_25*z_644)) + 0.5*((z_19*z_649 + z_20*z_649) - 203.0*(z_675 + (48000.0/29.0)*z_685));
    D[31] = ((-1.0/20000000000.0))*(8636.0*z_8*z_702 + 8636.0*z_10*z_636 + 8636.0*z_1*z_647 + 4318.0*sin_q3*z_710
        + 4318.0*cos_q3*z_703 + 4318.0*z_620 - 2.0*z_737);
    D[32] = ((-1.0/20000000000.0))*(8636.0*z_9*z_702 + 8636.0*z_4*z_636 - 2.0*z_737);
    D[33] = (1.0/20000000000.0)*(2.0*z_52*z_645 + z_51*z_645 + 2.0*z_31*z_646 + 4.0*z_44*z_641 + 4.0*z_43*z_641 +
        4.0*z_22*z_643 + 320.0*z_686 + 2.0*z_202 - z_29*z_646 - 4.0*z_17*z_643);
    D[34] = ((-1.0/20000000000.0))*(203.0*z_144 + 4318.0*z_248*z_143 + z_59*z_624 + 320.0*z_167*z_640 +
        320.0*z_166*z_640 + 320.0*z_681 - 4318.0*z_225*z_139 - z_56*z_624 - z_136*z_635 - z_137*z_635 -
        400000.0*z_621);
    D[35] = ((-1.0/20000000000.0))*(z_80*z_626 + 4318.0*sin_q4*z_140 + z_68*z_626 + z_73*z_630 + 320.0*z_69*z_639
        - 4318.0*sin_q4*z_141 - z_72*z_630 - z_50*z_634 - z_61*z_634 - 320.0*z_48*z_638 - 320.0*z_42*z_638 -
        320.0*z_70*z_639 - 320.0*z_622);
    const double z_738 = 9.0 + 625.0*load;
    const double z_739 = sin_q5*z_738;
    const double z_740 = 3027.0 + 500000.0*load;
    const double z_741 = 3750.0 + z_740;
    const double z_742 = 4250.0 - z_741;
    const double z_743 = 8636.0*z_739 - 5.0*z_742*z_608;
    const double z_744 = cos_q4*z_743;
    const double z_745 = sin_q4*z_739;
    const double z_746 = z_248*z_738;
    const double z_747 = cos_q5*cos_q5;
    const double z_748 = z_741*z_468;
    const double z_749 = 3001.0*z_745 + 5.0*(16250.0 + 4250.0*z_747 + z_748) - 406.0*z_746;
    const double z_750 = 9016.0*z_133;
    const double z_751 = 8636.0*z_54;
    const double z_752 = z_98 + cos_q5*z_45;
    const double z_753 = sin_q5*z_94 + z_23*sin_q6 - cos_q6*z_752;
    const double z_754 = 8636.0*z_35;
    const double z_755 = cos_q5*z_754;
    const double z_756 = cos_q6*z_751 - sin_q6*z_755;
    const double z_757 = load*(4000.0*z_753 - z_756);
    const double z_758 = 640.0*z_753 - z_756;
    const double z_759 = 100.0*z_757 + 9.0*z_758;
    const double z_760 = sin_q5*z_106 + sin_q6*z_752 + z_23*cos_q6;
    const double z_761 = cos_q6*z_755 + sin_q6*z_751;
    const double z_762 = load*(4000.0*z_760 + z_761);
    const double z_763 = 640.0*z_760 + z_761;
    const double z_764 = 100.0*z_762 + 9.0*z_763;
    const double z_765 = 34.0*z_751 + sin_q6*z_764 - cos_q6*z_759;
    const double z_766 = 82.0*z_750 + z_765;
    const double z_767 = 9016.0*z_33;
    const double z_768 = 34.0*z_755 + sin_q6*z_759 + cos_q6*z_764 - 640.0*q6_dot*z_739;
    const double z_769 = z_135*z_754*z_468 + cos_q5*z_768;
    const double z_770 = 82.0*z_767 + z_769;
    const double z_771 = z_159 + 640.0*z_739*z_84 - cos_q4*z_766 - sin_q4*z_770;
    const double z_772 = sin_q5*z_184*z_754 - sin_q5*z_768;
    const double z_773 = 9375.0*z_760 + 625.0*z_762 + 9.0*z_763;
    const double z_774 = 9375.0*z_753 + 625.0*z_757 + 9.0*z_758;
    const double z_775 = 18750.0*z_752 + sin_q6*z_773 - cos_q6*z_774;
    const double z_776 = z_95 + sin_q5*z_45;
    const double z_777 = 184828.0*z_750 + 2159.0*z_765 + 160.0*(112500.0*z_45 + cos_q5*z_775 +
        21250.0*sin_q5*z_776 - 5.0*q5_dot*z_748 - 21250.0*q5_dot*z_747);
    const double z_778 = sin_q5*z_740;
    const double z_779 = 25000.0*z_23 + cos_q6*z_773 + sin_q6*z_774 - 5.0*q6_dot*z_778;
    const double z_780 = 18000000.0*z_23 + 184828.0*z_767 + 2159.0*z_769 + 160.0*z_779;
    const double z_781 = 3001.0*z_772 + 4.0*(sin_q4*z_187 + cos_q4*z_192 + 160.0*z_84*z_743 - cos_q4*z_777 -
        sin_q4*z_780);
    const double z_782 = z_156 + 640.0*q4_dot*z_746 + sin_q4*z_766 - cos_q4*z_770;
    const double z_783 = sin_q5*z_775 - 21250.0*cos_q5*z_776 - 5.0*cos_q5*z_95*z_742;
    const double z_784 = 406.0*z_771 + 3001.0*z_782 + 640.0*z_783;
    const double z_785 = z_738*z_615;
    const double z_786 = 6777.0 + 500000.0*load;
    const double z_787 = 81250.0*q1_ddot + (21250.0*q1_ddot*z_747 + 5.0*z_786*z_602 + 3001.0*z_745*q1_ddot) -
        406.0*z_785;
    const double z_788 = 4250.0 - z_786;
    const double z_789 = 20000.0*z_438*z_612 + 8636.0*z_785 - 5.0*cos_q5*z_788*z_615;
    D[37] = ((-1.0/40000000000.0))*(sin_q2*(640.0*z_744*z_261 + 640.0*z_744*z_262 + 8636.0*q1_dot*z_771 +
        z_784*z_260 + 640.0*cos_q3*z_787 + 640.0*sin_q3*z_789 - 640.0*z_749*z_270 - 640.0*z_749*z_271 -
        z_781*z_269 - 5527040.0*z_785) - cos_q2*(5527040.0*z_206*z_746 + 640.0*cos_q3*z_789 - 640.0*z_744*z_270 -
        640.0*z_744*z_271 - 640.0*z_749*z_261 - 640.0*z_749*z_262 - z_781*z_260 - z_784*z_269 -
        640.0*sin_q3*z_787));
    D[38] = ((-1.0/40000000000.0))*(sin_q3*(5527040.0*z_745*z_399 + 640.0*z_13*z_744 + 640.0*z_744*z_400 +
        8636.0*q2_dot*z_772 + z_6*z_784 + 640.0*cos_q2*z_787 + 640.0*sin_q2*z_789 - 640.0*z_2*z_749 -
        640.0*z_749*z_401 - z_1*z_781) + cos_q3*(640.0*z_744*z_401 + 640.0*z_2*z_744 + 640.0*z_749*z_400 +
        640.0*z_13*z_749 + z_6*z_781 + z_1*z_784 + 640.0*sin_q2*z_787 - 8636.0*q2_dot*z_782 -
        5527040.0*z_745*q2_ddot - 640.0*cos_q2*z_789));
    const double z_790 = z_739*q1_ddot;
    const double z_791 = sin_q5*z_786;
    const double z_792 = q3_ddot*z_791 + q2_ddot*z_791;
    const double z_793 = z_739*q2_ddot;
    D[39] = (1.0/40000000000.0)*(sin_q4*((z_28*z_83 + 2.0*z_30*z_145 + 4.0*z_16*z_187 + 4.0*z_21*z_192) +
        640.0*z_739*z_410 + 640.0*z_11*z_743 + 640.0*z_743*z_412 + 1280.0*z_329*z_790 + 3200.0*z_339*z_788*z_553 -
        1280.0*z_739*z_90 - 2.0*z_30*z_766 - z_28*z_770 - 4.0*z_21*z_777 - 4.0*z_16*z_780 - 5527040.0*z_211*z_790)
        - cos_q4*((2.0*z_30*z_83 + 4.0*z_21*z_187 - z_28*z_145 - 4.0*z_16*z_192 - 12800000.0*z_222*z_438) +
        1280.0*z_739*z_411 + 640.0*z_739*z_89 + 640.0*z_743*z_413 + z_28*z_766 + 4.0*z_16*z_777 +
        3200.0*cos_q5*z_792 + 5527040.0*z_793 + 1920640.0*z_739*z_613 + 5527040.0*z_739*q3_ddot - 2.0*z_30*z_770 -
        4.0*z_21*z_780 - 13600000.0*z_357*z_608 - 5527040.0*z_739*z_360));
    const double z_794 = z_58*z_148;
    D[40] = ((-1.0/40000000000.0))*(sin_q5*(13600000.0*z_177 + 13600000.0*z_181 + 1600000.0*q6_ddot +
        27200000.0*cos_q5*q4_ddot + 3200.0*z_179*z_741 + z_143*z_754 + z_754*z_794 + z_55*z_768 +
        13600000.0*z_357*z_612 + 3200.0*z_211*z_786*z_615 - 13600000.0*z_180 - 13600000.0*z_250*q1_ddot -
        640.0*z_415 - 3200.0*z_178*z_741 - 640.0*z_45*z_165 - 640.0*z_23*z_775 - 13600000.0*z_40*z_776 -
        3200.0*sin_q4*z_792 - 13600000.0*cos_q5*z_613) - cos_q5*(13600000.0*z_97 + 640.0*z_176 + 13600000.0*z_592
        + 3200.0*z_96*z_741 + 12800000.0*z_212*z_438 + z_754*z_139 + z_55*z_754*z_148 + 640.0*z_40*z_775 +
        6400.0*q4_ddot*z_791 + 640.0*z_333*q1_ddot - 13600000.0*z_99 - 800000.0*z_414 - 3200.0*z_100*z_741 -
        800000.0*z_45*z_169 - z_58*z_768 - 13600000.0*z_23*z_776 - 640.0*z_729*q3_ddot - 640.0*z_604*q2_ddot -
        13600000.0*z_226*q1_ddot - 3200.0*z_613*z_791));
    const double z_795 = z_36*z_739;
    const double z_796 = z_60*z_739;
    D[41] = (1.0/40000000000.0)*(cos_q6*(640.0*sin_q5*z_424 + 640.0*sin_q5*z_174 + 640.0*z_739*z_125 +
        640.0*z_106*z_795 + 3200.0*z_120*z_778 + 3200.0*z_122*z_778 + 3200.0*z_121*z_778 + 640.0*z_23*z_162 +
        z_67*z_755 + z_60*z_759 + 640.0*z_46*z_774 - 640.0*z_739*z_126 - 640.0*z_94*z_796 - 3200.0*z_123*z_778 -
        640.0*z_160*z_752 - z_79*z_751 - z_36*z_764 - 640.0*z_41*z_773) - sin_q6*(640.0*sin_q5*z_175 +
        3200.0*z_102*z_778 + z_36*z_759 + z_60*z_764 + 640.0*z_46*z_773 + 640.0*z_41*z_774 - 640.0*sin_q5*z_425 -
        640.0*z_106*z_796 - 640.0*z_739*z_109 - 640.0*z_94*z_795 - 640.0*z_739*z_115 - 3200.0*z_105*z_778 -
        3200.0*z_103*z_778 - 3200.0*z_107*z_778 - 640.0*z_162*z_752 - 640.0*z_23*z_160 - z_79*z_755 -
        z_67*z_751));
    D[42] = (1.0/40000000000.0)*(5527040.0*z_272*z_746 + 640.0*z_277*z_744 + 640.0*z_276*z_744 +
        8636.0*cos_q2*z_771 + z_214*z_784 - 640.0*z_278*z_744 - 640.0*z_275*z_744 - 640.0*z_284*z_749 -
        640.0*z_283*z_749 - 640.0*z_282*z_749 - 640.0*z_281*z_749 - z_210*z_781 - z_209*z_781 - z_213*z_784);
    const double z_797 = (z_772 - (2.0/203.0)*(160.0*z_85*z_743 + sin_q4*z_777 + z_202 - cos_q4*z_780)) -
        (320.0/203.0)*((z_24*z_744 - z_25*z_744) + (z_19*z_749 + z_20*z_749));
    D[43] = (1.0/20000000000.0)*(2763520.0*z_745*z_8 + 2763520.0*z_1*z_746 + 4318.0*sin_q3*z_782 +
        4318.0*cos_q3*z_772 + 203.0*z_797);
    D[44] = (1.0/20000000000.0)*(2763520.0*z_9*z_745 + 203.0*z_797);
    D[45] = ((-1.0/62500000.0))*(2.0*z_30*z_745 + z_28*z_746 + z_44*z_743 + z_16*z_744 - z_783);
    D[46] = ((-1.0/62500000.0))*(5.0*sin_q5*z_167*z_742 + z_186 - 5.0*z_23*z_748 - 21250.0*z_23*z_747 - z_779);
    D[47] = (1.0/62500000.0)*(sin_q5*z_190 - sin_q5*z_189 - 2500.0*z_776 - z_796 - 5.0*z_46*z_778);
    const double z_798 = cos_q5*z_738;
    const double z_799 = 8636.0*z_798 + 5.0*(5000.0 + z_740);
    const double z_800 = 3001.0*z_739 + sin_q4*z_799;
    const double z_801 = z_448*z_738;
    const double z_802 = z_225*z_738;
    const double z_803 = 406.0*z_801 + 3001.0*z_802;
    const double z_804 = z_106 + z_168*cos_q6;
    const double z_805 = sin_q6*z_138;
    const double z_806 = load*(4000.0*z_804 + z_805);
    const double z_807 = 640.0*z_804 + z_805;
    const double z_808 = 100.0*z_806 + 9.0*z_807;
    const double z_809 = z_94 + z_168*sin_q6;
    const double z_810 = cos_q6*z_138;
    const double z_811 = load*(4000.0*z_809 - z_810);
    const double z_812 = 640.0*z_809 - z_810;
    const double z_813 = 100.0*z_811 + 9.0*z_812;
    const double z_814 = cos_q6*z_808 + sin_q6*z_813 - 640.0*q6_dot*z_738;
    const double z_815 = z_794 - z_55*z_184;
    const double z_816 = 34.0*z_138 + sin_q6*z_808 - cos_q6*z_813;
    const double z_817 = 640.0*q5_dot*z_739 + z_200 - sin_q5*z_815 - cos_q5*z_816;
    const double z_818 = 640.0*z_85*z_798 - cos_q4*z_814 - sin_q4*z_817;
    const double z_819 = z_144 + cos_q5*z_815 - 640.0*z_738*z_98 - sin_q5*z_816;
    const double z_820 = 9375.0*z_809 + 625.0*z_811 + 9.0*z_812;
    const double z_821 = 9375.0*z_804 + 625.0*z_806 + 9.0*z_807;
    const double z_822 = 18750.0*z_168 + sin_q6*z_820 + cos_q6*z_821 - 5.0*q6_dot*z_740;
    const double z_823 = 2159.0*z_814 + 160.0*(cos_q5*z_822 + z_170 - 21250.0*sin_q5*z_41);
    const double z_824 = cos_q6*z_820 - sin_q6*z_821;
    const double z_825 = 2159.0*z_817 + 160.0*z_824;
    const double z_826 = 3001.0*z_819 - 4.0*(160.0*z_85*z_799 - cos_q4*z_823 - sin_q4*z_825);
    const double z_827 = 640.0*q4_dot*z_801 + cos_q4*z_817 - sin_q4*z_814;
    const double z_828 = z_186 - sin_q5*z_822 - 21250.0*cos_q5*z_41;
    const double z_829 = 406.0*z_818 - 3001.0*z_827 - 640.0*z_828;
    const double z_830 = q1_ddot*z_801;
    const double z_831 = (20000.0*sin_q5*z_438 + 3001.0*q1_ddot*z_802) + 406.0*z_830;
    const double z_832 = q1_ddot*z_798;
    const double z_833 = 8027.0 + 500000.0*load;
    const double z_834 = 8636.0*z_832 + 5.0*q1_ddot*z_833;
    const double z_835 = 3001.0*z_790 + sin_q4*z_834 - 20000.0*z_225*z_438;
    D[49] = ((-1.0/40000000000.0))*(sin_q2*(640.0*z_800*z_261 + 640.0*z_800*z_262 + 640.0*z_803*z_270 +
        640.0*z_803*z_271 + 640.0*sin_q3*z_835 - 8636.0*q1_dot*z_818 - z_826*z_269 - z_829*z_260 - 5527040.0*z_830
        - 640.0*cos_q3*z_831) - cos_q2*(5527040.0*z_206*z_801 + 640.0*z_803*z_261 + 640.0*z_803*z_262 +
        z_829*z_269 + 640.0*sin_q3*z_831 + 640.0*cos_q3*z_835 - 640.0*z_800*z_270 - 640.0*z_800*z_271 -
        z_826*z_260));
    D[50] = (1.0/40000000000.0)*(sin_q3*(5527040.0*z_793 + 5527040.0*z_802*z_399 + z_1*z_826 + z_6*z_829 +
        640.0*cos_q2*z_831 - 640.0*z_13*z_800 - 640.0*z_800*z_400 - 640.0*z_2*z_803 - 640.0*z_803*z_401 -
        8636.0*q2_dot*z_819 - 640.0*sin_q2*z_835) + cos_q3*(5527040.0*z_739*z_399 + 640.0*z_803*z_400 +
        640.0*z_13*z_803 + 8636.0*q2_dot*z_827 + z_1*z_829 + 640.0*sin_q2*z_831 + 640.0*cos_q2*z_835 -
        640.0*z_800*z_401 - 640.0*z_2*z_800 - z_6*z_826 - 5527040.0*q2_ddot*z_802));
    D[51] = ((-1.0/40000000000.0))*(sin_q4*(1280.0*z_798*z_411 + 640.0*z_89*z_798 + 640.0*z_799*z_413 +
        5527040.0*q3_ddot*z_798 + 5527040.0*q2_ddot*z_798 + 1920640.0*z_798*z_613 + 3200.0*q2_ddot*z_833 +
        3200.0*q3_ddot*z_833 - 12800000.0*z_339*z_438 - 2.0*z_30*z_814 - z_28*z_817 - 4.0*z_21*z_823 -
        4.0*z_16*z_825 - 5527040.0*z_360*z_798) - cos_q4*(1280.0*z_90*z_798 + z_28*z_814 + 4.0*z_16*z_823 +
        640.0*z_211*z_834 - 640.0*z_798*z_410 - 640.0*z_11*z_799 - 640.0*z_799*z_412 - 2.0*z_30*z_817 -
        4.0*z_21*z_825 - 1280.0*z_329*z_832));
    const double z_836 = z_738*q2_ddot;
    const double z_837 = z_738*q1_ddot;
    D[52] = (1.0/40000000000.0)*(sin_q5*((z_55*z_139 + 800000.0*z_23*z_169 + 12800000.0*z_229*z_438 - z_58*z_143 -
        640.0*z_40*z_165) + 640.0*z_738*z_420 + 640.0*z_738*z_111 + 13600000.0*z_40*z_41 - z_58*z_815 - z_55*z_816
        - 640.0*z_23*z_822 - 5527040.0*z_738*z_720 - 5527040.0*z_444*z_836 - 640.0*z_335*z_837) +
        cos_q5*((z_58*z_139 + z_55*z_143 + 640.0*z_23*z_165 + 800000.0*z_40*z_169 + 12800000.0*z_215*z_438) +
        z_55*z_815 + 1920640.0*z_211*z_837 - 640.0*z_738*z_113 - 640.0*z_738*z_419 - z_58*z_816 - 640.0*z_40*z_822
        - 13600000.0*z_23*z_41 - 259840.0*z_738*q3_ddot - 1280.0*z_442*z_836));
    const double z_838 = z_36*z_738;
    const double z_839 = z_60*z_738;
    D[53] = ((-1.0/40000000000.0))*(cos_q6*(640.0*z_175 + 640.0*z_738*z_115 + 640.0*z_94*z_838 + 640.0*z_738*z_109
        + 640.0*z_106*z_839 + 3200.0*z_107*z_740 + 3200.0*z_105*z_740 + 3200.0*z_103*z_740 - 640.0*z_425 -
        3200.0*z_102*z_740 - 640.0*z_168*z_160 - z_138*z_67 - z_60*z_808 - z_36*z_813 - 640.0*z_41*z_820 -
        640.0*z_46*z_821) + sin_q6*(640.0*z_174 + 640.0*z_424 + 640.0*z_94*z_839 + 640.0*z_738*z_126 +
        3200.0*z_123*z_740 + 640.0*z_168*z_162 + z_36*z_808 + 640.0*z_41*z_821 - 640.0*z_106*z_838 -
        640.0*z_738*z_125 - 3200.0*z_122*z_740 - 3200.0*z_121*z_740 - 3200.0*z_120*z_740 - z_138*z_79 - z_60*z_813
        - 640.0*z_46*z_820));
    D[54] = (1.0/40000000000.0)*(5527040.0*z_272*z_801 + 640.0*z_277*z_800 + 640.0*z_276*z_800 + 640.0*z_284*z_803
        + 640.0*z_283*z_803 + 640.0*z_282*z_803 + 640.0*z_281*z_803 + z_213*z_829 - 640.0*z_278*z_800 -
        640.0*z_275*z_800 - 8636.0*cos_q2*z_818 - z_210*z_826 - z_209*z_826 - z_214*z_829);
    const double z_840 = (z_819 - (2.0/203.0)*(160.0*z_84*z_799 + cos_q4*z_825 - sin_q4*z_823)) -
        (320.0/203.0)*((z_24*z_800 - z_25*z_800) - (z_19*z_803 + z_20*z_803));
    D[55] = ((-1.0/20000000000.0))*(2763520.0*z_8*z_802 - 2763520.0*z_739*z_10 - 2763520.0*z_1*z_801 -
        4318.0*sin_q3*z_827 - 4318.0*cos_q3*z_819 - 203.0*z_840);
    D[56] = ((-1.0/20000000000.0))*(2763520.0*z_9*z_802 - 2763520.0*z_4*z_739 - 203.0*z_840);
    D[57] = (1.0/62500000.0)*(2.0*z_30*z_802 + z_22*z_799 + z_828 - z_28*z_801 - z_17*z_799);
    D[58] = ((-1.0/62500000.0))*(z_58*z_798 + z_55*z_739 + z_824);
    D[59] = (1.0/62500000.0)*(z_164 - z_838 - 5.0*z_41*(500.0 + z_740));
    const double z_841 = load*(4000.0*z_77);
    const double z_842 = 640.0*z_75;
    const double z_843 = 100.0*z_841 + 9.0*z_842;
    const double z_844 = load*(4000.0*z_65);
    const double z_845 = 640.0*z_63;
    const double z_846 = 100.0*z_844 + 9.0*z_845;
    const double z_847 = cos_q6*z_843 + z_142 - sin_q6*z_846;
    const double z_848 = z_81 - sin_q6*z_843 - cos_q6*z_846;
    const double z_849 = cos_q4*z_847 + z_448*z_848;
    const double z_850 = sin_q5*z_848;
    const double z_851 = 9375.0*z_49 + 625.0*z_844 + 9.0*z_845;
    const double z_852 = 9375.0*z_71 + 625.0*z_841 + 9.0*z_842;
    const double z_853 = sin_q6*z_851 + z_191 - cos_q6*z_852;
    const double z_854 = 2159.0*z_847 + 160.0*(2500.0*z_98 - cos_q5*z_853);
    const double z_855 = cos_q5*z_848;
    const double z_856 = z_164 - cos_q6*z_851 - sin_q6*z_852;
    const double z_857 = 2159.0*z_855 + 160.0*z_856;
    const double z_858 = 3001.0*z_850 - 4.0*(400000.0*sin_q5*z_84 - cos_q4*z_854 - sin_q4*z_857);
    const double z_859 = sin_q4*z_847 - z_225*z_848;
    const double z_860 = 2500.0*z_95 - sin_q5*z_853;
    const double z_861 = 406.0*z_849 - 3001.0*z_859 - 640.0*z_860;
    D[61] = (1.0/40000000000.0)*(sin_q2*(1600000.0*z_248*z_261 + 1600000.0*z_248*z_262 + 1600000.0*cos_q5*z_270 +
        1600000.0*cos_q5*z_271 + z_858*z_269 + 1600000.0*z_248*z_353 - 8636.0*q1_dot*z_849 - z_861*z_260 -
        1600000.0*cos_q5*z_348) + cos_q2*(1600000.0*z_248*z_270 + 1600000.0*z_248*z_271 - 1600000.0*cos_q5*z_261 -
        1600000.0*cos_q5*z_262 - z_858*z_260 - z_861*z_269 - 1600000.0*cos_q5*z_353 - 1600000.0*cos_q3*z_615));
    D[62] = (1.0/40000000000.0)*(sin_q3*(1600000.0*z_248*z_13 + 1600000.0*z_248*z_400 + 1600000.0*cos_q5*z_2 +
        1600000.0*cos_q5*z_401 + z_1*z_858 + 1600000.0*sin_q2*z_615 - 8636.0*q2_dot*z_850 - z_6*z_861 -
        1600000.0*cos_q5*z_356) + cos_q3*(1600000.0*z_248*z_401 + 1600000.0*z_248*z_2 - 1600000.0*cos_q5*z_400 -
        1600000.0*cos_q5*z_13 - 8636.0*q2_dot*z_859 - z_6*z_858 - z_1*z_861 - 1600000.0*cos_q5*z_355 -
        1600000.0*cos_q2*z_615));
    D[63] = (1.0/40000000000.0)*(sin_q4*(1600000.0*z_222*q1_ddot + 2.0*z_30*z_847 + z_28*z_855 + 4.0*z_21*z_854 +
        4.0*z_16*z_857 - 1600000.0*sin_q5*z_11 - 1600000.0*sin_q5*z_412) + cos_q4*(1600000.0*z_722 +
        1600000.0*z_706 + 1600000.0*sin_q5*z_413 + z_28*z_847 + 4.0*z_16*z_854 - 2.0*z_30*z_855 -
        4.0*z_21*z_857));
    D[64] = (1.0/40000000000.0)*(sin_q5*(1600000.0*z_87 + z_55*z_848 + 640.0*z_23*z_853 + 1600000.0*z_613 -
        1600000.0*q4_ddot - 1600000.0*z_422) + cos_q5*(1600000.0*z_86 + 1600000.0*z_731 + z_58*z_848 +
        640.0*z_40*z_853 - 1600000.0*z_421 - 1600000.0*z_229*q1_ddot));
    D[65] = (1.0/40000000000.0)*(cos_q6*((z_36*z_67 + 640.0*z_41*z_162 - z_60*z_79 - 640.0*z_46*z_160) +
        z_60*z_843 + 640.0*z_46*z_852 - z_36*z_846 - 640.0*z_41*z_851) + sin_q6*((z_60*z_67 + z_36*z_79 +
        640.0*z_41*z_160 + 640.0*z_46*z_162) - z_36*z_843 - z_60*z_846 - 640.0*z_46*z_851 - 640.0*z_41*z_852));
    D[66] = (1.0/40000000000.0)*(1600000.0*z_248*z_278 + 1600000.0*z_248*z_275 + 8636.0*cos_q2*z_849 + z_214*z_861
        - 1600000.0*z_248*z_277 - 1600000.0*z_248*z_276 - 1600000.0*cos_q5*z_284 - 1600000.0*cos_q5*z_283 -
        1600000.0*cos_q5*z_282 - 1600000.0*cos_q5*z_281 - z_210*z_858 - z_209*z_858 - z_213*z_861);
    const double z_862 = (z_850 + (2.0/203.0)*(400000.0*q4_dot*z_248 + sin_q4*z_854 - cos_q4*z_857)) +
        (800000.0/203.0)*((z_248*z_24 - z_248*z_25) - (cos_q5*z_19 + cos_q5*z_20));
    D[67] = (1.0/20000000000.0)*(4318.0*cos_q3*z_850 + 203.0*z_862 - 4318.0*sin_q3*z_859);
    D[68] = (1.0/20000000000.0)*(203.0*z_862);
    D[69] = (1.0/62500000.0)*(2500.0*z_21*z_612 + 2500.0*z_248*z_16 - z_860);
    D[70] = (1.0/62500000.0)*(2500.0*z_41 - z_856);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    D[0] = -1.0;
    const double q6 = x[5];
    const double sin_q6 = em_sin(q6);
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double q2_dot = v[1];
    const double q3_dot = v[2];
    const double z_2 = q2_dot + q3_dot;
    const double cos_q4 = em_cos(q4);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double q1_dot = v[0];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double z_6 = q1_dot*cos_q2;
    const double cos_q3 = em_cos(q3);
    const double sin_q2 = em_sin(q2);
    const double z_9 = q1_dot*sin_q2;
    const double z_10 = sin_q3*z_6 + cos_q3*z_9;
    const double z_11 = cos_q4*z_10;
    const double z_12 = sin_q4*z_2 - z_11;
    const double q5_dot = v[4];
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double z_14 = q5_dot*sin_q5;
    const double cos_q5 = em_cos(q5);
    const double q4_dot = v[3];
    const double z_16 = q4_dot*cos_q4;
    const double z_17 = q4_dot*sin_q4;
    const double z_18 = q2_dot*sin_q3;
    const double z_19 = q3_dot*cos_q3;
    const double z_20 = q2_dot*cos_q3;
    const double z_21 = q3_dot*sin_q3;
    const double z_22 = (z_18*z_9 - z_6*z_19) - (z_6*z_20 - z_9*z_21);
    const double z_23 = z_2*z_16 + (z_10*z_17 + cos_q4*z_22);
    const double z_24 = sin_q3*z_9 - cos_q3*z_6;
    const double z_25 = q4_dot - z_24;
    const double z_26 = q5_dot*cos_q5;
    const double z_27 = (z_6*z_18 + z_9*z_19) + (z_20*z_9 + z_6*z_21);
    const double z_28 = (z_12*z_14 - cos_q5*z_23) + (z_25*z_26 - sin_q5*z_27);
    const double z_29 = cos_q5*z_12 - sin_q5*z_25;
    const double q6_dot = v[5];
    const double cos_q6 = em_cos(q6);
    const double z_31 = q6_dot*cos_q6;
    const double z_32 = z_2*z_17 - (z_10*z_16 - sin_q4*z_22);
    const double z_33 = sin_q4*z_10;
    const double z_34 = cos_q4*z_2 + z_33;
    const double z_35 = q5_dot + z_34;
    const double z_36 = q6_dot*sin_q6;
    const double z_37 = z_24 - (8636.0/3001.0)*z_18;
    const double z_38 = 3001.0*z_37;
    const double z_39 = 203.0*z_24 - 4318.0*z_6;
    const double z_40 = z_34 + (1.0/8636.0)*(cos_q4*z_38 + 2.0*sin_q4*z_39);
    const double z_41 = 8636.0*z_40;
    const double z_42 = z_10 - (8636.0/3001.0)*z_20;
    const double z_43 = 406.0*z_2 - 3001.0*z_42;
    const double z_44 = cos_q5*z_41 - sin_q5*z_43;
    const double z_45 = 3001.0*z_27 - 8636.0*q3_dot*z_20;
    const double z_46 = 203.0*z_27 + 4318.0*q2_dot*z_9;
    const double z_47 = 8636.0*z_32 + (z_38*z_17 - cos_q4*z_45) - 2.0*(z_39*z_16 + sin_q4*z_46);
    const double z_48 = 3001.0*z_22 - 8636.0*q3_dot*z_18;
    const double z_49 = (z_41*z_14 + cos_q5*z_47) + (z_43*z_26 + sin_q5*z_48);
    const double z_50 = z_12 + (1.0/8636.0)*(sin_q4*z_38 - 2.0*cos_q4*z_39);
    const double z_51 = 8636.0*z_50;
    const double z_52 = 8636.0*z_23 + (z_38*z_16 + sin_q4*z_45) + 2.0*(z_39*z_17 - cos_q4*z_46);
    const double z_53 = 4000.0*(sin_q6*z_28 - z_29*z_31) - 4000.0*(cos_q6*z_32 + z_35*z_36) - (z_44*z_36 +
        cos_q6*z_49) - (z_51*z_31 + sin_q6*z_52);
    const double z_54 = sin_q2*sin_q3 - cos_q2*cos_q3;
    const double z_55 = cos_q2*sin_q3 + sin_q2*cos_q3;
    const double z_56 = cos_q4*cos_q5;
    const double z_57 = sin_q5*z_54 - z_55*z_56;
    const double z_58 = z_55*sin_q4;
    const double z_59 = z_55*sin_q5;
    const double z_60 = z_54*cos_q4;
    const double z_61 = cos_q2 - (203.0/4318.0)*z_54;
    const double z_62 = 4318.0*z_61;
    const double z_63 = 8636.0*z_58 + (3001.0*z_60 - 2.0*sin_q4*z_62);
    const double z_64 = 3001.0*z_59 + cos_q5*z_63;
    const double z_65 = z_55*cos_q4;
    const double z_66 = sin_q4*z_54;
    const double z_67 = 8636.0*z_65 - (3001.0*z_66 + 2.0*cos_q4*z_62);
    const double z_68 = 4000.0*(cos_q6*z_28 + z_29*z_36) + 4000.0*(sin_q6*z_32 - z_35*z_31) + (z_51*z_36 -
        cos_q6*z_52) - (z_44*z_31 - sin_q6*z_49);
    const double z_69 = (z_29*sin_q6 - z_35*cos_q6) - (1.0/4000.0)*(cos_q6*z_44 - sin_q6*z_51);
    const double z_70 = 4000.0*z_69;
    const double z_71 = sin_q2*z_18 + sin_q2*z_21 - cos_q2*z_19 - cos_q2*z_20;
    const double z_72 = z_55*z_17 + cos_q4*z_71;
    const double z_73 = cos_q2*z_18 + sin_q2*z_19 + sin_q2*z_20 + cos_q2*z_21;
    const double z_74 = z_54*z_26 + z_65*z_14 + cos_q5*z_72 + sin_q5*z_73;
    const double z_75 = z_55*z_16 - sin_q4*z_71;
    const double z_76 = 4318.0*q2_dot*sin_q2 + 203.0*z_73;
    const double z_77 = 8636.0*z_75 - (3001.0*z_54*z_17 + 2.0*z_16*z_62 - 3001.0*cos_q4*z_73 - 2.0*sin_q4*z_76);
    const double z_78 = 3001.0*z_55*z_26 + cos_q5*z_77 - z_63*z_14 - 3001.0*sin_q5*z_71;
    const double z_79 = 8636.0*z_72 + (3001.0*z_54*z_16 + 3001.0*sin_q4*z_73 - 2.0*z_17*z_62 - 2.0*cos_q4*z_76);
    const double z_80 = (z_29*cos_q6 + z_35*sin_q6) + (1.0/4000.0)*(cos_q6*z_51 + sin_q6*z_44);
    const double z_81 = 4000.0*z_80;
    const double z_82 = 4318.0*cos_q2 - 203.0*z_54;
    const double z_83 = 8636.0*z_65 - 3001.0*z_66 - 2.0*z_82*cos_q4 - 4000.0*z_57;
    const double q2_ddot = a[1];
    const double q3_ddot = a[2];
    const double z_84 = q2_ddot + q3_ddot;
    const double z_85 = sin_q4*z_84;
    const double q1_ddot = a[0];
    const double z_86 = cos_q3*q1_ddot;
    const double z_87 = sin_q3*q1_ddot;
    const double z_88 = sin_q2*z_86 + cos_q2*z_87;
    const double z_89 = z_85 - cos_q4*z_88;
    const double q4_ddot = a[3];
    const double z_90 = cos_q2*z_86 - sin_q2*z_87;
    const double z_91 = sin_q3*q2_ddot;
    const double z_92 = 8636.0*z_91 + 3001.0*z_90;
    const double z_93 = 203.0*z_90 + 4318.0*cos_q2*q1_ddot;
    const double z_94 = (z_43*z_14 - cos_q5*z_48) - (z_41*z_26 - sin_q5*z_47);
    const double z_95 = cos_q5*z_94;
    const double z_96 = cos_q5*z_43 + sin_q5*z_41;
    const double z_97 = z_96*z_14;
    const double z_98 = z_96*z_26;
    const double z_99 = cos_q5*z_96;
    const double z_100 = sin_q5*z_96;
    const double z_101 = z_84 + (4318.0/203.0)*cos_q3*q2_ddot;
    const double z_102 = 406.0*z_101 - 3001.0*z_88;
    const double z_103 = 8636.0*z_58 + 3001.0*z_60 - 2.0*sin_q4*z_82;
    const double z_104 = z_55*cos_q5;
    const double z_105 = sin_q5*z_103 - 3001.0*z_104;
    const double z_106 = cos_q5*z_105;
    const double z_107 = cos_q4*z_84;
    const double z_108 = z_107 + sin_q4*z_88;
    const double z_109 = 8636.0*z_108 - (cos_q4*z_92 + 2.0*sin_q4*z_93);
    const double z_110 = sin_q5*z_105;
    const double z_111 = 3001.0*z_59 + 4000.0*z_58 + z_103*cos_q5;
    const double q5_ddot = a[4];
    D[7] = ((-1.0/400000000.0))*(z_53*(4000.0*(sin_q6*z_57 - z_58*cos_q6) - (cos_q6*z_64 + sin_q6*z_67)) +
        z_68*(4000.0*(cos_q6*z_57 + z_58*sin_q6) - (cos_q6*z_67 - sin_q6*z_64)) + z_81*(4000.0*(z_57*z_36 -
        z_58*z_31 - cos_q6*z_74 - sin_q6*z_75) - (z_36*z_67 + z_31*z_64 + cos_q6*z_79 + sin_q6*z_78)) +
        z_83*(8636.0*z_89 + 4000.0*(cos_q5*z_89 - sin_q5*(q4_ddot + z_90)) - (sin_q4*z_92 - 2.0*cos_q4*z_93)) -
        z_70*(4000.0*(z_57*z_31 + z_58*z_36 + sin_q6*z_74 - cos_q6*z_75) + (z_36*z_64 + sin_q6*z_79 - z_31*z_67 -
        cos_q6*z_78)) - (3001.0*z_55*z_95 + 3001.0*z_55*z_97 + z_63*z_98 + 3001.0*z_71*z_99 + z_77*z_100 +
        z_102*z_106 + z_109*z_110 - sin_q5*z_94*z_63) - z_111*(4000.0*q5_ddot + 4000.0*z_108 - (sin_q5*z_102 -
        cos_q5*z_109)));
    D[10] = -1.0;
    const double load = c[1];
    const double z_112 = sin_q5*cos_q4;
    const double z_113 = z_104 - z_54*z_112;
    const double z_114 = z_55 + (1000.0/2159.0)*z_113;
    const double z_115 = 4318.0*z_61 - 4318.0*z_114;
    const double z_116 = z_113 + (29711.0/96.0)*(z_55 + (5075.0/178266.0)*z_54);
    D[15] = ((-1.0/200000.0))*(20880.0*sin_q2 + 576.0*z_116 - 759118.0*cos_q2 - 20.0*load*z_115);
    const double z_117 = sin_q4*cos_q5;
    const double z_118 = z_117*sin_q6 - cos_q4*cos_q6;
    const double z_119 = 203.0 + 4318.0*cos_q3;
    const double z_120 = cos_q4 - sin_q3*cos_q4;
    const double z_121 = sin_q5*z_119 - 4318.0*cos_q5*z_120;
    const double z_122 = sin_q4 - sin_q3*sin_q4;
    const double z_123 = z_117*cos_q6 + cos_q4*sin_q6;
    const double z_124 = z_16 - cos_q4*z_24;
    const double z_125 = sin_q4*z_14 + sin_q5*z_10 - cos_q5*z_124;
    const double z_126 = z_17 - sin_q4*z_24;
    const double z_127 = z_117*z_31 + cos_q4*z_36 + cos_q6*z_126 - sin_q6*z_125;
    const double z_128 = 3001.0*z_10 + 8636.0*z_19;
    const double z_129 = 203.0*z_10 + 4318.0*z_9;
    const double z_130 = 8636.0*z_126 - (8636.0*sin_q3*z_17 - cos_q4*z_128 - 2.0*sin_q4*z_129);
    const double z_131 = 3001.0*z_24 + 8636.0*z_21;
    const double z_132 = 2.0*z_119*z_26 + 8636.0*z_120*z_14 + cos_q5*z_130 - sin_q5*z_131;
    const double z_133 = 8636.0*z_124 - (8636.0*sin_q3*z_16 + sin_q4*z_128 - 2.0*cos_q4*z_129);
    const double z_134 = z_117*z_36 + cos_q6*z_125 + sin_q6*z_126 - cos_q4*z_31;
    const double g = c[0];
    const double z_135 = 1000.0*z_117 + 2159.0*z_122;
    const double z_136 = sin_q5*q4_ddot;
    const double z_137 = 2000.0*cos_q4 - z_121;
    const double z_138 = 203.0*z_101;
    const double z_139 = z_107 - cos_q4*z_91;
    const double z_140 = sin_q4*q1_ddot + (1000.0/2159.0)*z_117*q1_ddot;
    const double z_141 = sin_q5*z_120;
    const double z_142 = cos_q5*z_119 + 4318.0*z_141;
    const double z_143 = cos_q5*z_142;
    const double z_144 = 203.0*q1_ddot + 4318.0*z_86;
    const double z_145 = cos_q4*q1_ddot;
    const double z_146 = z_145 - cos_q4*z_87;
    D[16] = ((-1.0/400000000.0))*(2.0*z_53*(2000.0*z_118 + (cos_q6*z_121 + 4318.0*sin_q6*z_122)) +
        2.0*z_68*(2000.0*z_123 + (4318.0*cos_q6*z_122 - sin_q6*z_121)) + z_81*(4000.0*z_134 + (8636.0*z_122*z_36 +
        2.0*z_121*z_31 + sin_q6*z_132 - cos_q6*z_133)) + 4.0*z_83*(2159.0*z_140 - 2159.0*sin_q4*z_87) +
        (2.0*z_119*z_95 + 2.0*z_119*z_97 + 8636.0*z_141*z_94 + z_131*z_99 + z_130*z_100 - 8636.0*z_120*z_98 -
        4.0*z_138*z_143 - 17272.0*sin_q5*z_142*z_139 - 2.0*z_144*z_106 - 8636.0*z_146*z_110) - z_70*(4000.0*z_127
        - (2.0*z_121*z_36 - 8636.0*z_122*z_31 - cos_q6*z_132 - sin_q6*z_133)) - 40000.0*g*z_115 -
        16.0*z_135*(2159.0*z_85 - 1000.0*(z_136 - z_117*z_84) - 2159.0*sin_q4*z_91) - 4.0*z_137*(2000.0*q5_ddot +
        2000.0*z_107 - (sin_q5*z_138 - 4318.0*cos_q5*z_139)) - 2.0*z_111*(2000.0*z_145 - (sin_q5*z_144 -
        4318.0*cos_q5*z_146)));
    D[20] = -1.0;
    const double z_147 = 203.0*z_54 + 4318.0*z_114;
    D[24] = ((-1.0/200000.0))*(20.0*load*z_147 + 576.0*z_116);
    const double z_148 = sin_q5 - (4318.0/203.0)*z_56;
    const double z_149 = 203.0*z_148;
    const double z_150 = 3001.0*z_42;
    const double z_151 = 8636.0*z_126 + (406.0*z_33 + cos_q4*z_150);
    const double z_152 = 3001.0*z_37;
    const double z_153 = 406.0*z_26 + 8636.0*cos_q4*z_14 + cos_q5*z_151 - sin_q5*z_152;
    const double z_154 = 8636.0*z_124 + (406.0*z_11 - sin_q4*z_150);
    const double z_155 = 203.0*z_148 - 2000.0*cos_q4;
    const double z_156 = sin_q5*q3_ddot;
    const double z_157 = 2159.0*sin_q4 + 1000.0*z_117;
    const double z_158 = sin_q5*q2_ddot;
    const double z_159 = (203.0*cos_q5 + 4318.0*z_112)*q3_ddot;
    const double z_160 = sin_q5*q1_ddot;
    D[25] = ((-1.0/400000000.0))*(2.0*z_53*(2000.0*z_118 + (cos_q6*z_149 + 4318.0*sin_q4*sin_q6)) +
        2.0*z_68*(2000.0*z_123 + (4318.0*sin_q4*cos_q6 - sin_q6*z_149)) + z_81*(4000.0*z_134 + (8636.0*sin_q4*z_36
        + 2.0*z_149*z_31 + sin_q6*z_153 - cos_q6*z_154)) + 40000.0*g*z_147 + 4.0*z_155*(2000.0*q5_ddot +
        2000.0*cos_q4*q3_ddot - (203.0*z_156 - 4318.0*z_56*q3_ddot)) + 4.0*z_83*(2159.0*z_140) + (406.0*z_97 +
        406.0*z_95 + 8636.0*z_112*z_94 + z_152*z_99 + z_151*z_100 - 8636.0*cos_q4*z_98 - 812.0*cos_q5*z_159 -
        17272.0*z_112*z_159 - 812.0*q2_ddot*z_143 - 17272.0*z_142*z_112*q2_ddot - 406.0*q1_ddot*z_106 -
        8636.0*z_105*z_112*q1_ddot) - z_70*(4000.0*z_127 - (2.0*z_149*z_36 - 8636.0*sin_q4*z_31 - cos_q6*z_153 -
        sin_q6*z_154)) - 16.0*z_157*(2159.0*sin_q4*q3_ddot - 1000.0*(z_136 - z_117*q3_ddot)) -
        16.0*z_135*(2159.0*sin_q4*q2_ddot + 1000.0*z_117*q2_ddot) - 4.0*z_137*(2000.0*cos_q4*q2_ddot -
        (203.0*z_158 - 4318.0*z_56*q2_ddot)) - 2.0*z_111*(2000.0*z_145 - (203.0*z_160 - 4318.0*z_56*q1_ddot)));
    D[30] = -1.0;
    const double z_161 = 9.0 + 625.0*load;
    const double z_162 = sin_q5*z_58;
    D[33] = (1.0/3125.0)*(z_161*z_162);
    const double z_163 = 8636.0*z_50;
    const double z_164 = z_26 + cos_q5*z_34;
    const double z_165 = cos_q5*z_163;
    const double z_166 = 8636.0*z_40;
    D[34] = (1.0/400000000.0)*(4000.0*sin_q5*sin_q6*z_53 + 4000.0*sin_q5*cos_q6*z_68 + z_163*z_100 +
        z_81*(4000.0*(sin_q5*z_36 + z_12*sin_q6 - cos_q6*z_164) - (cos_q6*z_166 - sin_q6*z_165)) +
        80000000.0*g*z_162 + 16000000.0*q4_ddot*(sin_q5*sin_q5) + 4000.0*z_83*z_160 - z_70*(4000.0*(sin_q5*z_31 +
        sin_q6*z_164 + z_12*cos_q6) + (cos_q6*z_165 + sin_q6*z_166)) - 16000.0*z_157*z_156 - 16000.0*z_135*z_158);
    D[40] = -1.0;
    D[42] = (1.0/3125.0)*(z_161*z_57);
    const double z_167 = sin_q5*z_12 + cos_q5*z_25;
    D[43] = (1.0/400000000.0)*(16000000.0*q5_ddot + 4000.0*cos_q6*z_53 + z_70*(4000.0*(z_36 + z_167*sin_q6) -
        cos_q6*z_96) + z_81*(4000.0*(z_31 + z_167*cos_q6) + sin_q6*z_96) + 80000000.0*g*z_57 +
        8000.0*z_137*q2_ddot + (z_43*z_100 - z_41*z_99) + 4000.0*z_111*q1_ddot - 4000.0*sin_q6*z_68 -
        8000.0*z_155*q3_ddot);
    D[50] = -1.0;
    D[52] = ((-1.0/400000000.0))*(z_70*(4000.0*z_80) - z_81*(4000.0*z_69));
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes puma_lanes;
EM_WEAK em_lanes puma_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 12, 48, 0, 36 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double load = parameters[1];
    prepared[2] = 100.0*load; /* c_0 */
    const double z_0 = 43.0 + 100.0*load;
    prepared[3] = z_0; /* c_1 */
    prepared[4] = 20.0*load; /* c_2 */
    prepared[5] = 625.0*load; /* c_3 */
    prepared[6] = 43180.0*load; /* c_4 */
    prepared[7] = 100000.0*load; /* c_5 */
    prepared[8] = 2159.0*z_0; /* c_6 */
    prepared[9] = 3001.0*z_0; /* c_7 */
    prepared[10] = 203.0*z_0; /* c_8 */
    prepared[11] = 2500.0*load; /* c_9 */
    prepared[12] = 10150.0*z_0; /* c_10 */
    const double z_1 = 6777.0 + 500000.0*load;
    prepared[13] = 500000.0*z_1; /* c_11 */
    prepared[14] = 1250.0*load; /* c_12 */
    const double z_2 = 171348451657.0 + 40000000000.0*load;
    prepared[15] = (1.0/1000000000000.0)*z_2; /* c_13 */
    prepared[16] = (1.0/6250000.0)*(4250.0 - z_1); /* c_14 */
    const double g = parameters[0];
    const double z_3 = load*g;
    prepared[17] = 89133.0*g + 43180.0*z_3; /* c_15 */
    const double z_4 = 9.0*g + 625.0*z_3;
    prepared[18] = 32.0*z_4; /* c_16 */
    prepared[19] = 1015.0*(5.0*g + 4.0*z_3); /* c_17 */
    prepared[20] = 64.0*z_4; /* c_18 */
    prepared[21] = 4176000000.0*g; /* c_19 */
    prepared[22] = 6800000.0*(22327.0*g + 2540.0*z_3); /* c_20 */
    prepared[23] = 12800000.0*z_4; /* c_21 */
    prepared[24] = z_2; /* c_22 */
    prepared[25] = 960.0*g; /* c_23 */
    prepared[26] = 9.0*g; /* c_24 */
    prepared[27] = 34.0*g; /* c_25 */
    prepared[28] = 82.0*g; /* c_26 */
    prepared[29] = 34800.0*g; /* c_27 */
    prepared[30] = 100.0*z_3; /* c_28 */
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
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double cos_q2 = em_cos(q2);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_3 = cos_q2*sin_q3;
    const double cos_q3 = em_cos(q3);
    const double z_5 = sin_q2*cos_q3;
    const double z_6 = z_3 + z_5;
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double z_8 = z_6*sin_q4;
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double sin_q5 = em_sin(q5);
    const double z_11 = sin_q2*sin_q3;
    const double z_12 = cos_q2*cos_q3;
    const double z_13 = z_11 - z_12;
    const double z_14 = 4318.0*cos_q2 - 203.0*z_13;
    const double cos_q4 = em_cos(q4);
    const double z_16 = sin_q4*z_14 - 1500.5*z_13*cos_q4;
    const double z_17 = 8636.0*z_8 - 2.0*z_16;
    const double z_18 = z_6*sin_q5 + (1.0/3001.0)*z_17*cos_q5;
    const double z_19 = 4000.0*z_8 + 3001.0*z_18;
    const double c_0 = c[2];
    const double z_20 = 5760.0*z_8 + z_19*c_0 + 129043.0*z_18;
    const double z_21 = cos_q5*z_20;
    const double z_22 = sin_q5*z_17 - 3001.0*z_6*cos_q5;
    const double c_1 = c[3];
    const double z_23 = sin_q5*c_1;
    const double z_24 = 739312.0*z_8 + z_21 + z_22*z_23 - 164.0*z_16;
    const double z_25 = z_6*cos_q4;
    const double z_26 = sin_q5*z_13 - cos_q5*z_25;
    const double z_27 = sin_q4*z_13 + (2.0/3001.0)*z_14*cos_q4;
    const double z_28 = z_25 - (3001.0/8636.0)*z_27;
    const double z_29 = 8636.0*z_28 - 4000.0*z_26;
    const double c_2 = c[4];
    const double z_30 = 222132.0*z_25 + z_29*c_2 - 75025.0*z_27 - 1152.0*z_26;
    const double z_31 = sin_q4*z_24 + 5.0*cos_q4*z_30;
    const double z_32 = sin_q4*z_30 - (1.0/5.0)*cos_q4*z_24;
    const double c_3 = c[5];
    const double z_33 = z_29*c_3 + 77724.0*z_28 - 33885.0*z_26;
    const double z_34 = z_13*cos_q5 + sin_q5*z_25;
    const double z_35 = sin_q5*z_33 - 21250.0*cos_q5*z_34;
    const double z_36 = 5725482720.0*z_13 + 406.0*z_31 - 15005.0*z_32 - 640.0*z_35;
    const double z_37 = sin_q5*z_20;
    const double c_4 = c[6];
    const double z_38 = 497229916.0*z_25 + 32.0*cos_q5*z_33 + 680000.0*sin_q5*z_34 + z_29*c_4 - 166654533.0*z_27 -
        2487168.0*z_26;
    const double c_5 = c[7];
    const double c_6 = c[8];
    const double z_39 = sin_q5*c_6;
    const double z_40 = 1690830848.0*z_8 + 2159.0*z_21 + z_19*c_5 + z_22*z_39 + 4321440.0*z_18 - 369656.0*z_16;
    const double c_7 = c[9];
    const double z_41 = cos_q5*z_22;
    const double z_42 = 5803392000.0*cos_q2 + c_7*z_41 - 9492774802.0*z_6 - 3001.0*z_37 - 20.0*cos_q4*z_38 -
        4.0*sin_q4*z_40;
    M[0] = (1.0/1000000000000.0)*(130000000000.0*sin_q2*sin_q2 + 524000000000.0*cos_q2*cos_q2 +
        4350000.0*sin_q2*(207169.0*sin_q2 - 1632.0*cos_q2) + 25.0*z_11*z_36 + 1134029968642.0 -
        100.0*cos_q2*(70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_31 - 18759823020.0*cos_q2) - 25.0*z_3*z_42 -
        25.0*z_5*z_42 - 25.0*z_12*z_36);
    const double z_43 = cos_q5*c_1;
    const double c_8 = c[10];
    const double z_44 = (cos_q4*z_40 + 0.5*c_8*z_41) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_13) +
        (1.0/246082.0)*(z_37 + (10.0/203.0)*sin_q4*z_38));
    M[6] = M[1] = ((-1.0/20000000000.0))*(5383560000.0*sin_q2 + 475020000.0*cos_q2 + 4318.0*cos_q3*(1821922.0*z_6
        + z_37 - z_22*z_43) + 4318.0*sin_q3*(1575840.0*z_13 - 5.0*z_32) - 2.0*z_44);
    const double z_45 = sin_q3*cos_q4;
    const double z_46 = 4318.0*cos_q3 + 203.0;
    const double z_47 = cos_q4 - z_45;
    const double z_48 = sin_q5*z_46 - 4318.0*cos_q5*z_47;
    const double z_49 = 2000.0*cos_q4 - z_48;
    const double z_50 = 2880.0*cos_q4 + c_0*z_49 - 43.0*z_48;
    const double z_51 = cos_q5*z_50;
    const double z_52 = cos_q5*z_46 + 4318.0*sin_q5*z_47;
    const double z_53 = sin_q3*sin_q4;
    const double z_54 = sin_q4*cos_q5;
    const double z_55 = sin_q4 - z_53;
    const double z_56 = 1000.0*z_54 + 2159.0*z_55;
    const double z_57 = sin_q5*z_50;
    const double c_9 = c[11];
    const double z_58 = 33885.0*z_54 + z_56*c_9 + 77724.0*z_55;
    const double z_59 = sin_q5*sin_q5;
    const double z_60 = sin_q4*z_59 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_54);
    const double z_61 = (cos_q4*(845415424.0*cos_q4 + 2159.0*z_51 + z_49*c_5 + z_52*z_39 - 798087304.0*z_45 -
        1440.0*z_48) + 0.5*cos_q5*z_52*c_8) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_57 - (20.0/203.0)*sin_q4*(8.0*cos_q5*z_58 + z_56*c_4 + 170000.0*z_60 -
        119895747.0*z_53)));
    M[7] = (1.0/10000000000.0)*(4318.0*cos_q3*(2426716.0*cos_q3 + 16646.0 + z_52*z_43 - z_57) + 30547567588.0 +
        2.0*z_61 - 4318.0*sin_q3*(336000.0 + cos_q4*(369656.0*cos_q4 + z_51 + z_52*z_23 - 354076.0*z_45) +
        10.0*sin_q4*(55533.0*sin_q4 + 288.0*z_54 + z_56*c_2 - 53975.0*z_53) - 2072640.0*sin_q3));
    M[12] = M[2] = ((-1.0/20000000000.0))*(-2.0*z_44);
    M[13] = M[8] = (1.0/10000000000.0)*(1098579138.0 + 2.0*z_61);
    const double z_62 = 2159.0*sin_q4 + 1000.0*z_54;
    const double z_63 = 77724.0*sin_q4 + 33885.0*z_54 + z_62*c_9;
    const double z_64 = sin_q5 - (4318.0/203.0)*cos_q4*cos_q5;
    const double z_65 = 203.0*z_64 - 2000.0*cos_q4;
    const double z_66 = c_0*z_65 + 8729.0*z_64 - 2880.0*cos_q4;
    const double z_67 = 203.0*cos_q5 + 4318.0*sin_q5*cos_q4;
    const double c_10 = c[12];
    M[14] = (1.0/500000000000.0)*(1000.0*sin_q4*(8.0*cos_q5*z_63 + z_62*c_4 + 170000.0*z_60) + 10150.0*sin_q5*z_66
        + 343365622869.0 + cos_q5*z_67*c_10 - 100.0*cos_q4*(2159.0*cos_q5*z_66 + z_65*c_5 + 292320.0*z_64 -
        845415424.0*cos_q4 - z_67*z_39));
    M[18] = M[3] = ((-1.0/62500000.0))*(81250.0*z_13 - z_35);
    const double z_68 = sin_q5*sin_q4;
    const double z_69 = cos_q5*z_68;
    M[19] = M[9] = ((-1.0/62500000.0))*(sin_q5*z_58 - 21250.0*z_69);
    M[20] = M[15] = (1.0/62500000.0)*(21250.0*z_69 - sin_q5*z_63);
    const double c_11 = c[13];
    M[21] = (1.0/6250000000000.0)*(2125000000.0*cos_q5*cos_q5 + 1200566413273.0 + c_11*z_59);
    M[24] = M[4] = (1.0/62500000.0)*(40135.0*z_8 + z_19*c_3 + 27009.0*z_18);
    const double c_12 = c[14];
    M[25] = M[10] = (1.0/62500000.0)*(40135.0*cos_q4 + z_49*c_12 - 18.0*z_48);
    M[26] = M[16] = ((-1.0/62500000.0))*(z_65*c_12 + 3654.0*z_64 - 40135.0*cos_q4);
    M[27] = M[22] = 0.0;
    const double c_13 = c[15];
    M[28] = c_13;
    M[30] = M[5] = ((-1.0/25000.0))*z_34;
    M[31] = M[11] = (1.0/25000.0)*z_68;
    M[32] = M[17] = (1.0/25000.0)*z_68;
    M[33] = M[23] = (1.0/25000.0)*cos_q5;
    M[34] = M[29] = 0.0;
    M[35] = 48526126417.0/250000000000.0;
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
    real M1[N1][N1], shared[50];
    settled_masses(y, c, M1, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 48);
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
    em_spread(N, N1, coordinate1, y + 12, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 12);
    for (int i = 0; i < N1; ++i) y[48 + i] = s[coordinate1[i]];
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

#include "puma.h"

static const char *const coordinate_names[] = { "q1", "q2", "q3", "q4", "q5", "q6", NULL };
static const char *const parameter_names[] = { "g", "load", NULL };
static const char *const input_names[] = { "tau1", "tau2", "tau3", "tau4", "tau5", "tau6", NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 9.81, 0.0, 0.0 };
static const double input_defaults[] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
static const double initial_x[N] = { 0.0, 0.7853981633974483, 3.141592653589793, 0.0, 0.7853981633974483, 0.0 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 3},
    {"line", 3, 6},
    {"disk", 9, 8},
    {"line", 17, 6},
    {"disk", 23, 8},
    {"line", 31, 6},
    {"disk", 37, 8},
    {"line", 45, 6},
    {"line", 51, 6},
    {"disk", 57, 4},
    {"trace", 61, 3}
};
static const em_slice layout[] = {
    {"x", 0, 6},
    {"eta", 6, 6},
    {"C", 12, 36},
    {"s", 48, 6}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dq1, dM/dq6: M does not depend on them",
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
static int simulate(em_run *run) { return em_simulate(&puma_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&puma_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&puma_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&puma_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&puma_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&puma_model, run, mode); }

const em_model puma_model = {
    .abi = EM_ABI,
    .name = "puma",
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
    .event = model_events,
    .lanes = &puma_lanes,
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
    .n_shapes = 11,
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .motion_along = em_motion_along,
    .dynamics = &dynamics,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
