/* eigenmotion generate bricard.py */
/* input sha256:8bfed4695aa35d8d063cad4540c1a879bca63331457e2dff1caab598a87465d9 */
/* body sha256:285b72fa5279b731ab93851b1103bc69748a18f295f23699634f9fff864ea1e7 */
/* bricard: equations of motion, eigenfactor formulation.
 *
 * State, 40 numbers:
 *   x    y[0 .. 5)
 *   eta  y[5 .. 10)
 *   C    y[10 .. 35)
 *   s    y[35 .. 40)
 *
 * Blocks of M that do not couple:
 *   1: q1, q2, q3, q4, q5 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dq1: M does not depend on it
 *
 * Operations of the straight-line part:
 *   eigenfactor: 666 additions, 1129 multiplications, 10 function calls
 *   triangular root: 702 additions, 1183 multiplications, 10 function calls
 *   projection: 312 additions, 557 multiplications, 10 function calls
 */
#include "bricard.h"

#include "em_functions.h"
#include "em_multipliers.h"

enum {
    N = 5,              /* coordinates */
    N_ROWS = 4,         /* constraint rows */
    N_POSITIONS = 4,    /* of which holonomic */
    N_STATE = 40,       /* numbers of a state */
    N_C = 25,           /* of which C, */
    N_S = 5,            /* s, */
    N_CD = 0,           /* C of Delta, */
    N_SD = 0,           /* s of Delta */
    N_INPUTS = 0,
    N_OUTPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 30,      /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,/* whether the state is x, xdot */
    SETTLES = 1,        /* whether an accepted step leaves anything to put right */
    N_PARAMETERS = 3,
    N_PREPARED = 31,    /* the parameters, factors of constant blocks, shared constants */
    N1 = 5,             /* q1, q2, q3, q4, q5 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4 };

#ifndef EM_ASIDE_ALONE

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real l = c[1];
    const real c_0 = c[3];
    const real q2_dot = v[1];
    const real q2 = x[1];
    const real cos_q2 = em_cos(q2);
    const real z_1 = q2_dot*cos_q2;
    const real z_2 = l*z_1;
    const real sin_q2 = em_sin(q2);
    const real q3_dot = v[2];
    const real q3 = x[2];
    const real cos_q3 = em_cos(q3);
    const real z_5 = q3_dot*cos_q3;
    const real z_6 = sin_q2*z_5;
    const real sin_q3 = em_sin(q3);
    const real z_8 = sin_q3*z_1;
    const real z_9 = z_2 - l*(z_6 + z_8);
    const real c_1 = c[4];
    const real q5 = x[4];
    const real sin_q5 = em_sin(q5);
    const real q4_dot = v[3];
    const real q4 = x[3];
    const real sin_q4 = em_sin(q4);
    const real z_12 = q4_dot*sin_q4;
    const real z_13 = cos_q2*z_12;
    const real cos_q4 = em_cos(q4);
    const real z_15 = q2_dot*sin_q2;
    const real z_16 = cos_q4*z_15;
    const real z_17 = sin_q3*sin_q4;
    const real z_18 = q4_dot*cos_q4;
    const real z_19 = sin_q2*sin_q3;
    const real z_20 = (z_13 + z_16) + (z_1*z_17 + sin_q4*z_6 + z_18*z_19);
    const real z_21 = cos_q2*cos_q4;
    const real z_22 = sin_q2*z_17;
    const real z_23 = z_21 - z_22;
    const real q5_dot = v[4];
    const real cos_q5 = em_cos(q5);
    const real z_25 = q5_dot*cos_q5;
    const real z_26 = cos_q3*cos_q5;
    const real z_27 = q3_dot*sin_q3;
    const real z_28 = cos_q5*z_27;
    const real z_29 = q5_dot*sin_q5;
    const real z_30 = sin_q2*cos_q3;
    const real z_31 = z_26*z_1 - sin_q2*z_28 - z_29*z_30;
    const real z_32 = l*z_20 - z_9;
    const real z_33 = l*((sin_q5*z_20 - z_23*z_25) - z_31) - z_32;
    const real c_2 = c[5];
    const real z_34 = -z_32;
    const real z_35 = z_33*c_2 + z_34*c_1;
    const real z_36 = c_0*z_1 + z_9*c_1 + z_35;
    const real z_37 = sin_q3*cos_q5;
    const real z_38 = sin_q5*cos_q3;
    const real z_39 = sin_q4*cos_q3;
    const real z_40 = cos_q3 + z_39;
    const real z_41 = l*(z_40 - (z_37 + sin_q4*z_38));
    const real z_42 = z_41*c_2;
    const real z_43 = l*z_40;
    const real c_3 = c[6];
    const real c_4 = c[7];
    const real m = c[0];
    const real z_44 = m*(2.0*z_41 + z_43);
    const real z_45 = l*((c_3*cos_q3 + z_42 + z_43*c_4) - sin_q5*z_44);
    const real z_46 = sin_q4*z_45;
    const real z_47 = l*(z_42 + z_43*c_1 + cos_q3*c_0) + z_46;
    const real z_48 = z_47*z_27;
    const real z_49 = cos_q5*z_5;
    const real z_50 = sin_q3*z_29;
    const real z_51 = z_49 - z_50;
    const real z_52 = sin_q4*z_25;
    const real z_53 = sin_q5*z_27;
    const real z_54 = cos_q3*z_18;
    const real z_55 = l*z_27 - l*(z_54 - sin_q4*z_27);
    const real z_56 = l*(z_51 + (z_18*z_38 + cos_q3*z_52 - sin_q4*z_53)) + z_55;
    const real z_57 = z_56*c_2;
    const real z_58 = z_44*z_25;
    const real z_59 = m*(2.0*z_56 + z_55);
    const real z_60 = sin_q5*z_59;
    const real z_61 = l*(c_3*z_27 + z_57 + z_55*c_4) + l*(z_58 - z_60);
    const real z_62 = l*(z_57 + z_55*c_1 + c_0*z_27) - (z_45*z_18 - sin_q4*z_61);
    const real z_63 = cos_q5*z_30;
    const real z_64 = l*sin_q2;
    const real z_65 = l - z_64;
    const real z_66 = l*z_19 + z_65;
    const real z_67 = l*z_23 - z_66;
    const real z_68 = l*(z_23*sin_q5 + z_63) - z_67;
    const real z_69 = -z_67;
    const real z_70 = c_3 + z_68*c_2 + z_65*c_4 + z_66*c_1 + z_69*c_1;
    const real z_71 = m*(2.0*z_68 + z_69);
    const real z_72 = l*(m*(3.0*z_68 + z_66 + 5.0*z_69) - sin_q5*z_71);
    const real z_73 = m*(2.0*z_33 + z_34);
    const real z_74 = l*(m*(3.0*z_33 + z_9 + 5.0*z_34)) + l*(z_71*z_25 - sin_q5*z_73);
    const real c_5 = c[8];
    const real z_75 = l*(m*(3.0*z_68 + z_65 + 5.0*z_66 + 6.0*z_69)) + sin_q4*z_72;
    const real z_76 = z_72*z_18;
    const real z_77 = l*(c_3*z_1 + z_9*c_4 + z_35) - (z_76 - sin_q4*z_74);
    const real z_78 = z_71*z_26;
    const real z_79 = sin_q2*z_71;
    const real z_80 = z_71*z_30;
    Mdot1[0][0] = ((-1.0/6.0))*(l*z_36 + (z_48 + cos_q3*z_62) + l*(z_70*z_1 - sin_q2*z_36) + c_5*z_1 +
        l*(z_44*z_49 - z_44*z_50 - z_37*z_59) - (z_72*z_16 + z_72*z_13 + z_21*z_74) - (z_75*z_8 + z_75*z_6 -
        z_77*z_19) - l*(z_1*z_78 - z_28*z_79 - z_29*z_80 - z_63*z_73));
    const real c_6 = c[9];
    const real c_7 = c[10];
    const real z_81 = m*z_41 + z_43*c_6 + cos_q3*c_7;
    const real z_82 = sin_q2*z_12;
    const real z_83 = cos_q4*z_45;
    const real z_84 = cos_q4*sin_q2;
    const real z_85 = sin_q3*z_47;
    const real z_86 = cos_q2*z_5;
    const real z_87 = cos_q2*sin_q3;
    const real z_88 = cos_q2*z_44;
    const real z_89 = cos_q3*z_29;
    Mdot1[0][1] = Mdot1[1][0] = (1.0/6.0)*(3.0*l*(z_81*z_15 + cos_q2*(m*z_56 + z_55*c_6 + c_7*z_27)) - (z_45*z_82
        + z_84*z_61 - z_1*z_83) - (z_15*z_85 + z_62*z_87 - z_47*z_86) - l*(z_26*(z_44*z_15) + z_28*z_88 +
        z_89*z_88 + z_26*(cos_q2*z_59)));
    const real z_90 = l*sin_q3;
    const real z_91 = l - z_90;
    const real z_92 = l*z_17 - z_91;
    const real z_93 = -l*(z_26 - sin_q5*z_17) - z_92;
    const real z_94 = -z_92;
    const real z_95 = m*(2.0*z_93 + z_94);
    const real z_96 = l*(m*(3.0*z_93 + z_91 + 5.0*z_94) - sin_q5*z_95);
    const real z_97 = l*(c_3 + z_93*c_2 + z_91*c_4 + z_94*c_1) + sin_q4*z_96;
    const real z_98 = z_28 + z_89;
    const real z_99 = sin_q5*z_5;
    const real z_100 = sin_q3*z_18;
    const real z_101 = l*z_5;
    const real z_102 = z_101 + l*(z_100 + sin_q4*z_5);
    const real z_103 = z_102 - l*(z_98 + (z_25*z_17 + sin_q4*z_99 + sin_q5*z_100));
    const real z_104 = z_103*c_2;
    const real z_105 = m*(2.0*z_103 + z_102);
    const real z_106 = z_96*z_18 - sin_q4*(l*(c_3*z_5 + z_104 + z_102*c_4) + l*(z_95*z_25 - sin_q5*z_105));
    const real z_107 = l*(cos_q4 - cos_q4*sin_q5);
    const real z_108 = c_3*cos_q4;
    const real z_109 = z_108 + z_107*c_6;
    const real z_110 = l*((z_107*c_2 + cos_q4*c_0) - sin_q5*z_109);
    const real z_111 = l*z_12 - l*(sin_q5*z_12 - cos_q4*z_25);
    const real z_112 = c_3*z_12 + z_111*c_6;
    const real z_113 = l*(z_111*c_2 + c_0*z_12) + l*(z_109*z_25 - sin_q5*z_112);
    const real z_114 = cos_q4*z_113;
    const real c_8 = c[11];
    Mdot1[1][1] = ((-1.0/6.0))*((z_97*z_5 - sin_q3*(l*(z_104 + c_0*z_5 + z_102*c_1) - z_106)) + (z_110*z_12 +
        z_114) + (m*z_103 + c_7*z_5 + z_102*c_6)*c_8 - l*(z_95*z_28 + z_95*z_89 + z_26*z_105));
    const real z_115 = cos_q5*z_44;
    const real z_116 = z_44*z_29;
    Mdot1[0][2] = Mdot1[2][0] = (1.0/6.0)*((z_75*z_5 - sin_q3*z_77) + (cos_q3*z_47*z_1 - sin_q2*z_48 - z_62*z_30)
        - l*(z_71*z_28 + z_71*z_89 + z_26*z_73) - l*(z_8*z_115 + z_6*z_115 - z_19*z_116 - cos_q5*(z_59*z_19)));
    const real z_117 = m*z_107 + cos_q4*c_7;
    const real z_118 = sin_q4*z_110;
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/6.0))*(3.0*l*(z_117*z_27 + cos_q3*(m*z_111 + c_7*z_12)) + l*(z_109*z_49 -
        z_109*z_50 - z_37*z_112) - (z_110*z_54 - z_27*z_118 - z_39*z_113));
    const real z_119 = l*sin_q5;
    const real z_120 = l*sin_q4;
    const real z_121 = l + z_120;
    const real z_122 = z_121 - sin_q4*z_119;
    const real z_123 = m*(2.0*z_122 + z_121);
    const real z_124 = l*((c_3 + z_122*c_2 + z_121*c_4) - sin_q5*z_123);
    const real z_125 = l*z_18 - l*(z_52 + sin_q5*z_18);
    const real z_126 = l*(z_123*z_25 + sin_q5*(c_3*z_18 + z_125*c_6));
    const real c_9 = c[12];
    const real z_127 = cos_q5*c_9;
    Mdot1[2][2] = (1.0/6.0)*((z_124*z_18 + sin_q4*(l*(z_125*c_2 + c_0*z_18) - z_126)) + (m*z_125 + c_7*z_18)*c_8 -
        z_29*z_127);
    const real z_128 = cos_q4*z_72;
    const real z_129 = cos_q2*z_18;
    const real z_130 = cos_q2*sin_q4;
    Mdot1[0][3] = Mdot1[3][0] = (1.0/6.0)*((cos_q3*z_72*z_12 + z_27*z_128 + cos_q4*cos_q3*z_74) - (z_46*z_15 +
        z_61*z_130 - z_45*z_129) - (z_45*z_12*z_19 + cos_q4*z_61*z_19 - z_8*z_83 - z_6*z_83));
    const real z_131 = sin_q3*z_110;
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/6.0))*(z_106 + (z_12*z_131 + sin_q3*z_114 - cos_q4*z_110*z_5));
    const real z_132 = c_5*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    const real z_133 = cos_q5*cos_q5;
    const real z_134 = q5_dot*z_133;
    const real c_10 = c[13];
    Mdot1[2][3] = Mdot1[3][2] = (1.0/6.0)*(z_132*z_12 + cos_q4*(2.0*c_5*(z_134 - q5_dot*(sin_q5*sin_q5)) +
        c_10*z_29));
    const real z_135 = l - z_119;
    const real z_136 = c_3 + z_135*c_6;
    const real z_137 = l*cos_q5;
    const real z_138 = q5_dot*z_137;
    const real c_11 = c[14];
    Mdot1[3][3] = ((-1.0/6.0))*(c_10*z_25 - (cos_q5*c_11*z_29 - z_136*z_138));
    const real z_139 = sin_q3*z_25;
    const real z_140 = sin_q3*sin_q5;
    const real z_141 = sin_q4*cos_q5;
    const real z_142 = z_27*z_141;
    const real z_143 = sin_q4*z_71;
    const real z_144 = cos_q3*z_141;
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(l*(z_20*z_115 + z_23*z_116 + cos_q5*(z_23*z_59)) + l*(z_71*z_99 +
        z_71*z_139 - z_140*z_73) + l*(z_38*(z_44*z_1) + z_58*z_30 - z_53*(sin_q2*z_44) - z_60*z_30) - l*(z_18*z_78
        - z_71*z_142 - z_89*z_143 - z_144*z_73));
    const real z_145 = cos_q5*z_12;
    const real z_146 = cos_q4*z_29;
    const real z_147 = cos_q4*cos_q5;
    const real z_148 = cos_q5*z_17;
    Mdot1[1][4] = Mdot1[4][1] = (1.0/6.0)*(l*(z_95*z_145 + z_95*z_146 + z_105*z_147) - l*(z_25*(cos_q3*z_109) -
        z_109*z_53 - z_112*z_38) - l*(z_109*z_5*z_141 + cos_q5*(z_109*z_100) - z_29*(z_109*z_17) - z_112*z_148));
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/6.0))*(z_126 - 2.0*c_5*(z_133*z_18 - 2.0*z_29*z_141));
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real c_12 = c[15];
    const real c_13 = c[16];
    const real z_149 = c_13 - sin_q5*c_12;
    const real q1_dot = v[0];
    const real z_150 = q1_dot*z_45;
    const real z_151 = q2_dot*cos_q4;
    const real z_152 = q1_dot*q1_dot;
    const real z_153 = cos_q3*z_137;
    const real z_154 = l*z_152;
    const real z_155 = q1_dot*cos_q3;
    const real z_156 = 2.0*q1_dot*z_27 + z_152*z_19;
    const real z_157 = 2.0*z_18*z_155 + z_21*z_152 - sin_q4*z_156;
    const real z_158 = l*z_157;
    const real z_159 = sin_q2*z_152;
    const real z_160 = l*(-(z_152 - z_159));
    const real c_14 = c[17];
    const real z_161 = z_156*c_14 - z_158 - 6.0*z_160;
    const real z_162 = l*(2.0*z_52*z_155 + 2.0*q1_dot*z_49 + z_63*z_152 + sin_q5*z_157 - 2.0*q1_dot*z_50);
    const real c_15 = c[18];
    const real z_163 = z_162 + z_156*c_15 - 6.0*z_160 - z_157*c_14;
    const real z_164 = 2.0*z_162 + z_156*c_8 - 3.0*z_160 - z_157*c_8;
    const real z_165 = z_163 + z_164;
    const real z_166 = m*(z_161 + z_165);
    const real z_167 = c_3*z_164;
    const real z_168 = c_3*sin_q5;
    const real c_16 = c[19];
    const real z_169 = z_44*c_16;
    const real z_170 = q1_dot*z_169;
    const real z_171 = z_164*z_168 + z_25*z_170 - l*(m*z_165);
    const real z_172 = q1_dot*q2_dot;
    const real c_17 = c[20];
    const real c_18 = c[21];
    const real c_19 = c[22];
    const real z_173 = cos_q5*z_155;
    f1[1] = (1.0/12.0)*(cos_q2*(6.0*cos_q4*z_149 + 2.0*z_100*z_150 + 2.0*q1_dot*z_47*z_5 + 2.0*z_151*z_150 +
        z_152*(z_71*z_153) + sin_q3*z_75*z_152 + z_90*z_166 + z_26*z_167 - z_70*z_154 - l*(m*z_163 + m*z_161 +
        (c_3*z_152 + m*(l*z_156 - 5.0*z_160)) + m*z_164) - z_171*z_17 - z_29*z_155*z_169 - z_28*z_170) -
        sin_q2*(6.0*z_149*z_17 + 2.0*z_12*z_150 + 2.0*z_172*z_85 + cos_q4*z_171 + c_17 + sin_q3*c_18 + z_26*c_19 +
        q2_dot*z_169*z_173 - z_152*z_128 - z_81*c_15*z_172));
    const real z_174 = q2_dot*q3_dot;
    const real z_175 = q2_dot*q2_dot;
    const real z_176 = z_95*z_175;
    const real z_177 = q2_dot*q4_dot;
    const real z_178 = sin_q3*z_175;
    const real z_179 = 2.0*z_177 + z_178;
    const real z_180 = sin_q4*z_179;
    const real z_181 = l*(2.0*z_25*z_151 + z_26*z_175 - sin_q5*z_180);
    const real z_182 = c_8*z_175 - 2.0*z_181 - z_180*c_8 - z_178*c_8;
    const real z_183 = c_3*z_182;
    const real z_184 = q1_dot*sin_q2;
    const real z_185 = 2.0*z_5*z_184 + 2.0*q1_dot*z_8 + cos_q3*z_152;
    const real z_186 = 2.0*z_100*z_184 + 2.0*q1_dot*z_13 + 2.0*z_184*z_151 + sin_q4*z_185;
    const real z_187 = q1_dot*z_1;
    const real z_188 = q1_dot*z_23;
    const real z_189 = l*(2.0*z_89*z_184 + 2.0*z_28*z_184 + z_37*z_152 + sin_q5*z_186 - 2.0*z_25*z_188 -
        2.0*z_1*z_173);
    const real c_20 = c[23];
    const real z_190 = 2.0*z_189 + z_187*c_15 - z_186*c_8 - z_185*c_8;
    const real z_191 = m*((z_189 + z_187*c_20 - z_186*c_14 - z_185*c_15) + z_190);
    const real z_192 = sin_q4*z_168;
    const real z_193 = c_16*(q2_dot*z_109);
    const real z_194 = c_16*(q1_dot*z_71);
    const real z_195 = z_184*z_169;
    const real z_196 = q3_dot*cos_q5;
    const real z_197 = (c_15*z_175 - z_181 - z_180*c_14 - z_178*c_15) + z_182;
    const real z_198 = m*z_197;
    const real z_199 = z_45*z_184;
    const real z_200 = c_3*z_190;
    f1[2] = ((-1.0/12.0))*(sin_q3*(2.0*z_174*z_118 + 2.0*z_47*(q3_dot*z_184) + z_152*z_137*z_79 + z_47*z_152 +
        z_190*z_192 + sin_q2*cos_q5*z_167 + c_19*(cos_q2*cos_q5) + c_15*(z_117*z_174) + z_52*z_194 + z_194*z_196 +
        cos_q5*z_187*z_169 - z_137*z_176 - cos_q5*z_183 - 2.0*q1_dot*z_76 - c_3*(l*(-(5.0*z_185 + z_186 -
        12.0*z_187))) - z_120*z_191 - l*z_191 - z_29*z_193 - z_29*z_195) - cos_q3*(6.0*z_149*z_130 +
        2.0*q2_dot*z_110*z_18 + z_182*z_192 + 2.0*z_18*z_199 + 2.0*q1_dot*q3_dot*z_75 + 2.0*z_47*z_187 +
        z_75*z_159 + cos_q5*z_200 + z_64*z_166 + cos_q2*c_18 - z_97*z_175 - z_120*z_198 - l*(m*(l*(6.0*z_175 -
        5.0*z_178 - z_180) + z_197)) - z_152*(z_44*z_137) - sin_q2*sin_q4*z_171 - z_52*z_193 - z_193*z_196 -
        z_29*z_194 - z_195*z_196));
    const real z_201 = q3_dot*q3_dot;
    const real z_202 = z_201;
    const real z_203 = sin_q4*z_201;
    const real z_204 = 2.0*q3_dot*q5_dot + z_203;
    const real z_205 = sin_q5*z_204;
    const real z_206 = l*(-(3.0*z_202 + 3.0*z_203 - 2.0*z_205));
    const real z_207 = q2_dot*z_5;
    const real z_208 = l*cos_q3;
    const real z_209 = c_16*z_25;
    const real z_210 = 2.0*q2_dot*z_100 + 2.0*sin_q4*z_207 + cos_q4*z_175;
    const real z_211 = l*(2.0*z_25*(q2_dot*z_17) + 2.0*q2_dot*z_89 + 2.0*q2_dot*z_28 + sin_q5*z_210);
    const real z_212 = c_15*z_207 + z_210*c_8 - 2.0*z_211;
    f1[3] = (1.0/12.0)*(cos_q4*(6.0*z_149*z_87 + z_124*z_201 + z_206*z_168 + 2.0*z_110*z_207 + sin_q3*z_182*z_168
        + 2.0*q4_dot*cos_q2*z_150 + z_72*z_156 + z_45*z_185 + z_38*z_200 + q3_dot*z_134*c_9 + z_71*z_155*z_209 -
        l*(m*(l*(-(6.0*z_202 + 5.0*z_203 - z_205)) + z_206)) - z_96*z_179 - z_90*z_198 - z_208*z_191 - z_171*z_19
        - z_139*z_193) + sin_q4*(2.0*q3_dot*q4_dot*z_132 + z_212*z_168 + 2.0*q4_dot*z_72*z_155 + cos_q2*z_72*z_152
        + q2_dot*z_95*z_209 - 6.0*sin_q2*z_149 - 2.0*z_177*z_131 - z_110*z_175 - c_3*(c_20*z_207 + z_210*c_14 -
        z_211) - c_3*z_212 - 2.0*q4_dot*sin_q3*z_199 - 2.0*q2_dot*z_199 - cos_q2*z_171));
    const real z_213 = cos_q2*cos_q3;
    const real c_21 = c[24];
    const real z_214 = q3_dot*z_18;
    const real c_22 = c[25];
    const real z_215 = q5_dot*c_16;
    const real z_216 = q4_dot*q4_dot;
    const real z_217 = z_84 + cos_q2*z_17;
    const real z_218 = q5_dot*cos_q3;
    f1[4] = ((-1.0/12.0))*(sin_q5*(z_154*z_80 + sin_q3*z_200 + z_30*z_167 + c_19*z_213 + q3_dot*z_52*c_21 +
        c_9*(sin_q5*z_214) + z_201*z_127 + z_155*z_143*z_215 + z_169*(q5_dot*z_188) + z_5*z_194 +
        z_169*(z_1*z_155) - z_208*z_176 - cos_q3*z_183 - z_44*z_90*z_152 - c_22*z_214 - q5_dot*z_17*z_193 -
        z_215*(z_95*z_151) - z_27*z_193 - z_27*z_195) + cos_q5*(z_136*(l*z_216) + l*z_123*z_204 + z_109*(l*z_210)
        + z_108*z_212 + z_186*(l*z_44) + z_217*c_19 + z_193*z_218 + z_195*z_218 + q5_dot*sin_q3*z_194 -
        c_3*(l*(-(3.0*z_216 - 2.0*sin_q5*z_216))) - c_3*sin_q4*z_206 - z_95*(z_120*z_179) - z_17*z_183 -
        z_71*z_158 - z_39*z_200 - z_23*z_167 - z_214*z_127));
    const real z_219 = sin_q4*z_135;
    const real z_220 = l + z_219;
    const real z_221 = cos_q3*z_220 - sin_q3*z_137;
    const real q1 = x[0];
    const real cos_q1 = em_cos(q1);
    const real z_223 = cos_q4*z_135;
    const real z_224 = cos_q2*z_223;
    const real z_225 = z_65 + z_220*z_19 + z_137*z_30 - z_224;
    const real sin_q1 = em_sin(q1);
    A1[0][0] = z_221*cos_q1 - z_225*sin_q1;
    const real z_227 = sin_q3*z_220;
    const real z_228 = l*cos_q1 - cos_q1*z_227 - cos_q1*z_153;
    const real z_229 = sin_q2*cos_q1;
    A1[0][1] = -(cos_q2*z_228 - z_223*z_229);
    const real z_230 = z_220*sin_q1 + z_137*z_229;
    const real z_231 = sin_q1*z_137 - z_220*z_229;
    A1[0][2] = -(sin_q3*z_230 + cos_q3*z_231);
    const real z_232 = cos_q3*sin_q1;
    const real z_233 = z_232 + cos_q1*z_19;
    const real z_234 = z_135*z_130;
    A1[0][3] = z_233*z_223 + cos_q1*z_234;
    const real z_235 = sin_q3*sin_q1;
    const real z_236 = z_235 - cos_q1*z_30;
    const real z_237 = sin_q4*z_233 - z_21*cos_q1;
    A1[0][4] = l*(sin_q5*z_236 - cos_q5*z_237);
    A1[1][0] = em_real(0.0);
    const real z_238 = z_91 - z_153 - z_135*z_17;
    A1[1][1] = -(z_224 + sin_q2*z_238);
    const real z_239 = l*cos_q2 + z_234;
    A1[1][2] = -(cos_q3*z_239 - z_137*z_87);
    A1[1][3] = sin_q2*z_219 - z_223*z_87;
    A1[1][4] = l*(cos_q5*z_217 + cos_q2*z_38);
    A1[2][0] = -(z_221*sin_q1 + cos_q1*z_225);
    const real z_240 = l*sin_q1 - sin_q1*z_227 - sin_q1*z_153;
    const real z_241 = sin_q2*sin_q1;
    A1[2][1] = cos_q2*z_240 - z_241*z_223;
    const real z_242 = z_220*cos_q1;
    const real z_243 = z_242 - z_137*z_241;
    const real z_244 = cos_q1*z_137 + z_220*z_241;
    A1[2][2] = -(sin_q3*z_243 + cos_q3*z_244);
    const real z_245 = cos_q3*cos_q1 - sin_q3*z_241;
    A1[2][3] = z_245*z_223 - sin_q1*z_234;
    const real z_246 = sin_q3*cos_q1;
    const real z_247 = z_246 + sin_q1*z_30;
    const real z_248 = sin_q4*z_245 + z_21*sin_q1;
    A1[2][4] = l*(sin_q5*z_247 - cos_q5*z_248);
    const real z_249 = sin_q5*z_30 + sin_q2*z_148 - z_21*cos_q5;
    const real z_250 = z_140 - z_144;
    A1[3][0] = cos_q1*z_249 - sin_q1*z_250;
    const real z_251 = sin_q1*z_38 + sin_q1*z_148;
    A1[3][1] = cos_q2*z_251 + z_241*z_147;
    const real z_252 = sin_q5*cos_q1 + z_241*z_141;
    const real z_253 = sin_q5*z_241 - cos_q1*z_141;
    A1[3][2] = cos_q3*z_252 - sin_q3*z_253;
    const real z_254 = cos_q2*z_141;
    A1[3][3] = -(z_245*z_147 - sin_q1*z_254);
    A1[3][4] = sin_q5*z_248 + cos_q5*z_247;
    const real z_255 = z_135*z_18;
    const real z_256 = sin_q4*z_138;
    const real z_257 = z_255 - z_256;
    const real z_258 = (z_220*z_27 - cos_q3*z_257) + l*z_51;
    const real z_259 = q1_dot*sin_q1;
    const real z_260 = z_15*z_223;
    const real z_261 = z_135*z_13;
    const real z_262 = z_260 + z_261 + z_21*z_138;
    const real z_263 = z_2 - (z_220*z_8 + z_220*z_6 + z_257*z_19) - z_262 - l*z_31;
    const real z_264 = q1_dot*cos_q1;
    const real z_265 = z_135*z_12;
    const real z_266 = cos_q1*z_1;
    const real z_267 = cos_q4*z_138;
    const real z_268 = sin_q1*z_184;
    const real z_269 = sin_q1*z_29;
    const real z_270 = cos_q1*z_155;
    const real z_271 = (z_270 - sin_q1*z_27) + (cos_q1*z_8 + z_5*z_229 - sin_q3*z_268);
    const real z_272 = z_219*z_15;
    const real z_273 = z_135*z_129;
    const real z_274 = z_138*z_130;
    const real z_275 = sin_q1*z_5;
    gamma[0] = -(q1_dot*((cos_q1*z_258 + z_221*z_259) - (sin_q1*z_263 - z_225*z_264)) + q3_dot*((z_230*z_5 +
        sin_q3*((sin_q1*z_257 + z_220*z_264) + l*(cos_q5*z_266 - z_29*z_229 - cos_q5*z_268))) - (z_231*z_27 +
        cos_q3*(l*(z_269 - cos_q5*z_264) + (z_220*z_266 + z_257*z_229 - z_220*z_268)))) + q4_dot*((z_233*z_265 +
        z_233*z_267 - z_271*z_223) + (cos_q1*z_272 + cos_q1*z_274 + z_234*z_259 - cos_q1*z_273)) -
        q2_dot*((z_228*z_15 + cos_q2*(l*z_259 + (z_242*z_5 + z_246*z_257 - z_259*z_227) - l*(cos_q1*z_28 +
        cos_q1*z_89 + sin_q1*z_173))) - (z_229*z_265 + z_267*z_229 + z_223*z_268 - z_223*z_266)) -
        q5_dot*(l*(z_236*z_25 + sin_q5*((sin_q3*z_264 + z_275) + (cos_q3*z_268 + z_27*z_229 - cos_q3*z_266))) +
        l*(z_237*z_29 - cos_q5*((z_233*z_18 + sin_q4*z_271) + (z_21*z_259 + cos_q1*z_16 + cos_q1*z_13)))));
    gamma[1] = q2_dot*(z_262 - (z_238*z_1 - sin_q2*(z_101 + (z_219*z_5 + z_135*z_100 - z_138*z_17) - l*z_98))) +
        q3_dot*((z_239*z_27 + cos_q3*(l*z_15 + (z_272 + z_274 - z_273))) - l*(z_37*z_15 + z_29*z_87 -
        cos_q2*z_49)) + q4_dot*((z_219*z_1 + sin_q2*z_255 - sin_q2*z_256) + (sin_q3*z_260 + sin_q3*z_261 +
        z_21*(sin_q3*z_138) - z_223*z_86)) - q5_dot*(l*(z_217*z_29 - cos_q5*((cos_q4*z_1 - z_82) + (z_5*z_130 +
        cos_q2*z_100 - z_15*z_17))) + l*(z_15*z_38 + cos_q2*z_53 - z_25*z_213));
    const real z_276 = sin_q1*z_1;
    const real z_277 = cos_q1*z_184;
    const real z_278 = (sin_q1*z_155 + cos_q1*z_27) + (sin_q3*z_277 + sin_q1*z_8 + z_5*z_241);
    const real z_279 = (cos_q1*z_5 - sin_q3*z_259) + (cos_q3*z_277 + cos_q3*z_276 - z_27*z_241);
    const real z_280 = (z_245*z_18 - sin_q4*z_278) - (sin_q1*z_16 + sin_q1*z_13 - z_21*z_264);
    gamma[2] = q1_dot*((sin_q1*z_258 - z_221*z_264) + (z_225*z_259 + cos_q1*z_263)) + q5_dot*(l*(z_247*z_25 +
        sin_q5*z_279) + l*(z_248*z_29 - cos_q5*z_280)) - q2_dot*((z_240*z_15 - cos_q2*(l*z_264 + l*(sin_q1*z_28 +
        sin_q1*z_89 - cos_q1*z_173) - (z_220*z_275 + z_235*z_257 + z_264*z_227))) - (z_241*z_265 + z_267*z_241 -
        z_223*z_276 - z_223*z_277)) - q3_dot*((z_243*z_5 + sin_q3*((cos_q1*z_257 - z_220*z_259) - l*(cos_q5*z_276
        + cos_q5*z_277 - z_29*z_241))) - (z_244*z_27 + cos_q3*(l*(cos_q1*z_29 + cos_q5*z_259) - (z_220*z_276 +
        z_257*z_241 + z_220*z_277)))) - q4_dot*((z_245*z_265 + z_245*z_267 + z_278*z_223) - (sin_q1*z_272 +
        sin_q1*z_274 - sin_q1*z_273 - z_234*z_264));
    const real z_281 = cos_q5*z_18;
    const real z_282 = cos_q5*sin_q1;
    const real z_283 = sin_q4*z_29;
    gamma[3] = -(q1_dot*((z_249*z_259 - cos_q1*((z_1*z_38 + z_25*z_30 - sin_q2*z_53) + (z_15*z_147 + cos_q5*z_13 +
        z_21*z_29) + (z_1*z_148 + z_6*z_141 + z_19*z_281 - z_22*z_29))) + (z_250*z_264 + sin_q1*((z_99 + z_139) -
        (z_26*z_18 - z_142 - sin_q4*z_89)))) + q2_dot*((z_251*z_15 - cos_q2*((z_232*z_25 + sin_q5*z_270 -
        sin_q1*z_53) + (z_275*z_141 + z_100*z_282 + z_264*z_148 - z_269*z_17))) + (z_241*z_145 + z_241*z_146 -
        z_276*z_147 - z_277*z_147)) + q3_dot*((z_252*z_27 - cos_q3*((cos_q1*z_25 - sin_q5*z_259) + (z_141*z_276 +
        z_241*z_281 + z_141*z_277 - z_241*z_283))) + (z_253*z_5 + sin_q3*((sin_q5*z_276 + z_25*z_241 +
        sin_q5*z_277) - (cos_q1*z_281 - cos_q1*z_283 - z_141*z_259)))) - q4_dot*((z_245*z_145 + z_245*z_146 +
        z_278*z_147) - (sin_q1*z_15*z_141 + z_269*z_130 - z_129*z_282 - z_264*z_254)) - q5_dot*((z_248*z_25 +
        sin_q5*z_280) - (z_247*z_29 - cos_q5*z_279)));
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{
    (void)t, (void)c, (void)fault;

    /* q1, q2, q3, q4, q5: xdot = C^T S^-1 eta (20) */
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
    (void)t, (void)c, (void)u, (void)memory, (void)flags, (void)fault;

    /* q1, q2, q3, q4, q5: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    const real *const C1 = y + 10, *const s1 = y + 35;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, f1, A1, gamma);

    /* q1, q2, q3, q4, q5: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* q1, q2, q3, q4, q5: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real mu1[N1*N1], Omega1[N1*N1];
    em_congruence(N1, C1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 10, *const s1_dot = dy + 35;
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
    dy[5] = a1[0];
    dy[6] = a1[1];
    dy[7] = a1[2];
    dy[8] = a1[3];
    dy[9] = a1[4];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[66])
{
    const real l = c[1];
    const real c_3 = c[6];
    const real q2 = x[1];
    const real cos_q2 = em_cos(q2);
    const real q4 = x[3];
    const real cos_q4 = em_cos(q4);
    const real z_2 = cos_q2*cos_q4;
    const real sin_q4 = em_sin(q4);
    const real sin_q2 = em_sin(q2);
    const real q3 = x[2];
    const real sin_q3 = em_sin(q3);
    const real z_6 = sin_q2*sin_q3;
    const real z_7 = z_2 - sin_q4*z_6;
    const real q5 = x[4];
    const real sin_q5 = em_sin(q5);
    const real cos_q5 = em_cos(q5);
    const real cos_q3 = em_cos(q3);
    const real z_11 = sin_q2*cos_q3;
    const real z_12 = cos_q5*z_11;
    const real z_13 = l*sin_q2;
    const real z_14 = l - z_13;
    const real z_15 = l*z_6 + z_14;
    const real z_16 = l*z_7 - z_15;
    const real z_17 = l*(z_7*sin_q5 + z_12) - z_16;
    const real c_2 = c[5];
    const real c_4 = c[7];
    const real c_1 = c[4];
    const real z_18 = -z_16;
    const real z_19 = c_3 + z_17*c_2 + z_14*c_4 + z_15*c_1 + z_18*c_1;
    const real z_20 = l*z_19;
    const real z_21 = sin_q3*cos_q5;
    const real z_22 = sin_q4*cos_q3;
    const real z_23 = cos_q3 + z_22;
    const real z_24 = l*(z_23 - (z_21 + sin_q5*z_22));
    const real z_25 = z_24*c_2;
    const real z_26 = l*z_23;
    const real c_0 = c[3];
    const real m = c[0];
    const real z_27 = m*(2.0*z_24 + z_26);
    const real z_28 = sin_q5*z_27;
    const real z_29 = l*((c_3*cos_q3 + z_25 + z_26*c_4) - z_28);
    const real z_30 = sin_q4*z_29;
    const real z_31 = l*(z_25 + z_26*c_1 + cos_q3*c_0) + z_30;
    const real z_32 = m*(2.0*z_17 + z_18);
    const real z_33 = l*(m*(3.0*z_17 + z_15 + 5.0*z_18) - sin_q5*z_32);
    const real z_34 = l*(m*(3.0*z_17 + z_14 + 5.0*z_15 + 6.0*z_18)) + sin_q4*z_33;
    const real z_35 = l*cos_q5;
    const real z_36 = z_27*z_35;
    const real z_37 = z_32*z_11;
    const real c_9 = c[12];
    M1[0][0] = (1.0/6.0)*(z_20 + cos_q3*z_31 + c_3*z_14 + z_34*z_6 + z_35*z_37 + c_9 - z_13*z_19 - z_2*z_33 -
        sin_q3*z_36);
    const real z_38 = cos_q4*z_29;
    const real z_39 = cos_q2*sin_q3;
    const real z_40 = cos_q3*z_35;
    const real z_41 = cos_q2*z_27;
    const real c_6 = c[9];
    const real c_7 = c[10];
    const real z_42 = m*z_24 + z_26*c_6 + cos_q3*c_7;
    const real c_8 = c[11];
    M1[1][0] = ((-1.0/6.0))*(cos_q2*z_42*c_8 - sin_q2*z_38 - z_31*z_39 - z_40*z_41);
    const real z_43 = l*sin_q3;
    const real z_44 = l - z_43;
    const real z_45 = cos_q3*cos_q5;
    const real z_46 = sin_q3*sin_q4;
    const real z_47 = l*z_46 - z_44;
    const real z_48 = -l*(z_45 - sin_q5*z_46) - z_47;
    const real z_49 = -z_47;
    const real z_50 = z_48*c_2 + z_49*c_1;
    const real z_51 = m*(2.0*z_48 + z_49);
    const real z_52 = l*(m*(3.0*z_48 + z_44 + 5.0*z_49) - sin_q5*z_51);
    const real z_53 = sin_q4*z_52;
    const real z_54 = l*(c_3 + z_44*c_4 + z_50) + z_53;
    const real z_55 = l*(cos_q4 - cos_q4*sin_q5);
    const real z_56 = c_3*cos_q4;
    const real z_57 = z_56 + z_55*c_6;
    const real z_58 = l*((z_55*c_2 + cos_q4*c_0) - sin_q5*z_57);
    const real z_59 = cos_q4*z_58;
    M1[1][1] = ((-1.0/6.0))*(sin_q3*z_54 + z_51*z_40 - l*(c_0 + z_44*c_1 + z_50) - z_59);
    const real z_60 = sin_q3*z_34;
    const real z_61 = z_32*z_40;
    M1[2][0] = (1.0/6.0)*(z_60 + z_31*z_11 + z_61 - z_6*z_36);
    const real z_62 = sin_q3*z_35;
    const real z_63 = m*z_55 + cos_q4*c_7;
    M1[2][1] = (1.0/6.0)*(z_22*z_58 + cos_q3*z_63*c_8 - z_57*z_62);
    const real z_64 = l*sin_q5;
    const real z_65 = l*sin_q4;
    const real z_66 = l + z_65;
    const real z_67 = z_66 - sin_q4*z_64;
    const real z_68 = z_67*c_2;
    const real z_69 = m*(2.0*z_67 + z_66);
    const real z_70 = l*((c_3 + z_68 + z_66*c_4) - sin_q5*z_69);
    const real c_11 = c[14];
    const real z_71 = cos_q5*cos_q5;
    const real z_72 = c_11*z_71;
    M1[2][2] = (1.0/6.0)*(l*(c_0 + z_68 + z_66*c_1) + sin_q4*z_70 + z_72);
    const real z_73 = cos_q4*z_33;
    const real z_74 = cos_q2*sin_q4;
    M1[3][0] = ((-1.0/6.0))*(cos_q3*z_73 - z_29*z_74 - z_6*z_38);
    M1[3][1] = ((-1.0/6.0))*(z_53 - sin_q3*z_59);
    const real c_5 = c[8];
    const real z_75 = c_5*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    M1[3][2] = ((-1.0/6.0))*(cos_q4*z_75);
    const real z_76 = l - z_64;
    const real z_77 = c_3 + z_76*c_6;
    M1[3][3] = (1.0/6.0)*(l*((c_0 + z_76*c_2) - sin_q5*z_77));
    const real z_78 = cos_q5*z_27;
    const real z_79 = sin_q3*z_32;
    const real z_80 = sin_q4*cos_q5;
    const real z_81 = cos_q3*z_80;
    M1[4][0] = (1.0/6.0)*(l*(z_7*z_78 + z_32*z_81 - sin_q5*z_79 - z_28*z_11));
    const real z_82 = cos_q4*cos_q5;
    const real z_83 = sin_q5*cos_q3;
    const real z_84 = sin_q3*z_80;
    M1[4][1] = ((-1.0/6.0))*(l*(z_51*z_82 + z_57*z_83 + z_57*z_84));
    M1[4][2] = ((-1.0/6.0))*(z_69*z_64 - sin_q4*z_72);
    M1[4][3] = em_real(0.0);
    const real c_23 = c[26];
    M1[4][4] = c_23;
    shared[0] = cos_q2;
    shared[1] = sin_q2;
    shared[2] = cos_q3;
    shared[3] = sin_q3;
    shared[4] = sin_q5;
    shared[5] = sin_q4;
    shared[6] = cos_q4;
    shared[7] = z_46;
    shared[8] = z_6;
    shared[9] = z_7;
    shared[10] = cos_q5;
    shared[11] = z_45;
    shared[12] = z_11;
    shared[13] = z_31;
    shared[14] = z_83;
    shared[15] = z_80;
    shared[16] = z_29;
    shared[17] = z_27;
    shared[18] = z_19;
    shared[19] = z_73;
    shared[20] = z_33;
    shared[21] = z_2;
    shared[22] = z_32;
    shared[23] = z_34;
    shared[24] = z_78;
    shared[25] = z_21;
    shared[26] = z_37;
    shared[27] = z_12;
    shared[28] = z_42;
    shared[29] = z_38;
    shared[30] = z_39;
    shared[31] = z_41;
    shared[32] = z_54;
    shared[33] = z_52;
    shared[34] = z_51;
    shared[35] = z_58;
    shared[36] = z_57;
    shared[37] = z_63;
    shared[38] = z_22;
    shared[39] = z_70;
    shared[40] = z_69;
    shared[41] = z_30;
    shared[42] = z_74;
    shared[43] = z_59;
    shared[44] = z_75;
    shared[45] = z_71;
    shared[46] = z_77;
    shared[47] = z_35;
    shared[48] = z_79;
    shared[49] = z_28;
    shared[50] = z_81;
    shared[51] = z_82;
    shared[52] = z_84;
    shared[53] = z_61;
    shared[54] = z_60;
    shared[55] = z_20;
    shared[56] = z_43;
    shared[57] = z_65;
    shared[58] = z_36;
    shared[59] = z_13;
    shared[60] = z_56;
    shared[61] = z_76;
    shared[62] = z_62;
    shared[63] = z_14;
    shared[64] = z_40;
    shared[65] = z_44;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[66], real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1],
                                 real gamma[N_ROWS])
{
    const real l = c[1];
    const real c_0 = c[3];
    const real q2_dot = v[1];
    const real cos_q2 = shared[0];
    const real z_85 = q2_dot*cos_q2;
    const real z_86 = l*z_85;
    const real sin_q2 = shared[1];
    const real q3_dot = v[2];
    const real cos_q3 = shared[2];
    const real z_87 = q3_dot*cos_q3;
    const real z_88 = sin_q2*z_87;
    const real sin_q3 = shared[3];
    const real z_89 = sin_q3*z_85;
    const real z_90 = z_86 - l*(z_88 + z_89);
    const real c_1 = c[4];
    const real sin_q5 = shared[4];
    const real q4_dot = v[3];
    const real sin_q4 = shared[5];
    const real z_91 = q4_dot*sin_q4;
    const real z_92 = cos_q2*z_91;
    const real cos_q4 = shared[6];
    const real z_93 = q2_dot*sin_q2;
    const real z_94 = cos_q4*z_93;
    const real z_46 = shared[7];
    const real z_95 = q4_dot*cos_q4;
    const real z_6 = shared[8];
    const real z_96 = (z_92 + z_94) + (z_85*z_46 + sin_q4*z_88 + z_95*z_6);
    const real z_7 = shared[9];
    const real q5_dot = v[4];
    const real cos_q5 = shared[10];
    const real z_97 = q5_dot*cos_q5;
    const real z_45 = shared[11];
    const real z_98 = q3_dot*sin_q3;
    const real z_99 = sin_q2*z_98;
    const real z_100 = cos_q5*z_99;
    const real z_101 = q5_dot*sin_q5;
    const real z_11 = shared[12];
    const real z_102 = z_45*z_85 - z_100 - z_101*z_11;
    const real z_103 = l*z_96 - z_90;
    const real z_104 = l*((sin_q5*z_96 - z_7*z_97) - z_102) - z_103;
    const real c_2 = c[5];
    const real z_105 = -z_103;
    const real z_106 = z_104*c_2 + z_105*c_1;
    const real z_107 = c_0*z_85 + z_90*c_1 + z_106;
    const real z_31 = shared[13];
    const real z_108 = cos_q5*z_87;
    const real z_109 = sin_q3*z_101;
    const real z_110 = z_108 - z_109;
    const real z_83 = shared[14];
    const real z_80 = shared[15];
    const real z_111 = q5_dot*z_80;
    const real z_112 = sin_q5*z_98;
    const real z_113 = cos_q3*z_95;
    const real z_114 = l*z_98 - l*(z_113 - sin_q4*z_98);
    const real z_115 = l*(z_110 + (z_95*z_83 + cos_q3*z_111 - sin_q4*z_112)) + z_114;
    const real z_116 = z_115*c_2;
    const real z_29 = shared[16];
    const real c_3 = c[6];
    const real c_4 = c[7];
    const real z_27 = shared[17];
    const real z_117 = z_27*z_97;
    const real m = c[0];
    const real z_118 = m*(2.0*z_115 + z_114);
    const real z_119 = sin_q5*z_118;
    const real z_120 = l*(c_3*z_98 + z_116 + z_114*c_4) + l*(z_117 - z_119);
    const real z_121 = l*(z_116 + z_114*c_1 + c_0*z_98) - (z_29*z_95 - sin_q4*z_120);
    const real z_19 = shared[18];
    const real z_73 = shared[19];
    const real z_33 = shared[20];
    const real z_2 = shared[21];
    const real z_32 = shared[22];
    const real z_122 = m*(2.0*z_104 + z_105);
    const real z_123 = l*(m*(3.0*z_104 + z_90 + 5.0*z_105)) + l*(z_32*z_97 - sin_q5*z_122);
    const real c_5 = c[8];
    const real z_34 = shared[23];
    const real z_124 = l*(c_3*z_85 + z_90*c_4 + z_106) - (z_33*z_95 - sin_q4*z_123);
    const real z_78 = shared[24];
    const real z_21 = shared[25];
    const real z_125 = z_32*z_45;
    const real z_37 = shared[26];
    const real z_12 = shared[27];
    Mdot1[0][0] = ((-1.0/6.0))*(l*z_107 + (z_31*z_98 + cos_q3*z_121) + l*(z_19*z_85 - sin_q2*z_107) + c_5*z_85 +
        l*(z_87*z_78 - z_27*z_109 - z_21*z_118) - (z_93*z_73 + z_33*z_92 + z_2*z_123) - (z_34*z_89 + z_34*z_88 -
        z_124*z_6) - l*(z_85*z_125 - z_32*z_100 - z_101*z_37 - z_12*z_122));
    const real z_42 = shared[28];
    const real c_6 = c[9];
    const real c_7 = c[10];
    const real z_126 = sin_q2*z_91;
    const real z_38 = shared[29];
    const real z_127 = cos_q4*sin_q2;
    const real z_128 = q2_dot*z_6;
    const real z_39 = shared[30];
    const real z_129 = q2_dot*z_11;
    const real z_130 = cos_q5*z_98;
    const real z_41 = shared[31];
    const real z_131 = cos_q3*z_101;
    Mdot1[0][1] = Mdot1[1][0] = (1.0/6.0)*(3.0*l*(z_42*z_93 + cos_q2*(m*z_115 + z_114*c_6 + c_7*z_98)) -
        (z_29*z_126 + z_127*z_120 - z_85*z_38) - (z_31*z_128 + z_121*z_39 - cos_q2*z_31*z_87) - l*(z_78*z_129 +
        z_130*z_41 + z_131*z_41 + z_45*(cos_q2*z_118)));
    const real z_54 = shared[32];
    const real z_132 = z_130 + z_131;
    const real z_133 = sin_q3*z_111;
    const real z_134 = sin_q5*z_87;
    const real z_135 = sin_q3*z_95;
    const real z_136 = l*z_87;
    const real z_137 = z_136 + l*(z_135 + sin_q4*z_87);
    const real z_138 = z_137 - l*(z_132 + (z_133 + sin_q4*z_134 + sin_q5*z_135));
    const real z_139 = z_138*c_2;
    const real z_52 = shared[33];
    const real z_51 = shared[34];
    const real z_140 = m*(2.0*z_138 + z_137);
    const real z_141 = z_52*z_95 - sin_q4*(l*(c_3*z_87 + z_139 + z_137*c_4) + l*(z_51*z_97 - sin_q5*z_140));
    const real z_58 = shared[35];
    const real z_142 = l*z_91 - l*(sin_q5*z_91 - cos_q4*z_97);
    const real z_57 = shared[36];
    const real z_143 = c_3*z_91 + z_142*c_6;
    const real z_144 = l*(z_142*c_2 + c_0*z_91) + l*(z_57*z_97 - sin_q5*z_143);
    const real z_145 = cos_q4*z_144;
    const real c_8 = c[11];
    Mdot1[1][1] = ((-1.0/6.0))*((z_54*z_87 - sin_q3*(l*(z_139 + c_0*z_87 + z_137*c_1) - z_141)) + (z_58*z_91 +
        z_145) + (m*z_138 + c_7*z_87 + z_137*c_6)*c_8 - l*(z_51*z_130 + z_51*z_131 + z_45*z_140));
    const real z_146 = cos_q3*z_85;
    Mdot1[0][2] = Mdot1[2][0] = (1.0/6.0)*((z_34*z_87 - sin_q3*z_124) + (z_31*z_146 - z_31*z_99 - z_121*z_11) -
        l*(z_32*z_130 + z_32*z_131 + z_45*z_122) - l*(z_89*z_78 + z_88*z_78 - z_101*(z_27*z_6) -
        cos_q5*(z_118*z_6)));
    const real z_63 = shared[37];
    const real z_147 = sin_q4*z_58;
    const real z_22 = shared[38];
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/6.0))*(3.0*l*(z_63*z_98 + cos_q3*(m*z_142 + c_7*z_91)) + l*(z_57*z_108 -
        z_57*z_109 - z_21*z_143) - (z_58*z_113 - z_98*z_147 - z_22*z_144));
    const real z_70 = shared[39];
    const real z_148 = l*z_95 - l*(z_111 + sin_q5*z_95);
    const real z_69 = shared[40];
    const real z_149 = l*(z_69*z_97 + sin_q5*(c_3*z_95 + z_148*c_6));
    const real c_9 = c[12];
    const real z_150 = cos_q5*c_9;
    Mdot1[2][2] = (1.0/6.0)*((z_70*z_95 + sin_q4*(l*(z_148*c_2 + c_0*z_95) - z_149)) + (m*z_148 + c_7*z_95)*c_8 -
        z_101*z_150);
    const real z_30 = shared[41];
    const real z_151 = cos_q2*z_95;
    const real z_74 = shared[42];
    Mdot1[0][3] = Mdot1[3][0] = (1.0/6.0)*((cos_q3*z_33*z_91 + z_98*z_73 + cos_q4*cos_q3*z_123) - (z_30*z_93 +
        z_120*z_74 - z_29*z_151) - (z_29*z_6*z_91 + cos_q4*z_120*z_6 - z_89*z_38 - z_88*z_38));
    const real z_152 = sin_q3*z_58;
    const real z_59 = shared[43];
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/6.0))*(z_141 + (z_91*z_152 + sin_q3*z_145 - z_59*z_87));
    const real z_75 = shared[44];
    const real z_71 = shared[45];
    const real c_10 = c[13];
    Mdot1[2][3] = Mdot1[3][2] = (1.0/6.0)*(z_75*z_91 + cos_q4*(2.0*c_5*(q5_dot*z_71 - q5_dot*(sin_q5*sin_q5)) +
        c_10*z_101));
    const real z_77 = shared[46];
    const real z_35 = shared[47];
    const real z_153 = q5_dot*z_35;
    const real c_11 = c[14];
    Mdot1[3][3] = ((-1.0/6.0))*(c_10*z_97 - (cos_q5*c_11*z_101 - z_77*z_153));
    const real z_79 = shared[48];
    const real z_154 = sin_q3*sin_q5;
    const real z_155 = z_85*z_83;
    const real z_28 = shared[49];
    const real z_156 = z_98*z_80;
    const real z_81 = shared[50];
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(l*(z_96*z_78 + z_101*(z_7*z_27) + cos_q5*(z_7*z_118)) +
        l*(z_32*z_134 + z_97*z_79 - z_154*z_122) + l*(z_27*z_155 + z_117*z_11 - z_28*z_99 - z_119*z_11) -
        l*(z_95*z_125 - z_32*z_156 - z_101*(z_22*z_32) - z_81*z_122));
    const real z_157 = q4_dot*z_80;
    const real z_82 = shared[51];
    const real z_84 = shared[52];
    Mdot1[1][4] = Mdot1[4][1] = (1.0/6.0)*(l*(z_51*z_157 + z_101*(cos_q4*z_51) + z_140*z_82) -
        l*(z_97*(cos_q3*z_57) - z_57*z_112 - z_143*z_83) - l*(z_57*z_87*z_80 + cos_q5*(z_57*z_135) -
        z_101*(z_57*z_46) - z_143*z_84));
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/6.0))*(z_149 - 2.0*c_5*(z_71*z_95 - 2.0*z_101*z_80));
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real c_12 = c[15];
    const real c_13 = c[16];
    const real z_158 = c_13 - sin_q5*c_12;
    const real q1_dot = v[0];
    const real z_159 = q1_dot*z_29;
    const real z_160 = q1_dot*z_31;
    const real z_161 = q2_dot*cos_q4;
    const real z_61 = shared[53];
    const real z_162 = q1_dot*q1_dot;
    const real z_60 = shared[54];
    const real z_20 = shared[55];
    const real z_43 = shared[56];
    const real z_163 = q1_dot*cos_q3;
    const real z_164 = 2.0*q1_dot*z_98 + z_162*z_6;
    const real z_165 = 2.0*z_95*z_163 + z_2*z_162 - sin_q4*z_164;
    const real z_166 = l*z_165;
    const real z_167 = sin_q2*z_162;
    const real z_168 = l*(-(z_162 - z_167));
    const real c_14 = c[17];
    const real z_169 = z_164*c_14 - z_166 - 6.0*z_168;
    const real z_170 = l*(2.0*z_111*z_163 + 2.0*q1_dot*z_108 + z_12*z_162 + sin_q5*z_165 - 2.0*q1_dot*z_109);
    const real c_15 = c[18];
    const real z_171 = z_170 + z_164*c_15 - 6.0*z_168 - z_165*c_14;
    const real z_172 = 2.0*z_170 + z_164*c_8 - 3.0*z_168 - z_165*c_8;
    const real z_173 = z_171 + z_172;
    const real z_174 = m*(z_169 + z_173);
    const real z_175 = c_3*z_172;
    const real z_176 = c_3*sin_q5;
    const real c_16 = c[19];
    const real z_177 = c_16*(q1_dot*z_27);
    const real z_178 = z_172*z_176 + z_97*z_177 - l*(m*z_173);
    const real z_179 = q1_dot*q2_dot;
    const real c_17 = c[20];
    const real c_18 = c[21];
    const real c_19 = c[22];
    f1[1] = (1.0/12.0)*(cos_q2*(6.0*cos_q4*z_158 + 2.0*z_135*z_159 + 2.0*z_87*z_160 + 2.0*z_159*z_161 + z_61*z_162
        + z_60*z_162 + z_43*z_174 + z_45*z_175 - z_20*z_162 - l*(m*z_171 + m*z_169 + (c_3*z_162 + m*(l*z_164 -
        5.0*z_168)) + m*z_172) - z_178*z_46 - z_131*z_177 - z_130*z_177) - sin_q2*(6.0*z_158*z_46 + 2.0*z_91*z_159
        + 2.0*sin_q3*z_31*z_179 + cos_q4*z_178 + c_17 + sin_q3*c_18 + z_45*c_19 + q2_dot*z_45*z_177 - z_162*z_73 -
        z_42*c_15*z_179));
    const real z_180 = q2_dot*q3_dot;
    const real z_181 = q2_dot*q2_dot;
    const real z_182 = z_51*z_181;
    const real z_183 = q2_dot*q4_dot;
    const real z_184 = sin_q3*z_181;
    const real z_185 = 2.0*z_183 + z_184;
    const real z_186 = sin_q4*z_185;
    const real z_187 = l*(2.0*z_97*z_161 + z_45*z_181 - sin_q5*z_186);
    const real z_188 = c_8*z_181 - 2.0*z_187 - z_186*c_8 - z_184*c_8;
    const real z_189 = c_3*z_188;
    const real z_190 = q1_dot*z_95;
    const real z_191 = q3_dot*sin_q2;
    const real z_192 = 2.0*q1_dot*z_88 + 2.0*q1_dot*z_89 + cos_q3*z_162;
    const real z_193 = 2.0*z_6*z_190 + 2.0*q1_dot*z_92 + 2.0*q1_dot*z_94 + sin_q4*z_192;
    const real z_194 = q1_dot*z_85;
    const real z_65 = shared[57];
    const real z_195 = l*(2.0*z_101*(q1_dot*z_11) + 2.0*q1_dot*z_100 + z_21*z_162 + sin_q5*z_193 -
        2.0*z_97*(q1_dot*z_7) - 2.0*z_45*z_194);
    const real c_20 = c[23];
    const real z_196 = 2.0*z_195 + z_194*c_15 - z_193*c_8 - z_192*c_8;
    const real z_197 = m*((z_195 + z_194*c_20 - z_193*c_14 - z_192*c_15) + z_196);
    const real z_198 = sin_q4*z_176;
    const real z_199 = c_16*(q2_dot*z_57);
    const real z_200 = c_16*(q1_dot*z_32);
    const real z_201 = q3_dot*cos_q5;
    const real z_202 = cos_q5*z_177;
    const real z_203 = (c_15*z_181 - z_187 - z_186*c_14 - z_184*c_15) + z_188;
    const real z_204 = m*z_203;
    const real z_205 = sin_q2*z_95;
    const real z_36 = shared[58];
    const real z_206 = c_3*z_196;
    const real z_13 = shared[59];
    f1[2] = ((-1.0/12.0))*(sin_q3*(2.0*z_180*z_147 + 2.0*z_191*z_160 + z_32*z_167*z_35 + z_31*z_162 + z_196*z_198
        + sin_q2*cos_q5*z_175 + c_19*(cos_q2*cos_q5) + c_15*(z_63*z_180) + z_111*z_200 + z_200*z_201 + z_85*z_202
        - z_35*z_182 - cos_q5*z_189 - 2.0*z_33*z_190 - c_3*(l*(-(5.0*z_192 + z_193 - 12.0*z_194))) - z_65*z_197 -
        l*z_197 - z_101*z_199 - sin_q2*z_101*z_177) - cos_q3*(6.0*z_158*z_74 + 2.0*q2_dot*z_58*z_95 + z_188*z_198
        + 2.0*z_159*z_205 + 2.0*q1_dot*q3_dot*z_34 + 2.0*z_31*z_194 + z_34*z_167 + cos_q5*z_206 + z_13*z_174 +
        cos_q2*c_18 - z_54*z_181 - z_65*z_204 - l*(m*(l*(6.0*z_181 - 5.0*z_184 - z_186) + z_203)) - z_162*z_36 -
        sin_q2*sin_q4*z_178 - z_111*z_199 - z_199*z_201 - z_101*z_200 - z_191*z_202));
    const real z_207 = q3_dot*q3_dot;
    const real z_208 = z_207;
    const real z_209 = sin_q4*z_207;
    const real z_210 = q3_dot*q5_dot;
    const real z_211 = 2.0*z_210 + z_209;
    const real z_212 = sin_q5*z_211;
    const real z_213 = l*(-(3.0*z_208 + 3.0*z_209 - 2.0*z_212));
    const real z_214 = q2_dot*z_87;
    const real z_215 = q4_dot*z_159;
    const real z_216 = l*cos_q3;
    const real z_217 = sin_q3*z_97;
    const real z_218 = 2.0*q2_dot*z_135 + 2.0*sin_q4*z_214 + cos_q4*z_181;
    const real z_219 = l*(2.0*q2_dot*z_133 + 2.0*q2_dot*z_131 + 2.0*q2_dot*z_130 + sin_q5*z_218);
    const real z_220 = c_15*z_214 + z_218*c_8 - 2.0*z_219;
    f1[3] = (1.0/12.0)*(cos_q4*(6.0*z_158*z_39 + z_70*z_207 + z_213*z_176 + 2.0*z_58*z_214 + sin_q3*z_188*z_176 +
        2.0*cos_q2*z_215 + z_33*z_164 + z_29*z_192 + z_83*z_206 + z_210*c_9*z_71 + cos_q3*z_97*z_200 -
        l*(m*(l*(-(6.0*z_208 + 5.0*z_209 - z_212)) + z_213)) - z_52*z_185 - z_43*z_204 - z_216*z_197 - z_178*z_6 -
        z_217*z_199) + sin_q4*(2.0*q3_dot*q4_dot*z_75 + z_220*z_176 + 2.0*q4_dot*z_33*z_163 + cos_q2*z_33*z_162 +
        c_16*z_97*(q2_dot*z_51) - 6.0*sin_q2*z_158 - 2.0*z_183*z_152 - z_58*z_181 - c_3*(c_20*z_214 + z_218*c_14 -
        z_219) - c_3*z_220 - 2.0*z_6*z_215 - 2.0*z_93*z_159 - cos_q2*z_178));
    const real z_221 = cos_q2*cos_q3;
    const real c_21 = c[24];
    const real z_222 = q3_dot*z_95;
    const real c_22 = c[25];
    const real z_223 = q5_dot*z_199;
    const real z_224 = q5_dot*z_200;
    const real z_225 = q5_dot*z_177;
    const real z_226 = q4_dot*q4_dot;
    const real z_56 = shared[60];
    const real z_227 = z_127 + cos_q2*z_46;
    f1[4] = ((-1.0/12.0))*(sin_q5*(l*z_162*z_37 + sin_q3*z_206 + z_11*z_175 + c_19*z_221 + c_21*(q3_dot*z_111) +
        c_9*(sin_q5*z_222) + z_207*z_150 + z_22*z_224 + z_7*z_225 + z_87*z_200 + z_177*z_146 - z_216*z_182 -
        cos_q3*z_189 - z_27*z_43*z_162 - c_22*z_222 - z_46*z_223 - q5_dot*c_16*(z_51*z_161) - z_98*z_199 -
        z_99*z_177) + cos_q5*(z_77*(l*z_226) + l*z_69*z_211 + z_57*(l*z_218) + z_56*z_220 + z_27*(l*z_193) +
        z_227*c_19 + cos_q3*z_223 + z_11*z_225 + sin_q3*z_224 - c_3*(l*(-(3.0*z_226 - 2.0*sin_q5*z_226))) -
        c_3*sin_q4*z_213 - z_51*(z_65*z_185) - z_46*z_189 - z_32*z_166 - z_22*z_206 - z_7*z_175 - z_222*z_150));
    const real z_76 = shared[61];
    const real z_228 = sin_q4*z_76;
    const real z_229 = l + z_228;
    const real z_62 = shared[62];
    const real z_230 = cos_q3*z_229 - z_62;
    const real q1 = x[0];
    const real cos_q1 = em_cos(q1);
    const real z_14 = shared[63];
    const real z_232 = z_2*z_76;
    const real z_233 = z_14 + z_229*z_6 + z_35*z_11 - z_232;
    const real sin_q1 = em_sin(q1);
    A1[0][0] = z_230*cos_q1 - z_233*sin_q1;
    const real z_235 = sin_q3*z_229;
    const real z_40 = shared[64];
    const real z_236 = l*cos_q1 - cos_q1*z_235 - cos_q1*z_40;
    const real z_237 = cos_q4*z_76;
    const real z_238 = sin_q2*cos_q1;
    A1[0][1] = -(cos_q2*z_236 - z_237*z_238);
    const real z_239 = z_229*sin_q1 + z_35*z_238;
    const real z_240 = sin_q1*z_35 - z_229*z_238;
    A1[0][2] = -(sin_q3*z_239 + cos_q3*z_240);
    const real z_241 = cos_q3*sin_q1;
    const real z_242 = z_241 + cos_q1*z_6;
    const real z_243 = z_76*z_74;
    A1[0][3] = z_242*z_237 + cos_q1*z_243;
    const real z_244 = sin_q3*sin_q1;
    const real z_245 = z_244 - cos_q1*z_11;
    const real z_246 = sin_q4*z_242 - z_2*cos_q1;
    A1[0][4] = l*(sin_q5*z_245 - cos_q5*z_246);
    A1[1][0] = em_real(0.0);
    const real z_44 = shared[65];
    const real z_247 = z_44 - z_40 - z_76*z_46;
    A1[1][1] = -(z_232 + sin_q2*z_247);
    const real z_248 = l*cos_q2 + z_243;
    A1[1][2] = -(cos_q3*z_248 - z_35*z_39);
    A1[1][3] = sin_q2*z_228 - sin_q3*z_232;
    A1[1][4] = l*(cos_q5*z_227 + cos_q2*z_83);
    A1[2][0] = -(z_230*sin_q1 + cos_q1*z_233);
    const real z_249 = l*sin_q1 - sin_q1*z_235 - sin_q1*z_40;
    const real z_250 = sin_q2*sin_q1;
    A1[2][1] = cos_q2*z_249 - z_250*z_237;
    const real z_251 = z_229*cos_q1;
    const real z_252 = z_251 - z_35*z_250;
    const real z_253 = cos_q1*z_35 + z_229*z_250;
    A1[2][2] = -(sin_q3*z_252 + cos_q3*z_253);
    const real z_254 = cos_q3*cos_q1 - sin_q1*z_6;
    A1[2][3] = z_254*z_237 - sin_q1*z_243;
    const real z_255 = sin_q3*cos_q1;
    const real z_256 = z_255 + sin_q1*z_11;
    const real z_257 = sin_q4*z_254 + z_2*sin_q1;
    A1[2][4] = l*(sin_q5*z_256 - cos_q5*z_257);
    const real z_258 = sin_q5*z_11 + z_80*z_6 - z_2*cos_q5;
    const real z_259 = z_154 - z_81;
    A1[3][0] = cos_q1*z_258 - sin_q1*z_259;
    const real z_260 = sin_q1*z_83 + sin_q1*z_84;
    A1[3][1] = cos_q2*z_260 + z_250*z_82;
    const real z_261 = sin_q5*cos_q1 + z_80*z_250;
    const real z_262 = sin_q5*z_250 - cos_q1*z_80;
    A1[3][2] = cos_q3*z_261 - sin_q3*z_262;
    const real z_263 = cos_q2*z_80;
    A1[3][3] = -(z_254*z_82 - sin_q1*z_263);
    A1[3][4] = sin_q5*z_257 + cos_q5*z_256;
    const real z_264 = sin_q4*z_153;
    const real z_265 = z_76*z_95 - z_264;
    const real z_266 = (z_229*z_98 - cos_q3*z_265) + l*z_110;
    const real z_267 = q1_dot*sin_q1;
    const real z_268 = z_2*z_153;
    const real z_269 = z_93*z_237 + z_76*z_92 + z_268;
    const real z_270 = z_86 - (z_229*z_89 + z_229*z_88 + z_265*z_6) - z_269 - l*z_102;
    const real z_271 = q1_dot*cos_q1;
    const real z_272 = z_76*z_91;
    const real z_273 = cos_q1*z_85;
    const real z_274 = cos_q4*z_153;
    const real z_275 = q1_dot*z_250;
    const real z_276 = sin_q1*z_101;
    const real z_277 = (cos_q3*z_271 - sin_q1*z_98) + (cos_q1*z_89 + cos_q1*z_88 - z_6*z_267);
    const real z_278 = z_228*z_93;
    const real z_279 = z_76*z_151;
    const real z_280 = z_153*z_74;
    const real z_281 = sin_q1*z_87;
    gamma[0] = -(q1_dot*((cos_q1*z_266 + z_230*z_267) - (sin_q1*z_270 - z_233*z_271)) + q3_dot*((z_239*z_87 +
        sin_q3*((sin_q1*z_265 + z_229*z_271) + l*(cos_q5*z_273 - z_101*z_238 - cos_q5*z_275))) - (z_240*z_98 +
        cos_q3*(l*(z_276 - cos_q5*z_271) + (z_229*z_273 + z_265*z_238 - z_229*z_275)))) + q4_dot*((z_242*z_272 +
        z_242*z_274 - z_277*z_237) + (cos_q1*z_278 + cos_q1*z_280 + z_243*z_267 - cos_q1*z_279)) -
        q2_dot*((z_236*z_93 + cos_q2*(l*z_267 + (z_251*z_87 + z_255*z_265 - z_267*z_235) - l*(cos_q1*z_130 +
        cos_q1*z_131 + z_45*z_267))) - (z_238*z_272 + z_274*z_238 + z_237*z_275 - z_237*z_273)) -
        q5_dot*(l*(z_245*z_97 + sin_q5*((sin_q3*z_271 + z_281) + (z_11*z_267 + cos_q1*z_99 - cos_q3*z_273))) +
        l*(z_246*z_101 - cos_q5*((z_242*z_95 + sin_q4*z_277) + (z_2*z_267 + cos_q1*z_94 + cos_q1*z_92)))));
    gamma[1] = q2_dot*(z_269 - (z_247*z_85 - sin_q2*(z_136 + (z_228*z_87 + z_76*z_135 - z_153*z_46) - l*z_132))) +
        q3_dot*((z_248*z_98 + cos_q3*(l*z_93 + (z_278 + z_280 - z_279))) - l*(cos_q5*z_128 + z_101*z_39 -
        cos_q2*z_108)) + q4_dot*((z_228*z_85 + z_76*z_205 - sin_q2*z_264) + (z_237*z_128 + z_39*z_272 +
        sin_q3*z_268 - z_232*z_87)) - q5_dot*(l*(z_227*z_101 - cos_q5*((cos_q4*z_85 - z_126) + (z_87*z_74 +
        cos_q2*z_135 - sin_q4*z_128))) + l*(sin_q5*z_129 + cos_q2*z_112 - z_97*z_221));
    const real z_282 = sin_q1*z_85;
    const real z_283 = sin_q2*z_271;
    const real z_284 = (cos_q3*z_267 + cos_q1*z_98) + (z_6*z_271 + sin_q1*z_89 + z_87*z_250);
    const real z_285 = q2_dot*z_250;
    const real z_286 = (cos_q1*z_87 - sin_q3*z_267) + (z_11*z_271 + cos_q3*z_282 - z_98*z_250);
    const real z_287 = (z_254*z_95 - sin_q4*z_284) - (z_250*z_161 + sin_q1*z_92 - z_2*z_271);
    gamma[2] = q1_dot*((sin_q1*z_266 - z_230*z_271) + (z_233*z_267 + cos_q1*z_270)) + q5_dot*(l*(z_256*z_97 +
        sin_q5*z_286) + l*(z_257*z_101 - cos_q5*z_287)) - q2_dot*((z_249*z_93 - cos_q2*(l*z_271 + l*(sin_q1*z_130
        + sin_q1*z_131 - z_45*z_271) - (z_229*z_281 + z_244*z_265 + z_271*z_235))) - (z_250*z_272 + z_274*z_250 -
        z_237*z_282 - z_237*z_283)) - q3_dot*((z_252*z_87 + sin_q3*((cos_q1*z_265 - z_229*z_267) - l*(cos_q5*z_282
        + cos_q5*z_283 - z_101*z_250))) - (z_253*z_98 + cos_q3*(l*(cos_q1*z_101 + cos_q5*z_267) - (z_229*z_282 +
        z_265*z_250 + z_229*z_283)))) - q4_dot*((z_254*z_272 + z_254*z_274 + z_284*z_237) - (z_228*z_285 +
        sin_q1*z_280 - sin_q1*z_279 - z_243*z_271));
    const real z_288 = cos_q5*z_95;
    const real z_289 = sin_q4*z_101;
    const real z_290 = cos_q5*sin_q1;
    const real z_291 = cos_q4*z_101;
    gamma[3] = -(q1_dot*((z_258*z_267 - cos_q1*((z_155 + z_11*z_97 - sin_q5*z_99) + (z_93*z_82 + cos_q2*z_157 +
        z_2*z_101) + (z_89*z_80 + z_88*z_80 + z_6*z_288 - z_6*z_289))) + (z_259*z_271 + sin_q1*((z_134 + z_217) -
        (z_45*z_95 - z_156 - z_22*z_101)))) + q2_dot*((z_260*z_93 - cos_q2*((z_241*z_97 + z_271*z_83 -
        sin_q1*z_112) + (z_281*z_80 + z_135*z_290 + z_271*z_84 - z_276*z_46))) + (z_250*z_157 + z_250*z_291 -
        z_82*z_282 - z_82*z_283)) + q3_dot*((z_261*z_98 - cos_q3*((cos_q1*z_97 - sin_q5*z_267) + (z_80*z_282 +
        z_250*z_288 + z_80*z_283 - z_250*z_289))) + (z_262*z_87 + sin_q3*((sin_q5*z_282 + z_97*z_250 +
        sin_q5*z_283) - (cos_q1*z_288 - cos_q1*z_289 - z_80*z_267)))) - q4_dot*((z_254*z_157 + z_254*z_291 +
        z_284*z_82) - (z_80*z_285 + z_276*z_74 - z_151*z_290 - z_271*z_263)) - q5_dot*((z_257*z_97 + sin_q5*z_287)
        - (z_256*z_101 - cos_q5*z_286)));
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    (void)t, (void)c, (void)u, (void)flags, (void)fault;
    real M1[N1][N1], shared[66];
    triangular_masses(y, c, M1, shared);

    /* q1, q2, q3, q4, q5: M = L L^T */
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

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    triangular_motion(y, dy, c, shared, Mdot1, f1, A1, gamma);

    /* q1, q2, q3, q4, q5: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* q1, q2, q3, q4, q5: B = A L^-T */
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
    dy[5] = a1[0];
    dy[6] = a1[1];
    dy[7] = a1[2];
    dy[8] = a1[3];
    dy[9] = a1[4];
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

extern em_lanes bricard_lanes;
em_lanes bricard_lanes = {EM_LANES, rhs_on_lanes, velocity_on_lanes, NULL};

#else

/* What no step calls. As it stands this file holds all; compilers may work side by side on this part alone, with
 * -DEM_ASIDE_ALONE, and on the others, with -DEM_ASIDE_ELSEWHERE. */
#ifdef EM_ASIDE_ELSEWHERE

extern void mass_matrix_gradient(EM_UNUSED double t, const double *restrict x, const double *restrict c,
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
    const double l = c[1];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double c_0 = c[3];
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_2 = cos_q2*sin_q3;
    const double z_3 = cos_q2 - z_2;
    const double z_4 = l*z_3;
    const double c_1 = c[4];
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double q4 = x[3];
    const double cos_q4 = em_cos(q4);
    const double sin_q2 = em_sin(q2);
    const double z_8 = cos_q4*sin_q2;
    const double sin_q4 = em_sin(q4);
    const double z_10 = z_8 + sin_q4*z_2;
    const double cos_q3 = em_cos(q3);
    const double cos_q5 = em_cos(q5);
    const double z_13 = cos_q3*cos_q5;
    const double z_14 = cos_q2*z_13;
    const double z_15 = z_10 - z_3;
    const double z_16 = l*((sin_q5*z_10 - z_14) - z_15);
    const double c_2 = c[5];
    const double z_17 = l*(-z_15);
    const double z_18 = z_16*c_2 + z_17*c_1;
    const double z_19 = cos_q2*c_0 + z_4*c_1 + z_18;
    const double c_3 = c[6];
    const double z_20 = cos_q2*cos_q4;
    const double z_21 = sin_q2*sin_q3;
    const double z_22 = z_20 - sin_q4*z_21;
    const double z_23 = sin_q2*z_13;
    const double z_24 = l - l*sin_q2;
    const double z_25 = l*z_21 + z_24;
    const double z_26 = l*z_22 - z_25;
    const double z_27 = l*(z_22*sin_q5 + z_23) - z_26;
    const double c_4 = c[7];
    const double z_28 = -z_26;
    const double m = c[0];
    const double z_29 = m*(2.0*z_27 + z_28);
    const double z_30 = l*(m*(3.0*z_27 + z_25 + 5.0*z_28) - sin_q5*z_29);
    const double z_31 = m*(2.0*z_16 + z_17);
    const double z_32 = l*(m*(3.0*z_16 + z_4 + 5.0*z_17) - sin_q5*z_31);
    const double c_5 = c[8];
    const double z_33 = l*(m*(3.0*z_27 + z_24 + 5.0*z_25 + 6.0*z_28)) + sin_q4*z_30;
    const double z_34 = l*(c_3*cos_q2 + z_4*c_4 + z_18) + sin_q4*z_32;
    dM[25] = ((-1.0/6.0))*(l*z_19 + l*(cos_q2*(c_3 + z_27*c_2 + z_24*c_4 + z_25*c_1 + z_28*c_1) - sin_q2*z_19) +
        cos_q2*c_5 - (z_30*z_8 + z_20*z_32) - (z_33*z_2 - z_34*z_21) - l*(z_29*z_14 - z_23*z_31));
    const double z_35 = sin_q3*cos_q5;
    const double z_36 = sin_q4*cos_q3;
    const double z_37 = cos_q3 + z_36;
    const double z_38 = l*(z_37 - (z_35 + sin_q5*z_36));
    const double z_39 = z_38*c_2;
    const double z_40 = l*z_37;
    const double z_41 = m*(2.0*z_38 + z_40);
    const double z_42 = sin_q5*z_41;
    const double z_43 = l*((c_3*cos_q3 + z_39 + z_40*c_4) - z_42);
    const double z_44 = z_20*z_43;
    const double z_45 = sin_q4*z_43;
    const double z_46 = l*(z_39 + z_40*c_1 + cos_q3*c_0) + z_45;
    const double z_47 = z_46*z_21;
    const double z_48 = l*z_13;
    const double z_49 = sin_q2*z_48;
    const double z_50 = z_41*z_49;
    const double c_6 = c[9];
    const double c_7 = c[10];
    const double z_51 = m*z_38 + z_40*c_6 + cos_q3*c_7;
    const double c_8 = c[11];
    const double z_52 = sin_q2*c_8;
    dM[30] = dM[26] = (1.0/6.0)*(z_44 + z_51*z_52 - z_47 - z_50);
    const double z_53 = cos_q2*cos_q3*z_46;
    const double z_54 = l*z_35;
    const double z_55 = cos_q2*z_41;
    dM[35] = dM[27] = ((-1.0/6.0))*(sin_q3*z_34 + z_31*z_48 + z_54*z_55 - z_53);
    const double z_56 = cos_q4*cos_q3;
    const double z_57 = sin_q2*z_45;
    const double z_58 = cos_q4*sin_q3;
    dM[40] = dM[28] = (1.0/6.0)*(z_56*z_32 + cos_q2*z_43*z_58 - z_57);
    const double z_59 = cos_q5*z_41;
    const double z_60 = sin_q3*sin_q5;
    const double z_61 = sin_q5*cos_q3;
    const double z_62 = sin_q4*z_13;
    dM[45] = dM[29] = ((-1.0/6.0))*(l*(z_10*z_59 + z_61*z_55 + z_62*z_31 - z_60*z_31));
    const double z_63 = sin_q3*z_46;
    const double z_64 = z_13 - sin_q4*z_60;
    const double z_65 = sin_q3*sin_q4;
    const double z_66 = sin_q3 + z_65;
    const double z_67 = l*(z_64 + z_66);
    const double z_68 = z_67*c_2;
    const double z_69 = l*z_66;
    const double z_70 = m*(2.0*z_67 + z_69);
    const double z_71 = l*((c_3*sin_q3 + z_68 + z_69*c_4) - sin_q5*z_70);
    const double z_72 = l*(z_68 + z_69*c_1 + sin_q3*c_0) + sin_q4*z_71;
    const double z_73 = sin_q2*cos_q3;
    const double z_74 = sin_q2*z_35;
    const double z_75 = sin_q4*z_73;
    const double z_76 = z_73 + z_75;
    const double z_77 = l*(z_76 - (z_74 + sin_q5*z_75));
    const double z_78 = z_77*c_2;
    const double z_79 = l*z_76;
    const double z_80 = m*(2.0*z_77 + z_79);
    const double z_81 = l*((c_3*z_73 + z_78 + z_79*c_4) - sin_q5*z_80);
    const double z_82 = l*(z_78 + c_0*z_73 + z_79*c_1) + sin_q4*z_81;
    const double z_83 = z_41*z_13;
    const double z_84 = m*z_77 + z_73*c_7 + z_79*c_6;
    dM[50] = (1.0/6.0)*((z_33*z_73 + z_82*z_21) + z_84*c_8 - (z_63 + cos_q3*z_72) - z_20*z_81 - l*(z_83 -
        z_35*z_70) - l*(z_29*z_74 - z_23*z_80) - z_84*z_52);
    const double z_85 = cos_q2*c_8;
    dM[55] = dM[51] = (1.0/6.0)*((z_53 - z_2*z_72) + (m*z_67 + z_69*c_6 + sin_q3*c_7)*z_85 - z_8*z_71 -
        l*(z_35*z_55 + z_14*z_70));
    const double z_86 = l*sin_q3;
    const double z_87 = l - z_86;
    const double z_88 = sin_q4*z_86 - z_87;
    const double z_89 = -l*z_64 - z_88;
    const double z_90 = -z_88;
    const double z_91 = m*(2.0*z_89 + z_90);
    const double z_92 = l*(m*(3.0*z_89 + z_87 + 5.0*z_90) - sin_q5*z_91);
    dM[56] = ((-1.0/6.0))*(z_51*c_8 - (z_63 - cos_q3*(l*(c_3 + z_89*c_2 + z_87*c_4 + z_90*c_1) + sin_q4*z_92)) -
        l*(z_83 + z_35*z_91));
    dM[60] = dM[52] = (1.0/6.0)*((cos_q3*z_33 + sin_q3*z_82) - (z_47 + z_73*z_72) - l*(z_35*z_29 - z_13*z_80) -
        l*(z_23*z_41 - z_74*z_70));
    const double z_93 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_94 = c_3*cos_q4 + z_93*c_6;
    const double z_95 = l*((z_93*c_2 + cos_q4*c_0) - sin_q5*z_94);
    const double z_96 = z_65*z_95;
    const double z_97 = z_94*z_48;
    const double z_98 = (m*z_93 + cos_q4*c_7)*c_8;
    dM[61] = dM[57] = ((-1.0/6.0))*(z_96 + z_97 + sin_q3*z_98);
    const double z_99 = cos_q2*sin_q4;
    const double z_100 = cos_q4*z_43;
    const double z_101 = sin_q2*z_58;
    dM[65] = dM[53] = (1.0/6.0)*((z_30*z_58 - z_56*z_81) + (z_73*z_100 - z_101*z_71) - z_99*z_71);
    const double z_102 = z_95*z_56;
    dM[66] = dM[58] = (1.0/6.0)*(z_45 + z_102);
    const double z_103 = z_22*cos_q5;
    const double z_104 = sin_q5*z_73;
    const double z_105 = sin_q4*z_35;
    dM[70] = dM[54] = ((-1.0/6.0))*(l*(sin_q2*z_41*z_62 + z_70*z_103) + l*(z_29*z_61 + z_60*z_80) + l*(z_29*z_105
        - z_62*z_80) - l*(z_42*z_21 + z_104*z_70));
    const double z_106 = cos_q4*cos_q5;
    dM[71] = dM[59] = (1.0/6.0)*(l*(z_41*z_106 + z_94*z_60 - z_94*z_62));
    const double z_107 = l*(-(z_56 - sin_q5*z_56));
    const double z_108 = z_107*c_6 - c_3*z_56;
    const double z_109 = l*((z_107*c_2 - c_0*z_56) - sin_q5*z_108);
    const double z_110 = m*z_107 - z_56*c_7;
    const double z_111 = z_110*c_8 - (z_100 - sin_q4*z_109);
    const double z_112 = z_99 + z_101;
    const double z_113 = l*(-(z_112 - sin_q5*z_112));
    const double z_114 = z_113*c_6 - c_3*z_112;
    const double z_115 = l*((z_113*c_2 - c_0*z_112) - sin_q5*z_114);
    const double z_116 = m*z_113 - z_112*c_7;
    const double z_117 = z_116*c_8;
    const double z_118 = z_117 - (cos_q4*z_30 - sin_q4*z_115);
    dM[75] = ((-1.0/6.0))*(cos_q3*z_111 + z_118*z_21 + z_114*z_49 + z_117 - (z_30*z_99 + z_20*z_115) - z_108*z_54
        - z_116*z_52);
    dM[80] = dM[76] = (1.0/6.0)*(z_110*z_85 - (z_57 + z_8*z_109) - z_2*z_111 - z_108*(cos_q2*z_48));
    const double z_119 = l*(-(z_58 - sin_q5*z_58));
    const double z_120 = z_119*c_6 - c_3*z_58;
    const double z_121 = cos_q4*z_92 + sin_q4*(l*((z_119*c_2 - c_0*z_58) - sin_q5*z_120));
    const double z_122 = (m*z_119 - z_58*c_7)*c_8;
    const double z_123 = sin_q4*z_95;
    const double z_124 = l*(sin_q4 - sin_q4*sin_q5);
    const double z_125 = c_3*sin_q4 + z_124*c_6;
    const double z_126 = l*((z_124*c_2 + sin_q4*c_0) - sin_q5*z_125);
    dM[81] = (1.0/6.0)*(z_122 - sin_q3*(z_121 + z_122) - (z_123 + cos_q4*z_126) - z_120*z_48);
    dM[85] = dM[77] = ((-1.0/6.0))*(sin_q3*z_118 + z_73*z_111 + z_114*z_48 - z_108*(sin_q2*z_54));
    dM[86] = dM[82] = ((-1.0/6.0))*(cos_q3*(m*z_124 + sin_q4*c_7)*c_8 - (z_102 - z_36*z_126) - z_125*z_54);
    const double z_127 = l*sin_q5;
    const double z_128 = l + l*sin_q4;
    const double z_129 = z_128 - sin_q4*z_127;
    const double z_130 = m*(2.0*z_129 + z_128);
    dM[87] = (1.0/6.0)*((z_123 + cos_q4*(l*((c_3 + z_129*c_2 + z_128*c_4) - sin_q5*z_130))) + z_98);
    dM[90] = dM[78] = (1.0/6.0)*((z_36*z_30 + z_56*z_115) + (z_44 - z_99*z_109) - (z_45*z_21 + z_101*z_109));
    dM[91] = dM[83] = ((-1.0/6.0))*(z_121 + (z_96 + z_58*z_126));
    const double z_131 = sin_q5*cos_q5;
    dM[92] = dM[88] = (1.0/6.0)*(sin_q4*(c_5*(3.0*cos_q5 - 2.0*z_131)));
    const double z_132 = sin_q3*z_127;
    const double z_133 = cos_q4*z_13;
    dM[95] = dM[79] = ((-1.0/6.0))*(l*(z_112*z_59 + z_108*z_103) - z_114*z_132 - z_108*(z_127*z_73) -
        l*(z_29*z_133 - z_62*z_114));
    const double z_134 = sin_q4*cos_q5;
    const double z_135 = cos_q3*z_127;
    dM[96] = dM[84] = (1.0/6.0)*(l*(z_91*z_134 - z_120*z_106) + z_125*z_135 - l*(z_35*(cos_q4*z_94) -
        z_105*z_125));
    const double c_11 = c[14];
    const double z_136 = cos_q5*cos_q5;
    const double z_137 = c_11*z_136;
    dM[97] = dM[89] = ((-1.0/6.0))*(z_94*z_127 - cos_q4*z_137);
    const double z_138 = l*cos_q5;
    const double z_139 = z_60 - z_62;
    const double z_140 = sin_q5*c_11;
    const double c_10 = c[13];
    const double z_141 = z_139*c_10;
    const double z_142 = z_141 - (z_41*z_138 + z_139*z_140);
    const double z_143 = sin_q4*z_142 + z_141;
    const double z_144 = z_104 - z_103;
    const double z_145 = z_144*c_10;
    const double z_146 = (z_29*z_138 - z_144*z_140) + z_145;
    const double z_147 = sin_q4*z_146 + z_145;
    const double z_148 = z_139*c_11;
    const double z_149 = z_29*z_127;
    const double z_150 = z_144*c_11;
    dM[100] = ((-1.0/6.0))*(z_147*z_21 + (z_149*z_73 + z_23*z_150) + z_145 - cos_q3*z_143 - z_20*z_146 -
        (z_41*z_132 - z_35*z_148) - sin_q2*z_145);
    dM[105] = dM[101] = ((-1.0/6.0))*((z_55*z_135 - z_14*z_148) + cos_q2*z_141 - z_8*z_142 - z_2*z_143);
    const double z_151 = z_61 + z_105;
    const double z_152 = z_151*c_10;
    const double z_153 = sin_q4*(z_152 - (z_91*z_138 + z_151*z_140));
    const double z_154 = (z_94*z_138 - z_140*z_106) + c_10*z_106;
    const double z_155 = z_151*c_11;
    dM[106] = (1.0/6.0)*((z_91*z_135 - z_13*z_155) + z_152 - sin_q3*(z_153 + z_152) - cos_q4*z_154);
    const double z_156 = z_41*z_127;
    dM[110] = dM[102] = ((-1.0/6.0))*(sin_q3*z_147 + (z_29*z_135 + z_13*z_150) - z_73*z_143 - (z_156*z_21 -
        z_74*z_148));
    const double z_157 = z_94*z_132;
    dM[111] = dM[107] = ((-1.0/6.0))*(z_36*z_154 + c_10*z_133 - (z_157 + z_58*z_137));
    const double z_158 = z_130*z_138 - z_140*z_134;
    const double z_159 = c_10*z_134;
    const double c_9 = c[12];
    dM[112] = ((-1.0/6.0))*(sin_q4*(z_158 + z_159) + z_159 + z_131*c_9);
    dM[115] = dM[103] = (1.0/6.0)*(z_56*z_146 + z_99*z_142 + z_101*z_142);
    dM[116] = dM[108] = ((-1.0/6.0))*(z_153 + z_58*z_154);
    dM[117] = dM[113] = (1.0/6.0)*(cos_q4*(2.0*c_5*(z_136 - sin_q5*sin_q5) + sin_q5*c_10));
    dM[118] = ((-1.0/6.0))*(cos_q5*c_10 - (cos_q5*z_140 - (c_3 + (l - z_127)*c_6)*z_138));
    dM[120] = dM[104] = ((-1.0/6.0))*((z_22*z_156 - z_103*z_148) + (z_29*z_54 - z_140*(sin_q3*z_144)) + (z_50 +
        z_140*(z_139*z_73)) + (z_36*z_149 + z_62*z_150));
    dM[121] = dM[109] = (1.0/6.0)*((z_91*(cos_q4*z_127) - z_106*z_155) + (sin_q4*z_157 + z_137*(sin_q4*z_58)) -
        (z_97 - z_140*z_133));
    dM[122] = dM[114] = ((-1.0/6.0))*(z_158 + sin_q5*c_9*z_134);
}

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ASIDE void motion_bias(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                          const double *restrict c, EM_UNUSED const double *restrict u, double *restrict bias,
                          double *restrict gamma)
{
    const double q1_dot = v[0];
    const double l = c[1];
    const double c_0 = c[3];
    const double q2_dot = v[1];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double z_1 = q2_dot*cos_q2;
    const double z_2 = l*z_1;
    const double sin_q2 = em_sin(q2);
    const double q3_dot = v[2];
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double z_5 = q3_dot*cos_q3;
    const double z_6 = sin_q2*z_5;
    const double sin_q3 = em_sin(q3);
    const double z_8 = sin_q3*z_1;
    const double z_9 = z_2 - l*(z_6 + z_8);
    const double c_1 = c[4];
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double q4_dot = v[3];
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double z_12 = q4_dot*sin_q4;
    const double z_13 = cos_q2*z_12;
    const double cos_q4 = em_cos(q4);
    const double z_15 = q2_dot*sin_q2;
    const double z_16 = cos_q4*z_15;
    const double z_17 = sin_q3*sin_q4;
    const double z_18 = q4_dot*cos_q4;
    const double z_19 = sin_q2*sin_q3;
    const double z_20 = (z_13 + z_16) + (z_1*z_17 + sin_q4*z_6 + z_18*z_19);
    const double z_21 = cos_q2*cos_q4;
    const double z_22 = sin_q2*z_17;
    const double z_23 = z_21 - z_22;
    const double q5_dot = v[4];
    const double cos_q5 = em_cos(q5);
    const double z_25 = q5_dot*cos_q5;
    const double z_26 = cos_q3*cos_q5;
    const double z_27 = q3_dot*sin_q3;
    const double z_28 = cos_q5*z_27;
    const double z_29 = q5_dot*sin_q5;
    const double z_30 = sin_q2*cos_q3;
    const double z_31 = z_26*z_1 - sin_q2*z_28 - z_29*z_30;
    const double z_32 = l*z_20 - z_9;
    const double z_33 = l*((sin_q5*z_20 - z_23*z_25) - z_31) - z_32;
    const double c_2 = c[5];
    const double z_34 = -z_32;
    const double z_35 = z_33*c_2 + z_34*c_1;
    const double z_36 = c_0*z_1 + z_9*c_1 + z_35;
    const double z_37 = sin_q3*cos_q5;
    const double z_38 = sin_q5*cos_q3;
    const double z_39 = sin_q4*cos_q3;
    const double z_40 = cos_q3 + z_39;
    const double z_41 = l*(z_40 - (z_37 + sin_q4*z_38));
    const double z_42 = z_41*c_2;
    const double z_43 = l*z_40;
    const double c_3 = c[6];
    const double c_4 = c[7];
    const double m = c[0];
    const double z_44 = m*(2.0*z_41 + z_43);
    const double z_45 = l*((c_3*cos_q3 + z_42 + z_43*c_4) - sin_q5*z_44);
    const double z_46 = sin_q4*z_45;
    const double z_47 = l*(z_42 + z_43*c_1 + cos_q3*c_0) + z_46;
    const double z_48 = z_47*z_27;
    const double z_49 = cos_q5*z_5;
    const double z_50 = sin_q3*z_29;
    const double z_51 = z_49 - z_50;
    const double z_52 = sin_q4*z_25;
    const double z_53 = sin_q5*z_27;
    const double z_54 = cos_q3*z_18;
    const double z_55 = l*z_27 - l*(z_54 - sin_q4*z_27);
    const double z_56 = l*(z_51 + (z_18*z_38 + cos_q3*z_52 - sin_q4*z_53)) + z_55;
    const double z_57 = z_56*c_2;
    const double z_58 = z_44*z_25;
    const double z_59 = m*(2.0*z_56 + z_55);
    const double z_60 = sin_q5*z_59;
    const double z_61 = l*(c_3*z_27 + z_57 + z_55*c_4) + l*(z_58 - z_60);
    const double z_62 = l*(z_57 + z_55*c_1 + c_0*z_27) - (z_45*z_18 - sin_q4*z_61);
    const double z_63 = cos_q5*z_30;
    const double z_64 = l*sin_q2;
    const double z_65 = l - z_64;
    const double z_66 = l*z_19 + z_65;
    const double z_67 = l*z_23 - z_66;
    const double z_68 = l*(z_23*sin_q5 + z_63) - z_67;
    const double z_69 = -z_67;
    const double z_70 = c_3 + z_68*c_2 + z_65*c_4 + z_66*c_1 + z_69*c_1;
    const double z_71 = m*(2.0*z_68 + z_69);
    const double z_72 = l*(m*(3.0*z_68 + z_66 + 5.0*z_69) - sin_q5*z_71);
    const double z_73 = m*(2.0*z_33 + z_34);
    const double z_74 = l*(m*(3.0*z_33 + z_9 + 5.0*z_34)) + l*(z_71*z_25 - sin_q5*z_73);
    const double c_5 = c[8];
    const double z_75 = l*(m*(3.0*z_68 + z_65 + 5.0*z_66 + 6.0*z_69)) + sin_q4*z_72;
    const double z_76 = z_72*z_18;
    const double z_77 = l*(c_3*z_1 + z_9*c_4 + z_35) - (z_76 - sin_q4*z_74);
    const double z_78 = z_71*z_26;
    const double z_79 = sin_q2*z_71;
    const double z_80 = z_71*z_30;
    const double c_6 = c[9];
    const double c_7 = c[10];
    const double z_81 = m*z_41 + z_43*c_6 + cos_q3*c_7;
    const double z_82 = sin_q2*z_12;
    const double z_83 = cos_q4*z_45;
    const double z_84 = cos_q4*sin_q2;
    const double z_85 = sin_q3*z_47;
    const double z_86 = z_47*z_5;
    const double z_87 = cos_q2*sin_q3;
    const double z_88 = cos_q2*z_44;
    const double z_89 = cos_q3*z_29;
    const double z_90 = 3.0*l*(z_81*z_15 + cos_q2*(m*z_56 + z_55*c_6 + c_7*z_27)) - (z_45*z_82 + z_84*z_61 -
        z_1*z_83) - (z_15*z_85 + z_62*z_87 - cos_q2*z_86) - l*(z_26*(z_44*z_15) + z_28*z_88 + z_89*z_88 +
        z_26*(cos_q2*z_59));
    const double z_91 = cos_q5*z_44;
    const double z_92 = z_44*z_29;
    const double z_93 = (z_75*z_5 - sin_q3*z_77) + (cos_q3*z_47*z_1 - sin_q2*z_48 - z_62*z_30) - l*(z_71*z_28 +
        z_71*z_89 + z_26*z_73) - l*(z_8*z_91 + z_6*z_91 - z_19*z_92 - cos_q5*(z_59*z_19));
    const double z_94 = cos_q4*z_72;
    const double z_95 = cos_q2*z_18;
    const double z_96 = cos_q2*sin_q4;
    const double z_97 = (cos_q3*z_72*z_12 + z_27*z_94 + cos_q4*cos_q3*z_74) - (z_46*z_15 + z_61*z_96 - z_45*z_95)
        - (z_45*z_12*z_19 + cos_q4*z_61*z_19 - z_8*z_83 - z_6*z_83);
    const double z_98 = sin_q5*z_5;
    const double z_99 = sin_q3*z_25;
    const double z_100 = sin_q3*sin_q5;
    const double z_101 = sin_q4*cos_q5;
    const double z_102 = z_27*z_101;
    const double z_103 = sin_q4*z_71;
    const double z_104 = cos_q3*z_101;
    const double z_105 = l*(z_20*z_91 + z_23*z_92 + cos_q5*(z_23*z_59)) + l*(z_71*z_98 + z_71*z_99 - z_100*z_73) +
        l*(z_38*(z_44*z_1) + z_58*z_30 - z_53*(sin_q2*z_44) - z_60*z_30) - l*(z_18*z_78 - z_71*z_102 - z_89*z_103
        - z_104*z_73);
    bias[0] = (1.0/6.0)*(q1_dot*(l*z_36 + (z_48 + cos_q3*z_62) + l*(z_70*z_1 - sin_q2*z_36) + c_5*z_1 +
        l*(z_44*z_49 - z_44*z_50 - z_37*z_59) - (z_72*z_16 + z_72*z_13 + z_21*z_74) - (z_75*z_8 + z_75*z_6 -
        z_77*z_19) - l*(z_1*z_78 - z_28*z_79 - z_29*z_80 - z_63*z_73)) + q5_dot*z_105 - q2_dot*z_90 - q3_dot*z_93
        - q4_dot*z_97);
    const double c_12 = c[15];
    const double c_13 = c[16];
    const double z_106 = c_13 - sin_q5*c_12;
    const double z_107 = sin_q3*z_18;
    const double z_108 = q1_dot*z_45;
    const double z_109 = q2_dot*cos_q4;
    const double z_110 = q1_dot*q1_dot;
    const double z_111 = l*cos_q5;
    const double z_112 = cos_q3*z_111;
    const double z_113 = l*z_110;
    const double z_114 = l*sin_q3;
    const double z_115 = q1_dot*cos_q3;
    const double z_116 = 2.0*q1_dot*z_27 + z_110*z_19;
    const double z_117 = 2.0*z_18*z_115 + z_21*z_110 - sin_q4*z_116;
    const double z_118 = l*z_117;
    const double z_119 = sin_q2*z_110;
    const double z_120 = l*(-(z_110 - z_119));
    const double c_14 = c[17];
    const double z_121 = z_116*c_14 - z_118 - 6.0*z_120;
    const double z_122 = l*(2.0*z_52*z_115 + 2.0*q1_dot*z_49 + z_63*z_110 + sin_q5*z_117 - 2.0*q1_dot*z_50);
    const double c_15 = c[18];
    const double z_123 = z_122 + z_116*c_15 - 6.0*z_120 - z_117*c_14;
    const double c_8 = c[11];
    const double z_124 = 2.0*z_122 + z_116*c_8 - 3.0*z_120 - z_117*c_8;
    const double z_125 = z_123 + z_124;
    const double z_126 = m*(z_121 + z_125);
    const double z_127 = c_3*z_124;
    const double z_128 = c_3*sin_q5;
    const double c_16 = c[19];
    const double z_129 = z_44*c_16;
    const double z_130 = q1_dot*z_129;
    const double z_131 = z_124*z_128 + z_25*z_130 - l*(m*z_125);
    const double z_132 = q1_dot*q2_dot;
    const double c_17 = c[20];
    const double c_18 = c[21];
    const double c_19 = c[22];
    const double z_133 = cos_q5*z_115;
    const double z_134 = l - z_114;
    const double z_135 = l*z_17 - z_134;
    const double z_136 = -l*(z_26 - sin_q5*z_17) - z_135;
    const double z_137 = -z_135;
    const double z_138 = m*(2.0*z_136 + z_137);
    const double z_139 = l*(m*(3.0*z_136 + z_134 + 5.0*z_137) - sin_q5*z_138);
    const double z_140 = l*(c_3 + z_136*c_2 + z_134*c_4 + z_137*c_1) + sin_q4*z_139;
    const double z_141 = z_28 + z_89;
    const double z_142 = l*z_5;
    const double z_143 = z_142 + l*(z_107 + sin_q4*z_5);
    const double z_144 = z_143 - l*(z_141 + (z_25*z_17 + sin_q4*z_98 + sin_q5*z_107));
    const double z_145 = z_144*c_2;
    const double z_146 = m*(2.0*z_144 + z_143);
    const double z_147 = z_139*z_18 - sin_q4*(l*(c_3*z_5 + z_145 + z_143*c_4) + l*(z_138*z_25 - sin_q5*z_146));
    const double z_148 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_149 = c_3*cos_q4;
    const double z_150 = z_149 + z_148*c_6;
    const double z_151 = l*((z_148*c_2 + cos_q4*c_0) - sin_q5*z_150);
    const double z_152 = l*z_12 - l*(sin_q5*z_12 - cos_q4*z_25);
    const double z_153 = c_3*z_12 + z_152*c_6;
    const double z_154 = l*(z_152*c_2 + c_0*z_12) + l*(z_150*z_25 - sin_q5*z_153);
    const double z_155 = cos_q4*z_154;
    const double z_156 = m*z_148 + cos_q4*c_7;
    const double z_157 = sin_q4*z_151;
    const double z_158 = 3.0*l*(z_156*z_27 + cos_q3*(m*z_152 + c_7*z_12)) + l*(z_150*z_49 - z_150*z_50 -
        z_37*z_153) - (z_151*z_54 - z_27*z_157 - z_39*z_154);
    const double z_159 = sin_q3*z_151;
    const double z_160 = z_147 + (z_12*z_159 + sin_q3*z_155 - cos_q4*z_151*z_5);
    const double z_161 = cos_q5*z_12;
    const double z_162 = cos_q4*z_29;
    const double z_163 = cos_q4*cos_q5;
    const double z_164 = cos_q5*z_17;
    const double z_165 = l*(z_138*z_161 + z_138*z_162 + z_146*z_163) - l*(z_25*(cos_q3*z_150) - z_150*z_53 -
        z_153*z_38) - l*(z_150*z_5*z_101 + cos_q5*(z_150*z_107) - z_29*(z_150*z_17) - z_153*z_164);
    bias[1] = (1.0/12.0)*((cos_q2*(6.0*cos_q4*z_106 + 2.0*z_107*z_108 + 2.0*q1_dot*z_86 + 2.0*z_109*z_108 +
        z_110*(z_71*z_112) + sin_q3*z_75*z_110 + z_114*z_126 + z_26*z_127 - z_70*z_113 - l*(m*z_123 + m*z_121 +
        (c_3*z_110 + m*(l*z_116 - 5.0*z_120)) + m*z_124) - z_131*z_17 - z_29*z_115*z_129 - z_28*z_130) -
        sin_q2*(6.0*z_106*z_17 + 2.0*z_12*z_108 + 2.0*z_132*z_85 + cos_q4*z_131 + c_17 + sin_q3*c_18 + z_26*c_19 +
        q2_dot*z_129*z_133 - z_110*z_94 - z_81*c_15*z_132)) - 2.0*(q1_dot*z_90 + q5_dot*z_165 - q2_dot*((z_140*z_5
        - sin_q3*(l*(z_145 + c_0*z_5 + z_143*c_1) - z_147)) + (z_151*z_12 + z_155) + (m*z_144 + c_7*z_5 +
        z_143*c_6)*c_8 - l*(z_138*z_28 + z_138*z_89 + z_26*z_146)) - q3_dot*z_158 - q4_dot*z_160));
    const double z_166 = q2_dot*q3_dot;
    const double z_167 = q2_dot*q2_dot;
    const double z_168 = z_138*z_167;
    const double z_169 = q2_dot*q4_dot;
    const double z_170 = sin_q3*z_167;
    const double z_171 = 2.0*z_169 + z_170;
    const double z_172 = sin_q4*z_171;
    const double z_173 = l*(2.0*z_25*z_109 + z_26*z_167 - sin_q5*z_172);
    const double z_174 = c_8*z_167 - 2.0*z_173 - z_172*c_8 - z_170*c_8;
    const double z_175 = c_3*z_174;
    const double z_176 = q1_dot*sin_q2;
    const double z_177 = 2.0*z_5*z_176 + 2.0*q1_dot*z_8 + cos_q3*z_110;
    const double z_178 = 2.0*z_107*z_176 + 2.0*q1_dot*z_13 + 2.0*z_176*z_109 + sin_q4*z_177;
    const double z_179 = q1_dot*z_1;
    const double z_180 = l*sin_q4;
    const double z_181 = q1_dot*z_23;
    const double z_182 = l*(2.0*z_89*z_176 + 2.0*z_28*z_176 + z_37*z_110 + sin_q5*z_178 - 2.0*z_25*z_181 -
        2.0*z_1*z_133);
    const double c_20 = c[23];
    const double z_183 = 2.0*z_182 + z_179*c_15 - z_178*c_8 - z_177*c_8;
    const double z_184 = m*((z_182 + z_179*c_20 - z_178*c_14 - z_177*c_15) + z_183);
    const double z_185 = sin_q4*z_128;
    const double z_186 = c_16*(q2_dot*z_150);
    const double z_187 = c_16*(q1_dot*z_71);
    const double z_188 = z_176*z_129;
    const double z_189 = q3_dot*cos_q5;
    const double z_190 = (c_15*z_167 - z_173 - z_172*c_14 - z_170*c_15) + z_174;
    const double z_191 = m*z_190;
    const double z_192 = z_45*z_176;
    const double z_193 = c_3*z_183;
    const double z_194 = l*sin_q5;
    const double z_195 = l + z_180;
    const double z_196 = z_195 - sin_q4*z_194;
    const double z_197 = m*(2.0*z_196 + z_195);
    const double z_198 = l*((c_3 + z_196*c_2 + z_195*c_4) - sin_q5*z_197);
    const double z_199 = l*z_18 - l*(z_52 + sin_q5*z_18);
    const double z_200 = l*(z_197*z_25 + sin_q5*(c_3*z_18 + z_199*c_6));
    const double c_9 = c[12];
    const double z_201 = cos_q5*c_9;
    const double z_202 = c_5*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    const double z_203 = q4_dot*q4_dot;
    const double z_204 = cos_q5*cos_q5;
    const double z_205 = q5_dot*z_204;
    const double c_10 = c[13];
    const double z_206 = 2.0*c_5*(z_205 - q5_dot*(sin_q5*sin_q5)) + c_10*z_29;
    const double z_207 = z_200 - 2.0*c_5*(z_204*z_18 - 2.0*z_29*z_101);
    bias[2] = ((-1.0/12.0))*((sin_q3*(2.0*z_166*z_157 + 2.0*z_47*(q3_dot*z_176) + z_110*z_111*z_79 + z_47*z_110 +
        z_183*z_185 + sin_q2*cos_q5*z_127 + c_19*(cos_q2*cos_q5) + c_15*(z_156*z_166) + z_52*z_187 + z_187*z_189 +
        cos_q5*z_179*z_129 - z_111*z_168 - cos_q5*z_175 - 2.0*q1_dot*z_76 - c_3*(l*(-(5.0*z_177 + z_178 -
        12.0*z_179))) - z_180*z_184 - l*z_184 - z_29*z_186 - z_29*z_188) - cos_q3*(6.0*z_106*z_96 +
        2.0*q2_dot*z_151*z_18 + z_174*z_185 + 2.0*z_18*z_192 + 2.0*q1_dot*q3_dot*z_75 + 2.0*z_47*z_179 +
        z_75*z_119 + cos_q5*z_193 + z_64*z_126 + cos_q2*c_18 - z_140*z_167 - z_180*z_191 - l*(m*(l*(6.0*z_167 -
        5.0*z_170 - z_172) + z_190)) - z_110*(z_44*z_111) - sin_q2*sin_q4*z_131 - z_52*z_186 - z_186*z_189 -
        z_29*z_187 - z_188*z_189)) + 2.0*(q1_dot*z_93 + q3_dot*((z_198*z_18 + sin_q4*(l*(z_199*c_2 + c_0*z_18) -
        z_200)) + (m*z_199 + c_7*z_18)*c_8 - z_29*z_201) + (sin_q4*z_202*z_203 + z_206*z_18) - q2_dot*z_158 -
        q5_dot*z_207));
    const double z_208 = q3_dot*q3_dot;
    const double z_209 = z_208;
    const double z_210 = sin_q4*z_208;
    const double z_211 = 2.0*q3_dot*q5_dot + z_210;
    const double z_212 = sin_q5*z_211;
    const double z_213 = l*(-(3.0*z_209 + 3.0*z_210 - 2.0*z_212));
    const double z_214 = q2_dot*z_5;
    const double z_215 = l*cos_q3;
    const double z_216 = c_16*z_25;
    const double z_217 = q3_dot*z_202;
    const double z_218 = 2.0*q2_dot*z_107 + 2.0*sin_q4*z_214 + cos_q4*z_167;
    const double z_219 = l*(2.0*z_25*(q2_dot*z_17) + 2.0*q2_dot*z_89 + 2.0*q2_dot*z_28 + sin_q5*z_218);
    const double z_220 = c_15*z_214 + z_218*c_8 - 2.0*z_219;
    const double z_221 = l - z_194;
    const double z_222 = c_3 + z_221*c_6;
    const double z_223 = q5_dot*z_111;
    const double c_11 = c[14];
    bias[3] = (1.0/12.0)*((cos_q4*(6.0*z_106*z_87 + z_198*z_208 + z_213*z_128 + 2.0*z_151*z_214 +
        sin_q3*z_174*z_128 + 2.0*q4_dot*cos_q2*z_108 + z_72*z_116 + z_45*z_177 + z_38*z_193 + q3_dot*z_205*c_9 +
        z_71*z_115*z_216 - l*(m*(l*(-(6.0*z_209 + 5.0*z_210 - z_212)) + z_213)) - z_139*z_171 - z_114*z_191 -
        z_215*z_184 - z_131*z_19 - z_99*z_186) + sin_q4*(2.0*q4_dot*z_217 + z_220*z_128 + 2.0*q4_dot*z_72*z_115 +
        cos_q2*z_72*z_110 + q2_dot*z_138*z_216 - 6.0*sin_q2*z_106 - 2.0*z_169*z_159 - z_151*z_167 -
        c_3*(c_20*z_214 + z_218*c_14 - z_219) - c_3*z_220 - 2.0*q4_dot*sin_q3*z_192 - 2.0*q2_dot*z_192 -
        cos_q2*z_131)) - 2.0*(q1_dot*z_97 + (z_12*z_217 + q3_dot*cos_q4*z_206) - q2_dot*z_160 - q4_dot*(c_10*z_25
        - (cos_q5*c_11*z_29 - z_222*z_223))));
    const double z_224 = cos_q2*cos_q3;
    const double c_21 = c[24];
    const double z_225 = q3_dot*z_18;
    const double c_22 = c[25];
    const double z_226 = q5_dot*c_16;
    const double z_227 = z_84 + cos_q2*z_17;
    const double z_228 = q5_dot*cos_q3;
    bias[4] = ((-1.0/12.0))*((sin_q5*(z_113*z_80 + sin_q3*z_193 + z_30*z_127 + c_19*z_224 + q3_dot*z_52*c_21 +
        c_9*(sin_q5*z_225) + z_208*z_201 + z_115*z_103*z_226 + z_129*(q5_dot*z_181) + z_5*z_187 +
        z_129*(z_1*z_115) - z_215*z_168 - cos_q3*z_175 - z_44*z_114*z_110 - c_22*z_225 - q5_dot*z_17*z_186 -
        z_226*(z_138*z_109) - z_27*z_186 - z_27*z_188) + cos_q5*(z_222*(l*z_203) + l*z_197*z_211 + z_150*(l*z_218)
        + z_149*z_220 + z_178*(l*z_44) + z_227*c_19 + z_186*z_228 + z_188*z_228 + q5_dot*sin_q3*z_187 -
        c_3*(l*(-(3.0*z_203 - 2.0*sin_q5*z_203))) - c_3*sin_q4*z_213 - z_138*(z_180*z_171) - z_17*z_175 -
        z_71*z_118 - z_39*z_193 - z_23*z_127 - z_225*z_201)) - 2.0*(q1_dot*z_105 + q3_dot*z_207 - q2_dot*z_165));
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double z_230 = sin_q4*z_221;
    const double z_231 = l + z_230;
    const double z_232 = z_221*z_18;
    const double z_233 = sin_q4*z_223;
    const double z_234 = z_232 - z_233;
    const double z_235 = (z_231*z_27 - cos_q3*z_234) + l*z_51;
    const double z_236 = cos_q3*z_231 - sin_q3*z_111;
    const double sin_q1 = em_sin(q1);
    const double z_238 = q1_dot*sin_q1;
    const double z_239 = cos_q4*z_221;
    const double z_240 = z_15*z_239;
    const double z_241 = z_221*z_13;
    const double z_242 = z_240 + z_241 + z_21*z_223;
    const double z_243 = z_2 - (z_231*z_8 + z_231*z_6 + z_234*z_19) - z_242 - l*z_31;
    const double z_244 = z_21*z_221;
    const double z_245 = z_65 + z_231*z_19 + z_111*z_30 - z_244;
    const double z_246 = q1_dot*cos_q1;
    const double z_247 = sin_q3*z_231;
    const double z_248 = z_231*cos_q1;
    const double z_249 = sin_q3*cos_q1;
    const double z_250 = sin_q2*cos_q1;
    const double z_251 = z_221*z_12;
    const double z_252 = cos_q1*z_1;
    const double z_253 = cos_q4*z_223;
    const double z_254 = sin_q1*z_176;
    const double z_255 = sin_q1*z_29;
    const double z_256 = cos_q3*sin_q1;
    const double z_257 = z_256 + cos_q1*z_19;
    const double z_258 = cos_q1*z_115;
    const double z_259 = (z_258 - sin_q1*z_27) + (cos_q1*z_8 + cos_q1*z_6 - sin_q3*z_254);
    const double z_260 = z_230*z_15;
    const double z_261 = z_221*z_95;
    const double z_262 = z_223*z_96;
    const double z_263 = z_221*z_96;
    const double z_264 = sin_q3*sin_q1;
    const double z_265 = sin_q1*z_5;
    gamma[0] = -(q1_dot*((cos_q1*z_235 + z_236*z_238) - (sin_q1*z_243 - z_245*z_246)) + q3_dot*(((z_231*sin_q1 +
        z_111*z_250)*z_5 + sin_q3*((sin_q1*z_234 + z_231*z_246) + l*(cos_q5*z_252 - z_29*z_250 - cos_q5*z_254))) -
        ((sin_q1*z_111 - z_231*z_250)*z_27 + cos_q3*(l*(z_255 - cos_q5*z_246) + (z_231*z_252 + z_234*z_250 -
        z_231*z_254)))) + q4_dot*((z_257*z_251 + z_257*z_253 - z_259*z_239) + (cos_q1*z_260 + cos_q1*z_262 +
        z_263*z_238 - cos_q1*z_261)) - q2_dot*(((l*cos_q1 - cos_q1*z_247 - cos_q1*z_112)*z_15 + cos_q2*(l*z_238 +
        (z_248*z_5 + z_249*z_234 - z_238*z_247) - l*(cos_q1*z_28 + cos_q1*z_89 + sin_q1*z_133))) - (z_250*z_251 +
        z_253*z_250 + z_239*z_254 - z_239*z_252)) - q5_dot*(l*((z_264 - cos_q1*z_30)*z_25 + sin_q5*((sin_q3*z_246
        + z_265) + (cos_q3*z_254 + z_27*z_250 - cos_q3*z_252))) + l*((sin_q4*z_257 - z_21*cos_q1)*z_29 -
        cos_q5*((z_257*z_18 + sin_q4*z_259) + (z_21*z_238 + cos_q1*z_16 + cos_q1*z_13)))));
    gamma[1] = q2_dot*(z_242 - ((z_134 - z_112 - z_221*z_17)*z_1 - sin_q2*(z_142 + (z_230*z_5 + z_221*z_107 -
        z_223*z_17) - l*z_141))) + q3_dot*(((l*cos_q2 + z_263)*z_27 + cos_q3*(l*z_15 + (z_260 + z_262 - z_261))) -
        l*(z_37*z_15 + cos_q2*z_50 - cos_q2*z_49)) + q4_dot*((z_230*z_1 + sin_q2*z_232 - sin_q2*z_233) +
        (sin_q3*z_240 + sin_q3*z_241 + z_21*(sin_q3*z_223) - z_244*z_5)) - q5_dot*(l*(z_227*z_29 -
        cos_q5*((cos_q4*z_1 - z_82) + (z_5*z_96 + cos_q2*z_107 - z_15*z_17))) + l*(z_15*z_38 + cos_q2*z_53 -
        z_25*z_224));
    const double z_266 = sin_q2*sin_q1;
    const double z_267 = sin_q1*z_1;
    const double z_268 = cos_q1*z_176;
    const double z_269 = cos_q3*cos_q1 - sin_q3*z_266;
    const double z_270 = (sin_q1*z_115 + cos_q1*z_27) + (sin_q3*z_268 + sin_q1*z_8 + z_5*z_266);
    const double z_271 = z_249 + sin_q1*z_30;
    const double z_272 = (cos_q1*z_5 - sin_q3*z_238) + (cos_q3*z_268 + cos_q3*z_267 - z_27*z_266);
    const double z_273 = sin_q4*z_269 + z_21*sin_q1;
    const double z_274 = (z_269*z_18 - sin_q4*z_270) - (sin_q1*z_16 + sin_q1*z_13 - z_21*z_246);
    gamma[2] = q1_dot*((sin_q1*z_235 - z_236*z_246) + (z_245*z_238 + cos_q1*z_243)) + q5_dot*(l*(z_271*z_25 +
        sin_q5*z_272) + l*(z_273*z_29 - cos_q5*z_274)) - q2_dot*(((l*sin_q1 - sin_q1*z_247 - sin_q1*z_112)*z_15 -
        cos_q2*(l*z_246 + l*(sin_q1*z_28 + sin_q1*z_89 - cos_q1*z_133) - (z_231*z_265 + z_264*z_234 +
        z_246*z_247))) - (z_266*z_251 + z_253*z_266 - z_239*z_267 - z_268*z_239)) - q3_dot*(((z_248 -
        z_111*z_266)*z_5 + sin_q3*((cos_q1*z_234 - z_231*z_238) - l*(cos_q5*z_267 + cos_q5*z_268 - z_29*z_266))) -
        ((cos_q1*z_111 + z_231*z_266)*z_27 + cos_q3*(l*(cos_q1*z_29 + cos_q5*z_238) - (z_231*z_267 + z_234*z_266 +
        z_231*z_268)))) - q4_dot*((z_269*z_251 + z_269*z_253 + z_270*z_239) - (sin_q1*z_260 + sin_q1*z_262 -
        sin_q1*z_261 - z_263*z_246));
    const double z_275 = cos_q5*z_18;
    const double z_276 = cos_q5*sin_q1;
    const double z_277 = sin_q4*z_29;
    gamma[3] = -(q1_dot*(((sin_q5*z_30 + sin_q2*z_164 - z_21*cos_q5)*z_238 - cos_q1*((z_1*z_38 + z_25*z_30 -
        sin_q2*z_53) + (z_15*z_163 + cos_q5*z_13 + z_21*z_29) + (z_1*z_164 + z_6*z_101 + z_19*z_275 - z_22*z_29)))
        + ((z_100 - z_104)*z_246 + sin_q1*((z_98 + z_99) - (z_26*z_18 - z_102 - sin_q4*z_89)))) +
        q2_dot*(((sin_q1*z_38 + sin_q1*z_164)*z_15 - cos_q2*((z_256*z_25 + sin_q5*z_258 - sin_q1*z_53) +
        (z_265*z_101 + z_107*z_276 + z_246*z_164 - z_255*z_17))) + (z_266*z_161 + z_266*z_162 - z_267*z_163 -
        z_268*z_163)) + q3_dot*(((sin_q5*cos_q1 + z_266*z_101)*z_27 - cos_q3*((cos_q1*z_25 - sin_q5*z_238) +
        (z_101*z_267 + z_266*z_275 + z_101*z_268 - z_266*z_277))) + ((sin_q5*z_266 - cos_q1*z_101)*z_5 +
        sin_q3*((sin_q5*z_267 + z_25*z_266 + sin_q5*z_268) - (cos_q1*z_275 - cos_q1*z_277 - z_101*z_238)))) -
        q4_dot*((z_269*z_161 + z_269*z_162 + z_270*z_163) - (sin_q1*z_15*z_101 + z_255*z_96 - z_95*z_276 -
        cos_q2*z_101*z_246)) - q5_dot*((z_273*z_25 + sin_q5*z_274) - (z_271*z_29 - cos_q5*z_272)));
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ASIDE void energy(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                     const double *restrict c, double *restrict e)
{
    const double q1_dot = v[0];
    const double l = c[1];
    const double c_3 = c[6];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double q4 = x[3];
    const double cos_q4 = em_cos(q4);
    const double z_2 = cos_q2*cos_q4;
    const double sin_q2 = em_sin(q2);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double sin_q4 = em_sin(q4);
    const double z_6 = sin_q3*sin_q4;
    const double z_7 = z_2 - sin_q2*z_6;
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double cos_q5 = em_cos(q5);
    const double cos_q3 = em_cos(q3);
    const double z_11 = sin_q2*cos_q3;
    const double z_12 = sin_q2*sin_q3;
    const double z_13 = l*sin_q2;
    const double z_14 = l - z_13;
    const double z_15 = l*z_12 + z_14;
    const double z_16 = l*z_7 - z_15;
    const double z_17 = l*(z_7*sin_q5 + cos_q5*z_11) - z_16;
    const double c_2 = c[5];
    const double c_4 = c[7];
    const double c_1 = c[4];
    const double z_18 = -z_16;
    const double z_19 = c_3 + z_17*c_2 + z_14*c_4 + z_15*c_1 + z_18*c_1;
    const double z_20 = sin_q4*cos_q3;
    const double z_21 = cos_q3 + z_20;
    const double z_22 = l*(z_21 - (sin_q3*cos_q5 + sin_q5*z_20));
    const double z_23 = z_22*c_2;
    const double z_24 = l*z_21;
    const double c_0 = c[3];
    const double m = c[0];
    const double z_25 = m*(2.0*z_22 + z_24);
    const double z_26 = sin_q5*z_25;
    const double z_27 = l*((c_3*cos_q3 + z_23 + z_24*c_4) - z_26);
    const double z_28 = sin_q4*z_27;
    const double z_29 = l*(z_23 + z_24*c_1 + cos_q3*c_0) + z_28;
    const double z_30 = m*(2.0*z_17 + z_18);
    const double z_31 = l*(m*(3.0*z_17 + z_15 + 5.0*z_18) - sin_q5*z_30);
    const double z_32 = l*(m*(3.0*z_17 + z_14 + 5.0*z_15 + 6.0*z_18)) + sin_q4*z_31;
    const double z_33 = l*cos_q5;
    const double z_34 = z_25*z_33;
    const double z_35 = z_30*z_33;
    const double c_9 = c[12];
    const double q2_dot = v[1];
    const double z_36 = cos_q4*sin_q2;
    const double z_37 = cos_q2*sin_q3;
    const double z_38 = cos_q2*cos_q3;
    const double c_6 = c[9];
    const double c_7 = c[10];
    const double c_8 = c[11];
    const double z_39 = cos_q2*(m*z_22 + z_24*c_6 + cos_q3*c_7)*c_8 - z_27*z_36 - z_29*z_37 - z_34*z_38;
    const double q3_dot = v[2];
    const double z_40 = sin_q3*z_32 + z_29*z_11 + cos_q3*z_35 - z_12*z_34;
    const double q4_dot = v[3];
    const double z_41 = cos_q4*cos_q3*z_31 - cos_q2*z_28 - cos_q4*z_27*z_12;
    const double q5_dot = v[4];
    const double z_42 = l*(z_7*cos_q5*z_25 + cos_q5*z_20*z_30 - sin_q5*(sin_q3*z_30) - z_26*z_11);
    const double z_43 = l - l*sin_q3;
    const double z_44 = l*z_6 - z_43;
    const double z_45 = -l*(cos_q3*cos_q5 - sin_q5*z_6) - z_44;
    const double z_46 = -z_44;
    const double z_47 = z_45*c_2 + z_46*c_1;
    const double z_48 = m*(2.0*z_45 + z_46);
    const double z_49 = sin_q4*(l*(m*(3.0*z_45 + z_43 + 5.0*z_46) - sin_q5*z_48));
    const double z_50 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_51 = c_3*cos_q4 + z_50*c_6;
    const double z_52 = sin_q5*z_51;
    const double z_53 = l*((z_50*c_2 + cos_q4*c_0) - z_52);
    const double z_54 = cos_q4*z_53;
    const double z_55 = z_20*z_53 + cos_q3*(m*z_50 + cos_q4*c_7)*c_8 - sin_q3*(z_51*z_33);
    const double z_56 = z_49 - sin_q3*z_54;
    const double z_57 = l*(cos_q5*(cos_q4*z_48) + cos_q3*z_52 + cos_q5*z_51*z_6);
    const double z_58 = l*sin_q5;
    const double z_59 = l + l*sin_q4;
    const double z_60 = z_59 - sin_q4*z_58;
    const double z_61 = z_60*c_2;
    const double z_62 = m*(2.0*z_60 + z_59);
    const double c_11 = c[14];
    const double z_63 = cos_q5*cos_q5;
    const double c_5 = c[8];
    const double z_64 = cos_q4*(c_5*(3.0*cos_q5 - 2.0*sin_q5*cos_q5));
    const double z_65 = z_62*z_58 - c_11*(sin_q4*z_63);
    const double z_66 = l - z_58;
    e[0] = (1.0/12.0)*(q1_dot*(q1_dot*(l*z_19 + cos_q3*z_29 + c_3*z_14 + z_32*z_12 + z_11*z_35 + c_9 - z_13*z_19 -
        z_2*z_31 - sin_q3*z_34) + q3_dot*z_40 + q5_dot*z_42 - q2_dot*z_39 - q4_dot*z_41) + q3_dot*(q1_dot*z_40 +
        q2_dot*z_55 + q3_dot*(l*(c_0 + z_61 + z_59*c_1) + sin_q4*(l*((c_3 + z_61 + z_59*c_4) - sin_q5*z_62)) +
        c_11*z_63) - q4_dot*z_64 - q5_dot*z_65) + q5_dot*(q1_dot*z_42 + q5_dot*c_11 - q2_dot*z_57 - q3_dot*z_65) -
        q2_dot*(q1_dot*z_39 + q2_dot*(sin_q3*(l*(c_3 + z_43*c_4 + z_47) + z_49) + cos_q3*z_48*z_33 - l*(c_0 +
        z_43*c_1 + z_47) - z_54) + q4_dot*z_56 + q5_dot*z_57 - q3_dot*z_55) - q4_dot*(q1_dot*z_41 + q2_dot*z_56 +
        q3_dot*z_64 - q4_dot*(l*((c_0 + z_66*c_2) - sin_q5*(c_3 + z_66*c_6)))));
    e[1] = 0.0;
    e[2] = 0.0;
    const double z_67 = z_36 + cos_q2*z_6;
    const double c_25 = c[28];
    e[3] = l*(7.0*cos_q2 + (sin_q5*z_67 - cos_q5*z_38) - 3.0*z_67 - 5.0*z_37)*c_25;
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
    p[0] = p[1] = p[2] = p[3] = p[5] = p[6] = p[7] = p[8] = p[11] = p[14] = p[36] = p[37] = p[38] = p[42] = 0.0;
    const double c_26 = c[29];
    p[4] = c_26;
    const double l = c[1];
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    p[9] = p[12] = p[40] = l*cos_q1;
    const double sin_q1 = em_sin(q1);
    p[10] = p[13] = p[41] = l*sin_q1;
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_3 = sin_q2*cos_q1;
    const double z_4 = cos_q1 - z_3;
    p[15] = p[18] = p[44] = l*z_4;
    const double z_5 = sin_q2*sin_q1;
    const double z_6 = sin_q1 - z_5;
    p[16] = p[19] = p[45] = l*z_6;
    const double cos_q2 = em_cos(q2);
    p[17] = p[20] = p[46] = l*cos_q2;
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double sin_q3 = em_sin(q3);
    const double z_10 = cos_q3*sin_q1 + sin_q3*z_3;
    const double z_11 = z_10 + z_4;
    p[21] = p[24] = p[48] = p[60] = l*z_11;
    const double z_12 = cos_q3*cos_q1 - sin_q3*z_5;
    const double z_13 = z_12 - z_6;
    p[22] = p[25] = p[49] = p[61] = l*(-z_13);
    const double z_14 = cos_q2*sin_q3;
    const double z_15 = cos_q2 - z_14;
    p[23] = p[26] = p[50] = p[62] = l*z_15;
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double cos_q4 = em_cos(q4);
    const double z_18 = cos_q2*cos_q4;
    const double z_19 = sin_q4*z_10 - cos_q1*z_18;
    const double z_20 = z_19 + z_11;
    p[27] = p[30] = p[52] = l*z_20;
    const double z_21 = sin_q4*z_12 + sin_q1*z_18;
    const double z_22 = z_21 + z_13;
    p[28] = p[31] = p[53] = l*(-z_22);
    const double z_23 = cos_q4*sin_q2 + sin_q4*z_14;
    const double z_24 = z_23 - z_15;
    p[29] = p[32] = p[54] = l*(-z_24);
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double cos_q5 = em_cos(q5);
    p[33] = p[56] = l*(z_20 - (sin_q5*z_19 + cos_q5*(sin_q3*sin_q1 - cos_q3*z_3)));
    p[34] = p[57] = l*((sin_q5*z_21 + cos_q5*(sin_q3*cos_q1 + cos_q3*z_5)) - z_22);
    p[35] = p[58] = l*((sin_q5*z_23 - cos_q2*cos_q3*cos_q5) - z_24);
    const double c_27 = c[30];
    p[39] = p[43] = p[47] = p[51] = p[55] = p[59] = c_27;
}

#endif
#ifndef EM_ASIDE_ALONE

/* Where the other is linked it takes the place of this. */
extern em_lanes bricard_lanes;
EM_WEAK em_lanes bricard_lanes = {0, NULL, NULL, NULL};
#define EM_MODEL_LANES bricard_lanes

#include "em_blocks.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0 };
static const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 10, 35, 0, 25 };
static const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double l = parameters[1];
    const double m = parameters[0];
    const double z_0 = l*m;
    prepared[3] = 5.0*z_0;
    prepared[4] = 6.0*m;
    prepared[5] = 3.0*m;
    prepared[6] = z_0;
    prepared[7] = 5.0*m;
    const double z_1 = m*(l*l);
    prepared[8] = z_1;
    prepared[9] = 2.0*m;
    prepared[10] = 2.0*z_0;
    prepared[11] = 3.0*l;
    prepared[12] = 4.0*z_1;
    prepared[13] = 3.0*z_1;
    prepared[14] = 2.0*z_1;
    const double g = parameters[2];
    const double z_2 = z_0*g;
    prepared[15] = z_2;
    prepared[16] = 3.0*z_2;
    prepared[17] = 5.0*l;
    prepared[18] = 6.0*l;
    prepared[19] = 2.0*l;
    prepared[20] = (-42.0)*z_2;
    prepared[21] = 30.0*z_2;
    prepared[22] = 6.0*z_2;
    prepared[23] = 12.0*l;
    prepared[24] = 8.0*z_1;
    prepared[25] = 6.0*z_1;
    prepared[26] = (1.0/3.0)*z_1;
    prepared[27] = fabs(l);
    prepared[28] = 0.5*(m*g);
    prepared[29] = -l;
    prepared[30] = (1.0/20.0)*l;
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
    const double l = c[1];
    const double c_3 = c[6];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double q4 = x[3];
    const double cos_q4 = em_cos(q4);
    const double z_2 = cos_q2*cos_q4;
    const double sin_q4 = em_sin(q4);
    const double sin_q2 = em_sin(q2);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_6 = sin_q2*sin_q3;
    const double z_7 = z_2 - sin_q4*z_6;
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double cos_q5 = em_cos(q5);
    const double cos_q3 = em_cos(q3);
    const double z_11 = sin_q2*cos_q3;
    const double z_12 = l*sin_q2;
    const double z_13 = l - z_12;
    const double z_14 = l*z_6 + z_13;
    const double z_15 = l*z_7 - z_14;
    const double z_16 = l*(z_7*sin_q5 + cos_q5*z_11) - z_15;
    const double c_2 = c[5];
    const double c_4 = c[7];
    const double c_1 = c[4];
    const double z_17 = -z_15;
    const double z_18 = c_3 + z_16*c_2 + z_13*c_4 + z_14*c_1 + z_17*c_1;
    const double z_19 = sin_q4*cos_q3;
    const double z_20 = cos_q3 + z_19;
    const double z_21 = l*(z_20 - (sin_q3*cos_q5 + sin_q5*z_19));
    const double z_22 = z_21*c_2;
    const double z_23 = l*z_20;
    const double c_0 = c[3];
    const double m = c[0];
    const double z_24 = m*(2.0*z_21 + z_23);
    const double z_25 = sin_q5*z_24;
    const double z_26 = l*((c_3*cos_q3 + z_22 + z_23*c_4) - z_25);
    const double z_27 = sin_q4*z_26;
    const double z_28 = l*(z_22 + z_23*c_1 + cos_q3*c_0) + z_27;
    const double z_29 = m*(2.0*z_16 + z_17);
    const double z_30 = l*(m*(3.0*z_16 + z_14 + 5.0*z_17) - sin_q5*z_29);
    const double z_31 = l*(m*(3.0*z_16 + z_13 + 5.0*z_14 + 6.0*z_17)) + sin_q4*z_30;
    const double z_32 = l*cos_q5;
    const double z_33 = z_24*z_32;
    const double z_34 = z_29*z_32;
    const double c_9 = c[12];
    M[0] = (1.0/6.0)*(l*z_18 + cos_q3*z_28 + c_3*z_13 + z_31*z_6 + z_11*z_34 + c_9 - z_12*z_18 - z_2*z_30 -
        sin_q3*z_33);
    const double z_35 = cos_q4*z_26;
    const double c_8 = c[11];
    const double c_6 = c[9];
    const double c_7 = c[10];
    M[5] = M[1] = ((-1.0/6.0))*(c_8*(cos_q2*(m*z_21 + z_23*c_6 + cos_q3*c_7)) - sin_q2*z_35 - cos_q2*sin_q3*z_28 -
        cos_q2*cos_q3*z_33);
    const double z_36 = l - l*sin_q3;
    const double z_37 = sin_q3*sin_q4;
    const double z_38 = l*z_37 - z_36;
    const double z_39 = -l*(cos_q3*cos_q5 - sin_q5*z_37) - z_38;
    const double z_40 = -z_38;
    const double z_41 = z_39*c_2 + z_40*c_1;
    const double z_42 = m*(2.0*z_39 + z_40);
    const double z_43 = sin_q4*(l*(m*(3.0*z_39 + z_36 + 5.0*z_40) - sin_q5*z_42));
    const double z_44 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_45 = c_3*cos_q4 + z_44*c_6;
    const double z_46 = sin_q5*z_45;
    const double z_47 = l*((z_44*c_2 + cos_q4*c_0) - z_46);
    const double z_48 = cos_q4*z_47;
    M[6] = ((-1.0/6.0))*(sin_q3*(l*(c_3 + z_36*c_4 + z_41) + z_43) + cos_q3*z_42*z_32 - l*(c_0 + z_36*c_1 + z_41)
        - z_48);
    M[10] = M[2] = (1.0/6.0)*(sin_q3*z_31 + z_28*z_11 + cos_q3*z_34 - z_6*z_33);
    M[11] = M[7] = (1.0/6.0)*(z_19*z_47 + cos_q3*(m*z_44 + cos_q4*c_7)*c_8 - sin_q3*(z_45*z_32));
    const double z_49 = l*sin_q5;
    const double z_50 = l + l*sin_q4;
    const double z_51 = z_50 - sin_q4*z_49;
    const double z_52 = z_51*c_2;
    const double z_53 = m*(2.0*z_51 + z_50);
    const double c_11 = c[14];
    const double z_54 = cos_q5*cos_q5;
    M[12] = (1.0/6.0)*(l*(c_0 + z_52 + z_50*c_1) + sin_q4*(l*((c_3 + z_52 + z_50*c_4) - sin_q5*z_53)) +
        c_11*z_54);
    M[15] = M[3] = ((-1.0/6.0))*(cos_q4*cos_q3*z_30 - cos_q2*z_27 - z_6*z_35);
    M[16] = M[8] = ((-1.0/6.0))*(z_43 - sin_q3*z_48);
    const double c_5 = c[8];
    M[17] = M[13] = ((-1.0/6.0))*(cos_q4*(c_5*(3.0*cos_q5 - 2.0*sin_q5*cos_q5)));
    const double z_55 = l - z_49;
    M[18] = (1.0/6.0)*(l*((c_0 + z_55*c_2) - sin_q5*(c_3 + z_55*c_6)));
    M[20] = M[4] = (1.0/6.0)*(l*(z_7*cos_q5*z_24 + cos_q5*z_19*z_29 - sin_q5*(sin_q3*z_29) - z_25*z_11));
    M[21] = M[9] = ((-1.0/6.0))*(l*(cos_q5*(cos_q4*z_42) + cos_q3*z_46 + cos_q5*z_45*z_37));
    M[22] = M[14] = ((-1.0/6.0))*(z_53*z_49 - c_11*(sin_q4*z_54));
    M[23] = M[19] = 0.0;
    const double c_23 = c[26];
    M[24] = c_23;
}

/* What is factored, of which motion_bias is */
static void (*const factored)(double t, const double *restrict x, const double *restrict c, double *restrict M) =
    mass_matrix;

/* A (m, n), b (m): A xdot + b = 0                                                                               (8) */
static void pfaffian(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                     double *restrict A, double *restrict b)
{
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double l = c[1];
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double z_3 = l - l*sin_q5;
    const double z_4 = sin_q4*z_3;
    const double z_5 = l + z_4;
    const double sin_q3 = em_sin(q3);
    const double cos_q5 = em_cos(q5);
    const double z_8 = l*cos_q5;
    const double z_9 = cos_q3*z_5 - sin_q3*z_8;
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_12 = sin_q3*z_5;
    const double cos_q2 = em_cos(q2);
    const double cos_q4 = em_cos(q4);
    const double z_15 = cos_q4*z_3;
    const double z_16 = cos_q2*z_15;
    const double z_17 = cos_q3*z_8;
    const double z_18 = l + sin_q2*z_12 + sin_q2*z_17 - l*sin_q2 - z_16;
    const double sin_q1 = em_sin(q1);
    A[0] = z_9*cos_q1 - z_18*sin_q1;
    const double z_20 = sin_q2*cos_q1;
    A[1] = -(cos_q2*(l*cos_q1 - cos_q1*z_12 - cos_q1*z_17) - z_15*z_20);
    A[2] = -(sin_q3*(z_5*sin_q1 + z_8*z_20) + cos_q3*(sin_q1*z_8 - z_5*z_20));
    const double z_21 = cos_q3*sin_q1 + sin_q3*z_20;
    const double z_22 = cos_q2*z_4;
    A[3] = z_21*z_15 + cos_q1*z_22;
    const double z_23 = sin_q3*sin_q1;
    const double z_24 = cos_q2*cos_q4;
    A[4] = l*(sin_q5*(z_23 - cos_q3*z_20) - cos_q5*(sin_q4*z_21 - cos_q1*z_24));
    A[5] = 0.0;
    A[6] = -(z_16 + sin_q2*(l - l*sin_q3 - z_17 - sin_q3*z_4));
    const double z_25 = cos_q2*sin_q3;
    A[7] = -(cos_q3*(l*cos_q2 + z_22) - z_8*z_25);
    A[8] = sin_q2*z_4 - z_15*z_25;
    const double z_26 = sin_q5*cos_q3;
    A[9] = l*(cos_q5*(cos_q4*sin_q2 + sin_q4*z_25) + cos_q2*z_26);
    A[10] = -(z_9*sin_q1 + cos_q1*z_18);
    const double z_27 = sin_q2*sin_q1;
    A[11] = cos_q2*(l*sin_q1 - sin_q1*z_12 - sin_q1*z_17) - z_27*z_15;
    A[12] = -(sin_q3*(z_5*cos_q1 - z_8*z_27) + cos_q3*(cos_q1*z_8 + z_5*z_27));
    const double z_28 = cos_q3*cos_q1 - sin_q3*z_27;
    A[13] = z_28*z_15 - sin_q1*z_22;
    const double z_29 = sin_q3*cos_q1 + cos_q3*z_27;
    const double z_30 = sin_q4*z_28 + sin_q1*z_24;
    A[14] = l*(sin_q5*z_29 - cos_q5*z_30);
    const double z_31 = sin_q4*cos_q5;
    A[15] = cos_q1*(sin_q2*z_26 + sin_q2*sin_q3*z_31 - cos_q5*z_24) - sin_q1*(sin_q3*sin_q5 - cos_q3*z_31);
    const double z_32 = cos_q4*cos_q5;
    A[16] = cos_q2*(sin_q1*z_26 + z_23*z_31) + z_27*z_32;
    A[17] = cos_q3*(sin_q5*cos_q1 + z_27*z_31) - sin_q3*(sin_q5*z_27 - cos_q1*z_31);
    A[18] = -(z_28*z_32 - cos_q2*sin_q1*z_31);
    A[19] = sin_q5*z_30 + cos_q5*z_29;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
static void position(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                     double *restrict phi, double *restrict terms)
{
    const double l = c[1];
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double sin_q1 = em_sin(q1);
    const double z_3 = cos_q3*sin_q1;
    const double sin_q3 = em_sin(q3);
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_6 = sin_q2*cos_q1;
    const double z_7 = z_3 + sin_q3*z_6;
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double cos_q2 = em_cos(q2);
    const double cos_q4 = em_cos(q4);
    const double z_11 = cos_q2*cos_q4;
    const double z_12 = sin_q4*z_7 - z_11*cos_q1;
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double cos_q5 = em_cos(q5);
    const double z_15 = sin_q3*sin_q1;
    const double z_16 = z_15 - cos_q3*z_6;
    phi[0] = l*(cos_q1 + z_7 + z_12 - (sin_q5*z_12 + cos_q5*z_16) - z_6);
    const double z_17 = cos_q2*sin_q3;
    const double z_18 = cos_q4*sin_q2 + sin_q4*z_17;
    const double z_19 = cos_q2*cos_q3;
    phi[1] = l*(cos_q2 + (sin_q5*z_18 - cos_q5*z_19) - z_18 - z_17);
    const double z_20 = l*sin_q1;
    const double z_21 = cos_q3*cos_q1;
    const double z_22 = sin_q2*sin_q1;
    const double z_23 = z_21 - sin_q3*z_22;
    const double z_24 = sin_q4*z_23 + z_11*sin_q1;
    const double z_25 = sin_q3*cos_q1;
    const double z_26 = z_25 + cos_q3*z_22;
    phi[2] = -(l + z_20 + l*(sin_q5*z_24 + cos_q5*z_26) - l*z_24 - l*z_23 - l*z_22);
    phi[3] = sin_q5*z_26 - cos_q5*z_24;
    const double c_24 = c[27];
    const double z_27 = fabs(cos_q1);
    const double z_28 = z_27 + fabs(q1*sin_q1);
    const double z_29 = fabs(sin_q4);
    const double z_30 = z_29 + fabs(q4*cos_q4);
    const double z_31 = fabs(cos_q3);
    const double z_32 = z_31 + fabs(q3*sin_q3);
    const double z_33 = fabs(sin_q1);
    const double z_34 = z_33 + fabs(q1*cos_q1);
    const double z_35 = fabs(sin_q2);
    const double z_36 = z_35 + fabs(q2*cos_q2);
    const double z_37 = fabs(sin_q3);
    const double z_38 = z_37 + fabs(q3*cos_q3);
    const double z_39 = fabs(z_6);
    const double z_40 = fabs(sin_q2*sin_q3);
    const double z_41 = (z_32*z_33 + z_31*z_34) + (z_36*fabs(z_25) + z_38*z_39 + z_28*z_40);
    const double z_42 = fabs(cos_q2) + fabs(q2*sin_q2);
    const double z_43 = fabs(cos_q4);
    const double z_44 = z_43 + fabs(q4*sin_q4);
    const double z_45 = fabs(z_11);
    const double z_46 = (z_30*fabs(z_7) + z_29*z_41) + (z_42*fabs(cos_q4*cos_q1) + z_44*fabs(cos_q2*cos_q1) +
        z_28*z_45);
    const double z_47 = fabs(sin_q5);
    const double z_48 = z_47 + fabs(q5*cos_q5);
    const double z_49 = fabs(cos_q5);
    const double z_50 = z_49 + fabs(q5*sin_q5);
    const double z_51 = fabs(sin_q2*cos_q3);
    const double z_52 = fabs(l*sin_q2);
    terms[0] = c_24*z_28 + c_24*z_46 + c_24*z_41 + c_24*((z_48*fabs(z_12) + z_47*z_46) + (z_50*fabs(z_16) +
        z_49*((z_38*z_33 + z_37*z_34) + (z_36*fabs(z_21) + z_32*z_39 + z_28*z_51)))) + (z_36*fabs(l*cos_q1) +
        z_28*z_52);
    const double z_53 = (z_44*z_35 + z_43*z_36) + (z_42*fabs(sin_q3*sin_q4) + z_38*fabs(cos_q2*sin_q4) +
        z_30*fabs(z_17));
    terms[1] = c_24*z_42 + c_24*z_53 + c_24*((z_48*fabs(z_18) + z_47*z_53) + (z_42*fabs(cos_q3*cos_q5) +
        z_32*fabs(cos_q2*cos_q5) + z_50*fabs(z_19))) + (z_42*fabs(l*sin_q3) + z_38*fabs(l*cos_q2));
    const double z_54 = fabs(z_22);
    const double z_55 = (z_32*z_27 + z_31*z_28) + (z_36*fabs(z_15) + z_38*z_54 + z_34*z_40);
    const double z_56 = (z_30*fabs(z_23) + z_29*z_55) + (z_42*fabs(cos_q4*sin_q1) + z_44*fabs(cos_q2*sin_q1) +
        z_34*z_45);
    const double z_57 = fabs(z_24);
    const double z_58 = fabs(z_26);
    const double z_59 = (z_38*z_27 + z_37*z_28) + (z_36*fabs(z_3) + z_32*z_54 + z_34*z_51);
    terms[2] = c_24 + c_24*z_34 + c_24*z_56 + c_24*z_55 + c_24*((z_48*z_57 + z_47*z_56) + (z_50*z_58 + z_49*z_59))
        + (z_36*fabs(z_20) + z_34*z_52);
    terms[3] = (z_48*z_58 + z_47*z_59) + (z_50*z_57 + z_49*z_56);
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
                              double A1[N_ROWS][N1], double b[N_ROWS], double shared[58])
{
    const double l = c[1];
    const double c_3 = c[6];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double q4 = x[3];
    const double cos_q4 = em_cos(q4);
    const double z_2 = cos_q2*cos_q4;
    const double sin_q4 = em_sin(q4);
    const double sin_q2 = em_sin(q2);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_6 = sin_q2*sin_q3;
    const double z_7 = z_2 - sin_q4*z_6;
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double cos_q5 = em_cos(q5);
    const double cos_q3 = em_cos(q3);
    const double z_11 = sin_q2*cos_q3;
    const double z_12 = cos_q5*z_11;
    const double z_13 = l*sin_q2;
    const double z_14 = l - z_13;
    const double z_15 = l*z_6 + z_14;
    const double z_16 = l*z_7 - z_15;
    const double z_17 = l*(z_7*sin_q5 + z_12) - z_16;
    const double c_2 = c[5];
    const double c_4 = c[7];
    const double c_1 = c[4];
    const double z_18 = -z_16;
    const double z_19 = c_3 + z_17*c_2 + z_14*c_4 + z_15*c_1 + z_18*c_1;
    const double z_20 = sin_q3*cos_q5;
    const double z_21 = sin_q4*cos_q3;
    const double z_22 = cos_q3 + z_21;
    const double z_23 = l*(z_22 - (z_20 + sin_q5*z_21));
    const double z_24 = z_23*c_2;
    const double z_25 = l*z_22;
    const double c_0 = c[3];
    const double m = c[0];
    const double z_26 = m*(2.0*z_23 + z_25);
    const double z_27 = sin_q5*z_26;
    const double z_28 = l*((c_3*cos_q3 + z_24 + z_25*c_4) - z_27);
    const double z_29 = sin_q4*z_28;
    const double z_30 = l*(z_24 + z_25*c_1 + cos_q3*c_0) + z_29;
    const double z_31 = cos_q3*z_30;
    const double z_32 = m*(2.0*z_17 + z_18);
    const double z_33 = sin_q5*z_32;
    const double z_34 = l*(m*(3.0*z_17 + z_15 + 5.0*z_18) - z_33);
    const double z_35 = l*(m*(3.0*z_17 + z_14 + 5.0*z_15 + 6.0*z_18)) + sin_q4*z_34;
    const double z_36 = l*cos_q5;
    const double z_37 = sin_q3*z_36;
    const double c_9 = c[12];
    M1[0][0] = (1.0/6.0)*(l*z_19 + z_31 + c_3*z_14 + z_35*z_6 + z_11*(z_32*z_36) + c_9 - z_13*z_19 - z_2*z_34 -
        z_26*z_37);
    const double z_38 = cos_q4*sin_q2;
    const double z_39 = cos_q2*sin_q3;
    const double z_40 = cos_q3*z_36;
    const double z_41 = cos_q2*z_26;
    const double c_6 = c[9];
    const double c_7 = c[10];
    const double z_42 = m*z_23 + z_25*c_6 + cos_q3*c_7;
    const double c_8 = c[11];
    M1[0][1] = M1[1][0] = ((-1.0/6.0))*(cos_q2*z_42*c_8 - z_28*z_38 - z_30*z_39 - z_40*z_41);
    const double z_43 = l - l*sin_q3;
    const double z_44 = cos_q3*cos_q5;
    const double z_45 = sin_q3*sin_q4;
    const double z_46 = l*z_45 - z_43;
    const double z_47 = -l*(z_44 - sin_q5*z_45) - z_46;
    const double z_48 = -z_46;
    const double z_49 = z_47*c_2 + z_48*c_1;
    const double z_50 = m*(2.0*z_47 + z_48);
    const double z_51 = l*(m*(3.0*z_47 + z_43 + 5.0*z_48) - sin_q5*z_50);
    const double z_52 = sin_q4*z_51;
    const double z_53 = l*(c_3 + z_43*c_4 + z_49) + z_52;
    const double z_54 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_55 = c_3*cos_q4 + z_54*c_6;
    const double z_56 = sin_q5*z_55;
    const double z_57 = l*((z_54*c_2 + cos_q4*c_0) - z_56);
    const double z_58 = cos_q4*z_57;
    M1[1][1] = ((-1.0/6.0))*(sin_q3*z_53 + z_50*z_40 - l*(c_0 + z_43*c_1 + z_49) - z_58);
    M1[0][2] = M1[2][0] = (1.0/6.0)*(sin_q3*z_35 + z_30*z_11 + z_32*z_40 - z_6*(z_26*z_36));
    const double z_59 = m*z_54 + cos_q4*c_7;
    M1[1][2] = M1[2][1] = (1.0/6.0)*(z_21*z_57 + cos_q3*z_59*c_8 - z_55*z_37);
    const double z_60 = l*sin_q5;
    const double z_61 = l + l*sin_q4;
    const double z_62 = z_61 - sin_q4*z_60;
    const double z_63 = z_62*c_2;
    const double z_64 = m*(2.0*z_62 + z_61);
    const double z_65 = l*((c_3 + z_63 + z_61*c_4) - sin_q5*z_64);
    const double c_11 = c[14];
    const double z_66 = cos_q5*cos_q5;
    const double z_67 = c_11*z_66;
    M1[2][2] = (1.0/6.0)*(l*(c_0 + z_63 + z_61*c_1) + sin_q4*z_65 + z_67);
    const double z_68 = cos_q4*cos_q3;
    const double z_69 = cos_q2*sin_q4;
    const double z_70 = cos_q4*z_28;
    M1[0][3] = M1[3][0] = ((-1.0/6.0))*(z_34*z_68 - z_28*z_69 - z_6*z_70);
    M1[1][3] = M1[3][1] = ((-1.0/6.0))*(z_52 - sin_q3*z_58);
    const double c_5 = c[8];
    const double z_71 = c_5*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    M1[2][3] = M1[3][2] = ((-1.0/6.0))*(cos_q4*z_71);
    const double z_72 = l - z_60;
    const double z_73 = c_3 + z_72*c_6;
    M1[3][3] = (1.0/6.0)*(l*((c_0 + z_72*c_2) - sin_q5*z_73));
    const double z_74 = z_7*z_26;
    const double z_75 = sin_q3*sin_q5;
    const double z_76 = z_26*z_11;
    const double z_77 = sin_q4*cos_q5;
    const double z_78 = cos_q3*z_77;
    M1[0][4] = M1[4][0] = (1.0/6.0)*(l*(cos_q5*z_74 + z_32*z_78 - z_32*z_75 - sin_q5*z_76));
    const double z_79 = cos_q4*z_50;
    const double z_80 = sin_q5*cos_q3;
    const double z_81 = sin_q3*z_77;
    M1[1][4] = M1[4][1] = ((-1.0/6.0))*(l*(cos_q5*z_79 + z_55*z_80 + z_55*z_81));
    M1[2][4] = M1[4][2] = ((-1.0/6.0))*(z_64*z_60 - sin_q4*z_67);
    M1[3][4] = M1[4][3] = 0.0;
    const double c_23 = c[26];
    M1[4][4] = c_23;
    const double z_82 = sin_q4*z_72;
    const double z_83 = l + z_82;
    const double z_84 = cos_q3*z_83 - z_37;
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double z_86 = z_2*z_72;
    const double z_87 = z_14 + z_83*z_6 + z_36*z_11 - z_86;
    const double sin_q1 = em_sin(q1);
    A1[0][0] = z_84*cos_q1 - z_87*sin_q1;
    const double z_89 = z_83*cos_q1;
    const double z_90 = z_72*z_38;
    A1[0][1] = -(cos_q2*(l*cos_q1 - sin_q3*z_89 - cos_q1*z_40) - cos_q1*z_90);
    const double z_91 = cos_q1*z_36;
    A1[0][2] = -(sin_q3*(z_83*sin_q1 + sin_q2*z_91) + cos_q3*(sin_q1*z_36 - sin_q2*z_89));
    const double z_92 = cos_q3*sin_q1 + cos_q1*z_6;
    const double z_93 = cos_q4*z_72;
    const double z_94 = z_72*z_69;
    A1[0][3] = z_92*z_93 + cos_q1*z_94;
    const double z_95 = sin_q3*sin_q1;
    A1[0][4] = l*(sin_q5*(z_95 - cos_q1*z_11) - cos_q5*(sin_q4*z_92 - z_2*cos_q1));
    A1[1][0] = 0.0;
    A1[1][1] = -(z_86 + sin_q2*(z_43 - z_40 - z_72*z_45));
    A1[1][2] = -(cos_q3*(l*cos_q2 + z_94) - cos_q2*z_37);
    A1[1][3] = sin_q2*z_82 - sin_q3*z_86;
    A1[1][4] = l*(cos_q5*(z_38 + cos_q2*z_45) + cos_q2*z_80);
    A1[2][0] = -(z_84*sin_q1 + cos_q1*z_87);
    A1[2][1] = cos_q2*(l*sin_q1 - z_83*z_95 - sin_q1*z_40) - sin_q1*z_90;
    const double z_96 = sin_q2*sin_q1;
    A1[2][2] = -(sin_q3*(z_89 - z_36*z_96) + cos_q3*(z_91 + z_83*z_96));
    const double z_97 = cos_q3*cos_q1 - sin_q1*z_6;
    A1[2][3] = z_97*z_93 - sin_q1*z_94;
    const double z_98 = sin_q3*cos_q1 + sin_q1*z_11;
    const double z_99 = sin_q4*z_97 + z_2*sin_q1;
    A1[2][4] = l*(sin_q5*z_98 - cos_q5*z_99);
    A1[3][0] = cos_q1*(sin_q5*z_11 + z_6*z_77 - z_2*cos_q5) - sin_q1*(z_75 - z_78);
    A1[3][1] = cos_q2*(sin_q1*z_80 + sin_q1*z_81) + cos_q5*sin_q1*z_38;
    A1[3][2] = cos_q3*(sin_q5*cos_q1 + z_77*z_96) - sin_q3*(sin_q5*z_96 - cos_q1*z_77);
    const double z_100 = cos_q4*cos_q5;
    A1[3][3] = -(z_97*z_100 - cos_q2*sin_q1*z_77);
    A1[3][4] = sin_q5*z_99 + cos_q5*z_98;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    shared[0] = cos_q2;
    shared[1] = z_11;
    shared[2] = sin_q3;
    shared[3] = sin_q5;
    shared[4] = sin_q4;
    shared[5] = z_38;
    shared[6] = z_45;
    shared[7] = cos_q4;
    shared[8] = z_6;
    shared[9] = z_7;
    shared[10] = cos_q5;
    shared[11] = z_44;
    shared[12] = sin_q2;
    shared[13] = z_30;
    shared[14] = cos_q3;
    shared[15] = z_80;
    shared[16] = z_78;
    shared[17] = z_28;
    shared[18] = z_26;
    shared[19] = z_19;
    shared[20] = z_34;
    shared[21] = z_2;
    shared[22] = z_32;
    shared[23] = z_35;
    shared[24] = z_20;
    shared[25] = z_12;
    shared[26] = z_42;
    shared[27] = z_70;
    shared[28] = z_39;
    shared[29] = z_76;
    shared[30] = z_41;
    shared[31] = z_53;
    shared[32] = z_81;
    shared[33] = z_75;
    shared[34] = z_51;
    shared[35] = z_50;
    shared[36] = z_57;
    shared[37] = z_55;
    shared[38] = z_31;
    shared[39] = z_59;
    shared[40] = z_21;
    shared[41] = z_65;
    shared[42] = z_77;
    shared[43] = z_64;
    shared[44] = z_68;
    shared[45] = z_29;
    shared[46] = z_69;
    shared[47] = z_58;
    shared[48] = z_71;
    shared[49] = z_66;
    shared[50] = z_73;
    shared[51] = z_36;
    shared[52] = z_74;
    shared[53] = z_33;
    shared[54] = z_27;
    shared[55] = z_79;
    shared[56] = z_100;
    shared[57] = z_56;
}

/* Mdot */
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[58],
                             double Mdot1[N1][N1])
{
    const double l = c[1];
    const double c_0 = c[3];
    const double q2_dot = v[1];
    const double cos_q2 = shared[0];
    const double z_101 = q2_dot*cos_q2;
    const double q3_dot = v[2];
    const double z_11 = shared[1];
    const double z_102 = q3_dot*z_11;
    const double sin_q3 = shared[2];
    const double z_103 = sin_q3*z_101;
    const double z_104 = l*z_101 - l*(z_102 + z_103);
    const double c_1 = c[4];
    const double sin_q5 = shared[3];
    const double q4_dot = v[3];
    const double sin_q4 = shared[4];
    const double z_105 = q4_dot*sin_q4;
    const double z_106 = cos_q2*z_105;
    const double z_38 = shared[5];
    const double z_107 = q2_dot*z_38;
    const double z_45 = shared[6];
    const double cos_q4 = shared[7];
    const double z_108 = q4_dot*cos_q4;
    const double z_6 = shared[8];
    const double z_109 = (z_106 + z_107) + (z_101*z_45 + sin_q4*z_102 + z_108*z_6);
    const double z_7 = shared[9];
    const double q5_dot = v[4];
    const double cos_q5 = shared[10];
    const double z_110 = q5_dot*cos_q5;
    const double z_44 = shared[11];
    const double sin_q2 = shared[12];
    const double z_111 = q3_dot*sin_q3;
    const double z_112 = sin_q2*z_111;
    const double z_113 = cos_q5*z_112;
    const double z_114 = q5_dot*sin_q5;
    const double z_115 = l*z_109 - z_104;
    const double z_116 = l*((sin_q5*z_109 - z_7*z_110) - (z_44*z_101 - z_113 - z_11*z_114)) - z_115;
    const double c_2 = c[5];
    const double z_117 = -z_115;
    const double z_118 = z_116*c_2 + z_117*c_1;
    const double z_119 = c_0*z_101 + z_104*c_1 + z_118;
    const double z_30 = shared[13];
    const double cos_q3 = shared[14];
    const double z_120 = q3_dot*cos_q3;
    const double z_121 = cos_q5*z_120;
    const double z_122 = sin_q3*z_114;
    const double z_80 = shared[15];
    const double z_78 = shared[16];
    const double z_123 = sin_q4*z_111;
    const double z_124 = cos_q3*z_108;
    const double z_125 = l*z_111 - l*(z_124 - z_123);
    const double z_126 = l*((z_121 - z_122) + (z_108*z_80 + q5_dot*z_78 - sin_q5*z_123)) + z_125;
    const double z_127 = z_126*c_2;
    const double z_28 = shared[17];
    const double z_128 = z_28*z_108;
    const double c_3 = c[6];
    const double c_4 = c[7];
    const double z_26 = shared[18];
    const double m = c[0];
    const double z_129 = m*(2.0*z_126 + z_125);
    const double z_130 = sin_q5*z_129;
    const double z_131 = l*(c_3*z_111 + z_127 + z_125*c_4) + l*(z_26*z_110 - z_130);
    const double z_132 = l*(z_127 + z_125*c_1 + c_0*z_111) - (z_128 - sin_q4*z_131);
    const double z_19 = shared[19];
    const double z_34 = shared[20];
    const double z_2 = shared[21];
    const double z_32 = shared[22];
    const double z_133 = z_32*z_110;
    const double z_134 = m*(2.0*z_116 + z_117);
    const double z_135 = l*(m*(3.0*z_116 + z_104 + 5.0*z_117)) + l*(z_133 - sin_q5*z_134);
    const double c_5 = c[8];
    const double z_35 = shared[23];
    const double z_136 = l*(c_3*z_101 + z_104*c_4 + z_118) - (z_34*z_108 - sin_q4*z_135);
    const double z_20 = shared[24];
    const double z_137 = z_32*z_44;
    const double z_12 = shared[25];
    Mdot1[0][0] = ((-1.0/6.0))*(l*z_119 + (z_30*z_111 + cos_q3*z_132) + l*(z_19*z_101 - sin_q2*z_119) + c_5*z_101
        + l*(z_26*z_121 - z_26*z_122 - z_20*z_129) - (z_34*z_107 + z_34*z_106 + z_2*z_135) - (z_35*z_103 +
        z_35*z_102 - z_136*z_6) - l*(z_101*z_137 - z_32*z_113 - z_114*(z_32*z_11) - z_12*z_134));
    const double z_42 = shared[26];
    const double z_138 = q2_dot*sin_q2;
    const double c_6 = c[9];
    const double c_7 = c[10];
    const double z_139 = z_28*z_105;
    const double z_70 = shared[27];
    const double z_39 = shared[28];
    const double z_76 = shared[29];
    const double z_140 = cos_q5*z_111;
    const double z_41 = shared[30];
    const double z_141 = cos_q3*z_114;
    Mdot1[0][1] = Mdot1[1][0] = (1.0/6.0)*(3.0*l*(z_42*z_138 + cos_q2*(m*z_126 + z_125*c_6 + c_7*z_111)) -
        (sin_q2*z_139 + z_38*z_131 - z_101*z_70) - (q2_dot*z_30*z_6 + z_132*z_39 - cos_q2*z_30*z_120) -
        l*(cos_q5*(q2_dot*z_76) + z_140*z_41 + z_141*z_41 + z_44*(cos_q2*z_129)));
    const double z_53 = shared[31];
    const double z_81 = shared[32];
    const double z_142 = sin_q4*z_120;
    const double z_75 = shared[33];
    const double z_143 = l*z_120 + l*(sin_q3*z_108 + z_142);
    const double z_144 = z_143 - l*((z_140 + z_141) + (q5_dot*z_81 + sin_q5*z_142 + z_75*z_108));
    const double z_145 = z_144*c_2;
    const double z_51 = shared[34];
    const double z_50 = shared[35];
    const double z_146 = m*(2.0*z_144 + z_143);
    const double z_147 = z_51*z_108 - sin_q4*(l*(c_3*z_120 + z_145 + z_143*c_4) + l*(z_50*z_110 - sin_q5*z_146));
    const double z_57 = shared[36];
    const double z_148 = z_57*z_105;
    const double z_149 = l*z_105 - l*(sin_q5*z_105 - cos_q4*z_110);
    const double z_55 = shared[37];
    const double z_150 = z_55*z_110;
    const double z_151 = c_3*z_105 + z_149*c_6;
    const double z_152 = l*(z_149*c_2 + c_0*z_105) + l*(z_150 - sin_q5*z_151);
    const double z_153 = cos_q4*z_152;
    const double c_8 = c[11];
    Mdot1[1][1] = ((-1.0/6.0))*((z_53*z_120 - sin_q3*(l*(z_145 + c_0*z_120 + z_143*c_1) - z_147)) + (z_148 +
        z_153) + (m*z_144 + c_7*z_120 + z_143*c_6)*c_8 - l*(z_50*z_140 + z_50*z_141 + z_44*z_146));
    const double z_31 = shared[38];
    const double z_154 = z_26*z_101;
    Mdot1[0][2] = Mdot1[2][0] = (1.0/6.0)*((z_35*z_120 - sin_q3*z_136) + (z_31*z_101 - z_30*z_112 - z_132*z_11) -
        l*(z_32*z_140 + z_32*z_141 + z_44*z_134) - l*(z_20*z_154 + cos_q5*(q3_dot*z_76) - z_114*(z_26*z_6) -
        cos_q5*(z_129*z_6)));
    const double z_59 = shared[39];
    const double z_21 = shared[40];
    Mdot1[1][2] = Mdot1[2][1] = ((-1.0/6.0))*(3.0*l*(z_59*z_111 + cos_q3*(m*z_149 + c_7*z_105)) + l*(z_55*z_121 -
        z_55*z_122 - z_20*z_151) - (z_57*z_124 - z_57*z_123 - z_21*z_152));
    const double z_65 = shared[41];
    const double z_77 = shared[42];
    const double z_155 = l*z_108 - l*(q5_dot*z_77 + sin_q5*z_108);
    const double z_64 = shared[43];
    const double z_156 = l*(z_64*z_110 + sin_q5*(c_3*z_108 + z_155*c_6));
    const double c_9 = c[12];
    const double z_157 = cos_q5*z_114;
    Mdot1[2][2] = (1.0/6.0)*((z_65*z_108 + sin_q4*(l*(z_155*c_2 + c_0*z_108) - z_156)) + (m*z_155 + c_7*z_108)*c_8
        - c_9*z_157);
    const double z_68 = shared[44];
    const double z_29 = shared[45];
    const double z_69 = shared[46];
    Mdot1[0][3] = Mdot1[3][0] = (1.0/6.0)*((cos_q3*z_34*z_105 + cos_q4*z_34*z_111 + z_135*z_68) - (z_29*z_138 +
        z_131*z_69 - cos_q2*z_128) - (z_6*z_139 + cos_q4*z_131*z_6 - z_103*z_70 - z_102*z_70));
    const double z_58 = shared[47];
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/6.0))*(z_147 + (sin_q3*z_148 + sin_q3*z_153 - z_58*z_120));
    const double z_71 = shared[48];
    const double z_66 = shared[49];
    const double c_10 = c[13];
    Mdot1[2][3] = Mdot1[3][2] = (1.0/6.0)*(z_71*z_105 + cos_q4*(2.0*c_5*(q5_dot*z_66 - q5_dot*(sin_q5*sin_q5)) +
        c_10*z_114));
    const double z_73 = shared[50];
    const double z_36 = shared[51];
    const double c_11 = c[14];
    Mdot1[3][3] = ((-1.0/6.0))*(c_10*z_110 - (c_11*z_157 - z_73*(q5_dot*z_36)));
    const double z_74 = shared[52];
    const double z_33 = shared[53];
    const double z_27 = shared[54];
    Mdot1[0][4] = Mdot1[4][0] = ((-1.0/6.0))*(l*(cos_q5*z_26*z_109 + z_114*z_74 + cos_q5*(z_7*z_129)) +
        l*(z_33*z_120 + sin_q3*z_133 - z_75*z_134) + l*(z_80*z_154 + z_110*z_76 - z_27*z_112 - z_130*z_11) -
        l*(z_108*z_137 - z_32*z_111*z_77 - z_114*(z_21*z_32) - z_78*z_134));
    const double z_79 = shared[55];
    const double z_100 = shared[56];
    const double z_56 = shared[57];
    Mdot1[1][4] = Mdot1[4][1] = (1.0/6.0)*(l*(q4_dot*z_50*z_77 + z_114*z_79 + z_146*z_100) - l*(cos_q3*z_150 -
        z_56*z_111 - z_151*z_80) - l*(z_55*z_120*z_77 + z_20*z_55*z_108 - z_114*(z_55*z_45) - z_151*z_81));
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/6.0))*(z_156 - 2.0*c_5*(z_66*z_108 - 2.0*z_114*z_77));
    Mdot1[3][4] = Mdot1[4][3] = 0.0;
    Mdot1[4][4] = 0.0;
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
    double M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[58];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = INFINITY, delta_gap = INFINITY;
    gap = fmin(gap, em_gap(N1, y + 35));
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

static const char *const coordinate_names[] = { "q1", "q2", "q3", "q4", "q5", NULL };
static const char *const parameter_names[] = { "m", "l", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 3},
    {"ground", 3, 3},
    {"line", 6, 6},
    {"line", 12, 6},
    {"line", 18, 6},
    {"line", 24, 6},
    {"line", 30, 6},
    {"disk", 36, 4},
    {"disk", 40, 4},
    {"disk", 44, 4},
    {"disk", 48, 4},
    {"disk", 52, 4},
    {"disk", 56, 4},
    {"trace", 60, 3}
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
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dq1: M does not depend on it",
    NULL
};

const em_model bricard_model = {
    .abi = EM_ABI,
    .name = "bricard",
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
    .lanes = &bricard_lanes,
    .n_shapes = 14,
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
};

#endif
#endif
