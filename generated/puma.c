/* eigenmotion generate puma.py */
/* input sha256:44f9309bb8b2d719e1a6d8e72a68752f8590b0520274b45dad0cbd7ef656c8aa */
/* body sha256:e58b92cb4e7f281150a561d67b9260e6ee9041c560eafc6fc55043e6dbe426ae */
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
#include "puma.h"

#include "em_functions.h"
#include "em_multipliers.h"

enum {
    N = 6,              /* coordinates */
    N_ROWS = 0,         /* constraint rows */
    N_POSITIONS = 0,    /* of which holonomic */
    N_STATE = 54,       /* numbers of a state */
    N_C = 36,           /* of which C, */
    N_S = 6,            /* s, */
    N_CD = 0,           /* C of Delta, */
    N_SD = 0,           /* s of Delta */
    N_INPUTS = 6,
    N_OUTPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 42,      /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,/* whether the state is x, xdot */
    SETTLES = 1,        /* whether an accepted step leaves anything to put right */
    N_PARAMETERS = 2,
    N_PREPARED = 42,    /* the parameters, factors of constant blocks, shared constants */
    N1 = 6,             /* q1, q2, q3, q4, q5, q6 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4, 5 };

#ifndef EM_ASIDE_ALONE

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
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
    const real c_8 = c[10];
    const real z_117 = 33885.0*z_101 + z_103*c_8 + 77724.0*z_102;
    const real z_118 = sin_q5*sin_q5;
    const real z_119 = sin_q4*z_118 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_101);
    const real z_120 = 33885.0*z_113 + z_115*c_8 + 77724.0*z_114;
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
    const real z_125 = 77724.0*sin_q4 + 33885.0*z_101 + z_124*c_8;
    const real z_126 = 2159.0*z_43 + 1000.0*z_113;
    const real z_127 = 77724.0*z_43 + 33885.0*z_113 + z_126*c_8;
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
    const real c_9 = c[11];
    Mdot1[3][3] = -c_9*z_121;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/62500000.0))*(40135.0*z_44 + z_57*c_3 + 27009.0*z_56);
    const real c_10 = c[12];
    Mdot1[1][4] = Mdot1[4][1] = ((-1.0/62500000.0))*(40135.0*z_51 + z_108*c_10 + 18.0*z_107);
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/62500000.0))*(40135.0*z_51 + z_133*c_10 + 3654.0*z_132);
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
    const real c_11 = c[13];
    const real c_12 = c[14];
    const real z_198 = c_11 + cos_q5*c_12;
    const real c_13 = c[15];
    const real c_14 = c[16];
    const real z_199 = c_13 - z_76*c_14;
    const real c_15 = c[17];
    const real c_16 = c[18];
    f1[1] = (1.0/40000000000.0)*(40000000000.0*tau2 + (sin_q2*(4.0*q1_dot*(4145280.0*z_143 +
        19792500.0*(12.0*q2_dot - 455.0*z_140) - 23664000.0*z_144 - 2159.0*z_182) + z_196*z_197 +
        400000.0*cos_q3*z_198 + 200000.0*sin_q3*z_199 + c_15 - 20960000000.0*cos_q2*z_139 - z_192*z_193) -
        cos_q2*(174000.0*q1_dot*(48.0*z_144 + 455.0*(136.0*q2_dot - 455.0*z_141)) + 200000.0*cos_q3*z_199 + c_16 -
        5200000000.0*sin_q2*z_139 - z_192*z_197 - z_196*z_193 - 400000.0*sin_q3*z_198)));
    const real tau3 = u[2];
    f1[2] = (1.0/40000000000.0)*(40000000000.0*tau3 + (sin_q3*(8636.0*q2_dot*(480.0*z_183 - z_184) + z_140*z_196 +
        400000.0*cos_q2*z_198 + 200000.0*sin_q2*z_199 - z_141*z_192) - cos_q3*(8636.0*q2_dot*(480.0*z_194 + z_195)
        + 200000.0*cos_q2*z_199 - z_140*z_192 - z_141*z_196 - 400000.0*sin_q2*z_198)));
    const real tau4 = u[3];
    const real c_17 = c[19];
    f1[3] = (1.0/40000000000.0)*(40000000000.0*tau4 + (sin_q4*(2.0*z_150*z_176 + 4.0*z_142*z_190 - z_149*z_181 -
        4.0*z_145*z_191 - z_12*c_17) + cos_q4*(z_149*z_176 + 2.0*z_150*z_181 + 4.0*z_145*z_190 +
        4.0*z_142*z_191)));
    const real tau5 = u[4];
    const real z_200 = c_1*z_178;
    f1[4] = (1.0/40000000000.0)*(40000000000.0*tau5 - (sin_q5*(z_164*z_200 + z_162*z_179 + 640.0*z_146*z_187 +
        800000.0*z_155*z_189 + z_15*c_17) - cos_q5*(z_162*z_200 + 800000.0*z_146*z_189 + z_28*c_17 - z_164*z_179 -
        640.0*z_155*z_187)));
    const real tau6 = u[5];
    f1[5] = (1.0/40000000000.0)*(40000000000.0*tau6 + (cos_q6*(z_165*z_169 + z_153*z_174 + 640.0*z_156*z_185 +
        640.0*z_158*z_186) - sin_q6*(z_153*z_169 + 640.0*z_156*z_186 - z_165*z_174 - 640.0*z_158*z_185)));
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{
    (void)t, (void)c, (void)fault;

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
    (void)t, (void)c, (void)u, (void)memory, (void)flags, (void)fault;

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
    real mu1[N1*N1], Omega1[N1*N1];
    em_congruence(N1, C1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 12, *const s1_dot = dy + 48;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

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
    const real c_18 = c[20];
    const real z_50 = (cos_q4*z_44 + 0.5*c_18*z_45) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_14) +
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
    const real c_8 = c[10];
    const real z_69 = 33885.0*z_61 + z_63*c_8 + 77724.0*z_62;
    const real z_70 = sin_q5*sin_q5;
    const real z_71 = sin_q4*z_70 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_61);
    const real z_72 = 8.0*cos_q5*z_69 + z_63*c_4 + 170000.0*z_71 - 119895747.0*z_60;
    const real z_73 = (cos_q4*z_68 + 0.5*cos_q5*z_58*c_18) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_66 - (20.0/203.0)*sin_q4*z_72));
    M1[1][1] = (1.0/10000000000.0)*(4318.0*cos_q3*z_67 + 30547567588.0 + 2.0*z_73 - 4318.0*sin_q3*z_65);
    M1[2][0] = ((-1.0/20000000000.0))*(-2.0*z_50);
    M1[2][1] = (1.0/10000000000.0)*(1098579138.0 + 2.0*z_73);
    const real z_74 = 2159.0*sin_q4 + 1000.0*z_61;
    const real z_75 = 77724.0*sin_q4 + 33885.0*z_61 + z_74*c_8;
    const real z_76 = 8.0*cos_q5*z_75 + z_74*c_4 + 170000.0*z_71;
    const real z_77 = cos_q4*cos_q5;
    const real z_78 = sin_q5 - (4318.0/203.0)*z_77;
    const real z_79 = 203.0*z_78 - 2000.0*cos_q4;
    const real z_80 = c_0*z_79 + 8729.0*z_78 - 2880.0*cos_q4;
    const real z_81 = sin_q5*cos_q4;
    const real z_82 = 203.0*cos_q5 + 4318.0*z_81;
    const real z_83 = 2159.0*cos_q5*z_80 + z_79*c_5 + 292320.0*z_78 - 845415424.0*cos_q4 - z_82*z_43;
    const real c_19 = c[21];
    M1[2][2] = (1.0/500000000000.0)*(1000.0*sin_q4*z_76 + 10150.0*sin_q5*z_80 + 343365622869.0 + cos_q5*z_82*c_19
        - 100.0*cos_q4*z_83);
    M1[3][0] = ((-1.0/62500000.0))*(81250.0*z_14 - z_39);
    const real z_84 = sin_q5*z_61;
    M1[3][1] = ((-1.0/62500000.0))*(sin_q5*z_69 - 21250.0*z_84);
    M1[3][2] = (1.0/62500000.0)*(21250.0*z_84 - sin_q5*z_75);
    const real z_85 = cos_q5*cos_q5;
    const real c_20 = c[22];
    M1[3][3] = (1.0/6250000000000.0)*(2125000000.0*z_85 + 1200566413273.0 + c_20*z_70);
    M1[4][0] = (1.0/62500000.0)*(40135.0*z_8 + z_20*c_3 + 27009.0*z_19);
    const real c_10 = c[12];
    M1[4][1] = (1.0/62500000.0)*(40135.0*cos_q4 + z_55*c_10 - 18.0*z_54);
    M1[4][2] = ((-1.0/62500000.0))*(z_79*c_10 + 3654.0*z_78 - 40135.0*cos_q4);
    M1[4][3] = em_real(0.0);
    const real c_21 = c[23];
    M1[4][4] = c_21;
    M1[5][0] = ((-1.0/25000.0))*z_38;
    M1[5][1] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[5][2] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[5][3] = (1.0/25000.0)*cos_q5;
    M1[5][4] = em_real(0.0);
    M1[5][5] = em_real((48526126417.0/250000000000.0));
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
    const real c_8 = c[10];
    const real z_143 = 33885.0*z_139 + z_141*c_8 + 77724.0*z_140;
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
    const real z_147 = 77724.0*z_95 + 33885.0*z_139 + z_146*c_8;
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
    const real c_9 = c[11];
    Mdot1[3][3] = -c_9*(cos_q5*z_105);
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/62500000.0))*(40135.0*z_96 + z_109*c_3 + 27009.0*z_108);
    const real c_10 = c[12];
    Mdot1[1][4] = Mdot1[4][1] = ((-1.0/62500000.0))*(40135.0*z_103 + z_134*c_10 + 18.0*z_133);
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/62500000.0))*(40135.0*z_103 + z_149*c_10 + 3654.0*z_148);
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
    const real c_11 = c[13];
    const real c_12 = c[14];
    const real z_214 = c_11 + cos_q5*c_12;
    const real c_13 = c[15];
    const real c_14 = c[16];
    const real z_215 = c_13 - z_81*c_14;
    const real c_15 = c[17];
    const real c_16 = c[18];
    f1[1] = (1.0/40000000000.0)*(40000000000.0*tau2 + (sin_q2*(4.0*q1_dot*(4145280.0*z_159 +
        19792500.0*(12.0*q2_dot - 455.0*z_156) - 23664000.0*z_160 - 2159.0*z_198) + z_212*z_213 +
        400000.0*cos_q3*z_214 + 200000.0*sin_q3*z_215 + c_15 - 20960000000.0*cos_q2*z_155 - z_208*z_209) -
        cos_q2*(174000.0*q1_dot*(48.0*z_160 + 455.0*(136.0*q2_dot - 455.0*z_157)) + 200000.0*cos_q3*z_215 + c_16 -
        5200000000.0*sin_q2*z_155 - z_208*z_213 - z_212*z_209 - 400000.0*sin_q3*z_214)));
    const real tau3 = u[2];
    f1[2] = (1.0/40000000000.0)*(40000000000.0*tau3 + (sin_q3*(8636.0*q2_dot*(480.0*z_199 - z_200) + z_156*z_212 +
        400000.0*cos_q2*z_214 + 200000.0*sin_q2*z_215 - z_157*z_208) - cos_q3*(8636.0*q2_dot*(480.0*z_210 + z_211)
        + 200000.0*cos_q2*z_215 - z_156*z_208 - z_157*z_212 - 400000.0*sin_q2*z_214)));
    const real tau4 = u[3];
    const real c_17 = c[19];
    f1[3] = (1.0/40000000000.0)*(40000000000.0*tau4 + (sin_q4*(2.0*z_166*z_192 + 4.0*z_158*z_206 - z_165*z_197 -
        4.0*z_161*z_207 - z_11*c_17) + cos_q4*(z_165*z_192 + 2.0*z_166*z_197 + 4.0*z_161*z_206 +
        4.0*z_158*z_207)));
    const real tau5 = u[4];
    const real z_216 = c_1*z_194;
    f1[4] = (1.0/40000000000.0)*(40000000000.0*tau5 - (sin_q5*(z_180*z_216 + z_178*z_195 + 640.0*z_162*z_203 +
        800000.0*z_171*z_205 + z_14*c_17) - cos_q5*(z_178*z_216 + 800000.0*z_162*z_205 + z_27*c_17 - z_180*z_195 -
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
    (void)t, (void)c, (void)u, (void)flags, (void)fault;
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

extern em_lanes puma_lanes;
em_lanes puma_lanes = {EM_LANES, rhs_on_lanes, velocity_on_lanes, NULL};

#else

/* What no step calls. As it stands this file holds all; compilers may work side by side on this part alone, with
 * -DEM_ASIDE_ALONE, and on the others, with -DEM_ASIDE_ELSEWHERE. */
#ifdef EM_ASIDE_ELSEWHERE

extern void mass_matrix_gradient(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                                   double *restrict dM);
extern void motion_bias(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                          const double *restrict c, const double *restrict u, double *restrict bias,
                          EM_UNUSED double *restrict gamma);
extern void energy(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                     const double *restrict c, double *restrict e);
extern void observe(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                      EM_UNUSED const double *restrict v, EM_UNUSED const double *restrict a,
                      EM_UNUSED const double *restrict lambda, EM_UNUSED const double *restrict c,
                      EM_UNUSED const double *restrict u, EM_UNUSED double *restrict out);
extern void draw(EM_UNUSED double t, const double *restrict x, EM_UNUSED const double *restrict c,
                   double *restrict p);

#else

/* dM (n, n, n): dM[k, i, j] = dM_ij / dx_k */
EM_RARE /* no step calls it */
EM_ASIDE void mass_matrix_gradient(EM_UNUSED double t, const double *restrict x, const double *restrict c,
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
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double sin_q5 = em_sin(q5);
    const double z_11 = z_6*sin_q5;
    const double z_12 = sin_q2*sin_q3;
    const double z_13 = cos_q2*cos_q3;
    const double z_14 = z_12 - z_13;
    const double z_15 = 4318.0*cos_q2 - 203.0*z_14;
    const double cos_q4 = em_cos(q4);
    const double z_17 = z_14*cos_q4;
    const double z_18 = sin_q4*z_15 - 1500.5*z_17;
    const double z_19 = z_8 - (1.0/4318.0)*z_18;
    const double z_20 = 8636.0*z_19;
    const double z_21 = z_11 + (1.0/3001.0)*z_20*cos_q5;
    const double z_22 = 4000.0*z_8 + 3001.0*z_21;
    const double c_0 = c[2];
    const double z_23 = 5760.0*z_8 + z_22*c_0 + 129043.0*z_21;
    const double z_24 = cos_q5*z_23;
    const double z_25 = z_6*cos_q5;
    const double z_26 = sin_q5*z_20 - 3001.0*z_25;
    const double c_1 = c[3];
    const double z_27 = sin_q5*c_1;
    const double z_28 = 739312.0*z_8 + z_24 + z_26*z_27 - 164.0*z_18;
    const double z_29 = sin_q4*z_28;
    const double z_30 = z_6*cos_q4;
    const double z_31 = sin_q5*z_14;
    const double z_32 = cos_q4*cos_q5;
    const double z_33 = z_31 - z_6*z_32;
    const double z_34 = sin_q4*z_14;
    const double z_35 = z_34 + (2.0/3001.0)*z_15*cos_q4;
    const double z_36 = z_30 - (3001.0/8636.0)*z_35;
    const double z_37 = 8636.0*z_36 - 4000.0*z_33;
    const double c_2 = c[4];
    const double z_38 = 222132.0*z_30 + z_37*c_2 - 1152.0*z_33 - 75025.0*z_35;
    const double z_39 = cos_q4*z_38;
    const double z_40 = z_29 + 5.0*z_39;
    const double z_41 = 4318.0*sin_q2 + 203.0*z_6;
    const double z_42 = z_30 + (2.0/3001.0)*sin_q4*z_41;
    const double z_43 = 3001.0*z_42 - 8636.0*z_34;
    const double z_44 = z_31 - (1.0/3001.0)*cos_q5*z_43;
    const double z_45 = 4000.0*z_34 + 3001.0*z_44;
    const double z_46 = 5760.0*z_34 + c_0*z_45 + 129043.0*z_44;
    const double z_47 = cos_q5*z_46;
    const double z_48 = z_14*cos_q5;
    const double z_49 = 3001.0*z_48 + sin_q5*z_43;
    const double z_50 = z_49*z_27 + 246082.0*z_42 - 739312.0*z_34 - z_47;
    const double z_51 = cos_q4*z_41;
    const double z_52 = z_11 + z_14*z_32;
    const double z_53 = z_8 + (8636.0/3001.0)*z_17;
    const double z_54 = z_51 - 1500.5*z_53;
    const double z_55 = 4000.0*z_52 - 2.0*z_54;
    const double z_56 = z_52 + (75025.0/1152.0)*(z_8 + (222132.0/75025.0)*z_17);
    const double z_57 = z_55*c_2 + 1152.0*z_56 - 50.0*z_51;
    const double z_58 = sin_q4*z_50 - 5.0*cos_q4*z_57;
    const double c_3 = c[5];
    const double z_59 = z_37*c_3 + 77724.0*z_36 - 33885.0*z_33;
    const double z_60 = sin_q5*z_59;
    const double z_61 = sin_q5*cos_q4;
    const double z_62 = z_48 + z_6*z_61;
    const double z_63 = cos_q5*z_62;
    const double z_64 = sin_q4*z_38;
    const double z_65 = cos_q4*z_28;
    const double z_66 = z_64 - (1.0/5.0)*z_65;
    const double z_67 = 5725482720.0*z_14 + 13600000.0*z_63 + 406.0*z_40 - 640.0*z_60 - 15005.0*z_66;
    const double z_68 = z_3*z_67;
    const double z_69 = z_55*c_3 + 33885.0*z_52 - 18.0*z_54;
    const double z_70 = sin_q5*z_69;
    const double z_71 = z_25 - z_14*z_61;
    const double z_72 = cos_q5*z_71;
    const double z_73 = z_6 + (85000.0/35784267.0)*z_72;
    const double z_74 = sin_q4*z_57 + (1.0/5.0)*cos_q4*z_50;
    const double z_75 = 640.0*z_70 + 5725482720.0*z_73 + 406.0*z_58 + 15005.0*z_74;
    const double z_76 = sin_q5*z_23;
    const double z_77 = cos_q5*z_59;
    const double z_78 = sin_q5*z_62;
    const double c_4 = c[6];
    const double z_79 = 497229916.0*z_30 + 32.0*z_77 + 680000.0*z_78 + z_37*c_4 - 2487168.0*z_33 -
        166654533.0*z_35;
    const double z_80 = cos_q4*z_79;
    const double c_5 = c[7];
    const double c_6 = c[8];
    const double z_81 = sin_q5*c_6;
    const double z_82 = 1690830848.0*z_8 + 2159.0*z_24 + z_22*c_5 + z_26*z_81 + 4321440.0*z_21 - 369656.0*z_18;
    const double z_83 = sin_q4*z_82;
    const double c_7 = c[9];
    const double z_84 = cos_q5*c_7;
    const double z_85 = 5803392000.0*cos_q2 + z_26*z_84 - 9492774802.0*z_6 - 3001.0*z_76 - 20.0*z_80 - 4.0*z_83;
    const double z_86 = z_12*z_85;
    const double z_87 = sin_q5*z_46;
    const double z_88 = (z_8 + (497229916.0/166654533.0)*z_17) - (680000.0/166654533.0)*(sin_q5*z_71 -
        (2286.0/625.0)*z_52);
    const double z_89 = 32.0*cos_q5*z_69 + z_55*c_4 + 166654533.0*z_88 - 111066.0*z_51;
    const double z_90 = z_49*z_81 + 554668828.0*z_42 - 1690830848.0*z_34 - 2159.0*z_47 - z_45*c_5 -
        4321440.0*z_44;
    const double z_91 = 5803392000.0*sin_q2 + 4.0*sin_q4*z_90 - 9492774802.0*z_14 - 3001.0*z_87 - 20.0*cos_q4*z_89
        - z_49*z_84;
    const double z_92 = z_13*z_85;
    const double z_93 = z_5*z_67;
    dM[36] = ((-1.0/40000000000.0))*(31520000000.0*sin_q2*cos_q2 + (z_92 - z_5*z_91) -
        4.0*(sin_q2*(70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_40 - 18759823020.0*cos_q2) -
        cos_q2*(18759823020.0*sin_q2 + 70992000.0*cos_q2 + 2159.0*z_58 - 1450848000.0*z_14)) -
        174000.0*(cos_q2*(207169.0*sin_q2 - 1632.0*cos_q2) + sin_q2*(1632.0*sin_q2 + 207169.0*cos_q2)) - (z_68 +
        z_12*z_75) - (z_86 + z_3*z_91) - (z_93 - z_13*z_75));
    const double z_94 = cos_q5*c_1;
    const double c_18 = c[20];
    const double z_95 = cos_q5*c_18;
    const double z_96 = z_6 + (3568189.0/78792000.0)*z_14;
    const double z_97 = (cos_q4*z_90 + 0.5*z_49*z_95) + 551544000.0*(z_96 + (29.0/157584000.0)*(z_87 +
        (10.0/203.0)*sin_q4*z_89));
    dM[42] = dM[37] = (1.0/20000000000.0)*(475020000.0*sin_q2 + 4318.0*cos_q3*(1821922.0*z_14 + z_87 + z_49*z_94)
        + 2.0*z_97 - 5383560000.0*cos_q2 - 4318.0*sin_q3*(1575840.0*z_6 + 5.0*z_74));
    dM[48] = dM[38] = (1.0/20000000000.0)*(2.0*z_97);
    const double z_98 = z_6 + (17.0/65.0)*z_72;
    dM[54] = dM[39] = ((-1.0/62500000.0))*(z_70 + 81250.0*z_98);
    dM[60] = dM[40] = ((-1.0/62500000.0))*(40135.0*z_34 + z_45*c_3 + 27009.0*z_44);
    dM[66] = dM[41] = ((-1.0/25000.0))*z_71;
    const double z_99 = z_8 + (3001.0/406.0)*z_30;
    const double z_100 = 406.0*z_99 - 8636.0*z_34;
    const double z_101 = z_31 - (1.0/3001.0)*cos_q5*z_100;
    const double z_102 = 4000.0*z_34 + 3001.0*z_101;
    const double z_103 = 5760.0*z_34 + c_0*z_102 + 129043.0*z_101;
    const double z_104 = cos_q5*z_103;
    const double z_105 = 3001.0*z_48 + sin_q5*z_100;
    const double z_106 = z_105*z_27 + 33292.0*z_99 - 739312.0*z_34 - z_104;
    const double z_107 = z_30 - (3001.0/406.0)*z_53;
    const double z_108 = 4000.0*z_52 - 406.0*z_107;
    const double z_109 = z_108*c_2 + 1152.0*z_56 - 10150.0*z_30;
    const double z_110 = sin_q4*z_106 - 5.0*cos_q4*z_109;
    const double z_111 = z_108*c_3 + 33885.0*z_52 - 3654.0*z_107;
    const double z_112 = sin_q5*z_111;
    const double z_113 = sin_q4*z_109 + (1.0/5.0)*cos_q4*z_106;
    const double z_114 = 640.0*z_112 + 5725482720.0*z_73 + 406.0*z_110 + 15005.0*z_113;
    const double z_115 = sin_q5*z_103;
    const double z_116 = 32.0*cos_q5*z_111 + z_108*c_4 + 166654533.0*z_88 - 22546398.0*z_30;
    const double z_117 = z_105*z_81 + 75040168.0*z_99 - 1690830848.0*z_34 - 2159.0*z_104 - z_102*c_5 -
        4321440.0*z_101;
    const double z_118 = 9492774802.0*z_14 + 3001.0*z_115 + 20.0*cos_q4*z_116 + z_105*z_84 - 4.0*sin_q4*z_117;
    dM[72] = (1.0/40000000000.0)*(8636.0*cos_q2*(672000.0*z_14 - z_110) + (z_93 + z_12*z_114) + (z_86 - z_5*z_118)
        + (z_68 - z_13*z_114) - (z_92 + z_3*z_118));
    const double z_119 = (cos_q4*z_117 + 0.5*z_105*z_95) + 551544000.0*(z_96 + (29.0/157584000.0)*(z_115 +
        (10.0/203.0)*sin_q4*z_116));
    dM[78] = dM[73] = (1.0/20000000000.0)*(4318.0*(sin_q3*(1821922.0*z_6 + z_76 - z_26*z_94) +
        cos_q3*(1821922.0*z_14 + z_115 + z_105*z_94)) + 2.0*z_119 - 4318.0*(cos_q3*(1575840.0*z_14 - 5.0*z_66) +
        sin_q3*(1575840.0*z_6 + 5.0*z_113)));
    const double z_120 = sin_q3*cos_q4;
    const double z_121 = 4318.0*cos_q3 + 203.0;
    const double z_122 = cos_q4 - z_120;
    const double z_123 = sin_q5*z_121 - 4318.0*cos_q5*z_122;
    const double z_124 = 2000.0*cos_q4 - z_123;
    const double z_125 = 2880.0*cos_q4 + c_0*z_124 - 43.0*z_123;
    const double z_126 = cos_q5*z_125;
    const double z_127 = cos_q5*z_121 + 4318.0*sin_q5*z_122;
    const double z_128 = 369656.0*cos_q4 + z_126 + z_127*z_27 - 354076.0*z_120;
    const double z_129 = sin_q3*sin_q4;
    const double z_130 = sin_q4*cos_q5;
    const double z_131 = sin_q4 - z_129;
    const double z_132 = 1000.0*z_130 + 2159.0*z_131;
    const double z_133 = 55533.0*sin_q4 + 288.0*z_130 + z_132*c_2 - 53975.0*z_129;
    const double z_134 = cos_q3*cos_q4;
    const double z_135 = sin_q3*sin_q5 - cos_q3*z_32;
    const double z_136 = 43.0*z_135 + c_0*z_135;
    const double z_137 = cos_q5*z_136;
    const double z_138 = sin_q3*cos_q5 + cos_q3*z_61;
    const double c_22 = c[24];
    const double z_139 = sin_q4*sin_q4;
    const double z_140 = sin_q5*z_125;
    const double z_141 = sin_q5*z_136;
    const double c_23 = c[25];
    const double z_142 = cos_q3*sin_q4;
    const double c_24 = c[26];
    const double z_143 = (cos_q4*(1440.0*z_135 + 2159.0*z_137 + z_135*c_5 - 184828.0*z_134 - z_138*z_81) -
        0.5*z_138*z_95) - 8323.0*((sin_q3 + (24000.0/1189.0)*cos_q3) + (1.0/82.0)*(z_141 +
        (10.0/203.0)*sin_q4*(c_23*z_142 + c_24*(cos_q5*z_142))));
    dM[79] = ((-2159.0/5000000000.0))*((cos_q3*(336000.0 + cos_q4*z_128 + 10.0*sin_q4*z_133 - 2072640.0*sin_q3) -
        4318.0*sin_q3*(480.0*cos_q3 + cos_q4*(82.0*z_134 + z_138*z_27 - z_137) + c_22*(cos_q3*z_139))) +
        (sin_q3*(2426716.0*cos_q3 + 16646.0 + z_127*z_94 - z_140) + 4318.0*cos_q3*(562.0*sin_q3 + z_141 +
        z_138*z_94)) - 2.0*z_143);
    dM[84] = dM[74] = (1.0/20000000000.0)*(2.0*z_119);
    dM[85] = dM[80] = ((-2159.0/5000000000.0))*(-2.0*z_143);
    dM[90] = dM[75] = ((-1.0/62500000.0))*(z_112 + 81250.0*z_98);
    const double c_25 = c[27];
    dM[91] = dM[81] = sin_q5*c_25*z_142;
    dM[96] = dM[76] = ((-1.0/62500000.0))*(40135.0*z_34 + z_102*c_3 + 27009.0*z_101);
    dM[97] = dM[82] = (2159.0/15625000.0)*(9.0*z_135 + z_135*c_3);
    dM[102] = dM[77] = ((-1.0/25000.0))*z_71;
    const double z_144 = 8636.0*z_36;
    const double z_145 = cos_q5*z_144;
    const double z_146 = 4000.0*z_30 + z_145;
    const double z_147 = 5760.0*z_30 + 43.0*z_145 + c_0*z_146;
    const double z_148 = cos_q5*z_147;
    const double z_149 = sin_q5*sin_q5;
    const double z_150 = z_144*z_149;
    const double z_151 = 739312.0*z_30 + z_148 + c_1*z_150 - 246082.0*z_35;
    const double z_152 = z_8*cos_q5;
    const double z_153 = 4000.0*z_152 + 8636.0*z_19;
    const double z_154 = 222132.0*z_8 + 1152.0*z_152 + z_153*c_2 - 50.0*z_18;
    const double z_155 = (z_65 + sin_q4*z_151) - 5.0*(z_64 + cos_q4*z_154);
    const double z_156 = 33885.0*z_152 + z_153*c_3 + 77724.0*z_19;
    const double z_157 = sin_q5*cos_q5;
    const double z_158 = sin_q4*z_157;
    const double z_159 = sin_q5*z_156 - 21250.0*z_6*z_158;
    const double z_160 = (z_39 - sin_q4*z_154) + (1.0/5.0)*(z_29 - cos_q4*z_151);
    const double z_161 = 406.0*z_155 + 640.0*z_159 - 15005.0*z_160;
    const double z_162 = sin_q5*z_147;
    const double z_163 = sin_q4*z_149;
    const double z_164 = 497229916.0*z_8 + 2487168.0*z_152 + 32.0*cos_q5*z_156 + 680000.0*z_6*z_163 + z_153*c_4 -
        111066.0*z_18;
    const double z_165 = 1690830848.0*z_30 + 1440.0*z_145 + 2159.0*z_148 + z_146*c_5 + c_6*z_150 -
        554668828.0*z_35;
    const double z_166 = z_144*z_157;
    const double z_167 = 3001.0*z_162 + 4.0*(cos_q4*z_82 + sin_q4*z_165) - 20.0*(sin_q4*z_79 + cos_q4*z_164) -
        c_7*z_166;
    dM[108] = ((-1.0/40000000000.0))*(8636.0*cos_q2*z_155 + z_13*z_161 - z_12*z_161 - z_3*z_167 - z_5*z_167);
    const double z_168 = (z_162 + (10.0/203.0)*(z_80 - sin_q4*z_164)) + (2.0/203.0)*((z_83 - cos_q4*z_165) -
        0.5*c_18*z_166);
    dM[114] = dM[109] = ((-1.0/20000000000.0))*(4318.0*cos_q3*(z_162 - c_1*z_166) + 203.0*z_168 -
        4318.0*sin_q3*(5.0*z_160));
    const double z_169 = cos_q5*z_131;
    const double z_170 = 1000.0*sin_q4 + 2159.0*z_169;
    const double z_171 = 1440.0*sin_q4 + 92837.0*z_169 + c_0*z_170;
    const double z_172 = cos_q5*z_171;
    const double z_173 = z_131*z_149;
    const double z_174 = 2159.0*z_122 + 1000.0*z_32;
    const double z_175 = sin_q5*z_171;
    const double z_176 = z_131*z_157;
    const double c_8 = c[10];
    const double z_177 = 33885.0*z_130 + 77724.0*z_131 + z_132*c_8;
    const double z_178 = cos_q5*z_177;
    const double z_179 = z_163 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_130);
    const double z_180 = 77724.0*z_122 + 33885.0*z_32 + z_174*c_8;
    const double z_181 = cos_q4*z_149 + (124307479.0/170000.0)*(cos_q4 + (621792.0/124307479.0)*z_32);
    const double c_26 = c[28];
    const double c_27 = c[29];
    const double z_182 = (z_175 + (10.0/203.0)*(cos_q4*(8.0*z_178 + z_132*c_4 + 170000.0*z_179 -
        119895747.0*z_129) + sin_q4*(8.0*cos_q5*z_180 + z_174*c_4 + 170000.0*z_181 - 119895747.0*z_120))) -
        (1.0/203.0)*((sin_q4*(845415424.0*cos_q4 + 2159.0*z_126 + z_124*c_5 + z_127*z_81 - 798087304.0*z_120 -
        1440.0*z_123) + 2.0*cos_q4*(422707712.0*sin_q4 + 3108960.0*z_169 + 2159.0*z_172 + z_170*c_5 + c_26*z_173 -
        399043652.0*z_129)) + c_27*z_176);
    dM[115] = (1.0/5000000000.0)*(2159.0*sin_q3*((sin_q4*z_128 + 2.0*cos_q4*(184828.0*sin_q4 + z_172 + c_6*z_173 -
        177038.0*z_129)) - 10.0*(cos_q4*z_133 + sin_q4*(55533.0*cos_q4 + 288.0*z_32 + z_174*c_2 - 53975.0*z_120)))
        + 4318.0*cos_q3*(z_175 - c_6*z_176) + 203.0*z_182);
    dM[120] = dM[110] = ((-1.0/20000000000.0))*(203.0*z_168);
    dM[121] = dM[116] = (1.0/5000000000.0)*(203.0*z_182);
    const double z_183 = 2159.0*sin_q4 + 1000.0*z_130;
    const double z_184 = 77724.0*sin_q4 + 33885.0*z_130 + z_183*c_8;
    const double z_185 = cos_q5*z_184;
    const double z_186 = 2159.0*cos_q4 + 1000.0*z_32;
    const double z_187 = 77724.0*cos_q4 + 33885.0*z_32 + z_186*c_8;
    const double z_188 = sin_q5 - (4318.0/203.0)*z_32;
    const double z_189 = 203.0*z_188 - 2000.0*cos_q4;
    const double z_190 = c_0*z_189 + 8729.0*z_188 - 2880.0*cos_q4;
    const double z_191 = cos_q5*z_190;
    const double z_192 = cos_q5 + (4318.0/203.0)*z_61;
    const double z_193 = 203.0*z_192;
    const double z_194 = 1000.0*sin_q4 + 2159.0*z_130;
    const double z_195 = 1440.0*sin_q4 + 92837.0*z_130 + c_0*z_194;
    dM[122] = (1.0/5000000000.0)*(10.0*(cos_q4*(8.0*z_185 + z_183*c_4 + 170000.0*z_179) + sin_q4*(8.0*cos_q5*z_187
        + z_186*c_4 + 170000.0*z_181)) + (sin_q4*(2159.0*z_191 + z_189*c_5 + 292320.0*z_188 - 845415424.0*cos_q4 -
        z_193*z_81) - 2.0*cos_q4*(422707712.0*sin_q4 + 3108960.0*z_130 + 2159.0*cos_q5*z_195 + z_194*c_5 +
        z_163*c_26)) + 203.0*sin_q5*z_195 - z_158*c_27);
    dM[126] = dM[111] = ((-1.0/62500000.0))*z_159;
    const double z_196 = cos_q4*z_157;
    dM[127] = dM[117] = ((-1.0/62500000.0))*(sin_q5*z_180 - 21250.0*z_196);
    dM[128] = dM[123] = (1.0/62500000.0)*(21250.0*z_196 - sin_q5*z_187);
    dM[132] = dM[112] = (1.0/62500000.0)*(40135.0*z_30 + 9.0*z_145 + z_146*c_3);
    dM[133] = dM[118] = ((-1.0/62500000.0))*(40135.0*sin_q4 + 77724.0*z_169 + z_170*c_8);
    dM[134] = dM[124] = ((-1.0/62500000.0))*(40135.0*sin_q4 + 77724.0*z_130 + z_194*c_8);
    dM[138] = dM[113] = (1.0/25000.0)*(sin_q5*z_8);
    dM[139] = dM[119] = (1.0/25000.0)*z_61;
    dM[140] = dM[125] = (1.0/25000.0)*z_61;
    const double z_197 = 43.0*z_26 + c_0*z_26;
    const double z_198 = 3001.0*z_21;
    const double z_199 = (z_76 + cos_q5*z_197) - c_1*(cos_q5*z_26 + sin_q5*z_198);
    const double z_200 = 9.0*z_62 + z_62*c_3;
    const double z_201 = sin_q4*z_199 + 640.0*cos_q4*z_200;
    const double c_28 = c[30];
    const double z_202 = 6777.0*z_62 + z_62*c_28;
    const double z_203 = (z_77 - 5.0*sin_q5*z_202) + 21250.0*(z_78 + cos_q5*z_33);
    const double z_204 = sin_q4*z_200 - (1.0/640.0)*cos_q4*z_199;
    const double z_205 = 406.0*z_201 + 640.0*z_203 - 1920640.0*z_204;
    const double c_29 = c[31];
    const double z_206 = 77724.0*z_62 + (z_60 + 5.0*cos_q5*z_202) + z_62*c_29 - 21250.0*(z_63 - sin_q5*z_33);
    const double z_207 = 1440.0*z_26 + 2159.0*z_199 + z_26*c_5;
    const double z_208 = (z_24 - sin_q5*z_197) + c_1*(sin_q5*z_26 - cos_q5*z_198);
    const double z_209 = 3001.0*z_208 - 640.0*cos_q4*z_206 - 4.0*sin_q4*z_207;
    dM[144] = (1.0/40000000000.0)*(8636.0*cos_q2*z_201 + z_3*z_209 + z_5*z_209 + z_13*z_205 - z_12*z_205);
    const double z_210 = cos_q4*z_207 + 101.5*(z_208 - (320.0/203.0)*sin_q4*z_206);
    dM[150] = dM[145] = ((-1.0/20000000000.0))*(4318.0*cos_q3*z_208 + 4318.0*sin_q3*(640.0*z_204) + 2.0*z_210);
    const double z_211 = 43.0*z_127 + c_0*z_127;
    const double z_212 = (z_140 + cos_q5*z_211) - c_1*(cos_q5*z_127 - sin_q5*z_123);
    const double c_30 = c[32];
    const double z_213 = (z_126 - sin_q5*z_211) + c_1*(sin_q5*z_127 + cos_q5*z_123);
    const double c_31 = c[33];
    const double z_214 = z_158*c_31;
    const double c_32 = c[34];
    const double z_215 = z_158 - (1.0/42500.0)*sin_q5*sin_q4*c_32;
    const double z_216 = z_213 - (160.0/203.0)*(sin_q4*(42500.0*z_215 - (sin_q5*z_177 + z_214)) -
        (1.0/80.0)*cos_q4*(1440.0*z_127 + 2159.0*z_212 + z_127*c_5));
    dM[151] = (1.0/10000000000.0)*(4318.0*sin_q3*(cos_q4*z_212 + sin_q5*c_30*z_139) - 4318.0*cos_q3*z_213 -
        203.0*z_216);
    dM[156] = dM[146] = ((-1.0/20000000000.0))*(2.0*z_210);
    dM[157] = dM[152] = ((-1.0/10000000000.0))*(203.0*z_216);
    const double z_217 = c_0*z_193 + 8729.0*z_192;
    const double z_218 = 203.0*z_188;
    dM[158] = (1.0/10000000000.0)*(160.0*sin_q4*(42500.0*z_215 - (sin_q5*z_184 + z_214)) + 203.0*(z_191 +
        sin_q5*z_217) - 2.0*cos_q4*(z_193*c_5 + 292320.0*z_192 - 2159.0*(sin_q5*z_190 - cos_q5*z_217) -
        2159.0*c_1*(cos_q5*z_193 - sin_q5*z_218)) - 203.0*c_1*(sin_q5*z_193 + cos_q5*z_218));
    dM[162] = dM[147] = (1.0/62500000.0)*z_203;
    const double z_219 = z_163*c_31;
    const double z_220 = z_163 - sin_q4*(cos_q5*cos_q5);
    dM[163] = dM[153] = ((-1.0/62500000.0))*((z_178 - z_219) + 21250.0*z_220);
    dM[164] = dM[159] = ((-1.0/62500000.0))*(21250.0*z_220 + (z_185 - z_219));
    const double c_9 = c[11];
    dM[165] = -c_9*z_157;
    dM[168] = dM[148] = ((-1.0/62500000.0))*(9.0*z_26 + z_26*c_3);
    dM[169] = dM[154] = ((-1.0/31250000.0))*(9.0*z_127 + z_127*c_3);
    dM[170] = dM[160] = ((-1.0/31250000.0))*(z_193*c_3 + 1827.0*z_192);
    dM[174] = dM[149] = (1.0/25000.0)*z_33;
    dM[175] = dM[155] = (1.0/25000.0)*z_130;
    dM[176] = dM[161] = (1.0/25000.0)*z_130;
    dM[177] = dM[167] = ((-1.0/25000.0))*sin_q5;
}

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ASIDE void motion_bias(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                          const double *restrict c, const double *restrict u, double *restrict bias,
                          EM_UNUSED double *restrict gamma)
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
    const double c_11 = c[13];
    const double c_12 = c[14];
    const double z_139 = c_11 + cos_q5*c_12;
    const double c_13 = c[15];
    const double c_14 = c[16];
    const double z_140 = c_13 - c_14*(sin_q5*cos_q4);
    const double c_15 = c[17];
    const double c_16 = c[18];
    const double z_141 = 480.0*z_125 + z_126;
    const double z_142 = 480.0*z_101 - z_102;
    const double z_143 = ((z_108*z_63 + sin_q4*z_120) - (z_109*z_62 + cos_q4*z_122)) + 168000.0*(z_131 +
        (29.0/48000.0)*z_115);
    bias[1] = (1.0/40000000000.0)*((40000000000.0*tau2 + (sin_q2*(4.0*q1_dot*z_57 + z_127*z_138 +
        400000.0*cos_q3*z_139 + 200000.0*sin_q3*z_140 + c_15 - 20960000000.0*cos_q2*z_136 - z_110*z_137) -
        cos_q2*(174000.0*q1_dot*z_6 + 200000.0*cos_q3*z_140 + c_16 - 5200000000.0*sin_q2*z_136 - z_110*z_138 -
        z_127*z_137 - 400000.0*sin_q3*z_139))) - 2.0*(475020000.0*z_8 + 4318.0*(z_142*z_59 + cos_q3*(480.0*z_114 +
        z_115)) + 2.0*z_143 - 5383560000.0*z_7 - 4318.0*(z_141*z_58 + sin_q3*(480.0*z_131 + z_132))));
    const double tau3 = u[2];
    bias[2] = (1.0/40000000000.0)*((40000000000.0*tau3 + (sin_q3*(8636.0*q2_dot*z_142 + z_4*z_127 +
        400000.0*cos_q2*z_139 + 200000.0*sin_q2*z_140 - z_1*z_110) - cos_q3*(8636.0*q2_dot*z_141 +
        200000.0*cos_q2*z_140 - z_4*z_110 - z_1*z_127 - 400000.0*sin_q2*z_139))) - 2.0*(2.0*z_143));
    const double tau4 = u[3];
    const double c_17 = c[19];
    const double z_144 = z_124 + z_113;
    bias[3] = (1.0/40000000000.0)*((40000000000.0*tau4 + (sin_q4*(2.0*z_21*z_49 + 4.0*z_12*z_108 - z_20*z_55 -
        4.0*z_16*z_109 - c_17*(z_144*sin_q5)) + cos_q4*(z_20*z_49 + 2.0*z_21*z_55 + 4.0*z_16*z_108 +
        4.0*z_12*z_109))) + 640.0*z_133);
    const double tau5 = u[4];
    bias[4] = (1.0/40000000000.0)*((40000000000.0*tau5 - (sin_q5*(z_37*z_52 + z_35*z_53 + 640.0*z_17*z_105 +
        800000.0*z_28*z_107 + (z_135 - z_130)*c_17) - cos_q5*(z_35*z_52 + 800000.0*z_17*z_107 +
        c_17*(z_144*cos_q4) - z_37*z_53 - 640.0*z_28*z_105))) + 640.0*z_121);
    const double tau6 = u[5];
    bias[5] = (1.0/40000000000.0)*((40000000000.0*tau6 + (cos_q6*(z_38*z_42 + z_24*z_47 + 640.0*z_29*z_103 +
        640.0*z_31*z_104) - sin_q6*(z_24*z_42 + 640.0*z_29*z_104 - z_38*z_47 - 640.0*z_31*z_103))) -
        1600000.0*z_119);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ASIDE void energy(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                     const double *restrict c, double *restrict e)
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
    const double c_18 = c[20];
    const double z_45 = (cos_q4*z_40 + 0.5*c_18*z_41) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_13) +
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
    const double c_8 = c[10];
    const double z_63 = 33885.0*z_59 + z_61*c_8 + 77724.0*z_60;
    const double z_64 = sin_q5*sin_q5;
    const double z_65 = sin_q4*z_64 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_59);
    const double z_66 = (cos_q4*(845415424.0*cos_q4 + 2159.0*z_56 + z_54*c_5 + z_57*z_39 - 798087304.0*z_50 -
        1440.0*z_53) + 0.5*cos_q5*z_57*c_18) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_62 - (20.0/203.0)*sin_q4*(8.0*cos_q5*z_63 + z_61*c_4 + 170000.0*z_65 -
        119895747.0*z_58)));
    const double z_67 = 1098579138.0 + 2.0*z_66;
    const double z_68 = sin_q5*sin_q4;
    const double z_69 = cos_q5*z_68;
    const double z_70 = sin_q5*z_63 - 21250.0*z_69;
    const double c_10 = c[12];
    const double z_71 = 40135.0*cos_q4 + z_54*c_10 - 18.0*z_53;
    const double z_72 = q6_dot*z_68;
    const double z_73 = 2159.0*sin_q4 + 1000.0*z_59;
    const double z_74 = 77724.0*sin_q4 + 33885.0*z_59 + z_73*c_8;
    const double z_75 = sin_q5 - (4318.0/203.0)*cos_q4*cos_q5;
    const double z_76 = 203.0*z_75 - 2000.0*cos_q4;
    const double z_77 = c_0*z_76 + 8729.0*z_75 - 2880.0*cos_q4;
    const double z_78 = 203.0*cos_q5 + 4318.0*sin_q5*cos_q4;
    const double c_19 = c[21];
    const double z_79 = 21250.0*z_69 - sin_q5*z_74;
    const double z_80 = z_76*c_10 + 3654.0*z_75 - 40135.0*cos_q4;
    const double c_20 = c[22];
    const double c_33 = c[35];
    e[0] = (1.0/50000000000000.0)*(25.0*q1_dot*(q1_dot*(130000000000.0*sin_q2*sin_q2 +
        524000000000.0*cos_q2*cos_q2 + 4350000.0*sin_q2*(207169.0*sin_q2 - 1632.0*cos_q2) + 25.0*z_11*z_36 +
        1134029968642.0 - 100.0*cos_q2*(70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_31 - 18759823020.0*cos_q2)
        - 25.0*z_3*z_42 - 25.0*z_5*z_42 - 25.0*z_12*z_36) + 16000.0*q5_dot*z_49 - 50.0*q2_dot*z_46 -
        50.0*q3_dot*z_47 - 16000.0*q4_dot*z_48 - 40000000.0*q6_dot*z_34) + 50.0*q3_dot*(20000000.0*z_72 +
        50.0*q2_dot*z_67 + q3_dot*(1000.0*sin_q4*(8.0*cos_q5*z_74 + z_73*c_4 + 170000.0*z_65) +
        10150.0*sin_q5*z_77 + 343365622869.0 + cos_q5*z_78*c_19 - 100.0*cos_q4*(2159.0*cos_q5*z_77 + z_76*c_5 +
        292320.0*z_75 - 845415424.0*cos_q4 - z_78*z_39)) + 8000.0*q4_dot*z_79 - 25.0*q1_dot*z_47 -
        8000.0*q5_dot*z_80) + 25.0*q5_dot*(16000.0*q1_dot*z_49 + 16000.0*q2_dot*z_71 + q5_dot*c_33 -
        16000.0*q3_dot*z_80) + 100.0*q6_dot*(48526126417.0*q6_dot + 10000000.0*q2_dot*z_68 +
        10000000.0*q3_dot*z_68 + 10000000.0*q4_dot*cos_q5 - 10000000.0*q1_dot*z_34) - 1250.0*q2_dot*(q1_dot*z_46 +
        320.0*q4_dot*z_70 - 2.0*q2_dot*(4318.0*cos_q3*(2426716.0*cos_q3 + 16646.0 + z_57*z_43 - z_62) +
        30547567588.0 + 2.0*z_66 - 4318.0*sin_q3*(336000.0 + cos_q4*(369656.0*cos_q4 + z_56 + z_57*z_23 -
        354076.0*z_50) + 10.0*sin_q4*(55533.0*sin_q4 + 288.0*z_59 + z_61*c_2 - 53975.0*z_58) - 2072640.0*sin_q3))
        - 2.0*q3_dot*z_67 - 320.0*q5_dot*z_71 - 800000.0*z_72) - 4.0*q4_dot*(100000.0*q1_dot*z_48 +
        100000.0*q2_dot*z_70 - 100000.0*q3_dot*z_79 - q4_dot*(2125000000.0*cos_q5*cos_q5 + 1200566413273.0 +
        c_20*z_64) - 250000000.0*q6_dot*cos_q5));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c_34 = c[36];
    const double z_81 = sin_q2 + (203.0/4318.0)*z_6;
    const double z_82 = z_13 - z_81;
    const double c_35 = c[37];
    const double c_36 = c[38];
    const double c_37 = c[39];
    const double c_38 = c[40];
    const double c_39 = c[41];
    e[3] = (1.0/1000000.0)*((2159.0*sin_q2 - 350.0*z_13)*c_34 + (-320.0*z_34 - 4318.0*z_82)*c_35 +
        (-4318.0*z_82)*c_36 + (4318.0*z_81 - 4508.0*z_13)*c_37 + (34.0*z_44)*c_38 + (-2000.0*z_34 -
        4318.0*z_82)*c_39);
}

/* out (n_outputs), from x, v, a = xddot, lambda */
EM_ASIDE void observe(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                      EM_UNUSED const double *restrict v, EM_UNUSED const double *restrict a,
                      EM_UNUSED const double *restrict lambda, EM_UNUSED const double *restrict c,
                      EM_UNUSED const double *restrict u, EM_UNUSED double *restrict out)
{
}

/* p: what the drawing is made of, shape by shape */
EM_ASIDE void draw(EM_UNUSED double t, const double *restrict x, EM_UNUSED const double *restrict c,
                   double *restrict p)
{
    p[0] = p[1] = p[3] = p[4] = p[6] = p[7] = p[8] = p[9] = p[10] = p[11] = p[13] = p[14] = p[17] = p[18] = p[19]
        = p[23] = p[24] = p[25] = p[29] = 0.0;
    p[2] = p[5] = -0.5;
    p[12] = p[26] = p[40] = (1.0/20.0);
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
    p[60] = (1.0/30.0);
}

#endif
#ifndef EM_ASIDE_ALONE

/* Where the other is linked it takes the place of this. */
extern em_lanes puma_lanes;
EM_WEAK em_lanes puma_lanes = {0, NULL, NULL, NULL};
#define EM_MODEL_LANES puma_lanes

#include "em_blocks.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0, 0 };
static const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 12, 48, 0, 36 };
static const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double load = parameters[1];
    prepared[2] = 100.0*load;
    const double z_0 = 43.0*1.0 + 100.0*load;
    prepared[3] = z_0;
    prepared[4] = 20.0*load;
    prepared[5] = 625.0*load;
    prepared[6] = 43180.0*load;
    prepared[7] = 100000.0*load;
    prepared[8] = 2159.0*z_0;
    prepared[9] = 3001.0*z_0;
    prepared[10] = 2500.0*load;
    const double z_1 = 6777.0*1.0 + 500000.0*load;
    prepared[11] = (1.0/6250000.0)*(4250.0*1.0 - z_1);
    prepared[12] = 1250.0*load;
    const double g = parameters[0];
    const double z_2 = load*g;
    prepared[13] = 89133.0*g + 43180.0*z_2;
    const double z_3 = 9.0*g + 625.0*z_2;
    prepared[14] = 32.0*z_3;
    prepared[15] = 1015.0*(5.0*g + 4.0*z_2);
    prepared[16] = 64.0*z_3;
    prepared[17] = 4176000000.0*g;
    prepared[18] = 6800000.0*(22327.0*g + 2540.0*z_2);
    prepared[19] = 12800000.0*z_3;
    prepared[20] = 203.0*z_0;
    prepared[21] = 10150.0*z_0;
    prepared[22] = 500000.0*z_1;
    const double z_4 = 171348451657.0*1.0 + 40000000000.0*load;
    prepared[23] = (1.0/1000000000000.0)*z_4;
    prepared[24] = 25.0*(5.0*1.0 + 4.0*load);
    prepared[25] = 55533.0*1.0 + 43180.0*load;
    const double z_5 = 9.0*1.0 + 625.0*load;
    prepared[26] = 32.0*z_5;
    prepared[27] = (2159.0/15625000.0)*z_5;
    prepared[28] = 4661281.0*z_0;
    prepared[29] = 438277.0*z_0;
    prepared[30] = 500000.0*load;
    prepared[31] = 5397500.0*load;
    prepared[32] = 320.0*z_5;
    prepared[33] = 5.0*z_1;
    prepared[34] = 8636.0*z_5;
    prepared[35] = z_4;
    prepared[36] = 960.0*g;
    prepared[37] = 9.0*g;
    prepared[38] = 34.0*g;
    prepared[39] = 82.0*g;
    prepared[40] = 34800.0*g;
    prepared[41] = 100.0*z_2;
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
    const double c_18 = c[20];
    const double z_44 = (cos_q4*z_40 + 0.5*c_18*z_41) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_13) +
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
    const double c_8 = c[10];
    const double z_58 = 33885.0*z_54 + z_56*c_8 + 77724.0*z_55;
    const double z_59 = sin_q5*sin_q5;
    const double z_60 = sin_q4*z_59 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_54);
    const double z_61 = (cos_q4*(845415424.0*cos_q4 + 2159.0*z_51 + z_49*c_5 + z_52*z_39 - 798087304.0*z_45 -
        1440.0*z_48) + 0.5*cos_q5*z_52*c_18) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_57 - (20.0/203.0)*sin_q4*(8.0*cos_q5*z_58 + z_56*c_4 + 170000.0*z_60 -
        119895747.0*z_53)));
    M[7] = (1.0/10000000000.0)*(4318.0*cos_q3*(2426716.0*cos_q3 + 16646.0 + z_52*z_43 - z_57) + 30547567588.0 +
        2.0*z_61 - 4318.0*sin_q3*(336000.0 + cos_q4*(369656.0*cos_q4 + z_51 + z_52*z_23 - 354076.0*z_45) +
        10.0*sin_q4*(55533.0*sin_q4 + 288.0*z_54 + z_56*c_2 - 53975.0*z_53) - 2072640.0*sin_q3));
    M[12] = M[2] = ((-1.0/20000000000.0))*(-2.0*z_44);
    M[13] = M[8] = (1.0/10000000000.0)*(1098579138.0 + 2.0*z_61);
    const double z_62 = 2159.0*sin_q4 + 1000.0*z_54;
    const double z_63 = 77724.0*sin_q4 + 33885.0*z_54 + z_62*c_8;
    const double z_64 = sin_q5 - (4318.0/203.0)*cos_q4*cos_q5;
    const double z_65 = 203.0*z_64 - 2000.0*cos_q4;
    const double z_66 = c_0*z_65 + 8729.0*z_64 - 2880.0*cos_q4;
    const double z_67 = 203.0*cos_q5 + 4318.0*sin_q5*cos_q4;
    const double c_19 = c[21];
    M[14] = (1.0/500000000000.0)*(1000.0*sin_q4*(8.0*cos_q5*z_63 + z_62*c_4 + 170000.0*z_60) + 10150.0*sin_q5*z_66
        + 343365622869.0 + cos_q5*z_67*c_19 - 100.0*cos_q4*(2159.0*cos_q5*z_66 + z_65*c_5 + 292320.0*z_64 -
        845415424.0*cos_q4 - z_67*z_39));
    M[18] = M[3] = ((-1.0/62500000.0))*(81250.0*z_13 - z_35);
    const double z_68 = sin_q5*sin_q4;
    const double z_69 = cos_q5*z_68;
    M[19] = M[9] = ((-1.0/62500000.0))*(sin_q5*z_58 - 21250.0*z_69);
    M[20] = M[15] = (1.0/62500000.0)*(21250.0*z_69 - sin_q5*z_63);
    const double c_20 = c[22];
    M[21] = (1.0/6250000000000.0)*(2125000000.0*cos_q5*cos_q5 + 1200566413273.0 + c_20*z_59);
    M[24] = M[4] = (1.0/62500000.0)*(40135.0*z_8 + z_19*c_3 + 27009.0*z_18);
    const double c_10 = c[12];
    M[25] = M[10] = (1.0/62500000.0)*(40135.0*cos_q4 + z_49*c_10 - 18.0*z_48);
    M[26] = M[16] = ((-1.0/62500000.0))*(z_65*c_10 + 3654.0*z_64 - 40135.0*cos_q4);
    M[27] = M[22] = 0.0;
    const double c_21 = c[23];
    M[28] = c_21;
    M[30] = M[5] = ((-1.0/25000.0))*z_34;
    M[31] = M[11] = (1.0/25000.0)*z_68;
    M[32] = M[17] = (1.0/25000.0)*z_68;
    M[33] = M[23] = (1.0/25000.0)*cos_q5;
    M[34] = M[29] = 0.0;
    M[35] = (48526126417.0/250000000000.0);
}

/* What is factored, of which motion_bias is */
static void (*const factored)(double t, const double *restrict x, const double *restrict c, double *restrict M) =
    mass_matrix;

/* A (m, n), b (m): A xdot + b = 0                                                                               (8) */
static void pfaffian(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                     EM_UNUSED const double *restrict c, EM_UNUSED double *restrict A,
                     EM_UNUSED double *restrict b)
{
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
static void position(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                     EM_UNUSED const double *restrict c, EM_UNUSED double *restrict phi,
                     EM_UNUSED double *restrict terms)
{
}

/* crossing (n_events): an event happens where its number passes through zero */
static void model_events(EM_UNUSED double t, EM_UNUSED const double *restrict x,
                         EM_UNUSED const double *restrict v, EM_UNUSED const double *restrict c,
                         EM_UNUSED const double *restrict u, EM_UNUSED double *restrict crossing)
{
}

#include "em_mechanics.h"

/* M of the blocks that vary */
EM_INLINE void settled_masses(const double *restrict x, const double *restrict c, double M1[N1][N1],
                              double shared[50])
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
    const double z_32 = 70992000.0*sin_q2 + 1450848000.0*z_6 + 2159.0*z_31 - 18759823020.0*cos_q2;
    const double z_33 = 207169.0*sin_q2 - 1632.0*cos_q2;
    const double z_34 = sin_q4*z_30 - (1.0/5.0)*cos_q4*z_24;
    const double c_3 = c[5];
    const double z_35 = z_29*c_3 + 77724.0*z_28 - 33885.0*z_26;
    const double z_36 = z_13*cos_q5 + sin_q5*z_25;
    const double z_37 = sin_q5*z_35 - 21250.0*cos_q5*z_36;
    const double z_38 = 5725482720.0*z_13 + 406.0*z_31 - 15005.0*z_34 - 640.0*z_37;
    const double z_39 = sin_q5*z_20;
    const double c_4 = c[6];
    const double z_40 = 497229916.0*z_25 + 32.0*cos_q5*z_35 + 680000.0*sin_q5*z_36 + z_29*c_4 - 166654533.0*z_27 -
        2487168.0*z_26;
    const double c_5 = c[7];
    const double c_6 = c[8];
    const double z_41 = sin_q5*c_6;
    const double z_42 = 1690830848.0*z_8 + 2159.0*z_21 + z_19*c_5 + z_22*z_41 + 4321440.0*z_18 - 369656.0*z_16;
    const double c_7 = c[9];
    const double z_43 = cos_q5*z_22;
    const double z_44 = 5803392000.0*cos_q2 + c_7*z_43 - 9492774802.0*z_6 - 3001.0*z_39 - 20.0*cos_q4*z_40 -
        4.0*sin_q4*z_42;
    M1[0][0] = (1.0/1000000000000.0)*(130000000000.0*sin_q2*sin_q2 + 524000000000.0*cos_q2*cos_q2 +
        4350000.0*sin_q2*z_33 + 25.0*z_11*z_38 + 1134029968642.0 - 100.0*cos_q2*z_32 - 25.0*z_3*z_44 -
        25.0*z_5*z_44 - 25.0*z_12*z_38);
    const double z_45 = cos_q5*c_1;
    const double z_46 = 1821922.0*z_6 + z_39 - z_22*z_45;
    const double z_47 = 1575840.0*z_13 - 5.0*z_34;
    const double c_18 = c[20];
    const double z_48 = (cos_q4*z_42 + 0.5*c_18*z_43) - 24977323.0*((z_6 - (78792000.0/3568189.0)*z_13) +
        (1.0/246082.0)*(z_39 + (10.0/203.0)*sin_q4*z_40));
    M1[0][1] = M1[1][0] = ((-1.0/20000000000.0))*(5383560000.0*sin_q2 + 475020000.0*cos_q2 + 4318.0*cos_q3*z_46 +
        4318.0*sin_q3*z_47 - 2.0*z_48);
    const double z_49 = sin_q3*cos_q4;
    const double z_50 = 4318.0*cos_q3 + 203.0;
    const double z_51 = cos_q4 - z_49;
    const double z_52 = sin_q5*z_50 - 4318.0*cos_q5*z_51;
    const double z_53 = 2000.0*cos_q4 - z_52;
    const double z_54 = 2880.0*cos_q4 + c_0*z_53 - 43.0*z_52;
    const double z_55 = cos_q5*z_54;
    const double z_56 = cos_q5*z_50 + 4318.0*sin_q5*z_51;
    const double z_57 = 369656.0*cos_q4 + z_55 + z_56*z_23 - 354076.0*z_49;
    const double z_58 = sin_q3*sin_q4;
    const double z_59 = sin_q4*cos_q5;
    const double z_60 = sin_q4 - z_58;
    const double z_61 = 1000.0*z_59 + 2159.0*z_60;
    const double z_62 = 55533.0*sin_q4 + 288.0*z_59 + z_61*c_2 - 53975.0*z_58;
    const double z_63 = 336000.0 + cos_q4*z_57 + 10.0*sin_q4*z_62 - 2072640.0*sin_q3;
    const double z_64 = sin_q5*z_54;
    const double z_65 = 2426716.0*cos_q3 + 16646.0 + z_56*z_45 - z_64;
    const double z_66 = 845415424.0*cos_q4 + 2159.0*z_55 + z_53*c_5 + z_56*z_41 - 798087304.0*z_49 - 1440.0*z_52;
    const double c_8 = c[10];
    const double z_67 = 33885.0*z_59 + z_61*c_8 + 77724.0*z_60;
    const double z_68 = sin_q5*sin_q5;
    const double z_69 = sin_q4*z_68 + (124307479.0/170000.0)*(sin_q4 + (621792.0/124307479.0)*z_59);
    const double z_70 = 8.0*cos_q5*z_67 + z_61*c_4 + 170000.0*z_69 - 119895747.0*z_58;
    const double z_71 = (cos_q4*z_66 + 0.5*cos_q5*z_56*c_18) - 725424000.0*((sin_q3 - (1189.0/24000.0)*cos_q3) +
        (29.0/207264000.0)*(z_64 - (20.0/203.0)*sin_q4*z_70));
    M1[1][1] = (1.0/10000000000.0)*(4318.0*cos_q3*z_65 + 30547567588.0 + 2.0*z_71 - 4318.0*sin_q3*z_63);
    M1[0][2] = M1[2][0] = ((-1.0/20000000000.0))*(-2.0*z_48);
    M1[1][2] = M1[2][1] = (1.0/10000000000.0)*(1098579138.0 + 2.0*z_71);
    const double z_72 = 2159.0*sin_q4 + 1000.0*z_59;
    const double z_73 = 77724.0*sin_q4 + 33885.0*z_59 + z_72*c_8;
    const double z_74 = 8.0*cos_q5*z_73 + z_72*c_4 + 170000.0*z_69;
    const double z_75 = sin_q5 - (4318.0/203.0)*cos_q4*cos_q5;
    const double z_76 = 203.0*z_75 - 2000.0*cos_q4;
    const double z_77 = c_0*z_76 + 8729.0*z_75 - 2880.0*cos_q4;
    const double z_78 = 203.0*cos_q5 + 4318.0*sin_q5*cos_q4;
    const double z_79 = 2159.0*cos_q5*z_77 + z_76*c_5 + 292320.0*z_75 - 845415424.0*cos_q4 - z_78*z_41;
    const double c_19 = c[21];
    M1[2][2] = (1.0/500000000000.0)*(1000.0*sin_q4*z_74 + 10150.0*sin_q5*z_77 + 343365622869.0 + cos_q5*z_78*c_19
        - 100.0*cos_q4*z_79);
    M1[0][3] = M1[3][0] = ((-1.0/62500000.0))*(81250.0*z_13 - z_37);
    const double z_80 = sin_q5*z_59;
    M1[1][3] = M1[3][1] = ((-1.0/62500000.0))*(sin_q5*z_67 - 21250.0*z_80);
    M1[2][3] = M1[3][2] = (1.0/62500000.0)*(21250.0*z_80 - sin_q5*z_73);
    const double z_81 = cos_q5*cos_q5;
    const double c_20 = c[22];
    M1[3][3] = (1.0/6250000000000.0)*(2125000000.0*z_81 + 1200566413273.0 + c_20*z_68);
    M1[0][4] = M1[4][0] = (1.0/62500000.0)*(40135.0*z_8 + z_19*c_3 + 27009.0*z_18);
    const double c_10 = c[12];
    M1[1][4] = M1[4][1] = (1.0/62500000.0)*(40135.0*cos_q4 + z_53*c_10 - 18.0*z_52);
    M1[2][4] = M1[4][2] = ((-1.0/62500000.0))*(z_76*c_10 + 3654.0*z_75 - 40135.0*cos_q4);
    M1[3][4] = M1[4][3] = 0.0;
    const double c_21 = c[23];
    M1[4][4] = c_21;
    M1[0][5] = M1[5][0] = ((-1.0/25000.0))*z_36;
    M1[1][5] = M1[5][1] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[2][5] = M1[5][2] = (1.0/25000.0)*(sin_q5*sin_q4);
    M1[3][5] = M1[5][3] = (1.0/25000.0)*cos_q5;
    M1[4][5] = M1[5][4] = 0.0;
    M1[5][5] = (48526126417.0/250000000000.0);
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
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[50],
                             double Mdot1[N1][N1])
{
    const double cos_q2 = shared[0];
    const double q2_dot = v[1];
    const double sin_q2 = shared[1];
    const double z_82 = q2_dot*sin_q2;
    const double z_32 = shared[2];
    const double z_83 = q2_dot*cos_q2;
    const double sin_q3 = shared[3];
    const double z_84 = sin_q3*z_82;
    const double q3_dot = v[2];
    const double cos_q3 = shared[4];
    const double z_85 = q3_dot*cos_q3;
    const double z_86 = cos_q2*z_85;
    const double z_87 = cos_q3*z_83;
    const double z_88 = q3_dot*sin_q3;
    const double z_89 = sin_q2*z_88;
    const double z_90 = (z_84 - z_86) - (z_87 - z_89);
    const double z_24 = shared[5];
    const double q4_dot = v[3];
    const double cos_q4 = shared[6];
    const double z_91 = q4_dot*cos_q4;
    const double sin_q4 = shared[7];
    const double z_6 = shared[8];
    const double z_92 = sin_q4*z_90 - z_6*z_91;
    const double z_14 = shared[9];
    const double z_93 = sin_q3*z_83;
    const double z_94 = sin_q2*z_85;
    const double z_95 = cos_q3*z_82;
    const double z_96 = cos_q2*z_88;
    const double z_97 = (z_93 + z_94) + (z_95 + z_96);
    const double z_98 = 4318.0*z_82 + 203.0*z_97;
    const double z_13 = shared[10];
    const double z_99 = q4_dot*sin_q4;
    const double z_100 = (z_14*z_91 - sin_q4*z_98) - 1500.5*(cos_q4*z_97 - z_13*z_99);
    const double z_20 = shared[11];
    const double q5_dot = v[4];
    const double sin_q5 = shared[12];
    const double z_101 = q5_dot*sin_q5;
    const double cos_q5 = shared[13];
    const double c_0 = c[2];
    const double z_102 = q5_dot*cos_q5;
    const double z_103 = 8636.0*z_92 + 2.0*z_100;
    const double z_17 = shared[14];
    const double z_104 = (sin_q5*z_90 - z_6*z_102) + (1.0/3001.0)*(cos_q5*z_103 + z_17*z_101);
    const double z_105 = 4000.0*z_92 + 3001.0*z_104;
    const double z_106 = 5760.0*z_92 + c_0*z_105 + 129043.0*z_104;
    const double c_1 = c[3];
    const double z_22 = shared[15];
    const double z_107 = (z_17*z_102 - sin_q5*z_103) + 3001.0*(cos_q5*z_90 + z_6*z_101);
    const double z_108 = (z_20*z_101 + cos_q5*z_106) - c_1*(z_22*z_102 + sin_q5*z_107);
    const double z_109 = 739312.0*z_92 + 164.0*z_100 + z_108;
    const double z_30 = shared[16];
    const double z_110 = cos_q4*z_90;
    const double z_111 = z_6*z_99;
    const double z_112 = z_110 + z_111;
    const double z_25 = shared[17];
    const double z_113 = (z_13*z_102 + sin_q5*z_97) + (cos_q5*z_110 + cos_q5*z_111 + z_25*z_101);
    const double z_114 = (z_13*z_91 + sin_q4*z_97) - (2.0/3001.0)*(cos_q4*z_98 + z_14*z_99);
    const double z_115 = z_112 + (3001.0/8636.0)*z_114;
    const double z_116 = 4000.0*z_113 + 8636.0*z_115;
    const double c_2 = c[4];
    const double z_117 = 222132.0*z_112 + z_116*c_2 + 75025.0*z_114 + 1152.0*z_113;
    const double z_118 = (z_24*z_91 - sin_q4*z_109) - 5.0*(z_30*z_99 + cos_q4*z_117);
    const double z_33 = shared[18];
    const double z_38 = shared[19];
    const double z_11 = shared[20];
    const double z_119 = (z_30*z_91 - sin_q4*z_117) + (1.0/5.0)*(z_24*z_99 + cos_q4*z_109);
    const double z_35 = shared[21];
    const double c_3 = c[5];
    const double z_120 = z_116*c_3 + 33885.0*z_113 + 77724.0*z_115;
    const double z_36 = shared[22];
    const double z_121 = (cos_q5*z_97 - z_13*z_101) - (sin_q5*z_110 + sin_q5*z_111 - z_25*z_102);
    const double z_122 = (z_35*z_102 - sin_q5*z_120) + 21250.0*(z_36*z_101 - cos_q5*z_121);
    const double z_123 = 5725482720.0*z_97 + 406.0*z_118 - 15005.0*z_119 - 640.0*z_122;
    const double z_44 = shared[23];
    const double z_3 = shared[24];
    const double z_40 = shared[25];
    const double c_4 = c[6];
    const double z_124 = 497229916.0*z_112 + 32.0*(z_35*z_101 + cos_q5*z_120) + z_116*c_4 + 166654533.0*z_114 +
        2487168.0*z_113 - 680000.0*(z_36*z_102 + sin_q5*z_121);
    const double z_42 = shared[26];
    const double c_5 = c[7];
    const double z_125 = 1690830848.0*z_92 + z_105*c_5 + 4321440.0*z_104 + 369656.0*z_100 + 2159.0*z_108;
    const double z_126 = (z_20*z_102 - sin_q5*z_106) + c_1*(z_22*z_101 - cos_q5*z_107);
    const double z_127 = 5803392000.0*z_82 + 4.0*(z_42*z_91 - sin_q4*z_125) + 3001.0*z_126 - 9492774802.0*z_90 -
        20.0*(z_40*z_99 + cos_q4*z_124);
    const double z_5 = shared[27];
    const double z_12 = shared[28];
    Mdot1[0][0] = ((-1.0/40000000000.0))*(31520000000.0*cos_q2*z_82 + (z_44*z_87 - z_44*z_89 - z_5*z_127) -
        4.0*(z_32*z_82 - cos_q2*(70992000.0*z_83 + 18759823020.0*z_82 + 2159.0*z_118 - 1450848000.0*z_90)) -
        174000.0*(z_33*z_83 + sin_q2*(207169.0*z_83 + 1632.0*z_82)) - (z_38*z_93 + z_38*z_94 + z_11*z_123) -
        (z_44*z_84 + z_3*z_127 - z_44*z_86) - (z_38*z_95 + z_38*z_96 - z_12*z_123));
    const double z_46 = shared[29];
    const double z_47 = shared[30];
    const double z_128 = ((z_40*z_91 - sin_q4*z_124) + (1.0/5.0)*(z_42*z_99 + cos_q4*z_125)) + (203.0/10.0)*(z_126
        - 246082.0*(z_90 + (78792000.0/3568189.0)*z_97));
    Mdot1[0][1] = Mdot1[1][0] = ((-1.0/20000000000.0))*(5383560000.0*z_83 + 4318.0*(z_47*z_85 +
        sin_q3*(1575840.0*z_97 - 5.0*z_119)) + 10.0*z_128 - 475020000.0*z_82 - 4318.0*(z_46*z_88 +
        cos_q3*(1821922.0*z_90 - z_126)));
    const double z_63 = shared[31];
    const double z_57 = shared[32];
    const double z_129 = cos_q4*z_85 - sin_q3*z_99;
    const double z_54 = shared[33];
    const double z_50 = shared[34];
    const double z_51 = shared[35];
    const double z_130 = z_99 + z_129;
    const double z_131 = (z_50*z_102 - 4318.0*sin_q5*z_88) + 4318.0*(z_51*z_101 + cos_q5*z_130);
    const double z_132 = 2000.0*z_99 + z_131;
    const double z_133 = 2880.0*z_99 + c_0*z_132 + 43.0*z_131;
    const double z_56 = shared[36];
    const double z_134 = (z_50*z_101 + 4318.0*cos_q5*z_88) - 4318.0*(z_51*z_102 - sin_q5*z_130);
    const double z_135 = (z_54*z_101 + cos_q5*z_133) - c_1*(z_56*z_102 - sin_q5*z_134);
    const double z_62 = shared[37];
    const double z_136 = sin_q4*z_85 + sin_q3*z_91;
    const double z_137 = cos_q5*z_91 - sin_q4*z_101;
    const double z_138 = z_91 - z_136;
    const double z_139 = 1000.0*z_137 + 2159.0*z_138;
    const double z_65 = shared[38];
    const double z_140 = (z_54*z_102 - sin_q5*z_133) + c_1*(z_56*z_101 + cos_q5*z_134);
    const double z_70 = shared[39];
    const double z_67 = shared[40];
    const double c_8 = c[10];
    const double z_141 = 33885.0*z_137 + z_139*c_8 + 77724.0*z_138;
    const double z_59 = shared[41];
    const double z_68 = shared[42];
    const double z_142 = (2.0*z_59*z_101 + z_91*z_68) + (124307479.0/170000.0)*(z_91 +
        (621792.0/124307479.0)*z_137);
    const double z_66 = shared[43];
    const double z_143 = ((z_70*z_91 + sin_q4*(z_139*c_4 + 170000.0*z_142 - 119895747.0*z_136 - 8.0*(z_67*z_101 -
        cos_q5*z_141))) - (1.0/10.0)*(z_66*z_99 + cos_q4*(845415424.0*z_99 + 798087304.0*z_129 + z_132*c_5 +
        1440.0*z_131 + 2159.0*z_135))) - (203.0/20.0)*(z_140 + (207264000.0/29.0)*(z_85 + (1189.0/24000.0)*z_88));
    Mdot1[1][1] = ((-1.0/10000000000.0))*(4318.0*(z_63*z_85 - sin_q3*(2072640.0*z_85 + (z_57*z_99 +
        cos_q4*(369656.0*z_99 + 354076.0*z_129 + z_135)) - 10.0*(z_62*z_91 + sin_q4*(55533.0*z_91 + 288.0*z_137 +
        z_139*c_2 - 53975.0*z_136)))) + 4318.0*(z_65*z_88 + cos_q3*(2426716.0*z_88 + z_140)) - 20.0*z_143);
    Mdot1[0][2] = Mdot1[2][0] = (1.0/20000000000.0)*(-10.0*z_128);
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/10000000000.0))*(-20.0*z_143);
    const double z_74 = shared[44];
    const double z_73 = shared[45];
    const double z_144 = 2159.0*z_91 + 1000.0*z_137;
    const double z_145 = 77724.0*z_91 + 33885.0*z_137 + z_144*c_8;
    const double z_79 = shared[46];
    const double z_77 = shared[47];
    const double z_146 = z_102 + (4318.0/203.0)*(cos_q5*z_99 + cos_q4*z_101);
    const double z_147 = 2000.0*z_99 + 203.0*z_146;
    const double z_148 = 2880.0*z_99 + c_0*z_147 + 8729.0*z_146;
    const double z_78 = shared[48];
    const double z_149 = 203.0*z_101 - 4318.0*(cos_q4*z_102 - sin_q5*z_99);
    Mdot1[2][2] = (1.0/10000000000.0)*(20.0*(z_74*z_91 + sin_q4*(z_144*c_4 + 170000.0*z_142 - 8.0*(z_73*z_101 -
        cos_q5*z_145))) + 2.0*(z_79*z_99 - cos_q4*(845415424.0*z_99 + z_147*c_5 + 292320.0*z_146 -
        2159.0*(z_77*z_101 - cos_q5*z_148) - 2159.0*c_1*(z_78*z_102 - sin_q5*z_149))) + 203.0*(z_77*z_102 +
        sin_q5*z_148) - 203.0*c_1*(z_78*z_101 + cos_q5*z_149));
    Mdot1[0][3] = Mdot1[3][0] = ((-1.0/62500000.0))*(81250.0*z_97 - z_122);
    const double z_81 = shared[49];
    const double z_150 = q5_dot*sin_q4;
    const double z_151 = sin_q5*z_91;
    const double z_152 = z_81*z_150 + cos_q5*z_151 - z_68*z_150;
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/62500000.0))*((z_67*z_102 + sin_q5*z_141) - 21250.0*z_152);
    Mdot1[2][3] = Mdot1[3][2] = (1.0/62500000.0)*(21250.0*z_152 - (z_73*z_102 + sin_q5*z_145));
    const double c_9 = c[11];
    Mdot1[3][3] = -c_9*(cos_q5*z_101);
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/62500000.0))*(40135.0*z_92 + z_105*c_3 + 27009.0*z_104);
    const double c_10 = c[12];
    Mdot1[1][4] = Mdot1[4][1] = ((-1.0/62500000.0))*(40135.0*z_99 + z_132*c_10 + 18.0*z_131);
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/62500000.0))*(40135.0*z_99 + z_147*c_10 + 3654.0*z_146);
    Mdot1[3][4] = Mdot1[4][3] = 0.0;
    Mdot1[4][4] = 0.0;
    Mdot1[0][5] = Mdot1[5][0] = ((-1.0/25000.0))*z_121;
    Mdot1[1][5] = Mdot1[5][1] = (1.0/25000.0)*(sin_q4*z_102 + z_151);
    Mdot1[2][5] = Mdot1[5][2] = (1.0/25000.0)*(sin_q4*z_102 + z_151);
    Mdot1[3][5] = Mdot1[5][3] = ((-1.0/25000.0))*z_101;
    Mdot1[4][5] = Mdot1[5][4] = 0.0;
    Mdot1[5][5] = 0.0;
}

/* After an accepted step, and at the start: C and s.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
static int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                        em_fault *fault)
{
    (void)mode, (void)flags, (void)t, (void)y, (void)c, (void)memory, (void)pace, (void)fault;
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    double M1[N1][N1], shared[50];
    settled_masses(y, c, M1, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = INFINITY, delta_gap = INFINITY;
    gap = fmin(gap, em_gap(N1, y + 48));
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
    .energy = energy,
    .eigenfactors = em_eigenfactors_of,
    .output = em_observe,
    .jacobian = jacobian,
    .motion_jacobian = em_motion_jacobian,
    .simulate = em_simulate,
    .interpolate = em_interpolate,
    .release = em_release,
    .event = model_events,
    .lanes = &puma_lanes,
    .n_shapes = 11,
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
};

#endif
#endif
