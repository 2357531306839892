/* The paper's manipulator without Python: 10 s of motion, and the state at the end.
 *
 *     cc -std=c11 -O2 -I generated -I src/eigenmotion/runtime/include tests/generated_c/main.c generated/dual_link.c -lm
 */
#include <math.h>
#include <stdio.h>

#include "dual_link.h"

int main(void)
{
    const em_model *model = &dual_link_model;
    double c[256], y[64] = {0.0}, v[8];
    const double atol[8] = {1e-9, 1e-9, 1e-9, 1e-9};
    em_fault fault = {0};
    if (model->abi != EM_ABI || model->n_prepared > 256 || model->n_state > 64 || model->n > 8) return 2;
    if (model->prepare(model->parameter_defaults, c, &fault)) return 3;
    if (model->state(0.0, model->initial_x, model->initial_v, c, y, &fault)) return 3;

    em_run run = {.t_start = 0.0, .t_end = 10.0, .y_start = y, .prepared = c, .method = EM_DOP853, .rtol = 1e-9,
                  .atol = atol, .max_step = INFINITY, .max_steps = 100000, .stabilise = 1};
    const int status = model->simulate(&run);
    const double *last = run.rows.y + (run.rows.count - 1) * run.rows.width;
    model->velocity(run.rows.t[run.rows.count - 1], last, c, v, &fault);

    printf("%s: %ld steps, %ld right-hand sides\n", model->name, run.n_steps, run.n_rhs);
    for (int k = 0; k < model->n; ++k) printf("%s %.17g %.17g\n", model->coordinates[k], last[k], v[k]);
    model->release(&run);
    return status;
}
