/* Timing of steps of a fixed-step method, without Python. Arguments: METHOD STEPS
 *
 * Prints the largest number of right-hand sides of one step of 1 ms, and microseconds of a step: median, 99.9th
 * percentile, maximum. The motion restarts from its initial state every ten seconds, so that it does not die out. */
#include <stdio.h>
#include <time.h>

#include "em_control.h"

extern const em_model MODEL;

enum { LARGEST = 1024, RESTART = 10000 };

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Microseconds since an earlier time. */
static double since(const struct timespec *then) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return 1e6 * difftime(now.tv_sec, then->tv_sec) + 1e-3 * (double)(now.tv_nsec - then->tv_nsec);
}

int main(int argc, char **argv) {
    const em_model *model = &MODEL;
    double c[LARGEST] = {0.0}, y[LARGEST] = {0.0}, atol_k[LARGEST];
    em_fault fault;
    struct timespec begin;
    if (argc < 3 || model->abi != EM_ABI || model->n_prepared > LARGEST || model->n_state > LARGEST) return 2;
    const long steps = atol(argv[2]);
    for (int k = 0; k < LARGEST; ++k) atol_k[k] = 1e-9;
    if (model->prepare(model->parameter_defaults, c, &fault)) return 3;
    if (model->state(0.0, model->initial_x, model->initial_v, c, y, &fault)) return 3;
    const em_run task = {.y_start = y, .prepared = c, .method = (em_method)atoi(argv[1]), .rtol = 1e-6, .atol = atol_k,
                         .first_step = 1e-3, .max_step = INFINITY, .max_steps = 1000000, .stabilise = 1};
    em_stepper *s = em_stepper_open(model, &task, NULL);
    double *took = malloc((size_t)steps * sizeof *took);
    char *start = s != NULL ? malloc(em_stepper_size(s)) : NULL;
    long most = 0;
    if (start == NULL || took == NULL || s->run.fault.status) return 4;
    em_stepper_save(s, start);
    for (long k = 0; k < steps; ++k) {
        if (k % RESTART == 0) em_stepper_restore(s, start);
        const long before = s->run.n_rhs;
        timespec_get(&begin, TIME_UTC);
        if (em_stepper_advance(s, 1e-3 * (double)(k % RESTART + 1), NULL)) return 5;
        took[k] = since(&begin);
        if (k % RESTART && s->run.n_rhs - before > most) most = s->run.n_rhs - before;
    }
    qsort(took, (size_t)steps, sizeof *took, compare);
    printf("%ld %.4f %.4f %.4f\n", most, took[steps / 2], took[steps - steps / 1000], took[steps - 1]);
    em_stepper_close(s);
    free(start);
    free(took);
    return 0;
}
