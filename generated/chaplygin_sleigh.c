/* eigenmotion generate chaplygin_sleigh.py */
/* input sha256:3d5f0048bd7d07f166f5e27e487e5ada2df1ffaf99a10809e7c8523799804238 */
/* body sha256:66ee59e516bc1f6194362dad5649cee436a022d9b05e857e1bcd57bad9087914 */
/* chaplygin_sleigh: equations of motion, eigenfactor formulation.
 *
 * State, 18 numbers:
 *   x    y[0 .. 3)
 *   eta  y[3 .. 6)
 *   C    y[6 .. 15)
 *   s    y[15 .. 18)
 *
 * Blocks of M that do not couple:
 *   1: x, y, theta (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   dV/dx: there is no potential energy
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   a factor of Delta: one constraint, Delta is a number
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dx, dM/dy: M does not depend on them
 *
 * Operations of the straight-line part:
 *   eigenfactor: 1 additions, 8 multiplications, 2 function calls
 *   triangular root: 1 additions, 10 multiplications, 2 function calls
 *   projection: 5 multiplications, 2 function calls
 */
/* Whoever calls them hands all models the same arguments; functions use those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "em_functions.h"
#include "em_multipliers.h"

/* How large it is. */
enum {
    N = 3,                /* coordinates */
    N_ROWS = 1,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 18,         /* numbers of a state */
    N_C = 9,              /* of which C, */
    N_S = 3,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 12,        /* what a run remembers from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 3,
    N_PREPARED = 7,       /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_GIVEN = 4,          /* inputs, parameters and the time */
    N_ARGUMENTS = 10,     /* x, v and these: what motion depends on */
    N1 = 3,               /* x, y, theta */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real theta = x[2];
    const real cos_theta = em_cos(theta);
    const real theta_dot = v[2];
    const real c_0 = c[3];
    const real z_1 = theta_dot*c_0;
    Mdot1[0][2] = Mdot1[2][0] = -cos_theta*z_1;
    const real sin_theta = em_sin(theta);
    Mdot1[1][2] = Mdot1[2][1] = -sin_theta*z_1;
    Mdot1[2][2] = em_real(0.0);
    f1[0] = em_real(0.0);
    f1[1] = em_real(0.0);
    const real x_dot = v[0];
    const real y_dot = v[1];
    const real z_3 = theta_dot*(x_dot*cos_theta) + theta_dot*(y_dot*sin_theta);
    f1[2] = -z_3*c_0;
    A1[0][0] = -sin_theta;
    A1[0][1] = cos_theta;
    A1[0][2] = em_real(0.0);
    gamma[0] = -z_3;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x, y, theta: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[3], y[4], y[5] };
    const real *const C1 = y + 6, *const s1 = y + 15;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x, y, theta: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[3], y[4], y[5] };
    const real *const C1 = y + 6, *const s1 = y + 15;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, f1, A1, gamma);

    /* x, y, theta: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* x, y, theta: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_turned_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 6, *const s1_dot = dy + 15;
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
    dy[3] = a1[0];
    dy[4] = a1[1];
    dy[5] = a1[2];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[2])
{
    const real m = c[0];
    M1[0][0] = m;
    M1[1][0] = em_real(0.0);
    M1[1][1] = m;
    const real theta = x[2];
    const real sin_theta = em_sin(theta);
    const real c_0 = c[3];
    M1[2][0] = -sin_theta*c_0;
    const real cos_theta = em_cos(theta);
    M1[2][1] = cos_theta*c_0;
    const real c_1 = c[4];
    M1[2][2] = c_1;
    shared[0] = cos_theta;
    shared[1] = sin_theta;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[2],
                                 real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real cos_theta = shared[0];
    const real theta_dot = v[2];
    const real c_0 = c[3];
    const real z_2 = theta_dot*c_0;
    Mdot1[0][2] = Mdot1[2][0] = -cos_theta*z_2;
    const real sin_theta = shared[1];
    Mdot1[1][2] = Mdot1[2][1] = -sin_theta*z_2;
    Mdot1[2][2] = em_real(0.0);
    f1[0] = em_real(0.0);
    f1[1] = em_real(0.0);
    const real x_dot = v[0];
    const real y_dot = v[1];
    const real z_3 = theta_dot*(x_dot*cos_theta) + theta_dot*(y_dot*sin_theta);
    f1[2] = -z_3*c_0;
    A1[0][0] = -sin_theta;
    A1[0][1] = cos_theta;
    A1[0][2] = em_real(0.0);
    gamma[0] = -z_3;
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; what else the state holds rests. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[2];
    triangular_masses(y, c, M1, shared);

    /* x, y, theta: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[3], y[4], y[5] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    triangular_motion(dy, c, shared, Mdot1, f1, A1, gamma);

    /* x, y, theta: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* x, y, theta: B = A L^-T */
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
    dy[3] = a1[0];
    dy[4] = a1[1];
    dy[5] = a1[2];
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
#if EM_HOLDS(EM_MODEL) && !defined(EM_NODES_ALONE)

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                              real A1[N_ROWS][N1], real b[N_ROWS], real shared[2])
{
    const real m = c[0];
    M1[0][0] = m;
    M1[0][1] = M1[1][0] = em_real(0.0);
    M1[1][1] = m;
    const real theta = x[2];
    const real sin_theta = em_sin(theta);
    const real c_0 = c[3];
    M1[0][2] = M1[2][0] = -sin_theta*c_0;
    const real cos_theta = em_cos(theta);
    M1[1][2] = M1[2][1] = cos_theta*c_0;
    const real c_1 = c[4];
    M1[2][2] = c_1;
    A1[0][0] = -sin_theta;
    A1[0][1] = cos_theta;
    A1[0][2] = em_real(0.0);
    b[0] = em_real(0.0);
    shared[0] = cos_theta;
    shared[1] = sin_theta;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[2],
                             real Mdot1[N1][N1])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real cos_theta = shared[0];
    const real theta_dot = v[2];
    const real c_0 = c[3];
    const real z_2 = theta_dot*c_0;
    Mdot1[0][2] = Mdot1[2][0] = -cos_theta*z_2;
    const real sin_theta = shared[1];
    Mdot1[1][2] = Mdot1[2][1] = -sin_theta*z_2;
    Mdot1[2][2] = em_real(0.0);
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

enum { N_PIVOTS = 3 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[2];
    settled_masses(y, c, M1, A1, b, shared);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- what e (n), eta or an error of it, makes of xdot, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1], e[2] };
    if (mode) em_backward(N1, memory + 0, memory + 9, v1);
    else em_velocity_of_eta(N1, y + 6, y + 15, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s, constraints on velocities.
 * *done becomes 0 in lanes that are settled number by number instead, as where the mode changes;
 * what is singular leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[2];
    settled_masses(y, c, M1, A1, b, shared);
    real eta1[N1] = { y[3], y[4], y[5] };
    *done &= em_refresh(N1, M1[0], y + 6, y + 15, mode ? NULL : eta1);
    y[3] = eta1[0];
    y[4] = eta1[1];
    y[5] = eta1[2];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 9, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 15);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        real time = em_time_on_lanes(N1, y + 6, y + 15, Mdot1[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};

    real B1[N_ROWS][N1];
    if (mode) em_rows_of_root(N_ROWS, N1, memory + 0, memory + 9, A1[0], B1[0]);
    else em_rows_of_factors(N_ROWS, N1, y + 6, y + 15, A1[0], B1[0]);
    real a1[N1] = { y[3], y[4], y[5] };

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
    y[3] = a1[0];
    y[4] = a1[1];
    y[5] = a1[2];
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "em_flock.h"
#endif

extern em_lanes chaplygin_sleigh_lanes;
em_lanes chaplygin_sleigh_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_flock_run, EM_REMEMBERED, 2,
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
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double c_0 = c[3];
    const double theta_dot = v[2];
    const double z_1 = c_0*(theta_dot*theta_dot);
    bias[0] = cos_theta*z_1;
    const double sin_theta = em_sin(theta);
    bias[1] = sin_theta*z_1;
    bias[2] = 0.0;
    const double x_dot = v[0];
    const double y_dot = v[1];
    gamma[0] = -(x_dot*theta_dot*cos_theta + y_dot*theta_dot*sin_theta);
}

/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_ACROSS void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double x_dot = v[0];
    const double m = c[0];
    const double theta = x[2];
    const double sin_theta = em_sin(theta);
    const double theta_dot = v[2];
    const double c_0 = c[3];
    const double z_1 = theta_dot*c_0;
    const double y_dot = v[1];
    const double cos_theta = em_cos(theta);
    const double c_1 = c[4];
    e[0] = 0.5*(x_dot*(x_dot*m - sin_theta*z_1) + y_dot*(y_dot*m + cos_theta*z_1) - theta_dot*(x_dot*sin_theta*c_0
        - y_dot*cos_theta*c_0 - theta_dot*c_1));
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
    p[0] = x_;
    const double y = x[1];
    p[1] = y;
    const double a_ = c[2];
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double z_1 = a_*cos_theta;
    p[2] = p[5] = x_ + z_1;
    const double sin_theta = em_sin(theta);
    const double z_3 = a_*sin_theta;
    p[3] = p[6] = y + z_3;
    const double c_2 = c[5];
    p[4] = c_2;
    const double c_3 = c[6];
    p[7] = c_3;
    p[8] = 0.5*(2.0*x_ - z_1);
    p[9] = 0.5*(2.0*y - z_3);
    p[10] = 0.5*(2.0*x_ + z_1);
    p[11] = 0.5*(2.0*y + z_3);
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
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double m = c[0];
    const double a_ = c[2];
    const double z_1 = m*a_;
    dM[24] = dM[20] = -cos_theta*z_1;
    const double sin_theta = em_sin(theta);
    dM[25] = dM[23] = -sin_theta*z_1;
}

/* D (n + m, 2 n) by x, v, at fixed a, lambda, of r = M a + P^T lambda - bias and s = A a + gamma */
EM_RARE /* no explicit step calls it */
EM_ACROSS void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double theta_dot = v[2];
    const double z_0 = theta_dot*theta_dot;
    const double theta = x[2];
    const double sin_theta = em_sin(theta);
    const double m = c[0];
    const double a_ = c[2];
    const double z_2 = m*a_;
    const double z_3 = sin_theta*z_2;
    const double cos_theta = em_cos(theta);
    const double lambda_0 = lambda[0];
    const double theta_ddot = a[2];
    const double z_5 = lambda_0 + theta_ddot*z_2;
    D[2] = z_0*z_3 - cos_theta*z_5;
    const double z_6 = cos_theta*z_2;
    D[5] = (-2.0)*(theta_dot*z_6);
    D[8] = -(z_0*z_6 + sin_theta*z_5);
    D[11] = (-2.0)*(theta_dot*z_3);
    const double y_ddot = a[1];
    const double x_ddot = a[0];
    D[14] = -(y_ddot*z_3 + x_ddot*z_6);
    const double x_dot = v[0];
    const double y_dot = v[1];
    D[20] = -(sin_theta*(y_ddot - x_dot*theta_dot) + cos_theta*(x_ddot + y_dot*theta_dot));
    D[21] = -theta_dot*cos_theta;
    D[22] = -theta_dot*sin_theta;
    D[23] = -(y_dot*sin_theta + x_dot*cos_theta);
}

/* D (n + m, n_inputs + n_parameters + 1), of r and s by inputs, parameters, time */
EM_RARE /* no explicit step calls it */
EM_ACROSS void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_GIVEN);
    const double theta_dot = v[2];
    const double z_0 = theta_dot*theta_dot;
    const double a_ = c[2];
    const double theta = x[2];
    const double cos_theta = em_cos(theta);
    const double z_2 = a_*cos_theta;
    const double x_ddot = a[0];
    const double theta_ddot = a[2];
    const double sin_theta = em_sin(theta);
    const double z_4 = a_*sin_theta;
    D[0] = -(z_0*z_2 + theta_ddot*z_4 - x_ddot);
    const double m = c[0];
    const double z_5 = m*sin_theta;
    const double z_6 = m*cos_theta;
    D[2] = -(theta_ddot*z_5 + z_0*z_6);
    const double y_ddot = a[1];
    D[4] = -(z_0*z_4 - y_ddot - theta_ddot*z_2);
    D[6] = theta_ddot*z_6 - z_0*z_5;
    D[8] = y_ddot*z_2 + theta_ddot*(a_*a_) - x_ddot*z_4;
    D[9] = theta_ddot;
    D[10] = 2.0*m*a_*theta_ddot + y_ddot*z_6 - x_ddot*z_5;
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_RARE /* no explicit step calls it */
EM_ACROSS void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double y_dot = v[1];
    const double theta = x[2];
    const double sin_theta = em_sin(theta);
    const double x_dot = v[0];
    const double cos_theta = em_cos(theta);
    D[2] = -(y_dot*sin_theta + x_dot*cos_theta);
    D[3] = -sin_theta;
    D[4] = cos_theta;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* Where the other is linked it takes the place of this. */
extern em_lanes chaplygin_sleigh_lanes;
EM_WEAK em_lanes chaplygin_sleigh_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "em_blocks.h"
#include "em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0 };
EM_ACROSS const double scales[N] = { 1.0, 1.0, 1.0 };

/* Where the roots of the blocks are, and the places there: C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 6, 15, 0, 9 };
EM_ACROSS const em_block *const blocks[] = { &block1, NULL };

/* What other functions share that is made of parameters only */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double m = parameters[0];
    const double a_ = parameters[2];
    prepared[3] = m*a_; /* c_0 */
    const double J = parameters[1];
    prepared[4] = J + m*(a_*a_); /* c_1 */
    prepared[5] = (4.0/5.0)*a_; /* c_2 */
    prepared[6] = (1.0/12.0)*a_; /* c_3 */
}

/* Which numbers parameters, coordinates and inputs were declared to have. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {60, "positive"},
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
    const double m = c[0];
    M[0] = m;
    M[3] = M[1] = 0.0;
    M[4] = m;
    const double theta = x[2];
    const double sin_theta = em_sin(theta);
    const double c_0 = c[3];
    M[6] = M[2] = -sin_theta*c_0;
    const double cos_theta = em_cos(theta);
    M[7] = M[5] = cos_theta*c_0;
    const double c_1 = c[4];
    M[8] = c_1;
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
    const double theta = x[2];
    const double sin_theta = em_sin(theta);
    A[0] = -sin_theta;
    const double cos_theta = em_cos(theta);
    A[1] = cos_theta;
    A[2] = 0.0;
    b[0] = 0.0;
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

/* After an accepted step, and at the start: C and s, constraints on velocities.
 * Returns 1 where y changed, 0 where not, -1 and *fault. */
EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* so did the eigenfactors */
    int changed = rested || (flags & EM_STABILISE);
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[2];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 15);
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
    em_spread(N, N1, coordinate1, y + 6, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 6);
    for (int i = 0; i < N1; ++i) y[15 + i] = s[coordinate1[i]];
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

#include "chaplygin_sleigh.h"

static const char *const coordinate_names[] = { "x", "y", "theta", NULL };
static const char *const parameter_names[] = { "m", "J", "a", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 0.5, 0.4, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 0.0, 0.0 };
static const double initial_v[N] = { -1.0, 0.0, 0.8 };
static const int carried[N] = { 1, 1, 1 };
static const em_shape shapes[] = {
    {"trace", 0, 2},
    {"disk", 2, 3},
    {"disk", 5, 3},
    {"line", 8, 4}
};
static const em_slice layout[] = {
    {"x", 0, 3},
    {"eta", 3, 3},
    {"C", 6, 9},
    {"s", 15, 3}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "dV/dx: there is no potential energy",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "a factor of Delta: one constraint, Delta is a number",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dx, dM/dy: M does not depend on them",
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
static int simulate(em_run *run) { return em_simulate(&chaplygin_sleigh_model, run); }
/* the state within it, */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&chaplygin_sleigh_model, run, step, t, y);
}
/* the end of its tables, */
static void release(em_run *run) { em_release(&chaplygin_sleigh_model, run); }
/* a run that goes on as it is told, */
static void *open_run(em_run *run) { return em_handle_open(&chaplygin_sleigh_model, run); }
/* its size, */
static size_t saved(void) { return em_handle_saved(&chaplygin_sleigh_model); }
/* and a run in a lane. */
static void *enter(em_run *run, int *mode) { return em_member_enter(&chaplygin_sleigh_model, run, mode); }

const em_model chaplygin_sleigh_model = {
    .abi = EM_ABI,
    .name = "chaplygin_sleigh",
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
    .lanes = &chaplygin_sleigh_lanes,
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
    .n_shapes = 4,
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
