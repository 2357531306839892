/* models/veering.py by hand, in a gauge that turns smoothly: C need not diagonalise M.
 *
 *   Lambda = C M C^T = L L^T,  eta = L^T C xdot,  Cdot = -Omega C,  state (x, eta, C)
 *   Omega_12 = mu_12 g / (g^2 + delta^2),  g = Lambda_22 - Lambda_11,  mu = C Mdot C^T
 *
 * DELTA: delta, in units of M. PACED: delta grows by PACED times what the eigenvalues approach in the time on which
 * the motion varies. DIAGONALISED: C is turned onto the eigenvectors after each step. Errors of C count, as in the
 * published system. */
#define EM_UNIT (EM_MODEL | EM_RHS | EM_ASIDE | EM_STEPPER) /* all that a run by dop853 needs */
#include "em_functions.h"
#include "em_multipliers.h"

#ifndef DELTA
#define DELTA 1.0
#endif
#ifndef PACED
#define PACED 0.0
#endif
#ifndef DIAGONALISED
#define DIAGONALISED 0
#endif

enum { N = 2, N_ROWS = 0, N_POSITIONS = 0, N_C = 4, N_S = 0, N_CD = 0, N_SD = 0, N_STATE = 8 };
enum { N_INPUTS = 0, N_EVENTS = 0, L_KEPT = 0, R_KEPT = 4, PACE = 6, N_MEMORY = 7 };
enum { GAP, K_X, K_Z, N_PARAMETERS };

#include "em_units.h"

EM_ACROSS const double scales[N] = {1.0, 1.0};
EM_ACROSS const em_block *const blocks[] = {NULL}; /* none with factors in the published meaning */

static void masses(const double *x, const double *c, double *M) {
    M[0] = 2.0 + 0.5 * x[0];
    M[1] = M[2] = c[GAP];
    M[3] = 2.0 - 0.5 * x[0];
}

EM_ACROSS void mass_matrix(double t, const double *x, const double *c, double *M) { (void)t, masses(x, c, M); }

EM_ACROSS void factored(double t, const double *x, const double *c, double *M) { (void)t, masses(x, c, M); }

EM_ACROSS void pfaffian(double t, const double *x, const double *c, double *A, double *b) {
    (void)t, (void)x, (void)c, (void)A, (void)b;
}

EM_ACROSS void position(double t, const double *x, const double *c, double *phi, double *terms) {
    (void)t, (void)x, (void)c, (void)phi, (void)terms;
}

/* bias: M xddot = bias */
EM_ACROSS void motion_bias(double t, const double *x, const double *v, const double *c, const double *u, double *bias,
                        double *gamma) {
    (void)t, (void)u, (void)gamma;
    bias[0] = -0.25 * (v[0] * v[0] + v[1] * v[1]) - c[K_X] * x[0];
    bias[1] = 0.5 * v[0] * v[1] - c[K_Z] * x[1];
}

/* e: T2, T1, T0, V */
EM_ACROSS void energy(double t, const double *x, const double *v, const double *c, double *e) {
    double M[N * N];
    masses(x, c, M);
    (void)t;
    e[0] = 0.5 * (v[0] * (M[0] * v[0] + 2.0 * M[1] * v[1]) + M[3] * v[1] * v[1]);
    e[1] = e[2] = 0.0;
    e[3] = 0.5 * (c[K_X] * x[0] * x[0] + c[K_Z] * x[1] * x[1]);
}

EM_ACROSS void observe(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
             const double *u, double *out) {
    (void)t, (void)x, (void)v, (void)a, (void)lambda, (void)c, (void)u, (void)out;
}

/* L, r with C M C^T = L L^T; Lambda <- C M C^T. */
static inline int factor(const double *y, const double *c, double *Lambda, double *L, double *r, em_fault *fault) {
    double M[N * N];
    masses(y, c, M);
    em_congruence(N, y + 2 * N, M, Lambda);
    const int singular = em_cholesky(N, Lambda, L, r, EM_SINGULAR_PIVOT);
    return singular < 0 ? 0 : em_fail(fault, EM_SINGULAR_MASS_MATRIX, singular, -1, 0.0);
}

/* v <- C^T L^-T eta */
static inline void onto_velocity(const double *C, const double *L, const double *r, const double *eta, double *v) {
    double w[N] = {eta[0], eta[1]};
    em_backward(N, L, r, w);
    for (int j = 0; j < N; ++j) v[j] = C[j] * w[0] + C[N + j] * w[1];
}

static inline double turning(const double *Lambda, const double *mu, double pace) {
    const double gap = Lambda[3] - Lambda[0], apart = mu[3] - mu[0];
    double square = gap * gap + DELTA * DELTA;
    if (PACED > 0.0) square += PACED * PACED * pace * pace * (apart * apart + 4.0 * mu[1] * mu[1]);
    return mu[1] * gap / square; /* Omega_12 = -Omega_21 */
}

EM_ACROSS int model_rhs(int mode, double t, const double *y, const double *c, const double *u, double *memory, int flags,
                     double *restrict dy, em_fault *fault) {
    const double *const eta = y + N, *const C = y + 2 * N;
    double Lambda[N * N], L[N * N], r[N], mu[N * N];
    (void)mode, (void)t, (void)u, (void)flags;
    if (factor(y, c, Lambda, L, r, fault)) return -1;
    onto_velocity(C, L, r, eta, dy);
    const double Mdot[N * N] = {0.5 * dy[0], 0.0, 0.0, -0.5 * dy[0]};
    const double f[N] = {0.25 * (dy[0] * dy[0] - dy[1] * dy[1]) - c[K_X] * y[0], -c[K_Z] * y[1]};
    em_congruence(N, C, Mdot, mu);
    const double Omega = turning(Lambda, mu, memory[PACE]);
    for (int j = 0; j < N; ++j) {
        dy[2 * N + j] = -Omega * C[N + j];
        dy[3 * N + j] = Omega * C[j];
    }
    /* Lambdadot = mu - Omega Lambda + Lambda Omega; Phi: the lower triangle, half the diagonal, of L^-1 Lambdadot L^-T */
    mu[0] -= 2.0 * Omega * Lambda[1];
    mu[3] += 2.0 * Omega * Lambda[1];
    mu[1] = mu[2] += Omega * (Lambda[0] - Lambda[3]);
    for (int j = 0; j < N; ++j) em_forward(N, L, r, mu + j * N);
    em_forward_columns(N, 0, L, r, mu);
    /* a = L^-1 (C f - Omega L eta) - Phi eta */
    double *const a = dy + N;
    a[0] = C[0] * f[0] + C[1] * f[1] - Omega * (L[2] * eta[0] + L[3] * eta[1]);
    a[1] = C[2] * f[0] + C[3] * f[1] + Omega * L[0] * eta[0];
    em_forward(N, L, r, a);
    a[0] -= 0.5 * mu[0] * eta[0];
    a[1] -= mu[2] * eta[0] + 0.5 * mu[3] * eta[1];
    return 0;
}

EM_ACROSS int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace,
                        em_fault *fault) {
    double *const eta = y + N, *const C = y + 2 * N, *const L = memory + L_KEPT, *const r = memory + R_KEPT;
    double Lambda[N * N];
    (void)mode, (void)t;
    if (!(flags & EM_KEEP_MODE)) memory[PACE] = pace;
    em_orthonormalise(N, C);
    if (factor(y, c, Lambda, L, r, fault)) return -1;
    if (!DIAGONALISED) return 1;
    em_backward(N, L, r, eta);
    const double w[N] = {C[0] * eta[0] + C[2] * eta[1], C[1] * eta[0] + C[3] * eta[1]};
    em_jacobi(N, Lambda, C);
    for (int i = 0; i < N; ++i) eta[i] = C[i * N] * w[0] + C[i * N + 1] * w[1];
    L[1] = L[2] = 0.0;
    for (int i = 0; i < N; ++i) {
        L[i * N + i] = sqrt(Lambda[i * N + i]);
        r[i] = 1.0 / L[i * N + i];
        eta[i] *= L[i * N + i];
    }
    return 1;
}

EM_ACROSS void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                 double *ev) {
    (void)mode, (void)c;
    onto_velocity(y + 2 * N, memory + L_KEPT, memory + R_KEPT, e, ev);
}

EM_ACROSS int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault) {
    double Lambda[N * N], L[N * N], r[N];
    (void)mode, (void)t;
    if (factor(y, c, Lambda, L, r, fault)) return -1;
    onto_velocity(y + 2 * N, L, r, y + N, v);
    return 0;
}

EM_ACROSS int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                         em_fault *fault) {
    (void)mode, (void)t, (void)c, (void)memory, (void)fault;
    memcpy(row, y, N_STATE * sizeof *row);
    return 0;
}

EM_ACROSS void model_events(double t, const double *x, const double *v, const double *c, const double *u, double *g) {
    (void)t, (void)x, (void)v, (void)c, (void)u, (void)g;
}

#include "em_mechanics.h"
#include "em_handle.h"

EM_ACROSS int prepare(const double *parameters, double *c, em_fault *fault) {
    (void)fault;
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    return 0;
}

/* y from x, v: C the eigenvectors, L = S */
EM_ACROSS int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault) {
    double M[N * N], s[N];
    (void)t;
    memcpy(y, x, N * sizeof *y);
    masses(x, c, M);
    const int singular = em_eigenfactors(N, M, y + 2 * N, s);
    if (singular >= 0) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, singular, -1, 0.0);
    memcpy(y + N, v, N * sizeof *y);
    em_eta_of_velocity(N, y + 2 * N, s, y + N);
    return 0;
}

static const double defaults[] = {1e-3, 4.0, 1.0}, initial_x[] = {1.0, 0.5}, initial_v[] = {0.0, 0.3};

static const em_dynamics dynamics = {
    .n_C = N_C, .n_memory = N_MEMORY, .settles = 1, .rhs = model_rhs, .settle = model_settle, .velocity = model_velocity,
    .velocity_error = model_velocity_error, .publish = model_publish, .events = model_events, .factored = factored,
    .acceleration = em_acceleration};

extern const em_model veering_model;
static int simulate(em_run *run) { return em_simulate(&veering_model, run); }
static int interpolate(const em_run *run, size_t step, double t, double *y) {
    return em_interpolate(&veering_model, run, step, t, y);
}
static void release(em_run *run) { em_release(&veering_model, run); }

const em_model veering_model = {
    .abi = EM_ABI, .name = "veering", .n = N, .n_state = N_STATE, .n_parameters = N_PARAMETERS,
    .n_prepared = N_PARAMETERS, .parameter_defaults = defaults, .initial_x = initial_x, .initial_v = initial_v,
    .conserves_energy = 1, .prepare = prepare, .state = state, .energy = energy, .dynamics = &dynamics,
    .simulate = simulate, .interpolate = interpolate, .release = release};
