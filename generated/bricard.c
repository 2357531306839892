/* eigenmotion generate bricard.py */
/* input sha256:84c95ed96c00d0f879f20a64f2de802bc07fecba092ce5dcb4db62e1a3957270 */
/* body sha256:5a0142c8a55e98768a5a4baf478a8017756d080de902bdae66a1ea166075cda1 */
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
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 5,                /* coordinates */
    N_ROWS = 4,           /* constraint rows */
    N_POSITIONS = 4,      /* of which holonomic */
    N_STATE = 40,         /* numbers of a state */
    N_C = 25,             /* of which C, */
    N_S = 5,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 30,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 3,
    N_PREPARED = 31,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 4,          /* inputs, parameters and the time */
    N_ARGUMENTS = 14,     /* x, v and these: what motion depends on */
    N1 = 5,               /* q1, q2, q3, q4, q5 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_BY_ITSELF void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                     real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real l = c[1];
    const real c_4 = c[7];
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
    const real c_3 = c[6];
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
    const real c_1 = c[4];
    const real z_34 = -z_32;
    const real z_35 = z_33*c_1 + z_34*c_3;
    const real z_36 = c_4*z_1 + z_9*c_3 + z_35;
    const real z_37 = sin_q3*cos_q5;
    const real z_38 = sin_q5*cos_q3;
    const real z_39 = sin_q4*cos_q3;
    const real z_40 = cos_q3 + z_39;
    const real z_41 = l*(z_40 - (z_37 + sin_q4*z_38));
    const real z_42 = z_41*c_1;
    const real z_43 = l*z_40;
    const real c_0 = c[3];
    const real c_2 = c[5];
    const real m = c[0];
    const real z_44 = m*(2.0*z_41 + z_43);
    const real z_45 = l*((c_0*cos_q3 + z_42 + z_43*c_2) - sin_q5*z_44);
    const real z_46 = sin_q4*z_45;
    const real z_47 = l*(z_42 + z_43*c_3 + cos_q3*c_4) + z_46;
    const real z_48 = z_47*z_27;
    const real z_49 = cos_q5*z_5;
    const real z_50 = sin_q3*z_29;
    const real z_51 = z_49 - z_50;
    const real z_52 = sin_q4*z_25;
    const real z_53 = sin_q5*z_27;
    const real z_54 = cos_q3*z_18;
    const real z_55 = l*z_27 - l*(z_54 - sin_q4*z_27);
    const real z_56 = l*(z_51 + (z_18*z_38 + cos_q3*z_52 - sin_q4*z_53)) + z_55;
    const real z_57 = z_56*c_1;
    const real z_58 = z_44*z_25;
    const real z_59 = m*(2.0*z_56 + z_55);
    const real z_60 = sin_q5*z_59;
    const real z_61 = l*(c_0*z_27 + z_57 + z_55*c_2) + l*(z_58 - z_60);
    const real z_62 = l*(z_57 + z_55*c_3 + c_4*z_27) - (z_45*z_18 - sin_q4*z_61);
    const real z_63 = cos_q5*z_30;
    const real z_64 = l*sin_q2;
    const real z_65 = l - z_64;
    const real z_66 = l*z_19 + z_65;
    const real z_67 = l*z_23 - z_66;
    const real z_68 = l*(z_23*sin_q5 + z_63) - z_67;
    const real z_69 = -z_67;
    const real z_70 = c_0 + z_68*c_1 + z_65*c_2 + z_66*c_3 + z_69*c_3;
    const real z_71 = m*(2.0*z_68 + z_69);
    const real z_72 = l*(m*(3.0*z_68 + z_66 + 5.0*z_69) - sin_q5*z_71);
    const real z_73 = m*(2.0*z_33 + z_34);
    const real z_74 = l*(m*(3.0*z_33 + z_9 + 5.0*z_34)) + l*(z_71*z_25 - sin_q5*z_73);
    const real c_10 = c[13];
    const real z_75 = l*(m*(3.0*z_68 + z_65 + 5.0*z_66 + 6.0*z_69)) + sin_q4*z_72;
    const real z_76 = z_72*z_18;
    const real z_77 = l*(c_0*z_1 + z_9*c_2 + z_35) - (z_76 - sin_q4*z_74);
    const real z_78 = z_71*z_26;
    const real z_79 = sin_q2*z_71;
    const real z_80 = z_71*z_30;
    Mdot1[0][0] = ((-1.0/6.0))*(l*z_36 + (z_48 + cos_q3*z_62) + l*(z_70*z_1 - sin_q2*z_36) + c_10*z_1 +
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
    const real z_97 = l*(c_0 + z_93*c_1 + z_91*c_2 + z_94*c_3) + sin_q4*z_96;
    const real z_98 = z_28 + z_89;
    const real z_99 = sin_q5*z_5;
    const real z_100 = sin_q3*z_18;
    const real z_101 = l*z_5;
    const real z_102 = z_101 + l*(z_100 + sin_q4*z_5);
    const real z_103 = z_102 - l*(z_98 + (z_25*z_17 + sin_q4*z_99 + sin_q5*z_100));
    const real z_104 = z_103*c_1;
    const real z_105 = m*(2.0*z_103 + z_102);
    const real z_106 = z_96*z_18 - sin_q4*(l*(c_0*z_5 + z_104 + z_102*c_2) + l*(z_95*z_25 - sin_q5*z_105));
    const real z_107 = l*(cos_q4 - cos_q4*sin_q5);
    const real z_108 = c_0*cos_q4;
    const real z_109 = z_108 + z_107*c_6;
    const real z_110 = l*((z_107*c_1 + cos_q4*c_4) - sin_q5*z_109);
    const real z_111 = l*z_12 - l*(sin_q5*z_12 - cos_q4*z_25);
    const real z_112 = c_0*z_12 + z_111*c_6;
    const real z_113 = l*(z_111*c_1 + c_4*z_12) + l*(z_109*z_25 - sin_q5*z_112);
    const real z_114 = cos_q4*z_113;
    const real c_8 = c[11];
    Mdot1[1][1] = ((-1.0/6.0))*((z_97*z_5 - sin_q3*(l*(z_104 + c_4*z_5 + z_102*c_3) - z_106)) + (z_110*z_12 +
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
    const real z_124 = l*((c_0 + z_122*c_1 + z_121*c_2) - sin_q5*z_123);
    const real z_125 = l*z_18 - l*(z_52 + sin_q5*z_18);
    const real z_126 = l*(z_123*z_25 + sin_q5*(c_0*z_18 + z_125*c_6));
    const real c_5 = c[8];
    const real z_127 = cos_q5*c_5;
    Mdot1[2][2] = (1.0/6.0)*((z_124*z_18 + sin_q4*(l*(z_125*c_1 + c_4*z_18) - z_126)) + (m*z_125 + c_7*z_18)*c_8 -
        z_29*z_127);
    const real z_128 = cos_q4*z_72;
    const real z_129 = cos_q2*z_18;
    const real z_130 = cos_q2*sin_q4;
    Mdot1[0][3] = Mdot1[3][0] = (1.0/6.0)*((cos_q3*z_72*z_12 + z_27*z_128 + cos_q4*cos_q3*z_74) - (z_46*z_15 +
        z_61*z_130 - z_45*z_129) - (z_45*z_12*z_19 + cos_q4*z_61*z_19 - z_8*z_83 - z_6*z_83));
    const real z_131 = sin_q3*z_110;
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/6.0))*(z_106 + (z_12*z_131 + sin_q3*z_114 - cos_q4*z_110*z_5));
    const real z_132 = c_10*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    const real z_133 = cos_q5*cos_q5;
    const real z_134 = q5_dot*z_133;
    const real c_12 = c[15];
    Mdot1[2][3] = Mdot1[3][2] = (1.0/6.0)*(z_132*z_12 + cos_q4*(2.0*c_10*(z_134 - q5_dot*(sin_q5*sin_q5)) +
        c_12*z_29));
    const real z_135 = l - z_119;
    const real z_136 = c_0 + z_135*c_6;
    const real z_137 = l*cos_q5;
    const real z_138 = q5_dot*z_137;
    const real c_9 = c[12];
    Mdot1[3][3] = ((-1.0/6.0))*(c_12*z_25 - (cos_q5*c_9*z_29 - z_136*z_138));
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
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/6.0))*(z_126 - 2.0*c_10*(z_133*z_18 - 2.0*z_29*z_141));
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real c_13 = c[16];
    const real c_14 = c[17];
    const real z_149 = c_14 - sin_q5*c_13;
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
    const real c_15 = c[18];
    const real z_161 = z_156*c_15 - z_158 - 6.0*z_160;
    const real z_162 = l*(2.0*z_52*z_155 + 2.0*q1_dot*z_49 + z_63*z_152 + sin_q5*z_157 - 2.0*q1_dot*z_50);
    const real c_16 = c[19];
    const real z_163 = z_162 + z_156*c_16 - 6.0*z_160 - z_157*c_15;
    const real z_164 = 2.0*z_162 + z_156*c_8 - 3.0*z_160 - z_157*c_8;
    const real z_165 = z_163 + z_164;
    const real z_166 = m*(z_161 + z_165);
    const real z_167 = c_0*z_164;
    const real z_168 = c_0*sin_q5;
    const real c_17 = c[20];
    const real z_169 = z_44*c_17;
    const real z_170 = q1_dot*z_169;
    const real z_171 = z_164*z_168 + z_25*z_170 - l*(m*z_165);
    const real z_172 = q1_dot*q2_dot;
    const real c_18 = c[21];
    const real c_19 = c[22];
    const real c_20 = c[23];
    const real z_173 = cos_q5*z_155;
    f1[1] = (1.0/12.0)*(cos_q2*(6.0*cos_q4*z_149 + 2.0*z_100*z_150 + 2.0*q1_dot*z_47*z_5 + 2.0*z_151*z_150 +
        z_152*(z_71*z_153) + sin_q3*z_75*z_152 + z_90*z_166 + z_26*z_167 - z_70*z_154 - l*(m*z_163 + m*z_161 +
        (c_0*z_152 + m*(l*z_156 - 5.0*z_160)) + m*z_164) - z_171*z_17 - z_29*z_155*z_169 - z_28*z_170) -
        sin_q2*(6.0*z_149*z_17 + 2.0*z_12*z_150 + 2.0*z_172*z_85 + cos_q4*z_171 + c_18 + sin_q3*c_19 + z_26*c_20 +
        q2_dot*z_169*z_173 - z_152*z_128 - z_81*c_16*z_172));
    const real z_174 = q2_dot*q3_dot;
    const real z_175 = q2_dot*q2_dot;
    const real z_176 = z_95*z_175;
    const real z_177 = q2_dot*q4_dot;
    const real z_178 = sin_q3*z_175;
    const real z_179 = 2.0*z_177 + z_178;
    const real z_180 = sin_q4*z_179;
    const real z_181 = l*(2.0*z_25*z_151 + z_26*z_175 - sin_q5*z_180);
    const real z_182 = c_8*z_175 - 2.0*z_181 - z_180*c_8 - z_178*c_8;
    const real z_183 = c_0*z_182;
    const real z_184 = q1_dot*sin_q2;
    const real z_185 = 2.0*z_5*z_184 + 2.0*q1_dot*z_8 + cos_q3*z_152;
    const real z_186 = 2.0*z_100*z_184 + 2.0*q1_dot*z_13 + 2.0*z_184*z_151 + sin_q4*z_185;
    const real z_187 = q1_dot*z_1;
    const real z_188 = q1_dot*z_23;
    const real z_189 = l*(2.0*z_89*z_184 + 2.0*z_28*z_184 + z_37*z_152 + sin_q5*z_186 - 2.0*z_25*z_188 -
        2.0*z_1*z_173);
    const real c_21 = c[24];
    const real z_190 = 2.0*z_189 + z_187*c_16 - z_186*c_8 - z_185*c_8;
    const real z_191 = m*((z_189 + z_187*c_21 - z_186*c_15 - z_185*c_16) + z_190);
    const real z_192 = sin_q4*z_168;
    const real z_193 = c_17*(q2_dot*z_109);
    const real z_194 = c_17*(q1_dot*z_71);
    const real z_195 = z_184*z_169;
    const real z_196 = q3_dot*cos_q5;
    const real z_197 = (c_16*z_175 - z_181 - z_180*c_15 - z_178*c_16) + z_182;
    const real z_198 = m*z_197;
    const real z_199 = z_45*z_184;
    const real z_200 = c_0*z_190;
    f1[2] = ((-1.0/12.0))*(sin_q3*(2.0*z_174*z_118 + 2.0*z_47*(q3_dot*z_184) + z_152*z_137*z_79 + z_47*z_152 +
        z_190*z_192 + sin_q2*cos_q5*z_167 + c_20*(cos_q2*cos_q5) + c_16*(z_117*z_174) + z_52*z_194 + z_194*z_196 +
        cos_q5*z_187*z_169 - z_137*z_176 - cos_q5*z_183 - 2.0*q1_dot*z_76 - c_0*(l*(-(5.0*z_185 + z_186 -
        12.0*z_187))) - z_120*z_191 - l*z_191 - z_29*z_193 - z_29*z_195) - cos_q3*(6.0*z_149*z_130 +
        2.0*q2_dot*z_110*z_18 + z_182*z_192 + 2.0*z_18*z_199 + 2.0*q1_dot*q3_dot*z_75 + 2.0*z_47*z_187 +
        z_75*z_159 + cos_q5*z_200 + z_64*z_166 + cos_q2*c_19 - z_97*z_175 - z_120*z_198 - l*(m*(l*(6.0*z_175 -
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
    const real z_209 = c_17*z_25;
    const real z_210 = 2.0*q2_dot*z_100 + 2.0*sin_q4*z_207 + cos_q4*z_175;
    const real z_211 = l*(2.0*z_25*(q2_dot*z_17) + 2.0*q2_dot*z_89 + 2.0*q2_dot*z_28 + sin_q5*z_210);
    const real z_212 = c_16*z_207 + z_210*c_8 - 2.0*z_211;
    f1[3] = (1.0/12.0)*(cos_q4*(6.0*z_149*z_87 + z_124*z_201 + z_206*z_168 + 2.0*z_110*z_207 + sin_q3*z_182*z_168
        + 2.0*q4_dot*cos_q2*z_150 + z_72*z_156 + z_45*z_185 + z_38*z_200 + q3_dot*z_134*c_5 + z_71*z_155*z_209 -
        l*(m*(l*(-(6.0*z_202 + 5.0*z_203 - z_205)) + z_206)) - z_96*z_179 - z_90*z_198 - z_208*z_191 - z_171*z_19
        - z_139*z_193) + sin_q4*(2.0*q3_dot*q4_dot*z_132 + z_212*z_168 + 2.0*q4_dot*z_72*z_155 + cos_q2*z_72*z_152
        + q2_dot*z_95*z_209 - 6.0*sin_q2*z_149 - 2.0*z_177*z_131 - z_110*z_175 - c_0*(c_21*z_207 + z_210*c_15 -
        z_211) - c_0*z_212 - 2.0*q4_dot*sin_q3*z_199 - 2.0*q2_dot*z_199 - cos_q2*z_171));
    const real z_213 = cos_q2*cos_q3;
    const real c_22 = c[25];
    const real z_214 = q3_dot*z_18;
    const real c_23 = c[26];
    const real z_215 = q5_dot*c_17;
    const real z_216 = q4_dot*q4_dot;
    const real z_217 = z_84 + cos_q2*z_17;
    const real z_218 = q5_dot*cos_q3;
    f1[4] = ((-1.0/12.0))*(sin_q5*(z_154*z_80 + sin_q3*z_200 + z_30*z_167 + c_20*z_213 + q3_dot*z_52*c_22 +
        c_5*(sin_q5*z_214) + z_201*z_127 + z_155*z_143*z_215 + z_169*(q5_dot*z_188) + z_5*z_194 +
        z_169*(z_1*z_155) - z_208*z_176 - cos_q3*z_183 - z_44*z_90*z_152 - c_23*z_214 - q5_dot*z_17*z_193 -
        z_215*(z_95*z_151) - z_27*z_193 - z_27*z_195) + cos_q5*(z_136*(l*z_216) + l*z_123*z_204 + z_109*(l*z_210)
        + z_108*z_212 + z_186*(l*z_44) + z_217*c_20 + z_193*z_218 + z_195*z_218 + q5_dot*sin_q3*z_194 -
        c_0*(l*(-(3.0*z_216 - 2.0*sin_q5*z_216))) - c_0*sin_q4*z_206 - z_95*(z_120*z_179) - z_17*z_183 -
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
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 10, *const s1_dot = dy + 35;
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
    const real c_0 = c[3];
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
    const real c_1 = c[4];
    const real c_2 = c[5];
    const real c_3 = c[6];
    const real z_18 = -z_16;
    const real z_19 = c_0 + z_17*c_1 + z_14*c_2 + z_15*c_3 + z_18*c_3;
    const real z_20 = l*z_19;
    const real z_21 = sin_q3*cos_q5;
    const real z_22 = sin_q4*cos_q3;
    const real z_23 = cos_q3 + z_22;
    const real z_24 = l*(z_23 - (z_21 + sin_q5*z_22));
    const real z_25 = z_24*c_1;
    const real z_26 = l*z_23;
    const real c_4 = c[7];
    const real m = c[0];
    const real z_27 = m*(2.0*z_24 + z_26);
    const real z_28 = sin_q5*z_27;
    const real z_29 = l*((c_0*cos_q3 + z_25 + z_26*c_2) - z_28);
    const real z_30 = sin_q4*z_29;
    const real z_31 = l*(z_25 + z_26*c_3 + cos_q3*c_4) + z_30;
    const real z_32 = m*(2.0*z_17 + z_18);
    const real z_33 = l*(m*(3.0*z_17 + z_15 + 5.0*z_18) - sin_q5*z_32);
    const real z_34 = l*(m*(3.0*z_17 + z_14 + 5.0*z_15 + 6.0*z_18)) + sin_q4*z_33;
    const real z_35 = l*cos_q5;
    const real z_36 = z_27*z_35;
    const real z_37 = z_32*z_11;
    const real c_5 = c[8];
    M1[0][0] = (1.0/6.0)*(z_20 + cos_q3*z_31 + c_0*z_14 + z_34*z_6 + z_35*z_37 + c_5 - z_13*z_19 - z_2*z_33 -
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
    const real z_50 = z_48*c_1 + z_49*c_3;
    const real z_51 = m*(2.0*z_48 + z_49);
    const real z_52 = l*(m*(3.0*z_48 + z_44 + 5.0*z_49) - sin_q5*z_51);
    const real z_53 = sin_q4*z_52;
    const real z_54 = l*(c_0 + z_44*c_2 + z_50) + z_53;
    const real z_55 = l*(cos_q4 - cos_q4*sin_q5);
    const real z_56 = c_0*cos_q4;
    const real z_57 = z_56 + z_55*c_6;
    const real z_58 = l*((z_55*c_1 + cos_q4*c_4) - sin_q5*z_57);
    const real z_59 = cos_q4*z_58;
    M1[1][1] = ((-1.0/6.0))*(sin_q3*z_54 + z_51*z_40 - l*(c_4 + z_44*c_3 + z_50) - z_59);
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
    const real z_68 = z_67*c_1;
    const real z_69 = m*(2.0*z_67 + z_66);
    const real z_70 = l*((c_0 + z_68 + z_66*c_2) - sin_q5*z_69);
    const real c_9 = c[12];
    const real z_71 = cos_q5*cos_q5;
    const real z_72 = c_9*z_71;
    M1[2][2] = (1.0/6.0)*(l*(c_4 + z_68 + z_66*c_3) + sin_q4*z_70 + z_72);
    const real z_73 = cos_q4*z_33;
    const real z_74 = cos_q2*sin_q4;
    M1[3][0] = ((-1.0/6.0))*(cos_q3*z_73 - z_29*z_74 - z_6*z_38);
    M1[3][1] = ((-1.0/6.0))*(z_53 - sin_q3*z_59);
    const real c_10 = c[13];
    const real z_75 = c_10*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    M1[3][2] = ((-1.0/6.0))*(cos_q4*z_75);
    const real z_76 = l - z_64;
    const real z_77 = c_0 + z_76*c_6;
    M1[3][3] = (1.0/6.0)*(l*((c_4 + z_76*c_1) - sin_q5*z_77));
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
    const real c_11 = c[14];
    M1[4][4] = c_11;
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
EM_BY_ITSELF void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                    const real shared[66], real Mdot1[N1][N1], real f1[N1],
                                    real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real l = c[1];
    const real c_4 = c[7];
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
    const real c_3 = c[6];
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
    const real c_1 = c[4];
    const real z_105 = -z_103;
    const real z_106 = z_104*c_1 + z_105*c_3;
    const real z_107 = c_4*z_85 + z_90*c_3 + z_106;
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
    const real z_116 = z_115*c_1;
    const real z_29 = shared[16];
    const real c_0 = c[3];
    const real c_2 = c[5];
    const real z_27 = shared[17];
    const real z_117 = z_27*z_97;
    const real m = c[0];
    const real z_118 = m*(2.0*z_115 + z_114);
    const real z_119 = sin_q5*z_118;
    const real z_120 = l*(c_0*z_98 + z_116 + z_114*c_2) + l*(z_117 - z_119);
    const real z_121 = l*(z_116 + z_114*c_3 + c_4*z_98) - (z_29*z_95 - sin_q4*z_120);
    const real z_19 = shared[18];
    const real z_73 = shared[19];
    const real z_33 = shared[20];
    const real z_2 = shared[21];
    const real z_32 = shared[22];
    const real z_122 = m*(2.0*z_104 + z_105);
    const real z_123 = l*(m*(3.0*z_104 + z_90 + 5.0*z_105)) + l*(z_32*z_97 - sin_q5*z_122);
    const real c_10 = c[13];
    const real z_34 = shared[23];
    const real z_124 = l*(c_0*z_85 + z_90*c_2 + z_106) - (z_33*z_95 - sin_q4*z_123);
    const real z_78 = shared[24];
    const real z_21 = shared[25];
    const real z_125 = z_32*z_45;
    const real z_37 = shared[26];
    const real z_12 = shared[27];
    Mdot1[0][0] = ((-1.0/6.0))*(l*z_107 + (z_31*z_98 + cos_q3*z_121) + l*(z_19*z_85 - sin_q2*z_107) + c_10*z_85 +
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
    const real z_139 = z_138*c_1;
    const real z_52 = shared[33];
    const real z_51 = shared[34];
    const real z_140 = m*(2.0*z_138 + z_137);
    const real z_141 = z_52*z_95 - sin_q4*(l*(c_0*z_87 + z_139 + z_137*c_2) + l*(z_51*z_97 - sin_q5*z_140));
    const real z_58 = shared[35];
    const real z_142 = l*z_91 - l*(sin_q5*z_91 - cos_q4*z_97);
    const real z_57 = shared[36];
    const real z_143 = c_0*z_91 + z_142*c_6;
    const real z_144 = l*(z_142*c_1 + c_4*z_91) + l*(z_57*z_97 - sin_q5*z_143);
    const real z_145 = cos_q4*z_144;
    const real c_8 = c[11];
    Mdot1[1][1] = ((-1.0/6.0))*((z_54*z_87 - sin_q3*(l*(z_139 + c_4*z_87 + z_137*c_3) - z_141)) + (z_58*z_91 +
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
    const real z_149 = l*(z_69*z_97 + sin_q5*(c_0*z_95 + z_148*c_6));
    const real c_5 = c[8];
    const real z_150 = cos_q5*c_5;
    Mdot1[2][2] = (1.0/6.0)*((z_70*z_95 + sin_q4*(l*(z_148*c_1 + c_4*z_95) - z_149)) + (m*z_148 + c_7*z_95)*c_8 -
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
    const real c_12 = c[15];
    Mdot1[2][3] = Mdot1[3][2] = (1.0/6.0)*(z_75*z_91 + cos_q4*(2.0*c_10*(q5_dot*z_71 - q5_dot*(sin_q5*sin_q5)) +
        c_12*z_101));
    const real z_77 = shared[46];
    const real z_35 = shared[47];
    const real z_153 = q5_dot*z_35;
    const real c_9 = c[12];
    Mdot1[3][3] = ((-1.0/6.0))*(c_12*z_97 - (cos_q5*c_9*z_101 - z_77*z_153));
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
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/6.0))*(z_149 - 2.0*c_10*(z_71*z_95 - 2.0*z_101*z_80));
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    f1[0] = em_real(0.0);
    const real c_13 = c[16];
    const real c_14 = c[17];
    const real z_158 = c_14 - sin_q5*c_13;
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
    const real c_15 = c[18];
    const real z_169 = z_164*c_15 - z_166 - 6.0*z_168;
    const real z_170 = l*(2.0*z_111*z_163 + 2.0*q1_dot*z_108 + z_12*z_162 + sin_q5*z_165 - 2.0*q1_dot*z_109);
    const real c_16 = c[19];
    const real z_171 = z_170 + z_164*c_16 - 6.0*z_168 - z_165*c_15;
    const real z_172 = 2.0*z_170 + z_164*c_8 - 3.0*z_168 - z_165*c_8;
    const real z_173 = z_171 + z_172;
    const real z_174 = m*(z_169 + z_173);
    const real z_175 = c_0*z_172;
    const real z_176 = c_0*sin_q5;
    const real c_17 = c[20];
    const real z_177 = c_17*(q1_dot*z_27);
    const real z_178 = z_172*z_176 + z_97*z_177 - l*(m*z_173);
    const real z_179 = q1_dot*q2_dot;
    const real c_18 = c[21];
    const real c_19 = c[22];
    const real c_20 = c[23];
    f1[1] = (1.0/12.0)*(cos_q2*(6.0*cos_q4*z_158 + 2.0*z_135*z_159 + 2.0*z_87*z_160 + 2.0*z_159*z_161 + z_61*z_162
        + z_60*z_162 + z_43*z_174 + z_45*z_175 - z_20*z_162 - l*(m*z_171 + m*z_169 + (c_0*z_162 + m*(l*z_164 -
        5.0*z_168)) + m*z_172) - z_178*z_46 - z_131*z_177 - z_130*z_177) - sin_q2*(6.0*z_158*z_46 + 2.0*z_91*z_159
        + 2.0*sin_q3*z_31*z_179 + cos_q4*z_178 + c_18 + sin_q3*c_19 + z_45*c_20 + q2_dot*z_45*z_177 - z_162*z_73 -
        z_42*c_16*z_179));
    const real z_180 = q2_dot*q3_dot;
    const real z_181 = q2_dot*q2_dot;
    const real z_182 = z_51*z_181;
    const real z_183 = q2_dot*q4_dot;
    const real z_184 = sin_q3*z_181;
    const real z_185 = 2.0*z_183 + z_184;
    const real z_186 = sin_q4*z_185;
    const real z_187 = l*(2.0*z_97*z_161 + z_45*z_181 - sin_q5*z_186);
    const real z_188 = c_8*z_181 - 2.0*z_187 - z_186*c_8 - z_184*c_8;
    const real z_189 = c_0*z_188;
    const real z_190 = q1_dot*z_95;
    const real z_191 = q3_dot*sin_q2;
    const real z_192 = 2.0*q1_dot*z_88 + 2.0*q1_dot*z_89 + cos_q3*z_162;
    const real z_193 = 2.0*z_6*z_190 + 2.0*q1_dot*z_92 + 2.0*q1_dot*z_94 + sin_q4*z_192;
    const real z_194 = q1_dot*z_85;
    const real z_65 = shared[57];
    const real z_195 = l*(2.0*z_101*(q1_dot*z_11) + 2.0*q1_dot*z_100 + z_21*z_162 + sin_q5*z_193 -
        2.0*z_97*(q1_dot*z_7) - 2.0*z_45*z_194);
    const real c_21 = c[24];
    const real z_196 = 2.0*z_195 + z_194*c_16 - z_193*c_8 - z_192*c_8;
    const real z_197 = m*((z_195 + z_194*c_21 - z_193*c_15 - z_192*c_16) + z_196);
    const real z_198 = sin_q4*z_176;
    const real z_199 = c_17*(q2_dot*z_57);
    const real z_200 = c_17*(q1_dot*z_32);
    const real z_201 = q3_dot*cos_q5;
    const real z_202 = cos_q5*z_177;
    const real z_203 = (c_16*z_181 - z_187 - z_186*c_15 - z_184*c_16) + z_188;
    const real z_204 = m*z_203;
    const real z_205 = sin_q2*z_95;
    const real z_36 = shared[58];
    const real z_206 = c_0*z_196;
    const real z_13 = shared[59];
    f1[2] = ((-1.0/12.0))*(sin_q3*(2.0*z_180*z_147 + 2.0*z_191*z_160 + z_32*z_167*z_35 + z_31*z_162 + z_196*z_198
        + sin_q2*cos_q5*z_175 + c_20*(cos_q2*cos_q5) + c_16*(z_63*z_180) + z_111*z_200 + z_200*z_201 + z_85*z_202
        - z_35*z_182 - cos_q5*z_189 - 2.0*z_33*z_190 - c_0*(l*(-(5.0*z_192 + z_193 - 12.0*z_194))) - z_65*z_197 -
        l*z_197 - z_101*z_199 - sin_q2*z_101*z_177) - cos_q3*(6.0*z_158*z_74 + 2.0*q2_dot*z_58*z_95 + z_188*z_198
        + 2.0*z_159*z_205 + 2.0*q1_dot*q3_dot*z_34 + 2.0*z_31*z_194 + z_34*z_167 + cos_q5*z_206 + z_13*z_174 +
        cos_q2*c_19 - z_54*z_181 - z_65*z_204 - l*(m*(l*(6.0*z_181 - 5.0*z_184 - z_186) + z_203)) - z_162*z_36 -
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
    const real z_220 = c_16*z_214 + z_218*c_8 - 2.0*z_219;
    f1[3] = (1.0/12.0)*(cos_q4*(6.0*z_158*z_39 + z_70*z_207 + z_213*z_176 + 2.0*z_58*z_214 + sin_q3*z_188*z_176 +
        2.0*cos_q2*z_215 + z_33*z_164 + z_29*z_192 + z_83*z_206 + z_210*c_5*z_71 + cos_q3*z_97*z_200 -
        l*(m*(l*(-(6.0*z_208 + 5.0*z_209 - z_212)) + z_213)) - z_52*z_185 - z_43*z_204 - z_216*z_197 - z_178*z_6 -
        z_217*z_199) + sin_q4*(2.0*q3_dot*q4_dot*z_75 + z_220*z_176 + 2.0*q4_dot*z_33*z_163 + cos_q2*z_33*z_162 +
        c_17*z_97*(q2_dot*z_51) - 6.0*sin_q2*z_158 - 2.0*z_183*z_152 - z_58*z_181 - c_0*(c_21*z_214 + z_218*c_15 -
        z_219) - c_0*z_220 - 2.0*z_6*z_215 - 2.0*z_93*z_159 - cos_q2*z_178));
    const real z_221 = cos_q2*cos_q3;
    const real c_22 = c[25];
    const real z_222 = q3_dot*z_95;
    const real c_23 = c[26];
    const real z_223 = q5_dot*z_199;
    const real z_224 = q5_dot*z_200;
    const real z_225 = q5_dot*z_177;
    const real z_226 = q4_dot*q4_dot;
    const real z_56 = shared[60];
    const real z_227 = z_127 + cos_q2*z_46;
    f1[4] = ((-1.0/12.0))*(sin_q5*(l*z_162*z_37 + sin_q3*z_206 + z_11*z_175 + c_20*z_221 + c_22*(q3_dot*z_111) +
        c_5*(sin_q5*z_222) + z_207*z_150 + z_22*z_224 + z_7*z_225 + z_87*z_200 + z_177*z_146 - z_216*z_182 -
        cos_q3*z_189 - z_27*z_43*z_162 - c_23*z_222 - z_46*z_223 - q5_dot*c_17*(z_51*z_161) - z_98*z_199 -
        z_99*z_177) + cos_q5*(z_77*(l*z_226) + l*z_69*z_211 + z_57*(l*z_218) + z_56*z_220 + z_27*(l*z_193) +
        z_227*c_20 + cos_q3*z_223 + z_11*z_225 + sin_q3*z_224 - c_0*(l*(-(3.0*z_226 - 2.0*sin_q5*z_226))) -
        c_0*sin_q4*z_213 - z_51*(z_65*z_185) - z_46*z_189 - z_32*z_166 - z_22*z_206 - z_7*z_175 - z_222*z_150));
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
    dy[5] = a1[0];
    dy[6] = a1[1];
    dy[7] = a1[2];
    dy[8] = a1[3];
    dy[9] = a1[4];
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
    real v1[N1] = { e[0], e[1], e[2], e[3], e[4] };
    if (mode) em_backward(N1, memory + 0, memory + 25, v1);
    else em_velocity_of_eta(N1, y + 10, y + 35, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
    v[4] = v1[4];
}

#define EM_VELOCITY velocity_by_roots

#include "em_flock.h"
#endif

extern em_lanes bricard_lanes;
em_lanes bricard_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double q1_dot = v[0];
    const double l = c[1];
    const double c_4 = c[7];
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
    const double c_3 = c[6];
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
    const double c_1 = c[4];
    const double z_34 = -z_32;
    const double z_35 = z_33*c_1 + z_34*c_3;
    const double z_36 = c_4*z_1 + z_9*c_3 + z_35;
    const double z_37 = sin_q3*cos_q5;
    const double z_38 = sin_q5*cos_q3;
    const double z_39 = sin_q4*cos_q3;
    const double z_40 = cos_q3 + z_39;
    const double z_41 = l*(z_40 - (z_37 + sin_q4*z_38));
    const double z_42 = z_41*c_1;
    const double z_43 = l*z_40;
    const double c_0 = c[3];
    const double c_2 = c[5];
    const double m = c[0];
    const double z_44 = m*(2.0*z_41 + z_43);
    const double z_45 = l*((c_0*cos_q3 + z_42 + z_43*c_2) - sin_q5*z_44);
    const double z_46 = sin_q4*z_45;
    const double z_47 = l*(z_42 + z_43*c_3 + cos_q3*c_4) + z_46;
    const double z_48 = z_47*z_27;
    const double z_49 = cos_q5*z_5;
    const double z_50 = sin_q3*z_29;
    const double z_51 = z_49 - z_50;
    const double z_52 = sin_q4*z_25;
    const double z_53 = sin_q5*z_27;
    const double z_54 = cos_q3*z_18;
    const double z_55 = l*z_27 - l*(z_54 - sin_q4*z_27);
    const double z_56 = l*(z_51 + (z_18*z_38 + cos_q3*z_52 - sin_q4*z_53)) + z_55;
    const double z_57 = z_56*c_1;
    const double z_58 = z_44*z_25;
    const double z_59 = m*(2.0*z_56 + z_55);
    const double z_60 = sin_q5*z_59;
    const double z_61 = l*(c_0*z_27 + z_57 + z_55*c_2) + l*(z_58 - z_60);
    const double z_62 = l*(z_57 + z_55*c_3 + c_4*z_27) - (z_45*z_18 - sin_q4*z_61);
    const double z_63 = cos_q5*z_30;
    const double z_64 = l*sin_q2;
    const double z_65 = l - z_64;
    const double z_66 = l*z_19 + z_65;
    const double z_67 = l*z_23 - z_66;
    const double z_68 = l*(z_23*sin_q5 + z_63) - z_67;
    const double z_69 = -z_67;
    const double z_70 = c_0 + z_68*c_1 + z_65*c_2 + z_66*c_3 + z_69*c_3;
    const double z_71 = m*(2.0*z_68 + z_69);
    const double z_72 = l*(m*(3.0*z_68 + z_66 + 5.0*z_69) - sin_q5*z_71);
    const double z_73 = m*(2.0*z_33 + z_34);
    const double z_74 = l*(m*(3.0*z_33 + z_9 + 5.0*z_34)) + l*(z_71*z_25 - sin_q5*z_73);
    const double c_10 = c[13];
    const double z_75 = l*(m*(3.0*z_68 + z_65 + 5.0*z_66 + 6.0*z_69)) + sin_q4*z_72;
    const double z_76 = z_72*z_18;
    const double z_77 = l*(c_0*z_1 + z_9*c_2 + z_35) - (z_76 - sin_q4*z_74);
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
    bias[0] = (1.0/6.0)*(q1_dot*(l*z_36 + (z_48 + cos_q3*z_62) + l*(z_70*z_1 - sin_q2*z_36) + c_10*z_1 +
        l*(z_44*z_49 - z_44*z_50 - z_37*z_59) - (z_72*z_16 + z_72*z_13 + z_21*z_74) - (z_75*z_8 + z_75*z_6 -
        z_77*z_19) - l*(z_1*z_78 - z_28*z_79 - z_29*z_80 - z_63*z_73)) + q5_dot*z_105 - q2_dot*z_90 - q3_dot*z_93
        - q4_dot*z_97);
    const double c_13 = c[16];
    const double c_14 = c[17];
    const double z_106 = c_14 - sin_q5*c_13;
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
    const double c_15 = c[18];
    const double z_121 = z_116*c_15 - z_118 - 6.0*z_120;
    const double z_122 = l*(2.0*z_52*z_115 + 2.0*q1_dot*z_49 + z_63*z_110 + sin_q5*z_117 - 2.0*q1_dot*z_50);
    const double c_16 = c[19];
    const double z_123 = z_122 + z_116*c_16 - 6.0*z_120 - z_117*c_15;
    const double c_8 = c[11];
    const double z_124 = 2.0*z_122 + z_116*c_8 - 3.0*z_120 - z_117*c_8;
    const double z_125 = z_123 + z_124;
    const double z_126 = m*(z_121 + z_125);
    const double z_127 = c_0*z_124;
    const double z_128 = c_0*sin_q5;
    const double c_17 = c[20];
    const double z_129 = z_44*c_17;
    const double z_130 = q1_dot*z_129;
    const double z_131 = z_124*z_128 + z_25*z_130 - l*(m*z_125);
    const double z_132 = q1_dot*q2_dot;
    const double c_18 = c[21];
    const double c_19 = c[22];
    const double c_20 = c[23];
    const double z_133 = cos_q5*z_115;
    const double z_134 = l - z_114;
    const double z_135 = l*z_17 - z_134;
    const double z_136 = -l*(z_26 - sin_q5*z_17) - z_135;
    const double z_137 = -z_135;
    const double z_138 = m*(2.0*z_136 + z_137);
    const double z_139 = l*(m*(3.0*z_136 + z_134 + 5.0*z_137) - sin_q5*z_138);
    const double z_140 = l*(c_0 + z_136*c_1 + z_134*c_2 + z_137*c_3) + sin_q4*z_139;
    const double z_141 = z_28 + z_89;
    const double z_142 = l*z_5;
    const double z_143 = z_142 + l*(z_107 + sin_q4*z_5);
    const double z_144 = z_143 - l*(z_141 + (z_25*z_17 + sin_q4*z_98 + sin_q5*z_107));
    const double z_145 = z_144*c_1;
    const double z_146 = m*(2.0*z_144 + z_143);
    const double z_147 = z_139*z_18 - sin_q4*(l*(c_0*z_5 + z_145 + z_143*c_2) + l*(z_138*z_25 - sin_q5*z_146));
    const double z_148 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_149 = c_0*cos_q4;
    const double z_150 = z_149 + z_148*c_6;
    const double z_151 = l*((z_148*c_1 + cos_q4*c_4) - sin_q5*z_150);
    const double z_152 = l*z_12 - l*(sin_q5*z_12 - cos_q4*z_25);
    const double z_153 = c_0*z_12 + z_152*c_6;
    const double z_154 = l*(z_152*c_1 + c_4*z_12) + l*(z_150*z_25 - sin_q5*z_153);
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
        (c_0*z_110 + m*(l*z_116 - 5.0*z_120)) + m*z_124) - z_131*z_17 - z_29*z_115*z_129 - z_28*z_130) -
        sin_q2*(6.0*z_106*z_17 + 2.0*z_12*z_108 + 2.0*z_132*z_85 + cos_q4*z_131 + c_18 + sin_q3*c_19 + z_26*c_20 +
        q2_dot*z_129*z_133 - z_110*z_94 - z_81*c_16*z_132)) - 2.0*(q1_dot*z_90 + q5_dot*z_165 - q2_dot*((z_140*z_5
        - sin_q3*(l*(z_145 + c_4*z_5 + z_143*c_3) - z_147)) + (z_151*z_12 + z_155) + (m*z_144 + c_7*z_5 +
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
    const double z_175 = c_0*z_174;
    const double z_176 = q1_dot*sin_q2;
    const double z_177 = 2.0*z_5*z_176 + 2.0*q1_dot*z_8 + cos_q3*z_110;
    const double z_178 = 2.0*z_107*z_176 + 2.0*q1_dot*z_13 + 2.0*z_176*z_109 + sin_q4*z_177;
    const double z_179 = q1_dot*z_1;
    const double z_180 = l*sin_q4;
    const double z_181 = q1_dot*z_23;
    const double z_182 = l*(2.0*z_89*z_176 + 2.0*z_28*z_176 + z_37*z_110 + sin_q5*z_178 - 2.0*z_25*z_181 -
        2.0*z_1*z_133);
    const double c_21 = c[24];
    const double z_183 = 2.0*z_182 + z_179*c_16 - z_178*c_8 - z_177*c_8;
    const double z_184 = m*((z_182 + z_179*c_21 - z_178*c_15 - z_177*c_16) + z_183);
    const double z_185 = sin_q4*z_128;
    const double z_186 = c_17*(q2_dot*z_150);
    const double z_187 = c_17*(q1_dot*z_71);
    const double z_188 = z_176*z_129;
    const double z_189 = q3_dot*cos_q5;
    const double z_190 = (c_16*z_167 - z_173 - z_172*c_15 - z_170*c_16) + z_174;
    const double z_191 = m*z_190;
    const double z_192 = z_45*z_176;
    const double z_193 = c_0*z_183;
    const double z_194 = l*sin_q5;
    const double z_195 = l + z_180;
    const double z_196 = z_195 - sin_q4*z_194;
    const double z_197 = m*(2.0*z_196 + z_195);
    const double z_198 = l*((c_0 + z_196*c_1 + z_195*c_2) - sin_q5*z_197);
    const double z_199 = l*z_18 - l*(z_52 + sin_q5*z_18);
    const double z_200 = l*(z_197*z_25 + sin_q5*(c_0*z_18 + z_199*c_6));
    const double c_5 = c[8];
    const double z_201 = cos_q5*c_5;
    const double z_202 = c_10*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    const double z_203 = q4_dot*q4_dot;
    const double z_204 = cos_q5*cos_q5;
    const double z_205 = q5_dot*z_204;
    const double c_12 = c[15];
    const double z_206 = 2.0*c_10*(z_205 - q5_dot*(sin_q5*sin_q5)) + c_12*z_29;
    const double z_207 = z_200 - 2.0*c_10*(z_204*z_18 - 2.0*z_29*z_101);
    bias[2] = ((-1.0/12.0))*((sin_q3*(2.0*z_166*z_157 + 2.0*z_47*(q3_dot*z_176) + z_110*z_111*z_79 + z_47*z_110 +
        z_183*z_185 + sin_q2*cos_q5*z_127 + c_20*(cos_q2*cos_q5) + c_16*(z_156*z_166) + z_52*z_187 + z_187*z_189 +
        cos_q5*z_179*z_129 - z_111*z_168 - cos_q5*z_175 - 2.0*q1_dot*z_76 - c_0*(l*(-(5.0*z_177 + z_178 -
        12.0*z_179))) - z_180*z_184 - l*z_184 - z_29*z_186 - z_29*z_188) - cos_q3*(6.0*z_106*z_96 +
        2.0*q2_dot*z_151*z_18 + z_174*z_185 + 2.0*z_18*z_192 + 2.0*q1_dot*q3_dot*z_75 + 2.0*z_47*z_179 +
        z_75*z_119 + cos_q5*z_193 + z_64*z_126 + cos_q2*c_19 - z_140*z_167 - z_180*z_191 - l*(m*(l*(6.0*z_167 -
        5.0*z_170 - z_172) + z_190)) - z_110*(z_44*z_111) - sin_q2*sin_q4*z_131 - z_52*z_186 - z_186*z_189 -
        z_29*z_187 - z_188*z_189)) + 2.0*(q1_dot*z_93 + q3_dot*((z_198*z_18 + sin_q4*(l*(z_199*c_1 + c_4*z_18) -
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
    const double z_216 = c_17*z_25;
    const double z_217 = q3_dot*z_202;
    const double z_218 = 2.0*q2_dot*z_107 + 2.0*sin_q4*z_214 + cos_q4*z_167;
    const double z_219 = l*(2.0*z_25*(q2_dot*z_17) + 2.0*q2_dot*z_89 + 2.0*q2_dot*z_28 + sin_q5*z_218);
    const double z_220 = c_16*z_214 + z_218*c_8 - 2.0*z_219;
    const double z_221 = l - z_194;
    const double z_222 = c_0 + z_221*c_6;
    const double z_223 = q5_dot*z_111;
    const double c_9 = c[12];
    bias[3] = (1.0/12.0)*((cos_q4*(6.0*z_106*z_87 + z_198*z_208 + z_213*z_128 + 2.0*z_151*z_214 +
        sin_q3*z_174*z_128 + 2.0*q4_dot*cos_q2*z_108 + z_72*z_116 + z_45*z_177 + z_38*z_193 + q3_dot*z_205*c_5 +
        z_71*z_115*z_216 - l*(m*(l*(-(6.0*z_209 + 5.0*z_210 - z_212)) + z_213)) - z_139*z_171 - z_114*z_191 -
        z_215*z_184 - z_131*z_19 - z_99*z_186) + sin_q4*(2.0*q4_dot*z_217 + z_220*z_128 + 2.0*q4_dot*z_72*z_115 +
        cos_q2*z_72*z_110 + q2_dot*z_138*z_216 - 6.0*sin_q2*z_106 - 2.0*z_169*z_159 - z_151*z_167 -
        c_0*(c_21*z_214 + z_218*c_15 - z_219) - c_0*z_220 - 2.0*q4_dot*sin_q3*z_192 - 2.0*q2_dot*z_192 -
        cos_q2*z_131)) - 2.0*(q1_dot*z_97 + (z_12*z_217 + q3_dot*cos_q4*z_206) - q2_dot*z_160 - q4_dot*(c_12*z_25
        - (cos_q5*c_9*z_29 - z_222*z_223))));
    const double z_224 = cos_q2*cos_q3;
    const double c_22 = c[25];
    const double z_225 = q3_dot*z_18;
    const double c_23 = c[26];
    const double z_226 = q5_dot*c_17;
    const double z_227 = z_84 + cos_q2*z_17;
    const double z_228 = q5_dot*cos_q3;
    bias[4] = ((-1.0/12.0))*((sin_q5*(z_113*z_80 + sin_q3*z_193 + z_30*z_127 + c_20*z_224 + q3_dot*z_52*c_22 +
        c_5*(sin_q5*z_225) + z_208*z_201 + z_115*z_103*z_226 + z_129*(q5_dot*z_181) + z_5*z_187 +
        z_129*(z_1*z_115) - z_215*z_168 - cos_q3*z_175 - z_44*z_114*z_110 - c_23*z_225 - q5_dot*z_17*z_186 -
        z_226*(z_138*z_109) - z_27*z_186 - z_27*z_188) + cos_q5*(z_222*(l*z_203) + l*z_197*z_211 + z_150*(l*z_218)
        + z_149*z_220 + z_178*(l*z_44) + z_227*c_20 + z_186*z_228 + z_188*z_228 + q5_dot*sin_q3*z_187 -
        c_0*(l*(-(3.0*z_203 - 2.0*sin_q5*z_203))) - c_0*sin_q4*z_213 - z_138*(z_180*z_171) - z_17*z_175 -
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
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double q1_dot = v[0];
    const double l = c[1];
    const double c_0 = c[3];
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
    const double c_1 = c[4];
    const double c_2 = c[5];
    const double c_3 = c[6];
    const double z_18 = -z_16;
    const double z_19 = c_0 + z_17*c_1 + z_14*c_2 + z_15*c_3 + z_18*c_3;
    const double z_20 = sin_q4*cos_q3;
    const double z_21 = cos_q3 + z_20;
    const double z_22 = l*(z_21 - (sin_q3*cos_q5 + sin_q5*z_20));
    const double z_23 = z_22*c_1;
    const double z_24 = l*z_21;
    const double c_4 = c[7];
    const double m = c[0];
    const double z_25 = m*(2.0*z_22 + z_24);
    const double z_26 = sin_q5*z_25;
    const double z_27 = l*((c_0*cos_q3 + z_23 + z_24*c_2) - z_26);
    const double z_28 = sin_q4*z_27;
    const double z_29 = l*(z_23 + z_24*c_3 + cos_q3*c_4) + z_28;
    const double z_30 = m*(2.0*z_17 + z_18);
    const double z_31 = l*(m*(3.0*z_17 + z_15 + 5.0*z_18) - sin_q5*z_30);
    const double z_32 = l*(m*(3.0*z_17 + z_14 + 5.0*z_15 + 6.0*z_18)) + sin_q4*z_31;
    const double z_33 = l*cos_q5;
    const double z_34 = z_25*z_33;
    const double z_35 = z_30*z_33;
    const double c_5 = c[8];
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
    const double z_47 = z_45*c_1 + z_46*c_3;
    const double z_48 = m*(2.0*z_45 + z_46);
    const double z_49 = sin_q4*(l*(m*(3.0*z_45 + z_43 + 5.0*z_46) - sin_q5*z_48));
    const double z_50 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_51 = c_0*cos_q4 + z_50*c_6;
    const double z_52 = sin_q5*z_51;
    const double z_53 = l*((z_50*c_1 + cos_q4*c_4) - z_52);
    const double z_54 = cos_q4*z_53;
    const double z_55 = z_20*z_53 + cos_q3*(m*z_50 + cos_q4*c_7)*c_8 - sin_q3*(z_51*z_33);
    const double z_56 = z_49 - sin_q3*z_54;
    const double z_57 = l*(cos_q5*(cos_q4*z_48) + cos_q3*z_52 + cos_q5*z_51*z_6);
    const double z_58 = l*sin_q5;
    const double z_59 = l + l*sin_q4;
    const double z_60 = z_59 - sin_q4*z_58;
    const double z_61 = z_60*c_1;
    const double z_62 = m*(2.0*z_60 + z_59);
    const double c_9 = c[12];
    const double z_63 = cos_q5*cos_q5;
    const double c_10 = c[13];
    const double z_64 = cos_q4*(c_10*(3.0*cos_q5 - 2.0*sin_q5*cos_q5));
    const double z_65 = z_62*z_58 - c_9*(sin_q4*z_63);
    const double z_66 = l - z_58;
    e[0] = (1.0/12.0)*(q1_dot*(q1_dot*(l*z_19 + cos_q3*z_29 + c_0*z_14 + z_32*z_12 + z_11*z_35 + c_5 - z_13*z_19 -
        z_2*z_31 - sin_q3*z_34) + q3_dot*z_40 + q5_dot*z_42 - q2_dot*z_39 - q4_dot*z_41) + q3_dot*(q1_dot*z_40 +
        q2_dot*z_55 + q3_dot*(l*(c_4 + z_61 + z_59*c_3) + sin_q4*(l*((c_0 + z_61 + z_59*c_2) - sin_q5*z_62)) +
        c_9*z_63) - q4_dot*z_64 - q5_dot*z_65) + q5_dot*(q1_dot*z_42 + q5_dot*c_9 - q2_dot*z_57 - q3_dot*z_65) -
        q2_dot*(q1_dot*z_39 + q2_dot*(sin_q3*(l*(c_0 + z_43*c_2 + z_47) + z_49) + cos_q3*z_48*z_33 - l*(c_4 +
        z_43*c_3 + z_47) - z_54) + q4_dot*z_56 + q5_dot*z_57 - q3_dot*z_55) - q4_dot*(q1_dot*z_41 + q2_dot*z_56 +
        q3_dot*z_64 - q4_dot*(l*((c_4 + z_66*c_1) - sin_q5*(c_0 + z_66*c_6)))));
    e[1] = 0.0;
    e[2] = 0.0;
    const double z_67 = z_36 + cos_q2*z_6;
    const double c_25 = c[28];
    e[3] = l*(7.0*cos_q2 + (sin_q5*z_67 - cos_q5*z_38) - 3.0*z_67 - 5.0*z_37)*c_25;
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
#if EM_HOLDS(EM_DERIVATIVES)

/* --- partial derivatives --- */

/* dM (n, n, n): dM[k, i, j] = dM_ij / dx_k */
EM_RARE /* no step calls it */
EM_ACROSS void mass_matrix_gradient(double t, const double *restrict x, const double *restrict c,
                                    double *restrict dM)
{
    memset(dM, 0, sizeof *dM * N * N * N);
    const double l = c[1];
    const double m = c[0];
    const double z_0 = l*m;
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double z_2 = z_0*cos_q2;
    const double z_3 = l*cos_q2;
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_5 = cos_q2*sin_q3;
    const double z_6 = z_3 - l*z_5;
    const double z_7 = m*z_6;
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double q4 = x[3];
    const double cos_q4 = em_cos(q4);
    const double sin_q2 = em_sin(q2);
    const double z_11 = cos_q4*sin_q2;
    const double sin_q4 = em_sin(q4);
    const double z_13 = sin_q3*sin_q4;
    const double z_14 = z_11 + cos_q2*z_13;
    const double cos_q5 = em_cos(q5);
    const double cos_q3 = em_cos(q3);
    const double z_17 = cos_q2*cos_q3;
    const double z_18 = l*z_14 - z_6;
    const double z_19 = m*(l*(sin_q5*z_14 - cos_q5*z_17) - z_18);
    const double z_20 = m*(-z_18);
    const double z_21 = z_19 + 2.0*z_20;
    const double z_22 = 5.0*z_2 + 6.0*z_7 + 3.0*z_21;
    const double z_23 = l*sin_q2;
    const double z_24 = l - z_23;
    const double z_25 = m*z_24;
    const double z_26 = sin_q2*sin_q3;
    const double z_27 = l*z_26 + z_24;
    const double z_28 = m*z_27;
    const double z_29 = cos_q2*cos_q4;
    const double z_30 = z_29 - sin_q4*z_26;
    const double z_31 = sin_q2*cos_q3;
    const double z_32 = l*z_30 - z_27;
    const double z_33 = m*(l*(z_30*sin_q5 + cos_q5*z_31) - z_32);
    const double z_34 = m*(-z_32);
    const double z_35 = z_33 + 2.0*z_34;
    const double z_36 = 2.0*z_33 + z_34;
    const double z_37 = l*sin_q5;
    const double z_38 = z_36*z_37;
    const double z_39 = l*(3.0*z_33 + z_28 + 5.0*z_34) - z_38;
    const double z_40 = 2.0*z_19 + z_20;
    const double z_41 = l*(3.0*z_19 + z_7 + 5.0*z_20) - z_37*z_40;
    const double z_42 = m*(l*l);
    const double z_43 = cos_q2*z_42;
    const double z_44 = l*(z_25 + 5.0*z_28 + 3.0*z_35) + sin_q4*z_39;
    const double z_45 = l*(z_2 + 5.0*z_7 + 3.0*z_21) + sin_q4*z_41;
    const double z_46 = l*cos_q5;
    const double z_47 = cos_q3*z_46;
    const double z_48 = cos_q2*z_47;
    const double z_49 = z_46*z_31;
    dM[25] = ((-1.0/6.0))*(l*z_22 + ((z_0 + 5.0*z_25 + 6.0*z_28 + 3.0*z_35)*z_3 - z_23*z_22) + z_43 - (z_39*z_11 +
        z_29*z_41) - (z_44*z_5 - z_45*z_26) - (z_36*z_48 - z_40*z_49));
    const double z_50 = z_0*cos_q3;
    const double z_51 = sin_q4*cos_q3;
    const double z_52 = l*cos_q3;
    const double z_53 = z_52 + l*z_51;
    const double z_54 = m*(z_53 - l*(sin_q3*cos_q5 + sin_q5*z_51));
    const double z_55 = m*z_53;
    const double z_56 = z_54 + 2.0*z_55;
    const double z_57 = 2.0*z_50 + z_56;
    const double z_58 = 2.0*z_54 + z_55;
    const double z_59 = z_58*z_37;
    const double z_60 = l*(3.0*z_54 + 5.0*z_55 + z_50) - z_59;
    const double z_61 = z_29*z_60;
    const double z_62 = sin_q4*z_60;
    const double z_63 = l*(5.0*z_50 + 3.0*z_56) + z_62;
    const double z_64 = z_63*z_26;
    const double z_65 = z_58*z_46;
    const double z_66 = z_65*z_31;
    dM[30] = dM[26] = (1.0/6.0)*(3.0*z_23*z_57 + z_61 - z_64 - z_66);
    const double z_67 = z_63*z_17;
    const double z_68 = z_65*z_5;
    dM[35] = dM[27] = ((-1.0/6.0))*(sin_q3*z_45 + z_40*z_47 + z_68 - z_67);
    const double z_69 = cos_q4*cos_q3;
    const double z_70 = sin_q2*z_62;
    const double z_71 = cos_q4*sin_q3;
    dM[40] = dM[28] = (1.0/6.0)*(z_41*z_69 + cos_q2*z_60*z_71 - z_70);
    const double z_72 = sin_q3*z_37;
    const double z_73 = z_59*z_17;
    const double z_74 = sin_q4*z_47;
    dM[45] = dM[29] = ((-1.0/6.0))*(z_14*z_65 + z_73 + z_40*z_74 - z_40*z_72);
    const double z_75 = z_0*z_31;
    const double z_76 = sin_q4*z_31;
    const double z_77 = l*z_31 + l*z_76;
    const double z_78 = m*(z_77 - l*(cos_q5*z_26 + sin_q5*z_76));
    const double z_79 = m*z_77;
    const double z_80 = z_78 + 2.0*z_79;
    const double z_81 = 2.0*z_75 + z_80;
    const double z_82 = sin_q3*z_63;
    const double z_83 = z_0*sin_q3;
    const double z_84 = l*(cos_q3*cos_q5 - sin_q5*z_13);
    const double z_85 = l*sin_q3;
    const double z_86 = z_85 + l*z_13;
    const double z_87 = m*(z_84 + z_86);
    const double z_88 = m*z_86;
    const double z_89 = z_87 + 2.0*z_88;
    const double z_90 = 2.0*z_87 + z_88;
    const double z_91 = z_37*z_90;
    const double z_92 = l*(3.0*z_87 + 5.0*z_88 + z_83) - z_91;
    const double z_93 = l*(5.0*z_83 + 3.0*z_89) + sin_q4*z_92;
    const double z_94 = 2.0*z_78 + z_79;
    const double z_95 = l*(3.0*z_78 + z_75 + 5.0*z_79) - z_37*z_94;
    const double z_96 = l*(5.0*z_75 + 3.0*z_80) + sin_q4*z_95;
    const double z_97 = z_58*z_47;
    const double z_98 = sin_q3*z_46;
    const double z_99 = z_36*z_46;
    dM[50] = (1.0/6.0)*(3.0*l*z_81 + (z_44*z_31 + z_96*z_26) - (z_82 + cos_q3*z_93) - 3.0*z_23*z_81 - z_29*z_95 -
        (z_97 - z_90*z_98) - (z_99*z_26 - z_94*z_49));
    dM[55] = dM[51] = (1.0/6.0)*(3.0*z_3*(2.0*z_83 + z_89) + (z_67 - z_93*z_5) - z_11*z_92 - (z_68 + z_90*z_48));
    const double z_100 = l - z_86;
    const double z_101 = m*(z_100 - z_84);
    const double z_102 = m*(l - z_85);
    const double z_103 = m*z_100;
    const double z_104 = 2.0*z_101 + z_103;
    const double z_105 = z_104*z_37;
    const double z_106 = l*(3.0*z_101 + z_102 + 5.0*z_103) - z_105;
    dM[56] = ((-1.0/6.0))*(3.0*l*z_57 - (z_82 - cos_q3*(l*(z_0 + 3.0*z_101 + 5.0*z_102 + 6.0*z_103) +
        sin_q4*z_106)) - (z_97 + z_104*z_98));
    const double z_107 = z_36*z_98;
    const double z_108 = z_46*z_26;
    dM[60] = dM[52] = (1.0/6.0)*((cos_q3*z_44 + sin_q3*z_96) - (z_64 + z_93*z_31) - (z_107 - z_94*z_47) - (z_66 -
        z_90*z_108));
    const double z_109 = m*(l*cos_q4 - cos_q4*z_37);
    const double z_110 = z_0*cos_q4;
    const double z_111 = z_109 + 2.0*z_110;
    const double z_112 = 2.0*z_109 + z_110;
    const double z_113 = z_112*z_37;
    const double z_114 = l*(3.0*z_109 + 5.0*z_110) - z_113;
    const double z_115 = z_114*z_13;
    const double z_116 = z_112*z_47;
    dM[61] = dM[57] = ((-1.0/6.0))*(3.0*z_85*z_111 + z_115 + z_116);
    const double z_117 = cos_q2*sin_q4;
    const double z_118 = cos_q4*z_60;
    const double z_119 = cos_q4*z_26;
    dM[65] = dM[53] = (1.0/6.0)*((z_39*z_71 - z_95*z_69) + (z_118*z_31 - z_119*z_92) - z_117*z_92);
    const double z_120 = z_114*z_69;
    dM[66] = dM[58] = (1.0/6.0)*(z_62 + z_120);
    const double z_121 = z_30*z_46;
    const double z_122 = cos_q3*z_38;
    const double z_123 = z_59*z_26;
    dM[70] = dM[54] = ((-1.0/6.0))*((z_65*z_76 + z_90*z_121) + (z_122 + z_94*z_72) + (z_99*z_13 - z_94*z_74) -
        (z_123 + z_91*z_31));
    const double z_124 = z_112*z_72;
    dM[71] = dM[59] = (1.0/6.0)*(cos_q4*z_65 + z_124 - z_112*z_74);
    const double z_125 = z_117 + z_119;
    const double z_126 = m*(z_37*z_125 - l*z_125);
    const double z_127 = z_0*z_125;
    const double z_128 = z_126 - 2.0*z_127;
    const double z_129 = l*z_128;
    const double z_130 = m*(z_37*z_69 - l*z_69);
    const double z_131 = z_0*z_69;
    const double z_132 = z_130 - 2.0*z_131;
    const double z_133 = 2.0*z_130 - z_131;
    const double z_134 = z_37*z_133;
    const double z_135 = l*(3.0*z_130 - 5.0*z_131) - z_134;
    const double z_136 = 3.0*l*z_132 - (z_118 - sin_q4*z_135);
    const double z_137 = 2.0*z_126 - z_127;
    const double z_138 = l*(3.0*z_126 - 5.0*z_127) - z_37*z_137;
    const double z_139 = 3.0*z_129 - (cos_q4*z_39 - sin_q4*z_138);
    dM[75] = ((-1.0/6.0))*(3.0*z_129 + cos_q3*z_136 + z_139*z_26 + z_137*z_49 - 3.0*z_23*z_128 - (z_39*z_117 +
        z_29*z_138) - z_133*z_98);
    dM[80] = dM[76] = (1.0/6.0)*(3.0*z_3*z_132 - (z_70 + z_11*z_135) - z_136*z_5 - z_133*z_48);
    const double z_140 = m*(z_37*z_71 - l*z_71);
    const double z_141 = z_0*z_71;
    const double z_142 = l*(z_140 - 2.0*z_141);
    const double z_143 = 2.0*z_140 - z_141;
    const double z_144 = cos_q4*z_106 + sin_q4*(l*(3.0*z_140 - 5.0*z_141) - z_37*z_143);
    const double z_145 = sin_q4*z_114;
    const double z_146 = l*sin_q4;
    const double z_147 = sin_q4*z_37;
    const double z_148 = m*(z_146 - z_147);
    const double z_149 = z_0*sin_q4;
    const double z_150 = 2.0*z_148 + z_149;
    const double z_151 = z_37*z_150;
    const double z_152 = l*(3.0*z_148 + 5.0*z_149) - z_151;
    dM[81] = (1.0/6.0)*(3.0*z_142 - sin_q3*(3.0*z_142 + z_144) - (z_145 + cos_q4*z_152) - z_143*z_47);
    dM[85] = dM[77] = ((-1.0/6.0))*(sin_q3*z_139 + z_136*z_31 + z_137*z_47 - z_133*z_108);
    dM[86] = dM[82] = ((-1.0/6.0))*(3.0*z_52*(z_148 + 2.0*z_149) - (z_120 - z_152*z_51) - z_150*z_98);
    const double z_153 = l + z_146;
    const double z_154 = m*(z_153 - z_147);
    const double z_155 = m*z_153;
    const double z_156 = 2.0*z_154 + z_155;
    dM[87] = (1.0/6.0)*(3.0*l*z_111 + (z_145 + cos_q4*(l*(z_0 + 3.0*z_154 + 5.0*z_155) - z_156*z_37)));
    dM[90] = dM[78] = (1.0/6.0)*((z_39*z_51 + z_138*z_69) + (z_61 - z_117*z_135) - (z_62*z_26 + z_119*z_135));
    dM[91] = dM[83] = ((-1.0/6.0))*(z_144 + (z_115 + z_152*z_71));
    const double z_157 = cos_q5*z_42;
    const double z_158 = sin_q5*z_157;
    dM[92] = dM[88] = (1.0/6.0)*(sin_q4*(3.0*z_157 - 2.0*z_158));
    dM[95] = dM[79] = ((-1.0/6.0))*((z_65*z_125 + z_133*z_121) - z_137*z_72 - z_134*z_31 - (cos_q4*z_36*z_47 -
        z_137*z_74));
    const double z_159 = z_104*z_46;
    const double z_160 = z_112*z_46;
    dM[96] = dM[84] = (1.0/6.0)*((sin_q4*z_159 - cos_q4*z_143*z_46) + cos_q3*z_151 - (z_160*z_71 -
        z_150*z_46*z_13));
    const double z_161 = cos_q5*cos_q5*z_42;
    dM[97] = dM[89] = ((-1.0/6.0))*(z_113 - 2.0*cos_q4*z_161);
    const double z_162 = sin_q5*z_31 - z_30*cos_q5;
    const double z_163 = z_162*z_42;
    const double z_164 = sin_q3*sin_q5 - cos_q5*z_51;
    const double z_165 = z_164*z_42;
    const double z_166 = sin_q5*z_42;
    const double z_167 = z_164*z_166;
    const double z_168 = 3.0*z_165 - (z_65 + 2.0*z_167);
    const double z_169 = 3.0*z_165 + sin_q4*z_168;
    const double z_170 = z_166*z_162;
    const double z_171 = 3.0*z_163 + (z_99 - 2.0*z_170);
    const double z_172 = 3.0*z_163 + sin_q4*z_171;
    const double z_173 = z_157*z_164;
    const double z_174 = z_157*z_162;
    dM[100] = ((-1.0/6.0))*(3.0*z_163 + z_172*z_26 + (z_38*z_31 + 2.0*z_31*z_174) - cos_q3*z_169 -
        3.0*sin_q2*z_163 - z_29*z_171 - (z_58*z_72 - 2.0*sin_q3*z_173));
    dM[105] = dM[101] = ((-1.0/6.0))*(3.0*z_164*z_43 + (z_73 - 2.0*z_17*z_173) - z_11*z_168 - z_169*z_5);
    const double z_175 = sin_q5*cos_q3 + cos_q5*z_13;
    const double z_176 = z_175*z_42;
    const double z_177 = sin_q4*(3.0*z_176 - (z_159 + 2.0*z_166*z_175));
    const double z_178 = cos_q4*z_157;
    const double z_179 = 3.0*z_178 + (z_160 - 2.0*cos_q4*z_158);
    dM[106] = (1.0/6.0)*(3.0*z_176 + (cos_q3*z_105 - 2.0*cos_q3*z_157*z_175) - sin_q3*(3.0*z_176 + z_177) -
        cos_q4*z_179);
    dM[110] = dM[102] = ((-1.0/6.0))*(sin_q3*z_172 + (z_122 + 2.0*cos_q3*z_174) - z_169*z_31 - (z_123 -
        2.0*z_26*z_173));
    const double z_180 = z_161*z_71;
    dM[111] = dM[107] = ((-1.0/6.0))*(3.0*z_157*z_69 + z_179*z_51 - (z_124 + 2.0*z_180));
    const double z_181 = sin_q4*z_157;
    const double z_182 = sin_q4*z_158;
    const double z_183 = z_156*z_46 - 2.0*z_182;
    dM[112] = ((-1.0/6.0))*(4.0*z_158 + 3.0*z_181 + sin_q4*(3.0*z_181 + z_183));
    dM[115] = dM[103] = (1.0/6.0)*(z_171*z_69 + z_117*z_168 + z_119*z_168);
    dM[116] = dM[108] = ((-1.0/6.0))*(z_177 + z_179*z_71);
    dM[117] = dM[113] = (1.0/6.0)*(cos_q4*(3.0*z_166 + 2.0*(z_161 - sin_q5*sin_q5*z_42)));
    dM[118] = ((-1.0/6.0))*(3.0*z_157 - (2.0*z_158 - (z_0 + 2.0*m*(l - z_37))*z_46));
    dM[120] = dM[104] = ((-1.0/6.0))*((z_30*z_59 - 2.0*z_30*z_173) + (z_107 - 2.0*sin_q3*z_170) + (z_66 +
        2.0*z_167*z_31) + (z_38*z_51 + 2.0*z_51*z_174));
    dM[121] = dM[109] = (1.0/6.0)*((cos_q4*z_105 - 2.0*z_175*z_178) + (z_113*z_13 + 2.0*sin_q4*z_180) - (z_116 -
        2.0*z_158*z_69));
    dM[122] = dM[114] = ((-1.0/6.0))*(4.0*z_182 + z_183);
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double cos_q5 = em_cos(q5);
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double cos_q3 = em_cos(q3);
    const double z_6 = sin_q4*cos_q3;
    const double z_7 = sin_q3*sin_q5 - cos_q5*z_6;
    const double lambda_3 = lambda[3];
    const double l = c[1];
    const double z_8 = l*sin_q5;
    const double z_9 = l - z_8;
    const double z_10 = sin_q4*z_9;
    const double z_11 = l + z_10;
    const double z_12 = cos_q3*z_11;
    const double z_13 = l*cos_q5;
    const double z_14 = sin_q3*z_13;
    const double z_15 = z_12 - z_14;
    const double lambda_2 = lambda[2];
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_17 = l*sin_q2;
    const double z_18 = l - z_17;
    const double z_19 = sin_q2*sin_q3;
    const double cos_q2 = em_cos(q2);
    const double cos_q4 = em_cos(q4);
    const double z_22 = cos_q2*cos_q4;
    const double z_23 = z_22*z_9;
    const double z_24 = sin_q2*cos_q3;
    const double z_25 = z_13*z_24;
    const double z_26 = z_18 + z_11*z_19 + z_25 - z_23;
    const double lambda_0 = lambda[0];
    const double sin_q1 = em_sin(q1);
    const double z_28 = z_22*cos_q5;
    const double z_29 = sin_q4*z_19;
    const double z_30 = sin_q5*z_24 + z_29*cos_q5 - z_28;
    D[0] = -(cos_q1*(z_7*lambda_3 + z_15*lambda_2 + z_26*lambda_0) + sin_q1*(z_30*lambda_3 + z_15*lambda_0 -
        z_26*lambda_2));
    const double q5_dot = v[4];
    const double z_31 = q5_dot*z_8;
    const double z_32 = cos_q3*z_31;
    const double m = c[0];
    const double q3_dot = v[2];
    const double z_33 = q3_dot*cos_q3;
    const double z_34 = q5_dot*sin_q5;
    const double q4_dot = v[3];
    const double z_35 = q4_dot*cos_q4;
    const double z_36 = sin_q5*cos_q3;
    const double z_37 = q5_dot*cos_q5;
    const double z_38 = sin_q3*sin_q4;
    const double z_39 = q3_dot*z_38;
    const double z_40 = q3_dot*sin_q3;
    const double z_41 = l*z_40;
    const double z_42 = l*cos_q3;
    const double z_43 = z_41 - (z_42*z_35 - l*z_39);
    const double z_44 = m*(l*((cos_q5*z_33 - sin_q3*z_34) + (z_35*z_36 + z_6*z_37 - sin_q5*z_39)) + z_43);
    const double z_45 = m*z_43;
    const double z_46 = 2.0*z_44 + z_45;
    const double z_47 = sin_q4*z_42;
    const double z_48 = z_42 + z_47;
    const double z_49 = m*(z_48 - l*(sin_q3*cos_q5 + sin_q5*z_6));
    const double z_50 = m*z_48;
    const double z_51 = 2.0*z_49 + z_50;
    const double z_52 = z_51*z_31;
    const double z_53 = q5_dot*q5_dot;
    const double z_54 = cos_q3*z_13;
    const double z_55 = z_51*z_54;
    const double z_56 = sin_q3*z_35;
    const double z_57 = l*m;
    const double z_58 = z_57*z_40;
    const double z_59 = q5_dot*z_13;
    const double z_60 = z_51*z_59;
    const double z_61 = z_8*z_46;
    const double z_62 = l*(3.0*z_44 + 5.0*z_45 + z_58) + (z_60 - z_61);
    const double z_63 = z_57*cos_q3;
    const double z_64 = z_50 + (1.0/5.0)*z_63;
    const double z_65 = z_51*z_8;
    const double z_66 = l*(3.0*z_49 + 5.0*z_64) - z_65;
    const double z_67 = z_66*z_35;
    const double z_68 = q4_dot*q4_dot;
    const double z_69 = z_66*z_68;
    const double q2_dot = v[1];
    const double z_70 = q4_dot*sin_q4;
    const double z_71 = q2_dot*z_70;
    const double z_72 = z_40*z_13;
    const double z_73 = q3_dot*q3_dot;
    const double z_74 = z_44 + 2.0*z_45;
    const double z_75 = sin_q4*z_62;
    const double z_76 = l*(5.0*z_58 + 3.0*z_74) - (z_67 - z_75);
    const double z_77 = z_49 + 2.0*z_50;
    const double z_78 = sin_q4*z_66;
    const double z_79 = l*(5.0*z_63 + 3.0*z_77) + z_78;
    const double z_80 = sin_q3*z_79;
    const double z_81 = q2_dot*q2_dot;
    const double z_82 = q2_dot*cos_q4;
    const double z_83 = 2.0*z_63 + z_77;
    const double z_84 = l*z_81;
    const double q1_dot = v[0];
    const double z_85 = q1_dot*cos_q3;
    const double z_86 = z_22 - z_29;
    const double z_87 = l*z_19;
    const double z_88 = z_87 + z_18;
    const double z_89 = l*z_86 - z_88;
    const double z_90 = m*(l*(z_86*sin_q5 + cos_q5*z_24) - z_89);
    const double z_91 = m*(-z_89);
    const double z_92 = 2.0*z_90 + z_91;
    const double z_93 = z_92*z_31;
    const double z_94 = q2_dot*cos_q2;
    const double z_95 = z_57*z_94;
    const double z_96 = l*z_94;
    const double z_97 = l*sin_q3;
    const double z_98 = q3_dot*z_24;
    const double z_99 = l*z_98;
    const double z_100 = z_96 - (z_97*z_94 + z_99);
    const double z_101 = m*z_100;
    const double z_102 = cos_q2*z_70;
    const double z_103 = sin_q2*z_82;
    const double z_104 = z_102 + z_103;
    const double z_105 = z_94*z_38;
    const double z_106 = q3_dot*sin_q4;
    const double z_107 = z_106*z_24;
    const double z_108 = z_35*z_19;
    const double z_109 = z_104 + (z_105 + z_107 + z_108);
    const double z_110 = cos_q3*z_94;
    const double z_111 = q3_dot*z_19;
    const double z_112 = l*z_109 - z_100;
    const double z_113 = m*(l*((sin_q5*z_109 - z_86*z_37) - (cos_q5*z_110 - cos_q5*z_111 - z_24*z_34)) - z_112);
    const double z_114 = m*(-z_112);
    const double z_115 = z_113 + 2.0*z_114;
    const double z_116 = m*z_88;
    const double z_117 = z_92*z_8;
    const double z_118 = l*(3.0*z_90 + z_116 + 5.0*z_91) - z_117;
    const double z_119 = z_92*z_59;
    const double z_120 = 2.0*z_113 + z_114;
    const double z_121 = l*(3.0*z_113 + z_101 + 5.0*z_114) + (z_119 - z_8*z_120);
    const double z_122 = l*(z_95 + 5.0*z_101 + 3.0*z_115) - (z_118*z_35 - sin_q4*z_121);
    const double z_123 = q1_dot*sin_q3;
    const double z_124 = m*z_18;
    const double z_125 = z_90 + 2.0*z_91;
    const double z_126 = sin_q4*z_118;
    const double z_127 = l*(z_124 + 5.0*z_116 + 3.0*z_125) + z_126;
    const double z_128 = q1_dot*z_33;
    const double z_129 = q1_dot*z_118;
    const double z_130 = q1_dot*l;
    const double z_131 = 5.0*z_95 + 6.0*z_101 + 3.0*z_115;
    const double z_132 = l*z_33;
    const double z_133 = q1_dot*z_19;
    const double z_134 = z_40 + z_133;
    const double z_135 = l*z_134;
    const double z_136 = q1_dot*z_22;
    const double z_137 = cos_q3*z_35;
    const double z_138 = z_136 + z_137 - sin_q4*z_134;
    const double z_139 = l*z_138;
    const double z_140 = sin_q2*z_130;
    const double z_141 = z_140 - z_130;
    const double z_142 = z_13*z_33;
    const double z_143 = sin_q3*z_31;
    const double z_144 = z_142 - z_143;
    const double z_145 = z_59*z_6;
    const double z_146 = q1_dot*z_13;
    const double z_147 = z_24*z_146;
    const double z_148 = z_144 + z_145 + z_147 + z_8*z_138;
    const double z_149 = z_135 - z_141;
    const double z_150 = 2.0*z_148 + 3.0*z_149 - 3.0*z_139;
    const double z_151 = m*(z_148 + 6.0*z_149 - 5.0*z_139) + m*z_150;
    const double z_152 = m*(5.0*z_135 - z_139 - 6.0*z_141) + z_151;
    const double z_153 = m*z_8;
    const double z_154 = z_60 + z_150*z_153 - l*z_151;
    const double z_155 = sin_q4*z_33;
    const double z_156 = cos_q3*z_153;
    const double z_157 = q5_dot*z_156;
    const double z_158 = m*z_13;
    const double z_159 = z_40*z_158;
    const double z_160 = cos_q5*cos_q1;
    const double z_161 = lambda_3*z_160;
    const double z_162 = cos_q1*lambda_3;
    const double z_163 = sin_q1*lambda_0;
    const double z_164 = cos_q1*lambda_2 + z_163;
    const double z_165 = sin_q3*z_11;
    const double q5_ddot = a[4];
    const double z_166 = cos_q3*z_8;
    const double z_167 = q5_ddot*z_166;
    const double z_168 = cos_q4*z_66;
    const double q4_ddot = a[3];
    const double z_169 = sin_q3*q4_ddot;
    const double z_170 = z_51*z_13;
    const double q3_ddot = a[2];
    const double z_171 = sin_q3*q3_ddot;
    const double z_172 = cos_q3*q3_ddot;
    const double q2_ddot = a[1];
    const double q1_ddot = a[0];
    const double z_173 = sin_q3*q1_ddot;
    const double z_174 = z_57 + 5.0*z_124 + 6.0*z_116 + 3.0*z_125;
    const double z_175 = l*q1_ddot;
    const double z_176 = q1_ddot*z_19;
    const double z_177 = cos_q3*z_73 + z_171;
    const double z_178 = q1_dot*z_98;
    const double z_179 = z_94*z_123;
    const double z_180 = z_178 + z_179;
    const double z_181 = z_176 + z_177 + z_180;
    const double z_182 = l*z_181;
    const double z_183 = cos_q4*q4_ddot;
    const double z_184 = q1_dot*z_102 + q1_dot*z_103;
    const double z_185 = z_40*z_35 + z_68*z_6 + z_134*z_35 + sin_q4*z_181 + z_184 - cos_q3*z_183 - z_22*q1_ddot;
    const double z_186 = l*z_185;
    const double z_187 = z_130*z_94;
    const double z_188 = z_187 + z_17*q1_ddot - z_175;
    const double z_189 = z_8*z_53;
    const double z_190 = sin_q4*z_54;
    const double z_191 = sin_q3*z_8;
    const double z_192 = q1_dot*z_54;
    const double z_193 = q1_dot*z_24;
    const double z_194 = z_192*z_94 - (z_31*z_193 + z_146*z_111);
    const double z_195 = z_33*z_31 - 0.5*z_194;
    const double z_196 = z_189*z_6 + z_59*z_39 + z_14*z_53 + z_14*z_73 + q5_ddot*z_191 + z_8*z_185 + 2.0*z_195 -
        z_137*z_59 - z_138*z_59 - q5_ddot*z_190 - z_54*q3_ddot - z_25*q1_ddot;
    const double z_197 = z_182 - z_188;
    const double z_198 = 3.0*z_186 + 3.0*z_197 - 2.0*z_196;
    const double z_199 = m*(5.0*z_186 + 6.0*z_197 - z_196) + m*z_198;
    const double z_200 = m*(5.0*z_182 + z_186 - 6.0*z_188) + z_199;
    const double z_201 = m*z_54;
    const double z_202 = m*z_59;
    const double z_203 = z_46*z_59 + z_65*z_53 + l*z_199 - z_150*z_202 - z_170*q5_ddot - z_198*z_153;
    const double z_204 = z_92*q1_ddot;
    const double z_205 = z_92*z_146;
    const double z_206 = z_54*z_204 - (z_120*z_192 + z_40*z_205);
    const double z_207 = q2_dot*z_32;
    const double z_208 = q2_dot*sin_q3;
    const double z_209 = q2_dot*z_40;
    const double z_210 = q2_dot*z_33;
    const double z_211 = q2_dot*z_54;
    const double z_212 = q2_dot*l;
    const double z_213 = 2.0*z_58 + z_74;
    const double z_214 = q2_dot*z_192;
    const double z_215 = q2_dot*z_123;
    const double z_216 = m*(l*l);
    const double z_217 = q2_dot*z_130;
    const double z_218 = z_135 - 5.0*z_141;
    const double z_219 = q2_dot*z_97;
    const double z_220 = q2_dot*z_38;
    const double z_221 = q2_dot*z_201;
    const double z_222 = cos_q4*z_9;
    const double z_223 = z_66*q4_ddot;
    const double z_224 = l*z_83;
    const double z_225 = q1_dot*cos_q4;
    const double z_226 = cos_q4*z_118;
    const double z_227 = z_121*z_225 - z_226*q1_ddot;
    D[1] = (1.0/6.0)*(cos_q2*(z_32*z_46 + 2.0*z_40*z_52 + z_67*z_33 + z_72*z_46 + 3.0*z_83*z_84 + z_127*z_128 +
        z_82*z_129 + z_130*z_131 + z_132*z_152 + 6.0*z_38*z_161 + 6.0*z_36*z_162 + z_168*z_169 + z_79*z_172 +
        z_168*q2_ddot + z_127*z_173 + z_97*z_200 + l*(6.0*z_164 - (z_57*q1_ddot + m*(z_182 - 5.0*z_188)) - z_200)
        + z_198*z_201 + z_203*z_38 + z_206 - z_53*z_55 - z_56*z_62 - z_38*z_69 - 2.0*z_66*z_71 - z_73*z_55 -
        z_76*z_33 - z_73*z_80 - z_81*z_55 - z_81*z_80 - z_82*z_62 - z_85*z_93 - z_122*z_123 - z_56*z_154 -
        z_155*z_154 - z_82*z_154 - z_150*z_157 - z_150*z_159 - 6.0*z_54*z_164 - 6.0*z_164*z_165 - z_51*z_167 -
        z_170*z_171 - z_174*z_175) + sin_q2*(2.0*z_51*z_207 + z_62*z_70 + 2.0*z_170*z_209 + z_46*z_211 +
        z_76*z_208 + q1_dot*q2_dot*z_216 + z_174*z_217 + q2_dot*z_57*z_218 + z_154*z_220 + z_154*z_70 +
        z_212*z_152 + 6.0*cos_q4*z_161 + 3.0*q2_ddot*z_224 + cos_q4*z_203 - z_67*z_208 - z_168*z_68 -
        2.0*z_79*z_210 - z_168*z_81 - 3.0*z_212*z_213 - z_92*z_214 - z_127*z_215 - z_70*z_129 - z_219*z_152 -
        z_150*z_221 - 6.0*z_164*z_222 - sin_q4*z_223 - q2_ddot*z_55 - q2_ddot*z_80 - z_227));
    const double z_228 = sin_q4*z_59;
    const double z_229 = sin_q4*z_8;
    const double z_230 = z_92*z_53;
    const double z_231 = sin_q2*z_31;
    const double z_232 = sin_q2*z_170;
    const double z_233 = q3_dot*sin_q2;
    const double z_234 = sin_q4*z_68;
    const double z_235 = q3_dot*z_13;
    const double z_236 = q3_dot*z_94;
    const double z_237 = z_46*z_13;
    const double z_238 = z_120*z_146;
    const double z_239 = q1_dot*sin_q2;
    const double z_240 = z_51*z_146;
    const double z_241 = q1_dot*z_233;
    const double z_242 = l*z_35;
    const double z_243 = z_54*z_94;
    const double z_244 = z_13*z_111;
    const double z_245 = z_24*z_31;
    const double z_246 = z_244 + z_245;
    const double z_247 = z_243 - z_246;
    const double z_248 = z_86*z_59;
    const double z_249 = sin_q3*z_94;
    const double z_250 = z_98 + z_249 + z_85;
    const double z_251 = z_104 + z_108 + sin_q4*z_250;
    const double z_252 = z_247 + z_248 - sin_q3*z_146 - z_8*z_251;
    const double z_253 = l*z_251;
    const double z_254 = l*z_250;
    const double z_255 = z_96 - z_254;
    const double z_256 = 3.0*z_255 - 2.0*z_252 - 3.0*z_253;
    const double z_257 = m*(6.0*z_255 - z_252 - 5.0*z_253) + m*z_256;
    const double z_258 = m*z_228;
    const double z_259 = z_35*z_153;
    const double z_260 = l*z_233;
    const double z_261 = sin_q2*z_106;
    const double z_262 = q5_dot*z_153;
    const double z_263 = sin_q2*z_262;
    const double z_264 = z_94*z_158;
    const double z_265 = q3_dot*z_158;
    const double z_266 = cos_q5*sin_q1;
    const double z_267 = lambda_3*z_266;
    const double z_268 = sin_q4*z_267;
    const double z_269 = sin_q2*sin_q5;
    const double z_270 = sin_q2*z_13;
    const double z_271 = sin_q1*lambda_2;
    const double z_272 = cos_q1*lambda_0;
    const double z_273 = z_271 - z_272;
    const double z_274 = z_92*z_13;
    const double z_275 = sin_q4*z_274;
    const double z_276 = sin_q2*z_65;
    const double z_277 = sin_q2*z_79;
    const double z_278 = cos_q2*z_170;
    const double z_279 = l*cos_q2;
    const double z_280 = z_17*z_81 - z_279*q2_ddot;
    const double z_281 = q2_dot*sin_q2;
    const double z_282 = z_70*z_281;
    const double z_283 = cos_q2*sin_q4;
    const double z_284 = z_283*q4_ddot;
    const double z_285 = cos_q4*sin_q2;
    const double z_286 = z_285*q2_ddot;
    const double z_287 = q1_dot*z_40;
    const double z_288 = cos_q2*sin_q3;
    const double z_289 = cos_q3*q1_ddot;
    const double z_290 = z_287 + z_73*z_19 + z_81*z_19 - 2.0*z_94*z_33 - q3_ddot*z_24 - q2_ddot*z_288 - z_289;
    const double z_291 = z_98*z_35 + z_249*z_35 + z_22*z_68 + z_22*z_81 + z_250*z_35 + z_183*z_19 + z_284 + z_286
        - z_29*z_68 - 2.0*z_282 - sin_q4*z_290;
    const double z_292 = l*z_291;
    const double z_293 = l*z_290;
    const double z_294 = l*sin_q4;
    const double z_295 = z_8*z_24;
    const double z_296 = z_86*z_13;
    const double z_297 = z_13*z_19;
    const double z_298 = cos_q2*z_54;
    const double z_299 = z_31*z_123 - z_33*z_146;
    const double z_300 = (z_31*z_111 - z_32*z_94) - (z_72*z_94 - 0.5*z_299);
    const double z_301 = q5_ddot*z_296 + q2_ddot*z_298 + 2.0*z_300 - z_25*z_53 - z_86*z_189 - z_109*z_59 -
        z_25*z_73 - z_25*z_81 - z_251*z_59 - q5_ddot*z_295 - q3_ddot*z_297 - z_14*q1_ddot - z_8*z_291;
    const double z_302 = z_280 - z_293;
    const double z_303 = 2.0*z_301 + 3.0*z_292 + 3.0*z_302;
    const double z_304 = m*(z_301 + 5.0*z_292 + 6.0*z_302) + m*z_303;
    const double z_305 = sin_q4*z_153;
    const double z_306 = sin_q2*z_158;
    const double z_307 = sin_q2*z_35;
    const double z_308 = sin_q2*sin_q4;
    const double z_309 = q3_dot*z_35;
    const double z_310 = q1_dot*z_94;
    const double z_311 = q1_dot*q3_dot;
    const double z_312 = 6.0*z_96 - z_253 - 5.0*z_254;
    const double z_313 = q3_dot*z_57;
    const double z_314 = l*z_106;
    const double z_315 = z_106*z_153;
    const double z_316 = q3_dot*l;
    const double z_317 = sin_q4*z_94;
    const double z_318 = z_158*z_233;
    const double z_319 = sin_q5*sin_q1;
    const double z_320 = sin_q2*z_11;
    const double z_321 = cos_q2*z_79;
    const double z_322 = z_127*q1_ddot;
    const double z_323 = z_46*z_146;
    const double z_324 = z_323 - z_170*q1_ddot;
    D[2] = (1.0/6.0)*(sin_q3*(z_228*z_120 + z_229*z_230 + z_53*z_232 + 2.0*z_94*z_52 + 2.0*q3_dot*z_93 +
        z_73*z_232 + z_120*z_235 + z_76*z_233 + z_94*z_237 + z_81*z_232 + sin_q2*z_238 + z_239*z_93 + q3_dot*z_240
        + q1_dot*z_76 + z_242*z_257 + z_154*z_261 + z_150*z_263 + 6.0*z_164*z_270 + 6.0*z_11*z_273 + q5_ddot*z_276
        + z_118*z_183 + z_303*z_305 - z_119*z_35 - z_46*z_231 - z_67*z_233 - z_121*z_35 - z_118*z_234 -
        2.0*z_79*z_236 - z_127*z_73 - z_94*z_205 - z_127*z_241 - z_256*z_258 - z_256*z_259 - z_152*z_260 -
        z_150*z_264 - z_256*z_265 - 6.0*z_268 - 6.0*z_162*z_269 - q5_ddot*z_275 - z_274*q3_ddot - q3_ddot*z_277 -
        q2_ddot*z_278 - z_270*z_204 - z_79*q1_ddot - z_57*(6.0*z_280 + z_292 - 5.0*z_293) - z_294*z_304 - l*z_304
        - z_198*z_306) - cos_q3*(z_119*z_106 + z_274*z_53 + z_62*z_307 + z_308*z_69 + 2.0*z_170*z_236 + z_274*z_73
        + z_73*z_277 + q3_dot*z_122 + z_76*z_94 + z_81*z_277 + z_233*z_205 + z_122*z_239 + z_79*z_311 +
        z_256*z_315 + z_154*z_307 + z_154*z_317 + z_150*z_318 + z_256*z_262 + 6.0*lambda_3*z_319 + 6.0*z_164*z_320
        + z_117*q5_ddot + q3_ddot*z_232 + z_303*z_158 - 2.0*z_233*z_52 - z_120*z_31 - z_67*z_94 - z_118*z_309 -
        z_233*z_237 - q1_dot*z_52 - z_127*z_310 - z_312*z_313 - z_257*z_314 - z_257*z_316 - z_96*z_152 -
        6.0*z_308*z_161 - 6.0*z_273*z_13 - z_285*z_223 - z_127*q3_ddot - q2_ddot*z_321 - sin_q2*z_322 - z_17*z_200
        - z_308*z_203 - z_324));
    const double z_325 = q4_dot*cos_q2;
    const double z_326 = q4_dot*z_66;
    const double z_327 = cos_q3*z_118;
    const double z_328 = q1_dot*cos_q2;
    const double z_329 = q4_dot*z_328;
    const double z_330 = z_40*z_153;
    const double z_331 = cos_q3*z_202;
    const double z_332 = z_164*z_19 + cos_q3*z_273;
    const double z_333 = z_92*q5_ddot;
    const double z_334 = q4_dot*z_59;
    const double z_335 = cos_q3*z_92;
    const double z_336 = q4_dot*z_19;
    const double z_337 = q4_dot*cos_q3;
    const double z_338 = q4_dot*z_118;
    const double z_339 = cos_q2*z_81;
    const double z_340 = q4_dot*z_42;
    const double z_341 = q4_dot*z_156;
    const double z_342 = cos_q2*z_9;
    const double z_343 = sin_q2*q2_ddot;
    D[3] = ((-1.0/6.0))*(cos_q4*(cos_q3*z_120*z_59 + z_166*z_230 + z_40*z_119 + z_19*z_69 + z_62*z_325 +
        2.0*z_281*z_326 + z_121*z_134 + z_62*z_250 + z_256*z_330 + z_98*z_154 + z_249*z_154 + z_154*z_325 +
        6.0*z_9*z_332 + z_66*z_290 + z_303*z_156 - z_68*z_327 - z_118*z_329 - z_41*z_257 - z_256*z_331 -
        6.0*cos_q3*z_267 - 6.0*z_19*z_161 - z_54*z_333 - cos_q2*z_223 - z_118*z_181 - z_42*z_304 - z_203*z_19) +
        sin_q4*(z_334*z_335 + z_98*z_326 + z_249*z_326 + cos_q2*z_69 + z_121*z_337 + z_40*z_338 + z_66*z_339 +
        z_134*z_338 + z_121*z_328 + z_281*z_129 + z_250*z_326 + z_256*z_341 + 6.0*z_164*z_342 + z_19*z_223 +
        z_66*z_343 - z_62*z_336 - z_62*z_281 - z_257*z_340 - z_154*z_336 - z_154*z_281 - 6.0*cos_q2*z_161 -
        q4_ddot*z_327 - cos_q2*z_118*q1_ddot - cos_q2*z_203));
    const double z_344 = q5_dot*l;
    const double z_345 = z_92*z_344;
    const double z_346 = q5_dot*z_42;
    const double z_347 = z_92*z_35;
    const double z_348 = l*z_24;
    const double z_349 = z_51*z_348;
    const double z_350 = z_51*z_344;
    const double z_351 = l*z_46;
    const double z_352 = l*z_51;
    const double z_353 = z_97*z_73;
    const double z_354 = z_42*z_94;
    const double z_355 = z_130*z_120;
    const double z_356 = z_130*z_111;
    const double z_357 = z_42*z_310;
    const double z_358 = q1_dot*z_97;
    const double z_359 = z_130*z_33;
    const double z_360 = q5_dot*z_57;
    const double z_361 = z_6*z_360;
    const double z_362 = z_86*z_360;
    const double z_363 = z_57*z_111;
    const double z_364 = z_63*z_94;
    const double z_365 = z_57*z_33;
    const double z_366 = sin_q1*lambda_3;
    const double z_367 = z_86*z_352;
    const double z_368 = z_42*z_92;
    const double z_369 = cos_q2*z_42;
    const double z_370 = z_51*q1_ddot;
    const double z_371 = z_57*sin_q3;
    const double z_372 = z_57*z_24;
    const double z_373 = z_24*z_344;
    const double z_374 = z_51*z_94;
    const double z_375 = z_57*z_39;
    const double z_376 = z_63*z_35;
    const double z_377 = z_57*z_109;
    const double z_378 = z_24*z_360;
    const double z_379 = sin_q3*z_360;
    const double z_380 = sin_q3*sin_q1;
    const double z_381 = l*z_92;
    const double z_382 = z_57*z_6;
    const double z_383 = z_57*z_86;
    D[4] = (1.0/6.0)*(sin_q5*(q5_dot*z_47*z_120 + z_39*z_345 + z_53*z_349 + z_97*z_230 + z_86*z_46*z_344 +
        z_109*z_350 + z_73*z_349 + 2.0*z_40*z_94*z_352 + z_132*z_120 + z_92*z_353 + z_46*z_354 + z_81*z_349 +
        z_24*z_355 + z_92*z_356 + z_51*z_359 + z_251*z_350 + z_150*z_363 + 6.0*z_22*z_162 + 6.0*z_348*z_164 +
        q3_ddot*z_19*z_352 + z_97*z_370 + z_371*z_303 - z_346*z_347 - z_111*z_351 - z_92*z_357 - z_46*z_358 -
        z_138*z_345 - z_256*z_361 - z_150*z_362 - z_150*z_364 - z_365*z_256 - 6.0*z_6*z_366 - 6.0*z_29*z_162 -
        6.0*z_97*z_273 - z_47*z_333 - q5_ddot*z_367 - q3_ddot*z_368 - z_51*q2_ddot*z_369 - z_348*z_204 -
        z_372*z_198) - cos_q5*(z_47*z_230 + 2.0*z_346*z_374 + 2.0*z_33*z_345 + z_53*z_367 + z_193*z_345 +
        z_120*z_139 + z_256*z_375 + z_150*z_377 + z_150*z_378 + z_256*z_379 + 6.0*z_380*lambda_3 +
        6.0*l*(z_22*z_164 - sin_q4*z_332) + q5_ddot*z_349 + z_97*z_333 + z_185*z_381 + z_291*z_352 + z_303*z_382 -
        z_46*z_373 - 2.0*z_111*z_350 - sin_q3*z_120*z_344 - z_123*z_350 - z_251*z_351 - z_256*z_376 -
        6.0*z_24*z_162 - z_198*z_383));
    D[5] = ((-1.0/6.0))*(l*z_131 + (z_79*z_40 + cos_q3*z_76) + (z_174*z_96 - z_17*z_131) + z_94*z_216 +
        (z_170*z_33 - sin_q3*z_52 - z_14*z_46) - (z_118*z_103 + z_118*z_102 + z_22*z_121) - (z_127*z_249 +
        z_127*z_98 - z_122*z_19) - (z_92*z_243 - z_274*z_111 - z_24*z_93 - z_25*z_120));
    const double z_384 = z_281*z_224;
    const double z_385 = sin_q2*z_70;
    const double z_386 = z_66*z_385 - z_168*z_94;
    const double z_387 = q2_dot*z_19;
    const double z_388 = z_79*z_387 - z_33*z_321;
    const double z_389 = q2_dot*z_24;
    const double z_390 = cos_q2*z_51*z_32 + (z_170*z_389 + z_40*z_278);
    const double z_391 = 3.0*(z_384 + z_279*z_213) - (z_285*z_62 + z_386) - (z_76*z_288 + z_388) - (z_46*z_298 +
        z_390);
    const double z_392 = z_57*cos_q2;
    const double z_393 = cos_q2*z_97;
    const double z_394 = cos_q2*z_38;
    const double z_395 = cos_q2*z_201;
    const double z_396 = cos_q2*z_130;
    const double z_397 = cos_q2*z_192;
    const double z_398 = cos_q2*z_123;
    const double z_399 = ((z_216*z_328 - z_285*z_129) + (z_174*z_396 + z_386)) + ((z_388 + z_390) - 3.0*((z_384 +
        (1.0/3.0)*z_67*z_288) + (1.0/3.0)*(z_92*z_397 + z_127*z_398)));
    D[6] = (1.0/6.0)*(z_391 + z_393*z_152 + z_150*z_395 - z_392*z_218 - z_394*z_154 - z_285*z_154 - z_279*z_152 -
        z_399);
    const double z_400 = z_127*z_33;
    const double z_401 = z_79*z_110 - z_79*z_111;
    const double z_402 = z_40*z_274 + z_92*z_32;
    const double z_403 = z_19*z_52 - (z_249*z_170 + z_98*z_170);
    const double z_404 = (z_400 - sin_q3*z_122) + (z_401 - z_76*z_24) - (z_54*z_120 + z_402) - (-z_46*z_297 -
        z_403);
    const double z_405 = l*z_38;
    const double z_406 = z_153*z_38;
    const double z_407 = sin_q4*z_24;
    const double z_408 = z_19*z_158;
    const double z_409 = ((z_127*z_193 - z_79*z_123) + (z_401 - z_402)) + ((z_403 + (z_400 - z_119*z_38)) +
        ((z_67*z_24 + z_118*z_56) - (z_19*z_205 + z_51*z_192)));
    D[7] = (1.0/6.0)*(z_404 + z_371*z_312 + z_405*z_257 + z_97*z_257 + z_348*z_152 + z_256*z_201 + z_409 -
        z_256*z_406 - z_154*z_407 - z_150*z_408);
    const double z_410 = z_70*z_327;
    const double z_411 = cos_q4*cos_q3;
    const double z_412 = z_78*z_281 - cos_q2*z_67;
    const double z_413 = z_66*z_19*z_70;
    const double z_414 = cos_q4*z_19;
    const double z_415 = (z_410 + z_40*z_226 + z_121*z_411) - (z_283*z_62 + z_412) - (z_413 + z_414*z_62 -
        z_249*z_168 - z_98*z_168);
    const double z_416 = cos_q4*z_42;
    const double z_417 = cos_q4*z_156;
    const double z_418 = cos_q4*z_59;
    const double z_419 = (z_418*z_335 + z_283*z_129) - (z_412 - (z_410 - z_413));
    D[8] = (1.0/6.0)*(z_415 + z_226*z_134 + z_168*z_250 + z_256*z_417 + z_419 - z_257*z_416 - z_414*z_154 -
        z_283*z_154);
    const double z_420 = z_86*z_52;
    const double z_421 = z_117*z_33 + sin_q3*z_119;
    const double z_422 = z_65*z_111 - (z_166*z_374 + z_60*z_24);
    const double z_423 = z_6*z_93;
    const double z_424 = (z_170*z_109 + z_420 + z_46*z_296) + (z_421 - z_120*z_191) + (-z_46*z_295 - z_422) -
        (z_54*z_347 - z_274*z_39 - z_423 - z_120*z_190);
    const double z_425 = sin_q4*z_201;
    const double z_426 = z_86*z_158;
    const double z_427 = z_24*z_153;
    const double z_428 = sin_q3*z_153;
    const double z_429 = (z_421 - z_422) + ((z_420 + z_423) + (z_117*z_193 - z_65*z_123));
    D[9] = ((-1.0/6.0))*(z_424 + z_170*z_251 + z_150*z_427 + z_256*z_428 + z_429 - z_274*z_138 - z_256*z_425 -
        z_150*z_426);
    const double z_430 = cos_q5*lambda_3;
    const double z_431 = lambda_3*z_36;
    const double z_432 = z_9*z_285;
    const double z_433 = z_11*lambda_2;
    const double z_434 = z_11*lambda_0;
    D[10] = cos_q1*(z_285*z_430 + z_394*z_430 + cos_q2*z_431 + z_279*lambda_2 - lambda_2*z_432 - lambda_2*z_298 -
        z_288*z_433) - sin_q1*(lambda_0*z_432 + lambda_0*z_298 + z_288*z_434 - z_279*lambda_0);
    const double g = c[2];
    const double z_435 = z_57*g;
    const double z_436 = 3.0*z_435 - g*z_153;
    const double z_437 = q1_dot*q1_dot;
    const double z_438 = q1_dot*z_59;
    const double z_439 = 2.0*z_287 + z_437*z_19;
    const double z_440 = 2.0*z_85*z_35 + z_22*z_437 - sin_q4*z_439;
    const double z_441 = 2.0*z_6*z_438 + z_25*z_437 + z_8*z_440 - 2.0*z_299;
    const double z_442 = l*z_440;
    const double z_443 = l*z_439;
    const double z_444 = l*z_437;
    const double z_445 = z_17*z_437 - z_444;
    const double z_446 = z_443 - z_445;
    const double z_447 = 2.0*z_441 + 3.0*z_446 - 3.0*z_442;
    const double z_448 = m*(z_441 + 6.0*z_446 - 5.0*z_442) + m*z_447;
    const double z_449 = z_447*z_153;
    const double z_450 = 2.0*z_51*z_438 + z_449 - l*z_448;
    const double z_451 = q1_dot*z_70;
    const double z_452 = (z_66*z_451 + z_51*z_214) + (z_79*z_215 - 3.0*z_83*z_217);
    const double z_453 = z_279 - z_393;
    const double z_454 = m*z_453;
    const double z_455 = z_285 + z_394;
    const double z_456 = l*z_455;
    const double z_457 = m*(z_453 - z_456);
    const double z_458 = z_457 + z_455*z_153 - z_395;
    const double z_459 = z_457 + 0.5*z_458;
    const double z_460 = 5.0*z_392 + 6.0*z_454 + 6.0*z_459;
    const double z_461 = z_457 + 2.0*z_458;
    const double z_462 = l*(z_454 + 5.0*z_457 + 3.0*z_458) - z_8*z_461;
    const double z_463 = l*(z_392 + 5.0*z_454 + 6.0*z_459) + sin_q4*z_462;
    const double z_464 = sin_q3*z_437;
    const double z_465 = z_54*z_437;
    const double z_466 = l - z_97;
    const double z_467 = z_9*z_38;
    const double z_468 = z_466 - z_54 - z_467;
    const double lambda_1 = lambda[1];
    const double z_469 = z_279*z_437;
    const double z_470 = cos_q2*z_437;
    const double z_471 = z_97*z_470;
    const double z_472 = z_285*z_437 + z_38*z_470;
    const double z_473 = l*z_472;
    const double z_474 = z_54*z_470 - z_8*z_472;
    const double z_475 = z_469 - z_471;
    const double z_476 = 3.0*z_475 - 2.0*z_474 - 3.0*z_473;
    const double z_477 = m*(6.0*z_475 - z_474 - 5.0*z_473) + m*z_476;
    const double z_478 = m*(6.0*z_469 - 5.0*z_471 - z_473) + z_477;
    const double z_479 = l*z_477 - z_476*z_153;
    const double z_480 = m*(5.0*z_443 - z_442 - 6.0*z_445) + z_448;
    const double z_481 = q1_dot*z_82;
    const double z_482 = (z_85*z_52 + z_40*z_240) - (z_79*z_128 + z_66*z_481);
    const double z_483 = cos_q4*z_437;
    const double z_484 = sin_q1*z_36 + z_38*z_266;
    const double z_485 = l*sin_q1 - z_11*z_380 - sin_q1*z_54;
    const double z_486 = z_11*cos_q1;
    const double z_487 = l*cos_q1 - sin_q3*z_486 - cos_q1*z_54;
    D[11] = ((-1.0/12.0))*(cos_q2*(2.0*z_62*z_225 + z_444*z_460 + 12.0*z_271*z_222 + 12.0*z_468*lambda_1 +
        l*(m*(5.0*z_469 - z_471) + z_478) + 2.0*z_452 - (30.0*g*z_371 + 6.0*g*z_201 + 6.0*z_436*z_38 +
        cos_q4*z_450 + 2.0*z_452 - 42.0*z_435 - z_226*z_437) - z_463*z_464 - z_461*z_465 - 12.0*cos_q4*z_267 -
        12.0*z_272*z_222 - 2.0*z_168*q1_ddot - z_97*z_478 - z_201*z_476 - z_479*z_38) - sin_q2*((6.0*cos_q4*z_436
        + 2.0*z_67*z_123 + z_92*z_465 + z_127*z_464 + z_97*z_480 + z_447*z_201 - z_174*z_444 - l*((z_57*z_437 +
        m*(z_443 - 5.0*z_445)) + z_480) - z_450*z_38 - 2.0*z_482) + 2.0*z_46*z_192 + 2.0*z_76*z_123 + z_462*z_483
        + 12.0*z_487*lambda_0 + 12.0*lambda_1*z_222 + 6.0*q1_ddot*z_224 + cos_q4*z_479 + 2.0*z_482 -
        6.0*z_130*z_213 - 12.0*z_484*lambda_3 - 12.0*z_485*lambda_2 - 2.0*q1_ddot*z_55 - 2.0*z_79*z_173));
    const double z_488 = l*cos_q4;
    const double z_489 = cos_q4*z_8;
    const double z_490 = m*(z_488 - z_489);
    const double z_491 = z_57*cos_q4;
    const double z_492 = 2.0*z_490 + z_491;
    const double z_493 = z_492*z_59;
    const double z_494 = m*(l*z_70 - (z_8*z_70 - z_418));
    const double z_495 = z_57*z_70;
    const double z_496 = 2.0*z_494 + z_495;
    const double z_497 = z_492*z_13;
    const double z_498 = z_492*z_8;
    const double z_499 = l*(3.0*z_490 + 5.0*z_491) - z_498;
    const double z_500 = z_8*z_496;
    const double z_501 = l*(3.0*z_494 + 5.0*z_495) + (z_493 - z_500);
    const double z_502 = z_494 + 2.0*z_495;
    const double z_503 = cos_q3*cos_q5;
    const double z_504 = z_405 - z_466;
    const double z_505 = m*(-l*(z_503 - sin_q5*z_38) - z_504);
    const double z_506 = m*(-z_504);
    const double z_507 = 2.0*z_505 + z_506;
    const double z_508 = q2_dot*z_507;
    const double z_509 = m*z_466;
    const double z_510 = l*(3.0*z_505 + z_509 + 5.0*z_506) - z_507*z_8;
    const double z_511 = l*(z_57 + 3.0*z_505 + 5.0*z_509 + 6.0*z_506) + sin_q4*z_510;
    const double z_512 = q4_dot + z_208;
    const double z_513 = z_294*z_512;
    const double z_514 = 5.0*z_219 + z_513 - 6.0*z_212;
    const double z_515 = z_418 + z_211 - z_229*z_512;
    const double z_516 = z_219 - z_212;
    const double z_517 = 2.0*z_515 + 3.0*z_513 + 3.0*z_516;
    const double z_518 = m*(z_515 + 5.0*z_513 + 6.0*z_516) + m*z_517;
    const double z_519 = q1_dot*z_285;
    const double z_520 = z_519 + z_38*z_328;
    const double z_521 = z_397 - z_8*z_520;
    const double z_522 = l*z_520;
    const double z_523 = z_97*z_328;
    const double z_524 = z_396 - z_523;
    const double z_525 = 3.0*z_524 - 2.0*z_521 - 3.0*z_522;
    const double z_526 = m*(6.0*z_524 - z_521 - 5.0*z_522) + m*z_525;
    const double z_527 = cos_q2*z_447;
    const double z_528 = z_437*z_270;
    const double z_529 = q3_dot*z_146;
    const double z_530 = q1_dot*z_35;
    const double z_531 = q1_dot*z_228;
    const double z_532 = sin_q5*lambda_3;
    const double z_533 = cos_q2*sin_q1;
    const double z_534 = lambda_2*z_13;
    const double z_535 = z_492*q5_ddot;
    const double z_536 = sin_q4*z_499;
    const double z_537 = z_490 + 2.0*z_491;
    const double z_538 = l*z_537;
    const double z_539 = z_59*z_70;
    const double z_540 = cos_q4*z_13;
    const double z_541 = z_210 + sin_q3*q2_ddot;
    const double z_542 = q4_ddot + z_541;
    const double z_543 = z_512*z_35 + sin_q4*z_542;
    const double z_544 = q2_dot*z_13;
    const double z_545 = z_207 + z_40*z_544;
    const double z_546 = cos_q4*z_189 + z_539 + z_228*z_512 + z_8*z_543 + z_545 - q5_ddot*z_540 - z_54*q2_ddot;
    const double z_547 = l*z_543;
    const double z_548 = l*q2_ddot;
    const double z_549 = l*z_541;
    const double z_550 = z_548 - z_549;
    const double z_551 = 2.0*z_546 + 3.0*z_550 - 3.0*z_547;
    const double z_552 = z_279*q1_ddot;
    const double z_553 = z_285*q1_ddot + z_394*q1_ddot;
    const double z_554 = l*z_553;
    const double z_555 = z_393*q1_ddot;
    const double z_556 = z_520*z_59 + z_8*z_553 - z_455*z_438 - q1_ddot*z_298;
    const double z_557 = z_552 - z_555;
    const double z_558 = 2.0*z_556 + 3.0*z_557 - 3.0*z_554;
    const double z_559 = m*(z_556 + 6.0*z_557 - 5.0*z_554) + m*z_558;
    const double z_560 = z_507*z_13;
    const double z_561 = cos_q3*z_34;
    const double z_562 = z_132 + (z_294*z_33 + z_97*z_35);
    const double z_563 = m*(z_562 - l*((cos_q5*z_40 + z_561) + (z_38*z_37 + sin_q5*z_155 + sin_q5*z_56)));
    const double z_564 = m*z_562;
    const double z_565 = 2.0*z_563 + z_564;
    const double z_566 = cos_q2*z_13;
    const double z_567 = q2_ddot*z_560 - (z_565*z_544 + 6.0*z_272*z_566);
    const double z_568 = z_492*z_53;
    const double z_569 = q3_dot*z_31;
    const double z_570 = z_507*z_544;
    const double z_571 = z_563 + 2.0*z_564;
    const double z_572 = l*(3.0*z_563 + z_365 + 5.0*z_564) + (z_507*z_59 - z_8*z_565);
    const double z_573 = z_510*z_35 - sin_q4*z_572;
    const double z_574 = l*(5.0*z_365 + 3.0*z_571) - z_573;
    const double z_575 = 6.0*z_396 - z_522 - 5.0*z_523;
    const double z_576 = sin_q2*z_437;
    const double z_577 = q1_dot*z_31;
    const double z_578 = z_9*lambda_1;
    const double z_579 = sin_q4*z_497;
    const double z_580 = m*(z_546 + 6.0*z_550 - 5.0*z_547) + m*z_551;
    D[12] = (1.0/12.0)*(sin_q3*(2.0*z_493*z_106 + 2.0*z_497*z_53 + 2.0*z_497*z_73 + 2.0*z_501*z_106 +
        6.0*z_502*z_316 + 2.0*q2_dot*q3_dot*z_511 + 2.0*z_517*z_315 + 2.0*cos_q2*z_323 + 2.0*z_242*z_526 +
        z_158*z_527 + z_274*z_470 + 2.0*z_462*z_530 + 2.0*z_517*z_262 + 12.0*z_534*z_533 + 2.0*z_8*z_535 +
        2.0*z_551*z_158 + 2.0*z_57*(6.0*z_552 - z_554 - 5.0*z_555) + 2.0*z_294*z_559 + 2.0*l*z_559 + 2.0*z_567 -
        2.0*z_496*z_31 - 4.0*z_499*z_309 - 2.0*z_31*z_508 - 2.0*z_514*z_313 - 2.0*z_314*z_518 - 2.0*z_525*z_258 -
        2.0*z_525*z_259 - z_461*z_528 - 2.0*z_461*z_529 - 2.0*z_461*z_531 - 6.0*g*z_306 - 2.0*z_316*z_518 -
        2.0*z_525*z_265 - 12.0*z_532*z_533 - 12.0*lambda_1*z_270 - 2.0*q3_ddot*z_536 - 6.0*q3_ddot*z_538 -
        2.0*q1_ddot*z_278 - 2.0*z_558*z_305 - z_476*z_306) + cos_q3*(6.0*z_308*z_436 + 2.0*z_228*z_496 +
        2.0*z_229*z_568 + 4.0*z_492*z_569 + 2.0*z_496*z_235 + 2.0*q3_dot*z_570 + 2.0*q2_dot*z_574 +
        2.0*z_242*z_518 + 2.0*z_575*z_313 + 2.0*z_314*z_526 + 2.0*z_316*z_526 + z_283*z_450 + z_463*z_576 +
        2.0*z_463*z_311 + 30.0*sin_q2*z_435 + 12.0*z_283*z_267 + 12.0*z_308*z_578 + 12.0*cos_q2*z_11*z_272 +
        2.0*z_499*z_183 + 2.0*l*(6.0*sin_q2*lambda_1 - m*(6.0*z_548 - z_547 - 5.0*z_549) - z_580) +
        2.0*z_551*z_305 + 2.0*q1_ddot*z_321 + 2.0*z_558*z_158 + z_17*z_478 + z_308*z_479 - 2.0*z_493*z_35 -
        2.0*z_501*z_35 - 2.0*z_499*z_234 - 2.0*z_73*z_536 - 6.0*z_73*z_538 - 2.0*z_517*z_259 - 2.0*z_76*z_328 -
        2.0*z_525*z_315 - z_279*z_480 - z_127*z_470 - 2.0*z_67*z_328 - 2.0*z_461*z_577 - 2.0*z_517*z_258 -
        2.0*z_517*z_265 - 2.0*z_525*z_262 - 12.0*z_533*z_433 - 2.0*q5_ddot*z_579 - 2.0*z_497*q3_ddot -
        2.0*z_511*q2_ddot - 2.0*z_294*z_580));
    const double z_581 = sin_q3*z_499;
    const double z_582 = q2_dot*q4_dot;
    const double z_583 = z_72 + z_32;
    const double z_584 = z_59*z_38;
    const double z_585 = z_56 + z_155 + z_82;
    const double z_586 = z_583 + z_584 + z_8*z_585;
    const double z_587 = l*z_585;
    const double z_588 = 6.0*z_132 + 5.0*z_587 - z_586;
    const double z_589 = q4_dot*z_57;
    const double z_590 = 3.0*z_132 + 3.0*z_587 - 2.0*z_586;
    const double z_591 = q4_dot*z_153;
    const double z_592 = z_153*z_33;
    const double z_593 = z_85*z_59;
    const double z_594 = sin_q3*z_202;
    const double z_595 = z_271*z_288 - z_272*z_288;
    const double z_596 = z_66*q1_ddot;
    const double z_597 = sin_q3*z_492;
    const double z_598 = q4_dot*z_499;
    const double z_599 = q2_dot*z_501;
    const double z_600 = q4_dot*z_97;
    const double z_601 = q4_dot*z_428;
    const double z_602 = q4_dot*z_85;
    const double z_603 = sin_q2*sin_q1;
    const double z_604 = z_9*z_603;
    const double z_605 = sin_q2*z_9;
    const double z_606 = lambda_1*z_342;
    const double z_607 = z_499*q2_ddot;
    const double z_608 = z_353 - z_42*q3_ddot;
    const double z_609 = z_13*z_38;
    const double z_610 = z_35*z_33;
    const double z_611 = cos_q4*q2_ddot;
    const double z_612 = 2.0*z_610 + sin_q3*z_183 + q3_ddot*z_6 + z_611 - z_68*z_38 - z_73*z_38 - z_71;
    const double z_613 = z_56*z_59 + z_228*z_33;
    const double z_614 = (z_54*z_73 + z_167) + (z_14*q3_ddot - 2.0*(z_40*z_31 - 0.5*z_54*z_53));
    const double z_615 = z_189*z_38 - z_585*z_59 - q5_ddot*z_609 - z_8*z_612 - z_613 - z_614;
    const double z_616 = l*z_612;
    const double z_617 = 3.0*z_608 - 2.0*z_615 - 3.0*z_616;
    D[13] = (1.0/12.0)*(cos_q4*(2.0*sin_q3*z_496*z_59 + 2.0*z_191*z_568 + 2.0*z_507*z_334 + 2.0*z_590*z_591 +
        2.0*z_572*z_512 + 2.0*z_132*z_518 + 2.0*z_41*z_526 + 2.0*z_525*z_331 + z_450*z_288 + z_439*z_462 +
        2.0*z_461*z_593 + 6.0*z_436*z_19 + 12.0*z_288*z_267 + 12.0*z_19*z_578 + 2.0*z_499*z_172 + 2.0*z_551*z_428
        + 2.0*z_288*z_596 + 2.0*z_558*z_156 + z_479*z_19 - 2.0*z_493*z_33 - 2.0*z_68*z_581 - 2.0*z_501*z_33 -
        2.0*z_73*z_581 - 2.0*z_499*z_582 - 2.0*z_588*z_589 - 2.0*z_590*z_589 - 2.0*z_517*z_592 - 2.0*z_62*z_398 -
        2.0*z_525*z_330 - 2.0*z_517*z_594 - 12.0*z_9*z_595 - 2.0*z_14*z_535 - 2.0*z_510*z_542 - 2.0*z_97*z_580 -
        z_118*z_437*z_288 - 2.0*z_42*z_559) + sin_q4*(2.0*z_334*z_597 + 2.0*q4_dot*sin_q3*z_501 + 2.0*z_599 +
        2.0*z_590*z_202 + 2.0*q4_dot*z_510*z_512 + 2.0*z_517*z_601 + 2.0*z_62*z_239 + 2.0*z_526*z_340 +
        z_462*z_470 + z_118*z_576 + 2.0*z_462*z_602 + 6.0*cos_q2*z_436 + 12.0*lambda_2*z_604 + 12.0*z_606 +
        2.0*q5_ddot*z_560 + 2.0*z_57*(6.0*z_608 - z_615 - 5.0*z_616) + 2.0*z_57*z_617 + cos_q2*z_479 -
        2.0*z_565*z_59 - 2.0*z_507*z_189 - 4.0*z_33*z_598 - 2.0*z_518*z_600 - 2.0*z_525*z_341 - sin_q2*z_450 -
        12.0*sin_q2*z_267 - 12.0*z_272*z_605 - 2.0*z_499*z_169 - 2.0*z_607 - 2.0*z_617*z_153 - 2.0*sin_q2*z_596));
    const double z_618 = z_496*z_38;
    const double z_619 = z_492*z_344;
    const double z_620 = z_507*z_70;
    const double z_621 = q2_dot*z_42;
    const double z_622 = z_40*z_212;
    const double z_623 = cos_q4*z_360;
    const double z_624 = sin_q4*z_344;
    const double z_625 = z_348*z_437;
    const double z_626 = q1_dot*z_350;
    const double z_627 = q1_dot*z_47;
    const double z_628 = q5_dot*z_627;
    const double z_629 = z_38*z_360;
    const double z_630 = lambda_3*z_533;
    const double z_631 = z_507*z_488;
    const double z_632 = z_42*q2_ddot;
    const double z_633 = z_371*z_35;
    const double z_634 = z_57*z_155;
    const double z_635 = z_57*z_447;
    const double z_636 = z_344*z_123;
    const double z_637 = cos_q3*z_360;
    const double z_638 = l*z_492;
    const double z_639 = l*z_507;
    const double z_640 = z_57*z_38;
    D[14] = ((-1.0/12.0))*(sin_q5*(2.0*z_344*z_618 + 2.0*cos_q4*z_565*z_344 + 2.0*z_344*z_620 + 2.0*z_41*z_496 +
        2.0*z_565*z_621 + 2.0*z_507*z_622 + 2.0*z_507*z_512*z_624 + 2.0*z_525*z_361 + z_461*z_625 +
        2.0*z_461*z_359 + 2.0*z_455*z_626 + 2.0*z_461*z_628 + 6.0*z_435*z_24 + 2.0*z_365*z_525 + 12.0*z_285*z_366
        + 12.0*z_38*z_630 + 12.0*z_348*lambda_1 + 12.0*z_272*z_369 + 2.0*z_369*z_370 + 2.0*z_371*z_558 +
        z_372*z_476 - 2.0*z_56*z_619 - 2.0*z_155*z_619 - 2.0*z_42*z_568 - 2.0*z_42*z_492*z_73 - 2.0*z_585*z_619 -
        2.0*z_590*z_623 - 2.0*z_42*z_46*z_328 - 2.0*z_520*z_350 - z_63*z_527 - z_470*z_368 - 2.0*z_517*z_629 -
        2.0*z_58*z_517 - 12.0*z_42*lambda_2*z_533 - 2.0*z_405*z_535 - 2.0*q5_ddot*z_631 - 2.0*z_97*z_492*q3_ddot -
        2.0*z_507*z_632 - 2.0*z_63*z_551) - cos_q5*(2.0*z_405*z_568 + 2.0*z_496*z_346 + 4.0*z_40*z_619 +
        2.0*z_53*z_631 + 2.0*z_346*z_508 + 2.0*z_496*z_587 + 2.0*z_495*z_590 + 2.0*z_520*z_351 + 2.0*z_525*z_376 +
        z_455*z_635 + z_442*z_461 + 6.0*z_86*z_435 + 12.0*cos_q3*z_630 + 12.0*l*(z_285*z_271 + z_22*lambda_1 +
        sin_q4*z_595 - z_29*lambda_1 - z_285*z_272) + 2.0*z_491*z_617 + 2.0*z_543*z_639 + 2.0*z_551*z_640 +
        z_472*z_381 + 2.0*z_558*z_382 + z_476*z_383 - 2.0*z_565*z_513 - 2.0*z_517*z_633 - 2.0*z_517*z_634 -
        2.0*z_525*z_375 - 2.0*z_461*z_636 - 2.0*z_517*z_637 - 2.0*z_525*z_379 - 2.0*z_42*z_535 - 2.0*z_612*z_638 -
        2.0*z_553*z_352));
    D[15] = ((-1.0/6.0))*(z_140*z_460 + z_136*z_462 + z_137*z_462 + z_143*z_461 - z_391 - z_130*z_460 -
        z_133*z_463 - z_147*z_461 - z_40*z_463 - z_142*z_461 - z_455*z_60 - z_145*z_461 - z_399);
    D[16] = ((-1.0/6.0))*((z_511*z_33 - sin_q3*z_574) + 3.0*l*(2.0*z_365 + z_571) + (z_499*z_70 + cos_q4*z_501) -
        (z_507*z_72 + z_507*z_32 + z_54*z_565));
    const double z_641 = z_537*z_41;
    const double z_642 = z_499*z_137 - z_499*z_39;
    const double z_643 = z_497*z_33 - z_492*z_143;
    const double z_644 = 3.0*(z_641 + z_42*z_502) + (z_643 - z_14*z_496) - (z_642 - z_501*z_6);
    const double z_645 = z_153*z_6;
    const double z_646 = sin_q3*z_158;
    const double z_647 = q2_dot*cos_q3;
    const double z_648 = (z_642 - z_643) - 3.0*((z_641 + (1.0/3.0)*z_493*z_6) - (1.0/3.0)*(z_208*z_560 -
        z_511*z_647));
    D[17] = ((-1.0/6.0))*(z_644 + z_517*z_645 + z_525*z_406 + z_517*z_646 - z_63*z_514 - z_47*z_518 - z_371*z_575
        - z_405*z_526 - z_97*z_526 - z_463*z_123 - z_461*z_192 - z_42*z_518 - z_525*z_201 - z_648);
    const double z_649 = cos_q4*sin_q3;
    const double z_650 = z_38*z_598 - cos_q4*z_499*z_33;
    const double z_651 = z_573 + (z_501*z_649 + z_650);
    const double z_652 = z_57*sin_q4;
    const double z_653 = cos_q4*z_510;
    const double z_654 = cos_q4*z_97;
    const double z_655 = cos_q4*z_428;
    const double z_656 = cos_q4*z_85;
    const double z_657 = (z_418*z_597 - z_507*z_228) + (q2_dot*z_536 + z_650);
    D[18] = ((-1.0/6.0))*(z_651 + z_652*z_588 + z_652*z_590 + z_653*z_512 + z_517*z_655 + z_526*z_416 +
        z_462*z_656 + z_657 - z_590*z_305 - z_518*z_654 - z_525*z_417);
    const double z_658 = cos_q4*z_507*z_31;
    const double z_659 = cos_q3*z_493 - z_498*z_40;
    const double z_660 = z_492*z_14;
    const double z_661 = z_492*z_38*z_31;
    const double z_662 = (z_70*z_560 + z_658 + z_565*z_540) - (z_659 - z_496*z_166) - (z_155*z_497 + z_35*z_660 -
        z_661 - z_496*z_609);
    const double z_663 = cos_q4*z_158;
    const double z_664 = sin_q4*z_560;
    const double z_665 = z_8*z_123;
    const double z_666 = sin_q4*z_192;
    const double z_667 = z_38*z_158;
    const double z_668 = (z_658 + z_661) + (z_166*z_508 - z_659);
    D[19] = (1.0/6.0)*(z_662 + z_664*z_512 + z_525*z_425 + z_455*z_240 + z_461*z_666 + z_668 - z_497*z_585 -
        z_590*z_663 - z_170*z_520 - z_461*z_665 - z_517*z_667 - z_517*z_156 - z_525*z_428);
    D[20] = -(cos_q1*(z_532*z_19 + z_24*z_433 + z_54*lambda_0 + lambda_0*z_165 - z_430*z_407 - lambda_2*z_297) +
        sin_q1*(z_430*z_38 + z_431 + z_24*z_434 - z_54*lambda_2 - lambda_2*z_165 - lambda_0*z_297));
    const double z_669 = z_130*z_38;
    const double z_670 = q1_dot*z_8;
    const double z_671 = z_192 - z_38*z_670;
    const double z_672 = 3.0*z_358 + 2.0*z_671 + 3.0*z_669;
    const double z_673 = m*(6.0*z_358 + z_671 + 5.0*z_669) + m*z_672;
    const double z_674 = m*(5.0*z_358 + z_669) + z_673;
    const double z_675 = l*z_673 - z_672*z_153;
    const double z_676 = m*(z_348 + z_294*z_24);
    const double z_677 = z_676 - z_305*z_24 - z_408;
    const double z_678 = z_676 + 0.5*z_677;
    const double z_679 = 2.0*z_372 + 2.0*z_678;
    const double z_680 = z_676 + 2.0*z_677;
    const double z_681 = l*(z_372 + 5.0*z_676 + 3.0*z_677) - z_8*z_680;
    const double z_682 = l*(5.0*z_372 + 6.0*z_678) + sin_q4*z_681;
    const double z_683 = cos_q3*z_437;
    const double z_684 = z_92*z_437;
    const double z_685 = m*(z_97 + z_405);
    const double z_686 = z_685 + z_201 - z_406;
    const double z_687 = z_685 + 2.0*z_686;
    const double z_688 = l*(5.0*z_685 + z_371 + 3.0*z_686) - z_8*z_687;
    const double z_689 = z_685 + 0.5*z_686;
    const double z_690 = l*(5.0*z_371 + 6.0*z_689) + sin_q4*z_688;
    const double z_691 = z_687*z_146;
    const double z_692 = z_35*z_123;
    const double z_693 = z_85*z_31;
    const double z_694 = z_437*z_24 - 2.0*z_173;
    const double z_695 = l*z_694;
    const double z_696 = z_294*z_694;
    const double z_697 = z_437*z_297 + 2.0*z_54*q1_ddot + z_229*z_694;
    const double z_698 = 3.0*z_695 + 3.0*z_696 - 2.0*z_697;
    const double z_699 = m*(6.0*z_695 + 5.0*z_696 - z_697) + m*z_698;
    const double z_700 = m*(5.0*z_695 + z_696) + z_699;
    const double z_701 = 2.0*z_672*z_202 + 2.0*z_687*z_438 + l*z_699 - z_698*z_153;
    const double z_702 = 2.0*z_371 + 2.0*z_689;
    D[21] = (1.0/12.0)*(cos_q2*(2.0*sin_q3*z_323 + 2.0*z_132*z_674 + 2.0*z_56*z_675 + 2.0*z_155*z_675 + z_450*z_6
        + z_447*z_646 + 3.0*z_444*z_679 + z_14*z_684 + 2.0*z_688*z_481 + 2.0*z_690*z_128 + 2.0*z_688*z_692 +
        2.0*z_82*z_675 + 12.0*z_6*z_267 + 12.0*z_14*z_271 + 12.0*z_12*z_272 + 2.0*z_79*z_289 + l*(z_57*z_694 +
        z_700) - 2.0*z_85*z_76 - z_42*z_480 - z_464*z_682 - z_127*z_683 - z_465*z_680 - 2.0*z_40*z_691 -
        2.0*z_85*z_67 - 2.0*z_687*z_693 - 2.0*z_672*z_157 - 2.0*z_672*z_159 - 12.0*z_380*z_532 - 12.0*z_12*z_271 -
        12.0*z_14*z_272 - 2.0*z_170*z_173 - z_97*z_700 - z_201*z_698 - z_701*z_38) + sin_q2*(30.0*z_63*g +
        2.0*z_216*z_215 + 6.0*z_702*z_217 + 6.0*z_436*z_6 + 2.0*z_212*z_674 + 12.0*z_6*z_578 + 12.0*z_42*lambda_1
        - 2.0*z_219*z_674 - 2.0*z_675*z_220 - z_681*z_483 - 2.0*z_690*z_215 - 2.0*z_687*z_214 - 2.0*z_688*z_451 -
        6.0*g*z_646 - 2.0*z_675*z_70 - 2.0*z_672*z_221 - 12.0*z_14*lambda_1 - cos_q4*z_701));
    const double z_703 = cos_q2*z_435;
    const double z_704 = q2_dot*z_492;
    const double z_705 = z_82*z_59;
    const double z_706 = 2.0*z_582 + sin_q3*z_81;
    const double z_707 = 2.0*z_705 + z_54*z_81 - z_229*z_706;
    const double z_708 = z_294*z_706;
    const double z_709 = z_97*z_81;
    const double z_710 = z_84 - z_709;
    const double z_711 = 3.0*z_710 - 2.0*z_707 - 3.0*z_708;
    const double z_712 = m*(6.0*z_710 - z_707 - 5.0*z_708) + m*z_711;
    const double z_713 = z_683 + 2.0*z_180;
    const double z_714 = 2.0*z_133*z_35 + sin_q4*z_713 + 2.0*z_184;
    const double z_715 = z_14*z_437 + z_8*z_714 - 2.0*z_86*z_438 - 2.0*z_194;
    const double z_716 = l*z_714;
    const double z_717 = l*z_713;
    const double z_718 = z_187 - 0.5*z_717;
    const double z_719 = 2.0*z_715 + 6.0*z_718 - 3.0*z_716;
    const double z_720 = q2_dot*z_35;
    const double z_721 = z_492*z_544;
    const double z_722 = (z_127*z_311 + z_79*z_310) + ((z_499*z_720 - q3_dot*z_721) - (q1_dot*z_93 +
        z_240*z_233));
    const double z_723 = z_19*z_146 + z_229*z_193;
    const double z_724 = z_130*z_407;
    const double z_725 = z_130*z_24;
    const double z_726 = 2.0*z_723 - 3.0*z_724 - 3.0*z_725;
    const double z_727 = m*(z_723 - 5.0*z_724 - 6.0*z_725) + m*z_726;
    const double z_728 = z_31*z_239;
    const double z_729 = z_50 - z_646 - z_645;
    const double z_730 = z_50 + 2.0*z_729;
    const double z_731 = z_81*z_13;
    const double z_732 = sin_q5*cos_q1;
    const double z_733 = z_732 + z_308*z_266;
    const double z_734 = cos_q1*z_13;
    const double z_735 = z_734 + z_11*z_603;
    const double z_736 = z_9*z_283;
    const double z_737 = z_279 + z_736;
    const double z_738 = sin_q1*z_13;
    const double z_739 = z_738 - sin_q2*z_486;
    const double z_740 = z_42*z_81;
    const double z_741 = z_8*z_6;
    const double z_742 = z_14*z_81 + z_81*z_741;
    const double z_743 = z_47*z_81;
    const double z_744 = 3.0*z_740 + 3.0*z_743 - 2.0*z_742;
    const double z_745 = z_464 + 2.0*q1_ddot*z_24;
    const double z_746 = z_294*z_745;
    const double z_747 = l*z_745;
    const double z_748 = z_465 - 2.0*q1_ddot*z_297 - z_229*z_745;
    const double z_749 = 2.0*z_748 + 3.0*z_746 + 3.0*z_747;
    const double z_750 = m*(z_748 + 5.0*z_746 + 6.0*z_747) + m*z_749;
    const double z_751 = cos_q2*g;
    const double z_752 = m*(z_715 + 12.0*z_718 - 5.0*z_716) + m*z_719;
    const double z_753 = q2_dot*z_106;
    const double z_754 = q3_dot*z_212;
    const double z_755 = (z_240*z_94 - (z_31*z_704 - z_499*z_753)) + 3.0*((z_537*z_754 - (1.0/3.0)*z_239*z_52) +
        (1.0/3.0)*(q3_dot*z_205 + z_79*z_241));
    const double z_756 = z_496*z_544;
    const double z_757 = z_724 + 5.0*z_725;
    const double z_758 = z_437*z_13;
    const double z_759 = z_35*z_239;
    const double z_760 = z_50 + 0.5*z_729;
    const double z_761 = 5.0*z_63 + 6.0*z_760;
    const double z_762 = 3.0*z_729 + 5.0*z_64;
    const double z_763 = z_294*z_762 - z_229*z_730;
    const double z_764 = sin_q5*z_603 - sin_q4*z_160;
    const double z_765 = z_486 - z_13*z_603;
    const double z_766 = z_11*sin_q1;
    const double z_767 = z_766 + cos_q1*z_270;
    const double z_768 = m*(6.0*z_740 + 5.0*z_743 - z_742) + m*z_744;
    D[22] = ((-1.0/12.0))*(sin_q3*(2.0*z_726*z_258 + 2.0*z_726*z_259 + 2.0*z_674*z_260 + 2.0*z_675*z_261 +
        z_690*z_437 + 2.0*z_94*z_691 + 2.0*z_690*z_241 + 2.0*z_681*z_530 + 2.0*z_672*z_264 + 2.0*z_726*z_265 +
        12.0*z_733*lambda_3 + 2.0*q2_ddot*z_536 + 6.0*q2_ddot*z_538 + 2.0*z_274*q1_ddot + 2.0*q1_ddot*z_277 +
        z_57*(z_746 + 5.0*z_747) + z_294*z_750 + l*z_750 + 2.0*z_722 - (30.0*z_703 + 6.0*z_283*z_436 + z_711*z_305
        + 2.0*z_67*z_239 + z_127*z_576 + z_719*z_158 + z_17*z_480 + 2.0*z_722 - 2.0*z_228*z_704 - z_511*z_81 -
        z_294*z_712 - l*(m*(6.0*z_84 - z_708 - 5.0*z_709) + z_712) - z_170*z_437 - z_308*z_450) - 2.0*sin_q4*z_599
        - 6.0*z_212*z_502 - 2.0*z_238 - 2.0*z_76*z_239 - 2.0*z_242*z_727 - z_680*z_528 - 2.0*z_680*z_529 -
        2.0*z_687*z_728 - 2.0*z_680*z_531 - z_730*z_731 - 2.0*z_672*z_263 - 12.0*z_735*lambda_2 -
        12.0*z_737*lambda_1 - 12.0*z_739*lambda_0 - z_744*z_158 - z_305*z_749 - z_698*z_306) -
        cos_q3*((6.0*z_158*z_751 + 2.0*z_92*z_531 + z_92*z_528 + z_79*z_437 + z_719*z_305 + z_447*z_306 +
        2.0*z_755 - z_81*z_560 - z_711*z_158 - 2.0*z_35*z_129 - z_57*(12.0*z_187 - z_716 - 5.0*z_717) -
        z_294*z_752 - l*z_752) + 2.0*z_756 + 2.0*sin_q2*z_323 + 2.0*z_314*z_727 + 2.0*z_316*z_727 + 2.0*z_96*z_674
        + 2.0*z_675*z_307 + 2.0*z_675*z_317 + 2.0*z_690*z_310 + 2.0*z_688*z_759 + 2.0*z_680*z_577 +
        12.0*lambda_1*z_566 + z_305*z_744 + 2.0*z_322 - 2.0*q1_dot*z_122 - 2.0*z_757*z_313 - 2.0*z_726*z_315 -
        z_682*z_576 - z_687*z_758 - 2.0*z_682*z_311 - 2.0*z_233*z_691 - z_84*z_761 - z_763*z_81 - 2.0*z_672*z_318
        - 2.0*z_726*z_262 - 12.0*z_764*lambda_3 - 12.0*z_765*lambda_2 - 12.0*z_767*lambda_0 - 2.0*z_497*q2_ddot -
        z_294*z_768 - l*(m*(5.0*z_740 + z_743) + z_768) - 2.0*q1_ddot*z_232 - z_749*z_158 - z_17*z_700 -
        z_308*z_701 - 2.0*z_755));
    const double z_769 = cos_q5*z_216;
    const double z_770 = sin_q5*z_769;
    const double z_771 = 3.0*z_769 - 2.0*z_770;
    const double z_772 = m*(z_242 - (z_228 + z_8*z_35));
    const double z_773 = z_57*z_35;
    const double z_774 = l + z_294;
    const double z_775 = m*(z_774 - z_229);
    const double z_776 = m*z_774;
    const double z_777 = 2.0*z_775 + z_776;
    const double z_778 = 2.0*z_772 + z_773;
    const double z_779 = z_777*z_59 + z_8*z_778;
    const double z_780 = l*(3.0*z_772 + 5.0*z_773) - z_779;
    const double z_781 = z_208*z_13;
    const double z_782 = q2_dot*z_6;
    const double z_783 = z_781 + z_8*z_782;
    const double z_784 = q2_dot*z_47;
    const double z_785 = 6.0*z_621 + 5.0*z_784 - z_783;
    const double z_786 = 3.0*z_621 + 3.0*z_784 - 2.0*z_783;
    const double z_787 = l*z_706;
    const double z_788 = z_8*z_706;
    const double z_789 = cos_q2*cos_q3;
    const double z_790 = q5_dot + z_106;
    const double z_791 = z_8*z_790;
    const double z_792 = 3.0*z_314 + 3.0*z_316 - 2.0*z_791;
    const double z_793 = sin_q3*cos_q1;
    const double z_794 = z_271*z_24 + z_793*lambda_2 + z_380*lambda_0 - z_272*z_24;
    const double z_795 = cos_q5*cos_q5*z_216;
    const double z_796 = l*(z_57 + 3.0*z_775 + 5.0*z_776) - z_777*z_8;
    const double z_797 = z_309 + sin_q4*q3_ddot;
    const double z_798 = q5_ddot + z_797;
    const double z_799 = z_790*z_59 + z_8*z_798;
    const double z_800 = l*z_797;
    const double z_801 = l*q3_ddot;
    const double z_802 = 2.0*z_799 - 3.0*z_800 - 3.0*z_801;
    const double z_803 = z_216*z_34;
    const double z_804 = q5_dot*z_795;
    const double z_805 = sin_q5*sin_q5;
    const double z_806 = q5_dot*z_216;
    const double z_807 = 3.0*z_803 + 2.0*(z_804 - z_805*z_806);
    const double z_808 = q3_dot*q4_dot;
    const double z_809 = 5.0*z_314 + 6.0*z_316 - z_791;
    const double z_810 = q1_dot*z_281;
    const double z_811 = q4_dot*z_133;
    const double z_812 = q2_dot*z_59;
    const double z_813 = z_14*q2_ddot + q2_ddot*z_741;
    const double z_814 = z_47*q2_ddot;
    const double z_815 = 3.0*z_632 + 3.0*z_814 - 2.0*z_813;
    D[23] = (1.0/12.0)*(cos_q4*(2.0*z_771*z_68 + 2.0*q3_dot*z_780 + 2.0*z_786*z_591 + 2.0*z_41*z_727 +
        2.0*z_726*z_331 + 2.0*z_98*z_675 + 2.0*z_249*z_675 + z_450*z_24 + z_719*z_428 + z_713*z_688 +
        2.0*z_688*z_329 + 2.0*z_119*z_123 + z_42*z_712 + z_730*z_788 + 2.0*z_493*z_647 + 2.0*z_675*z_325 +
        12.0*sin_q3*z_161 + 12.0*z_24*z_267 + 4.0*q5_ddot*z_795 + 2.0*z_796*q3_ddot + 2.0*z_802*z_153 +
        2.0*cos_q3*z_607 + cos_q3*z_510*z_81 + z_744*z_428 + z_66*z_745 + z_42*z_750 - 8.0*z_770*z_53 -
        2.0*z_501*z_647 - 2.0*z_785*z_589 - 2.0*z_786*z_589 - 2.0*z_121*z_123 - 2.0*z_62*z_193 - 2.0*z_726*z_330 -
        z_97*z_752 - z_439*z_681 - 2.0*z_680*z_593 - z_711*z_156 - z_762*z_787 - 6.0*z_436*z_789 - 2.0*z_792*z_202
        - 12.0*cos_q3*z_606 - 12.0*z_9*z_794 - 2.0*l*(m*(z_799 - 5.0*z_800 - 6.0*z_801) + m*z_802) - z_97*z_768 -
        z_118*z_694 - z_749*z_156 - z_701*z_19) + sin_q4*(2.0*z_771*q4_ddot + 2.0*z_792*z_591 + 2.0*z_786*z_202 +
        2.0*z_727*z_340 + 2.0*z_730*z_812 + 2.0*z_815*z_153 - 2.0*q4_dot*z_807 - 4.0*q4_dot*z_804 -
        2.0*z_796*z_808 - 2.0*z_809*z_589 - 2.0*z_792*z_589 - 2.0*z_726*z_341 - 2.0*z_675*z_336 - z_681*z_470 -
        2.0*z_688*z_810 - 2.0*z_681*z_602 - 2.0*z_688*z_811 - 2.0*z_675*z_281 - 2.0*z_57*(6.0*z_632 + 5.0*z_814 -
        z_813) - 2.0*z_57*z_815 - cos_q2*z_701));
    const double z_816 = sin_q5*z_216;
    const double z_817 = q5_dot*z_769;
    const double z_818 = q3_dot*z_216;
    const double z_819 = z_777*z_790;
    const double z_820 = z_130*z_46;
    const double z_821 = z_42*z_120;
    const double z_822 = z_97*z_437;
    const double z_823 = q1_dot*z_86;
    const double z_824 = z_344*z_823;
    const double z_825 = z_507*z_81;
    const double z_826 = z_82*z_344;
    const double z_827 = z_42*cos_q1;
    const double z_828 = sin_q4*z_769;
    const double z_829 = z_183 - z_234;
    const double z_830 = z_492*q2_ddot;
    const double z_831 = z_344*z_193;
    const double z_832 = l*z_777;
    D[24] = (1.0/12.0)*(sin_q5*(8.0*sin_q4*z_53*z_816 + 8.0*z_34*z_818 + 2.0*z_344*z_819 + 2.0*z_786*z_623 +
        2.0*q1_dot*z_821 + z_63*z_719 + z_687*z_822 + z_680*z_625 + 2.0*z_680*z_359 + 2.0*z_687*z_356 +
        2.0*z_680*z_628 + z_711*z_371 + z_730*z_740 + z_97*z_825 + 2.0*z_730*z_826 + 2.0*z_672*z_363 +
        2.0*sin_q4*z_792*z_360 + 12.0*lambda_2*z_827 + 12.0*z_42*z_163 + 12.0*z_87*z_272 + 6.0*z_829*z_216 +
        2.0*z_97*z_830 + z_63*z_744 + 2.0*z_176*z_352 + z_371*z_749 + z_372*z_698 - 16.0*z_817*z_35 -
        2.0*z_219*z_496 - 2.0*z_19*z_820 - 2.0*z_726*z_361 - 2.0*z_672*z_362 - z_19*z_635 - z_42*z_51*z_437 -
        z_92*z_444*z_19 - 2.0*z_687*z_357 - 2.0*z_687*z_824 - 6.0*z_435*z_288 - 2.0*z_672*z_364 - 2.0*z_365*z_726
        - 12.0*z_38*z_162 - 12.0*z_407*z_366 - 12.0*z_87*z_271 - 12.0*z_393*lambda_1 - 8.0*q5_ddot*z_828 -
        4.0*z_829*z_816 - 8.0*z_769*q3_ddot - 2.0*z_42*z_204) - cos_q5*(8.0*z_53*z_828 + 8.0*z_803*z_35 +
        8.0*q3_dot*z_817 + 2.0*l*z_778*z_790 + 2.0*z_773*z_792 + 2.0*z_726*z_375 + 2.0*z_672*z_377 + z_716*z_687 +
        z_442*z_680 + 2.0*z_687*z_831 + z_711*z_382 + 2.0*z_672*z_378 + 2.0*z_726*z_379 + 12.0*z_19*z_366 +
        2.0*z_798*z_832 + 2.0*z_47*z_830 + 2.0*z_491*z_815 + z_47*z_825 + z_51*z_746 + z_749*z_382 + z_698*z_383 -
        6.0*z_35*z_806 - 2.0*z_496*z_784 - 2.0*z_495*z_786 - 2.0*z_38*z_355 - 2.0*z_407*z_820 - 2.0*z_726*z_376 -
        z_447*z_652*z_24 - z_719*z_640 - 2.0*z_680*z_636 - z_708*z_730 - 6.0*z_703*z_6 - 12.0*cos_q3*z_162 -
        12.0*l*(cos_q2*lambda_1*z_6 + sin_q4*z_794) - 4.0*z_769*z_829 - 2.0*z_652*z_802 - z_744*z_640 -
        z_92*z_696));
    D[25] = ((-1.0/6.0))*(3.0*z_130*z_679 + z_133*z_682 + sin_q3*z_691 + z_147*z_680 + 3.0*z_96*z_702 + z_40*z_682
        + z_142*z_680 + z_244*z_687 + z_245*z_687 + z_145*z_680 + z_409 - z_404 - z_85*z_690 - 3.0*z_140*z_679 -
        z_136*z_681 - z_103*z_688 - z_249*z_690 - z_243*z_687 - z_98*z_690 - z_137*z_681 - z_102*z_688 -
        z_108*z_688 - z_248*z_687 - z_51*z_228*z_24 - z_143*z_680);
    D[26] = (1.0/6.0)*(z_393*z_674 + z_394*z_675 + z_519*z_688 + z_690*z_398 + z_397*z_687 + 3.0*z_212*(2.0*z_63 +
        2.0*z_760) + z_285*z_675 + z_395*z_672 - z_644 - z_216*z_398 - 3.0*z_396*z_702 - z_219*z_761 - z_208*z_763
        - z_211*z_730 - z_418*z_730 - q4_dot*z_763 - z_279*z_674 - z_648);
    const double z_833 = z_769*z_34;
    D[27] = (1.0/6.0)*((3.0*l*(z_772 + 2.0*z_773) + (z_796*z_35 + sin_q4*z_780) - 4.0*z_833) + z_405*z_727 +
        z_97*z_727 + z_348*z_674 + z_675*z_407 + z_690*z_193 + z_201*z_726 - z_371*z_757 - z_726*z_406 -
        z_682*z_123 - z_192*z_680 - z_19*z_691 - z_672*z_408);
    const double z_834 = cos_q4*z_807;
    const double z_835 = cos_q4*z_153;
    const double z_836 = q1_dot*z_283;
    const double z_837 = cos_q4*z_133;
    const double z_838 = cos_q4*z_804;
    const double z_839 = z_838 + 0.5*q3_dot*cos_q4*z_796;
    D[28] = (1.0/6.0)*(2.0*z_771*z_70 + z_834 + z_491*z_809 + z_491*z_792 + z_786*z_305 + z_726*z_417 +
        z_414*z_675 + z_681*z_656 + z_688*z_836 + z_688*z_837 + z_283*z_675 + 2.0*z_839 - z_792*z_835 -
        z_652*z_785 - z_652*z_786 - z_727*z_416 - q2_dot*z_763);
    const double z_840 = z_35*z_795 - 2.0*z_34*z_828;
    const double z_841 = z_779 - 2.0*z_840;
    const double z_842 = z_8*z_193;
    const double z_843 = z_82*z_13;
    const double z_844 = sin_q4*z_158;
    const double z_845 = (z_840 - z_805*z_35*z_216) + 1.5*(z_35*z_816 - (4.0/3.0)*q3_dot*z_770);
    D[29] = (1.0/6.0)*(z_726*z_425 + z_672*z_426 + z_86*z_691 + z_665*z_680 + 2.0*z_845 - z_841 - z_13*z_819 -
        z_786*z_663 - z_687*z_842 - z_666*z_680 - z_730*z_843 - z_672*z_427 - z_726*z_428 - z_792*z_844);
    const double z_846 = cos_q4*z_430 - lambda_2*z_222;
    const double z_847 = lambda_0*z_222;
    D[30] = cos_q1*(z_283*z_430 + z_846*z_19 + cos_q3*z_847 - z_736*lambda_2) + sin_q1*(cos_q3*z_846 -
        z_736*lambda_0 - z_19*z_847);
    const double z_848 = z_8*z_656;
    const double z_849 = z_42*z_225;
    const double z_850 = 2.0*z_848 - 3.0*z_849;
    const double z_851 = m*(z_848 - 5.0*z_849) + m*z_850;
    const double z_852 = z_851 - z_491*z_85;
    const double z_853 = l*z_851 - z_850*z_153;
    const double z_854 = z_283 + z_414;
    const double z_855 = z_57*z_854;
    const double z_856 = z_855 - z_854*z_153;
    const double z_857 = 2.0*z_855 + z_856;
    const double z_858 = z_855 + 2.0*z_856;
    const double z_859 = l*(5.0*z_855 + 3.0*z_856) - z_8*z_858;
    const double z_860 = z_226 + 3.0*l*z_857 + sin_q4*z_859;
    const double z_861 = cos_q4*z_63;
    const double z_862 = z_861 - z_417;
    const double z_863 = z_861 + 2.0*z_862;
    const double z_864 = l*(5.0*z_861 + 3.0*z_862) - z_8*z_863;
    const double z_865 = 2.0*z_861 + z_862;
    const double z_866 = z_168 + 3.0*l*z_865 + sin_q4*z_864;
    const double z_867 = z_863*z_146;
    const double z_868 = sin_q3*z_222;
    const double z_869 = 2.0*z_40*z_225 - z_283*z_437 - cos_q4*z_439 - 2.0*q1_ddot*z_411;
    const double z_870 = z_8*z_869;
    const double z_871 = l*z_869;
    const double z_872 = 2.0*z_870 - 3.0*z_871;
    const double z_873 = m*(z_870 - 5.0*z_871) + m*z_872;
    const double z_874 = z_873 - z_57*z_869;
    const double z_875 = 2.0*z_850*z_202 + l*z_873 - 2.0*z_863*z_438 - z_872*z_153;
    const double z_876 = z_66*z_123;
    D[31] = (1.0/12.0)*(cos_q2*(6.0*sin_q4*z_436 + 2.0*z_168*z_128 + 2.0*z_132*z_852 + 2.0*z_56*z_853 +
        2.0*z_155*z_853 + z_450*z_649 + 3.0*z_444*z_857 + 2.0*z_40*z_867 + 2.0*z_863*z_693 + 2.0*z_82*z_853 +
        12.0*z_380*z_846 + 12.0*z_10*lambda_1 + 12.0*z_272*z_868 + 2.0*z_168*z_173 + l*z_874 -
        2.0*cos_q4*z_62*z_123 - z_464*z_860 - z_465*z_858 - 2.0*z_864*z_481 - 2.0*z_866*z_128 - 2.0*z_864*z_692 -
        2.0*z_850*z_157 - 2.0*z_850*z_159 - z_97*z_874 - z_201*z_872 - z_875*z_38) - sin_q2*(12.0*z_268 +
        sin_q4*z_450 + 2.0*z_82*z_876 + 2.0*z_219*z_852 + 2.0*z_853*z_220 + z_859*z_483 + 6.0*z_865*z_217 +
        2.0*z_853*z_70 + 2.0*z_850*z_221 + 12.0*z_10*z_272 + 2.0*sin_q4*z_596 + cos_q4*z_875 - 2.0*q1_dot*z_75 -
        z_126*z_437 - 2.0*z_866*z_215 - 2.0*z_863*z_214 - 2.0*z_864*z_451 - 6.0*z_436*z_649 - 2.0*z_212*z_852 -
        12.0*z_10*z_271 - 12.0*lambda_1*z_868));
    const double z_877 = q2_dot*z_229;
    const double z_878 = q2_dot*z_294;
    const double z_879 = 2.0*z_877 - 3.0*z_878;
    const double z_880 = m*(z_877 - 5.0*z_878) + m*z_879;
    const double z_881 = z_836 + z_837;
    const double z_882 = z_8*z_881;
    const double z_883 = l*z_881;
    const double z_884 = 2.0*z_882 - 3.0*z_883;
    const double z_885 = m*(z_882 - 5.0*z_883) + m*z_884;
    const double z_886 = cos_q4*z_371;
    const double z_887 = z_886 - z_655;
    const double z_888 = z_886 + 2.0*z_887;
    const double z_889 = z_652 - z_305;
    const double z_890 = 2.0*z_652 + z_889;
    const double z_891 = z_652 + 2.0*z_889;
    const double z_892 = l*(5.0*z_652 + 3.0*z_889) - z_8*z_891;
    const double z_893 = q2_dot*z_891;
    const double z_894 = 2.0*z_720 + 2.0*sin_q4*q2_ddot - cos_q4*z_706;
    const double z_895 = z_8*z_894;
    const double z_896 = l*z_894;
    const double z_897 = 2.0*z_895 - 3.0*z_896;
    const double z_898 = 2.0*z_98*z_225 + 2.0*cos_q4*z_179 + 2.0*z_414*q1_ddot + 2.0*z_283*q1_ddot - cos_q4*z_713;
    const double z_899 = 2.0*z_881*z_59 + z_8*z_898 - 2.0*z_854*z_438;
    const double z_900 = l*z_898;
    const double z_901 = 2.0*z_899 - 3.0*z_900;
    const double z_902 = m*(z_899 - 5.0*z_900) + m*z_901;
    const double z_903 = 2.0*z_886 + z_887;
    const double z_904 = 5.0*z_886 + 3.0*z_887;
    const double z_905 = z_653 + z_229*z_888 - z_294*z_904;
    const double z_906 = z_891*z_544;
    const double z_907 = m*(z_895 - 5.0*z_896) + m*z_897;
    D[32] = ((-1.0/12.0))*(sin_q3*(2.0*z_216*z_753 + 2.0*z_879*z_315 + 2.0*z_66*z_285*z_311 + 2.0*z_884*z_258 +
        2.0*z_884*z_259 + 2.0*z_852*z_260 + 2.0*z_853*z_261 + z_488*z_752 + 2.0*z_859*z_530 + 2.0*z_863*z_728 +
        6.0*z_890*z_754 + 2.0*z_892*z_753 + 2.0*z_879*z_262 + 2.0*z_850*z_264 + 2.0*z_884*z_265 + 12.0*z_163*z_222
        + z_898*z_216 + z_305*z_901 + 2.0*z_227 - 2.0*z_314*z_880 - 2.0*z_242*z_885 - z_719*z_835 - z_866*z_437 -
        z_858*z_528 - 2.0*z_94*z_867 - 2.0*z_866*z_241 - 2.0*z_858*z_529 - 2.0*z_858*z_531 - 2.0*q1_dot*z_92*z_418
        - z_888*z_731 - 2.0*z_31*z_893 - 2.0*z_316*z_880 - 2.0*z_850*z_263 - 12.0*cos_q1*z_846 - z_897*z_158 -
        z_294*z_902 - l*z_902 - z_872*z_306) + cos_q3*(6.0*z_22*z_436 + 2.0*z_82*z_501 + 2.0*z_242*z_880 +
        2.0*z_62*z_519 + 2.0*z_881*z_818 + 2.0*z_884*z_315 + z_860*z_576 + 2.0*z_866*z_310 + 2.0*z_860*z_311 +
        2.0*z_864*z_759 + z_711*z_835 + 3.0*z_84*z_903 + 2.0*q3_dot*z_906 + 2.0*z_228*z_893 + 2.0*z_850*z_318 +
        2.0*z_884*z_262 + 12.0*z_23*lambda_1 + z_294*z_907 + l*(z_907 - z_57*z_894) + z_17*z_874 + z_308*z_875 -
        2.0*z_879*z_259 - 2.0*z_168*z_310 - 2.0*z_226*z_311 - 2.0*z_314*z_885 - 2.0*z_316*z_885 - 2.0*z_96*z_852 -
        2.0*z_853*z_307 - 2.0*z_853*z_317 - z_285*z_450 - z_863*z_758 - 2.0*z_233*z_867 - 2.0*z_858*z_577 -
        z_488*z_712 - z_905*z_81 - 2.0*z_720*z_892 - 2.0*z_82*z_493 - 2.0*z_879*z_258 - 2.0*z_879*z_265 -
        12.0*z_846*z_603 - 12.0*z_272*z_432 - 2.0*z_499*z_611 - z_305*z_897 - 2.0*z_285*z_596 - z_901*z_158));
    const double z_908 = z_212*z_33;
    const double z_909 = z_208*z_35;
    const double z_910 = q2_dot*z_155;
    const double z_911 = 2.0*z_909 + 2.0*z_910 + cos_q4*z_81;
    const double z_912 = z_59*z_220 + z_545;
    const double z_913 = z_8*z_911 + 2.0*z_912;
    const double z_914 = l*z_911;
    const double z_915 = 6.0*z_908 + 3.0*z_914 - 2.0*z_913;
    const double z_916 = q4_dot*z_208;
    const double z_917 = (z_133*z_326 - z_118*z_602) + (z_66*z_810 - (z_771*z_808 - z_499*z_916));
    const double z_918 = z_82*z_191;
    const double z_919 = z_97*z_82;
    const double z_920 = z_918 - 5.0*z_919;
    const double z_921 = 2.0*z_918 - 3.0*z_919;
    const double z_922 = z_891*z_59;
    const double z_923 = l*z_73;
    const double z_924 = z_491 - z_835;
    const double z_925 = 5.0*z_491 + 3.0*z_924;
    const double z_926 = z_491 + 2.0*z_924;
    const double z_927 = z_8*z_926;
    const double z_928 = z_489*z_73;
    const double z_929 = z_488*z_73;
    const double z_930 = 2.0*z_928 - 3.0*z_929;
    const double z_931 = 2.0*q3_dot*q5_dot + sin_q4*z_73;
    const double z_932 = z_8*z_931;
    const double z_933 = z_294*z_73;
    const double z_934 = 2.0*z_932 - 3.0*z_933 - 3.0*z_923;
    const double z_935 = z_499*z_210 + z_328*z_326;
    const double z_936 = cos_q3*cos_q1;
    const double z_937 = z_936 - sin_q1*z_19;
    const double z_938 = z_9*z_937;
    const double z_939 = cos_q3*sin_q1;
    const double z_940 = z_939 + cos_q1*z_19;
    const double z_941 = z_9*z_940;
    const double z_942 = sin_q4*z_81 + 2.0*sin_q3*z_611;
    const double z_943 = z_8*z_942;
    const double z_944 = l*z_942;
    const double z_945 = 2.0*z_943 - 3.0*z_944;
    D[33] = (1.0/12.0)*(cos_q4*(2.0*z_920*z_589 + 2.0*z_921*z_589 + 2.0*q2_dot*z_572 + 2.0*z_879*z_592 +
        2.0*z_41*z_885 + 2.0*z_884*z_331 + 2.0*z_98*z_853 + 2.0*z_249*z_853 + z_888*z_788 + 2.0*z_210*z_892 +
        z_73*z_927 + 2.0*z_853*z_325 + 2.0*z_879*z_594 + 12.0*cos_q2*z_267 + 12.0*lambda_1*z_605 +
        12.0*z_272*z_342 + l*(m*(z_928 - 5.0*z_929) + m*z_930) + z_428*z_897 + 2.0*cos_q2*z_596 + z_156*z_901 -
        (2.0*z_507*z_812 + z_915*z_153 + z_118*z_470 - 6.0*sin_q2*z_436 - z_499*z_81 - z_57*(12.0*z_908 +
        5.0*z_914 - z_913) - z_57*z_915 - cos_q2*z_450 - 2.0*z_917) - 2.0*z_921*z_591 - 2.0*z_132*z_880 -
        2.0*z_62*z_328 - 2.0*z_884*z_330 - z_713*z_864 - z_439*z_859 - 2.0*z_864*z_329 - 2.0*z_858*z_593 -
        z_904*z_787 - 2.0*z_208*z_922 - z_923*z_925 - 12.0*z_271*z_342 - z_930*z_153 - 2.0*z_510*q2_ddot -
        z_97*z_907 - z_42*z_902 - z_875*z_19 - 2.0*z_917) - sin_q4*(2.0*q3_dot*z_807 + 2.0*z_921*z_202 +
        2.0*z_879*z_601 + 2.0*z_66*z_178 + 2.0*z_66*z_179 + 2.0*z_85*z_121 + 2.0*z_40*z_129 + 2.0*z_884*z_341 +
        2.0*z_853*z_336 + z_859*z_470 + 2.0*z_859*z_602 + z_892*z_81 + 2.0*z_892*z_916 + 2.0*z_853*z_281 +
        12.0*lambda_2*z_938 + 12.0*lambda_0*z_941 + 2.0*q2_ddot*z_581 + z_945*z_153 + 2.0*z_19*z_596 +
        cos_q2*z_875 + 2.0*z_935 - (6.0*z_436*z_288 + 4.0*q3_dot*z_804 + z_796*z_73 + z_934*z_153 + z_711*z_428 +
        2.0*z_85*z_119 + z_118*z_439 + z_66*z_713 + z_719*z_156 + 2.0*z_935 - l*(m*(z_932 - 5.0*z_933 - 6.0*z_923)
        + m*z_934) - 2.0*z_493*z_208 - z_510*z_706 - z_97*z_712 - z_42*z_752 - z_450*z_19) - 2.0*z_771*q3_ddot -
        2.0*z_501*z_208 - 2.0*z_510*z_582 - 2.0*z_880*z_600 - 2.0*z_133*z_62 - 2.0*z_885*z_340 - 2.0*z_864*z_810 -
        2.0*z_864*z_811 - 2.0*z_888*z_812 - 12.0*z_937*z_430 - 12.0*sin_q3*z_606 - z_57*(z_943 - 5.0*z_944) -
        z_57*z_945 - 2.0*q1_ddot*z_327));
    const double z_946 = z_57 + 2.0*m*z_9;
    const double z_947 = q4_dot*z_946;
    const double z_948 = cos_q4*z_937;
    const double z_949 = cos_q4*q3_ddot;
    const double z_950 = cos_q4*z_818;
    const double z_951 = z_22*sin_q3;
    const double z_952 = l*z_946;
    const double z_953 = cos_q4*z_769;
    D[34] = (1.0/12.0)*(sin_q5*(6.0*q4_dot*z_806 + 2.0*z_344*z_947 + 2.0*z_881*z_350 + z_858*z_625 +
        2.0*z_863*z_357 + 2.0*z_858*z_359 + 2.0*z_863*z_824 + 2.0*z_858*z_628 + z_740*z_888 + 2.0*z_891*z_622 +
        2.0*z_888*z_826 + 2.0*z_891*z_344*z_220 + 2.0*z_850*z_363 + 12.0*lambda_3*z_948 + 6.0*z_216*z_949 +
        z_63*z_897 + z_372*z_872 - 4.0*q4_dot*z_803 - 2.0*z_921*z_623 - 2.0*z_884*z_361 - 2.0*z_850*z_362 -
        z_863*z_822 - 2.0*z_863*z_356 - 2.0*z_854*z_626 - 2.0*z_879*z_629 - 2.0*z_58*z_879 - 2.0*z_850*z_364 -
        2.0*z_365*z_884 - 12.0*z_283*z_366 - 4.0*z_816*z_949 - z_371*z_901) - cos_q5*(8.0*z_34*z_950 +
        2.0*z_495*z_921 + 2.0*z_565*z_878 + 2.0*z_225*z_821 + 2.0*z_884*z_375 + 2.0*z_850*z_377 + z_719*z_861 +
        z_442*z_858 + z_711*z_886 + z_915*z_652 + z_914*z_891 + 2.0*z_346*z_893 + z_491*z_934 + 6.0*z_435*(z_308 -
        z_951) + 2.0*z_850*z_378 + 2.0*z_884*z_379 + 2.0*q4_ddot*z_952 + z_652*z_930 + z_942*z_638 + z_869*z_381 +
        z_898*z_352 + z_872*z_383 - 6.0*q5_dot*z_950 - 4.0*q4_dot*z_817 - 2.0*z_496*z_919 - 2.0*z_879*z_633 -
        2.0*z_879*z_634 - 2.0*z_881*z_351 - 2.0*z_884*z_376 - z_854*z_635 - z_716*z_863 - 2.0*z_858*z_636 -
        2.0*z_863*z_831 - z_708*z_888 - l*z_931*z_926 - 2.0*z_879*z_637 - 2.0*l*(6.0*z_283*z_271 +
        6.0*z_951*lambda_1 + m*(2.0*(z_334 + z_8*q4_ddot) - 3.0*l*q4_ddot) - 6.0*lambda_2*z_948 -
        6.0*z_308*lambda_1 - 6.0*z_283*z_272 - 6.0*cos_q4*z_940*lambda_0) - 4.0*z_953*q3_ddot - z_777*z_929 -
        z_491*z_945 - z_894*z_639 - z_897*z_640 - z_901*z_382));
    D[35] = ((-1.0/6.0))*(3.0*z_130*z_857 + z_85*z_866 + z_133*z_860 + z_147*z_858 + z_103*z_864 + z_249*z_866 +
        z_243*z_863 + z_40*z_860 + z_98*z_866 + z_142*z_858 + z_102*z_864 + z_108*z_864 + z_248*z_863 +
        z_145*z_858 + z_419 - z_415 - 3.0*z_140*z_857 - z_136*z_859 - sin_q3*z_867 - 3.0*z_96*z_865 - z_244*z_863
        - z_137*z_859 - z_854*z_60 - z_143*z_858 - z_245*z_863);
    D[36] = (1.0/6.0)*(z_22*z_876 + z_393*z_852 + z_394*z_853 + 3.0*z_396*z_865 + z_208*z_905 + 3.0*z_212*z_903 +
        z_82*z_892 + 3.0*z_132*z_890 + z_155*z_892 + z_56*z_892 + q4_dot*z_905 + z_285*z_853 + z_395*z_850 + z_657
        - z_651 - z_519*z_864 - z_866*z_398 - z_397*z_863 - 3.0*z_219*z_903 - z_211*z_888 - z_72*z_891 -
        z_418*z_888 - z_32*z_891 - z_38*z_922 - z_279*z_852);
    D[37] = (1.0/6.0)*(z_834 + z_226*z_123 + z_168*z_193 + z_216*z_782 + z_645*z_879 + z_405*z_885 + z_97*z_885 +
        z_348*z_852 + z_853*z_407 + z_19*z_867 + 3.0*z_621*z_890 + z_892*z_782 + z_106*z_927 + z_926*z_31 +
        z_646*z_879 + z_201*z_884 - z_47*z_880 - sin_q3*z_881*z_216 - z_406*z_884 - z_860*z_123 - z_866*z_193 -
        z_192*z_858 - z_781*z_891 - 3.0*z_316*(2.0*z_491 + z_924) - z_314*z_925 - z_42*z_880 - z_408*z_850 -
        2.0*z_839);
    const double z_954 = sin_q3*z_82;
    D[38] = ((-1.0/6.0))*((3.0*z_817 - (2.0*z_833 - z_946*z_59)) + z_305*z_921 + z_510*z_82 + z_880*z_654 +
        z_885*z_416 + z_836*z_864 + z_837*z_864 - z_652*z_920 - z_652*z_921 - z_879*z_655 - z_884*z_417 -
        z_414*z_853 - z_859*z_656 - z_892*z_954 - q2_dot*z_905 - z_283*z_853);
    const double z_955 = z_805*z_950 - 1.5*sin_q5*z_950;
    const double z_956 = q4_dot*z_770 - 0.5*(z_13*z_947 + 3.0*q4_dot*z_769);
    D[39] = ((-1.0/6.0))*(z_170*z_881 + z_86*z_867 + z_666*z_858 + z_888*z_843 + z_166*z_893 + z_38*z_906 +
        z_850*z_427 + z_884*z_428 + 2.0*z_955 - z_921*z_663 - z_884*z_425 - z_850*z_426 - z_854*z_240 -
        z_665*z_858 - z_842*z_863 - q3_dot*z_927 - z_879*z_667 - z_879*z_156 - 2.0*z_956);
    const double z_957 = z_532 - z_534;
    const double z_958 = z_430 + z_8*lambda_2;
    const double z_959 = lambda_0*z_13;
    D[40] = cos_q1*(z_22*z_957 + z_958*z_24 + lambda_0*z_191 - z_29*z_957 - lambda_0*z_190) - sin_q1*(sin_q3*z_958
        + z_957*z_6 + z_22*z_959 - lambda_0*z_295 - z_29*z_959);
    const double z_960 = z_665 - z_666;
    const double z_961 = z_57*z_960;
    const double z_962 = z_240 + 3.0*z_961 - 2.0*z_960*z_153;
    const double z_963 = z_426 - z_427;
    const double z_964 = l*z_963;
    const double z_965 = z_274 + 2.0*z_8*z_963 - 3.0*z_964;
    const double z_966 = 3.0*z_964 - sin_q4*z_965;
    const double z_967 = z_428 - z_425;
    const double z_968 = l*z_967;
    const double z_969 = z_170 + 2.0*z_8*z_967 - 3.0*z_968;
    const double z_970 = 3.0*z_968 - sin_q4*z_969;
    const double z_971 = z_967*z_146;
    const double z_972 = g*z_158 + 2.0*lambda_1*z_13;
    const double z_973 = 2.0*z_146*z_39 + z_440*z_13 + 2.0*q1_ddot*z_191 - 2.0*z_192*z_35 - z_437*z_295 -
        2.0*q1_ddot*z_190;
    const double z_974 = z_57*z_973;
    const double z_975 = z_447*z_158 + 4.0*z_960*z_202 + 4.0*z_967*z_438 + 2.0*z_973*z_153 + 2.0*z_324 -
        3.0*z_974;
    const double z_976 = cos_q4*sin_q1;
    D[41] = (1.0/12.0)*(cos_q2*(2.0*z_85*z_61 + z_447*z_156 + 3.0*z_444*z_963 + z_166*z_684 + 2.0*z_969*z_481 +
        4.0*z_40*z_971 + 2.0*z_969*z_692 + 4.0*z_967*z_693 + 4.0*z_960*z_157 + 4.0*z_960*z_159 + 12.0*z_939*z_958
        + 6.0*cos_q4*z_972 + 3.0*z_974 + z_975*z_38 - 6.0*z_961*z_33 - 2.0*z_56*z_962 - 2.0*z_155*z_962 -
        z_464*z_966 - 2.0*z_465*z_963 - 2.0*z_970*z_128 - 2.0*z_82*z_962 - 12.0*sin_q1*z_957*z_38 -
        12.0*z_272*z_166 - 12.0*z_272*z_609 - 2.0*z_166*z_370 - 3.0*z_371*z_973 - 2.0*z_201*z_973) +
        sin_q2*(6.0*z_208*z_961 + 2.0*z_962*z_220 + z_965*z_483 + 2.0*z_970*z_215 + 4.0*z_967*z_214 +
        2.0*z_962*z_70 + 4.0*z_960*z_221 + cos_q4*z_975 - 6.0*z_967*z_217 - 2.0*z_969*z_451 - 6.0*g*z_156 -
        6.0*q2_dot*z_961 - 12.0*z_957*z_976 - 12.0*lambda_1*z_166 - 6.0*z_972*z_38 - 12.0*z_272*z_540));
    const double z_977 = z_769*z_82;
    const double z_978 = sin_q5*z_977;
    const double z_979 = z_86*z_146 - z_842;
    const double z_980 = z_57*z_979;
    const double z_981 = z_156 + z_667;
    const double z_982 = z_497 + 3.0*z_953 - 2.0*cos_q4*z_770;
    const double z_983 = sin_q4*z_957;
    const double z_984 = cos_q2*z_8;
    const double z_985 = sin_q4*z_13;
    const double z_986 = 2.0*z_70*z_544 - z_706*z_985 - z_81*z_166 - 2.0*z_611*z_13;
    const double z_987 = 2.0*z_109*z_146 + z_437*z_191 + 2.0*q1_ddot*z_295 - z_714*z_13 - 2.0*q1_ddot*z_296;
    const double z_988 = cos_q4*cos_q4;
    const double z_989 = z_769*z_988;
    const double z_990 = z_770*z_988;
    const double z_991 = z_664 + 2.0*z_229*z_981 - 3.0*z_294*z_981;
    const double z_992 = z_82*z_795;
    D[42] = (1.0/12.0)*(sin_q3*(z_711*z_153 + 2.0*z_106*z_721 + 4.0*z_106*z_978 + 2.0*sin_q4*z_238 +
        4.0*z_979*z_258 + 4.0*z_979*z_259 + 6.0*z_961*z_233 + 2.0*z_962*z_261 + z_719*z_844 + z_970*z_437 +
        2.0*z_963*z_528 + 4.0*z_94*z_971 + 2.0*z_970*z_241 + 4.0*z_963*z_529 + 2.0*z_965*z_530 + 4.0*z_963*z_531 +
        z_8*z_825 + 8.0*z_34*z_977 + 4.0*z_960*z_264 + 4.0*z_979*z_265 + 12.0*sin_q2*z_8*z_272 +
        12.0*sin_q4*z_738*lambda_0 + 2.0*z_8*z_830 + 2.0*z_986*z_158 + 2.0*q1_ddot*z_276 + 3.0*z_652*z_987 +
        3.0*z_57*z_987 + 2.0*z_973*z_306 - 2.0*q2_dot*z_500 - 6.0*z_106*z_977 - 2.0*z_35*z_205 - 2.0*z_61*z_239 -
        6.0*z_35*z_980 - sin_q2*z_449 - z_117*z_576 - 4.0*z_967*z_728 - 2.0*z_981*z_731 - 12.0*q3_dot*z_977 -
        2.0*z_982*z_753 - 6.0*z_153*z_751 - 4.0*z_960*z_263 - 12.0*z_958*z_603 - 12.0*cos_q1*z_983 -
        12.0*lambda_1*z_984 - 2.0*q1_ddot*z_275 - 2.0*z_305*z_987) + cos_q3*(z_719*z_153 + 2.0*sin_q4*z_756 +
        6.0*z_582*z_989 + 2.0*z_120*z_670 + 4.0*z_979*z_315 + 2.0*z_967*z_758 + 4.0*z_233*z_971 + 2.0*z_969*z_759
        + 4.0*z_963*z_577 + 3.0*z_84*z_981 + 2.0*z_720*z_982 + 4.0*z_960*z_318 + 4.0*z_979*z_262 +
        12.0*cos_q1*z_958 + 6.0*z_283*z_972 + 12.0*z_8*z_163 + 2.0*z_305*z_986 + 2.0*z_987*z_158 + z_308*z_975 -
        2.0*z_35*z_721 - 4.0*z_582*z_990 - 2.0*z_106*z_205 - 6.0*z_106*z_980 - 6.0*q3_dot*z_980 - 6.0*z_961*z_94 -
        2.0*z_962*z_307 - 2.0*z_962*z_317 - z_966*z_576 - z_65*z_437 - 2.0*z_970*z_310 - 2.0*z_966*z_311 -
        z_711*z_844 - z_991*z_81 - 8.0*q3_dot*z_992 - 8.0*sin_q4*z_82*z_804 - 12.0*z_603*z_983 -
        12.0*z_308*z_272*z_13 - 2.0*q2_ddot*z_579 - 3.0*z_652*z_986 - 3.0*z_57*z_986 - 2.0*z_8*z_204 -
        3.0*sin_q2*z_974));
    const double z_993 = q3_dot*z_769;
    const double z_994 = q2_dot*z_166 + z_38*z_544;
    const double z_995 = z_777*z_13 - 2.0*sin_q4*z_770;
    const double z_996 = 2.0*q3_dot*z_59 + 2.0*z_8*q3_ddot - z_931*z_13;
    const double z_997 = q4_dot*z_818;
    const double z_998 = z_92*z_192;
    const double z_999 = 2.0*z_909*z_13 + 2.0*z_155*z_544 + 2.0*q2_ddot*z_609 + 2.0*q2_ddot*z_166 - z_911*z_13;
    D[43] = ((-1.0/12.0))*(cos_q4*(2.0*z_33*z_721 + 4.0*z_994*z_591 + 4.0*z_33*z_978 + 6.0*z_40*z_980 +
        4.0*z_979*z_331 + 2.0*z_98*z_962 + 2.0*z_249*z_962 + z_719*z_201 + 4.0*z_963*z_593 + z_711*z_646 +
        2.0*z_981*z_788 + z_706*z_560 + 8.0*z_804*z_954 + z_934*z_158 + 2.0*z_962*z_325 + 12.0*z_940*z_959 +
        3.0*z_57*z_996 + 2.0*z_14*z_830 + 3.0*z_371*z_986 + 3.0*z_63*z_987 - 4.0*z_34*z_993 - 2.0*z_496*z_781 -
        2.0*q4_dot*z_570 - 6.0*z_994*z_589 - 6.0*z_33*z_977 - 4.0*z_979*z_330 - z_713*z_969 - z_439*z_965 -
        2.0*z_969*z_329 - 3.0*z_981*z_787 - 2.0*z_210*z_982 - 3.0*z_73*z_828 - z_995*z_73 - 12.0*z_937*z_957 -
        6.0*z_972*z_288 - 4.0*q3_ddot*z_795 - 2.0*z_996*z_153 - 2.0*z_428*z_986 - 2.0*z_156*z_987 - z_975*z_19 -
        2.0*z_206) + sin_q4*(8.0*z_805*z_997 + 4.0*z_994*z_202 + 6.0*z_769*z_909 + 2.0*q4_dot*z_998 +
        6.0*q4_dot*z_63*z_979 + 2.0*z_969*z_810 + 2.0*z_969*z_811 + z_915*z_158 + z_982*z_81 + 2.0*z_982*z_916 +
        4.0*z_981*z_812 + 12.0*z_957*z_533 + 6.0*sin_q2*z_972 + 2.0*z_999*z_153 - 12.0*sin_q5*z_997 -
        2.0*z_497*z_916 - 4.0*z_770*z_909 - 4.0*z_979*z_341 - 2.0*z_962*z_336 - z_965*z_470 - 2.0*z_965*z_602 -
        2.0*z_962*z_281 - 3.0*z_57*z_999 - cos_q2*z_975 - 2.0*z_567));
    const double z_1000 = (z_769*z_309 - 0.5*z_346*z_704) - 0.5*(z_193*z_350 + z_123*z_345);
    const double z_1001 = q5_dot*z_38;
    const double z_1002 = z_793 + sin_q1*z_24;
    const double z_1003 = z_22*sin_q1;
    const double z_1004 = sin_q4*z_937 + z_1003;
    const double z_1005 = l*lambda_2;
    const double z_1006 = z_22*cos_q1;
    const double z_1007 = sin_q4*z_940 - z_1006;
    const double z_1008 = l*lambda_0;
    const double z_1009 = z_35*z_818;
    const double z_1010 = sin_q5*z_1009;
    const double z_1011 = ((z_507*z_826 + z_492*z_622) - (z_92*z_628 + z_350*z_823)) + ((z_51*z_356 - z_92*z_359)
        - (z_51*z_357 + 4.0*(z_817*z_106 - 0.25*z_220*z_619)));
    const double z_1012 = q5_dot*cos_q3;
    const double z_1013 = z_380 - cos_q1*z_24;
    D[44] = ((-1.0/12.0))*(sin_q5*((6.0*z_455*z_435 + z_68*z_952 + z_931*z_832 + z_911*z_638 + z_491*z_915 +
        z_714*z_352 - z_57*(2.0*z_8*z_68 - 3.0*l*z_68) - z_934*z_652 - z_507*z_708 - z_711*z_640 - z_92*z_442 -
        z_719*z_382 - z_447*z_383 - 4.0*z_1000) + 4.0*z_803*z_106 + 2.0*z_212*z_618 + 2.0*l*z_82*z_565 +
        2.0*z_212*z_620 + 4.0*z_994*z_623 + 2.0*z_530*z_368 + 2.0*z_967*z_822 + 4.0*z_967*z_356 + 2.0*z_740*z_981
        + 4.0*z_981*z_826 + 4.0*z_73*z_816 + 4.0*z_961*z_111 + 12.0*z_1002*lambda_3 + 12.0*z_456*lambda_1 +
        8.0*q3_ddot*z_828 + 2.0*z_47*z_204 + 2.0*q1_ddot*z_367 + 2.0*z_371*z_987 + 4.0*z_1000 -
        2.0*q3_dot*z_777*z_344 - 2.0*z_492*z_219*z_35 - 2.0*z_492*z_294*z_210 - 2.0*z_120*z_627 -
        2.0*z_92*z_130*z_39 - 2.0*z_86*z_820 - 2.0*z_51*z_130*z_109 - 4.0*z_979*z_361 - 4.0*z_960*z_362 -
        2.0*z_963*z_625 - 4.0*z_967*z_357 - 4.0*z_963*z_359 - 4.0*z_967*z_824 - 4.0*z_963*z_628 - 8.0*z_40*z_977 -
        8.0*z_977*z_1001 - 4.0*z_960*z_364 - 4.0*z_33*z_980 - 12.0*z_1004*z_1005 - 12.0*z_1007*z_1008 -
        2.0*z_405*z_830 - 2.0*q2_ddot*z_631 - 2.0*z_63*z_986 - 2.0*z_372*z_973) + cos_q5*(2.0*z_778*z_316 +
        4.0*z_495*z_994 + 4.0*z_916*z_989 + 4.0*z_155*z_977 + 4.0*z_979*z_376 + 2.0*z_442*z_963 + 2.0*z_708*z_981
        + 2.0*z_911*z_953 + 8.0*z_977*z_1012 + 2.0*z_931*z_828 + 4.0*z_769*z_68 + 2.0*q3_ddot*z_832 +
        2.0*z_42*z_830 + 2.0*q1_ddot*z_349 + 2.0*z_97*z_204 + 2.0*z_973*z_383 - 8.0*z_1010 - (6.0*z_63*z_751 +
        4.0*z_1010 + 4.0*z_769*z_73 + z_92*z_625 + z_719*z_371 + z_447*z_372 - 6.0*z_1009 - z_507*z_740 -
        z_63*z_711 - z_51*z_822 - 2.0*z_1011) - 2.0*z_496*z_621 - 2.0*z_24*z_820 - 2.0*z_120*z_358 -
        4.0*z_39*z_980 - 4.0*z_109*z_961 - 2.0*z_716*z_967 - 4.0*z_963*z_636 - 4.0*z_967*z_831 - 4.0*z_960*z_378 -
        4.0*z_979*z_379 - 12.0*z_1004*lambda_3 - 12.0*z_1002*z_1005 - 12.0*lambda_1*z_369 - 12.0*z_1013*z_1008 -
        2.0*z_652*z_996 - 2.0*z_491*z_999 - 2.0*z_986*z_640 - 2.0*z_987*z_382 - 2.0*z_1011));
    D[45] = (1.0/6.0)*(3.0*z_140*z_963 + 2.0*sin_q3*z_971 + 3.0*z_96*z_967 + z_103*z_969 + 2.0*z_244*z_967 +
        z_102*z_969 + z_108*z_969 + 2.0*z_143*z_963 + 2.0*z_245*z_967 + z_429 - z_424 - 3.0*z_130*z_963 -
        z_85*z_970 - z_136*z_965 - z_133*z_966 - 2.0*z_147*z_963 - z_249*z_970 - 2.0*z_243*z_967 - z_40*z_966 -
        z_98*z_970 - 2.0*z_142*z_963 - z_137*z_965 - 2.0*z_248*z_967 - 2.0*z_145*z_963);
    const double z_1014 = cos_q4*z_40;
    D[46] = ((-1.0/6.0))*(3.0*z_961*z_288 + z_394*z_962 + z_970*z_398 + 2.0*z_397*z_967 + z_208*z_991 +
        3.0*z_212*z_981 + 2.0*z_795*z_1014 + 2.0*z_561*z_953 + 2.0*z_838*z_38 + q4_dot*z_991 + z_285*z_962 +
        2.0*z_395*z_960 + z_668 - z_662 - 3.0*z_396*z_967 - z_519*z_969 - 3.0*z_219*z_981 - z_82*z_982 -
        2.0*z_211*z_981 - 3.0*z_953*z_33 - z_155*z_982 - z_56*z_982 - 2.0*z_418*z_981 - 3.0*cos_q2*z_961);
    D[47] = ((-1.0/6.0))*(z_841 + sin_q4*z_492*z_211 + z_38*z_205 + 2.0*z_6*z_978 + 3.0*z_38*z_980 +
        3.0*z_371*z_979 + 3.0*z_961*z_24 + z_962*z_407 + z_966*z_123 + z_970*z_193 + 2.0*z_192*z_963 +
        4.0*z_795*z_954 + 2.0*z_201*z_979 + 2.0*z_845 - 3.0*z_6*z_977 - 2.0*z_406*z_979 - 2.0*z_19*z_971 -
        6.0*cos_q3*z_977 - z_982*z_782 - 3.0*z_769*z_106 - 3.0*sin_q4*sin_q4*z_993 - z_995*z_106 - q5_dot*z_995 -
        2.0*z_408*z_960);
    D[48] = (1.0/6.0)*(sin_q4*z_570 + cos_q4*z_998 + 3.0*z_652*z_994 + 3.0*z_208*z_989 + 3.0*z_861*z_979 +
        z_836*z_969 + z_837*z_969 + z_982*z_954 + 4.0*z_955 - z_82*z_660 - 2.0*z_305*z_994 - 2.0*z_208*z_990 -
        2.0*z_417*z_979 - z_414*z_962 - z_965*z_656 - q2_dot*z_991 - z_283*z_962 - 2.0*z_956);
    D[49] = (1.0/6.0)*(2.0*z_770*z_106 + 2.0*z_994*z_663 + 2.0*z_665*z_963 + 2.0*z_842*z_967 + 2.0*z_981*z_843 +
        q3_dot*z_995 + 2.0*z_960*z_427 + 2.0*z_428*z_979 - z_777*z_235 - 2.0*z_979*z_425 - 2.0*z_960*z_426 -
        2.0*z_86*z_971 - 2.0*z_666*z_963 - 4.0*z_36*z_977 - 4.0*z_38*z_992);
    const double z_1015 = z_9*z_35 - z_228;
    const double z_1016 = z_9*z_103;
    const double z_1017 = z_22*z_59 + (z_1016 + z_70*z_342);
    const double z_1018 = z_96 - (z_11*z_249 + z_11*z_98 + z_1015*z_19) - z_1017 - z_247;
    const double z_1019 = z_53*z_13 + z_8*q5_ddot;
    const double z_1020 = z_189 - q5_ddot*z_13;
    const double z_1021 = 2.0*z_35*z_59 + z_10*z_68 - sin_q4*z_1020 - q4_ddot*z_222;
    const double z_1022 = sin_q3*z_73 - z_172;
    const double z_1023 = z_187 + q1_dot*z_1018 + sin_q3*z_1019 + z_1022*z_13 + 2.0*z_195 - z_342*z_451 -
        z_11*z_178 - 2.0*z_40*z_1015 - q1_dot*z_1016 - z_11*z_179 - z_15*z_437 - z_22*z_438 - z_1015*z_133 -
        cos_q3*z_1021 - z_11*z_177 - z_26*q1_ddot;
    const double z_1024 = z_9*z_70;
    const double z_1025 = z_11*z_33;
    const double z_1026 = (z_11*z_40 - cos_q3*z_1015) + z_144;
    const double z_1027 = sin_q2*z_81 - cos_q2*q2_ddot;
    const double z_1028 = z_23*z_68 + 2.0*z_1015*z_98 + 2.0*z_94*z_1025 + z_23*z_81 + 2.0*z_1015*z_249 +
        z_1015*z_85 + z_736*q4_ddot + q2_ddot*z_432 + l*z_1027 + z_15*q1_ddot + 2.0*z_300 - 2.0*z_102*z_59 -
        2.0*z_281*z_1024 - z_11*z_287 - 2.0*z_103*z_59 - z_26*z_437 - q1_dot*z_1026 - z_22*z_1020 - z_1019*z_24 -
        z_1021*z_19 - z_1022*z_320 - z_177*z_270 - z_54*z_1027 - z_1027*z_165;
    D[50] = cos_q1*z_1023 - sin_q1*z_1028;
    const double z_1029 = q2_dot*z_1024;
    const double z_1030 = q1_dot*sin_q1;
    const double z_1031 = z_11*z_1030;
    const double z_1032 = cos_q1*z_1015;
    const double z_1033 = cos_q1*z_31;
    const double z_1034 = z_9*z_82;
    const double z_1035 = cos_q1*z_59;
    const double z_1036 = sin_q3*z_1030;
    const double z_1037 = cos_q1*z_222;
    const double z_1038 = cos_q1*z_437 + sin_q1*q1_ddot;
    const double z_1039 = cos_q1*z_40;
    const double z_1040 = l*z_1030;
    const double z_1041 = z_486*z_33;
    const double z_1042 = sin_q3*z_1032 - sin_q3*z_1031;
    const double z_1043 = cos_q1*z_32 + z_54*z_1030;
    const double z_1044 = z_1040 + (z_1041 + z_1042) - (cos_q1*z_72 + z_1043);
    const double z_1045 = cos_q4*z_1020;
    const double z_1046 = z_10*q4_ddot;
    D[51] = -(cos_q2*(2.0*cos_q1*z_1029 + 2.0*z_1031*z_33 + 2.0*z_1030*z_1034 + 2.0*z_82*z_1035 +
        2.0*z_1036*z_1015 + z_936*z_1019 + z_793*z_1021 + z_486*z_1022 + z_734*z_177 + z_54*z_1038 + z_1038*z_165
        - 2.0*z_1032*z_33 - 2.0*z_72*z_1030 - 2.0*z_40*z_1033 - z_487*z_81 - 2.0*z_32*z_1030 - q2_ddot*z_1037 -
        l*z_1038) - sin_q2*(2.0*z_1030*z_1024 + 2.0*z_70*z_1035 + z_1039*z_544 + z_211*z_1030 + 2.0*z_418*z_1030 +
        z_1031*z_208 + cos_q1*z_207 + cos_q1*z_1045 + z_487*q2_ddot - z_68*z_1037 - z_486*z_210 - z_81*z_1037 -
        q2_dot*z_1044 - z_212*z_1030 - z_1032*z_208 - cos_q1*z_1046 - z_1038*z_222));
    const double z_1047 = sin_q1*z_31;
    const double z_1048 = q1_dot*cos_q1;
    const double z_1049 = z_13*z_1048;
    const double z_1050 = cos_q1*z_94;
    const double z_1051 = (z_1047 - z_1049) + (z_11*z_1050 + sin_q2*z_1032 - sin_q2*z_1031);
    const double z_1052 = z_13*z_1030;
    const double z_1053 = q3_dot*z_11;
    const double z_1054 = sin_q2*cos_q1;
    const double z_1055 = sin_q1*z_437 - cos_q1*q1_ddot;
    const double z_1056 = sin_q1*z_1015;
    const double z_1057 = z_11*z_1048;
    const double z_1058 = (z_1056 + z_1057) + (z_13*z_1050 - sin_q2*z_1033 - z_1030*z_270);
    const double z_1059 = z_1015*z_1030;
    D[52] = -(sin_q3*(q3_dot*z_1051 + z_1050*z_1053 + 2.0*z_1030*z_231 + 2.0*z_1015*z_1048 + q3_dot*z_1047 +
        z_1032*z_233 - z_767*z_73 - 2.0*z_1052*z_94 - 2.0*z_31*z_1050 - z_1031*z_233 - z_1048*z_235 -
        z_1019*z_1054 - sin_q1*z_1021 - z_739*q3_ddot - z_734*z_1027 - z_1038*z_270 - z_11*z_1055) -
        cos_q3*(z_739*z_73 + 2.0*z_1015*z_1050 + z_1052*z_233 + 2.0*z_1048*z_31 + z_1033*z_233 + sin_q1*z_1019 +
        z_1055*z_13 - q3_dot*z_1058 - z_1050*z_235 - 2.0*z_1031*z_94 - 2.0*sin_q2*z_1059 - q3_dot*z_1057 -
        q3_dot*z_1056 - z_1021*z_1054 - z_767*q3_ddot - z_486*z_1027 - z_1038*z_320));
    const double z_1060 = sin_q1*z_40;
    const double z_1061 = cos_q3*z_1048 - z_1060;
    const double z_1062 = z_19*z_1030 - (cos_q1*z_249 + cos_q1*z_98);
    const double z_1063 = z_1061 + (-z_1062);
    const double z_1064 = q4_dot*z_342;
    const double z_1065 = cos_q2*cos_q1;
    const double z_1066 = q4_dot*z_9;
    const double z_1067 = z_281*z_1066;
    const double z_1068 = z_1061 - z_1062;
    const double z_1069 = cos_q1*z_342;
    const double z_1070 = 2.0*z_40*z_1048 + 2.0*z_249*z_1030 + 2.0*z_98*z_1030 + z_1022*z_1054 + sin_q1*z_177 +
        z_793*z_1027 + z_1038*z_19 + cos_q3*z_1055 - 2.0*z_33*z_1050;
    const double z_1071 = z_9*z_281;
    const double z_1072 = cos_q2*z_59;
    D[53] = -(cos_q4*(z_1063*z_59 + 2.0*z_1030*z_1064 + 2.0*z_334*z_1065 + 2.0*cos_q1*z_1067 + z_68*z_941 +
        z_1068*z_59 + z_9*z_1070 - z_940*z_1020 - q4_ddot*z_1069) + sin_q4*(z_68*z_1069 + z_1063*z_1066 +
        z_81*z_1069 + z_1068*z_1066 + q4_ddot*z_941 + cos_q1*q2_ddot*z_605 + z_1038*z_342 - 2.0*z_940*z_334 -
        2.0*z_1030*z_1071 - 2.0*z_281*z_1035 - 2.0*z_1030*z_1072 - z_1020*z_1065));
    const double z_1073 = z_940*z_35;
    const double z_1074 = z_22*z_1030;
    const double z_1075 = cos_q1*z_103;
    const double z_1076 = cos_q1*z_102;
    const double z_1077 = (z_1073 + sin_q4*z_1063) + (z_1074 + z_1075 + z_1076);
    const double z_1078 = l*z_53;
    const double z_1079 = l*q5_ddot;
    const double z_1080 = l*z_1022;
    const double z_1081 = cos_q1*z_177;
    const double z_1082 = sin_q3*z_1048;
    const double z_1083 = sin_q1*z_33;
    const double z_1084 = cos_q1*z_111;
    const double z_1085 = (z_1082 + z_1083) + (z_24*z_1030 + z_1084 - cos_q3*z_1050);
    D[54] = sin_q5*(z_1077*z_344 + z_1076*z_344 + z_1073*z_344 + 2.0*z_132*z_1048 + 2.0*z_41*z_1050 + z_1075*z_344
        + 2.0*z_1030*z_354 + z_1074*z_344 + z_1068*z_624 + z_1007*z_1079 + z_17*z_1081 + z_1027*z_827 +
        z_348*z_1038 - z_1013*z_1078 - 2.0*z_1040*z_111 - sin_q1*z_1080 - z_97*z_1055) + cos_q5*(z_1007*z_1078 +
        z_1085*z_344 + z_1083*z_344 + z_1084*z_344 + z_1030*z_373 + z_1082*z_344 + z_1013*z_1079 - z_1050*z_346 -
        l*(z_1068*z_35 + z_1063*z_35 + z_1006*z_81 + z_1006*z_68 + cos_q1*z_284 + z_940*z_183 + cos_q1*z_286 +
        z_22*z_1038 - z_940*z_234 - 2.0*z_103*z_1030 - 2.0*z_102*z_1030 - 2.0*cos_q1*z_282 - sin_q4*z_1070));
    const double z_1086 = sin_q1*z_94;
    const double z_1087 = z_15*z_1030;
    const double z_1088 = z_26*z_1048;
    const double z_1089 = sin_q1*z_342;
    const double z_1090 = z_82*z_603;
    const double z_1091 = sin_q1*z_59;
    D[55] = l*z_1086 + z_738*z_111 + z_1047*z_24 + sin_q3*z_1033 + cos_q3*z_1032 - z_1087 - z_1088 -
        ((cos_q1*z_1026 + z_1087) - (sin_q1*z_1018 - z_1088)) - z_70*z_1089 - z_766*z_98 - cos_q1*z_142 -
        z_486*z_40 - z_9*z_1090 - z_54*z_1086 - z_766*z_249 - z_22*z_1091 - z_1056*z_19;
    const double z_1092 = z_487*z_281;
    const double z_1093 = (z_1024*z_1054 - z_222*z_1050) + (z_285*z_1035 + z_1030*z_432);
    D[56] = z_1092 + ((z_1092 + cos_q2*z_1044) - z_1093) + cos_q2*z_1041 + z_279*z_1030 + z_1032*z_288 - z_1093 -
        z_72*z_1065 - z_1030*z_298 - z_1031*z_288 - z_32*z_1065;
    const double z_1094 = z_767*z_33;
    const double z_1095 = z_739*z_40;
    const double z_1096 = z_380*z_1015 + sin_q3*z_1057;
    const double z_1097 = sin_q1*z_32 - z_54*z_1048;
    D[57] = -(z_1094 + ((z_1094 + sin_q3*z_1058) - (z_1095 + cos_q3*z_1051)) + z_734*z_249 + z_1031*z_24 + z_1096
        - z_1095 - z_12*z_1050 - z_1030*z_297 - z_1033*z_19 - z_1032*z_24 - z_1097);
    const double z_1098 = z_10*z_281;
    const double z_1099 = (cos_q1*z_1098 - z_35*z_1069) + (z_283*z_1035 + z_736*z_1030);
    const double z_1100 = z_940*z_1024 + z_940*z_418;
    D[58] = -(z_1099 + ((z_1100 - z_1063*z_222) + z_1099) + z_1100 - z_1068*z_222);
    const double z_1101 = z_1013*z_59;
    const double z_1102 = z_1007*z_31;
    D[59] = z_1101 + z_1102 + ((z_1101 + z_8*z_1085) + (z_1102 - z_1077*z_13)) + z_8*z_1083 + z_8*z_1084 +
        z_1030*z_295 + z_1048*z_191 - z_734*z_102 - z_1073*z_13 - z_734*z_103 - z_166*z_1050 - z_22*z_1052 -
        z_1068*z_985;
    const double z_1103 = z_132 + (z_9*z_155 + z_9*z_56 - z_584) - z_583;
    D[61] = -(cos_q2*(2.0*z_539 + z_1045 + z_468*q2_ddot + z_912 - z_908 - z_9*z_909 - z_68*z_222 - z_9*z_910 -
        q2_dot*z_1103 - z_81*z_222 - z_1046) + sin_q2*(2.0*z_705 + z_467*z_68 + 2.0*z_1029 + z_10*z_1022 + z_1080
        + 2.0*z_613 + z_614 - 2.0*z_9*z_610 - z_468*z_81 - z_1020*z_38 - z_222*z_169 - q2_ddot*z_222));
    const double z_1104 = l*z_281 + (z_1098 + z_283*z_59 - z_35*z_342);
    const double z_1105 = z_339 + z_343;
    D[62] = -(sin_q3*(z_53*z_566 + z_73*z_566 + q3_dot*z_1104 + z_106*z_1071 + z_316*z_281 + z_106*z_1072 +
        q5_ddot*z_984 + z_1105*z_13 - 2.0*z_31*z_281 - z_309*z_342 - z_737*q3_ddot) + cos_q3*(2.0*cos_q2*z_569 +
        2.0*z_281*z_235 + 2.0*z_228*z_281 + z_283*z_1020 + z_23*q4_ddot - 2.0*z_35*z_1072 - z_736*z_68 -
        2.0*z_35*z_1071 - z_737*z_73 - q3_ddot*z_566 - z_10*z_1105 - l*z_1105));
    D[63] = cos_q4*(sin_q3*z_68*z_342 + 2.0*z_94*z_1066 + 2.0*z_33*z_1072 + 2.0*q2_dot*z_9*z_98 + q4_ddot*z_605 +
        z_1022*z_342 + sin_q3*z_9*z_1105 - 2.0*sin_q2*z_334 - 2.0*z_19*z_812 - z_1020*z_288) -
        sin_q4*(2.0*z_334*z_288 + 2.0*z_1066*z_387 + z_68*z_605 + 2.0*z_94*z_59 + z_81*z_605 - 2.0*z_33*z_1064 -
        sin_q2*z_1020 - z_342*z_169 - q2_ddot*z_342);
    const double z_1106 = cos_q4*z_94;
    const double z_1107 = z_283*z_33;
    const double z_1108 = z_35*z_288;
    const double z_1109 = q2_dot*z_29;
    const double z_1110 = (z_1106 - z_385) + (z_1107 + z_1108 - z_1109);
    D[64] = -(sin_q5*(z_53*z_369 + z_1110*z_344 + z_1108*z_344 + z_73*z_369 + z_1107*z_344 + z_1106*z_344 +
        z_455*z_1079 + z_393*q3_ddot + z_42*z_1105 - z_385*z_344 - 2.0*z_212*z_111 - z_1109*z_344) +
        cos_q5*(2.0*cos_q2*z_40*z_344 + 2.0*q2_dot*z_373 + z_455*z_1078 + l*(z_285*z_81 + 2.0*z_94*z_70 +
        z_285*z_68 + 2.0*q2_dot*z_107 + 2.0*q2_dot*z_108 + z_394*z_68 + z_308*q4_ddot + z_283*z_1022 + z_1105*z_38
        - 2.0*cos_q2*z_610 - z_22*z_169 - z_22*q2_ddot) - q5_ddot*z_369));
    const double z_1111 = z_468*z_94;
    D[66] = z_1017 + (z_1017 - (z_1111 - sin_q2*z_1103)) + z_99 + z_9*z_108 + z_9*z_107 - z_1111 - z_228*z_19 -
        z_246;
    const double z_1112 = z_737*z_40;
    const double z_1113 = z_31*z_288 + (z_19*z_544 - cos_q2*z_142);
    D[67] = z_1112 + ((z_1112 + cos_q3*z_1104) - z_1113) + z_212*z_24 + z_10*z_389 + z_6*z_1072 - z_1113 -
        z_137*z_342;
    const double z_1114 = (z_19*z_1034 + z_38*z_1064) - (z_23*z_33 - z_951*z_59);
    const double z_1115 = sin_q2*z_228 - (z_10*z_94 + z_9*z_307);
    D[68] = z_1114 + ((-z_1115) + z_1114) - z_1115;
    const double z_1116 = z_455*z_31;
    const double z_1117 = z_40*z_984 + (q2_dot*z_295 - cos_q3*z_1072);
    D[69] = -(z_1116 + z_1117 + ((z_1116 - z_1110*z_13) + z_1117) + z_70*z_270 + z_29*z_544 - z_1108*z_13 -
        z_142*z_283 - z_94*z_540);
    D[70] = -(cos_q1*z_1028 + sin_q1*z_1023);
    const double z_1118 = sin_q1*z_222;
    const double z_1119 = l*z_1048;
    const double z_1120 = z_1119 + (sin_q1*z_72 + z_1097) - (z_766*z_33 + z_1096);
    D[71] = cos_q2*(2.0*sin_q1*z_1029 + 2.0*z_72*z_1048 + 2.0*z_82*z_1091 + 2.0*z_32*z_1048 + z_939*z_1019 +
        z_380*z_1021 + z_766*z_1022 + z_738*z_177 + z_54*z_1055 + z_1055*z_165 - 2.0*z_1057*z_33 - 2.0*z_1056*z_33
        - 2.0*z_40*z_1047 - 2.0*z_1048*z_1034 - z_485*z_81 - 2.0*z_1082*z_1015 - q2_ddot*z_1118 - l*z_1055) +
        sin_q2*(2.0*z_1048*z_1024 + z_68*z_1118 + z_766*z_210 + z_81*z_1118 + z_211*z_1048 + 2.0*z_418*z_1048 +
        z_1057*z_208 + z_1056*z_208 + sin_q1*z_1046 + z_1055*z_222 - 2.0*z_70*z_1091 - z_1060*z_544 -
        q2_dot*z_1120 - z_212*z_1048 - sin_q1*z_207 - z_1020*z_976 - z_485*q2_ddot);
    const double z_1121 = (z_1033 + z_1052) - (z_11*z_1086 + z_1015*z_603 + sin_q2*z_1057);
    const double z_1122 = sin_q2*z_1048;
    const double z_1123 = (z_1032 - z_1031) - (z_13*z_1086 + z_1048*z_270 - z_31*z_603);
    D[72] = -(sin_q3*(q3_dot*z_1121 + 2.0*z_31*z_1086 + 2.0*z_31*z_1122 + z_1030*z_235 + q3_dot*z_1033 +
        z_1019*z_603 + z_738*z_1027 + z_1055*z_270 - z_765*z_73 - 2.0*z_1049*z_94 - z_1086*z_1053 - z_1057*z_233 -
        2.0*z_1059 - z_1056*z_233 - cos_q1*z_1021 - z_735*q3_ddot - z_11*z_1038) - cos_q3*(z_735*z_73 +
        z_1086*z_235 + z_1049*z_233 + q3_dot*z_1031 + cos_q1*z_1019 + z_1021*z_603 + z_766*z_1027 + z_1055*z_320 +
        z_1038*z_13 - q3_dot*z_1123 - 2.0*z_1057*z_94 - 2.0*z_1015*z_1086 - 2.0*z_1015*z_1122 - 2.0*z_31*z_1030 -
        q3_dot*z_1032 - z_1047*z_233 - z_765*q3_ddot));
    const double z_1124 = sin_q1*z_98;
    const double z_1125 = sin_q1*z_249;
    const double z_1126 = (cos_q3*z_1030 + z_1039) + (z_1124 + (z_19*z_1048 + z_1125));
    const double z_1127 = z_1126;
    const double z_1128 = z_1022*z_603;
    const double z_1129 = 2.0*z_40*z_1030 + z_1128 + z_380*z_1027 + z_1055*z_19 - 2.0*z_249*z_1048 -
        2.0*z_98*z_1048 - 2.0*z_33*z_1086 - z_1081 - cos_q3*z_1038;
    D[73] = cos_q4*(z_1127*z_59 + 2.0*z_334*z_533 + 2.0*sin_q1*z_1067 + z_1126*z_59 + z_937*z_1020 + z_9*z_1129 -
        2.0*z_1048*z_1064 - z_68*z_938 - q4_ddot*z_1089) + sin_q4*(z_68*z_1089 + z_1127*z_1066 + 2.0*z_937*z_334 +
        2.0*z_1048*z_1071 + z_81*z_1089 + 2.0*z_1048*z_1072 + z_1126*z_1066 + q2_ddot*z_604 + z_1055*z_342 -
        2.0*z_281*z_1091 - z_1020*z_533 - q4_ddot*z_938);
    const double z_1130 = z_937*z_35;
    const double z_1131 = sin_q1*z_102;
    const double z_1132 = z_22*z_1048;
    const double z_1133 = (z_1130 - sin_q4*z_1127) - (z_1090 + z_1131 - z_1132);
    const double z_1134 = z_177*z_603;
    const double z_1135 = sin_q1*z_1027;
    const double z_1136 = cos_q1*z_33;
    const double z_1137 = sin_q1*z_111;
    const double z_1138 = (z_1136 - z_1036) + (z_24*z_1048 + cos_q3*z_1086 - z_1137);
    const double z_1139 = ((z_102*z_1048 + 0.5*sin_q1*z_284) - 0.5*(z_937*z_183 - sin_q1*z_286)) +
        0.5*((z_22*z_1055 + (z_937*z_234 + z_1127*z_35)) - 2.0*((sin_q1*z_282 - 0.5*z_1003*z_81) - (z_103*z_1048 +
        0.5*z_1003*z_68)));
    D[74] = sin_q5*(z_1133*z_344 + z_1130*z_344 + 2.0*z_1048*z_354 + z_1132*z_344 + z_1004*z_1079 - z_1002*z_1078
        - z_1131*z_344 - 2.0*z_132*z_1030 - 2.0*z_1119*z_111 - 2.0*z_41*z_1086 - z_1090*z_344 - z_1126*z_624 -
        cos_q1*z_1080 - l*z_1134 - z_42*z_1135 - z_348*z_1055 - z_97*z_1038) + cos_q5*(z_1004*z_1078 +
        z_1138*z_344 + z_1136*z_344 + z_1086*z_346 + z_1048*z_373 + z_1002*z_1079 + l*(z_1126*z_35 + 2.0*z_1139 -
        sin_q4*z_1129) - z_1137*z_344 - z_1036*z_344);
    const double z_1140 = z_15*z_1048;
    const double z_1141 = z_26*z_1030;
    D[75] = l*z_1050 + z_1141 + ((sin_q1*z_1026 - z_1140) + (z_1141 + cos_q1*z_1018)) + sin_q1*z_142 + z_734*z_111
        + z_766*z_40 + z_1033*z_24 - z_1140 - z_70*z_1069 - z_486*z_98 - cos_q1*z_1016 - z_54*z_1050 - z_486*z_249
        - z_22*z_1035 - z_1032*z_19 - cos_q3*z_1056 - z_380*z_31;
    const double z_1142 = z_485*z_281;
    const double z_1143 = (z_603*z_1024 - z_222*z_1086) + (z_285*z_1091 - z_1048*z_432);
    D[76] = -(z_1142 + ((z_1142 - cos_q2*z_1120) - z_1143) + z_533*z_1025 + z_1048*z_298 + z_1057*z_288 +
        z_1056*z_288 - z_1143 - z_72*z_533 - z_279*z_1048 - z_32*z_533);
    const double z_1144 = z_765*z_33;
    const double z_1145 = z_735*z_40;
    D[77] = -(z_1144 + ((z_1144 + sin_q3*z_1123) - (z_1145 + cos_q3*z_1121)) + z_12*z_1086 + z_1057*z_24 +
        z_1056*z_24 + z_1047*z_19 + z_1042 - z_1145 - z_738*z_249 - z_1048*z_297 - z_1043);
    const double z_1146 = (sin_q1*z_1098 - z_35*z_1089) + (z_283*z_1091 - z_736*z_1048);
    const double z_1147 = z_937*z_1024 + z_937*z_418;
    D[78] = -(((z_1127*z_222 + z_1147) - z_1146) + z_1126*z_222 + z_1147 - z_1146);
    const double z_1148 = z_1002*z_59;
    const double z_1149 = z_1004*z_31;
    D[79] = z_1148 + z_1149 + ((z_1148 + z_8*z_1138) + (z_1149 - z_1133*z_13)) + z_738*z_102 + z_8*z_1136 +
        z_1090*z_13 + z_1086*z_166 + z_1048*z_295 + z_1126*z_985 - z_1130*z_13 - z_8*z_1137 - z_1132*z_13 -
        z_1030*z_191;
    const double z_1150 = q1_dot*cos_q5;
    const double z_1151 = sin_q5*z_40;
    const double z_1152 = cos_q5*z_35;
    const double z_1153 = (sin_q5*z_33 + sin_q3*z_37) - (cos_q5*z_137 - cos_q5*z_39 - z_6*z_34);
    const double z_1154 = sin_q4*z_34;
    const double z_1155 = z_1152 - z_1154;
    const double z_1156 = cos_q5*z_38;
    const double z_1157 = cos_q5*z_53 + sin_q5*q5_ddot;
    const double z_1158 = sin_q5*z_53 - cos_q5*q5_ddot;
    const double z_1159 = 2.0*z_35*z_34 + cos_q5*z_234 + sin_q4*z_1157 - cos_q5*z_183;
    const double z_1160 = sin_q5*z_111;
    const double z_1161 = (z_94*z_36 + z_24*z_37 - z_1160) + (cos_q5*z_103 + cos_q5*z_102 + z_22*z_34) +
        (cos_q5*z_105 + cos_q5*z_107 + cos_q5*z_108 - z_29*z_34);
    const double z_1162 = sin_q4*cos_q5;
    D[80] = -(cos_q1*(z_39*z_1150 + 2.0*z_102*z_34 + 2.0*cos_q5*z_282 + 2.0*z_111*z_37 + 2.0*z_94*z_1151 +
        z_107*z_34 + sin_q5*z_128 + 2.0*z_103*z_34 + z_105*z_34 + q1_dot*z_1153 + z_30*z_437 + z_123*z_37 +
        z_177*z_269 + cos_q5*z_308*z_1022 + z_1027*z_1156 + z_1027*z_36 + z_7*q1_ddot + z_1158*z_24 + z_1159*z_19
        - z_28*z_68 - z_98*z_1152 - 2.0*cos_q5*z_155*z_94 - z_28*z_81 - z_249*z_1152 - 2.0*z_37*z_110 -
        z_98*z_1155 - z_249*z_1155 - z_85*z_1155 - cos_q5*z_284 - cos_q5*z_286 - z_22*z_1157) +
        sin_q1*(z_102*z_1150 + z_40*z_1152 + cos_q5*z_106*z_193 + 2.0*z_33*z_37 + z_103*z_1150 + z_310*z_1156 +
        sin_q5*z_85*z_94 + q1_dot*z_1161 + z_136*z_34 + z_133*z_1155 + z_40*z_1155 + z_193*z_37 + z_177*z_1162 +
        z_30*q1_ddot + cos_q3*z_1159 - z_34*z_39 - q1_dot*z_1160 - z_7*z_437 - sin_q5*z_1022 - sin_q3*z_1158));
    const double z_1163 = sin_q5*z_1048;
    const double z_1164 = q5_dot*z_266;
    const double z_1165 = cos_q5*z_1048;
    const double z_1166 = sin_q1*z_34;
    const double z_1167 = z_1048*z_34;
    const double z_1168 = sin_q1*z_1155;
    const double z_1169 = sin_q4*z_266;
    const double z_1170 = cos_q5*z_1055;
    const double z_1171 = cos_q4*z_266;
    const double z_1172 = z_1048*z_36;
    const double z_1173 = (cos_q3*z_1164 + z_1172 - z_40*z_319) + (z_155*z_266 + z_56*z_266 + z_38*z_1165 -
        z_38*z_1166);
    D[81] = -(cos_q2*(2.0*z_71*z_266 + 2.0*z_40*z_1163 + 2.0*z_40*z_1164 + z_155*z_1166 + 2.0*z_82*z_1166 +
        z_484*z_81 + z_38*z_1167 + z_177*z_319 + z_1022*z_1169 + z_38*z_1170 + z_1055*z_36 + z_939*z_1158 +
        z_380*z_1159 - 2.0*z_155*z_1165 - z_610*z_266 - 2.0*z_82*z_1165 - z_56*z_1165 - 2.0*z_1165*z_1012 -
        z_33*z_1168 - z_1082*z_1155 - z_611*z_266) + sin_q2*(2.0*z_70*z_1165 + z_68*z_1171 + z_910*z_266 +
        z_81*z_1171 + q2_dot*z_1173 + z_1165*z_220 + 2.0*cos_q4*z_1167 + q2_dot*z_1172 + z_208*z_1168 +
        z_1164*z_647 + q4_ddot*z_1169 + z_484*q2_ddot + cos_q4*z_1170 + z_1157*z_976 - 2.0*z_70*z_1166 -
        z_319*z_209));
    const double z_1174 = q5_dot*z_160;
    const double z_1175 = sin_q5*z_1030;
    const double z_1176 = z_94*z_266;
    const double z_1177 = (z_1174 - z_1175) + (sin_q4*z_1176 + z_266*z_307 + z_308*z_1165 - z_1154*z_603);
    const double z_1178 = cos_q5*z_1030;
    const double z_1179 = sin_q5*z_1086;
    const double z_1180 = (z_1179 + sin_q2*z_1164 + sin_q2*z_1163) - (z_35*z_160 - cos_q1*z_1154 - sin_q4*z_1178);
    const double z_1181 = cos_q1*z_1155;
    D[82] = sin_q3*(z_764*z_73 + z_1154*z_1030 + q3_dot*z_1175 + z_1027*z_319 + z_1055*z_269 + z_1158*z_603 -
        q3_dot*z_1177 - z_106*z_1176 - 2.0*z_94*z_1163 - 2.0*z_94*z_1164 - z_35*z_1178 - z_1165*z_261 -
        2.0*q5_dot*sin_q2*z_1165 - z_233*z_1168 - z_1155*z_1030 - q3_dot*z_1174 - z_733*q3_ddot - z_1038*z_1162 -
        cos_q1*z_1159) - cos_q3*(q3_dot*z_1180 + z_733*z_73 + z_1154*z_1086 + q3_dot*z_1179 + z_106*z_1178 +
        2.0*z_1030*z_37 + z_308*z_1167 + z_233*z_1163 + z_233*z_1164 + z_764*q3_ddot + z_1027*z_1169 +
        sin_q5*z_1038 + z_308*z_1170 + cos_q1*z_1158 + z_1159*z_603 - 2.0*z_1165*z_317 - z_35*z_1176 -
        z_1165*z_307 - z_1155*z_1086 - z_1155*z_1122 - q3_dot*z_1181);
    const double z_1182 = q4_dot*z_34;
    const double z_1183 = q4_dot*z_266;
    const double z_1184 = cos_q5*z_937;
    const double z_1185 = cos_q2*z_266;
    const double z_1186 = cos_q5*z_1127;
    D[83] = -(cos_q4*(2.0*z_40*z_1178 + z_1039*z_34 + z_561*z_1030 + 2.0*z_533*z_1182 + 2.0*z_281*z_1183 +
        z_98*z_1166 + z_249*z_1166 + z_19*z_1167 + z_1127*z_34 + sin_q2*z_1022*z_266 + sin_q3*z_1027*z_266 +
        z_19*z_1170 - z_177*z_160 - z_503*z_1038 - 2.0*z_1165*z_325 - z_68*z_1184 - 2.0*z_98*z_1165 -
        2.0*z_33*z_1176 - 2.0*z_249*z_1165 - q4_ddot*z_1185 - z_937*z_1157) + sin_q4*(z_68*z_1185 + q4_dot*z_1186
        + 2.0*z_937*z_1182 + q4_dot*z_40*z_160 + z_98*z_1183 + 2.0*z_281*z_1165 + z_81*z_1185 + z_249*z_1183 +
        z_1178*z_337 + z_1165*z_336 + 2.0*cos_q2*z_1167 + z_343*z_266 + cos_q2*z_1170 + z_1157*z_533 -
        2.0*z_281*z_1166 - q4_ddot*z_1184));
    const double z_1187 = q5_dot*z_1048;
    D[84] = -(sin_q5*(z_1004*z_53 + q5_dot*z_1138 + q5_dot*z_1136 + z_1086*z_1012 + z_24*z_1187 + z_1002*q5_ddot +
        z_1039*z_35 + 2.0*z_107*z_1048 + z_1124*z_35 + 2.0*z_155*z_1086 + 2.0*z_105*z_1048 + z_1125*z_35 +
        z_137*z_1030 + z_108*z_1048 + sin_q4*z_1081 + z_1038*z_6 + 2.0*z_1139 - q5_dot*z_1137 - q5_dot*z_1036 -
        2.0*z_1030*z_39 - sin_q4*z_1128 - z_38*z_1135 - z_29*z_1055) + cos_q5*(2.0*z_33*z_1030 + 2.0*z_1048*z_111
        + 2.0*z_40*z_1086 + z_1002*z_53 + q5_dot*z_1131 + q5_dot*z_1090 + cos_q1*z_1022 + z_1134 + z_939*z_1027 +
        z_1055*z_24 + sin_q3*z_1038 + q5_dot*cos_q1*z_39 + q5_dot*sin_q1*z_107 + z_1086*z_1001 + q5_dot*z_1030*z_6
        + z_29*z_1187 - 2.0*z_1048*z_110 - q5_dot*z_1133 - q5_dot*z_1130 - q5_dot*z_1132 - z_1004*q5_ddot));
    const double z_1188 = z_30*z_1030;
    const double z_1189 = z_7*z_1048;
    D[85] = -(z_1188 + z_1189 + ((z_1188 - cos_q1*z_1161) + (z_1189 + sin_q1*z_1153)) + z_33*z_319 + sin_q5*z_1084
        + z_266*z_39 + sin_q3*z_1164 - z_102*z_160 - z_103*z_160 - z_1050*z_36 - z_107*z_160 - z_105*z_160 -
        z_1006*z_34 - z_19*z_1181 - z_939*z_1155 - z_1174*z_24);
    const double z_1190 = z_484*z_281;
    const double z_1191 = (z_385*z_266 - cos_q4*z_1176) + (z_285*z_1166 - z_285*z_1165);
    D[86] = -(z_1190 + z_1191 + ((z_1190 - cos_q2*z_1173) + z_1191) + z_533*z_1151 - z_1107*z_266 - z_394*z_1165 -
        cos_q2*z_1172 - z_288*z_1168 - z_1164*z_789);
    const double z_1192 = z_733*z_40;
    const double z_1193 = z_764*z_33;
    D[87] = -(z_1192 + z_1193 + ((z_1192 - cos_q3*z_1177) + (z_1193 + sin_q3*z_1180)) + z_249*z_319 + z_38*z_1178
        + z_1030*z_36 + z_19*z_1163 + z_19*z_1164 - z_6*z_1176 - z_1165*z_407 - z_24*z_1168 - z_793*z_1155 -
        z_160*z_1012);
    const double z_1194 = (z_281*z_1169 - z_35*z_1185) + (z_283*z_1166 - z_283*z_1165);
    const double z_1195 = z_70*z_1184 + z_34*z_948;
    D[88] = ((cos_q4*z_1186 + z_1195) - z_1194) + z_160*z_1014 + z_98*z_1171 + z_249*z_1171 + z_1178*z_411 +
        z_414*z_1165 + z_1195 - z_1194;
    const double z_1196 = z_1004*z_37;
    const double z_1197 = z_1002*z_34;
    D[89] = z_1196 + ((z_1196 + sin_q5*z_1133) - (z_1197 - cos_q5*z_1138)) + z_33*z_160 + cos_q3*z_1176 +
        sin_q5*z_1130 + z_22*z_1163 + z_24*z_1165 - z_1197 - z_266*z_111 - z_102*z_319 - z_732*z_39 - z_107*z_319
        - sin_q5*z_1090 - z_1179*z_38 - z_1175*z_6 - sin_q3*z_1178 - z_29*z_1163;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double l = c[1];
    const double z_0 = l*l;
    const double q1_dot = v[0];
    const double q2_dot = v[1];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double z_2 = q2_dot*cos_q2;
    const double z_3 = q1_dot*z_2;
    const double q3_dot = v[2];
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_5 = q3_dot*sin_q3;
    const double z_6 = l*z_5;
    const double z_7 = l*z_2;
    const double q4_dot = v[3];
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double z_9 = q4_dot*sin_q4;
    const double z_10 = cos_q2*z_9;
    const double sin_q2 = em_sin(q2);
    const double cos_q4 = em_cos(q4);
    const double z_13 = q2_dot*cos_q4;
    const double z_14 = sin_q2*z_13;
    const double z_15 = z_10 + z_14;
    const double z_16 = q4_dot*cos_q4;
    const double z_17 = sin_q2*sin_q3;
    const double z_18 = z_16*z_17;
    const double cos_q3 = em_cos(q3);
    const double z_20 = sin_q2*cos_q3;
    const double z_21 = q3_dot*z_20;
    const double z_22 = sin_q3*z_2;
    const double z_23 = z_21 + z_22 + q1_dot*cos_q3;
    const double z_24 = z_15 + z_18 + sin_q4*z_23;
    const double z_25 = l*z_24;
    const double z_26 = l*z_23;
    const double z_27 = 6.0*z_7 - z_25 - 5.0*z_26;
    const double z_28 = l*cos_q3;
    const double z_29 = l*sin_q4;
    const double z_30 = z_6 - (z_28*z_16 - z_29*z_5);
    const double q5 = x[4];
    const double cos_q5 = em_cos(q5);
    const double z_32 = l*cos_q5;
    const double z_33 = cos_q3*z_32;
    const double z_34 = sin_q2*z_5;
    const double q5_dot = v[4];
    const double sin_q5 = em_sin(q5);
    const double z_36 = l*sin_q5;
    const double z_37 = q5_dot*z_36;
    const double z_38 = cos_q2*cos_q4;
    const double z_39 = sin_q4*z_17;
    const double z_40 = z_38 - z_39;
    const double z_41 = q5_dot*z_32;
    const double z_42 = q1_dot*sin_q3;
    const double z_43 = z_2*z_33 + z_40*z_41 - z_32*z_34 - z_20*z_37 - z_32*z_42 - z_36*z_24;
    const double z_44 = z_7 - z_26;
    const double z_45 = 6.0*z_44 - z_43 - 5.0*z_25;
    const double z_46 = cos_q3*cos_q5;
    const double z_47 = q3_dot*z_46;
    const double z_48 = q5_dot*sin_q5;
    const double z_49 = sin_q3*z_48;
    const double z_50 = cos_q3*z_16;
    const double z_51 = sin_q4*cos_q3;
    const double z_52 = q5_dot*cos_q5;
    const double z_53 = sin_q4*sin_q5;
    const double z_54 = (z_47 - z_49) + (sin_q5*z_50 + z_51*z_52 - z_5*z_53);
    const double z_55 = l*z_54 + z_30;
    const double z_56 = 3.0*z_44 - 2.0*z_43 - 3.0*z_25;
    const double z_57 = sin_q3*sin_q4;
    const double z_58 = z_15 + (z_2*z_57 + sin_q4*z_21 + z_18);
    const double z_59 = l*sin_q3;
    const double z_60 = z_7 - (z_59*z_2 + l*z_21);
    const double z_61 = l*z_58 - z_60;
    const double z_62 = -z_61;
    const double z_63 = q3_dot*cos_q3;
    const double z_64 = q1_dot*z_20;
    const double z_65 = q1_dot*z_17;
    const double z_66 = z_5 + z_65;
    const double z_67 = q1_dot*z_38 + z_50 - sin_q4*z_66;
    const double z_68 = z_32*z_63 + z_51*z_41 + z_32*z_64 + z_36*z_67 - sin_q3*z_37;
    const double z_69 = l*z_67;
    const double z_70 = l*z_66;
    const double z_71 = l*sin_q2;
    const double z_72 = q1_dot*z_71 - q1_dot*l;
    const double z_73 = z_70 - z_72;
    const double z_74 = z_68 + 6.0*z_73 - 5.0*z_69;
    const double z_75 = 5.0*z_70 - z_69 - 6.0*z_72;
    const double z_76 = z_70 - 5.0*z_72;
    const double z_77 = z_46*z_2;
    const double z_78 = cos_q5*z_34;
    const double z_79 = z_20*z_48;
    const double z_80 = (sin_q5*z_58 - z_40*z_52) - (z_77 - z_78 - z_79);
    const double z_81 = l*z_80 - z_61;
    const double z_82 = 2.0*z_68 + 3.0*z_73 - 3.0*z_69;
    const double q1_ddot = a[0];
    const double z_83 = l - z_71;
    const double z_84 = l*z_83;
    const double z_85 = q2_dot*q2_dot;
    const double z_86 = l*cos_q2;
    const double q2_ddot = a[1];
    const double z_87 = z_71*z_85 - z_86*q2_ddot;
    const double z_88 = sin_q3*z_16;
    const double z_89 = q4_dot*q4_dot;
    const double z_90 = sin_q4*z_89;
    const double z_91 = q2_dot*z_9;
    const double q4_ddot = a[3];
    const double z_92 = cos_q4*q4_ddot;
    const double z_93 = cos_q2*sin_q4;
    const double z_94 = z_93*q4_ddot;
    const double z_95 = cos_q4*sin_q2;
    const double z_96 = z_95*q2_ddot;
    const double z_97 = q1_dot*z_5;
    const double z_98 = q3_dot*q3_dot;
    const double q3_ddot = a[2];
    const double z_99 = cos_q2*sin_q3;
    const double z_100 = z_97 + z_98*z_17 + z_85*z_17 - 2.0*z_2*z_63 - q3_ddot*z_20 - q2_ddot*z_99 -
        cos_q3*q1_ddot;
    const double z_101 = z_21*z_16 + z_88*z_2 + z_38*z_89 + z_38*z_85 + z_23*z_16 + z_92*z_17 + z_94 + z_96 -
        z_90*z_17 - 2.0*sin_q2*z_91 - sin_q4*z_100;
    const double z_102 = l*z_101;
    const double z_103 = l*z_100;
    const double z_104 = 6.0*z_87 + z_102 - 5.0*z_103;
    const double z_105 = l*z_51;
    const double z_106 = z_28 + z_105;
    const double z_107 = q5_dot*q5_dot;
    const double z_108 = z_32*z_20;
    const double z_109 = cos_q3*z_37;
    const double z_110 = z_40*z_36;
    const double z_111 = z_5*z_32;
    const double q5_ddot = a[4];
    const double z_112 = z_36*z_20;
    const double z_113 = q5_ddot*z_32;
    const double z_114 = z_32*z_17;
    const double z_115 = cos_q2*q2_ddot;
    const double z_116 = sin_q3*z_32;
    const double z_117 = q1_dot*z_32;
    const double z_118 = z_42*z_37 - z_63*z_117;
    const double z_119 = 2.0*z_34*z_37 + z_40*z_113 + z_115*z_33 + z_118 - z_107*z_108 - 2.0*z_109*z_2 -
        z_107*z_110 - z_58*z_41 - z_98*z_108 - 2.0*z_111*z_2 - z_85*z_108 - z_24*z_41 - q5_ddot*z_112 -
        q3_ddot*z_114 - q1_ddot*z_116 - z_36*z_101;
    const double z_120 = z_87 - z_103;
    const double z_121 = z_119 + 5.0*z_102 + 6.0*z_120;
    const double z_122 = sin_q3*cos_q5;
    const double z_123 = sin_q5*z_51;
    const double z_124 = z_122 + z_123;
    const double z_125 = z_106 - l*z_124;
    const double z_126 = 2.0*z_119 + 3.0*z_102 + 3.0*z_120;
    const double z_127 = l*z_17 + z_83;
    const double z_128 = l*z_40 - z_127;
    const double z_129 = -z_128;
    const double z_130 = z_36*z_51;
    const double z_131 = sin_q4*z_5;
    const double z_132 = sin_q3*z_36;
    const double z_133 = cos_q4*cos_q3;
    const double z_134 = cos_q3*z_98 + sin_q3*q3_ddot;
    const double z_135 = q3_dot*z_64;
    const double z_136 = z_2*z_42;
    const double z_137 = z_135 + z_136;
    const double z_138 = q1_ddot*z_17 + z_134 + z_137;
    const double z_139 = q1_dot*z_10 + q1_dot*z_14;
    const double z_140 = z_5*z_16 + z_89*z_51 + z_66*z_16 + sin_q4*z_138 + z_139 - q4_ddot*z_133 - z_38*q1_ddot;
    const double z_141 = z_33*z_3 - (z_64*z_37 + z_34*z_117);
    const double z_142 = z_107*z_130 + z_41*z_131 + z_107*z_116 + 2.0*z_63*z_37 + z_98*z_116 + q5_ddot*z_132 +
        z_36*z_140 - z_50*z_41 - z_67*z_41 - z_51*z_113 - q3_ddot*z_33 - q1_ddot*z_108 - z_141;
    const double z_143 = l*z_140;
    const double z_144 = l*z_138;
    const double z_145 = l*z_3;
    const double z_146 = z_145 + z_71*q1_ddot - l*q1_ddot;
    const double z_147 = z_144 - z_146;
    const double z_148 = 5.0*z_143 + 6.0*z_147 - z_142;
    const double z_149 = 5.0*z_144 + z_143 - 6.0*z_146;
    const double z_150 = z_144 - 5.0*z_146;
    const double z_151 = cos_q5*z_20;
    const double z_152 = z_40*sin_q5 + z_151;
    const double z_153 = l*z_152 - z_128;
    const double z_154 = 3.0*z_143 + 3.0*z_147 - 2.0*z_142;
    D[0] = ((-1.0/6.0))*(z_0*z_3 + z_62*z_74 + z_60*z_75 + z_7*z_76 + z_81*z_82 + l*z_146 - z_6*z_27 - z_30*z_45 -
        z_55*z_56 - q1_ddot*z_84 - 4.0*q1_ddot*z_0 - z_28*z_104 - z_106*z_121 - z_125*z_126 - z_129*z_148 -
        z_127*z_149 - z_83*z_150 - z_153*z_154);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double lambda_2 = lambda[2];
    const double sin_q1 = em_sin(q1);
    const double lambda_0 = lambda[0];
    const double z_157 = cos_q1*lambda_2 + sin_q1*lambda_0;
    const double z_158 = sin_q1*lambda_2;
    const double z_159 = cos_q1*lambda_0;
    const double z_160 = z_158 - z_159;
    const double z_161 = z_157*z_17 + cos_q3*z_160;
    const double z_162 = z_38*z_157 - sin_q4*z_161;
    const double m = c[0];
    const double z_163 = l*m;
    const double z_164 = z_163*q1_ddot;
    const double z_165 = m*z_45 + m*z_56;
    const double z_166 = m*z_121 + m*z_126;
    const double z_167 = m*z_74 + m*z_82;
    const double z_168 = m*z_75 + z_167;
    const double z_169 = z_163*z_2;
    const double z_170 = m*z_60;
    const double z_171 = m*z_81;
    const double z_172 = m*z_62;
    const double z_173 = z_171 + 2.0*z_172;
    const double z_174 = q1_dot*(5.0*z_169 + 6.0*z_170 + 3.0*z_173);
    const double z_175 = m*z_83;
    const double z_176 = m*z_127;
    const double z_177 = m*z_153;
    const double z_178 = m*z_129;
    const double z_179 = z_177 + 2.0*z_178;
    const double z_180 = z_163 + 5.0*z_175 + 6.0*z_176 + 3.0*z_179;
    const double z_181 = z_180*q1_ddot;
    const double z_182 = m*z_55;
    const double z_183 = m*z_30;
    const double z_184 = 2.0*z_182 + z_183;
    const double z_185 = m*z_125;
    const double z_186 = m*z_106;
    const double z_187 = 2.0*z_185 + z_186;
    const double z_188 = z_187*q1_ddot;
    const double z_189 = 2.0*z_171 + z_172;
    const double z_190 = z_189*z_51;
    const double z_191 = 2.0*z_177 + z_178;
    const double z_192 = sin_q5*z_191;
    const double z_193 = z_191*z_52;
    const double z_194 = z_48*z_34;
    const double z_195 = z_151*z_187;
    const double z_196 = cos_q3*z_48;
    const double z_197 = z_187*z_2;
    const double z_198 = z_122*z_191;
    const double z_199 = z_48*z_63;
    const double z_200 = z_40*z_184;
    const double z_201 = sin_q5*z_187;
    const double z_202 = z_187*z_52;
    const double z_203 = cos_q5*z_5;
    const double z_204 = z_163*z_5;
    const double z_205 = z_182 + 2.0*z_183;
    const double z_206 = 2.0*z_204 + z_205;
    const double z_207 = z_163*cos_q3;
    const double z_208 = z_185 + 2.0*z_186;
    const double z_209 = 2.0*z_207 + z_208;
    const double z_210 = sin_q2*z_85;
    const double z_211 = z_48*z_64;
    const double z_212 = q1_dot*cos_q5;
    const double z_213 = z_34*z_212;
    const double z_214 = q1_dot*z_46;
    const double z_215 = z_2*z_214;
    const double z_216 = z_48*z_42;
    const double z_217 = q3_dot*z_214;
    const double z_218 = z_169 + 5.0*z_170 + 3.0*z_173;
    const double z_219 = sin_q5*z_189;
    const double z_220 = 3.0*z_171 + z_170 + 5.0*z_172;
    const double z_221 = sin_q5*z_184;
    const double z_222 = 3.0*z_182 + 5.0*z_183 + z_204;
    const double z_223 = 5.0*z_204 + 3.0*z_205;
    const double z_224 = m*z_5;
    const double z_225 = m*z_54;
    const double z_226 = m*z_80;
    const double z_227 = cos_q5*q5_ddot;
    const double z_228 = cos_q5*z_17;
    const double z_229 = z_191*z_46;
    const double z_230 = cos_q2*z_46;
    const double z_231 = z_175 + 5.0*z_176 + 3.0*z_179;
    const double z_232 = 3.0*z_177 + z_176 + 5.0*z_178;
    const double z_233 = z_186 + (1.0/5.0)*z_207;
    const double z_234 = 3.0*z_185 + 5.0*z_233;
    const double z_235 = 5.0*z_207 + 3.0*z_208;
    const double z_236 = m*cos_q3;
    const double z_237 = m*z_124;
    const double z_238 = m*z_148 + m*z_154;
    const double z_239 = m*z_149 + z_238;
    const double z_240 = z_239 - 6.0*(z_157 - (1.0/6.0)*(z_164 + m*z_150));
    const double z_241 = m*z_152;
    D[1] = ((-1.0/6.0))*(6.0*z_161 + z_168*z_2 + z_174 + z_122*z_188 + z_52*z_190 + z_107*z_51*z_192 + z_131*z_193
        + z_107*z_195 + 2.0*z_196*z_197 + z_107*z_198 + 2.0*z_191*z_199 + z_52*z_200 + z_40*z_107*z_201 +
        z_58*z_202 + z_98*z_195 + 2.0*z_203*z_197 + z_47*z_189 + z_98*z_198 + z_77*z_184 + z_85*z_195 +
        cos_q5*z_189*z_64 + z_191*z_211 + z_191*z_213 + z_187*z_217 + z_218*z_66 + 2.0*z_163*z_3 + z_67*z_219 +
        z_180*z_3 + z_24*z_202 + z_222*z_24 + z_223*z_23 + z_50*z_165 + m*z_76*z_2 + z_82*z_226 + 6.0*z_151*z_157
        + 6.0*sin_q5*z_162 + q5_ddot*z_20*z_201 + sin_q3*q5_ddot*z_192 + z_187*q3_ddot*z_228 + 3.0*z_209*z_115 +
        z_140*z_192 + sin_q2*z_181 + z_101*z_201 + z_235*z_100 + z_126*z_237 + z_40*z_238 + m*z_146 - 6.0*z_162 -
        8.0*z_164 - z_5*z_165 - cos_q3*z_166 - z_181 - cos_q5*z_184*z_42 - z_50*z_193 - z_79*z_184 -
        2.0*z_187*z_194 - z_49*z_189 - z_78*z_184 - 3.0*z_206*z_2 - 3.0*z_209*z_210 - z_191*z_215 - z_187*z_216 -
        z_67*z_193 - z_220*z_67 - sin_q2*z_174 - z_24*z_221 - z_27*z_224 - z_165*z_131 - z_56*z_225 - z_21*z_168 -
        z_22*z_168 - z_58*z_167 - 6.0*z_122*z_160 - z_191*z_51*z_227 - z_40*z_187*z_227 - q3_ddot*z_229 -
        z_187*q2_ddot*z_230 - z_151*z_191*q1_ddot - z_231*z_138 - z_175*q1_ddot - z_232*z_140 - z_234*z_101 -
        z_104*z_236 - z_166*z_51 - z_239*z_17 - sin_q2*(-z_240) - z_154*z_241 - z_240);
    const double z_242 = l*z_9;
    const double z_243 = l*z_63;
    const double z_244 = z_57*z_41;
    const double z_245 = q3_dot*z_51;
    const double z_246 = z_88 + z_245 + z_13;
    const double z_247 = z_111 + z_109 + z_244 + z_36*z_246;
    const double z_248 = l*z_246;
    const double z_249 = 6.0*z_243 + 5.0*z_248 - z_247;
    const double z_250 = cos_q4*z_41;
    const double z_251 = z_242 - (z_36*z_9 - z_250);
    const double z_252 = 3.0*z_243 + 3.0*z_248 - 2.0*z_247;
    const double z_253 = z_243 + (l*z_245 + z_59*z_16);
    const double z_254 = sin_q4*z_36;
    const double z_255 = q2_dot*sin_q3;
    const double z_256 = q4_dot + z_255;
    const double z_257 = z_250 + q2_dot*z_33 - z_254*z_256;
    const double z_258 = z_29*z_256;
    const double z_259 = q2_dot*z_59;
    const double z_260 = q2_dot*l;
    const double z_261 = z_259 - z_260;
    const double z_262 = z_257 + 5.0*z_258 + 6.0*z_261;
    const double z_263 = 5.0*z_259 + z_258 - 6.0*z_260;
    const double z_264 = z_52*z_57;
    const double z_265 = (z_203 + z_196) + (z_264 + sin_q5*z_245 + sin_q5*z_88);
    const double z_266 = z_253 - l*z_265;
    const double z_267 = 2.0*z_257 + 3.0*z_258 + 3.0*z_261;
    const double z_268 = q1_dot*z_86;
    const double z_269 = q1_dot*z_57;
    const double z_270 = q1_dot*z_95 + cos_q2*z_269;
    const double z_271 = l*z_270;
    const double z_272 = z_86*z_42;
    const double z_273 = 6.0*z_268 - z_271 - 5.0*z_272;
    const double z_274 = q1_dot*z_33;
    const double z_275 = cos_q2*z_274 - z_36*z_270;
    const double z_276 = z_268 - z_272;
    const double z_277 = 6.0*z_276 - z_275 - 5.0*z_271;
    const double z_278 = 3.0*z_276 - 2.0*z_275 - 3.0*z_271;
    const double z_279 = cos_q2*z_57;
    const double z_280 = z_95 + z_279;
    const double z_281 = q1_dot*z_41;
    const double z_282 = q1_dot*q1_dot;
    const double z_283 = 2.0*z_97 + z_282*z_17;
    const double z_284 = 2.0*q1_dot*z_50 + z_38*z_282 - sin_q4*z_283;
    const double z_285 = 2.0*z_51*z_281 + z_282*z_108 + z_36*z_284 - 2.0*z_118;
    const double z_286 = l*z_284;
    const double z_287 = l*z_283;
    const double z_288 = z_71*z_282 - l*z_282;
    const double z_289 = z_287 - z_288;
    const double z_290 = 2.0*z_285 + 3.0*z_289 - 3.0*z_286;
    const double z_291 = z_280*z_290;
    const double z_292 = z_86 - cos_q2*z_59;
    const double z_293 = z_292 - l*z_280;
    const double z_294 = z_287 - 5.0*z_288;
    const double z_295 = 5.0*z_287 - z_286 - 6.0*z_288;
    const double z_296 = z_285 + 6.0*z_289 - 5.0*z_286;
    const double z_297 = cos_q2*z_282;
    const double g = c[2];
    const double z_298 = 7.0*sin_q2 + 3.0*z_40;
    const double z_299 = l*g;
    const double z_300 = l*cos_q4;
    const double z_301 = z_59*z_98 - z_28*q3_ddot;
    const double z_302 = z_107*z_57;
    const double z_303 = cos_q3*z_36;
    const double z_304 = z_16*z_63;
    const double z_305 = cos_q4*sin_q3;
    const double z_306 = cos_q4*q2_ddot;
    const double z_307 = 2.0*z_304 + q4_ddot*z_305 + q3_ddot*z_51 + z_306 - z_89*z_57 - z_98*z_57 - z_91;
    const double z_308 = z_36*z_302 + 2.0*z_5*z_37 - z_88*z_41 - z_245*z_41 - z_107*z_33 - z_98*z_33 - z_246*z_41
        - z_57*z_113 - q5_ddot*z_303 - q3_ddot*z_116 - z_36*z_307;
    const double z_309 = l*z_307;
    const double z_310 = 6.0*z_301 - z_308 - 5.0*z_309;
    const double z_311 = cos_q4*z_36;
    const double z_312 = z_300 - z_311;
    const double z_313 = 3.0*z_301 - 2.0*z_308 - 3.0*z_309;
    const double z_314 = l*z_57;
    const double z_315 = l - z_59;
    const double z_316 = z_314 - z_315;
    const double z_317 = -z_316;
    const double z_318 = sin_q4*z_256;
    const double z_319 = q2_dot*z_63;
    const double z_320 = z_319 + sin_q3*q2_ddot;
    const double z_321 = z_256*z_16 + sin_q4*(q4_ddot + z_320);
    const double z_322 = q2_dot*z_109 + q2_dot*z_111;
    const double z_323 = z_311*z_107 + z_9*z_41 + z_41*z_318 + z_36*z_321 + z_322 - cos_q4*z_113 - q2_ddot*z_33;
    const double z_324 = l*z_321;
    const double z_325 = l*q2_ddot;
    const double z_326 = l*z_320;
    const double z_327 = z_325 - z_326;
    const double z_328 = z_323 + 6.0*z_327 - 5.0*z_324;
    const double z_329 = 6.0*z_325 - z_324 - 5.0*z_326;
    const double z_330 = z_46 - sin_q5*z_57;
    const double z_331 = -l*z_330 - z_316;
    const double z_332 = 2.0*z_323 + 3.0*z_327 - 3.0*z_324;
    const double z_333 = z_86*q1_ddot;
    const double z_334 = cos_q2*q1_ddot;
    const double z_335 = z_95*q1_ddot + z_57*z_334;
    const double z_336 = l*z_335;
    const double z_337 = z_59*z_334;
    const double z_338 = 6.0*z_333 - z_336 - 5.0*z_337;
    const double z_339 = z_270*z_41 + z_36*z_335 - z_280*z_281 - z_33*z_334;
    const double z_340 = z_333 - z_337;
    const double z_341 = z_339 + 6.0*z_340 - 5.0*z_336;
    const double z_342 = 2.0*z_339 + 3.0*z_340 - 3.0*z_336;
    const double z_343 = z_95*z_282 + z_57*z_297;
    const double z_344 = z_33*z_297 - z_36*z_343;
    const double z_345 = l*z_343;
    const double z_346 = l*z_297;
    const double z_347 = z_59*z_297;
    const double z_348 = z_346 - z_347;
    const double z_349 = 6.0*z_348 - z_344 - 5.0*z_345;
    const double z_350 = 6.0*z_346 - 5.0*z_347 - z_345;
    const double z_351 = 5.0*z_346 - z_347;
    const double z_352 = 3.0*z_348 - 2.0*z_344 - 3.0*z_345;
    const double z_353 = z_346 + 10.0*z_325 - 2.0*z_326;
    D[4] = ((-1.0/12.0))*(2.0*z_242*z_249 + 2.0*z_251*z_252 + cos_q2*z_290*z_33 + 6.0*z_298*z_299 +
        2.0*z_300*z_310 + 2.0*z_312*z_313 + 2.0*z_28*z_338 + 2.0*z_106*z_341 + 2.0*z_125*z_342 - 2.0*z_253*z_262 -
        2.0*z_243*z_263 - 2.0*z_266*z_267 - 2.0*z_6*z_273 - 2.0*z_30*z_277 - 2.0*z_55*z_278 - z_36*z_291 -
        z_290*z_293 - z_86*z_294 - z_295*z_292 - z_296*z_293 - z_0*z_297 - 6.0*g*z_110 - 6.0*g*z_108 -
        30.0*z_17*z_299 - 2.0*z_317*z_328 - 2.0*z_315*z_329 - 2.0*z_331*z_332 - z_129*z_349 - z_127*z_350 -
        z_83*z_351 - z_153*z_352 - l*z_353);
    const double z_354 = z_158*z_99 - z_159*z_99;
    const double lambda_1 = lambda[1];
    const double z_355 = z_95*z_158 + z_38*lambda_1 + sin_q4*z_354 - z_39*lambda_1 - z_95*z_159;
    const double z_356 = m*z_349 + m*z_352;
    const double z_357 = m*z_350 + z_356;
    const double z_358 = m*z_351 + z_357;
    const double z_359 = m*z_262 + m*z_267;
    const double z_360 = m*z_277 + m*z_278;
    const double z_361 = m*z_341 + m*z_342;
    const double z_362 = z_163*cos_q2;
    const double z_363 = m*z_292;
    const double z_364 = m*z_293;
    const double z_365 = m*z_36;
    const double z_366 = m*z_32;
    const double z_367 = cos_q2*cos_q3;
    const double z_368 = z_364 + z_280*z_365 - z_366*z_367;
    const double z_369 = z_364 + 0.5*z_368;
    const double z_370 = 5.0*z_362 + 6.0*z_363 + 6.0*z_369;
    const double z_371 = m*z_251;
    const double z_372 = z_163*z_9;
    const double z_373 = 2.0*z_371 + z_372;
    const double z_374 = m*z_312;
    const double z_375 = z_163*cos_q4;
    const double z_376 = 2.0*z_374 + z_375;
    const double z_377 = sin_q5*z_376;
    const double z_378 = z_376*z_52;
    const double z_379 = z_5*z_48;
    const double z_380 = z_46*z_376;
    const double z_381 = m*z_266;
    const double z_382 = m*z_253;
    const double z_383 = 2.0*z_381 + z_382;
    const double z_384 = cos_q4*z_52;
    const double z_385 = m*z_331;
    const double z_386 = m*z_317;
    const double z_387 = 2.0*z_385 + z_386;
    const double z_388 = sin_q5*z_387;
    const double z_389 = z_371 + 2.0*z_372;
    const double z_390 = z_374 + 2.0*z_375;
    const double z_391 = sin_q3*z_98;
    const double z_392 = q2_dot*z_383;
    const double z_393 = q2_dot*z_387;
    const double z_394 = sin_q5*z_373;
    const double z_395 = 3.0*z_371 + 5.0*z_372;
    const double z_396 = m*z_9;
    const double z_397 = m*cos_q4;
    const double z_398 = z_52*z_397;
    const double z_399 = m*sin_q5;
    const double z_400 = z_9*z_399;
    const double z_401 = z_163*z_63;
    const double z_402 = z_381 + 2.0*z_382;
    const double z_403 = sin_q4*z_52;
    const double z_404 = 3.0*z_381 + z_401 + 5.0*z_382;
    const double z_405 = m*z_265;
    const double z_406 = m*z_290;
    const double z_407 = m*z_296 + z_406;
    const double z_408 = m*z_295 + z_407;
    const double z_409 = sin_q2*z_282;
    const double z_410 = z_364 + 2.0*z_368;
    const double z_411 = sin_q5*z_284;
    const double z_412 = z_151*z_282;
    const double z_413 = q1_dot*z_52;
    const double z_414 = z_187*z_413;
    const double z_415 = z_51*z_413;
    const double z_416 = m*g;
    const double z_417 = cos_q3*z_377;
    const double z_418 = z_122*z_376;
    const double z_419 = cos_q3*z_390;
    const double z_420 = 3.0*z_374 + 5.0*z_375;
    const double z_421 = cos_q4*z_399;
    const double z_422 = m*z_315;
    const double z_423 = z_385 + 2.0*z_386;
    const double z_424 = 3.0*z_385 + z_422 + 5.0*z_386;
    const double z_425 = z_163 + 5.0*z_422 + 3.0*z_423;
    const double z_426 = m*z_328 + m*z_332;
    const double z_427 = z_426 - 6.0*(sin_q2*lambda_1 - (1.0/6.0)*m*z_329);
    const double z_428 = m*z_330;
    D[5] = ((-1.0/12.0))*(12.0*z_354 + 12.0*z_355 + 2.0*cos_q3*z_361 + 2.0*z_88*z_378 + 2.0*z_245*z_378 +
        2.0*z_107*z_380 + 2.0*z_98*z_380 + 6.0*z_389*z_63 + 6.0*z_390*z_391 + 2.0*z_246*z_378 + 2.0*z_395*z_246 +
        2.0*z_249*z_396 + 2.0*z_252*z_398 + 2.0*z_252*z_396 + 6.0*q2_dot*(2.0*z_401 + z_402) +
        2.0*z_383*z_256*z_53 + 2.0*z_267*z_405 + 2.0*cos_q2*z_184*z_214 + 2.0*z_270*z_202 + 2.0*z_222*z_270 +
        2.0*cos_q2*z_223*z_42 + 2.0*z_50*z_360 + z_406*z_230 + z_280*z_407 + z_408*z_99 + z_370*z_409 +
        z_284*(z_363 + 5.0*z_364 + 3.0*z_368) + z_297*z_229 + 2.0*z_410*z_216 + 6.0*z_298*z_416 + 12.0*z_158*z_230
        + 12.0*cos_q2*z_159 + 2.0*z_376*z_57*z_227 + 2.0*q5_ddot*z_417 + 2.0*cos_q4*z_387*z_227 +
        2.0*q3_ddot*z_418 + 2.0*z_46*z_387*q2_ddot + 2.0*z_307*z_377 + 2.0*z_310*z_397 + 2.0*z_313*z_397 +
        2.0*z_424*z_321 + 2.0*z_425*z_320 + 2.0*z_426*z_57 + 2.0*z_332*z_428 + 6.0*z_209*z_334 +
        sin_q3*z_231*z_297 + z_232*z_343 + 2.0*z_335*z_201 + 2.0*z_338*z_236 + 2.0*z_361*z_51 + sin_q2*z_358 +
        z_40*z_356 - z_358 - 2.0*z_359*z_63 - 2.0*z_5*z_360 - z_370*z_282 - 2.0*z_264*z_373 - 2.0*z_377*z_302 -
        2.0*z_196*z_373 - 4.0*z_376*z_379 - 2.0*z_383*z_384 - 2.0*cos_q4*z_107*z_388 - 2.0*z_387*z_52*z_9 -
        2.0*z_203*z_373 - 2.0*z_46*z_392 - 2.0*z_196*z_393 - 2.0*z_203*z_393 - 2.0*z_246*z_394 - 2.0*z_252*z_400 -
        2.0*z_387*z_256*z_403 - 2.0*z_404*z_318 - 2.0*(5.0*z_401 + 3.0*z_402)*z_255 - 2.0*m*z_263*z_63 -
        2.0*z_88*z_359 - 2.0*z_245*z_359 - 6.0*q1_dot*cos_q2*z_206 - 2.0*z_270*z_221 - 2.0*z_273*z_224 -
        2.0*z_360*z_131 - 2.0*z_278*z_225 - z_399*z_291 - cos_q2*((z_163*z_282 + m*z_294) + z_408) - z_180*z_297 -
        z_410*z_411 - z_163*z_297 - z_283*(z_362 + 5.0*z_363 + 6.0*z_369) - z_410*z_412 - 2.0*z_410*z_217 -
        2.0*z_280*z_414 - 2.0*z_410*z_415 - 6.0*z_40*g*z_399 - 6.0*z_151*z_416 - 30.0*z_17*z_416 -
        12.0*cos_q2*z_158 - 12.0*z_151*lambda_1 - 12.0*z_159*z_230 - 12.0*sin_q5*z_355 - 6.0*q3_ddot*z_419 -
        2.0*z_420*z_307 - 2.0*z_313*z_421 - 2.0*(5.0*z_163 + 6.0*z_422 + 3.0*z_423)*q2_ddot - 2.0*z_321*z_388 -
        2.0*sin_q3*(-z_427) - 2.0*z_230*z_188 - z_343*z_192 - 2.0*z_234*z_335 - 2.0*z_235*q1_ddot*z_99 -
        2.0*z_342*z_237 - z_357*z_17 - z_352*z_241 - m*z_353 - 2.0*z_427);
    D[6] = 0.5*(z_40*z_365 + z_20*z_366 + 5.0*z_163*z_17 - z_163*z_298);
    const double z_429 = cos_q5*z_0;
    const double z_430 = q5_dot*z_16;
    const double z_431 = cos_q5*cos_q5;
    const double z_432 = z_0*z_431;
    const double z_433 = sin_q5*sin_q5;
    const double z_434 = z_0*z_433;
    const double z_435 = z_0*z_48;
    const double z_436 = sin_q5*z_0;
    const double z_437 = q3_dot*z_52;
    const double z_438 = l*z_16;
    const double z_439 = q3_dot*z_29;
    const double z_440 = q3_dot*l;
    const double z_441 = q3_dot*sin_q4;
    const double z_442 = q5_dot + z_441;
    const double z_443 = z_36*z_442;
    const double z_444 = 5.0*z_439 + 6.0*z_440 - z_443;
    const double z_445 = z_438 - (sin_q4*z_41 + z_36*z_16);
    const double z_446 = 3.0*z_439 + 3.0*z_440 - 2.0*z_443;
    const double z_447 = q2_dot*z_28;
    const double z_448 = q2_dot*z_116 + q2_dot*z_130;
    const double z_449 = q2_dot*z_105;
    const double z_450 = 6.0*z_447 + 5.0*z_449 - z_448;
    const double z_451 = 3.0*z_447 + 3.0*z_449 - 2.0*z_448;
    const double z_452 = z_29*z_64;
    const double z_453 = l*z_64;
    const double z_454 = z_452 + 5.0*z_453;
    const double z_455 = z_17*z_117 + z_254*z_64;
    const double z_456 = z_455 - 5.0*z_452 - 6.0*z_453;
    const double z_457 = 2.0*z_455 - 3.0*z_452 - 3.0*z_453;
    const double z_458 = l*z_42;
    const double z_459 = z_274 - z_36*z_269;
    const double z_460 = l*z_269;
    const double z_461 = 6.0*z_458 + z_459 + 5.0*z_460;
    const double z_462 = 5.0*z_458 + z_460;
    const double z_463 = 3.0*z_458 + 2.0*z_459 + 3.0*z_460;
    const double z_464 = z_290*z_20;
    const double z_465 = l*z_20;
    const double z_466 = z_465 + z_29*z_20;
    const double z_467 = cos_q3*z_282 + 2.0*z_137;
    const double z_468 = 2.0*z_65*z_16 + sin_q4*z_467 + 2.0*z_139;
    const double z_469 = z_282*z_116 + z_36*z_468 - 2.0*z_40*z_281 - 2.0*z_141;
    const double z_470 = l*z_468;
    const double z_471 = l*z_467;
    const double z_472 = z_145 - 0.5*z_471;
    const double z_473 = 2.0*z_469 + 6.0*z_472 - 3.0*z_470;
    const double z_474 = z_36*z_473;
    const double z_475 = z_59 + z_314;
    const double z_476 = z_469 + 12.0*z_472 - 5.0*z_470;
    const double z_477 = 12.0*z_145 - z_470 - 5.0*z_471;
    const double z_478 = sin_q3*z_85;
    const double z_479 = 2.0*q2_dot*q4_dot + z_478;
    const double z_480 = 2.0*z_13*z_41 + z_85*z_33 - z_254*z_479;
    const double z_481 = z_29*z_479;
    const double z_482 = l*z_85;
    const double z_483 = z_59*z_85;
    const double z_484 = z_482 - z_483;
    const double z_485 = 3.0*z_484 - 2.0*z_480 - 3.0*z_481;
    const double z_486 = 6.0*z_482 - z_481 - 5.0*z_483;
    const double z_487 = 6.0*z_484 - z_480 - 5.0*z_481;
    const double z_488 = cos_q2*g;
    const double z_489 = sin_q4*q5_ddot;
    const double z_490 = z_92 - z_90;
    const double z_491 = sin_q5*z_429;
    const double z_492 = l + z_29;
    const double z_493 = q3_dot*z_16;
    const double z_494 = sin_q4*q3_ddot;
    const double z_495 = z_493 + z_494;
    const double z_496 = q5_ddot + z_495;
    const double z_497 = z_442*z_41 + z_36*z_496;
    const double z_498 = l*z_495;
    const double z_499 = l*q3_ddot;
    const double z_500 = z_497 - 5.0*z_498 - 6.0*z_499;
    const double z_501 = z_492 - z_254;
    const double z_502 = 2.0*z_497 - 3.0*z_498 - 3.0*z_499;
    const double z_503 = z_28*q2_ddot;
    const double z_504 = q2_ddot*z_116 + q2_ddot*z_130;
    const double z_505 = z_105*q2_ddot;
    const double z_506 = 6.0*z_503 + 5.0*z_505 - z_504;
    const double z_507 = 3.0*z_503 + 3.0*z_505 - 2.0*z_504;
    const double z_508 = z_28*z_85;
    const double z_509 = z_85*z_116 + z_85*z_130;
    const double z_510 = z_105*z_85;
    const double z_511 = 6.0*z_508 + 5.0*z_510 - z_509;
    const double z_512 = 5.0*z_508 + z_510;
    const double z_513 = 3.0*z_508 + 3.0*z_510 - 2.0*z_509;
    const double z_514 = sin_q3*z_282;
    const double z_515 = q1_ddot*z_20;
    const double z_516 = z_514 + 2.0*z_515;
    const double z_517 = z_29*z_516;
    const double z_518 = l*z_516;
    const double z_519 = z_517 + 5.0*z_518;
    const double z_520 = z_282*z_33 - 2.0*q1_ddot*z_114 - z_254*z_516;
    const double z_521 = z_520 + 5.0*z_517 + 6.0*z_518;
    const double z_522 = 2.0*z_520 + 3.0*z_517 + 3.0*z_518;
    const double z_523 = z_282*z_20;
    const double z_524 = sin_q3*q1_ddot;
    const double z_525 = z_523 - 2.0*z_524;
    const double z_526 = l*z_525;
    const double z_527 = z_282*z_114 + 2.0*q1_ddot*z_33 + z_254*z_525;
    const double z_528 = z_29*z_525;
    const double z_529 = 6.0*z_526 + 5.0*z_528 - z_527;
    const double z_530 = 5.0*z_526 + z_528;
    const double z_531 = 3.0*z_526 + 3.0*z_528 - 2.0*z_527;
    const double z_532 = z_508 + 2.0*z_498 + 10.0*z_499;
    D[8] = ((-1.0/12.0))*(8.0*z_107*z_53*z_429 + 4.0*z_430*z_434 + 8.0*z_436*z_437 + 2.0*z_242*z_450 +
        2.0*z_251*z_451 + 2.0*z_6*z_454 + 2.0*z_62*z_461 + 2.0*z_60*z_462 + 2.0*z_136*z_0 + 2.0*z_81*z_463 +
        z_290*z_466 + z_465*z_295 + z_296*z_466 + z_473*z_33 + z_473*z_475 + z_476*z_475 + z_59*z_477 +
        z_485*z_116 + z_485*z_130 + 18.0*z_105*z_488 + 30.0*z_28*z_488 + 6.0*z_490*z_429 + 2.0*z_492*z_500 +
        2.0*z_501*z_502 + z_129*z_529 + z_127*z_530 + z_525*z_84 + z_153*z_531 - 8.0*z_430*z_432 - 6.0*z_16*z_435
        - 2.0*z_438*z_444 - 2.0*z_445*z_446 - 2.0*z_30*z_456 - 2.0*z_55*z_457 - z_254*z_464 - z_290*z_114 -
        z_57*z_474 - z_106*z_485 - z_28*z_486 - z_106*z_487 - 6.0*z_488*z_130 - 6.0*z_116*z_488 - 4.0*z_432*z_489
        - 4.0*z_490*z_491 - 4.0*q3_ddot*z_432 - 2.0*z_300*z_506 - 2.0*z_312*z_507 - z_317*z_511 - z_315*z_512 -
        z_331*z_513 - z_28*z_519 - z_106*z_521 - z_125*z_522 - l*z_532);
    const double z_533 = sin_q3*cos_q1;
    const double z_534 = sin_q3*sin_q1;
    const double z_535 = z_158*z_20 + z_533*lambda_2 + z_534*lambda_0 - z_159*z_20;
    const double z_536 = cos_q2*z_51;
    const double z_537 = lambda_1*z_536 + sin_q4*z_535;
    const double z_538 = m*z_500 + m*z_502;
    const double z_539 = m*z_511 + m*z_513;
    const double z_540 = m*z_512 + z_539;
    const double z_541 = m*z_529 + m*z_531;
    const double z_542 = m*z_530 + z_541;
    const double z_543 = z_163*z_525 + z_542;
    const double z_544 = m*z_456 + m*z_457;
    const double z_545 = m*z_473;
    const double z_546 = m*z_476 + z_545;
    const double z_547 = m*z_521 + m*z_522;
    const double z_548 = m*z_461 + m*z_463;
    const double z_549 = m*z_462 + z_548;
    const double z_550 = z_163*z_20;
    const double z_551 = m*z_466;
    const double z_552 = sin_q4*z_20;
    const double z_553 = z_551 - z_365*z_552 - z_17*z_366;
    const double z_554 = z_551 + 0.5*z_553;
    const double z_555 = 2.0*z_550 + 2.0*z_554;
    const double z_556 = lambda_1*z_367;
    const double z_557 = q2_dot*z_373;
    const double z_558 = sin_q4*z_399;
    const double z_559 = z_163*z_431;
    const double z_560 = z_163*z_433;
    const double z_561 = z_48*z_366;
    const double z_562 = m*z_445;
    const double z_563 = z_163*z_16;
    const double z_564 = sin_q5*(2.0*z_562 + z_563);
    const double z_565 = m*z_501;
    const double z_566 = m*z_492;
    const double z_567 = 2.0*z_565 + z_566;
    const double z_568 = m*z_446;
    const double z_569 = m*cos_q5;
    const double z_570 = z_473*z_399;
    const double z_571 = z_163*sin_q3;
    const double z_572 = m*z_475;
    const double z_573 = z_572 + cos_q3*z_366 - z_57*z_365;
    const double z_574 = z_572 + 0.5*z_573;
    const double z_575 = z_572 + 2.0*z_573;
    const double z_576 = sin_q5*z_468;
    const double z_577 = z_551 + 2.0*z_553;
    const double z_578 = z_122*z_282;
    const double z_579 = z_40*z_413;
    const double z_580 = m*z_122;
    const double z_581 = z_51*z_399;
    const double z_582 = m*z_487 + m*z_485;
    const double z_583 = z_186 - sin_q3*z_366 - z_51*z_365;
    const double z_584 = z_186 + 0.5*z_583;
    const double z_585 = sin_q4*z_479;
    const double z_586 = z_186 + 2.0*z_583;
    const double z_587 = z_479*z_53;
    const double z_588 = z_46*z_85;
    const double z_589 = z_13*z_52;
    const double z_590 = m*z_51;
    const double z_591 = z_46*cos_q1;
    const double z_592 = cos_q2*z_122;
    const double z_593 = z_46*sin_q1;
    const double z_594 = z_32*z_399;
    const double z_595 = sin_q5*z_567;
    const double z_596 = z_163 + 3.0*z_565 + 5.0*z_566;
    const double z_597 = q2_ddot*z_51;
    const double z_598 = z_85*z_51;
    const double z_599 = cos_q3*z_85;
    D[9] = ((-1.0/12.0))*(2.0*z_189*z_214 + 12.0*z_535 + 12.0*z_537 + 2.0*z_538 + z_543 + sin_q3*z_546 +
        2.0*z_549*z_2 + 3.0*z_555*z_282 + 12.0*z_556 + 2.0*q2_ddot*z_418 + 16.0*z_107*z_32*z_558 + 8.0*z_430*z_560
        + 16.0*q3_dot*z_561 + 2.0*z_442*z_564 + 2.0*z_567*z_442*z_52 + 2.0*z_446*z_16*z_399 +
        6.0*q2_dot*cos_q3*z_389 + 2.0*q2_dot*z_395*z_51 + 2.0*z_450*z_396 + 2.0*z_451*z_398 + 2.0*z_451*z_396 +
        2.0*z_218*z_42 + 2.0*z_220*z_269 + 2.0*sin_q4*z_222*z_64 + 2.0*z_223*z_64 + 2.0*z_454*z_224 +
        2.0*z_50*z_544 + 2.0*z_163*z_136 + 2.0*z_463*z_226 + z_407*z_552 + z_408*z_20 + z_46*z_545 + z_546*z_57 +
        m*sin_q3*z_477 + z_575*z_576 + z_577*z_411 + z_283*(5.0*z_550 + 6.0*z_554) + z_575*z_578 + z_577*z_412 +
        6.0*(2.0*z_571 + 2.0*z_574)*z_3 + 2.0*z_577*z_217 + 2.0*z_575*z_213 + 2.0*z_575*z_211 + 2.0*z_577*z_415 +
        z_485*z_580 + z_485*z_581 + z_478*(5.0*z_207 + 6.0*z_584) + (3.0*z_583 + 5.0*z_233)*z_585 + z_586*z_588 +
        z_122*z_387*z_85 + 2.0*z_586*z_589 + 18.0*z_488*z_590 + 30.0*z_488*z_236 + 2.0*z_403*z_568 +
        12.0*lambda_2*z_591 + 12.0*lambda_0*z_593 + 12.0*z_159*z_228 + 12.0*z_490*z_366 + 2.0*z_496*z_595 +
        2.0*sin_q4*z_538 + 2.0*z_377*z_597 + 2.0*z_507*z_421 + z_388*z_598 + z_539*z_57 + sin_q3*z_540 +
        z_513*z_428 + 2.0*z_228*z_188 + z_231*z_525 + sin_q4*z_232*z_525 + z_187*z_516*z_53 + z_522*z_237 +
        z_542*z_17 + z_531*z_241 - 2.0*q1_ddot*z_229 - z_540 - 2.0*z_5*z_544 - cos_q3*z_547 - 2.0*z_122*z_557 -
        16.0*z_559*z_430 - 12.0*z_365*z_430 - 2.0*(3.0*z_562 + 5.0*z_563)*z_441 - 6.0*q3_dot*(z_562 + 2.0*z_563) -
        2.0*m*z_444*z_16 - 2.0*z_16*z_568 - 2.0*z_123*z_557 - 2.0*z_451*z_400 - 2.0*z_184*z_17*z_212 -
        2.0*z_269*z_219 - 2.0*z_184*z_64*z_53 - 2.0*z_544*z_131 - 2.0*z_457*z_225 - 2.0*z_21*z_549 -
        2.0*z_22*z_549 - 2.0*z_58*z_548 - z_558*z_464 - z_290*z_17*z_569 - z_57*z_570 - z_467*(5.0*z_571 +
        6.0*z_574) - z_468*(5.0*z_572 + z_571 + 3.0*z_573) - 3.0*z_555*z_409 - z_284*(z_550 + 5.0*z_551 +
        3.0*z_553) - z_187*z_46*z_282 - z_191*z_282*z_228 - 2.0*z_575*z_215 - 2.0*z_575*z_579 - 2.0*z_577*z_216 -
        cos_q3*(m*z_486 + z_582) - z_582*z_51 - z_586*z_587 - 3.0*(2.0*z_207 + 2.0*z_584)*z_85 - 6.0*z_488*z_581 -
        6.0*z_488*z_580 - 12.0*z_158*z_228 - 12.0*lambda_1*z_592 - 12.0*sin_q5*z_537 - 8.0*z_559*z_489 -
        8.0*z_490*z_594 - 8.0*q3_ddot*z_559 - 2.0*z_596*z_495 - 2.0*(5.0*z_163 + 3.0*z_565 + 6.0*z_566)*q3_ddot -
        2.0*z_502*z_558 - 6.0*q2_ddot*z_419 - 2.0*z_420*z_597 - 2.0*z_506*z_397 - 2.0*z_507*z_397 - z_424*z_598 -
        z_425*z_599 - z_191*z_525*z_53 - sin_q4*z_234*z_516 - z_235*z_516 - z_519*z_236 - z_547*z_51 -
        sin_q2*z_543 - z_40*z_541 - m*z_532);
    D[10] = 0.5*(z_365*z_536 + z_366*z_99 - 3.0*z_163*z_536 - 5.0*z_163*z_367);
    const double z_600 = q4_dot*z_52;
    const double z_601 = q3_dot*cos_q4;
    const double z_602 = q5_dot*z_601;
    const double z_603 = z_13*z_132;
    const double z_604 = z_59*z_13;
    const double z_605 = z_603 - 5.0*z_604;
    const double z_606 = 2.0*z_603 - 3.0*z_604;
    const double z_607 = q2_dot*z_254;
    const double z_608 = q2_dot*z_29;
    const double z_609 = z_607 - 5.0*z_608;
    const double z_610 = q2_dot*z_245;
    const double z_611 = 2.0*z_607 - 3.0*z_608;
    const double z_612 = q1_dot*cos_q4;
    const double z_613 = q1_dot*z_93 + z_17*z_612;
    const double z_614 = z_36*z_613;
    const double z_615 = l*z_613;
    const double z_616 = z_614 - 5.0*z_615;
    const double z_617 = 2.0*z_614 - 3.0*z_615;
    const double z_618 = q1_dot*z_133;
    const double z_619 = z_36*z_618;
    const double z_620 = z_28*z_612;
    const double z_621 = z_619 - 5.0*z_620;
    const double z_622 = 2.0*z_619 - 3.0*z_620;
    const double z_623 = cos_q4*z_17;
    const double z_624 = z_93 + z_623;
    const double z_625 = z_290*z_624;
    const double z_626 = cos_q4*z_28;
    const double z_627 = cos_q4*z_59;
    const double z_628 = l*z_319;
    const double z_629 = 2.0*q2_dot*z_88 + 2.0*z_610 + cos_q4*z_85;
    const double z_630 = 2.0*q2_dot*z_244 + z_36*z_629 + 2.0*z_322;
    const double z_631 = l*z_629;
    const double z_632 = 6.0*z_628 + 3.0*z_631 - 2.0*z_630;
    const double z_633 = 12.0*z_628 + 5.0*z_631 - z_630;
    const double z_634 = sin_q4*z_98;
    const double z_635 = 2.0*q3_dot*q5_dot + z_634;
    const double z_636 = z_36*z_635;
    const double z_637 = z_29*z_98;
    const double z_638 = l*z_98;
    const double z_639 = 2.0*z_636 - 3.0*z_637 - 3.0*z_638;
    const double z_640 = z_636 - 5.0*z_637 - 6.0*z_638;
    const double z_641 = sin_q2*sin_q4;
    const double z_642 = z_38*sin_q3;
    const double z_643 = z_641 - z_642;
    const double z_644 = g*z_643;
    const double z_645 = l - z_36;
    const double z_646 = q4_dot*z_41;
    const double z_647 = z_646 + z_36*q4_ddot;
    const double z_648 = l*q4_ddot;
    const double z_649 = 2.0*z_647 - 3.0*z_648;
    const double z_650 = cos_q4*q3_ddot;
    const double z_651 = z_311*z_98;
    const double z_652 = z_300*z_98;
    const double z_653 = z_651 - 5.0*z_652;
    const double z_654 = 2.0*z_651 - 3.0*z_652;
    const double z_655 = sin_q4*z_85 + 2.0*q2_ddot*z_305;
    const double z_656 = z_36*z_655;
    const double z_657 = l*z_655;
    const double z_658 = z_656 - 5.0*z_657;
    const double z_659 = 2.0*z_656 - 3.0*z_657;
    const double z_660 = q2_dot*z_16;
    const double z_661 = 2.0*z_660 + 2.0*sin_q4*q2_ddot - cos_q4*z_479;
    const double z_662 = z_36*z_661;
    const double z_663 = l*z_661;
    const double z_664 = z_662 - 5.0*z_663;
    const double z_665 = 2.0*z_662 - 3.0*z_663;
    const double z_666 = 2.0*z_64*z_601 + 2.0*cos_q4*z_136 + 2.0*z_623*q1_ddot + 2.0*z_93*q1_ddot - cos_q4*z_467;
    const double z_667 = 2.0*z_613*z_41 + z_36*z_666 - 2.0*z_624*z_281;
    const double z_668 = l*z_666;
    const double z_669 = z_667 - 5.0*z_668;
    const double z_670 = 2.0*z_667 - 3.0*z_668;
    const double z_671 = 2.0*z_5*z_612 - z_93*z_282 - cos_q4*z_283 - 2.0*q1_ddot*z_133;
    const double z_672 = z_36*z_671;
    const double z_673 = l*z_671;
    const double z_674 = z_672 - 5.0*z_673;
    const double z_675 = 2.0*z_672 - 3.0*z_673;
    const double z_676 = 2.0*z_647 + z_652 - 10.0*z_648;
    D[12] = ((-1.0/12.0))*(6.0*z_0*z_600 + 4.0*z_602*z_434 + 2.0*z_253*z_609 + 2.0*z_266*z_611 + 2.0*z_5*z_613*z_0
        + 2.0*z_62*z_621 + 2.0*z_81*z_622 + l*z_625 + l*z_296*z_624 + z_133*z_474 + z_36*z_485*z_305 + z_254*z_632
        + z_311*z_639 + 6.0*z_36*z_644 + 2.0*z_645*z_649 + 6.0*z_429*z_650 + z_300*z_658 + z_312*z_659 +
        z_315*z_663 + z_106*z_669 + z_125*z_670 + z_129*z_674 + z_153*z_675 + l*z_676 - 6.0*z_601*z_435 -
        4.0*z_600*z_436 - 2.0*z_242*z_605 - 2.0*z_251*z_606 - 2.0*z_610*z_0 - 2.0*z_30*z_616 - 2.0*z_55*z_617 -
        2.0*z_60*z_620 - z_36*z_625 - z_473*z_626 - z_476*z_626 - z_485*z_627 - z_487*z_627 - z_29*z_632 -
        z_29*z_633 - z_300*z_639 - z_300*z_640 - 18.0*z_643*z_299 - 4.0*z_650*z_491 - z_492*z_653 - z_501*z_654 -
        z_317*z_664 - z_331*z_665 - cos_q3*z_666*z_0 - z_127*z_673);
    const double z_677 = cos_q3*cos_q1 - sin_q1*z_17;
    const double z_678 = cos_q3*sin_q1 + cos_q1*z_17;
    const double z_679 = 6.0*z_93*z_158 + 6.0*z_642*lambda_1 + m*z_649 - 6.0*cos_q4*z_677*lambda_2 -
        6.0*z_641*lambda_1 - 6.0*z_93*z_159 - 6.0*cos_q4*z_678*lambda_0;
    const double z_680 = m*z_653 + m*z_654;
    const double z_681 = m*z_609 + m*z_611;
    const double z_682 = m*z_616 + m*z_617;
    const double z_683 = m*z_669 + m*z_670;
    const double z_684 = m*z_621 + m*z_622;
    const double z_685 = z_684 - z_163*z_618;
    const double z_686 = z_163*z_305;
    const double z_687 = z_686 - z_365*z_305;
    const double z_688 = 2.0*z_686 + z_687;
    const double z_689 = m*z_674 + m*z_675;
    const double z_690 = z_163*z_671 - z_689;
    const double z_691 = -z_690;
    const double z_692 = z_163*z_624;
    const double z_693 = z_692 - z_624*z_365;
    const double z_694 = 2.0*z_692 + z_693;
    const double z_695 = m*z_645;
    const double z_696 = z_163 + 2.0*z_695;
    const double z_697 = sin_q3*z_13;
    const double z_698 = q2_dot*sin_q4;
    const double z_699 = z_163*z_133;
    const double z_700 = z_699 - z_365*z_133;
    const double z_701 = 2.0*z_699 + z_700;
    const double z_702 = z_699 + 2.0*z_700;
    const double z_703 = z_692 + 2.0*z_693;
    const double z_704 = z_686 + 2.0*z_687;
    const double z_705 = m*sin_q4;
    const double z_706 = z_163*sin_q4;
    const double z_707 = z_706 - sin_q4*z_365;
    const double z_708 = z_706 + 2.0*z_707;
    const double z_709 = q2_dot*z_708;
    const double z_710 = z_375 - cos_q4*z_365;
    const double z_711 = cos_q4*z_98;
    const double z_712 = m*z_664 + m*z_665;
    const double z_713 = z_163*z_661 - z_712;
    D[13] = ((-1.0/12.0))*(2.0*z_679 + 2.0*z_681*z_63 + cos_q3*z_683 + 2.0*z_685*z_2 + 3.0*z_694*z_282 +
        2.0*z_696*z_600 + 12.0*m*z_646 + 8.0*z_602*z_560 + 2.0*z_395*z_697 + 2.0*z_606*z_400 + 2.0*z_53*z_392 +
        2.0*z_88*z_681 + 2.0*z_245*z_681 + 2.0*z_618*z_219 + 2.0*z_613*z_202 + 2.0*z_222*z_613 + 2.0*z_204*z_613 +
        2.0*z_50*z_682 + 2.0*z_622*z_226 + z_407*z_624 + z_133*z_570 + 3.0*z_467*z_701 + z_468*(5.0*z_699 +
        3.0*z_700) + z_703*z_411 + 3.0*z_283*z_694 + z_703*z_412 + 2.0*z_702*z_215 + 2.0*z_703*z_217 +
        2.0*z_702*z_579 + 2.0*z_703*z_415 + sin_q3*z_485*z_421 + 3.0*z_478*z_688 + (5.0*z_686 + 3.0*z_687)*z_585 +
        z_632*z_558 + sin_q5*z_629*z_708 + z_704*z_588 + 2.0*z_203*z_709 + 2.0*z_704*z_589 + 2.0*z_196*z_709 +
        2.0*z_264*z_709 + z_639*z_421 + 3.0*(2.0*z_375 + z_710)*z_98 + z_634*(5.0*z_375 + 3.0*z_710) +
        6.0*z_399*z_644 + 2.0*sin_q5*z_696*q4_ddot + 12.0*z_366*z_650 + z_596*z_711 + z_654*z_558 + z_655*z_377 +
        z_658*z_397 + z_659*z_397 + z_424*z_661 + z_712*z_57 + sin_q3*(-z_713) + z_665*z_428 + z_671*z_192 +
        z_666*z_201 + z_683*z_51 + z_691*z_17 + z_675*z_241 + m*z_676 + z_713 - z_680 - 2.0*z_5*z_682 -
        3.0*z_688*z_85 - sin_q2*z_691 - 12.0*z_365*z_602 - 8.0*q4_dot*z_561 - 2.0*z_697*z_394 - 2.0*z_605*z_396 -
        2.0*z_606*z_398 - 2.0*z_606*z_396 - 2.0*z_404*z_698 - 2.0*z_163*z_610 - 2.0*z_611*z_405 - 2.0*z_220*z_618
        - 2.0*z_613*z_221 - 2.0*z_682*z_131 - 2.0*z_617*z_225 - 2.0*z_21*z_685 - 2.0*z_22*z_685 - 2.0*z_58*z_684 -
        z_399*z_625 - z_546*z_133 - z_702*z_576 - 3.0*z_694*z_409 - z_284*(5.0*z_692 + 3.0*z_693) - z_702*z_578 -
        6.0*z_701*z_3 - 2.0*z_702*z_213 - 2.0*z_624*z_414 - 2.0*z_703*z_216 - 2.0*z_702*z_211 - z_582*z_305 -
        z_704*z_587 - z_632*z_705 - z_633*z_705 - z_629*(5.0*z_706 + 3.0*z_707) - 6.0*z_319*(2.0*z_706 + z_707) -
        cos_q4*(m*z_640 + m*z_639) - sin_q5*z_635*(z_375 + 2.0*z_710) - 18.0*z_643*z_416 - 2.0*(5.0*z_163 +
        3.0*z_695)*q4_ddot - 2.0*sin_q5*z_679 - 8.0*q3_ddot*z_32*z_421 - z_595*z_711 - sin_q4*z_680 - z_420*z_655
        - z_659*z_421 - z_661*z_388 - z_232*z_671 - z_234*z_666 - z_207*z_666 - z_670*z_237 - z_40*z_689 - z_690);
    D[14] = (-0.5)*(z_643*z_365 - 3.0*z_163*z_643);
    const double z_714 = z_32*z_57;
    const double z_715 = q2_dot*z_303 + q2_dot*z_714;
    const double z_716 = z_13*z_32;
    const double z_717 = z_40*z_117 - z_36*z_64;
    const double z_718 = z_36*z_42 - z_51*z_117;
    const double z_719 = z_40*z_290;
    const double z_720 = z_473*z_51;
    const double z_721 = sin_q4*z_639;
    const double z_722 = 2.0*z_36*z_89 - 3.0*l*z_89;
    const double z_723 = z_280*g;
    const double z_724 = z_635*z_32;
    const double z_725 = 2.0*q3_dot*z_41 + 2.0*z_36*q3_ddot - z_724;
    const double z_726 = z_629*z_32;
    const double z_727 = 2.0*z_660*z_116 + 2.0*z_610*z_32 + 2.0*q2_ddot*z_714 + 2.0*q2_ddot*z_303 - z_726;
    const double z_728 = 2.0*z_91*z_32 - z_32*z_585 - z_85*z_303 - 2.0*z_306*z_32;
    const double z_729 = q1_ddot*z_32;
    const double z_730 = 2.0*z_58*z_117 + z_282*z_132 + 2.0*q1_ddot*z_112 - z_468*z_32 - 2.0*z_40*z_729;
    const double z_731 = 2.0*z_131*z_117 + z_284*z_32 + 2.0*q1_ddot*z_132 - 2.0*z_274*z_16 - z_282*z_112 -
        2.0*z_51*z_729;
    D[16] = (1.0/12.0)*(4.0*q5_ddot*z_0 + 2.0*z_242*z_715 + 4.0*z_251*z_715 + 2.0*z_253*z_716 + 4.0*z_266*z_716 +
        2.0*z_62*z_718 + 4.0*z_81*z_718 + z_290*z_112 + z_473*z_132 + cos_q4*z_632*z_32 + 4.0*z_98*z_491 +
        4.0*z_493*z_434 + 6.0*z_32*z_723 + 6.0*z_488*z_303 + 2.0*z_645*z_89*z_32 + 4.0*z_494*z_432 + z_317*z_728 +
        2.0*z_331*z_728 + z_89*z_429 - 8.0*z_493*z_436 - 4.0*q3_dot*z_36*z_445 - 2.0*z_30*z_717 - 4.0*z_55*z_717 -
        z_32*z_719 - z_32*z_720 - z_485*z_303 - z_485*z_714 - z_32*z_721 - z_722*z_32 - z_492*z_725 -
        2.0*z_501*z_725 - z_300*z_727 - 2.0*z_312*z_727 - z_106*z_730 - 2.0*z_125*z_730 - z_129*z_731 -
        2.0*z_153*z_731);
    const double z_732 = m*z_728;
    const double z_733 = m*z_731;
    const double z_734 = sin_q3*z_365 - z_51*z_366;
    const double z_735 = z_40*z_366 - z_20*z_365;
    const double z_736 = cos_q3*z_365 + z_57*z_366;
    const double z_737 = cos_q5*z_376;
    const double z_738 = cos_q5*z_387;
    const double z_739 = z_13*z_366;
    const double z_740 = m*z_717;
    const double z_741 = m*z_718;
    const double z_742 = cos_q5*z_191;
    const double z_743 = cos_q3*z_399;
    const double z_744 = z_13*z_559;
    const double z_745 = z_38*sin_q1;
    const double z_746 = sin_q4*z_677 + z_745;
    const double z_747 = z_533 + sin_q1*z_20;
    const double z_748 = z_38*cos_q1;
    const double z_749 = sin_q4*z_678 - z_748;
    const double z_750 = z_534 - cos_q1*z_20;
    D[17] = (1.0/12.0)*(6.0*z_89*z_366 + 3.0*z_732 + 3.0*z_284*z_735 + 3.0*z_736*z_585 + 8.0*z_163*q5_ddot +
        4.0*z_441*z_561 + 12.0*z_493*z_560 + 2.0*cos_q5*z_57*z_557 + 2.0*sin_q5*cos_q3*z_557 +
        2.0*cos_q5*z_13*z_383 + 2.0*z_91*z_738 + 6.0*z_715*z_396 + 4.0*z_715*z_398 +
        6.0*q4_dot*z_255*(cos_q4*cos_q4)*z_366 + 6.0*z_245*z_739 + 2.0*z_191*z_16*z_214 + 2.0*z_64*z_221 +
        2.0*z_42*z_219 + 6.0*z_50*z_740 + 4.0*z_80*z_741 + z_399*z_464 + sin_q3*z_570 + 2.0*z_734*z_576 +
        cos_q5*z_187*z_468 + 3.0*z_735*z_409 + 2.0*z_734*z_578 + z_523*z_192 + 6.0*z_734*z_3 + 4.0*z_734*z_213 +
        4.0*z_735*z_216 + 4.0*z_734*z_211 + 3.0*z_478*z_736 + cos_q5*z_632*z_397 + 3.0*cos_q4*z_629*z_366 +
        z_629*z_737 + 2.0*z_736*z_588 + 12.0*z_63*z_739 + 4.0*z_736*z_589 + 3.0*z_634*z_366 +
        3.0*z_98*(sin_q4*sin_q4)*z_366 + cos_q5*z_567*z_635 + 8.0*z_98*z_594 + cos_q5*z_696*z_89 + 6.0*z_569*z_723
        + 6.0*z_488*z_743 + 6.0*z_2*z_741 + 12.0*sin_q5*z_747*lambda_2 + 12.0*sin_q5*z_556 +
        12.0*cos_q5*z_280*lambda_1 + 12.0*sin_q5*z_750*lambda_0 + 8.0*z_494*z_559 + 2.0*z_725*z_558 +
        2.0*z_727*z_421 + 2.0*q1_ddot*z_51*z_742 + 2.0*z_40*cos_q5*z_188 + 2.0*z_730*z_237 + 3.0*sin_q2*z_733 +
        3.0*z_40*z_733 - 3.0*m*z_725 - 3.0*z_733 - 3.0*z_468*z_734 - 3.0*z_736*z_85 - 3.0*z_735*z_282 -
        2.0*q3_dot*z_564 - 2.0*z_567*z_437 - 18.0*z_493*z_365 - 2.0*z_660*z_418 - 2.0*z_610*z_737 -
        4.0*z_715*z_400 - 4.0*z_265*z_739 - 2.0*z_212*z_190 - 2.0*z_191*z_212*z_131 - 2.0*z_212*z_200 -
        2.0*z_187*z_58*z_212 - 6.0*z_131*z_740 - 4.0*z_717*z_225 - 6.0*z_717*z_224 - 6.0*z_21*z_741 -
        6.0*z_22*z_741 - 6.0*z_58*z_741 - z_569*z_719 - z_569*z_720 - 3.0*z_467*z_734 - 2.0*z_735*z_411 -
        z_284*z_742 - 3.0*z_283*z_735 - z_514*z_201 - 2.0*z_735*z_412 - 4.0*z_734*z_215 - 4.0*z_735*z_217 -
        4.0*z_734*z_579 - 4.0*z_735*z_415 - z_485*z_743 - z_485*z_57*z_569 - 2.0*z_736*z_587 - z_585*z_738 -
        2.0*z_726*z_421 - z_388*z_599 - 4.0*z_5*z_744 - 4.0*z_196*z_739 - 4.0*q5_dot*z_57*z_744 - z_569*z_721 -
        2.0*z_724*z_558 - z_722*z_569 - 4.0*z_89*z_594 - 12.0*cos_q5*z_746*lambda_2 - 12.0*cos_q5*z_749*lambda_0 -
        2.0*q3_ddot*z_595 - 3.0*z_725*z_705 - 2.0*q2_ddot*z_57*z_737 - 2.0*q2_ddot*z_417 - 2.0*z_306*z_738 -
        3.0*z_727*z_397 - 3.0*z_732*z_57 - 3.0*sin_q3*z_732 - 2.0*z_728*z_428 - 2.0*z_515*z_201 - 2.0*z_524*z_192
        - 3.0*z_730*z_590 - 3.0*z_730*z_236 - 3.0*z_733*z_17 - 2.0*z_731*z_241);
    D[18] = 0.5*(z_280*z_366 + z_365*z_367);
    const double z_751 = sin_q5*z_107;
    const double z_752 = z_678*z_16;
    const double z_753 = q1_dot*cos_q1;
    const double z_754 = cos_q3*z_753 - sin_q1*z_5;
    const double z_755 = q1_dot*sin_q1;
    const double z_756 = z_17*z_755 - (cos_q1*z_22 + cos_q1*z_21);
    const double z_757 = z_754 + (-z_756);
    const double z_758 = cos_q1*z_14;
    const double z_759 = cos_q1*z_10;
    const double z_760 = cos_q5*z_107;
    const double z_761 = cos_q1*z_2;
    const double z_762 = cos_q1*z_282 + sin_q1*q1_ddot;
    const double z_763 = sin_q1*z_2;
    const double z_764 = z_391 - cos_q3*q3_ddot;
    const double z_765 = sin_q2*cos_q1;
    const double z_766 = z_210 - z_115;
    const double z_767 = sin_q1*z_282 - cos_q1*q1_ddot;
    const double z_768 = 2.0*z_5*z_753 + 2.0*z_42*z_763 + 2.0*sin_q1*z_135 + z_764*z_765 + sin_q1*z_134 +
        z_533*z_766 + z_762*z_17 + cos_q3*z_767 - 2.0*z_63*z_761;
    const double z_769 = z_754 - z_756;
    const double z_770 = z_769*z_16 + z_757*z_16 + z_748*z_85 + z_748*z_89 + cos_q1*z_94 + z_678*z_92 +
        cos_q1*z_96 + z_38*z_762 - z_678*z_90 - 2.0*z_14*z_755 - 2.0*z_10*z_755 - 2.0*z_91*z_765 - sin_q4*z_768;
    const double z_771 = sin_q5*q5_ddot;
    const double z_772 = cos_q5*z_764;
    const double z_773 = cos_q5*z_134;
    D[21] = z_749*z_751 + z_750*z_760 + ((cos_q1*z_42 + sin_q1*z_63) + (sin_q1*z_64 + cos_q1*z_34 -
        cos_q3*z_761))*z_48 + 2.0*sin_q1*z_3 + z_770 + sin_q1*z_199 + 2.0*sin_q1*z_213 + cos_q1*z_194 +
        sin_q1*z_211 + cos_q1*z_216 + z_750*z_771 + sin_q1*z_772 + cos_q1*z_766 + z_122*z_767 + sin_q2*z_762 -
        ((z_752 + sin_q4*z_757) + (z_38*z_755 + z_758 + z_759))*z_52 - z_762 - z_768 - z_759*z_52 - z_752*z_52 -
        2.0*cos_q1*z_217 - 2.0*z_203*z_761 - z_758*z_52 - 2.0*z_214*z_763 - z_196*z_761 - z_745*z_413 -
        z_769*z_403 - z_749*z_227 - z_765*z_773 - z_766*z_591 - z_151*z_762 - sin_q5*z_770;
    const double z_774 = sin_q2*z_9;
    const double z_775 = cos_q2*z_245;
    const double z_776 = cos_q2*z_88;
    const double z_777 = cos_q2*z_85 + sin_q2*q2_ddot;
    const double z_778 = z_95*z_85 + 2.0*z_2*z_9 + z_95*z_89 + 2.0*z_21*z_698 + 2.0*z_660*z_17 + z_279*z_89 +
        z_641*q4_ddot + z_93*z_764 + z_777*z_57 - 2.0*cos_q2*z_304 - z_642*q4_ddot - z_38*q2_ddot;
    D[25] = -(z_280*z_751 + 2.0*q2_dot*z_78 + 2.0*q2_dot*z_79 + 2.0*cos_q2*z_379 + z_777 + z_774*z_52 +
        q2_dot*z_17*z_403 + sin_q5*z_778 - ((cos_q4*z_2 - z_774) + (z_775 + z_776 - z_17*z_698))*z_52 - z_98*z_230
        - z_107*z_230 - 2.0*q2_dot*z_21 - z_778 - z_776*z_52 - z_775*z_52 - z_2*z_384 - z_367*z_771 - z_280*z_227
        - q3_ddot*z_592 - cos_q2*z_764 - z_46*z_777 - sin_q3*z_777);
    const double z_779 = z_677*z_16;
    const double z_780 = (cos_q3*z_755 + cos_q1*z_5) + (sin_q1*z_21 + (z_17*z_753 + sin_q1*z_22));
    const double z_781 = z_780;
    const double z_782 = sin_q1*z_14;
    const double z_783 = sin_q1*z_10;
    const double z_784 = sin_q2*sin_q1;
    const double z_785 = 2.0*z_5*z_755 + z_764*z_784 + z_534*z_766 + z_767*z_17 - 2.0*z_42*z_761 -
        2.0*cos_q1*z_135 - 2.0*z_63*z_763 - cos_q1*z_134 - cos_q3*z_762;
    const double z_786 = z_780*z_16 + z_677*z_90 + z_781*z_16 + z_745*z_85 + 2.0*z_14*z_753 + z_745*z_89 +
        2.0*z_10*z_753 + sin_q1*z_94 + sin_q1*z_96 + z_38*z_767 - 2.0*z_91*z_784 - z_677*z_92 - sin_q4*z_785;
    D[29] = z_746*z_751 + z_747*z_760 + ((cos_q1*z_63 - sin_q1*z_42) + (cos_q1*z_64 + cos_q3*z_763 -
        sin_q1*z_34))*z_48 + 2.0*cos_q1*z_3 + z_767 + z_785 + z_783*z_52 + 2.0*sin_q1*z_217 + cos_q1*z_199 +
        2.0*cos_q1*z_213 + 2.0*z_203*z_763 + z_782*z_52 + z_196*z_763 + cos_q1*z_211 + z_780*z_403 + z_747*z_771 +
        cos_q1*z_772 + z_784*z_773 + z_766*z_593 + z_151*z_767 + z_122*z_762 + sin_q5*z_786 - ((z_779 -
        sin_q4*z_781) - (z_782 + z_783 - z_38*z_753))*z_52 - z_786 - z_779*z_52 - sin_q1*z_194 - 2.0*z_214*z_761 -
        z_748*z_413 - sin_q1*z_216 - z_746*z_227 - sin_q1*z_766 - sin_q2*z_767;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double l = c[1];
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    const double z_1 = l*sin_q1;
    const double q4 = x[3];
    const double sin_q4 = em_sin(q4);
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double cos_q1 = em_cos(q1);
    const double z_5 = cos_q3*cos_q1;
    const double sin_q3 = em_sin(q3);
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_8 = sin_q2*sin_q1;
    const double z_9 = z_5 - sin_q3*z_8;
    const double cos_q2 = em_cos(q2);
    const double cos_q4 = em_cos(q4);
    const double z_12 = cos_q2*cos_q4;
    const double z_13 = sin_q4*z_9 + z_12*sin_q1;
    const double q5 = x[4];
    const double sin_q5 = em_sin(q5);
    const double cos_q5 = em_cos(q5);
    const double z_16 = sin_q3*cos_q1;
    const double z_17 = cos_q3*z_8;
    const double z_18 = z_16 + z_17;
    const double z_19 = sin_q5*z_13 + cos_q5*z_18;
    D[0] = -(z_1 + l*z_19 - l*z_13 - l*z_9 - l*z_8);
    const double z_20 = l*cos_q2;
    const double z_21 = sin_q2*cos_q1;
    const double z_22 = cos_q2*sin_q4;
    const double z_23 = cos_q4*z_21 + z_16*z_22;
    const double z_24 = cos_q2*sin_q3;
    const double z_25 = cos_q1*z_24;
    const double z_26 = cos_q5*cos_q1;
    const double z_27 = cos_q2*cos_q3;
    D[1] = -(cos_q1*z_20 + l*(sin_q5*z_23 - z_26*z_27) - l*z_23 - l*z_25);
    const double z_28 = sin_q3*sin_q1;
    const double z_29 = cos_q3*z_21;
    const double z_30 = z_28 - z_29;
    const double z_31 = l*sin_q4;
    const double z_32 = sin_q4*sin_q5;
    const double z_33 = cos_q3*sin_q1;
    const double z_34 = z_33 + sin_q3*z_21;
    D[2] = -(l*z_30 + z_30*z_31 - l*(z_30*z_32 - cos_q5*z_34));
    const double z_35 = cos_q1*z_22;
    const double z_36 = cos_q4*z_34 + z_35;
    const double z_37 = l*sin_q5;
    D[3] = l*z_36 - z_37*z_36;
    const double z_38 = sin_q4*z_34 - z_12*cos_q1;
    const double z_39 = sin_q5*z_30 - cos_q5*z_38;
    D[4] = l*z_39;
    const double z_40 = sin_q5*z_38 + cos_q5*z_30;
    D[11] = cos_q1 + z_34 + z_38 - z_40 - z_21;
    const double z_41 = sin_q3*sin_q4;
    const double z_42 = sin_q2*z_41;
    const double z_43 = z_12 - z_42;
    const double z_44 = sin_q2*cos_q3;
    const double z_45 = cos_q5*z_44;
    const double z_46 = l*sin_q2;
    const double z_47 = sin_q2*sin_q3;
    D[15] = l*(z_43*sin_q5 + z_45) + l*z_47 - l*z_43 - z_46;
    const double z_48 = cos_q3*z_22;
    const double z_49 = cos_q5*z_24;
    D[16] = -(l*z_27 + l*z_48 - l*(z_49 + sin_q5*z_48));
    const double z_50 = sin_q2*sin_q4;
    const double z_51 = z_50 - cos_q4*z_24;
    D[17] = l*z_51 - z_37*z_51;
    const double z_52 = sin_q3*z_22;
    const double z_53 = cos_q4*sin_q2 + z_52;
    const double z_54 = sin_q5*z_27;
    const double z_55 = cos_q5*z_53 + z_54;
    D[18] = l*z_55;
    D[25] = cos_q2 + (sin_q5*z_53 - cos_q5*z_27) - z_53 - z_24;
    const double z_56 = l*cos_q1;
    D[28] = -(z_56 + l*z_38 + l*z_34 - l*z_40 - l*z_21);
    const double z_57 = cos_q4*z_8 + z_28*z_22;
    const double z_58 = sin_q1*z_24;
    const double z_59 = sin_q1*z_27;
    const double z_60 = sin_q5*z_57 - cos_q5*z_59;
    D[29] = sin_q1*z_20 + l*z_60 - l*z_57 - l*z_58;
    const double z_61 = cos_q5*z_9 - z_18*z_32;
    D[30] = -(l*z_18 + z_18*z_31 + l*z_61);
    const double z_62 = sin_q1*z_22;
    const double z_63 = cos_q4*z_9 - z_62;
    D[31] = l*z_63 - z_37*z_63;
    const double z_64 = sin_q5*z_18 - cos_q5*z_13;
    D[32] = l*z_64;
    D[39] = -(1.0 + sin_q1 + z_19 - z_9 - z_13 - z_8);
    D[42] = -z_39;
    D[43] = sin_q5*z_59 + cos_q5*z_57;
    const double z_65 = sin_q4*cos_q5;
    D[44] = sin_q5*z_9 + z_18*z_65;
    D[45] = -cos_q5*z_63;
    D[46] = z_19;
    const double q1_dot = v[0];
    const double z_66 = l - z_37;
    const double z_67 = sin_q4*z_66;
    const double z_68 = l + z_67;
    const double z_69 = l*cos_q5;
    const double z_70 = sin_q3*z_69;
    const double z_71 = cos_q3*z_68 - z_70;
    const double z_72 = cos_q4*z_66;
    const double z_73 = cos_q2*z_72;
    const double z_74 = l + z_68*z_47 + z_69*z_44 - z_46 - z_73;
    const double z_75 = z_71*sin_q1 + cos_q1*z_74;
    const double q2_dot = v[1];
    const double z_76 = z_1 - z_68*z_28 - z_33*z_69;
    const double z_77 = cos_q2*z_76 - z_8*z_72;
    const double q3_dot = v[2];
    const double z_78 = z_68*cos_q1;
    const double z_79 = z_78 - z_8*z_69;
    const double z_80 = cos_q1*z_69;
    const double z_81 = z_80 + z_68*z_8;
    const double z_82 = sin_q3*z_79 + cos_q3*z_81;
    const double q4_dot = v[3];
    const double z_83 = z_9*z_72 - z_66*z_62;
    const double q5_dot = v[4];
    const double z_84 = z_37*z_18 - z_13*z_69;
    D[56] = -(q1_dot*z_75 + q3_dot*z_82 - q2_dot*z_77 - q4_dot*z_83 - q5_dot*z_84);
    const double z_85 = sin_q2*z_72;
    const double z_86 = z_69*z_27;
    const double z_87 = z_20 - z_85 - z_86 - z_68*z_24;
    const double z_88 = cos_q1*z_73;
    const double z_89 = z_56 - z_68*z_16 - z_5*z_69;
    const double z_90 = z_67*z_21 - z_72*z_25;
    const double z_91 = z_37*cos_q1;
    D[57] = q1_dot*sin_q1*z_87 + q2_dot*(z_88 + sin_q2*z_89) - q3_dot*(z_69*z_25 - z_78*z_27) - q4_dot*z_90 -
        q5_dot*(z_91*z_27 + z_23*z_69);
    const double z_92 = cos_q3*z_69;
    const double z_93 = z_92 + sin_q3*z_68;
    const double z_94 = z_69*z_47;
    const double z_95 = z_94 - z_68*z_44;
    const double z_96 = q2_dot*cos_q2;
    const double z_97 = sin_q1*z_69 - z_68*z_21;
    const double z_98 = z_68*sin_q1 + z_21*z_69;
    const double z_99 = q4_dot*z_72;
    const double z_100 = sin_q4*z_69;
    D[58] = -(q1_dot*(cos_q1*z_93 - sin_q1*z_95) + (z_16*z_69 - z_68*z_5)*z_96 + z_30*z_99 - q3_dot*(sin_q3*z_97 -
        cos_q3*z_98) - q5_dot*(z_37*z_34 + z_30*z_100));
    const double z_101 = z_66*z_22;
    const double z_102 = z_101 + z_72*z_47;
    const double z_103 = q5_dot*z_69;
    D[59] = q1_dot*(z_5*z_72 - sin_q1*z_102) + q4_dot*(z_88 - z_67*z_34) - q2_dot*z_90 - q3_dot*(z_28*z_72 -
        z_29*z_72) - z_36*z_103;
    const double z_104 = cos_q3*z_100 - sin_q3*z_37;
    const double z_105 = z_37*z_44;
    const double z_106 = z_12*z_69;
    const double z_107 = z_105 + z_42*z_69 - z_106;
    const double z_108 = cos_q4*z_69;
    D[60] = -(q1_dot*(cos_q1*z_104 - sin_q1*z_107) + q2_dot*(z_21*z_108 + cos_q2*(z_37*z_5 + z_80*z_41)) +
        q4_dot*(z_35*z_69 + z_34*z_108) - q3_dot*(sin_q3*(z_37*z_21 + sin_q1*z_100) + cos_q3*(z_37*sin_q1 -
        z_21*z_100)) - q5_dot*(z_37*z_38 + z_30*z_69));
    const double z_109 = z_71*cos_q1 - z_74*sin_q1;
    D[61] = z_109;
    const double z_110 = cos_q2*z_89 - z_21*z_72;
    D[62] = -z_110;
    const double z_111 = sin_q3*z_98 + cos_q3*z_97;
    D[63] = -z_111;
    const double z_112 = z_34*z_72 + z_66*z_35;
    D[64] = z_112;
    const double z_113 = z_37*z_30 - z_38*z_69;
    D[65] = z_113;
    const double z_114 = sin_q3*cos_q5;
    const double z_115 = 1.0 - sin_q5;
    const double z_116 = 1.0 + sin_q4*z_115;
    const double z_117 = z_114 - cos_q3*z_116;
    const double z_118 = z_12*z_115;
    const double z_119 = 1.0 + z_45 + z_116*z_47 - sin_q2 - z_118;
    const double z_120 = cos_q4*z_115;
    D[67] = -(q1_dot*(cos_q1*z_117 + sin_q1*z_119) + q2_dot*(cos_q2*(cos_q1 - cos_q5*z_5 - z_16*z_116) -
        z_21*z_120) + q3_dot*(sin_q3*(cos_q5*z_21 + sin_q1*z_116) + cos_q3*(cos_q5*sin_q1 - z_21*z_116)) -
        q4_dot*(z_34*z_120 + z_35*z_115) - q5_dot*z_39);
    const double z_121 = l - l*sin_q3 - z_92 - z_66*z_41;
    const double z_122 = sin_q2*z_67;
    D[71] = q2_dot*(z_85 - cos_q2*z_121) + q4_dot*z_102 - q3_dot*(z_94 - cos_q3*(z_46 + z_122)) - q5_dot*(z_105 -
        z_43*z_69);
    const double z_123 = z_20 + z_101;
    const double z_124 = z_37*z_24 - z_69*z_48;
    D[72] = -(z_27*z_99 + q5_dot*z_124 - q2_dot*sin_q2*(l*cos_q3 + cos_q3*z_67 - z_70) - q3_dot*(z_86 +
        sin_q3*z_123));
    D[73] = -(q3_dot*z_72*z_27 + z_51*z_103 - q2_dot*z_102 - q4_dot*(z_85 + z_66*z_52));
    D[74] = q2_dot*(z_106 - sin_q2*(cos_q3*z_37 + z_69*z_41)) + q4_dot*(z_24*z_108 - sin_q2*z_100) + q5_dot*(z_86
        - z_37*z_53) - q3_dot*z_124;
    D[76] = -(z_73 + sin_q2*z_121);
    D[77] = -(cos_q3*z_123 - z_24*z_69);
    D[78] = z_122 - z_24*z_72;
    D[79] = z_53*z_69 + z_37*z_27;
    D[81] = -(q2_dot*(z_118 + sin_q2*(1.0 - sin_q3 - cos_q3*cos_q5 - z_115*z_41)) - q3_dot*(z_49 - cos_q3*(cos_q2
        + z_115*z_22)) - q4_dot*(z_50*z_115 - z_24*z_120) - q5_dot*z_55);
    D[84] = -(q1_dot*z_109 + q4_dot*z_112 + q5_dot*z_113 - q2_dot*z_110 - q3_dot*z_111);
    const double z_125 = q1_dot*cos_q1;
    const double z_126 = z_73*sin_q1;
    const double z_127 = z_67*z_8 - z_72*z_58;
    D[85] = z_87*z_125 + q3_dot*(z_69*z_58 - z_68*z_59) + q4_dot*z_127 + q5_dot*(z_37*z_59 + z_57*z_69) -
        q2_dot*(z_126 + sin_q2*z_76);
    D[86] = q1_dot*(sin_q1*z_93 + cos_q1*z_95) + (z_28*z_69 - z_68*z_33)*z_96 + q3_dot*(sin_q3*z_81 - cos_q3*z_79)
        + q5_dot*(z_37*z_9 + z_18*z_100) - z_18*z_99;
    D[87] = -(q1_dot*(z_33*z_72 + cos_q1*z_102) + q3_dot*(z_16*z_72 + z_17*z_72) + q4_dot*(z_126 + z_67*z_9) +
        z_63*z_103 - q2_dot*z_127);
    const double z_128 = sin_q1*z_41;
    D[88] = q1_dot*(sin_q1*z_104 + cos_q1*z_107) + q2_dot*(z_8*z_108 + cos_q2*(z_37*z_33 + z_69*z_128)) +
        q4_dot*(z_62*z_69 - z_9*z_108) + q5_dot*(z_37*z_13 + z_18*z_69) - q3_dot*(sin_q3*(z_37*z_8 - cos_q1*z_100)
        - cos_q3*(z_91 + z_8*z_100));
    D[89] = -z_75;
    D[90] = z_77;
    D[91] = -z_82;
    D[92] = z_83;
    D[93] = z_84;
    const double z_129 = cos_q5*z_33;
    const double z_130 = cos_q5*z_8;
    const double z_131 = q5_dot*z_64;
    D[95] = q1_dot*(sin_q1*z_117 - cos_q1*z_119) + q2_dot*(cos_q2*(sin_q1 - z_129 - z_28*z_116) - z_8*z_120) +
        q3_dot*(sin_q3*(z_130 - cos_q1*z_116) - cos_q3*(z_26 + z_8*z_116)) + q4_dot*(z_9*z_120 - z_62*z_115) +
        z_131;
    const double z_132 = sin_q3*sin_q5 - cos_q3*z_65;
    const double z_133 = cos_q4*cos_q5;
    const double z_134 = cos_q2*z_133;
    const double z_135 = sin_q5*z_44 + z_42*cos_q5 - z_134;
    D[98] = -(q1_dot*(cos_q1*z_132 + sin_q1*z_135) + q3_dot*(cos_q3*(sin_q5*sin_q1 - z_21*z_65) +
        sin_q3*(sin_q1*z_65 + sin_q5*z_21)) + q5_dot*z_40 - q2_dot*(z_21*z_133 + cos_q2*(z_26*z_41 + sin_q5*z_5))
        - q4_dot*(cos_q5*z_35 + z_34*z_133));
    const double z_136 = sin_q1*z_134;
    const double z_137 = sin_q5*z_33 + cos_q5*z_128;
    const double z_138 = z_8*z_65;
    const double z_139 = z_138 - z_133*z_58;
    D[99] = (z_54 + sin_q2*z_133 + cos_q5*z_52)*z_125 + q2_dot*(z_136 - sin_q2*z_137) + q3_dot*(z_129*z_22 -
        sin_q5*z_58) - q4_dot*z_139 - q5_dot*z_60;
    const double z_140 = sin_q5*z_8 - cos_q1*z_65;
    const double z_141 = sin_q5*cos_q1 + z_138;
    D[100] = q1_dot*(cos_q1*(z_65*z_44 - sin_q5*z_47) - sin_q1*(sin_q5*cos_q3 + cos_q5*z_41)) + (z_33*z_65 -
        sin_q5*z_28)*z_96 + q4_dot*z_18*z_133 + q5_dot*z_61 - q3_dot*(cos_q3*z_140 + sin_q3*z_141);
    D[101] = q1_dot*(cos_q1*(cos_q5*z_22 + z_133*z_47) + z_33*z_133) + q3_dot*(z_17*z_133 + z_16*z_133) +
        q4_dot*(z_136 + z_9*z_65) + q5_dot*sin_q5*z_63 - q2_dot*z_139;
    const double z_142 = cos_q4*sin_q5;
    D[102] = -(z_131 + q2_dot*(z_8*z_142 - cos_q2*(z_129 - sin_q5*z_128)) + q4_dot*(sin_q5*z_62 - z_9*z_142) -
        q1_dot*(cos_q1*(z_45 + z_12*sin_q5 - z_42*sin_q5) - (z_114 + cos_q3*z_32)*sin_q1) - q3_dot*(cos_q3*(z_26 -
        z_8*z_32) - sin_q3*(z_130 + cos_q1*z_32)));
    D[103] = cos_q1*z_135 - sin_q1*z_132;
    D[104] = cos_q2*z_137 + z_8*z_133;
    D[105] = cos_q3*z_141 - sin_q3*z_140;
    D[106] = -(z_9*z_133 - cos_q5*z_62);
    D[107] = z_19;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes bricard_lanes;
EM_WEAK em_lanes bricard_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 10, 35, 0, 25 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double l = parameters[1];
    const double m = parameters[0];
    const double z_0 = l*m;
    prepared[3] = z_0; /* c_0 */
    prepared[4] = 3.0*m; /* c_1 */
    prepared[5] = 5.0*m; /* c_2 */
    prepared[6] = 6.0*m; /* c_3 */
    prepared[7] = 5.0*z_0; /* c_4 */
    const double z_1 = m*(l*l);
    prepared[8] = 4.0*z_1; /* c_5 */
    prepared[9] = 2.0*m; /* c_6 */
    prepared[10] = 2.0*z_0; /* c_7 */
    prepared[11] = 3.0*l; /* c_8 */
    prepared[12] = 2.0*z_1; /* c_9 */
    prepared[13] = z_1; /* c_10 */
    prepared[14] = (1.0/3.0)*z_1; /* c_11 */
    prepared[15] = 3.0*z_1; /* c_12 */
    const double g = parameters[2];
    const double z_2 = z_0*g;
    prepared[16] = z_2; /* c_13 */
    prepared[17] = 3.0*z_2; /* c_14 */
    prepared[18] = 5.0*l; /* c_15 */
    prepared[19] = 6.0*l; /* c_16 */
    prepared[20] = 2.0*l; /* c_17 */
    prepared[21] = (-42.0)*z_2; /* c_18 */
    prepared[22] = 30.0*z_2; /* c_19 */
    prepared[23] = 6.0*z_2; /* c_20 */
    prepared[24] = 12.0*l; /* c_21 */
    prepared[25] = 8.0*z_1; /* c_22 */
    prepared[26] = 6.0*z_1; /* c_23 */
    prepared[27] = fabs(l); /* c_24 */
    prepared[28] = 0.5*(m*g); /* c_25 */
    prepared[29] = -l; /* c_26 */
    prepared[30] = (1.0/20.0)*l; /* c_27 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
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
    const double l = c[1];
    const double c_0 = c[3];
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
    const double c_1 = c[4];
    const double c_2 = c[5];
    const double c_3 = c[6];
    const double z_17 = -z_15;
    const double z_18 = c_0 + z_16*c_1 + z_13*c_2 + z_14*c_3 + z_17*c_3;
    const double z_19 = sin_q4*cos_q3;
    const double z_20 = cos_q3 + z_19;
    const double z_21 = l*(z_20 - (sin_q3*cos_q5 + sin_q5*z_19));
    const double z_22 = z_21*c_1;
    const double z_23 = l*z_20;
    const double c_4 = c[7];
    const double m = c[0];
    const double z_24 = m*(2.0*z_21 + z_23);
    const double z_25 = sin_q5*z_24;
    const double z_26 = l*((c_0*cos_q3 + z_22 + z_23*c_2) - z_25);
    const double z_27 = sin_q4*z_26;
    const double z_28 = l*(z_22 + z_23*c_3 + cos_q3*c_4) + z_27;
    const double z_29 = m*(2.0*z_16 + z_17);
    const double z_30 = l*(m*(3.0*z_16 + z_14 + 5.0*z_17) - sin_q5*z_29);
    const double z_31 = l*(m*(3.0*z_16 + z_13 + 5.0*z_14 + 6.0*z_17)) + sin_q4*z_30;
    const double z_32 = l*cos_q5;
    const double z_33 = z_24*z_32;
    const double z_34 = z_29*z_32;
    const double c_5 = c[8];
    M[0] = (1.0/6.0)*(l*z_18 + cos_q3*z_28 + c_0*z_13 + z_31*z_6 + z_11*z_34 + c_5 - z_12*z_18 - z_2*z_30 -
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
    const double z_41 = z_39*c_1 + z_40*c_3;
    const double z_42 = m*(2.0*z_39 + z_40);
    const double z_43 = sin_q4*(l*(m*(3.0*z_39 + z_36 + 5.0*z_40) - sin_q5*z_42));
    const double z_44 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_45 = c_0*cos_q4 + z_44*c_6;
    const double z_46 = sin_q5*z_45;
    const double z_47 = l*((z_44*c_1 + cos_q4*c_4) - z_46);
    const double z_48 = cos_q4*z_47;
    M[6] = ((-1.0/6.0))*(sin_q3*(l*(c_0 + z_36*c_2 + z_41) + z_43) + cos_q3*z_42*z_32 - l*(c_4 + z_36*c_3 + z_41)
        - z_48);
    M[10] = M[2] = (1.0/6.0)*(sin_q3*z_31 + z_28*z_11 + cos_q3*z_34 - z_6*z_33);
    M[11] = M[7] = (1.0/6.0)*(z_19*z_47 + cos_q3*(m*z_44 + cos_q4*c_7)*c_8 - sin_q3*(z_45*z_32));
    const double z_49 = l*sin_q5;
    const double z_50 = l + l*sin_q4;
    const double z_51 = z_50 - sin_q4*z_49;
    const double z_52 = z_51*c_1;
    const double z_53 = m*(2.0*z_51 + z_50);
    const double c_9 = c[12];
    const double z_54 = cos_q5*cos_q5;
    M[12] = (1.0/6.0)*(l*(c_4 + z_52 + z_50*c_3) + sin_q4*(l*((c_0 + z_52 + z_50*c_2) - sin_q5*z_53)) + c_9*z_54);
    M[15] = M[3] = ((-1.0/6.0))*(cos_q4*cos_q3*z_30 - cos_q2*z_27 - z_6*z_35);
    M[16] = M[8] = ((-1.0/6.0))*(z_43 - sin_q3*z_48);
    const double c_10 = c[13];
    M[17] = M[13] = ((-1.0/6.0))*(cos_q4*(c_10*(3.0*cos_q5 - 2.0*sin_q5*cos_q5)));
    const double z_55 = l - z_49;
    M[18] = (1.0/6.0)*(l*((c_4 + z_55*c_1) - sin_q5*(c_0 + z_55*c_6)));
    M[20] = M[4] = (1.0/6.0)*(l*(z_7*cos_q5*z_24 + cos_q5*z_19*z_29 - sin_q5*(sin_q3*z_29) - z_25*z_11));
    M[21] = M[9] = ((-1.0/6.0))*(l*(cos_q5*(cos_q4*z_42) + cos_q3*z_46 + cos_q5*z_45*z_37));
    M[22] = M[14] = ((-1.0/6.0))*(z_53*z_49 - c_9*(sin_q4*z_54));
    M[23] = M[19] = 0.0;
    const double c_11 = c[14];
    M[24] = c_11;
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
EM_ACROSS void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
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
                              double A1[N_ROWS][N1], double b[N_ROWS], double shared[58])
{
    const double l = c[1];
    const double c_0 = c[3];
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
    const double c_1 = c[4];
    const double c_2 = c[5];
    const double c_3 = c[6];
    const double z_18 = -z_16;
    const double z_19 = c_0 + z_17*c_1 + z_14*c_2 + z_15*c_3 + z_18*c_3;
    const double z_20 = sin_q3*cos_q5;
    const double z_21 = sin_q4*cos_q3;
    const double z_22 = cos_q3 + z_21;
    const double z_23 = l*(z_22 - (z_20 + sin_q5*z_21));
    const double z_24 = z_23*c_1;
    const double z_25 = l*z_22;
    const double c_4 = c[7];
    const double m = c[0];
    const double z_26 = m*(2.0*z_23 + z_25);
    const double z_27 = sin_q5*z_26;
    const double z_28 = l*((c_0*cos_q3 + z_24 + z_25*c_2) - z_27);
    const double z_29 = sin_q4*z_28;
    const double z_30 = l*(z_24 + z_25*c_3 + cos_q3*c_4) + z_29;
    const double z_31 = cos_q3*z_30;
    const double z_32 = m*(2.0*z_17 + z_18);
    const double z_33 = sin_q5*z_32;
    const double z_34 = l*(m*(3.0*z_17 + z_15 + 5.0*z_18) - z_33);
    const double z_35 = l*(m*(3.0*z_17 + z_14 + 5.0*z_15 + 6.0*z_18)) + sin_q4*z_34;
    const double z_36 = l*cos_q5;
    const double z_37 = sin_q3*z_36;
    const double c_5 = c[8];
    M1[0][0] = (1.0/6.0)*(l*z_19 + z_31 + c_0*z_14 + z_35*z_6 + z_11*(z_32*z_36) + c_5 - z_13*z_19 - z_2*z_34 -
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
    const double z_49 = z_47*c_1 + z_48*c_3;
    const double z_50 = m*(2.0*z_47 + z_48);
    const double z_51 = l*(m*(3.0*z_47 + z_43 + 5.0*z_48) - sin_q5*z_50);
    const double z_52 = sin_q4*z_51;
    const double z_53 = l*(c_0 + z_43*c_2 + z_49) + z_52;
    const double z_54 = l*(cos_q4 - cos_q4*sin_q5);
    const double z_55 = c_0*cos_q4 + z_54*c_6;
    const double z_56 = sin_q5*z_55;
    const double z_57 = l*((z_54*c_1 + cos_q4*c_4) - z_56);
    const double z_58 = cos_q4*z_57;
    M1[1][1] = ((-1.0/6.0))*(sin_q3*z_53 + z_50*z_40 - l*(c_4 + z_43*c_3 + z_49) - z_58);
    M1[0][2] = M1[2][0] = (1.0/6.0)*(sin_q3*z_35 + z_30*z_11 + z_32*z_40 - z_6*(z_26*z_36));
    const double z_59 = m*z_54 + cos_q4*c_7;
    M1[1][2] = M1[2][1] = (1.0/6.0)*(z_21*z_57 + cos_q3*z_59*c_8 - z_55*z_37);
    const double z_60 = l*sin_q5;
    const double z_61 = l + l*sin_q4;
    const double z_62 = z_61 - sin_q4*z_60;
    const double z_63 = z_62*c_1;
    const double z_64 = m*(2.0*z_62 + z_61);
    const double z_65 = l*((c_0 + z_63 + z_61*c_2) - sin_q5*z_64);
    const double c_9 = c[12];
    const double z_66 = cos_q5*cos_q5;
    const double z_67 = c_9*z_66;
    M1[2][2] = (1.0/6.0)*(l*(c_4 + z_63 + z_61*c_3) + sin_q4*z_65 + z_67);
    const double z_68 = cos_q4*cos_q3;
    const double z_69 = cos_q2*sin_q4;
    const double z_70 = cos_q4*z_28;
    M1[0][3] = M1[3][0] = ((-1.0/6.0))*(z_34*z_68 - z_28*z_69 - z_6*z_70);
    M1[1][3] = M1[3][1] = ((-1.0/6.0))*(z_52 - sin_q3*z_58);
    const double c_10 = c[13];
    const double z_71 = c_10*(3.0*cos_q5 - 2.0*sin_q5*cos_q5);
    M1[2][3] = M1[3][2] = ((-1.0/6.0))*(cos_q4*z_71);
    const double z_72 = l - z_60;
    const double z_73 = c_0 + z_72*c_6;
    M1[3][3] = (1.0/6.0)*(l*((c_4 + z_72*c_1) - sin_q5*z_73));
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
    const double c_11 = c[14];
    M1[4][4] = c_11;
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
    const double c_4 = c[7];
    const double q2_dot = v[1];
    const double cos_q2 = shared[0];
    const double z_101 = q2_dot*cos_q2;
    const double q3_dot = v[2];
    const double z_11 = shared[1];
    const double z_102 = q3_dot*z_11;
    const double sin_q3 = shared[2];
    const double z_103 = sin_q3*z_101;
    const double z_104 = l*z_101 - l*(z_102 + z_103);
    const double c_3 = c[6];
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
    const double c_1 = c[4];
    const double z_117 = -z_115;
    const double z_118 = z_116*c_1 + z_117*c_3;
    const double z_119 = c_4*z_101 + z_104*c_3 + z_118;
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
    const double z_127 = z_126*c_1;
    const double z_28 = shared[17];
    const double z_128 = z_28*z_108;
    const double c_0 = c[3];
    const double c_2 = c[5];
    const double z_26 = shared[18];
    const double m = c[0];
    const double z_129 = m*(2.0*z_126 + z_125);
    const double z_130 = sin_q5*z_129;
    const double z_131 = l*(c_0*z_111 + z_127 + z_125*c_2) + l*(z_26*z_110 - z_130);
    const double z_132 = l*(z_127 + z_125*c_3 + c_4*z_111) - (z_128 - sin_q4*z_131);
    const double z_19 = shared[19];
    const double z_34 = shared[20];
    const double z_2 = shared[21];
    const double z_32 = shared[22];
    const double z_133 = z_32*z_110;
    const double z_134 = m*(2.0*z_116 + z_117);
    const double z_135 = l*(m*(3.0*z_116 + z_104 + 5.0*z_117)) + l*(z_133 - sin_q5*z_134);
    const double c_10 = c[13];
    const double z_35 = shared[23];
    const double z_136 = l*(c_0*z_101 + z_104*c_2 + z_118) - (z_34*z_108 - sin_q4*z_135);
    const double z_20 = shared[24];
    const double z_137 = z_32*z_44;
    const double z_12 = shared[25];
    Mdot1[0][0] = ((-1.0/6.0))*(l*z_119 + (z_30*z_111 + cos_q3*z_132) + l*(z_19*z_101 - sin_q2*z_119) + c_10*z_101
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
    const double z_145 = z_144*c_1;
    const double z_51 = shared[34];
    const double z_50 = shared[35];
    const double z_146 = m*(2.0*z_144 + z_143);
    const double z_147 = z_51*z_108 - sin_q4*(l*(c_0*z_120 + z_145 + z_143*c_2) + l*(z_50*z_110 - sin_q5*z_146));
    const double z_57 = shared[36];
    const double z_148 = z_57*z_105;
    const double z_149 = l*z_105 - l*(sin_q5*z_105 - cos_q4*z_110);
    const double z_55 = shared[37];
    const double z_150 = z_55*z_110;
    const double z_151 = c_0*z_105 + z_149*c_6;
    const double z_152 = l*(z_149*c_1 + c_4*z_105) + l*(z_150 - sin_q5*z_151);
    const double z_153 = cos_q4*z_152;
    const double c_8 = c[11];
    Mdot1[1][1] = ((-1.0/6.0))*((z_53*z_120 - sin_q3*(l*(z_145 + c_4*z_120 + z_143*c_3) - z_147)) + (z_148 +
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
    const double z_156 = l*(z_64*z_110 + sin_q5*(c_0*z_108 + z_155*c_6));
    const double c_5 = c[8];
    const double z_157 = cos_q5*z_114;
    Mdot1[2][2] = (1.0/6.0)*((z_65*z_108 + sin_q4*(l*(z_155*c_1 + c_4*z_108) - z_156)) + (m*z_155 + c_7*z_108)*c_8
        - c_5*z_157);
    const double z_68 = shared[44];
    const double z_29 = shared[45];
    const double z_69 = shared[46];
    Mdot1[0][3] = Mdot1[3][0] = (1.0/6.0)*((cos_q3*z_34*z_105 + cos_q4*z_34*z_111 + z_135*z_68) - (z_29*z_138 +
        z_131*z_69 - cos_q2*z_128) - (z_6*z_139 + cos_q4*z_131*z_6 - z_103*z_70 - z_102*z_70));
    const double z_58 = shared[47];
    Mdot1[1][3] = Mdot1[3][1] = ((-1.0/6.0))*(z_147 + (sin_q3*z_148 + sin_q3*z_153 - z_58*z_120));
    const double z_71 = shared[48];
    const double z_66 = shared[49];
    const double c_12 = c[15];
    Mdot1[2][3] = Mdot1[3][2] = (1.0/6.0)*(z_71*z_105 + cos_q4*(2.0*c_10*(q5_dot*z_66 - q5_dot*(sin_q5*sin_q5)) +
        c_12*z_114));
    const double z_73 = shared[50];
    const double z_36 = shared[51];
    const double c_9 = c[12];
    Mdot1[3][3] = ((-1.0/6.0))*(c_12*z_110 - (c_9*z_157 - z_73*(q5_dot*z_36)));
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
    Mdot1[2][4] = Mdot1[4][2] = ((-1.0/6.0))*(z_156 - 2.0*c_10*(z_66*z_108 - 2.0*z_114*z_77));
    Mdot1[3][4] = Mdot1[4][3] = 0.0;
    Mdot1[4][4] = 0.0;
}

/* After an accepted step, and at the start: constraints on positions, C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[58];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 35);
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

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "bricard.h"

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
static int simulate(em_run *run) { return em_simulate(&bricard_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&bricard_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&bricard_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&bricard_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&bricard_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&bricard_model, run, mode); }

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
    .redundant = em_redundant,
    .energy = energy,
    .eigenfactors = em_eigenfactors_of,
    .output = em_observe,
    .motion_jacobian = em_motion_jacobian,
    .simulate = simulate,
    .interpolate = interpolate,
    .release = release,
    .event = model_events,
    .lanes = &bricard_lanes,
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
    .n_shapes = 14,
    .dimension = 3,
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
