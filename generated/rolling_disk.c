/* eigenmotion generate rolling_disk.py */
/* input sha256:54f552f8bf8eaf402fe74f441e34761761c25ec8db4dad6aa08f8e7416ea6409 */
/* body sha256:2d60be079f4c1aee813985dc173799dfb8ef4a90b555e7e555f7d54630f11cb2 */
/* rolling_disk: equations of motion, eigenfactor formulation.
 *
 * State, 40 numbers:
 *   x    y[0 .. 5)
 *   eta  y[5 .. 10)
 *   C    y[10 .. 35)
 *   s    y[35 .. 40)
 *
 * Blocks of M that do not couple:
 *   1: x, y, phi, theta, psi (C and s are states)
 *
 * Left out, because this scene does not need it:
 *   G, Gdot, dG/dx: T has no part linear in the velocities
 *   dT0/dx: T has no part free of velocities
 *   Q: there are no other forces
 *   dM/dt, dA/dt, dV/dt: the time does not occur
 *   b, bdot: the constraints are homogeneous in the velocities
 *   dM/dx, dM/dy, dM/dpsi: M does not depend on them
 *
 * Operations of the straight-line part:
 *   eigenfactor: 14 additions, 54 multiplications, 4 function calls
 *   triangular root: 15 additions, 66 multiplications, 4 function calls
 *   projection: 5 additions, 33 multiplications, 4 function calls
 */
/* Callers use the same arguments for all models; each function uses those that this model needs. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "numeric/em_functions.h"
#include "constraints/em_multipliers.h"

/* Sizes. */
enum {
    N = 5,                /* coordinates */
    N_ROWS = 2,           /* constraint rows */
    N_POSITIONS = 0,      /* of which holonomic */
    N_STATE = 40,         /* numbers of a state */
    N_C = 25,             /* of which C, */
    N_S = 5,              /* s, */
    N_CD = 0,             /* C of Delta, */
    N_SD = 0,             /* s of Delta */
    N_INPUTS = 0,
    N_EVENTS = 0,
    N_MEMORY = 30,        /* numbers that a run keeps from one accepted step to the next */
    EM_SECOND_ORDER = 0,  /* whether the state is x, xdot */
};
#ifdef EM_UNIT
#include "loop/em_units.h"
#endif
#if EM_HOLDS(EM_MODEL | EM_RHS | EM_ASIDE | EM_DERIVATIVES)

enum {
    N_PARAMETERS = 3,
    N_PREPARED = 19,      /* the parameters, factors of constant blocks, shared constants c_0, ... */
    N_OUTPUTS = 0,
    N_FORCING = 4,        /* inputs, parameters and the time */
    N_ARGUMENTS = 14,     /* x, v and these: the arguments of derivatives */
    N1 = 5,               /* x, y, phi, theta, psi */
};

/* Coordinates of the blocks. */
EM_UNUSED static const int coordinate1[N1] = { 0, 1, 2, 3, 4 };
#endif

#if EM_HOLDS(EM_RHS)

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void eigenfactor_motion(const real *restrict x, const real *restrict v, const real *restrict c,
                                  real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real c_0 = c[3];
    const real phi = x[2];
    const real cos_phi = em_cos(phi);
    const real theta_dot = v[3];
    const real theta = x[3];
    const real cos_theta = em_cos(theta);
    const real z_2 = theta_dot*cos_theta;
    const real sin_phi = em_sin(phi);
    const real phi_dot = v[2];
    const real sin_theta = em_sin(theta);
    const real z_5 = phi_dot*sin_theta;
    Mdot1[0][2] = Mdot1[2][0] = c_0*(-(cos_phi*z_2 - sin_phi*z_5));
    Mdot1[1][2] = Mdot1[2][1] = -c_0*(cos_phi*z_5 + sin_phi*z_2);
    const real c_4 = c[7];
    Mdot1[2][2] = sin_theta*c_4*z_2;
    const real z_6 = theta_dot*sin_theta;
    const real z_7 = phi_dot*cos_theta;
    Mdot1[0][3] = Mdot1[3][0] = c_0*(sin_phi*z_6 - cos_phi*z_7);
    Mdot1[1][3] = Mdot1[3][1] = -c_0*(sin_phi*z_7 + cos_phi*z_6);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    Mdot1[3][3] = em_real(0.0);
    Mdot1[0][4] = Mdot1[4][0] = em_real(0.0);
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_3 = c[6];
    Mdot1[2][4] = Mdot1[4][2] = -c_3*z_2;
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    f1[0] = em_real(0.0);
    f1[1] = em_real(0.0);
    const real x_dot = v[0];
    const real y_dot = v[1];
    f1[2] = -(cos_phi*(c_0*(x_dot*z_2 + y_dot*z_5)) + sin_phi*(c_0*(y_dot*z_2 - x_dot*z_5)));
    const real c_1 = c[4];
    const real z_8 = phi_dot*phi_dot;
    const real c_5 = c[8];
    const real c_6 = c[9];
    const real psi_dot = v[4];
    const real z_9 = phi_dot*psi_dot;
    const real c_7 = c[10];
    const real c_8 = c[11];
    f1[3] = 0.25*(sin_theta*(c_5 + sin_phi*c_6*(x_dot*theta_dot) - cos_theta*c_1*z_8 -
        cos_phi*c_6*(y_dot*theta_dot)) - 2.0*cos_theta*(c_1*z_9 + sin_phi*c_7*(y_dot*phi_dot) +
        cos_phi*c_7*(x_dot*phi_dot) - sin_theta*c_8*z_8));
    f1[4] = em_real(0.0);
    A1[0][0] = em_real(1.0);
    A1[0][1] = em_real(0.0);
    A1[0][2] = em_real(0.0);
    A1[0][3] = em_real(0.0);
    const real r = c[1];
    const real z_10 = r*cos_phi;
    A1[0][4] = -z_10;
    A1[1][0] = em_real(0.0);
    A1[1][1] = em_real(1.0);
    A1[1][2] = em_real(0.0);
    A1[1][3] = em_real(0.0);
    const real z_11 = r*sin_phi;
    A1[1][4] = -z_11;
    gamma[0] = z_11*z_9;
    gamma[1] = -z_10*z_9;
}

/* xdot alone (20) */
EM_INLINE int velocities(real t, const real *restrict y, const real *restrict c, real *restrict dy,
                         em_fault *restrict fault)
{

    /* x, y, phi, theta, psi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    const real *const C1 = y + 10, *const s1 = y + 35;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];
    return 0;
}

/* The published system: xdot (20), etadot (45), Cdot (30), sdot (35).
 *   y, dy (n_state)    c prepared parameters    u inputs */
static int rhs_eigenfactor(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                           double *memory, int flags, real *restrict dy, em_fault *restrict fault)
{

    /* x, y, phi, theta, psi: xdot = C^T S^-1 eta (20) */
    const real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    const real *const C1 = y + 10, *const s1 = y + 35;
    real r1[N1], w1[N1], v1[N1];
    em_velocity(N1, C1, s1, eta1, r1, w1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    eigenfactor_motion(y, dy, c, Mdot1, f1, A1, gamma);

    /* x, y, phi, theta, psi: B = A C^T S^-1 (28) */
    real B1[N_ROWS][N1];
    em_rows_on_eta(N_ROWS, N1, C1, r1, A1[0], B1[0]);

    /* x, y, phi, theta, psi: mu = C Mdot C^T (31), Omega_ij = mu_ij / (s_j^2 - s_i^2) (32) */
    real T1[N1*N1], mu1[N1*N1], Omega1[N1*N1];
    em_transpose_for_tiles(N1, C1, T1);
    em_congruence_below(N1, C1, T1, Mdot1[0], mu1);
    em_omega_apart(N1, s1, mu1, Omega1);
    /* Cdot = -Omega C (30), sdot_i = mu_ii / (2 s_i) (35) */
    real *const C1_dot = dy + 10, *const s1_dot = dy + 35;
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
    dy[5] = a1[0];
    dy[6] = a1[1];
    dy[7] = a1[2];
    dy[8] = a1[3];
    dy[9] = a1[4];
    return 0;
}

/* M of the blocks that vary: the lower triangle */
EM_INLINE void triangular_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                                 real shared[4])
{
    const real m = c[0];
    M1[0][0] = m;
    M1[1][0] = em_real(0.0);
    M1[1][1] = m;
    const real theta = x[3];
    const real sin_theta = em_sin(theta);
    const real phi = x[2];
    const real cos_phi = em_cos(phi);
    const real c_0 = c[3];
    const real z_2 = cos_phi*c_0;
    M1[2][0] = -sin_theta*z_2;
    const real sin_phi = em_sin(phi);
    const real z_4 = sin_phi*c_0;
    M1[2][1] = -sin_theta*z_4;
    const real c_1 = c[4];
    const real cos_theta = em_cos(theta);
    M1[2][2] = 0.25*(c_1*(cos_theta*cos_theta + 6.0*sin_theta*sin_theta));
    M1[3][0] = -cos_theta*z_4;
    M1[3][1] = cos_theta*z_2;
    M1[3][2] = em_real(0.0);
    const real c_2 = c[5];
    M1[3][3] = c_2;
    M1[4][0] = em_real(0.0);
    M1[4][1] = em_real(0.0);
    const real c_3 = c[6];
    M1[4][2] = -sin_theta*c_3;
    M1[4][3] = em_real(0.0);
    M1[4][4] = c_3;
    shared[0] = cos_phi;
    shared[1] = cos_theta;
    shared[2] = sin_phi;
    shared[3] = sin_theta;
}

/* Mdot, force f = 1/2 xdot^T M_x xdot + G_x^T xdot + F (29), A, gamma = Adot xdot + bdot */
EM_INLINE void triangular_motion(const real *restrict v, const real *restrict c, const real shared[4],
                                 real Mdot1[N1][N1], real f1[N1], real A1[N_ROWS][N1], real gamma[N_ROWS])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real c_0 = c[3];
    const real cos_phi = shared[0];
    const real theta_dot = v[3];
    const real cos_theta = shared[1];
    const real z_6 = theta_dot*cos_theta;
    const real sin_phi = shared[2];
    const real phi_dot = v[2];
    const real sin_theta = shared[3];
    const real z_7 = phi_dot*sin_theta;
    Mdot1[0][2] = Mdot1[2][0] = c_0*(-(cos_phi*z_6 - sin_phi*z_7));
    Mdot1[1][2] = Mdot1[2][1] = -c_0*(cos_phi*z_7 + sin_phi*z_6);
    const real c_4 = c[7];
    Mdot1[2][2] = sin_theta*c_4*z_6;
    const real z_8 = theta_dot*sin_theta;
    const real z_9 = phi_dot*cos_theta;
    Mdot1[0][3] = Mdot1[3][0] = c_0*(sin_phi*z_8 - cos_phi*z_9);
    Mdot1[1][3] = Mdot1[3][1] = -c_0*(sin_phi*z_9 + cos_phi*z_8);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    Mdot1[3][3] = em_real(0.0);
    Mdot1[0][4] = Mdot1[4][0] = em_real(0.0);
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_3 = c[6];
    Mdot1[2][4] = Mdot1[4][2] = -c_3*z_6;
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
    f1[0] = em_real(0.0);
    f1[1] = em_real(0.0);
    const real x_dot = v[0];
    const real y_dot = v[1];
    f1[2] = -(cos_phi*(c_0*(x_dot*z_6 + y_dot*z_7)) + sin_phi*(c_0*(y_dot*z_6 - x_dot*z_7)));
    const real c_1 = c[4];
    const real z_10 = phi_dot*phi_dot;
    const real c_5 = c[8];
    const real c_6 = c[9];
    const real psi_dot = v[4];
    const real z_11 = phi_dot*psi_dot;
    const real c_7 = c[10];
    const real c_8 = c[11];
    f1[3] = 0.25*(sin_theta*(c_5 + sin_phi*c_6*(x_dot*theta_dot) - cos_theta*c_1*z_10 -
        cos_phi*c_6*(y_dot*theta_dot)) - 2.0*cos_theta*(c_1*z_11 + sin_phi*c_7*(y_dot*phi_dot) +
        cos_phi*c_7*(x_dot*phi_dot) - sin_theta*c_8*z_10));
    f1[4] = em_real(0.0);
    A1[0][0] = em_real(1.0);
    A1[0][1] = em_real(0.0);
    A1[0][2] = em_real(0.0);
    A1[0][3] = em_real(0.0);
    const real r = c[1];
    const real z_12 = r*cos_phi;
    A1[0][4] = -z_12;
    A1[1][0] = em_real(0.0);
    A1[1][1] = em_real(1.0);
    A1[1][2] = em_real(0.0);
    A1[1][3] = em_real(0.0);
    const real z_13 = r*sin_phi;
    A1[1][4] = -z_13;
    gamma[0] = z_13*z_11;
    gamma[1] = -z_12*z_11;
}

/* The triangular root: eta = L^T xdot, M = L L^T, Ldot = L Phi, Phi the lower triangle, with half the diagonal, of
 * L^-1 Mdot L^-T. The same equations with L in place of C^T S; the other states are constant. */
static int rhs_cholesky(real t, const real *restrict y, const real *restrict c, const real *restrict u,
                        int flags, real *restrict dy, em_fault *restrict fault)
{
    real M1[N1][N1], shared[4];
    triangular_masses(y, c, M1, shared);

    /* x, y, phi, theta, psi: M = L L^T */
    real L1[N1][N1], r1[N1];
    const int singular1 = em_cholesky(N1, M1[0], L1[0], r1, EM_SINGULAR_PIVOT);
    if (singular1 >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, coordinate1[singular1], -1, 0.0);
    const real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    real v1[N1];
    em_copy(N1, eta1, v1);
    em_backward(N1, L1[0], r1, v1);
    dy[0] = v1[0];
    dy[1] = v1[1];
    dy[2] = v1[2];
    dy[3] = v1[3];
    dy[4] = v1[4];

    real Mdot1[N1][N1], f1[N1], A1[N_ROWS][N1], gamma[N_ROWS];
    triangular_motion(dy, c, shared, Mdot1, f1, A1, gamma);

    /* x, y, phi, theta, psi: a = L^-1 f - Phi eta;  Bdot eta = Adot xdot + B q */
    real a1[N1], q1[N1];
    em_triangular_push(N1, L1[0], r1, Mdot1[0], eta1, f1, a1, q1);

    /* x, y, phi, theta, psi: B = A L^-T */
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
    dy[5] = a1[0];
    dy[6] = a1[1];
    dy[7] = a1[2];
    dy[8] = a1[3];
    dy[9] = a1[4];
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
#if EM_HOLDS(EM_MODEL) && !defined(EM_NODES_ALONE)

/* M of the blocks that vary, A, b: A xdot + b = 0 */
EM_INLINE void settled_masses(const real *restrict x, const real *restrict c, real M1[N1][N1],
                              real A1[N_ROWS][N1], real b[N_ROWS], real shared[4])
{
    const real m = c[0];
    M1[0][0] = m;
    M1[0][1] = M1[1][0] = em_real(0.0);
    M1[1][1] = m;
    const real theta = x[3];
    const real sin_theta = em_sin(theta);
    const real phi = x[2];
    const real cos_phi = em_cos(phi);
    const real c_0 = c[3];
    const real z_2 = cos_phi*c_0;
    M1[0][2] = M1[2][0] = -sin_theta*z_2;
    const real sin_phi = em_sin(phi);
    const real z_4 = sin_phi*c_0;
    M1[1][2] = M1[2][1] = -sin_theta*z_4;
    const real c_1 = c[4];
    const real cos_theta = em_cos(theta);
    M1[2][2] = 0.25*(c_1*(cos_theta*cos_theta + 6.0*sin_theta*sin_theta));
    M1[0][3] = M1[3][0] = -cos_theta*z_4;
    M1[1][3] = M1[3][1] = cos_theta*z_2;
    M1[2][3] = M1[3][2] = em_real(0.0);
    const real c_2 = c[5];
    M1[3][3] = c_2;
    M1[0][4] = M1[4][0] = em_real(0.0);
    M1[1][4] = M1[4][1] = em_real(0.0);
    const real c_3 = c[6];
    M1[2][4] = M1[4][2] = -sin_theta*c_3;
    M1[3][4] = M1[4][3] = em_real(0.0);
    M1[4][4] = c_3;
    A1[0][0] = em_real(1.0);
    A1[0][1] = em_real(0.0);
    A1[0][2] = em_real(0.0);
    A1[0][3] = em_real(0.0);
    const real r = c[1];
    A1[0][4] = -r*cos_phi;
    A1[1][0] = em_real(0.0);
    A1[1][1] = em_real(1.0);
    A1[1][2] = em_real(0.0);
    A1[1][3] = em_real(0.0);
    A1[1][4] = -r*sin_phi;
    b[0] = em_real(0.0);
    b[1] = em_real(0.0);
    shared[0] = cos_phi;
    shared[1] = cos_theta;
    shared[2] = sin_phi;
    shared[3] = sin_theta;
}

/* Mdot */
EM_INLINE void settled_rates(const real *restrict v, const real *restrict c, const real shared[4],
                             real Mdot1[N1][N1])
{
    Mdot1[0][0] = em_real(0.0);
    Mdot1[0][1] = Mdot1[1][0] = em_real(0.0);
    Mdot1[1][1] = em_real(0.0);
    const real c_0 = c[3];
    const real cos_phi = shared[0];
    const real theta_dot = v[3];
    const real cos_theta = shared[1];
    const real z_6 = theta_dot*cos_theta;
    const real sin_phi = shared[2];
    const real phi_dot = v[2];
    const real sin_theta = shared[3];
    const real z_7 = phi_dot*sin_theta;
    Mdot1[0][2] = Mdot1[2][0] = c_0*(-(cos_phi*z_6 - sin_phi*z_7));
    Mdot1[1][2] = Mdot1[2][1] = -c_0*(cos_phi*z_7 + sin_phi*z_6);
    const real c_4 = c[7];
    Mdot1[2][2] = sin_theta*c_4*z_6;
    const real z_8 = theta_dot*sin_theta;
    const real z_9 = phi_dot*cos_theta;
    Mdot1[0][3] = Mdot1[3][0] = c_0*(sin_phi*z_8 - cos_phi*z_9);
    Mdot1[1][3] = Mdot1[3][1] = -c_0*(sin_phi*z_9 + cos_phi*z_8);
    Mdot1[2][3] = Mdot1[3][2] = em_real(0.0);
    Mdot1[3][3] = em_real(0.0);
    Mdot1[0][4] = Mdot1[4][0] = em_real(0.0);
    Mdot1[1][4] = Mdot1[4][1] = em_real(0.0);
    const real c_3 = c[6];
    Mdot1[2][4] = Mdot1[4][2] = -c_3*z_6;
    Mdot1[3][4] = Mdot1[4][3] = em_real(0.0);
    Mdot1[4][4] = em_real(0.0);
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

enum { N_PIVOTS = 5 };

/* The pivots of M of the blocks that vary, and its diagonal */
static void pivots_on_lanes(real t, const real *y, const real *c, real *pivots, real *diagonal)
{
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[4];
    settled_masses(y, c, M1, A1, b, shared);
    em_pivots(N1, M1[0], pivots, diagonal);
}

#define EM_PIVOTS pivots_on_lanes

/* v (n) <- the part of xdot that follows from e (n), eta or an error of it, by the roots in the state and the memory */
static void velocity_by_roots(int mode, const real *y, const real *c, const real *memory, const real *e, real *v)
{
    real v1[N1] = { e[0], e[1], e[2], e[3], e[4] };
    if (mode) em_backward(N1, memory + 0, memory + 25, v1);
    else em_velocity_of_eta(N1, y + 10, y + 35, v1);
    v[0] = v1[0];
    v[1] = v1[1];
    v[2] = v1[2];
    v[3] = v1[3];
    v[4] = v1[4];
}

#define EM_VELOCITY velocity_by_roots

/* After an accepted step: C and s, constraints on velocities.
 * *done <- 0 in lanes that the scalar code must settle, for example where the mode changes;
 * a singular matrix leaves NaN. */
static int settle_on_lanes(int mode, real t, real *y, const real *c, real *memory, real pace, em_truth *done)
{
    EM_UNUSED em_fault whole, *const fault = &whole;
    EM_UNUSED const int flags = 0;
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[4];
    settled_masses(y, c, M1, A1, b, shared);
    real eta1[N1] = { y[5], y[6], y[7], y[8], y[9] };
    *done &= em_refresh(N1, M1[0], y + 10, y + 35, mode ? NULL : eta1);
    y[5] = eta1[0];
    y[6] = eta1[1];
    y[7] = eta1[2];
    y[8] = eta1[3];
    y[9] = eta1[4];
    if (mode) em_cholesky(N1, M1[0], memory + 0, memory + 25, EM_SINGULAR_PIVOT);

    real gap = em_gap(N1, y + 35);
    if (em_any(~(gap > EM_APART))) {
        real dy[N];
        velocity_by_roots(mode, y, c, memory, y + N, dy);
        real Mdot1[N1][N1];
        settled_rates(dy, c, shared, Mdot1);
        real time = em_time_on_lanes(N1, y + 10, y + 35, Mdot1[0]);
        *done &= em_keeps_mode(mode, gap, time, pace);
    } else if (mode) *done = (em_truth){0};

    real B1[N_ROWS][N1];
    if (mode) em_rows_of_root(N_ROWS, N1, memory + 0, memory + 25, A1[0], B1[0]);
    else em_rows_of_factors(N_ROWS, N1, y + 10, y + 35, A1[0], B1[0]);
    real a1[N1] = { y[5], y[6], y[7], y[8], y[9] };

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
    y[5] = a1[0];
    y[6] = a1[1];
    y[7] = a1[2];
    y[8] = a1[3];
    y[9] = a1[4];
    return 0;
}

#define EM_SETTLE settle_on_lanes
#include "batch/em_lane_runge_kutta.h"
#endif

extern em_lanes rolling_disk_lanes;
em_lanes rolling_disk_lanes = { EM_LANES, rhs_on_lanes, velocity_on_lanes, em_group_run, EM_REMEMBERED, 2, N_PREPARED };
#endif

#else
#if EM_HOLDS(EM_ASIDE)

/* --- functions that no step calls --- */

/* bias (n): M xddot + A^T lambda = bias (11);  gamma (m) = Adot xdot + bdot: A xddot + gamma = 0 */
EM_EXPORT void motion_bias(double t, const double *restrict x, const double *restrict v,
                           const double *restrict c, const double *restrict u, double *restrict bias,
                           double *restrict gamma)
{
    const double c_0 = c[3];
    const double phi_dot = v[2];
    const double z_0 = phi_dot*phi_dot;
    const double theta = x[3];
    const double sin_theta = em_sin(theta);
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double z_3 = sin_theta*sin_phi;
    const double cos_phi = em_cos(phi);
    const double theta_dot = v[3];
    const double cos_theta = em_cos(theta);
    const double z_6 = phi_dot*cos_theta;
    const double z_7 = theta_dot*z_6;
    const double z_8 = cos_phi*z_7;
    const double z_9 = theta_dot*theta_dot;
    bias[0] = -(c_0*(z_0*z_3 - z_8) - c_0*(z_8 - z_9*z_3));
    const double z_10 = sin_phi*z_7;
    const double z_11 = cos_phi*sin_theta;
    bias[1] = c_0*(z_10 + z_0*z_11) + c_0*(z_10 + z_9*z_11);
    const double x_dot = v[0];
    const double z_12 = x_dot*theta_dot;
    const double z_13 = z_3*(x_dot*phi_dot) - z_12*(cos_phi*cos_theta);
    const double y_dot = v[1];
    const double z_14 = y_dot*theta_dot;
    const double z_15 = z_11*(y_dot*phi_dot) + z_14*(cos_theta*sin_phi);
    const double psi_dot = v[4];
    const double c_1 = c[4];
    const double c_9 = c[12];
    bias[2] = 0.5*(2.0*c_0*(z_13 - z_15) - (2.0*c_0*z_13 + c_9*(sin_theta*z_7) - 2.0*c_0*z_15 -
        theta_dot*cos_theta*(psi_dot*c_1)));
    const double z_16 = z_6*(x_dot*cos_phi);
    const double c_6 = c[9];
    const double z_17 = z_6*(y_dot*sin_phi);
    const double z_18 = z_3*z_12;
    const double z_19 = z_11*z_14;
    const double c_10 = c[13];
    const double c_5 = c[8];
    bias[3] = (-0.25)*(((z_16*c_6 + z_17*c_6 + z_19*c_6 + psi_dot*c_10*z_6 - c_9*(z_0*(sin_theta*cos_theta)) -
        z_18*c_6) - sin_theta*c_5) - 4.0*(c_0*(z_16 - z_18) + c_0*(z_17 + z_19)));
    const double c_3 = c[6];
    bias[4] = c_3*z_7;
    const double r = c[1];
    const double z_20 = r*(phi_dot*psi_dot);
    gamma[0] = sin_phi*z_20;
    gamma[1] = -cos_phi*z_20;
}


/* e (4): T2, T1, T0, V                                                                                          (4) */
EM_EXPORT void energy(double t, const double *restrict x, const double *restrict v, const double *restrict c,
                      double *restrict e)
{
    const double x_dot = v[0];
    const double m = c[0];
    const double phi_dot = v[2];
    const double theta = x[3];
    const double sin_theta = em_sin(theta);
    const double z_1 = phi_dot*sin_theta;
    const double phi = x[2];
    const double cos_phi = em_cos(phi);
    const double c_0 = c[3];
    const double z_3 = cos_phi*c_0;
    const double sin_phi = em_sin(phi);
    const double z_5 = sin_phi*c_0;
    const double theta_dot = v[3];
    const double cos_theta = em_cos(theta);
    const double z_7 = theta_dot*cos_theta;
    const double y_dot = v[1];
    const double c_1 = c[4];
    const double c_6 = c[9];
    const double z_8 = cos_phi*c_6;
    const double z_9 = sin_phi*c_6;
    const double c_10 = c[13];
    const double psi_dot = v[4];
    const double c_9 = c[12];
    e[0] = 0.125*(4.0*x_dot*(x_dot*m - z_1*z_3 - z_5*z_7) + 4.0*y_dot*(y_dot*m + z_3*z_7 - z_1*z_5) -
        phi_dot*(x_dot*sin_theta*z_8 + y_dot*sin_theta*z_9 + c_10*(psi_dot*sin_theta) -
        phi_dot*(c_1*(cos_theta*cos_theta + 6.0*sin_theta*sin_theta))) - theta_dot*(x_dot*cos_theta*z_9 -
        y_dot*cos_theta*z_8 - theta_dot*c_9) - 2.0*psi_dot*(c_1*(-(psi_dot - z_1))));
    e[1] = 0.0;
    e[2] = 0.0;
    const double c_11 = c[14];
    e[3] = cos_theta*c_11;
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
    p[0] = x_;
    const double y = x[1];
    p[1] = y;
    p[2] = p[5] = p[8] = p[11] = p[14] = 0.0;
    const double c_12 = c[15];
    p[3] = p[12] = c_12;
    const double c_13 = c[16];
    p[4] = p[7] = c_13;
    const double c_14 = c[17];
    p[6] = p[9] = c_14;
    const double c_15 = c[18];
    p[10] = p[13] = c_15;
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double r = c[1];
    const double theta = x[3];
    const double sin_theta = em_sin(theta);
    const double z_2 = r*sin_theta;
    p[15] = x_ - sin_phi*z_2;
    const double cos_phi = em_cos(phi);
    p[16] = y + cos_phi*z_2;
    const double cos_theta = em_cos(theta);
    p[17] = r*cos_theta;
    p[18] = r;
    p[19] = -cos_theta*sin_phi;
    p[20] = cos_phi*cos_theta;
    p[21] = -sin_theta;
    const double psi = x[4];
    p[22] = psi;
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
    const double theta = x[3];
    const double sin_theta = em_sin(theta);
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double m = c[0];
    const double r = c[1];
    const double z_2 = m*r;
    const double z_3 = sin_phi*z_2;
    dM[60] = dM[52] = sin_theta*z_3;
    const double cos_phi = em_cos(phi);
    const double z_5 = cos_phi*z_2;
    dM[61] = dM[57] = -sin_theta*z_5;
    const double cos_theta = em_cos(theta);
    dM[65] = dM[53] = -cos_theta*z_5;
    dM[66] = dM[58] = -cos_theta*z_3;
    dM[85] = dM[77] = -cos_theta*z_5;
    dM[86] = dM[82] = -cos_theta*z_3;
    const double z_7 = r*r*(m*cos_theta);
    dM[87] = 2.5*(sin_theta*z_7);
    dM[90] = dM[78] = sin_theta*z_3;
    dM[91] = dM[83] = -sin_theta*z_5;
    dM[97] = dM[89] = (-0.5)*z_7;
}

/* D (n + m, 2 n) of r = M a + P^T lambda - bias and s = A a + gamma with respect to x, v, at fixed a, lambda */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void state_partials(double t, const double *restrict x, const double *restrict v,
                              const double *restrict a, const double *restrict lambda,
                              const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * 2 * N);
    const double phi = x[2];
    const double cos_phi = em_cos(phi);
    const double theta_ddot = a[3];
    const double theta = x[3];
    const double cos_theta = em_cos(theta);
    const double m = c[0];
    const double r = c[1];
    const double z_2 = m*r;
    const double z_3 = cos_theta*z_2;
    const double theta_dot = v[3];
    const double z_4 = theta_dot*theta_dot;
    const double sin_theta = em_sin(theta);
    const double z_6 = sin_theta*z_2;
    const double phi_dot = v[2];
    const double z_7 = phi_dot*phi_dot;
    const double z_8 = theta_ddot*z_3 - z_4*z_6 - z_7*z_6;
    const double sin_phi = em_sin(phi);
    const double phi_ddot = a[2];
    const double z_10 = phi_dot*theta_dot;
    const double z_11 = phi_ddot*z_6 + 2.0*z_10*z_3;
    D[2] = -(cos_phi*z_8 - sin_phi*z_11);
    const double z_12 = sin_phi*z_2;
    const double z_13 = cos_phi*z_2;
    D[3] = sin_theta*(theta_ddot*z_12 + 2.0*z_13*z_10) - cos_theta*(phi_ddot*z_13 - z_4*z_12 - z_7*z_12);
    const double z_14 = phi_dot*sin_theta;
    const double z_15 = cos_theta*z_13;
    D[7] = 2.0*(z_12*z_14 - theta_dot*z_15);
    const double z_16 = theta_dot*sin_theta;
    D[8] = 2.0*(z_12*z_16 - phi_dot*z_15);
    D[12] = -(cos_phi*z_11 + sin_phi*z_8);
    D[13] = -(sin_theta*(theta_ddot*z_13 - 2.0*z_12*z_10) + cos_theta*(phi_ddot*z_12 + z_4*z_13 + z_7*z_13));
    const double z_17 = cos_theta*z_12;
    D[17] = (-2.0)*(z_13*z_14 + theta_dot*z_17);
    D[18] = (-2.0)*(phi_dot*z_17 + z_13*z_16);
    const double y_ddot = a[1];
    const double z_18 = y_ddot*z_13;
    const double x_ddot = a[0];
    const double z_19 = x_ddot*z_12;
    D[22] = -(sin_theta*z_18 - sin_theta*z_19);
    const double psi_dot = v[4];
    const double z_20 = m*(r*r);
    const double z_21 = sin_theta*z_20;
    const double z_22 = z_10*z_21;
    const double z_23 = cos_theta*z_20;
    const double z_24 = phi_ddot*z_23;
    const double psi_ddot = a[4];
    D[23] = 0.5*(sin_theta*(theta_dot*psi_dot*z_20 - 5.0*z_22 - z_24) + cos_theta*(5.0*z_23*z_10 +
        6.0*phi_ddot*z_21 - psi_ddot*z_20 - 2.0*y_ddot*z_12 - 2.0*x_ddot*z_13));
    D[27] = 2.5*(z_23*z_16);
    const double z_25 = psi_dot*z_23 - 5.0*z_23*z_14;
    D[28] = (-0.5)*z_25;
    D[29] = (-0.5)*(theta_dot*z_23);
    D[32] = -(x_ddot*z_15 + y_ddot*z_17);
    const double z_26 = phi_dot*psi_dot;
    const double g = c[2];
    D[33] = (-0.25)*(sin_theta*(2.0*z_20*z_26 + 4.0*z_18 - 5.0*z_7*z_21 - 4.0*z_19) + cos_theta*(4.0*g*z_2 +
        5.0*z_7*z_23));
    D[37] = 0.5*z_25;
    const double z_27 = phi_dot*z_23;
    D[39] = 0.5*z_27;
    const double lambda_1 = lambda[1];
    const double z_28 = r*cos_phi;
    const double lambda_0 = lambda[0];
    const double z_29 = r*sin_phi;
    D[42] = -(lambda_1*z_28 - lambda_0*z_29);
    D[43] = 0.5*(z_22 - z_24);
    D[47] = (-0.5)*(theta_dot*z_23);
    D[48] = (-0.5)*z_27;
    D[52] = z_28*z_26 + psi_ddot*z_29;
    D[57] = psi_dot*z_29;
    D[59] = phi_dot*z_29;
    D[62] = z_29*z_26 - psi_ddot*z_28;
    D[67] = -psi_dot*z_28;
    D[69] = -phi_dot*z_28;
}

/* D (n + m, n_inputs + n_parameters + 1) of r and s with respect to inputs, parameters, time */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void forcing_partials(double t, const double *restrict x, const double *restrict v,
                                const double *restrict a, const double *restrict lambda,
                                const double *restrict c, const double *restrict u, double *restrict D)
{
    memset(D, 0, sizeof *D * (N + N_ROWS) * N_FORCING);
    const double phi_dot = v[2];
    const double z_0 = phi_dot*phi_dot;
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double r = c[1];
    const double theta = x[3];
    const double sin_theta = em_sin(theta);
    const double z_3 = r*sin_theta;
    const double z_4 = sin_phi*z_3;
    const double cos_phi = em_cos(phi);
    const double cos_theta = em_cos(theta);
    const double z_7 = r*cos_theta;
    const double theta_dot = v[3];
    const double z_8 = phi_dot*theta_dot;
    const double z_9 = z_7*z_8;
    const double z_10 = theta_dot*theta_dot;
    const double x_ddot = a[0];
    const double theta_ddot = a[3];
    const double z_11 = sin_phi*z_7;
    const double phi_ddot = a[2];
    const double z_12 = cos_phi*z_3;
    D[0] = z_0*z_4 + z_10*z_4 + x_ddot - 2.0*cos_phi*z_9 - theta_ddot*z_11 - phi_ddot*z_12;
    const double m = c[0];
    const double z_13 = m*cos_theta;
    const double z_14 = sin_phi*z_13;
    const double z_15 = m*sin_theta;
    const double z_16 = cos_phi*z_15;
    const double z_17 = sin_phi*z_15;
    const double z_18 = cos_phi*z_13;
    D[1] = -(theta_ddot*z_14 + phi_ddot*z_16 + 2.0*z_8*z_18 - z_10*z_17 - z_0*z_17);
    const double y_ddot = a[1];
    const double z_19 = cos_phi*z_7;
    D[4] = -(2.0*sin_phi*z_9 + z_10*z_12 + z_0*z_12 + phi_ddot*z_4 - y_ddot - theta_ddot*z_19);
    D[5] = theta_ddot*z_18 - phi_ddot*z_17 - z_10*z_16 - z_0*z_16 - 2.0*z_8*z_14;
    const double psi_ddot = a[4];
    const double z_20 = r*r;
    const double z_21 = psi_ddot*z_20;
    const double z_22 = cos_theta*z_20;
    const double psi_dot = v[4];
    const double z_23 = theta_dot*psi_dot;
    const double z_24 = sin_theta*z_22;
    const double z_25 = sin_theta*sin_theta;
    const double z_26 = phi_ddot*z_20;
    const double z_27 = cos_theta*cos_theta;
    D[8] = (-0.25)*(2.0*sin_theta*z_21 + 4.0*y_ddot*z_4 + 4.0*x_ddot*z_12 + 2.0*z_22*z_23 - 10.0*z_8*z_24 -
        6.0*z_25*z_26 - z_27*z_26);
    const double z_28 = r*z_15;
    const double z_29 = m*z_7;
    const double z_30 = m*r;
    const double z_31 = phi_ddot*z_30;
    D[9] = (-0.5)*(2.0*z_28*psi_ddot + 2.0*y_ddot*z_17 + 2.0*x_ddot*z_16 + 2.0*z_23*z_29 - 10.0*z_15*z_9 -
        6.0*z_25*z_31 - z_27*z_31);
    const double g = c[2];
    const double z_32 = phi_dot*psi_dot;
    D[12] = 0.25*(5.0*theta_ddot*z_20 + 4.0*y_ddot*z_19 + 2.0*z_22*z_32 - 4.0*x_ddot*z_11 - 4.0*g*z_3 -
        5.0*z_0*z_24);
    D[13] = 0.5*(5.0*theta_ddot*z_30 + 2.0*y_ddot*z_18 + 2.0*z_32*z_29 - 2.0*x_ddot*z_14 - 2.0*g*z_15 -
        5.0*z_0*z_15*z_7);
    D[14] = -z_28;
    D[16] = 0.5*(z_21 - sin_theta*z_26 - z_8*z_22);
    const double lambda_0 = lambda[0];
    const double lambda_1 = lambda[1];
    D[17] = -(cos_phi*lambda_0 + sin_phi*lambda_1 + z_28*phi_ddot + m*z_9 - psi_ddot*z_30);
    D[21] = -(cos_phi*psi_ddot - sin_phi*z_32);
    D[25] = -(sin_phi*psi_ddot + cos_phi*z_32);
}

/* D (h + m, n_arguments), of phi and A v + b */
EM_COLD_PATH /* no explicit step calls it */
EM_EXPORT void constraint_partials(double t, const double *restrict x, const double *restrict v,
                                   const double *restrict c, double *restrict D)
{
    memset(D, 0, sizeof *D * (N_POSITIONS + N_ROWS) * N_ARGUMENTS);
    const double phi = x[2];
    const double sin_phi = em_sin(phi);
    const double psi_dot = v[4];
    const double r = c[1];
    const double z_1 = psi_dot*r;
    D[2] = sin_phi*z_1;
    D[5] = 1.0;
    const double cos_phi = em_cos(phi);
    D[9] = -r*cos_phi;
    D[11] = -psi_dot*cos_phi;
    D[16] = -cos_phi*z_1;
    D[20] = 1.0;
    D[23] = -r*sin_phi;
    D[25] = -psi_dot*sin_phi;
}

#endif
#if EM_HOLDS(EM_MODEL)

/* If the version for lanes is linked, it replaces this one. */
extern em_lanes rolling_disk_lanes;
EM_WEAK em_lanes rolling_disk_lanes = {0, NULL, NULL, NULL, 0, 0, 0};

#include "dynamics/em_blocks.h"
#include "loop/em_assumptions.h"

/* The block of M each coordinate belongs to, and its unit in the eigenproblem. */
static const int block[N] = { 0, 0, 0, 0, 0 };
EM_EXPORT const double scales[N] = { 1.0, 1.0, 1.0, 1.0, 1.0 };

/* The location of the roots of the blocks: offsets of C, s, L, 1 / diag L. */
static const em_block block1 = { N, N1, coordinate1, scales, EM_IN_STATE, 10, 35, 0, 25 };
EM_EXPORT const em_block *const blocks[] = { &block1, NULL };

/* Terms in parameters only that other functions share */
EM_INLINE void prepared_constants(const double *restrict parameters, double prepared[N_PREPARED])
{
    const double m = parameters[0];
    const double r = parameters[1];
    const double z_0 = m*r;
    prepared[3] = z_0; /* c_0 */
    const double z_1 = m*(r*r);
    prepared[4] = z_1; /* c_1 */
    prepared[5] = 1.25*z_1; /* c_2 */
    prepared[6] = 0.5*z_1; /* c_3 */
    prepared[7] = 2.5*z_1; /* c_4 */
    const double g = parameters[2];
    const double z_2 = g*z_0;
    prepared[8] = 4.0*z_2; /* c_5 */
    prepared[9] = 4.0*z_0; /* c_6 */
    prepared[10] = 2.0*z_0; /* c_7 */
    prepared[11] = 3.0*z_1; /* c_8 */
    prepared[12] = 5.0*z_1; /* c_9 */
    prepared[13] = 2.0*z_1; /* c_10 */
    prepared[14] = z_2; /* c_11 */
    prepared[15] = (-4.0)*r; /* c_12 */
    prepared[16] = (-2.0)*r; /* c_13 */
    prepared[17] = 6.0*r; /* c_14 */
    prepared[18] = 8.0*r; /* c_15 */
}

/* The assumptions of parameters, coordinates and inputs. */
static const em_declared declared[] = {
    {60, "positive"},
    {60, "positive"},
    {63, ""},
    {63, ""},
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
    prepared_constants(parameters, c);
    return 0;
}

/* M (n, n)                                                                                                      (5) */
EM_EXPORT void mass_matrix(double t, const double *restrict x, const double *restrict c, double *restrict M)
{
    const double m = c[0];
    M[0] = m;
    M[5] = M[1] = 0.0;
    M[6] = m;
    const double theta = x[3];
    const double sin_theta = em_sin(theta);
    const double phi = x[2];
    const double cos_phi = em_cos(phi);
    const double c_0 = c[3];
    const double z_2 = cos_phi*c_0;
    M[10] = M[2] = -sin_theta*z_2;
    const double sin_phi = em_sin(phi);
    const double z_4 = sin_phi*c_0;
    M[11] = M[7] = -sin_theta*z_4;
    const double c_1 = c[4];
    const double cos_theta = em_cos(theta);
    M[12] = 0.25*(c_1*(cos_theta*cos_theta + 6.0*sin_theta*sin_theta));
    M[15] = M[3] = -cos_theta*z_4;
    M[16] = M[8] = cos_theta*z_2;
    M[17] = M[13] = 0.0;
    const double c_2 = c[5];
    M[18] = c_2;
    M[20] = M[4] = 0.0;
    M[21] = M[9] = 0.0;
    const double c_3 = c[6];
    M[22] = M[14] = -sin_theta*c_3;
    M[23] = M[19] = 0.0;
    M[24] = c_3;
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
    A[0] = 1.0;
    A[1] = 0.0;
    A[2] = 0.0;
    A[3] = 0.0;
    const double r = c[1];
    const double phi = x[2];
    const double cos_phi = em_cos(phi);
    A[4] = -r*cos_phi;
    A[5] = 0.0;
    A[6] = 1.0;
    A[7] = 0.0;
    A[8] = 0.0;
    const double sin_phi = em_sin(phi);
    A[9] = -r*sin_phi;
    b[0] = 0.0;
    b[1] = 0.0;
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
#endif
#if EM_HOLDS(EM_MODEL)

/* After an accepted step, and at the start: C and s, constraints on velocities.
 * Returns 1 if y changed, 0 if not, or -1 and *fault. */
EM_EXPORT int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                           em_fault *fault)
{
    const int rested = *mode; /* eigenfactors were constant */
    int changed = rested || (flags & EM_STABILISE);
    real M1[N1][N1], A1[N_ROWS][N1], b[N_ROWS], shared[4];
    settled_masses(y, c, M1, A1, b, shared);
    if (changed && em_settle_factors(&block1, *mode, 0, M1[0], y, memory, fault)) return -1;

    double gap = em_gap(N1, y + 35);
    int new_mode = em_mode_by_gaps(*mode, flags, gap, INFINITY);
    if (new_mode == EM_BY_TIME) {
        double dy[N]; /* xdot */
        em_velocity_kept(&block1, *mode, y + N, y, c, memory, dy);
        real Mdot1[N1][N1];
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

/* v (n): xdot from a state, according to its mode. */
EM_EXPORT int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault)
{
    double M[N*N];
    factored(t, y, c, M);
    if (em_velocity_at(&block1, mode, M, y, c, v, fault)) return -1;
    return 0;
}

/* ev (n): the error of xdot that follows from an error e (n) of eta. */
EM_EXPORT void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                    double *ev)
{
    em_velocity_kept(&block1, mode, e, y, c, memory, ev);
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
    em_spread(N, N1, coordinate1, y + 10, C);
    if (em_eigenfactors_of(t, x, c, C, s, fault)) return -1;
    for (int k = 0; k < N; ++k) eta[k] = v[k]/scales[k];
    em_eta_of_velocity(N, C, s, eta);
    memcpy(y + N, eta, sizeof eta);
    em_gather(N, N1, coordinate1, C, y + 10);
    for (int i = 0; i < N1; ++i) y[35 + i] = s[coordinate1[i]];
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

#include "rolling_disk.h"

static const char *const coordinate_names[] = { "x", "y", "phi", "theta", "psi", NULL };
static const char *const parameter_names[] = { "m", "r", "g", NULL };
static const char *const input_names[] = { NULL };
static const char *const output_names[] = { NULL };
static const char *const event_names[] = { NULL };
static const int event_direction[] = { 0 };
static const int event_terminal[] = { 0 };
static const double parameter_defaults[] = { 1.0, 0.5, 9.81, 0.0 };
static const double input_defaults[] = { 0.0 };
static const double initial_x[N] = { 0.0, 0.0, 0.0, 0.3, 0.0 };
static const double initial_v[N] = { 2.146192491889161, 0.0, 1.0, 0.0, 4.292384983778322 };
static const int carried[N] = { 1, 1, 1, 1, 1 };
static const em_shape shapes[] = {
    {"trace", 0, 3, 0, NULL},
    {"ground", 3, 12, 0, NULL},
    {"disk", 15, 8, 0, NULL}
};
static const em_slice layout[] = {
    {"x", 0, 5},
    {"eta", 5, 5},
    {"C", 10, 25},
    {"s", 35, 5}
};
static const char *const left_out[] = {
    "G, Gdot, dG/dx: T has no part linear in the velocities",
    "dT0/dx: T has no part free of velocities",
    "Q: there are no other forces",
    "dM/dt, dA/dt, dV/dt: the time does not occur",
    "b, bdot: the constraints are homogeneous in the velocities",
    "dM/dx, dM/dy, dM/dpsi: M does not depend on them",
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
static int simulate(em_run *run) { return em_simulate(&rolling_disk_model, run); }
/* the state within a run: */
static int interpolate(const em_run *run, size_t step, double t, double *y)
{
    return em_interpolate(&rolling_disk_model, run, step, t, y);
}
/* the memory of a run: */
static void release(em_run *run) { em_release(&rolling_disk_model, run); }
/* a run that advances on request: */
static void *open_run(em_run *run) { return em_handle_open(&rolling_disk_model, run); }
/* the size of its saved state: */
static size_t saved(void) { return em_handle_saved(&rolling_disk_model); }
/* forces of actuators: */
static int inverse_dynamics(double t, const double *x, const double *v, const double *a, const double *c,
                            const double *u, const em_actuators *actuators, double *forces, double *lambda,
                            double *residual, em_inverse_check *check, em_fault *fault)
{
    return em_inverse_dynamics(&rolling_disk_model, t, x, v, a, c, u, actuators, forces, lambda, residual,
                               check, fault);
}
/* a run on lanes: */
static void *enter(em_run *run, int *mode) { return em_member_enter(&rolling_disk_model, run, mode); }

const em_model rolling_disk_model = {
    .abi = EM_ABI,
    .name = "rolling_disk",
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
    .event = model_events,
    .lanes = &rolling_disk_lanes,
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
    .n_shapes = 3,
    .dimension = 3,
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
