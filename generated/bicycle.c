/* eigenmotion generate bicycle.py */
/* input sha256:086a2e7d83260e45b545b8ae0bfffd95f92bbe57b7720c7c4a3f813b1553452d */
/* body sha256:f4d13390a3c07fc2ece7fcd92625a37a32f48f2e805b2c10bb244a32c1548c71 */
/* bicycle: equations of motion, eigenfactor formulation.
 *
 * State, 88 numbers:
 *   x    y[0 .. 8)
 *   eta  y[8 .. 16)
 *   C    y[16 .. 80)
 *   s    y[80 .. 88)
 *
 * Blocks of M that do not couple:
 *   1: x, y, psi, phi, theta, delta, spin_r, spin_f (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dx, dM/dy, dM/dspin_r, dM/dspin_f: M does not depend on them
 *
 * Operations of the straight-line part:
 *   eigenfactor: 1176 additions, 1832 multiplications, 2 divisions, 1 roots, 8 function calls
 *   triangular root: 1320 additions, 2068 multiplications, 2 divisions, 1 roots, 8 function calls
 *   projection: 809 additions, 1292 multiplications, 1 divisions, 1 roots, 8 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 8,                /* coordinates */
    N_ROWS = 5,           /* constraint rows */
    N_POSITIONS = 1,      /* of which holonomic */
    N_STATE = 88,         /* numbers of a state */
    N_C = 64,             /* of which C, */
    N_S = 8,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 72,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 26,
    N_PREPARED = 154,     /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 27,         /* inputs, parameters and the time */
    N_ARGUMENTS = 43,     /* x, v and these: what motion depends on */
    N1 = 8,               /* x, y, psi, phi, theta, delta, spin_r, spin_f */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4, 5, 6, 7 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_BY_ITSELF void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                     real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real m_B = c[7];
    const real psi = x[2];
    const real cos_psi = em_cos(psi);
    const real r_R = c[4];
    const real phi_dot = v[3];
    const real phi = x[3];
    const real cos_phi = em_cos(phi);
    const real z_2 = phi_dot*cos_phi;
    const real z_3 = r_R*z_2;
    const real x_B = c[10];
    const real theta = x[4];
    const real sin_theta = em_sin(theta);
    const real z_5 = sin_theta*z_2;
    const real sin_phi = em_sin(phi);
    const real theta_dot = v[4];
    const real cos_theta = em_cos(theta);
    const real z_8 = theta_dot*cos_theta;
    const real z_9 = sin_phi*z_8;
    const real z_10 = z_5 + z_9;
    const real c_1 = c[27];
    const real z_11 = cos_theta*z_2;
    const real z_12 = theta_dot*sin_theta;
    const real z_13 = sin_phi*z_12;
    const real z_14 = z_11 - z_13;
    const real z_15 = z_3 - x_B*z_10 - c_1*z_14;
    const real z_16 = r_R*sin_phi;
    const real z_17 = sin_phi*sin_theta;
    const real z_18 = sin_phi*cos_theta;
    const real z_19 = z_16 - x_B*z_17 - c_1*z_18;
    const real psi_dot = v[2];
    const real sin_psi = em_sin(psi);
    const real z_21 = psi_dot*sin_psi;
    const real m_F = c[9];
    const real c_2 = c[28];
    const real z_22 = c_2*z_17 - (z_16 - r_R*z_18);
    const real c_ = c[1];
    const real c_3 = c[29];
    const real c_4 = c[30];
    const real delta = x[5];
    const real cos_delta = em_cos(delta);
    const real z_24 = c_3 + c_4*cos_delta;
    const real c_5 = c[31];
    const real z_25 = c_5 - cos_delta*c_5;
    const real c_6 = c[32];
    const real sin_delta = em_sin(delta);
    const real z_27 = c_6*sin_delta;
    const real z_28 = z_24*z_17 + z_25*z_18 + cos_phi*z_27;
    const real r_F = c[5];
    const real z_29 = c_4 + c_3*cos_delta;
    const real c_7 = c[33];
    const real z_30 = c_7*sin_delta;
    const real z_31 = z_29*z_18 + z_25*z_17 - cos_phi*z_30;
    const real z_32 = z_22 - (c_*z_28 + r_F*z_31);
    const real z_33 = -z_32;
    const real z_34 = c_2*z_10 - (z_3 - r_R*z_14);
    const real delta_dot = v[5];
    const real z_35 = delta_dot*sin_delta;
    const real z_36 = c_4*z_35;
    const real z_37 = z_17*z_36 - (z_24*z_5 + z_24*z_9);
    const real z_38 = c_5*z_35;
    const real z_39 = z_18*z_38 + (z_25*z_11 - z_25*z_13);
    const real z_40 = delta_dot*cos_delta;
    const real z_41 = cos_phi*z_40;
    const real z_42 = phi_dot*sin_phi;
    const real z_43 = sin_delta*z_42;
    const real z_44 = z_41 - z_43;
    const real z_45 = (-z_37) + z_39 + c_6*z_44;
    const real z_46 = c_3*z_35;
    const real z_47 = (z_18*z_46 + (z_29*z_13 - z_29*z_11)) - (z_17*z_38 + (z_25*z_5 + z_25*z_9));
    const real z_48 = c_7*z_44 + z_47;
    const real z_49 = z_34 - (c_*z_45 - r_F*z_48);
    const real z_50 = -z_49;
    const real m_H = c[8];
    const real z_H = c[13];
    const real c_8 = c[34];
    const real z_51 = z_31*z_H + z_28*c_8 - z_22;
    const real z_52 = c_8*z_45 - z_H*z_48 - z_34;
    const real z_53 = x_B*z_12 + c_1*z_8;
    const real z_54 = x_B*cos_theta - sin_theta*c_1;
    const real z_55 = psi_dot*cos_psi;
    const real z_56 = cos_theta*c_2 - r_R*sin_theta;
    const real z_57 = cos_theta*z_25;
    const real z_58 = sin_theta*z_29 - z_57;
    const real z_59 = sin_theta*z_25;
    const real z_60 = cos_theta*z_24 - z_59;
    const real z_61 = z_56 + (r_F*z_58 - c_*z_60);
    const real z_62 = r_R*z_8 + c_2*z_12;
    const real z_63 = sin_theta*z_35;
    const real z_64 = z_25*z_12;
    const real z_65 = cos_theta*z_38;
    const real z_66 = z_64 - z_65;
    const real z_67 = (z_29*z_8 - c_3*z_63) + z_66;
    const real z_68 = z_67;
    const real z_69 = cos_theta*z_35;
    const real z_70 = z_25*z_8;
    const real z_71 = sin_theta*z_38;
    const real z_72 = z_70 + z_71;
    const real z_73 = (z_24*z_12 + c_4*z_69) + z_72;
    const real z_74 = z_73;
    const real z_75 = z_62 - (r_F*z_68 + c_*z_74);
    const real z_76 = z_H*z_58 + z_56 - c_8*z_60;
    const real z_77 = z_62 - z_H*z_68 - c_8*z_74;
    const real c_9 = c[35];
    Mdot1[0][2] = Mdot1[2][0] = m_B*(cos_psi*z_15 - z_19*z_21) + m_B*(sin_psi*z_53 - z_54*z_55) + c_9*(cos_psi*z_2
        - sin_phi*z_21) - m_F*(z_33*z_21 - cos_psi*z_50) - m_H*(z_51*z_21 - cos_psi*z_52) - m_F*(z_61*z_55 -
        sin_psi*z_75) - m_H*(z_76*z_55 - sin_psi*z_77);
    Mdot1[1][2] = Mdot1[2][1] = -(m_B*(z_54*z_21 + cos_psi*z_53) + m_F*(z_61*z_21 + cos_psi*z_75) + m_H*(z_76*z_21
        + cos_psi*z_77) - m_B*(sin_psi*z_15 + z_19*z_55) - m_F*(sin_psi*z_50 + z_33*z_55) - m_H*(sin_psi*z_52 +
        z_51*z_55) - c_9*(sin_psi*z_2 + sin_phi*z_55));
    const real z_78 = sin_theta*cos_phi;
    const real z_79 = cos_theta*cos_phi;
    const real z_80 = sin_phi*z_27 - z_24*z_78 - z_25*z_79;
    const real c_10 = c[36];
    const real z_81 = z_29*z_79 + z_25*z_78 + sin_phi*z_30;
    const real c_11 = c[37];
    const real z_82 = z_81*c_11 - z_80*c_10;
    const real c_12 = c[38];
    const real z_83 = z_80*c_11 - z_81*c_12;
    const real z_84 = sin_phi*cos_delta + z_78*z_27 - z_79*z_30;
    const real c_13 = c[39];
    const real c_14 = c[40];
    const real z_85 = sin_phi*z_40;
    const real z_86 = z_85 + sin_delta*z_2;
    const real z_87 = sin_theta*z_42;
    const real z_88 = cos_phi*z_8;
    const real z_89 = z_78*z_36 + (z_24*z_87 - z_24*z_88);
    const real z_90 = cos_theta*z_42;
    const real z_91 = cos_phi*z_12;
    const real z_92 = z_79*z_38 - (z_25*z_90 + z_25*z_91);
    const real z_93 = c_6*z_86 + z_89 + (-z_92);
    const real z_94 = (z_79*z_46 + (z_29*z_90 + z_29*z_91)) - (z_78*z_38 + (z_25*z_88 - z_25*z_87));
    const real z_95 = z_94 - c_7*z_86;
    const real z_96 = c_10*z_93 + z_95*c_11;
    const real z_97 = c_12*z_95 + z_93*c_11;
    const real c_56 = c[82];
    const real z_98 = sin_phi*z_35;
    const real z_99 = (cos_delta*z_2 - z_98) + c_6*(sin_delta*z_88 + z_40*z_78 - sin_delta*z_87) +
        c_7*(sin_delta*z_91 + sin_delta*z_90 - z_40*z_79);
    const real z_100 = (c_6*(z_82*z_40 - sin_delta*z_96) + c_7*(z_83*z_40 + sin_delta*z_97)) +
        2.0*(c_56*(z_84*z_35 - cos_delta*z_99) - 0.5*c_14*z_2);
    const real c_15 = c[41];
    const real c_16 = c[42];
    const real c_17 = c[43];
    const real z_101 = sin_delta*z_84;
    const real z_102 = z_24*z_82 + c_15*z_78 + c_16*z_79 + c_17*z_101 - z_25*z_83;
    const real B_xz = c[21];
    const real z_103 = z_90 + z_91;
    const real c_57 = c[83];
    const real z_104 = z_84*z_40 + sin_delta*z_99;
    const real z_105 = z_88 - z_87;
    const real z_106 = (z_82*z_36 + z_24*z_96) + (z_83*z_38 + z_25*z_97) + 2.0*B_xz*z_103 - 2.0*c_57*z_104 -
        c_15*z_105;
    const real c_18 = c[44];
    const real c_19 = c[45];
    const real z_107 = z_25*z_82 + c_18*z_79 + c_16*z_78 - z_29*z_83 - c_19*z_101;
    const real c_58 = c[84];
    const real z_108 = (z_82*z_38 - z_25*z_96) + (z_83*z_46 - z_29*z_97) + 2.0*B_xz*z_105 - 2.0*c_58*z_104 -
        c_18*z_103;
    const real c_59 = c[85];
    const real c_60 = c[86];
    const real c_61 = c[87];
    const real c_62 = c[88];
    Mdot1[2][2] = (-0.5)*(((z_82*z_27 + z_83*z_30 - cos_delta*z_84*c_13 - sin_phi*c_14)*z_2 + sin_phi*z_100) +
        (z_107*z_91 + z_107*z_90 - z_108*z_79) + z_54*z_53*c_59 + z_61*z_75*c_60 + z_76*z_77*c_61 - (z_102*z_88 -
        z_102*z_87 - z_106*z_78) - z_19*z_15*c_59 - z_33*z_50*c_60 - z_51*z_52*c_61 - sin_phi*c_62*z_2);
    const real c_24 = c[50];
    const real c_25 = c[51];
    const real z_109 = z_78*z_55;
    const real c_26 = c[52];
    const real z_110 = z_79*z_55;
    const real c_27 = c[53];
    const real z_111 = sin_delta*sin_psi;
    const real z_112 = sin_phi*sin_delta;
    const real c_28 = c[54];
    const real z_113 = z_29*c_28;
    const real z_114 = sin_psi*z_113;
    const real z_115 = sin_psi*z_35;
    const real c_63 = c[89];
    const real z_116 = c_63*z_79;
    const real c_29 = c[55];
    const real z_117 = z_24*c_29;
    const real z_118 = sin_psi*z_117;
    const real c_64 = c[90];
    const real z_119 = c_64*z_78;
    const real z_120 = z_25*c_29;
    const real z_121 = sin_psi*z_120;
    const real c_65 = c[91];
    const real z_122 = c_65*z_79;
    const real z_123 = z_25*c_28;
    const real z_124 = sin_psi*z_123;
    const real c_66 = c[92];
    const real z_125 = c_66*z_78;
    Mdot1[0][3] = Mdot1[3][0] = -(c_24*(sin_psi*z_42 - cos_phi*z_55) + c_25*(sin_psi*z_88 + z_109 - sin_psi*z_87)
        + c_27*(z_2*z_111 + sin_psi*z_85 + z_55*z_112) + (z_91*z_114 + z_90*z_114 + z_115*z_116 - z_110*z_113) +
        (z_91*z_121 + z_90*z_121 - z_115*z_122 - z_110*z_120) - c_26*(sin_psi*z_91 + sin_psi*z_90 - z_110) -
        (z_88*z_118 + z_109*z_117 - z_115*z_119 - z_87*z_118) - (z_88*z_124 + z_115*z_125 + z_109*z_123 -
        z_87*z_124));
    const real z_126 = z_78*z_21;
    const real z_127 = z_79*z_21;
    const real z_128 = cos_psi*sin_delta;
    const real z_129 = cos_psi*z_113;
    const real z_130 = cos_psi*z_35;
    const real z_131 = cos_psi*z_117;
    const real z_132 = cos_psi*z_120;
    const real z_133 = cos_psi*z_123;
    Mdot1[1][3] = Mdot1[3][1] = c_25*(cos_psi*z_88 - z_126 - cos_psi*z_87) + c_27*(z_2*z_128 + cos_psi*z_85 -
        z_21*z_112) + c_24*(cos_phi*z_21 + cos_psi*z_42) + (z_91*z_129 + z_127*z_113 + z_90*z_129 + z_130*z_116) +
        (z_91*z_132 + z_127*z_120 + z_90*z_132 - z_130*z_122) - c_26*(cos_psi*z_91 + z_127 + cos_psi*z_90) -
        (z_88*z_131 - z_126*z_117 - z_130*z_119 - z_87*z_131) - (z_88*z_133 + z_130*z_125 - z_126*z_123 -
        z_87*z_133);
    const real z_134 = m_F*z_61 + m_H*z_76;
    const real z_135 = m_F*z_75 + m_H*z_77;
    const real c_32 = c[58];
    const real c_33 = c[59];
    const real z_136 = z_61*c_32 + z_76*c_33;
    const real z_137 = sin_delta*z_136;
    const real z_138 = c_32*z_75 + c_33*z_77;
    const real c_30 = c[56];
    const real c_31 = c[57];
    const real z_139 = z_61*c_30 + z_76*c_31;
    const real z_140 = z_29*z_139;
    const real z_141 = z_139*z_46;
    const real z_142 = c_30*z_75 + c_31*z_77;
    const real z_143 = z_29*z_142;
    const real z_144 = z_24*z_136;
    const real z_145 = z_136*z_36;
    const real z_146 = z_24*z_138;
    const real z_147 = z_25*z_136;
    const real z_148 = z_136*z_38;
    const real z_149 = z_25*z_138;
    const real z_150 = z_25*z_139;
    const real z_151 = z_139*z_38;
    const real z_152 = z_25*z_142;
    const real z_153 = sin_delta*z_139;
    const real c_67 = c[93];
    const real c_68 = c[94];
    Mdot1[2][3] = Mdot1[3][2] = 0.5*((z_107*z_8 + sin_theta*z_108) + (z_102*z_12 + cos_theta*z_106) +
        2.0*r_R*((m_B*z_54 + z_134)*z_42 + cos_phi*(m_B*z_53 + z_135)) + 2.0*c_2*(z_134*z_88 - z_134*z_87 -
        z_135*z_78) + 2.0*c_6*(z_2*z_137 + z_136*z_85 - z_138*z_112) + 2.0*(z_91*z_140 + z_90*z_140 + z_79*z_141 +
        z_79*z_143) + 2.0*(z_91*z_147 + z_90*z_147 + z_79*z_149 - z_79*z_148) + 2.0*c_67*(z_54*z_88 - z_54*z_87 -
        z_53*z_78) - 2.0*r_R*(z_134*z_91 + z_134*z_90 + z_135*z_79) - 2.0*(z_88*z_144 - z_78*z_145 - z_87*z_144 -
        z_78*z_146) - 2.0*(z_88*z_150 + z_78*z_151 - z_87*z_150 - z_78*z_152) - 2.0*c_7*(z_2*z_153 + z_139*z_85 -
        z_142*z_112) - 2.0*c_68*(z_54*z_91 + z_54*z_90 + z_53*z_79));
    const real z_154 = z_60*c_11 - z_58*c_12;
    const real z_155 = z_58*c_11 - z_60*c_10;
    const real z_156 = cos_theta*z_27 + sin_theta*z_30;
    const real z_157 = sin_delta*z_156;
    const real z_158 = c_12*z_68 + z_74*c_11;
    const real z_159 = c_10*z_74 + z_68*c_11;
    const real z_160 = sin_delta*z_12;
    const real z_161 = cos_theta*z_40;
    const real z_162 = z_160 - z_161;
    const real z_163 = sin_delta*z_8;
    const real z_164 = sin_theta*z_40;
    const real z_165 = z_163 + z_164;
    const real z_166 = c_6*z_162 - c_7*z_165;
    const real z_167 = z_156*z_40 - sin_delta*z_166;
    const real z_168 = sin_theta*z_24;
    const real z_169 = z_57 + z_168;
    const real z_170 = cos_theta*z_29;
    const real z_171 = z_59 + z_170;
    const real z_172 = r_R*cos_theta + sin_theta*c_2;
    const real z_173 = r_R - z_172;
    const real z_174 = c_*z_169 + r_F*z_171 + z_173;
    const real z_175 = z_H*z_171 + c_8*z_169 + z_173;
    const real z_176 = c_30*z_174 + c_31*z_175;
    const real z_177 = z_29*z_12;
    const real z_178 = c_3*z_69;
    const real z_179 = z_24*z_8;
    const real z_180 = c_4*z_63;
    const real z_181 = z_66 - (z_179 - z_180);
    const real z_182 = z_72 - (z_177 + z_178);
    const real z_183 = r_R*z_12 - c_2*z_8;
    const real z_184 = r_F*z_182 + z_183 - c_*z_181;
    const real z_185 = z_H*z_182 + z_183 - c_8*z_181;
    const real z_186 = c_30*z_184 + c_31*z_185;
    const real z_187 = c_32*z_174 + c_33*z_175;
    const real z_188 = c_32*z_184 + c_33*z_185;
    const real z_189 = m_F*z_174 + m_H*z_175;
    const real z_190 = m_F*z_184 + m_H*z_185;
    const real z_191 = r_R - x_B*sin_theta - c_1*cos_theta;
    const real z_192 = c_1*z_12 - x_B*z_8;
    const real c_34 = c[60];
    const real c_69 = c[95];
    const real z_193 = cos_delta*z_35;
    Mdot1[3][3] = 0.5*(((z_24*z_155 + sin_theta*c_16 - z_25*z_154 - cos_theta*c_15 - c_17*z_157)*z_12 +
        cos_theta*((z_155*z_36 - z_24*z_159) + (z_154*z_38 - z_25*z_158) + 2.0*c_57*z_167 - c_15*z_12 - c_16*z_8))
        + 2.0*(z_187*z_179 + z_168*z_188 - z_187*z_180) + 2.0*(z_176*z_70 + z_176*z_71 + z_59*z_186) +
        2.0*r_R*(z_189*z_12 - cos_theta*z_190) + 2.0*c_68*(z_191*z_12 - cos_theta*z_192) + (m_B*z_192 +
        z_190)*c_34 - ((z_29*z_154 + cos_theta*c_16 - z_25*z_155 - sin_theta*c_18 - c_19*z_157)*z_8 -
        sin_theta*((z_154*z_46 + z_29*z_158) + (z_155*z_38 + z_25*z_159) + 2.0*c_58*z_167 + c_18*z_8 + c_16*z_12))
        - 2.0*(z_176*z_177 + z_176*z_178 - z_170*z_186) - 2.0*(z_187*z_64 - z_187*z_65 - z_57*z_188) -
        2.0*c_2*(z_189*z_8 + sin_theta*z_190) - 2.0*c_67*(z_191*z_8 + sin_theta*z_192) - c_69*z_193);
    const real z_194 = sin_theta*z_21;
    const real z_195 = cos_theta*z_21;
    const real z_196 = cos_psi*z_69;
    const real z_197 = cos_psi*z_63;
    const real z_198 = z_17*z_55;
    const real z_199 = z_18*z_55;
    const real z_200 = c_64*z_18;
    const real z_201 = c_66*z_18;
    const real z_202 = c_63*z_17;
    const real z_203 = c_65*z_17;
    Mdot1[0][4] = Mdot1[4][0] = -(c_25*(cos_psi*z_8 - z_194) + (z_12*z_129 + z_195*z_113 + c_63*z_196) +
        (z_12*z_132 + z_195*z_120 - c_65*z_196) + c_25*(sin_psi*z_11 + z_199 - sin_psi*z_13) + (z_5*z_114 +
        z_9*z_114 + z_198*z_113 - z_115*z_202) + (z_5*z_121 + z_9*z_121 + z_115*z_203 + z_198*z_120) -
        c_26*(cos_psi*z_12 + z_195) - (z_8*z_131 - z_194*z_117 - c_64*z_197) - c_26*(sin_psi*z_5 + sin_psi*z_9 +
        z_198) - (z_8*z_133 + c_66*z_197 - z_194*z_123) - (z_11*z_118 + z_199*z_117 - z_13*z_118 - z_115*z_200) -
        (z_11*z_124 + z_115*z_201 + z_199*z_123 - z_13*z_124));
    const real z_204 = sin_theta*z_55;
    const real z_205 = cos_theta*z_55;
    const real z_206 = sin_psi*z_69;
    const real z_207 = sin_psi*z_63;
    const real z_208 = z_18*z_21;
    const real z_209 = z_17*z_21;
    Mdot1[1][4] = Mdot1[4][1] = -(c_25*(sin_psi*z_8 + z_204) + (z_12*z_114 + c_63*z_206 - z_205*z_113) +
        (z_12*z_121 - c_65*z_206 - z_205*z_120) + c_26*(cos_psi*z_5 + cos_psi*z_9 - z_209) + (z_11*z_131 -
        z_13*z_131 - z_208*z_117 - z_130*z_200) + (z_11*z_133 + z_130*z_201 - z_13*z_133 - z_208*z_123) -
        c_26*(sin_psi*z_12 - z_205) - (z_8*z_118 + z_204*z_117 - c_64*z_207) - c_25*(cos_psi*z_11 - cos_psi*z_13 -
        z_208) - (z_8*z_124 + c_66*z_207 + z_204*z_123) - (z_5*z_129 + z_9*z_129 - z_209*z_113 - z_130*z_202) -
        (z_5*z_132 + z_9*z_132 + z_130*z_203 - z_209*z_120));
    const real z_210 = z_33*c_30 + z_51*c_31;
    const real z_211 = c_30*z_50 + c_31*z_52;
    const real z_212 = z_33*c_32 + z_51*c_33;
    const real z_213 = c_32*z_50 + c_33*z_52;
    const real z_214 = m_F*z_33 + m_H*z_51;
    const real z_215 = m_F*z_50 + m_H*z_52;
    Mdot1[2][4] = Mdot1[4][2] = (-0.5)*(z_100 + 2.0*(z_210*z_177 + z_210*z_178 - z_170*z_211) + 2.0*(z_212*z_64 -
        z_212*z_65 - z_57*z_213) + 2.0*c_2*(z_214*z_8 + sin_theta*z_215) + 2.0*c_67*(z_19*z_8 + sin_theta*z_15) +
        2.0*r_R*(z_134*z_5 + z_134*z_9 - z_135*z_17) + 2.0*(z_11*z_144 - z_13*z_144 - z_18*z_145 - z_18*z_146) +
        2.0*(z_11*z_150 + z_18*z_151 - z_13*z_150 - z_18*z_152) + 2.0*c_68*(z_54*z_5 + z_54*z_9 - z_53*z_17) -
        2.0*(z_212*z_179 + z_168*z_213 - z_212*z_180) - 2.0*(z_210*z_70 + z_210*z_71 + z_59*z_211) -
        2.0*r_R*(z_214*z_12 - cos_theta*z_215) - 2.0*c_2*(z_134*z_11 - z_134*z_13 - z_135*z_18) - 2.0*(z_5*z_140 +
        z_9*z_140 - z_17*z_141 - z_17*z_143) - 2.0*(z_5*z_147 + z_9*z_147 + z_17*z_148 - z_17*z_149) -
        2.0*c_68*(z_19*z_12 - cos_theta*z_15) - 2.0*c_67*(z_54*z_11 - z_54*z_13 - z_53*z_18));
    const real c_70 = c[96];
    const real c_71 = c[97];
    const real z_216 = z_24*c_71;
    const real c_72 = c[98];
    const real z_217 = sin_delta*sin_delta;
    const real z_218 = delta_dot*z_217;
    const real z_219 = cos_theta*z_218;
    const real c_73 = c[99];
    const real z_220 = z_25*c_73;
    const real c_74 = c[100];
    const real c_75 = c[101];
    const real z_221 = z_29*c_73;
    const real c_76 = c[102];
    const real z_222 = sin_theta*z_218;
    const real z_223 = z_25*c_71;
    const real c_77 = c[103];
    Mdot1[3][4] = Mdot1[4][3] = 0.5*(2.0*c_56*(z_156*z_35 + cos_delta*z_166) + 2.0*c_70*z_165 + 2.0*c_75*z_162 -
        c_6*(z_155*z_40 + sin_delta*z_159) - c_7*(z_154*z_40 - sin_delta*z_158) - 2.0*(z_160*z_216 + c_72*z_219 -
        z_161*z_216) - 2.0*(z_160*z_220 - c_74*z_219 - z_161*z_220) - 2.0*(z_163*z_221 + z_164*z_221 - c_76*z_222)
        - 2.0*(z_163*z_223 + c_77*z_222 + z_164*z_223));
    const real z_224 = c_*z_25;
    const real z_225 = r_F*z_29;
    const real z_226 = r_R - z_224 - z_225;
    const real z_227 = r_R - z_29*z_H - z_25*c_8;
    const real z_228 = c_30*z_226 + c_31*z_227;
    const real c_78 = c[104];
    const real z_229 = c_*z_24;
    const real z_230 = z_25*r_F;
    const real z_231 = c_2 - z_229 - z_230;
    const real z_232 = c_2 - z_25*z_H - z_24*c_8;
    const real z_233 = c_32*z_231 + c_33*z_232;
    const real c_79 = c[105];
    const real z_234 = c_32*z_226 + c_33*z_227;
    const real c_80 = c[106];
    const real z_235 = z_25*z_35;
    const real z_236 = c_30*z_231 + c_31*z_232;
    const real c_81 = c[107];
    const real c_82 = c[108];
    const real c_83 = c[109];
    Mdot1[4][4] = (z_228*z_46 - z_29*c_78*z_35) + (z_233*z_36 - z_24*c_79*z_35) + c_82*z_35 - (z_234*z_38 +
        c_80*z_235) - (z_236*z_38 + c_81*z_235) - c_83*z_193;
    const real c_47 = c[73];
    const real z_237 = cos_theta*sin_delta;
    const real z_238 = cos_phi*z_35;
    const real z_239 = cos_delta*z_42;
    const real z_240 = cos_delta*cos_phi;
    const real c_48 = c[74];
    const real z_241 = sin_theta*sin_delta;
    const real z_242 = z_40*z_18;
    const real z_243 = sin_delta*z_18;
    const real z_244 = z_40*z_17;
    const real z_245 = sin_delta*z_17;
    Mdot1[0][5] = Mdot1[5][0] = -(c_47*(cos_psi*z_160 + z_21*z_237 - cos_psi*z_161) + c_27*(sin_psi*z_238 +
        sin_psi*z_239 - z_240*z_55) + c_48*(cos_psi*z_163 + cos_psi*z_164 - z_21*z_241) + c_48*(z_11*z_111 +
        sin_psi*z_242 + z_55*z_243 - z_13*z_111) + c_47*(z_5*z_111 + z_9*z_111 + sin_psi*z_244 + z_55*z_245));
    Mdot1[1][5] = Mdot1[5][1] = -(c_47*(sin_psi*z_160 - sin_psi*z_161 - z_55*z_237) + c_48*(sin_psi*z_163 +
        sin_psi*z_164 + z_55*z_241) - c_27*(z_240*z_21 + cos_psi*z_238 + cos_psi*z_239) - c_47*(z_5*z_128 +
        z_9*z_128 + cos_psi*z_244 - z_21*z_245) - c_48*(z_11*z_128 + cos_psi*z_242 - z_13*z_128 - z_21*z_243));
    Mdot1[2][5] = Mdot1[5][2] = (-0.5)*(c_7*z_96 + c_6*z_97 + 2.0*c_4*(z_212*z_160 - z_212*z_161 - z_213*z_237) +
        2.0*c_7*(z_139*z_238 + z_139*z_239 + z_240*z_142) + 2.0*c_3*(z_210*z_163 + z_210*z_164 + z_211*z_241) +
        2.0*c_5*(z_11*z_137 + z_136*z_242 - z_13*z_137 - z_138*z_243) + 2.0*c_5*(z_5*z_153 + z_9*z_153 +
        z_139*z_244 - z_142*z_245) - 2.0*c_6*(z_136*z_238 + z_136*z_239 + z_240*z_138) - 2.0*c_4*(z_5*z_137 +
        z_9*z_137 + z_136*z_244 - z_138*z_245) - 2.0*c_3*(z_11*z_153 + z_139*z_242 - z_13*z_153 - z_142*z_243) -
        2.0*c_5*(z_212*z_163 + z_212*z_164 + z_213*z_241) - 2.0*c_5*(z_210*z_160 - z_210*z_161 - z_211*z_237));
    const real c_84 = c[110];
    const real c_85 = c[111];
    Mdot1[3][5] = Mdot1[5][3] = 0.5*(c_7*z_159 + c_6*z_158 + 2.0*c_84*(z_217*z_12 - 2.0*cos_delta*z_69) +
        2.0*c_7*(z_176*z_35 - cos_delta*z_186) - 2.0*c_6*(z_187*z_35 - cos_delta*z_188) - 2.0*c_85*(z_217*z_8 +
        2.0*cos_delta*z_63));
    const real c_54 = c[80];
    const real c_86 = c[112];
    const real c_87 = c[113];
    const real z_246 = c_5*z_40;
    const real c_88 = c[114];
    const real c_89 = c[115];
    Mdot1[4][5] = Mdot1[5][4] = (-0.5)*(c_54*z_40 + 2.0*(c_4*z_234*z_40 + c_87*z_218) + 2.0*(z_233*z_246 +
        c_89*z_218) - 2.0*(c_3*z_236*z_40 + c_86*z_218) - 2.0*(z_228*z_246 + c_88*z_218));
    Mdot1[5][5] = em_real(0.0);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real R_yy = c[15];
    Mdot1[2][6] = Mdot1[6][2] = R_yy*z_2;
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    Mdot1[4][6] = Mdot1[6][4] = em_real(0.0);
    Mdot1[5][6] = Mdot1[6][5] = em_real(0.0);
    Mdot1[6][6] = em_real(0.0);
    Mdot1[0][7] = Mdot1[7][0] = em_real(0.0);
    Mdot1[1][7] = Mdot1[7][1] = em_real(0.0);
    const real F_yy = c[17];
    Mdot1[2][7] = Mdot1[7][2] = F_yy*z_99;
    Mdot1[3][7] = Mdot1[7][3] = F_yy*z_166;
    Mdot1[4][7] = Mdot1[7][4] = -F_yy*z_35;
    Mdot1[5][7] = Mdot1[7][5] = em_real(0.0);
    Mdot1[6][7] = Mdot1[7][6] = em_real(0.0);
    Mdot1[7][7] = em_real(0.0);
    f1[0] = em_real(0.0);
    f1[1] = em_real(0.0);
    const real x_dot = v[0];
    const real m_R = c[6];
    const real y_dot = v[1];
    const real z_247 = z_3 - (y_dot*cos_psi - x_dot*sin_psi);
    const real z_248 = c_7*z_40;
    const real z_249 = cos_phi*z_248 + z_47 - z_42*z_30;
    const real z_250 = c_6*z_40;
    const real z_251 = cos_phi*z_250 + z_39 - z_42*z_27 - z_37;
    const real z_252 = (c_2*z_9 - r_R*z_13) - (z_247 - (r_R*z_11 + c_2*z_5));
    const real z_253 = psi_dot*z_76 + z_H*z_249 + z_252 - c_8*z_251;
    const real z_254 = psi_dot*z_61 + r_F*z_249 + z_252 - c_*z_251;
    const real z_255 = m_H*z_253 + m_F*z_254;
    const real z_256 = psi_dot*z_54 + x_B*z_5 + c_1*z_11 + x_B*z_9 - c_1*z_13 - z_247;
    const real z_257 = m_R*(-z_247) + z_255 + m_B*z_256;
    const real z_258 = psi_dot*sin_phi;
    const real z_259 = x_dot*cos_psi + y_dot*sin_psi;
    const real z_260 = r_R*z_258 + z_259;
    const real z_261 = z_62 - z_259;
    const real z_262 = psi_dot*z_51 + z_H*z_67 + c_8*z_73 - z_261;
    const real z_263 = psi_dot*z_33 + c_*z_73 + r_F*z_67 - z_261;
    const real z_264 = m_H*z_262 + m_F*z_263;
    const real z_265 = psi_dot*z_19 + z_259 - z_53;
    const real z_266 = m_R*z_260 + z_264 + m_B*z_265;
    f1[2] = -(cos_psi*(x_dot*z_257 - y_dot*z_266) + sin_psi*(y_dot*z_257 + x_dot*z_266));
    const real z_267 = phi_dot*cos_theta;
    const real z_268 = c_33*z_253 + c_32*z_254;
    const real z_269 = z_25*z_268;
    const real z_270 = phi_dot*sin_theta;
    const real z_271 = z_24*z_268;
    const real z_272 = c_31*z_253 + c_30*z_254;
    const real z_273 = z_25*z_272;
    const real z_274 = z_29*z_272;
    const real z_275 = sin_phi*z_250 + z_2*z_27 + z_89 - z_92;
    const real z_276 = sin_phi*z_248 + z_2*z_30 - z_94;
    const real z_277 = r_R*z_42;
    const real z_278 = (r_R*z_90 + c_2*z_87) + (r_R*z_91 - (z_277 + c_2*z_88));
    const real z_279 = c_8*z_275 - z_H*z_276 - z_278;
    const real z_280 = c_*z_275 - r_F*z_276 - z_278;
    const real z_281 = c_31*z_279 + c_30*z_280;
    const real z_282 = c_33*z_279 + c_32*z_280;
    const real z_283 = z_270 + psi_dot*z_79;
    const real z_284 = B_xz*z_283;
    const real B_xx = c[18];
    const real z_285 = z_267 - psi_dot*z_78;
    const real H_xz = c[25];
    const real z_286 = theta_dot + z_258;
    const real z_287 = delta_dot*c_6 + z_29*z_283 + z_286*z_30 - z_25*z_285;
    const real z_288 = H_xz*z_287;
    const real H_xx = c[22];
    const real z_289 = z_24*z_285 + z_286*z_27 - delta_dot*c_7 - z_25*z_283;
    const real c_90 = c[116];
    const real z_290 = z_288 - (H_xx*z_289 - z_288) - c_90*z_289;
    const real z_291 = H_xz*z_289;
    const real H_zz = c[24];
    const real c_91 = c[117];
    const real z_292 = z_291 - (H_zz*z_287 - z_291) - c_91*z_287;
    const real c_92 = c[118];
    const real c_36 = c[62];
    const real H_yy = c[23];
    const real z_293 = z_283*z_30 - (cos_delta*z_286 - z_285*z_27);
    const real spin_f_dot = v[7];
    const real z_294 = H_yy*(-z_293) + F_yy*(spin_f_dot - z_293);
    const real z_295 = sin_delta*z_294;
    const real z_296 = z_284 + z_24*z_290 + c_36*z_295 - (B_xx*z_285 - z_284) - z_25*z_292 - c_92*z_285;
    const real z_297 = B_xz*z_285;
    const real B_zz = c[20];
    const real c_93 = c[119];
    const real c_37 = c[63];
    const real z_298 = z_297 + z_29*z_292 + c_37*z_295 - (B_zz*z_283 - z_297) - z_25*z_290 - c_93*z_283;
    const real c_94 = c[120];
    const real c_35 = c[61];
    const real z_299 = z_255*c_35;
    const real z_300 = z_255*c_34;
    const real z_301 = z_268*c_36;
    const real z_302 = z_272*c_37;
    const real z_303 = m_H*z_279 + m_F*z_280;
    const real z_304 = z_303*c_34;
    const real z_305 = z_303*c_35;
    const real c_51 = c[77];
    const real z_306 = c_51*z_63;
    const real c_50 = c[76];
    const real z_307 = c_50*z_69;
    const real z_308 = phi_dot*sin_delta;
    const real z_309 = z_281*c_37;
    const real z_310 = c_51*z_69;
    const real c_49 = c[75];
    const real z_311 = c_49*z_63;
    const real z_312 = z_282*c_36;
    const real c_39 = c[65];
    const real z_313 = z_256*c_39;
    const real c_38 = c[64];
    const real z_314 = z_256*c_38;
    const real z_315 = phi_dot*c_34;
    const real z_316 = z_277 + x_B*z_88 - x_B*z_87 - c_1*z_90 - c_1*z_91;
    const real z_317 = z_316*c_39;
    const real z_318 = z_316*c_38;
    const real c_95 = c[121];
    const real c_96 = c[122];
    const real z_319 = psi_dot*z_262;
    const real z_320 = psi_dot*z_263;
    const real z_321 = c_31*z_319 + c_30*z_320;
    const real z_322 = c_33*z_319 + c_32*z_320;
    const real c_97 = c[123];
    const real c_98 = c[124];
    const real z_323 = z_25*z_281;
    const real z_324 = z_29*z_281;
    const real z_325 = z_25*z_282;
    const real z_326 = z_24*z_282;
    const real c_99 = c[125];
    const real spin_r_dot = v[6];
    const real c_100 = c[126];
    const real c_23 = c[49];
    const real c_101 = c[127];
    const real z_327 = m_H*z_319 + m_F*z_320;
    const real z_328 = psi_dot*z_265;
    const real c_102 = c[128];
    f1[3] = (-0.5)*(sin_phi*(2.0*z_177*z_281 + 2.0*z_64*z_282 + psi_dot*sin_theta*z_296 + c_94 + z_270*z_299 +
        z_267*z_300 + z_40*z_302 + z_8*z_305 + z_281*z_307 + z_282*z_311 + z_308*z_312 + z_267*z_313 + z_270*z_314
        + z_8*z_318 + sin_delta*z_322*c_36 + cos_theta*c_97 + sin_theta*c_98 - 2.0*z_267*z_269 - 2.0*z_270*z_271 -
        2.0*z_270*z_273 - 2.0*z_267*z_274 - 2.0*z_70*z_281 - 2.0*z_179*z_282 - psi_dot*cos_theta*z_298 -
        z_40*z_301 - z_12*z_304 - z_281*z_306 - z_308*z_309 - z_282*z_310 - z_257*z_315 - z_12*z_317 - z_59*c_95 -
        z_170*c_95 - z_57*c_96 - z_168*c_96 - sin_delta*z_321*c_37) - cos_phi*(2.0*z_64*z_268 + 2.0*z_177*z_272 +
        2.0*z_270*z_323 + 2.0*z_267*z_324 + 2.0*z_267*z_325 + 2.0*z_270*z_326 + psi_dot*((2.0*cos_delta*z_294 +
        z_286*c_99 - z_290*z_27 - z_292*z_30) + (spin_r_dot + z_286)*c_100) + 2.0*z_59*z_321 + 2.0*z_170*z_321 +
        2.0*z_57*z_322 + 2.0*z_168*z_322 + sin_phi*c_23*(phi_dot*phi_dot) + c_101*(psi_dot*z_260) + z_8*z_299 +
        z_268*z_311 + z_308*z_301 + z_272*z_307 + z_40*z_312 + z_8*z_314 + (z_303 + m_B*z_316)*z_315 + (m_B*z_328
        + z_327)*c_34 - 2.0*z_179*z_268 - 2.0*z_70*z_272 - z_12*z_300 - z_268*z_310 - z_272*z_306 - z_308*z_302 -
        z_270*z_305 - z_267*z_304 - z_40*z_309 - z_12*z_313 - z_267*z_317 - z_270*z_318 - sin_theta*z_327*c_35 -
        cos_theta*z_327*c_34 - cos_theta*c_39*z_328 - sin_theta*c_38*z_328 - sin_delta*c_102));
    const real z_329 = theta_dot*sin_phi;
    const real z_330 = theta_dot*cos_phi;
    const real z_331 = c_31*z_262 + c_30*z_263;
    const real z_332 = c_33*z_262 + c_32*z_263;
    const real z_333 = theta_dot*z_25;
    const real z_334 = psi_dot*cos_phi;
    const real z_335 = psi_dot*z_253;
    const real z_336 = psi_dot*z_254;
    const real z_337 = c_33*z_335 + c_32*z_336;
    const real z_338 = c_31*z_335 + c_30*z_336;
    const real z_339 = sin_phi*z_25;
    const real z_340 = z_98*z_268;
    const real z_341 = z_98*z_272;
    const real z_342 = z_238*z_281;
    const real z_343 = z_238*z_282;
    const real z_344 = theta_dot*z_264;
    const real z_345 = z_331*z_35;
    const real z_346 = z_332*z_35;
    const real z_347 = theta_dot*z_265;
    const real z_348 = z_25*cos_phi;
    const real z_349 = m_H*z_335 + m_F*z_336;
    const real z_350 = sin_phi*z_327;
    const real z_351 = sin_phi*z_328;
    f1[4] = (-0.5)*(sin_theta*(2.0*z_42*z_324 + 2.0*z_42*z_325 + 2.0*theta_dot*z_29*z_331 + 2.0*z_332*z_333 +
        2.0*sin_phi*z_29*z_321 + 2.0*z_322*z_339 + z_329*z_299 + z_2*z_300 + c_50*z_341 + z_330*z_305 + c_50*z_342
        + c_49*z_346 + z_329*z_314 + z_2*z_313 + z_330*z_318 + z_349*c_35 + psi_dot*z_314 + cos_phi*c_97 -
        2.0*z_329*z_271 - 2.0*z_2*z_269 - 2.0*z_329*z_273 - 2.0*z_2*z_274 - 2.0*z_330*z_323 - 2.0*z_330*z_326 -
        phi_dot*z_296 - z_298*z_334 - 2.0*z_24*z_337 - 2.0*z_25*z_338 - c_51*z_340 - z_42*z_304 - c_51*z_343 -
        c_34*z_344 - c_51*z_345 - z_42*z_317 - c_39*z_347 - c_95*(cos_phi*z_29) - c_96*z_348 - c_34*z_350 -
        c_39*z_351) + cos_theta*(2.0*z_2*z_271 + 2.0*z_2*z_273 + phi_dot*z_298 + z_329*z_300 + c_51*z_341 +
        z_330*z_304 + z_42*z_305 + c_51*z_342 + c_35*z_344 + c_50*z_345 + z_329*z_313 + z_330*z_317 + z_42*z_318 +
        c_38*z_347 + c_95*z_348 + c_96*(z_24*cos_phi) + z_349*c_34 + psi_dot*z_313 + c_35*z_350 + c_38*z_351 -
        2.0*z_329*z_269 - 2.0*z_329*z_274 - 2.0*z_330*z_324 - 2.0*z_42*z_323 - 2.0*z_330*z_325 - 2.0*z_42*z_326 -
        2.0*z_331*z_333 - 2.0*theta_dot*z_24*z_332 - z_296*z_334 - 2.0*z_25*z_337 - 2.0*z_29*z_338 -
        2.0*z_321*z_339 - 2.0*sin_phi*z_24*z_322 - z_2*z_299 - c_49*z_340 - c_49*z_343 - c_51*z_346 - z_2*z_314 -
        cos_phi*c_98));
    const real z_352 = delta_dot*c_51;
    const real z_353 = delta_dot*c_49;
    const real z_354 = delta_dot*c_50;
    const real z_355 = delta_dot*cos_phi;
    const real z_356 = delta_dot*sin_phi;
    f1[5] = (-0.5)*(cos_delta*(c_6*z_286*z_290 + c_7*z_286*z_292 + z_352*(z_268*z_18) + z_352*(z_272*z_17) +
        z_42*z_302 + z_352*(z_281*z_78) + z_2*z_309 + z_352*(z_282*z_79) + z_352*(cos_theta*z_331) +
        z_354*(sin_theta*z_331) + c_37*(z_283*z_294) + c_36*(z_285*z_294) + c_37*(cos_phi*z_321) + sin_phi*c_102 -
        z_353*(z_268*z_17) - z_42*z_301 - z_354*(z_272*z_18) - z_354*(z_281*z_79) - z_353*(z_282*z_78) - z_2*z_312
        - z_352*(sin_theta*z_332) - z_353*(cos_theta*z_332) - c_36*(cos_phi*z_322)) -
        sin_delta*(c_3*(2.0*z_11*z_272 + z_283*z_292 + c_95*z_79 - 2.0*z_13*z_272 - 2.0*z_91*z_281 -
        2.0*z_90*z_281 - 2.0*z_331*z_8 - 2.0*sin_theta*z_338 - 2.0*z_321*z_18) + c_5*(2.0*z_13*z_268 +
        2.0*z_87*z_281 + 2.0*z_91*z_282 + 2.0*z_90*z_282 + 2.0*z_331*z_12 + 2.0*z_332*z_8 + z_283*z_290 +
        z_285*z_292 + 2.0*sin_theta*z_337 + 2.0*z_321*z_17 + 2.0*z_322*z_18 - 2.0*z_11*z_268 - 2.0*z_9*z_272 -
        2.0*z_5*z_272 - 2.0*z_88*z_281 - 2.0*cos_theta*z_338 - c_95*z_78 - c_96*z_79) + c_4*(2.0*z_9*z_268 +
        2.0*z_5*z_268 + 2.0*z_88*z_282 + z_285*z_290 + 2.0*cos_theta*z_337 + c_96*z_78 - 2.0*z_87*z_282 -
        2.0*z_332*z_12 - 2.0*z_322*z_17) + z_355*z_301 + z_356*z_309 - 2.0*z_286*z_294 - z_355*z_302 -
        z_356*z_312));
    f1[6] = em_real(0.0);
    f1[7] = em_real(0.0);
    A1[0][0] = em_real(0.0);
    A1[0][1] = em_real(0.0);
    A1[0][2] = em_real(0.0);
    const real c_103 = c[129];
    const real z_357 = z_84*z_84;
    const real z_358 = 1.0 - z_357;
    const real z_359 = sqrt(z_358);
    const real z_360 = 1.0/z_359;
    const real z_361 = z_84*z_360;
    const real z_362 = r_F*z_361;
    const real z_363 = sin_delta*c_103 + cos_delta*z_362;
    const real c_104 = c[130];
    const real z_364 = c_104*z_361;
    const real c_105 = c[131];
    const real z_365 = c_105*z_361;
    const real z_366 = (sin_theta*z_229 + cos_theta*z_224) + (cos_theta*z_225 + sin_theta*z_230);
    const real z_367 = z_241*z_364 + z_173 + z_366 - z_237*z_365;
    A1[0][3] = cos_phi*z_363 - sin_phi*z_367;
    const real z_368 = r_R*cos_phi;
    const real z_369 = cos_phi*sin_delta;
    const real z_370 = z_368 + z_365*z_369 - cos_phi*z_224 - cos_phi*z_225;
    const real z_371 = cos_phi*c_2 - cos_phi*z_229 - cos_phi*z_230 - z_364*z_369;
    A1[0][4] = sin_theta*z_370 - cos_theta*z_371;
    const real z_372 = sin_phi*c_103 + z_78*z_364 - z_79*z_365;
    const real c_106 = c[132];
    const real c_107 = c[133];
    const real z_373 = c_5*(c_*z_79 + r_F*z_78) - c_106*z_78 - sin_phi*z_362 - c_107*z_79;
    A1[0][5] = cos_delta*z_372 + sin_delta*z_373;
    A1[0][6] = em_real(0.0);
    A1[0][7] = em_real(0.0);
    A1[1][0] = cos_psi;
    A1[1][1] = sin_psi;
    A1[1][2] = em_real(0.0);
    A1[1][3] = em_real(0.0);
    const real c_108 = c[134];
    A1[1][4] = c_108;
    A1[1][5] = em_real(0.0);
    A1[1][6] = c_108;
    A1[1][7] = em_real(0.0);
    A1[2][0] = -sin_psi;
    A1[2][1] = cos_psi;
    A1[2][2] = em_real(0.0);
    A1[2][3] = em_real(0.0);
    A1[2][4] = em_real(0.0);
    A1[2][5] = em_real(0.0);
    A1[2][6] = em_real(0.0);
    A1[2][7] = em_real(0.0);
    A1[3][0] = cos_psi;
    A1[3][1] = sin_psi;
    const real z_374 = z_240 + z_18*z_30 - z_17*z_27;
    const real z_375 = z_81*z_374;
    const real z_376 = r_F*(z_31*z_359 - z_361*z_375);
    const real z_377 = z_357*z_360;
    const real z_378 = r_F*(z_374*z_359 + z_374*z_377);
    const real z_379 = z_80*z_374;
    const real z_380 = r_F*(z_28*z_359 + z_361*z_379);
    const real z_381 = z_376*z_30 - (cos_delta*z_378 + z_380*z_27);
    const real z_382 = -z_381;
    const real z_383 = z_25*z_380 + z_29*z_376 + z_378*z_30;
    const real z_384 = z_25*z_376 + z_24*z_380 - z_378*z_27;
    A1[3][2] = z_383*z_79 + z_384*z_78 - sin_phi*z_382 - z_32;
    A1[3][3] = em_real(0.0);
    A1[3][4] = -(z_172 - z_381 - z_366);
    const real c_109 = c[135];
    const real c_110 = c[136];
    A1[3][5] = c_7*z_380 + c_6*z_376 + c_110*z_237 - c_109*z_241;
    A1[3][6] = em_real(0.0);
    A1[3][7] = -z_378;
    A1[4][0] = -sin_psi;
    A1[4][1] = cos_psi;
    const real z_385 = z_80*z_156;
    const real z_386 = r_F*(z_60*z_359 - z_361*z_385);
    const real z_387 = r_F*(z_156*z_359 + z_156*z_377);
    const real z_388 = z_81*z_156;
    const real z_389 = r_F*(z_58*z_359 - z_361*z_388);
    const real z_390 = z_386*z_27 - (cos_delta*z_387 - z_389*z_30);
    const real z_391 = -z_390;
    const real z_392 = z_29*z_389 + z_387*z_30 - z_25*z_386;
    const real z_393 = z_24*z_386 + z_387*z_27 - z_25*z_389;
    A1[4][2] = z_61 + z_392*z_79 - sin_phi*z_391 - z_393*z_78;
    A1[4][3] = -(z_368 + c_103*z_112 + z_229*z_78 + z_224*z_79 + z_225*z_79 + z_230*z_78 - sin_theta*z_392 -
        cos_theta*z_393 - r_R*z_79 - c_2*z_78);
    A1[4][4] = -(r_R*z_17 + z_229*z_18 + z_230*z_18 - c_2*z_18 - z_224*z_17 - z_225*z_17 - z_390);
    A1[4][5] = c_6*z_389 + c_103*z_240 + c_109*z_243 + c_110*z_245 - c_7*z_386;
    A1[4][6] = em_real(0.0);
    A1[4][7] = -z_387;
    const real z_394 = z_99*z_360;
    const real z_395 = z_99*z_357/(z_358*z_359);
    const real c_111 = c[137];
    const real c_112 = c[138];
    const real z_396 = ((z_225*z_12 + c_107*z_69) - (z_230*z_8 + c_111*z_63)) - (z_183 + ((z_229*z_8 - c_106*z_63)
        - (z_224*z_12 - c_112*z_69)));
    const real z_397 = z_43*z_361 - z_41*z_361 - z_394*z_369 - z_395*z_369;
    gamma[0] = -(phi_dot*((z_363*z_42 - cos_phi*(c_103*z_40 - r_F*(z_35*z_361 - cos_delta*z_394 -
        cos_delta*z_395))) + (z_367*z_2 + sin_phi*(c_104*(z_163*z_361 + z_164*z_361 + z_394*z_241 + z_395*z_241) +
        c_105*(z_160*z_361 - z_161*z_361 - z_394*z_237 - z_395*z_237) - z_396))) + delta_dot*((z_372*z_35 -
        cos_delta*(c_103*z_2 + c_105*(z_91*z_361 + z_90*z_361 - z_79*z_394 - z_79*z_395) + c_104*(z_88*z_361 +
        z_78*z_394 + z_78*z_395 - z_87*z_361))) - (z_373*z_40 - sin_delta*(c_5*(c_*z_103 - r_F*z_105) +
        c_106*z_105 + r_F*(z_2*z_361 + sin_phi*z_394 + sin_phi*z_395) - c_107*z_103))) - theta_dot*((z_370*z_8 -
        sin_theta*(z_277 + (c_112*z_238 - z_224*z_42) + c_105*z_397 - (z_225*z_42 + c_107*z_238))) + (z_371*z_12 +
        cos_theta*(c_2*z_42 + (c_111*z_238 - z_230*z_42) - (c_106*z_238 + z_229*z_42) - c_104*z_397))));
    const real z_398 = x_dot*z_21 - y_dot*z_55;
    gamma[1] = -z_398;
    const real z_399 = x_dot*z_55 + y_dot*z_21;
    gamma[2] = -z_399;
    const real z_400 = z_99*z_361;
    const real z_401 = z_238 + z_239;
    const real z_402 = sin_delta*z_11 + z_242 - sin_delta*z_13;
    const real z_403 = sin_delta*z_5 + sin_delta*z_9 + z_244;
    const real z_404 = z_401 + c_6*z_403 - c_7*z_402;
    const real z_405 = r_F*(z_48*z_359 + z_31*z_400) - r_F*(z_361*(z_374*z_95) + z_361*(z_81*z_404) - z_394*z_375
        - z_395*z_375);
    const real z_406 = z_374*z_400;
    const real z_407 = r_F*(z_406 + z_404*z_359) - r_F*(2.0*z_406 + z_395*(z_84*z_374) - z_404*z_377);
    const real z_408 = r_F*(z_45*z_359 - z_28*z_400) + r_F*(z_361*(z_374*z_93) + z_394*z_379 + z_395*z_379 -
        z_361*(z_80*z_404));
    const real z_409 = c_7*(z_376*z_40 - sin_delta*z_405) + ((z_378*z_35 + cos_delta*z_407) - c_6*(z_380*z_40 +
        sin_delta*z_408));
    const real z_410 = z_378*z_40 - sin_delta*z_407;
    gamma[3] = -(z_398 - psi_dot*((z_384*z_88 + ((z_376*z_38 - z_25*z_405) - (z_380*z_36 - z_24*z_408) -
        c_6*z_410)*z_78 - z_384*z_87) - (z_382*z_2 - sin_phi*z_409) - (z_383*z_91 + z_383*z_90 - ((z_380*z_38 +
        z_25*z_408) + c_7*z_410 - (z_376*z_46 + z_29*z_405))*z_79) - z_49) - theta_dot*(z_409 - z_396) -
        delta_dot*(c_7*z_408 - c_6*z_405 - c_109*z_165 - c_110*z_162) - spin_f_dot*z_407);
    const real z_411 = r_F*(z_74*z_359 + z_60*z_400) + r_F*(z_361*(z_156*z_93) + z_394*z_385 + z_395*z_385 -
        z_361*(z_80*z_166));
    const real z_412 = z_156*z_400;
    const real z_413 = r_F*(z_166*z_359 + z_412) - r_F*(2.0*z_412 + z_395*(z_84*z_156) - z_166*z_377);
    const real z_414 = r_F*(z_68*z_359 - z_58*z_400) + r_F*(z_361*(z_156*z_95) + z_361*(z_81*z_166) - z_394*z_388
        - z_395*z_388);
    const real z_415 = c_6*(z_386*z_40 - sin_delta*z_411) + ((z_387*z_35 + cos_delta*z_413) + c_7*(z_389*z_40 +
        sin_delta*z_414));
    const real z_416 = z_387*z_40 - sin_delta*z_413;
    const real z_417 = (z_389*z_46 - z_29*z_414) + (z_386*z_38 - z_25*z_411) - c_7*z_416;
    const real z_418 = (z_386*z_36 + z_24*z_411) + (z_389*z_38 + z_25*z_414) - c_6*z_416;
    const real z_419 = c_106*z_35;
    const real z_420 = c_112*z_35;
    const real z_421 = c_107*z_35;
    const real z_422 = c_111*z_35;
    gamma[4] = -(z_399 + psi_dot*((z_391*z_2 - sin_phi*z_415) + (z_392*z_91 + z_392*z_90 + z_417*z_79) +
        (z_393*z_88 - z_393*z_87 - z_418*z_78) + z_75) - phi_dot*(z_277 + (z_392*z_8 - sin_theta*z_417) +
        c_2*z_105 + (z_224*z_91 + z_224*z_90 - z_79*z_420) + (z_225*z_91 + z_225*z_90 + z_79*z_421) - (z_393*z_12
        + cos_theta*z_418) - r_R*z_103 - c_103*z_86 - (z_229*z_88 - z_78*z_419 - z_229*z_87) - (z_230*z_88 +
        z_78*z_422 - z_230*z_87)) - theta_dot*(z_415 + c_2*z_14 + (z_224*z_5 + z_224*z_9 + z_17*z_420) +
        (z_225*z_5 + z_225*z_9 - z_17*z_421) - r_R*z_10 - (z_229*z_11 - z_229*z_13 - z_18*z_419) - (z_230*z_11 +
        z_18*z_422 - z_230*z_13)) - delta_dot*(c_6*z_414 + c_7*z_411 + c_109*z_402 + c_110*z_403 - c_103*z_401) -
        spin_f_dot*z_413);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x, y, psi, phi, theta, delta, spin_r, spin_f: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[8], y[9], y[10], y[11], y[12], y[13], y[14], y[15] };
    const real *const C1 = y + 16, *const s1 = y + 80;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];
    dy[6] = v1[6];
    dy[7] = v1[7];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x, y, psi, phi, theta, delta, spin_r, spin_f: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[8], y[9], y[10], y[11], y[12], y[13], y[14], y[15] };
    const real *const C1 = y + 16, *const s1 = y + 80;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    dy[5] = v1[5];
    dy[6] = v1[6];
    dy[7] = v1[7];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, f1, A1, gamma);

    /* x, y, psi, phi, theta, delta, spin_r, spin_f: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* x, y, psi, phi, theta, delta, spin_r, spin_f: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 16, *const s1_dot = dy + 80;
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
    dy[8] = a1[0];
    dy[9] = a1[1];
    dy[10] = a1[2];
    dy[11] = a1[3];
    dy[12] = a1[4];
    dy[13] = a1[5];
    dy[14] = a1[6];
    dy[15] = a1[7];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_BY_ITSELF void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                    real shared[93])
{
    const real c_0 = c[26];
    M1[0][0] = c_0;
    M1[1][0] = em_real(0.0);
    M1[1][1] = c_0;
    const real psi = x[2];
    const real cos_psi = em_cos(psi);
    const real m_B = c[7];
    const real r_R = c[4];
    const real phi = x[3];
    const real sin_phi = em_sin(phi);
    const real z_2 = r_R*sin_phi;
    const real x_B = c[10];
    const real theta = x[4];
    const real sin_theta = em_sin(theta);
    const real z_4 = sin_phi*sin_theta;
    const real c_1 = c[27];
    const real cos_theta = em_cos(theta);
    const real z_6 = sin_phi*cos_theta;
    const real z_7 = z_2 - x_B*z_4 - c_1*z_6;
    const real z_8 = m_B*z_7;
    const real m_F = c[9];
    const real c_2 = c[28];
    const real z_9 = c_2*z_4 - (z_2 - r_R*z_6);
    const real c_ = c[1];
    const real c_3 = c[29];
    const real c_4 = c[30];
    const real delta = x[5];
    const real cos_delta = em_cos(delta);
    const real z_11 = c_3 + c_4*cos_delta;
    const real c_5 = c[31];
    const real z_12 = c_5 - cos_delta*c_5;
    const real cos_phi = em_cos(phi);
    const real c_6 = c[32];
    const real sin_delta = em_sin(delta);
    const real z_15 = c_6*sin_delta;
    const real z_16 = z_11*z_4 + z_12*z_6 + cos_phi*z_15;
    const real r_F = c[5];
    const real z_17 = c_4 + c_3*cos_delta;
    const real c_7 = c[33];
    const real z_18 = c_7*sin_delta;
    const real z_19 = z_17*z_6 + z_12*z_4 - cos_phi*z_18;
    const real z_20 = z_9 - (c_*z_16 + r_F*z_19);
    const real z_21 = -z_20;
    const real z_22 = m_F*z_21;
    const real m_H = c[8];
    const real z_H = c[13];
    const real c_8 = c[34];
    const real z_23 = z_19*z_H + z_16*c_8 - z_9;
    const real z_24 = m_H*z_23;
    const real sin_psi = em_sin(psi);
    const real z_26 = x_B*cos_theta - sin_theta*c_1;
    const real z_27 = m_B*z_26;
    const real z_28 = cos_theta*c_2 - r_R*sin_theta;
    const real z_29 = cos_theta*z_12;
    const real z_30 = sin_theta*z_17 - z_29;
    const real z_31 = sin_theta*z_12;
    const real z_32 = cos_theta*z_11 - z_31;
    const real z_33 = z_28 + (r_F*z_30 - c_*z_32);
    const real z_34 = m_F*z_33;
    const real z_35 = z_H*z_30 + z_28 - c_8*z_32;
    const real z_36 = m_H*z_35;
    const real c_9 = c[35];
    const real z_37 = sin_phi*c_9;
    M1[2][0] = cos_psi*z_8 + cos_psi*z_22 + cos_psi*z_24 + cos_psi*z_37 - sin_psi*z_27 - sin_psi*z_34 -
        sin_psi*z_36;
    M1[2][1] = cos_psi*z_27 + sin_psi*z_8 + cos_psi*z_34 + sin_psi*z_22 + cos_psi*z_36 + sin_psi*z_24 +
        sin_psi*z_37;
    const real z_38 = sin_theta*cos_phi;
    const real z_39 = cos_theta*cos_phi;
    const real z_40 = sin_phi*z_15 - z_11*z_38 - z_12*z_39;
    const real c_10 = c[36];
    const real z_41 = z_17*z_39 + z_12*z_38 + sin_phi*z_18;
    const real c_11 = c[37];
    const real z_42 = z_41*c_11 - z_40*c_10;
    const real c_12 = c[38];
    const real z_43 = z_40*c_11 - z_41*c_12;
    const real z_44 = sin_phi*cos_delta + z_38*z_15 - z_39*z_18;
    const real c_13 = c[39];
    const real z_45 = cos_delta*c_13;
    const real c_14 = c[40];
    const real z_46 = (z_42*z_15 + z_43*z_18) - (z_44*z_45 + sin_phi*c_14);
    const real c_15 = c[41];
    const real c_16 = c[42];
    const real c_17 = c[43];
    const real z_47 = sin_delta*z_44;
    const real z_48 = z_11*z_42 + c_15*z_38 + c_16*z_39 + c_17*z_47 - z_12*z_43;
    const real c_18 = c[44];
    const real c_19 = c[45];
    const real z_49 = z_12*z_42 + c_18*z_39 + c_16*z_38 - z_17*z_43 - c_19*z_47;
    const real c_20 = c[46];
    const real c_21 = c[47];
    const real c_22 = c[48];
    const real c_23 = c[49];
    M1[2][2] = 0.5*(z_48*z_38 + z_49*z_39 + c_20*(z_26*z_26) + c_20*(z_7*z_7) + c_21*(z_33*z_33) +
        c_21*(z_21*z_21) + c_22*(z_35*z_35) + c_22*(z_23*z_23) + c_23*(sin_phi*sin_phi) - sin_phi*z_46);
    const real c_24 = c[50];
    const real z_50 = cos_phi*c_24;
    const real c_25 = c[51];
    const real z_51 = sin_psi*c_25;
    const real c_26 = c[52];
    const real z_52 = sin_psi*c_26;
    const real z_53 = sin_phi*sin_delta;
    const real c_27 = c[53];
    const real z_54 = sin_psi*c_27;
    const real c_28 = c[54];
    const real z_55 = z_17*c_28;
    const real z_56 = sin_psi*z_55;
    const real c_29 = c[55];
    const real z_57 = z_11*c_29;
    const real z_58 = sin_psi*z_57;
    const real z_59 = z_12*c_29;
    const real z_60 = sin_psi*z_59;
    const real z_61 = z_12*c_28;
    const real z_62 = sin_psi*z_61;
    M1[3][0] = sin_psi*z_50 + z_39*z_56 + z_38*z_58 + z_39*z_60 + z_38*z_62 - z_38*z_51 - z_39*z_52 - z_53*z_54;
    const real z_63 = cos_psi*c_25;
    const real z_64 = cos_psi*c_26;
    const real z_65 = cos_psi*c_27;
    const real z_66 = cos_psi*z_55;
    const real z_67 = cos_psi*z_57;
    const real z_68 = cos_psi*z_59;
    const real z_69 = cos_psi*z_61;
    M1[3][1] = z_38*z_63 + z_39*z_64 + z_53*z_65 - cos_psi*z_50 - z_39*z_66 - z_38*z_67 - z_39*z_68 - z_38*z_69;
    const real c_30 = c[56];
    const real c_31 = c[57];
    const real z_70 = z_33*c_30 + z_35*c_31;
    const real z_71 = z_17*z_70;
    const real c_32 = c[58];
    const real c_33 = c[59];
    const real z_72 = z_33*c_32 + z_35*c_33;
    const real z_73 = z_11*z_72;
    const real z_74 = z_12*z_72;
    const real z_75 = z_12*z_70;
    const real z_76 = z_34 + z_36;
    const real z_77 = z_27 + z_76;
    const real c_34 = c[60];
    const real z_78 = z_76*c_34;
    const real c_35 = c[61];
    const real z_79 = z_76*c_35;
    const real c_36 = c[62];
    const real z_80 = z_72*c_36;
    const real c_37 = c[63];
    const real z_81 = z_70*c_37;
    const real c_38 = c[64];
    const real z_82 = z_26*c_38;
    const real c_39 = c[65];
    const real z_83 = z_26*c_39;
    M1[3][2] = 0.5*(sin_theta*z_49 + z_39*z_78 + z_38*z_79 + z_53*z_80 + z_38*z_82 + z_39*z_83 - cos_theta*z_48 -
        2.0*z_39*z_71 - 2.0*z_38*z_73 - 2.0*z_39*z_74 - 2.0*z_38*z_75 - cos_phi*z_77*c_34 - z_53*z_81);
    const real z_84 = z_32*c_11 - z_30*c_12;
    const real z_85 = z_30*c_11 - z_32*c_10;
    const real z_86 = cos_theta*sin_delta;
    const real z_87 = sin_theta*sin_delta;
    const real z_88 = c_6*z_86 + c_7*z_87;
    const real z_89 = sin_delta*z_88;
    const real z_90 = z_17*z_84 + cos_theta*c_16 - z_12*z_85 - sin_theta*c_18 - c_19*z_89;
    const real z_91 = z_11*z_85 + sin_theta*c_16 - z_12*z_84 - cos_theta*c_15 - c_17*z_89;
    const real z_92 = cos_theta*z_17;
    const real z_93 = sin_theta*z_11;
    const real z_94 = z_29 + z_93;
    const real z_95 = z_31 + z_92;
    const real z_96 = r_R*cos_theta + sin_theta*c_2;
    const real z_97 = r_R - z_96;
    const real z_98 = c_*z_94 + r_F*z_95 + z_97;
    const real z_99 = z_H*z_95 + c_8*z_94 + z_97;
    const real z_100 = c_30*z_98 + c_31*z_99;
    const real z_101 = c_32*z_98 + c_33*z_99;
    const real z_102 = r_R - x_B*sin_theta - c_1*cos_theta;
    const real z_103 = m_F*z_98 + m_H*z_99;
    const real c_40 = c[66];
    const real z_104 = sin_delta*sin_delta;
    const real z_105 = cos_theta*c_34;
    const real z_106 = sin_theta*c_35;
    const real z_107 = sin_theta*c_38;
    const real z_108 = cos_theta*c_39;
    M1[3][3] = 0.5*(2.0*z_92*z_100 + 2.0*z_93*z_101 + 2.0*z_29*z_101 + 2.0*z_31*z_100 + (c_9 + m_B*z_102 +
        z_103)*c_34 - sin_theta*z_90 - cos_theta*z_91 - c_40*z_104 - z_103*z_105 - z_103*z_106 - z_102*z_107 -
        z_102*z_108);
    M1[4][0] = -(sin_theta*z_63 + cos_theta*z_64 + z_6*z_51 + z_4*z_56 + z_4*z_60 - cos_theta*z_66 -
        sin_theta*z_67 - cos_theta*z_68 - z_4*z_52 - sin_theta*z_69 - z_6*z_58 - z_6*z_62);
    M1[4][1] = -(sin_theta*z_51 + cos_theta*z_52 + z_4*z_64 + z_6*z_67 + z_6*z_69 - cos_theta*z_56 -
        sin_theta*z_58 - cos_theta*z_60 - z_6*z_63 - sin_theta*z_62 - z_4*z_66 - z_4*z_68);
    const real z_109 = z_21*c_30 + z_23*c_31;
    const real z_110 = z_21*c_32 + z_23*c_33;
    const real z_111 = z_22 + z_24;
    M1[4][2] = (-0.5)*(z_46 + 2.0*z_6*z_73 + 2.0*z_6*z_75 + z_111*z_105 + z_111*z_106 + z_7*z_107 + z_7*z_108 +
        z_4*z_78 + z_4*z_83 - 2.0*z_109*z_92 - 2.0*z_110*z_93 - 2.0*z_29*z_110 - 2.0*z_31*z_109 - 2.0*z_4*z_71 -
        2.0*z_4*z_74 - z_6*z_79 - z_6*z_82);
    const real c_41 = c[67];
    const real c_42 = c[68];
    const real c_43 = c[69];
    const real c_44 = c[70];
    M1[4][3] = (-0.5)*(z_85*z_15 + z_84*z_18 + z_88*z_45 + c_44*z_86 + z_17*c_43*z_87 + z_12*c_42*z_87 - c_41*z_87
        - z_11*c_42*z_86 - z_12*c_43*z_86);
    const real z_112 = c_*z_12;
    const real z_113 = r_F*z_17;
    const real z_114 = r_R - z_112 - z_113;
    const real z_115 = r_R - z_17*z_H - z_12*c_8;
    const real z_116 = c_30*z_114 + c_31*z_115;
    const real z_117 = c_*z_11;
    const real z_118 = z_12*r_F;
    const real z_119 = c_2 - z_117 - z_118;
    const real z_120 = c_2 - z_12*z_H - z_11*c_8;
    const real z_121 = c_32*z_119 + c_33*z_120;
    const real z_122 = c_32*z_114 + c_33*z_115;
    const real z_123 = c_30*z_119 + c_31*z_120;
    const real c_45 = c[71];
    const real c_46 = c[72];
    M1[4][4] = 0.5*(c_45*z_104 + c_46 + (m_F*z_114 + m_H*z_115)*c_34 + c_13*(cos_delta*cos_delta) + (m_F*z_119 +
        m_H*z_120)*c_35 - 2.0*z_17*z_116 - 2.0*z_11*z_121 - 2.0*z_12*z_122 - 2.0*z_12*z_123);
    const real c_47 = c[73];
    const real z_124 = cos_psi*c_47;
    const real z_125 = cos_delta*cos_phi;
    const real c_48 = c[74];
    const real z_126 = cos_psi*c_48;
    const real z_127 = sin_delta*z_6;
    const real z_128 = sin_psi*c_48;
    const real z_129 = sin_delta*z_4;
    const real z_130 = sin_psi*c_47;
    M1[5][0] = z_86*z_124 + z_125*z_54 - z_87*z_126 - z_127*z_128 - z_129*z_130;
    M1[5][1] = z_86*z_130 + z_129*z_124 + z_127*z_126 - z_87*z_128 - z_125*z_65;
    const real c_49 = c[75];
    const real c_50 = c[76];
    const real c_51 = c[77];
    M1[5][2] = 0.5*(c_7*z_42 + z_110*c_49*z_86 + z_125*z_81 + z_72*c_49*z_129 + z_70*c_50*z_127 + z_110*c_51*z_87
        - c_6*z_43 - z_109*c_50*z_87 - z_125*z_80 - z_109*c_51*z_86 - z_72*c_51*z_127 - z_70*c_51*z_129);
    const real c_52 = c[78];
    const real c_53 = c[79];
    M1[5][3] = 0.5*(c_7*z_85 + cos_delta*z_101*c_36 - c_6*z_84 - c_52*(cos_theta*z_104) - c_53*(sin_theta*z_104) -
        cos_delta*z_100*c_37);
    const real c_54 = c[80];
    const real z_131 = sin_delta*c_51;
    M1[5][4] = (-0.5)*(sin_delta*c_54 + sin_delta*z_122*c_49 + z_121*z_131 - sin_delta*z_123*c_50 - z_116*z_131);
    const real c_55 = c[81];
    M1[5][5] = c_55;
    M1[6][0] = em_real(0.0);
    M1[6][1] = em_real(0.0);
    const real R_yy = c[15];
    M1[6][2] = sin_phi*R_yy;
    M1[6][3] = em_real(0.0);
    M1[6][4] = R_yy;
    M1[6][5] = em_real(0.0);
    M1[6][6] = R_yy;
    M1[7][0] = em_real(0.0);
    M1[7][1] = em_real(0.0);
    const real F_yy = c[17];
    M1[7][2] = F_yy*z_44;
    M1[7][3] = -F_yy*z_88;
    M1[7][4] = cos_delta*F_yy;
    M1[7][5] = em_real(0.0);
    M1[7][6] = em_real(0.0);
    M1[7][7] = F_yy;
    shared[0] = cos_psi;
    shared[1] = cos_phi;
    shared[2] = z_38;
    shared[3] = z_6;
    shared[4] = z_39;
    shared[5] = z_4;
    shared[6] = z_7;
    shared[7] = sin_psi;
    shared[8] = z_21;
    shared[9] = sin_delta;
    shared[10] = z_11;
    shared[11] = z_12;
    shared[12] = cos_delta;
    shared[13] = sin_phi;
    shared[14] = z_17;
    shared[15] = z_23;
    shared[16] = sin_theta;
    shared[17] = cos_theta;
    shared[18] = z_26;
    shared[19] = z_33;
    shared[20] = z_35;
    shared[21] = z_46;
    shared[22] = z_42;
    shared[23] = z_43;
    shared[24] = z_44;
    shared[25] = z_48;
    shared[26] = z_49;
    shared[27] = z_53;
    shared[28] = z_56;
    shared[29] = z_55;
    shared[30] = z_58;
    shared[31] = z_57;
    shared[32] = z_60;
    shared[33] = z_59;
    shared[34] = z_62;
    shared[35] = z_61;
    shared[36] = z_66;
    shared[37] = z_67;
    shared[38] = z_68;
    shared[39] = z_69;
    shared[40] = z_77;
    shared[41] = z_76;
    shared[42] = z_72;
    shared[43] = z_71;
    shared[44] = z_70;
    shared[45] = z_73;
    shared[46] = z_74;
    shared[47] = z_75;
    shared[48] = z_90;
    shared[49] = z_84;
    shared[50] = z_85;
    shared[51] = z_88;
    shared[52] = z_91;
    shared[53] = z_100;
    shared[54] = z_92;
    shared[55] = z_101;
    shared[56] = z_93;
    shared[57] = z_29;
    shared[58] = z_31;
    shared[59] = z_103;
    shared[60] = z_102;
    shared[61] = z_109;
    shared[62] = z_110;
    shared[63] = z_111;
    shared[64] = z_104;
    shared[65] = z_116;
    shared[66] = z_121;
    shared[67] = z_122;
    shared[68] = z_123;
    shared[69] = z_86;
    shared[70] = z_125;
    shared[71] = z_87;
    shared[72] = z_127;
    shared[73] = z_129;
    shared[74] = z_18;
    shared[75] = z_15;
    shared[76] = z_106;
    shared[77] = z_105;
    shared[78] = z_108;
    shared[79] = z_107;
    shared[80] = z_97;
    shared[81] = z_117;
    shared[82] = z_112;
    shared[83] = z_113;
    shared[84] = z_118;
    shared[85] = z_19;
    shared[86] = z_41;
    shared[87] = z_16;
    shared[88] = z_40;
    shared[89] = z_20;
    shared[90] = z_96;
    shared[91] = z_32;
    shared[92] = z_30;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_BY_ITSELF void triangular_motion(const real *restrict v, const real *restrict c, const real shared[93],
                                    real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real m_B = c[7];
    const real cos_psi = shared[0];
    const real r_R = c[4];
    const real phi_dot = v[3];
    const real cos_phi = shared[1];
    const real z_132 = phi_dot*cos_phi;
    const real z_133 = r_R*z_132;
    const real x_B = c[10];
    const real z_38 = shared[2];
    const real z_134 = phi_dot*z_38;
    const real theta_dot = v[4];
    const real z_6 = shared[3];
    const real z_135 = theta_dot*z_6;
    const real z_136 = z_134 + z_135;
    const real c_1 = c[27];
    const real z_39 = shared[4];
    const real z_137 = phi_dot*z_39;
    const real z_4 = shared[5];
    const real z_138 = theta_dot*z_4;
    const real z_139 = z_137 - z_138;
    const real z_140 = z_133 - x_B*z_136 - c_1*z_139;
    const real z_7 = shared[6];
    const real psi_dot = v[2];
    const real sin_psi = shared[7];
    const real z_141 = psi_dot*sin_psi;
    const real m_F = c[9];
    const real z_21 = shared[8];
    const real c_2 = c[28];
    const real z_142 = c_2*z_136 - (z_133 - r_R*z_139);
    const real c_ = c[1];
    const real c_4 = c[30];
    const real delta_dot = v[5];
    const real sin_delta = shared[9];
    const real z_143 = delta_dot*sin_delta;
    const real z_144 = c_4*z_143;
    const real z_11 = shared[10];
    const real z_145 = z_4*z_144 - (z_11*z_134 + z_11*z_135);
    const real c_5 = c[31];
    const real z_146 = c_5*z_143;
    const real z_12 = shared[11];
    const real z_147 = z_6*z_146 + (z_12*z_137 - z_12*z_138);
    const real c_6 = c[32];
    const real cos_delta = shared[12];
    const real z_148 = delta_dot*cos_delta;
    const real z_149 = cos_phi*z_148;
    const real sin_phi = shared[13];
    const real z_150 = phi_dot*sin_delta;
    const real z_151 = sin_phi*z_150;
    const real z_152 = z_149 - z_151;
    const real z_153 = (-z_145) + z_147 + c_6*z_152;
    const real r_F = c[5];
    const real c_7 = c[33];
    const real c_3 = c[29];
    const real z_154 = c_3*z_143;
    const real z_17 = shared[14];
    const real z_155 = (z_6*z_154 + (z_17*z_138 - z_17*z_137)) - (z_4*z_146 + (z_12*z_134 + z_12*z_135));
    const real z_156 = c_7*z_152 + z_155;
    const real z_157 = z_142 - (c_*z_153 - r_F*z_156);
    const real z_158 = -z_157;
    const real m_H = c[8];
    const real z_23 = shared[15];
    const real z_H = c[13];
    const real c_8 = c[34];
    const real z_159 = c_8*z_153 - z_H*z_156 - z_142;
    const real sin_theta = shared[16];
    const real z_160 = theta_dot*sin_theta;
    const real cos_theta = shared[17];
    const real z_161 = theta_dot*cos_theta;
    const real z_162 = x_B*z_160 + c_1*z_161;
    const real z_26 = shared[18];
    const real z_163 = psi_dot*cos_psi;
    const real z_33 = shared[19];
    const real z_164 = r_R*z_161 + c_2*z_160;
    const real z_165 = sin_theta*z_143;
    const real z_166 = z_12*z_160;
    const real z_167 = cos_theta*z_146;
    const real z_168 = z_166 - z_167;
    const real z_169 = (z_17*z_161 - c_3*z_165) + z_168;
    const real z_170 = z_169;
    const real z_171 = cos_theta*z_143;
    const real z_172 = z_12*z_161;
    const real z_173 = sin_theta*z_146;
    const real z_174 = z_172 + z_173;
    const real z_175 = (z_11*z_160 + c_4*z_171) + z_174;
    const real z_176 = z_175;
    const real z_177 = z_164 - (r_F*z_170 + c_*z_176);
    const real z_35 = shared[20];
    const real z_178 = z_164 - z_H*z_170 - c_8*z_176;
    const real c_9 = c[35];
    Mdot1[0][2] = Mdot1[2][0] = m_B*(cos_psi*z_140 - z_7*z_141) + m_B*(sin_psi*z_162 - z_26*z_163) +
        c_9*(cos_psi*z_132 - sin_phi*z_141) - m_F*(z_21*z_141 - cos_psi*z_158) - m_H*(z_23*z_141 - cos_psi*z_159)
        - m_F*(z_33*z_163 - sin_psi*z_177) - m_H*(z_35*z_163 - sin_psi*z_178);
    Mdot1[1][2] = Mdot1[2][1] = -(m_B*(z_26*z_141 + cos_psi*z_162) + m_F*(z_33*z_141 + cos_psi*z_177) +
        m_H*(z_35*z_141 + cos_psi*z_178) - m_B*(sin_psi*z_140 + z_7*z_163) - m_F*(sin_psi*z_158 + z_21*z_163) -
        m_H*(sin_psi*z_159 + z_23*z_163) - c_9*(sin_psi*z_132 + sin_phi*z_163));
    const real z_46 = shared[21];
    const real z_42 = shared[22];
    const real c_10 = c[36];
    const real z_179 = sin_phi*z_148;
    const real z_180 = cos_phi*z_150;
    const real z_181 = z_179 + z_180;
    const real z_182 = phi_dot*z_4;
    const real z_183 = theta_dot*z_39;
    const real z_184 = z_38*z_144 + (z_11*z_182 - z_11*z_183);
    const real z_185 = phi_dot*z_6;
    const real z_186 = theta_dot*z_38;
    const real z_187 = z_39*z_146 - (z_12*z_185 + z_12*z_186);
    const real z_188 = c_6*z_181 + z_184 + (-z_187);
    const real z_189 = (z_39*z_154 + (z_17*z_185 + z_17*z_186)) - (z_38*z_146 + (z_12*z_183 - z_12*z_182));
    const real z_190 = z_189 - c_7*z_181;
    const real c_11 = c[37];
    const real z_191 = c_10*z_188 + z_190*c_11;
    const real z_43 = shared[23];
    const real c_12 = c[38];
    const real z_192 = c_12*z_190 + z_188*c_11;
    const real c_56 = c[82];
    const real z_44 = shared[24];
    const real z_193 = sin_phi*z_143;
    const real z_194 = (cos_delta*z_132 - z_193) + c_6*(sin_delta*z_183 + z_38*z_148 - z_4*z_150) +
        c_7*(sin_delta*z_186 + z_6*z_150 - z_39*z_148);
    const real c_14 = c[40];
    const real z_195 = (c_6*(z_42*z_148 - sin_delta*z_191) + c_7*(z_43*z_148 + sin_delta*z_192)) +
        2.0*(c_56*(z_44*z_143 - cos_delta*z_194) - 0.5*c_14*z_132);
    const real z_48 = shared[25];
    const real B_xz = c[21];
    const real z_196 = z_185 + z_186;
    const real c_57 = c[83];
    const real z_197 = z_44*z_148 + sin_delta*z_194;
    const real c_15 = c[41];
    const real z_198 = z_183 - z_182;
    const real z_199 = (z_42*z_144 + z_11*z_191) + (z_43*z_146 + z_12*z_192) + 2.0*B_xz*z_196 - 2.0*c_57*z_197 -
        c_15*z_198;
    const real z_49 = shared[26];
    const real c_58 = c[84];
    const real c_18 = c[44];
    const real z_200 = (z_42*z_146 - z_12*z_191) + (z_43*z_154 - z_17*z_192) + 2.0*B_xz*z_198 - 2.0*c_58*z_197 -
        c_18*z_196;
    const real c_59 = c[85];
    const real c_60 = c[86];
    const real c_61 = c[87];
    const real c_62 = c[88];
    const real z_201 = phi_dot*sin_phi;
    Mdot1[2][2] = (-0.5)*((z_46*z_132 + sin_phi*z_195) + (z_49*z_186 + z_49*z_185 - z_200*z_39) + z_26*z_162*c_59
        + z_33*z_177*c_60 + z_35*z_178*c_61 - (z_48*z_183 - z_48*z_182 - z_199*z_38) - z_7*z_140*c_59 -
        z_21*z_158*c_60 - z_23*z_159*c_61 - c_62*(cos_phi*z_201));
    const real c_24 = c[50];
    const real c_25 = c[51];
    const real z_202 = z_38*z_163;
    const real c_26 = c[52];
    const real z_203 = z_39*z_163;
    const real c_27 = c[53];
    const real z_53 = shared[27];
    const real z_56 = shared[28];
    const real z_204 = sin_psi*z_143;
    const real c_63 = c[89];
    const real z_205 = c_63*z_39;
    const real z_55 = shared[29];
    const real z_58 = shared[30];
    const real c_64 = c[90];
    const real z_206 = c_64*z_38;
    const real z_57 = shared[31];
    const real z_60 = shared[32];
    const real c_65 = c[91];
    const real z_207 = c_65*z_39;
    const real z_59 = shared[33];
    const real z_62 = shared[34];
    const real c_66 = c[92];
    const real z_208 = c_66*z_38;
    const real z_61 = shared[35];
    Mdot1[0][3] = Mdot1[3][0] = -(c_24*(sin_psi*z_201 - cos_phi*z_163) + c_25*(sin_psi*z_183 + z_202 -
        sin_psi*z_182) + c_27*(sin_psi*z_180 + sin_psi*z_179 + z_163*z_53) + (z_186*z_56 + z_185*z_56 +
        z_204*z_205 - z_203*z_55) + (z_186*z_60 + z_185*z_60 - z_204*z_207 - z_203*z_59) - c_26*(sin_psi*z_186 +
        sin_psi*z_185 - z_203) - (z_183*z_58 + z_202*z_57 - z_204*z_206 - z_182*z_58) - (z_183*z_62 + z_204*z_208
        + z_202*z_61 - z_182*z_62));
    const real z_209 = z_38*z_141;
    const real z_210 = z_39*z_141;
    const real z_66 = shared[36];
    const real z_211 = cos_psi*z_143;
    const real z_67 = shared[37];
    const real z_68 = shared[38];
    const real z_69 = shared[39];
    Mdot1[1][3] = Mdot1[3][1] = c_25*(cos_psi*z_183 - z_209 - cos_psi*z_182) + c_27*(cos_psi*z_180 + cos_psi*z_179
        - z_141*z_53) + c_24*(cos_phi*z_141 + cos_psi*z_201) + (z_186*z_66 + z_210*z_55 + z_185*z_66 +
        z_211*z_205) + (z_186*z_68 + z_210*z_59 + z_185*z_68 - z_211*z_207) - c_26*(cos_psi*z_186 + z_210 +
        cos_psi*z_185) - (z_183*z_67 - z_209*z_57 - z_211*z_206 - z_182*z_67) - (z_183*z_69 + z_211*z_208 -
        z_209*z_61 - z_182*z_69);
    const real z_77 = shared[40];
    const real z_212 = m_F*z_177 + m_H*z_178;
    const real z_76 = shared[41];
    const real z_72 = shared[42];
    const real c_32 = c[58];
    const real c_33 = c[59];
    const real z_213 = c_32*z_177 + c_33*z_178;
    const real z_71 = shared[43];
    const real z_70 = shared[44];
    const real z_214 = z_70*z_154;
    const real c_30 = c[56];
    const real c_31 = c[57];
    const real z_215 = c_30*z_177 + c_31*z_178;
    const real z_216 = z_17*z_215;
    const real z_73 = shared[45];
    const real z_217 = z_72*z_144;
    const real z_218 = z_11*z_213;
    const real z_74 = shared[46];
    const real z_219 = z_72*z_146;
    const real z_220 = z_12*z_213;
    const real z_75 = shared[47];
    const real z_221 = z_70*z_146;
    const real z_222 = z_12*z_215;
    const real c_67 = c[93];
    const real c_68 = c[94];
    Mdot1[2][3] = Mdot1[3][2] = 0.5*((z_49*z_161 + sin_theta*z_200) + (z_48*z_160 + cos_theta*z_199) +
        2.0*r_R*(z_77*z_201 + cos_phi*(m_B*z_162 + z_212)) + 2.0*c_2*(z_76*z_183 - z_76*z_182 - z_212*z_38) +
        2.0*c_6*(z_72*z_180 + z_72*z_179 - z_213*z_53) + 2.0*(z_186*z_71 + z_185*z_71 + z_39*z_214 + z_39*z_216) +
        2.0*(z_186*z_74 + z_185*z_74 + z_39*z_220 - z_39*z_219) + 2.0*c_67*(z_26*z_183 - z_26*z_182 - z_162*z_38)
        - 2.0*r_R*(z_76*z_186 + z_76*z_185 + z_212*z_39) - 2.0*(z_183*z_73 - z_38*z_217 - z_182*z_73 - z_38*z_218)
        - 2.0*(z_183*z_75 + z_38*z_221 - z_182*z_75 - z_38*z_222) - 2.0*c_7*(z_70*z_180 + z_70*z_179 - z_215*z_53)
        - 2.0*c_68*(z_26*z_186 + z_26*z_185 + z_162*z_39));
    const real z_90 = shared[48];
    const real z_84 = shared[49];
    const real z_223 = c_12*z_170 + z_176*c_11;
    const real z_85 = shared[50];
    const real z_224 = c_10*z_176 + z_170*c_11;
    const real z_88 = shared[51];
    const real z_225 = sin_delta*z_160;
    const real z_226 = cos_theta*z_148;
    const real z_227 = z_225 - z_226;
    const real z_228 = sin_delta*z_161;
    const real z_229 = sin_theta*z_148;
    const real z_230 = z_228 + z_229;
    const real z_231 = c_6*z_227 - c_7*z_230;
    const real z_232 = z_88*z_148 - sin_delta*z_231;
    const real c_16 = c[42];
    const real z_91 = shared[52];
    const real z_100 = shared[53];
    const real z_233 = z_17*z_160;
    const real z_234 = c_3*z_171;
    const real z_92 = shared[54];
    const real z_235 = z_11*z_161;
    const real z_236 = c_4*z_165;
    const real z_237 = z_168 - (z_235 - z_236);
    const real z_238 = z_174 - (z_233 + z_234);
    const real z_239 = r_R*z_160 - c_2*z_161;
    const real z_240 = r_F*z_238 + z_239 - c_*z_237;
    const real z_241 = z_H*z_238 + z_239 - c_8*z_237;
    const real z_242 = c_30*z_240 + c_31*z_241;
    const real z_101 = shared[55];
    const real z_93 = shared[56];
    const real z_243 = c_32*z_240 + c_33*z_241;
    const real z_29 = shared[57];
    const real z_31 = shared[58];
    const real z_103 = shared[59];
    const real z_244 = m_F*z_240 + m_H*z_241;
    const real z_102 = shared[60];
    const real z_245 = c_1*z_160 - x_B*z_161;
    const real c_34 = c[60];
    const real c_69 = c[95];
    const real z_246 = cos_delta*z_143;
    Mdot1[3][3] = 0.5*((z_91*z_160 + cos_theta*((z_85*z_144 - z_11*z_224) + (z_84*z_146 - z_12*z_223) +
        2.0*c_57*z_232 - c_15*z_160 - c_16*z_161)) + 2.0*(z_101*z_235 + z_93*z_243 - z_101*z_236) +
        2.0*(z_100*z_172 + z_100*z_173 + z_31*z_242) + 2.0*r_R*(z_103*z_160 - cos_theta*z_244) +
        2.0*c_68*(z_102*z_160 - cos_theta*z_245) + (m_B*z_245 + z_244)*c_34 - (z_90*z_161 - sin_theta*((z_84*z_154
        + z_17*z_223) + (z_85*z_146 + z_12*z_224) + 2.0*c_58*z_232 + c_18*z_161 + c_16*z_160)) - 2.0*(z_100*z_233
        + z_100*z_234 - z_92*z_242) - 2.0*(z_101*z_166 - z_101*z_167 - z_29*z_243) - 2.0*c_2*(z_103*z_161 +
        sin_theta*z_244) - 2.0*c_67*(z_102*z_161 + sin_theta*z_245) - c_69*z_246);
    const real z_247 = sin_theta*z_141;
    const real z_248 = cos_theta*z_141;
    const real z_249 = cos_psi*z_171;
    const real z_250 = cos_psi*z_165;
    const real z_251 = z_4*z_163;
    const real z_252 = z_6*z_163;
    const real z_253 = c_64*z_6;
    const real z_254 = c_66*z_6;
    const real z_255 = c_63*z_4;
    const real z_256 = c_65*z_4;
    Mdot1[0][4] = Mdot1[4][0] = -(c_25*(cos_psi*z_161 - z_247) + (z_160*z_66 + z_248*z_55 + c_63*z_249) +
        (z_160*z_68 + z_248*z_59 - c_65*z_249) + c_25*(sin_psi*z_137 + z_252 - sin_psi*z_138) + (z_134*z_56 +
        z_135*z_56 + z_251*z_55 - z_204*z_255) + (z_134*z_60 + z_135*z_60 + z_204*z_256 + z_251*z_59) -
        c_26*(cos_psi*z_160 + z_248) - (z_161*z_67 - z_247*z_57 - c_64*z_250) - c_26*(sin_psi*z_134 +
        sin_psi*z_135 + z_251) - (z_161*z_69 + c_66*z_250 - z_247*z_61) - (z_137*z_58 + z_252*z_57 - z_138*z_58 -
        z_204*z_253) - (z_137*z_62 + z_204*z_254 + z_252*z_61 - z_138*z_62));
    const real z_257 = sin_theta*z_163;
    const real z_258 = cos_theta*z_163;
    const real z_259 = sin_psi*z_171;
    const real z_260 = sin_psi*z_165;
    const real z_261 = z_6*z_141;
    const real z_262 = z_4*z_141;
    Mdot1[1][4] = Mdot1[4][1] = -(c_25*(sin_psi*z_161 + z_257) + (z_160*z_56 + c_63*z_259 - z_258*z_55) +
        (z_160*z_60 - c_65*z_259 - z_258*z_59) + c_26*(cos_psi*z_134 + cos_psi*z_135 - z_262) + (z_137*z_67 -
        z_138*z_67 - z_261*z_57 - z_211*z_253) + (z_137*z_69 + z_211*z_254 - z_138*z_69 - z_261*z_61) -
        c_26*(sin_psi*z_160 - z_258) - (z_161*z_58 + z_257*z_57 - c_64*z_260) - c_25*(cos_psi*z_137 -
        cos_psi*z_138 - z_261) - (z_161*z_62 + c_66*z_260 + z_257*z_61) - (z_134*z_66 + z_135*z_66 - z_262*z_55 -
        z_211*z_255) - (z_134*z_68 + z_135*z_68 + z_211*z_256 - z_262*z_59));
    const real z_109 = shared[61];
    const real z_263 = c_30*z_158 + c_31*z_159;
    const real z_110 = shared[62];
    const real z_264 = c_32*z_158 + c_33*z_159;
    const real z_111 = shared[63];
    const real z_265 = m_F*z_158 + m_H*z_159;
    Mdot1[2][4] = Mdot1[4][2] = (-0.5)*(z_195 + 2.0*(z_109*z_233 + z_109*z_234 - z_92*z_263) + 2.0*(z_110*z_166 -
        z_110*z_167 - z_29*z_264) + 2.0*c_2*(z_111*z_161 + sin_theta*z_265) + 2.0*c_67*(z_7*z_161 +
        sin_theta*z_140) + 2.0*r_R*(z_76*z_134 + z_76*z_135 - z_212*z_4) + 2.0*(z_137*z_73 - z_138*z_73 -
        z_6*z_217 - z_6*z_218) + 2.0*(z_137*z_75 + z_6*z_221 - z_138*z_75 - z_6*z_222) + 2.0*c_68*(z_26*z_134 +
        z_26*z_135 - z_162*z_4) - 2.0*(z_110*z_235 + z_93*z_264 - z_110*z_236) - 2.0*(z_109*z_172 + z_109*z_173 +
        z_31*z_263) - 2.0*r_R*(z_111*z_160 - cos_theta*z_265) - 2.0*c_2*(z_76*z_137 - z_76*z_138 - z_212*z_6) -
        2.0*(z_134*z_71 + z_135*z_71 - z_4*z_214 - z_4*z_216) - 2.0*(z_134*z_74 + z_135*z_74 + z_4*z_219 -
        z_4*z_220) - 2.0*c_68*(z_7*z_160 - cos_theta*z_140) - 2.0*c_67*(z_26*z_137 - z_26*z_138 - z_162*z_6));
    const real c_70 = c[96];
    const real c_71 = c[97];
    const real z_266 = z_11*c_71;
    const real c_72 = c[98];
    const real z_104 = shared[64];
    const real z_267 = delta_dot*z_104;
    const real z_268 = cos_theta*z_267;
    const real c_73 = c[99];
    const real z_269 = z_12*c_73;
    const real c_74 = c[100];
    const real c_75 = c[101];
    const real z_270 = z_17*c_73;
    const real c_76 = c[102];
    const real z_271 = sin_theta*z_267;
    const real z_272 = z_12*c_71;
    const real c_77 = c[103];
    Mdot1[3][4] = Mdot1[4][3] = 0.5*(2.0*c_56*(z_88*z_143 + cos_delta*z_231) + 2.0*c_70*z_230 + 2.0*c_75*z_227 -
        c_6*(z_85*z_148 + sin_delta*z_224) - c_7*(z_84*z_148 - sin_delta*z_223) - 2.0*(z_225*z_266 + c_72*z_268 -
        z_226*z_266) - 2.0*(z_225*z_269 - c_74*z_268 - z_226*z_269) - 2.0*(z_228*z_270 + z_229*z_270 - c_76*z_271)
        - 2.0*(z_228*z_272 + c_77*z_271 + z_229*z_272));
    const real z_116 = shared[65];
    const real c_78 = c[104];
    const real z_121 = shared[66];
    const real c_79 = c[105];
    const real z_122 = shared[67];
    const real c_80 = c[106];
    const real z_273 = z_12*z_143;
    const real z_123 = shared[68];
    const real c_81 = c[107];
    const real c_82 = c[108];
    const real c_83 = c[109];
    Mdot1[4][4] = (z_116*z_154 - z_17*c_78*z_143) + (z_121*z_144 - z_11*c_79*z_143) + c_82*z_143 - (z_122*z_146 +
        c_80*z_273) - (z_123*z_146 + c_81*z_273) - c_83*z_246;
    const real c_47 = c[73];
    const real z_86 = shared[69];
    const real z_274 = cos_phi*z_143;
    const real z_275 = cos_delta*z_201;
    const real z_125 = shared[70];
    const real c_48 = c[74];
    const real z_87 = shared[71];
    const real z_276 = z_39*z_150;
    const real z_277 = sin_delta*z_138;
    const real z_278 = z_6*z_148;
    const real z_127 = shared[72];
    const real z_279 = z_38*z_150;
    const real z_280 = sin_delta*z_135;
    const real z_281 = z_4*z_148;
    const real z_129 = shared[73];
    Mdot1[0][5] = Mdot1[5][0] = -(c_47*(cos_psi*z_225 + z_141*z_86 - cos_psi*z_226) + c_27*(sin_psi*z_274 +
        sin_psi*z_275 - z_125*z_163) + c_48*(cos_psi*z_228 + cos_psi*z_229 - z_141*z_87) + c_48*(sin_psi*z_276 +
        sin_psi*z_278 + z_163*z_127 - sin_psi*z_277) + c_47*(sin_psi*z_279 + sin_psi*z_280 + sin_psi*z_281 +
        z_163*z_129));
    Mdot1[1][5] = Mdot1[5][1] = -(c_47*(sin_psi*z_225 - sin_psi*z_226 - z_163*z_86) + c_48*(sin_psi*z_228 +
        sin_psi*z_229 + z_163*z_87) - c_27*(z_125*z_141 + cos_psi*z_274 + cos_psi*z_275) - c_47*(cos_psi*z_279 +
        cos_psi*z_280 + cos_psi*z_281 - z_141*z_129) - c_48*(cos_psi*z_276 + cos_psi*z_278 - cos_psi*z_277 -
        z_141*z_127));
    Mdot1[2][5] = Mdot1[5][2] = (-0.5)*(c_7*z_191 + c_6*z_192 + 2.0*c_4*(z_110*z_225 - z_110*z_226 - z_264*z_86) +
        2.0*c_7*(z_70*z_274 + z_70*z_275 + z_125*z_215) + 2.0*c_3*(z_109*z_228 + z_109*z_229 + z_263*z_87) +
        2.0*c_5*(z_72*z_276 + z_72*z_278 - z_72*z_277 - z_213*z_127) + 2.0*c_5*(z_70*z_279 + z_70*z_280 +
        z_70*z_281 - z_215*z_129) - 2.0*c_6*(z_72*z_274 + z_72*z_275 + z_125*z_213) - 2.0*c_4*(z_72*z_279 +
        z_72*z_280 + z_72*z_281 - z_213*z_129) - 2.0*c_3*(z_70*z_276 + z_70*z_278 - z_70*z_277 - z_215*z_127) -
        2.0*c_5*(z_110*z_228 + z_110*z_229 + z_264*z_87) - 2.0*c_5*(z_109*z_225 - z_109*z_226 - z_263*z_86));
    const real c_84 = c[110];
    const real c_85 = c[111];
    Mdot1[3][5] = Mdot1[5][3] = 0.5*(c_7*z_224 + c_6*z_223 + 2.0*c_84*(z_104*z_160 - 2.0*cos_delta*z_171) +
        2.0*c_7*(z_100*z_143 - cos_delta*z_242) - 2.0*c_6*(z_101*z_143 - cos_delta*z_243) - 2.0*c_85*(z_104*z_161
        + 2.0*cos_delta*z_165));
    const real c_54 = c[80];
    const real c_86 = c[112];
    const real c_87 = c[113];
    const real z_282 = c_5*z_148;
    const real c_88 = c[114];
    const real c_89 = c[115];
    Mdot1[4][5] = Mdot1[5][4] = (-0.5)*(c_54*z_148 + 2.0*(z_148*(c_4*z_122) + c_87*z_267) + 2.0*(z_121*z_282 +
        c_89*z_267) - 2.0*(z_148*(c_3*z_123) + c_86*z_267) - 2.0*(z_116*z_282 + c_88*z_267));
    Mdot1[5][5] = em_real(0.0);
    Mdot1[0][6] = Mdot1[6][0] = em_real(0.0);
    Mdot1[1][6] = Mdot1[6][1] = em_real(0.0);
    const real R_yy = c[15];
    Mdot1[2][6] = Mdot1[6][2] = R_yy*z_132;
    Mdot1[3][6] = Mdot1[6][3] = em_real(0.0);
    Mdot1[4][6] = Mdot1[6][4] = em_real(0.0);
    Mdot1[5][6] = Mdot1[6][5] = em_real(0.0);
    Mdot1[6][6] = em_real(0.0);
    Mdot1[0][7] = Mdot1[7][0] = em_real(0.0);
    Mdot1[1][7] = Mdot1[7][1] = em_real(0.0);
    const real F_yy = c[17];
    Mdot1[2][7] = Mdot1[7][2] = F_yy*z_194;
    Mdot1[3][7] = Mdot1[7][3] = F_yy*z_231;
    Mdot1[4][7] = Mdot1[7][4] = -F_yy*z_143;
    Mdot1[5][7] = Mdot1[7][5] = em_real(0.0);
    Mdot1[6][7] = Mdot1[7][6] = em_real(0.0);
    Mdot1[7][7] = em_real(0.0);
    f1[0] = em_real(0.0);
    f1[1] = em_real(0.0);
    const real x_dot = v[0];
    const real m_R = c[6];
    const real y_dot = v[1];
    const real z_283 = z_133 - (y_dot*cos_psi - x_dot*sin_psi);
    const real z_284 = c_7*z_148;
    const real z_285 = cos_phi*z_284 + z_155 - c_7*z_151;
    const real z_286 = c_6*z_148;
    const real z_287 = cos_phi*z_286 + z_147 - c_6*z_151 - z_145;
    const real z_288 = (c_2*z_135 - r_R*z_138) - (z_283 - (r_R*z_137 + c_2*z_134));
    const real z_289 = psi_dot*z_35 + z_H*z_285 + z_288 - c_8*z_287;
    const real z_290 = psi_dot*z_33 + r_F*z_285 + z_288 - c_*z_287;
    const real z_291 = m_H*z_289 + m_F*z_290;
    const real z_292 = psi_dot*z_26 + x_B*z_134 + c_1*z_137 + x_B*z_135 - c_1*z_138 - z_283;
    const real z_293 = m_R*(-z_283) + z_291 + m_B*z_292;
    const real z_294 = psi_dot*sin_phi;
    const real z_295 = x_dot*cos_psi + y_dot*sin_psi;
    const real z_296 = r_R*z_294 + z_295;
    const real z_297 = z_164 - z_295;
    const real z_298 = psi_dot*z_23 + z_H*z_169 + c_8*z_175 - z_297;
    const real z_299 = psi_dot*z_21 + c_*z_175 + r_F*z_169 - z_297;
    const real z_300 = m_H*z_298 + m_F*z_299;
    const real z_301 = psi_dot*z_7 + z_295 - z_162;
    const real z_302 = m_R*z_296 + z_300 + m_B*z_301;
    f1[2] = -(cos_psi*(x_dot*z_293 - y_dot*z_302) + sin_psi*(y_dot*z_293 + x_dot*z_302));
    const real z_303 = phi_dot*cos_theta;
    const real z_304 = c_33*z_289 + c_32*z_290;
    const real z_305 = z_12*z_304;
    const real z_306 = phi_dot*sin_theta;
    const real z_307 = z_11*z_304;
    const real z_308 = c_31*z_289 + c_30*z_290;
    const real z_309 = z_12*z_308;
    const real z_310 = z_17*z_308;
    const real z_311 = sin_phi*z_286 + c_6*z_180 + z_184 - z_187;
    const real z_312 = sin_phi*z_284 + c_7*z_180 - z_189;
    const real z_313 = r_R*z_201;
    const real z_314 = (r_R*z_185 + c_2*z_182) + (r_R*z_186 - (z_313 + c_2*z_183));
    const real z_315 = c_8*z_311 - z_H*z_312 - z_314;
    const real z_316 = c_*z_311 - r_F*z_312 - z_314;
    const real z_317 = c_31*z_315 + c_30*z_316;
    const real z_318 = c_33*z_315 + c_32*z_316;
    const real z_319 = z_306 + psi_dot*z_39;
    const real z_320 = B_xz*z_319;
    const real B_xx = c[18];
    const real z_321 = z_303 - psi_dot*z_38;
    const real H_xz = c[25];
    const real z_322 = theta_dot + z_294;
    const real z_18 = shared[74];
    const real z_323 = delta_dot*c_6 + z_17*z_319 + z_322*z_18 - z_12*z_321;
    const real z_324 = H_xz*z_323;
    const real H_xx = c[22];
    const real z_15 = shared[75];
    const real z_325 = z_11*z_321 + z_322*z_15 - delta_dot*c_7 - z_12*z_319;
    const real c_90 = c[116];
    const real z_326 = z_324 - (H_xx*z_325 - z_324) - c_90*z_325;
    const real z_327 = H_xz*z_325;
    const real H_zz = c[24];
    const real c_91 = c[117];
    const real z_328 = z_327 - (H_zz*z_323 - z_327) - c_91*z_323;
    const real c_92 = c[118];
    const real c_36 = c[62];
    const real H_yy = c[23];
    const real z_329 = z_319*z_18 - (cos_delta*z_322 - z_321*z_15);
    const real spin_f_dot = v[7];
    const real z_330 = H_yy*(-z_329) + F_yy*(spin_f_dot - z_329);
    const real z_331 = sin_delta*z_330;
    const real z_332 = z_320 + z_11*z_326 + c_36*z_331 - (B_xx*z_321 - z_320) - z_12*z_328 - c_92*z_321;
    const real z_333 = B_xz*z_321;
    const real B_zz = c[20];
    const real c_93 = c[119];
    const real c_37 = c[63];
    const real z_334 = z_333 + z_17*z_328 + c_37*z_331 - (B_zz*z_319 - z_333) - z_12*z_326 - c_93*z_319;
    const real c_94 = c[120];
    const real c_35 = c[61];
    const real z_335 = z_291*c_35;
    const real z_336 = z_291*c_34;
    const real z_337 = z_304*c_36;
    const real z_338 = z_308*c_37;
    const real z_339 = m_H*z_315 + m_F*z_316;
    const real z_340 = z_339*c_34;
    const real z_341 = z_339*c_35;
    const real c_51 = c[77];
    const real z_342 = c_51*z_165;
    const real c_50 = c[76];
    const real z_343 = c_50*z_171;
    const real z_344 = z_317*c_37;
    const real z_345 = c_51*z_171;
    const real c_49 = c[75];
    const real z_346 = c_49*z_165;
    const real z_347 = z_318*c_36;
    const real c_39 = c[65];
    const real z_348 = z_292*c_39;
    const real c_38 = c[64];
    const real z_349 = z_292*c_38;
    const real z_350 = phi_dot*c_34;
    const real z_351 = z_313 + x_B*z_183 - x_B*z_182 - c_1*z_185 - c_1*z_186;
    const real z_352 = z_351*c_39;
    const real z_353 = z_351*c_38;
    const real c_95 = c[121];
    const real c_96 = c[122];
    const real z_354 = psi_dot*z_298;
    const real z_355 = psi_dot*z_299;
    const real z_356 = c_31*z_354 + c_30*z_355;
    const real z_357 = c_33*z_354 + c_32*z_355;
    const real c_97 = c[123];
    const real c_98 = c[124];
    const real z_358 = z_12*z_317;
    const real z_359 = z_17*z_317;
    const real z_360 = z_12*z_318;
    const real z_361 = z_11*z_318;
    const real c_99 = c[125];
    const real spin_r_dot = v[6];
    const real c_100 = c[126];
    const real c_23 = c[49];
    const real c_101 = c[127];
    const real z_362 = m_H*z_354 + m_F*z_355;
    const real z_106 = shared[76];
    const real z_105 = shared[77];
    const real z_363 = psi_dot*z_301;
    const real z_108 = shared[78];
    const real z_107 = shared[79];
    const real c_102 = c[128];
    f1[3] = (-0.5)*(sin_phi*(2.0*z_233*z_317 + 2.0*z_166*z_318 + psi_dot*sin_theta*z_332 + c_94 + z_306*z_335 +
        z_303*z_336 + z_148*z_338 + z_161*z_341 + z_317*z_343 + z_318*z_346 + z_150*z_347 + z_303*z_348 +
        z_306*z_349 + z_161*z_353 + sin_delta*z_357*c_36 + cos_theta*c_97 + sin_theta*c_98 - 2.0*z_303*z_305 -
        2.0*z_306*z_307 - 2.0*z_306*z_309 - 2.0*z_303*z_310 - 2.0*z_172*z_317 - 2.0*z_235*z_318 -
        psi_dot*cos_theta*z_334 - z_148*z_337 - z_160*z_340 - z_317*z_342 - z_150*z_344 - z_318*z_345 -
        z_293*z_350 - z_160*z_352 - z_31*c_95 - z_92*c_95 - z_29*c_96 - z_93*c_96 - sin_delta*z_356*c_37) -
        cos_phi*(2.0*z_166*z_304 + 2.0*z_233*z_308 + 2.0*z_306*z_358 + 2.0*z_303*z_359 + 2.0*z_303*z_360 +
        2.0*z_306*z_361 + psi_dot*((2.0*cos_delta*z_330 + z_322*c_99 - z_326*z_15 - z_328*z_18) + (spin_r_dot +
        z_322)*c_100) + 2.0*z_31*z_356 + 2.0*z_92*z_356 + 2.0*z_29*z_357 + 2.0*z_93*z_357 +
        c_23*(sin_phi*(phi_dot*phi_dot)) + c_101*(psi_dot*z_296) + z_161*z_335 + z_304*z_346 + z_150*z_337 +
        z_308*z_343 + z_148*z_347 + z_161*z_349 + (z_339 + m_B*z_351)*z_350 + (m_B*z_363 + z_362)*c_34 -
        2.0*z_235*z_304 - 2.0*z_172*z_308 - z_160*z_336 - z_304*z_345 - z_308*z_342 - z_150*z_338 - z_306*z_341 -
        z_303*z_340 - z_148*z_344 - z_160*z_348 - z_303*z_352 - z_306*z_353 - z_362*z_106 - z_362*z_105 -
        z_363*z_108 - z_363*z_107 - sin_delta*c_102));
    const real z_364 = theta_dot*sin_phi;
    const real z_365 = theta_dot*cos_phi;
    const real z_366 = c_31*z_298 + c_30*z_299;
    const real z_367 = c_33*z_298 + c_32*z_299;
    const real z_368 = theta_dot*z_12;
    const real z_369 = psi_dot*cos_phi;
    const real z_370 = psi_dot*z_289;
    const real z_371 = psi_dot*z_290;
    const real z_372 = c_33*z_370 + c_32*z_371;
    const real z_373 = c_31*z_370 + c_30*z_371;
    const real z_374 = sin_phi*z_12;
    const real z_375 = z_193*z_304;
    const real z_376 = z_193*z_308;
    const real z_377 = z_274*z_317;
    const real z_378 = z_274*z_318;
    const real z_379 = theta_dot*z_300;
    const real z_380 = z_366*z_143;
    const real z_381 = z_367*z_143;
    const real z_382 = theta_dot*z_301;
    const real z_383 = z_12*cos_phi;
    const real z_384 = m_H*z_370 + m_F*z_371;
    const real z_385 = sin_phi*z_362;
    const real z_386 = sin_phi*z_363;
    f1[4] = (-0.5)*(sin_theta*(2.0*z_201*z_359 + 2.0*z_201*z_360 + 2.0*theta_dot*z_17*z_366 + 2.0*z_367*z_368 +
        2.0*sin_phi*z_17*z_356 + 2.0*z_357*z_374 + z_364*z_335 + z_132*z_336 + c_50*z_376 + z_365*z_341 +
        c_50*z_377 + c_49*z_381 + z_364*z_349 + z_132*z_348 + z_365*z_353 + z_384*c_35 + psi_dot*z_349 +
        cos_phi*c_97 - 2.0*z_364*z_307 - 2.0*z_132*z_305 - 2.0*z_364*z_309 - 2.0*z_132*z_310 - 2.0*z_365*z_358 -
        2.0*z_365*z_361 - phi_dot*z_332 - z_334*z_369 - 2.0*z_11*z_372 - 2.0*z_12*z_373 - c_51*z_375 - z_201*z_340
        - c_51*z_378 - c_34*z_379 - c_51*z_380 - z_201*z_352 - c_39*z_382 - c_95*(cos_phi*z_17) - c_96*z_383 -
        c_34*z_385 - c_39*z_386) + cos_theta*(2.0*z_132*z_307 + 2.0*z_132*z_309 + phi_dot*z_334 + z_364*z_336 +
        c_51*z_376 + z_365*z_340 + z_201*z_341 + c_51*z_377 + c_35*z_379 + c_50*z_380 + z_364*z_348 + z_365*z_352
        + z_201*z_353 + c_38*z_382 + c_95*z_383 + c_96*(z_11*cos_phi) + z_384*c_34 + psi_dot*z_348 + c_35*z_385 +
        c_38*z_386 - 2.0*z_364*z_305 - 2.0*z_364*z_310 - 2.0*z_365*z_359 - 2.0*z_201*z_358 - 2.0*z_365*z_360 -
        2.0*z_201*z_361 - 2.0*z_366*z_368 - 2.0*theta_dot*z_11*z_367 - z_332*z_369 - 2.0*z_12*z_372 -
        2.0*z_17*z_373 - 2.0*z_356*z_374 - 2.0*sin_phi*z_11*z_357 - z_132*z_335 - c_49*z_375 - c_49*z_378 -
        c_51*z_381 - z_132*z_349 - cos_phi*c_98));
    const real z_387 = delta_dot*c_51;
    const real z_388 = delta_dot*c_49;
    const real z_389 = delta_dot*c_50;
    const real z_390 = delta_dot*cos_phi;
    const real z_391 = delta_dot*sin_phi;
    f1[5] = (-0.5)*(cos_delta*(c_6*z_322*z_326 + c_7*z_322*z_328 + z_387*(z_304*z_6) + z_387*(z_308*z_4) +
        z_201*z_338 + z_387*(z_317*z_38) + z_132*z_344 + z_387*(z_318*z_39) + z_387*(cos_theta*z_366) +
        z_389*(sin_theta*z_366) + c_37*(z_319*z_330) + c_36*(z_321*z_330) + c_37*(cos_phi*z_356) + sin_phi*c_102 -
        z_388*(z_304*z_4) - z_201*z_337 - z_389*(z_308*z_6) - z_389*(z_317*z_39) - z_388*(z_318*z_38) -
        z_132*z_347 - z_387*(sin_theta*z_367) - z_388*(cos_theta*z_367) - c_36*(cos_phi*z_357)) -
        sin_delta*(c_3*(2.0*z_137*z_308 + z_319*z_328 + c_95*z_39 - 2.0*z_138*z_308 - 2.0*z_186*z_317 -
        2.0*z_185*z_317 - 2.0*z_366*z_161 - 2.0*sin_theta*z_373 - 2.0*z_356*z_6) + c_5*(2.0*z_138*z_304 +
        2.0*z_182*z_317 + 2.0*z_186*z_318 + 2.0*z_185*z_318 + 2.0*z_366*z_160 + 2.0*z_367*z_161 + z_319*z_326 +
        z_321*z_328 + 2.0*sin_theta*z_372 + 2.0*z_356*z_4 + 2.0*z_357*z_6 - 2.0*z_137*z_304 - 2.0*z_135*z_308 -
        2.0*z_134*z_308 - 2.0*z_183*z_317 - 2.0*cos_theta*z_373 - c_95*z_38 - c_96*z_39) + c_4*(2.0*z_135*z_304 +
        2.0*z_134*z_304 + 2.0*z_183*z_318 + z_321*z_326 + 2.0*cos_theta*z_372 + c_96*z_38 - 2.0*z_182*z_318 -
        2.0*z_367*z_160 - 2.0*z_357*z_4) + z_390*z_337 + z_391*z_344 - 2.0*z_322*z_330 - z_390*z_338 -
        z_391*z_347));
    f1[6] = em_real(0.0);
    f1[7] = em_real(0.0);
    A1[0][0] = em_real(0.0);
    A1[0][1] = em_real(0.0);
    A1[0][2] = em_real(0.0);
    const real c_103 = c[129];
    const real z_392 = z_44*z_44;
    const real z_393 = 1.0 - z_392;
    const real z_394 = sqrt(z_393);
    const real z_395 = 1.0/z_394;
    const real z_396 = z_44*z_395;
    const real z_397 = r_F*z_396;
    const real z_398 = sin_delta*c_103 + cos_delta*z_397;
    const real c_104 = c[130];
    const real z_399 = c_104*z_396;
    const real c_105 = c[131];
    const real z_400 = c_105*z_396;
    const real z_97 = shared[80];
    const real z_117 = shared[81];
    const real z_112 = shared[82];
    const real z_113 = shared[83];
    const real z_118 = shared[84];
    const real z_401 = (sin_theta*z_117 + cos_theta*z_112) + (cos_theta*z_113 + sin_theta*z_118);
    const real z_402 = z_87*z_399 + z_97 + z_401 - z_86*z_400;
    A1[0][3] = cos_phi*z_398 - sin_phi*z_402;
    const real z_403 = r_R*cos_phi;
    const real z_404 = cos_phi*sin_delta;
    const real z_405 = z_403 + z_400*z_404 - cos_phi*z_112 - cos_phi*z_113;
    const real z_406 = cos_phi*c_2 - cos_phi*z_117 - cos_phi*z_118 - z_399*z_404;
    A1[0][4] = sin_theta*z_405 - cos_theta*z_406;
    const real z_407 = sin_phi*c_103 + z_38*z_399 - z_39*z_400;
    const real c_106 = c[132];
    const real c_107 = c[133];
    const real z_408 = c_5*(c_*z_39 + r_F*z_38) - c_106*z_38 - sin_phi*z_397 - c_107*z_39;
    A1[0][5] = cos_delta*z_407 + sin_delta*z_408;
    A1[0][6] = em_real(0.0);
    A1[0][7] = em_real(0.0);
    A1[1][0] = cos_psi;
    A1[1][1] = sin_psi;
    A1[1][2] = em_real(0.0);
    A1[1][3] = em_real(0.0);
    const real c_108 = c[134];
    A1[1][4] = c_108;
    A1[1][5] = em_real(0.0);
    A1[1][6] = c_108;
    A1[1][7] = em_real(0.0);
    A1[2][0] = -sin_psi;
    A1[2][1] = cos_psi;
    A1[2][2] = em_real(0.0);
    A1[2][3] = em_real(0.0);
    A1[2][4] = em_real(0.0);
    A1[2][5] = em_real(0.0);
    A1[2][6] = em_real(0.0);
    A1[2][7] = em_real(0.0);
    A1[3][0] = cos_psi;
    A1[3][1] = sin_psi;
    const real z_19 = shared[85];
    const real z_41 = shared[86];
    const real z_409 = z_125 + z_6*z_18 - z_4*z_15;
    const real z_410 = z_41*z_409;
    const real z_411 = r_F*(z_19*z_394 - z_396*z_410);
    const real z_412 = z_392*z_395;
    const real z_413 = r_F*(z_409*z_394 + z_409*z_412);
    const real z_16 = shared[87];
    const real z_40 = shared[88];
    const real z_414 = z_40*z_409;
    const real z_415 = r_F*(z_16*z_394 + z_396*z_414);
    const real z_416 = z_411*z_18 - (cos_delta*z_413 + z_415*z_15);
    const real z_417 = -z_416;
    const real z_418 = z_12*z_415 + z_17*z_411 + z_413*z_18;
    const real z_419 = z_12*z_411 + z_11*z_415 - z_413*z_15;
    const real z_20 = shared[89];
    A1[3][2] = z_418*z_39 + z_419*z_38 - sin_phi*z_417 - z_20;
    A1[3][3] = em_real(0.0);
    const real z_96 = shared[90];
    A1[3][4] = -(z_96 - z_416 - z_401);
    const real c_109 = c[135];
    const real c_110 = c[136];
    A1[3][5] = c_7*z_415 + c_6*z_411 + c_110*z_86 - c_109*z_87;
    A1[3][6] = em_real(0.0);
    A1[3][7] = -z_413;
    A1[4][0] = -sin_psi;
    A1[4][1] = cos_psi;
    const real z_32 = shared[91];
    const real z_420 = z_40*z_88;
    const real z_421 = r_F*(z_32*z_394 - z_396*z_420);
    const real z_422 = r_F*(z_88*z_394 + z_88*z_412);
    const real z_30 = shared[92];
    const real z_423 = z_41*z_88;
    const real z_424 = r_F*(z_30*z_394 - z_396*z_423);
    const real z_425 = z_421*z_15 - (cos_delta*z_422 - z_424*z_18);
    const real z_426 = -z_425;
    const real z_427 = z_17*z_424 + z_422*z_18 - z_12*z_421;
    const real z_428 = z_11*z_421 + z_422*z_15 - z_12*z_424;
    A1[4][2] = z_33 + z_427*z_39 - sin_phi*z_426 - z_428*z_38;
    A1[4][3] = -(z_403 + c_103*z_53 + z_117*z_38 + z_112*z_39 + z_113*z_39 + z_118*z_38 - sin_theta*z_427 -
        cos_theta*z_428 - r_R*z_39 - c_2*z_38);
    A1[4][4] = -(r_R*z_4 + z_117*z_6 + z_118*z_6 - c_2*z_6 - z_112*z_4 - z_113*z_4 - z_425);
    A1[4][5] = c_6*z_424 + c_103*z_125 + c_109*z_127 + c_110*z_129 - c_7*z_421;
    A1[4][6] = em_real(0.0);
    A1[4][7] = -z_422;
    const real z_429 = z_194*z_395;
    const real z_430 = z_194*z_392/(z_393*z_394);
    const real c_111 = c[137];
    const real c_112 = c[138];
    const real z_431 = ((z_113*z_160 + c_107*z_171) - (z_118*z_161 + c_111*z_165)) - (z_239 + ((z_117*z_161 -
        c_106*z_165) - (z_112*z_160 - c_112*z_171)));
    const real z_432 = z_151*z_396 - z_149*z_396 - z_429*z_404 - z_430*z_404;
    gamma[0] = -(phi_dot*((z_398*z_201 - cos_phi*(c_103*z_148 - r_F*(z_143*z_396 - cos_delta*z_429 -
        cos_delta*z_430))) + (z_402*z_132 + sin_phi*(c_104*(z_228*z_396 + z_229*z_396 + z_87*z_429 + z_87*z_430) +
        c_105*(z_225*z_396 - z_226*z_396 - z_86*z_429 - z_86*z_430) - z_431))) + delta_dot*((z_407*z_143 -
        cos_delta*(c_103*z_132 + c_105*(z_186*z_396 + z_185*z_396 - z_39*z_429 - z_39*z_430) + c_104*(z_183*z_396
        + z_38*z_429 + z_38*z_430 - z_182*z_396))) - (z_408*z_148 - sin_delta*(c_5*(c_*z_196 - r_F*z_198) +
        c_106*z_198 + r_F*(z_396*z_132 + sin_phi*z_429 + sin_phi*z_430) - c_107*z_196))) - theta_dot*((z_405*z_161
        - sin_theta*(z_313 + (c_112*z_274 - z_112*z_201) + c_105*z_432 - (z_113*z_201 + c_107*z_274))) +
        (z_406*z_160 + cos_theta*(c_2*z_201 + (c_111*z_274 - z_118*z_201) - (c_106*z_274 + z_117*z_201) -
        c_104*z_432))));
    const real z_433 = x_dot*z_141 - y_dot*z_163;
    gamma[1] = -z_433;
    const real z_434 = x_dot*z_163 + y_dot*z_141;
    gamma[2] = -z_434;
    const real z_435 = z_194*z_396;
    const real z_436 = z_274 + z_275;
    const real z_437 = z_276 + z_278 - z_277;
    const real z_438 = z_279 + z_280 + z_281;
    const real z_439 = z_436 + c_6*z_438 - c_7*z_437;
    const real z_440 = r_F*(z_156*z_394 + z_19*z_435) - r_F*(z_396*(z_409*z_190) + z_396*(z_41*z_439) -
        z_429*z_410 - z_430*z_410);
    const real z_441 = z_409*z_435;
    const real z_442 = r_F*(z_441 + z_439*z_394) - r_F*(2.0*z_441 + z_430*(z_44*z_409) - z_439*z_412);
    const real z_443 = r_F*(z_153*z_394 - z_16*z_435) + r_F*(z_396*(z_409*z_188) + z_429*z_414 + z_430*z_414 -
        z_396*(z_40*z_439));
    const real z_444 = c_7*(z_411*z_148 - sin_delta*z_440) + ((z_413*z_143 + cos_delta*z_442) - c_6*(z_415*z_148 +
        sin_delta*z_443));
    const real z_445 = z_413*z_148 - sin_delta*z_442;
    gamma[3] = -(z_433 - psi_dot*((z_419*z_183 + ((z_411*z_146 - z_12*z_440) - (z_415*z_144 - z_11*z_443) -
        c_6*z_445)*z_38 - z_419*z_182) - (z_417*z_132 - sin_phi*z_444) - (z_418*z_186 + z_418*z_185 -
        ((z_415*z_146 + z_12*z_443) + c_7*z_445 - (z_411*z_154 + z_17*z_440))*z_39) - z_157) - theta_dot*(z_444 -
        z_431) - delta_dot*(c_7*z_443 - c_6*z_440 - c_109*z_230 - c_110*z_227) - spin_f_dot*z_442);
    const real z_446 = r_F*(z_176*z_394 + z_32*z_435) + r_F*(z_396*(z_88*z_188) + z_429*z_420 + z_430*z_420 -
        z_396*(z_40*z_231));
    const real z_447 = z_88*z_435;
    const real z_448 = r_F*(z_231*z_394 + z_447) - r_F*(2.0*z_447 + z_430*(z_44*z_88) - z_231*z_412);
    const real z_449 = r_F*(z_170*z_394 - z_30*z_435) + r_F*(z_396*(z_88*z_190) + z_396*(z_41*z_231) - z_429*z_423
        - z_430*z_423);
    const real z_450 = c_6*(z_421*z_148 - sin_delta*z_446) + ((z_422*z_143 + cos_delta*z_448) + c_7*(z_424*z_148 +
        sin_delta*z_449));
    const real z_451 = z_422*z_148 - sin_delta*z_448;
    const real z_452 = (z_424*z_154 - z_17*z_449) + (z_421*z_146 - z_12*z_446) - c_7*z_451;
    const real z_453 = (z_421*z_144 + z_11*z_446) + (z_424*z_146 + z_12*z_449) - c_6*z_451;
    const real z_454 = c_106*z_143;
    const real z_455 = c_112*z_143;
    const real z_456 = c_107*z_143;
    const real z_457 = c_111*z_143;
    gamma[4] = -(z_434 + psi_dot*((z_426*z_132 - sin_phi*z_450) + (z_427*z_186 + z_427*z_185 + z_452*z_39) +
        (z_428*z_183 - z_428*z_182 - z_453*z_38) + z_177) - phi_dot*(z_313 + (z_427*z_161 - sin_theta*z_452) +
        c_2*z_198 + (z_112*z_186 + z_112*z_185 - z_39*z_455) + (z_113*z_186 + z_113*z_185 + z_39*z_456) -
        (z_428*z_160 + cos_theta*z_453) - r_R*z_196 - c_103*z_181 - (z_117*z_183 - z_38*z_454 - z_117*z_182) -
        (z_118*z_183 + z_38*z_457 - z_118*z_182)) - theta_dot*(z_450 + c_2*z_139 + (z_112*z_134 + z_112*z_135 +
        z_4*z_455) + (z_113*z_134 + z_113*z_135 - z_4*z_456) - r_R*z_136 - (z_117*z_137 - z_117*z_138 - z_6*z_454)
        - (z_118*z_137 + z_6*z_457 - z_118*z_138)) - delta_dot*(c_6*z_449 + c_7*z_446 + c_109*z_437 + c_110*z_438
        - c_103*z_436) - spin_f_dot*z_448);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[93];
    triangular_masses(y, c, M1, shared);

    /* x, y, psi, phi, theta, delta, spin_r, spin_f: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[8], y[9], y[10], y[11], y[12], y[13], y[14], y[15] };
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
    dy[7] = v1[7];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    triangular_motion(dy, c, shared, Mdot1, f1, A1, gamma);

    /* x, y, psi, phi, theta, delta, spin_r, spin_f: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* x, y, psi, phi, theta, delta, spin_r, spin_f: B = A L^-T */
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
    dy[8] = a1[0];
    dy[9] = a1[1];
    dy[10] = a1[2];
    dy[11] = a1[3];
    dy[12] = a1[4];
    dy[13] = a1[5];
    dy[14] = a1[6];
    dy[15] = a1[7];
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
    real v1[N1] = { e[0], e[1], e[2], e[3], e[4], e[5], e[6], e[7] };
    if (mode) em_backward(N1, memory + 0, memory + 64, v1);
    else em_velocity_of_eta(N1, y + 16, y + 80, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
    v[4] = v1[4];
    v[5] = v1[5];
    v[6] = v1[6];
    v[7] = v1[7];
}

#define EM_VELOCITY velocity_by_roots

#include "em_flock.h"
#endif

extern em_lanes bicycle_lanes;
em_lanes bicycle_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double m_R = c[6];
    const double r_R = c[4];
    const double phi_dot = v[3];
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double z_1 = phi_dot*cos_phi;
    const double z_2 = r_R*z_1;
    const double y_dot = v[1];
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double x_dot = v[0];
    const double sin_psi = em_sin(psi);
    const double z_5 = z_2 - (y_dot*cos_psi - x_dot*sin_psi);
    const double m_H = c[8];
    const double psi_dot = v[2];
    const double z_H = c[13];
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double c_4 = c[30];
    const double c_3 = c[29];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_8 = c_4 + c_3*cos_delta;
    const double cos_theta = em_cos(theta);
    const double c_5 = c[31];
    const double z_10 = c_5 - cos_delta*c_5;
    const double z_11 = cos_theta*z_10;
    const double z_12 = sin_theta*z_8 - z_11;
    const double c_8 = c[34];
    const double z_13 = c_3 + c_4*cos_delta;
    const double z_14 = cos_theta*z_13;
    const double z_15 = sin_theta*z_10;
    const double z_16 = z_14 - z_15;
    const double c_2 = c[28];
    const double z_17 = cos_theta*c_2;
    const double z_18 = z_17 - r_R*sin_theta;
    const double z_19 = z_H*z_12 + z_18 - c_8*z_16;
    const double c_7 = c[33];
    const double delta_dot = v[5];
    const double z_20 = delta_dot*cos_delta;
    const double z_21 = c_7*z_20;
    const double sin_phi = em_sin(phi);
    const double z_23 = phi_dot*sin_phi;
    const double sin_delta = em_sin(delta);
    const double z_25 = c_7*sin_delta;
    const double z_26 = sin_phi*cos_theta;
    const double z_27 = delta_dot*sin_delta;
    const double z_28 = c_3*z_27;
    const double theta_dot = v[4];
    const double z_29 = sin_phi*sin_theta;
    const double z_30 = theta_dot*z_29;
    const double z_31 = cos_theta*cos_phi;
    const double z_32 = phi_dot*z_31;
    const double z_33 = c_5*z_27;
    const double z_34 = z_29*z_33;
    const double z_35 = sin_theta*cos_phi;
    const double z_36 = phi_dot*z_35;
    const double z_37 = theta_dot*z_26;
    const double z_38 = (z_26*z_28 + (z_8*z_30 - z_8*z_32)) - (z_34 + (z_10*z_36 + z_10*z_37));
    const double z_39 = cos_phi*z_21 + z_38 - z_23*z_25;
    const double c_6 = c[32];
    const double z_40 = c_6*z_20;
    const double z_41 = c_6*sin_delta;
    const double z_42 = z_26*z_33;
    const double z_43 = z_42 + (z_10*z_32 - z_10*z_30);
    const double z_44 = c_4*z_27;
    const double z_45 = z_29*z_44 - (z_13*z_36 + z_13*z_37);
    const double z_46 = cos_phi*z_40 + z_43 - z_23*z_41 - z_45;
    const double z_47 = (c_2*z_37 - r_R*z_30) - (z_5 - (r_R*z_32 + c_2*z_36));
    const double z_48 = psi_dot*z_19 + z_H*z_39 + z_47 - c_8*z_46;
    const double m_F = c[9];
    const double r_F = c[5];
    const double c_ = c[1];
    const double z_49 = r_F*z_12 + z_18 - c_*z_16;
    const double z_50 = psi_dot*z_49 + r_F*z_39 + z_47 - c_*z_46;
    const double z_51 = m_H*z_48 + m_F*z_50;
    const double m_B = c[7];
    const double x_B = c[10];
    const double c_1 = c[27];
    const double z_52 = x_B*cos_theta - sin_theta*c_1;
    const double z_53 = psi_dot*z_52 + x_B*z_36 + c_1*z_32 + x_B*z_37 - c_1*z_30 - z_5;
    const double z_54 = m_R*(-z_5) + z_51 + m_B*z_53;
    const double z_55 = psi_dot*cos_psi;
    const double z_56 = psi_dot*sin_psi;
    const double z_57 = x_dot*z_55 + y_dot*z_56;
    const double z_58 = phi_dot*phi_dot;
    const double z_59 = sin_phi*z_58;
    const double z_60 = z_57 - r_R*z_59;
    const double z_61 = theta_dot*sin_theta;
    const double z_62 = theta_dot*cos_theta;
    const double z_63 = x_B*z_61 + c_1*z_62;
    const double z_64 = theta_dot*z_31;
    const double z_65 = phi_dot*z_64;
    const double z_66 = z_65 - z_58*z_29;
    const double z_67 = theta_dot*z_35;
    const double z_68 = phi_dot*z_67;
    const double z_69 = z_68 + z_58*z_26;
    const double z_70 = theta_dot*theta_dot;
    const double z_71 = z_65 - z_70*z_29;
    const double z_72 = z_68 + z_70*z_26;
    const double z_73 = psi_dot*z_63 + c_1*z_69 + c_1*z_72 + z_60 - x_B*z_66 - x_B*z_71;
    const double z_74 = cos_theta*z_33;
    const double z_75 = (z_8*z_62 - sin_theta*z_28) + (z_10*z_61 - z_74);
    const double z_76 = z_75;
    const double z_77 = sin_theta*z_33;
    const double z_78 = (z_13*z_61 + cos_theta*z_44) + (z_10*z_62 + z_77);
    const double z_79 = z_78;
    const double z_80 = r_R*z_62 + c_2*z_61;
    const double z_81 = z_80 - z_H*z_76 - c_8*z_79;
    const double z_82 = delta_dot*delta_dot;
    const double z_83 = cos_phi*sin_delta;
    const double z_84 = z_23*z_20;
    const double z_85 = z_82*z_83 + z_84;
    const double z_86 = z_8*z_68;
    const double z_87 = z_8*z_26;
    const double z_88 = z_10*z_65;
    const double z_89 = z_10*z_29;
    const double z_90 = z_84 + z_58*z_83;
    const double z_91 = cos_delta*z_82;
    const double z_92 = z_30*z_27 - z_32*z_27 - z_26*z_91;
    const double z_93 = z_36*z_27 + z_37*z_27 + z_29*z_91;
    const double z_94 = c_7*z_85 + (z_88 + z_36*z_33 - z_89*z_58) + c_7*z_90 + (z_88 + z_37*z_33 - z_89*z_70) +
        c_3*z_92 + c_5*z_93 - (z_86 + z_87*z_70 - z_30*z_28) - (z_86 + z_87*z_58 + z_32*z_28);
    const double z_95 = z_13*z_65;
    const double z_96 = z_13*z_29;
    const double z_97 = z_10*z_68;
    const double z_98 = z_10*z_26;
    const double z_99 = c_6*z_85 + (z_97 + z_98*z_58 - z_32*z_33) + c_6*z_90 + (z_97 + z_98*z_70 + z_30*z_33) +
        c_4*z_93 - (z_95 - z_36*z_44 - z_96*z_58) - (z_95 - z_96*z_70 - z_37*z_44) - c_5*(-z_92);
    const double z_100 = (c_2*z_71 - r_R*z_72) - (z_60 + (r_R*z_69 - c_2*z_66));
    const double z_101 = psi_dot*z_81 + z_H*z_94 - c_8*z_99 - z_100;
    const double z_102 = z_80 - (r_F*z_76 + c_*z_79);
    const double z_103 = psi_dot*z_102 + r_F*z_94 - c_*z_99 - z_100;
    const double z_104 = m_H*z_101 + m_F*z_103;
    const double z_105 = m_R*z_60 + m_B*z_73 + z_104;
    const double z_106 = r_R*sin_phi;
    const double z_107 = x_dot*cos_psi + y_dot*sin_psi;
    const double z_108 = psi_dot*z_106 + z_107;
    const double z_109 = z_87 + z_89 - cos_phi*z_25;
    const double z_110 = z_96 + z_98 + cos_phi*z_41;
    const double z_111 = c_2*z_29 - (z_106 - r_R*z_26);
    const double z_112 = z_109*z_H + z_110*c_8 - z_111;
    const double z_113 = z_80 - z_107;
    const double z_114 = psi_dot*z_112 + z_H*z_75 + c_8*z_78 - z_113;
    const double z_115 = c_*z_110 + r_F*z_109 - z_111;
    const double z_116 = psi_dot*z_115 + c_*z_78 + r_F*z_75 - z_113;
    const double z_117 = m_H*z_114 + m_F*z_116;
    const double z_118 = z_106 - x_B*z_29 - c_1*z_26;
    const double z_119 = psi_dot*z_118 + z_107 - z_63;
    const double z_120 = m_R*z_108 + z_117 + m_B*z_119;
    const double z_121 = x_dot*z_56 - y_dot*z_55;
    const double z_122 = psi_dot*z_1;
    const double z_123 = z_121 - r_R*z_122;
    const double z_124 = z_36 + z_37;
    const double z_125 = z_32 - z_30;
    const double z_126 = z_2 - x_B*z_124 - c_1*z_125;
    const double z_127 = sin_theta*z_70;
    const double z_128 = z_121 + cos_theta*(x_B*z_70) - psi_dot*z_126 - c_1*z_127;
    const double z_129 = cos_phi*z_20;
    const double z_130 = z_129 - sin_delta*z_23;
    const double z_131 = c_7*z_130 + z_38;
    const double z_132 = (-z_45) + z_43 + c_6*z_130;
    const double z_133 = c_2*z_124 - (z_2 - r_R*z_125);
    const double z_134 = c_8*z_132 - z_H*z_131 - z_133;
    const double z_135 = z_27*z_62 + sin_theta*z_91;
    const double z_136 = z_27*z_61 - cos_theta*z_91;
    const double z_137 = (z_8*z_127 + z_62*z_28) + c_3*z_135 - (z_11*z_70 + z_61*z_33) - c_5*z_136;
    const double z_138 = (z_14*z_70 - z_61*z_44) + c_5*z_135 - (z_15*z_70 - z_62*z_33) - c_4*z_136;
    const double z_139 = z_17*z_70 + (z_121 - r_R*z_127);
    const double z_140 = z_H*z_137 + z_139 - psi_dot*z_134 - c_8*z_138;
    const double z_141 = z_133 - (c_*z_132 - r_F*z_131);
    const double z_142 = -z_141;
    const double z_143 = r_F*z_137 + z_139 - psi_dot*z_142 - c_*z_138;
    const double z_144 = m_H*z_140 + m_F*z_143;
    const double z_145 = m_R*z_123 + m_B*z_128 + z_144;
    bias[0] = (z_54*z_55 - sin_psi*z_105) + (z_120*z_56 + cos_psi*z_145);
    bias[1] = (z_54*z_56 + cos_psi*z_105) - (z_120*z_55 - sin_psi*z_145);
    const double c_9 = c[35];
    const double B_xz = c[21];
    const double z_146 = phi_dot*sin_theta;
    const double z_147 = z_146 + psi_dot*z_31;
    const double z_148 = B_xz*z_147;
    const double B_xx = c[18];
    const double z_149 = phi_dot*cos_theta;
    const double z_150 = z_149 - psi_dot*z_35;
    const double H_xz = c[25];
    const double z_151 = theta_dot + psi_dot*sin_phi;
    const double z_152 = delta_dot*c_6 + z_8*z_147 + z_151*z_25 - z_10*z_150;
    const double z_153 = H_xz*z_152;
    const double H_xx = c[22];
    const double z_154 = z_13*z_150 + z_151*z_41 - delta_dot*c_7 - z_10*z_147;
    const double c_90 = c[116];
    const double z_155 = z_153 - (H_xx*z_154 - z_153) - c_90*z_154;
    const double z_156 = H_xz*z_154;
    const double H_zz = c[24];
    const double c_91 = c[117];
    const double z_157 = z_156 - (H_zz*z_152 - z_156) - c_91*z_152;
    const double c_92 = c[118];
    const double c_36 = c[62];
    const double H_yy = c[23];
    const double z_158 = z_147*z_25 - (cos_delta*z_151 - z_150*z_41);
    const double F_yy = c[17];
    const double spin_f_dot = v[7];
    const double z_159 = H_yy*(-z_158) + F_yy*(spin_f_dot - z_158);
    const double z_160 = sin_delta*z_159;
    const double z_161 = z_148 + z_13*z_155 + c_36*z_160 - (B_xx*z_150 - z_148) - z_10*z_157 - c_92*z_150;
    const double z_162 = sin_theta*z_23;
    const double z_163 = cos_theta*z_23;
    const double z_164 = phi_dot*z_62 - (psi_dot*z_67 + psi_dot*z_163);
    const double z_165 = B_xz*z_164;
    const double z_166 = phi_dot*z_61 + (psi_dot*z_64 - psi_dot*z_162);
    const double c_57 = c[83];
    const double z_167 = (z_151*z_27 - cos_delta*z_122) + c_6*(z_150*z_20 - sin_delta*z_166) + c_7*(z_147*z_20 +
        sin_delta*z_164);
    const double z_168 = sin_delta*z_167;
    const double z_169 = z_151*z_20 + sin_delta*z_122;
    const double z_170 = (z_147*z_28 - z_8*z_164) + (z_150*z_33 - z_10*z_166) - c_7*z_169;
    const double z_171 = H_xz*z_170;
    const double z_172 = (z_150*z_44 + z_13*z_166) + (z_147*z_33 + z_10*z_164) - c_6*z_169;
    const double z_173 = z_171 - (H_xx*z_172 - z_171) - c_90*z_172;
    const double z_174 = H_xz*z_172;
    const double z_175 = z_174 - (H_zz*z_170 - z_174) - c_91*z_170;
    const double z_176 = z_165 + (B_xx*z_166 + z_165) + 2.0*(z_159*z_40 - c_57*z_168) + c_92*z_166 - (z_155*z_44 +
        z_13*z_173) - (z_157*z_33 - z_10*z_175);
    const double z_177 = B_xz*z_150;
    const double B_zz = c[20];
    const double c_93 = c[119];
    const double c_37 = c[63];
    const double z_178 = z_177 + z_8*z_157 + c_37*z_160 - (B_zz*z_147 - z_177) - z_10*z_155 - c_93*z_147;
    const double z_179 = B_xz*z_166;
    const double c_58 = c[84];
    const double z_180 = z_179 + (B_zz*z_164 + z_179) + (z_155*z_33 - z_10*z_173) + (z_157*z_28 + z_8*z_175) +
        c_93*z_164 - 2.0*(z_159*z_21 - c_58*z_168);
    const double c_99 = c[125];
    const double spin_r_dot = v[6];
    const double c_100 = c[126];
    const double z_181 = (2.0*cos_delta*z_159 + z_151*c_99 - z_155*z_41 - z_157*z_25) + (spin_r_dot +
        z_151)*c_100;
    const double c_56 = c[82];
    const double z_182 = (2.0*(z_159*z_27 + cos_delta*c_56*z_167) + c_6*(z_155*z_20 - sin_delta*z_173) +
        c_7*(z_157*z_20 - sin_delta*z_175) - c_99*z_122) - c_100*z_122;
    bias[2] = (-0.5)*(2.0*(cos_psi*(x_dot*z_54 - y_dot*z_120) + sin_psi*(y_dot*z_54 + x_dot*z_120)) +
        (2.0*c_9*(z_108*z_1 - sin_phi*z_123) + 2.0*m_H*(z_114*z_134 - z_112*z_140) + 2.0*m_F*(z_116*z_142 -
        z_115*z_143) + 2.0*m_B*(z_119*z_126 - z_118*z_128) + (z_64*z_161 + z_176*z_35 - z_162*z_161) + (z_67*z_178
        + z_163*z_178 + z_180*z_31) + (z_181*z_1 + sin_phi*(-z_182)) - 2.0*m_H*(z_48*z_81 + z_19*z_101) -
        2.0*m_F*(z_50*z_102 + z_49*z_103) - 2.0*m_B*(z_53*z_63 + z_52*z_73)));
    const double c_33 = c[59];
    const double c_32 = c[58];
    const double z_183 = c_33*z_48 + c_32*z_50;
    const double z_184 = z_10*z_183;
    const double z_185 = z_13*z_183;
    const double c_31 = c[57];
    const double c_30 = c[56];
    const double z_186 = c_31*z_48 + c_30*z_50;
    const double z_187 = z_10*z_186;
    const double z_188 = z_8*z_186;
    const double z_189 = z_35*z_44 + (z_13*z_162 - z_13*z_64);
    const double z_190 = z_31*z_33;
    const double z_191 = z_190 - (z_10*z_163 + z_10*z_67);
    const double z_192 = sin_phi*z_40 + z_1*z_41 + z_189 - z_191;
    const double z_193 = z_35*z_33;
    const double z_194 = (z_31*z_28 + (z_8*z_163 + z_8*z_67)) - (z_193 + (z_10*z_64 - z_10*z_162));
    const double z_195 = sin_phi*z_21 + z_1*z_25 - z_194;
    const double z_196 = r_R*z_23;
    const double z_197 = (r_R*z_163 + c_2*z_162) + (r_R*z_67 - (z_196 + c_2*z_64));
    const double z_198 = c_8*z_192 - z_H*z_195 - z_197;
    const double z_199 = c_*z_192 - r_F*z_195 - z_197;
    const double z_200 = c_31*z_198 + c_30*z_199;
    const double z_201 = z_8*z_200;
    const double z_202 = z_10*z_200;
    const double z_203 = c_33*z_198 + c_32*z_199;
    const double z_204 = z_13*z_203;
    const double z_205 = z_10*z_203;
    const double c_94 = c[120];
    const double c_35 = c[61];
    const double z_206 = z_51*c_35;
    const double c_34 = c[60];
    const double z_207 = z_51*c_34;
    const double z_208 = z_183*z_20;
    const double z_209 = z_186*z_20;
    const double z_210 = m_H*z_198 + m_F*z_199;
    const double z_211 = z_210*c_34;
    const double z_212 = z_210*c_35;
    const double c_51 = c[77];
    const double z_213 = sin_theta*z_27;
    const double z_214 = c_51*z_213;
    const double c_50 = c[76];
    const double z_215 = cos_theta*z_27;
    const double z_216 = c_50*z_215;
    const double z_217 = sin_delta*z_200;
    const double z_218 = phi_dot*c_37;
    const double z_219 = c_51*z_215;
    const double c_49 = c[75];
    const double z_220 = c_49*z_213;
    const double z_221 = sin_delta*z_203;
    const double z_222 = phi_dot*c_36;
    const double c_39 = c[65];
    const double z_223 = z_53*c_39;
    const double c_38 = c[64];
    const double z_224 = z_53*c_38;
    const double z_225 = phi_dot*c_34;
    const double z_226 = z_196 + x_B*z_64 - x_B*z_162 - c_1*z_163 - c_1*z_67;
    const double z_227 = z_226*c_39;
    const double z_228 = z_226*c_38;
    const double c_95 = c[121];
    const double z_229 = cos_theta*z_8;
    const double c_96 = c[122];
    const double z_230 = sin_theta*z_13;
    const double z_231 = psi_dot*z_114;
    const double z_232 = psi_dot*z_116;
    const double z_233 = c_31*z_231 + c_30*z_232;
    const double z_234 = c_33*z_231 + c_32*z_232;
    const double c_97 = c[123];
    const double c_98 = c[124];
    const double c_23 = c[49];
    const double c_101 = c[127];
    const double z_235 = sin_delta*z_183;
    const double z_236 = sin_delta*z_186;
    const double z_237 = z_200*c_37;
    const double z_238 = z_203*c_36;
    const double z_239 = z_210 + m_B*z_226;
    const double z_240 = m_H*z_231 + m_F*z_232;
    const double z_241 = psi_dot*z_119;
    const double c_102 = c[128];
    const double z_242 = c_33*z_101 + c_32*z_103;
    const double z_243 = sin_phi*sin_delta;
    const double z_244 = z_10*z_31;
    const double z_245 = z_183*z_44;
    const double z_246 = z_13*z_35;
    const double z_247 = c_31*z_101 + c_30*z_103;
    const double z_248 = z_10*z_35;
    const double z_249 = z_186*z_28;
    const double z_250 = z_8*z_31;
    const double z_251 = z_20*z_1;
    const double z_252 = z_251 - z_82*z_243;
    const double z_253 = z_23*z_62;
    const double z_254 = z_13*z_253;
    const double z_255 = z_23*z_61;
    const double z_256 = z_10*z_255;
    const double z_257 = z_251 - sin_delta*z_59;
    const double z_258 = z_162*z_27 - z_64*z_27 - z_35*z_91;
    const double z_259 = z_163*z_27 + z_67*z_27 - z_31*z_91;
    const double z_260 = c_6*z_252 + (z_246*z_58 + z_254 - z_162*z_44) + (z_244*z_58 + z_163*z_33 - z_256) +
        c_6*z_257 + (z_254 + z_246*z_70 + z_64*z_44) + c_5*z_259 - (z_256 - z_244*z_70 - z_67*z_33) - c_4*z_258;
    const double z_261 = z_10*z_253;
    const double z_262 = z_8*z_255;
    const double z_263 = c_7*z_252 + c_7*z_257 + (z_262 + z_67*z_28 - z_250*z_70) + c_3*z_259 + c_5*(-z_258) -
        (z_248*z_70 + z_261 - z_64*z_33) - (z_250*z_58 - z_262 - z_163*z_28) - (z_261 + z_248*z_58 + z_162*z_33);
    const double z_264 = z_58*z_31 - z_255;
    const double z_265 = z_253 + z_58*z_35;
    const double z_266 = z_255 - z_70*z_31;
    const double z_267 = r_R*cos_phi;
    const double z_268 = z_267*z_58;
    const double z_269 = z_70*z_35 + z_253;
    const double z_270 = (r_R*z_264 + c_2*z_265) - (r_R*z_266 + (z_268 - c_2*z_269));
    const double z_271 = c_8*z_260 - z_H*z_263 - z_270;
    const double z_272 = c_*z_260 - r_F*z_263 - z_270;
    const double z_273 = m_H*z_271 + m_F*z_272;
    const double z_274 = c_31*z_271 + c_30*z_272;
    const double z_275 = c_33*z_271 + c_32*z_272;
    const double c_68 = c[94];
    const double c_67 = c[93];
    const double z_276 = z_268 + c_1*z_266 - x_B*z_269 - x_B*z_265 - c_1*z_264;
    const double c_62 = c[88];
    bias[3] = (-0.5)*((sin_phi*(2.0*z_61*z_201 + 2.0*z_61*z_205 + psi_dot*sin_theta*z_161 + c_94 + z_146*z_206 +
        z_149*z_207 + c_37*z_209 + z_62*z_212 + z_200*z_216 + z_203*z_220 + z_221*z_222 + z_149*z_223 +
        z_146*z_224 + z_62*z_228 + sin_delta*z_234*c_36 + cos_theta*c_97 + sin_theta*c_98 - 2.0*z_149*z_184 -
        2.0*z_146*z_185 - 2.0*z_146*z_187 - 2.0*z_149*z_188 - 2.0*z_62*z_202 - 2.0*z_62*z_204 -
        psi_dot*cos_theta*z_178 - c_36*z_208 - z_61*z_211 - z_200*z_214 - z_217*z_218 - z_203*z_219 - z_54*z_225 -
        z_61*z_227 - z_15*c_95 - c_95*z_229 - z_11*c_96 - c_96*z_230 - sin_delta*z_233*c_37) -
        cos_phi*(2.0*z_61*z_184 + 2.0*z_61*z_188 + 2.0*z_146*z_202 + 2.0*z_149*z_201 + 2.0*z_149*z_205 +
        2.0*z_146*z_204 + psi_dot*z_181 + 2.0*z_15*z_233 + 2.0*z_233*z_229 + 2.0*z_11*z_234 + 2.0*z_234*z_230 +
        c_23*z_59 + c_101*(psi_dot*z_108) + z_62*z_206 + z_183*z_220 + z_235*z_222 + z_186*z_216 + z_20*z_238 +
        z_62*z_224 + z_239*z_225 + (m_B*z_241 + z_240)*c_34 - 2.0*z_62*z_185 - 2.0*z_62*z_187 - z_61*z_207 -
        z_183*z_219 - z_186*z_214 - z_236*z_218 - z_146*z_212 - z_149*z_211 - z_20*z_237 - z_61*z_223 -
        z_149*z_227 - z_146*z_228 - sin_theta*z_240*c_35 - cos_theta*z_240*c_34 - cos_theta*c_39*z_241 -
        sin_theta*c_38*z_241 - sin_delta*c_102)) + (2.0*c_2*(z_64*z_51 - z_162*z_51 - z_104*z_35) +
        2.0*c_6*(z_1*z_235 + sin_phi*z_208 - z_242*z_243) + 2.0*(z_67*z_184 + z_163*z_184 + z_244*z_242 -
        z_190*z_183) + 2.0*(z_67*z_188 + z_163*z_188 + z_31*z_249 + z_250*z_247) + 2.0*(z_36*z_202 + z_37*z_202 +
        z_34*z_200 + z_89*z_274) + 2.0*(z_32*z_201 + z_87*z_274 - z_30*z_201 - z_26*(z_200*z_28)) +
        2.0*c_7*(z_23*z_217 - z_129*z_200 - z_274*z_83) + 2.0*(z_32*z_205 + z_42*z_203 + z_98*z_275 - z_30*z_205)
        + 2.0*(z_36*z_204 + z_37*z_204 + z_96*z_275 - z_29*(z_203*z_44)) + 2.0*c_67*(z_64*z_53 - z_162*z_53 -
        z_73*z_35) + 2.0*r_R*(z_54*z_23 + cos_phi*z_105) + 2.0*r_R*(z_239*z_1 + sin_phi*(z_273 + m_B*z_276)) +
        (z_161*z_61 - cos_theta*z_176) + c_62*(cos_phi*z_59) - 2.0*r_R*(z_67*z_51 + z_163*z_51 + z_104*z_31) -
        2.0*(z_64*z_185 - z_35*z_245 - z_162*z_185 - z_246*z_242) - 2.0*c_7*(z_1*z_236 + sin_phi*z_209 -
        z_247*z_243) - 2.0*(z_64*z_187 + z_193*z_186 - z_162*z_187 - z_248*z_247) - 2.0*c_2*(z_36*z_210 +
        z_37*z_210 + z_273*z_29) - 2.0*r_R*(z_32*z_210 + z_273*z_26 - z_30*z_210) - 2.0*c_6*(z_23*z_221 -
        z_129*z_203 - z_275*z_83) - 2.0*c_68*(z_67*z_53 + z_163*z_53 + z_73*z_31) - 2.0*c_68*(z_226*z_32 +
        z_276*z_26 - z_226*z_30) - 2.0*c_67*(z_226*z_36 + z_226*z_37 + z_276*z_29) - (z_178*z_62 -
        sin_theta*z_180)));
    const double z_277 = theta_dot*sin_phi;
    const double z_278 = theta_dot*cos_phi;
    const double z_279 = c_31*z_114 + c_30*z_116;
    const double z_280 = c_33*z_114 + c_32*z_116;
    const double z_281 = theta_dot*z_10;
    const double z_282 = psi_dot*cos_phi;
    const double z_283 = psi_dot*z_48;
    const double z_284 = psi_dot*z_50;
    const double z_285 = c_33*z_283 + c_32*z_284;
    const double z_286 = c_31*z_283 + c_30*z_284;
    const double z_287 = sin_phi*z_10;
    const double z_288 = sin_phi*z_27;
    const double z_289 = z_288*z_183;
    const double z_290 = z_288*z_186;
    const double z_291 = cos_phi*z_27;
    const double z_292 = z_291*z_200;
    const double z_293 = z_291*z_203;
    const double z_294 = theta_dot*z_117;
    const double z_295 = z_279*z_27;
    const double z_296 = z_280*z_27;
    const double z_297 = theta_dot*z_119;
    const double z_298 = z_10*cos_phi;
    const double z_299 = m_H*z_283 + m_F*z_284;
    const double z_300 = sin_phi*z_240;
    const double z_301 = sin_phi*z_241;
    const double z_302 = z_183*z_29;
    const double z_303 = z_242*z_26;
    const double z_304 = z_186*z_26;
    const double z_305 = z_247*z_29;
    const double z_306 = z_200*z_35;
    const double z_307 = z_274*z_35;
    const double z_308 = z_200*z_31;
    const double z_309 = z_203*z_31;
    const double z_310 = z_275*z_31;
    const double z_311 = z_203*z_35;
    const double z_312 = z_279*z_62;
    const double z_313 = c_31*z_140 + c_30*z_143;
    const double z_314 = z_279*z_61;
    const double z_315 = cos_theta*z_279;
    const double z_316 = z_280*z_61;
    const double z_317 = c_33*z_140 + c_32*z_143;
    const double z_318 = z_280*z_62;
    const double z_319 = sin_theta*z_280;
    bias[4] = (-0.5)*((sin_theta*(2.0*z_23*z_201 + 2.0*z_23*z_205 + 2.0*theta_dot*z_8*z_279 + 2.0*z_280*z_281 +
        2.0*sin_phi*z_8*z_233 + 2.0*z_234*z_287 + z_277*z_206 + z_1*z_207 + c_50*z_290 + z_278*z_212 + c_50*z_292
        + c_49*z_296 + z_277*z_224 + z_1*z_223 + z_278*z_228 + z_299*c_35 + psi_dot*z_224 + cos_phi*c_97 -
        2.0*z_277*z_185 - 2.0*z_1*z_184 - 2.0*z_277*z_187 - 2.0*z_1*z_188 - 2.0*z_278*z_202 - 2.0*z_278*z_204 -
        phi_dot*z_161 - z_178*z_282 - 2.0*z_13*z_285 - 2.0*z_10*z_286 - c_51*z_289 - z_23*z_211 - c_51*z_293 -
        c_34*z_294 - c_51*z_295 - z_23*z_227 - c_39*z_297 - c_95*(cos_phi*z_8) - c_96*z_298 - c_34*z_300 -
        c_39*z_301) + cos_theta*(2.0*z_1*z_185 + 2.0*z_1*z_187 + phi_dot*z_178 + z_277*z_207 + c_51*z_290 +
        z_278*z_211 + z_23*z_212 + c_51*z_292 + c_35*z_294 + c_50*z_295 + z_277*z_223 + z_278*z_227 + z_23*z_228 +
        c_38*z_297 + c_95*z_298 + c_96*(z_13*cos_phi) + z_299*c_34 + psi_dot*z_223 + c_35*z_300 + c_38*z_301 -
        2.0*z_277*z_184 - 2.0*z_277*z_188 - 2.0*z_278*z_201 - 2.0*z_23*z_202 - 2.0*z_278*z_205 - 2.0*z_23*z_204 -
        2.0*z_279*z_281 - 2.0*theta_dot*z_13*z_280 - z_161*z_282 - 2.0*z_10*z_285 - 2.0*z_8*z_286 -
        2.0*z_233*z_287 - 2.0*sin_phi*z_13*z_234 - z_1*z_206 - c_49*z_289 - c_49*z_293 - c_51*z_296 - z_1*z_224 -
        cos_phi*c_98)) + (2.0*c_2*(z_32*z_51 - z_30*z_51 - z_104*z_26) + 2.0*(z_36*z_184 + z_37*z_184 + z_33*z_302
        - z_89*z_242) + 2.0*(z_36*z_188 + z_37*z_188 - z_29*z_249 - z_8*z_305) + 2.0*(z_64*z_201 + z_8*z_307 -
        z_162*z_201 - z_28*z_306) + 2.0*(z_67*z_202 + z_163*z_202 - z_33*z_308 - z_244*z_274) + 2.0*(z_67*z_204 +
        z_44*z_309 + z_163*z_204 - z_13*z_310) + 2.0*(z_64*z_205 + z_33*z_311 + z_248*z_275 - z_162*z_205) +
        2.0*r_R*(z_117*z_61 + cos_theta*z_144) + 2.0*(z_10*z_312 + z_77*z_279 - z_15*z_313) + 2.0*(z_13*z_318 -
        z_44*z_319 - z_317*z_230) + 2.0*c_67*(z_32*z_53 - z_30*z_53 - z_73*z_26) + 2.0*c_68*(z_119*z_61 +
        cos_theta*z_128) - 2.0*r_R*(z_36*z_51 + z_37*z_51 - z_104*z_29) - 2.0*(z_32*z_185 - z_30*z_185 -
        z_26*z_245 - z_13*z_303) - 2.0*(z_32*z_187 + z_33*z_304 - z_30*z_187 - z_98*z_247) - 2.0*r_R*(z_64*z_210 +
        z_273*z_35 - z_162*z_210) - 2.0*c_2*(z_67*z_210 + z_163*z_210 - z_273*z_31) - 2.0*c_2*(z_117*z_62 -
        sin_theta*z_144) - 2.0*(z_8*z_314 + z_28*z_315 + z_313*z_229) - 2.0*(z_10*z_316 + z_11*z_317 - z_74*z_280)
        - 2.0*c_68*(z_36*z_53 + z_37*z_53 - z_73*z_29) - 2.0*c_68*(z_64*z_226 + z_276*z_35 - z_162*z_226) -
        2.0*c_67*(z_67*z_226 + z_163*z_226 - z_276*z_31) - 2.0*c_67*(z_119*z_62 - sin_theta*z_128) - z_182));
    const double z_320 = delta_dot*c_51;
    const double z_321 = delta_dot*c_49;
    const double z_322 = z_183*c_36;
    const double z_323 = delta_dot*c_50;
    const double z_324 = z_186*c_37;
    const double z_325 = delta_dot*cos_phi;
    const double z_326 = delta_dot*sin_phi;
    const double z_327 = cos_delta*z_23;
    const double z_328 = cos_delta*cos_phi;
    const double z_329 = cos_delta*z_1;
    const double z_330 = sin_phi*cos_delta;
    const double z_331 = sin_delta*z_61;
    const double z_332 = cos_theta*z_20;
    const double z_333 = cos_theta*sin_delta;
    const double z_334 = sin_delta*z_62;
    const double z_335 = sin_theta*z_20;
    const double z_336 = sin_theta*sin_delta;
    bias[5] = (-0.5)*((cos_delta*(c_6*z_151*z_155 + c_7*z_151*z_157 + z_320*(z_183*z_26) + z_320*(z_186*z_29) +
        z_23*z_324 + z_320*z_306 + z_1*z_237 + z_320*z_309 + z_320*z_315 + z_323*(sin_theta*z_279) +
        c_37*(z_147*z_159) + c_36*(z_150*z_159) + c_37*(cos_phi*z_233) + sin_phi*c_102 - z_321*z_302 - z_23*z_322
        - z_323*z_304 - z_308*z_323 - z_311*z_321 - z_1*z_238 - z_320*z_319 - z_321*(cos_theta*z_280) -
        c_36*(cos_phi*z_234)) - sin_delta*(c_3*(2.0*z_32*z_186 + z_147*z_157 + c_95*z_31 - 2.0*z_30*z_186 -
        2.0*z_67*z_200 - 2.0*z_163*z_200 - 2.0*z_312 - 2.0*sin_theta*z_286 - 2.0*z_233*z_26) + c_5*(2.0*z_30*z_183
        + 2.0*z_162*z_200 + 2.0*z_67*z_203 + 2.0*z_163*z_203 + 2.0*z_314 + 2.0*z_318 + z_147*z_155 + z_150*z_157 +
        2.0*sin_theta*z_285 + 2.0*z_233*z_29 + 2.0*z_234*z_26 - 2.0*z_32*z_183 - 2.0*z_37*z_186 - 2.0*z_36*z_186 -
        2.0*z_64*z_200 - 2.0*cos_theta*z_286 - c_95*z_35 - c_96*z_31) + c_4*(2.0*z_37*z_183 + 2.0*z_36*z_183 +
        2.0*z_64*z_203 + z_150*z_155 + 2.0*cos_theta*z_285 + c_96*z_35 - 2.0*z_162*z_203 - 2.0*z_316 -
        2.0*z_234*z_29) + z_325*z_322 + z_326*z_237 - 2.0*z_151*z_159 - z_325*z_324 - z_326*z_238)) -
        (2.0*c_5*(z_32*z_235 + z_26*z_208 - z_30*z_235 - sin_delta*z_303) + 2.0*c_5*(z_36*z_236 + z_37*z_236 +
        z_29*z_209 - sin_delta*z_305) + 2.0*c_7*(z_291*z_186 + z_327*z_186 + z_328*z_247) + 2.0*c_5*(z_64*z_217 +
        z_20*z_306 + sin_delta*z_307 - z_162*z_217) + 2.0*c_3*(z_67*z_217 + z_163*z_217 - z_20*z_308 -
        sin_delta*(z_274*z_31)) + 2.0*c_7*(z_329*z_200 + z_330*z_274 - z_288*z_200) + 2.0*c_3*(z_334*z_279 +
        z_335*z_279 - z_313*z_336) + 2.0*c_4*(z_331*z_280 + z_317*z_333 - z_332*z_280) + c_7*z_173 -
        2.0*c_4*(z_36*z_235 + z_37*z_235 + z_29*z_208 - sin_delta*(z_242*z_29)) - 2.0*c_6*(z_291*z_183 +
        z_327*z_183 + z_328*z_242) - 2.0*c_3*(z_32*z_236 + z_26*z_209 - z_30*z_236 - sin_delta*(z_247*z_26)) -
        2.0*c_5*(z_67*z_221 + z_163*z_221 - z_20*z_309 - sin_delta*z_310) - 2.0*c_4*(z_64*z_221 + z_20*z_311 +
        sin_delta*(z_275*z_35) - z_162*z_221) - 2.0*c_6*(z_329*z_203 + z_330*z_275 - z_288*z_203) -
        2.0*c_5*(z_331*z_279 + z_313*z_333 - z_332*z_279) - 2.0*c_5*(z_334*z_280 + z_335*z_280 - z_317*z_336) -
        c_6*z_175));
    const double R_yy = c[15];
    bias[6] = -R_yy*z_122;
    bias[7] = F_yy*z_167;
    const double c_103 = c[129];
    const double z_337 = z_330 + z_35*z_41 - z_31*z_25;
    const double z_338 = z_337*z_337;
    const double z_339 = 1.0 - z_338;
    const double z_340 = sqrt(z_339);
    const double z_341 = 1.0/z_340;
    const double z_342 = z_337*z_341;
    const double z_343 = r_F*z_342;
    const double z_344 = (z_329 - z_288) + c_6*(sin_delta*z_64 + z_35*z_20 - sin_delta*z_162) +
        c_7*(sin_delta*z_67 + sin_delta*z_163 - z_31*z_20);
    const double z_345 = z_344*z_341;
    const double z_346 = z_344*z_338/(z_339*z_340);
    const double z_347 = c_*z_13;
    const double z_348 = c_*z_10;
    const double z_349 = r_F*z_8;
    const double z_350 = z_10*r_F;
    const double c_104 = c[130];
    const double z_351 = sin_delta*z_342;
    const double c_105 = c[131];
    const double c_107 = c[133];
    const double c_111 = c[137];
    const double c_106 = c[132];
    const double c_112 = c[138];
    const double z_352 = ((z_61*z_349 + c_107*z_215) - (z_62*z_350 + c_111*z_213)) - ((r_R*z_61 - c_2*z_62) +
        ((z_62*z_347 - c_106*z_213) - (z_61*z_348 - c_112*z_215)));
    const double z_353 = c_105*z_342;
    const double z_354 = z_23*z_351 - z_129*z_342 - z_345*z_83 - z_346*z_83;
    const double z_355 = c_104*z_342;
    const double z_356 = z_163 + z_67;
    const double z_357 = z_64 - z_162;
    gamma[0] = -(phi_dot*(((sin_delta*c_103 + cos_delta*z_343)*z_23 - cos_phi*(c_103*z_20 - r_F*(z_27*z_342 -
        cos_delta*z_345 - cos_delta*z_346))) + ((r_R + sin_theta*z_347 + cos_theta*z_348 + cos_theta*z_349 +
        sin_theta*z_350 + sin_theta*(c_104*z_351) - r_R*cos_theta - sin_theta*c_2 - cos_theta*(c_105*z_351))*z_1 +
        sin_phi*(c_104*(z_62*z_351 + z_335*z_342 + z_345*z_336 + z_346*z_336) + c_105*(z_61*z_351 - z_332*z_342 -
        z_345*z_333 - z_346*z_333) - z_352))) + delta_dot*(((sin_phi*c_103 + z_35*z_355 - z_31*z_353)*z_27 -
        cos_delta*(c_103*z_1 + c_105*(z_67*z_342 + z_163*z_342 - z_31*z_345 - z_31*z_346) + c_104*(z_64*z_342 +
        z_35*z_345 + z_35*z_346 - z_162*z_342))) - ((c_5*(c_*z_31 + r_F*z_35) - c_106*z_35 - sin_phi*z_343 -
        c_107*z_31)*z_20 - sin_delta*(c_5*(c_*z_356 - r_F*z_357) + c_106*z_357 + r_F*(z_342*z_1 + sin_phi*z_345 +
        sin_phi*z_346) - c_107*z_356))) - theta_dot*(((z_267 + z_83*z_353 - cos_phi*z_348 - cos_phi*z_349)*z_62 -
        sin_theta*(z_196 + (c_112*z_291 - z_23*z_348) + c_105*z_354 - (z_23*z_349 + c_107*z_291))) + ((cos_phi*c_2
        - cos_phi*z_347 - cos_phi*z_350 - z_83*z_355)*z_61 + cos_theta*(c_2*z_23 + (c_111*z_291 - z_23*z_350) -
        (c_106*z_291 + z_23*z_347) - c_104*z_354))));
    gamma[1] = -z_121;
    gamma[2] = -z_57;
    const double z_358 = z_328 + z_26*z_25 - z_29*z_41;
    const double z_359 = z_338*z_341;
    const double z_360 = r_F*(z_358*z_340 + z_358*z_359);
    const double z_361 = sin_phi*z_41 - z_246 - z_244;
    const double z_362 = z_361*z_358;
    const double z_363 = r_F*(z_110*z_340 + z_342*z_362);
    const double z_364 = z_250 + z_248 + sin_phi*z_25;
    const double z_365 = z_364*z_358;
    const double z_366 = r_F*(z_109*z_340 - z_342*z_365);
    const double z_367 = z_344*z_342;
    const double z_368 = sin_phi*z_20 + sin_delta*z_1;
    const double z_369 = z_194 - c_7*z_368;
    const double z_370 = z_291 + z_327;
    const double z_371 = sin_delta*z_32 + z_20*z_26 - sin_delta*z_30;
    const double z_372 = sin_delta*z_36 + sin_delta*z_37 + z_20*z_29;
    const double z_373 = z_370 + c_6*z_372 - c_7*z_371;
    const double z_374 = r_F*(z_131*z_340 + z_109*z_367) - r_F*(z_342*(z_358*z_369) + z_342*(z_364*z_373) -
        z_345*z_365 - z_346*z_365);
    const double z_375 = z_358*z_367;
    const double z_376 = r_F*(z_375 + z_373*z_340) - r_F*(2.0*z_375 + z_346*(z_337*z_358) - z_373*z_359);
    const double z_377 = c_6*z_368 + z_189 + (-z_191);
    const double z_378 = r_F*(z_132*z_340 - z_110*z_367) + r_F*(z_342*(z_358*z_377) + z_345*z_362 + z_346*z_362 -
        z_342*(z_361*z_373));
    const double z_379 = c_7*(z_366*z_20 - sin_delta*z_374) + ((z_360*z_27 + cos_delta*z_376) - c_6*(z_363*z_20 +
        sin_delta*z_378));
    const double z_380 = z_10*z_363 + z_8*z_366 + z_360*z_25;
    const double z_381 = z_360*z_20 - sin_delta*z_376;
    const double z_382 = z_10*z_366 + z_13*z_363 - z_360*z_41;
    const double c_109 = c[135];
    const double z_383 = z_334 + z_335;
    const double c_110 = c[136];
    const double z_384 = z_331 - z_332;
    gamma[3] = -(z_121 - psi_dot*((z_382*z_64 + ((z_366*z_33 - z_10*z_374) - (z_363*z_44 - z_13*z_378) -
        c_6*z_381)*z_35 - z_382*z_162) - ((cos_delta*z_360 + z_363*z_41 - z_366*z_25)*z_1 - sin_phi*z_379) -
        (z_380*z_67 + z_380*z_163 - ((z_363*z_33 + z_10*z_378) + c_7*z_381 - (z_366*z_28 + z_8*z_374))*z_31) -
        z_141) - theta_dot*(z_379 - z_352) - delta_dot*(c_7*z_378 - c_6*z_374 - c_109*z_383 - c_110*z_384) -
        spin_f_dot*z_376);
    const double z_385 = cos_theta*z_41 + sin_theta*z_25;
    const double z_386 = r_F*(z_385*z_340 + z_385*z_359);
    const double z_387 = z_364*z_385;
    const double z_388 = r_F*(z_12*z_340 - z_342*z_387);
    const double z_389 = z_361*z_385;
    const double z_390 = r_F*(z_16*z_340 - z_342*z_389);
    const double z_391 = c_6*z_384 - c_7*z_383;
    const double z_392 = r_F*(z_79*z_340 + z_16*z_367) + r_F*(z_342*(z_385*z_377) + z_345*z_389 + z_346*z_389 -
        z_342*(z_361*z_391));
    const double z_393 = z_385*z_367;
    const double z_394 = r_F*(z_391*z_340 + z_393) - r_F*(2.0*z_393 + z_346*(z_337*z_385) - z_391*z_359);
    const double z_395 = r_F*(z_76*z_340 - z_12*z_367) + r_F*(z_342*(z_385*z_369) + z_342*(z_364*z_391) -
        z_345*z_387 - z_346*z_387);
    const double z_396 = c_6*(z_390*z_20 - sin_delta*z_392) + ((z_386*z_27 + cos_delta*z_394) + c_7*(z_388*z_20 +
        sin_delta*z_395));
    const double z_397 = z_8*z_388 + z_386*z_25 - z_10*z_390;
    const double z_398 = z_386*z_20 - sin_delta*z_394;
    const double z_399 = (z_388*z_28 - z_8*z_395) + (z_390*z_33 - z_10*z_392) - c_7*z_398;
    const double z_400 = z_13*z_390 + z_386*z_41 - z_10*z_388;
    const double z_401 = (z_390*z_44 + z_13*z_392) + (z_388*z_33 + z_10*z_395) - c_6*z_398;
    const double z_402 = c_106*z_27;
    const double z_403 = c_112*z_27;
    const double z_404 = c_107*z_27;
    const double z_405 = c_111*z_27;
    gamma[4] = -(z_57 + psi_dot*(((cos_delta*z_386 - z_388*z_25 - z_390*z_41)*z_1 - sin_phi*z_396) + (z_397*z_67 +
        z_397*z_163 + z_399*z_31) + (z_400*z_64 - z_400*z_162 - z_401*z_35) + z_102) - phi_dot*(z_196 +
        (z_397*z_62 - sin_theta*z_399) + c_2*z_357 + (z_67*z_348 + z_163*z_348 - z_31*z_403) + (z_67*z_349 +
        z_163*z_349 + z_31*z_404) - (z_400*z_61 + cos_theta*z_401) - r_R*z_356 - c_103*z_368 - (z_64*z_347 -
        z_35*z_402 - z_162*z_347) - (z_64*z_350 + z_35*z_405 - z_162*z_350)) - theta_dot*(z_396 + c_2*z_125 +
        (z_36*z_348 + z_37*z_348 + z_29*z_403) + (z_36*z_349 + z_37*z_349 - z_29*z_404) - r_R*z_124 - (z_32*z_347
        - z_30*z_347 - z_26*z_402) - (z_32*z_350 + z_26*z_405 - z_30*z_350)) - delta_dot*(c_6*z_395 + c_7*z_392 +
        c_109*z_371 + c_110*z_372 - c_103*z_370) - spin_f_dot*z_394);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double x_dot = v[0];
    const double c_0 = c[26];
    const double psi_dot = v[2];
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double m_B = c[7];
    const double r_R = c[4];
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double z_2 = r_R*sin_phi;
    const double x_B = c[10];
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double z_4 = sin_phi*sin_theta;
    const double c_1 = c[27];
    const double cos_theta = em_cos(theta);
    const double z_6 = sin_phi*cos_theta;
    const double z_7 = z_2 - x_B*z_4 - c_1*z_6;
    const double z_8 = m_B*z_7;
    const double m_F = c[9];
    const double c_ = c[1];
    const double c_3 = c[29];
    const double c_4 = c[30];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_10 = c_3 + c_4*cos_delta;
    const double c_5 = c[31];
    const double z_11 = c_5 - cos_delta*c_5;
    const double cos_phi = em_cos(phi);
    const double c_6 = c[32];
    const double sin_delta = em_sin(delta);
    const double z_14 = c_6*sin_delta;
    const double z_15 = z_10*z_4 + z_11*z_6 + cos_phi*z_14;
    const double r_F = c[5];
    const double z_16 = c_4 + c_3*cos_delta;
    const double c_7 = c[33];
    const double z_17 = c_7*sin_delta;
    const double z_18 = z_16*z_6 + z_11*z_4 - cos_phi*z_17;
    const double c_2 = c[28];
    const double z_19 = c_2*z_4 - (z_2 - r_R*z_6);
    const double z_20 = c_*z_15 + r_F*z_18 - z_19;
    const double z_21 = m_F*z_20;
    const double m_H = c[8];
    const double z_H = c[13];
    const double c_8 = c[34];
    const double z_22 = z_18*z_H + z_15*c_8 - z_19;
    const double z_23 = m_H*z_22;
    const double sin_psi = em_sin(psi);
    const double z_25 = x_B*cos_theta - sin_theta*c_1;
    const double z_26 = m_B*z_25;
    const double z_27 = cos_theta*z_11;
    const double z_28 = sin_theta*z_16 - z_27;
    const double z_29 = sin_theta*z_11;
    const double z_30 = cos_theta*z_10 - z_29;
    const double z_31 = cos_theta*c_2 - r_R*sin_theta;
    const double z_32 = r_F*z_28 + z_31 - c_*z_30;
    const double z_33 = m_F*z_32;
    const double z_34 = z_H*z_28 + z_31 - c_8*z_30;
    const double z_35 = m_H*z_34;
    const double c_9 = c[35];
    const double z_36 = sin_phi*c_9;
    const double z_37 = cos_psi*z_8 + cos_psi*z_21 + cos_psi*z_23 + cos_psi*z_36 - sin_psi*z_26 - sin_psi*z_33 -
        sin_psi*z_35;
    const double phi_dot = v[3];
    const double c_24 = c[50];
    const double z_38 = cos_phi*c_24;
    const double z_39 = sin_theta*cos_phi;
    const double c_25 = c[51];
    const double z_40 = sin_psi*c_25;
    const double z_41 = cos_theta*cos_phi;
    const double c_26 = c[52];
    const double z_42 = sin_psi*c_26;
    const double z_43 = sin_phi*sin_delta;
    const double c_27 = c[53];
    const double z_44 = sin_psi*c_27;
    const double c_28 = c[54];
    const double z_45 = z_16*c_28;
    const double z_46 = sin_psi*z_45;
    const double c_29 = c[55];
    const double z_47 = z_10*c_29;
    const double z_48 = sin_psi*z_47;
    const double z_49 = z_11*sin_psi;
    const double z_50 = c_29*z_49;
    const double z_51 = c_28*z_49;
    const double z_52 = sin_psi*z_38 + z_41*z_46 + z_39*z_48 + z_41*z_50 + z_39*z_51 - z_39*z_40 - z_41*z_42 -
        z_43*z_44;
    const double theta_dot = v[4];
    const double z_53 = cos_psi*c_25;
    const double z_54 = cos_psi*c_26;
    const double z_55 = cos_psi*z_45;
    const double z_56 = cos_psi*z_47;
    const double z_57 = cos_psi*z_11;
    const double z_58 = c_29*z_57;
    const double z_59 = c_28*z_57;
    const double z_60 = sin_theta*z_53 + cos_theta*z_54 + z_6*z_40 + z_4*z_46 + z_4*z_50 - cos_theta*z_55 -
        sin_theta*z_56 - cos_theta*z_58 - z_4*z_42 - sin_theta*z_59 - z_6*z_48 - z_6*z_51;
    const double delta_dot = v[5];
    const double z_61 = cos_theta*sin_delta;
    const double c_47 = c[73];
    const double z_62 = cos_psi*c_47;
    const double z_63 = cos_delta*cos_phi;
    const double z_64 = sin_theta*sin_delta;
    const double c_48 = c[74];
    const double z_65 = cos_psi*c_48;
    const double z_66 = sin_delta*z_6;
    const double z_67 = sin_psi*c_48;
    const double z_68 = sin_delta*z_4;
    const double z_69 = sin_psi*c_47;
    const double z_70 = z_61*z_62 + z_63*z_44 - z_64*z_65 - z_66*z_67 - z_68*z_69;
    const double y_dot = v[1];
    const double z_71 = cos_psi*z_26 + sin_psi*z_8 + cos_psi*z_33 + sin_psi*z_21 + cos_psi*z_35 + sin_psi*z_23 +
        sin_psi*z_36;
    const double z_72 = cos_psi*c_27;
    const double z_73 = z_39*z_53 + z_41*z_54 + z_43*z_72 - cos_psi*z_38 - z_41*z_55 - z_39*z_56 - z_41*z_58 -
        z_39*z_59;
    const double z_74 = sin_theta*z_40 + cos_theta*z_42 + z_4*z_54 + z_6*z_56 + z_6*z_59 - cos_theta*z_46 -
        sin_theta*z_48 - cos_theta*z_50 - z_6*z_53 - sin_theta*z_51 - z_4*z_55 - z_4*z_58;
    const double z_75 = z_61*z_69 + z_68*z_62 + z_66*z_65 - z_64*z_67 - z_63*z_72;
    const double z_76 = c_6*z_43 - z_10*z_39 - z_11*z_41;
    const double c_10 = c[36];
    const double z_77 = z_16*z_41 + z_11*z_39 + c_7*z_43;
    const double c_11 = c[37];
    const double z_78 = z_77*c_11 - z_76*c_10;
    const double c_12 = c[38];
    const double z_79 = z_76*c_11 - z_77*c_12;
    const double z_80 = sin_phi*cos_delta + z_39*z_14 - z_41*z_17;
    const double c_13 = c[39];
    const double z_81 = cos_delta*c_13;
    const double c_14 = c[40];
    const double z_82 = (z_78*z_14 + z_79*z_17) - (z_80*z_81 + sin_phi*c_14);
    const double c_15 = c[41];
    const double c_16 = c[42];
    const double c_17 = c[43];
    const double z_83 = sin_delta*z_80;
    const double z_84 = z_10*z_78 + c_15*z_39 + c_16*z_41 + c_17*z_83 - z_11*z_79;
    const double c_18 = c[44];
    const double c_19 = c[45];
    const double z_85 = z_11*z_78 + c_18*z_41 + c_16*z_39 - z_16*z_79 - c_19*z_83;
    const double c_20 = c[46];
    const double c_21 = c[47];
    const double c_22 = c[48];
    const double c_23 = c[49];
    const double c_30 = c[56];
    const double c_31 = c[57];
    const double z_86 = z_32*c_30 + z_34*c_31;
    const double z_87 = z_16*z_86;
    const double c_32 = c[58];
    const double c_33 = c[59];
    const double z_88 = z_32*c_32 + z_34*c_33;
    const double z_89 = z_10*z_88;
    const double z_90 = z_11*z_88;
    const double z_91 = z_11*z_86;
    const double z_92 = z_33 + z_35;
    const double c_34 = c[60];
    const double z_93 = z_92*c_34;
    const double c_35 = c[61];
    const double z_94 = z_92*c_35;
    const double c_36 = c[62];
    const double z_95 = z_88*c_36;
    const double c_37 = c[63];
    const double z_96 = z_86*c_37;
    const double c_38 = c[64];
    const double z_97 = z_25*c_38;
    const double c_39 = c[65];
    const double z_98 = z_25*c_39;
    const double z_99 = sin_theta*z_85 + z_41*z_93 + z_39*z_94 + z_43*z_95 + z_39*z_97 + z_41*z_98 -
        cos_theta*z_84 - 2.0*z_41*z_87 - 2.0*z_39*z_89 - 2.0*z_41*z_90 - 2.0*z_39*z_91 - cos_phi*(z_26 +
        z_92)*c_34 - z_43*z_96;
    const double z_100 = z_20*c_30 + z_22*c_31;
    const double z_101 = cos_theta*z_16;
    const double z_102 = z_20*c_32 + z_22*c_33;
    const double z_103 = sin_theta*z_10;
    const double z_104 = z_21 + z_23;
    const double z_105 = cos_theta*c_34;
    const double z_106 = sin_theta*c_35;
    const double z_107 = z_82 + 2.0*z_6*z_89 + 2.0*z_6*z_91 + z_104*z_105 + z_104*z_106 + c_38*(sin_theta*z_7) +
        c_39*(cos_theta*z_7) + z_4*z_93 + z_4*z_98 - 2.0*z_100*z_101 - 2.0*z_102*z_103 - 2.0*z_27*z_102 -
        2.0*z_29*z_100 - 2.0*z_4*z_87 - 2.0*z_4*z_90 - z_6*z_94 - z_6*z_97;
    const double c_49 = c[75];
    const double c_50 = c[76];
    const double c_51 = c[77];
    const double z_108 = c_7*z_78 + c_49*(z_102*z_61) + z_63*z_96 + c_49*(z_88*z_68) + c_50*(z_86*z_66) +
        c_51*(z_102*z_64) - c_6*z_79 - c_50*(z_100*z_64) - z_63*z_95 - c_51*(z_100*z_61) - c_51*(z_88*z_66) -
        c_51*(z_86*z_68);
    const double c_100 = c[126];
    const double spin_r_dot = v[6];
    const double spin_f_dot = v[7];
    const double c_120 = c[146];
    const double z_109 = spin_f_dot*c_120;
    const double z_110 = z_30*c_11 - z_28*c_12;
    const double z_111 = z_28*c_11 - z_30*c_10;
    const double z_112 = c_6*z_61 + c_7*z_64;
    const double z_113 = sin_delta*z_112;
    const double z_114 = z_27 + z_103;
    const double z_115 = z_29 + z_101;
    const double z_116 = sin_theta*c_2 - (r_R - r_R*cos_theta);
    const double z_117 = c_*z_114 + r_F*z_115 - z_116;
    const double z_118 = z_H*z_115 + c_8*z_114 - z_116;
    const double z_119 = c_30*z_117 + c_31*z_118;
    const double z_120 = c_32*z_117 + c_33*z_118;
    const double z_121 = r_R - x_B*sin_theta - c_1*cos_theta;
    const double z_122 = m_F*z_117 + m_H*z_118;
    const double c_40 = c[66];
    const double z_123 = sin_delta*sin_delta;
    const double c_41 = c[67];
    const double c_42 = c[68];
    const double c_43 = c[69];
    const double c_44 = c[70];
    const double z_124 = z_111*z_14 + z_110*z_17 + z_112*z_81 + c_44*z_61 + c_43*(z_16*z_64) + c_42*(z_11*z_64) -
        c_41*z_64 - c_42*(z_10*z_61) - c_43*(z_11*z_61);
    const double c_52 = c[78];
    const double c_53 = c[79];
    const double z_125 = c_7*z_111 + c_36*(cos_delta*z_120) - c_6*z_110 - c_52*(cos_theta*z_123) -
        c_53*(sin_theta*z_123) - c_37*(cos_delta*z_119);
    const double z_126 = r_R - c_*z_11 - r_F*z_16;
    const double z_127 = r_R - z_16*z_H - z_11*c_8;
    const double z_128 = c_30*z_126 + c_31*z_127;
    const double z_129 = c_2 - c_*z_10 - z_11*r_F;
    const double z_130 = c_2 - z_11*z_H - z_10*c_8;
    const double z_131 = c_32*z_129 + c_33*z_130;
    const double z_132 = c_32*z_126 + c_33*z_127;
    const double z_133 = c_30*z_129 + c_31*z_130;
    const double c_45 = c[71];
    const double c_46 = c[72];
    const double c_54 = c[80];
    const double z_134 = sin_delta*c_51;
    const double z_135 = sin_delta*c_54 + c_49*(sin_delta*z_132) + z_131*z_134 - c_50*(sin_delta*z_133) -
        z_128*z_134;
    const double c_121 = c[147];
    const double R_yy = c[15];
    const double F_yy = c[17];
    e[0] = 0.25*(2.0*x_dot*(x_dot*c_0 + psi_dot*z_37 + phi_dot*z_52 + delta_dot*z_70 - theta_dot*z_60) +
        2.0*y_dot*(y_dot*c_0 + psi_dot*z_71 + phi_dot*z_73 + delta_dot*z_75 - theta_dot*z_74) +
        psi_dot*(2.0*x_dot*z_37 + 2.0*y_dot*z_71 + psi_dot*(z_84*z_39 + z_85*z_41 + c_20*(z_25*z_25) +
        c_20*(z_7*z_7) + c_21*(z_32*z_32) + c_21*(z_20*z_20) + c_22*(z_34*z_34) + c_22*(z_22*z_22) +
        c_23*(sin_phi*sin_phi) - sin_phi*z_82) + phi_dot*z_99 + delta_dot*z_108 + c_100*(spin_r_dot*sin_phi) +
        z_80*z_109 - theta_dot*z_107) + phi_dot*(2.0*x_dot*z_52 + 2.0*y_dot*z_73 + psi_dot*z_99 +
        phi_dot*(2.0*z_101*z_119 + 2.0*z_103*z_120 + 2.0*z_27*z_120 + 2.0*z_29*z_119 + (c_9 + m_B*z_121 +
        z_122)*c_34 - sin_theta*(z_16*z_110 + cos_theta*c_16 - z_11*z_111 - sin_theta*c_18 - c_19*z_113) -
        cos_theta*(z_10*z_111 + sin_theta*c_16 - z_11*z_110 - cos_theta*c_15 - c_17*z_113) - c_40*z_123 -
        z_122*z_105 - z_122*z_106 - c_38*(sin_theta*z_121) - c_39*(cos_theta*z_121)) + delta_dot*z_125 -
        theta_dot*z_124 - z_112*z_109) + delta_dot*(2.0*x_dot*z_70 + 2.0*y_dot*z_75 + psi_dot*z_108 +
        phi_dot*z_125 - theta_dot*z_135 - delta_dot*c_121) + 2.0*spin_r_dot*(R_yy*(theta_dot + spin_r_dot +
        psi_dot*sin_phi)) + 2.0*spin_f_dot*(F_yy*(spin_f_dot + psi_dot*z_80 + theta_dot*cos_delta -
        phi_dot*z_112)) - theta_dot*(2.0*x_dot*z_60 + 2.0*y_dot*z_74 + psi_dot*z_107 + phi_dot*z_124 +
        delta_dot*z_135 - theta_dot*(c_45*z_123 + c_46 + (m_F*z_126 + m_H*z_127)*c_34 + c_13*(cos_delta*cos_delta)
        + (m_F*z_129 + m_H*z_130)*c_35 - 2.0*z_16*z_128 - 2.0*z_10*z_131 - 2.0*z_11*z_132 - 2.0*z_11*z_133) -
        spin_r_dot*c_100 - cos_delta*z_109));
    e[1] = 0.0;
    e[2] = 0.0;
    const double g = c[3];
    const double z_136 = r_R*cos_phi;
    const double z_137 = c_2*z_39 - (z_136 - r_R*z_41);
    e[3] = g*(m_B*(z_136 - x_B*z_39 - c_1*z_41) + m_F*(r_F*z_77 - c_*z_76 - z_137) + m_H*(z_H*z_77 - c_8*z_76 -
        z_137) + cos_phi*c_9);
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
    const double x_ = x[0];
    p[0] = x_;
    const double y = x[1];
    p[1] = y;
    p[2] = 0.0;
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double r_F = c[5];
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double c_4 = c[30];
    const double c_3 = c[29];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_3 = c_4 + c_3*cos_delta;
    const double cos_theta = em_cos(theta);
    const double c_5 = c[31];
    const double z_5 = c_5 - cos_delta*c_5;
    const double z_6 = sin_theta*z_3 - cos_theta*z_5;
    const double c_2 = c[28];
    const double c_ = c[1];
    const double z_7 = c_3 + c_4*cos_delta;
    const double z_8 = cos_theta*z_7 - sin_theta*z_5;
    const double r_R = c[4];
    const double z_9 = (r_F*z_6 + cos_theta*c_2) - (c_*z_8 + r_R*sin_theta);
    const double c_6 = c[32];
    const double sin_delta = em_sin(delta);
    const double z_11 = c_6*sin_delta;
    const double c_7 = c[33];
    const double z_12 = c_7*sin_delta;
    const double z_13 = cos_theta*z_11 + sin_theta*z_12;
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double cos_phi = em_cos(phi);
    const double z_16 = sin_theta*cos_phi;
    const double z_17 = cos_theta*cos_phi;
    const double z_18 = sin_phi*cos_delta + z_16*z_11 - z_17*z_12;
    const double z_19 = sqrt(1.0 - z_18*z_18);
    const double z_20 = r_F*z_18/z_19;
    const double z_21 = z_9 - z_13*z_20;
    const double sin_psi = em_sin(psi);
    const double z_23 = sin_phi*cos_theta;
    const double z_24 = sin_phi*sin_theta;
    const double z_25 = z_3*z_23 + z_5*z_24 - cos_phi*z_12;
    const double z_26 = r_R*sin_phi;
    const double z_27 = z_7*z_24 + z_5*z_23 + cos_phi*z_11;
    const double z_28 = (r_F*z_25 - r_R*z_23) - (c_2*z_24 - (z_26 + c_*z_27));
    const double z_29 = cos_delta*cos_phi + z_23*z_12 - z_24*z_11;
    const double z_30 = z_28 - z_29*z_20;
    p[3] = x_ + cos_psi*z_21 + sin_psi*z_30;
    p[4] = y + sin_psi*z_21 - cos_psi*z_30;
    const double z_31 = z_3*z_17 + z_5*z_16 + sin_phi*z_12;
    const double z_32 = sin_phi*z_11 - z_7*z_16 - z_5*z_17;
    const double z_33 = r_R*cos_phi;
    const double z_34 = (c_2*z_16 - r_F*z_31) + (c_*z_32 - (z_33 - r_R*z_17));
    p[5] = -r_F*z_19 - z_34;
    p[6] = p[22] = x_ + z_26*sin_psi;
    p[7] = p[23] = y - z_26*cos_psi;
    p[8] = p[24] = z_33;
    p[9] = r_R;
    p[10] = -cos_phi*sin_psi;
    p[11] = cos_psi*cos_phi;
    p[12] = sin_phi;
    const double spin_r = x[6];
    p[13] = theta + spin_r;
    p[14] = p[37] = cos_psi*z_9 + z_28*sin_psi + x_;
    p[15] = p[38] = -(cos_psi*z_28 - sin_psi*z_9 - y);
    p[16] = p[39] = -z_34;
    p[17] = r_F;
    p[18] = -(cos_psi*z_13 + sin_psi*z_29);
    p[19] = cos_psi*z_29 - sin_psi*z_13;
    p[20] = z_18;
    const double spin_f = x[7];
    p[21] = spin_f;
    const double z_B = c[11];
    const double c_122 = c[148];
    const double z_35 = sin_theta*z_B + cos_theta*c_122;
    const double c_34 = c[60];
    const double z_36 = z_B*z_23 + sin_phi*c_34 - c_122*z_24;
    p[25] = p[28] = 0.5*(2.0*x_ + cos_psi*z_35 + sin_psi*z_36);
    p[26] = p[29] = 0.5*(2.0*y + sin_psi*z_35 - cos_psi*z_36);
    p[27] = p[30] = 0.5*(z_B*z_17 + cos_phi*c_34 - c_122*z_16);
    const double c_123 = c[149];
    const double c_124 = c[150];
    const double c_125 = c[151];
    const double c_126 = c[152];
    const double z_37 = cos_theta*c_123 + z_6*c_125 - sin_theta*c_124 - z_8*c_126;
    const double z_38 = sin_phi*c_124 + z_25*c_125 + z_27*c_126 - c_124*z_23 - c_123*z_24;
    p[31] = p[34] = 0.25*(4.0*x_ + cos_psi*z_37 + sin_psi*z_38);
    p[32] = p[35] = 0.25*(4.0*y + sin_psi*z_37 - cos_psi*z_38);
    p[33] = p[36] = 0.25*(cos_phi*c_124 + z_31*c_125 - c_124*z_17 - c_123*z_16 - z_32*c_126);
    const double x_B = c[10];
    const double c_1 = c[27];
    const double z_39 = x_B*cos_theta - sin_theta*c_1;
    const double z_40 = z_26 - x_B*z_24 - c_1*z_23;
    p[40] = cos_psi*z_39 + z_40*sin_psi + x_;
    p[41] = -(z_40*cos_psi - z_39*sin_psi - y);
    p[42] = z_33 - x_B*z_16 - c_1*z_17;
    const double c_127 = c[153];
    p[43] = c_127;
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
    const double x_B = c[10];
    const double theta = x[4];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    const double r_R = c[4];
    const double z_B = c[11];
    const double z_2 = r_R - z_B;
    const double z_3 = x_B*cos_theta - sin_theta*z_2;
    const double m_B = c[7];
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double z_5 = m_B*cos_psi;
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double z_7 = r_R*sin_phi;
    const double z_8 = sin_phi*sin_theta;
    const double z_9 = sin_phi*cos_theta;
    const double z_10 = z_7 - x_B*z_8 - z_2*z_9;
    const double sin_psi = em_sin(psi);
    const double z_12 = m_B*sin_psi;
    const double r_F = c[5];
    const double tilt = c[2];
    const double cos_tilt = em_cos(tilt);
    const double z_14 = cos_tilt*cos_tilt;
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double sin_tilt = em_sin(tilt);
    const double z_17 = sin_tilt*sin_tilt;
    const double z_18 = cos_delta*z_17;
    const double z_19 = z_14 + z_18;
    const double z_20 = sin_theta*z_19;
    const double z_21 = sin_tilt*cos_tilt;
    const double z_22 = cos_delta*z_21;
    const double z_23 = z_21 - z_22;
    const double z_24 = cos_theta*z_23;
    const double z_25 = z_20 - z_24;
    const double c_ = c[1];
    const double z_26 = cos_delta*z_14;
    const double z_27 = z_17 + z_26;
    const double z_28 = cos_theta*z_27;
    const double z_29 = sin_theta*z_23;
    const double z_30 = z_28 - z_29;
    const double w = c[0];
    const double z_31 = c_ + w;
    const double z_32 = cos_theta*z_31;
    const double z_33 = r_R*sin_theta;
    const double z_34 = z_32 - z_33;
    const double z_35 = r_F*z_25 + z_34 - c_*z_30;
    const double m_F = c[9];
    const double z_36 = m_F*cos_psi;
    const double z_37 = z_27*z_8;
    const double z_38 = z_23*z_9;
    const double cos_phi = em_cos(phi);
    const double sin_delta = em_sin(delta);
    const double z_41 = cos_tilt*sin_delta;
    const double z_42 = cos_phi*z_41;
    const double z_43 = z_37 + z_38 + z_42;
    const double z_44 = z_19*z_9;
    const double z_45 = z_23*z_8;
    const double z_46 = sin_tilt*sin_delta;
    const double z_47 = cos_phi*z_46;
    const double z_48 = z_44 + z_45 - z_47;
    const double z_49 = z_31*z_8 - (z_7 - r_R*z_9);
    const double z_50 = c_*z_43 + r_F*z_48 - z_49;
    const double z_51 = m_F*sin_psi;
    const double z_H = c[13];
    const double x_H = c[12];
    const double z_52 = z_31 - x_H;
    const double z_53 = z_H*z_25 + z_34 - z_52*z_30;
    const double m_H = c[8];
    const double z_54 = m_H*cos_psi;
    const double z_55 = z_48*z_H + z_43*z_52 - z_49;
    const double z_56 = m_H*sin_psi;
    const double m_R = c[6];
    const double z_57 = m_R*z_7;
    dM[144] = dM[130] = -(z_3*z_5 + z_10*z_12 + z_35*z_36 + z_50*z_51 + z_53*z_54 + z_55*z_56 + sin_psi*z_57);
    dM[145] = dM[138] = z_10*z_5 + z_50*z_36 + z_55*z_54 + cos_psi*z_57 - z_3*z_12 - z_35*z_51 - z_53*z_56;
    const double z_58 = sin_theta*cos_phi;
    const double z_59 = m_B*x_B;
    const double z_60 = m_F + m_H;
    const double z_61 = z_59 + z_31*z_60;
    const double z_62 = cos_psi*z_61;
    const double z_63 = cos_theta*cos_phi;
    const double z_64 = m_B*z_2;
    const double z_65 = z_64 + r_R*z_60;
    const double z_66 = cos_psi*z_65;
    const double z_67 = cos_psi*sin_delta;
    const double z_68 = m_F*c_;
    const double z_69 = m_H*z_52;
    const double z_70 = z_68 + z_69;
    const double z_71 = m_F*r_F;
    const double z_72 = m_H*z_H;
    const double z_73 = z_71 + z_72;
    const double z_74 = cos_tilt*z_70 - sin_tilt*z_73;
    const double z_75 = sin_phi*z_74;
    const double z_76 = m_B + m_R + z_60;
    const double z_77 = r_R*cos_phi;
    const double z_78 = z_76*z_77;
    const double z_79 = z_19*z_63;
    const double z_80 = cos_psi*z_73;
    const double z_81 = z_27*z_58;
    const double z_82 = cos_psi*z_70;
    const double z_83 = z_23*z_63;
    const double z_84 = z_23*z_58;
    dM[152] = dM[131] = -(z_58*z_62 + z_63*z_66 + z_67*z_75 - cos_psi*z_78 - z_79*z_80 - z_81*z_82 - z_83*z_82 -
        z_84*z_80);
    const double z_85 = sin_psi*z_61;
    const double z_86 = sin_psi*z_65;
    const double z_87 = sin_delta*sin_psi;
    const double z_88 = sin_psi*z_73;
    const double z_89 = sin_psi*z_70;
    dM[153] = dM[139] = sin_psi*z_78 + z_79*z_88 + z_81*z_89 + z_83*z_89 + z_84*z_88 - z_58*z_85 - z_63*z_86 -
        z_87*z_75;
    const double z_90 = cos_theta*z_19;
    const double z_91 = sin_theta*z_27;
    const double z_92 = z_19*z_8;
    const double z_93 = z_27*z_9;
    dM[160] = dM[132] = sin_theta*z_85 + cos_theta*z_86 + z_8*z_66 + z_93*z_82 + z_38*z_80 - z_90*z_88 - z_91*z_89
        - z_24*z_89 - z_9*z_62 - z_29*z_88 - z_92*z_80 - z_45*z_82;
    dM[161] = dM[140] = -(sin_theta*z_62 + cos_theta*z_66 + z_9*z_85 + z_92*z_88 + z_45*z_89 - z_90*z_80 -
        z_91*z_82 - z_24*z_82 - z_8*z_86 - z_29*z_80 - z_93*z_89 - z_38*z_88);
    const double z_94 = z_70*z_14 - z_21*z_73;
    const double z_95 = z_94*z_87;
    const double z_96 = z_73*z_17 - z_21*z_70;
    const double z_97 = z_96*z_87;
    const double z_98 = cos_psi*cos_delta;
    const double z_99 = cos_phi*z_74;
    const double z_100 = z_94*z_67;
    const double z_101 = z_96*z_67;
    dM[168] = dM[133] = -(cos_theta*z_95 + z_8*z_100 + z_9*z_101 - sin_theta*z_97 - z_98*z_99);
    const double z_102 = cos_delta*sin_psi;
    dM[169] = dM[141] = cos_theta*z_100 + z_102*z_99 - sin_theta*z_101 - z_9*z_97 - z_8*z_95;
    const double z_103 = z_77 - x_B*z_58 - z_2*z_63;
    const double z_104 = sin_phi*z_46;
    const double z_105 = z_79 + z_84 + z_104;
    const double z_106 = sin_phi*z_41;
    const double z_107 = z_106 - z_81 - z_83;
    const double z_108 = z_31*z_58;
    const double z_109 = r_R*z_63;
    const double z_110 = z_108 - (z_77 - z_109);
    const double z_111 = r_F*z_105 - c_*z_107 - z_110;
    const double z_112 = z_H*z_105 - z_52*z_107 - z_110;
    const double z_113 = m_R*z_77;
    dM[208] = dM[194] = z_103*z_5 + z_111*z_36 + z_112*z_54 + cos_psi*z_113;
    dM[209] = dM[202] = z_103*z_12 + z_111*z_51 + z_112*z_56 + sin_psi*z_113;
    const double z_114 = m_B*z_10;
    const double z_115 = m_F*z_50;
    const double z_116 = m_H*z_55;
    const double H_xz = c[25];
    const double H_xx = c[22];
    const double F_xx = c[16];
    const double z_117 = H_xx + 2.0*F_xx;
    const double z_118 = H_xx + z_117;
    const double z_119 = 2.0*H_xz*z_105 - z_107*z_118;
    const double H_zz = c[24];
    const double z_120 = 2.0*F_xx + H_zz;
    const double z_121 = H_zz + z_120;
    const double z_122 = 2.0*z_107*H_xz - z_105*z_121;
    const double z_123 = sin_phi*cos_delta + z_58*z_41 - z_46*z_63;
    const double F_yy = c[17];
    const double H_yy = c[23];
    const double z_124 = F_yy + H_yy;
    const double z_125 = cos_delta*z_124;
    const double B_yy = c[19];
    const double R_yy = c[15];
    const double z_126 = B_yy + R_yy;
    const double z_127 = 2.0*z_48*H_xz + z_43*z_118;
    const double z_128 = 2.0*z_43*H_xz + z_48*z_121;
    const double z_129 = cos_delta*cos_phi + z_46*z_9 - z_8*z_41;
    const double z_130 = (z_127*z_41 - z_128*z_46) + 2.0*(z_129*z_125 + cos_phi*z_126);
    const double B_xz = c[21];
    const double z_131 = B_xz*z_63;
    const double z_132 = z_124*z_41;
    const double B_xx = c[18];
    const double R_xx = c[14];
    const double z_133 = B_xx + (B_xx + 2.0*R_xx);
    const double z_134 = z_27*z_119 + 2.0*z_131 + 2.0*z_123*z_132 + z_133*z_58 - z_23*z_122;
    const double z_135 = z_27*z_127 + z_23*z_128 + 2.0*B_xz*z_9 + z_133*z_8 - 2.0*z_129*z_132;
    const double z_136 = B_xz*z_58;
    const double z_137 = z_124*z_46;
    const double B_zz = c[20];
    const double z_138 = B_zz + (2.0*R_xx + B_zz);
    const double z_139 = z_23*z_119 + 2.0*z_136 + z_138*z_63 - z_19*z_122 - 2.0*z_123*z_137;
    const double z_140 = z_23*z_127 + z_19*z_128 + 2.0*B_xz*z_8 + 2.0*z_129*z_137 + z_138*z_9;
    dM[210] = 0.5*(4.0*z_103*z_114 + 4.0*z_115*z_111 + 4.0*z_116*z_112 + 4.0*m_R*sin_phi*cos_phi*(r_R*r_R) -
        (cos_phi*(z_119*z_41 + z_122*z_46 - 2.0*z_123*z_125 - 2.0*sin_phi*z_126) - sin_phi*z_130) - (z_134*z_8 +
        z_135*z_58) - (z_139*z_9 + z_140*z_63));
    const double z_141 = z_76*z_7;
    const double z_142 = z_87*z_99;
    const double z_143 = (z_38*z_89 + z_45*z_88) - ((z_8*z_85 + z_9*z_86) - (z_44*z_88 + z_37*z_89));
    dM[216] = dM[195] = -(sin_psi*z_141 + z_142 + z_143);
    const double z_144 = z_67*z_99;
    const double z_145 = (z_38*z_82 + z_45*z_80) - ((z_8*z_62 + z_9*z_66) - (z_44*z_80 + z_37*z_82));
    dM[217] = dM[203] = -(-z_144 - cos_psi*z_141 - z_145);
    const double z_146 = m_B*z_3;
    const double z_147 = m_F*z_35;
    const double z_148 = m_H*z_53;
    const double z_149 = z_147 + z_148;
    const double z_150 = z_146 + z_149;
    const double z_151 = r_R*z_149;
    const double z_152 = z_9*z_151;
    const double z_153 = z_31*z_149;
    const double z_154 = z_8*z_153;
    const double z_155 = z_35*z_68 + z_53*z_69;
    const double z_156 = z_42*z_155;
    const double z_157 = z_35*z_71 + z_53*z_72;
    const double z_158 = z_44*z_157;
    const double z_159 = z_37*z_155;
    const double z_160 = z_38*z_155;
    const double z_161 = z_45*z_157;
    const double z_162 = z_47*z_157;
    const double z_163 = z_3*z_59;
    const double z_164 = z_8*z_163;
    const double z_165 = z_3*z_64;
    const double z_166 = z_9*z_165;
    dM[218] = dM[211] = (-0.5)*(sin_theta*z_140 + 2.0*z_152 + 2.0*z_154 + 2.0*z_162 + 2.0*z_164 + 2.0*z_166 -
        cos_theta*z_135 - 2.0*z_7*z_150 - 2.0*z_156 - 2.0*z_158 - 2.0*z_159 - 2.0*z_160 - 2.0*z_161);
    const double z_167 = z_27*z_63;
    const double z_168 = z_19*z_58;
    dM[224] = dM[196] = z_58*z_86 + z_167*z_89 + z_83*z_88 - z_63*z_85 - z_168*z_88 - z_84*z_89;
    dM[225] = dM[204] = z_63*z_62 + z_168*z_80 + z_84*z_82 - z_58*z_66 - z_167*z_82 - z_83*z_80;
    const double z_169 = z_71*z_111 + z_72*z_112;
    const double z_170 = z_68*z_111 + z_69*z_112;
    const double z_171 = r_R*cos_theta;
    const double z_172 = m_F*z_111 + m_H*z_112;
    const double z_173 = sin_theta*z_31;
    const double z_174 = z_63*z_153;
    const double z_175 = z_157*z_168;
    const double z_176 = z_84*z_155;
    const double z_177 = sin_theta*z_59;
    const double z_178 = cos_theta*z_64;
    const double z_179 = z_58*z_151;
    const double z_180 = z_155*z_167;
    const double z_181 = z_83*z_157;
    const double z_182 = z_63*z_163;
    const double z_183 = z_58*z_165;
    dM[226] = dM[212] = 0.5*(z_130 + 2.0*z_90*z_169 + 2.0*z_91*z_170 + 2.0*z_24*z_170 + 2.0*z_29*z_169 + 2.0*z_174
        + 2.0*z_175 + 2.0*z_176 + 2.0*z_182 - 2.0*z_171*z_172 - 2.0*z_173*z_172 - 2.0*z_103*z_177 -
        2.0*z_103*z_178 - 2.0*z_179 - 2.0*z_180 - 2.0*z_181 - 2.0*z_183);
    dM[232] = dM[197] = -(z_75*z_102 + z_63*z_97 + z_58*z_95);
    dM[233] = dM[205] = z_75*z_98 + z_58*z_100 + z_63*z_101;
    const double z_184 = sin_delta*z_14;
    const double z_185 = cos_theta*z_184;
    const double z_186 = sin_tilt*cos_delta;
    const double z_187 = sin_phi*z_186;
    const double z_188 = z_157*z_187;
    const double z_189 = sin_delta*z_17;
    const double z_190 = sin_theta*z_189;
    const double z_191 = cos_tilt*cos_delta;
    const double z_192 = sin_phi*z_191;
    const double z_193 = z_155*z_192;
    const double z_194 = z_58*z_184;
    const double z_195 = z_155*z_194;
    const double z_196 = z_63*z_189;
    const double z_197 = z_157*z_196;
    const double z_198 = cos_tilt*z_46;
    const double z_199 = sin_theta*z_198;
    const double z_200 = cos_theta*z_198;
    const double z_201 = z_63*z_198;
    const double z_202 = z_155*z_201;
    const double z_203 = z_58*z_198;
    const double z_204 = z_157*z_203;
    dM[234] = dM[213] = (-0.5)*(sin_tilt*z_127 + cos_tilt*z_128 + 2.0*z_188 + 2.0*z_190*z_169 + 2.0*z_200*z_169 +
        2.0*z_202 + 2.0*z_204 - 2.0*z_185*z_170 - 2.0*z_193 - 2.0*z_195 - 2.0*z_197 - 2.0*z_199*z_170);
    dM[242] = dM[214] = cos_phi*R_yy;
    dM[250] = dM[215] = F_yy*z_129;
    const double z_205 = x_B*z_9 - z_2*z_8;
    const double z_206 = z_45 - z_93;
    const double z_207 = z_38 - z_92;
    const double z_208 = z_31*z_9;
    const double z_209 = r_R*z_8;
    const double z_210 = z_208 - z_209;
    const double z_211 = c_*z_206 + z_210 - r_F*z_207;
    const double z_212 = z_52*z_206 + z_210 - z_H*z_207;
    const double z_213 = x_B*sin_theta + z_2*cos_theta;
    const double z_214 = z_171 + z_173;
    const double z_215 = z_24 + z_91;
    const double z_216 = z_29 + z_90;
    const double z_217 = c_*z_215 + r_F*z_216;
    const double z_218 = z_217 - z_214;
    const double z_219 = z_H*z_216 + z_52*z_215;
    const double z_220 = z_214 - z_219;
    dM[272] = dM[258] = -(z_205*z_5 + z_211*z_36 + z_212*z_54 + z_218*z_51 - z_213*z_12 - z_220*z_56);
    dM[273] = dM[266] = -(z_213*z_5 + z_205*z_12 + z_211*z_51 + z_220*z_54 + z_212*z_56 - z_218*z_36);
    const double z_221 = z_63*z_41 + z_46*z_58;
    const double z_222 = z_83 - z_168;
    const double z_223 = z_84 - z_167;
    const double z_224 = 2.0*H_xz*z_222 - z_118*z_223;
    const double z_225 = 2.0*H_xz*z_223 - z_121*z_222;
    const double z_226 = z_221*z_125 - 0.5*(z_224*z_41 + z_225*z_46);
    const double z_227 = 2.0*z_136 + z_23*z_225 - z_27*z_224 - 2.0*z_221*z_132 - z_133*z_63;
    const double z_228 = 2.0*z_131 + z_23*z_224 - z_19*z_225 - 2.0*z_221*z_137 - z_138*z_58;
    dM[274] = (-0.5)*(4.0*z_146*z_213 + 4.0*z_205*z_114 + 4.0*z_115*z_211 + 4.0*z_148*z_220 + 4.0*z_116*z_212 +
        sin_phi*(-2.0*z_226) + (z_139*z_58 - z_228*z_63) - 4.0*z_147*z_218 - (z_134*z_63 - z_227*z_58));
    dM[280] = dM[259] = z_58*z_86 + z_167*z_89 + z_83*z_88 - z_63*z_85 - z_168*z_88 - z_84*z_89;
    dM[281] = dM[267] = z_63*z_62 + z_168*z_80 + z_84*z_82 - z_58*z_66 - z_167*z_82 - z_83*z_80;
    const double z_229 = m_F*z_218 - m_H*z_220;
    const double z_230 = z_68*z_218 - z_69*z_220;
    const double z_231 = z_71*z_218 - z_72*z_220;
    const double z_232 = z_59*z_213;
    const double z_233 = z_64*z_213;
    dM[282] = dM[275] = 0.5*((cos_theta*z_139 + sin_theta*z_228) + (sin_theta*z_134 + cos_theta*z_227) +
        2.0*z_77*(m_B*z_213 - z_229) + 2.0*(z_174 + z_108*z_229) + 2.0*z_106*z_230 + 2.0*(z_175 - z_79*z_231) +
        2.0*(z_176 - z_83*z_230) + 2.0*(z_182 - z_58*z_232) - 2.0*(z_179 - z_109*z_229) - 2.0*(z_180 + z_81*z_230)
        - 2.0*(z_181 + z_84*z_231) - 2.0*z_104*z_231 - 2.0*(z_183 + z_63*z_233));
    const double z_234 = 2.0*z_30*H_xz - z_25*z_121;
    const double z_235 = 2.0*z_25*H_xz - z_30*z_118;
    const double z_236 = cos_theta*B_xz;
    const double z_237 = cos_theta*z_41 + sin_theta*z_46;
    const double z_238 = sin_theta*B_xz;
    const double z_239 = 2.0*H_xz*z_215 + z_121*z_216;
    const double z_240 = 2.0*H_xz*z_216 + z_118*z_215;
    const double z_241 = sin_theta*z_41 - cos_theta*z_46;
    const double z_242 = r_R - z_214;
    const double z_243 = z_242 + z_217;
    const double z_244 = z_242 + z_219;
    const double z_245 = z_71*z_243 + z_72*z_244;
    const double z_246 = z_68*z_243 + z_69*z_244;
    const double z_247 = m_F*z_243 + m_H*z_244;
    const double z_248 = r_R - z_213;
    const double z_249 = cos_theta*z_59;
    const double z_250 = sin_theta*z_64;
    dM[283] = (-0.5)*(2.0*r_R*z_150 + (cos_theta*(z_19*z_234 + 2.0*z_236 - z_23*z_235 - 2.0*z_237*z_137 -
        sin_theta*z_138) - sin_theta*(2.0*z_238 + cos_theta*z_138 + z_19*z_239 + z_23*z_240 - 2.0*z_241*z_137)) +
        2.0*(z_157*z_90 + z_20*z_245) + 2.0*(z_155*z_91 - z_28*z_246) + 2.0*(z_24*z_155 + z_29*z_246) +
        2.0*(z_29*z_157 - z_24*z_245) - (sin_theta*(z_27*z_235 + 2.0*z_238 - z_23*z_234 - 2.0*z_237*z_132 -
        cos_theta*z_133) - cos_theta*(2.0*z_236 + sin_theta*z_133 + z_27*z_240 + z_23*z_239 + 2.0*z_241*z_132)) -
        2.0*(z_149*z_171 + z_33*z_247) - 2.0*(z_149*z_173 - z_32*z_247) - 2.0*(z_3*z_177 - z_248*z_249) -
        2.0*(z_3*z_178 + z_248*z_250));
    dM[288] = dM[260] = z_24*z_80 + z_28*z_82 + sin_theta*z_66 - z_29*z_82 - z_20*z_80 - cos_theta*z_62 - z_143;
    dM[289] = dM[268] = -(z_29*z_89 + z_20*z_88 + cos_theta*z_85 - z_24*z_88 - z_28*z_89 - sin_theta*z_86 -
        z_145);
    const double z_251 = z_50*z_71 + z_55*z_72;
    const double z_252 = z_71*z_211 + z_72*z_212;
    const double z_253 = z_50*z_68 + z_55*z_69;
    const double z_254 = z_68*z_211 + z_69*z_212;
    const double z_255 = z_115 + z_116;
    const double z_256 = m_F*z_211 + m_H*z_212;
    dM[290] = dM[276] = (-0.5)*(2.0*(z_20*z_251 + z_90*z_252) + 2.0*(z_29*z_253 + z_24*z_254) + 2.0*(z_32*z_255 -
        z_173*z_256) + 2.0*(z_154 - z_208*z_229) + 2.0*(z_10*z_249 - z_205*z_177) + 2.0*(z_152 + z_209*z_229) +
        2.0*(z_164 + z_9*z_232) + 2.0*(z_166 - z_8*z_233) - 2.0*(z_28*z_253 - z_91*z_254) - 2.0*(z_24*z_251 -
        z_29*z_252) - 2.0*(z_33*z_255 + z_171*z_256) - 2.0*(z_158 + z_92*z_231) - 2.0*(z_160 + z_45*z_230) -
        2.0*(z_10*z_250 + z_205*z_178) - 2.0*(z_159 - z_93*z_230) - 2.0*(z_161 - z_38*z_231) - 2.0*z_226);
    const double z_257 = sin_tilt*r_F - c_*cos_tilt;
    const double z_258 = sin_tilt*z_H - cos_tilt*z_52;
    const double z_259 = m_F*z_257 + m_H*z_258;
    const double z_260 = sin_delta*z_259;
    const double z_261 = z_68*z_257 + z_69*z_258;
    const double z_262 = sin_delta*z_261;
    const double z_263 = z_71*z_257 + z_72*z_258;
    const double z_264 = sin_delta*z_263;
    dM[291] = dM[284] = 0.5*(2.0*z_241*z_125 + z_239*z_46 + 2.0*z_171*z_260 + 2.0*z_173*z_260 - z_240*z_41 -
        2.0*z_91*z_262 - 2.0*z_29*z_264 - 2.0*z_90*z_264 - 2.0*z_24*z_262);
    dM[296] = dM[261] = -(cos_theta*z_101 + sin_theta*z_100 + z_9*z_95 - z_8*z_97);
    dM[297] = dM[269] = -(sin_theta*z_95 + cos_theta*z_97 + z_8*z_101 - z_9*z_100);
    const double z_265 = sin_theta*z_184;
    const double z_266 = z_253*z_265;
    const double z_267 = cos_phi*z_186;
    const double z_268 = cos_theta*z_189;
    const double z_269 = z_251*z_268;
    const double z_270 = cos_phi*z_191;
    const double z_271 = z_155*z_9;
    const double z_272 = z_184*z_271;
    const double z_273 = z_8*z_184;
    const double z_274 = z_157*z_8;
    const double z_275 = z_189*z_274;
    const double z_276 = z_9*z_189;
    const double z_277 = z_253*z_200;
    const double z_278 = z_251*z_199;
    const double z_279 = z_8*z_198;
    const double z_280 = z_155*z_279;
    const double z_281 = z_9*z_198;
    const double z_282 = z_157*z_281;
    dM[298] = dM[277] = 0.5*(sin_tilt*z_224 + 2.0*z_267*z_231 + 2.0*(z_272 + z_273*z_230) + 2.0*(z_277 -
        z_199*z_254) + 2.0*(z_278 + z_200*z_252) + 2.0*(z_280 - z_281*z_230) - cos_tilt*z_225 - 2.0*(z_266 +
        z_185*z_254) - 2.0*(z_269 - z_190*z_252) - 2.0*z_270*z_230 - 2.0*(z_275 - z_276*z_231) - 2.0*(z_282 +
        z_279*z_231));
    const double z_283 = z_263*z_17;
    const double z_284 = z_283 - z_21*z_261;
    const double z_285 = sin_delta*sin_delta;
    const double z_286 = sin_theta*z_285;
    const double z_287 = z_261*z_14;
    const double z_288 = z_287 - z_21*z_263;
    const double z_289 = cos_theta*z_285;
    dM[299] = dM[285] = (-0.5)*(2.0*z_155*z_191 + 2.0*z_288*z_289 - 2.0*z_157*z_186 - sin_tilt*z_240 -
        cos_tilt*z_239 - 2.0*z_284*z_286);
    dM[314] = dM[279] = F_yy*z_221;
    dM[315] = dM[287] = F_yy*z_241;
    const double z_290 = z_281 + z_270 - z_273;
    const double z_291 = z_279 - z_276 - z_267;
    const double z_292 = c_*z_290 + r_F*z_291;
    const double z_293 = z_H*z_291 + z_52*z_290;
    const double z_294 = z_200 + z_190;
    const double z_295 = z_199 + z_185;
    const double z_296 = r_F*z_294 - c_*z_295;
    const double z_297 = z_H*z_294 - z_52*z_295;
    dM[336] = dM[322] = z_292*z_36 + z_293*z_54 + z_296*z_51 + z_297*z_56;
    dM[337] = dM[330] = -(z_296*z_36 + z_297*z_54 - z_292*z_51 - z_293*z_56);
    const double z_298 = z_124*z_123;
    const double z_299 = sin_phi*sin_delta + z_63*z_186 - z_58*z_191;
    const double z_300 = z_196 - z_203 - z_187;
    const double z_301 = z_192 + z_194 - z_201;
    const double z_302 = 2.0*H_xz*z_300 + z_118*z_301;
    const double z_303 = 2.0*H_xz*z_301 + z_121*z_300;
    const double z_304 = (sin_delta*z_298 + z_299*z_125) + 0.5*((z_119*z_191 - z_302*z_41) + (z_122*z_186 +
        z_303*z_46));
    const double z_305 = (z_119*z_184 + z_27*z_302) + (z_122*z_198 + z_23*z_303) - 2.0*(z_191*z_298 -
        z_299*z_132);
    const double z_306 = (z_119*z_198 - z_23*z_302) + (z_122*z_189 - z_19*z_303) - 2.0*(z_186*z_298 -
        z_299*z_137);
    dM[338] = (-0.5)*(4.0*z_147*z_296 + 4.0*z_148*z_297 + sin_phi*(2.0*z_304) + z_305*z_58 - 4.0*z_115*z_292 -
        4.0*z_116*z_293 - z_306*z_63);
    dM[344] = dM[323] = -(z_75*z_102 + z_63*z_97 + z_58*z_95);
    dM[345] = dM[331] = z_75*z_98 + z_58*z_100 + z_63*z_101;
    const double z_307 = m_F*z_296 + m_H*z_297;
    const double z_308 = z_68*z_296 + z_69*z_297;
    const double z_309 = z_71*z_296 + z_72*z_297;
    dM[346] = dM[339] = 0.5*(sin_theta*z_306 + cos_theta*z_305 + 2.0*z_77*z_307 + 2.0*(z_193 - z_106*z_308) +
        2.0*(z_197 + z_79*z_309) + 2.0*(z_195 + z_81*z_308) - 2.0*z_109*z_307 - 2.0*z_108*z_307 - 2.0*(z_202 -
        z_83*z_308) - 2.0*(z_204 - z_84*z_309) - 2.0*(z_188 - z_104*z_309));
    const double z_310 = z_200 - z_265;
    const double z_311 = z_199 - z_268;
    const double z_312 = c_*z_310 + r_F*z_311;
    const double z_313 = z_H*z_311 + z_52*z_310;
    const double z_314 = m_F*z_312 + m_H*z_313;
    const double z_315 = cos_delta*sin_delta;
    const double z_316 = 2.0*H_xz*z_295 - z_121*z_294;
    const double z_317 = 2.0*H_xz*z_294 - z_118*z_295;
    const double z_318 = z_124*z_237;
    const double z_319 = cos_theta*z_191 + sin_theta*z_186;
    const double z_320 = z_71*z_312 + z_72*z_313;
    const double z_321 = z_68*z_312 + z_69*z_313;
    dM[347] = 0.5*(2.0*r_R*z_314 + sin_theta*((z_234*z_189 + z_19*z_316) + (z_235*z_198 - z_23*z_317) +
        2.0*(z_186*z_318 + z_319*z_137)) + cos_theta*((z_235*z_184 + z_27*z_317) + (z_234*z_198 - z_23*z_316) +
        2.0*(z_191*z_318 + z_319*z_132)) + 2.0*(z_246*z_200 + z_24*z_321) + 2.0*(z_245*z_199 + z_29*z_320) -
        4.0*(cos_tilt*z_261 - sin_tilt*z_263)*z_315 - 2.0*(z_245*z_268 - z_90*z_320) - 2.0*(z_246*z_265 -
        z_91*z_321) - 2.0*z_171*z_314 - 2.0*z_173*z_314);
    dM[352] = dM[324] = -(cos_theta*z_101 + sin_theta*z_100 + z_9*z_95 - z_8*z_97);
    dM[353] = dM[332] = -(sin_theta*z_95 + cos_theta*z_97 + z_8*z_101 - z_9*z_100);
    const double z_322 = z_71*z_292 + z_72*z_293;
    const double z_323 = z_68*z_292 + z_69*z_293;
    const double z_324 = m_F*z_292 + m_H*z_293;
    dM[354] = dM[340] = (-0.5)*(2.0*(z_269 - z_90*z_322) + 2.0*(z_266 - z_91*z_323) + 2.0*z_171*z_324 +
        2.0*z_173*z_324 + 2.0*z_208*z_307 + 2.0*(z_275 + z_92*z_309) + 2.0*(z_282 - z_38*z_309) + 2.0*z_304 -
        2.0*(z_277 + z_24*z_323) - 2.0*(z_278 + z_29*z_322) - 2.0*(z_280 - z_45*z_308) - 2.0*z_209*z_307 -
        2.0*(z_272 + z_93*z_308));
    const double z_325 = sin_theta*cos_delta;
    const double z_326 = cos_theta*cos_delta;
    const double z_327 = z_21*z_285;
    dM[355] = dM[348] = 0.5*(2.0*(sin_delta*z_318 - z_319*z_125) + 2.0*r_R*z_259*z_325 +
        2.0*(cos_theta*z_263*z_327 + cos_delta*z_24*z_263) - (z_235*z_191 - z_317*z_41) - (z_234*z_186 -
        z_316*z_46) - 2.0*(z_287*z_289 - z_27*z_261*z_326) - 2.0*z_31*z_259*z_326 - 2.0*(z_19*z_263*z_325 -
        z_283*z_286) - 2.0*(sin_theta*z_261*z_327 + cos_delta*z_29*z_261));
    const double z_328 = r_R - c_*z_23 - r_F*z_19;
    const double z_329 = r_R - z_19*z_H - z_23*z_52;
    const double z_330 = z_71*z_328 + z_72*z_329;
    const double z_331 = r_F*z_17 - c_*z_21;
    const double z_332 = z_H*z_17 - z_21*z_52;
    const double z_333 = z_71*z_331 + z_72*z_332;
    const double z_334 = z_31 - c_*z_27 - z_23*r_F;
    const double z_335 = z_31 - z_23*z_H - z_27*z_52;
    const double z_336 = z_68*z_334 + z_69*z_335;
    const double z_337 = c_*z_14 - z_21*r_F;
    const double z_338 = z_21*z_H - z_52*z_14;
    const double z_339 = z_68*z_337 - z_69*z_338;
    const double z_340 = z_68*z_328 + z_69*z_329;
    const double z_341 = z_68*z_331 + z_69*z_332;
    const double z_342 = z_23*sin_delta;
    const double z_343 = z_71*z_334 + z_72*z_335;
    const double z_344 = z_71*z_337 - z_72*z_338;
    const double z_345 = cos_tilt*H_xx + cos_tilt*z_117 - 2.0*sin_tilt*H_xz;
    const double z_346 = sin_tilt*H_zz + sin_tilt*z_120 - 2.0*cos_tilt*H_xz;
    dM[356] = (z_330*z_189 - sin_delta*z_19*z_333) + (z_336*z_184 - z_27*sin_delta*z_339) +
        sin_delta*(r_R*(m_F*z_331 + m_H*z_332) + z_31*(m_F*z_337 - m_H*z_338)) - (z_340*z_198 + z_341*z_342) -
        (z_343*z_198 + z_344*z_342) - (2.0*z_124 - (cos_tilt*z_345 + sin_tilt*z_346))*z_315;
    const double z_347 = z_94*z_326;
    const double z_348 = z_96*z_325;
    const double z_349 = z_96*z_9;
    const double z_350 = z_94*z_8;
    dM[360] = dM[325] = -(z_142 + cos_psi*z_348 + z_102*z_349 + z_102*z_350 - cos_psi*z_347);
    dM[361] = dM[333] = z_144 + sin_psi*z_347 + z_98*z_350 + z_98*z_349 - sin_psi*z_348;
    dM[362] = dM[341] = (-0.5)*(sin_tilt*z_302 + cos_tilt*z_303 + 2.0*(z_162 + z_267*z_309) +
        2.0*(z_251*z_17*z_325 + z_190*z_322) + 2.0*(z_21*z_251*z_326 + z_200*z_322) + 2.0*(z_22*z_271 -
        z_281*z_308) + 2.0*(z_22*z_274 - z_279*z_309) - 2.0*(z_253*z_14*z_326 + z_185*z_323) - 2.0*(z_156 +
        z_270*z_308) - 2.0*(z_26*z_155*z_8 - z_273*z_308) - 2.0*(z_18*z_157*z_9 - z_276*z_309) -
        2.0*(z_21*z_253*z_325 + z_199*z_323));
    dM[363] = dM[349] = (-0.5)*(sin_tilt*z_317 + 4.0*sin_delta*z_284*z_326 + 2.0*(z_246*z_41 - z_321*z_191) +
        4.0*sin_delta*z_288*z_325 - cos_tilt*z_316 - 2.0*(z_245*z_46 - z_320*z_186));
    dM[364] = dM[357] = (-0.5)*(cos_delta*(sin_tilt*z_345 - cos_tilt*z_346) + 2.0*(z_26*z_340 + z_341*z_14*z_285)
        + 2.0*(z_22*z_336 + z_339*z_327) - 2.0*(z_18*z_343 + z_344*z_17*z_285) - 2.0*(z_22*z_330 + z_333*z_327));
    dM[378] = dM[343] = -F_yy*z_299;
    dM[379] = dM[351] = -F_yy*z_319;
    dM[380] = dM[359] = -sin_delta*F_yy;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double m_R = c[6];
    const double r_R = c[4];
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double phi_dot = v[3];
    const double z_2 = phi_dot*phi_dot;
    const double z_3 = sin_phi*z_2;
    const double z_4 = r_R*z_3;
    const double x_dot = v[0];
    const double psi_dot = v[2];
    const double z_5 = psi_dot*cos_psi;
    const double y_dot = v[1];
    const double sin_psi = em_sin(psi);
    const double z_7 = psi_dot*sin_psi;
    const double z_8 = z_4 - (x_dot*z_5 + y_dot*z_7);
    const double m_B = c[7];
    const double x_B = c[10];
    const double theta_dot = v[4];
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double z_10 = theta_dot*sin_theta;
    const double z_B = c[11];
    const double z_11 = r_R - z_B;
    const double cos_theta = em_cos(theta);
    const double z_13 = theta_dot*cos_theta;
    const double z_14 = x_B*z_10 + z_11*z_13;
    const double cos_phi = em_cos(phi);
    const double z_16 = cos_theta*cos_phi;
    const double z_17 = phi_dot*theta_dot;
    const double z_18 = z_16*z_17;
    const double z_19 = x_B*z_18;
    const double z_20 = sin_phi*sin_theta;
    const double z_21 = z_2*z_20;
    const double z_22 = sin_theta*cos_phi;
    const double z_23 = z_22*z_17;
    const double z_24 = z_11*z_23;
    const double z_25 = sin_phi*cos_theta;
    const double z_26 = z_2*z_25;
    const double z_27 = theta_dot*theta_dot;
    const double z_28 = z_27*z_20;
    const double z_29 = z_27*z_25;
    const double z_30 = psi_dot*z_14 + (z_24 + z_11*z_26) + (z_24 + z_11*z_29) - (z_19 - x_B*z_21) - (z_19 -
        x_B*z_28) - z_8;
    const double z_31 = m_B*z_30;
    const double m_H = c[8];
    const double z_H = c[13];
    const double tilt = c[2];
    const double cos_tilt = em_cos(tilt);
    const double z_33 = cos_tilt*cos_tilt;
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double sin_tilt = em_sin(tilt);
    const double z_36 = sin_tilt*sin_tilt;
    const double z_37 = z_33 + cos_delta*z_36;
    const double delta_dot = v[5];
    const double sin_delta = em_sin(delta);
    const double z_39 = delta_dot*sin_delta;
    const double z_40 = z_39*z_36;
    const double z_41 = sin_theta*z_40;
    const double z_42 = sin_tilt*cos_tilt;
    const double z_43 = sin_tilt*cos_delta;
    const double z_44 = z_42 - cos_tilt*z_43;
    const double z_45 = z_44*z_10;
    const double z_46 = delta_dot*cos_tilt;
    const double z_47 = sin_tilt*sin_delta;
    const double z_48 = z_46*z_47;
    const double z_49 = cos_theta*z_48;
    const double z_50 = (z_37*z_13 - z_41) + (z_45 - z_49);
    const double z_51 = z_50;
    const double c_ = c[1];
    const double w = c[0];
    const double z_52 = c_ + w;
    const double x_H = c[12];
    const double z_53 = z_52 - x_H;
    const double z_54 = z_36 + cos_delta*z_33;
    const double z_55 = z_39*z_33;
    const double z_56 = cos_theta*z_55;
    const double z_57 = z_44*z_13;
    const double z_58 = sin_theta*z_48;
    const double z_59 = (z_54*z_10 + z_56) + (z_57 + z_58);
    const double z_60 = z_59;
    const double z_61 = r_R*z_13 + z_52*z_10;
    const double z_62 = z_61 - z_H*z_51 - z_53*z_60;
    const double z_63 = cos_phi*z_47;
    const double z_64 = delta_dot*delta_dot;
    const double z_65 = delta_dot*z_43;
    const double z_66 = phi_dot*sin_phi;
    const double z_67 = z_65*z_66;
    const double z_68 = z_37*z_23;
    const double z_69 = theta_dot*z_20;
    const double z_70 = z_40*z_69;
    const double z_71 = phi_dot*z_16;
    const double z_72 = z_40*z_71;
    const double z_73 = z_44*z_16;
    const double z_74 = z_73*z_17;
    const double z_75 = phi_dot*z_22;
    const double z_76 = z_48*z_75;
    const double z_77 = theta_dot*z_25;
    const double z_78 = z_48*z_77;
    const double z_79 = cos_delta*z_64;
    const double z_80 = z_79*z_36;
    const double z_81 = cos_tilt*z_64;
    const double z_82 = z_43*z_81;
    const double z_83 = (z_63*z_64 + z_67) + (z_74 + z_76 - z_44*z_21) + (z_67 + z_63*z_2) + (z_74 + z_78 -
        z_44*z_28) + (z_70 - z_72 - z_25*z_80) + (z_76 + z_78 + z_20*z_82) - (z_68 + z_37*z_29 - z_70) - (z_68 +
        z_37*z_26 + z_72);
    const double z_84 = cos_tilt*sin_delta;
    const double z_85 = cos_phi*z_84;
    const double z_86 = cos_delta*z_46;
    const double z_87 = z_86*z_66;
    const double z_88 = z_54*z_18;
    const double z_89 = z_55*z_75;
    const double z_90 = z_44*z_22;
    const double z_91 = z_90*z_17;
    const double z_92 = z_48*z_71;
    const double z_93 = z_55*z_77;
    const double z_94 = z_48*z_69;
    const double z_95 = z_79*z_33;
    const double z_96 = (z_85*z_64 + z_87) + (z_91 + z_44*z_26 - z_92) + (z_87 + z_85*z_2) + (z_91 + z_44*z_29 +
        z_94) + (z_89 + z_93 + z_20*z_95) - (z_88 - z_89 - z_54*z_21) - (z_88 - z_54*z_28 - z_93) - (z_92 +
        z_25*z_82 - z_94);
    const double z_97 = z_52*z_18;
    const double z_98 = r_R*z_23;
    const double z_99 = ((z_97 - z_52*z_28) - (z_98 + r_R*z_29)) + (z_8 - ((z_98 + r_R*z_26) - (z_97 -
        z_52*z_21)));
    const double z_100 = psi_dot*z_62 + z_H*z_83 - z_53*z_96 - z_99;
    const double z_101 = m_H*z_100;
    const double m_F = c[9];
    const double r_F = c[5];
    const double z_102 = z_61 - (r_F*z_51 + c_*z_60);
    const double z_103 = psi_dot*z_102 + r_F*z_83 - c_*z_96 - z_99;
    const double z_104 = m_F*z_103;
    const double z_105 = z_101 + z_104;
    const double z_106 = m_R*(-z_8) + z_31 + z_105;
    const double lambda_2 = lambda[2];
    const double lambda_4 = lambda[4];
    const double z_107 = r_R*sin_phi;
    const double z_108 = x_dot*cos_psi;
    const double z_109 = y_dot*sin_psi;
    const double z_110 = z_108 + z_109;
    const double z_111 = psi_dot*z_107 + z_110;
    const double z_112 = z_37*z_25;
    const double z_113 = z_44*z_20;
    const double z_114 = z_112 + z_113 - z_63;
    const double z_115 = z_54*z_20;
    const double z_116 = z_44*z_25;
    const double z_117 = z_115 + z_116 + z_85;
    const double z_118 = z_107 - (r_R*z_25 + z_52*z_20);
    const double z_119 = z_114*z_H + z_117*z_53 + z_118;
    const double z_120 = z_110 - z_61;
    const double z_121 = psi_dot*z_119 + z_H*z_50 + z_53*z_59 + z_120;
    const double z_122 = m_H*z_121;
    const double z_123 = c_*z_117 + r_F*z_114 + z_118;
    const double z_124 = psi_dot*z_123 + c_*z_59 + r_F*z_50 + z_120;
    const double z_125 = m_F*z_124;
    const double z_126 = z_122 + z_125;
    const double z_127 = z_107 - x_B*z_20 - z_11*z_25;
    const double z_128 = psi_dot*z_127 + z_110 - z_14;
    const double z_129 = m_B*z_128;
    const double z_130 = m_R*z_111 + z_126 + z_129;
    const double delta_ddot = a[5];
    const double z_131 = sin_delta*delta_ddot;
    const double z_132 = m_F*c_;
    const double z_133 = m_H*z_53;
    const double z_134 = z_132 + z_133;
    const double z_135 = m_F*r_F;
    const double z_136 = m_H*z_H;
    const double z_137 = z_135 + z_136;
    const double z_138 = z_134*z_33 - z_42*z_137;
    const double z_139 = z_138*z_20;
    const double z_140 = z_137*z_36 - z_42*z_134;
    const double z_141 = z_140*z_25;
    const double z_142 = cos_tilt*z_134 - sin_tilt*z_137;
    const double z_143 = cos_delta*cos_phi;
    const double z_144 = z_142*z_143;
    const double theta_ddot = a[4];
    const double z_145 = z_44*theta_ddot;
    const double z_146 = z_145*z_20;
    const double z_147 = theta_ddot*z_20;
    const double z_148 = z_37*z_147;
    const double z_149 = z_145*z_25;
    const double z_150 = theta_ddot*z_25;
    const double z_151 = z_54*z_150;
    const double z_152 = m_B*x_B;
    const double z_153 = m_F + m_H;
    const double z_154 = z_152 + z_52*z_153;
    const double z_155 = m_B*z_11;
    const double z_156 = z_155 + r_R*z_153;
    const double phi_ddot = a[3];
    const double z_157 = z_137*phi_ddot;
    const double z_158 = z_134*phi_ddot;
    const double z_159 = z_54*z_22;
    const double z_160 = z_37*z_16;
    const double z_161 = sin_phi*sin_delta;
    const double z_162 = z_142*z_161;
    const double z_163 = phi_ddot*z_16;
    const double z_164 = phi_ddot*z_22;
    const double z_165 = m_B + z_153;
    const double z_166 = m_R + z_165;
    const double z_167 = r_R*cos_phi;
    const double z_168 = z_166*z_167;
    const double z_169 = sin_theta*z_37;
    const double z_170 = cos_theta*z_44;
    const double z_171 = z_169 - z_170;
    const double z_172 = cos_theta*z_54;
    const double z_173 = sin_theta*z_44;
    const double z_174 = z_172 - z_173;
    const double z_175 = cos_theta*z_52;
    const double z_176 = r_R*sin_theta;
    const double z_177 = z_175 - z_176;
    const double z_178 = z_H*z_171 + z_177 - z_53*z_174;
    const double z_179 = m_H*z_178;
    const double psi_ddot = a[2];
    const double z_180 = z_179*psi_ddot;
    const double z_181 = r_F*z_171 + z_177 - c_*z_174;
    const double z_182 = m_F*z_181;
    const double z_183 = z_182*psi_ddot;
    const double z_184 = x_B*cos_theta - sin_theta*z_11;
    const double z_185 = m_B*z_184;
    const double z_186 = z_185*psi_ddot;
    const double z_187 = z_106 + delta_ddot*z_144 + z_137*z_149 + z_134*z_151 + z_156*z_147 + z_90*z_157 +
        z_73*z_158 + z_159*z_158 + z_160*z_157 + phi_ddot*z_168 - lambda_2 - lambda_4 - psi_dot*z_130 -
        z_131*z_139 - z_131*z_141 - z_134*z_146 - z_137*z_148 - z_154*z_150 - phi_ddot*z_162 - z_156*z_163 -
        z_154*z_164 - z_180 - z_183 - z_186;
    const double z_188 = phi_dot*cos_phi;
    const double z_189 = psi_dot*z_188;
    const double z_190 = r_R*z_189;
    const double z_191 = x_dot*z_7 - y_dot*z_5;
    const double z_192 = z_191 - z_190;
    const double z_193 = r_R*z_188;
    const double z_194 = (x_B*z_75 + x_B*z_77) + (z_11*z_71 - z_11*z_69);
    const double z_195 = z_193 - z_194;
    const double z_196 = cos_theta*z_27;
    const double z_197 = sin_theta*z_27;
    const double z_198 = x_B*z_196 + z_191 - psi_dot*z_195 - z_11*z_197;
    const double z_199 = m_B*z_198;
    const double z_200 = cos_phi*z_65;
    const double z_201 = z_47*z_66;
    const double z_202 = z_20*z_48;
    const double z_203 = z_44*z_75;
    const double z_204 = z_44*z_77;
    const double z_205 = (z_200 - z_201) + ((z_25*z_40 + (z_37*z_69 - z_37*z_71)) - (z_202 + (z_203 + z_204)));
    const double z_206 = z_205;
    const double z_207 = z_20*z_55 - (z_54*z_75 + z_54*z_77);
    const double z_208 = z_25*z_48;
    const double z_209 = z_44*z_71;
    const double z_210 = z_44*z_69;
    const double z_211 = cos_phi*z_86;
    const double z_212 = z_84*z_66;
    const double z_213 = (z_208 + (z_209 - z_210)) + (z_211 - z_212);
    const double z_214 = (-z_207) + z_213;
    const double z_215 = z_52*z_75;
    const double z_216 = z_52*z_77;
    const double z_217 = z_215 + z_216;
    const double z_218 = r_R*z_71;
    const double z_219 = r_R*z_69;
    const double z_220 = z_218 - z_219;
    const double z_221 = z_217 - (z_193 - z_220);
    const double z_222 = z_53*z_214 - z_H*z_206 - z_221;
    const double z_223 = z_13*z_40;
    const double z_224 = z_170*z_27;
    const double z_225 = z_10*z_48;
    const double z_226 = cos_theta*z_82;
    const double z_227 = (z_169*z_27 + z_223) + (z_223 + sin_theta*z_80) - (z_224 + z_225) - (z_225 - z_226);
    const double z_228 = z_10*z_55;
    const double z_229 = z_173*z_27;
    const double z_230 = z_13*z_48;
    const double z_231 = sin_theta*z_82;
    const double z_232 = (z_172*z_27 - z_228) + (z_230 + z_231) - (z_229 - z_230) - (z_228 - cos_theta*z_95);
    const double z_233 = z_191 - (r_R*z_197 - z_52*z_196);
    const double z_234 = z_H*z_227 + z_233 - psi_dot*z_222 - z_53*z_232;
    const double z_235 = m_H*z_234;
    const double z_236 = z_221 - (c_*z_214 - r_F*z_206);
    const double z_237 = -z_236;
    const double z_238 = r_F*z_227 + z_233 - psi_dot*z_237 - c_*z_232;
    const double z_239 = m_F*z_238;
    const double z_240 = z_235 + z_239;
    const double lambda_1 = lambda[1];
    const double lambda_3 = lambda[3];
    const double z_241 = y_dot*cos_psi;
    const double z_242 = x_dot*sin_psi;
    const double z_243 = z_241 - z_242;
    const double z_244 = z_193 - z_243;
    const double z_245 = z_213 - z_207;
    const double z_246 = z_244 - (z_220 + z_217);
    const double z_247 = psi_dot*z_178 + z_H*z_205 - z_53*z_245 - z_246;
    const double z_248 = m_H*z_247;
    const double z_249 = psi_dot*z_181 + r_F*z_205 - c_*z_245 - z_246;
    const double z_250 = m_F*z_249;
    const double z_251 = z_248 + z_250;
    const double z_252 = psi_dot*z_184 + z_194 - z_244;
    const double z_253 = m_B*z_252;
    const double z_254 = m_R*(-z_244) + z_251 + z_253;
    const double z_255 = sin_theta*sin_delta;
    const double z_256 = delta_ddot*z_255;
    const double z_257 = cos_theta*sin_delta;
    const double z_258 = delta_ddot*z_257;
    const double z_259 = z_173*theta_ddot;
    const double z_260 = z_170*theta_ddot;
    const double z_261 = sin_theta*z_54;
    const double z_262 = z_261*theta_ddot;
    const double z_263 = cos_theta*z_37;
    const double z_264 = z_263*theta_ddot;
    const double z_265 = cos_theta*theta_ddot;
    const double z_266 = sin_theta*theta_ddot;
    const double z_267 = m_R*z_107;
    const double z_268 = m_H*z_119;
    const double z_269 = z_268*psi_ddot;
    const double z_270 = m_F*z_123;
    const double z_271 = z_270*psi_ddot;
    const double z_272 = m_B*z_127;
    const double z_273 = z_272*psi_ddot;
    const double z_274 = (m_R*z_192 + z_199 + z_240) + psi_dot*z_254 + z_140*z_256 + z_156*z_265 + z_154*z_266 -
        lambda_1 - lambda_3 - z_138*z_258 - z_137*z_259 - z_134*z_260 - z_134*z_262 - z_137*z_264 - z_267*psi_ddot
        - z_269 - z_271 - z_273;
    D[2] = cos_psi*z_187 + sin_psi*z_274;
    const double z_275 = sin_psi*z_134;
    const double z_276 = z_173*z_17;
    const double z_277 = z_172*z_17;
    const double z_278 = sin_psi*z_137;
    const double z_279 = z_170*z_17;
    const double z_280 = z_169*z_17;
    const double z_281 = z_134*z_5;
    const double z_282 = phi_dot*z_170;
    const double z_283 = phi_dot*z_261;
    const double z_284 = z_137*z_5;
    const double z_285 = phi_dot*z_173;
    const double z_286 = phi_dot*z_263;
    const double z_287 = cos_delta*delta_ddot;
    const double z_288 = sin_psi*z_142;
    const double z_289 = z_173*phi_ddot;
    const double z_290 = z_170*phi_ddot;
    const double z_291 = z_261*phi_ddot;
    const double z_292 = z_263*phi_ddot;
    const double z_293 = cos_theta*phi_ddot;
    const double z_294 = sin_psi*z_156;
    const double z_295 = sin_theta*phi_ddot;
    const double z_296 = sin_psi*z_154;
    const double z_297 = r_R*phi_ddot;
    const double z_298 = z_166*sin_psi;
    const double z_299 = psi_dot*psi_dot;
    const double z_300 = m_H*sin_psi;
    const double z_301 = m_H*cos_psi;
    const double z_302 = z_299*z_300 - psi_ddot*z_301;
    const double z_303 = m_F*sin_psi;
    const double z_304 = m_F*cos_psi;
    const double z_305 = z_299*z_303 - psi_ddot*z_304;
    const double z_306 = z_H*z_302 + r_F*z_305;
    const double z_307 = z_53*z_302 + c_*z_305;
    const double z_308 = cos_theta*z_17;
    const double z_309 = sin_theta*z_17;
    const double z_310 = sin_delta*z_2;
    const double z_311 = phi_dot*cos_theta;
    const double z_312 = sin_psi*z_140;
    const double z_313 = z_39*z_312;
    const double z_314 = phi_dot*sin_theta;
    const double z_315 = sin_psi*z_138;
    const double z_316 = z_39*z_315;
    const double z_317 = sin_delta*z_64;
    const double z_318 = m_R*r_R;
    const double z_319 = z_318 + r_R*(m_R + 2.0*z_165);
    const double z_320 = phi_dot*z_319;
    const double z_321 = z_153 + z_153;
    const double z_322 = 2.0*z_152 + z_52*z_321;
    const double z_323 = z_5*z_322;
    const double z_324 = 2.0*z_155 + r_R*z_321;
    const double z_325 = z_5*z_324;
    const double z_326 = delta_dot*cos_delta;
    const double z_327 = z_142*z_5;
    const double z_328 = z_261*z_27;
    const double z_329 = z_170*z_2;
    const double z_330 = z_261*z_2;
    const double z_331 = z_173*z_2;
    const double z_332 = z_263*z_2;
    const double z_333 = z_263*z_27;
    const double z_334 = r_R*z_2;
    const double z_335 = sin_psi*z_318;
    const double z_336 = z_54*z_13;
    const double z_337 = z_37*z_10;
    const double z_338 = z_169*theta_ddot;
    const double z_339 = z_172*theta_ddot;
    const double z_340 = sin_delta*phi_ddot;
    const double z_341 = cos_psi*z_318;
    const double z_342 = sin_theta*z_52;
    const double z_343 = z_302 + z_305;
    const double z_344 = r_R*cos_theta;
    const double z_345 = z_11*cos_theta;
    const double z_346 = m_B*sin_psi;
    const double z_347 = m_B*cos_psi;
    const double z_348 = z_299*z_346 - psi_ddot*z_347;
    const double z_349 = x_B*sin_theta;
    const double z_350 = sin_theta*z_2;
    const double z_351 = cos_theta*z_2;
    const double z_352 = cos_theta*z_79;
    const double z_353 = sin_theta*z_79;
    const double z_354 = phi_dot*z_326;
    const double z_355 = z_140*z_5;
    const double z_356 = cos_theta*z_39;
    const double z_357 = z_138*z_5;
    const double z_358 = sin_theta*z_39;
    const double z_359 = phi_dot*sin_delta;
    D[3] = sin_phi*(2.0*z_275*z_276 + 2.0*z_278*z_280 + z_293*z_294 + z_295*z_296 + z_307*z_84 + 2.0*z_308*z_296 +
        z_288*z_310 + 2.0*z_311*z_313 + 2.0*z_314*z_316 + z_317*z_288 + z_314*z_323 + z_311*z_325 -
        2.0*z_275*z_277 - 2.0*z_278*z_279 - 2.0*z_281*z_282 - 2.0*z_281*z_283 - 2.0*z_284*z_285 - 2.0*z_284*z_286
        - z_287*z_288 - z_289*z_278 - z_290*z_275 - z_291*z_275 - z_292*z_278 - z_297*z_298 - z_306*z_47 -
        2.0*z_309*z_294 - z_5*z_320 - 2.0*z_326*z_327) - cos_phi*(z_224*z_275 + z_275*z_328 + z_275*z_329 +
        z_275*z_330 + z_229*z_278 + z_278*z_331 + z_278*z_332 + z_278*z_333 + z_334*z_298 + z_299*z_335 +
        2.0*z_45*z_281 + 2.0*z_284*z_337 + z_315*z_256 + z_312*z_258 + z_259*z_275 + z_278*z_338 + z_265*z_296 +
        z_288*z_340 + z_173*z_306 + z_263*z_306 + z_170*z_307 + z_261*z_307 + r_R*(z_343 + z_348) + z_312*z_352 +
        z_315*z_353 + 2.0*z_13*z_316 + 2.0*z_288*z_354 + z_13*z_323 + 2.0*z_355*z_356 + 2.0*z_357*z_358 +
        2.0*z_327*z_359 - 2.0*z_281*z_336 - 2.0*z_57*z_284 - z_260*z_278 - z_275*z_339 - z_266*z_294 -
        psi_ddot*z_341 - z_342*z_343 - z_344*z_343 - z_345*z_348 - z_349*z_348 - z_196*z_294 - z_197*z_296 -
        z_296*z_350 - z_294*z_351 - 2.0*z_10*z_313 - z_10*z_325);
    const double z_360 = sin_phi*z_44;
    const double z_361 = z_27*z_360;
    const double z_362 = z_2*z_360;
    const double z_363 = z_54*cos_phi;
    const double z_364 = z_17*z_363;
    const double z_365 = z_44*cos_phi;
    const double z_366 = z_17*z_365;
    const double z_367 = z_37*z_278;
    const double z_368 = sin_phi*z_27;
    const double z_369 = cos_psi*z_137;
    const double z_370 = z_44*z_27;
    const double z_371 = cos_psi*z_134;
    const double z_372 = z_54*z_371;
    const double z_373 = theta_dot*sin_phi;
    const double z_374 = z_54*z_373;
    const double z_375 = z_44*z_188;
    const double z_376 = theta_dot*z_360;
    const double z_377 = z_37*z_188;
    const double z_378 = z_137*z_7;
    const double z_379 = theta_dot*z_37;
    const double z_380 = z_134*z_7;
    const double z_381 = theta_dot*z_44;
    const double z_382 = delta_ddot*z_161;
    const double z_383 = cos_psi*z_138;
    const double z_384 = theta_ddot*z_360;
    const double z_385 = sin_phi*z_54;
    const double z_386 = theta_ddot*z_385;
    const double z_387 = sin_phi*theta_ddot;
    const double z_388 = z_37*z_369;
    const double z_389 = cos_psi*z_156;
    const double z_390 = phi_ddot*z_365;
    const double z_391 = cos_phi*z_37;
    const double z_392 = phi_ddot*z_391;
    const double z_393 = cos_phi*phi_ddot;
    const double z_394 = z_299*z_301 + psi_ddot*z_300;
    const double z_395 = z_299*z_304 + psi_ddot*z_303;
    const double z_396 = z_53*z_394 + c_*z_395;
    const double z_397 = z_394 + z_395;
    const double z_398 = z_H*z_394 + r_F*z_395;
    const double z_399 = z_299*z_347 + psi_ddot*z_346;
    const double z_400 = sin_phi*z_37;
    const double z_401 = sin_phi*z_11;
    const double z_402 = cos_phi*z_17;
    const double z_403 = sin_phi*z_79;
    const double z_404 = z_39*z_188;
    const double z_405 = cos_psi*z_154;
    const double z_406 = cos_psi*z_140;
    const double z_407 = z_39*z_406;
    const double z_408 = sin_phi*z_39;
    const double z_409 = theta_dot*z_156;
    const double z_410 = z_138*z_7;
    const double z_411 = z_54*z_275;
    const double z_412 = z_17*z_391;
    const double z_413 = z_54*z_188;
    const double z_414 = z_37*z_373;
    const double z_415 = theta_dot*z_54;
    const double z_416 = theta_ddot*z_400;
    const double z_417 = phi_ddot*z_363;
    const double z_418 = sin_phi*z_52;
    const double z_419 = sin_phi*x_B;
    const double z_420 = z_39*z_383;
    const double z_421 = theta_dot*z_154;
    const double z_422 = z_140*z_7;
    D[4] = sin_theta*(z_275*z_361 + z_275*z_362 + z_3*z_367 + z_368*z_367 + 2.0*z_378*z_379 + 2.0*z_380*z_381 +
        z_312*z_382 + z_296*z_387 + theta_ddot*z_389 + z_393*z_294 + z_52*z_397 + x_B*z_399 + z_306*z_400 +
        z_307*z_360 + 2.0*z_296*z_402 + z_312*z_403 + 2.0*z_373*z_316 + 2.0*z_312*z_404 + z_27*z_405 +
        2.0*theta_dot*z_407 + z_373*z_323 + z_188*z_325 + 2.0*z_408*z_355 + 2.0*z_39*z_410 - 2.0*z_275*z_364 -
        2.0*z_278*z_366 - z_369*z_370 - z_27*z_372 - 2.0*z_281*z_374 - 2.0*z_281*z_375 - 2.0*z_284*z_376 -
        2.0*z_284*z_377 - z_131*z_383 - z_278*z_384 - z_275*z_386 - z_145*z_371 - theta_ddot*z_388 - z_275*z_390 -
        z_278*z_392 - z_54*z_396 - z_44*z_398 - z_107*z_343 - z_348*z_401 - z_368*z_294 - z_3*z_294 - z_79*z_383 -
        2.0*z_7*z_409) - cos_theta*(z_368*z_411 + 2.0*z_275*z_366 + z_3*z_411 + z_278*z_361 + z_278*z_362 +
        2.0*z_278*z_412 + z_27*z_388 + z_371*z_370 + 2.0*z_281*z_376 + 2.0*z_284*z_414 + 2.0*z_378*z_381 +
        2.0*z_380*z_415 + z_315*z_382 + z_131*z_406 + z_275*z_384 + z_278*z_416 + theta_ddot*z_405 + z_393*z_296 +
        z_44*z_396 + z_37*z_398 + z_306*z_360 + z_307*z_385 + z_315*z_403 + 2.0*z_315*z_404 + z_79*z_406 +
        2.0*theta_dot*z_420 + z_188*z_323 + 2.0*z_408*z_357 - 2.0*z_281*z_413 - 2.0*z_284*z_375 - z_145*z_369 -
        z_294*z_387 - theta_ddot*z_372 - z_278*z_390 - z_275*z_417 - r_R*z_397 - z_11*z_399 - z_343*z_418 -
        z_348*z_419 - z_368*z_296 - z_3*z_296 - 2.0*z_294*z_402 - 2.0*z_373*z_313 - z_27*z_389 - z_373*z_325 -
        2.0*z_7*z_421 - 2.0*z_39*z_422);
    const double z_423 = z_20*z_315;
    const double z_424 = z_25*z_312;
    const double z_425 = sin_theta*delta_ddot;
    const double z_426 = cos_theta*delta_ddot;
    const double z_427 = sin_phi*phi_ddot;
    const double z_428 = sin_tilt*cos_phi;
    const double z_429 = cos_tilt*cos_phi;
    const double z_430 = delta_dot*z_69;
    const double z_431 = cos_phi*z_2;
    const double z_432 = delta_dot*z_77;
    const double z_433 = delta_dot*z_71;
    const double z_434 = delta_dot*z_75;
    const double z_435 = cos_phi*z_64;
    const double z_436 = delta_dot*z_10;
    const double z_437 = delta_dot*z_13;
    const double z_438 = delta_dot*z_25;
    const double z_439 = delta_dot*z_20;
    const double z_440 = delta_dot*cos_theta;
    const double z_441 = delta_dot*sin_theta;
    const double z_442 = cos_phi*delta_ddot;
    const double z_443 = delta_dot*z_66;
    const double z_444 = cos_theta*z_64;
    const double z_445 = sin_theta*z_64;
    const double z_446 = delta_dot*cos_phi;
    D[5] = -(cos_delta*(delta_ddot*z_423 + delta_ddot*z_424 + z_406*z_425 + z_427*z_288 + z_307*z_429 +
        z_431*z_288 + 2.0*z_315*z_432 + 2.0*z_312*z_433 + 2.0*z_315*z_434 + z_288*z_435 + 2.0*z_383*z_436 +
        2.0*z_406*z_437 + 2.0*z_355*z_438 + 2.0*z_357*z_439 + 2.0*z_66*z_327 + 2.0*z_410*z_440 - z_383*z_426 -
        z_306*z_428 - 2.0*z_312*z_430 - 2.0*z_422*z_441) + sin_delta*(z_288*z_442 + z_42*(z_275*z_29 + z_275*z_26
        + 2.0*z_275*z_23 + z_278*z_28 + z_278*z_21 + z_197*z_371 + 2.0*z_69*z_281 + 2.0*z_10*z_378 +
        2.0*z_13*z_380 + z_275*z_147 + sin_theta*z_396 + z_306*z_20 + z_307*z_25 - 2.0*z_278*z_18 - z_196*z_369 -
        2.0*z_71*z_281 - 2.0*z_77*z_284 - 2.0*z_75*z_284 - z_278*z_150 - z_266*z_369 - z_265*z_371 - z_278*z_164 -
        z_275*z_163 - cos_theta*z_398) + z_383*z_444 + 2.0*z_327*z_446 - (z_278*z_26 + z_278*z_29 + 2.0*z_278*z_23
        + z_197*z_369 + 2.0*z_69*z_284 + 2.0*z_13*z_378 + z_278*z_147 + sin_theta*z_398 + z_306*z_25 -
        2.0*z_71*z_284 - z_265*z_369 - z_278*z_163)*z_36 - (z_275*z_28 + z_275*z_21 + 2.0*z_10*z_380 + z_307*z_20
        - 2.0*z_275*z_18 - z_196*z_371 - 2.0*z_77*z_281 - 2.0*z_75*z_281 - z_275*z_150 - z_266*z_371 - z_275*z_164
        - cos_theta*z_396)*z_33 - z_64*z_424 - z_64*z_423 - 2.0*z_288*z_443 - z_406*z_445));
    const double z_447 = cos_psi*z_254 + sin_psi*z_130;
    D[10] = y_dot*z_166 + z_195*z_347 + z_237*z_304 + z_222*z_301 + z_14*z_346 + z_102*z_303 + z_62*z_300 +
        z_188*z_341 - z_7*z_272 - z_270*z_7 - z_268*z_7 - z_185*z_5 - z_182*z_5 - z_179*z_5 - z_7*z_267 - z_447;
    const double z_448 = r_R*z_66;
    const double z_449 = theta_dot*z_16;
    const double z_450 = phi_dot*z_20;
    const double z_451 = theta_dot*z_22;
    const double z_452 = phi_dot*z_25;
    const double z_453 = sin_delta*z_188;
    const double z_454 = sin_phi*z_326;
    const double z_455 = z_44*z_451;
    const double z_456 = z_44*z_452;
    const double z_457 = z_44*z_449;
    const double z_458 = z_44*z_450;
    const double z_459 = cos_phi*z_319;
    D[11] = -(2.0*z_448*z_298 + 2.0*z_449*z_296 + 2.0*z_288*z_453 + 2.0*z_288*z_454 + 2.0*z_161*z_327 +
        2.0*z_451*z_367 + 2.0*z_452*z_367 + 2.0*z_450*z_411 + 2.0*z_455*z_275 + 2.0*z_456*z_275 + 2.0*z_458*z_278
        + 2.0*z_16*z_313 + 2.0*z_22*z_316 + z_22*z_323 + z_16*z_325 - 2.0*z_450*z_296 - 2.0*z_451*z_294 -
        2.0*z_452*z_294 - 2.0*z_160*z_284 - 2.0*z_449*z_411 - 2.0*z_159*z_281 - 2.0*z_73*z_281 - 2.0*z_457*z_278 -
        2.0*z_90*z_284 - z_5*z_459);
    const double z_460 = sin_theta*z_154;
    const double z_461 = cos_theta*z_156;
    const double z_462 = z_54*z_25;
    const double z_463 = z_37*z_20;
    D[12] = -(2.0*z_13*z_405 + 2.0*z_369*z_337 + 2.0*z_263*z_378 + 2.0*z_261*z_380 + 2.0*z_45*z_371 +
        2.0*z_170*z_380 + 2.0*z_173*z_378 + 2.0*z_71*z_296 + 2.0*z_69*z_411 + 2.0*z_210*z_278 + 2.0*z_75*z_367 +
        2.0*z_77*z_367 + 2.0*z_463*z_284 + 2.0*z_203*z_275 + 2.0*z_204*z_275 + 2.0*z_113*z_281 +
        2.0*cos_theta*z_407 + 2.0*sin_theta*z_420 + 2.0*z_25*z_316 + z_25*z_323 - 2.0*z_7*z_460 - 2.0*z_10*z_389 -
        2.0*z_7*z_461 - 2.0*z_371*z_336 - 2.0*z_75*z_294 - 2.0*z_77*z_294 - 2.0*z_57*z_369 - 2.0*z_69*z_296 -
        2.0*z_71*z_411 - 2.0*z_462*z_281 - 2.0*z_209*z_278 - 2.0*z_116*z_284 - 2.0*z_20*z_313 - z_20*z_325);
    const double z_464 = sin_delta*z_383;
    const double z_465 = cos_theta*z_326;
    const double z_466 = cos_phi*z_39;
    const double z_467 = cos_delta*z_66;
    const double z_468 = sin_delta*z_406;
    const double z_469 = sin_theta*z_326;
    const double z_470 = sin_delta*z_312;
    const double z_471 = sin_delta*z_25;
    const double z_472 = sin_delta*z_315;
    const double z_473 = sin_delta*z_20;
    D[13] = (-2.0)*(z_10*z_464 + z_257*z_410 + z_466*z_288 + z_467*z_288 + z_13*z_468 + z_406*z_469 + z_71*z_470 +
        z_326*z_424 + z_355*z_471 + z_75*z_472 + z_77*z_472 + z_326*z_423 + z_357*z_473 - z_383*z_465 -
        z_143*z_327 - z_255*z_422 - z_69*z_470);
    D[18] = -(cos_psi*z_274 - sin_psi*z_187);
    const double z_474 = cos_psi*z_142;
    const double z_475 = z_166*cos_psi;
    const double z_476 = z_7*z_322;
    const double z_477 = z_7*z_324;
    const double z_478 = z_142*z_7;
    D[19] = -(sin_phi*(2.0*z_371*z_276 + 2.0*z_369*z_280 + 2.0*z_380*z_282 + 2.0*z_380*z_283 + 2.0*z_378*z_285 +
        2.0*z_378*z_286 + z_293*z_389 + z_295*z_405 + z_396*z_84 + 2.0*z_308*z_405 + z_474*z_310 + 2.0*z_311*z_407
        + 2.0*z_314*z_420 + z_317*z_474 + z_7*z_320 + 2.0*z_326*z_478 - 2.0*z_371*z_277 - 2.0*z_369*z_279 -
        z_287*z_474 - z_289*z_369 - z_290*z_371 - z_291*z_371 - z_292*z_369 - z_297*z_475 - z_398*z_47 -
        2.0*z_309*z_389 - z_314*z_476 - z_311*z_477) - cos_phi*(z_224*z_371 + z_371*z_328 + z_371*z_329 +
        z_371*z_330 + z_229*z_369 + z_369*z_331 + z_369*z_332 + z_369*z_333 + z_334*z_475 + z_299*z_341 +
        2.0*z_380*z_336 + 2.0*z_57*z_378 + z_406*z_258 + z_383*z_256 + z_259*z_371 + z_369*z_338 + z_265*z_405 +
        z_474*z_340 + psi_ddot*z_335 + z_173*z_398 + z_263*z_398 + z_170*z_396 + z_261*z_396 + r_R*(z_397 + z_399)
        + z_406*z_352 + z_383*z_353 + 2.0*z_13*z_420 + 2.0*z_474*z_354 + z_10*z_477 - 2.0*z_45*z_380 -
        2.0*z_378*z_337 - z_260*z_369 - z_371*z_339 - z_266*z_389 - z_342*z_397 - z_344*z_397 - z_345*z_399 -
        z_349*z_399 - z_196*z_389 - z_197*z_405 - z_405*z_350 - z_389*z_351 - 2.0*z_10*z_407 - z_13*z_476 -
        2.0*z_422*z_356 - 2.0*z_410*z_358 - 2.0*z_478*z_359));
    D[20] = -(sin_theta*(z_371*z_361 + z_371*z_362 + z_3*z_388 + z_368*z_388 + z_278*z_370 + z_27*z_411 +
        2.0*z_380*z_374 + 2.0*z_380*z_375 + 2.0*z_378*z_376 + 2.0*z_378*z_377 + 2.0*z_284*z_379 + 2.0*z_281*z_381
        + z_406*z_382 + z_131*z_315 + z_405*z_387 + z_145*z_275 + theta_ddot*z_367 + z_393*z_389 + z_54*z_307 +
        z_44*z_306 + z_398*z_400 + z_396*z_360 + 2.0*z_405*z_402 + z_406*z_403 + 2.0*z_373*z_420 + 2.0*z_406*z_404
        + z_79*z_315 + 2.0*z_39*z_357 - 2.0*z_371*z_364 - 2.0*z_369*z_366 - z_369*z_384 - z_371*z_386 -
        theta_ddot*z_294 - z_371*z_390 - z_369*z_392 - z_52*z_343 - x_B*z_348 - z_107*z_397 - z_399*z_401 -
        z_368*z_389 - z_3*z_389 - z_27*z_296 - 2.0*theta_dot*z_313 - z_373*z_476 - z_188*z_477 - 2.0*z_408*z_422 -
        2.0*z_5*z_409) - cos_theta*(z_368*z_372 + 2.0*z_371*z_366 + z_3*z_372 + z_369*z_361 + z_369*z_362 +
        2.0*z_369*z_412 + 2.0*z_380*z_413 + 2.0*z_378*z_375 + 2.0*z_284*z_381 + 2.0*z_281*z_415 + z_383*z_382 +
        z_371*z_384 + z_369*z_416 + z_145*z_278 + theta_ddot*z_411 + z_393*z_405 + r_R*z_343 + z_11*z_348 +
        z_398*z_360 + z_396*z_385 + z_383*z_403 + 2.0*z_383*z_404 + z_27*z_294 + z_373*z_477 - z_27*z_367 -
        z_275*z_370 - 2.0*z_380*z_376 - 2.0*z_378*z_414 - z_131*z_312 - z_389*z_387 - theta_ddot*z_296 -
        z_369*z_390 - z_371*z_417 - z_44*z_307 - z_37*z_306 - z_397*z_418 - z_399*z_419 - z_368*z_405 - z_3*z_405
        - 2.0*z_389*z_402 - 2.0*z_373*z_407 - z_79*z_312 - 2.0*theta_dot*z_316 - z_188*z_476 - 2.0*z_408*z_410 -
        2.0*z_5*z_421 - 2.0*z_39*z_355));
    const double z_479 = z_25*z_406;
    const double z_480 = z_20*z_383;
    D[21] = cos_delta*(delta_ddot*z_479 + delta_ddot*z_480 + z_315*z_426 + z_427*z_474 + z_396*z_429 + z_431*z_474
        + 2.0*z_383*z_432 + 2.0*z_406*z_433 + 2.0*z_383*z_434 + z_474*z_435 + 2.0*z_357*z_440 - z_312*z_425 -
        z_398*z_428 - 2.0*z_406*z_430 - 2.0*z_315*z_436 - 2.0*z_312*z_437 - 2.0*z_422*z_438 - 2.0*z_410*z_439 -
        2.0*z_66*z_478 - 2.0*z_355*z_441) + sin_delta*(z_474*z_442 + z_42*(z_371*z_29 + z_371*z_26 +
        2.0*z_371*z_23 + z_369*z_28 + z_369*z_21 + z_196*z_278 + 2.0*z_71*z_380 + 2.0*z_77*z_378 + 2.0*z_75*z_378
        + 2.0*z_10*z_284 + 2.0*z_13*z_281 + z_371*z_147 + z_266*z_278 + z_265*z_275 + cos_theta*z_306 + z_398*z_20
        + z_396*z_25 - 2.0*z_369*z_18 - z_197*z_275 - 2.0*z_69*z_380 - z_369*z_150 - z_369*z_164 - z_371*z_163 -
        sin_theta*z_307) + z_312*z_445 - (z_369*z_26 + z_369*z_29 + 2.0*z_369*z_23 + 2.0*z_71*z_378 +
        2.0*z_13*z_284 + z_369*z_147 + z_265*z_278 + z_398*z_25 - z_197*z_278 - 2.0*z_69*z_378 - z_369*z_163 -
        sin_theta*z_306)*z_36 - (z_371*z_28 + z_371*z_21 + z_196*z_275 + 2.0*z_77*z_380 + 2.0*z_75*z_380 +
        2.0*z_10*z_281 + z_266*z_275 + cos_theta*z_307 + z_396*z_20 - 2.0*z_371*z_18 - z_371*z_150 -
        z_371*z_164)*z_33 - z_64*z_479 - z_64*z_480 - 2.0*z_474*z_443 - z_315*z_444 - 2.0*z_478*z_446);
    const double z_481 = sin_psi*z_254 - cos_psi*z_130;
    D[26] = -(x_dot*z_166 + z_185*z_7 + z_14*z_347 + z_182*z_7 + z_102*z_304 + z_179*z_7 + z_62*z_301 + z_481 -
        z_195*z_346 - z_5*z_272 - z_237*z_303 - z_270*z_5 - z_222*z_300 - z_268*z_5 - z_188*z_335 - z_5*z_267);
    D[27] = 2.0*z_449*z_405 + 2.0*z_474*z_453 + 2.0*z_474*z_454 + 2.0*z_448*z_475 + 2.0*z_451*z_388 +
        2.0*z_160*z_378 + 2.0*z_452*z_388 + 2.0*z_159*z_380 + 2.0*z_450*z_372 + 2.0*z_455*z_371 + 2.0*z_73*z_380 +
        2.0*z_456*z_371 + 2.0*z_90*z_378 + 2.0*z_458*z_369 + 2.0*z_16*z_407 + 2.0*z_22*z_420 + z_7*z_459 -
        2.0*z_450*z_405 - 2.0*z_451*z_389 - 2.0*z_452*z_389 - 2.0*z_161*z_478 - 2.0*z_449*z_372 - 2.0*z_457*z_369
        - z_22*z_476 - z_16*z_477;
    D[28] = -(2.0*z_13*z_296 + 2.0*z_5*z_460 + 2.0*z_5*z_461 + 2.0*z_278*z_337 + 2.0*z_45*z_275 + 2.0*z_69*z_405 +
        2.0*z_75*z_389 + 2.0*z_77*z_389 + 2.0*z_463*z_378 + 2.0*z_113*z_380 + 2.0*z_71*z_372 + 2.0*z_209*z_369 +
        2.0*cos_theta*z_313 + 2.0*sin_theta*z_316 + 2.0*z_20*z_407 + z_25*z_476 - 2.0*z_10*z_294 - 2.0*z_263*z_284
        - 2.0*z_275*z_336 - 2.0*z_261*z_281 - 2.0*z_170*z_281 - 2.0*z_71*z_405 - 2.0*z_57*z_278 - 2.0*z_173*z_284
        - 2.0*z_75*z_388 - 2.0*z_77*z_388 - 2.0*z_203*z_371 - 2.0*z_204*z_371 - 2.0*z_69*z_372 - 2.0*z_462*z_380 -
        2.0*z_210*z_369 - 2.0*z_116*z_378 - 2.0*z_25*z_420 - z_20*z_477);
    D[29] = (-2.0)*(z_10*z_472 + z_13*z_470 + z_312*z_469 + z_255*z_355 + z_410*z_473 + z_69*z_468 + z_422*z_471 -
        z_315*z_465 - z_257*z_357 - z_143*z_478 - z_466*z_474 - z_467*z_474 - z_75*z_464 - z_77*z_464 -
        z_326*z_480 - z_71*z_468 - z_326*z_479);
    const double z_482 = z_182 + z_179;
    const double z_483 = z_185 + z_482;
    const double z_484 = y_dot*psi_dot;
    const double z_485 = x_dot*psi_dot;
    const double z_486 = z_270 + z_268;
    const double z_487 = z_486 + z_272 + z_267;
    const double z_488 = m_B*z_14 - m_B*z_110;
    const double z_489 = m_H*z_62 - m_H*z_110;
    const double z_490 = m_F*z_102 - m_F*z_110;
    const double z_491 = z_489 + z_490;
    const double z_492 = m_R*z_110 - z_491;
    const double z_493 = z_492 - z_488;
    const double z_494 = z_318*z_188 - m_R*z_243;
    const double z_495 = m_B*z_195 - m_B*z_243;
    const double z_496 = m_H*z_222 - m_H*z_243;
    const double z_497 = m_F*z_237 - m_F*z_243;
    const double z_498 = z_496 + z_497;
    const double z_499 = z_494 + z_495 + z_498;
    const double y_ddot = a[1];
    const double x_ddot = a[0];
    D[34] = cos_psi*((y_dot*z_254 + x_dot*z_130) + y_dot*z_499 + z_267*y_ddot + z_268*y_ddot + z_270*y_ddot +
        z_272*y_ddot - z_483*z_484 - z_485*z_487 - x_dot*z_493 - z_179*x_ddot - z_182*x_ddot - z_185*x_ddot) -
        sin_psi*((x_dot*z_254 - y_dot*z_130) + z_484*z_487 + y_dot*z_493 + x_dot*z_499 + z_179*y_ddot +
        z_182*y_ddot + z_185*y_ddot + z_267*x_ddot + z_268*x_ddot + z_270*x_ddot + z_272*x_ddot - z_483*z_485);
    const double R_yy = c[15];
    const double spin_r_dot = v[6];
    const double z_500 = psi_dot*sin_phi;
    const double z_501 = theta_dot + z_500;
    const double H_yy = c[23];
    const double z_502 = cos_delta*z_501;
    const double z_503 = psi_dot*z_22;
    const double z_504 = z_311 - z_503;
    const double z_505 = psi_dot*z_16;
    const double z_506 = z_314 + z_505;
    const double z_507 = z_504*z_84 + z_506*z_47;
    const double F_yy = c[17];
    const double spin_f_dot = v[7];
    const double z_508 = spin_f_dot + z_502;
    const double z_509 = z_508 - z_507;
    const double z_510 = H_yy*(z_502 - z_507) + F_yy*z_509;
    const double H_xz = c[25];
    const double z_511 = z_44*z_504;
    const double z_512 = z_46 + z_501*z_47;
    const double z_513 = z_37*z_506 + z_512 - z_511;
    const double z_514 = H_xz*z_513;
    const double H_xx = c[22];
    const double z_515 = z_44*z_506;
    const double z_516 = delta_dot*sin_tilt;
    const double z_517 = z_516 - z_501*z_84;
    const double z_518 = z_54*z_504 - z_515 - z_517;
    const double F_xx = c[16];
    const double z_519 = H_xx + 2.0*F_xx;
    const double z_520 = z_514 - (H_xx*z_518 - z_514) - z_519*z_518;
    const double z_521 = H_xz*z_518;
    const double H_zz = c[24];
    const double z_522 = 2.0*F_xx + H_zz;
    const double z_523 = z_521 - (H_zz*z_513 - z_521) - z_522*z_513;
    const double B_yy = c[19];
    const double z_524 = 2.0*R_yy*(spin_r_dot + z_501) + (2.0*cos_delta*z_510 + 2.0*B_yy*z_501 - z_520*z_84 -
        z_523*z_47);
    const double B_xz = c[21];
    const double z_525 = psi_dot*z_449 - psi_dot*z_450;
    const double z_526 = z_309 + z_525;
    const double z_527 = B_xz*z_526;
    const double B_zz = c[20];
    const double z_528 = psi_dot*z_451 + psi_dot*z_452;
    const double z_529 = z_308 - z_528;
    const double z_530 = z_501*z_39;
    const double z_531 = z_504*z_86;
    const double z_532 = z_506*z_65;
    const double z_533 = (z_530 - cos_delta*z_189) + (z_531 - z_526*z_84) + (z_532 + z_529*z_47);
    const double z_534 = F_yy + H_yy;
    const double z_535 = z_534*z_47;
    const double z_536 = z_506*z_40;
    const double z_537 = z_504*z_48;
    const double z_538 = z_501*z_65;
    const double z_539 = (z_536 - z_37*z_529) + (z_537 - z_44*z_526) - (z_538 + z_189*z_47);
    const double z_540 = H_xz*z_539;
    const double z_541 = z_504*z_55;
    const double z_542 = z_506*z_48;
    const double z_543 = z_501*z_86;
    const double z_544 = (z_541 + z_54*z_526) + (z_542 + z_44*z_529) - (z_543 + z_189*z_84);
    const double z_545 = z_540 - (H_xx*z_544 - z_540) - z_519*z_544;
    const double z_546 = H_xz*z_544;
    const double z_547 = z_546 - (H_zz*z_539 - z_546) - z_522*z_539;
    const double R_xx = c[14];
    const double z_548 = 2.0*R_xx + B_zz;
    const double z_549 = z_527 + (B_zz*z_529 + z_527) + (z_520*z_48 - z_44*z_545) + (z_523*z_40 + z_37*z_547) +
        z_548*z_529 - 2.0*(z_65*z_510 - z_533*z_535);
    const double z_550 = B_xz*z_504;
    const double z_551 = z_550 + 2.0*z_510*z_47 + z_37*z_523 - (B_zz*z_506 - z_550) - z_44*z_520 - z_548*z_506;
    const double z_552 = B_xz*z_529;
    const double B_xx = c[18];
    const double z_553 = z_534*z_84;
    const double z_554 = B_xx + 2.0*R_xx;
    const double z_555 = z_552 + (B_xx*z_526 + z_552) + 2.0*(z_86*z_510 - z_533*z_553) + z_554*z_526 - (z_520*z_55
        + z_54*z_545) - (z_523*z_48 - z_44*z_547);
    const double z_556 = B_xz*z_506;
    const double z_557 = z_556 + 2.0*z_510*z_84 + z_54*z_520 - (B_xx*z_504 - z_556) - z_44*z_523 - z_554*z_504;
    const double z_558 = z_318*z_111;
    const double z_559 = cos_delta*z_534;
    const double z_560 = sin_phi*z_559 + z_22*z_553 - z_16*z_535;
    const double z_561 = psi_dot*phi_dot;
    const double z_562 = cos_delta*z_561;
    const double z_563 = sin_phi*z_47;
    const double z_564 = z_160 + z_90 + z_563;
    const double z_565 = sin_phi*z_84;
    const double z_566 = z_565 - z_159 - z_73;
    const double z_567 = H_xx + z_519;
    const double z_568 = 2.0*H_xz*z_564 - z_566*z_567;
    const double z_569 = z_568*z_84;
    const double z_570 = H_zz + z_522;
    const double z_571 = 2.0*z_566*H_xz - z_564*z_570;
    const double z_572 = z_571*z_47;
    const double z_573 = B_xx + z_554;
    const double z_574 = (z_54*z_568 - z_44*z_571) + 2.0*(B_xz*z_16 + 0.5*z_573*z_22);
    const double z_575 = 2.0*z_560*z_84 + z_574;
    const double z_576 = psi_dot*z_13;
    const double z_577 = B_zz + z_548;
    const double z_578 = (z_44*z_568 - z_37*z_571) + 2.0*(B_xz*z_22 + 0.5*z_577*z_16);
    const double z_579 = z_578 - 2.0*z_560*z_47;
    const double z_580 = psi_dot*z_10;
    const double z_581 = z_175*z_17;
    const double z_582 = z_176*z_17;
    const double z_583 = z_181*z_132 + z_178*z_133;
    const double z_584 = z_2*z_84;
    const double z_585 = z_311*z_48;
    const double z_586 = z_314*z_55;
    const double z_587 = z_64*z_84;
    const double z_588 = z_181*z_135 + z_178*z_136;
    const double z_589 = z_2*z_47;
    const double z_590 = z_314*z_48;
    const double z_591 = z_311*z_40;
    const double z_592 = z_64*z_47;
    const double z_593 = z_184*z_155;
    const double z_594 = z_184*z_152;
    const double z_595 = z_122 + psi_dot*z_268;
    const double z_596 = z_125 + psi_dot*z_270;
    const double z_597 = z_595 + z_596;
    const double z_598 = z_597 + z_491;
    const double z_599 = z_52*z_314;
    const double z_600 = r_R*z_311;
    const double z_601 = (z_53*z_595 + c_*z_596) + (z_53*z_489 + c_*z_490);
    const double z_602 = (z_H*z_595 + r_F*z_596) + (z_H*z_489 + r_F*z_490);
    const double z_603 = (z_129 + psi_dot*z_272) + z_488;
    const double z_604 = z_11*z_603;
    const double z_605 = x_B*z_603;
    const double z_606 = z_597 + z_603 - z_492;
    const double z_607 = phi_dot*r_R;
    const double z_608 = z_452 + z_451;
    const double z_609 = cos_delta*z_188;
    const double z_610 = z_609 - z_408;
    const double z_611 = z_86*z_22;
    const double z_612 = z_65*z_16;
    const double z_613 = z_449 - z_450;
    const double z_614 = z_610 + z_611 + z_613*z_84 + z_608*z_47 - z_612;
    const double z_615 = sin_phi*z_65;
    const double z_616 = z_47*z_188;
    const double z_617 = z_615 + z_616;
    const double z_618 = z_16*z_40;
    const double z_619 = z_22*z_48;
    const double z_620 = z_617 - (z_618 - z_619);
    const double z_621 = z_44*z_613 + z_620 - z_37*z_608;
    const double z_622 = sin_phi*z_86;
    const double z_623 = z_84*z_188;
    const double z_624 = z_622 + z_623;
    const double z_625 = z_22*z_55;
    const double z_626 = z_16*z_48;
    const double z_627 = z_624 + (z_625 - z_626);
    const double z_628 = z_44*z_608 + z_627 - z_54*z_613;
    const double z_629 = 2.0*H_xz*z_621 - z_567*z_628;
    const double z_630 = 2.0*H_xz*z_628 - z_570*z_621;
    const double z_631 = z_568*z_55 + z_571*z_48 + 2.0*B_xz*z_608 + z_44*z_630 - 2.0*z_86*z_560 - 2.0*z_614*z_553
        - z_54*z_629 - z_573*z_613;
    const double z_632 = psi_dot*sin_theta;
    const double z_633 = z_568*z_48 + z_571*z_40 + 2.0*B_xz*z_613 + z_44*z_629 - 2.0*z_65*z_560 - 2.0*z_614*z_535
        - z_37*z_630 - z_577*z_608;
    const double z_634 = psi_dot*cos_theta;
    const double z_635 = sin_phi*cos_delta;
    const double z_636 = z_635 + z_22*z_84 - z_47*z_16;
    const double z_637 = z_636*z_636;
    const double z_638 = 1.0 - z_637;
    const double z_639 = sqrt(z_638);
    const double z_640 = r_F*z_639;
    const double z_641 = cos_theta*z_84;
    const double z_642 = sin_theta*z_47;
    const double z_643 = z_641 + z_642;
    const double z_644 = r_F/z_639;
    const double z_645 = z_636*z_644;
    const double z_646 = z_643*z_645;
    const double z_647 = z_174*z_640 - z_566*z_646;
    const double z_648 = z_171*z_640 - z_564*z_646;
    const double z_649 = z_643*z_644;
    const double z_650 = z_643*z_640 + z_637*z_649;
    const double z_651 = z_54*z_647 + z_650*z_84 - z_44*z_648;
    const double z_652 = z_651*lambda_4;
    const double z_653 = z_37*z_648 + z_650*z_47 - z_44*z_647;
    const double z_654 = z_653*lambda_4;
    const double z_655 = z_47*z_25;
    const double z_656 = z_20*z_84;
    const double z_657 = z_143 + z_655 - z_656;
    const double z_658 = z_657*z_645;
    const double z_659 = z_114*z_640 - z_564*z_658;
    const double z_660 = z_117*z_640 + z_566*z_658;
    const double z_661 = z_657*z_644;
    const double z_662 = z_657*z_640 + z_637*z_661;
    const double z_663 = z_44*z_659 + z_54*z_660 - z_662*z_84;
    const double z_664 = sin_theta*lambda_3;
    const double z_665 = z_44*z_660 + z_37*z_659 + z_662*z_47;
    const double z_666 = cos_theta*lambda_3;
    const double z_667 = z_90*lambda_3 + z_160*lambda_3 + z_563*lambda_3;
    const double z_668 = z_564*z_645;
    const double z_669 = z_159*lambda_3 + z_73*lambda_3 - z_565*lambda_3;
    const double z_670 = z_566*z_645;
    const double z_671 = lambda_3*z_84;
    const double z_672 = lambda_3*z_47;
    const double z_673 = cos_delta*lambda_3;
    const double z_674 = z_22*z_671 + sin_phi*z_673 - z_16*z_672;
    const double z_675 = z_637*z_644;
    const double z_676 = z_667*z_668 + z_674*z_675 + z_674*z_640 - z_669*z_670;
    const double z_677 = cos_tilt*cos_delta;
    const double z_678 = z_583*delta_ddot;
    const double z_679 = z_588*delta_ddot;
    const double z_680 = z_482*phi_ddot;
    const double z_681 = z_578 - 2.0*z_636*z_535;
    const double z_682 = cos_theta*psi_ddot;
    const double z_683 = psi_ddot*z_16;
    const double z_684 = z_295 + z_683;
    const double z_685 = z_577*z_684;
    const double z_686 = sin_theta*B_xz;
    const double z_687 = 2.0*z_636*z_553 + z_574;
    const double z_688 = sin_theta*psi_ddot;
    const double z_689 = psi_ddot*z_22;
    const double z_690 = z_293 - z_689;
    const double z_691 = z_573*z_690;
    const double z_692 = cos_theta*B_xz;
    const double spin_f_ddot = a[7];
    const double z_693 = F_yy*spin_f_ddot;
    const double z_694 = z_159*lambda_4 + z_73*lambda_4 - z_565*lambda_4;
    const double z_695 = z_566*z_649;
    const double z_696 = z_90*lambda_4 + z_160*lambda_4 + z_563*lambda_4;
    const double z_697 = z_564*z_649;
    const double z_698 = lambda_4*z_84;
    const double z_699 = lambda_4*z_47;
    const double z_700 = cos_delta*lambda_4;
    const double z_701 = z_22*z_698 + sin_phi*z_700 - z_16*z_699;
    const double z_702 = z_564*z_661;
    const double z_703 = z_566*z_661;
    const double z_704 = r_F/(z_638*z_639);
    const double z_705 = z_636*z_704;
    const double z_706 = z_643*z_705;
    const double z_707 = z_566*z_706;
    const double z_708 = z_174*z_644;
    const double z_709 = z_564*z_706;
    const double z_710 = z_171*z_644;
    const double z_711 = z_637*z_704;
    const double z_712 = z_643*z_711;
    const double z_713 = z_657*z_705;
    const double z_714 = z_564*z_713;
    const double z_715 = z_114*z_644;
    const double z_716 = z_566*z_713;
    const double z_717 = z_117*z_644;
    const double z_718 = z_657*z_711;
    const double z_719 = sin_phi*psi_ddot;
    const double z_720 = theta_ddot + z_719;
    const double z_721 = z_693 + z_694*z_695 + z_669*z_703 + z_636*(z_694*z_707 + z_694*z_708 + z_701*z_649 +
        z_669*z_716 + z_674*z_661 - z_696*z_709 - z_696*z_710 - z_701*z_712 - z_667*z_714 - z_667*z_715 -
        z_669*z_717 - z_674*z_718) + z_720*z_559 - z_696*z_697 - 2.0*z_701*z_646 - z_667*z_702 - 2.0*z_674*z_658 -
        z_684*z_535 - z_690*z_553;
    const double z_722 = cos_theta*z_47;
    const double z_723 = sin_theta*z_84;
    const double z_724 = cos_tilt*delta_ddot;
    const double z_725 = z_724 + z_37*z_684 + z_720*z_47 - z_44*z_690;
    const double z_726 = sin_tilt*delta_ddot;
    const double z_727 = z_726 + z_44*z_684 - z_54*z_690 - z_720*z_84;
    const double z_728 = 2.0*z_696*z_646 + 2.0*z_667*z_658 - z_570*z_725 - 2.0*H_xz*z_727;
    const double z_729 = 2.0*z_694*z_646 + 2.0*z_669*z_658 - 2.0*H_xz*z_725 - z_567*z_727;
    const double z_730 = z_342*theta_ddot + z_344*theta_ddot;
    const double z_731 = cos_tilt*z_47;
    const double z_732 = sin_theta*z_731;
    const double z_733 = sin_delta*z_33;
    const double z_734 = cos_theta*z_733;
    const double z_735 = z_260 + z_262 + z_732*delta_ddot + z_734*delta_ddot;
    const double z_736 = cos_theta*z_731;
    const double z_737 = sin_delta*z_36;
    const double z_738 = sin_theta*z_737;
    const double z_739 = z_259 + z_264 - z_736*delta_ddot - z_738*delta_ddot;
    const double z_740 = z_235 + m_H*z_730 - 2.0*z_269 - psi_dot*z_496 - z_133*z_735 - z_136*z_739 - y_ddot*z_300
        - x_ddot*z_301;
    const double z_741 = lambda_3 - (z_239 + m_F*z_730 - 2.0*z_271 - psi_dot*z_497 - z_132*z_735 - z_135*z_739 -
        y_ddot*z_303 - x_ddot*z_304);
    const double z_742 = z_667*z_640 + r_F*z_741 - z_H*z_740;
    const double z_743 = z_669*z_640 + c_*z_741 - z_53*z_740;
    const double z_744 = B_yy + R_yy;
    const double z_745 = m_R*(r_R*r_R);
    const double z_746 = z_744 + z_745;
    const double z_747 = psi_dot*z_66;
    const double spin_r_ddot = a[6];
    const double z_748 = psi_dot*z_314;
    const double z_749 = psi_dot*z_311;
    const double z_750 = z_344*z_27;
    const double z_751 = z_342*z_27;
    const double z_752 = z_342*z_2;
    const double z_753 = z_344*z_2;
    const double z_754 = sin_theta*z_95;
    const double z_755 = z_13*z_55;
    const double z_756 = phi_dot*z_86;
    const double z_757 = cos_theta*z_80;
    const double z_758 = z_10*z_40;
    const double z_759 = phi_dot*z_65;
    const double z_760 = r_R*z_10;
    const double z_761 = z_52*z_13;
    const double z_762 = sin_theta*z_55;
    const double z_763 = phi_dot*z_84;
    const double z_764 = cos_theta*z_40;
    const double z_765 = phi_dot*z_47;
    const double z_766 = R_yy*z_188;
    const double z_767 = z_766 - 0.5*(z_568*z_86 + z_571*z_65 + 2.0*z_39*z_560 + z_629*z_84 + z_630*z_47 -
        2.0*B_yy*z_188 - 2.0*z_614*z_559);
    const double z_768 = 2.0*z_767;
    const double z_769 = cos_delta*z_650 - z_648*z_47 - z_647*z_84;
    const double z_770 = cos_delta*z_662 + z_660*z_84 - z_659*z_47;
    const double z_771 = cos_theta*z_737;
    const double z_772 = sin_theta*z_733;
    const double z_773 = z_482*theta_ddot;
    const double z_774 = z_588*phi_ddot;
    const double z_775 = z_583*phi_ddot;
    const double z_776 = z_740 - z_741;
    const double z_777 = -z_776;
    const double z_778 = z_199 + z_155*z_265 + z_152*z_266 - 2.0*z_273 - psi_dot*z_495 - y_ddot*z_346 -
        x_ddot*z_347;
    D[35] = (-0.5)*(sin_phi*(phi_dot*z_524 + cos_theta*z_549 + z_10*z_551 + sin_theta*z_555 + z_13*z_557 +
        2.0*phi_dot*z_558 + 2.0*z_560*z_562 + z_575*z_576 + 4.0*z_482*z_581 + 2.0*z_583*z_584 + 4.0*z_583*z_276 +
        4.0*z_583*z_586 + 2.0*z_583*z_587 + 4.0*z_588*z_591 + 4.0*z_588*z_280 + 4.0*z_308*z_594 + 2.0*z_601*z_282
        + 2.0*z_601*z_283 + 2.0*z_86*z_601 + 2.0*z_602*z_285 + 2.0*z_602*z_286 + 2.0*z_606*z_607 + z_633*z_634 +
        2.0*cos_theta*z_654 + 2.0*z_663*z_664 + 2.0*z_665*z_666 + 2.0*z_43*z_679 + 2.0*z_293*z_593 +
        2.0*z_295*z_594 + 2.0*z_342*z_680 + 2.0*z_344*z_680 + z_681*z_682 + cos_theta*z_685 + 2.0*z_686*z_684 +
        z_687*z_688 + 2.0*z_721*z_723 + 2.0*z_743*z_84 + 2.0*z_746*z_747 - z_569*z_561 - z_572*z_561 - z_579*z_580
        - 4.0*z_482*z_582 - 4.0*z_583*z_585 - 4.0*z_583*z_277 - 2.0*z_588*z_589 - 4.0*z_588*z_590 -
        4.0*z_588*z_279 - 2.0*z_588*z_592 - 4.0*z_309*z_593 - 2.0*z_598*z_599 - 2.0*z_598*z_600 - 2.0*z_65*z_602 -
        2.0*z_311*z_604 - 2.0*z_314*z_605 - z_631*z_632 - 2.0*sin_theta*z_652 - 2.0*cos_delta*z_676 -
        2.0*z_677*z_678 - 2.0*z_588*z_289 - 2.0*z_583*z_290 - 2.0*z_583*z_291 - 2.0*z_588*z_292 - 2.0*z_483*z_297
        - sin_theta*z_691 - 2.0*z_692*z_690 - 2.0*z_721*z_722 - z_173*z_728 - z_263*z_728 - z_170*z_729 -
        z_261*z_729 - 2.0*z_742*z_47) - cos_phi*((2.0*R_yy*z_189 - (2.0*(z_39*z_510 + z_533*z_559) + (z_86*z_520 -
        z_545*z_84) + (z_65*z_523 - z_547*z_47) - 2.0*B_yy*z_189)) + 2.0*R_yy*spin_r_ddot + z_311*z_551 +
        2.0*z_583*z_754 + 4.0*z_583*z_225 + 2.0*z_583*z_224 + 4.0*z_583*z_755 + 2.0*z_583*z_328 + 2.0*z_583*z_329
        + 2.0*z_583*z_330 + 4.0*z_583*z_756 + 2.0*z_588*z_757 + 2.0*z_588*z_229 + 2.0*z_588*z_331 +
        2.0*z_588*z_332 + 2.0*z_588*z_333 + 2.0*z_483*z_334 + 2.0*psi_dot*r_R*z_494 + 2.0*z_760*z_598 +
        2.0*z_49*z_601 + 2.0*z_601*z_336 + 2.0*z_58*z_602 + 2.0*z_57*z_602 + 2.0*z_602*z_765 + 2.0*z_10*z_604 +
        psi_dot*z_768 + 2.0*z_676*z_723 + 2.0*z_679*z_771 + 2.0*z_678*z_772 + 2.0*z_265*z_594 + 2.0*z_583*z_259 +
        2.0*z_588*z_338 + 2.0*z_175*z_773 + 2.0*z_84*z_775 + 4.0*z_745*z_719 + 2.0*z_744*z_720 +
        2.0*cos_delta*z_721 + z_729*z_84 + 2.0*y_ddot*z_335 + 2.0*x_ddot*z_341 + 2.0*z_173*z_742 + 2.0*z_263*z_742
        + 2.0*z_170*z_743 + 2.0*z_261*z_743 + 2.0*z_345*z_778 + 2.0*z_349*z_778 + 2.0*r_R*(-z_778 - z_776) -
        z_314*z_557 - 2.0*z_318*z_192 - z_575*z_748 - z_579*z_749 - 2.0*z_482*z_750 - 2.0*z_482*z_751 -
        2.0*z_482*z_752 - 2.0*z_482*z_753 - 2.0*z_583*z_226 - 2.0*z_588*z_231 - 4.0*z_588*z_230 - 4.0*z_588*z_758
        - 4.0*z_588*z_759 - 2.0*z_196*z_593 - 2.0*z_197*z_594 - 2.0*z_593*z_351 - 2.0*z_594*z_350 -
        2.0*z_761*z_598 - 2.0*z_601*z_762 - 2.0*z_45*z_601 - 2.0*z_601*z_763 - 2.0*z_602*z_764 - 2.0*z_602*z_337 -
        2.0*z_13*z_605 - 2.0*z_769*lambda_4 - 2.0*z_770*lambda_3 - 2.0*z_676*z_722 - 2.0*z_732*z_679 -
        2.0*z_736*z_678 - 2.0*z_266*z_593 - 2.0*z_588*z_260 - 2.0*z_583*z_339 - 2.0*z_176*z_773 - 2.0*z_47*z_774 -
        (z_569 + z_572 - 2.0*z_636*z_559 - 2.0*sin_phi*z_744)*psi_ddot - z_728*z_47 - 2.0*z_342*z_777 -
        2.0*z_344*z_777));
    const double z_779 = theta_dot*cos_phi;
    const double z_780 = psi_dot*cos_phi;
    const double z_781 = theta_dot*z_780;
    const double z_782 = r_R*z_482;
    const double z_783 = cos_phi*z_52;
    const double z_784 = z_783*z_17;
    const double z_785 = sin_phi*z_82;
    const double z_786 = z_55*z_373;
    const double z_787 = z_48*z_188;
    const double z_788 = sin_phi*z_80;
    const double z_789 = z_48*z_373;
    const double z_790 = z_188*z_40;
    const double z_791 = z_37*z_588;
    const double z_792 = z_52*z_27;
    const double z_793 = z_123*z_135 + z_119*z_136;
    const double z_794 = theta_dot*z_40;
    const double z_795 = z_123*z_132 + z_119*z_133;
    const double z_796 = theta_dot*z_48;
    const double z_797 = z_54*z_27;
    const double z_798 = z_127*z_152;
    const double z_799 = z_52*z_373;
    const double z_800 = sin_phi*z_48;
    const double z_801 = sin_phi*z_40;
    const double z_802 = z_248 + psi_dot*z_179;
    const double z_803 = z_250 + psi_dot*z_182;
    const double z_804 = z_802 + z_803 + z_498;
    const double z_805 = theta_dot*r_R;
    const double z_806 = (z_H*z_802 + r_F*z_803) + (z_H*z_496 + r_F*z_497);
    const double z_807 = (z_53*z_802 + c_*z_803) + (z_53*z_496 + c_*z_497);
    const double z_808 = (z_253 + psi_dot*z_185) + z_495;
    const double z_809 = theta_dot*z_11;
    const double z_810 = cos_phi*lambda_3;
    const double z_811 = z_694*z_670 - z_696*z_668 - z_701*z_675 - z_701*z_640;
    const double z_812 = sin_phi*z_731;
    const double z_813 = delta_ddot*z_731;
    const double z_814 = sin_phi*z_737;
    const double z_815 = delta_ddot*z_733;
    const double z_816 = z_127*z_155;
    const double z_817 = r_R*theta_ddot;
    const double z_818 = z_37*theta_ddot;
    const double z_819 = cos_phi*psi_ddot;
    const double z_820 = cos_phi*B_xz;
    const double z_821 = z_20*z_731;
    const double z_822 = z_25*z_737;
    const double z_823 = cos_phi*z_43;
    const double z_824 = z_148 + z_822*delta_ddot + z_823*delta_ddot - z_149 - z_90*phi_ddot - z_160*phi_ddot -
        z_821*delta_ddot - z_563*phi_ddot;
    const double z_825 = z_25*z_731;
    const double z_826 = z_20*z_733;
    const double z_827 = cos_phi*z_677;
    const double z_828 = z_146 + z_826*delta_ddot + z_565*phi_ddot - z_151 - z_73*phi_ddot - z_159*phi_ddot -
        z_825*delta_ddot - z_827*delta_ddot;
    const double z_829 = z_167*phi_ddot;
    const double z_830 = (r_R*z_147 - z_52*z_150 - z_52*z_164 - r_R*z_163) + z_829;
    const double z_831 = z_101 + psi_dot*z_489 + m_H*z_830 + x_ddot*z_300 - 2.0*z_180 - z_136*z_824 - z_133*z_828
        - y_ddot*z_301;
    const double z_832 = lambda_4 - (z_104 + psi_dot*z_490 + m_F*z_830 + x_ddot*z_303 - 2.0*z_183 - z_135*z_824 -
        z_132*z_828 - y_ddot*z_304);
    const double z_833 = z_694*z_640 + c_*z_832 - z_53*z_831;
    const double z_834 = z_832 - z_831;
    const double z_835 = z_696*z_640 + r_F*z_832 - z_H*z_831;
    const double z_836 = m_B*z_167;
    const double z_837 = z_31 + psi_dot*z_488 + z_155*z_147 + phi_ddot*z_836 + x_ddot*z_346 - 2.0*z_186 -
        z_152*z_150 - z_155*z_163 - z_152*z_164 - y_ddot*z_347;
    const double z_838 = z_52*z_482;
    const double z_839 = z_167*z_17;
    const double z_840 = sin_phi*z_95;
    const double z_841 = z_54*z_583;
    const double z_842 = z_188*z_55;
    const double z_843 = z_40*z_373;
    const double z_844 = r_R*z_27;
    const double z_845 = z_37*z_27;
    const double z_846 = theta_dot*z_55;
    const double z_847 = r_R*z_373;
    const double z_848 = z_52*z_188;
    const double z_849 = sin_phi*z_55;
    const double z_850 = theta_dot*z_52;
    const double z_851 = theta_dot*x_B;
    const double z_852 = sin_phi*z_733;
    const double z_853 = delta_ddot*z_737;
    const double z_854 = z_52*theta_ddot;
    const double z_855 = z_54*theta_ddot;
    D[36] = (-0.5)*(sin_theta*(cos_phi*z_549 + z_551*z_66 + z_557*z_779 + z_575*z_781 + 4.0*z_482*z_784 +
        2.0*z_583*z_361 + 4.0*z_583*z_786 + 2.0*z_583*z_362 + 2.0*z_588*z_788 + 4.0*z_588*z_790 + 2.0*z_3*z_791 +
        2.0*z_368*z_791 + 2.0*z_793*z_370 + 2.0*z_795*z_95 + 4.0*z_795*z_796 + 2.0*z_795*z_797 + 4.0*z_594*z_402 +
        z_579*z_17 + 2.0*z_601*z_800 + 2.0*z_601*z_374 + 2.0*z_601*z_375 + 2.0*z_602*z_376 + 2.0*z_602*z_377 +
        2.0*z_806*z_379 + 2.0*z_807*z_55 + 2.0*z_807*z_381 + phi_dot*z_631 + z_633*z_780 + 2.0*cos_phi*z_654 +
        2.0*z_665*z_810 + 2.0*z_811*z_84 + 2.0*z_679*z_814 + 2.0*z_795*z_815 + 2.0*z_594*z_387 + 2.0*z_418*z_773 +
        2.0*z_795*z_145 + 2.0*z_793*z_818 + 2.0*z_393*z_593 + 2.0*z_167*z_680 + z_681*z_819 + cos_phi*z_685 +
        2.0*z_52*z_834 + 2.0*z_742*z_400 + 2.0*z_743*z_360 + 2.0*z_778*z_401 - z_579*z_747 - 2.0*z_368*z_782 -
        2.0*z_3*z_782 - 2.0*z_583*z_785 - 4.0*z_583*z_787 - 4.0*z_583*z_364 - 4.0*z_588*z_789 - 4.0*z_588*z_366 -
        2.0*z_486*z_792 - 2.0*z_793*z_82 - 4.0*z_793*z_794 - 2.0*z_368*z_593 - 2.0*z_3*z_593 - 2.0*z_27*z_798 -
        2.0*z_598*z_799 - 2.0*z_193*z_598 - 2.0*z_602*z_801 - 2.0*z_804*z_805 - 2.0*z_806*z_48 - 2.0*z_373*z_605 -
        2.0*z_188*z_604 - 2.0*z_808*z_809 - 2.0*z_563*z_676 - 2.0*z_812*z_678 - 2.0*z_793*z_813 - 2.0*z_588*z_384
        - 2.0*z_583*z_386 - 2.0*theta_ddot*z_816 - 2.0*z_486*z_817 - 2.0*z_583*z_390 - 2.0*z_588*z_392 -
        z_687*phi_ddot - 2.0*z_690*z_820 - 2.0*z_63*z_721 - z_728*z_391 - z_729*z_365 - 2.0*z_54*z_833 -
        2.0*z_44*z_835 - 2.0*x_B*z_837 - 2.0*z_107*z_777) - cos_theta*(z_551*z_779 + cos_phi*z_555 +
        2.0*z_583*z_840 + 4.0*z_583*z_789 + 2.0*z_368*z_841 + 4.0*z_583*z_366 + 2.0*z_3*z_841 + 4.0*z_583*z_842 +
        2.0*z_588*z_361 + 2.0*z_588*z_362 + 4.0*z_588*z_412 + 2.0*z_486*z_844 + 4.0*z_793*z_796 + 2.0*z_795*z_82 +
        2.0*z_27*z_816 + z_575*z_17 + 2.0*z_598*z_847 + 2.0*z_601*z_413 + 2.0*z_602*z_800 + 2.0*z_602*z_375 +
        2.0*z_806*z_381 + 2.0*z_807*z_48 + 2.0*z_807*z_415 + 2.0*z_373*z_604 + phi_dot*z_633 + 2.0*z_663*z_810 +
        2.0*z_565*z_676 + 2.0*z_811*z_47 + 2.0*z_795*z_813 + 2.0*z_678*z_852 + 2.0*z_583*z_384 + 2.0*z_588*z_416 +
        2.0*z_793*z_145 + 2.0*z_795*z_855 + 2.0*z_393*z_594 + 2.0*z_783*z_680 + z_681*phi_ddot + 2.0*z_684*z_820 +
        z_687*z_819 + 2.0*z_85*z_721 + 2.0*z_44*z_833 + 2.0*z_37*z_835 + 2.0*z_11*z_837 + 2.0*z_742*z_360 +
        2.0*z_743*z_385 + 2.0*z_778*z_419 - z_557*z_66 - z_575*z_747 - z_579*z_781 - 2.0*z_368*z_838 -
        2.0*z_3*z_838 - 4.0*z_482*z_839 - 2.0*z_588*z_785 - 4.0*z_588*z_787 - 4.0*z_588*z_843 - 2.0*z_793*z_80 -
        2.0*z_793*z_845 - 2.0*z_795*z_370 - 4.0*z_795*z_846 - 2.0*z_368*z_594 - 4.0*z_593*z_402 - 2.0*z_3*z_594 -
        2.0*z_598*z_848 - 2.0*z_601*z_849 - 2.0*z_601*z_376 - 2.0*z_602*z_414 - 2.0*z_804*z_850 - 2.0*z_806*z_40 -
        2.0*z_188*z_605 - 2.0*z_808*z_851 - z_631*z_780 - 2.0*cos_phi*z_652 - 2.0*z_812*z_679 - 2.0*z_793*z_853 -
        2.0*z_593*z_387 - 2.0*z_107*z_773 - 2.0*theta_ddot*z_798 - 2.0*z_486*z_854 - 2.0*z_588*z_390 -
        2.0*z_583*z_417 - cos_phi*z_691 - z_728*z_365 - z_729*z_363 - 2.0*r_R*z_834 - 2.0*z_777*z_418));
    const double z_856 = delta_dot*z_36;
    const double z_857 = z_16*z_856;
    const double z_858 = sin_tilt*z_46;
    const double z_859 = z_22*z_858;
    const double z_860 = sin_phi*sin_tilt;
    const double z_861 = delta_dot*z_33;
    const double z_862 = z_22*z_861;
    const double z_863 = z_16*z_858;
    const double z_864 = sin_phi*cos_tilt;
    const double z_865 = delta_dot*sin_phi;
    const double z_866 = z_534*z_533;
    const double z_867 = cos_tilt*z_22;
    const double z_868 = sin_tilt*z_16;
    const double z_869 = sin_tilt*z_529;
    const double z_870 = cos_tilt*z_526;
    const double z_871 = delta_dot*z_501;
    const double z_872 = cos_tilt*z_568;
    const double z_873 = z_506*z_858;
    const double z_874 = z_504*z_861;
    const double z_875 = sin_tilt*z_571;
    const double z_876 = z_504*z_858;
    const double z_877 = z_506*z_856;
    const double z_878 = z_69*z_858;
    const double z_879 = z_2*z_429;
    const double z_880 = z_77*z_861;
    const double z_881 = z_71*z_858;
    const double z_882 = z_75*z_861;
    const double z_883 = cos_phi*z_81;
    const double z_884 = z_77*z_858;
    const double z_885 = z_2*z_428;
    const double z_886 = z_75*z_858;
    const double z_887 = z_71*z_856;
    const double z_888 = z_69*z_856;
    const double z_889 = z_64*z_428;
    const double z_890 = z_10*z_858;
    const double z_891 = z_13*z_856;
    const double z_892 = z_13*z_858;
    const double z_893 = z_10*z_861;
    const double z_894 = sin_tilt*z_188;
    const double z_895 = cos_tilt*z_188;
    const double z_896 = cos_tilt*z_510;
    const double z_897 = sin_tilt*z_510;
    const double z_898 = z_25*z_858;
    const double z_899 = z_20*z_861;
    const double z_900 = cos_tilt*z_66;
    const double z_901 = z_20*z_858;
    const double z_902 = z_25*z_856;
    const double z_903 = sin_tilt*z_66;
    const double z_904 = cos_theta*z_858;
    const double z_905 = sin_theta*z_856;
    const double z_906 = sin_theta*z_858;
    const double z_907 = cos_theta*z_861;
    const double z_908 = sin_tilt*z_534;
    const double z_909 = z_506*z_908;
    const double z_910 = cos_tilt*z_534;
    const double z_911 = z_504*z_910;
    const double z_912 = cos_tilt*z_501;
    const double z_913 = sin_tilt*z_501;
    const double z_914 = z_650*lambda_4;
    const double z_915 = z_647*lambda_4;
    const double z_916 = z_648*lambda_4;
    const double z_917 = z_662*lambda_3;
    const double z_918 = z_659*lambda_3;
    const double z_919 = z_660*lambda_3;
    const double z_920 = cos_tilt*z_20;
    const double z_921 = sin_tilt*z_25;
    const double z_922 = sin_theta*sin_tilt;
    const double z_923 = cos_theta*cos_tilt;
    const double z_924 = z_42*z_20;
    const double z_925 = z_42*z_25;
    const double z_926 = z_42*z_793;
    const double z_927 = z_42*z_795;
    const double z_928 = z_36*z_25;
    const double z_929 = z_33*z_20;
    const double z_930 = z_793*z_36;
    const double z_931 = z_795*z_33;
    const double z_932 = z_636*z_908;
    const double z_933 = z_636*z_910;
    const double z_934 = sin_phi*z_516;
    const double z_935 = sin_phi*z_46;
    const double z_936 = z_46*z_22;
    const double z_937 = z_516*z_16;
    const double z_938 = z_506*z_516;
    const double z_939 = z_46*z_504;
    const double z_940 = z_501*z_46;
    const double z_941 = z_501*z_516;
    const double z_942 = z_42*z_64;
    const double z_943 = z_25*z_942;
    const double z_944 = z_33*z_64;
    const double z_945 = z_20*z_944;
    const double z_946 = z_46*z_66;
    const double z_947 = z_20*z_942;
    const double z_948 = z_36*z_64;
    const double z_949 = z_25*z_948;
    const double z_950 = z_516*z_66;
    const double z_951 = cos_theta*z_942;
    const double z_952 = sin_theta*z_948;
    const double z_953 = sin_theta*z_942;
    const double z_954 = cos_theta*z_944;
    const double z_955 = cos_phi*z_46;
    const double z_956 = cos_phi*z_516;
    const double z_957 = z_534*z_501;
    const double z_958 = z_534*z_636;
    D[37] = 0.5*(cos_delta*(z_523*z_857 + z_547*z_860 + z_520*z_863 + z_545*z_864 + 2.0*z_866*z_868 +
        2.0*z_560*z_870 + z_568*z_873 + z_568*z_874 + z_571*z_876 + z_571*z_877 + 4.0*z_583*z_878 +
        2.0*z_583*z_879 + 4.0*z_583*z_880 + 4.0*z_583*z_882 + 2.0*z_583*z_883 + 4.0*z_588*z_887 + 4.0*z_793*z_890
        + 4.0*z_795*z_892 + 2.0*z_613*z_896 + 2.0*z_608*z_897 + 2.0*z_601*z_898 + 2.0*z_602*z_901 +
        2.0*z_602*z_903 + 2.0*z_807*z_906 + 2.0*z_807*z_907 + 2.0*z_914*z_868 + 2.0*z_864*z_915 + 2.0*z_860*z_916
        + 2.0*z_917*z_868 + 2.0*z_860*z_918 + 2.0*z_676*z_920 + 2.0*z_811*z_922 + 2.0*z_811*z_923 +
        2.0*z_425*z_927 + 2.0*z_679*z_928 + 2.0*z_678*z_929 + 2.0*z_426*z_931 + 2.0*z_864*z_775 + 2.0*z_721*z_867
        + z_729*z_864 + 2.0*z_743*z_429 - z_523*z_859 - z_520*z_862 - 2.0*z_510*z_865 - 2.0*z_866*z_867 -
        2.0*z_560*z_869 - 2.0*z_560*z_871 - z_189*z_872 - z_189*z_875 - 4.0*z_583*z_881 - 4.0*z_588*z_884 -
        2.0*z_588*z_885 - 4.0*z_588*z_886 - 4.0*z_588*z_888 - 2.0*z_588*z_889 - 4.0*z_793*z_891 - 4.0*z_795*z_893
        - z_523*z_894 - z_520*z_895 - 2.0*z_601*z_899 - 2.0*z_601*z_900 - 2.0*z_602*z_902 - 2.0*z_806*z_904 -
        2.0*z_806*z_905 - 2.0*z_614*z_909 - 2.0*z_614*z_911 - z_629*z_912 - z_630*z_913 - 2.0*z_914*z_867 -
        2.0*z_917*z_867 - 2.0*z_864*z_919 - 2.0*z_676*z_921 - 2.0*z_679*z_924 - 2.0*z_678*z_925 - 2.0*z_426*z_926
        - 2.0*z_425*z_930 - 2.0*z_860*z_774 - 2.0*z_684*z_932 - 2.0*z_690*z_933 - 2.0*z_721*z_868 - z_720*z_875 -
        z_720*z_872 - z_728*z_860 - 2.0*z_742*z_428) + sin_delta*(z_523*z_934 + z_520*z_935 + 2.0*sin_phi*z_866 +
        2.0*z_510*z_937 + 2.0*z_560*z_938 + 2.0*z_560*z_939 + z_568*z_940 + z_571*z_941 + 2.0*z_583*z_943 +
        2.0*z_588*z_947 + 4.0*z_588*z_950 + 2.0*z_793*z_951 + 2.0*z_793*z_952 + 2.0*z_602*z_956 +
        2.0*sin_phi*z_914 + 2.0*sin_phi*z_917 + 2.0*cos_phi*z_676 + 2.0*z_429*z_678 + z_42*(z_547*z_22 +
        z_568*z_529 + 2.0*z_583*z_29 + 2.0*z_583*z_26 + 4.0*z_583*z_23 + 2.0*z_588*z_28 + 2.0*z_588*z_21 +
        2.0*z_793*z_196 + 2.0*z_601*z_71 + 2.0*z_602*z_77 + 2.0*z_602*z_75 + 2.0*z_10*z_806 + 2.0*z_13*z_807 +
        z_506*z_629 + z_504*z_630 + 2.0*z_22*z_916 + 2.0*z_22*z_918 + 2.0*z_16*z_919 + 2.0*z_583*z_147 +
        2.0*z_793*z_266 + 2.0*z_795*z_265 + z_568*z_684 + z_571*z_690 + 2.0*sin_theta*z_833 + 2.0*z_742*z_20 +
        2.0*z_743*z_25 - z_545*z_16 - z_571*z_526 - 4.0*z_588*z_18 - 2.0*z_795*z_197 - z_523*z_613 - z_520*z_608 -
        2.0*z_601*z_69 - 2.0*z_16*z_915 - 2.0*z_588*z_150 - 2.0*z_588*z_164 - 2.0*z_583*z_163 - z_728*z_22 -
        z_729*z_16 - 2.0*cos_theta*z_835) + (z_545*z_22 + 4.0*z_583*z_18 + z_504*z_629 + 2.0*z_22*z_915 +
        2.0*z_583*z_150 + 2.0*z_583*z_164 + z_568*z_690 + z_729*z_22 + 2.0*cos_theta*z_833 - z_568*z_526 -
        2.0*z_583*z_28 - 2.0*z_583*z_21 - 2.0*z_795*z_196 - z_520*z_613 - 2.0*z_601*z_77 - 2.0*z_601*z_75 -
        2.0*z_10*z_807 - 2.0*z_22*z_919 - 2.0*z_795*z_266 - 2.0*z_743*z_20)*z_33 - 2.0*z_510*z_936 -
        2.0*z_189*z_560 - 2.0*z_583*z_945 - 4.0*z_583*z_946 - 2.0*z_588*z_949 - 2.0*z_795*z_953 - 2.0*z_795*z_954
        - 2.0*z_510*z_188 - 2.0*z_601*z_955 - 2.0*z_614*z_957 - 2.0*z_428*z_679 - 2.0*z_720*z_958 -
        2.0*sin_phi*z_721 - (z_547*z_16 + 2.0*z_588*z_26 + 2.0*z_588*z_29 + 4.0*z_588*z_23 + z_523*z_608 +
        2.0*z_602*z_71 + 2.0*z_13*z_806 + 2.0*z_16*z_916 + 2.0*z_16*z_918 + 2.0*z_588*z_147 + 2.0*z_793*z_265 +
        2.0*sin_theta*z_835 + 2.0*z_742*z_25 - z_571*z_529 - 2.0*z_793*z_197 - 2.0*z_602*z_69 - z_506*z_630 -
        2.0*z_588*z_163 - z_571*z_684 - z_728*z_16)*z_36));
    D[40] = cos_psi*z_499 + z_447 - z_483*z_5 - z_7*z_487 - sin_psi*z_493;
    D[41] = z_5*z_487 + cos_psi*z_493 + sin_psi*z_499 + z_481 - z_483*z_7;
    const double z_959 = sin_phi*z_746;
    D[42] = (-0.5)*(2.0*z_185*z_14 + 2.0*z_182*z_102 + 2.0*z_179*z_62 + z_568*z_623 + z_571*z_616 + z_450*z_575 +
        z_452*z_579 + z_451*z_579 + 2.0*z_483*z_109 + 2.0*z_483*z_108 + 2.0*z_242*z_487 + 2.0*z_178*z_489 +
        2.0*z_181*z_490 + 2.0*z_184*z_488 + z_631*z_22 - 2.0*z_272*z_195 - 2.0*z_270*z_237 - 2.0*z_268*z_222 -
        2.0*z_609*z_560 - z_449*z_575 - 2.0*z_241*z_487 - 2.0*z_107*z_494 - 2.0*z_119*z_496 - 2.0*z_123*z_497 -
        2.0*z_127*z_495 - z_633*z_16 - sin_phi*z_768 - 2.0*z_188*z_959);
    const double z_960 = cos_delta*z_780;
    const double z_961 = psi_dot*z_20;
    const double z_962 = psi_dot*z_25;
    const double z_963 = z_52*z_22;
    const double z_964 = r_R*z_16;
    const double z_965 = m_R*z_167;
    const double z_966 = (cos_phi*z_524 + z_551*z_25) - (z_557*z_20 - 2.0*z_965*z_111);
    D[43] = 0.5*(4.0*z_483*z_448 + 4.0*z_449*z_838 + 4.0*z_583*z_623 + 4.0*z_583*z_622 + 4.0*z_451*z_791 +
        4.0*z_452*z_791 + 4.0*z_588*z_618 + 4.0*z_583*z_625 + 4.0*z_450*z_841 + 4.0*z_583*z_455 + 4.0*z_583*z_456
        + 4.0*z_588*z_458 + 4.0*z_449*z_594 + 2.0*z_560*z_960 + z_10*z_575 + z_13*z_579 + 2.0*z_73*z_601 +
        2.0*z_159*z_601 + 2.0*z_563*z_602 + 2.0*z_90*z_602 + 2.0*z_160*z_602 + 2.0*z_167*z_606 + cos_theta*z_631 +
        sin_theta*z_633 + 2.0*z_780*z_959 + z_966 - 4.0*z_451*z_782 - 4.0*z_452*z_782 - 4.0*z_450*z_838 -
        4.0*z_449*z_841 - 4.0*z_583*z_626 - 4.0*z_588*z_457 - 4.0*z_588*z_619 - 4.0*z_588*z_616 - 4.0*z_588*z_615
        - 4.0*z_450*z_594 - 4.0*z_451*z_593 - 4.0*z_452*z_593 - z_569*z_780 - z_572*z_780 - z_575*z_961 -
        z_579*z_962 - 2.0*z_963*z_598 - 2.0*z_964*z_598 - 2.0*z_565*z_601 - 2.0*z_16*z_604 - 2.0*z_22*z_605);
    const double z_967 = z_20*z_40;
    const double z_968 = z_25*z_55;
    const double z_969 = r_R*z_20;
    const double z_970 = z_52*z_25;
    const double z_971 = z_551*z_22 + z_557*z_16;
    D[44] = (-0.5)*(4.0*z_793*z_337 + 4.0*z_793*z_764 + 4.0*z_795*z_762 + 4.0*z_795*z_45 + 4.0*z_486*z_761 +
        4.0*z_69*z_838 + 4.0*z_588*z_967 + 4.0*z_13*z_798 + 4.0*z_75*z_782 + 4.0*z_77*z_782 + 4.0*z_71*z_841 +
        4.0*z_588*z_209 + 4.0*z_588*z_208 + 4.0*z_69*z_594 + 4.0*z_75*z_593 + 4.0*z_77*z_593 + z_503*z_579 +
        2.0*z_970*z_598 + 2.0*z_113*z_601 + 2.0*z_463*z_602 + 2.0*z_342*z_804 + 2.0*z_344*z_804 + 2.0*z_25*z_605 +
        2.0*z_345*z_808 + 2.0*z_349*z_808 - 4.0*z_795*z_336 - 4.0*z_795*z_49 - 4.0*z_793*z_57 - 4.0*z_793*z_58 -
        4.0*z_486*z_760 - 4.0*z_71*z_838 - 4.0*z_75*z_791 - 4.0*z_77*z_791 - 4.0*z_583*z_203 - 4.0*z_583*z_204 -
        4.0*z_583*z_202 - 4.0*z_10*z_816 - 4.0*z_69*z_841 - 4.0*z_583*z_968 - 4.0*z_588*z_210 - 4.0*z_71*z_594 -
        z_505*z_575 - z_314*z_575 - z_311*z_579 - 2.0*z_969*z_598 - 2.0*z_462*z_601 - 2.0*z_116*z_602 -
        2.0*z_173*z_806 - 2.0*z_263*z_806 - 2.0*z_170*z_807 - 2.0*z_261*z_807 - 2.0*z_20*z_604 - 2.0*z_767 -
        z_971);
    const double z_972 = z_10*z_733;
    const double z_973 = cos_delta*z_907;
    const double z_974 = delta_dot*z_63;
    const double z_975 = z_43*z_66;
    const double z_976 = z_13*z_737;
    const double z_977 = cos_delta*z_905;
    const double z_978 = cos_phi*sin_delta;
    const double z_979 = z_46*z_978;
    const double z_980 = z_66*z_677;
    const double z_981 = z_75*z_733;
    const double z_982 = z_77*z_733;
    const double z_983 = cos_delta*z_899;
    const double z_984 = z_71*z_737;
    const double z_985 = z_69*z_737;
    const double z_986 = cos_delta*z_902;
    const double z_987 = z_13*z_731;
    const double z_988 = z_46*z_43;
    const double z_989 = sin_theta*z_988;
    const double z_990 = z_10*z_731;
    const double z_991 = cos_theta*z_988;
    const double z_992 = z_731*z_71;
    const double z_993 = z_731*z_69;
    const double z_994 = z_25*z_988;
    const double z_995 = z_731*z_75;
    const double z_996 = z_731*z_77;
    const double z_997 = z_20*z_988;
    const double z_998 = z_16*z_737;
    const double z_999 = z_22*z_731;
    const double z_1000 = sin_phi*z_43;
    const double z_1001 = z_22*z_733;
    const double z_1002 = z_16*z_731;
    const double z_1003 = sin_phi*z_677;
    const double z_1004 = z_22*z_677;
    const double z_1005 = z_16*z_43;
    const double z_1006 = z_506*z_43;
    const double z_1007 = z_504*z_677;
    const double z_1008 = sin_delta*z_501;
    const double z_1009 = z_501*z_677;
    const double z_1010 = z_506*z_731;
    const double z_1011 = z_504*z_733;
    const double z_1012 = z_501*z_43;
    const double z_1013 = z_504*z_731;
    const double z_1014 = z_506*z_737;
    D[45] = (-0.5)*(4.0*z_795*z_972 + 4.0*z_588*z_974 + 4.0*z_588*z_975 + 4.0*z_793*z_976 + 4.0*z_793*z_977 +
        4.0*z_588*z_985 + 4.0*z_793*z_991 + 4.0*z_583*z_992 + 4.0*z_583*z_994 + 4.0*z_588*z_995 + 4.0*z_588*z_996
        + 4.0*z_588*z_997 + z_523*z_999 + z_523*z_1000 + z_520*z_1001 + z_520*z_1003 + 2.0*z_510*z_161 +
        2.0*z_510*z_1005 + 2.0*z_560*z_1006 + 2.0*z_560*z_1007 + 2.0*z_1008*z_560 + z_568*z_1009 + z_571*z_1012 +
        2.0*z_826*z_601 + 2.0*z_822*z_602 + 2.0*z_823*z_602 + 2.0*z_736*z_806 + 2.0*z_738*z_806 + cos_tilt*z_630 -
        4.0*z_795*z_973 - 4.0*z_583*z_979 - 4.0*z_583*z_980 - 4.0*z_583*z_981 - 4.0*z_583*z_982 - 4.0*z_583*z_983
        - 4.0*z_588*z_984 - 4.0*z_588*z_986 - 4.0*z_795*z_987 - 4.0*z_795*z_989 - 4.0*z_793*z_990 -
        4.0*z_583*z_993 - z_523*z_998 - z_520*z_1002 - 2.0*z_510*z_1004 - z_568*z_1010 - z_568*z_1011 -
        z_571*z_1013 - z_571*z_1014 - 2.0*z_825*z_601 - 2.0*z_827*z_601 - 2.0*z_821*z_602 - 2.0*z_732*z_807 -
        2.0*z_734*z_807 - sin_tilt*z_629);
    D[46] = z_766;
    D[47] = F_yy*z_614;
    const double z_1015 = z_167 - (z_964 + z_963);
    const double z_1016 = z_136*z_564 + m_H*z_1015 - z_133*z_566;
    const double z_1017 = z_135*z_564 + m_F*z_1015 - z_132*z_566;
    const double z_1018 = z_1016 + z_1017;
    const double z_1019 = z_155*z_16 + z_152*z_22 - z_836;
    const double z_1020 = z_965 + z_1018 - z_1019;
    const double z_1021 = r_R*z_780;
    const double z_1022 = z_152*z_503 + z_155*z_505 - m_B*z_1021;
    const double z_1023 = psi_dot*z_136;
    const double z_1024 = psi_dot*z_133;
    const double z_1025 = psi_dot*m_H;
    const double z_1026 = z_564*z_1023 + z_1015*z_1025 - z_566*z_1024;
    const double z_1027 = psi_dot*z_132;
    const double z_1028 = psi_dot*z_135;
    const double z_1029 = psi_dot*m_F;
    const double z_1030 = z_566*z_1027 - z_564*z_1028 - z_1015*z_1029;
    const double z_1031 = z_1026 - z_1030;
    const double z_1032 = z_318*z_780 + z_1031 - z_1022;
    const double z_1033 = z_137*x_ddot;
    const double z_1034 = z_134*x_ddot;
    const double z_1035 = z_156*x_ddot;
    const double z_1036 = z_154*x_ddot;
    const double z_1037 = z_137*y_ddot;
    const double z_1038 = z_134*y_ddot;
    const double z_1039 = z_156*y_ddot;
    const double z_1040 = z_154*y_ddot;
    D[50] = cos_psi*(z_484*z_1020 + z_90*z_1033 + z_73*z_1034 + z_159*z_1034 + z_160*z_1033 + x_ddot*z_168 -
        y_dot*z_1032 - x_ddot*z_162 - z_16*z_1035 - z_22*z_1036) - sin_psi*(z_485*z_1020 + y_ddot*z_162 +
        z_16*z_1039 + z_22*z_1040 - x_dot*z_1032 - z_90*z_1037 - z_73*z_1038 - z_159*z_1038 - z_160*z_1037 -
        y_ddot*z_168);
    const double z_1041 = z_745*z_3;
    const double z_1042 = z_121*z_1025 + z_124*z_1029;
    const double z_1043 = z_121*z_1023 + z_124*z_1028;
    const double z_1044 = z_121*z_1024 + z_124*z_1027;
    const double z_1045 = z_155*z_128;
    const double z_1046 = z_152*z_128;
    const double g = c[3];
    const double z_1047 = z_136*g + z_135*g;
    const double z_1048 = z_133*g + z_132*g;
    const double z_1049 = sin_tilt*z_1047 - cos_tilt*z_1048;
    const double z_1050 = z_54*z_450 - z_54*z_449;
    const double z_1051 = z_456 + z_455;
    const double z_1052 = z_1050 + z_1051 + z_627;
    const double z_1053 = z_457 - z_458;
    const double z_1054 = z_37*z_452 + z_37*z_451;
    const double z_1055 = z_1053 + z_620 - z_1054;
    const double z_1056 = (r_R*z_452 + r_R*z_451) - (z_448 + (z_52*z_449 - z_52*z_450));
    const double z_1057 = z_53*z_1052 - z_H*z_1055 - z_1056;
    const double z_1058 = c_*z_1052 - r_F*z_1055 - z_1056;
    const double z_1059 = z_133*z_1057 + z_132*z_1058;
    const double z_1060 = z_155*z_252;
    const double z_1061 = z_152*z_252;
    const double z_1062 = z_448 + x_B*z_449 - x_B*z_450 - z_11*z_452 - z_11*z_451;
    const double z_1063 = z_155*z_1062;
    const double z_1064 = z_152*z_1062;
    const double z_1065 = m_H*z_1057 + m_F*z_1058;
    const double z_1066 = z_133*z_247;
    const double z_1067 = z_132*z_249;
    const double z_1068 = z_1066 + z_1067;
    const double z_1069 = z_136*z_247;
    const double z_1070 = z_135*z_249;
    const double z_1071 = z_1069 + z_1070;
    const double z_1072 = z_136*z_1057 + z_135*z_1058;
    const double z_1073 = (((z_1059*z_283 + z_86*z_1059) - (z_10*z_1060 - z_13*z_1061)) - ((z_311*z_1063 +
        z_314*z_1064) - ((z_1065 + m_B*z_1062)*z_607 - (z_760*z_251 - z_761*z_251)))) - ((((z_49*z_1068 -
        z_1068*z_762) - (z_45*z_1068 + z_1068*z_763)) + ((z_1068*z_336 + z_58*z_1071) - (z_1071*z_764 -
        z_57*z_1071))) + (((z_1071*z_765 - z_1071*z_337) + (z_1065*z_599 + z_1065*z_600)) - ((z_1072*z_285 +
        z_1072*z_286) - (z_65*z_1072 - z_1059*z_282))));
    const double z_1074 = z_152*z_30;
    const double z_1075 = z_155*z_30;
    const double z_1076 = z_86*z_188;
    const double z_1077 = z_25*z_17;
    const double z_1078 = z_54*z_1077;
    const double z_1079 = z_450*z_55;
    const double z_1080 = z_20*z_17;
    const double z_1081 = z_44*z_1080;
    const double z_1082 = z_452*z_48;
    const double z_1083 = z_451*z_48;
    const double z_1084 = z_449*z_55;
    const double z_1085 = (z_1076 - z_565*z_64) + (z_159*z_2 + z_1078 - z_1079) + (z_73*z_2 + z_1082 - z_1081) +
        (z_1076 - z_3*z_84) + (z_1078 + z_159*z_27 + z_1084) + (z_1082 + z_1083 - z_16*z_82) - (z_1081 - z_73*z_27
        - z_1083) - (z_1079 - z_1084 - z_22*z_95);
    const double z_1086 = z_65*z_188;
    const double z_1087 = z_449*z_48;
    const double z_1088 = z_44*z_1077;
    const double z_1089 = z_37*z_1080;
    const double z_1090 = z_452*z_40;
    const double z_1091 = z_450*z_48;
    const double z_1092 = z_451*z_40;
    const double z_1093 = (z_1086 - z_563*z_64) + (z_1086 - z_3*z_47) + (z_1089 + z_1092 - z_160*z_27) + (z_1090 +
        z_1092 - z_16*z_80) + (z_1087 + z_22*z_82 - z_1091) - (z_90*z_27 + z_1088 - z_1087) - (z_160*z_2 - z_1089
        - z_1090) - (z_1088 + z_90*z_2 + z_1091);
    const double z_1094 = r_R*z_1080;
    const double z_1095 = z_52*z_1077;
    const double z_1096 = z_2*z_22;
    const double z_1097 = z_27*z_16;
    const double z_1098 = z_167*z_2;
    const double z_1099 = z_27*z_22;
    const double z_1100 = ((z_334*z_16 - z_1094) + (z_1095 + z_52*z_1096)) - ((z_1094 - r_R*z_1097) + (z_1098 -
        (z_52*z_1099 + z_1095)));
    const double z_1101 = z_53*z_1085 - z_H*z_1093 - z_1100;
    const double z_1102 = c_*z_1085 - r_F*z_1093 - z_1100;
    const double z_1103 = z_133*z_1101 + z_132*z_1102;
    const double z_1104 = z_136*z_1101 + z_135*z_1102;
    const double z_1105 = z_136*z_100 + z_135*z_103;
    const double z_1106 = z_133*z_100 + z_132*z_103;
    const double z_1107 = z_117*z_133 + z_114*z_136 + m_H*z_118;
    const double z_1108 = z_117*z_132 + z_114*z_135 + m_F*z_118;
    const double z_1109 = z_1107 + z_1108;
    const double z_1110 = z_H*z_1107 + r_F*z_1108;
    const double z_1111 = z_53*z_1107 + c_*z_1108;
    const double z_1112 = z_155*z_25 + z_152*z_20 - m_B*z_107;
    const double z_1113 = z_11*z_1112;
    const double z_1114 = z_345*z_2;
    const double z_1115 = z_349*z_2;
    const double z_1116 = x_B*z_1112;
    const double z_1117 = z_1109 - z_1112;
    const double z_1118 = cos_theta*z_553 + sin_theta*z_535;
    const double z_1119 = 2.0*z_171*H_xz - z_174*z_567;
    const double z_1120 = z_1119*z_84;
    const double z_1121 = 2.0*z_174*H_xz - z_171*z_570;
    const double z_1122 = z_1121*z_47;
    const double z_1123 = (z_54*z_1119 - z_44*z_1121) + 2.0*(z_686 - 0.5*cos_theta*z_573);
    const double z_1124 = z_1123 - 2.0*z_1118*z_84;
    const double z_1125 = (z_37*z_1121 - z_44*z_1119) + 2.0*(z_692 - 0.5*sin_theta*z_577);
    const double z_1126 = z_1125 - 2.0*z_1118*z_47;
    const double z_1127 = z_53*z_1016 + c_*z_1017;
    const double z_1128 = z_H*z_1016 + r_F*z_1017;
    const double z_1129 = z_11*z_1019;
    const double z_1130 = x_B*z_1019;
    const double z_1131 = z_13 + z_962;
    const double z_1132 = cos_theta*z_86;
    const double z_1133 = sin_theta*z_65;
    const double z_1134 = z_10 + z_961;
    const double z_1135 = z_1132 + z_1133 + z_960 + z_1131*z_47 - z_1134*z_84;
    const double z_1136 = z_41 + z_49 + z_47*z_780 - z_37*z_1131 - z_44*z_1134;
    const double z_1137 = z_56 + z_58 + z_84*z_780 + z_54*z_1134 + z_44*z_1131;
    const double z_1138 = 2.0*H_xz*z_1136 - z_567*z_1137;
    const double z_1139 = 2.0*H_xz*z_1137 - z_570*z_1136;
    const double z_1140 = z_1119*z_55 + z_1121*z_48 + 2.0*z_86*z_1118 + 2.0*z_1135*z_553 + z_54*z_1138 -
        2.0*B_xz*z_1131 - z_44*z_1139 - z_573*z_1134;
    const double z_1141 = z_1121*z_40 + z_1119*z_48 + 2.0*z_65*z_1118 + 2.0*B_xz*z_1134 + 2.0*z_1135*z_535 +
        z_37*z_1139 + z_577*z_1131 - z_44*z_1138;
    const double z_1142 = r_F*lambda_4;
    const double z_1143 = c_*lambda_4;
    const double z_1144 = sin_tilt*r_F - c_*cos_tilt;
    const double z_1145 = sin_delta*z_1144;
    const double z_1146 = z_1145 + cos_delta*z_645;
    const double lambda_0 = lambda[0];
    const double z_1147 = z_588*psi_ddot;
    const double z_1148 = z_583*psi_ddot;
    const double z_1149 = z_482*psi_ddot;
    const double z_1150 = r_R*psi_ddot;
    const double z_1151 = B_xz*psi_ddot;
    const double z_1152 = z_172*lambda_4 - z_173*lambda_4;
    const double z_1153 = z_170*lambda_4 - z_169*lambda_4;
    const double z_1154 = cos_theta*z_698 + sin_theta*z_699;
    const double z_1155 = lambda_0*z_644;
    const double z_1156 = lambda_0*z_705;
    const double z_1157 = z_1152*z_695 + z_656*z_1155 + z_636*(z_1152*z_707 + z_1152*z_708 + z_1154*z_649 +
        z_656*z_1156 - z_1153*z_709 - z_1153*z_710 - z_1154*z_712 - z_655*z_1156 - z_143*z_1156) + z_688*z_535 +
        z_682*z_553 - z_1153*z_697 - 2.0*z_1154*z_646 - z_655*z_1155 - z_143*z_1155;
    const double z_1158 = z_170*psi_ddot;
    const double z_1159 = z_169*psi_ddot - z_1158;
    const double z_1160 = z_173*psi_ddot;
    const double z_1161 = z_1160 - z_172*psi_ddot;
    const double z_1162 = 2.0*z_1153*z_646 + z_570*z_1159 + 2.0*H_xz*z_1161;
    const double z_1163 = 2.0*z_1152*z_646 + 2.0*H_xz*z_1159 + z_567*z_1161;
    const double z_1164 = y_ddot*z_369;
    const double z_1165 = y_ddot*z_371;
    const double z_1166 = cos_theta*y_ddot;
    const double z_1167 = sin_theta*y_ddot;
    const double z_1168 = x_ddot*z_278;
    const double z_1169 = x_ddot*z_275;
    const double z_1170 = cos_theta*x_ddot;
    const double z_1171 = sin_theta*x_ddot;
    const double z_1172 = psi_dot*z_H;
    const double z_1173 = psi_dot*r_F;
    const double z_1174 = z_1026*z_1172 - z_1030*z_1173;
    const double z_1175 = psi_dot*z_53;
    const double z_1176 = psi_dot*c_;
    const double z_1177 = z_1026*z_1175 - z_1030*z_1176;
    const double z_1178 = m_H*g + m_F*g;
    const double z_1179 = z_155*g + r_R*z_1178;
    const double z_1180 = z_152*g + z_52*z_1178;
    const double z_1181 = (((z_45*z_1059 + z_1059*z_763) + (z_311*z_1060 + z_314*z_1061)) - ((z_254*z_607 +
        z_10*z_1063) - (z_13*z_1064 + (z_251*z_599 + z_251*z_600)))) - ((((z_1068*z_282 + z_1068*z_283) +
        (z_1068*z_86 + z_1071*z_285)) + ((z_1071*z_286 - z_1071*z_65) + (z_760*z_1065 - z_761*z_1065))) +
        (((z_58*z_1072 - z_1072*z_764) - (z_1072*z_337 - z_57*z_1072)) + ((z_1072*z_765 + z_49*z_1059) -
        (z_1059*z_762 - z_1059*z_336))));
    const double z_1182 = m_H*z_1101 + m_F*z_1102;
    const double z_1183 = x_B*z_1077;
    const double z_1184 = z_2*z_16;
    const double z_1185 = z_11*z_1080;
    const double z_1186 = z_1098 + (z_1185 - z_11*z_1097) - (x_B*z_1099 + z_1183) - (z_1183 + x_B*z_1096) -
        (z_11*z_1184 - z_1185);
    const double z_1187 = z_152*z_1186;
    const double z_1188 = z_155*z_1186;
    const double z_1189 = R_yy*z_780;
    const double z_1190 = z_1189 + 0.5*(z_1119*z_86 + z_1121*z_65 + 2.0*B_yy*z_780 + 2.0*z_1135*z_559 -
        2.0*z_39*z_1118 - z_1138*z_84 - z_1139*z_47);
    const double z_1191 = 2.0*z_1190;
    const double z_1192 = z_344 + z_342;
    const double z_1193 = r_R - z_1192;
    const double z_1194 = c_*z_261 + c_*z_170 + r_F*z_263 + r_F*z_173 + z_645*z_723 + z_1193 - z_645*z_722;
    const double z_1195 = sin_delta*y_ddot;
    const double z_1196 = sin_delta*x_ddot;
    const double z_1197 = psi_dot*z_1026 - psi_dot*z_1030;
    const double z_1198 = z_11*z_1022;
    const double z_1199 = x_B*z_1022;
    D[51] = (-0.5)*(sin_phi*(4.0*z_1041 + 2.0*r_R*z_106 + 2.0*z_1103*z_84 + 2.0*z_263*z_1105 + 2.0*z_173*z_1105 +
        2.0*z_261*z_1106 + 2.0*z_170*z_1106 + 2.0*z_1110*z_757 + 2.0*z_1110*z_333 + 2.0*z_1110*z_331 +
        2.0*z_1110*z_332 + 2.0*z_229*z_1110 + 2.0*z_1111*z_754 + 4.0*z_1111*z_755 + 2.0*z_1111*z_328 +
        4.0*z_225*z_1111 + 2.0*z_224*z_1111 + 2.0*z_1111*z_329 + 2.0*z_1111*z_330 + 4.0*z_1111*z_756 +
        2.0*z_196*z_1113 + 2.0*z_1112*z_1114 + 2.0*z_1112*z_1115 + 2.0*z_197*z_1116 + 2.0*z_334*z_1117 +
        z_1124*z_576 + z_1126*z_580 + 4.0*z_582*z_1018 + 4.0*z_1127*z_585 + 4.0*z_1127*z_277 + 2.0*z_1128*z_589 +
        4.0*z_1128*z_590 + 4.0*z_1128*z_279 + 2.0*z_1128*z_592 + 4.0*z_308*z_1130 + z_1141*z_634 +
        2.0*z_342*lambda_4 + 2.0*z_344*lambda_4 + 2.0*z_1146*lambda_0 + 2.0*z_593*z_682 + 2.0*z_594*z_688 +
        2.0*z_342*z_1149 + 2.0*z_344*z_1149 + 2.0*sin_theta*sin_theta*z_1151 + 2.0*z_1157*z_722 + z_173*z_1162 +
        z_263*z_1162 + z_170*z_1163 + z_261*z_1163 + 2.0*z_389*z_1166 + 2.0*z_405*z_1167 + 2.0*z_173*z_1168 +
        2.0*z_170*z_1169 + 2.0*z_261*z_1169 + 2.0*z_263*z_1168 + 2.0*r_R*x_ddot*z_298 + 2.0*z_1174*z_47 +
        2.0*z_1073 - (2.0*z_1041 + 2.0*psi_dot*z_558 + psi_dot*z_524 + 2.0*z_173*z_1043 + 2.0*z_263*z_1043 +
        2.0*z_170*z_1044 + 2.0*z_261*z_1044 + 2.0*r_R*(psi_dot*z_129 + z_1042) + 2.0*z_1073 - 2.0*z_342*z_1042 -
        2.0*z_344*z_1042 - 2.0*z_634*z_1045 - 2.0*z_632*z_1046 - 2.0*sin_delta*z_1049) - 2.0*sin_theta*z_1074 -
        2.0*cos_theta*z_1075 - 2.0*z_1104*z_47 - 2.0*z_344*z_105 - 2.0*z_342*z_105 - 2.0*z_750*z_1109 -
        2.0*z_752*z_1109 - 2.0*z_753*z_1109 - 2.0*z_751*z_1109 - 2.0*z_231*z_1110 - 4.0*z_1110*z_758 -
        4.0*z_230*z_1110 - 4.0*z_1110*z_759 - 2.0*z_226*z_1111 - 2.0*z_1118*z_562 - z_561*z_1120 - z_561*z_1122 -
        4.0*z_581*z_1018 - 2.0*z_1127*z_584 - 4.0*z_1127*z_276 - 4.0*z_1127*z_586 - 2.0*z_1127*z_587 -
        4.0*z_1128*z_591 - 4.0*z_1128*z_280 - 4.0*z_309*z_1129 - z_1140*z_632 - 2.0*z_173*z_1142 -
        2.0*z_263*z_1142 - 2.0*z_170*z_1143 - 2.0*z_261*z_1143 - 2.0*r_R*lambda_4 - 2.0*z_173*z_1147 -
        2.0*z_170*z_1148 - 2.0*z_261*z_1148 - 2.0*z_263*z_1147 - 2.0*z_483*z_1150 - 2.0*cos_theta*cos_theta*z_1151
        - 2.0*z_1157*z_723 - 2.0*z_173*z_1164 - 2.0*z_170*z_1165 - 2.0*z_261*z_1165 - 2.0*z_263*z_1164 -
        2.0*r_R*y_ddot*z_475 - 2.0*z_294*z_1170 - 2.0*z_296*z_1171 - 2.0*z_1177*z_84 - cos_theta*(z_573 -
        z_577)*z_688) + cos_phi*(2.0*sin_theta*z_1187 + 2.0*cos_theta*z_1188 + 2.0*z_344*z_1182 + 2.0*z_342*z_1182
        + 2.0*z_1106*z_84 + 4.0*z_581*z_1109 + 4.0*z_1110*z_591 + 4.0*z_1110*z_280 + 2.0*z_1111*z_584 +
        4.0*z_1111*z_276 + 4.0*z_1111*z_586 + 2.0*z_1111*z_587 + 4.0*z_309*z_1113 + z_1124*z_748 +
        2.0*z_1127*z_754 + 4.0*z_225*z_1127 + 2.0*z_224*z_1127 + 4.0*z_1127*z_755 + 2.0*z_1127*z_328 +
        2.0*z_1127*z_329 + 2.0*z_1127*z_330 + 4.0*z_1127*z_756 + 2.0*z_1128*z_757 + 2.0*z_229*z_1128 +
        2.0*z_1128*z_331 + 2.0*z_1128*z_332 + 2.0*z_1128*z_333 + 2.0*z_196*z_1129 + 2.0*z_197*z_1130 +
        2.0*z_1019*z_1114 + 2.0*z_1019*z_1115 + 2.0*z_334*z_1020 + 2.0*cos_phi*z_745*z_299 + psi_dot*z_1191 +
        2.0*z_1145*lambda_4 + 2.0*z_1194*lambda_0 + 2.0*z_47*z_1147 + 2.0*cos_delta*z_1157 + z_1163*z_84 +
        2.0*z_288*z_1196 + 2.0*z_173*z_1174 + 2.0*z_263*z_1174 + 2.0*z_170*z_1177 + 2.0*z_261*z_1177 +
        2.0*z_634*z_1198 + 2.0*z_632*z_1199 + 2.0*r_R*(z_1197 - psi_dot*z_1022) + 2.0*z_1181 - (z_557*z_632 +
        2.0*z_1044*z_84 + 2.0*cos_theta*z_1179 + 2.0*sin_theta*z_1180 + 2.0*z_1181 - z_551*z_634 - 2.0*z_318*g -
        2.0*r_R*(m_B*g + z_1178) - 2.0*z_173*z_1047 - 2.0*z_263*z_1047 - 2.0*z_170*z_1048 - 2.0*z_261*z_1048 -
        2.0*z_1043*z_47) - 2.0*r_R*(z_1182 + m_B*z_1186) - 2.0*z_261*z_1103 - 2.0*z_170*z_1103 - 2.0*z_263*z_1104
        - 2.0*z_173*z_1104 - 2.0*z_1105*z_47 - 2.0*z_745*z_431 - 4.0*z_582*z_1109 - 4.0*z_1110*z_590 -
        4.0*z_1110*z_279 - 2.0*z_1110*z_589 - 2.0*z_1110*z_592 - 4.0*z_1111*z_585 - 4.0*z_1111*z_277 -
        4.0*z_308*z_1116 - z_1126*z_749 - 2.0*z_750*z_1018 - 2.0*z_751*z_1018 - 2.0*z_752*z_1018 -
        2.0*z_753*z_1018 - 2.0*z_226*z_1127 - 2.0*z_231*z_1128 - 4.0*z_230*z_1128 - 4.0*z_1128*z_758 -
        4.0*z_1128*z_759 - 2.0*z_84*z_1148 - z_1162*z_47 - 2.0*z_474*z_1195 - 2.0*z_342*z_1197 -
        2.0*z_344*z_1197));
    const double z_1200 = z_167*z_27;
    const double z_1201 = z_17*z_418;
    const double z_1202 = cos_phi*z_80;
    const double z_1203 = z_27*z_391;
    const double z_1204 = z_1110*z_40;
    const double z_1205 = z_2*z_391;
    const double z_1206 = z_17*z_360;
    const double z_1207 = z_48*z_779;
    const double z_1208 = cos_phi*z_82;
    const double z_1209 = z_1111*z_55;
    const double z_1210 = z_27*z_365;
    const double z_1211 = z_48*z_66;
    const double z_1212 = z_2*z_365;
    const double z_1213 = z_17*z_385;
    const double z_1214 = cos_phi*z_27;
    const double z_1215 = sin_phi*z_17;
    const double z_1216 = r_R*z_1018;
    const double z_1217 = z_37*z_1128;
    const double z_1218 = psi_dot*z_1016 + psi_dot*z_1017 + z_1031;
    const double z_1219 = (z_1016*z_1172 + z_1017*z_1173) + (z_H*z_1026 - r_F*z_1030);
    const double z_1220 = (z_1016*z_1175 + z_1017*z_1176) + (z_53*z_1026 - c_*z_1030);
    const double z_1221 = psi_dot*z_1019 + z_1022;
    const double z_1222 = lambda_0*z_645;
    const double z_1223 = r_F*lambda_0;
    const double z_1224 = c_*lambda_0;
    const double z_1225 = sin_tilt*z_H - cos_tilt*z_53;
    const double z_1226 = z_135*z_1144 + z_136*z_1225;
    const double z_1227 = z_132*z_1144 + z_133*z_1225;
    const double z_1228 = z_1226*z_36 - z_42*z_1227;
    const double z_1229 = sin_delta*sin_delta;
    const double z_1230 = delta_ddot*z_1229;
    const double z_1231 = sin_delta*theta_ddot;
    const double z_1232 = m_F*z_1144 + m_H*z_1225;
    const double z_1233 = z_52*z_1232;
    const double z_1234 = sin_delta*z_145;
    const double z_1235 = z_54*z_1227;
    const double z_1236 = (r_R - z_349 - z_345)*phi_ddot;
    const double z_1237 = z_170 + z_261;
    const double z_1238 = z_173 + z_263;
    const double z_1239 = c_*z_1237 + r_F*z_1238 + z_1193;
    const double z_1240 = z_H*z_1238 + z_53*z_1237 + z_1193;
    const double z_1241 = m_F*z_1239 + m_H*z_1240;
    const double z_1242 = z_132*z_1239 + z_133*z_1240;
    const double z_1243 = z_1242*phi_ddot;
    const double z_1244 = z_135*z_1239 + z_136*z_1240;
    const double z_1245 = z_1244*phi_ddot;
    const double z_1246 = theta_ddot*z_559;
    const double z_1247 = z_693 + z_1152*z_670 + z_1246 - z_1153*z_668 - z_1154*z_675 - z_1154*z_640 - z_293*z_553
        - z_295*z_535;
    const double z_1248 = delta_ddot*z_677 + z_290 + z_291;
    const double z_1249 = delta_ddot*z_43 - z_289 - z_292;
    const double z_1250 = (z_342*phi_ddot + z_344*phi_ddot) - z_297;
    const double z_1251 = z_133*z_1248 - z_136*z_1249 - m_H*z_1250;
    const double z_1252 = z_132*z_1248 - z_135*z_1249 - m_F*z_1250;
    const double z_1253 = sin_phi*lambda_0 - z_1251 - z_1252;
    const double z_1254 = z_H*z_1251 + r_F*z_1252;
    const double z_1255 = z_155*z_293 + z_152*z_295 - m_B*z_297;
    const double z_1256 = cos_phi*y_ddot;
    const double z_1257 = cos_phi*x_ddot;
    const double z_1258 = z_726 + z_289 - theta_ddot*z_84 - z_172*phi_ddot;
    const double z_1259 = z_724 + theta_ddot*z_47 + z_169*phi_ddot - z_290;
    const double z_1260 = z_563*psi_ddot + z_90*psi_ddot + z_160*psi_ddot;
    const double z_1261 = z_73*psi_ddot + z_159*psi_ddot - z_565*psi_ddot;
    const double z_1262 = (z_963*psi_ddot + z_1150*z_16) - z_167*psi_ddot;
    const double z_1263 = z_136*z_1260 + z_133*z_1261 - m_H*z_1262;
    const double z_1264 = z_135*z_1260 + z_132*z_1261 - m_F*z_1262;
    const double z_1265 = 2.0*z_1152*z_640 + 2.0*z_53*z_1263 + 2.0*c_*z_1264 - z_567*z_1258 - 2.0*H_xz*z_1259;
    const double z_1266 = z_1263 + z_1264;
    const double z_1267 = z_53*z_1251 + c_*z_1252;
    const double z_1268 = 2.0*z_1153*z_640 + 2.0*z_H*z_1263 + 2.0*r_F*z_1264 - 2.0*H_xz*z_1258 - z_570*z_1259;
    const double z_1269 = 2.0*z_1267 + z_1268;
    const double z_1270 = z_155*z_683 + z_152*z_689 - psi_ddot*z_836;
    const double z_1271 = z_783*z_2;
    const double z_1272 = z_107*z_17;
    const double z_1273 = z_783*z_27;
    const double z_1274 = z_17*z_400;
    const double z_1275 = cos_phi*z_95;
    const double z_1276 = z_27*z_363;
    const double z_1277 = z_2*z_363;
    const double z_1278 = z_52*z_1018;
    const double z_1279 = z_54*z_1127;
    const double z_1280 = z_1227*z_33 - z_42*z_1226;
    const double z_1281 = z_37*z_1226;
    const double z_1282 = r_R*z_1232;
    const double z_1283 = 2.0*z_1254 - z_1265;
    D[52] = 0.5*(sin_theta*(z_555 + theta_dot*z_551 + 2.0*sin_phi*z_1188 + 2.0*cos_phi*z_1075 + 2.0*z_107*z_1182 +
        2.0*z_167*z_105 + 2.0*z_1109*z_1200 + 2.0*z_1098*z_1109 + 4.0*z_1109*z_1201 + 4.0*z_66*z_1204 +
        4.0*z_1110*z_1207 + 2.0*z_1111*z_1208 + 4.0*z_784*z_1018 + 2.0*z_1127*z_361 + 4.0*z_1127*z_786 +
        2.0*z_1127*z_362 + 2.0*z_1128*z_788 + 4.0*z_1128*z_790 + 2.0*z_3*z_1217 + 2.0*z_368*z_1217 +
        2.0*z_368*z_1129 + 2.0*z_3*z_1129 + z_1126*z_17 + 2.0*z_1044*z_365 + 2.0*z_1043*z_391 + 2.0*z_1048*z_360 +
        2.0*z_1047*z_400 + z_500*z_551 + 2.0*z_1219*z_379 + 2.0*z_1220*z_55 + 2.0*z_1220*z_381 + 2.0*z_1221*z_809
        + 2.0*z_391*z_1142 + 2.0*z_365*z_1143 + 2.0*z_400*z_1223 + 2.0*z_360*z_1224 + 2.0*z_1228*z_1230 +
        2.0*z_1231*z_1233 + 2.0*z_155*z_1236 + 2.0*z_1241*z_297 + (z_1123 - 2.0*z_643*z_553)*phi_ddot +
        2.0*z_1247*z_84 + 2.0*B_xz*z_295 + 2.0*z_365*z_1148 + 2.0*z_391*z_1147 + z_687*psi_ddot + 2.0*z_16*z_1151
        + 2.0*z_365*z_1165 + 2.0*z_391*z_1164 + 2.0*z_294*z_1257 + 2.0*z_52*z_1266 + 2.0*z_1174*z_400 +
        2.0*z_1177*z_360 + 2.0*z_500*z_1198 - 2.0*z_1103*z_360 - 2.0*z_1104*z_400 - 2.0*z_1105*z_391 -
        2.0*z_1106*z_365 - 2.0*z_1110*z_1202 - 2.0*z_1110*z_1203 - 2.0*z_1110*z_1205 - 4.0*z_1110*z_1206 -
        4.0*z_779*z_1209 - 2.0*z_1111*z_1210 - 4.0*z_1111*z_1211 - 2.0*z_1111*z_1212 - 4.0*z_1111*z_1213 -
        2.0*z_1113*z_1214 - 2.0*z_431*z_1113 - 4.0*z_1116*z_1215 - z_1124*z_781 - z_1126*z_747 - 2.0*z_368*z_1216
        - 2.0*z_3*z_1216 - 2.0*z_1127*z_785 - 4.0*z_1127*z_787 - 4.0*z_1127*z_364 - 4.0*z_1128*z_789 -
        4.0*z_1128*z_366 - 4.0*z_402*z_1130 - 2.0*z_780*z_1045 - 2.0*sin_phi*z_1179 - 2.0*z_167*z_1042 -
        2.0*z_1218*z_805 - 2.0*z_1219*z_48 - phi_dot*z_1140 - z_1141*z_780 - 2.0*z_167*lambda_4 - 2.0*z_652 -
        2.0*z_563*z_1222 - 2.0*z_1226*z_1234 - 2.0*z_1231*z_1235 - 2.0*z_44*z_1243 - 2.0*z_37*z_1245 - z_573*z_293
        - 2.0*r_R*z_1253 - 2.0*z_37*z_1254 - 2.0*z_11*z_1255 - 2.0*z_593*z_819 - 2.0*z_167*z_1149 - z_577*z_689 -
        2.0*z_63*z_1157 - z_1162*z_391 - z_1163*z_365 - 2.0*z_389*z_1256 - 2.0*z_365*z_1169 - 2.0*z_391*z_1168 -
        z_54*z_1265 - z_44*z_1269 - 2.0*x_B*z_1270 - 2.0*z_107*z_1197) + cos_theta*(z_549 + theta_dot*z_557 +
        2.0*z_1103*z_385 + 2.0*z_1104*z_360 + 2.0*z_1105*z_365 + 2.0*z_1106*z_363 + 4.0*z_1109*z_1272 +
        4.0*z_1110*z_1211 + 2.0*z_1110*z_1212 + 2.0*z_1110*z_1210 + 2.0*z_1111*z_1275 + 2.0*z_1111*z_1276 +
        4.0*z_1111*z_1207 + 2.0*z_1111*z_1277 + 2.0*z_431*z_1116 + 2.0*z_1116*z_1214 + z_1126*z_781 +
        2.0*z_368*z_1278 + 2.0*z_3*z_1278 + 4.0*z_839*z_1018 + 2.0*z_1128*z_785 + 4.0*z_1128*z_787 +
        4.0*z_1128*z_843 + z_1124*z_17 + 2.0*z_780*z_1046 + 2.0*sin_phi*z_1180 + 2.0*z_783*z_1042 + z_500*z_557 +
        2.0*z_1218*z_850 + 2.0*z_1219*z_40 + phi_dot*z_1141 + 2.0*z_783*lambda_4 + 2.0*z_654 + 2.0*z_1231*z_1282 +
        2.0*z_44*z_1245 + 2.0*z_54*z_1243 + z_577*z_295 + 2.0*z_52*z_1253 + 2.0*z_54*z_1267 + 2.0*x_B*z_1255 +
        2.0*z_594*z_819 + 2.0*z_783*z_1149 + z_681*psi_ddot + 2.0*z_22*z_1151 + z_1162*z_365 + z_1163*z_363 +
        2.0*z_405*z_1256 + 2.0*z_365*z_1168 + 2.0*z_363*z_1169 + 2.0*r_R*z_1266 + z_44*z_1283 + 2.0*z_1197*z_418 -
        2.0*sin_phi*z_1187 - 2.0*cos_phi*z_1074 - 2.0*z_1182*z_418 - 2.0*z_783*z_105 - 2.0*z_1109*z_1271 -
        2.0*z_1109*z_1273 - 2.0*z_1110*z_1208 - 4.0*z_779*z_1204 - 4.0*z_1110*z_1274 - 4.0*z_1111*z_1206 -
        4.0*z_66*z_1209 - 4.0*z_1113*z_1215 - z_1124*z_747 - 2.0*z_1127*z_840 - 4.0*z_1127*z_789 -
        2.0*z_368*z_1279 - 4.0*z_1127*z_366 - 2.0*z_3*z_1279 - 4.0*z_1127*z_842 - 2.0*z_1128*z_361 -
        2.0*z_1128*z_362 - 4.0*z_1128*z_412 - 2.0*z_368*z_1130 - 4.0*z_402*z_1129 - 2.0*z_3*z_1130 -
        2.0*z_1044*z_363 - 2.0*z_1043*z_365 - 2.0*z_1048*z_385 - 2.0*z_1047*z_360 - 2.0*z_1219*z_381 -
        2.0*z_1220*z_48 - 2.0*z_1220*z_415 - 2.0*z_1221*z_851 - z_1140*z_780 - 2.0*z_365*z_1142 - 2.0*z_363*z_1143
        - 2.0*z_565*z_1222 - 2.0*z_360*z_1223 - 2.0*z_385*z_1224 - 2.0*z_1280*z_1230 - 2.0*z_1227*z_1234 -
        2.0*z_1231*z_1281 - 2.0*z_152*z_1236 - 2.0*z_52*z_1241*phi_ddot - 2.0*B_xz*z_293 - (z_1125 -
        2.0*z_643*z_535)*phi_ddot - 2.0*z_1247*z_47 - 2.0*z_365*z_1147 - 2.0*z_363*z_1148 - z_573*z_683 -
        2.0*z_85*z_1157 - 2.0*z_365*z_1164 - 2.0*z_363*z_1165 - 2.0*z_296*z_1257 - z_37*z_1268 - 2.0*z_11*z_1270 -
        2.0*z_1174*z_360 - 2.0*z_1177*z_385 - 2.0*z_500*z_1199));
    const double z_1284 = z_451*z_856;
    const double z_1285 = z_450*z_858;
    const double z_1286 = z_452*z_856;
    const double z_1287 = z_449*z_858;
    const double z_1288 = sin_tilt*z_3;
    const double z_1289 = z_64*z_860;
    const double z_1290 = z_449*z_861;
    const double z_1291 = z_451*z_858;
    const double z_1292 = cos_tilt*z_3;
    const double z_1293 = z_452*z_858;
    const double z_1294 = z_450*z_861;
    const double z_1295 = sin_phi*z_81;
    const double z_1296 = cos_tilt*z_1119;
    const double z_1297 = sin_tilt*z_1121;
    const double z_1298 = sin_phi*z_1144;
    const double z_1299 = cos_tilt*lambda_4;
    const double z_1300 = sin_tilt*lambda_4;
    const double z_1301 = cos_phi*z_1144;
    const double z_1302 = z_175*z_1232;
    const double z_1303 = z_176*z_1232;
    const double z_1304 = sin_phi*y_ddot;
    const double z_1305 = sin_phi*x_ddot;
    const double z_1306 = z_22*z_942;
    const double z_1307 = z_16*z_948;
    const double z_1308 = z_516*z_188;
    const double z_1309 = z_16*z_942;
    const double z_1310 = z_22*z_944;
    const double z_1311 = z_46*z_188;
    const double z_1312 = cos_theta*z_46;
    const double z_1313 = sin_theta*z_516;
    const double z_1314 = z_534*z_643;
    const double z_1315 = z_1226*theta_ddot;
    const double z_1316 = z_1227*theta_ddot;
    D[53] = 0.5*(cos_delta*(2.0*z_1103*z_429 + 2.0*z_1105*z_860 + 4.0*z_1110*z_1285 + 2.0*z_1110*z_1288 +
        2.0*z_1110*z_1289 + 4.0*z_1111*z_1290 + 4.0*z_1111*z_1291 + 4.0*z_1111*z_1293 + z_523*z_905 + z_523*z_904
        + z_520*z_907 + z_520*z_906 + 2.0*cos_theta*z_533*z_910 + 2.0*sin_theta*z_533*z_908 + 2.0*z_1118*z_869 +
        2.0*z_1118*z_871 + z_1119*z_873 + z_1119*z_874 + z_1121*z_876 + z_1121*z_877 + 4.0*z_1127*z_881 +
        4.0*z_1128*z_884 + 2.0*z_1128*z_885 + 4.0*z_1128*z_886 + 4.0*z_1128*z_888 + 2.0*z_1128*z_889 +
        2.0*cos_phi*z_1049 + 2.0*z_1044*z_864 + sin_tilt*z_523*z_780 + cos_tilt*z_520*z_780 + 2.0*z_1134*z_896 +
        2.0*z_1219*z_904 + 2.0*z_1219*z_905 + 2.0*z_1135*z_909 + 2.0*z_1135*z_911 + z_1138*z_912 + z_1139*z_913 +
        2.0*cos_theta*z_650*z_1299 + 2.0*sin_theta*z_650*z_1300 + 2.0*z_1222*z_921 + 2.0*lambda_0*z_1301 +
        2.0*z_1226*z_260 + 2.0*z_1227*z_339 + 2.0*theta_ddot*z_1303 + 2.0*z_643*z_293*z_910 +
        2.0*z_643*z_295*z_908 + 2.0*z_1148*z_864 + 2.0*z_1157*z_868 + z_1162*z_860 + 2.0*z_474*z_1304 +
        2.0*z_1174*z_428 - 2.0*z_1104*z_428 - 2.0*z_1106*z_864 - 4.0*z_1110*z_1284 - 4.0*z_1110*z_1286 -
        4.0*z_1110*z_1287 - 2.0*z_1111*z_1292 - 4.0*z_1111*z_1294 - 2.0*z_1111*z_1295 - 2.0*z_1118*z_870 -
        z_189*z_1296 - z_189*z_1297 - 4.0*z_1127*z_878 - 2.0*z_1127*z_879 - 4.0*z_1127*z_880 - 4.0*z_1127*z_882 -
        2.0*z_1127*z_883 - 4.0*z_1128*z_887 - 2.0*z_1043*z_860 - 2.0*z_1131*z_897 - 2.0*z_1220*z_906 -
        2.0*z_1220*z_907 - 2.0*z_1298*lambda_4 - 2.0*z_1222*z_920 - 4.0*z_1280*z_256 - 4.0*z_1228*z_258 -
        2.0*z_1227*z_259 - 2.0*z_1226*z_338 - 2.0*theta_ddot*z_1302 - theta_ddot*z_1297 - theta_ddot*z_1296 -
        2.0*z_1247*z_922 - 2.0*z_1247*z_923 - 4.0*(cos_tilt*z_1227 - sin_tilt*z_1226)*z_340 - 2.0*z_1147*z_860 -
        2.0*z_688*z_932 - 2.0*z_682*z_933 - 2.0*z_1157*z_867 - z_1163*z_864 - 2.0*z_288*z_1305 - 2.0*z_1177*z_429)
        + sin_delta*(2.0*z_1110*z_1306 + 4.0*z_1110*z_1308 + 2.0*z_1111*z_1309 + 2.0*z_510*z_1312 +
        2.0*z_510*z_1313 + 2.0*z_189*z_1118 + z_1119*z_940 + z_1121*z_941 + 2.0*z_1127*z_945 + 4.0*z_1127*z_946 +
        2.0*z_1128*z_949 + 2.0*z_510*z_780 + 2.0*z_1135*z_957 + 2.0*z_1244*z_726 + 2.0*theta_ddot*z_1314 +
        2.0*sin_phi*z_1157 + z_42*(2.0*z_1103*z_25 + 2.0*z_1104*z_20 + 2.0*z_1105*z_22 + 2.0*z_1106*z_16 +
        2.0*z_1110*z_1096 + 4.0*z_1110*z_1077 + 2.0*z_1110*z_1099 + 2.0*z_1111*z_1097 + 2.0*z_1111*z_1184 +
        z_1119*z_529 + 4.0*z_1128*z_18 + z_520*z_1131 + 2.0*z_257*z_1315 + 2.0*z_1244*z_295 + 2.0*z_1242*z_293 +
        z_1121*z_293 + z_1119*z_295 + z_568*z_688 + z_571*z_682 + z_1162*z_22 + z_1163*z_16 + 2.0*z_22*z_1168 +
        2.0*z_16*z_1169 + sin_theta*z_1283 + cos_theta*z_1269 - 4.0*z_1111*z_1080 - cos_theta*z_547 -
        sin_theta*z_545 - z_1121*z_526 - 2.0*z_1127*z_29 - 2.0*z_1127*z_26 - 4.0*z_1127*z_23 - 2.0*z_1128*z_28 -
        2.0*z_1128*z_21 - 2.0*z_1044*z_16 - 2.0*z_1043*z_22 - 2.0*z_1048*z_25 - 2.0*z_1047*z_20 - z_523*z_1134 -
        2.0*z_10*z_1219 - 2.0*z_13*z_1220 - z_506*z_1138 - z_504*z_1139 - 2.0*z_22*z_1142 - 2.0*z_16*z_1143 -
        2.0*cos_theta*z_916 - 2.0*sin_theta*z_915 - 2.0*z_20*z_1223 - 2.0*z_25*z_1224 - 2.0*z_255*z_1316 -
        2.0*z_22*z_1147 - 2.0*z_16*z_1148 - 2.0*z_22*z_1164 - 2.0*z_16*z_1165 - 2.0*z_1174*z_20 - 2.0*z_1177*z_25)
        - 2.0*z_1110*z_1307 - 2.0*z_1111*z_1310 - 4.0*z_1111*z_1311 - 2.0*z_1118*z_938 - 2.0*z_1118*z_939 -
        2.0*z_1127*z_943 - 2.0*z_1128*z_947 - 4.0*z_1128*z_950 - 2.0*cos_phi*z_1222 - 2.0*z_1242*z_724 -
        (2.0*z_1104*z_25 + 2.0*z_1105*z_16 + 2.0*z_1110*z_1097 + 2.0*z_1110*z_1184 + sin_theta*z_547 +
        z_506*z_1139 + 2.0*sin_theta*z_916 + 2.0*z_1244*z_293 + 2.0*cos_theta*z_1254 + z_1162*z_16 +
        2.0*z_16*z_1168 - 4.0*z_1110*z_1080 - z_1121*z_529 - 2.0*z_1128*z_26 - 2.0*z_1128*z_29 - 4.0*z_1128*z_23 -
        2.0*z_1043*z_16 - 2.0*z_1047*z_25 - z_523*z_1131 - 2.0*z_13*z_1219 - 2.0*z_16*z_1142 - 2.0*z_25*z_1223 -
        2.0*z_255*z_1315 - z_1121*z_295 - 2.0*z_16*z_1147 - z_571*z_688 - 2.0*z_16*z_1164 - sin_theta*z_1268 -
        2.0*z_1174*z_25)*z_36 - (2.0*z_1103*z_20 + 2.0*z_1106*z_22 + 2.0*z_1111*z_1099 + 4.0*z_1111*z_1077 +
        2.0*z_1111*z_1096 + cos_theta*z_545 + z_1119*z_526 + 4.0*z_1127*z_18 + z_520*z_1134 + z_504*z_1138 +
        2.0*cos_theta*z_915 + 2.0*z_257*z_1316 + 2.0*z_1242*z_295 + 2.0*sin_theta*z_1267 + z_1163*z_22 +
        2.0*z_22*z_1169 + cos_theta*z_1265 - 2.0*z_1127*z_28 - 2.0*z_1127*z_21 - 2.0*z_1044*z_22 - 2.0*z_1048*z_20
        - 2.0*z_10*z_1220 - 2.0*z_22*z_1143 - 2.0*z_20*z_1224 - z_1119*z_293 - 2.0*z_22*z_1148 - z_568*z_682 -
        2.0*z_22*z_1165 - 2.0*z_1177*z_20)*z_33));
    D[56] = z_5*z_1020 - cos_psi*z_1032;
    D[57] = z_7*z_1020 - sin_psi*z_1032;
    const double z_1317 = sin_phi*z_745;
    const double z_1318 = z_132*z_124;
    const double z_1319 = z_135*z_124;
    const double z_1320 = z_136*z_121;
    const double z_1321 = z_133*z_121;
    D[58] = (-0.5)*(2.0*z_780*z_1317 + 2.0*z_609*z_1118 + z_1119*z_623 + z_1121*z_616 + z_450*z_1124 +
        2.0*z_14*z_1019 + 2.0*z_564*z_1319 + 2.0*z_564*z_1320 + 2.0*z_128*z_836 + 2.0*z_125*z_1015 +
        2.0*z_122*z_1015 + 2.0*z_119*z_1026 + z_1140*z_22 + sin_phi*z_1191 + z_966 - z_449*z_1124 - z_452*z_1126 -
        z_451*z_1126 - 2.0*z_62*z_1016 - 2.0*z_102*z_1017 - 2.0*z_22*z_1046 - 2.0*z_16*z_1045 - 2.0*z_566*z_1318 -
        2.0*z_566*z_1321 - 2.0*z_109*z_1020 - 2.0*z_108*z_1020 - 2.0*z_123*z_1030 - 2.0*z_127*z_1022 -
        z_1141*z_16);
    const double z_1322 = z_37*z_1110;
    const double z_1323 = z_54*z_1111;
    D[59] = 0.5*(4.0*z_188*z_1317 + 4.0*z_219*z_1109 + 4.0*z_202*z_1110 + 4.0*z_203*z_1110 + 4.0*z_71*z_1322 +
        4.0*z_204*z_1110 + 4.0*z_201*z_1110 + 4.0*z_208*z_1111 + 4.0*z_209*z_1111 + 4.0*z_77*z_1323 +
        4.0*z_75*z_1323 + 4.0*z_211*z_1111 + 4.0*z_71*z_1113 + 4.0*z_75*z_1116 + 4.0*z_77*z_1116 +
        4.0*z_193*z_1117 + z_962*z_1126 + 4.0*z_450*z_1278 + 4.0*z_452*z_1216 + 4.0*z_451*z_1216 +
        4.0*z_626*z_1127 + 4.0*z_449*z_1279 + 4.0*z_616*z_1128 + 4.0*z_619*z_1128 + 4.0*z_457*z_1128 +
        4.0*z_615*z_1128 + 4.0*z_449*z_1130 + z_10*z_1124 + cos_theta*z_1140 + sin_theta*z_1141 - 4.0*z_215*z_1109
        - 4.0*z_218*z_1109 - 4.0*z_216*z_1109 - 4.0*z_25*z_1204 - 4.0*z_69*z_1322 - 4.0*z_200*z_1110 -
        4.0*z_212*z_1111 - 4.0*z_210*z_1111 - 4.0*z_20*z_1209 - 4.0*z_69*z_1113 - 2.0*z_960*z_1118 - z_780*z_1120
        - z_780*z_1122 - z_961*z_1124 - 4.0*z_449*z_1278 - 4.0*z_623*z_1127 - 4.0*z_456*z_1127 - 4.0*z_455*z_1127
        - 4.0*z_450*z_1279 - 4.0*z_625*z_1127 - 4.0*z_622*z_1127 - 4.0*z_458*z_1128 - 4.0*z_618*z_1128 -
        4.0*z_452*z_1217 - 4.0*z_451*z_1217 - 4.0*z_452*z_1129 - 4.0*z_451*z_1129 - 4.0*z_450*z_1130 -
        4.0*z_448*z_1020 - z_13*z_1126);
    const double z_1324 = r_R*z_449;
    const double z_1325 = r_R*z_450;
    const double z_1326 = z_52*z_452;
    const double z_1327 = z_52*z_451;
    const double z_1328 = sin_theta*z_557 - cos_theta*z_551;
    D[60] = 0.5*(4.0*z_1109*z_1325 + 4.0*z_449*z_1322 + 4.0*z_456*z_1110 + 4.0*z_455*z_1110 + 4.0*z_16*z_1209 +
        4.0*z_451*z_1323 + 4.0*z_619*z_1111 + 4.0*z_457*z_1111 + 4.0*z_452*z_1323 + 4.0*z_449*z_1113 +
        4.0*z_452*z_1116 + 4.0*z_451*z_1116 + z_505*z_1124 + z_503*z_1126 + 4.0*z_77*z_1216 + 4.0*z_69*z_1278 +
        4.0*z_75*z_1216 + 4.0*z_71*z_1279 + 4.0*z_208*z_1128 + 4.0*z_209*z_1128 + 4.0*z_1128*z_967 +
        4.0*z_71*z_1130 + z_314*z_1124 + 2.0*z_342*z_1218 + 2.0*z_344*z_1218 + z_1328 - 4.0*z_1109*z_1324 -
        4.0*z_1109*z_1326 - 4.0*z_1109*z_1327 - 4.0*z_22*z_1204 - 4.0*z_450*z_1322 - 4.0*z_626*z_1110 -
        4.0*z_458*z_1111 - 4.0*z_450*z_1113 - 4.0*z_71*z_1278 - 4.0*z_202*z_1127 - 4.0*z_204*z_1127 -
        4.0*z_1127*z_968 - 4.0*z_69*z_1279 - 4.0*z_203*z_1127 - 4.0*z_210*z_1128 - 4.0*z_77*z_1217 -
        4.0*z_75*z_1217 - 4.0*z_77*z_1129 - 4.0*z_69*z_1130 - 4.0*z_75*z_1129 - z_311*z_1126 - 2.0*z_173*z_1219 -
        2.0*z_263*z_1219 - 2.0*z_170*z_1220 - 2.0*z_261*z_1220 - 2.0*z_345*z_1221 - 2.0*z_349*z_1221 -
        2.0*z_1190);
    const double z_1329 = z_22*z_988;
    const double z_1330 = cos_delta*z_857;
    const double z_1331 = z_451*z_737;
    const double z_1332 = z_450*z_731;
    const double z_1333 = z_452*z_737;
    const double z_1334 = z_449*z_731;
    const double z_1335 = delta_dot*z_563;
    const double z_1336 = z_43*z_188;
    const double z_1337 = z_16*z_988;
    const double z_1338 = cos_delta*z_862;
    const double z_1339 = z_449*z_733;
    const double z_1340 = z_451*z_731;
    const double z_1341 = z_452*z_731;
    const double z_1342 = z_450*z_733;
    const double z_1343 = z_46*z_161;
    const double z_1344 = z_188*z_677;
    const double z_1345 = cos_theta*z_677;
    const double z_1346 = sin_theta*z_43;
    D[61] = (-0.5)*(4.0*z_1110*z_1329 + 4.0*z_1110*z_1331 + 4.0*z_1110*z_1333 + 4.0*z_1110*z_1334 +
        4.0*z_1110*z_1336 + 4.0*z_1111*z_1337 + 4.0*z_1111*z_1342 + 4.0*z_1111*z_1343 + 2.0*z_510*z_1345 +
        2.0*z_510*z_1346 + z_1119*z_1009 + z_1121*z_1012 + 4.0*z_1127*z_983 + 4.0*z_1127*z_993 + 4.0*z_1127*z_982
        + 4.0*z_1127*z_981 + 4.0*z_1127*z_980 + 4.0*z_1127*z_979 + 4.0*z_1128*z_986 + 4.0*z_1128*z_984 +
        2.0*z_732*z_1220 + 2.0*z_734*z_1220 + sin_tilt*z_1138 - 4.0*z_1110*z_1330 - 4.0*z_1110*z_1332 -
        4.0*z_1110*z_1335 - 4.0*z_1111*z_1338 - 4.0*z_1111*z_1339 - 4.0*z_1111*z_1340 - 4.0*z_1111*z_1341 -
        4.0*z_1111*z_1344 - z_523*z_738 - z_523*z_736 - z_520*z_734 - z_520*z_732 - 2.0*z_1006*z_1118 -
        2.0*z_1007*z_1118 - 2.0*z_1008*z_1118 - z_1119*z_1010 - z_1119*z_1011 - z_1121*z_1013 - z_1121*z_1014 -
        4.0*z_1127*z_994 - 4.0*z_1127*z_992 - 4.0*z_1128*z_997 - 4.0*z_1128*z_996 - 4.0*z_1128*z_995 -
        4.0*z_1128*z_985 - 4.0*z_1128*z_975 - 4.0*z_1128*z_974 - 2.0*z_736*z_1219 - 2.0*z_738*z_1219 -
        cos_tilt*z_1139);
    D[62] = -z_1189;
    D[63] = -F_yy*z_1135;
    const double z_1347 = z_116 - z_463;
    const double z_1348 = z_113 - z_462;
    const double z_1349 = z_970 - z_969;
    const double z_1350 = z_136*z_1347 - z_133*z_1348 - m_H*z_1349;
    const double z_1351 = z_135*z_1347 - z_132*z_1348 - m_F*z_1349;
    const double z_1352 = z_1350 + z_1351;
    const double z_1353 = z_155*z_20;
    const double z_1354 = z_152*z_25;
    const double z_1355 = z_1353 - z_1354;
    const double z_1356 = z_1352 + z_1355;
    const double z_1357 = z_136*z_1238 + z_133*z_1237 - m_H*z_1192;
    const double z_1358 = z_132*z_1237 + z_135*z_1238 - m_F*z_1192;
    const double z_1359 = z_1357 + z_1358;
    const double z_1360 = cos_theta*z_155 + sin_theta*z_152;
    const double z_1361 = z_1359 - z_1360;
    const double z_1362 = z_152*z_632 + z_155*z_634;
    const double z_1363 = z_1238*z_1023 + z_1237*z_1024 - z_1192*z_1025;
    const double z_1364 = z_1238*z_1028 + z_1237*z_1027 - z_1192*z_1029;
    const double z_1365 = z_1363 + z_1364;
    const double z_1366 = z_1365 - z_1362;
    const double z_1367 = z_152*z_962 - z_155*z_961;
    const double z_1368 = z_1347*z_1023 - z_1348*z_1024 - z_1349*z_1025;
    const double z_1369 = z_1348*z_1027 + z_1349*z_1029 - z_1347*z_1028;
    const double z_1370 = z_1368 - z_1369;
    const double z_1371 = z_1370 - z_1367;
    D[66] = cos_psi*(z_484*z_1356 + x_dot*z_1366 + z_173*z_1037 + z_170*z_1038 + z_261*z_1038 + z_263*z_1037 +
        z_116*z_1033 + z_462*z_1034 + z_20*z_1035 - z_485*z_1361 - y_dot*z_1371 - z_156*z_1166 - z_154*z_1167 -
        z_113*z_1034 - z_463*z_1033 - z_25*z_1036) - sin_psi*(z_485*z_1356 + z_484*z_1361 + z_113*z_1038 +
        z_463*z_1037 + z_25*z_1040 + z_173*z_1033 + z_170*z_1034 + z_261*z_1034 + z_263*z_1033 - y_dot*z_1366 -
        x_dot*z_1371 - z_116*z_1037 - z_462*z_1038 - z_20*z_1039 - z_156*z_1170 - z_154*z_1171);
    const double z_1372 = z_54*z_16;
    const double z_1373 = z_90 - z_1372;
    const double z_1374 = z_37*z_22;
    const double z_1375 = z_73 - z_1374;
    const double z_1376 = r_R*z_22 - z_52*z_16;
    const double z_1377 = z_133*z_1373 - z_136*z_1375 - m_H*z_1376;
    const double z_1378 = z_132*z_1373 - z_135*z_1375 - m_F*z_1376;
    const double z_1379 = z_1377 + z_1378;
    const double z_1380 = z_H*z_1377 + r_F*z_1378;
    const double z_1381 = z_53*z_1377 + c_*z_1378;
    const double z_1382 = z_155*z_22 - z_152*z_16;
    const double z_1383 = z_11*z_1382;
    const double z_1384 = x_B*z_1382;
    const double z_1385 = z_1379 - z_1382;
    const double z_1386 = cos_delta*cos_delta;
    const double z_1387 = z_534*z_1386;
    const double z_1388 = sin_tilt*H_xz;
    const double z_1389 = cos_tilt*H_xx + cos_tilt*z_519 - 2.0*z_1388;
    const double z_1390 = sin_delta*z_1389;
    const double z_1391 = cos_tilt*H_xz;
    const double z_1392 = sin_tilt*H_zz + sin_tilt*z_522 - 2.0*z_1391;
    const double z_1393 = sin_delta*z_1392;
    const double z_1394 = 2.0*z_84*z_559 + z_44*z_1393 - z_54*z_1390;
    const double z_1395 = 2.0*z_47*z_559 + z_44*z_1390 - z_37*z_1393;
    const double z_1396 = z_53*z_1350 + c_*z_1351;
    const double z_1397 = z_H*z_1350 + r_F*z_1351;
    const double z_1398 = z_11*z_1355;
    const double z_1399 = x_B*z_1355;
    const double z_1400 = (psi_dot*z_1357 + psi_dot*z_1358) + z_1365;
    const double z_1401 = (z_1357*z_1175 + z_1358*z_1176) + (z_53*z_1363 + c_*z_1364);
    const double z_1402 = (z_1357*z_1172 + z_1358*z_1173) + (z_H*z_1363 + r_F*z_1364);
    const double z_1403 = psi_dot*z_1360 + z_1362;
    const double z_1404 = z_11*z_1403;
    const double z_1405 = x_B*z_1403;
    const double z_1406 = z_1400 - z_1403;
    const double z_1407 = z_39 + z_506*z_84 - z_504*z_47;
    const double z_1408 = z_515 + z_37*z_504 - z_65;
    const double z_1409 = z_511 + z_86 + z_54*z_506;
    const double z_1410 = 2.0*H_xz*z_1408 + z_567*z_1409;
    const double z_1411 = 2.0*H_xz*z_1409 + z_570*z_1408;
    const double z_1412 = z_1389*z_33 + z_42*z_1392;
    const double z_1413 = delta_dot*z_1229;
    const double z_1414 = 2.0*z_550 + 2.0*z_1407*z_553 + z_54*z_1410 + z_44*z_1411 + z_573*z_506 - 2.0*z_46*z_1387
        - z_1412*z_1413;
    const double z_1415 = z_42*z_1389 + z_1392*z_36;
    const double z_1416 = 2.0*z_556 + 2.0*z_516*z_1387 + z_44*z_1410 + z_37*z_1411 + z_1415*z_1413 + z_577*z_504 -
        2.0*z_1407*z_535;
    const double z_1417 = z_668*z_672 + z_670*z_671 + z_675*z_673 + z_640*z_673;
    const double z_1418 = z_16*z_84;
    const double z_1419 = z_47*z_22;
    const double z_1420 = z_698*z_695 + z_699*z_697 + 2.0*z_646*z_700 + z_672*z_702 + z_671*z_703 +
        2.0*z_658*z_673 + z_636*(z_698*z_707 + z_698*z_708 + z_699*z_709 + z_699*z_710 + z_700*z_712 + z_672*z_714
        + z_672*z_715 + z_671*z_716 + z_673*z_718 - z_649*z_700 - z_671*z_717 - z_661*z_673 - z_1156*z_1418 -
        z_1156*z_1419) - z_1155*z_1418 - z_1155*z_1419 - psi_ddot*z_559;
    const double z_1421 = 2.0*z_1391 - sin_tilt*z_570;
    const double z_1422 = sin_delta*psi_ddot;
    const double z_1423 = 2.0*z_646*z_699 + 2.0*z_658*z_672 + z_1421*z_1422;
    const double z_1424 = 2.0*z_1388 - cos_tilt*z_567;
    const double z_1425 = 2.0*z_646*z_698 + 2.0*z_658*z_671 + z_1424*z_1422;
    const double z_1426 = z_342*psi_ddot + z_344*psi_ddot;
    const double z_1427 = z_1158 + z_261*psi_ddot;
    const double z_1428 = z_1160 + z_263*psi_ddot;
    const double z_1429 = psi_dot*z_1368 + m_H*z_1426 - z_133*z_1427 - z_136*z_1428;
    const double z_1430 = psi_dot*z_1369 + z_132*z_1427 + z_135*z_1428 - m_F*z_1426;
    const double z_1431 = z_640*z_672 + r_F*z_1430 - z_H*z_1429;
    const double z_1432 = z_640*z_671 + z_53*z_1429 - c_*z_1430;
    const double z_1433 = cos_tilt*z_1389 + sin_tilt*z_1392;
    const double z_1434 = z_1433*z_1229;
    const double z_1435 = cos_delta*(2.0*z_534 - z_1433);
    const double z_1436 = 2.0*z_1407*z_559 + z_1411*z_47 + z_39*z_1435 - z_1410*z_84;
    const double z_1437 = z_1429 - z_1430;
    const double z_1438 = psi_dot*z_1367 - z_155*z_682 - z_152*z_688;
    D[67] = (-0.5)*(sin_phi*(2.0*cos_theta*z_1187 + 2.0*z_173*z_1103 + 2.0*z_169*z_1104 + 2.0*z_175*z_1182 +
        2.0*z_1380*z_757 + 2.0*z_1380*z_333 + 2.0*z_1380*z_331 + 2.0*z_1380*z_332 + 2.0*z_229*z_1380 +
        2.0*z_1381*z_754 + 4.0*z_1381*z_755 + 2.0*z_1381*z_328 + 4.0*z_225*z_1381 + 2.0*z_224*z_1381 +
        2.0*z_1381*z_329 + 2.0*z_1381*z_330 + 4.0*z_1381*z_756 + 2.0*z_196*z_1383 + 2.0*z_1382*z_1114 +
        2.0*z_1382*z_1115 + 2.0*z_197*z_1384 + 2.0*z_334*z_1385 + 2.0*z_561*z_1387 + z_1394*z_576 + z_1395*z_580 +
        4.0*z_582*z_1352 + 4.0*z_1396*z_585 + 4.0*z_1396*z_277 + 2.0*z_1397*z_589 + 4.0*z_1397*z_590 +
        4.0*z_1397*z_279 + 2.0*z_1397*z_592 + 4.0*z_309*z_1398 + 2.0*sin_theta*z_1179 + 2.0*z_172*z_1048 +
        2.0*z_170*z_1047 + 2.0*z_1401*z_282 + 2.0*z_1401*z_283 + 2.0*z_86*z_1401 + 2.0*z_1402*z_285 +
        2.0*z_1402*z_286 + 2.0*z_311*z_1404 + 2.0*z_314*z_1405 + 2.0*z_1406*z_607 + 2.0*z_641*z_1222 +
        2.0*z_170*z_1223 + 2.0*z_172*z_1224 + 2.0*z_642*z_1222 + 2.0*z_176*lambda_0 + 2.0*z_1420*z_722 +
        z_170*z_1425 + z_261*z_1425 + 2.0*z_744*z_561 + z_561*z_1434 - 2.0*sin_theta*z_1188 - 2.0*z_172*z_1103 -
        2.0*z_170*z_1104 - 2.0*z_176*z_1182 - 2.0*z_750*z_1379 - 2.0*z_752*z_1379 - 2.0*z_753*z_1379 -
        2.0*z_751*z_1379 - 2.0*z_231*z_1380 - 4.0*z_1380*z_758 - 4.0*z_230*z_1380 - 4.0*z_1380*z_759 -
        2.0*z_226*z_1381 - 4.0*z_581*z_1352 - 2.0*z_1396*z_584 - 4.0*z_1396*z_276 - 4.0*z_1396*z_586 -
        2.0*z_1396*z_587 - 4.0*z_1397*z_591 - 4.0*z_1397*z_280 - 4.0*z_308*z_1399 - 2.0*cos_theta*z_1180 -
        2.0*z_173*z_1048 - 2.0*z_169*z_1047 - z_551*z_632 - z_557*z_634 - 2.0*z_1400*z_599 - 2.0*z_1400*z_600 -
        2.0*z_65*z_1402 - z_1414*z_632 - z_1416*z_634 - 2.0*cos_delta*z_1417 - 2.0*z_175*lambda_0 -
        2.0*z_169*z_1223 - 2.0*z_173*z_1224 - 2.0*z_1420*z_723 - z_173*z_1423 - z_263*z_1423 - 2.0*z_1431*z_47 -
        2.0*z_1432*z_84) + cos_phi*(2.0*cos_theta*z_1074 + 2.0*z_169*z_1105 + 2.0*z_173*z_1106 + 2.0*z_175*z_105 +
        4.0*z_581*z_1379 + 4.0*z_1380*z_591 + 4.0*z_1380*z_280 + 2.0*z_1381*z_584 + 4.0*z_1381*z_276 +
        4.0*z_1381*z_586 + 2.0*z_1381*z_587 + 4.0*z_309*z_1383 + z_1394*z_748 + 2.0*z_1396*z_754 +
        4.0*z_225*z_1396 + 2.0*z_224*z_1396 + 4.0*z_1396*z_755 + 2.0*z_1396*z_328 + 2.0*z_1396*z_329 +
        2.0*z_1396*z_330 + 4.0*z_1396*z_756 + 2.0*z_1397*z_757 + 2.0*z_229*z_1397 + 2.0*z_1397*z_331 +
        2.0*z_1397*z_332 + 2.0*z_1397*z_333 + 2.0*z_334*z_1356 + 2.0*z_632*z_1045 + 2.0*z_172*z_1044 +
        2.0*z_170*z_1043 + 2.0*z_176*z_1042 + 2.0*z_761*z_1400 + 2.0*z_1401*z_762 + 2.0*z_45*z_1401 +
        2.0*z_1401*z_763 + 2.0*z_1402*z_764 + 2.0*z_1402*z_337 + 2.0*z_10*z_1404 + psi_dot*z_1436 +
        2.0*z_170*z_1142 + 2.0*z_172*z_1143 + 2.0*z_176*lambda_4 + 2.0*z_1417*z_722 + 2.0*z_593*z_688 +
        2.0*z_170*z_1147 + 2.0*z_172*z_1148 + 2.0*z_176*z_1149 + 2.0*cos_delta*z_1420 + z_1423*z_47 + z_1425*z_84
        + 2.0*z_170*z_1164 + 2.0*z_172*z_1165 + 2.0*z_389*z_1167 + 2.0*z_173*z_1169 + 2.0*z_169*z_1168 +
        2.0*z_296*z_1170 + 2.0*z_170*z_1432 + 2.0*z_261*z_1432 + 2.0*z_345*z_1438 + 2.0*z_349*z_1438 +
        2.0*r_R*(z_1437 - z_1438) - 2.0*sin_theta*z_1075 - 2.0*z_170*z_1105 - 2.0*z_172*z_1106 - 2.0*z_176*z_105 -
        4.0*z_582*z_1379 - 4.0*z_1380*z_590 - 4.0*z_1380*z_279 - 2.0*z_1380*z_589 - 2.0*z_1380*z_592 -
        4.0*z_1381*z_585 - 4.0*z_1381*z_277 - 4.0*z_308*z_1384 - z_1395*z_749 - 2.0*z_750*z_1352 -
        2.0*z_751*z_1352 - 2.0*z_752*z_1352 - 2.0*z_753*z_1352 - 2.0*z_226*z_1396 - 2.0*z_231*z_1397 -
        4.0*z_230*z_1397 - 4.0*z_1397*z_758 - 4.0*z_1397*z_759 - 2.0*z_196*z_1398 - 2.0*z_197*z_1399 -
        2.0*z_1355*z_1114 - 2.0*z_1355*z_1115 - 2.0*z_634*z_1046 - 2.0*z_173*z_1044 - 2.0*z_169*z_1043 -
        2.0*z_175*z_1042 - 2.0*z_760*z_1400 - 2.0*z_49*z_1401 - 2.0*z_1401*z_336 - 2.0*z_58*z_1402 -
        2.0*z_57*z_1402 - 2.0*z_1402*z_765 - 2.0*z_13*z_1405 - 2.0*z_169*z_1142 - 2.0*z_173*z_1143 -
        2.0*z_175*lambda_4 - 2.0*z_1417*z_723 - 2.0*z_594*z_682 - 2.0*z_173*z_1148 - 2.0*z_169*z_1147 -
        2.0*z_175*z_1149 - 2.0*z_744*psi_ddot - 2.0*z_173*z_1165 - 2.0*z_169*z_1164 - 2.0*z_405*z_1166 -
        2.0*z_170*z_1168 - 2.0*z_172*z_1169 - 2.0*z_294*z_1171 - 2.0*z_342*z_1437 - 2.0*z_344*z_1437 -
        2.0*z_173*z_1431 - 2.0*z_263*z_1431));
    const double z_1439 = z_247*z_1025 + z_249*z_1029;
    const double z_1440 = z_247*z_1024 + z_249*z_1027;
    const double z_1441 = z_247*z_1023 + z_249*z_1028;
    const double z_1442 = z_1321 + z_1318;
    const double z_1443 = z_52*z_1065;
    const double z_1444 = cos_phi*z_48;
    const double z_1445 = theta_dot*z_391;
    const double z_1446 = z_44*z_66;
    const double z_1447 = cos_phi*z_55;
    const double z_1448 = theta_dot*z_365;
    const double z_1449 = z_54*z_66;
    const double z_1450 = z_1320 + z_1319;
    const double z_1451 = (((z_1442*z_415 - z_373*z_1060) + (z_188*z_1061 - z_779*z_1063)) - ((z_66*z_1064 +
        theta_dot*z_1046) + ((z_251*z_847 - z_251*z_848) - (z_1068*z_849 + z_1068*z_376)))) - ((((z_1068*z_413 +
        z_1071*z_800) + (z_1071*z_375 - z_1071*z_414)) + ((theta_dot*z_167*z_1065 + z_66*z_1443) + (z_1072*z_1444
        - z_1072*z_1445))) - (((z_1072*z_1446 + z_1059*z_1447) + (z_1059*z_1448 + z_1059*z_1449)) - ((z_126*z_850
        + z_1450*z_40) - (z_1450*z_381 + z_1442*z_48))));
    const double z_1452 = z_133*z_234 + z_132*z_238;
    const double z_1453 = z_136*z_234 + z_135*z_238;
    const double z_1454 = z_1380*z_40;
    const double z_1455 = z_1381*z_55;
    const double z_1456 = r_R*z_1352;
    const double z_1457 = z_37*z_1397;
    const double z_1458 = z_H*z_1357 + r_F*z_1358;
    const double z_1459 = z_53*z_1357 + c_*z_1358;
    const double z_1460 = x_B*z_1360;
    const double z_1461 = psi_dot*z_1350 + psi_dot*z_1351 + z_1370;
    const double z_1462 = (z_1350*z_1172 + z_1351*z_1173) + (z_H*z_1368 - r_F*z_1369);
    const double z_1463 = (z_1350*z_1175 + z_1351*z_1176) + (z_53*z_1368 - c_*z_1369);
    const double z_1464 = psi_dot*z_1355 - z_1367;
    const double z_1465 = z_783 - c_*z_363 - r_F*z_365 - z_85*z_645;
    const double z_1466 = r_F*z_37;
    const double z_1467 = c_*z_44;
    const double z_1468 = z_44*z_340;
    const double z_1469 = z_670*z_698 + z_668*z_699 + z_675*z_700 + z_640*z_700 + phi_ddot*z_559;
    const double z_1470 = z_795*psi_ddot;
    const double z_1471 = z_793*psi_ddot;
    const double z_1472 = z_44*y_ddot;
    const double z_1473 = z_44*x_ddot;
    const double z_1474 = z_116*psi_ddot - z_463*psi_ddot;
    const double z_1475 = z_462*psi_ddot - z_113*psi_ddot;
    const double z_1476 = z_1150*z_20 - z_970*psi_ddot;
    const double z_1477 = psi_dot*z_1363 + z_136*z_1474 + z_133*z_1475 + m_H*z_1476;
    const double z_1478 = psi_dot*z_1364 + z_135*z_1474 + z_132*z_1475 + m_F*z_1476;
    const double z_1479 = 2.0*z_640*z_698 + 2.0*z_53*z_1477 + 2.0*c_*z_1478 - z_1424*z_340;
    const double z_1480 = z_1477 + z_1478;
    const double z_1481 = 2.0*z_640*z_699 - 2.0*z_H*z_1477 - 2.0*r_F*z_1478 - z_1421*z_340;
    const double z_1482 = psi_dot*z_1362 + z_1354*psi_ddot - z_1353*psi_ddot;
    const double z_1483 = cos_phi*z_40;
    const double z_1484 = z_37*z_66;
    const double z_1485 = theta_dot*z_363;
    const double z_1486 = (((z_1442*z_381 + z_373*z_1061) + (z_188*z_1060 - z_66*z_1063)) + ((z_779*z_1064 -
        theta_dot*z_1045) + ((z_251*z_799 + z_193*z_251) - (z_1068*z_800 + z_1068*z_374)))) - ((((z_1068*z_375 -
        z_1071*z_801) + (z_1071*z_376 + z_1071*z_377)) + ((z_448*z_1065 - z_779*z_1443) - (z_1072*z_1483 +
        z_1072*z_1484))) + (((z_1072*z_1448 + z_1059*z_1444) + (z_1059*z_1485 - z_1059*z_1446)) + ((z_126*z_805 +
        z_1450*z_48) - (z_1450*z_379 + z_1442*z_55))));
    const double z_1487 = z_52*z_1352;
    const double z_1488 = z_54*z_1396;
    const double z_1489 = z_11*z_1360;
    const double z_1490 = z_167 + z_63*z_645 - c_*z_365 - r_F*z_391;
    const double z_1491 = z_44*r_F;
    const double z_1492 = c_*z_54;
    const double z_1493 = z_52*psi_ddot;
    D[68] = 0.5*(sin_theta*(2.0*sin_phi*z_1074 + 2.0*z_44*z_1452 + 2.0*z_37*z_1453 + 2.0*z_1103*z_363 +
        2.0*z_1104*z_365 + 2.0*z_105*z_418 + 2.0*z_1379*z_1200 + 2.0*z_1098*z_1379 + 4.0*z_1201*z_1379 +
        4.0*z_66*z_1454 + 4.0*z_1380*z_1207 + 2.0*z_1381*z_1208 + 4.0*z_784*z_1352 + 2.0*z_1396*z_361 +
        4.0*z_1396*z_786 + 2.0*z_1396*z_362 + 2.0*z_1397*z_788 + 4.0*z_1397*z_790 + 2.0*z_3*z_1457 +
        2.0*z_368*z_1457 + 2.0*z_792*z_1359 + 2.0*z_1458*z_82 + 4.0*z_1458*z_794 + 4.0*z_402*z_1399 + z_1395*z_17
        + 2.0*z_1400*z_799 + 2.0*z_193*z_1400 + 2.0*z_1402*z_801 + 2.0*z_1462*z_379 + 2.0*z_1463*z_55 +
        2.0*z_1463*z_381 + z_1416*z_780 + 2.0*z_360*z_1142 + 2.0*z_385*z_1143 + 2.0*z_563*z_1417 +
        2.0*z_1465*lambda_0 + 2.0*z_340*z_1233 + 2.0*z_1469*z_84 + 2.0*r_R*lambda_3 + 2.0*z_360*z_1147 +
        2.0*z_385*z_1148 + 2.0*psi_ddot*z_816 + 2.0*z_486*z_1150 + z_1423*z_391 + 2.0*z_360*z_1164 +
        2.0*z_385*z_1165 + 2.0*y_ddot*z_294 + 2.0*z_296*z_1305 + 2.0*x_ddot*z_389 + 2.0*z_52*z_1480 + z_44*z_1481
        + 2.0*z_1432*z_360 + 2.0*z_1438*z_401 - (phi_dot*z_551 + 2.0*z_1047*z_365 + 2.0*z_1048*z_363 +
        2.0*r_R*z_1439 + 2.0*psi_dot*z_1060 + 2.0*z_1042*z_418 + 2.0*z_500*z_1046 - z_557*z_780 - 2.0*z_44*z_1440
        - 2.0*z_37*z_1441 - 2.0*z_1043*z_360 - 2.0*z_1044*z_385 - 2.0*cos_phi*z_1180 - 2.0*z_1451) -
        2.0*z_155*z_198 - 2.0*cos_phi*z_1187 - 2.0*r_R*z_240 - 2.0*z_783*z_1182 - 2.0*z_1105*z_360 -
        2.0*z_1106*z_385 - 2.0*z_1380*z_1202 - 2.0*z_1380*z_1203 - 2.0*z_1380*z_1205 - 4.0*z_1380*z_1206 -
        4.0*z_779*z_1455 - 2.0*z_1381*z_1210 - 4.0*z_1381*z_1211 - 2.0*z_1381*z_1212 - 4.0*z_1381*z_1213 -
        2.0*z_1383*z_1214 - 2.0*z_431*z_1383 - 4.0*z_1384*z_1215 - z_1394*z_781 - z_1395*z_747 - 2.0*z_368*z_1456
        - 2.0*z_3*z_1456 - 2.0*z_1396*z_785 - 4.0*z_1396*z_787 - 4.0*z_1396*z_364 - 4.0*z_1397*z_789 -
        4.0*z_1397*z_366 - 2.0*z_1458*z_370 - 2.0*z_1459*z_95 - 4.0*z_1459*z_796 - 2.0*z_1459*z_797 -
        2.0*z_368*z_1398 - 2.0*z_3*z_1398 - 2.0*z_27*z_1460 - 2.0*z_1401*z_800 - 2.0*z_1401*z_374 -
        2.0*z_1401*z_375 - 2.0*z_1402*z_376 - 2.0*z_1402*z_377 - 2.0*z_1461*z_805 - 2.0*z_1462*z_48 -
        2.0*z_373*z_1405 - 2.0*z_188*z_1404 - 2.0*z_1464*z_809 - phi_dot*z_1414 - 2.0*lambda_4*z_418 -
        2.0*z_1466*lambda_3 - 2.0*z_1467*lambda_3 - 2.0*z_1226*z_1468 - 2.0*z_340*z_1235 - 2.0*z_719*z_594 -
        2.0*z_418*z_1149 - 2.0*z_44*z_1470 - 2.0*z_37*z_1471 - 2.0*z_63*z_1420 - z_1425*z_365 - 2.0*z_405*z_1304 -
        2.0*z_275*z_1472 - 2.0*y_ddot*z_367 - 2.0*z_360*z_1168 - 2.0*z_385*z_1169 - 2.0*z_371*z_1473 -
        2.0*x_ddot*z_388 - z_54*z_1479 - 2.0*x_B*z_1482 - 2.0*z_107*z_1437 - 2.0*z_1431*z_400 - 2.0*z_1451) -
        cos_theta*(2.0*cos_phi*z_1188 + 2.0*z_54*z_1452 + 2.0*z_44*z_1453 + 2.0*z_167*z_1182 + 2.0*z_1105*z_400 +
        2.0*z_1106*z_360 + 2.0*z_1379*z_1271 + 2.0*z_1379*z_1273 + 2.0*z_1380*z_1208 + 4.0*z_779*z_1454 +
        4.0*z_1380*z_1274 + 4.0*z_1381*z_1206 + 4.0*z_66*z_1455 + 4.0*z_1383*z_1215 + z_1394*z_747 +
        2.0*z_1396*z_840 + 4.0*z_1396*z_789 + 2.0*z_368*z_1488 + 4.0*z_1396*z_366 + 2.0*z_3*z_1488 +
        4.0*z_1396*z_842 + 2.0*z_1397*z_361 + 2.0*z_1397*z_362 + 4.0*z_1397*z_412 + 2.0*z_1458*z_80 +
        2.0*z_1458*z_845 + 2.0*z_1459*z_370 + 4.0*z_1459*z_846 + 2.0*z_27*z_1489 + 2.0*z_1400*z_848 +
        2.0*z_1401*z_849 + 2.0*z_1401*z_376 + 2.0*z_1402*z_414 + 2.0*z_1462*z_381 + 2.0*z_1463*z_48 +
        2.0*z_1463*z_415 + 2.0*z_373*z_1404 + z_1414*z_780 + phi_dot*z_1416 + 2.0*z_107*lambda_4 +
        2.0*z_1227*z_1468 + 2.0*z_340*z_1281 + 2.0*z_1469*z_47 + 2.0*z_52*lambda_3 + 2.0*z_719*z_593 +
        2.0*z_107*z_1149 + 2.0*psi_ddot*z_798 + 2.0*z_486*z_1493 + 2.0*z_85*z_1420 + z_1423*z_365 +
        2.0*z_389*z_1304 + 2.0*y_ddot*z_296 + 2.0*z_360*z_1169 + 2.0*z_400*z_1168 + 2.0*x_ddot*z_405 + z_44*z_1479
        + 2.0*z_11*z_1482 + 2.0*z_1432*z_385 + 2.0*z_1438*z_419 + 2.0*z_1486 - (2.0*z_52*z_1439 +
        2.0*psi_dot*z_1061 + 2.0*z_1043*z_400 + 2.0*z_1044*z_360 + 2.0*cos_phi*z_1179 + 2.0*z_1486 - phi_dot*z_557
        - z_551*z_780 - 2.0*z_1047*z_391 - 2.0*z_1048*z_365 - 2.0*z_54*z_1440 - 2.0*z_44*z_1441 - 2.0*z_107*z_1042
        - 2.0*z_500*z_1045) - 2.0*z_152*z_198 - 2.0*sin_phi*z_1075 - 2.0*z_52*z_240 - 2.0*z_1103*z_365 -
        2.0*z_1104*z_391 - 2.0*z_107*z_105 - 4.0*z_1272*z_1379 - 4.0*z_1380*z_1211 - 2.0*z_1380*z_1212 -
        2.0*z_1380*z_1210 - 2.0*z_1381*z_1275 - 2.0*z_1381*z_1276 - 4.0*z_1381*z_1207 - 2.0*z_1381*z_1277 -
        2.0*z_431*z_1384 - 2.0*z_1384*z_1214 - z_1395*z_781 - 2.0*z_368*z_1487 - 2.0*z_3*z_1487 - 4.0*z_839*z_1352
        - 2.0*z_1397*z_785 - 4.0*z_1397*z_787 - 4.0*z_1397*z_843 - 2.0*z_844*z_1359 - 4.0*z_1458*z_796 -
        2.0*z_1459*z_82 - 2.0*z_368*z_1399 - 4.0*z_402*z_1398 - 2.0*z_3*z_1399 - z_1394*z_17 - 2.0*z_1400*z_847 -
        2.0*z_1401*z_413 - 2.0*z_1402*z_800 - 2.0*z_1402*z_375 - 2.0*z_1461*z_850 - 2.0*z_1462*z_40 -
        2.0*z_188*z_1405 - 2.0*z_1464*z_851 - 2.0*z_400*z_1142 - 2.0*z_360*z_1143 - 2.0*z_565*z_1417 -
        2.0*z_1490*lambda_0 - 2.0*z_1491*lambda_3 - 2.0*z_1492*lambda_3 - 2.0*z_340*z_1282 - 2.0*z_360*z_1148 -
        2.0*z_400*z_1147 - 2.0*z_44*z_1471 - 2.0*z_54*z_1470 - z_1425*z_363 - 2.0*z_360*z_1165 - 2.0*z_400*z_1164
        - 2.0*z_278*z_1472 - 2.0*y_ddot*z_411 - 2.0*z_369*z_1473 - 2.0*z_294*z_1305 - 2.0*x_ddot*z_372 -
        2.0*r_R*z_1480 - z_37*z_1481 - 2.0*z_1437*z_418 - 2.0*z_1431*z_360));
    const double z_1494 = sin_tilt*lambda_3;
    const double z_1495 = cos_tilt*lambda_3;
    const double z_1496 = z_52 - z_1492 - z_1491;
    const double z_1497 = z_52 - z_44*z_H - z_54*z_53;
    const double z_1498 = z_132*z_1496 + z_133*z_1497;
    const double z_1499 = z_42*z_1498;
    const double z_1500 = r_R - z_1467 - z_1466;
    const double z_1501 = r_R - z_37*z_H - z_44*z_53;
    const double z_1502 = z_135*z_1500 + z_136*z_1501;
    const double z_1503 = z_42*z_1502;
    const double z_1504 = z_132*z_1500 + z_133*z_1501;
    const double z_1505 = z_135*z_1496 + z_136*z_1497;
    const double z_1506 = sin_tilt*z_1389 - cos_tilt*z_1392;
    const double z_1507 = z_1226*phi_ddot;
    const double z_1508 = z_1227*phi_ddot;
    const double z_1509 = z_506*z_1415;
    const double z_1510 = z_504*z_1412;
    const double z_1511 = cos_theta*z_1453;
    const double z_1512 = z_1104*z_22;
    const double z_1513 = z_815 + z_145;
    const double z_1514 = z_813 - z_818;
    const double z_1515 = z_133*z_1513 - z_136*z_1514 - m_H*z_817;
    const double z_1516 = z_132*z_1513 - z_135*z_1514 - m_F*z_817;
    const double z_1517 = (z_504*z_523 - 2.0*z_1047*z_22) - 2.0*(cos_theta*z_1441 - z_1043*z_20);
    const double z_1518 = cos_theta*z_1452;
    const double z_1519 = sin_theta*z_1453;
    const double z_1520 = z_1103*z_22;
    const double z_1521 = z_1104*z_16;
    const double z_1522 = z_1505*theta_ddot;
    const double z_1523 = z_1504*theta_ddot;
    const double z_1524 = z_853 - z_145;
    const double z_1525 = z_813 + z_855;
    const double z_1526 = z_136*z_1524 + m_H*z_854 - z_133*z_1525;
    const double z_1527 = z_135*z_1524 + m_F*z_854 - z_132*z_1525;
    const double z_1528 = (z_504*z_520 + 2.0*z_1048*z_22) + 2.0*(cos_theta*z_1440 - z_1044*z_20);
    const double z_1529 = (z_506*z_523 + 2.0*z_1047*z_16) - 2.0*(sin_theta*z_1441 + z_1043*z_25);
    const double z_1530 = sin_theta*z_1452;
    const double z_1531 = z_1103*z_16;
    const double z_1532 = (z_506*z_520 - 2.0*z_1048*z_16) + 2.0*(sin_theta*z_1440 + z_1044*z_25);
    D[69] = 0.5*(cos_delta*(sin_tilt*z_547 + cos_tilt*z_545 + 4.0*z_1380*z_1285 + 2.0*z_1380*z_1288 +
        2.0*z_1380*z_1289 + 4.0*z_1381*z_1290 + 4.0*z_1381*z_1291 + 4.0*z_1381*z_1293 + 2.0*z_534*z_526*z_677 +
        4.0*z_1396*z_881 + 4.0*z_1397*z_884 + 2.0*z_1397*z_885 + 4.0*z_1397*z_886 + 4.0*z_1397*z_888 +
        2.0*z_1397*z_889 + 4.0*z_1458*z_890 + 4.0*z_1459*z_892 + 2.0*z_504*z_897 + 2.0*z_1401*z_898 +
        2.0*z_1402*z_901 + 2.0*z_1402*z_903 + 2.0*z_1462*z_904 + 2.0*z_1462*z_905 + 2.0*z_1407*z_909 +
        2.0*z_1407*z_911 + z_1410*z_912 + 2.0*z_647*z_1299 + 2.0*z_648*z_1300 + 2.0*z_659*z_1494 +
        2.0*z_1417*z_920 + 2.0*cos_tilt*z_16*z_1222 + 2.0*sin_tilt*z_22*z_1222 + 2.0*delta_ddot*z_1503 +
        2.0*z_1505*delta_ddot*z_36 + 2.0*z_1433*z_1231 + 2.0*z_1226*z_290 + 2.0*z_172*z_1508 + 2.0*phi_ddot*z_1303
        + 2.0*z_1420*z_868 + sin_delta*z_1433*z_189 - 2.0*delta_dot*z_510 - 4.0*z_1380*z_1284 - 4.0*z_1380*z_1286
        - 4.0*z_1380*z_1287 - 2.0*z_1381*z_1292 - 4.0*z_1381*z_1294 - 2.0*z_1381*z_1295 - 2.0*z_534*z_529*z_43 -
        2.0*z_326*z_957 - 4.0*z_1396*z_878 - 2.0*z_1396*z_879 - 4.0*z_1396*z_880 - 4.0*z_1396*z_882 -
        2.0*z_1396*z_883 - 4.0*z_1397*z_887 - 4.0*z_1458*z_891 - 4.0*z_1459*z_893 - 2.0*z_506*z_896 -
        2.0*z_1401*z_899 - 2.0*z_1401*z_900 - 2.0*z_1402*z_902 - 2.0*z_1463*z_906 - 2.0*z_1463*z_907 -
        z_1411*z_913 - 2.0*z_660*z_1495 - 2.0*z_1417*z_921 - 2.0*delta_ddot*z_1499 - 2.0*z_1504*delta_ddot*z_33 -
        z_1506*delta_ddot - 2.0*z_1227*z_289 - 2.0*z_169*z_1507 - 2.0*phi_ddot*z_1302 - phi_ddot*z_1297 -
        phi_ddot*z_1296 - 2.0*z_1469*z_922 - 2.0*z_1469*z_923 - 2.0*z_1420*z_867 - psi_ddot*z_875 - psi_ddot*z_872
        - z_1423*z_860 - z_1425*z_864 - 2.0*z_1431*z_428 - 2.0*z_1432*z_429 - z_39*z_1509 - z_39*z_1510) +
        sin_delta*(2.0*z_866 + 2.0*z_917 + 2.0*z_914 + z_516*z_523 + z_46*z_520 + 2.0*z_1380*z_1306 +
        4.0*z_1380*z_1308 + 2.0*z_1381*z_1309 + 2.0*z_534*z_532 + 2.0*z_534*z_531 + 2.0*z_1396*z_945 +
        4.0*z_1396*z_946 + 2.0*z_1397*z_949 + 2.0*z_1458*z_951 + 2.0*z_1458*z_952 + 2.0*z_1402*z_956 +
        2.0*z_1407*z_957 + 2.0*cos_phi*z_1417 + 2.0*phi_ddot*z_1314 + 2.0*sin_phi*z_1420 + (2.0*z_1530 +
        2.0*z_1531 + z_526*z_1390 + 2.0*z_1396*z_28 + 2.0*z_1396*z_21 + 2.0*z_10*z_1463 + 2.0*z_25*z_1143 +
        2.0*z_1498*theta_ddot + 2.0*z_53*z_1526 + 2.0*c_*z_1527 + 2.0*z_25*z_1148 + 2.0*z_25*z_1165 +
        2.0*z_1432*z_20 + z_1532 - 2.0*z_1106*z_25 - 2.0*z_1381*z_1099 - 4.0*z_1381*z_1077 - 2.0*z_1381*z_1096 -
        4.0*z_1396*z_18 - 2.0*z_196*z_1459 - 2.0*z_1401*z_77 - 2.0*z_1401*z_75 - z_504*z_1410 - 2.0*z_16*z_1224 -
        2.0*c_*z_664 - 2.0*z_257*z_1508 - 2.0*z_795*z_688 - z_1425*z_22 - 2.0*z_275*z_1167 - 2.0*z_25*z_1169 -
        2.0*z_371*z_1171 - cos_theta*z_1479)*z_33 - 2.0*z_693 - 4.0*z_1246 - 2.0*z_1380*z_1307 - 2.0*z_1381*z_1310
        - 4.0*z_1381*z_1311 - 2.0*z_189*z_559 - 2.0*z_1396*z_943 - 2.0*z_1397*z_947 - 4.0*z_1397*z_950 -
        2.0*z_1459*z_953 - 2.0*z_1459*z_954 - 2.0*z_1401*z_955 - 2.0*psi_ddot*z_958 - (2.0*z_1512 +
        2.0*z_1380*z_1097 + 2.0*z_1380*z_1184 + z_529*z_1393 + 2.0*z_1402*z_71 + 2.0*z_20*z_1142 + 2.0*r_F*z_666 +
        2.0*z_H*z_1515 + 2.0*r_F*z_1516 + 2.0*z_20*z_1147 + 2.0*z_793*z_682 + 2.0*z_20*z_1164 + 2.0*z_278*z_1166 +
        2.0*z_369*z_1170 + sin_theta*z_1481 + 2.0*z_1431*z_25 + z_1517 - 2.0*z_1511 - 2.0*z_1105*z_20 -
        4.0*z_1380*z_1080 - 2.0*z_1397*z_26 - 2.0*z_1397*z_29 - 4.0*z_1397*z_23 - 2.0*z_197*z_1458 -
        2.0*z_1402*z_69 - 2.0*z_13*z_1462 - z_506*z_1411 - 2.0*z_22*z_1223 - 2.0*z_1502*theta_ddot -
        2.0*z_255*z_1507 - z_1423*z_16 - 2.0*z_20*z_1168)*z_36 - z_42*(2.0*z_1518 + 2.0*z_1519 + 2.0*z_1521 +
        2.0*z_1106*z_20 + 4.0*z_1381*z_1080 + z_529*z_1390 + 2.0*z_1396*z_29 + 2.0*z_1396*z_26 + 4.0*z_1396*z_23 +
        2.0*z_1397*z_28 + 2.0*z_1397*z_21 + 2.0*z_197*z_1459 + 2.0*z_1401*z_69 + 2.0*z_10*z_1462 + 2.0*z_13*z_1463
        + z_506*z_1410 + 2.0*z_25*z_1142 + 2.0*z_22*z_1224 + 2.0*z_1522 + 2.0*z_1523 + 2.0*z_H*z_1526 +
        2.0*r_F*z_1527 + 2.0*z_255*z_1508 + 2.0*z_25*z_1147 + z_1423*z_22 + 2.0*z_25*z_1164 + 2.0*z_20*z_1169 +
        sin_theta*z_1479 + cos_theta*z_1481 + 2.0*z_1432*z_25 + z_1528 - 2.0*z_1520 - 2.0*z_1105*z_25 -
        2.0*z_1380*z_1096 - 4.0*z_1380*z_1077 - 2.0*z_1380*z_1099 - 2.0*z_1381*z_1097 - 2.0*z_1381*z_1184 -
        z_526*z_1393 - 4.0*z_1397*z_18 - 2.0*z_196*z_1458 - 2.0*z_1401*z_71 - 2.0*z_1402*z_77 - 2.0*z_1402*z_75 -
        z_504*z_1411 - 2.0*z_20*z_1143 - 2.0*z_16*z_1223 - 2.0*r_F*z_664 - 2.0*c_*z_666 - 2.0*z_53*z_1515 -
        2.0*c_*z_1516 - 2.0*z_257*z_1507 - 2.0*z_20*z_1148 - 2.0*z_793*z_688 - 2.0*z_795*z_682 - z_1425*z_16 -
        2.0*z_20*z_1165 - 2.0*z_278*z_1167 - 2.0*z_275*z_1166 - 2.0*z_25*z_1168 - 2.0*z_369*z_1171 -
        2.0*z_371*z_1170 - 2.0*z_1431*z_20 - z_1529) - z_1433*z_530));
    D[72] = z_5*z_1356 + sin_psi*z_1366 - z_7*z_1361 - cos_psi*z_1371;
    D[73] = z_7*z_1356 + z_5*z_1361 - cos_psi*z_1366 - sin_psi*z_1371;
    D[74] = 0.5*(2.0*z_744*z_188 + 2.0*cos_theta*z_1060 + 2.0*sin_theta*z_1061 + 2.0*z_188*z_1387 + z_449*z_1394 +
        z_452*z_1395 + z_451*z_1395 + 2.0*z_62*z_1350 + 2.0*z_222*z_1357 + 2.0*z_102*z_1351 + 2.0*z_237*z_1358 +
        2.0*z_14*z_1355 + 2.0*z_25*z_1046 + 2.0*z_1318*z_1348 + 2.0*z_1321*z_1348 + 2.0*z_125*z_1349 +
        2.0*z_250*z_1192 + 2.0*z_122*z_1349 + 2.0*z_248*z_1192 + 2.0*z_109*z_1356 + 2.0*z_108*z_1356 +
        2.0*z_241*z_1361 + 2.0*z_123*z_1369 + 2.0*z_184*z_1362 + 2.0*z_127*z_1367 + z_188*z_1434 - z_450*z_1394 -
        2.0*z_195*z_1360 - 2.0*z_20*z_1045 - 2.0*z_1319*z_1347 - 2.0*z_1320*z_1347 - 2.0*z_1238*z_1070 -
        2.0*z_1237*z_1067 - 2.0*z_1238*z_1069 - 2.0*z_1237*z_1066 - 2.0*z_242*z_1361 - 2.0*z_178*z_1363 -
        2.0*z_119*z_1368 - 2.0*z_181*z_1364 - z_1414*z_22 - z_1416*z_16 - sin_phi*z_1436 - z_971);
    const double z_1533 = z_37*z_1380;
    const double z_1534 = z_54*z_1381;
    D[75] = (-0.5)*(4.0*z_215*z_1379 + 4.0*z_218*z_1379 + 4.0*z_216*z_1379 + 4.0*z_25*z_1454 + 4.0*z_69*z_1533 +
        4.0*z_200*z_1380 + 4.0*z_212*z_1381 + 4.0*z_210*z_1381 + 4.0*z_20*z_1455 + 4.0*z_69*z_1383 + z_961*z_1394
        + 4.0*z_449*z_1487 + 4.0*z_623*z_1396 + 4.0*z_456*z_1396 + 4.0*z_455*z_1396 + 4.0*z_450*z_1488 +
        4.0*z_625*z_1396 + 4.0*z_622*z_1396 + 4.0*z_458*z_1397 + 4.0*z_618*z_1397 + 4.0*z_452*z_1457 +
        4.0*z_451*z_1457 + 4.0*z_449*z_1399 + 4.0*z_448*z_1356 + z_13*z_1395 + 2.0*z_963*z_1400 + 2.0*z_964*z_1400
        + 2.0*z_565*z_1401 + sin_theta*z_1416 + z_1328 - 4.0*z_219*z_1379 - 4.0*z_202*z_1380 - 4.0*z_203*z_1380 -
        4.0*z_71*z_1533 - 4.0*z_204*z_1380 - 4.0*z_201*z_1380 - 4.0*z_208*z_1381 - 4.0*z_209*z_1381 -
        4.0*z_77*z_1534 - 4.0*z_75*z_1534 - 4.0*z_211*z_1381 - 4.0*z_71*z_1383 - 4.0*z_75*z_1384 - 4.0*z_77*z_1384
        - 4.0*z_193*z_1385 - 2.0*z_780*z_1387 - z_962*z_1395 - 4.0*z_450*z_1487 - 4.0*z_452*z_1456 -
        4.0*z_451*z_1456 - 4.0*z_626*z_1396 - 4.0*z_449*z_1488 - 4.0*z_616*z_1397 - 4.0*z_619*z_1397 -
        4.0*z_457*z_1397 - 4.0*z_615*z_1397 - 4.0*z_452*z_1398 - 4.0*z_451*z_1398 - 4.0*z_450*z_1399 - z_10*z_1394
        - 2.0*z_73*z_1401 - 2.0*z_159*z_1401 - 2.0*z_563*z_1402 - 2.0*z_90*z_1402 - 2.0*z_160*z_1402 -
        2.0*z_16*z_1404 - 2.0*z_22*z_1405 - 2.0*z_167*z_1406 - cos_theta*z_1414 - 2.0*z_744*z_780 - z_780*z_1434);
    D[76] = (-0.5)*(4.0*z_1379*z_1324 + 4.0*z_1326*z_1379 + 4.0*z_1379*z_1327 + 4.0*z_22*z_1454 + 4.0*z_450*z_1533
        + 4.0*z_626*z_1380 + 4.0*z_458*z_1381 + 4.0*z_450*z_1383 + 4.0*z_71*z_1487 + 4.0*z_202*z_1396 +
        4.0*z_204*z_1396 + 4.0*z_1396*z_968 + 4.0*z_69*z_1488 + 4.0*z_203*z_1396 + 4.0*z_210*z_1397 +
        4.0*z_77*z_1457 + 4.0*z_75*z_1457 + 4.0*z_761*z_1359 + 4.0*z_1458*z_764 + 4.0*z_1458*z_337 +
        4.0*z_45*z_1459 + 4.0*z_1459*z_762 + 4.0*z_71*z_1399 + 4.0*z_10*z_1489 + z_311*z_1395 + 2.0*z_970*z_1400 +
        2.0*z_113*z_1401 + 2.0*z_463*z_1402 + 2.0*z_173*z_1462 + 2.0*z_263*z_1462 + 2.0*z_170*z_1463 +
        2.0*z_261*z_1463 + 2.0*z_20*z_1404 + z_1436 - 4.0*z_1325*z_1379 - 4.0*z_449*z_1533 - 4.0*z_456*z_1380 -
        4.0*z_455*z_1380 - 4.0*z_16*z_1455 - 4.0*z_451*z_1534 - 4.0*z_619*z_1381 - 4.0*z_457*z_1381 -
        4.0*z_452*z_1534 - 4.0*z_449*z_1383 - 4.0*z_452*z_1384 - 4.0*z_451*z_1384 - z_505*z_1394 - z_503*z_1395 -
        4.0*z_77*z_1456 - 4.0*z_69*z_1487 - 4.0*z_75*z_1456 - 4.0*z_71*z_1488 - 4.0*z_208*z_1397 -
        4.0*z_209*z_1397 - 4.0*z_1397*z_967 - 4.0*z_760*z_1359 - 4.0*z_58*z_1458 - 4.0*z_57*z_1458 -
        4.0*z_49*z_1459 - 4.0*z_1459*z_336 - 4.0*z_77*z_1398 - 4.0*z_69*z_1399 - 4.0*z_75*z_1398 - 4.0*z_13*z_1460
        - z_314*z_1394 - 2.0*z_969*z_1400 - 2.0*z_462*z_1401 - 2.0*z_116*z_1402 - 2.0*z_342*z_1461 -
        2.0*z_344*z_1461 - 2.0*z_25*z_1405 - 2.0*z_345*z_1464 - 2.0*z_349*z_1464);
    const double z_1535 = z_520*z_677 + 2.0*(sin_delta*z_510 + 0.5*z_523*z_43);
    D[77] = (-0.5)*(4.0*z_1380*z_1329 + 4.0*z_1380*z_1331 + 4.0*z_1380*z_1333 + 4.0*z_1380*z_1334 +
        4.0*z_1380*z_1336 + 4.0*z_1381*z_1337 + 4.0*z_1381*z_1342 + 4.0*z_1381*z_1343 + 2.0*z_1386*z_909 +
        2.0*z_1386*z_911 + 4.0*z_1396*z_983 + 4.0*z_1396*z_993 + 4.0*z_1396*z_982 + 4.0*z_1396*z_981 +
        4.0*z_1396*z_980 + 4.0*z_1396*z_979 + 4.0*z_1397*z_986 + 4.0*z_1397*z_984 + 4.0*z_1458*z_991 +
        4.0*z_1458*z_977 + 4.0*z_1458*z_976 + 4.0*z_1459*z_972 + 2.0*z_826*z_1401 + 2.0*z_822*z_1402 +
        2.0*z_823*z_1402 + 2.0*z_732*z_1463 + 2.0*z_734*z_1463 + sin_tilt*z_1410 + cos_tilt*z_1411 + z_1008*z_1435
        + z_1229*z_1509 + z_1229*z_1510 + z_1535 - 4.0*z_1380*z_1330 - 4.0*z_1380*z_1332 - 4.0*z_1380*z_1335 -
        4.0*z_1381*z_1338 - 4.0*z_1381*z_1339 - 4.0*z_1381*z_1340 - 4.0*z_1381*z_1341 - 4.0*z_1381*z_1344 -
        4.0*z_1396*z_994 - 4.0*z_1396*z_992 - 4.0*z_1397*z_997 - 4.0*z_1397*z_996 - 4.0*z_1397*z_995 -
        4.0*z_1397*z_985 - 4.0*z_1397*z_975 - 4.0*z_1397*z_974 - 4.0*z_1458*z_990 - 4.0*z_1459*z_989 -
        4.0*z_1459*z_973 - 4.0*z_1459*z_987 - 2.0*z_825*z_1401 - 2.0*z_827*z_1401 - 2.0*z_821*z_1402 -
        2.0*z_736*z_1462 - 2.0*z_738*z_1462);
    D[79] = -F_yy*z_1407;
    const double z_1536 = z_821 - z_822 - z_823;
    const double z_1537 = z_825 + z_827 - z_826;
    const double z_1538 = z_136*z_1536 + z_133*z_1537;
    const double z_1539 = z_135*z_1536 + z_132*z_1537;
    const double z_1540 = z_1538 + z_1539;
    const double z_1541 = z_736 + z_738;
    const double z_1542 = z_732 + z_734;
    const double z_1543 = z_136*z_1541 - z_133*z_1542;
    const double z_1544 = z_132*z_1542 - z_135*z_1541;
    const double z_1545 = z_1543 - z_1544;
    const double z_1546 = z_1541*z_1023 - z_1542*z_1024;
    const double z_1547 = z_1541*z_1028 - z_1542*z_1027;
    const double z_1548 = z_1546 + z_1547;
    const double z_1549 = z_1536*z_1023 + z_1537*z_1024;
    const double z_1550 = z_1537*z_1027 + z_1536*z_1028;
    const double z_1551 = z_1549 + z_1550;
    const double z_1552 = z_140*z_255;
    const double z_1553 = z_138*z_257;
    D[82] = cos_psi*(z_484*z_1540 + z_485*z_1545 + y_ddot*z_1553 + x_ddot*z_144 - x_dot*z_1548 - y_dot*z_1551 -
        y_ddot*z_1552 - z_1196*z_139 - z_1196*z_141) - sin_psi*(z_485*z_1540 + y_dot*z_1548 + z_1195*z_141 +
        z_1195*z_139 + x_ddot*z_1553 - z_484*z_1545 - x_dot*z_1551 - y_ddot*z_144 - x_ddot*z_1552);
    const double z_1554 = z_1003 + z_1001 - z_1002;
    const double z_1555 = z_998 - z_999 - z_1000;
    const double z_1556 = z_133*z_1554 + z_136*z_1555;
    const double z_1557 = z_132*z_1554 + z_135*z_1555;
    const double z_1558 = z_1556 + z_1557;
    const double z_1559 = z_H*z_1556 + r_F*z_1557;
    const double z_1560 = z_53*z_1556 + c_*z_1557;
    const double z_1561 = 2.0*z_1391 + sin_tilt*H_xx + sin_tilt*z_519;
    const double z_1562 = 2.0*z_1388 + cos_tilt*H_zz + cos_tilt*z_522;
    const double z_1563 = z_54*z_1561 + z_44*z_1562;
    const double z_1564 = z_44*z_1561 + z_37*z_1562;
    const double z_1565 = z_53*z_1538 + c_*z_1539;
    const double z_1566 = z_H*z_1538 + r_F*z_1539;
    const double z_1567 = (psi_dot*z_1543 - psi_dot*z_1544) + z_1548;
    const double z_1568 = (z_1543*z_1175 - z_1544*z_1176) + (z_53*z_1546 + c_*z_1547);
    const double z_1569 = (z_1543*z_1172 - z_1544*z_1173) + (z_H*z_1546 + r_F*z_1547);
    const double z_1570 = z_1567;
    const double z_1571 = z_1008 + z_1006 + z_1007;
    const double z_1572 = z_1012 - z_1013 - z_1014;
    const double z_1573 = z_1009 - z_1010 - z_1011;
    const double z_1574 = 2.0*H_xz*z_1572 - z_567*z_1573;
    const double z_1575 = 2.0*H_xz*z_1573 - z_570*z_1572;
    const double z_1576 = z_1561*z_33 - z_42*z_1562;
    const double z_1577 = z_523*z_731 + z_520*z_733 + 2.0*z_1571*z_553 + z_44*z_1575 - 2.0*z_510*z_677 -
        z_54*z_1574 - z_39*z_1576;
    const double z_1578 = z_42*z_1561 - z_1562*z_36;
    const double z_1579 = z_523*z_737 + z_520*z_731 + 2.0*z_1571*z_535 + z_44*z_1574 - 2.0*z_510*z_43 -
        z_37*z_1575 - z_39*z_1578;
    const double z_1580 = z_668*z_1495 - z_670*z_1494;
    const double z_1581 = z_1300*z_695 + z_1494*z_703 + z_1155*z_1004 + z_636*(z_1300*z_707 + z_1300*z_708 +
        z_1494*z_716 + z_1156*z_1004 - z_1299*z_709 - z_1299*z_710 - z_1495*z_714 - z_1495*z_715 - z_1494*z_717 -
        z_161*z_1156 - z_1156*z_1005) - z_1299*z_697 - z_1495*z_702 - z_161*z_1155 - z_1155*z_1005;
    const double z_1582 = 2.0*z_1388 + cos_tilt*z_570;
    const double z_1583 = 2.0*z_646*z_1299 + 2.0*z_658*z_1495 - psi_ddot*z_1582;
    const double z_1584 = 2.0*z_1391 + sin_tilt*z_567;
    const double z_1585 = 2.0*z_646*z_1300 + 2.0*z_658*z_1494 - psi_ddot*z_1584;
    const double z_1586 = z_731*z_688 + z_733*z_682;
    const double z_1587 = z_731*z_682 + z_737*z_688;
    const double z_1588 = psi_dot*z_1549 + z_136*z_1587 - z_133*z_1586;
    const double z_1589 = psi_dot*z_1550 + z_135*z_1587 - z_132*z_1586;
    const double z_1590 = z_640*z_1495 - z_H*z_1588 - r_F*z_1589;
    const double z_1591 = z_640*z_1494 - z_53*z_1588 - c_*z_1589;
    const double z_1592 = cos_tilt*z_1561 - sin_tilt*z_1562;
    const double z_1593 = sin_delta*z_1592;
    const double z_1594 = z_1048*z_33 - z_42*z_1047;
    const double z_1595 = z_1047*z_36 - z_42*z_1048;
    const double z_1596 = r_F*z_36;
    const double z_1597 = z_1596 - c_*z_42;
    const double z_1598 = z_1597*lambda_0;
    const double z_1599 = c_*z_33;
    const double z_1600 = z_1599 - z_42*r_F;
    const double z_1601 = z_1600*lambda_0;
    const double z_1602 = 2.0*z_1571*z_559 + z_1574*z_84 + z_1575*z_47 + z_1535 - z_1592*z_326;
    const double z_1603 = z_1600*lambda_4;
    const double z_1604 = z_1597*lambda_4;
    const double z_1605 = y_ddot*z_406;
    const double z_1606 = y_ddot*z_383;
    const double z_1607 = x_ddot*z_315;
    const double z_1608 = x_ddot*z_312;
    const double z_1609 = z_1588 + z_1589;
    D[83] = (-0.5)*(sin_phi*(2.0*z_1103*z_772 + 2.0*z_1104*z_771 + 2.0*z_1106*z_677 + 2.0*z_1559*z_757 +
        2.0*z_1559*z_333 + 2.0*z_1559*z_331 + 2.0*z_1559*z_332 + 2.0*z_229*z_1559 + 2.0*z_1560*z_754 +
        4.0*z_1560*z_755 + 2.0*z_1560*z_328 + 4.0*z_225*z_1560 + 2.0*z_224*z_1560 + 2.0*z_1560*z_329 +
        2.0*z_1560*z_330 + 4.0*z_1560*z_756 + 2.0*z_334*z_1558 + z_1563*z_576 + 4.0*z_582*z_1540 +
        4.0*z_1565*z_585 + 4.0*z_1565*z_277 + 2.0*z_1566*z_589 + 4.0*z_1566*z_590 + 4.0*z_1566*z_279 +
        2.0*z_1566*z_592 + 2.0*z_1043*z_43 + 2.0*z_1567*z_599 + 2.0*z_1567*z_600 + 2.0*z_65*z_1569 + z_1577*z_632
        + 2.0*z_1144*z_700 + 2.0*sin_theta*z_677*z_1222 + 2.0*z_43*z_1147 + 2.0*z_1581*z_723 +
        2.0*cos_delta*x_ddot*z_288 + 2.0*z_1591*z_84 - 2.0*z_736*z_1103 - 2.0*z_732*z_1104 - 2.0*z_1105*z_43 -
        2.0*z_750*z_1558 - 2.0*z_752*z_1558 - 2.0*z_753*z_1558 - 2.0*z_751*z_1558 - 2.0*z_231*z_1559 -
        4.0*z_1559*z_758 - 4.0*z_230*z_1559 - 4.0*z_1559*z_759 - 2.0*z_226*z_1560 - z_1564*z_580 -
        4.0*z_581*z_1540 - 2.0*z_1565*z_584 - 4.0*z_1565*z_276 - 4.0*z_1565*z_586 - 2.0*z_1565*z_587 -
        4.0*z_1566*z_591 - 4.0*z_1566*z_280 - 2.0*z_1044*z_677 - 2.0*z_1568*z_282 - 2.0*z_1568*z_283 -
        2.0*z_86*z_1568 - 2.0*z_1569*z_285 - 2.0*z_1569*z_286 - 2.0*z_1570*z_607 - z_1579*z_634 -
        2.0*cos_delta*z_1580 - 2.0*cos_theta*z_43*z_1222 - 2.0*z_677*z_1148 - 2.0*z_1581*z_722 - z_173*z_1583 -
        z_263*z_1583 - z_170*z_1585 - z_261*z_1585 - 2.0*cos_delta*y_ddot*z_474 - 2.0*z_1590*z_47 - z_561*z_1593 -
        2.0*z_1594*z_255 - 2.0*z_1595*z_257 - 2.0*z_257*z_1598 - 2.0*z_255*z_1601) - cos_phi*(2.0*z_1103*z_677 +
        2.0*z_732*z_1105 + 2.0*z_736*z_1106 + 4.0*z_582*z_1558 + 4.0*z_1559*z_590 + 4.0*z_1559*z_279 +
        2.0*z_1559*z_589 + 2.0*z_1559*z_592 + 4.0*z_1560*z_585 + 4.0*z_1560*z_277 + 2.0*z_750*z_1540 +
        2.0*z_751*z_1540 + 2.0*z_752*z_1540 + 2.0*z_753*z_1540 + 2.0*z_226*z_1565 + 2.0*z_231*z_1566 +
        4.0*z_230*z_1566 + 4.0*z_1566*z_758 + 4.0*z_1566*z_759 + 2.0*z_1044*z_772 + 2.0*cos_delta*z_1049 +
        2.0*z_1043*z_771 + 2.0*z_761*z_1567 + 2.0*z_1568*z_762 + 2.0*z_45*z_1568 + 2.0*z_1568*z_763 +
        2.0*z_1569*z_764 + 2.0*z_1569*z_337 + psi_dot*z_1602 + 2.0*z_255*z_1603 + 2.0*z_257*z_1604 +
        2.0*z_1580*z_723 + 2.0*cos_delta*z_1144*lambda_0 + 2.0*z_1147*z_771 + 2.0*z_1148*z_772 +
        2.0*cos_delta*z_1581 + z_1585*z_84 + 2.0*z_257*z_1605 + 2.0*z_255*z_1606 + 2.0*z_342*z_1609 +
        2.0*z_344*z_1609 + 2.0*z_173*z_1590 + 2.0*z_263*z_1590 + 2.0*z_170*z_1591 + 2.0*z_261*z_1591 -
        2.0*z_1104*z_43 - 2.0*z_1105*z_771 - 2.0*z_1106*z_772 - 4.0*z_581*z_1558 - 4.0*z_1559*z_591 -
        4.0*z_1559*z_280 - 2.0*z_1560*z_584 - 4.0*z_1560*z_276 - 4.0*z_1560*z_586 - 2.0*z_1560*z_587 -
        z_1563*z_748 - z_1564*z_749 - 2.0*z_1565*z_754 - 4.0*z_225*z_1565 - 2.0*z_224*z_1565 - 4.0*z_1565*z_755 -
        2.0*z_1565*z_328 - 2.0*z_1565*z_329 - 2.0*z_1565*z_330 - 4.0*z_1565*z_756 - 2.0*z_1566*z_757 -
        2.0*z_229*z_1566 - 2.0*z_1566*z_331 - 2.0*z_1566*z_332 - 2.0*z_1566*z_333 - 2.0*z_334*z_1540 -
        2.0*z_1044*z_736 - 2.0*z_1043*z_732 - 2.0*z_760*z_1567 - 2.0*z_49*z_1568 - 2.0*z_1568*z_336 -
        2.0*z_58*z_1569 - 2.0*z_57*z_1569 - 2.0*z_1569*z_765 - 2.0*z_1580*z_722 - 2.0*sin_delta*z_1222 -
        2.0*z_732*z_1147 - 2.0*z_736*z_1148 - z_1583*z_47 - 2.0*z_255*z_1607 - 2.0*z_257*z_1608 -
        2.0*r_R*z_1609));
    const double z_1610 = cos_phi*z_1103;
    const double z_1611 = cos_phi*z_1104;
    const double z_1612 = z_1559*z_40;
    const double z_1613 = z_1560*z_55;
    const double z_1614 = r_R*z_1540;
    const double z_1615 = z_37*z_1566;
    const double z_1616 = z_H*z_1543 - r_F*z_1544;
    const double z_1617 = z_53*z_1543 - c_*z_1544;
    const double z_1618 = psi_dot*z_1538 + psi_dot*z_1539 + z_1551;
    const double z_1619 = (z_1538*z_1172 + z_1539*z_1173) + (z_H*z_1549 + r_F*z_1550);
    const double z_1620 = (z_1538*z_1175 + z_1539*z_1176) + (z_53*z_1549 + c_*z_1550);
    const double z_1621 = sin_delta*z_1600;
    const double z_1622 = z_1228*phi_ddot;
    const double z_1623 = z_670*z_1300 - z_668*z_1299;
    const double z_1624 = cos_tilt*z_133 - sin_tilt*z_136;
    const double z_1625 = cos_tilt*z_132 - sin_tilt*z_135;
    const double z_1626 = z_1624 + z_1625;
    const double z_1627 = z_H*z_1624 + r_F*z_1625;
    const double z_1628 = cos_delta*phi_ddot;
    const double z_1629 = z_1627*z_1628;
    const double z_1630 = z_821*psi_ddot - z_822*psi_ddot - z_43*z_819;
    const double z_1631 = z_825*psi_ddot + z_677*z_819 - z_826*psi_ddot;
    const double z_1632 = psi_dot*z_1546 - z_136*z_1630 - z_133*z_1631;
    const double z_1633 = psi_dot*z_1547 - z_135*z_1630 - z_132*z_1631;
    const double z_1634 = 2.0*z_640*z_1300 + 2.0*z_53*z_1632 + 2.0*c_*z_1633 + phi_ddot*z_1584;
    const double z_1635 = z_1632 + z_1633;
    const double z_1636 = z_53*z_1624 + c_*z_1625;
    const double z_1637 = z_1636*z_1628;
    const double z_1638 = 2.0*z_640*z_1299 + 2.0*z_H*z_1632 + 2.0*r_F*z_1633 + phi_ddot*z_1582;
    const double z_1639 = 2.0*z_1637 - z_1638;
    const double z_1640 = z_52*z_1540;
    const double z_1641 = z_54*z_1565;
    const double z_1642 = sin_delta*z_1597;
    const double z_1643 = z_1280*phi_ddot;
    const double z_1644 = 2.0*z_1629 + z_1634;
    D[84] = 0.5*(sin_theta*(2.0*z_1452*z_733 + 2.0*z_731*z_1610 + 2.0*z_1105*z_814 + 2.0*z_1558*z_1200 +
        2.0*z_1098*z_1558 + 4.0*z_1201*z_1558 + 4.0*z_66*z_1612 + 4.0*z_1559*z_1207 + 2.0*z_1560*z_1208 +
        z_1564*z_747 + 4.0*z_784*z_1540 + 2.0*z_1565*z_361 + 4.0*z_1565*z_786 + 2.0*z_1565*z_362 +
        2.0*z_1566*z_788 + 4.0*z_1566*z_790 + 2.0*z_3*z_1615 + 2.0*z_368*z_1615 + 2.0*z_1616*z_370 +
        2.0*z_1617*z_95 + 4.0*z_1617*z_796 + 2.0*z_1617*z_797 + 2.0*z_1044*z_812 + 2.0*z_1440*z_733 +
        2.0*z_1568*z_800 + 2.0*z_1568*z_374 + 2.0*z_1568*z_375 + 2.0*z_1569*z_376 + 2.0*z_1569*z_377 +
        2.0*z_1619*z_379 + 2.0*z_1620*z_55 + 2.0*z_1620*z_381 + phi_dot*z_1577 + z_1579*z_780 + 2.0*z_563*z_1580 +
        2.0*z_823*z_1222 + 2.0*z_1229*z_1622 + 2.0*cos_delta*z_297*z_1626 + 2.0*z_1148*z_812 + 2.0*z_731*z_1471 +
        2.0*z_63*z_1581 + z_1583*z_391 + z_1585*z_365 + 2.0*z_161*z_1608 + z_54*z_1634 + 2.0*z_1595*z_978 +
        2.0*z_978*z_1598 - 2.0*z_1453*z_731 - 2.0*z_737*z_1611 - 2.0*z_1106*z_812 - 2.0*z_1559*z_1202 -
        2.0*z_1559*z_1203 - 2.0*z_1559*z_1205 - 4.0*z_1559*z_1206 - 4.0*z_779*z_1613 - 2.0*z_1560*z_1210 -
        4.0*z_1560*z_1211 - 2.0*z_1560*z_1212 - 4.0*z_1560*z_1213 - z_1563*z_781 - 2.0*z_368*z_1614 -
        2.0*z_3*z_1614 - 2.0*z_1565*z_785 - 4.0*z_1565*z_787 - 4.0*z_1565*z_364 - 4.0*z_1566*z_789 -
        4.0*z_1566*z_366 - 2.0*z_792*z_1545 - 2.0*z_1616*z_82 - 4.0*z_1616*z_794 - z_1564*z_17 - 2.0*z_1043*z_814
        - 2.0*z_1441*z_731 - 2.0*z_1567*z_799 - 2.0*z_193*z_1567 - 2.0*z_1569*z_801 - 2.0*z_1618*z_805 -
        2.0*z_1619*z_48 - 2.0*z_161*z_1604 - 2.0*lambda_3*z_1621 - 2.0*z_1623*z_84 - 2.0*z_37*z_1629 -
        2.0*z_1147*z_814 - 2.0*z_733*z_1470 - 2.0*z_161*z_1605 - 2.0*z_315*z_1195 - 2.0*z_383*z_1196 -
        2.0*z_52*z_1635 - z_44*z_1639 - 2.0*z_107*z_1609 - 2.0*z_1590*z_400 - 2.0*z_1591*z_360) -
        cos_theta*(2.0*z_1452*z_731 + 2.0*z_731*z_1611 + 2.0*z_1106*z_852 + 2.0*z_1558*z_1271 + 2.0*z_1558*z_1273
        + 2.0*z_1559*z_1208 + 4.0*z_779*z_1612 + 4.0*z_1559*z_1274 + 4.0*z_1560*z_1206 + 4.0*z_66*z_1613 +
        z_1563*z_747 + z_1564*z_781 + 2.0*z_1565*z_840 + 4.0*z_1565*z_789 + 2.0*z_368*z_1641 + 4.0*z_1565*z_366 +
        2.0*z_3*z_1641 + 4.0*z_1565*z_842 + 2.0*z_1566*z_361 + 2.0*z_1566*z_362 + 4.0*z_1566*z_412 +
        2.0*z_844*z_1545 + 4.0*z_1616*z_796 + 2.0*z_1617*z_82 + 2.0*z_1043*z_812 + 2.0*z_1440*z_731 +
        2.0*z_1567*z_847 + 2.0*z_1568*z_413 + 2.0*z_1569*z_800 + 2.0*z_1569*z_375 + 2.0*z_1619*z_381 +
        2.0*z_1620*z_48 + 2.0*z_1620*z_415 + phi_dot*z_1579 + 2.0*lambda_3*z_1642 + 2.0*z_1229*z_1643 +
        2.0*z_52*z_1626*z_1628 + 2.0*z_1147*z_812 + 2.0*z_737*z_1471 + z_1583*z_365 + z_1585*z_363 +
        2.0*z_312*z_1195 + 2.0*z_161*z_1607 + 2.0*z_406*z_1196 + 2.0*r_R*z_1635 + 2.0*z_1594*z_978 +
        2.0*z_978*z_1601 - 2.0*z_1453*z_737 - 2.0*z_733*z_1610 - 2.0*z_1105*z_812 - 4.0*z_1272*z_1558 -
        4.0*z_1559*z_1211 - 2.0*z_1559*z_1212 - 2.0*z_1559*z_1210 - 2.0*z_1560*z_1275 - 2.0*z_1560*z_1276 -
        4.0*z_1560*z_1207 - 2.0*z_1560*z_1277 - 2.0*z_368*z_1640 - 2.0*z_3*z_1640 - 4.0*z_839*z_1540 -
        2.0*z_1566*z_785 - 4.0*z_1566*z_787 - 4.0*z_1566*z_843 - 2.0*z_1616*z_80 - 2.0*z_1616*z_845 -
        2.0*z_1617*z_370 - 4.0*z_1617*z_846 - z_1563*z_17 - 2.0*z_1044*z_852 - 2.0*z_1441*z_737 - 2.0*z_1567*z_848
        - 2.0*z_1568*z_849 - 2.0*z_1568*z_376 - 2.0*z_1569*z_414 - 2.0*z_1618*z_850 - 2.0*z_1619*z_40 -
        z_1577*z_780 - 2.0*z_161*z_1603 - 2.0*z_565*z_1580 - 2.0*z_827*z_1222 - 2.0*z_1623*z_47 - 2.0*z_54*z_1637
        - 2.0*z_731*z_1470 - 2.0*z_1148*z_852 - 2.0*z_85*z_1581 - 2.0*z_161*z_1606 - z_44*z_1644 - z_37*z_1638 -
        2.0*z_1609*z_418 - 2.0*z_1590*z_360 - 2.0*z_1591*z_385));
    const double z_1645 = z_451*z_1072;
    const double z_1646 = z_452*z_1072;
    const double z_1647 = z_13*z_1450;
    const double z_1648 = z_10*z_1450;
    const double z_1649 = z_13*z_1442;
    const double z_1650 = z_449*z_1059;
    const double z_1651 = z_450*z_1059;
    const double z_1652 = z_10*z_1442;
    const double z_1653 = (z_1068*z_955 - z_1071*z_956) + (z_1072*z_934 - z_1059*z_935);
    const double z_1654 = z_42*z_1059;
    const double z_1655 = z_42*z_1072;
    const double z_1656 = z_1071*z_36;
    const double z_1657 = z_42*z_1071;
    const double z_1658 = z_1068*z_33;
    const double z_1659 = z_42*z_1068;
    const double z_1660 = z_1600*z_20;
    const double z_1661 = z_1597*z_25;
    const double z_1662 = z_42*(c_*z_16 + r_F*z_22) - z_1599*z_22 - sin_phi*z_645 - z_1596*z_16;
    const double z_1663 = z_506*z_1578;
    const double z_1664 = z_504*z_1576;
    const double z_1665 = (((z_1068*z_898 - z_1068*z_899) - (z_1068*z_900 - z_1071*z_901)) - ((z_1071*z_902 -
        z_1071*z_903) - (z_1072*z_859 - z_1072*z_857))) + (((z_1072*z_894 + z_1059*z_863) - (z_1059*z_862 +
        z_1059*z_895)) + ((z_1450*z_904 + z_1450*z_905) - (z_1442*z_906 + z_1442*z_907)));
    const double z_1666 = z_1298 + z_645*z_867 - z_645*z_868;
    const double z_1667 = z_133*z_33 - z_42*z_136;
    const double z_1668 = z_132*z_33 - z_42*z_135;
    const double z_1669 = z_136*z_36 - z_42*z_133;
    const double z_1670 = z_135*z_36 - z_42*z_132;
    D[85] = 0.5*(cos_delta*(2.0*z_42*z_1649 + 2.0*z_1519*z_36 + 2.0*z_42*z_1511 + 2.0*z_42*z_1648 +
        2.0*z_1520*z_33 + 2.0*z_1650*z_33 + 2.0*z_452*z_1654 + 2.0*z_451*z_1654 + 2.0*z_1521*z_36 +
        2.0*z_450*z_1655 + 2.0*z_71*z_1656 + 2.0*z_1105*z_924 + 2.0*z_77*z_1658 + 2.0*z_75*z_1658 +
        2.0*z_1106*z_925 + 2.0*z_69*z_1659 + 4.0*z_1559*z_1285 + 2.0*z_1559*z_1288 + 2.0*z_1559*z_1289 +
        4.0*z_1560*z_1290 + 4.0*z_1560*z_1291 + 4.0*z_1560*z_1293 + 4.0*z_1565*z_881 + 4.0*z_1566*z_884 +
        2.0*z_1566*z_885 + 4.0*z_1566*z_886 + 4.0*z_1566*z_888 + 2.0*z_1566*z_889 + 4.0*z_1616*z_891 +
        4.0*z_1617*z_893 + 2.0*z_1568*z_899 + 2.0*z_1568*z_900 + 2.0*z_1569*z_902 + 2.0*z_1619*z_904 +
        2.0*z_1619*z_905 + z_1574*z_912 + z_1575*z_913 + 2.0*lambda_4*z_1660 + 2.0*lambda_4*z_1661 +
        2.0*z_1600*z_666 + 2.0*z_1580*z_920 + 2.0*z_1662*lambda_0 + 2.0*theta_ddot*z_1503 + 2.0*z_1522*z_36 +
        2.0*z_1623*z_922 + 2.0*z_1623*z_923 + 2.0*z_688*z_927 + 2.0*z_1147*z_928 + 2.0*z_1148*z_929 +
        2.0*z_682*z_931 + 2.0*z_1581*z_867 + z_1585*z_864 + 2.0*y_ddot*z_479 + 2.0*y_ddot*z_480 + 2.0*z_315*z_1166
        + 2.0*z_383*z_1170 + 2.0*z_1591*z_429 + delta_dot*z_1663 + delta_dot*z_1664 + 2.0*z_1653 -
        ((2.0*z_1071*z_71 + z_1529 - 2.0*z_1071*z_69 - 2.0*z_1645 - 2.0*z_1646 - 2.0*z_1647)*z_36 +
        z_42*(2.0*z_1068*z_69 + 2.0*z_450*z_1072 + 2.0*z_451*z_1059 + 2.0*z_452*z_1059 + 2.0*z_1648 + 2.0*z_1649 +
        z_1532 + z_1517 - 2.0*z_1068*z_71 - 2.0*z_1071*z_77 - 2.0*z_1071*z_75 - 2.0*z_449*z_1072) +
        (2.0*z_1068*z_77 + 2.0*z_1068*z_75 + 2.0*z_1650 + z_1528 - 2.0*z_1651 - 2.0*z_1652)*z_33 + 2.0*z_1653 -
        2.0*z_501*z_510) - 2.0*z_1518*z_33 - 2.0*z_1652*z_33 - 2.0*z_42*z_1530 - 2.0*z_1647*z_36 - 2.0*z_1651*z_33
        - 2.0*z_42*z_1531 - 2.0*z_1646*z_36 - 2.0*z_1645*z_36 - 2.0*z_42*z_1512 - 2.0*z_449*z_1655 -
        2.0*z_1105*z_928 - 2.0*z_69*z_1656 - 2.0*z_77*z_1657 - 2.0*z_75*z_1657 - 2.0*z_1106*z_929 -
        2.0*z_71*z_1659 - 4.0*z_1559*z_1284 - 4.0*z_1559*z_1286 - 4.0*z_1559*z_1287 - 2.0*z_1560*z_1292 -
        4.0*z_1560*z_1294 - 2.0*z_1560*z_1295 - 4.0*z_1565*z_878 - 2.0*z_1565*z_879 - 4.0*z_1565*z_880 -
        4.0*z_1565*z_882 - 2.0*z_1565*z_883 - 4.0*z_1566*z_887 - 4.0*z_1616*z_890 - 4.0*z_1617*z_892 -
        2.0*z_1568*z_898 - 2.0*z_1569*z_901 - 2.0*z_1569*z_903 - 2.0*z_1620*z_906 - 2.0*z_1620*z_907 -
        2.0*z_1571*z_909 - 2.0*z_1571*z_911 - 2.0*z_1597*z_664 - 2.0*z_1580*z_921 - 2.0*theta_ddot*z_1499 -
        2.0*z_1523*z_33 - z_1506*theta_ddot - 4.0*z_255*z_1643 - 4.0*z_257*z_1622 - 2.0*z_1147*z_924 -
        2.0*z_1148*z_925 - 2.0*z_682*z_926 - 2.0*z_688*z_930 - 2.0*z_1581*z_868 - z_1583*z_860 - 2.0*z_312*z_1167
        - 2.0*x_ddot*z_423 - 2.0*x_ddot*z_424 - 2.0*z_406*z_1171 - 2.0*z_1590*z_428 - z_189*z_1592) +
        sin_delta*(2.0*z_1104*z_860 + 2.0*z_1105*z_428 + 2.0*z_1559*z_1306 + 4.0*z_1559*z_1308 + 2.0*z_1560*z_1309
        + 2.0*z_1565*z_945 + 4.0*z_1565*z_946 + 2.0*z_1566*z_949 + 2.0*z_1617*z_953 + 2.0*z_1617*z_954 +
        2.0*z_1568*z_955 + 2.0*cos_phi*z_1580 + 2.0*sin_tilt*z_1245 + 2.0*z_1148*z_429 + 2.0*z_474*z_1256 +
        z_42*(2.0*z_1559*z_1096 + 4.0*z_1559*z_1077 + 2.0*z_1559*z_1099 + 2.0*z_1560*z_1097 + 2.0*z_1560*z_1184 +
        z_1561*z_529 + z_1562*z_526 + 4.0*z_1566*z_18 + 2.0*z_197*z_1617 + 2.0*z_1568*z_69 + sin_theta*z_1644 +
        cos_theta*z_1639 + 2.0*z_1590*z_20 + 2.0*z_1591*z_25 - 4.0*z_1560*z_1080 - 2.0*z_1565*z_29 -
        2.0*z_1565*z_26 - 4.0*z_1565*z_23 - 2.0*z_1566*z_28 - 2.0*z_1566*z_21 - 2.0*z_196*z_1616 - 2.0*z_1568*z_71
        - 2.0*z_1569*z_77 - 2.0*z_1569*z_75 - 2.0*z_10*z_1619 - 2.0*z_13*z_1620 - z_506*z_1574 - z_504*z_1575 -
        z_1583*z_22 - z_1585*z_16 - 2.0*(z_H*z_1669 + r_F*z_1670 - z_53*z_1667 - c_*z_1668)*z_1231) + z_1592*z_871
        + 2.0*z_1665 - (2.0*z_506*z_897 + 2.0*z_504*z_896 + z_520*z_912 + z_523*z_913 + 2.0*z_1043*z_428 +
        2.0*sin_phi*z_1049 + 2.0*z_1665 - 2.0*z_1044*z_429) - 2.0*z_1103*z_864 - 2.0*z_1106*z_429 -
        2.0*z_1559*z_1307 - 2.0*z_1560*z_1310 - 4.0*z_1560*z_1311 - 2.0*z_1565*z_943 - 2.0*z_1566*z_947 -
        4.0*z_1566*z_950 - 2.0*z_1616*z_951 - 2.0*z_1616*z_952 - 2.0*z_1569*z_956 - 2.0*z_1571*z_957 -
        2.0*lambda_4*z_1301 - 2.0*z_1666*lambda_0 - 2.0*cos_tilt*z_1243 - 2.0*z_428*z_1147 - 2.0*sin_phi*z_1581 -
        2.0*z_288*z_1257 - (2.0*z_1559*z_1097 + 2.0*z_1559*z_1184 + z_1562*z_529 + 2.0*z_197*z_1616 +
        2.0*z_1569*z_69 + z_506*z_1575 + 2.0*cos_delta*z_293*z_1627 + sin_theta*z_1638 + 2.0*z_1590*z_25 +
        2.0*(z_H*z_1667 + r_F*z_1668)*z_1231 - 4.0*z_1559*z_1080 - 2.0*z_1566*z_26 - 2.0*z_1566*z_29 -
        4.0*z_1566*z_23 - 2.0*z_1569*z_71 - 2.0*z_13*z_1619 - z_1583*z_16)*z_36 - (2.0*z_1560*z_1099 +
        4.0*z_1560*z_1077 + 2.0*z_1560*z_1096 + z_1561*z_526 + 4.0*z_1565*z_18 + z_504*z_1574 +
        2.0*cos_delta*z_295*z_1636 + 2.0*z_1591*z_20 - 2.0*z_1565*z_28 - 2.0*z_1565*z_21 - 2.0*z_196*z_1617 -
        2.0*z_1568*z_77 - 2.0*z_1568*z_75 - 2.0*z_10*z_1620 - z_1585*z_22 - cos_theta*z_1634 - 2.0*(z_53*z_1669 +
        c_*z_1670)*z_1231)*z_33));
    D[88] = z_5*z_1540 + z_7*z_1545 - sin_psi*z_1548 - cos_psi*z_1551;
    D[89] = z_7*z_1540 + cos_psi*z_1548 - z_5*z_1545 - sin_psi*z_1551;
    D[90] = (-0.5)*(z_450*z_1563 + z_452*z_1564 + z_451*z_1564 + 2.0*z_222*z_1543 + 2.0*z_1318*z_1537 +
        2.0*z_1319*z_1536 + 2.0*z_1320*z_1536 + 2.0*z_1321*z_1537 + 2.0*z_1067*z_1542 + 2.0*z_1066*z_1542 +
        2.0*z_241*z_1545 + 2.0*z_119*z_1549 + 2.0*z_123*z_1550 + z_1579*z_16 + z_1592*z_453 - z_449*z_1563 -
        2.0*z_62*z_1538 - 2.0*z_102*z_1539 - 2.0*z_237*z_1544 - 2.0*z_1070*z_1541 - 2.0*z_1069*z_1541 -
        2.0*z_109*z_1540 - 2.0*z_108*z_1540 - 2.0*z_242*z_1545 - 2.0*z_178*z_1546 - 2.0*z_181*z_1547 - z_1577*z_22
        - sin_phi*z_1602);
    const double z_1671 = z_37*z_1559;
    const double z_1672 = z_54*z_1560;
    D[91] = (-0.5)*(4.0*z_215*z_1558 + 4.0*z_218*z_1558 + 4.0*z_216*z_1558 + 4.0*z_25*z_1612 + 4.0*z_69*z_1671 +
        4.0*z_200*z_1559 + 4.0*z_212*z_1560 + 4.0*z_210*z_1560 + 4.0*z_20*z_1613 + z_961*z_1563 + z_962*z_1564 +
        4.0*z_449*z_1640 + 4.0*z_623*z_1565 + 4.0*z_456*z_1565 + 4.0*z_455*z_1565 + 4.0*z_450*z_1641 +
        4.0*z_625*z_1565 + 4.0*z_622*z_1565 + 4.0*z_458*z_1566 + 4.0*z_618*z_1566 + 4.0*z_452*z_1615 +
        4.0*z_451*z_1615 + 4.0*z_448*z_1540 + 2.0*z_73*z_1568 + 2.0*z_159*z_1568 + 2.0*z_563*z_1569 +
        2.0*z_90*z_1569 + 2.0*z_160*z_1569 + 2.0*z_167*z_1570 + cos_theta*z_1577 + sin_theta*z_1579 + z_780*z_1593
        - 4.0*z_219*z_1558 - 4.0*z_202*z_1559 - 4.0*z_203*z_1559 - 4.0*z_71*z_1671 - 4.0*z_204*z_1559 -
        4.0*z_201*z_1559 - 4.0*z_208*z_1560 - 4.0*z_209*z_1560 - 4.0*z_77*z_1672 - 4.0*z_75*z_1672 -
        4.0*z_211*z_1560 - 4.0*z_193*z_1558 - 4.0*z_450*z_1640 - 4.0*z_452*z_1614 - 4.0*z_451*z_1614 -
        4.0*z_626*z_1565 - 4.0*z_449*z_1641 - 4.0*z_616*z_1566 - 4.0*z_619*z_1566 - 4.0*z_457*z_1566 -
        4.0*z_615*z_1566 - z_10*z_1563 - z_13*z_1564 - 2.0*z_963*z_1567 - 2.0*z_964*z_1567 - 2.0*z_565*z_1568);
    D[92] = (-0.5)*(4.0*z_1558*z_1324 + 4.0*z_1326*z_1558 + 4.0*z_1558*z_1327 + 4.0*z_22*z_1612 + 4.0*z_450*z_1671
        + 4.0*z_626*z_1559 + 4.0*z_458*z_1560 + z_503*z_1564 + 4.0*z_71*z_1640 + 4.0*z_202*z_1565 +
        4.0*z_204*z_1565 + 4.0*z_1565*z_968 + 4.0*z_69*z_1641 + 4.0*z_203*z_1565 + 4.0*z_210*z_1566 +
        4.0*z_77*z_1615 + 4.0*z_75*z_1615 + 4.0*z_760*z_1545 + 4.0*z_58*z_1616 + 4.0*z_57*z_1616 + 4.0*z_49*z_1617
        + 4.0*z_1617*z_336 + 2.0*z_969*z_1567 + 2.0*z_462*z_1568 + 2.0*z_116*z_1569 + 2.0*z_173*z_1619 +
        2.0*z_263*z_1619 + 2.0*z_170*z_1620 + 2.0*z_261*z_1620 - 4.0*z_1325*z_1558 - 4.0*z_449*z_1671 -
        4.0*z_456*z_1559 - 4.0*z_455*z_1559 - 4.0*z_16*z_1613 - 4.0*z_451*z_1672 - 4.0*z_619*z_1560 -
        4.0*z_457*z_1560 - 4.0*z_452*z_1672 - z_505*z_1563 - 4.0*z_77*z_1614 - 4.0*z_69*z_1640 - 4.0*z_75*z_1614 -
        4.0*z_71*z_1641 - 4.0*z_208*z_1566 - 4.0*z_209*z_1566 - 4.0*z_1566*z_967 - 4.0*z_761*z_1545 -
        4.0*z_1616*z_764 - 4.0*z_1616*z_337 - 4.0*z_45*z_1617 - 4.0*z_1617*z_762 - z_314*z_1563 - z_311*z_1564 -
        2.0*z_970*z_1567 - 2.0*z_113*z_1568 - 2.0*z_463*z_1569 - 2.0*z_342*z_1618 - 2.0*z_344*z_1618 - z_1602);
    D[93] = (-0.5)*(4.0*z_1559*z_1329 + 4.0*z_1559*z_1331 + 4.0*z_1559*z_1333 + 4.0*z_1559*z_1334 +
        4.0*z_1559*z_1336 + 4.0*z_1560*z_1337 + 4.0*z_1560*z_1342 + 4.0*z_1560*z_1343 + 4.0*z_1565*z_983 +
        4.0*z_1565*z_993 + 4.0*z_1565*z_982 + 4.0*z_1565*z_981 + 4.0*z_1565*z_980 + 4.0*z_1565*z_979 +
        4.0*z_1566*z_986 + 4.0*z_1566*z_984 + 4.0*z_1616*z_990 + 4.0*z_1617*z_989 + 4.0*z_1617*z_973 +
        4.0*z_1617*z_987 + 2.0*z_825*z_1568 + 2.0*z_827*z_1568 + 2.0*z_821*z_1569 + 2.0*z_732*z_1620 +
        2.0*z_734*z_1620 + sin_tilt*z_1574 + z_502*z_1592 - 4.0*z_1559*z_1330 - 4.0*z_1559*z_1332 -
        4.0*z_1559*z_1335 - 4.0*z_1560*z_1338 - 4.0*z_1560*z_1339 - 4.0*z_1560*z_1340 - 4.0*z_1560*z_1341 -
        4.0*z_1560*z_1344 - 4.0*z_1565*z_994 - 4.0*z_1565*z_992 - 4.0*z_1566*z_997 - 4.0*z_1566*z_996 -
        4.0*z_1566*z_995 - 4.0*z_1566*z_985 - 4.0*z_1566*z_975 - 4.0*z_1566*z_974 - 4.0*z_1616*z_991 -
        4.0*z_1616*z_977 - 4.0*z_1616*z_976 - 4.0*z_1617*z_972 - 2.0*z_826*z_1568 - 2.0*z_822*z_1569 -
        2.0*z_823*z_1569 - 2.0*z_736*z_1619 - 2.0*z_738*z_1619 - cos_tilt*z_1575 - sin_delta*z_1663 -
        sin_delta*z_1664);
    D[95] = F_yy*z_1571;
    D[99] = -(R_yy*z_747 - R_yy*z_819);
    D[106] = z_766;
    D[107] = z_1189;
    const double z_1673 = F_yy*z_84;
    const double z_1674 = F_yy*z_47;
    const double z_1675 = F_yy*z_86;
    const double z_1676 = F_yy*z_65;
    const double z_1677 = lambda_3*z_675 + lambda_3*z_640;
    const double z_1678 = F_yy*psi_ddot - 2.0*lambda_4*z_646 - 2.0*lambda_3*z_658 - z_636*(lambda_4*z_712 +
        lambda_3*z_718 - lambda_4*z_649 - lambda_3*z_661);
    const double z_1679 = F_yy*z_39;
    D[115] = -(sin_phi*(F_yy*z_562 + z_1673*z_576 + z_1674*z_580 + z_632*z_1675 + z_1678*z_723 - z_634*z_1676 -
        cos_delta*z_1677 - z_1678*z_722) + cos_phi*(z_1673*z_748 + psi_dot*z_1679 + z_1677*z_722 - z_1674*z_749 -
        z_1677*z_723 - cos_delta*z_1678));
    const double z_1680 = F_yy*phi_ddot + lambda_4*z_675 + lambda_4*z_640;
    D[116] = -(sin_theta*(z_781*z_1673 + z_747*z_1674 - z_17*z_1674 - F_yy*z_756 - z_780*z_1676 - z_563*z_1677 -
        z_1680*z_84 - z_63*z_1678) + cos_theta*(z_747*z_1673 + F_yy*z_759 + z_1680*z_47 - z_781*z_1674 -
        z_17*z_1673 - z_780*z_1675 - z_565*z_1677 - z_85*z_1678));
    D[117] = -(cos_delta*(F_yy*z_869 + F_yy*z_871 + z_1677*z_921 + z_1680*z_922 + z_1680*z_923 + z_1678*z_868 -
        F_yy*z_870 - z_1677*z_920 - z_1678*z_867) + sin_delta*(F_yy*theta_ddot + F_yy*z_189 + sin_phi*z_1678 -
        F_yy*z_938 - F_yy*z_939 - cos_phi*z_1677));
    D[122] = F_yy*z_609 + z_449*z_1673 + z_452*z_1674 + z_451*z_1674 + F_yy*z_611 - z_450*z_1673 - F_yy*z_612 -
        F_yy*z_408;
    D[123] = F_yy*z_960 + z_962*z_1674 + z_10*z_1673 - z_961*z_1673 - z_13*z_1674 - cos_theta*z_1675 -
        sin_theta*z_1676;
    D[124] = -(z_1679 + z_311*z_1674 - z_505*z_1673 - z_503*z_1674 - z_314*z_1673);
    D[125] = -(F_yy*z_1006 + F_yy*z_1007 + F_yy*z_1008);
    const double z_1681 = z_39*z_645;
    const double z_1682 = z_449*z_84;
    const double z_1683 = z_450*z_84;
    const double z_1684 = z_451*z_47;
    const double z_1685 = z_452*z_47;
    const double z_1686 = z_610 + (z_1682 + z_611 - z_1683) + (z_1684 + z_1685 - z_612);
    const double z_1687 = z_1686*z_711;
    const double z_1688 = sin_theta*z_86;
    const double z_1689 = z_1686*z_644;
    const double z_1690 = z_86*z_645;
    const double z_1691 = cos_theta*z_65;
    const double z_1692 = z_65*z_645;
    const double z_1693 = z_1144*z_354;
    const double z_1694 = z_13*z_84;
    const double z_1695 = z_10*z_47;
    const double z_1696 = z_1144*z_326 - (z_1681 - cos_delta*z_1689 - cos_delta*z_1687);
    const double z_1697 = z_408*z_711 + z_408*z_644 + z_612*z_711 + z_612*z_644 + z_1683*z_711 + z_1683*z_644 -
        z_611*z_711 - z_611*z_644 - z_1682*z_711 - z_1682*z_644 - z_1684*z_711 - z_1684*z_644 - z_1685*z_711 -
        z_1685*z_644 - z_609*z_711 - z_609*z_644;
    const double z_1698 = phi_dot*cos_delta;
    const double z_1699 = z_287 - z_317;
    const double z_1700 = z_1699*z_645;
    const double z_1701 = z_197 - z_265;
    const double z_1702 = z_645*z_84;
    const double z_1703 = z_196 + z_266;
    const double z_1704 = z_47*z_645;
    const double z_1705 = z_1686*z_705;
    const double z_1706 = z_450*z_86;
    const double z_1707 = z_449*z_86;
    const double z_1708 = z_452*z_65;
    const double z_1709 = z_451*z_65;
    const double z_1710 = z_84*z_1077;
    const double z_1711 = z_47*z_1080;
    const double z_1712 = z_131 + z_79;
    const double z_1713 = sin_phi*z_1712;
    const double z_1714 = z_1699*z_644;
    const double z_1715 = z_85*z_1701;
    const double z_1716 = z_63*z_1703;
    const double z_1717 = z_431 + z_427;
    const double z_1718 = z_1717*z_644;
    const double z_1719 = z_3 - z_393;
    const double z_1720 = cos_delta*z_1719;
    const double z_1721 = r_F*z_1686*(z_637/(z_639*(z_638*z_638)));
    const double z_1722 = z_1686*z_704;
    const double z_1723 = z_1699*z_705;
    const double z_1724 = z_1717*z_705;
    const double z_1725 = 2.0*z_408*z_1705 + 2.0*z_644*z_404 + 2.0*z_644*z_1706 + 2.0*z_612*z_1705 +
        2.0*z_644*z_1710 + 2.0*z_644*z_1711 + 2.0*z_1683*z_1705 + z_644*z_1713 + z_868*z_1714 + z_644*z_1715 +
        z_723*z_1718 + z_644*z_1720 + z_636*(3.0*z_408*z_1721 + z_408*z_1722 + 2.0*z_705*z_404 + 2.0*z_705*z_1706
        + 3.0*z_612*z_1721 + z_612*z_1722 + 2.0*z_705*z_1710 + 2.0*z_705*z_1711 + 3.0*z_1683*z_1721 +
        z_1683*z_1722 + z_705*z_1713 + z_868*z_1723 + z_705*z_1715 + z_723*z_1724 + z_705*z_1720 -
        3.0*z_611*z_1721 - z_611*z_1722 - 2.0*z_705*z_1707 - 2.0*z_705*z_1708 - 2.0*z_705*z_1709 -
        3.0*z_1682*z_1721 - z_1682*z_1722 - 3.0*z_1684*z_1721 - z_1684*z_1722 - 3.0*z_1685*z_1721 - z_1685*z_1722
        - 3.0*z_609*z_1721 - z_609*z_1722 - z_867*z_1723 - z_705*z_1716 - z_722*z_1724) - 2.0*z_611*z_1705 -
        2.0*z_644*z_1707 - 2.0*z_644*z_1708 - 2.0*z_644*z_1709 - 2.0*z_1682*z_1705 - 2.0*z_1684*z_1705 -
        2.0*z_1685*z_1705 - 2.0*z_609*z_1705 - z_867*z_1714 - z_644*z_1716 - z_722*z_1718;
    const double z_1726 = z_1597*z_39;
    const double z_1727 = z_1600*z_39;
    const double z_1728 = z_1466*z_10;
    const double z_1729 = r_F*z_57;
    const double z_1730 = z_760 - z_761;
    const double z_1731 = z_1492*z_13;
    const double z_1732 = c_*z_45;
    const double z_1733 = ((z_1728 + r_F*z_764) - (z_1729 + r_F*z_58)) - (z_1730 + ((z_1731 - c_*z_762) - (z_1732
        - c_*z_49)));
    const double z_1734 = (z_645*z_1694 + z_645*z_1688 + z_1689*z_723 + z_1687*z_723) + (z_645*z_1695 -
        z_645*z_1691 - z_1689*z_722 - z_1687*z_722) - z_1733;
    const double z_1735 = z_311*z_47;
    const double z_1736 = z_314*z_84;
    const double z_1737 = (r_F*z_280 + c_*z_276) + ((z_581 - z_582) - (r_F*z_279 + c_*z_277));
    D[131] = sin_phi*(phi_dot*z_1681 + z_1687*z_1691 + z_1689*z_1691 + z_1194*z_2 + z_1697*z_1695 + z_1697*z_1688
        + z_1697*z_1694 + z_1697*z_1698 + cos_theta*sin_tilt*z_1700 + z_1701*z_1702 + z_1491*z_1701 +
        z_1492*z_1701 + z_1466*z_1703 + z_1467*z_1703 + z_1725*z_723 + 2.0*z_13*z_1727 + cos_theta*z_1597*z_1712 +
        sin_theta*z_1600*z_1712 - z_1687*z_1688 - z_1689*z_1688 - 2.0*z_13*z_1690 - 2.0*z_10*z_1692 - z_1693 -
        z_1687*z_1694 - z_1689*z_1694 - z_1687*z_1695 - z_1689*z_1695 - phi_dot*z_1696 - z_1697*z_1691 -
        sin_theta*cos_tilt*z_1700 - z_52*z_1701 - z_1703*z_1704 - r_R*z_1703 - z_1146*phi_ddot - z_1725*z_722 -
        2.0*z_10*z_1726) + cos_phi*(z_311*z_1692 + z_1697*z_1736 + z_39*z_1697 + z_1144*z_1699 + z_311*z_1726 +
        z_314*z_1727 + z_1737 - z_39*z_1687 - z_39*z_1689 - z_314*z_1690 - z_308*z_1702 - z_309*z_1704 -
        phi_dot*z_1734 - z_1146*z_2 - z_1697*z_1735 - z_1712*z_645 - z_1194*phi_ddot - cos_delta*z_1725);
    const double z_1738 = z_52*z_66 + (r_F*z_1444 - z_1491*z_66) - (c_*z_1447 + z_1492*z_66) - (z_212*z_645 -
        z_211*z_645 - z_85*z_1689 - z_85*z_1687);
    const double z_1739 = z_645*z_17;
    const double z_1740 = z_84*z_779;
    const double z_1741 = cos_phi*z_1712;
    const double z_1742 = z_448 + (c_*z_1444 - z_1467*z_66) + (z_201*z_645 - z_200*z_645 - z_63*z_1689 -
        z_63*z_1687) - (z_1466*z_66 + r_F*z_1483);
    const double z_1743 = z_47*z_779;
    D[132] = -(sin_theta*(z_1201 + z_779*z_1690 + 2.0*z_66*z_1692 + theta_dot*z_1738 + z_1490*z_27 + z_201*z_1687
        + z_201*z_1689 + z_200*z_1697 + z_1717*z_1704 + r_R*z_1717 + z_63*z_1725 + 2.0*z_66*z_1726 - z_200*z_1687
        - z_200*z_1689 - z_565*z_1739 - r_F*z_1206 - c_*z_1213 - z_201*z_1697 - z_1697*z_1740 - z_428*z_1700 -
        z_1465*theta_ddot - z_1466*z_1717 - z_1467*z_1717 - z_779*z_1727 - z_1597*z_1741) + cos_theta*(z_1272 +
        2.0*z_66*z_1690 + theta_dot*z_1742 + z_563*z_1739 + z_212*z_1687 + z_212*z_1689 + z_1697*z_1743 +
        z_211*z_1697 + z_1717*z_1702 + z_1491*z_1717 + z_1492*z_1717 + z_85*z_1725 + z_1600*z_1741 - z_211*z_1687
        - z_211*z_1689 - z_779*z_1692 - z_1465*z_27 - r_F*z_1274 - c_*z_1206 - z_212*z_1697 - z_429*z_1700 -
        z_1490*theta_ddot - z_52*z_1717 - z_779*z_1726 - 2.0*z_66*z_1727));
    const double z_1744 = z_42*((c_*z_451 + c_*z_452) - (r_F*z_449 - r_F*z_450)) + (z_1599*z_449 - z_1599*z_450) +
        (z_645*z_188 + sin_phi*z_1689 + sin_phi*z_1687) - (z_1596*z_451 + z_1596*z_452);
    const double z_1745 = cos_tilt*z_449;
    const double z_1746 = cos_tilt*z_645;
    const double z_1747 = sin_tilt*z_451;
    const double z_1748 = sin_tilt*z_645;
    const double z_1749 = sin_tilt*z_452;
    const double z_1750 = cos_tilt*z_450;
    const double z_1751 = delta_dot*z_188;
    const double z_1752 = cos_theta*z_1717;
    const double z_1753 = sin_theta*z_1717;
    const double z_1754 = delta_dot*z_1600;
    const double z_1755 = delta_dot*z_1597;
    const double z_1756 = z_1144*z_188 + (z_645*z_1747 + z_645*z_1749 - z_1689*z_868 - z_1687*z_868) +
        (z_645*z_1745 + z_1689*z_867 + z_1687*z_867 - z_645*z_1750);
    const double z_1757 = z_46*z_645;
    const double z_1758 = z_516*z_645;
    const double z_1759 = cos_phi*r_F;
    const double z_1760 = c_*cos_phi;
    D[133] = -(cos_delta*(delta_dot*z_1744 + z_1666*z_64 + 2.0*z_1077*z_1746 + 2.0*z_1080*z_1748 + z_1687*z_1750 +
        z_1689*z_1750 + z_645*z_1751 + z_1697*z_1749 + z_1697*z_1747 + z_1697*z_1745 + z_1701*z_645*z_429 +
        z_1753*z_1746 + z_1144*z_1719 + z_1725*z_867 + z_449*z_1754 - z_1687*z_1745 - z_1689*z_1745 -
        z_1687*z_1747 - z_1689*z_1747 - z_1687*z_1749 - z_1689*z_1749 - z_1697*z_1750 - z_1697*z_865 -
        z_1662*delta_ddot - z_1703*z_645*z_428 - z_1752*z_1748 - z_1725*z_868 - z_451*z_1755 - z_450*z_1754 -
        z_452*z_1755) + sin_delta*(z_1662*z_64 + delta_dot*z_1756 + z_449*z_1757 + z_451*z_1758 + z_452*z_1758 +
        z_188*z_1687 + z_188*z_1689 + z_1144*z_1751 + z_1697*z_937 + z_1666*delta_ddot + (2.0*r_F*z_1080 -
        z_1703*z_1759 - r_F*z_1752)*z_36 + z_42*(2.0*r_F*z_1077 + z_1701*z_1759 + z_1703*z_1760 + r_F*z_1753 +
        c_*z_1752 - 2.0*c_*z_1080) - z_450*z_1757 - z_1697*z_936 - z_1697*z_188 - z_1719*z_645 - sin_phi*z_1725 -
        (2.0*c_*z_1077 + z_1701*z_1760 + c_*z_1753)*z_33));
    const double z_1761 = z_1146*z_66;
    const double z_1762 = z_1194*z_188;
    D[139] = z_216 + z_25*z_1692 + z_326*z_1301 + z_1466*z_69 + z_1467*z_69 + z_656*z_1697 + z_25*z_1726 +
        z_20*z_1727 - z_219 - z_1761 - z_1762 - ((z_1761 - cos_phi*z_1696) + (z_1762 + sin_phi*z_1734)) -
        z_466*z_645 - z_20*z_1690 - z_77*z_1702 - z_1491*z_77 - z_1492*z_77 - z_69*z_1704 - z_655*z_1697 -
        z_143*z_1697;
    const double z_1763 = z_1490*z_13;
    const double z_1764 = z_1465*z_10;
    D[140] = z_1763 + z_1764 + ((z_1763 - sin_theta*z_1742) + (z_1764 + cos_theta*z_1738)) + z_1326 + z_16*z_1690
        + z_22*z_1692 + z_1466*z_450 + z_1467*z_450 + z_22*z_1726 - z_1325 - z_450*z_1704 - z_452*z_1702 -
        z_1491*z_452 - z_1492*z_452 - z_1697*z_1419 - z_1697*z_1418 - z_16*z_1727;
    const double z_1765 = z_1666*z_39;
    const double z_1766 = z_1662*z_326;
    const double z_1767 = z_645*z_677;
    const double z_1768 = z_645*z_43;
    D[141] = -(z_1765 + ((z_1765 - cos_delta*z_1756) - (z_1766 - sin_delta*z_1744)) + z_450*z_1767 + z_645*z_453 +
        z_1697*z_1004 + z_449*z_1621 - z_1766 - z_449*z_1767 - z_451*z_1768 - z_452*z_1768 - z_1144*z_609 -
        z_1697*z_1005 - z_1697*z_161 - z_451*z_1642 - z_450*z_1621 - z_452*z_1642);
    const double z_1769 = z_485 - y_ddot;
    const double z_1770 = z_484 + x_ddot;
    D[146] = -(cos_psi*z_1769 + sin_psi*z_1770);
    D[152] = -z_7;
    D[153] = z_5;
    D[154] = z_243;
    D[162] = -(cos_psi*z_1770 - sin_psi*z_1769);
    D[168] = -z_5;
    D[169] = -z_7;
    D[170] = -z_110;
    D[178] = -(cos_psi*z_1769 + sin_psi*z_1770);
    const double z_1771 = z_1686*z_645;
    const double z_1772 = (z_618 + z_1054) - (z_619 + z_1053) - z_617;
    const double z_1773 = z_657*z_1689;
    const double z_1774 = z_657*z_1687;
    const double z_1775 = (z_466 + z_467) + (z_84*z_75 + z_84*z_77 + z_86*z_20) - (z_47*z_71 + z_65*z_25 -
        z_47*z_69);
    const double z_1776 = (z_206*z_640 + z_114*z_1771) - (z_1772*z_658 + z_1775*z_668 - z_564*z_1773 -
        z_564*z_1774);
    const double z_1777 = z_624 + (z_625 + z_1050) + (z_1051 - z_626);
    const double z_1778 = (z_214*z_640 - z_117*z_1771) + (z_1777*z_658 + z_566*z_1773 + z_566*z_1774 -
        z_1775*z_670);
    const double z_1779 = z_1686*z_658;
    const double z_1780 = z_657*z_1705;
    const double z_1781 = (z_1779 + z_1775*z_640) - (2.0*z_1779 + z_637*z_1780 - z_1775*z_675);
    const double z_1782 = (z_659*z_48 - z_44*z_1776) - (z_660*z_55 - z_54*z_1778) - (z_662*z_86 - z_1781*z_84);
    const double z_1783 = (z_660*z_48 + z_44*z_1778) + (z_662*z_65 - z_1781*z_47) - (z_659*z_40 + z_37*z_1776);
    const double z_1784 = z_44*z_503 + z_37*z_505 + z_512;
    const double z_1785 = z_54*z_503 + z_44*z_505 + z_517;
    const double z_1786 = z_503*z_84 + z_508 - z_505*z_47;
    const double z_1787 = z_1784*z_668 + z_1786*z_675 + z_1786*z_640 - z_1785*z_670;
    const double z_1788 = z_564*z_1784;
    const double z_1789 = z_114*z_1784;
    const double z_1790 = z_566*z_1785;
    const double z_1791 = z_117*z_1785;
    const double z_1792 = z_1786*z_637;
    const double z_1793 = z_1788*z_718 + z_661*z_1788 + z_645*z_1789 + z_645*z_1791 + z_713*z_1792 + z_1786*z_658
        - z_1790*z_718 - z_661*z_1790;
    const double z_1794 = z_1785*z_640 + z_1176;
    const double z_1795 = z_1784*z_640 + z_1173;
    const double z_1796 = z_1784*z_658;
    const double z_1797 = z_1785*z_658;
    const double z_1798 = z_1772*z_1784;
    const double z_1799 = z_1777*z_1785;
    const double z_1800 = z_525 + z_689;
    const double z_1801 = z_528 - z_683;
    const double z_1802 = theta_ddot + (z_189 + z_719);
    const double z_1803 = z_1802*z_47 + (z_538 + z_724);
    const double z_1804 = z_503*z_48 + z_44*z_1800 + z_1803 - z_505*z_40 - z_37*z_1801;
    const double z_1805 = z_1802*z_84 + (z_543 - z_726);
    const double z_1806 = z_503*z_55 + z_44*z_1801 + z_1805 - z_505*z_48 - z_54*z_1800;
    const double z_1807 = cos_delta*z_1802 - (z_530 - spin_f_ddot);
    const double z_1808 = z_505*z_65 - z_503*z_86 - z_1800*z_84 - z_1801*z_47 - z_1807;
    const double z_1809 = z_1687*z_1788 + z_1689*z_1788 + z_1705*z_1792 + z_1786*z_1771 + z_1804*z_668 +
        z_1806*z_670 - z_645*z_1798 - z_1687*z_1790 - z_1689*z_1790 - z_645*z_1799 - z_1808*z_675 - z_1808*z_640;
    const double z_1810 = z_1775*z_644;
    const double z_1811 = z_1775*z_1786;
    const double z_1812 = z_1775*z_705;
    const double z_1813 = z_657*z_1721;
    const double z_1814 = z_657*z_1722;
    const double z_1815 = z_1788*z_1810 + z_661*z_1798 + 2.0*z_1790*z_1780 + z_661*z_1799 + 2.0*z_645*z_1811 +
        2.0*z_1808*z_658 + z_636*(z_1788*z_1812 + z_713*z_1798 + z_206*z_1784*z_644 + 3.0*z_1790*z_1813 +
        z_1790*z_1814 + z_713*z_1799 + z_711*z_1811 + z_1806*z_717 + z_1808*z_718 - 3.0*z_1788*z_1813 -
        z_1788*z_1814 - z_1705*z_1789 - z_1790*z_1812 - z_1705*z_1791 - z_214*z_1785*z_644 -
        3.0*z_636*z_1786*z_1813 - z_644*z_1811 - z_1786*z_1780 - z_1804*z_714 - z_1804*z_715 - z_1806*z_716 -
        z_1808*z_661) - 2.0*z_1788*z_1780 - z_1689*z_1789 - z_1790*z_1810 - z_1689*z_1791 - 3.0*z_1786*z_1774 -
        z_1786*z_1773 - z_1804*z_702 - z_1806*z_703;
    const double z_1816 = z_1775*z_645;
    const double z_1817 = z_1784*z_1816 - z_1784*z_1774 - z_1784*z_1773 - z_1804*z_658;
    const double z_1818 = z_1785*z_1816 + z_1806*z_658 - z_1785*z_1774 - z_1785*z_1773;
    const double z_1819 = r_F*psi_ddot;
    const double z_1820 = z_1784*z_1771 - z_1804*z_640 - z_1819;
    const double z_1821 = c_*psi_ddot;
    const double z_1822 = z_1785*z_1771 + z_1806*z_640 - z_1821;
    const double z_1823 = (z_659*z_65 - z_1776*z_47) + ((z_662*z_39 + cos_delta*z_1781) - (z_660*z_86 +
        z_1778*z_84));
    D[179] = -(sin_phi*(r_R*z_561 + z_1782*z_632 + z_663*z_576 + z_1783*z_634 + z_1787*z_1736 + z_39*z_1787 +
        z_1793*z_1691 + z_1794*z_282 + z_1794*z_283 + z_86*z_1794 + z_1795*z_285 + z_1795*z_286 + z_1796*z_764 +
        z_1796*z_337 + z_1797*z_762 + z_45*z_1797 + z_1797*z_763 + z_663*z_688 + z_665*z_682 + z_1815*z_723 +
        z_173*z_1817 + z_263*z_1817 + z_170*z_1818 + z_261*z_1818 + z_1820*z_47 - z_665*z_580 - z_770*z_561 -
        z_1787*z_1735 - z_1793*z_1695 - z_1793*z_1688 - z_1793*z_1694 - z_1793*z_1698 - z_52*z_748 - r_R*z_749 -
        z_65*z_1795 - z_58*z_1796 - z_57*z_1796 - z_1796*z_765 - z_49*z_1797 - z_1797*z_336 - cos_delta*z_1809 -
        z_1815*z_722 - z_1822*z_84) + cos_phi*(z_1426 + z_663*z_748 + z_665*z_749 + z_1787*z_1691 + z_1793*z_1735
        + psi_dot*z_761 + z_1794*z_762 + z_45*z_1794 + z_1794*z_763 + z_1795*z_764 + z_1795*z_337 + z_65*z_1796 +
        z_770*psi_ddot + z_1809*z_722 + z_1818*z_84 + z_173*z_1820 + z_263*z_1820 + z_170*z_1822 + z_261*z_1822 -
        psi_dot*z_1823 - z_1787*z_1688 - z_1787*z_1694 - z_1787*z_1695 - z_1787*z_1698 - z_1793*z_1736 -
        z_39*z_1793 - psi_dot*z_760 - z_49*z_1794 - z_1794*z_336 - z_58*z_1795 - z_57*z_1795 - z_1795*z_765 -
        z_1796*z_285 - z_1796*z_286 - z_1797*z_282 - z_1797*z_283 - z_86*z_1797 - z_1809*z_723 - cos_delta*z_1815
        - z_1817*z_47 - z_1150));
    const double z_1824 = z_1787*z_84;
    const double z_1825 = z_1597 + z_1597;
    const double z_1826 = z_39*z_1825;
    const double z_1827 = z_1787*z_47;
    const double z_1828 = z_1600 + z_1600;
    const double z_1829 = z_39*z_1828;
    D[180] = sin_theta*(z_792 + z_190 + z_817 + z_665*z_747 + z_615*z_1787 + z_616*z_1787 + z_201*z_1793 +
        z_1793*z_1740 + psi_dot*z_799 + z_1795*z_801 + z_1796*z_1448 + z_1797*z_1444 + z_1797*z_1485 +
        z_563*z_1809 + z_63*z_1815 + z_107*psi_ddot + z_1820*z_400 + z_1822*z_360 + theta_dot*z_1826 - z_1600*z_79
        - z_663*z_781 - z_1783*z_780 - z_373*z_1824 - z_1491*z_27 - z_1492*z_27 - z_200*z_1793 - z_1794*z_800 -
        z_1794*z_374 - z_1794*z_375 - z_1795*z_376 - z_1795*z_377 - z_1796*z_1483 - z_1796*z_1484 - z_1797*z_1446
        - z_1600*z_131 - z_665*z_819 - z_1466*theta_ddot - c_*z_145 - z_1817*z_391 - z_1818*z_365) +
        cos_theta*(z_844 + z_1782*z_780 + z_622*z_1787 + z_623*z_1787 + z_373*z_1827 + z_212*z_1793 +
        psi_dot*z_847 + z_1794*z_413 + z_1795*z_800 + z_1795*z_375 + z_1796*z_1445 + z_1796*z_1446 + z_1797*z_1447
        + z_1797*z_1448 + z_1797*z_1449 + z_663*z_819 + z_565*z_1809 + r_F*z_145 + z_1492*theta_ddot + z_85*z_1815
        + z_1817*z_365 + z_1818*z_363 - z_854 - z_1597*z_79 - z_663*z_747 - z_665*z_781 - z_1466*z_27 -
        z_1467*z_27 - z_1793*z_1743 - z_211*z_1793 - z_52*z_189 - z_1794*z_849 - z_1794*z_376 - z_1795*z_414 -
        z_1796*z_1444 - z_1597*z_131 - psi_ddot*z_418 - z_1820*z_360 - z_1822*z_385 - theta_dot*z_1829);
    const double z_1830 = z_660*z_503;
    const double z_1831 = z_659*z_503;
    const double z_1832 = z_659*z_505;
    const double z_1833 = z_660*z_505;
    const double z_1834 = cos_tilt*z_1787;
    const double z_1835 = sin_tilt*z_1787;
    const double z_1836 = sin_tilt*z_1802;
    const double z_1837 = cos_tilt*z_1802;
    const double z_1838 = z_662*z_503;
    const double z_1839 = z_662*z_505;
    const double z_1840 = z_1787*z_20;
    const double z_1841 = z_1787*z_25;
    D[181] = cos_delta*(cos_tilt*z_503*z_1781 + z_858*z_1831 + z_858*z_1833 + z_662*z_871 + z_77*z_1834 +
        z_75*z_1834 + z_69*z_1835 + z_1787*z_446 + z_1793*z_1750 + z_1793*z_865 + z_1794*z_898 + z_1795*z_901 +
        z_1795*z_903 + z_1796*z_857 + z_1797*z_862 + z_1797*z_895 + z_1600*z_426 + z_659*z_1836 + z_1809*z_920 +
        z_1815*z_867 + z_1817*z_860 + z_1820*z_428 - z_861*z_1830 - sin_tilt*z_505*z_1781 - z_856*z_1832 -
        z_1776*z_913 - z_1778*z_912 - z_71*z_1835 - z_1793*z_1749 - z_1793*z_1747 - z_1793*z_1745 - z_1794*z_899 -
        z_1794*z_900 - z_1795*z_902 - z_1796*z_859 - z_1796*z_894 - z_1797*z_863 - z_1597*z_425 -
        cos_tilt*z_662*z_1800 - sin_tilt*z_662*z_1801 - z_660*z_1837 - z_1809*z_921 - z_1815*z_868 - z_1818*z_864
        - z_1822*z_429 - z_1828*z_436 - z_1825*z_437) - sin_delta*(z_1600*z_444 + z_516*z_1839 + z_659*z_941 +
        z_501*z_1781 + z_46*z_1840 + z_1787*z_66 + z_1793*z_937 + z_1794*z_955 + z_1797*z_935 + sin_phi*z_1815 +
        z_42*(z_503*z_1776 + c_*z_197 + z_1794*z_69 + z_449*z_1796 + z_660*z_1801 + z_1820*z_20 + z_1822*z_25 -
        z_505*z_1778 - r_F*z_196 - z_1794*z_71 - z_1795*z_77 - z_1795*z_75 - z_450*z_1796 - z_451*z_1797 -
        z_452*z_1797 - z_659*z_1800 - r_F*z_266 - c_*z_265 - z_1817*z_22 - z_1818*z_16) + (z_503*z_1778 + c_*z_196
        + z_1794*z_77 + z_1794*z_75 + z_450*z_1797 + z_660*z_1800 + c_*z_266 + z_1818*z_22 - z_449*z_1797 -
        z_1822*z_20)*z_33 - z_1597*z_445 - z_46*z_1838 - z_660*z_940 - z_516*z_1841 - z_1793*z_936 - z_1793*z_188
        - z_1795*z_956 - z_1796*z_934 - z_662*z_1802 - cos_phi*z_1809 - (z_505*z_1776 + r_F*z_197 + z_1795*z_69 +
        z_659*z_1801 + z_1820*z_25 - z_1795*z_71 - z_451*z_1796 - z_452*z_1796 - r_F*z_265 - z_1817*z_16)*z_36);
    D[184] = -z_7;
    D[185] = z_5;
    D[186] = ((z_663*z_449 + z_1782*z_22 - z_663*z_450) - (z_770*z_188 - sin_phi*z_1823) - (z_665*z_451 +
        z_665*z_452 - z_1783*z_16) - z_236) + z_243;
    D[187] = z_1021 + z_22*z_1824 + z_635*z_1787 + z_656*z_1793 + z_73*z_1794 + z_159*z_1794 + z_563*z_1795 +
        z_90*z_1795 + z_160*z_1795 + z_113*z_1796 + z_112*z_1796 + z_85*z_1797 + z_116*z_1797 + z_115*z_1797 -
        z_663*z_961 - z_665*z_962 - z_770*z_780 - z_16*z_1827 - z_655*z_1793 - z_143*z_1793 - z_52*z_503 -
        r_R*z_505 - z_565*z_1794 - z_63*z_1796;
    D[188] = z_1731 + z_1729 + (z_1823 - z_1733) + z_663*z_505 + z_84*z_1841 + z_20*z_1827 + r_R*z_961 +
        z_462*z_1794 + z_116*z_1795 + z_1374*z_1796 + z_90*z_1797 + z_1730 - z_1732 - z_1728 - sin_theta*z_1727 -
        cos_theta*z_1726 - z_665*z_503 - z_1793*z_1419 - z_1793*z_1418 - z_52*z_962 - z_113*z_1794 - z_463*z_1795
        - z_73*z_1796 - z_1372*z_1797;
    const double z_1842 = (z_13*z_1642 + z_1597*z_469) + (z_10*z_1621 - z_1600*z_465);
    D[189] = -(z_677*z_1838 + z_733*z_1830 + z_737*z_1832 + z_660*z_1009 + z_43*z_1841 + z_1793*z_1004 +
        z_826*z_1794 + z_822*z_1795 + z_823*z_1795 + z_999*z_1796 + z_1000*z_1796 + z_1002*z_1797 + z_1842 -
        (sin_tilt*z_1778 - cos_tilt*z_1776 - z_1842) - z_731*z_1831 - z_43*z_1839 - z_731*z_1833 - z_659*z_1012 -
        z_662*z_1008 - z_677*z_1840 - z_1787*z_978 - z_1793*z_1005 - z_1793*z_161 - z_825*z_1794 - z_827*z_1794 -
        z_821*z_1795 - z_998*z_1796 - z_1001*z_1797 - z_1003*z_1797);
    D[191] = z_1781;
    D[194] = -(cos_psi*z_1770 - sin_psi*z_1769);
    const double z_1843 = z_643*z_1689;
    const double z_1844 = (z_10*z_84 - z_1132) - (z_13*z_47 + z_1133);
    const double z_1845 = z_643*z_1687;
    const double z_1846 = (z_60*z_640 + z_174*z_1771) + (z_1777*z_646 + z_566*z_1843 + z_566*z_1845 -
        z_1844*z_670);
    const double z_1847 = (z_51*z_640 - z_171*z_1771) + (z_1772*z_646 + z_1844*z_668 - z_564*z_1843 -
        z_564*z_1845);
    const double z_1848 = z_1686*z_646;
    const double z_1849 = z_643*z_1705;
    const double z_1850 = (z_1844*z_640 + z_1848) - (2.0*z_1848 + z_637*z_1849 - z_1844*z_675);
    const double z_1851 = (z_647*z_55 + z_54*z_1846) + (z_648*z_48 + z_44*z_1847) - (z_650*z_86 - z_1850*z_84);
    const double z_1852 = (z_648*z_40 - z_37*z_1847) + (z_647*z_48 - z_44*z_1846) - (z_650*z_65 - z_1850*z_47);
    const double z_1853 = z_566*z_518;
    const double z_1854 = z_174*z_518;
    const double z_1855 = z_564*z_513;
    const double z_1856 = z_171*z_513;
    const double z_1857 = z_509*z_637;
    const double z_1858 = z_1853*z_712 + z_649*z_1853 + z_645*z_1854 + z_1855*z_712 + z_649*z_1855 + z_645*z_1856
        + z_706*z_1857 + z_509*z_646;
    const double z_1859 = z_513*z_646;
    const double z_1860 = z_518*z_646;
    const double z_1861 = z_1844*z_644;
    const double z_1862 = z_518*z_1777;
    const double z_1863 = z_513*z_1772;
    const double z_1864 = z_509*z_1844;
    const double z_1865 = z_526 - z_690;
    const double z_1866 = z_529 + z_684;
    const double z_1867 = z_541 + z_542 + z_54*z_1865 + z_44*z_1866 - z_1805;
    const double z_1868 = z_536 + z_537 - z_44*z_1865 - z_37*z_1866 - z_1803;
    const double z_1869 = z_531 + z_532 + z_1866*z_47 - z_1865*z_84 - z_1807;
    const double z_1870 = z_643*z_1721;
    const double z_1871 = z_1844*z_705;
    const double z_1872 = z_643*z_1722;
    const double z_1873 = 2.0*z_1853*z_1849 + z_649*z_1862 + z_1689*z_1854 + 2.0*z_1855*z_1849 + z_1689*z_1856 +
        3.0*z_509*z_1845 + z_509*z_1843 + z_636*(3.0*z_1853*z_1870 + z_1853*z_1872 + z_706*z_1862 + z_1705*z_1854
        + 3.0*z_1855*z_1870 + z_1855*z_1872 + z_1705*z_1856 + z_513*z_51*z_644 + 3.0*z_636*z_509*z_1870 +
        z_509*z_1849 + z_644*z_1864 + z_1869*z_649 - z_1853*z_1871 - z_518*z_60*z_644 - z_1855*z_1871 -
        z_706*z_1863 - z_711*z_1864 - z_1867*z_707 - z_1867*z_708 - z_1868*z_709 - z_1868*z_710 - z_1869*z_712) -
        z_1853*z_1861 - z_1855*z_1861 - z_649*z_1863 - 2.0*z_645*z_1864 - z_1867*z_695 - z_1868*z_697 -
        2.0*z_1869*z_646;
    const double z_1874 = z_1844*z_645;
    const double z_1875 = z_513*z_1845 + z_513*z_1843 - z_513*z_1874 - z_1868*z_646;
    const double z_1876 = z_518*z_1845 + z_518*z_1843 - z_518*z_1874 - z_1867*z_646;
    const double z_1877 = (z_647*z_86 - z_1846*z_84) + ((z_650*z_39 + cos_delta*z_1850) + (z_648*z_65 +
        z_1847*z_47));
    D[195] = -(sin_phi*(z_1250 + z_1851*z_632 + z_1858*z_1691 + z_1859*z_764 + z_1859*z_337 + z_49*z_1860 +
        z_1860*z_336 + z_1144*z_287 + z_653*z_682 + z_1873*z_722 + z_170*z_1876 + z_261*z_1876 + z_311*z_1826 +
        z_314*z_1829 + 2.0*z_1737 - z_1145*z_64 - z_1145*z_2 - z_651*z_576 - z_1852*z_634 - z_653*z_580 -
        z_769*z_561 - z_1858*z_1695 - z_1858*z_1688 - z_1858*z_1694 - z_1858*z_1698 - z_58*z_1859 - z_57*z_1859 -
        z_1859*z_765 - z_1860*z_762 - z_45*z_1860 - z_1860*z_763 - r_F*z_289 - r_F*z_292 - c_*z_290 - c_*z_291 -
        z_651*z_688 - z_1873*z_723 - z_173*z_1875 - z_263*z_1875) + cos_phi*(z_752 + z_753 + z_750 + z_751 +
        2.0*z_1693 + z_653*z_749 + z_1858*z_1735 + z_65*z_1859 + z_1860*z_282 + z_1860*z_283 + z_86*z_1860 +
        r_F*z_260 + c_*z_339 + z_176*theta_ddot + z_1144*z_340 + z_769*psi_ddot + cos_delta*z_1873 + z_1875*z_47 +
        z_1876*z_84 + z_10*z_1826 - z_334 - z_1600*z_353 - z_1597*z_352 - r_F*z_229 - c_*z_328 - r_F*z_333 -
        c_*z_224 - r_F*z_331 - r_F*z_332 - c_*z_329 - c_*z_330 - z_651*z_748 - psi_dot*z_1877 - z_1858*z_1736 -
        z_39*z_1858 - z_1859*z_285 - z_1859*z_286 - z_1600*z_256 - z_1597*z_258 - r_F*z_338 - c_*z_259 -
        z_175*theta_ddot - z_13*z_1829));
    const double z_1878 = z_518*z_670 + z_513*z_668 + z_509*z_675 + z_509*z_640;
    const double z_1879 = theta_dot*z_1878;
    const double z_1880 = z_1173 + z_513*z_640;
    const double z_1881 = z_1176 - z_518*z_640;
    const double z_1882 = z_1687*z_1853 + z_1689*z_1853 + z_645*z_1862 + z_1687*z_1855 + z_1689*z_1855 +
        z_1705*z_1857 + z_509*z_1771 - z_645*z_1863 - z_1867*z_670 - z_1868*z_668 - z_1869*z_675 - z_1869*z_640;
    const double z_1883 = z_1821 + z_518*z_1771 + z_1867*z_640;
    const double z_1884 = z_1819 - z_513*z_1771 - z_1868*z_640;
    D[196] = sin_theta*(z_4 + r_R*z_368 + 2.0*r_F*z_366 + 2.0*c_*z_364 + phi_dot*z_1851 + z_651*z_781 +
        z_1852*z_780 + z_653*z_747 + z_47*z_1879 + z_86*z_1878 + z_201*z_1858 + z_1858*z_1740 + z_1859*z_1448 +
        z_1860*z_1446 + psi_dot*z_805 + z_1880*z_48 + r_F*z_384 + c_*z_386 + r_F*z_392 + c_*z_390 + z_1882*z_84 +
        z_1875*z_391 + z_54*z_1883 + z_44*z_1884 - 2.0*z_784 - z_829 - z_1597*z_403 - z_1466*z_368 - c_*z_361 -
        z_1466*z_3 - c_*z_362 - z_653*z_17 - z_200*z_1858 - z_1859*z_1483 - z_1859*z_1484 - z_1860*z_1444 -
        z_1860*z_1485 - z_1880*z_379 - z_1881*z_55 - z_1881*z_381 - z_1597*z_382 - theta_ddot*z_418 -
        z_651*phi_ddot - z_653*z_819 - z_63*z_1873 - z_1876*z_365 - z_1493 - z_373*z_1829 - z_1825*z_404) -
        cos_theta*(z_52*z_368 + z_52*z_3 + 2.0*z_839 + z_1150 + z_651*z_17 + phi_dot*z_1852 + z_653*z_781 +
        z_65*z_1878 + z_1858*z_1743 + z_211*z_1858 + z_1859*z_1444 + z_1860*z_1447 + z_1860*z_1448 + z_1860*z_1449
        + psi_dot*z_850 + z_1880*z_40 + z_107*theta_ddot + r_F*z_390 + c_*z_417 + z_651*z_819 + z_1882*z_47 +
        z_85*z_1873 + z_1875*z_365 + z_373*z_1826 - z_1600*z_403 - r_F*z_361 - z_1492*z_368 - 2.0*r_F*z_412 -
        2.0*c_*z_366 - r_F*z_362 - z_1492*z_3 - z_1851*z_780 - z_651*z_747 - z_84*z_1879 - z_212*z_1858 -
        z_1859*z_1445 - z_1859*z_1446 - z_1880*z_381 - z_1881*z_48 - z_1881*z_415 - z_1600*z_382 - r_F*z_416 -
        c_*z_384 - z_783*phi_ddot - z_653*phi_ddot - z_1876*z_363 - z_44*z_1883 - z_37*z_1884 - z_1828*z_404);
    D[197] = -(cos_delta*(z_64*z_1301 + z_1144*z_431 + cos_tilt*z_504*z_1850 + z_648*z_876 + z_647*z_874 +
        sin_tilt*z_506*z_1850 + z_647*z_873 + z_648*z_877 + z_1846*z_912 + sin_tilt*z_13*z_1878 + z_1858*z_1749 +
        z_1858*z_1747 + z_1858*z_1745 + z_1859*z_859 + z_1859*z_894 + z_1860*z_862 + z_1860*z_895 + z_1880*z_904 +
        z_1880*z_905 + z_1298*phi_ddot + cos_tilt*z_650*z_1865 + z_1882*z_922 + z_1882*z_923 + z_1873*z_867 +
        z_1875*z_860 + z_1876*z_864 + z_1825*z_430 - z_1847*z_913 - z_650*z_871 - cos_tilt*z_10*z_1878 -
        z_1858*z_1750 - z_1858*z_865 - z_1859*z_857 - z_1860*z_863 - z_1881*z_906 - z_1881*z_907 -
        delta_ddot*z_1660 - delta_ddot*z_1661 - sin_tilt*z_650*z_1866 - z_647*z_1837 - z_648*z_1836 - z_1873*z_868
        - z_1828*z_432 - z_1828*z_434 - z_1825*z_433) + sin_delta*(z_64*z_1660 + z_64*z_1661 + z_650*z_939 +
        z_650*z_938 + z_647*z_940 + z_648*z_941 + z_501*z_1850 + z_1858*z_937 + delta_ddot*z_1301 + (r_F*z_29 +
        2.0*r_F*z_23 + r_F*z_26 + z_506*z_1847 + z_451*z_1859 + z_452*z_1859 + z_13*z_1880 + r_F*z_147 +
        z_648*z_1866 + sin_theta*z_1884 - r_F*z_163 - z_1875*z_16)*z_36 + (c_*z_28 + c_*z_21 + z_449*z_1860 +
        z_10*z_1881 + z_1876*z_22 - 2.0*c_*z_18 - z_504*z_1846 - z_450*z_1860 - c_*z_150 - c_*z_164 - z_647*z_1865
        - cos_theta*z_1883)*z_33 - 2.0*z_1144*z_443 - z_1878*z_1313 - z_1878*z_1312 - z_1858*z_936 - z_1858*z_188
        - z_1859*z_934 - z_1860*z_935 - z_650*z_1802 - sin_phi*z_1873 - z_42*(r_F*z_28 + c_*z_29 + 2.0*c_*z_23 +
        r_F*z_21 + c_*z_26 + z_506*z_1846 + z_450*z_1859 + z_10*z_1880 + z_13*z_1881 + c_*z_147 + z_648*z_1865 +
        z_1876*z_16 + sin_theta*z_1883 - 2.0*r_F*z_18 - z_504*z_1847 - z_449*z_1859 - z_451*z_1860 - z_452*z_1860
        - r_F*z_150 - r_F*z_164 - c_*z_163 - z_647*z_1866 - z_1875*z_22 - cos_theta*z_1884)));
    D[200] = -z_5;
    D[201] = -z_7;
    D[202] = -(((z_769*z_188 - sin_phi*z_1877) + (z_653*z_451 + z_653*z_452 + z_1852*z_16) + (z_651*z_449 -
        z_651*z_450 - z_1851*z_22) + z_102) + z_110);
    const double z_1885 = z_1492*z_449 - z_1492*z_450;
    const double z_1886 = z_1467*z_451 + z_1467*z_452;
    const double z_1887 = z_1466*z_451 + z_1466*z_452;
    const double z_1888 = z_1491*z_449 - z_1491*z_450;
    const double z_1889 = (z_1145*z_188 + z_1298*z_326) + z_1056;
    D[203] = ((z_653*z_13 - sin_theta*z_1852) + (z_1886 - c_*z_626) + (r_F*z_618 + z_1887) - (z_651*z_10 +
        cos_theta*z_1851) - (z_1885 - c_*z_625) - (r_F*z_619 + z_1888) - z_1889) + z_22*z_1727 + z_16*z_1726 +
        z_651*z_961 + z_656*z_1858 + z_113*z_1859 + z_112*z_1859 + z_1886 + z_1887 - z_653*z_962 - z_769*z_780 -
        z_655*z_1858 - z_143*z_1858 - z_63*z_1859 - z_85*z_1860 - z_116*z_1860 - z_115*z_1860 - z_1889 - z_1885 -
        z_1888;
    const double z_1890 = z_1467*z_75 + z_1467*z_77;
    const double z_1891 = z_1466*z_75 + z_1466*z_77;
    const double z_1892 = z_1492*z_71 - z_1492*z_69;
    const double z_1893 = z_1491*z_71 - z_1491*z_69;
    const double z_1894 = (z_52*z_71 - z_52*z_69) - (r_R*z_75 + r_R*z_77);
    D[204] = (z_1877 + (c_*z_202 + z_1890) + (z_1891 - r_F*z_967) + z_1894 - (z_1892 - c_*z_968) - (r_F*z_208 +
        z_1893)) + z_25*z_1727 + z_653*z_311 + z_1878*z_723 + z_1374*z_1859 + z_1372*z_1860 + z_173*z_1880 +
        z_263*z_1880 + z_170*z_1881 + z_261*z_1881 + z_1894 + z_1890 + z_1891 - z_20*z_1726 - z_651*z_314 -
        z_651*z_505 - z_653*z_503 - z_1878*z_722 - z_1858*z_1419 - z_1858*z_1418 - z_73*z_1859 - z_90*z_1860 -
        psi_dot*z_342 - psi_dot*z_344 - z_1892 - z_1893;
    const double z_1895 = (z_326*z_1660 + (z_75*z_1621 + z_77*z_1621)) - ((z_39*z_1301 + z_1144*z_467) -
        (z_326*z_1661 + (z_71*z_1642 - z_69*z_1642)));
    D[205] = -(z_648*z_1013 + z_647*z_1011 + z_647*z_1010 + z_648*z_1014 + z_1878*z_1346 + z_1878*z_1345 +
        z_1858*z_1004 + z_999*z_1859 + z_1000*z_1859 + z_1001*z_1860 + z_1003*z_1860 + z_736*z_1880 + z_738*z_1880
        - (cos_tilt*z_1847 + sin_tilt*z_1846 + z_1895) - z_650*z_1007 - z_650*z_1006 - z_647*z_1009 - z_648*z_1012
        - z_650*z_1008 - z_1858*z_1005 - z_1858*z_161 - z_998*z_1859 - z_1002*z_1860 - z_732*z_1881 - z_734*z_1881
        - z_1895);
    D[207] = z_1850;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double tilt = c[2];
    const double cos_tilt = em_cos(tilt);
    const double delta = x[5];
    const double sin_delta = em_sin(delta);
    const double z_2 = cos_tilt*sin_delta;
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double delta_dot = v[5];
    const double z_4 = delta_dot*delta_dot;
    const double z_5 = cos_phi*z_4;
    const double cos_delta = em_cos(delta);
    const double z_7 = delta_dot*cos_delta;
    const double z_8 = cos_tilt*z_7;
    const double phi_dot = v[3];
    const double sin_phi = em_sin(phi);
    const double z_10 = phi_dot*sin_phi;
    const double z_11 = z_8*z_10;
    const double sin_tilt = em_sin(tilt);
    const double z_13 = sin_tilt*sin_tilt;
    const double z_14 = cos_tilt*cos_tilt;
    const double z_15 = z_13 + cos_delta*z_14;
    const double theta = x[4];
    const double cos_theta = em_cos(theta);
    const double z_17 = cos_theta*cos_phi;
    const double theta_dot = v[4];
    const double z_18 = phi_dot*theta_dot;
    const double z_19 = z_17*z_18;
    const double z_20 = z_15*z_19;
    const double sin_theta = em_sin(theta);
    const double z_22 = sin_theta*cos_phi;
    const double z_23 = phi_dot*z_22;
    const double z_24 = delta_dot*sin_delta;
    const double z_25 = z_24*z_14;
    const double z_26 = z_23*z_25;
    const double z_27 = phi_dot*phi_dot;
    const double z_28 = sin_phi*sin_theta;
    const double z_29 = z_27*z_28;
    const double z_30 = z_26 + z_15*z_29;
    const double z_31 = sin_tilt*cos_tilt;
    const double z_32 = sin_tilt*cos_delta;
    const double z_33 = z_31 - cos_tilt*z_32;
    const double z_34 = z_22*z_18;
    const double z_35 = z_33*z_34;
    const double z_36 = phi_dot*z_17;
    const double z_37 = sin_tilt*z_24;
    const double z_38 = cos_tilt*z_37;
    const double z_39 = z_36*z_38;
    const double z_40 = sin_phi*cos_theta;
    const double z_41 = z_27*z_40;
    const double z_42 = z_39 - z_33*z_41;
    const double z_43 = theta_dot*theta_dot;
    const double z_44 = z_43*z_28;
    const double z_45 = theta_dot*z_40;
    const double z_46 = z_45*z_25;
    const double z_47 = z_15*z_44 + z_46;
    const double z_48 = cos_phi*z_27;
    const double z_49 = z_43*z_40;
    const double z_50 = theta_dot*z_28;
    const double z_51 = z_50*z_38;
    const double z_52 = z_33*z_49 + z_51;
    const double z_53 = cos_delta*z_4;
    const double z_54 = z_53*z_28;
    const double z_55 = sin_tilt*z_53;
    const double z_56 = z_40*z_55;
    const double z_57 = (z_2*z_5 + z_11) + (z_35 - z_42) + (z_11 + z_48*z_2) + (z_35 + z_52) + (z_26 + z_46 +
        z_54*z_14) - (z_20 - z_30) - (z_20 - z_47) - (z_39 + cos_tilt*z_56 - z_51);
    const double m_H = c[8];
    const double psi = x[2];
    const double sin_psi = em_sin(psi);
    const double z_59 = m_H*sin_psi;
    const double z_60 = theta_dot*sin_theta;
    const double z_61 = z_60*z_25;
    const double z_62 = cos_theta*z_53;
    const double z_63 = theta_dot*cos_theta;
    const double z_64 = z_63*z_38;
    const double z_65 = sin_theta*z_55;
    const double z_66 = cos_theta*z_43;
    const double z_67 = sin_theta*z_43;
    const double z_68 = (z_15*z_66 - z_61) - (z_33*z_67 - z_64);
    const double z_69 = (z_64 + cos_tilt*z_65) + z_68 - (z_61 - z_62*z_14);
    const double cos_psi = em_cos(psi);
    const double z_71 = m_H*cos_psi;
    const double z_72 = cos_theta*z_25;
    const double z_73 = sin_theta*z_38;
    const double z_74 = (z_15*z_60 + z_72) + (z_33*z_63 + z_73);
    const double z_75 = z_74;
    const double psi_dot = v[2];
    const double z_76 = psi_dot*sin_psi;
    const double z_77 = m_H*z_76;
    const double z_78 = z_28*z_25 - (z_15*z_23 + z_15*z_45);
    const double z_79 = (z_40*z_38 + (z_33*z_36 - z_33*z_50)) + (cos_phi*z_8 - z_2*z_10);
    const double z_80 = (-z_78) + z_79;
    const double z_81 = psi_dot*cos_psi;
    const double z_82 = m_H*z_81;
    const double z_83 = z_79 - z_78;
    const double theta_ddot = a[4];
    const double z_84 = cos_theta*theta_ddot;
    const double z_85 = cos_psi*z_33;
    const double delta_ddot = a[5];
    const double z_86 = sin_delta*delta_ddot;
    const double z_87 = sin_theta*z_86;
    const double z_88 = z_86*z_40;
    const double z_89 = cos_psi*z_87 + sin_psi*z_88;
    const double z_90 = cos_theta*z_86;
    const double z_91 = z_86*z_28;
    const double z_92 = cos_psi*z_90 - sin_psi*z_91;
    const double z_93 = theta_ddot*z_28;
    const double z_94 = z_33*sin_psi;
    const double z_95 = theta_ddot*z_40;
    const double z_96 = z_15*sin_psi;
    const double z_97 = sin_theta*theta_ddot;
    const double z_98 = cos_psi*z_15;
    const double phi_ddot = a[3];
    const double z_99 = phi_ddot*z_17;
    const double z_100 = phi_ddot*z_22;
    const double z_101 = cos_delta*cos_phi;
    const double z_102 = z_101*delta_ddot;
    const double z_103 = sin_phi*sin_delta;
    const double z_104 = phi_ddot*z_103;
    const double z_105 = sin_psi*z_102 - sin_psi*z_104;
    const double z_106 = z_84*z_85 + z_31*z_89 + z_92*z_14 + z_95*z_96 + z_97*z_98 + z_99*z_94 + z_100*z_96 +
        cos_tilt*z_105 - z_93*z_94;
    const double z_107 = cos_theta*z_15;
    const double z_108 = sin_theta*z_33;
    const double z_109 = z_107 - z_108;
    const double z_110 = psi_dot*psi_dot;
    const double psi_ddot = a[2];
    const double z_111 = sin_psi*psi_ddot;
    const double z_112 = z_110*z_71 + m_H*z_111;
    const double z_113 = z_33*z_40;
    const double z_114 = z_15*z_28 + z_113 + cos_phi*z_2;
    const double z_115 = cos_psi*psi_ddot;
    const double z_116 = z_110*z_59 - m_H*z_115;
    const double z_117 = z_57*z_59 + z_75*z_77 + z_74*z_77 + z_114*z_116 - z_69*z_71 - z_80*z_82 - z_83*z_82 -
        m_H*z_106 - z_109*z_112;
    const double m_F = c[9];
    const double z_118 = m_F*cos_psi;
    const double z_119 = z_110*z_118 + m_F*z_111;
    const double z_120 = z_112 + z_119;
    const double z_121 = m_F + m_H;
    const double z_122 = sin_psi*z_121;
    const double z_123 = cos_psi*z_121;
    const double z_124 = z_121 + z_121;
    const double z_125 = z_124*z_81;
    const double z_126 = z_121*z_60;
    const double z_127 = sin_psi*z_95 + cos_psi*z_97 + sin_psi*z_100;
    const double z_128 = m_F*sin_psi;
    const double z_129 = z_110*z_128 - m_F*z_115;
    const double z_130 = z_116 + z_129;
    const double z_131 = z_117 + (cos_theta*z_120 + 2.0*z_19*z_122 + z_66*z_123 + z_45*z_125 + z_23*z_125 +
        z_121*z_127 - z_44*z_122 - z_29*z_122 - 2.0*z_76*z_126 - z_130*z_28);
    D[0] = -z_131;
    const double z_132 = m_F*z_76;
    const double z_133 = m_F*z_81;
    D[1] = -(z_57*z_128 + z_75*z_132 + z_74*z_132 + z_131 + z_114*z_129 - z_69*z_118 - z_80*z_133 - z_83*z_133 -
        m_F*z_106 - z_109*z_119);
    const double c_ = c[1];
    const double z_134 = m_F*c_;
    const double w = c[0];
    const double z_135 = c_ + w;
    const double x_H = c[12];
    const double z_136 = z_135 - x_H;
    const double z_137 = m_H*z_136;
    const double z_138 = z_134 + z_137;
    const double z_139 = sin_psi*z_138;
    const double z_140 = z_37*z_50;
    const double z_141 = cos_phi*sin_delta;
    const double z_142 = z_27*z_141;
    const double z_143 = z_37*z_36;
    const double z_144 = z_7*z_10;
    const double z_145 = z_4*z_141;
    const double z_146 = cos_psi*z_138;
    const double z_147 = z_63*z_37;
    const double z_148 = z_138*z_81;
    const double z_149 = z_40*z_37;
    const double z_150 = phi_dot*z_103;
    const double z_151 = cos_phi*z_7;
    const double z_152 = sin_theta*z_37;
    const double z_153 = z_138*z_76;
    const double z_154 = sin_tilt*z_138;
    const double z_155 = z_136*z_116 + c_*z_129;
    const double r_F = c[5];
    const double z_156 = m_F*r_F;
    const double z_H = c[13];
    const double z_157 = m_H*z_H;
    const double z_158 = z_156 + z_157;
    const double z_159 = sin_psi*z_158;
    const double z_160 = cos_psi*z_158;
    const double z_161 = z_158*z_81;
    const double z_162 = z_158*z_76;
    const double z_163 = z_136*z_112 + c_*z_119;
    const double z_164 = z_H*z_112 + r_F*z_119;
    const double z_165 = z_H*z_116 + r_F*z_129;
    const double z_166 = z_49*z_139 + z_41*z_139 + 2.0*z_34*z_139 + z_44*z_159 + z_29*z_159 + z_67*z_146 +
        2.0*z_50*z_148 + 2.0*z_60*z_162 + 2.0*z_63*z_153 + z_93*z_139 + sin_theta*z_163 + z_165*z_28 + z_155*z_40
        - 2.0*z_19*z_159 - z_66*z_160 - 2.0*z_36*z_148 - 2.0*z_45*z_161 - 2.0*z_23*z_161 - z_95*z_159 - z_97*z_160
        - z_84*z_146 - z_100*z_159 - z_99*z_139 - cos_theta*z_164;
    const double z_167 = z_44*z_139 + z_29*z_139 + 2.0*z_60*z_153 + z_155*z_28 - 2.0*z_19*z_139 - z_66*z_146 -
        2.0*z_45*z_148 - 2.0*z_23*z_148 - z_95*z_139 - z_97*z_146 - z_100*z_139 - cos_theta*z_163;
    const double z_168 = cos_tilt*cos_delta;
    const double z_169 = z_41*z_159 + z_49*z_159 + 2.0*z_34*z_159 + z_67*z_160 + 2.0*z_50*z_161 + 2.0*z_63*z_162 +
        z_93*z_159 + sin_theta*z_164 + z_165*z_40 - 2.0*z_36*z_161 - z_84*z_160 - z_99*z_159;
    const double z_170 = cos_tilt*z_138;
    const double z_171 = sin_tilt*z_158;
    const double z_172 = 2.0*z_170 - z_171;
    const double z_173 = sin_psi*z_172;
    const double z_174 = z_24*z_172;
    const double z_175 = sin_psi*z_174;
    const double z_176 = cos_psi*z_172;
    const double z_177 = cos_psi*z_174;
    const double z_178 = z_28*z_174;
    const double z_179 = cos_theta*z_174;
    const double z_180 = cos_tilt*z_53;
    const double z_181 = z_28*z_180;
    const double z_182 = cos_tilt*z_24;
    const double z_183 = z_182*z_45;
    const double z_184 = z_182*z_23;
    const double z_185 = cos_theta*z_180;
    const double z_186 = z_60*z_182;
    const double z_187 = z_28*z_182;
    const double z_188 = cos_theta*z_182;
    const double z_189 = cos_tilt*z_158;
    const double z_190 = z_53*z_40;
    const double z_191 = z_170 - 2.0*z_171;
    const double z_192 = sin_psi*z_191;
    const double z_193 = z_24*z_191;
    const double z_194 = sin_psi*z_193;
    const double z_195 = sin_theta*z_53;
    const double z_196 = cos_psi*z_191;
    const double z_197 = cos_psi*z_193;
    const double z_198 = z_40*z_193;
    const double z_199 = sin_theta*z_193;
    D[2] = -(sin_tilt*(z_139*z_56 + 2.0*z_139*z_143 + z_146*z_65 + 2.0*z_146*z_147 + 2.0*z_148*z_149 +
        2.0*z_151*z_148 + z_89*z_154 + z_138*z_105 + z_166*z_32 + z_62*z_176 + z_92*z_172 - 2.0*z_139*z_140 -
        z_142*z_139 - 2.0*z_144*z_139 - z_145*z_139 - 2.0*z_150*z_148 - 2.0*z_152*z_153 - z_155*z_141 -
        sin_tilt*z_166 - 2.0*z_167*z_168 - 2.0*cos_tilt*z_169 - z_54*z_173 - 2.0*z_45*z_175 - 2.0*z_23*z_175 -
        2.0*z_60*z_177 - 2.0*z_81*z_178 - 2.0*z_76*z_179) - cos_tilt*(z_159*z_181 + 2.0*z_159*z_183 + z_142*z_159
        + 2.0*z_159*z_184 + 2.0*z_144*z_159 + z_145*z_159 + 2.0*z_160*z_186 + 2.0*z_161*z_187 + 2.0*z_150*z_161 +
        2.0*z_188*z_162 + z_165*z_141 + z_166*z_168 + z_190*z_192 + 2.0*z_36*z_194 + z_195*z_196 + 2.0*z_63*z_197
        + 2.0*z_81*z_198 + z_89*z_191 - z_160*z_185 - 2.0*z_151*z_161 - z_92*z_189 - z_158*z_105 - 2.0*z_169*z_32
        - cos_tilt*z_166 - 2.0*sin_tilt*z_167 - 2.0*z_50*z_194 - 2.0*z_76*z_199));
    const double m_R = c[6];
    const double m_B = c[7];
    const double z_200 = m_B + z_121;
    const double z_201 = m_R + z_200;
    const double z_202 = sin_phi*z_27;
    const double z_203 = z_201*z_202;
    const double z_204 = m_R*sin_phi;
    const double z_205 = z_110*z_204;
    const double z_206 = z_121*z_63;
    const double z_207 = sin_psi*z_93 - cos_psi*z_84 - sin_psi*z_99;
    const double z_208 = z_201*cos_phi;
    const double z_209 = phi_ddot*z_208;
    const double z_210 = m_B*cos_psi;
    const double z_211 = z_110*z_210 + m_B*z_111;
    const double z_212 = m_B*sin_psi;
    const double z_213 = m_B*z_81;
    const double z_214 = m_B*z_76;
    const double z_215 = z_110*z_212 - m_B*z_115;
    const double z_216 = sin_theta*z_211 + z_49*z_212 + z_41*z_212 + 2.0*z_34*z_212 + z_67*z_210 + 2.0*z_50*z_213
        + 2.0*z_63*z_214 + m_B*z_207 + z_215*z_40 - 2.0*z_36*z_213;
    const double z_217 = phi_dot*cos_phi;
    const double z_218 = (m_R + (m_R + 2.0*z_200))*z_217;
    D[4] = sin_theta*z_120 + z_49*z_122 + z_41*z_122 + 2.0*z_34*z_122 + z_67*z_123 + z_50*z_125 + 2.0*z_76*z_206 +
        z_121*z_207 + sin_psi*z_209 + z_115*z_204 + z_130*z_40 + z_216 + z_81*z_218 - sin_psi*z_203 -
        sin_psi*z_205 - z_36*z_125 - sin_phi*(z_130 + z_215);
    const double z_219 = sin_tilt*sin_delta;
    const double z_220 = sin_tilt*z_7;
    const double z_221 = z_220*z_10;
    const double z_222 = z_14 + cos_delta*z_13;
    const double z_223 = z_222*z_34;
    const double z_224 = z_24*z_13;
    const double z_225 = z_50*z_224;
    const double z_226 = z_222*z_49 - z_225;
    const double z_227 = z_36*z_224;
    const double z_228 = z_222*z_41 + z_227;
    const double z_229 = z_33*z_19;
    const double z_230 = z_23*z_38;
    const double z_231 = z_230 - z_33*z_29;
    const double z_232 = z_45*z_38;
    const double z_233 = z_33*z_44 - z_232;
    const double z_234 = z_28*z_55;
    const double z_235 = (z_219*z_5 + z_221) + (z_229 + z_231) + (z_221 + z_48*z_219) + (z_229 - z_233) + (z_225 -
        z_227 - z_190*z_13) + (z_230 + z_232 + cos_tilt*z_234) - (z_223 + z_226) - (z_223 + z_228);
    const double z_236 = z_63*z_224;
    const double z_237 = z_60*z_38;
    const double z_238 = cos_theta*z_55;
    const double z_239 = (z_222*z_67 + z_236) - (z_33*z_66 + z_237);
    const double z_240 = (z_236 + z_195*z_13) + z_239 - (z_237 - cos_tilt*z_238);
    const double z_241 = sin_theta*z_224;
    const double z_242 = cos_theta*z_38;
    const double z_243 = (z_222*z_63 - z_241) + (z_33*z_60 - z_242);
    const double z_244 = z_243;
    const double z_245 = (cos_phi*z_220 - z_219*z_10) + ((z_40*z_224 + (z_222*z_50 - z_222*z_36)) - (z_28*z_38 +
        (z_33*z_23 + z_33*z_45)));
    const double z_246 = z_245;
    const double z_247 = z_222*sin_psi;
    const double z_248 = cos_psi*z_222;
    const double z_249 = z_97*z_85 + z_95*z_94 + z_84*z_248 + z_100*z_94 + z_99*z_247 - z_89*z_13 - z_31*z_92 -
        z_93*z_247 - sin_tilt*z_105;
    const double z_250 = sin_theta*z_222;
    const double z_251 = cos_theta*z_33;
    const double z_252 = z_250 - z_251;
    const double z_253 = z_33*z_28;
    const double z_254 = z_222*z_40 + z_253 - cos_phi*z_219;
    D[5] = z_235*z_128 + m_F*z_249 - z_240*z_118 - z_244*z_132 - z_246*z_133 - z_245*z_133 - z_243*z_132 -
        z_252*z_119 - z_254*z_129;
    const double r_R = c[4];
    const double z_255 = psi_dot*z_217;
    const double x_dot = v[0];
    const double y_dot = v[1];
    const double z_256 = x_dot*z_76 - y_dot*z_81;
    const double z_257 = z_256 - r_R*z_255;
    const double z_258 = r_R*sin_phi;
    const double z_259 = z_258*z_27 - (x_dot*z_81 + y_dot*z_76);
    const double z_260 = -z_259;
    const double z_261 = x_dot*cos_psi + y_dot*sin_psi;
    const double z_262 = psi_dot*z_258 + z_261;
    const double z_263 = r_R*z_217;
    const double z_264 = y_dot*cos_psi - x_dot*sin_psi;
    const double z_265 = z_263 - z_264;
    const double z_266 = -z_265;
    const double x_ddot = a[0];
    const double z_267 = r_R*cos_phi;
    const double z_268 = z_267*phi_ddot;
    const double z_269 = x_ddot + sin_psi*z_268;
    D[6] = -(cos_psi*z_257 + z_262*z_76 + z_266*z_81 - sin_psi*z_260 - z_258*z_115 - z_269);
    const double x_B = c[10];
    const double z_B = c[11];
    const double z_270 = r_R - z_B;
    const double z_271 = (x_B*z_23 + x_B*z_45) + (z_270*z_36 - z_270*z_50);
    const double z_272 = z_263 - z_271;
    const double z_273 = x_B*z_66 + z_256 - psi_dot*z_272 - z_270*z_67;
    const double z_274 = x_B*z_60 + z_270*z_63;
    const double z_275 = x_B*z_19;
    const double z_276 = z_270*z_34;
    const double z_277 = psi_dot*z_274 + (z_276 + z_270*z_41) + (z_276 + z_270*z_49) - (z_275 - x_B*z_29) - (z_275
        - x_B*z_44) - z_259;
    const double z_278 = x_B*z_28;
    const double z_279 = z_270*z_40;
    const double z_280 = z_258 - z_278 - z_279;
    const double z_281 = psi_dot*z_280 + z_261 - z_274;
    const double z_282 = x_B*cos_theta - sin_theta*z_270;
    const double z_283 = psi_dot*z_282 + z_271 - z_265;
    D[7] = -(cos_psi*z_273 + z_281*z_76 + z_283*z_81 + x_B*z_127 + z_282*z_111 - sin_psi*z_277 - z_270*z_207 -
        z_280*z_115 - z_269);
    const double z_284 = (r_R*z_36 - r_R*z_50) + (z_135*z_23 + z_135*z_45);
    const double z_285 = z_263 - z_284;
    const double z_286 = z_136*z_80 + z_285 - z_H*z_246;
    const double z_287 = z_256 - (r_R*z_67 - z_135*z_66);
    const double z_288 = z_H*z_240 + z_287 - psi_dot*z_286 - z_136*z_69;
    const double z_289 = r_R*z_63 + z_135*z_60;
    const double z_290 = z_289 - z_H*z_244 - z_136*z_75;
    const double z_291 = z_135*z_19;
    const double z_292 = r_R*z_34;
    const double z_293 = ((z_291 - z_135*z_44) - (z_292 + r_R*z_49)) + (z_259 - ((z_292 + r_R*z_41) - (z_291 -
        z_135*z_29)));
    const double z_294 = psi_dot*z_290 + z_H*z_235 - z_136*z_57 - z_293;
    const double z_295 = z_254*z_H;
    const double z_296 = z_114*z_136;
    const double z_297 = z_258 - (r_R*z_40 + z_135*z_28);
    const double z_298 = z_295 + z_296 + z_297;
    const double z_299 = z_261 - z_289;
    const double z_300 = psi_dot*z_298 + z_H*z_243 + z_136*z_74 + z_299;
    const double z_301 = cos_theta*z_135 - r_R*sin_theta;
    const double z_302 = z_H*z_252 + z_301 - z_136*z_109;
    const double z_303 = z_265 - z_284;
    const double z_304 = psi_dot*z_302 + z_H*z_245 - z_136*z_83 - z_303;
    const double z_305 = (r_R*z_207 - z_135*z_127) + z_269;
    D[8] = -(cos_psi*z_288 + z_300*z_76 + z_304*z_81 + z_302*z_111 - sin_psi*z_294 - z_H*z_249 - z_136*z_106 -
        z_298*z_115 - z_305);
    const double z_306 = c_*z_80 + z_285 - r_F*z_246;
    const double z_307 = r_F*z_240 + z_287 - psi_dot*z_306 - c_*z_69;
    const double z_308 = z_289 - r_F*z_244 - c_*z_75;
    const double z_309 = psi_dot*z_308 + r_F*z_235 - c_*z_57 - z_293;
    const double z_310 = c_*z_114;
    const double z_311 = r_F*z_254;
    const double z_312 = z_310 + z_311 + z_297;
    const double z_313 = psi_dot*z_312 + c_*z_74 + r_F*z_243 + z_299;
    const double z_314 = r_F*z_252 + z_301 - c_*z_109;
    const double z_315 = psi_dot*z_314 + r_F*z_245 - c_*z_83 - z_303;
    D[9] = -(cos_psi*z_307 + z_313*z_76 + z_315*z_81 + z_314*z_111 - sin_psi*z_309 - r_F*z_249 - c_*z_106 -
        z_312*z_115 - z_305);
    D[10] = -(cos_theta*z_211 + 2.0*z_19*z_212 + z_66*z_210 + 2.0*z_45*z_213 + 2.0*z_23*z_213 + m_B*z_127 -
        z_44*z_212 - z_29*z_212 - 2.0*z_60*z_214 - z_215*z_28);
    D[11] = -z_216;
    D[12] = z_117;
    D[13] = z_235*z_59 + m_H*z_249 - z_240*z_71 - z_244*z_77 - z_246*z_82 - z_245*z_82 - z_243*z_77 - z_252*z_112
        - z_254*z_116;
    const double z_316 = sin_psi*z_87 - cos_psi*z_88;
    const double z_317 = sin_psi*z_90 + cos_psi*z_91;
    const double z_318 = cos_psi*z_102 - cos_psi*z_104;
    const double z_319 = z_84*z_94 + z_93*z_85 + z_97*z_96 + z_31*z_316 + z_317*z_14 - z_95*z_98 - z_99*z_85 -
        z_100*z_98 - cos_tilt*z_318;
    const double z_320 = z_57*z_71 + z_69*z_59 + z_75*z_82 + z_80*z_77 + z_83*z_77 + z_74*z_82 + m_H*z_319 +
        z_109*z_116 + z_114*z_112;
    const double z_321 = z_124*z_76;
    const double z_322 = sin_psi*z_97 - cos_psi*z_95 - cos_psi*z_100;
    const double z_323 = z_320 - (cos_theta*z_130 + z_44*z_123 + z_29*z_123 + z_66*z_122 + z_45*z_321 + z_23*z_321
        + 2.0*z_81*z_126 + z_121*z_322 + z_120*z_28 - 2.0*z_19*z_123);
    D[27] = z_323;
    D[28] = z_57*z_118 + z_69*z_128 + z_75*z_133 + z_80*z_132 + z_83*z_132 + z_74*z_133 + m_F*z_319 + z_109*z_129
        + z_323 + z_114*z_119;
    const double z_324 = z_49*z_146 + z_41*z_146 + 2.0*z_34*z_146 + z_44*z_160 + z_29*z_160 + z_66*z_159 +
        2.0*z_36*z_153 + 2.0*z_45*z_162 + 2.0*z_23*z_162 + 2.0*z_60*z_161 + 2.0*z_63*z_148 + z_93*z_146 +
        z_97*z_159 + z_84*z_139 + cos_theta*z_165 + z_164*z_28 + z_163*z_40 - 2.0*z_19*z_160 - z_67*z_139 -
        2.0*z_50*z_153 - z_95*z_160 - z_100*z_160 - z_99*z_146 - sin_theta*z_155;
    const double z_325 = z_44*z_146 + z_29*z_146 + z_66*z_139 + 2.0*z_45*z_153 + 2.0*z_23*z_153 + 2.0*z_60*z_148 +
        z_97*z_139 + cos_theta*z_155 + z_163*z_28 - 2.0*z_19*z_146 - z_95*z_146 - z_100*z_146;
    const double z_326 = z_41*z_160 + z_49*z_160 + 2.0*z_34*z_160 + 2.0*z_36*z_162 + 2.0*z_63*z_161 + z_93*z_160 +
        z_84*z_159 + z_164*z_40 - z_67*z_159 - 2.0*z_50*z_162 - z_99*z_160 - sin_theta*z_165;
    D[29] = sin_tilt*(z_146*z_56 + 2.0*z_146*z_143 + 2.0*z_150*z_153 + z_138*z_318 + z_324*z_32 + 2.0*z_60*z_175 +
        2.0*z_76*z_178 - 2.0*z_146*z_140 - z_142*z_146 - 2.0*z_144*z_146 - z_145*z_146 - z_139*z_65 -
        2.0*z_139*z_147 - 2.0*z_153*z_149 - 2.0*z_151*z_153 - 2.0*z_152*z_148 - z_316*z_154 - z_163*z_141 -
        sin_tilt*z_324 - 2.0*z_325*z_168 - 2.0*cos_tilt*z_326 - z_54*z_176 - 2.0*z_45*z_177 - 2.0*z_23*z_177 -
        z_62*z_173 - 2.0*z_81*z_179 - z_172*z_317) - cos_tilt*(z_160*z_181 + 2.0*z_160*z_183 + z_142*z_160 +
        2.0*z_160*z_184 + 2.0*z_144*z_160 + z_145*z_160 + z_159*z_185 + 2.0*z_151*z_162 + 2.0*z_188*z_161 +
        z_317*z_189 + z_164*z_141 + z_324*z_168 + z_190*z_196 + 2.0*z_36*z_197 - 2.0*z_159*z_186 - 2.0*z_162*z_187
        - 2.0*z_150*z_162 - z_158*z_318 - 2.0*z_326*z_32 - cos_tilt*z_324 - 2.0*sin_tilt*z_325 - 2.0*z_50*z_197 -
        z_195*z_192 - 2.0*z_63*z_194 - 2.0*z_76*z_198 - 2.0*z_81*z_199 - z_191*z_316);
    const double z_327 = sin_psi*z_84 + cos_psi*z_93 - cos_psi*z_99;
    const double z_328 = sin_theta*z_215 + z_67*z_212 + 2.0*z_50*z_214 - z_49*z_210 - z_41*z_210 - 2.0*z_34*z_210
        - 2.0*z_36*z_214 - 2.0*z_63*z_213 - m_B*z_327 - z_211*z_40;
    D[31] = sin_theta*z_130 + z_67*z_122 + cos_psi*z_203 + cos_psi*z_205 + z_50*z_321 + z_111*z_204 + z_328 +
        sin_phi*(z_120 + z_211) + z_76*z_218 - z_49*z_123 - z_41*z_123 - 2.0*z_34*z_123 - z_36*z_321 -
        2.0*z_81*z_206 - cos_psi*z_209 - z_121*z_327 - z_120*z_40;
    const double z_329 = z_97*z_94 + z_93*z_248 + z_84*z_247 + sin_tilt*z_318 - z_95*z_85 - z_100*z_85 -
        z_99*z_248 - z_316*z_13 - z_31*z_317;
    D[32] = -(z_235*z_118 + z_240*z_128 + z_246*z_132 + z_245*z_132 + z_252*z_129 - z_244*z_133 - z_243*z_133 -
        m_F*z_329 - z_254*z_119);
    const double y_ddot = a[1];
    const double z_330 = y_ddot - cos_psi*z_268;
    D[33] = -(sin_psi*z_257 + cos_psi*z_260 + z_266*z_76 - z_262*z_81 - z_258*z_111 - z_330);
    D[34] = -(sin_psi*z_273 + cos_psi*z_277 + z_283*z_76 + z_270*z_327 + x_B*z_322 - z_281*z_81 - z_280*z_111 -
        z_282*z_115 - z_330);
    const double z_331 = (r_R*z_327 + z_135*z_322) - z_330;
    D[35] = -(sin_psi*z_288 + cos_psi*z_294 + z_304*z_76 + z_331 - z_300*z_81 - z_298*z_111 - z_302*z_115 -
        z_H*z_329 - z_136*z_319);
    D[36] = -(sin_psi*z_307 + cos_psi*z_309 + z_315*z_76 + z_331 - z_313*z_81 - z_312*z_111 - z_314*z_115 -
        r_F*z_329 - c_*z_319);
    D[37] = -(cos_theta*z_215 + z_44*z_210 + z_29*z_210 + z_66*z_212 + 2.0*z_45*z_214 + 2.0*z_23*z_214 +
        2.0*z_60*z_213 + m_B*z_322 + z_211*z_28 - 2.0*z_19*z_210);
    D[38] = -z_328;
    D[39] = -z_320;
    D[40] = -(z_235*z_71 + z_240*z_59 + z_246*z_77 + z_245*z_77 + z_252*z_116 - z_244*z_82 - z_243*z_82 -
        m_H*z_329 - z_254*z_112);
    const double z_332 = m_H*z_302;
    const double z_333 = m_H*z_298;
    const double z_334 = psi_dot*m_H;
    const double z_335 = m_H*z_304 + z_302*z_334;
    const double z_336 = m_H*z_300 + z_298*z_334;
    const double z_337 = m_H*z_290 - m_H*z_261;
    const double z_338 = m_H*z_286 - m_H*z_264;
    const double z_339 = cos_tilt*z_219;
    const double z_340 = delta_ddot*z_339;
    const double z_341 = z_33*z_84 + z_15*z_97;
    const double z_342 = sin_theta*z_340 + z_90*z_14 + z_341;
    const double z_343 = cos_phi*delta_ddot;
    const double z_344 = sin_phi*z_2;
    const double z_345 = (z_33*z_93 - z_15*z_95) - (z_33*z_99 + z_15*z_100);
    const double z_346 = z_91*z_14 + z_344*phi_ddot + z_345 - z_340*z_40 - z_168*z_343;
    const double z_347 = m_H*z_294;
    const double z_348 = sin_phi*z_219;
    const double z_349 = (z_222*z_93 - z_33*z_95) - (z_33*z_100 + z_222*z_99);
    const double z_350 = z_88*z_13 + z_32*z_343 + z_349 - z_340*z_28 - z_348*phi_ddot;
    const double z_351 = (r_R*z_93 - z_135*z_95 - z_135*z_100 - r_R*z_99) + z_268;
    const double z_352 = cos_psi*y_ddot;
    const double z_353 = sin_psi*x_ddot;
    const double z_354 = z_347 + psi_dot*z_337 + m_H*z_351 + m_H*z_353 - 2.0*z_332*psi_ddot - z_157*z_350 -
        z_137*z_346 - m_H*z_352;
    const double z_355 = m_H*z_288;
    const double z_356 = z_135*z_97 + r_R*z_84;
    const double z_357 = z_33*z_97 + z_222*z_84;
    const double z_358 = z_357 - cos_theta*z_340 - z_87*z_13;
    const double z_359 = sin_psi*y_ddot;
    const double z_360 = cos_psi*x_ddot;
    const double z_361 = z_355 + m_H*z_356 - 2.0*z_333*psi_ddot - psi_dot*z_338 - z_137*z_342 - z_157*z_358 -
        m_H*z_359 - m_H*z_360;
    const double z_362 = z_332*z_57 + z_333*z_69 + z_75*z_335 + z_80*z_336 + z_83*z_337 + z_74*z_338 + z_333*z_342
        + z_332*z_346 + z_109*z_354 - z_114*z_361;
    const double z_363 = m_F*z_314;
    const double z_364 = z_363 + z_332;
    const double z_365 = m_F*z_312;
    const double z_366 = z_365 + z_333;
    const double z_367 = m_F*z_308 - m_F*z_261;
    const double z_368 = psi_dot*m_F;
    const double z_369 = m_F*z_313 + z_312*z_368;
    const double z_370 = z_367 + ((z_336 + z_369) + z_337);
    const double z_371 = m_F*z_315 + z_314*z_368;
    const double z_372 = m_F*z_306 - m_F*z_264;
    const double z_373 = z_335 + z_371 + z_338 + z_372;
    const double lambda_4 = lambda[4];
    const double z_374 = m_F*z_309;
    const double z_375 = lambda_4 - (z_374 + psi_dot*z_367 + m_F*z_351 + m_F*z_353 - 2.0*z_363*psi_ddot -
        z_156*z_350 - z_134*z_346 - m_F*z_352);
    const double z_376 = z_375 - z_354;
    const double lambda_3 = lambda[3];
    const double z_377 = m_F*z_307;
    const double z_378 = lambda_3 - (z_377 + m_F*z_356 - 2.0*z_365*psi_ddot - psi_dot*z_372 - z_134*z_342 -
        z_156*z_358 - m_F*z_359 - m_F*z_360);
    const double z_379 = z_361 - z_378;
    const double z_380 = -z_379;
    const double z_381 = z_362 - (z_364*z_44 + z_364*z_29 + z_366*z_66 + z_370*z_45 + z_370*z_23 + z_60*z_373 +
        z_366*z_97 + z_380*z_28 - 2.0*z_364*z_19 - z_364*z_95 - z_364*z_100 - cos_theta*z_376);
    D[54] = z_381;
    D[55] = z_363*z_57 + z_365*z_69 + z_75*z_371 + z_80*z_369 + z_83*z_367 + z_74*z_372 + z_365*z_342 +
        z_363*z_346 + z_381 + z_114*z_378 - z_109*z_375;
    const double H_xz = c[25];
    const double z_382 = psi_dot*z_22;
    const double z_383 = phi_dot*cos_theta - z_382;
    const double z_384 = psi_dot*z_17;
    const double z_385 = phi_dot*sin_theta + z_384;
    const double z_386 = z_33*z_385;
    const double z_387 = psi_dot*sin_phi;
    const double z_388 = theta_dot + z_387;
    const double z_389 = delta_dot*sin_tilt - z_388*z_2;
    const double z_390 = z_15*z_383 - z_386 - z_389;
    const double z_391 = H_xz*z_390;
    const double H_zz = c[24];
    const double z_392 = z_33*z_383;
    const double z_393 = delta_dot*cos_tilt + z_388*z_219;
    const double z_394 = z_222*z_385 + z_393 - z_392;
    const double F_xx = c[16];
    const double z_395 = 2.0*F_xx + H_zz;
    const double z_396 = z_391 - (H_zz*z_394 - z_391) - z_395*z_394;
    const double z_397 = z_22*z_37;
    const double z_398 = H_xz*z_394;
    const double H_xx = c[22];
    const double z_399 = H_xx + 2.0*F_xx;
    const double z_400 = z_398 - (H_xx*z_390 - z_398) - z_399*z_390;
    const double z_401 = z_22*z_182;
    const double z_402 = z_17*z_37;
    const double z_403 = z_385*z_224;
    const double z_404 = theta_dot*z_22;
    const double z_405 = phi_dot*z_40;
    const double z_406 = psi_dot*z_404 + psi_dot*z_405;
    const double z_407 = cos_theta*z_18 - z_406;
    const double z_408 = z_383*z_38;
    const double z_409 = theta_dot*z_17;
    const double z_410 = phi_dot*z_28;
    const double z_411 = psi_dot*z_409 - psi_dot*z_410;
    const double z_412 = sin_theta*z_18 + z_411;
    const double z_413 = z_388*z_220;
    const double z_414 = (z_403 - z_222*z_407) + (z_408 - z_33*z_412) - (z_413 + z_255*z_219);
    const double z_415 = H_xz*z_414;
    const double z_416 = z_383*z_25;
    const double z_417 = z_385*z_38;
    const double z_418 = z_388*z_8;
    const double z_419 = (z_416 + z_15*z_412) + (z_417 + z_33*z_407) - (z_418 + z_255*z_2);
    const double z_420 = z_415 - (H_xx*z_419 - z_415) - z_399*z_419;
    const double z_421 = sin_phi*z_7;
    const double z_422 = z_388*z_24;
    const double z_423 = z_383*z_8;
    const double z_424 = z_385*z_220;
    const double z_425 = (z_422 - cos_delta*z_255) + (z_423 - z_412*z_2) + (z_424 + z_407*z_219);
    const double F_yy = c[17];
    const double H_yy = c[23];
    const double z_426 = F_yy + H_yy;
    const double z_427 = sin_delta*z_426;
    const double z_428 = z_425*z_427;
    const double z_429 = cos_delta*z_388;
    const double z_430 = z_383*z_2 + z_385*z_219;
    const double z_431 = z_429 - z_430;
    const double spin_f_dot = v[7];
    const double z_432 = spin_f_dot + z_429;
    const double z_433 = z_432 - z_430;
    const double z_434 = H_yy*z_431 + F_yy*z_433;
    const double z_435 = z_22*z_7;
    const double z_436 = sin_phi*cos_delta;
    const double z_437 = z_22*z_2;
    const double z_438 = z_17*z_219;
    const double z_439 = z_426*z_436 + z_426*z_437 - z_426*z_438;
    const double z_440 = sin_delta*z_412;
    const double z_441 = z_383*z_7;
    const double z_442 = z_222*z_17;
    const double z_443 = z_33*z_22;
    const double z_444 = z_442 + z_443 + z_348;
    const double z_445 = z_15*z_22;
    const double z_446 = z_33*z_17;
    const double z_447 = z_344 - z_445 - z_446;
    const double z_448 = H_xx + z_399;
    const double z_449 = 2.0*H_xz*z_444 - z_447*z_448;
    const double z_450 = phi_dot*z_141;
    const double z_451 = psi_dot*z_450;
    const double z_452 = z_388*z_7;
    const double z_453 = z_385*z_37;
    const double z_454 = z_383*z_182;
    const double z_455 = H_zz + z_395;
    const double z_456 = 2.0*z_447*H_xz - z_444*z_455;
    const double z_457 = z_383*z_37;
    const double z_458 = z_314*z_134 + z_302*z_137;
    const double z_459 = z_314*z_156 + z_302*z_157;
    const double z_460 = z_37*z_45;
    const double z_461 = z_37*z_23;
    const double z_462 = z_312*z_156 + z_298*z_157;
    const double z_463 = z_60*z_37;
    const double z_464 = z_312*z_134 + z_298*z_137;
    const double z_465 = z_409 - z_410;
    const double z_466 = sin_delta*z_434;
    const double z_467 = (z_136*z_336 + c_*z_369) + (z_136*z_337 + c_*z_367);
    const double z_468 = (z_H*z_336 + r_F*z_369) + (z_H*z_337 + r_F*z_367);
    const double z_469 = z_28*z_37;
    const double z_470 = (z_H*z_335 + r_F*z_371) + (z_H*z_338 + r_F*z_372);
    const double z_471 = cos_theta*z_37;
    const double z_472 = (z_136*z_335 + c_*z_371) + (z_136*z_338 + c_*z_372);
    const double z_473 = cos_delta*z_217;
    const double z_474 = sin_phi*z_24;
    const double z_475 = z_473 - z_474;
    const double z_476 = z_8*z_22;
    const double z_477 = z_220*z_17;
    const double z_478 = z_405 + z_404;
    const double z_479 = z_475 + z_476 + z_465*z_2 + z_478*z_219 - z_477;
    const double z_480 = z_383*z_427;
    const double z_481 = sin_delta*z_388;
    const double z_482 = sin_phi*z_220 + z_219*z_217;
    const double z_483 = z_17*z_224;
    const double z_484 = z_22*z_38;
    const double z_485 = z_482 - (z_483 - z_484);
    const double z_486 = z_33*z_465 + z_485 - z_222*z_478;
    const double z_487 = sin_phi*z_8 + z_2*z_217;
    const double z_488 = z_22*z_25;
    const double z_489 = z_17*z_38;
    const double z_490 = z_487 + (z_488 - z_489);
    const double z_491 = z_33*z_478 + z_490 - z_15*z_465;
    const double z_492 = 2.0*H_xz*z_486 - z_448*z_491;
    const double z_493 = 2.0*H_xz*z_491 - z_455*z_486;
    const double z_494 = sin_delta*z_22;
    const double z_495 = cos_theta*z_2;
    const double z_496 = sin_theta*z_219;
    const double z_497 = z_495 + z_496;
    const double z_498 = z_436 + z_437 - z_438;
    const double z_499 = z_498*z_498;
    const double z_500 = 1.0 - z_499;
    const double z_501 = sqrt(z_500);
    const double z_502 = r_F*z_501;
    const double z_503 = 1.0/z_501;
    const double z_504 = r_F*z_503;
    const double z_505 = z_497*z_504;
    const double z_506 = z_497*z_502 + z_499*z_505;
    const double z_507 = z_506*lambda_4;
    const double z_508 = z_498*z_504;
    const double z_509 = z_497*z_508;
    const double z_510 = z_109*z_502 - z_447*z_509;
    const double z_511 = z_510*lambda_4;
    const double z_512 = z_101 + z_40*z_219 - z_28*z_2;
    const double z_513 = z_512*z_504;
    const double z_514 = z_512*z_502 + z_499*z_513;
    const double z_515 = z_514*lambda_3;
    const double z_516 = z_512*z_508;
    const double z_517 = z_114*z_502 + z_447*z_516;
    const double z_518 = z_517*lambda_3;
    const double z_519 = lambda_3*z_219;
    const double z_520 = z_443*lambda_3 + z_442*lambda_3 + sin_phi*z_519;
    const double z_521 = z_444*z_508;
    const double z_522 = lambda_3*z_2;
    const double z_523 = z_445*lambda_3 + z_446*lambda_3 - sin_phi*z_522;
    const double z_524 = z_447*z_508;
    const double z_525 = z_22*z_522 + z_436*lambda_3 - z_17*z_519;
    const double z_526 = z_499*z_504;
    const double z_527 = z_520*z_521 + z_525*z_526 + z_525*z_502 - z_523*z_524;
    const double z_528 = sin_delta*z_28;
    const double z_529 = lambda_4*z_2;
    const double z_530 = z_445*lambda_4 + z_446*lambda_4;
    const double z_531 = z_530 - sin_phi*z_529;
    const double z_532 = lambda_4*z_219;
    const double z_533 = z_443*lambda_4 + z_442*lambda_4;
    const double z_534 = sin_phi*z_532 + z_533;
    const double z_535 = z_22*z_529 + z_436*lambda_4 - z_17*z_532;
    const double z_536 = z_531*z_524 - z_534*z_521 - z_535*z_526 - z_535*z_502;
    const double z_537 = cos_theta*sin_delta;
    const double z_538 = delta_ddot*z_219;
    const double z_539 = z_459*z_538;
    const double z_540 = cos_theta*z_462;
    const double z_541 = sin_theta*z_464;
    const double z_542 = delta_ddot*z_2;
    const double z_543 = z_458*z_542;
    const double z_544 = cos_theta*phi_ddot;
    const double z_545 = psi_ddot*z_22;
    const double z_546 = z_544 - z_545;
    const double z_547 = z_498*z_427;
    const double spin_f_ddot = a[7];
    const double z_548 = F_yy*spin_f_ddot;
    const double z_549 = z_447*z_505;
    const double z_550 = z_444*z_505;
    const double z_551 = z_444*z_513;
    const double z_552 = z_447*z_513;
    const double z_553 = 1.0/(z_500*z_501);
    const double z_554 = r_F*z_553;
    const double z_555 = z_498*z_554;
    const double z_556 = z_447*z_497;
    const double z_557 = z_555*z_556;
    const double z_558 = z_109*z_504;
    const double z_559 = z_444*z_497;
    const double z_560 = z_555*z_559;
    const double z_561 = z_252*z_504;
    const double z_562 = z_499*z_554;
    const double z_563 = z_497*z_562;
    const double z_564 = z_444*z_512;
    const double z_565 = z_555*z_564;
    const double z_566 = z_254*z_504;
    const double z_567 = z_447*z_512;
    const double z_568 = z_555*z_567;
    const double z_569 = z_114*z_504;
    const double z_570 = z_512*z_562;
    const double z_571 = sin_theta*phi_ddot;
    const double z_572 = psi_ddot*z_17;
    const double z_573 = z_571 + z_572;
    const double z_574 = z_426*z_219;
    const double z_575 = z_426*z_2;
    const double z_576 = sin_phi*psi_ddot;
    const double z_577 = theta_ddot + z_576;
    const double z_578 = cos_delta*z_426;
    const double z_579 = z_548 + z_531*z_549 + z_523*z_552 + z_498*(z_531*z_557 + z_531*z_558 + z_535*z_505 +
        z_523*z_568 + z_525*z_513 - z_534*z_560 - z_534*z_561 - z_535*z_563 - z_520*z_565 - z_520*z_566 -
        z_523*z_569 - z_525*z_570) + z_577*z_578 - z_534*z_550 - 2.0*z_535*z_509 - z_520*z_551 - 2.0*z_525*z_516 -
        z_573*z_574 - z_546*z_575;
    const double z_580 = sin_delta*z_577;
    const double z_581 = cos_tilt*delta_ddot;
    const double z_582 = z_581 + z_222*z_573 + z_577*z_219 - z_33*z_546;
    const double z_583 = sin_tilt*delta_ddot;
    const double z_584 = z_583 + z_33*z_573 - z_15*z_546 - z_577*z_2;
    const double z_585 = 2.0*z_531*z_509 + 2.0*z_523*z_516 - 2.0*H_xz*z_582 - z_448*z_584;
    const double z_586 = z_523*z_502 + c_*z_378 - z_136*z_361;
    const double z_587 = H_xz*z_419;
    const double z_588 = z_587 - (H_zz*z_414 - z_587) - z_395*z_414;
    const double z_589 = z_252*z_502 - z_444*z_509;
    const double z_590 = z_589*lambda_4;
    const double z_591 = z_254*z_502 - z_444*z_516;
    const double z_592 = z_591*lambda_3;
    const double z_593 = 2.0*z_534*z_509 + 2.0*z_520*z_516 - z_455*z_582 - 2.0*H_xz*z_584;
    const double z_594 = z_531*z_502 + c_*z_375 - z_136*z_354;
    const double z_595 = z_534*z_502 + r_F*z_375 - z_H*z_354;
    const double z_596 = z_520*z_502 + r_F*z_378 - z_H*z_361;
    const double z_597 = z_588*z_22 + z_449*z_407 + 2.0*z_458*z_49 + 2.0*z_458*z_41 + 4.0*z_458*z_34 +
        2.0*z_459*z_44 + 2.0*z_459*z_29 + 2.0*z_462*z_66 + 2.0*z_467*z_36 + 2.0*z_468*z_45 + 2.0*z_468*z_23 +
        2.0*z_60*z_470 + 2.0*z_63*z_472 + z_385*z_492 + z_383*z_493 + 2.0*z_590*z_22 + 2.0*z_592*z_22 +
        2.0*z_518*z_17 + 2.0*z_458*z_93 + 2.0*z_462*z_97 + 2.0*z_464*z_84 + z_449*z_573 + z_456*z_546 +
        2.0*sin_theta*z_594 + 2.0*z_596*z_28 + 2.0*z_586*z_40 - z_420*z_17 - z_456*z_412 - 4.0*z_459*z_19 -
        2.0*z_464*z_67 - z_396*z_465 - z_400*z_478 - 2.0*z_467*z_50 - 2.0*z_511*z_17 - 2.0*z_459*z_95 -
        2.0*z_459*z_100 - 2.0*z_458*z_99 - z_593*z_22 - z_585*z_17 - 2.0*cos_theta*z_595;
    const double z_598 = z_420*z_22 + 4.0*z_458*z_19 + z_383*z_492 + 2.0*z_511*z_22 + 2.0*z_458*z_95 +
        2.0*z_458*z_100 + z_449*z_546 + z_585*z_22 + 2.0*cos_theta*z_594 - z_449*z_412 - 2.0*z_458*z_44 -
        2.0*z_458*z_29 - 2.0*z_464*z_66 - z_400*z_465 - 2.0*z_467*z_45 - 2.0*z_467*z_23 - 2.0*z_60*z_472 -
        2.0*z_518*z_22 - 2.0*z_464*z_97 - 2.0*z_586*z_28;
    const double z_599 = z_588*z_17 + 2.0*z_459*z_41 + 2.0*z_459*z_49 + 4.0*z_459*z_34 + z_396*z_478 +
        2.0*z_468*z_36 + 2.0*z_63*z_470 + 2.0*z_590*z_17 + 2.0*z_592*z_17 + 2.0*z_459*z_93 + 2.0*z_462*z_84 +
        2.0*sin_theta*z_595 + 2.0*z_596*z_40 - z_456*z_407 - 2.0*z_462*z_67 - 2.0*z_468*z_50 - z_385*z_493 -
        2.0*z_459*z_99 - z_456*z_573 - z_593*z_17;
    const double z_600 = z_17*z_182;
    const double z_601 = z_17*z_7;
    const double z_602 = sin_delta*z_407;
    const double z_603 = z_385*z_7;
    const double z_604 = z_385*z_182;
    const double z_605 = z_40*z_180;
    const double z_606 = z_182*z_50;
    const double z_607 = z_182*z_36;
    const double z_608 = z_63*z_182;
    const double z_609 = z_40*z_182;
    const double z_610 = sin_theta*z_182;
    const double z_611 = z_385*z_427;
    const double z_612 = sin_delta*z_17;
    const double z_613 = sin_delta*z_40;
    const double z_614 = sin_theta*sin_delta;
    D[56] = 0.5*(sin_tilt*(z_396*z_397 + 2.0*z_400*z_401 + z_400*z_421 + 2.0*z_22*z_428 + 2.0*z_439*z_441 +
        z_449*z_451 + z_449*z_452 + 2.0*z_458*z_56 + 4.0*z_458*z_143 + 2.0*z_459*z_234 + 4.0*z_459*z_460 +
        4.0*z_459*z_461 + 2.0*z_462*z_238 + 8.0*z_464*z_186 + z_400*z_450 + 4.0*z_467*z_187 + 2.0*z_467*z_150 +
        2.0*z_470*z_471 + 2.0*z_479*z_480 + z_481*z_492 + delta_dot*z_493 + 2.0*z_494*z_507 + 2.0*z_494*z_515 +
        2.0*z_518*z_103 + 2.0*z_28*z_539 + 2.0*z_458*z_538*z_40 + 2.0*z_538*z_540 + 2.0*z_458*z_102 +
        z_456*delta_ddot + 2.0*z_546*z_547 + z_449*z_580 + z_597*z_32 + 2.0*z_598*z_168 - z_400*z_402 -
        z_420*z_103 - 2.0*z_434*z_435 - 2.0*z_439*z_440 - z_449*z_453 - 2.0*z_449*z_454 - z_456*z_457 -
        4.0*z_458*z_181 - 4.0*z_458*z_140 - 2.0*z_458*z_142 - 8.0*z_458*z_183 - 8.0*z_458*z_184 - 4.0*z_458*z_144
        - 2.0*z_458*z_145 - 4.0*z_462*z_463 - 2.0*z_464*z_65 - 4.0*z_464*z_185 - 4.0*z_464*z_147 - 2.0*z_465*z_466
        - 2.0*z_467*z_149 - 2.0*z_467*z_151 - 2.0*z_468*z_469 - 2.0*z_472*z_152 - 4.0*z_472*z_188 -
        2.0*z_511*z_103 - 2.0*z_527*z_528 - 2.0*z_536*z_537 - 2.0*z_538*z_541 - 4.0*z_28*z_543 -
        4.0*cos_theta*z_464*z_542 - 2.0*z_458*z_104 - 2.0*z_579*z_494 - z_585*z_103 - 2.0*z_586*z_141 -
        sin_tilt*z_597 - 2.0*cos_tilt*z_599) + cos_tilt*(2.0*z_396*z_402 + z_588*z_103 + z_400*z_600 +
        2.0*z_17*z_428 + z_449*z_604 + z_456*z_454 + 2.0*z_456*z_453 + 4.0*z_458*z_606 + 4.0*z_459*z_56 +
        8.0*z_459*z_143 + 4.0*z_462*z_186 + 2.0*z_180*z_541 + 4.0*z_464*z_608 + 2.0*z_478*z_466 + 2.0*z_467*z_609
        + 2.0*z_468*z_187 + 2.0*z_468*z_150 + 2.0*z_472*z_610 + delta_dot*z_492 + 2.0*z_612*z_507 +
        2.0*z_590*z_103 + 2.0*z_612*z_515 + 2.0*z_592*z_103 + 2.0*z_536*z_614 + 2.0*z_542*z_541 + 4.0*z_40*z_539 +
        2.0*z_459*z_102 + z_449*delta_ddot + 2.0*z_599*z_32 + cos_tilt*z_597 - z_396*z_401 - z_396*z_421 -
        2.0*z_434*z_601 - 2.0*z_439*z_602 - 2.0*z_439*z_603 - z_456*z_451 - z_456*z_452 - 2.0*z_458*z_605 -
        4.0*z_458*z_607 - 2.0*z_459*z_181 - 4.0*z_459*z_183 - 2.0*z_459*z_142 - 4.0*z_459*z_184 - 8.0*z_459*z_140
        - 4.0*z_459*z_144 - 2.0*z_459*z_145 - 2.0*z_462*z_185 - 4.0*z_462*z_65 - 8.0*z_462*z_147 - z_396*z_450 -
        4.0*z_468*z_149 - 2.0*z_468*z_151 - 2.0*z_470*z_188 - 4.0*z_470*z_152 - 2.0*z_479*z_611 - z_481*z_493 -
        2.0*z_527*z_613 - 2.0*z_459*z_542*z_28 - 2.0*z_40*z_543 - 2.0*z_542*z_540 - 4.0*sin_theta*z_462*z_538 -
        2.0*z_459*z_104 - 2.0*z_573*z_547 - 2.0*z_579*z_612 - z_456*z_580 - z_593*z_103 - 2.0*z_596*z_141 -
        z_597*z_168 - 2.0*sin_tilt*z_598));
    const double z_615 = m_R*z_262;
    const double z_616 = m_B*z_282;
    const double z_617 = z_616 + z_364;
    const double z_618 = m_R*r_R;
    const double z_619 = m_B*z_281;
    const double z_620 = m_B*z_280;
    const double z_621 = m_B*z_274 - m_B*z_261;
    const double z_622 = (z_619 + psi_dot*z_620) + z_621;
    const double z_623 = cos_phi*phi_ddot;
    const double z_624 = psi_ddot*(sin_phi*sin_phi);
    const double z_625 = m_B*z_272 - m_B*z_264;
    const double z_626 = (m_B*z_283 + psi_dot*z_616) + z_625;
    const double z_627 = m_B*z_277;
    const double z_628 = m_B*z_270;
    const double z_629 = m_B*x_B;
    const double z_630 = z_627 + psi_dot*z_621 + z_93*z_628 + m_B*z_268 + m_B*z_353 - 2.0*z_616*psi_ddot -
        z_95*z_629 - z_99*z_628 - z_100*z_629 - m_B*z_352;
    const double z_631 = m_B*z_273;
    const double z_632 = z_631 + z_84*z_628 + z_97*z_629 - 2.0*psi_ddot*z_620 - psi_dot*z_625 - m_B*z_359 -
        m_B*z_360;
    const double z_633 = z_616*z_49 + z_616*z_41 + 2.0*z_616*z_34 + z_622*z_36 + z_63*z_626 + z_616*z_93 +
        z_84*z_620 - z_67*z_620 - z_622*z_50 - z_616*z_99 - sin_theta*z_630 - z_632*z_40;
    D[58] = -(z_257*z_204 + z_364*z_49 + z_364*z_41 + 2.0*z_364*z_34 + z_370*z_36 + z_63*z_373 + z_364*z_93 +
        z_366*z_84 + z_617*z_623 + sin_theta*z_376 + z_380*z_40 + z_633 - z_217*z_615 - z_366*z_67 - z_617*z_202 -
        m_R*z_258*z_255 - z_387*(z_618*z_217 - m_R*z_264) - z_370*z_50 - (z_370 + z_622 - m_R*z_261)*z_217 -
        z_364*z_99 - 2.0*z_618*z_624 - z_359*z_204 - z_360*z_204 - sin_phi*(-z_632 - z_379));
    const double z_634 = z_498*z_503;
    const double z_635 = z_634*z_556;
    const double z_636 = z_109*z_501;
    const double z_637 = z_634*z_559;
    const double z_638 = z_252*z_501;
    const double z_639 = z_499*z_503;
    const double z_640 = z_497*z_639;
    const double z_641 = z_497*z_501;
    const double z_642 = z_634*z_564;
    const double z_643 = z_254*z_501;
    const double z_644 = z_634*z_567;
    const double z_645 = z_114*z_501;
    const double z_646 = z_512*z_639;
    const double z_647 = z_512*z_501;
    D[59] = -(z_363*z_235 + z_365*z_240 + z_246*z_369 + z_245*z_367 + z_531*z_636 + z_534*z_637 + z_535*z_640 +
        z_535*z_641 + z_520*z_642 + z_525*z_646 + z_525*z_647 - z_244*z_371 - z_243*z_372 - z_531*z_635 -
        z_534*z_638 - z_520*z_643 - z_523*z_644 - z_523*z_645 - z_365*z_358 - z_363*z_350 - z_252*z_375 -
        z_254*z_378);
    const double z_648 = r_R*r_R;
    D[60] = -(z_258*z_257 + z_262*z_264 - z_263*z_262 - z_266*z_261 - z_648*z_624 - z_258*z_359 - z_258*z_360);
    const double z_649 = z_270*z_282;
    const double z_650 = x_B*z_282;
    const double z_651 = z_270*z_280;
    const double z_652 = x_B*z_280;
    D[61] = -(z_283*z_274 + z_282*z_277 + z_280*z_273 + z_281*z_264 + z_93*z_649 + z_84*z_651 + z_97*z_652 +
        z_282*z_268 + z_282*z_353 - z_281*z_272 - z_283*z_261 - z_95*z_650 - z_99*z_649 - z_100*z_650 -
        psi_ddot*(z_280*z_280) - psi_ddot*(z_282*z_282) - z_280*z_359 - z_282*z_352 - z_280*z_360);
    const double z_653 = z_136*z_298;
    const double z_654 = z_H*z_298;
    const double z_655 = z_H*z_302;
    const double z_656 = z_136*z_302;
    D[62] = -(z_304*z_290 + z_302*z_294 + z_298*z_288 + z_300*z_264 + z_298*z_356 + z_302*z_351 + z_302*z_353 -
        z_300*z_286 - z_304*z_261 - z_342*z_653 - z_358*z_654 - z_350*z_655 - z_346*z_656 - psi_ddot*(z_298*z_298)
        - psi_ddot*(z_302*z_302) - z_298*z_359 - z_302*z_352 - z_298*z_360);
    const double z_657 = c_*z_312;
    const double z_658 = r_F*z_312;
    const double z_659 = r_F*z_314;
    const double z_660 = c_*z_314;
    D[63] = -(z_315*z_308 + z_314*z_309 + z_312*z_307 + z_313*z_264 + z_312*z_356 + z_314*z_351 + z_314*z_353 -
        z_313*z_306 - z_315*z_261 - z_342*z_657 - z_358*z_658 - z_350*z_659 - z_346*z_660 - psi_ddot*(z_312*z_312)
        - psi_ddot*(z_314*z_314) - z_312*z_359 - z_314*z_352 - z_312*z_360);
    D[64] = -(z_616*z_44 + z_616*z_29 + z_66*z_620 + z_622*z_45 + z_622*z_23 + z_60*z_626 + z_97*z_620 +
        cos_theta*z_630 - 2.0*z_616*z_19 - z_616*z_95 - z_616*z_100 - z_632*z_28);
    D[65] = z_633;
    D[66] = -z_362;
    D[67] = -(z_332*z_235 + z_333*z_240 + z_246*z_336 + z_245*z_337 + z_252*z_354 + z_254*z_361 - z_244*z_335 -
        z_243*z_338 - z_333*z_358 - z_332*z_350);
    const double z_661 = z_573*z_17 + (z_407*z_17 - z_385*z_478);
    const double z_662 = z_546*z_22 - (z_412*z_22 - z_383*z_465);
    const double z_663 = -z_662;
    D[68] = z_661 + z_663;
    const double spin_r_ddot = a[6];
    const double spin_r_dot = v[6];
    const double z_664 = spin_r_dot + z_388;
    const double z_665 = sin_phi*z_255 + sin_phi*z_577;
    D[69] = sin_phi*spin_r_ddot + z_664*z_217 + z_665;
    const double z_666 = z_444*z_582 - (z_444*z_414 - z_394*z_486);
    const double z_667 = -z_666;
    const double z_668 = z_447*z_584 + (z_447*z_419 - z_390*z_491);
    D[70] = -(z_667 + z_668);
    const double z_669 = cos_delta*z_498;
    const double z_670 = z_436*z_425 + z_437*z_425 + z_498*z_573*z_219 + z_498*z_546*z_2 - z_438*z_425 -
        z_577*z_669;
    D[71] = z_498*spin_f_ddot + z_433*z_479 - z_670;
    D[72] = 0.5*(z_663 - z_662);
    D[73] = z_388*z_217 + z_665;
    D[74] = 0.5*(z_661 + z_661);
    D[75] = z_412*z_17 + z_407*z_22 + z_383*z_478 + z_385*z_465 + z_573*z_22 - z_546*z_17;
    D[76] = (-0.5)*(z_668 + z_668);
    D[77] = z_431*z_479 - z_670;
    D[78] = (-0.5)*(z_667 - z_666);
    D[79] = z_444*z_419 + z_447*z_414 + z_444*z_584 - z_390*z_486 - z_394*z_491 - z_447*z_582;
    const double z_671 = z_8*z_217;
    const double z_672 = z_27*z_22;
    const double z_673 = z_40*z_18;
    const double z_674 = z_15*z_673;
    const double z_675 = z_410*z_25;
    const double z_676 = z_674 - z_675;
    const double z_677 = z_27*z_17;
    const double z_678 = z_28*z_18;
    const double z_679 = z_33*z_678;
    const double z_680 = z_405*z_38;
    const double z_681 = z_679 - z_680;
    const double z_682 = z_43*z_17;
    const double z_683 = z_404*z_38;
    const double z_684 = z_43*z_22;
    const double z_685 = z_409*z_25;
    const double z_686 = z_14*z_22;
    const double z_687 = z_17*z_55;
    const double z_688 = (z_671 - z_344*z_4) + (z_15*z_672 + z_676) + (z_33*z_677 - z_681) + (z_671 - z_202*z_2) +
        (z_674 + z_15*z_684 + z_685) + (z_680 + z_683 - cos_tilt*z_687) - (z_679 - z_33*z_682 - z_683) - (z_675 -
        z_685 - z_53*z_686);
    const double z_689 = z_220*z_217;
    const double z_690 = z_409*z_38;
    const double z_691 = z_33*z_673;
    const double z_692 = z_690 - z_691;
    const double z_693 = z_222*z_678;
    const double z_694 = z_405*z_224;
    const double z_695 = z_693 + z_694;
    const double z_696 = z_410*z_38;
    const double z_697 = z_404*z_224;
    const double z_698 = z_13*z_17;
    const double z_699 = cos_tilt*z_22;
    const double z_700 = (z_689 - z_348*z_4) + (z_689 - z_202*z_219) + (z_693 + z_697 - z_222*z_682) + (z_694 +
        z_697 - z_53*z_698) + (z_690 + z_55*z_699 - z_696) - (z_33*z_684 - z_692) - (z_222*z_677 - z_695) - (z_691
        + z_33*z_672 + z_696);
    const double z_701 = r_R*z_678;
    const double z_702 = z_135*z_673;
    const double z_703 = z_267*z_27;
    const double z_704 = ((r_R*z_677 - z_701) + (z_702 + z_135*z_672)) - ((z_701 - r_R*z_682) + (z_703 -
        (z_135*z_684 + z_702)));
    const double z_705 = z_136*z_688 - z_H*z_700 - z_704;
    const double z_706 = m_H*z_705;
    const double z_707 = z_114*z_137 + z_254*z_157 + m_H*z_297;
    const double z_708 = z_267 - (r_R*z_17 + z_135*z_22);
    const double z_709 = z_157*z_444 + m_H*z_708 - z_137*z_447;
    const double z_710 = psi_dot*z_75;
    const double z_711 = z_300*z_334;
    const double g = c[3];
    const double z_712 = m_H*g;
    const double z_713 = psi_dot*z_157;
    const double z_714 = psi_dot*z_137;
    const double z_715 = z_444*z_713 + z_708*z_334 - z_447*z_714;
    const double z_716 = cos_theta*z_222;
    const double z_717 = z_108 + z_716;
    const double z_718 = z_H*z_717;
    const double z_719 = sin_theta*z_15;
    const double z_720 = z_251 + z_719;
    const double z_721 = z_136*z_720;
    const double z_722 = r_R*cos_theta + sin_theta*z_135;
    const double z_723 = r_R - z_722;
    const double z_724 = z_718 + z_721 + z_723;
    const double z_725 = m_H*z_724;
    const double z_726 = z_33*z_544;
    const double z_727 = delta_ddot*z_168 + z_726 + z_15*z_571;
    const double z_728 = sin_tilt*z_H - cos_tilt*z_136;
    const double z_729 = m_H*z_728;
    const double z_730 = sin_delta*sin_delta;
    const double z_731 = delta_ddot*z_730;
    const double z_732 = sin_theta*z_731;
    const double z_733 = cos_theta*z_731;
    const double z_734 = sin_delta*theta_ddot;
    const double z_735 = cos_theta*z_734;
    const double z_736 = phi_ddot*z_730;
    const double z_737 = z_14*z_732 + z_108*z_734 + cos_tilt*z_736 - z_31*z_733 - z_15*z_735;
    const double z_738 = sin_theta*z_734;
    const double z_739 = z_135*z_735 - r_R*z_738;
    const double z_740 = z_31*z_732 + z_251*z_734 + sin_tilt*z_736 - z_13*z_733 - z_222*z_738;
    const double z_741 = m_H*z_739 + z_137*z_737 - z_157*z_740;
    const double z_742 = z_33*z_571;
    const double z_743 = delta_ddot*z_32 - z_742 - z_222*z_544;
    const double z_744 = r_R*phi_ddot;
    const double z_745 = (z_135*z_571 + r_R*z_544) - z_744;
    const double z_746 = z_137*z_727 - z_157*z_743 - m_H*z_745;
    const double z_747 = z_33*z_572 + z_15*z_545 - z_344*psi_ddot;
    const double z_748 = z_103*z_352 - z_103*z_353;
    const double z_749 = z_446*z_352 + z_445*z_352 - z_446*z_353 - z_445*z_353 - cos_tilt*z_748;
    const double z_750 = z_348*psi_ddot + z_33*z_545 + z_222*z_572;
    const double z_751 = z_267*psi_ddot;
    const double z_752 = (z_135*z_545 + r_R*z_572) - z_751;
    const double z_753 = z_157*z_750 + z_137*z_747 - m_H*z_752;
    const double z_754 = psi_dot*z_715;
    const double z_755 = z_114*z_706 + z_688*z_707 + z_447*z_711 + z_725*z_727 + cos_tilt*z_741 + z_720*z_746 +
        z_109*z_753 - z_447*z_347 - z_57*z_709 - z_709*z_710 - z_114*z_712 - z_74*z_715 - z_729*z_737 -
        z_332*z_747 - m_H*z_749 - z_114*z_754;
    const double z_756 = z_347 + z_374;
    const double z_757 = c_*z_688 - r_F*z_700 - z_704;
    const double z_758 = m_F*z_757;
    const double z_759 = z_706 + z_758;
    const double z_760 = lambda_4*z_22;
    const double z_761 = z_114*z_134 + z_254*z_156 + m_F*z_297;
    const double z_762 = z_707 + z_761;
    const double z_763 = z_156*z_444 + m_F*z_708 - z_134*z_447;
    const double z_764 = z_709 + z_763;
    const double z_765 = m_F*g;
    const double z_766 = z_712 + z_765;
    const double z_767 = z_313*z_368;
    const double z_768 = z_711 + z_767;
    const double z_769 = psi_dot*z_134;
    const double z_770 = psi_dot*z_156;
    const double z_771 = z_447*z_769 - z_444*z_770 - z_708*z_368;
    const double z_772 = psi_dot*z_709 + psi_dot*z_763 + z_715 - z_771;
    const double z_773 = sin_tilt*r_F;
    const double z_774 = c_*cos_tilt;
    const double z_775 = z_773 - z_774;
    const double z_776 = m_F*z_775;
    const double z_777 = z_776 + z_729;
    const double z_778 = c_*z_720;
    const double z_779 = r_F*z_717;
    const double z_780 = z_778 + z_779 + z_723;
    const double z_781 = m_F*z_780;
    const double z_782 = z_781 + z_725;
    const double z_783 = z_134*z_727 - z_156*z_743 - m_F*z_745;
    const double lambda_0 = lambda[0];
    const double z_784 = z_783 - (sin_phi*lambda_0 - z_746);
    const double z_785 = -z_784;
    const double z_786 = z_22*z_352;
    const double z_787 = z_22*z_353;
    const double z_788 = z_786 - z_787;
    const double z_789 = z_156*z_750 + z_134*z_747 - m_F*z_752;
    const double z_790 = z_753 + z_789;
    const double z_791 = psi_dot*z_771;
    const double z_792 = z_754 - z_791;
    const double z_793 = z_755 - (z_756*z_22 + z_759*z_28 + z_762*z_672 + 2.0*z_673*z_762 + z_762*z_684 +
        2.0*z_19*z_764 + z_777*z_735 + z_782*z_571 + cos_theta*z_790 - z_760 - z_44*z_764 - z_29*z_764 -
        z_766*z_28 - z_768*z_22 - z_60*z_772 - sin_theta*z_785 - z_364*z_545 - z_121*z_788 - z_792*z_28);
    D[81] = z_793;
    const double z_794 = lambda_0*z_40;
    const double z_795 = lambda_0*z_28;
    const double z_796 = lambda_4*z_103 + m_F*z_739 + z_134*z_737 - lambda_0*z_141 - z_156*z_740;
    D[82] = -(z_447*z_374 + z_57*z_763 + z_114*z_765 + z_763*z_710 + z_33*z_794 + z_15*z_795 + z_776*z_737 +
        z_363*z_747 + m_F*z_749 + z_530 - z_114*z_758 - z_688*z_761 - z_447*z_767 - z_74*z_771 - z_781*z_727 -
        cos_tilt*z_796 - z_720*z_783 - z_109*z_789 - z_793 - z_114*z_791);
    const double z_797 = z_137*z_294 + z_134*z_309;
    const double z_798 = z_137*z_705 + z_134*z_757;
    const double z_799 = z_300*z_714 + z_313*z_769;
    const double z_800 = z_458*psi_ddot;
    const double z_801 = z_137*g + z_134*g;
    const double z_802 = z_H*z_707 + r_F*z_761;
    const double z_803 = z_22*z_55;
    const double z_804 = z_410*z_37;
    const double z_805 = z_409*z_37;
    const double z_806 = z_136*z_707 + c_*z_761;
    const double z_807 = z_22*z_180;
    const double z_808 = z_409*z_182;
    const double z_809 = z_404*z_37;
    const double z_810 = z_27*z_103;
    const double z_811 = z_405*z_37;
    const double z_812 = z_410*z_182;
    const double z_813 = z_4*z_103;
    const double z_814 = z_7*z_217;
    const double z_815 = cos_theta*z_7;
    const double z_816 = z_426*z_495 + z_426*z_496;
    const double z_817 = 2.0*z_252*H_xz - z_109*z_448;
    const double z_818 = 2.0*z_109*H_xz - z_252*z_455;
    const double z_819 = z_136*z_709 + c_*z_763;
    const double z_820 = z_H*z_709 + r_F*z_763;
    const double z_821 = psi_dot*z_141;
    const double z_822 = psi_dot*z_28;
    const double z_823 = z_60 + z_822;
    const double z_824 = psi_dot*z_H;
    const double z_825 = psi_dot*r_F;
    const double z_826 = (z_709*z_824 + z_763*z_825) + (z_H*z_715 - r_F*z_771);
    const double z_827 = psi_dot*z_136;
    const double z_828 = psi_dot*c_;
    const double z_829 = (z_709*z_827 + z_763*z_828) + (z_136*z_715 - c_*z_771);
    const double z_830 = cos_theta*z_8;
    const double z_831 = sin_theta*z_220;
    const double z_832 = psi_dot*z_40;
    const double z_833 = z_63 + z_832;
    const double z_834 = z_830 + z_831 + psi_dot*z_101 + z_833*z_219 - z_823*z_2;
    const double z_835 = psi_dot*cos_phi;
    const double z_836 = z_241 + z_242 + z_219*z_835 - z_222*z_833 - z_33*z_823;
    const double z_837 = z_72 + z_73 + z_2*z_835 + z_15*z_823 + z_33*z_833;
    const double z_838 = 2.0*H_xz*z_836 - z_448*z_837;
    const double z_839 = 2.0*H_xz*z_837 - z_455*z_836;
    const double z_840 = lambda_0*z_508;
    const double z_841 = z_134*z_780 + z_137*z_724;
    const double z_842 = cos_delta*delta_ddot;
    const double z_843 = z_134*z_775 + z_137*z_728;
    const double z_844 = sin_tilt*z_843;
    const double z_845 = z_497*z_544;
    const double z_846 = z_107*lambda_4 - z_108*lambda_4;
    const double z_847 = z_251*lambda_4 - z_250*lambda_4;
    const double z_848 = cos_theta*z_529 + sin_theta*z_532;
    const double z_849 = z_548 + z_846*z_524 + theta_ddot*z_578 - z_847*z_521 - z_848*z_526 - z_848*z_502 -
        z_544*z_575 - z_571*z_574;
    const double z_850 = cos_theta*psi_ddot;
    const double z_851 = z_504*z_219;
    const double z_852 = z_504*z_2;
    const double z_853 = z_101*lambda_0;
    const double z_854 = z_219*z_555;
    const double z_855 = z_2*z_555;
    const double z_856 = sin_theta*psi_ddot;
    const double z_857 = z_856*z_219;
    const double z_858 = z_850*z_2;
    const double z_859 = z_846*z_549 + z_795*z_852 + z_498*(z_846*z_557 + z_846*z_558 + z_848*z_505 + z_795*z_855
        - z_847*z_560 - z_847*z_561 - z_848*z_563 - z_794*z_854 - z_555*z_853) + z_426*z_857 + z_426*z_858 -
        z_847*z_550 - 2.0*z_848*z_509 - z_794*z_851 - z_504*z_853;
    const double z_860 = z_33*z_850;
    const double z_861 = z_222*z_856 - z_860;
    const double z_862 = z_33*z_856;
    const double z_863 = z_862 - z_15*z_850;
    const double z_864 = 2.0*z_846*z_509 + 2.0*H_xz*z_861 + z_448*z_863;
    const double z_865 = z_715*z_827 - z_771*z_828;
    const double z_866 = z_157*z_705 + z_156*z_757;
    const double z_867 = z_157*z_294 + z_156*z_309;
    const double z_868 = z_300*z_713 + z_313*z_770;
    const double z_869 = z_157*g + z_156*g;
    const double z_870 = lambda_4*z_17;
    const double z_871 = z_156*z_775 + z_157*z_728;
    const double z_872 = z_156*z_780 + z_157*z_724;
    const double z_873 = 2.0*z_847*z_509 + z_455*z_861 + 2.0*H_xz*z_863;
    const double z_874 = z_17*z_352;
    const double z_875 = z_17*z_353;
    const double z_876 = z_H*z_746 + r_F*z_783;
    const double z_877 = theta_ddot*z_2;
    const double z_878 = z_583 - z_877;
    const double z_879 = z_742 + z_878 - z_15*z_544;
    const double z_880 = theta_ddot*z_219;
    const double z_881 = z_581 + z_880;
    const double z_882 = z_222*z_571 + z_881 - z_726;
    const double z_883 = 2.0*z_846*z_502 + 2.0*z_136*z_753 + 2.0*c_*z_789 - z_448*z_879 - 2.0*H_xz*z_882;
    const double z_884 = z_136*z_746 + c_*z_783;
    const double z_885 = 2.0*z_847*z_502 + 2.0*z_H*z_753 + 2.0*r_F*z_789 - 2.0*H_xz*z_879 - z_455*z_882;
    const double z_886 = z_715*z_824 - z_771*z_825;
    const double z_887 = 2.0*z_798*z_40 + 2.0*z_866*z_28 + 2.0*z_867*z_22 + 2.0*z_797*z_17 + 2.0*z_802*z_672 +
        4.0*z_673*z_802 + 2.0*z_802*z_684 + 2.0*z_806*z_682 + 2.0*z_806*z_677 + z_817*z_407 + 4.0*z_19*z_820 +
        z_400*z_833 + 2.0*z_871*z_735 + 2.0*z_872*z_571 + 2.0*z_841*z_544 + z_818*z_544 + z_817*z_571 +
        z_449*z_856 + z_456*z_850 + z_873*z_22 + z_864*z_17 + 2.0*z_158*z_787 + 2.0*z_138*z_875 +
        sin_theta*(2.0*z_876 - z_883) + cos_theta*(2.0*z_884 + z_885) - 4.0*z_678*z_806 - cos_theta*z_588 -
        sin_theta*z_420 - z_818*z_412 - 2.0*z_49*z_819 - 2.0*z_41*z_819 - 4.0*z_34*z_819 - 2.0*z_44*z_820 -
        2.0*z_29*z_820 - 2.0*z_799*z_17 - 2.0*z_868*z_22 - 2.0*z_801*z_40 - 2.0*z_869*z_28 - z_396*z_823 -
        2.0*z_60*z_826 - 2.0*z_63*z_829 - z_385*z_838 - z_383*z_839 - 2.0*r_F*z_760 - 2.0*c_*z_870 -
        2.0*cos_theta*z_590 - 2.0*sin_theta*z_511 - 2.0*r_F*z_795 - 2.0*c_*z_794 - 2.0*z_843*z_738 -
        2.0*z_459*z_545 - 2.0*z_458*z_572 - 2.0*z_158*z_786 - 2.0*z_138*z_874 - 2.0*z_886*z_28 - 2.0*z_865*z_40;
    const double z_888 = 2.0*z_798*z_28 + 2.0*z_797*z_22 + 2.0*z_806*z_684 + 4.0*z_673*z_806 + 2.0*z_806*z_672 +
        cos_theta*z_420 + z_817*z_412 + 4.0*z_19*z_819 + z_400*z_823 + z_383*z_838 + 2.0*cos_theta*z_511 +
        2.0*z_843*z_735 + 2.0*z_841*z_571 + 2.0*sin_theta*z_884 + z_864*z_22 + 2.0*z_138*z_787 + cos_theta*z_883 -
        2.0*z_44*z_819 - 2.0*z_29*z_819 - 2.0*z_799*z_22 - 2.0*z_801*z_28 - 2.0*z_60*z_829 - 2.0*c_*z_760 -
        2.0*c_*z_795 - z_817*z_544 - 2.0*z_458*z_545 - z_449*z_850 - 2.0*z_138*z_786 - 2.0*z_865*z_28;
    const double z_889 = 2.0*z_866*z_40 + 2.0*z_867*z_17 + 2.0*z_802*z_682 + 2.0*z_802*z_677 + sin_theta*z_588 +
        z_385*z_839 + 2.0*sin_theta*z_590 + 2.0*z_872*z_544 + 2.0*cos_theta*z_876 + z_873*z_17 + 2.0*z_158*z_875 -
        4.0*z_678*z_802 - z_818*z_407 - 2.0*z_41*z_820 - 2.0*z_49*z_820 - 4.0*z_34*z_820 - 2.0*z_868*z_17 -
        2.0*z_869*z_40 - z_396*z_833 - 2.0*z_63*z_826 - 2.0*r_F*z_870 - 2.0*r_F*z_794 - 2.0*z_871*z_738 -
        z_818*z_571 - 2.0*z_459*z_572 - z_456*z_856 - 2.0*z_158*z_874 - sin_theta*z_885 - 2.0*z_886*z_40;
    const double z_890 = cos_tilt*z_843;
    const double z_891 = sin_tilt*z_871;
    const double z_892 = 2.0*z_890 - z_891;
    const double z_893 = z_459*psi_ddot;
    const double z_894 = z_17*z_180;
    const double z_895 = z_404*z_182;
    const double z_896 = z_405*z_182;
    const double z_897 = sin_theta*z_7;
    const double z_898 = cos_tilt*z_871;
    const double z_899 = z_497*z_571;
    const double z_900 = z_890 - 2.0*z_891;
    D[83] = 0.5*(sin_tilt*(2.0*z_797*z_103 + 2.0*z_801*z_141 + 2.0*z_802*z_803 + 4.0*z_802*z_805 + 2.0*z_806*z_687
        + 2.0*z_806*z_810 + 8.0*z_806*z_812 + 2.0*z_806*z_813 + 2.0*z_434*z_815 + 2.0*z_816*z_440 + z_817*z_451 +
        z_817*z_452 + 4.0*z_819*z_181 + 4.0*z_819*z_140 + 2.0*z_142*z_819 + 8.0*z_819*z_183 + 8.0*z_819*z_184 +
        4.0*z_144*z_819 + 2.0*z_145*z_819 + 2.0*z_829*z_152 + 4.0*z_829*z_188 + 2.0*z_528*z_840 + z_818*delta_ddot
        + z_817*z_734 + 2.0*z_849*z_537 + 2.0*z_843*z_736 + 2.0*z_850*z_547 + 2.0*z_859*z_494 + z_864*z_103 +
        2.0*z_865*z_141 + z_887*z_32 + 2.0*z_892*z_732 - 2.0*z_798*z_141 - 2.0*z_799*z_103 - 2.0*z_103*z_800 -
        4.0*z_802*z_804 - 4.0*z_806*z_807 - 8.0*z_806*z_808 - 4.0*z_806*z_809 - 4.0*z_806*z_811 - 4.0*z_814*z_806
        - z_396*z_471 - 2.0*z_400*z_188 - z_400*z_152 - 2.0*cos_theta*z_428 - 2.0*z_816*z_441 - z_817*z_453 -
        2.0*z_817*z_454 - z_818*z_457 - 2.0*z_819*z_56 - 4.0*z_819*z_143 - 2.0*z_820*z_234 - 4.0*z_820*z_460 -
        4.0*z_820*z_461 - z_400*z_821 - 2.0*z_823*z_466 - 2.0*z_826*z_471 - 2.0*z_834*z_480 - z_481*z_838 -
        delta_dot*z_839 - 2.0*z_537*z_507 - 2.0*z_841*z_842 - 2.0*z_733*z_844 - 2.0*z_427*z_845 - 2.0*z_136*z_741
        - 2.0*c_*z_796 - 2.0*z_138*z_748 - sin_tilt*z_887 - 2.0*z_888*z_168 - 2.0*cos_tilt*z_889) +
        cos_tilt*(2.0*z_867*z_103 + 2.0*z_869*z_141 + 4.0*z_802*z_687 + 4.0*z_802*z_812 + 2.0*z_802*z_810 +
        2.0*z_802*z_813 + 4.0*z_806*z_895 + 4.0*z_806*z_896 + 2.0*z_396*z_152 + z_396*z_188 + z_400*z_610 +
        2.0*sin_theta*z_428 + 2.0*z_816*z_602 + 2.0*z_816*z_603 + z_817*z_604 + z_818*z_454 + 2.0*z_818*z_453 +
        2.0*z_819*z_605 + 4.0*z_819*z_607 + 2.0*z_820*z_181 + 4.0*z_820*z_183 + 2.0*z_142*z_820 + 4.0*z_820*z_184
        + 8.0*z_820*z_140 + 4.0*z_144*z_820 + 2.0*z_145*z_820 + z_396*z_821 + 2.0*z_826*z_188 + 4.0*z_826*z_152 +
        2.0*z_834*z_611 + z_481*z_839 + 2.0*z_614*z_507 + 2.0*z_613*z_840 + 2.0*z_732*z_898 + z_817*delta_ddot +
        2.0*z_427*z_899 + 2.0*z_871*z_736 + 2.0*z_859*z_612 + z_873*z_103 + 2.0*z_886*z_141 + 2.0*z_889*z_32 +
        cos_tilt*z_887 + 2.0*sin_tilt*z_888 + 2.0*z_900*z_733 - 2.0*z_866*z_141 - 2.0*z_868*z_103 -
        2.0*z_103*z_893 - 2.0*z_802*z_807 - 8.0*z_802*z_809 - 8.0*z_802*z_811 - 4.0*z_802*z_808 - 4.0*z_814*z_802
        - 2.0*z_806*z_894 - 2.0*z_434*z_897 - z_818*z_451 - z_818*z_452 - 4.0*z_819*z_606 - 4.0*z_820*z_56 -
        8.0*z_820*z_143 - 2.0*z_833*z_466 - 2.0*z_829*z_610 - delta_dot*z_838 - 2.0*z_872*z_842 - z_818*z_734 -
        2.0*z_849*z_614 - 2.0*z_H*z_741 - 2.0*r_F*z_796 - 2.0*z_856*z_547 - 2.0*z_158*z_748 - z_887*z_168));
    const double z_901 = z_40*z_628 + z_28*z_629;
    D[84] = z_901 - sin_phi*(z_618 + m_B*r_R) - z_114*z_138 - z_254*z_158 - z_121*z_297;
    const double z_902 = x_B*z_673;
    const double z_903 = z_270*z_678;
    const double z_904 = z_703 + (z_903 - z_270*z_682) - (x_B*z_684 + z_902) - (z_902 + x_B*z_672) - (z_270*z_677
        - z_903);
    const double z_905 = m_B*z_904;
    const double z_906 = z_544*z_628 + z_571*z_629 - m_B*z_744;
    const double z_907 = m_R*z_267;
    const double z_908 = z_901 - m_B*z_258;
    const double z_909 = z_17*z_628 + z_22*z_629 - m_B*z_267;
    const double z_910 = psi_dot*m_B;
    const double z_911 = z_281*z_910;
    const double z_912 = x_B*sin_theta;
    const double z_913 = z_270*cos_theta;
    const double z_914 = r_R - z_912 - z_913;
    const double z_915 = m_B*z_914;
    const double z_916 = cos_phi*psi_ddot;
    const double z_917 = z_874 - z_875;
    const double z_918 = m_B*g;
    const double z_919 = z_382*z_629 + z_384*z_628 - z_267*z_910;
    const double z_920 = psi_dot*z_909 + z_919;
    const double z_921 = z_572*z_628 + z_545*z_629 - m_B*z_751;
    const double z_922 = z_905*z_40 + z_627*z_17 + 2.0*z_678*z_908 + z_49*z_909 + z_41*z_909 + 2.0*z_34*z_909 +
        z_63*z_920 + z_915*z_544 + sin_theta*z_921 + z_832*z_919 - z_908*z_682 - z_908*z_677 - z_384*z_619 -
        z_918*z_40 - cos_theta*z_906 - z_616*z_572 - m_B*z_917;
    D[85] = -(z_756*z_17 + z_759*z_40 + z_906 + cos_phi*lambda_4 + z_762*z_682 + z_762*z_677 + z_202*(z_907 +
        z_764 - z_909) + cos_phi*(z_911 + z_768) + z_835*z_615 + z_267*z_205 + z_782*z_544 + z_617*z_916 +
        z_352*z_208 + z_922 + sin_phi*(z_792 - psi_dot*z_919) + sin_phi*((z_918 + z_766) + m_R*g) -
        cos_phi*(m_R*z_260 + z_627 + z_756) - sin_phi*(z_759 + z_905) - z_870 - 2.0*z_907*z_202 - 2.0*z_678*z_762
        - z_48*(z_762 - z_908) - z_49*z_764 - z_41*z_764 - 2.0*z_34*z_764 - z_766*z_40 - z_768*z_17 - z_63*z_772 -
        z_777*z_738 - (z_618 + z_915 + z_782)*phi_ddot - cos_theta*z_785 - z_364*z_572 - z_121*z_917 - z_353*z_208
        - z_618*phi_ddot - sin_theta*z_790 - z_792*z_40 - z_784);
    const double z_923 = psi_dot*z_244;
    const double z_924 = z_219*z_634;
    const double z_925 = z_2*z_634;
    const double z_926 = z_443*z_352 + z_442*z_352 + sin_tilt*z_748 - z_443*z_353 - z_442*z_353;
    D[86] = -(z_700*z_761 + z_444*z_767 + z_254*z_765 + z_763*z_923 + z_846*z_635 + z_847*z_638 + z_795*z_925 +
        z_33*z_795 + z_222*z_794 + z_781*z_743 + sin_tilt*z_796 + z_363*z_750 + m_F*z_926 + z_252*z_789 + z_533 -
        z_634*z_853 - z_254*z_758 - z_444*z_374 - z_235*z_763 - z_243*z_771 - z_846*z_636 - z_847*z_637 -
        z_848*z_640 - z_848*z_641 - z_794*z_924 - z_776*z_740 - z_717*z_783 - z_254*z_791);
    const double z_927 = psi_dot*z_267;
    const double z_928 = z_267*z_352 - z_267*z_353;
    const double z_929 = z_258*g + z_928;
    D[87] = cos_phi*z_202*z_648 + z_267*z_260 + phi_ddot*z_648 - z_262*z_927 - z_929;
    const double z_930 = x_B*z_277;
    const double z_931 = z_270*z_277;
    const double z_932 = x_B*z_281;
    const double z_933 = z_270*z_281;
    D[88] = -(z_278*z_904 + z_279*z_904 + z_22*z_930 + z_17*z_931 + z_281*z_927 + z_270*z_914*z_544 +
        x_B*z_914*z_571 + z_282*z_751 + z_929 - z_258*z_904 - z_267*z_277 - z_382*z_932 - z_384*z_933 - z_278*g -
        z_279*g - z_914*z_744 - z_572*z_649 - z_545*z_650 - z_270*z_917 - x_B*z_788);
    const double z_934 = z_H*z_294;
    const double z_935 = z_136*z_294;
    const double z_936 = z_300*z_824;
    const double z_937 = z_300*z_827;
    const double z_938 = psi_dot*z_300;
    const double z_939 = z_H*z_728;
    const double z_940 = z_136*z_728;
    const double z_941 = z_928 + (g*z_297 - (r_R*z_917 + z_135*z_788));
    D[89] = z_296*z_705 + z_295*z_705 + z_705*z_297 + z_444*z_934 + z_294*z_708 + z_447*z_937 + z_136*z_724*z_727
        + z_740*z_939 + z_302*z_752 - z_447*z_935 - z_444*z_936 - z_296*g - z_295*g - z_708*z_938 - z_728*z_739 -
        z_H*z_724*z_743 - z_737*z_940 - z_724*z_745 - z_750*z_655 - z_747*z_656 - z_H*z_926 - z_136*z_749 - z_941;
    const double z_942 = r_F*z_309;
    const double z_943 = c_*z_309;
    const double z_944 = z_313*z_828;
    const double z_945 = z_313*z_825;
    const double z_946 = psi_dot*z_313;
    const double z_947 = r_F*z_775;
    const double z_948 = c_*z_775;
    D[90] = z_310*z_757 + z_311*z_757 + z_757*z_297 + z_444*z_942 + z_309*z_708 + z_447*z_944 + c_*z_780*z_727 +
        z_740*z_947 + z_314*z_752 - z_447*z_943 - z_444*z_945 - z_311*g - z_310*g - z_708*z_946 - z_775*z_739 -
        r_F*z_780*z_743 - z_737*z_948 - z_780*z_745 - z_750*z_659 - z_747*z_660 - r_F*z_926 - c_*z_749 - z_941;
    D[91] = -(z_905*z_28 + z_627*z_22 + z_44*z_909 + z_29*z_909 + z_60*z_920 + z_915*z_571 + z_822*z_919 -
        z_908*z_672 - 2.0*z_673*z_908 - z_908*z_684 - 2.0*z_19*z_909 - z_382*z_619 - z_918*z_28 - sin_theta*z_906
        - z_616*z_545 - m_B*z_788 - cos_theta*z_921);
    D[92] = z_922;
    D[93] = -z_755;
    D[94] = z_254*z_706 + z_444*z_347 + z_235*z_709 + z_729*z_740 + z_717*z_746 - z_700*z_707 - z_709*z_923 -
        z_444*z_711 - z_254*z_712 - z_243*z_715 - z_725*z_743 - sin_tilt*z_741 - z_332*z_750 - m_H*z_926 -
        z_252*z_753 - z_254*z_754;
    const double z_949 = sin_theta*sin_theta;
    const double z_950 = z_850*z_22;
    const double z_951 = (phi_ddot*z_949 + z_950) + (sin_theta*z_407 + z_385*z_833);
    const double z_952 = cos_theta*cos_theta;
    const double z_953 = (phi_ddot*z_952 - z_950) - (cos_theta*z_412 + z_383*z_823);
    const double z_954 = -z_953;
    D[95] = z_951 - z_954;
    D[96] = -z_664*z_835;
    const double z_955 = (z_252*z_882 + z_444*z_861) - (z_252*z_414 + z_394*z_836);
    const double z_956 = -z_955;
    const double z_957 = (z_109*z_879 + z_447*z_863) + (z_109*z_419 + z_390*z_837);
    D[97] = -(z_956 + z_957);
    const double z_958 = cos_delta*theta_ddot;
    const double z_959 = z_495*z_425 + z_496*z_425 + z_2*z_845 + z_219*z_899 - z_497*z_958 - z_498*z_857 -
        z_498*z_858;
    D[98] = -(z_497*spin_f_ddot + z_433*z_834 - z_959);
    D[99] = (-0.5)*(z_954 - z_953);
    D[100] = -z_388*z_835;
    D[101] = 0.5*(z_951 + z_951);
    D[102] = sin_theta*z_412 + z_385*z_823 + z_949*z_916 - cos_theta*z_407 - z_383*z_833 - 2.0*cos_theta*z_571 -
        z_952*z_916;
    D[103] = (-0.5)*(z_957 + z_957);
    D[104] = -(z_431*z_834 - z_959);
    D[105] = (-0.5)*(z_956 - z_955);
    D[106] = z_252*z_419 + z_109*z_414 + z_390*z_836 + z_394*z_837 + z_252*z_879 + z_444*z_863 - z_109*z_882 -
        z_447*z_861;
    const double z_960 = z_33*theta_ddot;
    const double z_961 = z_86*z_13 - z_960;
    const double z_962 = z_340 + z_15*theta_ddot;
    const double z_963 = z_135*theta_ddot;
    const double z_964 = z_157*z_961 + m_H*z_963 - z_137*z_962;
    const double z_965 = z_156*z_961 + m_F*z_963 - z_134*z_962;
    const double z_966 = z_443 - z_15*z_17;
    const double z_967 = z_253 - z_15*z_40;
    const double z_968 = z_446 - z_222*z_22;
    const double z_969 = r_R*z_22 - z_135*z_17;
    const double z_970 = z_137*z_966 - z_157*z_968 - m_H*z_969;
    const double z_971 = z_113 - z_222*z_28;
    const double z_972 = z_135*z_40 - r_R*z_28;
    const double z_973 = z_157*z_971 - z_137*z_967 - m_H*z_972;
    const double z_974 = z_157*z_717 + z_137*z_720 - m_H*z_722;
    const double z_975 = psi_dot*z_80;
    const double z_976 = z_304*z_334;
    const double z_977 = z_717*z_713 + z_720*z_714 - z_722*z_334;
    const double z_978 = z_971*z_713 - z_967*z_714 - z_972*z_334;
    const double z_979 = r_R - z_222*z_H - z_33*z_136;
    const double z_980 = m_H*z_979;
    const double z_981 = z_86*z_14 + z_960;
    const double z_982 = z_135 - z_33*z_H - z_15*z_136;
    const double z_983 = m_H*z_982;
    const double z_984 = z_340 - z_222*theta_ddot;
    const double z_985 = r_R*theta_ddot;
    const double z_986 = z_137*z_981 - z_157*z_984 - m_H*z_985;
    const double z_987 = sin_delta*z_571;
    const double z_988 = sin_delta*z_544;
    const double z_989 = z_33*z_987 - z_15*z_988;
    const double z_990 = z_135*z_988 - r_R*z_987;
    const double z_991 = z_222*z_987 - z_33*z_988;
    const double z_992 = m_H*z_990 + z_157*z_991 + z_137*z_989;
    const double z_993 = z_860 + z_15*z_856;
    const double z_994 = psi_ddot*z_40;
    const double z_995 = psi_ddot*z_28;
    const double z_996 = z_15*z_994 - z_33*z_995;
    const double z_997 = z_40*z_352;
    const double z_998 = z_28*z_352;
    const double z_999 = z_28*z_353;
    const double z_1000 = z_40*z_353;
    const double z_1001 = z_15*z_997 + z_33*z_999 - z_33*z_998 - z_251*z_359 - z_719*z_359 - z_15*z_1000 -
        z_251*z_360 - z_719*z_360;
    const double z_1002 = z_33*z_994 - z_222*z_995;
    const double z_1003 = r_R*z_995 - z_135*z_994;
    const double z_1004 = psi_dot*z_977 + z_157*z_1002 + z_137*z_996 + m_H*z_1003;
    const double z_1005 = z_135*z_856 + r_R*z_850;
    const double z_1006 = z_862 + z_222*z_850;
    const double z_1007 = psi_dot*z_978 + m_H*z_1005 - z_137*z_993 - z_157*z_1006;
    const double z_1008 = z_720*z_355 + z_967*z_347 + z_57*z_973 + z_973*z_710 + z_720*z_976 + z_712*z_966 +
        z_74*z_978 + z_980*z_981 + z_983*z_962 + z_15*z_964 + z_729*z_989 + z_332*z_996 + m_H*z_1001 +
        z_114*z_1007 - z_966*z_706 - z_688*z_970 - z_69*z_974 - z_974*z_975 - z_711*z_967 - z_83*z_977 -
        z_33*z_986 - cos_tilt*z_992 - z_333*z_993 - z_109*z_1004;
    const double z_1009 = z_355 + z_377;
    const double z_1010 = lambda_4*z_40;
    const double z_1011 = lambda_0*z_17;
    const double z_1012 = sin_theta*lambda_3;
    const double z_1013 = z_134*z_966 - z_156*z_968 - m_F*z_969;
    const double z_1014 = z_970 + z_1013;
    const double z_1015 = z_156*z_971 - z_134*z_967 - m_F*z_972;
    const double z_1016 = z_973 + z_1015;
    const double z_1017 = z_134*z_720 + z_156*z_717 - m_F*z_722;
    const double z_1018 = z_974 + z_1017;
    const double z_1019 = z_315*z_368;
    const double z_1020 = z_976 + z_1019;
    const double z_1021 = z_717*z_770 + z_720*z_769 - z_722*z_368;
    const double z_1022 = z_1021 + ((psi_dot*z_974 + psi_dot*z_1017) + z_977);
    const double z_1023 = z_967*z_769 + z_972*z_368 - z_971*z_770;
    const double z_1024 = psi_dot*z_973 + psi_dot*z_1015 + z_978 - z_1023;
    const double z_1025 = z_135 - c_*z_15 - z_33*r_F;
    const double z_1026 = m_F*z_1025;
    const double z_1027 = z_997 - sin_theta*z_359 - z_1000 - sin_theta*z_360;
    const double z_1028 = psi_dot*z_1021 + z_156*z_1002 + z_134*z_996 + m_F*z_1003;
    const double z_1029 = z_1004 + z_1028;
    const double z_1030 = psi_dot*z_1023 + z_134*z_993 + z_156*z_1006 - m_F*z_1005;
    const double z_1031 = z_1007 - z_1030;
    const double z_1032 = (z_964 + z_965) - (z_1008 + (z_756*z_40 + z_1011 + z_1012 + z_1014*z_672 +
        2.0*z_673*z_1014 + z_1014*z_684 + 2.0*z_19*z_1016 + z_66*z_1018 + z_766*z_17 + z_1022*z_45 + z_1022*z_23 +
        z_777*z_988 + z_366*z_856 + cos_theta*z_1029 - z_759*z_17 - sin_theta*z_1009 - z_1010 - z_44*z_1016 -
        z_29*z_1016 - z_768*z_40 - sin_theta*z_1020 - z_60*z_1024 - (z_1026 + z_983)*theta_ddot - z_364*z_994 -
        z_121*z_1027 - z_1031*z_28));
    D[108] = z_1032;
    const double z_1033 = lambda_4*z_28;
    const double z_1034 = lambda_0*z_22;
    const double z_1035 = r_R - c_*z_33 - r_F*z_222;
    const double z_1036 = m_F*z_1035;
    const double z_1037 = z_134*z_981 - z_156*z_984 - m_F*z_985;
    const double z_1038 = m_F*z_990 + z_156*z_991 + z_134*z_989;
    D[109] = z_966*z_758 + z_688*z_1013 + z_69*z_1017 + z_767*z_967 + z_1017*z_975 + z_83*z_1021 + z_74*z_1023 +
        z_33*z_1033 + z_15*z_1011 + z_251*lambda_3 + z_719*lambda_3 + z_33*z_1037 + cos_tilt*z_1038 + z_365*z_993
        + z_109*z_1028 + z_1032 + z_114*z_1030 - z_720*z_377 - z_967*z_374 - z_57*z_1015 - z_720*z_1019 -
        z_765*z_966 - z_1015*z_710 - z_15*z_1010 - z_33*z_1034 - z_1036*z_981 - z_1026*z_962 - z_15*z_965 -
        z_776*z_989 - z_363*z_996 - m_F*z_1001;
    const double z_1039 = z_H*z_970 + r_F*z_1013;
    const double z_1040 = z_136*z_970 + c_*z_1013;
    const double z_1041 = cos_delta*z_427;
    const double z_1042 = cos_delta*cos_delta;
    const double z_1043 = z_1042*(delta_dot*z_426);
    const double z_1044 = sin_tilt*H_xz;
    const double z_1045 = cos_tilt*H_xx + cos_tilt*z_399 - 2.0*z_1044;
    const double z_1046 = z_255*z_730;
    const double z_1047 = z_429*z_24;
    const double z_1048 = delta_dot*z_730;
    const double z_1049 = z_385*z_1048;
    const double z_1050 = z_136*z_973 + c_*z_1015;
    const double z_1051 = z_H*z_973 + r_F*z_1015;
    const double z_1052 = z_H*z_974 + r_F*z_1017;
    const double z_1053 = z_136*z_974 + c_*z_1017;
    const double z_1054 = (z_974*z_827 + z_1017*z_828) + (z_136*z_977 + c_*z_1021);
    const double z_1055 = (z_974*z_824 + z_1017*z_825) + (z_H*z_977 + r_F*z_1021);
    const double z_1056 = (z_973*z_824 + z_1015*z_825) + (z_H*z_978 - r_F*z_1023);
    const double z_1057 = (z_973*z_827 + z_1015*z_828) + (z_136*z_978 - c_*z_1023);
    const double z_1058 = z_24 + z_385*z_2 - z_383*z_219;
    const double z_1059 = z_386 + z_222*z_383 - z_220;
    const double z_1060 = z_392 + z_8 + z_15*z_385;
    const double z_1061 = 2.0*H_xz*z_1059 + z_448*z_1060;
    const double z_1062 = 2.0*H_xz*z_1060 + z_455*z_1059;
    const double z_1063 = cos_delta*lambda_3;
    const double z_1064 = z_521*z_519 + z_524*z_522 + z_526*z_1063 + z_502*z_1063;
    const double z_1065 = sin_delta*z_508;
    const double z_1066 = z_134*z_1025 + z_137*z_982;
    const double z_1067 = z_156*z_1035 + z_157*z_979;
    const double z_1068 = z_134*z_1035 + z_137*z_979;
    const double z_1069 = cos_tilt*H_xz;
    const double z_1070 = sin_tilt*H_zz + sin_tilt*z_395 - 2.0*z_1069;
    const double z_1071 = theta_ddot*z_730;
    const double z_1072 = z_542 + sin_tilt*z_1071;
    const double z_1073 = sin_delta*phi_ddot;
    const double z_1074 = cos_delta*lambda_4;
    const double z_1075 = cos_delta*phi_ddot;
    const double z_1076 = z_524*z_529 + z_521*z_532 + z_526*z_1074 + z_502*z_1074 + z_426*z_1075;
    const double z_1077 = z_529*z_549 + z_532*z_550 + 2.0*z_509*z_1074 + z_519*z_551 + z_522*z_552 +
        2.0*z_516*z_1063 + z_498*(z_529*z_557 + z_529*z_558 + z_532*z_560 + z_532*z_561 + z_1074*z_563 +
        z_519*z_565 + z_519*z_566 + z_522*z_568 + z_1063*z_570 - z_505*z_1074 - z_522*z_569 - z_513*z_1063 -
        z_1011*z_855 - z_1034*z_854) - z_1011*z_852 - z_1034*z_851 - psi_ddot*z_578;
    const double z_1078 = sin_delta*psi_ddot;
    const double z_1079 = 2.0*z_1044 - cos_tilt*z_448;
    const double z_1080 = 2.0*z_509*z_529 + 2.0*z_516*z_522 + z_1079*z_1078;
    const double z_1081 = z_502*z_522 + z_136*z_1007 - c_*z_1030;
    const double z_1082 = z_137*z_288 + z_134*z_307;
    const double z_1083 = z_157*z_288 + z_156*z_307;
    const double z_1084 = z_867*z_40;
    const double z_1085 = z_797*z_28;
    const double z_1086 = r_F*z_1011;
    const double z_1087 = c_*z_1034;
    const double z_1088 = cos_theta*lambda_3;
    const double z_1089 = z_156*z_1025 + z_157*z_982;
    const double z_1090 = z_459*z_994;
    const double z_1091 = z_458*z_995;
    const double z_1092 = 2.0*z_1069 - sin_tilt*z_455;
    const double z_1093 = 2.0*z_509*z_532 + 2.0*z_516*z_519 + z_1092*z_1078;
    const double z_1094 = sin_theta*y_ddot;
    const double z_1095 = cos_theta*y_ddot;
    const double z_1096 = sin_theta*x_ddot;
    const double z_1097 = cos_theta*x_ddot;
    const double z_1098 = 2.0*z_502*z_529 + 2.0*z_136*z_1004 + 2.0*c_*z_1028 - z_1079*z_1073;
    const double z_1099 = 2.0*z_502*z_532 - 2.0*z_H*z_1004 - 2.0*r_F*z_1028 - z_1092*z_1073;
    const double z_1100 = z_502*z_519 + r_F*z_1030 - z_H*z_1007;
    const double z_1101 = z_304*z_714 + z_315*z_769;
    const double z_1102 = (z_383*z_400 + 2.0*z_801*z_22) + 2.0*(cos_theta*z_1101 - z_799*z_28);
    const double z_1103 = z_304*z_713 + z_315*z_770;
    const double z_1104 = (z_385*z_396 + 2.0*z_869*z_17) - 2.0*(sin_theta*z_1103 + z_868*z_40);
    const double z_1105 = 2.0*cos_theta*z_1082 + 2.0*sin_theta*z_1083 + 2.0*z_866*z_17 + 2.0*z_1085 +
        4.0*z_678*z_1040 + z_1045*z_602 + 2.0*z_49*z_1050 + 2.0*z_41*z_1050 + 4.0*z_34*z_1050 + 2.0*z_44*z_1051 +
        2.0*z_29*z_1051 + 2.0*z_67*z_1053 + 2.0*z_1054*z_50 + 2.0*z_60*z_1056 + 2.0*z_63*z_1057 + z_385*z_1061 +
        2.0*r_F*z_1010 + 2.0*z_1087 + 2.0*z_1089*theta_ddot + 2.0*z_1068*theta_ddot + 2.0*z_H*z_964 +
        2.0*r_F*z_965 + 2.0*z_843*z_987 + 2.0*z_1090 + z_1093*z_22 + 2.0*z_158*z_997 + 2.0*z_138*z_999 +
        sin_theta*z_1098 + cos_theta*z_1099 + 2.0*z_1081*z_40 + z_1102 - 2.0*z_798*z_22 - 2.0*z_1084 -
        2.0*z_1039*z_672 - 4.0*z_673*z_1039 - 2.0*z_1039*z_684 - 2.0*z_1040*z_682 - 2.0*z_1040*z_677 -
        z_1070*z_440 - 4.0*z_19*z_1051 - 2.0*z_66*z_1052 - 2.0*z_1054*z_36 - 2.0*z_1055*z_45 - 2.0*z_1055*z_23 -
        z_383*z_1062 - 2.0*c_*z_1033 - 2.0*z_1086 - 2.0*r_F*z_1012 - 2.0*c_*z_1088 - 2.0*z_136*z_986 -
        2.0*c_*z_1037 - 2.0*z_871*z_988 - 2.0*z_1091 - 2.0*z_462*z_856 - 2.0*z_464*z_850 - z_1080*z_17 -
        2.0*z_138*z_998 - 2.0*z_159*z_1094 - 2.0*z_139*z_1095 - 2.0*z_158*z_1000 - 2.0*z_160*z_1096 -
        2.0*z_146*z_1097 - 2.0*z_1100*z_28 - z_1104;
    const double z_1106 = sin_theta*z_1082;
    const double z_1107 = z_798*z_17;
    const double z_1108 = z_797*z_40;
    const double z_1109 = z_458*z_994;
    const double z_1110 = z_464*z_856;
    const double z_1111 = (z_385*z_400 - 2.0*z_801*z_17) + 2.0*(sin_theta*z_1101 + z_799*z_40);
    const double z_1112 = 2.0*z_1106 + 2.0*z_1107 + z_1045*z_440 + 2.0*z_44*z_1050 + 2.0*z_29*z_1050 +
        2.0*z_60*z_1057 + 2.0*c_*z_1010 + 2.0*z_1066*theta_ddot + 2.0*z_136*z_964 + 2.0*c_*z_965 + 2.0*z_1109 +
        2.0*z_138*z_997 + 2.0*z_1081*z_28 + z_1111 - 2.0*z_1108 - 2.0*z_1040*z_684 - 4.0*z_673*z_1040 -
        2.0*z_1040*z_672 - 4.0*z_19*z_1050 - 2.0*z_66*z_1053 - 2.0*z_1054*z_45 - 2.0*z_1054*z_23 - z_383*z_1061 -
        2.0*c_*z_1011 - 2.0*c_*z_1012 - 2.0*z_843*z_988 - 2.0*z_1110 - z_1080*z_22 - 2.0*z_139*z_1094 -
        2.0*z_138*z_1000 - 2.0*z_146*z_1096 - cos_theta*z_1098;
    const double z_1113 = cos_theta*z_1083;
    const double z_1114 = z_866*z_22;
    const double z_1115 = z_867*z_28;
    const double z_1116 = z_459*z_995;
    const double z_1117 = z_462*z_850;
    const double z_1118 = (z_383*z_396 - 2.0*z_869*z_22) - 2.0*(cos_theta*z_1103 - z_868*z_28);
    const double z_1119 = 2.0*z_1114 + 2.0*z_1039*z_682 + 2.0*z_1039*z_677 + z_1070*z_602 + 2.0*z_1055*z_36 +
        2.0*r_F*z_1033 + 2.0*r_F*z_1088 + 2.0*z_H*z_986 + 2.0*r_F*z_1037 + 2.0*z_1116 + 2.0*z_1117 +
        2.0*z_158*z_998 + 2.0*z_159*z_1095 + 2.0*z_160*z_1097 + sin_theta*z_1099 + 2.0*z_1100*z_40 + z_1118 -
        2.0*z_1113 - 2.0*z_1115 - 4.0*z_678*z_1039 - 2.0*z_41*z_1051 - 2.0*z_49*z_1051 - 4.0*z_34*z_1051 -
        2.0*z_67*z_1052 - 2.0*z_1055*z_50 - 2.0*z_63*z_1056 - z_385*z_1062 - 2.0*r_F*z_1034 -
        2.0*z_1067*theta_ddot - 2.0*z_871*z_987 - z_1093*z_17 - 2.0*z_158*z_999;
    const double z_1120 = cos_tilt*z_1045;
    const double z_1121 = sin_tilt*z_1070;
    const double z_1122 = z_383*z_1048;
    const double z_1123 = z_538 - cos_tilt*z_1071;
    const double z_1124 = sin_theta*z_180;
    D[110] = 0.5*(sin_tilt*(z_400*z_7 + 2.0*z_1039*z_803 + 4.0*z_1039*z_805 + 2.0*z_1040*z_687 + 2.0*z_1040*z_810
        + 8.0*z_1040*z_812 + 2.0*z_1040*z_813 + 2.0*z_383*z_1043 + sin_tilt*z_1045*z_1049 + 4.0*z_1050*z_181 +
        4.0*z_1050*z_140 + 2.0*z_142*z_1050 + 8.0*z_1050*z_183 + 8.0*z_1050*z_184 + 4.0*z_144*z_1050 +
        2.0*z_145*z_1050 + 2.0*z_1052*z_238 + 8.0*z_1053*z_186 + 2.0*z_385*z_466 + 4.0*z_1054*z_187 +
        2.0*z_1054*z_150 + 2.0*z_1057*z_152 + 4.0*z_1057*z_188 + delta_dot*z_1062 + 2.0*sin_delta*z_518 +
        2.0*z_1066*z_538 + 4.0*z_1068*z_542 + 2.0*H_xz*z_1072 + z_817*z_1073 + 2.0*z_1076*z_537 + 2.0*z_1077*z_494
        + z_449*z_1078 + z_1080*z_103 + 2.0*z_1081*z_141 + sin_tilt*z_1105 + 2.0*z_1112*z_168 + (2.0*z_1120 +
        z_1121)*z_1122 + z_448*z_1123 - sin_delta*z_420 - 4.0*z_1039*z_804 - 4.0*z_1040*z_807 - 8.0*z_1040*z_808 -
        4.0*z_1040*z_809 - 4.0*z_1040*z_811 - 4.0*z_814*z_1040 - 2.0*z_412*z_1041 - z_1045*z_1046 - z_1045*z_1047
        - 2.0*z_1050*z_56 - 4.0*z_1050*z_143 - 2.0*z_1051*z_234 - 4.0*z_1051*z_460 - 4.0*z_1051*z_461 -
        4.0*z_1052*z_463 - 2.0*z_1053*z_65 - 4.0*z_1053*z_185 - 4.0*z_1053*z_147 - 2.0*z_1054*z_149 -
        2.0*z_1054*z_151 - 2.0*z_1055*z_469 - 2.0*z_1056*z_471 - 2.0*z_1058*z_480 - z_481*z_1061 -
        2.0*sin_delta*z_511 - 2.0*z_1064*z_528 - 2.0*z_1011*z_1065 - 2.0*z_1067*z_538 - z_1070*z_86 -
        z_1045*z_1071 - 2.0*z_136*z_992 - 2.0*c_*z_1038 - z_1105*z_32 - 2.0*cos_tilt*z_1119) - cos_tilt*(z_396*z_7
        + 2.0*z_1039*z_807 + 8.0*z_1039*z_809 + 8.0*z_1039*z_811 + 4.0*z_1039*z_808 + 4.0*z_814*z_1039 +
        2.0*z_1040*z_894 + 2.0*z_407*z_1041 + 2.0*z_385*z_1043 + cos_tilt*z_1070*z_1122 + 4.0*z_1050*z_606 +
        4.0*z_1051*z_56 + 8.0*z_1051*z_143 + 2.0*z_1052*z_185 + 4.0*z_1052*z_65 + 8.0*z_1052*z_147 +
        4.0*z_1055*z_149 + 2.0*z_1055*z_151 + 2.0*z_1057*z_610 + delta_dot*z_1061 + z_481*z_1062 +
        2.0*z_1064*z_613 + 2.0*z_1066*z_542 + z_1045*z_86 + z_818*z_1073 + 2.0*z_1076*z_614 + 2.0*z_H*z_992 +
        2.0*r_F*z_1038 + z_456*z_1078 + z_1093*z_103 + 2.0*z_1100*z_141 + cos_tilt*z_1105 + 2.0*sin_tilt*z_1112 +
        (z_1120 + 2.0*z_1121)*z_1049 - sin_delta*z_588 - 4.0*z_1039*z_687 - 4.0*z_1039*z_812 - 2.0*z_1039*z_810 -
        2.0*z_1039*z_813 - 4.0*z_1040*z_895 - 4.0*z_1040*z_896 - z_1070*z_1046 - z_1070*z_1047 - 2.0*z_1050*z_605
        - 4.0*z_1050*z_607 - 2.0*z_1051*z_181 - 4.0*z_1051*z_183 - 2.0*z_142*z_1051 - 4.0*z_1051*z_184 -
        8.0*z_1051*z_140 - 4.0*z_144*z_1051 - 2.0*z_145*z_1051 - 4.0*z_1052*z_186 - 2.0*z_1053*z_1124 -
        4.0*z_1053*z_608 - 2.0*z_383*z_466 - 2.0*z_1054*z_609 - 2.0*z_1055*z_187 - 2.0*z_1055*z_150 -
        2.0*z_1056*z_188 - 4.0*z_1056*z_152 - 2.0*z_1058*z_611 - 2.0*sin_delta*z_590 - 2.0*sin_delta*z_592 -
        2.0*z_1034*z_1065 - 2.0*z_1067*z_542 - 4.0*z_1089*z_538 - z_1070*z_1071 - 2.0*H_xz*z_1123 -
        2.0*z_1077*z_612 - 2.0*z_1119*z_32 - z_1105*z_168 - z_455*z_1072));
    const double z_1125 = z_22*z_628 - z_17*z_629;
    D[111] = z_1125 + z_158*z_968 + z_121*z_969 - z_138*z_966;
    const double lambda_1 = lambda[1];
    const double z_1126 = z_28*z_628 - z_40*z_629;
    const double z_1127 = cos_theta*z_628;
    const double z_1128 = sin_theta*z_629;
    const double z_1129 = z_1127 + z_1128;
    const double z_1130 = psi_dot*z_1128 + psi_dot*z_1127;
    const double z_1131 = psi_dot*z_1129 + z_1130;
    const double z_1132 = z_998 + cos_theta*z_359 + cos_theta*z_360 - z_999;
    const double z_1133 = z_283*z_910;
    const double z_1134 = z_832*z_629 - z_822*z_628;
    const double z_1135 = psi_dot*z_1126 - z_1134;
    const double z_1136 = psi_dot*z_1130 + z_994*z_629 - z_995*z_628;
    const double z_1137 = psi_dot*z_1134 - z_850*z_628 - z_856*z_629;
    const double z_1138 = cos_theta*z_631 + z_627*z_28 + z_1125*z_682 + z_1125*z_677 + z_49*z_1126 + z_41*z_1126 +
        2.0*z_34*z_1126 + z_918*z_22 + cos_theta*z_1133 + z_1131*z_36 + z_63*z_1135 + 2.0*theta_ddot*z_628 -
        z_905*z_22 - 2.0*z_678*z_1125 - z_67*z_1129 - z_911*z_28 - z_1131*z_50 - z_616*z_995 - z_850*z_620 -
        m_B*z_1132 - sin_theta*z_1136 - z_1137*z_40;
    D[112] = z_756*z_28 + cos_theta*z_1009 + z_1034 + 2.0*z_678*z_1014 + z_48*(z_1014 - z_1125) + z_49*z_1016 +
        z_41*z_1016 + 2.0*z_34*z_1016 + z_67*z_1018 + z_766*z_22 + cos_theta*z_1020 + z_1022*z_50 + z_63*z_1024 +
        (z_1022 - z_1131)*z_217 + (z_1036 + z_980)*theta_ddot + z_777*z_987 + sin_theta*z_1029 + z_1031*z_40 +
        z_1138 - z_759*z_22 - lambda_1 - z_986 - z_1037 - z_1033 - z_1088 - z_1014*z_682 - z_1014*z_677 -
        z_202*(z_1016 + z_1126) - z_768*z_28 - z_1022*z_36 - z_364*z_995 - z_366*z_850 - z_121*z_1132 -
        sin_phi*(z_1031 - z_1137);
    const double z_1139 = psi_dot*z_246;
    const double z_1140 = z_33*z_997 + z_222*z_999 - z_222*z_998 - z_108*z_359 - z_716*z_359 - z_33*z_1000 -
        z_108*z_360 - z_716*z_360;
    D[113] = -(z_717*z_377 + z_968*z_758 + z_700*z_1013 + z_240*z_1017 + z_767*z_971 + z_717*z_1019 + z_1015*z_923
        + z_1017*z_1139 + z_245*z_1021 + z_33*z_1010 + z_529*z_635 + z_532*z_637 + z_1074*z_640 + z_1074*z_641 +
        z_519*z_642 + z_522*z_644 + z_522*z_645 + z_1063*z_646 + z_1063*z_647 + z_222*z_1034 + z_33*z_965 +
        z_776*z_991 + sin_tilt*z_1038 + z_363*z_1002 + m_F*z_1140 + z_252*z_1028 - z_971*z_374 - z_235*z_1015 -
        z_765*z_968 - z_243*z_1023 - z_222*z_1033 - z_529*z_636 - z_532*z_638 - z_519*z_643 - z_1011*z_925 -
        z_33*z_1011 - z_1034*z_924 - z_108*lambda_3 - z_716*lambda_3 - z_1026*z_961 - z_1036*z_984 - z_222*z_1037
        - z_365*z_1006 - z_254*z_1030);
    const double z_1141 = x_B*z_17;
    const double z_1142 = z_270*z_22;
    const double z_1143 = psi_dot*z_283;
    D[115] = z_912*z_273 + z_913*z_273 + z_904*z_1141 + z_28*z_931 + z_832*z_932 + g*z_1142 + z_912*z_1143 +
        z_913*z_1143 + z_994*z_650 + x_B*z_1027 + theta_ddot*(x_B*x_B + z_270*z_270) - z_904*z_1142 - z_40*z_930 -
        z_822*z_933 - g*z_1141 - z_995*z_649 - z_850*z_651 - z_856*z_652 - z_270*z_1132;
    const double z_1144 = z_136*z_705;
    const double z_1145 = z_H*z_705;
    const double z_1146 = z_304*z_824;
    const double z_1147 = z_304*z_827;
    const double z_1148 = z_136*g;
    const double z_1149 = z_H*g;
    const double z_1150 = psi_dot*z_722;
    const double z_1151 = g*z_969 - (r_R*z_1132 - z_135*z_1027);
    D[116] = -(z_718*z_288 + z_721*z_288 + z_968*z_1145 + z_705*z_969 + z_967*z_935 + z_294*z_972 + z_971*z_936 +
        z_717*z_1146 + z_720*z_1147 + z_966*z_1148 + z_136*z_979*z_981 + z_136*z_982*z_962 + z_728*z_990 +
        z_991*z_939 + z_989*z_940 + z_298*z_1005 + z_1002*z_655 + z_996*z_656 + z_302*z_1003 + z_H*z_1140 +
        z_136*z_1001 - z_966*z_1144 - z_971*z_934 - z_288*z_722 - z_967*z_937 - z_968*z_1149 - z_972*z_938 -
        z_304*z_1150 - z_H*z_982*z_961 - z_H*z_979*z_984 - z_982*z_963 - z_979*z_985 - z_993*z_653 - z_1006*z_654
        - z_1151);
    const double z_1152 = c_*z_757;
    const double z_1153 = r_F*z_757;
    const double z_1154 = z_315*z_825;
    const double z_1155 = z_315*z_828;
    const double z_1156 = r_F*g;
    const double z_1157 = c_*g;
    D[117] = -(z_778*z_307 + z_779*z_307 + z_968*z_1153 + z_757*z_969 + z_967*z_943 + z_309*z_972 + z_971*z_945 +
        z_717*z_1154 + z_720*z_1155 + z_966*z_1157 + c_*z_1035*z_981 + c_*z_1025*z_962 + z_775*z_990 + z_991*z_947
        + z_989*z_948 + z_312*z_1005 + z_1002*z_659 + z_996*z_660 + z_314*z_1003 + r_F*z_1140 + c_*z_1001 -
        z_966*z_1152 - z_971*z_942 - z_307*z_722 - z_967*z_944 - z_968*z_1156 - z_972*z_946 - z_315*z_1150 -
        r_F*z_1025*z_961 - r_F*z_1035*z_984 - z_1025*z_963 - z_1035*z_985 - z_993*z_657 - z_1006*z_658 - z_1151);
    D[118] = sin_theta*z_631 + z_905*z_17 + z_1125*z_672 + 2.0*z_673*z_1125 + z_1125*z_684 + z_44*z_1126 +
        z_29*z_1126 + z_66*z_1129 + z_911*z_40 + sin_theta*z_1133 + z_1131*z_45 + z_1131*z_23 + z_60*z_1135 +
        2.0*theta_ddot*z_629 + z_616*z_994 + m_B*z_1027 + cos_theta*z_1136 - z_627*z_40 - 2.0*z_19*z_1126 -
        z_918*z_17 - z_856*z_620 - z_1137*z_28;
    D[119] = -z_1138;
    D[120] = z_1008;
    D[121] = -(z_717*z_355 + z_968*z_706 + z_700*z_970 + z_240*z_974 + z_973*z_923 + z_974*z_1139 + z_711*z_971 +
        z_717*z_976 + z_245*z_977 + z_243*z_978 + z_33*z_964 + z_729*z_991 + sin_tilt*z_992 + z_332*z_1002 +
        m_H*z_1140 + z_252*z_1004 + z_254*z_1007 - z_971*z_347 - z_235*z_973 - z_712*z_968 - z_983*z_961 -
        z_980*z_984 - z_222*z_986 - z_333*z_1006);
    const double z_1158 = z_255 + z_576;
    const double z_1159 = theta_ddot + z_1158;
    D[123] = spin_r_ddot + z_1159;
    const double z_1160 = z_252*phi_ddot;
    const double z_1161 = z_444*psi_ddot;
    const double z_1162 = (z_414*z_219 + z_394*z_1059) - (sin_tilt*z_1072 + (z_219*z_1160 + z_219*z_1161));
    const double z_1163 = z_109*phi_ddot;
    const double z_1164 = z_447*psi_ddot;
    const double z_1165 = (z_419*z_2 - z_390*z_1060) + (cos_tilt*z_1123 - (z_2*z_1163 + z_2*z_1164));
    D[124] = -(z_1162 + z_1165);
    const double z_1166 = cos_delta*z_425 + z_497*z_1075 - theta_ddot*z_1042 - psi_ddot*z_669;
    D[125] = cos_delta*spin_f_ddot - z_433*z_1058 - z_1166;
    const double z_1167 = z_385*z_383;
    D[126] = z_1167;
    D[127] = z_1159;
    D[128] = -z_1167;
    D[129] = z_383*z_383 - z_385*z_385;
    D[130] = (-0.5)*(z_1165 + z_1165);
    D[131] = -(z_431*z_1058 + z_1166);
    D[132] = (-0.5)*(z_1162 + z_1162);
    D[133] = z_419*z_219 + z_414*z_2 + z_390*z_1059 + sin_tilt*z_1123 - z_394*z_1060 - cos_tilt*z_1072 -
        z_2*z_1160 - z_219*z_1163 - z_219*z_1164 - z_2*z_1161;
    const double z_1168 = z_157*z_13 - z_31*z_137;
    const double z_1169 = z_156*z_13 - z_31*z_134;
    const double z_1170 = sin_theta*z_339 + z_14*z_537;
    const double z_1171 = sin_phi*z_168 + z_14*z_494 - z_17*z_339;
    const double z_1172 = z_40*z_339 + cos_phi*z_168 - z_14*z_528;
    const double z_1173 = z_13*z_612 - z_22*z_339 - sin_phi*z_32;
    const double z_1174 = z_137*z_1171 + z_157*z_1173;
    const double z_1175 = z_28*z_339 - z_13*z_613 - cos_phi*z_32;
    const double z_1176 = z_157*z_1175 + z_137*z_1172;
    const double z_1177 = cos_theta*z_339 + z_13*z_614;
    const double z_1178 = z_157*z_1177 - z_137*z_1170;
    const double z_1179 = z_1177*z_713 - z_1170*z_714;
    const double z_1180 = z_1175*z_713 + z_1172*z_714;
    const double z_1181 = z_14*z_734;
    const double z_1182 = theta_ddot*z_339;
    const double z_1183 = z_15*z_734;
    const double z_1184 = z_137*z_14 - z_31*z_157;
    const double z_1185 = z_33*z_734;
    const double z_1186 = z_725*phi_ddot;
    const double z_1187 = z_571*z_730;
    const double z_1188 = z_544*z_730;
    const double z_1189 = z_581 + z_14*z_1187 - z_31*z_1188;
    const double z_1190 = z_583 + z_31*z_1187 - z_13*z_1188;
    const double z_1191 = z_157*z_1190 - z_137*z_1189;
    const double z_1192 = cos_tilt*z_137 - sin_tilt*z_157;
    const double z_1193 = z_720*z_1075;
    const double z_1194 = sin_delta*z_14;
    const double z_1195 = z_856*z_339 + z_850*z_1194;
    const double z_1196 = z_994*z_339 + z_168*z_916 - z_995*z_1194;
    const double z_1197 = z_352*z_613 - z_359*z_614 - z_353*z_613 - z_360*z_614;
    const double z_1198 = z_352*z_528 + z_359*z_537 + z_360*z_537 - z_353*z_528;
    const double z_1199 = z_101*z_352 - z_101*z_353;
    const double z_1200 = z_31*z_1197 + cos_tilt*z_1199 - z_1198*z_14;
    const double z_1201 = sin_delta*z_13;
    const double z_1202 = z_995*z_339 - z_994*z_1201 - z_32*z_916;
    const double z_1203 = psi_dot*z_1179 - z_157*z_1202 - z_137*z_1196;
    const double z_1204 = z_850*z_339 + z_856*z_1201;
    const double z_1205 = psi_dot*z_1180 + z_157*z_1204 - z_137*z_1195;
    const double z_1206 = z_1170*z_355 + z_57*z_1176 + z_69*z_1178 + z_1176*z_710 + z_1178*z_975 + z_711*z_1172 +
        z_976*z_1170 + z_712*z_1171 + z_83*z_1179 + z_74*z_1180 + z_980*z_1181 + z_983*z_1182 + z_1168*z_1183 +
        z_729*z_1189 + cos_tilt*z_1191 + z_332*z_1196 + m_H*z_1200 + z_109*z_1203 + z_114*z_1205 - z_1171*z_706 -
        z_1172*z_347 - z_688*z_1174 - z_1184*z_1185 - z_168*z_1186 - z_1192*z_1193 - z_333*z_1195;
    const double z_1207 = z_134*z_1171 + z_156*z_1173;
    const double z_1208 = z_1174 + z_1207;
    const double z_1209 = z_156*z_1175 + z_134*z_1172;
    const double z_1210 = z_1176 + z_1209;
    const double z_1211 = z_134*z_1170 - z_156*z_1177;
    const double z_1212 = z_1178 - z_1211;
    const double z_1213 = z_1177*z_770 - z_1170*z_769;
    const double z_1214 = z_1213 + ((psi_dot*z_1178 - psi_dot*z_1211) + z_1179);
    const double z_1215 = z_1172*z_769 + z_1175*z_770;
    const double z_1216 = psi_dot*z_1176 + psi_dot*z_1209 + z_1180 + z_1215;
    const double z_1217 = cos_tilt*z_134 - sin_tilt*z_156;
    const double z_1218 = z_1192 + z_1217;
    const double z_1219 = cos_delta*z_571;
    const double z_1220 = psi_dot*z_1213 - z_156*z_1202 - z_134*z_1196;
    const double z_1221 = z_1203 + z_1220;
    const double z_1222 = psi_dot*z_1215 + z_156*z_1204 - z_134*z_1195;
    const double z_1223 = z_1205 + z_1222;
    const double z_1224 = (z_1168 + z_1169)*z_734 - (z_1206 + (z_1208*z_672 + 2.0*z_673*z_1208 + z_1208*z_684 +
        2.0*z_19*z_1210 + z_1218*z_1219 - z_44*z_1210 - z_29*z_1210 - z_66*z_1212 - z_1214*z_45 - z_1214*z_23 -
        z_60*z_1216 - cos_theta*z_1221 - z_1223*z_28));
    D[135] = -(-z_1224);
    const double z_1225 = lambda_4*z_613 - lambda_3*z_614;
    const double z_1226 = lambda_4*z_528 + lambda_3*z_537;
    const double z_1227 = z_134*z_14 - z_31*z_156;
    const double z_1228 = z_781*phi_ddot;
    const double z_1229 = z_101*lambda_4 + z_436*lambda_0 + z_156*z_1190 - z_134*z_1189;
    D[136] = -(z_1170*z_377 + z_57*z_1209 + z_767*z_1172 + z_1019*z_1170 + z_765*z_1171 + z_1209*z_710 +
        z_83*z_1213 + z_74*z_1215 + z_31*z_1225 + z_1034*z_1194 + z_1036*z_1181 + z_1026*z_1182 + z_1169*z_1183 +
        z_776*z_1189 + cos_tilt*z_1229 + z_363*z_1196 + m_F*z_1200 + z_109*z_1220 + z_114*z_1222 - z_1171*z_758 -
        z_1172*z_374 - z_688*z_1207 - z_69*z_1211 - z_1211*z_975 - z_1226*z_14 - z_1011*z_339 - z_1227*z_1185 -
        z_168*z_1228 - z_1217*z_1193 - z_365*z_1195 - z_1224);
    const double z_1230 = z_137*z_300 + z_134*z_313;
    const double z_1231 = z_60*z_1230;
    const double z_1232 = z_63*z_1230;
    const double z_1233 = z_157*z_300 + z_156*z_313;
    const double z_1234 = z_60*z_1233;
    const double z_1235 = z_410*z_2;
    const double z_1236 = z_15*z_410 - z_15*z_409;
    const double z_1237 = z_33*z_405 + z_33*z_404;
    const double z_1238 = z_1236 + z_1237 + z_490;
    const double z_1239 = z_33*z_409 - z_33*z_410;
    const double z_1240 = z_222*z_405 + z_222*z_404;
    const double z_1241 = z_1239 + z_485 - z_1240;
    const double z_1242 = (r_R*z_405 + z_135*z_410) + (r_R*z_404 - (r_R*z_10 + z_135*z_409));
    const double z_1243 = z_136*z_1238 - z_H*z_1241 - z_1242;
    const double z_1244 = c_*z_1238 - r_F*z_1241 - z_1242;
    const double z_1245 = z_137*z_1243 + z_134*z_1244;
    const double z_1246 = z_409*z_2;
    const double z_1247 = z_405*z_219;
    const double z_1248 = z_404*z_219;
    const double z_1249 = z_157*z_1243 + z_156*z_1244;
    const double z_1250 = z_410*z_1249;
    const double z_1251 = z_409*z_1249;
    const double z_1252 = z_157*z_304 + z_156*z_315;
    const double z_1253 = z_1252*z_219;
    const double z_1254 = z_137*z_304 + z_134*z_315;
    const double z_1255 = z_1254*z_2;
    const double z_1256 = z_1254*z_219;
    const double z_1257 = z_H*z_1174 + r_F*z_1207;
    const double z_1258 = z_136*z_1174 + c_*z_1207;
    const double z_1259 = sin_tilt*H_xx + sin_tilt*z_399;
    const double z_1260 = 2.0*z_1069 + z_1259;
    const double z_1261 = z_136*z_1176 + c_*z_1209;
    const double z_1262 = z_H*z_1176 + r_F*z_1209;
    const double z_1263 = z_H*z_1178 - r_F*z_1211;
    const double z_1264 = z_136*z_1178 - c_*z_1211;
    const double z_1265 = z_404*z_1245;
    const double z_1266 = z_405*z_1245;
    const double z_1267 = 2.0*z_1254*z_50 + 2.0*z_1250 + 2.0*z_1265 + 2.0*z_1266 + 2.0*z_1234 + 2.0*z_1232 +
        z_1111 + z_1118 - 2.0*z_1254*z_36 - 2.0*z_1252*z_45 - 2.0*z_1252*z_23 - 2.0*z_1251;
    const double z_1268 = cos_delta*z_434;
    const double z_1269 = (z_1178*z_827 - z_1211*z_828) + (z_136*z_1179 + c_*z_1213);
    const double z_1270 = (z_1178*z_824 - z_1211*z_825) + (z_H*z_1179 + r_F*z_1213);
    const double z_1271 = (z_1176*z_824 + z_1209*z_825) + (z_H*z_1180 + r_F*z_1215);
    const double z_1272 = (z_1176*z_827 + z_1209*z_828) + (z_136*z_1180 + c_*z_1215);
    const double z_1273 = z_481 + z_385*z_32 + z_383*z_168;
    const double z_1274 = z_388*z_32 - z_383*z_339 - z_385*z_1201;
    const double z_1275 = z_388*z_168 - z_385*z_339 - z_383*z_1194;
    const double z_1276 = 2.0*H_xz*z_1274 - z_448*z_1275;
    const double z_1277 = 2.0*H_xz*z_1275 - z_455*z_1274;
    const double z_1278 = c_*sin_tilt;
    const double z_1279 = cos_tilt*lambda_3;
    const double z_1280 = sin_tilt*lambda_3;
    const double z_1281 = z_521*z_1279 - z_524*z_1280;
    const double z_1282 = c_*z_17 + r_F*z_22;
    const double z_1283 = z_1282*lambda_0;
    const double z_1284 = cos_delta*z_508;
    const double z_1285 = sin_tilt*lambda_4;
    const double z_1286 = cos_tilt*lambda_4;
    const double z_1287 = z_524*z_1285 - z_521*z_1286;
    const double z_1288 = lambda_0*z_103;
    const double z_1289 = z_1034*z_168;
    const double z_1290 = z_1011*z_32;
    const double z_1291 = z_1285*z_549 + z_1280*z_552 + z_504*z_1289 + z_498*(z_1285*z_557 + z_1285*z_558 +
        z_1280*z_568 + z_555*z_1289 - z_1286*z_560 - z_1286*z_561 - z_1279*z_565 - z_1279*z_566 - z_1280*z_569 -
        z_555*z_1288 - z_555*z_1290) - z_1286*z_550 - z_1279*z_551 - z_504*z_1288 - z_504*z_1290;
    const double z_1292 = 2.0*z_1069 + sin_tilt*z_448;
    const double z_1293 = 2.0*z_509*z_1285 + 2.0*z_516*z_1280 - psi_ddot*z_1292;
    const double z_1294 = z_502*z_1280 - z_136*z_1205 - c_*z_1222;
    const double z_1295 = cos_tilt*H_zz + cos_tilt*z_395;
    const double z_1296 = 2.0*z_1044 + z_1295;
    const double z_1297 = 2.0*z_1044 + cos_tilt*z_455;
    const double z_1298 = 2.0*z_509*z_1286 + 2.0*z_516*z_1279 - psi_ddot*z_1297;
    const double z_1299 = z_H*z_1192 + r_F*z_1217;
    const double z_1300 = 2.0*z_502*z_1285 + 2.0*z_136*z_1203 + 2.0*c_*z_1220 + phi_ddot*z_1292;
    const double z_1301 = z_136*z_1192 + c_*z_1217;
    const double z_1302 = 2.0*z_502*z_1286 + 2.0*z_H*z_1203 + 2.0*r_F*z_1220 + phi_ddot*z_1297;
    const double z_1303 = z_502*z_1279 - z_H*z_1205 - r_F*z_1222;
    const double z_1304 = 2.0*z_1257*z_672 + 4.0*z_673*z_1257 + 2.0*z_1257*z_684 + 2.0*z_1258*z_682 +
        2.0*z_1258*z_677 + z_1260*z_407 + z_1296*z_412 + 4.0*z_19*z_1262 + 2.0*z_67*z_1264 + 2.0*z_1269*z_50 +
        sin_theta*(2.0*z_1299*z_1075 + z_1300) + cos_theta*(2.0*z_1301*z_1075 - z_1302) + 2.0*z_1303*z_28 +
        2.0*z_1294*z_40 - 4.0*z_678*z_1258 - 2.0*z_49*z_1261 - 2.0*z_41*z_1261 - 4.0*z_34*z_1261 - 2.0*z_44*z_1262
        - 2.0*z_29*z_1262 - 2.0*z_66*z_1263 - 2.0*z_1269*z_36 - 2.0*z_1270*z_45 - 2.0*z_1270*z_23 -
        2.0*z_60*z_1271 - 2.0*z_63*z_1272 - z_385*z_1276 - z_383*z_1277 - z_1298*z_22 - z_1293*z_17 -
        2.0*(z_H*z_1168 + r_F*z_1169 - z_136*z_1184 - c_*z_1227)*z_734;
    const double z_1305 = 2.0*z_1258*z_684 + 4.0*z_673*z_1258 + 2.0*z_1258*z_672 + z_1260*z_412 + 4.0*z_19*z_1261
        + z_383*z_1276 + 2.0*z_1301*z_1219 + 2.0*z_1294*z_28 - 2.0*z_44*z_1261 - 2.0*z_29*z_1261 - 2.0*z_66*z_1264
        - 2.0*z_1269*z_45 - 2.0*z_1269*z_23 - 2.0*z_60*z_1272 - z_1293*z_22 - cos_theta*z_1300 - 2.0*(z_136*z_1168
        + c_*z_1169)*z_734;
    const double z_1306 = cos_delta*z_544;
    const double z_1307 = 2.0*z_1257*z_682 + 2.0*z_1257*z_677 + z_1296*z_407 + 2.0*z_67*z_1263 + 2.0*z_1270*z_50 +
        z_385*z_1277 + 2.0*z_1299*z_1306 + sin_theta*z_1302 + 2.0*z_1303*z_40 + 2.0*(z_H*z_1184 +
        r_F*z_1227)*z_734 - 4.0*z_678*z_1257 - 2.0*z_41*z_1262 - 2.0*z_49*z_1262 - 4.0*z_34*z_1262 -
        2.0*z_1270*z_36 - 2.0*z_63*z_1271 - z_1298*z_17;
    const double z_1308 = cos_tilt*z_1260;
    const double z_1309 = sin_tilt*z_1296;
    const double z_1310 = z_773 - 2.0*z_774;
    const double z_1311 = z_63*z_1233;
    const double z_1312 = z_1252*z_2;
    const double z_1313 = cos_tilt*r_F;
    const double z_1314 = 2.0*z_773 - z_774;
    D[137] = (-0.5)*(sin_tilt*(z_588 + 2.0*z_101*z_797 + 2.0*z_436*z_798 + 2.0*z_590 + 2.0*z_592 +
        2.0*z_1232*z_219 + 2.0*z_1113*z_219 + 2.0*z_1234*z_219 + 4.0*z_437*z_798 + 4.0*z_1246*z_1245 +
        2.0*z_1247*z_1245 + 2.0*z_1248*z_1245 + 2.0*z_1250*z_219 + 2.0*z_1115*z_219 + 4.0*z_45*z_1255 +
        4.0*z_23*z_1255 + 2.0*z_1108*z_219 + 2.0*z_50*z_1256 + 4.0*z_1257*z_804 + 4.0*z_1258*z_807 +
        8.0*z_1258*z_808 + 4.0*z_1258*z_809 + 4.0*z_1258*z_811 + 4.0*z_814*z_1258 + z_1260*z_453 + 2.0*z_1261*z_56
        + 4.0*z_1261*z_143 + 2.0*z_1262*z_234 + 4.0*z_1262*z_460 + 4.0*z_1262*z_461 + 2.0*z_1263*z_238 +
        8.0*z_1264*z_186 + z_429*z_400 + 2.0*z_383*z_1268 + 4.0*z_1269*z_187 + 2.0*z_1269*z_150 + 2.0*z_1271*z_471
        + z_481*z_1276 + delta_dot*z_1277 + 2.0*z_1281*z_528 + 2.0*z_219*z_1283 + 2.0*z_1034*z_1284 +
        2.0*z_1067*z_880 + 2.0*H_xz*z_878 + 2.0*z_841*z_1075 + 2.0*z_1188*z_844 + 2.0*z_1287*z_537 +
        2.0*z_464*z_857 + 4.0*z_1091*z_2 + 4.0*z_464*z_858 + 2.0*z_1291*z_494 + z_1293*z_103 + 2.0*z_1294*z_141 +
        sin_tilt*z_1304 + 2.0*z_1305*z_168 + 2.0*cos_tilt*z_1307 + z_383*z_24*(2.0*z_1308 - z_1309) + (z_1070 -
        z_1259)*z_734 + 2.0*z_172*z_1198 - z_818*phi_ddot - z_456*psi_ddot - 4.0*z_495*z_1082 - 4.0*z_1231*z_2 -
        2.0*z_496*z_1082 - 4.0*z_1235*z_1245 - 2.0*z_438*z_798 - 2.0*z_1114*z_219 - 2.0*z_1251*z_219 -
        2.0*z_45*z_1253 - 2.0*z_23*z_1253 - 4.0*z_1085*z_2 - 2.0*z_36*z_1256 - 2.0*z_1257*z_803 - 4.0*z_1257*z_805
        - 2.0*z_1258*z_687 - 2.0*z_1258*z_810 - 8.0*z_1258*z_812 - 2.0*z_1258*z_813 - z_1260*z_451 - z_1260*z_452
        - 4.0*z_1261*z_181 - 4.0*z_1261*z_140 - 2.0*z_142*z_1261 - 8.0*z_1261*z_183 - 8.0*z_1261*z_184 -
        4.0*z_144*z_1261 - 2.0*z_145*z_1261 - 4.0*z_1263*z_463 - 2.0*z_1264*z_65 - 4.0*z_1264*z_185 -
        4.0*z_1264*z_147 - 2.0*(2.0*z_1254*z_45 + 2.0*z_1254*z_23 + 2.0*z_409*z_1245 + z_1102 - 2.0*z_410*z_1245 -
        2.0*z_1231)*z_2 - z_1267*z_219 - 2.0*z_436*z_801 - 2.0*z_101*z_799 - 2.0*z_1269*z_149 - 2.0*z_1269*z_151 -
        2.0*z_1270*z_469 - 2.0*z_1272*z_152 - 4.0*z_1272*z_188 - 2.0*z_1273*z_480 - 2.0*z_1225*z_1278 -
        4.0*z_1087*z_2 - 2.0*z_1066*z_880 - 4.0*z_1068*z_877 - 2.0*z_136*z_1191 - 2.0*c_*z_1229 - 2.0*z_1116*z_219
        - 2.0*z_1109*z_219 - 2.0*z_1117*z_219 - 2.0*z_101*z_800 - 2.0*z_1197*z_154 - 2.0*z_138*z_1199 -
        z_1304*z_32 - 2.0*z_1226*z_1310 - delta_ddot*(2.0*z_843 - z_1296 - z_1295) - 2.0*z_892*z_1187) +
        cos_tilt*(z_420 + 2.0*z_101*z_867 + 2.0*z_436*z_866 + 2.0*z_511 + 2.0*z_1106*z_2 + 4.0*z_1311*z_219 +
        2.0*z_1107*z_2 + 4.0*z_1247*z_1249 + 4.0*z_1248*z_1249 + 2.0*z_437*z_866 + 2.0*z_1246*z_1249 +
        4.0*z_1084*z_219 + 4.0*z_50*z_1253 + 2.0*z_45*z_1312 + 2.0*z_23*z_1312 + 2.0*z_36*z_1255 +
        2.0*z_1257*z_807 + 8.0*z_1257*z_809 + 8.0*z_1257*z_811 + 4.0*z_1257*z_808 + 4.0*z_814*z_1257 +
        2.0*z_1258*z_894 + z_1296*z_454 + 4.0*z_1261*z_606 + 4.0*z_1262*z_56 + 8.0*z_1262*z_143 + 4.0*z_1263*z_186
        + 2.0*z_1264*z_1124 + 4.0*z_1264*z_608 + z_1267*z_2 + 2.0*(2.0*z_1252*z_36 + z_1104 - 2.0*z_1252*z_50 -
        2.0*z_404*z_1249 - 2.0*z_405*z_1249 - 2.0*z_1311)*z_219 + 2.0*z_1269*z_609 + 2.0*z_1270*z_187 +
        2.0*z_1270*z_150 + 2.0*z_1272*z_610 + 2.0*z_1273*z_611 + delta_dot*z_1276 + 2.0*z_1226*z_1313 +
        2.0*z_1281*z_613 + 4.0*z_1086*z_219 + 2.0*z_1011*z_1284 + 2.0*z_1066*z_877 + 2.0*z_872*z_1075 +
        2.0*z_1116*z_2 + 2.0*z_1109*z_2 + 2.0*z_462*z_858 + 4.0*z_462*z_857 + 2.0*z_1291*z_612 + z_1298*z_103 +
        2.0*z_1198*z_189 + 2.0*z_1303*z_141 + z_1304*z_168 + (z_1045 - z_1295)*z_734 + 2.0*z_191*z_1197 -
        2.0*z_518 - z_817*phi_ddot - z_449*psi_ddot - 2.0*z_1232*z_2 - 4.0*z_496*z_1083 - 2.0*z_495*z_1083 -
        2.0*z_1234*z_2 - 2.0*z_1266*z_2 - 2.0*z_1265*z_2 - 4.0*z_438*z_866 - 2.0*z_1235*z_1249 - 4.0*z_36*z_1253 -
        2.0*z_1115*z_2 - 2.0*z_1108*z_2 - 2.0*z_50*z_1255 - 4.0*z_1257*z_687 - 4.0*z_1257*z_812 - 2.0*z_1257*z_810
        - 2.0*z_1257*z_813 - 4.0*z_1258*z_895 - 4.0*z_1258*z_896 - z_1296*z_451 - z_1296*z_452 - 2.0*z_1261*z_605
        - 4.0*z_1261*z_607 - 2.0*z_1262*z_181 - 4.0*z_1262*z_183 - 2.0*z_142*z_1262 - 4.0*z_1262*z_184 -
        8.0*z_1262*z_140 - 4.0*z_144*z_1262 - 2.0*z_145*z_1262 - 2.0*z_1263*z_185 - 4.0*z_1263*z_65 -
        8.0*z_1263*z_147 - 2.0*z_436*z_869 - 2.0*z_101*z_868 - z_429*z_396 - 2.0*z_385*z_1268 - 4.0*z_1270*z_149 -
        2.0*z_1270*z_151 - 2.0*z_1271*z_188 - 4.0*z_1271*z_152 - z_481*z_1277 - 2.0*z_2*z_1283 - 2.0*z_1067*z_877
        - 4.0*z_1089*z_880 - 2.0*H_xz*z_881 - 2.0*z_1187*z_898 - 2.0*z_1287*z_614 - 2.0*z_H*z_1191 -
        2.0*r_F*z_1229 - 2.0*z_1110*z_2 - 4.0*z_1090*z_219 - 2.0*z_101*z_893 - 2.0*z_158*z_1199 - 2.0*z_1307*z_32
        - cos_tilt*z_1304 - 2.0*sin_tilt*z_1305 - z_385*z_24*(z_1308 - 2.0*z_1309) - 2.0*z_1225*z_1314 -
        delta_ddot*(2.0*z_871 + z_1260 + z_1259) - 2.0*z_900*z_1188));
    D[138] = -(z_138*z_1171 + z_158*z_1173);
    D[139] = z_1218*z_1075 + z_48*z_1208 + 2.0*z_678*z_1208 + z_49*z_1210 + z_41*z_1210 + 2.0*z_34*z_1210 +
        z_1214*z_36 + z_63*z_1216 + z_1223*z_40 - z_202*z_1210 - sin_phi*z_1223 - z_1208*z_682 - z_1208*z_677 -
        z_67*z_1212 - z_1214*z_50 - (z_1214)*z_217 - z_1218*z_1306 - sin_theta*z_1221 - (z_1184 + z_1227)*z_734;
    const double z_1315 = z_13*z_734;
    const double z_1316 = z_222*z_734;
    const double z_1317 = z_717*z_1075;
    const double z_1318 = z_1197*z_13 + sin_tilt*z_1199 - z_31*z_1198;
    D[140] = -(z_634*z_1288 + z_700*z_1207 + z_240*z_1211 + z_767*z_1175 + z_765*z_1173 + z_1209*z_923 +
        z_1211*z_1139 + z_243*z_1215 + z_1285*z_636 + z_1286*z_637 + z_31*z_1226 + z_1279*z_642 + z_1011*z_1201 +
        z_634*z_1290 + z_1169*z_1185 + z_32*z_1228 + z_365*z_1204 + z_363*z_1202 + z_254*z_1222 - z_1177*z_377 -
        z_1173*z_758 - z_1175*z_374 - z_235*z_1209 - z_1019*z_1177 - z_245*z_1213 - z_1285*z_635 - z_1286*z_638 -
        z_1279*z_643 - z_1280*z_644 - z_1280*z_645 - z_1225*z_13 - z_1034*z_339 - z_634*z_1289 - z_1026*z_1315 -
        z_1036*z_1182 - z_1227*z_1316 - z_776*z_1190 - sin_tilt*z_1229 - z_1217*z_1317 - m_F*z_1318 -
        z_252*z_1220);
    D[143] = z_H*z_1177*z_288 + z_1171*z_1144 + z_1173*z_1145 + z_1175*z_934 + z_1172*z_935 + z_1177*z_1146 +
        z_1190*z_939 + z_1195*z_653 + z_H*z_1318 + z_982*(z_H*z_13 - z_31*z_136)*z_734 + z_979*(z_31*z_H -
        z_136*z_14)*z_734 - z_136*z_1170*z_288 - z_1175*z_936 - z_1172*z_937 - z_1170*z_1147 - z_1171*z_1148 -
        z_1173*z_1149 - z_1189*z_940 - z_1204*z_654 - z_1202*z_655 - z_1196*z_656 - z_136*z_1200 -
        z_724*z_728*z_1075;
    D[144] = -(c_*z_1170*z_307 + z_1172*z_944 + z_1175*z_945 + z_1170*z_1155 + z_1173*z_1156 + z_1171*z_1157 +
        z_1189*z_948 + z_1204*z_658 + z_1202*z_659 + z_1196*z_660 + c_*z_1200 + z_1035*(c_*z_14 - z_31*r_F)*z_734
        + z_780*z_775*z_1075 - r_F*z_1177*z_307 - z_1171*z_1152 - z_1173*z_1153 - z_1175*z_942 - z_1172*z_943 -
        z_1177*z_1154 - z_1190*z_947 - z_1195*z_657 - r_F*z_1318 - z_1025*(r_F*z_13 - c_*z_31)*z_734);
    D[147] = z_1206;
    D[148] = z_1177*z_355 + z_1173*z_706 + z_1175*z_347 + z_235*z_1176 + z_240*z_1178 + z_1178*z_1139 +
        z_976*z_1177 + z_245*z_1179 + z_983*z_1315 + z_980*z_1182 + z_1184*z_1316 + z_729*z_1190 + sin_tilt*z_1191
        + z_1192*z_1317 + m_H*z_1318 + z_252*z_1203 - z_700*z_1174 - z_1176*z_923 - z_711*z_1175 - z_712*z_1173 -
        z_243*z_1180 - z_1168*z_1185 - z_32*z_1186 - z_333*z_1204 - z_332*z_1202 - z_254*z_1205;
    const double z_1319 = (z_394*z_1274 - delta_ddot*z_14) - ((cos_tilt*z_1160 + cos_tilt*z_1161) + (z_1182 -
        cos_tilt*z_414));
    const double z_1320 = -z_1319;
    const double z_1321 = (z_390*z_1275 - delta_ddot*z_13) + ((sin_tilt*z_1163 + sin_tilt*z_1164) + (z_1182 -
        sin_tilt*z_419));
    D[151] = z_1320 - z_1321;
    D[152] = z_433*z_1273;
    D[157] = (-0.5)*(z_1321 + z_1321);
    D[158] = z_431*z_1273;
    D[159] = 0.5*(z_1320 - z_1319);
    D[160] = cos_tilt*z_419 + z_390*z_1274 + z_394*z_1275 + cos_tilt*z_878 + sin_tilt*z_881 + sin_tilt*z_1160 +
        sin_tilt*z_1161 - sin_tilt*z_414 - cos_tilt*z_1163 - cos_tilt*z_1164;
    D[166] = -lambda_1;
    D[177] = spin_r_ddot + z_1159;
    const double z_1322 = lambda_3*z_526 + lambda_3*z_502;
    const double z_1323 = F_yy*phi_ddot + lambda_4*z_526 + lambda_4*z_502;
    const double z_1324 = F_yy*psi_ddot - 2.0*lambda_4*z_509 - 2.0*lambda_3*z_516 - z_498*(lambda_4*z_563 +
        lambda_3*z_570 - lambda_4*z_505 - lambda_3*z_513);
    D[191] = -(sin_tilt*(F_yy*z_440 + z_1322*z_528 + z_1324*z_494 - F_yy*z_441 - z_1323*z_537) +
        cos_tilt*(F_yy*z_602 + F_yy*z_603 + z_1322*z_613 + z_1323*z_614 + z_1324*z_612));
    D[194] = -(lambda_4*z_640 + lambda_4*z_641 + lambda_3*z_646 + lambda_3*z_647);
    D[206] = -(z_425 + z_497*phi_ddot - spin_f_ddot - z_498*psi_ddot - z_958);
    const double z_1325 = z_67 - z_84;
    const double z_1326 = cos_phi*z_1325;
    const double z_1327 = z_48 + sin_phi*phi_ddot;
    const double z_1328 = sin_theta*z_1327;
    const double z_1329 = 2.0*z_673 + z_1326 + z_1328;
    D[216] = z_1329;
    const double z_1330 = z_86 + z_53;
    const double z_1331 = z_31*z_1330;
    const double z_1332 = z_66 + z_97;
    const double z_1333 = cos_phi*z_1332;
    const double z_1334 = cos_theta*z_1327;
    const double z_1335 = z_842 - sin_delta*z_4;
    const double z_1336 = z_202 - z_623;
    const double z_1337 = 2.0*z_814 + sin_phi*z_1335 - sin_delta*z_1336;
    D[217] = -(2.0*z_683 + 2.0*z_685 + z_1330*z_686 + z_15*z_1326 + z_33*z_1333 + z_33*z_1334 + z_15*z_1328 +
        cos_tilt*z_1337 + 2.0*z_676 - z_17*z_1331 - z_1329 - 2.0*z_681);
    const double z_1338 = (c_*z_404 + c_*z_405) - (r_F*z_409 - r_F*z_410);
    const double z_1339 = z_475 + (z_1246 + z_476 - z_1235) + (z_1248 + z_1247 - z_477);
    const double z_1340 = z_1339*z_499;
    const double z_1341 = z_554*z_1340;
    const double z_1342 = z_1339*z_504;
    const double z_1343 = z_508*z_7;
    const double z_1344 = sin_delta*z_409;
    const double z_1345 = sin_delta*z_410;
    const double z_1346 = z_474*z_562 + z_474*z_504 + z_477*z_562 + z_477*z_504 + z_1235*z_562 + z_1235*z_504 -
        z_476*z_562 - z_476*z_504 - z_1246*z_562 - z_1246*z_504 - z_1248*z_562 - z_1248*z_504 - z_1247*z_562 -
        z_1247*z_504 - z_473*z_562 - z_473*z_504;
    const double z_1347 = z_1282*z_1330;
    const double z_1348 = z_1335*z_508;
    const double z_1349 = z_508*z_141;
    const double z_1350 = z_1327*z_508;
    const double z_1351 = z_1339*z_555;
    const double z_1352 = z_24*z_217;
    const double z_1353 = z_410*z_8;
    const double z_1354 = z_409*z_8;
    const double z_1355 = z_405*z_220;
    const double z_1356 = z_404*z_220;
    const double z_1357 = sin_phi*z_1330;
    const double z_1358 = z_1335*z_699;
    const double z_1359 = sin_tilt*z_17;
    const double z_1360 = z_1335*z_1359;
    const double z_1361 = cos_delta*z_1336;
    const double z_1362 = z_1340*(r_F/(z_501*(z_500*z_500)));
    const double z_1363 = z_1339*z_554;
    const double z_1364 = 2.0*z_474*z_1351 + 2.0*z_504*z_1352 + 2.0*z_504*z_1353 + 2.0*z_477*z_1351 +
        2.0*z_673*z_852 + 2.0*z_678*z_851 + 2.0*z_1235*z_1351 + z_504*z_1357 + z_504*z_1360 + z_1326*z_852 +
        z_1328*z_852 + z_504*z_1361 + z_498*(3.0*z_474*z_1362 + z_474*z_1363 + 2.0*z_555*z_1352 + 2.0*z_555*z_1353
        + 3.0*z_477*z_1362 + z_477*z_1363 + 2.0*z_673*z_855 + 2.0*z_678*z_854 + 3.0*z_1235*z_1362 + z_1235*z_1363
        + z_555*z_1357 + z_555*z_1360 + z_1326*z_855 + z_1328*z_855 + z_555*z_1361 - 3.0*z_476*z_1362 -
        z_476*z_1363 - 2.0*z_555*z_1354 - 2.0*z_555*z_1355 - 2.0*z_555*z_1356 - 3.0*z_1246*z_1362 - z_1246*z_1363
        - 3.0*z_1248*z_1362 - z_1248*z_1363 - 3.0*z_1247*z_1362 - z_1247*z_1363 - 3.0*z_473*z_1362 - z_473*z_1363
        - z_555*z_1358 - z_1333*z_854 - z_1334*z_854) - 2.0*z_476*z_1351 - 2.0*z_504*z_1354 - 2.0*z_504*z_1355 -
        2.0*z_504*z_1356 - 2.0*z_1246*z_1351 - 2.0*z_1248*z_1351 - 2.0*z_1247*z_1351 - 2.0*z_473*z_1351 -
        z_504*z_1358 - z_1333*z_851 - z_1334*z_851;
    const double z_1365 = 2.0*r_F*z_673 + r_F*z_1326 + c_*z_1333 + r_F*z_1328 + c_*z_1334 - 2.0*c_*z_678;
    const double z_1366 = 2.0*c_*z_673 + c_*z_1326 + c_*z_1328;
    const double z_1367 = 2.0*r_F*z_678 - r_F*z_1333 - r_F*z_1334;
    const double z_1368 = z_24*(z_773 - 4.0*z_774);
    const double z_1369 = sin_delta*z_404;
    const double z_1370 = sin_delta*z_405;
    const double z_1371 = z_24*(4.0*z_773 - z_774);
    D[218] = sin_tilt*(z_1338*z_37 + 2.0*z_410*z_1343 + 2.0*z_673*z_1065 + c_*z_809 + z_1341*z_1345 +
        z_1342*z_1345 + c_*z_811 + z_1346*z_435 + z_1346*z_1344 + 2.0*c_*z_1330*z_699 + z_1325*z_1349 +
        z_614*z_1350 + c_*z_1337 + z_1364*z_494 + sin_tilt*z_1365 + 2.0*z_1366*z_168 + z_410*z_1368 - z_1341*z_435
        - z_1342*z_435 - 2.0*z_409*z_1343 - z_1341*z_1344 - z_1342*z_1344 - z_1346*z_1345 - sin_tilt*z_1347 -
        z_22*z_1348 - z_1365*z_32 - 2.0*cos_tilt*z_1367 - z_409*z_1368) - cos_tilt*(z_1338*z_182 + z_1341*z_601 +
        z_1342*z_601 + 2.0*z_678*z_1065 + r_F*z_812 + z_1346*z_1370 + z_1346*z_1369 + 2.0*r_F*z_1330*z_1359 +
        z_17*z_1348 + cos_tilt*z_1365 + 2.0*sin_tilt*z_1366 - 2.0*z_405*z_1343 - 2.0*z_404*z_1343 - r_F*z_808 -
        z_1341*z_1369 - z_1342*z_1369 - z_1341*z_1370 - z_1342*z_1370 - z_1346*z_601 - cos_tilt*z_1347 -
        z_1332*z_1349 - z_537*z_1350 - r_F*z_1337 - z_1364*z_612 - 2.0*z_1367*z_32 - z_1365*z_168 - z_405*z_1371 -
        z_404*z_1371);
    D[220] = -(2.0*z_678 + z_1327 - z_1333 - z_1334);
    const double z_1372 = z_553*z_1340;
    const double z_1373 = z_1339*z_503;
    D[221] = 2.0*z_697 + z_476*z_1372 + z_476*z_1373 + 2.0*z_634*z_1354 + 2.0*z_634*z_1355 + 2.0*z_634*z_1356 +
        z_1246*z_1372 + z_1246*z_1373 + z_1248*z_1372 + z_1248*z_1373 + z_1247*z_1372 + z_1247*z_1373 +
        z_473*z_1372 + z_473*z_1373 + z_22*z_1331 + z_634*z_1358 + z_1333*z_924 + z_1334*z_924 + sin_tilt*z_1337 +
        2.0*z_692 + 2.0*z_695 - 2.0*z_696 - z_474*z_1372 - z_474*z_1373 - 2.0*z_634*z_1352 - 2.0*z_634*z_1353 -
        z_477*z_1372 - z_477*z_1373 - 2.0*z_673*z_925 - 2.0*z_678*z_924 - z_1235*z_1372 - z_1235*z_1373 -
        z_1330*z_698 - z_634*z_1357 - z_634*z_1360 - z_1326*z_925 - z_33*z_1326 - z_222*z_1333 - z_1328*z_925 -
        z_33*z_1328 - z_222*z_1334 - z_634*z_1361;
    D[247] = -(theta_ddot + spin_r_ddot);
    const double z_1374 = psi_dot*z_45 + psi_dot*z_23 + z_995 + z_1332;
    D[297] = -z_1374;
    const double z_1375 = z_63*z_24 + z_195 + z_87;
    const double z_1376 = z_60*z_24 - z_62 - z_90;
    D[298] = z_975 + z_31*z_1375 + z_114*psi_ddot + z_68 + z_341 - z_1376*z_14 - z_1374;
    const double z_1377 = z_1339*z_508;
    const double z_1378 = (z_483 + z_1240) - (z_484 + z_1239) - z_482;
    const double z_1379 = (cos_phi*z_24 + cos_delta*z_10) + (z_2*z_23 + z_2*z_45 + z_8*z_28) - (z_219*z_36 +
        z_220*z_40 - z_219*z_50);
    const double z_1380 = (z_246*z_502 + z_254*z_1377) - (z_1378*z_516 + z_1379*z_521 - z_1339*z_551 -
        z_1341*z_564);
    const double z_1381 = z_1339*z_516;
    const double z_1382 = z_555*z_1340;
    const double z_1383 = sin_delta*((z_1381 + z_1379*z_502) - (2.0*z_1381 + z_512*z_1382 - z_1379*z_526));
    const double z_1384 = z_514*z_7;
    const double z_1385 = z_591*z_382;
    const double z_1386 = z_517*z_384;
    const double z_1387 = z_487 + (z_488 + z_1236) + (z_1237 - z_489);
    const double z_1388 = (z_80*z_502 - z_114*z_1377) + (z_1387*z_516 + z_1339*z_552 + z_1341*z_567 -
        z_1379*z_524);
    const double z_1389 = z_33*z_382 + z_222*z_384 + z_393;
    const double z_1390 = z_15*z_382 + z_33*z_384 + z_389;
    const double z_1391 = z_382*z_2 + z_432 - z_384*z_219;
    const double z_1392 = z_1389*z_521 + z_1391*z_526 + z_1391*z_502 - z_1390*z_524;
    const double z_1393 = z_1392*z_7;
    const double z_1394 = sin_delta*z_1392;
    const double z_1395 = z_1389*z_564;
    const double z_1396 = z_444*z_1389;
    const double z_1397 = z_254*z_1389;
    const double z_1398 = z_1390*z_567;
    const double z_1399 = z_447*z_1390;
    const double z_1400 = z_114*z_1390;
    const double z_1401 = z_512*z_1391;
    const double z_1402 = z_499*z_555;
    const double z_1403 = z_562*z_1395 + z_513*z_1396 + z_508*z_1397 + z_508*z_1400 + z_1401*z_1402 + z_1391*z_516
        - z_562*z_1398 - z_513*z_1399;
    const double z_1404 = z_1390*z_502 + z_828;
    const double z_1405 = z_1389*z_502 + z_825;
    const double z_1406 = z_1389*z_516;
    const double z_1407 = z_1390*z_516;
    const double z_1408 = z_411 + z_545;
    const double z_1409 = sin_delta*z_514;
    const double z_1410 = sin_delta*z_1159;
    const double z_1411 = z_1378*z_1389;
    const double z_1412 = z_1387*z_1390;
    const double z_1413 = z_406 - z_572;
    const double z_1414 = z_1159*z_219 + (z_413 + z_581);
    const double z_1415 = z_382*z_38 + z_33*z_1408 + z_1414 - z_384*z_224 - z_222*z_1413;
    const double z_1416 = z_1159*z_2 + (z_418 - z_583);
    const double z_1417 = z_382*z_25 + z_33*z_1413 + z_1416 - z_384*z_38 - z_15*z_1408;
    const double z_1418 = cos_delta*z_1159 - (z_422 - spin_f_ddot);
    const double z_1419 = z_384*z_220 - z_382*z_8 - z_1408*z_2 - z_1413*z_219 - z_1418;
    const double z_1420 = z_1341*z_1396 + z_1342*z_1396 + z_1391*z_1382 + z_1391*z_1377 + z_1415*z_521 +
        z_1417*z_524 - z_508*z_1411 - z_1341*z_1399 - z_1342*z_1399 - z_508*z_1412 - z_1419*z_526 - z_1419*z_502;
    const double z_1421 = z_1379*z_1396;
    const double z_1422 = z_1379*z_1399;
    const double z_1423 = z_1379*z_1391;
    const double z_1424 = z_1339*z_513;
    const double z_1425 = z_512*z_555;
    const double z_1426 = z_246*z_1389;
    const double z_1427 = z_80*z_1390;
    const double z_1428 = z_498*z_1362;
    const double z_1429 = z_504*z_1421 + z_513*z_1411 + 2.0*z_1351*z_1398 + z_513*z_1412 + 2.0*z_508*z_1423 +
        2.0*z_1419*z_516 + z_498*(z_555*z_1421 + z_1411*z_1425 + z_504*z_1426 + 3.0*z_1362*z_1398 + z_1363*z_1398
        + z_1412*z_1425 + z_562*z_1423 + z_1417*z_569 + z_1419*z_570 - 3.0*z_1362*z_1395 - z_1363*z_1395 -
        z_1351*z_1397 - z_555*z_1422 - z_1351*z_1400 - z_504*z_1427 - 3.0*z_1401*z_1428 - z_504*z_1423 -
        z_1351*z_1401 - z_1415*z_565 - z_1415*z_566 - z_1417*z_568 - z_1419*z_513) - 2.0*z_1351*z_1395 -
        z_1342*z_1397 - z_504*z_1422 - z_1342*z_1400 - 3.0*z_1341*z_1401 - z_1391*z_1424 - z_1415*z_551 -
        z_1417*z_552;
    const double z_1430 = z_1379*z_508;
    const double z_1431 = z_512*z_1341;
    const double z_1432 = z_1390*z_1430 + z_1417*z_516 - z_1390*z_1431 - z_1390*z_1424;
    const double z_1433 = c_*psi_ddot;
    const double z_1434 = z_1390*z_1377 + z_1417*z_502 - z_1433;
    const double z_1435 = z_1389*z_1430 - z_1389*z_1431 - z_1389*z_1424 - z_1415*z_516;
    const double z_1436 = r_F*psi_ddot;
    const double z_1437 = z_1389*z_1377 - z_1415*z_502 - z_1436;
    const double z_1438 = z_382*z_1380 + c_*z_67 + z_1404*z_50 + z_409*z_1406 + z_517*z_1413 + z_1437*z_28 +
        z_1434*z_40 - z_384*z_1388 - r_F*z_66 - z_1404*z_36 - z_1405*z_45 - z_1405*z_23 - z_410*z_1406 -
        z_404*z_1407 - z_405*z_1407 - z_591*z_1408 - r_F*z_97 - c_*z_84 - z_1435*z_22 - z_1432*z_17;
    const double z_1439 = z_382*z_1388 + c_*z_66 + z_1404*z_45 + z_1404*z_23 + z_410*z_1407 + z_517*z_1408 +
        c_*z_97 + z_1432*z_22 - z_409*z_1407 - z_1434*z_28;
    const double z_1440 = z_384*z_1380 + r_F*z_67 + z_1405*z_50 + z_591*z_1413 + z_1437*z_40 - z_1405*z_36 -
        z_404*z_1406 - z_405*z_1406 - r_F*z_84 - z_1435*z_17;
    const double z_1441 = z_24*z_1310;
    const double z_1442 = z_24*z_1314;
    D[299] = sin_tilt*(delta_dot*z_1380 + z_382*z_1384 + 2.0*z_517*z_382*z_182 + z_481*z_1388 + z_517*z_452 +
        z_1403*z_435 + z_1403*z_1344 + 2.0*z_1404*z_187 + z_1404*z_150 + z_1406*z_397 + z_1407*z_402 +
        z_1408*z_1409 + z_517*z_1410 + z_1432*z_103 + z_1434*z_141 + sin_tilt*z_1438 + 2.0*cos_tilt*z_1440 -
        z_382*z_1383 - z_37*z_1385 - z_37*z_1386 - z_28*z_1393 - z_45*z_1394 - z_23*z_1394 - c_*z_147 -
        z_1403*z_1345 - z_1404*z_149 - z_1404*z_151 - z_1405*z_469 - 2.0*z_1407*z_401 - z_450*z_1407 -
        z_1407*z_421 - z_1375*z_1278 - z_591*delta_ddot - z_1420*z_528 - z_1429*z_494 - z_1438*z_32 -
        2.0*z_1439*z_168 - z_60*z_1441 - z_1310*z_1376) + cos_tilt*(delta_dot*z_1388 + z_182*z_1385 + z_384*z_1384
        + z_182*z_1386 + z_591*z_452 + z_50*z_1394 + r_F*z_186 + z_1403*z_601 + z_1404*z_609 + z_1405*z_187 +
        z_1405*z_150 + 2.0*z_1406*z_402 + z_1376*z_1313 + z_517*delta_ddot + z_591*z_1410 + z_1435*z_103 +
        z_1437*z_141 + z_1438*z_168 + 2.0*sin_tilt*z_1439 - z_384*z_1383 - 2.0*z_591*z_384*z_37 - z_481*z_1380 -
        z_40*z_1393 - z_36*z_1394 - z_1403*z_1370 - z_1403*z_1369 - 2.0*z_1405*z_149 - z_1405*z_151 - z_1406*z_401
        - z_450*z_1406 - z_1406*z_421 - z_1407*z_600 - z_1413*z_1409 - z_1420*z_613 - z_1429*z_612 -
        2.0*z_1440*z_32 - cos_tilt*z_1438 - z_63*z_1442 - z_1314*z_1375);
    D[301] = psi_dot*z_50 + z_1325 + z_1158 - psi_dot*z_36 - z_994;
    const double z_1443 = z_512*z_634;
    const double z_1444 = z_1339*z_634;
    const double z_1445 = z_498*z_1372;
    D[302] = -(z_1372*z_1395 + z_1373*z_1395 + z_1444*z_1397 + z_501*z_1426 + z_634*z_1422 + z_1444*z_1400 +
        z_1401*z_1445 + z_1401*z_1444 + z_1139 + z_1415*z_642 + z_1417*z_644 + z_1417*z_645 + z_1375*z_13 + z_239
        - z_634*z_1421 - z_1411*z_1443 - z_1372*z_1398 - z_1373*z_1398 - z_1412*z_1443 - z_501*z_1427 -
        z_639*z_1423 - z_501*z_1423 - z_31*z_1376 - z_1415*z_643 - z_1419*z_646 - z_1419*z_647 - z_254*psi_ddot -
        z_357);
    const double z_1446 = psi_dot*z_60 + z_29 + z_44 - 2.0*z_19 - z_95 - z_100 - z_850;
    D[324] = -z_1446;
    const double z_1447 = z_24*z_50 - z_24*z_36 - z_190 - z_88;
    const double z_1448 = z_24*z_23 + z_24*z_45 + z_54 + z_91;
    const double z_1449 = z_145 + 2.0*z_144 + z_142 + z_104 - z_102;
    D[325] = -(2.0*z_20 + z_109*psi_ddot + z_1446 + z_42 - 2.0*z_35 - z_710 - z_31*z_1447 - z_1448*z_14 -
        cos_tilt*z_1449 - z_30 - z_47 - z_52 - z_345);
    const double z_1450 = (z_60*z_2 - z_830) - (z_63*z_219 + z_831);
    const double z_1451 = (z_244*z_502 - z_252*z_1377) + (z_1378*z_509 + z_1450*z_521 - z_1339*z_550 -
        z_1341*z_559);
    const double z_1452 = z_1339*z_509;
    const double z_1453 = sin_delta*((z_1450*z_502 + z_1452) - (2.0*z_1452 + z_497*z_1382 - z_1450*z_526));
    const double z_1454 = (z_75*z_502 + z_109*z_1377) + (z_1387*z_509 + z_1339*z_549 + z_1341*z_556 -
        z_1450*z_524);
    const double z_1455 = z_390*z_524 + z_394*z_521 + z_433*z_526 + z_433*z_502;
    const double z_1456 = sin_delta*z_1455;
    const double z_1457 = z_390*z_556;
    const double z_1458 = z_109*z_390;
    const double z_1459 = z_394*z_559;
    const double z_1460 = z_252*z_394;
    const double z_1461 = z_497*z_433;
    const double z_1462 = z_562*z_1457 + z_390*z_549 + z_508*z_1458 + z_562*z_1459 + z_394*z_550 + z_508*z_1460 +
        z_1461*z_1402 + z_433*z_509;
    const double z_1463 = z_394*z_509;
    const double z_1464 = z_390*z_509;
    const double z_1465 = z_825 + z_394*z_502;
    const double z_1466 = z_828 - z_390*z_502;
    const double z_1467 = z_412 - z_546;
    const double z_1468 = sin_delta*z_506;
    const double z_1469 = z_447*z_390;
    const double z_1470 = z_390*z_1387;
    const double z_1471 = z_444*z_394;
    const double z_1472 = z_394*z_1378;
    const double z_1473 = z_407 + z_573;
    const double z_1474 = z_416 + z_417 + z_15*z_1467 + z_33*z_1473 - z_1416;
    const double z_1475 = z_403 + z_408 - z_33*z_1467 - z_222*z_1473 - z_1414;
    const double z_1476 = z_423 + z_424 + z_1473*z_219 - z_1467*z_2 - z_1418;
    const double z_1477 = z_1341*z_1469 + z_1342*z_1469 + z_508*z_1470 + z_1341*z_1471 + z_1342*z_1471 +
        z_433*z_1382 + z_433*z_1377 - z_508*z_1472 - z_1474*z_524 - z_1475*z_521 - z_1476*z_526 - z_1476*z_502;
    const double z_1478 = z_1450*z_1469;
    const double z_1479 = z_1450*z_1471;
    const double z_1480 = z_433*z_1450;
    const double z_1481 = z_1339*z_505;
    const double z_1482 = z_497*z_555;
    const double z_1483 = z_390*z_75;
    const double z_1484 = z_394*z_244;
    const double z_1485 = 2.0*z_1351*z_1457 + z_505*z_1470 + z_1342*z_1458 + 2.0*z_1351*z_1459 + z_1342*z_1460 +
        3.0*z_1341*z_1461 + z_433*z_1481 + z_498*(3.0*z_1362*z_1457 + z_1363*z_1457 + z_1470*z_1482 +
        z_1351*z_1458 + 3.0*z_1362*z_1459 + z_1363*z_1459 + z_1351*z_1460 + z_504*z_1484 + 3.0*z_1461*z_1428 +
        z_1351*z_1461 + z_504*z_1480 + z_1476*z_505 - z_555*z_1478 - z_504*z_1483 - z_555*z_1479 - z_1472*z_1482 -
        z_562*z_1480 - z_1474*z_557 - z_1474*z_558 - z_1475*z_560 - z_1475*z_561 - z_1476*z_563) - z_504*z_1478 -
        z_504*z_1479 - z_505*z_1472 - 2.0*z_508*z_1480 - z_1474*z_549 - z_1475*z_550 - 2.0*z_1476*z_509;
    const double z_1486 = z_497*z_1341;
    const double z_1487 = z_1450*z_508;
    const double z_1488 = z_390*z_1486 + z_390*z_1481 - z_390*z_1487 - z_1474*z_509;
    const double z_1489 = z_394*z_1486 + z_394*z_1481 - z_394*z_1487 - z_1475*z_509;
    const double z_1490 = z_1433 + z_390*z_1377 + z_1474*z_502;
    const double z_1491 = z_1436 - z_394*z_1377 - z_1475*z_502;
    const double z_1492 = r_F*z_44 + c_*z_49 + 2.0*c_*z_34 + r_F*z_29 + c_*z_41 + z_385*z_1454 + z_410*z_1463 +
        z_60*z_1465 + z_63*z_1466 + c_*z_93 + z_589*z_1467 + z_1488*z_17 + sin_theta*z_1490 - 2.0*r_F*z_19 -
        z_383*z_1451 - z_409*z_1463 - z_404*z_1464 - z_405*z_1464 - r_F*z_95 - r_F*z_100 - c_*z_99 - z_510*z_1473
        - z_1489*z_22 - cos_theta*z_1491;
    const double z_1493 = c_*z_44 + c_*z_29 + z_409*z_1464 + z_60*z_1466 + z_1488*z_22 - 2.0*c_*z_19 -
        z_383*z_1454 - z_410*z_1464 - c_*z_95 - c_*z_100 - z_510*z_1467 - cos_theta*z_1490;
    const double z_1494 = r_F*z_49 + 2.0*r_F*z_34 + r_F*z_41 + z_385*z_1451 + z_404*z_1463 + z_405*z_1463 +
        z_63*z_1465 + r_F*z_93 + z_589*z_1473 + sin_theta*z_1491 - r_F*z_99 - z_1489*z_17;
    D[326] = -(sin_tilt*(delta_dot*z_1451 + c_*z_140 + z_506*z_441 + z_510*z_452 + z_60*z_1456 + z_1462*z_1345 +
        z_1464*z_402 + z_1466*z_152 + 2.0*z_1466*z_188 + z_589*delta_ddot + z_510*z_1410 + z_1447*z_1278 +
        c_*z_1449 + sin_tilt*z_1492 + 2.0*z_1493*z_168 + 2.0*cos_tilt*z_1494 - c_*z_143 - z_383*z_1453 -
        z_589*z_457 - 2.0*z_510*z_454 - z_510*z_453 - z_481*z_1454 - z_1455*z_815 - z_1462*z_435 - z_1462*z_1344 -
        z_1463*z_397 - 2.0*z_1464*z_401 - z_450*z_1464 - z_1464*z_421 - z_1465*z_471 - z_1467*z_1468 -
        z_1477*z_537 - z_1485*z_494 - z_1488*z_103 - z_1492*z_32 - z_45*z_1441 - z_23*z_1441 - z_1310*z_1448) -
        cos_tilt*(delta_dot*z_1454 + z_506*z_603 + z_481*z_1451 + z_589*z_452 + z_1462*z_601 + 2.0*z_1463*z_402 +
        z_1464*z_600 + z_1466*z_610 + z_1473*z_1468 + z_589*z_1410 + z_1485*z_612 + 2.0*z_1494*z_32 +
        cos_tilt*z_1492 + 2.0*sin_tilt*z_1493 + z_36*z_1442 - r_F*z_183 - r_F*z_184 - z_589*z_454 - z_385*z_1453 -
        z_510*z_604 - 2.0*z_589*z_453 - z_1455*z_897 - z_63*z_1456 - z_1462*z_1370 - z_1462*z_1369 - z_1463*z_401
        - z_450*z_1463 - z_1463*z_421 - z_1465*z_188 - 2.0*z_1465*z_152 - z_510*delta_ddot - z_1448*z_1313 -
        z_1477*z_614 - r_F*z_1449 - z_1489*z_103 - z_1492*z_168 - z_50*z_1442 - z_1314*z_1447));
    D[328] = z_99 + z_1336 - psi_dot*z_63 - 2.0*z_34 - z_41 - z_49 - z_93 - z_856;
    const double z_1495 = z_497*z_634;
    D[329] = 2.0*z_223 + z_634*z_1478 + z_634*z_1479 + z_1472*z_1495 + z_501*z_1484 + z_639*z_1480 + z_501*z_1480
        + z_923 + z_1474*z_635 + z_1475*z_637 + z_1476*z_640 + z_1476*z_641 + z_252*psi_ddot + z_226 + z_228 +
        z_233 + z_349 - 2.0*z_229 - z_1372*z_1457 - z_1373*z_1457 - z_1470*z_1495 - z_1444*z_1458 - z_501*z_1483 -
        z_1372*z_1459 - z_1373*z_1459 - z_1444*z_1460 - z_1461*z_1445 - z_1461*z_1444 - z_1474*z_636 -
        z_1475*z_638 - z_31*z_1448 - z_1447*z_13 - sin_tilt*z_1449 - z_231;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double delta = x[5];
    const double sin_delta = em_sin(delta);
    const double tilt = c[2];
    const double sin_tilt = em_sin(tilt);
    const double r_F = c[5];
    const double z_3 = sin_tilt*r_F;
    const double c_ = c[1];
    const double cos_tilt = em_cos(tilt);
    const double z_5 = c_*cos_tilt;
    const double z_6 = z_3 - z_5;
    const double z_7 = sin_delta*z_6;
    const double cos_delta = em_cos(delta);
    const double sin_phi = em_sin(phi);
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double z_11 = sin_theta*cos_phi;
    const double z_12 = cos_tilt*sin_delta;
    const double cos_theta = em_cos(theta);
    const double z_14 = cos_theta*cos_phi;
    const double z_15 = sin_tilt*sin_delta;
    const double z_16 = sin_phi*cos_delta + z_11*z_12 - z_14*z_15;
    const double z_17 = z_16*z_16;
    const double z_18 = 1.0 - z_17;
    const double z_19 = sqrt(z_18);
    const double z_20 = 1.0/z_19;
    const double z_21 = r_F*z_20;
    const double z_22 = z_16*z_21;
    const double z_23 = z_7 + cos_delta*z_22;
    const double r_R = c[4];
    const double z_24 = sin_theta*z_12;
    const double z_25 = cos_theta*z_15;
    const double z_26 = cos_tilt*cos_tilt;
    const double z_27 = sin_tilt*sin_tilt;
    const double z_28 = z_26 + cos_delta*z_27;
    const double z_29 = r_F*z_28;
    const double z_30 = sin_tilt*cos_tilt;
    const double z_31 = sin_tilt*cos_delta;
    const double z_32 = z_30 - cos_tilt*z_31;
    const double z_33 = sin_theta*z_32;
    const double z_34 = r_F*z_33;
    const double w = c[0];
    const double z_35 = c_ + w;
    const double z_36 = z_27 + cos_delta*z_26;
    const double z_37 = c_*z_36;
    const double z_38 = cos_theta*z_32;
    const double z_39 = c_*z_38;
    const double z_40 = (cos_theta*z_29 + z_34) - ((r_R*cos_theta + sin_theta*z_35) - (sin_theta*z_37 + z_39));
    const double z_41 = r_R + z_22*z_24 + z_40 - z_22*z_25;
    D[3] = cos_phi*z_23 - sin_phi*z_41;
    const double z_42 = r_R*cos_phi;
    const double z_43 = z_32*cos_phi;
    const double z_44 = cos_phi*z_15;
    const double z_45 = z_42 + z_44*z_22 - c_*z_43 - cos_phi*z_29;
    const double z_46 = cos_phi*z_12;
    const double z_47 = cos_phi*z_35 - cos_phi*z_37 - r_F*z_43 - z_46*z_22;
    D[4] = sin_theta*z_45 - cos_theta*z_47;
    const double z_48 = sin_tilt*z_14;
    const double z_49 = cos_tilt*z_11;
    const double z_50 = sin_phi*z_6 + z_22*z_49 - z_22*z_48;
    const double z_51 = c_*z_14 + r_F*z_11;
    const double z_52 = c_*z_11;
    const double z_53 = r_F*z_14;
    const double z_54 = z_30*z_51 - z_26*z_52 - sin_phi*z_22 - z_27*z_53;
    D[5] = cos_delta*z_50 + sin_delta*z_54;
    D[16] = -z_11;
    const double z_55 = sin_phi*z_12 - z_36*z_11 - z_32*z_14;
    D[17] = -(z_55 + z_11);
    const double z_56 = sin_delta*z_22;
    const double z_57 = sin_phi*sin_delta;
    const double z_58 = cos_tilt*cos_delta;
    D[18] = -(sin_tilt*(sin_tilt*z_51 + z_11*z_56 + 2.0*c_*cos_delta*z_49 + 2.0*cos_tilt*z_53 - c_*z_57 -
        z_51*z_31) - cos_tilt*(cos_tilt*z_51 + r_F*z_57 + 2.0*z_31*z_53 + 2.0*sin_tilt*z_52 - z_14*z_56 -
        z_51*z_58));
    D[20] = cos_phi - z_14;
    const double z_59 = z_28*z_14 + z_32*z_11 + sin_phi*z_15;
    D[21] = z_59 - z_19;
    const double theta_dot = v[4];
    const double z_60 = theta_dot*cos_theta;
    const double delta_dot = v[5];
    const double z_61 = delta_dot*cos_delta;
    const double z_62 = z_22*z_61;
    const double z_63 = theta_dot*sin_theta;
    const double phi_dot = v[3];
    const double z_64 = delta_dot*sin_delta;
    const double z_65 = sin_phi*z_64;
    const double z_66 = z_61*z_49;
    const double z_67 = z_61*z_48;
    const double z_68 = theta_dot*z_14;
    const double z_69 = z_68*z_12;
    const double z_70 = theta_dot*z_11;
    const double z_71 = z_70*z_15;
    const double z_72 = sin_phi*cos_theta;
    const double z_73 = phi_dot*z_72;
    const double z_74 = z_73*z_15;
    const double z_75 = sin_phi*sin_theta;
    const double z_76 = phi_dot*z_75;
    const double z_77 = z_76*z_12;
    const double z_78 = phi_dot*cos_phi;
    const double z_79 = cos_delta*z_78;
    const double z_80 = 1.0/(z_18*z_19);
    const double z_81 = r_F*z_80;
    const double z_82 = z_16*z_81;
    const double z_83 = theta_dot*r_F;
    const double z_84 = z_14*z_83;
    const double z_85 = z_16*z_80;
    const double z_86 = z_11*z_83;
    const double z_87 = z_21*z_65 + z_21*z_67 + z_21*z_77 + z_16*(z_82*z_65 + z_82*z_67 + z_82*z_77 - z_82*z_66 -
        z_84*z_12*z_85 - z_86*z_15*z_85 - z_82*z_74 - z_82*z_79) - z_21*z_66 - z_21*z_69 - z_21*z_71 - z_21*z_74 -
        z_21*z_79;
    const double z_88 = theta_dot*c_;
    const double z_89 = z_36*z_88;
    const double z_90 = z_28*z_83;
    const double z_91 = c_*z_26 - z_30*r_F;
    const double z_92 = sin_theta*z_64;
    const double z_93 = r_F*z_27 - c_*z_30;
    const double z_94 = cos_theta*z_64;
    const double z_95 = ((r_R*z_63 - z_35*z_60) + (cos_theta*z_89 - z_33*z_88)) - ((sin_theta*z_90 - z_38*z_83) +
        (z_91*z_92 + z_93*z_94));
    const double z_96 = z_6*z_61;
    D[46] = -(sin_phi*(z_60*z_22*z_12 + sin_theta*cos_tilt*z_62 + z_63*z_22*z_15 + phi_dot*z_23 + z_87*z_25 + z_95
        - cos_theta*sin_tilt*z_62 - z_87*z_24) - cos_phi*(z_96 - z_22*z_64 - phi_dot*z_41 - cos_delta*z_87));
    const double z_97 = phi_dot*sin_phi;
    const double z_98 = c_*z_32;
    const double z_99 = z_97*z_22;
    const double z_100 = sin_tilt*cos_phi;
    const double z_101 = cos_phi*z_64;
    const double z_102 = z_32*r_F;
    const double z_103 = cos_tilt*cos_phi;
    D[47] = -(sin_theta*(r_R*z_97 + z_15*z_99 + z_44*z_87 - z_97*z_98 - z_97*z_29 - z_62*z_100 - theta_dot*z_47 -
        z_93*z_101) - cos_theta*(z_35*z_97 + z_62*z_103 + theta_dot*z_45 - z_97*z_37 - z_97*z_102 - z_12*z_99 -
        z_46*z_87 - z_91*z_101));
    const double z_104 = sin_tilt*z_22;
    const double z_105 = cos_tilt*z_22;
    const double z_106 = z_86 + r_F*z_73;
    const double z_107 = z_11*z_88 + c_*z_73 + r_F*z_76 - z_84;
    const double z_108 = z_14*z_88 - c_*z_76;
    D[48] = cos_delta*(z_6*z_78 + z_70*z_104 + z_73*z_104 + z_68*z_105 + delta_dot*z_54 + z_87*z_48 - z_76*z_105 -
        z_87*z_49) - sin_delta*(z_78*z_22 + delta_dot*z_50 + z_30*z_107 + z_108*z_26 - sin_phi*z_87 - z_106*z_27);
    D[54] = cos_phi*z_23 - sin_phi*z_41;
    D[55] = sin_theta*z_45 - cos_theta*z_47;
    D[56] = cos_delta*z_50 + sin_delta*z_54;
    const double z_109 = z_68 - z_76;
    D[59] = -z_109;
    const double z_110 = z_26*z_64;
    const double z_111 = delta_dot*z_15;
    const double z_112 = cos_tilt*z_111;
    const double z_113 = sin_phi*z_61 + sin_delta*z_78;
    D[60] = -(z_36*z_76 + z_32*z_73 + z_32*z_70 + z_11*z_110 + z_109 + cos_tilt*z_113 - z_36*z_68 - z_14*z_112);
    const double z_114 = delta_dot*z_12;
    const double z_115 = sin_delta*z_11;
    const double z_116 = sin_delta*z_14;
    D[61] = sin_tilt*(2.0*z_114*z_52 + z_76*z_56 + c_*z_113 + z_87*z_115 + sin_tilt*z_107 + 2.0*cos_tilt*z_106 -
        z_51*z_111 - z_11*z_62 - z_68*z_56 - z_107*z_31 - 2.0*z_108*z_58) - cos_tilt*(2.0*z_111*z_53 + z_14*z_62 +
        2.0*z_106*z_31 + cos_tilt*z_107 - z_51*z_114 - z_70*z_56 - z_73*z_56 - r_F*z_113 - z_87*z_116 - z_107*z_58
        - 2.0*sin_tilt*z_108);
    D[63] = -(z_97 - z_73 - z_70);
    const double z_117 = z_27*z_64;
    const double z_118 = z_16*z_20;
    D[64] = z_32*z_68 + z_111*z_49 + z_118*z_66 + z_118*z_69 + z_118*z_71 + z_118*z_74 + z_118*z_79 +
        sin_tilt*z_113 - z_28*z_73 - z_32*z_76 - z_28*z_70 - z_14*z_117 - z_118*z_65 - z_118*z_67 - z_118*z_77;
    const double y_dot = v[1];
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double x_dot = v[0];
    const double sin_psi = em_sin(psi);
    D[88] = y_dot*cos_psi - x_dot*sin_psi;
    D[94] = cos_psi;
    D[95] = sin_psi;
    D[98] = -r_R;
    D[100] = -r_R;
    const double spin_r_dot = v[6];
    D[106] = -(theta_dot + spin_r_dot);
    D[131] = -(x_dot*cos_psi + y_dot*sin_psi);
    D[137] = -sin_psi;
    D[138] = cos_psi;
    D[174] = y_dot*cos_psi - x_dot*sin_psi;
    const double z_121 = z_28*z_72 + z_32*z_75 - z_44;
    const double z_122 = r_F*z_19;
    const double z_123 = cos_delta*cos_phi;
    const double z_124 = z_123 + z_15*z_72 - z_12*z_75;
    const double z_125 = z_124*z_22;
    const double z_126 = z_121*z_122 - z_59*z_125;
    const double z_127 = z_36*z_75 + z_32*z_72 + z_46;
    const double z_128 = z_127*z_122 + z_55*z_125;
    const double z_129 = z_17*z_21;
    const double z_130 = z_124*z_122 + z_124*z_129;
    const double z_131 = z_32*z_126 + z_36*z_128 - z_130*z_12;
    const double psi_dot = v[2];
    const double z_132 = psi_dot*sin_theta;
    const double z_133 = z_32*z_128 + z_28*z_126 + z_130*z_15;
    const double z_134 = psi_dot*cos_theta;
    const double z_135 = psi_dot*z_11;
    const double z_136 = psi_dot*z_14;
    const double z_137 = psi_dot*sin_phi;
    const double z_138 = theta_dot + z_137;
    const double z_139 = delta_dot*cos_tilt + z_138*z_15;
    const double z_140 = z_32*z_135 + z_28*z_136 + z_139;
    const double z_141 = z_59*z_140;
    const double z_142 = delta_dot*sin_tilt - z_138*z_12;
    const double z_143 = z_36*z_135 + z_32*z_136 + z_142;
    const double z_144 = z_55*z_143;
    const double spin_f_dot = v[7];
    const double z_145 = spin_f_dot + cos_delta*z_138;
    const double z_146 = z_135*z_12 + z_145 - z_136*z_15;
    const double z_147 = z_22*z_141 + z_146*z_129 + z_146*z_122 - z_22*z_144;
    const double z_148 = z_124*z_141;
    const double z_149 = z_124*z_144;
    const double z_150 = z_121*z_140;
    const double z_151 = z_127*z_143;
    const double z_152 = z_124*z_146;
    const double z_153 = z_17*z_81;
    const double z_154 = z_21*z_148 + 2.0*z_146*z_125 + z_16*(z_82*z_148 + z_21*z_150 + z_21*z_151 + z_152*z_153 -
        z_82*z_149 - z_21*z_152) - z_21*z_149;
    const double z_155 = z_140*z_125;
    const double z_156 = cos_theta*z_28;
    const double z_157 = z_143*z_125;
    const double z_158 = sin_theta*z_36;
    const double z_159 = psi_dot*r_F;
    const double z_160 = z_140*z_122 + z_159;
    const double z_161 = psi_dot*c_;
    const double z_162 = z_143*z_122 + z_161;
    const double z_163 = psi_dot*r_R;
    const double z_164 = z_126*z_15 - (cos_delta*z_130 + z_128*z_12);
    const double z_165 = -z_164;
    D[175] = -(sin_phi*(z_131*z_132 + z_133*z_134 + z_154*z_25 + z_162*z_12 - cos_delta*z_147 - z_154*z_24 -
        z_33*z_155 - z_155*z_156 - z_38*z_157 - z_157*z_158 - z_160*z_15) - cos_phi*(z_163 + z_147*z_24 +
        z_12*z_157 + z_33*z_160 + z_160*z_156 + z_38*z_162 + z_162*z_158 - z_35*z_132 - r_R*z_134 - psi_dot*z_165
        - z_147*z_25 - cos_delta*z_154 - z_15*z_155));
    const double z_166 = theta_dot*r_R;
    const double z_167 = psi_dot*cos_phi;
    const double z_168 = sin_phi*z_147;
    const double z_169 = cos_phi*z_28;
    const double z_170 = sin_phi*z_32;
    const double z_171 = theta_dot*z_35;
    const double z_172 = z_36*cos_phi;
    D[176] = sin_theta*(r_R*z_137 + z_166 + z_15*z_168 + z_155*z_169 + z_157*z_43 - z_91*z_64 - z_90 - z_32*z_88 -
        z_133*z_167 - z_44*z_154 - sin_phi*z_28*z_160 - z_162*z_170) - cos_theta*(z_171 + z_93*z_64 + z_46*z_154 +
        z_155*z_43 + z_157*z_172 + z_35*z_137 - z_32*z_83 - z_89 - z_131*z_167 - z_12*z_168 - z_160*z_170 -
        sin_phi*z_36*z_162);
    const double z_173 = delta_dot*z_91;
    const double z_174 = delta_dot*z_93;
    const double z_175 = sin_tilt*z_138;
    const double z_176 = cos_tilt*z_138;
    const double z_177 = sin_phi*sin_tilt;
    const double z_178 = sin_phi*cos_tilt;
    const double z_179 = cos_theta*z_83 + z_126*z_136 + z_160*z_72 - z_14*z_155;
    const double z_180 = sin_theta*z_83 + cos_theta*z_88 + z_126*z_135 + z_128*z_136 + z_160*z_75 + z_162*z_72 -
        z_11*z_155 - z_14*z_157;
    const double z_181 = sin_theta*z_88 + z_128*z_135 + z_162*z_75 - z_11*z_157;
    D[177] = cos_delta*(cos_theta*z_173 + sin_tilt*z_130*z_136 + z_126*z_175 + cos_tilt*z_147*z_75 + z_154*z_48 +
        z_157*z_178 + z_162*z_103 - sin_theta*z_174 - psi_dot*z_130*z_49 - z_128*z_176 - sin_tilt*z_147*z_72 -
        z_154*z_49 - z_155*z_177 - z_160*z_100) + sin_delta*(z_130*z_138 + cos_phi*z_147 + sin_phi*z_154 +
        z_30*z_180 - z_179*z_27 - z_181*z_26);
    D[180] = cos_psi;
    D[181] = sin_psi;
    D[182] = r_R*sin_phi + c_*z_127 + r_F*z_121 + z_14*z_133 + z_11*z_131 - r_R*z_72 - z_35*z_75 - sin_phi*z_165;
    D[184] = -(-z_164 - z_40);
    const double z_182 = sin_theta*sin_delta;
    const double z_183 = cos_theta*sin_delta;
    D[185] = sin_tilt*z_128 + cos_tilt*z_126 + z_91*z_183 - z_93*z_182;
    D[187] = -z_130;
    const double z_184 = z_63 + psi_dot*z_75;
    D[188] = -z_184;
    D[189] = z_36*z_63 + theta_dot*z_38 + z_26*z_94 + sin_theta*z_112 + psi_dot*z_127 - z_184;
    const double z_185 = sin_delta*z_147;
    const double z_186 = c_*z_111;
    const double z_187 = sin_delta*z_130;
    const double z_188 = sin_delta*z_138;
    const double z_189 = cos_phi*sin_delta;
    const double z_190 = z_3 - 2.0*z_5;
    const double z_191 = r_F*z_114;
    const double z_192 = 2.0*z_3 - z_5;
    D[190] = -(sin_tilt*(z_75*z_185 + sin_theta*z_186 + delta_dot*z_126 + z_157*z_57 + z_162*z_189 +
        sin_tilt*z_180 + 2.0*z_181*z_58 + 2.0*cos_tilt*z_179 - z_135*z_187 - z_128*z_188 - z_154*z_115 -
        z_180*z_31 - z_190*z_94) + cos_tilt*(z_72*z_185 + cos_theta*z_191 + z_155*z_57 + z_160*z_189 + z_180*z_58
        + z_192*z_92 - delta_dot*z_128 - z_136*z_187 - z_126*z_188 - z_154*z_116 - 2.0*z_179*z_31 - cos_tilt*z_180
        - 2.0*sin_tilt*z_181));
    D[192] = z_137 - z_60 - psi_dot*z_72;
    const double z_193 = z_17*z_20;
    D[193] = z_28*z_60 + theta_dot*z_33 + z_19*z_150 + z_118*z_149 + z_19*z_151 + psi_dot*z_121 - z_27*z_92 -
        cos_theta*z_112 - z_118*z_148 - z_152*z_193 - z_19*z_152;
    D[217] = -(x_dot*cos_psi + y_dot*sin_psi);
    const double z_194 = phi_dot*sin_theta;
    const double z_195 = phi_dot*cos_theta;
    const double z_196 = cos_theta*z_36 - z_33;
    const double z_197 = cos_theta*z_12 + sin_theta*z_15;
    const double z_198 = z_197*z_22;
    const double z_199 = z_196*z_122 - z_55*z_198;
    const double z_200 = sin_theta*z_28 - z_38;
    const double z_201 = z_200*z_122 - z_59*z_198;
    const double z_202 = z_197*z_122 + z_197*z_129;
    const double z_203 = z_36*z_199 + z_202*z_12 - z_32*z_201;
    const double z_204 = z_28*z_201 + z_202*z_15 - z_32*z_199;
    const double z_205 = z_195 - z_135;
    const double z_206 = z_194 + z_136;
    const double z_207 = z_36*z_205 - z_32*z_206 - z_142;
    const double z_208 = z_55*z_207;
    const double z_209 = z_197*z_208;
    const double z_210 = z_28*z_206 + z_139 - z_32*z_205;
    const double z_211 = z_59*z_210;
    const double z_212 = z_197*z_211;
    const double z_213 = z_145 - z_205*z_12 - z_206*z_15;
    const double z_214 = z_196*z_207;
    const double z_215 = z_200*z_210;
    const double z_216 = z_197*z_213;
    const double z_217 = z_21*z_209 + z_21*z_212 + 2.0*z_213*z_198 + z_16*(z_82*z_209 + z_21*z_214 + z_82*z_212 +
        z_21*z_215 + z_216*z_153 - z_21*z_216);
    const double z_218 = z_210*z_198;
    const double z_219 = z_207*z_198;
    const double z_220 = z_199*z_12 - (cos_delta*z_202 - z_201*z_15);
    const double z_221 = -z_220;
    D[218] = -(sin_phi*(z_96 + z_35*z_194 + r_R*z_195 + z_204*z_134 + z_217*z_25 + z_38*z_219 + z_219*z_158 -
        phi_dot*r_R - phi_dot*z_34 - z_195*z_29 - phi_dot*z_39 - z_194*z_37 - z_203*z_132 - z_217*z_24 -
        z_33*z_218 - z_218*z_156) + cos_phi*(phi_dot*z_7 + psi_dot*z_221 + cos_delta*z_217 + z_15*z_218 +
        z_12*z_219 + z_95));
    const double z_222 = z_22*z_208 + z_22*z_211 + z_213*z_129 + z_213*z_122;
    const double z_223 = z_161 - z_207*z_122;
    const double z_224 = z_159 + z_210*z_122;
    D[219] = -(sin_theta*(r_R*z_78 + sin_phi*z_171 + z_93*z_65 + phi_dot*z_203 + z_204*z_167 + z_44*z_217 +
        z_219*z_43 + psi_dot*z_35 - z_83*z_170 - sin_phi*z_89 - z_78*z_29 - z_78*z_98 - z_222*z_12 - z_218*z_169 -
        z_36*z_223 - z_32*z_224) + cos_theta*(z_163 + sin_phi*z_166 + z_78*z_102 + z_78*z_37 + z_203*z_167 +
        z_222*z_15 + z_46*z_217 + z_218*z_43 - z_35*z_78 - sin_phi*z_90 - z_88*z_170 - z_91*z_65 - phi_dot*z_204 -
        z_219*z_172 - z_32*z_223 - z_28*z_224));
    const double z_225 = phi_dot*z_14;
    const double z_226 = z_75*z_83 + z_201*z_206 + sin_theta*z_224 - r_F*z_225 - z_14*z_218;
    const double z_227 = phi_dot*z_11;
    const double z_228 = z_75*z_88 + z_14*z_219 + sin_theta*z_223 - c_*z_225 - z_72*z_83 - r_F*z_227 - z_201*z_205
        - z_199*z_206 - z_11*z_218 - cos_theta*z_224;
    const double z_229 = z_72*z_88 + c_*z_227 + cos_theta*z_223 - z_199*z_205 - z_11*z_219;
    D[220] = cos_delta*(z_75*z_173 + z_72*z_174 + cos_tilt*z_202*z_205 + sin_tilt*z_202*z_206 + z_199*z_176 +
        z_201*z_175 + z_217*z_48 - z_6*z_97 - sin_theta*sin_tilt*z_222 - cos_theta*cos_tilt*z_222 - z_217*z_49 -
        z_218*z_177 - z_219*z_178) - sin_delta*(delta_dot*cos_phi*z_6 + z_226*z_27 - z_202*z_138 - sin_phi*z_217 -
        z_30*z_228 - z_229*z_26);
    D[223] = -sin_psi;
    D[224] = cos_psi;
    D[225] = r_F*z_200 + cos_theta*z_35 + z_14*z_204 - c_*z_196 - r_R*sin_theta - sin_phi*z_221 - z_11*z_203;
    D[226] = -(z_42 + z_6*z_57 + z_11*z_37 + z_14*z_98 + z_14*z_29 + z_11*z_102 - sin_theta*z_204 -
        cos_theta*z_203 - r_R*z_14 - z_35*z_11);
    D[227] = -(r_R*z_75 + z_72*z_37 + z_72*z_102 - z_35*z_72 - z_75*z_98 - z_75*z_29 - z_220);
    D[228] = cos_tilt*z_201 + z_6*z_123 + sin_delta*z_93*z_72 + sin_delta*z_91*z_75 - sin_tilt*z_199;
    D[230] = -z_202;
    const double z_230 = theta_dot*z_72;
    const double z_231 = z_227 + z_230 + z_134;
    D[231] = z_231;
    const double z_232 = theta_dot*z_75;
    const double z_233 = cos_phi*z_61 - sin_delta*z_97;
    D[232] = -(z_36*z_227 + z_32*z_225 + z_36*z_230 + z_72*z_112 + cos_tilt*z_233 + psi_dot*z_196 - z_32*z_232 -
        z_75*z_110 - z_231);
    const double z_234 = sin_delta*z_202;
    D[233] = sin_tilt*(z_222*z_183 + z_72*z_186 + c_*z_233 + z_217*z_115 + z_219*z_57 + z_228*z_31 +
        2.0*z_229*z_58 + z_190*z_75*z_64 - delta_dot*z_201 - z_205*z_234 - z_199*z_188 - sin_tilt*z_228 -
        2.0*cos_tilt*z_226) - cos_tilt*(z_222*z_182 + delta_dot*z_199 + z_75*z_191 + z_218*z_57 + z_228*z_58 +
        2.0*sin_tilt*z_229 - z_206*z_234 - z_201*z_188 - r_F*z_233 - z_217*z_116 - 2.0*z_226*z_31 - cos_tilt*z_228
        - z_192*z_72*z_64);
    D[235] = -(z_78 + z_232 + z_132 - z_225);
    D[236] = z_28*z_232 + z_72*z_117 + z_19*z_214 + z_19*z_215 + sin_tilt*z_233 + psi_dot*z_200 - z_28*z_225 -
        z_32*z_227 - z_32*z_230 - z_75*z_112 - z_118*z_209 - z_118*z_212 - z_216*z_193 - z_19*z_216;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes bicycle_lanes;
EM_WEAK em_lanes bicycle_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0, 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 16, 80, 0, 64 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double m_B = parameters[7];
    const double m_R = parameters[6];
    const double m_F = parameters[9];
    const double m_H = parameters[8];
    const double z_0 = m_F + m_H;
    const double z_1 = m_B + m_R + z_0;
    prepared[26] = z_1; /* c_0 */
    const double r_R = parameters[4];
    const double z_B = parameters[11];
    const double z_2 = r_R - z_B;
    prepared[27] = z_2; /* c_1 */
    const double c_ = parameters[1];
    const double w = parameters[0];
    const double z_3 = c_ + w;
    prepared[28] = z_3; /* c_2 */
    const double tilt = parameters[2];
    const double sin_tilt = em_sin(tilt);
    const double z_5 = sin_tilt*sin_tilt;
    const double z_6 = z_5;
    prepared[29] = z_6; /* c_3 */
    const double cos_tilt = em_cos(tilt);
    const double z_8 = cos_tilt*cos_tilt;
    const double z_9 = z_8;
    prepared[30] = z_9; /* c_4 */
    const double z_10 = sin_tilt*cos_tilt;
    prepared[31] = z_10; /* c_5 */
    prepared[32] = cos_tilt; /* c_6 */
    prepared[33] = sin_tilt; /* c_7 */
    const double x_H = parameters[12];
    const double z_11 = z_3 - x_H;
    prepared[34] = z_11; /* c_8 */
    const double z_12 = m_R*r_R;
    prepared[35] = z_12; /* c_9 */
    const double H_xx = parameters[22];
    const double F_xx = parameters[16];
    const double z_13 = H_xx + 2.0*F_xx;
    prepared[36] = H_xx + z_13; /* c_10 */
    const double H_xz = parameters[25];
    prepared[37] = 2.0*H_xz; /* c_11 */
    const double H_zz = parameters[24];
    const double z_14 = 2.0*F_xx + H_zz;
    prepared[38] = H_zz + z_14; /* c_12 */
    const double F_yy = parameters[17];
    const double H_yy = parameters[23];
    const double z_15 = F_yy + H_yy;
    prepared[39] = 2.0*z_15; /* c_13 */
    const double B_yy = parameters[19];
    const double R_yy = parameters[15];
    const double z_16 = B_yy + R_yy;
    prepared[40] = 2.0*z_16; /* c_14 */
    const double B_xx = parameters[18];
    const double R_xx = parameters[14];
    const double z_17 = B_xx + 2.0*R_xx;
    prepared[41] = B_xx + z_17; /* c_15 */
    const double B_xz = parameters[21];
    prepared[42] = 2.0*B_xz; /* c_16 */
    const double z_18 = cos_tilt*z_15;
    prepared[43] = 2.0*z_18; /* c_17 */
    const double B_zz = parameters[20];
    const double z_19 = 2.0*R_xx + B_zz;
    prepared[44] = B_zz + z_19; /* c_18 */
    const double z_20 = sin_tilt*z_15;
    prepared[45] = 2.0*z_20; /* c_19 */
    prepared[46] = 2.0*m_B; /* c_20 */
    prepared[47] = 2.0*m_F; /* c_21 */
    prepared[48] = 2.0*m_H; /* c_22 */
    const double z_21 = m_R*(r_R*r_R);
    prepared[49] = 2.0*z_21; /* c_23 */
    prepared[50] = z_1*r_R; /* c_24 */
    const double x_B = parameters[10];
    const double z_22 = m_B*x_B;
    prepared[51] = z_22 + z_3*z_0; /* c_25 */
    const double z_23 = m_B*z_2;
    prepared[52] = z_23 + r_R*z_0; /* c_26 */
    const double z_24 = m_F*c_;
    const double z_25 = m_H*z_11;
    const double z_26 = z_24 + z_25;
    const double r_F = parameters[5];
    const double z_27 = m_F*r_F;
    const double z_H = parameters[13];
    const double z_28 = m_H*z_H;
    const double z_29 = z_27 + z_28;
    prepared[53] = cos_tilt*z_26 - sin_tilt*z_29; /* c_27 */
    prepared[54] = z_29; /* c_28 */
    prepared[55] = z_26; /* c_29 */
    prepared[56] = z_27; /* c_30 */
    prepared[57] = z_28; /* c_31 */
    prepared[58] = z_24; /* c_32 */
    prepared[59] = z_25; /* c_33 */
    prepared[60] = 2.0*r_R; /* c_34 */
    prepared[61] = 2.0*z_3; /* c_35 */
    prepared[62] = 2.0*cos_tilt; /* c_36 */
    prepared[63] = 2.0*sin_tilt; /* c_37 */
    prepared[64] = 2.0*z_22; /* c_38 */
    prepared[65] = 2.0*z_23; /* c_39 */
    const double z_30 = sin_tilt*r_F;
    const double z_31 = z_30 - c_*cos_tilt;
    const double z_32 = sin_tilt*z_H - cos_tilt*z_11;
    const double z_33 = z_24*z_31 + z_25*z_32;
    const double z_34 = z_27*z_31 + z_28*z_32;
    const double z_35 = cos_tilt*z_33 - sin_tilt*z_34;
    prepared[66] = 2.0*z_35; /* c_40 */
    const double z_36 = m_F*z_31 + m_H*z_32;
    const double z_37 = r_R*z_36;
    prepared[67] = 2.0*z_37; /* c_41 */
    prepared[68] = 2.0*z_33; /* c_42 */
    prepared[69] = 2.0*z_34; /* c_43 */
    const double z_38 = z_3*z_36;
    prepared[70] = 2.0*z_38; /* c_44 */
    const double z_39 = sin_tilt*H_xz;
    const double z_40 = cos_tilt*H_xx + cos_tilt*z_13 - 2.0*z_39;
    const double z_41 = cos_tilt*H_xz;
    const double z_42 = sin_tilt*H_zz + sin_tilt*z_14 - 2.0*z_41;
    const double z_43 = cos_tilt*z_40 + sin_tilt*z_42;
    prepared[71] = z_43; /* c_45 */
    prepared[72] = 2.0*(z_16 + m_B*(x_B*x_B) + m_B*(z_2*z_2)); /* c_46 */
    const double z_44 = z_26*z_8;
    const double z_45 = z_10*z_29;
    prepared[73] = z_44 - z_45; /* c_47 */
    const double z_46 = z_29*z_5;
    const double z_47 = z_10*z_26;
    prepared[74] = z_46 - z_47; /* c_48 */
    prepared[75] = 2.0*z_9; /* c_49 */
    prepared[76] = 2.0*z_6; /* c_50 */
    prepared[77] = 2.0*z_10; /* c_51 */
    const double z_48 = z_34*z_5;
    const double z_49 = z_10*z_33;
    const double z_50 = z_48 - z_49;
    prepared[78] = 2.0*z_50; /* c_52 */
    const double z_51 = z_33*z_8;
    const double z_52 = z_10*z_34;
    const double z_53 = z_51 - z_52;
    prepared[79] = 2.0*z_53; /* c_53 */
    prepared[80] = sin_tilt*z_40 - cos_tilt*z_42; /* c_54 */
    const double z_54 = 2.0*z_35 - sin_tilt*(2.0*z_41 + sin_tilt*H_xx + sin_tilt*z_13) - cos_tilt*(2.0*z_39 +
        cos_tilt*H_zz + cos_tilt*z_14);
    prepared[81] = (-0.5)*z_54; /* c_55 */
    prepared[82] = z_15; /* c_56 */
    prepared[83] = z_18; /* c_57 */
    prepared[84] = z_20; /* c_58 */
    prepared[85] = 4.0*m_B; /* c_59 */
    prepared[86] = 4.0*m_F; /* c_60 */
    prepared[87] = 4.0*m_H; /* c_61 */
    prepared[88] = 4.0*z_21; /* c_62 */
    prepared[89] = z_46; /* c_63 */
    prepared[90] = z_44; /* c_64 */
    prepared[91] = z_47; /* c_65 */
    prepared[92] = z_45; /* c_66 */
    prepared[93] = z_22; /* c_67 */
    prepared[94] = z_23; /* c_68 */
    prepared[95] = 4.0*z_35; /* c_69 */
    prepared[96] = z_37; /* c_70 */
    prepared[97] = z_33; /* c_71 */
    prepared[98] = z_51; /* c_72 */
    prepared[99] = z_34; /* c_73 */
    prepared[100] = z_52; /* c_74 */
    prepared[101] = z_38; /* c_75 */
    prepared[102] = z_48; /* c_76 */
    prepared[103] = z_49; /* c_77 */
    const double z_55 = r_F*z_5;
    const double z_56 = c_*z_10;
    const double z_57 = z_55 - z_56;
    const double z_58 = z_H*z_5 - z_10*z_11;
    const double z_59 = z_27*z_57 + z_28*z_58;
    prepared[104] = z_59; /* c_78 */
    const double z_60 = c_*z_8;
    const double z_61 = z_10*r_F;
    const double z_62 = z_60 - z_61;
    const double z_63 = z_10*z_H - z_11*z_8;
    const double z_64 = z_24*z_62 - z_25*z_63;
    prepared[105] = z_64; /* c_79 */
    const double z_65 = z_24*z_57 + z_25*z_58;
    prepared[106] = z_65; /* c_80 */
    const double z_66 = z_27*z_62 - z_28*z_63;
    prepared[107] = z_66; /* c_81 */
    prepared[108] = r_R*(m_F*z_57 + m_H*z_58) + z_3*(m_F*z_62 - m_H*z_63); /* c_82 */
    prepared[109] = 2.0*z_15 - z_43; /* c_83 */
    prepared[110] = z_50; /* c_84 */
    prepared[111] = z_53; /* c_85 */
    prepared[112] = z_66*z_5; /* c_86 */
    prepared[113] = z_65*z_8; /* c_87 */
    prepared[114] = z_10*z_59; /* c_88 */
    prepared[115] = z_10*z_64; /* c_89 */
    prepared[116] = z_13; /* c_90 */
    prepared[117] = z_14; /* c_91 */
    prepared[118] = z_17; /* c_92 */
    prepared[119] = z_19; /* c_93 */
    const double g = parameters[3];
    const double z_67 = m_B*g;
    const double z_68 = m_H*g + m_F*g;
    prepared[120] = (-2.0)*(z_12*g + r_R*(z_67 + z_68)); /* c_94 */
    const double z_69 = z_28*g + z_27*g;
    prepared[121] = 2.0*z_69; /* c_95 */
    const double z_70 = z_25*g + z_24*g;
    prepared[122] = 2.0*z_70; /* c_96 */
    prepared[123] = 2.0*(z_2*z_67 + r_R*z_68); /* c_97 */
    prepared[124] = 2.0*(x_B*z_67 + z_3*z_68); /* c_98 */
    prepared[125] = 2.0*B_yy; /* c_99 */
    prepared[126] = 2.0*R_yy; /* c_100 */
    prepared[127] = 2.0*z_12; /* c_101 */
    prepared[128] = 2.0*(sin_tilt*z_69 - cos_tilt*z_70); /* c_102 */
    prepared[129] = z_31; /* c_103 */
    prepared[130] = cos_tilt*r_F; /* c_104 */
    prepared[131] = z_30; /* c_105 */
    prepared[132] = z_60; /* c_106 */
    prepared[133] = z_55; /* c_107 */
    prepared[134] = -r_R; /* c_108 */
    prepared[135] = z_57; /* c_109 */
    prepared[136] = z_62; /* c_110 */
    prepared[137] = z_61; /* c_111 */
    prepared[138] = z_56; /* c_112 */
    prepared[139] = 2.0*fabs(r_R); /* c_113 */
    const double z_71 = fabs(cos_tilt);
    const double z_72 = z_71 + fabs(tilt*sin_tilt);
    prepared[140] = 2.0*(z_71*z_72); /* c_114 */
    const double z_73 = fabs(sin_tilt);
    const double z_74 = z_73 + fabs(tilt*cos_tilt);
    prepared[141] = z_74*z_71 + z_73*z_72; /* c_115 */
    prepared[142] = fabs(z_10); /* c_116 */
    prepared[143] = 2.0*fabs(r_F); /* c_117 */
    prepared[144] = 2.0*(z_73*z_74); /* c_118 */
    prepared[145] = 2.0*fabs(c_); /* c_119 */
    prepared[146] = 2.0*F_yy; /* c_120 */
    prepared[147] = z_54; /* c_121 */
    prepared[148] = 2.0*x_B; /* c_122 */
    prepared[149] = 4.0*z_3; /* c_123 */
    prepared[150] = 4.0*r_R; /* c_124 */
    prepared[151] = 5.0*z_H; /* c_125 */
    prepared[152] = 4.0*z_11; /* c_126 */
    prepared[153] = (1.0/3.0)*r_R; /* c_127 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
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
    const double c_0 = c[26];
    M[0] = c_0;
    M[8] = M[1] = 0.0;
    M[9] = c_0;
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double m_B = c[7];
    const double r_R = c[4];
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double z_2 = r_R*sin_phi;
    const double x_B = c[10];
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double z_4 = sin_phi*sin_theta;
    const double c_1 = c[27];
    const double cos_theta = em_cos(theta);
    const double z_6 = sin_phi*cos_theta;
    const double z_7 = z_2 - x_B*z_4 - c_1*z_6;
    const double z_8 = m_B*z_7;
    const double m_F = c[9];
    const double c_ = c[1];
    const double c_3 = c[29];
    const double c_4 = c[30];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_10 = c_3 + c_4*cos_delta;
    const double c_5 = c[31];
    const double z_11 = c_5 - cos_delta*c_5;
    const double cos_phi = em_cos(phi);
    const double c_6 = c[32];
    const double sin_delta = em_sin(delta);
    const double z_14 = c_6*sin_delta;
    const double z_15 = z_10*z_4 + z_11*z_6 + cos_phi*z_14;
    const double r_F = c[5];
    const double z_16 = c_4 + c_3*cos_delta;
    const double c_7 = c[33];
    const double z_17 = c_7*sin_delta;
    const double z_18 = z_16*z_6 + z_11*z_4 - cos_phi*z_17;
    const double c_2 = c[28];
    const double z_19 = c_2*z_4 - (z_2 - r_R*z_6);
    const double z_20 = c_*z_15 + r_F*z_18 - z_19;
    const double z_21 = m_F*z_20;
    const double m_H = c[8];
    const double z_H = c[13];
    const double c_8 = c[34];
    const double z_22 = z_18*z_H + z_15*c_8 - z_19;
    const double z_23 = m_H*z_22;
    const double sin_psi = em_sin(psi);
    const double z_25 = x_B*cos_theta - sin_theta*c_1;
    const double z_26 = m_B*z_25;
    const double z_27 = cos_theta*z_11;
    const double z_28 = sin_theta*z_16 - z_27;
    const double z_29 = sin_theta*z_11;
    const double z_30 = cos_theta*z_10 - z_29;
    const double z_31 = cos_theta*c_2 - r_R*sin_theta;
    const double z_32 = r_F*z_28 + z_31 - c_*z_30;
    const double z_33 = m_F*z_32;
    const double z_34 = z_H*z_28 + z_31 - c_8*z_30;
    const double z_35 = m_H*z_34;
    const double c_9 = c[35];
    const double z_36 = sin_phi*c_9;
    M[16] = M[2] = cos_psi*z_8 + cos_psi*z_21 + cos_psi*z_23 + cos_psi*z_36 - sin_psi*z_26 - sin_psi*z_33 -
        sin_psi*z_35;
    M[17] = M[10] = cos_psi*z_26 + sin_psi*z_8 + cos_psi*z_33 + sin_psi*z_21 + cos_psi*z_35 + sin_psi*z_23 +
        sin_psi*z_36;
    const double z_37 = sin_phi*sin_delta;
    const double z_38 = sin_theta*cos_phi;
    const double z_39 = cos_theta*cos_phi;
    const double z_40 = c_6*z_37 - z_10*z_38 - z_11*z_39;
    const double c_10 = c[36];
    const double z_41 = z_16*z_39 + z_11*z_38 + c_7*z_37;
    const double c_11 = c[37];
    const double z_42 = z_41*c_11 - z_40*c_10;
    const double c_12 = c[38];
    const double z_43 = z_40*c_11 - z_41*c_12;
    const double z_44 = sin_phi*cos_delta + z_38*z_14 - z_39*z_17;
    const double c_13 = c[39];
    const double z_45 = cos_delta*c_13;
    const double c_14 = c[40];
    const double z_46 = (z_42*z_14 + z_43*z_17) - (z_44*z_45 + sin_phi*c_14);
    const double c_15 = c[41];
    const double c_16 = c[42];
    const double c_17 = c[43];
    const double z_47 = sin_delta*z_44;
    const double z_48 = z_10*z_42 + c_15*z_38 + c_16*z_39 + c_17*z_47 - z_11*z_43;
    const double c_18 = c[44];
    const double c_19 = c[45];
    const double z_49 = z_11*z_42 + c_18*z_39 + c_16*z_38 - z_16*z_43 - c_19*z_47;
    const double c_20 = c[46];
    const double c_21 = c[47];
    const double c_22 = c[48];
    const double c_23 = c[49];
    M[18] = 0.5*(z_48*z_38 + z_49*z_39 + c_20*(z_25*z_25) + c_20*(z_7*z_7) + c_21*(z_32*z_32) + c_21*(z_20*z_20) +
        c_22*(z_34*z_34) + c_22*(z_22*z_22) + c_23*(sin_phi*sin_phi) - sin_phi*z_46);
    const double c_24 = c[50];
    const double z_50 = cos_phi*c_24;
    const double c_25 = c[51];
    const double z_51 = sin_psi*c_25;
    const double c_26 = c[52];
    const double z_52 = sin_psi*c_26;
    const double c_27 = c[53];
    const double z_53 = sin_psi*c_27;
    const double c_28 = c[54];
    const double z_54 = z_16*c_28;
    const double z_55 = sin_psi*z_54;
    const double c_29 = c[55];
    const double z_56 = z_10*c_29;
    const double z_57 = sin_psi*z_56;
    const double z_58 = z_11*sin_psi;
    const double z_59 = c_29*z_58;
    const double z_60 = c_28*z_58;
    M[24] = M[3] = sin_psi*z_50 + z_39*z_55 + z_38*z_57 + z_39*z_59 + z_38*z_60 - z_38*z_51 - z_39*z_52 -
        z_37*z_53;
    const double z_61 = cos_psi*c_25;
    const double z_62 = cos_psi*c_26;
    const double z_63 = cos_psi*c_27;
    const double z_64 = cos_psi*z_54;
    const double z_65 = cos_psi*z_56;
    const double z_66 = cos_psi*z_11;
    const double z_67 = c_29*z_66;
    const double z_68 = c_28*z_66;
    M[25] = M[11] = z_38*z_61 + z_39*z_62 + z_37*z_63 - cos_psi*z_50 - z_39*z_64 - z_38*z_65 - z_39*z_67 -
        z_38*z_68;
    const double c_30 = c[56];
    const double c_31 = c[57];
    const double z_69 = z_32*c_30 + z_34*c_31;
    const double z_70 = z_16*z_69;
    const double c_32 = c[58];
    const double c_33 = c[59];
    const double z_71 = z_32*c_32 + z_34*c_33;
    const double z_72 = z_10*z_71;
    const double z_73 = z_11*z_71;
    const double z_74 = z_11*z_69;
    const double c_34 = c[60];
    const double z_75 = z_33 + z_35;
    const double z_76 = z_75*c_34;
    const double c_35 = c[61];
    const double z_77 = z_75*c_35;
    const double c_36 = c[62];
    const double z_78 = z_71*c_36;
    const double c_37 = c[63];
    const double z_79 = z_69*c_37;
    const double c_38 = c[64];
    const double z_80 = z_25*c_38;
    const double c_39 = c[65];
    const double z_81 = z_25*c_39;
    M[26] = M[19] = 0.5*(sin_theta*z_49 + z_39*z_76 + z_38*z_77 + z_37*z_78 + z_38*z_80 + z_39*z_81 -
        cos_theta*z_48 - 2.0*z_39*z_70 - 2.0*z_38*z_72 - 2.0*z_39*z_73 - 2.0*z_38*z_74 - c_34*(cos_phi*(z_26 +
        z_75)) - z_37*z_79);
    const double z_82 = z_30*c_11 - z_28*c_12;
    const double z_83 = z_28*c_11 - z_30*c_10;
    const double z_84 = cos_theta*sin_delta;
    const double z_85 = sin_theta*sin_delta;
    const double z_86 = c_6*z_84 + c_7*z_85;
    const double z_87 = sin_delta*z_86;
    const double z_88 = cos_theta*z_16;
    const double z_89 = sin_theta*z_10;
    const double z_90 = z_27 + z_89;
    const double z_91 = z_29 + z_88;
    const double z_92 = sin_theta*c_2 - (r_R - r_R*cos_theta);
    const double z_93 = c_*z_90 + r_F*z_91 - z_92;
    const double z_94 = z_H*z_91 + c_8*z_90 - z_92;
    const double z_95 = c_30*z_93 + c_31*z_94;
    const double z_96 = c_32*z_93 + c_33*z_94;
    const double z_97 = r_R - x_B*sin_theta - c_1*cos_theta;
    const double z_98 = m_F*z_93 + m_H*z_94;
    const double c_40 = c[66];
    const double z_99 = sin_delta*sin_delta;
    const double z_100 = cos_theta*c_34;
    const double z_101 = sin_theta*c_35;
    M[27] = 0.5*(2.0*z_88*z_95 + 2.0*z_89*z_96 + 2.0*z_27*z_96 + 2.0*z_29*z_95 + (c_9 + m_B*z_97 + z_98)*c_34 -
        sin_theta*(z_16*z_82 + cos_theta*c_16 - z_11*z_83 - sin_theta*c_18 - c_19*z_87) - cos_theta*(z_10*z_83 +
        sin_theta*c_16 - z_11*z_82 - cos_theta*c_15 - c_17*z_87) - c_40*z_99 - z_98*z_100 - z_98*z_101 -
        c_38*(sin_theta*z_97) - c_39*(cos_theta*z_97));
    M[32] = M[4] = -(sin_theta*z_61 + cos_theta*z_62 + z_6*z_51 + z_4*z_55 + z_4*z_59 - cos_theta*z_64 -
        sin_theta*z_65 - cos_theta*z_67 - z_4*z_52 - sin_theta*z_68 - z_6*z_57 - z_6*z_60);
    M[33] = M[12] = -(sin_theta*z_51 + cos_theta*z_52 + z_4*z_62 + z_6*z_65 + z_6*z_68 - cos_theta*z_55 -
        sin_theta*z_57 - cos_theta*z_59 - z_6*z_61 - sin_theta*z_60 - z_4*z_64 - z_4*z_67);
    const double z_102 = z_20*c_30 + z_22*c_31;
    const double z_103 = z_20*c_32 + z_22*c_33;
    const double z_104 = z_21 + z_23;
    M[34] = M[20] = (-0.5)*(z_46 + 2.0*z_6*z_72 + 2.0*z_6*z_74 + z_104*z_100 + z_104*z_101 + c_38*(sin_theta*z_7)
        + c_39*(cos_theta*z_7) + z_4*z_76 + z_4*z_81 - 2.0*z_102*z_88 - 2.0*z_103*z_89 - 2.0*z_27*z_103 -
        2.0*z_29*z_102 - 2.0*z_4*z_70 - 2.0*z_4*z_73 - z_6*z_77 - z_6*z_80);
    const double c_41 = c[67];
    const double c_42 = c[68];
    const double c_43 = c[69];
    const double c_44 = c[70];
    M[35] = M[28] = (-0.5)*(z_83*z_14 + z_82*z_17 + z_86*z_45 + c_44*z_84 + c_43*(z_16*z_85) + c_42*(z_11*z_85) -
        c_41*z_85 - c_42*(z_10*z_84) - c_43*(z_11*z_84));
    const double z_105 = r_R - c_*z_11 - r_F*z_16;
    const double z_106 = r_R - z_16*z_H - z_11*c_8;
    const double z_107 = c_30*z_105 + c_31*z_106;
    const double z_108 = c_2 - c_*z_10 - z_11*r_F;
    const double z_109 = c_2 - z_11*z_H - z_10*c_8;
    const double z_110 = c_32*z_108 + c_33*z_109;
    const double z_111 = c_32*z_105 + c_33*z_106;
    const double z_112 = c_30*z_108 + c_31*z_109;
    const double c_45 = c[71];
    const double c_46 = c[72];
    M[36] = 0.5*(c_45*z_99 + c_46 + (m_F*z_105 + m_H*z_106)*c_34 + c_13*(cos_delta*cos_delta) + (m_F*z_108 +
        m_H*z_109)*c_35 - 2.0*z_16*z_107 - 2.0*z_10*z_110 - 2.0*z_11*z_111 - 2.0*z_11*z_112);
    const double c_47 = c[73];
    const double z_113 = cos_psi*c_47;
    const double z_114 = cos_delta*cos_phi;
    const double c_48 = c[74];
    const double z_115 = cos_psi*c_48;
    const double z_116 = sin_delta*z_6;
    const double z_117 = sin_psi*c_48;
    const double z_118 = sin_delta*z_4;
    const double z_119 = sin_psi*c_47;
    M[40] = M[5] = z_84*z_113 + z_114*z_53 - z_85*z_115 - z_116*z_117 - z_118*z_119;
    M[41] = M[13] = z_84*z_119 + z_118*z_113 + z_116*z_115 - z_85*z_117 - z_114*z_63;
    const double c_49 = c[75];
    const double c_50 = c[76];
    const double c_51 = c[77];
    M[42] = M[21] = 0.5*(c_7*z_42 + c_49*(z_103*z_84) + z_114*z_79 + c_49*(z_71*z_118) + c_50*(z_69*z_116) +
        c_51*(z_103*z_85) - c_6*z_43 - c_50*(z_102*z_85) - z_114*z_78 - c_51*(z_102*z_84) - c_51*(z_71*z_116) -
        c_51*(z_69*z_118));
    const double c_52 = c[78];
    const double c_53 = c[79];
    M[43] = M[29] = 0.5*(c_7*z_83 + c_36*(cos_delta*z_96) - c_6*z_82 - c_52*(cos_theta*z_99) -
        c_53*(sin_theta*z_99) - c_37*(cos_delta*z_95));
    const double c_54 = c[80];
    const double z_120 = sin_delta*c_51;
    M[44] = M[37] = (-0.5)*(sin_delta*c_54 + c_49*(sin_delta*z_111) + z_110*z_120 - c_50*(sin_delta*z_112) -
        z_107*z_120);
    const double c_55 = c[81];
    M[45] = c_55;
    M[48] = M[6] = 0.0;
    M[49] = M[14] = 0.0;
    const double R_yy = c[15];
    M[50] = M[22] = sin_phi*R_yy;
    M[51] = M[30] = 0.0;
    M[52] = M[38] = R_yy;
    M[53] = M[46] = 0.0;
    M[54] = R_yy;
    M[56] = M[7] = 0.0;
    M[57] = M[15] = 0.0;
    const double F_yy = c[17];
    M[58] = M[23] = F_yy*z_44;
    M[59] = M[31] = -F_yy*z_86;
    M[60] = M[39] = cos_delta*F_yy;
    M[61] = M[47] = 0.0;
    M[62] = M[55] = 0.0;
    M[63] = F_yy;
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
    A[0] = 0.0;
    A[1] = 0.0;
    A[2] = 0.0;
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double delta = x[5];
    const double sin_delta = em_sin(delta);
    const double c_103 = c[129];
    const double cos_delta = em_cos(delta);
    const double r_F = c[5];
    const double sin_phi = em_sin(phi);
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double z_5 = sin_theta*cos_phi;
    const double c_6 = c[32];
    const double z_6 = c_6*sin_delta;
    const double cos_theta = em_cos(theta);
    const double z_8 = cos_theta*cos_phi;
    const double c_7 = c[33];
    const double z_9 = c_7*sin_delta;
    const double z_10 = sin_phi*cos_delta + z_5*z_6 - z_8*z_9;
    const double z_11 = z_10*z_10;
    const double z_12 = sqrt(1.0 - z_11);
    const double z_13 = 1.0/z_12;
    const double z_14 = z_10*z_13;
    const double z_15 = r_F*z_14;
    const double r_R = c[4];
    const double c_104 = c[130];
    const double z_16 = sin_delta*z_14;
    const double c_105 = c[131];
    const double c_4 = c[30];
    const double c_3 = c[29];
    const double z_17 = c_4 + c_3*cos_delta;
    const double z_18 = r_F*z_17;
    const double c_5 = c[31];
    const double z_19 = c_5 - cos_delta*c_5;
    const double z_20 = z_19*r_F;
    const double c_2 = c[28];
    const double c_ = c[1];
    const double z_21 = c_3 + c_4*cos_delta;
    const double z_22 = c_*z_21;
    const double z_23 = c_*z_19;
    const double z_24 = (cos_theta*z_18 + sin_theta*z_20) - ((r_R*cos_theta + sin_theta*c_2) - (sin_theta*z_22 +
        cos_theta*z_23));
    A[3] = cos_phi*(sin_delta*c_103 + cos_delta*z_15) - sin_phi*(r_R + sin_theta*c_104*z_16 + z_24 -
        cos_theta*c_105*z_16);
    const double z_25 = r_R*cos_phi;
    const double z_26 = cos_phi*z_16;
    A[4] = sin_theta*(z_25 + c_105*z_26 - cos_phi*z_23 - cos_phi*z_18) - cos_theta*(cos_phi*c_2 - cos_phi*z_22 -
        cos_phi*z_20 - c_104*z_26);
    const double z_27 = sin_phi*c_103;
    const double c_106 = c[132];
    const double c_107 = c[133];
    A[5] = cos_delta*(z_27 + c_104*z_14*z_5 - c_105*z_14*z_8) + sin_delta*(c_5*(c_*z_8 + r_F*z_5) - c_106*z_5 -
        sin_phi*z_15 - c_107*z_8);
    A[6] = 0.0;
    A[7] = 0.0;
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    A[8] = cos_psi;
    const double sin_psi = em_sin(psi);
    A[9] = sin_psi;
    A[10] = 0.0;
    A[11] = 0.0;
    const double c_108 = c[134];
    A[12] = c_108;
    A[13] = 0.0;
    A[14] = c_108;
    A[15] = 0.0;
    A[16] = -sin_psi;
    A[17] = cos_psi;
    A[18] = 0.0;
    A[19] = 0.0;
    A[20] = 0.0;
    A[21] = 0.0;
    A[22] = 0.0;
    A[23] = 0.0;
    A[24] = cos_psi;
    A[25] = sin_psi;
    const double z_30 = sin_phi*sin_theta;
    const double z_31 = sin_phi*cos_theta;
    const double z_32 = z_21*z_30 + z_19*z_31 + cos_phi*z_6;
    const double z_33 = z_17*z_31 + z_19*z_30 - cos_phi*z_9;
    const double z_34 = z_17*z_8 + z_19*z_5 + sin_phi*z_9;
    const double z_35 = cos_delta*cos_phi;
    const double z_36 = z_35 + z_9*z_31 - z_6*z_30;
    const double z_37 = r_F*(z_33*z_12 - z_14*(z_34*z_36));
    const double z_38 = z_11*z_13;
    const double z_39 = r_F*(z_36*z_12 + z_36*z_38);
    const double z_40 = sin_phi*z_6 - z_21*z_5 - z_19*z_8;
    const double z_41 = r_F*(z_32*z_12 + z_14*(z_40*z_36));
    const double z_42 = z_37*z_9 - (cos_delta*z_39 + z_41*z_6);
    A[26] = r_R*sin_phi + c_*z_32 + r_F*z_33 + (z_19*z_41 + z_17*z_37 + z_39*z_9)*z_8 + (z_19*z_37 + z_21*z_41 -
        z_39*z_6)*z_5 - r_R*z_31 - c_2*z_30 - sin_phi*(-z_42);
    A[27] = 0.0;
    A[28] = -(-z_42 - z_24);
    const double c_109 = c[135];
    const double z_43 = sin_delta*c_109;
    const double c_110 = c[136];
    const double z_44 = sin_delta*c_110;
    A[29] = c_7*z_41 + c_6*z_37 + cos_theta*z_44 - sin_theta*z_43;
    A[30] = 0.0;
    A[31] = -z_39;
    A[32] = -sin_psi;
    A[33] = cos_psi;
    const double z_45 = sin_theta*z_17 - cos_theta*z_19;
    const double z_46 = cos_theta*z_21 - sin_theta*z_19;
    const double z_47 = cos_theta*z_6 + sin_theta*z_9;
    const double z_48 = r_F*(z_46*z_12 - z_14*(z_40*z_47));
    const double z_49 = r_F*(z_47*z_12 + z_47*z_38);
    const double z_50 = r_F*(z_45*z_12 - z_14*(z_34*z_47));
    const double z_51 = z_48*z_6 - (cos_delta*z_49 - z_50*z_9);
    const double z_52 = z_17*z_50 + z_49*z_9 - z_19*z_48;
    const double z_53 = z_21*z_48 + z_49*z_6 - z_19*z_50;
    A[34] = r_F*z_45 + cos_theta*c_2 + z_52*z_8 - c_*z_46 - r_R*sin_theta - sin_phi*(-z_51) - z_53*z_5;
    A[35] = -(z_25 + sin_delta*z_27 + z_5*z_22 + z_8*z_23 + z_8*z_18 + z_5*z_20 - sin_theta*z_52 - cos_theta*z_53
        - r_R*z_8 - c_2*z_5);
    A[36] = -(r_R*z_30 + z_31*z_22 + z_31*z_20 - c_2*z_31 - z_30*z_23 - z_30*z_18 - z_51);
    A[37] = c_6*z_50 + c_103*z_35 + z_31*z_43 + z_30*z_44 - c_7*z_48;
    A[38] = 0.0;
    A[39] = -z_49;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    b[4] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
EM_ACROSS void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
    const double r_R = c[4];
    const double phi_ = x[3];
    const double cos_phi_ = em_cos(phi_);
    const double z_1 = r_R*cos_phi_;
    const double theta = x[4];
    const double cos_theta = em_cos(theta);
    const double z_3 = cos_theta*cos_phi_;
    const double c_2 = c[28];
    const double sin_theta = em_sin(theta);
    const double z_5 = sin_theta*cos_phi_;
    const double r_F = c[5];
    const double c_4 = c[30];
    const double c_3 = c[29];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_7 = c_4 + c_3*cos_delta;
    const double c_5 = c[31];
    const double z_8 = c_5 - cos_delta*c_5;
    const double sin_phi_ = em_sin(phi_);
    const double c_7 = c[33];
    const double sin_delta = em_sin(delta);
    const double z_11 = c_7*sin_delta;
    const double c_ = c[1];
    const double c_6 = c[32];
    const double z_12 = c_6*sin_delta;
    const double z_13 = c_3 + c_4*cos_delta;
    const double z_14 = sin_phi_*cos_delta + z_5*z_12 - z_3*z_11;
    const double z_15 = sqrt(1.0 - z_14*z_14);
    phi[0] = z_1 + r_F*(z_7*z_3 + z_8*z_5 + sin_phi_*z_11) - r_R*z_3 - c_2*z_5 - c_*(sin_phi_*z_12 - z_13*z_5 -
        z_8*z_3) - r_F*z_15;
    const double z_16 = fabs(cos_theta) + fabs(theta*sin_theta);
    const double z_17 = fabs(cos_phi_) + fabs(phi_*sin_phi_);
    const double z_18 = fabs(sin_theta) + fabs(theta*cos_theta);
    const double z_19 = fabs(sin_phi_);
    const double z_20 = z_19 + fabs(phi_*cos_phi_);
    const double z_21 = fabs(cos_delta);
    const double z_22 = z_21 + fabs(delta*sin_delta);
    const double z_23 = fabs(sin_delta) + fabs(delta*cos_delta);
    const double c_113 = c[139];
    const double c_114 = c[140];
    const double z_24 = fabs(z_3);
    const double z_25 = fabs(z_8*cos_phi_);
    const double c_115 = c[141];
    const double c_116 = c[142];
    const double z_26 = c_115 + z_22*c_116;
    const double z_27 = fabs(z_5);
    const double c_117 = c[143];
    const double c_118 = c[144];
    const double c_119 = c[145];
    terms[0] = 0.5*(2.0*(z_16*fabs(z_1) + z_17*fabs(r_R*cos_theta)) + 2.0*(z_18*fabs(cos_phi_*c_2) +
        z_17*fabs(sin_theta*c_2)) + (1.0 + 2.0*((z_20*z_21 + z_19*z_22) + (z_18*fabs(cos_phi_*z_12) +
        z_17*fabs(sin_theta*z_12) + z_23*fabs(c_6*z_5)) + (z_16*fabs(cos_phi_*z_11) + z_17*fabs(cos_theta*z_11) +
        z_23*fabs(c_7*z_3)))*fabs(z_14))*fabs(r_F/z_15) + z_17*c_113 + ((z_16*fabs(cos_phi_*z_7) +
        z_17*fabs(cos_theta*z_7) + (c_114 + c_3*z_22)*z_24) + (z_18*z_25 + z_26*z_27 + z_17*fabs(sin_theta*z_8)) +
        (z_20*fabs(z_11) + z_23*fabs(sin_phi_*c_7)))*c_117 + ((z_20*fabs(z_12) + z_23*fabs(sin_phi_*c_6)) +
        (z_18*fabs(z_13*cos_phi_) + (c_118 + c_4*z_22)*z_27 + z_17*fabs(sin_theta*z_13)) + (z_16*z_25 + z_26*z_24
        + z_17*fabs(cos_theta*z_8)))*c_119);
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
EM_BY_ITSELF void settled_masses(const double *restrict x, const double *restrict c, double M1[N1][N1],
                                 double A1[N_ROWS][N1], double b[N_ROWS], double shared[75])
{
    const double c_0 = c[26];
    M1[0][0] = c_0;
    M1[0][1] = M1[1][0] = 0.0;
    M1[1][1] = c_0;
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double m_B = c[7];
    const double r_R = c[4];
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double z_2 = r_R*sin_phi;
    const double x_B = c[10];
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double z_4 = sin_phi*sin_theta;
    const double c_1 = c[27];
    const double cos_theta = em_cos(theta);
    const double z_6 = sin_phi*cos_theta;
    const double z_7 = z_2 - x_B*z_4 - c_1*z_6;
    const double z_8 = m_B*z_7;
    const double m_F = c[9];
    const double c_2 = c[28];
    const double z_9 = c_2*z_4 - (z_2 - r_R*z_6);
    const double c_ = c[1];
    const double c_3 = c[29];
    const double c_4 = c[30];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_11 = c_3 + c_4*cos_delta;
    const double c_5 = c[31];
    const double z_12 = c_5 - cos_delta*c_5;
    const double cos_phi = em_cos(phi);
    const double c_6 = c[32];
    const double sin_delta = em_sin(delta);
    const double z_15 = c_6*sin_delta;
    const double z_16 = z_11*z_4 + z_12*z_6 + cos_phi*z_15;
    const double r_F = c[5];
    const double z_17 = c_4 + c_3*cos_delta;
    const double c_7 = c[33];
    const double z_18 = c_7*sin_delta;
    const double z_19 = z_17*z_6 + z_12*z_4 - cos_phi*z_18;
    const double z_20 = z_9 - (c_*z_16 + r_F*z_19);
    const double z_21 = -z_20;
    const double z_22 = m_F*z_21;
    const double m_H = c[8];
    const double z_H = c[13];
    const double c_8 = c[34];
    const double z_23 = z_19*z_H + z_16*c_8 - z_9;
    const double z_24 = m_H*z_23;
    const double sin_psi = em_sin(psi);
    const double z_26 = x_B*cos_theta - sin_theta*c_1;
    const double z_27 = m_B*z_26;
    const double z_28 = cos_theta*c_2 - r_R*sin_theta;
    const double z_29 = cos_theta*z_12;
    const double z_30 = sin_theta*z_17 - z_29;
    const double z_31 = sin_theta*z_12;
    const double z_32 = cos_theta*z_11 - z_31;
    const double z_33 = z_28 + (r_F*z_30 - c_*z_32);
    const double z_34 = m_F*z_33;
    const double z_35 = z_H*z_30 + z_28 - c_8*z_32;
    const double z_36 = m_H*z_35;
    const double c_9 = c[35];
    const double z_37 = sin_phi*c_9;
    M1[0][2] = M1[2][0] = cos_psi*z_8 + cos_psi*z_22 + cos_psi*z_24 + cos_psi*z_37 - sin_psi*z_27 - sin_psi*z_34 -
        sin_psi*z_36;
    M1[1][2] = M1[2][1] = cos_psi*z_27 + sin_psi*z_8 + cos_psi*z_34 + sin_psi*z_22 + cos_psi*z_36 + sin_psi*z_24 +
        sin_psi*z_37;
    const double z_38 = sin_phi*sin_delta;
    const double z_39 = sin_theta*cos_phi;
    const double z_40 = cos_theta*cos_phi;
    const double z_41 = c_6*z_38 - z_11*z_39 - z_12*z_40;
    const double c_10 = c[36];
    const double z_42 = z_17*z_40 + z_12*z_39 + c_7*z_38;
    const double c_11 = c[37];
    const double z_43 = z_42*c_11 - z_41*c_10;
    const double c_12 = c[38];
    const double z_44 = z_41*c_11 - z_42*c_12;
    const double z_45 = sin_phi*cos_delta;
    const double z_46 = z_45 + z_39*z_15 - z_40*z_18;
    const double c_13 = c[39];
    const double z_47 = cos_delta*c_13;
    const double c_14 = c[40];
    const double z_48 = (z_43*z_15 + z_44*z_18) - (z_46*z_47 + sin_phi*c_14);
    const double c_15 = c[41];
    const double c_16 = c[42];
    const double c_17 = c[43];
    const double z_49 = sin_delta*z_46;
    const double z_50 = z_11*z_43 + c_15*z_39 + c_16*z_40 + c_17*z_49 - z_12*z_44;
    const double c_18 = c[44];
    const double c_19 = c[45];
    const double z_51 = z_12*z_43 + c_18*z_40 + c_16*z_39 - z_17*z_44 - c_19*z_49;
    const double c_20 = c[46];
    const double c_21 = c[47];
    const double c_22 = c[48];
    const double c_23 = c[49];
    M1[2][2] = 0.5*(z_50*z_39 + z_51*z_40 + c_20*(z_26*z_26) + c_20*(z_7*z_7) + c_21*(z_33*z_33) +
        c_21*(z_21*z_21) + c_22*(z_35*z_35) + c_22*(z_23*z_23) + c_23*(sin_phi*sin_phi) - sin_phi*z_48);
    const double c_24 = c[50];
    const double z_52 = cos_phi*c_24;
    const double c_25 = c[51];
    const double z_53 = sin_psi*c_25;
    const double c_26 = c[52];
    const double z_54 = sin_psi*c_26;
    const double c_27 = c[53];
    const double z_55 = sin_psi*c_27;
    const double c_28 = c[54];
    const double z_56 = z_17*c_28;
    const double z_57 = sin_psi*z_56;
    const double c_29 = c[55];
    const double z_58 = z_11*c_29;
    const double z_59 = sin_psi*z_58;
    const double z_60 = z_12*c_29;
    const double z_61 = sin_psi*z_60;
    const double z_62 = z_12*c_28;
    const double z_63 = sin_psi*z_62;
    M1[0][3] = M1[3][0] = sin_psi*z_52 + z_40*z_57 + z_39*z_59 + z_40*z_61 + z_39*z_63 - z_39*z_53 - z_40*z_54 -
        z_38*z_55;
    const double z_64 = cos_psi*c_25;
    const double z_65 = cos_psi*c_26;
    const double z_66 = cos_psi*c_27;
    const double z_67 = cos_psi*z_56;
    const double z_68 = cos_psi*z_58;
    const double z_69 = cos_psi*z_60;
    const double z_70 = cos_psi*z_62;
    M1[1][3] = M1[3][1] = z_39*z_64 + z_40*z_65 + z_38*z_66 - cos_psi*z_52 - z_40*z_67 - z_39*z_68 - z_40*z_69 -
        z_39*z_70;
    const double c_30 = c[56];
    const double c_31 = c[57];
    const double z_71 = z_33*c_30 + z_35*c_31;
    const double z_72 = z_17*z_71;
    const double c_32 = c[58];
    const double c_33 = c[59];
    const double z_73 = z_33*c_32 + z_35*c_33;
    const double z_74 = z_11*z_73;
    const double z_75 = z_12*z_73;
    const double z_76 = z_12*z_71;
    const double z_77 = z_34 + z_36;
    const double z_78 = z_27 + z_77;
    const double c_34 = c[60];
    const double z_79 = z_77*c_34;
    const double c_35 = c[61];
    const double z_80 = z_77*c_35;
    const double c_36 = c[62];
    const double z_81 = z_73*c_36;
    const double c_37 = c[63];
    const double z_82 = z_71*c_37;
    const double c_38 = c[64];
    const double z_83 = z_26*c_38;
    const double c_39 = c[65];
    const double z_84 = z_26*c_39;
    M1[2][3] = M1[3][2] = 0.5*(sin_theta*z_51 + z_40*z_79 + z_39*z_80 + z_38*z_81 + z_39*z_83 + z_40*z_84 -
        cos_theta*z_50 - 2.0*z_40*z_72 - 2.0*z_39*z_74 - 2.0*z_40*z_75 - 2.0*z_39*z_76 - cos_phi*z_78*c_34 -
        z_38*z_82);
    const double z_85 = z_32*c_11 - z_30*c_12;
    const double z_86 = z_30*c_11 - z_32*c_10;
    const double z_87 = cos_theta*sin_delta;
    const double z_88 = sin_theta*sin_delta;
    const double z_89 = c_6*z_87 + c_7*z_88;
    const double z_90 = sin_delta*z_89;
    const double z_91 = z_17*z_85 + cos_theta*c_16 - z_12*z_86 - sin_theta*c_18 - c_19*z_90;
    const double z_92 = z_11*z_86 + sin_theta*c_16 - z_12*z_85 - cos_theta*c_15 - c_17*z_90;
    const double z_93 = cos_theta*z_17;
    const double z_94 = sin_theta*z_11;
    const double z_95 = z_29 + z_94;
    const double z_96 = z_31 + z_93;
    const double z_97 = r_R*cos_theta + sin_theta*c_2;
    const double z_98 = r_R - z_97;
    const double z_99 = c_*z_95 + r_F*z_96 + z_98;
    const double z_100 = z_H*z_96 + c_8*z_95 + z_98;
    const double z_101 = c_30*z_99 + c_31*z_100;
    const double z_102 = c_32*z_99 + c_33*z_100;
    const double z_103 = r_R - x_B*sin_theta - c_1*cos_theta;
    const double z_104 = m_F*z_99 + m_H*z_100;
    const double c_40 = c[66];
    const double z_105 = sin_delta*sin_delta;
    const double z_106 = cos_theta*c_34;
    const double z_107 = sin_theta*c_35;
    const double z_108 = sin_theta*c_38;
    const double z_109 = cos_theta*c_39;
    M1[3][3] = 0.5*(2.0*z_93*z_101 + 2.0*z_94*z_102 + 2.0*z_29*z_102 + 2.0*z_31*z_101 + (c_9 + m_B*z_103 +
        z_104)*c_34 - sin_theta*z_91 - cos_theta*z_92 - c_40*z_105 - z_104*z_106 - z_104*z_107 - z_103*z_108 -
        z_103*z_109);
    M1[0][4] = M1[4][0] = -(sin_theta*z_64 + cos_theta*z_65 + z_6*z_53 + z_4*z_57 + z_4*z_61 - cos_theta*z_67 -
        sin_theta*z_68 - cos_theta*z_69 - z_4*z_54 - sin_theta*z_70 - z_6*z_59 - z_6*z_63);
    M1[1][4] = M1[4][1] = -(sin_theta*z_53 + cos_theta*z_54 + z_4*z_65 + z_6*z_68 + z_6*z_70 - cos_theta*z_57 -
        sin_theta*z_59 - cos_theta*z_61 - z_6*z_64 - sin_theta*z_63 - z_4*z_67 - z_4*z_69);
    const double z_110 = z_21*c_30 + z_23*c_31;
    const double z_111 = z_21*c_32 + z_23*c_33;
    const double z_112 = z_22 + z_24;
    M1[2][4] = M1[4][2] = (-0.5)*(z_48 + 2.0*z_6*z_74 + 2.0*z_6*z_76 + z_112*z_106 + z_112*z_107 + z_7*z_108 +
        z_7*z_109 + z_4*z_79 + z_4*z_84 - 2.0*z_110*z_93 - 2.0*z_111*z_94 - 2.0*z_29*z_111 - 2.0*z_31*z_110 -
        2.0*z_4*z_72 - 2.0*z_4*z_75 - z_6*z_80 - z_6*z_83);
    const double c_41 = c[67];
    const double c_42 = c[68];
    const double c_43 = c[69];
    const double c_44 = c[70];
    M1[3][4] = M1[4][3] = (-0.5)*(z_86*z_15 + z_85*z_18 + z_89*z_47 + c_44*z_87 + z_17*c_43*z_88 + z_12*c_42*z_88
        - c_41*z_88 - z_11*c_42*z_87 - z_12*c_43*z_87);
    const double z_113 = c_*z_12;
    const double z_114 = r_F*z_17;
    const double z_115 = r_R - z_113 - z_114;
    const double z_116 = r_R - z_17*z_H - z_12*c_8;
    const double z_117 = c_30*z_115 + c_31*z_116;
    const double z_118 = c_*z_11;
    const double z_119 = z_12*r_F;
    const double z_120 = c_2 - z_118 - z_119;
    const double z_121 = c_2 - z_12*z_H - z_11*c_8;
    const double z_122 = c_32*z_120 + c_33*z_121;
    const double z_123 = c_32*z_115 + c_33*z_116;
    const double z_124 = c_30*z_120 + c_31*z_121;
    const double c_45 = c[71];
    const double c_46 = c[72];
    M1[4][4] = 0.5*(c_45*z_105 + c_46 + (m_F*z_115 + m_H*z_116)*c_34 + c_13*(cos_delta*cos_delta) + (m_F*z_120 +
        m_H*z_121)*c_35 - 2.0*z_17*z_117 - 2.0*z_11*z_122 - 2.0*z_12*z_123 - 2.0*z_12*z_124);
    const double c_47 = c[73];
    const double z_125 = cos_psi*c_47;
    const double z_126 = cos_delta*cos_phi;
    const double c_48 = c[74];
    const double z_127 = cos_psi*c_48;
    const double z_128 = sin_delta*z_6;
    const double z_129 = sin_psi*c_48;
    const double z_130 = sin_delta*z_4;
    const double z_131 = sin_psi*c_47;
    M1[0][5] = M1[5][0] = z_87*z_125 + z_126*z_55 - z_88*z_127 - z_128*z_129 - z_130*z_131;
    M1[1][5] = M1[5][1] = z_87*z_131 + z_130*z_125 + z_128*z_127 - z_88*z_129 - z_126*z_66;
    const double c_49 = c[75];
    const double c_50 = c[76];
    const double c_51 = c[77];
    M1[2][5] = M1[5][2] = 0.5*(c_7*z_43 + z_111*c_49*z_87 + z_126*z_82 + z_73*c_49*z_130 + z_71*c_50*z_128 +
        z_111*c_51*z_88 - c_6*z_44 - z_110*c_50*z_88 - z_126*z_81 - z_110*c_51*z_87 - z_73*c_51*z_128 -
        z_71*c_51*z_130);
    const double c_52 = c[78];
    const double c_53 = c[79];
    M1[3][5] = M1[5][3] = 0.5*(c_7*z_86 + cos_delta*z_102*c_36 - c_6*z_85 - cos_theta*c_52*z_105 -
        sin_theta*c_53*z_105 - cos_delta*z_101*c_37);
    const double c_54 = c[80];
    const double z_132 = sin_delta*c_51;
    M1[4][5] = M1[5][4] = (-0.5)*(sin_delta*c_54 + sin_delta*z_123*c_49 + z_122*z_132 - sin_delta*z_124*c_50 -
        z_117*z_132);
    const double c_55 = c[81];
    M1[5][5] = c_55;
    M1[0][6] = M1[6][0] = 0.0;
    M1[1][6] = M1[6][1] = 0.0;
    const double R_yy = c[15];
    M1[2][6] = M1[6][2] = sin_phi*R_yy;
    M1[3][6] = M1[6][3] = 0.0;
    M1[4][6] = M1[6][4] = R_yy;
    M1[5][6] = M1[6][5] = 0.0;
    M1[6][6] = R_yy;
    M1[0][7] = M1[7][0] = 0.0;
    M1[1][7] = M1[7][1] = 0.0;
    const double F_yy = c[17];
    M1[2][7] = M1[7][2] = F_yy*z_46;
    M1[3][7] = M1[7][3] = -F_yy*z_89;
    M1[4][7] = M1[7][4] = cos_delta*F_yy;
    M1[5][7] = M1[7][5] = 0.0;
    M1[6][7] = M1[7][6] = 0.0;
    M1[7][7] = F_yy;
    A1[0][0] = 0.0;
    A1[0][1] = 0.0;
    A1[0][2] = 0.0;
    const double c_103 = c[129];
    const double z_133 = z_46*z_46;
    const double z_134 = sqrt(1.0 - z_133);
    const double z_135 = 1.0/z_134;
    const double z_136 = z_46*z_135;
    const double z_137 = r_F*z_136;
    const double c_104 = c[130];
    const double z_138 = c_104*z_136;
    const double c_105 = c[131];
    const double z_139 = c_105*z_136;
    const double z_140 = (c_*z_94 + c_*z_29) + (r_F*z_93 + r_F*z_31);
    A1[0][3] = cos_phi*(sin_delta*c_103 + cos_delta*z_137) - sin_phi*(z_88*z_138 + z_98 + z_140 - z_87*z_139);
    const double z_141 = r_R*cos_phi;
    const double z_142 = cos_phi*sin_delta;
    A1[0][4] = sin_theta*(z_141 + z_139*z_142 - cos_phi*z_113 - cos_phi*z_114) - cos_theta*(cos_phi*c_2 -
        cos_phi*z_118 - cos_phi*z_119 - z_138*z_142);
    const double c_106 = c[132];
    const double c_107 = c[133];
    A1[0][5] = cos_delta*(sin_phi*c_103 + z_39*z_138 - z_40*z_139) + sin_delta*(c_5*(c_*z_40 + r_F*z_39) -
        c_106*z_39 - sin_phi*z_137 - c_107*z_40);
    A1[0][6] = 0.0;
    A1[0][7] = 0.0;
    A1[1][0] = cos_psi;
    A1[1][1] = sin_psi;
    A1[1][2] = 0.0;
    A1[1][3] = 0.0;
    const double c_108 = c[134];
    A1[1][4] = c_108;
    A1[1][5] = 0.0;
    A1[1][6] = c_108;
    A1[1][7] = 0.0;
    A1[2][0] = -sin_psi;
    A1[2][1] = cos_psi;
    A1[2][2] = 0.0;
    A1[2][3] = 0.0;
    A1[2][4] = 0.0;
    A1[2][5] = 0.0;
    A1[2][6] = 0.0;
    A1[2][7] = 0.0;
    A1[3][0] = cos_psi;
    A1[3][1] = sin_psi;
    const double z_143 = z_126 + c_7*z_128 - c_6*z_130;
    const double z_144 = r_F*(z_19*z_134 - z_136*(z_42*z_143));
    const double z_145 = z_133*z_135;
    const double z_146 = r_F*(z_143*z_134 + z_143*z_145);
    const double z_147 = r_F*(z_16*z_134 + z_136*(z_41*z_143));
    const double z_148 = z_144*z_18 - (cos_delta*z_146 + z_147*z_15);
    A1[3][2] = (z_12*z_147 + z_17*z_144 + z_146*z_18)*z_40 + (z_12*z_144 + z_11*z_147 - z_146*z_15)*z_39 -
        sin_phi*(-z_148) - z_20;
    A1[3][3] = 0.0;
    A1[3][4] = -(z_97 - z_148 - z_140);
    const double c_109 = c[135];
    const double c_110 = c[136];
    A1[3][5] = c_7*z_147 + c_6*z_144 + c_110*z_87 - c_109*z_88;
    A1[3][6] = 0.0;
    A1[3][7] = -z_146;
    A1[4][0] = -sin_psi;
    A1[4][1] = cos_psi;
    const double z_149 = r_F*(z_32*z_134 - z_136*(z_41*z_89));
    const double z_150 = r_F*(z_89*z_134 + z_89*z_145);
    const double z_151 = r_F*(z_30*z_134 - z_136*(z_42*z_89));
    const double z_152 = z_149*z_15 - (cos_delta*z_150 - z_151*z_18);
    const double z_153 = z_17*z_151 + z_150*z_18 - z_12*z_149;
    const double z_154 = z_11*z_149 + z_150*z_15 - z_12*z_151;
    A1[4][2] = z_33 + z_153*z_40 - sin_phi*(-z_152) - z_154*z_39;
    A1[4][3] = -(z_141 + c_103*z_38 + z_118*z_39 + z_113*z_40 + z_114*z_40 + z_119*z_39 - sin_theta*z_153 -
        cos_theta*z_154 - r_R*z_40 - c_2*z_39);
    A1[4][4] = -(r_R*z_4 + z_118*z_6 + z_119*z_6 - c_2*z_6 - z_113*z_4 - z_114*z_4 - z_152);
    A1[4][5] = c_6*z_151 + c_103*z_126 + c_109*z_128 + c_110*z_130 - c_7*z_149;
    A1[4][6] = 0.0;
    A1[4][7] = -z_150;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    b[4] = 0.0;
    shared[0] = cos_psi;
    shared[1] = cos_phi;
    shared[2] = z_39;
    shared[3] = z_6;
    shared[4] = z_40;
    shared[5] = z_4;
    shared[6] = z_7;
    shared[7] = sin_psi;
    shared[8] = z_21;
    shared[9] = z_11;
    shared[10] = sin_delta;
    shared[11] = z_12;
    shared[12] = cos_delta;
    shared[13] = sin_phi;
    shared[14] = z_17;
    shared[15] = z_23;
    shared[16] = sin_theta;
    shared[17] = cos_theta;
    shared[18] = z_26;
    shared[19] = z_33;
    shared[20] = z_35;
    shared[21] = z_48;
    shared[22] = z_43;
    shared[23] = z_44;
    shared[24] = z_46;
    shared[25] = z_126;
    shared[26] = z_50;
    shared[27] = z_51;
    shared[28] = z_38;
    shared[29] = z_57;
    shared[30] = z_56;
    shared[31] = z_59;
    shared[32] = z_58;
    shared[33] = z_61;
    shared[34] = z_60;
    shared[35] = z_63;
    shared[36] = z_62;
    shared[37] = z_67;
    shared[38] = z_68;
    shared[39] = z_69;
    shared[40] = z_70;
    shared[41] = z_78;
    shared[42] = z_77;
    shared[43] = z_73;
    shared[44] = z_72;
    shared[45] = z_71;
    shared[46] = z_74;
    shared[47] = z_75;
    shared[48] = z_76;
    shared[49] = z_91;
    shared[50] = z_85;
    shared[51] = z_86;
    shared[52] = z_89;
    shared[53] = z_92;
    shared[54] = z_101;
    shared[55] = z_93;
    shared[56] = z_102;
    shared[57] = z_94;
    shared[58] = z_29;
    shared[59] = z_31;
    shared[60] = z_104;
    shared[61] = z_103;
    shared[62] = z_110;
    shared[63] = z_111;
    shared[64] = z_112;
    shared[65] = z_105;
    shared[66] = z_117;
    shared[67] = z_122;
    shared[68] = z_123;
    shared[69] = z_124;
    shared[70] = z_87;
    shared[71] = z_45;
    shared[72] = z_88;
    shared[73] = z_128;
    shared[74] = z_130;
}

/* Mdot */
EM_BY_ITSELF void settled_rates(const double *restrict v, const double *restrict c, const double shared[75],
                                double Mdot1[N1][N1])
{
    Mdot1[0][0] = 0.0;
    Mdot1[0][1] = Mdot1[1][0] = 0.0;
    Mdot1[1][1] = 0.0;
    const double m_B = c[7];
    const double cos_psi = shared[0];
    const double r_R = c[4];
    const double phi_dot = v[3];
    const double cos_phi = shared[1];
    const double z_155 = phi_dot*cos_phi;
    const double z_156 = r_R*z_155;
    const double x_B = c[10];
    const double z_39 = shared[2];
    const double z_157 = phi_dot*z_39;
    const double theta_dot = v[4];
    const double z_6 = shared[3];
    const double z_158 = theta_dot*z_6;
    const double z_159 = z_157 + z_158;
    const double c_1 = c[27];
    const double z_40 = shared[4];
    const double z_160 = phi_dot*z_40;
    const double z_4 = shared[5];
    const double z_161 = theta_dot*z_4;
    const double z_162 = z_160 - z_161;
    const double z_163 = z_156 - x_B*z_159 - c_1*z_162;
    const double z_7 = shared[6];
    const double psi_dot = v[2];
    const double sin_psi = shared[7];
    const double z_164 = psi_dot*sin_psi;
    const double m_F = c[9];
    const double z_21 = shared[8];
    const double c_ = c[1];
    const double z_11 = shared[9];
    const double c_4 = c[30];
    const double delta_dot = v[5];
    const double sin_delta = shared[10];
    const double z_165 = delta_dot*sin_delta;
    const double z_166 = c_4*z_165;
    const double z_12 = shared[11];
    const double c_5 = c[31];
    const double z_167 = c_5*z_165;
    const double c_6 = c[32];
    const double cos_delta = shared[12];
    const double z_168 = delta_dot*cos_delta;
    const double sin_phi = shared[13];
    const double z_169 = phi_dot*sin_delta;
    const double z_170 = cos_phi*z_168 - sin_phi*z_169;
    const double z_171 = (z_11*z_157 + z_11*z_158 - z_4*z_166) + (z_12*z_160 + z_6*z_167 - z_12*z_161) +
        c_6*z_170;
    const double r_F = c[5];
    const double z_17 = shared[14];
    const double c_3 = c[29];
    const double z_172 = c_3*z_165;
    const double c_7 = c[33];
    const double z_173 = (z_17*z_161 + z_6*z_172 - z_17*z_160) + c_7*z_170 - (z_12*z_157 + z_12*z_158 +
        z_4*z_167);
    const double c_2 = c[28];
    const double z_174 = c_2*z_159 - (z_156 - r_R*z_162);
    const double z_175 = c_*z_171 - r_F*z_173 - z_174;
    const double m_H = c[8];
    const double z_23 = shared[15];
    const double z_H = c[13];
    const double c_8 = c[34];
    const double z_176 = c_8*z_171 - z_H*z_173 - z_174;
    const double sin_theta = shared[16];
    const double z_177 = theta_dot*sin_theta;
    const double cos_theta = shared[17];
    const double z_178 = theta_dot*cos_theta;
    const double z_179 = x_B*z_177 + c_1*z_178;
    const double z_26 = shared[18];
    const double z_180 = psi_dot*cos_psi;
    const double z_33 = shared[19];
    const double z_181 = z_12*z_177;
    const double z_182 = cos_theta*z_167;
    const double z_183 = z_181 - z_182;
    const double z_184 = (z_17*z_178 - sin_theta*z_172) + z_183;
    const double z_185 = z_12*z_178;
    const double z_186 = sin_theta*z_167;
    const double z_187 = z_185 + z_186;
    const double z_188 = (z_11*z_177 + cos_theta*z_166) + z_187;
    const double z_189 = r_R*z_178 + c_2*z_177;
    const double z_190 = z_189 - r_F*z_184 - c_*z_188;
    const double z_35 = shared[20];
    const double z_191 = z_189 - z_H*z_184 - c_8*z_188;
    const double c_9 = c[35];
    const double z_192 = phi_dot*cos_psi;
    Mdot1[0][2] = Mdot1[2][0] = m_B*(cos_psi*z_163 - z_7*z_164) + m_B*(sin_psi*z_179 - z_26*z_180) +
        c_9*(cos_phi*z_192 - sin_phi*z_164) - m_F*(z_21*z_164 - cos_psi*z_175) - m_H*(z_23*z_164 - cos_psi*z_176)
        - m_F*(z_33*z_180 - sin_psi*z_190) - m_H*(z_35*z_180 - sin_psi*z_191);
    const double z_193 = phi_dot*sin_psi;
    Mdot1[1][2] = Mdot1[2][1] = -(m_B*(z_26*z_164 + cos_psi*z_179) + m_F*(z_33*z_164 + cos_psi*z_190) +
        m_H*(z_35*z_164 + cos_psi*z_191) - m_B*(sin_psi*z_163 + z_7*z_180) - m_F*(sin_psi*z_175 + z_21*z_180) -
        m_H*(sin_psi*z_176 + z_23*z_180) - c_9*(cos_phi*z_193 + sin_phi*z_180));
    const double z_48 = shared[21];
    const double z_43 = shared[22];
    const double c_10 = c[36];
    const double z_194 = sin_phi*z_168;
    const double z_195 = cos_phi*z_169;
    const double z_196 = z_194 + z_195;
    const double z_197 = phi_dot*z_4;
    const double z_198 = theta_dot*z_40;
    const double z_199 = phi_dot*z_6;
    const double z_200 = theta_dot*z_39;
    const double z_201 = c_6*z_196 + (z_11*z_197 + z_39*z_166 - z_11*z_198) + (z_12*z_199 + z_12*z_200 -
        z_40*z_167);
    const double z_202 = (z_17*z_199 + z_17*z_200 + z_40*z_172) - (z_12*z_198 + z_39*z_167 - z_12*z_197) -
        c_7*z_196;
    const double c_11 = c[37];
    const double z_203 = c_10*z_201 + z_202*c_11;
    const double z_44 = shared[23];
    const double c_12 = c[38];
    const double z_204 = c_12*z_202 + z_201*c_11;
    const double c_56 = c[82];
    const double z_46 = shared[24];
    const double z_126 = shared[25];
    const double z_205 = (phi_dot*z_126 - sin_phi*z_165) + c_6*(sin_delta*z_198 + z_39*z_168 - z_4*z_169) +
        c_7*(sin_delta*z_200 + z_6*z_169 - z_40*z_168);
    const double c_14 = c[40];
    const double z_206 = (c_6*(z_43*z_168 - sin_delta*z_203) + c_7*(z_44*z_168 + sin_delta*z_204)) +
        2.0*(c_56*(z_46*z_165 - cos_delta*z_205) - 0.5*c_14*z_155);
    const double z_50 = shared[26];
    const double B_xz = c[21];
    const double z_207 = z_199 + z_200;
    const double c_57 = c[83];
    const double z_208 = z_46*z_168 + sin_delta*z_205;
    const double c_15 = c[41];
    const double z_209 = z_198 - z_197;
    const double z_210 = (z_43*z_166 + z_11*z_203) + (z_44*z_167 + z_12*z_204) + 2.0*B_xz*z_207 - 2.0*c_57*z_208 -
        c_15*z_209;
    const double z_51 = shared[27];
    const double c_58 = c[84];
    const double c_18 = c[44];
    const double z_211 = (z_43*z_167 - z_12*z_203) + (z_44*z_172 - z_17*z_204) + 2.0*B_xz*z_209 - 2.0*c_58*z_208 -
        c_18*z_207;
    const double c_59 = c[85];
    const double c_60 = c[86];
    const double c_61 = c[87];
    const double c_62 = c[88];
    Mdot1[2][2] = (-0.5)*((z_48*z_155 + sin_phi*z_206) + (z_51*z_200 + z_51*z_199 - z_211*z_40) + z_26*z_179*c_59
        + z_33*z_190*c_60 + z_35*z_191*c_61 - (z_50*z_198 - z_50*z_197 - z_210*z_39) - z_7*z_163*c_59 -
        z_21*z_175*c_60 - z_23*z_176*c_61 - c_62*(sin_phi*z_155));
    const double c_24 = c[50];
    const double c_25 = c[51];
    const double z_212 = z_4*z_193;
    const double z_213 = z_39*z_180;
    const double c_26 = c[52];
    const double z_214 = z_6*z_193;
    const double z_215 = z_40*z_180;
    const double c_27 = c[53];
    const double z_38 = shared[28];
    const double z_57 = shared[29];
    const double z_56 = shared[30];
    const double c_63 = c[89];
    const double z_216 = sin_psi*z_165;
    const double z_217 = c_63*z_216;
    const double z_59 = shared[31];
    const double c_64 = c[90];
    const double z_218 = c_64*z_216;
    const double z_58 = shared[32];
    const double z_61 = shared[33];
    const double c_65 = c[91];
    const double z_219 = c_65*z_216;
    const double z_60 = shared[34];
    const double z_63 = shared[35];
    const double c_66 = c[92];
    const double z_220 = c_66*z_216;
    const double z_62 = shared[36];
    Mdot1[0][3] = Mdot1[3][0] = -(c_24*(sin_phi*z_193 - cos_phi*z_180) + c_25*(sin_psi*z_198 + z_213 - z_212) +
        c_27*(sin_psi*z_195 + sin_psi*z_194 + z_180*z_38) + (z_200*z_57 + z_214*z_56 + z_40*z_217 - z_215*z_56) +
        (z_200*z_61 + z_214*z_60 - z_40*z_219 - z_215*z_60) - c_26*(sin_psi*z_200 + z_214 - z_215) - (z_198*z_59 +
        z_213*z_58 - z_39*z_218 - z_212*z_58) - (z_198*z_63 + z_39*z_220 + z_213*z_62 - z_212*z_62));
    const double z_221 = z_39*z_164;
    const double z_222 = z_4*z_192;
    const double z_223 = z_40*z_164;
    const double z_224 = z_6*z_192;
    const double z_67 = shared[37];
    const double z_225 = cos_psi*z_165;
    const double z_226 = c_63*z_225;
    const double z_68 = shared[38];
    const double z_227 = c_64*z_225;
    const double z_69 = shared[39];
    const double z_228 = c_65*z_225;
    const double z_70 = shared[40];
    const double z_229 = c_66*z_225;
    Mdot1[1][3] = Mdot1[3][1] = c_25*(cos_psi*z_198 - z_221 - z_222) + c_27*(cos_psi*z_195 + cos_psi*z_194 -
        z_164*z_38) + c_24*(cos_phi*z_164 + sin_phi*z_192) + (z_200*z_67 + z_223*z_56 + z_224*z_56 + z_40*z_226) +
        (z_200*z_69 + z_223*z_60 + z_224*z_60 - z_40*z_228) - c_26*(cos_psi*z_200 + z_223 + z_224) - (z_198*z_68 -
        z_221*z_58 - z_39*z_227 - z_222*z_58) - (z_198*z_70 + z_39*z_229 - z_221*z_62 - z_222*z_62);
    const double z_78 = shared[41];
    const double z_230 = m_F*z_190 + m_H*z_191;
    const double z_77 = shared[42];
    const double z_73 = shared[43];
    const double c_32 = c[58];
    const double c_33 = c[59];
    const double z_231 = c_32*z_190 + c_33*z_191;
    const double z_72 = shared[44];
    const double z_71 = shared[45];
    const double z_232 = z_71*z_172;
    const double c_30 = c[56];
    const double c_31 = c[57];
    const double z_233 = c_30*z_190 + c_31*z_191;
    const double z_234 = z_17*z_233;
    const double z_74 = shared[46];
    const double z_235 = z_73*z_166;
    const double z_236 = z_11*z_231;
    const double z_75 = shared[47];
    const double z_237 = z_73*z_167;
    const double z_238 = z_12*z_231;
    const double z_76 = shared[48];
    const double z_239 = z_71*z_167;
    const double z_240 = z_12*z_233;
    const double c_67 = c[93];
    const double c_68 = c[94];
    Mdot1[2][3] = Mdot1[3][2] = 0.5*((z_51*z_178 + sin_theta*z_211) + (z_50*z_177 + cos_theta*z_210) +
        2.0*r_R*(z_78*(phi_dot*sin_phi) + cos_phi*(m_B*z_179 + z_230)) + 2.0*c_2*(z_77*z_198 - z_77*z_197 -
        z_230*z_39) + 2.0*c_6*(z_73*z_195 + z_73*z_194 - z_231*z_38) + 2.0*(z_200*z_72 + z_199*z_72 + z_40*z_232 +
        z_40*z_234) + 2.0*(z_200*z_75 + z_199*z_75 + z_40*z_238 - z_40*z_237) + 2.0*c_67*(z_26*z_198 - z_26*z_197
        - z_179*z_39) - 2.0*r_R*(z_77*z_200 + z_77*z_199 + z_230*z_40) - 2.0*(z_198*z_74 - z_39*z_235 - z_197*z_74
        - z_39*z_236) - 2.0*(z_198*z_76 + z_39*z_239 - z_197*z_76 - z_39*z_240) - 2.0*c_7*(z_71*z_195 + z_71*z_194
        - z_233*z_38) - 2.0*c_68*(z_26*z_200 + z_26*z_199 + z_179*z_40));
    const double z_91 = shared[49];
    const double z_85 = shared[50];
    const double z_241 = c_12*z_184 + z_188*c_11;
    const double z_86 = shared[51];
    const double z_242 = c_10*z_188 + z_184*c_11;
    const double z_89 = shared[52];
    const double z_243 = sin_delta*z_177;
    const double z_244 = cos_theta*z_168;
    const double z_245 = z_243 - z_244;
    const double z_246 = sin_delta*z_178;
    const double z_247 = sin_theta*z_168;
    const double z_248 = z_246 + z_247;
    const double z_249 = c_6*z_245 - c_7*z_248;
    const double z_250 = z_89*z_168 - sin_delta*z_249;
    const double c_16 = c[42];
    const double z_92 = shared[53];
    const double z_101 = shared[54];
    const double z_251 = z_17*z_177;
    const double z_252 = cos_theta*z_172;
    const double z_93 = shared[55];
    const double z_253 = z_11*z_178;
    const double z_254 = sin_theta*z_166;
    const double z_255 = z_183 - (z_253 - z_254);
    const double z_256 = z_187 - (z_251 + z_252);
    const double z_257 = r_R*z_177 - c_2*z_178;
    const double z_258 = r_F*z_256 + z_257 - c_*z_255;
    const double z_259 = z_H*z_256 + z_257 - c_8*z_255;
    const double z_260 = c_30*z_258 + c_31*z_259;
    const double z_102 = shared[56];
    const double z_94 = shared[57];
    const double z_261 = c_32*z_258 + c_33*z_259;
    const double z_29 = shared[58];
    const double z_31 = shared[59];
    const double z_104 = shared[60];
    const double z_262 = m_F*z_258 + m_H*z_259;
    const double z_103 = shared[61];
    const double z_263 = c_1*z_177 - x_B*z_178;
    const double c_34 = c[60];
    const double c_69 = c[95];
    const double z_264 = cos_delta*z_165;
    Mdot1[3][3] = 0.5*((z_92*z_177 + cos_theta*((z_86*z_166 - z_11*z_242) + (z_85*z_167 - z_12*z_241) +
        2.0*c_57*z_250 - c_15*z_177 - c_16*z_178)) + 2.0*(z_102*z_253 + z_94*z_261 - z_102*z_254) +
        2.0*(z_101*z_185 + z_101*z_186 + z_31*z_260) + 2.0*r_R*(z_104*z_177 - cos_theta*z_262) +
        2.0*c_68*(z_103*z_177 - cos_theta*z_263) + (m_B*z_263 + z_262)*c_34 - (z_91*z_178 - sin_theta*((z_85*z_172
        + z_17*z_241) + (z_86*z_167 + z_12*z_242) + 2.0*c_58*z_250 + c_18*z_178 + c_16*z_177)) - 2.0*(z_101*z_251
        + z_101*z_252 - z_93*z_260) - 2.0*(z_102*z_181 - z_102*z_182 - z_29*z_261) - 2.0*c_2*(z_104*z_178 +
        sin_theta*z_262) - 2.0*c_67*(z_103*z_178 + sin_theta*z_263) - c_69*z_264);
    const double z_265 = sin_theta*z_164;
    const double z_266 = cos_theta*z_164;
    const double z_267 = z_39*z_193;
    const double z_268 = z_4*z_180;
    const double z_269 = z_40*z_193;
    const double z_270 = z_6*z_180;
    Mdot1[0][4] = Mdot1[4][0] = -(c_25*(cos_psi*z_178 - z_265) + (z_177*z_67 + z_266*z_56 + cos_theta*z_226) +
        (z_177*z_69 + z_266*z_60 - cos_theta*z_228) + c_25*(z_269 + z_270 - sin_psi*z_161) + (z_267*z_56 +
        z_158*z_57 + z_268*z_56 - z_4*z_217) + (z_267*z_60 + z_158*z_61 + z_4*z_219 + z_268*z_60) -
        c_26*(cos_psi*z_177 + z_266) - (z_178*z_68 - z_265*z_58 - sin_theta*z_227) - c_26*(z_267 + sin_psi*z_158 +
        z_268) - (z_178*z_70 + sin_theta*z_229 - z_265*z_62) - (z_269*z_58 + z_270*z_58 - z_161*z_59 - z_6*z_218)
        - (z_269*z_62 + z_6*z_220 + z_270*z_62 - z_161*z_63));
    const double z_271 = sin_theta*z_180;
    const double z_272 = cos_theta*z_180;
    const double z_273 = z_40*z_192;
    const double z_274 = z_6*z_164;
    const double z_275 = z_39*z_192;
    const double z_276 = z_4*z_164;
    Mdot1[1][4] = Mdot1[4][1] = -(c_25*(sin_psi*z_178 + z_271) + (z_177*z_57 + cos_theta*z_217 - z_272*z_56) +
        (z_177*z_61 - cos_theta*z_219 - z_272*z_60) + c_26*(z_275 + cos_psi*z_158 - z_276) + (z_273*z_58 -
        z_161*z_68 - z_274*z_58 - z_6*z_227) + (z_273*z_62 + z_6*z_229 - z_161*z_70 - z_274*z_62) -
        c_26*(sin_psi*z_177 - z_272) - (z_178*z_59 + z_271*z_58 - sin_theta*z_218) - c_25*(z_273 - cos_psi*z_161 -
        z_274) - (z_178*z_63 + sin_theta*z_220 + z_271*z_62) - (z_275*z_56 + z_158*z_67 - z_276*z_56 - z_4*z_226)
        - (z_275*z_60 + z_158*z_69 + z_4*z_228 - z_276*z_60));
    const double z_110 = shared[62];
    const double z_277 = c_30*z_175 + c_31*z_176;
    const double z_111 = shared[63];
    const double z_278 = c_32*z_175 + c_33*z_176;
    const double z_112 = shared[64];
    const double z_279 = m_F*z_175 + m_H*z_176;
    Mdot1[2][4] = Mdot1[4][2] = (-0.5)*(z_206 + 2.0*(z_110*z_251 + z_110*z_252 - z_93*z_277) + 2.0*(z_111*z_181 -
        z_111*z_182 - z_29*z_278) + 2.0*c_2*(z_112*z_178 + sin_theta*z_279) + 2.0*c_67*(z_7*z_178 +
        sin_theta*z_163) + 2.0*r_R*(z_77*z_157 + z_77*z_158 - z_230*z_4) + 2.0*(z_160*z_74 - z_161*z_74 -
        z_6*z_235 - z_6*z_236) + 2.0*(z_160*z_76 + z_6*z_239 - z_161*z_76 - z_6*z_240) + 2.0*c_68*(z_26*z_157 +
        z_26*z_158 - z_179*z_4) - 2.0*(z_111*z_253 + z_94*z_278 - z_111*z_254) - 2.0*(z_110*z_185 + z_110*z_186 +
        z_31*z_277) - 2.0*r_R*(z_112*z_177 - cos_theta*z_279) - 2.0*c_2*(z_77*z_160 - z_77*z_161 - z_230*z_6) -
        2.0*(z_157*z_72 + z_158*z_72 - z_4*z_232 - z_4*z_234) - 2.0*(z_157*z_75 + z_158*z_75 + z_4*z_237 -
        z_4*z_238) - 2.0*c_68*(z_7*z_177 - cos_theta*z_163) - 2.0*c_67*(z_26*z_160 - z_26*z_161 - z_179*z_6));
    const double c_70 = c[96];
    const double c_71 = c[97];
    const double z_280 = z_11*c_71;
    const double c_72 = c[98];
    const double z_105 = shared[65];
    const double z_281 = delta_dot*z_105;
    const double z_282 = cos_theta*z_281;
    const double c_73 = c[99];
    const double z_283 = z_12*c_73;
    const double c_74 = c[100];
    const double c_75 = c[101];
    const double z_284 = z_17*c_73;
    const double c_76 = c[102];
    const double z_285 = sin_theta*z_281;
    const double z_286 = z_12*c_71;
    const double c_77 = c[103];
    Mdot1[3][4] = Mdot1[4][3] = 0.5*(2.0*c_56*(z_89*z_165 + cos_delta*z_249) + 2.0*c_70*z_248 + 2.0*c_75*z_245 -
        c_6*(z_86*z_168 + sin_delta*z_242) - c_7*(z_85*z_168 - sin_delta*z_241) - 2.0*(z_243*z_280 + c_72*z_282 -
        z_244*z_280) - 2.0*(z_243*z_283 - c_74*z_282 - z_244*z_283) - 2.0*(z_246*z_284 + z_247*z_284 - c_76*z_285)
        - 2.0*(z_246*z_286 + c_77*z_285 + z_247*z_286));
    const double z_117 = shared[66];
    const double c_78 = c[104];
    const double z_122 = shared[67];
    const double c_79 = c[105];
    const double z_123 = shared[68];
    const double c_80 = c[106];
    const double z_287 = z_12*z_165;
    const double z_124 = shared[69];
    const double c_81 = c[107];
    const double c_82 = c[108];
    const double c_83 = c[109];
    Mdot1[4][4] = (z_117*z_172 - z_17*c_78*z_165) + (z_122*z_166 - z_11*c_79*z_165) + c_82*z_165 - (z_123*z_167 +
        c_80*z_287) - (z_124*z_167 + c_81*z_287) - c_83*z_264;
    const double c_47 = c[73];
    const double z_87 = shared[70];
    const double z_45 = shared[71];
    const double c_48 = c[74];
    const double z_88 = shared[72];
    const double z_288 = z_40*z_169;
    const double z_289 = sin_delta*z_161;
    const double z_290 = z_6*z_168;
    const double z_128 = shared[73];
    const double z_291 = z_39*z_169;
    const double z_292 = sin_delta*z_158;
    const double z_293 = z_4*z_168;
    const double z_130 = shared[74];
    Mdot1[0][5] = Mdot1[5][0] = -(c_47*(cos_psi*z_243 + z_164*z_87 - cos_psi*z_244) + c_27*(cos_phi*z_216 +
        z_45*z_193 - z_126*z_180) + c_48*(cos_psi*z_246 + cos_psi*z_247 - z_164*z_88) + c_48*(sin_psi*z_288 +
        sin_psi*z_290 + z_180*z_128 - sin_psi*z_289) + c_47*(sin_psi*z_291 + sin_psi*z_292 + sin_psi*z_293 +
        z_180*z_130));
    Mdot1[1][5] = Mdot1[5][1] = -(c_47*(sin_psi*z_243 - sin_psi*z_244 - z_180*z_87) + c_48*(sin_psi*z_246 +
        sin_psi*z_247 + z_180*z_88) - c_27*(z_126*z_164 + cos_phi*z_225 + z_45*z_192) - c_47*(cos_psi*z_291 +
        cos_psi*z_292 + cos_psi*z_293 - z_164*z_130) - c_48*(cos_psi*z_288 + cos_psi*z_290 - cos_psi*z_289 -
        z_164*z_128));
    const double z_294 = cos_phi*z_165;
    const double z_295 = phi_dot*z_45;
    Mdot1[2][5] = Mdot1[5][2] = (-0.5)*(c_7*z_203 + c_6*z_204 + 2.0*c_4*(z_111*z_243 - z_111*z_244 - z_278*z_87) +
        2.0*c_7*(z_71*z_294 + z_71*z_295 + z_126*z_233) + 2.0*c_3*(z_110*z_246 + z_110*z_247 + z_277*z_88) +
        2.0*c_5*(z_73*z_288 + z_73*z_290 - z_73*z_289 - z_231*z_128) + 2.0*c_5*(z_71*z_291 + z_71*z_292 +
        z_71*z_293 - z_233*z_130) - 2.0*c_6*(z_73*z_294 + z_73*z_295 + z_126*z_231) - 2.0*c_4*(z_73*z_291 +
        z_73*z_292 + z_73*z_293 - z_231*z_130) - 2.0*c_3*(z_71*z_288 + z_71*z_290 - z_71*z_289 - z_233*z_128) -
        2.0*c_5*(z_111*z_246 + z_111*z_247 + z_278*z_88) - 2.0*c_5*(z_110*z_243 - z_110*z_244 - z_277*z_87));
    const double c_84 = c[110];
    const double c_85 = c[111];
    Mdot1[3][5] = Mdot1[5][3] = 0.5*(c_7*z_242 + c_6*z_241 + 2.0*c_84*(z_105*z_177 - 2.0*cos_theta*z_264) +
        2.0*c_7*(z_101*z_165 - cos_delta*z_260) - 2.0*c_6*(z_102*z_165 - cos_delta*z_261) - 2.0*c_85*(z_105*z_178
        + 2.0*sin_theta*z_264));
    const double c_54 = c[80];
    const double c_86 = c[112];
    const double c_87 = c[113];
    const double z_296 = c_5*z_168;
    const double c_88 = c[114];
    const double c_89 = c[115];
    Mdot1[4][5] = Mdot1[5][4] = (-0.5)*(c_54*z_168 + 2.0*(z_168*(c_4*z_123) + c_87*z_281) + 2.0*(z_122*z_296 +
        c_89*z_281) - 2.0*(z_168*(c_3*z_124) + c_86*z_281) - 2.0*(z_117*z_296 + c_88*z_281));
    Mdot1[5][5] = 0.0;
    Mdot1[0][6] = Mdot1[6][0] = 0.0;
    Mdot1[1][6] = Mdot1[6][1] = 0.0;
    const double R_yy = c[15];
    Mdot1[2][6] = Mdot1[6][2] = R_yy*z_155;
    Mdot1[3][6] = Mdot1[6][3] = 0.0;
    Mdot1[4][6] = Mdot1[6][4] = 0.0;
    Mdot1[5][6] = Mdot1[6][5] = 0.0;
    Mdot1[6][6] = 0.0;
    Mdot1[0][7] = Mdot1[7][0] = 0.0;
    Mdot1[1][7] = Mdot1[7][1] = 0.0;
    const double F_yy = c[17];
    Mdot1[2][7] = Mdot1[7][2] = F_yy*z_205;
    Mdot1[3][7] = Mdot1[7][3] = F_yy*z_249;
    Mdot1[4][7] = Mdot1[7][4] = -F_yy*z_165;
    Mdot1[5][7] = Mdot1[7][5] = 0.0;
    Mdot1[6][7] = Mdot1[7][6] = 0.0;
    Mdot1[7][7] = 0.0;
}

/* After an accepted step, and at the start: constraints on positions, C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[75];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 80);
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
    em_spread(N, N1, coordinate1, y + 16, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 16);
    for (int i = 0; i < N1; ++i) y[80 + i] = s[coordinate1[i]];
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

#include "bicycle.h"

static const char *const coordinate_names[] = { "x", "y", "psi", "phi", "theta", "delta", "spin_r", "spin_f", NULL };
static const char *const parameter_names[] = { "w", "c", "tilt", "g", "r_R", "r_F", "m_R", "m_B", "m_H", "m_F", "x_B",
    "z_B", "x_H", "z_H", "R_xx", "R_yy", "F_xx", "F_yy", "B_xx", "B_yy", "B_zz", "B_xz", "H_xx", "H_yy", "H_zz", "H_xz",
    NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.02, 0.08, 0.3141592653589793, 9.81, 0.3, 0.35, 2.0, 85.0, 4.0, 3.0, 0.3,
    0.9, 0.9, 0.7, 0.0603, 0.12, 0.1405, 0.28, 9.2, 11.0, 2.8, 2.4, 0.05892, 0.06, 0.00708, -0.00756, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
static const double initial_v[N] = { 4.6, 0.0, 0.0, 0.5, 0.0, 0.0, 15.333333333333332, 13.142857142857142 };
static const int carried[N] = { 1, 1, 1, 1, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"trace", 0, 3},
    {"trace", 3, 3},
    {"disk", 6, 8},
    {"disk", 14, 8},
    {"line", 22, 6},
    {"line", 28, 6},
    {"line", 34, 6},
    {"disk", 40, 4}
};
static const em_slice layout[] = {
    {"x", 0, 8},
    {"eta", 8, 8},
    {"C", 16, 64},
    {"s", 80, 8}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dx, dM/dy, dM/dspin_r, dM/dspin_f: M does not depend on them",
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
static int simulate(em_run *run) { return em_simulate(&bicycle_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&bicycle_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&bicycle_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&bicycle_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&bicycle_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&bicycle_model, run, mode); }

const em_model bicycle_model = {
    .abi = EM_ABI,
    .name = "bicycle",
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
    .lanes = &bicycle_lanes,
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
    .n_shapes = 8,
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
