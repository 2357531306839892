/* eigenmotion generate governor.py */
/* input sha256:202dd52e577d65d0bddec872924c315ac3164fbae4484a324e9d7f2fd425c856 */
/* body sha256:878ac730688581db155d1172636914ff2b222210aef203c2aa2d36bccac4388f */
/* governor: equations of motion, eigenfactor formulation.
 *
 * State, 8 numbers:
 *   x    y[0 .. 4)
 *   eta  y[4 .. 8)
 *
 * Blocks of M that do not couple:
 *   1: phi (s = sqrt(M) in closed form)
 *   2: a1 (constant, factored once per parameter set)
 *   3: a2 (constant, factored once per parameter set)
 *   4: s (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dphi, dM/ds: M does not depend on them
 *   C, mu, Omega across blocks: {phi}, {a1}, {a2}, {s} do not couple
 *   C, Omega of {phi}: one coordinate, s = sqrt(M) in closed form
 *   C, s, mu, Omega of {a1}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {a2}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {s}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 29 additions, 61 multiplications, 4 divisions, 2 roots, 4 function calls
 *   projection: 4 additions, 6 multiplications, 2 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

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
    N_EVENTS = 0,
    N_MEMORY = 2,         /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 9,
    N_PREPARED = 35,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 10,         /* inputs, parameters and the time */
    N_ARGUMENTS = 18,     /* x, v and these: what motion depends on */
    N1 = 1,               /* phi */
    N2 = 1,               /* a1 */
    N3 = 1,               /* a2 */
    N4 = 1,               /* s */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0 };
EM_UNUSED static const int coordinate2[N2] = { 1 };
EM_UNUSED static const int coordinate3[N3] = { 2 };
EM_UNUSED static const int coordinate4[N4] = { 3 };
#endif

#if EM_HOLDS(EM_RHS)

/* M of single coordinates */
EM_INLINE void eigenfactor_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                  real shared[4])
{
    const real J = c[2];
    const real M = c[0];
    const real b = c[4];
    const real a1 = x[1];
    const real sin_a1 = em_sin(a1);
    const real c_0 = c[21];
    const real z_1 = b + sin_a1*c_0;
    const real a2 = x[2];
    const real sin_a2 = em_sin(a2);
    const real z_3 = b + sin_a2*c_0;
    M1[0][0] = J + M*(z_1*z_1) + M*(z_3*z_3);
    shared[0] = z_1;
    shared[1] = z_3;
    shared[2] = sin_a1;
    shared[3] = sin_a2;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  const real shared[4], real Mdot1[N1][N1], real f1[N1], real f2[N2],
                                  real f3[N3], real f4[N4])
{
    const real c_1 = c[22];
    const real z_1 = shared[0];
    const real a1_dot = v[1];
    const real a1 = x[1];
    const real cos_a1 = em_cos(a1);
    const real z_5 = a1_dot*cos_a1;
    const real z_3 = shared[1];
    const real a2_dot = v[2];
    const real a2 = x[2];
    const real cos_a2 = em_cos(a2);
    const real z_7 = a2_dot*cos_a2;
    Mdot1[0][0] = 4.0*(c_1*(z_1*z_5 + z_3*z_7));
    f1[0] = em_real(0.0);
    const real c_ = c[6];
    const real l = c[3];
    const real sin_a1 = shared[2];
    const real z_8 = l*sin_a1;
    const real s = x[3];
    const real z_9 = s - l*cos_a1;
    const real c_2 = c[23];
    const real z_10 = sin_a1*c_2;
    const real s_dot = v[3];
    const real z_11 = z_9*z_9 + c_2*(sin_a1*sin_a1);
    const real z_12 = (z_9*(s_dot + a1_dot*z_8) + z_5*z_10)/z_11;
    const real c_3 = c[24];
    const real k = c[5];
    const real L = c[7];
    const real z_13 = sqrt(z_11);
    const real z_14 = (L - z_13)/z_13;
    const real z_15 = z_9*k*z_14;
    const real c_4 = c[25];
    const real c_5 = c[26];
    const real phi_dot = v[0];
    const real z_16 = c_5*(phi_dot*phi_dot);
    f2[0] = -(c_*(z_8*z_9 + cos_a1*z_10)*z_12 + (z_8*(c_3 - z_15) - cos_a1*(sin_a1*c_4*z_14 + z_1*z_16)));
    const real sin_a2 = shared[3];
    const real z_17 = l*sin_a2;
    const real z_18 = s - l*cos_a2;
    const real z_19 = sin_a2*c_2;
    const real z_20 = z_18*z_18 + c_2*(sin_a2*sin_a2);
    const real z_21 = (z_18*(s_dot + a2_dot*z_17) + z_7*z_19)/z_20;
    const real z_22 = sqrt(z_20);
    const real z_23 = (L - z_22)/z_22;
    const real z_24 = z_18*k*z_23;
    f3[0] = -(c_*(z_17*z_18 + cos_a2*z_19)*z_21 + (z_17*(c_3 - z_24) - cos_a2*(sin_a2*c_4*z_23 + z_3*z_16)));
    const real c_6 = c[27];
    f4[0] = -(c_*(z_9*z_12 + z_18*z_21) - (c_6 + z_24 + z_15));
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{
    real M1[N1][N1], shared[4];
    eigenfactor_masses(y, c, M1, shared);

    /* phi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4] };
    if (em_fails(M1[0], em_value(M1[0][0]) > 0.0))
        return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 0, -1, em_number(M1[0][0]));
    const real C1[1] = { em_real(1.0) }, s1[1] = { sqrt(M1[0][0]) };
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* a1: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[5] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* a2: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[6] };
    const real *const C3 = c + 13, *const s3 = c + 14;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];

    /* s: xdot = C^T S^-1 eta (20) */
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
    real M1[N1][N1], shared[4];
    eigenfactor_masses(y, c, M1, shared);

    /* phi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[4] };
    if (em_fails(M1[0], em_value(M1[0][0]) > 0.0))
        return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 0, -1, em_number(M1[0][0]));
    const real C1[1] = { em_real(1.0) }, s1[1] = { sqrt(M1[0][0]) };
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* a1: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[5] };
    const real *const C2 = c + 9, *const s2 = c + 10;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    /* a2: xdot = C^T S^-1 eta (20) */
    const real eta3[N3] = { y[6] };
    const real *const C3 = c + 13, *const s3 = c + 14;
    real r3[N3], w3[N3], v3[N3];
    em_velocity(N3, C3, s3, eta3, r3, w3, v3);
    dy[2] = v3[0];

    /* s: xdot = C^T S^-1 eta (20) */
    const real eta4[N4] = { y[7] };
    const real *const C4 = c + 17, *const s4 = c + 18;
    real r4[N4], w4[N4], v4[N4];
    em_velocity(N4, C4, s4, eta4, r4, w4, v4);
    dy[3] = v4[0];

    real Mdot1[N1][N1], f1[N1], f2[N2], f3[N3], f4[N4];
    eigenfactor_motion(y, dy, c, shared, Mdot1, f1, f2, f3, f4);

    /* phi: sdot = Mdot / (2 s) (35), a = (f - sdot eta) / s (41) */
    const real s1_dot[1] = { 0.5*Mdot1[0][0]*r1[0] };
    real a1[1] = { r1[0]*(f1[0] - s1_dot[0]*eta1[0]) };

    /* a1: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* a2: constant factors, a = S^-1 C f (41) */
    real a3[N3];
    em_rows_on_eta(1, N3, C3, r3, f3, a3);

    /* s: constant factors, a = S^-1 C f (41) */
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
#if EM_HOLDS(EM_MODEL) && !defined(EM_NODES_ALONE)

/* M of the blocks that vary */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1])
{
    const real J = c[2];
    const real M = c[0];
    const real b = c[4];
    const real a1 = x[1];
    const real sin_a1 = em_sin(a1);
    const real c_0 = c[21];
    const real z_1 = b + sin_a1*c_0;
    const real a2 = x[2];
    const real sin_a2 = em_sin(a2);
    const real z_3 = b + sin_a2*c_0;
    M1[0][0] = J + M*(z_1*z_1) + M*(z_3*z_3);
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

enum { N_PIVOTS = 1 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1];
    settled_masses(y, c, M1);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0] };
    em_backward(N1, memory + 0, memory + 1, v1);
    v[0] = v1[0];
    real v2[N2] = { e[1] };
    em_velocity_of_eta(N2, c + 9, c + 10, v2);
    v[1] = v2[0];
    real v3[N3] = { e[2] };
    em_velocity_of_eta(N3, c + 13, c + 14, v3);
    v[2] = v3[0];
    real v4[N4] = { e[3] };
    em_velocity_of_eta(N4, c + 17, c + 18, v4);
    v[3] = v4[0];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: the root of M is kept.
 * *done becomes 0 in lanes that are settled number by number instead;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1];
    settled_masses(y, c, M1);
    em_cholesky(N1, M1[0], memory + 0, memory + 1, 0.0);
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes governor_lanes;
em_lanes governor_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 1, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- what no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_ACROSS void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double phi_dot = v[0];
    const double c_1 = c[22];
    const double b = c[4];
    const double a1 = x[1];
    const double sin_a1 = em_sin(a1);
    const double c_0 = c[21];
    const double z_1 = b + sin_a1*c_0;
    const double a1_dot = v[1];
    const double cos_a1 = em_cos(a1);
    const double z_3 = a1_dot*cos_a1;
    const double a2 = x[2];
    const double sin_a2 = em_sin(a2);
    const double z_5 = b + sin_a2*c_0;
    const double a2_dot = v[2];
    const double cos_a2 = em_cos(a2);
    const double z_7 = a2_dot*cos_a2;
    bias[0] = (-4.0)*(phi_dot*(c_1*(z_1*z_3 + z_5*z_7)));
    const double c_ = c[6];
    const double l = c[3];
    const double z_8 = l*sin_a1;
    const double s = x[3];
    const double z_9 = s - l*cos_a1;
    const double c_2 = c[23];
    const double z_10 = sin_a1*c_2;
    const double s_dot = v[3];
    const double z_11 = z_9*z_9 + c_2*(sin_a1*sin_a1);
    const double z_12 = (z_9*(s_dot + a1_dot*z_8) + z_3*z_10)/z_11;
    const double c_3 = c[24];
    const double k = c[5];
    const double L = c[7];
    const double z_13 = sqrt(z_11);
    const double z_14 = (L - z_13)/z_13;
    const double z_15 = z_9*k*z_14;
    const double c_4 = c[25];
    const double c_5 = c[26];
    const double z_16 = c_5*(phi_dot*phi_dot);
    bias[1] = -(c_*(z_8*z_9 + cos_a1*z_10)*z_12 + (z_8*(c_3 - z_15) - cos_a1*(sin_a1*c_4*z_14 + z_1*z_16)));
    const double z_17 = l*sin_a2;
    const double z_18 = s - l*cos_a2;
    const double z_19 = sin_a2*c_2;
    const double z_20 = z_18*z_18 + c_2*(sin_a2*sin_a2);
    const double z_21 = (z_18*(s_dot + a2_dot*z_17) + z_7*z_19)/z_20;
    const double z_22 = sqrt(z_20);
    const double z_23 = (L - z_22)/z_22;
    const double z_24 = z_18*k*z_23;
    bias[2] = -(c_*(z_17*z_18 + cos_a2*z_19)*z_21 + (z_17*(c_3 - z_24) - cos_a2*(sin_a2*c_4*z_23 + z_5*z_16)));
    const double c_6 = c[27];
    bias[3] = -(c_*(z_9*z_12 + z_18*z_21) - (c_6 + z_24 + z_15));
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double m = c[1];
    const double s_dot = v[3];
    const double J = c[2];
    const double M = c[0];
    const double b = c[4];
    const double a1 = x[1];
    const double sin_a1 = em_sin(a1);
    const double c_0 = c[21];
    const double z_1 = b + sin_a1*c_0;
    const double a2 = x[2];
    const double sin_a2 = em_sin(a2);
    const double z_3 = b + sin_a2*c_0;
    const double phi_dot = v[0];
    const double c_7 = c[28];
    const double a1_dot = v[1];
    const double a2_dot = v[2];
    e[0] = 0.5*(m*(s_dot*s_dot) + (J + M*(z_1*z_1) + M*(z_3*z_3))*(phi_dot*phi_dot) + c_7*(a1_dot*a1_dot) +
        c_7*(a2_dot*a2_dot));
    e[1] = 0.0;
    e[2] = 0.0;
    const double k = c[5];
    const double L = c[7];
    const double s = x[3];
    const double l = c[3];
    const double cos_a2 = em_cos(a2);
    const double z_5 = s - l*cos_a2;
    const double c_2 = c[23];
    const double z_6 = L - sqrt(z_5*z_5 + c_2*(sin_a2*sin_a2));
    const double cos_a1 = em_cos(a1);
    const double z_8 = s - l*cos_a1;
    const double z_9 = L - sqrt(z_8*z_8 + c_2*(sin_a1*sin_a1));
    const double c_8 = c[29];
    const double c_9 = c[30];
    e[3] = 0.5*(k*(z_6*z_6 + z_9*z_9) - (m*s + l*(cos_a1 + cos_a2)*c_8)*c_9);
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
    p[0] = p[1] = p[3] = p[4] = p[8] = p[11] = p[14] = p[20] = p[44] = p[45] = 0.0;
    const double c_10 = c[31];
    p[2] = c_10;
    const double c_11 = c[32];
    p[5] = c_11;
    const double b = c[4];
    const double phi = x[0];
    const double cos_phi = em_cos(phi);
    const double z_1 = b*cos_phi;
    p[6] = p[18] = p[33] = -z_1;
    const double sin_phi = em_sin(phi);
    const double z_3 = b*sin_phi;
    p[7] = p[19] = p[34] = -z_3;
    p[9] = p[12] = p[27] = z_1;
    p[10] = p[13] = p[28] = z_3;
    const double a1 = x[1];
    const double sin_a1 = em_sin(a1);
    const double c_0 = c[21];
    const double z_5 = b + sin_a1*c_0;
    p[15] = p[36] = p[48] = z_5*cos_phi;
    p[16] = p[37] = p[49] = z_5*sin_phi;
    const double cos_a1 = em_cos(a1);
    p[17] = p[38] = p[50] = -cos_a1*c_0;
    const double a2 = x[2];
    const double sin_a2 = em_sin(a2);
    const double z_8 = b + sin_a2*c_0;
    p[21] = p[40] = -z_8*cos_phi;
    p[22] = p[41] = -z_8*sin_phi;
    const double cos_a2 = em_cos(a2);
    p[23] = p[42] = -cos_a2*c_0;
    const double l = c[3];
    const double z_10 = b + l*sin_a1;
    p[24] = cos_phi*z_10;
    p[25] = sin_phi*z_10;
    p[26] = -l*cos_a1;
    const double s = x[3];
    p[29] = p[35] = p[46] = -s;
    const double z_11 = b + l*sin_a2;
    p[30] = -cos_phi*z_11;
    p[31] = -sin_phi*z_11;
    p[32] = -l*cos_a2;
    const double c_12 = c[33];
    p[39] = p[43] = c_12;
    const double c_13 = c[34];
    p[47] = c_13;
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
    const double b = c[4];
    const double l = c[3];
    const double a1 = x[1];
    const double sin_a1 = em_sin(a1);
    const double cos_a1 = em_cos(a1);
    const double M = c[0];
    const double z_2 = M*l;
    dM[16] = 4.0*((b + 2.0*l*sin_a1)*cos_a1*z_2);
    const double a2 = x[2];
    const double sin_a2 = em_sin(a2);
    const double cos_a2 = em_cos(a2);
    dM[32] = 4.0*((b + 2.0*l*sin_a2)*cos_a2*z_2);
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double phi_dot = v[0];
    const double M = c[0];
    const double a1 = x[1];
    const double cos_a1 = em_cos(a1);
    const double z_1 = cos_a1*cos_a1;
    const double a1_dot = v[1];
    const double l = c[3];
    const double z_2 = l*l;
    const double z_3 = a1_dot*z_2;
    const double z_4 = z_1*z_3;
    const double sin_a1 = em_sin(a1);
    const double b = c[4];
    const double z_6 = l*sin_a1;
    const double z_7 = M*l;
    const double z_8 = (b + 2.0*z_6)*z_7;
    const double phi_ddot = a[0];
    const double z_9 = cos_a1*z_8;
    D[1] = 4.0*(phi_dot*(2.0*M*z_4 - a1_dot*sin_a1*z_8) + phi_ddot*z_9);
    const double a2 = x[2];
    const double cos_a2 = em_cos(a2);
    const double z_11 = cos_a2*cos_a2;
    const double a2_dot = v[2];
    const double z_12 = a2_dot*z_2;
    const double z_13 = z_11*z_12;
    const double sin_a2 = em_sin(a2);
    const double z_15 = l*sin_a2;
    const double z_16 = (b + 2.0*z_15)*z_7;
    const double z_17 = cos_a2*z_16;
    D[2] = 4.0*(phi_dot*(2.0*M*z_13 - a2_dot*sin_a2*z_16) + phi_ddot*z_17);
    D[4] = 4.0*(a1_dot*z_9 + a2_dot*z_17);
    const double z_18 = phi_dot*z_9;
    D[5] = 4.0*z_18;
    const double z_19 = phi_dot*z_17;
    D[6] = 4.0*z_19;
    const double s = x[3];
    const double z_20 = l*cos_a1;
    const double z_21 = s - z_20;
    const double z_22 = sin_a1*cos_a1;
    const double z_23 = z_6*z_21 + z_2*z_22;
    const double z_24 = z_23*z_23;
    const double c_ = c[6];
    const double s_dot = v[3];
    const double z_25 = s_dot + a1_dot*z_6;
    const double z_26 = z_21*z_25 + z_3*z_22;
    const double z_27 = z_21*z_21;
    const double z_28 = sin_a1*sin_a1;
    const double z_29 = z_2*z_28;
    const double z_30 = z_27 + z_29;
    const double z_31 = z_26/(z_30*z_30);
    const double z_32 = c_*z_31;
    const double z_33 = z_20*z_21;
    const double z_34 = (z_6*z_25 + a1_dot*z_33) - (z_28*z_3 - z_4);
    const double z_35 = 1.0/z_30;
    const double z_36 = c_*z_35;
    const double z_37 = z_23*z_36;
    const double g = c[8];
    const double z_38 = M*g;
    const double z_39 = sqrt(z_30);
    const double z_40 = 1.0/z_39;
    const double k = c[5];
    const double L = c[7];
    const double z_41 = L - z_39;
    const double z_42 = k*z_41;
    const double z_43 = z_40*z_42;
    const double z_44 = z_21*z_23;
    const double z_45 = 1.0/(z_30*z_39);
    const double z_46 = z_45*z_42;
    const double z_47 = k*z_35;
    const double z_48 = z_6*z_43 - z_44*z_46 - z_44*z_47;
    const double z_49 = k*z_2;
    const double z_50 = sin_a1*z_49;
    const double z_51 = z_41*z_50;
    const double z_52 = phi_dot*phi_dot;
    const double z_53 = z_52*(M*z_2);
    const double z_54 = z_45*z_51;
    D[9] = -((2.0*z_24*z_32 - z_34*z_37 - z_26*((z_29 + z_33) - (z_29 - z_2*z_1))*z_36) - ((z_20*(2.0*z_38 -
        z_21*z_43) - z_6*z_48) + (sin_a1*(z_40*z_51 + 2.0*z_52*z_8) - cos_a1*(4.0*cos_a1*z_53 +
        (cos_a1*z_41*z_40*z_49 - z_23*z_54 - z_23*z_35*z_50)))));
    const double z_55 = z_6*z_26;
    const double z_56 = z_43 - z_27*z_46 - z_27*z_47;
    const double z_57 = z_21*z_35;
    D[11] = (z_36*z_55 + z_25*z_37 - 2.0*z_44*z_32) - (z_6*z_56 - cos_a1*(z_21*z_54 + z_50*z_57));
    D[12] = (-4.0)*z_18;
    D[13] = z_24*z_36;
    D[15] = z_36*z_44;
    const double z_58 = l*cos_a2;
    const double z_59 = s - z_58;
    const double z_60 = sin_a2*cos_a2;
    const double z_61 = z_15*z_59 + z_2*z_60;
    const double z_62 = z_61*z_61;
    const double z_63 = s_dot + a2_dot*z_15;
    const double z_64 = z_59*z_63 + z_12*z_60;
    const double z_65 = z_59*z_59;
    const double z_66 = sin_a2*sin_a2;
    const double z_67 = z_2*z_66;
    const double z_68 = z_65 + z_67;
    const double z_69 = z_64/(z_68*z_68);
    const double z_70 = c_*z_69;
    const double z_71 = z_58*z_59;
    const double z_72 = (z_15*z_63 + a2_dot*z_71) - (z_66*z_12 - z_13);
    const double z_73 = 1.0/z_68;
    const double z_74 = c_*z_73;
    const double z_75 = z_61*z_74;
    const double z_76 = sqrt(z_68);
    const double z_77 = 1.0/z_76;
    const double z_78 = L - z_76;
    const double z_79 = k*z_78;
    const double z_80 = z_77*z_79;
    const double z_81 = z_59*z_61;
    const double z_82 = 1.0/(z_68*z_76);
    const double z_83 = z_82*z_79;
    const double z_84 = k*z_73;
    const double z_85 = z_15*z_80 - z_81*z_83 - z_81*z_84;
    const double z_86 = sin_a2*z_49;
    const double z_87 = z_78*z_86;
    const double z_88 = z_82*z_87;
    D[18] = -((2.0*z_62*z_70 - z_72*z_75 - z_64*((z_67 + z_71) - (z_67 - z_2*z_11))*z_74) - ((z_58*(2.0*z_38 -
        z_59*z_80) - z_15*z_85) + (sin_a2*(z_77*z_87 + 2.0*z_52*z_16) - cos_a2*(4.0*cos_a2*z_53 +
        (cos_a2*z_78*z_77*z_49 - z_61*z_88 - z_61*z_73*z_86)))));
    const double z_89 = z_15*z_64;
    const double z_90 = z_80 - z_65*z_83 - z_65*z_84;
    const double z_91 = z_59*z_73;
    D[19] = (z_74*z_89 + z_63*z_75 - 2.0*z_81*z_70) - (z_15*z_90 - cos_a2*(z_59*z_88 + z_86*z_91));
    D[20] = (-4.0)*z_19;
    D[22] = z_62*z_74;
    D[23] = z_74*z_81;
    D[25] = -(z_48 + c_*(2.0*z_44*z_31 - z_35*z_55 - z_34*z_57));
    D[26] = -(z_85 + c_*(2.0*z_81*z_69 - z_73*z_89 - z_72*z_91));
    D[27] = c_*((z_26*z_35 + z_25*z_57 - 2.0*z_27*z_31) + (z_64*z_73 + z_63*z_91 - 2.0*z_65*z_69)) - (z_56 +
        z_90);
    D[29] = z_36*z_44;
    D[30] = z_74*z_81;
    D[31] = c_*(z_65*z_73 + z_27*z_35);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double phi_dot = v[0];
    const double a2_dot = v[2];
    const double a2 = x[2];
    const double cos_a2 = em_cos(a2);
    const double z_1 = a2_dot*cos_a2;
    const double l = c[3];
    const double b = c[4];
    const double sin_a2 = em_sin(a2);
    const double z_3 = l*sin_a2;
    const double z_4 = b + 2.0*z_3;
    const double z_5 = l*z_4;
    const double a1_dot = v[1];
    const double a1 = x[1];
    const double cos_a1 = em_cos(a1);
    const double z_7 = a1_dot*cos_a1;
    const double sin_a1 = em_sin(a1);
    const double z_9 = l*sin_a1;
    const double z_10 = b + 2.0*z_9;
    const double z_11 = l*z_10;
    const double phi_ddot = a[0];
    D[0] = 4.0*phi_dot*(z_1*z_5 + z_7*z_11) + phi_ddot*(z_10*z_10 + z_4*z_4);
    D[2] = phi_ddot;
    const double M = c[0];
    const double z_12 = M*z_10;
    const double z_13 = M*z_9;
    const double z_14 = M*z_4;
    const double z_15 = M*z_3;
    D[3] = 4.0*(phi_dot*((z_12*z_7 + 2.0*z_13*z_7) + (z_14*z_1 + 2.0*z_15*z_1)) + phi_ddot*(sin_a1*z_12 +
        sin_a2*z_14));
    const double z_16 = M*l;
    D[4] = 2.0*(2.0*phi_dot*(z_1*z_16 + z_7*z_16) + phi_ddot*(z_14 + z_12));
    const double a1_ddot = a[1];
    const double z_17 = l*l;
    const double z_18 = phi_dot*phi_dot;
    const double z_19 = cos_a1*z_18;
    const double g = c[8];
    D[10] = 2.0*(2.0*a1_ddot*z_17 - (z_11*z_19 - z_9*g));
    const double c_ = c[6];
    const double s = x[3];
    const double z_20 = s - l*cos_a1;
    const double z_21 = z_9*z_20;
    const double z_22 = sin_a1*z_17;
    const double z_23 = cos_a1*z_22;
    const double z_24 = z_21 + z_23;
    const double z_25 = c_*z_24;
    const double z_26 = sin_a1*sin_a1;
    const double z_27 = z_20*z_20 + z_17*z_26;
    const double s_dot = v[3];
    const double z_28 = s_dot + a1_dot*z_9;
    const double z_29 = z_20*z_28 + z_7*z_22;
    const double z_30 = cos_a1*z_20 - l*z_26;
    const double z_31 = z_29*z_30/(z_27*z_27);
    const double z_32 = sin_a1*z_20;
    const double z_33 = 2.0*z_9*z_7 - (cos_a1*z_28 - a1_dot*z_32);
    const double z_34 = 1.0/z_27;
    const double z_35 = z_9*cos_a1;
    const double z_36 = z_29*z_34;
    const double z_37 = M*g;
    const double k = c[5];
    const double z_38 = sqrt(z_27);
    const double z_39 = 1.0/z_38;
    const double z_40 = k*z_39;
    const double L = c[7];
    const double z_41 = L - z_38;
    const double z_42 = z_20*z_41;
    const double z_43 = z_41*z_40;
    const double z_44 = k*z_30;
    const double z_45 = z_44/(z_27*z_38);
    const double z_46 = z_20*z_34;
    const double z_47 = cos_a1*z_43 - z_42*z_45 - z_44*z_46;
    D[13] = 8.0*a1_ddot*z_16 + ((2.0*z_25*z_31 + z_33*z_34*z_25 + c_*(2.0*z_35 + (z_32 - z_35))*z_36) +
        ((sin_a1*(2.0*z_37 - z_40*z_42) + z_9*z_47) - cos_a1*((2.0*z_9*z_43 + z_41*z_22*z_45 + z_34*z_22*z_44) +
        2.0*(z_12*z_18 + 2.0*z_13*z_18))));
    D[14] = (-2.0)*(z_16*z_19);
    const double z_48 = z_39*z_42;
    D[15] = -(z_9*z_48 + z_23*z_41*z_39);
    D[16] = z_24*z_36;
    D[17] = -(z_21*z_40 + z_23*z_40);
    D[18] = 2.0*z_13;
    const double a2_ddot = a[2];
    const double z_49 = cos_a2*z_18;
    D[20] = 2.0*(2.0*a2_ddot*z_17 - (z_5*z_49 - z_3*g));
    const double z_50 = s - l*cos_a2;
    const double z_51 = z_3*z_50;
    const double z_52 = sin_a2*z_17;
    const double z_53 = cos_a2*z_52;
    const double z_54 = z_51 + z_53;
    const double z_55 = c_*z_54;
    const double z_56 = sin_a2*sin_a2;
    const double z_57 = z_50*z_50 + z_17*z_56;
    const double z_58 = s_dot + a2_dot*z_3;
    const double z_59 = z_50*z_58 + z_1*z_52;
    const double z_60 = cos_a2*z_50 - l*z_56;
    const double z_61 = z_59*z_60/(z_57*z_57);
    const double z_62 = sin_a2*z_50;
    const double z_63 = 2.0*z_3*z_1 - (cos_a2*z_58 - a2_dot*z_62);
    const double z_64 = 1.0/z_57;
    const double z_65 = z_3*cos_a2;
    const double z_66 = z_59*z_64;
    const double z_67 = sqrt(z_57);
    const double z_68 = 1.0/z_67;
    const double z_69 = k*z_68;
    const double z_70 = L - z_67;
    const double z_71 = z_50*z_70;
    const double z_72 = z_70*z_69;
    const double z_73 = k*z_60;
    const double z_74 = z_73/(z_57*z_67);
    const double z_75 = z_50*z_64;
    const double z_76 = cos_a2*z_72 - z_71*z_74 - z_73*z_75;
    D[23] = 8.0*a2_ddot*z_16 + ((2.0*z_55*z_61 + z_63*z_64*z_55 + c_*(2.0*z_65 + (z_62 - z_65))*z_66) +
        ((sin_a2*(2.0*z_37 - z_69*z_71) + z_3*z_76) - cos_a2*((2.0*z_3*z_72 + z_70*z_52*z_74 + z_64*z_52*z_73) +
        2.0*(z_14*z_18 + 2.0*z_15*z_18))));
    D[24] = (-2.0)*(z_16*z_49);
    const double z_77 = z_68*z_71;
    D[25] = -(z_3*z_77 + z_53*z_70*z_68);
    D[26] = z_54*z_66;
    D[27] = -(z_51*z_69 + z_53*z_69);
    D[28] = 2.0*z_15;
    const double s_ddot = a[3];
    D[31] = -(g - s_ddot);
    D[33] = -(c_*((cos_a1*z_36 - 2.0*z_20*z_31 - z_33*z_46) + (cos_a2*z_66 - 2.0*z_50*z_61 - z_63*z_75)) - (z_47 +
        z_76));
    D[35] = -(z_77 + z_48);
    D[36] = z_20*z_36 + z_50*z_66;
    D[37] = -(z_20*z_40 + z_50*z_69);
    const double m = c[1];
    D[38] = -m;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes governor_lanes;
EM_WEAK em_lanes governor_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 1, 2, 3 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_MEMORY, 0, 0, 0, 1 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 9, 10, 11, 12 };
static const em_block block3 = { N, N3, coordinate3, scales, EM_PREPARED_FACTORS, 13, 14, 15, 16 };
static const em_block block4 = { N, N4, coordinate4, scales, EM_PREPARED_FACTORS, 17, 18, 19, 20 };
EM_ACROSS const em_block *const blocks[] = { &block1, &block2, &block3, &block4, NULL };

/* M of the constant blocks, and what other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double M2[N2][N2], double M3[N3][N3],
                                  double M4[N4][N4], double prepared[N_PREPARED])
{
    const double M = parameters[0];
    const double l = parameters[3];
    const double z_0 = l*l;
    M2[0][0] = 4.0*(M*z_0);
    M3[0][0] = 4.0*(M*z_0);
    const double m = parameters[1];
    M4[0][0] = m;
    prepared[21] = 2.0*l; /* c_0 */
    const double z_1 = M*l;
    prepared[22] = z_1; /* c_1 */
    prepared[23] = z_0; /* c_2 */
    const double g = parameters[8];
    prepared[24] = 2.0*(M*g); /* c_3 */
    const double k = parameters[5];
    prepared[25] = k*z_0; /* c_4 */
    prepared[26] = 2.0*z_1; /* c_5 */
    prepared[27] = m*g; /* c_6 */
    prepared[28] = 4.0*(M*z_0); /* c_7 */
    prepared[29] = 2.0*M; /* c_8 */
    prepared[30] = 2.0*g; /* c_9 */
    prepared[31] = 0.5*l; /* c_10 */
    prepared[32] = (-3.0)*l; /* c_11 */
    prepared[33] = 0.125*l; /* c_12 */
    const double b = parameters[4];
    prepared[34] = 2.0*b; /* c_13 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
    {62, "nonnegative"},
    {62, "nonnegative"},
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
    double M2[N2][N2], M3[N3][N3], M4[N4][N4];
    prepared_constants(parameters, M2, M3, M4, c);
    if (em_prepare(&block2, M2[0], c, fault)) return -1;
    if (em_prepare(&block3, M3[0], c, fault)) return -1;
    if (em_prepare(&block4, M4[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_ACROSS void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double J = c[2];
    const double M_ = c[0];
    const double b = c[4];
    const double a1 = x[1];
    const double sin_a1 = em_sin(a1);
    const double c_0 = c[21];
    const double z_1 = b + sin_a1*c_0;
    const double a2 = x[2];
    const double sin_a2 = em_sin(a2);
    const double z_3 = b + sin_a2*c_0;
    M[0] = J + M_*(z_1*z_1) + M_*(z_3*z_3);
    M[4] = M[1] = 0.0;
    const double c_7 = c[28];
    M[5] = c_7;
    M[8] = M[2] = 0.0;
    M[9] = M[6] = 0.0;
    M[10] = c_7;
    M[12] = M[3] = 0.0;
    M[13] = M[7] = 0.0;
    M[14] = M[11] = 0.0;
    const double m = c[1];
    M[15] = m;
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
}

#endif
#if !EM_ALONE(EM_ASIDE) && !EM_ALONE(EM_RHS)
#include "em_redundant.h"
#endif
#if EM_HOLDS(EM_DERIVATIVES)
#include "em_derivatives.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* After an accepted step, and at the start: the root of M is kept.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    real M1[N1][N1];
    settled_masses(y, c, M1);
    if (em_keep_root(&block1, M1[0], memory, fault)) return -1;
    return 0;
}

/* v (n): xdot from a state. */
EM_ACROSS int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    double M[N*N];
    factored(t, y, c, M);
    if (em_velocity_at(&block1, 0, M, y, c, v, fault)) return -1;
    if (em_velocity_at(&block2, 0, M, y, c, v, fault)) return -1;
    if (em_velocity_at(&block3, 0, M, y, c, v, fault)) return -1;
    if (em_velocity_at(&block4, 0, M, y, c, v, fault)) return -1;
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

#include "governor.h"

static const char *const coordinate_names[] = { "phi", "a1", "a2", "s", NULL };
static const char *const parameter_names[] = { "M", "m", "J", "l", "b", "k", "c", "L", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 5.0, 3.0, 1.0, 0.5, 0.05, 800000.0, 40000.0, 0.5, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 0.5235987755982989, 0.5235987755982989, 0.8660254037844386 };
static const double initial_v[N] = { 6.283185307179586, 0.0, 0.0, 0.0 };
static const int carried[N] = { 0, 0, 0, 0 };
static const em_shape shapes[] = {
    {"line", 0, 6},
    {"line", 6, 6},
    {"line", 12, 6},
    {"line", 18, 6},
    {"spring", 24, 6},
    {"spring", 30, 6},
    {"disk", 36, 4},
    {"disk", 40, 4},
    {"disk", 44, 4},
    {"trace", 48, 3}
};
static const em_slice layout[] = {
    {"x", 0, 4},
    {"eta", 4, 4}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dphi, dM/ds: M does not depend on them",
    "C, mu, Omega across blocks: {phi}, {a1}, {a2}, {s} do not couple",
    "C, Omega of {phi}: one coordinate, s = sqrt(M) in closed form",
    "C, s, mu, Omega of {a1}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {a2}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {s}: this block is constant, factored once per parameter set",
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
};

/* What of the stepper is told which model it is of: a run, */
static int simulate(em_run *run) { return em_simulate(&governor_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&governor_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&governor_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&governor_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&governor_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&governor_model, run, mode); }

const em_model governor_model = {
    .abi = EM_ABI,
    .name = "governor",
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
    .n_left_out = 10,
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
    .lanes = &governor_lanes,
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
    .n_shapes = 10,
    .dimension = 3,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .motion_along = em_motion_along,
    .dynamics = &dynamics,
    .declared = declared,
#ifdef EM_UNIT
    .rate_jacobian = em_rate_jacobian,
#endif
};

#endif
#endif
