/* The Furuta pendulum held upright by a controller at 1 kHz, without Python: one second, and the state at its end.
 *
 *     cc -std=c11 -O2 -I generated -I src/eigenmotion/runtime/include tests/stepper/control.c generated/furuta_pendulum.c -lm
 */
#include <stdio.h>

#include "em_control.h"
#include "furuta_pendulum.h"

int main(void)
{
    const em_model *model = &furuta_pendulum_model;
    double c[64] = {0.0}, y[32] = {0.0}, u[1] = {0.0};
    const double atol[2] = {1e-9, 1e-9};
    em_fault fault = {0};
    if (model->abi != EM_ABI || model->n_prepared > 64 || model->n_state > 32 || model->n != 2) return 2;
    if (model->prepare(model->parameter_defaults, c, &fault)) return 3;
    if (model->state(0.0, model->initial_x, model->initial_v, c, y, &fault)) return 3;

    const em_run task = {.t_start = 0.0, .y_start = y, .prepared = c, .method = EM_DOP853, .rtol = 1e-9, .atol = atol,
                         .max_step = INFINITY, .max_steps = 100000, .stabilise = 1};
    em_stepper *s = em_stepper_open(model, &task, NULL);
    if (s == NULL || s->run.fault.status != EM_FINISHED) return 4;
    for (int k = 1; k <= 1000; ++k) {
        u[0] = 0.083 * s->x[0] + 1.036 * s->x[1] + 0.057 * s->v[0] + 0.105 * s->v[1];
        if (em_stepper_advance(s, 1e-3 * k, u)) return 5;
    }
    printf("%s: %ld steps, %ld right-hand sides\n", model->name, s->run.n_steps, s->run.n_rhs);
    for (int k = 0; k < model->n; ++k) printf("%s %.17g %.17g\n", model->coordinates[k], s->x[k], s->v[k]);
    em_stepper_close(s);
    return 0;
}
