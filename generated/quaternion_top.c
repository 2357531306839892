/* eigenmotion generate quaternion_top.py */
/* input sha256:0cb8bde97f7a54b959afa6233ef8b22ba968fd2b37b477c410a8abc46e5c03d5 */
/* body sha256:2b97654e4e7d5b8996adcaba91b68ad400c82267d09db746f9fdb3615c4dd35c */
/* quaternion_top: equations of motion, eigenfactor formulation.
 *
 * State, 28 numbers:
 *   x    y[0 .. 4)
 *   eta  y[4 .. 8)
 *   C    y[8 .. 24)
 *   s    y[24 .. 28)
 *
 * Blocks of M that do not couple:
 *   1: q_0, q_1, q_2, q_3 (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   a factor of Delta: one constraint, Delta is a number
 *   b, bdot: the constraints are homogeneous in the velocities
 *   M^-1: M is singular; M + A^T W A is factored, with weights W of row 0
 *
 * Operations of the straight-line part:
 *   eigenfactor: 51 additions, 85 multiplications
 *   triangular root: 65 additions, 125 multiplications
 *   projection: 34 additions, 92 multiplications
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 4,                /* coordinates */
    N_ROWS = 1,           /* constraint rows */
    N_POSITIONS = 1,      /* of which holonomic */
    N_STATE = 28,         /* numbers of a state */
    N_C = 16,             /* of which C, */
    N_S = 4,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 20,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 5,
    N_PREPARED = 19,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 6,          /* inputs, parameters and the time */
    N_ARGUMENTS = 14,     /* x, v and these: what motion depends on */
    N1 = 4,               /* q_0, q_1, q_2, q_3 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real J3 = c[4];
    const real q_3_dot = v[3];
    const real q_3 = x[3];
    const real z_0 = q_3_dot*q_3;
    const real c_0 = c[5];
    const real q_0_dot = v[0];
    const real q_0 = x[0];
    const real z_1 = q_0_dot*q_0;
    const real J = c[3];
    const real q_1_dot = v[1];
    const real q_1 = x[1];
    const real z_2 = q_1_dot*q_1;
    const real q_2_dot = v[2];
    const real q_2 = x[2];
    const real z_3 = q_2_dot*q_2;
    const real z_4 = J*z_2 + J*z_3;
    Mdot1[0][0] = 8.0*(J3*z_0 + c_0*z_1 + z_4);
    const real c_1 = c[6];
    const real z_5 = q_3_dot*q_2;
    const real z_6 = q_2_dot*q_3;
    const real z_7 = z_5 + z_6;
    const real c_2 = c[7];
    const real z_8 = q_0_dot*q_1;
    const real z_9 = q_1_dot*q_0;
    const real z_10 = z_8 + z_9;
    Mdot1[0][1] = Mdot1[1][0] = 4.0*(c_1*z_7 - c_2*z_10);
    const real z_11 = J*z_1 + J*z_0;
    Mdot1[1][1] = 8.0*(J3*z_3 + c_0*z_2 + z_11);
    const real z_12 = q_1_dot*q_3;
    const real z_13 = q_3_dot*q_1;
    const real z_14 = z_12 + z_13;
    const real z_15 = q_0_dot*q_2;
    const real z_16 = q_2_dot*q_0;
    const real z_17 = z_15 + z_16;
    Mdot1[0][2] = Mdot1[2][0] = (-4.0)*(c_1*z_14 + c_2*z_17);
    const real c_4 = c[9];
    const real z_18 = q_2_dot*q_1;
    const real z_19 = q_1_dot*q_2;
    Mdot1[1][2] = Mdot1[2][1] = (-4.0)*(c_4*(z_18 + z_19));
    Mdot1[2][2] = 8.0*(J3*z_2 + c_0*z_3 + z_11);
    const real z_20 = q_0_dot*q_3;
    const real z_21 = q_3_dot*q_0;
    Mdot1[0][3] = Mdot1[3][0] = (-4.0)*(c_4*(z_20 + z_21));
    Mdot1[1][3] = Mdot1[3][1] = (-4.0)*(c_1*z_17 + c_2*z_14);
    Mdot1[2][3] = Mdot1[3][2] = 4.0*(c_1*z_10 - c_2*z_7);
    Mdot1[3][3] = 8.0*(J3*z_1 + c_0*z_0 + z_4);
    const real c_5 = c[10];
    const real c_6 = c[11];
    const real z_22 = (z_20 + z_18 - z_21 - z_19)*c_6;
    const real c_7 = c[12];
    const real z_23 = (z_15 + z_12 - z_16 - z_13)*c_7;
    const real z_24 = (z_8 + z_5 - z_9 - z_6)*c_7;
    const real c_8 = c[13];
    const real z_25 = (z_0 + z_2 + z_3 + z_1)*c_8;
    f1[0] = (-2.0)*((q_0*c_5 + q_3_dot*z_22 + q_2_dot*z_23 + q_1_dot*z_24) - q_0_dot*z_25);
    f1[1] = 2.0*((q_1*c_5 + q_2_dot*z_22 + q_0_dot*z_24 - q_3_dot*z_23) + q_1_dot*z_25);
    f1[2] = (-2.0)*((q_1_dot*z_22 - q_2*c_5 - q_0_dot*z_23 - q_3_dot*z_24) - q_2_dot*z_25);
    f1[3] = 2.0*((q_0_dot*z_22 + q_1_dot*z_23 - q_3*c_5 - q_2_dot*z_24) + q_3_dot*z_25);
    A1[0][0] = 2.0*q_0;
    A1[0][1] = 2.0*q_1;
    A1[0][2] = 2.0*q_2;
    A1[0][3] = 2.0*q_3;
    gamma[0] = 2.0*(q_0_dot*q_0_dot + q_1_dot*q_1_dot + q_2_dot*q_2_dot + q_3_dot*q_3_dot);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* q_0, q_1, q_2, q_3: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4], y[5], y[6], y[7] };
    const real *const C1 = y + 8, *const s1 = y + 24;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* q_0, q_1, q_2, q_3: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4], y[5], y[6], y[7] };
    const real *const C1 = y + 8, *const s1 = y + 24;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, f1, A1, gamma);

    /* q_0, q_1, q_2, q_3: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* q_0, q_1, q_2, q_3: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 8, *const s1_dot = dy + 24;
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
    dy[4] = a1[0];
    dy[5] = a1[1];
    dy[6] = a1[2];
    dy[7] = a1[3];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1])
{
    const real J3 = c[4];
    const real q_3 = x[3];
    const real z_0 = q_3*q_3;
    const real c_0 = c[5];
    const real q_0 = x[0];
    const real z_1 = q_0*q_0;
    const real J = c[3];
    const real q_1 = x[1];
    const real z_2 = q_1*q_1;
    const real q_2 = x[2];
    const real z_3 = q_2*q_2;
    const real z_4 = J*z_2 + J*z_3;
    M1[0][0] = 4.0*(J3*z_0 + c_0*z_1 + z_4);
    const real c_1 = c[6];
    const real z_5 = q_2*c_1;
    const real c_2 = c[7];
    const real z_6 = q_1*c_2;
    M1[1][0] = 4.0*(q_3*z_5 - q_0*z_6);
    const real z_7 = J*z_1 + J*z_0;
    M1[1][1] = 4.0*(J3*z_3 + c_0*z_2 + z_7);
    const real z_8 = q_1*c_1;
    const real z_9 = q_2*c_2;
    M1[2][0] = (-4.0)*(q_3*z_8 + q_0*z_9);
    const real c_3 = c[8];
    M1[2][1] = -c_3*(q_1*q_2);
    M1[2][2] = 4.0*(J3*z_2 + c_0*z_3 + z_7);
    M1[3][0] = -c_3*(q_3*q_0);
    M1[3][1] = (-4.0)*(q_0*z_5 + q_3*z_6);
    M1[3][2] = 4.0*(q_0*z_8 - q_3*z_9);
    M1[3][3] = 4.0*(J3*z_1 + c_0*z_0 + z_4);
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    const real J3 = c[4];
    const real q_3_dot = v[3];
    const real q_3 = x[3];
    const real z_10 = q_3_dot*q_3;
    const real c_0 = c[5];
    const real q_0_dot = v[0];
    const real q_0 = x[0];
    const real z_11 = q_0_dot*q_0;
    const real J = c[3];
    const real q_1_dot = v[1];
    const real q_1 = x[1];
    const real z_12 = q_1_dot*q_1;
    const real q_2_dot = v[2];
    const real q_2 = x[2];
    const real z_13 = q_2_dot*q_2;
    const real z_14 = J*z_12 + J*z_13;
    Mdot1[0][0] = 8.0*(J3*z_10 + c_0*z_11 + z_14);
    const real c_1 = c[6];
    const real z_15 = q_3_dot*q_2;
    const real z_16 = q_2_dot*q_3;
    const real z_17 = z_15 + z_16;
    const real c_2 = c[7];
    const real z_18 = q_0_dot*q_1;
    const real z_19 = q_1_dot*q_0;
    const real z_20 = z_18 + z_19;
    Mdot1[0][1] = Mdot1[1][0] = 4.0*(c_1*z_17 - c_2*z_20);
    const real z_21 = J*z_11 + J*z_10;
    Mdot1[1][1] = 8.0*(J3*z_13 + c_0*z_12 + z_21);
    const real z_22 = q_1_dot*q_3;
    const real z_23 = q_3_dot*q_1;
    const real z_24 = z_22 + z_23;
    const real z_25 = q_0_dot*q_2;
    const real z_26 = q_2_dot*q_0;
    const real z_27 = z_25 + z_26;
    Mdot1[0][2] = Mdot1[2][0] = (-4.0)*(c_1*z_24 + c_2*z_27);
    const real c_4 = c[9];
    const real z_28 = q_2_dot*q_1;
    const real z_29 = q_1_dot*q_2;
    Mdot1[1][2] = Mdot1[2][1] = (-4.0)*(c_4*(z_28 + z_29));
    Mdot1[2][2] = 8.0*(J3*z_12 + c_0*z_13 + z_21);
    const real z_30 = q_0_dot*q_3;
    const real z_31 = q_3_dot*q_0;
    Mdot1[0][3] = Mdot1[3][0] = (-4.0)*(c_4*(z_30 + z_31));
    Mdot1[1][3] = Mdot1[3][1] = (-4.0)*(c_1*z_27 + c_2*z_24);
    Mdot1[2][3] = Mdot1[3][2] = 4.0*(c_1*z_20 - c_2*z_17);
    Mdot1[3][3] = 8.0*(J3*z_11 + c_0*z_10 + z_14);
    const real c_5 = c[10];
    const real c_6 = c[11];
    const real z_32 = (z_30 + z_28 - z_31 - z_29)*c_6;
    const real c_7 = c[12];
    const real z_33 = (z_25 + z_22 - z_26 - z_23)*c_7;
    const real z_34 = (z_18 + z_15 - z_19 - z_16)*c_7;
    const real c_8 = c[13];
    const real z_35 = (z_10 + z_12 + z_13 + z_11)*c_8;
    f1[0] = (-2.0)*((q_0*c_5 + q_3_dot*z_32 + q_2_dot*z_33 + q_1_dot*z_34) - q_0_dot*z_35);
    f1[1] = 2.0*((q_1*c_5 + q_2_dot*z_32 + q_0_dot*z_34 - q_3_dot*z_33) + q_1_dot*z_35);
    f1[2] = (-2.0)*((q_1_dot*z_32 - q_2*c_5 - q_0_dot*z_33 - q_3_dot*z_34) - q_2_dot*z_35);
    f1[3] = 2.0*((q_0_dot*z_32 + q_1_dot*z_33 - q_3*c_5 - q_2_dot*z_34) + q_3_dot*z_35);
    A1[0][0] = 2.0*q_0;
    A1[0][1] = 2.0*q_1;
    A1[0][2] = 2.0*q_2;
    A1[0][3] = 2.0*q_3;
    gamma[0] = 2.0*(q_0_dot*q_0_dot + q_1_dot*q_1_dot + q_2_dot*q_2_dot + q_3_dot*q_3_dot);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1];
    triangular_masses(y, c, M1);

    /* q_0, q_1, q_2, q_3: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[4], y[5], y[6], y[7] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    triangular_motion(y, dy, c, Mdot1, f1, A1, gamma);

    /* q_0, q_1, q_2, q_3: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* q_0, q_1, q_2, q_3: B = A L^-T */
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
    dy[4] = a1[0];
    dy[5] = a1[1];
    dy[6] = a1[2];
    dy[7] = a1[3];
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
    real v1[N1] = { e[0], e[1], e[2], e[3] };
    if (mode) em_backward(N1, memory + 0, memory + 16, v1);
    else em_velocity_of_eta(N1, y + 8, y + 24, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
}

#define EM_VELOCITY velocity_by_roots

#include "em_flock.h"
#endif

extern em_lanes quaternion_top_lanes;
em_lanes quaternion_top_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2,
    N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): (M + A^T W A) xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double q_0 = x[0];
    const double c_5 = c[10];
    const double q_3_dot = v[3];
    const double q_0_dot = v[0];
    const double q_3 = x[3];
    const double q_2_dot = v[2];
    const double q_1 = x[1];
    const double q_1_dot = v[1];
    const double q_2 = x[2];
    const double z_0 = q_0_dot*q_3 + q_2_dot*q_1 - q_3_dot*q_0 - q_1_dot*q_2;
    const double c_6 = c[11];
    const double z_1 = z_0*c_6;
    const double z_2 = q_0_dot*q_2 + q_1_dot*q_3 - q_2_dot*q_0 - q_3_dot*q_1;
    const double c_7 = c[12];
    const double z_3 = z_2*c_7;
    const double z_4 = q_0_dot*q_1 + q_3_dot*q_2 - q_1_dot*q_0 - q_2_dot*q_3;
    const double z_5 = z_4*c_7;
    const double J3 = c[4];
    const double z_6 = J3*z_0;
    const double J = c[3];
    const double z_7 = J*z_2;
    const double z_8 = J*z_4;
    const double z_9 = q_0_dot*q_0_dot + q_1_dot*q_1_dot + q_2_dot*q_2_dot + q_3_dot*q_3_dot;
    const double c_8 = c[13];
    const double z_10 = z_9*c_8;
    bias[0] = (-2.0)*(((q_0*c_5 + q_3_dot*z_1 + q_2_dot*z_3 + q_1_dot*z_5) + 2.0*(q_3_dot*z_6 + q_2_dot*z_7 +
        q_1_dot*z_8)) + q_0*z_10);
    bias[1] = 2.0*(((q_1*c_5 + q_2_dot*z_1 + q_0_dot*z_5 - q_3_dot*z_3) + 2.0*(q_2_dot*z_6 + q_0_dot*z_8 -
        q_3_dot*z_7)) - q_1*z_10);
    bias[2] = (-2.0)*(((q_1_dot*z_1 - q_2*c_5 - q_0_dot*z_3 - q_3_dot*z_5) + 2.0*(q_1_dot*z_6 - q_0_dot*z_7 -
        q_3_dot*z_8)) + q_2*z_10);
    bias[3] = 2.0*(((q_0_dot*z_1 + q_1_dot*z_3 - q_3*c_5 - q_2_dot*z_5) + 2.0*(q_0_dot*z_6 + q_1_dot*z_7 -
        q_2_dot*z_8)) - q_3*z_10);
    gamma[0] = 2.0*z_9;
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double q_0_dot = v[0];
    const double J3 = c[4];
    const double q_3 = x[3];
    const double z_0 = q_3*q_3;
    const double J = c[3];
    const double q_1 = x[1];
    const double z_1 = q_1*q_1;
    const double q_2 = x[2];
    const double z_2 = q_2*q_2;
    const double z_3 = J*z_1 + J*z_2;
    const double q_1_dot = v[1];
    const double q_0 = x[0];
    const double z_4 = J*q_1;
    const double c_1 = c[6];
    const double z_5 = q_2*c_1;
    const double z_6 = q_0*z_4 - q_3*z_5;
    const double q_2_dot = v[2];
    const double z_7 = J*q_2;
    const double z_8 = q_1*c_1;
    const double z_9 = q_0*z_7 + q_3*z_8;
    const double q_3_dot = v[3];
    const double z_10 = q_0*(J3*q_3);
    const double z_11 = q_0*q_0;
    const double z_12 = J*z_11 + J*z_0;
    const double z_13 = J3*(q_1*q_2);
    const double z_14 = q_0*z_5 + q_3*z_4;
    const double z_15 = q_3*z_7 - q_0*z_8;
    e[0] = 2.0*(q_0_dot*(q_0_dot*(J3*z_0 + z_3) - q_1_dot*z_6 - q_2_dot*z_9 - q_3_dot*z_10) - q_1_dot*(q_0_dot*z_6
        + q_2_dot*z_13 + q_3_dot*z_14 - q_1_dot*(J3*z_2 + z_12)) - q_2_dot*(q_0_dot*z_9 + q_1_dot*z_13 +
        q_3_dot*z_15 - q_2_dot*(J3*z_1 + z_12)) - q_3_dot*(q_0_dot*z_10 + q_1_dot*z_14 + q_2_dot*z_15 -
        q_3_dot*(J3*z_11 + z_3)));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c_5 = c[10];
    e[3] = -(z_1 + z_2 - z_0 - z_11)*c_5;
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
    p[0] = p[1] = p[2] = p[3] = p[4] = p[5] = 0.0;
    const double q_2 = x[2];
    const double q_0 = x[0];
    const double z_0 = q_2*q_0;
    const double q_1 = x[1];
    const double q_3 = x[3];
    const double z_1 = q_1*q_3;
    const double z_2 = z_0 + z_1;
    const double c_10 = c[15];
    p[6] = p[22] = z_2*c_10;
    const double z_3 = q_1*q_0 - q_2*q_3;
    p[7] = p[23] = -z_3*c_10;
    const double z_4 = q_1*q_1 - q_3*q_3;
    const double z_5 = q_2*q_2 - q_0*q_0;
    const double z_6 = z_4 + z_5;
    const double c_11 = c[16];
    p[8] = p[24] = -z_6*c_11;
    const double c_12 = c[17];
    p[9] = p[16] = z_2*c_12;
    p[10] = p[17] = -z_3*c_12;
    const double l = c[1];
    p[11] = p[18] = -l*z_6;
    const double c_13 = c[18];
    p[12] = c_13;
    p[13] = 2.0*z_2;
    p[14] = (-2.0)*z_3;
    p[15] = -z_6;
    p[19] = (1.0/5.0)*(l*(10.0*z_2 + 3.0*(z_4 - z_5)));
    p[20] = ((-2.0/5.0))*(l*(5.0*z_3 - 3.0*(q_3*q_0 + q_1*q_2)));
    p[21] = ((-1.0/5.0))*(l*(5.0*z_6 + 6.0*(z_0 - z_1)));
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
    const double J = c[3];
    const double q_1 = x[1];
    const double z_0 = J*q_1;
    dM[4] = dM[1] = (-4.0)*z_0;
    const double q_0 = x[0];
    const double z_1 = J*q_0;
    dM[5] = 8.0*z_1;
    const double q_2 = x[2];
    const double z_2 = J*q_2;
    dM[8] = dM[2] = (-4.0)*z_2;
    dM[10] = 8.0*z_1;
    const double J3 = c[4];
    const double q_3 = x[3];
    const double z_3 = J3*q_3;
    dM[12] = dM[3] = (-4.0)*z_3;
    const double z_4 = J - J3;
    const double z_5 = q_2*z_4;
    dM[13] = dM[7] = (-4.0)*z_5;
    const double z_6 = q_1*z_4;
    dM[14] = dM[11] = 4.0*z_6;
    const double z_7 = J3*q_0;
    dM[15] = 8.0*z_7;
    dM[16] = 8.0*z_0;
    dM[20] = dM[17] = (-4.0)*z_1;
    const double z_8 = q_3*z_4;
    dM[24] = dM[18] = (-4.0)*z_8;
    const double z_9 = q_2*J3;
    dM[25] = dM[22] = (-4.0)*z_9;
    const double z_10 = q_1*J3;
    dM[26] = 8.0*z_10;
    const double z_11 = J*q_3;
    dM[29] = dM[23] = (-4.0)*z_11;
    const double z_12 = q_0*z_4;
    dM[30] = dM[27] = 4.0*z_12;
    dM[31] = 8.0*z_0;
    dM[32] = 8.0*z_2;
    dM[36] = dM[33] = 4.0*z_8;
    dM[37] = 8.0*z_9;
    dM[40] = dM[34] = (-4.0)*z_1;
    dM[41] = dM[38] = (-4.0)*z_10;
    dM[45] = dM[39] = (-4.0)*z_12;
    dM[46] = dM[43] = (-4.0)*z_11;
    dM[47] = 8.0*z_2;
    dM[48] = 8.0*z_3;
    dM[52] = dM[49] = 4.0*z_5;
    dM[53] = 8.0*z_11;
    dM[56] = dM[50] = (-4.0)*z_6;
    dM[58] = 8.0*z_11;
    dM[60] = dM[51] = (-4.0)*z_7;
    dM[61] = dM[55] = (-4.0)*z_0;
    dM[62] = dM[59] = (-4.0)*z_2;
}

/* dM (n, n, n), of what is factored */
EM_RARE /* no step calls it */
EM_ACROSS void factored_gradient(double t, const double *restrict x, const double *restrict c,
                                 double *restrict dM)
{
    memset(dM, 0, sizeof *dM * N * N * N);
    const double q_0 = x[0];
    const double J = c[3];
    const double J3 = c[4];
    const double z_0 = 1.0/(0.390625*1.0/(17.59503580771935*J + 3.7506756431875465*J3) +
        0.765625*1.0/(4.141300643187547*J + 16.82941080771935*J3) + 10.546220166818202*1.0/J +
        16.82941080771935*1.0/(4.141300643187547*J + 0.765625*J3) + 3.7506756431875465*1.0/(17.59503580771935*J +
        0.390625*J3));
    dM[0] = 8.0*(q_0*z_0);
    const double q_1 = x[1];
    const double z_1 = z_0;
    const double z_2 = J - z_1;
    dM[4] = dM[1] = (-4.0)*(q_1*z_2);
    dM[5] = 8.0*(J*q_0);
    const double q_2 = x[2];
    dM[8] = dM[2] = (-4.0)*(q_2*z_2);
    dM[10] = 8.0*(J*q_0);
    const double q_3 = x[3];
    const double z_3 = J3 - z_1;
    dM[12] = dM[3] = (-4.0)*(q_3*z_3);
    const double z_4 = J - J3;
    const double z_5 = q_2*z_4;
    dM[13] = dM[7] = (-4.0)*z_5;
    const double z_6 = q_1*z_4;
    dM[14] = dM[11] = 4.0*z_6;
    dM[15] = 8.0*(J3*q_0);
    dM[16] = 8.0*(J*q_1);
    dM[20] = dM[17] = (-4.0)*(q_0*z_2);
    dM[21] = 8.0*(q_1*z_0);
    const double z_7 = q_3*z_4;
    dM[24] = dM[18] = (-4.0)*z_7;
    dM[25] = dM[22] = (-4.0)*(q_2*z_3);
    dM[26] = 8.0*(q_1*J3);
    dM[29] = dM[23] = (-4.0)*(q_3*z_2);
    const double z_8 = q_0*z_4;
    dM[30] = dM[27] = 4.0*z_8;
    dM[31] = 8.0*(J*q_1);
    dM[32] = 8.0*(J*q_2);
    dM[36] = dM[33] = 4.0*z_7;
    dM[37] = 8.0*(q_2*J3);
    dM[40] = dM[34] = (-4.0)*(q_0*z_2);
    dM[41] = dM[38] = (-4.0)*(q_1*z_3);
    dM[42] = 8.0*(q_2*z_0);
    dM[45] = dM[39] = (-4.0)*z_8;
    dM[46] = dM[43] = (-4.0)*(q_3*z_2);
    dM[47] = 8.0*(J*q_2);
    dM[48] = 8.0*(J3*q_3);
    dM[52] = dM[49] = 4.0*z_5;
    dM[53] = 8.0*(J*q_3);
    dM[56] = dM[50] = (-4.0)*z_6;
    dM[58] = 8.0*(J*q_3);
    dM[60] = dM[51] = (-4.0)*(q_0*z_3);
    dM[61] = dM[55] = (-4.0)*(q_1*z_2);
    dM[62] = dM[59] = (-4.0)*(q_2*z_2);
    dM[63] = 8.0*(q_3*z_0);
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double q_3_ddot = a[3];
    const double q_3 = x[3];
    const double J3 = c[4];
    const double J = c[3];
    const double z_0 = 1.0/(0.390625*1.0/(17.59503580771935*J + 3.7506756431875465*J3) +
        0.765625*1.0/(4.141300643187547*J + 16.82941080771935*J3) + 10.546220166818202*1.0/J +
        16.82941080771935*1.0/(4.141300643187547*J + 0.765625*J3) + 3.7506756431875465*1.0/(17.59503580771935*J +
        0.390625*J3));
    const double z_1 = z_0;
    const double z_2 = J3 - z_1;
    const double z_3 = q_3*z_2;
    const double q_3_dot = v[3];
    const double z_4 = q_3_dot*q_3_dot;
    const double q_0_ddot = a[0];
    const double q_0 = x[0];
    const double z_5 = q_0*z_0;
    const double q_1_ddot = a[1];
    const double q_1 = x[1];
    const double z_6 = J - z_1;
    const double z_7 = q_1*z_6;
    const double q_0_dot = v[0];
    const double z_8 = q_0_dot*q_0_dot;
    const double q_1_dot = v[1];
    const double z_9 = q_1_dot*q_1_dot;
    const double q_2_dot = v[2];
    const double z_10 = q_2_dot*q_2_dot;
    const double lambda_0 = lambda[0];
    const double z_11 = (z_8 + z_9 + z_10 + z_4)*z_0 + 0.5*lambda_0;
    const double g = c[2];
    const double l = c[1];
    const double m = c[0];
    const double z_12 = g*l*m;
    const double q_2_ddot = a[2];
    const double q_2 = x[2];
    const double z_13 = q_2*z_6;
    const double z_14 = (q_1_ddot*z_7 - z_11) - 0.5*((z_12 - 4.0*J*z_10) - 4.0*(J*z_9 + 0.5*q_2_ddot*z_13));
    D[0] = 2.0*(4.0*q_0_ddot*z_5 - 2.0*q_3_ddot*z_3 - 4.0*J3*z_4 - 2.0*z_14);
    const double z_15 = q_0*z_6;
    const double z_16 = J - J3;
    const double z_17 = q_3*z_16;
    const double z_18 = J*q_1;
    const double z_19 = q_0_dot*J;
    const double z_20 = q_3_dot*z_16;
    const double z_21 = q_1_dot*z_19 - q_2_dot*z_20;
    D[1] = 4.0*(2.0*q_0_ddot*z_18 + 2.0*z_21 - q_1_ddot*z_15 - q_2_ddot*z_17);
    const double z_22 = J*q_2;
    const double z_23 = q_2_dot*z_19 + q_1_dot*z_20;
    D[2] = 4.0*(q_1_ddot*z_17 + 2.0*q_0_ddot*z_22 + 2.0*z_23 - q_2_ddot*z_15);
    const double z_24 = q_0*z_2;
    const double z_25 = q_0_dot*J3;
    const double z_26 = q_3_dot*z_25;
    const double z_27 = q_1*z_16;
    const double z_28 = q_2*z_16;
    const double z_29 = q_2_ddot*z_27 - q_1_ddot*z_28;
    D[3] = (-4.0)*(q_3_ddot*z_24 + z_29 - 2.0*z_26 - 2.0*J3*q_3*q_0_ddot);
    const double z_30 = q_3_dot*J3;
    const double z_31 = q_1_dot*J;
    const double z_32 = q_2_dot*J;
    const double z_33 = q_1*z_31 + q_2*z_32;
    D[4] = 8.0*(q_3*z_30 + q_0_dot*z_5 + z_33);
    const double z_34 = J*(q_0_dot*q_1 + q_3_dot*q_2 - q_1_dot*q_0 - q_2_dot*q_3);
    D[5] = 8.0*(z_34 + q_3*z_32 - q_1_dot*z_15 - q_2*z_30);
    const double z_35 = J*(q_0_dot*q_2 + q_1_dot*q_3 - q_2_dot*q_0 - q_3_dot*q_1);
    D[6] = 8.0*(z_35 + q_1*z_30 - q_2_dot*z_15 - q_3*z_31);
    const double z_36 = J3*(q_0_dot*q_3 + q_2_dot*q_1 - q_3_dot*q_0 - q_1_dot*q_2);
    const double z_37 = q_2*z_31 + (z_36 - q_1*z_32);
    D[7] = 8.0*(z_37 - q_3_dot*z_24);
    const double z_38 = J*q_0;
    D[8] = 4.0*(2.0*q_1_ddot*z_38 + 2.0*z_21 - q_0_ddot*z_7 - q_3_ddot*z_28);
    const double z_39 = q_2*z_2;
    const double z_40 = q_1*z_0;
    const double z_41 = q_3*z_6;
    const double z_42 = (q_0_ddot*z_15 - z_11) + 0.5*((z_12 + 4.0*J*z_4) + 4.0*(J*z_8 + 0.5*q_3_ddot*z_41));
    D[9] = (-2.0)*(2.0*q_2_ddot*z_39 + 4.0*J3*z_10 + 2.0*z_42 - 4.0*q_1_ddot*z_40);
    const double z_43 = q_1*z_2;
    const double z_44 = q_1_dot*J3;
    const double z_45 = q_2_dot*z_44;
    const double z_46 = q_0*z_16;
    const double z_47 = q_3_ddot*z_46 - q_0_ddot*z_17;
    D[10] = (-4.0)*(q_2_ddot*z_43 + z_47 - 2.0*z_45 - 2.0*q_2*J3*q_1_ddot);
    const double z_48 = J*q_3;
    const double z_49 = q_3_dot*J;
    const double z_50 = q_0_dot*z_16;
    const double z_51 = q_1_dot*z_49 + q_2_dot*z_50;
    D[11] = 4.0*(2.0*q_1_ddot*z_48 + q_0_ddot*z_28 + 2.0*z_51 - q_3_ddot*z_7);
    const double z_52 = q_2_dot*J3;
    D[12] = (-8.0)*(z_34 + q_0_dot*z_7 + q_3*z_52 - q_2*z_49);
    const double z_53 = q_0*z_19 + q_3*z_49;
    D[13] = 8.0*(q_2*z_52 + q_1_dot*z_40 + z_53);
    const double z_54 = q_3*z_19 - (z_36 + q_0*z_49);
    D[14] = (-8.0)*(q_2_dot*z_43 - z_54);
    D[15] = 8.0*(z_35 + q_0*z_52 - q_3_dot*z_7 - q_2*z_19);
    D[16] = 4.0*(q_3_ddot*z_27 + 2.0*q_2_ddot*z_38 + 2.0*z_23 - q_0_ddot*z_13);
    D[17] = 4.0*(2.0*z_45 + 2.0*q_1*J3*q_2_ddot + z_47 - q_1_ddot*z_39);
    const double z_55 = q_2*z_0;
    D[18] = (-2.0)*(2.0*q_1_ddot*z_43 + 4.0*J3*z_9 + 2.0*z_42 - 4.0*q_2_ddot*z_55);
    const double z_56 = q_2_dot*z_49 - q_1_dot*z_50;
    D[19] = 4.0*(2.0*q_2_ddot*z_48 + 2.0*z_56 - q_3_ddot*z_13 - q_0_ddot*z_27);
    D[20] = (-8.0)*(z_35 + q_0_dot*z_13 + q_1*z_49 - q_3*z_44);
    D[21] = 8.0*(-q_1_dot*z_39 - z_54);
    D[22] = 8.0*(q_1*z_44 + q_2_dot*z_55 + z_53);
    D[23] = (-8.0)*(z_34 + q_3_dot*z_13 + q_0*z_44 - q_1*z_19);
    D[24] = 4.0*(2.0*z_26 + 2.0*J3*q_0*q_3_ddot + z_29 - q_0_ddot*z_3);
    D[25] = 4.0*(q_2_ddot*z_46 + 2.0*q_3_ddot*z_18 + 2.0*z_51 - q_1_ddot*z_41);
    D[26] = 4.0*(2.0*q_3_ddot*z_22 + 2.0*z_56 - q_2_ddot*z_41 - q_1_ddot*z_46);
    const double z_57 = q_3*z_0;
    D[27] = 2.0*(4.0*q_3_ddot*z_57 - 2.0*q_0_ddot*z_24 - 4.0*J3*z_8 - 2.0*z_14);
    D[28] = (-8.0)*(q_0_dot*z_3 + z_37);
    D[29] = (-8.0)*(z_35 + q_1_dot*z_41 + q_0*z_32 - q_2*z_25);
    D[30] = 8.0*(z_34 + q_0*z_31 - q_2_dot*z_41 - q_1*z_25);
    D[31] = 8.0*(q_0*z_25 + q_3_dot*z_57 + z_33);
    D[32] = 2.0*q_0_ddot;
    D[33] = 2.0*q_1_ddot;
    D[34] = 2.0*q_2_ddot;
    D[35] = 2.0*q_3_ddot;
    D[36] = 4.0*q_0_dot;
    D[37] = 4.0*q_1_dot;
    D[38] = 4.0*q_2_dot;
    D[39] = 4.0*q_3_dot;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double q_0 = x[0];
    const double g = c[2];
    const double l = c[1];
    const double z_0 = g*l;
    D[0] = 2.0*(q_0*z_0);
    const double m = c[0];
    const double z_1 = g*m;
    D[1] = 2.0*(q_0*z_1);
    const double z_2 = l*m;
    D[2] = 2.0*(q_0*z_2);
    const double q_2_dot = v[2];
    const double q_0_dot = v[0];
    const double q_2 = x[2];
    const double q_1_dot = v[1];
    const double q_3 = x[3];
    const double q_3_dot = v[3];
    const double q_1 = x[1];
    const double z_3 = q_0_dot*q_2 + q_1_dot*q_3 - q_2_dot*q_0 - q_3_dot*q_1;
    const double z_4 = q_0_dot*q_1 + q_3_dot*q_2 - q_1_dot*q_0 - q_2_dot*q_3;
    const double q_2_ddot = a[2];
    const double z_5 = q_2*q_0;
    const double q_1_ddot = a[1];
    const double z_6 = q_1*q_0;
    const double z_7 = q_2_ddot*z_5 + q_1_ddot*z_6;
    const double z_8 = q_1*q_3;
    const double z_9 = q_2*q_3;
    const double z_10 = q_2_ddot*z_8 - q_1_ddot*z_9;
    const double q_0_ddot = a[0];
    const double z_11 = q_2*q_2;
    const double z_12 = q_1*q_1;
    const double J = c[3];
    const double J3 = c[4];
    const double z_13 = 17.59503580771935*J + 3.7506756431875465*J3;
    const double z_14 = 4.141300643187547*J + 16.82941080771935*J3;
    const double z_15 = 4.141300643187547*J + 0.765625*J3;
    const double z_16 = 17.59503580771935*J + 0.390625*J3;
    const double z_17 = 0.390625*1.0/z_13 + 0.765625*1.0/z_14 + 10.546220166818202*1.0/J +
        16.82941080771935*1.0/z_15 + 3.7506756431875465*1.0/z_16;
    const double z_18 = 1.0/(z_17*z_17);
    const double z_19 = (q_0_dot*q_0_dot + q_1_dot*q_1_dot + q_2_dot*q_2_dot + q_3_dot*q_3_dot)*z_18;
    const double z_20 = q_0*q_0;
    const double q_3_ddot = a[3];
    const double z_21 = q_3*q_0;
    const double z_22 = q_3_ddot*z_21;
    const double z_23 = q_0*z_19 + q_0_ddot*z_18*z_20 + (z_22 + z_7)*z_18;
    const double z_24 = 1.0/(z_16*z_16);
    const double z_25 = 1.0/(z_15*z_15);
    const double z_26 = 1.0/(z_14*z_14);
    const double z_27 = 1.0/(z_13*z_13);
    const double z_28 = 263.9730889801027*z_24 + 278.78259920990234*z_25 + 42.18488066727281*1.0/(J*J) +
        12.682733219761863*z_26 + 27.49224344956148*z_27;
    D[3] = 8.0*q_2_dot*z_3 + 8.0*q_1_dot*z_4 + 4.0*q_0_ddot*z_11 + 4.0*q_0_ddot*z_12 + z_23*z_28 - 4.0*z_7 -
        4.0*z_10;
    const double z_29 = q_0_dot*q_3 + q_2_dot*q_1 - q_3_dot*q_0 - q_1_dot*q_2;
    const double z_30 = q_3*q_3;
    const double z_31 = 5.860430692480541*z_24 + 51.540070598640504*z_25 + 51.540070598640504*z_26 +
        5.860430692480541*z_27;
    D[4] = 8.0*q_3_dot*z_29 + 4.0*z_10 + 4.0*q_0_ddot*z_30 + z_23*z_31 - 4.0*z_22;
    D[6] = (-2.0)*(q_1*z_0);
    D[7] = (-2.0)*(q_1*z_1);
    D[8] = (-2.0)*(q_1*z_2);
    const double z_32 = q_3_ddot*z_8 + q_0_ddot*z_6;
    const double z_33 = q_3_ddot*z_5 - q_0_ddot*z_9;
    const double z_34 = q_1*q_2;
    const double z_35 = q_2_ddot*z_34;
    const double z_36 = q_1*z_19 + q_1_ddot*z_18*z_12 + (z_35 + z_32)*z_18;
    D[9] = 8.0*q_3_dot*z_3 + 4.0*q_1_ddot*z_30 + 4.0*q_1_ddot*z_20 + z_28*z_36 - 8.0*q_0_dot*z_4 - 4.0*z_32 -
        4.0*z_33;
    D[10] = -(8.0*q_2_dot*z_29 + 4.0*z_35 - 4.0*q_1_ddot*z_11 - 4.0*z_33 - z_31*z_36);
    D[12] = (-2.0)*(q_2*z_0);
    D[13] = (-2.0)*(q_2*z_1);
    D[14] = (-2.0)*(q_2*z_2);
    const double z_37 = q_3_ddot*z_9 + q_0_ddot*z_5;
    const double z_38 = q_3_ddot*z_6 - q_0_ddot*z_8;
    const double z_39 = q_1_ddot*z_34;
    const double z_40 = q_2*z_19 + q_2_ddot*z_18*z_11 + (z_39 + z_37)*z_18;
    D[15] = -(8.0*q_0_dot*z_3 + 8.0*q_3_dot*z_4 + 4.0*z_37 - 4.0*q_2_ddot*z_30 - 4.0*q_2_ddot*z_20 - 4.0*z_38 -
        z_28*z_40);
    D[16] = 8.0*q_1_dot*z_29 + 4.0*q_2_ddot*z_12 + z_31*z_40 - 4.0*z_39 - 4.0*z_38;
    D[18] = 2.0*(q_3*z_0);
    D[19] = 2.0*(q_3*z_1);
    D[20] = 2.0*(q_3*z_2);
    const double z_41 = q_2_ddot*z_9 + q_1_ddot*z_8;
    const double z_42 = q_2_ddot*z_6 - q_1_ddot*z_5;
    const double z_43 = q_0_ddot*z_21;
    const double z_44 = q_3*z_19 + q_3_ddot*z_18*z_30 + (z_43 + z_41)*z_18;
    D[21] = -(8.0*q_1_dot*z_3 + 4.0*z_41 - 8.0*q_2_dot*z_4 - 4.0*z_42 - 4.0*q_3_ddot*z_11 - 4.0*q_3_ddot*z_12 -
        z_28*z_44);
    D[22] = -(8.0*q_0_dot*z_29 + 4.0*z_43 + 4.0*z_42 - 4.0*q_3_ddot*z_20 - z_31*z_44);
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double q_0 = x[0];
    D[0] = 2.0*q_0;
    const double q_1 = x[1];
    D[1] = 2.0*q_1;
    const double q_2 = x[2];
    D[2] = 2.0*q_2;
    const double q_3 = x[3];
    D[3] = 2.0*q_3;
    const double q_0_dot = v[0];
    D[14] = 2.0*q_0_dot;
    const double q_1_dot = v[1];
    D[15] = 2.0*q_1_dot;
    const double q_2_dot = v[2];
    D[16] = 2.0*q_2_dot;
    const double q_3_dot = v[3];
    D[17] = 2.0*q_3_dot;
    D[18] = 2.0*q_0;
    D[19] = 2.0*q_1;
    D[20] = 2.0*q_2;
    D[21] = 2.0*q_3;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes quaternion_top_lanes;
EM_WEAK em_lanes quaternion_top_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 8, 24, 0, 16 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double J = parameters[3];
    const double J3 = parameters[4];
    const double z_0 = 1.0/(0.390625*1.0/(17.59503580771935*J + 3.7506756431875465*J3) +
        0.765625*1.0/(4.141300643187547*J + 16.82941080771935*J3) + 10.546220166818202*1.0/J +
        16.82941080771935*1.0/(4.141300643187547*J + 0.765625*J3) + 3.7506756431875465*1.0/(17.59503580771935*J +
        0.390625*J3));
    prepared[5] = z_0; /* c_0 */
    prepared[6] = J - J3; /* c_1 */
    prepared[7] = J - z_0; /* c_2 */
    const double z_1 = J3 - z_0;
    prepared[8] = 4.0*z_1; /* c_3 */
    prepared[9] = z_1; /* c_4 */
    const double g = parameters[2];
    const double l = parameters[1];
    const double m = parameters[0];
    prepared[10] = g*l*m; /* c_5 */
    prepared[11] = 2.0*J3; /* c_6 */
    prepared[12] = 2.0*J; /* c_7 */
    prepared[13] = 2.0*z_0; /* c_8 */
    prepared[14] = 4.0*J3; /* c_9 */
    prepared[15] = 2.5*l; /* c_10 */
    prepared[16] = 1.25*l; /* c_11 */
    prepared[17] = 2.0*l; /* c_12 */
    prepared[18] = (3.0/5.0)*l; /* c_13 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {63, ""},
    {60, "positive"},
    {60, "positive"},
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
    const double J3 = c[4];
    const double q_3 = x[3];
    const double z_0 = q_3*q_3;
    const double J = c[3];
    const double q_1 = x[1];
    const double z_1 = q_1*q_1;
    const double q_2 = x[2];
    const double z_2 = q_2*q_2;
    const double z_3 = J*z_1 + J*z_2;
    M[0] = 4.0*(J3*z_0 + z_3);
    const double q_0 = x[0];
    const double z_4 = J*q_1;
    const double c_1 = c[6];
    const double z_5 = q_2*c_1;
    M[4] = M[1] = (-4.0)*(q_0*z_4 - q_3*z_5);
    const double z_6 = q_0*q_0;
    const double z_7 = J*z_6 + J*z_0;
    M[5] = 4.0*(J3*z_2 + z_7);
    const double z_8 = J*q_2;
    const double z_9 = q_1*c_1;
    M[8] = M[2] = (-4.0)*(q_0*z_8 + q_3*z_9);
    const double c_9 = c[14];
    M[9] = M[6] = -c_9*(q_1*q_2);
    M[10] = 4.0*(J3*z_1 + z_7);
    M[12] = M[3] = -c_9*(q_3*q_0);
    M[13] = M[7] = (-4.0)*(q_0*z_5 + q_3*z_4);
    M[14] = M[11] = (-4.0)*(q_3*z_8 - q_0*z_9);
    M[15] = 4.0*(J3*z_6 + z_3);
}

/* M + A^T W A (n, n), which is factored in place of M: M is singular, but not along the constraints */
EM_ACROSS void factored_matrix(double t, const double *restrict x, const double *restrict c,
                               double *restrict M)
{
    const double J3 = c[4];
    const double q_3 = x[3];
    const double z_0 = q_3*q_3;
    const double c_0 = c[5];
    const double q_0 = x[0];
    const double z_1 = q_0*q_0;
    const double J = c[3];
    const double q_1 = x[1];
    const double z_2 = q_1*q_1;
    const double q_2 = x[2];
    const double z_3 = q_2*q_2;
    const double z_4 = J*z_2 + J*z_3;
    M[0] = 4.0*(J3*z_0 + c_0*z_1 + z_4);
    const double c_1 = c[6];
    const double z_5 = q_2*q_3;
    const double c_2 = c[7];
    const double z_6 = q_1*q_0;
    M[4] = M[1] = 4.0*(c_1*z_5 - c_2*z_6);
    const double z_7 = J*z_1 + J*z_0;
    M[5] = 4.0*(J3*z_3 + c_0*z_2 + z_7);
    const double z_8 = q_1*q_3;
    const double z_9 = q_2*q_0;
    M[8] = M[2] = (-4.0)*(c_1*z_8 + c_2*z_9);
    const double c_3 = c[8];
    M[9] = M[6] = -c_3*(q_1*q_2);
    M[10] = 4.0*(J3*z_2 + c_0*z_3 + z_7);
    M[12] = M[3] = -c_3*(q_3*q_0);
    M[13] = M[7] = (-4.0)*(c_1*z_9 + c_2*z_8);
    M[14] = M[11] = 4.0*(c_1*z_6 - c_2*z_5);
    M[15] = 4.0*(J3*z_1 + c_0*z_0 + z_4);
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
    const double q_0 = x[0];
    A[0] = 2.0*q_0;
    const double q_1 = x[1];
    A[1] = 2.0*q_1;
    const double q_2 = x[2];
    A[2] = 2.0*q_2;
    const double q_3 = x[3];
    A[3] = 2.0*q_3;
    b[0] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
EM_ACROSS void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
    const double q_1 = x[1];
    const double q_2 = x[2];
    const double q_3 = x[3];
    const double q_0 = x[0];
    const double z_0 = (q_1*q_1 + q_2*q_2) + (q_3*q_3 + q_0*q_0);
    phi[0] = -(1.0 - z_0);
    terms[0] = 1.0 + 2.0*z_0;
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
                              double A1[N_ROWS][N1], double b[N_ROWS])
{
    const double J3 = c[4];
    const double q_3 = x[3];
    const double z_0 = q_3*q_3;
    const double c_0 = c[5];
    const double q_0 = x[0];
    const double z_1 = q_0*q_0;
    const double J = c[3];
    const double q_1 = x[1];
    const double z_2 = q_1*q_1;
    const double q_2 = x[2];
    const double z_3 = q_2*q_2;
    const double z_4 = J*z_2 + J*z_3;
    M1[0][0] = 4.0*(J3*z_0 + c_0*z_1 + z_4);
    const double c_1 = c[6];
    const double z_5 = q_2*c_1;
    const double c_2 = c[7];
    const double z_6 = q_1*c_2;
    M1[0][1] = M1[1][0] = 4.0*(q_3*z_5 - q_0*z_6);
    const double z_7 = J*z_1 + J*z_0;
    M1[1][1] = 4.0*(J3*z_3 + c_0*z_2 + z_7);
    const double z_8 = q_1*c_1;
    const double z_9 = q_2*c_2;
    M1[0][2] = M1[2][0] = (-4.0)*(q_3*z_8 + q_0*z_9);
    const double c_3 = c[8];
    M1[1][2] = M1[2][1] = -c_3*(q_1*q_2);
    M1[2][2] = 4.0*(J3*z_2 + c_0*z_3 + z_7);
    M1[0][3] = M1[3][0] = -c_3*(q_3*q_0);
    M1[1][3] = M1[3][1] = (-4.0)*(q_0*z_5 + q_3*z_6);
    M1[2][3] = M1[3][2] = 4.0*(q_0*z_8 - q_3*z_9);
    M1[3][3] = 4.0*(J3*z_1 + c_0*z_0 + z_4);
    A1[0][0] = 2.0*q_0;
    A1[0][1] = 2.0*q_1;
    A1[0][2] = 2.0*q_2;
    A1[0][3] = 2.0*q_3;
    b[0] = 0.0;
}

/* Mdot */
EM_INLINE void settled_rates(const double *restrict x, const double *restrict v, const double *restrict c,
                             double Mdot1[N1][N1])
{
    const double J3 = c[4];
    const double q_3_dot = v[3];
    const double q_3 = x[3];
    const double z_10 = q_3_dot*q_3;
    const double c_0 = c[5];
    const double q_0_dot = v[0];
    const double q_0 = x[0];
    const double z_11 = q_0_dot*q_0;
    const double J = c[3];
    const double q_1_dot = v[1];
    const double q_1 = x[1];
    const double z_12 = q_1_dot*q_1;
    const double q_2_dot = v[2];
    const double q_2 = x[2];
    const double z_13 = q_2_dot*q_2;
    const double z_14 = J*z_12 + J*z_13;
    Mdot1[0][0] = 8.0*(J3*z_10 + c_0*z_11 + z_14);
    const double c_1 = c[6];
    const double z_15 = q_3_dot*q_2 + q_2_dot*q_3;
    const double c_2 = c[7];
    const double z_16 = q_0_dot*q_1 + q_1_dot*q_0;
    Mdot1[0][1] = Mdot1[1][0] = 4.0*(c_1*z_15 - c_2*z_16);
    const double z_17 = J*z_11 + J*z_10;
    Mdot1[1][1] = 8.0*(J3*z_13 + c_0*z_12 + z_17);
    const double z_18 = q_1_dot*q_3 + q_3_dot*q_1;
    const double z_19 = q_0_dot*q_2 + q_2_dot*q_0;
    Mdot1[0][2] = Mdot1[2][0] = (-4.0)*(c_1*z_18 + c_2*z_19);
    const double c_4 = c[9];
    Mdot1[1][2] = Mdot1[2][1] = (-4.0)*(c_4*(q_2_dot*q_1 + q_1_dot*q_2));
    Mdot1[2][2] = 8.0*(J3*z_12 + c_0*z_13 + z_17);
    Mdot1[0][3] = Mdot1[3][0] = (-4.0)*(c_4*(q_0_dot*q_3 + q_3_dot*q_0));
    Mdot1[1][3] = Mdot1[3][1] = (-4.0)*(c_1*z_19 + c_2*z_18);
    Mdot1[2][3] = Mdot1[3][2] = 4.0*(c_1*z_16 - c_2*z_15);
    Mdot1[3][3] = 8.0*(J3*z_11 + c_0*z_10 + z_14);
}

/* After an accepted step, and at the start: constraints on positions, C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS];
    settled_masses(y, c, M1, A1, b);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 24);
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        double Mdot1[N1][N1];
        settled_rates(y, dy, c, Mdot1);
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
    em_spread(N, N1, coordinate1, y + 8, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 8);
    for (int i = 0; i < N1; ++i) y[24 + i] = s[coordinate1[i]];
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

#include "quaternion_top.h"

static const char *const coordinate_names[] = { "q_0", "q_1", "q_2", "q_3", NULL };
static const char *const parameter_names[] = { "m", "l", "g", "J", "J3", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 0.2, 9.81, 0.05, 0.02, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.955336489125606, 0.29552020666133955, 0.0, 0.0 };
static const double initial_v[N] = { 0.0, 0.0, -1.4776010333066978, 4.77668244562803 };
static const int carried[N] = { 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"ground", 0, 3},
    {"line", 3, 6},
    {"disk", 9, 7},
    {"line", 16, 6},
    {"trace", 22, 3}
};
static const em_slice layout[] = {
    {"x", 0, 4},
    {"eta", 4, 4},
    {"C", 8, 16},
    {"s", 24, 4}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "a factor of Delta: one constraint, Delta is a number",
    "b, bdot: the constraints are homogeneous in the velocities",
    "M^-1: M is singular; M + A^T W A is factored, with weights W of row 0",
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
static int simulate(em_run *run) { return em_simulate(&quaternion_top_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&quaternion_top_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&quaternion_top_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&quaternion_top_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&quaternion_top_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&quaternion_top_model, run, mode); }

const em_model quaternion_top_model = {
    .abi = EM_ABI,
    .name = "quaternion_top",
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
    .n_left_out = 7,
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
    .lanes = &quaternion_top_lanes,
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
    .n_shapes = 5,
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
