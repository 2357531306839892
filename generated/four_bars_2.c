/* eigenmotion generate four_bars.py */
/* input sha256:bcb90918768aa4b82cabda26a10ffab302d61bd800ad437e9fa9db3f90eb0350 */
/* body sha256:1dda4be5b5da257a4be398c1166700961363008f6b47fd196be03d5c4138a4dd */
/* four_bars_2: equations of motion, eigenfactor formulation.
 *
 * State, 22 numbers:
 *   x    y[0 .. 5)
 *   eta  y[5 .. 10)
 *   C    y[10 .. 18)
 *   s    y[18 .. 22)
 *
 * Blocks of M that do not couple:
 *   1: q1, p1 (C and s are states)
 *   2: q2, p2 (C and s are states)
 *   3: q3 (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dq3: M does not depend on it
 *   C, mu, Omega across blocks: {q1, p1}, {q2, p2}, {q3} do not couple
 *   C, s, mu, Omega of {q3}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 20 additions, 62 multiplications, 10 function calls
 *   triangular root: 22 additions, 70 multiplications, 10 function calls
 *   projection: 8 additions, 36 multiplications, 10 function calls
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
    N_STATE = 22,         /* numbers of a state */
    N_C = 8,              /* of which C, */
    N_S = 4,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 12,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 3,
    N_PREPARED = 19,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 4,          /* inputs, parameters and the time */
    N_ARGUMENTS = 14,     /* x, v and these: what motion depends on */
    N1 = 2,               /* q1, p1 */
    N2 = 2,               /* q2, p2 */
    N3 = 1,               /* q3 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 3 };
EM_UNUSED static const int coordinate2[N2] = { 1, 4 };
EM_UNUSED static const int coordinate3[N3] = { 2 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real Mdot2[N2][N2], real f1[N1], real f2[N2],
                                  real f3[N3], real A1[N_ROWS][N1], real A2[N_ROWS][N2], real A3[N_ROWS][N3],
                                  real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[8];
    const real p1_dot = v[3];
    const real q1 = x[0];
    const real cos_q1 = em_cos(q1);
    const real p1 = x[3];
    const real sin_p1 = em_sin(p1);
    const real z_2 = cos_q1*sin_p1;
    const real q1_dot = v[0];
    const real cos_p1 = em_cos(p1);
    const real sin_q1 = em_sin(q1);
    const real z_5 = cos_p1*sin_q1;
    Mdot1[0][1] = Mdot1[1][0] = (-0.5)*(c_1*(p1_dot*z_2 + q1_dot*z_5) - c_1*(p1_dot*z_5 + q1_dot*z_2));
    Mdot1[1][1] = em_real(0.0);
    Mdot2[0][0] = em_real(0.0);
    const real p2_dot = v[4];
    const real q2 = x[1];
    const real cos_q2 = em_cos(q2);
    const real p2 = x[4];
    const real sin_p2 = em_sin(p2);
    const real z_8 = cos_q2*sin_p2;
    const real q2_dot = v[1];
    const real cos_p2 = em_cos(p2);
    const real sin_q2 = em_sin(q2);
    const real z_11 = cos_p2*sin_q2;
    Mdot2[0][1] = Mdot2[1][0] = (-0.5)*(c_1*(p2_dot*z_8 + q2_dot*z_11) - c_1*(p2_dot*z_11 + q2_dot*z_8));
    Mdot2[1][1] = em_real(0.0);
    const real z_12 = q1_dot*p1_dot*(c_1*(z_5 - z_2));
    const real c_3 = c[10];
    f1[0] = (-0.5)*(z_12 + cos_q1*c_3);
    const real c_4 = c[11];
    f1[1] = 0.5*(z_12 - cos_p1*c_4);
    const real z_13 = q2_dot*p2_dot*(c_1*(z_11 - z_8));
    f2[0] = (-0.5)*(z_13 + cos_q2*c_3);
    f2[1] = 0.5*(z_13 - cos_p2*c_4);
    const real q3 = x[2];
    const real cos_q3 = em_cos(q3);
    const real c_5 = c[12];
    f3[0] = -cos_q3*c_5;
    const real l = c[1];
    A1[0][0] = -l*sin_q1;
    A1[0][1] = -l*sin_p1;
    A1[1][0] = l*cos_q1;
    A1[1][1] = l*cos_p1;
    A1[2][0] = em_real(0.0);
    A1[2][1] = em_real(0.0);
    A1[3][0] = em_real(0.0);
    A1[3][1] = em_real(0.0);
    const real z_15 = l*sin_q2;
    A2[0][0] = z_15;
    A2[0][1] = em_real(0.0);
    const real z_16 = l*cos_q2;
    A2[1][0] = -z_16;
    A2[1][1] = em_real(0.0);
    A2[2][0] = -z_15;
    A2[2][1] = -l*sin_p2;
    A2[3][0] = z_16;
    A2[3][1] = l*cos_p2;
    A3[0][0] = em_real(0.0);
    A3[1][0] = em_real(0.0);
    const real sin_q3 = em_sin(q3);
    A3[2][0] = l*sin_q3;
    A3[3][0] = -l*cos_q3;
    const real z_18 = q1_dot*q1_dot;
    const real z_19 = q2_dot*q2_dot;
    const real z_20 = cos_q2*z_19;
    const real z_21 = p1_dot*p1_dot;
    gamma[0] = -l*(cos_q1*z_18 + cos_p1*z_21 - z_20);
    const real z_22 = sin_q2*z_19;
    gamma[1] = -l*(sin_q1*z_18 + sin_p1*z_21 - z_22);
    const real q3_dot = v[2];
    const real z_23 = q3_dot*q3_dot;
    const real z_24 = p2_dot*p2_dot;
    gamma[2] = -l*(z_20 + cos_p2*z_24 - cos_q3*z_23);
    gamma[3] = -l*(z_22 + sin_p2*z_24 - sin_q3*z_23);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* q1, p1: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5], y[8] };
    const real *const C1 = y + 10, *const s1 = y + 18;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[3] = v1[1];

    /* q2, p2: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[6], y[9] };
    const real *const C2 = y + 14, *const s2 = y + 20;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];
    dy[4] = v2[1];

    /* q3: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[7] };
    const real *const C3 = c + 3, *const s3 = c + 4;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* q1, p1: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5], y[8] };
    const real *const C1 = y + 10, *const s1 = y + 18;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[3] = v1[1];

    /* q2, p2: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[6], y[9] };
    const real *const C2 = y + 14, *const s2 = y + 20;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];
    dy[4] = v2[1];

    /* q3: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[7] };
    const real *const C3 = c + 3, *const s3 = c + 4;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];

    real Mdot1[N1][N1], Mdot2[N2][N2], f1[N1], f2[N2], f3[N3], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3],
         gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, Mdot2, f1, f2, f3, A1, A2, A3, gamma);

    /* q1, p1: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* q2, p2: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* q3: B = A C^T S^-1 (28) */
    real B3[N_ROWS][N3];
    em_rows_on_eta(N_ROWS, N3, C3, r3, A3[0], B3[0]);

    /* q1, p1: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 10, *const s1_dot = dy + 18;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a1[N1], q1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, q1);

    /* q2, p2: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T2[N2*N2], mu2[N2*N2], Omega2[N2*N2];
    em_turned_for_tiles(N2, C2, T2);
    em_congruence_below(N2, C2, T2, Mdot2[0], mu2);
    em_omega_apart(N2, s2, mu2, Omega2);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C2_dot = dy + 14, *const s2_dot = dy + 20;
    em_factor_rates(N2, C2, r2, mu2, Omega2, C2_dot, s2_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a2[N2], q2[N2];
    em_turning_push(N2, C2, T2, s2, r2, Omega2, s2_dot, eta2, w2, f2, a2, q2);

    /* q3: constant factors, a = S^-1 C f (41) */
    real a3[N3];
    em_rows_on_eta(1, N3, C3, r3, f3, a3);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        em_add_to_load(N2, row, B2[0], a2, q2, lambda);
        em_add_to_load(N3, row, B3[0], a3, NULL, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
            em_add_product(N3, B3[row], B3[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[5] = a1[0];
    dy[8] = a1[1];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[6] = a2[0];
    dy[9] = a2[1];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    dy[7] = a3[0];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real M2[N2][N2], real shared[8])
{
    const real c_0 = c[7];
    M1[0][0] = c_0;
    const real c_1 = c[8];
    const real p1 = x[3];
    const real cos_p1 = em_cos(p1);
    const real q1 = x[0];
    const real cos_q1 = em_cos(q1);
    const real sin_p1 = em_sin(p1);
    const real sin_q1 = em_sin(q1);
    M1[1][0] = 0.5*(c_1*(cos_p1*cos_q1 + sin_p1*sin_q1));
    const real c_2 = c[9];
    M1[1][1] = c_2;
    M2[0][0] = c_0;
    const real p2 = x[4];
    const real cos_p2 = em_cos(p2);
    const real q2 = x[1];
    const real cos_q2 = em_cos(q2);
    const real sin_p2 = em_sin(p2);
    const real sin_q2 = em_sin(q2);
    M2[1][0] = 0.5*(c_1*(cos_p2*cos_q2 + sin_p2*sin_q2));
    M2[1][1] = c_2;
    shared[0] = cos_q1;
    shared[1] = sin_p1;
    shared[2] = cos_p1;
    shared[3] = sin_q1;
    shared[4] = cos_q2;
    shared[5] = sin_p2;
    shared[6] = cos_p2;
    shared[7] = sin_q2;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[8], real Mdot1[N1][N1], real Mdot2[N2][N2], real f1[N1],
                                 real f2[N2], real f3[N3], real A1[N_ROWS][N1], real A2[N_ROWS][N2],
                                 real A3[N_ROWS][N3], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[8];
    const real p1_dot = v[3];
    const real cos_q1 = shared[0];
    const real sin_p1 = shared[1];
    const real z_8 = cos_q1*sin_p1;
    const real q1_dot = v[0];
    const real cos_p1 = shared[2];
    const real sin_q1 = shared[3];
    const real z_9 = cos_p1*sin_q1;
    Mdot1[0][1] = Mdot1[1][0] = (-0.5)*(c_1*(p1_dot*z_8 + q1_dot*z_9) - c_1*(p1_dot*z_9 + q1_dot*z_8));
    Mdot1[1][1] = em_real(0.0);
    Mdot2[0][0] = em_real(0.0);
    const real p2_dot = v[4];
    const real cos_q2 = shared[4];
    const real sin_p2 = shared[5];
    const real z_10 = cos_q2*sin_p2;
    const real q2_dot = v[1];
    const real cos_p2 = shared[6];
    const real sin_q2 = shared[7];
    const real z_11 = cos_p2*sin_q2;
    Mdot2[0][1] = Mdot2[1][0] = (-0.5)*(c_1*(p2_dot*z_10 + q2_dot*z_11) - c_1*(p2_dot*z_11 + q2_dot*z_10));
    Mdot2[1][1] = em_real(0.0);
    const real z_12 = q1_dot*p1_dot*(c_1*(z_9 - z_8));
    const real c_3 = c[10];
    f1[0] = (-0.5)*(z_12 + cos_q1*c_3);
    const real c_4 = c[11];
    f1[1] = 0.5*(z_12 - cos_p1*c_4);
    const real z_13 = q2_dot*p2_dot*(c_1*(z_11 - z_10));
    f2[0] = (-0.5)*(z_13 + cos_q2*c_3);
    f2[1] = 0.5*(z_13 - cos_p2*c_4);
    const real q3 = x[2];
    const real cos_q3 = em_cos(q3);
    const real c_5 = c[12];
    f3[0] = -cos_q3*c_5;
    const real l = c[1];
    A1[0][0] = -l*sin_q1;
    A1[0][1] = -l*sin_p1;
    A1[1][0] = l*cos_q1;
    A1[1][1] = l*cos_p1;
    A1[2][0] = em_real(0.0);
    A1[2][1] = em_real(0.0);
    A1[3][0] = em_real(0.0);
    A1[3][1] = em_real(0.0);
    const real z_15 = l*sin_q2;
    A2[0][0] = z_15;
    A2[0][1] = em_real(0.0);
    const real z_16 = l*cos_q2;
    A2[1][0] = -z_16;
    A2[1][1] = em_real(0.0);
    A2[2][0] = -z_15;
    A2[2][1] = -l*sin_p2;
    A2[3][0] = z_16;
    A2[3][1] = l*cos_p2;
    A3[0][0] = em_real(0.0);
    A3[1][0] = em_real(0.0);
    const real sin_q3 = em_sin(q3);
    A3[2][0] = l*sin_q3;
    A3[3][0] = -l*cos_q3;
    const real z_18 = q1_dot*q1_dot;
    const real z_19 = q2_dot*q2_dot;
    const real z_20 = cos_q2*z_19;
    const real z_21 = p1_dot*p1_dot;
    gamma[0] = -l*(cos_q1*z_18 + cos_p1*z_21 - z_20);
    const real z_22 = sin_q2*z_19;
    gamma[1] = -l*(sin_q1*z_18 + sin_p1*z_21 - z_22);
    const real q3_dot = v[2];
    const real z_23 = q3_dot*q3_dot;
    const real z_24 = p2_dot*p2_dot;
    gamma[2] = -l*(z_20 + cos_p2*z_24 - cos_q3*z_23);
    gamma[3] = -l*(z_22 + sin_p2*z_24 - sin_q3*z_23);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], M2[N2][N2], shared[8];
    triangular_masses(y, c, M1, M2, shared);

    /* q1, p1: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[5], y[8] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[3] = v1[1];

    /* q2, p2: M = L L^T */
    real L2[N2][N2], r2[N2];
    const int singular2 = em_cholesky(N2, M2[0], L2[0], r2, EM_SINGULAR_PIVOT);
    if (singular2 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate2[singular2], -1, 0.0);
    const real eta2[N2] = { y[6], y[9] };
    real v2[N2];
    em_copy(N2, eta2, v2);
    em_backward(N2, L2[0], r2, v2);
    dy[1] = v2[0];
    dy[4] = v2[1];

    /* q3: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[7] };
    const real *const C3 = c + 3, *const s3 = c + 4;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];

    real Mdot1[N1][N1], Mdot2[N2][N2], f1[N1], f2[N2], f3[N3], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3],
         gamma[N_ROWS];
    triangular_motion(y, dy, c, shared, Mdot1, Mdot2, f1, f2, f3, A1, A2, A3, gamma);

    /* q1, p1: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* q2, p2: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a2[N2], q2[N2];
    em_triangular_push(N2, L2[0], r2, Mdot2[0], eta2, f2, a2, q2);

    /* q3: constant factors, a = S^-1 C f (41) */
    real a3[N3];
    em_rows_on_eta(1, N3, C3, r3, f3, a3);

    /* q1, p1: B = A L^-T */
    real B1[N_ROWS][N1];
    em_rows_of_root(N_ROWS, N1, L1[0], r1, A1[0], B1[0]);
    /* q2, p2: B = A L^-T */
    real B2[N_ROWS][N2];
    em_rows_of_root(N_ROWS, N2, L2[0], r2, A2[0], B2[0]);
    /* q3: B = A C^T S^-1 (28) */
    real B3[N_ROWS][N3];
    em_rows_on_eta(N_ROWS, N3, C3, r3, A3[0], B3[0]);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        em_add_to_load(N2, row, B2[0], a2, q2, lambda);
        em_add_to_load(N3, row, B3[0], a3, NULL, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
            em_add_product(N3, B3[row], B3[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[5] = a1[0];
    dy[8] = a1[1];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[6] = a2[0];
    dy[9] = a2[1];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    dy[7] = a3[0];
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
    real v1[N1] = { e[0], e[3] };
    if (mode) em_backward(N1, memory + 0, memory + 4, v1);
    else em_velocity_of_eta(N1, y + 10, y + 18, v1);
    v[0] = v1[0];
    v[3] = v1[1];
    real v2[N2] = { e[1], e[4] };
    if (mode) em_backward(N2, memory + 6, memory + 10, v2);
    else em_velocity_of_eta(N2, y + 14, y + 20, v2);
    v[1] = v2[0];
    v[4] = v2[1];
    real v3[N3] = { e[2] };
    em_velocity_of_eta(N3, c + 3, c + 4, v3);
    v[2] = v3[0];
}

#define EM_VELOCITY velocity_by_roots

#include "em_flock.h"
#endif

extern em_lanes four_bars_2_lanes;
em_lanes four_bars_2_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
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
    const double p1_dot = v[3];
    const double c_1 = c[8];
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    const double z_2 = cos_p1*sin_q1;
    const double cos_q1 = em_cos(q1);
    const double sin_p1 = em_sin(p1);
    const double z_5 = cos_q1*sin_p1;
    const double z_6 = q1_dot*p1_dot*(c_1*(z_2 - z_5));
    const double c_3 = c[10];
    const double z_7 = c_1*(p1_dot*z_5 + q1_dot*z_2) - c_1*(p1_dot*z_2 + q1_dot*z_5);
    bias[0] = (-0.5)*((z_6 + cos_q1*c_3) - p1_dot*z_7);
    const double q2_dot = v[1];
    const double p2_dot = v[4];
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_10 = cos_p2*sin_q2;
    const double cos_q2 = em_cos(q2);
    const double sin_p2 = em_sin(p2);
    const double z_13 = cos_q2*sin_p2;
    const double z_14 = q2_dot*p2_dot*(c_1*(z_10 - z_13));
    const double z_15 = c_1*(p2_dot*z_13 + q2_dot*z_10) - c_1*(p2_dot*z_10 + q2_dot*z_13);
    bias[1] = (-0.5)*((z_14 + cos_q2*c_3) - p2_dot*z_15);
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double c_5 = c[12];
    bias[2] = -cos_q3*c_5;
    const double c_4 = c[11];
    bias[3] = 0.5*((z_6 - cos_p1*c_4) + q1_dot*z_7);
    bias[4] = 0.5*((z_14 - cos_p2*c_4) + q2_dot*z_15);
    const double l = c[1];
    const double z_17 = q1_dot*q1_dot;
    const double z_18 = q2_dot*q2_dot;
    const double z_19 = cos_q2*z_18;
    const double z_20 = p1_dot*p1_dot;
    gamma[0] = -l*(cos_q1*z_17 + cos_p1*z_20 - z_19);
    const double z_21 = sin_q2*z_18;
    gamma[1] = -l*(sin_q1*z_17 + sin_p1*z_20 - z_21);
    const double q3_dot = v[2];
    const double z_22 = q3_dot*q3_dot;
    const double z_23 = p2_dot*p2_dot;
    gamma[2] = -l*(z_19 + cos_p2*z_23 - cos_q3*z_22);
    const double sin_q3 = em_sin(q3);
    gamma[3] = -l*(z_21 + sin_p2*z_23 - sin_q3*z_22);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double q1_dot = v[0];
    const double p1_dot = v[3];
    const double c_1 = c[8];
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double sin_p1 = em_sin(p1);
    const double sin_q1 = em_sin(q1);
    const double z_4 = c_1*(cos_p1*cos_q1 + sin_p1*sin_q1);
    const double c_7 = c[14];
    const double q2_dot = v[1];
    const double p2_dot = v[4];
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double sin_p2 = em_sin(p2);
    const double sin_q2 = em_sin(q2);
    const double z_9 = c_1*(cos_p2*cos_q2 + sin_p2*sin_q2);
    const double c_8 = c[15];
    const double q3_dot = v[2];
    e[0] = (1.0/12.0)*(q1_dot*(3.0*p1_dot*z_4 + q1_dot*c_7) + q2_dot*(3.0*p2_dot*z_9 + q2_dot*c_7) +
        p1_dot*(3.0*q1_dot*z_4 + p1_dot*c_8) + p2_dot*(3.0*q2_dot*z_9 + p2_dot*c_8) + c_8*(q3_dot*q3_dot));
    e[1] = 0.0;
    e[2] = 0.0;
    const double l = c[1];
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double c_9 = c[16];
    e[3] = l*(sin_p1 + 3.0*sin_q1 + sin_p2 + 3.0*sin_q2 + sin_q3)*c_9;
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
    p[0] = p[1] = p[3] = p[5] = p[6] = p[7] = p[11] = p[15] = 0.0;
    const double l = c[1];
    p[2] = p[10] = l;
    const double c_10 = c[17];
    p[4] = p[14] = c_10;
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    p[8] = p[18] = p[26] = l*cos_q1;
    const double sin_q1 = em_sin(q1);
    p[9] = p[19] = p[27] = l*sin_q1;
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double z_3 = l + l*cos_q2;
    p[12] = p[22] = p[29] = z_3;
    const double sin_q2 = em_sin(q2);
    p[13] = p[23] = p[30] = l*sin_q2;
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    p[16] = p[32] = p[35] = l*cos_q3 + c_10;
    const double sin_q3 = em_sin(q3);
    p[17] = p[33] = p[36] = l*sin_q3;
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    p[20] = l*(cos_p1 + cos_q1);
    const double sin_p1 = em_sin(p1);
    p[21] = l*(sin_p1 + sin_q1);
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    p[24] = l*cos_p2 + z_3;
    const double sin_p2 = em_sin(p2);
    p[25] = l*(sin_p2 + sin_q2);
    const double c_11 = c[18];
    p[28] = p[31] = p[34] = c_11;
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
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    const double m = c[0];
    const double l = c[1];
    const double z_2 = m*(l*l);
    const double cos_q1 = em_cos(q1);
    const double sin_p1 = em_sin(p1);
    const double z_5 = cos_p1*sin_q1*z_2 - cos_q1*sin_p1*z_2;
    dM[15] = dM[3] = (-0.5)*z_5;
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double cos_q2 = em_cos(q2);
    const double sin_p2 = em_sin(p2);
    const double z_10 = cos_p2*sin_q2*z_2 - cos_q2*sin_p2*z_2;
    dM[46] = dM[34] = (-0.5)*z_10;
    dM[90] = dM[78] = 0.5*z_5;
    dM[121] = dM[109] = 0.5*z_10;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double q1_dot = v[0];
    const double p1_dot = v[3];
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    const double m = c[0];
    const double l = c[1];
    const double z_2 = m*(l*l);
    const double z_3 = cos_p1*z_2;
    const double z_4 = cos_q1*z_3;
    const double sin_q1 = em_sin(q1);
    const double sin_p1 = em_sin(p1);
    const double z_7 = sin_p1*z_2;
    const double z_8 = sin_q1*z_7;
    const double z_9 = q1_dot*p1_dot*(z_4 + z_8);
    const double g = c[2];
    const double z_10 = m*g;
    const double z_11 = l*sin_q1;
    const double z_12 = (p1_dot*z_8 - q1_dot*z_4) + (p1_dot*z_4 - q1_dot*z_8);
    const double z_13 = p1_dot*z_12;
    const double z_14 = sin_q1*z_3;
    const double z_15 = cos_q1*z_7;
    const double z_16 = z_14 - z_15;
    const double p1_ddot = a[3];
    const double z_17 = z_16*p1_ddot;
    const double lambda_0 = lambda[0];
    const double z_18 = l*cos_q1;
    const double lambda_1 = lambda[1];
    D[0] = 0.5*(((z_9 - 3.0*z_10*z_11) + z_13) - z_17 - 2.0*(lambda_0*z_18 + lambda_1*z_11));
    D[3] = 0.5*(z_17 - (z_9 + z_13));
    const double z_19 = q1_dot*z_16;
    const double z_20 = (p1_dot*z_15 + q1_dot*z_14) - (p1_dot*z_14 + q1_dot*z_15);
    const double z_21 = p1_dot*z_16;
    D[8] = 0.5*(z_19 - (z_20 - z_21));
    const double q2_dot = v[1];
    const double p2_dot = v[4];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    const double z_24 = cos_p2*z_2;
    const double z_25 = cos_q2*z_24;
    const double sin_q2 = em_sin(q2);
    const double sin_p2 = em_sin(p2);
    const double z_28 = sin_p2*z_2;
    const double z_29 = sin_q2*z_28;
    const double z_30 = q2_dot*p2_dot*(z_25 + z_29);
    const double z_31 = l*sin_q2;
    const double z_32 = (p2_dot*z_29 - q2_dot*z_25) + (p2_dot*z_25 - q2_dot*z_29);
    const double z_33 = p2_dot*z_32;
    const double z_34 = sin_q2*z_24;
    const double z_35 = cos_q2*z_28;
    const double z_36 = z_34 - z_35;
    const double p2_ddot = a[4];
    const double z_37 = z_36*p2_ddot;
    const double z_38 = l*cos_q2;
    const double lambda_2 = lambda[2];
    const double lambda_3 = lambda[3];
    D[11] = 0.5*(((z_30 - 3.0*z_31*z_10) + z_33) + 2.0*(lambda_0*z_38 + lambda_1*z_31 - lambda_2*z_38 -
        lambda_3*z_31) - z_37);
    D[14] = 0.5*(z_37 - (z_30 + z_33));
    const double z_39 = q2_dot*z_36;
    const double z_40 = (p2_dot*z_35 + q2_dot*z_34) - (p2_dot*z_34 + q2_dot*z_35);
    const double z_41 = p2_dot*z_36;
    D[19] = 0.5*(z_39 - (z_40 - z_41));
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double z_43 = l*sin_q3;
    const double cos_q3 = em_cos(q3);
    const double z_45 = l*cos_q3;
    D[22] = (-0.5)*(z_10*z_43 - 2.0*(lambda_2*z_45 + lambda_3*z_43));
    const double z_46 = q1_dot*z_12;
    const double q1_ddot = a[0];
    const double z_47 = z_16*q1_ddot;
    D[30] = (-0.5)*((z_9 - z_46) + z_47);
    const double z_48 = l*sin_p1;
    const double z_49 = l*cos_p1;
    D[33] = 0.5*(z_47 - (z_46 - (z_9 - z_10*z_48)) - 2.0*(lambda_0*z_49 + lambda_1*z_48));
    D[35] = (-0.5)*(z_21 + (z_20 + z_19));
    const double z_50 = q2_dot*z_32;
    const double q2_ddot = a[1];
    const double z_51 = z_36*q2_ddot;
    D[41] = (-0.5)*((z_30 - z_50) + z_51);
    const double z_52 = l*sin_p2;
    const double z_53 = l*cos_p2;
    D[44] = 0.5*(z_51 - (z_50 - (z_30 - z_10*z_52)) - 2.0*(lambda_2*z_53 + lambda_3*z_52));
    D[46] = (-0.5)*(z_41 + (z_40 + z_39));
    const double z_54 = q1_dot*q1_dot;
    D[50] = z_54*z_11 - q1_ddot*z_18;
    const double z_55 = q2_dot*q2_dot;
    const double z_56 = z_55*z_31 - q2_ddot*z_38;
    D[51] = -z_56;
    const double z_57 = p1_dot*p1_dot;
    D[53] = z_57*z_48 - p1_ddot*z_49;
    D[55] = (-2.0)*(q1_dot*z_18);
    const double z_58 = q2_dot*z_38;
    D[56] = 2.0*z_58;
    D[58] = (-2.0)*(p1_dot*z_49);
    D[60] = -(z_54*z_18 + q1_ddot*z_11);
    const double z_59 = z_55*z_38 + q2_ddot*z_31;
    D[61] = z_59;
    D[63] = -(z_57*z_49 + p1_ddot*z_48);
    D[65] = (-2.0)*(q1_dot*z_11);
    const double z_60 = q2_dot*z_31;
    D[66] = 2.0*z_60;
    D[68] = (-2.0)*(p1_dot*z_48);
    D[71] = z_56;
    const double q3_dot = v[2];
    const double z_61 = q3_dot*q3_dot;
    const double q3_ddot = a[2];
    D[72] = -(z_61*z_43 - q3_ddot*z_45);
    const double z_62 = p2_dot*p2_dot;
    D[74] = z_62*z_52 - p2_ddot*z_53;
    D[76] = (-2.0)*z_58;
    D[77] = 2.0*(q3_dot*z_45);
    D[79] = (-2.0)*(p2_dot*z_53);
    D[81] = -z_59;
    D[82] = z_61*z_45 + q3_ddot*z_43;
    D[84] = -(z_62*z_53 + p2_ddot*z_52);
    D[86] = (-2.0)*z_60;
    D[87] = 2.0*(q3_dot*z_43);
    D[89] = (-2.0)*(p2_dot*z_52);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double l = c[1];
    const double g = c[2];
    const double z_1 = l*g;
    const double z_2 = l*l;
    const double p1 = x[3];
    const double sin_p1 = em_sin(p1);
    const double z_4 = cos_q1*sin_p1;
    const double z_5 = z_2*z_4;
    const double cos_p1 = em_cos(p1);
    const double sin_q1 = em_sin(q1);
    const double z_8 = cos_p1*sin_q1;
    const double z_9 = z_2*z_8;
    const double q1_dot = v[0];
    const double p1_dot = v[3];
    const double z_10 = q1_dot*p1_dot;
    const double z_11 = (z_5 - z_9)*z_10;
    const double z_12 = (q1_dot*z_9 + p1_dot*z_5) - (q1_dot*z_5 + p1_dot*z_9);
    const double q1_ddot = a[0];
    const double p1_ddot = a[3];
    const double z_13 = sin_p1*sin_q1;
    const double z_14 = cos_p1*cos_q1;
    const double z_15 = z_2*z_13 + z_2*z_14;
    D[0] = (1.0/6.0)*(3.0*((3.0*cos_q1*z_1 - z_11) - p1_dot*z_12) + (8.0*q1_ddot*z_2 + 3.0*p1_ddot*z_15));
    const double m = c[0];
    const double z_16 = m*g;
    const double z_17 = m*l;
    const double z_18 = z_17*z_4;
    const double z_19 = z_17*z_8;
    const double z_20 = (z_18 - z_19)*z_10;
    const double z_21 = (q1_dot*z_19 + p1_dot*z_18) - (q1_dot*z_18 + p1_dot*z_19);
    const double z_22 = z_17*z_13 + z_17*z_14;
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    D[1] = (1.0/6.0)*(3.0*((3.0*cos_q1*z_16 - 2.0*z_20) - 2.0*p1_dot*z_21) + 2.0*(8.0*q1_ddot*z_17 +
        3.0*p1_ddot*z_22) - 6.0*(sin_q1*lambda_0 - cos_q1*lambda_1));
    D[2] = 1.5*(cos_q1*z_17);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double p2 = x[4];
    const double sin_p2 = em_sin(p2);
    const double z_25 = cos_q2*sin_p2;
    const double z_26 = z_2*z_25;
    const double cos_p2 = em_cos(p2);
    const double sin_q2 = em_sin(q2);
    const double z_29 = cos_p2*sin_q2;
    const double z_30 = z_2*z_29;
    const double q2_dot = v[1];
    const double p2_dot = v[4];
    const double z_31 = q2_dot*p2_dot;
    const double z_32 = (z_26 - z_30)*z_31;
    const double z_33 = (q2_dot*z_30 + p2_dot*z_26) - (q2_dot*z_26 + p2_dot*z_30);
    const double q2_ddot = a[1];
    const double p2_ddot = a[4];
    const double z_34 = sin_p2*sin_q2;
    const double z_35 = cos_p2*cos_q2;
    const double z_36 = z_2*z_34 + z_2*z_35;
    D[4] = (1.0/6.0)*(3.0*((3.0*cos_q2*z_1 - z_32) - p2_dot*z_33) + (8.0*q2_ddot*z_2 + 3.0*p2_ddot*z_36));
    const double z_37 = z_17*z_25;
    const double z_38 = z_17*z_29;
    const double z_39 = (z_37 - z_38)*z_31;
    const double z_40 = (q2_dot*z_38 + p2_dot*z_37) - (q2_dot*z_37 + p2_dot*z_38);
    const double z_41 = z_17*z_34 + z_17*z_35;
    const double lambda_2 = lambda[2];
    const double lambda_3 = lambda[3];
    D[5] = (1.0/6.0)*(3.0*((3.0*cos_q2*z_16 - 2.0*z_39) - 2.0*p2_dot*z_40) + 2.0*(8.0*q2_ddot*z_17 +
        3.0*p2_ddot*z_41) + 6.0*(sin_q2*lambda_0 + cos_q2*lambda_3 - cos_q2*lambda_1 - sin_q2*lambda_2));
    D[6] = 1.5*(cos_q2*z_17);
    const double q3_ddot = a[2];
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    D[8] = (1.0/6.0)*(2.0*q3_ddot*z_2 + 3.0*cos_q3*z_1);
    const double sin_q3 = em_sin(q3);
    D[9] = (1.0/6.0)*(4.0*q3_ddot*z_17 + 3.0*cos_q3*z_16 + 6.0*(sin_q3*lambda_2 - cos_q3*lambda_3));
    D[10] = 0.5*(cos_q3*z_17);
    D[12] = (1.0/6.0)*(3.0*((cos_p1*z_1 + z_11) - q1_dot*z_12) + (2.0*p1_ddot*z_2 + 3.0*q1_ddot*z_15));
    D[13] = (1.0/6.0)*(3.0*((cos_p1*z_16 + 2.0*z_20) - 2.0*q1_dot*z_21) + 2.0*(2.0*p1_ddot*z_17 +
        3.0*q1_ddot*z_22) - 6.0*(sin_p1*lambda_0 - cos_p1*lambda_1));
    D[14] = 0.5*(cos_p1*z_17);
    D[16] = (1.0/6.0)*(3.0*((cos_p2*z_1 + z_32) - q2_dot*z_33) + (2.0*p2_ddot*z_2 + 3.0*q2_ddot*z_36));
    D[17] = (1.0/6.0)*(3.0*((cos_p2*z_16 + 2.0*z_39) - 2.0*q2_dot*z_40) + 2.0*(2.0*p2_ddot*z_17 +
        3.0*q2_ddot*z_41) - 6.0*(sin_p2*lambda_2 - cos_p2*lambda_3));
    D[18] = 0.5*(cos_p2*z_17);
    const double z_44 = q1_dot*q1_dot;
    const double z_45 = q2_dot*q2_dot;
    const double z_46 = cos_q2*z_45;
    const double z_47 = p1_dot*p1_dot;
    const double z_48 = sin_q2*q2_ddot;
    D[21] = -((cos_q1*z_44 + cos_p1*z_47 - z_46) + (sin_q1*q1_ddot + sin_p1*p1_ddot - z_48));
    const double z_49 = sin_q2*z_45;
    const double z_50 = cos_q2*q2_ddot;
    D[25] = -((sin_q1*z_44 + sin_p1*z_47 - z_49) - (cos_q1*q1_ddot + cos_p1*p1_ddot - z_50));
    const double q3_dot = v[2];
    const double z_51 = q3_dot*q3_dot;
    const double z_52 = p2_dot*p2_dot;
    D[29] = -((z_46 + cos_p2*z_52 - cos_q3*z_51) + (z_48 + sin_p2*p2_ddot - sin_q3*q3_ddot));
    D[33] = -((z_49 + sin_p2*z_52 - sin_q3*z_51) - (z_50 + cos_p2*p2_ddot - cos_q3*q3_ddot));
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
    D[0] = -l*sin_q1;
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_2 = l*sin_q2;
    D[1] = z_2;
    const double p1 = x[3];
    const double sin_p1 = em_sin(p1);
    D[3] = -l*sin_p1;
    const double cos_p1 = em_cos(p1);
    const double cos_q1 = em_cos(q1);
    const double cos_q2 = em_cos(q2);
    D[11] = -(1.0 + cos_q2 - cos_p1 - cos_q1);
    D[14] = l*cos_q1;
    const double z_7 = l*cos_q2;
    D[15] = -z_7;
    D[17] = l*cos_p1;
    D[25] = sin_p1 + sin_q1 - sin_q2;
    D[29] = -z_2;
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    D[30] = l*sin_q3;
    const double p2 = x[4];
    const double sin_p2 = em_sin(p2);
    D[32] = -l*sin_p2;
    const double cos_p2 = em_cos(p2);
    const double cos_q3 = em_cos(q3);
    D[39] = -(1.0 + cos_q3 - cos_p2 - cos_q2);
    D[43] = z_7;
    D[44] = -l*cos_q3;
    D[46] = l*cos_p2;
    D[53] = sin_p2 + sin_q2 - sin_q3;
    const double q1_dot = v[0];
    const double z_12 = q1_dot*l;
    D[56] = -cos_q1*z_12;
    const double q2_dot = v[1];
    const double z_13 = q2_dot*l;
    const double z_14 = cos_q2*z_13;
    D[57] = z_14;
    const double p1_dot = v[3];
    const double z_15 = p1_dot*l;
    D[59] = -cos_p1*z_15;
    D[61] = -l*sin_q1;
    D[62] = z_2;
    D[64] = -l*sin_p1;
    const double z_16 = q2_dot*sin_q2;
    D[67] = -(p1_dot*sin_p1 + q1_dot*sin_q1 - z_16);
    D[70] = -sin_q1*z_12;
    const double z_17 = sin_q2*z_13;
    D[71] = z_17;
    D[73] = -sin_p1*z_15;
    D[75] = l*cos_q1;
    D[76] = -z_7;
    D[78] = l*cos_p1;
    const double z_18 = q2_dot*cos_q2;
    D[81] = p1_dot*cos_p1 + q1_dot*cos_q1 - z_18;
    D[85] = -z_14;
    const double q3_dot = v[2];
    const double z_19 = q3_dot*l;
    D[86] = cos_q3*z_19;
    const double p2_dot = v[4];
    const double z_20 = p2_dot*l;
    D[88] = -cos_p2*z_20;
    D[90] = -z_2;
    D[91] = l*sin_q3;
    D[93] = -l*sin_p2;
    D[95] = -(p2_dot*sin_p2 + z_16 - q3_dot*sin_q3);
    D[99] = -z_17;
    D[100] = sin_q3*z_19;
    D[102] = -sin_p2*z_20;
    D[104] = z_7;
    D[105] = -l*cos_q3;
    D[107] = l*cos_p2;
    D[109] = p2_dot*cos_p2 + z_18 - q3_dot*cos_q3;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes four_bars_2_lanes;
EM_WEAK em_lanes four_bars_2_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 1, 2, 0, 1 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 10, 18, 0, 4 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_IN_STATE, 14, 20, 6, 10 };
static const em_block block3 = { N, N3, coordinate3, scales, EM_PREPARED_FACTORS, 3, 4, 5, 6 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, &block3, NULL };

/* M of the constant blocks, and what other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double M3[N3][N3],
                                  double prepared[N_PREPARED])
{
    const double m = parameters[0];
    const double l = parameters[1];
    const double z_0 = m*(l*l);
    M3[0][0] = (1.0/3.0)*z_0;
    prepared[7] = (4.0/3.0)*z_0; /* c_0 */
    prepared[8] = z_0; /* c_1 */
    prepared[9] = (1.0/3.0)*z_0; /* c_2 */
    const double g = parameters[2];
    const double z_1 = m*g;
    const double z_2 = l*z_1;
    prepared[10] = 3.0*z_2; /* c_3 */
    prepared[11] = z_2; /* c_4 */
    prepared[12] = 0.5*z_2; /* c_5 */
    prepared[13] = fabs(l); /* c_6 */
    prepared[14] = 8.0*z_0; /* c_7 */
    prepared[15] = 2.0*z_0; /* c_8 */
    prepared[16] = 0.5*z_1; /* c_9 */
    prepared[17] = 2.0*l; /* c_10 */
    prepared[18] = (1.0/30.0)*l; /* c_11 */
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
    double M3[N3][N3];
    prepared_constants(parameters, M3, c);
    if (em_prepare(&block3, M3[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_ACROSS void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double c_0 = c[7];
    M[0] = c_0;
    M[5] = M[1] = 0.0;
    M[6] = c_0;
    M[10] = M[2] = 0.0;
    M[11] = M[7] = 0.0;
    const double c_2 = c[9];
    M[12] = c_2;
    const double c_1 = c[8];
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double sin_p1 = em_sin(p1);
    const double sin_q1 = em_sin(q1);
    M[15] = M[3] = 0.5*(c_1*(cos_p1*cos_q1 + sin_p1*sin_q1));
    M[16] = M[8] = 0.0;
    M[17] = M[13] = 0.0;
    M[18] = c_2;
    M[20] = M[4] = 0.0;
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double sin_p2 = em_sin(p2);
    const double sin_q2 = em_sin(q2);
    M[21] = M[9] = 0.5*(c_1*(cos_p2*cos_q2 + sin_p2*sin_q2));
    M[22] = M[14] = 0.0;
    M[23] = M[19] = 0.0;
    M[24] = c_2;
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
    const double l = c[1];
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    A[0] = -l*sin_q1;
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_2 = l*sin_q2;
    A[1] = z_2;
    A[2] = 0.0;
    const double p1 = x[3];
    const double sin_p1 = em_sin(p1);
    A[3] = -l*sin_p1;
    A[4] = 0.0;
    const double cos_q1 = em_cos(q1);
    A[5] = l*cos_q1;
    const double cos_q2 = em_cos(q2);
    const double z_6 = l*cos_q2;
    A[6] = -z_6;
    A[7] = 0.0;
    const double cos_p1 = em_cos(p1);
    A[8] = l*cos_p1;
    A[9] = 0.0;
    A[10] = 0.0;
    A[11] = -z_2;
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    A[12] = l*sin_q3;
    A[13] = 0.0;
    const double p2 = x[4];
    const double sin_p2 = em_sin(p2);
    A[14] = -l*sin_p2;
    A[15] = 0.0;
    A[16] = z_6;
    const double cos_q3 = em_cos(q3);
    A[17] = -l*cos_q3;
    A[18] = 0.0;
    const double cos_p2 = em_cos(p2);
    A[19] = l*cos_p2;
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
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double z_2 = l*cos_q2;
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    phi[0] = -(l + z_2 - l*cos_q1 - l*cos_p1);
    const double sin_p1 = em_sin(p1);
    const double sin_q1 = em_sin(q1);
    const double sin_q2 = em_sin(q2);
    phi[1] = l*(sin_p1 + sin_q1 - sin_q2);
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    phi[2] = -(l + l*cos_q3 - z_2 - l*cos_p2);
    const double sin_p2 = em_sin(p2);
    const double sin_q3 = em_sin(q3);
    phi[3] = l*(sin_p2 + sin_q2 - sin_q3);
    const double c_6 = c[13];
    const double z_11 = c_6 + c_6*(fabs(cos_q2) + fabs(q2*sin_q2));
    terms[0] = c_6*(fabs(cos_q1) + fabs(q1*sin_q1)) + c_6*(fabs(cos_p1) + fabs(p1*sin_p1)) + z_11;
    const double z_12 = fabs(sin_q2) + fabs(q2*cos_q2);
    terms[1] = c_6*((fabs(sin_p1) + fabs(p1*cos_p1)) + (fabs(sin_q1) + fabs(q1*cos_q1)) + z_12);
    terms[2] = c_6*(fabs(cos_q3) + fabs(q3*sin_q3)) + c_6*(fabs(cos_p2) + fabs(p2*sin_p2)) + z_11;
    terms[3] = c_6*(z_12 + (fabs(sin_p2) + fabs(p2*cos_p2)) + (fabs(sin_q3) + fabs(q3*cos_q3)));
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
                              double M2[N2][N2], double A1[N_ROWS][N1], double A2[N_ROWS][N2],
                              double A3[N_ROWS][N3], double b[N_ROWS], double shared[8])
{
    const double c_0 = c[7];
    M1[0][0] = c_0;
    const double c_1 = c[8];
    const double p1 = x[3];
    const double cos_p1 = em_cos(p1);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double sin_p1 = em_sin(p1);
    const double sin_q1 = em_sin(q1);
    M1[0][1] = M1[1][0] = 0.5*(c_1*(cos_p1*cos_q1 + sin_p1*sin_q1));
    const double c_2 = c[9];
    M1[1][1] = c_2;
    M2[0][0] = c_0;
    const double p2 = x[4];
    const double cos_p2 = em_cos(p2);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double sin_p2 = em_sin(p2);
    const double sin_q2 = em_sin(q2);
    M2[0][1] = M2[1][0] = 0.5*(c_1*(cos_p2*cos_q2 + sin_p2*sin_q2));
    M2[1][1] = c_2;
    const double l = c[1];
    A1[0][0] = -l*sin_q1;
    A1[0][1] = -l*sin_p1;
    A1[1][0] = l*cos_q1;
    A1[1][1] = l*cos_p1;
    A1[2][0] = 0.0;
    A1[2][1] = 0.0;
    A1[3][0] = 0.0;
    A1[3][1] = 0.0;
    const double z_8 = l*sin_q2;
    A2[0][0] = z_8;
    A2[0][1] = 0.0;
    const double z_9 = l*cos_q2;
    A2[1][0] = -z_9;
    A2[1][1] = 0.0;
    A2[2][0] = -z_8;
    A2[2][1] = -l*sin_p2;
    A2[3][0] = z_9;
    A2[3][1] = l*cos_p2;
    A3[0][0] = 0.0;
    A3[1][0] = 0.0;
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    A3[2][0] = l*sin_q3;
    const double cos_q3 = em_cos(q3);
    A3[3][0] = -l*cos_q3;
    b[0] = 0.0;
    b[1] = 0.0;
    b[2] = 0.0;
    b[3] = 0.0;
    shared[0] = cos_q1;
    shared[1] = sin_p1;
    shared[2] = cos_p1;
    shared[3] = sin_q1;
    shared[4] = cos_q2;
    shared[5] = sin_p2;
    shared[6] = cos_p2;
    shared[7] = sin_q2;
}

/* Mdot */
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[8],
                             double Mdot1[N1][N1], double Mdot2[N2][N2])
{
    Mdot1[0][0] = 0.0;
    const double c_1 = c[8];
    const double p1_dot = v[3];
    const double cos_q1 = shared[0];
    const double sin_p1 = shared[1];
    const double z_12 = cos_q1*sin_p1;
    const double q1_dot = v[0];
    const double cos_p1 = shared[2];
    const double sin_q1 = shared[3];
    const double z_13 = cos_p1*sin_q1;
    Mdot1[0][1] = Mdot1[1][0] = (-0.5)*(c_1*(p1_dot*z_12 + q1_dot*z_13) - c_1*(p1_dot*z_13 + q1_dot*z_12));
    Mdot1[1][1] = 0.0;
    Mdot2[0][0] = 0.0;
    const double p2_dot = v[4];
    const double cos_q2 = shared[4];
    const double sin_p2 = shared[5];
    const double z_14 = cos_q2*sin_p2;
    const double q2_dot = v[1];
    const double cos_p2 = shared[6];
    const double sin_q2 = shared[7];
    const double z_15 = cos_p2*sin_q2;
    Mdot2[0][1] = Mdot2[1][0] = (-0.5)*(c_1*(p2_dot*z_14 + q2_dot*z_15) - c_1*(p2_dot*z_15 + q2_dot*z_14));
    Mdot2[1][1] = 0.0;
}

/* After an accepted step, and at the start: constraints on positions, C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], M2[N2][N2], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], b[N_ROWS], shared[8];
    settled_masses(y, c, M1, M2, A1, A2, A3, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;
    if (changed && em_settle_factors(&block2, *mode, 0, M2[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 18);
    gap = fmin(gap, em_gap(N2, y + 20));
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block2, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block3, *mode, y + N, y, c, memory, dy);
        double Mdot1[N1][N1], Mdot2[N2][N2];
        settled_rates(dy, c, shared, Mdot1, Mdot2);
        double time = em_time_of_block(&block1, Mdot1[0], y);
        time = fmin(time, em_time_of_block(&block2, Mdot2[0], y));
        wanted = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != wanted) {
        if (em_change_mode(&block1, wanted, M1[0], y, memory, fault)) return -1;
        if (em_change_mode(&block2, wanted, M2[0], y, memory, fault)) return -1;
        *mode = wanted;
        changed = 1;
    }

    if (flags & EM_STABILISE) { /* eta <- eta - B^T Delta^-1 (B eta + b) */
        double B1[N_ROWS][N1], a1[N1];
        em_rows_of_block(&block1, *mode, N_ROWS, y, c, memory, A1[0], B1[0]);
        em_take(&block1, y + N, a1);
        double B2[N_ROWS][N2], a2[N2];
        em_rows_of_block(&block2, *mode, N_ROWS, y, c, memory, A2[0], B2[0]);
        em_take(&block2, y + N, a2);
        double B3[N_ROWS][N3], a3[N3];
        em_rows_of_block(&block3, *mode, N_ROWS, y, c, memory, A3[0], B3[0]);
        em_take(&block3, y + N, a3);

        /* Delta = B B^T (43), Delta lambda = B a (46), in one loop */
        real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
        for (int row = 0; row < N_ROWS; ++row) {
            lambda[row] = b[row];
            em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
            em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
            em_add_to_load(N3, row, B3[0], a3, NULL, lambda);
            for (int column = 0; column <= row; ++column) {
                Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
                em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
                em_add_product(N3, B3[row], B3[column], &Delta[row*N_ROWS + column]);
            }
        }
        if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;
        em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
        em_put(&block1, a1, y + N);
        em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
        em_put(&block2, a2, y + N);
        em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
        em_put(&block3, a3, y + N);
    }
    return changed;
}

/* v (n): xdot from a state, in the meaning of its mode. */
EM_ACROSS int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    double M[N*N];
    factored(t, y, c, M);
    if (em_velocity_at(&block1, mode, M, y, c, v, fault)) return -1;
    if (em_velocity_at(&block2, mode, M, y, c, v, fault)) return -1;
    if (em_velocity_at(&block3, mode, M, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that an error e (n) of eta makes. */
EM_ACROSS void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, mode, e, y, c, memory, ev);
    em_velocity_kept(&block2, mode, e, y, c, memory, ev);
    em_velocity_kept(&block3, mode, e, y, c, memory, ev);
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
    em_publish_block(&block2, v, y, row);
    return 0;
}

/* y (n_state) from x, v (n); eigenfactors continuous with those y holds, if any */
EM_ACROSS int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    double C[N*N] = {0.0}, s[N], eta[N];
    em_spread(N, N1, coordinate1, y + 10, C);
    em_spread(N, N2, coordinate2, y + 14, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 10);
    for (int i = 0; i < N1; ++i) y[18 + i] = s[coordinate1[i]];
    em_gather(N, N2, coordinate2, C, y + 14);
    for (int i = 0; i < N2; ++i) y[20 + i] = s[coordinate2[i]];
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
    if (em_coincident_block(&block2, y, fault)) return -1;
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "four_bars_2.h"

static const char *const coordinate_names[] = { "q1", "q2", "q3", "p1", "p2", NULL };
static const char *const parameter_names[] = { "m", "l", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { -0.5707963267948967, -0.5707963267948967, -0.5707963267948967, 0.0, 0.0 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 1, 1, 0, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 2},
    {"ground", 2, 2},
    {"ground", 4, 2},
    {"line", 6, 4},
    {"line", 10, 4},
    {"line", 14, 4},
    {"line", 18, 4},
    {"line", 22, 4},
    {"disk", 26, 3},
    {"disk", 29, 3},
    {"disk", 32, 3},
    {"trace", 35, 2}
};
static const em_slice layout[] = {
    {"x", 0, 5},
    {"eta", 5, 5},
    {"C", 10, 8},
    {"s", 18, 4}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dq3: M does not depend on it",
    "C, mu, Omega across blocks: {q1, p1}, {q2, p2}, {q3} do not couple",
    "C, s, mu, Omega of {q3}: this block is constant, factored once per parameter set",
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
static int simulate(em_run *run) { return em_simulate(&four_bars_2_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&four_bars_2_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&four_bars_2_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&four_bars_2_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&four_bars_2_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&four_bars_2_model, run, mode); }

const em_model four_bars_2_model = {
    .abi = EM_ABI,
    .name = "four_bars_2",
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
    .n_left_out = 8,
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
    .lanes = &four_bars_2_lanes,
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
    .n_shapes = 12,
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
