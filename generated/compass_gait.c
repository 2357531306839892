/* eigenmotion generate compass_gait.py */
/* input sha256:56edeb7e4db8895b2d2cf8f221a89a13715f4c291bcea9a7fcf319590b9c2400 */
/* body sha256:6585eea68a4829dd710d19205992c8694fddb5d2d592f5e46f71b0986a627cf6 */
/* compass_gait: equations of motion, eigenfactor formulation.
 *
 * State, 10 numbers:
 *   x    y[0 .. 2)
 *   eta  y[2 .. 4)
 *   C    y[4 .. 8)
 *   s    y[8 .. 10)
 *
 * Blocks of M that do not couple:
 *   1: theta, phi (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dtheta: M does not depend on it
 *
 * Operations of the straight-line part:
 *   eigenfactor: 14 additions, 28 multiplications, 4 function calls
 *   triangular root: 17 additions, 31 multiplications, 4 function calls
 *   projection: 7 additions, 11 multiplications, 2 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#define EM_ACTS
#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 2,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 10,         /* numbers of a state */
    N_C = 4,              /* of which C, */
    N_S = 2,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 1,
    N_MEMORY = 6,         /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
    N_SWITCHES = 0,       /* constraint rows that hold at times */
    N_PARAMETERS = 5,
    N_PREPARED = 22,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_IMPACTS = 0,
    N_RESETS = 1,
    N_OUTPUTS = 0,
    N_GIVEN = 6,          /* inputs, parameters and the time */
    N_ARGUMENTS = 10,     /* x, v and these: what motion depends on */
    N1 = 2,               /* theta, phi */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1])
{
    const real c_2 = c[7];
    const real phi_dot = v[1];
    const real phi = x[1];
    const real sin_phi = em_sin(phi);
    const real z_1 = phi_dot*sin_phi;
    const real cos_phi = em_cos(phi);
    const real z_3 = cos_phi*z_1;
    const real l = c[2];
    const real c_1 = c[6];
    const real z_4 = (l - l*cos_phi)*c_1;
    const real c_3 = c[8];
    const real z_5 = (c_2*z_3 - z_1*z_4) - c_3*z_3;
    Mdot1[0][0] = c_2*z_1 - z_5;
    Mdot1[0][1] = Mdot1[1][0] = -(-z_5);
    Mdot1[1][1] = em_real(0.0);
    const real theta = x[0];
    const real sin_theta = em_sin(theta);
    const real c_4 = c[9];
    const real cos_theta = em_cos(theta);
    const real c_5 = c[10];
    const real c_6 = c[11];
    const real c_7 = c[12];
    const real z_8 = c_6*(sin_phi*cos_theta - cos_phi*sin_theta) + c_7*(cos_phi*cos_theta + sin_phi*sin_theta);
    f1[0] = sin_theta*c_4 + z_8 - cos_theta*c_5;
    const real theta_dot = v[0];
    const real z_9 = theta_dot*theta_dot;
    const real z_10 = z_9 - 2.0*theta_dot*phi_dot;
    const real z_11 = cos_phi*z_10;
    f1[1] = 0.5*(sin_phi*(z_10*z_4 - l*(c_1*(-(z_9 - z_11)))) + c_3*(sin_phi*z_11) - 2.0*z_8);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* theta, phi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[2], y[3] };
    const real *const C1 = y + 4, *const s1 = y + 8;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* theta, phi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[2], y[3] };
    const real *const C1 = y + 4, *const s1 = y + 8;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    real Mdot1[N1][N1], f1[N1];
    eigenfactor_motion(y, dy, c, Mdot1, f1);

    /* theta, phi: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 4, *const s1_dot = dy + 8;
    em_factor_rates(N1, C1, r1, mu1, Omega1, C1_dot, s1_dot);
    /* a = S^-1 (C f - Omega S eta - Sdot eta) (41) */
    real a1[N1];
    em_turning_push(N1, C1, T1, s1, r1, Omega1, s1_dot, eta1, w1, f1, a1, NULL);

    /* etadot = a (45) */
    dy[2] = a1[0];
    dy[3] = a1[1];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[3])
{
    const real c_0 = c[5];
    const real l = c[2];
    const real phi = x[1];
    const real cos_phi = em_cos(phi);
    const real c_1 = c[6];
    const real z_1 = (l - l*cos_phi)*c_1;
    const real c_2 = c[7];
    const real sin_phi = em_sin(phi);
    const real z_3 = c_2*(sin_phi*sin_phi) - cos_phi*z_1;
    M1[0][0] = c_0 + z_1 + z_3;
    M1[1][0] = -z_3;
    M1[1][1] = c_2;
    shared[0] = sin_phi;
    shared[1] = cos_phi;
    shared[2] = z_1;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void triangular_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                 const real shared[3], real Mdot1[N1][N1], real f1[N1])
{
    const real c_2 = c[7];
    const real phi_dot = v[1];
    const real sin_phi = shared[0];
    const real z_4 = phi_dot*sin_phi;
    const real cos_phi = shared[1];
    const real z_5 = cos_phi*z_4;
    const real z_1 = shared[2];
    const real c_3 = c[8];
    const real z_6 = (c_2*z_5 - z_1*z_4) - c_3*z_5;
    Mdot1[0][0] = c_2*z_4 - z_6;
    Mdot1[0][1] = Mdot1[1][0] = -(-z_6);
    Mdot1[1][1] = em_real(0.0);
    const real theta = x[0];
    const real sin_theta = em_sin(theta);
    const real c_4 = c[9];
    const real cos_theta = em_cos(theta);
    const real c_5 = c[10];
    const real c_6 = c[11];
    const real c_7 = c[12];
    const real z_9 = c_6*(sin_phi*cos_theta - cos_phi*sin_theta) + c_7*(cos_phi*cos_theta + sin_phi*sin_theta);
    f1[0] = sin_theta*c_4 + z_9 - cos_theta*c_5;
    const real theta_dot = v[0];
    const real z_10 = theta_dot*theta_dot;
    const real z_11 = z_10 - 2.0*theta_dot*phi_dot;
    const real l = c[2];
    const real c_1 = c[6];
    const real z_12 = cos_phi*z_11;
    f1[1] = 0.5*(sin_phi*(z_1*z_11 - l*(c_1*(-(z_10 - z_12)))) + c_3*(sin_phi*z_12) - 2.0*z_9);
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[3];
    triangular_masses(y, c, M1, shared);

    /* theta, phi: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[2], y[3] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];

    real Mdot1[N1][N1], f1[N1];
    triangular_motion(y, dy, c, shared, Mdot1, f1);

    /* theta, phi: a = L^-1 f - Phi eta */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* etadot = a (45) */
    dy[2] = a1[0];
    dy[3] = a1[1];
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

extern em_lanes compass_gait_lanes;
em_lanes compass_gait_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, NULL, 0, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double c_4 = c[9];
    const double cos_theta = em_cos(theta);
    const double c_5 = c[10];
    const double c_6 = c[11];
    const double phi = x[1];
    const double sin_phi = em_sin(phi);
    const double cos_phi = em_cos(phi);
    const double c_7 = c[12];
    const double z_4 = c_6*(sin_phi*cos_theta - cos_phi*sin_theta) + c_7*(cos_phi*cos_theta + sin_phi*sin_theta);
    const double theta_dot = v[0];
    const double c_2 = c[7];
    const double phi_dot = v[1];
    const double z_5 = phi_dot*sin_phi;
    const double z_6 = cos_phi*z_5;
    const double l = c[2];
    const double c_1 = c[6];
    const double z_7 = (l - l*cos_phi)*c_1;
    const double c_3 = c[8];
    const double z_8 = (c_2*z_6 - z_5*z_7) - c_3*z_6;
    const double z_9 = -z_8;
    bias[0] = (sin_theta*c_4 + z_4 - cos_theta*c_5) - (theta_dot*(c_2*z_5 - z_8) - phi_dot*z_9);
    const double z_10 = theta_dot*theta_dot;
    const double z_11 = z_10 - 2.0*theta_dot*phi_dot;
    const double z_12 = cos_phi*z_11;
    bias[1] = 0.5*((sin_phi*(z_11*z_7 - l*(c_1*(-(z_10 - z_12)))) + c_3*(sin_phi*z_12) - 2.0*z_4) +
        2.0*theta_dot*z_9);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double theta_dot = v[0];
    const double c_0 = c[5];
    const double l = c[2];
    const double phi = x[1];
    const double cos_phi = em_cos(phi);
    const double c_1 = c[6];
    const double z_1 = (l - l*cos_phi)*c_1;
    const double c_2 = c[7];
    const double sin_phi = em_sin(phi);
    const double z_3 = c_2*(sin_phi*sin_phi) - cos_phi*z_1;
    const double phi_dot = v[1];
    e[0] = 0.5*(theta_dot*(theta_dot*(c_0 + z_1 + z_3) - phi_dot*z_3) - phi_dot*(theta_dot*z_3 - phi_dot*c_2));
    e[1] = 0.0;
    e[2] = 0.0;
    const double g = c[3];
    const double c_8 = c[13];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double c_9 = c[14];
    const double m = c[1];
    const double cos_theta = em_cos(theta);
    const double c_10 = c[15];
    e[3] = g*(c_8*(sin_theta*c_9 + m*(l*(sin_theta + (sin_phi*cos_theta - cos_phi*sin_theta)))) +
        c_10*(c_9*cos_theta + m*(l*(cos_theta - (cos_phi*cos_theta + sin_phi*sin_theta)))));
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
    p[0] = p[1] = 0.0;
    const double l = c[2];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    p[2] = p[4] = p[8] = -l*sin_theta;
    const double cos_theta = em_cos(theta);
    p[3] = p[5] = p[9] = l*cos_theta;
    const double phi = x[1];
    const double sin_phi = em_sin(phi);
    const double cos_phi = em_cos(phi);
    p[6] = p[11] = -l*(sin_theta + (sin_phi*cos_theta - cos_phi*sin_theta));
    p[7] = p[12] = l*(cos_theta - (cos_phi*cos_theta + sin_phi*sin_theta));
    const double c_15 = c[20];
    p[10] = c_15;
    const double c_16 = c[21];
    p[13] = c_16;
}

/* struck: what strikes at each impact: N = dphi/dx, dphi/dt, the restitution */
EM_ACROSS void impacts(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                       const double *restrict u, double *restrict struck)
{
}

/* after: x, and v or the quasi-velocities, after each reset */
EM_ACROSS void resets(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      const double *restrict u, double *restrict after)
{
    const double phi = x[1];
    const double theta = x[0];
    after[0] = -(phi - theta);
    after[1] = -phi;
    const double M = c[0];
    const double c_11 = c[16];
    const double theta_dot = v[0];
    const double cos_theta = em_cos(theta);
    const double cos_phi = em_cos(phi);
    const double sin_phi = em_sin(phi);
    const double sin_theta = em_sin(theta);
    const double z_4 = cos_phi*cos_theta + sin_phi*sin_theta;
    const double z_5 = sin_phi*cos_theta - cos_phi*sin_theta;
    const double z_6 = c_11*(theta_dot*(cos_theta*z_4) - theta_dot*(sin_theta*z_5));
    const double c_12 = c[17];
    const double l = c[2];
    const double z_7 = l*(cos_theta - z_4);
    const double z_8 = l*(sin_theta + z_5);
    const double z_9 = l*(cos_theta*z_7 + sin_theta*z_8);
    const double z_10 = z_9*z_9;
    const double c_2 = c[7];
    const double c_13 = c[18];
    const double c_0 = c[5];
    const double m = c[1];
    const double z_11 = 1.0/(c_0 + m*(z_7*z_7 + z_8*z_8));
    const double z_12 = z_6*z_11/(c_2 - c_13*z_11*z_10);
    after[2] = (M*z_6 + c_12*z_10*z_12)*z_11;
    const double c_14 = c[19];
    after[3] = z_9*c_14*z_12;
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
    const double l = c[2];
    const double m = c[1];
    const double phi = x[1];
    const double sin_phi = em_sin(phi);
    const double z_1 = m*sin_phi;
    const double z_2 = l*l*z_1;
    const double cos_phi = em_cos(phi);
    const double z_4 = cos_phi*z_2;
    const double z_5 = z_4 - 0.5*(z_4 - l*(l - l*cos_phi)*z_1);
    dM[4] = z_2 + 2.0*z_5;
    dM[6] = dM[5] = -(2.0*z_5);
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double gamma = c[4];
    const double cos_gamma = em_cos(gamma);
    const double g = c[3];
    const double M = c[0];
    const double l = c[2];
    const double z_2 = g*(M*l);
    const double m = c[1];
    const double z_3 = l*m;
    const double z_4 = g*z_3;
    const double z_5 = cos_gamma*z_4;
    const double sin_theta = em_sin(theta);
    const double sin_gamma = em_sin(gamma);
    const double z_8 = sin_gamma*z_4;
    const double phi = x[1];
    const double cos_phi = em_cos(phi);
    const double sin_phi = em_sin(phi);
    const double z_11 = z_5*(cos_phi*cos_theta + sin_phi*sin_theta) - z_8*(sin_phi*cos_theta - cos_phi*sin_theta);
    D[0] = -(cos_theta*(cos_gamma*z_2 + z_5) + sin_theta*(sin_gamma*z_2 + z_8) - z_11);
    const double theta_dot = v[0];
    const double phi_dot = v[1];
    const double z_12 = m*(l*l);
    const double z_13 = cos_phi*z_12;
    const double z_14 = sin_phi*sin_phi;
    const double z_15 = phi_dot*z_12;
    const double z_16 = z_14*z_15;
    const double z_17 = cos_phi*cos_phi;
    const double z_18 = z_16 - z_17*z_15;
    const double z_19 = (l - l*cos_phi)*z_3;
    const double z_20 = phi_dot*z_19;
    const double z_21 = z_18 - 0.5*(z_18 + (z_16 + cos_phi*z_20));
    const double z_22 = 2.0*z_21;
    const double z_23 = sin_phi*z_13;
    const double z_24 = z_23 - 0.5*(z_23 - sin_phi*z_19);
    const double z_25 = sin_phi*z_12 + 2.0*z_24;
    const double theta_ddot = a[0];
    const double z_26 = 2.0*z_24;
    const double phi_ddot = a[1];
    D[1] = -((z_11 - (theta_dot*(phi_dot*z_13 - 2.0*z_21) + phi_dot*z_22)) - (z_25*theta_ddot - z_26*phi_ddot));
    const double z_27 = phi_dot*z_23;
    const double z_28 = z_27 - 0.5*(z_27 - sin_phi*z_20);
    D[2] = sin_phi*z_15 + 2.0*z_28;
    const double z_29 = 2.0*z_28;
    D[3] = theta_dot*z_25 - (z_29 + phi_dot*z_26);
    D[4] = -z_11;
    const double z_30 = theta_dot*theta_dot;
    const double z_31 = z_30 - 2.0*theta_dot*phi_dot;
    const double z_32 = z_31*z_12;
    const double z_33 = z_14*z_32;
    const double z_34 = cos_phi*z_3;
    D[5] = 0.5*(((2.0*z_11 + 2.0*(z_33 - z_17*z_32) - (2.0*z_33 + cos_phi*(z_31*z_19 - l*(z_31*z_34 - z_30*z_3))))
        + 2.0*theta_dot*z_22) - 2.0*z_26*theta_ddot);
    const double z_35 = theta_dot - phi_dot;
    D[6] = -(z_29 + (2.0*z_35*z_23 + sin_phi*(z_35*z_19 + l*(theta_dot*z_3 - z_35*z_34))));
    D[7] = (2.0*theta_dot*z_23 + sin_phi*(theta_dot*z_19 - theta_dot*z_13)) - theta_dot*z_26;
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double theta_ddot = a[0];
    const double l = c[2];
    const double z_0 = l*l;
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double g = c[3];
    const double gamma = c[4];
    const double sin_gamma = em_sin(gamma);
    const double z_3 = g*sin_gamma;
    const double z_4 = l*z_3;
    const double sin_theta = em_sin(theta);
    const double cos_gamma = em_cos(gamma);
    const double z_7 = g*cos_gamma;
    const double z_8 = l*z_7;
    const double z_9 = cos_theta*z_4 - sin_theta*z_8;
    D[0] = theta_ddot*z_0 + z_9;
    const double phi = x[1];
    const double cos_phi = em_cos(phi);
    const double sin_phi = em_sin(phi);
    const double z_12 = cos_phi*cos_theta + sin_phi*sin_theta;
    const double z_13 = sin_phi*cos_theta - cos_phi*sin_theta;
    const double z_14 = z_12*z_4 + z_13*z_8;
    const double theta_dot = v[0];
    const double phi_dot = v[1];
    const double z_15 = phi_dot*sin_phi;
    const double z_16 = cos_phi*z_15;
    const double z_17 = z_0*z_16;
    const double z_18 = l - l*cos_phi;
    const double z_19 = l*z_18;
    const double z_20 = z_17 + 0.5*(z_19*z_15 - z_17);
    const double z_21 = 2.0*z_20;
    const double z_22 = sin_phi*sin_phi;
    const double z_23 = cos_phi*z_19 - z_0*z_22;
    const double phi_ddot = a[1];
    D[1] = ((z_9 - z_14) + (theta_dot*(z_0*z_15 + 2.0*z_20) - phi_dot*z_21)) - (theta_ddot*(z_23 - z_19) -
        phi_ddot*z_23);
    const double m = c[1];
    const double z_24 = m*z_3;
    const double M = c[0];
    const double z_25 = m*z_7;
    const double z_26 = z_24*z_12 + z_25*z_13;
    const double z_27 = l*m;
    const double z_28 = z_27*z_16;
    const double z_29 = m*z_18;
    const double z_30 = (1.0 - cos_phi)*z_27;
    const double z_31 = z_28 - 0.25*(2.0*z_28 - (z_29*z_15 + z_30*z_15));
    const double z_32 = 4.0*z_31;
    const double z_33 = M*l;
    const double z_34 = z_22*z_27 - 0.5*(cos_phi*z_29 + cos_phi*z_30);
    const double z_35 = 2.0*z_34;
    D[2] = ((cos_theta*(z_24 + M*z_3) - sin_theta*(z_25 + M*z_7) - z_26) + (theta_dot*(2.0*z_27*z_15 + 4.0*z_31) -
        phi_dot*z_32)) + (theta_ddot*(2.0*z_33 + (z_29 + z_30) + 2.0*z_34) - phi_ddot*z_35);
    const double z_36 = sin_gamma*z_27;
    const double z_37 = cos_gamma*z_27;
    const double z_38 = z_12*z_36 + z_13*z_37;
    D[3] = cos_theta*(z_36 + z_33*sin_gamma) - sin_theta*(z_37 + z_33*cos_gamma) - z_38;
    const double z_39 = z_27*z_7;
    const double z_40 = z_27*z_3;
    const double z_41 = z_39*z_12 - z_40*z_13;
    D[4] = cos_theta*(z_33*z_7 + z_39) + sin_theta*(z_33*z_3 + z_40) - z_41;
    const double z_42 = theta_dot*theta_dot;
    const double z_43 = z_42 - 2.0*theta_dot*phi_dot;
    const double z_44 = cos_phi*z_43;
    const double z_45 = sin_phi*z_44;
    D[7] = (-0.5)*(((2.0*z_0*z_45 + sin_phi*(z_43*z_19 + l*(l*z_42 - l*z_44)) - 2.0*z_14) + 2.0*theta_dot*z_21) -
        2.0*(phi_ddot*z_0 + theta_ddot*z_23));
    D[8] = (-0.5)*(((4.0*z_27*z_45 + sin_phi*((z_43*z_29 + z_43*z_30) - ((z_27*z_44 - z_42*z_27) - l*(m*z_42 -
        m*z_44))) - 2.0*z_26) + 2.0*theta_dot*z_32) - 2.0*(2.0*phi_ddot*z_27 - theta_ddot*z_35));
    D[9] = z_38;
    D[10] = z_41;
}

/* D (n_events, n_arguments) */
EM_RARE /* no explicit step calls it */
EM_ACROSS void event_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_EVENTS * N_ARGUMENTS);
    D[0] = -2.0;
    D[1] = 1.0;
}

/* D (n + m, n_arguments), at fixed a, lambda, of M a + A^T lambda and A a */
EM_RARE /* no explicit step calls it */
EM_ACROSS void blow_partials(double t, const double *restrict x, const double *restrict a,
                             const double *restrict lambda, const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_ARGUMENTS);
    const double m = c[1];
    const double phi = x[1];
    const double sin_phi = em_sin(phi);
    const double l = c[2];
    const double z_1 = l*l;
    const double z_2 = sin_phi*z_1;
    const double cos_phi = em_cos(phi);
    const double z_4 = m*cos_phi;
    const double z_5 = z_4*z_2;
    const double z_6 = l*cos_phi;
    const double z_7 = l - z_6;
    const double z_8 = l*m;
    const double z_9 = z_5 - 0.5*(z_5 - z_7*sin_phi*z_8);
    const double theta_ddot = a[0];
    const double z_10 = 2.0*z_9;
    const double phi_ddot = a[1];
    D[1] = (m*z_2 + 2.0*z_9)*theta_ddot - z_10*phi_ddot;
    D[4] = theta_ddot*z_1;
    const double z_11 = sin_phi*sin_phi;
    const double z_12 = z_6*z_7 - z_1*z_11;
    D[5] = -(theta_ddot*(z_12 - l*z_7) - phi_ddot*z_12);
    const double M = c[0];
    const double z_13 = (1.0 - cos_phi)*z_8;
    const double z_14 = z_11*z_8 - 0.5*(z_7*z_4 + cos_phi*z_13);
    const double z_15 = 2.0*z_14;
    D[6] = theta_ddot*(2.0*M*l + (m*z_7 + z_13) + 2.0*z_14) - phi_ddot*z_15;
    D[11] = -z_10*theta_ddot;
    D[15] = phi_ddot*z_1 + theta_ddot*z_12;
    D[16] = 2.0*phi_ddot*z_8 - theta_ddot*z_15;
}

/* D (n_impacts (n + 2), n_arguments), of N, dphi/dt and the restitution */
EM_RARE /* no explicit step calls it */
EM_ACROSS void impact_partials(double t, const double *restrict x, const double *restrict v,
                               const double *restrict c, const double *restrict u, double *restrict D)
{
}

/* D (n_resets 2 n, n_arguments) */
EM_RARE /* no explicit step calls it */
EM_ACROSS void reset_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_RESETS * 2 * N * N_ARGUMENTS);
    D[0] = 1.0;
    D[1] = -1.0;
    D[11] = -1.0;
    const double M = c[0];
    const double theta_dot = v[0];
    const double l = c[2];
    const double z_0 = l*l;
    const double z_1 = theta_dot*z_0;
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double phi = x[1];
    const double cos_phi = em_cos(phi);
    const double sin_phi = em_sin(phi);
    const double sin_theta = em_sin(theta);
    const double z_6 = cos_phi*cos_theta + sin_phi*sin_theta;
    const double z_7 = cos_theta*z_6;
    const double z_8 = sin_phi*cos_theta - cos_phi*sin_theta;
    const double z_9 = sin_theta*z_8;
    const double z_10 = z_1*z_7 - z_1*z_9;
    const double z_11 = M*z_10;
    const double m = c[1];
    const double z_12 = l*cos_theta;
    const double z_13 = l*z_6;
    const double z_14 = z_12 - z_13;
    const double z_15 = l*sin_theta;
    const double z_16 = l*z_8;
    const double z_17 = z_15 + z_16;
    const double z_18 = z_14*z_14 + z_17*z_17;
    const double z_19 = M*z_0 + m*z_18;
    const double z_20 = 1.0/z_19;
    const double z_21 = m*m;
    const double z_22 = z_12*z_14 + z_15*z_17;
    const double z_23 = z_22*z_22;
    const double z_24 = z_21*z_23;
    const double z_25 = z_20*z_24;
    const double z_26 = m*z_0 - z_25;
    const double z_27 = 1.0/z_26;
    const double z_28 = z_11*z_27;
    const double z_29 = z_19*z_19;
    const double z_30 = 1.0/z_29;
    const double z_31 = (z_11 + z_25*z_28)*z_30;
    const double z_32 = z_16*z_14 + z_17*z_13;
    const double z_33 = m*z_32;
    const double z_34 = sin_theta*z_6;
    const double z_35 = cos_theta*z_8;
    const double z_36 = z_1*z_34 + z_1*z_35;
    const double z_37 = z_30*z_28;
    const double z_38 = z_24*z_37;
    const double z_39 = M*z_27;
    const double z_40 = z_25*z_39;
    const double z_41 = z_0*z_35 + z_0*z_34;
    const double z_42 = z_22*z_20;
    const double z_43 = z_21*z_42;
    const double z_44 = z_41*z_43;
    const double z_45 = z_30*z_24;
    const double z_46 = z_33*z_45 - z_44;
    const double z_47 = z_11/(z_26*z_26);
    const double z_48 = z_25*z_47;
    D[21] = -(2.0*z_31*z_33 + (M*z_36 + (2.0*z_38*z_33 + z_36*z_40 + 2.0*z_46*z_48 - 2.0*z_44*z_28))*z_20);
    const double z_49 = z_0*z_9 - z_0*z_7;
    D[22] = -(M*z_49 + z_49*z_40)*z_20;
    const double z_50 = z_10*z_27;
    const double z_51 = z_47*(z_0/(z_19*z_29));
    D[24] = -(z_0*z_31 - (z_10 + (z_25*z_50 - z_0*z_38 - z_21*z_21*(z_23*z_23)*z_51))*z_20);
    const double z_52 = m*z_20;
    const double z_53 = z_28*z_52;
    const double z_54 = z_0 - (2.0*z_23*z_52 - z_18*z_45);
    D[25] = -(z_18*z_31 - (2.0*z_23*z_53 - z_18*z_38 - z_54*z_48)*z_20);
    const double z_55 = cos_theta - z_6;
    const double z_56 = sin_theta + z_8;
    const double z_57 = M*l + m*(z_14*z_55 + z_17*z_56);
    const double z_58 = theta_dot*z_15*z_8 - theta_dot*z_12*z_6;
    const double z_59 = (cos_theta*z_14 + z_12*z_55) + (sin_theta*z_17 + z_15*z_56);
    const double z_60 = z_59*z_43;
    const double z_61 = l*m + (z_57*z_45 - z_60);
    D[26] = (-2.0)*(z_57*z_31 + (M*z_58 + (z_57*z_38 + z_58*z_40 + z_61*z_48 - z_60*z_28))*z_20);
    const double z_62 = m*z_42;
    const double z_63 = z_62*z_39;
    const double z_64 = z_47*z_62;
    D[31] = -(2.0*z_22*z_32*z_21*z_37 + z_36*z_63 + 2.0*z_46*z_64 - z_41*z_53);
    D[32] = -z_49*z_63;
    const double z_65 = m*z_22;
    const double z_66 = z_37*z_65;
    D[34] = z_62*z_50 - z_0*z_66 - z_24*z_65*z_51;
    D[35] = z_28*z_42 - z_18*z_66 - z_54*z_64;
    D[36] = -(2.0*z_57*z_66 + 2.0*z_58*z_63 + 2.0*z_61*z_64 - z_59*z_53);
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
extern em_lanes compass_gait_lanes;
EM_WEAK em_lanes compass_gait_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 4, 8, 0, 4 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double M = parameters[0];
    const double l = parameters[2];
    const double z_0 = l*l;
    prepared[5] = M*z_0; /* c_0 */
    const double m = parameters[1];
    prepared[6] = l*m; /* c_1 */
    const double z_1 = m*z_0;
    prepared[7] = z_1; /* c_2 */
    prepared[8] = 2.0*z_1; /* c_3 */
    const double gamma = parameters[4];
    const double cos_gamma = em_cos(gamma);
    const double g = parameters[3];
    const double z_3 = l*g;
    const double z_4 = M*z_3;
    const double z_5 = m*z_3;
    const double z_6 = cos_gamma*z_5;
    prepared[9] = cos_gamma*z_4 + z_6; /* c_4 */
    const double sin_gamma = em_sin(gamma);
    const double z_8 = sin_gamma*z_5;
    prepared[10] = sin_gamma*z_4 + z_8; /* c_5 */
    prepared[11] = z_6; /* c_6 */
    prepared[12] = z_8; /* c_7 */
    prepared[13] = sin_gamma; /* c_8 */
    prepared[14] = M*l; /* c_9 */
    prepared[15] = cos_gamma; /* c_10 */
    prepared[16] = z_0; /* c_11 */
    const double z_9 = m*m;
    prepared[17] = M*z_9; /* c_12 */
    prepared[18] = z_9; /* c_13 */
    prepared[19] = M*m; /* c_14 */
    prepared[20] = (1.0/20.0)*l; /* c_15 */
    prepared[21] = (1.0/40.0)*l; /* c_16 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
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
    const double c_0 = c[5];
    const double l = c[2];
    const double phi = x[1];
    const double cos_phi = em_cos(phi);
    const double c_1 = c[6];
    const double z_1 = (l - l*cos_phi)*c_1;
    const double c_2 = c[7];
    const double sin_phi = em_sin(phi);
    const double z_3 = c_2*(sin_phi*sin_phi) - cos_phi*z_1;
    M[0] = c_0 + z_1 + z_3;
    M[2] = M[1] = -z_3;
    M[3] = c_2;
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
    const double phi = x[1];
    const double theta = x[0];
    crossing[0] = phi - 2.0*theta;
}

/* What each event does: impact, reset, the contact that it closes or opens; whether it happens at zero, too; whether it
 * acts. */
EM_ACROSS const em_deed deeds[] = { {-1, 0, -1, 0, 1} };
EM_ACROSS const int resets_quasi[] = { 0, 0 };
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

/* M of the blocks that vary */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1], real shared[3])
{
    const real c_0 = c[5];
    const real l = c[2];
    const real phi = x[1];
    const real cos_phi = em_cos(phi);
    const real c_1 = c[6];
    const real z_1 = (l - l*cos_phi)*c_1;
    const real c_2 = c[7];
    const real sin_phi = em_sin(phi);
    const real z_3 = c_2*(sin_phi*sin_phi) - cos_phi*z_1;
    M1[0][0] = c_0 + z_1 + z_3;
    M1[0][1] = M1[1][0] = -z_3;
    M1[1][1] = c_2;
    shared[0] = sin_phi;
    shared[1] = cos_phi;
    shared[2] = z_1;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[3],
                             real Mdot1[N1][N1])
{
    const real c_2 = c[7];
    const real phi_dot = v[1];
    const real sin_phi = shared[0];
    const real z_4 = phi_dot*sin_phi;
    const real cos_phi = shared[1];
    const real z_5 = cos_phi*z_4;
    const real z_1 = shared[2];
    const real c_3 = c[8];
    const real z_6 = (c_2*z_5 - z_1*z_4) - c_3*z_5;
    Mdot1[0][0] = c_2*z_4 - z_6;
    Mdot1[0][1] = Mdot1[1][0] = -(-z_6);
    Mdot1[1][1] = em_real(0.0);
}

/* After an accepted step, and at the start: C and s.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    real M1[N1][N1], shared[3];
    settled_masses(y, c, M1, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 8);
    int wanted = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (wanted == EM_LOOK) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        double time = em_time_of_block(&block1, Mdot1[0], y);
        wanted = em_mode_by_time(*mode, gap, time, pace);
    }
    if (*mode != wanted) {
        if (em_change_mode(&block1, wanted, M1[0], y, memory, fault)) return -1;
        *mode = wanted;
        changed = 1;
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
    em_spread(N, N1, coordinate1, y + 4, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 4);
    for (int i = 0; i < N1; ++i) y[8 + i] = s[coordinate1[i]];
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
#endif
#if EM_HOLDS(EM_MODEL)

#include "compass_gait.h"

static const char *const coordinate_names[] = { "theta", "phi", NULL };
static const char *const parameter_names[] = { "M", "m", "l", "g", "gamma", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { "heel strike", NULL };
static const int event_direction[] = { 1, 0 };
static const int event_terminal[] = { 0, 0 };
static const double parameter_defaults[] = { 1000.0, 1.0, 1.0, 1.0, 0.009, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.2, 0.4 };
static const double initial_v[N] = { -0.2, -0.0158 };
static const int carried[N] = { 1, 1 };
static const em_shape shapes[] = {
    {"line", 0, 4},
    {"line", 4, 4},
    {"disk", 8, 3},
    {"disk", 11, 3}
};
static const em_slice layout[] = {
    {"x", 0, 2},
    {"eta", 2, 2},
    {"C", 4, 4},
    {"s", 8, 2}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dtheta: M does not depend on it",
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
    .worst_factors = em_worst_factors_of,
    .act = em_act,
    .watch_modes = em_watch_modes,
};

/* What of the stepper is told which model it is of: a run, */
static int simulate(em_run *run) { return em_simulate(&compass_gait_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&compass_gait_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&compass_gait_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&compass_gait_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&compass_gait_model); }

const em_model compass_gait_model = {
    .abi = EM_ABI,
    .name = "compass_gait",
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
    .event = em_watched,
    .deeds = deeds,
    .n_switches = N_SWITCHES,
    .switches = switches,
    .lanes = &compass_gait_lanes,
    .open = open_run,
    .advance = em_handle_advance,
    .now = em_handle_now,
    .publish = em_handle_publish,
    .saved = saved,
    .save = em_handle_save,
    .restore = em_handle_restore,
    .close = em_handle_close,
    .again = em_handle_again,
    .n_shapes = 4,
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
