/* eigenmotion generate sphere.py */
/* input sha256:87fcfceb530674a524220a6812c1bd35ccba13b97f87d16d8ddc76de85c67965 */
/* body sha256:5a8bd6263bdc5361639759994c5390b89824d9c11094b22d137077619c04790c */
/* sphere: equations of motion, eigenfactor formulation.
 *
 * State, 22 numbers:
 *   x    y[0 .. 5)
 *   eta  y[5 .. 10)
 *   C    y[10 .. 19)
 *   s    y[19 .. 22)
 *
 * Blocks of M that do not couple:
 *   1: x (constant, factored once per parameter set)
 *   2: y (constant, factored once per parameter set)
 *   3: p_1, p_2, p_3 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dx, dM/dy: M does not depend on them
 *   C, mu, Omega across blocks: {x}, {y}, {p_1, p_2, p_3} do not couple
 *   C, s, mu, Omega of {x}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {y}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 40 additions, 107 multiplications, 3 divisions
 *   triangular root: 45 additions, 121 multiplications, 3 divisions
 *   projection: 24 additions, 69 multiplications, 3 divisions
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 5,                /* coordinates */
    N_ROWS = 2,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 22,         /* numbers of a state */
    N_C = 9,              /* of which C, */
    N_S = 3,              /* s, */
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
    N_PARAMETERS = 4,
    N_PREPARED = 31,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 5,          /* inputs, parameters and the time */
    N_ARGUMENTS = 15,     /* x, v and these: what motion depends on */
    N1 = 1,               /* x */
    N2 = 1,               /* y */
    N3 = 3,               /* p_1, p_2, p_3 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0 };
EM_UNUSED static const int coordinate2[N2] = { 1 };
EM_UNUSED static const int coordinate3[N3] = { 2, 3, 4 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot3[N3][N3], real f1[N1], real f2[N2], real f3[N3],
                                  real A1[N_ROWS][N1], real A2[N_ROWS][N2], real A3[N_ROWS][N3],
                                  real gamma[N_ROWS])
{
    const real c_0 = c[12];
    const real p_3 = x[4];
    const real p_3_dot = v[4];
    const real p_1 = x[2];
    const real z_0 = p_1*p_1;
    const real p_2 = x[3];
    const real z_1 = p_2*p_2;
    const real z_2 = p_3*p_3;
    const real z_3 = 1.0 + z_0 + z_1 + z_2;
    const real z_4 = z_3*z_3;
    const real z_5 = 1.0/z_4;
    const real z_6 = p_3_dot*z_5;
    const real p_1_dot = v[2];
    const real p_2_dot = v[3];
    const real z_7 = p_1_dot*p_1 + p_2_dot*p_2 + p_3_dot*p_3;
    const real z_8 = 1.0/(z_3*z_4);
    const real z_9 = z_7*z_8;
    const real z_10 = c_0*(p_3*z_6 - 2.0*z_2*z_9);
    const real z_11 = p_2_dot*z_5;
    const real c_2 = c[14];
    const real z_12 = c_2*z_9;
    const real z_13 = c_0*(p_2*z_11 - 2.0*z_1*z_9) - z_12;
    Mdot3[0][0] = ((-16.0/5.0))*(-z_10 - z_13);
    const real z_14 = p_1_dot*z_5;
    Mdot3[0][1] = Mdot3[1][0] = ((-8.0/5.0))*(c_0*(p_2*z_14 + p_1*z_11 - 4.0*z_9*(p_1*p_2)));
    const real z_15 = c_0*(p_1*z_14 - 2.0*z_0*z_9);
    Mdot3[1][1] = ((-16.0/5.0))*(z_12 - z_10 - z_15);
    Mdot3[0][2] = Mdot3[2][0] = ((-8.0/5.0))*(c_0*(p_3*z_14 + p_1*z_6 - 4.0*z_9*(p_1*p_3)));
    Mdot3[1][2] = Mdot3[2][1] = ((-8.0/5.0))*(c_0*(p_3*z_11 + p_2*z_6 - 4.0*z_9*(p_2*p_3)));
    Mdot3[2][2] = ((-16.0/5.0))*(-z_15 - z_13);
    const real c_3 = c[15];
    f1[0] = c_3;
    f2[0] = em_real(0.0);
    const real z_16 = p_3_dot + p_2_dot*p_1 - p_1_dot*p_2;
    const real z_17 = c_0*z_5;
    const real z_18 = p_2_dot*z_17;
    const real z_19 = p_2_dot + p_1_dot*p_3 - p_3_dot*p_1;
    const real z_20 = p_3_dot*z_17;
    const real z_21 = p_1_dot + p_3_dot*p_2 - p_2_dot*p_3;
    const real z_22 = c_0*(z_8*(z_16*z_16) + z_8*(z_19*z_19) + z_8*(z_21*z_21));
    f3[0] = (8.0/5.0)*(z_16*z_18 - z_19*z_20 - 2.0*p_1*z_22);
    const real z_23 = p_1_dot*z_17;
    f3[1] = ((-8.0/5.0))*(z_16*z_23 + 2.0*p_2*z_22 - z_21*z_20);
    f3[2] = (8.0/5.0)*(z_19*z_23 - z_21*z_18 - 2.0*p_3*z_22);
    A1[0][0] = em_real(1.0);
    A1[1][0] = em_real(0.0);
    A2[0][0] = em_real(0.0);
    A2[1][0] = em_real(1.0);
    const real c_4 = c[16];
    const real z_24 = 1.0/z_3;
    const real z_25 = c_4*z_24;
    A3[0][0] = -p_3*z_25;
    A3[0][1] = -z_25;
    A3[0][2] = p_1*z_25;
    A3[1][0] = z_25;
    A3[1][1] = -p_3*z_25;
    A3[1][2] = p_2*z_25;
    const real R = c[1];
    const real z_26 = z_7*z_5;
    const real z_27 = R*(p_3_dot*z_24 - 2.0*p_3*z_26);
    const real z_28 = c_4*z_26;
    gamma[0] = (-2.0)*(p_1_dot*z_27 - p_3_dot*(R*(p_1_dot*z_24 - 2.0*p_1*z_26)) - p_2_dot*z_28);
    gamma[1] = (-2.0)*(p_2_dot*z_27 + p_1_dot*z_28 - p_3_dot*(R*(p_2_dot*z_24 - 2.0*p_2*z_26)));
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5] };
    const real *const C1 = c + 4, *const s1 = c + 5;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* y: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[6] };
    const real *const C2 = c + 8, *const s2 = c + 9;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* p_1, p_2, p_3: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[7], y[8], y[9] };
    const real *const C3 = y + 10, *const s3 = y + 19;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];
    dy[3] = v3[1];
    dy[4] = v3[2];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5] };
    const real *const C1 = c + 4, *const s1 = c + 5;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* y: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[6] };
    const real *const C2 = c + 8, *const s2 = c + 9;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* p_1, p_2, p_3: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[7], y[8], y[9] };
    const real *const C3 = y + 10, *const s3 = y + 19;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];
    dy[3] = v3[1];
    dy[4] = v3[2];

    real Mdot3[N3][N3], f1[N1], f2[N2], f3[N3], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot3, f1, f2, f3, A1, A2, A3, gamma);

    /* x: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* y: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* p_1, p_2, p_3: B = A C^T S^-1 (28) */
    real B3[N_ROWS][N3];
    em_rows_on_eta(N_ROWS, N3, C3, r3, A3[0], B3[0]);

    /* x: constant factors, a = S^-1 C f (41) */
    real a1[N1];
    em_rows_on_eta(1, N1, C1, r1, f1, a1);

    /* y: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* p_1, p_2, p_3: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T3[N3*N3], mu3[N3*N3], Omega3[N3*N3];
    em_turned_for_tiles(N3, C3, T3);
    em_congruence_below(N3, C3, T3, Mdot3[0], mu3);
    em_omega_apart(N3, s3, mu3, Omega3);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C3_dot = dy + 10, *const s3_dot = dy + 19;
    em_factor_rates(N3, C3, r3, mu3, Omega3, C3_dot, s3_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a3[N3], q3[N3];
    em_turning_push(N3, C3, T3, s3, r3, Omega3, s3_dot, eta3, w3, f3, a3, q3);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        em_add_to_load(N3, row, B3[0], a3, q3, lambda);
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
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[6] = a2[0];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    dy[7] = a3[0];
    dy[8] = a3[1];
    dy[9] = a3[2];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M3[N3][N3],
                                 real shared[8])
{
    const real c_0 = c[12];
    const real p_3 = x[4];
    const real z_0 = p_3*p_3;
    const real p_1 = x[2];
    const real z_1 = p_1*p_1;
    const real p_2 = x[3];
    const real z_2 = p_2*p_2;
    const real z_3 = 1.0 + z_1 + z_2 + z_0;
    const real z_4 = z_3*z_3;
    const real z_5 = 1.0/z_4;
    const real z_6 = z_0*z_5;
    const real z_7 = z_5;
    const real z_8 = z_7 + z_2*z_5;
    M3[0][0] = (8.0/5.0)*(c_0*(z_6 + z_8));
    const real c_1 = c[13];
    const real z_9 = p_1*z_5;
    const real z_10 = c_1*z_9;
    M3[1][0] = -p_2*z_10;
    const real z_11 = z_1*z_5;
    M3[1][1] = (8.0/5.0)*(c_0*(z_7 + z_6 + z_11));
    M3[2][0] = -p_3*z_10;
    const real z_12 = p_2*p_3;
    M3[2][1] = -c_1*z_5*z_12;
    M3[2][2] = (8.0/5.0)*(c_0*(z_11 + z_8));
    shared[0] = z_5;
    shared[1] = z_0;
    shared[2] = z_3;
    shared[3] = z_4;
    shared[4] = z_2;
    shared[5] = z_9;
    shared[6] = z_1;
    shared[7] = z_12;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[8], real Mdot3[N3][N3], real f1[N1], real f2[N2],
                                 real f3[N3], real A1[N_ROWS][N1], real A2[N_ROWS][N2], real A3[N_ROWS][N3],
                                 real gamma[N_ROWS])
{
    const real c_0 = c[12];
    const real p_3_dot = v[4];
    const real p_3 = x[4];
    const real z_5 = shared[0];
    const real z_13 = p_3*z_5;
    const real z_0 = shared[1];
    const real p_1_dot = v[2];
    const real p_1 = x[2];
    const real p_2_dot = v[3];
    const real p_2 = x[3];
    const real z_14 = p_1_dot*p_1 + p_2_dot*p_2 + p_3_dot*p_3;
    const real z_3 = shared[2];
    const real z_4 = shared[3];
    const real z_15 = 1.0/(z_3*z_4);
    const real z_16 = z_14*z_15;
    const real z_17 = c_0*(p_3_dot*z_13 - 2.0*z_0*z_16);
    const real z_18 = p_2*z_5;
    const real z_2 = shared[4];
    const real c_2 = c[14];
    const real z_19 = c_2*z_16;
    const real z_20 = c_0*(p_2_dot*z_18 - 2.0*z_2*z_16) - z_19;
    Mdot3[0][0] = ((-16.0/5.0))*(-z_17 - z_20);
    const real z_9 = shared[5];
    Mdot3[0][1] = Mdot3[1][0] = ((-8.0/5.0))*(c_0*(p_1_dot*z_18 + p_2_dot*z_9 - 4.0*z_16*(p_1*p_2)));
    const real z_1 = shared[6];
    const real z_21 = c_0*(p_1_dot*z_9 - 2.0*z_1*z_16);
    Mdot3[1][1] = ((-16.0/5.0))*(z_19 - z_17 - z_21);
    Mdot3[0][2] = Mdot3[2][0] = ((-8.0/5.0))*(c_0*(p_1_dot*z_13 + p_3_dot*z_9 - 4.0*z_16*(p_1*p_3)));
    const real z_12 = shared[7];
    Mdot3[1][2] = Mdot3[2][1] = ((-8.0/5.0))*(c_0*(p_2_dot*z_13 + p_3_dot*z_18 - 4.0*z_16*z_12));
    Mdot3[2][2] = ((-16.0/5.0))*(-z_21 - z_20);
    const real c_3 = c[15];
    f1[0] = c_3;
    f2[0] = em_real(0.0);
    const real z_22 = p_3_dot + p_2_dot*p_1 - p_1_dot*p_2;
    const real z_23 = c_0*z_5;
    const real z_24 = p_2_dot*z_23;
    const real z_25 = p_2_dot + p_1_dot*p_3 - p_3_dot*p_1;
    const real z_26 = p_3_dot*z_23;
    const real z_27 = p_1_dot + p_3_dot*p_2 - p_2_dot*p_3;
    const real z_28 = c_0*(z_15*(z_22*z_22) + z_15*(z_25*z_25) + z_15*(z_27*z_27));
    f3[0] = (8.0/5.0)*(z_22*z_24 - z_25*z_26 - 2.0*p_1*z_28);
    const real z_29 = p_1_dot*z_23;
    f3[1] = ((-8.0/5.0))*(z_22*z_29 + 2.0*p_2*z_28 - z_27*z_26);
    f3[2] = (8.0/5.0)*(z_25*z_29 - z_27*z_24 - 2.0*p_3*z_28);
    A1[0][0] = em_real(1.0);
    A1[1][0] = em_real(0.0);
    A2[0][0] = em_real(0.0);
    A2[1][0] = em_real(1.0);
    const real c_4 = c[16];
    const real z_30 = 1.0/z_3;
    const real z_31 = c_4*z_30;
    A3[0][0] = -p_3*z_31;
    A3[0][1] = -z_31;
    A3[0][2] = p_1*z_31;
    A3[1][0] = z_31;
    A3[1][1] = -p_3*z_31;
    A3[1][2] = p_2*z_31;
    const real R = c[1];
    const real z_32 = z_14*z_5;
    const real z_33 = R*(p_3_dot*z_30 - 2.0*p_3*z_32);
    const real z_34 = c_4*z_32;
    gamma[0] = (-2.0)*(p_1_dot*z_33 - p_3_dot*(R*(p_1_dot*z_30 - 2.0*p_1*z_32)) - p_2_dot*z_34);
    gamma[1] = (-2.0)*(p_2_dot*z_33 + p_1_dot*z_34 - p_3_dot*(R*(p_2_dot*z_30 - 2.0*p_2*z_32)));
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M3[N3][N3], shared[8];
    triangular_masses(y, c, M3, shared);

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5] };
    const real *const C1 = c + 4, *const s1 = c + 5;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* y: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[6] };
    const real *const C2 = c + 8, *const s2 = c + 9;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* p_1, p_2, p_3: M = L L^T */
    real L3[N3][N3], r3[N3];
    const int singular3 = em_cholesky(N3, M3[0], L3[0], r3, EM_SINGULAR_PIVOT);
    if (singular3 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate3[singular3], -1, 0.0);
    const real eta3[N3] = { y[7], y[8], y[9] };
    real v3[N3];
    em_copy(N3, eta3, v3);
    em_backward(N3, L3[0], r3, v3);
    dy[2] = v3[0];
    dy[3] = v3[1];
    dy[4] = v3[2];

    real Mdot3[N3][N3], f1[N1], f2[N2], f3[N3], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], gamma[N_ROWS];
    triangular_motion(y, dy, c, shared, Mdot3, f1, f2, f3, A1, A2, A3, gamma);

    /* x: constant factors, a = S^-1 C f (41) */
    real a1[N1];
    em_rows_on_eta(1, N1, C1, r1, f1, a1);

    /* y: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* p_1, p_2, p_3: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a3[N3], q3[N3];
    em_triangular_push(N3, L3[0], r3, Mdot3[0], eta3, f3, a3, q3);

    /* x: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);
    /* y: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);
    /* p_1, p_2, p_3: B = A L^-T */
    real B3[N_ROWS][N3];
    em_rows_of_root(N_ROWS, N3, L3[0], r3, A3[0], B3[0]);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        em_add_to_load(N3, row, B3[0], a3, q3, lambda);
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
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[6] = a2[0];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    dy[7] = a3[0];
    dy[8] = a3[1];
    dy[9] = a3[2];
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

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M3[N3][N3],
                              real A1[N_ROWS][N1], real A2[N_ROWS][N2], real A3[N_ROWS][N3], real b[N_ROWS],
                              real shared[8])
{
    const real c_0 = c[12];
    const real p_3 = x[4];
    const real z_0 = p_3*p_3;
    const real p_1 = x[2];
    const real z_1 = p_1*p_1;
    const real p_2 = x[3];
    const real z_2 = p_2*p_2;
    const real z_3 = 1.0 + z_1 + z_2 + z_0;
    const real z_4 = z_3*z_3;
    const real z_5 = 1.0/z_4;
    const real z_6 = z_0*z_5;
    const real z_7 = z_5;
    const real z_8 = z_7 + z_2*z_5;
    M3[0][0] = (8.0/5.0)*(c_0*(z_6 + z_8));
    const real c_1 = c[13];
    const real z_9 = p_1*z_5;
    const real z_10 = c_1*z_9;
    M3[0][1] = M3[1][0] = -p_2*z_10;
    const real z_11 = z_1*z_5;
    M3[1][1] = (8.0/5.0)*(c_0*(z_7 + z_6 + z_11));
    M3[0][2] = M3[2][0] = -p_3*z_10;
    const real z_12 = p_2*p_3;
    M3[1][2] = M3[2][1] = -c_1*z_5*z_12;
    M3[2][2] = (8.0/5.0)*(c_0*(z_11 + z_8));
    A1[0][0] = em_real(1.0);
    A1[1][0] = em_real(0.0);
    A2[0][0] = em_real(0.0);
    A2[1][0] = em_real(1.0);
    const real c_4 = c[16];
    const real z_13 = c_4/z_3;
    A3[0][0] = -p_3*z_13;
    A3[0][1] = -z_13;
    A3[0][2] = p_1*z_13;
    A3[1][0] = z_13;
    A3[1][1] = -p_3*z_13;
    A3[1][2] = p_2*z_13;
    b[0] = em_real(0.0);
    b[1] = em_real(0.0);
    shared[0] = z_5;
    shared[1] = z_0;
    shared[2] = z_3;
    shared[3] = z_4;
    shared[4] = z_2;
    shared[5] = z_9;
    shared[6] = z_1;
    shared[7] = z_12;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict x, const real *restrict v, const real *restrict c,
                             const real shared[8], real Mdot3[N3][N3])
{
    const real c_0 = c[12];
    const real p_3_dot = v[4];
    const real p_3 = x[4];
    const real z_14 = p_3_dot*p_3;
    const real z_5 = shared[0];
    const real z_0 = shared[1];
    const real p_1_dot = v[2];
    const real p_1 = x[2];
    const real p_2_dot = v[3];
    const real p_2 = x[3];
    const real z_15 = p_2_dot*p_2;
    const real z_3 = shared[2];
    const real z_4 = shared[3];
    const real z_16 = (p_1_dot*p_1 + z_15 + z_14)/(z_3*z_4);
    const real z_17 = c_0*(z_14*z_5 - 2.0*z_0*z_16);
    const real z_2 = shared[4];
    const real c_2 = c[14];
    const real z_18 = c_2*z_16;
    const real z_19 = c_0*(z_15*z_5 - 2.0*z_2*z_16) - z_18;
    Mdot3[0][0] = ((-16.0/5.0))*(-z_17 - z_19);
    const real z_9 = shared[5];
    Mdot3[0][1] = Mdot3[1][0] = ((-8.0/5.0))*(c_0*(z_5*(p_1_dot*p_2) + p_2_dot*z_9 - 4.0*z_16*(p_1*p_2)));
    const real z_1 = shared[6];
    const real z_20 = c_0*(p_1_dot*z_9 - 2.0*z_1*z_16);
    Mdot3[1][1] = ((-16.0/5.0))*(z_18 - z_17 - z_20);
    Mdot3[0][2] = Mdot3[2][0] = ((-8.0/5.0))*(c_0*(z_5*(p_1_dot*p_3) + p_3_dot*z_9 - 4.0*z_16*(p_1*p_3)));
    const real z_12 = shared[7];
    Mdot3[1][2] = Mdot3[2][1] = ((-8.0/5.0))*(c_0*(z_5*(p_2_dot*p_3) + z_5*(p_3_dot*p_2) - 4.0*z_16*z_12));
    Mdot3[2][2] = ((-16.0/5.0))*(-z_20 - z_19);
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

enum { N_PIVOTS = 3 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M3[N3][N3], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], b[N_ROWS], shared[8];
    settled_masses(y, c, M3, A1, A2, A3, b, shared);
    em_pivots(N3, M3[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0] };
    em_velocity_of_eta(N1, c + 4, c + 5, v1);
    v[0] = v1[0];
    real v2[N2] = { e[1] };
    em_velocity_of_eta(N2, c + 8, c + 9, v2);
    v[1] = v2[0];
    real v3[N3] = { e[2], e[3], e[4] };
    if (mode) em_backward(N3, memory + 0, memory + 9, v3);
    else em_velocity_of_eta(N3, y + 10, y + 19, v3);
    v[2] = v3[0];
    v[3] = v3[1];
    v[4] = v3[2];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s, constraints on velocities.
 * *done becomes 0 in lanes that are settled number by number instead, as where the mode changes;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M3[N3][N3], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], b[N_ROWS], shared[8];
    settled_masses(y, c, M3, A1, A2, A3, b, shared);
    real eta3[N3] = { y[7], y[8], y[9] };
    *done &= em_refresh(N3, M3[0], y + 10, y + 19, mode ? NULL : eta3);
    y[7] = eta3[0];
    y[8] = eta3[1];
    y[9] = eta3[2];
    if (mode) em_cholesky(N3, M3[0], memory + 0, memory + 9, EM_SINGULAR_PIVOT);

    real gap = em_gap(N3, y + 19);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot3[N3][N3];
        settled_rates(y, dy, c, shared, Mdot3);
        real time = em_time_on_lanes(N3, y + 10, y + 19, Mdot3[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};

    real B1[N_ROWS][N1];
    em_rows_of_factors(N_ROWS, N1, c + 4, c + 5, A1[0], B1[0]);
    real a1[N1] = { y[5] };
    real B2[N_ROWS][N2];
    em_rows_of_factors(N_ROWS, N2, c + 8, c + 9, A2[0], B2[0]);
    real a2[N2] = { y[6] };
    real B3[N_ROWS][N3];
    if (mode) em_rows_of_root(N_ROWS, N3, memory + 0, memory + 9, A3[0], B3[0]);
    else em_rows_of_factors(N_ROWS, N3, y + 10, y + 19, A3[0], B3[0]);
    real a3[N3] = { y[7], y[8], y[9] };

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
    y[5] = a1[0];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    y[6] = a2[0];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    y[7] = a3[0];
    y[8] = a3[1];
    y[9] = a3[2];
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes sphere_lanes;
em_lanes sphere_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double c_3 = c[15];
    bias[0] = c_3;
    bias[1] = 0.0;
    const double c_0 = c[12];
    const double p_1 = x[2];
    const double p_2 = x[3];
    const double p_3 = x[4];
    const double z_0 = 1.0 + p_1*p_1 + p_2*p_2 + p_3*p_3;
    const double z_1 = z_0*z_0;
    const double z_2 = 1.0/z_1;
    const double z_3 = c_0*z_2;
    const double p_2_dot = v[3];
    const double p_3_dot = v[4];
    const double p_1_dot = v[2];
    const double z_4 = p_3_dot + p_2_dot*p_1 - p_1_dot*p_2;
    const double z_5 = p_2_dot*z_4;
    const double z_6 = p_2_dot + p_1_dot*p_3 - p_3_dot*p_1;
    const double z_7 = p_3_dot*z_6;
    const double z_8 = 1.0/(z_0*z_1);
    const double z_9 = p_1_dot + p_3_dot*p_2 - p_2_dot*p_3;
    const double z_10 = c_0*(z_8*(z_4*z_4) + z_8*(z_6*z_6) + z_8*(z_9*z_9));
    const double z_11 = p_1_dot*p_1 + p_2_dot*p_2 + p_3_dot*p_3;
    const double z_12 = z_11*z_8;
    const double z_13 = z_4*z_12;
    const double z_14 = z_6*z_12;
    const double c_5 = c[17];
    const double z_15 = z_9*z_12;
    bias[2] = (8.0/5.0)*((z_3*z_5 - z_3*z_7 - 2.0*p_1*z_10) + (c_0*(z_2*z_5 - 4.0*p_2*z_13) + c_5*z_15 -
        c_0*(z_2*z_7 - 4.0*p_3*z_14)));
    const double z_16 = p_1_dot*z_4;
    const double z_17 = p_3_dot*z_9;
    bias[3] = ((-8.0/5.0))*((z_3*z_16 + 2.0*p_2*z_10 - z_3*z_17) - (c_0*(z_2*z_17 - 4.0*p_3*z_15) + c_5*z_14 -
        c_0*(z_2*z_16 - 4.0*p_1*z_13)));
    const double z_18 = p_1_dot*z_6;
    const double z_19 = p_2_dot*z_9;
    bias[4] = (8.0/5.0)*((z_3*z_18 - z_3*z_19 - 2.0*p_3*z_10) + (c_0*(z_2*z_18 - 4.0*p_1*z_14) + c_5*z_13 -
        c_0*(z_2*z_19 - 4.0*p_2*z_15)));
    const double R = c[1];
    const double z_20 = 1.0/z_0;
    const double z_21 = z_11*z_2;
    const double z_22 = R*(p_3_dot*z_20 - 2.0*p_3*z_21);
    const double c_4 = c[16];
    const double z_23 = c_4*z_21;
    gamma[0] = (-2.0)*(p_1_dot*z_22 - p_3_dot*(R*(p_1_dot*z_20 - 2.0*p_1*z_21)) - p_2_dot*z_23);
    gamma[1] = (-2.0)*(p_2_dot*z_22 + p_1_dot*z_23 - p_3_dot*(R*(p_2_dot*z_20 - 2.0*p_2*z_21)));
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double p_1_dot = v[2];
    const double c_0 = c[12];
    const double p_3 = x[4];
    const double z_0 = p_3*p_3;
    const double p_1 = x[2];
    const double z_1 = p_1*p_1;
    const double p_2 = x[3];
    const double z_2 = p_2*p_2;
    const double z_3 = 1.0 + z_1 + z_2 + z_0;
    const double z_4 = 1.0/(z_3*z_3);
    const double z_5 = z_0*z_4;
    const double z_6 = z_4;
    const double z_7 = z_6 + z_2*z_4;
    const double z_8 = c_0*z_4;
    const double z_9 = p_1*z_8;
    const double p_2_dot = v[3];
    const double z_10 = p_2_dot*p_2;
    const double p_3_dot = v[4];
    const double z_11 = p_3_dot*p_3;
    const double z_12 = p_1_dot*z_9;
    const double z_13 = z_1*z_4;
    const double c_6 = c[18];
    const double x_dot = v[0];
    const double y_dot = v[1];
    e[0] = (1.0/10.0)*(8.0*p_1_dot*(p_1_dot*(c_0*(z_5 + z_7)) - z_9*z_10 - z_9*z_11) + c_6*(x_dot*x_dot) +
        c_6*(y_dot*y_dot) - 8.0*p_2_dot*(p_2*z_12 + p_2*z_8*z_11 - p_2_dot*(c_0*(z_6 + z_5 + z_13))) -
        8.0*p_3_dot*(p_3*z_12 + p_3*z_8*z_10 - p_3_dot*(c_0*(z_13 + z_7))));
    e[1] = 0.0;
    e[2] = 0.0;
    const double x_ = x[0];
    const double c_3 = c[15];
    e[3] = -x_*c_3;
}

/* out (n_outputs), from x, v, a = xddot, lambda */
EM_ACROSS void observe(double t, const double *restrict x, const double *restrict v, const double *restrict a,
                       const double *restrict lambda, const double *restrict c, const double *restrict u,
                       double *restrict out)
{
}

/* y (n) = P(x, t) v: the quasi-velocities                                                                       (3) */
EM_ACROSS void quasi(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                     double *restrict y)
{
    const double x_dot = v[0];
    y[0] = x_dot;
    const double y_dot = v[1];
    y[1] = y_dot;
    const double p_1_dot = v[2];
    const double p_3_dot = v[4];
    const double p_2 = x[3];
    const double p_2_dot = v[3];
    const double p_3 = x[4];
    const double p_1 = x[2];
    const double z_0 = 1.0/(1.0 + p_1*p_1 + p_2*p_2 + p_3*p_3);
    y[2] = 2.0*((p_1_dot + p_3_dot*p_2 - p_2_dot*p_3)*z_0);
    y[3] = 2.0*((p_2_dot + p_1_dot*p_3 - p_3_dot*p_1)*z_0);
    y[4] = 2.0*((p_3_dot + p_2_dot*p_1 - p_1_dot*p_2)*z_0);
}

/* p: what the drawing is made of, shape by shape */
EM_ACROSS void draw(double t, const double *restrict x, const double *restrict c, double *restrict p)
{
    const double x_ = x[0];
    const double c_7 = c[19];
    const double z_0 = x_*c_7;
    p[0] = z_0;
    const double y = x[1];
    p[1] = p[16] = p[20] = p[27] = p[34] = y;
    const double c_8 = c[20];
    const double z_1 = x_*c_8;
    p[2] = -z_1;
    const double c_9 = c[21];
    p[3] = p[12] = c_9;
    const double c_10 = c[22];
    p[4] = p[7] = c_10;
    const double c_11 = c[23];
    p[5] = p[14] = c_11;
    const double c_12 = c[24];
    p[6] = p[9] = c_12;
    const double c_13 = c[25];
    p[8] = p[11] = c_13;
    const double c_14 = c[26];
    p[10] = p[13] = c_14;
    const double c_15 = c[27];
    p[15] = p[19] = p[26] = p[33] = z_0 + c_15;
    const double c_16 = c[28];
    p[17] = p[21] = p[28] = p[35] = -(z_1 - c_16);
    const double R = c[1];
    p[18] = p[22] = p[29] = p[36] = R;
    const double p_2 = x[3];
    const double z_2 = p_2*p_2;
    const double p_3 = x[4];
    const double z_3 = p_3*p_3;
    const double p_1 = x[2];
    const double z_4 = p_1*p_1;
    const double z_5 = z_4 + z_2;
    const double z_6 = 1.0/(1.0 + z_3 + z_5);
    const double z_7 = 1.0 - 2.0*(z_2 + z_3)*z_6;
    const double c_17 = c[29];
    const double z_8 = p_1*p_3;
    const double z_9 = (p_2 - z_8)*z_6;
    p[23] = c_7*z_7 - c_17*z_9;
    const double z_10 = p_1*p_2;
    p[24] = 2.0*((p_3 + z_10)*z_6);
    const double c_18 = c[30];
    p[25] = -(c_8*z_7 + c_18*z_9);
    const double z_11 = p_3 - z_10;
    const double z_12 = c_7*z_6;
    const double z_13 = p_2*p_3;
    const double z_14 = p_1 + z_13;
    const double z_15 = c_8*z_6;
    p[30] = (-2.0)*(z_11*z_12 - z_14*z_15);
    p[31] = 1.0 - 2.0*(z_4 + z_3)*z_6;
    p[32] = 2.0*(z_14*z_12 + z_11*z_15);
    const double z_16 = 1.0 - 2.0*z_5*z_6;
    const double z_17 = (p_2 + z_8)*z_6;
    p[37] = c_8*z_16 + c_18*z_17;
    p[38] = (-2.0)*((p_1 - z_13)*z_6);
    p[39] = c_7*z_16 - c_17*z_17;
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
    const double p_1 = x[2];
    const double z_0 = p_1*p_1;
    const double p_2 = x[3];
    const double z_1 = p_2*p_2;
    const double p_3 = x[4];
    const double z_2 = p_3*p_3;
    const double z_3 = 1.0 + z_0 + z_1 + z_2;
    const double z_4 = z_3*z_3;
    const double m = c[0];
    const double R = c[1];
    const double z_5 = m*(R*R);
    const double z_6 = z_5/(z_3*z_4);
    const double z_7 = p_1*z_6;
    const double z_8 = z_7*z_2;
    const double z_9 = z_7*z_1;
    const double z_10 = z_7 + z_9;
    dM[62] = ((-32.0/5.0))*(z_8 + z_10);
    const double z_11 = z_5/z_4;
    const double z_12 = p_2*z_11;
    const double z_13 = p_2*z_6;
    const double z_14 = z_13*z_0;
    dM[67] = dM[63] = ((-8.0/5.0))*(z_12 - 4.0*z_14);
    const double z_15 = p_1*z_11;
    const double z_16 = z_15 - 2.0*z_7*z_0;
    dM[68] = ((-16.0/5.0))*(2.0*z_7 + 2.0*z_8 - z_16);
    const double z_17 = p_3*z_11;
    const double z_18 = p_3*z_6;
    const double z_19 = z_18*z_0;
    dM[72] = dM[64] = ((-8.0/5.0))*(z_17 - 4.0*z_19);
    dM[73] = dM[69] = (32.0/5.0)*(p_2*p_3*z_7);
    dM[74] = ((-16.0/5.0))*(2.0*z_10 - z_16);
    const double z_20 = z_12 - 2.0*z_13*z_1;
    const double z_21 = z_13*z_2;
    dM[87] = ((-16.0/5.0))*(2.0*z_13 + 2.0*z_21 - z_20);
    dM[92] = dM[88] = ((-8.0/5.0))*(z_15 - 4.0*z_9);
    const double z_22 = z_14 + z_13;
    dM[93] = ((-32.0/5.0))*(z_21 + z_22);
    dM[97] = dM[89] = (32.0/5.0)*(p_2*p_3*z_7);
    const double z_23 = z_18*z_1;
    dM[98] = dM[94] = ((-8.0/5.0))*(z_17 - 4.0*z_23);
    dM[99] = ((-16.0/5.0))*(2.0*z_22 - z_20);
    const double z_24 = z_17 - 2.0*z_18*z_2;
    dM[112] = ((-16.0/5.0))*(2.0*z_23 + 2.0*z_18 - z_24);
    dM[117] = dM[113] = (32.0/5.0)*(p_2*p_3*z_7);
    const double z_25 = z_19 + z_18;
    dM[118] = ((-16.0/5.0))*(2.0*z_25 - z_24);
    dM[122] = dM[114] = ((-8.0/5.0))*(z_15 - 4.0*z_8);
    dM[123] = dM[119] = ((-8.0/5.0))*(z_12 - 4.0*z_21);
    dM[124] = ((-32.0/5.0))*(z_23 + z_25);
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double p_2_ddot = a[3];
    const double p_2 = x[3];
    const double p_1 = x[2];
    const double z_0 = p_1*p_1;
    const double z_1 = p_2*p_2;
    const double p_3 = x[4];
    const double z_2 = p_3*p_3;
    const double z_3 = 1.0 + z_0 + z_1 + z_2;
    const double z_4 = z_3*z_3;
    const double z_5 = 1.0/z_4;
    const double m = c[0];
    const double R = c[1];
    const double z_6 = m*(R*R);
    const double z_7 = z_5*z_6;
    const double z_8 = p_2*z_7;
    const double z_9 = p_2_ddot*z_8;
    const double p_1_dot = v[2];
    const double p_3_dot = v[4];
    const double z_10 = p_3_dot*p_2;
    const double p_2_dot = v[3];
    const double z_11 = p_2_dot*p_3;
    const double z_12 = p_1_dot + z_10 - z_11;
    const double z_13 = 1.0/(z_3*z_4);
    const double z_14 = z_13*z_6;
    const double z_15 = z_12*z_14;
    const double z_16 = p_3_dot + p_2_dot*p_1 - p_1_dot*p_2;
    const double z_17 = p_2*z_14;
    const double z_18 = z_16*z_17;
    const double z_19 = p_1_dot*p_3;
    const double z_20 = p_3_dot*p_1;
    const double z_21 = p_2_dot + z_19 - z_20;
    const double z_22 = z_21*z_14;
    const double z_23 = p_3*z_22;
    const double z_24 = z_15 + z_23 - z_18;
    const double z_25 = p_1*z_14;
    const double z_26 = z_16*z_25;
    const double z_27 = p_1_dot*p_1 + p_2_dot*p_2 + p_3_dot*p_3;
    const double z_28 = z_27*z_17 - 0.5*p_2_dot*z_7;
    const double z_29 = 2.0*z_26 + 2.0*z_28;
    const double z_30 = z_21*z_25;
    const double z_31 = z_27*z_14;
    const double z_32 = p_3*z_31 - 0.5*p_3_dot*z_7;
    const double z_33 = 2.0*z_30 - 2.0*z_32;
    const double lambda_1 = lambda[1];
    const double z_34 = R*z_5;
    const double lambda_0 = lambda[0];
    const double z_35 = p_3*z_34;
    const double p_3_ddot = a[4];
    const double z_36 = p_3*p_3_ddot;
    const double z_37 = p_2*z_25;
    const double z_38 = z_6/(z_4*z_4);
    const double z_39 = z_27*z_38;
    const double z_40 = z_21*z_39;
    const double z_41 = z_16*z_39;
    const double z_42 = z_12*z_39;
    const double z_43 = z_12*z_12;
    const double z_44 = p_1*z_38;
    const double z_45 = z_21*z_21;
    const double z_46 = z_16*z_14;
    const double z_47 = z_16*z_16;
    const double p_1_ddot = a[2];
    const double z_48 = p_1_ddot*z_14;
    const double z_49 = 5.0*lambda_1*z_34 + 48.0*p_2*z_41 + 24.0*z_43*z_44 + 16.0*p_3_dot*z_22 + 24.0*z_45*z_44 +
        24.0*z_47*z_44 + 8.0*z_48*z_2 + 8.0*z_48*z_1 + 8.0*z_48 - 5.0*lambda_0*z_35 - 8.0*z_25*z_36 -
        8.0*p_2_ddot*z_37 - 48.0*p_3*z_40 - 48.0*z_42 - 16.0*p_2_dot*z_46;
    const double z_50 = z_47*z_14 + z_45*z_14 + z_43*z_14;
    const double z_51 = z_50 - 0.5*z_7*z_36;
    D[22] = (4.0/5.0)*(4.0*p_2_dot*z_29 + 4.0*z_51 - 2.0*z_9 - 8.0*p_1_dot*z_24 - 4.0*p_3_dot*z_33 - p_1*z_49);
    const double z_52 = z_27*z_46;
    const double z_53 = p_1*z_7;
    const double z_54 = p_2_ddot*z_53;
    const double z_55 = z_31 - z_12*z_25;
    const double z_56 = p_1_ddot*z_8;
    D[23] = (4.0/5.0)*(8.0*z_52 + 4.0*z_56 - 2.0*z_54 - 8.0*p_2_dot*z_24 - 4.0*p_1_dot*z_29 - 8.0*p_3_dot*z_55 -
        p_2*z_49);
    const double z_57 = p_3_ddot*z_53;
    const double z_58 = p_3*p_1_ddot;
    const double z_59 = z_7*z_58;
    const double z_60 = R/z_3;
    const double z_61 = z_27*z_22 + 0.3125*lambda_0*z_60;
    D[24] = ((-2.0/5.0))*(4.0*z_57 + 16.0*p_3_dot*z_24 + 2.0*p_3*z_49 + 16.0*z_61 - 8.0*p_1_dot*z_33 -
        16.0*p_2_dot*z_55 - 8.0*z_59);
    D[27] = ((-16.0/5.0))*(2.0*p_1*z_24 + p_2*z_29 + 2.0*z_55 - p_3*z_33);
    const double z_62 = z_16*z_7;
    D[28] = ((-16.0/5.0))*(z_62 + 2.0*p_2*z_24 - p_1*z_29 - z_33 - 2.0*p_3*z_55);
    const double z_63 = z_21*z_7;
    D[29] = (16.0/5.0)*(z_63 + z_29 - 2.0*p_3*z_24 - p_1*z_33 - 2.0*p_2*z_55);
    const double z_64 = p_3*z_15;
    const double z_65 = z_22 + z_26 - z_64;
    const double z_66 = z_27*z_25 - 0.5*p_1_dot*z_7;
    const double z_67 = 2.0*z_18 - 2.0*z_66;
    const double z_68 = z_31 - z_21*z_17;
    const double z_69 = p_2*z_38;
    const double z_70 = p_2_ddot*z_14;
    const double z_71 = 5.0*lambda_1*z_35 + 5.0*lambda_0*z_34 + 8.0*z_17*z_36 + 8.0*p_1_ddot*z_37 + 48.0*p_1*z_41
        + 48.0*z_40 + 16.0*p_3_dot*z_15 - 48.0*p_3*z_42 - 24.0*z_43*z_69 - 24.0*z_45*z_69 - 16.0*p_1_dot*z_46 -
        24.0*z_47*z_69 - 8.0*z_70*z_0 - 8.0*z_70*z_2 - 8.0*z_70;
    D[32] = ((-4.0/5.0))*(8.0*z_52 + 2.0*z_56 + 8.0*p_1_dot*z_65 - 4.0*z_54 - 4.0*p_2_dot*z_67 - 8.0*p_3_dot*z_68
        - p_1*z_71);
    const double z_72 = p_1_ddot*z_53;
    const double z_73 = z_12*z_17;
    const double z_74 = 2.0*z_73 + 2.0*z_32;
    D[33] = (4.0/5.0)*(4.0*p_3_dot*z_74 + p_2*z_71 + 4.0*z_51 - 2.0*z_72 - 8.0*p_2_dot*z_65 - 4.0*p_1_dot*z_67);
    const double z_75 = p_3_ddot*z_8;
    const double z_76 = p_3*p_2_ddot;
    const double z_77 = z_7*z_76;
    const double z_78 = z_27*z_15 - 0.3125*lambda_1*z_60;
    D[34] = (2.0/5.0)*(8.0*z_77 + 2.0*p_3*z_71 + 16.0*z_78 - 4.0*z_75 - 16.0*p_3_dot*z_65 - 16.0*p_1_dot*z_68 -
        8.0*p_2_dot*z_74);
    D[37] = (16.0/5.0)*(z_62 + z_74 - 2.0*p_1*z_65 - p_2*z_67 - 2.0*p_3*z_68);
    D[38] = ((-16.0/5.0))*(2.0*p_2*z_65 + 2.0*z_68 + p_3*z_74 - p_1*z_67);
    const double z_79 = z_12*z_7;
    D[39] = ((-16.0/5.0))*(z_79 + 2.0*p_3*z_65 - z_67 - 2.0*p_1*z_68 - p_2*z_74);
    const double z_80 = z_46 + z_73 - z_30;
    const double z_81 = z_31 - p_3*z_46;
    const double z_82 = 2.0*z_23 + 2.0*z_66;
    const double z_83 = p_2*z_34;
    const double z_84 = p_1*z_34;
    const double z_85 = p_3*z_38;
    const double z_86 = p_3_ddot*z_14;
    const double z_87 = 5.0*lambda_1*z_83 + 5.0*lambda_0*z_84 + 48.0*p_1*z_40 + 16.0*p_2_dot*z_15 + 24.0*z_43*z_85
        + 24.0*z_45*z_85 + 24.0*z_47*z_85 + 8.0*z_86*z_0 + 8.0*z_86*z_1 + 8.0*z_86 - 8.0*z_17*z_76 - 8.0*z_25*z_58
        - 48.0*p_2*z_42 - 48.0*z_41 - 16.0*p_1_dot*z_22;
    D[42] = (2.0/5.0)*(8.0*z_57 + 16.0*z_61 - 4.0*z_59 - 16.0*p_1_dot*z_80 - 16.0*p_2_dot*z_81 - 8.0*p_3_dot*z_82
        - 2.0*p_1*z_87);
    const double z_88 = 2.0*z_64 - 2.0*z_28;
    D[43] = ((-2.0/5.0))*(4.0*z_77 + 16.0*p_2_dot*z_80 + 2.0*p_2*z_87 + 16.0*z_78 - 8.0*z_75 - 16.0*p_1_dot*z_81 -
        8.0*p_3_dot*z_88);
    D[44] = (4.0/5.0)*(4.0*z_50 + 4.0*p_1_dot*z_82 - 2.0*z_9 - 2.0*z_72 - 8.0*p_3_dot*z_80 - 4.0*p_2_dot*z_88 -
        p_3*z_87);
    D[47] = ((-16.0/5.0))*(z_63 + 2.0*p_1*z_80 - 2.0*p_2*z_81 - p_3*z_82 - z_88);
    D[48] = (16.0/5.0)*(z_79 + z_82 - 2.0*p_2*z_80 - 2.0*p_1*z_81 - p_3*z_88);
    D[49] = ((-16.0/5.0))*(2.0*p_3*z_80 + 2.0*z_81 + p_1*z_82 - p_2*z_88);
    const double z_89 = p_2_dot*z_34 + p_1_dot*z_35 - z_20*z_34;
    const double z_90 = z_13*(R*z_27);
    const double z_91 = p_3_ddot*z_84 + 4.0*p_2_dot*z_90 + 4.0*z_19*z_90 - p_2_ddot*z_34 - p_1_ddot*z_35 -
        4.0*z_20*z_90;
    const double z_92 = z_27*z_34;
    const double z_93 = p_3_ddot*z_60 - 2.0*p_3_dot*z_92;
    D[52] = 2.0*(2.0*p_1_dot*z_89 + z_93 - 2.0*p_1*z_91);
    D[53] = 4.0*(p_2_dot*z_89 - p_2*z_91);
    D[54] = 2.0*(2.0*p_1_dot*z_92 + 2.0*p_3_dot*z_89 - p_1_ddot*z_60 - 2.0*p_3*z_91);
    const double z_94 = p_3_dot*z_60;
    const double z_95 = z_94 - (z_94 - 2.0*z_27*z_35);
    D[57] = 2.0*(2.0*p_1*z_89 + z_95);
    D[58] = 4.0*(z_92 + p_2*z_89);
    const double z_96 = p_1_dot*z_60;
    D[59] = (-2.0)*(z_96 - (z_96 - 2.0*p_1*z_92) - 2.0*p_3*z_89);
    const double z_97 = p_1_dot*z_34 + z_10*z_34 - p_2_dot*z_35;
    const double z_98 = p_3_ddot*z_83 + p_1_ddot*z_34 + 4.0*z_11*z_90 - p_2_ddot*z_35 - 4.0*p_1_dot*z_90 -
        4.0*z_10*z_90;
    D[62] = (-4.0)*(p_1_dot*z_97 + p_1*z_98);
    D[63] = 2.0*(z_93 - 2.0*p_2_dot*z_97 - 2.0*p_2*z_98);
    D[64] = 2.0*(2.0*p_2_dot*z_92 - p_2_ddot*z_60 - 2.0*p_3_dot*z_97 - 2.0*p_3*z_98);
    D[67] = (-4.0)*(z_92 + p_1*z_97);
    D[68] = 2.0*(z_95 - 2.0*p_2*z_97);
    const double z_99 = p_2_dot*z_60;
    D[69] = (-2.0)*(z_99 + 2.0*p_3*z_97 - (z_99 - 2.0*p_2*z_92));
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double x_ddot = a[0];
    const double g = c[2];
    const double alpha = c[3];
    const double sin_alpha = em_sin(alpha);
    D[0] = x_ddot - g*sin_alpha;
    const double m = c[0];
    D[2] = -m*sin_alpha;
    const double cos_alpha = em_cos(alpha);
    D[3] = -m*g*cos_alpha;
    const double y_ddot = a[1];
    D[5] = y_ddot;
    const double R = c[1];
    const double z_2 = R*R;
    const double p_1 = x[2];
    const double z_3 = p_1*p_1;
    const double p_2 = x[3];
    const double z_4 = p_2*p_2;
    const double p_3 = x[4];
    const double z_5 = p_3*p_3;
    const double z_6 = 1.0 + z_3 + z_4 + z_5;
    const double z_7 = z_6*z_6;
    const double z_8 = 1.0/z_7;
    const double z_9 = z_2*z_8;
    const double p_3_dot = v[4];
    const double p_2_dot = v[3];
    const double p_1_dot = v[2];
    const double z_10 = p_2_dot + p_1_dot*p_3 - p_3_dot*p_1;
    const double z_11 = p_3_dot*z_10;
    const double z_12 = z_9*z_11;
    const double z_13 = p_3_dot + p_2_dot*p_1 - p_1_dot*p_2;
    const double z_14 = p_2_dot*z_13;
    const double z_15 = z_9*z_14;
    const double z_16 = p_1_dot + p_3_dot*p_2 - p_2_dot*p_3;
    const double z_17 = z_16*z_16;
    const double z_18 = 1.0/(z_6*z_7);
    const double z_19 = z_2*z_18;
    const double z_20 = z_10*z_10;
    const double z_21 = z_13*z_13;
    const double z_22 = z_17*z_19 + z_20*z_19 + z_21*z_19;
    const double z_23 = p_1_dot*p_1 + p_2_dot*p_2 + p_3_dot*p_3;
    const double z_24 = z_23*z_18;
    const double z_25 = z_2*z_24;
    const double z_26 = z_16*z_25;
    const double z_27 = z_13*z_25;
    const double z_28 = z_10*z_25;
    const double z_29 = p_1*p_3;
    const double p_3_ddot = a[4];
    const double z_30 = p_3_ddot*z_9;
    const double z_31 = p_1*p_2;
    const double p_2_ddot = a[3];
    const double z_32 = p_2_ddot*z_9;
    const double p_1_ddot = a[2];
    const double z_33 = z_9*z_4;
    const double z_34 = z_9*z_5 + z_9;
    D[10] = (8.0/5.0)*(((z_12 + 2.0*p_1*z_22 - z_15) - (4.0*z_26 + (4.0*p_3*z_28 - z_12) - (4.0*p_2*z_27 - z_15)))
        - (z_29*z_30 + z_31*z_32 - p_1_ddot*(z_33 + z_34)));
    const double z_35 = m*R;
    const double z_36 = z_8*z_35;
    const double z_37 = z_36*z_11;
    const double z_38 = z_36*z_14;
    const double z_39 = z_18*z_35;
    const double z_40 = z_17*z_39 + z_20*z_39 + z_21*z_39;
    const double z_41 = z_35*z_24;
    const double z_42 = z_16*z_41;
    const double z_43 = z_13*z_41;
    const double z_44 = z_10*z_41;
    const double z_45 = p_3_ddot*z_36;
    const double z_46 = p_2_ddot*z_36;
    const double z_47 = z_36*z_4;
    const double z_48 = z_36*z_5 + z_36;
    const double lambda_0 = lambda[0];
    const double z_49 = 1.0/z_6;
    const double z_50 = p_3*z_49;
    const double lambda_1 = lambda[1];
    D[11] = (2.0/5.0)*(8.0*((z_37 + 2.0*p_1*z_40 - z_38) - (4.0*z_42 + (4.0*p_3*z_44 - z_37) - (4.0*p_2*z_43 -
        z_38))) - 8.0*(z_29*z_45 + z_31*z_46 - p_1_ddot*(z_47 + z_48)) - 5.0*(lambda_0*z_50 - lambda_1*z_49));
    const double z_51 = p_3_dot*z_16;
    const double z_52 = z_9*z_51;
    const double z_53 = p_1_dot*z_13;
    const double z_54 = z_9*z_53;
    const double z_55 = p_2*p_3;
    const double z_56 = p_1_ddot*z_9;
    const double z_57 = z_9*z_3;
    D[15] = ((-8.0/5.0))*(((z_52 - z_54 - 2.0*p_2*z_22) + (4.0*z_28 + (4.0*p_1*z_27 - z_54) - (4.0*p_3*z_26 -
        z_52))) + (z_55*z_30 + z_31*z_56 - p_2_ddot*(z_57 + z_34)));
    const double z_58 = z_36*z_51;
    const double z_59 = z_36*z_53;
    const double z_60 = p_1_ddot*z_36;
    const double z_61 = z_36*z_3;
    D[16] = ((-2.0/5.0))*(8.0*((z_58 - z_59 - 2.0*p_2*z_40) + (4.0*z_44 + (4.0*p_1*z_43 - z_59) - (4.0*p_3*z_42 -
        z_58))) + 8.0*(z_55*z_45 + z_31*z_60 - p_2_ddot*(z_61 + z_48)) + 5.0*(lambda_0*z_49 + lambda_1*z_50));
    const double z_62 = p_2_dot*z_16;
    const double z_63 = z_9*z_62;
    const double z_64 = p_1_dot*z_10;
    const double z_65 = z_9*z_64;
    D[20] = (8.0/5.0)*(((z_63 + 2.0*p_3*z_22 - z_65) - (4.0*z_27 + (4.0*p_2*z_26 - z_63) - (4.0*p_1*z_28 - z_65)))
        - (z_55*z_32 + z_29*z_56 - p_3_ddot*(z_33 + z_9 + z_57)));
    const double z_66 = z_36*z_62;
    const double z_67 = z_36*z_64;
    const double z_68 = p_1*z_49;
    const double z_69 = p_2*z_49;
    D[21] = (2.0/5.0)*(8.0*((z_66 + 2.0*p_3*z_40 - z_67) - (4.0*z_43 + (4.0*p_2*z_42 - z_66) - (4.0*p_1*z_44 -
        z_67))) + 5.0*(lambda_0*z_68 + lambda_1*z_69) - 8.0*(z_55*z_46 + z_29*z_60 - p_3_ddot*(z_47 + z_36 +
        z_61)));
    const double z_70 = z_23*z_8;
    const double z_71 = p_3_dot*z_49 - 2.0*p_3*z_70;
    D[26] = 2.0*((2.0*p_2_dot*z_70 + p_3_dot*(p_1_dot*z_49 - 2.0*p_1*z_70) - p_1_dot*z_71) - (p_1_ddot*z_50 +
        p_2_ddot*z_49 - p_3_ddot*z_68));
    D[31] = (-2.0)*((2.0*p_1_dot*z_70 + p_2_dot*z_71 - p_3_dot*(p_2_dot*z_49 - 2.0*p_2*z_70)) - (p_1_ddot*z_49 +
        p_3_ddot*z_69 - p_2_ddot*z_50));
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double p_3_dot = v[4];
    const double R = c[1];
    const double p_1 = x[2];
    const double p_2 = x[3];
    const double p_3 = x[4];
    const double z_0 = 1.0 + p_1*p_1 + p_2*p_2 + p_3*p_3;
    const double z_1 = 1.0/z_0;
    const double z_2 = R*z_1;
    const double z_3 = p_3_dot*z_2;
    const double p_2_dot = v[3];
    const double z_4 = R/(z_0*z_0);
    const double z_5 = p_3_dot*p_1;
    const double p_1_dot = v[2];
    const double z_6 = p_1_dot*p_3;
    const double z_7 = p_2_dot*z_4 + z_4*z_6 - z_4*z_5;
    D[2] = 2.0*(z_3 + 2.0*p_1*z_7);
    D[3] = 4.0*(p_2*z_7);
    D[4] = (-2.0)*(p_1_dot*z_2 - 2.0*p_3*z_7);
    D[5] = 1.0;
    D[7] = (-2.0)*(p_3*z_2);
    D[8] = (-2.0)*z_2;
    D[9] = 2.0*(p_1*z_2);
    D[11] = (-2.0)*(p_2_dot*z_1 + z_1*z_6 - z_1*z_5);
    const double z_8 = p_3_dot*p_2;
    const double z_9 = p_2_dot*p_3;
    const double z_10 = p_1_dot*z_4 + z_4*z_8 - z_4*z_9;
    D[17] = (-4.0)*(p_1*z_10);
    D[18] = 2.0*(z_3 - 2.0*p_2*z_10);
    D[19] = (-2.0)*(p_2_dot*z_2 + 2.0*p_3*z_10);
    D[21] = 1.0;
    D[22] = 2.0*z_2;
    D[23] = (-2.0)*(p_3*z_2);
    D[24] = 2.0*(p_2*z_2);
    D[26] = 2.0*(p_1_dot*z_1 + z_1*z_8 - z_1*z_9);
}

/* D (n, n_arguments), of P(x, t) v */
EM_RARE /* no explicit step calls it */
EM_ACROSS void quasi_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * N * N_ARGUMENTS);
    D[5] = 1.0;
    D[21] = 1.0;
    const double p_1_dot = v[2];
    const double p_3_dot = v[4];
    const double p_2 = x[3];
    const double p_2_dot = v[3];
    const double p_3 = x[4];
    const double z_0 = p_1_dot + p_3_dot*p_2 - p_2_dot*p_3;
    const double p_1 = x[2];
    const double z_1 = 1.0 + p_1*p_1 + p_2*p_2 + p_3*p_3;
    const double z_2 = 1.0/(z_1*z_1);
    const double z_3 = p_1*z_2;
    D[32] = (-4.0)*(z_0*z_3);
    const double z_4 = 1.0/z_1;
    const double z_5 = p_3_dot*z_4;
    const double z_6 = p_2*z_2;
    D[33] = 2.0*(z_5 - 2.0*z_0*z_6);
    const double z_7 = p_2_dot*z_4;
    const double z_8 = p_3*z_2;
    D[34] = (-2.0)*(z_7 + 2.0*z_0*z_8);
    D[37] = 2.0*(z_4);
    const double z_9 = p_3*z_4;
    D[38] = (-2.0)*z_9;
    const double z_10 = p_2*z_4;
    D[39] = 2.0*z_10;
    const double z_11 = p_2_dot + p_1_dot*p_3 - p_3_dot*p_1;
    D[47] = (-2.0)*(z_5 + 2.0*z_11*z_3);
    D[48] = (-4.0)*(z_11*z_6);
    const double z_12 = p_1_dot*z_4;
    D[49] = 2.0*(z_12 - 2.0*z_11*z_8);
    D[52] = 2.0*z_9;
    D[53] = 2.0*(z_4);
    const double z_13 = p_1*z_4;
    D[54] = (-2.0)*z_13;
    const double z_14 = p_3_dot + p_2_dot*p_1 - p_1_dot*p_2;
    D[62] = 2.0*(z_7 - 2.0*z_14*z_3);
    D[63] = (-2.0)*(z_12 + 2.0*z_14*z_6);
    D[64] = (-4.0)*(z_14*z_8);
    D[67] = (-2.0)*z_10;
    D[68] = 2.0*z_13;
    D[69] = 2.0*(z_4);
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes sphere_lanes;
EM_WEAK em_lanes sphere_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 1, 2, 2, 2 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_PREPARED_FACTORS, 4, 5, 6, 7 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 8, 9, 10, 11 };
static const em_block block3 = { N, N3, coordinate3, scales, EM_IN_STATE, 10, 19, 0, 9 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, &block3, NULL };

/* M of the constant blocks, and what other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double M1[N1][N1], double M2[N2][N2],
                                  double prepared[N_PREPARED])
{
    const double m = parameters[0];
    M1[0][0] = m;
    M2[0][0] = m;
    const double R = parameters[1];
    const double z_0 = m*(R*R);
    prepared[12] = z_0; /* c_0 */
    prepared[13] = (8.0/5.0)*z_0; /* c_1 */
    prepared[14] = 2.0*z_0; /* c_2 */
    const double g = parameters[2];
    const double alpha = parameters[3];
    const double sin_alpha = em_sin(alpha);
    prepared[15] = m*g*sin_alpha; /* c_3 */
    prepared[16] = 2.0*R; /* c_4 */
    prepared[17] = 4.0*z_0; /* c_5 */
    prepared[18] = 5.0*m; /* c_6 */
    const double cos_alpha = em_cos(alpha);
    prepared[19] = cos_alpha; /* c_7 */
    prepared[20] = sin_alpha; /* c_8 */
    const double z_3 = R*cos_alpha;
    prepared[21] = (-4.0)*z_3; /* c_9 */
    prepared[22] = (-4.0)*R; /* c_10 */
    const double z_4 = R*sin_alpha;
    prepared[23] = 4.0*z_4; /* c_11 */
    prepared[24] = 24.0*z_3; /* c_12 */
    prepared[25] = (-24.0)*z_4; /* c_13 */
    prepared[26] = 12.0*R; /* c_14 */
    prepared[27] = z_4; /* c_15 */
    prepared[28] = z_3; /* c_16 */
    prepared[29] = 2.0*sin_alpha; /* c_17 */
    prepared[30] = 2.0*cos_alpha; /* c_18 */
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
    {63, ""},
    {63, ""}
};

/* What depends on parameters only, once per parameter set: c (N_PREPARED). */
EM_ACROSS int prepare(const double *parameters, double *c, em_fault *fault)
{
    if (em_refuse(declared, 0, N_PARAMETERS, parameters, fault)) return -1;
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    double M1[N1][N1], M2[N2][N2];
    prepared_constants(parameters, M1, M2, c);
    if (em_prepare(&block1, M1[0], c, fault)) return -1;
    if (em_prepare(&block2, M2[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_ACROSS void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double m = c[0];
    M[0] = m;
    M[5] = M[1] = 0.0;
    M[6] = m;
    M[10] = M[2] = 0.0;
    M[11] = M[7] = 0.0;
    const double c_0 = c[12];
    const double p_3 = x[4];
    const double z_0 = p_3*p_3;
    const double p_1 = x[2];
    const double z_1 = p_1*p_1;
    const double p_2 = x[3];
    const double z_2 = p_2*p_2;
    const double z_3 = 1.0 + z_1 + z_2 + z_0;
    const double z_4 = 1.0/(z_3*z_3);
    const double z_5 = z_0*z_4;
    const double z_6 = z_4;
    const double z_7 = z_6 + z_2*z_4;
    M[12] = (8.0/5.0)*(c_0*(z_5 + z_7));
    M[15] = M[3] = 0.0;
    M[16] = M[8] = 0.0;
    const double c_1 = c[13];
    const double z_8 = c_1*z_4;
    M[17] = M[13] = -z_8*(p_1*p_2);
    const double z_9 = z_1*z_4;
    M[18] = (8.0/5.0)*(c_0*(z_6 + z_5 + z_9));
    M[20] = M[4] = 0.0;
    M[21] = M[9] = 0.0;
    M[22] = M[14] = -z_8*(p_1*p_3);
    M[23] = M[19] = -z_8*(p_2*p_3);
    M[24] = (8.0/5.0)*(c_0*(z_9 + z_7));
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
    A[0] = 1.0;
    A[1] = 0.0;
    const double p_3 = x[4];
    const double c_4 = c[16];
    const double p_1 = x[2];
    const double p_2 = x[3];
    const double z_0 = c_4/(1.0 + p_1*p_1 + p_2*p_2 + p_3*p_3);
    A[2] = -p_3*z_0;
    A[3] = -z_0;
    A[4] = p_1*z_0;
    A[5] = 0.0;
    A[6] = 1.0;
    A[7] = z_0;
    A[8] = -p_3*z_0;
    A[9] = p_2*z_0;
    b[0] = 0.0;
    b[1] = 0.0;
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
#include "em_tangent.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* After an accepted step, and at the start: C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    real M3[N3][N3], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], b[N_ROWS], shared[8];
    settled_masses(y, c, M3, A1, A2, A3, b, shared);
    if (changed && em_settle_factors(&block3, *mode, 0, M3[0], y, memory, fault)) return -1;

    double gap = em_gap(N3, y + 19);
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block2, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block3, *mode, y + N, y, c, memory, dy);
        real Mdot3[N3][N3];
        settled_rates(y, dy, c, shared, Mdot3);
        double time = em_time_of_block(&block3, Mdot3[0], y);
        wanted = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != wanted) {
        if (em_change_mode(&block3, wanted, M3[0], y, memory, fault)) return -1;
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
    em_publish_block(&block3, v, y, row);
    return 0;
}

/* y (n_state) from x, v (n); eigenfactors continuous with those y holds, if any */
EM_ACROSS int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    double C[N*N] = {0.0}, s[N], eta[N];
    em_spread(N, N3, coordinate3, y + 10, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N3, coordinate3, C, y + 10);
    for (int i = 0; i < N3; ++i) y[19 + i] = s[coordinate3[i]];
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
    if (em_coincident_block(&block3, y, fault)) return -1;
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "sphere.h"

static const char *const coordinate_names[] = { "x", "y", "p_1", "p_2", "p_3", NULL };
static const char *const parameter_names[] = { "m", "R", "g", "alpha", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 0.5, 9.81, 0.08726646259971647, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 0.0, 0.1, -0.2, 0.3 };
static const double initial_v[N] = { 0.3, 0.5, -0.375, 0.48, 0.255 };
static const int carried[N] = { 0, 0, 1, 1, 1 };
static const char *const quasi_velocity_names[] = { "vx", "vy", "omega_x", "omega_y", "omega_z", NULL };
static const double initial_y[N] = { 0.3, 0.5, -1.0, 0.6, 0.4 };
static const em_shape shapes[] = {
    {"trace", 0, 3},
    {"ground", 3, 12},
    {"disk", 15, 4},
    {"disk", 19, 7},
    {"disk", 26, 7},
    {"disk", 33, 7}
};
static const em_slice layout[] = {
    {"x", 0, 5},
    {"eta", 5, 5},
    {"C", 10, 9},
    {"s", 19, 3}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dx, dM/dy: M does not depend on them",
    "C, mu, Omega across blocks: {x}, {y}, {p_1, p_2, p_3} do not couple",
    "C, s, mu, Omega of {x}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {y}: this block is constant, factored once per parameter set",
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
static int simulate(em_run *run) { return em_simulate(&sphere_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&sphere_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&sphere_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&sphere_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&sphere_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&sphere_model, run, mode); }

const em_model sphere_model = {
    .abi = EM_ABI,
    .name = "sphere",
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
    .n_left_out = 9,
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
    .n_quasi = N,
    .quasi_velocities = quasi_velocity_names,
    .initial_y = initial_y,
    .quasi = quasi,
    .event = model_events,
    .lanes = &sphere_lanes,
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
    .n_shapes = 6,
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .constraint_partials = constraint_partials,
    .quasi_partials = quasi_partials,
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
