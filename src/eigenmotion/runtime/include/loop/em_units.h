/* em_units.h: declarations of what the compile units of one NAME.c call in each other, and in the stepper's object: units
 * are compiled in parallel, some of them on demand (docs/architecture/building.md). A file that is compiled as a whole
 * needs none.
 *
 * x, v, y, c, u and the rest are those of em_model (eigenmotion.h). */
#ifndef EM_UNITS_H
#define EM_UNITS_H

#include "dynamics/em_blocks.h"

/* --- of EM_MODEL --- */

extern const double scales[N];
extern const em_block *const blocks[];
extern const em_event_action event_actions[];
extern const em_switch switches[];
extern const int resets_quasi[];

int prepare(const double *parameters, double *c, em_fault *fault);
int state(double t, const double *x, const double *v, const double *c, double *y, em_fault *fault);
int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double pace, em_fault *fault);
int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault);
void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e, double *ev);
int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row, em_fault *fault);
void model_events(double t, const double *x, const double *v, const double *c, const double *u, double *crossing);
void model_time_events(const double *c, double *at);
void table_arguments(double t, const double *x, const double *v, const double *c, const double *u, double *at);
void mass_matrix(double t, const double *x, const double *c, double *M);
void factored_matrix(double t, const double *x, const double *c, double *M);
void factored(double t, const double *x, const double *c, double *M);
void pfaffian(double t, const double *x, const double *c, double *A, double *b);
void position(double t, const double *x, const double *c, double *phi, double *terms);

/* --- of EM_RHS --- */

int model_rhs(int mode, double t, const double *y, const double *c, const double *u, double *memory, int flags, double *dy,
              em_fault *fault);

/* --- of EM_ASIDE --- */

void motion_bias(double t, const double *x, const double *v, const double *c, const double *u, double *bias, double *gamma);
void required_forces(double t, const double *x, const double *v, const double *a, const double *c, const double *u,
                     double *r, double *s);
void input_columns(double t, const double *x, const double *v, const double *a, const double *c, const double *u, double *B);
void energy(double t, const double *x, const double *v, const double *c, double *e);
void observe(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
             const double *u, double *out);
void quasi(double t, const double *x, const double *v, const double *c, double *y);
void draw(double t, const double *x, const double *v, const double *c, double *p);
void frames(const double *c, double *numbers);
void impacts(double t, const double *x, const double *v, const double *c, const double *u, double *impact_data);
void resets(double t, const double *x, const double *v, const double *c, const double *u, double *after);
void levels(double t, const double *x, const double *v, const double *c, const double *u, double *level);
#ifdef EM_NORMALS
extern const unsigned char normals[N_NORMALS][N_ROWS];
#endif
void reaction_rates(double t, const double *x, const double *v, const double *lambda, const double *c, const double *u,
                    double *rate);
void reaction_rate_partials(double t, const double *x, const double *v, const double *lambda, const double *c,
                            const double *u, double *by);
void pushes(double t, const double *x, const double *v, const double *c, const double *u, double *P);
struct em_acting;
int em_act(double t, double *x, double *v, double *c, const double *u, int least_norm,
           const em_act_limits *within, int *fired, em_pile *pile, em_fault *fault);
int em_act_on_all(struct em_acting *a, em_pile *pile);
void em_share_multipliers(double t, const double *x, const double *v, const double *c, const double *u, const double *Delta,
                          double *lambda);
int em_watch_modes(double t, const double *x, const double *v, const double *c, const double *u, int least_norm, double *g,
                   em_fault *fault);
int em_acceleration_with_idle(double t, const double *x, const double *v, const double *c, const double *u,
                              int least_norm, double *a, double *lambda, em_fault *fault);
void em_watched(double t, const double *x, const double *v, const double *c, const double *u, double *g);

/* --- of EM_DERIVATIVES --- */

void mass_matrix_gradient(double t, const double *x, const double *c, double *dM);
void factored_gradient(double t, const double *x, const double *c, double *dM);
void state_partials(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
                    const double *u, double *D);
void forcing_partials(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
                      const double *u, double *D);
void equation_partials(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
                       const double *u, double *D);
void em_equation_partials(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
                          const double *u, double *D);
void constraint_partials(double t, const double *x, const double *v, const double *c, double *D);
void output_partials(double t, const double *x, const double *v, const double *a, const double *lambda, const double *c,
                     const double *u, double *D);
void event_partials(double t, const double *x, const double *v, const double *c, const double *u, double *D);
void time_event_partials(const double *c, double *D);
void quasi_partials(double t, const double *x, const double *v, const double *c, double *D);
int jacobian(double t, const double *y, const double *c, const double *u, double *J, em_fault *fault);
int em_motion_jacobian(double t, const double *z, const double *c, const double *u, int least_norm, double *J, em_fault *fault);
int em_motion_derivatives(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                          double *a, double *lambda, double *da, double *dlambda, em_fault *fault);
int em_motion_along(double t, const double *x, const double *v, const double *c, const double *u, int least_norm,
                    int columns, const double *S, const double *P, double *a, double *lambda, double *W, em_fault *fault);
int em_tangent(double t, const double *x, const double *v, const double *c, int least_norm, int columns, double *S,
               const double *P, em_fault *fault);
int em_act_along(double t, double *x, double *v, double *c, const double *u, int least_norm, int *fired, em_pile *pile,
                 int columns, double *S, const double *P, em_fault *fault);
void em_watched_partials(double t, const double *x, const double *v, const double *c, const double *u, double *D);

/* --- of the stepper, compiled once for all models (em_stepper.c): for the table em_model --- */

int em_simulate(const em_model *model, em_run *run);
int em_interpolate(const em_model *model, const em_run *run, size_t step, double t, double *y);
void em_release(const em_model *model, em_run *run);
void *em_handle_open(const em_model *model, em_run *run);
int em_handle_advance(void *run_state, double t, int jumped);
double em_handle_now(const void *run_state, double *x, double *v);
int em_handle_publish(const void *run_state, double *y, em_fault *fault);
size_t em_handle_saved(const em_model *model);
void em_handle_save(const void *run_state, void *saved);
void em_handle_restore(void *run_state, const void *saved);
void em_handle_close(void *run_state);
int em_handle_again(void *run_state);
int em_inverse_dynamics(const em_model *model, double t, const double *x, const double *v, const double *a, const double *c,
                        const double *u, const em_actuators *of, double *forces, double *lambda, double *residual,
                        em_inverse_check *check, em_fault *fault);
void *em_member_enter(const em_model *model, em_run *run, int *mode);
void em_member_load(void *run_state, em_lane_group *f, int lane);
int em_member_check(void *run_state, em_lane_group *f, int lane, em_lane_outcome outcome);

/* --- of EM_ON_DUALS: likewise --- */

void em_rate_jacobian(double t, const double *y, const double *c, const double *u, double *J);

/* A module may be linked without some units: em_model then has NULL in their places, until they are loaded on demand
 * (docs/architecture.md). */
#ifdef __ELF__
#define EM_LATER(function) extern __typeof__(function) function __attribute__((weak, visibility("hidden")))
#else
#define EM_LATER(function) extern __typeof__(function) function __attribute__((weak))
#endif
#if EM_HOLDS(EM_MODEL)
EM_LATER(em_rate_jacobian);
#if !EM_HOLDS(EM_DERIVATIVES)
EM_LATER(mass_matrix_gradient);
EM_LATER(factored_gradient);
EM_LATER(jacobian);
EM_LATER(em_motion_jacobian);
EM_LATER(em_motion_derivatives);
EM_LATER(em_motion_along);
EM_LATER(em_tangent);
EM_LATER(equation_partials);
EM_LATER(em_equation_partials);
EM_LATER(constraint_partials);
EM_LATER(output_partials);
EM_LATER(event_partials);
EM_LATER(em_act_along);
EM_LATER(em_watched_partials);
EM_LATER(time_event_partials);
EM_LATER(quasi_partials);
#endif
#endif

#endif
