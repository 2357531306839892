/* eigenmotion generate pendulum.py */
/* input sha256:4cb3d75cfa750254dd7c7a92a151c59bb658f7285d3817bfdd1092f33379d1ad */
/* body sha256:71baf05a1e19be41cf43bf74404920e49bef5f56ee4dfe57919d0270a8337156 */
/* pendulum: equations of motion, eigenfactor formulation.
 *
 * State, 2 numbers:
 *   x    y[0 .. 1)
 *   eta  y[1 .. 2)
 *
 * Blocks of M that do not couple:
 *   1: theta (constant, factored once per parameter set)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   A, B, Bdot, Delta, lambda: there are no constraints
 *   dM/dtheta: M does not depend on it
 *   C, s, mu, Omega of {theta}: this block is constant, factored once per parameter set
 *
 * Operations of the straight-line part:
 *   eigenfactor: 1 multiplications, 1 function calls
 */
/* Callers use the same arguments for all models; each function uses those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "numeric/em_functions.h"
#include "constraints/em_multipliers.h"

/* Sizes. */
enum {
    N = 1,                /* coordinates */
    N_ROWS = 0,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 2,          /* numbers of a state */
    N_C = 0,              /* of which C, */
    N_S = 0,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 0,         /* numbers that a run keeps from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "loop/em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 3,
    N_PREPARED = 11,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_FORCING = 4,        /* inputs, parameters and the time */
    N_ARGUMENTS = 6,      /* x, v and these: the arguments of derivatives */
    N1 = 1,               /* theta */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29) */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict c, real f1[N1])
{
    const real c_0 = c[7];
    const real theta = x[0];
    const real sin_theta = em_sin(theta);
    f1[0] = -c_0*sin_theta;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* theta: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[1] };
    const real *const C1 = c + 3, *const s1 = c + 4;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* theta: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[1] };
    const real *const C1 = c + 3, *const s1 = c + 4;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];

    real f1[N1];
    eigenfactor_motion(y, c, f1);

    /* theta: constant factors, a = S^-1 C f (41) */
    real a1[N1];
    em_rows_on_eta(1, N1, C1, r1, f1, a1);

    /* etadot = a (45) */
    dy[1] = a1[0];
    return 0;
}

/* dy <- f(t, y). */
EM_EXPORT int model_rhs(int mode, real t, const real *y, const real *c, const real *u, double *memory, int flags,
                        real *dy, em_fault *fault)
{
    return rhs_eigenfactor(t, y, c, u, memory, flags, dy, fault);
}

#endif
#if EM_HOLDS(EM_MODEL) && !defined(EM_NODES_ALONE)

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
    real v1[N1] = { e[0] };
    em_velocity_of_eta(N1, c + 3, c + 4, v1);
    v[0] = v1[0];
}

#define EM_VELOCITY velocity_by_roots

#include "batch/em_lane_runge_kutta.h"
#endif

extern em_lanes pendulum_lanes;
em_lanes pendulum_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_group_run, EM_REMEMBERED, 1, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- functions that no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_EXPORT void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double c_0 = c[7];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    bias[0] = -c_0*sin_theta;
}


/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_EXPORT void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double c_2 = c[9];
    const double theta_dot = v[0];
    e[0] = c_2*(theta_dot*theta_dot);
    e[1] = 0.0;
    e[2] = 0.0;
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    const double c_0 = c[7];
    e[3] = -cos_theta*c_0;
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
    const double l = c[1];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    p[0] = p[6] = p[8] = l*sin_theta;
    const double cos_theta = em_cos(theta);
    p[1] = p[7] = p[9] = -l*cos_theta;
    p[2] = p[3] = p[4] = p[5] = 0.0;
    const double c_3 = c[10];
    p[10] = c_3;
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
    const double m = c[0];
    const double l = c[1];
    const double g = c[2];
    const double theta = x[0];
    const double cos_theta = em_cos(theta);
    D[0] = m*l*g*cos_theta;
}

/* D (n + m, n_inputs + n_parameters + 1) of r and s with respect to inputs, parameters, time */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_FORCING);
    const double theta_ddot = a[0];
    const double l = c[1];
    const double g = c[2];
    const double theta = x[0];
    const double sin_theta = em_sin(theta);
    const double z_1 = g*sin_theta;
    D[0] = theta_ddot*(l*l) + l*z_1;
    const double m = c[0];
    const double z_2 = m*l;
    D[1] = 2.0*theta_ddot*z_2 + m*z_1;
    D[2] = sin_theta*z_2;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* If the version for lanes is linked, it replaces this one. */
extern em_lanes pendulum_lanes;
EM_WEAK em_lanes pendulum_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "dynamics/em_blocks.h"
#include "loop/em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0 };
EM_EXPORT const double scales[N] = { 1.0 };

/* The location of the roots of the blocks: offsets of C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_PREPARED_FACTORS, 3, 4, 5, 6 };
EM_EXPORT const em_block *const blocks[] = { &block1, NULL };

/* M of the constant blocks, and terms in parameters only that other functions share */
EM_INLINE void prepared_constants(const double *restrict parameters, double M1[N1][N1],
                                  double prepared[N_PREPARED])
{
    const double m = parameters[0];
    const double l = parameters[1];
    const double z_0 = m*(l*l);
    M1[0][0] = z_0;
    const double g = parameters[2];
    prepared[7] = m*l*g; /* c_0 */
    prepared[8] = z_0; /* c_1 */
    prepared[9] = 0.5*z_0; /* c_2 */
    prepared[10] = (1.0/10.0)*l; /* c_3 */
}

/* The assumptions of parameters, coordinates and inputs. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {63, ""},
    {63, ""}
};

/* Constants that depend on parameters only, computed once per parameter set: c (N_PREPARED). */
EM_EXPORT int prepare(const double *parameters, double *c, em_fault *fault)
{
    if (em_check_declared(declared, 0, N_PARAMETERS, parameters, fault)) return -1;
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    double M1[N1][N1];
    prepared_constants(parameters, M1, c);
    if (em_prepare(&block1, M1[0], c, fault)) return -1;
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_EXPORT void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double c_1 = c[8];
    M[0] = c_1;
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
#include "dynamics/em_derivatives.h"
#endif
#if EM_HOLDS(EM_MODEL)

/* After an accepted step, and at the start: nothing to do.
 * Returns 1 if y changed, 0 if not, or -1 and *fault. */
EM_EXPORT int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    return 0;
}

/* v (n): xdot from a state. */
EM_EXPORT int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    if (em_velocity_at(&block1, 0, NULL, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that follows from an error e (n) of eta. */
EM_EXPORT void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, 0, e, y, c, memory, ev);
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
#include "batch/em_lane_run.h"
#endif
#if EM_HOLDS(EM_MODEL)

#include "pendulum.h"

static const char *const coordinate_names[] = { "theta", NULL };
static const char *const parameter_names[] = { "m", "l", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 1.0, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 2.0 };
static const double initial_v[N] = { 0.0 };
static const int carried[N] = { 0 };
static const em_shape shapes[] = {
    {"trace", 0, 2, 0, NULL},
    {"ground", 2, 2, 0, NULL},
    {"line", 4, 4, 0, NULL},
    {"disk", 8, 3, 0, NULL}
};
static const em_slice layout[] = {
    {"x", 0, 1},
    {"eta", 1, 1}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "A, B, Bdot, Delta, lambda: there are no constraints",
    "dM/dtheta: M does not depend on it",
    "C, s, mu, Omega of {theta}: this block is constant, factored once per parameter set",
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
    .settles = 0,
    .rhs = model_rhs,
    .settle = model_settle,
    .velocity = model_velocity,
    .velocity_error = model_velocity_error,
    .publish = model_publish,
    .events = model_events,
    .factored = factored,
    .acceleration = em_acceleration,
};

/* Functions of the stepper with this model as an argument. A run: */
static int simulate(em_run *run) { return em_simulate(&pendulum_model, run); }
/* the state within a run: */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&pendulum_model, run, step, t, y);
}
/* the memory of a run: */
static void release(em_run *run) { em_release(&pendulum_model, run); }
/* a run that advances on request: */
static void *open_run(em_run *run) { return em_handle_open(&pendulum_model, run); }
/* the size of its saved state: */
static size_t saved(void) { return em_handle_saved(&pendulum_model); }
/* forces of actuators: */
static int inverse_dynamics(double t, const double *x, const double *v, const double *a, const double *c,
                            const double *u, const em_actuators *actuators, double *forces, double *lambda,
                            double *residual, em_inverse_check *check, em_fault *fault)
{
    return em_inverse_dynamics(&pendulum_model, t, x, v, a, c, u, actuators, forces, lambda, residual,
                               check, fault);
}
/* a run on lanes: */
static void *enter(em_run *run, int *mode) { return em_member_enter(&pendulum_model, run, mode); }

const em_model pendulum_model = {
    .abi = EM_ABI,
    .name = "pendulum",
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
    .lanes = &pendulum_lanes,
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
    .n_shapes = 4,
    .dimension = 2,
    .shapes = shapes,
    .draw = draw,
    .n_arguments = N_ARGUMENTS,
    .motion_derivatives = em_motion_derivatives,
    .equation_partials = em_equation_partials,
    .motion_along = em_motion_along,
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
