/* eigenmotion generate newtons_cradle.py */
/* input sha256:b7b2f2f815633c0c13ec47b71b8d50d30eeb9cbde0c35a3d76e313769a9245db */
/* body sha256:1a49742a0d247955dbb610c3d983b8ea2943a84498b51fa929e9c9b2bf83c9e4 */
/* newtons_cradle_4: equations of motion, eigenfactor formulation.
 *
 * State, 8 numbers:
 *   x    y[0 .. 4)
 *   eta  y[4 .. 8)
 *
 * Blocks of M that do not couple:
 *   1: theta1 (constant, factored once per parameter set)
 *   2: theta2 (constant, factored once per parameter set)
 *   3: theta3 (constant, factored once per parameter set)
 *   4: theta4 (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dtheta1, dM/dtheta2, dM/dtheta3, dM/dtheta4: M does not depend on them
 *   C, mu, Omega across blocks: {theta1}, {theta2}, {theta3}, {theta4} do not couple
 *   C, s, mu, Omega of {theta1}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {theta2}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {theta3}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {theta4}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 4 multiplications, 4 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#define EM_ACTS
#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 4,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 8,          /* numbers of a state */
    N_C = 0,              /* of which C, */
    N_S = 0,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 3,
    N_MEMORY = 0,         /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
    N_SWITCHES = 0,       /* constraint rows that hold at times */
    N_PARAMETERS = 5,
    N_PREPARED = 27,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_IMPACTS = 3,
    N_RESETS = 0,
    N_OUTPUTS = 0,
    N_GIVEN = 6,          /* inputs, parameters and the time */
    N_ARGUMENTS = 14,     /* x, v and these: what motion depends on */
    N1 = 1,               /* theta1 */
    N2 = 1,               /* theta2 */
    N3 = 1,               /* theta3 */
    N4 = 1,               /* theta4 */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0 };
EM_UNUSED static const int coordinate2[N2] = { 1 };
EM_UNUSED static const int coordinate3[N3] = { 2 };
EM_UNUSED static const int coordinate4[N4] = { 3 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict c, real f1[N1], real f2[N2],
                                  real f3[N3], real f4[N4])
{
    const real c_0 = c[21];
    const real theta1 = x[0];
    const real sin_theta1 = em_sin(theta1);
    f1[0] = -c_0*sin_theta1;
    const real theta2 = x[1];
    const real sin_theta2 = em_sin(theta2);
    f2[0] = -c_0*sin_theta2;
    const real theta3 = x[2];
    const real sin_theta3 = em_sin(theta3);
    f3[0] = -c_0*sin_theta3;
    const real theta4 = x[3];
    const real sin_theta4 = em_sin(theta4);
    f4[0] = -c_0*sin_theta4;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* theta1: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4] };
    const real *const C1 = c + 5, *const s1 = c + 6;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* theta2: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[5] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* theta3: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[6] };
    const real *const C3 = c + 13, *const s3 = c + 14;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];

    /* theta4: xdot = C^T S^-1 eta (20) */
    const real eta4[N4] = { y[7] };
    const real *const C4 = c + 17, *const s4 = c + 18;
    real r4[N4], w4[N4], v4[N4];
    em_velocity(N4, C4, s4, eta4, r4, w4, v4);
    dy[3] = v4[0];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* theta1: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4] };
    const real *const C1 = c + 5, *const s1 = c + 6;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* theta2: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[5] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* theta3: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[6] };
    const real *const C3 = c + 13, *const s3 = c + 14;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];

    /* theta4: xdot = C^T S^-1 eta (20) */
    const real eta4[N4] = { y[7] };
    const real *const C4 = c + 17, *const s4 = c + 18;
    real r4[N4], w4[N4], v4[N4];
    em_velocity(N4, C4, s4, eta4, r4, w4, v4);
    dy[3] = v4[0];

    real f1[N1], f2[N2], f3[N3], f4[N4];
    eigenfactor_motion(y, c, f1, f2, f3, f4);

    /* theta1: constant factors, a = S^-1 C f (41) */
    real a1[N1];
    em_rows_on_eta(1, N1, C1, r1, f1, a1);

    /* theta2: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* theta3: constant factors, a = S^-1 C f (41) */
    real a3[N3];
    em_rows_on_eta(1, N3, C3, r3, f3, a3);

    /* theta4: constant factors, a = S^-1 C f (41) */
    real a4[N4];
    em_rows_on_eta(1, N4, C4, r4, f4, a4);

    /* etadot = a (45) */
    dy[4] = a1[0];
    dy[5] = a2[0];
    dy[6] = a3[0];
    dy[7] = a4[0];
    return 0;
}

/* dy <- f(t, y). */
EM_ACROSS int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags,
                        real *dy, em_fault *fault)
{
    return rhs_eigenfactor(t, y, c, u, memory, flags, dy, fault);
}

#endif
#ifdef EM_ON_LANES

#ifdef EM_ON_DUALS
#include "em_rate_jacobian.h"
#else
/* Compiled with -DEM_ON_LANES this file is its right-hand side on vectors, to be linked beside. */
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

extern em_lanes newtons_cradle_4_lanes;
em_lanes newtons_cradle_4_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, NULL, 0, 1, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double c_0 = c[21];
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    bias[0] = -c_0*sin_theta1;
    const double theta2 = x[1];
    const double sin_theta2 = em_sin(theta2);
    bias[1] = -c_0*sin_theta2;
    const double theta3 = x[2];
    const double sin_theta3 = em_sin(theta3);
    bias[2] = -c_0*sin_theta3;
    const double theta4 = x[3];
    const double sin_theta4 = em_sin(theta4);
    bias[3] = -c_0*sin_theta4;
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double c_1 = c[22];
    const double theta1_dot = v[0];
    const double theta2_dot = v[1];
    const double theta3_dot = v[2];
    const double theta4_dot = v[3];
    e[0] = 0.5*(c_1*(theta1_dot*theta1_dot + theta2_dot*theta2_dot + theta3_dot*theta3_dot +
        theta4_dot*theta4_dot));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c_0 = c[21];
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    const double theta3 = x[2];
    const double cos_theta3 = em_cos(theta3);
    const double theta4 = x[3];
    const double cos_theta4 = em_cos(theta4);
    e[3] = -c_0*(cos_theta1 + cos_theta2 + cos_theta3 + cos_theta4);
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
    p[0] = p[1] = p[5] = p[9] = p[13] = 0.0;
    const double l = c[1];
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    p[2] = p[16] = l*sin_theta1;
    const double cos_theta1 = em_cos(theta1);
    p[3] = p[17] = -l*cos_theta1;
    const double c_3 = c[24];
    p[4] = c_3;
    const double theta2 = x[1];
    const double sin_theta2 = em_sin(theta2);
    p[6] = p[19] = c_3 + l*sin_theta2;
    const double cos_theta2 = em_cos(theta2);
    p[7] = p[20] = -l*cos_theta2;
    const double c_4 = c[25];
    p[8] = c_4;
    const double theta3 = x[2];
    const double sin_theta3 = em_sin(theta3);
    p[10] = p[22] = c_4 + l*sin_theta3;
    const double cos_theta3 = em_cos(theta3);
    p[11] = p[23] = -l*cos_theta3;
    const double c_5 = c[26];
    p[12] = c_5;
    const double theta4 = x[3];
    const double sin_theta4 = em_sin(theta4);
    p[14] = p[25] = c_5 + l*sin_theta4;
    const double cos_theta4 = em_cos(theta4);
    p[15] = p[26] = -l*cos_theta4;
    const double r = c[4];
    p[18] = p[21] = p[24] = p[27] = r;
}

/* struck: what strikes at each impact: N = dphi/dx, dphi/dt, the restitution */
EM_ACROSS void impacts(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                       const double *restrict u, double *restrict struck)
{
    const double c_2 = c[23];
    struck[0] = c_2;
    const double l = c[1];
    struck[1] = l;
    struck[2] = 0.0;
    struck[3] = 0.0;
    struck[4] = 0.0;
    const double e = c[3];
    struck[5] = e;
    struck[6] = 0.0;
    struck[7] = c_2;
    struck[8] = l;
    struck[9] = 0.0;
    struck[10] = 0.0;
    struck[11] = e;
    struck[12] = 0.0;
    struck[13] = 0.0;
    struck[14] = c_2;
    struck[15] = l;
    struck[16] = 0.0;
    struck[17] = e;
}

/* after: x, and v or the quasi-velocities, after each reset */
EM_ACROSS void resets(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      const double *restrict u, double *restrict after)
{
}

/* level: for each row that holds at times, up to which speed of parting or force of sliding, and of sticking */
EM_ACROSS void levels(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      const double *restrict u, double *restrict level)
{
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
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta1 = x[0];
    const double cos_theta1 = em_cos(theta1);
    const double g = c[2];
    const double m = c[0];
    const double l = c[1];
    const double z_1 = g*(m*l);
    D[0] = cos_theta1*z_1;
    const double theta2 = x[1];
    const double cos_theta2 = em_cos(theta2);
    D[9] = cos_theta2*z_1;
    const double theta3 = x[2];
    const double cos_theta3 = em_cos(theta3);
    D[18] = cos_theta3*z_1;
    const double theta4 = x[3];
    const double cos_theta4 = em_cos(theta4);
    D[27] = cos_theta4*z_1;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double theta1_ddot = a[0];
    const double l = c[1];
    const double z_0 = l*l;
    const double theta1 = x[0];
    const double sin_theta1 = em_sin(theta1);
    const double g = c[2];
    const double z_2 = l*g;
    D[0] = theta1_ddot*z_0 + sin_theta1*z_2;
    const double m = c[0];
    const double z_3 = m*l;
    const double z_4 = m*g;
    D[1] = 2.0*theta1_ddot*z_3 + sin_theta1*z_4;
    D[2] = sin_theta1*z_3;
    const double theta2_ddot = a[1];
    const double theta2 = x[1];
    const double sin_theta2 = em_sin(theta2);
    D[6] = theta2_ddot*z_0 + sin_theta2*z_2;
    D[7] = 2.0*theta2_ddot*z_3 + sin_theta2*z_4;
    D[8] = sin_theta2*z_3;
    const double theta3_ddot = a[2];
    const double theta3 = x[2];
    const double sin_theta3 = em_sin(theta3);
    D[12] = theta3_ddot*z_0 + sin_theta3*z_2;
    D[13] = 2.0*theta3_ddot*z_3 + sin_theta3*z_4;
    D[14] = sin_theta3*z_3;
    const double theta4_ddot = a[3];
    const double theta4 = x[3];
    const double sin_theta4 = em_sin(theta4);
    D[18] = theta4_ddot*z_0 + sin_theta4*z_2;
    D[19] = 2.0*theta4_ddot*z_3 + sin_theta4*z_4;
    D[20] = sin_theta4*z_3;
}

/* D (n_events, n_arguments) */
EM_RARE /* no explicit step calls it */
EM_ACROSS void event_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_EVENTS * N_ARGUMENTS);
    const double l = c[1];
    D[0] = -l;
    D[1] = l;
    const double theta1 = x[0];
    const double theta2 = x[1];
    D[9] = -(theta1 - theta2);
    D[15] = -l;
    D[16] = l;
    const double theta3 = x[2];
    D[23] = -(theta2 - theta3);
    D[30] = -l;
    D[31] = l;
    const double theta4 = x[3];
    D[37] = -(theta3 - theta4);
}

/* D (n + m, n_arguments), at fixed a, lambda, of M a + A^T lambda and A a */
EM_RARE /* no explicit step calls it */
EM_ACROSS void blow_partials(double t, const double *restrict x, const double *restrict a,
                             const double *restrict lambda, const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_ARGUMENTS);
    const double theta1_ddot = a[0];
    const double l = c[1];
    const double z_0 = l*l;
    D[8] = theta1_ddot*z_0;
    const double m = c[0];
    const double z_1 = m*l;
    D[9] = 2.0*(theta1_ddot*z_1);
    const double theta2_ddot = a[1];
    D[22] = theta2_ddot*z_0;
    D[23] = 2.0*(theta2_ddot*z_1);
    const double theta3_ddot = a[2];
    D[36] = theta3_ddot*z_0;
    D[37] = 2.0*(theta3_ddot*z_1);
    const double theta4_ddot = a[3];
    D[50] = theta4_ddot*z_0;
    D[51] = 2.0*(theta4_ddot*z_1);
}

/* D (n_impacts (n + 2), n_arguments), of N, dphi/dt and the restitution */
EM_RARE /* no explicit step calls it */
EM_ACROSS void impact_partials(double t, const double *restrict x, const double *restrict v,
                               const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_IMPACTS * (N + 2) * N_ARGUMENTS);
    D[9] = -1.0;
    D[23] = 1.0;
    D[81] = 1.0;
    D[107] = -1.0;
    D[121] = 1.0;
    D[165] = 1.0;
    D[205] = -1.0;
    D[219] = 1.0;
    D[249] = 1.0;
}

/* D (n_resets 2 n, n_arguments) */
EM_RARE /* no explicit step calls it */
EM_ACROSS void reset_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
}

/* D (n_switches 2, n_arguments) */
EM_RARE /* no explicit step calls it */
EM_ACROSS void level_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes newtons_cradle_4_lanes;
EM_WEAK em_lanes newtons_cradle_4_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 1, 2, 3 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_PREPARED_FACTORS, 5, 6, 7, 8 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 9, 10, 11, 12 };
static const em_block block3 = { N, N3, coordinate3, scales, EM_PREPARED_FACTORS, 13, 14, 15, 16 };
static const em_block block4 = { N, N4, coordinate4, scales, EM_PREPARED_FACTORS, 17, 18, 19, 20 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, &block3, &block4, NULL };

/* M of the constant blocks, and what other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double M1[N1][N1], double M2[N2][N2],
                                  double M3[N3][N3], double M4[N4][N4], double prepared[N_PREPARED])
{
    const double m = parameters[0];
    const double l = parameters[1];
    M1[0][0] = m*(l*l);
    M2[0][0] = m*(l*l);
    M3[0][0] = m*(l*l);
    M4[0][0] = m*(l*l);
    const double g = parameters[2];
    prepared[21] = m*l*g; /* c_0 */
    prepared[22] = m*(l*l); /* c_1 */
    prepared[23] = -l; /* c_2 */
    const double r = parameters[4];
    prepared[24] = 2.0*r; /* c_3 */
    prepared[25] = 4.0*r; /* c_4 */
    prepared[26] = 6.0*r; /* c_5 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {63, ""},
    {62, "nonnegative"},
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
    double M1[N1][N1], M2[N2][N2], M3[N3][N3], M4[N4][N4];
    prepared_constants(parameters, M1, M2, M3, M4, c);
    if (em_prepare(&block1, M1[0], c, fault)) return -1;
    if (em_prepare(&block2, M2[0], c, fault)) return -1;
    if (em_prepare(&block3, M3[0], c, fault)) return -1;
    if (em_prepare(&block4, M4[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_ACROSS void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double c_1 = c[22];
    M[0] = c_1;
    M[4] = M[1] = 0.0;
    M[5] = c_1;
    M[8] = M[2] = 0.0;
    M[9] = M[6] = 0.0;
    M[10] = c_1;
    M[12] = M[3] = 0.0;
    M[13] = M[7] = 0.0;
    M[14] = M[11] = 0.0;
    M[15] = c_1;
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
    const double l = c[1];
    const double theta1 = x[0];
    const double theta2 = x[1];
    crossing[0] = -l*(theta1 - theta2);
    const double theta3 = x[2];
    crossing[1] = -l*(theta2 - theta3);
    const double theta4 = x[3];
    crossing[2] = -l*(theta3 - theta4);
}

/* What each event does: impact, reset, the contact that it closes or opens; whether it happens at zero, too; whether it
 * acts. */
EM_ACROSS const em_deed deeds[] = { {0, -1, -1, 1, 1}, {1, -1, -1, 1, 1}, {2, -1, -1, 1, 1} };
EM_ACROSS const int resets_quasi[] = { 0 };
/* Rows that hold at times: their event, their parameter, that of sliding, what presses, their number, their
 * parameter of being idle; whether Poisson's law holds; the first parameter of the shift of a cone, else -1 */
EM_ACROSS const em_switch switches[] = { {-1, -1, -1, -1, -1, -1, 0, -1} };

#endif
#if !EM_ALONE(EM_ASIDE) && !EM_ALONE(EM_RHS)
#include "em_redundant.h"
#endif
#if EM_HOLDS(EM_DERIVATIVES)
#include "em_derivatives.h"
#include "em_acts.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* After an accepted step, and at the start: nothing to do.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    return 0;
}

/* v (n): xdot from a state. */
EM_ACROSS int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    if (em_velocity_at(&block1, 0, NULL, y, c, v, fault)) return -1;
    if (em_velocity_at(&block2, 0, NULL, y, c, v, fault)) return -1;
    if (em_velocity_at(&block3, 0, NULL, y, c, v, fault)) return -1;
    if (em_velocity_at(&block4, 0, NULL, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that an error e (n) of eta makes. */
EM_ACROSS void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, 0, e, y, c, memory, ev);
    em_velocity_kept(&block2, 0, e, y, c, memory, ev);
    em_velocity_kept(&block3, 0, e, y, c, memory, ev);
    em_velocity_kept(&block4, 0, e, y, c, memory, ev);
}

/* row (n_state): a state, as a row of the solution. */
EM_ACROSS int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                            em_fault *fault)
{
    memcpy(row, y, N_STATE * sizeof *row);
    return 0;
}

/* y (n_state) from x, v (n) */
EM_ACROSS int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault)
{
    double C[N*N] = {0.0}, s[N], eta[N];
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
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
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

#endif
#if EM_HOLDS(EM_STEPPER)
#include "em_handle.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "newtons_cradle_4.h"

static const char *const coordinate_names[] = { "theta1", "theta2", "theta3", "theta4", NULL };
static const char *const parameter_names[] = { "m", "l", "g", "e", "r", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { "1 on 2", "2 on 3", "3 on 4", NULL };
static const int event_direction[] = { -1, -1, -1, 0 };
static const int event_terminal[] = { 0, 0, 0, 0 };
static const double parameter_defaults[] = { 0.1, 0.2, 9.81, 1.0, 0.02, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { -0.5, 0.0, 0.0, 0.0 };
static const double initial_v[N] = { 0.0, 0.0, 0.0, 0.0 };
static const int carried[N] = { 0, 0, 0, 0 };
static const em_shape shapes[] = {
    {"line", 0, 4},
    {"line", 4, 4},
    {"line", 8, 4},
    {"line", 12, 4},
    {"disk", 16, 3},
    {"disk", 19, 3},
    {"disk", 22, 3},
    {"disk", 25, 3}
};
static const em_slice layout[] = {
    {"x", 0, 4},
    {"eta", 4, 4}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dtheta1, dM/dtheta2, dM/dtheta3, dM/dtheta4: M does not depend on them",
    "C, mu, Omega across blocks: {theta1}, {theta2}, {theta3}, {theta4} do not couple",
    "C, s, mu, Omega of {theta1}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {theta2}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {theta3}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {theta4}: this block is constant, factored once per parameter set",
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
    .settles = 0,
    .rhs = model_rhs,
    .settle = model_settle,
    .velocity = model_velocity,
    .velocity_error = model_velocity_error,
    .publish = model_publish,
    .events = model_events,
    .factored = factored,
    .acceleration = em_acceleration,
    .act = em_act,
    .watch_modes = em_watch_modes,
};

/* What of the stepper is told which model it is of: a run, */
static int simulate(em_run *run) { return em_simulate(&newtons_cradle_4_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&newtons_cradle_4_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&newtons_cradle_4_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&newtons_cradle_4_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&newtons_cradle_4_model); }

const em_model newtons_cradle_4_model = {
    .abi = EM_ABI,
    .name = "newtons_cradle_4",
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
    .n_layout = 2,
    .n_left_out = 11,
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
    .event = em_watched,
    .deeds = deeds,
    .n_switches = N_SWITCHES,
    .switches = switches,
    .lanes = &newtons_cradle_4_lanes,
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
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .event_partials = em_watched_partials,
    .motion_along = em_motion_along,
    .act_along = em_act_along,
    .dynamics = &dynamics,
    .declared = declared,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
