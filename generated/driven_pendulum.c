/* eigenmotion generate driven_pendulum.py */
/* input sha256:4e9893cc5e7c5dc0d481cf1470a3ef3a5e1a3b84e5f7e00dadf8b82698fb15df */
/* body sha256:499e0e9d94a172f9b867503aac210e4d1efd87e259b06fb27ca2f9aa50aef936 */
/* driven_pendulum: equations of motion, eigenfactor formulation.
 *
 * State, 4 numbers:
 *   x    y[0 .. 2)
 *   eta  y[2 .. 4)
 *
 * Blocks of M that do not couple:
 *   1: x (constant, factored once per parameter set)
 *   2: y (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   a factor of Delta: one constraint, Delta is a number
 *   dM/dx, dM/dy: M does not depend on them
 *   C, mu, Omega across blocks: {x}, {y} do not couple
 *   C, s, mu, Omega of {x}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {y}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 5 additions, 11 multiplications, 2 function calls
 *   projection: 1 additions, 6 multiplications, 2 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 2,                /* coordinates */
    N_ROWS = 1,           /* constraint rows */
    N_POSITIONS = 1,      /* of which holonomic */
    N_STATE = 4,          /* numbers of a state */
    N_C = 0,              /* of which C, */
    N_S = 0,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 0,         /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 5,
    N_PREPARED = 24,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 6,          /* inputs, parameters and the time */
    N_ARGUMENTS = 10,     /* x, v and these: what motion depends on */
    N1 = 1,               /* x */
    N2 = 1,               /* y */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0 };
EM_UNUSED static const int coordinate2[N2] = { 1 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(real t, const real *restrict x, const real *restrict v,
                                  const real *restrict c, real f1[N1], real f2[N2], real A1[N_ROWS][N1],
                                  real A2[N_ROWS][N2], real gamma[N_ROWS])
{
    f1[0] = em_real(0.0);
    const real c_1 = c[14];
    f2[0] = c_1;
    const real x_ = x[0];
    A1[0][0] = 2.0*x_;
    const real y = x[1];
    const real a_ = c[3];
    const real w = c[4];
    const real z_0 = t*w;
    const real cos_z_0 = em_cos(z_0);
    const real z_2 = y - a_*cos_z_0;
    A2[0][0] = 2.0*z_2;
    const real x_dot = v[0];
    const real y_dot = v[1];
    const real sin_z_0 = em_sin(z_0);
    const real c_2 = c[15];
    const real z_4 = sin_z_0*c_2;
    const real z_5 = y_dot + z_4;
    const real c_3 = c[16];
    gamma[0] = 2.0*((x_dot*x_dot + y_dot*z_5) + (z_4*z_5 + cos_z_0*z_2*c_3));
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[2] };
    const real *const C1 = c + 5, *const s1 = c + 6;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* y: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[3] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[2] };
    const real *const C1 = c + 5, *const s1 = c + 6;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* y: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[3] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    real f1[N1], f2[N2], A1[N_ROWS][N1], A2[N_ROWS][N2], gamma[N_ROWS];
    eigenfactor_motion(t, y, dy, c, f1, f2, A1, A2, gamma);

    /* x: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* y: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* x: constant factors, a = S^-1 C f (41) */
    real a1[N1];
    em_rows_on_eta(1, N1, C1, r1, f1, a1);

    /* y: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N1, row, B1[0], a1, NULL, lambda);
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N1, B1[row], B1[column]);
            em_add_product(N2, B2[row], B2[column], &Delta[row*N_ROWS + column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[2] = a1[0];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[3] = a2[0];
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
    real v1[N1] = { e[0] };
    em_velocity_of_eta(N1, c + 5, c + 6, v1);
    v[0] = v1[0];
    real v2[N2] = { e[1] };
    em_velocity_of_eta(N2, c + 9, c + 10, v2);
    v[1] = v2[0];
}

#define EM_VELOCITY velocity_by_roots

#include "em_flock.h"
#endif

extern em_lanes driven_pendulum_lanes;
em_lanes driven_pendulum_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 1,
    N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    bias[0] = 0.0;
    const double c_1 = c[14];
    bias[1] = c_1;
    const double x_dot = v[0];
    const double y_dot = v[1];
    const double w = c[4];
    const double z_0 = t*w;
    const double sin_z_0 = em_sin(z_0);
    const double c_2 = c[15];
    const double z_2 = sin_z_0*c_2;
    const double z_3 = y_dot + z_2;
    const double cos_z_0 = em_cos(z_0);
    const double y = x[1];
    const double a_ = c[3];
    const double c_3 = c[16];
    gamma[0] = 2.0*((x_dot*x_dot + y_dot*z_3) + (z_2*z_3 + cos_z_0*(y - a_*cos_z_0)*c_3));
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double m = c[0];
    const double x_dot = v[0];
    const double y_dot = v[1];
    e[0] = 0.5*(m*(x_dot*x_dot + y_dot*y_dot));
    e[1] = 0.0;
    e[2] = 0.0;
    const double y = x[1];
    const double c_6 = c[19];
    e[3] = y*c_6;
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
    p[0] = p[8] = p[13] = x_;
    const double y = x[1];
    p[1] = p[9] = p[14] = y;
    const double c_7 = c[20];
    p[2] = p[4] = c_7;
    const double c_8 = c[21];
    p[3] = c_8;
    const double a_ = c[3];
    p[5] = a_;
    p[6] = p[10] = 0.0;
    const double w = c[4];
    const double cos_0 = em_cos(t*w);
    p[7] = p[11] = a_*cos_0;
    const double c_9 = c[22];
    p[12] = c_9;
    const double c_10 = c[23];
    p[15] = c_10;
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
    const double lambda_0 = lambda[0];
    D[0] = 2.0*lambda_0;
    D[5] = 2.0*lambda_0;
    const double x_ddot = a[0];
    D[8] = 2.0*x_ddot;
    const double y_ddot = a[1];
    const double a_ = c[3];
    const double w = c[4];
    const double z_0 = t*w;
    const double cos_z_0 = em_cos(z_0);
    D[9] = 2.0*(y_ddot + a_*cos_z_0*(w*w));
    const double x_dot = v[0];
    D[10] = 4.0*x_dot;
    const double y_dot = v[1];
    const double sin_z_0 = em_sin(z_0);
    D[11] = 4.0*(y_dot + a_*w*sin_z_0);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double x_ddot = a[0];
    D[0] = x_ddot;
    const double g = c[2];
    const double y_ddot = a[1];
    D[6] = g + y_ddot;
    const double m = c[0];
    D[8] = m;
    const double w = c[4];
    const double z_0 = t*w;
    const double cos_z_0 = em_cos(z_0);
    const double lambda_0 = lambda[0];
    D[9] = (-2.0)*(cos_z_0*lambda_0);
    const double a_ = c[3];
    const double sin_z_0 = em_sin(z_0);
    const double z_3 = a_*sin_z_0;
    D[10] = 2.0*(t*lambda_0*z_3);
    const double z_4 = a_*w;
    const double z_5 = sin_z_0*z_4;
    D[11] = 2.0*(z_5*lambda_0);
    const double z_6 = w*w;
    const double y = x[1];
    const double z_7 = a_*cos_z_0;
    const double z_8 = y - z_7;
    const double z_9 = cos_z_0*z_8;
    const double y_dot = v[1];
    const double z_10 = y_dot + z_5;
    const double z_11 = y_ddot + z_7*z_6;
    D[15] = 2.0*(z_6*z_9 + 2.0*w*sin_z_0*z_10 - cos_z_0*z_11);
    const double z_12 = 2.0*cos_z_0*z_10*z_4 - sin_z_0*(a_*z_8*z_6 - a_*z_11);
    D[16] = 2.0*(2.0*z_4*z_9 + 2.0*z_10*z_3 + t*z_12);
    D[17] = 2.0*(w*z_12);
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double x_ = x[0];
    D[0] = 2.0*x_;
    const double y = x[1];
    const double a_ = c[3];
    const double w = c[4];
    const double z_0 = t*w;
    const double cos_z_0 = em_cos(z_0);
    const double z_2 = a_*cos_z_0;
    const double z_3 = y - z_2;
    D[1] = 2.0*z_3;
    const double l = c[1];
    D[5] = (-2.0)*l;
    D[7] = (-2.0)*(cos_z_0*z_3);
    const double sin_z_0 = em_sin(z_0);
    const double z_5 = a_*sin_z_0;
    const double z_6 = z_3*z_5;
    D[8] = 2.0*(t*z_6);
    const double z_7 = w*z_3;
    D[9] = 2.0*(z_5*z_7);
    const double x_dot = v[0];
    D[10] = 2.0*x_dot;
    const double y_dot = v[1];
    const double z_8 = y_dot + w*z_5;
    D[11] = 2.0*z_8;
    D[12] = 2.0*x_;
    D[13] = 2.0*z_3;
    D[17] = (-2.0)*(cos_z_0*z_8 - sin_z_0*z_7);
    const double z_9 = z_2*z_7 + z_8*z_5;
    D[18] = 2.0*(z_6 + t*z_9);
    D[19] = 2.0*(w*z_9);
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes driven_pendulum_lanes;
EM_WEAK em_lanes driven_pendulum_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 1 };
EM_ACROSS const double scales[N] = { 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_PREPARED_FACTORS, 5, 6, 7, 8 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 9, 10, 11, 12 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, NULL };

/* M of the constant blocks, and what other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double M1[N1][N1], double M2[N2][N2],
                                  double prepared[N_PREPARED])
{
    const double m = parameters[0];
    M1[0][0] = m;
    M2[0][0] = m;
    const double a_ = parameters[3];
    const double w = parameters[4];
    const double z_0 = a_*w;
    prepared[13] = 2.0*z_0; /* c_0 */
    const double g = parameters[2];
    const double z_1 = m*g;
    prepared[14] = -z_1; /* c_1 */
    prepared[15] = z_0; /* c_2 */
    prepared[16] = a_*(w*w); /* c_3 */
    const double l = parameters[1];
    prepared[17] = l*l; /* c_4 */
    prepared[18] = fabs(a_); /* c_5 */
    prepared[19] = z_1; /* c_6 */
    prepared[20] = ((-1.0/20.0))*l; /* c_7 */
    prepared[21] = -a_; /* c_8 */
    prepared[22] = (1.0/20.0)*l; /* c_9 */
    prepared[23] = (1.0/12.0)*l; /* c_10 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
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
    M[2] = M[1] = 0.0;
    M[3] = m;
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
    const double x_ = x[0];
    A[0] = 2.0*x_;
    const double y = x[1];
    const double a_ = c[3];
    const double w = c[4];
    const double z_0 = t*w;
    const double cos_z_0 = em_cos(z_0);
    const double z_2 = y - a_*cos_z_0;
    A[1] = 2.0*z_2;
    const double c_0 = c[13];
    const double sin_z_0 = em_sin(z_0);
    b[0] = c_0*(z_2*sin_z_0);
}

/* phi (h): the holonomic constraints;  terms (h): what cancels in them, so that eps terms is their rounding */
EM_ACROSS void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
    const double x_ = x[0];
    const double z_0 = x_*x_;
    const double y = x[1];
    const double a_ = c[3];
    const double w = c[4];
    const double z_1 = t*w;
    const double cos_z_1 = em_cos(z_1);
    const double z_3 = y - a_*cos_z_1;
    const double c_4 = c[17];
    phi[0] = z_0 + z_3*z_3 - c_4;
    const double c_5 = c[18];
    const double sin_z_1 = em_sin(z_1);
    terms[0] = 2.0*(z_0 + c_4 + (fabs(y) + c_5*(fabs(cos_z_1) + fabs(z_1*sin_z_1)))*fabs(z_3));
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
EM_INLINE void settled_masses(double t, const double *restrict x, const double *restrict c,
                              double A1[N_ROWS][N1], double A2[N_ROWS][N2], double b[N_ROWS])
{
    const double x_ = x[0];
    A1[0][0] = 2.0*x_;
    const double y = x[1];
    const double a_ = c[3];
    const double w = c[4];
    const double z_0 = t*w;
    const double cos_z_0 = em_cos(z_0);
    const double z_2 = y - a_*cos_z_0;
    A2[0][0] = 2.0*z_2;
    const double c_0 = c[13];
    const double sin_z_0 = em_sin(z_0);
    b[0] = c_0*(z_2*sin_z_0);
}

/* After an accepted step, and at the start: constraints on positions, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int changed = flags & EM_STABILISE;
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double A1[N_ROWS][N1], A2[N_ROWS][N2], b[N_ROWS];
    settled_masses(t, y, c, A1, A2, b);

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

/* v (n): xdot from a state. */
EM_ACROSS int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    if (em_velocity_at(&block1, 0, NULL, y, c, v, fault)) return -1;
    if (em_velocity_at(&block2, 0, NULL, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that an error e (n) of eta makes. */
EM_ACROSS void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, 0, e, y, c, memory, ev);
    em_velocity_kept(&block2, 0, e, y, c, memory, ev);
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
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "driven_pendulum.h"

static const char *const coordinate_names[] = { "x", "y", NULL };
static const char *const parameter_names[] = { "m", "l", "g", "a", "w", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 9.81, 0.25, 5.0, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.7173560908995228, -0.4467067093471654 };
static const double initial_v[N] = { 0.0, 0.0 };
static const int carried[N] = { 0, 0 };
static const em_shape shapes[] = {
    {"trace", 0, 2},
    {"ground", 2, 4},
    {"line", 6, 4},
    {"disk", 10, 3},
    {"disk", 13, 3}
};
static const em_slice layout[] = {
    {"x", 0, 2},
    {"eta", 2, 2}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "a factor of Delta: one constraint, Delta is a number",
    "dM/dx, dM/dy: M does not depend on them",
    "C, mu, Omega across blocks: {x}, {y} do not couple",
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
};

/* What of the stepper is told which model it is of: a run, */
static int simulate(em_run *run) { return em_simulate(&driven_pendulum_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&driven_pendulum_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&driven_pendulum_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&driven_pendulum_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&driven_pendulum_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&driven_pendulum_model, run, mode); }

const em_model driven_pendulum_model = {
    .abi = EM_ABI,
    .name = "driven_pendulum",
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
    .conserves_energy = 0,
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
    .lanes = &driven_pendulum_lanes,
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
