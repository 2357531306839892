/* eigenmotion generate dual_link.py --formulation lagrange */
/* input sha256:831cacef6d0f2b457bc168580b239f60e0d317722a8f3f92538eb5b78a31990d */
/* body sha256:400ae98390cf2d751ac4b9a528a82d7397e305838499d909655e953833eef6bc */
/* dual_link: equations of motion, lagrange formulation.
 *
 * State, 8 numbers:
 *   x    y[0 .. 4)
 *   v    y[4 .. 8)
 *
 * Blocks of M that do not couple:
 *   1: theta1, theta2, theta3
 *   2: theta4 (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   a factor of Delta: one constraint, Delta is a number
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dtheta4: M does not depend on it
 *   C, mu, Omega across blocks: {theta1, theta2, theta3}, {theta4} do not couple
 *   C, s, mu, Omega of {theta4}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   lagrange: 29 additions, 55 multiplications, 4 function calls
 *   projection: 3 additions, 11 multiplications, 4 function calls
 */
/* Callers use the same arguments for all models; each function uses those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "numeric/em_functions.h"
#include "constraints/em_multipliers.h"

/* Sizes. */
enum {
    N = 4,                /* coordinates */
    N_ROWS = 1,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 8,          /* numbers of a state */
    N_C = 0,              /* of which C, */
    N_S = 0,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 12,        /* numbers that a run keeps from one accepted step to the next */
    EM_SECOND_ORDER = 1,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "loop/em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 9,
    N_PREPARED = 20,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_FORCING = 10,       /* inputs, parameters and the time */
    N_ARGUMENTS = 18,     /* x, v and these: the arguments of derivatives */
    N1 = 3,               /* theta1, theta2, theta3 */
    N2 = 1,               /* theta4 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2 };
EM_UNUSED static const int coordinate2[N2] = { 3 };
#endif

#if EM_HOLDS(EM_RHS)

/* M of the blocks that vary: the lower triangle, f = force - Mdot xdot, A, gamma = Adot xdot + bdot */
EM_INLINE void lagrange_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                               real M1[N1][N1], real f1[N1], real f2[N2], real A1[N_ROWS][N1],
                               real gamma[N_ROWS])
{
    const real c_0 = c[13];
    const real theta3 = x[2];
    const real l1 = c[3];
    const real z_0 = theta3 + l1;
    M1[0][0] = c_0*(z_0*z_0);
    const real theta1 = x[0];
    const real cos_theta1 = em_cos(theta1);
    const real theta2 = x[1];
    const real cos_theta2 = em_cos(theta2);
    const real sin_theta1 = em_sin(theta1);
    const real sin_theta2 = em_sin(theta2);
    const real z_5 = cos_theta1*cos_theta2 + sin_theta1*sin_theta2;
    const real c_1 = c[14];
    const real z_6 = z_5*c_1;
    M1[1][0] = z_0*z_6;
    const real c_2 = c[15];
    M1[1][1] = c_2;
    M1[2][0] = em_real(0.0);
    const real z_7 = cos_theta2*sin_theta1 - cos_theta1*sin_theta2;
    M1[2][1] = z_7*c_1;
    M1[2][2] = c_0;
    const real theta2_dot = v[1];
    const real theta3_dot = v[2];
    const real z_8 = theta2_dot*theta3_dot*z_5;
    const real z_9 = theta2_dot*z_7;
    const real theta1_dot = v[0];
    const real z_10 = theta1_dot - theta2_dot;
    const real c_3 = c[16];
    const real z_11 = theta1_dot*z_0;
    const real K3 = c[8];
    const real theta4 = x[3];
    const real z_12 = K3*(theta1 + 1.5707963267948966 - theta4);
    const real z_13 = z_0*cos_theta1;
    const real K2 = c[7];
    const real l2 = c[4];
    const real z_14 = l2*sin_theta2;
    const real z_15 = z_0*sin_theta1;
    const real z_16 = 4.0 - z_14 - z_15;
    const real z_17 = l2*cos_theta2;
    const real z_18 = z_13 + z_17;
    const real z_19 = c_1*(z_8 - z_11*z_9);
    f1[0] = -((c_1*(z_8 - z_9*(z_0*z_10)) + c_3*(theta3_dot*z_11)) + ((z_12 - z_13*K2*z_16 - K2*z_18*z_15) -
        z_19));
    const real z_20 = theta1_dot*theta3_dot;
    const real c_4 = c[17];
    f1[1] = -((c_1*(z_5*z_20 - z_7*(z_10*z_11)) + theta3_dot*z_10*z_6) - (c_4*(cos_theta2*z_16 + z_18*sin_theta2)
        - z_19));
    const real z_21 = theta2_dot*z_6;
    const real K1 = c[6];
    f1[2] = -(z_10*z_21 + ((theta3*K1 - K2*(sin_theta1*z_16 - cos_theta1*z_18)) - (z_0*c_0*(theta1_dot*theta1_dot)
        + theta1_dot*z_21)));
    f2[0] = z_12;
    A1[0][0] = z_13;
    A1[0][1] = z_17;
    A1[0][2] = sin_theta1;
    gamma[0] = theta1_dot*(theta3_dot*cos_theta1 - sin_theta1*z_11) + cos_theta1*z_20 -
        z_14*(theta2_dot*theta2_dot);
}

/* Lagrange's equations, M xddot + A^T lambda = f, A xddot + gamma = 0 (11),
 * with M = L D L^T, or L L^T where it is constant.
 *   y = (x, v)    c prepared parameters    u inputs */
static int rhs_lagrange(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    for (int k = 0; k < N; ++k) dy[k] = y[N + k];
    real M1[N1][N1], f1[N1], f2[N2], A1[N_ROWS][N1], gamma[N_ROWS];
    lagrange_motion(y, y + N, c, M1, f1, f2, A1, gamma);

    /* theta1, theta2, theta3: M = L D L^T, r = D^-1 */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_ldlt(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    real *const a1 = f1;
    em_forward_unit(N1, L1[0], a1);
    /* theta1, theta2, theta3: B = A L^-T, BD = B D^-1 */
    real B1[N_ROWS][N1], BD1[N_ROWS][N1];
    em_rows_of_ldlt(N_ROWS, N1, L1[0], r1, A1[0], B1[0], BD1[0]);

    /* theta4: M = L L^T */
    const real (*const L2)[N2] = (const real (*)[N2])(c + 11);
    const real *const r2 = c + 12;
    real *const a2 = f2;
    em_forward(N2, L2[0], r2, a2);

    /* Delta = B D^-1 B^T, Delta lambda = B D^-1 a + gamma, in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, BD1[0], a1, NULL, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, BD1[row], B1[column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* xddot = L^-T D^-1 (a - B^T lambda) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    em_backward_unit(N1, L1[0], r1, a1);
    dy[4] = a1[0];
    dy[5] = a1[1];
    dy[6] = a1[2];
    em_backward(N2, L2[0], r2, a2);
    dy[7] = a2[0];
    return 0;
}

/* dy <- f(t, y). */
EM_EXPORT int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags,
                        real *dy, em_fault *fault)
{
    return rhs_lagrange(t, y, c, u, flags, dy, fault);
}

#endif
#if EM_HOLDS(EM_MODEL) && !defined(EM_NODES_ALONE)

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                              real A1[N_ROWS][N1], real b[N_ROWS])
{
    const real c_0 = c[13];
    const real theta3 = x[2];
    const real l1 = c[3];
    const real z_0 = theta3 + l1;
    M1[0][0] = c_0*(z_0*z_0);
    const real theta1 = x[0];
    const real cos_theta1 = em_cos(theta1);
    const real theta2 = x[1];
    const real cos_theta2 = em_cos(theta2);
    const real sin_theta1 = em_sin(theta1);
    const real sin_theta2 = em_sin(theta2);
    const real c_1 = c[14];
    M1[1][0] = z_0*(cos_theta1*cos_theta2 + sin_theta1*sin_theta2)*c_1;
    const real c_2 = c[15];
    M1[1][1] = c_2;
    M1[2][0] = em_real(0.0);
    M1[2][1] = (cos_theta2*sin_theta1 - cos_theta1*sin_theta2)*c_1;
    M1[2][2] = c_0;
    A1[0][0] = z_0*cos_theta1;
    const real l2 = c[4];
    A1[0][1] = l2*cos_theta2;
    A1[0][2] = sin_theta1;
    b[0] = em_real(0.0);
}

#endif
#ifdef EM_ON_LANES

/* Compiled with -DEM_ON_LANES, this file has the right-hand side on vectors; link it with the scalar version. */
__attribute__((noinline)) /* one copy, although stages call it from several places */
static void rhs_on_lanes(int mode, const double *t, const double *y, const double *c, const double *u, int flags,
                         double *dy)
{
    em_fault fault;
    model_rhs(mode, *(const real *)t, (const real *)y, (const real *)c, (const real *)u, NULL, flags, (real *)dy,
              &fault);
}

#ifdef EM_NODES_ALONE /* lanes for the nodes of one run, not for ensembles */
enum { EM_REMEMBERED = 0 };
#define em_group_run NULL
#else
#include "batch/em_lane_factors.h"

enum { N_PIVOTS = 3 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS];
    settled_masses(y, c, M1, A1, b);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* After an accepted step: constraints on velocities.
 * *done <- 0 in lanes that the scalar code must settle;
 * a singular matrix leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS];
    settled_masses(y, c, M1, A1, b);
    real L1[N1][N1], r1[N1]; /* L D L^T */
    em_ldlt(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);

    /* theta1, theta2, theta3: B = A L^-T, BD = B D^-1 */
    real B1[N_ROWS][N1], BD1[N_ROWS][N1];
    em_rows_of_ldlt(N_ROWS, N1, L1[0], r1, A1[0], B1[0], BD1[0]);
    const real v1[N1] = { y[4], y[5], y[6] };
    for (int row = 0; row < N_ROWS; ++row) em_add_to_load(N1, row, A1[0], v1, NULL, b);

    /* Delta = B D^-1 B^T, Delta lambda = A xdot + b, in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = b[row];
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, BD1[row], B1[column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;
    real a1[N1];
    em_clear(N1, a1);
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    em_backward_unit(N1, L1[0], r1, a1);
    y[4] += a1[0];
    y[5] += a1[1];
    y[6] += a1[2];
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "batch/em_lane_runge_kutta.h"
#endif

extern em_lanes dual_link_lanes;
em_lanes dual_link_lanes = { EM_LANES, rhs_on_lanes, NULL, em_group_run, EM_REMEMBERED, 1, N_PREPARED };

#else
#if EM_HOLDS(EM_ASIDE)

/* --- functions that no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_EXPORT void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double c_1 = c[14];
    const double theta2_dot = v[1];
    const double theta3_dot = v[2];
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double sin_theta1 = em_sin(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double z_4 = cos_theta1*cos_theta2 + sin_theta1*sin_theta2;
    const double z_5 = theta3_dot*z_4;
    const double z_6 = theta2_dot*z_5;
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_7 = theta3 + l1;
    const double z_8 = cos_theta2*sin_theta1 - cos_theta1*sin_theta2;
    const double theta1_dot = v[0];
    const double z_9 = theta1_dot - theta2_dot;
    const double z_10 = z_8*z_9;
    const double c_3 = c[16];
    const double z_11 = theta1_dot*z_7;
    const double K3 = c[8];
    const double theta4 = x[3];
    const double z_12 = K3*(theta1 + 1.5707963267948966 - theta4);
    const double z_13 = z_7*cos_theta1;
    const double K2 = c[7];
    const double l2 = c[4];
    const double z_14 = l2*sin_theta2;
    const double z_15 = z_7*sin_theta1;
    const double z_16 = 4.0 - z_14 - z_15;
    const double z_17 = z_13 + l2*cos_theta2;
    const double z_18 = c_1*(z_6 - theta2_dot*(z_8*z_11));
    bias[0] = -((c_1*(z_6 - theta2_dot*(z_7*z_10)) + c_3*(theta3_dot*z_11)) + ((z_12 - z_13*K2*z_16 -
        K2*z_17*z_15) - z_18));
    const double c_4 = c[17];
    bias[1] = -((c_1*(theta1_dot*z_5 - z_11*z_10) + c_1*z_9*z_5) - (c_4*(cos_theta2*z_16 + z_17*sin_theta2) -
        z_18));
    const double z_19 = z_4*(theta2_dot*c_1);
    const double K1 = c[6];
    const double c_0 = c[13];
    bias[2] = -(z_9*z_19 + ((theta3*K1 - K2*(sin_theta1*z_16 - cos_theta1*z_17)) -
        (z_7*c_0*(theta1_dot*theta1_dot) + theta1_dot*z_19)));
    bias[3] = z_12;
    const double z_20 = theta3_dot*cos_theta1;
    gamma[0] = theta1_dot*(z_20 - sin_theta1*z_11) + theta1_dot*z_20 - z_14*(theta2_dot*theta2_dot);
}


/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_EXPORT void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double c_5 = c[18];
    const double theta4_dot = v[3];
    const double theta1_dot = v[0];
    const double c_0 = c[13];
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_0 = theta3 + l1;
    const double theta2_dot = v[1];
    const double c_1 = c[14];
    const double z_1 = theta2_dot*c_1;
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double sin_theta1 = em_sin(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double z_6 = z_0*(cos_theta1*cos_theta2 + sin_theta1*sin_theta2);
    const double c_2 = c[15];
    const double theta3_dot = v[2];
    const double z_7 = cos_theta2*sin_theta1 - cos_theta1*sin_theta2;
    e[0] = 0.5*(c_5*(theta4_dot*theta4_dot) + theta1_dot*(theta1_dot*c_0*(z_0*z_0) + z_1*z_6) +
        theta2_dot*(theta2_dot*c_2 + theta1_dot*c_1*z_6 + theta3_dot*z_7*c_1) + theta3_dot*(theta3_dot*c_0 +
        z_7*z_1));
    e[1] = 0.0;
    e[2] = 0.0;
    const double K1 = c[6];
    const double K2 = c[7];
    const double l2 = c[4];
    const double z_8 = z_0*cos_theta1 + l2*cos_theta2;
    const double z_9 = 4.0 - l2*sin_theta2 - z_0*sin_theta1;
    const double K3 = c[8];
    const double theta4 = x[3];
    const double z_10 = theta1 + 1.5707963267948966 - theta4;
    e[3] = 0.5*(K1*(theta3*theta3) + K2*(z_8*z_8 + z_9*z_9) + K3*(z_10*z_10));
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
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_0 = theta3 + l1;
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double z_2 = z_0*cos_theta1;
    const double l2 = c[4];
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    p[0] = p[8] = p[16] = p[25] = z_2 + l2*cos_theta2;
    const double sin_theta2 = em_sin(theta2);
    const double sin_theta1 = em_sin(theta1);
    const double z_6 = z_0*sin_theta1;
    p[1] = p[9] = p[17] = p[26] = l2*sin_theta2 + z_6;
    p[2] = p[3] = p[4] = p[6] = p[10] = p[11] = 0.0;
    p[5] = p[7] = 4.0;
    p[12] = p[14] = p[18] = p[22] = z_2;
    p[13] = p[15] = p[19] = p[23] = z_6;
    const double l3 = c[5];
    const double theta4 = x[3];
    const double cos_theta4 = em_cos(theta4);
    p[20] = p[28] = z_2 + l3*cos_theta4;
    const double sin_theta4 = em_sin(theta4);
    p[21] = p[29] = z_6 + l3*sin_theta4;
    const double c_6 = c[19];
    p[24] = p[27] = p[30] = c_6;
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
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_0 = theta3 + l1;
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double cos_theta1 = em_cos(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double m2 = c[1];
    const double l2 = c[4];
    const double z_5 = m2*l2;
    const double z_6 = z_0*(cos_theta2*sin_theta1 - cos_theta1*sin_theta2)*z_5;
    dM[4] = dM[1] = -z_6;
    const double z_7 = (cos_theta1*cos_theta2 + sin_theta1*sin_theta2)*z_5;
    dM[9] = dM[6] = z_7;
    dM[20] = dM[17] = z_6;
    dM[25] = dM[22] = -z_7;
    const double m1 = c[0];
    dM[32] = 2.0*(z_0*(m1 + m2));
    dM[36] = dM[33] = z_7;
}

/* D (n + m, 2 n) of r = M a + P^T lambda - bias and s = A a + gamma with respect to x, v, at fixed a, lambda */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta3_dot = v[2];
    const double theta2_dot = v[1];
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double cos_theta1 = em_cos(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double m2 = c[1];
    const double l2 = c[4];
    const double z_4 = m2*l2;
    const double z_5 = (cos_theta2*sin_theta1 - cos_theta1*sin_theta2)*z_4;
    const double z_6 = theta2_dot*z_5;
    const double z_7 = theta3_dot*z_6;
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_8 = theta3 + l1;
    const double theta1_dot = v[0];
    const double z_9 = theta1_dot - theta2_dot;
    const double z_10 = (cos_theta1*cos_theta2 + sin_theta1*sin_theta2)*z_4;
    const double z_11 = theta2_dot*z_10;
    const double z_12 = z_7 + z_8*z_9*z_11;
    const double K3 = c[8];
    const double K2 = c[7];
    const double z_13 = z_8*sin_theta1;
    const double z_14 = l2*sin_theta2;
    const double z_15 = 4.0 - z_14 - z_13;
    const double z_16 = K2*(z_8*z_8);
    const double z_17 = l2*cos_theta2;
    const double z_18 = z_8*cos_theta1 + z_17;
    const double z_19 = cos_theta1*K2;
    const double z_20 = z_8*z_19;
    const double z_21 = theta1_dot*z_8;
    const double z_22 = z_7 + z_11*z_21;
    const double lambda_0 = lambda[0];
    const double theta2_ddot = a[1];
    const double z_23 = z_8*z_5;
    const double z_24 = theta2_ddot*z_23;
    D[0] = -((z_12 - ((K3 + (K2*z_13*z_15 + cos_theta1*cos_theta1*z_16) - (z_18*z_20 -
        sin_theta1*sin_theta1*z_16)) + z_22)) + z_13*lambda_0 + z_24);
    const double z_25 = K2*z_14;
    const double z_26 = z_22 - (z_17*z_20 + z_13*z_25);
    D[1] = z_24 + (z_12 - z_26);
    const double z_27 = cos_theta1*lambda_0;
    const double z_28 = z_9*z_6;
    const double m1 = c[0];
    const double z_29 = m1 + m2;
    const double z_30 = theta1_dot*theta3_dot;
    const double z_31 = theta1_dot*z_6;
    const double z_32 = z_13*z_19;
    const double z_33 = z_31 - ((z_15*z_19 - z_32) + (sin_theta1*K2*z_18 + z_32));
    const double z_34 = theta2_ddot*z_10;
    const double theta1_ddot = a[0];
    const double z_35 = z_8*z_29;
    D[2] = z_27 + (z_34 + 2.0*theta1_ddot*z_35) - ((z_28 - 2.0*z_29*z_30) - z_33);
    D[3] = -K3;
    const double z_36 = z_8*z_6;
    D[4] = z_36 - (z_36 - 2.0*theta3_dot*z_35);
    const double z_37 = z_5*z_21;
    const double z_38 = theta3_dot*z_10;
    const double z_39 = z_9*z_23;
    D[5] = (z_37 - z_38) + (z_38 + (z_36 - z_39));
    const double z_40 = z_11 - (2.0*z_29*z_21 + z_11);
    D[6] = -z_40;
    const double z_41 = z_9*z_10;
    const double z_42 = z_9*z_5;
    const double z_43 = (z_5*z_30 + z_41*z_21) + theta3_dot*z_42;
    const double theta3_ddot = a[2];
    const double z_44 = theta1_ddot*z_23 - theta3_ddot*z_10;
    D[8] = -((z_26 + z_43) + z_44);
    const double z_45 = K2*(l2*l2);
    const double z_46 = z_17*K2;
    D[9] = z_44 + (z_43 + (z_22 + ((z_15*z_25 + cos_theta2*cos_theta2*z_45) + (sin_theta2*sin_theta2*z_45 -
        z_18*z_46)))) - z_14*lambda_0;
    const double z_47 = z_31 - (sin_theta1*z_46 - z_14*z_19);
    D[10] = theta1_ddot*z_10 - (theta1_dot*z_42 + z_47);
    D[12] = -(z_36 - (z_38 + (z_38 - (z_37 + z_39))));
    const double z_48 = theta1_dot*z_10;
    D[14] = z_11 + (z_41 + z_48);
    D[16] = z_34 + z_27 - (z_28 - z_33);
    D[17] = -(z_34 - (z_28 - z_47));
    const double z_49 = theta1_dot*theta1_dot;
    const double K1 = c[6];
    D[18] = -(z_29*z_49 - (K1 + K2));
    D[20] = z_40;
    D[21] = -(z_48 - (z_41 - z_11));
    D[24] = -K3;
    D[27] = K3;
    D[32] = -((theta1_dot*(theta3_dot*sin_theta1 + cos_theta1*z_21) + sin_theta1*z_30) + (z_13*theta1_ddot -
        cos_theta1*theta3_ddot));
    D[33] = -(z_17*(theta2_dot*theta2_dot) + z_14*theta2_ddot);
    D[34] = cos_theta1*theta1_ddot - sin_theta1*z_49;
    const double z_50 = theta3_dot*cos_theta1;
    const double z_51 = theta1_dot*z_13;
    D[36] = z_50 - (z_51 - (z_50 - z_51));
    D[37] = (-2.0)*(theta2_dot*z_14);
    D[38] = 2.0*(theta1_dot*cos_theta1);
}

/* D (n + m, n_inputs + n_parameters + 1) of r and s with respect to inputs, parameters, time */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_FORCING);
    const double theta3_dot = v[2];
    const double theta1_dot = v[0];
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_0 = theta3 + l1;
    const double z_1 = theta1_dot*z_0;
    const double z_2 = theta3_dot*z_1;
    const double theta1_ddot = a[0];
    const double z_3 = theta1_ddot*(z_0*z_0);
    D[0] = 2.0*z_2 + z_3;
    const double theta2_dot = v[1];
    const double z_4 = theta1_dot - theta2_dot;
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double cos_theta1 = em_cos(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double z_9 = cos_theta2*sin_theta1 - cos_theta1*sin_theta2;
    const double l2 = c[4];
    const double z_10 = theta2_dot*l2;
    const double z_11 = z_9*z_10;
    const double z_12 = cos_theta1*cos_theta2 + sin_theta1*sin_theta2;
    const double z_13 = z_12*z_10;
    const double z_14 = theta3_dot*z_13;
    const double z_15 = z_1*z_11 - z_14;
    const double z_16 = l2*z_12;
    const double theta2_ddot = a[1];
    const double z_17 = z_0*theta2_ddot;
    D[1] = ((2.0*z_2 - (z_0*z_4*z_11 - z_14)) + z_15) + (z_3 + z_16*z_17);
    const double lambda_0 = lambda[0];
    const double m2 = c[1];
    const double z_18 = m2*z_9;
    const double z_19 = z_4*z_18;
    const double m1 = c[0];
    const double z_20 = m1 + m2;
    const double z_21 = theta1_dot*theta3_dot;
    const double z_22 = theta1_dot*z_18*z_10;
    const double z_23 = l2*sin_theta2;
    const double z_24 = z_0*sin_theta1;
    const double z_25 = 4.0 - z_23 - z_24;
    const double K2 = c[7];
    const double z_26 = cos_theta1*K2;
    const double z_27 = z_24*z_26;
    const double z_28 = z_0*cos_theta1;
    const double z_29 = l2*cos_theta2;
    const double z_30 = z_28 + z_29;
    const double z_31 = sin_theta1*K2;
    const double z_32 = m2*z_12;
    const double z_33 = l2*theta2_ddot;
    const double z_34 = z_0*theta1_ddot;
    D[3] = cos_theta1*lambda_0 + (z_32*z_33 + 2.0*z_20*z_34) - ((z_10*z_19 - 2.0*z_20*z_21) - (z_22 - ((z_25*z_26
        - z_27) + (z_30*z_31 + z_27))));
    const double z_35 = theta2_dot*z_32;
    const double z_36 = theta3_dot*z_35;
    const double z_37 = cos_theta2*K2;
    const double z_38 = theta2_dot*z_18*z_1 - z_36;
    D[4] = z_32*z_17 - ((theta2_dot*z_0*z_19 - z_36) - ((z_0*sin_theta2*z_26 - z_24*z_37) + z_38));
    D[7] = -(z_28*z_25 + z_30*z_24);
    const double theta4 = x[3];
    const double z_39 = 1.5707963267948966 + theta1 - theta4;
    D[8] = z_39;
    const double z_40 = theta3_dot*z_4;
    const double z_41 = l2*z_9;
    const double theta3_ddot = a[2];
    D[11] = -((z_15 - (z_16*z_40 - (z_4*z_1*z_41 - z_16*z_21))) - (theta3_ddot*z_41 + z_16*z_34 +
        theta2_ddot*(l2*l2)));
    D[13] = l2*theta1_ddot*z_32 - (theta1_dot*l2*z_19 + (z_22 - (z_29*z_31 - z_23*z_26)));
    const double z_42 = K2*sin_theta2;
    const double z_43 = z_29*z_42;
    D[14] = cos_theta2*lambda_0 + ((z_32*z_40 - (z_1*z_19 - z_32*z_21)) - (z_38 + ((z_25*z_37 - z_43) + (z_30*z_42
        + z_43)))) + (2.0*m2*z_33 + theta3_ddot*z_18 + z_32*z_34);
    D[17] = -(z_30*z_23 + z_29*z_25);
    const double z_44 = theta1_dot*theta1_dot;
    const double z_45 = z_0*z_44;
    D[20] = -(z_45 - theta3_ddot);
    D[21] = (z_4*z_13 - (z_45 + theta1_dot*z_13)) + (theta3_ddot + theta2_ddot*z_41);
    D[23] = K2 - z_20*z_44;
    D[24] = theta2_ddot*z_18 + (z_4*z_35 - (theta1_dot*z_35 - (sin_theta2*z_31 + cos_theta2*z_26)));
    D[26] = theta3;
    D[27] = -(sin_theta1*z_25 - cos_theta1*z_30);
    const double theta4_ddot = a[3];
    const double l3 = c[5];
    D[32] = theta4_ddot*(l3*l3);
    const double m3 = c[2];
    D[35] = 2.0*(m3*l3*theta4_ddot);
    D[38] = -z_39;
    D[43] = cos_theta1*theta1_ddot - sin_theta1*z_44;
    D[44] = -(sin_theta2*(theta2_dot*theta2_dot) - cos_theta2*theta2_ddot);
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double theta3_dot = v[2];
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double theta1_dot = v[0];
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_1 = theta3 + l1;
    const double sin_theta1 = em_sin(theta1);
    D[0] = theta3_dot*cos_theta1 - theta1_dot*z_1*sin_theta1;
    const double theta2_dot = v[1];
    const double l2 = c[4];
    const double theta2 = x[1];
    const double sin_theta2 = em_sin(theta2);
    D[1] = -theta2_dot*l2*sin_theta2;
    D[2] = theta1_dot*cos_theta1;
    D[4] = z_1*cos_theta1;
    const double cos_theta2 = em_cos(theta2);
    D[5] = l2*cos_theta2;
    D[6] = sin_theta1;
    D[11] = theta1_dot*cos_theta1;
    D[12] = theta2_dot*cos_theta2;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* If the version for lanes is linked, it replaces this one. */
extern em_lanes dual_link_lanes;
EM_WEAK em_lanes dual_link_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "dynamics/em_blocks.h"
#include "loop/em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 1 };
EM_EXPORT const double scales[N] = { 1.0, 1.0, 1.0, 1.0 };

/* The location of the roots of the blocks: offsets of C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, NULL, EM_IN_MEMORY, 0, 0, 0, 9 };
static const em_block block2 = { N, N2, coordinate2, NULL, EM_PREPARED_ROOT, 9, 10, 11, 12 };
EM_EXPORT const em_block *const blocks[] = { &block1, &block2, NULL };

/* M of the constant blocks, and terms in parameters only that other functions share */
EM_INLINE void prepared_constants(const double *restrict parameters, double M2[N2][N2],
                                  double prepared[N_PREPARED])
{
    const double m3 = parameters[2];
    const double l3 = parameters[5];
    M2[0][0] = m3*(l3*l3);
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double z_0 = m1 + m2;
    prepared[13] = z_0; /* c_0 */
    const double l2 = parameters[4];
    prepared[14] = m2*l2; /* c_1 */
    prepared[15] = m2*(l2*l2); /* c_2 */
    prepared[16] = 2.0*z_0; /* c_3 */
    const double K2 = parameters[7];
    prepared[17] = l2*K2; /* c_4 */
    prepared[18] = m3*(l3*l3); /* c_5 */
    const double l1 = parameters[3];
    prepared[19] = (1.0/10.0)*l1; /* c_6 */
}

/* The assumptions of parameters, coordinates and inputs. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {62, "nonnegative"},
    {62, "nonnegative"},
    {62, "nonnegative"},
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
    const double c_0 = c[13];
    const double theta3 = x[2];
    const double l1 = c[3];
    const double z_0 = theta3 + l1;
    M[0] = c_0*(z_0*z_0);
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double sin_theta1 = em_sin(theta1);
    const double sin_theta2 = em_sin(theta2);
    const double c_1 = c[14];
    M[4] = M[1] = z_0*(cos_theta1*cos_theta2 + sin_theta1*sin_theta2)*c_1;
    const double c_2 = c[15];
    M[5] = c_2;
    M[8] = M[2] = 0.0;
    M[9] = M[6] = (cos_theta2*sin_theta1 - cos_theta1*sin_theta2)*c_1;
    M[10] = c_0;
    M[12] = M[3] = 0.0;
    M[13] = M[7] = 0.0;
    M[14] = M[11] = 0.0;
    const double c_5 = c[18];
    M[15] = c_5;
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
    const double theta3 = x[2];
    const double l1 = c[3];
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    A[0] = (theta3 + l1)*cos_theta1;
    const double l2 = c[4];
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    A[1] = l2*cos_theta2;
    const double sin_theta1 = em_sin(theta1);
    A[2] = sin_theta1;
    A[3] = 0.0;
    b[0] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): the terms that cancel in them; eps terms is their rounding */
EM_EXPORT void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
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

/* J (n_state, n_state) = d rhs / d y */
EM_EXPORT int jacobian(double t, const double *y, const double *c, const double *u, double *J, em_fault *fault)
{
    return em_motion_jacobian(t, y, c, u, 0, J, fault);
}
#endif
#if EM_HOLDS(EM_MODEL)

/* After an accepted step, and at the start: constraints on velocities.
 * Returns 1 if y changed, 0 if not, or -1 and *fault. */
EM_EXPORT int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS];
    settled_masses(y, c, M1, A1, b);
    if (em_keep_root(&block1, M1[0], memory, fault)) return -1;
    if (!(flags & EM_STABILISE)) return 0;

    double B1[N_ROWS][N1], a1[N1];
    em_rows_of_block(&block1, 0, N_ROWS, y, c, memory, A1[0], B1[0]);
    em_take(&block1, y + N, a1);
    em_transposed(N1, memory + 0, a1);

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
    em_velocity_in_run(&block1, 0, y, c, memory, a1);
    em_put(&block1, a1, y + N);
    return 1;
}

/* v (n): xdot from a state. */
EM_EXPORT int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    memcpy(v, y + N, N * sizeof *v);
    return 0;
}

/* ev (n): the error of xdot that follows from an error e (n) of v. */
EM_EXPORT void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    memcpy(ev, e, N * sizeof *ev);
}

/* row (n_state): a state, as a row of the solution. */
EM_EXPORT int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                            em_fault *fault)
{
    memcpy(row, y, N_STATE * sizeof *row);
    return 0;
}

/* y (n_state) from x, v (n) */
EM_EXPORT int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    memcpy(y + N, v, N * sizeof *y);
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
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

#endif
#if EM_HOLDS(EM_STEPPER)
#include "loop/em_handle.h"
#include "inverse_dynamics/em_inverse_dynamics.h"
#include "batch/em_lane_run.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "dual_link.h"

static const char *const coordinate_names[] = { "theta1", "theta2", "theta3", "theta4", NULL };
static const char *const parameter_names[] = { "m1", "m2", "m3", "l1", "l2", "l3", "K1", "K2", "K3", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 1.0, 0.5, 0.7071067811865476, 0.5, 1.0, 1.0, 0.5, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.5235987755982989, 1.0471975511965979, 0.0, 2.356194490192345 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 0, 0, 0, 0 };
static const em_shape shapes[] = {
    {"trace", 0, 2, 0, NULL},
    {"ground", 2, 2, 0, NULL},
    {"ground", 4, 2, 0, NULL},
    {"spring", 6, 4, 0, NULL},
    {"spring", 10, 4, 0, NULL},
    {"line", 14, 4, 0, NULL},
    {"line", 18, 4, 0, NULL},
    {"disk", 22, 3, 0, NULL},
    {"disk", 25, 3, 0, NULL},
    {"disk", 28, 3, 0, NULL}
};
static const em_slice layout[] = {
    {"x", 0, 4},
    {"v", 4, 4}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "a factor of Delta: one constraint, Delta is a number",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dtheta4: M does not depend on it",
    "C, mu, Omega across blocks: {theta1, theta2, theta3}, {theta4} do not couple",
    "C, s, mu, Omega of {theta4}: this block is constant, factored once per parameter set",
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
};

/* Functions of the stepper with this model as an argument. A run: */
static int simulate(em_run *run) { return em_simulate(&dual_link_model, run); }
/* the state within a run: */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&dual_link_model, run, step, t, y);
}
/* the memory of a run: */
static void release(em_run *run) { em_release(&dual_link_model, run); }
/* a run that advances on request: */
static void *open_run(em_run *run) { return em_handle_open(&dual_link_model, run); }
/* the size of its saved state: */
static size_t saved(void) { return em_handle_saved(&dual_link_model); }
/* forces of actuators: */
static int inverse_dynamics(double t, const double *x, const double *v, const double *a, const double *c,
                            const double *u, const em_actuators *actuators, double *forces, double *lambda,
                            double *residual, em_inverse_check *check, em_fault *fault)
{
    return em_inverse_dynamics(&dual_link_model, t, x, v, a, c, u, actuators, forces, lambda, residual,
                               check, fault);
}
/* a run on lanes: */
static void *enter(em_run *run, int *mode) { return em_member_enter(&dual_link_model, run, mode); }

const em_model dual_link_model = {
    .abi = EM_ABI,
    .name = "dual_link",
    .formulation = "lagrange",
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
    .n_layout = 2,
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
    .jacobian = jacobian,
    .motion_jacobian = em_motion_jacobian,
    .simulate = simulate,
    .interpolate = interpolate,
    .release = release,
    .event = model_events,
    .lanes = &dual_link_lanes,
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
    .n_shapes = 10,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .equation_partials = em_equation_partials,
    .constraint_partials = constraint_partials,
    .motion_along = em_motion_along,
    .tangent = em_tangent,
    .dynamics = &dynamics,
    .declared = declared,
    .required_forces = em_required_forces,
    .inverse_dynamics = inverse_dynamics,
};

#endif
#endif
