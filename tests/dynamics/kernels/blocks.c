/* A block of `n` coordinates among `all`, the places of its roots the same in state, memory and prepared parameters. */
#include "dynamics/em_blocks.h"

enum { n = SIZE, all = n + 2, C = 2 * all, s = C + n * n, L = s + n, r = L + n * n };

typedef struct {
    const int *coordinate;
    const double *scales;
    int home, mode;
    double *y, *c, *memory;
    em_fault fault;
} context;

static em_block block_of(const context *at) {
    return (em_block){all, n, at->coordinate, at->scales, (em_root_location)at->home, C, s, L, r};
}
static em_group group_of(const context *at) { return (em_group){n, at->coordinate, C, s, L}; }

#define BLOCK const em_block b = block_of(at)
#define GROUP const em_group g = group_of(at)

int places(int *place) { return place[0] = C, place[1] = s, place[2] = L, place[3] = r, r + n * n; }
void part(context *at, const double *M, double *some) { BLOCK; em_block_of(&b, M, some); }
int prepare(context *at, const double *M) { BLOCK; return em_prepare(&b, M, at->c, &at->fault); }
int keep_root(context *at, const double *M) { BLOCK; return em_keep_root(&b, M, at->memory, &at->fault); }
void velocity_kept(context *at, const double *eta, double *v) {
    BLOCK;
    em_velocity_kept(&b, at->mode, eta, at->y, at->c, at->memory, v);
}
int velocity_at(context *at, const double *M, double *v) {
    BLOCK;
    return em_velocity_at(&b, at->mode, M, at->y, at->c, v, &at->fault);
}
void publish_block(context *at, const double *v, double *row) { BLOCK; em_publish_block(&b, v, at->y, row); }
int settle_factors(context *at, const double *M) {
    BLOCK;
    return em_settle_factors(&b, at->mode, 0, M, at->y, at->memory, &at->fault);
}
int change_mode(context *at, const double *M) { BLOCK; return em_change_mode(&b, at->mode, M, at->y, at->memory, &at->fault); }
void rows_of_block(context *at, const double *A, double *B) {
    BLOCK;
    em_rows_of_block(&b, at->mode, all, at->y, at->c, at->memory, A, B);
}
double time_of_block(context *at, const double *Mdot) { BLOCK; return em_time_of_block(&b, Mdot, at->y); }
void remember_block(context *at, const double *Mdot) { BLOCK; em_remember_block(&b, Mdot, at->y, 0.0, at->memory); }
int coincident_block(context *at) { BLOCK; return em_coincident_block(&b, at->y, &at->fault); }
double worst_factors(context *at, const double *M, int *first) {
    BLOCK;
    return em_worst_factors((const em_block *const[]){&b, NULL}, M, at->y, first);
}
void add_delta_rate_of(context *at, const double *A, const double *Adot, const double *Mdot, double *rate) {
    BLOCK;
    em_add_delta_rate_of(&b, all, at->y, at->c, at->memory, A, Adot, Mdot, rate);
}
int settle_group(context *at, const double *Delta) { GROUP; return em_settle_group(&g, all, Delta, at->y, &at->fault); }
int begin_group(context *at, const double *Delta) { GROUP; return em_begin_group(&g, all, Delta, at->y, &at->fault); }
void remember_group(context *at, const double *rate) { GROUP; em_remember_group(&g, all, rate, at->y, 0.0, at->memory); }
int coincident_group(context *at) { GROUP; return em_coincident_group(&g, at->y, &at->fault); }
