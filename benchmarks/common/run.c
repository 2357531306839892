/* Runs of a model without Python. Arguments: RUNS T_END TOLERANCE PARAMETERS...
 *
 * RUNS = 0: makes one run and prints the numbers of right-hand sides, of steps, and of steps not by the published
 * equations, and the status; then t, x of each accepted step. Otherwise prints the nanoseconds of a run, as the mean of
 * RUNS runs that record only their end. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "eigenmotion.h"

extern const em_model MODEL;

enum { LARGEST = 1024 };

static void print(const em_run *run, int n) {
    printf("%ld %ld %ld %d\n", run->n_rhs, run->n_steps, run->n_bounded, (int)run->fault.status);
    for (size_t row = 0; row < run->rows.count; ++row) {
        printf("%.17g", run->rows.t[row]);
        for (int k = 0; k < n; ++k) printf(" %.17g", run->rows.y[row * run->rows.width + (size_t)k]);
        printf("\n");
    }
}

static double seconds_since(const struct timespec *then) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return difftime(now.tv_sec, then->tv_sec) + 1e-9 * (double)(now.tv_nsec - then->tv_nsec);
}

int main(int argc, char **argv) {
    const em_model *model = &MODEL;
    const long runs = argc > 3 ? atol(argv[1]) : -1;
    double parameters[LARGEST] = {0.0}, c[LARGEST] = {0.0}, y[LARGEST] = {0.0}, atol_k[LARGEST];
    const int events[LARGEST] = {0}; /* found in both directions, and none ends the run */
    em_fault fault;
    struct timespec start;
    if (runs < 0 || model->abi != EM_ABI || model->n_prepared > LARGEST || model->n_state > LARGEST) return 2;
    if (model->n_events > LARGEST) return 2;
    const double t_end = atof(argv[2]), tolerance = atof(argv[3]);
    memcpy(parameters, model->parameter_defaults, (size_t)model->n_parameters * sizeof *parameters);
    for (int k = 4; k < argc && k - 4 < model->n_parameters; ++k) parameters[k - 4] = atof(argv[k]);
    for (int k = 0; k < LARGEST; ++k) atol_k[k] = tolerance;
    if (model->prepare(parameters, c, &fault)) return 3;
    if (model->state(0.0, model->initial_x, model->initial_v, c, y, &fault)) return 3;
    const em_run task = {.t_start = 0.0, .t_end = t_end, .y_start = y, .prepared = c, .method = EM_DOP853,
                         .rtol = tolerance, .atol = atol_k, .max_step = INFINITY, .max_steps = 1000000,
                         .stabilise = 1, .event_direction = events, .event_terminal = events,
                         .t_eval = runs ? &t_end : NULL, .n_t_eval = runs ? 1 : 0};
    timespec_get(&start, TIME_UTC);
    for (long k = 0; k < (runs ? runs : 1); ++k) {
        em_run run = task;
        model->simulate(&run);
        if (!runs) print(&run, model->n);
        model->release(&run);
    }
    if (runs) printf("%.17g\n", 1e9 * seconds_since(&start) / (double)runs);
    return 0;
}
