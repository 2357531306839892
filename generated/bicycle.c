/* eigenmotion generate bicycle.py */
/* input sha256:6aab49efe412f9e2376a6a40a15d69c742564dd7bf6899b0495dbaa7b7dd103e */
/* body sha256:d7c2d203fded45cfac309918bec36425138c7e92dc21fa0906db708b5a84d817 */
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
#include "bicycle.h"

#include "em_functions.h"
#include "em_multipliers.h"

enum {
    N = 8,              /* coordinates */
    N_ROWS = 5,         /* constraint rows */
    N_POSITIONS = 1,    /* of which holonomic */
    N_STATE = 88,       /* numbers of a state */
    N_C = 64,           /* of which C, */
    N_S = 8,            /* s, */
    N_CD = 0,           /* C of Delta, */
    N_SD = 0,           /* s of Delta */
    N_INPUTS = 0,
    N_OUTPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 72,      /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,/* whether the state is x, xdot */
    SETTLES = 1,        /* whether an accepted step leaves anything to put right */
    N_PARAMETERS = 26,
    N_PREPARED = 156,   /* the parameters, factors of constant blocks, shared constants */
    N1 = 8,             /* x, y, psi, phi, theta, delta, spin_r, spin_f */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4, 5, 6, 7 };

#ifndef EM_ASIDE_ALONE

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
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
    const real c_0 = c[26];
    const real z_11 = cos_theta*z_2;
    const real z_12 = theta_dot*sin_theta;
    const real z_13 = sin_phi*z_12;
    const real z_14 = z_11 - z_13;
    const real z_15 = z_3 - x_B*z_10 - c_0*z_14;
    const real z_16 = r_R*sin_phi;
    const real z_17 = sin_phi*sin_theta;
    const real z_18 = sin_phi*cos_theta;
    const real z_19 = z_16 - x_B*z_17 - c_0*z_18;
    const real psi_dot = v[2];
    const real sin_psi = em_sin(psi);
    const real z_21 = psi_dot*sin_psi;
    const real m_F = c[9];
    const real c_1 = c[27];
    const real z_22 = c_1*z_17 - (z_16 - r_R*z_18);
    const real c_ = c[1];
    const real c_2 = c[28];
    const real c_3 = c[29];
    const real delta = x[5];
    const real cos_delta = em_cos(delta);
    const real z_24 = c_2 + c_3*cos_delta;
    const real c_4 = c[30];
    const real z_25 = c_4 - cos_delta*c_4;
    const real c_5 = c[31];
    const real sin_delta = em_sin(delta);
    const real z_27 = c_5*sin_delta;
    const real z_28 = z_24*z_17 + z_25*z_18 + cos_phi*z_27;
    const real r_F = c[5];
    const real z_29 = c_3 + c_2*cos_delta;
    const real c_6 = c[32];
    const real z_30 = c_6*sin_delta;
    const real z_31 = z_29*z_18 + z_25*z_17 - cos_phi*z_30;
    const real z_32 = z_22 - (c_*z_28 + r_F*z_31);
    const real z_33 = -z_32;
    const real z_34 = c_1*z_10 - (z_3 - r_R*z_14);
    const real delta_dot = v[5];
    const real z_35 = delta_dot*sin_delta;
    const real z_36 = c_3*z_35;
    const real z_37 = z_17*z_36 - (z_24*z_5 + z_24*z_9);
    const real z_38 = c_4*z_35;
    const real z_39 = z_18*z_38 + (z_25*z_11 - z_25*z_13);
    const real z_40 = delta_dot*cos_delta;
    const real z_41 = cos_phi*z_40;
    const real z_42 = phi_dot*sin_phi;
    const real z_43 = sin_delta*z_42;
    const real z_44 = z_41 - z_43;
    const real z_45 = (-z_37) + z_39 + c_5*z_44;
    const real z_46 = c_2*z_35;
    const real z_47 = (z_18*z_46 + (z_29*z_13 - z_29*z_11)) - (z_17*z_38 + (z_25*z_5 + z_25*z_9));
    const real z_48 = c_6*z_44 + z_47;
    const real z_49 = z_34 - (c_*z_45 - r_F*z_48);
    const real z_50 = -z_49;
    const real m_H = c[8];
    const real z_H = c[13];
    const real c_7 = c[33];
    const real z_51 = z_31*z_H + z_28*c_7 - z_22;
    const real z_52 = c_7*z_45 - z_H*z_48 - z_34;
    const real z_53 = x_B*z_12 + c_0*z_8;
    const real z_54 = x_B*cos_theta - sin_theta*c_0;
    const real z_55 = psi_dot*cos_psi;
    const real z_56 = cos_theta*c_1 - r_R*sin_theta;
    const real z_57 = cos_theta*z_25;
    const real z_58 = sin_theta*z_29 - z_57;
    const real z_59 = sin_theta*z_25;
    const real z_60 = cos_theta*z_24 - z_59;
    const real z_61 = z_56 + (r_F*z_58 - c_*z_60);
    const real z_62 = r_R*z_8 + c_1*z_12;
    const real z_63 = sin_theta*z_35;
    const real z_64 = z_25*z_12;
    const real z_65 = cos_theta*z_38;
    const real z_66 = z_64 - z_65;
    const real z_67 = (z_29*z_8 - c_2*z_63) + z_66;
    const real z_68 = z_67;
    const real z_69 = cos_theta*z_35;
    const real z_70 = z_25*z_8;
    const real z_71 = sin_theta*z_38;
    const real z_72 = z_70 + z_71;
    const real z_73 = (z_24*z_12 + c_3*z_69) + z_72;
    const real z_74 = z_73;
    const real z_75 = z_62 - (r_F*z_68 + c_*z_74);
    const real z_76 = z_H*z_58 + z_56 - c_7*z_60;
    const real z_77 = z_62 - z_H*z_68 - c_7*z_74;
    const real c_8 = c[34];
    Mdot1[0][2] = Mdot1[2][0] = m_B*(cos_psi*z_15 - z_19*z_21) + m_B*(sin_psi*z_53 - z_54*z_55) + c_8*(cos_psi*z_2
        - sin_phi*z_21) - m_F*(z_33*z_21 - cos_psi*z_50) - m_H*(z_51*z_21 - cos_psi*z_52) - m_F*(z_61*z_55 -
        sin_psi*z_75) - m_H*(z_76*z_55 - sin_psi*z_77);
    Mdot1[1][2] = Mdot1[2][1] = -(m_B*(z_54*z_21 + cos_psi*z_53) + m_F*(z_61*z_21 + cos_psi*z_75) + m_H*(z_76*z_21
        + cos_psi*z_77) - m_B*(sin_psi*z_15 + z_19*z_55) - m_F*(sin_psi*z_50 + z_33*z_55) - m_H*(sin_psi*z_52 +
        z_51*z_55) - c_8*(sin_psi*z_2 + sin_phi*z_55));
    const real z_78 = sin_theta*cos_phi;
    const real z_79 = cos_theta*cos_phi;
    const real z_80 = sin_phi*z_27 - z_24*z_78 - z_25*z_79;
    const real c_9 = c[35];
    const real z_81 = z_29*z_79 + z_25*z_78 + sin_phi*z_30;
    const real c_10 = c[36];
    const real z_82 = z_81*c_10 - z_80*c_9;
    const real c_11 = c[37];
    const real z_83 = z_80*c_10 - z_81*c_11;
    const real z_84 = sin_phi*cos_delta + z_78*z_27 - z_79*z_30;
    const real c_12 = c[38];
    const real c_13 = c[39];
    const real z_85 = sin_phi*z_40;
    const real z_86 = z_85 + sin_delta*z_2;
    const real z_87 = sin_theta*z_42;
    const real z_88 = cos_phi*z_8;
    const real z_89 = z_78*z_36 + (z_24*z_87 - z_24*z_88);
    const real z_90 = cos_theta*z_42;
    const real z_91 = cos_phi*z_12;
    const real z_92 = z_79*z_38 - (z_25*z_90 + z_25*z_91);
    const real z_93 = c_5*z_86 + z_89 + (-z_92);
    const real z_94 = (z_79*z_46 + (z_29*z_90 + z_29*z_91)) - (z_78*z_38 + (z_25*z_88 - z_25*z_87));
    const real z_95 = z_94 - c_6*z_86;
    const real z_96 = c_9*z_93 + z_95*c_10;
    const real z_97 = c_11*z_95 + z_93*c_10;
    const real c_14 = c[40];
    const real z_98 = sin_phi*z_35;
    const real z_99 = (cos_delta*z_2 - z_98) + c_5*(sin_delta*z_88 + z_40*z_78 - sin_delta*z_87) +
        c_6*(sin_delta*z_91 + sin_delta*z_90 - z_40*z_79);
    const real z_100 = (c_5*(z_82*z_40 - sin_delta*z_96) + c_6*(z_83*z_40 + sin_delta*z_97)) +
        2.0*(c_14*(z_84*z_35 - cos_delta*z_99) - 0.5*c_13*z_2);
    const real c_15 = c[41];
    const real c_16 = c[42];
    const real c_17 = c[43];
    const real z_101 = sin_delta*z_84;
    const real z_102 = z_24*z_82 + c_15*z_78 + c_16*z_79 + c_17*z_101 - z_25*z_83;
    const real B_xz = c[21];
    const real z_103 = z_90 + z_91;
    const real c_18 = c[44];
    const real z_104 = z_84*z_40 + sin_delta*z_99;
    const real z_105 = z_88 - z_87;
    const real z_106 = (z_82*z_36 + z_24*z_96) + (z_83*z_38 + z_25*z_97) + 2.0*B_xz*z_103 - 2.0*c_18*z_104 -
        c_15*z_105;
    const real c_19 = c[45];
    const real c_20 = c[46];
    const real z_107 = z_25*z_82 + c_19*z_79 + c_16*z_78 - z_29*z_83 - c_20*z_101;
    const real c_21 = c[47];
    const real z_108 = (z_82*z_38 - z_25*z_96) + (z_83*z_46 - z_29*z_97) + 2.0*B_xz*z_105 - 2.0*c_21*z_104 -
        c_19*z_103;
    const real c_22 = c[48];
    const real c_23 = c[49];
    const real c_24 = c[50];
    const real c_25 = c[51];
    Mdot1[2][2] = (-0.5)*(((z_82*z_27 + z_83*z_30 - cos_delta*z_84*c_12 - sin_phi*c_13)*z_2 + sin_phi*z_100) +
        (z_107*z_91 + z_107*z_90 - z_108*z_79) + z_54*z_53*c_22 + z_61*z_75*c_23 + z_76*z_77*c_24 - (z_102*z_88 -
        z_102*z_87 - z_106*z_78) - z_19*z_15*c_22 - z_33*z_50*c_23 - z_51*z_52*c_24 - sin_phi*c_25*z_2);
    const real c_26 = c[52];
    const real c_27 = c[53];
    const real z_109 = z_78*z_55;
    const real c_28 = c[54];
    const real z_110 = z_79*z_55;
    const real c_29 = c[55];
    const real z_111 = sin_delta*sin_psi;
    const real z_112 = sin_phi*sin_delta;
    const real c_30 = c[56];
    const real z_113 = z_29*c_30;
    const real z_114 = sin_psi*z_113;
    const real z_115 = sin_psi*z_35;
    const real c_31 = c[57];
    const real z_116 = c_31*z_79;
    const real c_32 = c[58];
    const real z_117 = z_24*c_32;
    const real z_118 = sin_psi*z_117;
    const real c_33 = c[59];
    const real z_119 = c_33*z_78;
    const real z_120 = z_25*c_32;
    const real z_121 = sin_psi*z_120;
    const real c_34 = c[60];
    const real z_122 = c_34*z_79;
    const real z_123 = z_25*c_30;
    const real z_124 = sin_psi*z_123;
    const real c_35 = c[61];
    const real z_125 = c_35*z_78;
    Mdot1[0][3] = Mdot1[3][0] = -(c_26*(sin_psi*z_42 - cos_phi*z_55) + c_27*(sin_psi*z_88 + z_109 - sin_psi*z_87)
        + c_29*(z_2*z_111 + sin_psi*z_85 + z_55*z_112) + (z_91*z_114 + z_90*z_114 + z_115*z_116 - z_110*z_113) +
        (z_91*z_121 + z_90*z_121 - z_115*z_122 - z_110*z_120) - c_28*(sin_psi*z_91 + sin_psi*z_90 - z_110) -
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
    Mdot1[1][3] = Mdot1[3][1] = c_27*(cos_psi*z_88 - z_126 - cos_psi*z_87) + c_29*(z_2*z_128 + cos_psi*z_85 -
        z_21*z_112) + c_26*(cos_phi*z_21 + cos_psi*z_42) + (z_91*z_129 + z_127*z_113 + z_90*z_129 + z_130*z_116) +
        (z_91*z_132 + z_127*z_120 + z_90*z_132 - z_130*z_122) - c_28*(cos_psi*z_91 + z_127 + cos_psi*z_90) -
        (z_88*z_131 - z_126*z_117 - z_130*z_119 - z_87*z_131) - (z_88*z_133 + z_130*z_125 - z_126*z_123 -
        z_87*z_133);
    const real z_134 = m_F*z_61 + m_H*z_76;
    const real z_135 = m_F*z_75 + m_H*z_77;
    const real c_36 = c[62];
    const real c_37 = c[63];
    const real z_136 = z_61*c_36 + z_76*c_37;
    const real z_137 = sin_delta*z_136;
    const real z_138 = c_36*z_75 + c_37*z_77;
    const real c_38 = c[64];
    const real c_39 = c[65];
    const real z_139 = z_61*c_38 + z_76*c_39;
    const real z_140 = z_29*z_139;
    const real z_141 = z_139*z_46;
    const real z_142 = c_38*z_75 + c_39*z_77;
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
    const real c_40 = c[66];
    const real c_41 = c[67];
    Mdot1[2][3] = Mdot1[3][2] = 0.5*((z_107*z_8 + sin_theta*z_108) + (z_102*z_12 + cos_theta*z_106) +
        2.0*r_R*((m_B*z_54 + z_134)*z_42 + cos_phi*(m_B*z_53 + z_135)) + 2.0*c_1*(z_134*z_88 - z_134*z_87 -
        z_135*z_78) + 2.0*c_5*(z_2*z_137 + z_136*z_85 - z_138*z_112) + 2.0*(z_91*z_140 + z_90*z_140 + z_79*z_141 +
        z_79*z_143) + 2.0*(z_91*z_147 + z_90*z_147 + z_79*z_149 - z_79*z_148) + 2.0*c_40*(z_54*z_88 - z_54*z_87 -
        z_53*z_78) - 2.0*r_R*(z_134*z_91 + z_134*z_90 + z_135*z_79) - 2.0*(z_88*z_144 - z_78*z_145 - z_87*z_144 -
        z_78*z_146) - 2.0*(z_88*z_150 + z_78*z_151 - z_87*z_150 - z_78*z_152) - 2.0*c_6*(z_2*z_153 + z_139*z_85 -
        z_142*z_112) - 2.0*c_41*(z_54*z_91 + z_54*z_90 + z_53*z_79));
    const real z_154 = z_60*c_10 - z_58*c_11;
    const real z_155 = z_58*c_10 - z_60*c_9;
    const real z_156 = cos_theta*z_27 + sin_theta*z_30;
    const real z_157 = sin_delta*z_156;
    const real z_158 = c_11*z_68 + z_74*c_10;
    const real z_159 = c_9*z_74 + z_68*c_10;
    const real z_160 = sin_delta*z_12;
    const real z_161 = cos_theta*z_40;
    const real z_162 = z_160 - z_161;
    const real z_163 = sin_delta*z_8;
    const real z_164 = sin_theta*z_40;
    const real z_165 = z_163 + z_164;
    const real z_166 = c_5*z_162 - c_6*z_165;
    const real z_167 = z_156*z_40 - sin_delta*z_166;
    const real z_168 = sin_theta*z_24;
    const real z_169 = z_57 + z_168;
    const real z_170 = cos_theta*z_29;
    const real z_171 = z_59 + z_170;
    const real z_172 = r_R*cos_theta + sin_theta*c_1;
    const real z_173 = r_R - z_172;
    const real z_174 = c_*z_169 + r_F*z_171 + z_173;
    const real z_175 = z_H*z_171 + c_7*z_169 + z_173;
    const real z_176 = c_38*z_174 + c_39*z_175;
    const real z_177 = z_29*z_12;
    const real z_178 = c_2*z_69;
    const real z_179 = z_24*z_8;
    const real z_180 = c_3*z_63;
    const real z_181 = z_66 - (z_179 - z_180);
    const real z_182 = z_72 - (z_177 + z_178);
    const real z_183 = r_R*z_12 - c_1*z_8;
    const real z_184 = r_F*z_182 + z_183 - c_*z_181;
    const real z_185 = z_H*z_182 + z_183 - c_7*z_181;
    const real z_186 = c_38*z_184 + c_39*z_185;
    const real z_187 = c_36*z_174 + c_37*z_175;
    const real z_188 = c_36*z_184 + c_37*z_185;
    const real z_189 = m_F*z_174 + m_H*z_175;
    const real z_190 = m_F*z_184 + m_H*z_185;
    const real z_191 = r_R - x_B*sin_theta - c_0*cos_theta;
    const real z_192 = c_0*z_12 - x_B*z_8;
    const real c_42 = c[68];
    const real c_43 = c[69];
    const real z_193 = cos_delta*z_35;
    Mdot1[3][3] = 0.5*(((z_24*z_155 + sin_theta*c_16 - z_25*z_154 - cos_theta*c_15 - c_17*z_157)*z_12 +
        cos_theta*((z_155*z_36 - z_24*z_159) + (z_154*z_38 - z_25*z_158) + 2.0*c_18*z_167 - c_15*z_12 - c_16*z_8))
        + 2.0*(z_187*z_179 + z_168*z_188 - z_187*z_180) + 2.0*(z_176*z_70 + z_176*z_71 + z_59*z_186) +
        2.0*r_R*(z_189*z_12 - cos_theta*z_190) + 2.0*c_41*(z_191*z_12 - cos_theta*z_192) + (m_B*z_192 +
        z_190)*c_42 - ((z_29*z_154 + cos_theta*c_16 - z_25*z_155 - sin_theta*c_19 - c_20*z_157)*z_8 -
        sin_theta*((z_154*z_46 + z_29*z_158) + (z_155*z_38 + z_25*z_159) + 2.0*c_21*z_167 + c_19*z_8 + c_16*z_12))
        - 2.0*(z_176*z_177 + z_176*z_178 - z_170*z_186) - 2.0*(z_187*z_64 - z_187*z_65 - z_57*z_188) -
        2.0*c_1*(z_189*z_8 + sin_theta*z_190) - 2.0*c_40*(z_191*z_8 + sin_theta*z_192) - c_43*z_193);
    const real z_194 = sin_theta*z_21;
    const real z_195 = cos_theta*z_21;
    const real z_196 = cos_psi*z_69;
    const real z_197 = cos_psi*z_63;
    const real z_198 = z_17*z_55;
    const real z_199 = z_18*z_55;
    const real z_200 = c_33*z_18;
    const real z_201 = c_35*z_18;
    const real z_202 = c_31*z_17;
    const real z_203 = c_34*z_17;
    Mdot1[0][4] = Mdot1[4][0] = -(c_27*(cos_psi*z_8 - z_194) + (z_12*z_129 + z_195*z_113 + c_31*z_196) +
        (z_12*z_132 + z_195*z_120 - c_34*z_196) + c_27*(sin_psi*z_11 + z_199 - sin_psi*z_13) + (z_5*z_114 +
        z_9*z_114 + z_198*z_113 - z_115*z_202) + (z_5*z_121 + z_9*z_121 + z_115*z_203 + z_198*z_120) -
        c_28*(cos_psi*z_12 + z_195) - (z_8*z_131 - z_194*z_117 - c_33*z_197) - c_28*(sin_psi*z_5 + sin_psi*z_9 +
        z_198) - (z_8*z_133 + c_35*z_197 - z_194*z_123) - (z_11*z_118 + z_199*z_117 - z_13*z_118 - z_115*z_200) -
        (z_11*z_124 + z_115*z_201 + z_199*z_123 - z_13*z_124));
    const real z_204 = sin_theta*z_55;
    const real z_205 = cos_theta*z_55;
    const real z_206 = sin_psi*z_69;
    const real z_207 = sin_psi*z_63;
    const real z_208 = z_18*z_21;
    const real z_209 = z_17*z_21;
    Mdot1[1][4] = Mdot1[4][1] = -(c_27*(sin_psi*z_8 + z_204) + (z_12*z_114 + c_31*z_206 - z_205*z_113) +
        (z_12*z_121 - c_34*z_206 - z_205*z_120) + c_28*(cos_psi*z_5 + cos_psi*z_9 - z_209) + (z_11*z_131 -
        z_13*z_131 - z_208*z_117 - z_130*z_200) + (z_11*z_133 + z_130*z_201 - z_13*z_133 - z_208*z_123) -
        c_28*(sin_psi*z_12 - z_205) - (z_8*z_118 + z_204*z_117 - c_33*z_207) - c_27*(cos_psi*z_11 - cos_psi*z_13 -
        z_208) - (z_8*z_124 + c_35*z_207 + z_204*z_123) - (z_5*z_129 + z_9*z_129 - z_209*z_113 - z_130*z_202) -
        (z_5*z_132 + z_9*z_132 + z_130*z_203 - z_209*z_120));
    const real z_210 = z_33*c_38 + z_51*c_39;
    const real z_211 = c_38*z_50 + c_39*z_52;
    const real z_212 = z_33*c_36 + z_51*c_37;
    const real z_213 = c_36*z_50 + c_37*z_52;
    const real z_214 = m_F*z_33 + m_H*z_51;
    const real z_215 = m_F*z_50 + m_H*z_52;
    Mdot1[2][4] = Mdot1[4][2] = (-0.5)*(z_100 + 2.0*(z_210*z_177 + z_210*z_178 - z_170*z_211) + 2.0*(z_212*z_64 -
        z_212*z_65 - z_57*z_213) + 2.0*c_1*(z_214*z_8 + sin_theta*z_215) + 2.0*c_40*(z_19*z_8 + sin_theta*z_15) +
        2.0*r_R*(z_134*z_5 + z_134*z_9 - z_135*z_17) + 2.0*(z_11*z_144 - z_13*z_144 - z_18*z_145 - z_18*z_146) +
        2.0*(z_11*z_150 + z_18*z_151 - z_13*z_150 - z_18*z_152) + 2.0*c_41*(z_54*z_5 + z_54*z_9 - z_53*z_17) -
        2.0*(z_212*z_179 + z_168*z_213 - z_212*z_180) - 2.0*(z_210*z_70 + z_210*z_71 + z_59*z_211) -
        2.0*r_R*(z_214*z_12 - cos_theta*z_215) - 2.0*c_1*(z_134*z_11 - z_134*z_13 - z_135*z_18) - 2.0*(z_5*z_140 +
        z_9*z_140 - z_17*z_141 - z_17*z_143) - 2.0*(z_5*z_147 + z_9*z_147 + z_17*z_148 - z_17*z_149) -
        2.0*c_41*(z_19*z_12 - cos_theta*z_15) - 2.0*c_40*(z_54*z_11 - z_54*z_13 - z_53*z_18));
    const real c_44 = c[70];
    const real c_45 = c[71];
    const real z_216 = z_24*c_45;
    const real c_46 = c[72];
    const real z_217 = sin_delta*sin_delta;
    const real z_218 = delta_dot*z_217;
    const real z_219 = cos_theta*z_218;
    const real c_47 = c[73];
    const real z_220 = z_25*c_47;
    const real c_48 = c[74];
    const real c_49 = c[75];
    const real z_221 = z_29*c_47;
    const real c_50 = c[76];
    const real z_222 = sin_theta*z_218;
    const real z_223 = z_25*c_45;
    const real c_51 = c[77];
    Mdot1[3][4] = Mdot1[4][3] = 0.5*(2.0*c_14*(z_156*z_35 + cos_delta*z_166) + 2.0*c_44*z_165 + 2.0*c_49*z_162 -
        c_5*(z_155*z_40 + sin_delta*z_159) - c_6*(z_154*z_40 - sin_delta*z_158) - 2.0*(z_160*z_216 + c_46*z_219 -
        z_161*z_216) - 2.0*(z_160*z_220 - c_48*z_219 - z_161*z_220) - 2.0*(z_163*z_221 + z_164*z_221 - c_50*z_222)
        - 2.0*(z_163*z_223 + c_51*z_222 + z_164*z_223));
    const real z_224 = c_*z_25;
    const real z_225 = r_F*z_29;
    const real z_226 = r_R - z_224 - z_225;
    const real z_227 = r_R - z_29*z_H - z_25*c_7;
    const real z_228 = c_38*z_226 + c_39*z_227;
    const real c_52 = c[78];
    const real z_229 = c_*z_24;
    const real z_230 = z_25*r_F;
    const real z_231 = c_1 - z_229 - z_230;
    const real z_232 = c_1 - z_25*z_H - z_24*c_7;
    const real z_233 = c_36*z_231 + c_37*z_232;
    const real c_53 = c[79];
    const real z_234 = c_36*z_226 + c_37*z_227;
    const real c_54 = c[80];
    const real z_235 = z_25*z_35;
    const real z_236 = c_38*z_231 + c_39*z_232;
    const real c_55 = c[81];
    const real c_56 = c[82];
    const real c_57 = c[83];
    Mdot1[4][4] = (z_228*z_46 - z_29*c_52*z_35) + (z_233*z_36 - z_24*c_53*z_35) + c_56*z_35 - (z_234*z_38 +
        c_54*z_235) - (z_236*z_38 + c_55*z_235) - c_57*z_193;
    const real c_58 = c[84];
    const real z_237 = cos_theta*sin_delta;
    const real z_238 = cos_phi*z_35;
    const real z_239 = cos_delta*z_42;
    const real z_240 = cos_delta*cos_phi;
    const real c_59 = c[85];
    const real z_241 = sin_theta*sin_delta;
    const real z_242 = z_40*z_18;
    const real z_243 = sin_delta*z_18;
    const real z_244 = z_40*z_17;
    const real z_245 = sin_delta*z_17;
    Mdot1[0][5] = Mdot1[5][0] = -(c_58*(cos_psi*z_160 + z_21*z_237 - cos_psi*z_161) + c_29*(sin_psi*z_238 +
        sin_psi*z_239 - z_240*z_55) + c_59*(cos_psi*z_163 + cos_psi*z_164 - z_21*z_241) + c_59*(z_11*z_111 +
        sin_psi*z_242 + z_55*z_243 - z_13*z_111) + c_58*(z_5*z_111 + z_9*z_111 + sin_psi*z_244 + z_55*z_245));
    Mdot1[1][5] = Mdot1[5][1] = -(c_58*(sin_psi*z_160 - sin_psi*z_161 - z_55*z_237) + c_59*(sin_psi*z_163 +
        sin_psi*z_164 + z_55*z_241) - c_29*(z_240*z_21 + cos_psi*z_238 + cos_psi*z_239) - c_58*(z_5*z_128 +
        z_9*z_128 + cos_psi*z_244 - z_21*z_245) - c_59*(z_11*z_128 + cos_psi*z_242 - z_13*z_128 - z_21*z_243));
    Mdot1[2][5] = Mdot1[5][2] = (-0.5)*(c_6*z_96 + c_5*z_97 + 2.0*c_3*(z_212*z_160 - z_212*z_161 - z_213*z_237) +
        2.0*c_6*(z_139*z_238 + z_139*z_239 + z_240*z_142) + 2.0*c_2*(z_210*z_163 + z_210*z_164 + z_211*z_241) +
        2.0*c_4*(z_11*z_137 + z_136*z_242 - z_13*z_137 - z_138*z_243) + 2.0*c_4*(z_5*z_153 + z_9*z_153 +
        z_139*z_244 - z_142*z_245) - 2.0*c_5*(z_136*z_238 + z_136*z_239 + z_240*z_138) - 2.0*c_3*(z_5*z_137 +
        z_9*z_137 + z_136*z_244 - z_138*z_245) - 2.0*c_2*(z_11*z_153 + z_139*z_242 - z_13*z_153 - z_142*z_243) -
        2.0*c_4*(z_212*z_163 + z_212*z_164 + z_213*z_241) - 2.0*c_4*(z_210*z_160 - z_210*z_161 - z_211*z_237));
    const real c_60 = c[86];
    const real c_61 = c[87];
    Mdot1[3][5] = Mdot1[5][3] = 0.5*(c_6*z_159 + c_5*z_158 + 2.0*c_60*(z_217*z_12 - 2.0*cos_delta*z_69) +
        2.0*c_6*(z_176*z_35 - cos_delta*z_186) - 2.0*c_5*(z_187*z_35 - cos_delta*z_188) - 2.0*c_61*(z_217*z_8 +
        2.0*cos_delta*z_63));
    const real c_62 = c[88];
    const real c_63 = c[89];
    const real c_64 = c[90];
    const real z_246 = c_4*z_40;
    const real c_65 = c[91];
    const real c_66 = c[92];
    Mdot1[4][5] = Mdot1[5][4] = (-0.5)*(c_62*z_40 + 2.0*(c_3*z_234*z_40 + c_64*z_218) + 2.0*(z_233*z_246 +
        c_66*z_218) - 2.0*(c_2*z_236*z_40 + c_63*z_218) - 2.0*(z_228*z_246 + c_65*z_218));
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
    const real z_248 = c_6*z_40;
    const real z_249 = cos_phi*z_248 + z_47 - z_42*z_30;
    const real z_250 = c_5*z_40;
    const real z_251 = cos_phi*z_250 + z_39 - z_42*z_27 - z_37;
    const real z_252 = (c_1*z_9 - r_R*z_13) - (z_247 - (r_R*z_11 + c_1*z_5));
    const real z_253 = psi_dot*z_76 + z_H*z_249 + z_252 - c_7*z_251;
    const real z_254 = psi_dot*z_61 + r_F*z_249 + z_252 - c_*z_251;
    const real z_255 = m_H*z_253 + m_F*z_254;
    const real z_256 = psi_dot*z_54 + x_B*z_5 + c_0*z_11 + x_B*z_9 - c_0*z_13 - z_247;
    const real z_257 = m_R*(-z_247) + z_255 + m_B*z_256;
    const real z_258 = psi_dot*sin_phi;
    const real z_259 = x_dot*cos_psi + y_dot*sin_psi;
    const real z_260 = r_R*z_258 + z_259;
    const real z_261 = z_62 - z_259;
    const real z_262 = psi_dot*z_51 + z_H*z_67 + c_7*z_73 - z_261;
    const real z_263 = psi_dot*z_33 + c_*z_73 + r_F*z_67 - z_261;
    const real z_264 = m_H*z_262 + m_F*z_263;
    const real z_265 = psi_dot*z_19 + z_259 - z_53;
    const real z_266 = m_R*z_260 + z_264 + m_B*z_265;
    f1[2] = -(cos_psi*(x_dot*z_257 - y_dot*z_266) + sin_psi*(y_dot*z_257 + x_dot*z_266));
    const real z_267 = phi_dot*cos_theta;
    const real z_268 = c_37*z_253 + c_36*z_254;
    const real z_269 = z_25*z_268;
    const real z_270 = phi_dot*sin_theta;
    const real z_271 = z_24*z_268;
    const real z_272 = c_39*z_253 + c_38*z_254;
    const real z_273 = z_25*z_272;
    const real z_274 = z_29*z_272;
    const real z_275 = sin_phi*z_250 + z_2*z_27 + z_89 - z_92;
    const real z_276 = sin_phi*z_248 + z_2*z_30 - z_94;
    const real z_277 = r_R*z_42;
    const real z_278 = (r_R*z_90 + c_1*z_87) + (r_R*z_91 - (z_277 + c_1*z_88));
    const real z_279 = c_7*z_275 - z_H*z_276 - z_278;
    const real z_280 = c_*z_275 - r_F*z_276 - z_278;
    const real z_281 = c_39*z_279 + c_38*z_280;
    const real z_282 = c_37*z_279 + c_36*z_280;
    const real z_283 = z_270 + psi_dot*z_79;
    const real z_284 = B_xz*z_283;
    const real B_xx = c[18];
    const real z_285 = z_267 - psi_dot*z_78;
    const real H_xz = c[25];
    const real z_286 = theta_dot + z_258;
    const real z_287 = delta_dot*c_5 + z_29*z_283 + z_286*z_30 - z_25*z_285;
    const real z_288 = H_xz*z_287;
    const real H_xx = c[22];
    const real z_289 = z_24*z_285 + z_286*z_27 - delta_dot*c_6 - z_25*z_283;
    const real c_67 = c[93];
    const real z_290 = z_288 - (H_xx*z_289 - z_288) - c_67*z_289;
    const real z_291 = H_xz*z_289;
    const real H_zz = c[24];
    const real c_68 = c[94];
    const real z_292 = z_291 - (H_zz*z_287 - z_291) - c_68*z_287;
    const real c_69 = c[95];
    const real c_70 = c[96];
    const real H_yy = c[23];
    const real z_293 = z_283*z_30 - (cos_delta*z_286 - z_285*z_27);
    const real spin_f_dot = v[7];
    const real z_294 = H_yy*(-z_293) + F_yy*(spin_f_dot - z_293);
    const real z_295 = sin_delta*z_294;
    const real z_296 = z_284 + z_24*z_290 + c_70*z_295 - (B_xx*z_285 - z_284) - z_25*z_292 - c_69*z_285;
    const real z_297 = B_xz*z_285;
    const real B_zz = c[20];
    const real c_71 = c[97];
    const real c_72 = c[98];
    const real z_298 = z_297 + z_29*z_292 + c_72*z_295 - (B_zz*z_283 - z_297) - z_25*z_290 - c_71*z_283;
    const real c_73 = c[99];
    const real c_74 = c[100];
    const real z_299 = z_255*c_74;
    const real z_300 = z_255*c_42;
    const real z_301 = z_268*c_70;
    const real z_302 = z_272*c_72;
    const real z_303 = m_H*z_279 + m_F*z_280;
    const real z_304 = z_303*c_42;
    const real z_305 = z_303*c_74;
    const real c_75 = c[101];
    const real z_306 = c_75*z_63;
    const real c_76 = c[102];
    const real z_307 = c_76*z_69;
    const real z_308 = phi_dot*sin_delta;
    const real z_309 = z_281*c_72;
    const real z_310 = c_75*z_69;
    const real c_77 = c[103];
    const real z_311 = c_77*z_63;
    const real z_312 = z_282*c_70;
    const real c_78 = c[104];
    const real z_313 = z_256*c_78;
    const real c_79 = c[105];
    const real z_314 = z_256*c_79;
    const real z_315 = phi_dot*c_42;
    const real z_316 = z_277 + x_B*z_88 - x_B*z_87 - c_0*z_90 - c_0*z_91;
    const real z_317 = z_316*c_78;
    const real z_318 = z_316*c_79;
    const real c_80 = c[106];
    const real c_81 = c[107];
    const real z_319 = psi_dot*z_262;
    const real z_320 = psi_dot*z_263;
    const real z_321 = c_39*z_319 + c_38*z_320;
    const real z_322 = c_37*z_319 + c_36*z_320;
    const real c_82 = c[108];
    const real c_83 = c[109];
    const real z_323 = z_25*z_281;
    const real z_324 = z_29*z_281;
    const real z_325 = z_25*z_282;
    const real z_326 = z_24*z_282;
    const real c_84 = c[110];
    const real spin_r_dot = v[6];
    const real c_85 = c[111];
    const real c_86 = c[112];
    const real c_87 = c[113];
    const real z_327 = m_H*z_319 + m_F*z_320;
    const real z_328 = psi_dot*z_265;
    const real c_88 = c[114];
    f1[3] = (-0.5)*(sin_phi*(2.0*z_177*z_281 + 2.0*z_64*z_282 + psi_dot*sin_theta*z_296 + c_73 + z_270*z_299 +
        z_267*z_300 + z_40*z_302 + z_8*z_305 + z_281*z_307 + z_282*z_311 + z_308*z_312 + z_267*z_313 + z_270*z_314
        + z_8*z_318 + sin_delta*z_322*c_70 + cos_theta*c_82 + sin_theta*c_83 - 2.0*z_267*z_269 - 2.0*z_270*z_271 -
        2.0*z_270*z_273 - 2.0*z_267*z_274 - 2.0*z_70*z_281 - 2.0*z_179*z_282 - psi_dot*cos_theta*z_298 -
        z_40*z_301 - z_12*z_304 - z_281*z_306 - z_308*z_309 - z_282*z_310 - z_257*z_315 - z_12*z_317 - z_59*c_80 -
        z_170*c_80 - z_57*c_81 - z_168*c_81 - sin_delta*z_321*c_72) - cos_phi*(2.0*z_64*z_268 + 2.0*z_177*z_272 +
        2.0*z_270*z_323 + 2.0*z_267*z_324 + 2.0*z_267*z_325 + 2.0*z_270*z_326 + psi_dot*((2.0*cos_delta*z_294 +
        z_286*c_84 - z_290*z_27 - z_292*z_30) + (spin_r_dot + z_286)*c_85) + 2.0*z_59*z_321 + 2.0*z_170*z_321 +
        2.0*z_57*z_322 + 2.0*z_168*z_322 + sin_phi*c_86*(phi_dot*phi_dot) + c_87*(psi_dot*z_260) + z_8*z_299 +
        z_268*z_311 + z_308*z_301 + z_272*z_307 + z_40*z_312 + z_8*z_314 + (z_303 + m_B*z_316)*z_315 + (m_B*z_328
        + z_327)*c_42 - 2.0*z_179*z_268 - 2.0*z_70*z_272 - z_12*z_300 - z_268*z_310 - z_272*z_306 - z_308*z_302 -
        z_270*z_305 - z_267*z_304 - z_40*z_309 - z_12*z_313 - z_267*z_317 - z_270*z_318 - sin_theta*z_327*c_74 -
        cos_theta*z_327*c_42 - cos_theta*c_78*z_328 - sin_theta*c_79*z_328 - sin_delta*c_88));
    const real z_329 = theta_dot*sin_phi;
    const real z_330 = theta_dot*cos_phi;
    const real z_331 = c_39*z_262 + c_38*z_263;
    const real z_332 = c_37*z_262 + c_36*z_263;
    const real z_333 = theta_dot*z_25;
    const real z_334 = psi_dot*cos_phi;
    const real z_335 = psi_dot*z_253;
    const real z_336 = psi_dot*z_254;
    const real z_337 = c_37*z_335 + c_36*z_336;
    const real z_338 = c_39*z_335 + c_38*z_336;
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
        2.0*sin_phi*z_29*z_321 + 2.0*z_322*z_339 + z_329*z_299 + z_2*z_300 + c_76*z_341 + z_330*z_305 + c_76*z_342
        + c_77*z_346 + z_329*z_314 + z_2*z_313 + z_330*z_318 + z_349*c_74 + psi_dot*z_314 + cos_phi*c_82 -
        2.0*z_329*z_271 - 2.0*z_2*z_269 - 2.0*z_329*z_273 - 2.0*z_2*z_274 - 2.0*z_330*z_323 - 2.0*z_330*z_326 -
        phi_dot*z_296 - z_298*z_334 - 2.0*z_24*z_337 - 2.0*z_25*z_338 - c_75*z_340 - z_42*z_304 - c_75*z_343 -
        c_42*z_344 - c_75*z_345 - z_42*z_317 - c_78*z_347 - c_80*(cos_phi*z_29) - c_81*z_348 - c_42*z_350 -
        c_78*z_351) + cos_theta*(2.0*z_2*z_271 + 2.0*z_2*z_273 + phi_dot*z_298 + z_329*z_300 + c_75*z_341 +
        z_330*z_304 + z_42*z_305 + c_75*z_342 + c_74*z_344 + c_76*z_345 + z_329*z_313 + z_330*z_317 + z_42*z_318 +
        c_79*z_347 + c_80*z_348 + c_81*(z_24*cos_phi) + z_349*c_42 + psi_dot*z_313 + c_74*z_350 + c_79*z_351 -
        2.0*z_329*z_269 - 2.0*z_329*z_274 - 2.0*z_330*z_324 - 2.0*z_42*z_323 - 2.0*z_330*z_325 - 2.0*z_42*z_326 -
        2.0*z_331*z_333 - 2.0*theta_dot*z_24*z_332 - z_296*z_334 - 2.0*z_25*z_337 - 2.0*z_29*z_338 -
        2.0*z_321*z_339 - 2.0*sin_phi*z_24*z_322 - z_2*z_299 - c_77*z_340 - c_77*z_343 - c_75*z_346 - z_2*z_314 -
        cos_phi*c_83));
    const real z_352 = delta_dot*c_75;
    const real z_353 = delta_dot*c_77;
    const real z_354 = delta_dot*c_76;
    const real z_355 = delta_dot*cos_phi;
    const real z_356 = delta_dot*sin_phi;
    f1[5] = (-0.5)*(cos_delta*(c_5*z_286*z_290 + c_6*z_286*z_292 + z_352*(z_268*z_18) + z_352*(z_272*z_17) +
        z_42*z_302 + z_352*(z_281*z_78) + z_2*z_309 + z_352*(z_282*z_79) + z_352*(cos_theta*z_331) +
        z_354*(sin_theta*z_331) + c_72*(z_283*z_294) + c_70*(z_285*z_294) + c_72*(cos_phi*z_321) + sin_phi*c_88 -
        z_353*(z_268*z_17) - z_42*z_301 - z_354*(z_272*z_18) - z_354*(z_281*z_79) - z_353*(z_282*z_78) - z_2*z_312
        - z_352*(sin_theta*z_332) - z_353*(cos_theta*z_332) - c_70*(cos_phi*z_322)) -
        sin_delta*(c_2*(2.0*z_11*z_272 + z_283*z_292 + c_80*z_79 - 2.0*z_13*z_272 - 2.0*z_91*z_281 -
        2.0*z_90*z_281 - 2.0*z_331*z_8 - 2.0*sin_theta*z_338 - 2.0*z_321*z_18) + c_4*(2.0*z_13*z_268 +
        2.0*z_87*z_281 + 2.0*z_91*z_282 + 2.0*z_90*z_282 + 2.0*z_331*z_12 + 2.0*z_332*z_8 + z_283*z_290 +
        z_285*z_292 + 2.0*sin_theta*z_337 + 2.0*z_321*z_17 + 2.0*z_322*z_18 - 2.0*z_11*z_268 - 2.0*z_9*z_272 -
        2.0*z_5*z_272 - 2.0*z_88*z_281 - 2.0*cos_theta*z_338 - c_80*z_78 - c_81*z_79) + c_3*(2.0*z_9*z_268 +
        2.0*z_5*z_268 + 2.0*z_88*z_282 + z_285*z_290 + 2.0*cos_theta*z_337 + c_81*z_78 - 2.0*z_87*z_282 -
        2.0*z_332*z_12 - 2.0*z_322*z_17) + z_355*z_301 + z_356*z_309 - 2.0*z_286*z_294 - z_355*z_302 -
        z_356*z_312));
    f1[6] = em_real(0.0);
    f1[7] = em_real(0.0);
    A1[0][0] = em_real(0.0);
    A1[0][1] = em_real(0.0);
    A1[0][2] = em_real(0.0);
    const real c_89 = c[115];
    const real z_357 = z_84*z_84;
    const real z_358 = 1.0 - z_357;
    const real z_359 = sqrt(z_358);
    const real z_360 = 1.0/z_359;
    const real z_361 = z_84*z_360;
    const real z_362 = r_F*z_361;
    const real z_363 = sin_delta*c_89 + cos_delta*z_362;
    const real c_90 = c[116];
    const real z_364 = c_90*z_361;
    const real c_91 = c[117];
    const real z_365 = c_91*z_361;
    const real z_366 = (sin_theta*z_229 + cos_theta*z_224) + (cos_theta*z_225 + sin_theta*z_230);
    const real z_367 = z_241*z_364 + z_173 + z_366 - z_237*z_365;
    A1[0][3] = cos_phi*z_363 - sin_phi*z_367;
    const real z_368 = r_R*cos_phi;
    const real z_369 = cos_phi*sin_delta;
    const real z_370 = z_368 + z_365*z_369 - cos_phi*z_224 - cos_phi*z_225;
    const real z_371 = cos_phi*c_1 - cos_phi*z_229 - cos_phi*z_230 - z_364*z_369;
    A1[0][4] = sin_theta*z_370 - cos_theta*z_371;
    const real z_372 = sin_phi*c_89 + z_78*z_364 - z_79*z_365;
    const real c_92 = c[118];
    const real c_93 = c[119];
    const real z_373 = c_4*(c_*z_79 + r_F*z_78) - c_92*z_78 - sin_phi*z_362 - c_93*z_79;
    A1[0][5] = cos_delta*z_372 + sin_delta*z_373;
    A1[0][6] = em_real(0.0);
    A1[0][7] = em_real(0.0);
    A1[1][0] = cos_psi;
    A1[1][1] = sin_psi;
    A1[1][2] = em_real(0.0);
    A1[1][3] = em_real(0.0);
    const real c_94 = c[120];
    A1[1][4] = c_94;
    A1[1][5] = em_real(0.0);
    A1[1][6] = c_94;
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
    const real c_95 = c[121];
    const real c_96 = c[122];
    A1[3][5] = c_6*z_380 + c_5*z_376 + c_96*z_237 - c_95*z_241;
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
    A1[4][3] = -(z_368 + c_89*z_112 + z_229*z_78 + z_224*z_79 + z_225*z_79 + z_230*z_78 - sin_theta*z_392 -
        cos_theta*z_393 - r_R*z_79 - c_1*z_78);
    A1[4][4] = -(r_R*z_17 + z_229*z_18 + z_230*z_18 - c_1*z_18 - z_224*z_17 - z_225*z_17 - z_390);
    A1[4][5] = c_5*z_389 + c_89*z_240 + c_95*z_243 + c_96*z_245 - c_6*z_386;
    A1[4][6] = em_real(0.0);
    A1[4][7] = -z_387;
    const real z_394 = z_99*z_360;
    const real z_395 = z_99*z_357/(z_358*z_359);
    const real c_97 = c[123];
    const real c_98 = c[124];
    const real z_396 = ((z_225*z_12 + c_93*z_69) - (z_230*z_8 + c_97*z_63)) - (z_183 + ((z_229*z_8 - c_92*z_63) -
        (z_224*z_12 - c_98*z_69)));
    const real z_397 = z_43*z_361 - z_41*z_361 - z_394*z_369 - z_395*z_369;
    gamma[0] = -(phi_dot*((z_363*z_42 - cos_phi*(c_89*z_40 - r_F*(z_35*z_361 - cos_delta*z_394 -
        cos_delta*z_395))) + (z_367*z_2 + sin_phi*(c_90*(z_163*z_361 + z_164*z_361 + z_394*z_241 + z_395*z_241) +
        c_91*(z_160*z_361 - z_161*z_361 - z_394*z_237 - z_395*z_237) - z_396))) + delta_dot*((z_372*z_35 -
        cos_delta*(c_89*z_2 + c_91*(z_91*z_361 + z_90*z_361 - z_79*z_394 - z_79*z_395) + c_90*(z_88*z_361 +
        z_78*z_394 + z_78*z_395 - z_87*z_361))) - (z_373*z_40 - sin_delta*(c_4*(c_*z_103 - r_F*z_105) + c_92*z_105
        + r_F*(z_2*z_361 + sin_phi*z_394 + sin_phi*z_395) - c_93*z_103))) - theta_dot*((z_370*z_8 -
        sin_theta*(z_277 + (c_98*z_238 - z_224*z_42) + c_91*z_397 - (z_225*z_42 + c_93*z_238))) + (z_371*z_12 +
        cos_theta*(c_1*z_42 + (c_97*z_238 - z_230*z_42) - (c_92*z_238 + z_229*z_42) - c_90*z_397))));
    const real z_398 = x_dot*z_21 - y_dot*z_55;
    gamma[1] = -z_398;
    const real z_399 = x_dot*z_55 + y_dot*z_21;
    gamma[2] = -z_399;
    const real z_400 = z_99*z_361;
    const real z_401 = z_238 + z_239;
    const real z_402 = sin_delta*z_11 + z_242 - sin_delta*z_13;
    const real z_403 = sin_delta*z_5 + sin_delta*z_9 + z_244;
    const real z_404 = z_401 + c_5*z_403 - c_6*z_402;
    const real z_405 = r_F*(z_48*z_359 + z_31*z_400) - r_F*(z_361*(z_374*z_95) + z_361*(z_81*z_404) - z_394*z_375
        - z_395*z_375);
    const real z_406 = z_374*z_400;
    const real z_407 = r_F*(z_406 + z_404*z_359) - r_F*(2.0*z_406 + z_395*(z_84*z_374) - z_404*z_377);
    const real z_408 = r_F*(z_45*z_359 - z_28*z_400) + r_F*(z_361*(z_374*z_93) + z_394*z_379 + z_395*z_379 -
        z_361*(z_80*z_404));
    const real z_409 = c_6*(z_376*z_40 - sin_delta*z_405) + ((z_378*z_35 + cos_delta*z_407) - c_5*(z_380*z_40 +
        sin_delta*z_408));
    const real z_410 = z_378*z_40 - sin_delta*z_407;
    gamma[3] = -(z_398 - psi_dot*((z_384*z_88 + ((z_376*z_38 - z_25*z_405) - (z_380*z_36 - z_24*z_408) -
        c_5*z_410)*z_78 - z_384*z_87) - (z_382*z_2 - sin_phi*z_409) - (z_383*z_91 + z_383*z_90 - ((z_380*z_38 +
        z_25*z_408) + c_6*z_410 - (z_376*z_46 + z_29*z_405))*z_79) - z_49) - theta_dot*(z_409 - z_396) -
        delta_dot*(c_6*z_408 - c_5*z_405 - c_95*z_165 - c_96*z_162) - spin_f_dot*z_407);
    const real z_411 = r_F*(z_74*z_359 + z_60*z_400) + r_F*(z_361*(z_156*z_93) + z_394*z_385 + z_395*z_385 -
        z_361*(z_80*z_166));
    const real z_412 = z_156*z_400;
    const real z_413 = r_F*(z_166*z_359 + z_412) - r_F*(2.0*z_412 + z_395*(z_84*z_156) - z_166*z_377);
    const real z_414 = r_F*(z_68*z_359 - z_58*z_400) + r_F*(z_361*(z_156*z_95) + z_361*(z_81*z_166) - z_394*z_388
        - z_395*z_388);
    const real z_415 = c_5*(z_386*z_40 - sin_delta*z_411) + ((z_387*z_35 + cos_delta*z_413) + c_6*(z_389*z_40 +
        sin_delta*z_414));
    const real z_416 = z_387*z_40 - sin_delta*z_413;
    const real z_417 = (z_389*z_46 - z_29*z_414) + (z_386*z_38 - z_25*z_411) - c_6*z_416;
    const real z_418 = (z_386*z_36 + z_24*z_411) + (z_389*z_38 + z_25*z_414) - c_5*z_416;
    const real z_419 = c_92*z_35;
    const real z_420 = c_98*z_35;
    const real z_421 = c_93*z_35;
    const real z_422 = c_97*z_35;
    gamma[4] = -(z_399 + psi_dot*((z_391*z_2 - sin_phi*z_415) + (z_392*z_91 + z_392*z_90 + z_417*z_79) +
        (z_393*z_88 - z_393*z_87 - z_418*z_78) + z_75) - phi_dot*(z_277 + (z_392*z_8 - sin_theta*z_417) +
        c_1*z_105 + (z_224*z_91 + z_224*z_90 - z_79*z_420) + (z_225*z_91 + z_225*z_90 + z_79*z_421) - (z_393*z_12
        + cos_theta*z_418) - r_R*z_103 - c_89*z_86 - (z_229*z_88 - z_78*z_419 - z_229*z_87) - (z_230*z_88 +
        z_78*z_422 - z_230*z_87)) - theta_dot*(z_415 + c_1*z_14 + (z_224*z_5 + z_224*z_9 + z_17*z_420) +
        (z_225*z_5 + z_225*z_9 - z_17*z_421) - r_R*z_10 - (z_229*z_11 - z_229*z_13 - z_18*z_419) - (z_230*z_11 +
        z_18*z_422 - z_230*z_13)) - delta_dot*(c_5*z_414 + c_6*z_411 + c_95*z_402 + c_96*z_403 - c_89*z_401) -
        spin_f_dot*z_413);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{
    (void)t, (void)c, (void)fault;

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
    (void)t, (void)c, (void)u, (void)memory, (void)flags, (void)fault;

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
    real mu1[N1*N1], Omega1[N1*N1];
    em_congruence(N1, C1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 16, *const s1_dot = dy + 80;
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
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[93])
{
    const real c_99 = c[125];
    M1[0][0] = c_99;
    M1[1][0] = em_real(0.0);
    M1[1][1] = c_99;
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
    const real c_0 = c[26];
    const real cos_theta = em_cos(theta);
    const real z_6 = sin_phi*cos_theta;
    const real z_7 = z_2 - x_B*z_4 - c_0*z_6;
    const real z_8 = m_B*z_7;
    const real m_F = c[9];
    const real c_1 = c[27];
    const real z_9 = c_1*z_4 - (z_2 - r_R*z_6);
    const real c_ = c[1];
    const real c_2 = c[28];
    const real c_3 = c[29];
    const real delta = x[5];
    const real cos_delta = em_cos(delta);
    const real z_11 = c_2 + c_3*cos_delta;
    const real c_4 = c[30];
    const real z_12 = c_4 - cos_delta*c_4;
    const real cos_phi = em_cos(phi);
    const real c_5 = c[31];
    const real sin_delta = em_sin(delta);
    const real z_15 = c_5*sin_delta;
    const real z_16 = z_11*z_4 + z_12*z_6 + cos_phi*z_15;
    const real r_F = c[5];
    const real z_17 = c_3 + c_2*cos_delta;
    const real c_6 = c[32];
    const real z_18 = c_6*sin_delta;
    const real z_19 = z_17*z_6 + z_12*z_4 - cos_phi*z_18;
    const real z_20 = z_9 - (c_*z_16 + r_F*z_19);
    const real z_21 = -z_20;
    const real z_22 = m_F*z_21;
    const real m_H = c[8];
    const real z_H = c[13];
    const real c_7 = c[33];
    const real z_23 = z_19*z_H + z_16*c_7 - z_9;
    const real z_24 = m_H*z_23;
    const real sin_psi = em_sin(psi);
    const real z_26 = x_B*cos_theta - sin_theta*c_0;
    const real z_27 = m_B*z_26;
    const real z_28 = cos_theta*c_1 - r_R*sin_theta;
    const real z_29 = cos_theta*z_12;
    const real z_30 = sin_theta*z_17 - z_29;
    const real z_31 = sin_theta*z_12;
    const real z_32 = cos_theta*z_11 - z_31;
    const real z_33 = z_28 + (r_F*z_30 - c_*z_32);
    const real z_34 = m_F*z_33;
    const real z_35 = z_H*z_30 + z_28 - c_7*z_32;
    const real z_36 = m_H*z_35;
    const real c_8 = c[34];
    const real z_37 = sin_phi*c_8;
    M1[2][0] = cos_psi*z_8 + cos_psi*z_22 + cos_psi*z_24 + cos_psi*z_37 - sin_psi*z_27 - sin_psi*z_34 -
        sin_psi*z_36;
    M1[2][1] = cos_psi*z_27 + sin_psi*z_8 + cos_psi*z_34 + sin_psi*z_22 + cos_psi*z_36 + sin_psi*z_24 +
        sin_psi*z_37;
    const real z_38 = sin_theta*cos_phi;
    const real z_39 = cos_theta*cos_phi;
    const real z_40 = sin_phi*z_15 - z_11*z_38 - z_12*z_39;
    const real c_9 = c[35];
    const real z_41 = z_17*z_39 + z_12*z_38 + sin_phi*z_18;
    const real c_10 = c[36];
    const real z_42 = z_41*c_10 - z_40*c_9;
    const real c_11 = c[37];
    const real z_43 = z_40*c_10 - z_41*c_11;
    const real z_44 = sin_phi*cos_delta + z_38*z_15 - z_39*z_18;
    const real c_12 = c[38];
    const real z_45 = cos_delta*c_12;
    const real c_13 = c[39];
    const real z_46 = (z_42*z_15 + z_43*z_18) - (z_44*z_45 + sin_phi*c_13);
    const real c_15 = c[41];
    const real c_16 = c[42];
    const real c_17 = c[43];
    const real z_47 = sin_delta*z_44;
    const real z_48 = z_11*z_42 + c_15*z_38 + c_16*z_39 + c_17*z_47 - z_12*z_43;
    const real c_19 = c[45];
    const real c_20 = c[46];
    const real z_49 = z_12*z_42 + c_19*z_39 + c_16*z_38 - z_17*z_43 - c_20*z_47;
    const real c_100 = c[126];
    const real c_101 = c[127];
    const real c_102 = c[128];
    const real c_86 = c[112];
    M1[2][2] = 0.5*(z_48*z_38 + z_49*z_39 + c_100*(z_26*z_26) + c_100*(z_7*z_7) + c_101*(z_33*z_33) +
        c_101*(z_21*z_21) + c_102*(z_35*z_35) + c_102*(z_23*z_23) + c_86*(sin_phi*sin_phi) - sin_phi*z_46);
    const real c_26 = c[52];
    const real z_50 = cos_phi*c_26;
    const real c_27 = c[53];
    const real z_51 = sin_psi*c_27;
    const real c_28 = c[54];
    const real z_52 = sin_psi*c_28;
    const real z_53 = sin_phi*sin_delta;
    const real c_29 = c[55];
    const real z_54 = sin_psi*c_29;
    const real c_30 = c[56];
    const real z_55 = z_17*c_30;
    const real z_56 = sin_psi*z_55;
    const real c_32 = c[58];
    const real z_57 = z_11*c_32;
    const real z_58 = sin_psi*z_57;
    const real z_59 = z_12*c_32;
    const real z_60 = sin_psi*z_59;
    const real z_61 = z_12*c_30;
    const real z_62 = sin_psi*z_61;
    M1[3][0] = sin_psi*z_50 + z_39*z_56 + z_38*z_58 + z_39*z_60 + z_38*z_62 - z_38*z_51 - z_39*z_52 - z_53*z_54;
    const real z_63 = cos_psi*c_27;
    const real z_64 = cos_psi*c_28;
    const real z_65 = cos_psi*c_29;
    const real z_66 = cos_psi*z_55;
    const real z_67 = cos_psi*z_57;
    const real z_68 = cos_psi*z_59;
    const real z_69 = cos_psi*z_61;
    M1[3][1] = z_38*z_63 + z_39*z_64 + z_53*z_65 - cos_psi*z_50 - z_39*z_66 - z_38*z_67 - z_39*z_68 - z_38*z_69;
    const real c_38 = c[64];
    const real c_39 = c[65];
    const real z_70 = z_33*c_38 + z_35*c_39;
    const real z_71 = z_17*z_70;
    const real c_36 = c[62];
    const real c_37 = c[63];
    const real z_72 = z_33*c_36 + z_35*c_37;
    const real z_73 = z_11*z_72;
    const real z_74 = z_12*z_72;
    const real z_75 = z_12*z_70;
    const real z_76 = z_34 + z_36;
    const real z_77 = z_27 + z_76;
    const real c_42 = c[68];
    const real z_78 = z_76*c_42;
    const real c_74 = c[100];
    const real z_79 = z_76*c_74;
    const real c_70 = c[96];
    const real z_80 = z_72*c_70;
    const real c_72 = c[98];
    const real z_81 = z_70*c_72;
    const real c_79 = c[105];
    const real z_82 = z_26*c_79;
    const real c_78 = c[104];
    const real z_83 = z_26*c_78;
    M1[3][2] = 0.5*(sin_theta*z_49 + z_39*z_78 + z_38*z_79 + z_53*z_80 + z_38*z_82 + z_39*z_83 - cos_theta*z_48 -
        2.0*z_39*z_71 - 2.0*z_38*z_73 - 2.0*z_39*z_74 - 2.0*z_38*z_75 - cos_phi*z_77*c_42 - z_53*z_81);
    const real z_84 = z_32*c_10 - z_30*c_11;
    const real z_85 = z_30*c_10 - z_32*c_9;
    const real z_86 = cos_theta*sin_delta;
    const real z_87 = sin_theta*sin_delta;
    const real z_88 = c_5*z_86 + c_6*z_87;
    const real z_89 = sin_delta*z_88;
    const real z_90 = z_17*z_84 + cos_theta*c_16 - z_12*z_85 - sin_theta*c_19 - c_20*z_89;
    const real z_91 = z_11*z_85 + sin_theta*c_16 - z_12*z_84 - cos_theta*c_15 - c_17*z_89;
    const real z_92 = cos_theta*z_17;
    const real z_93 = sin_theta*z_11;
    const real z_94 = z_29 + z_93;
    const real z_95 = z_31 + z_92;
    const real z_96 = r_R*cos_theta + sin_theta*c_1;
    const real z_97 = r_R - z_96;
    const real z_98 = c_*z_94 + r_F*z_95 + z_97;
    const real z_99 = z_H*z_95 + c_7*z_94 + z_97;
    const real z_100 = c_38*z_98 + c_39*z_99;
    const real z_101 = c_36*z_98 + c_37*z_99;
    const real z_102 = r_R - x_B*sin_theta - c_0*cos_theta;
    const real z_103 = m_F*z_98 + m_H*z_99;
    const real c_103 = c[129];
    const real z_104 = sin_delta*sin_delta;
    const real z_105 = cos_theta*c_42;
    const real z_106 = sin_theta*c_74;
    const real z_107 = sin_theta*c_79;
    const real z_108 = cos_theta*c_78;
    M1[3][3] = 0.5*(2.0*z_92*z_100 + 2.0*z_93*z_101 + 2.0*z_29*z_101 + 2.0*z_31*z_100 + (c_8 + m_B*z_102 +
        z_103)*c_42 - sin_theta*z_90 - cos_theta*z_91 - c_103*z_104 - z_103*z_105 - z_103*z_106 - z_102*z_107 -
        z_102*z_108);
    M1[4][0] = -(sin_theta*z_63 + cos_theta*z_64 + z_6*z_51 + z_4*z_56 + z_4*z_60 - cos_theta*z_66 -
        sin_theta*z_67 - cos_theta*z_68 - z_4*z_52 - sin_theta*z_69 - z_6*z_58 - z_6*z_62);
    M1[4][1] = -(sin_theta*z_51 + cos_theta*z_52 + z_4*z_64 + z_6*z_67 + z_6*z_69 - cos_theta*z_56 -
        sin_theta*z_58 - cos_theta*z_60 - z_6*z_63 - sin_theta*z_62 - z_4*z_66 - z_4*z_68);
    const real z_109 = z_21*c_38 + z_23*c_39;
    const real z_110 = z_21*c_36 + z_23*c_37;
    const real z_111 = z_22 + z_24;
    M1[4][2] = (-0.5)*(z_46 + 2.0*z_6*z_73 + 2.0*z_6*z_75 + z_111*z_105 + z_111*z_106 + z_7*z_107 + z_7*z_108 +
        z_4*z_78 + z_4*z_83 - 2.0*z_109*z_92 - 2.0*z_110*z_93 - 2.0*z_29*z_110 - 2.0*z_31*z_109 - 2.0*z_4*z_71 -
        2.0*z_4*z_74 - z_6*z_79 - z_6*z_82);
    const real c_104 = c[130];
    const real c_105 = c[131];
    const real c_106 = c[132];
    const real c_107 = c[133];
    M1[4][3] = (-0.5)*(z_85*z_15 + z_84*z_18 + z_88*z_45 + c_107*z_86 + z_17*c_106*z_87 + z_12*c_105*z_87 -
        c_104*z_87 - z_11*c_105*z_86 - z_12*c_106*z_86);
    const real z_112 = c_*z_12;
    const real z_113 = r_F*z_17;
    const real z_114 = r_R - z_112 - z_113;
    const real z_115 = r_R - z_17*z_H - z_12*c_7;
    const real z_116 = c_38*z_114 + c_39*z_115;
    const real z_117 = c_*z_11;
    const real z_118 = z_12*r_F;
    const real z_119 = c_1 - z_117 - z_118;
    const real z_120 = c_1 - z_12*z_H - z_11*c_7;
    const real z_121 = c_36*z_119 + c_37*z_120;
    const real z_122 = c_36*z_114 + c_37*z_115;
    const real z_123 = c_38*z_119 + c_39*z_120;
    const real c_108 = c[134];
    const real c_109 = c[135];
    M1[4][4] = 0.5*(c_108*z_104 + c_109 + (m_F*z_114 + m_H*z_115)*c_42 + c_12*(cos_delta*cos_delta) + (m_F*z_119 +
        m_H*z_120)*c_74 - 2.0*z_17*z_116 - 2.0*z_11*z_121 - 2.0*z_12*z_122 - 2.0*z_12*z_123);
    const real c_58 = c[84];
    const real z_124 = cos_psi*c_58;
    const real z_125 = cos_delta*cos_phi;
    const real c_59 = c[85];
    const real z_126 = cos_psi*c_59;
    const real z_127 = sin_delta*z_6;
    const real z_128 = sin_psi*c_59;
    const real z_129 = sin_delta*z_4;
    const real z_130 = sin_psi*c_58;
    M1[5][0] = z_86*z_124 + z_125*z_54 - z_87*z_126 - z_127*z_128 - z_129*z_130;
    M1[5][1] = z_86*z_130 + z_129*z_124 + z_127*z_126 - z_87*z_128 - z_125*z_65;
    const real c_77 = c[103];
    const real c_76 = c[102];
    const real c_75 = c[101];
    M1[5][2] = 0.5*(c_6*z_42 + z_110*c_77*z_86 + z_125*z_81 + z_72*c_77*z_129 + z_70*c_76*z_127 + z_110*c_75*z_87
        - c_5*z_43 - z_109*c_76*z_87 - z_125*z_80 - z_109*c_75*z_86 - z_72*c_75*z_127 - z_70*c_75*z_129);
    const real c_110 = c[136];
    const real c_111 = c[137];
    M1[5][3] = 0.5*(c_6*z_85 + cos_delta*z_101*c_70 - c_5*z_84 - c_110*(cos_theta*z_104) - c_111*(sin_theta*z_104)
        - cos_delta*z_100*c_72);
    const real c_62 = c[88];
    const real z_131 = sin_delta*c_75;
    M1[5][4] = (-0.5)*(sin_delta*c_62 + sin_delta*z_122*c_77 + z_121*z_131 - sin_delta*z_123*c_76 - z_116*z_131);
    const real c_112 = c[138];
    M1[5][5] = c_112;
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
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[93],
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
    const real c_0 = c[26];
    const real z_39 = shared[4];
    const real z_137 = phi_dot*z_39;
    const real z_4 = shared[5];
    const real z_138 = theta_dot*z_4;
    const real z_139 = z_137 - z_138;
    const real z_140 = z_133 - x_B*z_136 - c_0*z_139;
    const real z_7 = shared[6];
    const real psi_dot = v[2];
    const real sin_psi = shared[7];
    const real z_141 = psi_dot*sin_psi;
    const real m_F = c[9];
    const real z_21 = shared[8];
    const real c_1 = c[27];
    const real z_142 = c_1*z_136 - (z_133 - r_R*z_139);
    const real c_ = c[1];
    const real c_3 = c[29];
    const real delta_dot = v[5];
    const real sin_delta = shared[9];
    const real z_143 = delta_dot*sin_delta;
    const real z_144 = c_3*z_143;
    const real z_11 = shared[10];
    const real z_145 = z_4*z_144 - (z_11*z_134 + z_11*z_135);
    const real c_4 = c[30];
    const real z_146 = c_4*z_143;
    const real z_12 = shared[11];
    const real z_147 = z_6*z_146 + (z_12*z_137 - z_12*z_138);
    const real c_5 = c[31];
    const real cos_delta = shared[12];
    const real z_148 = delta_dot*cos_delta;
    const real z_149 = cos_phi*z_148;
    const real sin_phi = shared[13];
    const real z_150 = phi_dot*sin_delta;
    const real z_151 = sin_phi*z_150;
    const real z_152 = z_149 - z_151;
    const real z_153 = (-z_145) + z_147 + c_5*z_152;
    const real r_F = c[5];
    const real c_6 = c[32];
    const real c_2 = c[28];
    const real z_154 = c_2*z_143;
    const real z_17 = shared[14];
    const real z_155 = (z_6*z_154 + (z_17*z_138 - z_17*z_137)) - (z_4*z_146 + (z_12*z_134 + z_12*z_135));
    const real z_156 = c_6*z_152 + z_155;
    const real z_157 = z_142 - (c_*z_153 - r_F*z_156);
    const real z_158 = -z_157;
    const real m_H = c[8];
    const real z_23 = shared[15];
    const real z_H = c[13];
    const real c_7 = c[33];
    const real z_159 = c_7*z_153 - z_H*z_156 - z_142;
    const real sin_theta = shared[16];
    const real z_160 = theta_dot*sin_theta;
    const real cos_theta = shared[17];
    const real z_161 = theta_dot*cos_theta;
    const real z_162 = x_B*z_160 + c_0*z_161;
    const real z_26 = shared[18];
    const real z_163 = psi_dot*cos_psi;
    const real z_33 = shared[19];
    const real z_164 = r_R*z_161 + c_1*z_160;
    const real z_165 = sin_theta*z_143;
    const real z_166 = z_12*z_160;
    const real z_167 = cos_theta*z_146;
    const real z_168 = z_166 - z_167;
    const real z_169 = (z_17*z_161 - c_2*z_165) + z_168;
    const real z_170 = z_169;
    const real z_171 = cos_theta*z_143;
    const real z_172 = z_12*z_161;
    const real z_173 = sin_theta*z_146;
    const real z_174 = z_172 + z_173;
    const real z_175 = (z_11*z_160 + c_3*z_171) + z_174;
    const real z_176 = z_175;
    const real z_177 = z_164 - (r_F*z_170 + c_*z_176);
    const real z_35 = shared[20];
    const real z_178 = z_164 - z_H*z_170 - c_7*z_176;
    const real c_8 = c[34];
    Mdot1[0][2] = Mdot1[2][0] = m_B*(cos_psi*z_140 - z_7*z_141) + m_B*(sin_psi*z_162 - z_26*z_163) +
        c_8*(cos_psi*z_132 - sin_phi*z_141) - m_F*(z_21*z_141 - cos_psi*z_158) - m_H*(z_23*z_141 - cos_psi*z_159)
        - m_F*(z_33*z_163 - sin_psi*z_177) - m_H*(z_35*z_163 - sin_psi*z_178);
    Mdot1[1][2] = Mdot1[2][1] = -(m_B*(z_26*z_141 + cos_psi*z_162) + m_F*(z_33*z_141 + cos_psi*z_177) +
        m_H*(z_35*z_141 + cos_psi*z_178) - m_B*(sin_psi*z_140 + z_7*z_163) - m_F*(sin_psi*z_158 + z_21*z_163) -
        m_H*(sin_psi*z_159 + z_23*z_163) - c_8*(sin_psi*z_132 + sin_phi*z_163));
    const real z_46 = shared[21];
    const real z_42 = shared[22];
    const real c_9 = c[35];
    const real z_179 = sin_phi*z_148;
    const real z_180 = cos_phi*z_150;
    const real z_181 = z_179 + z_180;
    const real z_182 = phi_dot*z_4;
    const real z_183 = theta_dot*z_39;
    const real z_184 = z_38*z_144 + (z_11*z_182 - z_11*z_183);
    const real z_185 = phi_dot*z_6;
    const real z_186 = theta_dot*z_38;
    const real z_187 = z_39*z_146 - (z_12*z_185 + z_12*z_186);
    const real z_188 = c_5*z_181 + z_184 + (-z_187);
    const real z_189 = (z_39*z_154 + (z_17*z_185 + z_17*z_186)) - (z_38*z_146 + (z_12*z_183 - z_12*z_182));
    const real z_190 = z_189 - c_6*z_181;
    const real c_10 = c[36];
    const real z_191 = c_9*z_188 + z_190*c_10;
    const real z_43 = shared[23];
    const real c_11 = c[37];
    const real z_192 = c_11*z_190 + z_188*c_10;
    const real c_14 = c[40];
    const real z_44 = shared[24];
    const real z_193 = sin_phi*z_143;
    const real z_194 = (cos_delta*z_132 - z_193) + c_5*(sin_delta*z_183 + z_38*z_148 - z_4*z_150) +
        c_6*(sin_delta*z_186 + z_6*z_150 - z_39*z_148);
    const real c_13 = c[39];
    const real z_195 = (c_5*(z_42*z_148 - sin_delta*z_191) + c_6*(z_43*z_148 + sin_delta*z_192)) +
        2.0*(c_14*(z_44*z_143 - cos_delta*z_194) - 0.5*c_13*z_132);
    const real z_48 = shared[25];
    const real B_xz = c[21];
    const real z_196 = z_185 + z_186;
    const real c_18 = c[44];
    const real z_197 = z_44*z_148 + sin_delta*z_194;
    const real c_15 = c[41];
    const real z_198 = z_183 - z_182;
    const real z_199 = (z_42*z_144 + z_11*z_191) + (z_43*z_146 + z_12*z_192) + 2.0*B_xz*z_196 - 2.0*c_18*z_197 -
        c_15*z_198;
    const real z_49 = shared[26];
    const real c_21 = c[47];
    const real c_19 = c[45];
    const real z_200 = (z_42*z_146 - z_12*z_191) + (z_43*z_154 - z_17*z_192) + 2.0*B_xz*z_198 - 2.0*c_21*z_197 -
        c_19*z_196;
    const real c_22 = c[48];
    const real c_23 = c[49];
    const real c_24 = c[50];
    const real c_25 = c[51];
    const real z_201 = phi_dot*sin_phi;
    Mdot1[2][2] = (-0.5)*((z_46*z_132 + sin_phi*z_195) + (z_49*z_186 + z_49*z_185 - z_200*z_39) + z_26*z_162*c_22
        + z_33*z_177*c_23 + z_35*z_178*c_24 - (z_48*z_183 - z_48*z_182 - z_199*z_38) - z_7*z_140*c_22 -
        z_21*z_158*c_23 - z_23*z_159*c_24 - c_25*(cos_phi*z_201));
    const real c_26 = c[52];
    const real c_27 = c[53];
    const real z_202 = z_38*z_163;
    const real c_28 = c[54];
    const real z_203 = z_39*z_163;
    const real c_29 = c[55];
    const real z_53 = shared[27];
    const real z_56 = shared[28];
    const real z_204 = sin_psi*z_143;
    const real c_31 = c[57];
    const real z_205 = c_31*z_39;
    const real z_55 = shared[29];
    const real z_58 = shared[30];
    const real c_33 = c[59];
    const real z_206 = c_33*z_38;
    const real z_57 = shared[31];
    const real z_60 = shared[32];
    const real c_34 = c[60];
    const real z_207 = c_34*z_39;
    const real z_59 = shared[33];
    const real z_62 = shared[34];
    const real c_35 = c[61];
    const real z_208 = c_35*z_38;
    const real z_61 = shared[35];
    Mdot1[0][3] = Mdot1[3][0] = -(c_26*(sin_psi*z_201 - cos_phi*z_163) + c_27*(sin_psi*z_183 + z_202 -
        sin_psi*z_182) + c_29*(sin_psi*z_180 + sin_psi*z_179 + z_163*z_53) + (z_186*z_56 + z_185*z_56 +
        z_204*z_205 - z_203*z_55) + (z_186*z_60 + z_185*z_60 - z_204*z_207 - z_203*z_59) - c_28*(sin_psi*z_186 +
        sin_psi*z_185 - z_203) - (z_183*z_58 + z_202*z_57 - z_204*z_206 - z_182*z_58) - (z_183*z_62 + z_204*z_208
        + z_202*z_61 - z_182*z_62));
    const real z_209 = z_38*z_141;
    const real z_210 = z_39*z_141;
    const real z_66 = shared[36];
    const real z_211 = cos_psi*z_143;
    const real z_67 = shared[37];
    const real z_68 = shared[38];
    const real z_69 = shared[39];
    Mdot1[1][3] = Mdot1[3][1] = c_27*(cos_psi*z_183 - z_209 - cos_psi*z_182) + c_29*(cos_psi*z_180 + cos_psi*z_179
        - z_141*z_53) + c_26*(cos_phi*z_141 + cos_psi*z_201) + (z_186*z_66 + z_210*z_55 + z_185*z_66 +
        z_211*z_205) + (z_186*z_68 + z_210*z_59 + z_185*z_68 - z_211*z_207) - c_28*(cos_psi*z_186 + z_210 +
        cos_psi*z_185) - (z_183*z_67 - z_209*z_57 - z_211*z_206 - z_182*z_67) - (z_183*z_69 + z_211*z_208 -
        z_209*z_61 - z_182*z_69);
    const real z_77 = shared[40];
    const real z_212 = m_F*z_177 + m_H*z_178;
    const real z_76 = shared[41];
    const real z_72 = shared[42];
    const real c_36 = c[62];
    const real c_37 = c[63];
    const real z_213 = c_36*z_177 + c_37*z_178;
    const real z_71 = shared[43];
    const real z_70 = shared[44];
    const real z_214 = z_70*z_154;
    const real c_38 = c[64];
    const real c_39 = c[65];
    const real z_215 = c_38*z_177 + c_39*z_178;
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
    const real c_40 = c[66];
    const real c_41 = c[67];
    Mdot1[2][3] = Mdot1[3][2] = 0.5*((z_49*z_161 + sin_theta*z_200) + (z_48*z_160 + cos_theta*z_199) +
        2.0*r_R*(z_77*z_201 + cos_phi*(m_B*z_162 + z_212)) + 2.0*c_1*(z_76*z_183 - z_76*z_182 - z_212*z_38) +
        2.0*c_5*(z_72*z_180 + z_72*z_179 - z_213*z_53) + 2.0*(z_186*z_71 + z_185*z_71 + z_39*z_214 + z_39*z_216) +
        2.0*(z_186*z_74 + z_185*z_74 + z_39*z_220 - z_39*z_219) + 2.0*c_40*(z_26*z_183 - z_26*z_182 - z_162*z_38)
        - 2.0*r_R*(z_76*z_186 + z_76*z_185 + z_212*z_39) - 2.0*(z_183*z_73 - z_38*z_217 - z_182*z_73 - z_38*z_218)
        - 2.0*(z_183*z_75 + z_38*z_221 - z_182*z_75 - z_38*z_222) - 2.0*c_6*(z_70*z_180 + z_70*z_179 - z_215*z_53)
        - 2.0*c_41*(z_26*z_186 + z_26*z_185 + z_162*z_39));
    const real z_90 = shared[48];
    const real z_84 = shared[49];
    const real z_223 = c_11*z_170 + z_176*c_10;
    const real z_85 = shared[50];
    const real z_224 = c_9*z_176 + z_170*c_10;
    const real z_88 = shared[51];
    const real z_225 = sin_delta*z_160;
    const real z_226 = cos_theta*z_148;
    const real z_227 = z_225 - z_226;
    const real z_228 = sin_delta*z_161;
    const real z_229 = sin_theta*z_148;
    const real z_230 = z_228 + z_229;
    const real z_231 = c_5*z_227 - c_6*z_230;
    const real z_232 = z_88*z_148 - sin_delta*z_231;
    const real c_16 = c[42];
    const real z_91 = shared[52];
    const real z_100 = shared[53];
    const real z_233 = z_17*z_160;
    const real z_234 = c_2*z_171;
    const real z_92 = shared[54];
    const real z_235 = z_11*z_161;
    const real z_236 = c_3*z_165;
    const real z_237 = z_168 - (z_235 - z_236);
    const real z_238 = z_174 - (z_233 + z_234);
    const real z_239 = r_R*z_160 - c_1*z_161;
    const real z_240 = r_F*z_238 + z_239 - c_*z_237;
    const real z_241 = z_H*z_238 + z_239 - c_7*z_237;
    const real z_242 = c_38*z_240 + c_39*z_241;
    const real z_101 = shared[55];
    const real z_93 = shared[56];
    const real z_243 = c_36*z_240 + c_37*z_241;
    const real z_29 = shared[57];
    const real z_31 = shared[58];
    const real z_103 = shared[59];
    const real z_244 = m_F*z_240 + m_H*z_241;
    const real z_102 = shared[60];
    const real z_245 = c_0*z_160 - x_B*z_161;
    const real c_42 = c[68];
    const real c_43 = c[69];
    const real z_246 = cos_delta*z_143;
    Mdot1[3][3] = 0.5*((z_91*z_160 + cos_theta*((z_85*z_144 - z_11*z_224) + (z_84*z_146 - z_12*z_223) +
        2.0*c_18*z_232 - c_15*z_160 - c_16*z_161)) + 2.0*(z_101*z_235 + z_93*z_243 - z_101*z_236) +
        2.0*(z_100*z_172 + z_100*z_173 + z_31*z_242) + 2.0*r_R*(z_103*z_160 - cos_theta*z_244) +
        2.0*c_41*(z_102*z_160 - cos_theta*z_245) + (m_B*z_245 + z_244)*c_42 - (z_90*z_161 - sin_theta*((z_84*z_154
        + z_17*z_223) + (z_85*z_146 + z_12*z_224) + 2.0*c_21*z_232 + c_19*z_161 + c_16*z_160)) - 2.0*(z_100*z_233
        + z_100*z_234 - z_92*z_242) - 2.0*(z_101*z_166 - z_101*z_167 - z_29*z_243) - 2.0*c_1*(z_103*z_161 +
        sin_theta*z_244) - 2.0*c_40*(z_102*z_161 + sin_theta*z_245) - c_43*z_246);
    const real z_247 = sin_theta*z_141;
    const real z_248 = cos_theta*z_141;
    const real z_249 = cos_psi*z_171;
    const real z_250 = cos_psi*z_165;
    const real z_251 = z_4*z_163;
    const real z_252 = z_6*z_163;
    const real z_253 = c_33*z_6;
    const real z_254 = c_35*z_6;
    const real z_255 = c_31*z_4;
    const real z_256 = c_34*z_4;
    Mdot1[0][4] = Mdot1[4][0] = -(c_27*(cos_psi*z_161 - z_247) + (z_160*z_66 + z_248*z_55 + c_31*z_249) +
        (z_160*z_68 + z_248*z_59 - c_34*z_249) + c_27*(sin_psi*z_137 + z_252 - sin_psi*z_138) + (z_134*z_56 +
        z_135*z_56 + z_251*z_55 - z_204*z_255) + (z_134*z_60 + z_135*z_60 + z_204*z_256 + z_251*z_59) -
        c_28*(cos_psi*z_160 + z_248) - (z_161*z_67 - z_247*z_57 - c_33*z_250) - c_28*(sin_psi*z_134 +
        sin_psi*z_135 + z_251) - (z_161*z_69 + c_35*z_250 - z_247*z_61) - (z_137*z_58 + z_252*z_57 - z_138*z_58 -
        z_204*z_253) - (z_137*z_62 + z_204*z_254 + z_252*z_61 - z_138*z_62));
    const real z_257 = sin_theta*z_163;
    const real z_258 = cos_theta*z_163;
    const real z_259 = sin_psi*z_171;
    const real z_260 = sin_psi*z_165;
    const real z_261 = z_6*z_141;
    const real z_262 = z_4*z_141;
    Mdot1[1][4] = Mdot1[4][1] = -(c_27*(sin_psi*z_161 + z_257) + (z_160*z_56 + c_31*z_259 - z_258*z_55) +
        (z_160*z_60 - c_34*z_259 - z_258*z_59) + c_28*(cos_psi*z_134 + cos_psi*z_135 - z_262) + (z_137*z_67 -
        z_138*z_67 - z_261*z_57 - z_211*z_253) + (z_137*z_69 + z_211*z_254 - z_138*z_69 - z_261*z_61) -
        c_28*(sin_psi*z_160 - z_258) - (z_161*z_58 + z_257*z_57 - c_33*z_260) - c_27*(cos_psi*z_137 -
        cos_psi*z_138 - z_261) - (z_161*z_62 + c_35*z_260 + z_257*z_61) - (z_134*z_66 + z_135*z_66 - z_262*z_55 -
        z_211*z_255) - (z_134*z_68 + z_135*z_68 + z_211*z_256 - z_262*z_59));
    const real z_109 = shared[61];
    const real z_263 = c_38*z_158 + c_39*z_159;
    const real z_110 = shared[62];
    const real z_264 = c_36*z_158 + c_37*z_159;
    const real z_111 = shared[63];
    const real z_265 = m_F*z_158 + m_H*z_159;
    Mdot1[2][4] = Mdot1[4][2] = (-0.5)*(z_195 + 2.0*(z_109*z_233 + z_109*z_234 - z_92*z_263) + 2.0*(z_110*z_166 -
        z_110*z_167 - z_29*z_264) + 2.0*c_1*(z_111*z_161 + sin_theta*z_265) + 2.0*c_40*(z_7*z_161 +
        sin_theta*z_140) + 2.0*r_R*(z_76*z_134 + z_76*z_135 - z_212*z_4) + 2.0*(z_137*z_73 - z_138*z_73 -
        z_6*z_217 - z_6*z_218) + 2.0*(z_137*z_75 + z_6*z_221 - z_138*z_75 - z_6*z_222) + 2.0*c_41*(z_26*z_134 +
        z_26*z_135 - z_162*z_4) - 2.0*(z_110*z_235 + z_93*z_264 - z_110*z_236) - 2.0*(z_109*z_172 + z_109*z_173 +
        z_31*z_263) - 2.0*r_R*(z_111*z_160 - cos_theta*z_265) - 2.0*c_1*(z_76*z_137 - z_76*z_138 - z_212*z_6) -
        2.0*(z_134*z_71 + z_135*z_71 - z_4*z_214 - z_4*z_216) - 2.0*(z_134*z_74 + z_135*z_74 + z_4*z_219 -
        z_4*z_220) - 2.0*c_41*(z_7*z_160 - cos_theta*z_140) - 2.0*c_40*(z_26*z_137 - z_26*z_138 - z_162*z_6));
    const real c_44 = c[70];
    const real c_45 = c[71];
    const real z_266 = z_11*c_45;
    const real c_46 = c[72];
    const real z_104 = shared[64];
    const real z_267 = delta_dot*z_104;
    const real z_268 = cos_theta*z_267;
    const real c_47 = c[73];
    const real z_269 = z_12*c_47;
    const real c_48 = c[74];
    const real c_49 = c[75];
    const real z_270 = z_17*c_47;
    const real c_50 = c[76];
    const real z_271 = sin_theta*z_267;
    const real z_272 = z_12*c_45;
    const real c_51 = c[77];
    Mdot1[3][4] = Mdot1[4][3] = 0.5*(2.0*c_14*(z_88*z_143 + cos_delta*z_231) + 2.0*c_44*z_230 + 2.0*c_49*z_227 -
        c_5*(z_85*z_148 + sin_delta*z_224) - c_6*(z_84*z_148 - sin_delta*z_223) - 2.0*(z_225*z_266 + c_46*z_268 -
        z_226*z_266) - 2.0*(z_225*z_269 - c_48*z_268 - z_226*z_269) - 2.0*(z_228*z_270 + z_229*z_270 - c_50*z_271)
        - 2.0*(z_228*z_272 + c_51*z_271 + z_229*z_272));
    const real z_116 = shared[65];
    const real c_52 = c[78];
    const real z_121 = shared[66];
    const real c_53 = c[79];
    const real z_122 = shared[67];
    const real c_54 = c[80];
    const real z_273 = z_12*z_143;
    const real z_123 = shared[68];
    const real c_55 = c[81];
    const real c_56 = c[82];
    const real c_57 = c[83];
    Mdot1[4][4] = (z_116*z_154 - z_17*c_52*z_143) + (z_121*z_144 - z_11*c_53*z_143) + c_56*z_143 - (z_122*z_146 +
        c_54*z_273) - (z_123*z_146 + c_55*z_273) - c_57*z_246;
    const real c_58 = c[84];
    const real z_86 = shared[69];
    const real z_274 = cos_phi*z_143;
    const real z_275 = cos_delta*z_201;
    const real z_125 = shared[70];
    const real c_59 = c[85];
    const real z_87 = shared[71];
    const real z_276 = z_39*z_150;
    const real z_277 = sin_delta*z_138;
    const real z_278 = z_6*z_148;
    const real z_127 = shared[72];
    const real z_279 = z_38*z_150;
    const real z_280 = sin_delta*z_135;
    const real z_281 = z_4*z_148;
    const real z_129 = shared[73];
    Mdot1[0][5] = Mdot1[5][0] = -(c_58*(cos_psi*z_225 + z_141*z_86 - cos_psi*z_226) + c_29*(sin_psi*z_274 +
        sin_psi*z_275 - z_125*z_163) + c_59*(cos_psi*z_228 + cos_psi*z_229 - z_141*z_87) + c_59*(sin_psi*z_276 +
        sin_psi*z_278 + z_163*z_127 - sin_psi*z_277) + c_58*(sin_psi*z_279 + sin_psi*z_280 + sin_psi*z_281 +
        z_163*z_129));
    Mdot1[1][5] = Mdot1[5][1] = -(c_58*(sin_psi*z_225 - sin_psi*z_226 - z_163*z_86) + c_59*(sin_psi*z_228 +
        sin_psi*z_229 + z_163*z_87) - c_29*(z_125*z_141 + cos_psi*z_274 + cos_psi*z_275) - c_58*(cos_psi*z_279 +
        cos_psi*z_280 + cos_psi*z_281 - z_141*z_129) - c_59*(cos_psi*z_276 + cos_psi*z_278 - cos_psi*z_277 -
        z_141*z_127));
    Mdot1[2][5] = Mdot1[5][2] = (-0.5)*(c_6*z_191 + c_5*z_192 + 2.0*c_3*(z_110*z_225 - z_110*z_226 - z_264*z_86) +
        2.0*c_6*(z_70*z_274 + z_70*z_275 + z_125*z_215) + 2.0*c_2*(z_109*z_228 + z_109*z_229 + z_263*z_87) +
        2.0*c_4*(z_72*z_276 + z_72*z_278 - z_72*z_277 - z_213*z_127) + 2.0*c_4*(z_70*z_279 + z_70*z_280 +
        z_70*z_281 - z_215*z_129) - 2.0*c_5*(z_72*z_274 + z_72*z_275 + z_125*z_213) - 2.0*c_3*(z_72*z_279 +
        z_72*z_280 + z_72*z_281 - z_213*z_129) - 2.0*c_2*(z_70*z_276 + z_70*z_278 - z_70*z_277 - z_215*z_127) -
        2.0*c_4*(z_110*z_228 + z_110*z_229 + z_264*z_87) - 2.0*c_4*(z_109*z_225 - z_109*z_226 - z_263*z_86));
    const real c_60 = c[86];
    const real c_61 = c[87];
    Mdot1[3][5] = Mdot1[5][3] = 0.5*(c_6*z_224 + c_5*z_223 + 2.0*c_60*(z_104*z_160 - 2.0*cos_delta*z_171) +
        2.0*c_6*(z_100*z_143 - cos_delta*z_242) - 2.0*c_5*(z_101*z_143 - cos_delta*z_243) - 2.0*c_61*(z_104*z_161
        + 2.0*cos_delta*z_165));
    const real c_62 = c[88];
    const real c_63 = c[89];
    const real c_64 = c[90];
    const real z_282 = c_4*z_148;
    const real c_65 = c[91];
    const real c_66 = c[92];
    Mdot1[4][5] = Mdot1[5][4] = (-0.5)*(c_62*z_148 + 2.0*(z_148*(c_3*z_122) + c_64*z_267) + 2.0*(z_121*z_282 +
        c_66*z_267) - 2.0*(z_148*(c_2*z_123) + c_63*z_267) - 2.0*(z_116*z_282 + c_65*z_267));
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
    const real z_284 = c_6*z_148;
    const real z_285 = cos_phi*z_284 + z_155 - c_6*z_151;
    const real z_286 = c_5*z_148;
    const real z_287 = cos_phi*z_286 + z_147 - c_5*z_151 - z_145;
    const real z_288 = (c_1*z_135 - r_R*z_138) - (z_283 - (r_R*z_137 + c_1*z_134));
    const real z_289 = psi_dot*z_35 + z_H*z_285 + z_288 - c_7*z_287;
    const real z_290 = psi_dot*z_33 + r_F*z_285 + z_288 - c_*z_287;
    const real z_291 = m_H*z_289 + m_F*z_290;
    const real z_292 = psi_dot*z_26 + x_B*z_134 + c_0*z_137 + x_B*z_135 - c_0*z_138 - z_283;
    const real z_293 = m_R*(-z_283) + z_291 + m_B*z_292;
    const real z_294 = psi_dot*sin_phi;
    const real z_295 = x_dot*cos_psi + y_dot*sin_psi;
    const real z_296 = r_R*z_294 + z_295;
    const real z_297 = z_164 - z_295;
    const real z_298 = psi_dot*z_23 + z_H*z_169 + c_7*z_175 - z_297;
    const real z_299 = psi_dot*z_21 + c_*z_175 + r_F*z_169 - z_297;
    const real z_300 = m_H*z_298 + m_F*z_299;
    const real z_301 = psi_dot*z_7 + z_295 - z_162;
    const real z_302 = m_R*z_296 + z_300 + m_B*z_301;
    f1[2] = -(cos_psi*(x_dot*z_293 - y_dot*z_302) + sin_psi*(y_dot*z_293 + x_dot*z_302));
    const real z_303 = phi_dot*cos_theta;
    const real z_304 = c_37*z_289 + c_36*z_290;
    const real z_305 = z_12*z_304;
    const real z_306 = phi_dot*sin_theta;
    const real z_307 = z_11*z_304;
    const real z_308 = c_39*z_289 + c_38*z_290;
    const real z_309 = z_12*z_308;
    const real z_310 = z_17*z_308;
    const real z_311 = sin_phi*z_286 + c_5*z_180 + z_184 - z_187;
    const real z_312 = sin_phi*z_284 + c_6*z_180 - z_189;
    const real z_313 = r_R*z_201;
    const real z_314 = (r_R*z_185 + c_1*z_182) + (r_R*z_186 - (z_313 + c_1*z_183));
    const real z_315 = c_7*z_311 - z_H*z_312 - z_314;
    const real z_316 = c_*z_311 - r_F*z_312 - z_314;
    const real z_317 = c_39*z_315 + c_38*z_316;
    const real z_318 = c_37*z_315 + c_36*z_316;
    const real z_319 = z_306 + psi_dot*z_39;
    const real z_320 = B_xz*z_319;
    const real B_xx = c[18];
    const real z_321 = z_303 - psi_dot*z_38;
    const real H_xz = c[25];
    const real z_322 = theta_dot + z_294;
    const real z_18 = shared[74];
    const real z_323 = delta_dot*c_5 + z_17*z_319 + z_322*z_18 - z_12*z_321;
    const real z_324 = H_xz*z_323;
    const real H_xx = c[22];
    const real z_15 = shared[75];
    const real z_325 = z_11*z_321 + z_322*z_15 - delta_dot*c_6 - z_12*z_319;
    const real c_67 = c[93];
    const real z_326 = z_324 - (H_xx*z_325 - z_324) - c_67*z_325;
    const real z_327 = H_xz*z_325;
    const real H_zz = c[24];
    const real c_68 = c[94];
    const real z_328 = z_327 - (H_zz*z_323 - z_327) - c_68*z_323;
    const real c_69 = c[95];
    const real c_70 = c[96];
    const real H_yy = c[23];
    const real z_329 = z_319*z_18 - (cos_delta*z_322 - z_321*z_15);
    const real spin_f_dot = v[7];
    const real z_330 = H_yy*(-z_329) + F_yy*(spin_f_dot - z_329);
    const real z_331 = sin_delta*z_330;
    const real z_332 = z_320 + z_11*z_326 + c_70*z_331 - (B_xx*z_321 - z_320) - z_12*z_328 - c_69*z_321;
    const real z_333 = B_xz*z_321;
    const real B_zz = c[20];
    const real c_71 = c[97];
    const real c_72 = c[98];
    const real z_334 = z_333 + z_17*z_328 + c_72*z_331 - (B_zz*z_319 - z_333) - z_12*z_326 - c_71*z_319;
    const real c_73 = c[99];
    const real c_74 = c[100];
    const real z_335 = z_291*c_74;
    const real z_336 = z_291*c_42;
    const real z_337 = z_304*c_70;
    const real z_338 = z_308*c_72;
    const real z_339 = m_H*z_315 + m_F*z_316;
    const real z_340 = z_339*c_42;
    const real z_341 = z_339*c_74;
    const real c_75 = c[101];
    const real z_342 = c_75*z_165;
    const real c_76 = c[102];
    const real z_343 = c_76*z_171;
    const real z_344 = z_317*c_72;
    const real z_345 = c_75*z_171;
    const real c_77 = c[103];
    const real z_346 = c_77*z_165;
    const real z_347 = z_318*c_70;
    const real c_78 = c[104];
    const real z_348 = z_292*c_78;
    const real c_79 = c[105];
    const real z_349 = z_292*c_79;
    const real z_350 = phi_dot*c_42;
    const real z_351 = z_313 + x_B*z_183 - x_B*z_182 - c_0*z_185 - c_0*z_186;
    const real z_352 = z_351*c_78;
    const real z_353 = z_351*c_79;
    const real c_80 = c[106];
    const real c_81 = c[107];
    const real z_354 = psi_dot*z_298;
    const real z_355 = psi_dot*z_299;
    const real z_356 = c_39*z_354 + c_38*z_355;
    const real z_357 = c_37*z_354 + c_36*z_355;
    const real c_82 = c[108];
    const real c_83 = c[109];
    const real z_358 = z_12*z_317;
    const real z_359 = z_17*z_317;
    const real z_360 = z_12*z_318;
    const real z_361 = z_11*z_318;
    const real c_84 = c[110];
    const real spin_r_dot = v[6];
    const real c_85 = c[111];
    const real c_86 = c[112];
    const real c_87 = c[113];
    const real z_362 = m_H*z_354 + m_F*z_355;
    const real z_106 = shared[76];
    const real z_105 = shared[77];
    const real z_363 = psi_dot*z_301;
    const real z_108 = shared[78];
    const real z_107 = shared[79];
    const real c_88 = c[114];
    f1[3] = (-0.5)*(sin_phi*(2.0*z_233*z_317 + 2.0*z_166*z_318 + psi_dot*sin_theta*z_332 + c_73 + z_306*z_335 +
        z_303*z_336 + z_148*z_338 + z_161*z_341 + z_317*z_343 + z_318*z_346 + z_150*z_347 + z_303*z_348 +
        z_306*z_349 + z_161*z_353 + sin_delta*z_357*c_70 + cos_theta*c_82 + sin_theta*c_83 - 2.0*z_303*z_305 -
        2.0*z_306*z_307 - 2.0*z_306*z_309 - 2.0*z_303*z_310 - 2.0*z_172*z_317 - 2.0*z_235*z_318 -
        psi_dot*cos_theta*z_334 - z_148*z_337 - z_160*z_340 - z_317*z_342 - z_150*z_344 - z_318*z_345 -
        z_293*z_350 - z_160*z_352 - z_31*c_80 - z_92*c_80 - z_29*c_81 - z_93*c_81 - sin_delta*z_356*c_72) -
        cos_phi*(2.0*z_166*z_304 + 2.0*z_233*z_308 + 2.0*z_306*z_358 + 2.0*z_303*z_359 + 2.0*z_303*z_360 +
        2.0*z_306*z_361 + psi_dot*((2.0*cos_delta*z_330 + z_322*c_84 - z_326*z_15 - z_328*z_18) + (spin_r_dot +
        z_322)*c_85) + 2.0*z_31*z_356 + 2.0*z_92*z_356 + 2.0*z_29*z_357 + 2.0*z_93*z_357 +
        c_86*(sin_phi*(phi_dot*phi_dot)) + c_87*(psi_dot*z_296) + z_161*z_335 + z_304*z_346 + z_150*z_337 +
        z_308*z_343 + z_148*z_347 + z_161*z_349 + (z_339 + m_B*z_351)*z_350 + (m_B*z_363 + z_362)*c_42 -
        2.0*z_235*z_304 - 2.0*z_172*z_308 - z_160*z_336 - z_304*z_345 - z_308*z_342 - z_150*z_338 - z_306*z_341 -
        z_303*z_340 - z_148*z_344 - z_160*z_348 - z_303*z_352 - z_306*z_353 - z_362*z_106 - z_362*z_105 -
        z_363*z_108 - z_363*z_107 - sin_delta*c_88));
    const real z_364 = theta_dot*sin_phi;
    const real z_365 = theta_dot*cos_phi;
    const real z_366 = c_39*z_298 + c_38*z_299;
    const real z_367 = c_37*z_298 + c_36*z_299;
    const real z_368 = theta_dot*z_12;
    const real z_369 = psi_dot*cos_phi;
    const real z_370 = psi_dot*z_289;
    const real z_371 = psi_dot*z_290;
    const real z_372 = c_37*z_370 + c_36*z_371;
    const real z_373 = c_39*z_370 + c_38*z_371;
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
        2.0*sin_phi*z_17*z_356 + 2.0*z_357*z_374 + z_364*z_335 + z_132*z_336 + c_76*z_376 + z_365*z_341 +
        c_76*z_377 + c_77*z_381 + z_364*z_349 + z_132*z_348 + z_365*z_353 + z_384*c_74 + psi_dot*z_349 +
        cos_phi*c_82 - 2.0*z_364*z_307 - 2.0*z_132*z_305 - 2.0*z_364*z_309 - 2.0*z_132*z_310 - 2.0*z_365*z_358 -
        2.0*z_365*z_361 - phi_dot*z_332 - z_334*z_369 - 2.0*z_11*z_372 - 2.0*z_12*z_373 - c_75*z_375 - z_201*z_340
        - c_75*z_378 - c_42*z_379 - c_75*z_380 - z_201*z_352 - c_78*z_382 - c_80*(cos_phi*z_17) - c_81*z_383 -
        c_42*z_385 - c_78*z_386) + cos_theta*(2.0*z_132*z_307 + 2.0*z_132*z_309 + phi_dot*z_334 + z_364*z_336 +
        c_75*z_376 + z_365*z_340 + z_201*z_341 + c_75*z_377 + c_74*z_379 + c_76*z_380 + z_364*z_348 + z_365*z_352
        + z_201*z_353 + c_79*z_382 + c_80*z_383 + c_81*(z_11*cos_phi) + z_384*c_42 + psi_dot*z_348 + c_74*z_385 +
        c_79*z_386 - 2.0*z_364*z_305 - 2.0*z_364*z_310 - 2.0*z_365*z_359 - 2.0*z_201*z_358 - 2.0*z_365*z_360 -
        2.0*z_201*z_361 - 2.0*z_366*z_368 - 2.0*theta_dot*z_11*z_367 - z_332*z_369 - 2.0*z_12*z_372 -
        2.0*z_17*z_373 - 2.0*z_356*z_374 - 2.0*sin_phi*z_11*z_357 - z_132*z_335 - c_77*z_375 - c_77*z_378 -
        c_75*z_381 - z_132*z_349 - cos_phi*c_83));
    const real z_387 = delta_dot*c_75;
    const real z_388 = delta_dot*c_77;
    const real z_389 = delta_dot*c_76;
    const real z_390 = delta_dot*cos_phi;
    const real z_391 = delta_dot*sin_phi;
    f1[5] = (-0.5)*(cos_delta*(c_5*z_322*z_326 + c_6*z_322*z_328 + z_387*(z_304*z_6) + z_387*(z_308*z_4) +
        z_201*z_338 + z_387*(z_317*z_38) + z_132*z_344 + z_387*(z_318*z_39) + z_387*(cos_theta*z_366) +
        z_389*(sin_theta*z_366) + c_72*(z_319*z_330) + c_70*(z_321*z_330) + c_72*(cos_phi*z_356) + sin_phi*c_88 -
        z_388*(z_304*z_4) - z_201*z_337 - z_389*(z_308*z_6) - z_389*(z_317*z_39) - z_388*(z_318*z_38) -
        z_132*z_347 - z_387*(sin_theta*z_367) - z_388*(cos_theta*z_367) - c_70*(cos_phi*z_357)) -
        sin_delta*(c_2*(2.0*z_137*z_308 + z_319*z_328 + c_80*z_39 - 2.0*z_138*z_308 - 2.0*z_186*z_317 -
        2.0*z_185*z_317 - 2.0*z_366*z_161 - 2.0*sin_theta*z_373 - 2.0*z_356*z_6) + c_4*(2.0*z_138*z_304 +
        2.0*z_182*z_317 + 2.0*z_186*z_318 + 2.0*z_185*z_318 + 2.0*z_366*z_160 + 2.0*z_367*z_161 + z_319*z_326 +
        z_321*z_328 + 2.0*sin_theta*z_372 + 2.0*z_356*z_4 + 2.0*z_357*z_6 - 2.0*z_137*z_304 - 2.0*z_135*z_308 -
        2.0*z_134*z_308 - 2.0*z_183*z_317 - 2.0*cos_theta*z_373 - c_80*z_38 - c_81*z_39) + c_3*(2.0*z_135*z_304 +
        2.0*z_134*z_304 + 2.0*z_183*z_318 + z_321*z_326 + 2.0*cos_theta*z_372 + c_81*z_38 - 2.0*z_182*z_318 -
        2.0*z_367*z_160 - 2.0*z_357*z_4) + z_390*z_337 + z_391*z_344 - 2.0*z_322*z_330 - z_390*z_338 -
        z_391*z_347));
    f1[6] = em_real(0.0);
    f1[7] = em_real(0.0);
    A1[0][0] = em_real(0.0);
    A1[0][1] = em_real(0.0);
    A1[0][2] = em_real(0.0);
    const real c_89 = c[115];
    const real z_392 = z_44*z_44;
    const real z_393 = 1.0 - z_392;
    const real z_394 = sqrt(z_393);
    const real z_395 = 1.0/z_394;
    const real z_396 = z_44*z_395;
    const real z_397 = r_F*z_396;
    const real z_398 = sin_delta*c_89 + cos_delta*z_397;
    const real c_90 = c[116];
    const real z_399 = c_90*z_396;
    const real c_91 = c[117];
    const real z_400 = c_91*z_396;
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
    const real z_406 = cos_phi*c_1 - cos_phi*z_117 - cos_phi*z_118 - z_399*z_404;
    A1[0][4] = sin_theta*z_405 - cos_theta*z_406;
    const real z_407 = sin_phi*c_89 + z_38*z_399 - z_39*z_400;
    const real c_92 = c[118];
    const real c_93 = c[119];
    const real z_408 = c_4*(c_*z_39 + r_F*z_38) - c_92*z_38 - sin_phi*z_397 - c_93*z_39;
    A1[0][5] = cos_delta*z_407 + sin_delta*z_408;
    A1[0][6] = em_real(0.0);
    A1[0][7] = em_real(0.0);
    A1[1][0] = cos_psi;
    A1[1][1] = sin_psi;
    A1[1][2] = em_real(0.0);
    A1[1][3] = em_real(0.0);
    const real c_94 = c[120];
    A1[1][4] = c_94;
    A1[1][5] = em_real(0.0);
    A1[1][6] = c_94;
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
    const real c_95 = c[121];
    const real c_96 = c[122];
    A1[3][5] = c_6*z_415 + c_5*z_411 + c_96*z_86 - c_95*z_87;
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
    A1[4][3] = -(z_403 + c_89*z_53 + z_117*z_38 + z_112*z_39 + z_113*z_39 + z_118*z_38 - sin_theta*z_427 -
        cos_theta*z_428 - r_R*z_39 - c_1*z_38);
    A1[4][4] = -(r_R*z_4 + z_117*z_6 + z_118*z_6 - c_1*z_6 - z_112*z_4 - z_113*z_4 - z_425);
    A1[4][5] = c_5*z_424 + c_89*z_125 + c_95*z_127 + c_96*z_129 - c_6*z_421;
    A1[4][6] = em_real(0.0);
    A1[4][7] = -z_422;
    const real z_429 = z_194*z_395;
    const real z_430 = z_194*z_392/(z_393*z_394);
    const real c_97 = c[123];
    const real c_98 = c[124];
    const real z_431 = ((z_113*z_160 + c_93*z_171) - (z_118*z_161 + c_97*z_165)) - (z_239 + ((z_117*z_161 -
        c_92*z_165) - (z_112*z_160 - c_98*z_171)));
    const real z_432 = z_151*z_396 - z_149*z_396 - z_429*z_404 - z_430*z_404;
    gamma[0] = -(phi_dot*((z_398*z_201 - cos_phi*(c_89*z_148 - r_F*(z_143*z_396 - cos_delta*z_429 -
        cos_delta*z_430))) + (z_402*z_132 + sin_phi*(c_90*(z_228*z_396 + z_229*z_396 + z_87*z_429 + z_87*z_430) +
        c_91*(z_225*z_396 - z_226*z_396 - z_86*z_429 - z_86*z_430) - z_431))) + delta_dot*((z_407*z_143 -
        cos_delta*(c_89*z_132 + c_91*(z_186*z_396 + z_185*z_396 - z_39*z_429 - z_39*z_430) + c_90*(z_183*z_396 +
        z_38*z_429 + z_38*z_430 - z_182*z_396))) - (z_408*z_148 - sin_delta*(c_4*(c_*z_196 - r_F*z_198) +
        c_92*z_198 + r_F*(z_396*z_132 + sin_phi*z_429 + sin_phi*z_430) - c_93*z_196))) - theta_dot*((z_405*z_161 -
        sin_theta*(z_313 + (c_98*z_274 - z_112*z_201) + c_91*z_432 - (z_113*z_201 + c_93*z_274))) + (z_406*z_160 +
        cos_theta*(c_1*z_201 + (c_97*z_274 - z_118*z_201) - (c_92*z_274 + z_117*z_201) - c_90*z_432))));
    const real z_433 = x_dot*z_141 - y_dot*z_163;
    gamma[1] = -z_433;
    const real z_434 = x_dot*z_163 + y_dot*z_141;
    gamma[2] = -z_434;
    const real z_435 = z_194*z_396;
    const real z_436 = z_274 + z_275;
    const real z_437 = z_276 + z_278 - z_277;
    const real z_438 = z_279 + z_280 + z_281;
    const real z_439 = z_436 + c_5*z_438 - c_6*z_437;
    const real z_440 = r_F*(z_156*z_394 + z_19*z_435) - r_F*(z_396*(z_409*z_190) + z_396*(z_41*z_439) -
        z_429*z_410 - z_430*z_410);
    const real z_441 = z_409*z_435;
    const real z_442 = r_F*(z_441 + z_439*z_394) - r_F*(2.0*z_441 + z_430*(z_44*z_409) - z_439*z_412);
    const real z_443 = r_F*(z_153*z_394 - z_16*z_435) + r_F*(z_396*(z_409*z_188) + z_429*z_414 + z_430*z_414 -
        z_396*(z_40*z_439));
    const real z_444 = c_6*(z_411*z_148 - sin_delta*z_440) + ((z_413*z_143 + cos_delta*z_442) - c_5*(z_415*z_148 +
        sin_delta*z_443));
    const real z_445 = z_413*z_148 - sin_delta*z_442;
    gamma[3] = -(z_433 - psi_dot*((z_419*z_183 + ((z_411*z_146 - z_12*z_440) - (z_415*z_144 - z_11*z_443) -
        c_5*z_445)*z_38 - z_419*z_182) - (z_417*z_132 - sin_phi*z_444) - (z_418*z_186 + z_418*z_185 -
        ((z_415*z_146 + z_12*z_443) + c_6*z_445 - (z_411*z_154 + z_17*z_440))*z_39) - z_157) - theta_dot*(z_444 -
        z_431) - delta_dot*(c_6*z_443 - c_5*z_440 - c_95*z_230 - c_96*z_227) - spin_f_dot*z_442);
    const real z_446 = r_F*(z_176*z_394 + z_32*z_435) + r_F*(z_396*(z_88*z_188) + z_429*z_420 + z_430*z_420 -
        z_396*(z_40*z_231));
    const real z_447 = z_88*z_435;
    const real z_448 = r_F*(z_231*z_394 + z_447) - r_F*(2.0*z_447 + z_430*(z_44*z_88) - z_231*z_412);
    const real z_449 = r_F*(z_170*z_394 - z_30*z_435) + r_F*(z_396*(z_88*z_190) + z_396*(z_41*z_231) - z_429*z_423
        - z_430*z_423);
    const real z_450 = c_5*(z_421*z_148 - sin_delta*z_446) + ((z_422*z_143 + cos_delta*z_448) + c_6*(z_424*z_148 +
        sin_delta*z_449));
    const real z_451 = z_422*z_148 - sin_delta*z_448;
    const real z_452 = (z_424*z_154 - z_17*z_449) + (z_421*z_146 - z_12*z_446) - c_6*z_451;
    const real z_453 = (z_421*z_144 + z_11*z_446) + (z_424*z_146 + z_12*z_449) - c_5*z_451;
    const real z_454 = c_92*z_143;
    const real z_455 = c_98*z_143;
    const real z_456 = c_93*z_143;
    const real z_457 = c_97*z_143;
    gamma[4] = -(z_434 + psi_dot*((z_426*z_132 - sin_phi*z_450) + (z_427*z_186 + z_427*z_185 + z_452*z_39) +
        (z_428*z_183 - z_428*z_182 - z_453*z_38) + z_177) - phi_dot*(z_313 + (z_427*z_161 - sin_theta*z_452) +
        c_1*z_198 + (z_112*z_186 + z_112*z_185 - z_39*z_455) + (z_113*z_186 + z_113*z_185 + z_39*z_456) -
        (z_428*z_160 + cos_theta*z_453) - r_R*z_196 - c_89*z_181 - (z_117*z_183 - z_38*z_454 - z_117*z_182) -
        (z_118*z_183 + z_38*z_457 - z_118*z_182)) - theta_dot*(z_450 + c_1*z_139 + (z_112*z_134 + z_112*z_135 +
        z_4*z_455) + (z_113*z_134 + z_113*z_135 - z_4*z_456) - r_R*z_136 - (z_117*z_137 - z_117*z_138 - z_6*z_454)
        - (z_118*z_137 + z_6*z_457 - z_118*z_138)) - delta_dot*(c_5*z_449 + c_6*z_446 + c_95*z_437 + c_96*z_438 -
        c_89*z_436) - spin_f_dot*z_448);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    (void)t, (void)c, (void)u, (void)flags, (void)fault;
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

extern em_lanes bicycle_lanes;
em_lanes bicycle_lanes = {EM_LANES, rhs_on_lanes, velocity_on_lanes, NULL};

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
    const double x_B = c[10];
    const double theta = x[4];
    const double cos_theta = em_cos(theta);
    const double sin_theta = em_sin(theta);
    const double c_0 = c[26];
    const double z_2 = x_B*cos_theta - sin_theta*c_0;
    const double m_B = c[7];
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    const double z_4 = m_B*cos_psi;
    const double r_R = c[4];
    const double phi = x[3];
    const double sin_phi = em_sin(phi);
    const double z_6 = r_R*sin_phi;
    const double z_7 = sin_phi*sin_theta;
    const double z_8 = sin_phi*cos_theta;
    const double z_9 = z_6 - x_B*z_7 - c_0*z_8;
    const double sin_psi = em_sin(psi);
    const double z_11 = m_B*sin_psi;
    const double r_F = c[5];
    const double c_3 = c[29];
    const double c_2 = c[28];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_13 = c_2*cos_delta;
    const double z_14 = c_3 + z_13;
    const double z_15 = sin_theta*z_14;
    const double c_4 = c[30];
    const double z_16 = cos_delta*c_4;
    const double z_17 = c_4 - z_16;
    const double z_18 = cos_theta*z_17;
    const double z_19 = z_15 - z_18;
    const double c_ = c[1];
    const double z_20 = c_3*cos_delta;
    const double z_21 = c_2 + z_20;
    const double z_22 = cos_theta*z_21;
    const double z_23 = sin_theta*z_17;
    const double z_24 = z_22 - z_23;
    const double c_1 = c[27];
    const double z_25 = cos_theta*c_1 - r_R*sin_theta;
    const double z_26 = r_F*z_19 + z_25 - c_*z_24;
    const double m_F = c[9];
    const double z_27 = m_F*cos_psi;
    const double z_28 = z_21*z_7;
    const double z_29 = z_17*z_8;
    const double cos_phi = em_cos(phi);
    const double c_5 = c[31];
    const double sin_delta = em_sin(delta);
    const double z_32 = c_5*sin_delta;
    const double z_33 = z_28 + z_29 + cos_phi*z_32;
    const double z_34 = z_14*z_8;
    const double z_35 = z_17*z_7;
    const double c_6 = c[32];
    const double z_36 = c_6*sin_delta;
    const double z_37 = z_34 + z_35 - cos_phi*z_36;
    const double z_38 = c_1*z_7 - (z_6 - r_R*z_8);
    const double z_39 = c_*z_33 + r_F*z_37 - z_38;
    const double z_40 = m_F*sin_psi;
    const double z_H = c[13];
    const double c_7 = c[33];
    const double z_41 = z_H*z_19 + z_25 - c_7*z_24;
    const double m_H = c[8];
    const double z_42 = m_H*cos_psi;
    const double z_43 = z_37*z_H + z_33*c_7 - z_38;
    const double z_44 = m_H*sin_psi;
    const double c_8 = c[34];
    const double z_45 = sin_phi*sin_psi;
    dM[144] = dM[130] = -(z_2*z_4 + z_9*z_11 + z_26*z_27 + z_39*z_40 + z_41*z_42 + z_43*z_44 + c_8*z_45);
    const double z_46 = sin_phi*cos_psi;
    dM[145] = dM[138] = z_9*z_4 + z_39*z_27 + z_43*z_42 + c_8*z_46 - z_2*z_11 - z_26*z_40 - z_41*z_44;
    const double z_47 = sin_theta*cos_phi;
    const double c_27 = c[53];
    const double z_48 = cos_psi*c_27;
    const double z_49 = cos_theta*cos_phi;
    const double c_28 = c[54];
    const double z_50 = cos_psi*c_28;
    const double z_51 = sin_phi*sin_delta;
    const double c_29 = c[55];
    const double z_52 = cos_psi*c_29;
    const double c_26 = c[52];
    const double z_53 = cos_psi*cos_phi;
    const double z_54 = z_14*z_49;
    const double c_30 = c[56];
    const double z_55 = cos_psi*c_30;
    const double z_56 = z_21*z_47;
    const double c_32 = c[58];
    const double z_57 = cos_psi*c_32;
    const double z_58 = z_17*z_49;
    const double z_59 = z_17*z_47;
    dM[152] = dM[131] = -(z_47*z_48 + z_49*z_50 + z_51*z_52 - c_26*z_53 - z_54*z_55 - z_56*z_57 - z_58*z_57 -
        z_59*z_55);
    const double z_60 = cos_phi*sin_psi;
    const double z_61 = sin_psi*c_27;
    const double z_62 = sin_psi*c_28;
    const double z_63 = sin_psi*c_29;
    const double z_64 = sin_psi*c_30;
    const double z_65 = sin_psi*c_32;
    dM[153] = dM[139] = c_26*z_60 + z_54*z_64 + z_56*z_65 + z_58*z_65 + z_59*z_64 - z_47*z_61 - z_49*z_62 -
        z_51*z_63;
    const double z_66 = cos_theta*z_14;
    const double z_67 = sin_theta*z_21;
    const double z_68 = z_14*z_7;
    const double z_69 = z_21*z_8;
    dM[160] = dM[132] = sin_theta*z_61 + cos_theta*z_62 + z_7*z_50 + z_69*z_57 + z_29*z_55 - z_66*z_64 - z_67*z_65
        - z_18*z_65 - z_8*z_48 - z_23*z_64 - z_68*z_55 - z_35*z_57;
    dM[161] = dM[140] = -(sin_theta*z_48 + cos_theta*z_50 + z_8*z_61 + z_68*z_64 + z_35*z_65 - z_66*z_55 -
        z_67*z_57 - z_18*z_57 - z_7*z_62 - z_23*z_55 - z_69*z_65 - z_29*z_64);
    const double z_70 = cos_theta*sin_delta;
    const double c_58 = c[84];
    const double z_71 = sin_psi*c_58;
    const double z_72 = sin_theta*sin_delta;
    const double c_59 = c[85];
    const double z_73 = sin_psi*c_59;
    const double z_74 = cos_delta*cos_phi;
    const double z_75 = sin_delta*z_7;
    const double z_76 = cos_psi*c_58;
    const double z_77 = sin_delta*z_8;
    const double z_78 = cos_psi*c_59;
    dM[168] = dM[133] = -(z_70*z_71 + z_75*z_76 + z_77*z_78 - z_72*z_73 - z_74*z_52);
    dM[169] = dM[141] = z_70*z_76 + z_74*z_63 - z_72*z_78 - z_77*z_73 - z_75*z_71;
    const double z_79 = r_R*cos_phi;
    const double z_80 = z_79 - x_B*z_47 - c_0*z_49;
    const double z_81 = z_54 + z_59 + sin_phi*z_36;
    const double z_82 = sin_phi*z_32 - z_56 - z_58;
    const double z_83 = c_1*z_47 - (z_79 - r_R*z_49);
    const double z_84 = r_F*z_81 - c_*z_82 - z_83;
    const double z_85 = z_H*z_81 - c_7*z_82 - z_83;
    dM[208] = dM[194] = z_80*z_4 + z_84*z_27 + z_85*z_42 + c_8*z_53;
    dM[209] = dM[202] = z_80*z_11 + z_84*z_40 + z_85*z_44 + c_8*z_60;
    const double c_9 = c[35];
    const double c_10 = c[36];
    const double z_86 = z_81*c_10 - z_82*c_9;
    const double c_11 = c[37];
    const double z_87 = z_82*c_10 - z_81*c_11;
    const double z_88 = sin_phi*cos_delta;
    const double z_89 = z_88 + z_47*z_32 - z_49*z_36;
    const double z_90 = cos_delta*z_89;
    const double c_12 = c[38];
    const double c_13 = c[39];
    const double z_91 = z_33*c_9 + z_37*c_10;
    const double z_92 = z_37*c_11 + z_33*c_10;
    const double z_93 = z_74 + c_6*z_77 - c_5*z_75;
    const double z_94 = cos_delta*c_12;
    const double z_95 = (z_91*z_32 - z_92*z_36) + (z_93*z_94 + cos_phi*c_13);
    const double c_15 = c[41];
    const double c_16 = c[42];
    const double z_96 = c_16*z_49;
    const double c_17 = c[43];
    const double z_97 = sin_delta*c_17;
    const double z_98 = z_21*z_86 + c_15*z_47 + z_96 + z_89*z_97 - z_17*z_87;
    const double z_99 = z_21*z_91 + z_17*z_92 + c_15*z_7 + c_16*z_8 - z_93*z_97;
    const double c_19 = c[45];
    const double z_100 = c_16*z_47;
    const double c_20 = c[46];
    const double z_101 = sin_delta*c_20;
    const double z_102 = z_17*z_86 + c_19*z_49 + z_100 - z_14*z_87 - z_89*z_101;
    const double z_103 = z_17*z_91 + z_14*z_92 + c_19*z_8 + c_16*z_7 + z_93*z_101;
    const double c_22 = c[48];
    const double z_104 = z_9*c_22;
    const double c_23 = c[49];
    const double z_105 = z_39*c_23;
    const double c_24 = c[50];
    const double z_106 = z_43*c_24;
    const double c_25 = c[51];
    dM[210] = 0.5*(z_80*z_104 + z_84*z_105 + z_85*z_106 + c_25*(sin_phi*cos_phi) - (cos_phi*(z_86*z_32 + z_87*z_36
        - z_90*c_12 - sin_phi*c_13) - sin_phi*z_95) - (z_98*z_7 + z_99*z_47) - (z_102*z_8 + z_103*z_49));
    const double z_107 = cos_phi*sin_delta;
    const double z_108 = z_107*z_63;
    const double z_109 = (z_29*z_65 + z_35*z_64) - ((z_7*z_61 + z_8*z_62) - (z_34*z_64 + z_28*z_65));
    dM[216] = dM[195] = -(c_26*z_45 + z_108 + z_109);
    const double z_110 = z_107*z_52;
    const double z_111 = (z_29*z_57 + z_35*z_55) - ((z_7*z_48 + z_8*z_50) - (z_34*z_55 + z_28*z_57));
    dM[217] = dM[203] = -(-z_110 - c_26*z_46 - z_111);
    const double c_38 = c[64];
    const double c_39 = c[65];
    const double z_112 = z_26*c_38 + z_41*c_39;
    const double z_113 = z_34*z_112;
    const double c_36 = c[62];
    const double c_37 = c[63];
    const double z_114 = z_26*c_36 + z_41*c_37;
    const double z_115 = z_28*z_114;
    const double z_116 = z_29*z_114;
    const double z_117 = z_35*z_112;
    const double z_118 = m_F*z_26 + m_H*z_41;
    const double c_42 = c[68];
    const double z_119 = (m_B*z_2 + z_118)*c_42;
    const double z_120 = z_118*z_8;
    const double z_121 = z_118*z_7;
    const double c_74 = c[100];
    const double z_122 = z_114*z_107;
    const double c_70 = c[96];
    const double z_123 = z_112*z_107;
    const double c_72 = c[98];
    const double z_124 = z_2*z_7;
    const double c_79 = c[105];
    const double z_125 = z_2*z_8;
    const double c_78 = c[104];
    dM[218] = dM[211] = (-0.5)*(sin_theta*z_103 + z_120*c_42 + z_121*c_74 + z_123*c_72 + z_124*c_79 + z_125*c_78 -
        cos_theta*z_99 - 2.0*z_113 - 2.0*z_115 - 2.0*z_116 - 2.0*z_117 - sin_phi*z_119 - z_122*c_70);
    const double z_126 = z_21*z_49;
    const double z_127 = z_14*z_47;
    dM[224] = dM[196] = z_47*z_62 + z_126*z_65 + z_58*z_64 - z_49*z_61 - z_127*z_64 - z_59*z_65;
    dM[225] = dM[204] = z_49*z_48 + z_127*z_55 + z_59*z_57 - z_47*z_50 - z_126*z_57 - z_58*z_55;
    const double z_128 = c_38*z_84 + c_39*z_85;
    const double z_129 = c_36*z_84 + c_37*z_85;
    const double z_130 = z_112*z_127;
    const double z_131 = z_59*z_114;
    const double z_132 = z_114*z_126;
    const double z_133 = z_58*z_112;
    const double z_134 = m_F*z_84 + m_H*z_85;
    const double z_135 = cos_theta*c_42;
    const double z_136 = sin_theta*c_74;
    const double z_137 = z_118*z_49;
    const double z_138 = z_118*z_47;
    const double z_139 = z_2*z_49;
    const double z_140 = z_2*z_47;
    dM[226] = dM[212] = 0.5*(z_95 + 2.0*z_66*z_128 + 2.0*z_67*z_129 + 2.0*z_18*z_129 + 2.0*z_23*z_128 + 2.0*z_130
        + 2.0*z_131 + z_137*c_74 + z_139*c_79 - 2.0*z_132 - 2.0*z_133 - z_134*z_135 - z_134*z_136 -
        sin_theta*z_80*c_79 - cos_theta*z_80*c_78 - z_138*c_42 - z_140*c_78);
    const double z_141 = sin_delta*z_49;
    const double z_142 = sin_delta*z_47;
    dM[232] = dM[197] = -(z_88*z_63 + z_73*z_141 + z_71*z_142);
    dM[233] = dM[205] = z_88*z_52 + z_76*z_142 + z_78*z_141;
    const double c_77 = c[103];
    const double z_143 = z_88*z_112;
    const double c_76 = c[102];
    const double z_144 = z_88*z_114;
    const double c_75 = c[101];
    dM[234] = dM[213] = (-0.5)*(c_6*z_91 + c_5*z_92 + z_143*c_72 + z_128*c_76*z_72 + z_128*c_75*z_70 +
        z_114*c_75*z_141 + z_112*c_75*z_142 - z_129*c_77*z_70 - z_144*c_70 - z_114*c_77*z_142 - z_112*c_76*z_141 -
        z_129*c_75*z_72);
    const double R_yy = c[15];
    dM[242] = dM[214] = cos_phi*R_yy;
    const double F_yy = c[17];
    dM[250] = dM[215] = F_yy*z_93;
    const double z_145 = x_B*z_8 - c_0*z_7;
    const double z_146 = z_35 - z_69;
    const double z_147 = z_29 - z_68;
    const double z_148 = c_1*z_8 - r_R*z_7;
    const double z_149 = c_*z_146 + z_148 - r_F*z_147;
    const double z_150 = c_7*z_146 + z_148 - z_H*z_147;
    const double z_151 = x_B*sin_theta + c_0*cos_theta;
    const double z_152 = r_R*cos_theta + sin_theta*c_1;
    const double z_153 = z_18 + z_67;
    const double z_154 = z_23 + z_66;
    const double z_155 = c_*z_153 + r_F*z_154;
    const double z_156 = z_155 - z_152;
    const double z_157 = z_H*z_154 + c_7*z_153;
    const double z_158 = z_152 - z_157;
    dM[272] = dM[258] = -(z_145*z_4 + z_149*z_27 + z_150*z_42 + z_156*z_40 - z_151*z_11 - z_158*z_44);
    dM[273] = dM[266] = -(z_151*z_4 + z_145*z_11 + z_149*z_40 + z_158*z_42 + z_150*z_44 - z_156*z_27);
    const double z_159 = z_49*z_32 + z_47*z_36;
    const double z_160 = z_59 - z_126;
    const double z_161 = z_58 - z_127;
    const double z_162 = z_161*c_10 - c_9*z_160;
    const double z_163 = z_160*c_10 - c_11*z_161;
    const double z_164 = z_159*z_94 - (z_162*z_32 + z_163*z_36);
    const double z_165 = z_17*z_163 + z_100 - z_21*z_162 - c_15*z_49 - z_159*z_97;
    const double z_166 = z_17*z_162 + z_96 - z_14*z_163 - c_19*z_47 - z_159*z_101;
    const double z_167 = z_26*c_23;
    const double z_168 = z_41*c_24;
    dM[274] = (-0.5)*(sin_phi*(-z_164) + (z_102*z_47 - z_166*z_49) + z_2*z_151*c_22 + z_145*z_104 + z_149*z_105 +
        z_158*z_168 + z_150*z_106 - (z_98*z_49 - z_165*z_47) - z_156*z_167);
    dM[280] = dM[259] = z_47*z_62 + z_126*z_65 + z_58*z_64 - z_49*z_61 - z_127*z_64 - z_59*z_65;
    dM[281] = dM[267] = z_49*z_48 + z_127*z_55 + z_59*z_57 - z_47*z_50 - z_126*z_57 - z_58*z_55;
    const double z_169 = m_F*z_156 - m_H*z_158;
    const double z_170 = c_38*z_156 - c_39*z_158;
    const double z_171 = c_36*z_156 - c_37*z_158;
    const double c_40 = c[66];
    const double c_41 = c[67];
    const double z_172 = z_171*c_70;
    const double z_173 = z_170*c_72;
    dM[282] = dM[275] = 0.5*((cos_theta*z_102 + sin_theta*z_166) + (sin_theta*z_98 + cos_theta*z_165) +
        2.0*c_1*(z_137 + z_169*z_47) + 2.0*(z_130 - z_54*z_170) + 2.0*(z_131 - z_58*z_171) + 2.0*c_40*(z_139 -
        z_151*z_47) + cos_phi*(m_B*z_151 - z_169)*c_42 + z_51*z_172 - 2.0*r_R*(z_138 - z_169*z_49) - 2.0*(z_132 +
        z_56*z_171) - 2.0*(z_133 + z_59*z_170) - 2.0*c_41*(z_140 + z_151*z_49) - z_51*z_173);
    const double z_174 = z_24*c_10 - z_19*c_11;
    const double z_175 = z_19*c_10 - z_24*c_9;
    const double z_176 = cos_theta*c_16;
    const double z_177 = c_5*z_70 + c_6*z_72;
    const double z_178 = c_11*z_154 + z_153*c_10;
    const double z_179 = c_9*z_153 + z_154*c_10;
    const double z_180 = sin_theta*c_16;
    const double z_181 = c_5*z_72 - c_6*z_70;
    const double z_182 = r_R - z_152;
    const double z_183 = z_182 + z_155;
    const double z_184 = z_182 + z_157;
    const double z_185 = c_38*z_183 + c_39*z_184;
    const double z_186 = c_36*z_183 + c_37*z_184;
    const double z_187 = m_F*z_183 + m_H*z_184;
    const double z_188 = r_R - z_151;
    dM[283] = (-0.5)*((cos_theta*(z_14*z_174 + z_176 - z_17*z_175 - sin_theta*c_19 - z_177*z_101) -
        sin_theta*(cos_theta*c_19 + z_14*z_178 + z_17*z_179 + z_180 - z_181*z_101)) + 2.0*(z_112*z_66 +
        z_15*z_185) + 2.0*(z_114*z_67 - z_22*z_186) + 2.0*(z_18*z_114 + z_23*z_186) + 2.0*(z_23*z_112 -
        z_18*z_185) + z_119 - (sin_theta*(z_21*z_175 + z_180 - z_17*z_174 - cos_theta*c_15 - z_177*z_97) -
        cos_theta*(sin_theta*c_15 + z_21*z_179 + z_17*z_178 + z_176 + z_181*z_97)) - 2.0*r_R*(sin_theta*z_187 +
        cos_theta*z_118) - 2.0*c_1*(-(cos_theta*z_187 - sin_theta*z_118)) - 2.0*c_40*(-(cos_theta*z_188 -
        sin_theta*z_2)) - 2.0*c_41*(sin_theta*z_188 + cos_theta*z_2));
    dM[288] = dM[260] = z_18*z_55 + z_22*z_57 + sin_theta*z_50 - z_23*z_57 - z_15*z_55 - cos_theta*z_48 - z_109;
    dM[289] = dM[268] = -(z_23*z_65 + z_15*z_64 + cos_theta*z_61 - z_18*z_64 - z_22*z_65 - sin_theta*z_62 -
        z_111);
    const double z_189 = z_39*c_38 + z_43*c_39;
    const double z_190 = c_38*z_149 + c_39*z_150;
    const double z_191 = z_39*c_36 + z_43*c_37;
    const double z_192 = c_36*z_149 + c_37*z_150;
    const double z_193 = m_F*z_39 + m_H*z_43;
    const double z_194 = m_F*z_149 + m_H*z_150;
    dM[290] = dM[276] = (-0.5)*(2.0*(z_15*z_189 + z_66*z_190) + 2.0*(z_23*z_191 + z_18*z_192) +
        2.0*c_1*(cos_theta*z_193 - sin_theta*z_194) + 2.0*c_1*(z_121 - z_169*z_8) + 2.0*c_40*(cos_theta*z_9 -
        sin_theta*z_145) + 2.0*r_R*(z_120 + z_169*z_7) + 2.0*c_40*(z_124 + z_151*z_8) + 2.0*c_41*(z_125 -
        z_151*z_7) - 2.0*(z_22*z_191 - z_67*z_192) - 2.0*(z_18*z_189 - z_23*z_190) - 2.0*r_R*(sin_theta*z_193 +
        cos_theta*z_194) - 2.0*(z_113 + z_68*z_170) - 2.0*(z_116 + z_35*z_171) - 2.0*c_41*(sin_theta*z_9 +
        cos_theta*z_145) - 2.0*(z_115 - z_69*z_171) - 2.0*(z_117 - z_29*z_170) - z_164);
    const double c_104 = c[130];
    const double c_105 = c[131];
    const double c_106 = c[132];
    const double c_107 = c[133];
    dM[291] = dM[284] = 0.5*(z_178*z_36 + z_181*z_94 + c_104*z_70 + c_107*z_72 - z_179*z_32 - z_21*c_105*z_72 -
        c_106*(z_17*z_72) - z_14*c_106*z_70 - c_105*(z_17*z_70));
    dM[296] = dM[261] = -(z_70*z_78 + z_72*z_76 + z_77*z_71 - z_75*z_73);
    dM[297] = dM[269] = -(z_72*z_71 + z_70*z_73 + z_75*z_78 - z_77*z_76);
    dM[298] = dM[277] = 0.5*(c_6*z_162 + 2.0*c_3*(z_114*z_77 + z_171*z_75) + 2.0*c_4*(z_191*z_70 - z_192*z_72) +
        2.0*c_4*(z_189*z_72 + z_190*z_70) + 2.0*c_4*(z_114*z_75 - z_171*z_77) + z_74*z_173 - c_5*z_163 -
        2.0*c_3*(z_191*z_72 + z_192*z_70) - 2.0*c_2*(z_189*z_70 - z_190*z_72) - 2.0*c_2*(z_112*z_75 - z_170*z_77)
        - 2.0*c_4*(z_112*z_77 + z_170*z_75) - z_74*z_172);
    const double z_195 = cos_delta*z_114;
    const double z_196 = cos_delta*z_112;
    const double c_110 = c[136];
    const double z_197 = sin_delta*sin_delta;
    const double z_198 = sin_theta*z_197;
    const double c_111 = c[137];
    const double z_199 = cos_theta*z_197;
    dM[299] = dM[285] = (-0.5)*(c_70*z_195 + c_111*z_199 - c_6*z_179 - c_5*z_178 - c_72*z_196 - c_110*z_198);
    dM[314] = dM[279] = F_yy*z_159;
    dM[315] = dM[287] = F_yy*z_181;
    const double z_200 = c_4*z_77;
    const double z_201 = z_200 + c_5*z_74 - c_3*z_75;
    const double z_202 = c_4*z_75;
    const double z_203 = z_202 - c_2*z_77 - c_6*z_74;
    const double z_204 = c_*z_201 + r_F*z_203;
    const double z_205 = z_H*z_203 + c_7*z_201;
    const double z_206 = c_4*z_70;
    const double z_207 = z_206 + c_2*z_72;
    const double z_208 = c_4*z_72;
    const double z_209 = z_208 + c_3*z_70;
    const double z_210 = r_F*z_207 - c_*z_209;
    const double z_211 = z_H*z_207 - c_7*z_209;
    dM[336] = dM[322] = z_204*z_27 + z_205*z_42 + z_210*z_40 + z_211*z_44;
    dM[337] = dM[330] = -(z_210*z_27 + z_211*z_42 - z_204*z_40 - z_205*z_44);
    const double c_14 = c[40];
    const double z_212 = z_51 + z_49*(c_6*cos_delta) - z_47*(c_5*cos_delta);
    const double z_213 = c_4*sin_delta;
    const double z_214 = z_49*z_213;
    const double z_215 = c_5*z_88 + c_3*z_142 - z_214;
    const double z_216 = z_47*z_213;
    const double z_217 = c_2*z_141 - z_216 - c_6*z_88;
    const double z_218 = c_9*z_215 + z_217*c_10;
    const double z_219 = c_11*z_217 + z_215*c_10;
    const double z_220 = c_14*(sin_delta*z_89 + cos_delta*z_212) + 0.5*(c_5*(cos_delta*z_86 - sin_delta*z_218) +
        c_6*(cos_delta*z_87 + sin_delta*z_219));
    const double z_221 = c_3*sin_delta;
    const double c_18 = c[44];
    const double z_222 = z_90 - sin_delta*z_212;
    const double z_223 = (z_86*z_221 + z_21*z_218) + (z_87*z_213 + z_17*z_219) - 2.0*c_18*z_222;
    const double z_224 = c_2*sin_delta;
    const double c_21 = c[47];
    const double z_225 = (z_86*z_213 - z_17*z_218) + (z_87*z_224 - z_14*z_219) - 2.0*c_21*z_222;
    dM[338] = (-0.5)*(sin_phi*(2.0*z_220) + z_223*z_47 + z_210*z_167 + z_211*z_168 - z_225*z_49 - z_204*z_105 -
        z_205*z_106);
    dM[344] = dM[323] = -(z_88*z_63 + z_73*z_141 + z_71*z_142);
    dM[345] = dM[331] = z_88*z_52 + z_76*z_142 + z_78*z_141;
    const double z_226 = c_36*z_210 + c_37*z_211;
    const double z_227 = c_2*z_112;
    const double z_228 = c_38*z_210 + c_39*z_211;
    const double z_229 = c_3*z_114;
    const double z_230 = m_F*z_210 + m_H*z_211;
    const double z_231 = z_230*c_42;
    const double z_232 = z_230*c_74;
    dM[346] = dM[339] = 0.5*(sin_theta*z_225 + cos_theta*z_223 + 2.0*c_5*(z_144 - z_51*z_226) + 2.0*(z_141*z_227 +
        z_54*z_228) + 2.0*(z_142*z_229 + z_56*z_226) + cos_phi*z_231 - 2.0*(z_114*z_214 - z_58*z_226) -
        2.0*(z_112*z_216 - z_59*z_228) - 2.0*c_6*(z_143 - z_51*z_228) - z_49*z_231 - z_47*z_232);
    const double z_233 = z_209*c_10 - c_11*z_207;
    const double z_234 = z_207*c_10 - c_9*z_209;
    const double z_235 = cos_theta*cos_delta;
    const double z_236 = sin_theta*cos_delta;
    const double z_237 = c_5*z_235 + c_6*z_236;
    const double z_238 = cos_delta*z_177 + sin_delta*z_237;
    const double z_239 = c_2*z_70;
    const double z_240 = c_3*z_72;
    const double z_241 = z_206 - z_240;
    const double z_242 = z_208 - z_239;
    const double z_243 = c_*z_241 + r_F*z_242;
    const double z_244 = z_H*z_242 + c_7*z_241;
    const double z_245 = c_38*z_243 + c_39*z_244;
    const double z_246 = c_36*z_243 + c_37*z_244;
    const double z_247 = m_F*z_243 + m_H*z_244;
    const double c_43 = c[69];
    const double z_248 = cos_delta*sin_delta;
    dM[347] = 0.5*(sin_theta*((z_174*z_224 + z_14*z_233) + (z_175*z_213 - z_17*z_234) + 2.0*c_21*z_238) +
        cos_theta*((z_175*z_221 + z_21*z_234) + (z_174*z_213 - z_17*z_233) + 2.0*c_18*z_238) + 2.0*(z_186*z_206 +
        z_18*z_246) + 2.0*(z_185*z_208 + z_23*z_245) + z_247*c_42 - 2.0*(z_185*z_239 - z_66*z_245) -
        2.0*(z_186*z_240 - z_67*z_246) - c_43*z_248 - z_247*z_135 - z_247*z_136);
    dM[352] = dM[324] = -(z_70*z_78 + z_72*z_76 + z_77*z_71 - z_75*z_73);
    dM[353] = dM[332] = -(z_72*z_71 + z_70*z_73 + z_75*z_78 - z_77*z_76);
    const double z_249 = c_38*z_204 + c_39*z_205;
    const double z_250 = c_36*z_204 + c_37*z_205;
    const double z_251 = m_F*z_204 + m_H*z_205;
    dM[354] = dM[340] = (-0.5)*(2.0*(z_189*z_239 - z_66*z_249) + 2.0*(z_191*z_240 - z_67*z_250) + 2.0*(z_75*z_227
        + z_68*z_228) + 2.0*(z_112*z_200 - z_29*z_228) + z_251*z_135 + z_251*z_136 + z_8*z_232 + 2.0*z_220 -
        2.0*(z_191*z_206 + z_18*z_250) - 2.0*(z_189*z_208 + z_23*z_249) - 2.0*(z_114*z_202 - z_35*z_226) -
        2.0*(z_77*z_229 + z_69*z_226) - z_7*z_231);
    const double c_46 = c[72];
    const double c_45 = c[71];
    const double c_48 = c[74];
    const double c_47 = c[73];
    const double c_50 = c[76];
    const double c_51 = c[77];
    dM[355] = dM[348] = 0.5*(2.0*c_14*(sin_delta*z_177 - cos_delta*z_237) + 2.0*(c_48*z_199 + cos_delta*z_18*c_47)
        + c_104*z_236 - c_5*(cos_delta*z_175 - sin_delta*z_234) - c_6*(cos_delta*z_174 - sin_delta*z_233) -
        2.0*(c_46*z_199 - z_235*(z_21*c_45)) - 2.0*(z_236*(z_14*c_47) - c_50*z_198) - 2.0*(c_51*z_198 +
        cos_delta*z_23*c_45) - c_107*z_235);
    const double z_252 = r_R - c_*z_17 - r_F*z_14;
    const double z_253 = r_R - z_14*z_H - z_17*c_7;
    const double z_254 = c_38*z_252 + c_39*z_253;
    const double c_52 = c[78];
    const double z_255 = c_1 - c_*z_21 - z_17*r_F;
    const double z_256 = c_1 - z_17*z_H - z_21*c_7;
    const double z_257 = c_36*z_255 + c_37*z_256;
    const double c_53 = c[79];
    const double z_258 = c_36*z_252 + c_37*z_253;
    const double c_54 = c[80];
    const double z_259 = z_17*sin_delta;
    const double z_260 = c_38*z_255 + c_39*z_256;
    const double c_55 = c[81];
    const double c_56 = c[82];
    const double c_57 = c[83];
    dM[356] = (z_254*z_224 - sin_delta*z_14*c_52) + (z_257*z_221 - z_21*sin_delta*c_53) + sin_delta*c_56 -
        (z_258*z_213 + c_54*z_259) - (z_260*z_213 + c_55*z_259) - c_57*z_248;
    const double z_261 = cos_delta*z_8;
    const double z_262 = cos_delta*z_7;
    dM[360] = dM[325] = -(z_108 + z_236*z_78 + z_73*z_261 + z_71*z_262 - z_235*z_76);
    dM[361] = dM[333] = z_110 + z_235*z_71 + z_76*z_262 + z_78*z_261 - z_236*z_73;
    dM[362] = dM[341] = (-0.5)*(c_6*z_218 + c_5*z_219 + 2.0*c_6*(z_123 + z_74*z_228) + 2.0*c_2*(z_189*z_236 +
        z_249*z_72) + 2.0*c_4*(z_189*z_235 + z_249*z_70) + 2.0*c_4*(z_8*z_195 - z_226*z_77) + 2.0*c_4*(z_7*z_196 -
        z_228*z_75) - 2.0*c_3*(z_191*z_235 + z_250*z_70) - 2.0*c_5*(z_122 + z_74*z_226) - 2.0*c_3*(z_7*z_195 -
        z_226*z_75) - 2.0*c_2*(z_8*z_196 - z_228*z_77) - 2.0*c_4*(z_191*z_236 + z_250*z_72));
    const double c_113 = c[139];
    const double c_114 = c[140];
    dM[363] = dM[349] = (-0.5)*(c_6*z_234 + 2.0*c_5*(sin_delta*z_186 - cos_delta*z_246) + c_113*(cos_delta*z_70) +
        c_114*(cos_delta*z_72) - c_5*z_233 - 2.0*c_6*(sin_delta*z_185 - cos_delta*z_245));
    const double c_62 = c[88];
    const double c_63 = c[89];
    const double c_64 = c[90];
    const double c_65 = c[91];
    const double c_66 = c[92];
    dM[364] = dM[357] = (-0.5)*(cos_delta*c_62 + 2.0*(z_20*z_258 + c_64*z_197) + 2.0*(z_16*z_257 + c_66*z_197) -
        2.0*(z_13*z_260 + c_63*z_197) - 2.0*(z_16*z_254 + c_65*z_197));
    dM[378] = dM[343] = -F_yy*z_212;
    dM[379] = dM[351] = -F_yy*z_237;
    dM[380] = dM[359] = -sin_delta*F_yy;
}

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ASIDE void motion_bias(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                          const double *restrict c, EM_UNUSED const double *restrict u, double *restrict bias,
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
    const double c_3 = c[29];
    const double c_2 = c[28];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_8 = c_3 + c_2*cos_delta;
    const double cos_theta = em_cos(theta);
    const double c_4 = c[30];
    const double z_10 = c_4 - cos_delta*c_4;
    const double z_11 = cos_theta*z_10;
    const double z_12 = sin_theta*z_8 - z_11;
    const double c_7 = c[33];
    const double z_13 = c_2 + c_3*cos_delta;
    const double z_14 = cos_theta*z_13;
    const double z_15 = sin_theta*z_10;
    const double z_16 = z_14 - z_15;
    const double c_1 = c[27];
    const double z_17 = cos_theta*c_1;
    const double z_18 = z_17 - r_R*sin_theta;
    const double z_19 = z_H*z_12 + z_18 - c_7*z_16;
    const double c_6 = c[32];
    const double delta_dot = v[5];
    const double z_20 = delta_dot*cos_delta;
    const double z_21 = c_6*z_20;
    const double sin_phi = em_sin(phi);
    const double z_23 = phi_dot*sin_phi;
    const double sin_delta = em_sin(delta);
    const double z_25 = c_6*sin_delta;
    const double z_26 = sin_phi*cos_theta;
    const double z_27 = delta_dot*sin_delta;
    const double z_28 = c_2*z_27;
    const double theta_dot = v[4];
    const double z_29 = sin_phi*sin_theta;
    const double z_30 = theta_dot*z_29;
    const double z_31 = cos_theta*cos_phi;
    const double z_32 = phi_dot*z_31;
    const double z_33 = c_4*z_27;
    const double z_34 = z_29*z_33;
    const double z_35 = sin_theta*cos_phi;
    const double z_36 = phi_dot*z_35;
    const double z_37 = theta_dot*z_26;
    const double z_38 = (z_26*z_28 + (z_8*z_30 - z_8*z_32)) - (z_34 + (z_10*z_36 + z_10*z_37));
    const double z_39 = cos_phi*z_21 + z_38 - z_23*z_25;
    const double c_5 = c[31];
    const double z_40 = c_5*z_20;
    const double z_41 = c_5*sin_delta;
    const double z_42 = z_26*z_33;
    const double z_43 = z_42 + (z_10*z_32 - z_10*z_30);
    const double z_44 = c_3*z_27;
    const double z_45 = z_29*z_44 - (z_13*z_36 + z_13*z_37);
    const double z_46 = cos_phi*z_40 + z_43 - z_23*z_41 - z_45;
    const double z_47 = (c_1*z_37 - r_R*z_30) - (z_5 - (r_R*z_32 + c_1*z_36));
    const double z_48 = psi_dot*z_19 + z_H*z_39 + z_47 - c_7*z_46;
    const double m_F = c[9];
    const double r_F = c[5];
    const double c_ = c[1];
    const double z_49 = r_F*z_12 + z_18 - c_*z_16;
    const double z_50 = psi_dot*z_49 + r_F*z_39 + z_47 - c_*z_46;
    const double z_51 = m_H*z_48 + m_F*z_50;
    const double m_B = c[7];
    const double x_B = c[10];
    const double c_0 = c[26];
    const double z_52 = x_B*cos_theta - sin_theta*c_0;
    const double z_53 = psi_dot*z_52 + x_B*z_36 + c_0*z_32 + x_B*z_37 - c_0*z_30 - z_5;
    const double z_54 = m_R*(-z_5) + z_51 + m_B*z_53;
    const double z_55 = psi_dot*cos_psi;
    const double z_56 = psi_dot*sin_psi;
    const double z_57 = x_dot*z_55 + y_dot*z_56;
    const double z_58 = phi_dot*phi_dot;
    const double z_59 = sin_phi*z_58;
    const double z_60 = z_57 - r_R*z_59;
    const double z_61 = theta_dot*sin_theta;
    const double z_62 = theta_dot*cos_theta;
    const double z_63 = x_B*z_61 + c_0*z_62;
    const double z_64 = theta_dot*z_31;
    const double z_65 = phi_dot*z_64;
    const double z_66 = z_65 - z_58*z_29;
    const double z_67 = theta_dot*z_35;
    const double z_68 = phi_dot*z_67;
    const double z_69 = z_68 + z_58*z_26;
    const double z_70 = theta_dot*theta_dot;
    const double z_71 = z_65 - z_70*z_29;
    const double z_72 = z_68 + z_70*z_26;
    const double z_73 = psi_dot*z_63 + c_0*z_69 + c_0*z_72 + z_60 - x_B*z_66 - x_B*z_71;
    const double z_74 = cos_theta*z_33;
    const double z_75 = (z_8*z_62 - sin_theta*z_28) + (z_10*z_61 - z_74);
    const double z_76 = z_75;
    const double z_77 = sin_theta*z_33;
    const double z_78 = (z_13*z_61 + cos_theta*z_44) + (z_10*z_62 + z_77);
    const double z_79 = z_78;
    const double z_80 = r_R*z_62 + c_1*z_61;
    const double z_81 = z_80 - z_H*z_76 - c_7*z_79;
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
    const double z_94 = c_6*z_85 + (z_88 + z_36*z_33 - z_89*z_58) + c_6*z_90 + (z_88 + z_37*z_33 - z_89*z_70) +
        c_2*z_92 + c_4*z_93 - (z_86 + z_87*z_70 - z_30*z_28) - (z_86 + z_87*z_58 + z_32*z_28);
    const double z_95 = z_13*z_65;
    const double z_96 = z_13*z_29;
    const double z_97 = z_10*z_68;
    const double z_98 = z_10*z_26;
    const double z_99 = c_5*z_85 + (z_97 + z_98*z_58 - z_32*z_33) + c_5*z_90 + (z_97 + z_98*z_70 + z_30*z_33) +
        c_3*z_93 - (z_95 - z_36*z_44 - z_96*z_58) - (z_95 - z_96*z_70 - z_37*z_44) - c_4*(-z_92);
    const double z_100 = (c_1*z_71 - r_R*z_72) - (z_60 + (r_R*z_69 - c_1*z_66));
    const double z_101 = psi_dot*z_81 + z_H*z_94 - c_7*z_99 - z_100;
    const double z_102 = z_80 - (r_F*z_76 + c_*z_79);
    const double z_103 = psi_dot*z_102 + r_F*z_94 - c_*z_99 - z_100;
    const double z_104 = m_H*z_101 + m_F*z_103;
    const double z_105 = m_R*z_60 + m_B*z_73 + z_104;
    const double z_106 = r_R*sin_phi;
    const double z_107 = x_dot*cos_psi + y_dot*sin_psi;
    const double z_108 = psi_dot*z_106 + z_107;
    const double z_109 = z_87 + z_89 - cos_phi*z_25;
    const double z_110 = z_96 + z_98 + cos_phi*z_41;
    const double z_111 = c_1*z_29 - (z_106 - r_R*z_26);
    const double z_112 = z_109*z_H + z_110*c_7 - z_111;
    const double z_113 = z_80 - z_107;
    const double z_114 = psi_dot*z_112 + z_H*z_75 + c_7*z_78 - z_113;
    const double z_115 = c_*z_110 + r_F*z_109 - z_111;
    const double z_116 = psi_dot*z_115 + c_*z_78 + r_F*z_75 - z_113;
    const double z_117 = m_H*z_114 + m_F*z_116;
    const double z_118 = z_106 - x_B*z_29 - c_0*z_26;
    const double z_119 = psi_dot*z_118 + z_107 - z_63;
    const double z_120 = m_R*z_108 + z_117 + m_B*z_119;
    const double z_121 = x_dot*z_56 - y_dot*z_55;
    const double z_122 = psi_dot*z_1;
    const double z_123 = z_121 - r_R*z_122;
    const double z_124 = z_36 + z_37;
    const double z_125 = z_32 - z_30;
    const double z_126 = z_2 - x_B*z_124 - c_0*z_125;
    const double z_127 = sin_theta*z_70;
    const double z_128 = z_121 + cos_theta*(x_B*z_70) - psi_dot*z_126 - c_0*z_127;
    const double z_129 = cos_phi*z_20;
    const double z_130 = z_129 - sin_delta*z_23;
    const double z_131 = c_6*z_130 + z_38;
    const double z_132 = (-z_45) + z_43 + c_5*z_130;
    const double z_133 = c_1*z_124 - (z_2 - r_R*z_125);
    const double z_134 = c_7*z_132 - z_H*z_131 - z_133;
    const double z_135 = z_27*z_62 + sin_theta*z_91;
    const double z_136 = z_27*z_61 - cos_theta*z_91;
    const double z_137 = (z_8*z_127 + z_62*z_28) + c_2*z_135 - (z_11*z_70 + z_61*z_33) - c_4*z_136;
    const double z_138 = (z_14*z_70 - z_61*z_44) + c_4*z_135 - (z_15*z_70 - z_62*z_33) - c_3*z_136;
    const double z_139 = z_17*z_70 + (z_121 - r_R*z_127);
    const double z_140 = z_H*z_137 + z_139 - psi_dot*z_134 - c_7*z_138;
    const double z_141 = z_133 - (c_*z_132 - r_F*z_131);
    const double z_142 = -z_141;
    const double z_143 = r_F*z_137 + z_139 - psi_dot*z_142 - c_*z_138;
    const double z_144 = m_H*z_140 + m_F*z_143;
    const double z_145 = m_R*z_123 + m_B*z_128 + z_144;
    bias[0] = (z_54*z_55 - sin_psi*z_105) + (z_120*z_56 + cos_psi*z_145);
    bias[1] = (z_54*z_56 + cos_psi*z_105) - (z_120*z_55 - sin_psi*z_145);
    const double c_8 = c[34];
    const double B_xz = c[21];
    const double z_146 = phi_dot*sin_theta;
    const double z_147 = z_146 + psi_dot*z_31;
    const double z_148 = B_xz*z_147;
    const double B_xx = c[18];
    const double z_149 = phi_dot*cos_theta;
    const double z_150 = z_149 - psi_dot*z_35;
    const double H_xz = c[25];
    const double z_151 = theta_dot + psi_dot*sin_phi;
    const double z_152 = delta_dot*c_5 + z_8*z_147 + z_151*z_25 - z_10*z_150;
    const double z_153 = H_xz*z_152;
    const double H_xx = c[22];
    const double z_154 = z_13*z_150 + z_151*z_41 - delta_dot*c_6 - z_10*z_147;
    const double c_67 = c[93];
    const double z_155 = z_153 - (H_xx*z_154 - z_153) - c_67*z_154;
    const double z_156 = H_xz*z_154;
    const double H_zz = c[24];
    const double c_68 = c[94];
    const double z_157 = z_156 - (H_zz*z_152 - z_156) - c_68*z_152;
    const double c_69 = c[95];
    const double c_70 = c[96];
    const double H_yy = c[23];
    const double z_158 = z_147*z_25 - (cos_delta*z_151 - z_150*z_41);
    const double F_yy = c[17];
    const double spin_f_dot = v[7];
    const double z_159 = H_yy*(-z_158) + F_yy*(spin_f_dot - z_158);
    const double z_160 = sin_delta*z_159;
    const double z_161 = z_148 + z_13*z_155 + c_70*z_160 - (B_xx*z_150 - z_148) - z_10*z_157 - c_69*z_150;
    const double z_162 = sin_theta*z_23;
    const double z_163 = cos_theta*z_23;
    const double z_164 = phi_dot*z_62 - (psi_dot*z_67 + psi_dot*z_163);
    const double z_165 = B_xz*z_164;
    const double z_166 = phi_dot*z_61 + (psi_dot*z_64 - psi_dot*z_162);
    const double c_18 = c[44];
    const double z_167 = (z_151*z_27 - cos_delta*z_122) + c_5*(z_150*z_20 - sin_delta*z_166) + c_6*(z_147*z_20 +
        sin_delta*z_164);
    const double z_168 = sin_delta*z_167;
    const double z_169 = z_151*z_20 + sin_delta*z_122;
    const double z_170 = (z_147*z_28 - z_8*z_164) + (z_150*z_33 - z_10*z_166) - c_6*z_169;
    const double z_171 = H_xz*z_170;
    const double z_172 = (z_150*z_44 + z_13*z_166) + (z_147*z_33 + z_10*z_164) - c_5*z_169;
    const double z_173 = z_171 - (H_xx*z_172 - z_171) - c_67*z_172;
    const double z_174 = H_xz*z_172;
    const double z_175 = z_174 - (H_zz*z_170 - z_174) - c_68*z_170;
    const double z_176 = z_165 + (B_xx*z_166 + z_165) + 2.0*(z_159*z_40 - c_18*z_168) + c_69*z_166 - (z_155*z_44 +
        z_13*z_173) - (z_157*z_33 - z_10*z_175);
    const double z_177 = B_xz*z_150;
    const double B_zz = c[20];
    const double c_71 = c[97];
    const double c_72 = c[98];
    const double z_178 = z_177 + z_8*z_157 + c_72*z_160 - (B_zz*z_147 - z_177) - z_10*z_155 - c_71*z_147;
    const double z_179 = B_xz*z_166;
    const double c_21 = c[47];
    const double z_180 = z_179 + (B_zz*z_164 + z_179) + (z_155*z_33 - z_10*z_173) + (z_157*z_28 + z_8*z_175) +
        c_71*z_164 - 2.0*(z_159*z_21 - c_21*z_168);
    const double c_84 = c[110];
    const double spin_r_dot = v[6];
    const double c_85 = c[111];
    const double z_181 = (2.0*cos_delta*z_159 + z_151*c_84 - z_155*z_41 - z_157*z_25) + (spin_r_dot + z_151)*c_85;
    const double c_14 = c[40];
    const double z_182 = (2.0*(z_159*z_27 + cos_delta*c_14*z_167) + c_5*(z_155*z_20 - sin_delta*z_173) +
        c_6*(z_157*z_20 - sin_delta*z_175) - c_84*z_122) - c_85*z_122;
    bias[2] = (-0.5)*(2.0*(cos_psi*(x_dot*z_54 - y_dot*z_120) + sin_psi*(y_dot*z_54 + x_dot*z_120)) +
        (2.0*c_8*(z_108*z_1 - sin_phi*z_123) + 2.0*m_H*(z_114*z_134 - z_112*z_140) + 2.0*m_F*(z_116*z_142 -
        z_115*z_143) + 2.0*m_B*(z_119*z_126 - z_118*z_128) + (z_64*z_161 + z_176*z_35 - z_162*z_161) + (z_67*z_178
        + z_163*z_178 + z_180*z_31) + (z_181*z_1 + sin_phi*(-z_182)) - 2.0*m_H*(z_48*z_81 + z_19*z_101) -
        2.0*m_F*(z_50*z_102 + z_49*z_103) - 2.0*m_B*(z_53*z_63 + z_52*z_73)));
    const double c_37 = c[63];
    const double c_36 = c[62];
    const double z_183 = c_37*z_48 + c_36*z_50;
    const double z_184 = z_10*z_183;
    const double z_185 = z_13*z_183;
    const double c_39 = c[65];
    const double c_38 = c[64];
    const double z_186 = c_39*z_48 + c_38*z_50;
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
    const double z_197 = (r_R*z_163 + c_1*z_162) + (r_R*z_67 - (z_196 + c_1*z_64));
    const double z_198 = c_7*z_192 - z_H*z_195 - z_197;
    const double z_199 = c_*z_192 - r_F*z_195 - z_197;
    const double z_200 = c_39*z_198 + c_38*z_199;
    const double z_201 = z_8*z_200;
    const double z_202 = z_10*z_200;
    const double z_203 = c_37*z_198 + c_36*z_199;
    const double z_204 = z_13*z_203;
    const double z_205 = z_10*z_203;
    const double c_73 = c[99];
    const double c_74 = c[100];
    const double z_206 = z_51*c_74;
    const double c_42 = c[68];
    const double z_207 = z_51*c_42;
    const double z_208 = z_183*z_20;
    const double z_209 = z_186*z_20;
    const double z_210 = m_H*z_198 + m_F*z_199;
    const double z_211 = z_210*c_42;
    const double z_212 = z_210*c_74;
    const double c_75 = c[101];
    const double z_213 = sin_theta*z_27;
    const double z_214 = c_75*z_213;
    const double c_76 = c[102];
    const double z_215 = cos_theta*z_27;
    const double z_216 = c_76*z_215;
    const double z_217 = sin_delta*z_200;
    const double z_218 = phi_dot*c_72;
    const double z_219 = c_75*z_215;
    const double c_77 = c[103];
    const double z_220 = c_77*z_213;
    const double z_221 = sin_delta*z_203;
    const double z_222 = phi_dot*c_70;
    const double c_78 = c[104];
    const double z_223 = z_53*c_78;
    const double c_79 = c[105];
    const double z_224 = z_53*c_79;
    const double z_225 = phi_dot*c_42;
    const double z_226 = z_196 + x_B*z_64 - x_B*z_162 - c_0*z_163 - c_0*z_67;
    const double z_227 = z_226*c_78;
    const double z_228 = z_226*c_79;
    const double c_80 = c[106];
    const double z_229 = cos_theta*z_8;
    const double c_81 = c[107];
    const double z_230 = sin_theta*z_13;
    const double z_231 = psi_dot*z_114;
    const double z_232 = psi_dot*z_116;
    const double z_233 = c_39*z_231 + c_38*z_232;
    const double z_234 = c_37*z_231 + c_36*z_232;
    const double c_82 = c[108];
    const double c_83 = c[109];
    const double c_86 = c[112];
    const double c_87 = c[113];
    const double z_235 = sin_delta*z_183;
    const double z_236 = sin_delta*z_186;
    const double z_237 = z_200*c_72;
    const double z_238 = z_203*c_70;
    const double z_239 = z_210 + m_B*z_226;
    const double z_240 = m_H*z_231 + m_F*z_232;
    const double z_241 = psi_dot*z_119;
    const double c_88 = c[114];
    const double z_242 = c_37*z_101 + c_36*z_103;
    const double z_243 = sin_phi*sin_delta;
    const double z_244 = z_10*z_31;
    const double z_245 = z_183*z_44;
    const double z_246 = z_13*z_35;
    const double z_247 = c_39*z_101 + c_38*z_103;
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
    const double z_260 = c_5*z_252 + (z_246*z_58 + z_254 - z_162*z_44) + (z_244*z_58 + z_163*z_33 - z_256) +
        c_5*z_257 + (z_254 + z_246*z_70 + z_64*z_44) + c_4*z_259 - (z_256 - z_244*z_70 - z_67*z_33) - c_3*z_258;
    const double z_261 = z_10*z_253;
    const double z_262 = z_8*z_255;
    const double z_263 = c_6*z_252 + c_6*z_257 + (z_262 + z_67*z_28 - z_250*z_70) + c_2*z_259 + c_4*(-z_258) -
        (z_248*z_70 + z_261 - z_64*z_33) - (z_250*z_58 - z_262 - z_163*z_28) - (z_261 + z_248*z_58 + z_162*z_33);
    const double z_264 = z_58*z_31 - z_255;
    const double z_265 = z_253 + z_58*z_35;
    const double z_266 = z_255 - z_70*z_31;
    const double z_267 = r_R*cos_phi;
    const double z_268 = z_267*z_58;
    const double z_269 = z_70*z_35 + z_253;
    const double z_270 = (r_R*z_264 + c_1*z_265) - (r_R*z_266 + (z_268 - c_1*z_269));
    const double z_271 = c_7*z_260 - z_H*z_263 - z_270;
    const double z_272 = c_*z_260 - r_F*z_263 - z_270;
    const double z_273 = m_H*z_271 + m_F*z_272;
    const double z_274 = c_39*z_271 + c_38*z_272;
    const double z_275 = c_37*z_271 + c_36*z_272;
    const double c_41 = c[67];
    const double c_40 = c[66];
    const double z_276 = z_268 + c_0*z_266 - x_B*z_269 - x_B*z_265 - c_0*z_264;
    const double c_25 = c[51];
    bias[3] = (-0.5)*((sin_phi*(2.0*z_61*z_201 + 2.0*z_61*z_205 + psi_dot*sin_theta*z_161 + c_73 + z_146*z_206 +
        z_149*z_207 + c_72*z_209 + z_62*z_212 + z_200*z_216 + z_203*z_220 + z_221*z_222 + z_149*z_223 +
        z_146*z_224 + z_62*z_228 + sin_delta*z_234*c_70 + cos_theta*c_82 + sin_theta*c_83 - 2.0*z_149*z_184 -
        2.0*z_146*z_185 - 2.0*z_146*z_187 - 2.0*z_149*z_188 - 2.0*z_62*z_202 - 2.0*z_62*z_204 -
        psi_dot*cos_theta*z_178 - c_70*z_208 - z_61*z_211 - z_200*z_214 - z_217*z_218 - z_203*z_219 - z_54*z_225 -
        z_61*z_227 - z_15*c_80 - c_80*z_229 - z_11*c_81 - c_81*z_230 - sin_delta*z_233*c_72) -
        cos_phi*(2.0*z_61*z_184 + 2.0*z_61*z_188 + 2.0*z_146*z_202 + 2.0*z_149*z_201 + 2.0*z_149*z_205 +
        2.0*z_146*z_204 + psi_dot*z_181 + 2.0*z_15*z_233 + 2.0*z_233*z_229 + 2.0*z_11*z_234 + 2.0*z_234*z_230 +
        c_86*z_59 + c_87*(psi_dot*z_108) + z_62*z_206 + z_183*z_220 + z_235*z_222 + z_186*z_216 + z_20*z_238 +
        z_62*z_224 + z_239*z_225 + (m_B*z_241 + z_240)*c_42 - 2.0*z_62*z_185 - 2.0*z_62*z_187 - z_61*z_207 -
        z_183*z_219 - z_186*z_214 - z_236*z_218 - z_146*z_212 - z_149*z_211 - z_20*z_237 - z_61*z_223 -
        z_149*z_227 - z_146*z_228 - sin_theta*z_240*c_74 - cos_theta*z_240*c_42 - cos_theta*c_78*z_241 -
        sin_theta*c_79*z_241 - sin_delta*c_88)) + (2.0*c_1*(z_64*z_51 - z_162*z_51 - z_104*z_35) +
        2.0*c_5*(z_1*z_235 + sin_phi*z_208 - z_242*z_243) + 2.0*(z_67*z_184 + z_163*z_184 + z_244*z_242 -
        z_190*z_183) + 2.0*(z_67*z_188 + z_163*z_188 + z_31*z_249 + z_250*z_247) + 2.0*(z_36*z_202 + z_37*z_202 +
        z_34*z_200 + z_89*z_274) + 2.0*(z_32*z_201 + z_87*z_274 - z_30*z_201 - z_26*(z_200*z_28)) +
        2.0*c_6*(z_23*z_217 - z_129*z_200 - z_274*z_83) + 2.0*(z_32*z_205 + z_42*z_203 + z_98*z_275 - z_30*z_205)
        + 2.0*(z_36*z_204 + z_37*z_204 + z_96*z_275 - z_29*(z_203*z_44)) + 2.0*c_40*(z_64*z_53 - z_162*z_53 -
        z_73*z_35) + 2.0*r_R*(z_54*z_23 + cos_phi*z_105) + 2.0*r_R*(z_239*z_1 + sin_phi*(z_273 + m_B*z_276)) +
        (z_161*z_61 - cos_theta*z_176) + c_25*(cos_phi*z_59) - 2.0*r_R*(z_67*z_51 + z_163*z_51 + z_104*z_31) -
        2.0*(z_64*z_185 - z_35*z_245 - z_162*z_185 - z_246*z_242) - 2.0*c_6*(z_1*z_236 + sin_phi*z_209 -
        z_247*z_243) - 2.0*(z_64*z_187 + z_193*z_186 - z_162*z_187 - z_248*z_247) - 2.0*c_1*(z_36*z_210 +
        z_37*z_210 + z_273*z_29) - 2.0*r_R*(z_32*z_210 + z_273*z_26 - z_30*z_210) - 2.0*c_5*(z_23*z_221 -
        z_129*z_203 - z_275*z_83) - 2.0*c_41*(z_67*z_53 + z_163*z_53 + z_73*z_31) - 2.0*c_41*(z_226*z_32 +
        z_276*z_26 - z_226*z_30) - 2.0*c_40*(z_226*z_36 + z_226*z_37 + z_276*z_29) - (z_178*z_62 -
        sin_theta*z_180)));
    const double z_277 = theta_dot*sin_phi;
    const double z_278 = theta_dot*cos_phi;
    const double z_279 = c_39*z_114 + c_38*z_116;
    const double z_280 = c_37*z_114 + c_36*z_116;
    const double z_281 = theta_dot*z_10;
    const double z_282 = psi_dot*cos_phi;
    const double z_283 = psi_dot*z_48;
    const double z_284 = psi_dot*z_50;
    const double z_285 = c_37*z_283 + c_36*z_284;
    const double z_286 = c_39*z_283 + c_38*z_284;
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
    const double z_313 = c_39*z_140 + c_38*z_143;
    const double z_314 = z_279*z_61;
    const double z_315 = cos_theta*z_279;
    const double z_316 = z_280*z_61;
    const double z_317 = c_37*z_140 + c_36*z_143;
    const double z_318 = z_280*z_62;
    const double z_319 = sin_theta*z_280;
    bias[4] = (-0.5)*((sin_theta*(2.0*z_23*z_201 + 2.0*z_23*z_205 + 2.0*theta_dot*z_8*z_279 + 2.0*z_280*z_281 +
        2.0*sin_phi*z_8*z_233 + 2.0*z_234*z_287 + z_277*z_206 + z_1*z_207 + c_76*z_290 + z_278*z_212 + c_76*z_292
        + c_77*z_296 + z_277*z_224 + z_1*z_223 + z_278*z_228 + z_299*c_74 + psi_dot*z_224 + cos_phi*c_82 -
        2.0*z_277*z_185 - 2.0*z_1*z_184 - 2.0*z_277*z_187 - 2.0*z_1*z_188 - 2.0*z_278*z_202 - 2.0*z_278*z_204 -
        phi_dot*z_161 - z_178*z_282 - 2.0*z_13*z_285 - 2.0*z_10*z_286 - c_75*z_289 - z_23*z_211 - c_75*z_293 -
        c_42*z_294 - c_75*z_295 - z_23*z_227 - c_78*z_297 - c_80*(cos_phi*z_8) - c_81*z_298 - c_42*z_300 -
        c_78*z_301) + cos_theta*(2.0*z_1*z_185 + 2.0*z_1*z_187 + phi_dot*z_178 + z_277*z_207 + c_75*z_290 +
        z_278*z_211 + z_23*z_212 + c_75*z_292 + c_74*z_294 + c_76*z_295 + z_277*z_223 + z_278*z_227 + z_23*z_228 +
        c_79*z_297 + c_80*z_298 + c_81*(z_13*cos_phi) + z_299*c_42 + psi_dot*z_223 + c_74*z_300 + c_79*z_301 -
        2.0*z_277*z_184 - 2.0*z_277*z_188 - 2.0*z_278*z_201 - 2.0*z_23*z_202 - 2.0*z_278*z_205 - 2.0*z_23*z_204 -
        2.0*z_279*z_281 - 2.0*theta_dot*z_13*z_280 - z_161*z_282 - 2.0*z_10*z_285 - 2.0*z_8*z_286 -
        2.0*z_233*z_287 - 2.0*sin_phi*z_13*z_234 - z_1*z_206 - c_77*z_289 - c_77*z_293 - c_75*z_296 - z_1*z_224 -
        cos_phi*c_83)) + (2.0*c_1*(z_32*z_51 - z_30*z_51 - z_104*z_26) + 2.0*(z_36*z_184 + z_37*z_184 + z_33*z_302
        - z_89*z_242) + 2.0*(z_36*z_188 + z_37*z_188 - z_29*z_249 - z_8*z_305) + 2.0*(z_64*z_201 + z_8*z_307 -
        z_162*z_201 - z_28*z_306) + 2.0*(z_67*z_202 + z_163*z_202 - z_33*z_308 - z_244*z_274) + 2.0*(z_67*z_204 +
        z_44*z_309 + z_163*z_204 - z_13*z_310) + 2.0*(z_64*z_205 + z_33*z_311 + z_248*z_275 - z_162*z_205) +
        2.0*r_R*(z_117*z_61 + cos_theta*z_144) + 2.0*(z_10*z_312 + z_77*z_279 - z_15*z_313) + 2.0*(z_13*z_318 -
        z_44*z_319 - z_317*z_230) + 2.0*c_40*(z_32*z_53 - z_30*z_53 - z_73*z_26) + 2.0*c_41*(z_119*z_61 +
        cos_theta*z_128) - 2.0*r_R*(z_36*z_51 + z_37*z_51 - z_104*z_29) - 2.0*(z_32*z_185 - z_30*z_185 -
        z_26*z_245 - z_13*z_303) - 2.0*(z_32*z_187 + z_33*z_304 - z_30*z_187 - z_98*z_247) - 2.0*r_R*(z_64*z_210 +
        z_273*z_35 - z_162*z_210) - 2.0*c_1*(z_67*z_210 + z_163*z_210 - z_273*z_31) - 2.0*c_1*(z_117*z_62 -
        sin_theta*z_144) - 2.0*(z_8*z_314 + z_28*z_315 + z_313*z_229) - 2.0*(z_10*z_316 + z_11*z_317 - z_74*z_280)
        - 2.0*c_41*(z_36*z_53 + z_37*z_53 - z_73*z_29) - 2.0*c_41*(z_64*z_226 + z_276*z_35 - z_162*z_226) -
        2.0*c_40*(z_67*z_226 + z_163*z_226 - z_276*z_31) - 2.0*c_40*(z_119*z_62 - sin_theta*z_128) - z_182));
    const double z_320 = delta_dot*c_75;
    const double z_321 = delta_dot*c_77;
    const double z_322 = z_183*c_70;
    const double z_323 = delta_dot*c_76;
    const double z_324 = z_186*c_72;
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
    bias[5] = (-0.5)*((cos_delta*(c_5*z_151*z_155 + c_6*z_151*z_157 + z_320*(z_183*z_26) + z_320*(z_186*z_29) +
        z_23*z_324 + z_320*z_306 + z_1*z_237 + z_320*z_309 + z_320*z_315 + z_323*(sin_theta*z_279) +
        c_72*(z_147*z_159) + c_70*(z_150*z_159) + c_72*(cos_phi*z_233) + sin_phi*c_88 - z_321*z_302 - z_23*z_322 -
        z_323*z_304 - z_308*z_323 - z_311*z_321 - z_1*z_238 - z_320*z_319 - z_321*(cos_theta*z_280) -
        c_70*(cos_phi*z_234)) - sin_delta*(c_2*(2.0*z_32*z_186 + z_147*z_157 + c_80*z_31 - 2.0*z_30*z_186 -
        2.0*z_67*z_200 - 2.0*z_163*z_200 - 2.0*z_312 - 2.0*sin_theta*z_286 - 2.0*z_233*z_26) + c_4*(2.0*z_30*z_183
        + 2.0*z_162*z_200 + 2.0*z_67*z_203 + 2.0*z_163*z_203 + 2.0*z_314 + 2.0*z_318 + z_147*z_155 + z_150*z_157 +
        2.0*sin_theta*z_285 + 2.0*z_233*z_29 + 2.0*z_234*z_26 - 2.0*z_32*z_183 - 2.0*z_37*z_186 - 2.0*z_36*z_186 -
        2.0*z_64*z_200 - 2.0*cos_theta*z_286 - c_80*z_35 - c_81*z_31) + c_3*(2.0*z_37*z_183 + 2.0*z_36*z_183 +
        2.0*z_64*z_203 + z_150*z_155 + 2.0*cos_theta*z_285 + c_81*z_35 - 2.0*z_162*z_203 - 2.0*z_316 -
        2.0*z_234*z_29) + z_325*z_322 + z_326*z_237 - 2.0*z_151*z_159 - z_325*z_324 - z_326*z_238)) -
        (2.0*c_4*(z_32*z_235 + z_26*z_208 - z_30*z_235 - sin_delta*z_303) + 2.0*c_4*(z_36*z_236 + z_37*z_236 +
        z_29*z_209 - sin_delta*z_305) + 2.0*c_6*(z_291*z_186 + z_327*z_186 + z_328*z_247) + 2.0*c_4*(z_64*z_217 +
        z_20*z_306 + sin_delta*z_307 - z_162*z_217) + 2.0*c_2*(z_67*z_217 + z_163*z_217 - z_20*z_308 -
        sin_delta*(z_274*z_31)) + 2.0*c_6*(z_329*z_200 + z_330*z_274 - z_288*z_200) + 2.0*c_2*(z_334*z_279 +
        z_335*z_279 - z_313*z_336) + 2.0*c_3*(z_331*z_280 + z_317*z_333 - z_332*z_280) + c_6*z_173 -
        2.0*c_3*(z_36*z_235 + z_37*z_235 + z_29*z_208 - sin_delta*(z_242*z_29)) - 2.0*c_5*(z_291*z_183 +
        z_327*z_183 + z_328*z_242) - 2.0*c_2*(z_32*z_236 + z_26*z_209 - z_30*z_236 - sin_delta*(z_247*z_26)) -
        2.0*c_4*(z_67*z_221 + z_163*z_221 - z_20*z_309 - sin_delta*z_310) - 2.0*c_3*(z_64*z_221 + z_20*z_311 +
        sin_delta*(z_275*z_35) - z_162*z_221) - 2.0*c_5*(z_329*z_203 + z_330*z_275 - z_288*z_203) -
        2.0*c_4*(z_331*z_279 + z_313*z_333 - z_332*z_279) - 2.0*c_4*(z_334*z_280 + z_335*z_280 - z_317*z_336) -
        c_5*z_175));
    const double R_yy = c[15];
    bias[6] = -R_yy*z_122;
    bias[7] = F_yy*z_167;
    const double c_89 = c[115];
    const double z_337 = z_330 + z_35*z_41 - z_31*z_25;
    const double z_338 = z_337*z_337;
    const double z_339 = 1.0 - z_338;
    const double z_340 = sqrt(z_339);
    const double z_341 = 1.0/z_340;
    const double z_342 = z_337*z_341;
    const double z_343 = r_F*z_342;
    const double z_344 = (z_329 - z_288) + c_5*(sin_delta*z_64 + z_35*z_20 - sin_delta*z_162) +
        c_6*(sin_delta*z_67 + sin_delta*z_163 - z_31*z_20);
    const double z_345 = z_344*z_341;
    const double z_346 = z_344*z_338/(z_339*z_340);
    const double z_347 = c_*z_13;
    const double z_348 = c_*z_10;
    const double z_349 = r_F*z_8;
    const double z_350 = z_10*r_F;
    const double c_90 = c[116];
    const double z_351 = sin_delta*z_342;
    const double c_91 = c[117];
    const double c_93 = c[119];
    const double c_97 = c[123];
    const double c_92 = c[118];
    const double c_98 = c[124];
    const double z_352 = ((z_61*z_349 + c_93*z_215) - (z_62*z_350 + c_97*z_213)) - ((r_R*z_61 - c_1*z_62) +
        ((z_62*z_347 - c_92*z_213) - (z_61*z_348 - c_98*z_215)));
    const double z_353 = c_91*z_342;
    const double z_354 = z_23*z_351 - z_129*z_342 - z_345*z_83 - z_346*z_83;
    const double z_355 = c_90*z_342;
    const double z_356 = z_163 + z_67;
    const double z_357 = z_64 - z_162;
    gamma[0] = -(phi_dot*(((sin_delta*c_89 + cos_delta*z_343)*z_23 - cos_phi*(c_89*z_20 - r_F*(z_27*z_342 -
        cos_delta*z_345 - cos_delta*z_346))) + ((r_R + sin_theta*z_347 + cos_theta*z_348 + cos_theta*z_349 +
        sin_theta*z_350 + sin_theta*(c_90*z_351) - r_R*cos_theta - sin_theta*c_1 - cos_theta*(c_91*z_351))*z_1 +
        sin_phi*(c_90*(z_62*z_351 + z_335*z_342 + z_345*z_336 + z_346*z_336) + c_91*(z_61*z_351 - z_332*z_342 -
        z_345*z_333 - z_346*z_333) - z_352))) + delta_dot*(((sin_phi*c_89 + z_35*z_355 - z_31*z_353)*z_27 -
        cos_delta*(c_89*z_1 + c_91*(z_67*z_342 + z_163*z_342 - z_31*z_345 - z_31*z_346) + c_90*(z_64*z_342 +
        z_35*z_345 + z_35*z_346 - z_162*z_342))) - ((c_4*(c_*z_31 + r_F*z_35) - c_92*z_35 - sin_phi*z_343 -
        c_93*z_31)*z_20 - sin_delta*(c_4*(c_*z_356 - r_F*z_357) + c_92*z_357 + r_F*(z_342*z_1 + sin_phi*z_345 +
        sin_phi*z_346) - c_93*z_356))) - theta_dot*(((z_267 + z_83*z_353 - cos_phi*z_348 - cos_phi*z_349)*z_62 -
        sin_theta*(z_196 + (c_98*z_291 - z_23*z_348) + c_91*z_354 - (z_23*z_349 + c_93*z_291))) + ((cos_phi*c_1 -
        cos_phi*z_347 - cos_phi*z_350 - z_83*z_355)*z_61 + cos_theta*(c_1*z_23 + (c_97*z_291 - z_23*z_350) -
        (c_92*z_291 + z_23*z_347) - c_90*z_354))));
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
    const double z_369 = z_194 - c_6*z_368;
    const double z_370 = z_291 + z_327;
    const double z_371 = sin_delta*z_32 + z_20*z_26 - sin_delta*z_30;
    const double z_372 = sin_delta*z_36 + sin_delta*z_37 + z_20*z_29;
    const double z_373 = z_370 + c_5*z_372 - c_6*z_371;
    const double z_374 = r_F*(z_131*z_340 + z_109*z_367) - r_F*(z_342*(z_358*z_369) + z_342*(z_364*z_373) -
        z_345*z_365 - z_346*z_365);
    const double z_375 = z_358*z_367;
    const double z_376 = r_F*(z_375 + z_373*z_340) - r_F*(2.0*z_375 + z_346*(z_337*z_358) - z_373*z_359);
    const double z_377 = c_5*z_368 + z_189 + (-z_191);
    const double z_378 = r_F*(z_132*z_340 - z_110*z_367) + r_F*(z_342*(z_358*z_377) + z_345*z_362 + z_346*z_362 -
        z_342*(z_361*z_373));
    const double z_379 = c_6*(z_366*z_20 - sin_delta*z_374) + ((z_360*z_27 + cos_delta*z_376) - c_5*(z_363*z_20 +
        sin_delta*z_378));
    const double z_380 = z_10*z_363 + z_8*z_366 + z_360*z_25;
    const double z_381 = z_360*z_20 - sin_delta*z_376;
    const double z_382 = z_10*z_366 + z_13*z_363 - z_360*z_41;
    const double c_95 = c[121];
    const double z_383 = z_334 + z_335;
    const double c_96 = c[122];
    const double z_384 = z_331 - z_332;
    gamma[3] = -(z_121 - psi_dot*((z_382*z_64 + ((z_366*z_33 - z_10*z_374) - (z_363*z_44 - z_13*z_378) -
        c_5*z_381)*z_35 - z_382*z_162) - ((cos_delta*z_360 + z_363*z_41 - z_366*z_25)*z_1 - sin_phi*z_379) -
        (z_380*z_67 + z_380*z_163 - ((z_363*z_33 + z_10*z_378) + c_6*z_381 - (z_366*z_28 + z_8*z_374))*z_31) -
        z_141) - theta_dot*(z_379 - z_352) - delta_dot*(c_6*z_378 - c_5*z_374 - c_95*z_383 - c_96*z_384) -
        spin_f_dot*z_376);
    const double z_385 = cos_theta*z_41 + sin_theta*z_25;
    const double z_386 = r_F*(z_385*z_340 + z_385*z_359);
    const double z_387 = z_364*z_385;
    const double z_388 = r_F*(z_12*z_340 - z_342*z_387);
    const double z_389 = z_361*z_385;
    const double z_390 = r_F*(z_16*z_340 - z_342*z_389);
    const double z_391 = c_5*z_384 - c_6*z_383;
    const double z_392 = r_F*(z_79*z_340 + z_16*z_367) + r_F*(z_342*(z_385*z_377) + z_345*z_389 + z_346*z_389 -
        z_342*(z_361*z_391));
    const double z_393 = z_385*z_367;
    const double z_394 = r_F*(z_391*z_340 + z_393) - r_F*(2.0*z_393 + z_346*(z_337*z_385) - z_391*z_359);
    const double z_395 = r_F*(z_76*z_340 - z_12*z_367) + r_F*(z_342*(z_385*z_369) + z_342*(z_364*z_391) -
        z_345*z_387 - z_346*z_387);
    const double z_396 = c_5*(z_390*z_20 - sin_delta*z_392) + ((z_386*z_27 + cos_delta*z_394) + c_6*(z_388*z_20 +
        sin_delta*z_395));
    const double z_397 = z_8*z_388 + z_386*z_25 - z_10*z_390;
    const double z_398 = z_386*z_20 - sin_delta*z_394;
    const double z_399 = (z_388*z_28 - z_8*z_395) + (z_390*z_33 - z_10*z_392) - c_6*z_398;
    const double z_400 = z_13*z_390 + z_386*z_41 - z_10*z_388;
    const double z_401 = (z_390*z_44 + z_13*z_392) + (z_388*z_33 + z_10*z_395) - c_5*z_398;
    const double z_402 = c_92*z_27;
    const double z_403 = c_98*z_27;
    const double z_404 = c_93*z_27;
    const double z_405 = c_97*z_27;
    gamma[4] = -(z_57 + psi_dot*(((cos_delta*z_386 - z_388*z_25 - z_390*z_41)*z_1 - sin_phi*z_396) + (z_397*z_67 +
        z_397*z_163 + z_399*z_31) + (z_400*z_64 - z_400*z_162 - z_401*z_35) + z_102) - phi_dot*(z_196 +
        (z_397*z_62 - sin_theta*z_399) + c_1*z_357 + (z_67*z_348 + z_163*z_348 - z_31*z_403) + (z_67*z_349 +
        z_163*z_349 + z_31*z_404) - (z_400*z_61 + cos_theta*z_401) - r_R*z_356 - c_89*z_368 - (z_64*z_347 -
        z_35*z_402 - z_162*z_347) - (z_64*z_350 + z_35*z_405 - z_162*z_350)) - theta_dot*(z_396 + c_1*z_125 +
        (z_36*z_348 + z_37*z_348 + z_29*z_403) + (z_36*z_349 + z_37*z_349 - z_29*z_404) - r_R*z_124 - (z_32*z_347
        - z_30*z_347 - z_26*z_402) - (z_32*z_350 + z_26*z_405 - z_30*z_350)) - delta_dot*(c_5*z_395 + c_6*z_392 +
        c_95*z_371 + c_96*z_372 - c_89*z_370) - spin_f_dot*z_394);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ASIDE void energy(EM_UNUSED double t, const double *restrict x, const double *restrict v,
                     const double *restrict c, double *restrict e)
{
    const double x_dot = v[0];
    const double c_99 = c[125];
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
    const double c_0 = c[26];
    const double cos_theta = em_cos(theta);
    const double z_6 = sin_phi*cos_theta;
    const double z_7 = z_2 - x_B*z_4 - c_0*z_6;
    const double z_8 = m_B*z_7;
    const double m_F = c[9];
    const double c_ = c[1];
    const double c_2 = c[28];
    const double c_3 = c[29];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_10 = c_2 + c_3*cos_delta;
    const double c_4 = c[30];
    const double z_11 = c_4 - cos_delta*c_4;
    const double cos_phi = em_cos(phi);
    const double c_5 = c[31];
    const double sin_delta = em_sin(delta);
    const double z_14 = c_5*sin_delta;
    const double z_15 = z_10*z_4 + z_11*z_6 + cos_phi*z_14;
    const double r_F = c[5];
    const double z_16 = c_3 + c_2*cos_delta;
    const double c_6 = c[32];
    const double z_17 = c_6*sin_delta;
    const double z_18 = z_16*z_6 + z_11*z_4 - cos_phi*z_17;
    const double c_1 = c[27];
    const double z_19 = c_1*z_4 - (z_2 - r_R*z_6);
    const double z_20 = c_*z_15 + r_F*z_18 - z_19;
    const double z_21 = m_F*z_20;
    const double m_H = c[8];
    const double z_H = c[13];
    const double c_7 = c[33];
    const double z_22 = z_18*z_H + z_15*c_7 - z_19;
    const double z_23 = m_H*z_22;
    const double sin_psi = em_sin(psi);
    const double z_25 = x_B*cos_theta - sin_theta*c_0;
    const double z_26 = m_B*z_25;
    const double z_27 = cos_theta*z_11;
    const double z_28 = sin_theta*z_16 - z_27;
    const double z_29 = sin_theta*z_11;
    const double z_30 = cos_theta*z_10 - z_29;
    const double z_31 = cos_theta*c_1 - r_R*sin_theta;
    const double z_32 = r_F*z_28 + z_31 - c_*z_30;
    const double z_33 = m_F*z_32;
    const double z_34 = z_H*z_28 + z_31 - c_7*z_30;
    const double z_35 = m_H*z_34;
    const double c_8 = c[34];
    const double z_36 = sin_phi*c_8;
    const double z_37 = cos_psi*z_8 + cos_psi*z_21 + cos_psi*z_23 + cos_psi*z_36 - sin_psi*z_26 - sin_psi*z_33 -
        sin_psi*z_35;
    const double phi_dot = v[3];
    const double c_26 = c[52];
    const double z_38 = cos_phi*c_26;
    const double z_39 = sin_theta*cos_phi;
    const double c_27 = c[53];
    const double z_40 = sin_psi*c_27;
    const double z_41 = cos_theta*cos_phi;
    const double c_28 = c[54];
    const double z_42 = sin_psi*c_28;
    const double z_43 = sin_phi*sin_delta;
    const double c_29 = c[55];
    const double z_44 = sin_psi*c_29;
    const double c_30 = c[56];
    const double z_45 = z_16*c_30;
    const double z_46 = sin_psi*z_45;
    const double c_32 = c[58];
    const double z_47 = z_10*c_32;
    const double z_48 = sin_psi*z_47;
    const double z_49 = z_11*sin_psi;
    const double z_50 = c_32*z_49;
    const double z_51 = c_30*z_49;
    const double z_52 = sin_psi*z_38 + z_41*z_46 + z_39*z_48 + z_41*z_50 + z_39*z_51 - z_39*z_40 - z_41*z_42 -
        z_43*z_44;
    const double theta_dot = v[4];
    const double z_53 = cos_psi*c_27;
    const double z_54 = cos_psi*c_28;
    const double z_55 = cos_psi*z_45;
    const double z_56 = cos_psi*z_47;
    const double z_57 = cos_psi*z_11;
    const double z_58 = c_32*z_57;
    const double z_59 = c_30*z_57;
    const double z_60 = sin_theta*z_53 + cos_theta*z_54 + z_6*z_40 + z_4*z_46 + z_4*z_50 - cos_theta*z_55 -
        sin_theta*z_56 - cos_theta*z_58 - z_4*z_42 - sin_theta*z_59 - z_6*z_48 - z_6*z_51;
    const double delta_dot = v[5];
    const double z_61 = cos_theta*sin_delta;
    const double c_58 = c[84];
    const double z_62 = cos_psi*c_58;
    const double z_63 = cos_delta*cos_phi;
    const double z_64 = sin_theta*sin_delta;
    const double c_59 = c[85];
    const double z_65 = cos_psi*c_59;
    const double z_66 = sin_delta*z_6;
    const double z_67 = sin_psi*c_59;
    const double z_68 = sin_delta*z_4;
    const double z_69 = sin_psi*c_58;
    const double z_70 = z_61*z_62 + z_63*z_44 - z_64*z_65 - z_66*z_67 - z_68*z_69;
    const double y_dot = v[1];
    const double z_71 = cos_psi*z_26 + sin_psi*z_8 + cos_psi*z_33 + sin_psi*z_21 + cos_psi*z_35 + sin_psi*z_23 +
        sin_psi*z_36;
    const double z_72 = cos_psi*c_29;
    const double z_73 = z_39*z_53 + z_41*z_54 + z_43*z_72 - cos_psi*z_38 - z_41*z_55 - z_39*z_56 - z_41*z_58 -
        z_39*z_59;
    const double z_74 = sin_theta*z_40 + cos_theta*z_42 + z_4*z_54 + z_6*z_56 + z_6*z_59 - cos_theta*z_46 -
        sin_theta*z_48 - cos_theta*z_50 - z_6*z_53 - sin_theta*z_51 - z_4*z_55 - z_4*z_58;
    const double z_75 = z_61*z_69 + z_68*z_62 + z_66*z_65 - z_64*z_67 - z_63*z_72;
    const double z_76 = c_5*z_43 - z_10*z_39 - z_11*z_41;
    const double c_9 = c[35];
    const double z_77 = z_16*z_41 + z_11*z_39 + c_6*z_43;
    const double c_10 = c[36];
    const double z_78 = z_77*c_10 - z_76*c_9;
    const double c_11 = c[37];
    const double z_79 = z_76*c_10 - z_77*c_11;
    const double z_80 = sin_phi*cos_delta + z_39*z_14 - z_41*z_17;
    const double c_12 = c[38];
    const double z_81 = cos_delta*c_12;
    const double c_13 = c[39];
    const double z_82 = (z_78*z_14 + z_79*z_17) - (z_80*z_81 + sin_phi*c_13);
    const double c_15 = c[41];
    const double c_16 = c[42];
    const double c_17 = c[43];
    const double z_83 = sin_delta*z_80;
    const double z_84 = z_10*z_78 + c_15*z_39 + c_16*z_41 + c_17*z_83 - z_11*z_79;
    const double c_19 = c[45];
    const double c_20 = c[46];
    const double z_85 = z_11*z_78 + c_19*z_41 + c_16*z_39 - z_16*z_79 - c_20*z_83;
    const double c_100 = c[126];
    const double c_101 = c[127];
    const double c_102 = c[128];
    const double c_86 = c[112];
    const double c_38 = c[64];
    const double c_39 = c[65];
    const double z_86 = z_32*c_38 + z_34*c_39;
    const double z_87 = z_16*z_86;
    const double c_36 = c[62];
    const double c_37 = c[63];
    const double z_88 = z_32*c_36 + z_34*c_37;
    const double z_89 = z_10*z_88;
    const double z_90 = z_11*z_88;
    const double z_91 = z_11*z_86;
    const double z_92 = z_33 + z_35;
    const double c_42 = c[68];
    const double z_93 = z_92*c_42;
    const double c_74 = c[100];
    const double z_94 = z_92*c_74;
    const double c_70 = c[96];
    const double z_95 = z_88*c_70;
    const double c_72 = c[98];
    const double z_96 = z_86*c_72;
    const double c_79 = c[105];
    const double z_97 = z_25*c_79;
    const double c_78 = c[104];
    const double z_98 = z_25*c_78;
    const double z_99 = sin_theta*z_85 + z_41*z_93 + z_39*z_94 + z_43*z_95 + z_39*z_97 + z_41*z_98 -
        cos_theta*z_84 - 2.0*z_41*z_87 - 2.0*z_39*z_89 - 2.0*z_41*z_90 - 2.0*z_39*z_91 - cos_phi*(z_26 +
        z_92)*c_42 - z_43*z_96;
    const double z_100 = z_20*c_38 + z_22*c_39;
    const double z_101 = cos_theta*z_16;
    const double z_102 = z_20*c_36 + z_22*c_37;
    const double z_103 = sin_theta*z_10;
    const double z_104 = z_21 + z_23;
    const double z_105 = cos_theta*c_42;
    const double z_106 = sin_theta*c_74;
    const double z_107 = z_82 + 2.0*z_6*z_89 + 2.0*z_6*z_91 + z_104*z_105 + z_104*z_106 + c_79*(sin_theta*z_7) +
        c_78*(cos_theta*z_7) + z_4*z_93 + z_4*z_98 - 2.0*z_100*z_101 - 2.0*z_102*z_103 - 2.0*z_27*z_102 -
        2.0*z_29*z_100 - 2.0*z_4*z_87 - 2.0*z_4*z_90 - z_6*z_94 - z_6*z_97;
    const double c_77 = c[103];
    const double c_76 = c[102];
    const double c_75 = c[101];
    const double z_108 = c_6*z_78 + c_77*(z_102*z_61) + z_63*z_96 + c_77*(z_88*z_68) + c_76*(z_86*z_66) +
        c_75*(z_102*z_64) - c_5*z_79 - c_76*(z_100*z_64) - z_63*z_95 - c_75*(z_100*z_61) - c_75*(z_88*z_66) -
        c_75*(z_86*z_68);
    const double c_85 = c[111];
    const double spin_r_dot = v[6];
    const double spin_f_dot = v[7];
    const double c_122 = c[148];
    const double z_109 = spin_f_dot*c_122;
    const double z_110 = z_30*c_10 - z_28*c_11;
    const double z_111 = z_28*c_10 - z_30*c_9;
    const double z_112 = c_5*z_61 + c_6*z_64;
    const double z_113 = sin_delta*z_112;
    const double z_114 = z_27 + z_103;
    const double z_115 = z_29 + z_101;
    const double z_116 = sin_theta*c_1 - (r_R - r_R*cos_theta);
    const double z_117 = c_*z_114 + r_F*z_115 - z_116;
    const double z_118 = z_H*z_115 + c_7*z_114 - z_116;
    const double z_119 = c_38*z_117 + c_39*z_118;
    const double z_120 = c_36*z_117 + c_37*z_118;
    const double z_121 = r_R - x_B*sin_theta - c_0*cos_theta;
    const double z_122 = m_F*z_117 + m_H*z_118;
    const double c_103 = c[129];
    const double z_123 = sin_delta*sin_delta;
    const double c_104 = c[130];
    const double c_105 = c[131];
    const double c_106 = c[132];
    const double c_107 = c[133];
    const double z_124 = z_111*z_14 + z_110*z_17 + z_112*z_81 + c_107*z_61 + c_106*(z_16*z_64) + c_105*(z_11*z_64)
        - c_104*z_64 - c_105*(z_10*z_61) - c_106*(z_11*z_61);
    const double c_110 = c[136];
    const double c_111 = c[137];
    const double z_125 = c_6*z_111 + c_70*(cos_delta*z_120) - c_5*z_110 - c_110*(cos_theta*z_123) -
        c_111*(sin_theta*z_123) - c_72*(cos_delta*z_119);
    const double z_126 = r_R - c_*z_11 - r_F*z_16;
    const double z_127 = r_R - z_16*z_H - z_11*c_7;
    const double z_128 = c_38*z_126 + c_39*z_127;
    const double z_129 = c_1 - c_*z_10 - z_11*r_F;
    const double z_130 = c_1 - z_11*z_H - z_10*c_7;
    const double z_131 = c_36*z_129 + c_37*z_130;
    const double z_132 = c_36*z_126 + c_37*z_127;
    const double z_133 = c_38*z_129 + c_39*z_130;
    const double c_108 = c[134];
    const double c_109 = c[135];
    const double c_62 = c[88];
    const double z_134 = sin_delta*c_75;
    const double z_135 = sin_delta*c_62 + c_77*(sin_delta*z_132) + z_131*z_134 - c_76*(sin_delta*z_133) -
        z_128*z_134;
    const double c_123 = c[149];
    const double R_yy = c[15];
    const double F_yy = c[17];
    e[0] = 0.25*(2.0*x_dot*(x_dot*c_99 + psi_dot*z_37 + phi_dot*z_52 + delta_dot*z_70 - theta_dot*z_60) +
        2.0*y_dot*(y_dot*c_99 + psi_dot*z_71 + phi_dot*z_73 + delta_dot*z_75 - theta_dot*z_74) +
        psi_dot*(2.0*x_dot*z_37 + 2.0*y_dot*z_71 + psi_dot*(z_84*z_39 + z_85*z_41 + c_100*(z_25*z_25) +
        c_100*(z_7*z_7) + c_101*(z_32*z_32) + c_101*(z_20*z_20) + c_102*(z_34*z_34) + c_102*(z_22*z_22) +
        c_86*(sin_phi*sin_phi) - sin_phi*z_82) + phi_dot*z_99 + delta_dot*z_108 + c_85*(spin_r_dot*sin_phi) +
        z_80*z_109 - theta_dot*z_107) + phi_dot*(2.0*x_dot*z_52 + 2.0*y_dot*z_73 + psi_dot*z_99 +
        phi_dot*(2.0*z_101*z_119 + 2.0*z_103*z_120 + 2.0*z_27*z_120 + 2.0*z_29*z_119 + (c_8 + m_B*z_121 +
        z_122)*c_42 - sin_theta*(z_16*z_110 + cos_theta*c_16 - z_11*z_111 - sin_theta*c_19 - c_20*z_113) -
        cos_theta*(z_10*z_111 + sin_theta*c_16 - z_11*z_110 - cos_theta*c_15 - c_17*z_113) - c_103*z_123 -
        z_122*z_105 - z_122*z_106 - c_79*(sin_theta*z_121) - c_78*(cos_theta*z_121)) + delta_dot*z_125 -
        theta_dot*z_124 - z_112*z_109) + delta_dot*(2.0*x_dot*z_70 + 2.0*y_dot*z_75 + psi_dot*z_108 +
        phi_dot*z_125 - theta_dot*z_135 - delta_dot*c_123) + 2.0*spin_r_dot*(R_yy*(theta_dot + spin_r_dot +
        psi_dot*sin_phi)) + 2.0*spin_f_dot*(F_yy*(spin_f_dot + psi_dot*z_80 + theta_dot*cos_delta -
        phi_dot*z_112)) - theta_dot*(2.0*x_dot*z_60 + 2.0*y_dot*z_74 + psi_dot*z_107 + phi_dot*z_124 +
        delta_dot*z_135 - theta_dot*(c_108*z_123 + c_109 + (m_F*z_126 + m_H*z_127)*c_42 +
        c_12*(cos_delta*cos_delta) + (m_F*z_129 + m_H*z_130)*c_74 - 2.0*z_16*z_128 - 2.0*z_10*z_131 -
        2.0*z_11*z_132 - 2.0*z_11*z_133) - spin_r_dot*c_85 - cos_delta*z_109));
    e[1] = 0.0;
    e[2] = 0.0;
    const double g = c[3];
    const double z_136 = r_R*cos_phi;
    const double z_137 = c_1*z_39 - (z_136 - r_R*z_41);
    e[3] = g*(m_B*(z_136 - x_B*z_39 - c_0*z_41) + m_F*(r_F*z_77 - c_*z_76 - z_137) + m_H*(z_H*z_77 - c_7*z_76 -
        z_137) + cos_phi*c_8);
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
    const double c_3 = c[29];
    const double c_2 = c[28];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_3 = c_3 + c_2*cos_delta;
    const double cos_theta = em_cos(theta);
    const double c_4 = c[30];
    const double z_5 = c_4 - cos_delta*c_4;
    const double z_6 = sin_theta*z_3 - cos_theta*z_5;
    const double c_1 = c[27];
    const double c_ = c[1];
    const double z_7 = c_2 + c_3*cos_delta;
    const double z_8 = cos_theta*z_7 - sin_theta*z_5;
    const double r_R = c[4];
    const double z_9 = (r_F*z_6 + cos_theta*c_1) - (c_*z_8 + r_R*sin_theta);
    const double c_5 = c[31];
    const double sin_delta = em_sin(delta);
    const double z_11 = c_5*sin_delta;
    const double c_6 = c[32];
    const double z_12 = c_6*sin_delta;
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
    const double z_28 = (r_F*z_25 - r_R*z_23) - (c_1*z_24 - (z_26 + c_*z_27));
    const double z_29 = cos_delta*cos_phi + z_23*z_12 - z_24*z_11;
    const double z_30 = z_28 - z_29*z_20;
    p[3] = x_ + cos_psi*z_21 + sin_psi*z_30;
    p[4] = y + sin_psi*z_21 - cos_psi*z_30;
    const double z_31 = z_3*z_17 + z_5*z_16 + sin_phi*z_12;
    const double z_32 = sin_phi*z_11 - z_7*z_16 - z_5*z_17;
    const double z_33 = r_R*cos_phi;
    const double z_34 = (c_1*z_16 - r_F*z_31) + (c_*z_32 - (z_33 - r_R*z_17));
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
    const double c_124 = c[150];
    const double z_35 = sin_theta*z_B + cos_theta*c_124;
    const double c_42 = c[68];
    const double z_36 = z_B*z_23 + sin_phi*c_42 - c_124*z_24;
    p[25] = p[28] = 0.5*(2.0*x_ + cos_psi*z_35 + sin_psi*z_36);
    p[26] = p[29] = 0.5*(2.0*y + sin_psi*z_35 - cos_psi*z_36);
    p[27] = p[30] = 0.5*(z_B*z_17 + cos_phi*c_42 - c_124*z_16);
    const double c_125 = c[151];
    const double c_126 = c[152];
    const double c_127 = c[153];
    const double c_128 = c[154];
    const double z_37 = cos_theta*c_125 + z_6*c_127 - sin_theta*c_126 - z_8*c_128;
    const double z_38 = sin_phi*c_126 + z_25*c_127 + z_27*c_128 - c_126*z_23 - c_125*z_24;
    p[31] = p[34] = 0.25*(4.0*x_ + cos_psi*z_37 + sin_psi*z_38);
    p[32] = p[35] = 0.25*(4.0*y + sin_psi*z_37 - cos_psi*z_38);
    p[33] = p[36] = 0.25*(cos_phi*c_126 + z_31*c_127 - c_126*z_17 - c_125*z_16 - z_32*c_128);
    const double x_B = c[10];
    const double c_0 = c[26];
    const double z_39 = x_B*cos_theta - sin_theta*c_0;
    const double z_40 = z_26 - x_B*z_24 - c_0*z_23;
    p[40] = cos_psi*z_39 + z_40*sin_psi + x_;
    p[41] = -(z_40*cos_psi - z_39*sin_psi - y);
    p[42] = z_33 - x_B*z_16 - c_0*z_17;
    const double c_129 = c[155];
    p[43] = c_129;
}

#endif
#ifndef EM_ASIDE_ALONE

/* Where the other is linked it takes the place of this. */
extern em_lanes bicycle_lanes;
EM_WEAK em_lanes bicycle_lanes = {0, NULL, NULL, NULL};
#define EM_MODEL_LANES bicycle_lanes

#include "em_blocks.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0, 0, 0, 0 };
static const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 16, 80, 0, 64 };
static const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double r_R = parameters[4];
    const double z_B = parameters[11];
    const double z_0 = r_R - z_B;
    prepared[26] = z_0;
    const double c_ = parameters[1];
    const double w = parameters[0];
    const double z_1 = c_ + w;
    prepared[27] = z_1;
    const double tilt = parameters[2];
    const double sin_tilt = em_sin(tilt);
    const double z_3 = sin_tilt*sin_tilt;
    const double z_4 = z_3;
    prepared[28] = z_4;
    const double cos_tilt = em_cos(tilt);
    const double z_6 = cos_tilt*cos_tilt;
    const double z_7 = z_6;
    prepared[29] = z_7;
    const double z_8 = sin_tilt*cos_tilt;
    prepared[30] = z_8;
    prepared[31] = cos_tilt;
    prepared[32] = sin_tilt;
    const double x_H = parameters[12];
    const double z_9 = z_1 - x_H;
    prepared[33] = z_9;
    const double m_R = parameters[6];
    const double z_10 = m_R*r_R;
    prepared[34] = z_10;
    const double H_xx = parameters[22];
    const double F_xx = parameters[16];
    const double z_11 = H_xx + 2.0*F_xx;
    prepared[35] = H_xx + z_11;
    const double H_xz = parameters[25];
    prepared[36] = 2.0*H_xz;
    const double H_zz = parameters[24];
    const double z_12 = 2.0*F_xx + H_zz;
    prepared[37] = H_zz + z_12;
    const double F_yy = parameters[17];
    const double H_yy = parameters[23];
    const double z_13 = F_yy + H_yy;
    prepared[38] = 2.0*z_13;
    const double B_yy = parameters[19];
    const double R_yy = parameters[15];
    const double z_14 = B_yy + R_yy;
    prepared[39] = 2.0*z_14;
    prepared[40] = z_13;
    const double B_xx = parameters[18];
    const double R_xx = parameters[14];
    const double z_15 = B_xx + 2.0*R_xx;
    prepared[41] = B_xx + z_15;
    const double B_xz = parameters[21];
    prepared[42] = 2.0*B_xz;
    const double z_16 = cos_tilt*z_13;
    prepared[43] = 2.0*z_16;
    prepared[44] = z_16;
    const double B_zz = parameters[20];
    const double z_17 = 2.0*R_xx + B_zz;
    prepared[45] = B_zz + z_17;
    const double z_18 = sin_tilt*z_13;
    prepared[46] = 2.0*z_18;
    prepared[47] = z_18;
    const double m_B = parameters[7];
    prepared[48] = 4.0*m_B;
    const double m_F = parameters[9];
    prepared[49] = 4.0*m_F;
    const double m_H = parameters[8];
    prepared[50] = 4.0*m_H;
    const double z_19 = m_R*(r_R*r_R);
    prepared[51] = 4.0*z_19;
    const double z_20 = m_F + m_H;
    const double z_21 = m_B + m_R + z_20;
    prepared[52] = z_21*r_R;
    const double x_B = parameters[10];
    const double z_22 = m_B*x_B;
    prepared[53] = z_22 + z_1*z_20;
    const double z_23 = m_B*z_0;
    prepared[54] = z_23 + r_R*z_20;
    const double z_24 = m_F*c_;
    const double z_25 = m_H*z_9;
    const double z_26 = z_24 + z_25;
    const double r_F = parameters[5];
    const double z_27 = m_F*r_F;
    const double z_H = parameters[13];
    const double z_28 = m_H*z_H;
    const double z_29 = z_27 + z_28;
    prepared[55] = cos_tilt*z_26 - sin_tilt*z_29;
    prepared[56] = z_29;
    const double z_30 = z_29*z_3;
    prepared[57] = z_30;
    prepared[58] = z_26;
    const double z_31 = z_26*z_6;
    prepared[59] = z_31;
    const double z_32 = z_8*z_26;
    prepared[60] = z_32;
    const double z_33 = z_8*z_29;
    prepared[61] = z_33;
    prepared[62] = z_24;
    prepared[63] = z_25;
    prepared[64] = z_27;
    prepared[65] = z_28;
    prepared[66] = z_22;
    prepared[67] = z_23;
    prepared[68] = 2.0*r_R;
    const double z_34 = sin_tilt*r_F;
    const double z_35 = z_34 - c_*cos_tilt;
    const double z_36 = sin_tilt*z_H - cos_tilt*z_9;
    const double z_37 = z_24*z_35 + z_25*z_36;
    const double z_38 = z_27*z_35 + z_28*z_36;
    const double z_39 = cos_tilt*z_37 - sin_tilt*z_38;
    prepared[69] = 4.0*z_39;
    const double z_40 = m_F*z_35 + m_H*z_36;
    const double z_41 = r_R*z_40;
    prepared[70] = z_41;
    prepared[71] = z_37;
    const double z_42 = z_37*z_6;
    prepared[72] = z_42;
    prepared[73] = z_38;
    const double z_43 = z_8*z_38;
    prepared[74] = z_43;
    const double z_44 = z_1*z_40;
    prepared[75] = z_44;
    const double z_45 = z_38*z_3;
    prepared[76] = z_45;
    const double z_46 = z_8*z_37;
    prepared[77] = z_46;
    const double z_47 = r_F*z_3;
    const double z_48 = c_*z_8;
    const double z_49 = z_47 - z_48;
    const double z_50 = z_H*z_3 - z_8*z_9;
    const double z_51 = z_27*z_49 + z_28*z_50;
    prepared[78] = z_51;
    const double z_52 = c_*z_6;
    const double z_53 = z_8*r_F;
    const double z_54 = z_52 - z_53;
    const double z_55 = z_8*z_H - z_9*z_6;
    const double z_56 = z_24*z_54 - z_25*z_55;
    prepared[79] = z_56;
    const double z_57 = z_24*z_49 + z_25*z_50;
    prepared[80] = z_57;
    const double z_58 = z_27*z_54 - z_28*z_55;
    prepared[81] = z_58;
    prepared[82] = r_R*(m_F*z_49 + m_H*z_50) + z_1*(m_F*z_54 - m_H*z_55);
    const double z_59 = sin_tilt*H_xz;
    const double z_60 = cos_tilt*H_xx + cos_tilt*z_11 - 2.0*z_59;
    const double z_61 = cos_tilt*H_xz;
    const double z_62 = sin_tilt*H_zz + sin_tilt*z_12 - 2.0*z_61;
    const double z_63 = cos_tilt*z_60 + sin_tilt*z_62;
    prepared[83] = 2.0*z_13 - z_63;
    prepared[84] = z_31 - z_33;
    prepared[85] = z_30 - z_32;
    const double z_64 = z_45 - z_46;
    prepared[86] = z_64;
    const double z_65 = z_42 - z_43;
    prepared[87] = z_65;
    prepared[88] = sin_tilt*z_60 - cos_tilt*z_62;
    prepared[89] = z_58*z_3;
    prepared[90] = z_57*z_6;
    prepared[91] = z_8*z_51;
    prepared[92] = z_8*z_56;
    prepared[93] = z_11;
    prepared[94] = z_12;
    prepared[95] = z_15;
    prepared[96] = 2.0*cos_tilt;
    prepared[97] = z_17;
    prepared[98] = 2.0*sin_tilt;
    const double g = parameters[3];
    const double z_66 = m_B*g;
    const double z_67 = m_H*g + m_F*g;
    prepared[99] = (-2.0)*(z_10*g + r_R*(z_66 + z_67));
    prepared[100] = 2.0*z_1;
    prepared[101] = 2.0*z_8;
    prepared[102] = 2.0*z_4;
    prepared[103] = 2.0*z_7;
    prepared[104] = 2.0*z_23;
    prepared[105] = 2.0*z_22;
    const double z_68 = z_28*g + z_27*g;
    prepared[106] = 2.0*z_68;
    const double z_69 = z_25*g + z_24*g;
    prepared[107] = 2.0*z_69;
    prepared[108] = 2.0*(z_0*z_66 + r_R*z_67);
    prepared[109] = 2.0*(x_B*z_66 + z_1*z_67);
    prepared[110] = 2.0*B_yy;
    prepared[111] = 2.0*R_yy;
    prepared[112] = 2.0*z_19;
    prepared[113] = 2.0*z_10;
    prepared[114] = 2.0*(sin_tilt*z_68 - cos_tilt*z_69);
    prepared[115] = z_35;
    prepared[116] = cos_tilt*r_F;
    prepared[117] = z_34;
    prepared[118] = z_52;
    prepared[119] = z_47;
    prepared[120] = -r_R;
    prepared[121] = z_49;
    prepared[122] = z_54;
    prepared[123] = z_53;
    prepared[124] = z_48;
    prepared[125] = z_21;
    prepared[126] = 2.0*m_B;
    prepared[127] = 2.0*m_F;
    prepared[128] = 2.0*m_H;
    prepared[129] = 2.0*z_39;
    prepared[130] = 2.0*z_41;
    prepared[131] = 2.0*z_37;
    prepared[132] = 2.0*z_38;
    prepared[133] = 2.0*z_44;
    prepared[134] = z_63;
    prepared[135] = 2.0*(z_14 + m_B*(x_B*x_B) + m_B*(z_0*z_0));
    prepared[136] = 2.0*z_64;
    prepared[137] = 2.0*z_65;
    const double z_70 = 2.0*z_39 - sin_tilt*(2.0*z_61 + sin_tilt*H_xx + sin_tilt*z_11) - cos_tilt*(2.0*z_59 +
        cos_tilt*H_zz + cos_tilt*z_12);
    prepared[138] = (-0.5)*z_70;
    prepared[139] = 4.0*z_64;
    prepared[140] = 4.0*z_65;
    prepared[141] = 2.0*fabs(r_R);
    const double z_71 = fabs(cos_tilt);
    const double z_72 = z_71 + fabs(tilt*sin_tilt);
    prepared[142] = 2.0*(z_71*z_72);
    const double z_73 = fabs(sin_tilt);
    const double z_74 = z_73 + fabs(tilt*cos_tilt);
    prepared[143] = z_74*z_71 + z_73*z_72;
    prepared[144] = fabs(z_8);
    prepared[145] = 2.0*fabs(r_F);
    prepared[146] = 2.0*(z_73*z_74);
    prepared[147] = 2.0*fabs(c_);
    prepared[148] = 2.0*F_yy;
    prepared[149] = z_70;
    prepared[150] = 2.0*x_B;
    prepared[151] = 4.0*z_1;
    prepared[152] = 4.0*r_R;
    prepared[153] = 5.0*z_H;
    prepared[154] = 4.0*z_9;
    prepared[155] = (1.0/3.0)*r_R;
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
    const double c_99 = c[125];
    M[0] = c_99;
    M[8] = M[1] = 0.0;
    M[9] = c_99;
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
    const double c_0 = c[26];
    const double cos_theta = em_cos(theta);
    const double z_6 = sin_phi*cos_theta;
    const double z_7 = z_2 - x_B*z_4 - c_0*z_6;
    const double z_8 = m_B*z_7;
    const double m_F = c[9];
    const double c_ = c[1];
    const double c_2 = c[28];
    const double c_3 = c[29];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_10 = c_2 + c_3*cos_delta;
    const double c_4 = c[30];
    const double z_11 = c_4 - cos_delta*c_4;
    const double cos_phi = em_cos(phi);
    const double c_5 = c[31];
    const double sin_delta = em_sin(delta);
    const double z_14 = c_5*sin_delta;
    const double z_15 = z_10*z_4 + z_11*z_6 + cos_phi*z_14;
    const double r_F = c[5];
    const double z_16 = c_3 + c_2*cos_delta;
    const double c_6 = c[32];
    const double z_17 = c_6*sin_delta;
    const double z_18 = z_16*z_6 + z_11*z_4 - cos_phi*z_17;
    const double c_1 = c[27];
    const double z_19 = c_1*z_4 - (z_2 - r_R*z_6);
    const double z_20 = c_*z_15 + r_F*z_18 - z_19;
    const double z_21 = m_F*z_20;
    const double m_H = c[8];
    const double z_H = c[13];
    const double c_7 = c[33];
    const double z_22 = z_18*z_H + z_15*c_7 - z_19;
    const double z_23 = m_H*z_22;
    const double sin_psi = em_sin(psi);
    const double z_25 = x_B*cos_theta - sin_theta*c_0;
    const double z_26 = m_B*z_25;
    const double z_27 = cos_theta*z_11;
    const double z_28 = sin_theta*z_16 - z_27;
    const double z_29 = sin_theta*z_11;
    const double z_30 = cos_theta*z_10 - z_29;
    const double z_31 = cos_theta*c_1 - r_R*sin_theta;
    const double z_32 = r_F*z_28 + z_31 - c_*z_30;
    const double z_33 = m_F*z_32;
    const double z_34 = z_H*z_28 + z_31 - c_7*z_30;
    const double z_35 = m_H*z_34;
    const double c_8 = c[34];
    const double z_36 = sin_phi*c_8;
    M[16] = M[2] = cos_psi*z_8 + cos_psi*z_21 + cos_psi*z_23 + cos_psi*z_36 - sin_psi*z_26 - sin_psi*z_33 -
        sin_psi*z_35;
    M[17] = M[10] = cos_psi*z_26 + sin_psi*z_8 + cos_psi*z_33 + sin_psi*z_21 + cos_psi*z_35 + sin_psi*z_23 +
        sin_psi*z_36;
    const double z_37 = sin_phi*sin_delta;
    const double z_38 = sin_theta*cos_phi;
    const double z_39 = cos_theta*cos_phi;
    const double z_40 = c_5*z_37 - z_10*z_38 - z_11*z_39;
    const double c_9 = c[35];
    const double z_41 = z_16*z_39 + z_11*z_38 + c_6*z_37;
    const double c_10 = c[36];
    const double z_42 = z_41*c_10 - z_40*c_9;
    const double c_11 = c[37];
    const double z_43 = z_40*c_10 - z_41*c_11;
    const double z_44 = sin_phi*cos_delta + z_38*z_14 - z_39*z_17;
    const double c_12 = c[38];
    const double z_45 = cos_delta*c_12;
    const double c_13 = c[39];
    const double z_46 = (z_42*z_14 + z_43*z_17) - (z_44*z_45 + sin_phi*c_13);
    const double c_15 = c[41];
    const double c_16 = c[42];
    const double c_17 = c[43];
    const double z_47 = sin_delta*z_44;
    const double z_48 = z_10*z_42 + c_15*z_38 + c_16*z_39 + c_17*z_47 - z_11*z_43;
    const double c_19 = c[45];
    const double c_20 = c[46];
    const double z_49 = z_11*z_42 + c_19*z_39 + c_16*z_38 - z_16*z_43 - c_20*z_47;
    const double c_100 = c[126];
    const double c_101 = c[127];
    const double c_102 = c[128];
    const double c_86 = c[112];
    M[18] = 0.5*(z_48*z_38 + z_49*z_39 + c_100*(z_25*z_25) + c_100*(z_7*z_7) + c_101*(z_32*z_32) +
        c_101*(z_20*z_20) + c_102*(z_34*z_34) + c_102*(z_22*z_22) + c_86*(sin_phi*sin_phi) - sin_phi*z_46);
    const double c_26 = c[52];
    const double z_50 = cos_phi*c_26;
    const double c_27 = c[53];
    const double z_51 = sin_psi*c_27;
    const double c_28 = c[54];
    const double z_52 = sin_psi*c_28;
    const double c_29 = c[55];
    const double z_53 = sin_psi*c_29;
    const double c_30 = c[56];
    const double z_54 = z_16*c_30;
    const double z_55 = sin_psi*z_54;
    const double c_32 = c[58];
    const double z_56 = z_10*c_32;
    const double z_57 = sin_psi*z_56;
    const double z_58 = z_11*sin_psi;
    const double z_59 = c_32*z_58;
    const double z_60 = c_30*z_58;
    M[24] = M[3] = sin_psi*z_50 + z_39*z_55 + z_38*z_57 + z_39*z_59 + z_38*z_60 - z_38*z_51 - z_39*z_52 -
        z_37*z_53;
    const double z_61 = cos_psi*c_27;
    const double z_62 = cos_psi*c_28;
    const double z_63 = cos_psi*c_29;
    const double z_64 = cos_psi*z_54;
    const double z_65 = cos_psi*z_56;
    const double z_66 = cos_psi*z_11;
    const double z_67 = c_32*z_66;
    const double z_68 = c_30*z_66;
    M[25] = M[11] = z_38*z_61 + z_39*z_62 + z_37*z_63 - cos_psi*z_50 - z_39*z_64 - z_38*z_65 - z_39*z_67 -
        z_38*z_68;
    const double c_38 = c[64];
    const double c_39 = c[65];
    const double z_69 = z_32*c_38 + z_34*c_39;
    const double z_70 = z_16*z_69;
    const double c_36 = c[62];
    const double c_37 = c[63];
    const double z_71 = z_32*c_36 + z_34*c_37;
    const double z_72 = z_10*z_71;
    const double z_73 = z_11*z_71;
    const double z_74 = z_11*z_69;
    const double c_42 = c[68];
    const double z_75 = z_33 + z_35;
    const double z_76 = z_75*c_42;
    const double c_74 = c[100];
    const double z_77 = z_75*c_74;
    const double c_70 = c[96];
    const double z_78 = z_71*c_70;
    const double c_72 = c[98];
    const double z_79 = z_69*c_72;
    const double c_79 = c[105];
    const double z_80 = z_25*c_79;
    const double c_78 = c[104];
    const double z_81 = z_25*c_78;
    M[26] = M[19] = 0.5*(sin_theta*z_49 + z_39*z_76 + z_38*z_77 + z_37*z_78 + z_38*z_80 + z_39*z_81 -
        cos_theta*z_48 - 2.0*z_39*z_70 - 2.0*z_38*z_72 - 2.0*z_39*z_73 - 2.0*z_38*z_74 - c_42*(cos_phi*(z_26 +
        z_75)) - z_37*z_79);
    const double z_82 = z_30*c_10 - z_28*c_11;
    const double z_83 = z_28*c_10 - z_30*c_9;
    const double z_84 = cos_theta*sin_delta;
    const double z_85 = sin_theta*sin_delta;
    const double z_86 = c_5*z_84 + c_6*z_85;
    const double z_87 = sin_delta*z_86;
    const double z_88 = cos_theta*z_16;
    const double z_89 = sin_theta*z_10;
    const double z_90 = z_27 + z_89;
    const double z_91 = z_29 + z_88;
    const double z_92 = sin_theta*c_1 - (r_R - r_R*cos_theta);
    const double z_93 = c_*z_90 + r_F*z_91 - z_92;
    const double z_94 = z_H*z_91 + c_7*z_90 - z_92;
    const double z_95 = c_38*z_93 + c_39*z_94;
    const double z_96 = c_36*z_93 + c_37*z_94;
    const double z_97 = r_R - x_B*sin_theta - c_0*cos_theta;
    const double z_98 = m_F*z_93 + m_H*z_94;
    const double c_103 = c[129];
    const double z_99 = sin_delta*sin_delta;
    const double z_100 = cos_theta*c_42;
    const double z_101 = sin_theta*c_74;
    M[27] = 0.5*(2.0*z_88*z_95 + 2.0*z_89*z_96 + 2.0*z_27*z_96 + 2.0*z_29*z_95 + (c_8 + m_B*z_97 + z_98)*c_42 -
        sin_theta*(z_16*z_82 + cos_theta*c_16 - z_11*z_83 - sin_theta*c_19 - c_20*z_87) - cos_theta*(z_10*z_83 +
        sin_theta*c_16 - z_11*z_82 - cos_theta*c_15 - c_17*z_87) - c_103*z_99 - z_98*z_100 - z_98*z_101 -
        c_79*(sin_theta*z_97) - c_78*(cos_theta*z_97));
    M[32] = M[4] = -(sin_theta*z_61 + cos_theta*z_62 + z_6*z_51 + z_4*z_55 + z_4*z_59 - cos_theta*z_64 -
        sin_theta*z_65 - cos_theta*z_67 - z_4*z_52 - sin_theta*z_68 - z_6*z_57 - z_6*z_60);
    M[33] = M[12] = -(sin_theta*z_51 + cos_theta*z_52 + z_4*z_62 + z_6*z_65 + z_6*z_68 - cos_theta*z_55 -
        sin_theta*z_57 - cos_theta*z_59 - z_6*z_61 - sin_theta*z_60 - z_4*z_64 - z_4*z_67);
    const double z_102 = z_20*c_38 + z_22*c_39;
    const double z_103 = z_20*c_36 + z_22*c_37;
    const double z_104 = z_21 + z_23;
    M[34] = M[20] = (-0.5)*(z_46 + 2.0*z_6*z_72 + 2.0*z_6*z_74 + z_104*z_100 + z_104*z_101 + c_79*(sin_theta*z_7)
        + c_78*(cos_theta*z_7) + z_4*z_76 + z_4*z_81 - 2.0*z_102*z_88 - 2.0*z_103*z_89 - 2.0*z_27*z_103 -
        2.0*z_29*z_102 - 2.0*z_4*z_70 - 2.0*z_4*z_73 - z_6*z_77 - z_6*z_80);
    const double c_104 = c[130];
    const double c_105 = c[131];
    const double c_106 = c[132];
    const double c_107 = c[133];
    M[35] = M[28] = (-0.5)*(z_83*z_14 + z_82*z_17 + z_86*z_45 + c_107*z_84 + c_106*(z_16*z_85) + c_105*(z_11*z_85)
        - c_104*z_85 - c_105*(z_10*z_84) - c_106*(z_11*z_84));
    const double z_105 = r_R - c_*z_11 - r_F*z_16;
    const double z_106 = r_R - z_16*z_H - z_11*c_7;
    const double z_107 = c_38*z_105 + c_39*z_106;
    const double z_108 = c_1 - c_*z_10 - z_11*r_F;
    const double z_109 = c_1 - z_11*z_H - z_10*c_7;
    const double z_110 = c_36*z_108 + c_37*z_109;
    const double z_111 = c_36*z_105 + c_37*z_106;
    const double z_112 = c_38*z_108 + c_39*z_109;
    const double c_108 = c[134];
    const double c_109 = c[135];
    M[36] = 0.5*(c_108*z_99 + c_109 + (m_F*z_105 + m_H*z_106)*c_42 + c_12*(cos_delta*cos_delta) + (m_F*z_108 +
        m_H*z_109)*c_74 - 2.0*z_16*z_107 - 2.0*z_10*z_110 - 2.0*z_11*z_111 - 2.0*z_11*z_112);
    const double c_58 = c[84];
    const double z_113 = cos_psi*c_58;
    const double z_114 = cos_delta*cos_phi;
    const double c_59 = c[85];
    const double z_115 = cos_psi*c_59;
    const double z_116 = sin_delta*z_6;
    const double z_117 = sin_psi*c_59;
    const double z_118 = sin_delta*z_4;
    const double z_119 = sin_psi*c_58;
    M[40] = M[5] = z_84*z_113 + z_114*z_53 - z_85*z_115 - z_116*z_117 - z_118*z_119;
    M[41] = M[13] = z_84*z_119 + z_118*z_113 + z_116*z_115 - z_85*z_117 - z_114*z_63;
    const double c_77 = c[103];
    const double c_76 = c[102];
    const double c_75 = c[101];
    M[42] = M[21] = 0.5*(c_6*z_42 + c_77*(z_103*z_84) + z_114*z_79 + c_77*(z_71*z_118) + c_76*(z_69*z_116) +
        c_75*(z_103*z_85) - c_5*z_43 - c_76*(z_102*z_85) - z_114*z_78 - c_75*(z_102*z_84) - c_75*(z_71*z_116) -
        c_75*(z_69*z_118));
    const double c_110 = c[136];
    const double c_111 = c[137];
    M[43] = M[29] = 0.5*(c_6*z_83 + c_70*(cos_delta*z_96) - c_5*z_82 - c_110*(cos_theta*z_99) -
        c_111*(sin_theta*z_99) - c_72*(cos_delta*z_95));
    const double c_62 = c[88];
    const double z_120 = sin_delta*c_75;
    M[44] = M[37] = (-0.5)*(sin_delta*c_62 + c_77*(sin_delta*z_111) + z_110*z_120 - c_76*(sin_delta*z_112) -
        z_107*z_120);
    const double c_112 = c[138];
    M[45] = c_112;
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

/* What is factored, of which motion_bias is */
static void (*const factored)(double t, const double *restrict x, const double *restrict c, double *restrict M) =
    mass_matrix;

/* A (m, n), b (m): A xdot + b = 0                                                                               (8) */
static void pfaffian(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                     double *restrict A, double *restrict b)
{
    A[0] = 0.0;
    A[1] = 0.0;
    A[2] = 0.0;
    const double phi = x[3];
    const double cos_phi = em_cos(phi);
    const double delta = x[5];
    const double sin_delta = em_sin(delta);
    const double c_89 = c[115];
    const double cos_delta = em_cos(delta);
    const double r_F = c[5];
    const double sin_phi = em_sin(phi);
    const double theta = x[4];
    const double sin_theta = em_sin(theta);
    const double z_5 = sin_theta*cos_phi;
    const double c_5 = c[31];
    const double z_6 = c_5*sin_delta;
    const double cos_theta = em_cos(theta);
    const double z_8 = cos_theta*cos_phi;
    const double c_6 = c[32];
    const double z_9 = c_6*sin_delta;
    const double z_10 = sin_phi*cos_delta + z_5*z_6 - z_8*z_9;
    const double z_11 = z_10*z_10;
    const double z_12 = sqrt(1.0 - z_11);
    const double z_13 = 1.0/z_12;
    const double z_14 = z_10*z_13;
    const double z_15 = r_F*z_14;
    const double r_R = c[4];
    const double c_90 = c[116];
    const double z_16 = sin_delta*z_14;
    const double c_91 = c[117];
    const double c_3 = c[29];
    const double c_2 = c[28];
    const double z_17 = c_3 + c_2*cos_delta;
    const double z_18 = r_F*z_17;
    const double c_4 = c[30];
    const double z_19 = c_4 - cos_delta*c_4;
    const double z_20 = z_19*r_F;
    const double c_1 = c[27];
    const double c_ = c[1];
    const double z_21 = c_2 + c_3*cos_delta;
    const double z_22 = c_*z_21;
    const double z_23 = c_*z_19;
    const double z_24 = (cos_theta*z_18 + sin_theta*z_20) - ((r_R*cos_theta + sin_theta*c_1) - (sin_theta*z_22 +
        cos_theta*z_23));
    A[3] = cos_phi*(sin_delta*c_89 + cos_delta*z_15) - sin_phi*(r_R + sin_theta*c_90*z_16 + z_24 -
        cos_theta*c_91*z_16);
    const double z_25 = r_R*cos_phi;
    const double z_26 = cos_phi*z_16;
    A[4] = sin_theta*(z_25 + c_91*z_26 - cos_phi*z_23 - cos_phi*z_18) - cos_theta*(cos_phi*c_1 - cos_phi*z_22 -
        cos_phi*z_20 - c_90*z_26);
    const double z_27 = sin_phi*c_89;
    const double c_92 = c[118];
    const double c_93 = c[119];
    A[5] = cos_delta*(z_27 + c_90*z_14*z_5 - c_91*z_14*z_8) + sin_delta*(c_4*(c_*z_8 + r_F*z_5) - c_92*z_5 -
        sin_phi*z_15 - c_93*z_8);
    A[6] = 0.0;
    A[7] = 0.0;
    const double psi = x[2];
    const double cos_psi = em_cos(psi);
    A[8] = cos_psi;
    const double sin_psi = em_sin(psi);
    A[9] = sin_psi;
    A[10] = 0.0;
    A[11] = 0.0;
    const double c_94 = c[120];
    A[12] = c_94;
    A[13] = 0.0;
    A[14] = c_94;
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
        z_39*z_6)*z_5 - r_R*z_31 - c_1*z_30 - sin_phi*(-z_42);
    A[27] = 0.0;
    A[28] = -(-z_42 - z_24);
    const double c_95 = c[121];
    const double z_43 = sin_delta*c_95;
    const double c_96 = c[122];
    const double z_44 = sin_delta*c_96;
    A[29] = c_6*z_41 + c_5*z_37 + cos_theta*z_44 - sin_theta*z_43;
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
    A[34] = r_F*z_45 + cos_theta*c_1 + z_52*z_8 - c_*z_46 - r_R*sin_theta - sin_phi*(-z_51) - z_53*z_5;
    A[35] = -(z_25 + sin_delta*z_27 + z_5*z_22 + z_8*z_23 + z_8*z_18 + z_5*z_20 - sin_theta*z_52 - cos_theta*z_53
        - r_R*z_8 - c_1*z_5);
    A[36] = -(r_R*z_30 + z_31*z_22 + z_31*z_20 - c_1*z_31 - z_30*z_23 - z_30*z_18 - z_51);
    A[37] = c_5*z_50 + c_89*z_35 + z_31*z_43 + z_30*z_44 - c_6*z_48;
    A[38] = 0.0;
    A[39] = -z_49;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    b[4] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
static void position(EM_UNUSED double t, const double *restrict x, const double *restrict c,
                     double *restrict phi, double *restrict terms)
{
    const double r_R = c[4];
    const double phi_ = x[3];
    const double cos_phi_ = em_cos(phi_);
    const double z_1 = r_R*cos_phi_;
    const double theta = x[4];
    const double cos_theta = em_cos(theta);
    const double z_3 = cos_theta*cos_phi_;
    const double c_1 = c[27];
    const double sin_theta = em_sin(theta);
    const double z_5 = sin_theta*cos_phi_;
    const double r_F = c[5];
    const double c_3 = c[29];
    const double c_2 = c[28];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_7 = c_3 + c_2*cos_delta;
    const double c_4 = c[30];
    const double z_8 = c_4 - cos_delta*c_4;
    const double sin_phi_ = em_sin(phi_);
    const double c_6 = c[32];
    const double sin_delta = em_sin(delta);
    const double z_11 = c_6*sin_delta;
    const double c_ = c[1];
    const double c_5 = c[31];
    const double z_12 = c_5*sin_delta;
    const double z_13 = c_2 + c_3*cos_delta;
    const double z_14 = sin_phi_*cos_delta + z_5*z_12 - z_3*z_11;
    const double z_15 = sqrt(1.0 - z_14*z_14);
    phi[0] = z_1 + r_F*(z_7*z_3 + z_8*z_5 + sin_phi_*z_11) - r_R*z_3 - c_1*z_5 - c_*(sin_phi_*z_12 - z_13*z_5 -
        z_8*z_3) - r_F*z_15;
    const double z_16 = fabs(cos_theta) + fabs(theta*sin_theta);
    const double z_17 = fabs(cos_phi_) + fabs(phi_*sin_phi_);
    const double z_18 = fabs(sin_theta) + fabs(theta*cos_theta);
    const double z_19 = fabs(sin_phi_);
    const double z_20 = z_19 + fabs(phi_*cos_phi_);
    const double z_21 = fabs(cos_delta);
    const double z_22 = z_21 + fabs(delta*sin_delta);
    const double z_23 = fabs(sin_delta) + fabs(delta*cos_delta);
    const double c_115 = c[141];
    const double c_116 = c[142];
    const double z_24 = fabs(z_3);
    const double z_25 = fabs(z_8*cos_phi_);
    const double c_117 = c[143];
    const double c_118 = c[144];
    const double z_26 = c_117 + z_22*c_118;
    const double z_27 = fabs(z_5);
    const double c_119 = c[145];
    const double c_120 = c[146];
    const double c_121 = c[147];
    terms[0] = 0.5*(2.0*(z_16*fabs(z_1) + z_17*fabs(r_R*cos_theta)) + 2.0*(z_18*fabs(cos_phi_*c_1) +
        z_17*fabs(sin_theta*c_1)) + (1.0 + 2.0*((z_20*z_21 + z_19*z_22) + (z_18*fabs(cos_phi_*z_12) +
        z_17*fabs(sin_theta*z_12) + z_23*fabs(c_5*z_5)) + (z_16*fabs(cos_phi_*z_11) + z_17*fabs(cos_theta*z_11) +
        z_23*fabs(c_6*z_3)))*fabs(z_14))*fabs(r_F/z_15) + z_17*c_115 + ((z_16*fabs(cos_phi_*z_7) +
        z_17*fabs(cos_theta*z_7) + (c_116 + c_2*z_22)*z_24) + (z_18*z_25 + z_26*z_27 + z_17*fabs(sin_theta*z_8)) +
        (z_20*fabs(z_11) + z_23*fabs(sin_phi_*c_6)))*c_119 + ((z_20*fabs(z_12) + z_23*fabs(sin_phi_*c_5)) +
        (z_18*fabs(z_13*cos_phi_) + (c_120 + c_3*z_22)*z_27 + z_17*fabs(sin_theta*z_13)) + (z_16*z_25 + z_26*z_24
        + z_17*fabs(cos_theta*z_8)))*c_121);
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
                              double A1[N_ROWS][N1], double b[N_ROWS], double shared[75])
{
    const double c_99 = c[125];
    M1[0][0] = c_99;
    M1[0][1] = M1[1][0] = 0.0;
    M1[1][1] = c_99;
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
    const double c_0 = c[26];
    const double cos_theta = em_cos(theta);
    const double z_6 = sin_phi*cos_theta;
    const double z_7 = z_2 - x_B*z_4 - c_0*z_6;
    const double z_8 = m_B*z_7;
    const double m_F = c[9];
    const double c_1 = c[27];
    const double z_9 = c_1*z_4 - (z_2 - r_R*z_6);
    const double c_ = c[1];
    const double c_2 = c[28];
    const double c_3 = c[29];
    const double delta = x[5];
    const double cos_delta = em_cos(delta);
    const double z_11 = c_2 + c_3*cos_delta;
    const double c_4 = c[30];
    const double z_12 = c_4 - cos_delta*c_4;
    const double cos_phi = em_cos(phi);
    const double c_5 = c[31];
    const double sin_delta = em_sin(delta);
    const double z_15 = c_5*sin_delta;
    const double z_16 = z_11*z_4 + z_12*z_6 + cos_phi*z_15;
    const double r_F = c[5];
    const double z_17 = c_3 + c_2*cos_delta;
    const double c_6 = c[32];
    const double z_18 = c_6*sin_delta;
    const double z_19 = z_17*z_6 + z_12*z_4 - cos_phi*z_18;
    const double z_20 = z_9 - (c_*z_16 + r_F*z_19);
    const double z_21 = -z_20;
    const double z_22 = m_F*z_21;
    const double m_H = c[8];
    const double z_H = c[13];
    const double c_7 = c[33];
    const double z_23 = z_19*z_H + z_16*c_7 - z_9;
    const double z_24 = m_H*z_23;
    const double sin_psi = em_sin(psi);
    const double z_26 = x_B*cos_theta - sin_theta*c_0;
    const double z_27 = m_B*z_26;
    const double z_28 = cos_theta*c_1 - r_R*sin_theta;
    const double z_29 = cos_theta*z_12;
    const double z_30 = sin_theta*z_17 - z_29;
    const double z_31 = sin_theta*z_12;
    const double z_32 = cos_theta*z_11 - z_31;
    const double z_33 = z_28 + (r_F*z_30 - c_*z_32);
    const double z_34 = m_F*z_33;
    const double z_35 = z_H*z_30 + z_28 - c_7*z_32;
    const double z_36 = m_H*z_35;
    const double c_8 = c[34];
    const double z_37 = sin_phi*c_8;
    M1[0][2] = M1[2][0] = cos_psi*z_8 + cos_psi*z_22 + cos_psi*z_24 + cos_psi*z_37 - sin_psi*z_27 - sin_psi*z_34 -
        sin_psi*z_36;
    M1[1][2] = M1[2][1] = cos_psi*z_27 + sin_psi*z_8 + cos_psi*z_34 + sin_psi*z_22 + cos_psi*z_36 + sin_psi*z_24 +
        sin_psi*z_37;
    const double z_38 = sin_phi*sin_delta;
    const double z_39 = sin_theta*cos_phi;
    const double z_40 = cos_theta*cos_phi;
    const double z_41 = c_5*z_38 - z_11*z_39 - z_12*z_40;
    const double c_9 = c[35];
    const double z_42 = z_17*z_40 + z_12*z_39 + c_6*z_38;
    const double c_10 = c[36];
    const double z_43 = z_42*c_10 - z_41*c_9;
    const double c_11 = c[37];
    const double z_44 = z_41*c_10 - z_42*c_11;
    const double z_45 = sin_phi*cos_delta;
    const double z_46 = z_45 + z_39*z_15 - z_40*z_18;
    const double c_12 = c[38];
    const double z_47 = cos_delta*c_12;
    const double c_13 = c[39];
    const double z_48 = (z_43*z_15 + z_44*z_18) - (z_46*z_47 + sin_phi*c_13);
    const double c_15 = c[41];
    const double c_16 = c[42];
    const double c_17 = c[43];
    const double z_49 = sin_delta*z_46;
    const double z_50 = z_11*z_43 + c_15*z_39 + c_16*z_40 + c_17*z_49 - z_12*z_44;
    const double c_19 = c[45];
    const double c_20 = c[46];
    const double z_51 = z_12*z_43 + c_19*z_40 + c_16*z_39 - z_17*z_44 - c_20*z_49;
    const double c_100 = c[126];
    const double c_101 = c[127];
    const double c_102 = c[128];
    const double c_86 = c[112];
    M1[2][2] = 0.5*(z_50*z_39 + z_51*z_40 + c_100*(z_26*z_26) + c_100*(z_7*z_7) + c_101*(z_33*z_33) +
        c_101*(z_21*z_21) + c_102*(z_35*z_35) + c_102*(z_23*z_23) + c_86*(sin_phi*sin_phi) - sin_phi*z_48);
    const double c_26 = c[52];
    const double z_52 = cos_phi*c_26;
    const double c_27 = c[53];
    const double z_53 = sin_psi*c_27;
    const double c_28 = c[54];
    const double z_54 = sin_psi*c_28;
    const double c_29 = c[55];
    const double z_55 = sin_psi*c_29;
    const double c_30 = c[56];
    const double z_56 = z_17*c_30;
    const double z_57 = sin_psi*z_56;
    const double c_32 = c[58];
    const double z_58 = z_11*c_32;
    const double z_59 = sin_psi*z_58;
    const double z_60 = z_12*c_32;
    const double z_61 = sin_psi*z_60;
    const double z_62 = z_12*c_30;
    const double z_63 = sin_psi*z_62;
    M1[0][3] = M1[3][0] = sin_psi*z_52 + z_40*z_57 + z_39*z_59 + z_40*z_61 + z_39*z_63 - z_39*z_53 - z_40*z_54 -
        z_38*z_55;
    const double z_64 = cos_psi*c_27;
    const double z_65 = cos_psi*c_28;
    const double z_66 = cos_psi*c_29;
    const double z_67 = cos_psi*z_56;
    const double z_68 = cos_psi*z_58;
    const double z_69 = cos_psi*z_60;
    const double z_70 = cos_psi*z_62;
    M1[1][3] = M1[3][1] = z_39*z_64 + z_40*z_65 + z_38*z_66 - cos_psi*z_52 - z_40*z_67 - z_39*z_68 - z_40*z_69 -
        z_39*z_70;
    const double c_38 = c[64];
    const double c_39 = c[65];
    const double z_71 = z_33*c_38 + z_35*c_39;
    const double z_72 = z_17*z_71;
    const double c_36 = c[62];
    const double c_37 = c[63];
    const double z_73 = z_33*c_36 + z_35*c_37;
    const double z_74 = z_11*z_73;
    const double z_75 = z_12*z_73;
    const double z_76 = z_12*z_71;
    const double z_77 = z_34 + z_36;
    const double z_78 = z_27 + z_77;
    const double c_42 = c[68];
    const double z_79 = z_77*c_42;
    const double c_74 = c[100];
    const double z_80 = z_77*c_74;
    const double c_70 = c[96];
    const double z_81 = z_73*c_70;
    const double c_72 = c[98];
    const double z_82 = z_71*c_72;
    const double c_79 = c[105];
    const double z_83 = z_26*c_79;
    const double c_78 = c[104];
    const double z_84 = z_26*c_78;
    M1[2][3] = M1[3][2] = 0.5*(sin_theta*z_51 + z_40*z_79 + z_39*z_80 + z_38*z_81 + z_39*z_83 + z_40*z_84 -
        cos_theta*z_50 - 2.0*z_40*z_72 - 2.0*z_39*z_74 - 2.0*z_40*z_75 - 2.0*z_39*z_76 - cos_phi*z_78*c_42 -
        z_38*z_82);
    const double z_85 = z_32*c_10 - z_30*c_11;
    const double z_86 = z_30*c_10 - z_32*c_9;
    const double z_87 = cos_theta*sin_delta;
    const double z_88 = sin_theta*sin_delta;
    const double z_89 = c_5*z_87 + c_6*z_88;
    const double z_90 = sin_delta*z_89;
    const double z_91 = z_17*z_85 + cos_theta*c_16 - z_12*z_86 - sin_theta*c_19 - c_20*z_90;
    const double z_92 = z_11*z_86 + sin_theta*c_16 - z_12*z_85 - cos_theta*c_15 - c_17*z_90;
    const double z_93 = cos_theta*z_17;
    const double z_94 = sin_theta*z_11;
    const double z_95 = z_29 + z_94;
    const double z_96 = z_31 + z_93;
    const double z_97 = r_R*cos_theta + sin_theta*c_1;
    const double z_98 = r_R - z_97;
    const double z_99 = c_*z_95 + r_F*z_96 + z_98;
    const double z_100 = z_H*z_96 + c_7*z_95 + z_98;
    const double z_101 = c_38*z_99 + c_39*z_100;
    const double z_102 = c_36*z_99 + c_37*z_100;
    const double z_103 = r_R - x_B*sin_theta - c_0*cos_theta;
    const double z_104 = m_F*z_99 + m_H*z_100;
    const double c_103 = c[129];
    const double z_105 = sin_delta*sin_delta;
    const double z_106 = cos_theta*c_42;
    const double z_107 = sin_theta*c_74;
    const double z_108 = sin_theta*c_79;
    const double z_109 = cos_theta*c_78;
    M1[3][3] = 0.5*(2.0*z_93*z_101 + 2.0*z_94*z_102 + 2.0*z_29*z_102 + 2.0*z_31*z_101 + (c_8 + m_B*z_103 +
        z_104)*c_42 - sin_theta*z_91 - cos_theta*z_92 - c_103*z_105 - z_104*z_106 - z_104*z_107 - z_103*z_108 -
        z_103*z_109);
    M1[0][4] = M1[4][0] = -(sin_theta*z_64 + cos_theta*z_65 + z_6*z_53 + z_4*z_57 + z_4*z_61 - cos_theta*z_67 -
        sin_theta*z_68 - cos_theta*z_69 - z_4*z_54 - sin_theta*z_70 - z_6*z_59 - z_6*z_63);
    M1[1][4] = M1[4][1] = -(sin_theta*z_53 + cos_theta*z_54 + z_4*z_65 + z_6*z_68 + z_6*z_70 - cos_theta*z_57 -
        sin_theta*z_59 - cos_theta*z_61 - z_6*z_64 - sin_theta*z_63 - z_4*z_67 - z_4*z_69);
    const double z_110 = z_21*c_38 + z_23*c_39;
    const double z_111 = z_21*c_36 + z_23*c_37;
    const double z_112 = z_22 + z_24;
    M1[2][4] = M1[4][2] = (-0.5)*(z_48 + 2.0*z_6*z_74 + 2.0*z_6*z_76 + z_112*z_106 + z_112*z_107 + z_7*z_108 +
        z_7*z_109 + z_4*z_79 + z_4*z_84 - 2.0*z_110*z_93 - 2.0*z_111*z_94 - 2.0*z_29*z_111 - 2.0*z_31*z_110 -
        2.0*z_4*z_72 - 2.0*z_4*z_75 - z_6*z_80 - z_6*z_83);
    const double c_104 = c[130];
    const double c_105 = c[131];
    const double c_106 = c[132];
    const double c_107 = c[133];
    M1[3][4] = M1[4][3] = (-0.5)*(z_86*z_15 + z_85*z_18 + z_89*z_47 + c_107*z_87 + z_17*c_106*z_88 +
        z_12*c_105*z_88 - c_104*z_88 - z_11*c_105*z_87 - z_12*c_106*z_87);
    const double z_113 = c_*z_12;
    const double z_114 = r_F*z_17;
    const double z_115 = r_R - z_113 - z_114;
    const double z_116 = r_R - z_17*z_H - z_12*c_7;
    const double z_117 = c_38*z_115 + c_39*z_116;
    const double z_118 = c_*z_11;
    const double z_119 = z_12*r_F;
    const double z_120 = c_1 - z_118 - z_119;
    const double z_121 = c_1 - z_12*z_H - z_11*c_7;
    const double z_122 = c_36*z_120 + c_37*z_121;
    const double z_123 = c_36*z_115 + c_37*z_116;
    const double z_124 = c_38*z_120 + c_39*z_121;
    const double c_108 = c[134];
    const double c_109 = c[135];
    M1[4][4] = 0.5*(c_108*z_105 + c_109 + (m_F*z_115 + m_H*z_116)*c_42 + c_12*(cos_delta*cos_delta) + (m_F*z_120 +
        m_H*z_121)*c_74 - 2.0*z_17*z_117 - 2.0*z_11*z_122 - 2.0*z_12*z_123 - 2.0*z_12*z_124);
    const double c_58 = c[84];
    const double z_125 = cos_psi*c_58;
    const double z_126 = cos_delta*cos_phi;
    const double c_59 = c[85];
    const double z_127 = cos_psi*c_59;
    const double z_128 = sin_delta*z_6;
    const double z_129 = sin_psi*c_59;
    const double z_130 = sin_delta*z_4;
    const double z_131 = sin_psi*c_58;
    M1[0][5] = M1[5][0] = z_87*z_125 + z_126*z_55 - z_88*z_127 - z_128*z_129 - z_130*z_131;
    M1[1][5] = M1[5][1] = z_87*z_131 + z_130*z_125 + z_128*z_127 - z_88*z_129 - z_126*z_66;
    const double c_77 = c[103];
    const double c_76 = c[102];
    const double c_75 = c[101];
    M1[2][5] = M1[5][2] = 0.5*(c_6*z_43 + z_111*c_77*z_87 + z_126*z_82 + z_73*c_77*z_130 + z_71*c_76*z_128 +
        z_111*c_75*z_88 - c_5*z_44 - z_110*c_76*z_88 - z_126*z_81 - z_110*c_75*z_87 - z_73*c_75*z_128 -
        z_71*c_75*z_130);
    const double c_110 = c[136];
    const double c_111 = c[137];
    M1[3][5] = M1[5][3] = 0.5*(c_6*z_86 + cos_delta*z_102*c_70 - c_5*z_85 - cos_theta*c_110*z_105 -
        sin_theta*c_111*z_105 - cos_delta*z_101*c_72);
    const double c_62 = c[88];
    const double z_132 = sin_delta*c_75;
    M1[4][5] = M1[5][4] = (-0.5)*(sin_delta*c_62 + sin_delta*z_123*c_77 + z_122*z_132 - sin_delta*z_124*c_76 -
        z_117*z_132);
    const double c_112 = c[138];
    M1[5][5] = c_112;
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
    const double c_89 = c[115];
    const double z_133 = z_46*z_46;
    const double z_134 = sqrt(1.0 - z_133);
    const double z_135 = 1.0/z_134;
    const double z_136 = z_46*z_135;
    const double z_137 = r_F*z_136;
    const double c_90 = c[116];
    const double z_138 = c_90*z_136;
    const double c_91 = c[117];
    const double z_139 = c_91*z_136;
    const double z_140 = (c_*z_94 + c_*z_29) + (r_F*z_93 + r_F*z_31);
    A1[0][3] = cos_phi*(sin_delta*c_89 + cos_delta*z_137) - sin_phi*(z_88*z_138 + z_98 + z_140 - z_87*z_139);
    const double z_141 = r_R*cos_phi;
    const double z_142 = cos_phi*sin_delta;
    A1[0][4] = sin_theta*(z_141 + z_139*z_142 - cos_phi*z_113 - cos_phi*z_114) - cos_theta*(cos_phi*c_1 -
        cos_phi*z_118 - cos_phi*z_119 - z_138*z_142);
    const double c_92 = c[118];
    const double c_93 = c[119];
    A1[0][5] = cos_delta*(sin_phi*c_89 + z_39*z_138 - z_40*z_139) + sin_delta*(c_4*(c_*z_40 + r_F*z_39) -
        c_92*z_39 - sin_phi*z_137 - c_93*z_40);
    A1[0][6] = 0.0;
    A1[0][7] = 0.0;
    A1[1][0] = cos_psi;
    A1[1][1] = sin_psi;
    A1[1][2] = 0.0;
    A1[1][3] = 0.0;
    const double c_94 = c[120];
    A1[1][4] = c_94;
    A1[1][5] = 0.0;
    A1[1][6] = c_94;
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
    const double z_143 = z_126 + c_6*z_128 - c_5*z_130;
    const double z_144 = r_F*(z_19*z_134 - z_136*(z_42*z_143));
    const double z_145 = z_133*z_135;
    const double z_146 = r_F*(z_143*z_134 + z_143*z_145);
    const double z_147 = r_F*(z_16*z_134 + z_136*(z_41*z_143));
    const double z_148 = z_144*z_18 - (cos_delta*z_146 + z_147*z_15);
    A1[3][2] = (z_12*z_147 + z_17*z_144 + z_146*z_18)*z_40 + (z_12*z_144 + z_11*z_147 - z_146*z_15)*z_39 -
        sin_phi*(-z_148) - z_20;
    A1[3][3] = 0.0;
    A1[3][4] = -(z_97 - z_148 - z_140);
    const double c_95 = c[121];
    const double c_96 = c[122];
    A1[3][5] = c_6*z_147 + c_5*z_144 + c_96*z_87 - c_95*z_88;
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
    A1[4][3] = -(z_141 + c_89*z_38 + z_118*z_39 + z_113*z_40 + z_114*z_40 + z_119*z_39 - sin_theta*z_153 -
        cos_theta*z_154 - r_R*z_40 - c_1*z_39);
    A1[4][4] = -(r_R*z_4 + z_118*z_6 + z_119*z_6 - c_1*z_6 - z_113*z_4 - z_114*z_4 - z_152);
    A1[4][5] = c_5*z_151 + c_89*z_126 + c_95*z_128 + c_96*z_130 - c_6*z_149;
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
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[75],
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
    const double c_0 = c[26];
    const double z_40 = shared[4];
    const double z_160 = phi_dot*z_40;
    const double z_4 = shared[5];
    const double z_161 = theta_dot*z_4;
    const double z_162 = z_160 - z_161;
    const double z_163 = z_156 - x_B*z_159 - c_0*z_162;
    const double z_7 = shared[6];
    const double psi_dot = v[2];
    const double sin_psi = shared[7];
    const double z_164 = psi_dot*sin_psi;
    const double m_F = c[9];
    const double z_21 = shared[8];
    const double c_ = c[1];
    const double z_11 = shared[9];
    const double c_3 = c[29];
    const double delta_dot = v[5];
    const double sin_delta = shared[10];
    const double z_165 = delta_dot*sin_delta;
    const double z_166 = c_3*z_165;
    const double z_12 = shared[11];
    const double c_4 = c[30];
    const double z_167 = c_4*z_165;
    const double c_5 = c[31];
    const double cos_delta = shared[12];
    const double z_168 = delta_dot*cos_delta;
    const double sin_phi = shared[13];
    const double z_169 = phi_dot*sin_delta;
    const double z_170 = cos_phi*z_168 - sin_phi*z_169;
    const double z_171 = (z_11*z_157 + z_11*z_158 - z_4*z_166) + (z_12*z_160 + z_6*z_167 - z_12*z_161) +
        c_5*z_170;
    const double r_F = c[5];
    const double z_17 = shared[14];
    const double c_2 = c[28];
    const double z_172 = c_2*z_165;
    const double c_6 = c[32];
    const double z_173 = (z_17*z_161 + z_6*z_172 - z_17*z_160) + c_6*z_170 - (z_12*z_157 + z_12*z_158 +
        z_4*z_167);
    const double c_1 = c[27];
    const double z_174 = c_1*z_159 - (z_156 - r_R*z_162);
    const double z_175 = c_*z_171 - r_F*z_173 - z_174;
    const double m_H = c[8];
    const double z_23 = shared[15];
    const double z_H = c[13];
    const double c_7 = c[33];
    const double z_176 = c_7*z_171 - z_H*z_173 - z_174;
    const double sin_theta = shared[16];
    const double z_177 = theta_dot*sin_theta;
    const double cos_theta = shared[17];
    const double z_178 = theta_dot*cos_theta;
    const double z_179 = x_B*z_177 + c_0*z_178;
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
    const double z_189 = r_R*z_178 + c_1*z_177;
    const double z_190 = z_189 - r_F*z_184 - c_*z_188;
    const double z_35 = shared[20];
    const double z_191 = z_189 - z_H*z_184 - c_7*z_188;
    const double c_8 = c[34];
    const double z_192 = phi_dot*cos_psi;
    Mdot1[0][2] = Mdot1[2][0] = m_B*(cos_psi*z_163 - z_7*z_164) + m_B*(sin_psi*z_179 - z_26*z_180) +
        c_8*(cos_phi*z_192 - sin_phi*z_164) - m_F*(z_21*z_164 - cos_psi*z_175) - m_H*(z_23*z_164 - cos_psi*z_176)
        - m_F*(z_33*z_180 - sin_psi*z_190) - m_H*(z_35*z_180 - sin_psi*z_191);
    const double z_193 = phi_dot*sin_psi;
    Mdot1[1][2] = Mdot1[2][1] = -(m_B*(z_26*z_164 + cos_psi*z_179) + m_F*(z_33*z_164 + cos_psi*z_190) +
        m_H*(z_35*z_164 + cos_psi*z_191) - m_B*(sin_psi*z_163 + z_7*z_180) - m_F*(sin_psi*z_175 + z_21*z_180) -
        m_H*(sin_psi*z_176 + z_23*z_180) - c_8*(cos_phi*z_193 + sin_phi*z_180));
    const double z_48 = shared[21];
    const double z_43 = shared[22];
    const double c_9 = c[35];
    const double z_194 = sin_phi*z_168;
    const double z_195 = cos_phi*z_169;
    const double z_196 = z_194 + z_195;
    const double z_197 = phi_dot*z_4;
    const double z_198 = theta_dot*z_40;
    const double z_199 = phi_dot*z_6;
    const double z_200 = theta_dot*z_39;
    const double z_201 = c_5*z_196 + (z_11*z_197 + z_39*z_166 - z_11*z_198) + (z_12*z_199 + z_12*z_200 -
        z_40*z_167);
    const double z_202 = (z_17*z_199 + z_17*z_200 + z_40*z_172) - (z_12*z_198 + z_39*z_167 - z_12*z_197) -
        c_6*z_196;
    const double c_10 = c[36];
    const double z_203 = c_9*z_201 + z_202*c_10;
    const double z_44 = shared[23];
    const double c_11 = c[37];
    const double z_204 = c_11*z_202 + z_201*c_10;
    const double c_14 = c[40];
    const double z_46 = shared[24];
    const double z_126 = shared[25];
    const double z_205 = (phi_dot*z_126 - sin_phi*z_165) + c_5*(sin_delta*z_198 + z_39*z_168 - z_4*z_169) +
        c_6*(sin_delta*z_200 + z_6*z_169 - z_40*z_168);
    const double c_13 = c[39];
    const double z_206 = (c_5*(z_43*z_168 - sin_delta*z_203) + c_6*(z_44*z_168 + sin_delta*z_204)) +
        2.0*(c_14*(z_46*z_165 - cos_delta*z_205) - 0.5*c_13*z_155);
    const double z_50 = shared[26];
    const double B_xz = c[21];
    const double z_207 = z_199 + z_200;
    const double c_18 = c[44];
    const double z_208 = z_46*z_168 + sin_delta*z_205;
    const double c_15 = c[41];
    const double z_209 = z_198 - z_197;
    const double z_210 = (z_43*z_166 + z_11*z_203) + (z_44*z_167 + z_12*z_204) + 2.0*B_xz*z_207 - 2.0*c_18*z_208 -
        c_15*z_209;
    const double z_51 = shared[27];
    const double c_21 = c[47];
    const double c_19 = c[45];
    const double z_211 = (z_43*z_167 - z_12*z_203) + (z_44*z_172 - z_17*z_204) + 2.0*B_xz*z_209 - 2.0*c_21*z_208 -
        c_19*z_207;
    const double c_22 = c[48];
    const double c_23 = c[49];
    const double c_24 = c[50];
    const double c_25 = c[51];
    Mdot1[2][2] = (-0.5)*((z_48*z_155 + sin_phi*z_206) + (z_51*z_200 + z_51*z_199 - z_211*z_40) + z_26*z_179*c_22
        + z_33*z_190*c_23 + z_35*z_191*c_24 - (z_50*z_198 - z_50*z_197 - z_210*z_39) - z_7*z_163*c_22 -
        z_21*z_175*c_23 - z_23*z_176*c_24 - c_25*(sin_phi*z_155));
    const double c_26 = c[52];
    const double c_27 = c[53];
    const double z_212 = z_4*z_193;
    const double z_213 = z_39*z_180;
    const double c_28 = c[54];
    const double z_214 = z_6*z_193;
    const double z_215 = z_40*z_180;
    const double c_29 = c[55];
    const double z_38 = shared[28];
    const double z_57 = shared[29];
    const double z_56 = shared[30];
    const double c_31 = c[57];
    const double z_216 = sin_psi*z_165;
    const double z_217 = c_31*z_216;
    const double z_59 = shared[31];
    const double c_33 = c[59];
    const double z_218 = c_33*z_216;
    const double z_58 = shared[32];
    const double z_61 = shared[33];
    const double c_34 = c[60];
    const double z_219 = c_34*z_216;
    const double z_60 = shared[34];
    const double z_63 = shared[35];
    const double c_35 = c[61];
    const double z_220 = c_35*z_216;
    const double z_62 = shared[36];
    Mdot1[0][3] = Mdot1[3][0] = -(c_26*(sin_phi*z_193 - cos_phi*z_180) + c_27*(sin_psi*z_198 + z_213 - z_212) +
        c_29*(sin_psi*z_195 + sin_psi*z_194 + z_180*z_38) + (z_200*z_57 + z_214*z_56 + z_40*z_217 - z_215*z_56) +
        (z_200*z_61 + z_214*z_60 - z_40*z_219 - z_215*z_60) - c_28*(sin_psi*z_200 + z_214 - z_215) - (z_198*z_59 +
        z_213*z_58 - z_39*z_218 - z_212*z_58) - (z_198*z_63 + z_39*z_220 + z_213*z_62 - z_212*z_62));
    const double z_221 = z_39*z_164;
    const double z_222 = z_4*z_192;
    const double z_223 = z_40*z_164;
    const double z_224 = z_6*z_192;
    const double z_67 = shared[37];
    const double z_225 = cos_psi*z_165;
    const double z_226 = c_31*z_225;
    const double z_68 = shared[38];
    const double z_227 = c_33*z_225;
    const double z_69 = shared[39];
    const double z_228 = c_34*z_225;
    const double z_70 = shared[40];
    const double z_229 = c_35*z_225;
    Mdot1[1][3] = Mdot1[3][1] = c_27*(cos_psi*z_198 - z_221 - z_222) + c_29*(cos_psi*z_195 + cos_psi*z_194 -
        z_164*z_38) + c_26*(cos_phi*z_164 + sin_phi*z_192) + (z_200*z_67 + z_223*z_56 + z_224*z_56 + z_40*z_226) +
        (z_200*z_69 + z_223*z_60 + z_224*z_60 - z_40*z_228) - c_28*(cos_psi*z_200 + z_223 + z_224) - (z_198*z_68 -
        z_221*z_58 - z_39*z_227 - z_222*z_58) - (z_198*z_70 + z_39*z_229 - z_221*z_62 - z_222*z_62);
    const double z_78 = shared[41];
    const double z_230 = m_F*z_190 + m_H*z_191;
    const double z_77 = shared[42];
    const double z_73 = shared[43];
    const double c_36 = c[62];
    const double c_37 = c[63];
    const double z_231 = c_36*z_190 + c_37*z_191;
    const double z_72 = shared[44];
    const double z_71 = shared[45];
    const double z_232 = z_71*z_172;
    const double c_38 = c[64];
    const double c_39 = c[65];
    const double z_233 = c_38*z_190 + c_39*z_191;
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
    const double c_40 = c[66];
    const double c_41 = c[67];
    Mdot1[2][3] = Mdot1[3][2] = 0.5*((z_51*z_178 + sin_theta*z_211) + (z_50*z_177 + cos_theta*z_210) +
        2.0*r_R*(z_78*(phi_dot*sin_phi) + cos_phi*(m_B*z_179 + z_230)) + 2.0*c_1*(z_77*z_198 - z_77*z_197 -
        z_230*z_39) + 2.0*c_5*(z_73*z_195 + z_73*z_194 - z_231*z_38) + 2.0*(z_200*z_72 + z_199*z_72 + z_40*z_232 +
        z_40*z_234) + 2.0*(z_200*z_75 + z_199*z_75 + z_40*z_238 - z_40*z_237) + 2.0*c_40*(z_26*z_198 - z_26*z_197
        - z_179*z_39) - 2.0*r_R*(z_77*z_200 + z_77*z_199 + z_230*z_40) - 2.0*(z_198*z_74 - z_39*z_235 - z_197*z_74
        - z_39*z_236) - 2.0*(z_198*z_76 + z_39*z_239 - z_197*z_76 - z_39*z_240) - 2.0*c_6*(z_71*z_195 + z_71*z_194
        - z_233*z_38) - 2.0*c_41*(z_26*z_200 + z_26*z_199 + z_179*z_40));
    const double z_91 = shared[49];
    const double z_85 = shared[50];
    const double z_241 = c_11*z_184 + z_188*c_10;
    const double z_86 = shared[51];
    const double z_242 = c_9*z_188 + z_184*c_10;
    const double z_89 = shared[52];
    const double z_243 = sin_delta*z_177;
    const double z_244 = cos_theta*z_168;
    const double z_245 = z_243 - z_244;
    const double z_246 = sin_delta*z_178;
    const double z_247 = sin_theta*z_168;
    const double z_248 = z_246 + z_247;
    const double z_249 = c_5*z_245 - c_6*z_248;
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
    const double z_257 = r_R*z_177 - c_1*z_178;
    const double z_258 = r_F*z_256 + z_257 - c_*z_255;
    const double z_259 = z_H*z_256 + z_257 - c_7*z_255;
    const double z_260 = c_38*z_258 + c_39*z_259;
    const double z_102 = shared[56];
    const double z_94 = shared[57];
    const double z_261 = c_36*z_258 + c_37*z_259;
    const double z_29 = shared[58];
    const double z_31 = shared[59];
    const double z_104 = shared[60];
    const double z_262 = m_F*z_258 + m_H*z_259;
    const double z_103 = shared[61];
    const double z_263 = c_0*z_177 - x_B*z_178;
    const double c_42 = c[68];
    const double c_43 = c[69];
    const double z_264 = cos_delta*z_165;
    Mdot1[3][3] = 0.5*((z_92*z_177 + cos_theta*((z_86*z_166 - z_11*z_242) + (z_85*z_167 - z_12*z_241) +
        2.0*c_18*z_250 - c_15*z_177 - c_16*z_178)) + 2.0*(z_102*z_253 + z_94*z_261 - z_102*z_254) +
        2.0*(z_101*z_185 + z_101*z_186 + z_31*z_260) + 2.0*r_R*(z_104*z_177 - cos_theta*z_262) +
        2.0*c_41*(z_103*z_177 - cos_theta*z_263) + (m_B*z_263 + z_262)*c_42 - (z_91*z_178 - sin_theta*((z_85*z_172
        + z_17*z_241) + (z_86*z_167 + z_12*z_242) + 2.0*c_21*z_250 + c_19*z_178 + c_16*z_177)) - 2.0*(z_101*z_251
        + z_101*z_252 - z_93*z_260) - 2.0*(z_102*z_181 - z_102*z_182 - z_29*z_261) - 2.0*c_1*(z_104*z_178 +
        sin_theta*z_262) - 2.0*c_40*(z_103*z_178 + sin_theta*z_263) - c_43*z_264);
    const double z_265 = sin_theta*z_164;
    const double z_266 = cos_theta*z_164;
    const double z_267 = z_39*z_193;
    const double z_268 = z_4*z_180;
    const double z_269 = z_40*z_193;
    const double z_270 = z_6*z_180;
    Mdot1[0][4] = Mdot1[4][0] = -(c_27*(cos_psi*z_178 - z_265) + (z_177*z_67 + z_266*z_56 + cos_theta*z_226) +
        (z_177*z_69 + z_266*z_60 - cos_theta*z_228) + c_27*(z_269 + z_270 - sin_psi*z_161) + (z_267*z_56 +
        z_158*z_57 + z_268*z_56 - z_4*z_217) + (z_267*z_60 + z_158*z_61 + z_4*z_219 + z_268*z_60) -
        c_28*(cos_psi*z_177 + z_266) - (z_178*z_68 - z_265*z_58 - sin_theta*z_227) - c_28*(z_267 + sin_psi*z_158 +
        z_268) - (z_178*z_70 + sin_theta*z_229 - z_265*z_62) - (z_269*z_58 + z_270*z_58 - z_161*z_59 - z_6*z_218)
        - (z_269*z_62 + z_6*z_220 + z_270*z_62 - z_161*z_63));
    const double z_271 = sin_theta*z_180;
    const double z_272 = cos_theta*z_180;
    const double z_273 = z_40*z_192;
    const double z_274 = z_6*z_164;
    const double z_275 = z_39*z_192;
    const double z_276 = z_4*z_164;
    Mdot1[1][4] = Mdot1[4][1] = -(c_27*(sin_psi*z_178 + z_271) + (z_177*z_57 + cos_theta*z_217 - z_272*z_56) +
        (z_177*z_61 - cos_theta*z_219 - z_272*z_60) + c_28*(z_275 + cos_psi*z_158 - z_276) + (z_273*z_58 -
        z_161*z_68 - z_274*z_58 - z_6*z_227) + (z_273*z_62 + z_6*z_229 - z_161*z_70 - z_274*z_62) -
        c_28*(sin_psi*z_177 - z_272) - (z_178*z_59 + z_271*z_58 - sin_theta*z_218) - c_27*(z_273 - cos_psi*z_161 -
        z_274) - (z_178*z_63 + sin_theta*z_220 + z_271*z_62) - (z_275*z_56 + z_158*z_67 - z_276*z_56 - z_4*z_226)
        - (z_275*z_60 + z_158*z_69 + z_4*z_228 - z_276*z_60));
    const double z_110 = shared[62];
    const double z_277 = c_38*z_175 + c_39*z_176;
    const double z_111 = shared[63];
    const double z_278 = c_36*z_175 + c_37*z_176;
    const double z_112 = shared[64];
    const double z_279 = m_F*z_175 + m_H*z_176;
    Mdot1[2][4] = Mdot1[4][2] = (-0.5)*(z_206 + 2.0*(z_110*z_251 + z_110*z_252 - z_93*z_277) + 2.0*(z_111*z_181 -
        z_111*z_182 - z_29*z_278) + 2.0*c_1*(z_112*z_178 + sin_theta*z_279) + 2.0*c_40*(z_7*z_178 +
        sin_theta*z_163) + 2.0*r_R*(z_77*z_157 + z_77*z_158 - z_230*z_4) + 2.0*(z_160*z_74 - z_161*z_74 -
        z_6*z_235 - z_6*z_236) + 2.0*(z_160*z_76 + z_6*z_239 - z_161*z_76 - z_6*z_240) + 2.0*c_41*(z_26*z_157 +
        z_26*z_158 - z_179*z_4) - 2.0*(z_111*z_253 + z_94*z_278 - z_111*z_254) - 2.0*(z_110*z_185 + z_110*z_186 +
        z_31*z_277) - 2.0*r_R*(z_112*z_177 - cos_theta*z_279) - 2.0*c_1*(z_77*z_160 - z_77*z_161 - z_230*z_6) -
        2.0*(z_157*z_72 + z_158*z_72 - z_4*z_232 - z_4*z_234) - 2.0*(z_157*z_75 + z_158*z_75 + z_4*z_237 -
        z_4*z_238) - 2.0*c_41*(z_7*z_177 - cos_theta*z_163) - 2.0*c_40*(z_26*z_160 - z_26*z_161 - z_179*z_6));
    const double c_44 = c[70];
    const double c_45 = c[71];
    const double z_280 = z_11*c_45;
    const double c_46 = c[72];
    const double z_105 = shared[65];
    const double z_281 = delta_dot*z_105;
    const double z_282 = cos_theta*z_281;
    const double c_47 = c[73];
    const double z_283 = z_12*c_47;
    const double c_48 = c[74];
    const double c_49 = c[75];
    const double z_284 = z_17*c_47;
    const double c_50 = c[76];
    const double z_285 = sin_theta*z_281;
    const double z_286 = z_12*c_45;
    const double c_51 = c[77];
    Mdot1[3][4] = Mdot1[4][3] = 0.5*(2.0*c_14*(z_89*z_165 + cos_delta*z_249) + 2.0*c_44*z_248 + 2.0*c_49*z_245 -
        c_5*(z_86*z_168 + sin_delta*z_242) - c_6*(z_85*z_168 - sin_delta*z_241) - 2.0*(z_243*z_280 + c_46*z_282 -
        z_244*z_280) - 2.0*(z_243*z_283 - c_48*z_282 - z_244*z_283) - 2.0*(z_246*z_284 + z_247*z_284 - c_50*z_285)
        - 2.0*(z_246*z_286 + c_51*z_285 + z_247*z_286));
    const double z_117 = shared[66];
    const double c_52 = c[78];
    const double z_122 = shared[67];
    const double c_53 = c[79];
    const double z_123 = shared[68];
    const double c_54 = c[80];
    const double z_287 = z_12*z_165;
    const double z_124 = shared[69];
    const double c_55 = c[81];
    const double c_56 = c[82];
    const double c_57 = c[83];
    Mdot1[4][4] = (z_117*z_172 - z_17*c_52*z_165) + (z_122*z_166 - z_11*c_53*z_165) + c_56*z_165 - (z_123*z_167 +
        c_54*z_287) - (z_124*z_167 + c_55*z_287) - c_57*z_264;
    const double c_58 = c[84];
    const double z_87 = shared[70];
    const double z_45 = shared[71];
    const double c_59 = c[85];
    const double z_88 = shared[72];
    const double z_288 = z_40*z_169;
    const double z_289 = sin_delta*z_161;
    const double z_290 = z_6*z_168;
    const double z_128 = shared[73];
    const double z_291 = z_39*z_169;
    const double z_292 = sin_delta*z_158;
    const double z_293 = z_4*z_168;
    const double z_130 = shared[74];
    Mdot1[0][5] = Mdot1[5][0] = -(c_58*(cos_psi*z_243 + z_164*z_87 - cos_psi*z_244) + c_29*(cos_phi*z_216 +
        z_45*z_193 - z_126*z_180) + c_59*(cos_psi*z_246 + cos_psi*z_247 - z_164*z_88) + c_59*(sin_psi*z_288 +
        sin_psi*z_290 + z_180*z_128 - sin_psi*z_289) + c_58*(sin_psi*z_291 + sin_psi*z_292 + sin_psi*z_293 +
        z_180*z_130));
    Mdot1[1][5] = Mdot1[5][1] = -(c_58*(sin_psi*z_243 - sin_psi*z_244 - z_180*z_87) + c_59*(sin_psi*z_246 +
        sin_psi*z_247 + z_180*z_88) - c_29*(z_126*z_164 + cos_phi*z_225 + z_45*z_192) - c_58*(cos_psi*z_291 +
        cos_psi*z_292 + cos_psi*z_293 - z_164*z_130) - c_59*(cos_psi*z_288 + cos_psi*z_290 - cos_psi*z_289 -
        z_164*z_128));
    const double z_294 = cos_phi*z_165;
    const double z_295 = phi_dot*z_45;
    Mdot1[2][5] = Mdot1[5][2] = (-0.5)*(c_6*z_203 + c_5*z_204 + 2.0*c_3*(z_111*z_243 - z_111*z_244 - z_278*z_87) +
        2.0*c_6*(z_71*z_294 + z_71*z_295 + z_126*z_233) + 2.0*c_2*(z_110*z_246 + z_110*z_247 + z_277*z_88) +
        2.0*c_4*(z_73*z_288 + z_73*z_290 - z_73*z_289 - z_231*z_128) + 2.0*c_4*(z_71*z_291 + z_71*z_292 +
        z_71*z_293 - z_233*z_130) - 2.0*c_5*(z_73*z_294 + z_73*z_295 + z_126*z_231) - 2.0*c_3*(z_73*z_291 +
        z_73*z_292 + z_73*z_293 - z_231*z_130) - 2.0*c_2*(z_71*z_288 + z_71*z_290 - z_71*z_289 - z_233*z_128) -
        2.0*c_4*(z_111*z_246 + z_111*z_247 + z_278*z_88) - 2.0*c_4*(z_110*z_243 - z_110*z_244 - z_277*z_87));
    const double c_60 = c[86];
    const double c_61 = c[87];
    Mdot1[3][5] = Mdot1[5][3] = 0.5*(c_6*z_242 + c_5*z_241 + 2.0*c_60*(z_105*z_177 - 2.0*cos_theta*z_264) +
        2.0*c_6*(z_101*z_165 - cos_delta*z_260) - 2.0*c_5*(z_102*z_165 - cos_delta*z_261) - 2.0*c_61*(z_105*z_178
        + 2.0*sin_theta*z_264));
    const double c_62 = c[88];
    const double c_63 = c[89];
    const double c_64 = c[90];
    const double z_296 = c_4*z_168;
    const double c_65 = c[91];
    const double c_66 = c[92];
    Mdot1[4][5] = Mdot1[5][4] = (-0.5)*(c_62*z_168 + 2.0*(z_168*(c_3*z_123) + c_64*z_281) + 2.0*(z_122*z_296 +
        c_66*z_281) - 2.0*(z_168*(c_2*z_124) + c_63*z_281) - 2.0*(z_117*z_296 + c_65*z_281));
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
static int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                        em_fault *fault)
{
    (void)mode, (void)flags, (void)t, (void)y, (void)c, (void)memory, (void)pace, (void)fault;
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[75];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = INFINITY, delta_gap = INFINITY;
    gap = fmin(gap, em_gap(N1, y + 80));
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

static const char *const coordinate_names[] = { "x", "y", "psi", "phi", "theta", "delta", "spin_r", "spin_f", NULL };
static const char *const parameter_names[] = { "w", "c", "tilt", "g", "r_R", "r_F", "m_R", "m_B", "m_H", "m_F", "x_B", "z_B", "x_H", "z_H", "R_xx", "R_yy", "F_xx", "F_yy", "B_xx", "B_yy", "B_zz", "B_xz", "H_xx", "H_yy", "H_zz", "H_xz", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.02, 0.08, 0.3141592653589793, 9.81, 0.3, 0.35, 2.0, 85.0, 4.0, 3.0, 0.3, 0.9, 0.9, 0.7, 0.0603, 0.12, 0.1405, 0.28, 9.2, 11.0, 2.8, 2.4, 0.05892, 0.06, 0.00708, -0.00756, 0.0 };
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
    .energy = energy,
    .eigenfactors = em_eigenfactors_of,
    .output = em_observe,
    .jacobian = jacobian,
    .motion_jacobian = em_motion_jacobian,
    .simulate = em_simulate,
    .interpolate = em_interpolate,
    .release = em_release,
    .event = model_events,
    .lanes = &bicycle_lanes,
    .n_shapes = 8,
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
};

#endif
#endif
