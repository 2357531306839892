/* eigenmotion generate four_bar.py */
/* input sha256:10ea64c65b0625c37ac606379d8e7cc0bf2575aa65b654f2e2d516bf1b2ce748 */
/* body sha256:23c9baa9766be8ddf9d014383252d770320ddf99a870dace58cb55a40769953d */
/* four_bar: equations of motion, eigenfactor formulation.
 *
 * State, 12 numbers:
 *   x    y[0 .. 3)
 *   eta  y[3 .. 6)
 *   C    y[6 .. 10)
 *   s    y[10 .. 12)
 *
 * Blocks of M that do not couple:
 *   1: q1, q2 (C and s are states)
 *   2: q3 (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dq3: M does not depend on it
 *   C, mu, Omega across blocks: {q1, q2}, {q3} do not couple
 *   C, s, mu, Omega of {q3}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 10 additions, 32 multiplications, 6 function calls
 *   triangular root: 11 additions, 36 multiplications, 6 function calls
 *   projection: 4 additions, 19 multiplications, 6 function calls
 */
/* Callers use the same arguments for all models; each function uses those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "numeric/em_functions.h"
#include "constraints/em_multipliers.h"

/* Sizes. */
enum {
    N = 3,                /* coordinates */
    N_ROWS = 2,           /* constraint rows */
    N_POSITIONS = 2,      /* of which holonomic */
    N_STATE = 12,         /* numbers of a state */
    N_C = 4,              /* of which C, */
    N_S = 2,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 6,         /* numbers that a run keeps from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "loop/em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 6,
    N_PREPARED = 29,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_FORCING = 7,        /* inputs, parameters and the time */
    N_ARGUMENTS = 13,     /* x, v and these: the arguments of derivatives */
    N1 = 2,               /* q1, q2 */
    N2 = 1,               /* q3 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1 };
EM_UNUSED static const int coordinate2[N2] = { 2 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1], real f2[N2], real A1[N_ROWS][N1],
                                  real A2[N_ROWS][N2], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[11];
    const real q1_dot = v[0];
    const real q2 = x[1];
    const real cos_q2 = em_cos(q2);
    const real q1 = x[0];
    const real sin_q1 = em_sin(q1);
    const real z_2 = cos_q2*sin_q1;
    const real q2_dot = v[1];
    const real cos_q1 = em_cos(q1);
    const real sin_q2 = em_sin(q2);
    const real z_5 = cos_q1*sin_q2;
    Mdot1[0][1] = Mdot1[1][0] = (-0.5)*(c_1*(q1_dot*z_2 + q2_dot*z_5) - c_1*(q1_dot*z_5 + q2_dot*z_2));
    Mdot1[1][1] = em_real(0.0);
    const real z_6 = q1_dot*q2_dot*(c_1*(z_2 - z_5));
    const real c_3 = c[13];
    f1[0] = (-0.5)*(z_6 + cos_q1*c_3);
    const real c_4 = c[14];
    f1[1] = 0.5*(z_6 - cos_q2*c_4);
    const real q3 = x[2];
    const real cos_q3 = em_cos(q3);
    const real c_5 = c[15];
    f2[0] = -cos_q3*c_5;
    const real a_ = c[0];
    const real z_8 = a_*sin_q1;
    A1[0][0] = -z_8;
    const real b = c[1];
    const real z_9 = b*sin_q2;
    A1[0][1] = -z_9;
    const real z_10 = a_*cos_q1;
    A1[1][0] = z_10;
    const real z_11 = b*cos_q2;
    A1[1][1] = z_11;
    const real c_ = c[2];
    const real sin_q3 = em_sin(q3);
    const real z_13 = c_*sin_q3;
    A2[0][0] = z_13;
    const real z_14 = c_*cos_q3;
    A2[1][0] = -z_14;
    const real z_15 = q1_dot*q1_dot;
    const real z_16 = q2_dot*q2_dot;
    const real q3_dot = v[2];
    const real z_17 = q3_dot*q3_dot;
    gamma[0] = -(z_10*z_15 + z_11*z_16 - z_14*z_17);
    gamma[1] = -(z_8*z_15 + z_9*z_16 - z_13*z_17);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* q1, q2: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[3], y[4] };
    const real *const C1 = y + 6, *const s1 = y + 10;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    /* q3: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[5] };
    const real *const C2 = c + 6, *const s2 = c + 7;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[2] = v2[0];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* q1, q2: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[3], y[4] };
    const real *const C1 = y + 6, *const s1 = y + 10;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    /* q3: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[5] };
    const real *const C2 = c + 6, *const s2 = c + 7;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[2] = v2[0];

    real Mdot1[N1][N1], f1[N1], f2[N2], A1[N_ROWS][N1], A2[N_ROWS][N2], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, f1, f2, A1, A2, gamma);

    /* q1, q2: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* q3: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* q1, q2: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_transpose_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 6, *const s1_dot = dy + 10;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41);  Bdot eta = Adot xdot + B q (40) */
    real a1[N1], q1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, q1);

    /* q3: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[3] = a1[0];
    dy[4] = a1[1];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[5] = a2[0];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[4])
{
    const real c_0 = c[10];
    M1[0][0] = c_0;
    const real c_1 = c[11];
    const real q1 = x[0];
    const real cos_q1 = em_cos(q1);
    const real q2 = x[1];
    const real cos_q2 = em_cos(q2);
    const real sin_q1 = em_sin(q1);
    const real sin_q2 = em_sin(q2);
    M1[1][0] = 0.5*(c_1*(cos_q1*cos_q2 + sin_q1*sin_q2));
    const real c_2 = c[12];
    M1[1][1] = c_2;
    shared[0] = cos_q2;
    shared[1] = sin_q1;
    shared[2] = cos_q1;
    shared[3] = sin_q2;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[4], real Mdot1[N1][N1], real f1[N1], real f2[N2],
                                 real A1[N_ROWS][N1], real A2[N_ROWS][N2], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    const real c_1 = c[11];
    const real q1_dot = v[0];
    const real cos_q2 = shared[0];
    const real sin_q1 = shared[1];
    const real z_4 = cos_q2*sin_q1;
    const real q2_dot = v[1];
    const real cos_q1 = shared[2];
    const real sin_q2 = shared[3];
    const real z_5 = cos_q1*sin_q2;
    Mdot1[0][1] = Mdot1[1][0] = (-0.5)*(c_1*(q1_dot*z_4 + q2_dot*z_5) - c_1*(q1_dot*z_5 + q2_dot*z_4));
    Mdot1[1][1] = em_real(0.0);
    const real z_6 = q1_dot*q2_dot*(c_1*(z_4 - z_5));
    const real c_3 = c[13];
    f1[0] = (-0.5)*(z_6 + cos_q1*c_3);
    const real c_4 = c[14];
    f1[1] = 0.5*(z_6 - cos_q2*c_4);
    const real q3 = x[2];
    const real cos_q3 = em_cos(q3);
    const real c_5 = c[15];
    f2[0] = -cos_q3*c_5;
    const real a_ = c[0];
    const real z_8 = a_*sin_q1;
    A1[0][0] = -z_8;
    const real b = c[1];
    const real z_9 = b*sin_q2;
    A1[0][1] = -z_9;
    const real z_10 = a_*cos_q1;
    A1[1][0] = z_10;
    const real z_11 = b*cos_q2;
    A1[1][1] = z_11;
    const real c_ = c[2];
    const real sin_q3 = em_sin(q3);
    const real z_13 = c_*sin_q3;
    A2[0][0] = z_13;
    const real z_14 = c_*cos_q3;
    A2[1][0] = -z_14;
    const real z_15 = q1_dot*q1_dot;
    const real z_16 = q2_dot*q2_dot;
    const real q3_dot = v[2];
    const real z_17 = q3_dot*q3_dot;
    gamma[0] = -(z_10*z_15 + z_11*z_16 - z_14*z_17);
    gamma[1] = -(z_8*z_15 + z_9*z_16 - z_13*z_17);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; the other states are constant. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[4];
    triangular_masses(y, c, M1, shared);

    /* q1, q2: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[3], y[4] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    /* q3: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[5] };
    const real *const C2 = c + 6, *const s2 = c + 7;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[2] = v2[0];

    real Mdot1[N1][N1], f1[N1], f2[N2], A1[N_ROWS][N1], A2[N_ROWS][N2], gamma[N_ROWS];
    triangular_motion(y, dy, c, shared, Mdot1, f1, f2, A1, A2, gamma);

    /* q1, q2: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* q3: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* q1, q2: B = A L^-T */
    real B1[N_ROWS][N1];
    em_rows_of_root(N_ROWS, N1, L1[0], r1, A1[0], B1[0]);
    /* q3: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, q1, lambda);
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[3] = a1[0];
    dy[4] = a1[1];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[5] = a2[0];
    for (int k = 2*N; k < N_STATE; ++k) dy[k] = em_real(0.0);
    return 0;
}

/* dy <- f(t, y): the published equations, or in mode 1 those of the triangular root. */
EM_EXPORT int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags,
                        real *dy, em_fault *fault)
{
    if (mode) return rhs_cholesky(t, y, c, u, flags, dy, fault);
    return rhs_eigenfactor(t, y, c, u, memory, flags, dy, fault);
}

#endif
#ifdef EM_ON_LANES

#ifdef EM_ON_DUALS
#include "dynamics/em_rate_jacobian.h"
#else
/* Compiled with -DEM_ON_LANES, this file has the right-hand side on vectors; link it with the scalar version. */
__attribute__((noinline)) /* one copy, although stages call it from several places */
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

#ifdef EM_NODES_ALONE /* lanes for the nodes of one run, not for ensembles */
enum { EM_REMEMBERED = 0 };
#define em_group_run NULL
#else
#include "batch/em_lane_factors.h"

/* v (n) <- the part of xdot that follows from e (n), eta or an error of it, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1] };
    if (mode) em_backward(N1, memory + 0, memory + 4, v1);
    else em_velocity_of_eta(N1, y + 6, y + 10, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    real v2[N2] = { e[2] };
    em_velocity_of_eta(N2, c + 6, c + 7, v2);
    v[2] = v2[0];
}

#define EM_VELOCITY velocity_by_roots

#include "batch/em_lane_runge_kutta.h"
#endif

extern em_lanes four_bar_lanes;
em_lanes four_bar_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_group_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- functions that no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_EXPORT void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double q1_dot = v[0];
    const double q2_dot = v[1];
    const double c_1 = c[11];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    const double z_2 = cos_q2*sin_q1;
    const double cos_q1 = em_cos(q1);
    const double sin_q2 = em_sin(q2);
    const double z_5 = cos_q1*sin_q2;
    const double z_6 = q1_dot*q2_dot*(c_1*(z_2 - z_5));
    const double c_3 = c[13];
    const double z_7 = c_1*(q1_dot*z_2 + q2_dot*z_5) - c_1*(q1_dot*z_5 + q2_dot*z_2);
    bias[0] = (-0.5)*((z_6 + cos_q1*c_3) - q2_dot*z_7);
    const double c_4 = c[14];
    bias[1] = 0.5*((z_6 - cos_q2*c_4) + q1_dot*z_7);
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double c_5 = c[15];
    bias[2] = -cos_q3*c_5;
    const double a_ = c[0];
    const double z_9 = a_*(q1_dot*q1_dot);
    const double b = c[1];
    const double z_10 = b*(q2_dot*q2_dot);
    const double c_ = c[2];
    const double q3_dot = v[2];
    const double z_11 = c_*(q3_dot*q3_dot);
    gamma[0] = -(cos_q1*z_9 + cos_q2*z_10 - cos_q3*z_11);
    const double sin_q3 = em_sin(q3);
    gamma[1] = -(sin_q1*z_9 + sin_q2*z_10 - sin_q3*z_11);
}


/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_EXPORT void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double q1_dot = v[0];
    const double q2_dot = v[1];
    const double c_1 = c[11];
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double sin_q1 = em_sin(q1);
    const double sin_q2 = em_sin(q2);
    const double z_4 = c_1*(cos_q1*cos_q2 + sin_q1*sin_q2);
    const double c_11 = c[21];
    const double c_12 = c[22];
    const double c_13 = c[23];
    const double q3_dot = v[2];
    e[0] = (1.0/12.0)*(q1_dot*(3.0*q2_dot*z_4 + q1_dot*c_11) + q2_dot*(3.0*q1_dot*z_4 + q2_dot*c_12) +
        c_13*(q3_dot*q3_dot));
    e[1] = 0.0;
    e[2] = 0.0;
    const double b = c[1];
    const double c_14 = c[24];
    const double c_15 = c[25];
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double c_16 = c[26];
    const double c_17 = c[27];
    e[3] = (b*(b*sin_q2 + sin_q1*c_14) + c_15*sin_q1 + sin_q3*c_16)*c_17;
}

/* out (n_outputs), from x, v, a = xddot, lambda */
EM_EXPORT void observe(double t, const double *restrict x, const double *restrict v, const double *restrict a,
                       const double *restrict lambda, const double *restrict c, const double *restrict u,
                       double *restrict out)
{
}

/* p: the numbers of the drawing, shape by shape */
EM_EXPORT void draw(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                    double *restrict p)
{
    const double b = c[1];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double z_1 = b*cos_q2;
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double c_14 = c[24];
    p[0] = p[18] = 0.5*(z_1 + cos_q1*c_14);
    const double sin_q2 = em_sin(q2);
    const double z_4 = b*sin_q2;
    const double sin_q1 = em_sin(q1);
    p[1] = p[19] = 0.5*(z_4 + sin_q1*c_14);
    p[2] = p[3] = p[5] = p[6] = p[7] = p[15] = 0.0;
    const double d = c[3];
    p[4] = p[14] = d;
    const double a_ = c[0];
    const double z_6 = a_*cos_q1;
    p[8] = p[10] = z_6;
    const double z_7 = a_*sin_q1;
    p[9] = p[11] = z_7;
    p[12] = z_6 + z_1;
    p[13] = z_7 + z_4;
    const double c_ = c[2];
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    p[16] = c_*cos_q3 + d;
    const double sin_q3 = em_sin(q3);
    p[17] = c_*sin_q3;
    const double c_18 = c[28];
    p[20] = c_18;
}

#endif
#if EM_HOLDS(EM_DERIVATIVES)

/* --- partial derivatives --- */

/* dM (n, n, n): dM[k, i, j] = dM_ij / dx_k */
EM_COLD_PATH /* no step calls it */
EM_EXPORT void mass_matrix_gradient(double t, const double *restrict x, const double *restrict c,
                                    double *restrict dM)
{
    memset(dM, 0, sizeof *dM * N * N * N);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    const double b = c[1];
    const double density = c[4];
    const double a_ = c[0];
    const double z_2 = b*b*(density*a_);
    const double cos_q1 = em_cos(q1);
    const double sin_q2 = em_sin(q2);
    const double z_5 = cos_q2*sin_q1*z_2 - cos_q1*sin_q2*z_2;
    dM[3] = dM[1] = (-0.5)*z_5;
    dM[12] = dM[10] = 0.5*z_5;
}

/* D (n + m, 2 n) of r = M a + P^T lambda - bias and s = A a + gamma with respect to x, v, at fixed a, lambda */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double q1_dot = v[0];
    const double q2_dot = v[1];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double b = c[1];
    const double z_2 = b*b;
    const double density = c[4];
    const double a_ = c[0];
    const double z_3 = density*a_;
    const double z_4 = z_2*z_3;
    const double z_5 = cos_q1*z_4;
    const double z_6 = cos_q2*z_5;
    const double sin_q2 = em_sin(q2);
    const double sin_q1 = em_sin(q1);
    const double z_9 = sin_q1*z_4;
    const double z_10 = sin_q2*z_9;
    const double z_11 = q1_dot*q2_dot*(z_6 + z_10);
    const double g = c[5];
    const double z_12 = density*g;
    const double z_13 = (q1_dot*z_6 - q2_dot*z_10) + (q1_dot*z_10 - q2_dot*z_6);
    const double z_14 = q2_dot*z_13;
    const double z_15 = cos_q2*z_9;
    const double z_16 = sin_q2*z_5;
    const double z_17 = z_15 - z_16;
    const double q2_ddot = a[1];
    const double z_18 = z_17*q2_ddot;
    const double lambda_0 = lambda[0];
    const double z_19 = a_*cos_q1;
    const double lambda_1 = lambda[1];
    const double z_20 = a_*sin_q1;
    D[0] = 0.5*(((z_11 - sin_q1*(a_*a_*z_12 + 2.0*b*g*z_3)) - z_14) - z_18 - 2.0*(lambda_0*z_19 + lambda_1*z_20));
    D[1] = 0.5*(z_18 - (z_11 - z_14));
    const double z_21 = q1_dot*z_17;
    const double z_22 = (q1_dot*z_15 + q2_dot*z_16) - (q1_dot*z_16 + q2_dot*z_15);
    const double z_23 = q2_dot*z_17;
    D[4] = 0.5*(z_21 - (z_22 - z_23));
    const double z_24 = q1_dot*z_13;
    const double q1_ddot = a[0];
    const double z_25 = z_17*q1_ddot;
    D[6] = (-0.5)*((z_11 + z_24) + z_25);
    const double z_26 = b*cos_q2;
    const double z_27 = b*sin_q2;
    D[7] = 0.5*(z_25 + (z_24 + (z_11 - sin_q2*z_2*z_12)) - 2.0*(lambda_0*z_26 + lambda_1*z_27));
    D[9] = (-0.5)*(z_23 + (z_22 + z_21));
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    const double c_ = c[2];
    const double cos_q3 = em_cos(q3);
    const double z_30 = c_*cos_q3;
    const double z_31 = c_*sin_q3;
    D[14] = (-0.5)*(sin_q3*(c_*c_)*z_12 - 2.0*(lambda_0*z_30 + lambda_1*z_31));
    const double z_32 = q1_dot*q1_dot;
    D[18] = z_32*z_20 - q1_ddot*z_19;
    const double z_33 = q2_dot*q2_dot;
    D[19] = z_33*z_27 - q2_ddot*z_26;
    const double q3_dot = v[2];
    const double z_34 = q3_dot*q3_dot;
    const double q3_ddot = a[2];
    D[20] = -(z_34*z_31 - q3_ddot*z_30);
    D[21] = (-2.0)*(q1_dot*z_19);
    D[22] = (-2.0)*(q2_dot*z_26);
    D[23] = 2.0*(q3_dot*z_30);
    D[24] = -(z_32*z_19 + q1_ddot*z_20);
    D[25] = -(z_33*z_26 + q2_ddot*z_27);
    D[26] = z_34*z_30 + q3_ddot*z_31;
    D[27] = (-2.0)*(q1_dot*z_20);
    D[28] = (-2.0)*(q2_dot*z_27);
    D[29] = 2.0*(q3_dot*z_31);
}

/* D (n + m, n_inputs + n_parameters + 1) of r and s with respect to inputs, parameters, time */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_FORCING);
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double b = c[1];
    const double density = c[4];
    const double g = c[5];
    const double z_1 = density*g;
    const double z_2 = b*z_1;
    const double a_ = c[0];
    const double z_3 = density*a_;
    const double z_4 = g*z_3;
    const double z_5 = b*b;
    const double z_6 = density*z_5;
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    const double z_8 = cos_q1*sin_q2;
    const double cos_q2 = em_cos(q2);
    const double sin_q1 = em_sin(q1);
    const double z_11 = cos_q2*sin_q1;
    const double q1_dot = v[0];
    const double q2_dot = v[1];
    const double z_12 = q1_dot*q2_dot;
    const double z_13 = (z_6*z_8 - z_6*z_11)*z_12;
    const double z_14 = q2_dot*z_8;
    const double z_15 = q1_dot*z_11;
    const double z_16 = q2_dot*z_11;
    const double z_17 = q1_dot*z_8;
    const double z_18 = (z_6*z_14 + z_6*z_15) - (z_6*z_16 + z_6*z_17);
    const double q1_ddot = a[0];
    const double z_19 = b*z_3;
    const double z_20 = a_*a_;
    const double z_21 = density*z_20;
    const double z_22 = 2.0*z_19 + z_21;
    const double q2_ddot = a[1];
    const double z_23 = sin_q1*sin_q2;
    const double z_24 = cos_q1*cos_q2;
    const double z_25 = z_6*z_23 + z_6*z_24;
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    D[0] = 0.5*(((2.0*cos_q1*(z_2 + z_4) - z_13) - q2_dot*z_18) + (2.0*q1_ddot*z_22 + q2_ddot*z_25) -
        2.0*(sin_q1*lambda_0 - cos_q1*lambda_1));
    const double z_26 = (z_19*z_8 - z_19*z_11)*z_12;
    const double z_27 = (z_19*z_14 + z_19*z_15) - (z_19*z_16 + z_19*z_17);
    const double z_28 = z_19*z_23 + z_19*z_24;
    D[1] = ((cos_q1*z_4 - z_26) - q2_dot*z_27) + (q1_ddot*z_21 + q2_ddot*z_28);
    const double z_29 = a_*z_5;
    const double z_30 = (z_8*z_29 - z_11*z_29)*z_12;
    const double z_31 = (z_29*z_14 + z_29*z_15) - (z_29*z_16 + z_29*z_17);
    const double z_32 = z_29*z_23 + z_29*z_24;
    D[4] = (1.0/6.0)*(3.0*((cos_q1*(2.0*a_*b*g + g*z_20) - z_30) - q2_dot*z_31) + (2.0*q1_ddot*(a_*z_20 +
        3.0*b*z_20) + 3.0*q2_ddot*z_32));
    D[5] = 0.5*(cos_q1*z_22);
    D[7] = 0.5*((z_13 - q1_dot*z_18) + q1_ddot*z_25);
    D[8] = ((cos_q2*z_2 + z_26) - q1_dot*z_27) + (q2_ddot*z_6 + q1_ddot*z_28) - (sin_q2*lambda_0 -
        cos_q2*lambda_1);
    D[11] = (1.0/6.0)*(3.0*((cos_q2*g*z_5 + z_30) - q1_dot*z_31) + (2.0*b*q2_ddot*z_5 + 3.0*q1_ddot*z_32));
    D[12] = 0.5*(cos_q2*z_6);
    const double q3_ddot = a[2];
    const double c_ = c[2];
    const double z_33 = c_*c_;
    const double z_34 = density*z_33;
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double sin_q3 = em_sin(q3);
    D[16] = q3_ddot*z_34 + c_*cos_q3*z_1 + (sin_q3*lambda_0 - cos_q3*lambda_1);
    D[18] = (1.0/6.0)*(2.0*c_*q3_ddot*z_33 + 3.0*cos_q3*g*z_33);
    D[19] = 0.5*(cos_q3*z_34);
    const double z_37 = q1_dot*q1_dot;
    D[21] = -(cos_q1*z_37 + sin_q1*q1_ddot);
    const double z_38 = q2_dot*q2_dot;
    D[22] = -(cos_q2*z_38 + sin_q2*q2_ddot);
    const double q3_dot = v[2];
    const double z_39 = q3_dot*q3_dot;
    D[23] = cos_q3*z_39 + sin_q3*q3_ddot;
    D[28] = -(sin_q1*z_37 - cos_q1*q1_ddot);
    D[29] = -(sin_q2*z_38 - cos_q2*q2_ddot);
    D[30] = sin_q3*z_39 - cos_q3*q3_ddot;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double a_ = c[0];
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    D[0] = -a_*sin_q1;
    const double b = c[1];
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    D[1] = -b*sin_q2;
    const double c_ = c[2];
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    D[2] = c_*sin_q3;
    const double cos_q1 = em_cos(q1);
    D[6] = cos_q1;
    const double cos_q2 = em_cos(q2);
    D[7] = cos_q2;
    const double cos_q3 = em_cos(q3);
    D[8] = -cos_q3;
    D[9] = -1.0;
    D[13] = a_*cos_q1;
    D[14] = b*cos_q2;
    D[15] = -c_*cos_q3;
    D[19] = sin_q1;
    D[20] = sin_q2;
    D[21] = -sin_q3;
    const double q1_dot = v[0];
    const double z_6 = q1_dot*a_;
    D[26] = -cos_q1*z_6;
    const double q2_dot = v[1];
    const double z_7 = q2_dot*b;
    D[27] = -cos_q2*z_7;
    const double q3_dot = v[2];
    const double z_8 = q3_dot*c_;
    D[28] = cos_q3*z_8;
    D[29] = -a_*sin_q1;
    D[30] = -b*sin_q2;
    D[31] = c_*sin_q3;
    D[32] = -q1_dot*sin_q1;
    D[33] = -q2_dot*sin_q2;
    D[34] = q3_dot*sin_q3;
    D[39] = -sin_q1*z_6;
    D[40] = -sin_q2*z_7;
    D[41] = sin_q3*z_8;
    D[42] = a_*cos_q1;
    D[43] = b*cos_q2;
    D[44] = -c_*cos_q3;
    D[45] = q1_dot*cos_q1;
    D[46] = q2_dot*cos_q2;
    D[47] = -q3_dot*cos_q3;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* If the version for lanes is linked, it replaces this one. */
extern em_lanes four_bar_lanes;
EM_WEAK em_lanes four_bar_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "dynamics/em_blocks.h"
#include "loop/em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 1 };
EM_EXPORT const double scales[N] = { 1.0, 1.0, 1.0 };

/* The location of the roots of the blocks: offsets of C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 6, 10, 0, 4 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 6, 7, 8, 9 };
EM_EXPORT const em_block *const blocks[] = { &block1, &block2, NULL };

/* M of the constant blocks, and terms in parameters only that other functions share */
EM_INLINE void prepared_constants(const double *restrict parameters, double M2[N2][N2],
                                  double prepared[N_PREPARED])
{
    const double density = parameters[4];
    const double c_ = parameters[2];
    const double z_0 = c_*c_;
    const double z_1 = density*c_*z_0;
    M2[0][0] = (1.0/3.0)*z_1;
    const double a_ = parameters[0];
    const double z_2 = a_*a_;
    const double z_3 = density*a_;
    const double b = parameters[1];
    const double z_4 = density*b;
    const double z_5 = z_2*z_3 + 3.0*z_2*z_4;
    prepared[10] = (1.0/3.0)*z_5; /* c_0 */
    const double z_6 = b*b;
    prepared[11] = z_6*z_3; /* c_1 */
    const double z_7 = z_6*z_4;
    prepared[12] = (1.0/3.0)*z_7; /* c_2 */
    const double g = parameters[5];
    const double z_8 = density*g;
    prepared[13] = z_8*z_2 + 2.0*a_*b*z_8; /* c_3 */
    prepared[14] = z_8*z_6; /* c_4 */
    prepared[15] = 0.5*(z_8*z_0); /* c_5 */
    prepared[16] = (1.0/3.0)*z_1; /* c_6 */
    prepared[17] = fabs(a_); /* c_7 */
    prepared[18] = fabs(b); /* c_8 */
    prepared[19] = fabs(c_); /* c_9 */
    const double d = parameters[3];
    prepared[20] = fabs(d); /* c_10 */
    prepared[21] = 2.0*z_5; /* c_11 */
    prepared[22] = 2.0*z_7; /* c_12 */
    prepared[23] = 2.0*z_1; /* c_13 */
    prepared[24] = 2.0*a_; /* c_14 */
    prepared[25] = z_2; /* c_15 */
    prepared[26] = z_0; /* c_16 */
    prepared[27] = 0.5*z_8; /* c_17 */
    prepared[28] = (1.0/20.0)*a_; /* c_18 */
}

/* The assumptions of parameters, coordinates and inputs. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {63, ""},
    {63, ""},
    {63, ""},
    {63, ""}
};

/* Constants that depend on parameters only, computed once per parameter set: c (N_PREPARED). */
EM_EXPORT int prepare(const double *parameters, double *c, em_fault *fault)
{
    if (em_check_declared(declared, 0, N_PARAMETERS, parameters, fault)) return -1;
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    double M2[N2][N2];
    prepared_constants(parameters, M2, c);
    if (em_prepare(&block2, M2[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_EXPORT void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double c_0 = c[10];
    M[0] = c_0;
    const double c_1 = c[11];
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double sin_q1 = em_sin(q1);
    const double sin_q2 = em_sin(q2);
    M[3] = M[1] = 0.5*(c_1*(cos_q1*cos_q2 + sin_q1*sin_q2));
    const double c_2 = c[12];
    M[4] = c_2;
    M[6] = M[2] = 0.0;
    M[7] = M[5] = 0.0;
    const double c_6 = c[16];
    M[8] = c_6;
}

/* The matrix that is factored, to which motion_bias and its partial derivatives belong */
EM_EXPORT void factored(double t, const double *x, const double *c, double *M)
{
    mass_matrix(t, x, c, M);
}

/* A (m, n), b (m): A xdot + b = 0                                                                               (8) */
EM_EXPORT void pfaffian(double t, const double *restrict x, const double *restrict c, double *restrict A,
                        double *restrict b)
{
    const double a_ = c[0];
    const double q1 = x[0];
    const double sin_q1 = em_sin(q1);
    A[0] = -a_*sin_q1;
    const double b_ = c[1];
    const double q2 = x[1];
    const double sin_q2 = em_sin(q2);
    A[1] = -b_*sin_q2;
    const double c_ = c[2];
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    A[2] = c_*sin_q3;
    const double cos_q1 = em_cos(q1);
    A[3] = a_*cos_q1;
    const double cos_q2 = em_cos(q2);
    A[4] = b_*cos_q2;
    const double cos_q3 = em_cos(q3);
    A[5] = -c_*cos_q3;
    b[0] = 0.0;
    b[1] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): the terms that cancel in them; eps terms is their rounding */
EM_EXPORT void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
    const double a_ = c[0];
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double b = c[1];
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double c_ = c[2];
    const double q3 = x[2];
    const double cos_q3 = em_cos(q3);
    const double d = c[3];
    phi[0] = a_*cos_q1 + b*cos_q2 - c_*cos_q3 - d;
    const double sin_q1 = em_sin(q1);
    const double sin_q2 = em_sin(q2);
    const double sin_q3 = em_sin(q3);
    phi[1] = a_*sin_q1 + b*sin_q2 - c_*sin_q3;
    const double c_7 = c[17];
    const double c_8 = c[18];
    const double c_9 = c[19];
    const double c_10 = c[20];
    terms[0] = c_7*(fabs(cos_q1) + fabs(q1*sin_q1)) + c_8*(fabs(cos_q2) + fabs(q2*sin_q2)) + c_9*(fabs(cos_q3) +
        fabs(q3*sin_q3)) + c_10;
    terms[1] = c_7*(fabs(sin_q1) + fabs(q1*cos_q1)) + c_8*(fabs(sin_q2) + fabs(q2*cos_q2)) + c_9*(fabs(sin_q3) +
        fabs(q3*cos_q3));
}

/* crossing (n_events): an event happens where its function passes through zero */
EM_EXPORT void model_events(double t, const double *restrict x, const double *restrict v,
                            const double *restrict c, const double *restrict u, double *restrict crossing)
{
}

#endif
#if !EM_ALONE(EM_ASIDE) && !EM_ALONE(EM_RHS)
#include "dynamics/em_dependent_rows.h"
#endif
#if EM_HOLDS(EM_MODEL)
#include "dynamics/em_required_forces.h"
#endif
#if EM_HOLDS(EM_DERIVATIVES)
#include "dynamics/em_tangent.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const double *restrict x, const double *restrict c, double M1[N1][N1],
                              double A1[N_ROWS][N1], double A2[N_ROWS][N2], double b[N_ROWS],
                              double shared[4])
{
    const double c_0 = c[10];
    M1[0][0] = c_0;
    const double c_1 = c[11];
    const double q1 = x[0];
    const double cos_q1 = em_cos(q1);
    const double q2 = x[1];
    const double cos_q2 = em_cos(q2);
    const double sin_q1 = em_sin(q1);
    const double sin_q2 = em_sin(q2);
    M1[0][1] = M1[1][0] = 0.5*(c_1*(cos_q1*cos_q2 + sin_q1*sin_q2));
    const double c_2 = c[12];
    M1[1][1] = c_2;
    const double a_ = c[0];
    A1[0][0] = -a_*sin_q1;
    const double b_ = c[1];
    A1[0][1] = -b_*sin_q2;
    A1[1][0] = a_*cos_q1;
    A1[1][1] = b_*cos_q2;
    const double c_ = c[2];
    const double q3 = x[2];
    const double sin_q3 = em_sin(q3);
    A2[0][0] = c_*sin_q3;
    const double cos_q3 = em_cos(q3);
    A2[1][0] = -c_*cos_q3;
    b[0] = 0.0;
    b[1] = 0.0;
    shared[0] = cos_q2;
    shared[1] = sin_q1;
    shared[2] = cos_q1;
    shared[3] = sin_q2;
}

/* Mdot */
EM_INLINE void settled_rates(const double *restrict v, const double *restrict c, const double shared[4],
                             double Mdot1[N1][N1])
{
    Mdot1[0][0] = 0.0;
    const double c_1 = c[11];
    const double q1_dot = v[0];
    const double cos_q2 = shared[0];
    const double sin_q1 = shared[1];
    const double z_6 = cos_q2*sin_q1;
    const double q2_dot = v[1];
    const double cos_q1 = shared[2];
    const double sin_q2 = shared[3];
    const double z_7 = cos_q1*sin_q2;
    Mdot1[0][1] = Mdot1[1][0] = (-0.5)*(c_1*(q1_dot*z_6 + q2_dot*z_7) - c_1*(q1_dot*z_7 + q2_dot*z_6));
    Mdot1[1][1] = 0.0;
}

/* After an accepted step, and at the start: constraints on positions, C and s, constraints on velocities.
 * Returns 1 if y changed, 0 if not, or -1 and *fault. */
EM_EXPORT int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* eigenfactors were constant */
    int changed = rested || (flags & EM_STABILISE);
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double M1[N1][N1], A1[N_ROWS][N1], A2[N_ROWS][N2], b[N_ROWS], shared[4];
    settled_masses(y, c, M1, A1, A2, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 10);
    int new_mode = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (new_mode == EM_BY_TIME) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        em_velocity_kept(&block2, *mode, y + N, y, c, memory, dy);
        double Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        double time = em_time_of_block(&block1, Mdot1[0], y);
        new_mode = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != new_mode) {
        if (em_change_mode(&block1, new_mode, M1[0], y, memory, fault)) return -1;
        *mode = new_mode;
        changed = 1;
    }

    if (flags & EM_STABILISE) { /* eta <- eta - B^T Delta^-1 (B eta + b) */
        double B1[N_ROWS][N1], a1[N1];
        em_rows_of_block(&block1, *mode, N_ROWS, y, c, memory, A1[0], B1[0]);
        em_take(&block1, y + N, a1);
        double B2[N_ROWS][N2], a2[N2];
        em_rows_of_block(&block2, *mode, N_ROWS, y, c, memory, A2[0], B2[0]);
        em_take(&block2, y + N, a2);

        /* Delta = B B^T (43), Delta lambda = B a (46), in one loop */
        real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
        for (int row = 0; row < N_ROWS; ++row) {
            lambda[row] = b[row];
            em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
            em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
            for (int column = 0; column <= row; ++column) {
                Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
                em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
            }
        }
        if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;
        em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
        em_put(&block1, a1, y + N);
        em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
        em_put(&block2, a2, y + N);
    }
    return changed;
}

/* v (n): xdot from a state, according to its mode. */
EM_EXPORT int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    double M[N*N];
    factored(t, y, c, M);
    if (em_velocity_at(&block1, mode, M, y, c, v, fault)) return -1;
    if (em_velocity_at(&block2, mode, M, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that follows from an error e (n) of eta. */
EM_EXPORT void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, mode, e, y, c, memory, ev);
    em_velocity_kept(&block2, mode, e, y, c, memory, ev);
}

/* row (n_state): a state in the published meaning. */
EM_EXPORT int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                            em_fault *fault)
{
    memcpy(row, y, N_STATE * sizeof *row);
    if (mode == 0) return 0;
    double v[N];
    if (model_velocity(mode, t, y, c, v, fault)) return -1;
    em_publish_block(&block1, v, y, row);
    return 0;
}

/* y (n_state) from x, v (n); eigenfactors are continuous with those in y, if any */
EM_EXPORT int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    double C[N*N] = {0.0}, s[N], eta[N];
    em_spread(N, N1, coordinate1, y + 6, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 6);
    for (int i = 0; i < N1; ++i) y[10 + i] = s[coordinate1[i]];
    memcpy(y, x, N * sizeof *y);
    return 0;
}

/* The functions below take states in the published meaning. */
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
#include "loop/em_handle.h"
#include "inverse_dynamics/em_inverse_dynamics.h"
#include "batch/em_lane_run.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "four_bar.h"

static const char *const coordinate_names[] = { "q1", "q2", "q3", NULL };
static const char *const parameter_names[] = { "a", "b", "c", "d", "density", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 0.4, 1.0, 0.8, 1.0, 1.0, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 1.5707963267948966, 0.4069607577066713, 1.6730644304861704 };
static const double initial_v[N] = { 4.0, -0.1712309218771849, 1.9253387515666516 };
static const int carried[N] = { 1, 1, 0 };
static const em_shape shapes[] = {
    {"trace", 0, 2, 0, NULL},
    {"ground", 2, 2, 0, NULL},
    {"ground", 4, 2, 0, NULL},
    {"line", 6, 4, 0, NULL},
    {"line", 10, 4, 0, NULL},
    {"line", 14, 4, 0, NULL},
    {"disk", 18, 3, 0, NULL}
};
static const em_slice layout[] = {
    {"x", 0, 3},
    {"eta", 3, 3},
    {"C", 6, 4},
    {"s", 10, 2}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dq3: M does not depend on it",
    "C, mu, Omega across blocks: {q1, q2}, {q3} do not couple",
    "C, s, mu, Omega of {q3}: this block is constant, factored once per parameter set",
    NULL
};

/* Functions that steppers call. */
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

/* Functions of the stepper with this model as an argument. A run: */
static int simulate(em_run *run) { return em_simulate(&four_bar_model, run); }
/* the state within a run: */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&four_bar_model, run, step, t, y);
}
/* the memory of a run: */
static void release(em_run *run) { em_release(&four_bar_model, run); }
/* a run that advances on request: */
static void *open_run(em_run *run) { return em_handle_open(&four_bar_model, run); }
/* the size of its saved state: */
static size_t saved(void) { return em_handle_saved(&four_bar_model); }
/* forces of actuators: */
static int inverse_dynamics(double t, const double *x, const double *v, const double *a, const double *c,
                            const double *u, const em_actuators *actuators, double *forces, double *lambda,
                            double *residual, em_inverse_check *check, em_fault *fault)
{
    return em_inverse_dynamics(&four_bar_model, t, x, v, a, c, u, actuators, forces, lambda, residual,
                               check, fault);
}
/* a run on lanes: */
static void *enter(em_run *run, int *mode) { return em_member_enter(&four_bar_model, run, mode); }

const em_model four_bar_model = {
    .abi = EM_ABI,
    .name = "four_bar",
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
    .lanes = &four_bar_lanes,
    .enter = enter,
    .load = em_member_load,
    .check_step = em_member_check,
    .open = open_run,
    .advance = em_handle_advance,
    .now = em_handle_now,
    .publish = em_handle_publish,
    .saved = saved,
    .save = em_handle_save,
    .restore = em_handle_restore,
    .close = em_handle_close,
    .again = em_handle_again,
    .n_shapes = 7,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .equation_partials = em_equation_partials,
    .constraint_partials = constraint_partials,
    .motion_along = em_motion_along,
    .tangent = em_tangent,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
    .dynamics = &dynamics,
    .declared = declared,
    .required_forces = em_required_forces,
    .inverse_dynamics = inverse_dynamics,
};

#endif
#endif
