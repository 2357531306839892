/* eigenmotion generate bouncing_ball.py */
/* input sha256:4d128ea20431f269a25450ff61477ebcbb2676698bb6448ebdd8d37e15829545 */
/* body sha256:d94fe3fbcca776049dbbcce814120c64d6614ec78531fba48b2ae27928cacb28 */
/* bouncing_ball: equations of motion, eigenfactor formulation.
 *
 * State, 4 numbers:
 *   x    y[0 .. 2)
 *   eta  y[2 .. 4)
 *
 * Blocks of M that do not couple:
 *   1: x (constant, factored once per parameter set)
 *   2: z (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   a factor of Delta: one constraint, Delta is a number
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dx, dM/dz: M does not depend on them
 *   C, mu, Omega across blocks: {x}, {z} do not couple
 *   C, s, mu, Omega of {x}: this block is constant, factored once per parameter set
 *   C, s, mu, Omega of {z}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: none
 *   projection: none
 */
/* Callers use the same arguments for all models; each function uses those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#define EM_SWITCHED_ROWS 0x1 /* bits of constraint rows that hold in some modes */
#define EM_ACTS
#define EM_HAS_ROWS
#include "numeric/em_functions.h"
#include "constraints/em_multipliers.h"

/* Sizes. */
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
    N_EVENTS = 1,
    N_MEMORY = 0,         /* numbers that a run keeps from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
    N_SWITCHES = 1,       /* constraint rows that hold in some modes */
    N_PARAMETERS = 6,
    N_PREPARED = 16,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
};
#ifdef EM_UNIT
#include "loop/em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_IMPACTS = 1,
    N_RESETS = 0,
    N_OUTPUTS = 0,
    N_FORCING = 7,        /* inputs, parameters and the time */
    N_ARGUMENTS = 11,     /* x, v and these: the arguments of derivatives */
    N1 = 1,               /* x */
    N2 = 1,               /* z */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0 };
EM_UNUSED static const int coordinate2[N2] = { 1 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict c, real f1[N1], real f2[N2], real A2[N_ROWS][N2],
                                  real gamma[N_ROWS])
{
    f1[0] = em_real(0.0);
    const real c_0 = c[14];
    f2[0] = c_0;
    const real floor_held = c[4];
    A2[0][0] = floor_held;
    gamma[0] = em_real(0.0);
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[2] };
    const real *const C1 = c + 6, *const s1 = c + 7;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* z: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[3] };
    const real *const C2 = c + 10, *const s2 = c + 11;
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
    const real *const C1 = c + 6, *const s1 = c + 7;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    /* z: xdot = C^T S^-1 eta (20) */
    const real eta2[N2] = { y[3] };
    const real *const C2 = c + 10, *const s2 = c + 11;
    real r2[N2], w2[N2], v2[N2];
    em_velocity(N2, C2, s2, eta2, r2, w2, v2);
    dy[1] = v2[0];

    real f1[N1], f2[N2], A2[N_ROWS][N2], gamma[N_ROWS];
    eigenfactor_motion(c, f1, f2, A2, gamma);

    /* z: B = A C^T S^-1 (28) */
    real B2[N_ROWS][N2];
    em_rows_on_eta(N_ROWS, N2, C2, r2, A2[0], B2[0]);

    /* x: constant factors, a = S^-1 C f (41) */
    real a1[N1];
    em_rows_on_eta(1, N1, C1, r1, f1, a1);

    /* z: constant factors, a = S^-1 C f (41) */
    real a2[N2];
    em_rows_on_eta(1, N2, C2, r2, f2, a2);

    /* Delta = B B^T (43), Delta lambda = B a + Bdot eta + bdot (46), in one loop */
    real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
    for (int row = 0; row < N_ROWS; ++row) {
        lambda[row] = gamma[row];
        em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
        for (int column = 0; column <= row; ++column) {
            Delta[row*N_ROWS + column] = em_inner(N2, B2[row], B2[column]);
        }
    }
    if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;

    /* etadot = a - B^T lambda (45) */
    dy[2] = a1[0];
    em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
    dy[3] = a2[0];
    return 0;
}

/* dy <- f(t, y). */
EM_EXPORT int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags,
                        real *dy, em_fault *fault)
{
    return rhs_eigenfactor(t, y, c, u, memory, flags, dy, fault);
}

#endif
#ifdef EM_ON_LANES

#ifdef EM_ON_DUALS
#include "dynamics/em_rate_jacobian.h"
#else
/* Compiled with -DEM_ON_LANES, this file has the right-hand side on vectors; link it with the scalar version. */
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

extern em_lanes bouncing_ball_lanes;
em_lanes bouncing_ball_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, NULL, 0, 1, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- functions that no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_EXPORT void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    bias[0] = 0.0;
    const double c_0 = c[14];
    bias[1] = c_0;
    gamma[0] = 0.0;
}


/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_EXPORT void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double m = c[0];
    const double x_dot = v[0];
    const double z_dot = v[1];
    e[0] = 0.5*(m*(x_dot*x_dot + z_dot*z_dot));
    e[1] = 0.0;
    e[2] = 0.0;
    const double z = x[1];
    const double c_1 = c[15];
    e[3] = z*c_1;
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
    const double x_ = x[0];
    p[0] = p[6] = x_;
    const double z = x[1];
    const double r = c[3];
    p[1] = p[7] = z + r;
    p[2] = -1.0;
    p[3] = p[5] = 0.0;
    p[4] = 3.0;
    p[8] = r;
}

/* impact_data, for each impact: N = dphi/dx, dphi/dt, the restitution */
EM_EXPORT void impacts(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                       const double *restrict u, double *restrict impact_data)
{
    impact_data[0] = 0.0;
    impact_data[1] = 1.0;
    impact_data[2] = 0.0;
    const double e = c[2];
    impact_data[3] = e;
}

/* after: x, and v or the quasi-velocities, after each reset */
EM_EXPORT void resets(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      const double *restrict u, double *restrict after)
{
}

/* level, for each row that holds in some modes: the limit of separation speed or of sliding friction, and that of
 * sticking */
EM_EXPORT void levels(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      const double *restrict u, double *restrict level)
{
    level[0] = 1.0/1000.0;
    level[1] = 0.0;
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
}

/* D (n + m, 2 n) of r = M a + P^T lambda - bias and s = A a + gamma with respect to x, v, at fixed a, lambda */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
}

/* D (n + m, n_inputs + n_parameters + 1) of r and s with respect to inputs, parameters, time */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_FORCING);
    const double x_ddot = a[0];
    D[0] = x_ddot;
    const double g = c[1];
    const double z_ddot = a[1];
    D[7] = g + z_ddot;
    const double m = c[0];
    D[8] = m;
    const double lambda_0 = lambda[0];
    D[11] = lambda_0;
    D[18] = z_ddot;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double floor_held = c[4];
    D[1] = floor_held;
    const double z = x[1];
    D[8] = z;
    D[14] = floor_held;
    const double z_dot = v[1];
    D[19] = z_dot;
}

/* D (n_events, n_arguments) of the event functions */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void event_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_EVENTS * N_ARGUMENTS);
    D[1] = 1.0;
}

/* D (n + m, n_arguments), at fixed a, lambda, of M a + A^T lambda and A a */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void impact_balance_partials(double t, const double *restrict x, const double *restrict a,
                                       const double *restrict lambda, const double *restrict c,
                                       double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_ARGUMENTS);
    const double x_ddot = a[0];
    D[4] = x_ddot;
    const double z_ddot = a[1];
    D[15] = z_ddot;
    const double lambda_0 = lambda[0];
    D[19] = lambda_0;
    D[30] = z_ddot;
}

/* D (n_impacts (n + 2), n_arguments), of N, dphi/dt and the restitution */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void impact_partials(double t, const double *restrict x, const double *restrict v,
                               const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_IMPACTS * (N + 2) * N_ARGUMENTS);
    D[39] = 1.0;
}

/* D (n_resets 2 n, n_arguments) of the states after resets */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void reset_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
}

/* D (n_switches 2, n_arguments) of the levels */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void level_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * N_SWITCHES * 2 * N_ARGUMENTS);
}

#endif
#if EM_HOLDS(EM_MODEL)

/* If the version for lanes is linked, it replaces this one. */
extern em_lanes bouncing_ball_lanes;
EM_WEAK em_lanes bouncing_ball_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "dynamics/em_blocks.h"
#include "loop/em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 1 };
EM_EXPORT const double scales[N] = { 1.0, 1.0 };

/* The location of the roots of the blocks: offsets of C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_PREPARED_FACTORS, 6, 7, 8, 9 };
static const em_block block2 = { N, N2, coordinate2, scales, EM_PREPARED_FACTORS, 10, 11, 12, 13 };
EM_EXPORT const em_block *const blocks[] = { &block1, &block2, NULL };

/* M of the constant blocks, and terms in parameters only that other functions share */
EM_INLINE void prepared_constants(const double *restrict parameters, double M1[N1][N1], double M2[N2][N2],
                                  double prepared[N_PREPARED])
{
    const double m = parameters[0];
    M1[0][0] = m;
    M2[0][0] = m;
    const double g = parameters[1];
    const double z_0 = m*g;
    prepared[14] = -z_0; /* c_0 */
    prepared[15] = z_0; /* c_1 */
}

/* The assumptions of parameters, coordinates and inputs. */
static const em_declared declared[] = {
    {60, "positive"},
    {63, ""},
    {62, "nonnegative"},
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
    double M1[N1][N1], M2[N2][N2];
    prepared_constants(parameters, M1, M2, c);
    if (em_prepare(&block1, M1[0], c, fault)) return -1;
    if (em_prepare(&block2, M2[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_EXPORT void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double m = c[0];
    M[0] = m;
    M[2] = M[1] = 0.0;
    M[3] = m;
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
    A[0] = 0.0;
    const double floor_held = c[4];
    A[1] = floor_held;
    b[0] = 0.0;
}

/* phi (h): the holonomic constraints;  terms (h): the terms that cancel in them; eps terms is their rounding */
EM_EXPORT void position(double t, const double *restrict x, const double *restrict c, double *restrict phi,
                        double *restrict terms)
{
    const double floor_held = c[4];
    const double z = x[1];
    const double z_0 = floor_held*z;
    phi[0] = z_0;
    terms[0] = fabs(z_0);
}

/* crossing (n_events): an event happens where its function passes through zero */
EM_EXPORT void model_events(double t, const double *restrict x, const double *restrict v,
                            const double *restrict c, const double *restrict u, double *restrict crossing)
{
    const double z = x[1];
    crossing[0] = z;
}

/* Actions of each event: impact, reset, the contact that it closes or opens; whether it also fires at zero; whether it
 * acts. */
EM_EXPORT const em_event_action event_actions[] = { {0, -1, 0, 1, 1} };
EM_EXPORT const int resets_quasi[] = { 0 };
/* Rows that hold in some modes: their event, their parameter, that of sliding, their normal force, their number, their
 * parameter when idle; whether they use Poisson's law; the first parameter of the shift of a cone, or -1 */
EM_EXPORT const em_switch switches[] = { {0, 4, -1, -1, 0, 5, 0, -1}, {-1, -1, -1, -1, -1, -1, 0, -1} };

#endif
#if !EM_ALONE(EM_RHS)
#include "dynamics/em_dependent_rows.h"
#endif
#if EM_HOLDS(EM_MODEL)
#include "dynamics/em_required_forces.h"
#endif
#if EM_HOLDS(EM_ASIDE)
#include "contact/em_event_actions.h"
#endif
#if EM_HOLDS(EM_DERIVATIVES)
#include "dynamics/em_tangent.h"
#include "contact/em_event_directions.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const double *restrict c, double A2[N_ROWS][N2], double b[N_ROWS])
{
    const double floor_held = c[4];
    A2[0][0] = floor_held;
    b[0] = 0.0;
}

/* After an accepted step, and at the start: constraints on positions, constraints on velocities.
 * Returns 1 if y changed, 0 if not, or -1 and *fault. */
EM_EXPORT int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int changed = flags & EM_STABILISE;
    if ((flags & EM_STABILISE) && em_newton(t, y, c, 3, flags & EM_ABOUT_ROWS, fault) < 0) return -1;
    double A2[N_ROWS][N2], b[N_ROWS];
    settled_masses(c, A2, b);

    if (flags & EM_STABILISE) { /* eta <- eta - B^T Delta^-1 (B eta + b) */
        double B2[N_ROWS][N2], a2[N2];
        em_rows_of_block(&block2, *mode, N_ROWS, y, c, memory, A2[0], B2[0]);
        em_take(&block2, y + N, a2);

        /* Delta = B B^T (43), Delta lambda = B a (46), in one loop */
        real Delta[N_ROWS*N_ROWS], lambda[N_ROWS];
        for (int row = 0; row < N_ROWS; ++row) {
            lambda[row] = b[row];
            em_add_to_load(N2, row, B2[0], a2, NULL, lambda);
            for (int column = 0; column <= row; ++column) {
                Delta[row*N_ROWS + column] = em_inner(N2, B2[row], B2[column]);
            }
        }
        if (em_solve_delta(N_ROWS, Delta, lambda, flags, fault)) return -1;
        em_subtract_reactions(N_ROWS, N2, B2[0], lambda, a2);
        em_put(&block2, a2, y + N);
    }
    return changed;
}

/* v (n): xdot from a state. */
EM_EXPORT int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    if (em_velocity_at(&block1, 0, NULL, y, c, v, fault)) return -1;
    if (em_velocity_at(&block2, 0, NULL, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that follows from an error e (n) of eta. */
EM_EXPORT void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, 0, e, y, c, memory, ev);
    em_velocity_kept(&block2, 0, e, y, c, memory, ev);
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
    double C[N*N] = {0.0}, s[N], eta[N];
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
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
#endif
#if EM_HOLDS(EM_MODEL)

#include "bouncing_ball.h"

static const char *const coordinate_names[] = { "x", "z", NULL };
static const char *const parameter_names[] = { "m", "g", "e", "r", "floor_held", "floor_idle", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { "floor", NULL };
static const int event_direction[] = { -1, 0 };
static const int event_terminal[] = { 0, 0 };
static const double parameter_defaults[] = { 1.0, 9.81, 0.9, 0.05, 0.0, 0.0, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 1.0 };
static const double initial_v[N] = { 0.2, 0.0 };
static const int carried[N] = { 0, 0 };
static const em_shape shapes[] = {
    {"trace", 0, 2, 0, NULL},
    {"line", 2, 4, 0, NULL},
    {"disk", 6, 3, 0, NULL}
};
static const em_slice layout[] = {
    {"x", 0, 2},
    {"eta", 2, 2}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "a factor of Delta: one constraint, Delta is a number",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dx, dM/dz: M does not depend on them",
    "C, mu, Omega across blocks: {x}, {z} do not couple",
    "C, s, mu, Omega of {x}: this block is constant, factored once per parameter set",
    "C, s, mu, Omega of {z}: this block is constant, factored once per parameter set",
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
    .switched_rows = EM_SWITCHED_ROWS,
    .cones = 0,
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
    .act = em_act,
    .watch_modes = em_watch_modes,
};

/* Functions of the stepper with this model as an argument. A run: */
static int simulate(em_run *run) { return em_simulate(&bouncing_ball_model, run); }
/* the state within a run: */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&bouncing_ball_model, run, step, t, y);
}
/* the memory of a run: */
static void release(em_run *run) { em_release(&bouncing_ball_model, run); }
/* a run that advances on request: */
static void *open_run(em_run *run) { return em_handle_open(&bouncing_ball_model, run); }
/* the size of its saved state: */
static size_t saved(void) { return em_handle_saved(&bouncing_ball_model); }
/* forces of actuators: */
static int inverse_dynamics(double t, const double *x, const double *v, const double *a, const double *c,
                            const double *u, const em_actuators *actuators, double *forces, double *lambda,
                            double *residual, em_inverse_check *check, em_fault *fault)
{
    return em_inverse_dynamics(&bouncing_ball_model, t, x, v, a, c, u, actuators, forces, lambda, residual,
                               check, fault);
}

const em_model bouncing_ball_model = {
    .abi = EM_ABI,
    .name = "bouncing_ball",
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
    .conserves_energy = 1,
    .prepare = prepare,
    .state = state,
    .velocity = velocity,
    .rhs = rhs,
    .mass_matrix = mass_matrix,
    .mass_matrix_gradient = mass_matrix_gradient,
    .pfaffian = pfaffian,
    .position = position,
    .acceleration = em_acceleration_with_idle,
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
    .event_actions = event_actions,
    .n_switches = N_SWITCHES,
    .switches = switches,
    .levels = levels,
    .n_impacts = N_IMPACTS,
    .impacts = impacts,
    .lanes = &bouncing_ball_lanes,
    .open = open_run,
    .advance = em_handle_advance,
    .now = em_handle_now,
    .publish = em_handle_publish,
    .saved = saved,
    .save = em_handle_save,
    .restore = em_handle_restore,
    .close = em_handle_close,
    .again = em_handle_again,
    .n_shapes = 3,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .equation_partials = em_equation_partials,
    .constraint_partials = constraint_partials,
    .event_partials = em_watched_partials,
    .motion_along = em_motion_along,
    .tangent = em_tangent,
    .act_along = em_act_along,
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
