/* bead.c: a bead of mass m on a circle of radius l, in Cartesian coordinates, written by hand.
 *
 *   y ^        phi = (x^2 + y^2 - l^2) / 2 = 0        A = (x, y)
 *     |        M = m 1,  V = m g y,  Q = (push, 0)
 *     o---> x  m a = Q - dV/dx - A^T lambda,  A a + |v|^2 = 0
 *    /l        lambda = (x . (Q - dV/dx) + m |v|^2) / |x|^2
 *   *  m, push ->
 */
#include "numeric/em_linear.h"

enum { N = 2, N_ROWS = 1, N_POSITIONS = 1, N_STATE = 4, N_INPUTS = 1, N_EVENTS = 2 };
enum { MASS, GRAVITY, RADIUS, N_PARAMETERS };

static int motion(const double *x, const double *v, const double *c, const double *u, int least_norm, double *a,
                  double *lambda, em_fault *fault) {
    const double force[2] = {u[0], -c[MASS] * c[GRAVITY]}, square = x[0] * x[0] + x[1] * x[1];
    if (!(c[MASS] > 0.0)) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 0, -1, c[MASS]);
    if (square == 0.0 && !least_norm) return em_fail(fault, EM_DEPENDENT_CONSTRAINTS, 0, -1, square);
    *lambda = square == 0.0 ? 0.0
              : (x[0] * force[0] + x[1] * force[1] + c[MASS] * (v[0] * v[0] + v[1] * v[1])) / square;
    for (int k = 0; k < 2; ++k) a[k] = (force[k] - x[k] * *lambda) / c[MASS];
    return 0;
}

static int project(double *x, double *v, const double *c, em_fault *fault) {
    for (int k = 0; k < 20; ++k) {
        const double square = x[0] * x[0] + x[1] * x[1], phi = 0.5 * (square - c[RADIUS] * c[RADIUS]);
        if (square == 0.0) return em_fail(fault, EM_POSITION_NOT_REACHED, 0, -1, phi);
        if (fabs(phi) < 1e-16) break;
        x[0] -= x[0] * phi / square;
        x[1] -= x[1] * phi / square;
    }
    const double along = (x[0] * v[0] + x[1] * v[1]) / (x[0] * x[0] + x[1] * x[1]);
    v[0] -= along * x[0];
    v[1] -= along * x[1];
    return 0;
}

/* --- what the stepper relies on --- */

static int model_rhs(int mode, double t, const double *y, const double *c, const double *u, double *memory,
                     int flags, double *dy, em_fault *fault) {
    double lambda;
    (void)mode, (void)t, (void)memory;
    dy[0] = y[2];
    dy[1] = y[3];
    return motion(y, y + 2, c, u, flags & EM_LEAST_NORM, dy + 2, &lambda, fault);
}

static int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double h,
                        em_fault *fault) {
    (void)mode, (void)t, (void)memory, (void)h;
    if (!(flags & EM_STABILISE) || flags & EM_BEGIN) return 0;
    return project(y, y + 2, c, fault) ? -1 : 1;
}

static void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e, double *ev) {
    (void)mode, (void)y, (void)c, (void)memory;
    memcpy(ev, e, 2 * sizeof *ev);
}

static int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                         em_fault *fault) {
    (void)mode, (void)t, (void)c, (void)memory, (void)fault;
    memcpy(row, y, N_STATE * sizeof *row);
    return 0;
}

static int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault) {
    (void)mode, (void)t, (void)c, (void)fault;
    memcpy(v, y + 2, 2 * sizeof *v);
    return 0;
}

static void model_events(double t, const double *x, const double *v, const double *c, const double *u, double *g) {
    (void)t, (void)v, (void)c, (void)u;
    g[0] = x[0];
    g[1] = x[1];
}

#include "loop/em_handle.h"

/* --- the table --- */

static int prepare(const double *parameters, double *c, em_fault *fault) {
    (void)fault;
    memcpy(c, parameters, N_PARAMETERS * sizeof *c);
    return 0;
}

static int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault) {
    (void)t, (void)c, (void)fault;
    memcpy(y, x, 2 * sizeof *y);
    memcpy(y + 2, v, 2 * sizeof *y);
    return 0;
}

static int velocity(double t, const double *y, const double *c, double *v, em_fault *fault) {
    return model_velocity(0, t, y, c, v, fault);
}

static int rhs(double t, const double *y, const double *c, const double *u, double *dy, em_fault *fault) {
    return model_rhs(0, t, y, c, u, NULL, 0, dy, fault);
}

static void mass_matrix(double t, const double *x, const double *c, double *M) {
    (void)t, (void)x;
    M[0] = M[3] = c[MASS];
    M[1] = M[2] = 0.0;
}

static void mass_matrix_gradient(double t, const double *x, const double *c, double *dM) {
    (void)t, (void)x, (void)c;
    memset(dM, 0, 8 * sizeof *dM);
}

static void pfaffian(double t, const double *x, const double *c, double *A, double *b) {
    (void)t, (void)c;
    A[0] = x[0];
    A[1] = x[1];
    b[0] = 0.0;
}

static void position(double t, const double *x, const double *c, double *phi, double *terms) {
    (void)t;
    terms[0] = 1.5 * (x[0] * x[0] + x[1] * x[1] + c[RADIUS] * c[RADIUS]);
    phi[0] = 0.5 * (x[0] * x[0] + x[1] * x[1] - c[RADIUS] * c[RADIUS]);
}

static int acceleration(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                        double *a, double *lambda, em_fault *fault) {
    (void)t;
    return motion(x, v, c, u, least_norm, a, lambda, fault);
}

static int project_state(double t, double *x, double *v, const double *c, int least_norm, em_fault *fault) {
    (void)t, (void)least_norm;
    return project(x, v, c, fault);
}

static void energy(double t, const double *x, const double *v, const double *c, double *e) {
    (void)t;
    e[0] = 0.5 * c[MASS] * (v[0] * v[0] + v[1] * v[1]);
    e[1] = e[2] = 0.0;
    e[3] = c[MASS] * c[GRAVITY] * x[1];
}

static int eigenfactors(double t, const double *x, const double *c, double *C, double *s, em_fault *fault) {
    (void)t, (void)x;
    if (!(c[MASS] > 0.0)) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 0, -1, c[MASS]);
    if (C[0] == 0.0) C[0] = C[3] = 1.0;
    s[0] = s[1] = sqrt(c[MASS]);
    return 0;
}

static int output(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                  double *out, em_fault *fault) {
    double a[2], lambda;
    (void)t;
    if (motion(x, v, c, u, least_norm, a, &lambda, fault)) return -1;
    out[0] = lambda * c[RADIUS];
    out[1] = u[0];
    return 0;
}

/* The derivatives of (v, a) by hand, with lambda = (x . f + m |v|^2) / |x|^2 and m a = f - x lambda. */
static int motion_jacobian(double t, const double *z, const double *c, const double *u, int least_norm, double *J,
                           em_fault *fault) {
    const double force[2] = {u[0], -c[MASS] * c[GRAVITY]}, square = z[0] * z[0] + z[1] * z[1];
    double a[2], lambda;
    (void)t;
    memset(J, 0, 16 * sizeof *J);
    if (motion(z, z + 2, c, u, least_norm, a, &lambda, fault)) return -1;
    for (int k = 0; k < 2; ++k) {
        const double by_x = (force[k] - 2.0 * z[k] * lambda) / square, by_v = 2.0 * c[MASS] * z[2 + k] / square;
        J[k * 4 + 2 + k] = 1.0;
        for (int i = 0; i < 2; ++i) {
            J[(2 + i) * 4 + k] = -(z[i] * by_x + (i == k) * lambda) / c[MASS];
            J[(2 + i) * 4 + 2 + k] = -z[i] * by_v / c[MASS];
        }
    }
    return 0;
}

static int jacobian(double t, const double *y, const double *c, const double *u, double *J, em_fault *fault) {
    return motion_jacobian(t, y, c, u, 0, J, fault);
}

static const char *const names[] = {"x", "y"}, *const parameters[] = {"m", "g", "l"}, *const inputs[] = {"push"},
                         *const outputs[] = {"tension", "push_seen"}, *const events[] = {"lowest", "level"},
                         *const left_out[] = {"dM/dx: M is constant"};
static const double defaults[] = {2.0, 9.81, 1.5}, rest[] = {0.0}, initial_x[] = {1.5, 0.0}, initial_v[] = {0.0, 0.0},
                    scales[] = {1.0, 1.0};
static const int block[] = {0, 1}, carried[] = {0, 0}, direction[] = {0, 1}, terminal[] = {0, 1};
static const em_slice layout[] = {{"x", 0, 2}, {"v", 2, 2}};

/* No `factored`: it states no terms of its equations that a step could be held against. */
static const em_dynamics dynamics = {
    .second_order = 1, .settles = 1, .rhs = model_rhs, .settle = model_settle, .velocity = model_velocity,
    .velocity_error = model_velocity_error, .publish = model_publish, .events = model_events};

extern const em_model bead_model;
static int simulate(em_run *run) { return em_simulate(&bead_model, run); }
static int interpolate(const em_run *run, size_t step, double t, double *y) {
    return em_interpolate(&bead_model, run, step, t, y);
}
static void release(em_run *run) { em_release(&bead_model, run); }
static void *open_run(em_run *run) { return em_handle_open(&bead_model, run); }
static size_t saved(void) { return em_handle_saved(&bead_model); }

const em_model bead_model = {
    .abi = EM_ABI, .name = "bead", .formulation = "lagrange", .close_eigenvalues = "bounded", .schur = "factor",
    .n = N, .m = N_ROWS, .h = N_POSITIONS, .n_state = N_STATE, .n_parameters = N_PARAMETERS,
    .n_prepared = N_PARAMETERS, .n_inputs = N_INPUTS, .n_outputs = 2, .n_events = N_EVENTS, .n_layout = 2,
    .n_left_out = 1, .coordinates = names, .parameters = parameters, .parameter_defaults = defaults, .inputs = inputs,
    .input_defaults = rest, .initial_x = initial_x, .initial_v = initial_v, .outputs = outputs, .events = events,
    .event_direction = direction, .event_terminal = terminal, .layout = layout, .left_out = left_out, .block = block,
    .scales = scales, .conserves_energy = 0, .prepare = prepare, .state = state, .velocity = velocity, .rhs = rhs,
    .carried = carried, .mass_matrix = mass_matrix, .mass_matrix_gradient = mass_matrix_gradient, .pfaffian = pfaffian,
    .position = position, .acceleration = acceleration, .project = project_state, .energy = energy,
    .eigenfactors = eigenfactors, .output = output, .simulate = simulate, .interpolate = interpolate,
    .open = open_run, .advance = em_handle_advance, .now = em_handle_now, .publish = em_handle_publish,
    .saved = saved, .save = em_handle_save, .restore = em_handle_restore,
    .close = em_handle_close, .again = em_handle_again,
    .jacobian = jacobian, .dynamics = &dynamics,
    .motion_jacobian = motion_jacobian, .release = release, .event = model_events};
