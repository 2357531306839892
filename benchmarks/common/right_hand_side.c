/* Timing of one right-hand side of a generated model, in nanoseconds, called through its em_model as by any caller.
 * Each call depends on the one before, so that the compiler cannot remove any. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "eigenmotion.h"

extern const em_model MODEL;

int main(int argc, char **argv) {
    const em_model *model = &MODEL;
    const long calls = argc > 1 ? atol(argv[1]) : 1000000;
    double *c = calloc((size_t)model->n_prepared + 1, sizeof *c), *y = calloc((size_t)model->n_state, sizeof *y);
    double *start = calloc((size_t)model->n_state, sizeof *y), *dy = calloc((size_t)model->n_state, sizeof *y);
    em_fault fault;
    struct timespec before, after;
    if (!c || !y || !start || !dy || model->prepare(model->parameter_defaults, c, &fault)) return 1;
    if (model->state(0.0, model->initial_x, model->initial_v, c, start, &fault)) return 1;
    memcpy(y, start, (size_t)model->n_state * sizeof *y);
    timespec_get(&before, TIME_UTC);
    for (long k = 0; k < calls; ++k) {
        if (model->rhs(0.0, y, c, model->input_defaults, dy, &fault)) return 1;
        for (int i = 0; i < model->n_state; ++i) y[i] = start[i] + 1e-9 * dy[i];
    }
    timespec_get(&after, TIME_UTC);
    const double seconds = difftime(after.tv_sec, before.tv_sec) + 1e-9 * (double)(after.tv_nsec - before.tv_nsec);
    printf("%.17g\n", 1e9 * seconds / (double)calls);
    free(c), free(y), free(start), free(dy);
    return 0;
}
