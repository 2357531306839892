/* eigenmotion generate snakeboard.py */
/* input sha256:d70ece58f05e5f9e65f4727d2ec66dffb4d52447c0fb6fbf54b7fa75292c5627 */
/* body sha256:a4d93e240406ebd25f43ca292e161086b2074e27129a31a09432af53187a99a5 */
/* snakeboard: equations of motion, eigenfactor formulation.
 *
 * State, 10 numbers:
 *   x    y[0 .. 5)
 *   eta  y[5 .. 10)
 *
 * Blocks of M that do not couple:
 *   1: x (constant, factored once per parameter set)
 *   2: y (constant, factored once per parameter set)
 *   3: theta, psi (constant, factored once per parameter set)
 *   4: phi (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   dV/dx: there is no potential energy
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dx, dM/dy, dM/dtheta, dM/dpsi, dM/dphi: M does not depend on them
 *   C, mu, Omega across blocks: {x}, {y}, {theta, psi}, {phi} do not couple
 *   C, s, mu, Omega of {x}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {y}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {theta, psi}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {phi}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 10 additions, 16 multiplications, 4 function calls
 *   projection: 4 additions, 5 multiplications, 4 function calls
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
    N_STATE = 10,         /* numbers of a state */
    N_C = 0,              /* of which C, */
    N_S = 0,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 2,
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
    N_PREPARED = 33,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 8,          /* inputs, parameters and the time */
    N_ARGUMENTS = 18,     /* x, v and these: what motion depends on */
    N1 = 1,               /* x */
    N2 = 1,               /* y */
    N3 = 2,               /* theta, psi */
    N4 = 1,               /* phi */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0 };
EM_UNUSED static const int coordinate2[N2] = { 1 };
EM_UNUSED static const int coordinate3[N3] = { 2, 3 };
EM_UNUSED static const int coordinate4[N4] = { 4 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  const real *restrict u, real f1[N1], real f2[N2], real f3[N3], real f4[N4],
                                  real A1[N_ROWS][N1], real A2[N_ROWS][N2], real A3[N_ROWS][N3],
                                  real gamma[N_ROWS])
{
    f1[0] = em_real(0.0);
    f2[0] = em_real(0.0);
    f3[0] = em_real(0.0);
    const real swing = u[0];
    f3[1] = swing;
    const real steer = u[1];
    f4[0] = steer;
    const real phi = x[4];
    const real sin_phi = em_sin(phi);
    const real theta = x[2];
    const real cos_theta = em_cos(theta);
    const real z_2 = sin_phi*cos_theta;
    const real cos_phi = em_cos(phi);
    const real sin_theta = em_sin(theta);
    const real z_5 = cos_phi*sin_theta;
    const real z_6 = z_2 + z_5;
    A1[0][0] = -z_6;
    const real z_7 = z_2 - z_5;
    A1[1][0] = z_7;
    const real z_8 = cos_phi*cos_theta;
    const real z_9 = sin_phi*sin_theta;
    const real z_10 = z_8 - z_9;
    A2[0][0] = z_10;
    const real z_11 = z_8 + z_9;
    A2[1][0] = z_11;
    const real l = c[1];
    const real z_12 = l*cos_phi;
    A3[0][0] = z_12;
    A3[0][1] = em_real(0.0);
    A3[1][0] = -z_12;
    A3[1][1] = em_real(0.0);
    const real theta_dot = v[2];
    const real phi_dot = v[4];
    const real z_13 = theta_dot*phi_dot*l*sin_phi;
    const real x_dot = v[0];
    const real z_14 = theta_dot + phi_dot;
    const real y_dot = v[1];
    gamma[0] = -(z_13 + x_dot*z_14*z_10 + y_dot*z_14*z_6);
    const real z_15 = theta_dot - phi_dot;
    gamma[1] = z_13 + y_dot*z_15*z_7 - x_dot*z_15*z_11;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5] };
    const real *const C1 = c + 5, *const s1 = c + 6;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* y: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[6] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* theta, psi: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[7], y[8] };
    const real *const C3 = c + 13, *const s3 = c + 17;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];
    dy[3] = v3[1];

    /* phi: xdot = C^T S^-1 eta (20) */
    const real eta4[N4] = { y[9] };
    const real *const C4 = c + 25, *const s4 = c + 26;
    real r4[N4], w4[N4], v4[N4];
    em_velocity(N4, C4, s4, eta4, r4, w4, v4);
    dy[4] = v4[0];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5] };
    const real *const C1 = c + 5, *const s1 = c + 6;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* y: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[6] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* theta, psi: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[7], y[8] };
    const real *const C3 = c + 13, *const s3 = c + 17;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];
    dy[3] = v3[1];

    /* phi: xdot = C^T S^-1 eta (20) */
    const real eta4[N4] = { y[9] };
    const real *const C4 = c + 25, *const s4 = c + 26;
    real r4[N4], w4[N4], v4[N4];
    em_velocity(N4, C4, s4, eta4, r4, w4, v4);
    dy[4] = v4[0];

    real f1[N1], f2[N2], f3[N3], f4[N4], A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, u, f1, f2, f3, f4, A1, A2, A3, gamma);

    /* x: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* y: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* theta, psi: B = A C^T S^-1 (28) */
    real B3[N_ROWS][N3];
    em_rows_on_eta(N_ROWS, N3, C3, r3, A3[0], B3[0]);

    /* x: constant factors, a = S^-1 C f (41) */
    real a1[N1];
    em_rows_on_eta(1, N1, C1, r1, f1, a1);

    /* y: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* theta, psi: constant factors, a = S^-1 C f (41) */
    real a3[N3];
    em_rows_on_eta(1, N3, C3, r3, f3, a3);

    /* phi: constant factors, a = S^-1 C f (41) */
    real a4[N4];
    em_rows_on_eta(1, N4, C4, r4, f4, a4);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
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

    /* etadot = a - B^T lambda (45) */
    em_subtract_reactions(N_ROWS, N1, B1[0], lambda, a1);
    dy[5] = a1[0];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[6] = a2[0];
    em_subtract_reactions(N_ROWS, N3, B3[0], lambda, a3);
    dy[7] = a3[0];
    dy[8] = a3[1];
    dy[9] = a4[0];
    return 0;
}

/* dy <- f(t, y). */
EM_ACROSS int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags,
                        real *dy, em_fault *fault)
{
    return rhs_eigenfactor(t, y, c, u, memory, flags, dy, fault);
}

#endif
#if EM_HOLDS(EM_MODEL) && !defined(EM_NODES_ALONE)

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real A1[N_ROWS][N1],
                              real A2[N_ROWS][N2], real A3[N_ROWS][N3], real b[N_ROWS])
{
    const real phi = x[4];
    const real sin_phi = em_sin(phi);
    const real theta = x[2];
    const real cos_theta = em_cos(theta);
    const real z_2 = sin_phi*cos_theta;
    const real cos_phi = em_cos(phi);
    const real sin_theta = em_sin(theta);
    const real z_5 = cos_phi*sin_theta;
    A1[0][0] = -(z_2 + z_5);
    A1[1][0] = z_2 - z_5;
    const real z_6 = cos_phi*cos_theta;
    const real z_7 = sin_phi*sin_theta;
    A2[0][0] = z_6 - z_7;
    A2[1][0] = z_6 + z_7;
    const real l = c[1];
    const real z_8 = l*cos_phi;
    A3[0][0] = z_8;
    A3[0][1] = em_real(0.0);
    A3[1][0] = -z_8;
    A3[1][1] = em_real(0.0);
    b[0] = em_real(0.0);
    b[1] = em_real(0.0);
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
    real v3[N3] = { e[2], e[3] };
    em_velocity_of_eta(N3, c + 13, c + 17, v3);
    v[2] = v3[0];
    v[3] = v3[1];
    real v4[N4] = { e[4] };
    em_velocity_of_eta(N4, c + 25, c + 26, v4);
    v[4] = v4[0];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: constraints on velocities.
 * *done becomes 0 in lanes that are settled number by number instead;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], b[N_ROWS];
    settled_masses(y, c, A1, A2, A3, b);

    real B1[N_ROWS][N1];
    em_rows_of_factors(N_ROWS, N1, c + 5, c + 6, A1[0], B1[0]);
    real a1[N1] = { y[5] };
    real B2[N_ROWS][N2];
    em_rows_of_factors(N_ROWS, N2, c + 9, c + 10, A2[0], B2[0]);
    real a2[N2] = { y[6] };
    real B3[N_ROWS][N3];
    em_rows_of_factors(N_ROWS, N3, c + 13, c + 17, A3[0], B3[0]);
    real a3[N3] = { y[7], y[8] };

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
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes snakeboard_lanes;
em_lanes snakeboard_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 1, N_PREPARED };
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
    bias[1] = 0.0;
    bias[2] = 0.0;
    const double swing = u[0];
    bias[3] = swing;
    const double steer = u[1];
    bias[4] = steer;
    const double theta_dot = v[2];
    const double phi_dot = v[4];
    const double l = c[1];
    const double phi = x[4];
    const double sin_phi = em_sin(phi);
    const double z_1 = theta_dot*phi_dot*l*sin_phi;
    const double x_dot = v[0];
    const double z_2 = theta_dot + phi_dot;
    const double cos_phi = em_cos(phi);
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double z_5 = cos_phi*cos_theta;
    const double sin_theta = em_sin(theta);
    const double z_7 = sin_phi*sin_theta;
    const double y_dot = v[1];
    const double z_8 = sin_phi*cos_theta;
    const double z_9 = cos_phi*sin_theta;
    gamma[0] = -(z_1 + x_dot*z_2*(z_5 - z_7) + y_dot*z_2*(z_8 + z_9));
    const double z_10 = theta_dot - phi_dot;
    gamma[1] = z_1 + y_dot*z_10*(z_8 - z_9) - x_dot*z_10*(z_5 + z_7);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double m = c[0];
    const double x_dot = v[0];
    const double y_dot = v[1];
    const double theta_dot = v[2];
    const double c_0 = c[29];
    const double psi_dot = v[3];
    const double J_rotor = c[3];
    const double c_1 = c[30];
    const double phi_dot = v[4];
    e[0] = 0.5*(m*(x_dot*x_dot) + m*(y_dot*y_dot) + theta_dot*(theta_dot*c_0 + psi_dot*J_rotor) +
        psi_dot*(J_rotor*(theta_dot + psi_dot)) + c_1*(phi_dot*phi_dot));
    e[1] = 0.0;
    e[2] = 0.0;
    e[3] = 0.0;
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
    p[0] = p[18] = x_;
    const double y = x[1];
    p[1] = p[19] = y;
    const double l = c[1];
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double z_1 = l*cos_theta;
    p[2] = x_ - z_1;
    const double sin_theta = em_sin(theta);
    const double z_3 = l*sin_theta;
    p[3] = y - z_3;
    p[4] = x_ + z_1;
    p[5] = y + z_3;
    const double phi = x[4];
    const double cos_phi = em_cos(phi);
    const double z_5 = cos_phi*cos_theta;
    const double sin_phi = em_sin(phi);
    const double z_7 = sin_phi*sin_theta;
    const double z_8 = l*(z_5 - z_7);
    const double c_2 = c[31];
    const double z_9 = cos_theta*c_2;
    const double z_10 = x_ + (1.0/5.0)*z_9;
    p[6] = (1.0/5.0)*(5.0*z_10 - z_8);
    const double z_11 = sin_phi*cos_theta;
    const double z_12 = cos_phi*sin_theta;
    const double z_13 = l*(z_11 + z_12);
    const double z_14 = sin_theta*c_2;
    const double z_15 = y + (1.0/5.0)*z_14;
    p[7] = (1.0/5.0)*(5.0*z_15 - z_13);
    p[8] = (1.0/5.0)*(z_8 + 5.0*z_10);
    p[9] = (1.0/5.0)*(z_13 + 5.0*z_15);
    const double z_16 = l*(z_5 + z_7);
    const double z_17 = x_ - (1.0/5.0)*z_9;
    p[10] = (1.0/5.0)*(5.0*z_17 - z_16);
    const double z_18 = l*(z_11 - z_12);
    const double z_19 = y - (1.0/5.0)*z_14;
    p[11] = (1.0/5.0)*(z_18 + 5.0*z_19);
    p[12] = (1.0/5.0)*(z_16 + 5.0*z_17);
    p[13] = (1.0/5.0)*(5.0*z_19 - z_18);
    const double psi = x[3];
    const double z_20 = theta + psi;
    const double cos_z_20 = em_cos(z_20);
    const double z_22 = l*cos_z_20;
    p[14] = 0.5*(2.0*x_ - z_22);
    const double sin_z_20 = em_sin(z_20);
    const double z_24 = l*sin_z_20;
    p[15] = 0.5*(2.0*y - z_24);
    p[16] = 0.5*(2.0*x_ + z_22);
    p[17] = 0.5*(2.0*y + z_24);
    const double c_3 = c[32];
    p[20] = c_3;
    p[21] = z_20;
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
    const double phi = x[4];
    const double cos_phi = em_cos(phi);
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double z_2 = cos_phi*cos_theta;
    const double sin_phi = em_sin(phi);
    const double sin_theta = em_sin(theta);
    const double z_5 = sin_phi*sin_theta;
    const double z_6 = z_2 - z_5;
    const double lambda_0 = lambda[0];
    const double z_7 = z_6*lambda_0;
    const double z_8 = z_2 + z_5;
    const double lambda_1 = lambda[1];
    const double z_9 = z_8*lambda_1;
    D[2] = -(z_7 + z_9);
    D[4] = -(z_7 - z_9);
    const double z_10 = sin_phi*cos_theta;
    const double z_11 = cos_phi*sin_theta;
    const double z_12 = z_10 + z_11;
    const double z_13 = z_12*lambda_0;
    const double z_14 = z_10 - z_11;
    const double z_15 = z_14*lambda_1;
    D[12] = -(z_13 - z_15);
    D[14] = -(z_13 + z_15);
    const double l = c[1];
    const double z_16 = l*sin_phi;
    D[24] = -(lambda_0*z_16 - lambda_1*z_16);
    const double x_dot = v[0];
    const double theta_dot = v[2];
    const double phi_dot = v[4];
    const double z_17 = theta_dot + phi_dot;
    const double z_18 = z_17*z_12;
    const double y_dot = v[1];
    const double z_19 = z_17*z_6;
    const double z_20 = x_dot*z_18 - y_dot*z_19;
    const double x_ddot = a[0];
    const double y_ddot = a[1];
    const double z_21 = z_6*x_ddot + z_12*y_ddot;
    D[52] = z_20 - z_21;
    const double z_22 = theta_dot*phi_dot*l*cos_phi;
    const double theta_ddot = a[2];
    const double z_23 = theta_ddot*z_16;
    D[54] = (z_20 - z_22) - (z_21 + z_23);
    D[55] = -z_19;
    D[56] = -z_18;
    const double z_24 = phi_dot*z_16;
    const double z_25 = y_dot*z_12 + x_dot*z_6;
    D[57] = -(z_24 + z_25);
    const double z_26 = theta_dot*z_16;
    D[59] = -(z_26 + z_25);
    const double z_27 = theta_dot - phi_dot;
    const double z_28 = z_27*z_14;
    const double z_29 = z_27*z_8;
    const double z_30 = x_dot*z_28 + y_dot*z_29;
    const double z_31 = z_8*x_ddot - z_14*y_ddot;
    D[62] = -(z_30 + z_31);
    D[64] = (z_22 + z_30) + (z_23 + z_31);
    D[65] = -z_29;
    D[66] = z_28;
    const double z_32 = y_dot*z_14 - x_dot*z_8;
    D[67] = z_24 + z_32;
    D[69] = z_26 - z_32;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double x_ddot = a[0];
    D[2] = x_ddot;
    const double y_ddot = a[1];
    D[10] = y_ddot;
    const double phi = x[4];
    const double cos_phi = em_cos(phi);
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    D[19] = cos_phi*lambda_0 - cos_phi*lambda_1;
    const double theta_ddot = a[2];
    D[20] = theta_ddot;
    const double psi_ddot = a[3];
    D[21] = theta_ddot + psi_ddot;
    D[22] = 2.0*theta_ddot;
    D[24] = -1.0;
    D[29] = theta_ddot + psi_ddot;
    D[33] = -1.0;
    const double phi_ddot = a[4];
    D[38] = 2.0*phi_ddot;
    const double theta_dot = v[2];
    const double phi_dot = v[4];
    const double sin_phi = em_sin(phi);
    const double z_2 = theta_dot*phi_dot*sin_phi - cos_phi*theta_ddot;
    D[43] = -z_2;
    D[51] = z_2;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double y_dot = v[1];
    const double phi = x[4];
    const double sin_phi = em_sin(phi);
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double z_2 = sin_phi*cos_theta;
    const double cos_phi = em_cos(phi);
    const double sin_theta = em_sin(theta);
    const double z_5 = cos_phi*sin_theta;
    const double z_6 = z_2 + z_5;
    const double x_dot = v[0];
    const double z_7 = cos_phi*cos_theta;
    const double z_8 = sin_phi*sin_theta;
    const double z_9 = z_7 - z_8;
    const double z_10 = y_dot*z_6 + x_dot*z_9;
    D[2] = -z_10;
    const double theta_dot = v[2];
    const double l = c[1];
    const double z_11 = theta_dot*l*sin_phi;
    D[4] = -(z_11 + z_10);
    D[5] = -z_6;
    D[6] = z_9;
    const double z_12 = l*cos_phi;
    D[7] = z_12;
    const double z_13 = theta_dot*cos_phi;
    D[13] = z_13;
    const double z_14 = z_2 - z_5;
    const double z_15 = z_7 + z_8;
    const double z_16 = y_dot*z_14 - x_dot*z_15;
    D[20] = z_16;
    D[22] = z_11 - z_16;
    D[23] = z_14;
    D[24] = z_15;
    D[25] = -z_12;
    D[31] = -z_13;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes snakeboard_lanes;
EM_WEAK em_lanes snakeboard_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 1, 2, 2, 3 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_PREPARED_FACTORS, 5, 6, 7, 8 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 9, 10, 11, 12 };
static const em_block block3 = { N, N3, coordinate3, scales, EM_PREPARED_FACTORS, 13, 17, 19, 23 };
static const em_block block4 = { N, N4, coordinate4, scales, EM_PREPARED_FACTORS, 25, 26, 27, 28 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, &block3, &block4, NULL };

/* M of the constant blocks, and what other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double M1[N1][N1], double M2[N2][N2],
                                  double M3[N3][N3], double M4[N4][N4], double prepared[N_PREPARED])
{
    const double m = parameters[0];
    M1[0][0] = m;
    M2[0][0] = m;
    const double J = parameters[2];
    const double J_rotor = parameters[3];
    const double J_wheels = parameters[4];
    M3[0][0] = J + J_rotor + 2.0*J_wheels;
    M3[0][1] = M3[1][0] = J_rotor;
    M3[1][1] = J_rotor;
    M4[0][0] = 2.0*J_wheels;
    prepared[29] = J + J_rotor + 2.0*J_wheels; /* c_0 */
    prepared[30] = 2.0*J_wheels; /* c_1 */
    const double l = parameters[1];
    prepared[31] = 5.0*l; /* c_2 */
    prepared[32] = 0.25*l; /* c_3 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
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
    const double m = c[0];
    M[0] = m;
    M[5] = M[1] = 0.0;
    M[6] = m;
    M[10] = M[2] = 0.0;
    M[11] = M[7] = 0.0;
    const double c_0 = c[29];
    M[12] = c_0;
    M[15] = M[3] = 0.0;
    M[16] = M[8] = 0.0;
    const double J_rotor = c[3];
    M[17] = M[13] = J_rotor;
    M[18] = J_rotor;
    M[20] = M[4] = 0.0;
    M[21] = M[9] = 0.0;
    M[22] = M[14] = 0.0;
    M[23] = M[19] = 0.0;
    const double c_1 = c[30];
    M[24] = c_1;
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
    const double phi = x[4];
    const double sin_phi = em_sin(phi);
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double z_2 = sin_phi*cos_theta;
    const double cos_phi = em_cos(phi);
    const double sin_theta = em_sin(theta);
    const double z_5 = cos_phi*sin_theta;
    A[0] = -(z_2 + z_5);
    const double z_6 = cos_phi*cos_theta;
    const double z_7 = sin_phi*sin_theta;
    A[1] = z_6 - z_7;
    const double l = c[1];
    const double z_8 = l*cos_phi;
    A[2] = z_8;
    A[3] = 0.0;
    A[4] = 0.0;
    A[5] = z_2 - z_5;
    A[6] = z_6 + z_7;
    A[7] = -z_8;
    A[8] = 0.0;
    A[9] = 0.0;
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

/* After an accepted step, and at the start: constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int changed = flags & EM_STABILISE;
    real A1[N_ROWS][N1], A2[N_ROWS][N2], A3[N_ROWS][N3], b[N_ROWS];
    settled_masses(y, c, A1, A2, A3, b);

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
#include "em_member.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "snakeboard.h"

static const char *const coordinate_names[] = { "x", "y", "theta", "psi", "phi", NULL };
static const char *const parameter_names[] = { "m", "l", "J", "J_rotor", "J_wheels", NULL };
static const char *const input_names[] = { "swing", "steer", NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 6.0, 0.2, 0.016, 0.072, 0.0013, 0.0 };
static const double input_defaults[] = { 0.0, 0.0, 0.0 };
static const double initial_x[N] = { 0.0, 0.0, 0.0, 0.0, 0.2 };
static const double initial_v[N] = { 0.5, 0.0, 0.5067750887716812, 3.0, -0.1 };
static const int carried[N] = { 0, 0, 0, 0, 0 };
static const em_shape shapes[] = {
    {"trace", 0, 2},
    {"line", 2, 4},
    {"line", 6, 4},
    {"line", 10, 4},
    {"line", 14, 4},
    {"disk", 18, 4}
};
static const em_slice layout[] = {
    {"x", 0, 5},
    {"eta", 5, 5}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "dV/dx: there is no potential energy",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dx, dM/dy, dM/dtheta, dM/dpsi, dM/dphi: M does not depend on them",
    "C, mu, Omega across blocks: {x}, {y}, {theta, psi}, {phi} do not couple",
    "C, s, mu, Omega of {x}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {y}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {theta, psi}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {phi}: this block is constant, factored once per parameter set",
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
static int simulate(em_run *run) { return em_simulate(&snakeboard_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&snakeboard_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&snakeboard_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&snakeboard_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&snakeboard_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&snakeboard_model, run, mode); }

const em_model snakeboard_model = {
    .abi = EM_ABI,
    .name = "snakeboard",
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
    .lanes = &snakeboard_lanes,
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
