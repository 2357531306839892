/* Nanoseconds of a call of an external function of CasADi: x and v in, res out. */
#define _POSIX_C_SOURCE 199309L
#include <time.h>

typedef int (*function)(const double **arg, double **res, long long *iw, double *w, int mem);

double nanoseconds(function f, const double *x, const double *v, double **res, int n_res, int calls)
{
    struct timespec start, end;
    const double none[1] = {0.0};
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (int k = 0; k < calls; ++k) {
        const double *arg[8] = {x, v, none, none, none, none, none, none};
        double *to[16] = {0};
        for (int i = 0; i < n_res; ++i) to[i] = res[i];
        f(arg, to, 0, 0, 0);
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    return (1e9 * (double)(end.tv_sec - start.tv_sec) + (double)(end.tv_nsec - start.tv_nsec)) / calls;
}
